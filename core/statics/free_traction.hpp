#pragma once

#include "tribology/ellipse_traction.hpp"
#include "tribology/traction_law.hpp"

#include <algorithm>
#include <cmath>

/// Friction of a contact whose element rolls freely. SI.
namespace adore::statics {

/// The root of an increasing function between two bounds by regula falsi with halving (Illinois).
/// @param width of the bracket where the search ends, in addition to rounding
template <class F>
[[nodiscard]] double root_between(const F& f, double low, double high, double width = 0.0) {
  double at_low = f(low), at_high = f(high);
  if (at_low >= 0.0) return low;
  if (at_high <= 0.0) return high;
  double x = 0.5 * (low + high);
  for (int n = 0; n < 60; ++n) {
    x = (low * at_high - high * at_low) / (at_high - at_low);
    const double y = f(x);
    if (y == 0.0) break;
    if (y < 0.0) {
      low = x;
      at_low = y;
      at_high *= 0.5;
    } else {
      high = x;
      at_high = y;
      at_low *= 0.5;
    }
    if (high - low <= width + 1e-12 * (std::abs(low) + std::abs(high))) break;
  }
  return x;
}

/// Traction of an ellipse that creeps freely: its u_t is the one without force along the rolling
/// direction, ∫ τ_t dA = 0 (friction.hpp).
[[nodiscard]] inline tribology::EllipseTraction free_traction(const tribology::TractionLaw& law,
                                                              const tribology::EllipseGeometry& g,
                                                              tribology::EllipseKinematics m,
                                                              const tribology::EllipseRule& rule) {
  // u_t of a surface point is u + range; no creep beyond it leaves force in one direction only.
  const double middle = m.W_c * g.height(0.0), edge = m.W_c * g.height(g.a);
  const double spin = std::abs(m.W_n) * g.a;
  const double low = std::min(middle, edge) - spin, high = std::max(middle, edge) + spin;
  if (!(high > low)) return {};
  m.u_t = root_between(
      [&](double u) {
        m.u_t = u;
        return tribology::ellipse_traction(law, g, m, rule).F_t;
      },
      low, high);
  return tribology::ellipse_traction(law, g, m, rule);
}

}  // namespace adore::statics
