#include "adrinput/accuracy_panel.hpp"
#include "adrinput/catalogue_dialog.hpp"
#include "adrinput/cell_table.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/drawing_view.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/search.hpp"
#include "adrinput/solution_charts.hpp"
#include "adrinput/start_check.hpp"
#include "adrinput/unit_choice.hpp"
#include "deck/templates.hpp"
#include "desktop/theme.hpp"
#include "facade/run.hpp"
#include "support/qt_app.hpp"

#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QCompleter>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QStatusBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

QLineEdit* line_of(DeckWindow& window, const char* name) {
  window.showRecord(cell(name).record);
  auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell(name).variable));
  REQUIRE(line != nullptr);
  return line;
}

QString beside(DeckWindow& window, const char* name) {
  auto* label = window.page()->findChild<QLabel*>(QString("other-") + name);
  REQUIRE(label != nullptr);
  return label->text();
}

}  // namespace

TEST_CASE("a half-typed quantity is never a value; the whole one is, in the deck's unit",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  QLineEdit* line = line_of(window, "bReDia");
  line->selectAll();
  QTest::keyClicks(line, "12.8");
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  QTest::keyClicks(line, " m");
  CHECK(beside(window, "bReDia") == "= 12.8 m");  // what it would be is seen before it is taken
  QTest::keyClicks(line, "m");
  CHECK(beside(window, "bReDia") == "= 0.0128 m");
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  QTest::keyClick(line, Qt::Key_Return);
  CHECK(window.document().deck().real("bReDia") == 0.0128);
  CHECK(line->text() == "0.0128");
  window.undo();
  CHECK(line->text() == "0.0127");
  CHECK_FALSE(window.document().can_undo());
  replace_text(line, "1/2 in");
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  CHECK_FALSE(window.document().can_undo());  // the same as before: no step
  replace_text(line, "5-3");
  CHECK(window.document().has_errors());
  CHECK(window.page()->findChild<QLabel*>("problem-bReDia")->text().contains("5e-3 or 5 - 3"));
}

TEST_CASE("values are shown in a unit of choice, and the deck keeps its own",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  const deck::Deck before = window.document().deck();
  choose_unit("m", "mm");
  choose_unit("K", "°C");
  QLineEdit* line = line_of(window, "bReDia");
  CHECK(line->text() == "12.7 mm");
  QTest::keyClick(line, Qt::Key_End);
  CHECK(line_of(window, "roomTemp")->text() == "20 °C");
  CHECK(window.document().deck() == before);
  line = line_of(window, "bReDia");
  replace_text(line, "13 mm");
  CHECK(window.document().deck().real("bReDia") == 0.013);
  CHECK(line->text() == "13 mm");
  replace_text(line, "12.7");  // without a unit: in the unit that the field is shown in
  CHECK(line->text() == "12.7 mm");
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  replace_text(line, "0.013 m");
  CHECK(line->text() == "13 mm");
  for (const auto& [typed, metres] : {std::pair{"3*4", 0.012},
                                      {"12,5", 0.0125},
                                      {"1/2 in", 0.0127},
                                      {"1.25e1", 0.0125},
                                      {"127e-1", 0.0127},
                                      {"2+9", 0.011},
                                      {"10 - 1/2", 0.0095},
                                      {"(1+2)*4", 0.012},
                                      {"30/3", 0.01}}) {
    INFO(typed);
    replace_text(line, typed);
    CHECK(window.document().deck().real("bReDia") == Approx(metres).epsilon(1e-14));
  }
  // The same digits as the deck has, in another unit: no text of "no change".
  choose_unit("N", "kN");
  line = line_of(window, "appLoadX");
  replace_text(line, "3 N");
  CHECK(window.document().deck().real("appLoadX") == 3.0);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QString::fromStdString(window.document().text(cell("appLoadX"))));
  CHECK(beside(window, "appLoadX") == "= 3000.0 N");
  QTest::keyClick(line, Qt::Key_Return);
  CHECK(window.document().deck().real("appLoadX") == 3000.0);
  CHECK(line->text() == "3 kN");
  choose_unit("m", {});
  choose_unit("K", {});
  choose_unit("N", {});
}

