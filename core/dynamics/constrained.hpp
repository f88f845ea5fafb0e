#pragma once

#include "base/rotation.hpp"
#include "contact/angle_law.hpp"
#include "contact/groove.hpp"

#include <array>

namespace adore::contact {
struct WavyGroove;
}

/// Motion with inertia left out where it hardly acts: a ball whose x and r stand in force balance
/// at every instant while its orbit stays dynamic (mode 1, light-load balance), races in balance
/// (mode 2), suppressed accelerations (kDOF). SI, rad, base axes; G = force balance in x and r.
///
/// Contact with race j: contact/ball_groove.hpp, K fixed or following the contact angle
/// (contact/angle_law.hpp): it has a potential V.
/// Balance at azimuth θ: G = (F_x - V_x, F_r - V_r + centrifugal(r)) = 0, and everything implicit
/// follows from ∂G/∂(x, r).
/// Limits: frictionless normal contacts plus given forces; ball center off the race axis.
namespace adore::dynamics {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

/// Pose of one race: P_j and the unit vector of its axis.
struct RacePose {
  Vec3 centre = Vec3::Zero();
  Vec3 axis = Vec3::UnitX();
  Vec3 zero = Vec3::UnitZ();  ///< across the axis, where azimuths in the race begin now; read of
                              ///< races that are not of revolution only
  Mat3 to_base = Mat3::Identity();  ///< from the frame of the other members; of balls that are not
                                    ///< round only
};

/// One ball/race contact at a ball position; vectors in the azimuth frame (e_x, e_r, e_θ) of the
/// ball.
struct GrooveContact {
  double approach = 0.0;          ///< δ, negative when open [m]
  double load = 0.0;              ///< Q [N]
  double angle = 0.0;             ///< contact angle, 0 when open [rad]
  double energy = 0.0;            ///< V [J]
  Vec3 force = Vec3::Zero();      ///< -∂V/∂p on the ball [N]
  Vec3 normal = Vec3::Zero();     ///< n, from the ball towards the race
  Mat3 bending = Mat3::Zero();    ///< ∂n/∂p = ∂²l/∂p² [1/m]
  Mat3 stiffness = Mat3::Zero();  ///< ∂²V/∂p², symmetric, 0 when open [N/m]
};

/// Conserved quantity of the orbit while x and r adjust: the orbital speed θ̇ (centrifugal force m r
/// θ̇²) or, the choice that conserves energy, the angular momentum L = m r² θ̇ (force L²/(m r³)).
struct Orbit {
  enum class Kept : unsigned char { Speed, Momentum };
  Kept kept = Kept::Momentum;
  double value = 0.0;  ///< θ̇ [rad/s] or L [kg m²/s]
};

/// Position of a ball and the derivatives that the balance needs.
struct BallBalance {
  double x = 0.0, r = 0.0;
  double speed = 0.0;  ///< θ̇ of the orbit at this r [rad/s]
  std::array<GrooveContact, 2> contact;
  Vec2 residual = Vec2::Zero();   ///< G [N]
  Mat2 stiffness = Mat2::Zero();  ///< -∂G/∂(x, r), symmetric [N/m]
  Vec2 per_theta = Vec2::Zero();  ///< ∂G/∂θ at fixed x, r [N]
  Vec2 per_orbit = Vec2::Zero();  ///< ∂G/∂(orbit value)
  double force_theta = 0.0;       ///< of the contacts along e_θ [N]
  double potential = 0.0;         ///< Σ V + centrifugal potential - F·(x, r) [J]
  int iterations = 0;
  bool solved = false;  ///< |G| is at rounding level
  [[nodiscard]] Vec2 place() const noexcept { return {x, r}; }
};

/// A ball between its two races.
class ConstrainedBall {
 public:
  /// @param K Hertz constants [N m^-1.5], outer and inner; where `law` follows the contact angle,
  /// of a scale only
  ConstrainedBall(const contact::GrooveGeometry& groove, const std::array<double, 2>& K,
                  double mass, const std::array<contact::HertzAngleLaw, 2>& law = {}) noexcept
      : groove_(groove), K_(K), law_(law), mass_(mass) {}

