#include "listing/print_life.hpp"

#include "life/statistics.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

/// Page "FATIGUE LIFE" of PRINT.txt.
namespace adore::listing {
namespace {

using bearing::LifeModel;
using bearing::LifeModification;
using life::BearingLife;
using life::SourcedValue;

constexpr std::array<const char*, 4> kModelNames{"Original Lundberg-Palmgren",
                                                 "Updated Lundberg-Palmgren", "Gupta-Zaretsky type",
                                                 "Ioannides-Harris type"};
constexpr std::array<const char*, 3> kModificationNames{"", "STLE factors", "Tallian-type factors"};

std::string marked(const SourcedValue& m) {
  return fmt::format("{} ({})", Report::number(m.value), m.origin);
}

std::string with_unit(Report& report, double value, const UnitPair& unit) {
  return Report::number(from_si(value, unit, report.units()));
}

std::string model_origin(LifeModel model) {
  return model == LifeModel::Original ? life::constants().point_constant.origin : "calibrated";
}

std::string factor_origin(LifeModification modification) {
  return modification == LifeModification::Stle ? life::constants().stle_origin : "derived";
}

const char* shape_text(life::ContactShape shape, bool line) {
  if (shape == life::ContactShape::Between) return line ? "between (line)" : "between (point)";
  return shape == life::ContactShape::Line ? "line contact" : "point contact";
}

void lives(Report& report, const BearingLife& life) {
  const double S = life.parameters.survival.value;
  report.text(
      "Lives at the constant loads of the quasi-static solution. Part lives and bearing L10 are "
      "for 90 % survival, in 1e6 revolutions of one race relative to the other. Values in ( ) are "
      "not included in the bearing life.");
  report.blank();
  std::vector<std::vector<std::string>> rows;
  for (std::size_t m = 0; m < life::kModels; ++m)
    for (std::size_t f = 0; f < life::kModifications; ++f) {
      const life::PartLives& at = life.state.model[m].modified[f];
      std::string elements = std::isnan(at.part[2]) ? "-" : format_life_value(at.part[2]);
      if (!std::isnan(at.part[2]) && !at.elements_counted) elements = "(" + elements + ")";
      const double n = life.state.relative_speed;
      rows.push_back({f == 0 ? kModelNames[m] : std::string("  with ") + kModificationNames[f],
                      format_life_value(at.part[0]), format_life_value(at.part[1]), elements,
                      format_life_value(at.L10), format_life_value(life::life_hours(at.L10, n)),
                      format_life_value(life::life_hours(at.L_S, n)),
                      f == 0 ? model_origin(static_cast<LifeModel>(m))
                             : "+ " + factor_origin(static_cast<LifeModification>(f))});
    }
  report.text_table({{"model", 27},
                     {"outer race", 12},
                     {"inner race", 12},
                     {"elements", 14},
                     {"bearing L10", 12},
                     {"L10 [hr]", 12},
                     {fmt::format("{:.6g} % [hr]", 100.0 * S), 12},
                     {"origin", 12}},
                    rows);
  report.blank();
  const bearing::LifeChoices& choices = life.parameters.choices;
  report.item("Life model in SOL7, terminal and sweeps (sol7Life)",
              life_model_name(choices.stored_model, choices.stored_modification));
  report.item("Specified survival probability", marked(life.parameters.survival));
  report.item("Weibull slope of the bearing", marked(life.parameters.bearing_slope));
  report.text(
      "Column \"origin\": origin of the model constants; in rows with +, origin of the life "
      "factors. The constant of the original theory is published (\"seen\"). The constants of the "
      "three stress models are CALIBRATED: at one reference contact, all models give the life of "
      "the original theory. They are not the constants of the authors of the models. The STLE "
      "tables are not verified (uncertainty of the film curve: +-30 %). The asperity term of the "
      "Tallian-type factor was derived for this program.");
}

void races(Report& report, const BearingLife& life) {
  report.heading("Races: capacities and stresses at the most loaded contact");
  std::vector<std::vector<std::string>> rows;
  const auto row = [&](const char* name, const UnitPair& unit, auto value) {
    rows.push_back({name, with_unit(report, value(life.race[0]), unit),
                    with_unit(report, value(life.race[1]), unit),
                    &unit == &unit::kPure ? "" : std::string(unit_name(unit, report.units()))});
  };
  using Race = life::RaceReport;
  rows.push_back({"rotates relative to the load", life.race[0].rotating ? "yes" : "no",
                  life.race[1].rotating ? "yes" : "no", ""});
  const bool rollers = life.effective_length > 0.0;
  if (rollers) {
    rows.push_back({"contact type (Harris, not verified)",
                    shape_text(life.state.shape[0], life.race[0].line),
                    shape_text(life.state.shape[1], life.race[1].line), ""});
    row("ellipse length 2a, most loaded roller", unit::kLength,
        [](const Race& r) { return r.major_axis; });
    row("effective length of a roller", unit::kLength,
        [&](const Race&) { return life.effective_length; });
  }
  row("contact angle (mean of loaded contacts)", unit::kAngle,
      [](const Race& r) { return r.angle; });
  row("D cos(angle) / pitch diameter", unit::kPure, [](const Race& r) { return r.gamma; });
  row("load capacity Qc, original theory", unit::kForce, [](const Race& r) { return r.Q_c; });
  row("equivalent contact load Qe", unit::kForce, [](const Race& r) { return r.Q_e; });
  row("largest contact load", unit::kForce, [](const Race& r) { return r.Q_max; });
  row("largest pressure", unit::kPressure, [](const Race& r) { return r.p_max; });
  row("largest orthogonal shear stress", unit::kPressure,
      [](const Race& r) { return r.peaks.shear_amplitude * r.p_max; });
  row("largest shear stress", unit::kPressure,
      [](const Race& r) { return r.peaks.max_shear * r.p_max; });
  row("largest von Mises stress", unit::kPressure,
      [](const Race& r) { return r.peaks.von_mises * r.p_max; });
  row("stress capacity pc, updated LP", unit::kPressure,
      [](const Race& r) { return r.stress_capacity[0]; });
  row("stress capacity pc, Gupta-Zaretsky", unit::kPressure,
      [](const Race& r) { return r.stress_capacity[1]; });
  row("stress capacity pc, Ioannides-Harris", unit::kPressure,
      [](const Race& r) { return r.stress_capacity[2]; });
  report.text_table({{"", 40}, {"outer race", 16}, {"inner race", 16}, {"", 10}}, rows);
}

void parameters(Report& report, const BearingLife& life) {
  report.heading("Constants of the life models (life ~ pressure^-n without a fatigue limit)");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t i = 0; i < 3; ++i) {
      const life::PartParameters& part = life.parameters.part[i];
      const life::ModelParameters& p = part.model[m];
      const bool zaretsky = m == 1;
      const double hazard = p.stress_exponent.value * (zaretsky ? part.slope.value : 1.0);
      rows.push_back({i == 0 ? kModelNames[m + 1] : "", part.name, marked(p.factor),
                      marked(p.stress_exponent), Report::number(hazard),
                      zaretsky ? "-" : marked(p.depth_exponent),
                      fmt::format("{:.5g}", life.pressure_exponent[m][i])});
    }
  report.text_table({{"model", 26},
                     {"part", 17},
                     {"multiplier", 13},
                     {"stress exponent", 21},
                     {"hazard exp", 10},
                     {"depth exponent", 21},
                     {"n", 8}},
                    rows);
  report.text(
      "The stress exponent of the Gupta-Zaretsky type refers to life. Its hazard exponent is the "
      "stress exponent times the Weibull slope.");
  report.blank();
  rows.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    const life::PartParameters& part = life.parameters.part[i];
    rows.push_back({part.name, marked(part.slope), i < 2 ? marked(part.original_factor) : "-",
                    with_unit(report, part.fatigue_limit.value, unit::kPressure),
                    part.fatigue_limit.origin,
                    i < 2 ? with_unit(report, part.residual_stress, unit::kPressure) : "-"});
  }
  const std::string pressure(unit_name(unit::kPressure, report.units()));
  report.text_table({{"part", 17},
                     {"Weibull slope", 20},
                     {"original multiplier", 20},
                     {fmt::format("limit [{}]", pressure), 18},
                     {"origin", 12},
                     {fmt::format("residual stress [{}]", pressure), 26}},
                    rows);
  report.text(fmt::format(
      "Fatigue limit: von Mises limit stress of the material times facStrLimit = {}. The fatigue "
      "limit of ISO 281 corresponds to about {} {} (from a public source). Residual stress is "
      "positive in tension (interpretation of this program).",
      Report::number(life.parameters.limit_factor),
      with_unit(report, life::constants().iso_equivalent_limit.value, unit::kPressure), pressure));
  report.item(
      "Form of the Ioannides-Harris model",
      life.parameters.choices.limit_form == bearing::LimitForm::Peak
          ? "largest von Mises stress minus the fatigue limit"
          : "depth integral of the orthogonal shear stress above the fatigue limit (line contact)");
}

