#include "tribology/ellipse_traction.hpp"

#include "base/errors.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::tribology {
namespace {

constexpr int kLargestRule = 200;

/// Legendre P_{k-1}(x) and P_k(x) by the three-term recurrence, k >= 1.
struct LegendrePair {
  double previous, value;
};
LegendrePair legendre(int k, double x) {
  double previous = 1.0, value = x;
  for (int j = 2; j <= k; ++j) {
    const double next = ((2 * j - 1) * x * value - (j - 1) * previous) / j;
    previous = value;
    value = next;
  }
  return {previous, value};
}

}  // namespace

EllipseRule make_ellipse_rule(int major, int minor) {
  if (major < 1 || major > kLargestRule || minor < 1 || minor > kLargestRule) {
    throw InputError(
        fmt::format("a contact ellipse rule of {} x {} points cannot be made; each number must lie "
                    "between 1 and {}",
                    major, minor, kLargestRule));
  }
  EllipseRule rule;
  rule.major = major;
  rule.minor = minor;
  // Gauss rule for the weight 1 - s²: its nodes are the zeros of P'_{n+1}, the inner nodes of the
  // Lobatto rule with n + 2 points, and its weights those Lobatto weights times 1 - s².
  // [abramowitz1964 25.4.32]
  const int k = major + 1;
  for (int i = 0; i < major; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 1.0) / k);
    for (int iteration = 0; iteration < 50; ++iteration) {
      const auto [previous, value] = legendre(k, x);
      // (1-x²) P_k' = k (P_{k-1} - x P_k) = q; q' = -k (k+1) P_k.
      const double step = (previous - x * value) / ((k + 1.0) * value);
      x += step;
      if (std::abs(step) < 1e-16) break;
    }
    if (2 * i + 1 == major) x = 0.0;
    const double value = legendre(k, x).value;
    rule.s.push_back(x);
    rule.weight_s.push_back(0.75 * (1.0 - x * x) * 2.0 / (k * (k + 1.0) * value * value));
  }
  for (int j = minor; j >= 1; --j) {
    const double angle = std::numbers::pi * j / (minor + 1.0);
    rule.v.push_back(2 * j == minor + 1 ? 0.0 : std::cos(angle));
    rule.weight_v.push_back(2.0 * std::sin(angle) * std::sin(angle) / (minor + 1.0));
  }
  for (double x : rule.s) rule.chord.push_back(std::sqrt(1.0 - x * x));
  for (int j = 0; j < minor; ++j) {
    rule.weight_v1.push_back(rule.weight_v[j] * rule.v[j]);
    rule.weight_v2.push_back(rule.weight_v1[j] * rule.v[j]);
  }
  return rule;
}

void set_contact_surface(EllipseGeometry& geometry, ContactSurface surface, double ball_radius,
                         double groove_radius, double approach) noexcept {
  const double rho = 2.0 * ball_radius * groove_radius / (ball_radius + groove_radius);
  const auto chord = [&](double radius) {
    return std::sqrt(std::max(radius * radius - geometry.a * geometry.a, 0.0));
  };
  switch (surface) {
    case ContactSurface::CurvedEdge:
      geometry.rho = rho;
      geometry.h0 = rho - chord(rho) + chord(ball_radius);
      return;
    case ContactSurface::CurvedHalf:
      geometry.rho = rho;
      geometry.h0 = ball_radius - 0.5 * approach;
      return;
    case ContactSurface::CurvedUndeformed:
      geometry.rho = rho;
      geometry.h0 = ball_radius;
      return;
    case ContactSurface::FlatUndeformed:
      geometry.rho = 0.0;
      geometry.h0 = ball_radius;
      return;
    case ContactSurface::FlatHalf:
      geometry.rho = 0.0;
      geometry.h0 = ball_radius - 0.5 * approach;
      return;
    case ContactSurface::FlatEdge:
      geometry.rho = 0.0;
      geometry.h0 = chord(ball_radius);
      return;
  }
}

EllipseTraction ellipse_traction(const bearing::TractionCurve& curve,
                                 const EllipseGeometry& geometry, const EllipseKinematics& motion,
                                 const EllipseRule& rule) noexcept {
  EllipseTraction result;
  const double tiny = slip_floor(curve);
  double fastest = 0.0;
  const auto height = [&](double xi) {
    if (geometry.rho <= 0.0) return geometry.h0;
    const double below = std::sqrt(std::max(geometry.rho * geometry.rho - xi * xi, 0.0));
    return geometry.h0 - xi * xi / (geometry.rho + below);
  };
  for (double end : {-1.0, 1.0}) {
    const double h = height(end * geometry.a);
    fastest =
        std::max(fastest, std::hypot(motion.u_c + motion.W_t * h,
                                     motion.u_t + motion.W_n * end * geometry.a - motion.W_c * h));
  }
  for (int i = 0; i < rule.major; ++i) {
    const double xi = rule.s[i] * geometry.a;
    const double h = height(xi);
    const double half_width = geometry.b * rule.chord[i];
    const double u_t = motion.u_t + motion.W_n * xi - motion.W_c * h;
    const double mean = motion.u_c + motion.W_t * h;
    const double swing = motion.W_n * half_width;      // u_c = mean - swing v
    double g0 = 0.0, g1 = 0.0, g2 = 0.0, speed = 0.0;  // ∫ (κ/s) v^k, ∫ |u|
    for (int j = 0; j < rule.minor; ++j) {
      const double v = rule.v[j];
      const double u_c = mean - swing * v;
      const double slip = std::sqrt(u_c * u_c + u_t * u_t + tiny);
      const double g = rule.weight_v[j] * traction_coefficient(curve, slip) / slip;
      g0 += g;
      g1 += g * v;
      g2 += g * v * v;
      speed += rule.weight_v[j] * slip;
    }
    const double load = geometry.Q * rule.weight_s[i];
    const double f_t = load * g0 * u_t;
    const double f_c = load * (mean * g0 - swing * g1);
    const double f_cv = load * (mean * g1 - swing * g2);  // ∫ v f_c
    result.F_c += f_c;
    result.F_t += f_t;
    result.M_c -= h * f_t;
    result.M_t += h * f_c;
    result.M_n += xi * f_t - half_width * f_cv;
    result.heat += u_t * f_t + mean * f_c - swing * f_cv;
    result.load_slip += load * speed;
    fastest = std::max(fastest, std::hypot(std::abs(mean) + std::abs(swing), u_t));
  }
  result.max_slip = fastest;
  return result;
}

}  // namespace adore::tribology
