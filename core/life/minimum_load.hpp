#pragma once

/// Least load at which the elements roll instead of sliding. Rules of SKF, Rolling bearings, PUB
/// BU/P1 17000 EN (2018): maker's estimates of an order of magnitude, not results of the model.
///
///   share of a rating: 0.01 C (ball), 0.02 C (roller); spherical roller 0.01 C0
///   deep groove, self-aligning: kr (nu n/1000)^(2/3) (dm/100)^2 [kN]
///   cylindrical roller: kr (6 + 4 n/n_r) (dm/100)^2 [kN], n_r: reference speed
///   spherical roller with oil: 0.003 C0 to n/n_r = 0.3, then 0.003 C0 (1 + 2 sqrt(n/n_r - 0.3))
///   thrust ball: A (n/1000)^2 [kN]; thrust roller: 0.0005 C0 + A (n/1000)^2
/// kr and A are the maker's factors of the size. nu [mm^2/s], n [rpm], dm [mm], loads [N].
namespace adore::life {

[[nodiscard]] double minimum_load_of_balls(double kr, double viscosity, double rpm, double mean_mm);
[[nodiscard]] double minimum_load_of_rollers(double kr, double speed_ratio, double mean_mm);
/// @param speed_ratio n/n_r, up to 2
[[nodiscard]] double minimum_load_of_spherical_rollers(double static_rating, double speed_ratio);
/// @param static_rating 0: thrust ball bearing
[[nodiscard]] double minimum_thrust(double A, double rpm, double static_rating);

}  // namespace adore::life
