#include "base/rotation.hpp"
#include "contact/roller_flange.hpp"
#include "contact/slice_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <random>
#include <utility>

/// The force of a flange goes along the normal and has the potential of the gap: so the normal has
/// to be the gradient of the gap, and the gap may not jump, wherever the end touches.

using namespace adore;
using namespace adore::contact;
using Mode = FlangeContact::Mode;
using Surface = FlangeContact::Surface;

namespace {

struct Dice {
  std::mt19937_64 engine{20};
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  template <class T>
  T one_of(std::initializer_list<T> values) {
    return values.begin()[std::uniform_int_distribution<std::size_t>(0, values.size() - 1)(engine)];
  }
};

struct Pose {
  Vec3 centre, axis;
};

/// One flange of any race and side, the end that faces it, and a pose in which they overlap.
struct Scene {
  RollerEnd end;
  FlangeFace face;
  Pose pose;

  [[nodiscard]] FlangeContact at(const Pose& p) const {
    return flange_contact_for_forces(face, end, p.centre, p.axis);
  }
};

Scene random_scene(Dice& dice) {
  Scene s;
  RollerProfile roller;
  roller.diameter = 0.01;
  roller.length = 0.012;
  roller.half_angle = dice.one_of({0.0, 0.035});
  const double corner = dice.one_of({0.0, 3e-4, 1e-3});
  roller.corner_radius = {corner, corner};
  const double end_radius = dice.one_of({0.0, 0.05, 0.13});
  roller.end_radius = {end_radius, end_radius};
  const int which = dice.one_of({0, 1});
  s.end = roller_end(roller, which);
  Flange flange;
  flange.side = dice.one_of({bearing::kInner, bearing::kOuter});
  flange.at = which == 0 ? -1 : 1;
  flange.layback = dice.one_of({0.0, 0.002, 0.02});
  flange.height = dice.one_of({0.0004, 0.001, 0.0022, 0.0035});
  flange.race_half_angle = roller.half_angle > 0.0 ? dice.one_of({0.19, 0.26}) : 0.0;
  flange.root_r = flange.side == bearing::kInner ? 0.0275 : 0.0375;
  const double nominal = roller.half_angle > 0.0 ? -0.226 : 0.0;
  const double turns = dice.one_of({3e-4, 5e-3, 0.05});
  s.pose.axis = roller_axis(nominal + turns * dice.between(-1, 1), turns * dice.between(-1, 1));
  s.pose.centre = Vec3(1e-5 * dice.between(-1, 1), 0.0,
                       0.0325 + dice.one_of({1e-5, 1e-3}) * dice.between(-1, 1));
  // The root is put where the end overlaps by the asked depth.
  const double depth = dice.one_of({1e-7, 2e-6, 2e-5}) * dice.between(0.2, 1.0);
  flange.root_x = flange.at * 0.006;
  for (int n = 0; n < 60; ++n) {
    s.face = flange_face(flange);
    const double more = s.at(s.pose).gap + depth;
    if (std::abs(more) < 1e-9 * depth) break;
    flange.root_x -= flange.at * more;
  }
  // A low lip may miss the end.
  return s.at(s.pose).gap < 0.0 ? s : random_scene(dice);
}

/// The pose after the roller has moved by d and turned by w about its middle.
Pose moved(const Pose& p, const Vec3& d, const Vec3& w) {
  const double angle = w.norm();
  if (!(angle > 0.0)) return {p.centre + d, p.axis};
  return {p.centre + d, Eigen::AngleAxisd(angle, w / angle) * p.axis};
}

}  // namespace

TEST_CASE("The normal of a flange contact is the gradient of its gap on face, corner and lip",
          "[physics][rollers]") {
  constexpr int kScenes = 3000;
  Dice dice;
  std::map<std::pair<Mode, Surface>, int> met;
  int kinks = 0;
  for (int n = 0; n < kScenes; ++n) {
    const Scene s = random_scene(dice);
    const FlangeContact c = s.at(s.pose);
    CAPTURE(n, s.end.corner_radius, s.end.end_radius, c.gap, c.height, static_cast<int>(c.mode),
            static_cast<int>(c.surface));
    REQUIRE(c.mode != Mode::None);
    REQUIRE(c.gap < 0.0);
    ++met[{c.mode, c.surface}];
    const Vec3 arm = c.point - s.pose.centre;
    for (int k = 0; k < 6; ++k) {
      const Vec3 unit = Vec3::Unit(k % 3);
      const double step = k < 3 ? 1e-9 : 2e-7;
      const auto gap = [&](double h) {
        return s
            .at(k < 3 ? moved(s.pose, h * unit, Vec3::Zero())
                      : moved(s.pose, Vec3::Zero(), h * unit))
            .gap;
      };
      const double up = (gap(step) - c.gap) / step, down = (c.gap - gap(-step)) / step;
      const double expected =
          c.steepness * (k < 3 ? c.normal.dot(unit) : c.normal.dot(unit.cross(arm)));
      const double size = k < 3 ? 1.0 : 0.005;
      CAPTURE(k, up, down, expected);
      // Between two places that touch alike the gap has a kink: either of them may be named.
      if (std::abs(up - down) > 2e-3 * size) {
        ++kinks;
        CHECK(std::min(std::abs(up - expected), std::abs(down - expected)) < 2e-3 * size);
      } else {
        CHECK(0.5 * (up + down) == Approx(expected).margin(1e-4 * size));
      }
    }
  }
  CHECK(kinks < kScenes / 100);
  for (const Mode mode : {Mode::Face, Mode::Lip, Mode::Corner})
    CHECK(met[{mode, Surface::Torus}] > 100);
  for (const Mode mode : {Mode::Face, Mode::Lip}) CHECK(met[{mode, Surface::Cap}] > 100);
  CHECK(met[{Mode::Lip, Surface::Disc}] > 100);
}

TEST_CASE("The gap of a flange does not jump as the roller moves over face, corner and lip",
          "[physics][rollers]") {
  constexpr int kPaths = 300, kSteps = 200;
  Dice dice;
  std::map<Mode, int> met;
  for (int n = 0; n < kPaths; ++n) {
    const Scene s = random_scene(dice);
    const Vec3 d =
        1e-4 * Vec3(0.2 * dice.between(-1, 1), dice.between(-1, 1), 5 * dice.between(-1, 1));
    const Vec3 w = 0.01 * Vec3(0.0, dice.between(-1, 1), dice.between(-1, 1));
    const double reach = std::hypot(0.006, 0.005);
    double before = s.at(s.pose).gap;
    for (int k = 1; k <= kSteps; ++k) {
      const double share = static_cast<double>(k) / kSteps;
      const FlangeContact c = s.at(moved(s.pose, share * d, share * w));
      CAPTURE(n, k, c.gap, before, static_cast<int>(c.mode), static_cast<int>(c.surface));
      ++met[c.mode];
      REQUIRE(std::abs(c.gap - before) <= 1.001 * (d.norm() + reach * w.norm()) / kSteps);
      before = c.gap;
    }
  }
  CHECK(met[Mode::Face] > 1000);
  CHECK(met[Mode::Lip] > 1000);
  CHECK(met[Mode::Corner] > 1000);
  CHECK(met[Mode::None] == 0);
}
