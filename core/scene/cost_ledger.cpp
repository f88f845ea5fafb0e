#include "scene/cost_ledger.hpp"

#include <algorithm>
#include <ctime>

namespace adore::scene {
namespace {

/// Time between two neighboring readings of the clock: the least of a few hundred.
CostLedger::Clock::duration clock_cost() {
  static const CostLedger::Clock::duration cost = [] {
    auto least = CostLedger::Clock::duration::max();
    for (int i = 0; i < 400; ++i) {
      const auto first = CostLedger::Clock::now();
      least = std::min(least, CostLedger::Clock::now() - first);
    }
    return least;
  }();
  return cost;
}

/// A sampled call may take this much longer by the wall's clock than by the processor's [s]: the
/// second is read in two system calls.
constexpr double kLostProcessor = 2e-6;

double seconds(CostLedger::Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

double processor_seconds() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

int CostLedger::add_entry(std::string name) {
  (void)clock_cost();  // measured at set-up, not in the first sampled call
  entries_.push_back({.name = std::move(name)});
  return static_cast<int>(entries_.size()) - 1;
}

int CostLedger::entry(std::string_view name) {
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (entries_[i].name == name) return static_cast<int>(i);
  return add_entry(std::string(name));
}

void CostLedger::add_sampled(int entry, Clock::duration duration) noexcept {
  Entry& e = entries_[static_cast<std::size_t>(entry)];
  e.pending += std::max(duration - clock_cost(), Clock::duration::zero());
  e.is_sampled = true;
}

void CostLedger::begin_sample() noexcept {
  for (Entry& e : entries_) e.pending = {};
  sample_start_time_ = Clock::now();
  sample_start_processor_seconds_ = processor_seconds();
}

void CostLedger::end_sample() noexcept {
  const double processor = processor_seconds() - sample_start_processor_seconds_;
  const double wall = seconds(Clock::now() - sample_start_time_);
  // The first one counts in any case: a run of a few calls has no other.
  if (kept_ > 0 && wall > 1.2 * processor + kLostProcessor) return;
  ++kept_;
  for (Entry& e : entries_) e.sampled += e.pending;
}

void CostLedger::add(int entry, double seconds) noexcept {
  Entry& e = entries_[static_cast<std::size_t>(entry)];
  e.full += seconds;
  ++e.calls;
}

std::vector<CostLedger::Row> CostLedger::rows() const {
  std::vector<Row> result;
  result.reserve(entries_.size());
  for (const Entry& e : entries_) {
    Row row{e.name, e.calls, e.full};
    if (e.is_sampled) {
      row.calls += calls_;
      row.seconds += seconds(e.sampled) * static_cast<double>(calls_) /
                     static_cast<double>(std::max(1L, kept_));
    }
    result.push_back(std::move(row));
  }
  return result;
}

}  // namespace adore::scene
