#pragma once

#include "dynamics/effects/pockets.hpp"
#include "dynamics/element_masses.hpp"
#include "dynamics/held_contacts.hpp"
#include "dynamics/moving_frame.hpp"

#include <array>
#include <optional>
#include <vector>

/// Contacts of held balls: grooves with the fixed constants of constrained.hpp, the pocket's walls.
/// Only held balls are evaluated. Left out: contacts between neighbours, races that tilt in time.
namespace adore::dynamics {

class HeldBalls final : public HeldContacts {
 public:
  struct Scene {
    const std::array<RaceContactModel, 2>& contacts;
    const ElementMasses& masses;
    Vec3 gravity;                       ///< [m/s²]
    PocketSet* pockets;                 ///< null without pocket contact
    tribology::TractionLaw pocket_law;  ///< with pocket_traction
    bool pocket_traction;
    std::optional<MovingFrame> frame;  ///< a turning base frame
  };
  HeldBalls(const Scene& scene, std::size_t balls);

  void springs(const Evaluation& e, std::span<const std::size_t> held,
               std::span<HeldSprings> out) noexcept override;
  Vec3 forces(Evaluation& e, std::span<const std::size_t> held,
              std::span<const HeldSprings> springs, std::span<HeldForces> out) noexcept override;
  [[nodiscard]] HeldPlace balanced(const Evaluation& e, std::size_t i,
                                   const Vec2& force) const override;
  [[nodiscard]] Vec2 normal_force(const Evaluation& e, std::size_t i) const noexcept override;
  [[nodiscard]] double free_path() const noexcept override { return kFreePath * offset_; }

 private:
  static constexpr double kFreePath = 0.02;  ///< over (groove - ball radius)

  [[nodiscard]] RacePose pose(const Evaluation& e, std::size_t j) const noexcept;
  void add_walls(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept;
  /// Into action_, load_ ... of the held balls. Returns the force on the inner race [N].
  Vec3 race_forces(const Evaluation& e, std::span<const std::size_t> held) noexcept;
  Vec3 race_forces_one_by_one(const Evaluation& e, std::span<const std::size_t> held) noexcept;
  /// The walls that a located ball touches.
  [[nodiscard]] contact::WallPoints pocket_walls(std::size_t i) const noexcept;
  /// @param friction of the pockets (pocket_action)
  template <class Friction>
  void add_forces(const Friction& friction, const Evaluation& e, std::size_t i, std::size_t k,
                  const HeldSprings& springs, HeldForces& out) noexcept;

  [[nodiscard]] const ConstrainedBall& ball(std::size_t i) const noexcept {
    return balls_[i < balls_.size() ? i : balls_.size() - 1];
  }

  Scene scene_;
  std::vector<ConstrainedBall> balls_;  ///< one for all, or each its own
  double offset_ = 0.0;                 ///< least groove radius - ball radius [m]
  // One value per held ball.
  ElementStorage state_;
  ElementActions action_;  ///< forces and moments of the races
  std::array<std::vector<double>, 2> load_, heat_, load_slip_;
};

}  // namespace adore::dynamics
