#pragma once

#include "desktop/axis_scale.hpp"
#include "desktop/chart_page.hpp"
#include "desktop/theme.hpp"
#include "desktop/way_tiles.hpp"

#include <QGraphicsScene>
#include <QPolygonF>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

class QImage;

/// Draws a ChartPage: the same scene is shown by AdrPlot's window, by AGORE's data
/// area and by every headless picture.
namespace adore::desktop {

/// Sizes of a page in pixels: the full page of AdrPlot, or the small one in AGORE.
enum class ChartStyle : unsigned char { Page, Compact };

/// Visible part of a page: a range of the abscissa, and ranges of the panel axes that the user has
/// chosen. For a page with equal axes: its own axis and then the other one, or neither.
struct ChartZoom {
  double low = 0.0, high = 1.0;
  std::vector<std::optional<std::pair<double, double>>> panels;  ///< missing: follows the curves
  bool operator==(const ChartZoom&) const = default;
};

/// A curve's name in the picture, to be clicked.
struct LegendEntry {
  QRectF place;
  std::size_t panel = 0, curve = 0;
};

class ChartScene : public QGraphicsScene {
  Q_OBJECT
 public:
  struct ShownCurve;
  explicit ChartScene(ChartStyle style = ChartStyle::Page, QObject* parent = nullptr);

  /// Shows all of the page; with `keep_view` the part of the abscissa that is shown now, if the new
  /// page has the same abscissa.
  void setPage(ChartPage page, bool keep_view = false);
  [[nodiscard]] const ChartPage& page() const { return page_; }
  void setTheme(const Theme& theme);
  void setPageSize(QSizeF size);
  /// Can the user point at the scene? Then texts that do not fit are shown in a tooltip; a saved
  /// picture has to show everything, in small letters if necessary.
  void setInteractive(bool interactive);
  [[nodiscard]] bool interactive() const { return interactive_; }
  /// Height below which the panels of the page are not readable, with two lines of a note.
  [[nodiscard]] qreal minReadableHeight() const;

  /// Visible part of the abscissa, in the page's units; limited to the data. Vertical axes follow.
  void setView(double low, double high);
  /// All of the abscissa and of each panel, beyond the part that the page begins with.
  void showAll();
  [[nodiscard]] bool whole() const;
  void resetView();
  [[nodiscard]] ChartZoom zoom() const { return {low_, high_, panel_views_}; }
  /// Ranges of panels that this page does not have are dropped.
  void setZoom(const ChartZoom& zoom);
  /// Range of the axis of one panel, in its unit; none: it follows its curves again.
  void setPanelView(std::size_t panel, std::optional<std::pair<double, double>> range);
  /// Visible part of a page with equal axes, in current scene coordinates: the picture keeps its
  /// aspect ratio and shows all of `part`, at most everything and at least a ten-thousandth.
  void setPlaneView(const QRectF& part);
  /// Is this a page with equal axes that can be zoomed?
  [[nodiscard]] bool isPlane() const;
  /// Complete content, in current scene coordinates: wider than a panel that shows a part of the
  /// abscissa, for a page with equal axes also higher.
  [[nodiscard]] QRectF everything() const;
  /// The least part of everything that is shown.
  static constexpr double kLeastPart = 1e-4;
  /// Does the view differ from the one that resetView() makes?
  [[nodiscard]] bool zoomed() const;
  void showCurve(std::size_t panel, std::size_t curve, bool shown);
  [[nodiscard]] const std::vector<LegendEntry>& legend() const { return legend_; }
  [[nodiscard]] double viewLow() const { return low_; }
  [[nodiscard]] double viewHigh() const { return high_; }

