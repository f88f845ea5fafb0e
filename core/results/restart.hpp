#pragma once

#include "base/write_folder.hpp"
#include "scene/scales.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// FINAL and MASTER (outputs.md 4, N3, N68): text, SI and radians, every number with all its
/// digits, replaced as a whole. They are written during a run, too, so that a killed run continues.
/// MASTER holds a copy of the state: one replacement moves state and bookkeeping together, whenever
/// the run dies.
namespace adore::results {

/// A solution vector and where it belongs.
struct FinalState {
  std::string version, run_id;
  long step = 0;
  double time = 0.0, step_size = 0.0;    ///< [s]
  double shaft_rotation = 0.0;           ///< inner minus outer [rad]
  scene::Scales scales;                  ///< of the first run (N7)
  std::map<std::string, double> extras;  ///< further numbers that a restart wants, by name (one
                                         ///< word or several, no line ends)
  std::vector<std::string> components;   ///< StateLayout::component_name of each value
  std::vector<double> state;
  std::string deck;  ///< the deck that was run, in deck syntax; empty in files of format 1
};

struct MasterFileEntry {
  std::string role;  ///< "PRINT", "SOL1" ... "SOL8", "RESULTS"
  std::string name;  ///< relative to MASTER's folder
  std::uintmax_t bytes =
      0;  ///< length at MASTER's step; 0 if the length has no meaning (RESULTS.h5)
  std::optional<std::uint64_t> sum;  ///< of these bytes, or of the steps in RESULTS.h5
};

/// In MasterState::averages: last step that RESULTS.h5 has.
inline constexpr const char* kLastSaved = "last step in RESULTS";

struct MasterState {
  FinalState last;                         ///< version, run code and state at MASTER's step
  std::map<std::string, double> averages;  ///< of RunAverages and ChannelRecorder
  std::vector<MasterFileEntry> files;

  /// nullptr when the run has no such file.
  [[nodiscard]] const MasterFileEntry* file(std::string_view role) const;
};

/// Replace the file atomically. @throws InputError when it cannot be written.
void write_final(const FinalState& state, const WritePath& place);
void write_master(const MasterState& state, const WritePath& place);

/// @throws InputError when the file is missing, is something else, or is damaged (with the line).
[[nodiscard]] FinalState read_final(const std::filesystem::path& path);
[[nodiscard]] MasterState read_master(const std::filesystem::path& path);

/// Throws unless a stored state fits this run's unknowns. @throws InputError naming the first
/// component that differs and what to do.
void check_layout(const FinalState& state, const std::vector<std::string>& components,
                  const std::filesystem::path& path);

/// Throws unless a stored state is of the same bodies as this run: as many rolling elements, the
/// same cage. What else it has (orientations that only one of the runs shows) is not compared.
/// @throws InputError naming both.
void check_bodies(const FinalState& state, const std::vector<std::string>& components,
                  const std::filesystem::path& path);

}  // namespace adore::results
