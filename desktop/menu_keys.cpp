#include "desktop/menu_keys.hpp"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QMainWindow>

#include <algorithm>
#include <array>

namespace adore::desktop {
namespace {

bool is_editing(const QKeyEvent& key) {
  constexpr std::array kOfFields = {QKeySequence::Copy,  QKeySequence::Cut,
                                    QKeySequence::Paste, QKeySequence::Undo,
                                    QKeySequence::Redo,  QKeySequence::SelectAll};
  return std::any_of(kOfFields.begin(), kOfFields.end(), [&](QKeySequence::StandardKey standard) {
    return QKeySequence::keyBindings(standard).contains(QKeySequence(key.keyCombination()));
  });
}

/// A letter with Alt activates a button or menu. If that is disabled or gone, a text field would
/// take the letter.
bool is_stray_letter(const QKeyEvent& key) {
  const Qt::KeyboardModifiers held = key.modifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier);
  return held == Qt::AltModifier && !key.text().isEmpty() && key.text().front().isPrint();
}

/// Menus, which take letters with Alt themselves, are separate windows but not dialogs.
bool in_dialog_of(const QWidget& widget, const QWidget& window) {
  const QWidget* top = widget.window();
  if (qobject_cast<const QDialog*>(top) == nullptr) return false;
  while (top != nullptr && top != &window) top = top->parentWidget();
  return top != nullptr;
}

}  // namespace

MenuKeys::MenuKeys(QMainWindow& window) : QObject(&window), window_(window) {
  qApp->installEventFilter(this);
}

bool MenuKeys::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  const auto* widget = qobject_cast<QWidget*>(object);
  if (widget == nullptr) return false;
  const bool own = widget->window() == &window_;
  const auto& key = *static_cast<QKeyEvent*>(event);
  if (event->type() == QEvent::KeyPress)
    return (own || in_dialog_of(*widget, window_)) && is_stray_letter(key);
  if (!own) return false;
  if (!key.modifiers().testFlag(Qt::ControlModifier) || is_editing(key)) return false;
  const QKeySequence pressed(key.keyCombination());
  for (const QAction* action : window_.findChildren<QAction*>())
    if (action->isEnabled() && action->shortcuts().contains(pressed)) {
      event->ignore();
      return true;
    }
  return false;
}

}  // namespace adore::desktop
