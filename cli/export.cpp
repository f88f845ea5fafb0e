#include "cli/export.hpp"

#include "base/atomic_file.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string>

namespace adore::cli {
namespace {

namespace fs = std::filesystem;

/// How exports of one kind begin: the heading of a CSV file, the first key of a JSON file.
std::string_view beginning(std::string_view text) {
  if (text.substr(0, 1) != "{") return text.substr(0, text.find('\n'));
  return text.substr(0, text.find(':'));
}

}  // namespace

void write_export(const fs::path& path, std::string_view text,
                  const std::vector<fs::path>& inputs) {
  std::error_code error;
  for (const fs::path& input : inputs)
    if (fs::equivalent(input, path, error))
      throw InputError(
          fmt::format("--out {}: this is the file that is read; name another one", path.string()));
  const fs::file_status status = fs::symlink_status(path, error);
  if (fs::is_regular_file(status) && fs::file_size(path, error) > 0) {
    const std::string_view start = beginning(text);
    std::string old(start.size() + 1, '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(old.data(), static_cast<std::streamsize>(old.size()));
    old.resize(static_cast<std::size_t>(stream.gcount()));
    if (start.empty() || beginning(old) != start)
      throw InputError(fmt::format(
          "--out {}: the file exists and is no export of this kind; name another one, or remove it "
          "first",
          path.string()));
  } else if (fs::is_symlink(status)) {
    throw InputError(fmt::format("--out {}: this is a symbolic link to {}; name the file itself",
                                 path.string(), fs::read_symlink(path, error).string()));
  }
  write_file_atomically(path, text);
}

}  // namespace adore::cli
