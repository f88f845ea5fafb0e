#include "tribology/adaptive_integral.hpp"
#include "tribology/ellipse_traction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

/// With s = sin φ and v = sin ψ the load element is p dA = Q ¾ cos³φ dφ (2/π) cos²ψ dψ. At fixed φ
/// the slip is (mean - swing v, u_t), so |u|² is a quadratic in v: the inner integral is split at
/// its minimum (slip reversal) and where |u| passes the kink of the law. The outer integral is
/// split where u_t = 0, where those points appear (|u_t| = kink) and where they cross the edge of
/// the ellipse.
namespace adore::tribology {
namespace {

constexpr double kInnerTolerance = 1e-13;
constexpr double kOuterTolerance = 1e-12;
constexpr int kPanels = 400;     ///< bound per piece; reached only where the law itself is singular
constexpr int kScanCells = 512;  ///< cells in which break points are looked for

struct Row {
  double xi, h, half_width;
  double u_t, mean, swing;  ///< u_c = mean - swing v
};

class Kinematics {
 public:
  Kinematics(const EllipseGeometry& geometry, const EllipseKinematics& motion)
      : g_(geometry), m_(motion) {}

  [[nodiscard]] Row row(double phi) const {
    Row row;
    row.xi = g_.a * std::sin(phi);
    row.half_width = g_.b * std::cos(phi);
    row.h = g_.height(row.xi);
    row.u_t = m_.u_t + m_.W_n * row.xi - m_.W_c * row.h;
    row.mean = m_.u_c + m_.W_t * row.h;
    row.swing = m_.W_n * row.half_width;
    return row;
  }
  /// |u| on the edge, side = -1 or 1.
  [[nodiscard]] double edge_slip(double phi, double side) const {
    const Row r = row(phi);
    return std::hypot(r.mean - side * r.swing, r.u_t);
  }

