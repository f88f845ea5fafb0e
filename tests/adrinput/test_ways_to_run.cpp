#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/sweep_range.hpp"
#include "adrinput/unit_choice.hpp"
#include "results/run_json.hpp"
#include "studies/sweep.hpp"
#include "studies/sweep_mark.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

/// The run to continue, the runs that may be replaced, and the range of a sweep.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

struct Bench {
  QTemporaryDir folder;
  DeckWindow window;
  explicit Bench(const char* steps) {
    window.runPanel().launch = [](const QString&, const QStringList&) {};
    window.show();
    window.document().change({{"maxStps", steps}, {"kPltFreq", "1"}, {"kAGraf", "1"}});
    window.document().save(path("DATA.txt"));
  }
  [[nodiscard]] fs::path path(const char* name) const {
    return folder.filePath(name).toStdString();
  }
  [[nodiscard]] std::string status(const char* in = ".") const {
    return results::read_request_status(path(in) / "RUN.json").status;
  }
  void change(const char* name, const char* value) {
    window.document().edit(cell(name), value);
    window.document().end_undo_step();
  }
  void wait() {
    REQUIRE(QTest::qWaitFor([&] { return !window.runPanel().busy(); }, 120000));
  }
  /// Ends a run as soon as it has stored something.
  void cancel() {
    REQUIRE(QTest::qWaitFor(
        [&] { return note().startsWith("Step ") && !note().startsWith("Step 0,"); }, 60000));
    press(window, "cancel");
    wait();
    CHECK(note().startsWith("Cancelled"));
  }
  QString note() { return window.findChild<QLabel*>("run-note")->text(); }
  QMessageBox* question() { return window.findChild<QMessageBox*>("replace-results"); }
  void answer(const char* button) {
    QTest::mouseClick(question()->findChild<QPushButton*>(button), Qt::LeftButton);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    wait();
  }
  /// The entry of the menu as it is opened.
  QAction& entry() {
    auto* menu = window.findChild<QMenu*>("run-menu");
    emit menu->aboutToShow();
    for (QAction* action : menu->actions())
      if (action->text().contains("ontinue")) return *action;
    FAIL("no such entry");
    throw 0;
  }
};

}  // namespace

TEST_CASE("run panel: last cancelled run → continued in its folder, named in the menu",
          "[gui][adrinput][continue]") {
  test::use_qt();
  Bench bench("3");
  CHECK(bench.entry().text() == "&Continue the run");
  bench.window.runDeck();
  bench.wait();
  CHECK(bench.entry().text() == "&Continue the run next to the deck");
  const std::string first = bytes_of(bench.path("RUN.json"));
  bench.change("maxStps", "1000000");
  bench.window.runInNewFolder();
  bench.cancel();
  REQUIRE(bench.status("run-001") == "interrupted");
  CHECK(bench.entry().text() == "&Continue the run in run-001");
  CHECK(bench.entry().toolTip().endsWith("/run-001"));
  const auto size = fs::file_size(bench.path("run-001/SOL1"));
  bench.entry().trigger();
  CHECK(bench.note().contains("run-001"));
  bench.cancel();
  CHECK(fs::file_size(bench.path("run-001/SOL1")) > size);
  CHECK(bytes_of(bench.path("RUN.json")) == first);

  // Runs of other windows: the interrupted one is continued.
  {
    DeckWindow other;
    REQUIRE(other.openFile(bench.path("DATA.txt")));
    QAction name(nullptr);
    other.runPanel().updateContinueAction(name);
    CHECK(name.text() == "&Continue the run in run-001");
  }

  // Another deck in the same folder has none of these.
  {
    fs::copy_file(bench.path("DATA.txt"), bench.path("COPY.txt"));
    DeckWindow other;
    REQUIRE(other.openFile(bench.path("COPY.txt")));
    QAction name(nullptr);
    other.runPanel().updateContinueAction(name);
    CHECK_FALSE(name.text().contains("run-001"));
  }

  // Two that were broken off: which is asked.
  bench.window.runInNewFolder();
  bench.cancel();
  CHECK(bench.entry().text() == QString::fromUtf8("&Continue a run …"));
  for (const int choice : {0, 1}) {
    const char* folder = choice == 0 ? "run-002" : "run-001";
    bench.entry().trigger();
    CHECK_FALSE(bench.window.runPanel().busy());
    auto* dialog = bench.window.findChild<QInputDialog*>("continue-which");
    REQUIRE(dialog != nullptr);
    auto* combo = dialog->findChild<QComboBox*>();
    REQUIRE(combo != nullptr);
    CHECK(combo->count() == 2);
    CHECK(combo->itemText(0).startsWith("run-002"));  // the last one
    combo->setCurrentIndex(choice);
    const auto before = fs::file_size(bench.path(folder) / "SOL1");
    dialog->accept();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    REQUIRE(bench.window.runPanel().busy());
    bench.cancel();
    CHECK(fs::file_size(bench.path(folder) / "SOL1") > before);
  }
  CHECK(bytes_of(bench.path("RUN.json")) == first);
}

