#include "base/constants.hpp"
#include "base/errors.hpp"
#include "contact/roller_flange.hpp"
#include "contact/roller_inertia.hpp"
#include "contact/slice_contact.hpp"
#include "contact/tapered_geometry.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

using namespace adore;
using namespace adore::contact;
using Mode = FlangeContact::Mode;
using bearing::kInner;
using bearing::kOuter;

namespace {

RollerProfile roller(double end_radius, double corner = 3e-4, double half_angle = 0.0) {
  RollerProfile p;
  p.diameter = 0.01;
  p.length = 0.012;
  p.half_angle = half_angle;
  p.corner_radius = {corner, corner};
  p.end_radius = {end_radius, end_radius};
  return p;
}

RollerProfile straight(double half_angle = 0.0) {
  RollerProfile p;
  p.diameter = 0.01;
  p.length = 0.012;
  p.half_angle = half_angle;
  p.central_length = p.length;
  return p;
}

RollerProfile barrel(double crown_radius) {
  RollerProfile p = straight();
  p.kind = RollerProfile::Kind::Arc;
  p.crown_radius = crown_radius;
  return p;
}

/// Tapered inner rib that the large end touches at its nominal pose.
struct Rib {
  TaperedGeometry g = tapered_geometry(0.01, {15 * kPi / 180, 11 * kPi / 180});
  RollerEnd end;
  Flange flange;
  FlangeFace face;
  Vec3 C;
  explicit Rib(double height = 0.0018) {
    end = roller_end(roller(0.9 * g.apex_distance, 3e-4, g.half_angle), 0);
    C = Vec3(0.0, 0.0, 0.5 * g.pitch_diameter);
    flange.layback = 2.1e-3;
    flange.height = height;
    flange.race_half_angle = g.race_angle[1];
    flange = placed_flange(flange, end, C, axis(0.0, 0.0), g.contact[1], 0.0);
    face = flange_face(flange);
  }
  [[nodiscard]] Vec3 axis(double tilt, double skew) const {
    return roller_axis(-g.axis_angle + tilt, skew);
  }
  [[nodiscard]] FlangeContact at(double tilt, double skew) const {
    return flange_contact(face, end, C, axis(tilt, skew));
  }
};

/// Flanges of an inner and an outer cylinder on a flat-ended roller.
Flange plain_flange(int side, int at, double layback = 7e-3, double height = 0.0022) {
  Flange f;
  f.side = side;
  f.at = at;
  f.layback = layback;
  f.height = height;
  f.root_x = at * flat_end_root_distance(0.012, 3e-4, layback, 8e-5);
  f.root_r = side == kInner ? 0.0275 : 0.0375;
  return f;
}

/// Least σ over the sampled surface of the end within the height: zooming grid over the generating
/// line (disc or cap, then corner) and the angle about the axis. An upper bound of the gap.
double sampled_gap(const FlangeFace& face, const RollerEnd& end, const Vec3& C, const Vec3& a) {
  const Vec3 out = end.sign * a, e1 = out.cross(Vec3::UnitY()).normalized(), e2 = out.cross(e1);
  const auto surface = [&](double u, double chi) {  // u in [0,1] cap or disc, [1,2] corner
    double v = end.vertex, rho = end.cap_radius * u;
    if (u > 1.0) {
      const double first =
          end.flat() ? 0.0 : std::atan2(end.ring_radius, end.ring - end.dome_centre);
      const double angle = first + (u - 1.0) * (end.side_angle - first);
      v = end.ring + end.corner_radius * std::cos(angle);
      rho = end.ring_radius + end.corner_radius * std::sin(angle);
    } else if (!end.flat()) {
      v = end.dome_centre + std::sqrt(end.end_radius * end.end_radius - rho * rho);
    }
    const Vec3 X = C + v * out + rho * (std::cos(chi) * e1 + std::sin(chi) * e2);
    const double r = std::hypot(X[1], X[2]);
    return face.coordinate_along_flange(X[0], r) <= face.reach ? face.sigma(X[0], r) : INFINITY;
  };
  double u0 = 1.0, chi0 = 0.0, du = 1.0, dchi = kPi, best = INFINITY;
  for (int zoom = 0; zoom < 14; ++zoom) {
    constexpr int kGrid = 60;
    const double uc = u0, cc = chi0;
    for (int i = -kGrid; i <= kGrid; ++i)
      for (int j = -kGrid; j <= kGrid; ++j) {
        const double u = std::clamp(uc + du * i / kGrid, 0.0, 2.0), chi = cc + dchi * j / kGrid;
        const double sigma = surface(u, chi);
        if (sigma < best) best = sigma, u0 = u, chi0 = chi;
      }
    du *= 0.3;
    dchi *= 0.3;
  }
  return best;
}

/// Largest second difference of gap(t) on n steps over [from, to].
template <class Gap>
double roughness(const Gap& gap, double from, double to, int n) {
  double worst = 0.0;
  const double h = (to - from) / n;
  for (int k = 1; k < n; ++k)
    worst = std::max(
        worst, std::abs(gap(from + (k - 1) * h) - 2 * gap(from + k * h) + gap(from + (k + 1) * h)));
  return worst;
}

}  // namespace

