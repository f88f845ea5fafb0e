#include "desktop/chart_scene.hpp"

#include "desktop/chart_scene_parts.hpp"

#include <QChart>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QGraphicsLineItem>
#include <QGraphicsTextItem>
#include <QImage>
#include <QLineSeries>
#include <QPainter>
#include <QTextDocument>
#include <QValueAxis>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::desktop {

ChartScene::Metrics ChartScene::metrics() const {
  if (style_ == ChartStyle::Compact) return {74, 14, 46, 46, 26, 17, 13, 11, 10, 1.4, 1.0};
  const qreal note = page_.note.empty() || page_.panels.empty() ? 0 : 20;
  return {86, 28, 66 + note, 54, 34, 22, 18, 13, 12, 1.6, 1.2};
}

ChartScene::ChartScene(ChartStyle style, QObject* parent)
    : QGraphicsScene(parent), style_(style), theme_(&current_theme()) {}

void ChartScene::setPage(ChartPage page) {
  page_ = std::move(page);
  resetView();
}

void ChartScene::setTheme(const Theme& theme) {
  theme_ = &theme;
  rebuild();
}

void ChartScene::setPageSize(QSizeF size) {
  const QSizeF wanted = size.expandedTo({160, 120});
  if (wanted == size_ && !items().isEmpty()) return;
  size_ = wanted;
  rebuild();
}

void ChartScene::resetView() {
  Extent extent;
  for (const double x : page_.x) extent.include(x);
  if (page_.view_high > page_.view_low) {
    low_ = page_.view_low;
    high_ = page_.view_high;
  } else {
    low_ = extent.empty() ? 0.0 : extent.low;
    high_ = extent.empty() ? 1.0 : extent.high;
  }
  rebuild();
}

void ChartScene::setView(double low, double high) {
  Extent extent;
  for (const double x : page_.x) extent.include(x);
  if (extent.empty() || page_.equal_axes) return;
  const double smallest = (extent.high - extent.low) * 1e-4;
  low = std::clamp(low, extent.low, extent.high);
  high = std::clamp(high, extent.low, extent.high);
  if (high - low < smallest) return;
  low_ = low;
  high_ = high;
  rebuild();
}

double ChartScene::abscissaAt(double scene_x) const {
  if (areas_.empty()) return low_;
  const QRectF& area = areas_.front();
  const double shown =
      x_axis_.min + (scene_x - area.left()) / area.width() * (x_axis_.max - x_axis_.min);
  return shown * x_axis_.factor + x_axis_.offset;
}

