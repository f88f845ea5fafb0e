#include "statics/element_places.hpp"

#include "statics/ball_report.hpp"
#include "statics/race_text.hpp"
#include "statics/roller_report.hpp"

#include <algorithm>
#include <cmath>

namespace adore::statics {
namespace {

template <class Set, class State>
bool solve(const Set& set, const RaceLoadCase& task, State& state) {
  const State start = state;
  if (solve_race(set, task, state).converged) return true;
  state = start;
  return solve_race_with_fallback(set, task, state).converged;
}

std::optional<ElementPositions> of_balls(const ElementPositionModel& of,
                                         std::span<const double> azimuth, const RaceLoadCase& task,
                                         const Vec5& guess) {
  BallModel model = make_ball_model(of.bearing, of.balls);
  model.azimuth.assign(azimuth.begin(), azimuth.end());
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
  ElementPositions out;
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

std::optional<ElementPositions> of_rollers(const ElementPositionModel& of,
                                           std::span<const double> azimuth,
                                           const RaceLoadCase& task, const Vec5& guess) {
  RollerModel model = make_roller_model(of.bearing, of.rollers);
  model.azimuth.assign(azimuth.begin(), azimuth.end());
  set_load_floors(model,
                  force_scale(race_scales(model), race_load_case(of.bearing.constraints), 0.0));
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
  ElementPositions out;
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

}  // namespace

std::optional<ElementPositions> element_places(const ElementPositionModel& model,
                                               std::span<const double> azimuth,
                                               const RaceLoadCase& task, const Vec5& guess) {
  return model.bearing.rollers() != nullptr ? of_rollers(model, azimuth, task, guess)
                                            : of_balls(model, azimuth, task, guess);
}

}  // namespace adore::statics
