#pragma once

#include "bearing/bearing.hpp"
#include "deck/deck.hpp"
#include "listing/report.hpp"

#include <nlohmann/json_fwd.hpp>

/// The cage in PRINT.txt and RUN.json, of balls and rollers alike.
namespace adore::listing {

/// Sizes, pockets, lands and mass of the geometry page.
void print_cage_geometry(Report& report, const bearing::Bearing& bearing, const deck::Deck& deck);

/// Guidance of the cage in operation, for the quasi-static page: speed, smallest clearance, mass.
/// Nothing without a cage, or when the bearing is not the operating one.
void print_cage_operation(Report& report, const bearing::Bearing& bearing);

/// The same for RUN.json. @pre a cage, and a bearing in operation
[[nodiscard]] nlohmann::ordered_json cage_json(const bearing::Bearing& bearing);

}  // namespace adore::listing
