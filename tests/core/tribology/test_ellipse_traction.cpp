#include "base/errors.hpp"
#include "tribology/ellipse_breaks.hpp"
#include "tribology/ellipse_traction.hpp"
#include "tribology/traction_curve.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace adore::tribology;
using adore::bearing::TractionCurve;

namespace {

const EllipseGeometry kFlat{400.0, 1e-3, 1.5e-4, 0.0, 6.346e-3};
const EllipseGeometry kCurved{400.0, 1e-3, 1.5e-4, 6.5e-3, 6.346e-3};
const EllipseKinematics kSpin{0.0, 0.0, 0.0, 0.0, 3000.0};
const EllipseKinematics kGeneral{0.03, -18.988, -3000.0, 12.0, 1050.0};
const TractionCurve kCoulomb = traction_curve(0, {0.05, 0.0, 0.0, 0.1});
const TractionCurve kTwoSlope = traction_curve(0, {0.0, 0.5, 0.0, 0.1});
const TractionCurve kSmooth = traction_curve(-1, {-0.04, 0.02, 8.0, 0.04});

double relative(double a, double b) { return std::abs(a - b) / std::abs(b); }

}  // namespace

TEST_CASE("make_ellipse_rule(): Hertz pressure times polynomials → exact", "[unit][analytic]") {
  for (int n : {1, 2, 3, 7, 12, 40, 200}) {
    const EllipseRule rule = make_ellipse_rule(n, n);
    double s0 = 0.0, s2 = 0.0, v0 = 0.0, v2 = 0.0, odd = 0.0;
    for (std::size_t i = 0; i < rule.s.size(); ++i) {
      s0 += rule.weight_s[i];
      s2 += rule.weight_s[i] * rule.s[i] * rule.s[i];
      v0 += rule.weight_v[i];
      v2 += rule.weight_v2[i];
      odd += rule.weight_s[i] * rule.s[i] + rule.weight_v1[i];
      CHECK(rule.chord[i] == Approx(std::sqrt(1.0 - rule.s[i] * rule.s[i])).epsilon(1e-15));
      if (i > 0) CHECK(rule.s[i] > rule.s[i - 1]);
      if (i > 0) CHECK(rule.v[i] > rule.v[i - 1]);
    }
    // 1e-13: a few hundred additions of weights that carry ~10 ulp each.
    CHECK(s0 == Approx(1.0).epsilon(1e-13));
    CHECK(v0 == Approx(1.0).epsilon(1e-13));
    CHECK(std::abs(odd) < 1e-13);
    if (n > 1) {
      CHECK(s2 == Approx(1.0 / 5.0).epsilon(1e-13));  // ¾ ∫ s² (1-s²) ds
      CHECK(v2 == Approx(1.0 / 4.0).epsilon(1e-13));  // (2/π) ∫ v² sqrt(1-v²) dv
    }
  }
  CHECK_THROWS_AS(make_ellipse_rule(0, 4), adore::InputError);
  CHECK_THROWS_AS(make_ellipse_rule(4, 201), adore::InputError);
}

TEST_CASE("pure spin under Coulomb traction: M = 3/8 mu Q a E(1 - b²/a²) and heat M W",
          "[physics][analytic]") {
  const double m = 1.0 - std::pow(kFlat.b / kFlat.a, 2);
  const double closed = 0.375 * 0.05 * kFlat.Q * kFlat.a * std::comp_ellint_2(std::sqrt(m));
  const EllipseTraction exact = ellipse_traction_converged(kCoulomb, kFlat, kSpin);
  CHECK(relative(exact.M_n, closed) < 1e-10);
  CHECK(relative(exact.heat, closed * kSpin.W_n) < 1e-10);
  CHECK(std::abs(exact.F_c) + std::abs(exact.F_t) < 1e-10 * 0.05 * kFlat.Q);
  CHECK(exact.max_slip == Approx(kFlat.a * kSpin.W_n).epsilon(1e-12));
  // The fixed rule regularizes slips below 1e-5 m/s of 3 m/s and sees |u| with its corner: 0.5 % at
  // 12 x 4.
  const EllipseTraction rule = ellipse_traction(kCoulomb, kFlat, kSpin, make_ellipse_rule(12, 4));
  CHECK(relative(rule.M_n, closed) < 5e-3);
}

