#include "desktop/axis_scale.hpp"
#include "desktop/heat_color.hpp"
#include "desktop/study_chart.hpp"
#include "desktop/theme.hpp"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace adore::desktop {
namespace {

QString text_of(const std::string& text) { return QString::fromStdString(text); }

/// All sizes of a page are proportional to its letters: a page of 1280 by 800 has 15 pixels, none
/// has fewer than 11.
struct Page {
  explicit Page(const QSizeF& of)
      : size(of),
        letter(std::clamp(15.0 * std::min(of.width() / 1280.0, of.height() / 800.0), 11.0, 24.0)),
        u(letter / 15.0) {}
  QSizeF size;
  double letter, u;
  /// Space for `left` and `right` of the plane, in pixels of the large page.
  [[nodiscard]] QRectF plane(double left, double right, double top = 70.0) const {
    return {left * u, top * u, std::max(size.width() - (left + right) * u, 40.0),
            std::max(size.height() - (top + 90.0) * u, 40.0)};
  }
};

class Sheet {
 public:
  Sheet(const Page& page, QPainter& painter, const Theme& colours, const std::string& title)
      : page_(page), painter_(painter), colours_(colours) {
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setFont(ui_font(static_cast<int>(std::lround(20 * page.u)), true));
    painter_.setPen(colours_.text);
    const QRectF box(20 * page.u, 12 * page.u, page.size.width() - 40 * page.u, 34 * page.u);
    painter_.drawText(
        box, Qt::AlignCenter,
        QFontMetricsF(painter_.font()).elidedText(text_of(title), Qt::ElideMiddle, box.width()));
    painter_.setFont(ui_font(static_cast<int>(std::lround(page.letter))));
  }
  [[nodiscard]] QPainter& painter() { return painter_; }
  [[nodiscard]] const Theme& colours() const { return colours_; }
  [[nodiscard]] double u() const { return page_.u; }
  [[nodiscard]] double width(const QString& text) const {
    return QFontMetricsF(painter_.font()).horizontalAdvance(text);
  }

  void label(const QRectF& box, int flags, const std::string& text) {
    painter_.setPen(colours_.text);
    painter_.drawText(
        box, flags,
        QFontMetricsF(painter_.font()).elidedText(text_of(text), Qt::ElideMiddle, box.width()));
  }
  /// Below the plane, and to its left from bottom to top.
  void titles(const QRectF& plane, const std::string& across, const std::string& up) {
    label({plane.left(), page_.size.height() - 44.0 * u(), plane.width(), 30 * u()},
          Qt::AlignCenter, across);
    painter_.save();
    painter_.translate(28 * u(), plane.center().y());
    painter_.rotate(-90);
    label({-plane.height() / 2, -16 * u(), plane.height(), 32 * u()}, Qt::AlignCenter, up);
    painter_.restore();
  }
  void line(QPointF from, QPointF to, const QColor& colour, double width) {
    painter_.setPen(QPen(colour, width));
    painter_.drawLine(from, to);
  }

