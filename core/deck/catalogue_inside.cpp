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

/// Shares of the section (OD - bore) from tests/candidates: 0.29 to 0.30 of the deep groove
/// bearings for rules, whose balls are in steps of 1/64 in; 0.3175 of the 3xxK sizes (309 to 318)
/// of the same list, which have no ratings: outside diameters above 2.05 bores + 8 mm (series 03).
ProposedInternalGeometry balls(BearingType type, const Envelope& e, double angle,
                               std::string_view group, const KnownInternalGeometry& known) {
  constexpr double kInch64 = 0.0254 / 64.0, kInch32 = 0.0254 / 32.0, kShoulder = 0.54;
  const bool deep = type == BearingType::DeepGroove;
  const double section = e.outside - e.bore;
  const bool heavy = deep && section > 0.8 * e.bore + 20.0 * kMm;
  const double share = !deep ? 0.30 : heavy ? 0.3175 : 0.297;
  const double pitch = known.pitch > 0.0 ? known.pitch : 0.5 * (e.bore + e.outside);
  const double ball = known.diameter > 0.0
                          ? known.diameter
                          : nearest(share * section, deep && !heavy ? kInch64 : kInch32);
  // A deep groove bearing is filled through the gap of rings laid against each other: its balls
  // cover 195 degrees then. A split cage leaves a tenth of the circle in the other type.
  constexpr double kFilled = 195.0 / 2.0;
  const long long count =
      known.count > 0 ? known.count
      : deep ? static_cast<long long>(std::floor(kFilled * kDegree / std::asin(ball / pitch))) + 1
             : elements_that_fit(ball, pitch, 0.9);
  Sets sets;
  sets.whole("nRe", count);
  sets.real("bReDia", ball);
  sets.length("pitchDia", pitch);
  sets.real("freeConAng", deep ? 0.0 : angle);
  sets.length("freeIntCls", deep ? clearance_group_mean(type, group, e.bore) : 0.0);
  const double outer = known.groove_outer > 0.0 ? known.groove_outer : deep ? 0.525 : 0.5232;
  const double inner = known.groove_inner > 0.0 ? known.groove_inner : deep ? 0.515 : 0.5232;
  sets.real("raceCurFac1", outer);
  sets.real("raceCurFac2", inner);
  sets.length("shoulderDia1", pitch + kShoulder * ball);
  sets.length("shoulderDia2", pitch - kShoulder * ball);
  const std::string rest =
      fmt::format("{} as in the {} example{}",
                  known.groove_outer > 0.0 ? "shoulders" : "groove factors and shoulders",
                  deep ? "6205" : "218", deep ? "; clearance: " + clearance_reason(group) : "");
  if (known.diameter > 0.0) return {sets.take(), known.source + "; " + rest};
  return {sets.take(),
          fmt::format("ball diameter D = {:.4g} (OD - bore), rounded to 1/{} in; {}; {}", share,
                      deep && !heavy ? 64 : 32,
                      deep ? "number of balls: the maximum for eccentric (Conrad) assembly"
                           : "the balls fill 90 % of the pitch circle",
                      rest)};
}

/// The proportions of today's bearings with enlarged rollers: rated by ISO 281 they come near the
/// C of NU205 (28.6 kN), NU209 (69.5 kN) and NU210 (73.5 kN) of makers [recalled high].
ProposedInternalGeometry cylinders(const Envelope& e, std::string_view group,
                                   const KnownInternalGeometry& known) {
  const double pitch = known.pitch > 0.0 ? known.pitch : 0.5 * (e.bore + e.outside);
  const double section = e.outside - e.bore;
  const bool light = section < 0.4 * e.bore + 12.5 * kMm;  // series 10
  const double share = light ? 0.25 : 0.275, width_share = light ? 0.54 : 0.62;
  const double roller = known.diameter > 0.0 ? known.diameter : nearest(share * section, 0.5 * kMm);
  const double length = known.length > 0.0
                            ? known.length
                            : std::min(1.2 * roller, nearest(width_share * e.width, 0.5 * kMm));
  Sets sets;
  sets.whole("nRe", known.count > 0 ? known.count : elements_that_fit(roller, pitch, 0.82));
  sets.length("bReDia", roller);
  sets.real("bReCrn", std::round(200.0 * length * 1e3) / 1e3);
  sets.length("bReLen", length);
  sets.length("bReCenLen", 0.6 * length);
  sets.length("bReCorRad1", 0.02 * roller);
  sets.length("bReCorRad2", 0.02 * roller);
  sets.length("pitchDia", pitch);
  sets.length("freeIntCls", clearance_group_mean(BearingType::Cylindrical, group, e.bore));
  sets.length("raceLandLmt1", length);
  sets.length("raceLandLmt2", 1.2 * length);
  sets.length("flngHt11", 0.2 * roller);
  sets.length("flngHt21", 0.2 * roller);
  return {sets.take(),
          (known.diameter > 0.0
               ? known.source
               : fmt::format("roller diameter D = {} (OD - bore); roller length L = {} times the "
                             "bearing width (at most 1.2 D); the rollers fill 82 % of the pitch "
                             "circle, as in current designs with large rollers",
                             share, width_share)) +
              "; typical crown and flanges; clearance: " + clearance_reason(group)};
}

