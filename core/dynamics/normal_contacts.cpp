#include "dynamics/normal_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

NormalContacts::NormalContacts(const std::array<RaceContactModel, 2>& contacts,
                               const BallSlices& slices, double mass)
    : contacts_(contacts), s_(slices), per_mass_(1.0 / mass) {
  for (std::size_t j = 0; j < 2; ++j) {
    contacts_[j].traction = false;
    load_limit_[j] = load_limit(contacts[j]);
  }
  for (auto* array : {&sin_, &cos_, &F_x_, &F_r_, &F_theta_, &M_, &load_, &heat_})
    array->assign(static_cast<std::size_t>(slices.x.count), 0.0);
}

bool NormalContacts::evaluate(const std::array<RaceState, 2>& races, const double* y, double* dydt,
                              int size) noexcept {
  const std::size_t n = sin_.size();
  const double* theta = y + s_.theta.first;
  const double* r = y + s_.r.first;
  bool valid = true;
  for (std::size_t i = 0; i < n; ++i) {
    sin_[i] = std::sin(theta[i]);
    cos_[i] = std::cos(theta[i]);
    valid = valid && r[i] > 0.0;
  }
  if (!valid) return false;
  const BallArrays balls{n,
                         y + s_.x.first,
                         r,
                         sin_.data(),
                         cos_.data(),
                         y + s_.x_dot.first,
                         y + s_.r_dot.first,
                         y + s_.theta_dot.first,
                         y + s_.omega_x.first,
                         y + s_.omega_r.first,
                         y + s_.omega_theta.first};
  for (auto* array : {&F_x_, &F_r_, &F_theta_}) std::fill(array->begin(), array->end(), 0.0);
  for (std::size_t j = 0; j < 2; ++j) {
    // Without traction nothing is added to the moments, so one array stands for all three.
    evaluate_race_contacts(contacts_[j], balls, races[j].motion,
                           {F_x_.data(), F_r_.data(), F_theta_.data(), M_.data(), M_.data(),
                            M_.data(), load_.data(), heat_.data(), nullptr});
    for (const double Q : load_) valid = valid && !(Q > load_limit_[j]);
  }
  std::fill(dydt, dydt + size, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    dydt[s_.x.first + i] = balls.x_dot[i];
    dydt[s_.r.first + i] = balls.r_dot[i];
    dydt[s_.theta.first + i] = balls.theta_dot[i];
    dydt[s_.x_dot.first + i] = F_x_[i] * per_mass_;
    dydt[s_.r_dot.first + i] = F_r_[i] * per_mass_;
    dydt[s_.theta_dot.first + i] = F_theta_[i] * per_mass_ / r[i];
  }
  return valid;
}

}  // namespace adore::dynamics
