#pragma once

#include <filesystem>

/// Which files this program wrote, by what stands in them: only those are ever replaced.
namespace adore::results {

/// Is this a listing, SOL1-SOL8, FINAL, MASTER, RUN.json, RESULTS.h5 or SWEEP.csv of this program,
/// whatever its name? False when it cannot be read, and for an empty file.
[[nodiscard]] bool is_own_file(const std::filesystem::path& path);

}  // namespace adore::results
