#include "adrinput/cell_table.hpp"
#include "adrinput/compare_dialog.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_page.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"
#include "runs/plan.hpp"
#include "runs/prepare.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <catch2/catch.hpp>

#include <algorithm>
#include <clocale>
#include <filesystem>
#include <fstream>

using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

Cell option(const std::string& name) {
  const auto& all = options_record().variables;
  for (std::size_t v = 0; v < all.size(); ++v)
    if (all[v].name == name) return {std::string(kOptionsPage), 1, v, 0};
  FAIL("no option " << name);
  return {};
}

QLineEdit* line_of(DeckWindow& window, const Cell& at) {
  window.showRecord(at.record);
  auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(at.variable));
  REQUIRE(line != nullptr);
  return line;
}

void choose(DeckWindow& window, const Cell& at, const QString& code) {
  window.showRecord(at.record);
  auto* combo = qobject_cast<QComboBox*>(window.page()->fieldOf(at.variable));
  REQUIRE(combo != nullptr);
  REQUIRE(combo->findData(code) >= 0);
  emit combo->activated(combo->findData(code));
}

}  // namespace

TEST_CASE("comparing decks: sentences, jumps to fields, follows what is typed", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  DeckWindow window;
  window.show();
  window.compareWithSaved();
  CHECK(take_message(window).contains("not been saved"));
  window.document().save(path);
  window.document().edit(cell("pitchDia"), "0.0606");
  window.document().edit(cell("cageGsCls", 2), "6e-4");
  window.compareWithSaved();
  auto* dialog = window.findChild<CompareDialog*>("compare");
  REQUIRE(dialog != nullptr);
  auto* list = dialog->findChild<QListWidget*>("differences");
  const auto texts = [&] {
    QStringList out;
    for (int i = 0; i < list->count(); ++i) out << list->item(i)->text().trimmed();
    return out;
  };
  CHECK(dialog->findChild<QLabel*>("summary")->text().startsWith("2 differences from"));
  REQUIRE(texts().size() == 4);  // a heading for each record
  CHECK(texts()[0].startsWith("Record 5A"));
  CHECK(texts()[1] == "pitchDia: 0.0606 m here, 0.06 m there (0.99 % less)");
  CHECK(texts()[3] == "cageGsCls[2]: 6.0e-04 m here, 3.0e-04 m there (50 % less)");
  list->setCurrentRow(3);
  QTest::keyClick(list, Qt::Key_Return);
  CHECK(window.currentRecord() == "7.2.i");
  auto* table = window.page()->findChild<CellTable*>("instances");
  CHECK(table->cellAt(table->currentRow(), table->currentColumn()) == cell("cageGsCls", 2));
  window.undo();
  CHECK(texts().size() == 2);
  window.undo();
  CHECK(dialog->findChild<QLabel*>("summary")->text().startsWith("No difference"));
  CHECK(list->count() == 0);
  dialog->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

  // Another file, and an example with other units and other records.
  window.askForComparison();
  auto* chooser = window.findChild<QFileDialog*>("compare-open");
  REQUIRE(chooser != nullptr);
  emit chooser->fileSelected(QString::fromStdString(path.string()));
  CHECK(window.findChild<CompareDialog*>("compare")->shown().empty());
  auto* menu = window.findChild<QMenu*>("compare-menu");
  REQUIRE(menu != nullptr);
  for (QAction* action : menu->actions())
    if (action->text().endsWith("ball-english")) action->trigger();
  dialog = window.findChild<CompareDialog*>("compare");
  REQUIRE(dialog != nullptr);
  for (const deck::Difference& row : dialog->shown()) CHECK(row.variable != "pitchDia");
  for (QAction* action : menu->actions())
    if (action->text().endsWith("tapered")) action->trigger();
  dialog = window.findChild<CompareDialog*>("compare");
  CHECK(dialog->shown().size() > 10);
  list = dialog->findChild<QListWidget*>("differences");
  for (int i = 0; i < list->count(); ++i) emit list->itemClicked(list->item(i));
  CHECK(take_message(window).isEmpty());
}

