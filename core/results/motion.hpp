#pragma once

#include "bearing/bearing.hpp"
#include "scene/snapshot.hpp"

#include <array>
#include <string_view>

/// Quantities that the outputs derive from a snapshot's motion.
namespace adore::results {

using scene::Vec3;

/// Direction of a vector as the outputs show it (N101): theta = atan2(v_z, v_x), phi = asin(v_y /
/// |v|) [rad]: tilt_of_axis of the mirror
/// image, which counts theta the other way. Both are 0 for a zero vector and near 0 for one along
/// +x. Frame: that of the vector.
struct DirectionAngles {
  double theta = 0.0, phi = 0.0;
};
[[nodiscard]] DirectionAngles direction_angles(const Vec3& v);
/// One of them alone.
[[nodiscard]] double direction_theta(const Vec3& v);
[[nodiscard]] double direction_phi(const Vec3& v);

/// Motion of a mass center in the plane across the bearing axis, base frame, angle from +Z as
/// azimuths: y = -r sin θ, z = r cos θ. On the axis itself (r below 1 pm) θ is taken from the
/// velocity, else from the acceleration, and the angular rates are 0.
struct OrbitMotion {
  double r = 0.0, r_dot = 0.0, r_ddot = 0.0;              ///< [m, m/s, m/s²]
  double theta = 0.0, theta_dot = 0.0, theta_ddot = 0.0;  ///< θ in -π..π [rad, rad/s, rad/s²]
};
[[nodiscard]] OrbitMotion orbit_motion(const Vec3& position, const Vec3& velocity,
                                       const Vec3& acceleration);

/// The body's x axis in the base frame, from its unit quaternion (body -> base).
[[nodiscard]] Vec3 body_x_axis(const scene::Quat& orientation);

/// Angle reduced to -π..π.
[[nodiscard]] double wrapped(double angle);

/// The branch of `angle` (a multiple of 2π away) nearest to `previous`.
[[nodiscard]] double nearest_branch(double angle, double previous);

/// Speed of the faster race about its own axis, sign kept [rad/s] (N54); 0 when both stand still.
[[nodiscard]] double faster_race_speed(const scene::Snapshot& snapshot);

/// Reference length of the cage's mass center (N71): the mean radial clearance of the guided lands,
/// so that 1 means contact; without guided lands the radial pocket clearance I; if that is not
/// positive either, the deck's unit of length.
struct CageLengthScale {
  enum class Of : unsigned char { GuideLands, Pockets, UnitOfLength };
  double length = 1.0;  ///< [m]
  Of of = Of::UnitOfLength;
};
/// "guide lands", "pockets", "unit of length"; as RUN.json has them.
[[nodiscard]] std::string_view name_of(CageLengthScale::Of of);
[[nodiscard]] CageLengthScale cage_length_scale(const bearing::Cage& cage, double unit_length);
/// Its length alone [m].
[[nodiscard]] inline double cage_scale_length(const bearing::Cage& cage, double unit_length) {
  return cage_length_scale(cage, unit_length).length;
}

/// Archard's wear volume per time, averaged over the run (N50): W(T) = K/(H T) ∫ Q V dt [m³/s].
/// 0 at T = 0 and for a material without hardness.
[[nodiscard]] double average_wear_rate(const bearing::Material& material, double load_slip_integral,
                                       double time);

}  // namespace adore::results
