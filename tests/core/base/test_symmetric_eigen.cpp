#include "base/symmetric_eigen.hpp"

#include <catch2/catch.hpp>

#include <limits>

namespace {

template <int N>
void check_size() {
  using Matrix = Eigen::Matrix<double, N, N>;
  for (int k = 0; k < 20; ++k) {
    const Matrix any = Matrix::Random();
    const Matrix A = any + any.transpose();
    const auto found = adore::symmetric_eigen<N>(A);
    CAPTURE(N, k);
    CHECK((A * found.vectors - found.vectors * found.values.asDiagonal()).norm() <
          1e-14 * A.norm() * N);
    CHECK((found.vectors.transpose() * found.vectors - Matrix::Identity()).norm() < 1e-14 * N);
    for (int i = 1; i < N; ++i) CHECK(found.values[i] >= found.values[i - 1]);
  }
}

}  // namespace

TEST_CASE("symmetric_eigen(): symmetric matrix → orthonormal eigenvectors that solve the problem",
          "[unit][base]") {
  check_size<2>();
  check_size<3>();
  check_size<5>();
}

TEST_CASE("symmetric_eigen(): matrix that is not finite → no eigenvalues", "[unit][base]") {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  A(1, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(adore::symmetric_eigen<3>(A).values.allFinite());
}
