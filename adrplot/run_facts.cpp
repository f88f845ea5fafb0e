#include "adrplot/run_facts.hpp"

#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::adrplot {
namespace {

using Of = results::CageScale::Of;
constexpr double kInch = 0.0254;

/// Radial positions over ratios, where the cage is farthest from its middle: the most digits.
double length_of(const KnownColumns& columns) {
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

OrbitScale orbit_scale(const results::SolFile& file, const KnownColumns& columns,
                       const RunFacts& facts) {
  OrbitScale out;
  out.unit = columns.unit("cage.radial_position");
  if (facts.cage_scale) {
    out.of = facts.cage_scale->of;
    out.length = facts.cage_scale->length / (out.unit == "in" ? kInch : 1.0);
    return out;
  }
  out.length = length_of(columns);
  const auto no_land = [&columns](const char* force) {
    return columns.has(force) && !columns.values(force).why_none.empty();
  };
  if (!no_land("cage.land1_force") || !no_land("cage.land2_force") || file.steps.empty())
    return out;
  // Seven digits; no pocket has a play of a whole metre or inch.
  const bool one = std::abs(out.length - 1.0) < 1e-5;
  out.of = one ? Of::UnitOfLength : Of::Pockets;
  return out;
}

std::string orbit_note(const OrbitScale& scale) {
  const std::string size =
      scale.length > 0.0 ? ", " + desktop::pretty_quantity(scale.length, scale.unit, 3) : "";
  switch (scale.of) {
    case Of::GuideLands:
      return size.empty() ? ""
                          : fmt::format(
                                "Divided by the radial clearance of the guide lands{}: at "
                                "1 the cage touches.",
                                size);
    case Of::Pockets:
      return fmt::format(
          "This cage has no guide land: its orbit is divided by the radial clearance of its "
          "pockets{}. That is no limit, for the elements in them move too.",
          size);
    case Of::UnitOfLength:
      break;
  }
  return fmt::format(
      "This cage has neither a guide land nor clearance in its pockets: its orbit is divided by 1 "
      "{}, so that the numbers are its position.",
      scale.unit);
}

std::string orbit_divisor(const OrbitScale& scale) {
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

}  // namespace adore::adrplot
