#pragma once

#include "drawing/outline.hpp"

#include <QRectF>
#include <QTransform>
#include <QWidget>

#include <string>
#include <vector>

class QPainter;

namespace adore::adrinput {

/// Part in focus: drawn in the accent color, with its dimension.
struct DrawingFocus {
  std::string record, variable;
  int instance = 1, index = 1;
  bool operator==(const DrawingFocus&) const = default;
};

/// Paints a drawing: figures one below the other, fitted to the widget, with the measures of the
/// record in focus. The wheel zooms about the pointer, dragging moves, a double click shows all
/// again.
class DrawingView : public QWidget {
  Q_OBJECT
 public:
  explicit DrawingView(QWidget* parent = nullptr);

  /// `stale`: reason why the drawing is older than the deck; it is shown pale with the reason.
  void setDrawing(drawing::Drawing drawing, const QString& stale = {});
  void setFocusOn(DrawingFocus focus);
  /// "raceTemp1 = 293.15 K": written on the body that the field speaks of when it has no measure.
  void setFocusLabel(const QString& label);
  [[nodiscard]] const drawing::Drawing& drawing() const { return drawing_; }
  [[nodiscard]] const DrawingFocus& currentFocus() const { return focus_; }

  /// Texts of the last painting, with their areas; labels do not overlap.
  struct Label {
    QRectF box;
    QString text;
    bool strong = false;  ///< of the field in focus
  };
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }
  /// The measure at a position of the widget, or nullptr.
  [[nodiscard]] const drawing::Dimension* dimensionAt(QPointF position) const;

  [[nodiscard]] QSize sizeHint() const override;

 signals:
  void dimensionClicked(const QString& variable, int instance, int index);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  struct PaneLayout {
    QRectF area;       ///< of the figure on the widget, title excluded
    QTransform place;  ///< from meters to pixels
  };
  struct Zoom {
    double scale = 1.0;
    QPointF shift;
  };
  void layOut();
  [[nodiscard]] QTransform fitTransform(const drawing::Pane& pane, const QRectF& area) const;
  void paintPane(QPainter& painter, const drawing::Pane& pane, const PaneLayout& frame);
  void paintAxes(QPainter& painter, const drawing::Pane& pane, const PaneLayout& frame);
  void paintShape(QPainter& painter, const drawing::Shape& shape, const QTransform& place);
  void paintArrow(QPainter& painter, const drawing::Arrow& arrow, const QTransform& place);
  void paintDimension(QPainter& painter, const drawing::Dimension& dimension,
                      const QTransform& place);
  void writeLabels(QPainter& painter, const drawing::Pane& pane, const PaneLayout& frame);
  [[nodiscard]] bool isDimensionVisible(const drawing::Dimension& dimension) const;
  /// Writes near a point where there is no text yet; false if there is no space.
  /// `free`: distance of the label from the point, [px].
  bool writeAlongDimension(QPainter& painter, const QRectF& area,
                           const drawing::Dimension& dimension, const QTransform& place,
                           const QString& text);
  bool writeLabel(QPainter& painter, const QRectF& area, QPointF near, const QString& text,
                  bool strong, const QColor& colour, double free = 0.0);
  [[nodiscard]] bool inFocus(const drawing::Shape& shape) const;
  [[nodiscard]] bool inFocus(const drawing::Dimension& dimension) const;
  [[nodiscard]] bool inFocus(const drawing::Arrow& arrow) const;
  [[nodiscard]] bool isInFocusedRecord(const std::string& variable) const;
  [[nodiscard]] int paneAt(QPointF position) const;

  drawing::Drawing drawing_;
  QString stale_;
  DrawingFocus focus_;
  QString focus_label_;
  std::vector<drawing::Part> focused_parts_;  ///< that the variable in focus speaks of
  bool focus_has_dimension_ = false;          ///< the variable in focus has a measure or arrow here
  std::vector<PaneLayout> pane_layouts_;
  std::vector<Zoom> zooms_;
  std::vector<Label> labels_;
  QPointF press_position_, last_drag_position_;
  bool dragging_ = false;
};

}  // namespace adore::adrinput
