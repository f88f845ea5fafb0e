#include "agore/agore_window.hpp"
#include "agore/film_dialog.hpp"
#include "agore/render.hpp"
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

QString best_format() { return desktop::ffmpeg_found() ? "mp4" : "gif"; }

}  // namespace

/// A name in the folder of the displayed file, used to find its pictures.
QString AgoreWindow::besideFile(const QString& name) const {
  return desktop::folder_of(picture_->animation().file.path) + "/" + name;
}

void AgoreWindow::print() {
  if (!picture_) return askForFile();
  pause();
  desktop::print_page(this, [this](QPainter& painter, const QRectF& paper) {
    picture_->paintOnPaper(painter, paper, canvas_->size(), frame_, stillOptions());
  });
}

void AgoreWindow::savePicture() {
  if (!picture_) return askForFile();
  pause();
  desktop::save_picture(
      this, kApp, besideFile(proposedName("jpg")),
      [this] { return picture_->image(canvas_->size(), frame_, stillOptions()); }, canvas_->size(),
      [this](QPainter& painter) {
        picture_->paint(painter, QRectF(canvas_->rect()), frame_, stillOptions());
      });
}

QString AgoreWindow::proposedName(const QString& suffix) const {
  QString run = QFileInfo(desktop::folder_of(picture_->animation().file.path)).fileName();
  if (run.isEmpty()) run = "bearing";
  const QString what =
      options_.beside.empty() ? QString::fromStdString(view_name(options_.view)) : QString("views");
  return run + "-" + what + (suffix.isEmpty() ? QString() : "." + suffix);
}

int AgoreWindow::filmRate() const {
  constexpr int kSlowRate = 25;
  return slow_ > 0.0 ? kSlowRate : std::max(1, speed_->currentData().toInt() / filmEvery());
}

/// Players show 50 pictures a second; a faster one shows every n-th frame, so that it lasts as long
/// as the window plays.
int AgoreWindow::filmEvery() const {
  constexpr int kMostRate = 50;
  return slow_ > 0.0 ? 1 : (speed_->currentData().toInt() + kMostRate - 1) / kMostRate;
}

RenderOptions AgoreWindow::filmOptions() const {
  RenderOptions render;
  render.view = stillOptions();
  // As seen, but not larger than a film needs to be.
  const QSize size = canvas_->size().boundedTo({1280, 800});
  render.width = size.width() & ~1;
  render.height = size.height() & ~1;
  render.replace = true;
  render.slow = slow_;  // a film plays as the window does
  return render;
}

void AgoreWindow::saveFilm() {
  if (!picture_) return askForFile();
  pause();
  // The time for all pictures is estimated from one; writing to a file takes 30 ms
  // (picture-speed.md).
  constexpr double kInFile = 0.03;  // [s]
  const RenderOptions render = filmOptions();
  QElapsedTimer clock;
  clock.start();
  const QImage sample = picture_->image({render.width, render.height}, frame_, render.view);
  const double each = 1e-9 * static_cast<double>(clock.nsecsElapsed()) + kInFile;
  const double bytes = bytes_of_png(sample);
  const auto tell = [this, render, each, bytes](std::size_t first, std::size_t last) {
    RenderOptions part = render;
    part.first = static_cast<int>(first) + 1, part.last = static_cast<int>(last) + 1;
    try {
      const auto pictures =
          static_cast<double>(film_frames(*picture_, filmEvery(), filmRate(), part).size());
      const auto seconds = [](double value) {
        return QString::fromStdString(desktop::pretty_quantity(value, "s", 2));
      };
      return std::pair{
          tr("%1 at %2 per second: length %3. Writing takes about %4. Size: about %5 as MP4, %6 as "
             "GIF, %7 as AVI.")
                  .arg(QString::fromStdString(counted(pictures, "picture")))
                  .arg(filmRate())
                  .arg(seconds(pictures / filmRate()), seconds(each * pictures),
                       megabytes(kMp4Share * bytes * pictures),
                       megabytes(kGifShare * bytes * pictures),
                       megabytes(kAviShare * bytes * pictures)) +
              (filmEvery() > 1
                   ? tr(" The movie has one of every %1 frames. Numbered pictures have all frames.")
                         .arg(filmEvery())
                   : QString()),
          true};
    } catch (const std::exception& error) {
      return std::pair{QString::fromUtf8(error.what()), false};
    }
  };
  auto* dialog = new FilmDialog(picture_->animation().time, playedFrames(), tell, this);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    askForFilmName(static_cast<int>(dialog->first()) + 1, static_cast<int>(dialog->last()) + 1);
  });
  dialog->open();
}

void AgoreWindow::askForFilmName(int first, int last) {
  // MP4 first: a GIF has some twenty times its size.
  const QString mp4 = tr("MP4 (*.mp4)"), others = tr("GIF (*.gif);;AVI (*.avi)"),
                folder = tr("Numbered pictures, folder (*)");
  auto* dialog = new QFileDialog(
      this, tr("Save Movie"), proposedName(best_format()),
      (desktop::ffmpeg_found()
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
  dialog->selectFile(besideFile(proposedName(best_format())));
  name_as(dialog->selectedNameFilter());
  connect(dialog, &QFileDialog::filterSelected, this, name_as);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, dialog, first, last](const QString& name) {
            dialog->hide();  // writing takes its time
            writeFilm(name, first, last);
          });
  dialog->open();
}

bool AgoreWindow::writeFilm(const QString& path, int first, int last) {
  writing_ = true;  // the picture stays unchanged until the movie is written
  const auto written = qScopeGuard([this] { writing_ = false; });
  RenderOptions render = filmOptions();
  render.first = first, render.last = last;
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
    // Numbered pictures have no rate.
    const int every = QFileInfo(path).suffix().isEmpty() ? 1 : filmEvery();
    render_movie(*picture_, every, filmRate(), path.toStdString(), render);
    const bool folder = QFileInfo(path).isDir();
    if (stopped)
      desktop::tell_in_foot(
          this,
          folder ? tr("Stopped. %1 in %2.")
                       .arg(QString::fromStdString(counted(pictures, "picture is", "pictures are")))
                       .arg(path)
                 : tr("Stopped: no movie was saved."));
    else
      desktop::tell_in_foot(
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
