#include "listing/print_films.hpp"

#include "base/constants.hpp"
#include "listing/print_words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace adore::listing {
namespace {

std::string certainty(const std::string& provenance) {
  if (provenance == "given") return "from the deck";
  if (provenance == "seen") return "from a public source";
  if (provenance == "recalled") return "at least one value is not checked against a publication";
  return "AT LEAST ONE CONSTANT IS AN ESTIMATE for the class of the lubricant, not a measured "
         "value";
}

}  // namespace

void print_films(Report& report, const statics::LubricantFilms& films, const std::string& element) {
  report.heading("Lubricant films");
  report.item("Lubricant", films.lubricant);
  report.item("Source of the lubricant constants", certainty(films.provenance));
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string at = fmt::format("at the inlet of the {} race", kRaceName[j]);
    report.item("Temperature " + at, films.temperature[j], unit::kTemperature);
    report.item("Viscosity " + at, films.viscosity[j], unit::kViscosity);
    report.item("Pressure-viscosity coefficient " + at, films.alpha[j], unit::kPerStress);
  }
  report.item("Critical film thickness (thinner films: metallic contact)", films.critical_film,
              unit::kLength);
  report.item("Inlet meniscus distance divided by the contact half width", films.meniscus,
              unit::kPure);
  std::vector<Report::Row> rows;
  for (std::size_t k = 0; k < films.race[0].size(); ++k) {
    Report::Row row{std::to_string(k + 1), {}};
    for (const std::vector<statics::ElementFilm>& race : films.race) {
      const statics::ElementFilm& f = race[k];
      const bool film = f.film.isothermal > 0.0;
      for (const double value :
           {film ? f.film.central : kNaN, film ? f.film.minimum : kNaN,
            film ? f.film.thermal : kNaN, film ? f.film.starvation : kNaN, f.lambda})
        row.values.push_back(value);
    }
    rows.push_back(std::move(row));
  }
  report.text(
      "Columns. \"film\": central film thickness. \"least\": minimum film thickness. \"heat\", "
      "\"starve\": factors for inlet heating and starvation, which both thicknesses include. "
      "\"lambda\": minimum thickness divided by the composite roughness.");
  report.table(element,
               {{"film outer", &unit::kLength},
                {"least outer", &unit::kLength},
                {"heat", &unit::kPure},
                {"starve", &unit::kPure},
                {"lambda", &unit::kPure},
                {"film inner", &unit::kLength},
                {"least inner", &unit::kLength},
                {"heat", &unit::kPure},
                {"starve", &unit::kPure},
                {"lambda", &unit::kPure}},
               rows);
  for (std::size_t j = 0; j < 2; ++j)
    if (films.metal[j] > 0)
      report.text(
          fmt::format("Metallic contact (film thinner than the critical thickness): {} of the "
                      "loaded contacts with the {} race.",
                      films.metal[j], kRaceName[j]));
}

void add_film_columns(results::StaticTable& elements, const statics::LubricantFilms& films) {
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = fmt::format("{} ", kRaceName[j]);
    std::vector<double> central, minimum, lambda;
    for (const statics::ElementFilm& f : films.race[j]) {
      const bool film = f.film.isothermal > 0.0;
      central.push_back(film ? f.film.central : kNaN);
      minimum.push_back(film ? f.film.minimum : kNaN);
      lambda.push_back(f.lambda);
    }
    elements.add(race + "film", unit::kLength, std::move(central));
    elements.add(race + "least film", unit::kLength, std::move(minimum));
    elements.add(race + "film parameter", unit::kPure, std::move(lambda));
  }
}

}  // namespace adore::listing
