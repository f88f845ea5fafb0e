#pragma once

#include <array>

#include "bearing/bearing.hpp"

/// The hypothetical traction-slip curve κ(u) in its four prescriptions (records 10.1, 10.2, 10.5; N44, N45).
namespace adore::tribology {

/// kTracType and the four record fields -> curve. -1: A,B,C,D; 0: two slopes A,B,C,u0; 1: κ0, κmax, κ∞, u_m;
/// 2: κ0, κ∞, initial slope, unused.
/// @throws InputError saying which condition cannot be met (e.g. κmax < κ∞).
[[nodiscard]] bearing::TractionCurve traction_curve(int type, const std::array<double, 4>& tc);

/// κ(|u|) for u >= 0, no regularisation.
[[nodiscard]] double traction_coefficient(const bearing::TractionCurve& curve, double slip) noexcept;

/// Slip below which laws with κ(0) ≠ 0 are regularised: factor u/sqrt(u²+ε²), ε = this [m/s]. Stated in PRINT.txt.
inline constexpr double kRegularisationSlip = 1e-5;

}  // namespace adore::tribology
