#include "base/rotation.hpp"
#include "dynamics/rigid_body.hpp"
#include "statics/kinematics.hpp"

#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::dynamics;

TEST_CASE("Angles, matrix and quaternion describe one attitude", "[unit][rotation]") {
  for (const Vec3& angles : {Vec3(0.1, 0.02, -0.03), Vec3(-2.8, 1.4, 3.0), Vec3(3.1, -1.2, 0.4)}) {
    const Quat q = quaternion_from_angles(angles);
    CHECK((rotation_matrix(q).transpose() - passive_matrix(angles)).norm() < 1e-14);
    CHECK((angles_from_quaternion(q) - angles).norm() < 1e-13);
    CHECK(norm(q) == Approx(1.0).margin(1e-15));
    CHECK(rotation_matrix(q).determinant() == Approx(1.0).margin(1e-14));
    CHECK((rotation_matrix(with_positive_w({-q[0], -q[1], -q[2], -q[3]})) - rotation_matrix(q))
              .norm() == 0.0);
  }
}

TEST_CASE("The quaternion rate is the derivative along the motion", "[unit][rotation]") {
  const Vec3 angles(0.4, 0.05, -0.02), rates(420.0, -3.0, 5.0);
  const double h = 1e-6;
  const Quat before = quaternion_from_angles(angles - h * rates),
             after = quaternion_from_angles(angles + h * rates);
  const Quat rate =
      quaternion_rate(quaternion_from_angles(angles), omega_from_angle_rates(angles, rates));
  for (std::size_t i = 0; i < 4; ++i)  // h² ω³/6 ~ 1e-5
    CHECK((after[i] - before[i]) / (2 * h) == Approx(rate[i]).margin(2e-5));
}

TEST_CASE("Azimuth directions are right-handed with the bearing axis", "[unit][rotation]") {
  for (const double psi : {0.0, 0.7, 3.0, -2.0}) {
    CHECK((Vec3::UnitX().cross(radial_direction(psi)) - circumferential_direction(psi)).norm() <
          1e-15);
    CHECK(azimuth(2.5 * radial_direction(psi)) == Approx(psi).margin(1e-14));
  }
}

TEST_CASE("Cylindrical coordinates give velocity and acceleration as time derivatives",
          "[physics][motion]") {
  const Vec3 place(1e-4, 0.023, 0.7), rates(0.02, -0.05, 420.0), second(30.0, -200.0, 1500.0);
  const auto position = [&](double t) {
    return from_cylindrical(place + t * rates + 0.5 * t * t * second, Vec3::Zero(), Vec3::Zero())
        .position;
  };
  const PointMotion motion = from_cylindrical(place, rates, second);
  const double h = 1e-5;
  CHECK(((position(h) - position(-h)) / (2 * h) - motion.velocity).norm() <
        1e-4 * motion.velocity.norm());
  CHECK(((position(h) - 2 * position(0) + position(-h)) / (h * h) - motion.acceleration).norm() <
        1e-4 * motion.acceleration.norm());
}

TEST_CASE("A body of revolution spins as Euler's equations say", "[physics][motion]") {
  const double polar = 4.9e-8, transverse = 6.4e-8;
  const Vec3 axis = Vec3(1.0, 0.02, -0.05).normalized(), omega(-3100.0, 12.0, -7.0),
             moment(0.002, 0.15, -0.08);
  const Mat3 I = transverse * Mat3::Identity() + (polar - transverse) * axis * axis.transpose();
  const SpinRates rates = axisymmetric_spin(polar, transverse, 510.0, omega, axis, moment);
  CHECK((rates.omega_inertial - euler_rate(I, omega, moment)).norm() <
        1e-12 * rates.omega_inertial.norm());
  CHECK((rates.omega_azimuth + 510.0 * Vec3::UnitX().cross(omega) - rates.omega_inertial).norm() <
        1e-9);
  CHECK(rates.axis_azimuth.dot(axis) == Approx(0.0).margin(1e-12));
}

TEST_CASE("Power of the moment is the rate of kinetic energy of a body with turned principal axes",
          "[physics][motion]") {
  RigidBody body;
  body.mass = 0.042;
  body.inertia = inertia_in_geometric_axes({2.1e-5, 1.15e-5, 1.2e-5}, {0.17, 0.03, -0.05});
  body.to_geometric_centre = {1e-4, -2e-5, 5e-5};
  CHECK((body.inertia - body.inertia.transpose()).norm() < 1e-20);
  CHECK(body.inertia.trace() == Approx(4.45e-5));
  const Vec3 omega(430.0, -6.0, 4.0), moment(0.01, 0.05, -0.02);
  const Vec3 rate = euler_rate(body.inertia, omega, moment);
  CHECK(omega.dot(body.inertia * rate) == Approx(moment.dot(omega)).epsilon(1e-12));
  CHECK(kinetic_energy(body, {1.0, 0.0, 0.0}, Vec3::Zero()) == Approx(0.021));
  // Geometric center of a turning body: differences of its path.
  const auto centre_velocity = [&](double t) {
    const Vec3 w = omega + t * rate;
    const Vec3 turn = omega * t;
    const Mat3 R = rotation_matrix(
        quaternion_about(turn.norm() > 0 ? Vec3(turn.normalized()) : Vec3::UnitX(), turn.norm()));
    return geometric_centre_velocity(body, R, Vec3::Zero(), w);
  };
  const double h = 1e-7;
  const Vec3 a = geometric_centre_acceleration(body, Mat3::Identity(), Vec3::Zero(), omega, rate);
  const Vec3 difference = (centre_velocity(h) - centre_velocity(0.0)) / h;
  CHECK((difference - a).norm() < 1e-3 * a.norm());  // one-sided: h ω/2 = 2e-5, and ω̇ h/2
}

TEST_CASE("The cage starts at its share of the epicyclic speed and whirls about the bearing axis",
          "[physics][motion]") {
  CHECK(statics::epicyclic_speed(0.0, 1000.0, 0.2) == Approx(400.0));
  CHECK(statics::epicyclic_speed(1000.0, 0.0, 0.2) == Approx(600.0));
  CHECK(statics::epicyclic_speed(70.0, 70.0, 0.3) == Approx(70.0));
  const CageStart start =
      cage_start(400.0, 0.98, 0.5, {3e-4, 0, 0}, {1e-5, 0, 5e-5}, {0.2, 0.001, -0.002});
  CHECK(start.cage_speed == Approx(392.0));
  CHECK(start.mass_centre_velocity[0] == 0.0);
  CHECK(start.mass_centre_velocity[1] == Approx(-196.0 * 5e-5));  // e_x × z = -y
  CHECK((rotation_matrix(start.orientation) * start.omega_body - Vec3(392.0, 0, 0)).norm() < 1e-10);
}
