#include "desktop/chart_scene.hpp"

#include "desktop/beyond_log.hpp"
#include "desktop/chart_scene_parts.hpp"
#include "desktop/study_picture.hpp"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace adore::desktop {

ChartScene::Metrics ChartScene::metrics() const {
  if (style_ == ChartStyle::Compact && size_.height() < kLowCompact)
    return {74, 14, 49, 40, 14, 16, 13, 11, 10, 1.4, 1.0};
  if (style_ == ChartStyle::Compact) return {74, 14, 46, 46, 26, 20, 13, 11, 10, 1.4, 1.0};
  const qreal note = noteHeight(28);
  return {86, 28, 66 + note, 54, 34, 22, 18, 13, 12, 1.6, 1.2};
}

QRectF ChartScene::space(const Metrics& m) const {
  return {m.left, m.top, size_.width() - m.left - m.right - colorBarWidth(m),
          size_.height() - m.top - m.bottom};
}

namespace {

/// Selectable ranges: of each panel, or of both axes of a page with equal axes.
std::size_t view_count(const ChartPage& page) { return page.equal_axes ? 2 : page.panels.size(); }

}  // namespace

ChartScene::ChartScene(ChartStyle style, QObject* parent)
    : QGraphicsScene(parent), style_(style), theme_(&current_theme()) {}

