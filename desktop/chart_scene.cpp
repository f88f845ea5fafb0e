#include "desktop/chart_scene.hpp"

#include "desktop/chart_scene_parts.hpp"
#include "desktop/dense_line.hpp"
#include "desktop/study_picture.hpp"

#include <QChart>
#include <QFontMetricsF>
#include <QGraphicsItem>
#include <QGraphicsLayout>
#include <QGraphicsLineItem>
#include <QGraphicsTextItem>
#include <QImage>
#include <QPainter>
#include <QTextDocument>
#include <QValueAxis>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace adore::desktop {

ChartScene::Metrics ChartScene::metrics() const {
  if (style_ == ChartStyle::Compact) return {74, 14, 46, 46, 26, 17, 13, 11, 10, 1.4, 1.0};
  const qreal note =
      18.0 * static_cast<qreal>(noteLines(28).size()) + (noteLines(28).isEmpty() ? 0 : 2);
  return {86, 28, 66 + note, 54, 34, 22, 18, 13, 12, 1.6, 1.2};
}

/// The page's note as lines of the page's width, three at most.
QStringList ChartScene::noteLines(qreal right) const {
  if (page_.note.empty() || page_.panels.empty()) return {};
  constexpr int kFont = 13, kLeft = 24, kMost = 3;
  const QFontMetricsF metrics(ui_font(kFont));
  const qreal width = size_.width() - kLeft - right;
  QStringList lines{QString()};
  for (const QString& word : text_of(page_.note).split(' ')) {
    const QString longer = lines.back().isEmpty() ? word : lines.back() + ' ' + word;
    if (lines.size() < kMost && !lines.back().isEmpty() &&
        metrics.horizontalAdvance(longer) > width)
      lines << word;
    else
      lines.back() = longer;
  }
  for (QString& line : lines) line = metrics.elidedText(line, Qt::ElideRight, width);
  return lines;
}

ChartScene::ChartScene(ChartStyle style, QObject* parent)
    : QGraphicsScene(parent), style_(style), theme_(&current_theme()) {}

