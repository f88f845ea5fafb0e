#include "desktop/study_chart.hpp"

#include "desktop/axis_scale.hpp"
#include "desktop/image_export.hpp"
#include "desktop/theme.hpp"

#include <QFontMetrics>
#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace adore::desktop {
namespace {

constexpr int kWidth = 1280, kHeight = 800;
constexpr int kLabel = 15, kHeading = 20;  // [px]

QString text_of(const std::string& text) { return QString::fromStdString(text); }

/// A white sheet with a title; saved when it is left with something on it.
class Sheet {
 public:
  explicit Sheet(const std::string& title)
      : image_(kWidth, kHeight, QImage::Format_RGB32), colours_(theme(ThemeKind::Light)) {
    image_.fill(colours_.surface);
    painter_.begin(&image_);
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setFont(ui_font(kHeading, true));
    painter_.setPen(colours_.text);
    painter_.drawText(QRectF(20, 12, kWidth - 40, 34), Qt::AlignCenter, text_of(title));
    painter_.setFont(ui_font(kLabel));
  }
  [[nodiscard]] QPainter& painter() { return painter_; }
  [[nodiscard]] const Theme& colours() const { return colours_; }

  void label(const QRectF& box, int flags, const std::string& text) {
    painter_.setPen(colours_.text);
    painter_.drawText(box, flags, text_of(text));
  }
  /// Below the plane, and to its left from bottom to top.
  void titles(const QRectF& plane, const std::string& across, const std::string& up) {
    label({plane.left(), kHeight - 44.0, plane.width(), 30}, Qt::AlignCenter, across);
    painter_.save();
    painter_.translate(28, plane.center().y());
    painter_.rotate(-90);
    label({-plane.height() / 2, -16, plane.height(), 32}, Qt::AlignCenter, up);
    painter_.restore();
  }
  void save(const std::filesystem::path& file) {
    painter_.end();
    save_image(image_, file);
  }

