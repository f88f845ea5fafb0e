#include "desktop/chart_scene_parts.hpp"
#include "desktop/heat_color.hpp"

#include <QApplication>
#include <QFontMetricsF>
#include <QGraphicsItem>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

/// Maps: the curves of a panel as rows of colors.
namespace adore::desktop {
namespace {

constexpr qreal kBarGap = 16.0, kBarWidth = 14.0, kLabelGap = 6.0;

class PictureItem : public QGraphicsItem {
 public:
  PictureItem(QImage image, const QRectF& area) : image_(std::move(image)), area_(area) {}
  [[nodiscard]] QRectF boundingRect() const override { return area_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    painter->drawImage(area_, image_);
  }

 private:
  QImage image_;
  QRectF area_;
};

/// Stored places that a pixel shows, [first, last]: all with their place in it, so that no peak is
/// lost, else the one whose color reaches it. `first` > `last`: none.
struct PixelRange {
  std::size_t first = 1, last = 0;
  [[nodiscard]] bool any() const { return first <= last; }
  bool operator==(const PixelRange&) const = default;
};

/// @param shown values of the axis, increasing
std::vector<PixelRange> pixel_ranges(const std::vector<double>& shown, double low, double high,
                                     int pixels) {
  std::vector<PixelRange> out(static_cast<std::size_t>(pixels));
  const std::vector<double> limits = cell_edges(shown);
  const double width = (high - low) / pixels;
  for (int p = 0; p < pixels; ++p) {
    const double from = low + width * p, to = from + width, middle = from + 0.5 * width;
    const auto first = std::lower_bound(shown.begin(), shown.end(), from) - shown.begin();
    const auto behind = std::lower_bound(shown.begin(), shown.end(), to) - shown.begin();
    PixelRange& range = out[static_cast<std::size_t>(p)];
    if (behind > first) {
      range = {static_cast<std::size_t>(first), static_cast<std::size_t>(behind - 1)};
    } else if (middle >= limits.front() && middle < limits.back()) {
      const auto one = std::upper_bound(limits.begin(), limits.end(), middle) - limits.begin() - 1;
      range = {static_cast<std::size_t>(one), static_cast<std::size_t>(one)};
    }
  }
  return out;
}

std::vector<double> shown_values(const std::vector<double>& values, const AxisScale& axis) {
  std::vector<double> out;
  for (const double value : values) out.push_back(axis.shown(value));
  return out;
}

double largest_of(const std::vector<ChartCurve>& rows, const PixelRange& up,
                  const PixelRange& across) {
  double out = -std::numeric_limits<double>::infinity();
  for (std::size_t r = up.first; r <= up.last; ++r)
    for (std::size_t k = across.first; k <= std::min(across.last, rows[r].y.size() - 1); ++k)
      out = std::max(out, rows[r].y[k]);
  return out;
}

/// The colors of a map between two values.
class ColorScale {
 public:
  ColorScale(double low, double high) : low_(low), high_(high > low ? high : low + 1.0) {
    for (std::size_t i = 0; i < colors_.size(); ++i)
      colors_.at(i) = heat_color(static_cast<double>(i) / (colors_.size() - 1)).rgb();
  }
  [[nodiscard]] QRgb of(double value) const {
    const double share = std::clamp((value - low_) / (high_ - low_), 0.0, 1.0);
    return colors_.at(static_cast<std::size_t>(std::lround(share * (colors_.size() - 1))));
  }

