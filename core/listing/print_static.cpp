#include "base/constants.hpp"
#include "listing/print_cage.hpp"
#include "listing/print_file.hpp"
#include "listing/print_films.hpp"
#include "listing/rounding.hpp"
#include "listing/static_summary.hpp"
#include "results/motion.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

/// Quasi-static page of PRINT.txt.
namespace adore::listing {
namespace {

void ball_contacts(Report& report, const statics::StaticSolution& solution) {
  report.item("Race control criterion (above 1: outer race control)", solution.race_control_ratio,
              unit::kPure);
  for (std::size_t race = 0; race < 2; ++race) {
    const char* name = race == 0 ? "outer" : "inner";
    report.item(fmt::format("Hertz constant K of Q = K delta^1.5, {} race", name),
                solution.hertz[race].K, unit::kHertzConstant);
    report.item(fmt::format("Axis ratio of the contact ellipse, {} race", name),
                solution.hertz[race].kappa, unit::kPure);
  }
}

/// Reference values for the columns s and t of a race.
std::string edge_limits(const bearing::Bearing& bearing, std::size_t race, UnitSystem units) {
  const auto length = [&](double si) {
    return Report::number(from_si(si, unit::kLength, units)) + " " +
           std::string(unit_name(unit::kLength, units));
  };
  const double shoulder = bearing.balls().shoulder_diameter[race];
  const double shim = bearing.balls().shim[race];
  return fmt::format(
      "Limits at the {} race: s {}; t {}.", race == 0 ? "outer" : "inner",
      shoulder > 0.0 ? fmt::format("above 0 (shoulder diameter {})", length(shoulder))
                     : std::string("not limited (no shoulder diameter given)"),
      shim > 0.0 ? fmt::format("above {} (half the shim thickness)", length(0.5 * shim))
                 : std::string("not limited (race not split)"));
}

void balls(Report& report, const statics::StaticSolution& solution,
           const bearing::Bearing& bearing) {
  std::vector<Report::Row> loads, ellipses, edges, motions;
  for (std::size_t j = 0; j < solution.balls.size(); ++j) {
    const statics::StaticBall& b = solution.balls[j];
    const std::string name = std::to_string(j + 1);
    loads.push_back({name,
                     {b.azimuth, b.Q[0], b.Q[1], b.alpha[0], b.alpha[1], b.delta[0], b.delta[1],
                      b.p_max[0], b.p_max[1]}});
    ellipses.push_back({name,
                        {b.a[0], b.b[0], b.a[1], b.b[1], zero_rounding_noise(b.spin_roll[0]),
                         zero_rounding_noise(b.spin_roll[1])}});
    edges.push_back({name,
                     {b.azimuth, b.shoulder_depth[0], b.inner_chord[0], b.shoulder_depth[1],
                      b.inner_chord[1]}});
    const Vec3 omega(b.omega_x, -b.omega_theta, b.omega_r);
    const DirectionAngles direction = direction_angles(omega);
    motions.push_back({name,
                       {b.x, b.r, b.orbital_speed, omega.norm(), direction.theta, direction.phi,
                        b.centrifugal_force, b.gyroscopic_moment}});
  }
  report.heading("Contact loads");
  report.table("ball",
               {{"azimuth", &unit::kAngle},
                {"Q outer", &unit::kForce},
                {"Q inner", &unit::kForce},
                {"angle outer", &unit::kAngle},
                {"angle inner", &unit::kAngle},
                {"delta outer", &unit::kLength},
                {"delta inner", &unit::kLength},
                {"pmax outer", &unit::kPressure},
                {"pmax inner", &unit::kPressure}},
               loads);
  report.heading(
      "Contact ellipses (half axes a across, b along the rolling direction) and spin-to-roll "
      "ratios");
  report.table("ball",
               {{"a outer", &unit::kLength},
                {"b outer", &unit::kLength},
                {"a inner", &unit::kLength},
                {"b inner", &unit::kLength},
                {"s/r outer", &unit::kPure},
                {"s/r inner", &unit::kPure}},
               ellipses);
  report.heading("Contact edges in the grooves");
  report.text(
      "Columns. \"s\": depth of the contact edge next to the shoulder, below the shoulder "
      "(negative: beyond the shoulder). \"t\": distance of the other contact edge from the middle "
      "plane of the groove (in a split race: the plane of the split).");
  for (std::size_t race = 0; race < 2; ++race)
    report.text(edge_limits(bearing, race, report.units()));
  report.table("ball",
               {{"azimuth", &unit::kAngle},
                {"s outer", &unit::kLength},
                {"t outer", &unit::kLength},
                {"s inner", &unit::kLength},
                {"t inner", &unit::kLength}},
               edges);
  report.heading(
      "Position and motion (theta, phi: direction of the angular velocity in the azimuth frame)");
  report.table("ball",
               {{"axial", &unit::kLength},
                {"radial", &unit::kLength},
                {"orbit", &unit::kRotation},
                {"spin", &unit::kRotation},
                {"theta", &unit::kAngle},
                {"phi", &unit::kAngle},
                {"centrifugal", &unit::kForce},
                {"gyroscopic", &unit::kMoment}},
               motions);
}

/// Only when a race is split.
void split_races(Report& report, const statics::StaticSolution& solution,
                 const bearing::Bearing& bearing) {
  for (std::size_t race = 0; race < 2; ++race) {
    if (!(bearing.balls().shim[race] > 0.0)) continue;
    const char* name = race == 0 ? "outer" : "inner";
    std::vector<Report::Row> rows;
    for (std::size_t k = 0; k < solution.balls.size(); ++k) {
      const statics::StaticBall& b = solution.balls[k];
      const statics::SecondContact& second = b.second[race];
      const bool dual = second.Q > 0.0;
      const auto of_second = [&](double value) { return dual ? value : kNaN; };
      rows.push_back(
          {std::to_string(k + 1),
           {b.azimuth, b.inner_chord[race] - 0.5 * bearing.balls().shim[race], b.other_half[race],
            b.shoulder_depth[race], second.Q, of_second(second.alpha), of_second(second.delta),
            of_second(second.p_max), of_second(second.a), of_second(second.b)}});
    }
    report.heading(
        fmt::format("Split {} race: distance of the nearest contact edge from the split; gap and "
                    "contact with the other (less loaded) half",
                    name));
    report.table("ball",
                 {{"azimuth", &unit::kAngle},
                  {"from split", &unit::kLength},
                  {"other half", &unit::kLength},
                  {"shoulder", &unit::kLength},
                  {"second load", &unit::kForce},
                  {"angle", &unit::kAngle},
                  {"approach", &unit::kLength},
                  {"pressure", &unit::kPressure},
                  {"a", &unit::kLength},
                  {"b", &unit::kLength}},
                 rows);
  }
}

}  // namespace

void print_race_equilibrium(Report& report, const statics::RaceResult& solution,
                            const bearing::Bearing& bearing) {
  report.text(
      "Inner race relative to the outer race, in the base frame. Loads: applied by the shaft to "
      "the inner race.");
  report.text(displacement_datum_text(bearing, report.units()));
  const double radius = 0.5 * bearing.pitch_diameter();
  const auto displacement = zero_rounding_noise(solution.displacement, radius);
  const auto found_load = zero_rounding_noise(solution.load, 1.0 / radius);
  std::vector<std::vector<std::string>> rows;
  const char* const names[] = {"x", "y", "z", "about y", "about z"};
  for (std::size_t k = 0; k < 5; ++k) {
    const UnitPair& motion = k < 3 ? unit::kLength : unit::kAngle;
    const UnitPair& load = k < 3 ? unit::kForce : unit::kMoment;
    const bool given = bearing.constraints.displacement_given[k];
    rows.push_back({names[k], Report::number(from_si(displacement[k], motion, report.units())),
                    std::string(unit_name(motion, report.units())), given ? "given" : "found",
                    Report::number(from_si(found_load[k], load, report.units())),
                    std::string(unit_name(load, report.units())), given ? "found" : "given"});
  }
  report.text_table(
      {{"", 8}, {"displacement", 16}, {"", 6}, {"", 8}, {"load", 16}, {"", 8}, {"", 8}}, rows);
  const auto& outer = bearing.constraints.outer_misalignment;
  if (outer[0] != 0.0 || outer[1] != 0.0) {
    const auto tilt = relative_tilt({solution.displacement[3], solution.displacement[4]}, outer);
    report.item("Tilt of the outer race about y, base frame", outer[0], unit::kAngle);
    report.item("Tilt of the outer race about z, base frame", outer[1], unit::kAngle);
    report.item("Tilt of the inner race relative to the outer race about y", tilt[0], unit::kAngle);
    report.item("Tilt of the inner race relative to the outer race about z", tilt[1], unit::kAngle);
  }
  report.blank();
  report.item("Largest contact load", solution.max_load, unit::kForce);
  report.item("Largest contact stiffness", solution.max_stiffness, unit::kStiffness);
  report.item("Iterations", static_cast<long>(solution.iterations));
  report.item("Largest force residual / load", solution.residual, unit::kPure);
}

/// Entries are force or moment over length or radian.
void print_race_stiffness(Report& report, const statics::RaceResult& solution) {
  report.heading("Stiffness: change of the load (rows) per displacement (columns)");
  const UnitSystem units = report.units();
  const std::array<const char*, 5> loads{"Fx", "Fy", "Fz", "My", "Mz"},
      motions{"x", "y", "z", "rot y", "rot z"};
  const auto load_unit = [](std::size_t k) -> const UnitPair& {
    return k < 3 ? unit::kForce : unit::kMoment;
  };
  const auto motion_unit = [](std::size_t k) -> const UnitPair& {
    return k < 3 ? unit::kLength : unit::kRadian;
  };
  const auto K = zero_rounding_noise(solution.stiffness);
  std::vector<Report::Column> columns;
  std::vector<Report::Row> rows;
  for (std::size_t i = 0; i < 5; ++i) {
    columns.push_back(
        {fmt::format("{} [{}]", motions[i], unit_name(motion_unit(i), units)), nullptr});
    Report::Row row{fmt::format("{} [{}]", loads[i], unit_name(load_unit(i), units)), {}};
    for (std::size_t j = 0; j < 5; ++j) {
      const double entry = K(static_cast<int>(i), static_cast<int>(j));
      row.values.push_back(from_si(entry, load_unit(i), units) * to_si(1.0, motion_unit(j), units));
    }
    rows.push_back(std::move(row));
  }
  report.table("per", columns, rows, 14);
}

void print_quasi_static(Report& report, const statics::StaticSolution& solution,
                        const bearing::Bearing& bearing) {
  report.new_page("QUASI-STATIC EQUILIBRIUM");
  print_race_equilibrium(report, solution, bearing);
  ball_contacts(report, solution);
  print_race_stiffness(report, solution);
  balls(report, solution, bearing);
  split_races(report, solution, bearing);
  if (solution.films) print_films(report, *solution.films, "ball");
  print_cage_operation(report, bearing);
  if (solution.notes.empty()) return;
  report.heading("Notes");
  for (const Finding& note : solution.notes) report.text(note.message);
}

}  // namespace adore::listing
