#pragma once

#include "integrators/explicit_stepper.hpp"
#include "integrators/tableau.hpp"

namespace adore::integrators {

/// Explicit embedded Runge–Kutta method with a proportional-integral step size control. Of
/// Fehlberg's pairs the lower-order solution is propagated, so the error estimate is that of the
/// solution itself; of rk4 the higher one. The order is the one in the name.
class EmbeddedRungeKutta final : public ExplicitStepper {
 public:
  EmbeddedRungeKutta(std::string name, const Tableau& tableau);

 private:
  void prepare() override;
  Trial attempt(double h, double t_new) override;
  [[nodiscard]] const double* end_derivative() const override;
  void accepted(double h) override { (void)h; }
  void save(Memory& memory) const override;
  void restore(const Memory& memory) override;
  [[nodiscard]] double growth(double error) override;

  const Tableau& tableau_;
  Stages stages_;
  double previous_error_ = 1.0;
};

}  // namespace adore::integrators
