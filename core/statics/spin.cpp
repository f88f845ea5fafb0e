#include "statics/spin.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <numbers>
#include <optional>

namespace adore::statics {
namespace {

using Nodes = Eigen::Array<double, 12, 1>;

/// 12-point Gauss-Legendre rule on (-1, 1), and the powers of its nodes that the slip needs.
struct GaussRule {
  Nodes weight;            ///< times 3/4 (1-s²)
  Nodes s2, s3, s4, rest;  ///< rest = 1-s²
};

GaussRule make_rule() {
  constexpr int n = Nodes::RowsAtCompileTime;
  GaussRule rule;
  for (int k = 0; k < n; ++k) {
    double x = std::cos(std::numbers::pi * (k + 0.75) / (n + 0.5));
    double slope = 1.0;
    for (int pass = 0; pass < 20; ++pass) {
      double previous = 1.0;
      double current = x;
      for (int degree = 2; degree <= n; ++degree) {
        const double next = ((2 * degree - 1) * x * current - (degree - 1) * previous) / degree;
        previous = current;
        current = next;
      }
      slope = n * (x * current - previous) / (x * x - 1.0);
      x -= current / slope;
    }
    rule.weight(k) = 0.75 * 2.0 / (slope * slope);
    rule.s2(k) = x * x;
    rule.s3(k) = x * x * x;
    rule.s4(k) = x * x * x * x;
    rule.rest(k) = 1.0 - x * x;
  }
  return rule;
}

/// G of one contact over its spin: G = a H(σ, t), t = a/(2ρ), with
///   H = Σ w slip,  slip² = A σ² + 2 B σ + C,  A = s² + (1-s²)/(4κ²),  B = t s³,  C = t² s⁴.
/// H is homogeneous of degree 1 in (σ, t), which gives the derivatives over t and so over a.
struct SlipIntegral {
  double H = 0.0, slope = 0.0, curvature = 0.0;  ///< over σ

  SlipIntegral() = default;
  SlipIntegral(double aspect, double t, double sigma) {
    static const GaussRule kRule = make_rule();
    const double narrow = 0.25 / (aspect * aspect);
    const Nodes B = t * kRule.s3;
    const Nodes half_slope = (kRule.s2 + narrow * kRule.rest) * sigma + B;
    const Nodes square = (half_slope + B) * sigma + (t * t) * kRule.s4;
    const Nodes slip = square.sqrt();
    const Nodes over_slip = slip.inverse();
    const Nodes weighted = kRule.weight * over_slip;
    H = (kRule.weight * slip).sum();
    slope = (weighted * half_slope).sum();
    // A C - B² = t² s⁴ (1-s²)/(4κ²)
    curvature = t * t * narrow * (weighted * kRule.s4 * kRule.rest * over_slip * over_slip).sum();
  }
};

/// One contact with the axis at β: how it rolls and spins, T = tan(α-β).
struct Rolled {
  double rho = 0.0;                 ///< 1 ± γ cos α
  double rolls = 0.0, turns = 0.0;  ///< cos(α-β)/ρ, its derivative sin(α-β)/ρ
  double T = 0.0;
  double sigma = 0.0, sigma_1 = 0.0;  ///< and its derivative
  double share = 0.0, share_1 = 0.0;  ///< of the rolling: W = rolls/Σ rolls, and its derivative
  SlipIntegral slip;
};

/// The heat over |Ω_i - Ω_o|/γ, E = Σ Q_j W_j a_j H_j, with the axis at one angle.
class Heat {
 public:
  Heat(const std::array<HeatContact, 2>& contacts, double gamma, double beta)
      : contacts_(&contacts), gamma_(gamma) {
    const Direction<double> axis{std::sin(beta), std::cos(beta)};
    for (std::size_t j = 0; j < 2; ++j) {
      const HeatContact& c = contacts[j];
      Rolled& r = at_[j];
      r.rho = 1.0 + sign(j) * gamma * c.alpha.cos;
      const double cosine = cos_between(c.alpha, axis);
      const double sine = sin_between(c.alpha, axis);
      r.rolls = cosine / r.rho;
      r.turns = sine / r.rho;
      r.T = sine / cosine;
      r.sigma = gamma * c.alpha.sin - sign(j) * r.rho * r.T;
      r.sigma_1 = sign(j) * r.rho * (1.0 + r.T * r.T);
      r.slip = SlipIntegral(c.aspect, 0.5 * c.half_major / c.surface_radius, r.sigma);
    }
    sum_ = at_[0].rolls + at_[1].rolls;
    sum_1_ = at_[0].turns + at_[1].turns;
    for (std::size_t j = 0; j < 2; ++j) {
      const HeatContact& c = contacts[j];
      Rolled& r = at_[j];
      r.share = r.rolls / sum_;
      r.share_1 = (r.turns - r.share * sum_1_) / sum_;
      const double share_2 = -2.0 * r.share_1 * sum_1_ / sum_;  // rolls'' = -rolls
      const double sigma_2 = -2.0 * r.T * r.sigma_1;
      const double size = c.load * c.half_major;
      value += size * r.share * r.slip.H;
      slope += size * (r.share_1 * r.slip.H + r.share * r.slip.slope * r.sigma_1);
      curvature +=
          size * (share_2 * r.slip.H + 2.0 * r.share_1 * r.slip.slope * r.sigma_1 +
                  r.share * (r.slip.curvature * r.sigma_1 * r.sigma_1 + r.slip.slope * sigma_2));
    }
  }

