#pragma once

#include "scene/ledger.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

/// Everything the outputs may show of one instant, in SI and radians. Observers and writers read
/// this and nothing else.
namespace adore::scene {

using Vec3 = Eigen::Vector3d;

/// Unit quaternion (w, x, y, z), body -> base frame.
using Quat = std::array<double, 4>;

struct RaceContactSnapshot {
  double load = 0.0;                          ///< Q [N]
  double angle = 0.0;                         ///< contact angle [rad]; 0 when open
  double half_major = 0.0, half_minor = 0.0;  ///< a (transverse), b (rolling) [m]
  double max_pressure = 0.0;                  ///< [Pa]
  double spin_to_roll = 0.0;                  ///< signed W_n / W_c of dynamics_README
  double max_slip = 0.0;                      ///< largest slip speed in the ellipse [m/s]
  double heat = 0.0;                          ///< ∫ κ p u dA [W]
  double rolling_heat = 0.0;                  ///< rolling resistance of the oil [W]
  double damping_heat = 0.0;                  ///< taken by contact damping [W]
  double load_slip = 0.0;                     ///< ∫ p u dA [W]
  double film = 0.0;                          ///< in the middle; 0 with the hypothetical law [m]
  double least_film = 0.0;                    ///< at its thinnest, likewise [m]
  double film_parameter = 0.0;       ///< Λ, least film over the composite roughness; 0: none known
  double rolling_speed = 0.0;        ///< of both surfaces, of contacts with a film [m/s]
  double temperature_rise = 0.0;     ///< flash, of contacts with a film; else 0 [K]
  double contact_temperature = 0.0;  ///< race temperature + rise [K]
  double edge = 0.0;          ///< depth s of the contact below the shoulder, either race (N94) [m]
  double centre_chord = 0.0;  ///< t, inner end of the contact from the groove's centre plane [m]
  // Rollers: half_major is half the length in contact, half_minor and max_pressure are those of the
  // slice with the largest pressure.
  double peak_position = 0.0;          ///< of that slice, from mid length towards +x [m]
  std::vector<double> slice_load;      ///< by slice [N]; empty for balls
  std::vector<double> slice_pressure;  ///< [Pa]
};

/// A roller end at a flange of a race.
struct FlangeContactSnapshot {
  bool present = false;
  double force = 0.0;         ///< [N]
  double gap = 0.0;           ///< negative in contact [m]; infinite: the end is nowhere near
  double height = 0.0;        ///< of the contact up the face [m]
  double slip = 0.0;          ///< [m/s]
  double heat = 0.0;          ///< [W]
  double load_slip = 0.0;     ///< [W]
  double damping_heat = 0.0;  ///< taken by contact damping [W]
};

struct PocketContactSnapshot {
  double force = 0.0;             ///< of contact and film [N]
  double gap = 0.0;               ///< negative in contact [m]
  double theta = 0.0, phi = 0.0;  ///< contact angles [rad], theta 0..2π
  double position = 0.0;          ///< of a roller: axial place of the contact on the surface [m]
};

/// A ball and the next one in the ring, without cage.
struct NeighborContactSnapshot {
  double force = 0.0;  ///< [N]
  double gap = 0.0;    ///< negative in contact [m]
};

struct ElementSnapshot {
  double x = 0.0, r = 0.0, theta = 0.0;  ///< mass centre; theta accumulates turns [m, m, rad]
  double vx = 0.0, vr = 0.0, theta_dot = 0.0;
  double ax = 0.0, ar = 0.0, theta_ddot = 0.0;  ///< ẍ, r̈ [m/s²], θ̈ [rad/s²]
  Vec3 omega = Vec3::Zero();     ///< absolute, azimuth frame (x, y = -e_θ, z = e_r) [rad/s]
  Vec3 x_axis = Vec3::UnitX();   ///< body x axis in the azimuth frame; valid when oriented
  Quat orientation{1, 0, 0, 0};  ///< valid when oriented
  double total_rotation = 0.0;   ///< ∫ ω·(body x axis) dt [rad]; valid when oriented
  bool oriented = false;         ///< orientation is integrated for this element
  bool held = false;  ///< x and r in force balance (qFac): vx, vr, ax, ar are zero by definition
  std::array<RaceContactSnapshot, 2> race{};  ///< of split races the contact with more load
  /// With the other halves of split races; empty: no race is split.
  std::vector<RaceContactSnapshot> second;
  std::array<std::array<FlangeContactSnapshot, 2>, 2> flange{};  ///< [race][side: -x, +x]
  std::vector<PocketContactSnapshot> pocket;  ///< one per surface; empty without cage
  Vec3 pocket_to_centre =
      Vec3::Zero();          ///< vector pocket centre -> element centre, pocket frame [m]
  double pocket_heat = 0.0;  ///< of all surfaces, ends, halves and films of its pocket [W]
  std::optional<NeighborContactSnapshot> to_next;  ///< without cage; the last of two balls has none
};

struct LandSnapshot {
  double force = 0.0, gap = 0.0;
  double angle = 0.0;       ///< azimuth of the least gap in the cage frame [rad]
  double film_force = 0.0;  ///< hydrodynamic [N]
  double heat = 0.0;        ///< of contact and film [W]
  double attitude = 0.0;    ///< from the line of least gap to the film's load; 0 without [rad]
};

/// Rigid body (cage or race) in the base frame. Orbit: r, θ of the mass centre about the bearing
/// axis.
struct BodySnapshot {
  Vec3 position = Vec3::Zero();  ///< cage: from the locus of element centres; race: displacement
                                 ///< from its free position [m]
  Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();
  Quat orientation{1, 0, 0, 0};
  Vec3 omega = Vec3::Zero();    ///< base frame [rad/s]
  double total_rotation = 0.0;  ///< about its own x axis, accumulated [rad]
};

/// The cage, or one of its segments.
struct CageSnapshot : BodySnapshot {
  std::vector<LandSnapshot> lands;
  /// Surfaces of the half pocket at the end of a segment that is cut through its pockets; the half
  /// at its start is in the pocket of its first element.
  std::vector<PocketContactSnapshot> last_half;
  /// Of a segment: least distance of its end from the start of the next one along the pitch circle,
  /// over the corners of both; negative: they overlap [m].
  double to_next = 0.0;
  Vec3 mass_centre = Vec3::Zero();  ///< of a segment, base frame [m]
};

struct RaceSnapshot : BodySnapshot {
  Vec3 applied_force = Vec3::Zero();   ///< what holds or loads this race [N]
  Vec3 applied_moment = Vec3::Zero();  ///< about its centre [N m]
  /// Against its contacts; `applied_force` where the race is held, but not where it accelerates [N]
  Vec3 carried_force = Vec3::Zero();
};

struct PowerSnapshot {
  double total_loss = 0.0;         ///< all dissipation now: energy.heat_rate() [W]
  double churning_fraction = 0.0;  ///< of it, drag and churning
  double life_hours = 0.0;         ///< at the loads now; infinity is a valid life; 0: no life model
  bool integrated = false;         ///< the integrals below are; else nothing is known of wear
  // Time integrals since t = 0 of load x slip [J]: what Archard wear needs (element 1 per race, all
  // of a race, cage). Raceways and flanges of a race apart.
  double qv_element1[2] = {0.0, 0.0}, qv_race[2] = {0.0, 0.0}, qv_cage = 0.0;
  double qv_element1_flange[2] = {0.0, 0.0}, qv_flange[2] = {0.0, 0.0};
};

/// What the last thermal step found (core/thermal/network.hpp); flows are averages over it.
struct ThermalSnapshot {
  int step = 0;                                ///< 0: none yet
  double coolant_in = 0.0, coolant_out = 0.0;  ///< [K]
  double outside = 0.0, bore = 0.0;            ///< of the bearing, at housing and shaft [K]
  double housing = 0.0;                        ///< its outside [K]
  double heat = 0.0, coolant_heat = 0.0;       ///< all; what the coolant takes [W]
  std::array<double, 2> race_heat{};           ///< what goes through the races [W]
  std::array<double, 2> raceway{};             ///< surfaces of the raceways [K]
  std::array<double, 2> film{};                ///< of the race contacts; NaN: not computed [K]
  double housing_mean = 0.0, shaft_mean = 0.0, medium = 0.0;  ///< [K]
};

struct Snapshot {
  long step = 0;
  double time = 0.0, step_size = 0.0;  ///< [s]
  double shaft_rotation = 0.0;         ///< inner minus outer about x [rad], signed
  std::vector<ElementSnapshot> elements;
  std::vector<CageSnapshot> cages;  ///< none, one, or one for each segment
  std::array<RaceSnapshot, 2> races;
  PowerSnapshot power;
  EnergyLedger energy;                     ///< since the start of the run
  std::optional<MomentumLedger> momentum;  ///< the same, with the momentum ledger
  std::optional<ThermalSnapshot> thermal;  ///< with a thermal analysis
  std::optional<int> held_elements;        ///< in force balance, with light-load balance (qFac)
  double max_quaternion_error = 0.0;       ///< largest | |q| - 1 |
};

}  // namespace adore::scene