TEST_CASE("pure spin under a linear law: M = B W Q (a² + b²)/5 for any rule",
          "[physics][analytic]") {
  const TractionCurve linear = traction_curve(0, {0.0, 0.05, 0.0, 1000.0});
  const double closed = 0.05 * kSpin.W_n * kFlat.Q * (kFlat.a * kFlat.a + kFlat.b * kFlat.b) / 5.0;
  CHECK(relative(ellipse_traction(linear, kFlat, kSpin, make_ellipse_rule(2, 2)).M_n, closed) <
        1e-14);
  CHECK(relative(ellipse_traction_converged(linear, kFlat, kSpin).M_n, closed) < 1e-10);
}

TEST_CASE("fixed rule: spectral convergence for a smooth law without reversal",
          "[physics][convergence]") {
  const EllipseKinematics motion{0.4, 0.6, 0.0, 0.0, 500.0};
  const EllipseTraction exact = ellipse_traction_converged(kSmooth, kCurved, motion);
  double before = 1.0;
  for (int n : {2, 4, 8, 16}) {
    const EllipseTraction rule =
        ellipse_traction(kSmooth, kCurved, motion, make_ellipse_rule(n, n));
    const double error = relative(rule.M_n, exact.M_n) + relative(rule.F_t, exact.F_t);
    CHECK(error < std::max(0.2 * before, 1e-10));  // doubling n gains far more than any fixed order
    before = error;
  }
  CHECK(before < 1e-8);
}

TEST_CASE("fixed rule: second order or better across kinks and reversals",
          "[physics][convergence]") {
  const EllipseTraction exact = ellipse_traction_converged(kTwoSlope, kCurved, kGeneral);
  const auto error = [&](int major, int minor) {
    const EllipseTraction rule =
        ellipse_traction(kTwoSlope, kCurved, kGeneral, make_ellipse_rule(major, minor));
    return std::hypot(rule.F_c - exact.F_c, rule.F_t - exact.F_t) / (0.05 * kCurved.Q);
  };
  CHECK(error(12, 4) < 3e-2);
  CHECK(error(48, 16) < 2e-3);
  CHECK(error(192, 64) < 1e-4);
}

TEST_CASE("split rule: whole load, and smooth integrands exactly", "[unit][analytic]") {
  // A constant coefficient and uniform slip: F = κ Q whatever the pieces are.
  const TractionCurve constant = traction_curve(2, {0.05, 0.05, 0.0, 0.0});
  for (const int major : {1, 10, 15, 20, 200}) {
    const EllipseRule rule = make_split_ellipse_rule(major, 4);
    CHECK(rule.major % kEllipsePieces == 0);
    CHECK(rule.major >= std::max(major, 10));
    const EllipseTraction one = ellipse_traction(constant, kFlat, {0.0, 3.0, 0.0, 0.0, 0.0}, rule);
    CHECK(one.F_t == Approx(0.05 * kFlat.Q).epsilon(1e-10));  // regularized: (1e-5/3)² / 2
    CHECK(one.load_slip == Approx(3.0 * kFlat.Q).epsilon(1e-10));
  }
  const TractionCurve linear = traction_curve(0, {0.0, 0.05, 0.0, 1000.0});
  const double closed = 0.05 * kSpin.W_n * kFlat.Q * (kFlat.a * kFlat.a + kFlat.b * kFlat.b) / 5.0;
  CHECK(relative(ellipse_traction(linear, kFlat, kSpin, make_split_ellipse_rule(15, 4)).M_n,
                 closed) < 1e-13);
  CHECK_THROWS_AS(make_split_ellipse_rule(201, 4), adore::InputError);
}

TEST_CASE("split rule: exact for sliding bands without spin", "[physics][convergence]") {
  // Traction is piecewise a parabola of ξ there; its three kinks lie on the break points. What is
  // left is the curvature of the surface beyond a parabola, (a/ρ)² / 4 of a slip of ~0.1 m/s.
  const EllipseKinematics bands{0.0, -18.94569230769231, -3000.0, 0.0, 0.0};
  const EllipseTraction exact = ellipse_traction_converged(kTwoSlope, kCurved, bands);
  const auto error = [&](const EllipseRule& rule) {
    return std::abs(ellipse_traction(kTwoSlope, kCurved, bands, rule).F_t - exact.F_t) /
           (0.05 * kCurved.Q);
  };
  CHECK(error(make_split_ellipse_rule(20, 1)) < 2e-5);
  CHECK(error(make_ellipse_rule(20, 1)) > 2.0 * error(make_split_ellipse_rule(20, 1)));
}

