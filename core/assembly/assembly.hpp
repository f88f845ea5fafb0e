#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A set of up to four bearing rows whose inner rings are on one rigid shaft and whose outer rings
/// are in one rigid housing. Plain values in SI, as ASSEMBLY.json gives them (assembly_file.hpp).
///
/// Frame of the set: X along the shaft, Z radial upward, origin where the positions count from. A
/// row of orientation + has the frame of its deck. A row of orientation - is its mirror image in
/// the plane X = position: x, turns about y and turns about z change their sign, while y, z and
/// speeds about X stay. A mirror image obeys the same laws, so that its deck is solved unchanged.
/// The shaft pushes the inner ring of a + row to +X, that of a - row to -X.
namespace adore::assembly {

inline constexpr std::size_t kMaxRows = 4;

struct RowPlacement {
  std::string deck;                ///< path from the folder of the assembly: deck or its folder
  int orientation = 1;             ///< +1, -1
  std::optional<double> position;  ///< X of the middle of the row [m]; empty: rows side by side
  double offset = 0.0;  ///< axial offset of the inner ring against the outer one, positive when it
                        ///< loads the row [m]
};

/// Between row k and row k + 1. An inner spacer longer than the outer one by d moves the inner ring
/// of row k + 1 by +d along X.
struct Spacer {
  double inner = 0.0, outer = 0.0;                             ///< lengths [m]
  double stiffness = std::numeric_limits<double>::infinity();  ///< axial, of both spacers in series
                                                               ///< [N/m]
};

enum class PreloadKind : unsigned char { None, Force, Offset };

/// Preload by fixed rings: a total offset between both groups of rows, given or found from a force.
struct Preload {
  PreloadKind kind = PreloadKind::None;
  double force = 0.0;         ///< sum of the axial loads of the + rows without external load [N]
  double offset = 0.0;        ///< total: half of it at each row [m]
  bool in_operation = false;  ///< the force is that in operation; else that of the unmounted set at
                              ///< rest and room temperature
  std::string name;           ///< preload class, one of `classes`; empty: none
  std::vector<std::pair<std::string, double>> classes;  ///< forces of the preload classes [N]
  std::string source;                                   ///< of the force or of the classes
};

struct Assembly {
  std::string name;
  std::string arrangement;         ///< one of arrangement_names()
  std::vector<RowPlacement> rows;  ///< in order along X
  std::vector<Spacer> spacers;     ///< one less than rows, or none
  Preload preload;
  std::array<double, 5> load{};  ///< of the shaft on the set: x, y, z, about y, about z [N, N m]
  double load_position = 0.0;    ///< X at which the forces act [m]
};

/// Orientations of a named arrangement ("DB": + -), source: universal names of matched sets as in
/// the catalogs of bearing makers. Empty: no such name, or "custom".
[[nodiscard]] std::vector<int> orientations(const std::string& arrangement);
/// "DB", "DF", "DT", ..., "custom"
[[nodiscard]] const std::vector<std::string>& arrangement_names();

/// Shift of each inner ring along X by the difference of the lengths of the spacers before it [m].
[[nodiscard]] std::vector<double> spacer_shifts(const Assembly& assembly);

/// Positions given, or rows side by side, the middle of the set at X = 0.
/// @param widths of the inner rings [m] @throws InputError without widths
[[nodiscard]] std::vector<double> positions(const Assembly& assembly,
                                            const std::vector<double>& widths);

}  // namespace adore::assembly
