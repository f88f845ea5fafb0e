#pragma once

#include "base/rotation.hpp"
#include "results/motion_file.hpp"
#include "results/sol_file.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Data for the views of AGORE in addition to the frames of a SOL8 file: continuous angles, the
/// guiding race, and more accurate values. No Qt. Frames: X along the bearing axis, Z up; azimuth
/// is a rotation about +X from Z (y = -r sin, z = r cos).
///
/// With RESULTS.h5 of the same run in the folder, its steps are the frames and its channels the
/// curves: full precision, all stored steps. SOL8 has three digits at its own times; then only
/// these frames are drawn, and speeds are differences over frames with a rotation of one radian, at
/// most a tenth of the file. No speed is known for a body that turns by more than half a revolution
/// between two frames.
///
/// RESULTS.h5 of a killed or active run may end before SOL8: later frames are those of SOL8.
namespace adore::agore {

/// Oldest accepted program version of data sets.
inline constexpr const char* kLowestVersion = "0.1";

/// @throws InputError when `version` names a version below kLowestVersion or no version at all.
void check_version(const std::string& version, const std::string& file);

enum class Guide : unsigned char { None, Outer, Inner };

/// Contact of one guide land with its race.
struct GuideLandContact {
  double force = 0.0;  ///< in the file's unit
  double angle = 0.0;  ///< azimuth of the least gap, from the segment's z axis [rad]
};

/// Contact of one rolling element with the two races (outer, inner).
struct ContactFrame {
  std::array<double, 2> load{};  ///< in `load_unit`
  std::array<double, 2> slip{};  ///< largest slip speed in the contact, in `slip_unit`
};

/// Range of a contact quantity in the whole run, by the larger value of both contacts of an
/// element.
struct RunRange {
  double lowest = 0.0, largest = 0.0;
  double usual = 0.0;  ///< that 19 of 20 values above 0 stay below
};
[[nodiscard]] RunRange run_range(const results::MotionChannel& channel);
/// Is there an element that touches neither race at some step? Of the loads of a run.
[[nodiscard]] bool loses_contact(const results::MotionChannel& load);

/// Contacts of all elements at the frames of a SOL8 file.
struct ContactFrames {
  std::string load_unit, slip_unit;
  std::vector<std::vector<ContactFrame>> frames;  ///< [frame][element]
  double largest_load = 0.0;                      ///< over all frames and elements
  std::array<double, 2> largest_of_race{};        ///< of largest_load, by race
};

/// Fraction of the frames of a run for which the path from the previous frame is known.
enum class Known : unsigned char { All, Some, None };

struct Animation {
  results::Sol8File file;
  std::shared_ptr<const results::MotionFile> motion;  ///< RESULTS.h5, if usable
  std::size_t exact = 0;  ///< frames of RESULTS.h5; later ones are from SOL8
  /// Content of SOL8, if RESULTS.h5 ends earlier.
  std::shared_ptr<const Animation> alone;
  std::string source;  ///< source of the pictures, as text
  bool has_cage = false;
  int segments = 0;                ///< of the cage; 1: in one piece
  std::vector<int> pocket_part{};  ///< segment that the element's pocket belongs to
  std::array<bool, 2> land{};      ///< guide lands that exist
  Guide guide = Guide::None;
  double guide_clearance = 0.0;                   ///< radial, file units
  std::vector<double> time;                       ///< [s]
  std::vector<double> cage_angle;                 ///< continuous rotation about X [rad]
  std::array<std::vector<double>, 2> race_angle;  ///< outer, inner [rad]
  std::optional<ContactFrames> contacts;          ///< from RESULTS.h5 in the same folder
  std::string no_contacts;                        ///< reason for missing contacts
  /// Reason why RESULTS.h5 in the same folder is not used; empty: it is used or missing.
  std::string unused;
  /// Problems of the files, as sentences without a period.
  [[nodiscard]] std::vector<std::string> notes() const;
  std::map<std::string, RunRange> run_ranges;  ///< of quantities that color, by channel
  bool some_free = false;                      ///< an element touches neither race at some step
  std::vector<double> pocket_angle;            ///< of each pocket center in the cage [rad]
  std::vector<double> turned;  ///< by the races since the frame before, at least [rev]
  /// Ways of centers, of elements about the axis, and of elements past each other.
  Known known_centres = Known::All, known_elements = Known::All, known_trails = Known::All;

