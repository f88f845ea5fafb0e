#pragma once

#include <atomic>

/// Reports which user routine was running when the process crashes: machine code of a plug-in
/// has no other protection here (a separate process gives one).
namespace adore::user {

/// The call under way, for the signal handler.
struct CallMark {
  const char* hook = nullptr;    ///< "ADRX7"
  const char* source = nullptr;  ///< the plug-in
  long number = 0;               ///< of the call
  double time = 0.0;             ///< [s]
};

/// While one lives, a crash inside of a marked call is reported on the standard error stream, and
/// ends the process with the code of a failed run (3). One at a time.
class CrashGuard {
 public:
  CrashGuard();
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;
  static void enter(const CallMark& mark) noexcept { current_ = &mark; }
  static void leave() noexcept { current_ = nullptr; }
  [[nodiscard]] static const CallMark* current() noexcept { return current_; }

 private:
  static thread_local const CallMark* current_;
};

}  // namespace adore::user