 private:
  QImage image_;
  const Theme& colours_;
  QPainter painter_;
};

struct Extent {
  double low = std::numeric_limits<double>::infinity(),
         high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!is_drawable(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool any() const { return low <= high; }
};

/// Dark blue over green to yellow: rises in lightness, so that it reads in grey too.
QColor heat_colour(double share) {
  constexpr std::array<std::array<double, 3>, 5> kStops{
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(below);
  std::array<int, 3> rgb{};
  for (std::size_t k = 0; k < 3; ++k)
    rgb[k] = static_cast<int>(
        std::lround((1.0 - part) * kStops[below][k] + part * kStops[below + 1][k]));
  return {rgb[0], rgb[1], rgb[2]};
}

std::string with_unit(const std::string& title, const std::string& unit) {
  return unit.empty() ? title : title + " [" + unit + "]";
}

}  // namespace

bool save_picture(const HeatMap& map, const std::filesystem::path& file) {
  Extent extent;
  for (const auto& row : map.values)
    for (const double value : row) extent.add(value);
  if (!extent.any() || map.x.empty() || map.y.empty()) return false;
  Sheet sheet(map.title);
  QPainter& painter = sheet.painter();
  const QRectF plane(130, 70, 950, 640);
  const double w = plane.width() / static_cast<double>(map.x.size()),
               h = plane.height() / static_cast<double>(map.y.size());
  const double span = extent.high > extent.low ? extent.high - extent.low : 1.0;
  for (std::size_t j = 0; j < map.y.size(); ++j)
    for (std::size_t i = 0; i < map.x.size(); ++i) {
      const QRectF cell(plane.left() + w * static_cast<double>(i),
                        plane.bottom() - h * static_cast<double>(j + 1), w, h);
      const double value = map.values[j][i];
      const double share = (value - extent.low) / span;
      painter.fillRect(cell,
                       is_drawable(value) ? heat_colour(share) : QColor(sheet.colours().grid));
      painter.setPen(QPen(sheet.colours().surface, 1.0));
      painter.drawRect(cell);
      painter.setPen(share > 0.6 ? QColor(Qt::black) : QColor(Qt::white));
      if (!is_drawable(value)) painter.setPen(sheet.colours().muted);
      QString text = is_drawable(value) ? text_of(pretty_number(value, 3)) : QString("none");
      if (!map.marks.empty() && !map.marks[j][i].empty()) text += "\n" + text_of(map.marks[j][i]);
      if (w > 50.0 && h > 24.0) painter.drawText(cell, Qt::AlignCenter, text);
    }
  for (std::size_t i = 0; i < map.x.size(); ++i)
    sheet.label({plane.left() + w * static_cast<double>(i), plane.bottom() + 6, w, 22},
                Qt::AlignCenter, pretty_number(map.x[i]));
  for (std::size_t j = 0; j < map.y.size(); ++j)
    sheet.label({50, plane.bottom() - h * static_cast<double>(j + 1), 74, h},
                Qt::AlignRight | Qt::AlignVCenter, pretty_number(map.y[j]));
  sheet.titles(plane, map.x_title, map.y_title);
  const QRectF scale(1120, plane.top() + 40, 28, plane.height() - 80);
  for (int k = 0; k < static_cast<int>(scale.height()); ++k)
    painter.fillRect(QRectF(scale.left(), scale.bottom() - k - 1, scale.width(), 1.5),
                     heat_colour(k / scale.height()));
  const AxisScale axis = tight_axis(extent.low, extent.high, map.unit, 6);
  for (const AxisTick& tick : axis_ticks(axis)) {
    const double y = scale.bottom() - (axis.value(tick.at) - extent.low) / span * scale.height();
    sheet.label({scale.right() + 6, y - 11, 110, 22}, Qt::AlignLeft | Qt::AlignVCenter, tick.text);
  }
  sheet.label({scale.left() - 40, plane.top(), 200, 30}, Qt::AlignLeft | Qt::AlignVCenter,
              with_unit(map.legend, axis.unit));
  sheet.save(file);
  return true;
}

bool save_picture(const ParallelLines& lines, const std::filesystem::path& file) {
  if (lines.axes.size() < 2 || lines.rows.empty()) return false;
  std::vector<Extent> extents(lines.axes.size());
  for (const auto& row : lines.rows)
    for (std::size_t k = 0; k < row.size(); ++k) extents[k].add(row[k]);
  Sheet sheet(lines.title);
  QPainter& painter = sheet.painter();
  const QRectF plane(110, 120, kWidth - 220, 590);
  const double gap = plane.width() / static_cast<double>(lines.axes.size() - 1);
  const auto place = [&](std::size_t k, double value) {
    const double span = extents[k].high - extents[k].low;
    const double share = span > 0.0 ? (value - extents[k].low) / span : 0.5;
    return QPointF(plane.left() + gap * static_cast<double>(k),
                   plane.bottom() - share * plane.height());
  };
  const std::size_t last = lines.axes.size() - 1;
  const auto draw = [&](std::size_t i, double width, int alpha) {
    const auto& row = lines.rows[i];
    const double span = extents[last].high - extents[last].low;
    QColor colour =
        is_drawable(row[last])
            ? heat_colour(span > 0.0 ? 0.9 * (row[last] - extents[last].low) / span : 0.5)
            : QColor(sheet.colours().frame);
    colour.setAlpha(alpha);
    painter.setPen(QPen(colour, width));
    for (std::size_t k = 0; k + 1 < row.size(); ++k)
      if (is_drawable(row[k]) && is_drawable(row[k + 1]))
        painter.drawLine(place(k, row[k]), place(k + 1, row[k + 1]));
  };
  constexpr std::size_t kSolid = 200;  // rows; more of them are drawn paler
  const int alpha = static_cast<int>(std::clamp(
      200.0 * static_cast<double>(kSolid) / static_cast<double>(lines.rows.size()), 30.0, 200.0));
  for (std::size_t i = 0; i < lines.rows.size(); ++i) draw(i, 1.4, alpha);
  if (lines.heavy >= 0) draw(static_cast<std::size_t>(lines.heavy), 4.0, 255);
  for (std::size_t k = 0; k < lines.axes.size(); ++k) {
    const double x = plane.left() + gap * static_cast<double>(k);
    painter.setPen(QPen(sheet.colours().text, 1.5));
    painter.drawLine(QPointF(x, plane.top()), QPointF(x, plane.bottom()));
    const double width = std::max(90.0, gap);
    painter.setPen(sheet.colours().text);
    painter.drawText(QRectF(x - width / 2, k % 2 == 0 ? 48 : 70, width, 24), Qt::AlignCenter,
                     QFontMetrics(painter.font())
                         .elidedText(text_of(lines.axes[k]), Qt::ElideMiddle,
                                     static_cast<int>(std::min(2.0 * gap, 400.0))));
    if (!extents[k].any()) continue;
    sheet.label({x - width / 2, plane.bottom() + 6, width, 22}, Qt::AlignCenter,
                pretty_number(extents[k].low, 3));
    sheet.label({x - width / 2, plane.top() - 22, width, 22}, Qt::AlignCenter,
                pretty_number(extents[k].high, 3));
  }
  sheet.label({20, kHeight - 44.0, kWidth - 40.0, 30}, Qt::AlignCenter,
              "one line per run; dark to bright: low to high in the last column");
  sheet.save(file);
  return true;
}

bool save_picture(const Tornado& tornado, const std::filesystem::path& file) {
  std::vector<Tornado::Bar> bars;
  for (const Tornado::Bar& bar : tornado.bars)
    if (is_drawable(bar.value)) bars.push_back(bar);
  if (bars.empty()) return false;
  std::stable_sort(bars.begin(), bars.end(), [](const auto& a, const auto& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  constexpr std::size_t kMost = 20;
  if (bars.size() > kMost) bars.resize(kMost);
  double size = 0.0;
  for (const Tornado::Bar& bar : bars)
    size = std::max(size, std::abs(bar.value) + (is_drawable(bar.doubt) ? bar.doubt : 0.0));
  if (!(size > 0.0)) size = 1.0;
  Sheet sheet(tornado.title);
  QPainter& painter = sheet.painter();
  const QRectF plane(260, 70, kWidth - 360.0, 640);
  const AxisScale axis = value_axis(-1.15 * size, 1.15 * size, "", 8);
  const auto x_of = [&](double value) {
    return plane.left() + (axis.shown(value) - axis.min) / (axis.max - axis.min) * plane.width();
  };
  for (const AxisTick& tick : axis_ticks(axis)) {
    const double x = x_of(axis.value(tick.at));
    painter.setPen(QPen(sheet.colours().grid, 1.0));
    painter.drawLine(QPointF(x, plane.top()), QPointF(x, plane.bottom()));
    sheet.label({x - 50, plane.bottom() + 6, 100, 22}, Qt::AlignCenter, tick.text);
  }
  const double h = std::min(56.0, plane.height() / static_cast<double>(bars.size()));
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double y = plane.top() + h * static_cast<double>(i);
    const double from = x_of(0.0), to = x_of(bars[i].value);
    painter.fillRect(QRectF(std::min(from, to), y + 0.15 * h, std::abs(to - from), 0.7 * h),
                     bars[i].value < 0.0 ? sheet.colours().curves[1] : sheet.colours().curves[0]);
    if (bars[i].doubt > 0.0 && is_drawable(bars[i].doubt)) {
      painter.setPen(QPen(sheet.colours().text, 2.0));
      painter.drawLine(QPointF(x_of(bars[i].value - bars[i].doubt), y + 0.5 * h),
                       QPointF(x_of(bars[i].value + bars[i].doubt), y + 0.5 * h));
    }
    sheet.label({20, y, 230, h}, Qt::AlignRight | Qt::AlignVCenter, bars[i].name);
    const bool right = bars[i].value >= 0.0;
    sheet.label(right ? QRectF(to + 8, y, 120, h) : QRectF(to - 128, y, 120, h),
                (right ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
                pretty_number(bars[i].value, 3));
  }
  painter.setPen(QPen(sheet.colours().text, 1.5));
  painter.drawLine(QPointF(x_of(0.0), plane.top()), QPointF(x_of(0.0), plane.bottom()));
  sheet.titles(plane, with_unit(tornado.x_title, axis.unit), "");
  sheet.save(file);
  return true;
}

bool save_picture(const BandCurves& data, const std::filesystem::path& file) {
  Extent across, up;
  for (const BandCurves::Curve& curve : data.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!is_drawable(curve.y[i])) continue;
      across.add(curve.x[i]);
      up.add(curve.y[i]);
      if (!curve.low.empty()) up.add(curve.low[i]);
      if (!curve.high.empty()) up.add(curve.high[i]);
    }
  if (!across.any() || !up.any()) return false;
  Sheet sheet(data.title);
  QPainter& painter = sheet.painter();
  const QRectF plane(130, 70, data.curves.size() > 1 ? 900 : 1090, 640);
  const AxisScale x = tight_axis(across.low, across.high, data.x_unit, 8),
                  y = value_axis(up.low, up.high, data.y_unit, 7);
  const auto at = [&](double a, double b) {
    const double right = x.max > x.min ? (x.shown(a) - x.min) / (x.max - x.min) : 0.5,
                 over = (y.shown(b) - y.min) / (y.max - y.min);
    return QPointF(plane.left() + right * plane.width(), plane.bottom() - over * plane.height());
  };
  for (const AxisTick& tick : axis_ticks(x)) {
    const QPointF p = at(x.value(tick.at), y.value(y.min));
    painter.setPen(QPen(sheet.colours().grid, 1.0));
    painter.drawLine(p, QPointF(p.x(), plane.top()));
    sheet.label({p.x() - 60, plane.bottom() + 6, 120, 22}, Qt::AlignCenter, tick.text);
  }
  for (const AxisTick& tick : axis_ticks(y)) {
    const QPointF p = at(x.value(x.min), y.value(tick.at));
    painter.setPen(QPen(sheet.colours().grid, 1.0));
    painter.drawLine(p, QPointF(plane.right(), p.y()));
    sheet.label({44, p.y() - 11, 80, 22}, Qt::AlignRight | Qt::AlignVCenter, tick.text);
  }
  painter.setPen(QPen(sheet.colours().frame, 1.0));
  painter.drawRect(plane);
  std::size_t number = 0;
  for (const BandCurves::Curve& curve : data.curves) {
    const QColor colour = sheet.colours().curves[number % sheet.colours().curves.size()];
    // Broken where a run has no value.
    std::vector<std::vector<std::size_t>> pieces(1);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (is_drawable(curve.y[i]))
        pieces.back().push_back(i);
      else if (!pieces.back().empty())
        pieces.emplace_back();
    }
    for (const std::vector<std::size_t>& piece : pieces) {
      if (piece.empty()) continue;
      if (!curve.low.empty()) {
        QPolygonF band;
        for (const std::size_t i : piece) band << at(curve.x[i], curve.high[i]);
        for (auto i = piece.rbegin(); i != piece.rend(); ++i)
          band << at(curve.x[*i], curve.low[*i]);
        QColor pale = colour;
        pale.setAlpha(50);
        painter.setPen(Qt::NoPen);
        painter.setBrush(pale);
        painter.drawPolygon(band);
      }
      QPolygonF line;
      for (const std::size_t i : piece) line << at(curve.x[i], curve.y[i]);
      painter.setPen(QPen(colour, 2.4));
      painter.setBrush(Qt::NoBrush);
      painter.drawPolyline(line);
      constexpr std::size_t kDotted = 60;
      painter.setBrush(colour);
      if (piece.size() <= kDotted)
        for (const QPointF& p : line) painter.drawEllipse(p, 3.5, 3.5);
    }
    if (data.curves.size() > 1 && number < 24) {
      const double top = plane.top() + 26.0 * static_cast<double>(number);
      painter.fillRect(QRectF(1050, top + 10, 24, 4), colour);
      sheet.label({1082, top, 190, 24}, Qt::AlignLeft | Qt::AlignVCenter, curve.name);
    }
    ++number;
  }
  const auto titled = [](const std::string& title, const AxisScale& axis) {
    std::string out = with_unit(title, axis.unit);
    if (!axis.offset_text.empty()) out += " − " + axis.offset_text;
    return out;
  };
  sheet.titles(plane, titled(data.x_title, x), titled(data.y_title, y));
  sheet.save(file);
  return true;
}

}  // namespace adore::desktop
