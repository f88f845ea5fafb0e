#pragma once

/// End of a program on Ctrl+C, SIGTERM or a closed terminal, when there are no partial results to
/// keep: the same for all programs.
namespace adore {

inline constexpr int kInterruptedCode = 130;

/// From now on SIGINT, SIGTERM and SIGHUP end the program with the word "interrupted" and exit code
/// 130,. Signals that were ignored when the program
/// started (nohup) stay ignored. Programs that can save partial results install their own handler.
void exit_on_interrupt();

/// While it lives, such signals wait; also over the start of another program in the place of this
/// one, until that calls exit_on_interrupt().
class InterruptBlocker {
 public:
  InterruptBlocker();
  InterruptBlocker(const InterruptBlocker&) = delete;
  InterruptBlocker& operator=(const InterruptBlocker&) = delete;
  ~InterruptBlocker();
};

}  // namespace adore
