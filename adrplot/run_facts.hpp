#pragma once

#include "adrplot/known_values.hpp"
#include "results/motion.hpp"
#include "results/sol_file.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

/// Meaning of values of a plot file that is not clear from the values.
namespace adore::adrplot {

/// From "stored" of the RUN.json of the run. Empty: unknown.
struct RunFacts {
  std::optional<int> life_every;              ///< steps between life predictions; 0: first, last
  std::optional<bool> temperatures_computed;  ///< else input values of the deck
  std::optional<bool> races_held;             ///< no race moves under loads
  /// Flanges of the races: "inner.1" at −x, "outer.2" at +x. Empty optional: unknown.
  std::optional<std::set<std::string>> flanges;
  std::optional<results::CageLengthScale> cage_length_scale;  ///< divisor of the cage orbit
};

/// Divisor of a cage orbit (N71): from the run, else from the file. Length: positions [m or in]
/// over ratios; 0: unknown.
struct OrbitScale {
  results::CageLengthScale::Of of = results::CageLengthScale::Of::GuideLands;
  double length = 0.0;  ///< in `unit`
  std::string unit;
  bool segment = false;
};
[[nodiscard]] OrbitScale orbit_scale(const results::SolFile& file, const ValidColumns& columns,
                                     const RunFacts& facts);
/// A sentence; and "clearance", "pocket clearance" or "1 m" for the titles of axes.
[[nodiscard]] std::string orbit_note(const OrbitScale& scale);
[[nodiscard]] std::string orbit_divisor_text(const OrbitScale& scale);

/// Directions in which a race file contains reactions instead of loads: its position (or angle, or
/// speed) is constant. Empty: none.
[[nodiscard]] std::string prescribed_motion_note(const ValidColumns& columns, bool moments);

/// A column with a constant value. False for fewer than two steps.
[[nodiscard]] bool is_constant(const std::vector<double>& values, double rounding);

/// Reason for a flange column without values, from the known data of the race. `where`: e.g.
/// ".inner.2".
[[nodiscard]] std::string missing_flange_reason(const std::string& where, const RunFacts& facts,
                                                bool part);
[[nodiscard]] bool has_no_flange(const std::string& column, const RunFacts& facts);

}  // namespace adore::adrplot