void ChartScene::setPage(ChartPage page, bool keep_view) {
  const bool same = keep_view && zoomed() && !page.equal_axes && !page_.equal_axes &&
                    page.x_title == page_.x_title && page.x_unit == page_.x_unit;
  const double low = low_, high = high_;
  page_ = std::move(page);
  panel_views_.assign(page_.panels.size(), std::nullopt);
  studyCurves();
  const auto [first, last] = wholeRange();
  if (same && low < last && high > first) {
    low_ = std::max(low, first);
    high_ = std::min(high, last);
    rebuild();
  } else {
    resetView();
  }
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

void ChartScene::studyCurves() {
  constexpr std::size_t kLong = 8192;
  const std::vector<double>& x = page_.x;
  blocks_.clear();
  rising_ = !page_.equal_axes && !x.empty() && std::is_sorted(x.begin(), x.end()) &&
            std::all_of(x.begin(), x.end(), [](double value) { return is_drawable(value); });
  if (!rising_ || x.size() < kLong) return;
  for (const ChartPanel& panel : page_.panels) {
    auto& of_panel = blocks_.emplace_back();
    for (const ChartCurve& curve : panel.curves)
      of_panel.push_back(curve.y.size() == x.size() ? blocks_of(curve.y, panel.wraps)
                                                    : CurveBlocks{});
  }
}

std::pair<double, double> ChartScene::wholeRange() const {
  if (rising_ && !page_.log_x) return {page_.x.front(), page_.x.back()};
  Extent extent;
  for (const double x : page_.x)
    if (!page_.log_x || x > 0.0) extent.include(x);
  if (extent.empty()) return {page_.log_x ? 1.0 : 0.0, page_.log_x ? 10.0 : 1.0};
  return {extent.low, extent.high};
}

void ChartScene::resetView() {
  panel_views_.assign(page_.panels.size(), std::nullopt);
  std::tie(low_, high_) =
      page_.view_high > page_.view_low ? std::pair(page_.view_low, page_.view_high) : wholeRange();
  if (page_.log_x) low_ = std::max(low_, wholeRange().first);
  rebuild();
}

bool ChartScene::zoomed() const {
  const bool chosen = std::any_of(panel_views_.begin(), panel_views_.end(),
                                  [](const auto& range) { return range.has_value(); });
  const auto [first, last] =
      page_.view_high > page_.view_low ? std::pair(page_.view_low, page_.view_high) : wholeRange();
  return chosen || low_ != first || high_ != last;
}

void ChartScene::setView(double low, double high) { setZoom({low, high, panel_views_}); }

void ChartScene::setZoom(const ChartZoom& zoom) {
  if (page_.x.empty() || page_.equal_axes) return;
  const auto [first, last] = wholeRange();
  const double smallest = (last - first) * 1e-4;
  const double low = std::clamp(zoom.low, first, last), high = std::clamp(zoom.high, first, last);
  if (high - low >= smallest) {
    low_ = low;
    high_ = high;
  }
  panel_views_ = zoom.panels;
  panel_views_.resize(page_.panels.size());
  rebuild();
}

void ChartScene::setPanelView(std::size_t panel, std::optional<std::pair<double, double>> range) {
  if (panel >= panel_views_.size() || page_.equal_axes) return;
  if (range && !(range->second > range->first)) return;
  panel_views_[panel] = range;
  rebuild();
}

void ChartScene::showCurve(std::size_t panel, std::size_t curve, bool shown) {
  page_.panels.at(panel).curves.at(curve).hidden = !shown;
  rebuild();
}

double ChartScene::abscissaAt(double scene_x) const {
  if (areas_.empty()) return low_;
  const QRectF& area = areas_.front();
  return x_axis_.value(x_axis_.min +
                       (scene_x - area.left()) / area.width() * (x_axis_.max - x_axis_.min));
}

double ChartScene::positionOf(double abscissa) const {
  if (areas_.empty()) return 0.0;
  const QRectF& area = areas_.front();
  return area.left() +
         (x_axis_.shown(abscissa) - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
}

double ChartScene::valueAt(std::size_t panel, double scene_y) const {
  const QRectF& area = areas_.at(panel);
  const AxisScale& axis = y_axes_.at(panel);
  return axis.value(axis.min + (area.bottom() - scene_y) / area.height() * (axis.max - axis.min));
}

double ChartScene::heightOf(std::size_t panel, double value) const {
  const QRectF& area = areas_.at(panel);
  const AxisScale& axis = y_axes_.at(panel);
  return area.bottom() - (axis.shown(value) - axis.min) / (axis.max - axis.min) * area.height();
}

std::optional<std::size_t> ChartScene::panelAt(QPointF position) const {
  for (std::size_t p = 0; p < areas_.size(); ++p)
    if (areas_[p].contains(position)) return p;
  return std::nullopt;
}

std::vector<long> ChartScene::runsAt(QPointF position) const {
  return page_.study ? runs_at(*page_.study, size_, position) : std::vector<long>();
}

QString ChartScene::readout(QPointF position) const {
  if (const std::vector<long> runs = runsAt(position); !runs.empty())
    return (
        runs.size() == 1
            ? tr("run %1: a click shows it").arg(runs.front())
            : tr("%1 runs, %2 the first: a click shows them").arg(runs.size()).arg(runs.front()));
  if (page_.equal_axes || page_.x.empty() || !panelAt(position)) return {};
  const std::size_t i = nearest_index(page_.x, abscissaAt(position.x()));
  QString text = text_of(pretty_quantity(page_.x[i], page_.x_unit, 5)) + ":";
  for (const ChartPanel& panel : page_.panels) {
    QStringList values;
    for (const auto& curve : panel.curves) {
      if (i >= curve.y.size() || curve.hidden) continue;
      const QString value = text_of(pretty_quantity(curve.value(i), panel.unit, 5));
      values << (curve.name.empty() ? value : text_of(curve.name) + " " + value);
    }
    if (values.isEmpty()) continue;
    const bool titled = page_.panels.size() > 1 || panel.curves.front().name.empty();
    text += "   " + (titled ? text_of(panel.title) + " " : QString()) + values.join(", ");
  }
  return text;
}

void ChartScene::rebuild() {
  clear();
  charts_.clear();
  lines_.clear();
  areas_.clear();
  y_axes_.clear();
  legend_.clear();
  setSceneRect(QRectF(QPointF(0, 0), size_));
  setBackgroundBrush(theme_->surface);
  if (page_.study) {
    addItem(new StudyPicture(page_.study, *theme_, size_));
    return;
  }
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
  x_axis_ = page_.log_x ? log_axis(low_, high_, page_.x_unit, true)
                        : tight_axis(low_, high_, page_.x_unit,
                                     std::max(2, static_cast<int>(space.width() / 110)));
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
    auto* item =
        addSimpleText(fitted_line(text, QFontMetricsF(font), size_.width() - left - m.right), font);
    item->setBrush(colour);
    item->setPos(left, y);
  };
  if (style_ == ChartStyle::Compact) {
    line(text_of(page_.title), ui_font(m.title_font, true), theme_->text, 8);
    return;
  }
  line(text_of(page_.title), ui_font(m.title_font, true), theme_->text, 14);
  line(text_of(page_.subtitle), ui_font(m.text_font), theme_->muted, 40);
  qreal y = 60;
  for (const QString& text : noteLines(m.right)) {
    line(text, ui_font(m.text_font), theme_->accent, y);
    y += 18;
  }
}

void ChartScene::addPanel(std::size_t index, const QRectF& area, bool bottom, const Metrics& m) {
  const ChartPanel& panel = page_.panels[index];
  Extent extent;
  bool any = false;
  const auto [from, to] = rising_ ? places_between(page_.x, low_, high_)
                                  : std::pair<std::size_t, std::size_t>(0, page_.x.size());
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const ChartCurve& curve = panel.curves[c];
    any = any || std::any_of(curve.y.begin(), curve.y.end(), is_drawable);
    if (curve.hidden) continue;
    const CurveBlocks* blocks = blocks_.empty() || panel.log ? nullptr : &blocks_[index][c];
    for (const auto* values : {&curve.y, &curve.low, &curve.high})
      for (std::size_t i = from; i < std::min(to, values->size()); ++i) {
        if (!rising_ && (page_.x[i] < low_ || page_.x[i] > high_)) continue;
        const std::size_t b = i / CurveBlocks::kLength;
        if (values == &curve.y && blocks != nullptr && i % CurveBlocks::kLength == 0 &&
            i + CurveBlocks::kLength <= to && b < blocks->blocks.size() &&
            blocks->blocks[b].whole) {
          extent.include((*values)[blocks->blocks[b].lowest]);
          extent.include((*values)[blocks->blocks[b].highest]);
          i += CurveBlocks::kLength - 1;
        } else if (!panel.log || (*values)[i] > 0.0) {
          extent.include((*values)[i]);
        }
      }
  }
  const double least = std::max(panel.least_span, least_span_of(panel.unit));
  if (!panel.log && !extent.empty() && extent.high - extent.low < least) {
    // Beside a larger value such noise is a constant; about zero the axis shows how small it is.
    const double middle = 0.5 * (extent.low + extent.high);
    const bool nothing = std::max(std::abs(extent.low), std::abs(extent.high)) < 1e-3 * least;
    const double half = std::abs(middle) > 500.0 * least ? 0.0 : 0.5 * least;
    extent = {middle - half, middle + half};
    // What is 0 but for rounding gets a scale that bearings have, not one of atoms.
    if (nothing) extent = {-1e4 * least, 1e4 * least};
  }
  const int parts = std::clamp(static_cast<int>(area.height() / 38), 2, 8);
  const auto& chosen = panel_views_[index];
  const double low = chosen ? chosen->first : extent.low,
               high = chosen ? chosen->second : extent.high;
  const AxisScale y_axis = panel.log ? log_axis(low, high, panel.unit, chosen.has_value())
                           : chosen  ? tight_axis(low, high, panel.unit, parts)
                                     : value_axis(low, high, panel.unit, parts);
  const QString x_title = bottom ? with_unit_and_base(text_of(page_.x_title), x_axis_) : QString();
  const qreal legend = addLegend(panel, area, m);
  // A title too long for the side of its panel, even without its unit, stands above it.
  QString y_title = with_unit(text_of(panel.title), y_axis);
  qreal head = area.left();
  const QFontMetricsF title_metrics(ui_font(m.text_font));
  const bool names_above = index == 0 && !page_.marks.empty();
  if (!names_above &&
      title_metrics.horizontalAdvance(text_of(panel.title)) > title_room(area, m.gap) &&
      area.left() + title_metrics.horizontalAdvance(y_title) + 8.0 < legend) {
    auto* title = addSimpleText(y_title, ui_font(m.text_font));
    title->setBrush(theme_->text);
    title->setPos(area.left(), area.top() - title_metrics.height() - 3.0);
    head += title_metrics.horizontalAdvance(y_title) + 16.0;
    y_title.clear();
  }
  addChart(area, x_axis_, y_axis, x_title, y_title, bottom, m);
  int colour = -1;
  std::vector<QPolygonF> drawn;
  for (const auto& curve : panel.curves) {
    colour = panel.one_colour ? 0 : colour + 1;
    if (curve.hidden) continue;
    if (!curve.low.empty()) addBand(curve, area, y_axis, colour, drawn);
    std::vector<double> positive;
    if (panel.log) {
      positive = curve.y;
      for (double& value : positive)
        if (!(value > 0.0)) value = std::numeric_limits<double>::quiet_NaN();
    }
    const auto pieces = drawable_pieces(
        page_.x, panel.log ? positive : curve.y, low_, high_, static_cast<int>(area.width()),
        panel.wraps,
        blocks_.empty() || panel.log
            ? nullptr
            : &blocks_[index][static_cast<std::size_t>(&curve - panel.curves.data())]);
    for (const auto& piece : pieces) {
      drawn.push_back(addCurve(piece, area, x_axis_, y_axis, penOf(colour, m.line, curve.dashed)));
      // A value between gaps has no line: it is a point.
      if (page_.points || piece.x.size() == 1)
        addPoints(piece, area, x_axis_, y_axis, colour, m.line);
    }
  }
  if (!any)
    addMessage(area, panel.message.empty() ? "no values in the file" : text_of(panel.message), m);
  else if (panel.log && std::all_of(panel.curves.begin(), panel.curves.end(), nothing_above_0))
    addMessage(area, tr("No value is above 0, and a logarithmic axis shows no others."), m);
  if (!y_axis.offset_text.empty()) addBase(y_axis, area, head, legend, drawn, m);
  if (any) addMarks(area, index == 0, legend, m);  // lines across a message hide its words
  areas_.push_back(area);
  y_axes_.push_back(y_axis);
}

