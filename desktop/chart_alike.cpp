#include "desktop/beyond_log.hpp"
#include "desktop/chart_scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

/// Finds the curves of a panel that cover each other, the ranges, and the texts in the legend.
namespace adore::desktop {
namespace {

/// Points of `line` on the path of `other`: within `same` of its range in a pixel to either side.
/// Both have increasing x. With `stop` the first point outside is the last one.
std::vector<bool> points_on(const QPolygonF& line, const QPolygonF& other, qreal same,
                            bool stop = false) {
  const auto height = [&other](qsizetype i, qreal x) {  // of the stroke that ends at point i
    const QPointF &a = other[i - 1], &b = other[i];
    return b.x() > a.x() ? a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()) : b.y();
  };
  const auto on_a_stroke = [&other](qsizetype i) { return i > 0 && i < other.size(); };
  std::vector<bool> out;
  out.reserve(static_cast<std::size_t>(line.size()));
  qsizetype first = 0;
  for (const QPointF& p : line) {
    const qreal left = p.x() - 1.0, right = p.x() + 1.0;
    while (first < other.size() && other[first].x() < left) ++first;
    Extent passed;
    if (on_a_stroke(first)) passed.include(height(first, left));
    qsizetype last = first;
    for (; last < other.size() && other[last].x() <= right; ++last) passed.include(other[last].y());
    if (on_a_stroke(last)) passed.include(height(last, right));
    out.push_back(!passed.empty() && p.y() >= passed.low - same && p.y() <= passed.high + same);
    if (stop && !out.back()) return out;
  }
  return out;
}

bool lies_on(const QPolygonF& line, const QPolygonF& other, qreal same) {
  const std::vector<bool> on = points_on(line, other, same, true);
  return on.empty() || on.back();
}

/// Minimum and maximum position of each line.
std::vector<Extent> extents_of(const std::vector<QPolygonF>& lines) {
  std::vector<Extent> out(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const QPointF& p : lines[i]) out[i].include(p.y());
  return out;
}

/// Do the lines `a` hide the lines `b` completely, or vice versa? Dense oscillations within equal
/// bounds hide each other for any values.
bool coincide(const ChartScene::ShownCurve& one, const ChartScene::ShownCurve& other, qreal same) {
  const std::vector<QPolygonF>&a = one.lines, &b = other.lines;
  if (a.empty() || a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)  // soon decided
    if (std::abs(one.extents[i].low - other.extents[i].low) > same ||
        std::abs(one.extents[i].high - other.extents[i].high) > same)
      return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i].front().x() - b[i].front().x()) > 1.0 ||
        std::abs(a[i].back().x() - b[i].back().x()) > 1.0 || !lies_on(a[i], b[i], same) ||
        !lies_on(b[i], a[i], same))
      return false;
  }
  return true;
}

/// Is every part of a curve on another one?
bool within(const ChartScene::ShownCurve& one, const ChartScene::ShownCurve& other, qreal same) {
  return !one.lines.empty() &&
         std::all_of(one.lines.begin(), one.lines.end(), [&](const QPolygonF& line) {
           return std::any_of(other.lines.begin(), other.lines.end(), [&](const QPolygonF& cover) {
             return cover.front().x() <= line.front().x() + 1.0 &&
                    cover.back().x() >= line.back().x() - 1.0 && lies_on(line, cover, same);
           });
         });
}

/// Is nothing to be seen of a curve with gaps below one drawn later, over at least half of that?
bool covered(const ChartScene::ShownCurve& below, const ChartScene::ShownCurve& above, qreal same) {
  const auto width = [](const QPolygonF& line) { return line.back().x() - line.front().x(); };
  qreal all = 0.0, hidden = 0.0;
  for (const QPolygonF& line : above.lines) all += width(line);
  for (const QPolygonF& line : below.lines) hidden += width(line);
  if (!(hidden > 0.0) || hidden < 0.5 * all) return false;
  return within(below, above, same);
}

