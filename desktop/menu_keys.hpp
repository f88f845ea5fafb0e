#pragma once

#include <QObject>

class QMainWindow;

namespace adore::desktop {

/// Keys of a window's menus act wherever the focus is. Under X11 a text field takes Ctrl+U, Ctrl+K,
/// Ctrl+D and others as editing keys of old terminals: Ctrl+U would empty the field. Copying,
/// pasting, selecting and undoing stay with the field. A letter with Alt that no button has now is
/// not typed, in dialogs of the window neither. Every window has one (an architecture test looks);
/// it lives as long as the window.
class MenuKeys : public QObject {
 public:
  explicit MenuKeys(QMainWindow& window);
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QMainWindow& window_;
};

}  // namespace adore::desktop
