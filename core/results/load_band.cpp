#include "results/load_band.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::results {

void LoadBand::look(std::span<const double> outer, std::span<const double> inner) {
  values_.resize(outer.size() + inner.size());
  look(outer, 0);
  look(inner, outer.size());
  ++looks_;
}

void LoadBand::look(std::span<const double> loads, std::size_t first) {
  Range* range = values_.data() + first;
  if (looks_ == 0) {
    for (const double load : loads) *range++ = {load, load, load};
    return;
  }
  for (const double load : loads) {
    range->low = std::min(range->low, load);
    range->high = std::max(range->high, load);
    range->sum += load;
    ++range;
  }
}

void LoadBand::save(std::map<std::string, double>& state) const {
  if (empty()) return;
  state["load band looks"] = looks_;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    state[fmt::format("load band low {}", i)] = values_[i].low;
    state[fmt::format("load band high {}", i)] = values_[i].high;
    state[fmt::format("load band sum {}", i)] = values_[i].sum;
  }
}

void LoadBand::restore(const std::map<std::string, double>& state) {
  const auto number = [&](const std::string& name) {
    const auto found = state.find(name);
    return found == state.end() ? nullptr : &found->second;
  };
  const double* looks = number("load band looks");
  looks_ = looks == nullptr ? 0.0 : *looks;
  values_.clear();
  for (std::size_t i = 0; looks_ > 0.0; ++i) {
    const double *low = number(fmt::format("load band low {}", i)),
                 *high = number(fmt::format("load band high {}", i)),
                 *sum = number(fmt::format("load band sum {}", i));
    if (low == nullptr || high == nullptr || sum == nullptr) break;
    values_.push_back({*low, *high, *sum});
  }
  if (values_.empty()) looks_ = 0.0;
}

}  // namespace adore::results
