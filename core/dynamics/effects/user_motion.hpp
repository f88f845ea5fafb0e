#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/element_masses.hpp"
#include "scene/user_laws.hpp"

/// Routine ADRX1 of the user: loads on races, accelerations of races that it drives, motion of the
/// base frame. It is asked once an evaluation, when both races have their motion.
///
/// Loads F, M act on a race, M about its center. Along directions that are free they move it
/// (free_races.cpp), in mode 2 they are part of the balance of the inner race (race_balance.hpp).
/// A race that is held there carries its contacts' force C and F; its support gives the reaction
///   R = -(C + F),   power R·v + F·v,
/// so that F changes the reaction (SOL5, SOL6, PRINT) and is booked as a separate item of work, but
/// does not move the race. The velocity v of a held race is prescribed.
///
/// The base frame moves with acceleration A of its origin and turns at Ω, all in its own axes. A
/// body of mass m at ρ with velocity v and angular velocity ω relative to the frame, tensor I about
/// its mass center (base axes), feels
///   F = -m [A + Ω̇ × ρ + Ω × (Ω × ρ) + 2 Ω × v],
///   M = I(ω × Ω) - (ω + Ω) × I(ω + Ω) + ω × Iω - I Ω̇
/// (Newton and Euler for ω + Ω, written for ω: d(ω + Ω)/dt = ω̇ + Ω̇ + Ω × ω) [derived]. Power F·v +
/// M·ω, impulse and angular impulse are booked as work: A and Ω are any functions of time. Races
/// that are prescribed move as prescribed, relative to the frame; gravity keeps its direction in
/// the frame. Sign: a constant A acts as gravity -A. [SI, base axes]
///
/// An inner race that mode 2 places by its load and that ADRX1 drives follows the angular
/// acceleration about x and the accelerations along directions whose displacement is given
/// (kFS = 1): eight states. The load places it in the other directions.
namespace adore::dynamics {

/// Routine ADRX1 is active.
[[nodiscard]] bool has_user_motion(const ScenePlan& plan);
[[nodiscard]] std::unique_ptr<SceneEffect> make_user_motion(const ScenePlan& plan);
[[nodiscard]] std::span<const LedgerTerm* const> user_motion_terms();

class UserMotion final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;
  void start(std::span<double> y) const override;
  void report(const Evaluation& e, Snapshot& snapshot) const override;
  [[nodiscard]] bool moves_races() const noexcept override;
  /// As the routine promised: part of its shortest period, never beyond its next kink.
  [[nodiscard]] double longest_step(double t) const override;

  [[nodiscard]] const scene::UserMotion::MotionDeclaration& motion_declaration() const noexcept {
    return routine_->motion_declaration();
  }
  /// Of this evaluation, from Phase::Kinematics on.
  [[nodiscard]] const scene::UserMotion::Actions& actions() const noexcept { return actions_; }
  /// dF/dt of the load on the inner race [N/s]; known in mode 2 only.
  [[nodiscard]] const Vec3& load_rate() const noexcept { return load_rate_; }

 private:
  class CallRoutine;
  class FrameForces;
  class SupportedLoads;
  class SupportedLoadWork;
  class DrivenRaceMotion;
  class DrivenRaceRates;
  /// Elements do not act on the states of a driven inner race in mode 2.
  struct NoElementCoupling final : BorderBody {
    void add_rate_contribution(const Evaluation&, std::size_t, const Vec3&, const Vec3&,
                               double*) const noexcept override {}
  };

  void apply_frame_forces(Evaluation& e) noexcept;
  /// Of the load of race j what its support carries: force and moment.
  [[nodiscard]] Vec3 supported_force(const Evaluation& e, std::size_t j) const noexcept;
  [[nodiscard]] Vec3 supported_moment(const Evaluation& e, std::size_t j) const noexcept;

  scene::UserMotion* routine_ = nullptr;
  scene::UserMotion::Actions actions_{};
  Vec3 load_rate_ = Vec3::Zero();
  std::array<Vec3, 2> unloaded_race_centers_;
  bool has_balanced_race_ = false;           ///< mode 2
  Vec3 balanced_directions_ = Vec3::Zero();  ///< there: 1 along directions in balance
  ElementMasses masses_;
  // Now: of the frame on all bodies, and of loads on held races; about the base origin [N, N m].
  double frame_power_ = 0.0, supported_load_power_ = 0.0;  ///< [W]
  Vec3 frame_force_ = Vec3::Zero(), frame_moment_ = Vec3::Zero();
  Vec3 supported_force_ = Vec3::Zero(), supported_moment_ = Vec3::Zero();
  NoElementCoupling no_element_coupling_;
  Slice place_, velocity_, spin_;  ///< of a driven inner race in mode 2; spin and turn
  int frame_impulse_index_ = -1, frame_angular_impulse_index_ = -1, supported_impulse_index_ = -1,
      supported_angular_impulse_index_ = -1;  ///< in the state
};

}  // namespace adore::dynamics
