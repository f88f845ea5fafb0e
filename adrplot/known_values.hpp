#pragma once

#include "results/channels.hpp"
#include "results/sol_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// Values of one file by column id, without values that mean "not computed": classic files store 0
/// for those.
namespace adore::adrplot {

/// Is any of them a number?
[[nodiscard]] inline bool any_value(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

struct KnownValues {
  std::vector<double> values;  ///< one per step, in the file's unit; NaN: none
  std::string unit;
  std::string why_none;       ///< a message if the column contains no meaningful values
  std::string why_gaps = {};  ///< reason for missing values at some steps
};

/// Rules, each only where the stored numbers leave no other meaning:
/// - a film thickness or a temperature rise of exactly 0 at every step: the run has no such model;
/// - a guide land whose force, gap and angle are exactly 0 at every step: the cage has no such
/// land;
/// - a flange gap of exactly 0: no flange there, or the roller's end is nowhere near it;
/// - contact angle, spin to roll and slip at a load of exactly 0: the contact is open;
/// - a life of 0: no life model, or none computed yet; 9.99E+30: infinite (N77);
/// - the angle of a land of exactly 0 while the cage has not left its middle;
/// - an average wear rate at time 0: there is no time to average over; all of exactly 0 at every
/// step: they were not integrated, or nothing wears;
/// - a velocity or acceleration of exactly 0 at every step, of a place that moves: modes 1 and 2
/// have it from a balance;
/// - an orientation of exactly 0 at every step, of what turns;
/// - a heat over a thermal step, before the first one has ended;
/// - temperatures of a coolant that never takes heat while there is some: none flows.
class KnownColumns {
 public:
  explicit KnownColumns(const results::SolFile& file);
  [[nodiscard]] bool has(const std::string& id) const { return find(id) < columns_.size(); }
  [[nodiscard]] KnownValues values(const std::string& id) const;
  [[nodiscard]] std::string unit(const std::string& id) const;
  /// The columns that the rules for a column look at besides its own.
  [[nodiscard]] static std::vector<std::string> sources(const std::string& id);
  [[nodiscard]] const std::vector<results::SolColumn>& columns() const { return columns_; }

 private:
  [[nodiscard]] std::size_t find(const std::string& id) const;
  [[nodiscard]] std::vector<double> stored(const std::string& id) const;
  [[nodiscard]] bool always_zero(const std::string& id) const;

  const results::SolFile& file_;
  std::vector<results::SolColumn> columns_;
  std::map<std::string, std::size_t> place_;
};

}  // namespace adore::adrplot
