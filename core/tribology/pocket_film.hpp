#pragma once

/// Rigid, isoviscous films between a rolling element and its cage pocket. SI.
namespace adore::tribology {

/// Wedge of a point contact (Brewe, Hamrock & Taylor 1979, recalled, inverted):
///   w = μ u Rx √(128 a Rx/h) λ (0.131 atan(a/2) + 1.683),  a = Ry/Rx <= 100,  λ = 1/(1 + 2/(3a)).
/// @param speed mean speed of both surfaces [m/s]; along x
[[nodiscard]] double point_wedge_force(double viscosity, double speed, double along, double across,
                                       double gap);

/// Squeeze of a sphere of radius R: -6π μ R² ḣ/h for ḣ < 0; 0 while it opens (cavitation).
[[nodiscard]] double sphere_squeeze_force(double viscosity, double radius, double gap,
                                          double gap_rate);

/// Wedge of a line contact (Martin 1916, recalled): 4.896 μ u R L/h. Shear in it at slip u, flow
/// between a cylinder and a plane, μ u L ∫dx/h = π √2 μ u L √(R/h) (own derivation).
/// @param speed mean speed of both surfaces [m/s]
[[nodiscard]] double line_wedge_force(double viscosity, double speed, double radius, double length,
                                      double gap);
[[nodiscard]] double line_shear_force(double viscosity, double slip, double radius, double length,
                                      double gap);

/// Squeeze of a cylinder of length L: -3√2 π μ L ḣ (R/h)^1.5 for ḣ < 0 (own derivation).
[[nodiscard]] double cylinder_squeeze_force(double viscosity, double radius, double length,
                                            double gap, double gap_rate);

}  // namespace adore::tribology
