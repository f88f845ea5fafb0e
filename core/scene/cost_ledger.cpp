#include "scene/cost_ledger.hpp"

#include <algorithm>

namespace adore::scene {
namespace {

/// Time between two neighbouring readings of the clock: the least of a few hundred.
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

double seconds(CostLedger::Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

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
  e.sampled += std::max(duration - clock_cost(), Clock::duration::zero());
  e.is_sampled = true;
}

void CostLedger::add(int entry, Clock::duration duration) noexcept {
  Entry& e = entries_[static_cast<std::size_t>(entry)];
  e.full += duration;
  ++e.calls;
}

std::vector<CostLedger::Row> CostLedger::rows() const {
  std::vector<Row> result;
  result.reserve(entries_.size());
  const long sampled_calls = (calls_ + kSampleEvery - 1) / kSampleEvery;
  for (const Entry& e : entries_) {
    Row row{e.name, e.calls, seconds(e.full)};
    if (e.is_sampled) {
      row.calls += calls_;
      row.seconds +=
          seconds(e.sampled) * static_cast<double>(calls_) / static_cast<double>(sampled_calls);
    }
    result.push_back(std::move(row));
  }
  return result;
}

}  // namespace adore::scene
