#pragma once

#include "dynamics/constrained.hpp"
#include "dynamics/evaluation.hpp"

#include <array>
#include <cstddef>
#include <span>

/// What held elements (held_elements.hpp) touch: the part of the light-load balance that depends on
/// the kind of element. Vectors in the basis (e_x, e_r, e_θ) of each element; one call for all held
/// elements, none per contact. SI.
namespace adore::dynamics {

/// Normal forces F_j of the races (with their flanges) and how they change.
struct HeldSprings {
  std::array<Mat3, 2> race;       ///< -∂F_j over the element's place [N/m]
  std::array<Mat2, 2> along;      ///< I - n nᵀ of each race contact in (x, r)
  std::array<Vec3, 2> turning;    ///< dF_j/dt by the turning alone of the element, and of a race
                                  ///< with errors [N/s]
  Vec3 normal = Vec3::Zero();     ///< Σ F_j [N]
  Mat3 stiffness = Mat3::Zero();  ///< of races and cage together [N/m]
};

/// All forces at the rates that the evaluation's elements have.
struct HeldForces {
  Vec3 force = Vec3::Zero();    ///< of races with friction, cage, gravity, turning frame ... [N]
  double race_theta = 0.0;      ///< of the races alone along e_θ [N]
  Mat2 damping = Mat2::Zero();  ///< C: friction force over slip speed in (x, r) [N s/m]
};

/// Where an element would stand in balance.
struct HeldPlace {
  double x = 0.0, r = 0.0;  ///< [m]
  double speed = 0.0;       ///< θ̇ there, m r² θ̇ kept [rad/s]
  double load = 0.0;        ///< larger of both race loads [N]
  bool solved = false;
};

class HeldContacts {
 public:
  virtual ~HeldContacts() = default;
  virtual void springs(const Evaluation& e, std::span<const std::size_t> held,
                       std::span<HeldSprings> out) noexcept = 0;
  /// @param e its elements have the rates; what bodies feel is as before afterwards
  /// @return force of the elements on the inner race, base axes [N]
  virtual Vec3 forces(Evaluation& e, std::span<const std::size_t> held,
                      std::span<const HeldSprings> springs, std::span<HeldForces> out) noexcept = 0;
  /// Balance of the races' normal forces and `force` on (x, r) [N].
  [[nodiscard]] virtual HeldPlace balanced(const Evaluation& e, std::size_t i,
                                           const Vec2& force) const = 0;
  /// Normal forces of the races on (x, r) [N].
  [[nodiscard]] virtual Vec2 normal_force(const Evaluation& e, std::size_t i) const noexcept = 0;
  /// Longest way that a held element may be thrown at once [m].
  [[nodiscard]] virtual double free_path() const noexcept = 0;
};

/// Adds the friction of a contact of load Q, heat and load-slip: Q κ/u = heat (Q/load-slip)².
inline void add_friction_damping(double load, double heat, double load_slip, const Mat2& along,
                                 Mat2& damping) noexcept {
  if (load_slip > 0.0 && heat > 0.0)
    damping += heat * (load / load_slip) * (load / load_slip) * along;
}

}  // namespace adore::dynamics
