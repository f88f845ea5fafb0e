#pragma once

#include "scene/user_laws.hpp"

#include <cstddef>
#include <utility>
#include <vector>

/// ADRX2 to ADRX4: what a routine of the user makes of the normal forces of one kind of contact, or
/// damping in its place (contact_damping.hpp).
///
/// The built-in block acts as without a routine; a block behind it collects its contacts, asks for
/// all of them in one call and adds the difference, times F/N of the force asked for and the
/// built-in one, so that friction goes with the force and a law that is restated changes nothing,
/// not a bit. Along the normal the difference has the power
///   (F - N) d(gap)/dt,
/// without a potential that is known: it is booked with the heat of the kind (damping: by itself),
/// where a damping law heats and an elastic one gives back what it took. d(gap)/dt must therefore
/// be the power of the built-in normal force over N. Limit: a contact that the built-in law leaves
/// open is not asked for.
namespace adore::dynamics {

template <class Touch>
class UserForces {
 public:
  /// @param most contacts there can be
  UserForces(scene::UserForce& routine, std::size_t most) : routine_(routine) {
    touches_.reserve(most);
    for (auto* values : {&gap_, &rate_, &built_in_, &force_}) values->reserve(most);
    element_.reserve(most);
    surface_.reserve(most);
  }
  void clear() noexcept {
    touches_.clear();
    for (auto* values : {&gap_, &rate_, &built_in_, &force_}) values->clear();
    element_.clear();
    surface_.clear();
  }
  /// @param load N > 0
  void collect(const Touch& touch, std::size_t element, std::size_t surface, double gap,
               double rate, double load) {
    touches_.push_back(touch);
    element_.push_back(static_cast<int>(element));
    surface_.push_back(static_cast<int>(surface));
    gap_.push_back(gap);
    rate_.push_back(rate);
    built_in_.push_back(load);
    force_.push_back(load);
  }
  /// act(touch, (F - N)/N, F - N, d(gap)/dt) of what is not as built in. False: no valid state.
  template <class Act>
  bool ask(double t, const Act& act) noexcept {
    if (touches_.empty()) return true;
    if (!routine_.forces(t, {touches_.size(), element_.data(), surface_.data(), gap_.data(),
                             rate_.data(), built_in_.data(), force_.data()}))
      return false;
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      const double difference = force_[k] - built_in_[k];
      if (difference != 0.0) act(touches_[k], difference / built_in_[k], difference, rate_[k]);
    }
    return true;
  }
  /// visit(touch, surface, F - N) of the last call, for reports.
  template <class Visit>
  void for_differences(const Visit& visit) const {
    for (std::size_t k = 0; k < touches_.size(); ++k)
      if (force_[k] != built_in_[k])
        visit(touches_[k], static_cast<std::size_t>(surface_[k]), force_[k] - built_in_[k]);
  }

 private:
  scene::UserForce& routine_;
  std::vector<Touch> touches_;
  std::vector<int> element_, surface_;
  std::vector<double> gap_, rate_, built_in_, force_;
};

}  // namespace adore::dynamics
