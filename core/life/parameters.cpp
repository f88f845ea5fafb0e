#include "life/parameters.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <array>

namespace adore::life {
namespace {

using bearing::LifeComponentInput;
using bearing::LifeModelInput;
using bearing::Material;

constexpr int kDeckMaterial = 1;

/// The default material of races and rolling elements (code 0) is 52100.
int table_code(const Material& material) { return material.code == 0 ? 100 : material.code; }

constexpr std::array<const char*, 3> kPartNames{"outer race", "inner race", "rolling elements"};

SourcedValue given_or(const std::optional<double>& value, const SourcedValue& otherwise) {
  return value ? SourcedValue{*value, "deck"} : otherwise;
}

ModelParameters model_parameters(const LifeModelInput& input, const SourcedValue& stress,
                                 const SourcedValue& depth) {
  ModelParameters out;
  out.factor = given_or(input.factor, {1.0, "default"});
  // No model has a stress exponent of 0: it selects the built-in one. A depth exponent of 0 has
  // a meaning, so it selects the built-in one only together with it.
  const bool blank = !input.stress_exponent || *input.stress_exponent == 0.0;
  out.stress_exponent = blank ? stress : SourcedValue{*input.stress_exponent, "deck"};
  const bool own_depth = input.depth_exponent && (!blank || *input.depth_exponent != 0.0);
  out.depth_exponent = own_depth ? SourcedValue{*input.depth_exponent, "deck"} : depth;
  return out;
}

/// A modification factor of zero is a record left blank too.
SourcedValue factor_or(const std::optional<double>& value, const SourcedValue& otherwise) {
  return value && *value > 0.0 ? SourcedValue{*value, "deck"} : otherwise;
}

void set_factors(PartParameters& out, const LifeComponentInput& input, const Material& material,
                 std::vector<Finding>& notes) {
  const LifeConstants& c = constants();
  const bool own = material.code == kDeckMaterial;
  const auto stle = c.stle_by_code.find(table_code(material));
  const auto tallian = c.tallian_by_code.find(table_code(material));
  const SourcedValue none{1.0, own ? "blank" : "none known"};
  const bool has_stle = !own && stle != c.stle_by_code.end();
  out.stle_material = factor_or(input.stle_material,
                                has_stle ? SourcedValue{stle->second.first, c.stle_origin} : none);
  out.stle_process = factor_or(input.stle_process,
                               has_stle ? SourcedValue{stle->second.second, c.stle_origin} : none);
  out.stle_hardness = factor_or(input.stle_hardness, {1.0, "default"});
  const bool has_tallian = !own && tallian != c.tallian_by_code.end();
  const LifeConstants::TallianDefaults values =
      has_tallian ? tallian->second : LifeConstants::TallianDefaults{};
  const std::string origin = has_tallian ? "manual" : none.origin;
  out.tallian_material = factor_or(input.tallian_material, {values.material, origin});
  out.tallian_process = factor_or(input.tallian_process, {values.process, origin});
  out.tallian_contamination =
      factor_or(input.tallian_contamination, {values.contamination, origin});
  out.asperity_slope = given_or(input.asperity_slope, {c.asperity_slope, "derived"});
  out.asperity_traction = given_or(input.asperity_traction, {c.asperity_traction, "derived"});
  out.residual_stress = input.residual_stress;
  if (!own && !has_stle)
    notes.push_back(
        make_finding("life.stle", fmt::format("{}: no STLE factors are known for {}; "
                                              "material and process factors are set to 1",
                                              out.name, material.name))
            .of(out.name));
  if (!own && !has_tallian)
    notes.push_back(
        make_finding(
            "life.tallian",
            fmt::format("{}: no Tallian factors are known for {}; the factors are set to 1",
                        out.name, material.name))
            .of(out.name));
}

void set_limit(PartParameters& out, const Material& material, double limit_factor,
               std::vector<Finding>& notes) {
  if (material.code == kDeckMaterial)
    out.fatigue_limit = {material.fatigue_limit_stress, "deck"};
  else if (const auto known = fatigue_limit_of_code(table_code(material)))
    out.fatigue_limit = *known;
  else
    out.fatigue_limit = {0.0, "none known"};
  out.fatigue_limit.value *= limit_factor;
  if (out.fatigue_limit.value == 0.0)
    notes.push_back(
        make_finding("life.fatigue_limit",
                     fmt::format("{}: no fatigue limit is known for {}. The limit is set to 0, so "
                                 "no life is infinite. The Ioannides-Harris lives are far too "
                                 "short, because the model was calibrated with a limit of 684 MPa",
                                 out.name, material.name))
            .of(out.name));
}

}  // namespace

LifeParameters life_parameters(const bearing::LifeInputs& inputs, bool line,
                               const Material& element, const std::array<Material, 2>& race) {
  const LifeConstants& c = constants();
  LifeParameters out;
  out.line = line;
  out.choices = inputs.choices;
  out.limit_factor = inputs.limit_factor;
  const SourcedValue slope = line ? c.line_slope : c.point_slope;
  out.survival = given_or(inputs.survival, {0.9, "default"});
  out.bearing_slope = given_or(inputs.bearing_slope, slope);
  out.point_bearing_slope = given_or(inputs.bearing_slope, c.point_slope);
  if (!(out.survival.value > 0.0 && out.survival.value < 1.0))
    throw InputError(fmt::format(
        "record 8.6.0: the survival probability sProb is {}; it must be between 0 and 1, e.g. 0.9",
        out.survival.value));
  for (std::size_t i = 0; i < 3; ++i) {
    const LifeComponentInput& input = inputs.part[i];
    const Material& material = i == bearing::kElementPart ? element : race[i];
    PartParameters& part = out.part[i];
    part.name = kPartNames[i];
    part.material = material.name;
    part.poisson_ratio = material.poisson_ratio;
    part.elastic_modulus = material.elastic_modulus;
    part.slope = given_or(input.weibull_slope, slope);
    part.point_slope = given_or(input.weibull_slope, c.point_slope);
    part.original_factor = given_or(input.original_factor, {1.0, "default"});
    if (!(part.original_factor.value > 0.0))
      throw InputError(fmt::format(
          "fatigue life of the {}: the multiplier of the original Lundberg-Palmgren constant is "
          "{}; it must be above 0",
          part.name, part.original_factor.value));
    part.model[0] = model_parameters(input.updated, c.stress_exponent, c.depth_exponent);
    part.model[1] =
        model_parameters(input.zaretsky, c.zaretsky_exponent, {0.0, "part of the model"});
    part.model[2] = model_parameters(input.harris, c.stress_exponent, c.depth_exponent);
    set_limit(part, material, inputs.limit_factor, out.notes);
    if (inputs.race_limit && i != bearing::kElementPart)
      part.fatigue_limit = {*inputs.race_limit * inputs.limit_factor, "maker"};
    set_factors(part, input, material, out.notes);
    // Elastic constants are hidden in the constant of the original theory.
    constexpr double kMinSteelModulus = 185e9, kMaxSteelModulus = 225e9;  // [Pa]
    if (i != bearing::kElementPart && !(material.elastic_modulus > kMinSteelModulus &&
                                        material.elastic_modulus < kMaxSteelModulus))
      out.notes.push_back(
          make_finding("life.not_steel",
                       fmt::format("{}: the elastic modulus is {:.4g} GPa, but the original "
                                   "Lundberg-Palmgren life is valid for steel only. The three "
                                   "stress-based life models account for the modulus",
                                   part.name, 1e-9 * material.elastic_modulus))
              .of(part.name)
              .measure(1e-9 * material.elastic_modulus, 1e-9 * kMaxSteelModulus)
              .at_least(1e-9 * kMinSteelModulus));
  }
  constexpr double kCeramicModulus = 250e9;
  out.ceramic_elements =
      element.code == 150 || element.code == 151 ||
      (element.code == kDeckMaterial && element.elastic_modulus > kCeramicModulus);
  if (out.ceramic_elements && out.choices.elements == bearing::ElementLife::Zaretsky)
    out.notes.push_back(
        make_finding("life.ceramic",
                     "the life models for steel are not valid for ceramic rolling elements, so the "
                     "bearing life does not include the lives of the rolling elements. To include "
                     "them, set the run option lifeElements=all"));
  return out;
}

bool includes_element_life(const LifeParameters& parameters, bearing::LifeModel model) {
  using bearing::ElementLife;
  if (model == bearing::LifeModel::Original) return false;
  switch (parameters.choices.elements) {
    case ElementLife::All:
      return true;
    case ElementLife::None:
      return false;
    case ElementLife::Zaretsky:
      break;
  }
  return model == bearing::LifeModel::Zaretsky && !parameters.ceramic_elements;
}

}  // namespace adore::life
