#include "base/input_file.hpp"
#include "base/write_error.hpp"
#include "results/growing_file.hpp"
#include "studies/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>

namespace adore::studies {
namespace {

constexpr int kInterrupted = 130;

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

int run_tasks_from_stdin(const std::filesystem::path& folder, const std::stop_token& stop) {
  const auto say = [](const std::string& line) {
    return std::fputs(line.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  };
  try {
    const Job job = read_job(folder);
    TaskSource source{"standard input", 0, job.decks.size()};
    for (std::string line; !stop.stop_requested() && std::getline(std::cin, line);) {
      ++source.line;
      const Task task = parse_task(line, source);
      const std::optional<Record> record = run_task(job, task, folder, stop);
      if (!record) return kInterrupted;
      write_record(folder, *record);
      if (!say("done " + task.key + "\n")) return kInterrupted;  // the driver is gone
    }
  } catch (const InputError& error) {  // a file: no fault of a run
    (void)say("halt " + one_line(error.what()) + "\n");
    return 2;
  }
  return stop.stop_requested() ? kInterrupted : 0;
}

int run_tasks_from_file(const std::filesystem::path& folder, const std::filesystem::path& tasks,
                        long first, long count, const std::stop_token& stop) {
  try {
    const Job job = read_job(folder);
    InputFile lines(tasks);
    if (!lines) throw InputError(tasks.string() + ": cannot be read");
    long at = 0;
    for (std::string line; at < first + count && std::getline(lines, line); ++at) {
      if (at < first) continue;
      const Task task = parse_task(line, {tasks.string(), at + 1, job.decks.size()});
      if (read_record(folder, task.key)) continue;  // by an earlier start of this piece
      const std::optional<Record> record = run_task(job, task, folder, stop);
      if (!record) return kInterrupted;
      write_record(folder, *record);
    }
  } catch (const WriteError& error) {
    std::fprintf(stderr, "halt %s\n", one_line(error.what()).c_str());
    return kWriteFailedExit;
  }
  return 0;
}

}  // namespace adore::studies
