#include "listing/static_summary.hpp"

#include "base/rotation.hpp"
#include "contact/groove.hpp"
#include "life/statistics.hpp"
#include "listing/print_life.hpp"
#include "listing/print_words.hpp"
#include "listing/rounding.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::listing {
namespace {

using bearing::Bearing;
using TextRow = std::vector<std::string>;

constexpr std::array<const char*, 5> kDirection{"x", "y", "z", "about y", "about z"};

const UnitPair& motion_unit(std::size_t k) { return k < 3 ? unit::kLength : unit::kAngle; }

void raise(ElementValue& most, double value, std::size_t index) {
  if (most.element == 0 ? std::isfinite(value) : value > most.value)
    most = {value, static_cast<int>(index) + 1};
}
void lower(ElementValue& least, double value, std::size_t index) {
  if (least.element == 0 ? std::isfinite(value) : value < least.value)
    least = {value, static_cast<int>(index) + 1};
}

double pitch_radius(const Bearing& bearing) { return 0.5 * bearing.pitch_diameter(); }

std::string short_number(double value) {
  return std::isnan(value) ? std::string("-") : fmt::format("{:.6g}", value + 0.0);
}

/// "4208.27 N"; "-" where there is none.
std::string quantity(double si, const UnitPair& unit, UnitSystem units) {
  if (std::isnan(si)) return "-";
  return fmt::format("{} {}", short_number(from_si(si, unit, units)), unit_name(unit, units));
}

/// "4208.27 N    ball 1"
std::string where(const ElementValue& at, const UnitPair& unit, const StaticSummary& s,
                  UnitSystem units) {
  if (at.element == 0) return "-";
  return fmt::format("{:<24}{} {}", quantity(at.value, unit, units), s.element, at.element);
}

std::string elastic_limit(const life::ContactStrength& s, UnitSystem units) {
  return s.elastic_limit > 0.0 ? quantity(s.elastic_limit, unit::kPressure, units) : "not known";
}

void inner_race(Report& report, const StaticSummary& s, const Bearing& bearing) {
  const UnitSystem units = report.units();
  const statics::RaceResult& r = s.result;
  const auto displacement = zero_rounding_noise(r.displacement, pitch_radius(bearing));
  const auto load = zero_rounding_noise(r.load, 1.0 / pitch_radius(bearing));
  std::vector<TextRow> rows;
  for (std::size_t k = 0; k < 5; ++k) {
    const bool given = bearing.constraints.displacement_given[k];
    const auto i = static_cast<Eigen::Index>(k);
    rows.push_back({kDirection[k], quantity(displacement[k], motion_unit(k), units),
                    given ? "given" : "found", quantity(load[k], load_unit(k), units),
                    given ? "found" : "given",
                    quantity(r.stiffness(i, i),
                             k < 3 ? unit::kStiffness : unit::kRotationalStiffness, units)});
  }
  report.text_table({{"inner race", 18},
                     {"displacement", 22},
                     {"", 6},
                     {"load from the shaft", 28},
                     {"", 6},
                     {"stiffness in this direction", 30}},
                    rows);
  const auto& outer = bearing.constraints.outer_misalignment;
  if (outer[0] != 0.0 || outer[1] != 0.0) {
    const auto tilt = relative_tilt({r.displacement[3], r.displacement[4]}, outer);
    report.text(fmt::format(
        "Tilts are in the base frame. Tilt of the outer race: {} about y, {} about z. Tilt of the "
        "inner race relative to the outer race: {} about y, {} about z.",
        quantity(outer[0], unit::kAngle, units), quantity(outer[1], unit::kAngle, units),
        quantity(tilt[0], unit::kAngle, units), quantity(tilt[1], unit::kAngle, units)));
  }
  report.text(displacement_datum_text(bearing, units));
}

void contacts(Report& report, const StaticSummary& s) {
  const UnitSystem units = report.units();
  std::vector<TextRow> rows;
  const auto row = [&](std::string name, const UnitPair& unit, ElementValue RaceSummary::*member) {
    if ((s.race[0].*member).element == 0 && (s.race[1].*member).element == 0) return;
    rows.push_back({std::move(name), where(s.race[0].*member, unit, s, units),
                    where(s.race[1].*member, unit, s, units)});
  };
  row("largest contact load", unit::kForce, &RaceSummary::load);
  row("largest pressure", unit::kPressure, &RaceSummary::pressure);
  const auto strength = [&](std::string name, std::size_t body) {
    TextRow cells{std::move(name)};
    for (std::size_t race = 0; race < 2; ++race) {
      const life::ContactStrength& at = s.strength[race][body];
      cells.push_back(at.element == 0 ? std::string("-")
                                      : fmt::format("{:<24}limit {}",
                                                    quantity(at.von_mises, unit::kPressure, units),
                                                    elastic_limit(at, units)));
    }
    rows.push_back(std::move(cells));
  };
  strength("subsurface von Mises, race", 0);
  strength(fmt::format("subsurface von Mises, {}", s.element), 1);
  row("smallest contact angle", unit::kAngle, &RaceSummary::least_angle);
  row("largest contact angle", unit::kAngle, &RaceSummary::most_angle);
  row("least depth below shoulder", unit::kLength, &RaceSummary::shoulder);
  row("largest flange load", unit::kForce, &RaceSummary::flange);
  const auto counts = [&](std::string name, int RaceSummary::*member) {
    rows.push_back({std::move(name), fmt::format("{} of {}", s.race[0].*member, s.count),
                    fmt::format("{} of {}", s.race[1].*member, s.count)});
  };
  counts(fmt::format("loaded {}s", s.element), &RaceSummary::loaded);
  if (s.element == "roller") counts("at a corner or land edge", &RaceSummary::at_edge);
  report.text_table({{"contacts", 28}, {kRaceTitle[0], 46}, {kRaceTitle[1], 46}}, rows);
}

void geometry(Report& report, const bearing::OperatingFits& fits) {
  const UnitSystem units = report.units();
  const auto cell = [&](double si, const UnitPair& unit) { return quantity(si, unit, units); };
  std::vector<TextRow> rows;
  const auto row = [&](const char* name, const UnitPair& unit,
                       double bearing::ClearanceState::*member) {
    rows.push_back({name, cell(fits.free.*member, unit), cell(fits.mounted.*member, unit),
                    cell(fits.operating.*member, unit)});
  };
  const bool cones = fits.axial_setting.has_value();
  row(cones ? "change of diametral clearance" : "diametral clearance", unit::kLength,
      &bearing::ClearanceState::clearance);
  if (fits.locus[0] > 0.0) {
    row("free contact angle", unit::kAngle, &bearing::ClearanceState::contact_angle);
    row("free end play", unit::kLength, &bearing::ClearanceState::end_play);
  }
  for (const bearing::CageClearance& play : fits.plays)
    rows.push_back({"cage: " + play.name, cell(play.free, unit::kLength), "",
                    cell(play.operating, unit::kLength)});
  report.text_table({{"operating geometry", 42}, {"cold", 22}, {"mounted", 22}, {"operating", 22}},
                    rows);
  if (cones)
    report.text("Change of the axial setting (positive: less clearance): " +
                cell(*fits.axial_setting, unit::kLength));
  report.blank();
  rows.clear();
  for (std::size_t j = 0; j < 2; ++j) {
    const bearing::FitState& fit = fits.fit[j];
    rows.push_back(
        {j == 0 ? "outer race in housing" : "inner race on shaft",
         cell(fit.interference, unit::kLength), cell(fit.pressure, unit::kPressure),
         cell(fit.race_hoop, unit::kPressure),
         fit.race_limit > 0.0 ? cell(fit.race_limit, unit::kPressure) : std::string("not known")});
  }
  report.text_table({{"fit in operation (negative: loose)", 34},
                     {"interference", 20},
                     {"pressure", 20},
                     {"hoop stress of race", 22},
                     {"elastic limit", 20}},
                    rows);
}

/// Origin of a model's constants: the original theory's is published, those of the three
/// stress models are calibrated on it; the deck may give its own multipliers.
std::string origin(const life::BearingLife& life, std::size_t model) {
  bool own = false, built_in = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const life::PartParameters& part = life.parameters.part[i];
    const life::SourcedValue& factor =
        model == 0 ? part.original_factor : part.model[model - 1].factor;
    (factor.origin == "deck" ? own : built_in) = true;
  }
  const std::string ours = model == 0 ? "seen" : "calibrated";
  return own ? (built_in ? "deck, " + ours : "deck") : ours;
}

