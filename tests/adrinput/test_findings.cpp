#include "adrinput/driver.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/run_driver.hpp"
#include "deck/deck.hpp"
#include "deck/templates.hpp"
#include "desktop/findings_bar.hpp"

#include <QListWidget>
#include <QToolButton>

#include <fstream>

/// Findings of statics, plan and run in AdrInput (issue 44 C).
namespace adore::adrinput {
namespace {

/// The 218 bearing of the textbooks: 74 % of a ball's load is beyond the shoulder, and friction
/// cannot hold the spin axis that is given, at either race.
std::filesystem::path overrun_deck(const QTemporaryDir& folder) {
  std::filesystem::path file = folder.filePath("DATA.txt").toStdString();
  deck::Deck deck = deck::new_deck("angular-218");
  deck.set("kAngVel", "2");
  deck.set("angVelOrient", "30");
  deck::write_deck(deck, file);
  return file;
}

std::vector<std::string> codes_of(const std::vector<Finding>& findings) {
  std::vector<std::string> out;
  for (const Finding& one : findings) out.push_back(one.code);
  return out;
}

}  // namespace

TEST_CASE("findings of statics: listed at load, no green sign, a click goes to the field",
          "[gui][adrinput]") {
  RunBench bench;
  DeckWindow& window = bench.window;
  window.openFile(overrun_deck(bench.folder));
  auto* state = window.findChild<QToolButton*>("deck-state");
  REQUIRE(QTest::qWaitFor([&] { return state->text().contains("3 warnings"); }, 60000));
  CHECK(window.document().warnings() == 3);
  auto* problems = window.findChild<QListWidget*>("problems");
  const auto row_of = [&](const QString& text) {
    for (int row = 0; row < problems->count(); ++row)
      if (problems->item(row)->text().contains(text)) return row;
    return -1;
  };
  CHECK(row_of("no problem") < 0);
  REQUIRE(row_of("needs a friction coefficient") >= 0);
  const int row = row_of("extends beyond the shoulder");
  REQUIRE(row >= 0);
  CHECK(window.document().state_of("5A") == RecordState::Doubtful);
  emit problems->itemClicked(problems->item(row));
  CHECK(window.currentRecord() == "5A");
}

TEST_CASE("findings next to the quasi-static solution and the run, which start anew with the deck",
          "[gui][adrinput]") {
  RunBench bench;
  DeckWindow& window = bench.window;
  window.openFile(overrun_deck(bench.folder));
  auto* statics = window.findChild<EvaluationPanel*>("statics");
  const auto bar_of = [](QWidget& panel) -> desktop::FindingsBar& {
    return *panel.findChild<desktop::FindingsBar*>("findings");
  };
  QSignalSpy done(statics, &EvaluationPanel::finished);
  window.runQuasiStatic();
  REQUIRE(done.wait(60000));
  for (const char* code : {"statics.shoulder", "statics.gyroscopic"})
    CHECK_THAT(codes_of(bar_of(*statics).findings()), Catch::VectorContains(std::string(code)));
  run_to_end(window);
  desktop::FindingsBar& of_run = bar_of(window.runPanel());
  CHECK_THAT(codes_of(of_run.findings()), Catch::VectorContains(std::string("statics.shoulder")));
  CHECK(of_run.line().startsWith("3 warnings"));
  emit of_run.list().itemClicked(of_run.list().item(0));
  CHECK(window.currentRecord() == "3.3");  // kAngVel
  DeckWindow later;                        // the stored run of this deck
  later.show();
  later.openFile(overrun_deck(bench.folder));
  CHECK(bar_of(later.runPanel()).line().startsWith("3 warnings"));
}

}  // namespace adore::adrinput
