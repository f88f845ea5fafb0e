#pragma once

#include "desktop/axis_scale.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A page of charts as plain data: up to three panels stacked over a common abscissa, or one panel
/// with equal axes. No Qt.
namespace adore::desktop {

struct ChartCurve {
  std::string name;
  std::vector<double> y;  ///< one per abscissa value; NaN = no value, the line is broken there
  /// Empty: abscissa of the page (separate values only on pages with equal axes).
  std::vector<double> x;
  bool dashed = false;  ///< drawn broken, so that a curve below it stays visible
  bool heavy = false;   ///< drawn thick: the main curve
  /// Extremes between the values, drawn as a min-max band; empty: unknown. As long as y.
  std::vector<double> low = {}, high = {};
  /// Stored values, as long as y: others are interpolated linearly.
  /// Empty: all are stored.
  std::vector<bool> stored = {};
  bool hidden = false;     ///< by its entry in the legend
  std::string brief = {};  ///< complete name for readouts; empty: title and name
  int element = 0;         ///< its rolling element, from 1; 0: another body, or see the name
};

/// Vertical axis and colors of a panel whose curves are the rows of a map: each curve is one row at
/// its place on the axis, each value a color. Values of a map have no gaps between stored places:
/// a color reaches half the distance to the neighbors.
struct ChartMapRows {
  std::string title, unit;       ///< vertical axis: "Time", "s"
  std::vector<double> at;        ///< place of each curve; increasing
  std::string value_title;       ///< of the color bar: "Amplitude"
  double low = 0.0, high = 1.0;  ///< values of the first and last color, in the unit of the panel
};

/// Limits between the neighbors of increasing places, half a distance beyond the first and last:
/// one more than places.
[[nodiscard]] std::vector<double> cell_edges(const std::vector<double>& places);

struct ChartPanel {
  std::string title;  ///< "Contact load"
  std::string unit;   ///< unit string of the result files, "" for a pure number
  std::vector<ChartCurve> curves;
  bool wraps = false;  ///< an angle in degrees: jumps by more than half a revolution are not joined
  double least_span =
      0.0;  ///< smallest range of the vertical axis; finer detail is rounding of the data
  std::string message = {};  ///< a message instead of curves without values
  bool log = false;          ///< logarithmic axis; values of 0 and less cannot be drawn
  int group = -1;            ///< that a user-defined chart gave to its curves
  std::optional<ChartMapRows> rows = {};  ///< the curves are rows of a map
};

struct ChartMark {
  double x = 0.0;
  std::string label;
  /// For a moving mark: abscissa and height in the first panel of the page, from the bottom up; it
  /// is vertical below the first point and above the last, which is `x`. Empty: vertical at x.
  std::vector<std::pair<double, double>> way = {};
};

/// A remark at a point of a page with equal axes.
struct ChartLabel {
  double x = 0.0, y = 0.0;
  double towards_x = 0.0, towards_y = 0.0;  ///< direction of the text from there: -1, 0 or 1
  std::string text;
};

struct StudyChart;

struct ChartPage {
  /// A picture of a study instead of everything else (study_chart.hpp).
  std::shared_ptr<const StudyChart> study = nullptr;
  std::string title, subtitle;
  std::string note;            ///< a sentence below the title, or, without panels, instead of them
  std::string band_note = {};  ///< note on min-max bands: shown if a band is visible
  std::string x_title, x_unit;
  std::vector<double> x;
  std::vector<ChartPanel> panels;
  std::vector<ChartMark> marks;  ///< dashed vertical lines with a label
  bool equal_axes = false;       ///< an orbit: same scale in both directions, one panel
  bool points = false;           ///< each value is marked: no values in between
  bool closed_outline = false;   ///< an orbit page whose curves are outlines, not paths
  bool fitted = false;           ///< an orbit page as wide and high as its curves, not square
  bool schematic = false;        ///< an orbit page without axes, because positions have no meaning
  std::vector<ChartLabel> labels;  ///< of a page with equal axes
  double guide_radius = 0.0;       ///< circle about the origin of an orbit; 0 = none
  /// For an orbit: abscissa of its points on other pages; increasing. Empty: unknown.
  std::vector<double> along = {};
  std::string along_title = {}, along_unit = {};
  double view_low = 0.0, view_high = 0.0;  ///< first view of the abscissa; equal = everything
  bool log_x = false;                      ///< logarithmic abscissa
  /// Alternative curves of this page, including its own; empty: no choice.
  std::vector<std::string> choices = {};
  std::size_t chosen = 0;
  std::string about = {};  ///< the body, for tables without a subtitle
};

/// Extremes, mean and root mean square of the values of a curve between two points of its abscissa,
/// both included. Means are integrals by the trapezoidal rule; for one value they are that value.
struct CurveStatistics {
  std::size_t count = 0;           ///< of values
  double first = 0.0, last = 0.0;  ///< position of the first and the last of them
  double lowest = 0.0, highest = 0.0, mean = 0.0, rms = 0.0;
};
[[nodiscard]] CurveStatistics statistics_between(const std::vector<double>& x,
                                                 const std::vector<double>& y, double from,
                                                 double to);

/// Index of the value with the nearest abscissa; 0 for an empty vector. `x` increases.
[[nodiscard]] std::size_t nearest_index(const std::vector<double>& x, double where);

/// The pieces of a curve that are drawn as connected lines inside [low, high] of the abscissa:
/// broken at NaN and at wraps, thinned to the extremes of each of `columns` columns, so that the
/// picture is the same but quick.
struct Polyline {
  std::vector<double> x, y;
};
/// With the `blocks` of a long curve over a rising x only as many values are looked at as matter.
struct CurveBlocks;
std::vector<Polyline> drawable_polylines(const std::vector<double>& x, const std::vector<double>& y,
                                         double low, double high, int columns, bool wraps,
                                         const CurveBlocks* blocks = nullptr);

/// Indices of the minimum and maximum of each block of kLength values of a long curve, and these
/// values: computed once, so that panning over a million values is fast and keeps all peaks.
struct CurveBlocks {
  static constexpr std::size_t kLength = 32, kSpan = 32 * kLength;
  struct Block {
    std::size_t lowest = 0, highest = 0;
    double low = 0.0, high = 0.0;
    bool whole = false;   ///< no gap in it
    bool smooth = false;  ///< nor a wrap, nor one to the value before
    int begun = 0;        ///< pieces between gaps and wraps that begin in it
  };
  std::vector<Block> blocks;  ///< of complete blocks; later values have none
  std::vector<Extent> spans;  ///< of each block of kSpan values, without missing ones
};
[[nodiscard]] CurveBlocks blocks_of(const std::vector<double>& y, bool wraps);

/// Range of the values from index `from` to before `to`, without missing ones.
[[nodiscard]] Extent extent_between(const std::vector<double>& y, std::size_t from, std::size_t to,
                                    const CurveBlocks& blocks);

/// Pieces of a curve from index `first` to before `last` between its gaps and, if it `wraps`, its
/// wraps; complete blocks are not examined.
[[nodiscard]] std::size_t count_pieces_between(const std::vector<double>& y, std::size_t first,
                                               std::size_t last, bool wraps,
                                               const CurveBlocks& blocks);

/// Indices of the values with low <= x <= high, [first, second). `x` increases.
[[nodiscard]] std::pair<std::size_t, std::size_t> indices_between(const std::vector<double>& x,
                                                                  double low, double high);

}  // namespace adore::desktop
