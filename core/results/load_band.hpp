#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

/// Lowest, highest and mean load of every element/race contact between two stored steps: what a run
/// that stores every tenth step would hide.
///
/// One look per integration step: at counted steps the accepted state, at the substeps between them
/// (nStps) the last state that the stepper evaluated, which lies inside that step and is as
/// accurate as its stages. The stored value itself is always among them, so that low <= load <=
/// high. A look costs three additions or comparisons per contact: 0.05 us for twelve elements.
namespace adore::results {

class LoadBand {
 public:
  /// One look: loads [N] of all elements at the outer and at the inner race.
  void look(std::span<const double> outer, std::span<const double> inner);
  /// After a stored step: the next look begins anew.
  void clear() noexcept { looks_ = 0; }

  [[nodiscard]] bool empty() const noexcept { return looks_ == 0; }
  /// @pre not empty. `place`: race * elements + element
  [[nodiscard]] double low(std::size_t place) const { return values_[place].low; }
  [[nodiscard]] double high(std::size_t place) const { return values_[place].high; }
  /// Of the looks, all alike.
  [[nodiscard]] double mean(std::size_t place) const { return values_[place].sum / looks_; }

  /// For MASTER, and back. restore() leaves it empty when the map holds none.
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);

 private:
  struct Range {
    double low = 0.0, high = 0.0, sum = 0.0;
  };
  void look(std::span<const double> loads, std::size_t first);
  std::vector<Range> values_;
  double looks_ = 0;
};

}  // namespace adore::results
