#include "base/write_folder.hpp"

#include "base/write_error.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace adore {
namespace {

namespace fs = std::filesystem;

std::string_view remedy_of(int error) {
  switch (error) {
    case EACCES:
    case EPERM:
    case EROFS:
      return "make the file and its folder writable, or choose another folder";
    case ENOENT:
    case ENOTDIR:
      return "create the folder first, or choose another folder";
    case ENOSPC:
    case EDQUOT:
      return "free some disk space or choose another disk";
    case EISDIR:
      return "give the name of a file";
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f), or choose another disk";
    default:
      return "choose another folder";
  }
}

[[noreturn]] void fail(const fs::path& path, std::string message, std::string_view remedy) {
  Issue issue;
  issue.file = path.string();
  issue.message = std::move(message);
  issue.remedy = remedy;
  throw WriteError({issue});
}

[[noreturn]] void fail(const fs::path& path, int error, std::string_view step) {
  fail(path,
       fmt::format("the file cannot be written ({}: {})", step,
                   std::generic_category().message(error)),
       remedy_of(error));
}

[[noreturn]] void refuse_link(const fs::path& path, int folder, const char* name) {
  std::string target(4096, '\0');
  const ssize_t size = ::readlinkat(folder, name, target.data(), target.size());
  target.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  fail(path,
       fmt::format("this is a symbolic link to {}, and outputs are not written through links",
                   target),
       "remove the link, or choose another folder");
}

/// Nothing: there is none.
struct Found {
  bool any = false;
  struct stat status {};
};
Found look_up(int folder, const char* name) {
  Found out;
  out.any = ::fstatat(folder, name, &out.status, AT_SYMLINK_NOFOLLOW) == 0;
  return out;
}

std::string own_link(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

/// Makes a rename itself durable; not every file system allows it, and then only that is lost.
void flush_folder(int descriptor) {
  const int folder = ::openat(descriptor, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos &&
         name.find('\0') == std::string::npos;
}

/// The message of a missing folder names the file.
WriteFolder folder_of(const fs::path& file) {
  const fs::path folder = file.parent_path();
  if (::access(folder.empty() ? "." : folder.c_str(), F_OK) != 0)
    fail(file, errno, "opening its folder");
  return WriteFolder(folder);
}

/// To look names up: a folder that may be written but not listed will do.
constexpr int kFolder = O_PATH | O_DIRECTORY | O_CLOEXEC;

}  // namespace

WriteFolder::WriteFolder(fs::path path, int descriptor, uid_t owner)
    : path_(std::move(path)),
      descriptor_(new const int(descriptor),
                  [](const int* open) {
                    ::close(*open);
                    delete open;
                  }),
      owner_(owner) {}

WriteFolder::WriteFolder(const fs::path& named) : path_(named) {
  const int descriptor = ::open(named.empty() ? "." : named.c_str(), kFolder);
  if (descriptor < 0) fail(named, errno, "opening its folder");
  struct stat status {};
  (void)::fstat(descriptor, &status);
  *this = WriteFolder(named, descriptor, status.st_uid);
}

void WriteFolder::demand_own(const std::string& name, int descriptor) const {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) fail(path_ / name, errno, "examining it");
  if (status.st_uid == ::geteuid() || status.st_uid == owner_) return;
  fail(path_ / name,
       fmt::format("the owner is user {}, who is neither you nor the owner of the parent folder",
                   status.st_uid),
       "remove this file or folder, or choose another folder");
}

WriteFolder WriteFolder::folder(const fs::path& below) const {
  WriteFolder out = *this;
  for (const fs::path& part : below) {
    const std::string name = part.string();
    if (name.empty() || name == ".") continue;  // "runs/"
    const fs::path path = out.path_ / name;
    if (!is_plain_name(name))
      fail(path, "this is not a folder below the results folder", "choose another name");
    int descriptor = ::openat(out.descriptor(), name.c_str(), kFolder | O_NOFOLLOW);
    if (descriptor < 0 && errno == ENOENT) {
      if (::mkdirat(out.descriptor(), name.c_str(), 0777) != 0 && errno != EEXIST)
        fail(path,
             fmt::format("the folder cannot be created ({})",
                         std::generic_category().message(errno)),
             remedy_of(errno));
      descriptor = ::openat(out.descriptor(), name.c_str(), kFolder | O_NOFOLLOW);
    }
    if (descriptor < 0) {
      const int error = errno;
      if (const Found there = look_up(out.descriptor(), name.c_str());
          there.any && S_ISLNK(there.status.st_mode))
        refuse_link(path, out.descriptor(), name.c_str());
      fail(path,
           fmt::format("the folder cannot be opened ({})", std::generic_category().message(error)),
           error == ENOTDIR
               ? "remove the file with the same name as this folder, or choose another folder"
               : remedy_of(error));
    }
    const WriteFolder above = out;
    out = WriteFolder(path, descriptor, owner_);
    above.demand_own(name, descriptor);
  }
  return out;
}

