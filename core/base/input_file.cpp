#include "base/input_file.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace adore {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path) {
  throw InputError(path.string() +
                   ": this is a pipe or a device, not a file; give the name of a file");
}

/// @return -1 when there is no file that can be read
int open_regular(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  struct stat status {};
  if (file < 0) {
    if (::stat(path.c_str(), &status) == 0 && S_ISSOCK(status.st_mode)) refuse(path);
    return -1;
  }
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode)) return file;
  ::close(file);
  if (S_ISDIR(status.st_mode)) return -1;
  refuse(path);
}

}  // namespace

InputFile::InputFile(const fs::path& path) : std::istream(nullptr) {
  const int file = open_regular(path);
  if (file < 0) {
    setstate(std::ios::failbit);
    return;
  }
  buffer_ = __gnu_cxx::stdio_filebuf<char>(file, std::ios::in | std::ios::binary);
  rdbuf(&buffer_);
}

InputFile::InputFile(InputFile&& other)
    : std::istream(std::move(other)), buffer_(std::move(other.buffer_)) {
  if (buffer_.is_open()) set_rdbuf(&buffer_);
}

std::string read_text_file(const fs::path& path, std::uintmax_t limit) {
  InputFile stream(path);
  if (!stream) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
      throw InputError(fmt::format("{}: there is no such file; give the name of an existing file",
                                   path.string()));
    if (fs::is_directory(status))
      throw InputError(
          fmt::format("{}: this is a folder; give the name of a file in it", path.string()));
    throw InputError(
        fmt::format("{}: the file cannot be read; check its permissions", path.string()));
  }
  // A file that grows meanwhile, or has no length (/proc), is cut off, too.
  std::string text, block(std::size_t{1} << 16, '\0');
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) ||
         stream.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > limit) {
      std::error_code error;
      throw InputError(fmt::format(
          "{}: the file has {} bytes, but at most {} are allowed for this kind of file; give "
          "another file",
          path.string(), std::max<std::uintmax_t>(fs::file_size(path, error), text.size()), limit));
    }
  }
  return text;
}

bool is_plain_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

void reject_special_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_other(fs::status(path, error))) refuse(path);
}

}  // namespace adore
