#pragma once

/// Starved films: the meniscus stands m half widths before the contact (strParam of record 10.3).
///   ψ = m (b²/(2 R h))^(2/3), h the flooded film (Wolveridge, Baglin & Archard 1971).
namespace adore::tribology {

[[nodiscard]] double starvation_parameter(double meniscus, double half_width, double radius,
                                          double flooded_film);

/// φ = 1 - exp(-1.68005 ψ^0.8315 + 0.260137 ψ^1.558 - 0.016146 ψ^2.296), without the cut at ψ = 8
/// of its source: it approaches 1 smoothly. ψ <= 0: 0, a dry contact. 0 to 6 % above the integral.
[[nodiscard]] double starvation_factor(double psi);

/// The fit as its source has it: 1 for ψ >= 8.
[[nodiscard]] double starvation_factor_cut(double psi);

/// Grubin's inlet with a sharp meniscus (own derivation): with c = 4 √2/3 and I(ψ) = ∫0^ψ c
/// y^1.5/(1 + c y^1.5)³ dy, the starved film satisfies φ = [I(ψ φ^(-2/3))/I(∞)]^(3/4). To 1e-8.
[[nodiscard]] double starvation_factor_integral(double psi);

}  // namespace adore::tribology
