#include "adrinput/run_driver.hpp"
#include "support/elsewhere.hpp"
#include "support/full_disk.hpp"
#include "support/qt_app.hpp"

#include <QFileDialog>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

/// Runs from the window: results, viewers, what is replaced.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

TEST_CASE("Run saves the deck, shows progress, and opens plots and animation of the results",
          "[gui][adrinput]") {
  RunBench bench;
  auto& [folder, window, launches] = bench;
  shorten(window.document(), "60");
  press(window, "run-deck");  // has no name yet
  CHECK_FALSE(window.runPanel().busy());
  auto* dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog != nullptr);
  QSignalSpy spy(&window.runPanel(), &RunPanel::finished);
  emit dialog->fileSelected(folder.filePath("DATA.txt"));
  CHECK(window.runPanel().busy());
  CHECK_FALSE(window.findChild<QPushButton*>("run")->isEnabled());
  REQUIRE(spy.wait(120000));
  CHECK(note(window).startsWith("Done: 60 steps"));
  auto* bar = window.findChild<QProgressBar*>("progress");
  CHECK(bar->value() == bar->maximum());
  for (const char* name : {"PRINT.txt", "SOL1", "SOL8", "RUN.json", "FINAL"}) {
    INFO(name);
    CHECK(fs::exists(folder.filePath(name).toStdString()));
    CHECK(window.runPanel().text().contains(name));
  }
  REQUIRE(launches.size() == 2);
  CHECK(launches[0].first == "adrplot");
  CHECK(launches[0].second.contains(folder.filePath("SOL1")));
  const QStringList project{"--project", folder.path()};
  CHECK(launches[0].second.mid(0, 2) == project);
  // Somebody may be typing here when a run ends: nothing takes the keyboard then.
  CHECK(launches[0].second.value(2) == "--behind");
  CHECK(window.runPanel().text().contains("Opened in the background: plots and animation."));
  CHECK(launches[1] ==
        std::pair(QString("agore"), project + QStringList{"--behind", folder.filePath("SOL8")}));
  press(window, "listing");
  auto* listing = window.findChild<QDialog*>("listing-window");
  REQUIRE(listing != nullptr);
  CHECK(listing->findChild<QPlainTextEdit*>()->toPlainText().contains("Largest contact load"));
  window.document().edit(cell("appLoadX"), "1501");
  CHECK(note(window).contains("the deck has changed"));

  // A changed deck is saved first; without the marks nothing is opened.
  for (const char* box : {"plots-at-end", "animation-at-end"})
    window.findChild<QCheckBox*>(box)->setChecked(false);
  launches.clear();
  {
    QSignalSpy ended(&window.runPanel(), &RunPanel::finished);
    replace_and_run(window);
    CHECK(QTest::qWaitFor([&] { return ended.count() == 2; }, 120000));
  }
  CHECK(launches.empty());
  CHECK(deck::read_deck(folder.filePath("DATA.txt").toStdString()).deck.real("appLoadX") == 1501);
  press(window, "open-plots");
  REQUIRE(launches.size() == 1);
  CHECK_FALSE(launches[0].second.contains("--behind"));  // asked for: to the front

  window.newDeck("cylindrical");
  CHECK(note(window).contains("Results of another deck"));
  CHECK(note(window).contains("DATA.txt"));
  window.document().edit(cell("rpm2"), "1234");
  CHECK(note(window).contains("Results of another deck"));
  REQUIRE(window.openFile(folder.filePath("DATA.txt").toStdString()));
  CHECK(note(window).startsWith("Done: 60 steps"));

  // A copy has the same values, but none of the results.
  fs::copy(folder.filePath("DATA.txt").toStdString(), folder.filePath("COPY.txt").toStdString());
  REQUIRE(window.openFile(folder.filePath("COPY.txt").toStdString()));
  CHECK(note(window).startsWith("Results of another deck"));
  window.document().edit(cell("rpm2"), "1234");
  (void)window.document().undo();
  CHECK(note(window).startsWith("Results of another deck"));
}

TEST_CASE("viewers: started with absolute file names", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const test::Elsewhere elsewhere(folder.path().toStdString());
  {
    DeckWindow window;
    Launches launches;
    watch_launches(window, launches);
    window.show();
    shorten(window.document(), "5");
    window.document().save("DATA.txt");
    run_to_end(window);
    REQUIRE(launches.size() == 2);
    for (const auto& [program, arguments] : launches) {
      INFO(program.toStdString() << ": " << arguments.join(" ").toStdString());
      CHECK(arguments.value(1) == folder.path());
      CHECK(arguments.size() > 3);
      for (const QString& file : arguments.mid(3)) CHECK(file.startsWith(folder.path() + "/SOL"));
    }
  }
}

