#include "assembly/row_model.hpp"

#include "statics/ball_friction.hpp"
#include "statics/ball_race.hpp"
#include "statics/roller_equilibrium.hpp"
#include "statics/roller_friction.hpp"
#include "statics/start_radii.hpp"

#include <algorithm>
#include <cmath>

namespace adore::assembly {
namespace {

std::array<double, 5> array_of(const Vec5& v) { return {v(0), v(1), v(2), v(3), v(4)}; }

/// Means of contact angles, weighted by load.
class AngleMean {
 public:
  void add(double load, double angle) {
    if (!(load > 0.0) || !std::isfinite(angle)) return;
    load_ += load;
    sum_ += load * angle;
  }
  [[nodiscard]] double value() const {
    return load_ > 0.0 ? sum_ / load_ : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  double load_ = 0.0, sum_ = 0.0;
};

/// Load at the inner race; less than a billionth of the largest contact load is none.
void count_inner(const std::vector<double>& loads, RowState& out) {
  for (const double load : loads) out.inner_load = std::max(out.inner_load, load);
  out.loaded = static_cast<int>(std::count_if(loads.begin(), loads.end(), [&](double load) {
    return load > 1e-9 * std::max(out.largest, out.inner_load);
  }));
}

void take_race(const statics::RaceResult& result, const Vec5& own, RowState& out) {
  out.own = own;
  for (int k = 0; k < 5; ++k) out.load(k) = result.load[static_cast<std::size_t>(k)];
  out.stiffness = result.stiffness;
  out.largest = result.max_load;
}

RowState state_of(const statics::StaticSolution& solution, const Vec5& own) {
  RowState out;
  take_race(solution, own, out);
  std::array<AngleMean, 2> angles;
  std::vector<double> inner;
  for (const statics::StaticBall& ball : solution.balls) {
    for (std::size_t j = 0; j < 2; ++j) {
      angles[j].add(ball.Q[j], ball.alpha[j]);
      out.pressure = std::max({out.pressure, ball.p_max[j], ball.second[j].p_max});
    }
    inner.push_back(std::max(ball.Q[1], ball.second[1].Q));
  }
  out.angle = {angles[0].value(), angles[1].value()};
  count_inner(inner, out);
  return out;
}

RowState state_of(const statics::RollerSolution& solution, const Vec5& own) {
  RowState out;
  take_race(solution, own, out);
  std::array<AngleMean, 2> angles;
  std::vector<double> inner;
  for (const statics::StaticRoller& roller : solution.rollers) {
    for (std::size_t j = 0; j < 2; ++j) {
      angles[j].add(roller.race[j].load, roller.race[j].contact_angle);
      out.pressure = std::max(out.pressure, roller.race[j].peak_pressure);
    }
    double load = roller.race[1].load;
    for (const auto& flange : roller.flange[1]) load = std::max(load, flange.load);
    inner.push_back(load);
  }
  out.angle = {angles[0].value(), angles[1].value()};
  count_inner(inner, out);
  return out;
}

std::variant<statics::BallModel, statics::RollerModel> model_of(
    const bearing::Bearing& bearing, const statics::BallStaticsOptions& balls,
    const statics::RollerOptions& rollers) {
  if (bearing.rollers()) return statics::make_roller_model(bearing, rollers);
  return statics::make_ball_model(bearing, balls);
}

}  // namespace

RowModel::RowModel(const runs::Prepared& prepared, RowCondition condition)
    : bearing_(condition == RowCondition::Unmounted ? prepared.as_built : prepared.bearing),
      ball_options_(runs::ball_statics_options(prepared)),
      roller_options_(prepared.options.rollers) {
  if (condition != RowCondition::Operation) {
    bearing_.speed = {};
    bearing_.gravity.setZero();
    ball_options_.friction_balance = false;
    roller_options_.friction_balance = false;
  }
  bearing_.constraints.load = {};
  bearing_.constraints.displacement = {};
  bearing_.constraints.displacement_given.fill(true);
  model_ = model_of(bearing_, ball_options_, roller_options_);
  includes_friction_ = bearing_.rollers() ? statics::has_friction_balance(bearing_, roller_options_)
                                          : statics::has_friction_balance(bearing_, ball_options_);
}

RowState RowModel::at(const Vec5& own) const {
  bearing::Bearing bearing = bearing_;
  bearing.constraints.displacement = array_of(own);
  if (bearing.rollers())
    return state_of(statics::solve_roller_statics(bearing, roller_options_), own);
  statics::FrictionBalance balance;
  return state_of(statics::solve_balls_with_friction(bearing, ball_options_, {}, balance), own);
}

RowModel RowModel::without_friction() const {
  RowModel out = *this;
  out.ball_options_.friction_balance = false;
  out.roller_options_.friction_balance = false;
  out.includes_friction_ = false;
  return out;
}

double RowModel::under_thrust(double force) const {
  bearing::Bearing bearing = bearing_;
  bearing.constraints.displacement_given[0] = false;
  bearing.constraints.load[0] = force;
  if (bearing.rollers())
    return statics::solve_roller_statics(bearing, roller_options_).displacement[0];
  return statics::solve_ball_statics(bearing, ball_options_).displacement[0];
}

statics::RaceScales RowModel::scales() const {
  return std::visit([](const auto& model) { return statics::race_scales(model); }, model_);
}

double RowModel::reference_stiffness(double load) const {
  return std::visit([&](const auto& model) { return statics::reference_stiffness(model, load); },
                    model_);
}

double RowModel::inner_reference_x() const {
  const auto* balls = std::get_if<statics::BallModel>(&model_);
  return balls == nullptr ? 0.0 : balls->groove.centre_x[1];
}

}  // namespace adore::assembly
