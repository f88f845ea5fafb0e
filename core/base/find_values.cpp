#include "base/find_values.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace adore {
namespace {

constexpr double kRatioForGeometric = 100.0;  ///< of the bounds
constexpr double kTolerance = 1e-9;           ///< of x, relative
constexpr double kNearZero = 1e-3;            ///< of the range: x below it counts as this
constexpr double kJump = 0.01;      ///< change of f that is left in the last interval, relative
constexpr double kNoise = 1e-7;     ///< of the span of f: smaller changes are no turn
constexpr double kAccuracy = 1e-9;  ///< of f, relative to its size: smaller changes are rounding
constexpr double kTouch = 1e-8;     ///< distance of a touching curve, relative to its neighbors
constexpr int kMaxPoints = 2001, kMaxSteps = 100, kMaxTurns = 8;

/// End of a piece of constant side.
struct Border {
  double left = 0.0, right = 0.0;  ///< last interval
  double value_left = 0.0, value_right = 0.0;
  bool jump = false, bound = false, failure = false;
};

/// Part of the range on one side of the target: -1, 0, 1.
struct Piece {
  int side = 0;
  Border from, to;
};

class Search {
 public:
  Search(const FindSettings& settings, const std::function<double(double)>& f)
      : s_(settings), f_(f) {}

  FindOutcome run() {
    scan();
    const bool seeks_extremum = s_.relation == Relation::Least || s_.relation == Relation::Largest;
    if (!s_.whole && !seeks_extremum) split_turns();
    if (seeks_extremum)
      find_extremum();
    else
      find_pieces();
    sort();
    describe_curve();
    judge(seeks_extremum);
    return std::move(out_);
  }

 private:
  [[nodiscard]] double tolerance_at(double x) const {
    return kTolerance * std::max(std::abs(x), kNearZero * (s_.last - s_.first));
  }
  [[nodiscard]] double distance(const FindSample& p) const { return p.value - s_.target; }
  [[nodiscard]] int side(const FindSample& p) const {
    const double d = distance(p);
    return d > 0.0 ? 1 : d < 0.0 ? -1 : 0;
  }

  FindSample at(double x) {
    FindSample out;
    out.x = x;
    out.value = std::numeric_limits<double>::quiet_NaN();
    try {
      out.value = f_(x);
      if (std::isnan(out.value)) out.failure = "the result was not computed";
    } catch (const InputError& error) {
      out.failure = error.what();
      out.wrong_input = true;
    } catch (const SolverError& error) {
      out.failure = error.what();
    }
    out_.samples.push_back(out);
    return out;
  }

  void sort() {
    std::sort(out_.samples.begin(), out_.samples.end(),
              [](const FindSample& a, const FindSample& b) { return a.x < b.x; });
  }

  void scan() {
    if (!std::isfinite(s_.first) || !std::isfinite(s_.last) || !(s_.first < s_.last))
      throw InputError(fmt::format(
          "range {:g}:{:g}: the bounds must be finite, the lower one first. Write lower:upper.",
          s_.first, s_.last));
    if (s_.whole) {
      const double low = std::ceil(s_.first), high = std::floor(s_.last);
      if (high - low >= kMaxPoints || high < low)
        throw InputError(
            fmt::format("range {:g}:{:g}: the range must contain from 1 to {} whole numbers. "
                        "Change the bounds.",
                        s_.first, s_.last, kMaxPoints));
      for (double x = low; x <= high; x += 1.0) (void)at(x);
    } else {
      if (s_.points < 3 || s_.points > kMaxPoints)
        throw InputError(fmt::format("number of scan points {}: it must be from 3 to {}.",
                                     s_.points, kMaxPoints));
      const double ratio = s_.last / s_.first;
      out_.equal_ratios = std::isfinite(ratio) && ratio > 0.0 &&
                          (ratio >= kRatioForGeometric || ratio <= 1.0 / kRatioForGeometric);
      for (int k = 0; k < s_.points; ++k) {
        const double share = static_cast<double>(k) / (s_.points - 1);
        const double x = k == 0               ? s_.first
                         : k == s_.points - 1 ? s_.last
                         : out_.equal_ratios  ? s_.first * std::pow(ratio, share)
                                              : s_.first + share * (s_.last - s_.first);
        (void)at(x);
      }
    }
    if (std::any_of(out_.samples.begin(), out_.samples.end(),
                    [](const FindSample& p) { return p.ok(); }))
      return;
    const FindSample& first = out_.samples.front();
    const std::string text = fmt::format(
        "the result could not be computed at any point of the range. Failure at {:g}: {}", first.x,
        first.failure);
    if (first.wrong_input) throw InputError(text);
    throw SolverError(text);
  }

