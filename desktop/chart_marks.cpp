#include "base/counted.hpp"
#include "desktop/chart_scene_parts.hpp"

#include <QFontMetricsF>
#include <QGraphicsSimpleTextItem>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <optional>

/// Vertical lines with names above the first panel of a page.
namespace adore::desktop {
namespace {

/// Between two names, between two leaders, and between a leader and its name.
constexpr qreal kApart = 8.0, kLeaders = 5.0, kBeside = 3.0;

/// Height of a row of names.
qreal row_pitch(int tick_font) { return tick_font + 3.0; }

/// A name over a panel, and the line that it belongs to.
struct MarkName {
  QStringList all;
  QString text = {};
  qreal line = 0.0, left = 0.0, width = 0.0;
  int row = 0;          ///< above the lowest one
  bool beside = false;  ///< its leader, which crosses the rows below
  /// Point where the leader from the name to its line begins.
  [[nodiscard]] qreal foot() const {
    if (beside) return left - kBeside;
    const qreal edge = std::min(3.0, 0.5 * width);
    return std::clamp(line, left + edge, left + width - edge);
  }
};

/// Names of lines that are too close to distinguish their leaders.
constexpr qreal kOneLine = 3.0;

/// A text for all names of `name`, which counts those that it has no room for.
void write(MarkName& name, const QFontMetricsF& metrics, qreal room) {
  name.text = name.all.join(", ");
  for (qsizetype told = name.all.size() - 1;
       told >= 0 && metrics.horizontalAdvance(name.text) > room; --told)
    name.text = told > 0 ? ChartScene::tr("%1, %2 more")
                               .arg(name.all.mid(0, told).join(", "))
                               .arg(name.all.size() - told)
                         : text_of(counted(name.all.size(), "name"));
  name.width = metrics.horizontalAdvance(name.text);
}

void join(std::vector<MarkName>& names, std::size_t i, const QFontMetricsF& metrics, qreal room) {
  names[i].all += names[i + 1].all;
  names.erase(names.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  write(names[i], metrics, room);
}

/// Side by side from `left` to `right`, each as close to its line as the others allow; the last of
/// too many share a text.
void arrange(std::vector<MarkName>& names, const QFontMetricsF& metrics, qreal left, qreal right) {
  // Without the last one, which may count its names.
  const auto length = [&] {
    qreal all = 0.0;
    for (std::size_t i = 0; i + 1 < names.size(); ++i) all += names[i].width + kApart;
    return all;
  };
  constexpr qreal kShort = 60.0;
  const auto crowded = [&] {
    return length() + std::min(names.back().width, kShort) > right - left;
  };
  while (names.size() > 1 && crowded()) join(names, names.size() - 2, metrics, right - left);
  if (!names.empty()) write(names.back(), metrics, right - left - length());
  for (MarkName& name : names) name.left = std::max(left, name.line - 0.5 * name.width);
  for (std::size_t i = 1; i < names.size(); ++i)
    names[i].left = std::max(names[i].left, names[i - 1].left + names[i - 1].width + kApart);
  qreal end = right;
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    name->left = std::min(name->left, end - name->width);
    end = name->left - kApart;
  }
}

/// In stairs of `rows` names, from the highest row down, each to the right of its leader; a stair
/// begins behind all names of the one before, so that no leader crosses a name. Does all have room?
bool arrange_in_stairs(std::vector<MarkName>& names, std::size_t rows, qreal left, qreal right) {
  const std::size_t n = names.size();
  const auto begins_stair = [rows](std::size_t i) { return i % rows == 0; };
  std::vector<qreal> foot(n);
  qreal behind = left;  // all names of the stairs before
  for (std::size_t i = 0, first = 0; i < n; ++i) {
    if (begins_stair(i))
      for (; first < i; ++first)
        behind = std::max(behind, foot[first] + kBeside + names[first].width + kApart);
    foot[i] = std::max({names[i].line, behind, i > 0 ? foot[i - 1] + kLeaders : left});
  }
  qreal next = right + kApart;  // start of the next step of the leader
  for (std::size_t i = n; i-- > 0;) {
    foot[i] = std::min(foot[i], next - kApart - names[i].width - kBeside);
    if (i + 1 < n) foot[i] = std::min(foot[i], foot[i + 1] - kLeaders);
    if (begins_stair(i)) next = foot[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    names[i].left = foot[i] + kBeside;
    names[i].row = static_cast<int>(rows - 1 - i % rows);
    names[i].beside = true;
  }
  return n == 0 || foot[0] >= left;
}

/// Largest horizontal shift of a leader.
qreal farthest_aside(const std::vector<MarkName>& names) {
  qreal out = 0.0;
  for (const MarkName& name : names) out = std::max(out, std::abs(name.foot() - name.line));
  return out;
}

/// In as few rows as keep leaders short, `most` at most.
void place_names(std::vector<MarkName>& names, int most, const QFontMetricsF& metrics, qreal left,
                 qreal right) {
  constexpr qreal kNear = 30.0;
  for (MarkName& name : names) write(name, metrics, right - left);
  for (std::size_t i = 0; i + 1 < names.size();)
    if (names[i + 1].line - names[i].line < kOneLine)
      join(names, i, metrics, right - left);
    else
      ++i;
  std::vector<MarkName> one_row = names;
  arrange(one_row, metrics, left, right);
  std::vector<MarkName> best = one_row;
  for (int rows = 2; rows <= most && (best.size() < names.size() || farthest_aside(best) > kNear);
       ++rows) {
    std::vector<MarkName> stairs = names;
    if (arrange_in_stairs(stairs, static_cast<std::size_t>(rows), left, right) &&
        (best.size() < names.size() || farthest_aside(stairs) < farthest_aside(best)))
      best = std::move(stairs);
  }
  names = std::move(best);
}

/// Steps below each other, so that they do not cross: for names to the right of their lines the
/// last one is lowest, for names to the left the first. The distance is limited by the longest of
/// such rows.
std::vector<qreal> step_depths(const std::vector<MarkName>& names, qreal height) {
  constexpr qreal kWidest = 5.0;
  const auto aside = [&](std::size_t i) { return names[i].foot() - names[i].line; };
  std::vector<int> count(names.size(), 0);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (aside(i) > 0.5) count[i] = 1 + (i > 0 && aside(i - 1) > 0.5 ? count[i - 1] : 0);
  for (std::size_t i = names.size(); i-- > 0;)
    if (aside(i) < -0.5)
      count[i] = 1 + (i + 1 < names.size() && aside(i + 1) < -0.5 ? count[i + 1] : 0);
  const int most = count.empty() ? 0 : *std::max_element(count.begin(), count.end());
  std::vector<qreal> out;
  for (const int steps : count)
    out.push_back(steps * std::min(kWidest, (height - 3.0) / std::max(1, most)));
  return out;
}

/// A mark that moves.
QPolygonF way_of(const ChartMark& mark, const QRectF& area, const AxisScale& x_axis,
                 const AxisScale& y_axis) {
  Polyline way;
  for (const auto& [x, height] : mark.way) {
    if (!is_drawable(x_axis.shown(x))) continue;
    way.x.push_back(x);
    way.y.push_back(height);
  }
  return line_in_scene(way, area, x_axis, y_axis);
}

}  // namespace

int mark_row_count(const ChartPage& page, int tick_font, qreal width) {
  constexpr qreal kBesidePanels = 114.0, kOne = 0.6, kTwo = 1.5;  // of their width
  const QFontMetricsF metrics(ui_font(tick_font));
  qreal all = 0.0;
  for (const ChartMark& mark : page.marks)
    all += metrics.horizontalAdvance(text_of(mark.label)) + kApart;
  const qreal part = all / std::max(1.0, width - kBesidePanels);
  return part < kOne ? 1 : part < kTwo ? 2 : 3;
}

qreal mark_labels_height(const ChartPage& page, int tick_font, qreal width) {
  if (page.marks.empty()) return 0.0;
  const int rows = mark_row_count(page, tick_font, width);
  return tick_font + 6.0 + mark_step_height(rows) + (rows - 1) * row_pitch(tick_font);
}

void ChartScene::addMarks(const QRectF& area, const AxisScale& y_axis, bool label, bool drawn,
                          const Metrics& m) {
  const QFont font = ui_font(m.tick_font);
  const QFontMetricsF metrics(font);
  // Visible on the colors of a map.
  const bool map = !page_.panels.empty() && page_.panels.front().rows;
  const QPen pen(map ? QColor(255, 255, 255, 170) : theme_->muted, 1, Qt::DashLine);
  std::vector<MarkName> names;
  for (const ChartMark& mark : page_.marks) {
    if (mark.way.empty()) {
      const double shown = x_axis_.shown(mark.x);
      if (!(shown > x_axis_.min && shown < x_axis_.max)) continue;
      const qreal x =
          area.left() + (shown - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
      if (drawn) addLine(QLineF(x, area.top(), x, area.bottom()), pen);
      names.push_back({.all = {text_of(mark.label)}, .line = x});
      continue;
    }
    // A mark that leaves the view at a side is named at its last visible position.
    std::optional<qreal> last;
    for (const QPolygonF& part : clip_to_area(way_of(mark, area, x_axis_, y_axis), area)) {
      QPainterPath path;
      path.addPolygon(part);
      if (drawn) addPath(path, pen);
      last = part.back().x();
    }
    if (last) names.push_back({.all = {text_of(mark.label)}, .line = *last});
  }
  std::stable_sort(names.begin(), names.end(),
                   [](const MarkName& a, const MarkName& b) { return a.line < b.line; });
  if (!label || names.empty()) return;
  const std::vector<MarkName> lines = names;
  const int rows = mark_row_count(page_, m.tick_font, size_.width());
  place_names(names, rows, metrics, area.left(), area.right());
  const qreal top = area.top() - mark_step_height(rows);
  const std::vector<qreal> depth = step_depths(names, mark_step_height(rows));
  const QPen thin(theme_->muted, 1);
  for (std::size_t i = 0, line = 0; i < names.size(); ++i) {
    const MarkName& name = names[i];
    auto* item = addSimpleText(name.text, font);
    item->setBrush(theme_->muted);
    item->setToolTip(name.all.join(", "));
    const qreal bottom = top - name.row * row_pitch(m.tick_font);
    item->setPos(name.left, bottom - metrics.height() + 1.0);
    const qreal from = top + 1.0 + depth[i];
    const qreal begin = name.beside ? bottom - 0.7 * metrics.ascent() : top + 1.0;
    if (depth[i] > 0.0 || name.beside) addLine(QLineF(name.foot(), begin, name.foot(), from), thin);
    if (depth[i] > 0.0) addLine(QLineF(name.foot(), from, name.line, from), thin);
    // All lines with this name.
    const qreal next = i + 1 < names.size() ? names[i + 1].line : area.right() + 1.0;
    const qreal first = name.line;
    for (; line < lines.size() && lines[line].line < next; ++line) {
      addLine(QLineF(lines[line].line, from, lines[line].line, area.top()), thin);
      if (lines[line].line > first) addLine(QLineF(first, from, lines[line].line, from), thin);
    }
  }
}

}  // namespace adore::desktop
