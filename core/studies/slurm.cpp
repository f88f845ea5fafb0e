#include "studies/slurm.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <poll.h>
#include <sstream>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>

namespace adore::studies {
namespace {

std::vector<std::string> fields(const std::string& line, char separator) {
  std::vector<std::string> out;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);) out.push_back(field);
  return out;
}

/// Value of "Name=value" in the words of scontrol.
std::string value_of(const std::string& text, const std::string& name) {
  const std::size_t at = (" " + text).find(" " + name + "=");
  if (at == std::string::npos) return {};
  const std::size_t from = at + name.size() + 1;
  return text.substr(from, text.find_first_of(" \n", from) - from);
}

long whole(const std::string& text, long otherwise) {
  long value = 0;
  return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc()
             ? value
             : otherwise;
}

/// "0:9": exit code and signal.
SlurmExitState end_of(const std::string& state, const std::string& code) {
  const std::size_t colon = code.find(':');
  return {state, static_cast<int>(whole(code.substr(0, colon), 0)),
          colon == std::string::npos ? 0 : static_cast<int>(whole(code.substr(colon + 1), 0))};
}

/// "CANCELLED by 0" -> "CANCELLED"
std::string first_word(const std::string& text) { return text.substr(0, text.find(' ')); }

}  // namespace

bool is_slurm_job(const std::string& text) {
  return !text.empty() && text.size() <= 20 &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

std::optional<std::string> command_output(const std::vector<std::string>& words,
                                          std::string* error) {
  std::array<int, 2> out{}, err{};
  if (pipe2(out.data(), O_CLOEXEC) != 0) return {};
  if (pipe2(err.data(), O_CLOEXEC) != 0) {
    close(out[0]);
    close(out[1]);
    return {};
  }
  std::vector<char*> argv;
  std::vector<std::string> copy = words;
  for (std::string& word : copy) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    // Ctrl-C is for us.
    setpgid(0, 0);
    const int nowhere = open("/dev/null", O_RDONLY);
    dup2(nowhere, STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    dup2(err[1], STDERR_FILENO);
    execvp(argv[0], argv.data());
    _exit(127);
  }
  close(out[1]);
  close(err[1]);
  std::array<std::string, 2> texts;
  std::array<pollfd, 2> files{{{out[0], POLLIN, 0}, {err[0], POLLIN, 0}}};
  while (child > 0 && (files[0].fd >= 0 || files[1].fd >= 0)) {
    if (poll(files.data(), 2, -1) < 0 && errno != EINTR) break;
    for (std::size_t k = 0; k < 2; ++k) {
      if (files[k].fd < 0 || files[k].revents == 0) continue;
      std::array<char, 4096> block{};
      const ssize_t n = read(files[k].fd, block.data(), block.size());
      if (n > 0) texts[k].append(block.data(), static_cast<std::size_t>(n));
      if (n == 0 || (n < 0 && errno != EINTR)) files[k].fd = -1;
    }
  }
  close(out[0]);
  close(err[0]);
  int status = -1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (error != nullptr) *error = texts[1];
  if (child < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return {};
  return texts[0];
}

int slurm_cores() {
  std::string error;
  const auto text = command_output({"sinfo", "--noheader", "--format=%C"}, &error);
  if (!text)
    throw InputError(
        fmt::format("--engine slurm: {}; install Slurm (packages slurm-wlm and munge), start it, "
                    "or use --engine local",
                    error.empty() ? "there is no Slurm on this machine (sinfo is not found)"
                                  : "Slurm does not answer: " + error.substr(0, error.find('\n'))));
  // allocated/idle/other/total, one line per partition
  long most = 0;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);)
    if (const auto parts = fields(line, '/'); parts.size() == 4)
      most = std::max(most, whole(parts[0], 0) + whole(parts[1], 0));
  if (most == 0)
    throw InputError(
        "--engine slurm: no node is up (`sinfo` shows the reason); start a node, or use --engine "
        "local");
  return static_cast<int>(most);
}

long slurm_max_array_size() {
  constexpr long kDefault = 1001;
  const auto text = command_output({"scontrol", "show", "config"});
  if (!text) return kDefault;
  const std::size_t at = text->find("MaxArraySize");
  const std::size_t sign = text->find('=', at);
  if (at == std::string::npos || sign == std::string::npos) return kDefault;
  return std::max(2L, whole(text->substr(sign + 2, text->find('\n', sign) - sign - 2), kDefault));
}

std::optional<std::map<std::string, int>> slurm_queue(const std::string& job) {
  std::string error;
  const auto text =
      command_output({"squeue", "--noheader", "--array", "--jobs=" + job, "--format=%T"}, &error);
  std::map<std::string, int> out;
  if (!text) {
    // A job that the controller has forgotten is over.
    if (error.find("Invalid job id") != std::string::npos) return out;
    return {};
  }
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) ++out[line];
  for (const char* over : {"COMPLETED", "FAILED", "TIMEOUT", "CANCELLED", "NODE_FAIL"})
    out.erase(over);
  return out;
}

std::map<long, SlurmExitState> slurm_exit_states(const std::string& job) {
  std::map<long, SlurmExitState> out;
  if (const auto text = command_output({"sacct", "--noheader", "--allocations", "--parsable2",
                                        "--jobs=" + job, "--format=JobID,State,ExitCode"})) {
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) {
      const auto parts = fields(line, '|');
      const std::size_t element = line.find('_');
      if (parts.size() != 3 || element == std::string::npos) continue;
      out[whole(parts[0].substr(element + 1), -1)] = end_of(first_word(parts[1]), parts[2]);
    }
  }
  if (!out.empty()) return out;
  if (const auto text = command_output({"scontrol", "--oneliner", "show", "job", job})) {
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) {
      const long element = whole(value_of(line, "ArrayTaskId"), -1);
      if (element >= 0)
        out[element] = end_of(value_of(line, "JobState"), value_of(line, "ExitCode"));
    }
  }
  return out;
}

}  // namespace adore::studies
