#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

/// Readers of the classic result files SOL1-SOL8 (formats: columns, never blanks; N51-N53, N59-N61,
/// N65, N103). They also read files cut off anywhere: complete steps are returned and `note` says
/// the missing part.
namespace adore::results {

enum class SolKind : unsigned char { Element, Cage, Race, Power, Animation };

/// The version fields of SOL1 to SOL8 have room only for the program's version (N60): that of
/// user routines follows the run code, from this column of line 1 on, which readers of the
/// format ignore.
inline constexpr int kUserVersionColumn = 58;
struct FileVersion {
  std::string_view program, user;  ///< "Adore0.1.0", "+my laws 1"
};
[[nodiscard]] FileVersion file_version(std::string_view version);
/// Fills the first line of a file up to there; nothing where there is no user's version.
void append_user_version(std::string& line, const FileVersion& version);

/// Header of SOL1-SOL7 (outputs.md 5.1).
struct SolHeader {
  std::string version, run_id, title;
  int value_count = 0;  ///< values per step
  int elements = 0;     ///< rolling elements
  int per_segment = 0;  ///< pockets per cage segment
  int segments = 0;
  int first_pocket = 0;  ///< element whose pocket is the first segment's first, from 0; not stored
  int index = 0;         ///< element number: 1..n, cages, outer, inner; 0 = SOL7
  bool outer_flange = false, inner_flange = false;
  int bearing_type = 1, pocket_type = 0, pocket_surfaces = 1;
  std::array<std::string, 10>
      units;  ///< slots of outputs.md §2, blanks trimmed by the stored length
};

struct SolStep {
  long step = 0;
  double revolutions = 0.0;            ///< bearing rotation [rev]
  double element_revolutions = 0.0;    ///< [rev]
  double step_size = 0.0, time = 0.0;  ///< [s]
  std::vector<double> values;          ///< in the file's units; NaN where the file shows stars
};

/// Which steps to keep: positions in the file, counted from 1.
struct SolRange {
  long from = 1;
  long to = std::numeric_limits<long>::max();  ///< the whole file (N81)
  long every = 1;
  std::vector<std::size_t> columns = {};  ///< values to keep, by their places in a step, rising;
                                          ///< empty: all of them
};

struct SolFile {
  std::filesystem::path path;
  SolKind kind = SolKind::Element;
  SolHeader header;
  std::vector<SolStep> steps;
  std::vector<std::size_t> columns;  ///< of each step's values; empty: all of the file's
  std::string note;    ///< empty, or what was wrong with the file ("cut off in step 120")
  std::string gaps;    ///< empty, or the number of its values that are not finite (SolParser::gaps)
  bool more = false;   ///< there are stored steps behind the range
  bool part = false;   ///< it has other stored steps than those that were read
  long every = 1;      ///< of so many stored steps one was read
  long last_step = 0;  ///< of those up to the range's end, kept or not: the file's last one but for
                       ///< `more`; 0: not known, then it is the last that was kept

  /// Index of the file's column in a step's values; beyond their end when it was not kept.
  [[nodiscard]] std::size_t place(std::size_t column) const;
};

/// @throws InputError when the file cannot be read or is not a SOL1-SOL7 file (with the reason).
SolFile read_sol(const std::filesystem::path& path, const SolRange& range = {});

/// Complete and cut-off stored steps of a SOL1-SOL7 file by its size: exact, because every step of
/// a file takes the same room. @throws InputError as read_sol()
[[nodiscard]] long stored_steps(const std::filesystem::path& path);

/// Geometry line of SOL8, in file units (outputs.md 7.1).
struct Sol8Geometry {
  double cage_outer_radius = 0, cage_inner_radius = 0, cage_outer_clearance = 0,
         cage_inner_clearance = 0;
  double pocket_clearance_1 = 0, pocket_clearance_2 = 0, element_radius = 0, pitch_diameter = 0;
  double outer_race_outer_radius = 0, outer_race_inner_radius = 0, inner_race_outer_radius = 0,
         inner_race_inner_radius = 0;
};

/// The line's fields, lengths all of them, in its order; by name in RESULTS.h5.
struct Sol8GeometryField {
  const char* name;
  double Sol8Geometry::*value;
};
inline constexpr std::array<Sol8GeometryField, 12> kSol8Geometry{
    {{"cage_outer_radius", &Sol8Geometry::cage_outer_radius},
     {"cage_inner_radius", &Sol8Geometry::cage_inner_radius},
     {"cage_outer_clearance", &Sol8Geometry::cage_outer_clearance},
     {"cage_inner_clearance", &Sol8Geometry::cage_inner_clearance},
     {"pocket_clearance_1", &Sol8Geometry::pocket_clearance_1},
     {"pocket_clearance_2", &Sol8Geometry::pocket_clearance_2},
     {"element_radius", &Sol8Geometry::element_radius},
     {"pitch_diameter", &Sol8Geometry::pitch_diameter},
     {"outer_race_outer_radius", &Sol8Geometry::outer_race_outer_radius},
     {"outer_race_inner_radius", &Sol8Geometry::outer_race_inner_radius},
     {"inner_race_outer_radius", &Sol8Geometry::inner_race_outer_radius},
     {"inner_race_inner_radius", &Sol8Geometry::inner_race_inner_radius}}};
static_assert(sizeof(Sol8Geometry) == kSol8Geometry.size() * sizeof(double),
              "every field is named");

struct Sol8Element {
  double x = 0, r = 0, theta = 0;             ///< mass center, theta [rad]
  std::array<double, 3> angles{};             ///< η, ξ, λ [rad]
  std::array<double, 3> pocket_vector{};      ///< pocket center -> element center
  double pocket_force = 0, pocket_angle = 0;  ///< [rad]
};

struct Sol8Body {
  std::array<double, 3> position{}, angles{};
};

struct Sol8Frame {
  long step = 0;
  double revolutions = 0, time = 0;
  std::vector<Sol8Element> elements;
  Sol8Body cage;
  std::array<double, 2> land_force{}, land_angle{};  ///< cage to race contact, lands 1 and 2 [rad]
  std::array<Sol8Body, 2> races;
};

struct Sol8File {
  std::filesystem::path path;
  std::string version, run_id;
  int bearing_type = 1;
  int elements = 0;
  std::array<std::string, 10> units;
  Sol8Geometry geometry;
  std::vector<Sol8Frame> frames;
  std::string note, gaps;  ///< as of SolFile
};

Sol8File read_sol8(const std::filesystem::path& path, const SolRange& range = {1, 1000000000, 1});

/// Looks at the header only. @throws InputError when the file is none of ours.
SolKind sol_kind(const std::filesystem::path& path);

}  // namespace adore::results
