#include "tribology/ellipse_split.hpp"

#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::tribology;

namespace {

bearing::TractionCurve two_slope() {
  bearing::TractionCurve curve;
  curve.form = bearing::TractionCurve::Form::TwoSlope;
  curve.B = 0.5;
  curve.u0 = 0.1;
  return curve;
}

bearing::TractionCurve exponential() {
  bearing::TractionCurve curve;
  curve.A = -0.04;
  curve.B = 0.02;
  curve.C = 8.0;
  curve.D = 0.04;
  return curve;
}

}  // namespace

TEST_CASE("Split rule: converged traction of laws without a jump at rest", "[physics][traction]") {
  const EllipseGeometry curved{330.0, 1.03e-3, 1.42e-4, 6.47e-3, 6.32e-3};
  EllipseGeometry flat = curved;
  flat.rho = 0.0;
  const auto rolling = [](double u_c, double u_t, double W_c, double W_t, double W_n) {
    return EllipseKinematics{u_c, u_t + W_c * 6.32e-3, W_c, W_t,
                             W_n};  // u_t at the middle of the contact
  };
  const EllipseKinematics motions[] = {
      rolling(0.03, 0.02, -1500, 3, 100),      // kinks across the ellipse
      rolling(0.0, 1e-6, -2000, 0, 0),         // no spin: rows without kinks
      rolling(0.3, 0.2, -1500, -100, 600),     // spin
      rolling(0.02, 0.01, -4500, -20, 1800)};  // narrow reversal in a wide slip range
  for (const bearing::TractionCurve& curve : {two_slope(), exponential()})
    for (const EllipseGeometry& geometry : {curved, flat})
      for (const EllipseKinematics& motion : motions) {
        const EllipseTraction expected = ellipse_traction_converged(curve, geometry, motion);
        const EllipseTraction got = ellipse_traction_split(curve, geometry, motion, 24);
        // 24 points: 1e-8 of the largest possible traction κ Q, whatever the kinematics above
        const double force = 1e-8 * 0.05 * geometry.Q;
        CHECK(got.F_c == Approx(expected.F_c).margin(force));
        CHECK(got.F_t == Approx(expected.F_t).margin(force));
        CHECK(got.M_c == Approx(expected.M_c).margin(force * geometry.h0));
        CHECK(got.M_t == Approx(expected.M_t).margin(force * geometry.h0));
        CHECK(got.M_n == Approx(expected.M_n).margin(force * geometry.a));
        CHECK(got.heat == Approx(expected.heat).epsilon(1e-7));
        CHECK(got.load_slip == Approx(expected.load_slip).epsilon(1e-7));
      }
}

TEST_CASE("Split rule: open contact → no traction", "[unit][traction]") {
  const EllipseTraction open = ellipse_traction_split(two_slope(), {}, {0.1, 0.1, 0.0, 0.0, 0.0});
  CHECK(open.F_t == 0.0);
  CHECK(open.heat == 0.0);
}
