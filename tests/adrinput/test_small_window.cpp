#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/record_page.hpp"
#include "deck/templates.hpp"
#include "support/qt_app.hpp"
#include "support/reachable.hpp"

#include <QDockWidget>
#include <QListWidget>
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

TEST_CASE("adrinput: no page of an example scrolls sideways on a screen of 1280x800",
          "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1264, 770);  // with its frame
  window.show();
  const auto* form = window.findChild<QScrollArea*>("form");
  for (const deck::TemplateInfo& info : deck::templates()) {
    window.newDeck(QString::fromStdString(std::string(info.name)));
    for (const std::string& record : window.document().pages()) {
      INFO(info.name << ", record " << record);
      window.showRecord(record);
      CHECK(window.page()->minimumSizeHint().width() <= form->viewport()->width());
    }
  }
}

TEST_CASE("adrinput: titles of records are not cut in a narrow list", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.resize(944, 500);  // a screen of 1920x1080 at scale factor 2
  window.show();
  QTest::qWait(50);
  auto* list = window.findChild<QListWidget*>("records");
  REQUIRE(list->count() > 10);
  constexpr int kSignAndMargins = 32;
  for (int row = 0; row < list->count(); ++row) {
    const QRect place = list->visualItemRect(list->item(row));
    for (const QString& word : list->item(row)->text().split(' ')) {
      INFO(word.toStdString());
      CHECK(list->fontMetrics().horizontalAdvance(word) <= place.width() - kSignAndMargins);
    }
  }
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