TEST_CASE("split rule: several times less error than the product rule across reversals",
          "[physics][convergence]") {
  double product = 0.0, split = 0.0;
  int count = 0;
  for (double spin = 100.0; spin < 3000.0; spin += 237.0) {
    for (double offset = -0.3; offset < 0.3; offset += 0.055) {
      const EllipseKinematics motion{0.03, -18.988 + offset, -3000.0, 12.0, spin};
      const EllipseTraction exact = ellipse_traction_converged(kTwoSlope, kCurved, motion);
      const auto error = [&](const EllipseRule& rule) {
        const EllipseTraction one = ellipse_traction(kTwoSlope, kCurved, motion, rule);
        return std::pow(std::hypot(one.F_c - exact.F_c, one.F_t - exact.F_t) / (0.05 * kCurved.Q),
                        2);
      };
      product += error(make_ellipse_rule(20, 4));
      split += error(make_split_ellipse_rule(20, 4));
      ++count;
    }
  }
  CHECK(std::sqrt(split / count) < 3e-3);
  CHECK(std::sqrt(product / count) > 2.0 * std::sqrt(split / count));
}

TEST_CASE("split rule: continuous while break points appear, meet the edge and vanish",
          "[physics]") {
  for (const double spin : {0.0, 300.0, 2000.0}) {
    double before = 0.0, largest_step = 0.0, total = 0.0;
    constexpr int kSteps = 4000;
    for (int i = 0; i <= kSteps; ++i) {
      const EllipseKinematics motion{0.03, -19.6 + 1.2 * i / kSteps, -3000.0, 12.0, spin};
      const double force =
          ellipse_traction(kTwoSlope, kCurved, motion, make_split_ellipse_rule(20, 4)).F_t;
      if (i > 0) largest_step = std::max(largest_step, std::abs(force - before));
      if (i > 0) total += std::abs(force - before);
      before = force;
    }
    // κ Q = 20 N is crossed once each way over slips of 0.2 m/s: the slope is at most B Q = 200 N
    // s/m.
    CHECK(largest_step < 1.5 * 200.0 * 1.2 / kSteps);
    CHECK(total > 10.0);  // and the sweep does reverse the traction
  }
}

TEST_CASE("converged traction: power balance, heat = u0·F + W·M", "[physics][energy]") {
  for (const TractionCurve& curve : {kCoulomb, kTwoSlope, kSmooth}) {
    for (const EllipseKinematics& motion :
         {kGeneral, kSpin, EllipseKinematics{-0.2, -19.0, -3000.0, 40.0, -300.0}}) {
      const EllipseTraction one = ellipse_traction_converged(curve, kCurved, motion);
      const double power = motion.u_c * one.F_c + motion.u_t * one.F_t + motion.W_c * one.M_c +
                           motion.W_t * one.M_t + motion.W_n * one.M_n;
      // u0·F and W·M are ~30 times the heat and cancel.
      CHECK(power == Approx(one.heat).epsilon(1e-8));
      CHECK(one.load_slip <= kCurved.Q * one.max_slip);
      CHECK(one.load_slip > 0.0);
    }
  }
}

TEST_CASE("largest slip: at the edge, for any law and rule", "[physics]") {
  std::mt19937 random(15);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> power(-2.0, 1.0);
  double worst = 0.0, all = 0.0;
  constexpr int kContacts = 300;
  for (int i = 0; i < kContacts; ++i) {
    // Rolling that all but cancels in the middle, spin and gyration of any share.
    const double W_c = 3000.0 * normal(random), size = std::pow(10.0, power(random));
    const EllipseKinematics motion{0.3 * size * normal(random),
                                   W_c * kCurved.h0 + 0.3 * size * normal(random), W_c,
                                   100.0 * normal(random), 800.0 * normal(random)};
    const double exact = ellipse_traction_converged(kSmooth, kCurved, motion).max_slip;
    const double found = largest_slip(kCurved, motion);
    CHECK(found <= exact * (1.0 + 1e-9));
    const double off = 1.0 - found / exact;
    worst = std::max(worst, off);
    all += off / kContacts;
    for (const EllipseRule& rule : {make_ellipse_rule(3, 2), make_split_ellipse_rule(20, 4)})
      CHECK(ellipse_traction(kTwoSlope, kCurved, motion, rule).max_slip == found);
  }
  CHECK(worst < 0.012);
  CHECK(all < 5e-4);
}

TEST_CASE("traction: reversed slip → reversed traction", "[physics][symmetry]") {
  const EllipseKinematics back{-kGeneral.u_c, -kGeneral.u_t, -kGeneral.W_c, -kGeneral.W_t,
                               -kGeneral.W_n};
  const EllipseRule rule = make_ellipse_rule(12, 4);
  const EllipseTraction a = ellipse_traction(kTwoSlope, kCurved, kGeneral, rule);
  const EllipseTraction b = ellipse_traction(kTwoSlope, kCurved, back, rule);
  CHECK(b.F_c == -a.F_c);
  CHECK(b.F_t == -a.F_t);
  CHECK(b.M_n == -a.M_n);
  CHECK(b.heat == a.heat);
  CHECK(b.load_slip == a.load_slip);
}

