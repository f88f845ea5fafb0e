#pragma once

#include <algorithm>
#include <array>
#include <cmath>

/// Step of a fixed-point iteration T = g(T) of the bulk temperatures: T + f (g(T) - T), with the
/// factor f after Irons & Tuck (1969) from the last two residuals, f = -f r·d/d·d, d = r' - r, held
/// between two limits. No part moves more than kLargestStride: the heat of cold oil is several
/// times that of the steady state, and its steady temperatures would leave the range of any law.
/// Heat that fluctuates (`averages`): the factor is at most 1/(1 + n) after n turns of the
/// residual against the one before (Kesten 1958) [recalled, high], so that temperatures settle at
/// the mean. `least` bounds the memory.
namespace adore::thermal {

struct Relaxation {
  using Field = std::array<double, 7>;
  static constexpr double kLargestStride = 40.0;  ///< [K] [choice]

  double least = 0.05, most = 3.0;  ///< of the factor
  double quiet = 0.0;               ///< largest residual that changes no factor [K]
  bool averages = false;
  int turns = 0;  ///< of the residual
  double factor = 1.0;
  bool begun = false;
  Field residual{};   ///< of the last step
  double gain = 0.0;  ///< dg/dT along the last step; NaN: not known yet

  /// @return the next field
  [[nodiscard]] Field step(const Field& at, const Field& found) {
    constexpr double kColdest = 1.5;  // [K]
    Field r{}, next{};
    double largest = 0.0, rr = 0.0, rd = 0.0, dd = 0.0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      r[k] = found[k] - at[k];
      largest = std::max(largest, std::abs(r[k]));
      const double d = r[k] - residual[k];
      rr += residual[k] * residual[k];
      rd += residual[k] * d;
      dd += d * d;
    }
    if (begun && dd > 0.0 && rr > 0.0 && largest > quiet) {
      gain = 1.0 + rd / (factor * rr);
      const double wanted = -factor * rd / dd;
      factor = wanted > 0.0 ? std::clamp(wanted, least, most) : std::min(1.0, most);
    }
    if (begun && rr + rd < 0.0) ++turns;
    if (averages) factor = std::clamp(1.0 / (1.0 + turns), least, std::max(factor, least));
    begun = true;
    residual = r;
    if (largest > 0.0) factor = std::min(factor, kLargestStride / largest);
    for (std::size_t k = 0; k < at.size(); ++k) next[k] = std::max(at[k] + factor * r[k], kColdest);
    return next;
  }
};

}  // namespace adore::thermal