WriteFolder WriteFolder::new_folder(const std::string& stem) const {
  for (int number = 1;; ++number) {
    const std::string name = fmt::format("{}-{}", stem, number);
    if (::mkdirat(descriptor(), name.c_str(), 0777) == 0) return folder(name);
    if (errno != EEXIST)
      fail(path_ / name,
           fmt::format("the folder cannot be created ({})", std::generic_category().message(errno)),
           remedy_of(errno));
  }
}

int WriteFolder::create(const std::string& name) const {
  const fs::path path = path_ / name;
  if (!is_plain_name(name)) fail(path, EISDIR, "opening");
  if (const Found old = look_up(descriptor(), name.c_str()); old.any) {
    if (!S_ISREG(old.status.st_mode) && !S_ISLNK(old.status.st_mode))
      fail(path, "this is not a regular file",
           "remove this file or folder, or choose another folder");
    if (::unlinkat(descriptor(), name.c_str(), 0) != 0 && errno != ENOENT)
      fail(path, errno, "replacing");
  }
  const int file = ::openat(descriptor(), name.c_str(),
                            O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (file < 0) fail(path, errno, "creating");
  return file;
}

int WriteFolder::open_own(const std::string& name) const {
  const fs::path path = path_ / name;
  if (!is_plain_name(name)) fail(path, EISDIR, "opening");
  const int file =
      ::openat(descriptor(), name.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) {
    const int error = errno;
    if (error == ELOOP) refuse_link(path, descriptor(), name.c_str());
    fail(path, error, "opening");
  }
  try {
    struct stat status {};
    if (::fstat(file, &status) != 0) fail(path, errno, "examining it");
    if (!S_ISREG(status.st_mode))
      fail(path, "this is not a regular file",
           "remove this file or folder, or choose another folder");
    if (status.st_nlink != 1)
      fail(path, "writing to the file would also change its other hard links",
           "replace the file by a copy (cp FILE COPY; mv COPY FILE)");
    demand_own(name, file);
  } catch (...) {
    ::close(file);
    throw;
  }
  return file;
}

int WriteFolder::open_lock(const std::string& name) const noexcept {
  const int file =
      ::openat(descriptor(), name.c_str(),
               O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666);
  struct stat status {};
  if (file < 0 || ::fstat(file, &status) != 0) return file;
  if (S_ISREG(status.st_mode) && status.st_nlink <= 1) return file;
  ::close(file);
  errno = S_ISREG(status.st_mode) ? EMLINK : EINVAL;
  return -1;
}

void WriteFolder::remove(const std::string& name) const noexcept {
  if (is_plain_name(name)) (void)::unlinkat(descriptor(), name.c_str(), 0);
}

void WriteFolder::rename(const std::string& name, const WriteFolder& to,
                         const std::string& new_name) const {
  if (!is_plain_name(name) || !is_plain_name(new_name)) fail(path_ / name, EISDIR, "moving");
  if (::renameat(descriptor(), name.c_str(), to.descriptor(), new_name.c_str()) != 0)
    fail(path_ / name,
         fmt::format("the file cannot be moved to {} ({})", (to.path_ / new_name).string(),
                     std::generic_category().message(errno)),
         "move the file by hand");
}

WritePath::WritePath(const fs::path& file, int)
    : folder_(folder_of(file)), name_(file.filename().string()), path_(file) {}

WritePath::WritePath(WriteFolder folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)), path_(folder_.path() / name_) {}

