#pragma once

#include "dynamics/effect.hpp"

#include <span>

/// Thermal steps: between two steps of the motion temperatures, geometry and material change while
/// the state moves to the new equilibrium (new_equilibrium.hpp), which books what that changes of
/// stored energy and momentum in the integrals declared here.
namespace adore::dynamics {

class ThermalSteps final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;

 private:
  int energy_index_ = -1, impulse_index_ = -1, angular_impulse_index_ = -1;  ///< in the state
};

}  // namespace adore::dynamics
