#include "base/kept_copy.hpp"

#include "base/input_file.hpp"
#include "base/write_folder.hpp"

#include <iterator>
#include <string>

namespace adore {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& path, std::string_view content) {
  std::error_code error;
  if (fs::file_size(path, error) != content.size() || error) return false;
  InputFile file(path);
  const std::string there{std::istreambuf_iterator<char>(file), {}};
  return there == content;
}

}  // namespace

fs::path write_backup_copy(const fs::path& path, std::string_view content) {
  for (int number = 1;; ++number) {
    fs::path copy = path;
    copy += number == 1 ? ".bak" : ".bak" + std::to_string(number);
    if (holds(copy, content)) return copy;
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(copy, ignored))) continue;
    write_file_atomically(copy, content);
    return copy;
  }
}

}  // namespace adore
