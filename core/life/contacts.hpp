#pragma once

#include "bearing/bearing.hpp"
#include "life/stress_life.hpp"
#include "scene/snapshot.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

/// Input of the life models for any type of bearing: one geometry, one list of contacts
/// per race. Every solution (balls or rollers, at rest or in motion) is converted to it.
namespace adore::life {

/// Index [0] outer race, [1] inner race.
struct LifeGeometry {
  bool line = false;             ///< rollers: lines or points by contact_shape; else points
  int count = 0;                 ///< Z
  double diameter = 0.0;         ///< D, of a tapered or barrel roller at mid-length [m]
  double pitch_diameter = 0.0;   ///< d_m [m]
  double nominal_angle = 0.0;    ///< [rad]
  double length = 0.0;           ///< effective length of a line contact [m]
  std::array<double, 2> land{};  ///< straight land in the middle of a roller's contact [m]
  std::array<double, 2> profile_radius{};  ///< point contact: transverse radius of the element,
                                           ///< with the crown of the race [m]
  std::array<double, 2> groove_radius{};   ///< point contact: transverse radius of the races [m];
                                           ///< infinite: straight raceway
};

/// Load on one half of a split race that does the damage of both contacts of a ball: lives of point
/// contacts go with Q^-3. Both halves count as one track, up to 7 % more damage than on two
/// [derived].
[[nodiscard]] inline double equivalent_split_race_load(double first, double second) {
  return second > 0.0 ? std::cbrt(first * first * first + second * second * second) : first;
}

/// Contacts of one race. patches[element * slices + slice]; a roller's slices have the same order
/// on every element, because slice k of all elements shares one track on the race. Balls on a split
/// race have two tracks: its halves.
struct RaceContacts {
  std::vector<ContactPatch> patches;
  /// Rollers: the Hertz ellipse of each one's whole load, its crown against the race; empty without
  /// a crown that could make one.
  std::vector<ContactPatch> ellipses;
  double angle = 0.0;    ///< contact angle: mean of the loaded elements, or the nominal one [rad]
  bool rotating = true;  ///< turns relative to the direction of the load
};

struct BearingContacts {
  std::size_t slices = 1;
  std::array<RaceContacts, 2> race;
  double relative_speed = 0.0;  ///< |Ω_inner - Ω_outer| [rad/s]
  /// Λ by race, of the most loaded contact; empty: no film is computed.
  std::array<std::optional<double>, 2> film_parameter;
  /// Turns of each element about its own axis per relative ring turn; empty: pure rolling,
  /// d_m(1-γ²)/(2D).
  std::vector<double> element_turns;
};

[[nodiscard]] LifeGeometry ball_life_geometry(const bearing::BallGeometry& balls);

/// From a quasi-static solution. A race is taken as rotating when its speed is not zero (the load
/// of the deck keeps its direction); with both races at rest the inner one counts as rotating.
[[nodiscard]] BearingContacts life_contacts(const statics::StaticSolution& solution,
                                            const bearing::Bearing& bearing);
/// A line is as long as the roller without its corners.
[[nodiscard]] LifeGeometry roller_life_geometry(const bearing::RollerGeometry& rollers);
/// From a quasi-static solution of rollers, at the operating geometry and moduli. A slice is a
/// patch of half its width, its half width along the rolling direction that of the line contact
/// with the same load and pressure; with RollerContact::Point one slice as long as the roller.
[[nodiscard]] BearingContacts life_contacts(const statics::RollerSolution& solution,
                                            const bearing::Bearing& bearing);
/// From one instant of a dynamic run, with the elements' own spin.
[[nodiscard]] BearingContacts life_contacts(const scene::Snapshot& snapshot,
                                            const bearing::Bearing& bearing);

}  // namespace adore::life
