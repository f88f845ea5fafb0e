#include "desktop/image_export.hpp"

#include "base/errors.hpp"

#include <QBuffer>
#include <QFileInfo>
#include <QImageWriter>
#include <QPainter>
#include <QPrinter>
#include <QRegularExpression>
#include <QSaveFile>
#include <QSettings>

namespace adore::desktop {

void save_image(const QImage& image, const std::filesystem::path& path) {
  const QString name = QString::fromStdString(path.string());
  const QByteArray suffix = QFileInfo(name).suffix().toLower().toLatin1();
  if (suffix != "png" && suffix != "jpg" && suffix != "jpeg")
    throw InputError("a picture cannot be saved as " + path.string() +
                     "; give a name that ends in .png, .jpg or .jpeg");
  QSaveFile file(name);
  if (!file.open(QIODevice::WriteOnly))
    throw InputError("cannot write " + path.string() + ": " + file.errorString().toStdString() +
                     "; choose a folder that exists and is yours");
  QImageWriter writer(&file, suffix);
  if (suffix != "png") writer.setQuality(93);
  if (!writer.write(image) || !file.commit())
    throw InputError(
        "cannot write " + path.string() + ": " +
        (file.error() != QFileDevice::NoError ? file.errorString() : writer.errorString())
            .toStdString());
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw InputError("cannot make the folder " + folder.string() + ": " + failure.message() +
                     "; choose one that you may write to");
}

QString next_image_name(const QString& previous) {
  static const QRegularExpression numbered("^(.*?)(?:-(\\d+))?$");
  const QFileInfo info(previous);
  const QString suffix = info.suffix().isEmpty() ? "jpg" : info.suffix();
  const QString folder = previous.left(previous.size() - info.fileName().size());
  const auto match = numbered.match(info.completeBaseName());
  int number = match.captured(2).isEmpty() ? 1 : match.captured(2).toInt();
  QString name;
  do {
    name = QString("%1%2-%3.%4").arg(folder, match.captured(1)).arg(++number).arg(suffix);
  } while (QFileInfo::exists(name));
  return name;
}

QString proposed_image_name(const QString& app, const QString& fallback) {
  const QString previous = QSettings("Adore", app).value("picture/last").toString();
  return previous.isEmpty() ? fallback : next_image_name(previous);
}

void remember_image_name(const QString& app, const QString& saved) {
  QSettings("Adore", app).setValue("picture/last", saved);
}

void print_image(const QImage& image, QPrinter& printer) {
  QPainter painter(&printer);
  const QRect page = painter.viewport();
  const QSize size = image.size().scaled(page.size(), Qt::KeepAspectRatio);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRect(page.topLeft(), size), image);
}

}  // namespace adore::desktop
