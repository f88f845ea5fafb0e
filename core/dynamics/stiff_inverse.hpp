#pragma once

#include "base/symmetric_eigen.hpp"

#include <vector>

namespace adore::dynamics {

/// Far below the stiffness of any contact that carries load [N/m].
inline constexpr double kNoStiffness = 1e-6;

/// Inverse of a symmetric matrix on the directions whose stiffness is above `smallest`, 0 on the
/// others, which `free` receives as unit vectors.
template <int N>
Eigen::Matrix<double, N, N> stiff_inverse(
    const Eigen::Matrix<double, N, N>& stiffness, double smallest,
    std::vector<Eigen::Matrix<double, N, 1>>* free = nullptr) {
  const SymmetricEigen<N> eigen = symmetric_eigen<N>(stiffness);
  Eigen::Matrix<double, N, N> inverse = Eigen::Matrix<double, N, N>::Zero();
  for (int k = 0; k < N; ++k) {
    const double value = eigen.values[k];
    const Eigen::Matrix<double, N, 1> direction = eigen.vectors.col(k);
    if (value > smallest)
      inverse += direction * direction.transpose() / value;
    else if (free != nullptr)
      free->push_back(direction);
  }
  return inverse;
}

}  // namespace adore::dynamics
