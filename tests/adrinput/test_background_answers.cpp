#include "adrinput/accuracy_panel.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/solution_charts.hpp"
#include "adrinput/start_check.hpp"
#include "adrinput/stored_accuracy.hpp"
#include "deck/reader.hpp"
#include "deck/templates.hpp"
#include "desktop/chart_view.hpp"
#include "runs/run.hpp"
#include "studies/model_errors.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QDoubleSpinBox>
#include <QGraphicsSimpleTextItem>
#include <QLabel>
#include <QListWidget>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <thread>

/// Results of background work and the deck that they belong to.
using namespace adore;
using namespace adore::adrinput;

TEST_CASE("new deck: results of the previous deck are removed", "[gui][adrinput][daily]") {
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
      CHECK_FALSE(note->text().contains("the deck has changed"));
    }
  }
  // A result still in progress belongs to the earlier deck.
  window.runQuasiStatic();
  window.newDeck("tapered");
  REQUIRE(QTest::qWaitFor([&] { return !window.staticsPanel().busy(); }, 60000));
  CHECK(window.staticsPanel().tables() == nullptr);
  CHECK(window.solutionCharts().pages().isEmpty());
}

TEST_CASE("adrinput: quasi-static solution → charts next to the form", "[gui][adrinput][daily]") {
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
    stale = stale || (label->isVisible() && label->text().contains("the deck has changed"));
  CHECK(stale);
}

TEST_CASE("accuracy panel: running study → revolutions of the round are displayed",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  AccuracyPanel& panel = window.accuracyPanel();
  std::atomic<bool> go_on = false;
  panel.study = [&go_on](const studies::AccuracyRequest&, const studies::AccuracySink& row_done,
                         std::stop_token) {
    studies::AccuracyStudy study;
    studies::AccuracyRow row;
    row.setting.name = "rkf5, tol 1e-06";
    row.turns = 1.0;
    study.screening.push_back(row);
    row_done(row, study);
    row.turns = 12.5;
    study.finals.push_back(row);
    row_done(row, study);
    while (!go_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return study;
  };
  window.studyAccuracy();
  CHECK(QTest::qWaitFor([&] { return panel.text().count("rkf5") == 2; }, 10000));
  CHECK(panel.text().startsWith("first round, 1 revolution\n"));
  CHECK(panel.text().contains("second round, 12.5 revolutions\n"));
  go_on = true;
  CHECK(QTest::qWaitFor([&] { return !panel.busy(); }, 10000));
}

TEST_CASE("accuracy page: stored accuracy of the last run and model errors are shown",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir temporary;
  const std::filesystem::path folder = temporary.path().toStdString();
  const std::filesystem::path file = folder / "DATA.txt";
  test::write_text(file, deck::write_deck(deck::new_deck("ball")));
  test::write_text(folder / "RUN.json", R"({"accuracy": {"revolutions": 2.5, "quantities": [
    {"label": "heat, outer race", "value": 12.5, "unit": "W", "half_width": 0.004,
     "numerical": 0.001, "statistical": 0.003}]},
    "verify": {"against": "rkf7, tol 1e-10", "errors": {"heat": 0.0021}}})");
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(file));
  QTabWidget* tabs = window.findChild<QTabWidget*>("panels");
  REQUIRE(tabs != nullptr);
  for (int i = 0; i < tabs->count(); ++i)
    if (tabs->widget(i)->isAncestorOf(&window.accuracyPanel())) tabs->setCurrentIndex(i);
  const QString text = window.accuracyPanel().text();
  CAPTURE(text.toStdString());
  CHECK(text.contains("2.5 revolutions"));
  CHECK(text.contains("heat, outer race"));
  CHECK(text.contains("± 0.4 %"));
  CHECK(text.contains("Verified against rkf7, tol 1e-10: heat 0.21 %"));
  // A model study counts only when it is of this deck.
  runs::LoadedDeck loaded;
  loaded.path = file;
  loaded.deck = deck::read_deck(file.string()).deck;
  runs::ModelStudy study;
  study.stamp = runs::model_stamp(loaded);
  study.complete = true;
  study.rows.push_back(
      {{"damping", "contactDamping = 2x", "factor 2", {}, {}}, {}, 0.01, -0.02, 1.0, ""});
  test::write_text(folder / runs::kModelFile, runs::model_json(study));
  CHECK_THAT(stored_accuracy(file, loaded.deck, {}), Catch::Contains("contactDamping = 2x"));
  loaded.deck.set("bReDia", "0.0126");
  CHECK_THAT(stored_accuracy(file, loaded.deck, {}), !Catch::Contains("contactDamping = 2x"));
}

TEST_CASE("charts next to the form: low window → axis titles are complete",
          "[gui][adrinput][daily]") {
  test::use_qt();
  for (const char* deck : {"ball", "cylindrical", "tapered", "spherical", "spherical-tapered"}) {
    DeckWindow window;
    window.newDeck(deck);
    window.show();
    window.runQuasiStatic();
    REQUIRE(QTest::qWaitFor([&] { return !window.staticsPanel().busy(); }, 60000));
    SolutionCharts& charts = window.solutionCharts();
    for (const QSize size : {QSize(1280, 800), QSize(1010, 560), QSize(944, 450)}) {
      window.resize(size);
      for (int page = 0; page < charts.pages().size(); ++page) {
        charts.choosePage(page);
        QCoreApplication::processEvents();
        INFO(deck << ", " << charts.pages()[page].toStdString() << ", " << size.height()
                  << " pixels");
        const qreal width = charts.view().chartScene().sceneRect().width();
        for (const QGraphicsItem* item : charts.view().chartScene().items())
          if (const auto* text = dynamic_cast<const QGraphicsSimpleTextItem*>(item);
              text != nullptr && text->isVisible()) {
            INFO(text->text().toStdString());
            if (text->rotation() != 0.0) CHECK_FALSE(text->text().contains(QChar(0x2026)));
            CHECK(text->sceneBoundingRect().right() <= width + 1.0);
          }
      }
    }
  }
}