  /// @param wavy imperfections of the races, null: none; outlive this
  /// @param number of the ball, where balls are not round
  void set_wavy_grooves(const std::array<const contact::WavyGroove*, 2>& wavy,
                        std::size_t number = 0) noexcept {
    wavy_grooves_ = wavy;
    ball_index_ = number;
  }
  /// @param half of split races, by race
  void set_split_halves(const std::array<std::array<contact::SplitRaceHalf, 2>, 2>& half) noexcept {
    half_ = half;
  }
  [[nodiscard]] double mass() const noexcept { return mass_; }
  /// Radius of the ball circle between the unloaded grooves, for a first guess [m].
  [[nodiscard]] double mid_radius() const noexcept {
    return 0.5 * (groove_.centre_radius[0] + groove_.offset[0] + groove_.centre_radius[1] -
                  groove_.offset[1]);
  }
  [[nodiscard]] const contact::GrooveGeometry& groove() const noexcept { return groove_; }
  [[nodiscard]] const std::array<double, 2>& hertz_constants() const noexcept { return K_; }
  /// @param pose in the azimuth frame of the ball; place x and r of its center
  [[nodiscard]] GrooveContact contact_with(int race, const RacePose& pose,
                                           const Vec2& place) const noexcept;
  /// The same with a split race: force, stiffness and energy of both halves, the rest of the one
  /// with more load.
  [[nodiscard]] GrooveContact split_contact(int race, const RacePose& pose,
                                            const Vec2& place) const noexcept;
  /// The same with a wavy race. @param per_turn change of the force on the ball, -Q n, with the
  /// turn of the race about its axis [N/rad]
  [[nodiscard]] GrooveContact wavy_contact(int race, const RacePose& pose, const Vec2& place,
                                           Vec3& per_turn) const noexcept;
  /// The balance at a given place, not solved for. `force` acts on (x, r).
  [[nodiscard]] BallBalance evaluate(const std::array<RacePose, 2>& races, double theta,
                                     const Orbit& orbit, const Vec2& force,
                                     const Vec2& x_r) const noexcept;
  /// Solves G = 0 for (x, r) from `guess`: Newton with the analytic Hessian on the potential;
  /// eigenvalues that are not positive are replaced, the step is limited to a few δ and halved
  /// until |G| or the potential decreases. With neither orbit nor force and no load on the inner
  /// race the solution is the limit of vanishing centrifugal force: outer gap 0 at the groove
  /// bottom seen along e_r. A groove is
  /// a closed circle here and takes any force; loads beyond Hertz are the caller's to refuse.
  /// `solved` is false when the iteration ends above rounding level.
  [[nodiscard]] BallBalance solve(const std::array<RacePose, 2>& races, double theta,
                                  const Orbit& orbit, const Vec2& force,
                                  const Vec2& guess) const noexcept;

 private:
  [[nodiscard]] Vec2 unloaded_position(const RacePose& outer, double theta,
                                       const Vec2& guess) const noexcept;
  [[nodiscard]] double orbital_speed_at(const Orbit& orbit, double r) const noexcept;

  contact::GrooveGeometry groove_;
  std::array<double, 2> K_;
  std::array<contact::HertzAngleLaw, 2> law_;
  double mass_;
  std::array<const contact::WavyGroove*, 2> wavy_grooves_{};
  std::size_t ball_index_ = 0;
  std::array<std::array<contact::SplitRaceHalf, 2>, 2> half_{};
};

/// Derivatives of the solved (x, r); each column or vector is -(∂G/∂(x,r))⁻¹ ∂G/∂(...). Directions
/// in which the ball has no stiffness (all contacts open) do not move.
struct BallSensitivity {
  Vec2 per_theta, per_orbit;
  Eigen::Matrix<double, 2, 3> per_inner_centre;
};
[[nodiscard]] BallSensitivity sensitivity(const BallBalance& balance, double theta) noexcept;
/// Axes of the azimuth frame as rows: base to azimuth.
[[nodiscard]] Mat3 azimuth_frame(double theta) noexcept;

/// (ẋ, ṙ) of a ball in balance whose races stand still: used in slip velocities and at release,
/// never in the balance itself. orbit_rate = L̇ = r F_θ when L is kept, θ̈ otherwise.
[[nodiscard]] inline Vec2 implicit_rates(const BallSensitivity& s, double theta_dot,
                                         double orbit_rate) noexcept {
  return s.per_theta * theta_dot + s.per_orbit * orbit_rate;
}

/// A ball becomes held: L stays, (x, r) go to balance, ẋ and ṙ are dropped.
struct QuasiStaticTransition {
  BallBalance after;           ///< its potential is the energy after
  double energy_before = 0.0;  ///< ½m(ẋ² + ṙ²) + L²/(2mr²) + Σ V - F·(x, r) [J]
  double jump = 0.0;           ///< after - before, to be booked [J]
};
/// @param orbit keeps the momentum
[[nodiscard]] QuasiStaticTransition hold(const ConstrainedBall& ball,
                                         const std::array<RacePose, 2>& races, double theta,
                                         const Orbit& orbit, const Vec2& force, const Vec2& place,
                                         const Vec2& rates) noexcept;

/// Light-load balance with hysteresis (record 2.1): held from `threshold` down, released above
/// kReleaseRatio × threshold; between the two nothing changes. threshold <= 0: never held.
inline constexpr double kReleaseRatio = 1.1;
[[nodiscard]] constexpr bool is_quasi_static_next(bool held, double largest_load, double threshold,
                                                  double release_ratio = kReleaseRatio) noexcept {
  if (!(threshold > 0.0)) return false;
  return held ? largest_load <= release_ratio * threshold : largest_load <= threshold;
}

/// Accelerations set to zero (kDOF). Element: x, r, θ, then ω_x, ω_y, ω_z of the azimuth frame;
/// cage: x, y, z, ω_x, ω_y, ω_z. 0 none; 1 x of elements and cage; 2 also ω_y, ω_z of both; 3 as 1
/// and 4 as 2, of elements only; 5 all six of elements.
/// @throws InputError for another code
void suppress_accelerations(int kdof, std::array<double, 6>& element, std::array<double, 6>& cage);

}  // namespace adore::dynamics
