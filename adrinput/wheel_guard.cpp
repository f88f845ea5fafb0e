#include "adrinput/wheel_guard.hpp"

#include <QEvent>
#include <QWidget>

namespace adore::adrinput {

WheelGuard::WheelGuard(QWidget* field) : QObject(field) {
  field->setFocusPolicy(Qt::StrongFocus);
  field->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* object, QEvent* event) {
  const auto* field = qobject_cast<QWidget*>(object);
  if (event->type() != QEvent::Wheel || field == nullptr || field->hasFocus()) return false;
  event->ignore();  // for the surrounding area, which scrolls
  return true;
}

}  // namespace adore::adrinput
