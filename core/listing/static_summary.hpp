#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "life/bearing_life.hpp"
#include "life/contact_strength.hpp"
#include "listing/report.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"

#include <array>
#include <limits>
#include <string>
#include <vector>

/// Main results of a quasi-static solution: one page of PRINT.txt, and a few lines
/// for the terminal and the run panel. SI inside; every printed number has its unit.
namespace adore::listing {

/// A number and the rolling element (1-based; 0: none) that it belongs to.
struct ElementValue {
  double value = std::numeric_limits<double>::quiet_NaN();
  int element = 0;
};

/// Extremes over the contacts of one race.
struct RaceSummary {
  ElementValue load;                     ///< largest Q [N]
  ElementValue pressure;                 ///< largest p [Pa]
  ElementValue least_angle, most_angle;  ///< of the loaded contacts [rad]
  ElementValue shoulder;                 ///< least depth below the shoulder (balls) [m]
  ElementValue flange;                   ///< largest load on a flange of this race (rollers) [N]
  int loaded = 0;                        ///< elements with a load
  int at_edge = 0;                       ///< rollers whose contact reaches a corner or land edge
};

struct StaticSummary {
  std::string element;  ///< "ball", "roller"
  int count = 0;
  std::array<RaceSummary, 2> race;
  life::RaceStrength strength;
  statics::RaceResult result;
};

[[nodiscard]] StaticSummary summarize(const statics::StaticSolution& solution,
                                      const bearing::Bearing& bearing);
[[nodiscard]] StaticSummary summarize(const statics::RollerSolution& solution,
                                      const bearing::Bearing& bearing);

/// The page. `warnings` and `notes` are counted, and shown as far as the page has room.
void print_static_summary(Report& report, const StaticSummary& summary,
                          const bearing::Bearing& bearing, const life::BearingLife& life,
                          const std::vector<std::string>& warnings,
                          const std::vector<Finding>& notes);

/// Displacement, largest contact load and pressure, life: one line each, in the deck's units.
[[nodiscard]] std::vector<std::string> summary_lines(const StaticSummary& summary,
                                                     const bearing::Bearing& bearing,
                                                     const life::BearingLife& life,
                                                     UnitSystem units);

/// In words, what displacements are measured from (decision 140).
[[nodiscard]] std::string displacement_datum_text(const bearing::Bearing& bearing,
                                                  UnitSystem units);

/// Tilt of the inner race relative to a misaligned outer one, about the outer race's y and then z
/// [rad]; both tilts are R = R_y R_z of the base frame.
[[nodiscard]] std::array<double, 2> relative_tilt(const std::array<double, 2>& inner,
                                                  const std::array<double, 2>& outer);

}  // namespace adore::listing
