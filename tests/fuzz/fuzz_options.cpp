#include "base/errors.hpp"
#include "deck/templates.hpp"
#include "runs/option_file.hpp"

#include <cstdint>
#include <string>

using namespace adore;
using namespace adore::runs;

/// ADORE.json with any bytes: the file is read or its problem has a message, an unchanged file
/// keeps its text, and what the deck takes of it can be written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const OptionFile file = OptionFile::from_text(text);
  if (!file.problem().empty()) return 0;
  for (const auto& [name, value] : file.values()) (void)option_problem(name, value);
  for (const std::string& name : file.unknown_names()) (void)unknown_name_text(name);
  (void)file.with(file.values());
  (void)file.with({});
  static const deck::Deck kDeck = deck::new_deck("ball");
  deck::Deck deck = kDeck;
  const std::vector<Issue> issues = set_extension(deck, file, "DATA.txt");
  const OptionFile written = OptionFile::from_text(file.with_variables(deck));
  demand(written.problem().empty(), "a written file cannot be read");
  if (!issues.empty()) return 0;
  deck::Deck again = kDeck;
  (void)set_extension(again, written, "DATA.txt");
  demand(again == deck, "a written file gives another deck");
  return 0;
}
