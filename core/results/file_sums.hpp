#pragma once

#include "results/restart.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Checksums of the files of a run (decision 831): RUN.json has those of the finished files, MASTER
/// those of the parts that a continuation keeps. They find damage, not malice.
namespace adore::results {

class H5Reader;

struct FileChecksum {
  std::string name;
  std::uintmax_t bytes = 0;
  std::uint64_t sum = 0;
};

/// Length and checksum of a whole file. @throws InputError when it cannot be read
[[nodiscard]] FileChecksum file_checksum(const std::filesystem::path& path);

/// Checksum of the values of the first `rows` steps of RESULTS.h5, as H5Writer::sum() forms it.
[[nodiscard]] std::uint64_t steps_checksum(const H5Reader& file, std::size_t rows);

/// Why the part of a file that MASTER names is not as the run left it; empty: it is, or MASTER has
/// no checksum of it. @param last_step stored in RESULTS.h5 at MASTER's step
[[nodiscard]] std::string describe_file_damage(const MasterFileEntry& file,
                                               const std::filesystem::path& path, long last_step);

/// A file of a run or a study, as `adore verify` judges it.
struct FileCheck {
  enum class State : unsigned char { Intact, Damaged, Missing, Unchecked };
  std::filesystem::path file;
  State state = State::Unchecked;
  std::string detail;  ///< reason, or what was compared
};

/// All files of a run's folder, and of the runs in its folders (a sweep).
/// @throws InputError when there is no run
[[nodiscard]] std::vector<FileCheck> verify_run(const std::filesystem::path& folder);

}  // namespace adore::results
