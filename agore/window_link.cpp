#include "agore/agore_window.hpp"
#include "desktop/run_link.hpp"

#include <QScopedValueRollback>

#include <filesystem>

/// Time of the frame and selected element, shared with other windows of the run.
namespace adore::agore {

void AgoreWindow::makeLink() {
  link_ = new desktop::RunLink(this);
  connect(link_, &desktop::RunLink::told, this, &AgoreWindow::takeLinked);
}

/// A file of the same run begins at the shared time.
void AgoreWindow::joinLink() {
  std::error_code none;  // an animation in memory has no file
  const std::filesystem::path file =
      std::filesystem::canonical(picture_->animation().file.path, none);
  link_->join(none ? QString() : QString::fromStdString(file.parent_path().string()));
  linked_ = linkedNow();
  takeLinked(link_->state());
}

desktop::LinkState AgoreWindow::linkedNow() const {
  return {picture_->animation().time[frame_], options_.element};
}

void AgoreWindow::tellLinked(bool by_user) {
  if (!picture_ || taking_) return;
  const desktop::LinkState now = linkedNow();
  desktop::LinkState change;
  if (now.time != linked_.time) change.time = now.time;
  if (now.element != linked_.element) change.element = now.element;
  linked_ = now;
  using Cause = desktop::RunLink::Cause;
  link_->tell(change, by_user ? Cause::User : Cause::Playing);
}

/// Another window has moved: this one stops playing.
void AgoreWindow::takeLinked(const desktop::LinkState& change) {
  if (!picture_ || writing_ || change.empty()) return;
  const QScopedValueRollback quiet(taking_, true);
  if (change.time) {
    pause();
    frame_ = picture_->frameAt(*change.time);
  }
  if (change.element && *change.element <= picture_->animation().file.elements)
    options_.element = *change.element;
  refresh();
  linked_ = linkedNow();
}

}  // namespace adore::agore
