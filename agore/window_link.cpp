#include "agore/agore_window.hpp"
#include "desktop/run_link.hpp"

#include <QScopedValueRollback>

#include <filesystem>

/// Time of the frame and selected element, shared with other windows of the run.
namespace adore::agore {

void AgoreWindow::makeLink() {
  link_ = new desktop::RunLink(this);
  connect(link_, &desktop::RunLink::told, this, &AgoreWindow::applyLinkState);
}

/// A file of the same run begins at the shared time.
void AgoreWindow::joinLink() {
  std::error_code none;  // an animation in memory has no file
  const std::filesystem::path file =
      std::filesystem::canonical(picture_->animation().file.path, none);
  link_->join(none ? QString() : QString::fromStdString(file.parent_path().string()));
  last_link_state_ = currentLinkState();
  applyLinkState(link_->state());
}

desktop::LinkState AgoreWindow::currentLinkState() const {
  return {picture_->animation().time[frame_], options_.element};
}

void AgoreWindow::sendLinkState(bool by_user) {
  if (!picture_ || taking_) return;
  const desktop::LinkState now = currentLinkState();
  desktop::LinkState change;
  if (now.time != last_link_state_.time) change.time = now.time;
  if (now.element != last_link_state_.element) change.element = now.element;
  last_link_state_ = now;
  using Cause = desktop::RunLink::Cause;
  link_->tell(change, by_user ? Cause::User : Cause::Playing);
}

/// Another window has moved: this one stops playing.
void AgoreWindow::applyLinkState(const desktop::LinkState& change) {
  if (!picture_ || writing_movie_ || change.empty()) return;
  const QScopedValueRollback quiet(taking_, true);
  if (change.time) {
    pause();
    frame_ = picture_->frameAt(*change.time);
  }
  if (change.element && *change.element <= picture_->animation().file.elements)
    options_.element = *change.element;
  refresh();
  last_link_state_ = currentLinkState();
}

}  // namespace adore::agore
