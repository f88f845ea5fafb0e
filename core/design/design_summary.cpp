#include "design/design_summary.hpp"

#include "life/statistics.hpp"
#include "listing/static_summary.hpp"
#include "runs/prepare.hpp"
#include "runs/solution_tables.hpp"
#include "statics/kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace adore::design {
namespace {

constexpr std::array<const char*, 2> kRace = {"outer", "inner"};

/// A unit that people read, and its number over that of SI.
struct Shown {
  const char* si;
  const char* unit;
  double factor = 1.0, offset = 0.0;
};
constexpr Shown kHours{"h", "h"}, kPure{"", ""}, kAngle{"rad", "°", 180.0 / 3.14159265358979323846},
    kPressure{"Pa", "GPa", 1e-9}, kFilm{"m", "µm", 1e6}, kTorque{"N.m", "N mm", 1e3},
    kPower{"W", "W"}, kStiffness{"N/m", "N/µm", 1e-6}, kFrequency{"Hz", "Hz"},
    kTemperature{"K", "°C", 1.0, -273.15}, kForce{"N", "N"};

class Writer {
 public:
  explicit Writer(DesignSummary& out) : out_(out) {}
  void group(std::string name) { group_ = std::move(name); }
  void add(std::string id, std::string label, const Shown& shown, std::optional<double> value,
           std::string note = {}) {
    if (value && std::isnan(*value)) value.reset();
    out_.values.push_back({std::move(id), group_, std::move(label), value, shown.si, shown.unit,
                           shown.factor, shown.offset, std::move(note)});
  }

