#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Inverse calculation in one unknown: all x between two bounds at which a computed result f(x)
/// meets a target.
///
/// 1. Scan: `points` values of x, evenly spaced; in equal ratios where both bounds have the same
///    sign and one is 100 times the other or more.
/// 2. Neighbors on different sides of the target: Brent's method (inverse quadratic interpolation,
///    secant, bisection) [R. P. Brent, Algorithms for Minimization without Derivatives, 1973, ch.
///    4]. Neighbors of which one is exactly on the target: bisection to the edge of the range in
///    which f is constant (a load that is 0 while an element has no contact).
/// 3. Neighbors on the same side with a minimum of the distance between them: golden section, which
///    finds two near solutions, or a curve that touches the target.
/// A change of side that does not become small with the interval is a jump, not a solution.
/// Limits: more than one turn of f within one scan interval is not seen; `points` sets the
/// interval.
namespace adore {

enum class Relation : unsigned char { Equal, AtLeast, AtMost, Least, Largest };

struct FindSettings {
  double first = 0.0, last = 1.0;  ///< bounds, first < last
  Relation relation = Relation::Equal;
  double target = 0.0;  ///< unused by Least and Largest
  int points = 41;
  bool whole = false;  ///< x takes whole numbers only: each is computed, none is refined
};

struct FindSample {
  double x = 0.0, value = 0.0;  ///< NaN where the computation failed
  std::string failure;          ///< reason; empty: computed
  bool wrong_input = false;     ///< the failure is an InputError
  [[nodiscard]] bool ok() const { return failure.empty(); }
};

enum class FindSolutionKind : unsigned char {
  Crossing,  ///< f passes through the target
  Touch,     ///< f touches the target and turns
  Range,     ///< f meets the target, or the condition, in a range of x
  Extremum   ///< least or largest f
};

struct FindSolution {
  FindSolutionKind kind = FindSolutionKind::Crossing;
  double x = 0.0;               ///< of a range: the end that is not a bound, the lower one of two
  double value = 0.0;           ///< f(x)
  double width = 0.0;           ///< of the last interval around x: the tolerance reached
  double from = 0.0, to = 0.0;  ///< of a range; else x
  bool from_bound = false, to_bound = false;      ///< ends at a bound of the search
  bool from_failure = false, to_failure = false;  ///< ends where the computation fails
};

struct FindJump {
  double before = 0.0, after = 0.0;  ///< x on both sides
  double value_before = 0.0, value_after = 0.0;
};

/// Part of the range without a result, between the computed neighbors.
struct FindFailure {
  double from = 0.0, to = 0.0;
  std::string reason;
};

enum class FindAnswer : unsigned char {
  One,           ///< one solution, and f is monotonic where it was computed
  NotMonotonic,  ///< one solution, but f turns: others may lie between scan points
  Many,
  Everywhere,  ///< every x between the bounds
  None,
  NotComputed  ///< no solution where f was computed, and f was not computed everywhere
};

struct FindOutcome {
  FindAnswer answer = FindAnswer::None;
  std::vector<FindSample> samples;  ///< all that was computed, x rises
  std::vector<FindSolution> solutions;
  std::vector<FindJump> jumps;
  std::vector<FindFailure> failures;
  std::vector<double> turns;  ///< x where f turns, of the computed values
  FindSample best;            ///< nearest to the target, or to the condition
  bool monotonic = true, constant = false, equal_ratios = false;
};

/// @param f may throw InputError and SolverError: the point has no result
/// @throws InputError for bounds that are not finite or not in order, too many whole numbers, or
/// when f throws it at every point; SolverError when f fails at every point otherwise
[[nodiscard]] FindOutcome find_values(const FindSettings& settings,
                                      const std::function<double(double)>& f);

}  // namespace adore