  /// Drawing area of each panel in scene coordinates, from top to bottom.
  [[nodiscard]] const std::vector<QRectF>& plotAreas() const { return plot_areas_; }
  /// Connected lines that are drawn in a panel.
  [[nodiscard]] int lineCount(std::size_t panel) const { return lines_.at(panel); }
  /// Abscissa value at a scene position, and back.
  [[nodiscard]] double abscissaAt(double scene_x) const;
  [[nodiscard]] double sceneXAt(double abscissa) const;
  /// Value of the axis of a panel at a scene position, and the inverse.
  [[nodiscard]] double valueAt(std::size_t panel, double scene_y) const;
  [[nodiscard]] double sceneYAt(std::size_t panel, double value) const;
  /// Panel at a scene position; none between them.
  [[nodiscard]] std::optional<std::size_t> panelAt(QPointF scene_position) const;
  /// "12.3 rev: outer 412 N, inner 398 N" for a scene position, empty outside the panels.
  [[nodiscard]] QString readout(QPointF scene_position) const;
  /// The same, each value as a part with its label.
  [[nodiscard]] QStringList readoutParts(QPointF scene_position) const;
  /// Row of a map that contains a scene position; none outside or without a map.
  [[nodiscard]] std::optional<std::size_t> mapRowAt(QPointF scene_position) const;
  /// The same for a stored point: of the abscissa (and a row of a map), or of a curve of an orbit.
  [[nodiscard]] QStringList storedPointReadout(std::size_t curve, std::size_t index) const;
  /// Number of digits that resolve the variation of a curve and the resolution of its panel: 30.005
  /// mm does not show a motion of 1 µm.
  [[nodiscard]] int digitsOf(std::size_t panel, std::size_t curve) const;
  /// The stored point of an orbit that is drawn nearest to a position, and its position; none
  /// farther away than `reach` pixels.
  struct PlanePoint {
    std::size_t curve = 0, index = 0;
    QPointF at;
  };
  [[nodiscard]] std::optional<PlanePoint> nearestPlanePoint(QPointF scene_position,
                                                            qreal reach) const;
  /// Position of a point of an orbit; none outside the visible range.
  [[nodiscard]] std::optional<QPointF> planePosition(double across, double up) const;

  /// Numbers of the runs behind a position in a picture of a study; empty: none.
  [[nodiscard]] std::vector<long> runsAt(QPointF scene_position) const;

  /// Are min-max bands visible, so that the note on them is shown?
  [[nodiscard]] bool showsBandNote() const {
    return band_note_visible_ && !page_.band_note.empty();
  }

  void paintPage(QPainter& painter, const QRectF& target);
  [[nodiscard]] QImage image(QSize size);

