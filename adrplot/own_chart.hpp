#pragma once

#include "adrplot/plot_document.hpp"

#include <cstddef>
#include <memory>
#include <vector>

/// User-defined charts: any curves of the open files over one horizontal axis.
namespace adore::adrplot {

/// A curve of a page of an open file.
struct CurvePick {
  const PlotDocument* file = nullptr;
  int page = 1;
  std::size_t panel = 0, curve = 0;
  int group = -1;  ///< curves of one group and unit share a panel; -1: those of one unit
};

enum class Combine : unsigned char { Overlay, Difference };

/// Curves of a user-defined chart. It holds the files of its curves, so that it outlives them in
/// the window.
struct UserChart {
  std::vector<CurvePick> curves;
  std::vector<std::shared_ptr<const PlotDocument>> files;  ///< one per curve
  Combine how = Combine::Overlay;
  /// Copies share the data read from a file.
  void add(const CurvePick& pick);
};

/// One page: curves of one unit share a panel. The abscissa contains the values of all curves;
/// between its own values a curve is interpolated linearly, outside it is not drawn.
/// Difference: each curve minus the first one, which must have the same unit.
/// For spectra, envelopes and orders, the spectrum of each curve or difference is drawn; for
/// spectrograms that of the first curve.
/// @throws InputError without curves, with different abscissae or, for differences, units
[[nodiscard]] desktop::ChartPage combine_curves(const std::vector<CurvePick>& picks, Combine how,
                                                const PageOptions& options);

/// Rotation of the run of a file at other times; unknown outside the run.
[[nodiscard]] RunMotion motion_at(const PlotDocument& file, const std::vector<double>& times);

/// The panel of each pick by its unit, as combine_curves() makes them without groups.
[[nodiscard]] std::vector<int> groups_by_unit(const std::vector<CurvePick>& picks,
                                              const PageOptions& options);

/// Values of y(x) at other points by linear interpolation; NaN outside of x and next to missing
/// values.
[[nodiscard]] std::vector<double> interpolated_values(const std::vector<double>& x,
                                                      const std::vector<double>& y,
                                                      const std::vector<double>& where);

}  // namespace adore::adrplot