TEST_CASE("The corner torus touches side and end of any profile", "[unit][rollers]") {
  for (const double end_radius : {0.0, 0.13})
    for (const double crown : {double(INFINITY), 0.05, 1.2})
      for (const double nu : {0.0, 0.035})
        for (int which = 0; which < 2; ++which) {
          RollerProfile p = roller(end_radius, 4e-4, nu);
          p.crown_radius = crown;
          if (crown < 1.0) p.kind = RollerProfile::Kind::Arc;
          const RollerEnd e = roller_end(p, which);
          // Distance of the tube center from the side curve, by its foot point.
          const double s = e.sign * e.side_v, slope = e.sign * roller_slope(p, s);
          const double dv = e.side_v - e.ring, dr = roller_radius(p, s) - e.ring_radius;
          CHECK(std::hypot(dv, dr) == Approx(4e-4).epsilon(1e-12));
          CHECK(dv + slope * dr == Approx(0.0).margin(1e-15));
          if (e.flat())
            CHECK(e.ring + 4e-4 == Approx(0.006).epsilon(1e-13));
          else
            CHECK(std::hypot(e.ring - e.dome_centre, e.ring_radius) + 4e-4 ==
                  Approx(0.13).epsilon(1e-13));
        }
}

TEST_CASE("Flange gaps are the least height of the sampled end over the face",
          "[physics][rollers][slow]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::multiset<Mode> met;
  const auto compare = [&](const FlangeFace& face, const RollerEnd& end, const Vec3& C,
                           const Vec3& a) {
    const FlangeContact c = flange_contact(face, end, C, a);
    met.insert(c.mode);
    const double sampled = sampled_gap(face, end, C, a);
    INFO("mode " << static_cast<int>(c.mode) << " gap " << c.gap << " sampled " << sampled);
    const double r = std::hypot(c.point[1], c.point[2]);
    if (c.mode == Mode::Lip && c.gap < 0.0) {  // along the normal instead of m
      const double n_r = (c.normal[1] * c.point[1] + c.normal[2] * c.point[2]) / r;
      const double along = c.normal[0] * face.m_x + n_r * face.m_r;
      CHECK(sampled * along == Approx(c.gap).epsilon(1e-4).margin(2e-9));
    } else {
      CHECK(sampled > c.gap - 1e-12);
      CHECK(sampled < c.gap + 2e-9);  // what the last grid of the search resolves at a lip
      CHECK(face.sigma(c.point[0], r) == Approx(c.gap).margin(1e-15));
      CHECK(face.coordinate_along_flange(c.point[0], r) == Approx(c.height).margin(1e-12));
    }
    CHECK(c.normal.norm() == Approx(1.0).epsilon(1e-12));
  };
  for (int trial = 0; trial < 6; ++trial) {
    const Rib rib(trial % 2 == 0 ? 0.0018 : 0.00046);
    compare(rib.face, rib.end, rib.C, rib.axis(5e-4 * unit(random), 3e-3 * unit(random)));
  }
  const RollerEnd flat[2] = {roller_end(roller(0.0), 0), roller_end(roller(0.0), 1)};
  for (int trial = 0; trial < 10; ++trial) {
    const int at = trial % 2, side = (trial / 2) % 2;
    const FlangeFace face = flange_face(plain_flange(side, at == 0 ? -1 : 1));
    compare(face, flat[at], Vec3(1e-5 * unit(random), 0.0, 0.0325),
            roller_axis(0.02 * unit(random), 0.008 * unit(random)));
  }
  CHECK(met.contains(Mode::Face));
  CHECK(met.contains(Mode::Lip));
  CHECK(met.contains(Mode::Corner));
}