 private:
  DesignSummary& out_;
  std::string group_;
};

std::string bearing_text(const bearing::Bearing& bearing) {
  static constexpr std::array<const char*, 5> kTypes = {"ball", "cylindrical roller",
                                                        "spherical roller", "tapered roller",
                                                        "spherical tapered roller"};
  return fmt::format("{} bearing with {} {}", kTypes.at(static_cast<std::size_t>(bearing.type) - 1),
                     bearing.element_count(), bearing.rollers() != nullptr ? "rollers" : "balls");
}

void add_lives(Writer& out, const runs::Prepared& ready) {
  out.group("Life");
  const double speed = ready.life.state.relative_speed;
  const auto hours = [&](std::optional<double> revolutions) -> std::optional<double> {
    if (!revolutions || !(speed > 0.0)) return std::nullopt;
    return life::life_hours(*revolutions, speed);
  };
  const auto why = [&](const char* otherwise) {
    return speed > 0.0 ? std::string(otherwise) : std::string("the races do not rotate");
  };
  const std::optional<life::IsoReport>& iso = ready.life.iso;
  out.add("life_iso281", "L10h, ISO 281", kHours, iso ? hours(iso->L10) : std::nullopt,
          iso && iso->L10
              ? why("rating life at the loads of the deck")
              : why("ISO 281 does not define an equivalent load for the loads of the deck"));
  out.add("life_iso16281", "L10rh, ISO/TS 16281", kHours,
          iso && iso->reference ? hours(iso->reference->L10r) : std::nullopt,
          iso && iso->reference ? why("life computed from the loads of all contacts")
                                : why("the deck does not have the roller slices or the geometry "
                                      "that ISO/TS 16281 needs"));
  out.add("life_modified", "Lnmh, with aISO", kHours,
          iso && iso->L_nm ? hours(iso->L_nm) : std::nullopt,
          iso && iso->L_nm
              ? why("aISO from the viscosity ratio and the contamination factor (isoContamination)")
              : why("needs an oil and the run option isoContamination"));
  out.add(
      "life_lundberg_palmgren", "L10h, Lundberg-Palmgren", kHours,
      hours(ready.life.state.of(bearing::LifeModel::Original, bearing::LifeModification::None).L10),
      why("original Lundberg-Palmgren theory with the loads of all contacts"));
}

void add_contacts(Writer& out, const runs::Prepared& ready) {
  out.group("Contacts");
  const bool rollers = ready.rollers.has_value();
  const listing::StaticSummary all = rollers ? listing::summarize(*ready.rollers, ready.bearing)
                                             : listing::summarize(ready.statics, ready.bearing);
  std::optional<double> safety;
  for (std::size_t j = 0; j < 2; ++j) {
    const listing::RaceSummary& race = all.race[j];
    if (race.pressure.element == 0 || !(race.pressure.value > 0.0)) continue;
    const bool line = ready.life.race[j].line;
    const double here = line ? std::pow(4.0e9 / race.pressure.value, 2.0)
                             : std::pow(4.2e9 / race.pressure.value, 3.0);
    safety = std::min(safety.value_or(here), here);
  }
  out.add("static_safety", "Safety s0", kPure, safety,
          safety ? "from the larger of the maximum contact pressures of the two races"
                 : "no contact has a load");
  for (std::size_t j = 0; j < 2; ++j) {
    const listing::RaceSummary& race = all.race[j];
    out.add(fmt::format("pressure_{}", kRace[j]), fmt::format("Pressure, {} race", kRace[j]),
            kPressure,
            race.pressure.element > 0 ? std::optional(race.pressure.value) : std::nullopt,
            race.pressure.element > 0 ? fmt::format("{} {}", all.element, race.pressure.element)
                                      : std::string("no contact has a load"));
  }
  for (std::size_t j = 0; j < 2; ++j) {
    const listing::RaceSummary& race = all.race[j];
    std::optional<double> angle;
    if (race.load.element > 0) {
      const auto i = static_cast<std::size_t>(race.load.element) - 1;
      angle = rollers ? ready.bearing.rollers()->race_angle[j] : ready.statics.balls[i].alpha[j];
    }
    std::string note = "no contact has a load";
    if (angle && rollers)
      note = "angle of the raceway at mid-length of the roller";
    else if (angle)
      note = fmt::format("at the most loaded ball; range of all balls: {:.3g} to {:.3g}°",
                         race.least_angle.value * kAngle.factor,
                         race.most_angle.value * kAngle.factor);
    out.add(fmt::format("contact_angle_{}", kRace[j]), fmt::format("Angle, {} race", kRace[j]),
            kAngle, angle, note);
  }
  out.add("largest_load", "Largest load", kForce, ready.race_result().max_load,
          fmt::format("{} of {} {}s have a load", all.race[1].loaded, all.count, all.element));
}

void add_films(Writer& out, const runs::Prepared& ready) {
  out.group("Film");
  const std::optional<statics::LubricantFilms>& films = ready.race_result().films;
  for (std::size_t j = 0; j < 2; ++j) {
    std::optional<double> least;
    if (films)
      for (const statics::ElementFilm& one : films->race[j])
        if (one.film.minimum > 0.0)
          least = std::min(least.value_or(one.film.minimum), one.film.minimum);
    const std::string none = films ? "no contact has a film" : "the deck has no oil";
    out.add(fmt::format("film_{}", kRace[j]), fmt::format("Film, {} race", kRace[j]), kFilm, least,
            least ? films->lubricant : none);
    out.add(
        fmt::format("lambda_{}", kRace[j]), fmt::format("Lambda, {} race", kRace[j]), kPure,
        films && least ? std::optional(films->lambda[j]) : std::nullopt,
        films && least
            ? (std::isnan(films->lambda[j])
                   ? "the roughness is 0"
                   : "smallest film thickness divided by roughness, for the most loaded contact")
            : none);
  }
}

void add_friction(Writer& out, const runs::Prepared& ready) {
  out.group("Friction torque");
  const statics::FrictionEstimate* f = ready.friction ? &*ready.friction : nullptr;
  const std::string none =
      f == nullptr ? "the user traction routine is called only in a simulation of the motion"
                   : f->why_none();
  const bool known = f != nullptr && none.empty();
  const auto add = [&](const char* id, const char* label, double power, const std::string& note,
                       const std::string& why_not = {}) {
    const bool here = known && why_not.empty();
    out.add(fmt::format("torque_{}", id), label, kTorque,
            here ? std::optional(power / f->speed) : std::nullopt,
            here    ? note
            : known ? why_not
                    : none);
  };
  statics::FrictionOfContact races;
  if (known)
    for (int j = 0; j < 2; ++j) {
      const statics::FrictionOfContact one = f->of_race(j);
      races.rolling += one.rolling;
      races.sliding += one.sliding;
      races.spin += one.spin;
    }
  add("total", "Total", known ? f->power() : 0.0, "without cage and seals");
  add("rolling", "Rolling in oil", races.rolling, "both races",
      known && !f->oil ? "the deck has no oil" : "");
  add("sliding", "Sliding", races.sliding, "both races");
  add("spin", "Spin", races.spin, "both races");
  add("flange", "Flanges", known ? f->flange[0] + f->flange[1] : 0.0,
      ready.rollers ? "roller ends" : "balls have no flanges");
  add("drag", "Drag of medium", known ? f->drag() : 0.0, known ? f->medium : none,
      known && f->medium.empty() ? "the deck has no churning medium (kChrn = 0)" : "");
  out.add("torque_cage", "Cage, seals", kTorque, std::nullopt,
          "cage friction needs a simulation of the motion; seals are not modeled");
  out.add("heat", "Heat", kPower, known ? std::optional(f->power()) : std::nullopt,
          known ? "without cage and seals" : none);
}

void add_stiffness(Writer& out, const runs::Prepared& ready) {
  out.group("Stiffness");
  const statics::RaceResult& race = ready.race_result();
  const auto add = [&](const char* id, const char* label, Eigen::Index k) {
    out.add(id, label, kStiffness, race.stiffness(k, k), "at this load and speed");
  };
  add("stiffness_axial", "Axial", 0);
  add("stiffness_radial", "Radial (z)", 2);
}

void add_fault_frequencies(Writer& out, const runs::Prepared& ready) {
  out.group("Defect frequencies");
  const bearing::Bearing& b = ready.bearing;
  double angle = 0.0;
  if (const bearing::RollerGeometry* rollers = b.rollers()) {
    angle = 0.5 * (rollers->race_angle[0] + rollers->race_angle[1]);
  } else {
    double most = 0.0;
    angle = b.balls().contact_angle;
    for (const statics::StaticBall& ball : ready.statics.balls)
      if (ball.Q[0] > 0.0 && ball.Q[1] > 0.0 && ball.Q[1] > most) {
        most = ball.Q[1];
        angle = 0.5 * (ball.alpha[0] + ball.alpha[1]);
      }
  }
  const bool moves = b.speed[0] != b.speed[1];
  statics::EpicyclicSpeeds speeds;
  if (moves)
    speeds = statics::epicyclic_speeds(b.element_count(), b.element_diameter(), b.pitch_diameter(),
                                       std::abs(angle), b.speed[0], b.speed[1]);
  const auto add = [&](const char* id, const char* label, double value, const char* note) {
    out.add(id, label, kFrequency, moves ? std::optional(value) : std::nullopt,
            moves ? note : "the races do not rotate relative to each other");
  };
  add("bpfo", "BPFO (outer)", speeds.outer_pass,
      "frequency at which elements pass a point of the outer race");
  add("bpfi", "BPFI (inner)", speeds.inner_pass,
      "frequency at which elements pass a point of the inner race");
  add("bsf", "BSF (spin)", speeds.spin_frequency,
      "spin frequency; a defect of an element strikes the races at twice this frequency");
  add("ftf", "FTF (cage)", std::abs(speeds.cage_frequency), "rotation frequency of the cage");
}

void add_temperatures(Writer& out, const runs::Prepared& ready) {
  out.group("Temperatures");
  const bool computed = ready.thermal.has_value();
  const std::string note =
      computed ? "steady state" : "temperature from the deck; no thermal analysis (kTherm = 0)";
  const auto add = [&](const char* id, const char* label, double kelvin) {
    out.add(id, label, kTemperature, kelvin, note);
  };
  const bearing::Bearing& b = ready.bearing;
  add("temperature_outer", "Outer race",
      computed ? ready.thermal->heat.bulk.race[0] : b.race_temperature[0]);
  add("temperature_inner", "Inner race",
      computed ? ready.thermal->heat.bulk.race[1] : b.race_temperature[1]);
  add("temperature_element", b.rollers() != nullptr ? "Rollers" : "Balls",
      computed ? ready.thermal->heat.bulk.element : b.element_temperature);
}

}  // namespace

