#pragma once

#include "dynamics/ball_springs.hpp"
#include "dynamics/element_masses.hpp"
#include "dynamics/held_contacts.hpp"
#include "dynamics/race_contacts.hpp"

#include <array>
#include <vector>

/// Grooves of held balls (constrained.hpp). Not included: races that tilt in time.
namespace adore::dynamics {

class QuasiStaticBalls final : public QuasiStaticContacts {
 public:
  /// @param contacts outlive this
  /// @param half of split races
  QuasiStaticBalls(const std::array<RaceContactModel, 2>& contacts,
                   const std::array<std::array<contact::SplitRaceHalf, 2>, 2>& half,
                   const ElementMasses& masses, std::size_t balls);

  void springs(const Evaluation& e, std::span<const std::size_t> held,
               std::span<ContactLinearization> out) noexcept override;
  [[nodiscard]] QuasiStaticPosition balanced(const Evaluation& e, std::size_t i,
                                             const Vec2& force) const override;
  [[nodiscard]] Vec2 normal_force(const Evaluation& e, std::size_t i) const noexcept override;
  [[nodiscard]] double max_free_displacement() const noexcept override {
    return kFreePath * offset_;
  }

 private:
  static constexpr double kFreePath = 0.02;  ///< over (groove - ball radius)

  /// Of one race, for identical balls and a race of revolution.
  void identical_ball_springs(const Evaluation& e, std::size_t j, std::span<const std::size_t> held,
                              std::span<ContactLinearization> out) noexcept;
  /// For all others.
  void general_ball_springs(const Evaluation& e, std::size_t j, std::span<const std::size_t> held,
                            std::span<ContactLinearization> out) const noexcept;
  [[nodiscard]] RacePose pose(const Evaluation& e, std::size_t j) const noexcept;
  [[nodiscard]] const ConstrainedBall& ball(std::size_t i) const noexcept {
    return balls_[i < balls_.size() ? i : balls_.size() - 1];
  }

  const std::array<RaceContactModel, 2>& contacts_;
  std::vector<ConstrainedBall> balls_;  ///< one for all, or each its own
  double offset_ = 0.0;                 ///< least groove radius - ball radius [m]
  BallSpringsKernel kernel_;
  std::vector<BallSpring> found_;
};

}  // namespace adore::dynamics
