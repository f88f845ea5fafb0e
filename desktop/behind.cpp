#include "desktop/behind.hpp"

#include <QApplication>
#include <QEvent>
#include <QTimer>
#include <QWidget>
#include <QWindow>

namespace adore::desktop {

OpenWithoutFocusGuard::OpenWithoutFocusGuard() { qApp->installEventFilter(this); }

bool OpenWithoutFocusGuard::eventFilter(QObject* object, QEvent* event) {
  // After the user has activated a window, later ones come to the front.
  if (event->type() == QEvent::WindowActivate) qApp->removeEventFilter(this);
  if (!object->isWidgetType() || !static_cast<QWidget*>(object)->isWindow()) return false;
  auto* window = static_cast<QWidget*>(object);
  if (event->type() == QEvent::Polish) {  // before it is shown
    window->setAttribute(Qt::WA_ShowWithoutActivating);
    // A window created before, when its position was restored, needs the notification that Qt sends
    // to others.
    if (QWindow* made = window->windowHandle()) made->setProperty("_q_showWithoutActivating", true);
  }
  if (event->type() == QEvent::Show) {
    QApplication::alert(window);
    // Above the active one it would hide the typed text.
    QTimer::singleShot(0, window, [window] { window->lower(); });
  }
  return false;
}

}  // namespace adore::desktop
