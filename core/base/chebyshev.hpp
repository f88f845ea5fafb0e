#pragma once

#include <cstddef>
#include <vector>

namespace adore {

/// The points cos(π(k + ½)/n), k = 0 ... n - 1, where chebyshev_coefficients wants its values.
[[nodiscard]] std::vector<double> chebyshev_points(std::size_t n);

/// Coefficients of Σ c_k T_k(x) from its values at those points, trailing ones below rounding
/// dropped (two are kept). Exact for polynomials of degree below n; for analytic functions the
/// coefficients fall like ρ^-k, ρ the sum of the half axes of the ellipse of regularity.
[[nodiscard]] std::vector<double> chebyshev_coefficients(const std::vector<double>& values);

/// The same polynomial in powers of x. Well conditioned for a few terms only: the coefficients grow
/// like 2^n.
[[nodiscard]] std::vector<double> chebyshev_to_monomial(const std::vector<double>& coefficients);

}  // namespace adore
