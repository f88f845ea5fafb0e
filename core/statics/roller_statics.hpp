#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "bearing/race_motion.hpp"
#include "statics/race_result.hpp"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Quasi-static equilibrium of a roller bearing: every roller between its races and flanges, the
/// inner race under its loads.
///
/// Freedoms. A roller moves in its azimuth plane: axially, radially, and in tilt. Skew is zero:
/// without friction nothing loads it but what misalignment does in second order. With friction
/// (RollerOptions::friction_balance) loaded rollers then get skew, spin and orbit from their
/// balance (roller_friction.hpp), and all else follows. The inner race has the five freedoms of the
/// ball solution. Forces. Slices of each roller against each race (contact/slice_contact.hpp) with
/// the power law of contact/line_contact.hpp, roller ends against flanges
/// (contact/roller_flange.hpp), centrifugal force and gyroscopic moment of the speeds of pure
/// rolling at nominal geometry, the same for all rollers: they do not follow the loads, and
/// unloaded rollers orbit with the others. No friction, but that straight raceways hold their
/// rollers axially (decision 109). All forces, those at the edge of a land too
/// (contact/land_edge.hpp), derive from a potential, so that line searches on it converge from
/// anywhere (race_equilibrium.hpp). Unloaded rollers have no unique place; the rule (decision 124),
/// which the solution carries in words: at rest they stand in the middle between both races and
/// carry nothing. At speed they rest on the outer race, cylinders at their nominal axial place or
/// as near to it as flanges allow, cones against the flange that stops them, barrels in the middle
/// of their groove: what the centrifugal force of a barrel has along its axis, F_c sin α_o, guide
/// ring or cage hold.
namespace adore::statics {

enum class RollerContact : unsigned char {
  Sliced,  ///< default: sees edges, lands, misalignment and partial contact
  Point  ///< one elliptical Hertz contact of the crown and groove radii: better physics for barrels
         ///< of moderate ellipticity that do not reach their ends (types 3 and 5 only)
};
enum class RollerKinematics : unsigned char {
  Exact,  ///< rotation of the race's tilt, three-dimensional slices: default
  Linear  ///< first order in all displacements: reference family D, cylindrical only
};

struct RollerSolution;

struct RollerOptions {
  int slices = 31;
  RollerContact contact = RollerContact::Sliced;
  RollerKinematics kinematics = RollerKinematics::Exact;
  double line_constant = 0.0;  ///< K_l of Q = K_l L^(8/9) δ^(10/9) [N/m²]; 0: of the materials
  std::optional<bearing::FrameMotion> frame;  ///< base frame that turns; speeds relative to it
  bool ball_balance = false;                  ///< of balls: BallStaticsOptions::friction_balance
  bool friction_balance = false;              ///< rollers with friction (roller_friction.hpp)
  double first_azimuth = 0.0;                 ///< of roller 1 [rad]
  double difference_share = 0.0;  ///< above 0: stiffness by differences too, displaced by this
                                  ///< share of the largest contact deflection
  bool guide = true;  ///< guide ring or cage hold what the centrifugal force of barrels has along
                      ///< their axis; false: nothing does, they lean on their grooves
  bool warm_start = false;  ///< begin at StaticConstraints::displacement even where it is 0
  const RollerSolution* start = nullptr;  ///< begin where an earlier solution of the same bearing
                                          ///< ended (sweeps, tables); outlives the call
};

/// One roller against one race.
struct RollerRaceContact {
  double load = 0.0;    ///< Q, size of the resultant of the slice loads [N]
  double moment = 0.0;  ///< Σ Q_k s_k about mid length, positive when the +x end carries more [N m]
  double contact_angle =
      std::numeric_limits<double>::quiet_NaN();  ///< of the resultant; both
                                                 ///< positive when the inner race pushes to +x
                                                 ///< [rad]; NaN unloaded
  double delta = 0.0;                            ///< largest penetration of a slice; < 0: gap [m]
  double stiffness = 0.0;                        ///< Σ dQ_k/dδ [N/m]
  double peak_pressure = 0.0;                    ///< [Pa]
  double peak_position = std::numeric_limits<double>::quiet_NaN();  ///< s of that slice [m]
  double half_width = 0.0;  ///< b of that slice; Point: semi-minor axis [m]
  double length = 0.0;      ///< in contact, along the roller; Point: major axis of the ellipse [m]
  bool at_edge = false;  ///< more than a tenth of the peak up to a roller corner or land edge: the
                         ///< stress there exceeds peak_pressure by an unknown amount
  std::vector<double> slice_load;      ///< Q_k [N]; empty for Point
  std::vector<double> slice_pressure;  ///< p_k [Pa]
};

/// One roller end against one flange.
struct RollerFlangeContact {
  bool present = false;
  double load = 0.0;  ///< [N]
  double gap =
      std::numeric_limits<double>::quiet_NaN();  ///< geometric interaction, < 0 contact [m]
  double height = std::numeric_limits<double>::quiet_NaN();  ///< of the contact up the face [m]
  double radius =
      std::numeric_limits<double>::quiet_NaN();  ///< of the contact from the roller axis [m]
  bool on_face = true;  ///< false: lip of the flange or corner of the roller, where stress is not
                        ///< Hertzian
};

/// Power of a roller's friction [W], by race.
struct RollerHeat {
  std::array<double, 2> traction{}, rolling{}, load_slip{}, flange{};
};

struct StaticRoller {
  double azimuth = 0.0;     ///< [rad]
  double x = 0.0, r = 0.0;  ///< middle of the roller: axial from its nominal place, radial [m]
  double tilt = 0.0;        ///< θ of the roller axis, nominal -axis_angle [rad]
  std::array<RollerRaceContact, 2> race;
  std::array<std::array<RollerFlangeContact, 2>, 2> flange;  ///< [race][side: -x, +x]
  bool idle = false;  ///< at rest, touches nothing; placed by rule
  // Of a roller in balance of friction (roller_friction.hpp).
  bool balanced = false;
  double skew = 0.0;  ///< ψ, moves the +x end of the axis towards y = z × x [rad]
  double spin_speed = 0.0, orbital_speed = 0.0;  ///< as in the solution [rad/s]
  RollerHeat heat;
  Eigen::Matrix<double, 3, 5> follow =
      Eigen::Matrix<double, 3, 5>::Zero();  ///< d(x, r, tilt)/d(displacement of the inner race)
};

/// Rollers in balance of friction: which are not.
struct RollerFrictionBalance {
  bool computed = false;
  std::string failure;            ///< why it was given up for the whole bearing; empty: it was not
  std::vector<std::size_t> left;  ///< loaded rollers without a balance, from 0

