#include "statics/balanced_race.hpp"

#include "statics/ball_forces.hpp"
#include "statics/ball_report.hpp"
#include "statics/coupled_balls.hpp"
#include "statics/race_text.hpp"
#include "statics/stiffness_difference.hpp"

#include <cmath>
#include <utility>

namespace adore::statics {

BalancedRace::BalancedRace(const bearing::Bearing& bearing, const BallStaticsOptions& options,
                           const StaticSolution& solution)
    : load_case_(race_load_case(bearing.constraints)), model_(make_ball_model(bearing, options)) {
  state_.q = Eigen::Map<const Vec5>(solution.displacement.data());
  for (std::size_t k = 0; k < solution.balls.size(); ++k) {
    const StaticBall& from = solution.balls[k];
    BallState ball;
    ball.site.sin = std::sin(from.azimuth);
    ball.site.cos = std::cos(from.azimuth);
    ball.site.own = model_.own_number.empty() ? 0 : model_.own_number[k];
    ball.site.law = first_spin_law(bearing, options);
    ball.site.axis_shift = from.axis_shift;
    if (from.inner_race_control)
      ball.site.law = {SpinLaw::Axis::InnerControl, SpinLaw::Share::Equal};
    ball.x = from.x;
    ball.rho = from.r - 0.5 * model_.balls.pitch_diameter;
    ball.known = true;
    state_.elements.push_back(ball);
  }
}

std::array<double, 2> BalancedRace::along(std::size_t k) const {
  const BallState& ball = state_.elements[k];
  if (!ball.site.tractions) return {};
  const auto f = ball_forces<double>(model_, ball.site, ball.x, ball.rho,
                                     inner_race_pose<double>(model_, displacement()));
  return {f.contact[0].friction, f.contact[1].friction};
}

void BalancedRace::set_traction(std::size_t k, const StaticBall& ball, const BallMotion& motion,
                                const Eigen::Matrix<double, 3, 5>& slopes) {
  LinearizedTractions now;
  const auto value = [&](double of, Eigen::Index row) {
    LinearizedTractions::Value out{of, {}};
    for (std::size_t p = 0; p < LinearizedTractions::kPlaces; ++p)
      out.slope[p] = slopes(row, static_cast<Eigen::Index>(p));
    return out;
  };
  now.along = {value(motion.along[0], 0), value(motion.along[1], 1)};
  now.into = motion.into;
  now.orbital = value(motion.orbit, 2);
  now.at.load = ball.Q;
  now.at.rho = ball.r - 0.5 * model_.balls.pitch_diameter;
  for (std::size_t j = 0; j < 2; ++j) {
    now.at.sin[j] = std::sin(ball.alpha[j]);
    now.at.cos[j] = std::cos(ball.alpha[j]);
  }
  state_.elements[k].site.tractions = now;
}

void BalancedRace::set_coupling(Eigen::MatrixXd slopes) {
  coupled_balls_ = {};
  coupled_balls_.T = std::move(slopes);
  for (const BallState& ball : state_.elements) {
    coupled_balls_.start.push_back(ball.site.tractions.value_or(LinearizedTractions{}));
    coupled_balls_.coupled.push_back(ball.site.tractions.has_value());
  }
}

CoupledBalls BalancedRace::make_coupled_balls() const {
  CoupledBalls out = coupled_balls_;
  out.model = &model_;
  return out;
}

bool BalancedRace::solve(StaticSolution& solution) {
  BallRace trial = state_;
  RaceSolveResult solve = is_coupled() ? solve_race(make_coupled_balls(), load_case_, trial)
                                       : solve_race(model_, load_case_, trial);
  ignores_traction_slopes_ = !solve.converged;
  if (ignores_traction_slopes_) {
    // Slopes of tractions that saturate mislead long steps: without them.
    trial = state_;
    for (BallState& ball : trial.elements)
      if (ball.site.tractions) {
        for (LinearizedTractions::Value& value : ball.site.tractions->along) value.slope = {};
        ball.site.tractions->orbital.slope = {};
      }
    solve = solve_race(model_, load_case_, trial);
    if (!solve.converged) return false;
  }
  state_ = std::move(trial);
  solution.displacement = displacement();
  for (std::size_t k = 0; k < 5; ++k) solution.load[k] = state_.load(static_cast<Eigen::Index>(k));
  solution.stiffness = state_.stiffness;
  solution.residual = solve.residual;
  solution.iterations += solve.iterations;
  for (std::size_t k = 0; k < state_.elements.size(); ++k) {
    StaticBall now = report_ball(model_, solution.displacement, state_.elements[k]);
    now.azimuth = solution.balls[k].azimuth;
    solution.balls[k] = now;
  }
  fill_summary(model_, solution);
  return true;
}

std::vector<Finding> BalancedRace::notes(const StaticSolution& solution) const {
  return ball_notes(model_, solution.balls);
}

void BalancedRace::add_stiffness_by_difference(double share, StaticSolution& solution) const {
  if (!(share > 0.0)) return;
  if (is_coupled())
    add_difference_stiffness(make_coupled_balls(), state_, share, solution);
  else
    add_difference_stiffness(model_, state_, share, solution);
}

}  // namespace adore::statics
