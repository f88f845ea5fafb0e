#include "integrators/tableau.hpp"

#include <algorithm>

namespace adore::integrators {

void Stages::resize(const Tableau& tableau, int width) {
  tableau_ = &tableau;
  width_ = width;
  memory_.assign(static_cast<std::size_t>(width) * (tableau.stages - 1), 0.0);
  for (int s = 1; s < tableau.stages; ++s) {
    k_[s] = memory_.data() + static_cast<std::size_t>(s - 1) * width;
  }
  for (int s = 0; s < tableau.stages; ++s) {
    error_weights_[s] = tableau.b[s] - tableau.b_high[s];
  }
}

Outcome Stages::run(Evaluator& evaluate, double t, double h, const double* y, const double* f,
                    double* y_new, double* error) {
  k_[0] = f;
  for (int s = 1; s < tableau_->stages; ++s) {
    combine(y_new, y, h, tableau_->a[s].data(), k_.data(), s, width_);
    double* k = memory_.data() + static_cast<std::size_t>(s - 1) * width_;
    const Outcome outcome = evaluate(t + tableau_->c[s] * h, y_new, k);
    if (outcome != Outcome::Ok) return outcome;
  }
  if (!tableau_->last_stage_is_end) {
    combine(y_new, y, h, tableau_->b.data(), k_.data(), tableau_->stages, width_);
  }
  combine(error, nullptr, h, error_weights_.data(), k_.data(), tableau_->stages, width_);
  return Outcome::Ok;
}

const double* Stages::end_derivative() const noexcept {
  return tableau_->last_stage_is_end ? k_[tableau_->stages - 1] : nullptr;
}

}  // namespace adore::integrators
