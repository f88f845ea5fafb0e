#include "adrinput/cell_table.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/record_page.hpp"
#include "deck/templates.hpp"
#include "support/drops.hpp"
#include "support/qt_app.hpp"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <clocale>
#include <filesystem>
#include <fstream>

using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

TEST_CASE("typing with a German locale writes a decimal point", "[gui][adrinput]") {
  test::use_qt();
  const QLocale old = QLocale();
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  const std::string old_c = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "C.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  {
    DeckWindow window;
    window.show();
    window.showRecord("5A");
    auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("pitchDia").variable));
    REQUIRE(line != nullptr);
    replace_text(line, "0,0605");
    CHECK(line->text() == "0.0605");
    window.document().save(path);
  }
  std::setlocale(LC_ALL, old_c.c_str());
  QLocale::setDefault(old);
  CHECK(bytes_of(path).find(" 0.0605,") != std::string::npos);
  CHECK(deck::read_deck(path).deck.real("pitchDia") == 0.0605);
}

TEST_CASE("adrinput: Go Back, Next Rec, Save & Exit and Quit → behavior as in the manual",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  DeckWindow window;
  window.show();
  CHECK(window.currentRecord() == "1");
  press(window, "back");
  CHECK(take_message(window).contains("first record"));
  press(window, "next");
  CHECK(window.currentRecord() == "2.1");
  press(window, "back");
  CHECK(window.currentRecord() == "1");
  for (std::size_t i = 1; i < window.document().pages().size(); ++i) press(window, "next");
  CHECK(window.currentRecord() == "ADORE.json");
  press(window, "next");
  CHECK(take_message(window).contains("last page"));

  window.document().edit(cell("pitchDia"), "0.0601");
  CHECK(window.isWindowModified());
  const auto answer = [&](QMessageBox::StandardButton button) {
    CHECK_FALSE(window.close());
    auto* box = window.findChild<QMessageBox*>("unsaved");
    REQUIRE(box != nullptr);
    CHECK(box->text().contains("Save them?"));
    QTest::mouseClick(box->button(button), Qt::LeftButton);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  answer(QMessageBox::Cancel);
  CHECK(window.isVisible());
  press(window, "save-exit");  // has no name yet
  auto* dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog != nullptr);
  const QString name = folder.filePath("DATA.txt");
  emit dialog->fileSelected(name);
  CHECK_FALSE(window.isVisible());
  CHECK(deck::read_deck(name.toStdString()).deck.real("pitchDia") == 0.0601);

  window.show();
  window.document().edit(cell("pitchDia"), "0.0602");
  answer(QMessageBox::Discard);
  CHECK_FALSE(window.isVisible());
  CHECK(deck::read_deck(name.toStdString()).deck.real("pitchDia") == 0.0601);
}

TEST_CASE("adrinput: saving a deck with errors → window stays open, message with reasons",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  DeckWindow window;
  window.show();
  window.document().save(path);
  const std::string good = bytes_of(path);
  window.showRecord("5A");
  auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("pitchDia").variable));
  replace_text(line, "tiny");
  auto* remark = window.page()->findChild<QLabel*>("problem-pitchDia");
  REQUIRE(remark != nullptr);
  CHECK(remark->text().contains("not a number"));
  press(window, "save-exit");
  const QString reasons = take_message(window);
  CHECK(reasons.contains("not saved"));
  CHECK(reasons.contains("pitchDia = tiny"));
  CHECK(window.isVisible());
  CHECK(bytes_of(path) == good);

  // The problems panel leads back to the field.
  window.showRecord("1");
  window.nextProblem();
  CHECK(window.currentRecord() == "5A");
  CHECK(line != window.page()->fieldOf(cell("pitchDia").variable));
  line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("pitchDia").variable));
  CHECK(line->text() == "tiny");
  CHECK(window.focusWidget() == line);
  window.undo();
  CHECK(line->text() == "0.06");
  CHECK(window.page()->findChild<QLabel*>("problem-pitchDia")->text().isEmpty());
}