TEST_CASE("The gap stays smooth where the contact leaves the cap, and where it climbs over the lip",
          "[physics][rollers]") {
  // C1: halving the step quarters the largest second difference; a kink would only halve it.
  const Rib tall, low(0.00046);
  std::set<Mode> modes;
  const auto corner = [&](double skew) {
    const FlangeContact c = tall.at(-3e-4, skew);
    modes.insert(c.mode);
    return c.gap;
  };
  CHECK(roughness(corner, 1e-4, 4e-3, 400) / roughness(corner, 1e-4, 4e-3, 800) > 3.0);
  CHECK(modes == std::set<Mode>{Mode::Face, Mode::Corner});
  modes.clear();
  const auto lip = [&](double tilt) {
    const FlangeContact c = low.at(tilt, 2e-4);
    modes.insert(c.mode);
    return c.gap;
  };
  CHECK(roughness(lip, -2e-4, 2e-4, 400) / roughness(lip, -2e-4, 2e-4, 800) > 3.0);
  CHECK(modes == std::set<Mode>{Mode::Face, Mode::Lip});
  // Flat end climbing a skewed inner flange: corner on the face, then lip; gap continuous.
  modes.clear();
  const RollerEnd end = roller_end(roller(0.0), 0);
  const FlangeFace face = flange_face(plain_flange(kInner, -1));
  const auto flat = [&](double tilt) {
    const FlangeContact c =
        flange_contact(face, end, Vec3(0.0, 0.0, 0.0325), roller_axis(tilt, 4e-3));
    modes.insert(c.mode);
    return c.gap;
  };
  double jump = 0.0;
  for (int k = 0; k < 800; ++k)
    jump = std::max(jump, std::abs(flat(-0.02 + 5e-5 * (k + 1)) - flat(-0.02 + 5e-5 * k)));
  CHECK(jump < 5e-5 * 0.006);  // steepest change: the rim's distance from the middle times the turn
  CHECK(modes == std::set<Mode>{Mode::Face, Mode::Lip});
}

TEST_CASE("Flanges are placed by their end play", "[physics][rollers]") {
  for (const int side : {kInner, kOuter})
    for (int which = 0; which < 2; ++which)
      for (const double layback : {0.002, 0.0105}) {
        const RollerEnd end = roller_end(roller(0.0), which);
        const double R = side == kInner ? 0.0275 : 0.0375;
        Flange f;
        f.side = side;
        f.at = end.sign;
        f.layback = layback;
        f.height = 0.0022;
        f = placed_flange(f, end, Vec3(0, 0, 0.0325), Vec3::UnitX(), {end.sign * 0.006, R}, 4e-5);
        CHECK(end.sign * f.root_x ==
              Approx(flat_end_root_distance(0.012, 3e-4, layback, 8e-5)).epsilon(1e-12));
        const Vec3 moved(end.sign * 4e-5, 0.0, 0.0325);
        CHECK(flange_contact(flange_face(f), end, moved, Vec3::UnitX()).gap ==
              Approx(0.0).margin(1e-16));
      }
  const Rib rib;
  CHECK(rib.at(0.0, 0.0).gap == Approx(0.0).margin(1e-15));
  Flange bad;
  CHECK_THROWS_AS(flange_face(bad), InputError);
}

