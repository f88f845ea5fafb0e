#pragma once

#include "dynamics/effect.hpp"

#include <span>

/// Thermal steps: between two steps of the motion temperatures, geometry and material change while
/// the state stays. What that changes of stored energy and momentum goes into the ledgers.
namespace adore::dynamics {

class ThermalSteps final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;
  /// Books a jump of the stored energy [J] and of the momenta.
  void book(std::span<double> y, double energy, const Momenta& before, const Momenta& after) const;

 private:
  int energy_ = -1, impulse_ = -1, angular_impulse_ = -1;  ///< in the state
};

}  // namespace adore::dynamics