  [[nodiscard]] std::size_t frames() const { return time.size(); }
  [[nodiscard]] const results::Sol8Frame& frame(std::size_t i) const { return file.frames.at(i); }
  /// Is it a frame of SOL8 behind the end of RESULTS.h5?
  [[nodiscard]] bool behind(std::size_t frame) const { return motion && frame >= exact; }
  /// "frames from 120 on are only in SOL8"; empty if RESULTS.h5 has all frames.
  [[nodiscard]] std::string sol8_only_note() const;
  /// Contacts of the elements at a frame; null without contacts, see `missing_loads_reason`.
  [[nodiscard]] const std::vector<ContactFrame>* contacts_at(std::size_t frame) const;
  [[nodiscard]] std::string missing_loads_reason(std::size_t frame) const;
  /// May the path of a center be drawn as a line from the previous frame? Not if the bearing turns
  /// far in between, because the path is unknown.
  [[nodiscard]] bool is_path_known(std::size_t frame) const;
  /// The same for an element; `past_others`: compared with its neighbors, so that elements are not
  /// confused.
  [[nodiscard]] bool is_path_known(std::size_t frame, std::size_t element, bool past_others) const;
  /// Cage, or segment with the pocket of an element, at a frame.
  [[nodiscard]] const results::Sol8Body& cage_part_of(std::size_t frame, std::size_t element) const;
  [[nodiscard]] const results::Sol8Body& part(std::size_t frame, int segment) const;
  /// Continuous for a cage in one piece [rad].
  [[nodiscard]] double cage_part_angle(std::size_t frame, int segment) const;
  [[nodiscard]] GuideLandContact land_contact(std::size_t i, int segment, std::size_t which) const;
  /// ", segment 2 of 3", or nothing for a cage in one piece.
  [[nodiscard]] std::string segment_remark(int segment) const;
  /// Value of a channel of RESULTS.h5 at a frame; NaN if missing.
  [[nodiscard]] double value(const std::string& channel, std::size_t frame,
                             std::size_t place) const;
};

/// The largest rotation of races or elements between frames for which the path between is known
/// [rev]: its chord deviates from the circle by a hundredth of the radius.
inline constexpr double kKnownTurn = 1.0 / 24.0;

/// A curve next to the picture: at the steps of RESULTS.h5, else of the SOL file of that body, else
/// at the frames of SOL8. If RESULTS.h5 ends before SOL8, the curve continues with those.
struct History {
  std::vector<double> time;  ///< [s]
  std::vector<double> value;
  std::string unit;
  std::string unknown;  ///< why the values cannot be known; empty: they are
  /// Extremes since the value before, as RESULTS.h5 has them; empty: not known.
  std::vector<double> low = {}, high = {};
  double least_radius = 0.0;  ///< of a whirl that is drawn, if others are left out [file unit]
};
/// `segment`: of the cage, from 0; the only one of a cage in one piece.
[[nodiscard]] History land_force(const Animation& animation, std::size_t land, int segment = 0);
[[nodiscard]] History pocket_force(const Animation& animation, std::size_t element);
/// Speed of the mass center of the cage about the bearing axis, and of the cage about its own, over
/// that of the faster race. Of a segment: its reference point on the cage axis, and its own
/// turning. The whirl speed is the tangential velocity over the distance r from the axis. Close to
/// the axis any small motion gives a large one, so values for r below kNearAxis of the radial
/// clearance of the lands (without lands: of the largest r) are NaN.
inline constexpr double kNearAxis = 0.05;
[[nodiscard]] History cage_whirl(const Animation& animation, int segment = 0);
[[nodiscard]] History cage_speed(const Animation& animation, int segment = 0);
/// Orbit speed of an element, and the size of its angular velocity, over that of the shaft.
[[nodiscard]] History element_orbit_speed(const Animation& animation, std::size_t element);
[[nodiscard]] History element_spin(const Animation& animation, std::size_t element);
/// Mass center of a race, coordinate 0, 1, 2 = x, y, z.
[[nodiscard]] History race_position(const Animation& animation, std::size_t race,
                                    std::size_t coordinate);
/// Load of an element at a race (0 outer, 1 inner); `channel`: that of the other half of a split
/// race.
[[nodiscard]] History contact_load(const Animation& animation, std::size_t element,
                                   std::size_t race, const std::string& channel = "contact.load");
/// Of one element at one race (0 outer, 1 inner); `what`: "force" or "gap"; side 0 = -x, 1 = +x.
[[nodiscard]] History flange_history(const Animation& animation, const std::string& what,
                                     std::size_t element, std::size_t race, std::size_t side);

/// Does the run have a flange there?
[[nodiscard]] bool has_flange(const Animation& animation, std::size_t race, std::size_t side);

/// @throws InputError for a file without a complete frame, of an unknown version, or of too many
/// bodies for its frames.
Animation prepare(results::Sol8File file, long most_frames = 1'000'000'000);
/// RESULTS.h5 alone: also for bearings that SOL8 has no room for. @throws InputError
Animation prepare(results::MotionFile motion);
/// SOL8, RESULTS.h5 by its ending, or either in the folder of a run. @throws InputError
Animation open_motion(const std::filesystem::path& path, long most_frames = 1'000'000'000);

/// An angle stored in -pi..pi (or 0..2 pi) made continuous.
std::vector<double> continuous(std::vector<double> angle);

/// d(angle)/dt by differences over enough frames to see past the file's rounding; NaN when there
/// are fewer than three frames.
std::vector<double> rate(const std::vector<double>& angle, const std::vector<double>& time);

/// Speed of the inner relative to the outer race [rad/s], averaged over the file; 0 without
/// rotation.
double shaft_speed(const Animation& animation);

/// Rotation matrix of transformation angles: about X by eta, then the new Y by xi, then the newest
/// Z by lambda. Columns are the body's axes in the fixed frame.
Mat3 rotation(const std::array<double, 3>& angles);

}  // namespace adore::agore
