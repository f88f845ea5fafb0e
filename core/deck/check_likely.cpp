#include "deck/check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

/// Values that are legal but most likely a slip: deg C for K, mm/s² for m/s², rad for deg, a deck
/// in SI that says English, a bearing that nothing loads or turns. Warnings only.
namespace adore::deck {
namespace {

constexpr double kStandardGravity = 9.80665;  // [m/s²]
constexpr double kInchPerMetre = 1.0 / 0.0254;
constexpr double kFreezingPoint = 273.15;  // 0 deg C [K]
constexpr double kColdest = 200.0;         // no bearing but a cryogenic one runs below [K]

constexpr std::array<std::string_view, 8> kTemperatures = {
    "roomTemp", "hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "cageTemp", "baseTemp"};

bool english(const Checker& c) { return c.deck().units() == UnitSystem::English; }

bool near(double value, double expected, double tolerance) {
  return std::abs(value - expected) <= tolerance * expected;
}

/// Liquefied gases as medium or coolant (codes 3 to 7): the deck means its temperatures.
bool says_cryogenic(const Checker& c) {
  for (const char* name : {"kChrn", "kCoolant"}) {
    const auto code = c.integer(name);
    if (code && *code >= 3 && *code <= 7) return true;
  }
  return false;
}

/// The temperatures below kColdest share one remark: deg C is then used for all of them.
void check_celsius(Checker& c) {
  std::string_view first;
  std::string others;
  for (const std::string_view name : kTemperatures) {
    const auto kelvin = c.si(name);
    if (!kelvin || *kelvin <= 0.0 || *kelvin >= kColdest) continue;
    if (first.empty())
      first = name;
    else
      others += (others.empty() ? "" : ", ") + std::string(name);
  }
  if (first.empty() || says_cryogenic(c)) return;
  const double value_in_deck_units = *c.value_in_deck_units(first);
  const char* scale = english(c) ? "deg F" : "deg C";
  const double absolute =
      english(c) ? value_in_deck_units + 459.67 : value_in_deck_units + kFreezingPoint;
  c.warning(first,
            fmt::format("is {:.0f} deg C: plausible only for a cryogenic bearing{}",
                        *c.si(first) - kFreezingPoint,
                        others.empty() ? std::string() : " (also " + others + ")"),
            fmt::format("temperatures are absolute: for {:g} {} write {:.6g} {}",
                        value_in_deck_units, scale, absolute, english(c) ? "R" : "K"));
}

/// @param number the deck's value of the vector's length
void check_gravity(Checker& c) {
  double square = 0.0;
  std::string_view largest;
  double most = 0.0;
  for (const std::string_view name : {"gravityVecX", "gravityVecY", "gravityVecZ"}) {
    const auto value = c.value_in_deck_units(name);
    if (!value) return;
    square += *value * *value;
    if (std::abs(*value) > most) {
      most = std::abs(*value);
      largest = name;
    }
  }
  if (largest.empty()) return;
  const double size = std::sqrt(square);
  const bool inches = english(c);
  const double right = inches ? kStandardGravity * kInchPerMetre : kStandardGravity;
  struct Slip {
    double value;
    const char* unit;
  };
  const std::array<Slip, 5> slips{
      {{1000.0 * kStandardGravity, "mm/s^2"},
       {1.0, "units of g"},
       {kStandardGravity / 0.3048, "ft/s^2"},
       {inches ? kStandardGravity : kStandardGravity * kInchPerMetre, inches ? "m/s^2" : "in/s^2"},
       {100.0 * kStandardGravity, "cm/s^2"}}};
  for (const Slip& slip : slips)
    if (near(size, slip.value, 0.02)) {
      c.warning(largest, fmt::format("looks like gravity in {}", slip.unit),
                fmt::format("enter gravity in {}, the unit of this deck: {:.5g}",
                            inches ? "in/s^2" : "m/s^2", right));
      return;
    }
  if (size > 100.0 * right)
    c.warning(largest, fmt::format("is {:.0f} times the gravity of Earth", size / right),
              fmt::format("enter gravity in {}, the unit of this deck: {:.5g}",
                          inches ? "in/s^2" : "m/s^2", right));
}

/// A contact angle of 0.44 is more likely 25 deg in rad than half a degree.
void check_radians(Checker& c) {
  for (const std::string_view name : {"freeConAng", "raceTaper1", "raceTaper2"}) {
    const auto angle = c.value_in_deck_units(name);
    const double least = name == "freeConAng" ? 0.05 : 0.09, most = 1.5;
    if (!angle || std::abs(*angle) < least || std::abs(*angle) > most) continue;
    c.warning(
        name,
        fmt::format("is below {:g} deg and may be in rad; angles of this record are in deg", most),
        fmt::format("for {:g} rad write {:.6g}", *angle, *angle * 180.0 / 3.14159265358979));
  }
  for (const std::string_view name : {"appMis11", "appMis21", "appMis12", "appMis22"}) {
    const auto angle = c.value_in_deck_units(name);
    if (!angle || std::abs(*angle) < 0.1) continue;
    c.warning(name,
              fmt::format("is a misalignment of {:.3g} deg; misalignments are in rad",
                          *angle * 180.0 / 3.14159265358979),
              fmt::format("for {:g} deg write {:.6g}", *angle, *angle * 3.14159265358979 / 180.0));
  }
}

/// Room temperature gives the unit system away: 293 in K, 528 in R. True when it was said.
bool check_unit_system(Checker& c) {
  const auto room = c.value_in_deck_units("roomTemp");
  if (!room) return false;
  const bool kelvin = english(c) && *room > 270.0 && *room < 325.0;
  const bool rankine = !english(c) && *room > 490.0 && *room < 580.0;
  if (kelvin)
    c.warning("kUnit",
              fmt::format("selects English units, but roomTemp = {:g} is a room temperature in K; "
                          "as a value in R it is {:.0f} deg C",
                          *room, *room / 1.8 - kFreezingPoint),
              "set kUnit to 1 if the deck is in SI units, or enter temperatures in R");
  if (rankine)
    c.warning("kUnit",
              fmt::format("selects SI units, but roomTemp = {:g} is a room temperature in R; as a "
                          "value in K it is {:.0f} deg C",
                          *room, *room - kFreezingPoint),
              "set kUnit to 2 if the deck is in English units, or enter temperatures in K");
  return kelvin || rankine;
}

/// Nothing presses elements and races together: no load, no displacement, no play taken away.
void check_loads(Checker& c) {
  constexpr std::array<std::array<std::string_view, 3>, 5> kAxes = {
      {{"kFS1", "appLoadX", "appDispX"},
       {"kFS2", "appLoadY", "appDispY"},
       {"kFS3", "appLoadZ", "appDispZ"},
       {"kFS4", "appMomY", "appMis12"},
       {"kFS5", "appMomZ", "appMis22"}}};
  for (const auto& [flag, load, displacement] : kAxes) {
    const auto code = c.integer(flag);
    const auto value = c.value_in_deck_units(code && *code == 1 ? displacement : load);
    if (!code || !value || *value != 0.0) return;
  }
  // Other ways to a load: the outer ring tilted, preload by interference, fits and growth; loads
  // and inertia forces that change in time.
  for (const std::string_view name : {"appMis11", "appMis21"})
    if (const auto value = c.value_in_deck_units(name); value && *value != 0.0) return;
  if (const auto clearance = c.value_in_deck_units("freeIntCls"); clearance && *clearance < 0.0)
    return;
  for (const std::string_view name : {"raceFit1", "raceFit2"})
    if (const auto fit = c.value_in_deck_units(name); fit && *fit > 0.0) return;
  const auto room = c.value_in_deck_units("roomTemp");
  for (const std::string_view name : kTemperatures)
    if (const auto value = c.value_in_deck_units(name);
        value && room && name != "baseTemp" && *value != *room)
      return;
  for (const std::string_view name : {"kVarLoad", "kRotFrame", "kReGeoImp"})
    if (const auto code = c.integer(name); code && *code != 0) return;
  const auto mode = c.integer("mode");
  if (!mode) return;
  c.warning(
      "appLoadX",
      "the inner race has no load, moment or displacement that presses the elements against "
      "the races",
      "enter a load on record 9.1.1, or set one of kFS1 to kFS5 to 1 and enter a displacement");
}

/// Races that do not turn against each other roll nothing.
void check_speeds(Checker& c) {
  const auto outer = c.value_in_deck_units("rpm1"), inner = c.value_in_deck_units("rpm2");
  if (!outer || !inner || *outer != *inner) return;
  const auto varied = c.integer("kVarSpeed"), table = c.integer("kStif"), mode = c.integer("mode");
  if (!mode || (varied && *varied != 0)) return;
  if (*mode < 0 && table && *table > 0) return;  // the stiffness table brings its own speeds
  if (*mode < 0 && *inner == 0.0) {              // at rest the equilibrium alone is a fair question
    c.add(c.deck().issue(
        Severity::Note, "rpm2",
        "no race rotates: the result is the equilibrium at rest, without a life in hours",
        "enter a speed on record 9.1.2, unless the bearing is at rest"));
    return;
  }
  c.warning("rpm2",
            *inner == 0.0
                ? std::string("no race rotates, so that nothing rolls")
                : fmt::format("both races rotate at {:g} rpm, so that nothing rolls", *inner),
            "give the races different speeds on record 9.1.2");
}

}  // namespace

void check_likely_mistakes(Checker& c) {
  if (!check_unit_system(c)) check_celsius(c);
  check_gravity(c);
  check_radians(c);
  check_loads(c);
  check_speeds(c);
}

}  // namespace adore::deck