std::string hours_text(double life, double speed) {
  const double hours = life::life_hours(life, speed);
  return std::isinf(hours) ? "INFINITE" : short_number(hours);
}

std::string millions(double life) { return std::isinf(life) ? "INFINITE" : short_number(life); }

void lives(Report& report, const life::BearingLife& life) {
  std::vector<TextRow> rows;
  const double speed = life.state.relative_speed;
  for (std::size_t m = 0; m < life::kModels; ++m) {
    const life::PartLives& at = life.state.model[m].modified[0];
    const std::string elements = millions(at.part[2]);
    rows.push_back(
        {life_model_name(static_cast<bearing::LifeModel>(m), bearing::LifeModification::None),
         millions(at.part[0]), millions(at.part[1]),
         std::isnan(at.part[2]) || at.elements_counted ? elements : "(" + elements + ")",
         millions(at.L10), hours_text(at.L10, speed), hours_text(at.L_S, speed), origin(life, m)});
  }
  if (life.iso) {
    const auto iso = [&](const char* name, double L, const char* from) {
      rows.push_back({name, "", "", "", millions(L), hours_text(L, speed),
                      hours_text(life.iso->a1 * L, speed), from});
    };
    if (life.iso->L10)
      iso("ISO 281", *life.iso->L10, life.iso->maker.C ? "maker's C" : "recalled, seen");
    if (life.iso->reference)
      iso("ISO 16281", life.iso->reference->L10r,
          life.iso->maker.C ? "maker's C" : "recalled, seen");
  }
  report.text_table({{"lives, 90 % survival", 26},
                     {"outer [Mrev]", 12},
                     {"inner [Mrev]", 12},
                     {"elem. [Mrev]", 13},
                     {"bearing [Mrev]", 14},
                     {"bearing [hr]", 12},
                     {fmt::format("{:.4g} % [hr]", 100.0 * life.parameters.survival.value), 12},
                     {"constants", 14}},
                    rows);
}

