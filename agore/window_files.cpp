#include "agore/agore_window.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"

#include <algorithm>
#include <exception>
#include <utility>

/// What the window shows: opening, reading again.
namespace adore::agore {

bool AgoreWindow::openFile(const std::filesystem::path& path, long most_frames) {
  try {
    setAnimation(open_motion(path, most_frames));
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  most_frames_ = most_frames;
  desktop::remember_file(kApp, QString::fromStdString(path.string()));
  const std::string &note = picture_->animation().file.note,
                    &gaps = picture_->animation().file.gaps;
  if (note.empty() && !gaps.empty())
    desktop::show_message(this, tr("Of the file %1.").arg(QString::fromStdString(gaps)));
  if (!note.empty())
    desktop::show_message(this, tr("The file is incomplete: %1. Its %2 complete frames are shown.")
                                    .arg(QString::fromStdString(note))
                                    .arg(frameCount()));
  return true;
}

void AgoreWindow::reload() {
  if (!picture_) return askForFile();
  const double moment = picture_->animation().time[frame_];
  const std::filesystem::path path = picture_->animation().file.path;  // the picture goes with it
  if (!openFile(path, most_frames_)) return;
  setFrame(picture_->frameAt(moment));
  desktop::tell_in_foot(this, tr("Read again: %1 frames to %2.")
                                  .arg(frameCount())
                                  .arg(QString::fromStdString(desktop::pretty_quantity(
                                      picture_->animation().time.back(), "s", 5))));
}

void AgoreWindow::setAnimation(Animation animation) {
  pause();
  auto fresh = std::make_unique<MotionPicture>(std::move(animation));
  if (options_.element > fresh->animation().file.elements) options_.element = 1;
  if (!why_not(options_.view, fresh->animation()).empty()) options_.view = View::Bearing;
  std::erase_if(options_.beside, [&fresh](const SideView& side) {
    return !why_not(side.view, fresh->animation()).empty();
  });
  // The canvas lets go of the old one before it dies.
  const auto old = std::exchange(picture_, std::move(fresh));
  frame_ = 0;
  refresh();
}

/// The number first, as the classic tool has it. Nobody who only wants to see a run loses steps by
/// it: all that can be held is what is offered, whatever was asked for before.
void AgoreWindow::askForFile() {
  desktop::ask_number(
      this, tr("Open: steps, then the file"),
      tr("Most time steps to animate. Of a run with more, every 2nd, 3rd ... is shown.\n"
         "The file is chosen next."),
      static_cast<int>(results::MotionFile::kMostFrames), 1, 100'000'000, [this](int steps) {
        desktop::ask_file(
            this, kApp, tr("Open animation file"), "SOL8* RESULTS.h5",
            [this, steps](const QString& name) { openFile(name.toStdString(), steps); });
      });
}

}  // namespace adore::agore
