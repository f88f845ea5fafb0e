#include "statics/element_places.hpp"

#include "base/errors.hpp"
#include "statics/ball_report.hpp"
#include "statics/race_text.hpp"
#include "statics/roller_report.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::statics {
namespace {

/// Acceleration that a body at rest at the base origin feels in the frame: Ω² R outwards.
Eigen::Vector3d field_of(const bearing::FrameMotion& frame) {
  return frame.speed * frame.speed * frame.orbit_radius *
         Eigen::Vector3d(0.0, -std::sin(frame.orbit_angle), std::cos(frame.orbit_angle));
}

template <class Set, class State>
bool solve(const Set& set, const RaceTask& task, State& state) {
  const State start = state;
  if (solve_race(set, task, state).converged) return true;
  state = start;
  return solve_race_surely(set, task, state).converged;
}

std::optional<ElementPlaces> of_balls(const PlaceModel& of, std::span<const double> azimuth,
                                      const RaceTask& task, const Vec5& guess) {
  BallModel model = make_ball_model(of.bearing, of.balls);
  model.azimuth.assign(azimuth.begin(), azimuth.end());
  if (of.frame) set_frame(model, of.frame->speed, field_of(*of.frame));
  const SpinLaw law = first_spin_law(of.bearing, of.balls);
  BallRace state;
  state.q = guess;
  for (std::size_t k = 0; k < azimuth.size(); ++k) {
    BallState ball;
    ball.site.sin = std::sin(azimuth[k]);
    ball.site.cos = std::cos(azimuth[k]);
    ball.site.own = model.own_number.empty() ? 0 : model.own_number[k];
    ball.site.law = law;
    state.elements.push_back(ball);
  }
  model.own_speed_share = 0.0;
  if (!solve(model, task, state)) return std::nullopt;
  if (!of.conservative) {
    model.own_speed_share = 1.0;
    if (!solve(model, task, state)) return std::nullopt;
  }
  ElementPlaces out;
  out.race = state.q;
  out.stiffness = state.stiffness;
  out.load = state.load;
  std::array<double, 5> q{};
  for (std::size_t k = 0; k < 5; ++k) q[k] = state.q(static_cast<Eigen::Index>(k));
  for (const BallState& ball : state.elements) {
    StaticBall found = report_ball(model, q, ball);
    found.azimuth = azimuth[out.balls.size()];
    out.balls.push_back(found);
    out.elements.push_back({found.x,
                            found.r,
                            0.0,
                            std::max(found.Q[0], found.Q[1]),
                            found.orbital_speed,
                            {found.omega_x, found.omega_r, found.omega_theta}});
  }
  return out;
}

std::optional<ElementPlaces> of_rollers(const PlaceModel& of, std::span<const double> azimuth,
                                        const RaceTask& task, const Vec5& guess) {
  RollerModel model = make_roller_model(of.bearing, of.rollers);
  model.azimuth.assign(azimuth.begin(), azimuth.end());
  if (of.frame)
    set_frame(model, of.bearing, of.rollers.guide, of.frame->speed, field_of(*of.frame));
  set_load_floors(model, force_scale(race_scales(model), race_task(of.bearing.constraints), 0.0));
  RollerRace state;
  state.q = guess;
  for (std::size_t k = 0; k < azimuth.size(); ++k) {
    RollerState roller;
    roller.number = k;
    roller.sin = std::sin(azimuth[k]);
    roller.cos = std::cos(azimuth[k]);
    state.elements.push_back(roller);
  }
  if (!solve(model, task, state)) return std::nullopt;
  ElementPlaces out;
  out.race = state.q;
  out.stiffness = state.stiffness;
  out.load = state.load;
  for (const RollerState& roller : state.elements) {
    const StaticRoller found = report_roller(model, state.q, roller);
    out.rollers.push_back(found);
    Eigen::Vector3d omega =
        model.speeds.spin * Eigen::Vector3d(std::cos(found.tilt), std::sin(found.tilt), 0.0);
    omega(0) += model.speeds.orbital;
    out.elements.push_back({found.x, found.r, found.tilt,
                            std::max(found.race[0].load, found.race[1].load), model.speeds.orbital,
                            omega});
  }
  return out;
}

/// Equilibrium in the frame from that of a bearing at rest.
ElementPlaces in_frame(PlaceModel model, std::span<const double> azimuth,
                       const RaceResult& at_rest) {
  const Vec5 guess = Eigen::Map<const Vec5>(at_rest.displacement.data());
  for (const bool conservative : {false, true}) {
    model.conservative = conservative;
    if (auto found = element_places(model, azimuth, race_task(model.bearing.constraints), guess))
      return *found;
  }
  throw SolverError(
      "bearing equilibrium in the turning base frame of record 9.5: none was found. Reduce "
      "brgAngVel "
      "or brgOrbitRad, or give more load");
}

void take_race(const ElementPlaces& from, RaceResult& to) {
  for (std::size_t k = 0; k < 5; ++k) {
    to.displacement[k] = from.race(static_cast<Eigen::Index>(k));
    to.load[k] = from.load(static_cast<Eigen::Index>(k));
  }
  to.stiffness = from.stiffness;
  to.max_load = to.max_stiffness = to.max_deflection = 0.0;
}

}  // namespace

void put_into_frame(const bearing::Bearing& bearing, const bearing::FrameMotion& frame,
                    const StaticsOptions& options, StaticSolution& solution) {
  std::vector<double> azimuth;
  for (const StaticBall& ball : solution.balls) azimuth.push_back(ball.azimuth);
  ElementPlaces found = in_frame({bearing, options, {}, false, frame}, azimuth, solution);
  take_race(found, solution);
  for (const StaticBall& ball : found.balls)
    for (std::size_t j = 0; j < 2; ++j) {
      if (!(ball.Q[j] > 0.0)) continue;
      solution.max_load = std::max(solution.max_load, ball.Q[j]);
      solution.max_deflection = std::max(solution.max_deflection, ball.delta[j]);
      solution.max_stiffness = std::max(solution.max_stiffness, 1.5 * ball.Q[j] / ball.delta[j]);
    }
  solution.balls = std::move(found.balls);
}

void put_into_frame(const bearing::Bearing& bearing, const bearing::FrameMotion& frame,
                    const RollerOptions& options, RollerSolution& solution) {
  std::vector<double> azimuth;
  for (const StaticRoller& roller : solution.rollers) azimuth.push_back(roller.azimuth);
  ElementPlaces found = in_frame({bearing, {}, options, false, frame}, azimuth, solution);
  take_race(found, solution);
  for (const StaticRoller& roller : found.rollers)
    for (const RollerRaceContact& c : roller.race) {
      solution.max_load = std::max(solution.max_load, c.load);
      solution.max_stiffness = std::max(solution.max_stiffness, c.stiffness);
      solution.max_deflection = std::max(solution.max_deflection, c.delta);
    }
  for (std::size_t k = 0; k < found.rollers.size(); ++k) found.rollers[k].azimuth = azimuth[k];
  solution.rollers = std::move(found.rollers);
}

std::optional<ElementPlaces> element_places(const PlaceModel& model,
                                            std::span<const double> azimuth, const RaceTask& task,
                                            const Vec5& guess) {
  return model.bearing.rollers() != nullptr ? of_rollers(model, azimuth, task, guess)
                                            : of_balls(model, azimuth, task, guess);
}

}  // namespace adore::statics
