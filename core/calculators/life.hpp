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
[[nodiscard]] Json life_number(double value);
[[nodiscard]] double life_value(const Json& value);
[[nodiscard]] std::vector<double> life_values(const Json& list);

}  // namespace adore::calculators
