#include "agore/agore_window.hpp"
#include "agore/element_panel.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/project.hpp"
#include "desktop/project_words.hpp"
#include "results/run_findings.hpp"
#include "results/run_folder.hpp"

#include <QAction>
#include <QElapsedTimer>
#include <QMenu>
#include <QScopedValueRollback>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

/// Opening, reloading, following a running solver.
namespace adore::agore {
namespace {

constexpr int kLook = 1000;  // [ms] between looks at the files of a running solver

/// Sizes and times of change of the files that the picture of one of them rests on.
std::string state_of(const std::filesystem::path& path) {
  std::string out;
  for (const auto& file : {path, path.parent_path() / "RESULTS.h5"}) {
    std::error_code none;
    const auto size = std::filesystem::file_size(file, none);
    if (none) continue;
    const auto time = std::filesystem::last_write_time(file, none).time_since_epoch().count();
    out += fmt::format("{} {} {};", file.string(), size, time);
  }
  return out;
}

}  // namespace

bool AgoreWindow::openFile(const std::filesystem::path& named, long most_frames) {
  if (desktop::opens_as_project(named)) return openProject(named);
  std::filesystem::path path;
  try {
    path = results::animation_file(named);
    setAnimation(open_motion(path, most_frames));
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  max_frames_ = most_frames;
  desktop::remember_file(kApp, QString::fromStdString(path.string()));
  const std::string &note = picture_->animation().file.note,
                    &gaps = picture_->animation().file.gaps;
  QStringList told;
  if (!note.empty())
    told << tr("Incomplete file: %1. The animation has %2.")
                .arg(QString::fromStdString(note))
                .arg(QString::fromStdString(counted(frameCount(), "complete frame")));
  else if (!gaps.empty())
    told << tr("File: %1.").arg(QString::fromStdString(gaps));
  if (const std::string& why = picture_->animation().unused; !why.empty())
    told << tr("RESULTS.h5 is not used: %1.").arg(QString::fromStdString(why));
  if (!told.isEmpty()) desktop::show_message(this, told.join(' '));
  return true;
}

bool AgoreWindow::openProject(const std::filesystem::path& path) {
  const auto list = [this](const desktop::Project& project) {
    auto* menu = findChild<QMenu*>("projectMenu");
    menu->clear();
    for (const desktop::Project::Entry& run : project.runs())
      menu->addAction(desktop::run_label(run), this,
                      [this, folder = run.path] { openFile(folder); })
          ->setEnabled(!run.missing);
    menu->setEnabled(!menu->isEmpty());
  };
  return desktop::open_project(this, kApp, path, list,
                               [this](const std::filesystem::path& run) { openFile(run); });
}

void AgoreWindow::askForProject() {
  desktop::ask_file(this, kApp, tr("Open project"), desktop::kProjectFile,
                    [this](const QString& name) { openProject(name.toStdString()); });
}

void AgoreWindow::reload() {
  if (!picture_) return askForFile();
  const double moment = picture_->animation().time[frame_];
  const std::filesystem::path path = picture_->animation().file.path;  // the picture is closed, too
  const auto from = options_.span_from, to = options_.span_to;
  if (!openFile(path, max_frames_)) return;
  options_.span_from = from, options_.span_to = to;
  setFrame(picture_->frameAt(moment));
  desktop::show_in_status_bar(this, tr("Reloaded: %1 to %2.")
                                        .arg(QString::fromStdString(counted(frameCount(), "frame")))
                                        .arg(QString::fromStdString(desktop::pretty_quantity(
                                            picture_->animation().time.back(), "s", 5))));
}

void AgoreWindow::setAnimation(Animation animation) {
  pause();
  options_.span_from = options_.span_to = std::nullopt;
  {
    const QScopedValueRollback quiet(taking_, true);  // opened, not moved
    replaceAnimation(std::move(animation));
    frame_ = 0;
    refresh();
  }
  joinLink();
}

void AgoreWindow::replaceAnimation(Animation animation) {
  auto fresh = std::make_unique<MotionPicture>(std::move(animation));
  if (options_.element > fresh->animation().file.elements) options_.element = 1;
  if (!why_not(options_.view, fresh->animation()).empty()) options_.view = View::Bearing;
  std::erase_if(options_.beside, [&fresh](const AdditionalView& side) {
    return !why_not(side.view, fresh->animation()).empty();
  });
  seen_ = state_of(fresh->animation().file.path);
  const auto old = std::exchange(picture_, std::move(fresh));
  frame_ = std::min(frame_, frameCount() - 1);
  findings_->setFindings(results::run_findings(picture_->animation().file.path));
  options_.warned = warned_bodies(findings_->findings());
  panel_->open(picture_->animation());
  rejected_reload_count_ = 0;
  showFrame();  // the canvas lets go of the old one before it dies
}

bool AgoreWindow::canShow(const Animation& animation) const {
  for (std::size_t i = 0; i <= options_.beside.size(); ++i)
    if (!why_not(options_.tile(i).view, animation).empty()) return false;
  return options_.element <= animation.file.elements;
}

void AgoreWindow::follow(bool on) {
  if (follow_action_->isChecked() != on)
    return follow_action_->setChecked(on);  // which comes here again
  file_check_timer_.setInterval(kLook);
  on ? file_check_timer_.start() : file_check_timer_.stop();
  refresh();
}

/// A file that is being written contains complete steps and possibly an incomplete one, which
/// readers skip. Files that cannot be read now, or cannot replace the displayed ones (RESULTS.h5 is
/// still too short for the view), are checked again later.
void AgoreWindow::checkForFileChanges() {
  if (!picture_ || writing_movie_) return;
  const std::filesystem::path path = picture_->animation().file.path;
  const std::string now = state_of(path);
  if (now == seen_) return;
  QElapsedTimer clock;
  clock.start();
  std::optional<Animation> fresh;
  try {
    fresh = open_motion(path, max_frames_);
  } catch (const std::exception& error) {
    desktop::show_in_status_bar(this,
                                tr("The file cannot be read at the moment: %1").arg(error.what()));
    return;
  }
  constexpr int kPatience = 10;
  if (!canShow(*fresh) && ++rejected_reload_count_ < kPatience) return;
  const bool at_end = frame_ + 1 == frameCount() && !playing();
  const double moment = picture_->animation().time[frame_];
  {
    const QScopedValueRollback quiet(taking_, true);
    replaceAnimation(std::move(*fresh));
    seen_ = now;  // steps that arrive while reading are found at the next check
    frame_ = at_end ? frameCount() - 1 : picture_->frameAt(moment);
    refresh();
  }
  sendLinkState(false);
  // Reading a long file takes processor time, which the solver needs.
  constexpr int kShare = 8;
  file_check_timer_.setInterval(std::max(kLook, kShare * static_cast<int>(clock.elapsed())));
}

/// The number first, as in the classic tool. The default is the largest possible number, whatever
/// was entered before, so that no steps are lost by accident.
void AgoreWindow::askForFile() {
  desktop::ask_number(
      this, tr("Open animation"),
      tr("Maximum number of frames. Runs with more steps show every 2nd, 3rd ... stored step.\nYou "
         "select the file in the next dialog."),
      static_cast<int>(results::MotionFile::kMostFrames), 1, 100'000'000, [this](int steps) {
        desktop::ask_file(
            this, kApp, tr("Open animation file"), "SOL8* RESULTS.h5 PROJECT.json",
            [this, steps](const QString& name) { openFile(name.toStdString(), steps); });
      });
}

}  // namespace adore::agore
