#pragma once

#include "dynamics/element_masses.hpp"
#include "dynamics/evaluation.hpp"

#include <cstddef>

/// One rolling element, some of whose accelerations are given, with its mass center off its
/// reference point P (element_masses.hpp). SI, components on e_x, e_r, e_θ.
///
/// Given are ẍ, r̈ or θ̈ of P, and the rates of ω_x or of (ω_r, ω_θ) on the azimuth axes: all
/// zero. P and the attitude are the coordinates; the constraint of a coordinate acts on it alone,
/// so it is a force at P along the held direction, or a moment about the held axis (d'Alembert).
/// With a_P = (ẍ, r̈ - r θ̇², r θ̈ + 2 ṙ θ̇), c the arm and I_P about P:
///   m (a_P + ω̇ × c + ω × (ω × c)) = F + H,   m c × a_P + I_P ω̇ + ω × I_P ω = M + N
/// are six equations for the free rates and the components of H and N that hold the others. With c
/// = 0 and a ball these are independent equations, and the given rates are those of the free
/// element replaced by zero.
namespace adore::dynamics {

/// Given accelerations.
struct ElementConstraints {
  bool x = false, r = false, theta = false;  ///< of P
  bool spin = false;                         ///< of ω_x
  bool tilt = false;                         ///< of ω_r and ω_θ
};

struct ElementRates {
  double x_ddot = 0.0, r_ddot = 0.0, theta_ddot = 0.0;
  Vec3 omega = Vec3::Zero();                         ///< rates of ω on the azimuth axes
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< H and N [N, N m]
};

/// From what acts on element i now (Evaluation::actions), its attitude and its rates.
[[nodiscard]] ElementRates constrained_element(const Evaluation& e, std::size_t i,
                                               const ElementMass& body,
                                               const ElementConstraints& hold) noexcept;

}  // namespace adore::dynamics
