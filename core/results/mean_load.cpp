#include "results/mean_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::results {
namespace {

/// Difference between actual and specified load along a direction with a specified load [N].
double off(const MeanLoad& load, std::size_t k) {
  const auto i = static_cast<Eigen::Index>(k);
  return load.given[k] ? std::abs(load.mean[i] - load.asked[i]) : 0.0;
}

/// The same across the specified load, along directions with a specified load of 0.
double across(const MeanLoad& load) {
  double out = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (load.asked[static_cast<Eigen::Index>(k)] == 0.0) out = std::hypot(out, off(load, k));
  return out;
}

double off(const MeanLoad& load) { return std::hypot(off(load, 0), off(load, 1), off(load, 2)); }

/// "appLoadX 1500, appLoadZ 500" of the directions with a given load that is not 0, or with one of
/// 0 that is not kept.
std::string named(const MeanLoad& load, const scene::Vec3& values, UnitSystem units) {
  constexpr double kMinDifferenceShare = 0.2;  // of all that is off
  std::string out;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (!load.given[k] || (load.asked[i] == 0.0 && off(load, k) <= kMinDifferenceShare * off(load)))
      continue;
    out += fmt::format("{}appLoad{} {:.4g}", out.empty() ? "" : ", ", "XYZ"[k],
                       from_si(values[i], unit::kForce, units));
  }
  return out + " " + std::string(unit_name(unit::kForce, units));
}

}  // namespace

double MeanLoad::departure() const {
  double size = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (given[k]) size = std::hypot(size, asked[static_cast<Eigen::Index>(k)]);
  return size > 0.0 ? off(*this) / std::max(size, kLoadFloor * contact) : 0.0;
}

MeanLoad mean_load(const Averages& averages, const bearing::Bearing& bearing,
                   const scene::ScenePlan& plan) {
  MeanLoad out;
  out.time = averages.time;
  out.mean = averages.load;
  out.contact = averages.largest_load;
  out.balanced = plan.has(scene::Effect::RaceBalance);
  for (const auto& vibration : plan.race_motions.vibration)
    out.shaken = out.shaken || vibration.has_value();
  for (const auto& free : plan.race_motions.free)
    out.tilts = out.tilts || (free && !(free->rotation_held[1] && free->rotation_held[2]));
  for (std::size_t k = 0; k < 3; ++k) {
    out.given[k] = !bearing.constraints.displacement_given[k];
    const auto& turning = plan.race_motions.rotating_load_parameters;
    if (k > 0 && turning && (turning->fraction[0] != 0.0 || turning->fraction[1] != 0.0))
      out.given[k] = false;
    if (out.given[k]) out.asked[static_cast<Eigen::Index>(k)] = bearing.constraints.load[k];
    out.moves[k] = out.balanced;
    for (const auto& free : plan.race_motions.free)
      out.moves[k] = out.moves[k] || (free && !free->translation_held[k]);
  }
  return out;
}

std::string load_warning(const MeanLoad& load, UnitSystem units) {
  const double departure = load.departure();
  if (departure <= (load.balanced ? kBalanceWarning : kLoadWarning)) return {};
  // The actual load is nearly proportional to the specified one, unless the load is
  // entirely different.
  scene::Vec3 instead = load.asked;
  bool scalable = true;
  for (int k = 0; k < 3; ++k) {
    if (load.asked[k] == 0.0 || !load.given[static_cast<std::size_t>(k)]) continue;
    const double ratio = load.mean[k] / load.asked[k];
    scalable = scalable && ratio > 0.3 && ratio < 3.0;
    if (ratio != 0.0) instead[k] = load.asked[k] / ratio;
  }
  std::string out = fmt::format(
      "the mean load of the elements is {} over {:.3g} s, but the deck specifies {} ({:.1f} % "
      "difference). Cause: ",
      named(load, load.mean, units), load.time, named(load, load.asked, units), 100.0 * departure);
  std::size_t furthest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (off(load, k) > off(load, furthest)) furthest = k;
  if (load.balanced)
    return out +
           "in mode 2 the inner race has no inertia. Centrifugal force, gravity or cage forces "
           "exceed the load, so the elements lose contact for short times. Increase the load or "
           "preload, or set mode = 0 with kDCR = 1 and kFD = 0";
  if (load.moves[furthest])
    return out + fmt::format(
                     "a race is free to move along {}, and in this short run part of the load "
                     "accelerates it. Extend the run to reduce the difference",
                     "xyz"[furthest]);
  if (load.tilts)
    return out +
           "a race without prescribed tilt (kMD21, kMD31, kMD22 or kMD32 of record 2.2) tilts away "
           "from its quasi-static position. This tilt changes the load of the elements. Prescribe "
           "the tilt, or give the moments of the quasi-static solution";
  if (load.shaken)
    return out +
           "record 9.3B makes a race vibrate about its quasi-static position. The mean load "
           "changes because contacts stiffen under load, or because the last period is incomplete. "
           "Compare with a run without vibration before changing the load";
  // Fraction of the difference: another load along the specified one corrects the rest.
  constexpr double kMaxAcrossShare = 0.5;
  if (across(load) > kMaxAcrossShare * off(load))
    return out +
           "the inner race is fixed at its quasi-static position, where the moving elements exert "
           "forces perpendicular to the specified load. A different load in the specified "
           "direction does not correct these forces. A longer run or a cage distributes the "
           "elements more evenly. A race that is free to move (kDCR = 1 and kFD = 0) has the "
           "specified mean load";
  out +=
      "the inner race is fixed at its quasi-static position. There, the forces of moving elements "
      "differ from those of the quasi-static solution. ";
  out += scalable ? fmt::format(
                        "To obtain the specified mean load, enter about {}, or specify the "
                        "displacement (kFS1-3, appDispX to Z)",
                        named(load, instead, units))
                  : "Specify the displacement instead of the load (kFS1-3, appDispX to Z), and "
                    "adjust the displacement until the mean load is correct";
  return out;
}

}  // namespace adore::results
