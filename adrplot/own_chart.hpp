#pragma once

#include "adrplot/plot_document.hpp"

#include <cstddef>
#include <vector>

/// Charts of the user's own: any curves of any open files over one abscissa.
namespace adore::adrplot {

/// A curve of a page of an open file.
struct CurvePick {
  const PlotDocument* file = nullptr;
  int page = 1;
  std::size_t panel = 0, curve = 0;
};

enum class Combine : unsigned char { Overlay, Difference };

/// One page: curves of one unit share a panel. The abscissa has every value of every curve; between
/// its own values a curve is a straight line, outside of them it is not drawn.
/// Difference: every curve less the first one, which must have the same unit.
/// With the domain of spectra each curve's own is drawn, or that of its difference; of waterfalls
/// the first curve's.
/// @throws InputError without curves, with different abscissae or, for differences, units
[[nodiscard]] desktop::ChartPage combine_curves(const std::vector<CurvePick>& picks, Combine how,
                                                const PageOptions& options);

/// Values of y(x) at other points by linear interpolation; NaN outside of x and next to missing
/// values.
[[nodiscard]] std::vector<double> read_off(const std::vector<double>& x,
                                           const std::vector<double>& y,
                                           const std::vector<double>& where);

}  // namespace adore::adrplot