/// The extremes between the values, as a pale area that the lowest and highest value of each column
/// of pixels bound.
void ChartScene::addBand(const ChartCurve& curve, const QRectF& area, const AxisScale& y_axis,
                         int colour, std::vector<QPolygonF>& drawn) {
  const std::size_t count = std::min({page_.x.size(), curve.low.size(), curve.high.size()});
  struct Column {
    qreal x = 0.0;
    double low = 0.0, high = 0.0;
  };
  std::vector<Column> columns;
  const auto flush = [&] {
    if (columns.size() < 2) {
      columns.clear();
      return;
    }
    const auto height = [&](double value) {
      const double at = (y_axis.shown(value) - y_axis.min) / (y_axis.max - y_axis.min);
      return area.bottom() - std::clamp(at, 0.0, 1.0) * area.height();
    };
    QPolygonF outline;
    for (const Column& c : columns) outline.append({c.x, height(c.high)});
    for (auto c = columns.rbegin(); c != columns.rend(); ++c)
      outline.append({c->x, height(c->low)});
    QColor fill = theme_->curves[static_cast<std::size_t>(colour) % theme_->curves.size()];
    fill.setAlpha(70);
    addPolygon(outline, QPen(Qt::NoPen), fill);
    drawn.push_back(std::move(outline));
    columns.clear();
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (page_.x[i] < low_ || page_.x[i] > high_) continue;
    if (!is_drawable(curve.low[i]) || !is_drawable(curve.high[i])) {
      flush();
      continue;
    }
    const qreal x = area.left() + (x_axis_.shown(page_.x[i]) - x_axis_.min) /
                                      (x_axis_.max - x_axis_.min) * area.width();
    if (columns.size() > 1 && std::floor(x) == std::floor(columns.back().x)) {
      columns.back().low = std::min(columns.back().low, curve.low[i]);
      columns.back().high = std::max(columns.back().high, curve.high[i]);
    } else {
      columns.push_back({x, curve.low[i], curve.high[i]});
    }
  }
  flush();
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
    axis->setVisible(!page_.schematic);
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
  lines_.push_back(0);
  if (!page_.schematic) addLabels(area, x_scale, y_scale, x_title, y_title, x_labels, m);
  return chart;
}

