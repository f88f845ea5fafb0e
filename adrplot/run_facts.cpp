#include "adrplot/run_facts.hpp"

#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::adrplot {
namespace {

using Of = results::CageLengthScale::Of;
constexpr double kInch = 0.0254;

/// Radial positions divided by ratios, at the largest distance of the cage from its center: most
/// accurate.
double length_of(const ValidColumns& columns) {
  for (const char* id : {"cage.radial_position", "cage.y_over_clearance", "cage.z_over_clearance"})
    if (!columns.has(id)) return 0.0;
  const std::vector<double> radius = columns.values("cage.radial_position").values,
                            y = columns.values("cage.y_over_clearance").values,
                            z = columns.values("cage.z_over_clearance").values;
  double farthest = 0.0, length = 0.0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double ratio = std::hypot(y[i], z[i]);
    if (!(ratio > farthest) || !(radius[i] > 0.0)) continue;
    farthest = ratio;
    length = radius[i] / ratio;
  }
  return length;
}

}  // namespace

OrbitScale orbit_scale(const results::SolFile& file, const ValidColumns& columns,
                       const RunFacts& facts) {
  OrbitScale out;
  out.unit = columns.unit("cage.radial_position");
  out.segment = file.header.segments > 1;
  if (facts.cage_length_scale) {
    out.of = facts.cage_length_scale->of;
    out.length = facts.cage_length_scale->length / (out.unit == "in" ? kInch : 1.0);
    return out;
  }
  out.length = length_of(columns);
  const auto no_land = [&columns](const char* force) {
    return columns.has(force) && !columns.values(force).why_none.empty();
  };
  if (!no_land("cage.land1_force") || !no_land("cage.land2_force") || file.steps.empty())
    return out;
  // Seven digits; no pocket has a clearance of a whole meter or inch.
  const bool one = std::abs(out.length - 1.0) < 1e-5;
  out.of = one ? Of::UnitOfLength : Of::Pockets;
  return out;
}

std::string orbit_note(const OrbitScale& scale) {
  const std::string size =
      scale.length > 0.0 ? ", " + desktop::pretty_quantity(scale.length, scale.unit, 3) : "";
  switch (scale.of) {
    case Of::GuideLands:
      if (size.empty()) return "";
      return fmt::format(
          fmt::runtime(scale.segment
                           ? "The orbit of the segment origin (center of the cage before it was "
                             "cut) is divided by the radial clearance of the guide lands{}. At "
                             "1, the middle of an untilted segment touches the land."
                           : "The orbit is divided by the radial clearance of the guide lands{}. "
                             "At 1, an untilted cage touches the land."),
          size);
    case Of::Pockets:
      return fmt::format(
          "The cage has no guide land: its orbit is divided by the radial pocket clearance{}. "
          "Values above 1 are possible because the rolling elements also move.",
          size);
    case Of::UnitOfLength:
      break;
  }
  return fmt::format("The cage has no guide land and no pocket clearance: its orbit is in {}.",
                     scale.unit);
}

std::string orbit_divisor_text(const OrbitScale& scale) {
  switch (scale.of) {
    case Of::GuideLands:
      return "clearance";
    case Of::Pockets:
      return "pocket clearance";
    case Of::UnitOfLength:
      break;
  }
  return "1 " + scale.unit;
}

bool is_constant(const std::vector<double>& values, double rounding) {
  std::size_t count = 0;
  double low = 0.0, high = 0.0;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    low = count == 0 ? v : std::min(low, v);
    high = count == 0 ? v : std::max(high, v);
    ++count;
  }
  return count > 1 && high - low <= rounding;
}

std::string prescribed_motion_note(const ValidColumns& columns, bool moments) {
  constexpr double kDigits = 2e-7;  // of a plot file
  const auto held = [&columns](const char* id) {
    if (!columns.has(id)) return false;
    const std::vector<double> values = columns.values(id).values;
    double size = 0.0;
    for (const double v : values)
      if (std::isfinite(v)) size = std::max(size, std::abs(v));
    return is_constant(values,
                       std::max(kDigits * size, 1e-3 * desktop::min_axis_span(columns.unit(id))));
  };
  if (moments) {
    if (!held("race.theta") || !held("race.phi") || !held("race.angular_velocity")) return {};
    return "Direction and speed of the race are prescribed: the values are reaction moments, not "
           "loads of the deck.";
  }
  std::string names;
  int count = 0;
  for (const auto& [id, name] : {std::pair{"race.x", "X"}, {"race.y", "Y"}, {"race.z", "Z"}}) {
    if (!held(id)) continue;
    names += (count > 0 ? ", " : "") + std::string(name);
    ++count;
  }
  if (count == 0) return {};
  if (const auto comma = names.rfind(", "); comma != std::string::npos)
    names.replace(comma, 2, " and ");
  return fmt::format(
      "The position of the race is prescribed in {}: the values are reaction forces, not loads of "
      "the deck.",
      names);
}

namespace {

/// ".inner.2" -> "inner", "+x"
std::pair<std::string, const char*> flange_of(const std::string& where) {
  return {where.starts_with(".outer") ? "outer" : "inner", where.ends_with("1") ? "−x" : "+x"};
}

}  // namespace

std::string missing_flange_reason(const std::string& where, const RunFacts& facts, bool part) {
  const auto [race, side] = flange_of(where);
  if (!facts.flanges)
    return fmt::format("The {} race has no flange at {}, or the roller end {}.", race, side,
                       part ? "was not close to it at these steps" : "was never close to it");
  return facts.flanges->contains(where.substr(1))
             ? fmt::format("The roller end was {} close to the flange at {} of the {} race{}.",
                           part ? "not" : "never", side, race, part ? " at these steps" : "")
             : fmt::format("The {} race has no flange at {}.", race, side);
}

bool has_no_flange(const std::string& column, const RunFacts& facts) {
  const auto dot = column.find('.', std::string("flange.").size());
  return column.starts_with("flange.") && dot != std::string::npos && facts.flanges &&
         !facts.flanges->contains(column.substr(dot + 1));
}

}  // namespace adore::adrplot