TEST_CASE("traction: no slip → none, also if κ(0) is not zero", "[unit]") {
  const EllipseKinematics still{};
  for (const TractionCurve& curve : {kCoulomb, kTwoSlope, kSmooth}) {
    CHECK(ellipse_traction_converged(curve, kCurved, still).F_t == 0.0);
    CHECK(ellipse_traction_converged(curve, kCurved, still).heat == 0.0);
    const EllipseTraction rule = ellipse_traction(curve, kCurved, still, make_ellipse_rule(12, 4));
    CHECK(rule.F_t == 0.0);
    CHECK(rule.heat == 0.0);
  }
  EllipseGeometry open = kCurved;
  open.Q = 0.0;
  CHECK(ellipse_traction_converged(kCoulomb, open, kGeneral).heat == 0.0);
}

TEST_CASE("the regularization of a law with κ(0) ≠ 0 costs less than ε/u", "[unit]") {
  const EllipseKinematics sliding{0.0, 0.5, 0.0, 0.0, 0.0};
  const EllipseTraction rule = ellipse_traction(kCoulomb, kFlat, sliding, make_ellipse_rule(4, 4));
  CHECK(relative(rule.F_t, 0.05 * kFlat.Q) < std::pow(kRegularizationSlip / 0.5, 2));
  const EllipseKinematics creeping{0.0, kRegularizationSlip, 0.0, 0.0, 0.0};
  const EllipseTraction slow = ellipse_traction(kCoulomb, kFlat, creeping, make_ellipse_rule(4, 4));
  CHECK(slow.F_t == Approx(0.05 * kFlat.Q / std::numbers::sqrt2).epsilon(1e-9));
}

TEST_CASE("pressure-dependent law that ignores the pressure: agrees with the curve", "[unit]") {
  const TractionFunction law{
      [](double slip, double) { return traction_coefficient(kTwoSlope, slip); }, kTwoSlope.u0};
  const EllipseTraction a = ellipse_traction_converged(law, kCurved, kGeneral);
  const EllipseTraction b = ellipse_traction_converged(kTwoSlope, kCurved, kGeneral);
  CHECK(a.F_t == b.F_t);
  CHECK(a.M_n == b.M_n);
  // κ proportional to p: ∫ p² dA = (3/4) p0 Q for uniform slip.
  const double p0 = 1.5 * kFlat.Q / (std::numbers::pi * kFlat.a * kFlat.b);
  const TractionFunction proportional{[&](double, double p) { return 0.1 * p / p0; }, 0.0};
  const EllipseKinematics sliding{0.0, 0.5, 0.0, 0.0, 0.0};
  CHECK(ellipse_traction_converged(proportional, kFlat, sliding).F_t ==
        Approx(0.075 * kFlat.Q).epsilon(1e-10));
}

TEST_CASE("set_contact_surface(): surface of each convention", "[unit]") {
  const double rb = 6.35e-3, R = 6.604e-3, delta = 4e-6, rho = 2.0 * rb * R / (rb + R);
  EllipseGeometry g{400.0, 1e-3, 1.5e-4, 0.0, 0.0};
  set_contact_surface(g, ContactSurface::CurvedEdge, rb, R, delta);
  CHECK(g.rho == Approx(rho).epsilon(1e-15));
  // The arc meets the undeformed ball at ξ = ±a.
  const double at_edge = g.h0 - (g.rho - std::sqrt(g.rho * g.rho - g.a * g.a));
  CHECK(at_edge == Approx(std::sqrt(rb * rb - g.a * g.a)).epsilon(1e-14));
  set_contact_surface(g, ContactSurface::CurvedHalf, rb, R, delta);
  CHECK(g.h0 == Approx(rb - 0.5 * delta).epsilon(1e-15));
  set_contact_surface(g, ContactSurface::CurvedUndeformed, rb, R, delta);
  CHECK((g.h0 == rb && g.rho > 0.0));
  set_contact_surface(g, ContactSurface::FlatHalf, rb, R, delta);
  CHECK((g.h0 == rb - 0.5 * delta && g.rho == 0.0));
  set_contact_surface(g, ContactSurface::FlatEdge, rb, R, delta);
  CHECK(g.h0 == Approx(std::sqrt(rb * rb - g.a * g.a)).epsilon(1e-15));
  set_contact_surface(g, ContactSurface::FlatUndeformed, rb, R, delta);
  CHECK((g.h0 == rb && g.rho == 0.0));
}
