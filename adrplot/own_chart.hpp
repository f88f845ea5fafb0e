#pragma once

#include "adrplot/plot_document.hpp"

#include <cstddef>
#include <vector>

/// User-defined charts: any curves of the open files over one horizontal axis.
namespace adore::adrplot {

/// A curve of a page of an open file.
struct CurvePick {
  const PlotDocument* file = nullptr;
  int page = 1;
  std::size_t panel = 0, curve = 0;
};

enum class Combine : unsigned char { Overlay, Difference };

/// One page: curves of one unit share a panel. The abscissa contains the values of all curves;
/// between its own values a curve is interpolated linearly, outside it is not drawn.
/// Difference: each curve minus the first one, which must have the same unit.
/// For spectra, the spectrum of each curve or difference is drawn; for waterfalls that of the first
/// curve.
/// @throws InputError without curves, with different abscissae or, for differences, units
[[nodiscard]] desktop::ChartPage combine_curves(const std::vector<CurvePick>& picks, Combine how,
                                                const PageOptions& options);

/// Values of y(x) at other points by linear interpolation; NaN outside of x and next to missing
/// values.
[[nodiscard]] std::vector<double> read_off(const std::vector<double>& x,
                                           const std::vector<double>& y,
                                           const std::vector<double>& where);

}  // namespace adore::adrplot
