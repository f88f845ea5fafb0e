#include "agore/agore_window.hpp"
#include "agore/film_dialog.hpp"
#include "agore/render.hpp"
#include "agore/scene_page.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/mp4_writer.hpp"
#include "desktop/one_window.hpp"

#include <QBuffer>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QProgressDialog>
#include <QRegularExpression>
#include <QScopeGuard>

#include <algorithm>
#include <exception>
#include <utility>

/// Pictures and films that the window saves.
namespace adore::agore {
namespace {

/// Bytes of a film per picture, as a share of the picture's PNG: measured with 1800 pictures of
/// 1280 x 800 of the example `ball` (bearing and 3D view), between 0.02 and 0.04, 0.4 and 0.45,
/// 0.57 and 0.77.
constexpr double kMp4Share = 0.03, kGifShare = 0.45, kAviShare = 0.65;

double bytes_of_png(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return static_cast<double>(bytes.size());
}

QString megabytes(double bytes) {
  return QString::fromStdString(desktop::pretty_number(1e-6 * bytes, 2)) + " MB";
}

QString best_format() { return desktop::has_ffmpeg() ? "mp4" : "gif"; }

}  // namespace

/// A name in the folder of the displayed file, used to find its pictures.
QString AgoreWindow::pathInFileFolder(const QString& name) const {
  return desktop::folder_of(picture_->animation().file.path) + "/" + name;
}

void AgoreWindow::print() {
  if (!picture_) return askForFile();
  pause();
  desktop::print_page(this, [this](QPainter& painter, const QRectF& paper) {
    picture_->paintOnPaper(painter, paper, picture_widget_->size(), frame_, exportViewOptions());
  });
}

void AgoreWindow::savePicture() {
  if (!picture_) return askForFile();
  pause();
  desktop::save_picture(
      this, kApp, pathInFileFolder(proposedName("jpg")),
      [this] { return picture_->image(picture_widget_->size(), frame_, exportViewOptions()); },
      picture_widget_->size(),
      [this](QPainter& painter) {
        picture_->paint(painter, QRectF(picture_widget_->rect()), frame_, exportViewOptions());
      });
}

QString AgoreWindow::proposedName(const QString& suffix) const {
  QString run = QFileInfo(desktop::folder_of(picture_->animation().file.path)).fileName();
  if (run.isEmpty()) run = "bearing";
  const QString what =
      options_.beside.empty() ? QString::fromStdString(view_name(options_.view)) : QString("views");
  return run + "-" + what + (suffix.isEmpty() ? QString() : "." + suffix);
}

int AgoreWindow::movieFrameRate() const {
  constexpr int kSlowRate = 25;
  return slow_motion_rate_ > 0.0
             ? kSlowRate
             : std::max(1, playback_rate_box_->currentData().toInt() / movieFrameInterval());
}

/// Players show 50 pictures a second; a faster one shows every n-th frame, so that it lasts as long
/// as the window plays.
int AgoreWindow::movieFrameInterval() const {
  constexpr int kMostRate = 50;
  return slow_motion_rate_ > 0.0
             ? 1
             : (playback_rate_box_->currentData().toInt() + kMostRate - 1) / kMostRate;
}

MovieSettings AgoreWindow::movieSettings() const {
  const auto [first, last] = playedFrames();
  // As seen, but not larger than a film needs to be; codecs want even numbers.
  const QSize size = picture_widget_->size().boundedTo({1280, 800});
  return {
      first, last, movieFrameInterval(), movieFrameRate(), {size.width() & ~1, size.height() & ~1}};
}

RenderOptions AgoreWindow::movieRenderOptions(const MovieSettings& choice) const {
  RenderOptions render;
  render.view = exportViewOptions();
  render.width = choice.size.width();
  render.height = choice.size.height();
  render.replace = true;
  render.slow = slow_motion_rate_;  // a film plays as the window does
  render.first = static_cast<int>(choice.first) + 1;
  render.last = static_cast<int>(choice.last) + 1;
  return render;
}

namespace {

/// Measured with one picture of a size.
struct Sample {
  QSize size;
  double seconds = 0.0, bytes = 0.0;
};

}  // namespace

void AgoreWindow::saveMovie() {
  if (!picture_) return askForFile();
  pause();
  // The time for all pictures is estimated from one; writing to a file takes 30 ms
  // (picture-speed.md).
  constexpr double kInFile = 0.03;  // [s]
  const auto tell = [this, sample = Sample()](const MovieSettings& choice) mutable {
    const RenderOptions render = movieRenderOptions(choice);
    if (sample.size != choice.size) {
      QElapsedTimer clock;
      clock.start();
      const QImage image = picture_->image(choice.size, frame_, render.view);
      sample = {choice.size, 1e-9 * static_cast<double>(clock.nsecsElapsed()) + kInFile,
                bytes_of_png(image)};
    }
    try {
      const auto pictures =
          static_cast<double>(movie_frames(*picture_, choice.every, choice.rate, render).size());
      const auto seconds = [](double value) {
        return QString::fromStdString(desktop::pretty_quantity(value, "s", 2));
      };
      const double bytes = sample.bytes * pictures;
      return std::pair{
          tr("%1 at %2 per second: length %3. Writing takes about %4. Size: about %5 as MP4, %6 as "
             "GIF, %7 as AVI.")
                  .arg(QString::fromStdString(counted(pictures, "picture")))
                  .arg(choice.rate)
                  .arg(seconds(pictures / choice.rate), seconds(sample.seconds * pictures),
                       megabytes(kMp4Share * bytes), megabytes(kGifShare * bytes),
                       megabytes(kAviShare * bytes)) +
              (desktop::has_ffmpeg() ? QString()
                                     : tr(" MP4 needs the package ffmpeg, which is missing.")),
          true};
    } catch (const std::exception& error) {
      return std::pair{QString::fromUtf8(error.what()), false};
    }
  };
  auto* dialog = new MovieDialog(picture_->animation().time, movieSettings(),
                                 slow_motion_rate_ > 0.0, tell, this);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { askForMovieFile(dialog->choice()); });
  dialog->open();
}

