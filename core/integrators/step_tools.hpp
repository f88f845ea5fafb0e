#pragma once

#include "integrators/stepper.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// Small pieces that every stepper of this folder needs.
namespace adore::integrators {

/// Our own steppers keep their vectors zero-padded to whole blocks, so that inner loops have a
/// fixed length.
inline constexpr int kBlock = 8;
[[nodiscard]] constexpr int padded(int n) noexcept { return (n + kBlock - 1) / kBlock * kBlock; }

/// out = base + h * sum_j weights[j] * vectors[j], all of `n_padded` values; base may be null
/// (zero). Terms of zero weight are skipped. count <= 16. `out` may be `base`, not one of the
/// vectors.
void combine(double* out, const double* base, double h, const double* weights,
             const double* const* vectors, int count, int n_padded) noexcept;

/// Raises `error` to a second opinion h |Σ weights[s] (rates[s] - rates[0])|, of lower order than
/// the pair: only for components where the pair is blind. Its estimate is nothing but rounding
/// (pure quadrature), or the derivative is not smooth over the nodes, so that their divided
/// difference is of the size of its terms (the onset of a contact).
void add_quadrature_error_estimate(double* error, double h, const double* weights,
                                   const double* const* rates, int stages, int n_padded) noexcept;

/// max_i |values_i| * weights_i. Values that are not numbers do not count: see all_finite.
[[nodiscard]] double weighted_maximum(const double* values, const double* weights, int n) noexcept;
[[nodiscard]] bool all_finite(const double* values, int n) noexcept;
/// Index of the largest |values_i| * weights_i, or of the first value that is not finite.
[[nodiscard]] int worst_index(const double* values, const double* weights, int n) noexcept;

/// Shortest decimal text of a number, in no locale.
[[nodiscard]] std::string text(double value);

enum class Outcome : unsigned char { Ok, Retry, Fail, NotFinite };

/// Calls and counts the right-hand side, and looks for values that are not finite.
class Evaluator {
 public:
  void attach(OdeSystem& system, Counters& counters) noexcept;
  [[nodiscard]] Outcome operator()(double t, const double* y, double* dydt) noexcept;
  [[nodiscard]] OdeSystem& system() const noexcept { return *system_; }
  /// First component that was not finite in the last NotFinite outcome.
  [[nodiscard]] int invalid_component() const noexcept { return invalid_component_; }
  void set_invalid_component(int component) noexcept { invalid_component_ = component; }

 private:
  OdeSystem* system_ = nullptr;
  Counters* counters_ = nullptr;
  int size_ = 0;
  int invalid_component_ = -1;
};

/// @throws std::invalid_argument when control, scales or sizes make no sense.
void check_start(const OdeSystem& system, double t0, std::span<const double> y0,
                 const StepControl& control);

/// Weights of the error norm: 1 / (|scale| * tolerance) of the controlled components, 0 of the
/// quadratures and of the padding.
void error_weights(const OdeSystem& system, double tolerance, std::vector<double>& weights);

/// A careful first step: the second-order term of the solution, estimated by one explicit Euler
/// step, is held to the tolerance. `weights` = 1 / (scale * tolerance), 0 for quadratures. Within
/// [minimum, maximum] and the guard. `y`, `f` are scratch of system size. Returns control.initial
/// (clamped) when that is given.
[[nodiscard]] double first_step(Evaluator& evaluate, double t0, const double* y0, const double* f0,
                                const double* weights, const StepControl& control, double* y,
                                double* f);

/// Longest step allowed from time t: maximum and step_guard, but never below minimum.
[[nodiscard]] double longest_step(const OdeSystem& system, double t, const StepControl& control);

/// Does a step of length h reach t_stop? One part in a million is stretched rather than left as a
/// sliver.
[[nodiscard]] inline bool reaches(double t, double h, double t_stop) noexcept {
  return h * (1.0 + 1e-6) >= t_stop - t;
}

/// Cause of a stepper's failure, for the text of a StepFailure. component < 0: none.
struct Diagnosis {
  std::string_view method;
  std::string cause;
  std::string remedy;
  double t = 0.0;
  double h = 0.0;
  int component = -1;
};
[[noreturn]] void throw_failure(const OdeSystem& system, const Diagnosis& diagnosis);

/// Sentences shared by all steppers.
[[nodiscard]] std::string cause_of(Outcome outcome);
[[nodiscard]] std::string remedy_of(Outcome outcome);

}  // namespace adore::integrators
