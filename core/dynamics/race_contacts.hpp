#pragma once

#include "base/instruction_set.hpp"
#include "bearing/bearing.hpp"
#include "contact/angle_law.hpp"
#include "contact/damping_law.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "dynamics/elements.hpp"
#include "dynamics/race_kernel.hpp"
#include "dynamics/scene.hpp"
#include "tribology/ellipse_traction.hpp"
#include "tribology/laws/rolling_resistance.hpp"
#include "tribology/traction_law.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace adore::contact {
struct WavyGroove;
}

/// The hot path: all ball/race contacts of one race in one call, vectorised over the balls
/// (structure of arrays).
///
/// Contact axes c, t, n, approach δ and load Q of contact/ball_groove.hpp, with d = ball centre -
/// P_j and the race axis k:
///   with damping F of contact/damping_law.hpp stands for Q: traction, pressures, life and stored
///   loads are of the total force; the elastic energy, L below and the ellipse are of δ alone
///   slip at the ball centre u0 = V_P + ω × d - V_ball,  W = ω - ω_ball,  ω = Ω k + tilt
///   (ball_race_motion.hpp), traction as in ellipse_traction.hpp
///   on the ball:  F = -Q n + F_c c + F_t t,  M = M_c c + M_t t + M_n n about its centre;
///   constants that follow the contact angle add L c at its centre (contact/angle_law.hpp)
///   on the race:  -Σ F,  about P_j: -Σ (d × F + M)
/// Split races have a model for each half, with P_j the centre of its arc; moments of the sums are
/// about the race's own P_j (contact/split_race.hpp).
/// A race that is not one of revolution: contact/wavy_groove.hpp; it has a kernel of its own. So
/// have balls that differ: what is theirs is one value a lane.
/// Source: tests/reference/dynamics_README.md ("Ball/race contact geometry", "Traction"). The
/// traction power on ball and race together is -heat identically (also for the quadrature rule).
/// Limits: r_ball > a (load_limit); ball centre off the race axis. At zero contact angle c is -e_x
/// on the outer race and +e_x on the inner.
namespace adore::dynamics {

/// Pose and motion of one race as a rigid body of revolution, base frame: its angular velocity is
/// Ω k + tilt.
struct RaceMotion {
  Vec3 centre;                   ///< P_j [m] (see groove.hpp)
  Vec3 axis;                     ///< k, unit vector of the race's x axis
  double speed = 0.0;            ///< Ω about its axis [rad/s]
  Vec3 velocity = Vec3::Zero();  ///< of P_j [m/s]
  Vec3 tilt = Vec3::Zero();      ///< part of the angular velocity across k: dk/dt = tilt × k
  // Read of races that are not of revolution only.
  Vec3 z = Vec3::UnitZ();  ///< across k, where azimuths in the race begin before it turned
  double turn = 0.0;       ///< that the race has turned beyond z [rad]

  /// Where azimuths in the race begin now.
  [[nodiscard]] Vec3 zero() const noexcept;
};

struct UnequalBallModels;
class UserScratch;

/// Constants of the contacts with one race.
struct RaceContactModel {
  bearing::Race race = bearing::kOuter;
  contact::GrooveGeometry groove;
  contact::HertzConstants hertz;  ///< at one angle: frozen constants, and the scale of estimates
  contact::HertzAngleLaw angle;   ///< in their place where it follows the contact angle
  std::shared_ptr<const contact::WavyGroove> wavy;  ///< imperfections of the race; null: none
  double effective_modulus = 0.0;                   ///< E* [Pa]
  double shoulder_radius = 0.0;   ///< of this race [m], reports only; 0 = not given
  contact::DampingLaw<> damping;  ///< none: elastic
  bool traction = true;
  tribology::TractionLaw law;
  tribology::ContactSurface surface = tribology::ContactSurface::CurvedEdge;
  tribology::EllipseRule rule;  ///< fixed quadrature rule of the run (make_ellipse_rule)
  std::shared_ptr<const UnequalBallModels> own;  ///< balls that differ; null: all are alike
  contact::SplitRaceHalf half;                   ///< of a split race: this contact is with one half
  std::shared_ptr<UserScratch> points;           ///< of a law of the user; else null

