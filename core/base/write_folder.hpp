#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <sys/types.h>

/// The only code of the suite that opens files for writing, and makes, renames and removes files
/// and folders; tests/architecture reads the sources for that.
///
/// The folder that the user names may be a link, and so may folders above it. Nothing below it is
/// followed: each name is looked up in the open folder (openat, O_NOFOLLOW), so a study or run
/// folder from a stranger cannot lead a write to another place (decision 830).
namespace adore {

/// An open folder in which the program writes. Copies share the open folder.
class WriteFolder {
 public:
  /// @param named existing folder as the user named it; "" is the current one
  /// @throws WriteError when it is missing or cannot be opened
  explicit WriteFolder(const std::filesystem::path& named);

  /// The folder `below` this one ("runs/ab"), made where it is missing. Each part must be a folder,
  /// not a link, of this user or of the owner of the folder that the user named.
  /// @throws WriteError naming the part and the reason
  [[nodiscard]] WriteFolder folder(const std::filesystem::path& below) const;
  /// A new folder: NAME-1, NAME-2, ..., the first number that is free.
  [[nodiscard]] WriteFolder new_folder(const std::string& stem) const;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  /// Of the open folder, for the file driver of RESULTS.h5 and for locks.
  [[nodiscard]] int descriptor() const noexcept { return *descriptor_; }

  /// New empty file under this name. A regular file or a link of that name is removed first: its
  /// content and its other names stay as they are. @return its descriptor @throws WriteError
  [[nodiscard]] int create(const std::string& name) const;
  /// Opens an existing file to change it: regular, one name only (no hard link), with the owner
  /// that folder() asks for. @return its descriptor @throws WriteError
  [[nodiscard]] int open_own(const std::string& name) const;
  /// The same, made empty where there is none. @return -1 and errno when it cannot be opened
  [[nodiscard]] int open_lock(const std::string& name) const noexcept;
  /// Removes a file or a link. Whether there was one does not matter.
  void remove(const std::string& name) const noexcept;
  /// @throws WriteError
  void rename(const std::string& name, const WriteFolder& to, const std::string& new_name) const;

 private:
  friend class PendingFile;
  WriteFolder(std::filesystem::path path, int descriptor, uid_t owner);
  void demand_own(const std::string& name, int descriptor) const;

  std::filesystem::path path_;
  std::shared_ptr<const int> descriptor_;
  uid_t owner_ = 0;  ///< of the folder that the user named
};

/// Target of a file: a name in an open folder. From a path, the folder is the one that the
/// user named: for a file deeper in a folder tree of the program, give the folder itself.
class WritePath {
 public:
  template <class Path>
  requires std::convertible_to<const Path&, std::filesystem::path> WritePath(
      const Path& file)  // NOLINT(google-explicit-constructor): a path is sufficient
      : WritePath(std::filesystem::path(file), 0) {}
  WritePath(WriteFolder folder, std::string name);

  [[nodiscard]] const WriteFolder& folder() const noexcept { return folder_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] std::filesystem::path path() const { return path_; }

 private:
  WritePath(const std::filesystem::path& file, int);
  WriteFolder folder_;
  std::string name_;
  std::filesystem::path path_;  ///< as the user gave it, for messages
};

/// A file that appears under its name as a whole: it has no name, or a hidden one, until commit()
/// has forced it to the disk and renamed it over the old file. Readers of the name see the old
/// content or the new one, never a part, also after a crash. Permissions of an existing file are
/// kept, except those to execute it.
class PendingFile {
 public:
  /// @throws WriteError naming the path and the reason: folder not writable, the name is a link, a
  /// folder, a device or a pipe, or the file there is write-protected (for root, too)
  explicit PendingFile(const WritePath& place);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  void write(std::string_view piece);
  /// Over what is there already; the next write() goes to the end again.
  void write_at(std::uint64_t position, std::string_view piece);
  /// For another program of this user that writes the content; valid until commit().
  [[nodiscard]] std::filesystem::path open_path() const;
  /// @throws WriteError
  void commit();

 private:
  void give_name();
  WriteFolder folder_;
  std::string target_, name_;
  std::filesystem::path shown_;
  int descriptor_ = -1;
  bool named_ = false, renamed_ = false;
};

/// Replaces a file as a whole by PendingFile. @throws WriteError
void write_file_atomically(const WritePath& place, std::string_view content);

/// The same for content that is produced piece by piece. Nothing is replaced when `produce` throws.
using TextSink = std::function<void(std::string_view piece)>;
void write_file_atomically(const WritePath& place,
                           const std::function<void(const TextSink&)>& produce);

/// @throws WriteError with the sentence for the user when the name is a link, a folder, a device or
/// a pipe, or the file there is write-protected. Nothing there: passes.
void check_writable_file(const WritePath& place);

/// Is there a file that may not be written? A new one could take its name in a writable folder, and
/// root may write all: a user who removes the permission wants the file to stay.
[[nodiscard]] bool write_protected(const std::filesystem::path& path);

/// Name of the new file until it is renamed, X for any letter or digit: what a killed process may
/// leave on file systems that have no files without a name.
[[nodiscard]] std::string temporary_pattern(const std::filesystem::path& target);

/// Makes the folder that the user named, with those above it. @return how many were missing
/// @throws WriteError
int make_folders(const std::filesystem::path& named);
/// Removes the last `count` folders of the path while they are empty.
void remove_empty_folders(std::filesystem::path named, int count) noexcept;
/// A new folder of this user alone, with a unique name that begins with `stem`, in the folder for
/// temporary files. @throws WriteError
[[nodiscard]] std::filesystem::path make_temporary_folder(const std::string& stem);
/// Removes a file or link of the user's own (drafts, old copies). Links are removed, not followed.
void remove_file(const std::filesystem::path& path) noexcept;
/// Removes a folder of temporary files with all it holds; links in it are removed, not followed.
void remove_tree(const std::filesystem::path& folder) noexcept;

}  // namespace adore
