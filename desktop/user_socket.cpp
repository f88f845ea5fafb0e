#include "desktop/user_socket.hpp"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>

#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace adore::desktop {
namespace {

bool is_private(const QByteArray& folder) {
  constexpr mode_t kOthers = 0077;
  struct stat found {};
  return !folder.isEmpty() && ::lstat(folder.constData(), &found) == 0 && S_ISDIR(found.st_mode) &&
         found.st_uid == ::geteuid() && (found.st_mode & kOthers) == 0;
}

}  // namespace

QString folder_key(const QString& folder) {
  const QByteArray path = QDir(folder).canonicalPath().toUtf8();
  const QByteArray user = QDir::homePath().toUtf8();
  constexpr int kDigits = 20;
  return QCryptographicHash::hash(user + '\n' + path, QCryptographicHash::Sha1)
      .toHex()
      .left(kDigits);
}

QString user_socket(const QString& name) {
  QByteArray folder = qgetenv("XDG_RUNTIME_DIR");
  if (!is_private(folder)) folder = QFile::encodeName(QDir::tempPath());
  const QByteArray path = folder + '/' + QFile::encodeName(name);
  const bool fits = path.size() < static_cast<qsizetype>(sizeof(sockaddr_un::sun_path));
  return fits ? QFile::decodeName(path) : QString();
}

bool is_own_socket(const QString& path) {
  struct stat found {};
  return ::lstat(QFile::encodeName(path).constData(), &found) == 0 && S_ISSOCK(found.st_mode) &&
         found.st_uid == ::geteuid();
}

}  // namespace adore::desktop
