#include "runs/fault_frequencies.hpp"

#include "runs/run_span.hpp"
#include "statics/kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::runs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// At a mean speed of the element set and mean spin [rad/s].
FaultFrequencies frequencies(const bearing::Bearing& bearing, double set_speed,
                             std::optional<double> spin) {
  const double count = bearing.element_count() / kTurn;
  FaultFrequencies out{count * std::abs(set_speed - bearing.speed[0]),
                       count * std::abs(bearing.speed[1] - set_speed), std::nullopt,
                       set_speed / kTurn};
  if (spin) out.spin = std::abs(*spin) / kTurn;
  return out;
}

std::string text_of(const FaultFrequencies& f) {
  return fmt::format(
      "outer race (BPFO) {:.5g}, inner race (BPFI) {:.5g}, {}cage (FTF) {:.5g} Hz", f.outer,
      f.inner, f.spin ? fmt::format("element spin (BSF) {:.5g}, ", *f.spin) : "", std::abs(f.cage));
}

}  // namespace

FaultFrequencies nominal_fault_frequencies(const Prepared& prepared) {
  const bearing::Bearing& made = prepared.as_built;
  double diameter = 0.0, pitch = 0.0, angle = 0.0;
  if (const bearing::RollerGeometry* rollers = made.rollers()) {
    diameter = rollers->diameter;
    pitch = rollers->pitch_diameter;
    angle = 0.5 * (rollers->race_angle[0] + rollers->race_angle[1]);
  } else {
    diameter = made.balls().diameter;
    pitch = made.balls().pitch_diameter;
    angle = made.balls().contact_angle;
  }
  const statics::EpicyclicSpeeds s = statics::epicyclic_speeds(
      made.element_count(), diameter, pitch, angle, made.speed[0], made.speed[1]);
  return {s.outer_pass, s.inner_pass, s.spin_frequency, s.cage_frequency};
}

FaultFrequencies equilibrium_fault_frequencies(const Prepared& prepared) {
  double orbit = 0.0, spin = 0.0, all_orbit = 0.0, all_spin = 0.0;
  int loaded = 0, all = 0;
  const auto add = [&](double orbital_speed, double spin_speed, bool carries) {
    all_orbit += orbital_speed;
    all_spin += std::abs(spin_speed);
    ++all;
    if (!carries) return;
    orbit += orbital_speed;
    spin += std::abs(spin_speed);
    ++loaded;
  };
  if (const auto& solution = prepared.rollers) {
    for (const statics::StaticRoller& roller : solution->rollers)
      add(roller.balanced ? roller.orbital_speed : solution->orbital_speed,
          roller.balanced ? roller.spin_speed : solution->spin_speed, roller.race[1].load > 0.0);
  } else {
    for (const statics::StaticBall& ball : prepared.statics.balls)
      add(ball.orbital_speed, ball.spin_speed, ball.Q[1] > 0.0);
  }
  const double share = loaded > 0 ? 1.0 / loaded : 1.0 / std::max(1, all);
  return frequencies(prepared.bearing, share * (loaded > 0 ? orbit : all_orbit),
                     share * (loaded > 0 ? spin : all_spin));
}

std::optional<FaultFrequencies> motion_fault_frequencies(const Prepared& prepared,
                                                         const results::Averages& averages) {
  const bearing::Bearing& bearing = prepared.bearing;
  const double relative = bearing.speed[1] - bearing.speed[0];
  if (!(averages.time > 0.0) || averages.orbital_ratio == 0.0 || relative == 0.0 ||
      speeds_vary(prepared))
    return std::nullopt;
  FaultFrequencies out = frequencies(bearing, averages.orbital_ratio * relative, std::nullopt);
  if (bearing.cage) out.cage = averages.cage_ratio * relative / kTurn;
  return out;
}

void add_fault_frequencies(results::KeyResults& out, const Prepared& prepared,
                           const std::optional<FaultFrequencies>& computed) {
  const auto add = [&](const std::string& kind, const FaultFrequencies& f) {
    const auto one = [&](const char* name, double value) {
      out.push_back(results::key_result(name + kind + "_Hz", value));
    };
    one("bpfo", f.outer);
    one("bpfi", f.inner);
    if (f.spin) one("bsf", *f.spin);
    one("ftf", f.cage);
  };
  add("_nominal", nominal_fault_frequencies(prepared));
  if (computed) add("", *computed);
}

std::vector<std::string> fault_frequency_lines(const Prepared& prepared,
                                               const std::optional<FaultFrequencies>& computed) {
  if (prepared.bearing.speed[0] == prepared.bearing.speed[1]) return {};
  std::vector<std::string> out{"passing frequencies, nominal: " +
                               text_of(nominal_fault_frequencies(prepared))};
  if (computed) out.push_back("passing frequencies, computed: " + text_of(*computed));
  return out;
}

}  // namespace adore::runs