void ChartScene::setPage(ChartPage page, bool keep_view) {
  const bool same = keep_view && zoomed() && !page.equal_axes && !page_.equal_axes &&
                    page.x_title == page_.x_title && page.x_unit == page_.x_unit;
  const double low = low_, high = high_;
  page_ = std::move(page);
  panel_views_.assign(view_count(page_), std::nullopt);
  precomputeCurves();
  precomputePlaneCurves();
  computeCurveDigits();
  log_axis_note_ = log_axis_note(page_);
  const auto [first, last] = fullRange();
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

void ChartScene::setInteractive(bool interactive) {
  if (interactive == interactive_) return;
  interactive_ = interactive;
  if (!items().isEmpty()) rebuild();
}

void ChartScene::precomputeCurves() {
  constexpr std::size_t kLong = 8192;
  const std::vector<double>& x = page_.x;
  curve_blocks_.clear();
  equal_curves_cache_.clear();
  log_abscissa_.clear();
  if (page_.log_x)
    for (const double value : x) log_abscissa_.push_back(std::log10(value));
  abscissa_increasing_ =
      !page_.equal_axes && !x.empty() && std::is_sorted(x.begin(), x.end()) &&
      std::all_of(x.begin(), x.end(), [](double value) { return is_drawable(value); });
  if (!abscissa_increasing_ || x.size() < kLong) return;
  for (const ChartPanel& panel : page_.panels) {
    auto& of_panel = curve_blocks_.emplace_back();
    const auto study = [&](const std::vector<double>& values, bool wraps) {
      return values.size() == x.size() ? blocks_of(values, wraps) : CurveBlocks{};
    };
    for (const ChartCurve& curve : panel.curves)
      of_panel.push_back(
          {study(curve.y, panel.wraps), study(curve.low, false), study(curve.high, false)});
  }
}

std::pair<double, double> ChartScene::fullRange() const {
  if (abscissa_increasing_ && !page_.log_x) return {page_.x.front(), page_.x.back()};
  Extent extent;
  for (const double x : page_.x)
    if (!page_.log_x || x > 0.0) extent.include(x);
  if (extent.empty()) return {page_.log_x ? 1.0 : 0.0, page_.log_x ? 10.0 : 1.0};
  return {extent.low, extent.high};
}

std::pair<double, double> ChartScene::initialRange() const {
  if (!(page_.view_high > page_.view_low)) return fullRange();
  return {page_.log_x ? std::max(page_.view_low, fullRange().first) : page_.view_low,
          page_.view_high};
}

void ChartScene::resetView() {
  panel_views_.assign(view_count(page_), std::nullopt);
  std::tie(low_, high_) = initialRange();
  rebuild();
}

void ChartScene::showAll() {
  panel_views_.assign(view_count(page_), std::nullopt);
  std::tie(low_, high_) = fullRange();
  rebuild();
}

bool ChartScene::arePanelsUnzoomed() const {
  return std::none_of(panel_views_.begin(), panel_views_.end(),
                      [](const auto& range) { return range.has_value(); });
}

bool ChartScene::whole() const {
  return arePanelsUnzoomed() && (page_.equal_axes || std::pair(low_, high_) == fullRange());
}

bool ChartScene::zoomed() const {
  return !arePanelsUnzoomed() || (!page_.equal_axes && std::pair(low_, high_) != initialRange());
}

void ChartScene::setView(double low, double high) { setZoom({low, high, panel_views_}); }

void ChartScene::setZoom(const ChartZoom& zoom) {
  if (isPlane()) {
    panel_views_ = zoom.panels;
    panel_views_.resize(view_count(page_));
    const EqualAxesLayout seen = visiblePlaneLayout(fullPlaneLayout(metrics()));
    if (seen.enlarged > 1.0)
      panel_views_ = {std::pair(seen.middle_y - seen.half_y, seen.middle_y + seen.half_y),
                      std::pair(seen.middle_x - seen.half_x, seen.middle_x + seen.half_x)};
    else
      panel_views_.assign(view_count(page_), std::nullopt);
    rebuild();
    return;
  }
  if (page_.x.empty() || page_.equal_axes) return;
  // Spectra begin at 0, before their first line: that view is theirs, too.
  const auto [from, last] = fullRange();
  const double first = std::min(from, initialRange().first);
  const double smallest = (last - first) * kLeastPart;
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
  log_axis_note_ = log_axis_note(page_);
  rebuild();
}

QRectF ChartScene::everything() const {
  if (plot_areas_.empty()) return {};
  const QRectF& area = plot_areas_.front();
  if (isPlane()) {
    const EqualAxesLayout all = fullPlaneLayout(metrics());
    const qreal left = sceneXAt(all.middle_x - all.half_x),
                top = sceneYAt(0, all.middle_y + all.half_y);
    return {left, top, sceneXAt(all.middle_x + all.half_x) - left,
            sceneYAt(0, all.middle_y - all.half_y) - top};
  }
  if (page_.equal_axes) return area;
  const auto [from, last] = fullRange();
  const qreal left = sceneXAt(std::min(from, initialRange().first));
  return {left, area.top(), sceneXAt(last) - left, area.height()};
}

double ChartScene::abscissaAt(double scene_x) const {
  if (plot_areas_.empty()) return low_;
  const QRectF& area = plot_areas_.front();
  return x_axis_.value(x_axis_.min +
                       (scene_x - area.left()) / area.width() * (x_axis_.max - x_axis_.min));
}

double ChartScene::sceneXAt(double abscissa) const {
  if (plot_areas_.empty()) return 0.0;
  const QRectF& area = plot_areas_.front();
  return area.left() +
         (x_axis_.shown(abscissa) - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
}

double ChartScene::valueAt(std::size_t panel, double scene_y) const {
  const QRectF& area = plot_areas_.at(panel);
  const AxisScale& axis = y_axes_.at(panel);
  return axis.value(axis.min + (area.bottom() - scene_y) / area.height() * (axis.max - axis.min));
}

double ChartScene::sceneYAt(std::size_t panel, double value) const {
  const QRectF& area = plot_areas_.at(panel);
  const AxisScale& axis = y_axes_.at(panel);
  return area.bottom() - (axis.shown(value) - axis.min) / (axis.max - axis.min) * area.height();
}

std::optional<std::size_t> ChartScene::panelAt(QPointF position) const {
  for (std::size_t p = 0; p < plot_areas_.size(); ++p)
    if (plot_areas_[p].contains(position)) return p;
  return std::nullopt;
}

std::vector<long> ChartScene::runsAt(QPointF position) const {
  return page_.study ? runs_at(*page_.study, size_, position) : std::vector<long>();
}

namespace {

/// Is there text above a panel?
bool has_heads(const ChartPage& page) {
  return std::any_of(page.panels.begin(), page.panels.end(),
                     [](const ChartPanel& panel) { return !panel.rows; });
}

}  // namespace

void ChartScene::rebuild() {
  build();
  if (page_.band_note.empty() || bands_visible_ == band_note_visible_) return;
  // The note needs some of the height of the panels: only what is visible without it is described.
  band_note_visible_ = !band_note_visible_;
  build();
  if (band_note_visible_ || !bands_visible_) return;
  band_note_visible_ = true;
  build();
}

void ChartScene::build() {
  bands_visible_ = false;
  clear();
  lines_.clear();
  plot_areas_.clear();
  y_axes_.clear();
  axis_cache_.assign(page_.panels.size(), std::nullopt);
  legend_.clear();
  setSceneRect(QRectF(QPointF(0, 0), size_));
  setBackgroundBrush(theme_->surface);
  if (page_.study) {
    addItem(new StudyPicture(page_.study, *theme_, size_));
    return;
  }
  constexpr qreal kLabelWidth = 45.0;  // width of a number next to others [px]
  Metrics m = metrics();
  addHeading(m);
  const QRectF space = this->space(m);
  if (page_.panels.empty()) {
    if (!page_.note.empty()) addMessage(space, text_of(page_.note), m);
    return;
  }
  if (page_.equal_axes) {
    addOrbit(m);
    return;
  }
  x_axis_ = page_.log_x ? log_axis(low_, high_, page_.x_unit, true, space.width() / kLabelWidth)
                        : tight_axis(low_, high_, page_.x_unit,
                                     std::max(2, static_cast<int>(space.width() / 110)));
  const auto count = static_cast<qreal>(page_.panels.size());
  const qreal rise = mark_labels_height(page_, m.tick_font, size_.width());
  const qreal legend = has_heads(page_) ? m.legend : 0.0;
  const auto share = [&] { return (space.height() - m.gap * (count - 1) - legend - rise) / count; };
  // Low panels of a small picture need the room between them more than the eye does.
  constexpr qreal kLow = 24.0, kLeastGap = 14.0;
  if (style_ == ChartStyle::Compact && share() < kLow) m.gap = std::min(m.gap, kLeastGap);
  const qreal height = share();
  for (std::size_t i = 0; i < page_.panels.size(); ++i) {
    const QRectF area(space.left(),
                      space.top() + legend + rise + static_cast<qreal>(i) * (height + m.gap),
                      space.width(), height);
    addPanel(i, area, i + 1 == page_.panels.size(), m);
  }
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
  const bool before = interactive_;
  setInteractive(false);
  QPainter painter(&image);
  paintPage(painter, QRectF(QPointF(0, 0), QSizeF(size)));
  setInteractive(before);
  return image;
}

}  // namespace adore::desktop
