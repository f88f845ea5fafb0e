#include "tribology/traction_curve.hpp"

#include "base/errors.hpp"
#include "tribology/traction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::tribology {
namespace {

using bearing::TractionCurve;

/// Coefficients that are zero in exact arithmetic (A + D) may come out of a text file like this.
constexpr double kZeroCoefficient = 1e-12;

TractionCurve exponential(double A, double B, double C, double D) {
  TractionCurve curve;
  curve.form = TractionCurve::Form::Exponential;
  curve.A = A, curve.B = B, curve.C = C, curve.D = D;
  return curve;
}

/// Smallest κ over u >= 0 of an exponential law with C >= 0.
double least_exponential(const TractionCurve& curve) {
  double least = curve.A + curve.D;
  if (curve.C == 0.0) return curve.B < 0.0 ? -HUGE_VAL : least;
  least = std::min(least, curve.D);
  if (curve.B != 0.0) {
    const double turn = 1.0 / curve.C - curve.A / curve.B;  // κ'(u) = 0
    if (turn > 0.0) least = std::min(least, traction_coefficient(curve, turn));
  }
  return least;
}

TractionCurve from_coefficients(const std::array<double, 4>& tc) {
  const TractionCurve curve = exponential(tc[0], tc[1], tc[2], tc[3]);
  if (curve.C < 0.0) {
    throw InputError(
        fmt::format("the decay C = {} s/m of the exponential traction law is negative, so the "
                    "traction would grow "
                    "without bound with slip; give C >= 0",
                    curve.C));
  }
  if (least_exponential(curve) < -kZeroCoefficient) {
    throw InputError(
        fmt::format("the exponential traction law with A = {}, B = {} s/m, C = {} s/m, D = {} is "
                    "negative at some "
                    "slip, so traction would drive the sliding; A + D, D and the value at the "
                    "turning point must "
                    "be >= 0",
                    curve.A, curve.B, curve.C, curve.D));
  }
  return curve;
}

TractionCurve two_slopes(const std::array<double, 4>& tc) {
  TractionCurve curve;
  curve.form = TractionCurve::Form::TwoSlope;
  curve.A = tc[0], curve.B = tc[1], curve.C = tc[2], curve.u0 = tc[3];
  if (curve.u0 < 0.0) {
    throw InputError(
        fmt::format("the slip u0 = {} m/s at the slope change of the two-slope traction law is "
                    "negative; give u0 >= 0",
                    curve.u0));
  }
  const double bend = curve.A + curve.B * curve.u0;
  const double far = traction_coefficient(curve, kLargestSlip);
  if (std::min({curve.A, bend, far}) < -kZeroCoefficient) {
    throw InputError(
        fmt::format("the two-slope traction law is negative within the slip range: it is {} at "
                    "rest, {} at u0 = {} "
                    "m/s and {} at {} m/s; all three must be >= 0",
                    curve.A, bend, curve.u0, far, kLargestSlip));
  }
  return curve;
}

/// Root x > 0 of (1 - x) exp(x) = r for r < 1, by Newton on 1 - x - r exp(-x) inside a bracket.
double solve_maximum_condition(double r) {
  double lo = r >= 0.0 ? 0.0 : 1.0;
  double hi = r >= 0.0 ? 1.0 : 1.0 + std::log1p(-r);
  // Near r = 1 the law is flat: r = 1 - x²/2 - x³/3 ...; for large -r, x ≈ ln(-r).
  double x =
      r > 0.5 ? std::sqrt(2.0 * (1.0 - r)) : (r < -1.0 ? std::log(-r) : 1.0 - r / std::exp(1.0));
  for (int i = 0; i < 100; ++i) {
    x = x > lo && x < hi ? x : 0.5 * (lo + hi);
    const double decay = r * std::exp(-x);
    const double value = 1.0 - x - decay;
    (value > 0.0 ? lo : hi) = x;
    const double step = value / (1.0 - decay);
    x += step;
    if (std::abs(step) <= 4e-16 * x) break;
  }
  return std::clamp(x, lo, hi);
}

TractionCurve from_maximum(const std::array<double, 4>& tc) {
  const auto [k0, km, kinf, um] = tc;
  if (!(um > 0.0)) {
    throw InputError(fmt::format(
        "the slip u_m = {} m/s at maximum traction must be positive; give u_m > 0", um));
  }
  if (std::min({k0, km, kinf}) < 0.0) {
    throw InputError(
        fmt::format("traction coefficients cannot be negative: at zero slip {}, maximum {}, at "
                    "infinite slip {}",
                    k0, km, kinf));
  }
  if (!(km > k0)) {
    throw InputError(
        fmt::format("the maximum traction coefficient {} must exceed the coefficient at zero slip, "
                    "{}; raise the maximum or use the asymptotic law (type 2)",
                    km, k0));
  }
  if (!(km > kinf)) {
    throw InputError(
        fmt::format("the maximum traction coefficient {} must exceed the coefficient at infinite "
                    "slip, {}; raise the maximum or use the asymptotic law (type 2)",
                    km, kinf));
  }
  const double M = km - kinf;
  const double A = k0 - kinf;
  const double x = A == 0.0 ? 1.0 : solve_maximum_condition(A / M);
  const double C = x / um;
  return exponential(A, C * M * std::exp(x), C, kinf);
}

TractionCurve from_asymptote(const std::array<double, 4>& tc) {
  const double k0 = tc[0], kinf = tc[1], slope = tc[2];
  if (std::min(k0, kinf) < 0.0) {
    throw InputError(fmt::format(
        "traction coefficients cannot be negative: at zero slip {}, at infinite slip {}", k0,
        kinf));
  }
  if (k0 == kinf && slope == 0.0) return exponential(0.0, 0.0, 0.0, kinf);
  if (!(slope * (kinf - k0) > 0.0)) {
    throw InputError(fmt::format(
        "the initial slope {} s/m of the traction law does not fit the coefficients {} at zero "
        "slip and {} at infinite slip; the slope must have the sign of their difference, {}",
        slope, k0, kinf, kinf - k0));
  }
  return exponential(k0 - kinf, 0.0, slope / (kinf - k0), kinf);
}

}  // namespace

