#pragma once

#include "contact/conformal.hpp"
#include "contact/damping_law.hpp"
#include "contact/uneven_land.hpp"
#include "dynamics/effect.hpp"
#include "dynamics/effects/gathered_traction.hpp"
#include "dynamics/effects/heat_by_part.hpp"
#include "scene/snapshot.hpp"
#include "tribology/traction_law.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

/// Guide lands of a scene: what lands.cpp and uneven_lands.cpp share. SI.
namespace adore::dynamics {

struct LandModel {
  int race = 0;              ///< guiding race
  double side = 1.0;         ///< +1 outer guidance, -1 inner guidance
  double cage_radius = 0.0;  ///< R_c [m]
  contact::LandLaw law;
  contact::DampingLaw<> damping;
  double slice_length = 0.0;                  ///< [m]
  std::vector<double> slice_x;                ///< mid planes in the cage frame [m]
  std::optional<contact::UnevenLand> uneven;  ///< shape errors of the cage or of the race
};

/// The race that guides all lands; -1: both.
[[nodiscard]] inline int common_guide_race(const std::vector<LandModel>& lands) noexcept {
  int race = -1;
  for (const LandModel& land : lands) {
    if (land.slice_x.empty()) continue;
    if (race >= 0 && race != land.race) return -1;
    race = land.race;
  }
  return race;
}

struct LandSlicePosition {
  Vec3 centre;        ///< slice center, base frame [m]
  Vec3 eccentricity;  ///< across the race axis [m]
};

inline LandSlicePosition locate(double x, const BodyState& cage, const RaceBody& race) noexcept {
  const Vec3 centre = cage.position + x * cage.to_base.col(0);
  const Vec3 from_race = centre - race.position, axis = race.axis();
  return {centre, from_race - from_race.dot(axis) * axis};
}

/// Normal forces on each land of each segment as an evaluation left them, for a look.
struct LandForces {
  std::vector<Vec3> at;  ///< on the cage, axes of the base or of the land's race [N]

  void none() noexcept { std::fill(at.begin(), at.end(), Vec3::Zero()); }
};

/// Contact and traction of the lands that have shape errors (contact/uneven_land.hpp), which reads
/// no other; adds to `heat` what they dissipate.
template <bool Traction>
class UnevenLandBlock final : public EffectBlock {
 public:
  /// @param middle azimuth of each segment in the cage [rad]
  UnevenLandBlock(const std::vector<LandModel>& lands, const std::vector<double>& middle,
                  const tribology::TractionLaw& law, HeatByPart& heat, LandForces& kept)
      : lands_(lands),
        middle_(middle),
        law_(law),
        heat_(heat),
        kept_(kept),
        race_(common_guide_race(lands)) {}
  void apply(Evaluation& e) noexcept override;

 private:
  template <class Friction>
  void apply_to(const Friction& friction_per_slip, Evaluation& e, std::size_t piece,
                std::size_t which) noexcept;

  const std::vector<LandModel>& lands_;
  const std::vector<double>& middle_;
  tribology::TractionLaw law_;
  UserTractionBatch asked_;
  HeatByPart& heat_;
  LandForces& kept_;
  int race_;
};
extern template class UnevenLandBlock<false>;
extern template class UnevenLandBlock<true>;

/// Force, least gap over the slices and its azimuth in the frame of the cage or segment.
/// @param force of the evaluation made last [N]
[[nodiscard]] scene::LandSnapshot report_uneven_land(const LandModel& land, const Evaluation& e,
                                                     const BodyState& segment, double middle,
                                                     const Vec3& force);

}  // namespace adore::dynamics
