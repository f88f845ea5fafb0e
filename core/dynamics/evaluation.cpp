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
  for (auto& array : actions) std::fill(array.begin(), array.end(), 0.0);
  cage.force.setZero();
  cage.moment.setZero();
  for (RaceState& r : race) {
    r.force.setZero();
    r.moment.setZero();
  }
  cage.load_slip = 0.0;
  elastic = 0.0;
  valid = true;
}

}  // namespace adore::dynamics
