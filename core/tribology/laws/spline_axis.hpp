#pragma once

#include "base/scalar_lanes.hpp"
#include "base/scalar_math.hpp"

namespace adore::tribology {

/// Uniform cubic B-splines over one variable: `knots` coefficients whose middles stand at from,
/// from + step ... less one at each end. Four of them are not 0 at a place; outside the edge holds.
struct SplineAxis {
  int knots = 4;
  double from = 0.0, inverse_step = 1.0;

  template <class T>
  struct Place {
    T cell;       ///< first of the four coefficients, a whole number
    T weight[4];  ///< sum to 1
  };
  template <class T>
  struct Cell {
    T cell;    ///< as above
    T inside;  ///< place in it, 0 to 1
  };
  /// For tables of tiles (base/single.hpp).
  template <class T>
  [[gnu::always_inline]] Cell<T> cell(const T& x) const {
    using M = ScalarMath<T>;
    const double last = static_cast<double>(knots - 3);
    const T steps = (x - from) * inverse_step;
    const T s = M::min(M::pick(steps > 0.0, steps, T(0.0)), T(last));  // no number: the first
    const T whole = M::min(ScalarLanes<T>::floor(s), T(last - 1.0));
    return {whole, s - whole};
  }
  template <class T>
  [[gnu::always_inline]] Place<T> at(const T& x) const {
    using M = ScalarMath<T>;
    const T last = static_cast<double>(knots - 3);  // cells
    const T steps = (x - from) * inverse_step;
    const T s = M::min(M::pick(steps > 0.0, steps, T(0.0)), last);  // NaN: the first
    Place<T> out;
    out.cell = ScalarLanes<T>::floor(M::min(s, last - 1e-9));
    weights(s - out.cell, out.weight);
    return out;
  }
  /// Of the four coefficients, at the place f in a cell.
  template <class T>
  [[gnu::always_inline]] static void weights(const T& f, T* weight) {
    const T g = 1.0 - f, f2 = f * f, g2 = g * g;
    weight[0] = g2 * g * (1.0 / 6.0);
    weight[1] = 2.0 / 3.0 - f2 * (1.0 - 0.5 * f);
    weight[3] = f2 * f * (1.0 / 6.0);
    weight[2] = 1.0 - weight[0] - weight[1] - weight[3];
  }
};

}  // namespace adore::tribology
