#pragma once

/// Sines and cosines of many angles at once.
namespace adore {

/// sine[i], cosine[i] of angle[i] [rad], i < n, to two units in the last place; the arrays do not
/// overlap. The same bytes on every machine while |angle| < 1e6; an array with a larger angle, or
/// NaN, is passed to the standard library.
///
/// Angle = k π/2 + r, |r| <= π/4, with π/2 in three parts (33 + 33 + 53 bits, so that k times the
/// first two is exact); then Taylor's series to r^17 and r^18, whose next terms are below 1e-19.
void sines_and_cosines(const double* angle, int n, double* sine, double* cosine) noexcept;

}  // namespace adore