  /// Golden section for the least `cost` between samples a and c; stops when `done`.
  template <class Cost, class Done>
  FindSample least(double a, double c, double end, const Cost& cost, const Done& done) {
    constexpr double kGolden = 2.0 - std::numbers::phi;
    double low = a, high = c;
    FindSample p = at(low + kGolden * (high - low)), q = at(high - kGolden * (high - low));
    for (int n = 0; n < kMaxSteps && high - low > end && p.ok() && q.ok(); ++n) {
      if (done(p)) return p;
      if (done(q)) return q;
      if (cost(p) < cost(q)) {
        high = q.x;
        q = std::move(p);
        p = at(low + kGolden * (high - low));
      } else {
        low = p.x;
        p = std::move(q);
        q = at(high - kGolden * (high - low));
      }
    }
    return q.ok() && (!p.ok() || cost(q) < cost(p)) ? q : p;
  }

  /// Computes between neighbors of a point that is nearer to the target than both.
  void split_turns() {
    const std::vector<FindSample> scan = out_.samples;
    int turns = 0;
    for (std::size_t k = 1; k + 1 < scan.size() && turns < kMaxTurns; ++k) {
      const FindSample &a = scan[k - 1], &b = scan[k], &c = scan[k + 1];
      if (!a.ok() || !b.ok() || !c.ok()) continue;
      const int one = side(b);
      if (one == 0 || side(a) != one || side(c) != one) continue;
      const double da = std::abs(distance(a)), db = std::abs(distance(b)),
                   dc = std::abs(distance(c));
      if (!(db < da && db <= dc)) continue;
      ++turns;
      const double scale = std::max(da, dc);
      const FindSample found = least(
          a.x, c.x, std::sqrt(kTolerance) * (c.x - a.x),
          [&](const FindSample& p) { return std::abs(distance(p)); },
          [&](const FindSample& p) { return side(p) != one; });
      if (found.ok() && side(found) == one && std::abs(distance(found)) < kTouch * scale &&
          s_.relation == Relation::Equal)
        out_.solutions.push_back({FindSolutionKind::Touch, found.x, found.value,
                                  std::sqrt(kTolerance) * (c.x - a.x), found.x, found.x});
    }
    sort();
  }

  void find_extremum() {
    const double sign = s_.relation == Relation::Least ? 1.0 : -1.0;
    const auto cost = [&](const FindSample& p) {
      return p.ok() ? sign * p.value : std::numeric_limits<double>::infinity();
    };
    const auto less = [&](const FindSample& a, const FindSample& b) { return cost(a) < cost(b); };
    const std::vector<FindSample> scan = out_.samples;
    const auto best = std::min_element(scan.begin(), scan.end(), less);
    const auto k = static_cast<std::size_t>(best - scan.begin());
    const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, scan.size() - 1);
    FindSolution solution;
    solution.kind = FindSolutionKind::Extremum;
    FindSample found = *best;
    if (!s_.whole && scan[before].ok() && scan[after].ok()) {
      // The value is flat there: x is known to the square root of the accuracy of the value.
      solution.width = std::sqrt(kTolerance) * (scan[after].x - scan[before].x);
      const FindSample refined = least(scan[before].x, scan[after].x, solution.width, cost,
                                       [](const FindSample&) { return false; });
      if (less(refined, found)) found = refined;
    }
    solution.x = solution.from = solution.to = found.x;
    solution.value = found.value;
    solution.from_bound = found.x == scan.front().x;
    solution.to_bound = found.x == scan.back().x;
    solution.from_failure = before != k && !scan[before].ok();
    solution.to_failure = after != k && !scan[after].ok();
    out_.solutions.push_back(solution);
  }

