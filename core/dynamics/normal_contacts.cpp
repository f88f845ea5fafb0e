#include "dynamics/normal_contacts.hpp"

#include <algorithm>

namespace adore::dynamics {

NormalContacts::NormalContacts(const std::array<RaceContactModel, 2>& contacts,
                               const ElementSlices& slices, const ElementMasses& masses)
    : contacts_(contacts), s_(slices) {
  for (std::size_t i = 0; i < slices.elements(); ++i) per_mass_.push_back(1.0 / masses[i].mass);
  for (std::size_t j = 0; j < 2; ++j) {
    contacts_[j].traction = false;
    load_limit_[j] = load_limit(contacts[j]);
  }
  for (auto* array : {&sin_, &cos_, &load_, &heat_}) array->assign(slices.elements(), 0.0);
  for (auto& array : actions_) array.assign(slices.elements(), 0.0);
}

bool NormalContacts::evaluate(const std::array<RaceBody, 2>& races, const double* y, double* dydt,
                              int size) noexcept {
  const std::size_t n = sin_.size();
  ElementViews balls{};
  if (!view_elements(y, s_, sin_.data(), cos_.data(), balls)) return false;
  bool valid = true;
  for (auto& array : actions_) std::fill(array.begin(), array.end(), 0.0);
  const ElementForces out = forces_in(actions_, load_.data(), heat_.data(), nullptr);
  for (std::size_t j = 0; j < 2; ++j) {
    evaluate_race_contacts(contacts_[j], balls, races[j].motion(), out);
    for (const double Q : load_) valid = valid && !(Q > load_limit_[j]);
  }
  std::fill(dydt, dydt + size, 0.0);
  const double* const F_x = out.F_x;
  const double* const F_r = out.F_r;
  const double* const F_theta = out.F_theta;
  using enum Quantity;
  for (std::size_t i = 0; i < n; ++i) {
    dydt[s_.at(X, i)] = balls.x_dot[i];
    dydt[s_.at(R, i)] = balls.r_dot[i];
    dydt[s_.at(Theta, i)] = balls.theta_dot[i];
    dydt[s_.at(XDot, i)] = F_x[i] * per_mass_[i];
    dydt[s_.at(RDot, i)] = F_r[i] * per_mass_[i];
    dydt[s_.at(ThetaDot, i)] = F_theta[i] * per_mass_[i] / balls.r[i];
  }
  return valid;
}

}  // namespace adore::dynamics
