#pragma once

#include "dynamics/scene.hpp"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

/// Every body and effect that a scene may have, one line each.
namespace adore::dynamics {

class SceneEffect;

struct EffectCatalogEntry {
  std::string_view name;
  std::string_view decided_by;  ///< deck variables that switch it, "-": none does
  std::string_view help;
  std::unique_ptr<SceneEffect> (*make)(const ScenePlan&);  ///< null where the plan leaves it out
  LedgerTerms (*terms)();                                  ///< of the energy ledger; may be null
};

/// In the order in which effects declare themselves: after the effects that they need.
[[nodiscard]] std::span<const EffectCatalogEntry> effect_catalogue();

/// All items that the energy ledger of any scene may hold, kind by kind.
[[nodiscard]] std::vector<const LedgerTerm*> energy_terms();

}  // namespace adore::dynamics
