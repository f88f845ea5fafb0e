#include "adrinput/document.hpp"
#include "adrinput/driver.hpp"
#include "deck/templates.hpp"
#include "runs/deck_request.hpp"
#include "runs/rehearsal.hpp"

#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

/// Marks at records of decks with a wrong value.
using namespace adore;
using namespace adore::adrinput;

TEST_CASE("record list: deck that a run accepts → ready; records with errors are not checked off",
          "[adrinput][slow]") {
  const deck::Deck base = deck::new_deck("ball");
  int refused = 0, accepted = 0;
  for (const deck::RecordData& record : base.records) {
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 0; v < spec.variables.size(); ++v) {
      if (record.values[v].empty() || spec.variables[v].type == deck::VarType::String) continue;
      for (const char* text : {"-1", "0", "1e9"}) {
        Document document;
        document.start_new("ball");
        const Cell cell{record.id, record.instance, v, 0};
        document.edit(cell, text);
        document.end_undo_step();
        document.check_model();
        INFO("record " << record.id << ", " << spec.variables[v].name << " = " << text);
        // A text that is not a valid value does not reach the deck.
        const bool draft = document.has_unparsed_text(cell);
        // As `adore run` reads the deck that would be saved.
        std::vector<Issue> reasons;
        try {
          runs::DeckRequest request;
          request.text = deck::write_deck(document.deck());
          request.in_memory = true;
          reasons = runs::dry_run_errors(runs::load_deck(request));
        } catch (const InputError& error) {
          reasons = error.issues();
          if (reasons.empty()) reasons.emplace_back();
        }
        if (document.needs_start_check())
          document.set_start_check_result(document.candidate(), reasons);
        const bool runs = reasons.empty() && !draft;
        CHECK((document.deck_state() == DeckState::Ready) == runs);
        if (draft) CHECK(document.state_of(record.id) != RecordState::Complete);
        for (const Problem& problem : document.problems())
          if (problem.issue.severity == Severity::Error || problem.refused)
            CHECK(document.state_of(problem.page) != RecordState::Complete);
        // Each rejection is reported, so that no mark hides it.
        if (!runs && !draft) CHECK_FALSE(document.problems().empty());
        ++(runs ? accepted : refused);
      }
    }
  }
  CHECK(refused > 50);
  CHECK(accepted > 50);
}

TEST_CASE("adrinput: missing start state → error at the record that needs it", "[adrinput]") {
  const QTemporaryDir folder;
  for (const char* code : {"-1", "1"}) {
    runs::LoadedDeck input;
    input.path = folder.filePath("DATA.txt").toStdString();
    input.deck = deck::new_deck("ball");
    const std::vector<std::pair<std::string, std::string>> sets{{"kIcOpt", code}};
    input.deck.set_all(sets);
    const std::vector<Issue> refused = runs::dry_run_errors(std::move(input));
    REQUIRE(refused.size() == 1);
    CHECK(refused[0].variable == "kIcOpt");
    CHECK(refused[0].record == "1");
    CHECK(refused[0].message.find("FINAL") != std::string::npos);
    Document document;
    document.start_new("ball");
    document.edit(cell("kIcOpt"), code);
    document.set_start_check_result(document.candidate(), refused);
    CHECK(document.state_of("1") != RecordState::Complete);
  }
}