  [[nodiscard]] static Border border(const FindSample& a, const FindSample& b, bool jump) {
    Border out;
    out.left = a.x;
    out.right = b.x;
    out.value_left = a.value;
    out.value_right = b.value;
    out.jump = jump;
    return out;
  }

  /// The point between a and b where the side changes from that of a. Nothing: a point failed.
  std::optional<Border> edge(FindSample a, FindSample b) {
    const int one = side(a);
    const auto put = [&](const FindSample& p) {
      if (!p.ok()) return false;
      (side(p) == one ? a : b) = p;
      return true;
    };
    // Of a single exact hit the edge is next to it.
    const double near = 2.0 * tolerance_at(one == 0 ? a.x : b.x);
    if (b.x - a.x > 2.0 * near && !put(at(one == 0 ? a.x + near : b.x - near))) return std::nullopt;
    for (int n = 0; n < kMaxSteps && b.x - a.x > tolerance_at(b.x); ++n)
      if (!put(at(0.5 * (a.x + b.x)))) return std::nullopt;
    return border(a, b, std::abs(b.value - a.value) > reach_);
  }

  /// Brent's method between points on opposite sides. Nothing: a point failed.
  std::optional<Border> crossing(const FindSample& left, const FindSample& right,
                                 std::optional<FindSample>& hit) {
    const double span = std::abs(right.value - left.value);
    FindSample a = left, b = right, c = left;
    double step = b.x - a.x, before = step;
    for (int n = 0; n < kMaxSteps; ++n) {
      if (side(b) == side(c)) {
        c = a;
        step = before = b.x - a.x;
      }
      if (std::abs(distance(c)) < std::abs(distance(b))) {
        a = b;
        b = c;
        c = a;
      }
      const double end = 0.5 * tolerance_at(b.x), middle = 0.5 * (c.x - b.x);
      if (std::abs(middle) <= end) break;
      const double fa = distance(a), fb = distance(b), fc = distance(c);
      const bool finite = std::isfinite(fa) && std::isfinite(fb) && std::isfinite(fc);
      if (finite && std::abs(before) >= end && std::abs(fa) > std::abs(fb)) {
        double p = 0.0, q = 0.0;
        const double s = fb / fa;
        if (a.x == c.x) {
          p = 2.0 * middle * s;
          q = 1.0 - s;
        } else {
          const double r = fb / fc, t = fa / fc;
          p = s * (2.0 * middle * t * (t - r) - (b.x - a.x) * (r - 1.0));
          q = (t - 1.0) * (r - 1.0) * (s - 1.0);
        }
        if (p > 0.0)
          q = -q;
        else
          p = -p;
        if (2.0 * p < std::min(3.0 * middle * q - std::abs(end * q), std::abs(before * q))) {
          before = step;
          step = p / q;
        } else {
          before = step = middle;
        }
      } else {
        before = step = middle;
      }
      a = b;
      b = at(std::abs(step) > end ? b.x + step : b.x + std::copysign(end, middle));
      if (!b.ok()) return std::nullopt;
      if (side(b) == 0) {
        hit = b;
        return std::nullopt;
      }
    }
    if (c.x < b.x) std::swap(b, c);
    const double left_over = std::abs(c.value - b.value);
    return border(b, c, !std::isfinite(left_over) || left_over > kJump * span);
  }