  /// Of one ball. What is here is that of the nominal one.
  [[nodiscard]] const RaceContactModel& of(std::size_t ball) const noexcept;
};

/// Balls of unequal diameter in the grooves of one race: offset, Hertz constants and their laws are
/// each ball's own, and so is the radius of its contact surface. A law of traction with a film is
/// that of the nominal ball: its thickness changes by about half the relative deviation.
struct UnequalBallModels {
  std::vector<RaceContactModel> model;   ///< by ball
  std::vector<BallConstants> constants;  ///< the same for kernels
};
/// Gives `model`, of a nominal ball, those of balls that are `growth` larger [m]. All 0: nothing.
/// All 0 on a split race: the same ones for each ball.
/// @param angle where constants are frozen [rad]
/// @param count of balls
void set_unequal_balls(RaceContactModel& model, const bearing::BallGeometry& balls,
                       const bearing::RaceErrors& errors, std::vector<double> growth, double angle,
                       std::size_t count);

/// Load up to which a contact can be one [N]: there the ball lies in the race by its own radius, or
/// half the major axis is as long as that.
/// Of balls that differ the least one.
[[nodiscard]] double load_limit(const RaceContactModel& model) noexcept;

struct RaceSums {
  Vec3 force = Vec3::Zero();    ///< on the race [N]
  Vec3 moment = Vec3::Zero();   ///< on the race about P_j [N m]
  double elastic_energy = 0.0;  ///< Σ 0.4 K δ^2.5 [J]
  double heat = 0.0, load_slip = 0.0;
  double damping = 0.0;  ///< power that damping takes [W]
};

/// Evaluates one race. No allocation, no throw. Chooses the widest vector unit of the machine at
/// first use; the environment variable ADORE_ISA = baseline, avx2 or avx512 asks for another one.
/// With traction off, heat is 0.
RaceSums evaluate_race_contacts(const RaceContactModel& model, const ElementViews& balls,
                                const RaceMotion& race, const ElementForces& out) noexcept;

/// Can both races be evaluated at once? Alike balls on races of revolution, dry, under curves of
/// one form (no routine of the user), with one kind of surface and constants that follow the angle
/// for both or neither. Parameters of the curves and quadrature rules are not compared: they are
/// those of one bearing.
[[nodiscard]] bool can_share_vectors(const std::array<RaceContactModel, 2>& models) noexcept;
/// The same as of one race after the other, to rounding, where can_share_vectors says so and the
/// laws of both are of one curve; forces and moments of both go to the same arrays. Balls that fill
/// no vector of one race share one, if they fit.
std::array<RaceSums, 2> evaluate_both_races(const std::array<RaceContactModel, 2>& models,
                                            const ElementViews& balls,
                                            const std::array<RaceMotion, 2>& races,
                                            const std::array<ElementForces, 2>& out) noexcept;

// base/instruction_set.hpp
using adore::check_instruction_set_request;
using adore::chosen_instruction_set;
using adore::instruction_set_name;
using adore::InstructionSet;
using adore::is_instruction_set_available;

/// Everything a report wants of one contact (angles, ellipse, spin-to-roll, largest slip ...); not
/// for the hot path. Contact angle: outer atan2(n_x', n_r'), inner atan2(-n_x', -n_r') in the
/// race's own meridional plane; both positive when the inner race pushes the ball towards +x.
/// spin_to_roll = W_n / W_c, signed, 0 without rolling. `edge` is how far the contact stays below
/// the shoulder (N94), negative when it runs over; 0 when open or shoulder_radius is 0.
/// film_parameter, temperature_rise and contact_temperature are left at 0.
/// With `converged` the traction integrals are split at kinks and reversals instead of using
/// model.rule.
RaceContactSnapshot race_contact_detail(const RaceContactModel& model, const ElementViews& balls,
                                        std::size_t index, const RaceMotion& race,
                                        bool converged = false);

/// What evaluate_race_contacts found at one contact.
struct ContactSums {
  double heat = 0.0, load_slip = 0.0;
};
/// The same where the integrals of the state are known: they are not taken again.
RaceContactSnapshot race_contact_detail(const RaceContactModel& model, const ElementViews& balls,
                                        std::size_t index, const RaceMotion& race,
                                        const ContactSums& known);

/// Largest slip speed of every contact [m/s], 0 where it is open: max_slip of race_contact_detail,
/// to rounding, vectorised over the balls. No allocation.
/// @param scratch,slip n values each; what is in scratch is not told
void largest_slips(InstructionSet set, const RaceContactModel& model, const ElementViews& balls,
                   const RaceMotion& race, double* scratch, double* slip) noexcept;

/// Geometry and kinematics of one contact in its own axes; what race_contact_detail integrates.
struct RaceContactState {
  double approach = 0.0;               ///< δ [m], negative when open
  double approach_rate = 0.0;          ///< dδ/dt [m/s]
  double elastic = 0.0;                ///< Q without damping [N]
  Vec3 n, t, c;                        ///< contact axes in the base frame
  Vec3 arm;                            ///< d = ball centre - P_j, base frame [m]
  double angle = 0.0;                  ///< contact angle [rad]
  tribology::EllipseGeometry ellipse;  ///< Q = a = b = 0 when open
  tribology::EllipseKinematics motion;
  double share = 1.0;   ///< of the ellipse's load Q that the half of a split race carries
  double turned = 0.0;  ///< M of contact/split_race.hpp, along c [N]
  double energy = 1.0;  ///< φ of contact/split_race.hpp
};
RaceContactState race_contact_state(const RaceContactModel& model, const ElementViews& balls,
                                    std::size_t index, const RaceMotion& race);
/// Power that rolling resistance takes at one contact, a share of evaluate_race_rolling() [W].
[[nodiscard]] double race_rolling_heat(const RaceContactModel& model,
                                       const tribology::RollingResistance& rolling,
                                       const RaceContactState& state) noexcept;

/// Error of model.rule against the converged integrals over the loaded contacts of one race, for
/// reports (milliseconds per contact). Root mean squares in units of full traction κ(u_max) Q and
/// of that times a; heat of the race relative.
struct QuadratureRuleError {
  int contacts = 0;  ///< loaded ones
  double force = 0.0, moment = 0.0, heat = 0.0;
};
QuadratureRuleError measure_rule_error(const RaceContactModel& model, const ElementViews& balls,
                                       const RaceMotion& race);

/// The same with a given instruction set, for tests and benchmarks. An unavailable one falls back
/// to Baseline.
RaceSums evaluate_race_contacts(InstructionSet set, const RaceContactModel& model,
                                const ElementViews& balls, const RaceMotion& race,
                                const ElementForces& out) noexcept;

std::array<RaceSums, 2> evaluate_both_races(InstructionSet set,
                                            const std::array<RaceContactModel, 2>& models,
                                            const ElementViews& balls,
                                            const std::array<RaceMotion, 2>& races,
                                            const std::array<ElementForces, 2>& out) noexcept;

/// Rolling resistance of the oil in the inlets of one race (effects/rolling_resistance.cpp), added
/// to forces and moments; load, heat and load_slip of `out` are scratch here. heat of the sums is
/// its power, the rest of them forces on the race.
RaceSums evaluate_race_rolling(const RaceContactModel& model,
                               const tribology::RollingResistance& rolling,
                               const ElementViews& balls, const RaceMotion& race,
                               const ElementForces& out) noexcept;
RaceSums evaluate_race_rolling(InstructionSet set, const RaceContactModel& model,
                               const tribology::RollingResistance& rolling,
                               const ElementViews& balls, const RaceMotion& race,
                               const ElementForces& out) noexcept;

/// Name of the instruction set that evaluate_race_contacts uses here: "avx512", "avx2", "baseline".
const char* race_contact_instruction_set() noexcept;

}  // namespace adore::dynamics
