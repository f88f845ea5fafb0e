#pragma once

#include "desktop/chart_scene.hpp"

#include <QGraphicsView>

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

class QMimeData;
class QRubberBand;

namespace adore::desktop {

/// Commands of a chart without a mouse. "Reading" shows the values of one stored point, as the
/// pointer does.
enum class ChartAction : unsigned char {
  ZoomIn,
  ZoomOut,
  MoveLeft,
  MoveRight,
  MoveUp,
  MoveDown,
  FarLeft,  ///< by as much as is seen
  FarRight,
  EnlargeValues,  ///< of the panel that the keys are of
  ReduceValues,
  PanelAbove,
  PanelBelow,
  ReadBack,  ///< one stored place
  ReadOn,
  ReadFarBack,  ///< a twentieth of the visible range
  ReadFarOn,
  CursorA,  ///< at the current point, or removed from there
  CursorB,
  ZoomToCursors,
};
inline constexpr int kChartDeeds = static_cast<int>(ChartAction::ZoomToCursors) + 1;

/// A ChartScene in a window.
/// - The wheel zooms the abscissa, with Ctrl the axis of a panel; dragging moves; Shift+drag zooms
/// to a box. For a page with equal axes all three keep the scales equal. A double click shows
/// everything; zoomBack() restores earlier views, also after other pages: then only the common
/// abscissa.
/// - The keys have the same commands as the mouse (chart_view_keys.cpp).
/// - A click on a name in a legend hides or shows its curve.
/// - A curve is dragged by its name in a legend, all curves of a panel by its title; with
/// enableDrops() the chart reports what is dropped on it.
/// - Ctrl+click sets cursor A, Ctrl+Shift+click cursor B: statistics between them are shown.
class ChartView : public QGraphicsView {
  Q_OBJECT
 public:
  explicit ChartView(QWidget* parent = nullptr);
  [[nodiscard]] ChartScene& chartScene() { return *scene_; }
  /// Keeps zoom and cursors if the new page has the same abscissa. A page that was shown before or
  /// is reloaded gets its axis ranges back, and its curves stay hidden.
  void showPage(ChartPage page);

  /// Abscissa of cursor 0 (A) or 1 (B); NaN removes it.
  void setCursorAbscissa(int which, double abscissa);
  [[nodiscard]] double cursorAbscissa(int which) const {
    return cursors_.at(static_cast<std::size_t>(which));
  }
  /// Values at the cursors and statistics between them, a line per curve; empty without cursors.
  [[nodiscard]] QString cursorReport() const;

  void perform(ChartAction chart_action);
  /// Reason why a command would change nothing now; empty: it has an effect.
  [[nodiscard]] QString disabledReason(ChartAction chart_action) const;
  /// Curves that have names in a legend, from the first panel's first one on.
  [[nodiscard]] std::vector<LegendEntry> legendCurves() const;
  /// Type of a curve of this chart while it is dragged: "panel curve", curve -1 for all.
  static constexpr const char* kCurveMime = "application/x-adore-curve";
  /// Accepts drops of these types, and lets curves be dragged.
  void enableDrops(const QStringList& types);
  /// Panel whose title or numbers are at a scene position.
  [[nodiscard]] std::optional<std::size_t> panelTitleAt(QPointF position) const;
  [[nodiscard]] std::optional<LegendEntry> legendAt(QPointF position) const;
  /// Hides a curve, or shows it again.
  void toggleCurve(std::size_t panel, std::size_t curve);

 public slots:
  void zoomBack();
  void zoomForward();
  void zoomAll();
  void clearCursors();

