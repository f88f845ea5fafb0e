#include "bearing/ring_tolerance.hpp"

#include "base/errors.hpp"
#include "bearing/rating_data.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace adore::bearing {
namespace {

constexpr std::array<std::string_view, 5> kClassNames = {"Normal", "6", "5", "4", "2"};

RingTolerance tolerance(const char* part, const char* name, RingToleranceClass ring,
                        double nominal) {
  const nlohmann::json& table = rating_data("ring_tolerances").at(part);
  const auto column = static_cast<std::size_t>(ring);
  const double size = 1e3 * nominal;
  for (const nlohmann::json& row : table.at("rows")) {
    const double to = row.at(1).get<double>();
    if (!(size > row.at(0).get<double>() - (&row == &table.at("rows").front() ? 1e-9 : 0.0)) ||
        size > to + 1e-9 || row.at(column + 2).is_null())
      continue;
    constexpr double kMicrometer = 1e-6;
    return {{kMicrometer * row.at(column + 2).get<double>(), 0.0},
            to <= table.at("largest_seen").at(column).get<double>()};
  }
  throw InputError(
      fmt::format("{} {:.6g} mm: tolerance class {} is not available for this size. Enter a size "
                  "of 2.5 mm or more (in classes 4 and 2: bores up to 250 mm, outside diameters up "
                  "to 400 mm), or enter another class.",
                  name, size, kClassNames.at(column)));
}

}  // namespace

RingToleranceClass ring_class(std::string_view name) {
  std::string_view plain = name;
  if (plain.size() > 1 && (plain[0] == 'P' || plain[0] == 'p')) plain.remove_prefix(1);
  if (plain == "0") plain = kClassNames[0];
  for (std::size_t k = 0; k < kClassNames.size(); ++k)
    if (plain == kClassNames.at(k)) return static_cast<RingToleranceClass>(k);
  throw InputError(fmt::format(
      "bearing tolerance class {}: this class does not exist. Enter Normal, 6, 5, 4 or 2.", name));
}

RingTolerance bore_tolerance(RingToleranceClass ring, double nominal) {
  return tolerance("bore", "bore", ring, nominal);
}

RingTolerance outside_diameter_tolerance(RingToleranceClass ring, double nominal) {
  return tolerance("outside", "outside diameter", ring, nominal);
}

Interference interference(const SizeLimits& inner_part, const SizeLimits& outer_part) {
  Interference out;
  out.least = inner_part.lower - outer_part.upper;
  out.most = inner_part.upper - outer_part.lower;
  out.mean = 0.5 * (out.least + out.most);
  const double half = 0.5 * std::hypot(inner_part.width(), outer_part.width());
  out.probable_least = out.mean - half;
  out.probable_most = out.mean + half;
  return out;
}

}  // namespace adore::bearing
