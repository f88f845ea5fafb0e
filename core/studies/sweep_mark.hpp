#pragma once

#include "base/write_folder.hpp"
#include "runs/run.hpp"

#include <filesystem>
#include <optional>
#include <string>

/// SWEEP.json: identifies the sweep of a folder, so that it can be continued later.
namespace adore::studies {

struct SweepManifest {
  std::string deck;     ///< file name without folders
  std::string range;    ///< as --set takes it: "appLoadZ=500:1500:5"
  std::string request;  ///< sweep_digest()
  std::string status;   ///< "running", "interrupted", "done"
  long failed = 0;      ///< runs that came to no result, of those that ended

  static constexpr const char* kName = "SWEEP.json";
};

/// Digest of the common part of all runs of a sweep: request_digest() without the range. Empty
/// if the deck cannot be read.
[[nodiscard]] std::string sweep_digest(const runs::RunRequest& request);

/// Replaces the file atomically. @throws WriteError
void write_sweep_manifest(const SweepManifest& mark, const WriteFolder& folder);
/// Nothing where there is none of this program, or a damaged one.
[[nodiscard]] std::optional<SweepManifest> read_sweep_manifest(const std::filesystem::path& folder);

/// Does a value of --set stand for a range, first:last:count?
[[nodiscard]] bool is_sweep_range(const std::string& value);

}  // namespace adore::studies
