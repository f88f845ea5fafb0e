#pragma once

#include <array>
#include <cstddef>

#include "bearing/bearing.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "dynamics/snapshot.hpp"
#include "tribology/ellipse_traction.hpp"

/// The hot path: all ball/race contacts of one race in one call, vectorised over the balls (structure of arrays).
///
/// Geometry, slip, force and moment: tests/reference/dynamics_README.md ("Ball/race contact geometry", "Traction").
/// The normal force -Q n acts through the ball centre; the traction on the ball is along the slip (race minus ball).
namespace adore::dynamics {

/// States of n balls; each pointer addresses n values. Azimuth unit vectors e_r = (0,-s,c), e_θ = (0,-c,-s).
struct BallArrays {
  std::size_t n = 0;
  const double *x, *r, *sin_theta, *cos_theta;       ///< centre [m], azimuth
  const double *x_dot, *r_dot, *theta_dot;           ///< [m/s, m/s, rad/s]
  const double *omega_x, *omega_r, *omega_theta;     ///< absolute angular velocity on e_x, e_r, e_θ [rad/s]
};

/// Pose and motion of one race, base frame.
struct RaceMotion {
  Vec3 centre;        ///< P_j [m] (see groove.hpp)
  Vec3 axis;          ///< unit vector of the race's x axis
  double speed = 0.0; ///< Ω about its axis [rad/s]
  Vec3 velocity = Vec3::Zero();  ///< of P_j [m/s]
};

/// Constants of the contacts with one race.
struct RaceContactModel {
  bearing::Race race = bearing::kOuter;
  contact::GrooveGeometry groove;
  contact::HertzConstants hertz;             ///< one constant per race: the load has a potential 0.4 K δ^2.5
  double effective_modulus = 0.0;            ///< E* [Pa], reports only
  bool traction = true;
  bearing::TractionCurve curve;
  tribology::ContactSurface surface = tribology::ContactSurface::CurvedEdge;
  tribology::EllipseRule rule;               ///< fixed quadrature rule of the run
};

/// Results, n values each; forces and moments are ADDED to what is there.
struct BallForces {
  double *F_x, *F_r, *F_theta;   ///< on the ball [N]
  double *M_x, *M_r, *M_theta;   ///< about the ball centre [N m]
  double *load;                  ///< Q of this race [N] (assigned)
  double *heat;                  ///< ∫ κ p u dA [W] (assigned)
  double *load_slip;             ///< ∫ p u dA [W] (assigned); not touched when null
};

struct RaceSums {
  Vec3 force = Vec3::Zero();    ///< on the race [N]
  Vec3 moment = Vec3::Zero();   ///< on the race about P_j [N m]
  double elastic_energy = 0.0;  ///< Σ 0.4 K δ^2.5 [J]
  double heat = 0.0, load_slip = 0.0;
};

/// Evaluates one race. No allocation, no throw. Chooses the widest vector unit of the machine at first use.
RaceSums evaluate_race_contacts(const RaceContactModel& model, const BallArrays& balls, const RaceMotion& race,
                                const BallForces& out) noexcept;

/// Everything a report wants of one contact (angles, ellipse, spin-to-roll, largest slip ...); not for the hot path.
/// With `converged` the traction integrals are split at kinks and reversals instead of using model.rule.
RaceContactSnapshot race_contact_detail(const RaceContactModel& model, const BallArrays& balls, std::size_t index,
                                        const RaceMotion& race, bool converged = false);

/// Name of the instruction set that evaluate_race_contacts uses here: "avx512", "avx2", "baseline".
const char* race_contact_instruction_set() noexcept;

}  // namespace adore::dynamics
