#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

/// Numbers that are zero but for rounding (a side force under a load without a side) as zeros, so
/// that a listing does not show noise as a result.
namespace adore::listing {

/// Zero for entries below 1e-10 of the largest of five displacements or loads of a race: x, y, z,
/// about y, about z. `arm` [m] compares one kind with the other (radius for displacements: r φ with
/// a length; for loads pass 1/r).
[[nodiscard]] inline std::array<double, 5> zero_rounding_noise(std::array<double, 5> v,
                                                               double arm) {
  double largest = 0.0;
  for (std::size_t k = 0; k < 5; ++k)
    largest = std::fmax(largest, std::abs(v[k]) * (k < 3 ? 1.0 : arm));
  for (std::size_t k = 0; k < 5; ++k)
    if (std::abs(v[k]) * (k < 3 ? 1.0 : arm) < 1e-10 * largest) v[k] = 0.0;
  return v;
}

/// Zero for entries of a stiffness below 1e-9 of the geometric mean of their diagonal entries (the
/// differences of a race are good to that).
[[nodiscard]] inline Eigen::Matrix<double, 5, 5> zero_rounding_noise(
    Eigen::Matrix<double, 5, 5> K) {
  const Eigen::Matrix<double, 5, 1> diagonal = K.diagonal().cwiseAbs().cwiseSqrt();
  for (Eigen::Index i = 0; i < 5; ++i)
    for (Eigen::Index j = 0; j < 5; ++j)
      if (i != j && std::abs(K(i, j)) < 1e-9 * diagonal(i) * diagonal(j)) K(i, j) = 0.0;
  return K;
}

/// Zero below 1e-12 of what the value would be compared with (1: a ratio of order one).
[[nodiscard]] inline double zero_rounding_noise(double value, double scale = 1.0) {
  return std::abs(value) < 1e-12 * scale ? 0.0 : value;
}

}  // namespace adore::listing