/// Is a curve a dense oscillation in more than a twentieth of its columns of pixels? Then only its
/// bounds are visible; otherwise every value.
bool runs_to_and_fro(const ChartScene::ShownCurve& one, qreal same) {
  constexpr qreal kMost = 0.05;
  qreal columns = 0.0, dense = 0.0;
  for (const QPolygonF& line : one.lines) {
    for (qsizetype i = 0; i < line.size();) {
      const qreal column = std::floor(line[i].x());
      qreal up = 0.0, down = 0.0;  // ways within the column
      for (++i; i < line.size() && std::floor(line[i].x()) == column; ++i) {
        const qreal way = line[i].y() - line[i - 1].y();
        (way > 0.0 ? down : up) += std::abs(way);
      }
      columns += 1.0;
      dense += std::min(up, down) > same ? 1.0 : 0.0;
    }
  }
  return dense > kMost * columns;
}

/// Do curves and their bands agree from index `from` to before `to`, according to `same`, wherever
/// both have values?
struct Agreement {
  bool agree = true;
  bool gaps = false;  ///< a value of one without a value of the other
};
template <class Same>
Agreement agreement(const ChartCurve& a, const ChartCurve& b, std::size_t from, std::size_t to,
                    Same same) {
  Agreement out;
  for (const auto values : {&ChartCurve::y, &ChartCurve::low, &ChartCurve::high}) {
    const std::vector<double>&p = a.*values, &q = b.*values;
    if (p.size() != q.size()) return {false, false};
    for (std::size_t i = from; i < std::min(to, p.size()); ++i) {
      if (std::isnan(p[i]) || std::isnan(q[i]))
        out.gaps = out.gaps || std::isnan(p[i]) != std::isnan(q[i]);
      else if (!same(p[i], q[i]))
        return {false, out.gaps};
    }
  }
  return out;
}

/// Do the bands of two curves reach as far beyond their lines, to `seen`?
bool bands_agree(const ChartCurve& a, const ChartCurve& b, std::size_t from, std::size_t to,
                 double seen) {
  for (const auto values : {&ChartCurve::low, &ChartCurve::high}) {
    const std::vector<double>&p = a.*values, &q = b.*values;
    if (p.size() != q.size()) return false;
    for (std::size_t i = from; i < std::min({to, p.size(), a.y.size(), b.y.size()}); ++i)
      if (std::abs((p[i] - a.y[i]) - (q[i] - b.y[i])) > seen) return false;
  }
  return true;
}

/// Tolerance of equal values in a picture: at the start of a range, and within it. A single
/// tolerance would split ranges of nearly equal values, differently for each picture size.
template <class Begins, class Goes>
struct Sameness {
  Begins begins;
  Goes goes_on;
};

/// Ranges of indices from `from` to before `to` where the curves agree according to `same`: the
/// first and last index of each. A missing value does not end a range.
struct Stretches {
  std::vector<std::pair<std::size_t, std::size_t>> places;
  bool differ = false;  ///< somewhere
};
template <class Same>
Stretches stretches_of(const ChartCurve& a, const ChartCurve& b, std::size_t from, std::size_t to,
                       Same same) {
  Stretches out;
  bool open = false;
  for (std::size_t i = from; i < std::min({to, a.y.size(), b.y.size()}); ++i) {
    if (!is_drawable(a.y[i]) || !is_drawable(b.y[i])) continue;
    if (open ? !same.goes_on(a.y[i], b.y[i]) : !same.begins(a.y[i], b.y[i])) {
      out.differ = true;
      open = false;
      continue;
    }
    if (!open) out.places.emplace_back(i, i);
    out.places.back().second = i;
    open = true;
  }
  return out;
}

/// The same for very many values: a few thousand samples find the differences, and only intervals
/// that are `long_enough` are compared completely. No range that is `long_enough` is missed,
/// because all of its values agree.
template <class Same, class Long>
Stretches long_stretches_of(const ChartCurve& a, const ChartCurve& b, std::size_t from,
                            std::size_t to, Same same, Long long_enough) {
  constexpr std::size_t kLooks = 4096;
  to = std::min({to, a.y.size(), b.y.size()});
  const std::size_t step = to > from ? (to - from) / kLooks : 0;
  if (step < 2) return stretches_of(a, b, from, to, same);
  Stretches out;
  const auto look_between = [&](std::size_t first, std::size_t end) {
    if (!(first < end) || !long_enough(first, end - 1)) return;
    const Stretches found = stretches_of(a, b, first, end, same);
    out.differ = out.differ || found.differ;
    out.places.insert(out.places.end(), found.places.begin(), found.places.end());
  };
  std::size_t begun = from;
  for (std::size_t i = from; i < to; i += step) {
    if (!is_drawable(a.y[i]) || !is_drawable(b.y[i]) || same.goes_on(a.y[i], b.y[i])) continue;
    out.differ = true;
    look_between(begun, i);
    begun = i + 1;
  }
  look_between(begun, to);
  return out;
}

