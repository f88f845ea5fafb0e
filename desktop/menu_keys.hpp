#pragma once

#include <QObject>

class QMainWindow;

namespace adore::desktop {

/// Shortcuts of the menus of a window act for any focus. Under X11 a text field takes Ctrl+U,
/// Ctrl+K, Ctrl+D and others as editing keys of old terminals: Ctrl+U would empty the field.
/// Copying, pasting, selecting and undoing stay with the field. A letter with Alt that no button
/// uses is not typed, also in dialogs of the window. Every window has one (checked by an
/// architecture test); it exists as long as the window.
class MenuKeys : public QObject {
 public:
  explicit MenuKeys(QMainWindow& window);
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QMainWindow& window_;
};

}  // namespace adore::desktop
