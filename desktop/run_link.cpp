#include "desktop/run_link.hpp"

#include "desktop/user_socket.hpp"

#include <QFileInfo>
#include <QRandomGenerator>
#include <QtNetwork/QLocalServer>
#include <QtNetwork/QLocalSocket>

#include <algorithm>
#include <utility>

namespace adore::desktop {
namespace {

constexpr int kPace = 30;                     // [ms] between messages: a playing animation
constexpr int kFirstRetry = 40;               // [ms]
constexpr int kRetryDoublings = 6;            // doublings of the time between attempts
constexpr int kWindowsLimit = 64;             // linked to one hub
constexpr int kBuffer = 8 * kLongestMessage;  // [bytes] received at once
constexpr int kUnsentLimit = 64 * 1024;       // [bytes] for a program that does not read

}  // namespace

RunLink::RunLink(QObject* parent) : QObject(parent) {
  retry_timer_.setSingleShot(true);
  connect(&retry_timer_, &QTimer::timeout, this, &RunLink::begin);
  send_timer_.setSingleShot(true);
  send_timer_.setInterval(kPace);
  connect(&send_timer_, &QTimer::timeout, this, [this] {
    if (pending_.change.empty()) return;
    send(std::exchange(pending_, {}));
    send_timer_.start();
  });
}

RunLink::~RunLink() { leave(); }

QString RunLink::socketPath(const QString& folder) {
  if (folder.isEmpty() || !QFileInfo(folder).isDir()) return {};
  return user_socket("adore-link-" + folder_key(folder));
}

void RunLink::join(const QString& folder) {
  if (folder == folder_) return;
  leave();
  folder_ = folder;
  state_ = {};
  last_action_number_ = 0;
  own_action_is_last_ = false;
  path_ = socketPath(folder);
  join_failures_ = 0;
  begin();
}

void RunLink::setActive(bool on) {
  if (on == active_) return;
  active_ = on;
  state_ = {};
  own_action_is_last_ = false;
  leave();
  join_failures_ = 0;
  begin();
}

void RunLink::tell(const LinkState& change, Cause cause) {
  if (!active_ || folder_.isEmpty() || change.empty()) return;
  if (cause == Cause::User) {
    ++last_action_number_;
    own_action_is_last_ = true;
  }
  state_.take(change);
  pending_.change.take(change);
  pending_.action = last_action_number_;
  if (send_timer_.isActive()) return;
  send(std::exchange(pending_, {}));
  send_timer_.start();
}

void RunLink::begin() {
  if (!active_ || path_.isEmpty() || isJoined()) return;
  if (!becomeHub()) connectToHub();
}

void RunLink::leave() {
  retry_timer_.stop();
  send_timer_.stop();
  pending_ = {};
  connected_ = false;
  for (QLocalSocket* socket : std::exchange(sockets_, {})) discardSocket(socket);
  server_.reset();  // removes its file before another one can have the lock
  lock_.reset();
}

/// Windows that lose their hub do not all ask for the lock at the same moment.
void RunLink::retry() {
  const int pause = kFirstRetry << std::min(join_failures_++, kRetryDoublings);
  retry_timer_.start(pause + QRandomGenerator::global()->bounded(pause));
}

bool RunLink::becomeHub() {
  auto lock = InstanceLock::take((path_ + ".lock").toStdString());
  if (!lock) return false;
  QLocalServer::removeServer(path_);  // of a hub that was cut off
  auto server = std::make_unique<QLocalServer>();
  server->setSocketOptions(QLocalServer::UserAccessOption);
  server->setMaxPendingConnections(kWindowsLimit);
  if (!server->listen(path_)) return false;
  lock_ = std::move(lock);
  server_ = std::move(server);
  join_failures_ = 0;
  connect(server_.get(), &QLocalServer::newConnection, this, &RunLink::acceptConnections);
  return true;
}

void RunLink::acceptConnections() {
  while (QLocalSocket* socket = server_->nextPendingConnection()) {
    socket->setParent(this);
    adopt(socket);
    if (sockets_.size() > kWindowsLimit)
      discardSocket(sockets_.takeLast());
    else if (!state_.empty())
      socket->write(link_message({state_, last_action_number_}));
  }
}

void RunLink::connectToHub() {
  if (!is_own_socket(path_)) return retry();
  auto* socket = new QLocalSocket(this);
  adopt(socket);
  connect(socket, &QLocalSocket::connected, this, [this] {
    connected_ = true;
    join_failures_ = 0;
    if (own_action_is_last_) send({state_, last_action_number_});
  });
  connect(socket, &QLocalSocket::errorOccurred, this, [this, socket] {
    if (sockets_.removeAll(socket) == 0) return;
    connected_ = false;
    discardSocket(socket);
    retry();
  });
  socket->connectToServer(path_);
}

/// Of another window of this folder.
void RunLink::adopt(QLocalSocket* socket) {
  sockets_ << socket;
  socket->setReadBufferSize(kBuffer);
  connect(socket, &QLocalSocket::readyRead, this, [this, socket] { receive(socket); });
  connect(socket, &QLocalSocket::disconnected, this, [this, socket] {
    if (sockets_.removeAll(socket) == 0) return;
    discardSocket(socket);
    if (server_) return;
    connected_ = false;  // the hub has ended
    retry();
  });
}

void RunLink::discardSocket(QLocalSocket* socket) {
  socket->disconnect(this);
  socket->abort();
  socket->deleteLater();
}

/// Of several messages the last values, and none from before the last action. A sender of lines
/// without end is cut off.
void RunLink::receive(QLocalSocket* from) {
  LinkState change;
  while (from->canReadLine())
    if (const auto read = read_link_message(from->readLine());
        read && read->action >= last_action_number_) {
      if (read->action > last_action_number_) own_action_is_last_ = false;
      last_action_number_ = read->action;
      change.take(read->change);
    }
  if (from->bytesAvailable() > kLongestMessage) return from->abort();
  if (change.empty()) return;
  state_.take(change);
  pending_ = {};  // it is older
  if (server_) send({change, last_action_number_}, from);
  emit told(change);
}

/// A program that does not read its messages misses some.
void RunLink::send(const LinkMessage& message, const QLocalSocket* except) {
  const QByteArray line = link_message(message);
  for (QLocalSocket* socket : sockets_)
    if (socket != except && socket->state() == QLocalSocket::ConnectedState &&
        socket->bytesToWrite() < kUnsentLimit)
      socket->write(line);
}

}  // namespace adore::desktop