 private:
  const Page& page_;
  QPainter& painter_;
  const Theme& colours_;
};

struct PanelExtent {
  double low = std::numeric_limits<double>::infinity(),
         high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!is_drawable(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool any() const { return low <= high; }
  /// Values over two decades and more, none of them 0 or negative: in one color but the largest
  /// few on an even scale.
  [[nodiscard]] bool wide() const { return low > 0.0 && high >= 100.0 * low; }
  [[nodiscard]] double share(double value, bool logarithmic = false) const {
    if (!(high > low)) return 0.5;
    return logarithmic ? std::log(value / low) / std::log(high / low)
                       : (value - low) / (high - low);
  }
};

std::string title_with_unit(const std::string& title, const std::string& unit) {
  return unit.empty() ? title : title + " [" + unit + "]";
}

// ---- maps

struct MapPlace {
  MapPlace(const HeatMap& map, const QSizeF& size)
      : page(size),
        plane(page.plane(130, 200)),
        w(plane.width() / static_cast<double>(std::max<std::size_t>(map.x.size(), 1))),
        h(plane.height() / static_cast<double>(std::max<std::size_t>(map.y.size(), 1))) {}
  [[nodiscard]] QRectF cell(std::size_t i, std::size_t j) const {
    return {plane.left() + w * static_cast<double>(i),
            plane.bottom() - h * static_cast<double>(j + 1), w, h};
  }
  Page page;
  QRectF plane;
  double w, h;
};

void paint(const HeatMap& map, QPainter& painter, const QSizeF& size, const Theme& theme) {
  const MapPlace place(map, size);
  const QRectF& plane = place.plane;
  const double u = place.page.u;
  PanelExtent extent;
  for (const auto& row : map.values)
    for (const double value : row) extent.add(value);
  Sheet sheet(place.page, painter, theme, map.title);
  // Numbers in cells have the unit of the scale.
  const bool wide = extent.wide();
  const AxisScale axis = wide ? log_axis(extent.low, extent.high, map.unit, true)
                              : tight_axis(extent.low, extent.high, map.unit, 6);
  const double line = QFontMetricsF(painter.font()).lineSpacing();
  for (std::size_t j = 0; j < map.y.size(); ++j)
    for (std::size_t i = 0; i < map.x.size(); ++i) {
      const QRectF cell = place.cell(i, j);
      const double value = map.values[j][i];
      const bool known = is_drawable(value);
      const double share = extent.high > extent.low ? extent.share(value, wide) : 0.0;
      painter.fillRect(cell, known ? heat_color(share) : theme.grid);
      painter.setPen(QPen(theme.surface, 1.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(cell);
      painter.setPen(!known ? theme.muted : QColor(share > 0.6 ? Qt::black : Qt::white));
      // As much of number and mark as the cell has room for.
      const QString number =
          known ? text_of(pretty_number(value / axis.factor, 3)) : QString("none");
      const QString mark = map.marks.empty() ? QString() : text_of(map.marks[j][i]);
      const bool number_fits = sheet.width(number) < place.w - 4 * u && line < place.h;
      const bool mark_fits =
          !mark.isEmpty() && sheet.width(mark) < place.w - 4 * u && 2.0 * line < place.h;
      if (number_fits)
        painter.drawText(cell, Qt::AlignCenter, mark_fits ? number + "\n" + mark : number);
    }
  double widest = 0.0;
  for (const double x : map.x)
    widest = std::max(widest, sheet.width(text_of(pretty_number(x))) + 8 * u);
  const auto every_x = static_cast<std::size_t>(std::max(1.0, std::ceil(widest / place.w))),
             every_y = static_cast<std::size_t>(std::max(1.0, std::ceil(line / place.h)));
  for (std::size_t i = 0; i < map.x.size(); i += every_x)
    sheet.label(
        {place.cell(i, 0).center().x() - widest / 2, plane.bottom() + 6 * u, widest, 22 * u},
        Qt::AlignCenter, pretty_number(map.x[i]));
  for (std::size_t j = 0; j < map.y.size(); j += every_y)
    sheet.label({50 * u, place.cell(0, j).center().y() - line, 74 * u, 2 * line},
                Qt::AlignRight | Qt::AlignVCenter, pretty_number(map.y[j]));
  sheet.titles(plane, map.x_title, map.y_title);
  if (!extent.any()) return;
  const QRectF scale(plane.right() + 40 * u, plane.top() + 40 * u, 28 * u, plane.height() - 80 * u);
  for (int k = 0; k < static_cast<int>(scale.height()); ++k)
    painter.fillRect(QRectF(scale.left(), scale.bottom() - k - 1, scale.width(), 1.5),
                     heat_color(k / scale.height()));
  for (const AxisTick& tick : axis_ticks(axis)) {
    const double y = scale.bottom() - extent.share(axis.value(tick.at), wide) * scale.height();
    sheet.label({scale.right() + 6 * u, y - 11 * u, 120 * u, 22 * u},
                Qt::AlignLeft | Qt::AlignVCenter, tick.text);
  }
  sheet.label({size.width() - 520 * u, 44 * u, 512 * u, 26 * u}, Qt::AlignRight | Qt::AlignVCenter,
              title_with_unit(map.legend, axis.unit) + (wide ? ", logarithmic" : "") +
                  (axis.offset_text.empty() ? "" : " − " + axis.offset_text));
}

Runs near(const HeatMap& map, const QSizeF& size, const QPointF& at) {
  const MapPlace place(map, size);
  if (map.runs.empty() || !place.plane.contains(at)) return {};
  const auto i = static_cast<std::size_t>((at.x() - place.plane.left()) / place.w),
             j = static_cast<std::size_t>((place.plane.bottom() - at.y()) / place.h);
  return map.runs[std::min(j, map.y.size() - 1)][std::min(i, map.x.size() - 1)];
}

// ---- parallel coordinates

/// Heading of an axis, "Stiffness, x [N/m]", with the unit scaled for its largest value.
struct AxisHeading {
  std::string text;
  double factor = 1.0;
};
AxisHeading scaled_heading(const std::string& heading, const PanelExtent& extent) {
  const std::size_t at = heading.rfind(" [");
  if (at == std::string::npos || heading.back() != ']' || !extent.any()) return {heading, 1.0};
  const std::string unit = heading.substr(at + 2, heading.size() - at - 3);
  const double largest = std::max(std::abs(extent.low), std::abs(extent.high));
  const AxisScale scale = tight_axis(0.0, largest, unit, 4);
  return {title_with_unit(heading.substr(0, at), scale.unit), scale.factor};
}

struct LinesPlace {
  LinesPlace(const ParallelLines& lines, const QSizeF& size)
      : page(size),
        plane(page.plane(110, 110, 120)),
        gap(plane.width() / static_cast<double>(lines.axes.size() - 1)),
        extents(lines.axes.size()) {
    for (const auto& row : lines.rows)
      for (std::size_t k = 0; k < row.size(); ++k) extents[k].add(row[k]);
  }
  [[nodiscard]] QPointF at(std::size_t k, double value) const {
    return {plane.left() + gap * static_cast<double>(k),
            plane.bottom() - extents[k].share(value) * plane.height()};
  }
  Page page;
  QRectF plane;
  double gap;
  std::vector<PanelExtent> extents;
};

void paint(const ParallelLines& lines, QPainter& painter, const QSizeF& size, const Theme& theme) {
  const LinesPlace place(lines, size);
  const QRectF& plane = place.plane;
  const double u = place.page.u;
  Sheet sheet(place.page, painter, theme, lines.title);
  const std::size_t last = lines.axes.size() - 1;
  const auto draw = [&](std::size_t i, double width, int alpha) {
    const auto& row = lines.rows[i];
    QColor colour = is_drawable(row[last]) ? heat_color(0.9 * place.extents[last].share(row[last]))
                                           : theme.frame;
    colour.setAlpha(alpha);
    painter.setPen(QPen(colour, width));
    for (std::size_t k = 0; k + 1 < row.size(); ++k)
      if (is_drawable(row[k]) && is_drawable(row[k + 1]))
        painter.drawLine(place.at(k, row[k]), place.at(k + 1, row[k + 1]));
  };
  constexpr double kSolid = 200.0;  // rows; more of them are drawn paler
  const int alpha = static_cast<int>(
      std::clamp(200.0 * kSolid / static_cast<double>(lines.rows.size()), 30.0, 200.0));
  for (std::size_t i = 0; i < lines.rows.size(); ++i) draw(i, 1.4, alpha);
  if (lines.heavy >= 0) draw(static_cast<std::size_t>(lines.heavy), 4.0, 255);
  for (std::size_t k = 0; k < lines.axes.size(); ++k) {
    const double x = plane.left() + place.gap * static_cast<double>(k);
    sheet.line({x, plane.top()}, {x, plane.bottom()}, theme.text, 1.5);
    // Names are in two rows, so that each has the space of two gaps.
    const AxisHeading heading = scaled_heading(lines.axes[k], place.extents[k]);
    const double room = std::min({2.0 * place.gap - 8 * u, 400.0 * u, size.width() - 8 * u});
    const double wide = std::min(room, sheet.width(text_of(heading.text)) + 2.0);
    const double left = std::clamp(x - wide / 2, 4.0 * u, size.width() - wide - 4.0 * u);
    sheet.label({left, (k % 2 == 0 ? 48 : 70) * u, wide, 24 * u}, Qt::AlignCenter, heading.text);
    if (!place.extents[k].any()) continue;
    const double width = std::max(50.0 * u, place.gap - 4 * u);
    sheet.label({x - width / 2, plane.bottom() + 6 * u, width, 22 * u}, Qt::AlignCenter,
                pretty_number(place.extents[k].low / heading.factor, 3));
    sheet.label({x - width / 2, plane.top() - 22 * u, width, 22 * u}, Qt::AlignCenter,
                pretty_number(place.extents[k].high / heading.factor, 3));
  }
  sheet.label({20 * u, size.height() - 44.0 * u, size.width() - 40.0 * u, 30 * u}, Qt::AlignCenter,
              "Each line is a run. Dark to bright: low to high value in the last column.");
}

double distance(const QPointF& a, const QPointF& b, const QPointF& from) {
  const QPointF along = b - a, to = from - a;
  const double length = QPointF::dotProduct(along, along);
  const double share =
      length > 0.0 ? std::clamp(QPointF::dotProduct(to, along) / length, 0.0, 1.0) : 0.0;
  const QPointF gap = to - share * along;
  return std::hypot(gap.x(), gap.y());
}

Runs near(const ParallelLines& lines, const QSizeF& size, const QPointF& at) {
  const LinesPlace place(lines, size);
  double best = 6.0 * place.page.u;
  Runs out;
  for (std::size_t i = 0; i < lines.rows.size() && !lines.runs.empty(); ++i)
    for (std::size_t k = 0; k + 1 < lines.axes.size(); ++k) {
      const auto& row = lines.rows[i];
      if (!is_drawable(row[k]) || !is_drawable(row[k + 1])) continue;
      const double d = distance(place.at(k, row[k]), place.at(k + 1, row[k + 1]), at);
      if (d >= best) continue;
      best = d;
      out = {lines.runs[i]};
    }
  return out;
}

// ---- bars

void paint(const Tornado& tornado, QPainter& painter, const QSizeF& size, const Theme& theme) {
  std::vector<Tornado::Bar> bars;
  for (const Tornado::Bar& bar : tornado.bars)
    if (is_drawable(bar.value)) bars.push_back(bar);
  std::stable_sort(bars.begin(), bars.end(), [](const auto& a, const auto& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  const Page page(size);
  const double u = page.u;
  // Names are complete unless they need more than half of the page.
  double widest = 0.0;
  const QFontMetricsF metrics(ui_font(static_cast<int>(std::lround(page.letter))));
  for (const Tornado::Bar& bar : bars)
    widest = std::max(widest, metrics.horizontalAdvance(text_of(bar.name)));
  const double names = std::clamp(widest + 4.0, 60.0 * u, 0.5 * size.width());
  const QRectF plane = page.plane(names / u + 18.0, 100);
  const auto most = static_cast<std::size_t>(std::clamp(plane.height() / (24 * u), 3.0, 20.0));
  if (bars.size() > most) bars.resize(most);
  double largest = 0.0;
  for (const Tornado::Bar& bar : bars)
    largest = std::max(largest, std::abs(bar.value) + (is_drawable(bar.doubt) ? bar.doubt : 0.0));
  if (!(largest > 0.0)) largest = 1.0;
  Sheet sheet(page, painter, theme, tornado.title);
  const AxisScale axis = value_axis(-1.3 * largest, 1.3 * largest, "",
                                    std::max(2, static_cast<int>(plane.width() / (110 * u))));
  const auto x_of = [&](double value) {
    return plane.left() + (axis.shown(value) - axis.min) / (axis.max - axis.min) * plane.width();
  };
  for (const AxisTick& tick : axis_ticks(axis)) {
    const double x = x_of(axis.value(tick.at));
    sheet.line({x, plane.top()}, {x, plane.bottom()}, theme.grid, 1.0);
    sheet.label({x - 50 * u, plane.bottom() + 6 * u, 100 * u, 22 * u}, Qt::AlignCenter, tick.text);
  }
  const double h = plane.height() / static_cast<double>(std::max<std::size_t>(bars.size(), 1));
  const double thick = std::min(0.7 * h, 60.0 * u);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double y = plane.top() + h * static_cast<double>(i);
    const double from = x_of(0.0), to = x_of(bars[i].value);
    painter.fillRect(QRectF(std::min(from, to), y + 0.5 * (h - thick), std::abs(to - from), thick),
                     bars[i].value < 0.0 ? theme.curves[1] : theme.curves[0]);
    if (bars[i].doubt > 0.0 && is_drawable(bars[i].doubt))
      sheet.line({x_of(bars[i].value - bars[i].doubt), y + 0.5 * h},
                 {x_of(bars[i].value + bars[i].doubt), y + 0.5 * h}, theme.text, 2.0);
    sheet.label({8 * u, y, names, h}, Qt::AlignRight | Qt::AlignVCenter, bars[i].name);
    const bool right = bars[i].value >= 0.0;
    sheet.label(right ? QRectF(to + 8 * u, y, 120 * u, h) : QRectF(to - 128 * u, y, 120 * u, h),
                (right ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
                pretty_number(bars[i].value, 3));
  }
  sheet.line({x_of(0.0), plane.top()}, {x_of(0.0), plane.bottom()}, theme.text, 1.5);
  sheet.titles(plane, title_with_unit(tornado.x_title, axis.unit), "");
}

Runs near(const Tornado& /*tornado*/, const QSizeF& /*size*/, const QPointF& /*at*/) {
  return {};  // a bar is of all runs
}

// ---- curves

struct CurvesPlace {
  CurvesPlace(const BandCurves& data, const QSizeF& size)
      : page(size), plane(page.plane(130, data.curves.size() > 1 ? 250 : 60)) {
    PanelExtent across, up;
    for (const BandCurves::Curve& curve : data.curves)
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!is_drawable(curve.y[i])) continue;
        across.add(curve.x[i]);
        up.add(curve.y[i]);
        if (!curve.low.empty()) up.add(curve.low[i]);
        if (!curve.high.empty()) up.add(curve.high[i]);
      }
    const double u = page.u;
    x = tight_axis(across.low, across.high, data.x_unit,
                   std::max(2, static_cast<int>(plane.width() / (130 * u))));
    y = value_axis(up.low, up.high, data.y_unit,
                   std::max(2, static_cast<int>(plane.height() / (90 * u))));
  }
  [[nodiscard]] QPointF at(double a, double b) const {
    const double right = x.max > x.min ? (x.shown(a) - x.min) / (x.max - x.min) : 0.5,
                 over = (y.shown(b) - y.min) / (y.max - y.min);
    return {plane.left() + right * plane.width(), plane.bottom() - over * plane.height()};
  }
  Page page;
  QRectF plane;
  AxisScale x, y;
};

/// Interrupted where a run has no value.
std::vector<std::vector<std::size_t>> pieces_of(const BandCurves::Curve& curve) {
  std::vector<std::vector<std::size_t>> pieces(1);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (is_drawable(curve.x[i]) && is_drawable(curve.y[i]))
      pieces.back().push_back(i);
    else if (!pieces.back().empty())
      pieces.emplace_back();
  }
  return pieces;
}

void paint_curve(const BandCurves::Curve& curve, const CurvesPlace& place, QPainter& painter,
                 const QColor& colour) {
  const double u = place.page.u;
  for (const std::vector<std::size_t>& piece : pieces_of(curve)) {
    if (piece.empty()) continue;
    const bool band = !curve.low.empty() && !curve.high.empty();
    if (band) {
      QPolygonF area;
      for (const std::size_t i : piece)
        if (is_drawable(curve.high[i])) area << place.at(curve.x[i], curve.high[i]);
      for (auto i = piece.rbegin(); i != piece.rend(); ++i)
        if (is_drawable(curve.low[*i])) area << place.at(curve.x[*i], curve.low[*i]);
      QColor pale = colour;
      pale.setAlpha(60);
      painter.setPen(Qt::NoPen);
      painter.setBrush(pale);
      painter.drawPolygon(area);
    }
    QPolygonF line;
    for (const std::size_t i : piece) line << place.at(curve.x[i], curve.y[i]);
    painter.setPen(QPen(colour, std::max(1.4, 2.4 * u)));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    constexpr std::size_t kDotted = 60;
    painter.setBrush(colour);
    if (piece.size() <= kDotted)
      for (const QPointF& p : line) painter.drawEllipse(p, 3.5 * u, 3.5 * u);
  }
}

void paint(const BandCurves& data, QPainter& painter, const QSizeF& size, const Theme& theme) {
  const CurvesPlace place(data, size);
  const QRectF& plane = place.plane;
  const AxisScale &x = place.x, &y = place.y;
  const double u = place.page.u;
  Sheet sheet(place.page, painter, theme, data.title);
  for (const AxisTick& tick : axis_ticks(x)) {
    const QPointF p = place.at(x.value(tick.at), y.value(y.min));
    sheet.line(p, {p.x(), plane.top()}, theme.grid, 1.0);
    sheet.label({p.x() - 60 * u, plane.bottom() + 6 * u, 120 * u, 22 * u}, Qt::AlignCenter,
                tick.text);
  }
  for (const AxisTick& tick : axis_ticks(y)) {
    const QPointF p = place.at(x.value(x.min), y.value(tick.at));
    sheet.line(p, {plane.right(), p.y()}, theme.grid, 1.0);
    sheet.label({44 * u, p.y() - 11 * u, 80 * u, 22 * u}, Qt::AlignRight | Qt::AlignVCenter,
                tick.text);
  }
  painter.setPen(QPen(theme.frame, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(plane);
  const double row = 26.0 * u;
  const auto most = static_cast<std::size_t>(std::max(1.0, plane.height() / row));
  for (std::size_t k = 0; k < data.curves.size(); ++k) {
    const QColor colour = theme.curves[k % theme.curves.size()];
    paint_curve(data.curves[k], place, painter, colour);
    if (data.curves.size() < 2 || k >= most) continue;
    const double top = plane.top() + row * static_cast<double>(k);
    painter.fillRect(QRectF(plane.right() + 16 * u, top + 10 * u, 24 * u, 4 * u), colour);
    const bool more = k + 1 == most && data.curves.size() > most;
    sheet.label({plane.right() + 48 * u, top, 194 * u, 24 * u}, Qt::AlignLeft | Qt::AlignVCenter,
                more ? "… and " + std::to_string(data.curves.size() - most + 1) + " more"
                     : data.curves[k].name);
  }
  const auto titled = [](const std::string& title, const AxisScale& axis) {
    std::string out = title_with_unit(title, axis.unit);
    if (!axis.offset_text.empty()) out += " − " + axis.offset_text;
    return out;
  };
  sheet.titles(plane, titled(data.x_title, x), titled(data.y_title, y));
}

Runs near(const BandCurves& data, const QSizeF& size, const QPointF& at) {
  const CurvesPlace place(data, size);
  double best = 14.0 * place.page.u;
  Runs out;
  for (const BandCurves::Curve& curve : data.curves)
    for (std::size_t i = 0; i < curve.x.size() && !curve.runs.empty(); ++i) {
      if (!is_drawable(curve.y[i])) continue;
      const QPointF gap = place.at(curve.x[i], curve.y[i]) - at;
      const double d = std::hypot(gap.x(), gap.y());
      if (d >= best) continue;
      best = d;
      out = curve.runs[i];
    }
  return out;
}

}  // namespace

void paint_study(const StudyChart& chart, QPainter& painter, const QSizeF& size,
                 const Theme& theme) {
  if (!chart.has_content()) return;
  painter.save();
  std::visit([&](const auto& of) { paint(of, painter, size, theme); }, chart.of);
  painter.restore();
}

Runs runs_at(const StudyChart& chart, const QSizeF& size, const QPointF& at) {
  if (!chart.has_content()) return {};
  return std::visit([&](const auto& of) { return near(of, size, at); }, chart.of);
}

}  // namespace adore::desktop
