#include "deck/schema_parts.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

/// Records 10: traction, lubricants, churning.
namespace adore::deck {
namespace {

using range::kAny;
using range::kNotNegative;
using range::kPositive;
using unit::kPerSpeed;
using unit::kPure;
using unit::kSpeed;

VariableSpec curve_form(std::string_view name, std::string_view pair, std::string_view more = "") {
  return choice(
      name,
      {{"-1", "coefficients A B C D given"},
       {"0", "two slopes"},
       {"1", "A B C D from four conditions"},
       {"2", "asymptote with initial slope"}},
      intern_string(fmt::format("Form of the hypothetical traction curve, {}.{}", pair, more)));
}

VariableSpec curve_source(std::string_view name, std::string_view pair,
                          std::string_view more = "") {
  return choice(
      name, {{"-1", "user routine ADRX7"}, {"0", "hypothetical curve"}},
      intern_string(fmt::format("Source of the traction coefficient, {}.{}", pair, more)));
}

RecordSpec traction_options() {
  return record(
      "10.0", "Traction model options", "true",
      {with_option_table(
           choice("kTrac", {}, "Traction model or lubricant between rolling elements and races."),
           "@lubricants"),
       curve_form(
           "kTracType", "element to race",
           " The curve is always needed: it applies where the film is thinner than reRaceFilm."),
       curve_source("kCPTrac", "element to cage"), curve_form("kCPTracType", "element to cage"),
       curve_source("kCRTrac", "cage to race"), curve_form("kCRTracType", "cage to race"),
       curve_source("kRFTrac", "roller to flange"), curve_form("kRFTracType", "roller to flange"),
       curve_source("kRRTrac", "element to element",
                    " It is used only if the bearing has no cage."),
       curve_form("kRRTracType", "element to element",
                  " It is used only if the bearing has no cage."),
       choice("iTherm", {{"0", "off"}, {"1", "on"}},
              "Simplified thermal correction of the visco-elastic model. It is used only if kTrac "
              "is 12.")});
}

/// The four forms A to D of one traction pair; k is the traction coefficient, u the slip speed.
void add_traction_curves(std::vector<RecordSpec>& out, std::string_view id, std::string_view stem,
                         std::string_view title, std::string_view pair, std::string_view condition,
                         std::string_view type_variable) {
  const auto name = [&](int i) { return intern_string(fmt::format("{}{}", stem, i)); };
  const auto add = [&](char variant, int code, std::string_view form,
                       std::vector<VariableSpec> variables) {
    const std::string type = fmt::format("{} == {}", type_variable, code);
    out.push_back(
        record(intern_string(fmt::format("{}{}", id, variant)),
               intern_string(fmt::format("{}, {}", title, form)),
               intern_string(condition.empty() ? type : fmt::format("{} && {}", condition, type)),
               std::move(variables)));
  };
  const auto help = [&](std::string_view text) {
    return intern_string(fmt::format("{}, {}.", text, pair));
  };
  const std::string_view at_rest = help("Traction coefficient at zero slip");

  add('A', -1, "coefficients",
      {real(name(1), kPure, kAny,
            help("Coefficient A of the traction coefficient (A + B u) exp(-C u) + D at slip speed "
                 "u")),
       real(name(2), kPerSpeed, kAny,
            help("Coefficient B of the traction coefficient (A + B u) exp(-C u) + D at slip speed "
                 "u")),
       real(name(3), kPerSpeed, kAny,
            help("Coefficient C of the traction coefficient (A + B u) exp(-C u) + D at slip speed "
                 "u")),
       real(name(4), kPure, kAny,
            help("Coefficient D (value at large slip) of the traction coefficient (A + B u) exp(-C "
                 "u) + D at slip speed u"))});
  add('B', 0, "two slopes",
      {real(name(1), kPure, kAny, at_rest),
       real(
           name(2), kPerSpeed, kAny,
           intern_string(fmt::format("Slope of the traction curve up to slip speed {}.", name(4)))),
       real(
           name(3), kPerSpeed, kAny,
           intern_string(fmt::format("Slope of the traction curve above slip speed {}.", name(4)))),
       real(name(4), kSpeed, kNotNegative,
            help("Slip speed at which the slope of the traction curve changes"))});
  add('C', 1, "four conditions",
      {real(name(1), kPure, kAny, at_rest),
       real(name(2), kPure, kAny, help("Largest traction coefficient")),
       real(name(3), kPure, kAny, help("Traction coefficient at infinite slip")),
       real(name(4), kSpeed, kPositive,
            help("Slip speed at which the traction coefficient is largest"))});
  add('D', 2, "asymptote",
      {real(name(1), kPure, kAny, at_rest),
       real(name(2), kPure, kAny,
            help("Traction coefficient that the traction curve approaches at infinite slip")),
       real(name(3), kPerSpeed, kAny, help("Slope of the traction curve at zero slip")),
       real(name(4), kPure, kAny, "Not used; set 0.", "0")});
}

void add_user_lubricant(std::vector<RecordSpec>& out) {
  out.push_back(
      record("10.4.0", "User lubricant name", "kTrac == 9",
             {text("lubName", 36,
                   "Name of the lubricant, at most 36 characters; for documentation only.")}));
  out.push_back(
      record("10.4.1", "User lubricant, low-pressure properties", "kTrac == 9",
             {real("refTemp", unit::kTemperature, kPositive,
                   "Reference temperature T0 (absolute) of the lubricant properties."),
              real("refVis", unit::kViscosity, kPositive,
                   "Viscosity of the lubricant at the reference temperature and low pressure."),
              real("prVisCoeff", unit::kPerStress, kNotNegative,
                   "Pressure-viscosity coefficient of the lubricant."),
              real("tempVisCoeff", unit::kTemperature, kNotNegative,
                   "Temperature coefficient b of the viscosity, in the law exp(b (1/T - 1/T0))."),
              real("lubTherCond", unit::kConductivity, kPositive,
                   "Thermal conductivity of the lubricant (a real number, not an integer)."),
              real("lubDen", unit::kDensity, kPositive,
                   "Density of the lubricant (a real number, not an integer)."),
              real("lubSpHeat", unit::kSpecificHeat, kPositive,
                   "Specific heat of the lubricant (a real number, not an integer).")}));
  out.push_back(record(
      "10.4.4", "User lubricant, high-pressure traction viscosity", "kTrac == 9",
      {real("refTracVis", unit::kViscosity, kPositive,
            "Reference viscosity of the lubricant for traction in the contact."),
       real("tracVisCoeff1", unit::kPerStress, kNotNegative,
            "Pressure coefficient a of the traction viscosity, in the law exp(a p + b (T0 - T))."),
       real("tracVisCoeff2", unit::kPerTemperature, kNotNegative,
            "Temperature coefficient b of the traction viscosity, in the law exp(a p + b (T0 - "
            "T)).")}));
}

}  // namespace

void add_lubrication_records(std::vector<RecordSpec>& out) {
  out.push_back(traction_options());
  add_traction_curves(out, "10.1", "reRaceTC", "Element to race traction", "element to race", "",
                      "kTracType");
  add_traction_curves(out, "10.2", "reFlngTC", "Roller to flange traction", "roller to flange",
                      kAnyFlange, "kRFTracType");
  out.push_back(record(
      "10.3", "Critical film and starvation", "kTrac > 0",
      {real("reRaceFilm", unit::kLength, kNotNegative,
            "Film thickness below which the hypothetical traction curve replaces the traction "
            "model of the lubricant."),
       real("strParam", kPure, kNotNegative,
            "Distance of the oil meniscus from the contact edge divided by the contact half width. "
            "The contact is flooded at 10 or more, and heavily starved at 1 or less.")}));
  add_user_lubricant(out);
  add_traction_curves(out, "10.5.1", "reCageTC", "Element to cage traction", "element to cage",
                      "nCseg > 0", "kCPTracType");
  add_traction_curves(out, "10.5.2", "cageRaceTC", "Cage to race traction", "cage to race",
                      "nCseg > 0 && max(iCageGuide) > 0", "kCRTracType");
  add_traction_curves(out, "10.5.3", "reReTC", "Element to element traction", "element to element",
                      "nCseg == 0", "kRRTracType");
  out.push_back(record("10.6", "Oil for cage hydrodynamics",
                       "kTrac <= 0 && nCseg > 0 && (kPocHydro != 0 || kGsHydro != 0)",
                       {real("pocVis", unit::kViscosity, kPositive,
                             "Effective viscosity of the oil in the cage pockets."),
                        real("gsVis", unit::kViscosity, kPositive,
                             "Effective viscosity of the oil at the guide lands of the cage.")}));
  out.push_back(
      record("10.7A", "Churning medium, given properties", "kChrn == 2",
             {real("chnDen", unit::kDensity, kPositive,
                   "Effective density of the oil-air mixture that causes churning drag."),
              real("chnVis", unit::kViscosity, kPositive,
                   "Effective viscosity of the oil-air mixture that causes churning drag.")}));
  out.push_back(
      record("10.7B", "Churning medium, density and viscosity ratios", "kChrn == 1 || kChrn > 2",
             {real("denRatio", kPure, kNotNegative,
                   "Effective density of the churning medium divided by the built-in value. It is "
                   "far below 1 for an oil mist."),
              real("visRatio", kPure, kNotNegative,
                   "Effective viscosity of the churning medium divided by the built-in value.")}));
}

}  // namespace adore::deck
