#include "dynamics/evaluation.hpp"

#include "tribology/traction_curve.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

SlipFriction::SlipFriction(const bearing::TractionCurve& curve) : curve_(curve) {
  constexpr double kSlip = tribology::kRegularisationSlip;
  if (tribology::traction_coefficient(curve, 0.0) != 0.0) smoothing_ = kSlip * kSlip;
}

double SlipFriction::per_slip(double u) const noexcept {
  return tribology::traction_coefficient(curve_, u) / std::sqrt(u * u + smoothing_);
}

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
  for (BodyState& body : segments) body.clear_actions();
  for (BodyState& body : race) body.clear_actions();
  for (BodyState& body : others) body.clear_actions();
  elastic = 0.0;
  valid = true;
}

}  // namespace adore::dynamics
