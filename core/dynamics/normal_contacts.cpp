#include "dynamics/normal_contacts.hpp"

#include <algorithm>
#include <utility>

namespace adore::dynamics {

NormalContacts::NormalContacts(std::vector<RaceContactModel> contacts, const ElementSlices& slices,
                               const ElementMasses& masses)
    : contacts_(std::move(contacts)), s_(slices) {
  for (std::size_t i = 0; i < slices.elements(); ++i) inverse_mass_.push_back(1.0 / masses[i].mass);
  for (RaceContactModel& contact : contacts_) {
    contact.traction = false;
    load_limit_.push_back(load_limit(contact));
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
  const ElementForces out = element_force_targets(actions_, load_.data(), heat_.data(), nullptr);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const RaceBody& race = races[static_cast<std::size_t>(contacts_[k].race)];
    evaluate_race_contacts(contacts_[k], balls, race.motion(), out);
    for (const double Q : load_) valid = valid && !(Q > load_limit_[k]);
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
    dydt[s_.at(XDot, i)] = F_x[i] * inverse_mass_[i];
    dydt[s_.at(RDot, i)] = F_r[i] * inverse_mass_[i];
    dydt[s_.at(ThetaDot, i)] = F_theta[i] * inverse_mass_[i] / balls.r[i];
  }
  return valid;
}

}  // namespace adore::dynamics
