#include "adrinput/text_keys.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextEdit>

#include <optional>

namespace adore::adrinput {
namespace {

std::optional<QAbstractSlider::SliderAction> action_of(const QKeyEvent& key) {
  if (key.matches(QKeySequence::MoveToNextPage)) return QAbstractSlider::SliderPageStepAdd;
  if (key.matches(QKeySequence::MoveToPreviousPage)) return QAbstractSlider::SliderPageStepSub;
  if (key.matches(QKeySequence::MoveToEndOfDocument)) return QAbstractSlider::SliderToMaximum;
  if (key.matches(QKeySequence::MoveToStartOfDocument)) return QAbstractSlider::SliderToMinimum;
  return std::nullopt;
}

}  // namespace

TextKeys::TextKeys(QWidget& window) : QObject(&window), window_(window) {
  qApp->installEventFilter(this);
}

bool TextKeys::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  auto* plain = qobject_cast<QPlainTextEdit*>(object);
  auto* rich = qobject_cast<QTextEdit*>(object);
  auto* area = plain != nullptr ? static_cast<QAbstractScrollArea*>(plain) : rich;
  if (area == nullptr || area->window() != &window_) return false;
  const auto action = action_of(*static_cast<QKeyEvent*>(event));
  if (!action) return false;
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();  // a key of the text, not a shortcut
    return true;
  }
  if (!(plain != nullptr ? plain->isReadOnly() : rich->isReadOnly())) return false;
  area->verticalScrollBar()->triggerAction(*action);
  return true;
}

}  // namespace adore::adrinput
