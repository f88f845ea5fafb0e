#pragma once

#include "calculators/adapter.hpp"

#include <vector>

/// Fatigue life: families life_lp_capacity, life_race_bearing, life_stress_models,
/// life_identities, life_factors, life_accumulation, life_iso281, life_iso16281.
namespace adore::calculators {

[[nodiscard]] std::vector<Adapter> life_adapters();
/// life_iso281 and life_iso16281 alone.
[[nodiscard]] std::vector<Adapter> iso_life_adapters();

/// Infinity is the text "inf" in these cases.
[[nodiscard]] Json life_to_json(double value);
[[nodiscard]] double life_from_json(const Json& value);
[[nodiscard]] std::vector<double> lives_from_json(const Json& list);

}  // namespace adore::calculators
