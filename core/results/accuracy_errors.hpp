#pragma once

#include "results/key_results.hpp"

#include <array>

/// Errors of the results that engineers use, all runs over the same span of whole revolutions from
/// the same start (Δ: difference to the reference, values with ‾ are means over the span):
///   speed  |Δ orbital ratio‾| / |orbital ratio‾|, and the same of the cage ratio
///   whirl  |Δ whirl ratio‾| over the larger of |whirl ratio‾| and |cage ratio‾|, the whirl by the
///         area that the cage center sweeps (results/averages.hpp): PRINT's ratio counts
///          windings, which jump by one where a path passes the bearing axis on its other side
///   load   |Δ largest contact load‾| over its own value, and |Δ race load‾| over |race load‾|
///   peak   |Δ largest contact load of the span| over its own value
///   heat   |Δ heat‾| of outer race, inner race and everything else, over the whole heat‾
///   life   |Δ life| / life, by the loads of the run.
namespace adore::results {

struct AccuracyErrors {
  double speed = 0.0, load = 0.0, heat = 0.0, life = 0.0, whirl = 0.0,
         peak = 0.0;  ///< negative: not computed
  static constexpr AccuracyErrors none();
  [[nodiscard]] double largest() const;
};
constexpr AccuracyErrors AccuracyErrors::none() { return {-1.0, -1.0, -1.0, -1.0, -1.0, -1.0}; }

/// All of them: member, key in files, name in messages.
struct AccuracyQuantity {
  double AccuracyErrors::*member;
  const char *key, *name;
};
inline constexpr std::array<AccuracyQuantity, 6> kAccuracyQuantities{
    {{&AccuracyErrors::speed, "speed", "speeds"},
     {&AccuracyErrors::whirl, "whirl", "whirl"},
     {&AccuracyErrors::load, "load", "loads"},
     {&AccuracyErrors::peak, "peak", "peak load"},
     {&AccuracyErrors::heat, "heat", "heat"},
     {&AccuracyErrors::life, "life", "life"}}};

/// Of each the larger one.
[[nodiscard]] AccuracyErrors larger(const AccuracyErrors& a, const AccuracyErrors& b);

/// Of two runs of one deck over one span. @param reference the more accurate one
[[nodiscard]] AccuracyErrors compare_results(const results::KeyResults& run,
                                             const results::KeyResults& reference);

}  // namespace adore::results
