#pragma once

#include "base/errors.hpp"
#include "base/write_folder.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The folder of a run's files: lock, and files that may be replaced (decision 160).
namespace adore::runs {

/// One process at a time writes into a folder. The lock ends with the process that holds it,
/// however that ends.
class FolderLock {
 public:
  /// @throws InputError naming the process that is at work there; or when nothing can be written.
  /// `elsewhere`: how this command takes another folder, for the sentence.
  explicit FolderLock(WriteFolder folder,
                      std::string_view elsewhere = "choose another folder with --out");
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  static constexpr const char* kName = ".adore.lock";
  /// Is the file a lock that no process holds? A file that is none is not free, either.
  [[nodiscard]] static bool is_free(const std::filesystem::path& lock) noexcept;

 private:
  WriteFolder folder_;
  int descriptor_ = -1;  ///< -1: the file system has no locks
};

/// The folder of a run: where its files are, and the open folder that they are written in.
struct RunPlace {
  RunPlace(WriteFolder open) : path(open.path()), folder(std::move(open)) {}  // NOLINT
  /// Nothing is written.
  explicit RunPlace(std::filesystem::path looked_at) : path(std::move(looked_at)) {}
  std::filesystem::path path;
  std::optional<WriteFolder> folder;
};

/// Rejects a folder that this process may not write into, as FolderLock would, and leaves no files
/// there. @throws InputError
void check_writable(const std::filesystem::path& folder,
                    std::string_view elsewhere = "choose another folder with --out");

/// The folder holds results that a new run would replace, and nobody has allowed it.
class ResultsExist : public InputError {
 public:
  ResultsExist(const std::filesystem::path& folder, const std::vector<std::string>& names);
};

struct Outputs {
  std::filesystem::path folder;
  std::vector<std::string> names;             ///< of the files that the run writes
  std::vector<std::filesystem::path> inputs;  ///< deck, option file
};

/// Refuses names that are an input of the run, a symbolic link, no plain file, or a file that this
/// program did not write. Touches nothing. @throws InputError naming file and remedy
void check_names(const Outputs& outputs);

/// check_names(), and the same question for a run that starts anew: earlier results are there.
/// @throws ResultsExist unless `overwrite`
void check_room(const Outputs& outputs, bool overwrite);

/// Removes the hidden files that a process left which was killed while it replaced one of the
/// outputs. Every run that holds the lock does so before it writes.
void remove_leftovers(const Outputs& outputs, const WriteFolder& folder);

/// Makes room for a new run, after check_room(): files named by MASTER and RUN.json of an earlier
/// run, and files left by a killed process, are removed if they will be written; other results are
/// moved into a folder "earlier-1", "earlier-2" ... @return that folder, empty when nothing had to
/// be moved.
std::filesystem::path make_room(const Outputs& outputs, const WriteFolder& folder);

}  // namespace adore::runs