 private:
  struct Metrics;
  /// Curves of which only one would be visible: their lines cover each other, their values differ
  /// by less than a line width, or are equal.
  enum class Alike : unsigned char { Covers, Near, Equal };
  [[nodiscard]] Metrics metrics() const;
  /// The page's note as lines of the page's width.
  struct NoteLines {
    QStringList lines;
    int font = 13;
    bool more = false;  ///< not all of it fits
  };
  /// The notes of the page: text, min-max bands, and values that logarithmic axes cannot show.
  [[nodiscard]] std::string noteText() const;
  [[nodiscard]] const NoteLines& noteLines(qreal right) const;
  [[nodiscard]] NoteLines findNoteLines(qreal right) const;
  [[nodiscard]] qreal noteHeight(qreal right) const;
  /// Draws the page; adds the note on min-max bands if a band is visible.
  void rebuild();
  void build();
  void addHeading(const Metrics& m);
  /// Range of the values in the view, not finer than a bearing's numbers are.
  [[nodiscard]] AxisScale findAxis(std::size_t index, const QRectF& area, bool& any) const;
  /// The same, once for a picture; panels are of one size.
  [[nodiscard]] AxisScale panelAxis(std::size_t index, const QRectF& area, bool& any);
  /// Draws the curves of a panel and finds curves that would hide others.
  [[nodiscard]] std::vector<ShownCurve> prepareShownCurves(std::size_t index, const QRectF& area,
                                                           const AxisScale& y_axis,
                                                           const Metrics& m);
  /// Legend text for a curve of a panel that would hide the curve `a` in the view; lines closer
  /// than `same` pixels are considered equal.
  void classifyOverlap(std::size_t index, std::size_t a, ShownCurve& shown, const QRectF& area,
                       const AxisScale& y_axis, qreal same);
  /// Ranges of the view in which the later of two curves is on the earlier one; false if there are
  /// none.
  bool findOverlapRanges(std::size_t index, ShownCurve& before, ShownCurve& shown,
                         const QRectF& area, const AxisScale& y_axis, qreal same) const;
  /// Draws a curve. If it would hide others, stripes are left to them: it keeps one of `later` + 1.
  void addShownCurve(const ShownCurve& shown, const ChartPanel& panel, const QRectF& area,
                     const AxisScale& y_axis, const Metrics& m);
  void addPanel(std::size_t index, const QRectF& area, bool bottom, const Metrics& m);
  void addMapPanel(std::size_t index, const QRectF& area, const AxisScale& y_axis, bool any,
                   bool bottom, const Metrics& m);
  /// The rows of a map as colors, and their color bar.
  void addMapRows(const ChartPanel& panel, const QRectF& area, const AxisScale& y_axis,
                  const Metrics& m);
  /// Width of the color bar of a map next to its panel, with its numbers and title; 0: no map.
  [[nodiscard]] qreal colorBarWidth(const Metrics& m) const;
  /// Appends the outlines that it has drawn.
  void addBand(std::size_t panel, std::size_t curve, const QRectF& area, const AxisScale& y_axis,
               int colour, std::vector<QPolygonF>& drawn);
  /// Is one of these bands visible next to the lines of a panel?
  [[nodiscard]] static bool areBandsVisible(const std::vector<QPolygonF>& bands,
                                            const std::vector<ShownCurve>& shown,
                                            const QRectF& area, qreal line);
  /// Reference value of the numbers of the axis: next to the legend, shorter if there is little
  /// space, else in the corner of the panel that hides the least.
  void addAxisOffset(const AxisScale& y_axis, const QRectF& area, qreal head, qreal legend,
                     const std::vector<QPolygonF>& drawn, const Metrics& m);
  /// A page with equal axes: its frame, and its content.
  struct EqualAxesLayout {
    QRectF area;
    double middle_x = 0.0, middle_y = 0.0, half_x = 1.0, half_y = 1.0;
    double enlarged = 1.0;  ///< fraction of the visible range
  };
  [[nodiscard]] QRectF space(const Metrics& m) const;
  /// Iterates over a page with equal axes.
  void precomputePlaneCurves();
  [[nodiscard]] EqualAxesLayout fullPlaneLayout(const Metrics& m) const;
  /// The selected part of it.
  [[nodiscard]] EqualAxesLayout visiblePlaneLayout(const EqualAxesLayout& whole) const;
  [[nodiscard]] EqualAxesLayout selectedPlaneLayout(const EqualAxesLayout& whole) const;
  void addOrbit(const Metrics& m);
  void computeCurveDigits();
  [[nodiscard]] QStringList planeReadout(QPointF position) const;
  /// "Y 1 µm, Z 2 µm".
  [[nodiscard]] QString planeValuesText(double across, double up) const;
  /// " (0.1 N to 2 N)": extremes since the previous value; empty if missing or equal.
  [[nodiscard]] QString bandText(std::size_t panel, std::size_t curve, std::size_t place) const;
  void addPlaneLabel(const ChartLabel& label, QPointF at, const QRectF& area, const Metrics& m);
  /// Returns its left end. A legend over the labels of the axis is above `labels_top`.
  qreal addLegend(const ChartPanel& panel, const std::vector<ShownCurve>& shown, const QRectF& area,
                  qreal labels_top, const Metrics& m);
  /// Upper end of the labels of a panel axis.
  [[nodiscard]] qreal labelsTop(const QRectF& area, const AxisScale& y_axis,
                                const Metrics& m) const;
  /// Names are above the panel, as close to their lines as possible; a step connects a name with a
  /// line that is not below it.
  void addMarks(const QRectF& area, const AxisScale& y_axis, bool names, bool lines,
                const Metrics& m);
  [[nodiscard]] bool arePanelsUnzoomed() const;
  [[nodiscard]] std::pair<double, double> fullRange() const;
  /// Heading of the page.
  [[nodiscard]] std::pair<double, double> initialRange() const;
  void addMessage(const QRectF& area, const QString& text, const Metrics& m);
  void addFrame(const QRectF& area, const AxisScale& x_axis, const AxisScale& y_axis,
                const QString& x_title, const QString& y_title, bool x_labels, bool y_labels,
                const Metrics& m);
  void addLabels(const QRectF& area, const AxisScale& x_scale, const AxisScale& y_scale,
                 const QString& x_title, const QString& y_title,
                 const std::vector<AxisTick>& x_ticks, const std::vector<AxisTick>& y_ticks,
                 const Metrics& m);
  /// A line inside `area`. Returns it in the scene.
  QPolygonF addCurve(const Polyline& line, const QRectF& area, const AxisScale& x_axis,
                     const AxisScale& y_axis, QPen pen);
  /// All parts of a line as one item.
  void addPolylineItem(std::vector<QPolygonF> parts, const QRectF& area, QPen pen);
  /// A curve of very many points of a page with equal axes.
  void addLongPath(std::size_t curve, const PathPlacement& place, QPen pen);
  [[nodiscard]] QPen penOf(int colour, qreal width, bool dashed = false) const;
  void precomputeCurves();
  void addPoints(const Polyline& line, const QRectF& area, const AxisScale& x_axis,
                 const AxisScale& y_axis, int colour, qreal width);