TEST_CASE("run panel: cancel a run; quit during a run → confirmation", "[gui][adrinput]") {
  RunBench bench;
  auto& [folder, window, launches] = bench;
  shorten(window.document(), "1000000");
  window.document().save(folder.filePath("DATA.txt").toStdString());
  auto* bar = window.findChild<QProgressBar*>("progress");
  QSignalSpy spy(&window.runPanel(), &RunPanel::finished);
  const auto start = [&] {
    if (fs::exists(folder.filePath("RUN.json").toStdString()))
      replace_and_run(window);
    else
      window.runDeck();
    REQUIRE(window.runPanel().busy());
    REQUIRE(QTest::qWaitFor([&] { return note(window).startsWith("Step"); }, 60000));
  };
  start();
  press(window, "cancel");
  REQUIRE(spy.wait(60000));
  CHECK(note(window).startsWith("Cancelled"));
  CHECK(bar->value() < bar->maximum());
  CHECK(launches.empty());
  CHECK(fs::exists(folder.filePath("FINAL").toStdString()));

  start();
  const auto answer = [&](bool end) {
    CHECK_FALSE(window.close());
    auto* box = window.findChild<QMessageBox*>("running");
    REQUIRE(box != nullptr);
    for (QAbstractButton* button : box->buttons())
      if ((box->standardButton(button) == QMessageBox::Cancel) != end)
        QTest::mouseClick(button, Qt::LeftButton);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  answer(false);
  CHECK(window.isVisible());
  CHECK(window.runPanel().busy());
  answer(true);
  CHECK_FALSE(window.isVisible());
  CHECK((spy.count() == 3 || spy.wait(60000)));
  CHECK(note(window).startsWith("Cancelled"));
}

TEST_CASE("run panel: quasi-static run → tables open; deck that cannot run → reason",
          "[gui][adrinput]") {
  RunBench bench;
  auto& [folder, window, launches] = bench;
  window.newDeck("cylindrical-nu209");
  window.document().save(folder.filePath("NU209.txt").toStdString());
  run_to_end(window);
  CHECK(note(window).startsWith("Done: Quasi-static"));
  REQUIRE(launches.size() == 1);
  CHECK(launches[0] ==
        std::pair(QString("adrplot"), QStringList{"--project", folder.path(), "--behind",
                                                  folder.filePath("RUN.json")}));
  CHECK_FALSE(window.findChild<QPushButton*>("open-animation")->isEnabled());

  window.document().edit(cell("mode"), "0");
  window.document().edit(cell("kDOF"), "6");  // a user routine
  window.checkNow();
  launches.clear();
  run_to_end(window);
  CHECK(note(window).contains("not run"));
  CHECK(note(window).contains("user routine ADRX1"));
  CHECK(launches.empty());
  // The tables of the run before are still there.
  CHECK(window.findChild<QPushButton*>("open-plots")->isEnabled());
}

TEST_CASE("run panel: continue a complete run → reported as complete", "[gui][adrinput]") {
  RunBench bench;
  auto& [folder, window, launches] = bench;
  shorten(window.document(), "3");
  window.document().save(folder.filePath("DATA.txt").toStdString());
  run_to_end(window);
  REQUIRE(note(window).startsWith("Done: 3 steps"));
  RunPanel& panel = window.runPanel();
  const auto go_on = [&] {
    QSignalSpy spy(&panel, &RunPanel::finished);
    panel.continueRun(window.document().path(), window.document().deck(), {});
    CHECK(note(window).startsWith("Reading the stored state"));
    REQUIRE(spy.wait(120000));
  };
  go_on();
  CHECK(note(window).startsWith("Done: the run is complete, at step 3"));
  shorten(window.document(), "5");
  window.document().save(folder.filePath("DATA.txt").toStdString());
  go_on();
  CHECK(note(window).startsWith("Done: 5 steps"));
}

TEST_CASE("run panel: results of another program are replaced only after a question",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path report = folder.filePath("RUN.json").toStdString();
  const auto open = [&](DeckWindow& window, Launches& launches) {
    watch_launches(window, launches);
    window.show();
    shorten(window.document(), "20");
    window.document().save(folder.filePath("DATA.txt").toStdString());
  };
  {
    DeckWindow window;
    Launches launches;
    open(window, launches);
    run_to_end(window);
    CHECK(note(window).startsWith("Done: 20 steps"));
    run_to_end(window);  // its own results
    CHECK(note(window).startsWith("Done: 20 steps"));
  }
  DeckWindow window;
  Launches launches;
  open(window, launches);
  const auto before = fs::last_write_time(report);
  QSignalSpy spy(&window.runPanel(), &RunPanel::finished);
  const auto answer = [&](const char* name) {
    run_to_end(window);
    CHECK(note(window).contains("was not run"));
    CHECK(note(window).contains("earlier run"));
    auto* box = window.findChild<QMessageBox*>("replace-results");
    REQUIRE(box != nullptr);
    spy.clear();
    if (name == nullptr)
      QTest::keyClick(box, Qt::Key_Return);  // users who do not read messages
    else
      QTest::mouseClick(box->findChild<QPushButton*>(name), Qt::LeftButton);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    CHECK(window.findChild<QMessageBox*>("replace-results") == nullptr);
  };
  const auto wait = [&] { REQUIRE((spy.count() == 1 || spy.wait(120000))); };
  answer(nullptr);
  CHECK_FALSE(window.runPanel().busy());
  CHECK(fs::last_write_time(report) == before);
  CHECK(launches.empty());
  // Results that were not replaced can be opened.
  for (const char* name : {"open-plots", "open-animation", "listing"})
    CHECK(window.findChild<QPushButton*>(name)->isEnabled());
  press(window, "open-plots");
  REQUIRE(launches.size() == 1);
  CHECK(launches[0].second.contains(folder.filePath("SOL1")));
  launches.clear();

  answer("new-folder-instead");
  wait();
  CHECK(note(window).startsWith("Done: 20 steps"));
  CHECK(fs::exists(folder.filePath("run-001/SOL1").toStdString()));
  CHECK(fs::last_write_time(report) == before);

  answer("continue-instead");
  wait();
  CHECK(note(window).contains("the run is complete"));

  // Without a state to continue from, this choice is not offered.
  fs::remove(folder.filePath("MASTER").toStdString());
  DeckWindow third;
  Launches none;
  open(third, none);
  run_to_end(third);
  CHECK(third.findChild<QPushButton*>("continue-instead") == nullptr);
  QTest::mouseClick(third.findChild<QPushButton*>("replace-them"), Qt::LeftButton);
  REQUIRE(third.runPanel().busy());
  QSignalSpy third_spy(&third.runPanel(), &RunPanel::finished);
  REQUIRE(third_spy.wait(120000));
  CHECK(note(third).startsWith("Done: 20 steps"));
  CHECK(fs::last_write_time(report) != before);
}

TEST_CASE("run panel: result buttons follow the files on the disk", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path deck_file = folder.filePath("DATA.txt").toStdString();
  const auto put = [&](const char* name, bool there) {
    const fs::path file = folder.filePath(name).toStdString();
    if (there)
      std::ofstream(file) << "x";
    else
      fs::remove(file);
  };
  DeckWindow window;
  Launches launches;
  watch_launches(window, launches);
  window.show();
  shorten(window.document(), "3");
  window.document().save(deck_file);
  const auto enabled = [&](const char* name) {
    return window.findChild<QPushButton*>(name)->isEnabled();
  };
  const auto follows = [&] {
    for (int shown = 0; shown < 16; ++shown) {
      const bool plots = (shown & 1) != 0, animation = (shown & 2) != 0, listing = (shown & 4) != 0,
                 tables = (shown & 8) != 0;
      put("SOL3", plots);
      put("SOL8", animation);
      put("PRINT.txt", listing);
      put("RUN.json", tables);
      INFO("files " << shown);
      CHECK(QTest::qWaitFor(
          [&] {
            return enabled("open-plots") == (plots || tables) &&
                   enabled("open-animation") == animation && enabled("listing") == listing;
          },
          10000));
    }
    for (const char* name : {"SOL3", "SOL8", "PRINT.txt", "RUN.json"}) put(name, false);
  };
  CHECK_FALSE(enabled("open-plots"));
  follows();  // of a deck that was not run here
  run_to_end(window);
  CHECK(enabled("open-plots"));
  for (const char* name : {"SOL1", "SOL2", "SOL4", "SOL7"}) put(name, false);
  follows();
  // Names that the deck gives its files.
  window.document().change({{"kFnOpt", "1"}, {"pltNames8", "MOVES"}});
  window.document().save(deck_file);
  DeckWindow other;
  other.show();
  put("MOVES", true);
  REQUIRE(other.openFile(deck_file));
  CHECK(other.findChild<QPushButton*>("open-animation")->isEnabled());
}

TEST_CASE("run panel: disk full during a run → progress reported, stored results can be opened",
          "[gui][adrinput]") {
  RunBench bench;
  auto& [folder, window, launches] = bench;
  shorten(window.document(), "100000");
  window.document().save(folder.filePath("DATA.txt").toStdString());
  {
    const test::FullDisk full(1'500'000);
    run_to_end(window);
  }
  const QString said = note(window);
  INFO(said.toStdString());
  CHECK(said.contains(
      QRegularExpression("^The run stopped at \\d+ %: .*writing to the file failed")));
  CHECK(said.contains("can be opened"));
  CHECK(window.findChild<QLabel*>("run-note")->wordWrap());
  CHECK_FALSE(window.findChild<QPlainTextEdit*>("run-text")->isVisible());
  CHECK(launches.empty());
  for (const char* button : {"open-plots", "open-animation"}) {
    INFO(button);
    CHECK(window.findChild<QPushButton*>(button)->isEnabled());
  }
  press(window, "open-plots");
  REQUIRE(launches.size() == 1);
  CHECK(launches[0].second.contains(folder.filePath("SOL1")));
  // A run that never started reports nothing about an earlier one.
  window.document().edit(cell("kDOF"), "6");
  run_to_end(window);
  CHECK(note(window).startsWith("The deck was not run"));
}
