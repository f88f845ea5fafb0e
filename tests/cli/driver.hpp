#pragma once

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "support/paths.hpp"

/// What tests of the program `adore` do: start it in a folder of their own and read what it leaves.
namespace adore::test {

namespace fs = std::filesystem;

/// A folder of its own for one test, removed at the end.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "adore-cli-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct Result {
  int code = -1;
  std::string out;  ///< stdout and stderr together
};

inline std::string command_line(const std::string& arguments) {
  return adore::test::program("adore").string() + " " + arguments;
}

inline Result run_adore(const std::string& arguments, const std::string& environment = "") {
  Result result;
  FILE* pipe = popen((environment + " " + command_line(arguments) + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer{};
  std::size_t count = 0;
  while ((count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0)
    result.out.append(buffer.data(), count);
  const int status = pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

inline void write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream out;
  out << file.rdbuf();
  return out.str();
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A new ball deck in the folder, stored often enough for short runs.
inline void new_ball_deck(const Folder& folder) {
  REQUIRE(run_adore("new ball --out " + (folder / "DATA.txt").string()).code == 0);
}

/// Starts a long run in the background and returns its process.
inline pid_t start_long_run(const Folder& folder, const std::string& set = "") {
  const pid_t child = fork();
  if (child == 0) {
    std::freopen("/dev/null", "w", stderr);
    std::freopen("/dev/null", "w", stdout);
    const std::string deck = folder.path().string();
    if (set.empty())
      execl(adore::test::program("adore").c_str(), "adore", "run", deck.c_str(), "--until", "500rev", "--opt",
            "checkpointSeconds=0.2", nullptr);
    else
      execl(adore::test::program("adore").c_str(), "adore", "run", deck.c_str(), "--until", "500rev", "--opt",
            "checkpointSeconds=0.2", "--set", set.c_str(), nullptr);
    _exit(99);
  }
  return child;
}

/// Waits until the run has stored some steps.
inline void wait_for_steps(const Folder& folder, std::uintmax_t bytes) {
  std::error_code error;
  for (int i = 0; i < 600 && (!fs::exists(folder / "SOL7", error) ||
                              fs::file_size(folder / "SOL7", error) < bytes);
       ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  REQUIRE(fs::file_size(folder / "SOL7") >= bytes);
}

}  // namespace adore::test