TEST_CASE("adrinput: plan → cost of each effect is listed", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showPlan();
  REQUIRE(QTest::qWaitFor([&] { return !window.planPanel().busy(); }, 60000));
  const QString text = window.planPanel().text();
  CHECK(text.contains("CPU time of the effects"));
  CHECK(text.contains("%"));
  CHECK(text.contains("kTracType"));  // why an effect is on
}

TEST_CASE("accuracy study: rows shown, recommended settings applied to the deck",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  AccuracyPanel& panel = window.accuracyPanel();
  std::atomic<double> asked = 0.0;
  panel.study = [&asked](const studies::AccuracyRequest& request,
                         const studies::AccuracySink& row_done, std::stop_token) {
    CHECK(request.text.has_value());
    asked = request.turns;
    studies::AccuracyStudy study;
    studies::AccuracyRow row;
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
  panel.findChild<QDoubleSpinBox*>("accuracy-turns")->setValue(12.0);
  window.studyAccuracy();
  REQUIRE(QTest::qWaitFor([&] { return !panel.busy() && !panel.recommended().empty(); }, 10000));
  CHECK(asked == 12.0);
  CHECK(panel.text().contains("rkf6"));
  press(window, "apply-accuracy");
  CHECK(window.document().deck().integer("intMet") == 6);
  CHECK(window.document().deck().real("tol") == 1e-5);
  window.undo();
  CHECK(window.document().deck().integer("intMet") == 5);

  // Changes during a study do not affect the deck of its result.
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath("DATA.txt").toStdString();
  window.document().save(file);
  const auto note = [&] { return window.findChild<QLabel*>("study-note")->text(); };
  const QString advice = "\"Apply to deck\" sets";
  const auto plain = panel.study;
  for (const bool reread : {false, true}) {
    INFO(reread);
    std::atomic<bool> go_on = false;
    panel.study = [&go_on, plain](const studies::AccuracyRequest& request,
                                  const studies::AccuracySink& row_done, std::stop_token stop) {
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
    CHECK(note().startsWith(reread ? "Out of date: the file was reloaded"
                                   : "Out of date: the deck has changed"));
    CHECK(note().contains(advice) != reread);
    CHECK(window.findChild<QPushButton*>("apply-accuracy")->isEnabled() != reread);
  }
}

TEST_CASE(
    "adrinput: error that only a run finds → listed with the records, click leads to the reason",
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
  window.document().end_undo_step();
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
  // A missing run to continue, until there is one.
  window.newDeck("ball");
  for (const auto& [name, value] :
       {std::pair{"maxStps", "4"}, std::pair{"kIcOpt", "1"}, std::pair{"kAGraf", "0"}})
    window.document().edit(cell(name), value);
  window.document().save(folder.filePath("DATA.txt").toStdString());
  window.checkNow();
  REQUIRE(says("Run refused"));
  CHECK(problems->item(0)->text().contains("kIcOpt"));
  runs::RunRequest first;
  first.deck = folder.filePath("DATA.txt").toStdString();
  first.sets = {{"kIcOpt", "0"}};
  (void)runs::run(first);
  emit window.runPanel().finished();
  CHECK(says("Ready to run"));
}

TEST_CASE("adrinput: deck restored during the check of another one → its own result is displayed",
          "[gui][adrinput][daily]") {
  test::use_qt();
  Document document;
  document.edit(cell("kStif"), "300");  // a table that can be given up at each of its speeds
  for (const auto& [name, rpm] : {std::pair{"pctDisp", "1"}, std::pair{"rpmRange12", "1000"},
                                  std::pair{"rpmRange22", "9000"}})
    document.edit(cell(name), rpm);
  REQUIRE_FALSE(document.has_errors());
  const Document::Candidate first = document.candidate();
  document.edit(cell("appLoadX"), "1501");
  const Document::Candidate second = document.candidate();
  StartCheck check;
  std::vector<Document::Candidate> answers;
  check.found = [&](const Document::Candidate& of, const runs::DryRunResult&) {
    answers.push_back(of);
  };
  check.ask(first);
  check.ask(second);
  check.ask(first);  // undone
  REQUIRE(QTest::qWaitFor([&] { return !check.busy(); }, 60000));
  REQUIRE(answers.size() == 1);
  CHECK(answers.front() == first);
}

TEST_CASE("adrinput: files changed by a finished run → check is repeated, old result is dropped",
          "[gui][adrinput][daily]") {
  test::use_qt();
  Document document;
  const Document::Candidate asked = document.candidate();
  StartCheck check;
  int answers = 0;
  check.found = [&](const Document::Candidate&, const runs::DryRunResult&) { ++answers; };
  const auto wait = [&] { REQUIRE(QTest::qWaitFor([&] { return !check.busy(); }, 60000)); };
  check.ask(asked);
  check.invalidateResult();
  wait();
  CHECK(answers == 0);
  check.ask(asked);
  check.invalidateResult();
  check.ask(asked);  // the same deck with other files in its folder
  wait();
  CHECK(answers == 1);
}

TEST_CASE("background check: edit during a check → the new deck is checked",
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
  window.document().end_undo_step();
  window.checkNow();
  REQUIRE(says("Run refused"));
  const Document::Candidate refused = window.document().candidate();
  window.document().edit(cell("kDOF"), "1");
  window.document().end_undo_step();
  check->found(refused, {});
  CHECK(says("Ready to run"));
}
