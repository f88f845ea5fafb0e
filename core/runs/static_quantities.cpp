#include "runs/static_quantities.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "life/iso281.hpp"
#include "listing/ball_warnings.hpp"
#include "statics/ball_friction.hpp"
#include "tribology/lubricant.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::runs {
namespace {

using results::key_result;

double least_element_load(const Prepared& prepared) {
  double out = std::numeric_limits<double>::infinity();
  if (prepared.rollers)
    for (const statics::StaticRoller& roller : prepared.rollers->rollers)
      out = std::min({out, roller.race[0].load, roller.race[1].load});
  for (const statics::StaticBall& ball : prepared.statics.balls)
    for (std::size_t j = 0; j < 2; ++j) out = std::min(out, ball.Q[j] + ball.second[j].Q);
  return out;
}

/// Of the solution by the spin rule: balls in balance of friction already creep.
std::optional<double> gyroscopic_ratio(const Prepared& prepared) {
  std::optional<double> needed;
  const auto count = [&](const std::vector<statics::StaticBall>& balls) {
    for (const statics::StaticBall& ball : balls)
      for (const double one : ball.friction)
        if (!std::isnan(one)) needed = std::max(needed.value_or(0.0), one);
  };
  const auto& balls = prepared.statics.balls;
  if (std::all_of(balls.begin(), balls.end(), listing::follows_spin_rule)) {
    count(balls);
  } else {
    statics::BallStaticsOptions options = ball_statics_options(prepared);
    options.friction_balance = false;
    try {
      count(statics::solve_ball_statics(prepared.bearing, options).balls);
    } catch (const SolverError&) {
      return {};  // the spin rule has no equilibrium here: no result
    }
  }
  if (!needed) return {};
  return *needed / available_friction(prepared.input.deck, prepared.bearing)
                       .value_or(listing::kLubricatedFriction);
}

/// Without an oil by grade: add_lives() has the ratio of that.
std::optional<double> viscosity_ratio(const Prepared& prepared) {
  if (prepared.life.iso && prepared.life.iso->kappa_origin == "oil") return {};
  const bearing::Bearing& b = prepared.bearing;
  const double rpm = std::abs(b.speed[1] - b.speed[0]) * 30.0 / kPi;
  const auto& films = prepared.race_result().films;
  if (!b.lubrication || !films || !(rpm > 0.0)) return {};
  const tribology::Lubricant oil = tribology::lubricant_of(*b.lubrication);
  double least = std::numeric_limits<double>::infinity();
  for (const double T : films->temperature)
    least = std::min(least, oil.base_viscosity(T) / oil.density.at(T));
  constexpr double kSquareMillimetres = 1e6, kMillimetres = 1e3;
  return kSquareMillimetres * least /
         life::iso_reference_viscosity(rpm, kMillimetres * b.pitch_diameter());
}

/// (y, z) turned about x.
void turn(double& y, double& z, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), old = y;
  y = c * old - s * z;
  z = s * old + c * z;
}

}  // namespace

std::optional<double> available_friction(const deck::Deck& deck, const bearing::Bearing& bearing) {
  const double largest = tribology::max_traction_coefficient(bearing.race_traction);
  if (!deck.has("kTracType") || !(largest > 0.0)) return std::nullopt;
  return largest;
}

void add_extremes(results::KeyResults& out, const Prepared& prepared) {
  out.push_back(key_result("least_element_load_N", least_element_load(prepared)));
  out.push_back(key_result("largest_approach_m", prepared.race_result().max_deflection));
  if (const auto ratio = gyroscopic_ratio(prepared))
    out.push_back(key_result("gyroscopic_ratio", *ratio));
  if (const auto ratio = viscosity_ratio(prepared))
    out.push_back(key_result("viscosity_ratio", *ratio));
}

VariableCompliance variable_compliance(const Prepared& prepared) {
  const bearing::StaticConstraints& given = prepared.bearing.constraints;
  const double force = std::hypot(given.load[1], given.load[2]);
  if (given.displacement_given[1] || given.displacement_given[2] || !(force > 0.0))
    throw InputError(
        "variable compliance needs a radial force: set kFS2 and kFS3 to 0, and appLoadY or "
        "appLoadZ to a value other than 0");
  if (given.displacement_given[3] != given.displacement_given[4])
    throw InputError(
        "variable compliance needs either both tilts or both moments: set kFS4 and kFS5 to the "
        "same code");
  const auto azimuth_of = [](double y, double z) { return std::atan2(-y, z); };
  const double load_azimuth = azimuth_of(given.load[1], given.load[2]);
  const int count = prepared.bearing.element_count();
  const double pitch = 2.0 * kPi / count;
  const double first = prepared.rollers ? prepared.rollers->rollers.front().azimuth
                                        : prepared.statics.balls.front().azimuth;
  // Smallest turn that brings the load over an element.
  const double under = first + pitch * std::round((load_azimuth - first) / pitch) - load_azimuth;

  bearing::Bearing bearing = prepared.bearing;
  int without = 0;  // positions without a friction equilibrium
  const auto displacement = [&](double angle) {
    bearing::StaticConstraints& c = bearing.constraints;
    c = given;
    turn(c.load[1], c.load[2], angle);
    turn(c.load[3], c.load[4], angle);
    turn(c.displacement[3], c.displacement[4], angle);
    turn(c.outer_misalignment[0], c.outer_misalignment[1], angle);
    std::array<double, 5> q{};
    if (prepared.rollers) {
      const statics::RollerSolution solution =
          statics::solve_roller_statics(bearing, prepared.options.rollers);
      without += solution.friction.findings().empty() ? 0 : 1;
      q = solution.displacement;
    } else {
      statics::StaticSolution solution =
          statics::solve_ball_statics(bearing, ball_statics_options(prepared));
      const auto balance =
          statics::solve_ball_friction_balance(bearing, ball_statics_options(prepared), solution);
      without += balance.findings().empty() ? 0 : 1;
      q = solution.displacement;
    }
    return (q[1] * c.load[1] + q[2] * c.load[2]) / force;
  };
  std::array<double, kCompliancePositions> u{};
  for (std::size_t k = 0; k < u.size(); ++k)
    u[k] = displacement(under + pitch * static_cast<double>(k) / kCompliancePositions);
  if (without != 0 && without != kCompliancePositions)
    throw SolverError(
        fmt::format("variable compliance: no friction equilibrium was found at {} of {} positions "
                    "of the elements, so the variation cannot be computed. Set ballFriction = "
                    "spin-rule or rollerFriction = none",
                    without, kCompliancePositions));
  const auto [least, largest] = std::minmax_element(u.begin(), u.end());
  return {u[kCompliancePositions / 2] - u[0], *largest - *least};
}

}  // namespace adore::runs
