#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "support/qt_app.hpp"
#include "support/reachable.hpp"

#include <QDockWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::adrinput;

TEST_CASE("adrinput: the letters of its menus choose one entry each", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  CHECK(test::clashing_letters(window).join("; ").toStdString() == "");
}

TEST_CASE("adrinput: all of a page can be reached at 700x450", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.resize(700, 450);
  window.show();
  QTest::qWait(50);
  CHECK(window.width() == 700);
  CHECK(window.height() == 450);
  CHECK(window.minimumSizeHint().width() <= 700);
  CHECK(window.minimumSizeHint().height() <= 450);
  const auto* form = window.findChild<QScrollArea*>("form");
  CHECK(form->width() >= 380);
  CHECK(form->height() >= 80);
  // Buttons are whole, each on its own place.
  QList<QRect> places;
  for (const char* name : {"back", "next", "run-statics", "run-deck", "save-exit"}) {
    const auto* button = window.findChild<QPushButton*>(name);
    INFO(name);
    CHECK(button->width() >= button->sizeHint().width());
    CHECK(button->parentWidget()->rect().contains(button->geometry()));
    for (const QRect& other : places) CHECK_FALSE(other.intersects(button->geometry()));
    places << button->geometry();
  }
  // In a large window they stand in one row again.
  window.resize(1280, 800);
  QTest::qWait(50);
  CHECK(window.findChild<QPushButton*>("back")->y() ==
        window.findChild<QPushButton*>("save-exit")->y());
}
