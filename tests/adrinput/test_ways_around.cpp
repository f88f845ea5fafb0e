#include "adrinput/catalogue_dialog.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/search.hpp"
#include "adrinput/solution_charts.hpp"
#include "deck/lookup.hpp"
#include "support/qt_app.hpp"

#include <QAbstractItemView>
#include <QCompleter>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>

/// Search, menus and the catalogue.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

TEST_CASE("adrinput: search for an array without elements → leads to its count, with a message",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.document().edit(cell("kNumPltElem"), "0");
  window.document().end_undo_step();
  auto* notice = window.findChild<NoticeBar*>("search-notice");
  REQUIRE(notice != nullptr);
  window.goTo(cell("kPltElemInd"));
  CHECK(window.currentRecord() == "3.4");
  REQUIRE(notice->isVisibleTo(&window));
  CHECK(notice->text().contains("kNumPltElem"));
  const auto* focus = qobject_cast<QLineEdit*>(window.focusWidget());
  REQUIRE(focus != nullptr);
  CHECK(focus->text() == "0");
  CHECK(focus->objectName().contains("kNumPltElem"));
  CHECK_FALSE(focus->visibleRegion().isEmpty());
  window.document().edit(cell("kNumPltElem"), "2");
  window.document().end_undo_step();
  window.goTo(cell("kPltElemInd"));
  CHECK_FALSE(notice->isVisibleTo(&window));
}

TEST_CASE("search: hidden field → option that shows it, can be set", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.document().edit(cell("nCseg"), "0");
  CHECK(window.document().instances("7.1") == 0);
  window.goTo(cell("cageDia1"));
  CHECK(window.currentRecord() == "3.2");
  auto* notice = window.findChild<NoticeBar*>("search-notice");
  REQUIRE(notice != nullptr);
  CHECK(notice->text().contains("nCseg = 1"));
  press(window, "set-option");
  CHECK(window.currentRecord() == "7.1");
  CHECK(window.document().deck().integer("nCseg") == 1);
  // The found element is marked as present.
  auto* query = window.findChild<QLineEdit*>("search");
  auto* list = window.findChild<QListWidget*>("found");
  query->setText("reDiaVar12");
  REQUIRE(list->count() > 0);
  CHECK(list->item(0)->text().contains("Not in this deck"));
  window.document().edit(cell("kReGeoImp"), "2");
  window.checkNow();
  CHECK_FALSE(list->item(0)->text().contains("Not in this deck"));
  window.document().edit(cell("kReGeoImp"), "0");
  query->clear();
  // The message of one search is removed by the next one.
  for (const char* found : {"bReDia", "kTherm"}) {
    window.goTo(cell("kBaseTemp"));
    CHECK(notice->isVisibleTo(&window));
    window.goTo(cell(found));
    CHECK_FALSE(notice->isVisibleTo(&window));
  }
  // The way that is named leads there; nearly every record has one.
  int ways = 0, none = 0;
  for (const deck::RecordSpec& spec : deck::schema()) {
    if (window.document().instances(spec.id) > 0 || spec.id == "12" || deck::is_extension(spec.id))
      continue;
    INFO(spec.id);
    const std::optional<EnablingOption> way =
        find_enabling_option(window.document().deck(), spec.id);
    ++(way ? ways : none);
    if (!way) continue;
    deck::Deck changed = window.document().deck();
    changed.set(variable_of(way->option)->name, way->code);
    changed.complete();
    CHECK((!way->enough || changed.has_record(spec.id)));
  }
  CHECK(ways > 15);
  CHECK(none <= 3);
}

TEST_CASE("catalog: designation → deck with a list of standard and estimated values",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  DeckWindow window;
  window.show();
  window.newFromCatalogue();
  auto* dialog = window.findChild<CatalogueDialog*>("catalogue");
  REQUIRE(dialog != nullptr);
  auto* name = dialog->findChild<QLineEdit*>("designation");
  auto* createDeck = dialog->findChild<QPushButton*>("take");
  CHECK_FALSE(createDeck->isEnabled());
  QTest::keyClicks(name, "62055");
  CHECK_FALSE(createDeck->isEnabled());
  // The list of further results closes when it is empty: it covers the description.
  const auto* list = name->completer()->popup();
  name->clear();
  QTest::keyClicks(name, "NU2");
  CHECK(list->isVisible());
  QTest::keyClicks(name, "09");
  QTest::qWait(50);
  CHECK_FALSE(list->isVisible());
  name->setText("NU209");
  CHECK(createDeck->isEnabled());
  CHECK(dialog->descriptionText().contains("ISO 15"));
  CHECK(dialog->descriptionText().contains("ESTIMATE"));
  QTest::mouseClick(createDeck, Qt::LeftButton);
  CHECK(window.document().deck().real("brgOD") == 0.085);
  CHECK(window.currentRecord() == "4");
  CHECK_FALSE(window.document().has_errors());
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  window.document().save(path);
  CHECK(bytes_of(path).find("ESTIMATE of the internal geometry") != std::string::npos);
  // The inside of another size, from bore, outside diameter and widths.
  window.document().change({{"brgBore", "0.05"}, {"brgOD", "0.09"}});
  window.estimateInternalGeometry();
  CHECK(take_message(window).contains("estimate"));
  CHECK(window.document().deck().real("pitchDia") == Approx(0.07));
  window.undo();
  CHECK(window.document().deck().real("pitchDia") == 0.065);
}

