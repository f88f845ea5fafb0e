#pragma once

#include "calculators/adapter.hpp"

#include <vector>

/// Ratings: families rating_static, rating_reference_speed, rating_oscillation,
/// rating_minimum_load, and the tolerances of rating_size_limits and rating_bearing_fit.
namespace adore::calculators {

[[nodiscard]] std::vector<Adapter> rating_adapters();
[[nodiscard]] std::vector<Adapter> size_limit_adapters();

}  // namespace adore::calculators
