#pragma once

#include "desktop/instance_lock.hpp"
#include "desktop/link_message.hpp"

#include <QList>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

class QLocalServer;
class QLocalSocket;

namespace adore::desktop {

/// Links windows that show the same run folder, also of other programs of the user: each reports
/// its time and selected element to the others.
///
/// One of them is the hub, which passes messages on; the others connect to it. The hub has a lock
/// that the system releases when its program ends, however it ends: then another one becomes the
/// hub. Nothing here waits for another program.
class RunLink : public QObject {
  Q_OBJECT
 public:
  explicit RunLink(QObject* parent);
  ~RunLink() override;

  /// Leaves the previous folder. Empty: no run.
  void join(const QString& folder);
  [[nodiscard]] const QString& folder() const { return folder_; }
  /// Switched off: neither sends nor receives.
  void setActive(bool on);
  [[nodiscard]] bool isActive() const { return active_; }
  enum class Cause : unsigned char { User, Playing };
  /// A change in this window, for all others. Of changes in quick succession the last one arrives.
  /// Frames of a playing animation never replace a later action of the user in another window.
  void tell(const LinkState& change, Cause cause = Cause::User);
  /// As told or received last in this folder.
  [[nodiscard]] const LinkState& state() const { return state_; }
  /// Is this window the hub, or connected to it?
  [[nodiscard]] bool isJoined() const { return server_ || connected_; }
  [[nodiscard]] bool isHub() const { return server_ != nullptr; }
  /// Of a folder; empty: windows of this folder cannot be linked.
  [[nodiscard]] static QString socketPath(const QString& folder);

 signals:
  /// A change in another window. A window that joins receives the current state.
  void told(const adore::desktop::LinkState& change);

 private:
  void begin();
  void leave();
  void retry();
  bool becomeHub();
  void connectToHub();
  void acceptConnections();
  void adopt(QLocalSocket* socket);
  void discardSocket(QLocalSocket* socket);
  void receive(QLocalSocket* from);
  void send(const LinkMessage& message, const QLocalSocket* except = nullptr);

  QString folder_, path_;
  bool active_ = true, connected_ = false;
  std::optional<InstanceLock> lock_;
  std::unique_ptr<QLocalServer> server_;  ///< of the hub
  QList<QLocalSocket*> sockets_;          ///< of the hub: to all others; else: to the hub
  LinkState state_;
  LinkMessage pending_;
  long long last_action_number_ = 0;  ///< the last one of the user, in any window
  bool own_action_is_last_ = false;   ///< it was in this window; a hub that ends may lose it
  QTimer retry_timer_, send_timer_;
  int join_failures_ = 0;  ///< successive attempts to join
};

}  // namespace adore::desktop