// Our own tick labels and titles: Qt Charts writes "-0.0", cuts long labels, and sets titles at a
// different place in each panel.
void ChartScene::addLabels(const QRectF& area, const AxisScale& x_scale, const AxisScale& y_scale,
                           const QString& x_title, const QString& y_title, bool x_labels,
                           const Metrics& m) {
  const QFont font = ui_font(m.tick_font), title_font = ui_font(m.text_font);
  const QFontMetricsF metrics(font), title_metrics(title_font);
  const auto add = [&](const QString& text, const QFont& used, const QColor& colour,
                       QPointF position) {
    auto* item = addSimpleText(text, used);
    item->setBrush(colour);
    item->setPos(position);
    return item;
  };
  for (const auto& [value, label] : axis_ticks(y_scale)) {
    const QString text = text_of(label);
    const qreal y =
        area.bottom() - (value - y_scale.min) / (y_scale.max - y_scale.min) * area.height();
    add(text, font, theme_->muted,
        {area.left() - 8 - metrics.horizontalAdvance(text), y - 0.5 * metrics.height()});
  }
  if (x_labels)
    for (const auto& [value, label] : axis_ticks(x_scale)) {
      const QString text = text_of(label);
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
  // A title longer than its panel may use the gaps above and below; then its unit gets a line of
  // its own, which is never shortened.
  const qreal room = title_room(area, m.gap);
  const auto write = [&](const QString& text, qreal left) {
    auto* title = add(text, title_font, theme_->text, {});
    title->setRotation(-90);
    title->setPos(left, area.center().y() + 0.5 * title_metrics.horizontalAdvance(text));
  };
  const qsizetype unit = y_title.lastIndexOf(" [");
  if (title_metrics.horizontalAdvance(y_title) <= room || unit < 0) {
    write(title_metrics.elidedText(y_title, Qt::ElideRight, room), area.left() - m.left + 8);
    return;
  }
  write(title_metrics.elidedText(y_title.left(unit), Qt::ElideRight, room),
        area.left() - m.left + 1);
  write(y_title.mid(unit + 1), area.left() - m.left + 1 + title_metrics.height() - 2);
}

namespace {

/// A line of a chart, not beyond its area.
class LineItem : public QGraphicsItem {
 public:
  LineItem(QPolygonF line, const QRectF& area, QPen pen)
      : line_(std::move(line)), area_(area), pen_(std::move(pen)) {}
  [[nodiscard]] QRectF boundingRect() const override { return area_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    draw_line(*painter, line_, area_, pen_);
  }

 private:
  QPolygonF line_;
  QRectF area_;
  QPen pen_;
};

}  // namespace

QPen ChartScene::penOf(int colour, qreal width, bool dashed) const {
  QPen pen(theme_->curves[static_cast<std::size_t>(colour) % theme_->curves.size()], width);
  pen.setJoinStyle(Qt::BevelJoin);  // a round one takes five times as long
  if (dashed) pen.setDashPattern({4.0, 4.0});
  return pen;
}

QPolygonF ChartScene::addCurve(const Polyline& line, const QRectF& area, const AxisScale& x_axis,
                               const AxisScale& y_axis, QPen pen) {
  QPolygonF points;
  points.reserve(static_cast<qsizetype>(line.x.size()));
  // Far outside a picture numbers are too large for the painter.
  constexpr double kFar = 1e5;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const double x = (x_axis.shown(line.x[i]) - x_axis.min) / (x_axis.max - x_axis.min),
                 y = (y_axis.shown(line.y[i]) - y_axis.min) / (y_axis.max - y_axis.min);
    points.append({area.left() + std::clamp(x * area.width(), -kFar, kFar),
                   area.bottom() - std::clamp(y * area.height(), -kFar, kFar)});
  }
  addItem(new LineItem(points, area.adjusted(-1, -1, 1, 1), std::move(pen)));
  if (!lines_.empty()) ++lines_.back();
  return points;
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
    if (y < area.top() || y > area.bottom()) continue;  // beyond the chosen range
    addEllipse(QRectF(x - r, y - r, 2 * r, 2 * r), QPen(Qt::NoPen), fill)->setZValue(5);
  }
}

