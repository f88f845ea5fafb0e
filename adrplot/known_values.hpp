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
[[nodiscard]] inline bool has_number(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

struct ValidValues {
  std::vector<double> values;  ///< one per step, in the unit of the file; NaN: none
  std::string unit;
  std::string why_none;       ///< a message if the column contains no meaningful values
  std::string why_gaps = {};  ///< reason for missing values at some steps
};

/// Rules, each only where the stored numbers have no other meaning:
/// - a film thickness or a temperature rise of exactly 0 at all steps: the run has no such model;
/// - a guide land whose force, gap and angle are exactly 0 at all steps: the land does not exist;
/// - a flange gap of exactly 0: no flange, or the roller end is far away;
/// - contact angle, spin to roll and slip at a load of exactly 0: no contact;
/// - a life of 0: no life model, or not computed yet; 9.99E+30: infinite (N77);
/// - the angle of a land of exactly 0 while the cage is centered;
/// - an average wear rate at time 0: no averaging time; exactly 0 at all steps: not integrated, or
/// no wear;
/// - a velocity or acceleration of exactly 0 at all steps, of a moving coordinate: given by a force
/// balance in modes 1 and 2;
/// - an orientation of exactly 0 at all steps, of a rotating body;
/// - a heat over a thermal step, before the first one has ended;
/// - coolant temperatures without heat flow to the coolant: no coolant flow.
class ValidColumns {
 public:
  explicit ValidColumns(const results::SolFile& file);
  [[nodiscard]] bool has(const std::string& id) const { return find(id) < columns_.size(); }
  [[nodiscard]] ValidValues values(const std::string& id) const;
  [[nodiscard]] std::string unit(const std::string& id) const;
  /// Additional columns needed by the rules for a column.
  [[nodiscard]] static std::vector<std::string> required_columns(const std::string& id);
  [[nodiscard]] const std::vector<results::SolColumn>& columns() const { return columns_; }

 private:
  [[nodiscard]] std::size_t find(const std::string& id) const;
  [[nodiscard]] std::vector<double> stored(const std::string& id) const;
  [[nodiscard]] bool is_always_zero(const std::string& id) const;

  const results::SolFile& file_;
  std::vector<results::SolColumn> columns_;
  std::map<std::string, std::size_t> column_index_;
};

}  // namespace adore::adrplot