void remarks(Report& report, const std::vector<std::string>& warnings,
             const std::vector<Finding>& notes) {
  report.text(fmt::format("Warnings: {}. Notes: {}.", warnings.size(), notes.size()));
  // Complete if there is room, cut to one line otherwise; the last line is kept free.
  const auto shown = [&](const std::string& text) {
    constexpr std::size_t kWidth = 112;
    const int lines = static_cast<int>(text.size() / kWidth) + 1;
    if (report.lines_left() < 2) return false;
    const bool whole = lines == 1 || lines < report.lines_left();
    report.text(whole ? text : text.substr(0, kWidth - 4) + " ...", 6);
    return true;
  };
  std::vector<std::string> all = warnings;
  for (const Finding& note : notes) all.push_back(note.message);
  for (const std::string& text : all)
    if (!shown(text)) return report.text("    More on the following pages.", 0);
}

/// "55.3 kN (maker's)"
std::string rating(const char* name, double si, bool maker, UnitSystem units) {
  return fmt::format("{} {} ({})", name, quantity(si, unit::kForce, units),
                     maker ? "maker's" : "estimated");
}

/// The lives by the standards and what they are of.
std::vector<std::string> iso_lines(const life::IsoReport& iso, double speed, UnitSystem units) {
  std::vector<std::string> out;
  const auto lived = [&](double L) {
    return speed > 0.0 && std::isfinite(L) ? hours_text(L, speed) + " hr" : millions(L) + " Mrev";
  };
  if (iso.L10 && iso.equivalent)
    out.push_back(fmt::format("life L10h by ISO 281: {} ({}, P {})", lived(*iso.L10),
                              rating("C", iso.C, iso.maker.C.has_value(), units),
                              quantity(iso.equivalent->P, unit::kForce, units)));
  if (iso.reference)
    out.push_back(fmt::format("life L10r by ISO/TS 16281: {} ({})", lived(iso.reference->L10r),
                              rating("C", iso.C, iso.maker.C.has_value(), units)));
  if (iso.L10 && iso.reference)
    out.push_back(
        "ISO 281 uses the loads on the bearing and the rating C. ISO/TS 16281 uses the computed "
        "load of every contact and the rating C. The Lundberg-Palmgren life uses the contact loads "
        "and the geometry, without C.");
  if (iso.viscosity && iso.required_viscosity)
    out.push_back(fmt::format(
        "oil: {}; viscosity {:.4g} mm²/s at {}, required {:.4g} mm²/s, kappa {:.4g}", iso.oil,
        1e6 * *iso.viscosity, quantity(iso.oil_temperature, unit::kTemperature, units),
        1e6 * *iso.required_viscosity, *iso.kappa));
  if (iso.a_iso && iso.L_nm)
    out.push_back(fmt::format(
        "life Lnmh by ISO 281: {} (a_ISO {:.4g}, a1 {:.4g}, {})", lived(*iso.L_nm), *iso.a_iso,
        iso.a1, rating("Cu", iso.C_u.value_or(0.0), iso.maker.C_u.has_value(), units)));
  return out;
}

}  // namespace

