#pragma once

#include <filesystem>

/// How a program ends that is asked to (Ctrl+C, SIGTERM, a closed terminal) where nothing is worth
/// keeping: alike everywhere.
namespace adore {

inline constexpr int kInterruptedCode = 130;

/// From now on SIGINT, SIGTERM and SIGHUP end the program with the word "interrupted" and exit code
/// 130, and files that are unfinished are removed. Signals that were ignored when the program
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

/// While it lives, the file is worth nothing: an interrupt removes it.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::filesystem::path& path);
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile();

 private:
  int place_ = -1;
};

}  // namespace adore
