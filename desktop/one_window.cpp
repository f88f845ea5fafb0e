#include "desktop/one_window.hpp"

#include "desktop/user_socket.hpp"

#include <QFileInfo>
#include <QtNetwork/QLocalServer>
#include <QtNetwork/QLocalSocket>

#include <algorithm>

namespace adore::desktop {
namespace {

constexpr int kPatience = 500;  // ms for a window that is busy drawing

QString server_name(const QString& program, const QString& folder) {
  return "adore-" + program + "-" + folder_key(folder);
}

}  // namespace

SingleWindowServer::SingleWindowServer(const QString& program, const QString& folder,
                                       QObject* parent,
                                       std::function<void(const QStringList&)> show)
    : QObject(parent), server_(new QLocalServer(this)) {
  const QString name = server_name(program, folder);
  server_->setSocketOptions(QLocalServer::UserAccessOption);
  QLocalSocket other;
  other.connectToServer(name);
  if (other.waitForConnected(kPatience)) return;  // the other window stays the only one
  QLocalServer::removeServer(name);               // of a program that was cut off
  if (!server_->listen(name)) return;
  connect(server_, &QLocalServer::newConnection, this, [this, show = std::move(show)] {
    QLocalSocket* asking = server_->nextPendingConnection();
    connect(asking, &QLocalSocket::disconnected, asking, [asking, show] {
      const QString text = QString::fromUtf8(asking->readAll());
      asking->deleteLater();
      const QStringList files = text.split('\n', Qt::SkipEmptyParts);
      if (!files.isEmpty()) show(files);
    });
  });
}

bool SingleWindowServer::is_listening() const { return server_->isListening(); }

QString folder_of(const std::filesystem::path& file) {
  return QFileInfo(QString::fromStdString(file.string())).absolutePath();
}

bool send_to_open_window(const QString& program, const QString& folder, const QStringList& files) {
  const bool any = std::any_of(files.begin(), files.end(),
                               [](const QString& name) { return !name.startsWith("--"); });
  if (!any) return false;
  QLocalSocket socket;
  socket.connectToServer(server_name(program, folder));
  if (!socket.waitForConnected(kPatience)) return false;
  socket.write(files.join('\n').toUtf8());
  const bool written = socket.waitForBytesWritten(kPatience);
  socket.disconnectFromServer();
  return written;
}

}  // namespace adore::desktop
