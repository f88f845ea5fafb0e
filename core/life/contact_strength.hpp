#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "scene/snapshot.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

/// Do the materials stay elastic under the heaviest contacts?
///
/// Below a Hertz contact of largest pressure p the largest von Mises stress on its axis is c p,
/// with c of the ellipticity b/a and of Poisson's ratio of the stressed body (stress_life.hpp: 0.62
/// for a circle, 0.56 for a line, at 0.3). Yield begins where c p exceeds the elastic limit, which
/// is the elastic strain limit (records 8.x, materials.json) times Young's modulus, a uniaxial
/// stress. A material whose strain limit is 0 has none known and is not judged. Edge stresses are
/// not in p.
namespace adore::life {

/// One body of the contact of largest pressure at one race.
struct ContactStrength {
  int element = 0;             ///< 1-based; 0: no contact at this race is loaded
  double pressure = 0.0;       ///< p [Pa]
  double von_mises = 0.0;      ///< c p [Pa]
  double elastic_limit = 0.0;  ///< [Pa]; 0: not known
  [[nodiscard]] bool yields() const { return elastic_limit > 0.0 && von_mises > elastic_limit; }
};

/// By race (outer, inner), then [0] the race and [1] the rolling element.
using RaceStrength = std::array<std::array<ContactStrength, 2>, 2>;

[[nodiscard]] RaceStrength contact_strength(const bearing::Bearing& bearing,
                                            const statics::StaticSolution& solution);
[[nodiscard]] RaceStrength contact_strength(const bearing::Bearing& bearing,
                                            const statics::RollerSolution& solution);
/// The contact of largest pressure at one race.
struct MaxPressureContact {
  int element = 0;        ///< 1-based; 0: none is loaded
  double pressure = 0.0;  ///< [Pa]
  double ratio = 0.0;     ///< b/a, 0: a line
};
using MaxPressureContacts = std::array<MaxPressureContact, 2>;  ///< outer, inner race
/// Of one instant of a motion; quick. @param lines the elements are rollers
[[nodiscard]] MaxPressureContacts max_pressure_contacts(
    std::span<const scene::ElementSnapshot> elements, bool lines);
[[nodiscard]] RaceStrength contact_strength(const bearing::Bearing& bearing,
                                            const MaxPressureContacts& heaviest);

/// A finding of this code for each body that yields, with element, race, stress and limit; empty
/// when all stay elastic.
[[nodiscard]] std::vector<Finding> strength_warnings(const char* code,
                                                     const bearing::Bearing& bearing,
                                                     const RaceStrength& strength);

}  // namespace adore::life
