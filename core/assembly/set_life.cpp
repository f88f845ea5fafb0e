#include "assembly/set_life.hpp"

#include <cmath>
#include <limits>

namespace adore::assembly {

std::optional<double> life_of_set(std::span<const double> rows, double slope) {
  if (rows.empty()) return std::nullopt;
  double shortest = std::numeric_limits<double>::infinity();
  for (const double life : rows) {
    if (!(life > 0.0)) return std::nullopt;
    shortest = std::fmin(shortest, life);
  }
  if (std::isinf(shortest)) return shortest;
  double sum = 0.0;  // over the shortest life, so that powers stay near 1
  for (const double life : rows) sum += std::pow(life / shortest, -slope);
  return shortest * std::pow(sum, -1.0 / slope);
}

}  // namespace adore::assembly