qreal ChartScene::addLegend(const ChartPanel& panel, const QRectF& area, const Metrics& m) {
  if (panel.curves.size() < 2 || panel.one_colour) return area.right();
  const QFont font = ui_font(m.text_font);
  const QFontMetricsF metrics(font);
  // What has no room shares it: first the lines get short, then long names are shortened alike.
  const auto count = static_cast<qreal>(panel.curves.size());
  const auto name_of = [&](const ChartCurve& curve) {
    return panel.log && nothing_above_0(curve) ? tr("%1 (not above 0)").arg(text_of(curve.name))
                                               : text_of(curve.name);
  };
  qreal names = 0.0;
  for (const auto& curve : panel.curves) names += metrics.horizontalAdvance(name_of(curve));
  const qreal room = area.right() - 8.0;  // also over the labels of the axis
  const bool narrow = names + count * (24.0 + 16.0) > room;
  const qreal line = narrow ? 14.0 : 24.0, gap = narrow ? 8.0 : 16.0;
  const qreal most =
      names + count * (line + gap) <= room ? room : std::max(0.0, room / count - line - gap);
  const auto index = static_cast<std::size_t>(&panel - page_.panels.data());
  qreal x = area.right();
  for (std::size_t i = panel.curves.size(); i-- > 0;) {
    const ChartCurve& curve = panel.curves[i];
    const QString name = metrics.elidedText(name_of(curve), Qt::ElideMiddle, most);
    x -= metrics.horizontalAdvance(name);
    auto* label = addSimpleText(name, font);
    label->setBrush(curve.hidden ? theme_->muted : theme_->text);
    label->setToolTip(name_of(curve));
    label->setPos(x, area.top() - metrics.height() - 3);
    const qreal middle = area.top() - 0.5 * metrics.height() - 3;
    QPen pen(curve.hidden ? theme_->frame : theme_->curves[i % theme_->curves.size()], 2.4);
    if (curve.dashed) pen.setDashPattern({2.0, 1.5});
    addLine(QLineF(x - line, middle, x - 6, middle), pen);
    legend_.push_back({QRectF(x - line, area.top() - metrics.height() - 3,
                              metrics.horizontalAdvance(name) + line, metrics.height()),
                       index, i});
    x -= line + gap;
  }
  return x;
}

