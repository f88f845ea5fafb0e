#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_page.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTest>
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace adore;
using namespace adore::adrinput;

namespace {

std::vector<QAction*> all_actions(QMenu& menu) {
  std::vector<QAction*> out;
  for (QAction* action : menu.actions()) {
    if (action->isSeparator()) continue;
    out.push_back(action);
    if (action->menu() != nullptr)
      for (QAction* inner : all_actions(*action->menu())) out.push_back(inner);
  }
  return out;
}

}  // namespace

TEST_CASE("Tab goes through a page in the order of the deck, then to the buttons and panels",
          "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  window.activateWindow();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  for (const std::string& record : window.document().pages()) {
    INFO("record " << record);
    window.showRecord(record);
    const deck::RecordSpec& spec = *page_record(record);
    std::vector<QWidget*> fields;
    if (record == "12") {
      fields.push_back(window.page()->fieldOf(0));
    } else {
      for (std::size_t v = 0; v < spec.variables.size(); ++v) {
        QWidget* field = window.page()->fieldOf(v);
        REQUIRE(field != nullptr);
        if (field->isVisible() && (fields.empty() || fields.back() != field))
          fields.push_back(field);
      }
    }
    fields.front()->setFocus();
    std::vector<QWidget*> visited;
    QWidget* last = nullptr;
    // A table takes a Tab per cell; the end of the loop is the search field at the left.
    for (int i = 0; i < 400 && (last == nullptr || last->objectName() != "search"); ++i) {
      QWidget* now = window.focusWidget();
      REQUIRE(now != nullptr);
      if (now != last) visited.push_back(now);
      last = now;
      QTest::keyClick(now, Qt::Key_Tab);
    }
    REQUIRE(last->objectName() == "search");
    std::vector<QWidget*> among;
    std::copy_if(visited.begin(), visited.end(), std::back_inserter(among), [&](QWidget* widget) {
      return std::find(fields.begin(), fields.end(), widget) != fields.end();
    });
    CHECK(among == fields);
    const auto place = [&](const char* name) {
      const auto found = std::find_if(visited.begin(), visited.end(), [&](const QWidget* widget) {
        return widget->objectName() == name;
      });
      return found - visited.begin();
    };
    CHECK(place("back") > 0);
    CHECK(place("back") < place("next"));
    CHECK(place("next") < place("save-exit"));
    CHECK(place("save-exit") < place("problems"));
    CHECK(place("problems") < static_cast<std::ptrdiff_t>(visited.size()));
    const auto tabs = std::find_if(visited.begin(), visited.end(), [](QWidget* widget) {
      return qobject_cast<QTabBar*>(widget) != nullptr;
    });
    CHECK(tabs != visited.end());
  }
}

TEST_CASE(
    "adrinput: keyboard → every action has a menu entry with a shortcut, every button takes the "
    "focus",
    "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  std::set<QKeySequence> shortcuts;
  QString letters;
  for (QAction* top : window.menuBar()->actions()) {
    REQUIRE(top->menu() != nullptr);
    const qsizetype at = top->text().indexOf('&');
    REQUIRE(at >= 0);
    CHECK_FALSE(letters.contains(top->text()[at + 1]));
    letters += top->text()[at + 1];
    for (QAction* action : all_actions(*top->menu()))
      for (const QKeySequence& key : action->shortcuts()) {
        INFO(action->text().toStdString());
        CHECK(shortcuts.insert(key).second);  // one meaning for each key
      }
  }
  window.document().edit(cell("kUnit"), "2");  // shows a question
  window.showRecord("3.2");
  int buttons = 0;
  for (const QPushButton* button : window.findChildren<QPushButton*>()) {
    if (!button->isVisible()) continue;
    INFO(button->objectName().toStdString());
    ++buttons;
    CHECK((button->focusPolicy() & Qt::TabFocus) != 0);
  }
  CHECK(buttons >= 7);
  // The question is answered with Tab and Space.
  auto* convert = window.findChild<QPushButton*>("convert");
  REQUIRE(convert != nullptr);
  convert->setFocus();
  QTest::keyClick(convert, Qt::Key_Space);
  CHECK(window.document().deck().real("pitchDia") == Approx(2.3622).epsilon(1e-4));
}

TEST_CASE("Tab behind a count goes into the table that the count makes", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  window.activateWindow();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  window.document().edit(cell("kNumPltElem"), "0");
  window.document().end_undo_step();
  window.showRecord("3.4");
  auto* count = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("kNumPltElem").variable));
  REQUIRE(count != nullptr);
  count->setFocus();
  count->selectAll();
  QTest::keyClicks(count, "2");
  QTest::keyClick(count, Qt::Key_Tab);
  CHECK(QApplication::focusWidget() == window.page()->fieldOf(cell("kPltElemInd").variable));
  CHECK(window.document().deck().integer("kNumPltElem") == 2);
}

TEST_CASE("Alt+letter without an action: not typed into a field", "[gui][adrinput][letters]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.activateWindow();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  for (const char* name : {"pitchDia", "mode", "masName"}) {
    if (window.document().instances(cell(name).record) == 0) continue;
    window.showRecord(cell(name).record);
    QWidget* field = window.page()->fieldOf(cell(name).variable);
    field->setFocus();
    const std::string before = window.document().text(cell(name));
    for (char letter = 'a'; letter <= 'z'; ++letter) {
      if (QApplication::focusWidget() != field) field->setFocus();
      QKeyEvent press(QEvent::KeyPress, letter - 'a' + Qt::Key_A, Qt::AltModifier,
                      QString(QChar(letter)));
      QApplication::sendEvent(field, &press);
    }
    window.document().end_undo_step();
    INFO(name);
    CHECK(window.document().text(cell(name)) == before);
    CHECK_FALSE(window.document().modified());
  }
}
