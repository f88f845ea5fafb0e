#pragma once

#include <QObject>
#include <QSize>
#include <QString>

class QWidget;

namespace adore::desktop {

/// Size of a window for a `preferred` size in an `available` area without panels: reserves space
/// for the frame and title bar of the window manager.
[[nodiscard]] QSize size_within(QSize preferred, QSize available);

/// Resizes a window to `preferred`, or to the size that fits its screen. The offscreen platform has
/// no screen: there it is `preferred`.
void resize_to_fit_screen(QWidget& window, QSize preferred);

/// Restores the size and position of a main window from its last use, and stores them when it is
/// closed. Exists as long as the window.
class WindowGeometryStore : public QObject {
 public:
  /// @param app name of the settings, e.g. "agore"
  WindowGeometryStore(QWidget& window, QString app);
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QWidget& window_;
  QString app_;
};

}  // namespace adore::desktop