/// Width in the picture of values of one of two curves where the other has none; `place`: position
/// of the i-th value of `from` to before `to`.
template <class Place>
qreal unlike_gaps(const ChartCurve& a, const ChartCurve& b, std::size_t from, std::size_t to,
                  Place place) {
  to = std::min({to, a.y.size(), b.y.size()});
  qreal out = 0.0;
  for (std::size_t i = from; i < to; ++i)
    if (is_drawable(a.y[i]) != is_drawable(b.y[i]))
      out += 0.5 * (place(std::min(i + 1, to - 1)) - place(std::max(i, from + 1) - 1));
  return out;
}

/// Shorter ranges are crossings, or invisible; such a small part of the picture width is ignored.
constexpr qreal kMinGap = 24.0, kWorthSaying = 0.05;

/// Visible ranges of two curves without points where only the upper one has values: nothing is
/// below it there.
template <class Place>
std::vector<std::pair<std::size_t, std::size_t>> without_gaps(
    const std::vector<std::pair<std::size_t, std::size_t>>& places, const ChartCurve& lower,
    const ChartCurve& upper, Place place) {
  constexpr qreal kSeen = 4.0;
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (const auto& [first, last] : places) {
    std::size_t begun = first, known = first;  // where both have values
    for (std::size_t i = first; i <= last; ++i) {
      if (!is_drawable(lower.y[i]) || !is_drawable(upper.y[i])) continue;
      bool bare = false;
      for (std::size_t k = known + 1; k < i && !bare; ++k) bare = is_drawable(upper.y[k]);
      if (bare && place(i) - place(known) > kSeen) {
        out.emplace_back(begun, known);
        begun = i;
      }
      known = i;
    }
    out.emplace_back(begun, last);
  }
  return out;
}

/// Intervals of a picture in which a curve is on another one, as drawn lines; and whether all of it
/// is.
std::pair<std::vector<std::pair<qreal, qreal>>, bool> common_ways(
    const ChartScene::ShownCurve& one, const ChartScene::ShownCurve& other, qreal same) {
  constexpr qreal kColumn = 1.5;  // as below, of thinned lines
  std::vector<std::pair<qreal, qreal>> out;
  bool all = true;
  for (const QPolygonF& line : one.lines) {
    std::vector<bool> on(static_cast<std::size_t>(line.size()), false);
    for (const QPolygonF& way : other.lines) {
      const std::vector<bool> here = points_on(line, way, same);
      for (std::size_t i = 0; i < on.size(); ++i) on[i] = on[i] || here[i];
    }
    for (std::size_t i = 0; i < on.size();) {
      if (!on[i]) {
        all = false;
        ++i;
        continue;
      }
      const std::size_t first = i;
      while (i < on.size() && on[i]) ++i;
      const qreal left = line[static_cast<qsizetype>(first)].x() + kColumn,
                  right = line[static_cast<qsizetype>(i) - 1].x() - kColumn;
      if (right - left >= kMinGap) out.emplace_back(left, right);
    }
  }
  return {std::move(out), all};
}

/// To the digits of a file.
bool equal_values(double p, double q) {
  constexpr double kDigits = 1e-6;
  return std::abs(p - q) <= kDigits * std::max(std::abs(p), std::abs(q));
}

}  // namespace

