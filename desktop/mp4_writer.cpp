#include "desktop/mp4_writer.hpp"

#include "base/errors.hpp"

#include <QImage>
#include <QStandardPaths>

namespace adore::desktop {
namespace {
constexpr int kEncoderPatience = 60'000;  // [ms] for one picture, and for the end
}

bool has_ffmpeg() { return !QStandardPaths::findExecutable("ffmpeg").isEmpty(); }

Mp4Writer::Mp4Writer(const std::filesystem::path& path, QSize size, int frames_per_second)
    : path_(path), file_(path), size_(size.width() & ~1, size.height() & ~1) {
  const QString program = QStandardPaths::findExecutable("ffmpeg");
  if (program.isEmpty())
    throw InputError(path.string() +
                     " needs the program ffmpeg, which is not in the PATH; install it, or write a "
                     "movie as .avi or .gif");
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.start(program, {"-y",
                           "-loglevel",
                           "error",
                           "-f",
                           "rawvideo",
                           "-pix_fmt",
                           "bgra",
                           "-s",
                           QString("%1x%2").arg(size_.width()).arg(size_.height()),
                           "-r",
                           QString::number(frames_per_second),
                           "-i",
                           "-",
                           "-metadata",
                           "comment=Adore",
                           "-pix_fmt",
                           "yuv420p",
                           "-f",
                           "mp4",
                           QString::fromStdString(file_.open_path().string())});
  if (!process_.waitForStarted()) fail();
}

Mp4Writer::~Mp4Writer() {
  if (process_.state() == QProcess::NotRunning) return;
  process_.kill();
  process_.waitForFinished();
}

void Mp4Writer::fail() {
  const QByteArray said = process_.readAllStandardError().trimmed();
  throw InputError(path_.string() + ": ffmpeg could not write the movie" +
                   (said.isEmpty() ? std::string() : ": " + said.toStdString()));
}

void Mp4Writer::add(const QImage& picture) {
  const QImage image = (picture.size() == size_ ? picture
                                                : picture.scaled(size_, Qt::IgnoreAspectRatio,
                                                                 Qt::SmoothTransformation))
                           .convertToFormat(QImage::Format_RGB32);
  process_.write(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes());
  while (process_.bytesToWrite() > 0)
    if (!process_.waitForBytesWritten(kEncoderPatience)) fail();
}

void Mp4Writer::finish() {
  process_.closeWriteChannel();
  if (!process_.waitForFinished(kEncoderPatience) ||
      process_.exitStatus() != QProcess::NormalExit || process_.exitCode() != 0)
    fail();
  file_.commit();
}

}  // namespace adore::desktop
