#include "runs/temporary_folder.hpp"

#include "base/write_folder.hpp"
#include "runs/output_folder.hpp"

#include <chrono>
#include <cstring>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

constexpr const char* kNamePrefix = "adore-temporary-";
constexpr const char* kFilesFolder = "files";
constexpr std::size_t kRandomLetters = 6;    ///< letters that mkdtemp gives
constexpr std::chrono::minutes kMinAge{10};  ///< nobody is about to take a lock that is so old

/// Only files of a temporary folder: results of a run are never taken for them.
bool has_only_temporary_files(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name != FolderLock::kName && name != kFilesFolder) return false;
  }
  return !error;
}

/// A folder of this user, named as ours are, that a process left which was killed.
bool is_abandoned(const fs::path& folder) {
  const std::string name = folder.filename().string();
  if (!name.starts_with(kNamePrefix) || name.size() != std::strlen(kNamePrefix) + kRandomLetters)
    return false;
  struct stat status {};
  if (::lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
      status.st_uid != ::geteuid())
    return false;
  std::error_code error;
  const fs::path lock = folder / FolderLock::kName;
  const auto made = fs::last_write_time(lock, error);
  return !error && fs::file_time_type::clock::now() - made > kMinAge &&
         has_only_temporary_files(folder) && FolderLock::is_free(lock);
}

void remove_abandoned_folders(const fs::path& place) {
  std::error_code error;
  for (fs::directory_iterator at(place, error), end; !error && at != end; at.increment(error)) {
    if (is_abandoned(at->path())) remove_tree(at->path());
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  const fs::path place = fs::temp_directory_path();
  [[maybe_unused]] static const bool cleaned = (remove_abandoned_folders(place), true);
  outer_ = make_temporary_folder(kNamePrefix);
  const WriteFolder outer(outer_);
  lock_ = std::make_unique<FolderLock>(outer);
  path_ = outer.folder(kFilesFolder).path();
}

TemporaryFolder::~TemporaryFolder() { remove_tree(outer_); }

}  // namespace adore::runs
