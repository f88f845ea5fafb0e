#include "deck/schema_parts.hpp"

/// Records X: facts of makers and shortcuts that a data deck has no record for. They are in
/// ADORE.json next to the deck. A value that is not given is "not given": no default takes its
/// place. All of them apply to any deck.
namespace adore::deck {
namespace {

using range::between;
using range::kAny;
using range::kNotNegative;
using range::kPositive;
using unit::kPure;

RecordSpec ratings() {
  return record(
      "X1", "Ratings of the maker", "true",
      {real("ratingC", unit::kForce, kPositive,
            "Dynamic load rating C that the maker publishes. It replaces the ISO 281 estimate."),
       real("ratingC0", unit::kForce, kPositive,
            "Static load rating C0 that the maker publishes. It replaces the ISO 76 estimate."),
       real("ratingCu", unit::kForce, kPositive,
            "Fatigue load limit Cu (Pu) that the maker publishes. It replaces the ISO 281 "
            "estimate."),
       real("ratingE", kPure, kNotNegative,
            "Limit e of the ratio of axial to radial load. Above this ratio, the load factors X "
            "and Y apply."),
       real("ratingX", kPure, kNotNegative,
            "Radial load factor X for axial loads above e times the radial load."),
       real("ratingY", kPure, kNotNegative,
            "Axial load factor Y for axial loads above e times the radial load."),
       real("ratingVM", unit::kStress, kPositive,
            "Von Mises fatigue limit stress of both races. It replaces the limit of the material "
            "in the stress-life models.")});
}

const UnitPair kKinematic{"mm^2/s", "mm^2/s", 1e-6, 1e-6};

RecordSpec oil() {
  return record(
      "X2", "Oil by grade", "true",
      {text("oilName", 36, "Name of the oil; for documentation only."),
       choice("kOilBase",
              {{"1", "mineral oil"}, {"2", "polyalphaolefin"}, {"3", "ester"}, {"4", "polyglycol"}},
              "Base oil. It is used to estimate the oil properties that are not given. If not "
              "given: mineral oil."),
       choice("kGrease", {{"0", "oil"}, {"1", "grease (all values are those of its base oil)"}},
              "Oil or grease."),
       integer("oilGrade", between(2.0, 3200.0),
               "ISO viscosity grade: the viscosity at 40 °C in mm^2/s."),
       real("oilVisc1", kKinematic, between(2.0, 1e6),
            "Kinematic viscosity at oilTemp1. Give either this value or oilGrade."),
       real("oilTemp1", unit::kTemperature, between(200.0, 500.0),
            "Temperature of oilVisc1. If not given: 40 °C."),
       real("oilVisc2", kKinematic, between(2.0, 1e6), "Kinematic viscosity at oilTemp2."),
       real("oilTemp2", unit::kTemperature, between(200.0, 500.0),
            "Temperature of oilVisc2. If not given: 100 °C."),
       real(
           "oilIndex", kPure, between(0.0, 400.0),
           "Viscosity index. It is used with oilGrade, or with oilVisc1 at 40 °C. Estimates if not "
           "given: 95 for mineral oil, 140 for polyalphaolefin and ester, 200 for polyglycol."),
       real("oilDen", unit::kDensity, between(500.0, 2500.0),
            "Density of the oil at 15 °C. If not given: estimated from the base oil."),
       real("oilPrCoeff", unit::kPerStress, between(1e-9, 1e-7),
            "Pressure-viscosity coefficient of the oil at 40 °C. If not given: estimated from "
            "viscosity and base oil."),
       real("oilTemp", unit::kTemperature, between(200.0, 500.0),
            "Bearing temperature for the viscosity ratio of ISO 281. If not given: mean of the "
            "race temperatures.")});
}

RecordSpec materials() {
  const auto of_parts = [](VariableSpec variable) { return array(std::move(variable), "3"); };
  return record(
      "X3", "Materials by single properties", "true",
      {of_parts(real(
           "matEM", unit::kStress, kPositive,
           "Elastic modulus of outer race, inner race and rolling elements. A single value applies "
           "to all three. A given value replaces the elastic modulus of the material.")),
       of_parts(real("matPR", kPure, range::kPoisson,
                     "Poisson ratio of outer race, inner race and rolling elements.")),
       of_parts(real("matDen", unit::kDensity, kPositive,
                     "Density of outer race, inner race and rolling elements.")),
       of_parts(real("matCTE", unit::kPerTemperature, kAny,
                     "Thermal expansion coefficient of outer race, inner race and rolling "
                     "elements."))});
}

RecordSpec start() {
  return record("X4", "Start position of the element set", "true",
                {real("startAngle", unit::kAngle, between(-360.0, 360.0),
                      "Azimuth of rolling element 1 at the start and in the quasi-static solution. "
                      "It is measured from the radial direction z and is positive about the "
                      "bearing axis x. If not given: 0.")});
}

}  // namespace

void add_extension_records(std::vector<RecordSpec>& out) {
  for (const auto& make : {ratings, oil, materials, start}) out.push_back(make());
}

}  // namespace adore::deck
