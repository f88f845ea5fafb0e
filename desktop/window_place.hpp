#pragma once

#include <QObject>
#include <QSize>
#include <QString>

class QWidget;

namespace adore::desktop {

/// Size of a window that wants `preferred` where `available` is free of panels: room is left for
/// the frame and title bar that the window manager puts around it.
[[nodiscard]] QSize size_within(QSize preferred, QSize available);

/// Resizes a window to `preferred`, or to what its screen has room for. The offscreen platform has
/// no screen: there it is `preferred`.
void open_at_size(QWidget& window, QSize preferred);

/// Restores the size and position of a main window from its last use, and stores them when it is
/// closed. Exists as long as the window.
class WindowMemory : public QObject {
 public:
  /// @param app name of the settings, e.g. "agore"
  WindowMemory(QWidget& window, QString app);
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QWidget& window_;
  QString app_;
};

}  // namespace adore::desktop
