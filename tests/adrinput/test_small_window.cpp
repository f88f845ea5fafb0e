#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_list.hpp"
#include "adrinput/record_page.hpp"
#include "deck/templates.hpp"
#include "support/qt_app.hpp"
#include "support/reachable.hpp"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTest>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;
using namespace adore::adrinput;

TEST_CASE("adrinput: the letters of its menus choose one entry each", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  CHECK(test::clashing_letters(window).join("; ").toStdString() == "");
}

TEST_CASE("adrinput: the help of the keys is readable with large letters", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  CHECK(test::unreadable_help(window).join("; ").toStdString() == "");
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

namespace {

constexpr int kPatience = 2000;  // [ms] for a layout to come to rest

/// Elements that are cut off at the width of the page.
QStringList cut_in(const QWidget& page, int width) {
  QStringList cut;
  for (const QWidget* widget : page.findChildren<const QWidget*>()) {
    const auto* label = qobject_cast<const QLabel*>(widget);
    const bool field = widget->focusPolicy() != Qt::NoFocus && widget->parentWidget() == &page;
    if (!widget->isVisibleTo(&page) || (label == nullptr && !field)) continue;
    const QRect place(widget->mapTo(&page, QPoint()), widget->size());
    const QString name = label != nullptr ? label->text().left(40) : widget->objectName();
    if (place.left() < 0 || place.right() >= width)
      cut << QString("%1 ends at %2 of %3").arg(name).arg(place.right()).arg(width);
    if (label != nullptr && label->minimumSizeHint().width() > label->width())
      cut << QString("%1 has %2 of %3")
                 .arg(name)
                 .arg(label->width())
                 .arg(label->minimumSizeHint().width());
    if (label != nullptr && label->wordWrap() &&
        label->heightForWidth(label->width()) > label->height())
      cut << QString("%1 is %2 high of %3")
                 .arg(name)
                 .arg(label->height())
                 .arg(label->heightForWidth(label->width()));
  }
  return cut;
}

}  // namespace

TEST_CASE(
    "adrinput: no page is cut or scrolls sideways at 320 to 700 pixels, letters at once and "
    "half as large again",
    "[gui][adrinput][slow]") {
  test::use_qt();
  for (const char* deck : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    Document document;
    document.start_new(deck);
    document.edit(cell("kReGeoImp"), "2");  // a table that is wide
    for (const std::string& record : document.pages())
      for (const double factor : {1.0, 1.5}) {
        QScrollArea area;
        area.setWidgetResizable(true);
        area.setFrameShape(QFrame::NoFrame);
        area.resize(700, 500);
        auto* page = new RecordPage(document, record);
        page->setOtherUnitsShown(true);
        for (QWidget* widget : page->findChildren<QWidget*>()) {
          QFont font = widget->font();
          font.setPixelSize(static_cast<int>(std::lround(font.pixelSize() * factor)));
          if (factor > 1.0) widget->setFont(font);
        }
        area.setWidget(page);
        area.show();
        for (int width = 700; width >= 320; width -= 20) {
          area.resize(width, 500);
          QCoreApplication::processEvents();
          // Heights follow widths in rounds, whose number nobody knows.
          (void)QTest::qWaitFor(
              [&] {
                return area.horizontalScrollBar()->maximum() == 0 &&
                       cut_in(*page, area.viewport()->width()).isEmpty();
              },
              kPatience);
          INFO(deck << ", record " << record << ", " << width << " pixels, letters x " << factor);
          CHECK(area.horizontalScrollBar()->maximum() == 0);
          CHECK(cut_in(*page, area.viewport()->width()).join("; ").toStdString() == "");
        }
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

TEST_CASE("adrinput: what a search finds is not cut in a narrow list", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.resize(944, 500);
  window.show();
  auto* query = window.findChild<QLineEdit*>("search");
  auto* list = window.findChild<QListWidget*>("found");
  REQUIRE(list != nullptr);
  auto* panel = window.findChild<RecordList*>();
  panel->setFixedWidth(panel->minimumWidth());  // as at scale factor 2 on 1920x1080
  constexpr int kMargins = 10;
  const QRegularExpression breaks("[\\s\\x{200b}-]");
  int words = 0;
  for (const char* record : {"ADORE.json", "1", "2.1", "3.2", "5A", "7.1", "9.1.1", "10.4.1"})
    for (const deck::VariableSpec& variable : page_record(record)->variables) {
      query->setText(QString::fromStdString(std::string(variable.name)));
      QCoreApplication::processEvents();
      for (const QString& word : list->item(0)->text().split(breaks)) {
        INFO(variable.name << ": " << word.toStdString());
        CHECK(list->fontMetrics().horizontalAdvance(word) <= list->viewport()->width() - kMargins);
        ++words;
      }
    }
  CHECK(words > 500);
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
  // In a large window they are in one row again.
  window.resize(1280, 800);
  QTest::qWait(50);
  CHECK(window.findChild<QPushButton*>("back")->y() ==
        window.findChild<QPushButton*>("save-exit")->y());
}
