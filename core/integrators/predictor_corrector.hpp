#pragma once

#include "integrators/explicit_stepper.hpp"
#include "integrators/tableau.hpp"

#include <array>

namespace adore::integrators {

inline constexpr int kMaxAdamsOrder = 8;

/// Weights of one variable-step Adams step of order k on the actual time grid.
struct AdamsWeights {
  std::array<double, kMaxAdamsOrder>
      predict{};  ///< y* = y + h Σ predict_j f_{n-j}  (Bashforth, order k)
  std::array<double, kMaxAdamsOrder> extrapolate{};  ///< P(t + h) = Σ extrapolate_j f_{n-j}
  double correct = 0.0;         ///< Moulton of order k:     y = y* + h correct (f* - P)
  double correct_higher = 0.0;  ///< Moulton of order k+1: the same with this factor
};

/// @param times t_n, t_{n-1}, ..., k of them, all different; h > 0.
/// Exact: the integrands are polynomials of degree <= 8 and the quadrature is five-point
/// Gauss–Legendre.
[[nodiscard]] AdamsWeights adams_weights(const double* times, int k, double h) noexcept;

/// Adams–Bashforth–Moulton in PECE form on a truly variable grid: weights follow from the actual
/// times of the last k derivatives, so no interpolation and no change of step costs order. The
/// corrector has the order of the predictor; the local error is the Milne device for a variable
/// grid: the distance to the corrector of one order more, which is a known multiple of corrector
/// minus predictor.
///
/// Only the derivatives of the past are kept, and each belongs to a projected state; the state
/// itself enters once. Hence a projection needs no restart.
///
/// Start: the k - 1 further derivatives come from steps of the Fehlberg pair of order 4, each
/// interval subdivided until the estimated error over it is below the tolerance.
class PredictorCorrector final : public ExplicitStepper {
 public:
  PredictorCorrector(std::string name, int order);

 private:
  void prepare() override;
  Trial attempt(double h, double t_new) override;
  void accepted(double h) override;
  void save(Memory& memory) const override;
  void restore(const Memory& memory) override;
  void rejected(int in_a_row) override;
  [[nodiscard]] double growth(double error) override;

  [[nodiscard]] bool is_starting() const noexcept { return known_ < order(); }
  Trial attempt_start(double h);
  Trial attempt_adams(double h);
  Outcome substeps(double h, int count, double& error);
  void forget_past();

  int known_ = 0;  ///< derivatives in the history; history_[0] belongs to times_[0] = t_
  std::array<double, kMaxAdamsOrder> times_{};
  std::array<double*, kMaxAdamsOrder> history_{};
  std::vector<double> memory_;
  std::vector<double> predicted_, extrapolated_derivative_;
  Stages stages_;
  std::vector<double> y_sub_, f_sub_;
};

}  // namespace adore::integrators
