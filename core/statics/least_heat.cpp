#include "statics/least_heat.hpp"

#include "statics/ball_friction.hpp"
#include "statics/ball_report.hpp"
#include "statics/free_traction.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace adore::statics {
namespace {

constexpr int kMaxHeatPasses = 12;
constexpr double kSteadyShift = 1e-7;     ///< change of β where passes end [rad]
constexpr double kAcceptedChange = 1e-4;  ///< after the last pass [rad]

std::array<double, 5> array_of(const Vec5& v) { return {v(0), v(1), v(2), v(3), v(4)}; }

/// Heat of both contacts of one ball at its place, over the shift of its spin axis.
class HeatOfBall {
 public:
  HeatOfBall(const bearing::Bearing& bearing, const ContactLaws& laws,
             const tribology::EllipseRule& rule, const BallModel& model,
             const std::array<double, 5>& q, const BallState& ball)
      : bearing_(bearing), rule_(rule), model_(model), q_(q), ball_(ball) {
    const StaticBall now = report_ball(model, q, ball);
    loaded_ = now.Q[0] > 0.0 && now.Q[1] > 0.0 && now.Q[1] >= model.seat(ball.site.own).window;
    if (!loaded_) return;
    beta = now.pitch_angle;
    for (std::size_t j = 0; j < 2; ++j) {
      contact_[j] = ball_contact(bearing, laws, now, j);
      const double sine = std::sin(now.alpha[j]), cosine = std::cos(now.alpha[j]);
      control[j] = std::atan2(sine, cosine + (j == 0 ? 1.0 : -1.0) * model.gamma);
    }
  }
  [[nodiscard]] bool loaded() const { return loaded_; }
  [[nodiscard]] double operator()(double shift) const {
    BallState trial = ball_;
    trial.site.axis_shift = shift;
    const StaticBall s = report_ball(model_, q_, trial);
    BallMotion motion;
    motion.omega = {s.omega_x, s.omega_r, s.omega_theta};
    motion.orbit = s.orbital_speed;
    double heat = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      tribology::EllipseKinematics m = contact_kinematics(bearing_, contact_[j], motion, s.r, j);
      m.W_t = 0.0;
      heat += free_traction(contact_[j].law, contact_[j].ellipse, m, rule_).heat;
    }
    return heat;
  }
  /// Shift of the least heat.
  [[nodiscard]] double least() const {
    // β = free axis + shift; the free axis does not depend on the shift.
    const double free = beta - ball_.site.axis_shift;
    double low = std::min(control[0], control[1]) - free,
           high = std::max(control[0], control[1]) - free;
    constexpr double kBracketMargin = 0.02;  // [rad]
    low -= kBracketMargin;
    high += kBracketMargin;
    constexpr int kScanCells = 8;
    double cell = (high - low) / kScanCells;
    double best = low, least = (*this)(low);
    for (int k = 1; k <= kScanCells; ++k) {
      const double at = low + k * cell, heat = (*this)(at);
      if (heat < least) {
        best = at;
        least = heat;
      }
    }
    for (int n = 0; n < 6 && (best == low || best == high); ++n, cell *= 1.5) {
      const double at = best == low ? low - cell : high + cell, heat = (*this)(at);
      (best == low ? low : high) = at;
      if (!(heat < least)) break;
      best = at;
      least = heat;
    }
    constexpr double kSlopeStep = 1e-4, kRootWidth = 1e-8;  // [rad]
    const auto slope = [&](double at) {
      return (*this)(at + kSlopeStep) - (*this)(at - kSlopeStep);
    };
    return root_between(slope, best - cell, best + cell, kRootWidth);
  }

  double beta = 0.0;                ///< at the present shift [rad]
  std::array<double, 2> control{};  ///< race-control angles [rad]

 private:
  const bearing::Bearing& bearing_;
  const tribology::EllipseRule& rule_;
  const BallModel& model_;
  const std::array<double, 5>& q_;
  const BallState& ball_;
  std::array<BallContact, 2> contact_;
  bool loaded_ = false;
};

}  // namespace

void solve_least_heat(const bearing::Bearing& bearing, const BallModel& model,
                      const RaceLoadCase& task, BallRace& state, RaceSolveResult& solve,
                      std::vector<Finding>& notes) {
  if (bearing.speed[0] == bearing.speed[1] || !model.per_ball_speeds ||
      (!bearing.lubrication && !(tribology::max_traction_coefficient(bearing.race_traction) > 0.0)))
    return;
  const ContactLaws laws(bearing);
  const tribology::EllipseRule rule = tribology::make_split_ellipse_rule(30, 8);
  const BallRace before = state;
  const RaceSolveResult first = solve;
  double change = 0.0;
  for (int pass = 0; pass < kMaxHeatPasses; ++pass) {
    const auto q = array_of(state.q);
    change = 0.0;
    for (BallState& ball : state.elements) {
      const HeatOfBall heat(bearing, laws, rule, model, q, ball);
      if (!heat.loaded()) continue;
      const double shift = heat.least();
      change = std::max(change, std::abs(shift - ball.site.axis_shift));
      ball.site.axis_shift = shift;
    }
    if (change <= kSteadyShift) return;
    const int iterations = solve.iterations;
    solve = solve_race(model, task, state);
    solve.iterations += iterations;
    if (!solve.converged) break;
  }
  if (solve.converged && change <= kAcceptedChange) return;
  state = before;
  solve = first;
  notes.push_back(make_finding(
      "statics.least_heat",
      fmt::format(
          "minimum-heat spin axis: {}. The spin axes for a constant friction coefficient are used",
          solve.converged ? "spin axes and loads did not converge"
                          : "no equilibrium was found with the traction law of the deck")));
}

}  // namespace adore::statics
