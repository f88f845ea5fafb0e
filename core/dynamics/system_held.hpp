#pragma once

#include "dynamics/constrained.hpp"
#include "dynamics/system_effects.hpp"
#include "dynamics/system_pockets.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// Light-load balance in a run (record 2.1 qFac): balls whose inertia in x and r is left out.
///
/// A held ball keeps x, r, θ, θ̇ and its spin as state; m r² θ̇ changes by r F_θ as always. Instead
/// of ẍ and r̈ its x and r follow the balance
///   G = (F_x, F_r + m r θ̇²) = 0,   F of all forces: races with friction, pocket, gravity,
/// by first-order motion  (ẋ, ṙ) = w + A⁻¹ G(w),  where
///   w = B⁻¹ (∂G/∂t along θ, L, races and cage; normal forces and gravity): the rates of the
///   balance, A = T B + C,  B = -∂G/∂(x, r) of the normal forces at fixed L,  C = Q κ/u per contact
///   (friction force over slip), T = kRelaxation times the time scale.
/// So G decays within T where normal forces restore the ball, and friction alone sets the rates
/// where it is stronger than that. A departure from balance approaches it no faster than
/// kLargestPull × (groove radius - ball radius) in T. w needs no friction; G(w) is formed by a
/// first pass over the held balls, and the pass over all balls then forms every slip with (ẋ, ṙ)
/// itself. Hence the right-hand side is a pure function of (t, y) and the set of held balls, and
/// the energy that the motion takes is exactly ∫ G·(ẋ, ṙ) dt, an item of the ledger; the kinetic
/// energy ½m(ẋ² + ṙ²) is left out of the stored energy. ẋ and ṙ of held balls stand in the state as
/// zero. Limits: races that tilt in time are followed by the pull alone; the load of a held ball is
/// below a stated share of the bearing's, so it follows within T (a few contact periods).
namespace adore::dynamics {

inline constexpr double kRelaxation = 3.0;    ///< T over the time scale of the run
inline constexpr double kLargestPull = 0.02;  ///< step limit of the pull over the groove offset

class HeldBalls {
 public:
  struct Scene {
    const std::array<RaceContactModel, 2>& contacts;
    double mass;              ///< of a ball [kg]
    Vec3 gravity;             ///< [m/s²]
    PocketSet* pockets;       ///< null without pocket contact
    SlipFriction pocket_law;  ///< with pocket_traction
    bool pocket_traction;
  };
  HeldBalls(const Scene& scene, const BallSlices& slices, std::size_t balls);

  void set_relaxation_time(double seconds) noexcept { relaxation_ = seconds; }
  void set(std::size_t i, bool held);
  [[nodiscard]] bool is_held(std::size_t i) const noexcept { return flags_[i] != 0; }
  [[nodiscard]] const std::vector<std::size_t>& list() const noexcept { return list_; }

  /// (ẋ, ṙ) of any ball at the state evaluated last, and G of a held one [N].
  [[nodiscard]] Vec2 rate(std::size_t i) const noexcept { return {x_dot_[i], r_dot_[i]}; }
  [[nodiscard]] Vec2 residual(std::size_t i) const noexcept { return residual_[i]; }

  /// The place where ball i would stand in balance with the normal forces of the races and all that
  /// acts besides them at the state evaluated last (`force` on x and r, [N]). L is kept.
  [[nodiscard]] BallBalance balanced(const Evaluation& e, std::size_t i, const Vec2& force) const;
  /// Normal forces of the races on (x, r) of ball i [N].
  [[nodiscard]] Vec2 normal_force(const Evaluation& e, std::size_t i) const noexcept;

  // For the blocks.
  void form_rates(Evaluation& e) noexcept;
  void take_inertia_out(Evaluation& e) noexcept;

 private:
  struct Estimate {
    Mat2 stiffness, inverse;    ///< B and B⁻¹ on its stiff directions
    Vec2 per_orbit;             ///< ∂G/∂L
    double normal_theta = 0.0;  ///< F_θ of normal forces and gravity [N]
    Mat2 race_along[2];         ///< I - n nᵀ of each race contact in (x, r)
  };
  [[nodiscard]] std::array<RacePose, 2> poses(const Evaluation& e) const noexcept;
  void gather(const Evaluation& e, std::size_t k) noexcept;
  void first_rates(const Evaluation& e, const std::array<RacePose, 2>& races,
                   std::size_t k) noexcept;
  void pull(Evaluation& e, std::size_t k) noexcept;

  Scene scene_;
  BallSlices slices_;
  ConstrainedBall ball_;
  double relaxation_ = 0.0, offset_ = 0.0;
  std::vector<unsigned char> flags_;
  std::vector<std::size_t> list_;      ///< held balls, rising
  std::vector<double> x_dot_, r_dot_;  ///< of all balls
  std::vector<Vec2> residual_;
  // One value per held ball.
  std::vector<Estimate> estimate_;
  std::array<std::vector<double>, 10> state_;  ///< BallArrays of the held balls
  std::array<std::vector<double>, 6> action_;  ///< forces and moments of the races
  std::array<std::vector<double>, 2> load_, heat_, load_slip_;
};

/// Gives held balls the rates (ẋ, ṙ) that all slips are formed with. After the kinematics, before
/// every force.
class HeldRates final : public EffectBlock {
 public:
  explicit HeldRates(HeldBalls& held) : held_(held) {}
  void apply(Evaluation& e) noexcept override { held_.form_rates(e); }

 private:
  HeldBalls& held_;
};

/// Replaces ẍ and r̈ of held balls by zero and books what their inertia would take. After the
/// equations of motion of the balls.
class HeldMotion final : public EffectBlock {
 public:
  explicit HeldMotion(HeldBalls& held) : held_(held) {}
  void apply(Evaluation& e) noexcept override { held_.take_inertia_out(e); }

 private:
  HeldBalls& held_;
};

}  // namespace adore::dynamics
