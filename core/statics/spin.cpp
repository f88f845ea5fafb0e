#include "statics/spin.hpp"

#include <algorithm>
#include <numbers>

namespace adore::statics {
namespace {

constexpr int kHalfNodes = 6;
struct GaussRule {
  std::array<double, kHalfNodes> node{};
  std::array<double, kHalfNodes> weight{};
};

/// Positive half of the 12-point Gauss-Legendre rule on (-1, 1).
GaussRule make_rule() {
  constexpr int n = 2 * kHalfNodes;
  GaussRule rule;
  for (int k = 0; k < kHalfNodes; ++k) {
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
    rule.node[static_cast<std::size_t>(k)] = x;
    rule.weight[static_cast<std::size_t>(k)] = 2.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

/// One contact with angle, load and axis carried as numbers of type S.
template <class S>
struct Contact {
  Direction<S> alpha;
  S load = 0.0, half_major = 0.0;
  double aspect = 1.0, surface_radius = 0.0;
};

/// G(σ) and dG/dσ of one contact.
template <class S>
struct SlipIntegral {
  S value = 0.0;
  S slope = 0.0;
};

template <class S>
SlipIntegral<S> slip_integral(const Contact<S>& c, const S& sigma) {
  static const GaussRule kRule = make_rule();
  SlipIntegral<S> result;
  const S curve = c.half_major * c.half_major / (2.0 * c.surface_radius);
  const S narrow = 0.25 / (c.aspect * c.aspect) * c.half_major * c.half_major;
  const S tilt = sigma * c.half_major;
  for (std::size_t k = 0; k < 2 * kHalfNodes; ++k) {
    const double s = k < kHalfNodes ? kRule.node[k] : -kRule.node[k - kHalfNodes];
    const double w = 0.75 * kRule.weight[k % kHalfNodes] * (1.0 - s * s);
    const S along = tilt * s + curve * (s * s);
    const S across = sigma * narrow * (1.0 - s * s);
    const S slip = square_root(along * along + sigma * across);
    result.value += w * slip;
    result.slope += w * (along * c.half_major * s + across) / slip;
  }
  return result;
}

/// Heat over |Ω_i - Ω_o|/γ and its derivative over β.
template <class S>
SlipIntegral<S> heat_and_slope(const std::array<Contact<S>, 2>& contacts, double gamma,
                               const S& beta) {
  const Direction<S> axis{sine(beta), cosine(beta)};
  std::array<S, 2> part;        // cos(β-α)/ρ
  std::array<S, 2> part_slope;  // its derivative over β
  std::array<S, 2> sigma;
  std::array<S, 2> sigma_slope;
  for (std::size_t j = 0; j < 2; ++j) {
    const double sign = j == 0 ? 1.0 : -1.0;
    const auto& alpha = contacts[j].alpha;
    const S rho = 1.0 + sign * gamma * alpha.cos;
    const S cosine_between = cos_between(axis, alpha);
    const S tangent = sin_between(alpha, axis) / cosine_between;
    part[j] = cosine_between / rho;
    part_slope[j] = sin_between(alpha, axis) / rho;
    sigma[j] = gamma * alpha.sin - sign * rho * tangent;
    sigma_slope[j] = sign * rho * (1.0 + tangent * tangent);
  }
  const S sum = part[0] + part[1];
  const S sum_slope = part_slope[0] + part_slope[1];
  SlipIntegral<S> total;
  for (std::size_t j = 0; j < 2; ++j) {
    const SlipIntegral<S> g = slip_integral(contacts[j], sigma[j]);
    const S rolling = part[j] / sum;
    const S rolling_slope = (part_slope[j] - rolling * sum_slope) / sum;
    total.value += contacts[j].load * rolling * g.value;
    total.slope +=
        contacts[j].load * (rolling_slope * g.value + rolling * g.slope * sigma_slope[j]);
  }
  return total;
}

struct Bracket {
  double low, high;
};

/// An interval in which the slope of the heat changes from negative to positive: the two
/// race-control angles, widened in small steps while both contacts still roll.
template <class Slope>
Bracket bracket_minimum(double first, double second, Slope slope) {
  Bracket b{std::min(first, second) - 1e-6, std::max(first, second) + 1e-6};
  double widen = 0.01;
  for (int n = 0; n < 6 && slope(b.low).v > 0.0; ++n, widen *= 2.0) {
    b.low -= widen;
  }
  widen = 0.01;
  for (int n = 0; n < 6 && slope(b.high).v < 0.0; ++n, widen *= 2.0) {
    b.high += widen;
  }
  return b;
}

/// Plain Newton from a good guess: true when its steps shrink quickly to nothing on a convex
/// stretch.
template <class Slope>
bool newton_minimum(Slope slope, double& beta, double& curvature) {
  double last = 0.3;
  for (int n = 0; n < 8; ++n) {
    const Dual<1> g = slope(beta);
    curvature = g.d[0];
    const double step = curvature > 0.0 ? -g.v / curvature : 1.0;
    if (!(std::abs(step) < 0.7 * last)) {
      return false;
    }
    beta += step;
    last = std::abs(step);
    if (last < 1e-6) {  // the next step is of the order of its square
      return true;
    }
  }
  return false;
}

/// Newton inside a shrinking bracket.
template <class Slope>
void safeguarded_minimum(Slope slope, Bracket bracket, double& beta, double& curvature) {
  beta = 0.5 * (bracket.low + bracket.high);
  for (int n = 0; n < 60; ++n) {
    const Dual<1> g = slope(beta);
    curvature = g.d[0];
    (g.v > 0.0 ? bracket.high : bracket.low) = beta;
    double next = curvature > 0.0 ? beta - g.v / curvature : bracket.low - 1.0;
    if (!(next > bracket.low && next < bracket.high)) {
      next = 0.5 * (bracket.low + bracket.high);
    }
    const double change = std::abs(next - beta);
    beta = next;
    if (change < 1e-13) {
      break;
    }
  }
}

template <class S>
std::array<Contact<S>, 2> constant_contacts(const std::array<HeatContact, 2>& contacts) {
  std::array<Contact<S>, 2> result;
  for (std::size_t j = 0; j < 2; ++j) {
    const HeatContact& c = contacts[j];
    result[j] = {{S(std::sin(c.alpha)), S(std::cos(c.alpha))},
                 S(c.load),
                 S(c.half_major),
                 c.aspect,
                 c.surface_radius};
  }
  return result;
}

}  // namespace

HeatOfAxis heat_of_axis(const std::array<HeatContact, 2>& contacts, double gamma, double beta) {
  const auto h = heat_and_slope(constant_contacts<double>(contacts), gamma, beta);
  return {h.value, h.slope};
}

LeastHeatAxis least_heat_axis(const std::array<HeatContact, 2>& contacts, double gamma,
                              double guess) {
  const auto fixed = constant_contacts<Dual<1>>(contacts);
  std::array<double, 2> control{};
  std::array<double, 2> weight{};
  for (std::size_t j = 0; j < 2; ++j) {
    const HeatContact& c = contacts[j];
    control[j] = std::atan2(std::sin(c.alpha), std::cos(c.alpha) + (j == 0 ? gamma : -gamma));
    weight[j] = c.load * c.half_major;
  }
  const auto slope = [&](double beta) {
    return heat_and_slope(fixed, gamma, Dual<1>::variable(beta, 0)).slope;
  };
  double beta = std::isfinite(guess)
                    ? guess
                    : (weight[0] * control[0] + weight[1] * control[1]) / (weight[0] + weight[1]);
  double curvature = 0.0;
  if (!newton_minimum(slope, beta, curvature)) {
    safeguarded_minimum(slope, bracket_minimum(control[0], control[1], slope), beta, curvature);
  }
  LeastHeatAxis result;
  result.beta = beta;
  if (curvature > 0.0) {
    // dβ = -(∂g/∂p) dp / (∂g/∂β) with g = 0 at the minimum; p = α_o, α_i, Q_o, Q_i.
    using D4 = Dual<4>;
    std::array<Contact<D4>, 2> moving;
    for (std::size_t j = 0; j < 2; ++j) {
      const HeatContact& c = contacts[j];
      const D4 alpha = D4::variable(c.alpha, static_cast<int>(j));
      const D4 load = D4::variable(c.load, static_cast<int>(j) + 2);
      D4 half_major = c.half_major;
      half_major.d[j] = c.half_major * c.log_a_slope;
      half_major.d[j + 2] = c.half_major / (3.0 * c.load);
      moving[j] = {{sine(alpha), cosine(alpha)}, load, half_major, c.aspect, c.surface_radius};
    }
    const D4 g = heat_and_slope(moving, gamma, D4(beta)).slope;
    for (std::size_t j = 0; j < 2; ++j) {
      result.over_angle[j] = -g.d[j] / curvature;
      result.over_load[j] = -g.d[j + 2] / curvature;
    }
  }
  return result;
}

}  // namespace adore::statics
