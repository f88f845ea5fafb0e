#include "desktop/chart_page.hpp"

#include "desktop/axis_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::desktop {

std::vector<double> cell_edges(const std::vector<double>& places) {
  if (places.empty()) return {};
  if (places.size() == 1) return {places[0] - 0.5, places[0] + 0.5};
  std::vector<double> out{places[0] - 0.5 * (places[1] - places[0])};
  for (std::size_t i = 1; i < places.size(); ++i) out.push_back(0.5 * (places[i - 1] + places[i]));
  out.push_back(places.back() + 0.5 * (places.back() - places[places.size() - 2]));
  return out;
}

namespace {

/// A larger step of an angle [deg] is a wrap.
constexpr double kWrap = 180.0;
/// An angle that flips at nearly every step has no line to show; joining everything is honest and
/// quick.
constexpr std::size_t kMostPieces = 400;

/// First, lowest, highest and last point of each column, in their order.
Polyline thinned(const Polyline& line, double low, double high, int columns) {
  if (line.x.size() <= static_cast<std::size_t>(4 * columns) || !(high > low)) return line;
  Polyline out;
  const double width = (high - low) / columns;
  std::size_t begin = 0;
  while (begin < line.x.size()) {
    const double column = std::floor((line.x[begin] - low) / width);
    std::size_t end = begin, lowest = begin, highest = begin;
    while (end < line.x.size() && std::floor((line.x[end] - low) / width) == column) {
      if (line.y[end] < line.y[lowest]) lowest = end;
      if (line.y[end] > line.y[highest]) highest = end;
      ++end;
    }
    std::vector<std::size_t> keep{begin, std::min(lowest, highest), std::max(lowest, highest),
                                  end - 1};
    keep.erase(std::unique(keep.begin(), keep.end()), keep.end());
    for (const auto i : keep) {
      out.x.push_back(line.x[i]);
      out.y.push_back(line.y[i]);
    }
    begin = end;
  }
  return out;
}

}  // namespace

namespace {

/// Does a piece of the curve begin with the i-th value?
bool begins_piece(const std::vector<double>& y, std::size_t i, bool wraps) {
  return is_drawable(y[i]) &&
         (i == 0 || !is_drawable(y[i - 1]) || (wraps && std::abs(y[i] - y[i - 1]) > kWrap));
}

}  // namespace

CurveBlocks blocks_of(const std::vector<double>& y, bool wraps) {
  CurveBlocks out;
  out.blocks.resize(y.size() / CurveBlocks::kLength);
  for (std::size_t b = 0; b < out.blocks.size(); ++b) {
    CurveBlocks::Block& block = out.blocks[b];
    const std::size_t begin = b * CurveBlocks::kLength, end = begin + CurveBlocks::kLength;
    block = {begin, begin, 0.0, 0.0, true, false, 0};
    for (std::size_t i = begin; i < end; ++i) {
      block.whole = block.whole && is_drawable(y[i]);
      if (y[i] < y[block.lowest]) block.lowest = i;
      if (y[i] > y[block.highest]) block.highest = i;
      block.begun += begins_piece(y, i, wraps) ? 1 : 0;
    }
    block.low = y[block.lowest], block.high = y[block.highest];
    block.smooth = block.whole;
    if (!wraps || !block.whole) continue;
    const double before = begin > 0 && is_drawable(y[begin - 1]) ? y[begin - 1] : y[begin];
    block.smooth = std::max(block.high, before) - std::min(block.low, before) <= kWrap;
  }
  out.spans.resize(y.size() / CurveBlocks::kSpan);
  for (std::size_t i = 0; i < out.spans.size() * CurveBlocks::kSpan; ++i)
    out.spans[i / CurveBlocks::kSpan].include(y[i]);
  return out;
}

Extent extent_between(const std::vector<double>& y, std::size_t from, std::size_t to,
                      const CurveBlocks& blocks) {
  Extent out;
  for (std::size_t i = from; i < std::min(to, y.size());) {
    const std::size_t k = i / CurveBlocks::kSpan;
    if (i % CurveBlocks::kSpan == 0 && i + CurveBlocks::kSpan <= to && k < blocks.spans.size()) {
      out.include(blocks.spans[k]);
      i += CurveBlocks::kSpan;
    } else {
      out.include(y[i++]);
    }
  }
  return out;
}

std::size_t count_pieces_between(const std::vector<double>& y, std::size_t first, std::size_t last,
                                 bool wraps, const CurveBlocks& blocks) {
  std::size_t out = 0;
  for (std::size_t i = first; i < last;) {
    const std::size_t b = i / CurveBlocks::kLength;
    if (i > first && i % CurveBlocks::kLength == 0 && i + CurveBlocks::kLength <= last &&
        b < blocks.blocks.size()) {
      out += static_cast<std::size_t>(blocks.blocks[b].begun);
      i += CurveBlocks::kLength;
      continue;
    }
    // The first visible one begins a piece, independent of its previous start.
    out += begins_piece(y, i, wraps) || (i == first && is_drawable(y[i])) ? 1 : 0;
    ++i;
  }
  return out;
}

std::pair<std::size_t, std::size_t> indices_between(const std::vector<double>& x, double low,
                                                    double high) {
  const auto first = std::lower_bound(x.begin(), x.end(), low);
  return {static_cast<std::size_t>(first - x.begin()),
          static_cast<std::size_t>(std::upper_bound(first, x.end(), high) - x.begin())};
}