TEST_CASE("Rib contact of a tapered roller lies where the closed form says", "[physics][rollers]") {
  const Rib rib;
  const FlangeContact c = rib.at(0.0, 0.0);
  CHECK(c.mode == Mode::Face);
  // Polar angle of the contact on the sphere: ν + γ.
  CHECK(c.from_axis ==
        Approx(rib.end.end_radius * std::sin(rib.g.half_angle + rib.flange.layback)).epsilon(1e-9));
  CHECK(dome_center_axis_distance(rib.end, rib.C, rib.axis(0, 0)) > 0.0);
  const FlangeContact pressed =
      flange_contact(rib.face, rib.end, rib.C - Vec3(3e-6, 0, 0), rib.axis(0, 0));
  const double E_star = 206e9 / (2 * 0.91);
  const FlangeLoad load = flange_load(rib.end, rib.axis(0, 0), pressed, E_star);
  CHECK(load.load == Approx(load.hertz.K * std::pow(-pressed.gap, 1.5)).epsilon(1e-13));
  CHECK(load.curvature.along == Approx(1 / rib.end.end_radius).epsilon(1e-12));
  CHECK(load.curvature.across < 0.25 * load.curvature.along);  // long ellipse around the bearing
  const FlangeContact open =
      flange_contact(rib.face, rib.end, rib.C + Vec3(3e-6, 0, 0), rib.axis(0, 0));
  CHECK(open.gap > 0.0);
  CHECK(flange_load(rib.end, rib.axis(0, 0), open, E_star).load == 0.0);
}

TEST_CASE("Corner and lip contacts have finite Hertz constants", "[physics][rollers]") {
  const double E_star = 206e9 / (2 * 0.91);
  for (const double corner : {0.0, 3e-4})
    for (const int side : {kInner, kOuter})
      for (const double tilt : {-0.02, -1e-3, 0.0, 1e-3, 0.02}) {
        const RollerEnd end = roller_end(roller(0.0, corner), 0);
        const FlangeFace face = flange_face(plain_flange(side, -1));
        const Vec3 a = roller_axis(tilt, 2e-3);
        const FlangeContact c = flange_contact(face, end, Vec3(0, 0, 0.0325), a);
        CAPTURE(corner, side, tilt);
        REQUIRE(c.mode != Mode::None);
        const FlangeCurvature k = flange_curvature(end, a, c);
        CHECK(k.relative.along_major > 0.0);
        CHECK(k.relative.along_minor >= k.relative.along_major);
        CHECK(flange_load(end, a, c, E_star).hertz.K > 0.0);
      }
  // Equal spheres in every direction keep their curvature: a dome far out on a lip of 0.1 mm.
  const Rib low(0.0004);
  const FlangeContact c = low.at(0.0, 0.0);
  REQUIRE(c.mode == Mode::Lip);
  CHECK(flange_curvature(low.end, low.axis(0, 0), c).relative.along_minor ==
        Approx(1 / kEdgeTube + 1 / low.end.end_radius).epsilon(1e-3));
}

