#pragma once

#include "thermal/ring.hpp"

#include <array>

/// Fits and clearances of a mounted bearing of any type, on plain numbers. SI: radii and lengths
/// [m], clearances diametral [m], speeds [rad/s], displacements outward [m]; arrays are [0] outer
/// race, [1] inner race.
///
/// The rule of superposition: free thermal growth r g, centrifugal growth u_w and the growth under
/// fit pressure u_p are added (linear elasticity; ring.hpp). A part is free to grow by g = ε(T) -
/// ε(T_room) of its material. The clearance given by the deck is that of the unmounted bearing
/// at room temperature and rest. Mounted at room temperature and at rest is the same calculation
/// with g = 0 and w = 0 (at_rest).
namespace adore::thermal {

/// One ring, sleeve or disc.
struct RingPart {
  Elastic elastic;
  double inner = 0.0;   ///< radius [m]; 0: solid
  double outer = 0.0;   ///< radius [m]; not above inner: no wall, which carries no fit
  double growth = 0.0;  ///< g, thermal strain from room temperature [-]
  double speed = 0.0;   ///< [rad/s], either sign

  /// Thermal and centrifugal displacement at r, without any pressure [m].
  [[nodiscard]] double free_displacement(double r) const;
};

struct MountedRings {
  RingPart shaft;               ///< shaft bore .. bearing bore
  RingPart inner;               ///< bearing bore .. inner raceway (groove bottom)
  RingPart outer;               ///< outer raceway .. bearing outside
  RingPart housing;             ///< bearing outside .. housing outside
  std::array<double, 2> fit{};  ///< diametral allowance at room temperature, > 0 interference [m]
};

/// The same parts cold and at rest.
[[nodiscard]] MountedRings at_rest(MountedRings rings);

struct MountedState {
  MountedRings rings;
  /// Operating diametral interference [m]: I1 = fit1 + 2 (U_outer - U_housing), I2 = fit2 + 2
  /// (U_shaft - U_inner) with the free displacements U at the interface; < 0 is a running
  /// clearance.
  std::array<double, 2> interference{};
  std::array<double, 2> pressure{};  ///< fit pressure [Pa], >= 0

  /// Displacement of a race at r: thermal + centrifugal + under its fit's pressure. A land radius
  /// outside the ring (a shoulder) uses the same formulas at that r.
  [[nodiscard]] double race_displacement(int race, double r) const;
  /// The part of it that the fit pressure causes.
  [[nodiscard]] double fit_pressure_displacement(int race, double r) const;
  /// Hoop stress of largest size, with its sign, in the race, and in the housing (0) or shaft (1)
  /// around it [Pa].
  [[nodiscard]] double race_hoop_stress(int race) const;
  [[nodiscard]] double mating_part_hoop_stress(int race) const;
};

[[nodiscard]] MountedState mount(const MountedRings& rings);

/// Diametral clearance after the raceways moved by u (outward) and the elements grew by dD [m]; < 0
/// is preload:
///   Pd' = Pd + 2 (u_outer - u_inner) - 2 dD.
[[nodiscard]] double operating_clearance(double clearance, const std::array<double, 2>& u,
                                         double element_growth);

/// Free contact angle of a ball bearing [rad]: cos α = 1 - Pd/(2A) with the distance A of the
/// curvature centers; 0 when Pd <= 0 (and when Pd >= 4A, where no such angle exists).
[[nodiscard]] double contact_angle(double clearance, double centre_distance);
/// Free axial clearance 2 A sin α of the circular grooves [m].
[[nodiscard]] double end_play(double centre_distance, double contact_angle);

/// A race split in the middle and ground by a shim s, of groove radius r:
///   sin α_s = s/(2r - D);  Pd of the circular groove = measured + (2r - D)(1 - cos α_s);  end play
///   = 2A sin α - s.
/// @throws InputError when the shim is negative or reaches 2r - D.
struct SplitRace {
  double shim_angle = 0.0;     ///< α_s [rad]
  double clearance = 0.0;      ///< Pd of the circular groove [m]
  double contact_angle = 0.0;  ///< [rad]
  double end_play = 0.0;       ///< [m]
};
[[nodiscard]] SplitRace split_race(double groove_radius, double ball_diameter, double shim,
                                   double measured_clearance, double centre_distance);

/// Diametral clearance between cage and race at a guide land [m]: the race's land radius moves by
/// u_race, the cage's by u_cage. Outer race: 2 (r + u_race - r_cage - u_cage); inner race: the
/// negative.
[[nodiscard]] double land_clearance(int race, double race_radius, double u_race, double cage_radius,
                                    double u_cage);

/// Pocket clearance after cage and element grew: (D + C)(1 + g_cage) - D (1 + g_element) [m].
[[nodiscard]] double pocket_clearance(double clearance, double element_diameter, double g_cage,
                                      double g_element);

/// Displacement of a cage at r: thermal, and centrifugal for a one-piece cage. A segmented cage has
/// no hoop stiffness and gets no centrifugal growth.
[[nodiscard]] double cage_displacement(const RingPart& cage, double r, bool one_piece);

/// A roller bearing, measured radially.
struct RollerSizes {
  double diameter = 0.0, length = 0.0,
         crown_radius = 0.0;    ///< [m]; crown radius 0 or infinite: straight
  double pitch_diameter = 0.0;  ///< [m]
  double clearance = 0.0;       ///< diametral [m]
};
struct RollerOperatingGeometry {
  RollerSizes geometry;  ///< in operation
  std::array<double, 2> raceway_displacement{};
  double axial_setting_change = 0.0;  ///< tapered only, see tapered_setting_change [m]
};
/// Clearance as for balls; roller dimensions times (1 + g_element); pitch circle midway between the
/// raceways. The raceway radii are those of the rings (rings.outer.inner, rings.inner.outer); for
/// cones give the mean ones.
/// @param outer_half_angle angle of the outer raceway to the axis [rad]; 0: cylindrical or
/// spherical
[[nodiscard]] RollerOperatingGeometry roller_operating_geometry(const MountedState& state,
                                                                const RollerSizes& free,
                                                                double element_growth,
                                                                double outer_half_angle);

/// Axial setting of a tapered bearing whose radial clearance changed by dPd [m] (diametral):
/// -(dPd/2)/tan β_o, positive when clearance was lost. Approximate: cone and cup move along each
/// other at constant half angle β_o of the outer raceway.
/// @throws InputError when β_o is not between 0 and 90 degrees.
[[nodiscard]] double tapered_setting_change(double clearance_change, double outer_half_angle);

}  // namespace adore::thermal
