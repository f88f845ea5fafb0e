#include "tribology/ellipse_traction.hpp"

#include "base/errors.hpp"
#include "tribology/ellipse_breaks.hpp"
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

void check_size(int major, int minor) {
  if (major < 1 || major > kLargestRule || minor < 1 || minor > kLargestRule) {
    throw InputError(
        fmt::format("a contact ellipse rule of {} x {} points cannot be made; each number must lie "
                    "between 1 and {}",
                    major, minor, kLargestRule));
  }
}

/// Gauss-Chebyshev of the second kind over v.
void add_minor_nodes(EllipseRule& rule, int minor) {
  rule.minor = minor;
  for (int j = minor; j >= 1; --j) {
    const double angle = std::numbers::pi * j / (minor + 1.0);
    rule.v.push_back(2 * j == minor + 1 ? 0.0 : std::cos(angle));
    rule.weight_v.push_back(2.0 * std::sin(angle) * std::sin(angle) / (minor + 1.0));
    rule.weight_v1.push_back(rule.weight_v.back() * rule.v.back());
    rule.weight_v2.push_back(rule.weight_v1.back() * rule.v.back());
  }
}

/// One major node with everything that the η integral needs.
struct Row {
  double s, chord, weight;
};

class FixedRule {
 public:
  FixedRule(const bearing::TractionCurve& curve, const EllipseGeometry& geometry,
            const EllipseKinematics& motion, const EllipseRule& rule)
      : curve_(curve), g_(geometry), m_(motion), rule_(rule), floor_(slip_floor(curve)) {}

  EllipseTraction run() {
    note_edge_slip(-1.0, 0.0);
    note_edge_slip(1.0, 0.0);
    if (rule_.split) {
      const EllipseBreaks<double> at = breaks();
      const double ends[kEllipsePieces + 1] = {-1.0, at.s1, at.s2, at.s3, at.s4, 1.0};
      for (int piece = 0; piece < kEllipsePieces; ++piece) {
        const double length = ends[piece + 1] - ends[piece];
        for (std::size_t i = 0; i < rule_.s.size(); ++i) {
          const double s = ends[piece] + length * rule_.s[i];
          const double outside = std::max(1.0 - s * s, 0.0);
          add_row({s, std::sqrt(outside), 0.75 * outside * length * rule_.weight_s[i]});
        }
      }
    } else {
      for (std::size_t i = 0; i < rule_.s.size(); ++i) {
        add_row({rule_.s[i], rule_.chord[i], rule_.weight_s[i]});
      }
    }
    result_.max_slip = fastest_;
    return result_;
  }

