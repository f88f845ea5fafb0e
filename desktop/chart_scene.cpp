#include "desktop/chart_scene.hpp"

#include "desktop/beyond_log.hpp"
#include "desktop/chart_scene_parts.hpp"
#include "desktop/study_picture.hpp"

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace adore::desktop {

ChartScene::Metrics ChartScene::metrics() const {
  constexpr qreal kLow = 190.0;  // then panels need the room between words
  if (style_ == ChartStyle::Compact && size_.height() < kLow)
    return {74, 14, 44, 40, 14, 16, 13, 11, 10, 1.4, 1.0};
  if (style_ == ChartStyle::Compact) return {74, 14, 46, 46, 26, 20, 13, 11, 10, 1.4, 1.0};
  const qreal note = noteHeight(28);
  return {86, 28, 66 + note, 54, 34, 22, 18, 13, 12, 1.6, 1.2};
}

QRectF ChartScene::space(const Metrics& m) const {
  return {m.left, m.top, size_.width() - m.left - m.right - lineNamesWidth(m),
          size_.height() - m.top - m.bottom};
}

qreal ChartScene::lineNamesWidth(const Metrics& m) const {
  const QFontMetricsF metrics(ui_font(m.tick_font));
  qreal out = 0.0;
  for (const ChartPanel& panel : page_.panels)
    for (const ChartCurve& curve : panel.curves)
      if (panel.one_colour && !curve.name.empty())
        out = std::max(
            out, metrics.horizontalAdvance(text_of(curve.name)) + kLineNameGap - m.right + 4.0);
  return std::max(out, 0.0);
}

namespace {

/// Ranges that can be chosen: of each panel, or of both axes of a page where they are equal.
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
  studyCurves();
  studyPlane();
  studyDigits();
  beyond_log_ = beyond_log_axes(page_);
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

void ChartScene::setPointed(bool pointed) {
  if (pointed == pointed_) return;
  pointed_ = pointed;
  if (!items().isEmpty()) rebuild();
}

void ChartScene::studyCurves() {
  constexpr std::size_t kLong = 8192;
  const std::vector<double>& x = page_.x;
  blocks_.clear();
  equal_runs_.clear();
  decades_.clear();
  if (page_.log_x)
    for (const double value : x) decades_.push_back(std::log10(value));
  rising_ = !page_.equal_axes && !x.empty() && std::is_sorted(x.begin(), x.end()) &&
            std::all_of(x.begin(), x.end(), [](double value) { return is_drawable(value); });
  if (!rising_ || x.size() < kLong) return;
  for (const ChartPanel& panel : page_.panels) {
    auto& of_panel = blocks_.emplace_back();
    const auto study = [&](const std::vector<double>& values, bool wraps) {
      return values.size() == x.size() ? blocks_of(values, wraps) : CurveBlocks{};
    };
    for (const ChartCurve& curve : panel.curves)
      of_panel.push_back(
          {study(curve.y, panel.wraps), study(curve.low, false), study(curve.high, false)});
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

std::pair<double, double> ChartScene::firstRange() const {
  if (!(page_.view_high > page_.view_low)) return wholeRange();
  return {page_.log_x ? std::max(page_.view_low, wholeRange().first) : page_.view_low,
          page_.view_high};
}

void ChartScene::resetView() {
  panel_views_.assign(view_count(page_), std::nullopt);
  std::tie(low_, high_) = firstRange();
  rebuild();
}

void ChartScene::showAll() {
  panel_views_.assign(view_count(page_), std::nullopt);
  std::tie(low_, high_) = wholeRange();
  rebuild();
}

bool ChartScene::panelsWhole() const {
  return std::none_of(panel_views_.begin(), panel_views_.end(),
                      [](const auto& range) { return range.has_value(); });
}

bool ChartScene::whole() const {
  return panelsWhole() && (page_.equal_axes || std::pair(low_, high_) == wholeRange());
}

bool ChartScene::zoomed() const {
  return !panelsWhole() || (!page_.equal_axes && std::pair(low_, high_) != firstRange());
}

void ChartScene::setView(double low, double high) { setZoom({low, high, panel_views_}); }

void ChartScene::setZoom(const ChartZoom& zoom) {
  if (isPlane()) {
    panel_views_ = zoom.panels;
    panel_views_.resize(view_count(page_));
    const Plane seen = seenPlane(wholePlane(metrics()));
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
  const auto [from, last] = wholeRange();
  const double first = std::min(from, firstRange().first);
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
  beyond_log_ = beyond_log_axes(page_);
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

namespace {

/// "outer race 400 N", "land 1: 400 N".
QString told(const std::string& name, const QString& value) {
  const bool number = !name.empty() && name.back() >= '0' && name.back() <= '9';
  return text_of(name) + (number ? ": " : " ") + value;
}

}  // namespace

namespace {

constexpr int kDigits = 5;

/// So many more digits as a range has fewer of than its largest number.
int digits_for(double low, double high) {
  constexpr int kMost = 12;
  const double largest = std::max(std::abs(low), std::abs(high));
  if (!(high > low) || !std::isfinite(largest)) return kDigits;
  const int more = static_cast<int>(std::floor(std::log10(largest / (high - low))));
  return std::clamp(kDigits + more, kDigits, kMost);
}

}  // namespace

void ChartScene::studyDigits() {
  digits_.clear();
  for (const ChartPanel& panel : page_.panels) {
    auto& of_panel = digits_.emplace_back();
    for (const ChartCurve& curve : panel.curves) {
      Extent extent;
      for (const double v : curve.y) extent.include(v);
      of_panel.push_back(
          extent.empty() ? kDigits : digits_for(extent.low - curve.lift, extent.high - curve.lift));
    }
  }
}

int ChartScene::digitsOf(std::size_t panel, std::size_t curve) const {
  // A panel without curves has places under the pointer, too.
  if (panel >= digits_.size() || curve >= digits_[panel].size()) return kDigits;
  int digits = digits_[panel][curve];
  if (panel < y_axes_.size() && !y_axes_[panel].log) {
    const AxisScale& axis = y_axes_[panel];
    digits = std::max(digits, digits_for(axis.value(axis.min), axis.value(axis.max)));
  }
  return digits;
}

QString ChartScene::bandAt(std::size_t panel, std::size_t index, std::size_t place) const {
  const ChartPanel& of = page_.panels[panel];
  const ChartCurve& curve = of.curves[index];
  if (place >= curve.low.size() || place >= curve.high.size()) return {};
  const auto text = [&](double v) {
    return text_of(pretty_quantity(v - curve.lift, of.unit, digitsOf(panel, index)));
  };
  const QString low = text(curve.low[place]), high = text(curve.high[place]);
  const bool known = std::isfinite(curve.low[place]) && std::isfinite(curve.high[place]);
  return known && low != high ? tr(" (%1 to %2)").arg(low, high) : QString();
}

QStringList ChartScene::readoutParts(QPointF position) const {
  if (const std::vector<long> runs = runsAt(position); !runs.empty())
    return {
        runs.size() == 1
            ? tr("run %1: a click shows it").arg(runs.front())
            : tr("%1 runs, %2 the first: a click shows them").arg(runs.size()).arg(runs.front())};
  if (isPlane()) return planeReadout(position);
  if (page_.equal_axes || page_.x.empty() || !panelAt(position)) return {};
  const std::size_t i = nearest_index(page_.x, abscissaAt(position.x()));
  const QString place = text_of(pretty_quantity(page_.x[i], page_.x_unit, 5)) + ":";
  QStringList parts;
  for (std::size_t p = 0; p < page_.panels.size(); ++p) {
    const ChartPanel& panel = page_.panels[p];
    bool first = true;
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
      const ChartCurve& curve = panel.curves[c];
      if (i >= curve.y.size() || curve.hidden) continue;
      QString value = text_of(pretty_quantity(curve.value(i), panel.unit, digitsOf(p, c)));
      value += bandAt(p, c, i);
      QString part = curve.name.empty() ? value : told(curve.name, value);
      const bool titled = page_.panels.size() > 1 || panel.curves.front().name.empty();
      const bool named = !panel.curves.front().name.empty();
      if (first && titled)
        part = named ? text_of(panel.title) + " " + part : told(panel.title, part);
      parts << (first ? "   " : ", ") + part;
      first = false;
    }
  }
  if (parts.isEmpty()) return {place};
  parts.front().prepend(place);
  return parts;
}

QString ChartScene::readout(QPointF position) const { return readoutParts(position).join(""); }

void ChartScene::rebuild() {
  clear();
  lines_.clear();
  areas_.clear();
  y_axes_.clear();
  found_axes_.assign(page_.panels.size(), std::nullopt);
  legend_.clear();
  setSceneRect(QRectF(QPointF(0, 0), size_));
  setBackgroundBrush(theme_->surface);
  if (page_.study) {
    addItem(new StudyPicture(page_.study, *theme_, size_));
    return;
  }
  constexpr qreal kLabelWidth = 45.0;  // of a number beside others [px]
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
  const qreal rise = mark_rise(page_, m.tick_font, size_.width());
  const auto share = [&] {
    return (space.height() - m.gap * (count - 1) - m.legend - rise) / count;
  };
  // Low panels of a small picture need the room between them more than the eye does.
  constexpr qreal kLow = 24.0, kLeastGap = 14.0;
  if (style_ == ChartStyle::Compact && share() < kLow) m.gap = std::min(m.gap, kLeastGap);
  const qreal height = share();
  for (std::size_t i = 0; i < page_.panels.size(); ++i) {
    const QRectF area(space.left(),
                      space.top() + m.legend + rise + static_cast<qreal>(i) * (height + m.gap),
                      space.width(), height);
    addPanel(i, area, i + 1 == page_.panels.size(), m);
  }
}

AxisScale ChartScene::panelAxis(std::size_t index, const QRectF& area, bool& any) {
  auto& found = found_axes_.at(index);
  if (!found) {
    bool has = false;
    const AxisScale axis = findAxis(index, area, has);
    found = std::pair(axis, has);
  }
  any = found->second;
  return found->first;
}

AxisScale ChartScene::findAxis(std::size_t index, const QRectF& area, bool& any) const {
  const ChartPanel& panel = page_.panels[index];
  Extent extent;
  any = false;
  const auto [from, to] = rising_ ? places_between(page_.x, low_, high_)
                                  : std::pair<std::size_t, std::size_t>(0, page_.x.size());
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const ChartCurve& curve = panel.curves[c];
    any = any || std::any_of(curve.y.begin(), curve.y.end(), is_drawable);
    if (curve.hidden) continue;
    const bool by_blocks = !blocks_.empty() && !panel.log;
    std::size_t which = 0;
    for (const auto* values : {&curve.y, &curve.low, &curve.high}) {
      const CurveBlocks* blocks = by_blocks ? &blocks_[index][c].of(which) : nullptr;
      ++which;
      for (std::size_t i = from; i < std::min(to, values->size()); ++i) {
        if (!rising_ && (page_.x[i] < low_ || page_.x[i] > high_)) continue;
        const std::size_t b = i / CurveBlocks::kLength;
        if (blocks != nullptr && i % CurveBlocks::kLength == 0 && i + CurveBlocks::kLength <= to &&
            b < blocks->blocks.size() && blocks->blocks[b].whole) {
          extent.include((*values)[blocks->blocks[b].lowest]);
          extent.include((*values)[blocks->blocks[b].highest]);
          i += CurveBlocks::kLength - 1;
        } else if (!panel.log || (*values)[i] > 0.0) {
          extent.include((*values)[i]);
        }
      }
    }
  }
  const double least = std::max(panel.least_span, least_span_of(panel.unit));
  if (!panel.log && !extent.empty() && extent.high - extent.low < least) {
    // Beside a larger value such noise is a constant; about zero the axis shows how small it is.
    constexpr double kSeen = 0.03;  // of an axis as short as the noise: less is a straight line
    const double middle = 0.5 * (extent.low + extent.high);
    const bool nothing = std::max(std::abs(extent.low), std::abs(extent.high)) < kSeen * least;
    const double half = std::abs(middle) > 500.0 * least ? 0.0 : 0.5 * least;
    extent = {middle - half, middle + half};
    // What is 0 but for rounding gets a scale that bearings have, not one of atoms.
    if (nothing) extent = {-1e4 * least, 1e4 * least};
  }
  const int parts = std::clamp(static_cast<int>(area.height() / 38), 2, 8);
  const auto& chosen = panel_views_[index];
  const double low = chosen ? chosen->first : extent.low,
               high = chosen ? chosen->second : extent.high;
  constexpr qreal kLabelHeight = 20.0;
  return panel.log
             ? log_axis(low, high, panel.unit, chosen.has_value(), area.height() / kLabelHeight)
         : chosen ? tight_axis(low, high, panel.unit, parts)
                  : value_axis(low, high, panel.unit, parts);
}

namespace {

bool has_values(const ChartPanel& panel) {
  return std::any_of(panel.curves.begin(), panel.curves.end(), [](const ChartCurve& curve) {
    return std::any_of(curve.y.begin(), curve.y.end(), is_drawable);
  });
}

/// More than rounding of 0.
bool is_something(const ChartPanel& panel) {
  const double least = std::max(panel.least_span, least_span_of(panel.unit));
  return std::any_of(panel.curves.begin(), panel.curves.end(), [least](const ChartCurve& curve) {
    return std::any_of(curve.y.begin(), curve.y.end(),
                       [least](double v) { return is_drawable(v) && std::abs(v) > least; });
  });
}

/// Has nothing of the page values, for one reason? Then that is the page's, said once.
bool one_message(const ChartPage& page) {
  return page.panels.size() > 1 &&
         std::all_of(page.panels.begin(), page.panels.end(), [&](const ChartPanel& panel) {
           return !panel.message.empty() && panel.message == page.panels.front().message &&
                  !has_values(panel);
         });
}

/// Lengths are no vector: a radius stands beside micrometres of an axial position.
bool shares_unit(const ChartPanel& panel) {
  return !panel.log && !panel.unit.empty() && panel.unit != "m";
}

}  // namespace

void ChartScene::addPanel(std::size_t index, const QRectF& area, bool bottom, const Metrics& m) {
  const ChartPanel& panel = page_.panels[index];
  bool any = false;
  AxisScale y_axis = panelAxis(index, area, any);
  if (one_message(page_)) {  // axes would be of nothing
    if (index == 0) addMessage(space(m), text_of(panel.message), m);
    areas_.push_back(area);
    y_axes_.push_back(y_axis);
    lines_.push_back(0);
    return;
  }
  // Panels of one unit are compared: N beside kN are all drawn in N where that is no long number.
  std::vector<AxisScale> alike;
  for (std::size_t i = 0; any && shares_unit(panel) && i < page_.panels.size(); ++i) {
    if (page_.panels[i].unit != panel.unit || !shares_unit(page_.panels[i])) continue;
    bool drawn = false;
    const AxisScale axis = panelAxis(i, area, drawn);
    if (drawn && is_something(page_.panels[i])) alike.push_back(axis);
  }
  if (!alike.empty()) take_common_unit(y_axis, alike);
  const QString x_title = bottom ? with_unit_and_base(text_of(page_.x_title), x_axis_) : QString();
  const std::vector<ShownCurve> shown = shownCurves(index, area, y_axis, m);
  const bool log_of_none =
      any && panel.log && std::none_of(panel.curves.begin(), panel.curves.end(), any_above_0);
  const bool names_above = index == 0 && !page_.marks.empty();
  // A panel without values has no scale: any would be made up.
  const bool scaled = any && !log_of_none;
  const QRectF below_legend = area.adjusted(
      0.0, names_above ? -mark_rise(page_, m.tick_font, size_.width()) : 0.0, 0.0, 0.0);
  const qreal legend =
      scaled ? addLegend(panel, shown, below_legend, labelsTop(area, y_axis, m), m) : area.right();
  // A title too long for the side of its panel, even without its unit, stands above it.
  const bool numbered = scaled && !panel.scale_bar;
  QString y_title = numbered ? with_unit(text_of(panel.title), y_axis) : text_of(panel.title);
  qreal head = area.left();
  const QFontMetricsF title_metrics(ui_font(m.text_font));
  // One way for the page.
  const bool above =
      std::any_of(page_.panels.begin(), page_.panels.end(), [&](const ChartPanel& one) {
        const QString unit = "[" + text_of(pretty_unit(one.unit)) + "]";
        return std::max(title_metrics.horizontalAdvance(text_of(one.title)),
                        title_metrics.horizontalAdvance(unit)) > title_room(area, m.gap);
      });
  if (above && area.left() + title_metrics.horizontalAdvance(y_title) + 8.0 < legend) {
    auto* title = addSimpleText(y_title, ui_font(m.text_font));
    title->setBrush(theme_->text);
    title->setPos(area.left(), below_legend.top() - title_metrics.height() - 3.0);
    head += title_metrics.horizontalAdvance(y_title) + 16.0;
    y_title.clear();
  }
  addFrame(area, x_axis_, y_axis, x_title, y_title, bottom, numbered, m);
  if (scaled && panel.scale_bar) addScaleBar(panel, area, y_axis, m);
  std::vector<QPolygonF> drawn;
  for (const ShownCurve& one : shown)  // below all curves: none has the colour of another's area
    if (!panel.curves[one.curve].low.empty())
      addBand(index, one.curve, area, y_axis, one.colour, drawn);
  for (const ShownCurve& one : shown) {
    addShown(one, panel, area, y_axis, m);
    drawn.insert(drawn.end(), one.lines.begin(), one.lines.end());
  }
  if (!any)
    addMessage(
        area,
        panel.message.empty() ? tr("There are no values in the file.") : text_of(panel.message), m);
  if (log_of_none)
    addMessage(area, tr("No value is above 0, and a logarithmic axis shows no others."), m);
  if (panel.one_colour && scaled) addLineNames(panel, area, y_axis, m);
  if (scaled && !y_axis.offset_text.empty())
    addBase(y_axis, area, head, names_above ? head : legend, drawn, m);
  if (any) addMarks(area, index == 0, m);  // lines across a message hide its words
  areas_.push_back(area);
  y_axes_.push_back(y_axis);
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
  const bool before = pointed_;
  setPointed(false);
  QPainter painter(&image);
  paintPage(painter, QRectF(QPointF(0, 0), QSizeF(size)));
  setPointed(before);
  return image;
}

}  // namespace adore::desktop
