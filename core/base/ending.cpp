#include "base/ending.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <poll.h>
#include <unistd.h>

namespace adore {
namespace {

std::atomic<pid_t> listener{0};
static_assert(std::atomic<pid_t>::is_always_lock_free);

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

void hold(int how) {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : kSignals) sigaddset(&set, signal);
  pthread_sigmask(how, &set, nullptr);
}

extern "C" void end_now(int) {
  // A process that was forked from here, with this handler, must not report or remove anything.
  if (getpid() != listener) _exit(kInterruptedCode);
  // Not where it would wait for the reader of a full pipe.
  constexpr char kWord[] = "\ninterrupted\n";
  pollfd error{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&error, 1, 0) == 1 && (error.revents & POLLOUT) != 0)
    (void)!::write(STDERR_FILENO, kWord, sizeof kWord - 1);
  _exit(kInterruptedCode);
}

}  // namespace

void exit_on_interrupt() {
  listener = getpid();
  for (const int signal : kSignals) {
    struct sigaction old {
    }, action{};
    if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) continue;
    action.sa_handler = end_now;
    sigfillset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
  hold(SIG_UNBLOCK);
}

InterruptBlocker::InterruptBlocker() { hold(SIG_BLOCK); }
InterruptBlocker::~InterruptBlocker() { hold(SIG_UNBLOCK); }

}  // namespace adore