double ChartScene::positionOf(double abscissa) const {
  if (areas_.empty()) return 0.0;
  const QRectF& area = areas_.front();
  return area.left() +
         (x_axis_.shown(abscissa) - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
}

QString ChartScene::readout(QPointF position) const {
  if (page_.equal_axes || page_.x.empty()) return {};
  for (std::size_t p = 0; p < areas_.size(); ++p) {
    if (!areas_[p].contains(position)) continue;
    const double x = abscissaAt(position.x());
    const auto after = std::lower_bound(page_.x.begin(), page_.x.end(), x);
    auto i = static_cast<std::size_t>(
        std::min<std::ptrdiff_t>(after - page_.x.begin(), std::ssize(page_.x) - 1));
    if (i > 0 && std::abs(page_.x[i - 1] - x) < std::abs(page_.x[i] - x)) --i;
    QString text = text_of(pretty_quantity(page_.x[i], page_.x_unit, 5)) + ":";
    for (const auto& curve : page_.panels[p].curves) {
      if (i >= curve.y.size()) continue;
      const QString name = text_of(curve.name.empty() ? page_.panels[p].title : curve.name);
      text += "  " + name + " " + text_of(pretty_quantity(curve.y[i], page_.panels[p].unit, 5));
    }
    return text;
  }
  return {};
}

void ChartScene::rebuild() {
  clear();
  charts_.clear();
  areas_.clear();
  setSceneRect(QRectF(QPointF(0, 0), size_));
  setBackgroundBrush(theme_->surface);
  const Metrics m = metrics();
  addHeading(m);
  const QRectF space(m.left, m.top, size_.width() - m.left - m.right,
                     size_.height() - m.top - m.bottom);
  if (page_.panels.empty()) {
    if (!page_.note.empty()) addMessage(space, text_of(page_.note), m);
    return;
  }
  if (page_.equal_axes) {
    addOrbit(space, m);
    return;
  }
  x_axis_ =
      tight_axis(low_, high_, page_.x_unit, std::max(2, static_cast<int>(space.width() / 110)));
  const auto count = static_cast<qreal>(page_.panels.size());
  const qreal height = (space.height() - m.gap * (count - 1) - m.legend) / count;
  for (std::size_t i = 0; i < page_.panels.size(); ++i) {
    const QRectF area(space.left(),
                      space.top() + m.legend + static_cast<qreal>(i) * (height + m.gap),
                      space.width(), height);
    addPanel(i, area, i + 1 == page_.panels.size(), m);
  }
}

void ChartScene::addHeading(const Metrics& m) {
  const auto line = [&](const QString& text, const QFont& font, const QColor& colour, qreal y) {
    if (text.isEmpty()) return;
    const qreal left = style_ == ChartStyle::Compact ? 12 : 24;
    auto* item = addSimpleText(
        QFontMetricsF(font).elidedText(text, Qt::ElideRight, size_.width() - left - m.right), font);
    item->setBrush(colour);
    item->setPos(left, y);
  };
  if (style_ == ChartStyle::Compact) {
    line(text_of(page_.title), ui_font(m.title_font, true), theme_->text, 8);
    return;
  }
  line(text_of(page_.title), ui_font(m.title_font, true), theme_->text, 14);
  line(text_of(page_.subtitle), ui_font(m.text_font), theme_->muted, 40);
  if (!page_.panels.empty()) line(text_of(page_.note), ui_font(m.text_font), theme_->accent, 60);
}

void ChartScene::addPanel(std::size_t index, const QRectF& area, bool bottom, const Metrics& m) {
  const ChartPanel& panel = page_.panels[index];
  Extent extent;
  for (const auto& curve : panel.curves)
    for (std::size_t i = 0; i < std::min(curve.y.size(), page_.x.size()); ++i)
      if (page_.x[i] >= low_ && page_.x[i] <= high_) extent.include(curve.y[i]);
  if (!extent.empty() && extent.high - extent.low < panel.least_span) {
    const double middle = 0.5 * (extent.low + extent.high);
    extent = {middle - 0.5 * panel.least_span, middle + 0.5 * panel.least_span};
  }
  const int parts = std::clamp(static_cast<int>(area.height() / 38), 2, 8);
  const AxisScale y_axis = value_axis(extent.low, extent.high, panel.unit, parts);
  AxisScale x_axis = x_axis_;
  const QString x_title = bottom ? with_unit(text_of(page_.x_title), x_axis) : QString();
  QChart* chart =
      addChart(area, x_axis, y_axis, x_title, with_unit(text_of(panel.title), y_axis), bottom, m);
  int colour = 0;
  for (const auto& curve : panel.curves) {
    const auto pieces =
        drawable_pieces(page_.x, curve.y, low_, high_, static_cast<int>(area.width()), panel.wraps);
    for (const auto& piece : pieces) {
      addSeries(chart, piece, x_axis, y_axis, text_of(curve.name), colour, m.line, curve.dashed);
      // A value between gaps has no line: it is a point.
      if (page_.points || piece.x.size() == 1)
        addPoints(piece, area, x_axis, y_axis, colour, m.line);
    }
    ++colour;
  }
  if (extent.empty()) addMessage(area, "no values in the file", m);
  addMarks(area, index == 0, m);
  addLegend(panel, area, m);
  areas_.push_back(area);
}

QChart* ChartScene::addChart(const QRectF& area, const AxisScale& x_scale, const AxisScale& y_scale,
                             const QString& x_title, const QString& y_title, bool x_labels,
                             const Metrics& m) {
  auto* chart = new QChart;
  chart->setBackgroundVisible(false);
  chart->setPlotAreaBackgroundVisible(false);
  chart->legend()->hide();
  chart->setMargins({0, 0, 0, 0});
  chart->setAnimationOptions(QChart::NoAnimation);
  addItem(chart);
  const QRectF frame =
      area.adjusted(-m.left + 4, -14, std::min<qreal>(m.right, 26), x_labels ? m.bottom - 4 : 14);
  chart->setGeometry(frame);
  chart->setPlotArea(area.translated(-frame.topLeft()));
  const auto style = [&](QValueAxis* axis, const AxisScale& scale, const QString& title) {
    // A hair beyond the ends, so that a tick on the end is not lost to rounding.
    const double hair = 1e-7 * (scale.max - scale.min);
    axis->setRange(scale.min - hair, scale.max + hair);
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0.0);
    axis->setTickInterval(scale.step);
    axis->setGridLinePen(QPen(theme_->grid, 1));
    axis->setLinePen(QPen(theme_->frame, 1));
    axis->setTitleText(title);
    axis->setTitleVisible(false);
    axis->setLabelsVisible(false);
  };
  auto* x = new QValueAxis;
  auto* y = new QValueAxis;
  style(x, x_scale, x_title);
  style(y, y_scale, y_title);
  chart->addAxis(x, Qt::AlignBottom);
  chart->addAxis(y, Qt::AlignLeft);
  // Axes are placed when the layout runs, which would otherwise wait for the event loop; a picture
  // is painted now.
  chart->layout()->invalidate();
  chart->layout()->activate();
  charts_.push_back(chart);
  addLabels(area, x_scale, y_scale, x_title, y_title, x_labels, m);
  return chart;
}