/// At which temperature the lives know each property.
void properties(Report& report, const BearingLife& life) {
  if (!(life.parameters.part[0].temperature > 0.0)) return;
  const bool follows = life.parameters.modulus_follows_temperature;
  report.heading("Material properties used for the lives");
  std::vector<Report::Row> rows;
  for (const life::PartParameters& part : life.parameters.part)
    rows.push_back({part.name, {part.temperature, part.elastic_modulus, part.poisson_ratio}});
  report.table("",
               {{"temperature", &unit::kTemperature},
                {"modulus", &unit::kPressure},
                {"Poisson", &unit::kPure}},
               rows, 18);
  report.text(follows ? "Moduli, pressures and ellipses are those at the temperature of each part "
                        "(kMatPropMod = 1). Outside the temperature range of a material law, its "
                        "value at the nearest end of the range applies."
                      : "The moduli are those at room temperature, because kMatPropMod is not 1.");
  report.text(
      "Poisson's ratio, fatigue limit and life factors are those at room temperature, because the "
      "material table has no temperature law for them. The hardness factor of the deck applies at "
      "operating temperature (default 1).");
}

void factors(Report& report, const BearingLife& life) {
  const life::ModificationFactors& f = life.state.factors;
  report.heading("STLE life factors");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const life::PartParameters& part = life.parameters.part[i];
    rows.push_back({part.name, marked(part.stle_material), marked(part.stle_process),
                    marked(part.stle_hardness), Report::number(f.film[i]), Report::number(f.filter),
                    Report::number(f.residual[i]), Report::number(f.stle[i])});
  }
  report.text_table({{"part", 17},
                     {"material", 16},
                     {"process", 16},
                     {"hardness", 13},
                     {"film", 9},
                     {"filter", 9},
                     {"residual", 10},
                     {"life factor", 12}},
                    rows);
  report.heading("Tallian-type factors: hazard multipliers and life factor of the original theory");
  rows.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    const life::PartParameters& part = life.parameters.part[i];
    rows.push_back({part.name, marked(part.tallian_material), marked(part.tallian_process),
                    marked(part.tallian_contamination), Report::number(f.asperity[i]),
                    Report::number(f.hazard[i]), Report::number(f.tallian[i])});
  }
  report.text_table({{"part", 17},
                     {"material", 17},
                     {"process", 17},
                     {"contamination", 17},
                     {"asperity", 12},
                     {"hazard", 12},
                     {"life factor", 12}},
                    rows);
  for (std::size_t i = 0; i < 2; ++i) {
    const life::PartParameters& part = life.parameters.part[i];
    report.text(fmt::format("Asperities, {}: rms slope {} rad, traction coefficient {}.", part.name,
                            marked(part.asperity_slope), marked(part.asperity_traction)));
  }
}

