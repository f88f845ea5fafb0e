#include "results/growing_file.hpp"

#include "base/checksum.hpp"
#include "base/write_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <exception>
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
      return "create the folder first, or choose another folder";
    case ENOSPC:
    case EDQUOT:
      return "free some disk space or choose another disk";
    case EISDIR:
      return "give the name of a file, not of a folder";
    case ELOOP:
      return "replace the symbolic link with a regular file";
    case EFBIG:
      return "the file has reached the size limit (ulimit -f, or the file system). Increase the "
             "limit, choose another disk, or store fewer steps";
    default:
      return "choose another folder";
  }
}

[[noreturn]] void fail(const fs::path& path, int error, std::string_view what) {
  Issue issue;
  issue.file = path.string();
  issue.message = fmt::format("{}: {}", what, std::generic_category().message(error));
  issue.remedy = remedy(error);
  throw WriteError({issue});
}

/// Checksum of the first bytes of an open file, as far as they can be read.
std::uint64_t sum_of(int descriptor, std::uintmax_t bytes) {
  std::uint64_t sum = checksum({});
  std::string block(std::size_t{1} << 16, '\0');
  for (std::uintmax_t at = 0; at < bytes;) {
    const auto most = static_cast<std::size_t>(std::min<std::uintmax_t>(block.size(), bytes - at));
    const ssize_t count = ::pread(descriptor, block.data(), most, static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    sum = checksum({block.data(), static_cast<std::size_t>(count)}, sum);
    at += static_cast<std::uintmax_t>(count);
  }
  return sum;
}

}  // namespace

GrowingFile::GrowingFile(fs::path path, int descriptor, std::uintmax_t bytes)
    : path_(std::move(path)), descriptor_(descriptor), bytes_(bytes) {}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      bytes_(other.bytes_),
      sum_(other.sum_),
      is_buffering_(other.is_buffering_),
      pending_text_(std::exchange(other.pending_text_, {})) {}

GrowingFile& GrowingFile::operator=(GrowingFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(bytes_, other.bytes_);
  std::swap(sum_, other.sum_);
  std::swap(is_buffering_, other.is_buffering_);
  std::swap(pending_text_, other.pending_text_);
  return *this;
}

GrowingFile::~GrowingFile() {
  if (descriptor_ < 0) return;
  try {
    flush();
  } catch (const std::exception&) {
    // Errors cannot be reported here; flush() reports them.
  }
  ::close(descriptor_);
}

GrowingFile GrowingFile::create(const WritePath& place) {
  return {place.path(), place.folder().create(place.name()), 0};
}

GrowingFile GrowingFile::open_for_append(const WritePath& place, std::uintmax_t bytes) {
  const fs::path path = place.path();
  const int descriptor = place.folder().open_own(place.name());
  GrowingFile file(path, descriptor, bytes);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0)
    fail(path, errno, "the file that this run continues cannot be read");
  if (static_cast<std::uintmax_t>(status.st_size) < bytes)
    throw InputError(
        fmt::format("{}: the file has {} bytes, but had {} at the end of the run that is "
                    "continued. Restore the file, or start a new run with kIcOpt = -1",
                    path.string(), status.st_size, bytes));
  file.sum_ = sum_of(descriptor, bytes);
  if (::ftruncate(descriptor, static_cast<off_t>(bytes)) != 0 ||
      ::lseek(descriptor, static_cast<off_t>(bytes), SEEK_SET) < 0)
    fail(path, errno, "the file that this run continues cannot be truncated");
  return file;
}

void GrowingFile::append(std::string_view piece) {
  constexpr std::size_t kMaxWaitingBytes = std::size_t{1} << 16U;
  if (!is_buffering_) {
    write(piece);
    return;
  }
  pending_text_ += piece;
  if (pending_text_.size() >= kMaxWaitingBytes) flush();
}

void GrowingFile::flush() {
  if (pending_text_.empty()) return;
  std::string pieces;
  pieces.swap(pending_text_);  // tried once
  write(pieces);
  pieces.clear();
  pending_text_.swap(pieces);  // and their room kept
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
      fail(path_, error, "writing to the file failed");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  bytes_ += pieces.size();
  sum_ = checksum(pieces, sum_);
}

}  // namespace adore::results
