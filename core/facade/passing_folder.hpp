#pragma once

#include <filesystem>

namespace adore::facade {

/// A new folder for files that nobody wants to keep, gone with this object.
class PassingFolder {
 public:
  /// In the folder that TMPDIR names, or /tmp. @throws WriteError when none can be made
  PassingFolder();
  ~PassingFolder();
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace adore::facade
