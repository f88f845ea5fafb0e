#pragma once

#include <array>
#include <cstddef>
#include <vector>

/// A look at the evaluation of the right-hand side that was made last: forces and heats that
/// it has formed anyway, and slips, for extremes between stored steps. As Snapshot would show them,
/// but with no evaluation, no allocation and nothing of the state, which may be gone.
namespace adore::scene {

enum class ExtremeQuantity : unsigned char {
  ContactLoad,  ///< element / race [N]
  ContactHeat,  ///< [W]
  ContactSlip,  ///< largest in the contact [m/s]
  FlangeForce,  ///< [N]
  FlangeSlip,   ///< [m/s]
  PocketForce,  ///< of contact, as reported [N]
  PairForce,    ///< of an element and the next one, without cage [N]
  LandForce,    ///< of cage and race [N]
  RaceForceX,   ///< load or reaction of a race, base frame [N, N m]
  RaceForceY,
  RaceForceZ,
  RaceMomentX,
  RaceMomentY,
  RaceMomentZ
};
inline constexpr std::size_t kExtremeQuantityCount = 14;

struct Look {
  /// In the order of the places in Snapshot: element, race (contacts); element, race, side
  /// (flanges); element, then last halves, surface (pockets); segment, land. Empty: the scene has
  /// no such effect, and what would be shown is 0.
  std::array<std::vector<double>, kExtremeQuantityCount> values;

  [[nodiscard]] std::vector<double>& operator[](ExtremeQuantity what) noexcept {
    return values[static_cast<std::size_t>(what)];
  }
  [[nodiscard]] const std::vector<double>& operator[](ExtremeQuantity what) const noexcept {
    return values[static_cast<std::size_t>(what)];
  }
};

}  // namespace adore::scene