TEST_CASE("adrinput: run menu; both redo shortcuts; undo in an empty search acts on the deck",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.activateWindow();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  const auto* menu = window.findChild<QMenu*>("run-menu");
  REQUIRE(menu != nullptr);
  QStringList entries;
  for (const QAction* action : menu->actions()) entries << action->text().remove('&');
  for (const char* entry : {"Plan", "Quasi-static solution", "Run", "Run in a new folder",
                            "Continue the run", "Sweep a variable …", "Study accuracy"})
    CHECK(entries.contains(QString::fromUtf8(entry)));

  QLineEdit* line = line_of(window, "bReDia");
  replace_text(line, "0.0128");
  auto* query = window.findChild<QLineEdit*>("search");
  query->setFocus();
  QTest::keyClicks(query, "load");
  for (QToolButton* cross : query->findChildren<QToolButton*>()) cross->click();
  CHECK(query->text().isEmpty());
  CHECK_FALSE(query->hasFocus());
  query->setFocus();
  QTest::keyClick(query, Qt::Key_Z, Qt::ControlModifier);
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  QTest::keyClick(query, Qt::Key_Y, Qt::ControlModifier);
  CHECK(window.document().deck().real("bReDia") == 0.0128);
  QTest::keyClick(query, Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(query, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(window.document().deck().real("bReDia") == 0.0128);
}

TEST_CASE("search: name in several records → the record of this deck first",
          "[gui][adrinput][daily]") {
  test::use_qt();
  int elsewhere = 0;
  for (const char* type : {"ball", "cylindrical", "tapered", "spherical", "spherical-tapered"}) {
    DeckWindow window;
    window.show();
    window.newDeck(type);
    auto* query = window.findChild<QLineEdit*>("search");
    std::set<std::string> names;
    for (const deck::RecordData& record : window.document().deck().records)
      for (const deck::VariableSpec& variable : deck::find_record(record.id)->variables)
        if (variable.name != "recID" && deck::find_variable(variable.name).size() > 1)
          names.emplace(variable.name);
    for (const std::string& name : names) {
      INFO(type << ": " << name);
      query->setText(QString::fromStdString(name));
      query->setFocus();
      QTest::keyClick(query, Qt::Key_Return);
      CHECK(window.document().instances(window.currentRecord()) > 0);
      const auto refs = deck::find_variable(name);
      CHECK(std::any_of(refs.begin(), refs.end(), [&](const deck::VariableRef& ref) {
        return ref.record->id == window.currentRecord();
      }));
      elsewhere += deck::find_variable(name)[0].record->id != window.currentRecord() ? 1 : 0;
    }
  }
  CHECK(elsewhere > 3);
}

TEST_CASE("catalog dialog: published facts → list of candidates, chosen one becomes the deck",
          "[gui][adrinput][daily]") {
  test::use_qt();
  CatalogueDialog dialog;
  QString text;
  QObject::connect(&dialog, &CatalogueDialog::deckCreated,
                   [&](const QString& made) { text = made; });
  dialog.show();
  const auto field = [&](const char* name) { return dialog.findChild<QLineEdit*>(name); };
  auto* list = dialog.findChild<QListWidget*>("candidates");
  auto* createDeck = dialog.findChild<QPushButton*>("take");
  field("designation")->setText("7208 B");
  CHECK_FALSE(list->isVisible());
  field("C")->setText("36.5");
  field("C0")->setText("26");
  REQUIRE(list->count() > 1);
  CHECK(list->isVisible());
  list->setCurrentRow(1);
  CHECK(dialog.descriptionText().contains("candidate 2 of"));
  field("C0")->setText("200");
  CHECK(list->count() == 0);
  CHECK_FALSE(createDeck->isEnabled());
  CHECK(dialog.descriptionText().contains("CONTRADICTION"));
  field("C0")->setText("26");
  list->setCurrentRow(1);
  field("radial")->setText("x");
  CHECK_FALSE(createDeck->isEnabled());
  field("radial")->setText("1234");
  field("speed")->setText("4321");
  field("temperature")->setText("70");
  list->setCurrentRow(1);
  QTest::mouseClick(createDeck, Qt::LeftButton);
  const deck::Deck made = deck::read_deck_text(text.toStdString(), "made").deck;
  CHECK(made.real("appLoadZ") == 1234.0);
  CHECK(made.real("rpm2") == 4321.0);
  CHECK(made.real("reTemp") == Approx(343.15));
  CHECK(made.integer("nRe") == 14);
}

TEST_CASE("catalog dialog: description of a bearing → completely visible",
          "[gui][adrinput][daily]") {
  test::use_qt();
  CatalogueDialog dialog;
  dialog.show();
  auto* name = dialog.findChild<QLineEdit*>("designation");
  const auto* descriptionText = dialog.findChild<QLabel*>("story");
  const auto* area = dialog.findChild<QScrollArea*>();
  for (const char* typed : {"", "62", "6205", "7208 B", "NU209 C3", "30208 C3", "22210 C4 W33",
                            "deep-groove 25x52x15", "22210 K C3"}) {
    name->setText(typed);
    INFO(typed << ": " << descriptionText->text().toStdString());
    CHECK(QTest::qWaitFor(
        [&] {
          return area->viewport()->height() >=
                 descriptionText->heightForWidth(descriptionText->width());
        },
        2000));
  }
  CHECK(dialog.descriptionText().contains("tapered bore"));
}
