#include "statics/roller_race_law.hpp"

#include "base/instruction_set.hpp"

#include <algorithm>
#include <cmath>

namespace adore::statics {

tribology::RaceFilmInputs roller_film_surface(const bearing::Bearing& bearing, std::size_t race,
                                              double E_star, bool single) {
  const bearing::RollerGeometry& g = *bearing.rollers();
  const double roller = 0.5 * bearing.element_diameter(),
               of_race = g.race_radius(static_cast<int>(race));
  tribology::RaceFilmInputs surface;
  surface.line = true;
  surface.radius = 1.0 / (1.0 / roller + (race == 0 ? -1.0 : 1.0) / of_race);
  surface.modulus = 2.0 * E_star;
  surface.wall_temperature = 0.5 * (bearing.race_temperature[race] + bearing.element_temperature);
  surface.race_speed = 0.5 * bearing.pitch_diameter() *
                       std::max(std::abs(bearing.speed[0]), std::abs(bearing.speed[1]));
  surface.width_over_pressure = 2.0 * surface.radius / E_star;
  surface.walls = {tribology::film_wall(bearing.race_material[race]),
                   tribology::film_wall(bearing.element_material)};
  surface.single = single;
  return surface;
}

tribology::TractionLaw roller_race_law(const bearing::Bearing& bearing,
                                       const tribology::RaceFilmInputs& surface) {
  if (!bearing.lubrication) return bearing.race_traction;
  return tribology::film_law(bearing.race_traction, tribology::lubricant_of(*bearing.lubrication),
                             *bearing.lubrication, surface);
}

RollerKernel roller_kernel() noexcept {
#if defined(__x86_64__)
  const InstructionSet set = chosen_instruction_set();
  if (set == InstructionSet::Avx512) return roller_kernel_avx512;
  if (set == InstructionSet::Avx2) return roller_kernel_avx2;
#endif
  return roller_kernel_baseline;
}

RollingResistanceKernel rolling_resistance_kernel() noexcept {
#if defined(__x86_64__)
  const InstructionSet set = chosen_instruction_set();
  if (set == InstructionSet::Avx512) return roller_rolling_resistance_avx512;
  if (set == InstructionSet::Avx2) return roller_rolling_resistance_avx2;
#endif
  return roller_rolling_resistance_baseline;
}

}  // namespace adore::statics
