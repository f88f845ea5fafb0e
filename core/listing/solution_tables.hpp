#pragma once

#include "bearing/bearing.hpp"
#include "listing/report.hpp"
#include "results/static_tables.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"
#include "statics/stiffness_table.hpp"

/// The tables of a quasi-static solution.
namespace adore::listing {

/// "ball", "cylindrical roller", ...
[[nodiscard]] const char* type_name(bearing::Type type);

/// Tables of a ball bearing: "elements" with azimuth, and per race load, contact angle, pressure
/// and the angles between which the contact ellipse lies, and, where the deck gives a shoulder, the
/// angle at which the groove ends.
[[nodiscard]] StaticTables static_tables(const statics::StaticSolution& solution,
                                         const bearing::Bearing& bearing, UnitSystem units);

/// Tables of a roller bearing: "elements" with azimuth, tilt, and per race load, moment, contact
/// angle, largest pressure, flange loads; "slices" along the most loaded roller.
[[nodiscard]] StaticTables static_tables(const statics::RollerSolution& solution,
                                         const bearing::Bearing& bearing, UnitSystem units);

/// "stiffness over speed": one row per speed with the speeds, the displacement, the largest contact
/// load and, as "Fx/x", "My/rot y" ..., every entry of the stiffness, with " by difference" behind
/// where that was computed; NaN at speeds without an equilibrium.
[[nodiscard]] StaticTable stiffness_over_speed(const std::vector<statics::StiffnessRow>& rows);

}  // namespace adore::listing
