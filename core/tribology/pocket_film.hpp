#pragma once

/// Rigid, isoviscous films between a rolling element and its cage pocket. SI.
namespace adore::tribology {

/// Wedge of a point contact (Brewe, Hamrock & Taylor 1979, recalled, inverted):
///   w = μ u Rx √(128 a Rx/h) λ (0.131 atan(a/2) + 1.683),  a = Ry/Rx <= 100,  λ = 1/(1 + 2/(3a)).
/// @param speed mean speed of both surfaces [m/s]; along x
[[nodiscard]] double pocket_wedge(double viscosity, double speed, double along, double across,
                                  double gap);

/// Squeeze of a sphere of radius R: -6π μ R² ḣ/h for ḣ < 0; 0 while it opens (cavitation).
[[nodiscard]] double sphere_squeeze(double viscosity, double radius, double gap, double gap_rate);

/// Squeeze of a cylinder of length L: -3√2 π μ L ḣ (R/h)^1.5 for ḣ < 0 (own derivation).
[[nodiscard]] double cylinder_squeeze(double viscosity, double radius, double length, double gap,
                                      double gap_rate);

}  // namespace adore::tribology