  ChartStyle style_;
  const Theme* theme_;
  ChartPage page_;
  QSizeF size_{1280, 800};
  bool interactive_ = false;
  double low_ = 0.0, high_ = 1.0;
  AxisScale x_axis_;
  std::vector<AxisScale> y_axes_;
  std::vector<std::optional<std::pair<double, double>>> panel_views_;
  /// Of each panel, and whether it has values: found once for a picture, for panels of one unit ask
  /// for each other's.
  std::vector<std::optional<std::pair<AxisScale, bool>>> axis_cache_;
  std::vector<LegendEntry> legend_;
  std::vector<QRectF> plot_areas_;
  std::vector<int> lines_;
  /// Last result, with its note, width, height, right margin and use.
  using NoteKey = std::tuple<std::string, qreal, qreal, qreal, bool>;
  mutable std::optional<std::pair<NoteKey, NoteLines>> note_lines_;
  bool abscissa_increasing_ = false;  ///< the abscissa
  std::vector<double> log_abscissa_;  ///< log10 of a logarithmic abscissa
  std::string log_axis_note_;         ///< values that logarithmic axes cannot show
  bool bands_visible_ = false;        ///< some of a band, in the panels that are drawn
  bool band_note_visible_ = true;     ///< their explanation, in the note
  /// Of a long curve and of the edges of its band.
  struct LongCurveBlocks {
    CurveBlocks y, low, high;
    [[nodiscard]] const CurveBlocks& of(std::size_t which) const {
      return which == 0 ? y : which == 1 ? low : high;
    }
  };
  std::vector<std::vector<LongCurveBlocks>>
      curve_blocks_;                      ///< by panel and curve; none for short ones
  std::vector<std::vector<int>> digits_;  ///< by panel and curve
  /// Of a page with equal axes.
  struct PlaneCurve {
    Extent across, up;
    PathIndex runs;
    PathTiles tiles;
  };
  std::vector<PlaneCurve> plane_curves_;
  /// Are two curves of a panel equal over the whole run? Cached for compared pairs.
  std::map<std::array<std::size_t, 3>, bool> equal_curves_cache_;
};

}  // namespace adore::desktop
