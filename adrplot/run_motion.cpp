#include "adrplot/run_motion.hpp"

#include <algorithm>
#include <cmath>

namespace adore::adrplot {
namespace {

double turns_at(const MarkEventCounts& mark, double time) {
  const auto after = std::upper_bound(mark.time.begin() + 1, mark.time.end() - 1, time);
  const auto i = static_cast<std::size_t>(after - mark.time.begin());
  const double span = mark.time[i] - mark.time[i - 1];
  const double part = span > 0.0 ? (time - mark.time[i - 1]) / span : 0.0;
  return mark.turns[i - 1] + part * (mark.turns[i] - mark.turns[i - 1]);
}

}  // namespace

std::vector<double> event_counts_of(const MarkEventCounts& mark, const std::vector<double>& times) {
  std::vector<double> out;
  if (mark.time.size() < 2 || mark.turns.size() != mark.time.size()) return out;
  out.reserve(times.size());
  for (const double time : times) out.push_back(turns_at(mark, time));
  return out;
}

double frequency_between(const MarkEventCounts& mark, double from, double to) {
  if (mark.time.size() < 2 || mark.turns.size() != mark.time.size()) return 0.0;
  if (!(std::min(to, mark.time.back()) > std::max(from, mark.time.front()))) {
    const bool before = to <= mark.time.front();
    from = before ? mark.time.front() : mark.time[mark.time.size() - 2];
    to = before ? mark.time[1] : mark.time.back();
  }
  from = std::max(from, mark.time.front());
  to = std::min(to, mark.time.back());
  const double out = to > from ? (turns_at(mark, to) - turns_at(mark, from)) / (to - from) : 0.0;
  return std::isfinite(out) ? std::abs(out) : 0.0;
}

std::vector<desktop::ChartMark> mean_marks(const std::vector<MarkEventCounts>& marks) {
  std::vector<desktop::ChartMark> out;
  for (const MarkEventCounts& mark : marks) {
    if (mark.time.empty()) continue;
    const double mean = frequency_between(mark, mark.time.front(), mark.time.back());
    if (mean > 0.0) out.push_back({mean, mark.label});
  }
  return out;
}

}  // namespace adore::adrplot
