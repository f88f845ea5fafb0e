#include "integrators/tableau.hpp"

#include <algorithm>
#include <cmath>

namespace adore::integrators {

std::array<double, kMaxStages> quadrature_error_weights(const Tableau& tableau) {
  std::array<double, kMaxStages> weights{};
  // Weights of f(t) in the pair's estimate, gathered by node.
  bool blind = true;
  for (int i = 0; i < tableau.stages; ++i) {
    double at_node = 0.0;
    for (int j = 0; j < tableau.stages; ++j) {
      if (tableau.c[j] == tableau.c[i]) at_node += tableau.b[j] - tableau.b_high[j];
    }
    blind = blind && std::abs(at_node) < 1e-12;
  }
  if (!blind) return weights;
  // Divided difference over the nodes of b, scaled so that b - weights does not use the node at the
  // end. Stages at one node share its weight, and count once.
  double scale = 0.0;
  for (int i = 0; i < tableau.stages; ++i) {
    if (tableau.b[i] == 0.0) continue;
    weights[i] = 1.0;
    int here = 0;
    for (int j = 0; j < tableau.stages; ++j) {
      if (tableau.b[j] == 0.0) continue;
      if (tableau.c[j] == tableau.c[i]) {
        ++here;
        continue;
      }
      bool seen = false;
      for (int k = 0; k < j; ++k)
        seen = seen || (tableau.b[k] != 0.0 && tableau.c[k] == tableau.c[j]);
      if (!seen) weights[i] /= tableau.c[i] - tableau.c[j];
    }
    if (tableau.c[i] == 1.0) scale = tableau.b[i] / weights[i];
    weights[i] /= here;
  }
  for (double& w : weights) w *= scale;
  return weights;
}

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
  quadrature_weights_ = quadrature_error_weights(tableau);
  error_covers_quadratures_ = std::all_of(quadrature_weights_.begin(), quadrature_weights_.end(),
                                          [](double w) { return w == 0.0; });
}

Outcome Stages::run(Evaluator& evaluate, double t, double h, double t_end, const double* y,
                    const double* f, double* y_new, double* error) {
  k_[0] = f;
  for (int s = 1; s < tableau_->stages; ++s) {
    combine(y_new, y, h, tableau_->a[s].data(), k_.data(), s, width_);
    double* k = memory_.data() + static_cast<std::size_t>(s - 1) * width_;
    const bool at_end = tableau_->last_stage_is_end && s + 1 == tableau_->stages;
    const Outcome outcome = evaluate(at_end ? t_end : t + tableau_->c[s] * h, y_new, k);
    if (outcome != Outcome::Ok) return outcome;
  }
  if (!tableau_->last_stage_is_end) {
    combine(y_new, y, h, tableau_->b.data(), k_.data(), tableau_->stages, width_);
  }
  combine(error, nullptr, h, error_weights_.data(), k_.data(), tableau_->stages, width_);
  if (!error_covers_quadratures_)
    add_quadrature_error_estimate(error, h, quadrature_weights_.data(), k_.data(), tableau_->stages,
                                  width_);
  return Outcome::Ok;
}

const double* Stages::end_derivative() const noexcept {
  return tableau_->last_stage_is_end ? k_[tableau_->stages - 1] : nullptr;
}

}  // namespace adore::integrators
