#pragma once

#include "integrators/step_tools.hpp"

#include <string>
#include <vector>

namespace adore::integrators {

/// Common part of the explicit methods of this program: step size control, stop times, projection
/// and diagnosis. A method supplies one trial step and its error estimate.
///
/// A trial is accepted in this order: error test on the method's result, projection, derivative at
/// the projected state. The last derivative therefore always belongs to the projected state, and a
/// projection costs nothing.
///
/// A trial that passes this test but loses more of OdeSystem::kept() than tol allows is repeated
/// with a shorter step, as long as shorter steps lose less: an impact that begins inside a step
/// moves each component by less than its tolerance and still costs energy. A step whose length only
/// the tolerance determines loses very little, so smooth runs keep their steps.
class ExplicitStepper : public Stepper {
 public:
  ExplicitStepper(std::string name, int order) : name_(std::move(name)), order_(order) {}

  [[nodiscard]] std::string_view name() const noexcept final { return name_; }
  [[nodiscard]] int order() const noexcept final { return order_; }
  [[nodiscard]] bool can_hold_constant_step() const noexcept final { return true; }
  void start(OdeSystem& system, double t0, std::span<const double> y0,
             const StepControl& control) final;
  [[nodiscard]] Memory memory() const final;
  void resume(OdeSystem& system, double t0, std::span<const double> y0, const StepControl& control,
              const Memory& memory) final;
  StepInfo step(double t_stop) final;
  [[nodiscard]] double time() const noexcept final { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept final {
    return {y_.data(), static_cast<std::size_t>(size_)};
  }
  [[nodiscard]] std::span<const double> derivative() const noexcept final {
    return {f_.data(), static_cast<std::size_t>(size_)};
  }
  [[nodiscard]] const Counters& counters() const noexcept final { return counters_; }

 protected:
  struct Trial {
    Outcome outcome = Outcome::Ok;
    double error = 0.0;  ///< norm / tolerance
    double lost = 0.0;   ///< of what the solution keeps, over what a step may lose
  };
  /// Sizes work arrays for width() values per vector; t_, y_, f_ are set.
  virtual void prepare() = 0;
  /// Tries a step of h from (t_, y_, f_), which ends at t_new: fills y_new_ and error_.
  virtual Trial attempt(double h, double t_new) = 0;
  /// Derivative at (t_new, y_new_) when the trial has it already, else null.
  [[nodiscard]] virtual const double* end_derivative() const { return nullptr; }
  /// The trial became the state (t_, y_, f_).
  virtual void accepted(double h) = 0;
  /// The n-th trial in a row failed.
  virtual void rejected(int in_a_row) { (void)in_a_row; }
  /// The memory of the method, and its restoration.
  virtual void save(Memory& memory) const = 0;
  virtual void restore(const Memory& memory) = 0;
  /// Factor to the next step after an accepted trial of this error.
  [[nodiscard]] virtual double growth(double error) = 0;

  [[nodiscard]] bool has_constant_step() const noexcept {
    return control_.minimum == control_.maximum;
  }
  [[nodiscard]] int width() const noexcept { return width_; }

  Evaluator evaluate_;
  Counters counters_;
  StepControl control_;
  double t_ = 0.0;
  std::vector<double> y_, f_, y_new_, f_new_;
  std::vector<double> error_;    ///< local error of the last trial
  std::vector<double> weights_;  ///< 1 / (scale * tolerance); 0 for quadratures and padding

 private:
  void attach(OdeSystem& system, double t0, std::span<const double> y0, const StepControl& control);
  [[nodiscard]] Trial try_step(double h, double t_new, bool accept_any_error);
  [[noreturn]] void give_up(Outcome outcome, double h) const;

  /// Loss of a step from kept_ to the last evaluated state of the system.
  [[nodiscard]] double lost(double& kept) noexcept;
  /// Counts steps that were shortened without success.
  void count_failed_reduction(bool in_vain) noexcept;

  std::string name_;
  int order_ = 0;
  int size_ = 0;
  int width_ = 0;
  double t_rounding_ = 0.0;  ///< loss of the sum of steps by rounding
  double h_next_ = 0.0;
  double kept_ = 0.0;      ///< OdeSystem::kept() at (t_, y_)
  double kept_new_ = 0.0;  ///< at the end of the trial
  int failed_reduction_count_ =
      0;  ///< steps in a row checked without success; below 0: steps left unchecked
};

}  // namespace adore::integrators
