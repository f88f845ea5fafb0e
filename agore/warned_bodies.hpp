#pragma once

#include "base/finding.hpp"

#include <array>
#include <set>
#include <span>
#include <string>

namespace adore::agore {

/// Bodies that warnings and errors of a run are about; the bearing view draws a ring around each.
struct WarnedBodies {
  std::set<int> elements;       ///< from 1
  bool cage = false;            ///< a pocket counts as the cage
  std::array<bool, 2> races{};  ///< outer, inner; one whose element is named is not marked
  bool operator==(const WarnedBodies&) const = default;
  [[nodiscard]] bool empty() const { return *this == WarnedBodies{}; }
  /// "ball 3, cage"; of more than three elements only the number: "5 rollers, inner race".
  [[nodiscard]] std::string names(bool balls) const;
};

[[nodiscard]] WarnedBodies warned_bodies(std::span<const Finding> findings);

}  // namespace adore::agore