TEST_CASE("a deck with an error is parked as a draft and comes back as it was",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  const QString draft = folder.filePath("half.draft");
  {
    DeckWindow window;
    window.show();
    replace_text(line_of(window, "bReDia"), "unknown");
    replace_text(line_of(window, "pitchDia"), "61 mm");
    window.document().save_draft(draft.toStdString());
    CHECK_FALSE(window.document().modified());
    CHECK(window.windowTitle().contains("half.draft"));
    CHECK_THROWS_AS(window.document().save(folder.filePath("DATA.txt").toStdString()), InputError);
  }
  CHECK_THROWS_AS(deck::read_deck(draft.toStdString()), InputError);  // no run takes it
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(draft.toStdString()));
  CHECK(window.document().deck().real("pitchDia") == 0.061);
  CHECK(line_of(window, "bReDia")->text() == "unknown");
  CHECK_FALSE(window.document().modified());
  replace_text(line_of(window, "bReDia"), "12.7 mm");
  window.document().save(folder.filePath("DATA.txt").toStdString());
  CHECK_FALSE(fs::exists(draft.toStdString()));  // it became the deck
  CHECK(deck::read_deck(folder.filePath("DATA.txt").toStdString()).deck.real("pitchDia") == 0.061);
  // The refused save offers to park it.
  replace_text(line_of(window, "bReDia"), "unknown");
  window.save();
  auto* box = window.findChild<QMessageBox*>("message");
  REQUIRE(box != nullptr);
  REQUIRE(box->findChild<QPushButton*>("park-draft") != nullptr);
  box->close();
}

TEST_CASE("a deck's remarks survive a save that changes options", "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::ofstream(path) << deck::template_text("ball");
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(path));
  window.document().edit(cell("kReGeoImp"), "2");  // four records come
  window.document().edit(cell("reDiaVar7"), "1e-6");
  window.document().save(path);
  const std::string text = bytes_of(path);
  CHECK(text.find("stpInit stpMin stpMax fTime tol qFac") != std::string::npos);
  CHECK(text.find("D, dm, contact angle") != std::string::npos);
  CHECK_FALSE(fs::exists(path.string() + ".bak"));
  CHECK(deck::read_deck(path).deck == window.document().deck());
}

TEST_CASE("after a change of units the remarks name the new ones, or a note says whose do not",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::string text(deck::template_text("ball"));
  const std::string own = "bore, OD, shaft bore, housing OD, race widths [m]";
  REQUIRE(text.find(own) != std::string::npos);
  text.replace(text.find(own), own.size(), "bore 40 mm, from our drawing");
  std::ofstream(path) << text;
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(path));
  const auto notes = [&] {
    std::vector<std::string> records;
    for (const Problem& problem : window.document().problems())
      if (problem.issue.message.find("remark behind its values") != std::string::npos)
        records.push_back(problem.page);
    return records;
  };
  window.document().edit(cell("kUnit"), "2");
  window.document().convert_values();
  window.save();
  CHECK(bytes_of(path).find("displacements [lbf, in]") != std::string::npos);
  CHECK(bytes_of(path).find("bore 40 mm, from our drawing") != std::string::npos);
  CHECK(notes() == std::vector<std::string>{"4"});
  window.document().edit(cell("kUnit"), "1");
  window.document().convert_values();
  window.save();
  CHECK(bytes_of(path).find("displacements [N, m]") != std::string::npos);
  CHECK(notes().empty());
}

