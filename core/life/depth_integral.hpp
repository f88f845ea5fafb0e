#pragma once

/// Orthogonal shear below a line contact, and the Ioannides-Harris integral over depth.
namespace adore::life {

/// Shear stress τ_xz below a frictionless Hertz line contact over the peak pressure, McEwen's
/// field: with m, n > 0 from m² - n² = b² - x² + z², m n = |x| z (lengths over b = 1):
/// τ = n (m² - z²)/(m² + n²), sign dropped. x along rolling, z depth > 0. [johnson1985 4.2]
[[nodiscard]] double line_shear(double x, double z) noexcept;

/// Largest line_shear over x at one depth: 0.25 at z = 0.5.
[[nodiscard]] double line_shear_amplitude(double z) noexcept;

/// I = ∫ <τ(ζ) - τ_u>^c ζ^-h dζ, τ the amplitude over p_max, depth ζ over b, <> zero where
/// negative. Converges at the surface for c/2 > h - 1 (τ falls as √ζ there).
/// @param limit_ratio τ_u / p_max >= 0
/// @throws InputError when the exponents let the integral diverge.
[[nodiscard]] double depth_integral(double limit_ratio, double c, double h);

}  // namespace adore::life
