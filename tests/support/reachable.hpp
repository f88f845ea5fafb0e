#pragma once

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStringList>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTextBrowser>
#include <QTreeWidget>

/// Elements that users without a mouse or a screen can find in a window.
namespace adore::test {

/// Widgets that can be used but have neither a text nor an accessible name nor a label of theirs.
inline QStringList nameless_widgets(const QMainWindow& window) {
  QStringList out;
  const auto labels = window.findChildren<QLabel*>();
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    // Elements that the keyboard can reach, and buttons that it cannot. A scroll area takes the
    // focus for its content, which has a separate name.
    const bool used = (widget->focusPolicy() != Qt::NoFocus &&
                       qobject_cast<const QScrollArea*>(widget) == nullptr) ||
                      qobject_cast<const QAbstractButton*>(widget) != nullptr;
    if (!used || !widget->isVisible() || !widget->accessibleName().isEmpty()) continue;
    if (widget->objectName().startsWith("qt_")) continue;  // parts of a tool bar
    const auto* area = qobject_cast<const QAbstractScrollArea*>(widget->parentWidget());
    if (area != nullptr && area->viewport() == widget) continue;  // the area has the name
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    if (button != nullptr && !button->text().isEmpty()) continue;
    bool labelled = false;
    for (const QLabel* label : labels) labelled = labelled || label->buddy() == widget;
    if (!labelled)
      out << QString("%1 %2 in %3 %4")
                 .arg(widget->metaObject()->className(), widget->objectName(),
                      widget->parentWidget()->metaObject()->className(),
                      widget->parentWidget()->objectName());
  }
  return out;
}

/// Entries of one menu, or menus of one bar, that the same letter chooses: it would choose none.
inline QStringList clashing_letters(const QMainWindow& window) {
  QStringList out;
  QList<QWidget*> menus{window.menuBar()};
  for (QMenu* menu : window.findChildren<QMenu*>()) menus << menu;
  static const QRegularExpression letter("&([^&])");
  for (const QWidget* menu : menus) {
    QMap<QString, QString> seen;
    for (const QAction* action : menu->actions()) {
      const QRegularExpressionMatch found = letter.match(action->text());
      if (!found.hasMatch()) continue;
      const QString key = found.captured(1).toLower();
      if (seen.contains(key)) out << seen[key] + " / " + action->text();
      seen[key] = action->text();
    }
  }
  return out;
}

/// Letters with Alt that several things of a window claim as it is shown now: such a key only moves
/// the focus from one to the next. Buttons count that are gray at the moment.
inline QStringList contested_letters(const QWidget& window) {
  QMap<QString, QStringList> claims;
  const auto claim = [&](const QString& text) {
    static const QRegularExpression letter("&([^&])");
    const QRegularExpressionMatch found = letter.match(QString(text).replace("&&", "  "));
    if (found.hasMatch()) claims[found.captured(1).toLower()] << text;
  };
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->window() != &window || !widget->isVisibleTo(&window)) continue;
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) claim(button->text());
    if (const auto* box = qobject_cast<const QGroupBox*>(widget)) claim(box->title());
    if (const auto* label = qobject_cast<const QLabel*>(widget); label && label->buddy())
      claim(label->text());
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget))
      for (int k = 0; k < tabs->count(); ++k) claim(tabs->tabText(k));
    if (const auto* bar = qobject_cast<const QMenuBar*>(widget))
      for (const QAction* action : bar->actions())
        if (action->isVisible()) claim(action->text());
  }
  QStringList out;
  for (const QStringList& texts : claims)
    if (texts.size() > 1) out << texts.join(" / ");
  return out;
}

/// The same of a window with each page of its tabs in front, one after the other.
inline QStringList contested_letters_of_pages(const QWidget& window) {
  QStringList out = contested_letters(window);
  for (QTabWidget* tabs : window.findChildren<QTabWidget*>()) {
    const int before = tabs->currentIndex();
    for (int k = 0; k < tabs->count(); ++k) {
      tabs->setCurrentIndex(k);
      for (const QString& clash : contested_letters(window))
        out << clash + " (page " + tabs->tabText(k) + ")";
    }
    tabs->setCurrentIndex(before);
  }
  return out;
}

