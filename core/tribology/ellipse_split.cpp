#include "tribology/ellipse_split.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace adore::tribology {
namespace {

constexpr double kHalfPi = 0.5 * std::numbers::pi;

/// Gauss-Legendre points on [-1, 1].
struct Gauss {
  std::vector<double> node, weight;
};

Gauss make_gauss(int n) {
  Gauss rule;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1.0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double p0 = 1.0, p1 = x;
      for (int k = 2; k <= n; ++k) {
        const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
      }
      slope = n * (x * p1 - p0) / (x * x - 1);
      const double step = p1 / slope;
      x -= step;
      if (std::abs(step) < 1e-16) break;
    }
    rule.node.push_back(x);
    rule.weight.push_back(2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

const Gauss& gauss(int n) {
  static const std::vector<Gauss> rules = [] {
    std::vector<Gauss> all;
    for (int k = 0; k <= 40; ++k) all.push_back(k < 4 ? Gauss{} : make_gauss(k));
    return all;
  }();
  return rules[static_cast<std::size_t>(n)];
}

struct Row {
  double xi, h, u_t, mean, swing;  ///< u_c = mean - swing v
};

template <class Here>
class Integral {
 public:
  /// @param of_strip the law wants the peak pressure of a strip (laws/contact_point.hpp)
  Integral(const Here& law, bool of_strip, double kink, double peak_pressure,
           const EllipseGeometry& g, const EllipseKinematics& m, int points)
      : law_(law),
        of_strip_(of_strip),
        peak_(peak_pressure),
        g_(g),
        m_(m),
        gauss_(gauss(points)),
        kink_(kink) {}

  EllipseTraction run() {
    const std::vector<double> cuts = outer_cuts();
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const double middle = 0.5 * (cuts[k] + cuts[k + 1]), half = 0.5 * (cuts[k + 1] - cuts[k]);
      for (std::size_t i = 0; i < gauss_.node.size(); ++i) {
        const double tau = kHalfPi * gauss_.node[i];  // φ = middle + half sin τ
        const double phi = middle + half * std::sin(tau), c = std::cos(phi);
        add_row(row(phi), c, 0.75 * c * c * c * gauss_.weight[i] * half * kHalfPi * std::cos(tau));
      }
    }
    return sum_;
  }

 private:
  [[nodiscard]] Row row(double phi) const {
    Row r{};
    r.xi = g_.a * std::sin(phi);
    r.h = g_.height(r.xi);
    r.u_t = m_.u_t + m_.W_n * r.xi - m_.W_c * r.h;
    r.mean = m_.u_c + m_.W_t * r.h;
    r.swing = m_.W_n * g_.b * std::cos(phi);
    return r;
  }

  /// Functions of a row whose zeros bound the pieces: u_t = 0 (slip reversal), |u_t| = kink, and
  /// |u| = kink at either edge.
  [[nodiscard]] std::array<double, 5> marks(double phi) const {
    const Row r = row(phi);
    const auto edge = [&](double side) {
      return std::hypot(r.mean - side * r.swing, r.u_t) - kink_;
    };
    return {r.u_t, r.u_t - kink_, r.u_t + kink_, edge(1.0), edge(-1.0)};
  }

  [[nodiscard]] std::vector<double> outer_cuts() const {
    std::vector<double> cuts = {-kHalfPi, 0.0, kHalfPi};
    const std::size_t used = kink_ > 0.0 ? 5 : 1;
    constexpr int kCells = 48;
    std::array<double, 5> left = marks(-kHalfPi);
    for (int cell = 0; cell < kCells; ++cell) {
      const double a = -kHalfPi + cell * (2 * kHalfPi / kCells),
                   b = -kHalfPi + (cell + 1) * (2 * kHalfPi / kCells);
      const std::array<double, 5> right = marks(b);
      for (std::size_t k = 0; k < used; ++k)
        if ((left[k] > 0.0) != (right[k] > 0.0)) cuts.push_back(zero(k, a, left[k], b, right[k]));
      left = right;
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
  }

  [[nodiscard]] double zero(std::size_t k, double a, double fa, double b, double fb) const {
    for (int i = 0; i < 60 && b - a > 1e-14; ++i) {  // Illinois
      const double c =
          i % 12 == 11 ? 0.5 * (a + b) : std::clamp(b - fb * (b - a) / (fb - fa), a, b);
      const double fc = marks(c)[k];
      if (fc == 0.0) return c;
      if ((fc > 0.0) == (fb > 0.0)) {
        b = c, fb = fc;
        fa *= 0.5;
      } else {
        a = c, fa = fc;
        fb *= 0.5;
      }
      if (std::abs(fc) < 1e-15 * (kink_ + std::abs(m_.W_c) * g_.h0)) return c;
    }
    return 0.5 * (a + b);
  }

  /// Points in ψ are ψ0 + ε sinh σ, Gauss in σ: ψ0 is the place of least slip, ε the width of the
  /// peak of 1/|u| there.
  void add_row(const Row& r, double chord_s, double weight) {
    const double swing = std::max(std::abs(r.swing), 1e-300);
    const double least = std::clamp(r.mean / std::copysign(swing, r.swing), -1.0, 1.0);
    const double beyond = std::max(std::abs(r.mean) - swing, 0.0);
    const double width = std::clamp(std::max({std::abs(r.u_t), kink_, beyond}) / swing, 1e-12, 9.0);
    const double centre = std::asin(least);
    const double epsilon = width / std::max(std::cos(centre), std::sqrt(width));

    std::array<double, 5> cuts = {-kHalfPi, kHalfPi, kHalfPi, kHalfPi, kHalfPi};
    std::size_t pieces = 1;
    const auto cut = [&](double v) {
      if (!(v > -1.0 && v < 1.0)) return;
      cuts[pieces++] = std::asin(v);
      cuts[pieces] = kHalfPi;
    };
    const double room = kink_ * kink_ - r.u_t * r.u_t;
    if (kink_ > 0.0 && room > 0.0 && r.swing != 0.0) {
      const double half = std::sqrt(room) / swing, middle = r.mean / r.swing;
      cut(middle - half);
      cut(middle + half);
    } else if (epsilon < 1.0) {
      cut(least);
    }
    double f_c = 0.0, f_t = 0.0, m_n = 0.0, heat = 0.0, load_slip = 0.0;
    for (std::size_t k = 0; k < pieces; ++k) {
      const double from = std::asinh((cuts[k] - centre) / epsilon),
                   to = std::asinh((cuts[k + 1] - centre) / epsilon);
      const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
      for (std::size_t i = 0; i < gauss_.node.size(); ++i) {
        const double grow = std::exp(middle + half * gauss_.node[i]), shrink = 1 / grow;
        const double psi = centre + 0.5 * epsilon * (grow - shrink), v = std::sin(psi),
                     c = std::cos(psi);
        const double dpsi = 0.5 * epsilon * (grow + shrink) * half * gauss_.weight[i];
        const double w = c * c * dpsi / kHalfPi;  // (2/π) cos²ψ dψ
        const double u_c = r.mean - r.swing * v, u = std::sqrt(u_c * u_c + r.u_t * r.u_t);
        const double kappa = u > 0.0 ? law_(u, peak_ * chord_s * (of_strip_ ? 1.0 : c)) : 0.0;
        const double per_slip = u > 0.0 ? w * kappa / u : 0.0;
        f_c += per_slip * u_c;
        f_t += per_slip * r.u_t;
        m_n += per_slip * u_c * v;
        heat += w * kappa * u;
        load_slip += w * u;
        sum_.max_slip = std::max(sum_.max_slip, u);
      }
    }
    const double Q = weight * g_.Q;
    const double chord = g_.b * std::sqrt(std::max(1 - (r.xi / g_.a) * (r.xi / g_.a), 0.0));
    sum_.F_c += Q * f_c;
    sum_.F_t += Q * f_t;
    sum_.M_c -= Q * r.h * f_t;
    sum_.M_t += Q * r.h * f_c;
    sum_.M_n += Q * (r.xi * f_t - chord * m_n);
    sum_.heat += Q * heat;
    sum_.load_slip += Q * load_slip;
  }

  Here law_;
  bool of_strip_;
  double peak_;
  EllipseGeometry g_;
  EllipseKinematics m_;
  const Gauss& gauss_;
  double kink_;
  EllipseTraction sum_;
};

}  // namespace

EllipseTraction ellipse_traction_split(const TractionLaw& law, const EllipseGeometry& geometry,
                                       const EllipseKinematics& motion, int points) {
  demand(points >= 4 && points <= 40,
         "integration over a split contact ellipse: the number of points per piece must be from 4 "
         "to 40");
  if (!(geometry.Q > 0.0) || !(geometry.a > 0.0)) return {};
  const double peak = 1.5 * geometry.Q / (std::numbers::pi * geometry.a * geometry.b);
  const ContactConditions<double> contact{geometry.Q,         peak,
                                          geometry.a,         geometry.b,
                                          motion.entrainment, middle_slip(geometry, motion),
                                          motion.curvature};
  return law.visit([&](const auto& own) {
    constexpr bool kStrip = is_strip_law<std::decay_t<decltype(own)>>();
    return Integral(own.at(contact), kStrip, own.kink(), peak, geometry, motion, points).run();
  });
}

}  // namespace adore::tribology