std::vector<ChartScene::ShownCurve> ChartScene::prepareShownCurves(std::size_t index,
                                                                   const QRectF& area,
                                                                   const AxisScale& y_axis,
                                                                   const Metrics& m) {
  const ChartPanel& panel = page_.panels[index];
  std::vector<ShownCurve> out;
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const ChartCurve& curve = panel.curves[c];
    if (curve.hidden) continue;
    ShownCurve shown{.curve = c, .colour = static_cast<int>(c)};
    std::vector<double> positive;
    // One height of the panel below its foot; a curve of such values alone has no line.
    if (panel.log)
      positive = replace_nonpositive(curve.y, has_positive_value(curve)
                                                  ? y_axis.value(2.0 * y_axis.min - y_axis.max)
                                                  : std::numeric_limits<double>::quiet_NaN());
    const CurveBlocks* const blocks =
        curve_blocks_.empty() || panel.log ? nullptr : &curve_blocks_[index][c].y;
    const std::vector<double>& y = panel.log ? positive : curve.y;
    const int columns = static_cast<int>(area.width());
    if (page_.log_x) {  // columns of pixels are equal parts of a decade
      shown.pieces = drawable_polylines(log_abscissa_, y, std::log10(low_), std::log10(high_),
                                        columns, panel.wraps, blocks);
      for (Polyline& piece : shown.pieces)
        for (double& x : piece.x) x = std::pow(10.0, x);
    } else {
      shown.pieces = drawable_polylines(page_.x, y, low_, high_, columns, panel.wraps, blocks);
    }
    for (const Polyline& piece : shown.pieces)
      shown.lines.push_back(line_in_scene(piece, area, x_axis_, y_axis));
    shown.extents = extents_of(shown.lines);
    const bool compared = abscissa_increasing_;
    const qreal same = m.line;  // distance of two lines that partly cover each other
    // Dense oscillations have no values to compare: their edges are compared.
    const qreal edges = std::min(same, area.height() / 300.0);
    const auto hide = [&](ShownCurve& before) {
      shown.hides = before.curve;
      classifyOverlap(index, before.curve, shown, area, y_axis, same);
      shown.later = ++before.later;
    };
    for (ShownCurve& before : out) {
      if (!compared || before.hides || !coincide(before, shown, edges)) continue;
      hide(before);
      break;
    }
    for (std::size_t i = 0; compared && !panel.log && !shown.hides && i < out.size(); ++i)
      if (!out[i].hides && findOverlapRanges(index, out[i], shown, area, y_axis, same)) break;
    for (ShownCurve& before : out) {
      // A later curve hides an earlier one where it is on it, and is complete elsewhere.
      if (!compared || shown.hides || before.hides ||
          !(covered(before, shown, edges) ||
            (panel.curves[c].y.size() == panel.curves[before.curve].y.size() &&
             shown.lines.size() > 1 && within(shown, before, edges))))
        continue;
      const auto [over, all] = common_ways(shown, before, edges);
      if (!all && over.empty()) continue;
      hide(before);
      if (all) break;
      shown.over = over;
      shown.partly = true;
      break;
    }
    out.push_back(std::move(shown));
  }
  return out;
}

