#pragma once

#include "base/write_folder.hpp"

#include <filesystem>
#include <optional>

namespace adore::runs {

/// The folder for results, created with missing parents. Folders created
/// here and still empty at the end are removed with this object: a rejected run leaves nothing.
class ResultsFolder {
 public:
  /// @param named by the user: may be a link
  /// @param below folders in it that the program names ("files/KEY"): links are rejected
  /// @throws InputError when it cannot be created
  explicit ResultsFolder(std::filesystem::path named, const std::filesystem::path& below = {});
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const WriteFolder& folder() const { return *folder_; }

 private:
  std::filesystem::path path_;
  std::optional<WriteFolder> folder_;
  int created_folder_count_ = 0;  ///< folders that were missing: the last ones of the path
};

}  // namespace adore::runs