TEST_CASE("run panel: cancelled sweep → continued; after a change of the deck → reason",
          "[gui][adrinput][continue]") {
  test::use_qt();
  Bench bench("150");
  RunPanel& panel = bench.window.runPanel();
  Document& document = bench.window.document();
  panel.sweep(document.path(), document.deck(), document.options(), "rpm2=7000:7500:6");
  const auto done = [&](int number) {
    const QString folder = QString("sweep-001/rpm2-%1").arg(number);
    return bench.status(folder.toStdString().c_str()) == "done";
  };
  REQUIRE(QTest::qWaitFor([&] { return done(1) || done(2); }, 120000));
  press(bench.window, "cancel");
  bench.wait();
  REQUIRE_FALSE(done(6));
  CHECK(bench.note().contains("cancelled"));
  CHECK(bench.entry().text() == "&Continue the sweep in sweep-001");
  const fs::path first = bench.path(done(1) ? "sweep-001/rpm2-1" : "sweep-001/rpm2-2");
  const std::string kept = bytes_of(first / "RUN.json");

  bench.change("appLoadX", "1501");
  bench.entry().trigger();
  CHECK_FALSE(panel.busy());
  CHECK(take_message(bench.window).contains("Undo the change"));
  CHECK(bytes_of(first / "RUN.json") == kept);
  bench.window.undo();
  bench.entry().trigger();
  REQUIRE(panel.busy());
  bench.wait();
  CHECK(bench.note() == "The sweep is done.");
  for (int number = 1; number <= 6; ++number) CHECK(done(number));
  CHECK(bytes_of(first / "RUN.json") == kept);  // not computed again
  CHECK(bench.entry().text() == "&Continue the run");
}

