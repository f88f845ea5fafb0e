#include "deck/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

/// Records 6, 9 and 10: inertia, loads, times, temperatures, traction curves.
namespace adore::deck {
namespace {

/// No body has a principal moment larger than the sum of the other two.
void check_inertia(Checker& c, std::string_view prefix, std::string_view suffix) {
  const std::array<std::string, 3> names = {fmt::format("{}MIx{}", prefix, suffix),
                                            fmt::format("{}MIy{}", prefix, suffix),
                                            fmt::format("{}MIz{}", prefix, suffix)};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = c.si(names[i]);
    const auto b = c.si(names[(i + 1) % 3]);
    const auto d = c.si(names[(i + 2) % 3]);
    if (a && b && d && *b > 0.0 && *d > 0.0 && *a > (*b + *d) * (1.0 + 1e-6))
      c.error(names[i],
              "is larger than the sum of the other two principal moments, which is not possible "
              "for a rigid body",
              "check the three moments of inertia");
  }
}

void check_constraints(Checker& c) {
  struct Load {
    std::string_view flag, load;
    std::array<std::string_view, 2> free;  ///< a race that moves under it in a run
  };
  constexpr std::array<Load, 5> kLoads = {{{"kFS1", "appLoadX", {"kFD11", "kFD12"}},
                                           {"kFS2", "appLoadY", {"kFD21", "kFD22"}},
                                           {"kFS3", "appLoadZ", {"kFD31", "kFD32"}},
                                           {"kFS4", "appMomY", {"kMD21", "kMD22"}},
                                           {"kFS5", "appMomZ", {"kMD31", "kMD32"}}}};
  const auto mode = c.integer("mode");
  for (const auto& [flag, load, free] : kLoads) {
    const auto value = c.value_in_deck_units(load);
    if (mode && *mode >= 0 && c.is("kDCR", 1) && (c.is(free[0], 0) || c.is(free[1], 0))) continue;
    if (c.is(flag, 1) && value && *value != 0.0)
      c.warning(load, fmt::format("is not used, because {} is 1 (displacement given)", flag),
                fmt::format("set {} or {} to 0", load, flag));
  }
}

void check_times(Checker& c) {
  for (const int race : {1, 2}) {
    const auto start = c.value_in_deck_units(fmt::format("startTime{}", race));
    const std::string name = fmt::format("endTime{}", race);
    const auto end = c.value_in_deck_units(name);
    if (start && end && *end < *start)
      c.error(name, fmt::format("the acceleration ends before its start at {:.10g} s", *start),
              "enter a time after the start");
  }
}

void check_temperatures(Checker& c) {
  const auto room = c.si("roomTemp");
  if (room && *room > 400.0)
    c.warning("roomTemp", fmt::format("a room temperature of {} is unusual", c.temperature(*room)),
              "temperatures are absolute, in K (SI) or R (English)");
  const auto coolant = c.integer("kCoolant");
  const auto flow = c.value_in_deck_units("cFlowRate");
  if (coolant && *coolant > 0 && flow && *flow == 0.0)
    c.warning("cFlowRate", "the coolant does not flow and removes no heat",
              "enter a flow above 0, or set kCoolant to 0");
}

/// Rockwell C is a scale for hard steel; elsewhere its conversion is an extrapolation.
void check_hardness(Checker& c) {
  for (const std::string_view name : {"reH", "raceH1", "raceH2"}) {
    const auto hardness = c.value_in_deck_units(name);
    if (hardness && (*hardness < 20.0 || *hardness > 70.0))
      c.warning(name, "is outside the range of the Rockwell C scale, 20 to 70",
                "enter the hardness in HRC, not HV or Pa");
  }
}

/// Coefficients 1 to `count` of a curve, each by its own name. @return none is below 0
bool not_negative(Checker& c, std::string_view stem, int count) {
  bool good = true;
  for (int k = 1; k <= count; ++k) {
    const std::string name = fmt::format("{}{}", stem, k);
    const auto value = c.value_in_deck_units(name);
    if (!value || !(*value < 0.0)) continue;
    c.error(name, "a traction coefficient cannot be negative", "enter a value of at least 0");
    good = false;
  }
  return good;
}

/// The four-condition curve has a solution only when its largest value is really larger than both
/// ends.
void check_peak(Checker& c, std::string_view stem) {
  const std::string peak_name = fmt::format("{}2", stem);
  const auto at_zero = c.value_in_deck_units(fmt::format("{}1", stem));
  const auto peak = c.value_in_deck_units(peak_name);
  const auto at_infinity = c.value_in_deck_units(fmt::format("{}3", stem));
  if (!at_zero || !peak || !at_infinity) return;
  if (*peak == *at_zero && *peak == *at_infinity) return;  // a constant coefficient
  const bool rises = *peak > *at_zero || (*at_zero == *at_infinity && *peak >= *at_zero);
  const bool falls = *peak > *at_infinity;
  if (!rises || !falls)
    c.error(peak_name,
            fmt::format("the largest traction coefficient must be above those at zero slip "
                        "({0}1 = {1:.6g}) and at infinite slip ({0}3 = {2:.6g})",
                        stem, *at_zero, *at_infinity),
            "enter a larger value, or use curve type 2 for a curve without a peak");
}

/// The asymptotic curve decays only when its slope points from the start towards the asymptote.
void check_asymptote(Checker& c, std::string_view stem) {
  const std::string slope_name = fmt::format("{}3", stem);
  const auto at_zero = c.value_in_deck_units(fmt::format("{}1", stem));
  const auto at_infinity = c.value_in_deck_units(fmt::format("{}2", stem));
  const auto slope = c.value_in_deck_units(slope_name);
  if (!at_zero || !at_infinity || !slope) return;
  const double rise = *at_infinity - *at_zero;
  const bool constant = rise == 0.0 && *slope == 0.0;
  if (!constant && !(*slope * rise > 0.0))
    c.error(slope_name,
            fmt::format("with this slope, the curve does not approach the asymptote: the traction "
                        "coefficient must change from {0}1 = {1:.6g} to {0}2 = {2:.6g}",
                        stem, *at_zero, *at_infinity),
            rise > 0.0   ? "enter a positive slope"
            : rise < 0.0 ? "enter a negative slope"
                         : "enter slope 0 for a constant coefficient");
}

void check_curves(Checker& c) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kCurves = {
      {{"kTracType", "reRaceTC"},
       {"kRFTracType", "reFlngTC"},
       {"kCPTracType", "reCageTC"},
       {"kCRTracType", "cageRaceTC"},
       {"kRRTracType", "reReTC"}}};
  for (const auto& [type, stem] : kCurves) {
    if (c.is(type, 1) && not_negative(c, stem, 3)) check_peak(c, stem);
    if (c.is(type, 2) && not_negative(c, stem, 2)) check_asymptote(c, stem);
    const auto rate = c.value_in_deck_units(fmt::format("{}3", stem));
    if (c.is(type, -1) && rate && *rate < 0.0)
      c.error(fmt::format("{}3", stem),
              "with a negative coefficient C the traction coefficient grows without limit",
              "enter a value of at least 0");
  }
}

}  // namespace

void check_operation(Checker& c) {
  check_inertia(c, "bRe", "");
  check_inertia(c, "race", "1");
  check_inertia(c, "race", "2");
  check_inertia(c, "cage", "");
  check_constraints(c);
  check_times(c);
  check_temperatures(c);
  check_curves(c);
  check_hardness(c);
}

}  // namespace adore::deck
