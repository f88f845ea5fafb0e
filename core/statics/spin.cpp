#include "statics/spin.hpp"

#include <algorithm>
#include <numbers>

namespace adore::statics {
namespace {

constexpr int kHalfNodes = 8;
struct GaussRule {
  std::array<double, kHalfNodes> node{};
  std::array<double, kHalfNodes> weight{};
};

/// Positive half of the 16-point Gauss-Legendre rule on (-1, 1).
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

/// G(σ) and dG/dσ of one contact.
template <class S>
struct SlipIntegral {
  S value = 0.0;
  S slope = 0.0;
};

template <class S>
SlipIntegral<S> slip_integral(const HeatContact<S>& c, const S& sigma) {
  static const GaussRule kRule = make_rule();
  SlipIntegral<S> result;
  const S curve = c.half_major * c.half_major / (2.0 * c.surface_radius);
  const S narrow = 0.25 * c.half_minor * c.half_minor;
  for (std::size_t k = 0; k < 2 * kHalfNodes; ++k) {
    const double s = k < kHalfNodes ? kRule.node[k] : -kRule.node[k - kHalfNodes];
    const double w = 0.75 * kRule.weight[k % kHalfNodes] * (1.0 - s * s);
    const S along = sigma * c.half_major * s + curve * (s * s);
    const S spread = narrow * (1.0 - s * s);
    const S slip = square_root(along * along + sigma * sigma * spread);
    result.value += w * slip;
    result.slope += w * (along * c.half_major * s + sigma * spread) / slip;
  }
  return result;
}

/// Heat over |Ω_i - Ω_o|/γ and its derivative over β.
template <class S>
SlipIntegral<S> heat_and_slope(const std::array<HeatContact<S>, 2>& contacts, double gamma,
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
  for (int n = 0; n < 6 && slope(b.low) > 0.0; ++n, widen *= 2.0) {
    b.low -= widen;
  }
  widen = 0.01;
  for (int n = 0; n < 6 && slope(b.high) < 0.0; ++n, widen *= 2.0) {
    b.high += widen;
  }
  return b;
}

}  // namespace

HeatOfAxis heat_of_axis(const std::array<HeatContact<double>, 2>& contacts, double gamma,
                        double beta) {
  const auto h = heat_and_slope(contacts, gamma, beta);
  return {h.value, h.slope};
}

template <class S>
Direction<S> least_heat_axis(const std::array<HeatContact<S>, 2>& contacts, double gamma) {
  std::array<HeatContact<Dual<1>>, 2> fixed;
  std::array<double, 2> control{};
  for (std::size_t j = 0; j < 2; ++j) {
    const auto& c = contacts[j];
    fixed[j] = {{value_of(c.alpha.sin), value_of(c.alpha.cos)},
                value_of(c.load),
                value_of(c.half_major),
                value_of(c.half_minor),
                c.surface_radius};
    control[j] =
        std::atan2(value_of(c.alpha.sin), value_of(c.alpha.cos) + (j == 0 ? gamma : -gamma));
  }
  const auto slope = [&](double beta) {
    return heat_and_slope(fixed, gamma, Dual<1>::variable(beta, 0)).slope;
  };
  Bracket bracket =
      bracket_minimum(control[0], control[1], [&](double beta) { return slope(beta).v; });
  double beta = 0.5 * (bracket.low + bracket.high);
  double curvature = 0.0;
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
    if (change < 1e-14 || bracket.high - bracket.low < 1e-14) {
      break;
    }
  }
  S angle = beta;
  if (curvature > 0.0) {
    // dβ = -(∂g/∂p) dp / (∂g/∂β), with g = 0 at the minimum.
    const S g = heat_and_slope(contacts, gamma, S(beta)).slope;
    angle = beta - (g - value_of(g)) / curvature;
  }
  return {sine(angle), cosine(angle)};
}

template Direction<double> least_heat_axis(const std::array<HeatContact<double>, 2>&, double);
template Direction<Dual<2>> least_heat_axis(const std::array<HeatContact<Dual<2>>, 2>&, double);
template Direction<Dual<8>> least_heat_axis(const std::array<HeatContact<Dual<8>>, 2>&, double);

}  // namespace adore::statics
