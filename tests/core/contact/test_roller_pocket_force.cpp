#include "contact/roller_pocket.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

/// The force of a pocket on a slice is the gradient of its gap, also where the roller leans.
using namespace adore;
using contact::PocketSlice;

namespace {

constexpr double kRadius = 4.75e-3;

/// ∂gap/∂p told against differences, and against what the normal alone would be.
struct Gradients {
  double error = 0.0, of_normal = 0.0;
};
template <class Touch>
Gradients compare(const Vec3& p, const Touch& touch) {
  const PocketSlice here = touch(p);
  Vec3 slope;
  constexpr double kStep = 1e-9;
  for (int k = 0; k < 3; ++k)
    slope[k] = (touch(p + kStep * Vec3::Unit(k)).gap - touch(p - kStep * Vec3::Unit(k)).gap) /
               (2.0 * kStep);
  return {(slope - (here.aside - here.m)).norm(), (slope + here.m).norm()};
}

}  // namespace

TEST_CASE("a slice that leans in a round pocket is pushed along the gradient of its gap",
          "[unit][cage][pocket]") {
  const double nu = 0.0336;
  contact::RoundPocket pocket{kRadius + 1.25e-4, -3e-3, 3e-3, 0, 0.0, std::tan(nu), std::cos(nu)};
  const Vec3 u = Vec3(1.0, 0.02, -0.07).normalized();
  for (const double azimuth : {0.1, 0.4, -0.3, 2.9, 3.5}) {
    const Vec3 p(2e-3, 1.3e-4 * std::cos(azimuth), 1.3e-4 * std::sin(azimuth));
    const Gradients g = compare(
        p, [&](const Vec3& at) { return contact::slice_in_round_pocket(pocket, at, u, kRadius); });
    CAPTURE(azimuth, g.error, g.of_normal);
    CHECK(g.error < 1e-6);
    CHECK(g.of_normal > 1e-3);
  }
  SECTION("at the edge of the wall, and of a half that is cut away") {
    for (const int half : {0, 1}) {
      pocket.half = half;
      pocket.cut = half == 0 ? 0.0 : 2e-3;
      const Vec3 p(1e-3, half == 0 ? 2e-5 : -1.5e-4, 1.6e-4);
      const Gradients g = compare(p, [&](const Vec3& at) {
        return contact::slice_in_round_pocket(pocket, at, u, kRadius);
      });
      CAPTURE(half, g.error, g.of_normal);
      CHECK(g.error < 1e-5);  // the edge of a tapered wall is slightly curved, which is left out
      CHECK(g.of_normal > 5e-4);
    }
  }
}

TEST_CASE("a slice that leans on the edge of a face is pushed along the gradient of its gap",
          "[unit][cage][pocket]") {
  contact::PocketFace face;
  face.centre = {0.0, kRadius, 2e-3};
  face.half_width = 1e-3;
  const Vec3 u = Vec3(1.0, 0.05, 0.03).normalized();
  for (const double z : {-2e-3, 0.0, 2e-3}) {
    const Vec3 p(1e-3, 1e-4, z);
    const Gradients g = compare(
        p, [&](const Vec3& at) { return contact::slice_at_face(face, at, u, kRadius, 1e-4); });
    CAPTURE(z, g.error, g.of_normal);
    CHECK(g.error < 1e-6);
  }
}

TEST_CASE(
    "a slice that reaches over the end of a guide face is pushed along the gradient of its "
    "energy",
    "[unit][cage][pocket]") {
  contact::PocketFace face;
  face.centre = {0.0, kRadius, 0.0};
  face.half_length = 2e-3;
  constexpr double kHalf = 2e-4;
  const Vec3 u = Vec3(1.0, 0.002, 0.001).normalized();
  const auto touch = [&](const Vec3& at) {
    return contact::slice_at_face(face, at, u, kRadius, kHalf);
  };
  // Of the line law Q = φ δ^(10/9).
  const auto energy = [&](const Vec3& at) {
    const PocketSlice c = touch(at);
    return 9.0 / 19.0 * c.fraction * std::pow(std::max(-c.gap, 0.0), 19.0 / 9.0);
  };
  for (const double x : {-2.1e-3, -1.9e-3, 0.0, 2.05e-3}) {
    const Vec3 p(x, 2e-5, 0.0);
    const PocketSlice here = touch(p);
    REQUIRE(here.gap < 0.0);
    const double load = here.fraction * std::pow(-here.gap, 10.0 / 9.0);
    Vec3 slope;
    constexpr double kStep = 1e-9;
    for (int k = 0; k < 3; ++k)
      slope[k] =
          (energy(p + kStep * Vec3::Unit(k)) - energy(p - kStep * Vec3::Unit(k))) / (2.0 * kStep);
    CAPTURE(x, here.fraction, slope.transpose());
    CHECK((slope - load * (here.m - here.aside - here.edge)).norm() < 1e-5 * load);
    CHECK((here.fraction < 1.0) == (here.edge.x() != 0.0));
    CHECK(here.aside.norm() < 1e-3);  // no part of the end: it is in proportion to a damped load
  }
}

TEST_CASE("what is surely open in a pocket is open, and a slice's gap by itself is its gap",
          "[unit][cage][pocket]") {
  std::mt19937_64 numbers(14);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int near = 0;
  for (int n = 0; n < 4000; ++n) {
    contact::RollerProfile profile;
    profile.length = 0.012;
    profile.diameter = 2.0 * kRadius;
    profile.corner_radius = {4e-4, 4e-4};
    profile.end_radius = {0.0, n % 2 == 0 ? 0.0 : 0.09};
    const double lean = std::pow(10.0, -5.0 + 4.0 * std::abs(unit(numbers)));
    const Vec3 u = Vec3(1.0, lean * unit(numbers), lean * unit(numbers)).normalized();
    const Vec3 q(1e-4 * unit(numbers), 2e-4 * unit(numbers), 2e-4 * unit(numbers));
    for (int k = 0; k < 2; ++k) {
      const contact::RollerEnd end = contact::roller_end(profile, k);
      const double wall = 0.5 * profile.length + 1e-4 * std::abs(unit(numbers));
      const double gap = contact::end_contact_at_wall(end, wall, q, u).gap;
      const double bound = contact::end_gap_bound(end, wall, q, u);
      REQUIRE(bound <= gap);
      if (gap > 0.0 && bound > 0.0) ++near;
    }
    for (const contact::PocketFace& face :
         contact::window_faces(2.0 * kRadius + 2.5e-4, -1e-3, 2e-3, 1.0, n % 3 == 0 ? 0.03 : 0.0)) {
      const Vec3 p = q + 5e-3 * unit(numbers) * u;
      REQUIRE(contact::gap_at_face(face, p, u, kRadius) ==
              contact::slice_at_face(face, p, u, kRadius, 2e-4).gap);
    }
  }
  CHECK(near > 1000);  // a bound that never says so is of no use
}
