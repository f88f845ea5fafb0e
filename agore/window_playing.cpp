#include "agore/agore_window.hpp"

#include <QComboBox>

#include <algorithm>

/// The window's way through time.
namespace adore::agore {

void AgoreWindow::setSlowMotion(double rate) {
  slow_ = rate;
  speed_->setEnabled(rate == 0.0);
  if (picture_) film_time_ = picture_->animation().time[frame_];
}

void AgoreWindow::playForward() { play(1); }
void AgoreWindow::playBackward() { play(-1); }

void AgoreWindow::play(int direction) {
  if (!picture_) return askForFile();
  direction_ = direction;
  // Play at the end starts over.
  if (direction > 0 && frame_ + 1 == frameCount()) setFrame(0);
  if (direction < 0 && frame_ == 0) setFrame(frameCount() - 1);
  pending_ = 0.0;
  film_time_ = picture_->animation().time[frame_];
  clock_.start();
  timer_.start();
}

void AgoreWindow::advance() {
  const double seconds = static_cast<double>(clock_.restart()) * 1e-3;
  const std::size_t last = frameCount() - 1, end = direction_ > 0 ? last : 0;
  if (slow_ > 0.0) {
    // In the simulation's own time, however unequal the frames lie in it.
    const auto& time = picture_->animation().time;
    film_time_ += direction_ * slow_ * seconds;
    const bool over = direction_ > 0 ? film_time_ >= time.back() : film_time_ <= time.front();
    const auto after = std::upper_bound(time.begin(), time.end(), film_time_);
    setFrame(over
                 ? end
                 : static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - time.begin() - 1)));
  } else {
    pending_ += seconds * speed_->currentData().toDouble();
    const auto due = static_cast<std::size_t>(pending_);
    if (due == 0) return;
    pending_ -= static_cast<double>(due);
    const std::size_t left = direction_ > 0 ? last - frame_ : frame_;
    const std::size_t moved = std::min(due, left);
    setFrame(direction_ > 0 ? frame_ + moved : frame_ - moved);
  }
  if (frame_ != end) return;
  if (loop_ && last > 0)
    play(direction_);
  else
    pause();
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