TEST_CASE("a file that another program changed is not replaced without a question",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  DeckWindow window;
  window.show();
  window.document().save(path);
  std::ofstream(path) << deck::template_text("tapered");
  const std::string foreign = bytes_of(path);
  const auto answer = [&](QMessageBox::StandardButton button) {
    window.document().edit(cell("pitchDia"), button == QMessageBox::Save ? "0.0601" : "0.0602");
    window.save();
    auto* box = window.findChild<QMessageBox*>("changed");
    REQUIRE(box != nullptr);
    CHECK(bytes_of(path) == foreign);
    QTest::mouseClick(box->button(button), Qt::LeftButton);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  answer(QMessageBox::Cancel);
  CHECK(bytes_of(path) == foreign);
  CHECK(window.document().modified());
  answer(QMessageBox::Save);
  CHECK(deck::read_deck(path).deck.real("pitchDia") == 0.0601);
  CHECK_FALSE(window.document().modified());
  window.document().edit(cell("pitchDia"), "0.0603");
  window.save();  // nobody else wrote: no question
  CHECK(window.findChild<QMessageBox*>("changed") == nullptr);
  CHECK(deck::read_deck(path).deck.real("pitchDia") == 0.0603);
}

TEST_CASE("adrinput: dropped web link → not opened as a deck", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  const QString title = window.windowTitle();
  QMimeData link;
  link.setUrls({QUrl("https://example.org/DATA.txt")});
  link.setText("https://example.org/DATA.txt");
  for (const QPoint& place : test::places_of(window)) test::drop_on(window, link, place);
  CHECK(take_message(window).isEmpty());
  CHECK(window.windowTitle() == title);
}

TEST_CASE("opening: dropped and recent decks, folders, other files", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::ofstream(path) << deck::template_text("tapered");
  DeckWindow window;
  window.show();
  for (const QPoint& place : test::places_of(window)) {  // on a field as well: no text for it
    INFO(place.x() << ", " << place.y());
    window.newDeck("ball");
    CHECK(test::drop_on(window, folder.path(), {"."}, place));
    CHECK(window.document().deck() == deck::new_deck("tapered"));
  }
  CHECK(window.document().deck() == deck::new_deck("tapered"));
  CHECK(window.windowTitle().contains("/DATA.txt"));
  // A floating dock is a separate window.
  const auto docks = window.findChildren<QDockWidget*>();
  REQUIRE(docks.size() >= 3);
  for (QDockWidget* dock : docks) {
    INFO(dock->objectName().toStdString());
    dock->show();
    dock->setFloating(true);
    QCoreApplication::processEvents();
    REQUIRE(dock->isWindow());
    const QList<QPoint> places = test::places_of(*dock);
    for (const QPoint& place : {places.front(), places[places.size() / 2], places.back()}) {
      window.newDeck("ball");
      CHECK(test::drop_on(*dock, folder.path(), {"."}, place));
      CHECK(window.document().deck() == deck::new_deck("tapered"));
    }
    dock->setFloating(false);
  }

  window.newDeck("ball");
  CHECK(window.document().deck() == deck::new_deck("ball"));
  auto* recent = window.findChild<QMenu*>("recent");
  emit recent->aboutToShow();
  REQUIRE_FALSE(recent->actions().isEmpty());
  CHECK(recent->actions().front()->text().endsWith("DATA.txt"));
  recent->actions().front()->trigger();
  CHECK(window.document().deck() == deck::new_deck("tapered"));

  const fs::path binary = folder.filePath("picture.png").toStdString();
  std::ofstream(binary, std::ios::binary) << std::string("\x89PNG\0\1\2", 7);
  CHECK_FALSE(window.openFile(binary));
  CHECK(take_message(window).contains("not a text file"));
  CHECK_FALSE(window.openFile(folder.filePath("none.txt").toStdString()));
  CHECK(take_message(window).contains("none.txt"));
  CHECK(window.document().deck() == deck::new_deck("tapered"));
}

TEST_CASE("search: result selected → its field has the focus and help shows its record",
          "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  auto* query = window.findChild<QLineEdit*>("search");
  QTest::keyClicks(query, "pitch diameter");
  QTest::keyClick(query, Qt::Key_Return);
  CHECK(window.currentRecord() == "5A");
  CHECK(window.focusWidget() == window.page()->fieldOf(cell("pitchDia").variable));
  query->clear();
  QTest::keyClicks(query, "crown radius of the roller profile");
  auto* found = window.findChild<QListWidget*>("found");
  REQUIRE(found->count() > 0);
  CHECK(found->item(0)->text().contains("Not in this deck"));
  QTest::keyClick(query, Qt::Key_Return);
  CHECK(window.currentRecord() == "3.2");  // at the option that would show it, which is named
  CHECK(window.findChild<NoticeBar*>("search-notice")->text().contains("kBrg"));
  QTest::keyClick(query, Qt::Key_Escape);
  CHECK(query->text().isEmpty());
  int windows = 0;
  for (QAction* action : window.findChild<QMenu*>("help")->actions()) {
    action->trigger();
    if (auto* dialog = window.findChild<QDialog*>("help-window")) {
      ++windows;
      dialog->accept();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
  }
  CHECK(windows == 4);
}

TEST_CASE("keyboard: undo in a field, pages, records, tables and lines work without a mouse",
          "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.activateWindow();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  window.showRecord("5A");
  auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("pitchDia").variable));
  line->setFocus();
  QTest::keyClick(line, Qt::Key_End);
  QTest::keyClicks(line, "12");
  CHECK(window.document().deck().real("pitchDia") == 0.06);  // still being typed
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
  CHECK(line->text() == "0.06");
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(line->text() == "0.0612");
  CHECK(window.document().deck().real("pitchDia") == 0.0612);
  CHECK_FALSE(window.document().can_redo());
  QTest::keyClick(line, Qt::Key_PageDown);
  CHECK(window.currentRecord() == "7.0");
  auto* records = window.findChild<QListWidget*>("records");
  records->setFocus();
  QTest::keyClick(records, Qt::Key_Down);
  QTest::keyClick(records, Qt::Key_Down);
  CHECK(window.currentRecord() == "7.2.i");
  CHECK(records->hasFocus());

  auto* table = window.page()->findChild<CellTable*>("instances");
  REQUIRE(table != nullptr);
  REQUIRE(table->focusCell(cell("cageGsCls", 2)));
  QTest::keyClicks(table, "5");
  auto* editor = table->viewport()->findChild<QLineEdit*>();
  REQUIRE(editor != nullptr);
  QTest::keyClicks(editor, "e-4");
  QTest::keyClick(editor, Qt::Key_Tab);  // the last cell: leaves the table
  QCoreApplication::processEvents();
  CHECK(window.document().deck().real("cageGsCls", 2) == 5e-4);
  CHECK_FALSE(table->hasFocus());

  window.showRecord("12");
  auto* lines = window.page()->findChild<QPlainTextEdit*>("lines");
  QTest::keyClicks(lines, "1.0 2.0");
  QTest::keyClick(lines, Qt::Key_Return);
  QTest::keyClicks(lines, "third");
  CHECK(window.document().deck().user_lines == std::vector<std::string>{"1.0 2.0", "third"});
  window.undo();
  CHECK(window.document().deck().user_lines.empty());
  CHECK(lines->toPlainText().isEmpty());
}

TEST_CASE("adrinput: plan and quasi-static solution → displayed next to the form",
          "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  const auto run = [&](EvaluationPanel& panel, auto start) {
    QSignalSpy spy(&panel, &EvaluationPanel::finished);
    (window.*start)();
    CHECK(panel.busy());
    REQUIRE(spy.wait(60000));
    return panel.text();
  };
  CHECK(run(window.planPanel(), &DeckWindow::showPlan).contains("pocket contact"));
  CHECK(run(window.staticsPanel(), &DeckWindow::runQuasiStatic).contains("Largest contact load"));
  CHECK(window.staticsPanel().headline().contains("Largest contact load"));
  window.document().edit(cell("appLoadX"), "1501");
  CHECK(window.staticsPanel().findChild<QLabel*>("note")->text().contains("the deck has changed"));
  window.undo();
  window.newDeck("cylindrical-nu209");
  CHECK(run(window.staticsPanel(), &DeckWindow::runQuasiStatic).contains("Largest contact load"));
  window.newDeck("ball");
  window.document().edit(cell("pitchDia"), "-1");
  window.showPlan();
  CHECK(take_message(window).contains("errors"));
  CHECK_FALSE(window.planPanel().busy());
}
