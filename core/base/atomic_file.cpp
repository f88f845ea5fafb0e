#include "base/atomic_file.hpp"

#include "base/write_error.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace adore {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error, std::string_view step) {
  std::string remedy;
  switch (error) {
    case EACCES:
    case EPERM:
    case EROFS:
      remedy = "make the folder writable or choose another one";
      break;
    case ENOENT:
    case ENOTDIR:
      remedy = "create the folder first or choose another one";
      break;
    case ENOSPC:
    case EDQUOT:
      remedy = "free some disk space or choose another disk";
      break;
    case EISDIR:
      remedy = "give the name of a file";
      break;
    case EFBIG:
      remedy = "raise the limit on file sizes (ulimit -f), or choose another disk";
      break;
    default:
      remedy = "choose another place";
  }
  Issue issue;
  issue.file = path.string();
  issue.message = fmt::format("the file cannot be written ({}: {})", step,
                              std::generic_category().message(error));
  issue.remedy = remedy;
  throw WriteError({issue});
}

/// The temporary file: closed and removed on every way out unless it was renamed. It gets a name
/// only when all is on the disk, where the file system knows files without one: a process that is
/// killed while it writes leaves nothing behind.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& target, const fs::path& shown) : shown_(shown) {
    const fs::path folder = target.parent_path();
    name_ = (folder / temporary_pattern(target)).string();
    descriptor_ = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC,
                         S_IRUSR | S_IWUSR);
    if (descriptor_ >= 0 && ::access(own_link(descriptor_).c_str(), F_OK) != 0) {
      ::close(descriptor_);  // no /proc, no way to name it later
      descriptor_ = -1;
    }
    named_ = descriptor_ < 0;
    if (named_) descriptor_ = ::mkostemp(name_.data(), O_CLOEXEC);
    if (descriptor_ < 0) fail(shown_, errno, "creating a file in its folder");
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (named_ && !renamed_) ::unlink(name_.c_str());
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t count = ::write(descriptor_, content.data(), content.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(shown_, errno, "writing");
      content.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  /// The file is private so far; a data file should be readable as the user's mask says, and none
  /// is a program.
  void set_permissions_like(const fs::path& target) {
    struct stat old {};
    mode_t mode = 0;
    if (::stat(target.c_str(), &old) == 0) {
      mode = old.st_mode & 0666;
    } else {
      const mode_t mask = ::umask(0);
      ::umask(mask);
      mode = 0666 & ~mask;
    }
    if (::fchmod(descriptor_, mode) != 0) fail(shown_, errno, "setting its permissions");
  }

  void rename_to(const fs::path& target) {
    if (::fsync(descriptor_) != 0) fail(shown_, errno, "flushing to the disk");
    if (!named_) give_name();
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail(shown_, errno, "closing");
    if (::rename(name_.c_str(), target.c_str()) != 0) fail(shown_, errno, "replacing");
    renamed_ = true;
  }

 private:
  static std::string own_link(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
  }
  void give_name() {
    static std::atomic<unsigned> counter{0};
    const std::string stem = name_.substr(0, name_.size() - 6);  // what stands before the X's
    for (int attempt = 0;; ++attempt) {
      const unsigned number = static_cast<unsigned>(::getpid()) * 64 + counter++;
      name_ = stem + fmt::format("{:06x}", number & 0xffffffU);
      if (::linkat(AT_FDCWD, own_link(descriptor_).c_str(), AT_FDCWD, name_.c_str(),
                   AT_SYMLINK_FOLLOW) == 0) {
        named_ = true;
        return;
      }
      if (errno != EEXIST || attempt > 100) fail(shown_, errno, "naming it");
    }
  }

  fs::path shown_;
  std::string name_;
  int descriptor_ = -1;
  bool named_ = false, renamed_ = false;
};

/// Makes the rename itself durable; not every file system allows it, and then nothing is lost but
/// this.
void flush_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

bool write_protected(const fs::path& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return false;
  const bool anybody = (there.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) != 0;
  return !anybody || ::access(path.c_str(), W_OK) != 0;
}

std::string temporary_pattern(const fs::path& target) {
  return fmt::format(".{}.XXXXXX", target.filename().string());
}

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_file_atomically(path, [&](const TextSink& write) { write(content); });
}

void write_file_atomically(const fs::path& path,
                           const std::function<void(const TextSink&)>& produce) {
  std::error_code error;
  fs::path target = fs::weakly_canonical(path, error);  // follows a link, so that it survives
  if (error || target.empty()) target = fs::absolute(path, error);
  if (error || path.empty())
    fail(path, path.empty() ? ENOENT : error.value(), "finding its folder");
  if (fs::is_directory(target, error)) fail(path, EISDIR, "opening");
  if (write_protected(target)) {
    Issue issue;
    issue.file = path.string();
    issue.message = "the file is write-protected and stays as it is";
    issue.remedy = "give another name, or make the file writable (chmod u+w)";
    throw WriteError({issue});
  }

  TemporaryFile file(target, path);
  produce([&](std::string_view piece) { file.write(piece); });
  file.set_permissions_like(target);
  file.rename_to(target);
  flush_folder(target.parent_path());
}

}  // namespace adore