void iso(Report& report, const life::IsoReport& r) {
  report.heading(
      "Additional results of ISO 281 and ISO 16281 (from public implementations; separate from the "
      "lives above)");
  const auto optional_life = [&](const char* name, const std::optional<double>& life) {
    report.item(name, life ? format_life_value(*life) + " Mrev" : std::string("not available"));
  };
  const auto optional_force = [&](const char* name, const std::optional<double>& force) {
    if (force)
      report.item(name, *force, unit::kForce);
    else
      report.item(name, "not available");
  };
  report.item("Rating angle", r.geometry.contact_angle, unit::kAngle);
  report.item("Rating factor bm (not verified)", r.geometry.rating_factor, unit::kPure);
  report.item(r.maker.C ? "Dynamic load rating C (maker's)"
                        : "Dynamic load rating C (formula from a public source)",
              r.C, unit::kForce);
  if (r.maker.C) report.item("    estimate of ISO 281", r.C_estimate, unit::kForce);
  const bool roller = r.geometry.type == life::IsoType::RadialRoller ||
                      r.geometry.type == life::IsoType::ThrustRoller;
  optional_force(r.maker.C0 ? "Static load rating C0 (maker's)"
                 : roller   ? "Static load rating C0 (formula from a public source)"
                            : "Static load rating C0 (factor f0 not verified)",
                 r.C0);
  if (r.maker.C0) optional_force("    estimate of ISO 76", r.C0_estimate);
  optional_force(r.maker.C_u ? "Fatigue load limit Cu (maker's)"
                 : roller    ? "Fatigue load limit Cu (as C0/8.2, from a public source)"
                             : "Fatigue load limit Cu (at 1500 MPa, from a public source)",
                 r.C_u);
  if (r.maker.C_u) optional_force("    estimate of ISO 281", r.C_u_estimate);
  report.item("Radial load", r.radial, unit::kForce);
  report.item("Axial load", r.axial, unit::kForce);
  if (r.equivalent) {
    report.item("Equivalent load P (some factors not verified)", r.equivalent->P, unit::kForce);
    const auto factor = [&](std::string name, double value, const std::optional<double>& maker) {
      report.item(name + (maker ? " (maker's)" : ""), value, unit::kPure);
    };
    factor("    X", r.equivalent->X, r.maker.X);
    factor("    Y", r.equivalent->Y, r.maker.Y);
    factor("    e", r.equivalent->e, r.maker.e);
  }
  optional_life("L10 (ISO 281; sources: see C and P)", r.L10);
  report.item("Factor a1 for the survival probability (not verified)", r.a1, unit::kPure);
  if (r.viscosity) {
    report.item("Oil (record X2)", r.oil);
    report.item("    temperature", r.oil_temperature, unit::kTemperature);
    report.item("    kinematic viscosity", fmt::format("{:.5g} mm2/s", 1e6 * *r.viscosity));
  }
  if (r.required_viscosity)
    report.item("    required viscosity nu1 (ISO 281, from a public source)",
                fmt::format("{:.5g} mm2/s", 1e6 * *r.required_viscosity));
  if (r.kappa)
    report.item(r.kappa_origin == "oil" ? "Viscosity ratio kappa (oil of record X2)"
                                        : "Viscosity ratio kappa (option)",
                *r.kappa, unit::kPure);
  if (r.contamination)
    report.item("Contamination factor eC (option)", *r.contamination, unit::kPure);
  if (r.a_iso) report.item("aISO (coefficients from a public source)", *r.a_iso, unit::kPure);
  if (r.outside)
    report.text("The viscosity ratio is below 0.1, which is outside the range of the standard.");
  optional_life("Lnm = a1 aISO L10 (sources: see a1, aISO and L10)", r.L_nm);
  if (r.reference) {
    report.item("Reference load Pref (ISO 16281)", r.reference->P_ref, unit::kForce);
    report.item("    race capacity Qci", r.reference->capacity_inner, unit::kForce);
    report.item("    race capacity Qce", r.reference->capacity_outer, unit::kForce);
  }
  optional_life("L10r (ISO 16281, formula from a public source)",
                r.reference ? std::optional(r.reference->L10r) : std::nullopt);
  optional_life("Lnmr = a1 aISO L10r (sources: see a1, aISO and L10r)", r.L_nmr);
}

}  // namespace

