#include "dynamics/scene_estimate.hpp"

#include "bearing/element_inertia.hpp"
#include "contact/ball_groove.hpp"
#include "contact/groove.hpp"
#include "dynamics/effects/contact_damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace adore::dynamics {
namespace {

using Laws = std::array<contact::DampingLaw<>, 2>;

BallVibration ball_vibration(const statics::StaticBall& ball, const contact::GrooveGeometry& groove,
                             double mass, const Laws& laws) {
  BallVibration result;
  double xx = 0.0, xr = 0.0, rr = 0.0;                 // the symmetric 2 x 2 matrix
  double loss_xx = 0.0, loss_xr = 0.0, loss_rr = 0.0;  // Σ (d Q + c) n nᵀ
  std::array<double, 2> normal{};
  const auto add = [&](const statics::StaticBall& at, std::size_t j) {
    if (!(at.Q[j] > 0.0) || !(at.delta[j] > 0.0)) return;
    const double nx = std::sin(at.alpha[j]), nr = std::cos(at.alpha[j]);
    const contact::PointContactStiffness s = contact::point_contact_stiffness(
        at.share[j] * at.K[j], at.delta[j], at.Q[j], groove.offset[j] + at.delta[j], 0.0);
    normal[j] += s.normal;
    xx += s.normal * nx * nx + s.across * nr * nr;
    xr += (s.normal - s.across) * nx * nr;
    rr += s.normal * nr * nr + s.across * nx * nx;
    const double loss = laws[j].impact * at.Q[j] + laws[j].material * std::sqrt(s.normal);
    loss_xx += loss * nx * nx;
    loss_xr += loss * nx * nr;
    loss_rr += loss * nr * nr;
  };
  for (std::size_t j = 0; j < 2; ++j) {
    add(ball, j);
    if (ball.second[j].Q > 0.0) add(statics::ball_at_second_contacts(ball), j);
  }
  const double mean = 0.5 * (xx + rr), half = std::hypot(0.5 * (xx - rr), xr);
  result.along = std::sqrt((mean + half) / mass);
  result.across = std::sqrt(std::max(mean - half, 0.0) / mass);
  // Principal directions: (cos β, sin β) of x and r, and across it.
  const double twice = std::atan2(2.0 * xr, xx - rr), c = std::cos(twice), s = std::sin(twice);
  const double loss_mean = 0.5 * (loss_xx + loss_rr),
               loss_half = 0.5 * (loss_xx - loss_rr) * c + loss_xr * s;
  const auto ratio = [&](double loss, double frequency) {
    return frequency > 0.0 ? std::max(loss, 0.0) / (2.0 * mass * frequency) : 0.0;
  };
  result.along_damping = ratio(loss_mean + loss_half, result.along);
  result.across_damping = ratio(loss_mean - loss_half, result.across);
  result.stiffer_race = normal[1] > normal[0] ? 1 : 0;
  return result;
}

/// A roller between straight contacts: (10/9) Q/δ each, along their common normal; across, its tilt
/// on springs spread over the length.
BallVibration roller_vibration(const statics::StaticBall& roller, const bearing::Bearing& bearing,
                               const Laws& laws) {
  BallVibration result;
  std::array<double, 2> normal{};
  for (std::size_t j = 0; j < 2; ++j)
    if (roller.Q[j] > 0.0 && roller.delta[j] > 0.0)
      normal[j] = (10.0 / 9.0) * roller.Q[j] / roller.delta[j];
  const double stiffness = normal[0] + normal[1];
  const double length = bearing.rollers()->contact_length();
  result.along = std::sqrt(stiffness / bearing.element_inertia.mass);
  result.across =
      std::sqrt(stiffness * length * length / 12.0 / bearing.element_inertia.moments[1]);
  // Tilt is damped by the slices, too: their coefficients spread over the length.
  double loss = 0.0;
  for (std::size_t j = 0; j < 2; ++j)
    loss += laws[j].impact * roller.Q[j] + laws[j].material * std::sqrt(length * normal[j]);
  if (result.along > 0.0) {
    result.along_damping = loss / (2.0 * bearing.element_inertia.mass * result.along);
    result.across_damping =
        loss * length * length / (24.0 * bearing.element_inertia.moments[1] * result.across);
  }
  result.stiffer_race = normal[1] > normal[0] ? 1 : 0;
  return result;
}

double seconds_per_evaluation(System& system) {
  using Clock = std::chrono::steady_clock;
  const CostLedger ledger = system.cost();
  const std::vector<double> y = system.initial_state();
  std::vector<double> dydt(y.size());
  system.check_state(0.0, y.data());
  constexpr int kBatches = 5, kPerBatch = 8;
  double least = std::numeric_limits<double>::infinity();
  for (int batch = 0; batch < kBatches; ++batch) {
    const auto start = Clock::now();
    for (int i = 0; i < kPerBatch; ++i) system.rhs(0.0, y.data(), dydt.data());
    least =
        std::min(least, std::chrono::duration<double>(Clock::now() - start).count() / kPerBatch);
  }
  system.cost() = ledger;
  return least;
}

}  // namespace

