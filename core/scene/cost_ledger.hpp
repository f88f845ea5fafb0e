#pragma once

#include <array>
#include <chrono>
#include <string>
#include <string_view>
#include <vector>

/// Distribution of the processor time of a run. Timers inside the right-hand side are sampled
/// (every n-th call is measured in full) so that the ledger costs below 2 % and still adds up to
/// the run's time. Inside a call the wall clock is used, which is fast; a call during which the
/// thread did not have the processor all the time is left out.
namespace adore::scene {

/// Processor time of this thread [s]: what other programs do meanwhile does not count.
[[nodiscard]] double processor_seconds() noexcept;

class CostLedger {
 public:
  using Clock = std::chrono::steady_clock;
  /// Registers an entry and returns its handle.
  int add_entry(std::string name);
  /// Handle of the entry of that name, registered at its first mention.
  int entry(std::string_view name);
  /// Called at the start of each right-hand side; true when this call is to be measured: between
  /// begin_sample() and end_sample().
  bool sample() noexcept { return (calls_++ % kSampleEvery) == 0; }
  void begin_sample() noexcept;
  /// Adds measured time of the sampled call (scaled up by calls / sampled calls on report; an entry
  /// may be added to several times per call). What one reading of the clock costs (measured once)
  /// is taken off, so that short entries are not overestimated.
  void add_sampled(int entry, Clock::duration duration) noexcept;
  /// Books what was added since begin_sample(), unless the thread lost the processor in between.
  void end_sample() noexcept;
  /// Adds time that was measured in full (output, stepper ...) [s].
  void add(int entry, double seconds) noexcept;
  struct Row {
    std::string name;
    long calls = 0;
    double seconds = 0.0;
  };
  /// One row per entry, in the order of add_entry. Sampled entries count every right-hand side as a
  /// call.
  [[nodiscard]] std::vector<Row> rows() const;
  [[nodiscard]] long calls() const noexcept { return calls_; }
  static constexpr int kSampleEvery = 64;

 private:
  struct Entry {
    std::string name;
    long calls = 0;
    double full = 0.0;  ///< [s]
    Clock::duration sampled{}, pending{};
    bool is_sampled = false;
  };
  std::vector<Entry> entries_;
  long calls_ = 0, kept_ = 0;  ///< right-hand sides; sampled ones that were booked
  Clock::time_point sample_start_time_;
  double sample_start_processor_seconds_ = 0.0;  ///< [s]
};

}  // namespace adore::scene