TEST_CASE("run panel: sweep of an earlier session → missing runs computed, finished ones kept",
          "[gui][adrinput][continue]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path deck = folder.filePath("DATA.txt").toStdString();
  const auto request = [&](const char* range) {
    runs::RunRequest out;
    out.deck = deck;
    out.sets = {{"rpm2", range}};
    return out;
  };
  // Broken off after the second of four runs, as by a kill: its report says "running".
  const auto broken_off = [&](runs::RunRequest sweep, const fs::path& place) {
    sweep.out = place;
    std::stop_source stop;
    studies::run_sweep(
        sweep, 1,
        [&](const runs::Progress& now) { now.step >= 2 ? void(stop.request_stop()) : void(); },
        stop.get_token());
    auto mark = studies::read_sweep_manifest(place);
    REQUIRE(mark);
    CHECK(mark->status == "interrupted");
    mark->status = "running";
    studies::write_sweep_manifest(*mark, WriteFolder(place));
  };
  {
    Document document;
    document.change({{"mode", "-1"}});
    document.save(deck);
  }
  const fs::path sweep = deck.parent_path() / "sweep-001";
  broken_off(request("7000:7600:4"), sweep);
  const auto done = [&](int number) {
    const fs::path report = sweep / ("rpm2-" + std::to_string(number)) / "RUN.json";
    return results::read_request_status(report).status == "done";
  };
  REQUIRE((done(2) && !done(3)));
  const std::string kept = bytes_of(sweep / "rpm2-2/RUN.json");
  const auto opened = [&](Bench& bench) -> QAction& {
    REQUIRE(bench.window.openFile(deck));
    return bench.entry();
  };
  {
    Bench bench("1");
    QAction& entry = opened(bench);
    CHECK(entry.text() == "&Continue the sweep in sweep-001");
    entry.trigger();
    REQUIRE(bench.window.runPanel().busy());
    bench.wait();
    CHECK(bench.note() == "The sweep is done.");
    // Finished runs take no time, so they do not enter the estimate.
    runs::RunRequest again = request("7000:7600:4");
    again.out = sweep;
    again.go_on = true;
    int told = 0;
    (void)studies::run_sweep(
        again, 1, [&](const runs::Progress& now) { told += now.remaining > 0.0 ? 1 : 0; });
    CHECK(told == 0);
    for (int number = 1; number <= 4; ++number) CHECK(done(number));
    CHECK(bytes_of(sweep / "rpm2-2/RUN.json") == kept);
    CHECK(bench.entry().text() == "&Continue the run");
  }
  {
    // All of its runs ended, one of them without a result: that one is made again.
    const fs::path report = sweep / "rpm2-3/RUN.json";
    std::string text = bytes_of(report);
    text.replace(text.find("\"status\": \"done\""), 16, "\"status\": \"failed\"");
    std::ofstream(report) << text;
    auto mark = *studies::read_sweep_manifest(sweep);
    CHECK(mark.failed == 0);
    mark.failed = 1;
    studies::write_sweep_manifest(mark, WriteFolder(sweep));
    Bench bench("1");
    QAction& entry = opened(bench);
    CHECK(entry.text() == "&Continue the sweep in sweep-001");
    CHECK(entry.toolTip().contains("1 run without a result"));
    entry.trigger();
    REQUIRE(bench.window.runPanel().busy());
    bench.wait();
    CHECK(bench.note() == "The sweep is done.");
    CHECK(done(3));
    CHECK(bytes_of(sweep / "rpm2-2/RUN.json") == kept);
    CHECK(bench.entry().text() == "&Continue the run");
    // A failed sweep reports the number of failures and is still offered.
    RunPanel& panel = bench.window.runPanel();
    Document& document = bench.window.document();
    panel.sweep(document.path(), document.deck(), document.options(), "raceCurFac1=0.4:0.52:2");
    bench.wait();
    CHECK(bench.note().contains("1 run is without a result"));
    CHECK(bench.entry().text() == "&Continue the sweep in sweep-002");
    fs::remove_all(deck.parent_path() / "sweep-002");
  }
  {
    // Of a deck of another name in the folder.
    auto mark = *studies::read_sweep_manifest(sweep);
    mark.status = "interrupted";
    mark.deck = "OTHER.txt";
    studies::write_sweep_manifest(mark, WriteFolder(sweep));
    Bench bench("1");
    CHECK(opened(bench).text() == "&Continue the run");
    fs::remove_all(sweep);
  }
  {
    // A run of the command line in the folder of the deck, and one with a value that the deck does
    // not have.
    auto other = request("7000:7600:4");
    other.sets.emplace_back("appLoadX", "900.0");
    broken_off(other, deck.parent_path());
    Bench bench("1");
    QAction& entry = opened(bench);
    CHECK(entry.text() == "&Continue the sweep next to the deck");
    const std::string before = bytes_of(deck.parent_path() / "rpm2-1/RUN.json");
    entry.trigger();
    CHECK_FALSE(bench.window.runPanel().busy());
    CHECK(take_message(bench.window).contains("the values, the run options"));
    CHECK(bytes_of(deck.parent_path() / "rpm2-1/RUN.json") == before);
  }
}

TEST_CASE(
    "run panel: results of another deck are replaced after a question that can be switched off",
    "[gui][adrinput][continue]") {
  test::use_qt();
  Bench bench("20");
  DeckWindow& window = bench.window;
  const auto run = [&] {
    window.runDeck();
    bench.wait();
  };
  run();
  const auto load = [&] { return bytes_of(bench.path("SOL7")); };
  const std::string first = load();
  run();  // the same deck: the same results
  CHECK(bench.question() == nullptr);
  bench.change("appLoadX", "1501");
  run();
  REQUIRE(bench.question() != nullptr);
  CHECK(bench.question()->text().contains("before the deck was changed"));
  QTest::keyClick(bench.question(), Qt::Key_Return);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  CHECK_FALSE(window.runPanel().busy());
  CHECK(load() == first);
  // A tick without "Replace them" promises nothing.
  run();
  window.findChild<QCheckBox*>("replace-unasked")->setChecked(true);
  QTest::keyClick(bench.question(), Qt::Key_Escape);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  run();
  REQUIRE(bench.question() != nullptr);
  CHECK_FALSE(window.findChild<QCheckBox*>("replace-unasked")->isChecked());
  bench.answer("new-folder-instead");
  CHECK(fs::exists(bench.path("run-001/SOL7")));
  CHECK(load() == first);
  // After undo it is the deck of the results again, independent of other runs.
  window.undo();
  run();
  CHECK(bench.question() == nullptr);
  CHECK(bench.note().startsWith("Done: 20 steps"));

  bench.change("appLoadX", "1502");
  run();
  REQUIRE(bench.question() != nullptr);
  bench.answer("replace-them");
  CHECK(load() != first);
  bench.change("appLoadX", "1503");
  run();
  REQUIRE(bench.question() != nullptr);
  window.findChild<QCheckBox*>("replace-unasked")->setChecked(true);
  bench.answer("replace-them");
  for (const char* value : {"1504", "1505"}) {
    const std::string before = load();
    bench.change("appLoadX", value);
    run();
    CHECK(bench.question() == nullptr);
    CHECK(load() != before);
  }
  // Not so what somebody else put there.
  fs::last_write_time(bench.path("RUN.json"),
                      fs::file_time_type::clock::now() + std::chrono::seconds(5));
  run();
  REQUIRE(bench.question() != nullptr);
  CHECK(bench.question()->text().contains("an earlier run"));
}

