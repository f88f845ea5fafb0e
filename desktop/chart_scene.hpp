#pragma once

#include "desktop/axis_scale.hpp"
#include "desktop/chart_page.hpp"
#include "desktop/theme.hpp"

#include <QGraphicsScene>

#include <vector>

class QChart;
class QImage;

/// Draws a ChartPage with Qt Charts: the same scene is shown by AdrPlot's window, by AGORE's data
/// area and by every headless picture.
namespace adore::desktop {

/// Sizes of a page in pixels: the full page of AdrPlot, or the small one beside AGORE's picture.
enum class ChartStyle : unsigned char { Page, Compact };

class ChartScene : public QGraphicsScene {
  Q_OBJECT
 public:
  explicit ChartScene(ChartStyle style = ChartStyle::Page, QObject* parent = nullptr);

  void setPage(ChartPage page);
  [[nodiscard]] const ChartPage& page() const { return page_; }
  void setTheme(const Theme& theme);
  void setPageSize(QSizeF size);

  /// Visible part of the abscissa, in the page's units; limited to the data. Vertical axes follow.
  void setView(double low, double high);
  void resetView();
  [[nodiscard]] double viewLow() const { return low_; }
  [[nodiscard]] double viewHigh() const { return high_; }

  /// Drawing area of each panel in scene coordinates, from top to bottom.
  [[nodiscard]] const std::vector<QRectF>& plotAreas() const { return areas_; }
  [[nodiscard]] const std::vector<QChart*>& charts() const { return charts_; }
  /// Abscissa value at a scene position, and back.
  [[nodiscard]] double abscissaAt(double scene_x) const;
  [[nodiscard]] double positionOf(double abscissa) const;
  /// "12.3 rev: outer 412 N, inner 398 N" for a scene position, empty outside the panels.
  [[nodiscard]] QString readout(QPointF scene_position) const;

  void paintPage(QPainter& painter, const QRectF& target);
  [[nodiscard]] QImage image(QSize size);

 private:
  struct Metrics;
  [[nodiscard]] Metrics metrics() const;
  void rebuild();
  void addHeading(const Metrics& m);
  void addPanel(std::size_t index, const QRectF& area, bool bottom, const Metrics& m);
  void addOrbit(const QRectF& space, const Metrics& m);
  void addRemark(const ChartLabel& label, QPointF at, const Metrics& m);
  void addLegend(const ChartPanel& panel, const QRectF& area, const Metrics& m);
  void addMarks(const QRectF& area, bool label, const Metrics& m);
  void addMessage(const QRectF& area, const QString& text, const Metrics& m);
  QChart* addChart(const QRectF& area, const AxisScale& x_axis, const AxisScale& y_axis,
                   const QString& x_title, const QString& y_title, bool x_labels, const Metrics& m);
  void addLabels(const QRectF& area, const AxisScale& x_scale, const AxisScale& y_scale,
                 const QString& x_title, const QString& y_title, bool x_labels, const Metrics& m);
  void addSeries(QChart* chart, const Polyline& line, const AxisScale& x_axis,
                 const AxisScale& y_axis, const QString& name, int colour, qreal width,
                 bool dashed = false);
  void addPoints(const Polyline& line, const QRectF& area, const AxisScale& x_axis,
                 const AxisScale& y_axis, int colour, qreal width);

  ChartStyle style_;
  const Theme* theme_;
  ChartPage page_;
  QSizeF size_{1280, 800};
  double low_ = 0.0, high_ = 1.0;
  AxisScale x_axis_;
  std::vector<QRectF> areas_;
  std::vector<QChart*> charts_;
};

}  // namespace adore::desktop