  double value = 0.0, slope = 0.0, curvature = 0.0;  ///< over β

  /// Derivative of the slope over ln a of contact j; t grows with a.
  [[nodiscard]] double slope_over_log_a(std::size_t j) const {
    const Rolled& r = at_[j];
    const double H = 2.0 * r.slip.H - r.sigma * r.slip.slope;          // ∂(a H)/∂a
    const double H_sigma = r.slip.slope - r.sigma * r.slip.curvature;  // ∂(a ∂H/∂σ)/∂a
    return (*contacts_)[j].load * (*contacts_)[j].half_major *
           (r.share_1 * H + r.share * H_sigma * r.sigma_1);
  }
  [[nodiscard]] double slope_over_load(std::size_t j) const {
    const Rolled& r = at_[j];
    const HeatContact& c = (*contacts_)[j];
    return c.half_major * (r.share_1 * r.slip.H + r.share * r.slip.slope * r.sigma_1) +
           slope_over_log_a(j) / (3.0 * c.load);
  }
  [[nodiscard]] double slope_over_angle(std::size_t j) const {
    const Rolled& r = at_[j];
    const HeatContact& c = (*contacts_)[j];
    const double rho_a = -sign(j) * gamma_ * c.alpha.sin;
    const double rolls_a = -r.turns - r.rolls * rho_a / r.rho;
    const double turns_a = r.rolls - r.turns * rho_a / r.rho;
    const double squared = 1.0 + r.T * r.T;
    const double sigma_a = gamma_ * c.alpha.cos - sign(j) * (rho_a * r.T + r.rho * squared);
    const double sigma_1_a = sign(j) * squared * (rho_a + 2.0 * r.rho * r.T);
    double total = slope_over_log_a(j) * c.log_a_slope;
    for (std::size_t i = 0; i < 2; ++i) {
      const Rolled& other = at_[i];
      const double own = i == j ? 1.0 : 0.0;
      const double share_a = (own - other.share) * rolls_a / sum_;
      const double share_1_a =
          (own * turns_a - share_a * sum_1_ - other.share * turns_a - other.share_1 * rolls_a) /
          sum_;
      total += (*contacts_)[i].load * (*contacts_)[i].half_major *
               (share_1_a * other.slip.H + share_a * other.slip.slope * other.sigma_1);
    }
    return total +
           c.load * c.half_major *
               (r.share_1 * r.slip.slope * sigma_a +
                r.share * (r.slip.curvature * sigma_a * r.sigma_1 + r.slip.slope * sigma_1_a));
  }

 private:
  static double sign(std::size_t j) { return j == 0 ? 1.0 : -1.0; }