void check_writable_file(const WritePath& place) {
  const fs::path shown = place.path();
  const int folder = place.folder().descriptor();
  if (!is_plain_name(place.name())) fail(shown, shown.empty() ? ENOENT : EISDIR, "opening");
  const Found old = look_up(folder, place.name().c_str());
  if (!old.any) return;
  const mode_t mode = old.status.st_mode;
  if (S_ISLNK(mode)) refuse_link(shown, folder, place.name().c_str());
  if (S_ISDIR(mode)) fail(shown, EISDIR, "opening");
  if (!S_ISREG(mode))
    fail(shown, "this is a pipe or a device, not a file", "give the name of a file");
  if ((mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 ||
      ::faccessat(folder, place.name().c_str(), W_OK, 0) != 0)
    fail(shown, "the file is write-protected and was not changed",
         "give another file name, or make the file writable (chmod u+w)");
}

PendingFile::PendingFile(const WritePath& place)
    : folder_(place.folder()), target_(place.name()), shown_(place.path()) {
  check_writable_file(place);
  descriptor_ =
      ::openat(folder_.descriptor(), ".", O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (descriptor_ >= 0 && ::access(own_link(descriptor_).c_str(), F_OK) != 0) {
    ::close(descriptor_);  // no /proc: it could not be named later
    descriptor_ = -1;
  }
  if (descriptor_ < 0) give_name();
}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (named_ && !renamed_) folder_.remove(name_);
}

void PendingFile::give_name() {
  static std::atomic<unsigned> counter{0};
  const std::string pattern = temporary_pattern(target_);
  const std::string stem = pattern.substr(0, pattern.size() - 6);  // before the X's
  for (int attempt = 0;; ++attempt) {
    const unsigned number = static_cast<unsigned>(::getpid()) * 64 + counter++;
    name_ = stem + fmt::format("{:06x}", number & 0xffffffU);
    if (descriptor_ >= 0) {
      named_ = ::linkat(AT_FDCWD, own_link(descriptor_).c_str(), folder_.descriptor(),
                        name_.c_str(), AT_SYMLINK_FOLLOW) == 0;
    } else {
      descriptor_ = ::openat(folder_.descriptor(), name_.c_str(),
                             O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR);
      named_ = descriptor_ >= 0;
    }
    if (named_) return;
    if (errno != EEXIST || attempt > 100) fail(shown_, errno, "creating a file in its folder");
  }
}

void PendingFile::write(std::string_view piece) {
  while (!piece.empty()) {
    const ssize_t count = ::write(descriptor_, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(shown_, errno, "writing");
    piece.remove_prefix(static_cast<std::size_t>(count));
  }
}

void PendingFile::write_at(std::uint64_t position, std::string_view piece) {
  while (!piece.empty()) {
    const ssize_t count =
        ::pwrite(descriptor_, piece.data(), piece.size(), static_cast<off_t>(position));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(shown_, errno, "writing");
    position += static_cast<std::uint64_t>(count);
    piece.remove_prefix(static_cast<std::size_t>(count));
  }
}

fs::path PendingFile::open_path() const {
  return fmt::format("/proc/{}/fd/{}", ::getpid(), descriptor_);
}

void PendingFile::commit() {
  // The file is private so far; a data file is readable as the user's mask says, and not a program.
  const Found old = look_up(folder_.descriptor(), target_.c_str());
  mode_t mode = old.status.st_mode & 0666;
  if (!old.any) {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    mode = 0666 & ~mask;
  }
  if (::fchmod(descriptor_, mode) != 0) fail(shown_, errno, "setting its permissions");
  if (::fsync(descriptor_) != 0) fail(shown_, errno, "flushing to the disk");
  if (!named_) give_name();
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail(shown_, errno, "closing");
  if (::renameat(folder_.descriptor(), name_.c_str(), folder_.descriptor(), target_.c_str()) != 0)
    fail(shown_, errno, "replacing");
  renamed_ = true;
  flush_folder(folder_.descriptor());
}

void write_file_atomically(const WritePath& place, std::string_view content) {
  write_file_atomically(place, [&](const TextSink& write) { write(content); });
}

void write_file_atomically(const WritePath& place,
                           const std::function<void(const TextSink&)>& produce) {
  PendingFile file(place);
  produce([&](std::string_view piece) { file.write(piece); });
  file.commit();
}

bool write_protected(const fs::path& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return false;
  const bool anybody = (there.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) != 0;
  return !anybody || ::access(path.c_str(), W_OK) != 0;
}

std::string temporary_pattern(const fs::path& target) {
  return fmt::format(".{}.XXXXXX", target.filename().string());
}

int make_folders(const fs::path& named) {
  std::error_code error;
  int missing = 0;
  for (fs::path at = named; !at.empty() && !fs::exists(at, error); at = at.parent_path()) ++missing;
  fs::create_directories(named, error);
  if (!error && !fs::is_directory(named, error))
    error = std::make_error_code(std::errc::file_exists);
  if (error)
    fail(named, fmt::format("the folder cannot be created ({})", error.message()),
         "choose a folder that you can write to");
  return missing;
}

void remove_empty_folders(fs::path named, int count) noexcept {
  for (; count > 0; --count, named = named.parent_path())
    if (::rmdir(named.c_str()) != 0) return;
}

fs::path make_temporary_folder(const std::string& stem) {
  const fs::path place = fs::temp_directory_path();
  std::string pattern = (place / stem).string() + "XXXXXX";
  if (::mkdtemp(pattern.data()) == nullptr)
    throw WriteError(
        fmt::format("{}: a temporary folder cannot be created ({}). Set the environment variable "
                    "TMPDIR to a writable folder.",
                    place.string(), std::generic_category().message(errno)));
  return pattern;
}

void remove_file(const fs::path& path) noexcept { (void)::unlink(path.c_str()); }

void remove_tree(const fs::path& folder) noexcept {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

}  // namespace adore
