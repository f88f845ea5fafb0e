#pragma once

#include "base/rotation.hpp"
#include "results/full_precision.hpp"
#include "results/sol_file.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// What AGORE's views need beyond the frames of a SOL8 file: continuous angles, speeds by
/// differences, and the guiding race. No Qt. Frames: X along the bearing axis, Z up; azimuth is a
/// rotation about +X from Z (y = -r sin, z = r cos). SOL8 holds three significant digits, so angles
/// are averaged over a few frames and speeds are differences over a span of frames that turns by
/// one radian, a tenth of the file at most. A body must turn by less than half a turn from one
/// stored frame to the next.
namespace adore::agore {

/// Oldest program version whose data sets are accepted.
inline constexpr const char* kLowestVersion = "0.1";

/// @throws InputError when `version` names a version below kLowestVersion or no version at all.
void check_version(const std::string& version, const std::string& file);

enum class Guide : unsigned char { None, Outer, Inner };

struct Animation {
  results::Sol8File file;
  bool has_cage = false;
  Guide guide = Guide::None;
  double guide_clearance = 0.0;                    ///< radial, file units
  std::vector<double> time;                        ///< [s]
  std::vector<double> cage_angle;                  ///< continuous rotation about X [rad]
  std::array<std::vector<double>, 2> race_angle;   ///< outer, inner [rad]
  std::optional<results::ContactFrames> contacts;  ///< from RESULTS.h5 beside the file
  std::string no_contacts;                         ///< why there are none
  std::vector<double> pocket_angle;                ///< of each pocket centre in the cage [rad]

  [[nodiscard]] std::size_t frames() const { return time.size(); }
  [[nodiscard]] const results::Sol8Frame& frame(std::size_t i) const { return file.frames.at(i); }
};

/// @throws InputError for a file without a complete frame, of an unknown version, or of too many
/// bodies for its frames.
Animation prepare(results::Sol8File file);

/// An angle stored in -pi..pi (or 0..2 pi) made continuous.
std::vector<double> continuous(std::vector<double> angle);

/// d(angle)/dt by differences over enough frames to see past the file's rounding; NaN when there
/// are fewer than three frames.
std::vector<double> rate(const std::vector<double>& angle, const std::vector<double>& time);

/// Speed of the inner relative to the outer race [rad/s], averaged over the file; 0 when nothing
/// turns.
double shaft_speed(const Animation& animation);

/// Orbit speed of the cage centre, and rotation speed of the cage, each over shaft speed. NaN where
/// the centre stands in the middle.
std::vector<double> cage_whirl_ratio(const Animation& animation);
std::vector<double> cage_speed_ratio(const Animation& animation);

/// Orbit speed of an element (0-based), and the size of its rotation speed, each over shaft speed.
std::vector<double> element_orbit_ratio(const Animation& animation, std::size_t element);
std::vector<double> element_spin_ratio(const Animation& animation, std::size_t element);

/// Rotation matrix of transformation angles: about X by eta, then the new Y by xi, then the newest
/// Z by lambda. Columns are the body's axes in the fixed frame.
Mat3 rotation(const std::array<double, 3>& angles);

}  // namespace adore::agore
