#pragma once

#include <filesystem>
#include <memory>

namespace adore::runs {

class FolderLock;

/// A new folder for temporary files, removed with this object. The first one of a
/// process also removes those of this user left by killed processes: their lock is free
/// (FolderLock), and no file in them was created recently.
class PassingFolder {
 public:
  /// In the folder that TMPDIR names, or /tmp. @throws WriteError when none can be made
  PassingFolder();
  ~PassingFolder();
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path outer_, path_;  ///< with the lock; in it, for the files
  std::unique_ptr<FolderLock> lock_;
};

}  // namespace adore::runs
