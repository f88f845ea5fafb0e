#include "cli/signals.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <unistd.h>

namespace adore::cli {
namespace {

std::atomic<bool> asked{false}, asked_by_user{false};
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr int kInterrupted = 130;

extern "C" void on_signal(int signal) {
  asked = true;
  // A closing terminal may send SIGHUP several times, followed by SIGTERM.
  if (signal != SIGHUP && asked_by_user.exchange(true)) _exit(kInterrupted);
}

void listen(int signal) {
  struct sigaction old {
  }, action{};
  if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) return;
  action.sa_handler = on_signal;  // without SA_RESTART: a write that waits gives up
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void ignore_file_size_signal() { std::signal(SIGXFSZ, SIG_IGN); }

InterruptWatch::InterruptWatch() {
  // No signal is handled between two of these lines: signals wait until all are installed.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) listen(signal);
  std::signal(SIGPIPE, SIG_IGN);
  // The watcher keeps them blocked: signals go to the thread that computes and writes.
  watcher_ = std::jthread([this](std::stop_token done) {
    while (!done.stop_requested()) {
      if (asked) stop_source_.request_stop();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace adore::cli
