#include "adrinput/run_driver.hpp"
#include "adrinput/window_words.hpp"
#include "deck/templates.hpp"
#include "runs/rehearsal.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <filesystem>

/// Messages and questions about a run, in the words of the window.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

TEST_CASE("run panel: error of a run → message in terms of the window", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  // An output that the run may not replace, in the sentence of the command line and in ours.
  fs::create_directory(folder.filePath("SOL1").toStdString());
  runs::LoadedDeck input;
  input.path = folder.filePath("DATA.txt").toStdString();
  input.deck = deck::new_deck("ball");
  const std::vector<Issue> refused = runs::dry_run_errors(input);
  REQUIRE_FALSE(refused.empty());
  CHECK(refused.front().text().find("--out") != std::string::npos);
  const std::string ours = replace_cli_terms(refused.front().text());
  CHECK(ours.find("--") == std::string::npos);
  CHECK(ours.find("a new folder (Shift+F7)") != std::string::npos);
  DeckWindow window;
  window.show();
  window.document().save(input.path);
  REQUIRE(
      QTest::qWaitFor([&] { return window.document().deck_state() == DeckState::Refused; }, 60000));
  for (const Problem& problem : window.document().problems()) {
    INFO(problem.issue.text());
    CHECK(problem.issue.text().find("--") == std::string::npos);
  }
}

TEST_CASE("window words: every message that names a command option has a text for windows",
          "[adrinput]") {
  // Texts of the sources: literals that follow each other are one.
  const QRegularExpression texts(R"x("(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)x");
  const QRegularExpression joints(R"x("\s*")x"),
      comment(R"x(^\s*//.*$)x", QRegularExpression::MultilineOption), character(R"x('\\?.')x"),
      option("--[a-z]"), command("`adore [^`]*`");
  // Only who gives these options meets these sentences, and the window gives none; scripts;
  // examples of the help.
  const QRegularExpression not_ours(
      "^(--until \\{|--tol \\{|--integrator \\{| --opt \\{| --set \\{|--reproducible|#!|adore find "
      ")");
  int sentences = 0;
  for (const auto& entry : fs::recursive_directory_iterator(test::source_dir() / "core")) {
    // Command lines to be copied, whole.
    if (entry.path().extension() != ".cpp" || entry.path().stem() == "study_table_read") continue;
    QFile file(QString::fromStdString(entry.path().string()));
    REQUIRE(file.open(QIODevice::ReadOnly));
    const QString source =
        QString::fromUtf8(file.readAll()).remove(comment).replace(character, " ");
    for (auto match = texts.globalMatch(source); match.hasNext();) {
      QString text = match.next().captured().remove(joints);
      text = text.mid(1, text.size() - 2);
      if (!text.contains(option) || !text.contains(' ') || text.contains(not_ours)) continue;
      ++sentences;
      const QString told = QString::fromStdString(replace_cli_terms(text.toStdString()));
      INFO(entry.path().string() << ": " << text.toStdString() << "\n" << told.toStdString());
      CHECK_FALSE(QString(told).remove(command).contains(option));
      CHECK(told.count('`') % 2 == 0);
    }
  }
  CHECK(sentences > 30);
}

TEST_CASE("a run that is complete, and a tolerance that is loose, name nothing to be typed",
          "[gui][adrinput]") {
  RunBench bench;
  auto& [folder, window, launches] = bench;
  shorten(window.document(), "5");
  window.document().edit(cell("tol"), "1e-3");
  window.document().save(folder.filePath("DATA.txt").toStdString());
  run_to_end(window);
  const QString first = window.runPanel().text();
  CHECK(first.contains("Accuracy (F9) estimates"));
  CHECK_FALSE(first.contains("--"));
  QSignalSpy spy(&window.runPanel(), &RunPanel::finished);
  window.continueRun();
  REQUIRE(QTest::qWaitFor([&] { return spy.count() > 0; }, 60000));
  CHECK(note(window).contains("the run is complete"));
  CHECK_FALSE(note(window).contains("--"));
  window.document().edit(cell("maxStps"), "0");
  window.document().check_model();
  for (const Problem& problem : window.document().problems())
    CHECK(problem.issue.text().find("--") == std::string::npos);
}

TEST_CASE("run panel: progress bar → limit that ends the run", "[gui][adrinput]") {
  RunBench bench;
  auto& [folder, window, launches] = bench;
  window.document().save(folder.filePath("DATA.txt").toStdString());
  QSignalSpy spy(&window.runPanel(), &RunPanel::finished);
  for (const auto& [steps, time, said] :
       {std::tuple{"1000000", "1e12", " of 1000000, "}, {"100000000", "1e6", " of 8.56"}}) {
    shorten(window.document(), steps);
    window.document().edit(cell("fTime"), time);
    if (fs::exists(folder.filePath("RUN.json").toStdString()))
      replace_and_run(window);
    else
      window.runDeck();
    // The pace is unknown before the first step.
    REQUIRE(QTest::qWaitFor(
        [&] { return note(window).startsWith("Step ") && !note(window).startsWith("Step 0,"); },
        60000));
    INFO(note(window).toStdString());
    CHECK(note(window).contains(said));
    press(window, "cancel");
    REQUIRE((!window.runPanel().busy() || spy.wait(60000)));
  }
}

TEST_CASE("questions: Enter never selects an answer that ends or deletes something",
          "[gui][adrinput][questions]") {
  // Every box with a choice names its default: Cancel, or Save where the other way is to discard.
  const QRegularExpression choice("Destructive|Discard|::Save\\b|::Yes\\b|AcceptRole");
  const QRegularExpression harmless(
      "setDefaultButton\\(QMessageBox::(Cancel|No|Ok)\\)|"
      "Discard[\\s\\S]*setDefaultButton\\(QMessageBox::Save\\)");
  const QRegularExpression static_box("QMessageBox::(question|warning|critical)\\(");
  // A box that spares the next question is for a hand that ticks it.
  const QRegularExpression ticked("setChecked\\((?!false)");
  int questions = 0;
  bool replaces = false;
  for (const char* program : {"adrinput", "adrplot", "agore", "desktop"})
    for (const auto& entry : fs::recursive_directory_iterator(test::source_dir() / program)) {
      if (entry.path().extension() != ".cpp") continue;
      const QString source = QString::fromStdString(bytes_of(entry.path()));
      INFO(entry.path().string());
      CHECK_FALSE(source.contains(static_box));
      const QStringList boxes = source.split("new QMessageBox(");
      for (qsizetype i = 1; i < boxes.size(); ++i) {
        const QString box = boxes[i].section("->open()", 0, 0);
        if (!box.contains(choice)) continue;
        ++questions;
        replaces = replaces || (box.contains("replace-results") && box.contains("setCheckBox"));
        INFO(box.toStdString());
        CHECK(box.contains(harmless));
        CHECK_FALSE(box.contains(ticked));
      }
    }
  CHECK(questions >= 6);
  CHECK(replaces);
}