  /// Empty: all loaded rollers are in balance, or nothing was computed.
  [[nodiscard]] std::vector<Finding> findings() const;
};

struct RollerSolution : RaceResult {
  RollerFrictionBalance friction;
  std::vector<StaticRoller> rollers;
  std::vector<double> slice_position;     ///< s of the slices of a nominal roller [m]
  double slice_width = 0.0;               ///< [m]
  std::array<double, 2> line_constant{};  ///< K_l by race [N/m²]; Point: Hertz K [N/m^1.5]
  double orbital_speed = 0.0;             ///< ω_m about +x [rad/s]
  double spin_speed = 0.0;  ///< about the roller axis, relative to the orbiting frame [rad/s]
  double centrifugal_force = 0.0;      ///< on each roller [N]
  double guide_force = 0.0;            ///< on each barrel along its axis, by guide ring or cage [N]
  std::string unloaded_position_rule;  ///< where rollers stand that no load puts in place
  double gyroscopic_moment =
      0.0;                   ///< about y = z × x, what the contacts supply to each roller [N m]
  double roller_mass = 0.0;  ///< [kg]
  double mass_offset = 0.0;  ///< s_G of the mass centre from mid length [m]
};

/// Solves the equilibrium from a cold start.
/// @throws InputError when geometry, materials, options or constraints are not those of a bearing.
/// @throws SolverError saying why no equilibrium was found and what to do.
[[nodiscard]] RollerSolution solve_roller_statics(const bearing::Bearing& bearing,
                                                  const RollerOptions& options = {});

}  // namespace adore::statics
