#pragma once

#include "scene/look.hpp"

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Lowest, highest and mean values between two stored steps of vibrating quantities: a run that
/// stores every tenth step would miss them.
///
/// One sample per integration step: at counted steps the accepted state, at the substeps between
/// them (nStps) the last state that the stepper evaluated, which is inside that step and is as
/// accurate as its stages. A stored step is sampled as it is stored, so that low <= value
/// <= high to the last digit, and a run that stores every step has no width.
///
/// Slip is 0 without contact: such samples do not count in its extremes
/// and mean, which are 0 only if no sample had contact.
namespace adore::results {

/// The channel of which a look has the values, in the same order.
[[nodiscard]] std::string_view channel_of(scene::ExtremeQuantity what);

class StepBand {
 public:
  /// One look between stored steps.
  void look(const scene::Look& at);
  /// The look at a step that is stored, of one channel; all of them, then stored().
  void look(scene::ExtremeQuantity what, std::span<const double> values);
  void stored() noexcept { ++sample_count_; }
  /// After a stored step: the next look begins anew.
  void clear() noexcept;

  [[nodiscard]] bool empty() const noexcept { return sample_count_ == 0; }
  // Of all samples. NaN: no samples. @pre not empty
  [[nodiscard]] double low(scene::ExtremeQuantity what, std::size_t place) const;
  [[nodiscard]] double high(scene::ExtremeQuantity what, std::size_t place) const;
  [[nodiscard]] double mean(scene::ExtremeQuantity what, std::size_t place) const;

  /// For MASTER, and back. restore() leaves it empty when the map holds none.
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);

 private:
  struct Range {
    double low = 0.0, high = 0.0, sum = 0.0, looks = 0.0;
  };
  /// Null: nobody looked there.
  [[nodiscard]] const Range* at(scene::ExtremeQuantity what, std::size_t place) const {
    const std::vector<Range>& ranges = ranges_[static_cast<std::size_t>(what)];
    return place < ranges.size() ? &ranges[place] : nullptr;
  }
  std::array<std::vector<Range>, scene::kExtremeQuantityCount> ranges_;
  double sample_count_ = 0;
};

}  // namespace adore::results