 signals:
  void readoutChanged(const QStringList& parts);
  void cursorsChanged();
  /// The visible range or the current point may have changed.
  void viewChanged();
  /// A panel was clicked, not dragged.
  void panelClicked(std::size_t panel);
  /// A curve was shown or hidden by its name.
  void curvesChanged();
  /// Dropped on a panel; none: between or beside them.
  void dropped(const QMimeData* data, std::optional<std::size_t> panel);
  /// A point, cell or line in a picture of a study was clicked.
  void runsChosen(const std::vector<long>& runs);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void leaveEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  using Ranges = std::vector<std::optional<std::pair<double, double>>>;  ///< of the panels
  /// A view: part of the abscissa, and the ranges chosen on all pages.
  struct View {
    std::string abscissa;
    double low = 0.0, high = 0.0;
    std::map<std::string, Ranges> ranges;
    bool operator==(const View&) const = default;
  };
  [[nodiscard]] View now() const;
  /// Shows as much of a view as the present page has.
  void apply(const View& view);
  void travel(std::vector<View>& from, std::vector<View>& to);
  void remember();
  void zoomBox(const QRectF& box);
  void read();
  void readPointer();
  [[nodiscard]] QString planeReport() const;
  [[nodiscard]] QString mapReport(const ChartPanel& panel) const;
  /// Point of an orbit at a cursor; none without a cursor or outside the visible range.
  [[nodiscard]] std::optional<QPointF> planeCursor(std::size_t which) const;
  void startDrag(std::size_t panel, std::optional<std::size_t> curve);
  [[nodiscard]] bool acceptsDrop(const QMimeData* data) const;
  void showDropTarget(std::optional<QPoint> at);
  void drawDropTarget(QPainter& painter) const;
  // For the keys:
  // A stored point of the abscissa, or of a curve of an orbit.
  struct StoredPoint {
    std::size_t curve = 0, index = 0;
  };
  [[nodiscard]] QString chartDisabledReason() const;
  [[nodiscard]] QString zoomDisabledReason(ChartAction chart_action) const;
  [[nodiscard]] QString moveDisabledReason(ChartAction chart_action) const;
  [[nodiscard]] QString valueZoomDisabledReason(ChartAction chart_action) const;
  [[nodiscard]] QString readDisabledReason(ChartAction chart_action) const;
  /// The part of the picture that would be seen then, in scene coordinates of now.
  [[nodiscard]] QRectF visiblePartAfter(ChartAction chart_action) const;
  [[nodiscard]] QRectF limitToContent(const QRectF& part) const;
  void setVisiblePart(const QRectF& part);
  /// Range of the values of the panel that the keys are of, over the whole page.
  [[nodiscard]] const Extent& panelValueRange() const;
  [[nodiscard]] std::pair<double, double> valueRangeAfter(ChartAction chart_action) const;
  /// Current point, by key or pointer, else the middle of the visible range; none without points.
  [[nodiscard]] std::optional<StoredPoint> currentStoredPoint() const;
  [[nodiscard]] std::optional<StoredPoint> storedPointAfter(ChartAction chart_action) const;
  [[nodiscard]] std::optional<StoredPoint> nextStoredPoint(StoredPoint at, long by) const;
  [[nodiscard]] std::size_t placesOf(std::size_t curve) const;
  [[nodiscard]] bool hasStoredPoint(const StoredPoint& place) const;
  [[nodiscard]] bool isPointVisible(const StoredPoint& place) const;
  void follow(const StoredPoint& place);
  void endReading();
  [[nodiscard]] QPointF scenePosition(const StoredPoint& place) const;
  /// Abscissa of a point, for an orbit its time; NaN: unknown.
  [[nodiscard]] double abscissaOf(const StoredPoint& place) const;
  void readStoredPoint(const StoredPoint& place);
  void choosePanel(std::size_t panel);
  void drawFocus(QPainter& painter) const;

  ChartScene* scene_;
  QRubberBand* band_;
  bool dragging_ = false, zoom_box_active_ = false;
  QPoint zoom_box_start_;
  QPoint press_position_;                            ///< where a drag began
  std::optional<LegendEntry> pressed_legend_entry_;  ///< in a legend, until the button is released
  std::optional<std::size_t> pressed_title_panel_;
  QStringList drop_types_;
  std::optional<std::size_t> drop_panel_;  ///< panel below a drag
  double drag_start_x_ = 0.0;
  QPointF last_;                                ///< of a drag over a page with equal axes
  std::optional<QPoint> pointer_position_;      ///< of the viewport; none: not on this page
  double pointer_line_x_ = -1.0;                ///< scene x of the pointer line; negative = none
  std::optional<QPointF> hovered_plane_point_;  ///< stored point of an orbit near the pointer
  std::optional<StoredPoint> reading_;          ///< by key; none: point under the pointer
  std::size_t panel_ = 0;                       ///< that the keys are of
  mutable std::vector<std::optional<Extent>>
      panel_value_ranges_;        ///< by panel, if chosen by the user
  bool key_move_active_ = false;  ///< by keys, successively: one entry of the zoom history
  std::array<double, 2> cursors_{std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::quiet_NaN()};
  std::vector<View> back_views_, forward_views_;
  // By page:
  std::map<std::string, Ranges> ranges_;
  std::map<std::string, std::set<std::pair<std::size_t, std::size_t>>>
      hidden_curves_;  ///< panel, curve
};

}  // namespace adore::desktop