  /// Pieces of constant side between two computed neighbors a and b: adds the borders.
  void cut(const FindSample& a, const FindSample& b, std::vector<Piece>& pieces) {
    const auto change = [&](const Border& at_border, int next) {
      pieces.back().to = at_border;
      pieces.push_back({next, at_border, {}});
    };
    const int before = side(a), after = side(b);
    if (before == after) return;
    if (s_.whole) return change(border(a, b, true), after);
    if (before == 0 || after == 0) {
      if (const auto found = edge(a, b)) return change(*found, after);
    } else {
      std::optional<FindSample> hit;
      if (const auto found = crossing(a, b, hit)) return change(*found, after);
      if (hit) {
        cut(a, *hit, pieces);
        return cut(*hit, b, pieces);
      }
    }
    Border lost = border(a, b, false);
    lost.failure = true;
    const auto failed = std::find_if(out_.samples.rbegin(), out_.samples.rend(),
                                     [](const FindSample& p) { return !p.ok(); });
    out_.failures.push_back({a.x, b.x, failed->failure});
    change(lost, after);
  }

  void find_pieces() {
    const std::vector<FindSample> known = out_.samples;
    double least_value = std::numeric_limits<double>::infinity(), largest = -least_value;
    for (const FindSample& p : known)
      if (p.ok() && std::isfinite(p.value)) {
        least_value = std::min(least_value, p.value);
        largest = std::max(largest, p.value);
      }
    reach_ = largest > least_value ? kJump * (largest - least_value) : 0.0;
    std::vector<Piece> pieces;
    const FindSample* last = nullptr;
    std::string reason;
    double lost_from = s_.first;
    for (const FindSample& p : known) {
      if (!p.ok()) {
        if (reason.empty()) {
          lost_from = last != nullptr ? last->x : p.x;
          reason = p.failure;
          if (last != nullptr) {
            pieces.back().to.left = pieces.back().to.right = last->x;
            pieces.back().to.failure = true;
          }
        }
        continue;
      }
      if (last == nullptr || !reason.empty()) {
        Border start;
        start.left = start.right = p.x;
        start.value_left = start.value_right = p.value;
        start.bound = reason.empty();
        start.failure = !reason.empty();
        pieces.push_back({side(p), start, {}});
        if (!reason.empty()) out_.failures.push_back({lost_from, p.x, reason});
        reason.clear();
      } else {
        cut(*last, p, pieces);
      }
      last = &p;
    }
    if (!reason.empty()) {
      out_.failures.push_back({lost_from, known.back().x, reason});
    } else {
      Border& end = pieces.back().to;
      end.left = end.right = last->x;
      end.value_left = end.value_right = last->value;
      end.bound = true;
    }
    read_pieces(pieces);
  }

  [[nodiscard]] bool meets(int side_of_piece) const {
    return side_of_piece == 0 || (s_.relation == Relation::AtLeast && side_of_piece > 0) ||
           (s_.relation == Relation::AtMost && side_of_piece < 0);
  }

