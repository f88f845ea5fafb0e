#pragma once

#include "contact/cage_pieces.hpp"
#include "dynamics/effect.hpp"
#include "scene/user_laws.hpp"
#include "tribology/traction_law.hpp"

#include <vector>

namespace adore::dynamics {

/// Pieces of the cage of a scene, which must have one, and their pockets, where its elements start.
[[nodiscard]] inline contact::CagePieces pieces_of(const SceneBuilder& scene) {
  std::vector<double> azimuths;
  for (const statics::StaticBall& element : scene.statics.balls)
    azimuths.push_back(element.azimuth);
  return contact::cage_pieces(*scene.bearing.cage, azimuths);
}

/// The deck's traction curve, or the routine of the user that takes its place.
[[nodiscard]] inline tribology::TractionLaw traction_of(const SceneBuilder& scene,
                                                        tribology::TractionKind kind,
                                                        const bearing::TractionCurve& curve) {
  if (scene.options.user)
    if (const tribology::UserTractionRoutine* routine = scene.options.user->traction_of(kind))
      return {*routine, kind};
  return curve;
}

/// Sets the heat of a kind of contacts to zero before the blocks that add to it.
class ResetHeat final : public EffectBlock {
 public:
  explicit ResetHeat(double& heat) : heat_(heat) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation&) noexcept override { heat_ = 0.0; }

 private:
  double& heat_;
};

}  // namespace adore::dynamics
