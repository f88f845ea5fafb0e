#pragma once

#include "bearing/bearing.hpp"
#include "bearing/race_motion.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "statics/race_result.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Quasi-static equilibrium of a ball bearing: every ball between its races, the inner race under
/// its loads.
namespace adore::statics {

/// Angle at which the Hertz curvatures are taken.
enum class Curvature : unsigned char {
  Actual,     ///< each contact at its own angle, with its derivative in the stiffness: the better
              ///< physics, default
  Free,       ///< at the free contact angle
  Potential,  ///< as Actual, and the force is the gradient of 0.4 K(α) δ^2.5
              ///< (contact/angle_law.hpp): the start of a dynamic run
  Fixed  ///< at BallStaticsOptions::fixed_angle: the start of a dynamic run with frozen constants
};
enum class RingKinematics : unsigned char {
  Exact,  ///< rotation matrix of the race's tilt, as in dynamics: default
  Linear  ///< small-angle kinematics of the reference cases
};
/// How the gyroscopic moment is shared between the races (reference family C).
enum class Control : unsigned char {
  FromBearing,  ///< the bearing's spin rule (kAngVel): default
  Outer,
  Inner,
  Equal,
  None
};
enum class Orbit : unsigned char {
  PerBall,  ///< no gross slip at each ball's own angles: default
  Nominal   ///< (Ω/2)(1 - γ' cos α_free), no gyroscopic moment
};

struct BallStaticsOptions {
  Curvature curvature = Curvature::Actual;
  std::array<double, 2> fixed_angle{};  ///< [rad], per race, Curvature::Fixed only
  RingKinematics kinematics = RingKinematics::Exact;
  Control control = Control::FromBearing;
  Orbit orbit = Orbit::PerBall;
  std::optional<bearing::FrameMotion> frame;  ///< base frame that turns; speeds relative to it
  bool friction_balance = false;  ///< solve_ball_friction_balance() acts (ball_friction.hpp)
  double first_azimuth = 0.0;     ///< of ball 1 [rad]
  double difference_share = 0.0;  ///< above 0: stiffness by differences too, displaced by this
                                  ///< share of the largest contact deflection
  bool warm_start = false;  ///< use StaticConstraints::displacement of force-controlled directions
                            ///< as given, even when 0
};

/// Contact of a ball with the other half of a split race: the half with less load.
struct SecondContact {
  double Q = 0.0;                        ///< load; 0: the ball does not touch this half [N]
  double alpha = 0.0, delta = 0.0;       ///< contact angle [rad], approach [m]
  double a = 0.0, b = 0.0, p_max = 0.0;  ///< of the whole ellipse [m, Pa]
  double K = 0.0;                        ///< [N m^-1.5]
  double share = 1.0;                    ///< part of the ellipse's load on this side of the split
  double inner_chord = 0.0, shoulder_depth = 0.0;  ///< as of the first contact [m]
};

struct StaticBall {
  double azimuth = 0.0;           ///< [rad]
  double x = 0.0, r = 0.0;        ///< centre: axial in the base frame, radial [m]
  std::array<double, 2> Q{};      ///< contact loads [N]
  std::array<double, 2> alpha{};  ///< contact angles [rad]; both positive when the inner race
                                  ///< pushes the ball to +x; NaN when unloaded
  std::array<double, 2> delta{};  ///< approach [m]
  std::array<double, 2> a{}, b{}, p_max{};  ///< ellipse half axes [m] (a transverse), pressure [Pa]
  std::array<double, 2> spin_roll{};        ///< signed, as in reference family C
  std::array<double, 2>
      edge{};  ///< s of the outer and t of the inner contact, as the SOL files list them [m]
  std::array<double, 2> shoulder_depth{};  ///< s per race: depth of the far contact edge below the
                                           ///< shoulder [m]; NaN without shoulder or load
  std::array<double, 2> inner_chord{};     ///< t per race: groove-centre plane to the near contact
                                           ///< edge [m]; NaN unloaded
  std::array<double, 2> other_half{};  ///< per split race: gap between the ball and the half that
                                       ///< its contact is not on [m], < 0: it touches both;
                                       ///< NaN: not split, or unloaded
  std::array<double, 2> beyond{};      ///< part of Q whose place of the ellipse lies over the
                                       ///< shoulder, which the solution counts all the same [N]
  std::array<double, 2> friction{};    ///< coefficient of friction that the race must have to hold
                                       ///< the ball against its gyroscopic moment; NaN unloaded
  std::array<double, 2> K{};           ///< Hertz constants in use [N m^-1.5]
  std::array<double, 2> share{1.0, 1.0};  ///< part of the ellipse's load on this side of the split
  std::array<SecondContact, 2> second{};  ///< with the other half of a split race
  double orbital_speed = 0.0;             ///< ω_m [rad/s]
  double omega_x = 0.0, omega_r = 0.0,
         omega_theta = 0.0;        ///< ABSOLUTE angular velocity on (e_x, e_r, e_θ) [rad/s]
  double centrifugal_force = 0.0;  ///< [N]
  double gyroscopic_moment = 0.0;  ///< [N m]
  double spin_speed = 0.0;  ///< ω_R relative to the orbiting frame, sign of Ω_i - Ω_o [rad/s]
  double pitch_angle =
      0.0;  ///< β of the spin axis, positive for positive contact angles [rad]; NaN unloaded
  double axis_shift = 0.0;  ///< BallSite::axis_shift [rad]
  double race_control_ratio =
      0.0;  ///< Q_o a_o E_o cos(α_i - α_o)/(Q_i a_i E_i); NaN without both loads
  bool inner_race_control = false;  ///< spin axis taken from the inner race (race-control rule)
  bool inner_contact = false;
};

/// The ball with its second contacts in the place of the first, for sums over contacts. Without
/// second contact Q is 0.
[[nodiscard]] StaticBall ball_at_second_contacts(const StaticBall& ball);
[[nodiscard]] inline bool has_second_contact(const StaticBall& ball) {
  return ball.second[0].Q > 0.0 || ball.second[1].Q > 0.0;
}

struct StaticSolution : RaceResult {
  std::array<contact::HertzConstants, 2> hertz{};  ///< at the free angle (Free), fixed angle
                                                   ///< (Fixed), or of the most loaded ball (Actual)
  std::vector<StaticBall> balls;
  /// ball_at_second_contacts() of each ball that has a second contact.
  [[nodiscard]] std::vector<StaticBall> second_contacts() const;
  double race_control_ratio =
      0.0;  ///< > 1: outer race control by the classical criterion (most loaded ball)
};

/// Solves the equilibrium from a cold start: safeguarded Newton with exact derivatives (decision
/// 030). Equations: ball_forces.hpp and spin.hpp; spin rules: decision 031; balls that barely touch
/// the inner race: decision 032.
/// @throws InputError when geometry, materials or constraints are not those of a bearing.
/// @throws SolverError saying why no equilibrium was found (e.g. load cannot be carried in that
/// direction) and what to do.
[[nodiscard]] StaticSolution solve_ball_statics(const bearing::Bearing& bearing,
                                                const BallStaticsOptions& options = {});

}  // namespace adore::statics