TEST_CASE("run panel: cancelled run restarted → question before its results are replaced",
          "[gui][adrinput][continue]") {
  test::use_qt();
  Bench bench("1000000");
  bench.window.runDeck();
  bench.cancel();
  const std::string kept = bytes_of(bench.path("SOL1"));
  bench.window.runDeck();
  bench.wait();
  REQUIRE(bench.question() != nullptr);
  CHECK(bench.question()->text().contains("cancelled"));
  CHECK(bench.question()->findChild<QPushButton*>("continue-instead") != nullptr);
  CHECK(bytes_of(bench.path("SOL1")) == kept);
}

TEST_CASE("sweep range: units for one or both values", "[gui][adrinput][sweep]") {
  test::use_qt();
  DeckWindow window;
  Document& document = window.document();
  const auto set = [&](const char* text) { return parse_sweep_range(document, text).set; };
  const std::string newtons = "appLoadZ=500:1500:3";
  for (const char* text :
       {"appLoadZ=500:1500:3", " appLoadZ = 500 : 1500 : 3 ", "appLoadZ=0.5 kN:1.5 kN:3",
        "appLoadZ=0,5 kN:1500 N:3", "appLoadZ=0.5:1.5 kN:3", "appLoadZ=0.5 kN:1.5:3",
        "appLoadZ=0.5:1.5:3 kN", "appLoadZ=1/2:3*0.5 kN:3", "appLoadZ=500:3*0.5 kN:3 N"}) {
    INFO(text);
    CHECK(set(text) == newtons);
  }
  CHECK(set("pitchDia=60 mm:61 mm:2") == "pitchDia=0.06:0.061:2");
  CHECK(set("pitchDia=60:61:2 mm") == "pitchDia=0.06:0.061:2");
  CHECK(parse_sweep_range(document, newtons).told == "appLoadZ from 500 N to 1500 N, 3 runs");
  CHECK(sweep_unit(document, "appLoadZ") == "N");
  CHECK(sweep_unit(document, "nothing") == "");
  const auto refusal = [&](const char* text) {
    try {
      (void)parse_sweep_range(document, text);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using Catch::Contains;
  CHECK_THAT(refusal("appLoadZ=0.5 mm:1 mm:3"), Contains("0.5 mm") && Contains("appLoadZ"));
  CHECK_THAT(refusal("appLoadZ=500:1500:1"), Contains("number of runs"));
  CHECK_THAT(refusal("appLoadZ=500:1500:two"), Contains("number of runs"));
  CHECK_THAT(refusal("appLoadQ=500:1500:3"), Contains("no variable \"appLoadQ\""));
  CHECK_THAT(refusal("specId=500:1500:3"), Contains("no variable") || Contains("is a text"));
  for (const char* text : {"", "=", "appLoadZ", "appLoadZ=1", "appLoadZ=1:2", "a=b=1:2:3",
                           "appLoadZ=1:2:3:4", "appLoadZ=::", "appLoadZ=:1:2", ":::"}) {
    INFO(text);
    CHECK_FALSE(refusal(text).empty());
  }

  // In kilonewtons, a number means kilonewtons, and the dialog states it.
  choose_unit("N", "kN");
  CHECK(set("appLoadZ=0.5:1.5:3") == newtons);
  CHECK(set("appLoadZ=500 N:1500:3") == newtons);
  CHECK(sweep_unit(document, "appLoadZ=5") == "kN");
  window.show();
  window.askForSweep();
  auto* dialog = window.findChild<QInputDialog*>("sweep");
  REQUIRE(dialog != nullptr);
  dialog->setTextValue("appLoadZ=0.5");
  CHECK(dialog->labelText().contains("in kN"));
  dialog->setTextValue("appLoadZ=0.5:1.5:3");
  CHECK(dialog->labelText().contains("from 500 N to 1500 N, 3 runs"));
  choose_unit("N", {});
}
