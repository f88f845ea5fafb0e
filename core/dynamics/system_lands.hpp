#pragma once

#include "contact/conformal.hpp"
#include "dynamics/snapshot.hpp"
#include "dynamics/system_effects.hpp"

/// Guide lands of the cage on the cylindrical lands of the races.
///
/// A land is cut into slices, each taken at its mid plane as a circle of the cage about the cage
/// axis inside (outer guidance) or around (inner guidance) a circle of the race about the race
/// axis, whose radii differ by the radial clearance c. e = vector from the race axis to the slice
/// centre, across the race axis; contact where |e| > c. Normal: F/L of contact/conformal.hpp on the
/// cage along -e through the slice centre, the opposite on the race; it is minus the gradient of
/// the slice energy. Friction at the cage point P = slice centre ± R_c e/|e| (+ outer, - inner
/// guidance): slip = race point - cage point velocity, its part along e removed; N κ(|u|) u/|u| on
/// the cage, the opposite on the race at the same point. Heat = friction · u. Tilt enters through
/// the slice centres; second order in tilt.
namespace adore::dynamics {

struct LandModel {
  int race = 0;              ///< guiding race
  double side = 1.0;         ///< +1 outer guidance, -1 inner guidance
  double cage_radius = 0.0;  ///< R_c [m]
  contact::LandLaw law;
  double slice_length = 0.0;    ///< [m]
  std::vector<double> slice_x;  ///< mid planes in the cage frame [m]
};

/// One entry per land of the cage; lands without a guiding race have no slices.
std::vector<LandModel> make_lands(const bearing::Bearing& bearing, int slices);

/// Force, least gap over the slices and its azimuth in the cage frame.
LandSnapshot report(const LandModel& land, const Evaluation& e);

/// Effect "land contact" of all lands, with friction when Traction. `lands` must outlive the block.
template <bool Traction>
class LandBlock final : public EffectBlock {
 public:
  LandBlock(const std::vector<LandModel>& lands, const SlipFriction& friction)
      : lands_(lands), friction_(friction) {}
  void apply(Evaluation& e) noexcept override;

 private:
  const std::vector<LandModel>& lands_;
  SlipFriction friction_;
};
extern template class LandBlock<false>;
extern template class LandBlock<true>;

}  // namespace adore::dynamics
