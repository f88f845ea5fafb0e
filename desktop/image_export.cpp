#include "desktop/image_export.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/version.hpp"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QImageWriter>
#include <QRegularExpression>
#include <QSettings>

#include <algorithm>
#include <string>
#include <string_view>

namespace adore::desktop {

void check_replaceable(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, error);
  if (!std::filesystem::exists(status)) return;
  if (std::filesystem::is_regular_file(status)) {
    // The signature of save_image() and AviWriter precedes the pixels.
    std::string bytes(4096, '\0');
    InputFile stream(path);
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
    const bool picture = bytes.starts_with("\x89PNG") || bytes.starts_with("\xff\xd8") ||
                         bytes.starts_with("RIFF") || bytes.starts_with("GIF89a");
    const auto has = [&](std::string_view mark) { return bytes.find(mark) != std::string::npos; };
    using namespace std::string_view_literals;
    if (bytes.empty() || (picture && has("Adore ")) ||
        (bytes.starts_with("<?xml") && has("<desc>Adore</desc>")) ||
        (bytes.starts_with("%PDF") && has("\0A\0d\0o\0r\0e"sv)))
      return;
  }
  throw InputError(path.string() +
                   " exists and was not written by this program; select another file or folder, or "
                   "remove the file first");
}

void save_image(const QImage& image, const WritePath& place, Replace replace) {
  const std::filesystem::path path = place.path();
  if (replace == Replace::OwnPictures) check_replaceable(path);
  const QByteArray suffix =
      QFileInfo(QString::fromStdString(place.name())).suffix().toLower().toLatin1();
  if (suffix != "png" && suffix != "jpg" && suffix != "jpeg")
    throw InputError("a picture cannot be saved as " + path.string() +
                     "; give a name that ends in .png, .jpg or .jpeg");
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QImageWriter writer(&buffer, suffix);
  if (suffix != "png") writer.setQuality(93);
  writer.setText("Software", QString::fromLatin1(kProgramVersion.data(),
                                                 static_cast<qsizetype>(kProgramVersion.size())));
  if (!writer.write(image))
    throw InputError("cannot write " + path.string() + ": " + writer.errorString().toStdString());
  save_bytes(bytes, place);
}

void save_bytes(const QByteArray& bytes, const WritePath& place) {
  write_file_atomically(place, text_of(bytes));
}

std::string_view text_of(const QByteArray& bytes) {
  return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

void make_folder(const std::filesystem::path& folder) { (void)make_folders(folder); }

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

/// `name`, or with the first free number after it. A number at its end belongs to the name, such as
/// a page.
QString free_name(const QString& name) {
  const QFileInfo info(name);
  const QString folder = name.left(name.size() - info.fileName().size());
  QString out = name;
  for (int number = 2; QFileInfo::exists(out); ++number)
    out = QString("%1%2-%3.%4").arg(folder, info.completeBaseName()).arg(number).arg(info.suffix());
  return out;
}

/// Is it the proposed name, with or without its number, in any format?
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