TEST_CASE("adrinput: values in both unit systems → next to their fields, follow typing",
          "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  window.activateWindow();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  window.showRecord("3.2");
  auto* button = window.page()->findChild<QPushButton*>("other-units");
  REQUIRE(button != nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  CHECK(window.findChild<QAction*>("other-units-action")->isChecked());
  QLineEdit* line = line_of(window, cell("pitchDia"));
  CHECK(beside(window, "pitchDia") == "= 2.3622 in");
  line->selectAll();
  QTest::keyClicks(line, "0,0508");
  CHECK(beside(window, "pitchDia") == "= 2 in");
  QTest::keyClicks(line, "x");
  CHECK(beside(window, "pitchDia").isEmpty());  // no number
  window.undo();
  CHECK(beside(window, "pitchDia") == "= 2.3622 in");
  window.showRecord("7.2.i");  // a table
  const auto* table = window.page()->findChild<CellTable*>("instances");
  const auto under = [&](const Cell& at) {
    for (int row = 0; row < table->rowCount(); ++row)
      for (int column = 0; column < table->columnCount(); ++column)
        if (table->cellAt(row, column) == at)
          return table->item(row, column)->data(Qt::UserRole).toString();
    return QString("no such cell");
  };
  CHECK(under(cell("cageGsCls", 2)) == "0.011811 in");
  window.document().edit(cell("cageGsCls", 2), "0.0254");
  CHECK(under(cell("cageGsCls", 2)) == "1 in");
  QTest::keyClick(&window, Qt::Key_U, Qt::ControlModifier);
  CHECK(under(cell("cageGsCls", 2)).isEmpty());
}

TEST_CASE("changing kUnit offers to convert the numbers, as one step", "[gui][adrinput]") {
  test::use_qt();
  for (const char* type : {"ball", "tapered", "spherical-tapered"}) {
    DeckWindow window;
    window.show();
    window.newDeck(type);
    Document& document = window.document();
    auto* bar = window.findChild<NoticeBar*>("units-notice");
    REQUIRE(bar != nullptr);
    // A record that does not apply now is converted too, for the day when it comes back.
    document.edit(cell("nCseg"), "0");
    document.end_undo_step();
    const deck::Deck before = document.deck();
    const auto switch_units = [&] {
      window.showRecord("3.2");
      auto* combo = qobject_cast<QComboBox*>(window.page()->fieldOf(cell("kUnit").variable));
      combo->setFocus();
      QTest::keyClick(combo, combo->currentIndex() == 0 ? Qt::Key_Down : Qt::Key_Up);
    };
    switch_units();
    CHECK(bar->isVisible());
    press(window, "keep-numbers");
    CHECK_FALSE(bar->isVisible());
    CHECK(document.deck().real("brgBore") == before.real("brgBore"));
    window.undo();
    CHECK(document.deck() == before);
    CHECK_FALSE(bar->isVisible());

    switch_units();
    REQUIRE(bar->isVisible());
    press(window, "convert");
    CHECK_FALSE(bar->isVisible());
    CHECK(document.deck() == deck::in_units(before, deck::UnitSystem::English));
    CHECK(document.deck().si("brgBore") == Approx(before.si("brgBore")).epsilon(1e-11));
    document.edit(cell("nCseg"), "1");
    document.end_undo_step();
    CHECK(document.deck() == deck::in_units(deck::new_deck(type), deck::UnitSystem::English));
    window.undo();
    window.undo();
    CHECK(document.deck() == before);  // one step back over both
    window.redo();
    CHECK(document.deck() == deck::in_units(before, deck::UnitSystem::English));
    switch_units();
    press(window, "convert");
    CHECK(document.deck() == before);  // there and back

    // The question stays until it is answered; what is typed meanwhile is in the new units.
    switch_units();
    REQUIRE(bar->isVisible());
    document.edit(cell("appLoadX"), "77");
    CHECK(bar->isVisible());
    press(window, "convert");
    CHECK_FALSE(bar->isVisible());
    CHECK(document.deck().real("appLoadX") == 77.0);
  }
}

TEST_CASE("run options: page, ADORE.json in the deck folder, unknown names kept",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  const fs::path file = folder.filePath("ADORE.json").toStdString();
  {
    DeckWindow window;
    window.show();
    CHECK(window.document().pages().back() == kOptionsPage);
    window.showRecord(std::string(kOptionsPage));
    for (const runs::RunOptionInfo& info : runs::run_options()) {
      QWidget* field = window.page()->fieldOf(option(info.name).variable);
      if (const auto* combo = qobject_cast<QComboBox*>(field)) {
        CHECK_FALSE(info.choices.empty());
        CHECK(combo->currentData().toString().toStdString() == info.default_value);
        continue;
      }
      auto* line = qobject_cast<QLineEdit*>(field);
      REQUIRE(line != nullptr);
      CHECK(line->text().toStdString() == info.default_value);
    }
    window.document().save(path);
    CHECK_FALSE(fs::exists(file));  // no messages
    replace_text(line_of(window, option("lifeSkip")), "2,5");
    CHECK(line_of(window, option("lifeSkip"))->text() == "2.5");
    replace_text(line_of(window, option("rollerSlices")), "4000");
    CHECK(window.document().has_errors());
    CHECK(window.page()->findChild<QLabel*>("problem-rollerSlices")->text().contains("1 to 999"));
    window.showRecord("1");
    window.nextProblem();
    CHECK(window.currentRecord() == kOptionsPage);
    CHECK_THROWS_AS(window.document().save(path), InputError);
    CHECK_FALSE(fs::exists(file));
    window.undo();
    CHECK_FALSE(window.document().has_errors());
    CHECK(window.document().modified());
    window.undo();
    CHECK_FALSE(window.document().modified());
    window.redo();
    choose(window, option("contactSurface"), "flat_edge");
    replace_text(line_of(window, option("seed")), "");  // the default
    CHECK(line_of(window, option("seed"))->text() == "1");
    window.document().save(path);
  }
  CHECK(runs::options_of_deck(path) ==
        std::map<std::string, std::string>{{"lifeSkip", "2.5"}, {"contactSurface", "flat_edge"}});

  std::ofstream(file) << R"({"myNote": {"by": "me"}, "ellipseMinor": 6, "lifeElement": "all"})";
  {
    DeckWindow window;
    window.show();
    window.openFile(path);
    CHECK(line_of(window, option("ellipseMinor"))->text() == "6");
    int reported = 0;
    for (const Problem& problem : window.document().problems())
      if (problem.page == kOptionsPage) ++reported;
    CHECK(reported == 2);
    CHECK_FALSE(window.document().has_errors());  // the deck itself may be saved
    const std::string as_it_was = bytes_of(file);
    window.document().edit(cell("pitchDia"), "0.0601");
    window.document().save(path);
    CHECK(bytes_of(file) == as_it_was);  // untouched while no option changes
    replace_text(line_of(window, option("landSlices")), "7");
    window.document().save(path);
  }
  const std::string text = bytes_of(file);
  for (const char* part :
       {"myNote", "\"by\"", "\"ellipseMinor\": 6", "lifeElement", "\"landSlices\": 7"})
    CHECK(text.find(part) != std::string::npos);

  // A file that is not JSON is unchanged, then kept as a copy when an option is set.
  std::ofstream(file) << "{ not json";
  {
    DeckWindow window;
    window.show();
    window.openFile(path);
    REQUIRE_FALSE(window.document().problems().empty());
    CHECK(window.document().problems()[0].issue.message.find("not valid JSON") !=
          std::string::npos);
    window.document().save(path);
    CHECK(bytes_of(file) == "{ not json");
    replace_text(line_of(window, option("landSlices")), "7");
    window.document().save(path);
    CHECK(bytes_of(file.string() + ".bak") == "{ not json");
    CHECK(runs::options_of_deck(path).at("landSlices") == "7");
  }
}

TEST_CASE("run options: choices, times with units and effect names", "[gui][adrinput]") {
  test::use_qt();
  for (const runs::RunOptionInfo& info : runs::run_options()) {
    INFO(info.name);
    const bool number = info.default_value.find_first_not_of("0123456789.") == std::string::npos;
    if (info.name != "effectsOff" && !number) CHECK_FALSE(info.choices.empty());
    // A number that only 0 and 1 are valid for is a switch.
    if (number && runs::option_problem(info.name, "1").empty() &&
        runs::option_problem(info.name, "0").empty() &&
        !runs::option_problem(info.name, "2").empty())
      CHECK(info.choices == std::vector<std::string>{"1", "0"});
    for (const std::string& choice : info.choices)
      CHECK(runs::option_problem(info.name, choice) == "");
  }
  DeckWindow window;
  window.show();
  window.document().check_model();
  window.showRecord(std::string(kOptionsPage));
  const auto typed = [&](const char* name, const char* text) {
    replace_text(line_of(window, option(name)), text);
    return line_of(window, option(name))->text().toStdString();
  };
  CHECK(typed("userTimeout", "500 ms") == "0.5");
  CHECK(typed("checkpointSeconds", "2 min") == "120");
  CHECK(typed("userTimeout", "3 mm") == "3 mm");
  CHECK(window.document().has_errors());
  CHECK(typed("userTimeout", "4") == "4");
  CHECK_FALSE(window.document().has_errors());

  const auto names = [&] {
    QStringList out;
    auto* button = window.page()->findChild<QToolButton*>("effect-names");
    emit button->menu()->aboutToShow();
    for (const QAction* action : button->menu()->actions()) out << action->text();
    return out;
  };
  CHECK(names().contains("without gravity"));
  CHECK_FALSE(names().contains("without ball / race contact"));  // that makes the scene
  const auto toggle = [&](const QString& text) {
    auto* button = window.page()->findChild<QToolButton*>("effect-names");
    emit button->menu()->aboutToShow();
    for (QAction* action : button->menu()->actions())
      if (action->text() == text) return action->trigger();
  };
  // Every name that is offered is one that a run takes.
  for (const QString& name : names()) {
    toggle(name);
    window.document().check_model();
    CHECK(window.document().options().at("effectsOff") == name.mid(8).toStdString());
    const auto ready = [&] {
      runs::DeckRequest request;
      request.text = deck::write_deck(window.document().deck());
      request.in_memory = true;
      for (const auto& [option_name, value] : window.document().options())
        request.options.emplace_back(option_name, value);
      return runs::plan(request);
    };
    CHECK_NOTHROW(ready());
    toggle(name);
  }
  CHECK(window.document().options().count("effectsOff") == 0);
  toggle("without gravity");
  toggle("without momentum ledger");
  CHECK(line_of(window, option("effectsOff"))->text() == "gravity,momentum ledger");
  window.document().edit(cell("mode"), "-1");
  window.document().check_model();
  CHECK(names().size() == 2);  // effects that are already off can be switched on again
}

TEST_CASE("lines for user routines: edited and saved without changes", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  const std::string raw = "'mine' 1,5  2.0\n   3*0.5, \"x\" / rest\n12.2 \xC3\xA4\xC3\xB6 !\n";
  std::ofstream(path, std::ios::binary) << deck::write_deck(deck::new_deck("ball")) << raw;
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(path));
  window.showRecord("12");
  auto* lines = window.page()->findChild<QPlainTextEdit*>("lines");
  REQUIRE(lines != nullptr);
  CHECK(lines->toPlainText().toStdString() + "\n" == raw);
  QTest::keyClick(lines, Qt::Key_End, Qt::ControlModifier);
  QTest::keyClick(lines, Qt::Key_Return);
  QTest::keyClicks(lines, "last, 7,5");
  window.save();
  CHECK(take_message(window).isEmpty());
  const std::string written = bytes_of(path);
  CHECK(written.ends_with(raw + "last, 7,5\n"));
  CHECK(deck::read_deck(path).deck == window.document().deck());
}