 private:
  [[nodiscard]] double height(double xi) const {
    if (g_.rho <= 0.0) return g_.h0;
    const double below = std::sqrt(std::max(g_.rho * g_.rho - xi * xi, 0.0));
    return g_.h0 - xi * xi / (g_.rho + below);
  }
  [[nodiscard]] double rolling_slip(double s) const {
    return m_.u_t + m_.W_n * s * g_.a - m_.W_c * height(s * g_.a);
  }
  [[nodiscard]] EllipseBreaks<double> breaks() const {
    const double law = slip_scale(curve_), sweep = 0.5 * m_.W_n * g_.b;
    const double width = std::sqrt(std::sqrt(std::pow(law, 4) + std::pow(sweep, 4)));
    return ellipse_breaks(rolling_slip(-1.0), rolling_slip(0.0), rolling_slip(1.0), width,
                          [](bool condition, double a, double b) { return condition ? a : b; });
  }
  void note_edge_slip(double s, double chord) {
    const double mean = m_.u_c + m_.W_t * height(s * g_.a);
    const double fastest_c = std::abs(mean) + std::abs(m_.W_n * g_.b * chord);
    fastest_ = std::max(fastest_, std::hypot(fastest_c, rolling_slip(s)));
  }
  void add_row(const Row& row) {
    const double xi = row.s * g_.a;
    const double h = height(xi);
    const double half_width = g_.b * row.chord;
    const double u_t = m_.u_t + m_.W_n * xi - m_.W_c * h;
    const double mean = m_.u_c + m_.W_t * h;
    const double swing = m_.W_n * half_width;          // u_c = mean - swing v
    double g0 = 0.0, g1 = 0.0, g2 = 0.0, speed = 0.0;  // ∫ (κ/s) v^k, ∫ |u|
    for (std::size_t j = 0; j < rule_.v.size(); ++j) {
      const double v = rule_.v[j];
      const double u_c = mean - swing * v;
      const double slip = std::sqrt(u_c * u_c + u_t * u_t + floor_);
      const double g = rule_.weight_v[j] * traction_coefficient(curve_, slip) / slip;
      g0 += g;
      g1 += g * v;
      g2 += g * v * v;
      speed += rule_.weight_v[j] * slip;
    }
    const double load = g_.Q * row.weight;
    const double f_t = load * g0 * u_t;
    const double f_c = load * (mean * g0 - swing * g1);
    const double f_cv = load * (mean * g1 - swing * g2);  // ∫ v f_c
    result_.F_c += f_c;
    result_.F_t += f_t;
    result_.M_c -= h * f_t;
    result_.M_t += h * f_c;
    result_.M_n += xi * f_t - half_width * f_cv;
    result_.heat += u_t * f_t + mean * f_c - swing * f_cv;
    result_.load_slip += load * speed;
    note_edge_slip(row.s, row.chord);
  }

  const bearing::TractionCurve& curve_;
  const EllipseGeometry& g_;
  const EllipseKinematics& m_;
  const EllipseRule& rule_;
  double floor_;
  double fastest_ = 0.0;
  EllipseTraction result_;
};

}  // namespace

EllipseRule make_ellipse_rule(int major, int minor) {
  check_size(major, minor);
  EllipseRule rule;
  rule.major = major;
  // Gauss rule for the weight 1 - s²: its nodes are the zeros of P'_{n+1}, the inner nodes of the
  // Lobatto rule with n + 2 points, and its weights those Lobatto weights times 1 - s².
  // [abramowitz1964 25.4.32]
  const int k = major + 1;
  for (int i = 0; i < major; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 1.0) / k);
    for (int iteration = 0; iteration < 50; ++iteration) {
      const auto [previous, value] = legendre(k, x);
      // (1-x²) P_k' = k (P_{k-1} - x P_k), whose derivative is -k (k+1) P_k.
      const double step = (previous - x * value) / ((k + 1.0) * value);
      x += step;
      if (std::abs(step) < 1e-16) break;
    }
    if (2 * i + 1 == major) x = 0.0;
    const double value = legendre(k, x).value;
    rule.s.push_back(x);
    rule.weight_s.push_back(0.75 * (1.0 - x * x) * 2.0 / (k * (k + 1.0) * value * value));
    rule.chord.push_back(std::sqrt(1.0 - x * x));
  }
  add_minor_nodes(rule, minor);
  return rule;
}

EllipseRule make_split_ellipse_rule(int major, int minor) {
  check_size(major, minor);
  EllipseRule rule;
  rule.split = true;
  // Two nodes integrate the parabola 1 - s² exactly, so the pieces always carry the whole load.
  const int k = std::max(2, (major + kEllipsePieces - 1) / kEllipsePieces);
  rule.major = kEllipsePieces * k;
  for (int i = 0; i < k; ++i) {  // Gauss-Legendre on 0..1
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (k + 0.5));
    double slope = 0.0;
    for (int iteration = 0; iteration < 50; ++iteration) {
      const auto [previous, value] = legendre(k, x);
      slope = k * (previous - x * value) / (1.0 - x * x);
      const double step = value / slope;
      x -= step;
      if (std::abs(step) < 1e-16) break;
    }
    rule.s.push_back(0.5 * (1.0 + x));
    rule.weight_s.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  add_minor_nodes(rule, minor);
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
  return FixedRule(curve, geometry, motion, rule).run();
}

}  // namespace adore::tribology
