#include "integrators/embedded_runge_kutta.hpp"

#include <algorithm>
#include <cmath>

namespace adore::integrators {

EmbeddedRungeKutta::EmbeddedRungeKutta(std::string name, const Tableau& tableau)
    : ExplicitStepper(std::move(name), tableau.order), tableau_(tableau) {}

void EmbeddedRungeKutta::prepare() {
  stages_.resize(tableau_, width());
  previous_error_ = 1.0;
}

ExplicitStepper::Trial EmbeddedRungeKutta::attempt(double h, double t_new) {
  const Outcome outcome =
      stages_.run(evaluate_, t_, h, t_new, y_.data(), f_.data(), y_new_.data(), error_.data());
  if (outcome != Outcome::Ok) return {outcome, 0.0};
  return {Outcome::Ok, weighted_maximum(error_.data(), weights_.data(), width())};
}

void EmbeddedRungeKutta::save(Memory& memory) const { memory["error before"] = previous_error_; }

void EmbeddedRungeKutta::restore(const Memory& memory) {
  previous_error_ = memory.at("error before");
}

const double* EmbeddedRungeKutta::end_derivative() const { return stages_.end_derivative(); }

// h' = 0.9 h e^(-0.7/q) e_before^(0.4/q), q: power of the estimate: [gustafsson1991]; damps the
// saw-tooth of contact vibration.
double EmbeddedRungeKutta::growth(double error) {
  const double q = tableau_.error_order();
  const double e = std::max(error, 1e-8);
  const double factor = 0.9 * std::pow(e, -0.7 / q) * std::pow(previous_error_, 0.4 / q);
  previous_error_ = std::min(e, 1.0);
  return std::clamp(factor, 0.2, 5.0);
}

}  // namespace adore::integrators