TEST_CASE("decimal comma: accepted in all fields, never written to a file", "[gui][adrinput]") {
  test::use_qt();
  const QLocale old = QLocale();
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  const std::string old_c = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  {
    DeckWindow window;
    window.show();
    window.activateWindow();
    REQUIRE(QTest::qWaitForWindowActive(&window));
    replace_text(line_of(window, cell("pitchDia")), "0,0605");
    // In a table: typed, and pasted from a spreadsheet.
    window.showRecord("7.2.i");
    auto* table = window.page()->findChild<CellTable*>("instances");
    REQUIRE(table->focusCell(cell("cageGsCls", 1)));
    QTest::keyClick(table, Qt::Key_F2);
    auto* editor = table->viewport()->findChild<QLineEdit*>();
    REQUIRE(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, "0,00035");
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QApplication::clipboard()->setText("0,00031\t0,00032\n");
    REQUIRE(table->focusCell(cell("cageGsCls", 1)));
    QTest::keyClick(table, Qt::Key_V, Qt::ControlModifier);
    CHECK(window.document().deck().real("cageGsCls", 1) == 0.00031);
    CHECK(window.document().deck().real("cageGsCls", 2) == 0.00032);
    // Pasted into a field, and an option.
    QApplication::clipboard()->setText("0,0127");
    QLineEdit* line = line_of(window, cell("bReDia"));
    line->setFocus();
    line->selectAll();
    QTest::keyClick(line, Qt::Key_V, Qt::ControlModifier);
    QTest::keyClick(line, Qt::Key_Return);
    CHECK(line->text() == "0.0127");
    replace_text(line_of(window, option("checkpointSeconds")), "12,5");
    // Units: shown and converted.
    window.findChild<QAction*>("other-units-action")->setChecked(true);
    window.showRecord("5A");
    CHECK(beside(window, "bReDia") == "= 0.5 in");
    window.document().edit(cell("kUnit"), "2");
    press(window, "convert");
    CHECK(window.document().deck().real("bReDia") == 0.5);
    window.save();
    if (auto* dialog = window.findChild<QFileDialog*>("save"))
      emit dialog->fileSelected(QString::fromStdString(path.string()));
    CHECK(take_message(window).isEmpty());
  }
  const std::string text = bytes_of(path);
  const deck::ReadResult back = deck::read_deck(path);
  const std::string options = bytes_of(folder.filePath("ADORE.json").toStdString());
  std::setlocale(LC_ALL, old_c.c_str());
  QLocale::setDefault(old);
  REQUIRE(back.ok());
  CHECK(back.deck.real("pitchDia") == Approx(0.0605 / 0.0254).epsilon(1e-11));
  CHECK(back.deck.real("cageGsCls", 2) == Approx(0.00032 / 0.0254).epsilon(1e-11));
  CHECK(options.find("12.5") != std::string::npos);
  CHECK(text.find("0,5") == std::string::npos);
}

TEST_CASE("damaged deck of 5 MB: opens, lists problems, can be edited", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::string text(deck::template_text("ball"));
  const std::string whole = text;
  while (text.size() < 5000000) text += whole + "1.0, 2.0, abc 'no end\r\n";
  std::ofstream(path, std::ios::binary) << text;
  DeckWindow window;
  window.show();
  QElapsedTimer clock;
  clock.start();
  REQUIRE(window.openFile(path));
  QCoreApplication::processEvents();
  CHECK(clock.elapsed() < 10000);
  CHECK(window.document().original() == text);
  CHECK(window.document().has_errors() == false);
  CHECK_FALSE(window.document().problems().empty());
  clock.restart();
  line_of(window, cell("pitchDia"))->setText("");
  QTest::keyClicks(line_of(window, cell("pitchDia")), "0,06");
  QCoreApplication::processEvents();
  CHECK(clock.elapsed() < 10000);
  CHECK(window.document().deck().real("pitchDia") == 0.06);
}
