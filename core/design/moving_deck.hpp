#pragma once

#include "deck/deck.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

/// A deck of motion from any deck, for a first moving picture: cage with clearance, guide lands,
/// friction, gravity, monitored bodies, and a run of some revolutions that is stored for animation.
///
/// A cage of the deck, friction curves and gravity that the deck has are kept. Otherwise
/// [estimated, proportions of the example decks; no manufacturer publishes them], with D the
/// diameter, L the length of the elements and dm the pitch diameter:
///   land clearance 0.005 dm; outer diameter of a guided cage: the shoulder or flange of the race
///   less that clearance; pocket clearance 0.02 D (balls), 0.023 D (cylindrical), 0.026 D
///   (tapered), 0.0114 D (spherical); width 1.4 D (balls), 1.33 L, 1.21 L (tapered), within the
///   race.
/// Balls and cylindrical rollers with flanges at the outer race have an outer-guided cage,
/// spherical rollers an inner-guided one; tapered rollers guide their cage. Friction: pockets 0.08,
/// lands 0.06, contacts with the races 0.06 at most where the deck has none.
namespace adore::design {

struct DynamicDeckProposal {
  /// What changes, as for Deck::set_all(), in units of the deck.
  std::vector<std::pair<std::string, std::string>> sets;
  std::vector<std::string> assumptions;  ///< a sentence each, for the user before the change
};

inline constexpr double kDynamicDeckRevolutions = 3.2;  ///< of the inner race against the outer one
inline constexpr long kDynamicDeckStoredSteps = 400;    ///< stored steps, about

/// Solves the equilibrium for the time scale.
/// @param deck without errors @param options run options as given
/// @throws InputError when the races do not rotate or a cage has no room; SolverError
[[nodiscard]] DynamicDeckProposal propose_dynamic_deck(
    const deck::Deck& deck, const std::map<std::string, std::string>& options = {});

}  // namespace adore::design
