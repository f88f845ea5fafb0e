#pragma once

#include <stop_token>
#include <thread>

/// Signals that end a run.
namespace adore::cli {

/// A file that grows beyond the limit of its process is a full disk, not the end of the program.
void ignore_file_size_signal();

/// While it lives, SIGINT, SIGTERM and SIGHUP become a stop request; the second SIGINT or SIGTERM
/// ends the program at once. Signals that were ignored when the program started (nohup) stay so. A
/// closed pipe is an error of writing only.
class InterruptWatch {
 public:
  InterruptWatch();
  [[nodiscard]] std::stop_token token() const { return stop_source_.get_token(); }

 private:
  std::stop_source stop_source_;
  std::jthread watcher_;
};

}  // namespace adore::cli
