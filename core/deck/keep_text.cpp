#include "deck/keep_text.hpp"

#include "base/errors.hpp"
#include "deck/lookup.hpp"
#include "deck/scanner.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace adore::deck {
namespace {

/// A piece of the text and what takes its place.
struct Exchange {
  std::size_t at = 0, length = 0;
  std::string by;
};

/// Values of a record that differ, each as the exchange of one word; nothing when one of them has
/// no word of its own.
std::optional<std::vector<Exchange>> exchanges(std::string_view text, const Scanner& start,
                                               const RecordData& before, const RecordData& after) {
  std::vector<Exchange> out;
  Scanner scanner = start;
  scanner.go_to_line(static_cast<std::size_t>(before.line) - 1);
  long long uses = 0;
  bool single = true;
  for (std::size_t variable = 0; variable < before.values.size(); ++variable)
    for (std::size_t k = 0; k < before.values[variable].size(); ++k) {
      Token token;
      if (uses == 0) {
        token = scanner.next();
        uses = std::max(1LL, token.repeat);
        single = uses == 1 && token.kind == Token::Kind::Word;
      }
      --uses;
      if (k < after.values[variable].size() &&
          before.values[variable][k] == after.values[variable][k])
        continue;
      if (!single || k >= after.values[variable].size()) return std::nullopt;
      const Scanner::Position end = scanner.position();
      const std::string_view line = scanner.lines()[end.line];
      out.push_back(
          {static_cast<std::size_t>(line.data() - text.data()) + end.column - token.text.size(),
           token.text.size(), value_text(after.values[variable][k])});
    }
  return out;
}

std::optional<std::string> exchanged(std::string_view text, const Deck& before, const Deck& after) {
  if (before.records.size() != after.records.size()) return std::nullopt;
  const Scanner start(text);
  std::string out(text);
  for (std::size_t r = before.records.size(); r-- > 0;) {
    const RecordData &was = before.records[r], &is = after.records[r];
    if (was == is) continue;
    if (was.id != is.id || was.instance != is.instance || was.line == 0 ||
        was.values.size() != is.values.size())
      return std::nullopt;
    auto list = exchanges(text, start, was, is);
    if (!list) return std::nullopt;
    std::reverse(list->begin(), list->end());  // what is before stays where it is
    for (const Exchange& e : *list) out.replace(e.at, e.length, e.by);
  }
  return out;
}

}  // namespace

KeptText with_values(std::string_view text,
                     std::span<const std::pair<std::string, std::string>> sets) {
  const ReadResult before = read_deck_text(text, "deck");
  Deck after = before.deck;
  after.set_all(sets);
  if (std::optional<std::string> kept = exchanged(text, before.deck, after)) {
    const ReadResult again = read_deck_text(*kept, "deck");
    if (again.ok() && again.deck == after) return {std::move(*kept), true};
  }
  return {write_deck(after), false};
}

}  // namespace adore::deck