/// The dialogs and boxes that the entries of a window's menus open ("…" or "..."), each closed
/// again, and the letters in them that are contested.
inline QStringList contested_letters_of_dialogs(QMainWindow& window, int& dialogs) {
  QStringList out;
  const auto open_ones = [] {
    QList<QWidget*> found;
    for (QWidget* top : QApplication::topLevelWidgets())
      if (top->isVisible() && qobject_cast<QDialog*>(top) != nullptr) found << top;
    return found;
  };
  for (const QPointer<QAction>& action : [&] {
         QList<QPointer<QAction>> all;
         for (QAction* one : window.findChildren<QAction*>()) all << one;
         return all;
       }()) {
    if (!action || !action->isEnabled() || action->menu() != nullptr) continue;
    const QString text = action->text();
    if (!text.endsWith("...") && !text.endsWith(QChar(0x2026))) continue;
    action->trigger();
    QCoreApplication::processEvents();
    for (QWidget* dialog : open_ones()) {
      // A file dialog of Qt has its letters.
      if (qobject_cast<QFileDialog*>(dialog) == nullptr) {
        ++dialogs;
        for (const QString& clash : contested_letters_of_pages(*dialog))
          out << clash + " (" + text + ")";
      }
      dialog->close();
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCoreApplication::processEvents();
  }
  return out;
}

/// Letters with Alt that a field of the window takes as text while all that they could choose is
/// gray, as "Cancel" is a moment after the end of a run. A field is added, in case the window shows
/// none now. The window's buttons and menus stay gray.
inline QStringList letters_typed_by_alt(QMainWindow& window) {
  for (QAbstractButton* button : window.findChildren<QAbstractButton*>()) button->setEnabled(false);
  for (QAction* action : window.findChildren<QAction*>()) action->setEnabled(false);
  const auto own = [](QWidget& parent, const char* name) {
    auto* field = new QLineEdit(&parent);
    field->setObjectName(name);
    field->show();
    return field;
  };
  own(window, "a field of the window");
  auto* dialog = new QDialog(&window);
  own(*dialog, "a field of a dialog");
  dialog->show();
  QStringList out;
  for (const QPointer<QLineEdit>& field : [&] {
         QList<QPointer<QLineEdit>> all;
         for (QLineEdit* one : window.findChildren<QLineEdit*>())
           if (one->isVisible() && one->isEnabled() && !one->isReadOnly()) all << one;
         return all;
       }()) {
    for (char letter = 'a'; field && letter <= 'z'; ++letter) {
      const QString before = field->text();
      field->setFocus();
      QTest::keyClick(field, letter, Qt::AltModifier);
      if (field && field->text() != before)
        out << QString("%1 in %2").arg(letter).arg(field->objectName());
    }
  }
  delete dialog;
  return out;
}

/// Keys of a window's menus and buttons that do not do what they promise, or do it twice, where
/// some part of the window has the focus: "Home in pages". Text fields keep what is typed and what
/// moves in them; they and text that can be selected keep copying. Afterwards the keys do nothing.
inline QStringList keys_without_effect(QMainWindow& window) {
  window.activateWindow();
  QApplication::setActiveWindow(&window);
  int done = 0;
  QList<QAction*> actions;
  for (QAction* action : window.findChildren<QAction*>()) {
    if (action->shortcuts().isEmpty() || !action->isEnabled() || !action->isVisible()) continue;
    QObject::disconnect(action, &QAction::triggered, nullptr, nullptr);
    QObject::disconnect(action, &QAction::toggled, nullptr, nullptr);
    QObject::connect(action, &QAction::triggered, action, [&done] { ++done; });
    actions << action;
  }
  QStringList out;
  int places = 0;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->window() != &window || !widget->isVisible() || !widget->isEnabled() ||
        widget->focusPolicy() == Qt::NoFocus)
      continue;
    widget->setFocus();
    QWidget* const at = QApplication::focusWidget();  // of a compound, its part
    if (at == nullptr) continue;
    ++places;
    const bool field = qobject_cast<QLineEdit*>(at) != nullptr || at->inherits("QAbstractSpinBox");
    const bool text = field || qobject_cast<QLabel*>(at) != nullptr;
    for (const QAction* action : actions)
      for (const QKeySequence& key : action->shortcuts()) {
        const QKeyCombination pressed = key[0];
        const Qt::KeyboardModifiers held = pressed.keyboardModifiers();
        if (field && !(held & (Qt::ControlModifier | Qt::AltModifier))) continue;
        if (text && key == QKeySequence(QKeySequence::Copy)) continue;
        // Keys of one part of the window are that part's alone.
        const bool everywhere = action->shortcutContext() != Qt::WidgetShortcut;
        const bool here = everywhere || at->actions().contains(const_cast<QAction*>(action));
        const int wanted = here ? 1 : 0;
        done = 0;
        QTest::keyClick(at, pressed.key(), held);
        if (done != wanted)
          out << QString("%1 in %2 %3 (%4 times)")
                     .arg(key.toString(), at->metaObject()->className(), at->objectName())
                     .arg(done);
      }
  }
  for (const QAction* action : actions) QObject::disconnect(action, nullptr, action, nullptr);
  if (places < 1 || actions.size() < 10)
    out << QString("%1 places, %2 keys").arg(places).arg(actions.size());
  return out;
}