// Our own tick labels and titles: Qt Charts writes "-0.0", cuts long labels, and sets titles at a
// different place in each panel.
void ChartScene::addLabels(const QRectF& area, const AxisScale& x_scale, const AxisScale& y_scale,
                           const QString& x_title, const QString& y_title, bool x_labels,
                           const Metrics& m) {
  const QFont font = ui_font(m.tick_font), title_font = ui_font(m.text_font);
  const QFontMetricsF metrics(font), title_metrics(title_font);
  const auto ticks = [](const AxisScale& scale) {
    constexpr std::size_t kMostTicks = 200;
    std::vector<double> values;
    const double slack = 1e-6 * scale.step;
    for (double k = std::ceil((scale.min - slack) / scale.step);
         k * scale.step <= scale.max + slack && values.size() < kMostTicks; ++k)
      values.push_back(k * scale.step);
    return values;
  };
  const auto add = [&](const QString& text, const QFont& used, const QColor& colour,
                       QPointF position) {
    auto* item = addSimpleText(text, used);
    item->setBrush(colour);
    item->setPos(position);
    return item;
  };
  for (const double value : ticks(y_scale)) {
    const QString text = text_of(tick_text(value, y_scale.decimals));
    const qreal y =
        area.bottom() - (value - y_scale.min) / (y_scale.max - y_scale.min) * area.height();
    add(text, font, theme_->muted,
        {area.left() - 8 - metrics.horizontalAdvance(text), y - 0.5 * metrics.height()});
  }
  if (x_labels)
    for (const double value : ticks(x_scale)) {
      const QString text = text_of(tick_text(value, x_scale.decimals));
      const qreal x =
          area.left() + (value - x_scale.min) / (x_scale.max - x_scale.min) * area.width();
      const qreal width = metrics.horizontalAdvance(text);
      add(text, font, theme_->muted,
          {std::min(x - 0.5 * width, size_.width() - width - 2), area.bottom() + 7});
    }
  if (x_labels) {
    const qreal width = title_metrics.horizontalAdvance(x_title);
    add(x_title, title_font, theme_->text,
        {area.center().x() - 0.5 * width, area.bottom() + 10 + metrics.height()});
  }
  // A title longer than its panel may use the gaps above and below before it is shortened.
  const QString shown = title_metrics.elidedText(y_title, Qt::ElideRight, area.height() + m.gap);
  auto* title = add(shown, title_font, theme_->text, {});
  title->setRotation(-90);
  title->setPos(area.left() - m.left + 8,
                area.center().y() + 0.5 * title_metrics.horizontalAdvance(shown));
}

