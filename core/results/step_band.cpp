#include "results/step_band.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace adore::results {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kLooks = "band looks";

std::string key(scene::ExtremeQuantity what, const char* quantity, std::size_t place) {
  return fmt::format("band {} {} {}", channel_of(what), quantity, place);
}

}  // namespace

std::string_view channel_of(scene::ExtremeQuantity what) {
  constexpr std::array<std::string_view, scene::kExtremeQuantityCount> kIds{
      "contact.load",          "contact.heat",         "contact.slip",
      "flange.force",          "flange.slip",          "pocket.force",
      "neighbour.force",       "land.force",           "race.applied_force_x",
      "race.applied_force_y",  "race.applied_force_z", "race.applied_moment_x",
      "race.applied_moment_y", "race.applied_moment_z"};
  return kIds[static_cast<std::size_t>(what)];
}

void StepBand::look(scene::ExtremeQuantity what, std::span<const double> values) {
  std::vector<Range>& ranges = ranges_[static_cast<std::size_t>(what)];
  // Parts that the scene does not have are always 0.
  if (values.size() > ranges.size()) ranges.resize(values.size());
  const bool slip =
      what == scene::ExtremeQuantity::ContactSlip || what == scene::ExtremeQuantity::FlangeSlip;
  Range* range = ranges.data();
  for (const double value : values) {
    if (range->looks == 0.0) {
      *range = {value, value, value, slip && value == 0.0 ? 0.0 : 1.0};
    } else if (!slip || value != 0.0) {
      range->low = std::min(range->low, value);
      range->high = std::max(range->high, value);
      range->sum += value;
      range->looks += 1.0;
    }
    ++range;
  }
}

void StepBand::look(const scene::Look& at) {
  for (std::size_t k = 0; k < scene::kExtremeQuantityCount; ++k)
    look(static_cast<scene::ExtremeQuantity>(k), at.values[k]);
  ++sample_count_;
}

void StepBand::clear() noexcept {
  sample_count_ = 0;
  // No value of before may stand for one that is not looked at.
  for (std::vector<Range>& ranges : ranges_) std::fill(ranges.begin(), ranges.end(), Range{});
}

double StepBand::low(scene::ExtremeQuantity what, std::size_t place) const {
  const Range* range = at(what, place);
  return range == nullptr ? kUnknown : range->low;
}
double StepBand::high(scene::ExtremeQuantity what, std::size_t place) const {
  const Range* range = at(what, place);
  return range == nullptr ? kUnknown : range->high;
}
double StepBand::mean(scene::ExtremeQuantity what, std::size_t place) const {
  const Range* range = at(what, place);
  // Rounding of the sum must not lead out of the range.
  return range == nullptr
             ? kUnknown
             : std::clamp(range->sum / std::max(range->looks, 1.0), range->low, range->high);
}

void StepBand::save(std::map<std::string, double>& state) const {
  if (empty()) return;
  state[kLooks] = sample_count_;
  for (std::size_t k = 0; k < scene::kExtremeQuantityCount; ++k) {
    const auto what = static_cast<scene::ExtremeQuantity>(k);
    for (std::size_t i = 0; i < ranges_[k].size(); ++i) {
      state[key(what, "low", i)] = ranges_[k][i].low;
      state[key(what, "high", i)] = ranges_[k][i].high;
      state[key(what, "sum", i)] = ranges_[k][i].sum;
      state[key(what, "looks", i)] = ranges_[k][i].looks;
    }
  }
}

void StepBand::restore(const std::map<std::string, double>& state) {
  const auto number = [&](const std::string& name) {
    const auto found = state.find(name);
    return found == state.end() ? nullptr : &found->second;
  };
  const double* looks = number(kLooks);
  sample_count_ = looks == nullptr ? 0.0 : *looks;
  bool any = false;
  for (std::size_t k = 0; k < scene::kExtremeQuantityCount; ++k) {
    const auto what = static_cast<scene::ExtremeQuantity>(k);
    std::vector<Range>& ranges = ranges_[k];
    ranges.clear();
    for (std::size_t i = 0; sample_count_ > 0.0; ++i) {
      const double *low = number(key(what, "low", i)), *high = number(key(what, "high", i)),
                   *sum = number(key(what, "sum", i)), *seen = number(key(what, "looks", i));
      if (low == nullptr || high == nullptr || sum == nullptr || seen == nullptr) break;
      ranges.push_back({*low, *high, *sum, *seen});
    }
    any = any || !ranges.empty();
  }
  if (!any) sample_count_ = 0.0;
}

}  // namespace adore::results
