#include "base/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>

namespace adore {

template <int N>
SymmetricEigen<N> symmetric_eigen(const Eigen::Matrix<double, N, N>& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

template SymmetricEigen<2> symmetric_eigen<2>(const Eigen::Matrix2d&);
template SymmetricEigen<3> symmetric_eigen<3>(const Eigen::Matrix3d&);
template SymmetricEigen<5> symmetric_eigen<5>(const Eigen::Matrix<double, 5, 5>&);

}  // namespace adore
