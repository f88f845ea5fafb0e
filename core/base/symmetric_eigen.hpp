#pragma once

#include <Eigen/Core>

namespace adore {

/// Eigenvalues of a symmetric matrix, ascending, in the unit of its entries, and unit eigenvectors
/// as columns in the same order. NaN where the matrix is not finite.
template <int N>
struct SymmetricEigen {
  Eigen::Matrix<double, N, 1> values;
  Eigen::Matrix<double, N, N> vectors;
};

/// By implicit QR (Eigen's SelfAdjointEigenSolver), compiled once for the sizes in use; reads the
/// lower triangle.
template <int N>
[[nodiscard]] SymmetricEigen<N> symmetric_eigen(const Eigen::Matrix<double, N, N>& matrix);

extern template SymmetricEigen<2> symmetric_eigen<2>(const Eigen::Matrix2d&);
extern template SymmetricEigen<3> symmetric_eigen<3>(const Eigen::Matrix3d&);
extern template SymmetricEigen<5> symmetric_eigen<5>(const Eigen::Matrix<double, 5, 5>&);

}  // namespace adore
