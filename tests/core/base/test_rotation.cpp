#include "base/constants.hpp"
#include "base/rotation.hpp"

#include <catch2/catch.hpp>

#include <initializer_list>
#include <numbers>

using namespace adore;

namespace {

double off(const Vec3& angles, const Mat3& wanted) {
  return (passive_matrix(angles) - wanted).cwiseAbs().maxCoeff();
}

void check_ranges(const Vec3& angles) {
  CHECK(std::abs(angles[0]) <= kPi);
  CHECK(std::abs(angles[1]) <= 0.5 * kPi);
  CHECK(std::abs(angles[2]) <= kPi);
}

}  // namespace

TEST_CASE("rotation angles: eta about X, then xi about y', then lambda about z''",
          "[unit][rotation]") {
  // Each turn moves the axes that the ones before it have left.
  const Vec3 angles(0.4, -0.7, 1.1);
  Quat q{1, 0, 0, 0};
  for (int k = 0; k < 3; ++k)
    q = multiply(quaternion_about(rotation_matrix(q).col(k), angles[k]), q);
  CHECK((angles_from_quaternion(q) - angles).norm() < 1e-14);
  CHECK((rotation_matrix(q).transpose() - passive_matrix(angles)).norm() < 1e-14);
}

TEST_CASE("rotation angles: every attitude, also singular ones → reproduced", "[unit][rotation]") {
  const int parts = 24;  // of a turn: quarter and half turns among them
  for (int i = -parts; i <= parts; ++i)
    for (int k = -parts; k <= parts; ++k)
      for (const double side : {-1.0, 1.0})
        for (const double beside : {0.0, 1e-16, 1e-14, 1e-13, 9e-13, 1.1e-12, 1e-11, 1e-9, 1e-7,
                                    1e-4, 0.1, 1.0, 0.5 * kPi}) {
          const Vec3 given(i * kPi / parts, side * (0.5 * kPi - beside), k * kPi / parts);
          const Quat q = quaternion_from_angles(given);
          const Mat3 T = passive_matrix(given);
          for (const Vec3& found : {angles_from_matrix(T), angles_from_quaternion(q)}) {
            const double error = off(found, T);
            if (error > 2e-12 || std::abs(found[1] - given[1]) > 2e-12) {
              CAPTURE(given.transpose(), found.transpose());
              CHECK(error <= 2e-12);
              CHECK(std::abs(found[1] - given[1]) <= 2e-12);
            }
            check_ranges(found);
          }
          // Only the sum or difference is defined: eta takes it.
          if (beside < 5e-13) {
            const Vec3 found = angles_from_matrix(T);
            CHECK(found[2] == 0.0);
            CHECK(std::abs(std::remainder(found[0] - (given[0] + side * given[2]), 2.0 * kPi)) <
                  1e-11);
          } else if (beside > 1e-3) {
            const Vec3 found = angles_from_quaternion(q);
            for (const int a : {0, 2})
              CHECK(std::abs(std::remainder(found[a] - given[a], 2.0 * kPi)) < 1e-13);
          }
        }
}

TEST_CASE("rotation angles: quaternion of any length or sign → those of its attitude",
          "[unit][rotation]") {
  const Vec3 angles(2.0, -0.3, -1.2);
  const Quat q = quaternion_from_angles(angles);
  for (const double factor : {-1.0, 0.5, 1.0 + 1e-6, -3.0})
    CHECK((angles_from_quaternion({factor * q[0], factor * q[1], factor * q[2], factor * q[3]}) -
           angles)
              .norm() < 1e-14);
}

TEST_CASE("rotation angles: identity and half rotations → no negative zero", "[unit][rotation]") {
  const Vec3 none = angles_from_quaternion({1, 0, 0, 0});
  for (const double angle : none) CHECK_FALSE(std::signbit(angle));
  CHECK(angles_from_quaternion({0, 1, 0, 0})[0] == Approx(kPi));  // half a turn about X
}

TEST_CASE("tilt of an axis: X is rotated into it, also along Y", "[unit][rotation]") {
  const int parts = 16;
  for (int i = -parts; i <= parts; ++i)
    for (int k = -parts; k <= parts; ++k)
      for (const double beside : {0.0, 1e-15, 1e-13, 1e-11, 1e-6}) {
        const double xi = i * kPi / parts, lambda = 0.5 * k * kPi / parts - beside;
        const Vec3 axis = passive_matrix({0.0, xi, lambda}).row(0).transpose();
        const auto tilt = tilt_of_axis(axis);
        const Vec3 found = passive_matrix({0.0, tilt[0], tilt[1]}).row(0).transpose();
        CAPTURE(xi, lambda, tilt[0], tilt[1]);
        CHECK((found - axis).norm() < 2e-12);
        CHECK(std::abs(tilt[1]) <= 0.5 * kPi);
        // The angles of the frame that has not spun are the same.
        if (std::abs(xi) < 1.5 && std::abs(lambda) < 1.5) {
          const Vec3 angles = angles_from_matrix(passive_matrix({0.0, xi, lambda}));
          CHECK(angles[1] == Approx(tilt[0]).margin(1e-14));
          CHECK(angles[2] == Approx(tilt[1]).margin(1e-14));
        }
      }
  CHECK(tilt_of_axis(Vec3::UnitY())[0] == 0.0);
  CHECK(tilt_of_axis(-Vec3::UnitX())[0] == Approx(kPi));
}
