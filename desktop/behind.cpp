#include "desktop/behind.hpp"

#include <QApplication>
#include <QEvent>
#include <QWidget>

namespace adore::desktop {

OpensBehind::OpensBehind() { qApp->installEventFilter(this); }

bool OpensBehind::eventFilter(QObject* object, QEvent* event) {
  // Before a window is shown; from the first one that is chosen on, the others come to the front.
  if (event->type() == QEvent::WindowActivate) qApp->removeEventFilter(this);
  if (event->type() == QEvent::Polish && object->isWidgetType() &&
      static_cast<QWidget*>(object)->isWindow())
    static_cast<QWidget*>(object)->setAttribute(Qt::WA_ShowWithoutActivating);
  if (event->type() == QEvent::Show && object->isWidgetType() &&
      static_cast<QWidget*>(object)->isWindow())
    QApplication::alert(static_cast<QWidget*>(object));
  return false;
}

}  // namespace adore::desktop
