#include "base/errors.hpp"
#include "deck/deck.hpp"

#include <cstdint>
#include <string_view>

/// With any bytes, reading never throws or crashes, every issue can be printed, and a deck without
/// errors is written and read again unchanged.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace adore::deck;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const ReadResult result = read_deck_text(text, "fuzz");
  for (const adore::Issue& issue : result.issues)
    adore::demand(!issue.text().empty(), "an issue has a text");
  adore::demand(!result.deck.records.empty() || !result.issues.empty(),
                "nothing is read without a word");

  const std::string written = write_deck(result.deck);
  const ReadResult again = read_deck_text(written, "fuzz");
  // Lines for user routines may look like records; then the second reading has another view of
  // them.
  if (result.ok() && result.deck.user_lines.empty()) {
    adore::demand(again.ok(), "a deck without errors is written without errors");
    adore::demand(again.deck == result.deck, "a deck is written so that it reads back equal");
  }
  Deck completed = result.deck;
  completed.complete();
  (void)check_deck(completed);
  return 0;
}
