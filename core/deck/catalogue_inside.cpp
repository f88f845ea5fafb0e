#include "base/errors.hpp"
#include "deck/catalogue_parts.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// Estimates of the internal geometry of a bearing.
namespace adore::deck {
namespace {

double nearest(double value, double step) {
  return std::max(step, std::round(value / step) * step);
}

std::string clearance_reason(std::string_view group) {
  return fmt::format("middle of group {} (ISO 5753-1)", group);
}

class Sets {
 public:
  void real(std::string_view name, double value) {
    list_.emplace_back(name, fmt::format("{}", value));
  }
  /// A length, to a tenth of a micrometer.
  void length(std::string_view name, double value) { real(name, std::round(value * 1e7) / 1e7); }
  void whole(std::string_view name, long long value) {
    list_.emplace_back(name, fmt::format("{}", value));
  }
  std::vector<std::pair<std::string, std::string>> take() { return std::move(list_); }

 private:
  std::vector<std::pair<std::string, std::string>> list_;
};

/// Elements side by side on the pitch circle when `share` of the circle is theirs.
long long elements_that_fit(double diameter, double pitch, double share) {
  return static_cast<long long>(
      std::floor(share * std::numbers::pi / std::asin(diameter / pitch) + 1e-9));
}

InnerGeometry balls(BearingType type, const Envelope& e, double angle, std::string_view group) {
  constexpr double kInch32 = 0.0254 / 32.0, kSection = 0.30, kShoulder = 0.54;
  const double pitch = 0.5 * (e.bore + e.outside);
  const double ball = nearest(kSection * (e.outside - e.bore), kInch32);
  const bool deep = type == BearingType::DeepGroove;
  // A deep groove bearing is filled through the gap of rings laid against each other: its balls
  // cover 195 degrees then. A split cage leaves a tenth of the circle in the other type.
  constexpr double kFilled = 195.0 / 2.0;
  const long long count =
      deep ? static_cast<long long>(std::floor(kFilled * kDegree / std::asin(ball / pitch))) + 1
           : elements_that_fit(ball, pitch, 0.9);
  Sets sets;
  sets.whole("nRe", count);
  sets.real("bReDia", ball);
  sets.length("pitchDia", pitch);
  sets.real("freeConAng", deep ? 0.0 : angle);
  sets.length("freeIntCls", deep ? middle_clearance(type, group, e.bore) : 0.0);
  sets.real("raceCurFac1", deep ? 0.525 : 0.5232);
  sets.real("raceCurFac2", deep ? 0.515 : 0.5232);
  sets.length("shoulderDia1", pitch + kShoulder * ball);
  sets.length("shoulderDia2", pitch - kShoulder * ball);
  return {sets.take(), fmt::format("D = 0.30 (OD - bore), rounded to 1/32 in; {}; groove factors "
                                   "and shoulders as in the {} example{}",
                                   deep ? "as many balls as eccentric filling allows"
                                        : "balls on 90 % of the pitch circle",
                                   deep ? "6205" : "218",
                                   deep ? "; clearance: " + clearance_reason(group) : "")};
}

InnerGeometry cylinders(const Envelope& e, std::string_view group) {
  const double pitch = 0.5 * (e.bore + e.outside);
  const double roller = nearest(0.25 * (e.outside - e.bore), 0.5 * kMm);
  const double length = std::min(roller, nearest(0.6 * e.width, 0.5 * kMm));
  Sets sets;
  sets.whole("nRe", elements_that_fit(roller, pitch, 0.7));
  sets.length("bReDia", roller);
  sets.real("bReCrn", std::round(200.0 * length * 1e3) / 1e3);
  sets.length("bReLen", length);
  sets.length("bReCenLen", 0.6 * length);
  sets.length("bReCorRad1", 0.02 * roller);
  sets.length("bReCorRad2", 0.02 * roller);
  sets.length("pitchDia", pitch);
  sets.length("freeIntCls", middle_clearance(BearingType::Cylindrical, group, e.bore));
  sets.length("raceLandLmt1", length);
  sets.length("raceLandLmt2", 1.2 * length);
  sets.length("flngHt11", 0.2 * roller);
  sets.length("flngHt21", 0.2 * roller);
  return {sets.take(),
          "D = L = 0.25 (OD - bore); rollers on 70 % of the pitch circle, as in the 209 bearing of "
          "textbooks; typical crown and flanges; clearance: " +
              clearance_reason(group)};
}

InnerGeometry cones(const Envelope& e, double cup) {
  const double pitch = 0.5 * (e.bore + e.outside);
  const double roller = nearest(0.245 * (e.outside - e.bore), 0.1 * kMm);
  const double length = nearest(0.75 * e.width, 0.5 * kMm);
  // Both cones share their apex: D / dm = sin h / sin m with m = cup - h, h half the taper.
  const double ratio = roller / pitch, alpha = cup * kDegree;
  const double half = std::atan2(ratio * std::sin(alpha), 1.0 + ratio * std::cos(alpha));
  const double to_apex = 0.5 * pitch / std::sin(alpha - half);
  Sets sets;
  sets.whole("nRe", elements_that_fit(roller, pitch, 0.9));
  sets.length("bReDia", roller);
  sets.real("bReCrn", std::round(8.0 * std::pow(length / 0.0135, 2) * 100.0) / 100.0);
  sets.length("bReLen", length);
  sets.length("bReCenLen", length * 2.0 / 3.0);
  sets.length("bReEndRad1", std::round(0.76 * to_apex * 1e3) / 1e3);
  sets.length("bReEndRad2", std::round(0.76 * to_apex * 1e3) / 1e3);
  sets.length("bReCorRad1", 0.04 * roller);
  sets.length("bReCorRad2", 0.04 * roller);
  sets.real("raceTaper1", cup);
  sets.real("raceTaper2", std::round((cup - 2.0 * half / kDegree) * 1e4) / 1e4);
  sets.length("raceLandLmt1", length);
  sets.length("raceLandLmt2", length);
  sets.length("flngHt12", 0.255 * roller);
  return {sets.take(),
          "D = 0.245 (OD - bore); L = 0.75 times the cone width; rollers on 90 % of the pitch "
          "circle; cone angle from the cup angle; typical crown and rib"};
}

InnerGeometry barrels(const Envelope& e, double angle, std::string_view group, bool tapered_bore) {
  const double pitch = 0.502 * (e.bore + e.outside);
  const double roller = nearest(0.275 * (e.outside - e.bore), 0.1 * kMm);
  const double sphere =
      0.5 * pitch / std::cos(angle * kDegree) + 0.5 * roller;  // of the outer race
  Sets sets;
  sets.whole("nRe", elements_that_fit(roller, pitch, 0.87));
  sets.length("bReDia", roller);
  sets.length("bReCrn", 0.961 * sphere);
  sets.length("bReLen", nearest(0.413 * e.width, 0.1 * kMm));
  sets.length("bReCorRad1", 0.036 * roller);
  sets.length("bReCorRad2", 0.036 * roller);
  sets.length("pitchDia", pitch);
  sets.length("freeIntCls", middle_clearance(BearingType::Spherical, group, e.bore, tapered_bore));
  sets.real("raceCurFac1", 0.5133);
  sets.real("raceCurFac2", 0.5133);
  sets.real("freeConAng", std::round(angle * 100.0) / 100.0);
  return {sets.take(),
          "D = 0.275 (OD - bore); L = 0.413 times the width; rollers on 87 % of the pitch circle; "
          "contact angle from the distance of the rows; clearance: " +
              clearance_reason(group) + (tapered_bore ? " for tapered bores" : "")};
}

/// Record 7.1 in proportion to the cage of the example of the type: diameters about the pitch
/// circle, width with the elements, plays with their diameter. Estimates, as all of the inside.
void propose_cage(std::string_view example_name, const Envelope& e, double diameter, double length,
                  double cone_angle, Sets& sets) {
  const Deck example = new_deck(example_name);
  const auto of = [&](std::string_view name) { return example.real(name); };
  const bool balls = !example.has("bReLen");
  const double pitch = 0.5 * (e.bore + e.outside),
               pitch_there = 0.5 * (of("brgBore") + of("brgOD"));
  const double size = diameter / of("bReDia");
  for (const char* name : {"cageDia1", "cageDia2"})
    sets.length(name, pitch + (of(name) - pitch_there) * size);
  sets.length("cageWidth", of("cageWidth") * (balls ? size : length / of("bReLen")));
  for (const char* name : {"cageCls1", "cageCls2", "bPocCls1", "bPocCls2"})
    sets.length(name, of(name) * size);
  sets.real("cageConeAng", cone_angle);
}

}  // namespace

InnerGeometry propose_inner(BearingType type, const Envelope& envelope, double angle,
                            std::string_view group, bool tapered_bore) {
  const double section = envelope.outside - envelope.bore;
  if (!(envelope.bore > 0.0 && section > 0.0 && envelope.width > 0.0))
    throw InputError(fmt::format(
        "no elements fit between bore {} m and outside diameter {} m at width {} m; the bore must "
        "be above 0 and below the outside diameter, and the width above 0",
        envelope.bore, envelope.outside, envelope.width));
  switch (type) {
    case BearingType::Cylindrical:
      return cylinders(envelope, group);
    case BearingType::Tapered:
      return cones(envelope, angle > 0.0 ? angle : usual_angle(type, envelope));
    case BearingType::Spherical:
      return barrels(envelope, angle > 0.0 ? angle : usual_angle(type, envelope), group,
                     tapered_bore);
    default:
      return balls(type, envelope, angle > 0.0 ? angle : usual_angle(type, envelope), group);
  }
}

InnerGeometry propose_inner(const Deck& deck) {
  const long long kind = deck.integer("kBrg");
  if (kind < 1 || kind > 4)
    throw InputError(
        fmt::format("kBrg = {}: internal geometry is estimated only for ball, cylindrical, "
                    "spherical and tapered bearings (1 to 4)",
                    kind));
  constexpr std::array<BearingType, 4> kOfCode = {BearingType::DeepGroove, BearingType::Cylindrical,
                                                  BearingType::Spherical, BearingType::Tapered};
  BearingType type = kOfCode.at(static_cast<std::size_t>(kind - 1));
  const double angle = kind == 4   ? deck.real("raceTaper1")
                       : kind == 2 ? 0.0
                                   : deck.real("freeConAng");
  if (kind == 1 && angle != 0.0) type = BearingType::AngularContact;
  Envelope envelope{deck.si("brgBore"), deck.si("brgOD"), deck.si("raceWidth2"),
                    deck.si("raceWidth1")};
  if (kind == 3) envelope.width *= 2.0;  // of both rows
  InnerGeometry out = propose_inner(type, envelope, angle);
  if (deck.integer("nCseg") == 1) {
    constexpr std::array<std::string_view, 4> kExamples = {"ball", "cylindrical", "spherical",
                                                           "tapered"};
    const double cone =
        kind == 4 ? 0.5 * (number(out, "raceTaper1") + number(out, "raceTaper2")) : 0.0;
    Sets cage;
    propose_cage(kExamples.at(static_cast<std::size_t>(kind - 1)), envelope, number(out, "bReDia"),
                 number(out, "bReLen"), cone, cage);
    for (auto& set : cage.take()) out.sets.push_back(std::move(set));
    out.reasons += "; cage (record 7.1) scaled from the example of this type";
  }
  std::erase_if(out.sets, [&](const auto& set) { return !deck.has(set.first); });
  if (deck.units() == UnitSystem::SI) return out;
  for (auto& [name, value] : out.sets) {
    const VariableRef ref = find_present(deck, name);
    if (ref.spec().type == VarType::Real)
      value = fmt::format(
          "{}", convert_value(real(value), ref.spec().unit, UnitSystem::SI, UnitSystem::English));
  }
  return out;
}

}  // namespace adore::deck
