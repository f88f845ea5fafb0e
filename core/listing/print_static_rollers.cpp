#include "listing/print_cage.hpp"
#include "listing/print_file.hpp"
#include "listing/print_films.hpp"
#include "listing/print_words.hpp"
#include "listing/rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// Roller bearings in PRINT.txt: geometry and quasi-static page.
namespace adore::listing {
namespace {

constexpr std::array<const char*, 2> kSideName{"-x", "+x"};

const char* shape_name(bearing::RollerShape shape) {
  switch (shape) {
    case bearing::RollerShape::Arc:
      return "one arc over the whole length";
    case bearing::RollerShape::Logarithmic:
      return "logarithmic";
    case bearing::RollerShape::Crowned:
      break;
  }
  return "straight land with tangent crowns";
}

void flanges(Report& report, const bearing::RollerGeometry& g) {
  std::vector<Report::Row> rows;
  for (std::size_t race = 0; race < 2; ++race)
    for (std::size_t side = 0; side < 2; ++side)
      if (const auto& flange = g.flange[race][side])
        rows.push_back({fmt::format("{} {}", kRaceName[race], kSideName[side]),
                        {flange->layback, flange->height}});
  if (rows.empty()) {
    report.text("There are no flanges.");
    return;
  }
  report.heading("Flanges (layback from the perpendicular to the raceway)");
  report.table("flange", {{"layback", &unit::kAngle}, {"height", &unit::kLength}}, rows, 14);
  for (std::size_t race = 0; race < 2; ++race)
    if (g.flange[race][0] && g.flange[race][1])
      report.item(fmt::format("Axial clearance between the {} flanges", kRaceName[race]),
                  g.flange_play[race], unit::kLength);
}

void summary(Report& report, const statics::RollerSolution& s) {
  const bool point =
      s.slice_position.empty() || s.rollers.empty() || s.rollers.front().race[0].slice_load.empty();
  for (std::size_t race = 0; race < 2; ++race) {
    if (point)
      report.item(fmt::format("Hertz constant K of Q = K delta^1.5, {} race", kRaceName[race]),
                  s.line_constant[race], unit::kHertzConstant);
    else
      report.item(fmt::format("Constant K of Q = K L^(8/9) delta^(10/9), {} race", kRaceName[race]),
                  s.line_constant[race], unit::kPressure);
  }
  if (!point) {
    report.item("Slices along a roller", static_cast<long>(s.slice_position.size()));
    report.item("Width of a slice", s.slice_width, unit::kLength);
  }
  report.item("Orbital speed of the rollers (pure rolling)", s.orbital_speed, unit::kRotation);
  report.item("Spin of a roller about its axis, relative to the orbit", s.spin_speed,
              unit::kRotation);
  report.item("Centrifugal force on a roller", s.centrifugal_force, unit::kForce);
  report.item("Gyroscopic moment about y, supported by the contacts", s.gyroscopic_moment,
              unit::kMoment);
  if (s.guide_force > 0.0) {
    report.item("Force along the axis of each roller from guide ring or cage", s.guide_force,
                unit::kForce);
  }
  std::string skew = "Roller skew is assumed to be zero. ";
  if (s.friction.computed) {
    double largest = 0.0, orbit = 0.0;
    long balanced = 0;
    for (const statics::StaticRoller& r : s.rollers)
      if (r.balanced) {
        largest = std::max(largest, std::abs(r.skew));
        orbit += r.orbital_speed;
        ++balanced;
      }
    report.item("Rollers in friction equilibrium", balanced);
    if (balanced > 0) {
      report.item("Largest skew of a roller", largest, unit::kAngle);
      report.item("Mean orbital speed of rollers in friction equilibrium",
                  orbit / static_cast<double>(balanced), unit::kRotation);
    }
    skew = "Rollers without friction equilibrium have no skew and roll without slip. ";
  }
  report.text(skew + s.unloaded_position_rule);
}

/// Position of the largest pressure: the middle of the neighboring slices that carry it (to 1e-9,
/// a land carries one pressure), and of two equal peaks the one towards +x.
double peak_position(const statics::RollerRaceContact& c, const statics::RollerSolution& s) {
  if (c.slice_pressure.empty() || !(c.peak_pressure > 0.0)) return c.peak_position;
  const auto peak = [&](std::size_t k) {
    return c.slice_pressure[k] >= c.peak_pressure * (1.0 - 1e-9);
  };
  std::size_t last = s.slice_position.size();
  while (last > 0 && !peak(last - 1)) --last;
  std::size_t first = last;
  while (first > 0 && peak(first - 1)) --first;
  if (first == last) return c.peak_position;
  const double middle = 0.5 * (s.slice_position[first] + s.slice_position[last - 1]);
  return std::abs(middle) < 1e-9 * s.slice_width ? 0.0 : middle;
}

void contacts(Report& report, const statics::RollerSolution& s, std::size_t race) {
  std::vector<Report::Row> rows;
  for (std::size_t k = 0; k < s.rollers.size(); ++k) {
    const statics::RollerRaceContact& c = s.rollers[k].race[race];
    rows.push_back({std::to_string(k + 1) + (c.at_edge ? " *" : ""),
                    {c.load, zero_rounding_noise(c.moment, c.load * c.length), c.contact_angle,
                     c.delta, c.peak_pressure, peak_position(c, s), c.half_width, c.length}});
  }
  report.heading(fmt::format("Contacts with the {} race", kRaceName[race]));
  report.text(
      "Moments are about mid-length. Column \"at\": axial distance of the pressure peak from "
      "mid-length (of two equal peaks, the one at larger x).");
  report.table("roller",
               {{"load Q", &unit::kForce},
                {"moment", &unit::kMoment},
                {"angle", &unit::kAngle},
                {"approach", &unit::kLength},
                {"pmax", &unit::kPressure},
                {"at", &unit::kLength},
                {"half width", &unit::kLength},
                {"length", &unit::kLength}},
               rows);
  if (std::any_of(s.rollers.begin(), s.rollers.end(),
                  [race](const auto& r) { return r.race[race].at_edge; }))
    report.text(
        "Rollers marked *: the contact reaches a roller corner or a land edge. The edge stress is "
        "higher than the printed pressure.");
}

void positions(Report& report, const statics::RollerSolution& s) {
  std::vector<Report::Row> rows;
  for (std::size_t k = 0; k < s.rollers.size(); ++k) {
    const statics::StaticRoller& r = s.rollers[k];
    Report::Row& row =
        rows.emplace_back(Report::Row{std::to_string(k + 1), {r.azimuth, r.x, r.r, r.tilt}});
    if (s.friction.computed) row.values.push_back(r.skew);
    for (const double load : {r.race[0].load, r.race[1].load, s.centrifugal_force})
      row.values.push_back(load);
  }
  report.heading(
      "Roller positions (middle of the roller; tilt of the roller axis to the bearing axis)");
  std::vector<Report::Column> columns{{"azimuth", &unit::kAngle},
                                      {"axial", &unit::kLength},
                                      {"radial", &unit::kLength},
                                      {"tilt", &unit::kAngle}};
  if (s.friction.computed) columns.push_back({"skew", &unit::kAngle});
  columns.insert(
      columns.end(),
      {{"Q outer", &unit::kForce}, {"Q inner", &unit::kForce}, {"centrifugal", &unit::kForce}});
  report.table("roller", columns, rows);
}

void flange_contacts(Report& report, const statics::RollerSolution& s) {
  bool any = false;
  for (std::size_t race = 0; race < 2; ++race)
    for (std::size_t side = 0; side < 2; ++side) {
      if (s.rollers.empty() || !s.rollers.front().flange[race][side].present) continue;
      if (!any) report.heading("Roller ends against flanges (gap: negative in contact)");
      any = true;
      std::vector<Report::Row> rows;
      for (std::size_t k = 0; k < s.rollers.size(); ++k) {
        const statics::RollerFlangeContact& f = s.rollers[k].flange[race][side];
        rows.push_back({fmt::format("{}{}", k + 1, f.load > 0.0 && !f.on_face ? " edge" : ""),
                        {f.load, f.gap, f.height, f.radius}});
      }
      report.table(fmt::format("{} {}", kRaceName[race], kSideName[side]),
                   {{"load", &unit::kForce},
                    {"gap", &unit::kLength},
                    {"height", &unit::kLength},
                    {"from axis", &unit::kLength}},
                   rows, 10);
    }
}

/// Load per length and pressure along the heaviest roller of each race.
void profile(Report& report, const statics::RollerSolution& s) {
  std::array<std::size_t, 2> heaviest{};
  for (std::size_t race = 0; race < 2; ++race)
    for (std::size_t k = 0; k < s.rollers.size(); ++k)
      if (s.rollers[k].race[race].load > s.rollers[heaviest[race]].race[race].load)
        heaviest[race] = k;
  const auto& outer = s.rollers[heaviest[0]].race[0];
  const auto& inner = s.rollers[heaviest[1]].race[1];
  if (outer.slice_load.empty() || !(outer.load + inner.load > 0.0)) return;
  report.heading(
      fmt::format("Slices of the most loaded rollers (roller {} at the outer race, {} at the inner "
                  "race); positions from mid-length towards +x",
                  heaviest[0] + 1, heaviest[1] + 1));
  std::vector<Report::Row> rows;
  for (std::size_t k = 0; k < s.slice_position.size(); ++k)
    rows.push_back({std::to_string(k + 1),
                    {s.slice_position[k], outer.slice_load[k], outer.slice_pressure[k],
                     inner.slice_load[k], inner.slice_pressure[k]}});
  report.table("slice",
               {{"position", &unit::kLength},
                {"Q outer", &unit::kForce},
                {"p outer", &unit::kPressure},
                {"Q inner", &unit::kForce},
                {"p inner", &unit::kPressure}},
               rows);
}

}  // namespace

void print_roller_geometry(Report& report, const bearing::RollerGeometry& g,
                           const bearing::Envelope& envelope) {
  report.item("Number of rollers", static_cast<long>(g.count));
  report.item("Roller diameter at mid-length", g.diameter, unit::kLength);
  report.item("Roller length", g.length, unit::kLength);
  report.item("Roller profile", shape_name(g.shape));
  report.item("Crown radius", g.crown_radius, unit::kLength);
  if (g.shape == bearing::RollerShape::Crowned)
    report.item("Length of the central land", g.central_length, unit::kLength);
  report.item("Corner radius, -x end", g.corner_radius[0], unit::kLength);
  report.item("Corner radius, +x end", g.corner_radius[1], unit::kLength);
  report.item("End radius, -x end (0: flat)", g.end_radius[0], unit::kLength);
  report.item("End radius, +x end (0: flat)", g.end_radius[1], unit::kLength);
  report.item("Half taper angle of the roller", g.half_angle, unit::kAngle);
  report.item("Angle of the roller axis to the bearing axis", g.axis_angle, unit::kAngle);
  report.item("Pitch diameter", g.pitch_diameter, unit::kLength);
  report.item("Diametral clearance", g.clearance, unit::kLength);
  report.item("Bearing bore", envelope.bore, unit::kLength);
  report.item("Bearing outside diameter", envelope.outer_diameter, unit::kLength);
  report.item("Shaft bore", envelope.shaft_bore, unit::kLength);
  report.item("Housing outside diameter", envelope.housing_diameter, unit::kLength);
  report.blank();
  std::vector<Report::Row> rows;
  for (int race = 0; race < 2; ++race) {
    const auto r = static_cast<std::size_t>(race);
    rows.push_back(
        {fmt::format("{} race", kRaceName[r]),
         {g.race_angle[r], 2.0 * g.race_radius(race), 2.0 * g.groove_factor[r] * g.crown_radius,
          g.land_width[r], envelope.race_width[r], g.roughness[r]}});
  }
  report.text("Groove radius 0: straight raceway. Land width 0: not limited.");
  report.table("",
               {{"angle", &unit::kAngle},
                {"diameter", &unit::kLength},
                {"groove rad", &unit::kLength},
                {"land width", &unit::kLength},
                {"race width", &unit::kLength},
                {"roughness", &unit::kLength}},
               rows, 12);
  for (const std::size_t r : {0UL, 1UL}) {
    if (!(g.race_crown_radius[r] > 0.0)) continue;
    report.item(fmt::format("Crown radius of the {} race", kRaceName[r]), g.race_crown_radius[r],
                unit::kLength);
    report.item(fmt::format("Length of the flat land of the {} race", kRaceName[r]),
                g.race_central_length[r], unit::kLength);
  }
  flanges(report, g);
}

void print_quasi_static(Report& report, const statics::RollerSolution& solution,
                        const bearing::Bearing& bearing) {
  report.new_page("QUASI-STATIC EQUILIBRIUM");
  print_race_equilibrium(report, solution, bearing);
  summary(report, solution);
  print_race_stiffness(report, solution);
  positions(report, solution);
  contacts(report, solution, bearing::kOuter);
  contacts(report, solution, bearing::kInner);
  flange_contacts(report, solution);
  profile(report, solution);
  if (solution.films) print_films(report, *solution.films, "roller");
  print_cage_operation(report, bearing);
  if (solution.notes.empty()) return;
  report.heading("Notes");
  for (const Finding& note : solution.notes) report.text(note.message);
}

}  // namespace adore::listing
