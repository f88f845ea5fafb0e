#pragma once

#include "integrators/step_tools.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace adore::integrators {

inline constexpr int kMaxStages = 13;

/// Embedded explicit Runge–Kutta pair. `b` gives the propagated solution of order `order`, `b_high`
/// the other one that serves for the error estimate: of order + 1, of classical() one below.
struct Tableau {
  int order;
  int stages;
  std::array<double, kMaxStages> c;
  std::array<std::array<double, kMaxStages>, kMaxStages> a;
  std::array<double, kMaxStages> b;
  std::array<double, kMaxStages> b_high;
  bool last_stage_is_end;  ///< last row of a equals b: the last stage is the derivative at the end
                           ///< of the step
  /// The error estimate goes with this power of the step.
  [[nodiscard]] int error_order() const { return std::min(order, order_of_other) + 1; }
  int order_of_other = order + 1;
};

/// Fehlberg's pairs p(p+1) for p = 1 to 7.
/// Sources: [fehlberg1968] (orders 5–7), [fehlberg1969] (orders 1–4).
/// Tests: tests/core/integrators/test_order_conditions.cpp, all rooted trees.
/// @throws std::invalid_argument for any other order.
[[nodiscard]] const Tableau& fehlberg(int order);

/// The classical method of order 4 with four evaluations a step, and an estimate from the one at
/// the end of the step, which the next step begins with:
///   b_high = (1/6, 1/3, 1/3, 0, 1/6) over k_1 to k_4 and f(t + h, y_new), of order 3.
/// Stable on the imaginary axis up to hω = 2√2, 0.71 an evaluation (Fehlberg's 1 to 7 at most 0.4):
/// the cheapest of the explicit methods where undamped contact vibrations bound the step.
/// Source: [hairer1993] II.1-II.4.
[[nodiscard]] const Tableau& classical();

/// Fehlberg's pairs of order 5 to 7 form their error from stages at the two ends of the step, as a
/// difference that vanishes where f depends on t alone: prescribed motion, or a body in free flight
/// that meets a contact late in the step. For such a pair this gives the weights q of a second
/// opinion h Σ q_i k_i: the distance from the rule b to the interpolating rule that leaves out the
/// end of the step. All zero for pairs that see quadratures.
[[nodiscard]] std::array<double, kMaxStages> quadrature_error_weights(const Tableau& tableau);

/// Stages of one trial step, with their memory.
class Stages {
 public:
  void resize(const Tableau& tableau, int width);
  /// Evaluates all stages from (t, y, f = derivative there), then `y_new` and the local error
  /// estimate `error` = h Σ (b - b_high)_i k_i. All arrays have the width given to resize().
  /// @param t_end time that the step ends at: t + h, but for the caller's rounding. The stage that
  /// is the derivative there has it to the bit.
  [[nodiscard]] Outcome run(Evaluator& evaluate, double t, double h, double t_end, const double* y,
                            const double* f, double* y_new, double* error);
  /// Derivative at the end of the step when the tableau has it, else null.
  [[nodiscard]] const double* end_derivative() const noexcept;

 private:
  const Tableau* tableau_ = nullptr;
  int width_ = 0;
  std::array<double, kMaxStages> error_weights_{};
  std::array<double, kMaxStages> quadrature_weights_{};
  bool error_covers_quadratures_ = true;
  std::vector<double> memory_;
  std::array<const double*, kMaxStages> k_{};
};

}  // namespace adore::integrators
