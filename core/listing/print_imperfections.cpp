#include "listing/print_imperfections.hpp"

#include "bearing/given_surface.hpp"
#include "contact/groove.hpp"
#include "contact/race_errors.hpp"
#include "listing/print_words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <numbers>

namespace adore::listing {
namespace {

using bearing::RaceErrors;

/// One column of the table of deviations.
struct Deviation {
  const char* title;  ///< PRINT.txt
  const char* key;    ///< RUN.json
  const UnitPair* unit;
  std::vector<double> values;  ///< by element
};

bool rollers_deviate(const bearing::Bearing& b) {
  return b.rollers() && !b.rollers()->deviation.empty();
}

std::vector<Deviation> element_deviations(const bearing::Bearing& b) {
  std::vector<Deviation> out;
  if (!b.imperfections.ball_diameter.empty())
    out.push_back({"diameter", "diameter [m]", &unit::kLength, b.imperfections.ball_diameter});
  if (!rollers_deviate(b)) return out;
  const auto add = [&](const char* title, const char* key,
                       double bearing::RollerDeviation::*member) {
    Deviation column{title, key, &unit::kLength, {}};
    for (const bearing::RollerDeviation& own : b.rollers()->deviation)
      column.values.push_back(own.*member);
    out.push_back(std::move(column));
  };
  add("diameter", "diameter [m]", &bearing::RollerDeviation::diameter);
  if (b.rollers()->shape != bearing::RollerShape::Crowned ||
      b.imperfections.elements != bearing::ElementErrorSource::Random)
    return out;
  add("crown rad", "crown radius [m]", &bearing::RollerDeviation::crown_radius);
  add("length", "length [m]", &bearing::RollerDeviation::length);
  add("land len", "central land length [m]", &bearing::RollerDeviation::central_length);
  add("land offs", "central land offset [m]", &bearing::RollerDeviation::land_offset);
  return out;
}

/// R of contact/race_errors.hpp: groove bottom, or raceway under the middle of a roller.
double raceway_radius(const bearing::Bearing& b, std::size_t race) {
  if (b.rollers()) return b.rollers()->race_radius(static_cast<int>(race));
  const contact::GrooveGeometry g = contact::groove_geometry(b.balls());
  return g.centre_radius[race] + (race == bearing::kOuter ? 1.0 : -1.0) * g.groove_radius[race];
}

/// None of a surface over both coordinates, which has no one value at an azimuth.
std::vector<Deviation> race_deviations(const bearing::Bearing& b, std::size_t race) {
  if (bearing::table_of(b.imperfections.race[race].given.get()) != nullptr) return {};
  const double radius = raceway_radius(b, race);
  const bool groove = !b.rollers() || b.rollers()->groove_factor[race] > 0.0;
  std::vector<Deviation> out{{"radius", "radius [m]", &unit::kLength, {}}};
  if (groove) {
    out.push_back({"factor f", "curvature factor", &unit::kPure, {}});
  } else {
    out.push_back({"land offs", "land offset [m]", &unit::kLength, {}});
    out.push_back({"taper", "taper [rad]", &unit::kAngle, {}});
  }
  const int count = b.element_count();
  for (int k = 0; k < count; ++k) {
    const contact::LocalRaceError e = contact::race_error_at(b.imperfections.race[race], radius,
                                                             2.0 * std::numbers::pi * k / count);
    out[0].values.push_back(e.radius);
    out[1].values.push_back(groove ? e.curvature_factor : e.land_offset);
    if (!groove) out[2].values.push_back(e.taper);
  }
  return out;
}

void print_wave(Report& report, const std::string& label, const bearing::Harmonic& wave,
                const UnitPair& unit) {
  report.item(label + ": amplitude", wave.amplitude, unit);
  report.item("    waves per revolution", wave.waves, unit::kPure);
  report.item("    phase", wave.phase, unit::kAngle);
}

void print_race(Report& report, const bearing::Bearing& b, std::size_t race) {
  const RaceErrors& e = b.imperfections.race[race];
  if (e.given) {
    const bearing::SurfaceSeries& given = *e.given;
    const auto range = [&](const char* what, const bearing::AzimuthSeries& of,
                           const UnitPair& unit) {
      if (of.pairs.empty()) return;
      report.item(
          fmt::format("User routine ADRX6: smallest {} of the {} race", what, kRaceName[race]),
          of.least, unit);
      report.item("    largest", of.largest, unit);
    };
    if (const bearing::SurfaceTable* const table = bearing::table_of(&given)) {
      report.text(
          fmt::format("User routine ADRX6 gives the surface of the {} race on a grid of {} x {} "
                      "points (around the race x across the race).",
                      kRaceName[race], table->around, table->across));
      if (given.curvature_factor.least != 0.0 || given.curvature_factor.largest != 0.0) {
        report.item(fmt::format("Smallest curvature factor of the {} race", kRaceName[race]),
                    given.curvature_factor.least, unit::kPure);
        report.item("    largest", given.curvature_factor.largest, unit::kPure);
      }
    }
    range("radius", given.radius, unit::kLength);
    range("taper", given.taper, unit::kAngle);
    range("curvature factor", given.curvature_factor, unit::kPure);
    return;
  }
  if (e.roundness == RaceErrors::Roundness::Elliptical) {
    const std::string name = fmt::format("Ellipse of the {} race, ", kRaceName[race]);
    report.item(name + "half major axis minus radius", e.variation[0], unit::kLength);
    report.item("    half minor axis minus radius", e.variation[1], unit::kLength);
    report.item("    major axis from the z axis", e.variation[2], unit::kAngle);
  } else {
    print_wave(report, fmt::format("Waviness of the {} race radius", kRaceName[race]),
               {e.variation[0], e.variation[1], e.variation[2]}, unit::kLength);
  }
  if (!b.rollers() || b.rollers()->groove_factor[race] > 0.0) {
    print_wave(report, fmt::format("Waviness of the {} race curvature factor", kRaceName[race]),
               e.curvature_factor, unit::kPure);
    return;
  }
  print_wave(report, fmt::format("Waviness of the {} race land offset", kRaceName[race]),
             e.land_offset, unit::kLength);
  print_wave(report, fmt::format("Waviness of the {} race taper", kRaceName[race]), e.taper,
             unit::kAngle);
}

bool imperfect(const bearing::Bearing& b) {
  const bearing::Imperfections& i = b.imperfections;
  return i.elements != bearing::ElementErrorSource::None || i.race_given[0] || i.race_given[1];
}

void print_columns(Report& report, const std::string& heading, const bearing::Bearing& b,
                   const std::vector<Deviation>& columns) {
  if (columns.empty()) return;
  report.heading(heading);
  std::vector<Report::Column> titles;
  for (const Deviation& column : columns) titles.push_back({column.title, column.unit});
  std::vector<Report::Row> rows;
  for (std::size_t k = 0; k < static_cast<std::size_t>(b.element_count()); ++k) {
    Report::Row row{std::to_string(k + 1), {}};
    for (const Deviation& column : columns) row.values.push_back(column.values[k]);
    rows.push_back(std::move(row));
  }
  report.table(b.rollers() ? "roller" : "ball", titles, rows);
}

}  // namespace

void print_imperfections(Report& report, const bearing::Bearing& b) {
  if (!imperfect(b)) return;
  report.new_page("GEOMETRIC IMPERFECTIONS");
  const bearing::Imperfections& i = b.imperfections;
  if (i.elements == bearing::ElementErrorSource::Random) {
    report.text(
        "Deviations of the rolling elements: rms values of the deck times normally distributed "
        "random numbers. The random numbers depend only on the seed (option seed), the element "
        "number and the dimension.");
    report.item("Random seed", static_cast<long>(i.seed));
  }
  for (std::size_t race = 0; race < 2; ++race)
    if (i.race_given[race]) print_race(report, b, race);
  print_columns(report, "Deviations of the rolling elements (actual minus nominal)", b,
                element_deviations(b));
  for (std::size_t race = 0; race < 2; ++race)
    if (i.race_given[race])
      print_columns(report,
                    fmt::format("Deviations of the {} race (actual minus nominal) at the element "
                                "positions of the quasi-static solution",
                                kRaceName[race]),
                    b, race_deviations(b, race));
}

nlohmann::ordered_json imperfections_json(const bearing::Bearing& b) {
  nlohmann::ordered_json out;
  if (!imperfect(b)) return out;
  for (const Deviation& column : element_deviations(b)) out["elements"][column.key] = column.values;
  for (std::size_t race = 0; race < 2; ++race)
    if (b.imperfections.race_given[race])
      for (const Deviation& column : race_deviations(b, race))
        out[fmt::format("{} race at the elements", kRaceName[race])][column.key] = column.values;
  return out;
}

}  // namespace adore::listing
