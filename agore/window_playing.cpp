#include "agore/agore_window.hpp"
#include "desktop/run_link.hpp"

#include <QAction>
#include <QComboBox>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

/// Time control of the window.
namespace adore::agore {

void AgoreWindow::setSlowMotion(double rate) {
  slow_motion_rate_ = rate;
  playback_rate_box_->setEnabled(rate == 0.0);
  if (picture_) slow_motion_time_ = picture_->animation().time[frame_];
}

void AgoreWindow::playForward() { play(1); }
void AgoreWindow::playBackward() { play(-1); }

std::pair<std::size_t, std::size_t> AgoreWindow::playedFrames() const {
  const std::size_t first = options_.span_from ? picture_->frameAt(*options_.span_from) : 0,
                    last =
                        options_.span_to ? picture_->frameAt(*options_.span_to) : frameCount() - 1;
  return {std::min(first, last), std::max(first, last)};
}

void AgoreWindow::setRepeatRange(std::optional<double> from, std::optional<double> to) {
  if (from && to && *from > *to) std::swap(from, to);
  options_.span_from = from, options_.span_to = to;
  if (picture_ && (from || to)) repeat_action_->setChecked(true);
  showFrame();
}

/// Start or end of the repeated range. The other end is removed if it would be passed.
void AgoreWindow::setRepeatLimit(bool first) {
  if (!picture_) return askForFile();
  const double now = picture_->animation().time[frame_];
  std::optional<double> from = options_.span_from, to = options_.span_to;
  (first ? from : to) = now;
  if (from && to && !(*from < *to)) (first ? to : from) = std::nullopt;
  setRepeatRange(from, to);
}

void AgoreWindow::play(int direction) {
  if (!picture_) return askForFile();
  direction_ = direction;
  // At the end, and outside the marked range, playing starts over.
  const auto [first, last] = playedFrames();
  const bool within = frame_ >= first && frame_ <= last;
  if (direction > 0 && (!within || frame_ == last)) setFrame(first);
  if (direction < 0 && (!within || frame_ == first)) setFrame(last);
  pending_frames_ = 0.0;
  slow_motion_time_ = picture_->animation().time[frame_];
  link_->tell({slow_motion_time_, {}});
  clock_.start();
  timer_.start();
}

void AgoreWindow::advance() {
  const double seconds = static_cast<double>(clock_.restart()) * 1e-3;
  const auto [first, last] = playedFrames();
  // The user moved outside the range while playing: it plays to the end of the run.
  const bool beyond = direction_ > 0 ? frame_ > last : frame_ < first;
  const bool around = loop_ && !beyond && last > first;
  const std::size_t end = beyond           ? (direction_ > 0 ? frameCount() - 1 : 0)
                          : direction_ > 0 ? last
                                           : first;
  if (slow_motion_rate_ > 0.0) {
    // In simulated time, also for unequal intervals between frames.
    const auto& time = picture_->animation().time;
    slow_motion_time_ += direction_ * slow_motion_rate_ * seconds;
    bool over = direction_ > 0 ? slow_motion_time_ >= time[end] : slow_motion_time_ <= time[end];
    if (over && around) {
      const double span = time[last] - time[first];
      slow_motion_time_ -= span * std::floor((slow_motion_time_ - time[first]) / span);
      over = false;
    }
    const auto after = std::upper_bound(time.begin(), time.end(), slow_motion_time_);
    setFrame(over
                 ? end
                 : static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - time.begin() - 1)));
  } else {
    pending_frames_ += seconds * playback_rate_box_->currentData().toDouble();
    const auto due = static_cast<std::size_t>(pending_frames_);
    if (due == 0) return;
    pending_frames_ -= static_cast<double>(due);
    const std::size_t left = direction_ > 0 ? end - frame_ : frame_ - end;
    if (due > left && around) {
      const std::size_t past = (due - left - 1) % (last - first + 1);
      setFrame(direction_ > 0 ? first + past : last - past);
    } else {
      const std::size_t moved = std::min(due, left);
      setFrame(direction_ > 0 ? frame_ + moved : frame_ - moved);
    }
  }
  if (frame_ == end && !around) pause();
}

void AgoreWindow::frameForward() {
  pause();
  if (picture_ && frame_ + 1 < frameCount()) setFrame(frame_ + 1);
}

void AgoreWindow::frameBackward() {
  pause();
  if (frame_ > 0) setFrame(frame_ - 1);
}

void AgoreWindow::pause() {
  const bool was = playing();
  timer_.stop();
  if (was) showFrame();  // the finer picture
}

}  // namespace adore::agore
