#pragma once

#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

/// Actions of tests of the program `adore`: start it in a separate folder and read its files.
namespace adore::test {

namespace fs = std::filesystem;

/// A separate folder for one test, removed at the end.
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

/// Runs a line in a shell; for redirections and limits. ADORE stands for the program.
inline Result run_shell(std::string line) {
  for (std::size_t at = 0; (at = line.find("ADORE ", at)) != std::string::npos;)
    line.replace(at, 5, program("adore").string());
  Result result;
  FILE* pipe = popen(line.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer{};
  std::size_t count = 0;
  while ((count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0)
    result.out.append(buffer.data(), count);
  const int status = pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

/// The unchanged command.
inline Result run_as_given(const std::string& arguments, const std::string& environment = "") {
  return run_shell(environment + " " + command_line(arguments) + " 2>&1");
}

/// The same, and a run may replace the results of the one before: most tests run several times in
/// one folder.
inline Result run_adore(const std::string& arguments, const std::string& environment = "") {
  const bool replaces = arguments.rfind("run ", 0) == 0 &&
                        arguments.find("--continue") == std::string::npos &&
                        arguments.find("--overwrite") == std::string::npos;
  return run_as_given(arguments + (replaces ? " --overwrite" : ""), environment);
}

inline void write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string read(const fs::path& path) { return test::bytes_of(path); }

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A new ball deck in the folder, stored often enough for short runs.
inline void new_ball_deck(const Folder& folder) {
  REQUIRE(run_adore("new ball --out " + (folder / "DATA.txt").string()).code == 0);
}

/// Waits for something that the program does, however long that takes on this machine.
template <class Condition>
void wait_for(Condition condition) {
  for (int i = 0; i < 15000 && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  REQUIRE(condition());
}

/// A run in the background without an end. It ends with this object, and with the test program in
/// any case.
class EndlessRun {
 public:
  /// With the deck of the folder and further arguments; its output goes into the file "said".
  explicit EndlessRun(const Folder& folder, const std::vector<std::string>& more = {},
                      const std::string& until = "1e9rev",
                      const std::string& checkpoint_seconds = "0.05")
      : said_(folder / "said") {
    std::vector<std::string> words{program("adore").string(),
                                   "run",
                                   folder.path().string(),
                                   "--overwrite",
                                   "--opt",
                                   "checkpointSeconds=" + checkpoint_seconds};
    if (!until.empty()) words.insert(words.end(), {"--until", until});
    words.insert(words.end(), more.begin(), more.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string said = said_.string();
    const pid_t parent = getpid();
    child_ = fork();
    if (child_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int file = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (getppid() == parent && file >= 0 && dup2(file, STDOUT_FILENO) >= 0 &&
        dup2(file, STDERR_FILENO) >= 0)
      execv(arguments.front(), arguments.data());
    _exit(99);
  }
  ~EndlessRun() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  EndlessRun(const EndlessRun&) = delete;
  EndlessRun& operator=(const EndlessRun&) = delete;

  [[nodiscard]] bool alive() const { return ::kill(child_, 0) == 0; }
  void send(int signal) const { REQUIRE(::kill(child_, signal) == 0); }
  /// Has the program taken over the handling of all interrupts?
  [[nodiscard]] bool listens() const {
    std::ifstream status(fmt::format("/proc/{}/status", child_));
    for (std::string line; std::getline(status, line);)
      if (line.rfind("SigCgt:", 0) == 0)
        return (std::stoull(line.substr(7), nullptr, 16) & kInterrupts) == kInterrupts;
    return false;
  }
  /// Waits for its end. @return the exit code, or 128 + the signal that ended it
  int end() {
    int status = 0;
    REQUIRE(waitpid(child_, &status, 0) == child_);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  [[nodiscard]] std::string said() const { return test::bytes_of(said_); }

 private:
  static constexpr std::uint64_t kInterrupts =
      1ULL << (SIGINT - 1) | 1ULL << (SIGTERM - 1) | 1ULL << (SIGHUP - 1);
  fs::path said_;
  pid_t child_ = -1;
};

}  // namespace adore::test
