#include "contact/subsurface.hpp"

#include "base/errors.hpp"
#include "contact/elliptic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::contact {
namespace {

/// Parameter t of the closed form: (t²-1)(2t-1) = (b/a)², written for u = t - 1 >= 0, where the
/// left side is increasing and convex: Newton from the right descends without overshoot.
double orthogonal_parameter(double ratio_squared) {
  double u = 0.5 * ratio_squared;
  for (int n = 0; n < 60; ++n) {
    const double value = u * (u + 2.0) * (1.0 + 2.0 * u) - ratio_squared;
    const double slope = 2.0 + u * (10.0 + 6.0 * u);
    const double step = value / slope;
    u -= step;
    if (std::abs(step) <= 1e-16 * u) {
      break;
    }
  }
  return 1.0 + u;
}

struct Peak {
  double z, value;
};

/// Largest value of f over depth: scan to find the highest point, then golden section around it.
/// The stress differences have at most one interior maximum beside the one at the surface, far
/// apart on this scan.
template <class Function>
Peak largest_over_depth(double b, Function f) {
  constexpr int kSteps = 60;
  constexpr double kDeepest = 3.0;
  int best = 0;
  double best_value = f(0.0);
  for (int k = 1; k <= kSteps; ++k) {
    const double value = f(kDeepest * b * k / kSteps);
    if (value > best_value) {
      best = k;
      best_value = value;
    }
  }
  double low = kDeepest * b * std::max(best - 1, 0) / kSteps;
  double high = kDeepest * b * std::min(best + 1, kSteps) / kSteps;
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double f_left = f(left);
  double f_right = f(right);
  while (high - low > 4e-8 * b) {
    if (f_left >= f_right) {
      high = right;
      right = left;
      f_right = f_left;
      left = high - golden * (high - low);
      f_left = f(left);
    } else {
      low = left;
      left = right;
      f_left = f_right;
      right = low + golden * (high - low);
      f_right = f(right);
    }
  }
  // Flat top: the vertex of the parabola through three points 1e-4 b apart is sharper than
  // comparisons.
  const double z = 0.5 * (low + high);
  const double h = 1e-4 * b;
  if (z > 2.0 * h) {
    const double f_minus = f(z - h);
    const double f_mid = f(z);
    const double f_plus = f(z + h);
    const double curvature = f_minus - 2.0 * f_mid + f_plus;
    const double shift = curvature < 0.0 ? 0.5 * h * (f_minus - f_plus) / curvature : h;
    if (std::abs(shift) <
        1e-5 * b) {  // a kink (two differences crossing) leaves the golden section's answer
      return {z + shift, std::max(f_mid, f(z + shift))};
    }
  }
  const double at_surface = f(0.0);
  return at_surface >= f(z) ? Peak{0.0, at_surface} : Peak{z, f(z)};
}

}  // namespace

double AxisStress::max_shear() const noexcept {
  const auto [low, high] = std::minmax({major, minor, depth});
  return 0.5 * (high - low);
}

double AxisStress::octahedral() const noexcept {
  return std::hypot(major - minor, minor - depth, depth - major) / 3.0;
}

AxisStress axis_stress(double a, double b, double p_max, double poisson, double z) noexcept {
  const double a2 = a * a + z * z;
  const double b2 = b * b + z * z;
  const double root_a = std::sqrt(a2);
  const double root_b = std::sqrt(b2);
  // I = z ∫_{z²}^∞ dw / ((c²+w) sqrt((a²+w)(b²+w)w)), c = a or b; L = ∫_z^∞ of the same with w^-1/2
  // gone.
  const double along_a = z > 0.0 ? 2.0 / 3.0 * z * carlson_rd(b2, z * z, a2) : 0.0;
  const double along_b = z > 0.0 ? 2.0 / 3.0 * z * carlson_rd(a2, z * z, b2) : 0.0;
  const double surface_a = 2.0 / (root_a * (root_a + root_b));
  const double surface_b = 2.0 / (root_b * (root_a + root_b));
  const double half = 0.5 * p_max * a * b;
  const double common = poisson * (2.0 * (along_a + along_b) - 4.0 / (root_a * root_b));
  AxisStress s;
  s.major = half * (common + 2.0 * (1.0 - poisson) * along_a - (1.0 - 2.0 * poisson) * surface_a);
  s.minor = half * (common + 2.0 * (1.0 - poisson) * along_b - (1.0 - 2.0 * poisson) * surface_b);
  s.depth = -p_max * a * b / (root_a * root_b);
  return s;
}

SubsurfaceStress subsurface_stress(double a, double b, double p_max, double poisson) {
  if (!(std::isfinite(a) && b > 0.0 && a >= b * (1.0 - 1e-12))) {
    throw InputError(fmt::format(
        "subsurface stress: the half axes are a = {} m and b = {} m; they must satisfy a >= b > 0",
        a, b));
  }
  if (!(std::isfinite(p_max) && p_max >= 0.0)) {
    throw InputError(fmt::format(
        "subsurface stress: the peak pressure is {} Pa; it must not be negative", p_max));
  }
  if (!(poisson >= 0.0 && poisson <= 0.5)) {
    throw InputError(
        fmt::format("subsurface stress: Poisson's ratio is {}; it must be 0 to 0.5", poisson));
  }
  SubsurfaceStress s;
  const double t = orthogonal_parameter((b / a) * (b / a));
  const double root = std::sqrt(2.0 * t - 1.0);
  s.orthogonal_shear = p_max * root / (2.0 * t * (t + 1.0));
  s.orthogonal_depth = b / ((t + 1.0) * root);
  s.orthogonal_offset = b * t / (t + 1.0) * std::sqrt(2.0 * t + 1.0) / root;
  const Peak shear = largest_over_depth(
      b, [&](double z) { return axis_stress(a, b, 1.0, poisson, z).max_shear(); });
  s.max_shear = p_max * shear.value;
  s.max_shear_depth = shear.z;
  const Peak octahedral = largest_over_depth(
      b, [&](double z) { return axis_stress(a, b, 1.0, poisson, z).octahedral(); });
  s.octahedral = p_max * octahedral.value;
  s.octahedral_depth = octahedral.z;
  s.von_mises = 3.0 / std::numbers::sqrt2 * s.octahedral;
  return s;
}

}  // namespace adore::contact
