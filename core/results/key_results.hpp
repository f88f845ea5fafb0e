#pragma once

#include "bearing/life_inputs.hpp"
#include "results/quantities.hpp"

#include <span>
#include <string_view>
#include <vector>

/// The figures by which a run is judged and compared: `summary` of RUN.json, the columns of
/// SWEEP.csv and their plots. Each is defined once, in the table of key_results.cpp.
namespace adore::results {

struct KeyResultSpec {
  std::string_view id;     ///< "stiffness_x_N_per_m": key and column, the same in every release
  std::string_view label;  ///< "Stiffness"
  std::string_view part;   ///< "x": tells results of one label apart; empty when there is only one
  const UnitPair* unit = nullptr;   ///< of the value, which is in SI: factor 1
  std::string_view of_motion = {};  ///< label in a table of motions, where it is another
  std::string_view meaning = {};    ///< sign and limits, where the label does not say them
};

struct KeyResult {
  KeyResultSpec of;
  double value = 0.0;  ///< SI; lives may be infinite
};
/// In the order in which they are shown.
using KeyResults = std::vector<KeyResult>;

[[nodiscard]] std::span<const KeyResultSpec> key_result_specs();
/// Name of the result: by of_motion in a table of motions.
[[nodiscard]] constexpr std::string_view label_of(const KeyResultSpec& spec, bool motion) {
  return motion && !spec.of_motion.empty() ? spec.of_motion : spec.label;
}
/// Empty id when there is none of this name: files may come from another release.
[[nodiscard]] KeyResultSpec find_key_result(std::string_view id);
/// @throws std::out_of_range for an id that is not in the table.
[[nodiscard]] KeyResult key_result(std::string_view id, double value);
/// Value of a key result [SI]; not a number when the run has none.
[[nodiscard]] double value_of(const KeyResults& results, std::string_view id);
/// Life of the bearing by one model [hr]: life_lp_hours, life_gz_stle_hours.
[[nodiscard]] KeyResult life_result(bearing::LifeModel model,
                                    bearing::LifeModification modification, double hours);

}  // namespace adore::results
