#pragma once

#include "dynamics/constrained.hpp"
#include "dynamics/evaluation.hpp"

#include <array>
#include <cstddef>
#include <span>

/// Contacts of held elements (held_elements.hpp): the part of the light-load balance that depends
/// on the kind of element: normal forces of the races. Vectors in the basis (e_x, e_r, e_θ) of each
/// element; one call for all held elements, none per contact. SI.
namespace adore::dynamics {

/// Normal forces F_j of the races (with their flanges) and how they change.
struct ContactLinearization {
  std::array<Mat3, 2> race;       ///< -∂F_j over the element's place [N/m]
  std::array<Mat2, 2> along;      ///< I - n nᵀ of each race contact in (x, r)
  std::array<Vec3, 2> turning;    ///< dF_j/dt by the turning alone of the element, and of a race
                                  ///< with errors [N/s]
  Vec3 normal = Vec3::Zero();     ///< Σ F_j [N]
  Mat3 stiffness = Mat3::Zero();  ///< of all that it touches [N/m]
};

/// Position of an element in balance.
struct QuasiStaticPosition {
  double x = 0.0, r = 0.0;  ///< [m]
  double speed = 0.0;       ///< θ̇ there, m r² θ̇ kept [rad/s]
  double load = 0.0;        ///< larger of both race loads [N]
  bool solved = false;
};

class QuasiStaticContacts {
 public:
  virtual ~QuasiStaticContacts() = default;
  /// Of the races; `stiffness` is theirs alone.
  virtual void springs(const Evaluation& e, std::span<const std::size_t> held,
                       std::span<ContactLinearization> out) noexcept = 0;
  /// Balance of the races' normal forces and `force` on (x, r) [N].
  [[nodiscard]] virtual QuasiStaticPosition balanced(const Evaluation& e, std::size_t i,
                                                     const Vec2& force) const = 0;
  /// Normal forces of the races on (x, r) [N].
  [[nodiscard]] virtual Vec2 normal_force(const Evaluation& e, std::size_t i) const noexcept = 0;
  /// Longest way that a held element may be thrown at once [m].
  [[nodiscard]] virtual double max_free_displacement() const noexcept = 0;
};

}  // namespace adore::dynamics
