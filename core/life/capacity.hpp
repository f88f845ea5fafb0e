#pragma once

#include "life/constants.hpp"

/// Original Lundberg-Palmgren theory: the contact load that a race endures for 1e6 revolutions.
namespace adore::life {

/// Inputs of the capacity of one race contact. Point contacts use the radii, line contacts
/// the length.
struct CapacityGeometry {
  double diameter = 0.0;  ///< D of the rolling element [m]
  double gamma = 0.0;     ///< D cos α / d_m, α the contact angle of the solution
  double cos_alpha = 1.0;
  int count = 0;                ///< Z
  bool inner = true;            ///< race
  double profile_radius = 0.0;  ///< transverse radius of the element [m]; D/2 for a ball
  double groove_radius = 0.0;   ///< transverse radius of the race [m]; f D; infinite: no groove
  double length = 0.0;          ///< effective length of a line contact [m]
};

/// Q_c = A λ (2R/D · r/(r-R))^0.41 (1∓γ)^1.39/(1±γ)^(1/3) (γ/cos α)^0.3 D^1.8 Z^(-1/3), upper sign
/// inner race [N]; for a ball R = D/2, r = fD the conformity term is (2f/(2f-1))^0.41.
/// Past α = 90° γ changes its sign, as the curvature around the bearing does, and γ/cos α = D/d_m
/// stays [derived]. A = 98.0665 N/mm^1.8 (seen). D^1.8 at every size: the 3.647 D^1.4 above 25.4 mm
/// belongs to the rating standards. [lundberg1947]
/// @throws InputError when the groove does not embrace the element or a size is not positive.
[[nodiscard]] double point_capacity(const CapacityGeometry& geometry, double factor = 1.0);

/// Q_c = B λ (1∓γ)^(29/27)/(1±γ)^(1/4) (γ/cos α)^(2/9) D^(29/27) l^(7/9) Z^(-1/4) [N],
/// B = 551.134 (seen; often printed 552). [lundberg1952]
/// @throws InputError
[[nodiscard]] double line_capacity(const CapacityGeometry& geometry, double factor = 1.0);

/// (Q_c/Q)^3 for a point, (Q_c/Q)^4 for a line contact; infinite for Q <= 0 [1e6 revolutions].
[[nodiscard]] double lundberg_palmgren_life(double capacity, double load, bool line);

}  // namespace adore::life
