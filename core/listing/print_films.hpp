#pragma once

#include "listing/report.hpp"
#include "results/static_tables.hpp"
#include "statics/contact_films.hpp"

#include <string>

/// Lubricant films of a quasi-static solution in PRINT.txt and RUN.json, of balls and rollers
/// alike.
namespace adore::listing {

/// @param element "ball" or "roller"
void print_films(Report& report, const statics::LubricantFilms& films, const std::string& element);

/// Columns "outer film", "outer least film", "outer film parameter" ... of the elements' table; NaN
/// where there is no load.
void add_film_columns(results::StaticTable& elements, const statics::LubricantFilms& films);

}  // namespace adore::listing