  const std::array<HeatContact, 2>* contacts_;
  double gamma_ = 0.0;
  std::array<Rolled, 2> at_;
  double sum_ = 0.0, sum_1_ = 0.0;
};

struct Bracket {
  double low, high;
};

/// An interval in which the slope of the heat changes from negative to positive: the two
/// race-control angles, widened in small steps while both contacts still roll.
template <class HeatAt>
Bracket bracket_minimum(double first, double second, HeatAt heat) {
  Bracket b{std::min(first, second) - 1e-6, std::max(first, second) + 1e-6};
  double widen = 0.01;
  for (int n = 0; n < 6 && heat(b.low).slope > 0.0; ++n, widen *= 2.0) {
    b.low -= widen;
  }
  widen = 0.01;
  for (int n = 0; n < 6 && heat(b.high).slope < 0.0; ++n, widen *= 2.0) {
    b.high += widen;
  }
  return b;
}

/// Steps below this leave an error of the order of their square, and derivatives as good as at the
/// minimum.
constexpr double kMaxAcceptedStep = 1e-8;

/// The heat next to its minimum over β: Newton from a guess while steps shrink quickly on a convex
/// stretch; from the first that does not, inside a shrinking bracket of the minimum.
template <class HeatAt, class BracketOf>
Heat least_heat(HeatAt heat, BracketOf bracket_of, double& beta) {
  std::optional<Bracket> bracket;
  double last = 0.3;
  for (int n = 0; n < 60; ++n) {
    const Heat now = heat(beta);
    const double step = now.curvature > 0.0 ? -now.slope / now.curvature : 1.0;
    if (!bracket && !(n < 8 && std::abs(step) < 0.7 * last)) {
      bracket = bracket_of();
      beta = 0.5 * (bracket->low + bracket->high);
      continue;
    }
    double next = beta + step;
    if (bracket) {
      (now.slope > 0.0 ? bracket->high : bracket->low) = beta;
      if (!(now.curvature > 0.0 && next > bracket->low && next < bracket->high)) {
        next = 0.5 * (bracket->low + bracket->high);
      }
    }
    last = std::abs(next - beta);
    beta = next;
    if (!bracket && last < kMaxAcceptedStep) {
      return now;
    }
    if (bracket && last < 1e-13) {
      break;
    }
  }
  return heat(beta);
}

/// The control angle of each race, for which it does not spin.
std::array<double, 2> control_angles(const std::array<HeatContact, 2>& contacts, double gamma) {
  std::array<double, 2> control{};
  for (std::size_t j = 0; j < 2; ++j) {
    const Direction<double>& alpha = contacts[j].alpha;
    control[j] = std::atan2(alpha.sin, alpha.cos + (j == 0 ? gamma : -gamma));
  }
  return control;
}

}  // namespace

HeatOfAxis heat_of_axis(const std::array<HeatContact, 2>& contacts, double gamma, double beta) {
  const Heat heat(contacts, gamma, beta);
  return {heat.value, heat.slope};
}

LeastHeatAxis least_heat_axis(const std::array<HeatContact, 2>& contacts, double gamma,
                              double guess) {
  const auto heat = [&](double beta) { return Heat(contacts, gamma, beta); };
  LeastHeatAxis result;
  double& beta = result.beta;
  beta = guess;
  if (!std::isfinite(guess)) {
    const std::array<double, 2> control = control_angles(contacts, gamma);
    const double outer = contacts[0].load * contacts[0].half_major;
    const double inner = contacts[1].load * contacts[1].half_major;
    beta = (outer * control[0] + inner * control[1]) / (outer + inner);
  }
  const auto bracket_of = [&] {
    const std::array<double, 2> control = control_angles(contacts, gamma);
    return bracket_minimum(control[0], control[1], heat);
  };
  const Heat least = least_heat(heat, bracket_of, beta);
  if (least.curvature > 0.0) {
    // dβ = -(∂g/∂p) dp / (∂g/∂β) with the slope g = 0 at the minimum; p = α_o, α_i, Q_o, Q_i.
    for (std::size_t j = 0; j < 2; ++j) {
      result.over_angle[j] = -least.slope_over_angle(j) / least.curvature;
      result.over_load[j] = -least.slope_over_load(j) / least.curvature;
    }
  }
  return result;
}

}  // namespace adore::statics
