#pragma once

#include <filesystem>

namespace adore::test {

/// The process works in another folder while this lives.
class Elsewhere {
 public:
  explicit Elsewhere(const std::filesystem::path& folder) { std::filesystem::current_path(folder); }
  ~Elsewhere() { std::filesystem::current_path(before_); }
  Elsewhere(const Elsewhere&) = delete;
  Elsewhere& operator=(const Elsewhere&) = delete;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

}  // namespace adore::test
