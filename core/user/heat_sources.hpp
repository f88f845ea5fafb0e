#pragma once

#include "bearing/bearing.hpp"
#include "scene/snapshot.hpp"
#include "user/adore_user.h"

#include <array>
#include <string_view>
#include <vector>

/// Where heat arises at one instant, for ADRX9: every contact of elements and races with place and
/// size; roller ends at flanges, pockets and guide lands at their places; of every other item of
/// the energy ledger what it dissipates as a whole. Their sum is the ledger's heat rate, by
/// construction: what the details of an item leave of it is a source without a place.
///
/// Places [m, base frame], C the centre of the element, a its axis, m the direction of the wall by
/// the stored angles of the pocket, in the frame of the element's azimuth:
///   pocket  C + R m (balls), C + s a + R m (rollers, s the place along the wall); the surfaces of
///   a
///           pocket share its heat as its force, without force the nearest one has it;
///   land    c + T (x e_x + R_l e_r(angle of the least gap)), c and T of the cage, R_l of the land;
///   flange  C ± L/2 a, at the height of the contact above the raceway of the roller.
/// Limits: the tilt of the cage (its clearance over its diameter) is left out of the direction m,
/// and skew of the roller out of the azimuth of a flange contact.
namespace adore::user {

class HeatSources {
 public:
  /// Of the bearing, what places of contacts need.
  struct Geometry {
    struct Land {
      double x = 0.0, radius = 0.0;  ///< middle from the cage's center, on the cage [m]
      int race = -1;
    };
    double element_radius = 0.0, half_length = 0.0;  ///< rollers: half the length [m]
    double rotation_sign = 1.0;                      ///< of the cage
    bool rollers = false;
    std::vector<Land> lands;
  };
  [[nodiscard]] static Geometry geometry_of(const bearing::Bearing& bearing);
  HeatSources(const scene::Snapshot& snapshot, const Geometry& geometry);
  /// Points into this object and the snapshot's ledger terms.
  [[nodiscard]] adore_adrx9 arguments() const;

 private:
  struct Place {
    double x = 0.0, y = 0.0, z = 0.0, across = 0.0, along = 0.0;
  };
  /// Heat of one ledger term that has a place, by race [W].
  struct TermHeatSum {
    std::string_view id;
    std::array<double, 2> sum{};
  };
  void add_flanges(const scene::Snapshot& snapshot, std::size_t i, const Geometry& geometry);
  void add_pocket(const scene::Snapshot& snapshot, std::size_t i, const Geometry& geometry);
  void add_land(const scene::CageSnapshot& cage, std::size_t k, const Geometry& geometry);
  void add(int kind, int element, int race, double heat, const Place& place, const char* name);

  double step_size_, total_heat_;
  std::array<TermHeatSum, 2> flange_heat_sums_{{{"flange_heat"}, {"flange_damping"}}};
  std::vector<double> x_, r_, theta_, load_, angle_, heat_, place_, size_;
  std::vector<std::int32_t> kind_, element_, race_;
  std::vector<const char*> name_;
};

}  // namespace adore::user
