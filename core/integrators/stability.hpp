#pragma once

#include <string_view>
#include <vector>

/// Effect of a method on a vibration that it does not resolve. The test equation is y' = λ y with
/// λ = (-ζ + √(ζ² - 1)) ω: a contact vibration of damping ratio ζ, y' = iω y without damping. A
/// method multiplies its amplitude by a factor per step that depends on hω only; above 1 the
/// vibration grows from rounding until the error control detects it, far below the loads that it
/// then has.
namespace adore::integrators {

/// Order of the method's steps: methods of fixed order have one.
/// CVODE changes its order; `order` is the one held by the package's last steps, or its bound.
inline constexpr int kOwnOrder = 0;

/// Amplification per step of equal size at hω = phase, dimensionless: the largest modulus of the
/// eigenvalues of the step's matrix. 1: kept, below: damped, above: grows.
///
///   rkf, arkode    |R(iφ)|, R(z) = 1 + z bᵀ (1 - z A)⁻¹ 1 of the solution that is propagated;
///                  arkode-imex with the whole vibration in its implicit part, as dynamics splits
///                  it
///   pece           predict, evaluate, correct, evaluate, with the history of derivatives and the
///                  weights (adams_weights) that the stepper itself uses
///   cvode-adams    Nordsieck predictor and one fixed-point iteration: what the package does while
///                  a vibration is small against the tolerance
///   cvode-bdf      backward differences of the order, solved exactly
///
/// Sources: [hairer1993] II.2, III.3-5; [hairer1996] IV.2-3, V.1; [hindmarsh2005] for CVODE's mode.
/// Limits: linear, equal steps. Unequal steps of an explicit one-step method multiply their own
/// factors; for the multistep methods see history_amplification().
/// @param damping ζ >= 0; above 1 the faster of the two decays, λ = -(ζ + √(ζ² - 1)) ω
/// @throws std::invalid_argument for an unknown method, or an order that it does not have.
[[nodiscard]] double amplification(std::string_view method, double phase, int order = kOwnOrder,
                                   double damping = 0.0);

}  // namespace adore::integrators
