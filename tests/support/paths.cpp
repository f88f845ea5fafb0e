#include "support/paths.hpp"

namespace adore::test {

const std::filesystem::path& source_dir() {
  static const std::filesystem::path path = ADORE_SOURCE_DIR;
  return path;
}

const std::filesystem::path& binary_dir() {
  static const std::filesystem::path path = ADORE_BINARY_DIR;
  return path;
}

std::filesystem::path program(std::string_view name) { return binary_dir() / "bin" / name; }

}  // namespace adore::test
