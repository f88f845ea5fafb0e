#include "user/crash_guard.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace adore::user {
namespace {

constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
std::array<struct sigaction, kSignals.size()> before;
int guards = 0;

void say(const char* text) { (void)!write(STDERR_FILENO, text, std::strlen(text)); }
/// Nothing that allocates is allowed here.
void say(long number) {
  char digits[24];
  int at = 23;
  digits[at] = '\0';
  do {
    digits[--at] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number > 0 && at > 0);
  say(digits + at);
}

void on_crash(int signal) {
  const CallMark* mark = CrashGuard::current();
  if (mark == nullptr) {  // not in a routine: as ever
    for (std::size_t k = 0; k < kSignals.size(); ++k)
      if (kSignals[k] == signal) sigaction(signal, &before[k], nullptr);
    raise(signal);
    return;
  }
  constexpr int kFailedRun = 3;
  say("\nadore: user routine ");
  say(mark->hook);
  say(" of ");
  say(mark->source);
  say(" crashed in its call ");
  say(mark->number);
  say(", at t = ");
  say(static_cast<long>(mark->time * 1e9));
  say(" ns (signal ");
  say(signal);
  say("). The files are valid up to the last stored step. Repeat the run with --opt userProcess=1, "
      "which runs the plug-in in a separate process\n");
  _exit(kFailedRun);
}

}  // namespace

thread_local const CallMark* CrashGuard::current_ = nullptr;

CrashGuard::CrashGuard() {
  if (guards++ > 0) return;
  struct sigaction action {};
  action.sa_handler = on_crash;
  sigemptyset(&action.sa_mask);
  for (std::size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &action, &before[k]);
}
CrashGuard::~CrashGuard() {
  if (--guards > 0) return;
  for (std::size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &before[k], nullptr);
}

}  // namespace adore::user
