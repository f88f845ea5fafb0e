#pragma once

#include "results/results_h5.hpp"
#include "results/sol_file.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The motion of a run in RESULTS.h5: the content of SOL8 with all digits, at every stored
/// step, also for bearings that SOL8 does not support (segments, more than 88 elements), and with
/// all other channels.
namespace adore::results {

/// Values of one channel at the frames of a motion, in the motion's units (angles in rad).
struct MotionChannel {
  std::string unit;
  std::size_t width = 0;  ///< values per frame
  std::vector<double> values;
  [[nodiscard]] double at(std::size_t frame, std::size_t place) const {
    return values[frame * width + place];
  }
};

class MotionFile {
 public:
  /// Frames that are held at a time; of longer runs every second, third ... stored step is one.
  static constexpr std::size_t kMostFrames = 20'000;

  /// @throws InputError when RESULTS.h5 cannot be read or lacks the motion of the bodies
  static MotionFile open(const std::filesystem::path& h5, UnitSystem units = UnitSystem::SI,
                         std::size_t most_frames = kMostFrames);
  /// From RESULTS.h5 in the folder of a SOL8 file, in its units. Nothing, with the reason in
  /// `why_not`, when there is none, or when it is not of the same run: another run code, or times
  /// and orbit radii that SOL8's digits contradict.
  static std::optional<MotionFile> of_sol8(const Sol8File& file, std::string& why_not,
                                           std::size_t most_frames = kMostFrames);

  /// As SOL8 would hold it. With segments the cage of a frame is the first of them, and
  /// `segment_frames` has them all.
  [[nodiscard]] const Sol8File& frames() const noexcept { return file_; }
  [[nodiscard]] const std::vector<std::vector<Sol8Body>>& segment_frames() const noexcept {
    return segments_;
  }
  [[nodiscard]] std::size_t stored_steps() const noexcept { return reader_->steps(); }
  [[nodiscard]] std::size_t every() const noexcept {
    return steps_per_frame_;
  }  ///< stored steps per frame
  /// Sizes of the bearing in SI, as /geometry names them.
  [[nodiscard]] const std::map<std::string, double>& geometry() const noexcept {
    return reader_->geometry();
  }
  [[nodiscard]] bool has(std::string_view id) const noexcept {
    return reader_->find(id) != nullptr;
  }
  /// Guide surfaces of a pocket; 0 without a cage.
  [[nodiscard]] std::size_t pocket_surfaces() const;
  /// At the frames; nullptr when the run has no such channel. Read once, then kept.
  [[nodiscard]] const MotionChannel* channel(const std::string& id) const;

  /// One value of a channel, or "shaft_rotation" [rad], at every stored step, frames or not; empty
  /// when there is none.
  [[nodiscard]] std::vector<double> series(const std::string& id, std::size_t place,
                                           std::string* unit = nullptr) const;
  [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }  ///< all [s]

 private:
  explicit MotionFile(H5Reader reader);
  void read_frames(std::size_t most_frames);

  std::unique_ptr<H5Reader> reader_;
  UnitSystem units_ = UnitSystem::SI;
  std::size_t steps_per_frame_ = 1;
  std::vector<double> times_;
  Sol8File file_;
  std::vector<std::vector<Sol8Body>> segments_;
  mutable std::map<std::string, MotionChannel> channel_cache_;
};

}  // namespace adore::results