ProposedInternalGeometry cones(const Envelope& e, double cup, const KnownInternalGeometry& known) {
  const double pitch = known.pitch > 0.0 ? known.pitch : 0.5 * (e.bore + e.outside);
  const double roller =
      known.diameter > 0.0 ? known.diameter : nearest(0.245 * (e.outside - e.bore), 0.1 * kMm);
  const double length = known.length > 0.0 ? known.length : nearest(0.75 * e.width, 0.5 * kMm);
  // Both cones share their apex: D / dm = sin h / sin m with m = cup - h, h half the taper.
  const double ratio = roller / pitch, alpha = cup * kDegree;
  const double half = std::atan2(ratio * std::sin(alpha), 1.0 + ratio * std::cos(alpha));
  const double to_apex = 0.5 * pitch / std::sin(alpha - half);
  Sets sets;
  sets.whole("nRe", known.count > 0 ? known.count : elements_that_fit(roller, pitch, 0.9));
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
  return {sets.take(), (known.diameter > 0.0
                            ? known.source
                            : "roller diameter D = 0.245 (OD - bore); roller length L = 0.75 times "
                              "the cone width; the rollers fill 90 % of the pitch circle") +
                           "; cone angle calculated from the cup angle; typical crown and rib"};
}

ProposedInternalGeometry barrels(const Envelope& e, double angle, std::string_view group,
                                 bool tapered_bore, const KnownInternalGeometry& known) {
  const double pitch = known.pitch > 0.0 ? known.pitch : 0.502 * (e.bore + e.outside);
  const double roller =
      known.diameter > 0.0 ? known.diameter : nearest(0.275 * (e.outside - e.bore), 0.1 * kMm);
  const double sphere =
      0.5 * pitch / std::cos(angle * kDegree) + 0.5 * roller;  // of the outer race
  Sets sets;
  sets.whole("nRe", known.count > 0 ? known.count : elements_that_fit(roller, pitch, 0.87));
  sets.length("bReDia", roller);
  sets.length("bReCrn", 0.961 * sphere);
  sets.length("bReLen", known.length > 0.0 ? known.length : nearest(0.413 * e.width, 0.1 * kMm));
  sets.length("bReCorRad1", 0.036 * roller);
  sets.length("bReCorRad2", 0.036 * roller);
  sets.length("pitchDia", pitch);
  sets.length("freeIntCls",
              clearance_group_mean(BearingType::Spherical, group, e.bore, tapered_bore));
  sets.real("raceCurFac1", 0.5133);
  sets.real("raceCurFac2", 0.5133);
  sets.real("freeConAng", std::round(angle * 100.0) / 100.0);
  return {sets.take(),
          (known.diameter > 0.0 ? known.source
                                : "roller diameter D = 0.275 (OD - bore); roller length L = 0.413 "
                                  "times the bearing width; the rollers fill 87 % of the pitch "
                                  "circle; contact angle from the distance of the rows") +
              "; clearance: " + clearance_reason(group) +
              (tapered_bore ? " for tapered bores" : "")};
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

ProposedInternalGeometry propose_internal_geometry(BearingType type, const Envelope& envelope,
                                                   double angle, std::string_view group,
                                                   bool tapered_bore,
                                                   const KnownInternalGeometry& known) {
  const double section = envelope.outside - envelope.bore;
  if (!(envelope.bore > 0.0 && section > 0.0 && envelope.width > 0.0))
    throw InputError(fmt::format(
        "no elements fit between bore {} m and outside diameter {} m at width {} m; the bore must "
        "be above 0 and below the outside diameter, and the width above 0",
        envelope.bore, envelope.outside, envelope.width));
  switch (type) {
    case BearingType::Cylindrical:
      return cylinders(envelope, group, known);
    case BearingType::Tapered:
      return cones(envelope, angle > 0.0 ? angle : default_contact_angle(type, envelope), known);
    case BearingType::Spherical:
      return barrels(envelope, angle > 0.0 ? angle : default_contact_angle(type, envelope), group,
                     tapered_bore, known);
    default:
      return balls(type, envelope, angle > 0.0 ? angle : default_contact_angle(type, envelope),
                   group, known);
  }
}

ProposedInternalGeometry propose_internal_geometry(const Deck& deck) {
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
  ProposedInternalGeometry out = propose_internal_geometry(type, envelope, angle);
  if (deck.integer("nCseg") == 1) {
    constexpr std::array<std::string_view, 4> kExamples = {"ball", "cylindrical", "spherical",
                                                           "tapered"};
    const double cone =
        kind == 4 ? 0.5 * (number(out, "raceTaper1") + number(out, "raceTaper2")) : 0.0;
    Sets cage;
    propose_cage(kExamples.at(static_cast<std::size_t>(kind - 1)), envelope, number(out, "bReDia"),
                 number(out, "bReLen"), cone, cage);
    for (auto& set : cage.take()) out.sets.push_back(std::move(set));
    out.reasons += "; cage (record 7.1) scaled from the example deck of this bearing type";
  }
  std::erase_if(out.sets, [&](const auto& set) { return !deck.has(set.first); });
  if (deck.units() == UnitSystem::SI) return out;
  for (auto& [name, value] : out.sets) {
    const VariableRef ref = find_present_variable(deck, name);
    if (ref.spec().type == VarType::Real)
      value = fmt::format(
          "{}", convert_value(real(value), ref.spec().unit, UnitSystem::SI, UnitSystem::English));
  }
  return out;
}

}  // namespace adore::deck
