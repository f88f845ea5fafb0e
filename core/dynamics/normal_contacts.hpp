#pragma once

#include "dynamics/element_masses.hpp"
#include "dynamics/evaluation.hpp"

#include <array>
#include <vector>

namespace adore::dynamics {

/// The fastest part of the motion alone: ball centers vibrating on their normal race contacts,
///   ẋ = x_dot, ṙ = r_dot, θ̇ = theta_dot                       of every ball
///   ẍ = N_x/m, r̈ = N_r/m, θ̈ = N_θ/(m r),  N = -Σ_j Q_j n_j    (race_contacts.hpp, no traction)
/// and 0 for every other component. The velocities belong to it: with the accelerations alone
/// the implicit part would be ẍ(x) at a position that the explicit part has fixed already, hence
/// no more stable than an explicit method. It is the flow of the Hamiltonian ½m v² + Σ 0.4 K δ^2.5
/// except for the fictitious forces of the cylindrical coordinates, which are slow.
/// Source of the contact: race_contacts.hpp. Units SI. Limit: as there.
class NormalContacts {
 public:
  /// @param contacts of both races, of split ones with each half
  NormalContacts(std::vector<RaceContactModel> contacts, const ElementSlices& slices,
                 const ElementMasses& masses);
  /// Writes all `size` rates; false where the whole right-hand side is not valid either: a ball on
  /// the axis, or pressed into a race by more than its radius. No allocation.
  bool evaluate(const std::array<RaceBody, 2>& races, const double* y, double* dydt,
                int size) noexcept;

 private:
  std::vector<RaceContactModel> contacts_;  ///< without traction
  ElementSlices s_;
  std::vector<double> inverse_mass_;  ///< by ball [1/kg]
  std::vector<double> load_limit_;
  std::vector<double> sin_, cos_, load_, heat_;
  ElementActions actions_;  ///< without traction no moments
};

}  // namespace adore::dynamics
