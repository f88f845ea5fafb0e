#pragma once

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QPointer>
#include <QStringList>
#include <QTabWidget>

#include <algorithm>

/// Text of a screen reader for the element with keyboard focus.
namespace adore::test {

/// Combo boxes and texts of a window, visible or not, without an accessible name. On Linux Qt
/// reports the present text of a box as its name: a label or a description states its purpose.
inline QStringList unspoken_parts(const QWidget& window) {
  QStringList out;
  const auto labels = window.findChildren<QLabel*>();
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    const bool box = qobject_cast<QComboBox*>(widget) != nullptr;
    if (!box && !widget->inherits("QPlainTextEdit") && !widget->inherits("QTextEdit")) continue;
    if (widget->objectName().startsWith("qt_")) continue;  // of Qt's own
    const bool labelled = std::any_of(labels.begin(), labels.end(), [widget](const QLabel* label) {
      return label->buddy() == widget && !label->text().isEmpty();
    });
    QAccessibleInterface* said = QAccessible::queryAccessibleInterface(widget);
    const auto what = box ? QAccessible::Description : QAccessible::Name;
    if (!labelled && (said == nullptr || said->text(what).trimmed().isEmpty()))
      out << QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
  }
  return out;
}

/// Widgets of a window with keyboard focus and without a text, a label or an accessible name:
/// "QComboBox unit-choice".
inline QStringList unspoken(const QWidget& window) {
  QStringList out = unspoken_parts(window);
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
      const bool of_qt =
          qobject_cast<QFileDialog*>(top) != nullptr || top->inherits("QPrintDialog");
      if (!of_qt) {
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
