#include "adrinput/file_names.hpp"

#include <system_error>
#include <vector>

namespace adore::adrinput {

namespace fs = std::filesystem;

fs::path normalized_path(const fs::path& path) {
  if (path.empty()) return path;
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return path;
  const fs::path folder = fs::weakly_canonical(absolute.parent_path(), error);
  return error ? absolute : folder / absolute.filename();
}

std::string shortened_path(const fs::path& path) {
  constexpr std::size_t kMost = 64;  // bytes that a question has room for
  const std::string whole = path.string();
  if (whole.size() <= kMost) return whole;
  const std::vector<fs::path> parts(path.begin(), path.end());
  constexpr std::size_t kFront = 2, kBack = 3;  // root and first folder; two folders and the file
  if (parts.size() <= kFront + kBack) return whole;
  const std::string front = (parts[0] / parts[1]).string() + "/\u2026/";
  fs::path back;
  for (std::size_t i = parts.size(); i-- > kFront;) {
    const fs::path longer = back.empty() ? parts[i] : parts[i] / back;
    if (parts.size() - i > kBack && front.size() + longer.string().size() > kMost) break;
    back = longer;
  }
  return front + back.string();
}

}  // namespace adore::adrinput
