#pragma once

#include "base/input_limits.hpp"

#include <ext/stdio_filebuf.h>
#include <filesystem>
#include <istream>
#include <string>

/// The only code of the suite that opens files for reading (tests/architecture checks that). An
/// input may be a link. A device, a pipe or a socket is rejected: it may never end, or hold its
/// reader for ever. What is opened is examined, not the name, so that it cannot change in between.
namespace adore {

/// A stream of bytes from a regular file; fails (operator bool) when there is none or it cannot be
/// read.
class InputFile : public std::istream {
 public:
  /// @throws InputError for a device, a pipe or a socket
  explicit InputFile(const std::filesystem::path& path);
  InputFile(InputFile&& other);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

 private:
  __gnu_cxx::stdio_filebuf<char> buffer_;
};

/// The whole of a text file. @throws InputError when it cannot be read or has more than `limit`
/// bytes.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path,
                                         std::uintmax_t limit = kMaxTextBytes);

/// Lets regular files, folders and missing files pass, which their readers tell apart.
/// @throws InputError for a pipe, a socket or a device
void reject_special_file(const std::filesystem::path& path);

/// True through links; false for what does not exist, too.
[[nodiscard]] bool is_plain_file(const std::filesystem::path& path);

}  // namespace adore