bool ChartScene::findOverlapRanges(std::size_t index, ShownCurve& before, ShownCurve& shown,
                                   const QRectF& area, const AxisScale& y_axis, qreal same) const {
  const ChartPanel& panel = page_.panels[index];
  const auto [from, to] = indices_between(page_.x, low_, high_);
  // Lines side by side do not cover each other: one over paper would look like a broken line.
  constexpr double kBegins = 0.3, kGoesOn = 0.6;  // of a line's width
  const double line = same / area.height() * (y_axis.max - y_axis.min) * std::abs(y_axis.factor);
  const double nothing = 1e-3 * std::max(panel.least_span, min_axis_span(panel.unit));
  const ChartCurve &one = panel.curves[before.curve], &other = panel.curves[shown.curve];
  const auto place = [&](std::size_t i) {
    return area.left() +
           (x_axis_.shown(page_.x[i]) - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
  };
  const auto long_enough = [&](std::size_t first, std::size_t last) {
    return place(last) - place(first) >= kMinGap;
  };
  const auto within_of_line = [&](double part) {
    return [=](double p, double q) { return std::abs(p - q) <= part * line; };
  };
  const Sameness alike{within_of_line(kBegins), within_of_line(kGoesOn)};
  const Stretches found = long_stretches_of(one, other, from, to, alike, long_enough);
  bool equal = true;
  double longest = 0.0;  // of equal values, along the abscissa
  std::vector<std::pair<qreal, qreal>> over;
  const qreal gaps = found.places.empty() ? 0.0 : unlike_gaps(one, other, from, to, place);
  const auto places = gaps > kMinGap ? without_gaps(found.places, one, other, place) : found.places;
  for (const auto& [first, last] : places) {
    if (!long_enough(first, last)) continue;
    // Lines are thinned to columns of pixels: near an end they may already deviate toward the next
    // value.
    constexpr qreal kColumn = 1.5;
    over.emplace_back(place(first) + kColumn, place(last) - kColumn);
    // The ends of a range depend on the picture size: for curves that separate soon, the equal
    // values are the common range.
    std::size_t begun = first;
    for (std::size_t i = first; i <= last; ++i) {
      if (!is_drawable(one.y[i]) || !is_drawable(other.y[i])) continue;
      if (!equal_values(one.y[i], other.y[i]) && std::abs(one.y[i] - other.y[i]) > nothing) {
        equal = false;
        begun = i + 1;
      } else if (i > begun) {
        const double way =
            page_.log_x ? std::log10(page_.x[i] / page_.x[begun]) : page_.x[i] - page_.x[begun];
        longest = std::max(longest, way);
      }
    }
  }
  qreal all = 0.0;
  for (const auto& [first, last] : over) all += last - first;
  if (all < std::max(kMinGap, kWorthSaying * area.width())) return false;
  shown.hides = before.curve;
  shown.later = ++before.later;
  shown.over = std::move(over);
  shown.partly = found.differ || gaps > kMinGap;
  const double told = kWorthSaying * (page_.log_x ? std::log10(high_ / low_) : high_ - low_);
  shown.alike = equal || (shown.partly && longest >= told) ? Alike::Equal : Alike::Near;
  return true;
}

void ChartScene::classifyOverlap(std::size_t index, std::size_t a, ShownCurve& shown,
                                 const QRectF& area, const AxisScale& y_axis, qreal same) {
  const ChartPanel& panel = page_.panels[index];
  const ChartCurve &one = panel.curves[a], &other = panel.curves[shown.curve];
  const auto [known, unknown] = equal_curves_cache_.try_emplace({index, a, shown.curve}, false);
  // Values that are 0 except for rounding are 0.
  const double nothing = 1e-3 * std::max(panel.least_span, min_axis_span(panel.unit));
  const auto equal = [nothing](double p, double q) {
    return equal_values(p, q) || std::abs(p - q) <= nothing;
  };
  if (unknown) {
    const Agreement whole = agreement(one, other, 0, page_.x.size(), equal);
    known->second = whole.agree && !whole.gaps;
  }
  shown.alike = Alike::Equal;
  if (known->second) return;
  const auto [from, to] = indices_between(page_.x, low_, high_);
  const double seen = same / area.height() * (y_axis.max - y_axis.min);
  const auto near = [&](double p, double q) {
    const bool p_shown = !panel.log || p > 0.0, q_shown = !panel.log || q > 0.0;
    return p_shown && q_shown ? std::abs(y_axis.shown(p) - y_axis.shown(q)) <= seen
                              : p_shown == q_shown;
  };
  const Agreement seen_alike = agreement(one, other, from, to, near);
  const auto place = [&](std::size_t i) {
    return area.left() +
           (x_axis_.shown(page_.x[i]) - x_axis_.min) / (x_axis_.max - x_axis_.min) * area.width();
  };
  shown.partly =
      seen_alike.agree && seen_alike.gaps && unlike_gaps(one, other, from, to, place) > kMinGap;
  // On a steep path the values of lines that cover each other differ by more than a line width.
  const auto near_by_ways = [&] {
    return !runs_to_and_fro(shown, same) &&
           bands_agree(one, other, from, to, seen * std::abs(y_axis.factor));
  };
  shown.alike = !seen_alike.agree ? (near_by_ways() ? Alike::Near : Alike::Covers)
                : agreement(one, other, from, to, equal).agree ? Alike::Equal
                                                               : Alike::Near;
}

}  // namespace adore::desktop