void AgoreWindow::askForMovieFile(const MovieSettings& choice) {
  // MP4 first: a GIF has some twenty times its size.
  const QString mp4 = tr("MP4 (*.mp4)"), others = tr("GIF (*.gif);;AVI (*.avi)"),
                folder = tr("Numbered pictures, folder (*)");
  auto* dialog = new QFileDialog(
      this, tr("Save Movie"), proposedName(best_format()),
      (desktop::has_ffmpeg()
           ? QStringList{mp4, others, folder}
           : QStringList{others, tr("MP4 (needs the package ffmpeg) (*.mp4)"), folder})
          .join(";;"));
  dialog->setObjectName("film");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  // The selected file type determines the name: "film" and GIF give film.gif, not a folder.
  const auto name_as = [this, dialog](const QString& filter) {
    const QString suffix = QRegularExpression("\\*\\.(\\w+)").match(filter).captured(1);
    const QString base =
        QFileInfo(dialog->selectedFiles().value(0, proposedName({}))).completeBaseName();
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(suffix.isEmpty() ? base : base + "." + suffix);
  };
  dialog->selectFile(pathInFileFolder(proposedName(best_format())));
  name_as(dialog->selectedNameFilter());
  connect(dialog, &QFileDialog::filterSelected, this, name_as);
  connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, choice](const QString& name) {
    dialog->hide();  // writing takes its time
    writeMovie(name, choice);
  });
  dialog->open();
}

void AgoreWindow::saveScene() {
  if (!picture_) return askForFile();
  pause();
  const Animation& animation = picture_->animation();
  if (const std::string reason = why_not(View::Solid, animation); !reason.empty())
    return desktop::show_message(this, QString::fromStdString(reason));
  if (!is_threejs_installed())
    return desktop::show_message(this,
                                 tr("A page with the 3D scene needs three.js. Install the package "
                                    "libjs-three."),
                                 true);
  auto* dialog = new QFileDialog(this, tr("Save 3D Scene for Browsers"), {}, tr("HTML (*.html)"));
  dialog->setObjectName("scene");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("html");
  const ScenePageSize size = scene_page_size(animation, sceneOptions());
  dialog->setLabelText(QFileDialog::FileName,
                       tr("File (%1, about %2):")
                           .arg(QString::fromStdString(counted(size.frames, "frame")))
                           .arg(megabytes(size.bytes)));
  dialog->selectFile(pathInFileFolder(proposedName("html")));
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& name) { writeScene(name); });
  dialog->open();
}

ScenePageOptions AgoreWindow::sceneOptions() const {
  ScenePageOptions out;
  out.view = exportViewOptions();
  const auto [first, last] = playedFrames();
  out.first = static_cast<int>(first) + 1, out.last = static_cast<int>(last) + 1;
  return out;
}

bool AgoreWindow::writeScene(const QString& path) {
  try {
    const ScenePage page =
        write_scene_page(picture_->animation(), sceneOptions(), path.toStdString(), true);
    desktop::show_in_status_bar(
        this, tr("Saved %1: %2.").arg(path, QString::fromStdString(page.summary())));
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

bool AgoreWindow::writeMovie(const QString& path, int first, int last) {
  MovieSettings choice = movieSettings();
  choice.first = static_cast<std::size_t>(first - 1);
  choice.last = last > 0 ? static_cast<std::size_t>(last - 1) : frameCount() - 1;
  // Numbered pictures have no rate.
  if (QFileInfo(path).suffix().isEmpty()) choice.every = 1;
  return writeMovie(path, choice);
}

bool AgoreWindow::writeMovie(const QString& path, const MovieSettings& choice) {
  writing_movie_ = true;  // the picture stays unchanged until the movie is written
  const auto written = qScopeGuard([this] { writing_movie_ = false; });
  RenderOptions render = movieRenderOptions(choice);
  QProgressDialog progress(tr("Writing %1 ...").arg(path), tr("Cancel"), 0,
                           static_cast<int>(frameCount()), this);
  progress.setWindowTitle(tr("Save Movie"));
  progress.setWindowModality(Qt::WindowModal);
  progress.setMinimumDuration(500);
  long pictures = 0;
  render.progress = [&progress, &pictures](long done, long total) {
    pictures = done;
    progress.setMaximum(static_cast<int>(total));
    progress.setValue(static_cast<int>(done));
  };
  bool stopped = false;
  render.stop = [&progress, &stopped] { return stopped = progress.wasCanceled(); };
  try {
    const int every = choice.every;
    render_movie(*picture_, every, choice.rate, path.toStdString(), render);
    const bool folder = QFileInfo(path).isDir();
    if (stopped)
      desktop::show_in_status_bar(
          this,
          folder ? tr("Stopped. %1 in %2.")
                       .arg(QString::fromStdString(counted(pictures, "picture is", "pictures are")))
                       .arg(path)
                 : tr("Stopped: no movie was saved."));
    else
      desktop::show_in_status_bar(
          this, folder
                    ? tr("Saved %1 in %2.")
                          .arg(QString::fromStdString(counted(pictures, "numbered picture")))
                          .arg(path)
                    : tr("Saved %1: %2%3.")
                          .arg(path)
                          .arg(QString::fromStdString(counted(pictures, "picture")))
                          .arg(every > 1 ? tr(", one of every %1 frames").arg(every) : QString()));
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

}  // namespace adore::agore