void ChartScene::addMarks(const QRectF& area, bool label, qreal free_until, const Metrics& m) {
  std::vector<ChartMark> marks = page_.marks;
  std::stable_sort(marks.begin(), marks.end(),
                   [](const ChartMark& a, const ChartMark& b) { return a.x < b.x; });
  const QFont font = ui_font(m.tick_font);
  const QFontMetricsF metrics(font);
  // Lines too close for a name each have theirs in one text, in their order.
  struct Names {
    QString text;
    qreal left = 0.0, right = 0.0;
    bool one = true;
  };
  std::vector<Names> names;
  const auto place = [&](Names& group) {
    group.text = metrics.elidedText(group.text, Qt::ElideRight, area.width());
    const qreal width = metrics.horizontalAdvance(group.text);
    group.left = std::clamp(group.left, area.left(), area.right() - width);
    group.right = group.left + width;
  };
  constexpr qreal kApart = 8.0;
  for (const auto& mark : marks) {
    const double shown = x_axis_.shown(mark.x);
    if (!(shown > x_axis_.min && shown < x_axis_.max)) continue;
    const qreal x =
        area.left() + (shown - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
    addLine(QLineF(x, area.top(), x, area.bottom()), QPen(theme_->muted, 1, Qt::DashLine));
    if (!label) continue;
    const QString text = text_of(mark.label);
    names.push_back({text, x - 0.5 * metrics.horizontalAdvance(text)});
    place(names.back());
    while (names.size() > 1 && names.back().left < names[names.size() - 2].right + kApart) {
      Names& before = names[names.size() - 2];
      before.text += ", " + names.back().text;
      before.one = false;
      names.pop_back();
      place(names.back());
    }
  }
  for (Names& group : names) {
    // Several names that meet the legend end before it: they would cover the curves below it.
    const qreal until = free_until - kApart - group.left;
    if (!group.one && group.left + metrics.horizontalAdvance(group.text) > free_until - kApart &&
        free_until < area.right() && until > 0.5 * (group.right - group.left)) {
      group.text = metrics.elidedText(group.text, Qt::ElideRight, until);
      group.right = group.left + metrics.horizontalAdvance(group.text) - 1.0;
    }
    auto* item = addSimpleText(group.text, font);
    item->setBrush(theme_->muted);
    const bool above = free_until >= area.right() || group.right + kApart < free_until;
    const qreal aside = above || !group.one ? 0.0 : -0.5 * (group.right - group.left) - 3.0;
    item->setPos(group.left + aside, area.top() + (above ? -metrics.height() - 3.0 : 2.0));
    if (above || group.one) continue;
    QColor paper = theme_->surface;  // its own lines pass there
    paper.setAlpha(215);
    item->setZValue(1.0);
    addRect(item->sceneBoundingRect(), Qt::NoPen, paper);
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
