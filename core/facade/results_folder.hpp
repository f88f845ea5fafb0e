#pragma once

#include <filesystem>

namespace adore::facade {

/// The folder that results go into, made with those above it where they are missing. What was made
/// here and is still empty at the end goes with this object: a run that is refused leaves nothing.
class ResultsFolder {
 public:
  /// @throws InputError when it cannot be made
  explicit ResultsFolder(std::filesystem::path folder);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int made_ = 0;  ///< folders that were missing: the last ones of the path
};

}  // namespace adore::facade
