#pragma once

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMainWindow>
#include <QMenu>
#include <QPointer>
#include <QStringList>
#include <QTabWidget>

/// What a screen reader can say of what has the keyboard.
namespace adore::test {

/// Widgets of a window that can have the keyboard and for which nothing can be said, neither a text
/// or label of theirs nor an accessible name: "QComboBox unit-choice".
inline QStringList unspoken(const QWidget& window) {
  QStringList out;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->window() != &window || !widget->isVisibleTo(&window) ||
        widget->focusPolicy() == Qt::NoFocus || widget->focusProxy() != nullptr)
      continue;
    if (widget->objectName().startsWith("qt_")) continue;  // parts of Qt's own compounds
    // The part of a compound speaks for it.
    const QWidget* parent = widget->parentWidget();
    if (parent != nullptr &&
        (parent->inherits("QAbstractSpinBox") || parent->inherits("QComboBox")))
      continue;
    QAccessibleInterface* said = QAccessible::queryAccessibleInterface(widget);
    if (said == nullptr || said->text(QAccessible::Name).trimmed().isEmpty())
      out << QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
  }
  out.removeDuplicates();
  return out;
}

/// The same with each page of its tabs in front, one after the other.
inline QStringList unspoken_on_pages(const QWidget& window) {
  QStringList out = unspoken(window);
  for (QTabWidget* tabs : window.findChildren<QTabWidget*>()) {
    const int before = tabs->currentIndex();
    for (int k = 0; k < tabs->count(); ++k) {
      tabs->setCurrentIndex(k);
      out << unspoken(window);
    }
    tabs->setCurrentIndex(before);
  }
  out.removeDuplicates();
  return out;
}

/// Of the dialogs and boxes that the entries of a window's menus open ("…"), each closed again.
inline QStringList unspoken_in_dialogs(QMainWindow& window, int& dialogs) {
  QStringList out;
  QList<QPointer<QAction>> actions;
  for (QAction* one : window.findChildren<QAction*>()) actions << one;
  for (const QPointer<QAction>& action : actions) {
    if (!action || !action->isEnabled() || action->menu() != nullptr) continue;
    const QString text = action->text();
    if (!text.endsWith("...") && !text.endsWith(QChar(0x2026))) continue;
    action->trigger();
    QCoreApplication::processEvents();
    for (QWidget* top : QApplication::topLevelWidgets()) {
      if (!top->isVisible() || qobject_cast<QDialog*>(top) == nullptr) continue;
      if (qobject_cast<QFileDialog*>(top) == nullptr) {  // Qt's own
        ++dialogs;
        for (const QString& widget : unspoken_on_pages(*top)) out << widget + " (" + text + ")";
      }
      top->close();
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCoreApplication::processEvents();
  }
  return out;
}

}  // namespace adore::test