std::vector<BallVibration> ball_vibrations(const ScenePlan& plan, const bearing::Bearing& bearing,
                                           const SystemOptions& options,
                                           const statics::StaticSolution& statics) {
  std::vector<BallVibration> out;
  const Laws laws{race_damping(plan, bearing, options, statics, 0),
                  race_damping(plan, bearing, options, statics, 1)};
  if (bearing.rollers() != nullptr) {
    for (const statics::StaticBall& roller : statics.balls)
      out.push_back(roller_vibration(roller, bearing, laws));
    return out;
  }
  const contact::GrooveGeometry groove = contact::groove_geometry(bearing.balls());
  for (std::size_t i = 0; i < statics.balls.size(); ++i) {
    const double growth = 2.0 * bearing::element_radius(bearing, i) - bearing.element_diameter();
    out.push_back(ball_vibration(statics.balls[i], contact::groove_with_ball_growth(groove, growth),
                                 bearing::inertia_of(bearing, i).mass, laws));
  }
  return out;
}

void find_fastest_vibration(ScenePlan& plan, const bearing::Bearing& bearing,
                            const statics::StaticSolution& statics) {
  BallVibration fastest;
  std::size_t element = 0;
  const std::vector<BallVibration> vibrations = ball_vibrations(plan, bearing, {}, statics);
  for (std::size_t i = 0; i < vibrations.size(); ++i) {
    if (vibrations[i].along <= fastest.along) continue;
    fastest = vibrations[i];
    element = i;
  }
  if (!(fastest.along > 0.0)) return;
  plan.fastest_frequency = fastest.along / (2.0 * std::numbers::pi);
  plan.fastest_contact = fmt::format("element {} / {} race", element + 1,
                                     fastest.stiffer_race == 0 ? "outer" : "inner");
}

void estimate(ScenePlan& plan, const bearing::Bearing& bearing,
              const statics::StaticSolution& statics, System& system) {
  find_fastest_vibration(plan, bearing, statics);
  plan.quadratures = system.layout().size() - system.layout().controlled_size();
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (!(plan.fastest_frequency > 0.0)) {
    plan.fastest_frequency = 1.0 / (kTurn * system.scales().time);
    plan.fastest_contact =
        "no contact is loaded; the frequency is an estimate for a small contact load (0.001 times "
        "the force scale of the bearing)";
  }
  plan.expected_step = kPeriodsPerStep / plan.fastest_frequency;
  const double speed = std::abs(bearing.speed[1] - bearing.speed[0]);
  plan.steps_per_revolution = speed > 0.0 ? kTurn / speed / plan.expected_step : 0.0;
  plan.seconds_per_revolution =
      plan.steps_per_revolution * kEvaluationsPerStep * seconds_per_evaluation(system);
}

}  // namespace adore::dynamics
