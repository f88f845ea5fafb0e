#pragma once

#include "bearing/imperfections.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

/// Surfaces over both coordinates, which series over the azimuth cannot state. SI, rad.
namespace adore::bearing {

/// Coefficients of a cubic B-spline (contact/race_table.hpp), row by row, `around` of each row over
/// the turn. Rows of grooves that balls run in are angles φ on the groove arc, from `first` on; of
/// races of rollers their slices; of balls latitudes, of a direction n in the ball: the azimuth
/// about its x axis from its z axis, and asin n_x.
struct SurfaceTable {
  int around = 0, across = 0;
  double first = 0.0, step = 1.0;  ///< of balls and their grooves [rad]
  std::vector<double> height;      ///< races: how far the surface recedes from the element; balls:
                                   ///< larger radius [m]
  std::vector<double> factor;      ///< grooves of balls: change of the factor f; empty: none [-]
};

/// A race or an element by a table. The series of SurfaceSeries have least and largest alone; one
/// of them is no number, so that who does not know tables does not take them for an ideal surface.
struct TabulatedSurface : SurfaceSeries {
  SurfaceTable table;

  explicit TabulatedSurface(SurfaceTable values) : table(std::move(values)) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    radius.pairs = {kNone, kNone};
  }
};

/// The table of a surface; null: it has series.
[[nodiscard]] inline const SurfaceTable* table_of(const SurfaceSeries* given) noexcept {
  if (given == nullptr || given->radius.pairs.empty() || !std::isnan(given->radius.pairs[0]))
    return nullptr;
  return &static_cast<const TabulatedSurface*>(given)->table;
}

}  // namespace adore::bearing