TractionCurve traction_curve(int type, const std::array<double, 4>& tc) {
  for (std::size_t i = 0; i < tc.size(); ++i) {
    if (!std::isfinite(tc[i])) {
      throw InputError(
          fmt::format("value {} of the traction law is {}; give a finite number", i + 1, tc[i]));
    }
  }
  switch (type) {
    case -1:
      return from_coefficients(tc);
    case 0:
      return two_slopes(tc);
    case 1:
      return from_maximum(tc);
    case 2:
      return from_asymptote(tc);
    default:
      break;
  }
  throw InputError(
      fmt::format("there is no traction law of type {}; the types are -1 (A, B, C, D), 0 (two "
                  "slopes), 1 (maximum) "
                  "and 2 (asymptotic)",
                  type));
}

double traction_coefficient(const TractionCurve& curve, double slip) noexcept {
  return TractionLaw(curve).coefficient(slip);
}

double traction_slope(const TractionCurve& curve, double slip) noexcept {
  if (curve.form == TractionCurve::Form::TwoSlope) return slip <= curve.u0 ? curve.B : curve.C;
  return (curve.B - curve.C * (curve.A + curve.B * slip)) * std::exp(-curve.C * slip);
}

double max_traction_coefficient(const TractionCurve& curve) noexcept {
  double largest =
      std::max(traction_coefficient(curve, 0.0), traction_coefficient(curve, kLargestSlip));
  double turn = curve.u0;
  if (curve.form == TractionCurve::Form::Exponential)
    turn = curve.B != 0.0 && curve.C > 0.0 ? 1.0 / curve.C - curve.A / curve.B : 0.0;
  if (turn > 0.0 && turn < kLargestSlip)
    largest = std::max(largest, traction_coefficient(curve, turn));
  return largest;
}

}  // namespace adore::tribology
