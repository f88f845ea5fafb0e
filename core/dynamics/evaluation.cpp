#include "dynamics/evaluation.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

Evaluation::Evaluation(std::size_t n) : sin_theta(n), cos_theta(n) {
  for (auto& array : actions) array.assign(n, 0.0);
  for (auto* arrays : {&load, &heat, &load_slip})
    for (auto& array : *arrays) array.assign(n, 0.0);
}

void Evaluation::begin(double time, const double* state, double* rates) noexcept {
  t = time;
  y = state;
  dydt = rates;
  clear_actions();
  valid = true;
}

void Evaluation::clear_actions() noexcept {
  for (auto& array : actions) std::fill(array.begin(), array.end(), 0.0);
  for (BodyState& body : segments) body.clear_actions();
  for (BodyState& body : race) body.clear_actions();
  for (BodyState& body : others) body.clear_actions();
  elastic = 0.0;
}

}  // namespace adore::dynamics
