#include "base/errors.hpp"
#include "dynamics/effect_catalogue.hpp"
#include "dynamics/system_impl.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::dynamics {
namespace {

/// Largest applied load component; of a displacement-driven bearing the largest reaction; of an
/// unloaded one the weight of an element at 9.81 m/s² (N11).
double force_scale(const bearing::Bearing& bearing, const statics::StaticSolution& statics) {
  double applied = 0.0, reaction = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!bearing.constraints.displacement_given[k])
      applied = std::max(applied, std::abs(bearing.constraints.load[k]));
    reaction = std::max(reaction, std::abs(statics.load[k]));
  }
  if (applied > 0.0) return applied;
  const double weight = bearing.element_inertia.mass * 9.81;
  return reaction > 1e-9 * weight ? reaction : weight;
}

}  // namespace

System::Impl::Impl(const bearing::Bearing& bearing_, const ScenePlan& plan,
                   const statics::StaticSolution& statics, const std::array<double, 2>& fixed_angle,
                   const SystemOptions& options, const std::vector<EffectMaker>& more_effects,
                   std::shared_ptr<const RollerStaticResult> rollers)
    : bearing(bearing_),
      user(options.user),
      roller_scene(std::move(rollers)),
      e(static_cast<std::size_t>(bearing_.element_count())) {
  SceneBuilder scene(bearing, plan, statics, fixed_angle, options, roller_scene.get(), e, parts);
  const auto take = [&](std::unique_ptr<SceneEffect> effect) {
    if (effect != nullptr) parts.effects.push_back(std::move(effect));
  };
  for (const EffectCatalogEntry& line : effect_catalogue()) take(line.make(plan));
  for (const EffectMaker& make : more_effects) take(make(plan));
  for (const auto& effect : parts.effects) effect->declare(scene);
  std::stable_sort(
      parts.blocks.begin(), parts.blocks.end(),
      [](const Assembly::Block& a, const Assembly::Block& b) { return a.phase < b.phase; });
  for (const Assembly::Block& block : parts.blocks)
    if (block.phase == Phase::Races) ++race_blocks;
  for (const auto& effect : parts.effects)
    if (effect->has_stiff_part()) {
      demand(stiff == nullptr, "only one effect may have a part that is integrated implicitly");
      stiff = effect.get();
    }
  set_up_border();
  set_up_integrals();
  rates.assign(static_cast<std::size_t>(parts.layout.size()), 0.0);
  checked = rates;

  scales.length = 0.5 * bearing.element_diameter();
  scales.force = force_scale(bearing, statics);
  // Largest dQ/dδ at the static solution; without a loaded contact that of the stiffest contact at
  // 1e-3 of the force scale (N7).
  double stiffness = statics.max_stiffness;
  if (!(stiffness > 0.0))
    for (const auto& effect : parts.effects)
      stiffness = std::max(stiffness, effect->stiffness(scales.force));
  scales.time = std::sqrt(bearing.element_inertia.mass / stiffness);
  apply_scales();
}

/// Shares have one value for each border component, in the order of the components; bodies are
/// found by what blocks call them.
void System::Impl::set_up_border() {
  const std::vector<int>& owner = parts.owner;
  border_count = static_cast<int>(std::count(owner.begin(), owner.end(), kBorder));
  int of_bodies = 0;
  for (const Assembly::Border& one : parts.border) {
    of_bodies += one.rows.count;
    border_rank.push_back(static_cast<std::size_t>(
        std::count(owner.begin(), owner.begin() + one.rows.first, kBorder)));
  }
  demand(of_bodies == border_count, "some state variables of the solver do not belong to any body");
  const std::size_t elements = e.sin_theta.size();
  for (const Assembly::Block& block : parts.blocks) {
    std::vector<int> partner(elements, -1);
    for (std::size_t i = 0; i < elements; ++i)
      for (std::size_t k = 0; k < parts.border.size(); ++k)
        if (const BodyId* id = block.partners.of(i); id != nullptr && *id == parts.border[k].id)
          partner[i] = static_cast<int>(k);
    if (std::all_of(partner.begin(), partner.end(), [](int one) { return one < 0; }))
      partner.clear();
    partner_of.push_back(std::move(partner));
  }
  before = e.actions;
}

void System::Impl::set_up_integrals() {
  parts.layout.begin_quadratures();
  std::vector<int> first_of;
  for (const Assembly::Integral& one : parts.integrals) {
    const int first = parts.layout.add(one.name, one.unit, one.count, 1.0).first;
    first_of.push_back(first);
    if (one.index != nullptr) *one.index = first;
    static constexpr double kNoRate = 0.0;  // changed between steps only
    for (int k = 0; k < one.count; ++k)
      integrals.push_back({first + k, one.rate == nullptr ? &kNoRate : one.rate + k});
  }
  const auto index_of = [&](int integral) { return first_of[static_cast<std::size_t>(integral)]; };
  for (const Assembly::EnergyItem& item : parts.energy)
    energy_items.push_back({item.term, item.race, index_of(item.integral), item.rate});
  std::stable_sort(
      energy_items.begin(), energy_items.end(),
      [](const EnergyItem& a, const EnergyItem& b) { return a.term->kind < b.term->kind; });
  for (const Assembly::MomentumItem& item : parts.momentum)
    momentum_items.push_back({item.term, item.angular, index_of(item.integral)});
}

void System::Impl::apply_scales() {
  for (const auto& [slice, kind] : parts.kinds) switch (kind) {
      case ScaleKind::Length:
        parts.layout.set_scale(slice, scales.length);
        break;
      case ScaleKind::Velocity:
        parts.layout.set_scale(slice, scales.length / scales.time);
        break;
      case ScaleKind::Angle:
        parts.layout.set_scale(slice, 1.0);
        break;
      case ScaleKind::Rate:
        parts.layout.set_scale(slice, 1.0 / scales.time);
        break;
    }
}

}  // namespace adore::dynamics
