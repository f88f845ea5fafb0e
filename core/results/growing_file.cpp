#include "results/growing_file.hpp"

#include "base/plain_file.hpp"
#include "base/write_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace adore::results {
namespace {

namespace fs = std::filesystem;

std::string_view remedy(int error) {
  switch (error) {
    case EACCES:
    case EPERM:
    case EROFS:
      return "make the file and its folder writable, or choose another folder";
    case ENOENT:
    case ENOTDIR:
      return "create the folder first or choose another one";
    case ENOSPC:
    case EDQUOT:
      return "free some disk space or choose another disk";
    case EISDIR:
      return "give the name of a file, not of a folder";
    case ELOOP:
      return "put the file itself in place of the symbolic link";
    case EFBIG:
      return "no larger files are allowed here (ulimit -f, or the file system): raise the limit, "
             "choose "
             "another disk, or store fewer steps";
    default:
      return "choose another place";
  }
}

[[noreturn]] void fail(const fs::path& path, int error, std::string_view what) {
  Issue issue;
  issue.file = path.string();
  issue.message = fmt::format("{}: {}", what, std::generic_category().message(error));
  issue.remedy = remedy(error);
  throw WriteError({issue});
}

}  // namespace

GrowingFile::GrowingFile(fs::path path, int descriptor, std::uintmax_t bytes)
    : path_(std::move(path)), descriptor_(descriptor), bytes_(bytes) {}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      bytes_(other.bytes_),
      collects_(other.collects_),
      waiting_(std::exchange(other.waiting_, {})) {}

GrowingFile& GrowingFile::operator=(GrowingFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(bytes_, other.bytes_);
  std::swap(collects_, other.collects_);
  std::swap(waiting_, other.waiting_);
  return *this;
}

GrowingFile::~GrowingFile() {
  if (descriptor_ < 0) return;
  try {
    flush();
  } catch (const std::exception&) {
    // Nobody can be told from here; flush() reports.
  }
  ::close(descriptor_);
}

GrowingFile GrowingFile::create(const fs::path& path) {
  // A file of its own: neither the target of a link nor another name of the old file is written to,
  // and permissions to execute are not inherited. What is no plain file (a device) stays.
  struct stat old {};
  const bool exists = ::lstat(path.c_str(), &old) == 0;
  const bool replaces = exists && (S_ISREG(old.st_mode) || S_ISLNK(old.st_mode));
  if (replaces && ::unlink(path.c_str()) != 0 && errno != ENOENT)
    fail(path, errno, "the file cannot be replaced");
  const int how = exists && !replaces ? O_WRONLY : O_WRONLY | O_CREAT | O_EXCL;
  const int descriptor = ::open(path.c_str(), how | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(path, errno, "the file cannot be written");
  return {path, descriptor, 0};
}

GrowingFile GrowingFile::append_after(const fs::path& path, std::uintmax_t bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) fail(path, errno, "the file to be continued cannot be opened");
  GrowingFile file(path, descriptor, bytes);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0)
    fail(path, errno, "the file to be continued cannot be examined");
  if (static_cast<std::uintmax_t>(status.st_size) < bytes)
    throw InputError(
        fmt::format("{}: the file has {} bytes, but the run to be continued left {}; restore the "
                    "file, or start a new run with kIcOpt = -1",
                    path.string(), status.st_size, bytes));
  if (::ftruncate(descriptor, static_cast<off_t>(bytes)) != 0 ||
      ::lseek(descriptor, static_cast<off_t>(bytes), SEEK_SET) < 0)
    fail(path, errno, "the file to be continued cannot be cut back");
  return file;
}

void GrowingFile::append(std::string_view piece) {
  constexpr std::size_t kMost = std::size_t{1} << 16U;
  if (!collects_) {
    write(piece);
    return;
  }
  waiting_ += piece;
  if (waiting_.size() >= kMost) flush();
}

void GrowingFile::flush() {
  if (waiting_.empty()) return;
  std::string pieces;
  pieces.swap(waiting_);  // tried once
  write(pieces);
  pieces.clear();
  waiting_.swap(pieces);  // and their room kept
}

void GrowingFile::write(std::string_view pieces) {
  std::string_view rest = pieces;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const int error = written < 0 ? errno : EIO;
      // Whole pieces only. Where even cutting fails (a device), the reader still finds every whole
      // step.
      if (::ftruncate(descriptor_, static_cast<off_t>(bytes_)) == 0)
        (void)::lseek(descriptor_, static_cast<off_t>(bytes_), SEEK_SET);
      fail(path_, error, "the file cannot be written any further");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  bytes_ += pieces.size();
}

std::string read_text_file(const fs::path& path, std::uintmax_t limit) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    throw InputError(
        fmt::format("{}: there is no such file; give the name of an existing one", path.string()));
  if (fs::is_directory(status))
    throw InputError(
        fmt::format("{}: this is a folder; give the name of a file in it", path.string()));
  refuse_pipe(path);
  if (const std::uintmax_t size = fs::file_size(path, error); !error && size > limit)
    throw InputError(fmt::format(
        "{}: {} bytes are too many for this kind of file (at most {}); give another file",
        path.string(), size, limit));
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream && text.empty())
    throw InputError(
        fmt::format("{}: the file cannot be read; check its permissions", path.string()));
  return text;
}

}  // namespace adore::results
