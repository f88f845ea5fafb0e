#include "tribology/edge_slips.hpp"

#include <algorithm>
#include <cmath>

#ifndef ADORE_CLONES  // core/CMakeLists.txt
#define ADORE_CLONES
#endif

namespace adore::tribology {

namespace {

/// A constant kCurved keeps the choice of the surface out of the loop.
template <bool kCurved>
[[gnu::always_inline]] inline void slips(const EdgeContact& c, int n, const double* s,
                                         double* across, double* rolling,
                                         double* squares) noexcept {
  const double swing = c.W_n * c.b, offset = c.h0 - c.rho, rho2 = c.rho * c.rho;
  for (int i = 0; i < n; ++i) {
    const double xi = s[i] * c.a;
    const double outside = 1.0 - s[i] * s[i];
    const double chord = std::sqrt(outside > 0.0 ? outside : 0.0);
    // Two forms of one height: this one without cancellation, and that of the integrals.
    double height = c.h0, summed = offset;
    if constexpr (kCurved) {
      const double under = rho2 - xi * xi;
      const double root = std::sqrt(under > 0.0 ? under : 0.0);
      height = c.h0 - xi * xi / (c.rho + root);
      summed = offset + root;
    }
    const double u_c = std::abs(c.u_c + c.W_t * height) + std::abs(swing * chord);
    const double u_t = c.u_t + c.W_n * xi - c.W_c * summed;
    across[i] = u_c;
    rolling[i] = u_t;
    squares[i] = u_c * u_c + u_t * u_t;
  }
}

}  // namespace

ADORE_CLONES void edge_slips(const EdgeContact& contact, int n, const double* s, double* across,
                             double* rolling, double* squares) noexcept {
  if (contact.rho > 0.0)
    slips<true>(contact, n, s, across, rolling, squares);
  else
    slips<false>(contact, n, s, across, rolling, squares);
}

}  // namespace adore::tribology