void ChartScene::addSeries(QChart* chart, const Polyline& line, const AxisScale& x_axis,
                           const AxisScale& y_axis, const QString& name, int colour, qreal width,
                           bool dashed) {
  auto* series = new QLineSeries;
  QList<QPointF> points;
  points.reserve(static_cast<qsizetype>(line.x.size()));
  for (std::size_t i = 0; i < line.x.size(); ++i)
    points.append({x_axis.shown(line.x[i]), y_axis.shown(line.y[i])});
  series->replace(points);
  series->setName(name);
  QPen pen(theme_->curves[static_cast<std::size_t>(colour) % theme_->curves.size()], width);
  pen.setJoinStyle(Qt::RoundJoin);
  if (dashed) pen.setDashPattern({4.0, 4.0});
  series->setPen(pen);
  chart->addSeries(series);
  for (auto* axis : chart->axes()) series->attachAxis(axis);
}

void ChartScene::addPoints(const Polyline& line, const QRectF& area, const AxisScale& x_axis,
                           const AxisScale& y_axis, int colour, qreal width) {
  const QColor fill = theme_->curves[static_cast<std::size_t>(colour) % theme_->curves.size()];
  const qreal r = 1.6 * width;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (line.x[i] < low_ || line.x[i] > high_) continue;
    const qreal x = area.left() + (x_axis.shown(line.x[i]) - x_axis.min) /
                                      (x_axis.max - x_axis.min) * area.width();
    const qreal y = area.bottom() - (y_axis.shown(line.y[i]) - y_axis.min) /
                                        (y_axis.max - y_axis.min) * area.height();
    addEllipse(QRectF(x - r, y - r, 2 * r, 2 * r), QPen(Qt::NoPen), fill)->setZValue(5);
  }
}

void ChartScene::addLegend(const ChartPanel& panel, const QRectF& area, const Metrics& m) {
  if (panel.curves.size() < 2) return;
  const QFont font = ui_font(m.text_font);
  const QFontMetricsF metrics(font);
  qreal x = area.right();
  for (std::size_t i = panel.curves.size(); i-- > 0;) {
    const QString name = text_of(panel.curves[i].name);
    x -= metrics.horizontalAdvance(name);
    auto* label = addSimpleText(name, font);
    label->setBrush(theme_->text);
    label->setPos(x, area.top() - metrics.height() - 3);
    const qreal middle = area.top() - 0.5 * metrics.height() - 3;
    QPen pen(theme_->curves[i % theme_->curves.size()], 2.4);
    if (panel.curves[i].dashed) pen.setDashPattern({2.0, 1.5});
    addLine(QLineF(x - 24, middle, x - 6, middle), pen);
    x -= 40;
  }
}

void ChartScene::addMarks(const QRectF& area, bool label, const Metrics& m) {
  for (const auto& mark : page_.marks) {
    const double shown = x_axis_.shown(mark.x);
    if (!(shown > x_axis_.min && shown < x_axis_.max)) continue;
    const qreal x =
        area.left() + (shown - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
    addLine(QLineF(x, area.top(), x, area.bottom()), QPen(theme_->muted, 1, Qt::DashLine));
    if (!label) continue;
    const QFont font = ui_font(m.tick_font);
    const QString text = text_of(mark.label);
    auto* item = addSimpleText(text, font);
    item->setBrush(theme_->muted);
    const qreal width = QFontMetricsF(font).horizontalAdvance(text);
    item->setPos(std::clamp(x - 0.5 * width, area.left(), area.right() - width),
                 area.top() - QFontMetricsF(font).height() - 3);
  }
}

void ChartScene::addMessage(const QRectF& area, const QString& text, const Metrics& m) {
  auto* item = addText(text, ui_font(m.text_font + 1));
  item->setDefaultTextColor(theme_->muted);
  item->setTextWidth(std::min<qreal>(area.width() - 20, 640));
  QTextOption option(Qt::AlignCenter);
  item->document()->setDefaultTextOption(option);
  item->setPos(area.center() - item->boundingRect().center());
}

void ChartScene::paintPage(QPainter& painter, const QRectF& target) {
  setPageSize(target.size());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::TextAntialiasing);
  render(&painter, target, sceneRect());
  painter.restore();
}

QImage ChartScene::image(QSize size) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(theme_->surface);
  QPainter painter(&image);
  paintPage(painter, QRectF(QPointF(0, 0), QSizeF(size)));
  return image;
}

}  // namespace adore::desktop