TEST_CASE("Tapered geometry says how it degenerates", "[unit][rollers]") {
  const auto message = [](double outer, double inner) -> std::string {
    try {
      (void)tapered_geometry(0.01, {outer, inner});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(message(0.2, 0.2), Catch::Contains("infinity"));
  CHECK_THAT(message(0.19, 0.2), Catch::Contains("infinity"));
  CHECK_THAT(message(0.2002, 0.2), Catch::Contains("are nearly equal: the common apex"));
  CHECK_THAT(message(0.2, 1e-5), Catch::Contains("too small"));
  CHECK_THAT(message(1.7, 0.2), Catch::Contains("between 0 and"));
  CHECK(message(0.23, 0.2).empty());
  // Nearly parallel cones of the right ratio are a cylinder bearing: d_m = D (α_o + α_i)/(α_o -
  // α_i).
  const double ratio = (0.065 - 0.01) / (0.065 + 0.01);
  CHECK(tapered_geometry(0.01, {1e-4, 1e-4 * ratio}).pitch_diameter == Approx(0.065).epsilon(1e-7));
  const TaperedGeometry g = tapered_geometry(0.01, {0.26, 0.19});
  const double h = 1e-7, moved = tapered_geometry(0.01, {0.26 + h, 0.19}).pitch_diameter;
  // The estimate leaves out the change of sin β.
  CHECK(std::abs(moved - g.pitch_diameter) / h ==
        Approx(pitch_diameter_sensitivity(g)).epsilon(0.2));
  CHECK_THROWS_AS(end_diameters(g, 0.01, 1.0), InputError);
  CHECK_THROWS_AS(grooved_tapered_races(g, 0.05, {0.5, 0.52}), InputError);
  CHECK_THROWS_AS(rib_loads(100.0, {0.26, 0.19}, 0.19 + 0.6 * kPi, 0.0), InputError);
}

TEST_CASE("Grooves leave the stated normal gap at the middle of the roller", "[physics][rollers]") {
  const SphericalRow row = spherical_row(0.016, 0.075, 0.157, 0.055, {0.515, 0.52}, 4e-5);
  const Vec3 C(0.0, 0.0, 0.0375), a = roller_axis(-0.157, 0.0);
  for (const RaceSurface& race : row.race)
    CHECK(slice_contact(race, C, a, {0.0, 0.008}).delta == Approx(-row.normal_gap).margin(1e-16));
}

TEST_CASE("Roller inertia agrees with closed forms", "[physics][rollers]") {
  const double rho = 7800.0, D = 0.01, L = 0.012, R = 0.5 * D;
  const RollerInertia cylinder = roller_inertia(straight(), rho);
  const double m = rho * kPi * R * R * L;
  CHECK(cylinder.mass == Approx(m).epsilon(1e-14));
  CHECK(cylinder.axial == Approx(m * D * D / 8).epsilon(1e-14));
  CHECK(cylinder.transverse == Approx(m * (D * D / 16 + L * L / 12)).epsilon(1e-14));
  CHECK(std::abs(cylinder.mass_centre) < 1e-18);

  const double nu = 0.035, r1 = R + 0.5 * L * std::tan(nu), r2 = R - 0.5 * L * std::tan(nu);
  const RollerInertia cone = roller_inertia(straight(nu), rho);
  const double sum = r1 * r1 + r1 * r2 + r2 * r2;
  const double mc = kPi * rho * L * sum / 3;
  CHECK(cone.mass == Approx(mc).epsilon(1e-14));
  CHECK(cone.mass_centre ==
        Approx(-0.5 * L + L * (r1 * r1 + 2 * r1 * r2 + 3 * r2 * r2) / (4 * sum)).epsilon(1e-11));
  const double fourth = r1 * r1 * r1 * r1 + r1 * r1 * r1 * r2 + r1 * r1 * r2 * r2 +
                        r1 * r2 * r2 * r2 + r2 * r2 * r2 * r2;
  CHECK(cone.axial == Approx(0.3 * mc * fourth / sum).epsilon(1e-14));

  // Middle layer of a ball: V = 2π(R²h - h³/3), h half the length.
  RollerProfile ball = barrel(0.005);
  ball.length = 0.006;
  const double h = 0.003;
  CHECK(roller_inertia(ball, rho).mass ==
        Approx(2 * kPi * rho * (R * R * h - h * h * h / 3)).epsilon(1e-13));

  // Dome: spherical cap of height k on a cylinder of length L - k.
  RollerProfile domed = straight();
  domed.end_radius[1] = 0.02;
  const double k = 0.02 - std::sqrt(0.02 * 0.02 - R * R);
  CHECK(roller_inertia(domed, rho).mass ==
        Approx(rho * kPi * (R * R * (L - k) + k * k * (0.06 - k) / 3)).epsilon(1e-13));
  CHECK(roller_inertia(domed, rho).mass_centre < 0.0);

  // Corner: square minus quarter circle, by Pappus; its centroid lies r (10-3π)/(12-3π) from the
  // edges.
  RollerProfile corners = straight();
  corners.corner_radius = {5e-4, 5e-4};
  const double r = 5e-4, centroid = R - r * (10 - 3 * kPi) / (12 - 3 * kPi);
  CHECK(m - roller_inertia(corners, rho).mass ==
        Approx(2 * rho * 2 * kPi * centroid * (1 - kPi / 4) * r * r).epsilon(1e-11));
  CHECK(roller_inertia(corners, rho, false).mass == Approx(m).epsilon(1e-14));
  CHECK(roller_inertia(barrel(1e10), rho).axial == Approx(cylinder.axial).epsilon(1e-12));
  CHECK_THROWS_AS(roller_inertia(straight(), 0.0), InputError);
}
