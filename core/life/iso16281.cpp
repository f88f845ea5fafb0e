#include "life/iso16281.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "life/constants.hpp"

#include <algorithm>
#include <cmath>

namespace adore::life {
namespace {

/// Loads of lamina k of every element.
std::vector<double> lamina(const std::vector<double>& loads, std::size_t k, std::size_t n,
                           double factor) {
  std::vector<double> out;
  for (std::size_t at = k; at < loads.size(); at += n) out.push_back(factor * loads[at]);
  return out;
}

}  // namespace

double equivalent_load(std::span<const double> loads, bool line, bool rotating) {
  demand(!loads.empty(), "there are no contact loads");
  const double p = line ? (rotating ? 4.0 : 4.5) : (rotating ? 3.0 : 10.0 / 3.0);
  const double largest = *std::max_element(loads.begin(), loads.end());
  if (!(largest > 0.0)) return 0.0;
  double sum = 0.0;
  for (const double Q : loads)
    if (Q > 0.0) sum += std::pow(Q / largest, p);
  return largest * std::pow(sum / static_cast<double>(loads.size()), 1.0 / p);
}

ReferenceLife iso_reference_life_ball(const IsoGeometry& g, double rating,
                                      std::span<const double> inner, std::span<const double> outer,
                                      bool inner_rotates, bool outer_rotates,
                                      const std::optional<AisoInput>& condition) {
  const LifeConstants& c = constants();
  const double gamma = iso_gamma(g);
  const bool thrust = g.type == IsoType::ThrustBall;
  const double grooves = g.conformity_inner * (2.0 * g.conformity_outer - 1.0) /
                         (g.conformity_outer * (2.0 * g.conformity_inner - 1.0));
  const double T = (thrust ? 1.0 : c.ball_bracket) * std::pow((1.0 - gamma) / (1.0 + gamma), 1.72) *
                   std::pow(grooves, 0.41);
  const double cosine = std::cos(g.contact_angle), Z = g.count;
  const double share = Z * cosine * std::pow(g.rows, 0.7);
  const double axial = Z * std::sin(g.contact_angle);
  ReferenceLife out;
  out.capacity_inner = rating / (thrust ? axial : c.ball_inner * share) *
                       std::pow(1.0 + std::pow(T, 10.0 / 3.0), 0.3);
  out.capacity_outer = rating / (thrust ? axial : c.ball_outer * share) *
                       std::pow(1.0 + std::pow(T, -10.0 / 3.0), 0.3);
  out.load_inner = equivalent_load(inner, false, inner_rotates);
  out.load_outer = equivalent_load(outer, false, outer_rotates);
  const double hazard = std::pow(out.load_inner / out.capacity_inner, 10.0 / 3.0) +
                        std::pow(out.load_outer / out.capacity_outer, 10.0 / 3.0);
  out.L10r = hazard > 0.0 ? std::pow(hazard, -0.9) : kInfinity;
  out.P_ref = hazard > 0.0 ? rating / std::cbrt(out.L10r) : 0.0;
  if (condition)
    out.modified = hazard > 0.0
                       ? out.L10r * iso_life_factor(g.type, condition->kappa,
                                                    condition->contamination *
                                                        condition->fatigue_limit / out.P_ref)
                                        .value
                       : kInfinity;
  return out;
}

double lamina_edge_factor(std::size_t k, std::size_t n) {
  demand(n > 1 && k >= 1 && k <= n, "the lamina number is out of range");
  const double position = std::abs(2.0 * static_cast<double>(k) - static_cast<double>(n) - 1.0) /
                          (2.0 * static_cast<double>(n) - 2.0);
  if (position == 0.0) return 1.0;  // the middle lamina: ln 0, no concentration
  return 1.0 - 0.01 / std::log(1.985 * position);
}

RollerReferenceLife iso_reference_life_roller(const IsoGeometry& g, double rating,
                                              const LaminaLoads& loads, bool inner_rotates,
                                              bool outer_rotates, bool edge,
                                              const std::optional<AisoInput>& condition) {
  const LifeConstants& c = constants();
  const std::size_t n = loads.laminae;
  demand(n > 0 && loads.inner.size() % n == 0 && loads.outer.size() == loads.inner.size(),
         "laminae of an element or a race are missing");
  const double gamma = iso_gamma(g);
  const double cosine = std::cos(g.contact_angle), Z = g.count;
  const double T = c.roller_bracket * std::pow((1.0 - gamma) / (1.0 + gamma), 143.0 / 108.0);
  const double share = c.roller_reduction * Z * cosine * std::pow(g.rows, 7.0 / 9.0);
  RollerReferenceLife out;
  out.capacity_inner =
      rating / (c.roller_inner * share) * std::pow(1.0 + std::pow(T, 4.5), 2.0 / 9.0);
  out.capacity_outer =
      rating / (c.roller_outer * share) * std::pow(1.0 + std::pow(T, -4.5), 2.0 / 9.0);
  const double parts = static_cast<double>(n);
  const double split = std::pow(parts, -7.0 / 9.0);
  out.lamina_capacity_inner = out.capacity_inner * split;
  out.lamina_capacity_outer = out.capacity_outer * split;
  const double ratio = c.roller_bracket * out.lamina_capacity_inner / out.lamina_capacity_outer;
  double sum = 0.0, modified = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double f = edge ? lamina_edge_factor(k + 1, n) : 1.0;
    const double q_i = equivalent_load(lamina(loads.inner, k, n, f), true, inner_rotates);
    const double q_e = equivalent_load(lamina(loads.outer, k, n, f), true, outer_rotates);
    const double hazard = std::pow(q_i / out.lamina_capacity_inner, 4.5) +
                          std::pow(q_e / out.lamina_capacity_outer, 4.5);
    sum += hazard;
    const double P =
        c.roller_lamina_load * Z * parts * cosine *
        std::pow((std::pow(q_i, 4.5) + std::pow(ratio * q_e, 4.5)) / (1.0 + std::pow(ratio, 4.5)),
                 2.0 / 9.0);
    out.lamina_load.push_back(P);
    if (condition && hazard > 0.0)
      modified +=
          hazard * std::pow(iso_life_factor(g.type, condition->kappa,
                                            condition->contamination * condition->fatigue_limit / P)
                                .value,
                            -9.0 / 8.0);
  }
  // The equivalent loads of the whole rollers, for the print.
  const auto whole = [&](const std::vector<double>& all) {
    std::vector<double> Q(all.size() / n, 0.0);
    for (std::size_t at = 0; at < all.size(); ++at) Q[at / n] += std::max(all[at], 0.0);
    return Q;
  };
  out.load_inner = equivalent_load(whole(loads.inner), true, inner_rotates);
  out.load_outer = equivalent_load(whole(loads.outer), true, outer_rotates);
  out.L10r = sum > 0.0 ? std::pow(sum, -8.0 / 9.0) : kInfinity;
  out.P_ref = sum > 0.0 ? rating / std::pow(out.L10r, 0.3) : 0.0;
  if (condition) out.modified = sum > 0.0 ? std::pow(modified, -8.0 / 9.0) : kInfinity;
  return out;
}

}  // namespace adore::life
