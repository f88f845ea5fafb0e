#pragma once

#include "bearing/given_surface.hpp"
#include "contact/race_table.hpp"

#include <algorithm>
#include <cstddef>

/// Race of rollers whose surface is a table over azimuth and slices (user routine ADRX6): slice k
/// meets a race that is farther by w_k(ψ), ψ that of the roller's middle in the race. SI, rad.
namespace adore::contact {

/// What each slice has at one azimuth, to arrays of table.across numbers.
/// @param radius in: of the roller's slices, out: less w_k [m]; rise ∂δ_k/∂ψ [m/rad], may be null
inline void apply_table_to_slices(const bearing::SurfaceTable& table, double psi, double* radius,
                                  double* rise) noexcept {
  const TableColumn column = table_column(table.around, psi);
  const SplineWeights a = spline_weights(column.rest);
  const double per_column = table.around / 6.28318530717958647692;
  for (int k = 0; k < table.across; ++k) {
    const double* const row = table.height.data() + static_cast<std::ptrdiff_t>(k) * table.around;
    double value = 0.0, slope = 0.0;
    for (int i = 0; i < 4; ++i) {
      const double c = row[wrap_column(column.first + i, table.around)];
      value += a.w[i] * c;
      slope += a.d[i] * c;
    }
    radius[k] -= value;
    if (rise != nullptr) rise[k] = -per_column * slope;
  }
}

/// By how much a slice can be nearer than to the ideal race [m].
[[nodiscard]] inline double nearest(const bearing::SurfaceTable& table) {
  return std::max(0.0, -*std::min_element(table.height.begin(), table.height.end()));
}

}  // namespace adore::contact
