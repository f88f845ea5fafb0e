#include "deck/schema_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

/// Records 5G: geometry errors of rolling elements (5G.1) and races (5G.2).
namespace adore::deck {
namespace {

using range::kAny;
using range::kNotNegative;
using range::kTaper;
using unit::kAngle;
using unit::kLength;
using unit::kPure;
using unit::kRadian;
using unit::kWaves;

VariableSpec rms_length(std::string_view name, std::string_view what) {
  return real(name, kLength, kNotNegative,
              intern_string(fmt::format("Root-mean-square deviation of {}.", what)));
}

void add_random_errors(std::vector<RecordSpec>& out) {
  out.push_back(
      record("5G.1A", "Random ball imperfections", "kReGeoImp == 1 && kBrg == 1",
             {rms_length("reDiaVar", "the ball diameters. The random numbers have a fixed seed")}));
  out.push_back(record(
      "5G.1B", "Random roller imperfections, cylindrical and tapered",
      "kReGeoImp == 1 && kBrg in (2,4)",
      {rms_length("reDiaVar", "the roller diameters. The random numbers have a fixed seed"),
       rms_length("reCrnVar", "the crown radii"), rms_length("reLenVar", "the roller lengths"),
       rms_length("reCLVar", "the lengths of the central lands of the rollers"),
       real("reCLOffset", kLength, kNotNegative,
            "Root-mean-square axial offset of the central lands of the rollers.")}));
  out.push_back(record(
      "5G.1C", "Random roller imperfections, spherical types", "kReGeoImp == 1 && kBrg in (3,5)",
      {rms_length("reDiaVar", "the roller diameters. The random numbers have a fixed seed")}));
}

/// Four records of ten diameters, always all four (N33).
void add_listed_diameters(std::vector<RecordSpec>& out) {
  for (int block = 0; block < 4; ++block) {
    const int first = 10 * block + 1;
    RecordSpec spec =
        record(intern_string(fmt::format("5G.1D.{}", block + 1)),
               intern_string(
                   fmt::format("Listed diameter deviations, elements {} to {}", first, first + 9)),
               "kReGeoImp == 2", {});
    for (int element = first; element < first + 10; ++element)
      spec.variables.push_back(
          real(intern_string(fmt::format("reDiaVar{}", element)), kLength, kAny,
               intern_string(
                   fmt::format("Diameter of rolling element {} minus the nominal diameter; 0 if "
                               "there is no such element.",
                               element))));
    out.push_back(std::move(spec));
  }
}

struct RaceNames {
  int number;
  std::string_view name;
};

/// A wave over the circumference, a sin(w theta + phi): amplitude, waves per revolution, phase.
std::vector<VariableSpec> wave(std::string_view stem, int race, const UnitPair& unit,
                               std::string_view what, Range amplitude = kAny) {
  const auto name = [&](int i) { return intern_string(fmt::format("{}{}{}", stem, i, race)); };
  return {real(name(1), unit, amplitude,
               intern_string(fmt::format("Amplitude a of the {}, a sin(w theta + phi).", what))),
          real(name(2), kWaves, kNotNegative,
               intern_string(fmt::format("Number w of waves per revolution of the {}.", what))),
          real(name(3), kAngle, kAny, intern_string(fmt::format("Phase phi of the {}.", what)))};
}

std::vector<VariableSpec> roundness(bool elliptical, const RaceNames& race) {
  if (!elliptical)
    return wave("rndVar", race.number, kLength,
                intern_string(fmt::format("radius error of the {} race", race.name)));
  const auto name = [&](int i) { return intern_string(fmt::format("rndVar{}{}", i, race.number)); };
  return {real(name(1), kLength, kAny,
               intern_string(
                   fmt::format("Semi-major axis minus nominal radius of the {} race.", race.name))),
          real(name(2), kLength, kAny,
               intern_string(
                   fmt::format("Semi-minor axis minus nominal radius of the {} race.", race.name))),
          real(name(3), kAngle, kAny,
               "Angle of the major axis of the elliptical race, measured from the race-fixed z "
               "axis and positive about x.")};
}

void append(std::vector<VariableSpec>& to, std::vector<VariableSpec> more) {
  for (VariableSpec& variable : more) to.push_back(std::move(variable));
}

/// Variants A, B for curved grooves (kBrg 1, 3, 5) and C, D for straight lands (kBrg 2, 4); A and C
/// elliptical, B and D sinusoidal.
void add_race_errors(std::vector<RecordSpec>& out, const RaceNames& race, std::string_view title) {
  for (const bool groove : {true, false})
    for (const bool elliptical : {true, false}) {
      const char variant = static_cast<char>('A' + (groove ? 0 : 2) + (elliptical ? 0 : 1));
      std::vector<VariableSpec> variables = roundness(elliptical, race);
      if (groove) {
        append(variables, wave("cFacVar", race.number, kPure,
                               intern_string(fmt::format(
                                   "error of the curvature factor of the {} race", race.name))));
      } else {
        append(
            variables,
            wave("rlOffset", race.number, kLength,
                 intern_string(fmt::format("axial offset of the land of the {} race", race.name))));
        append(variables,
               wave("rlTaper", race.number, kRadian,
                    intern_string(fmt::format("taper of the land of the {} race", race.name)),
                    kTaper));
      }
      out.push_back(record(
          intern_string(fmt::format("5G.2.{}{}", race.number, variant)),
          intern_string(fmt::format("{} race imperfections, {}, {}", title,
                                    groove ? "ball and spherical types" : "cylindrical and tapered",
                                    elliptical ? "elliptical" : "sinusoidal")),
          intern_string(fmt::format("kRaceGeoImp{} == {} && kBrg in {}", race.number,
                                    elliptical ? 1 : 2, groove ? "(1,3,5)" : "(2,4)")),
          std::move(variables)));
    }
}

}  // namespace

void add_imperfection_records(std::vector<RecordSpec>& out) {
  add_random_errors(out);
  add_listed_diameters(out);
  add_race_errors(out, {1, "outer"}, "Outer");
  add_race_errors(out, {2, "inner"}, "Inner");
}

}  // namespace adore::deck