/// The text of the box that an entry of the menu Help shows.
inline QString help_text(QMainWindow& window, const QString& entry) {
  for (QAction* action : window.findChildren<QAction*>()) {
    if (QString(action->text()).remove('&') != entry) continue;
    action->trigger();
    auto* dialog = window.findChild<QDialog*>("help-window");
    if (dialog == nullptr) return {};
    const QString text = dialog->findChild<QTextBrowser*>()->toPlainText();
    delete dialog;
    return text;
  }
  return {};
}

/// Unreadable parts of the help "Keys and Mouse", with letters of the desktop's size and half as
/// large again: windows larger than the screen, lines beyond their window.
inline QStringList unreadable_help(QMainWindow& window) {
  QStringList out;
  const QFont usual = QApplication::font();
  for (const double times : {1.0, 1.5, 2.0}) {
    QFont font = usual;
    if (usual.pixelSize() > 0)
      font.setPixelSize(static_cast<int>(times * usual.pixelSize()));
    else
      font.setPointSizeF(times * usual.pointSizeF());
    QApplication::setFont(font);
    for (QAction* action : window.findChildren<QAction*>())
      if (QString(action->text()).remove('&') == "Keys and Mouse") action->trigger();
    QTest::qWait(1);
    if (auto* dialog = window.findChild<QDialog*>("help-window")) {
      const QSize screen = dialog->screen()->availableSize();
      if (dialog->width() > screen.width() || dialog->height() > screen.height())
        out << QString("%1 times: larger than the screen").arg(times);
      auto* browser = dialog->findChild<QTextBrowser*>();
      if (browser->horizontalScrollBar()->maximum() > 0)
        out << QString("%1 times: wider than its window").arg(times);
      const int shown = browser->viewport()->height() + browser->verticalScrollBar()->maximum();
      if (shown < browser->document()->size().height())
        out << QString("%1 times: its end cannot be reached").arg(times);
      delete dialog;
    } else {
      out << QString("%1 times: no help").arg(times);
    }
  }
  QApplication::setFont(usual);
  return out;
}

/// Keys without Ctrl or Alt, which nobody would guess, that the help does not name.
inline QStringList keys_without_help(const QMainWindow& window, const QString& help) {
  QStringList out;
  for (const QAction* action : window.findChildren<QAction*>())
    for (const QKeySequence& key : action->shortcuts()) {
      const QString name = key.toString(QKeySequence::PortableText);
      if (name.contains("Ctrl") || name.contains("Alt")) continue;
      QString spoken = name;
      spoken.replace("PgUp", "Page Up").replace("PgDown", "Page Down");
      const bool digit = spoken.size() == 1 && spoken[0].isDigit();
      const QRegularExpression alone("(^|[^A-Za-z+])" + QRegularExpression::escape(spoken) +
                                     "($|[^A-Za-z])");
      if (digit ? !help.contains("1 to 9") : !help.contains(alone)) out << name;
    }
  return out;
}

}  // namespace adore::test
