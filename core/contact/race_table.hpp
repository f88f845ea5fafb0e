#pragma once

#include "contact/race_wave.hpp"

#include <cmath>

/// Surface of a groove that varies along and across it (user routine ADRX6): a table over the
/// azimuth ψ of the race and the angle φ of the place on the groove arc, for numbers, dual numbers
/// and, lane by lane, vectors. Plain numbers, for kernels too. SI, rad.
///
/// φ is that of the direction from the groove centre to the ball centre: with (n_k, n_e) of
/// contact/ball_groove.hpp, φ = atan2(n_k, ±n_e), + outer and - inner race, so that x = r_g sin φ
/// across the groove. Values are a uniform cubic B-spline, C2, periodic in ψ; beyond the first and
/// last row in φ it goes on along its tangent. Set-up: setup/surface_table.hpp.
namespace adore::contact {

struct SurfaceDeviationTable {
  // Coefficients, row by row of one φ, `around` of them each; null: none.
  const double* height = nullptr;  ///< w, how far the surface recedes from the ball [m]
  const double* factor = nullptr;  ///< change of the groove factor f [-]
  int around = 0, across = 0;
  double first = 0.0, step = 1.0;  ///< φ of row 0, and between rows [rad]
  double side = 1.0;               ///< 1 outer race, -1 inner race
};

/// A value of the table and its derivatives.
struct TableValue {
  double value = 0.0, psi = 0.0, phi = 0.0, psi_psi = 0.0, psi_phi = 0.0, phi_phi = 0.0;
};

/// Cubic B-spline at t of 0 to 1: values, slopes, second derivatives over t.
struct SplineWeights {
  double w[4], d[4], dd[4];
};
[[nodiscard, gnu::always_inline]] inline SplineWeights spline_weights(double t) {
  const double u = 1.0 - t;
  return {{u * u * u / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
           (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0, t * t * t / 6.0},
          {-0.5 * u * u, 0.5 * t * (3.0 * t - 4.0), -0.5 * u * (3.0 * u - 4.0), 0.5 * t * t},
          {u, 3.0 * t - 2.0, 3.0 * u - 2.0, t}};
}

/// Place in one row: column and rest.
struct TableColumn {
  int first;  ///< of the four, before the turn closes
  double rest;
};
[[nodiscard, gnu::always_inline]] inline TableColumn table_column(int around, double psi) {
  constexpr double kTurn = 6.28318530717958647692;
  double u = psi / kTurn;
  u = (u - std::floor(u)) * around;
  const int i = static_cast<int>(u);
  return {i - 1, u - i};
}
[[nodiscard, gnu::always_inline]] inline int wrap_column(int column, int around) {
  return column < 0 ? column + around : column >= around ? column - around : column;
}

[[nodiscard, gnu::always_inline]] inline TableValue table_value(const SurfaceDeviationTable& table,
                                                                const double* coefficients,
                                                                double psi, double phi) {
  const double per_column = table.around / 6.28318530717958647692, per_row = 1.0 / table.step;
  const TableColumn column = table_column(table.around, psi);
  const SplineWeights a = spline_weights(column.rest);
  const double row = (phi - table.first) * per_row;
  const double most = table.across - 2.0, held = row < 1.0 ? 1.0 : row > most ? most : row;
  int m = static_cast<int>(held);
  if (m > table.across - 3) m = table.across - 3;
  const SplineWeights b = spline_weights(held - m);
  TableValue out;
  for (int i = 0; i < 4; ++i) {
    const double* const of_row =
        coefficients + static_cast<long>(m - 1 + i) * static_cast<long>(table.around);
    double value = 0.0, slope = 0.0, bend = 0.0;
    for (int k = 0; k < 4; ++k) {
      const double c = of_row[wrap_column(column.first + k, table.around)];
      value += a.w[k] * c;
      slope += a.d[k] * c;
      bend += a.dd[k] * c;
    }
    out.value += b.w[i] * value;
    out.psi += b.w[i] * slope;
    out.psi_psi += b.w[i] * bend;
    out.phi += b.d[i] * value;
    out.psi_phi += b.d[i] * slope;
    out.phi_phi += b.dd[i] * value;
  }
  out.psi *= per_column;
  out.psi_psi *= per_column * per_column;
  out.phi *= per_row;
  out.psi_phi *= per_column * per_row;
  out.phi_phi *= per_row * per_row;
  if (held != row) {
    const double beyond = (row - held) * table.step;
    out.value += beyond * out.phi;
    out.psi += beyond * out.psi_phi;
    out.phi_phi = 0.0;
  }
  return out;
}

/// Both functions where a ball touches.
template <class T>
struct TableAtContact {
  T height = 0.0, height_psi = 0.0, height_phi = 0.0;
  T factor = 0.0, factor_psi = 0.0, factor_phi = 0.0;
};

/// Of numbers and of dual numbers, whose derivatives follow from a step of first order. Vectors
/// have a specialisation where kernels are.
template <class T>
struct TableLookup {
  [[nodiscard, gnu::always_inline]] static double number(double x) { return x; }
  template <class D>
  [[nodiscard]] static double number(const D& x) {
    return x.v;
  }
  [[nodiscard, gnu::always_inline]] static TableAtContact<T> at(const SurfaceDeviationTable& table,
                                                                const AzimuthDirection<T>& psi,
                                                                const T& n_k, const T& n_e) {
    const double c = number(psi.cosine), s = number(psi.sine);
    const double k = number(n_k), e = table.side * number(n_e);
    const double at_psi = std::atan2(s, c), at_phi = std::atan2(k, e);
    const T turned = c * (psi.sine - s) - s * (psi.cosine - c);
    const T leaned = e * (n_k - k) - k * (table.side * n_e - e);
    TableAtContact<T> out;
    const auto take = [&](const double* of, T& value, T& over_psi, T& over_phi)
        __attribute__((always_inline)) {
      if (of == nullptr) return;
      const TableValue v = table_value(table, of, at_psi, at_phi);
      value = v.value + v.psi * turned + v.phi * leaned;
      over_psi = v.psi + v.psi_psi * turned + v.psi_phi * leaned;
      over_phi = v.phi + v.psi_phi * turned + v.phi_phi * leaned;
    };
    take(table.height, out.height, out.height_psi, out.height_phi);
    take(table.factor, out.factor, out.factor_psi, out.factor_phi);
    return out;
  }
};

}  // namespace adore::contact
