#pragma once

#include "dynamics/balanced_race.hpp"
#include "dynamics/effect.hpp"

#include <optional>

/// Mode 2: the inner race is in force balance along the directions whose load is given
/// (balanced_race.hpp), whose turning share (9.3A) turns as a load; the others follow their laws of
/// time (9.3B). A load of user routine ADRX1 is added to it (user_motion.hpp). Its
/// center is state, in the border of the arrow; its speed and tilt stay prescribed. Its work on
/// the elements is the work of the inner race in the ledger: the load's work, minus the energy of
/// its motion to the balance. Its velocity: held_elements.hpp.
namespace adore::dynamics {

class RaceBalance final : public SceneEffect, public BorderBody {
 public:
  void declare(SceneBuilder& scene) override;
  void start(std::span<double> y) const override;
  [[nodiscard]] bool moves_races() const noexcept override { return true; }
  void add_rate_contribution(const Evaluation& e, std::size_t i, const Vec3& force,
                             const Vec3& moment, double* row) const noexcept override;

  [[nodiscard]] BalancedRace& race() noexcept { return *race_; }

 private:
  class Place;
  class Motion;
  class UserLoad;

  std::optional<BalancedRace> race_;
  Vec3 start_ = Vec3::Zero();  ///< static center [m]
  Slice centre_;
};

}  // namespace adore::dynamics
