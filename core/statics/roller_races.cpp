#include "statics/roller_races.hpp"

#include "contact/tapered_geometry.hpp"

namespace adore::statics {

RollerRaces bench_races(bearing::Type type, const bearing::RollerGeometry& g) {
  RollerRaces race;
  switch (type) {
    case bearing::Type::Spherical:
      race = contact::spherical_row(g.diameter, g.pitch_diameter, g.race_angle[0], g.crown_radius,
                                    g.groove_factor, g.clearance)
                 .race;
      break;
    case bearing::Type::Tapered:
      race = contact::tapered_races(contact::tapered_geometry(g.diameter, g.race_angle));
      break;
    case bearing::Type::SphericalTapered:
      race = contact::grooved_tapered_races(contact::tapered_geometry(g.diameter, g.race_angle),
                                            g.crown_radius, g.groove_factor);
      break;
    default:
      for (int j = 0; j < 2; ++j) {
        race[static_cast<std::size_t>(j)] = contact::cylinder_race(
            j, contact::cylindrical_race_radius(j, g.pitch_diameter, g.diameter, g.clearance));
      }
  }
  for (std::size_t j = 0; j < 2; ++j) {
    if (g.land_width[j] > 0.0 && g.shape != bearing::RollerShape::Arc) {
      race[j].land_width = g.land_width[j];
    }
    if (g.race_crown_radius[j] > 0.0) {
      race[j] = contact::crowned_race(race[j], g.race_crown_radius[j], g.race_central_length[j]);
    }
  }
  return race;
}

std::array<contact::RaceGrowth, 2> race_growths(bearing::Type type,
                                                const bearing::RollerGeometry& rollers) {
  if (!rollers.bench) {
    return {};
  }
  const RollerRaces bench = bench_races(type, rollers.unmounted_geometry());
  const double held = type == bearing::Type::Spherical ? bench[0].groove_x : 0.0;
  const auto& growth = rollers.bench->growth;
  return {contact::race_growth(growth[0], bench[0], held),
          contact::race_growth(growth[1], bench[1], held)};
}

RollerRaces race_surfaces(const bearing::Bearing& b) {
  RollerRaces race = bench_races(b.type, b.rollers()->unmounted_geometry());
  if (b.rollers()->bench) {
    const auto growth = race_growths(b.type, *b.rollers());
    for (std::size_t j = 0; j < 2; ++j) {
      race[j] = contact::grown(race[j], growth[j]);
    }
  }
  return race;
}

}  // namespace adore::statics
