#include "desktop/image_export.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"

#include <QBuffer>
#include <QFileInfo>
#include <QImageWriter>
#include <QRegularExpression>
#include <QSaveFile>
#include <QSettings>

#include <algorithm>
#include <fstream>
#include <string>

namespace adore::desktop {

void check_replaceable(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, error);
  if (!std::filesystem::exists(status)) return;
  if (std::filesystem::is_regular_file(status)) {
    // The mark of save_image() and AviWriter stands before the pixels.
    std::string bytes(4096, '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
    const bool picture = bytes.starts_with("\x89PNG") || bytes.starts_with("\xff\xd8") ||
                         bytes.starts_with("RIFF") || bytes.starts_with("GIF89a");
    if (bytes.empty() || (picture && bytes.find("Adore ") != std::string::npos)) return;
  }
  throw InputError(path.string() +
                   " exists and was not drawn by this program; name another folder or file, or "
                   "remove it first");
}

void save_image(const QImage& image, const std::filesystem::path& path, Replace replace) {
  if (replace == Replace::OwnPictures) check_replaceable(path);
  const QString name = QString::fromStdString(path.string());
  const QByteArray suffix = QFileInfo(name).suffix().toLower().toLatin1();
  if (suffix != "png" && suffix != "jpg" && suffix != "jpeg")
    throw InputError("a picture cannot be saved as " + path.string() +
                     "; give a name that ends in .png, .jpg or .jpeg");
  QSaveFile file(name);
  if (!file.open(QIODevice::WriteOnly))
    throw InputError("cannot write " + path.string() + ": " + write_fault(file) +
                     "; choose a folder that exists and is yours");
  QImageWriter writer(&file, suffix);
  if (suffix != "png") writer.setQuality(93);
  writer.setText("Software", QString::fromLatin1(kProgramVersion.data(),
                                                 static_cast<qsizetype>(kProgramVersion.size())));
  if (!writer.write(image) || !file.commit())
    throw InputError("cannot write " + path.string() + ": " +
                     (file.error() != QFileDevice::NoError ? write_fault(file)
                                                           : writer.errorString().toStdString()));
}

void save_bytes(const QByteArray& bytes, const std::filesystem::path& path) {
  QSaveFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
    throw InputError("cannot write " + path.string() + ": " + write_fault(file) +
                     "; choose a folder that exists and is yours");
}

std::string write_fault(const QFileDevice& file) {
  const QString text = file.errorString();
  return text == QLatin1String("Unknown error") ? "the disk may be full" : text.toStdString();
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

namespace {

/// `name`, or with the first number behind it that no file has. A number that ends it is what it
/// names, a page.
QString free_name(const QString& name) {
  const QFileInfo info(name);
  const QString folder = name.left(name.size() - info.fileName().size());
  QString out = name;
  for (int number = 2; QFileInfo::exists(out); ++number)
    out = QString("%1%2-%3.%4").arg(folder, info.completeBaseName()).arg(number).arg(info.suffix());
  return out;
}

/// Is it the name that was proposed, with or without its number, in whatever format?
bool is_proposed(const QString& shown, const QString& saved) {
  const QString stem = QFileInfo(shown).completeBaseName();
  const QRegularExpression form("^" + QRegularExpression::escape(stem) + "(-\\d+)?$");
  return form.match(QFileInfo(saved).completeBaseName()).hasMatch();
}

}  // namespace

QString proposed_image_name(const QString& app, const QString& shown) {
  const QSettings settings("Adore", app);
  const QString last = settings.value("picture/last").toString(),
                of = settings.value("picture/of").toString();
  const QFileInfo now(shown);
  if (last.isEmpty() || QFileInfo(of).absolutePath() != now.absolutePath()) return free_name(shown);
  if (of == shown && !is_proposed(shown, last)) return next_image_name(last);
  return free_name(QFileInfo(last).absoluteDir().filePath(now.fileName()));
}

void remember_image_name(const QString& app, const QString& shown, const QString& saved) {
  QSettings settings("Adore", app);
  settings.setValue("picture/of", shown);
  settings.setValue("picture/last", saved);
}

}  // namespace adore::desktop
