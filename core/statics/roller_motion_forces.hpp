#pragma once

#include "bearing/bearing.hpp"
#include "contact/roller_race.hpp"
#include "statics/roller_model.hpp"
#include "statics/roller_pose.hpp"
#include "statics/roller_race_law.hpp"
#include "tribology/bearing_drag.hpp"
#include "tribology/traction_law.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

/// Forces on a roller that moves steadily at its azimuth, by the laws and kernels of motion. SI.
///
/// A steady motion is u = (x, r, tilt φ, skew ψ, spin ω_s, orbit ω_m): middle C = (x, 0, r) and
/// axis
///   a = (cos φ cos ψ, sin ψ, sin φ cos ψ)   on (x, y, z) of roller_pose.hpp,
///   ω = ω_m e_x + ω_s a,   v = ω_m e_x × C.
/// Slices against the races with traction and rolling resistance (contact/roller_race.hpp,
/// statics/roller_kernel.hpp), roller ends against flanges with the traction of record 10.2
/// (dynamics/effects/roller_flanges.cpp has the same contact), drag of the medium. With W = ω_m +
/// Ω_f (Ω_f: base frame of record 9.5) and the mass center G = C + s_G a it is in balance where
///   F + m W² (0, G_y, G_z) = 0,   M_G = W e_x × H,   H = J_t ω' + (J_a - J_t)(ω'·a) a,
/// ω' = W e_x + ω_s a. Limits: no cage, no gravity; a race that is not round is taken as it is at
/// the azimuth of the roller, its slope loads the race only.
namespace adore::statics {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
inline constexpr int kPlaceX = 0, kPlaceR = 1, kPlaceTilt = 2, kPlaceSkew = 3, kPlaceSpin = 4,
                     kPlaceOrbit = 5;  ///< of u

struct RollerMotionAction {
  Vec6 rates = Vec6::Zero();     ///< out of balance, in the order of u, over the scales below
  Vec5 load = Vec5::Zero();      ///< share of the load on the inner race [N, N m]
  std::array<double, 2> race{};  ///< contact loads [N]
  double flange = 0.0;           ///< sum of flange loads [N]
  RollerHeat heat;
  Vec6 by_outer = Vec6::Zero();  ///< force and moment of the outer race about C [N, N m]
};

class RollerMotionForces {
 public:
  /// @param load scale of the contact loads [N]. Both references outlive the object.
  RollerMotionForces(const bearing::Bearing& bearing, const RollerModel& model, double load);

  /// @param same_outer action at this u with the outer race at this place, which is not computed
  /// again; its contact loads and heat are those of the inner race only
  [[nodiscard]] RollerMotionAction at(const RollerState& roller, const Vec6& u,
                                      const Races<double>& races,
                                      const RollerMotionAction* same_outer = nullptr) const;
  /// Scales of u: R, R, 1, 1, 1/T and R/(r T), with T² = m R/load. Rates are force over load,
  /// moments over load times R and J/(m R²).
  [[nodiscard]] const Vec6& units() const noexcept { return units_; }

 private:
  const bearing::Bearing& bearing_;
  const RollerModel& model_;
  std::array<std::vector<contact::RollerRaceSlices>, 2> slices_;  ///< by race and body
  std::array<tribology::TractionLaw, 2> law_;
  std::array<tribology::RollingResistance, 2> rolling_;
  bool rolls_ = false;
  tribology::TractionLaw flange_law_;
  std::optional<tribology::BearingDrag> drag_;
  RollerKernel kernel_;
  double load_, radius_;
  Vec6 units_;
};

}  // namespace adore::statics
