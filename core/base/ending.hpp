#pragma once

/// How a program ends that is asked to (Ctrl+C, SIGTERM, a closed terminal) where nothing is worth
/// keeping: alike everywhere.
namespace adore {

inline constexpr int kInterruptedCode = 130;

/// From now on SIGINT, SIGTERM and SIGHUP end the program with the word "interrupted" and exit code
/// 130,. Signals that were ignored when the program
/// started (nohup) stay so. Who can keep what there is listens for himself.
void end_when_interrupted();

/// While it lives, such signals wait; also over the start of another program in the place of this
/// one, until that calls end_when_interrupted().
class InterruptsWait {
 public:
  InterruptsWait();
  InterruptsWait(const InterruptsWait&) = delete;
  InterruptsWait& operator=(const InterruptsWait&) = delete;
  ~InterruptsWait();
};

}  // namespace adore
