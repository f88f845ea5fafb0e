#pragma once

#include "statics/deck_fault.hpp"

namespace adore::statics {

/// The row has less thrust than its rollers turn its radial load into: no numerics can find an
/// equilibrium, the loads are to be mended.
class MissingThrust : public DeckFault {
 public:
  MissingThrust(std::string why, std::string remedy)
      : DeckFault("appLoadX", std::move(why), std::move(remedy)) {}
};

}  // namespace adore::statics