 private:
  double low_, high_;
  std::array<QRgb, 256> colors_{};
};

AxisScale bar_axis(const ChartPanel& panel, int parts) {
  return tight_axis(panel.rows->low, panel.rows->high, panel.unit, parts);
}

qreal label_width(const AxisScale& axis, const QFontMetricsF& metrics) {
  qreal out = 0.0;
  for (const AxisTick& tick : axis_ticks(axis))
    out = std::max(out, metrics.horizontalAdvance(text_of(tick.text)));
  return out;
}

int bar_parts(qreal height) { return std::clamp(static_cast<int>(height / 38), 2, 8); }

}  // namespace

qreal ChartScene::colorBarWidth(const Metrics& m) const {
  const QFontMetricsF metrics(ui_font(m.tick_font));
  qreal out = 0.0;
  for (const ChartPanel& panel : page_.panels)
    if (panel.rows)
      out = std::max(out, kBarGap + kBarWidth + 2.0 * kLabelGap +
                              label_width(bar_axis(panel, bar_parts(size_.height())), metrics) +
                              QFontMetricsF(ui_font(m.text_font)).height() - 0.5 * m.right);
  return out;
}

void ChartScene::addMapRows(const ChartPanel& panel, const QRectF& area, const AxisScale& y_axis,
                            const Metrics& m) {
  const ChartMapRows& rows = *panel.rows;
  // Saved pictures are finer than a screen.
  const double finer = interactive_ ? std::max(1.0, qApp->devicePixelRatio()) : 2.0;
  const QSize size(std::max(1, static_cast<int>(std::lround(area.width() * finer))),
                   std::max(1, static_cast<int>(std::lround(area.height() * finer))));
  const auto across =
      pixel_ranges(shown_values(page_.x, x_axis_), x_axis_.min, x_axis_.max, size.width());
  const auto up =
      pixel_ranges(shown_values(rows.at, y_axis), y_axis.min, y_axis.max, size.height());
  const ColorScale colors(rows.low, rows.high);
  QImage image(size, QImage::Format_RGB32);
  image.fill(theme_->surface);
  for (int line = 0; line < size.height(); ++line) {
    const PixelRange& of = up[static_cast<std::size_t>(line)];
    auto* pixels = reinterpret_cast<QRgb*>(image.scanLine(size.height() - 1 - line));
    if (line > 0 && of == up[static_cast<std::size_t>(line - 1)]) {
      const auto* before = reinterpret_cast<const QRgb*>(image.constScanLine(size.height() - line));
      std::copy_n(before, size.width(), pixels);
      continue;
    }
    for (int p = 0; of.any() && p < size.width(); ++p)
      if (const PixelRange& k = across[static_cast<std::size_t>(p)]; k.any())
        if (const double value = largest_of(panel.curves, of, k); std::isfinite(value))
          pixels[p] = colors.of(value);
  }
  addItem(new PictureItem(std::move(image), area));
  // The color bar.
  const QRectF bar(area.right() + kBarGap, area.top(), kBarWidth, area.height());
  constexpr int kShades = 256;
  QImage shades(1, kShades, QImage::Format_RGB32);
  for (int i = 0; i < kShades; ++i)
    shades.setPixel(0, kShades - 1 - i,
                    colors.of(rows.low + (rows.high - rows.low) * i / (kShades - 1)));
  addItem(new PictureItem(std::move(shades), bar));
  const AxisScale axis = bar_axis(panel, bar_parts(area.height()));
  const QFont font = ui_font(m.tick_font);
  const QFontMetricsF metrics(font);
  for (const AxisTick& tick : axis_ticks(axis)) {
    const qreal y = bar.bottom() - (tick.at - axis.min) / (axis.max - axis.min) * bar.height();
    auto* label = addSimpleText(text_of(tick.text), font);
    label->setBrush(theme_->muted);
    label->setPos(bar.right() + kLabelGap, y - 0.5 * metrics.height());
  }
  const QFont title_font = ui_font(m.text_font);
  const QFontMetricsF title_metrics(title_font);
  const QString text =
      title_metrics.elidedText(with_unit_and_offset(text_of(rows.value_title), axis),
                               Qt::ElideRight, available_title_length(area, m.gap));
  auto* title = addSimpleText(text, title_font);
  title->setBrush(theme_->text);
  title->setRotation(-90);
  title->setPos(bar.right() + 2.0 * kLabelGap + label_width(axis, metrics) - 2.0,
                area.center().y() + 0.5 * title_metrics.horizontalAdvance(text));
}

std::optional<std::size_t> ChartScene::mapRowAt(QPointF position) const {
  const auto panel = panelAt(position);
  if (!panel || !page_.panels.at(*panel).rows) return std::nullopt;
  const std::vector<double>& at = page_.panels[*panel].rows->at;
  const std::vector<double> limits = cell_edges(at);
  const double value = valueAt(*panel, position.y());
  if (at.empty() || value < limits.front() || value > limits.back()) return std::nullopt;
  const auto behind = std::upper_bound(limits.begin(), limits.end(), value) - limits.begin();
  return std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(behind, 1) - 1), at.size() - 1);
}

}  // namespace adore::desktop
