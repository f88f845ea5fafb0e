#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace adore::test {

/// All of a file; nothing when there is none. Tests are compiled without optimization: to go
/// through a file by iterators of its characters took half of the time of those that compare files.
[[nodiscard]] inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream out;
  out << stream.rdbuf();
  return std::move(out).str();
}

}  // namespace adore::test