 private:
  EllipseGeometry g_;
  EllipseKinematics m_;
};

template <class F>
double bisect(const F& f, double lo, double hi) {
  const bool rising = f(hi) > 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (lo + hi);
    ((f(middle) > 0.0) == rising ? hi : lo) = middle;
  }
  return 0.5 * (lo + hi);
}

/// Minimum of f in [lo, hi] by golden section.
template <class F>
double minimise(const F& f, double lo, double hi) {
  constexpr double kGolden = 0.6180339887498949;
  double a = hi - kGolden * (hi - lo), b = lo + kGolden * (hi - lo);
  double fa = f(a), fb = f(b);
  for (int i = 0; i < 60; ++i) {
    if (fa < fb) {
      hi = std::exchange(b, a);
      fb = fa;
      a = hi - kGolden * (hi - lo);
      fa = f(a);
    } else {
      lo = std::exchange(a, b);
      fa = fb;
      b = lo + kGolden * (hi - lo);
      fb = f(b);
    }
  }
  return 0.5 * (lo + hi);
}

constexpr double kEnd = 0.5 * std::numbers::pi;

double scan_angle(int i) { return kEnd * (2.0 * i / kScanCells - 1.0); }

/// Zeros of f over the ellipse, also pairs closer than a cell: a minimum of |f| is searched for
/// more.
template <class F>
void append_zeros(const F& f, std::vector<double>& breaks) {
  std::array<double, kScanCells + 1> value;
  for (int i = 0; i <= kScanCells; ++i) value[static_cast<std::size_t>(i)] = f(scan_angle(i));
  for (std::size_t i = 0; i < kScanCells; ++i) {
    const double lo = scan_angle(static_cast<int>(i)), hi = scan_angle(static_cast<int>(i) + 1);
    if ((value[i] > 0.0) != (value[i + 1] > 0.0)) {
      breaks.push_back(bisect(f, lo, hi));
    } else if (i > 0) {
      const double sign = value[i] > 0.0 ? 1.0 : -1.0;
      const double before = lo - (hi - lo);
      if (sign * value[i] >= sign * value[i - 1] || sign * value[i] > sign * value[i + 1]) continue;
      const auto size = [&](double x) { return sign * f(x); };
      const double nearest = minimise(size, before, hi);
      breaks.push_back(nearest);
      if (size(nearest) < 0.0) {
        breaks.push_back(bisect(f, before, nearest));
        breaks.push_back(bisect(f, nearest, hi));
      }
    }
  }
}

std::vector<double> outer_breaks(const Kinematics& kinematics, double kink) {
  std::vector<double> breaks{-kEnd, kEnd};
  const auto u_t = [&](double phi) { return kinematics.row(phi).u_t; };
  append_zeros(u_t, breaks);
  for (double side : {-1.0, 1.0}) {
    append_zeros(
        [&](double phi) {
          const Row row = kinematics.row(phi);
          return row.mean - side * row.swing;
        },
        breaks);
    if (kink > 0.0) {
      append_zeros([&](double phi) { return u_t(phi) - side * kink; }, breaks);
      append_zeros([&](double phi) { return kinematics.edge_slip(phi, side) - kink; }, breaks);
    }
  }
  std::sort(breaks.begin(), breaks.end());
  const auto same = [](double a, double b) { return b - a < 1e-12; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
  return breaks;
}

/// Break points ψ of the inner integral, ascending; returns their number.
int inner_breaks(const Row& row, double kink, std::array<double, 5>& breaks) {
  int count = 0;
  breaks[static_cast<std::size_t>(count++)] = -kEnd;
  const auto append = [&](double v) {
    if (std::abs(v) < 1.0) breaks[static_cast<std::size_t>(count++)] = std::asin(v);
  };
  if (row.swing != 0.0) {
    const double reach = kink * kink - row.u_t * row.u_t;
    const double side = reach > 0.0 ? std::sqrt(reach) : 0.0;
    if (side > 0.0) append((row.mean - side) / row.swing);
    append(row.mean / row.swing);
    if (side > 0.0) append((row.mean + side) / row.swing);
  }
  breaks[static_cast<std::size_t>(count++)] = kEnd;
  std::sort(breaks.begin(), breaks.begin() + count);
  return count;
}

double largest_slip(const Kinematics& kinematics) {
  double largest = 0.0;
  for (double side : {-1.0, 1.0}) {
    int best = 0;
    const auto slowness = [&](double phi) { return -kinematics.edge_slip(phi, side); };
    for (int i = 1; i <= kScanCells; ++i) {
      if (slowness(scan_angle(i)) < slowness(scan_angle(best))) best = i;
    }
    const double phi = minimise(slowness, scan_angle(std::max(best - 1, 0)),
                                scan_angle(std::min(best + 1, kScanCells)));
    largest = std::max(
        {largest, kinematics.edge_slip(phi, side), kinematics.edge_slip(scan_angle(best), side)});
  }
  return largest;
}

/// Per unit load: ∫ κ, ∫ κ|u|, ∫ |u| by a fixed rule, as the reference for "small".
struct Sizes {
  double coefficient = 0.0, heat = 0.0, slip = 0.0;
};

/// Input of a law at a point: its pressure, or the peak of its strip, as fractions of the
/// contact's.
template <class Law>
double pressure_at(double strip_peak, double of_strip) {
  return is_strip_law<Law>() ? strip_peak : strip_peak * of_strip;
}

template <class Law, class Here>
Sizes typical_sizes(const Here& law, const Kinematics& kinematics, double p0) {
  const EllipseRule rule = make_ellipse_rule(24, 16);
  Sizes sizes;
  for (std::size_t i = 0; i < rule.s.size(); ++i) {
    const Row row = kinematics.row(std::asin(rule.s[i]));
    for (std::size_t j = 0; j < rule.v.size(); ++j) {
      const double weight = rule.weight_s[i] * rule.weight_v[j];
      const double slip = std::hypot(row.mean - row.swing * rule.v[j], row.u_t);
      const double pressure =
          pressure_at<Law>(p0 * rule.chord[i], std::sqrt(1.0 - rule.v[j] * rule.v[j]));
      const double kappa = std::abs(law(slip, pressure));
      sizes.coefficient += weight * kappa;
      sizes.heat += weight * kappa * slip;
      sizes.slip += weight * slip;
    }
  }
  return sizes;
}

template <class Law>
EllipseTraction integrate(const Law& of_contacts, const EllipseGeometry& geometry,
                          const EllipseKinematics& motion) {
  EllipseTraction result;
  if (!(geometry.Q > 0.0)) return result;
  const double kink = of_contacts.kink();
  const Kinematics kinematics(geometry, motion);
  result.max_slip = largest_slip(kinematics);
  const double p0 = 1.5 * geometry.Q / (std::numbers::pi * geometry.a * geometry.b);
  const auto law = of_contacts.at(
      ContactConditions<double>{geometry.Q, p0, geometry.a, geometry.b, motion.entrainment,
                                middle_slip(geometry, motion), motion.curvature});
  const Sizes sizes = typical_sizes<Law>(law, kinematics, p0);
  if (!(sizes.slip > 0.0)) return result;  // κ(0) means no force at exactly zero slip
  // A law of zero traction still needs the load-slip integral.
  const double coefficient = std::max(sizes.coefficient, 1e-300),
               heat = std::max(sizes.heat, 1e-300);

  // Inner: κ u_t/|u|, κ u_c/|u|, v κ u_c/|u|, κ |u|, |u|.
  AdaptiveIntegral<5> inner({coefficient, coefficient, coefficient, heat, sizes.slip},
                            kInnerTolerance, kPanels);
  const auto inner_sums = [&](double phi, const Row& row) {
    std::array<double, 5> breaks{};
    const int count = inner_breaks(row, kink, breaks);
    const auto integrand = [&](double psi) {
      const double v = std::sin(psi), cosine = std::cos(psi);
      const double u_c = row.mean - row.swing * v;
      const double slip = std::sqrt(u_c * u_c + row.u_t * row.u_t);
      const double kappa =
          slip > 0.0 ? law(slip, pressure_at<Law>(p0 * std::cos(phi), cosine)) : 0.0;
      const double along_c = slip > 0.0 ? kappa * u_c / slip : 0.0;
      const double along_t = slip > 0.0 ? kappa * row.u_t / slip : 0.0;
      const double weight = 2.0 / std::numbers::pi * cosine * cosine;
      return std::array<double, 5>{weight * along_t, weight * along_c, weight * v * along_c,
                                   weight * kappa * slip, weight * slip};
    };
    std::array<double, 5> sum{};
    for (int i = 0; i + 1 < count; ++i) {
      const auto part = inner.integrate_piece(integrand, breaks[static_cast<std::size_t>(i)],
                                              breaks[static_cast<std::size_t>(i) + 1]);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
    }
    return sum;
  };
  // Outer, per unit load: F_c, F_t, M_c, M_t, M_n, heat, load-slip.
  const double arm = std::abs(geometry.h0) > 0.0 ? std::abs(geometry.h0) : geometry.a;
  AdaptiveIntegral<7> outer({coefficient, coefficient, coefficient * arm, coefficient * arm,
                             coefficient * geometry.a, heat, sizes.slip},
                            kOuterTolerance, kPanels);
  const auto integrand = [&](double phi) {
    const Row row = kinematics.row(phi);
    const auto sum = inner_sums(phi, row);
    const double cosine = std::cos(phi);
    const double weight = 0.75 * cosine * cosine * cosine;
    return std::array<double, 7>{weight * sum[1],
                                 weight * sum[0],
                                 -weight * row.h * sum[0],
                                 weight * row.h * sum[1],
                                 weight * (row.xi * sum[0] - row.half_width * sum[2]),
                                 weight * sum[3],
                                 weight * sum[4]};
  };
  const std::vector<double> breaks = outer_breaks(kinematics, kink);
  std::array<double, 7> total{};
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const auto part = outer.integrate_piece(integrand, breaks[i], breaks[i + 1]);
    for (std::size_t k = 0; k < total.size(); ++k) total[k] += geometry.Q * part[k];
  }
  result.F_c = total[0], result.F_t = total[1];
  result.M_c = total[2], result.M_t = total[3], result.M_n = total[4];
  result.heat = total[5], result.load_slip = total[6];
  return result;
}

}  // namespace

EllipseTraction ellipse_traction_converged(const TractionLaw& law, const EllipseGeometry& geometry,
                                           const EllipseKinematics& motion) {
  return law.visit([&](const auto& own) { return integrate(own, geometry, motion); });
}

EllipseTraction ellipse_traction_converged(const TractionFunction& law,
                                           const EllipseGeometry& geometry,
                                           const EllipseKinematics& motion) {
  return integrate(law, geometry, motion);
}

}  // namespace adore::tribology