const DesignValue* DesignSummary::find(std::string_view id) const {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const DesignValue& one) { return one.id == id; });
  return found == values.end() ? nullptr : &*found;
}

std::string number_text(const DesignValue& value) {
  if (!value.value) return "not computed";
  const double shown = *value.value * value.factor + value.offset;
  constexpr double kMost = 1e6;
  if (shown > kMost) return "> 1 000 000";
  if (shown == 0.0) return "0";
  // Four significant digits, as a plain number.
  const int decimals = 3 - static_cast<int>(std::floor(std::log10(std::abs(shown))));
  const double scale = decimals < 0 ? std::pow(10.0, -decimals) : 1.0;
  std::string text = decimals < 0 ? fmt::format("{:.0f}", std::round(shown / scale) * scale)
                                  : fmt::format("{:.{}f}", shown, std::min(decimals, 6));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string quantity_text(const DesignValue& value) {
  const std::string number = number_text(value);
  if (!value.value || value.unit.empty()) return number;
  return value.unit == "°" ? number + "°" : number + " " + value.unit;
}

DesignSummary design_summary(deck::Deck deck, const std::map<std::string, std::string>& options,
                             std::stop_token stop) {
  const auto begin = std::chrono::steady_clock::now();
  deck.set("mode", "-1");
  deck.set("kStif", "0");
  deck.complete();
  runs::LoadedDeck input;
  input.path = "deck";
  input.deck = std::move(deck);
  input.option_values = options;
  input.stop = std::move(stop);
  const runs::Prepared ready = runs::prepare(std::move(input));
  DesignSummary out;
  out.bearing = bearing_text(ready.bearing);
  Writer writer(out);
  add_lives(writer, ready);
  add_contacts(writer, ready);
  add_friction(writer, ready);
  add_films(writer, ready);
  add_stiffness(writer, ready);
  add_fault_frequencies(writer, ready);
  add_temperatures(writer, ready);
  out.findings = ready.input.warnings;
  for (Finding& one : runs::solution_notes(ready)) out.findings.push_back(std::move(one));
  out.tables = runs::solution_tables(ready);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

}  // namespace adore::design
