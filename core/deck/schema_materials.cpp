#include "deck/schema_parts.hpp"

#include <fmt/format.h>

/// Records 8: materials and the constants of the life models.
namespace adore::deck {
namespace {

using range::kAny;
using range::kNotNegative;
using range::kPositive;
using unit::kPure;
using unit::kRadian;

/// How much of the ten material properties a part needs.
enum class Extent : unsigned char { Conduction, Wear, Fatigue };

std::vector<VariableSpec> material_variables(std::string_view prefix, std::string_view suffix,
                                             std::string_view part, Extent extent) {
  const auto name = [&](std::string_view middle) {
    return intern_string(fmt::format("{}{}{}", prefix, middle, suffix));
  };
  const auto of = [&](std::string_view property, std::string_view more = "") {
    return intern_string(fmt::format("{} of the {}.{}", property, part, more));
  };
  std::vector<VariableSpec> variables = {
      real(name("Den"), unit::kDensity, kPositive, of("Density")),
      real(name("EM"), unit::kStress, kPositive, of("Elastic (Young's) modulus")),
      real(name("PR"), kPure, range::kPoisson, of("Poisson ratio", " About 0.3 for metals.")),
      real(name("CTE"), unit::kPerTemperature, kAny, of("Linear thermal expansion coefficient")),
      real(name("TC"), unit::kConductivity, kPositive, of("Thermal conductivity"))};
  if (extent == Extent::Conduction) return variables;
  variables.push_back(real(name("SH"), unit::kSpecificHeat, kPositive, of("Specific heat")));
  variables.push_back(
      real(name("ESL"), kPure, kNotNegative,
           of("Elastic strain limit", " Strains above this limit are reported as plastic.")));
  variables.push_back(
      real(name("H"), unit::kRockwell, range::kRockwell,
           of("Rockwell C hardness",
              " The indentation pressure of the wear law is computed from this hardness.")));
  variables.push_back(
      real(name("WC"), kPure, kNotNegative,
           of("Wear coefficient K",
              " The worn volume is K times load times sliding distance, divided by hardness.")));
  if (extent == Extent::Wear) return variables;
  variables.push_back(real(name("VM"), unit::kStress, kNotNegative,
                           of("Von Mises fatigue limit stress",
                              " Below this stress the Ioannides-Harris life is infinite.")));
  return variables;
}

/// Races have the original Lundberg-Palmgren multiplier too; elements do not.
std::vector<VariableSpec> life_constants(std::string_view suffix, std::string_view part,
                                         std::string_view slope_name) {
  const auto name = [&](std::string_view stem) {
    return intern_string(fmt::format("{}{}", stem, suffix));
  };
  const auto multiplier = [&](std::string_view stem, std::string_view model) {
    return real(name(stem), kPure, kNotNegative,
                intern_string(fmt::format(
                    "Multiplier on the constant of the {} model, {}. 1 keeps the built-in value.",
                    model, part)),
                "1.0");
  };
  const auto exponent = [&](std::string_view stem, std::string_view what, std::string_view model) {
    return real(name(stem), kPure, kNotNegative,
                intern_string(fmt::format(
                    "{} exponent of the {} model, {}.{}", what, model, part,
                    what == "Depth"
                        ? " 0 selects the built-in value if the shear stress exponent is also 0."
                        : " 0 selects the built-in value.")));
  };
  constexpr std::string_view kLp = "updated Lundberg-Palmgren";
  constexpr std::string_view kGz = "Gupta-Zaretsky";
  constexpr std::string_view kIh = "updated Ioannides-Harris";
  std::vector<VariableSpec> variables;
  if (suffix != "re") variables.push_back(multiplier("fco", "original Lundberg-Palmgren"));
  variables.push_back(multiplier("fcLP", kLp));
  variables.push_back(exponent("shExLP", "Shear stress", kLp));
  variables.push_back(exponent("depExLP", "Depth", kLp));
  variables.push_back(multiplier("fcGZ", kGz));
  variables.push_back(exponent("shExGZ", "Shear stress", kGz));
  variables.push_back(multiplier("fcIH", kIh));
  variables.push_back(exponent("shExIH", "Shear stress", kIh));
  variables.push_back(exponent("depExIH", "Depth", kIh));
  variables.push_back(real(slope_name, kPure, kPositive,
                           intern_string(fmt::format("Weibull slope of the {}.", part))));
  return variables;
}

struct LifeFactorNames {
  std::string_view material, contamination, process, material_stle, process_stle, hardness_stle;
};

std::vector<VariableSpec> life_factors(const LifeFactorNames& names, std::string_view part) {
  const auto factor = [&](std::string_view name, std::string_view what, std::string_view more,
                          std::string_view value = {}) {
    return real(name, kPure, kNotNegative,
                intern_string(fmt::format("{}, {}.{}", what, part, more)), value);
  };
  return {factor(names.material, "Tallian material factor",
                 " 1.197 for 52100, 1.773 for 8620, 2.267 for M50."),
          factor(names.contamination, "Tallian contamination factor",
                 " The standard value is 1. For VIMVAR steel in aerospace use, it is about 0.25 "
                 "and can be as low as 0.10.",
                 "1.0"),
          factor(names.process, "Tallian process factor",
                 " Published values: 2.58 for CVD steel before 1975, 0.077 for CVD steel since "
                 "1975, 4.85 for carburizing CVD steel, 0.003 to 0.0050 for VIMVAR steel. These "
                 "values differ so much that they may be wrong. Check a value before you use it.",
                 "0.077"),
          factor(names.material_stle, "STLE material factor", " 1 does not change the life."),
          factor(names.process_stle, "STLE process factor", " 1 does not change the life."),
          factor(names.hardness_stle, "STLE hardness factor", " 1 does not change the life.")};
}

RecordSpec race_life_factors(std::string_view id, int race, std::string_view name) {
  const auto with_race = [&](std::string_view stem) {
    return intern_string(fmt::format("{}{}", stem, race));
  };
  const std::string_view part = intern_string(fmt::format("{} race", name));
  RecordSpec spec =
      record(id, intern_string(fmt::format("Life modification factors of the {} race", name)),
             intern_string(fmt::format("kRaceMat{} == 1", race)),
             {real(with_race("rmsAspSlope"), kRadian, kNotNegative,
                   intern_string(fmt::format("Composite rms asperity slope of the {} race contact, "
                                             "used in the Tallian life factors.",
                                             name))),
              real(with_race("aspTrac"), kPure, kNotNegative,
                   intern_string(fmt::format("Asperity traction coefficient of the {} race "
                                             "contact, used in the Tallian life factors.",
                                             name)))});
  const LifeFactorNames names{with_race("facMat"),    with_race("facCont"),
                              with_race("facProc"),   with_race("facMatLF"),
                              with_race("facProcLF"), with_race("hardnessLF")};
  for (VariableSpec& variable : life_factors(names, part))
    spec.variables.push_back(std::move(variable));
  return spec;
}

}  // namespace

void add_material_records(std::vector<RecordSpec>& out) {
  out.push_back(record("8.1", "Rolling element material", "kReMat == 1",
                       material_variables("re", "", "rolling elements", Extent::Fatigue)));
  out.push_back(record("8.2.1", "Outer race material", "kRaceMat1 == 1",
                       material_variables("race", "1", "outer race", Extent::Fatigue)));
  out.push_back(record("8.2.2", "Inner race material", "kRaceMat2 == 1",
                       material_variables("race", "2", "inner race", Extent::Fatigue)));
  out.push_back(record("8.3", "Shaft material", "kShftMat == 1",
                       material_variables("shft", "", "shaft", Extent::Conduction)));
  out.push_back(record("8.4", "Housing material", "kHsngMat == 1",
                       material_variables("hsng", "", "housing", Extent::Conduction)));
  out.push_back(record("8.5", "Cage material", "nCseg > 0 && kCageMat == 1",
                       material_variables("cage", "", "cage", Extent::Wear)));
  out.push_back(
      record("8.6.0", "Life: survival probability and dispersion", "kLifeCons == 1",
             {real("sProb", kPure, range::kProbability,
                   "Survival probability for which the life is computed; 0.9 gives L10."),
              real("brgWbDis", kPure, kPositive, "Weibull slope of the bearing as a whole.")}));
  out.push_back(record("8.6.1", "Life constants of the outer race", "kLifeCons == 1",
                       life_constants("1", "outer race", "wbDis1")));
  out.push_back(record("8.6.2", "Life constants of the inner race", "kLifeCons == 1",
                       life_constants("2", "inner race", "wbDis2")));
  out.push_back(record("8.6.3", "Life constants of the rolling elements", "kLifeCons == 1",
                       life_constants("re", "rolling elements", "wbDisRe")));
  out.push_back(race_life_factors("8.6.4", 1, "outer"));
  out.push_back(race_life_factors("8.6.5", 2, "inner"));
  out.push_back(record("8.6.6", "Life modification factors of the rolling elements", "kReMat == 1",
                       life_factors({"facMatRe", "facContRe", "facProcRe", "facMatLFre",
                                     "facProcLFre", "hardnessLFre"},
                                    "rolling elements")));
}

}  // namespace adore::deck