TEST_CASE("forty deviations are one table, and a pasted row or column fills it",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.document().edit(cell("kReGeoImp"), "2");
  window.showRecord("5G.1D.1");
  auto* table = window.page()->findChild<CellTable*>("deviations");
  REQUIRE(table != nullptr);
  CHECK(table->rowCount() * table->columnCount() == 40);
  QStringList row, column;
  for (int k = 1; k <= 40; ++k) row << QString("%1e-7").arg(k);
  QApplication::clipboard()->setText(row.join('\t') + "\n");
  table->setFocus();
  table->setCurrentCell(0, 0);
  QTest::keyClick(table, Qt::Key_V, Qt::ControlModifier);
  CHECK(window.document().deck().real("reDiaVar1") == 1e-7);
  CHECK(window.document().deck().real("reDiaVar12") == 12e-7);
  CHECK(window.document().deck().real("reDiaVar40") == 40e-7);
  QApplication::clipboard()->setText("0,5 µm\n-0,25 µm\r\n");
  table->setCurrentCell(1, 1);  // element 12
  QTest::keyClick(table, Qt::Key_V, Qt::ControlModifier);
  CHECK(window.document().deck().real("reDiaVar12") == 0.5e-6);
  CHECK(window.document().deck().real("reDiaVar13") == -0.25e-6);
  CHECK(window.document().deck().real("reDiaVar14") == 14e-7);
  // One paste is one step of undo.
  window.document().undo();
  CHECK(window.document().deck().real("reDiaVar12") == 12e-7);
  CHECK(window.document().deck().real("reDiaVar13") == 13e-7);
  window.document().undo();
  for (const char* name : {"reDiaVar1", "reDiaVar12", "reDiaVar40"})
    CHECK(window.document().deck().real(name) == 0.0);
  // The editor that a click opens takes a list into the table, and one value into its cell.
  table->setCurrentCell(0, 0);
  const auto paste_into_editor = [&](const QString& text) {
    QApplication::clipboard()->setText(text);
    table->editItem(table->item(0, 0));
    auto* editor = table->viewport()->findChild<QLineEdit*>();
    REQUIRE(editor != nullptr);
    editor->selectAll();
    QTest::keyClick(editor, Qt::Key_V, Qt::ControlModifier);
    QTest::keyClick(table, Qt::Key_Return);
    table->setFocus();
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  for (const QString& list : {row.join('\t'), row.join('\n'), row.join(' '), row.join("; ")}) {
    paste_into_editor(list);
    CHECK(window.document().deck().real("reDiaVar1") == 1e-7);
    CHECK(window.document().deck().real("reDiaVar40") == 40e-7);
    window.document().undo();
    CHECK(window.document().deck().real("reDiaVar1") == 0.0);
  }
  QApplication::clipboard()->setText("0.5 µm");
  table->editItem(table->item(0, 0));
  auto* editor = table->viewport()->findChild<QLineEdit*>();
  REQUIRE(editor != nullptr);
  editor->selectAll();
  QTest::keyClick(editor, Qt::Key_V, Qt::ControlModifier);
  CHECK(editor->text() == QString::fromUtf8("0.5 µm"));
}

TEST_CASE("a wrong value leaves what the deck does not use pale", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.document().edit(cell("kReGeoImp"), "2");
  window.checkNow();
  const Cell absent = cell("reDiaVar40");
  REQUIRE_FALSE(window.document().unused_because(absent).empty());
  window.document().edit(cell("reDiaVar3"), "abc");
  window.checkNow();
  CHECK(window.document().has_errors());
  CHECK_FALSE(window.document().unused_because(absent).empty());
}

TEST_CASE("another deck has nothing of what was computed for the one before",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  for (const char* next : {"cylindrical", "ball"}) {
    INFO(next);
    window.runQuasiStatic();
    REQUIRE(QTest::qWaitFor([&] { return !window.staticsPanel().busy(); }, 60000));
    CHECK(window.staticsPanel().tables() != nullptr);
    CHECK_FALSE(window.solutionCharts().pages().isEmpty());
    window.newDeck(next);
    CHECK(window.staticsPanel().tables() == nullptr);
    CHECK(window.staticsPanel().text().isEmpty());
    CHECK(window.staticsPanel().headline().isEmpty());
    CHECK(window.solutionCharts().pages().isEmpty());
    for (const QLabel* note : window.findChildren<QLabel*>()) {
      INFO(note->text().toStdString());
      CHECK_FALSE(note->text().contains("before the last change"));
    }
  }
  // One that is still computed is of the deck that was there.
  window.runQuasiStatic();
  window.newDeck("tapered");
  REQUIRE(QTest::qWaitFor([&] { return !window.staticsPanel().busy(); }, 60000));
  CHECK(window.staticsPanel().tables() == nullptr);
  CHECK(window.solutionCharts().pages().isEmpty());
}

TEST_CASE("bodies and vectors have names", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showRecord("3.4");
  auto* bodies = qobject_cast<CellTable*>(window.page()->fieldOf(cell("kPltElemInd").variable));
  REQUIRE(bodies != nullptr);
  CHECK(bodies->item(0, 2)->text() == QString("13 — cage"));
  CHECK(bodies->item(0, 3)->text() == QString("15 — inner race"));
  window.showRecord("9.6");
  auto* place = qobject_cast<CellTable*>(window.page()->fieldOf(cell("cageGcPos").variable));
  REQUIRE(place != nullptr);
  CHECK(place->horizontalHeaderItem(0)->text() == "x");
  CHECK(place->horizontalHeaderItem(2)->text() == "z");
}

TEST_CASE("what a deck's options leave unused looks unused, with the reason",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.document().edit(cell("mode"), "-1");
  window.checkNow();
  const Cell steps = cell("maxStps");
  CHECK_FALSE(window.document().unused_because(steps).empty());
  window.showRecord("1");
  auto* said = window.page()->findChild<QLabel*>("unused-maxStps");
  REQUIRE(said != nullptr);
  CHECK(said->text().startsWith("Not used now"));
  CHECK(said->isVisibleTo(window.page()));
  window.document().edit(cell("mode"), "0");
  window.checkNow();
  CHECK(window.document().unused_because(steps).empty());
  CHECK_FALSE(said->isVisibleTo(window.page()));
}

TEST_CASE("deviations of elements that are not there are pale, with other units beside them too",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.document().edit(cell("kReGeoImp"), "2");
  window.checkNow();
  const QColor text = desktop::current_theme().text;
  for (const bool others : {false, true}) {
    INFO("other units: " << others);
    window.showRecord("5G.1D.2");
    window.page()->setOtherUnits(others);
    auto* table = window.page()->findChild<CellTable*>();
    REQUIRE(table != nullptr);
    table->setCurrentCell(0, 0);
    const QImage image = table->viewport()->grab().toImage();
    const auto dark = [&](int row, int column) {
      const QRect rect = table->visualItemRect(table->item(row, column)).adjusted(3, 3, -3, -3);
      int count = 0;
      for (int y = rect.top(); y < rect.bottom(); ++y)
        for (int x = rect.left(); x < rect.right(); ++x) count += image.pixelColor(x, y) == text;
      return count;
    };
    CHECK(dark(1, 1) > 0);   // of 12 elements the last
    CHECK(dark(1, 2) == 0);  // there is no 13th
    CHECK(dark(3, 3) == 0);
  }
}

TEST_CASE("search goes to the option that would show a field, and can set it",
          "[gui][adrinput][daily]") {
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
  // What was found knows that it is there now.
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
  // What was said of one search goes with the next one.
  for (const char* found : {"bReDia", "kTherm"}) {
    window.goTo(cell("kBaseTemp"));
    CHECK(notice->isVisibleTo(&window));
    window.goTo(cell(found));
    CHECK_FALSE(notice->isVisibleTo(&window));
  }
  // The way that is named leads there; nearly every record has one.
  int ways = 0, none = 0;
  for (const deck::RecordSpec& spec : deck::schema()) {
    if (window.document().instances(spec.id) > 0 || spec.id == "12") continue;
    INFO(spec.id);
    const std::optional<OptionWay> way = way_to(window.document().deck(), spec.id);
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

TEST_CASE("times of a run are shown and typed in seconds and turns", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showRecord("2.1");
  REQUIRE(QTest::qWaitFor([&] { return window.document().scales().has_value(); }, 60000));
  CHECK(beside(window, "fTime").contains("revolutions"));
  const facade::RunScales scales = *window.document().scales();
  CHECK(scales.turns_per_second == Approx(10000.0 / 60.0));
  QLineEdit* line = line_of(window, "fTime");
  replace_text(line, "5 rev");
  CHECK(window.document().deck().real("fTime") * scales.time * scales.turns_per_second ==
        Approx(5.0).epsilon(1e-12));
  CHECK(beside(window, "fTime").contains("= 5 revolutions"));
  replace_text(line, "20 ms");
  CHECK(window.document().deck().real("fTime") * scales.time == Approx(0.02).epsilon(1e-12));
  replace_text(line, "3 mm");
  CHECK(window.document().has_errors());
}

TEST_CASE("a designation makes a deck, with what is standard and what is estimated said",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  DeckWindow window;
  window.show();
  window.newFromCatalogue();
  auto* dialog = window.findChild<CatalogueDialog*>("catalogue");
  REQUIRE(dialog != nullptr);
  auto* name = dialog->findChild<QLineEdit*>("designation");
  auto* take = dialog->findChild<QPushButton*>("take");
  CHECK_FALSE(take->isEnabled());
  QTest::keyClicks(name, "62055");
  CHECK_FALSE(take->isEnabled());
  // The list of what goes on like that goes when it has no more to say: it lies over the story.
  const auto* list = name->completer()->popup();
  name->clear();
  QTest::keyClicks(name, "NU2");
  CHECK(list->isVisible());
  QTest::keyClicks(name, "09");
  QTest::qWait(50);
  CHECK_FALSE(list->isVisible());
  name->setText("NU209");
  CHECK(take->isEnabled());
  CHECK(dialog->story().contains("ISO 15"));
  CHECK(dialog->story().contains("ESTIMATE"));
  QTest::mouseClick(take, Qt::LeftButton);
  CHECK(window.document().deck().real("brgOD") == 0.085);
  CHECK(window.currentRecord() == "4");
  CHECK_FALSE(window.document().has_errors());
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  window.document().save(path);
  CHECK(bytes_of(path).find("ESTIMATE of the inside") != std::string::npos);
  // The inside of another size, from bore, outside diameter and widths.
  window.document().change({{"brgBore", "0.05"}, {"brgOD", "0.09"}});
  window.proposeInside();
  CHECK(take_message(window).contains("estimate"));
  CHECK(window.document().deck().real("pitchDia") == Approx(0.07));
  window.undo();
  CHECK(window.document().deck().real("pitchDia") == 0.065);
}

TEST_CASE("the solution has its charts beside the form", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  CHECK(window.solutionCharts().pages().isEmpty());
  window.runQuasiStatic();
  REQUIRE(QTest::qWaitFor([&] { return !window.staticsPanel().busy(); }, 60000));
  const QStringList pages = window.solutionCharts().pages();
  CHECK(pages.contains("Load around the bearing"));
  CHECK(pages.contains("Contact ellipses around the bearing"));
  CHECK(window.solutionCharts().isVisible());
  // With them it still fits 1920 x 1080 pixels at a scale factor of 2, frame included.
  CHECK(window.minimumSizeHint().width() <= 944);
  CHECK(window.minimumSizeHint().height() <= 492);
  window.document().edit(cell("bReDia"), "0.0126");
  window.checkNow();
  bool stale = false;
  for (const QLabel* label : window.solutionCharts().findChildren<QLabel*>())
    stale = stale || (label->isVisible() && label->text().contains("before the last change"));
  CHECK(stale);
}

TEST_CASE("the plan says what each effect costs", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showPlan();
  REQUIRE(QTest::qWaitFor([&] { return !window.planPanel().busy(); }, 60000));
  const QString text = window.planPanel().text();
  CHECK(text.contains("cost of the effects"));
  CHECK(text.contains("%"));
  CHECK(text.contains("kTracType"));  // why an effect is on
}

TEST_CASE("an accuracy study shows its rows, and its advice goes into the deck",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  AccuracyPanel& panel = window.accuracyPanel();
  panel.study = [](const facade::AccuracyRequest& request, const facade::AccuracySink& row_done,
                   std::stop_token) {
    CHECK(request.text.has_value());
    facade::AccuracyStudy study;
    facade::AccuracyRow row;
    row.setting.name = "rkf6, tol 1e-05";
    row.setting.method = "rkf6";
    row.setting.tolerance = 1e-5;
    row.seconds = 1.5;
    row.turns = 10.0;
    study.finals.push_back(row);
    study.recommended = 0;
    study.target = request.target;
    study.complete = true;
    row_done(row, study);
    return study;
  };
  window.studyAccuracy();
  REQUIRE(QTest::qWaitFor([&] { return !panel.busy() && !panel.recommended().empty(); }, 10000));
  CHECK(panel.text().contains("rkf6"));
  press(window, "apply-accuracy");
  CHECK(window.document().deck().integer("intMet") == 6);
  CHECK(window.document().deck().real("tol") == 1e-5);
  window.undo();
  CHECK(window.document().deck().integer("intMet") == 5);

  // What changes while a study goes on leaves its end with the deck that it is of.
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath("DATA.txt").toStdString();
  window.document().save(file);
  const auto note = [&] { return window.findChild<QLabel*>("study-note")->text(); };
  const QString advice = "\"Put into the deck\" sets";
  const auto plain = panel.study;
  for (const bool reread : {false, true}) {
    INFO(reread);
    std::atomic<bool> go_on = false;
    panel.study = [&go_on, plain](const facade::AccuracyRequest& request,
                                  const facade::AccuracySink& row_done, std::stop_token stop) {
      while (!go_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return plain(request, row_done, stop);
    };
    window.studyAccuracy();
    REQUIRE(panel.busy());
    window.document().edit(cell("appLoadZ"), reread ? "1234" : "1235");
    window.document().save(file);
    if (reread) REQUIRE(window.openFile(file));
    go_on = true;
    REQUIRE(QTest::qWaitFor([&] { return !panel.busy(); }, 10000));
    INFO(note().toStdString());
    CHECK(note().startsWith(reread ? "Of the deck as it was before its file was read again"
                                   : "Of the deck as it was before the last change"));
    CHECK(note().contains(advice) != reread);
    CHECK(window.findChild<QPushButton*>("apply-accuracy")->isEnabled() != reread);
  }
}

TEST_CASE("what only the run itself refuses is told beside the records, and leads to the reason",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  DeckWindow window;
  window.resize(700, 450);
  window.show();
  auto* state = window.findChild<QToolButton*>("deck-state");
  REQUIRE(state != nullptr);
  const auto says = [&](const QString& text) {
    return QTest::qWaitFor([&] { return state->text() == text; }, 60000);
  };
  REQUIRE(says("Ready to run"));
  CHECK(state->fontMetrics().horizontalAdvance(state->text()) < state->width() - 24);
  // A method that is for balls alone.
  window.newDeck("cylindrical");
  REQUIRE(says("Ready to run"));
  window.document().edit(cell("intMet"), "33");
  window.document().end_step();
  window.checkNow();
  REQUIRE(says("Run refused"));
  const auto* problems = window.findChild<QListWidget*>("problems");
  CHECK(problems->item(0)->text().startsWith("Refused"));
  CHECK(problems->item(0)->text().contains("arkode-imex"));
  CHECK(window.document().state_of("1") == RecordState::Doubtful);  // of intMet
  QTest::mouseClick(state, Qt::LeftButton);
  CHECK(problems->isVisible());
  CHECK(problems->currentRow() == 0);
  window.document().edit(cell("appLoadZ"), "much");
  window.checkNow();
  CHECK(state->text() == "1 error");
  window.undo();
  window.undo();
  CHECK(says("Ready to run"));
  // A run to go on with that is not there, until there is one.
  window.newDeck("ball");
  for (const auto& [name, value] :
       {std::pair{"maxStps", "4"}, std::pair{"kIcOpt", "1"}, std::pair{"kAGraf", "0"}})
    window.document().edit(cell(name), value);
  window.document().save(folder.filePath("DATA.txt").toStdString());
  window.checkNow();
  REQUIRE(says("Run refused"));
  CHECK(problems->item(0)->text().contains("kIcOpt"));
  facade::RunRequest first;
  first.deck = folder.filePath("DATA.txt").toStdString();
  first.sets = {{"kIcOpt", "0"}};
  (void)facade::run(first);
  emit window.runPanel().finished();
  CHECK(says("Ready to run"));
}

TEST_CASE("a deck that comes back while another one is asked about gets its answer",
          "[gui][adrinput][daily]") {
  test::use_qt();
  Document document;
  document.edit(cell("kStif"), "1000");  // a table that can be given up at each of its speeds
  for (const auto& [name, rpm] : {std::pair{"pctDisp", "1"}, std::pair{"rpmRange12", "1000"},
                                  std::pair{"rpmRange22", "9000"}})
    document.edit(cell(name), rpm);
  REQUIRE_FALSE(document.has_errors());
  const Document::Candidate first = document.candidate();
  document.edit(cell("appLoadX"), "1501");
  const Document::Candidate second = document.candidate();
  StartCheck check;
  std::vector<Document::Candidate> answers;
  check.found = [&](const Document::Candidate& of, const std::vector<Issue>&) {
    answers.push_back(of);
  };
  check.ask(first);
  check.ask(second);
  check.ask(first);  // undone
  REQUIRE(QTest::qWaitFor([&] { return !check.busy(); }, 60000));
  REQUIRE(answers.size() == 1);
  CHECK(answers.front() == first);
}

TEST_CASE("what is found out when a run ends is asked anew, the old answer does not count",
          "[gui][adrinput][daily]") {
  test::use_qt();
  Document document;
  const Document::Candidate asked = document.candidate();
  StartCheck check;
  int answers = 0;
  check.found = [&](const Document::Candidate&, const std::vector<Issue>&) { ++answers; };
  const auto wait = [&] { REQUIRE(QTest::qWaitFor([&] { return !check.busy(); }, 60000)); };
  check.ask(asked);
  check.forget();
  wait();
  CHECK(answers == 0);
  check.ask(asked);
  check.forget();
  check.ask(asked);  // the same deck beside other files
  wait();
  CHECK(answers == 1);
}

TEST_CASE("an answer in the background does not keep an edit from being checked",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  auto* state = window.findChild<QToolButton*>("deck-state");
  auto* check = window.findChild<StartCheck*>();
  REQUIRE(state != nullptr);
  REQUIRE(check != nullptr);
  const auto says = [&](const QString& text) {
    return QTest::qWaitFor([&] { return state->text() == text; }, 60000);
  };
  window.document().edit(cell("kDOF"), "6");  // needs a routine of the user
  window.document().end_step();
  window.checkNow();
  REQUIRE(says("Run refused"));
  const Document::Candidate refused = window.document().candidate();
  window.document().edit(cell("kDOF"), "1");
  window.document().end_step();
  check->found(refused, {});
  CHECK(says("Ready to run"));
}

TEST_CASE("a number that ends within its exponent is told as that", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  for (const char* name : {"tol", "bReDia", "appLoadX"})
    for (const char* text : {"1e-", "1e", "2.5E+", "3d"}) {
      CAPTURE(name, text);
      replace_text(line_of(window, name), text);
      const QString said = window.page()->findChild<QLabel*>(QString("problem-") + name)->text();
      CHECK(said.contains("ends within its exponent"));
      CHECK_FALSE(said.contains("unit"));
      window.undo();
    }
}

TEST_CASE(
    "runs have a menu of their own, redo both of its keys, and an empty search the deck's undo",
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
  for (const char* entry :
       {"Plan of this deck", "Quasi-static solution", "Run", "Run into a new folder",
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

TEST_CASE(
    "a deck with an error is refused before its name is asked, and a copy that is kept is told",
    "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  {
    DeckWindow window;
    window.show();
    replace_text(line_of(window, "bReDia"), "unknown");
    for (const bool as : {false, true}) {
      if (as)
        window.saveAs();
      else
        window.save();
      CHECK(window.findChild<QFileDialog*>("save") == nullptr);
      CHECK(take_message(window).contains("bReDia"));
    }
  }
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::string text(deck::template_text("ball"));
  text.replace(text.find("0.0127"), 6, "x.0127");
  std::ofstream(path) << text;
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(path));
  replace_text(line_of(window, "bReDia"), "12.7 mm");
  window.save();
  CHECK(take_message(window).isEmpty());
  CHECK(window.statusBar()->currentMessage().contains("DATA.txt.bak"));
  CHECK(bytes_of(path.string() + ".bak") == text);
  replace_text(line_of(window, "bReDia"), "12.8 mm");
  window.save();
  CHECK_FALSE(window.statusBar()->currentMessage().contains(".bak"));
}

TEST_CASE("names in the drawing and the menu of a field go by the units of view",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showRecord("9.1.1");
  auto* drawing = window.findChild<DrawingView*>("drawing");
  const auto labels = [&] {
    QStringList out;
    for (const drawing::Pane& pane : drawing->drawing().panes) {
      for (const drawing::Arrow& arrow : pane.arrows) out << QString::fromStdString(arrow.label);
      for (const drawing::Dimension& one : pane.dimensions)
        out << QString::fromStdString(one.label);
    }
    return out;
  };
  QTest::qWait(300);
  REQUIRE(labels().contains("appLoadX = 1500.0 N"));
  QLineEdit* line = line_of(window, "appLoadX");
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Down, Qt::AltModifier);
  auto* button = window.page()->findChild<QToolButton*>("unit-appLoadX");
  REQUIRE(button->menu()->isVisible());
  for (QAction* action : button->menu()->actions())
    if (action->text() == "kN") action->trigger();
  button->menu()->hide();
  CHECK(line->text() == "1.5 kN");
  CHECK(labels().contains("appLoadX = 1.5 kN"));
  CHECK_FALSE(labels().contains("appLoadX = 1500.0 N"));
  choose_unit("N", {});
}
