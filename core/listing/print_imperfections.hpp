#pragma once

#include "bearing/bearing.hpp"
#include "listing/report.hpp"

#include <nlohmann/json_fwd.hpp>

/// Geometric imperfections in PRINT.txt and RUN.json: what each rolling element and its place on
/// the races differ by from the ideal bearing. Races are shown at the azimuth of each element in
/// the quasi-static solution, element 1 at the z axis.
namespace adore::listing {

/// Nothing when the deck asks for an ideal bearing.
void print_imperfections(Report& report, const bearing::Bearing& bearing);

/// The same numbers, SI; null when the deck asks for an ideal bearing.
[[nodiscard]] nlohmann::ordered_json imperfections_json(const bearing::Bearing& bearing);

}  // namespace adore::listing