StaticSummary summarize(const statics::StaticSolution& solution, const Bearing& bearing) {
  StaticSummary out{"ball", static_cast<int>(solution.balls.size()), {}, {}, solution};
  out.strength = life::contact_strength(bearing, solution);
  for (std::size_t k = 0; k < solution.balls.size(); ++k)
    for (std::size_t j = 0; j < 2; ++j) {
      const statics::StaticBall& ball = solution.balls[k];
      RaceSummary& race = out.race[j];
      if (!(ball.Q[j] > 0.0)) continue;
      ++race.loaded;
      raise(race.load, ball.Q[j], k);
      raise(race.pressure, ball.p_max[j], k);
      lower(race.least_angle, ball.alpha[j], k);
      raise(race.most_angle, ball.alpha[j], k);
      lower(race.shoulder, ball.shoulder_depth[j], k);
    }
  return out;
}

StaticSummary summarize(const statics::RollerSolution& solution, const Bearing& bearing) {
  StaticSummary out{"roller", static_cast<int>(solution.rollers.size()), {}, {}, solution};
  out.strength = life::contact_strength(bearing, solution);
  for (std::size_t k = 0; k < solution.rollers.size(); ++k)
    for (std::size_t j = 0; j < 2; ++j) {
      const statics::StaticRoller& roller = solution.rollers[k];
      const statics::RollerRaceContact& contact = roller.race[j];
      RaceSummary& race = out.race[j];
      for (const statics::RollerFlangeContact& flange : roller.flange[j])
        if (flange.present) raise(race.flange, flange.load, k);
      if (!(contact.load > 0.0)) continue;
      ++race.loaded;
      race.at_edge += contact.at_edge ? 1 : 0;
      raise(race.load, contact.load, k);
      raise(race.pressure, contact.peak_pressure, k);
      lower(race.least_angle, contact.contact_angle, k);
      raise(race.most_angle, contact.contact_angle, k);
    }
  return out;
}

std::array<double, 2> relative_tilt(const std::array<double, 2>& inner,
                                    const std::array<double, 2>& outer) {
  const auto to_frame = [](const std::array<double, 2>& tilt) {
    return passive_matrix({0.0, tilt[0], tilt[1]});
  };
  std::array<double, 2> tilt = tilt_of_axis(to_frame(outer) * to_frame(inner).row(0).transpose());
  // Equal tilts leave rounding.
  double largest = 0.0;
  for (const double angle : {inner[0], inner[1], outer[0], outer[1]})
    largest = std::fmax(largest, std::abs(angle));
  for (double& angle : tilt)
    if (std::abs(angle) < 1e-12 * largest) angle = 0.0;
  return tilt;
}

std::string displacement_datum_text(const Bearing& bearing, UnitSystem units) {
  const bool cones =
      bearing.type == bearing::Type::Tapered || bearing.type == bearing::Type::SphericalTapered;
  std::string place = cones               ? "both races touch the rollers without load"
                      : bearing.rollers() ? "the mid planes of both races coincide"
                                          : "the planes of the groove centers coincide";
  if (!bearing.rollers()) {
    const contact::GrooveGeometry g = contact::groove_geometry(bearing.balls());
    const double apart = g.centre_x[1] - g.centre_x[0];
    const double angle =
        bearing.operating ? bearing.operating->free.contact_angle : bearing.balls().contact_angle;
    if (apart != 0.0)
      place = fmt::format(
          "all balls touch both grooves without load at a contact angle of {} on the +x side (the "
          "planes of the groove centers coincide at x = {})",
          quantity(angle, unit::kAngle, units), quantity(-apart, unit::kLength, units));
  }
  const char* const kept = !bearing.rollers() ? "the plane of the groove centers"
                           : bearing.type == bearing::Type::Spherical
                               ? "the plane of the outer groove centers"
                               : "the middle plane of the row";
  return fmt::format(
      "Datum of displacements: unmounted bearing at room temperature, not rotating, races coaxial. "
      "At x = 0, {}. Fits, temperatures and speeds move the raceways, but not the datum: {} of "
      "each race is fixed. Axial growth of the rings relative to their faces is not modeled.",
      place, kept);
}

