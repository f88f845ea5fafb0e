#pragma once

#include "contact/cage_pieces.hpp"
#include "dynamics/effect.hpp"

#include <vector>

namespace adore::dynamics {

/// Pieces of the cage of a scene, which must have one, and their pockets, where its elements start.
[[nodiscard]] inline contact::CagePieces pieces_of(const SceneBuilder& scene) {
  std::vector<double> azimuths;
  for (const statics::StaticBall& element : scene.statics.balls)
    azimuths.push_back(element.azimuth);
  return contact::cage_pieces(*scene.bearing.cage, azimuths);
}

}  // namespace adore::dynamics