namespace {

/// The values from `first` to before `last`; of whole blocks only the ends and extremes, combined
/// up to `width`, so that all peaks remain visible. Blocks of values that wrap (`wraps`) are
/// combined only within one period.
Polyline reduced(const std::vector<double>& x, const std::vector<double>& y, std::size_t first,
                 std::size_t last, double width, bool wraps, const CurveBlocks& blocks) {
  Polyline out;
  const auto take = [&](std::size_t i) {
    out.x.push_back(x[i]);
    out.y.push_back(y[i]);
  };
  /// Is the block that begins at `i` one of those, in a group that begins at `from`?
  const auto fits = [&](std::size_t i, std::size_t from) {
    const std::size_t b = i / CurveBlocks::kLength, end = i + CurveBlocks::kLength;
    return end <= last && b < blocks.blocks.size() &&
           (wraps ? blocks.blocks[b].smooth : blocks.blocks[b].whole) &&
           !(x[end - 1] - x[from] > width);
  };
  for (std::size_t i = first; i < last;) {
    if (i % CurveBlocks::kLength != 0 || !fits(i, i)) {
      take(i++);
      continue;
    }
    const std::size_t from = i;
    std::size_t lowest = i, highest = i;
    do {
      const CurveBlocks::Block& block = blocks.blocks[i / CurveBlocks::kLength];
      const std::size_t low = block.low < y[lowest] ? block.lowest : lowest,
                        high = block.high > y[highest] ? block.highest : highest;
      if (wraps && i > from && y[high] - y[low] > kWrap) break;
      lowest = low, highest = high;
      i += CurveBlocks::kLength;
    } while (fits(i, from));
    std::array<std::size_t, 4> keep{from, lowest, highest, i - 1};
    std::sort(keep.begin(), keep.end());
    take(keep[0]);
    for (std::size_t k = 1; k < keep.size(); ++k)
      if (keep[k] != keep[k - 1]) take(keep[k]);
  }
  return out;
}

}  // namespace

std::vector<Polyline> drawable_polylines(const std::vector<double>& x, const std::vector<double>& y,
                                         double low, double high, int columns, bool wraps,
                                         const CurveBlocks* blocks) {
  if (blocks != nullptr && x.size() == y.size() && !x.empty()) {
    auto [first, last] = indices_between(x, low, high);
    first -= first > 0 ? 1 : 0;
    last = std::min(last + 1, x.size());
    wraps = wraps && count_pieces_between(y, first, last, wraps, *blocks) <= kMostPieces;
    const Polyline few =
        reduced(x, y, first, last, (high - low) / std::max(columns, 1), wraps, *blocks);
    return drawable_polylines(few.x, few.y, low, high, columns, wraps);
  }
  std::vector<Polyline> pieces;
  const std::size_t count = std::min(x.size(), y.size());
  bool open = false;
  double last = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    // One neighbor beyond each end keeps the line running to the edge of a zoomed view.
    const bool needed = (x[i] >= low && x[i] <= high) ||
                        (i + 1 < count && x[i] < low && x[i + 1] >= low) ||
                        (i > 0 && x[i] > high && x[i - 1] <= high);
    if (!needed || !is_drawable(y[i]) || !is_drawable(x[i])) {
      open = false;
      continue;
    }
    if (!open || (wraps && std::abs(y[i] - last) > kWrap)) pieces.emplace_back();
    pieces.back().x.push_back(x[i]);
    pieces.back().y.push_back(y[i]);
    last = y[i];
    open = true;
  }
  if (wraps && pieces.size() > kMostPieces)
    return drawable_polylines(x, y, low, high, columns, false);
  for (auto& piece : pieces) piece = thinned(piece, low, high, columns);
  return pieces;
}

std::size_t nearest_index(const std::vector<double>& x, double where) {
  if (x.empty()) return 0;
  const auto after = std::lower_bound(x.begin(), x.end(), where);
  auto i = static_cast<std::size_t>(std::min<std::ptrdiff_t>(after - x.begin(), std::ssize(x) - 1));
  if (i > 0 && std::abs(x[i - 1] - where) < std::abs(x[i] - where)) --i;
  return i;
}

CurveStatistics statistics_between(const std::vector<double>& x, const std::vector<double>& y,
                                   double from, double to) {
  if (from > to) std::swap(from, to);
  CurveStatistics out;
  double sum = 0.0, squares = 0.0, span = 0.0, plain = 0.0, plain_squares = 0.0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!(x[i] >= from && x[i] <= to) || !is_drawable(y[i])) continue;
    if (out.count == 0) out.first = x[i];
    out.last = x[i];
    out.lowest = out.count == 0 ? y[i] : std::min(out.lowest, y[i]);
    out.highest = out.count == 0 ? y[i] : std::max(out.highest, y[i]);
    if (out.count > 0) {
      const double width = x[i] - x[last];
      sum += 0.5 * width * (y[i] + y[last]);
      squares += 0.5 * width * (y[i] * y[i] + y[last] * y[last]);
      span += width;
    }
    plain += y[i];
    plain_squares += y[i] * y[i];
    last = i;
    ++out.count;
  }
  if (out.count == 0) return out;
  const auto n = static_cast<double>(out.count);
  out.mean = span > 0.0 ? sum / span : plain / n;
  out.rms = std::sqrt(span > 0.0 ? squares / span : plain_squares / n);
  return out;
}

}  // namespace adore::desktop