void print_static_summary(Report& report, const StaticSummary& s, const Bearing& bearing,
                          const life::BearingLife& life, const std::vector<std::string>& warnings,
                          const std::vector<Finding>& notes) {
  report.new_page("QUASI-STATIC SOLUTION: SUMMARY");
  report.text(fmt::format(
      "{} {}s; outer race {:.6g} rpm, inner race {:.6g} rpm. Tables of every contact follow.",
      s.count, s.element, from_si(bearing.speed[0], unit::kRotation, report.units()),
      from_si(bearing.speed[1], unit::kRotation, report.units())));
  report.blank();
  inner_race(report, s, bearing);
  report.blank();
  contacts(report, s);
  report.blank();
  if (bearing.operating) {
    geometry(report, *bearing.operating);
    report.blank();
  }
  lives(report, life);
  report.text(
      "Origin of constants. \"seen\": found in a public source. \"recalled\": not checked against "
      "a source. \"calibrated\", \"derived\": determined by this program, not by the authors of "
      "the model. \"deck\": given in the deck.");
  report.blank();
  remarks(report, warnings, notes);
}

std::vector<std::string> summary_lines(const StaticSummary& s, const Bearing& bearing,
                                       const life::BearingLife& life, UnitSystem units) {
  std::vector<std::string> out;
  const auto displacement = zero_rounding_noise(s.result.displacement, pitch_radius(bearing));
  std::string moved;
  for (std::size_t k = 0; k < 5; ++k)
    moved += fmt::format("{}{} {}", k == 0 ? "" : ", ", kDirection[k],
                         quantity(displacement[k], motion_unit(k), units));
  out.push_back(fmt::format("displacement of the inner race: {}", moved));
  const auto largest = [&](const char* name, const UnitPair& unit,
                           ElementValue RaceSummary::*member) {
    const std::size_t j = (s.race[1].*member).element != 0 &&
                                  !((s.race[0].*member).value >= (s.race[1].*member).value)
                              ? 1
                              : 0;
    const ElementValue& at = s.race[j].*member;
    out.push_back(at.element == 0
                      ? fmt::format("{}: none (no contact)", name)
                      : fmt::format("{}: {} ({} {}, {})", name, quantity(at.value, unit, units),
                                    s.element, at.element, kRaceTitle[j]));
  };
  largest("largest contact load", unit::kForce, &RaceSummary::load);
  largest("largest pressure", unit::kPressure, &RaceSummary::pressure);
  const auto lived = [&](bearing::LifeModel model, bearing::LifeModification modification) {
    const double L = life.state.of(model, modification).L_S, speed = life.state.relative_speed;
    const std::string hours =
        speed > 0.0 && std::isfinite(L) ? ", " + hours_text(L, speed) + " hr" : std::string();
    out.push_back(fmt::format(
        "life at {:.4g} % survival: {}{}{} ({}; constants {})",
        100.0 * life.parameters.survival.value, millions(L), std::isfinite(L) ? " Mrev" : "", hours,
        life_model_name(model, modification), origin(life, static_cast<std::size_t>(model))));
  };
  if (life.iso)
    for (std::string& line : iso_lines(*life.iso, life.state.relative_speed, units))
      out.push_back(std::move(line));
  lived(bearing::LifeModel::Original, bearing::LifeModification::None);
  const bearing::LifeChoices& choices = life.parameters.choices;
  if (choices.stored_model != bearing::LifeModel::Original ||
      choices.stored_modification != bearing::LifeModification::None)
    lived(choices.stored_model, choices.stored_modification);
  return out;
}

}  // namespace adore::listing
