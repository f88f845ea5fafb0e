#pragma once

#include "dynamics/balanced_race.hpp"
#include "dynamics/constrained.hpp"
#include "dynamics/effects/pockets.hpp"
#include "dynamics/moving_frame.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Light-load balance in a run (record 2.1 qFac): balls whose inertia in x and r is left out.
///
/// A held ball keeps x, r, θ, θ̇ and its spin as state; m r² θ̇ changes by r F_θ as always. Instead
/// of ẍ and r̈ its x and r follow the balance
///   G = (F_x, F_r + m r θ̇²) = 0,   F of all forces: races with friction, pocket, gravity,
/// by first-order motion  (ẋ, ṙ) = w + (A + C)⁻¹ G(w),  where
///   w = B⁻¹ (∂G/∂t along θ, L and the races and their waves): rates of the balance of race
///   normals, B = -∂G/∂(x, r) of the normal forces at fixed L,  A = 2 √(m B), C = Q κ/u along the
///   contact, summed over the contacts (friction force over slip speed).
/// A departure from balance decays like that of a critically damped ball without inertia, at half
/// its natural frequency: not faster than the ball itself would move, and without vibration; where
/// friction is stronger than that, friction alone sets the rates. B is taken as
/// √(B² + (kSoft m θ̇²)²), so that a ball without contact keeps finite rates, and a ball nears its
/// balance no faster than by free fall from rest through kFreePath × (groove - ball radius).
///
/// w needs no friction; G(w) is formed by a first pass over the held balls, and the pass over all
/// balls then forms every slip with (ẋ, ṙ) itself. Hence the right-hand side is a pure function of
/// (t, y) and the set of held balls, and the energy that the motion takes is exactly ∫ G·(ẋ, ṙ) dt,
/// an item of the ledger. The kinetic energy ½m(ẋ² + ṙ²) is left out of the stored energy; ẋ and ṙ
/// of held balls stand in the state as zero.
///
/// Modes 1 and 2 hold all balls. In mode 2 the inner race follows its own balance by the same kind
/// of motion (balanced_race.hpp), and w holds what its velocity does to the balls.
///
/// Limits: w leaves out the cage, gravity and races that tilt in time; a held ball follows those,
/// and changes of friction, within its natural time √(m/B): microseconds along the contact normal,
/// up to milliseconds across an outer groove at low speed.
namespace adore::dynamics {

inline constexpr double kSoft = 1.0;  ///< softest stiffness that rates come from, over m θ̇²
inline constexpr double kFreePath = 0.02;  ///< see above

class HeldBalls {
 public:
  struct Scene {
    const std::array<RaceContactModel, 2>& contacts;
    double mass;                        ///< of a ball [kg]
    Vec3 gravity;                       ///< [m/s²]
    PocketSet* pockets;                 ///< null without pocket contact
    tribology::TractionLaw pocket_law;  ///< with pocket_traction
    bool pocket_traction;
    std::optional<MovingFrame> frame;  ///< a turning base frame
    bool axial_suppressed = false;     ///< x keeps its place (kDOF)
    BalancedRace* race = nullptr;      ///< an inner race in balance (mode 2)
  };
  HeldBalls(const Scene& scene, const ElementSlices& slices, std::size_t balls);

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

  /// What the inertia that is left out takes at this evaluation; moment about the base origin.
  struct Account {
    double power = 0.0;                                ///< [W]
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< [N, N m]
  };
  [[nodiscard]] const Account& account() const noexcept { return account_; }

  /// Gives held balls the rates (ẋ, ṙ) that all slips are formed with. After the kinematics, before
  /// every force.
  void form_rates(Evaluation& e) noexcept;
  /// Replaces ẍ and r̈ of held balls by zero and books what their inertia would take. After the
  /// equations of motion of the balls.
  void take_inertia_out(Evaluation& e) noexcept;

 private:
  struct Estimate {
    Mat2 damping, inverse;      ///< A and B⁻¹
    Vec2 per_orbit;             ///< ∂G/∂L
    double normal_theta = 0.0;  ///< F_θ of the races' normal forces [N]
    Mat2 race_along[2];         ///< I - n nᵀ of each race contact in (x, r)
    Mat3 race_stiffness[2];     ///< of each race contact on (x, r, θ) directions [N/m]
    Vec3 race_turning[2];       ///< change of its force as a wavy race turns [N/s]
  };
  [[nodiscard]] RacePose pose(const Evaluation& e, std::size_t j) const noexcept;
  [[nodiscard]] std::array<RacePose, 2> poses(const Evaluation& e) const noexcept;
  void estimate(const Evaluation& e, std::size_t k) noexcept;
  void first_rates(const Evaluation& e, std::size_t k) noexcept;
  /// Velocity of an inner race in balance with what the balls do at their first rates, and what the
  /// balls' rates get from it.
  void move_race(Evaluation& e) noexcept;
  void follow_race(const Evaluation& e, const Vec3& velocity) noexcept;
  /// The walls that a located ball touches.
  [[nodiscard]] contact::WallPoints pocket_walls(std::size_t i) const noexcept;
  /// @param friction of the pockets (pocket_action)
  template <class Friction>
  void pull(const Friction& friction, Evaluation& e, std::size_t k) noexcept;

  Scene scene_;
  ElementSlices slices_;
  ConstrainedBall ball_;
  double offset_ = 0.0;  ///< least groove radius - ball radius [m]
  std::vector<unsigned char> flags_;
  std::vector<std::size_t> list_;      ///< held balls, rising
  std::vector<double> x_dot_, r_dot_;  ///< of all balls
  std::vector<Vec2> residual_;
  Account account_;
  // One value per held ball.
  std::vector<Estimate> estimate_;
  ElementStorage state_;   ///< of the held balls
  ElementActions action_;  ///< forces and moments of the races
  std::array<std::vector<double>, 2> load_, heat_, load_slip_;
};

}  // namespace adore::dynamics