std::string format_life_value(double life) {
  return std::isinf(life) ? std::string("INFINITE") : Report::number(life);
}

std::string life_model_name(LifeModel model, LifeModification modification) {
  std::string out = kModelNames[static_cast<std::size_t>(model)];
  if (modification != LifeModification::None)
    out += std::string(" with ") + kModificationNames[static_cast<std::size_t>(modification)];
  return out;
}

std::string life_constants_origin(LifeModel model, LifeModification modification) {
  std::string out = model_origin(model);
  if (modification != LifeModification::None) out += ", " + factor_origin(modification);
  return out;
}

void print_life(Report& report, const BearingLife& life) {
  report.new_page("FATIGUE LIFE");
  lives(report, life);
  races(report, life);
  parameters(report, life);
  properties(report, life);
  factors(report, life);
  if (life.iso) iso(report, *life.iso);
  report.heading("Notes on life");
  for (const Finding& note : life.notes) report.text(note.message);
  if (life.iso)
    for (const Finding& note : life.iso->notes) report.text(note.message);
}

void print_run_life(Report& report, const RunLife& run) {
  report.heading("Fatigue life of the run (Palmgren-Miner sum over the evaluation window)");
  report.item("Model", life_model_name(run.model, run.modification));
  report.item("Origin of the constants", life_constants_origin(run.model, run.modification));
  report.item("Excluded at the start", run.skipped_turns * 2.0 * kPi, unit::kRevolution);
  report.item("Evaluation window", run.damage.seconds(), unit::kTime);
  report.item("Revolutions of one race relative to the other in the window",
              run.damage.revolutions() * 2.0 * kPi, unit::kRevolution);
  constexpr std::array<const char*, 3> kParts{"outer race", "inner race", "rolling elements"};
  for (std::size_t i = 0; i < kParts.size(); ++i)
    report.item(fmt::format("Damage in the window, {}", kParts[i]), run.damage.damage()[i],
                unit::kPure);
  if (!(run.damage.seconds() > 0.0)) {
    report.text("The evaluation window is empty, so the life of the run is not computed.");
    return;
  }
  report.item("Load samples (integration steps)", fmt::format("{}", run.steps));
  report.item("Number of evaluations of the full life model", fmt::format("{}", run.evaluations));
  report.item("Mean damage change between evaluations (at equal loads)", run.change, unit::kPure);
  report.item("Life at 90 % survival if the evaluation window repeats",
              format_life_value(run.damage.life_mega_revolutions(run.slopes)) + " Mrev");
  report.item("Life at 90 % survival if the evaluation window repeats",
              format_life_value(run.damage.life_hours(run.slopes)) + " hr");
  if (std::isnan(run.relative_error))
    report.text(
        fmt::format("Standard error: not computed. {} batches of {:.3g} revolutions are too few. "
                    "Extend the run.",
                    run.batches, run.revolutions_per_batch));
  else
    report.item(fmt::format("Relative standard error ({} batches of {:.3g} revolutions)",
                            run.batches, run.revolutions_per_batch),
                run.relative_error, unit::kPure);
}

}  // namespace adore::listing
