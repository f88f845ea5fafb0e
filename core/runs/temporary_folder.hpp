#pragma once

#include <filesystem>
#include <memory>

namespace adore::runs {

class FolderLock;

/// A new folder for temporary files, removed with this object. The first one of a
/// process also removes those of this user left by killed processes: their lock is free
/// (FolderLock), and no file in them was created recently.
class TemporaryFolder {
 public:
  /// In the folder that TMPDIR names, or /tmp. @throws WriteError when none can be made
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path outer_, path_;  ///< with the lock; in it, for the files
  std::unique_ptr<FolderLock> lock_;
};

}  // namespace adore::runs
