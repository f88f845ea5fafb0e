#include "desktop/menu_keys.hpp"

#include <QAction>
#include <QApplication>
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

/// A letter with Alt is a way to a button or menu. Where that is disabled or gone, a field of text
/// would take the letter.
bool is_stray_letter(const QKeyEvent& key) {
  const Qt::KeyboardModifiers held = key.modifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier);
  return held == Qt::AltModifier && !key.text().isEmpty() && key.text().front().isPrint();
}

}  // namespace

MenuKeys::MenuKeys(QMainWindow& window) : QObject(&window), window_(window) {
  qApp->installEventFilter(this);
}

bool MenuKeys::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  const auto* widget = qobject_cast<QWidget*>(object);
  if (widget == nullptr || widget->window() != &window_) return false;
  const auto& key = *static_cast<QKeyEvent*>(event);
  if (event->type() == QEvent::KeyPress) return is_stray_letter(key);
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
