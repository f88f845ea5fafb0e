#include "dynamics/elements.hpp"

#include "base/sine_cosine.hpp"

#include <cmath>

namespace adore::dynamics {

bool view_elements(const double* y, const ElementSlices& slices, double* sin, double* cos,
                   ElementViews& out) noexcept {
  out.n = slices.elements();
  for (std::size_t q = 0; q < kQuantities.size(); ++q)
    out.*kQuantities[q].view = y + slices[static_cast<Quantity>(q)].first;
  sines_and_cosines(out.theta, static_cast<int>(out.n), sin, cos);
  bool valid = true;
  for (std::size_t i = 0, n = out.n; i < n; ++i) valid = valid && out.r[i] > 0.0;
  out.sin_theta = sin;
  out.cos_theta = cos;
  return valid;
}

ElementViews view_of(const ElementStorage& storage, std::size_t n) noexcept {
  ElementViews out{};
  out.n = n;
  for (std::size_t k = 0; k < storage.size(); ++k) out.*kElementViews[k] = storage[k].data();
  return out;
}

void gather(const ElementViews& from, std::size_t i, ElementStorage& to, std::size_t k) noexcept {
  for (std::size_t q = 0; q < to.size(); ++q) to[q][k] = (from.*kElementViews[q])[i];
}

ElementForces element_force_targets(ElementActions& actions, double* load, double* heat,
                                    double* load_slip) noexcept {
  ElementForces out{};
  for (std::size_t k = 0; k < actions.size(); ++k) out.*kElementActions[k] = actions[k].data();
  out.load = load;
  out.heat = heat;
  out.load_slip = load_slip;
  return out;
}

}  // namespace adore::dynamics
