#pragma once

#include "core/results/synthetic.hpp"
#include "deck/deck.hpp"
#include "runs/prepare.hpp"
#include "runs/run.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Decks that are run, with the files of the run.
namespace adore::testing {

struct Ran {
  runs::RunOutcome outcome;
  nlohmann::json report;  ///< RUN.json
  std::string print;      ///< PRINT.txt
};

using Options = std::vector<std::pair<std::string, std::string>>;

inline Ran run_deck(const deck::Deck& deck, const std::filesystem::path& folder, bool go_on = false,
                    const Options& options = {}) {
  std::filesystem::create_directories(folder);
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.go_on = go_on;
  request.options = options;
  Ran out;
  out.outcome = runs::run(request);
  out.report = nlohmann::json::parse(read_bytes(folder / "RUN.json"));
  out.print = read_bytes(folder / "PRINT.txt");
  return out;
}

/// Why a deck is refused, or "was accepted".
inline std::string refusal_of(const deck::Deck& deck) {
  runs::DeckRequest request;
  request.text = deck::write_deck(deck);
  try {
    (void)runs::prepare(request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "was accepted";
}

}  // namespace adore::testing