  void read_pieces(const std::vector<Piece>& pieces) {
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Piece& piece = pieces[k];
      const Border& end = piece.to;
      if (meets(piece.side)) {
        // Adjacent pieces that both meet the condition are one range.
        std::size_t n = k;
        while (n + 1 < pieces.size() && meets(pieces[n + 1].side) && !pieces[n].to.failure) ++n;
        add_range(piece.from, pieces[n].to);
        k = n;
      } else if (k + 1 < pieces.size() && !end.failure && !end.bound && !end.jump &&
                 s_.relation == Relation::Equal && pieces[k + 1].side != 0) {
        const bool left =
            std::abs(end.value_left - s_.target) < std::abs(end.value_right - s_.target);
        const double x = left ? end.left : end.right;
        out_.solutions.push_back({FindSolutionKind::Crossing, x,
                                  left ? end.value_left : end.value_right, end.right - end.left, x,
                                  x});
      }
    }
    for (const Piece& piece : pieces)
      if (piece.to.jump && !s_.whole)
        out_.jumps.push_back(
            {piece.to.left, piece.to.right, piece.to.value_left, piece.to.value_right});
    std::sort(out_.solutions.begin(), out_.solutions.end(),
              [](const FindSolution& a, const FindSolution& b) { return a.x < b.x; });
  }

  void add_range(const Border& from, const Border& to) {
    FindSolution out;
    out.from = from.right;
    out.to = to.left;
    out.from_bound = from.bound;
    out.to_bound = to.bound;
    out.from_failure = from.failure;
    out.to_failure = to.failure;
    const auto open = [](const Border& one) { return !one.bound && !one.failure; };
    const bool lower = open(from) || !open(to);
    out.x = lower ? out.from : out.to;
    out.value = lower ? from.value_right : to.value_left;
    out.width = s_.whole ? 0.0 : lower ? from.right - from.left : to.right - to.left;
    // An exact hit, not a range.
    const bool single = s_.relation == Relation::Equal && !s_.whole &&
                        out.to - out.from <= 8.0 * tolerance_at(out.x);
    out.kind = single ? FindSolutionKind::Crossing : FindSolutionKind::Range;
    if (s_.whole && out.from == out.to) out.kind = FindSolutionKind::Crossing;
    if (out.kind == FindSolutionKind::Crossing) {
      out.x = 0.5 * (out.from + out.to);
      out.width = std::max(out.width, out.to - out.from);
      out.from = out.to = out.x;
      out.from_bound = out.to_bound = false;
    }
    out_.solutions.push_back(out);
  }

  void describe_curve() {
    double least_value = std::numeric_limits<double>::infinity(), largest = -least_value;
    for (const FindSample& p : out_.samples)
      if (p.ok()) {
        least_value = std::min(least_value, p.value);
        largest = std::max(largest, p.value);
      }
    const double size = std::max(std::abs(least_value), std::abs(largest));
    const double span = largest - least_value;
    const double noise = std::isfinite(span) ? std::max(kNoise * span, kAccuracy * size) : 0.0;
    out_.constant = std::isfinite(span) ? span <= kAccuracy * size : least_value == largest;
    int direction = 0;
    const FindSample* extreme = nullptr;
    for (const FindSample& p : out_.samples) {
      if (!p.ok()) continue;
      if (extreme == nullptr) {
        extreme = &p;
        continue;
      }
      const double change = p.value - extreme->value;
      const int sign = change > noise ? 1 : change < -noise ? -1 : 0;
      if (sign == 0 && direction == 0) continue;
      if (sign == -direction && direction != 0) out_.turns.push_back(extreme->x);
      if (sign != 0) direction = sign;
      if (change * direction >= 0.0) extreme = &p;
    }
    out_.monotonic = out_.turns.empty();
  }

  void judge(bool seeks_extremum) {
    // Samples with a result; of conditions the largest or the least value is nearest.
    const auto cost = [&](const FindSample& p) {
      if (!p.ok()) return std::numeric_limits<double>::infinity();
      switch (s_.relation) {
        case Relation::Equal:
          return std::abs(distance(p));
        case Relation::AtLeast:
        case Relation::Largest:
          return -p.value;
        case Relation::AtMost:
        case Relation::Least:
          break;
      }
      return p.value;
    };
    out_.best = *std::min_element(
        out_.samples.begin(), out_.samples.end(),
        [&](const FindSample& a, const FindSample& b) { return cost(a) < cost(b); });
    if (seeks_extremum) {
      for (const FindSample& p : out_.samples)
        if (!p.ok()) out_.failures.push_back({p.x, p.x, p.failure});
      out_.answer = FindAnswer::One;
      return;
    }
    const bool failed = !out_.failures.empty();
    const std::size_t count = out_.solutions.size();
    if (count == 0)
      out_.answer = failed ? FindAnswer::NotComputed : FindAnswer::None;
    else if (count > 1)
      out_.answer = FindAnswer::Many;
    else if (out_.solutions[0].from_bound && out_.solutions[0].to_bound && !failed)
      out_.answer = FindAnswer::Everywhere;
    else
      out_.answer = out_.monotonic ? FindAnswer::One : FindAnswer::NotMonotonic;
  }

  const FindSettings& s_;
  const std::function<double(double)>& f_;
  FindOutcome out_;
  double reach_ = 0.0;  ///< change of f that may be a jump at an edge
};

}  // namespace

FindOutcome find_values(const FindSettings& settings, const std::function<double(double)>& f) {
  return Search(settings, f).run();
}

}  // namespace adore
