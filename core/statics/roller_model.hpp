#pragma once

#include "contact/roller_profile.hpp"
#include "contact/tapered_geometry.hpp"
#include "statics/roller_flanges.hpp"
#include "statics/roller_races.hpp"
#include "statics/roller_statics.hpp"
#include "statics/slice_potential.hpp"

#include <array>
#include <vector>

/// Constants of one quasi-static roller bearing problem: what all rollers share.
namespace adore::statics {

/// Shape of one roller and of the races where it stands, or of all when nothing deviates.
struct RollerContactGeometry {
  contact::RollerProfile profile;
  std::vector<contact::RollerSlice> slices;
  std::array<contact::RaceSurface, 2> race;
  /// As they meet race j where its surface is a table: less what it recedes; empty: `slices`.
  std::array<std::vector<contact::RollerSlice>, 2> on_race;
  double inner_slope = 0.0;              ///< dR/dψ of the inner race here [m/rad]
  std::array<PointContactSet, 2> point;  ///< RollerContact::Point
  std::vector<FlangeEndPair> flanges;    ///< that this roller can touch
};

struct RollerModel {
  bearing::RollerGeometry rollers;
  RollerContact contact = RollerContact::Sliced;
  bool linear = false;
  bool grips = false;  ///< straight raceways: friction holds the roller axially (decision 109)
  contact::Slicing slicing;
  RollerRaces race;  ///< ideal
  std::array<contact::PowerLaw, 2> law;
  std::array<double, 2> E_star{};
  std::array<double, 2> line_constant{};      ///< K_l [N/m²]
  std::vector<RollerContactGeometry> bodies;  ///< one, or one per roller
  std::vector<double> azimuth;                ///< [rad]
  std::array<double, 2> race_speed{};         ///< [rad/s]
  std::array<double, 2> outer_tilt{};         ///< about y, z [rad]
  contact::RollingSpeeds speeds;
  double mass = 0.0, mass_offset = 0.0;
  double centrifugal = 0.0;  ///< of each roller, at its mass centre [N]
  double gyroscopic = 0.0;   ///< about y that the contacts supply [N m]
  /// Barrels of an inclined row without a flange at -x: what the centrifugal force has along the
  /// roller is held by guide ring or cage, F_c sin α_o (cos α_o, -sin α_o) in x and r [N].
  std::array<double, 2> guide{};
  bool moving = false;
  /// Turning base frame: its speed adds to the orbital speed in inertial forces, and the transport
  /// acceleration of the base origin acts on every roller (base axes).
  double frame_speed = 0.0;                         ///< [rad/s]
  Eigen::Vector3d field = Eigen::Vector3d::Zero();  ///< [m/s²]

  double line_stiffness = 0.0;  ///< K L^(8/9), the stiffer race [N m^(-10/9)]
  double lever = 0.0;           ///< of a roller's tilt [m/rad]
  double longest_step = 0.0;    ///< of one Newton step [m]
  double load_floor = 0.0;      ///< forces below are nothing [N]
  double weak_floor = 0.0;      ///< the same along modes that are held by the curvature of a light
                                ///< contact only (roller_equilibrium.cpp); infinite where the guide
                                ///< force holds the roller [N]

  [[nodiscard]] const RollerContactGeometry& body(std::size_t k) const {
    return bodies[bodies.size() == 1 ? 0 : k];
  }
  /// Contacts of a roller with one race: its slices, or one.
  [[nodiscard]] std::size_t results(const RollerContactGeometry& body) const {
    return contact == RollerContact::Point ? 1 : body.slices.size();
  }
  [[nodiscard]] SliceSet slices(std::size_t j, const RollerContactGeometry& body) const {
    return {body.race[j], body.on_race[j].empty() ? body.slices : body.on_race[j], slicing.width,
            law[j]};
  }
};

/// Imperfections: diameter, crown, length and land of each roller (RollerGeometry::deviation);
/// races with the errors of their own azimuth under each roller (contact/race_errors.hpp), the
/// inner one with its slope; of tables the slices are less what the race recedes there, and the
/// slope is the mean of all slices. Mass, spin and the places of flanges stay those of the ideal
/// bearing.
/// @throws InputError naming the value that makes no bearing.
[[nodiscard]] RollerModel make_roller_model(const bearing::Bearing& bearing,
                                            const RollerOptions& options);

/// Adds what race j does to a roller of this body at p, by the contact and the kinematics of the
/// model. `each`: empty, or as many as RollerModel::results.
void add_race(const RollerModel& model, const RollerContactGeometry& body, std::size_t j,
              const Vec4& p, PairPotential& sum, std::span<SliceResult> each = {});

/// Fills load_floor and weak_floor: a roller need not be balanced better than to 1e-13 of the load
/// on the bearing, and cannot be where a step of its position in floating point changes the force
/// by more. Weak modes: 1e-9 of the load.
void set_load_floors(RollerModel& model, double bearing_load);

/// Penetration of one roller between both races as a power of the load: δ = (Q/(K L^(8/9)))^0.9.
[[nodiscard]] double line_approach(const RollerModel& model, double load);

}  // namespace adore::statics
