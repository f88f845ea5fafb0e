#pragma once

#include "contact/damping_law.hpp"
#include "scene/user_laws.hpp"

#include <cstddef>
#include <utility>
#include <vector>

/// ADRX2 to ADRX4: normal forces of one kind of contact by a user routine.
///
/// The built-in block acts as without a routine; a following block collects its contacts, calls the
/// routine once for all of them and adds the difference, times the ratio of the difference to the
/// built-in elastic force N, so that friction follows the force and a law equal to the built-in one
/// changes no bit. The routine returns the elastic force F; damping
/// (contact/damping_law.hpp) acts in addition to it: the contact has the total force
///   P(F) = max(0, F + (d F + c) δ̇)  in place of P(N), c of the built-in stiffness.
/// Along the normal, F - N has the power (F - N) d(gap)/dt, without a known potential: it
/// is booked with the heat of the kind, where a damping law heats and an elastic one gives back
/// the energy; the part of damping is booked with damping. d(gap)/dt must therefore be the power of
/// the built-in normal force over N. Limit: the routine is not called for a contact that the
/// built-in law leaves open.
namespace adore::dynamics {

/// A contact as the built-in block damped it.
struct DampedContact {
  contact::DampingLaw<> law;
  double stiffness = 0.0;  ///< as damped_load() takes it
  double load = 0.0;       ///< P(N) [N]
};
[[nodiscard]] inline DampedContact damped_contact(const contact::DampingLaw<>& law, double load,
                                                  double stiffness, double approach,
                                                  double rate) noexcept {
  return {law, stiffness, contact::damped_load(law, load, stiffness, approach, rate)};
}

/// Changes that a routine makes at a contact.
struct UserForceDifference {
  double ratio = 0.0;    ///< (P(F) - P(N))/N
  double force = 0.0;    ///< P(F) - P(N) [N]
  double heat = 0.0;     ///< (N - F) d(gap)/dt [W]
  double damping = 0.0;  ///< additional power of damping [W]
};

template <class Touch>
class UserForces {
 public:
  /// @param most contacts there can be
  UserForces(scene::UserContactForce& routine, std::size_t most) : routine_(routine) {
    touches_.reserve(most);
    damped_contacts_.reserve(most);
    for (auto* values : {&gap_, &rate_, &built_in_, &force_}) values->reserve(most);
    element_.reserve(most);
    surface_.reserve(most);
  }
  void clear() noexcept {
    touches_.clear();
    damped_contacts_.clear();
    for (auto* values : {&gap_, &rate_, &built_in_, &force_}) values->clear();
    element_.clear();
    surface_.clear();
  }
  /// @param load N > 0
  void collect(const Touch& touch, std::size_t element, std::size_t surface, double gap,
               double rate, double load, const DampedContact& damped) {
    touches_.push_back(touch);
    damped_contacts_.push_back(damped);
    element_.push_back(static_cast<int>(element));
    surface_.push_back(static_cast<int>(surface));
    gap_.push_back(gap);
    rate_.push_back(rate);
    built_in_.push_back(load);
    force_.push_back(load);
  }
  /// act(touch, UserForceDifference) of what is not as built in. False: no valid state.
  template <class Act>
  bool ask(double t, const Act& act) noexcept {
    if (touches_.empty()) return true;
    if (!routine_.forces(t, {touches_.size(), element_.data(), surface_.data(), gap_.data(),
                             rate_.data(), built_in_.data(), force_.data()}))
      return false;
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      const double N = built_in_[k], F = force_[k], rate = rate_[k];
      if (F == N) continue;
      const DampedContact& built_in = damped_contacts_[k];
      const double total =
          contact::damped_load(built_in.law, F, built_in.stiffness, -gap_[k], -rate);
      const double difference = total - built_in.load;
      act(touches_[k], UserForceDifference{difference / N, difference, (N - F) * rate,
                                           (built_in.load - N - (total - F)) * rate});
    }
    return true;
  }

 private:
  scene::UserContactForce& routine_;
  std::vector<Touch> touches_;
  std::vector<DampedContact> damped_contacts_;
  std::vector<int> element_, surface_;
  std::vector<double> gap_, rate_, built_in_, force_;
};

}  // namespace adore::dynamics
