#include "base/ending.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <poll.h>
#include <string>
#include <unistd.h>

namespace adore {
namespace {

/// What a signal handler may read: no memory that is asked for or given back meanwhile.
struct Place {
  std::atomic<bool> taken{false}, named{false};
  std::array<char, 4096> name{};
};
constexpr int kPlaces = 8;  // films at a time: one
std::array<Place, kPlaces> places;
static_assert(std::atomic<bool>::is_always_lock_free);

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
  // A process that was forked from here, with this handler, has nothing to say or to remove.
  if (getpid() != listener) _exit(kInterruptedCode);
  for (const Place& place : places)
    if (place.named) ::unlink(place.name.data());
  // Not where it would wait for the reader of a full pipe.
  constexpr char kWord[] = "\ninterrupted\n";
  pollfd error{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&error, 1, 0) == 1 && (error.revents & POLLOUT) != 0)
    (void)!::write(STDERR_FILENO, kWord, sizeof kWord - 1);
  _exit(kInterruptedCode);
}

}  // namespace

void end_when_interrupted() {
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

InterruptsWait::InterruptsWait() { hold(SIG_BLOCK); }
InterruptsWait::~InterruptsWait() { hold(SIG_UNBLOCK); }

UnfinishedFile::UnfinishedFile(const std::filesystem::path& path) {
  const std::string name = std::filesystem::absolute(path).string();
  for (int i = 0; i < kPlaces; ++i) {
    Place& place = places[static_cast<std::size_t>(i)];
    if (name.size() >= place.name.size() || place.taken.exchange(true)) continue;
    std::memcpy(place.name.data(), name.c_str(), name.size() + 1);
    place.named = true;
    place_ = i;
    return;
  }
}

UnfinishedFile::~UnfinishedFile() {
  if (place_ < 0) return;
  Place& place = places[static_cast<std::size_t>(place_)];
  place.named = false;
  place.taken = false;
}

}  // namespace adore
