#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Type of a file, by its first bytes: for messages such as "PRINT.txt is a listing, not a deck",
/// and to recognize outputs of this program.
namespace adore {

enum class AdoreFileType : unsigned char {
  Unknown,
  Deck,        ///< 'Rec 1', ...
  Listing,     ///< PRINT.txt
  Plot,        ///< SOL1-SOL7
  Animation,   ///< SOL8
  Final,       ///< FINAL
  Master,      ///< MASTER
  RunJson,     ///< RUN.json
  ResultsH5,   ///< RESULTS.h5, or any HDF5 file
  SweepTable,  ///< SWEEP.csv
  Json,        ///< other JSON: inputs of calculators, reference cases, ADORE.json
};

/// Enough bytes for detect_file_type.
inline constexpr std::size_t kFileTypeBytes = 1024;

/// @param first_bytes up to kFileTypeBytes of a file's beginning
[[nodiscard]] AdoreFileType detect_file_type(std::string_view first_bytes);
/// Unknown too when the file cannot be read.
[[nodiscard]] AdoreFileType read_file_type(const std::filesystem::path& path);

/// Did this program write the file? Its sort by its first bytes, and our name and version at the
/// place where our writers put them: files of the same layout by other programs are not ours. Only
/// own files are ever replaced. False when it cannot be read, and for an empty file.
[[nodiscard]] bool is_written_by_adore(const std::filesystem::path& path);

/// "a listing (PRINT.txt of a run)"; empty for Unknown.
[[nodiscard]] std::string_view describe_file_type(AdoreFileType sort);

/// Programs that use such a file: "plot it with `adore plot`". Empty for Unknown.
[[nodiscard]] std::string_view file_type_usage_hint(AdoreFileType sort);

}  // namespace adore
