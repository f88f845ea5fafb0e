#include "tribology/law_spread.hpp"

#include "tribology/film_law.hpp"
#include "tribology/lubricant.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {

std::vector<LawSpreadRow> law_spread(int code, const LawSpreadContact& contact,
                                     const std::vector<double>& slips) {
  const Oil oil = oil_of(code);
  std::vector<LawSpreadRow> out;
  for (const int one : oil.codes) {
    bearing::Lubrication lubrication;
    lubrication.code = one;
    lubrication.meniscus = contact.meniscus;
    lubrication.stress_limit = contact.stress_limit;
    lubrication.direct_strips = true;  // few points: no surface is worth its time
    RaceFilmInputs surface;
    surface.line = contact.line;
    surface.radius = 1.0 / contact.point.curvature;
    surface.modulus = contact.modulus;
    surface.wall_temperature = contact.temperature;
    surface.race_speed = std::abs(contact.point.entrainment);
    surface.width_over_pressure = contact.point.half_minor / contact.point.peak_pressure;
    const Lubricant of = lubricant_of(lubrication);
    const TractionLaw law = film_law({}, of, lubrication, surface);
    LawSpreadRow row{one, of.name, one == oil.recommended, {}};
    for (const double slip : slips) {
      ContactConditions<double> at = contact.point;
      at.slip = slip;
      row.kappa.push_back(law.visit([&](const auto& film) {
        if constexpr (kHasFilm<std::decay_t<decltype(film)>>)
          return film.at(at).strip(at.peak_pressure)(slip);
        else
          return 0.0;
      }));
    }
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace adore::tribology
