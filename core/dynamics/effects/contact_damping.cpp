#include "dynamics/effects/contact_damping.hpp"

#include "bearing/contact_losses.hpp"
#include "contact/film_squeeze.hpp"
#include "dynamics/effect_makers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::dynamics {
namespace {

constexpr const LedgerTerm* kTerms[] = {&kRaceDamping};

contact::DampingLaw<> law_of(const ScenePlan& plan, const bearing::Bearing& bearing,
                             const SystemOptions& options, const bearing::Material& a,
                             const bearing::Material& b, double mass) {
  if (!plan.has(Effect::ContactDamping)) return {};
  const bearing::ContactLosses losses = bearing::contact_losses(a, b);
  contact::DampingLaw<> law;
  const auto& [impact_loss, impact_only, factor] = options.damping;
  law.impact = factor * 1.5 * (impact_loss > 0.0 ? impact_loss : losses.impact_loss);
  if (!impact_only) law.material = factor * losses.loss_factor * std::sqrt(mass);
  law.onset = contact::kOnsetOverRadius * 0.5 * bearing.element_diameter();
  return law;
}

/// The pressure of the squeeze acts through the elasticity of the contact: spring and dashpot in
/// series at the natural frequency ω = √(2 k/m) of the element, c/(1 + (c ω/k)²) [derived,
/// Maxwell]. The loss factor of a film is 1/2 at most; very thick oil moves as the bodies do.
double through_elasticity(double c, double k, double mass) {
  const double over = c * std::sqrt(2.0 / (k * mass));
  return c / (1.0 + over * over);
}

/// c/√k of the film of the most loaded contact of race j, of slices c/√(k L); 0: no oil, no load.
double film_squeeze(const bearing::Bearing& bearing, const statics::StaticSolution& start,
                    std::size_t j) {
  if (!start.films || !bearing.lubrication || !(bearing.lubrication->meniscus > 0.0)) return 0.0;
  std::size_t most = 0;
  for (std::size_t i = 1; i < start.balls.size(); ++i)
    if (start.balls[i].Q[j] > start.balls[most].Q[j]) most = i;
  const statics::StaticBall& at = start.balls[most];
  if (!(at.Q[j] > 0.0) || most >= start.films->race[j].size()) return 0.0;
  const bearing::RollerGeometry* rollers = bearing.rollers();
  const double mass = bearing.element_inertia.mass;
  contact::SqueezedFilm film;
  film.line = rollers != nullptr;
  film.E_star = bearing::contact_modulus(bearing.element_material, bearing.race_material[j]);
  film.film = std::max(start.films->race[j][most].film.central, start.films->critical_film);
  film.viscosity = start.films->viscosity[j];
  if (film.line) {
    const double length = rollers->contact_length(), line = at.Q[j] / length;
    const double curvature = 2.0 / bearing.element_diameter() +
                             (j == 0 ? -1.0 : 1.0) / rollers->race_radius(static_cast<int>(j));
    film.peak_pressure = std::sqrt(line * film.E_star * curvature / std::numbers::pi);
    film.half_width = 2.0 * line / (std::numbers::pi * film.peak_pressure);
    film.stiffness = 10.0 / 9.0 * at.Q[j] / at.delta[j];
    return through_elasticity(contact::squeeze_damping(film), film.stiffness, mass) /
           std::sqrt(film.stiffness * length);
  }
  film.peak_pressure = at.p_max[j];
  film.half_width = at.b[j];
  film.stiffness = 1.5 * at.Q[j] / at.delta[j];
  return through_elasticity(contact::squeeze_damping(film), film.stiffness, mass) /
         std::sqrt(film.stiffness);
}

}  // namespace

contact::DampingLaw<> damping_law(const SceneBuilder& scene, const bearing::Material& a,
                                  const bearing::Material& b, double mass, double share_of_length) {
  return law_of(scene.plan, scene.bearing, scene.options, a, b, mass * share_of_length);
}

contact::DampingLaw<> race_damping(const ScenePlan& plan, const bearing::Bearing& bearing,
                                   const SystemOptions& options,
                                   const statics::StaticSolution& start, std::size_t j) {
  if (plan.has(Effect::ElementBalance)) return {};
  const bearing::RollerGeometry* rollers = bearing.rollers();
  const double mass = 0.5 * bearing.element_inertia.mass;
  contact::DampingLaw<> law =
      law_of(plan, bearing, options, bearing.element_material, bearing.race_material[j],
             rollers != nullptr ? mass / rollers->contact_length() : mass);
  if (contact::is_damped(law) && !options.damping.impact_only)
    law.material += options.damping.factor * film_squeeze(bearing, start, j);
  return law;
}

// Every kind of contacts takes it into its own block.
MadeEffect make_contact_damping(const ScenePlan&) { return nullptr; }
std::span<const LedgerTerm* const> contact_damping_terms() { return kTerms; }

}  // namespace adore::dynamics
