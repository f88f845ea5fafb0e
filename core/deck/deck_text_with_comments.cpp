#include "deck/deck_text_with_comments.hpp"

#include "base/errors.hpp"
#include "deck/lookup.hpp"
#include "deck/remarks.hpp"
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

/// Values of a record that differ, each as the exchange of one word; nothing when one of them is
/// not a separate word.
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
    std::reverse(list->begin(), list->end());  // the text before it does not change
    for (const Exchange& e : *list) out.replace(e.at, e.length, e.by);
  }
  return out;
}

/// The line of one record as the writer has it, without its end.
std::string written(const RecordData& record) {
  Deck alone;
  alone.records.push_back(record);
  std::string line = write_deck(alone);
  line.pop_back();
  return line;
}

/// Text from the start of one line to the start of another (0-based), line ends included.
std::string_view lines_between(std::string_view text, const Scanner& scanner, std::size_t first,
                               std::size_t behind) {
  const auto start = [&](std::size_t line) {
    return line < scanner.lines().size()
               ? static_cast<std::size_t>(scanner.lines()[line].data() - text.data())
               : text.size();
  };
  return text.substr(start(first), start(behind) - start(first));
}

/// Record by record: its own text where it has one.
std::optional<std::string> joined(std::string_view text, const Deck& before, const Deck& after) {
  if (before.records.empty()) return std::nullopt;
  const Scanner scanner(text);
  const auto first_line = [&](std::size_t r) {
    return static_cast<std::size_t>(before.records[r].line) - 1;
  };
  for (std::size_t r = 0; r < before.records.size(); ++r)
    if (before.records[r].line == 0 || (r > 0 && first_line(r) <= first_line(r - 1)))
      return std::nullopt;
  std::string out(lines_between(text, scanner, 0, first_line(0)));
  for (const RecordData& is : after.records) {
    const auto was = std::find_if(
        before.records.begin(), before.records.end(), [&](const RecordData& candidate) {
          return candidate.id == is.id && candidate.instance == is.instance;
        });
    if (was == before.records.end()) {
      out += written(is) + "\n";
      continue;
    }
    const auto r = static_cast<std::size_t>(was - before.records.begin());
    const RecordEnd end = find_record_end(scanner, *was);
    const std::size_t behind = r + 1 < before.records.size()
                                   ? first_line(r + 1)
                                   : std::min(end.line + 1, scanner.lines().size());
    if (behind <= first_line(r)) return std::nullopt;
    std::string block(lines_between(text, scanner, first_line(r), behind));
    if (!(*was == is)) {
      const std::optional<std::vector<Exchange>> list =
          was->values.size() == is.values.size() && !block.empty()
              ? exchanges(text, scanner, *was, is)
              : std::nullopt;
      if (list) {
        const auto from =
            static_cast<std::size_t>(scanner.lines()[first_line(r)].data() - text.data());
        for (auto e = list->rbegin(); e != list->rend(); ++e) {
          if (e->at < from || e->at + e->length > from + block.size()) return std::nullopt;
          block.replace(e->at - from, e->length, e->by);
        }
      } else {
        const std::string_view after_it = lines_between(text, scanner, end.line + 1, behind);
        std::string_view remark = end.remark;
        const std::size_t said = remark.find_first_not_of(" \t,");
        remark = said == std::string_view::npos ? "" : remark.substr(said);
        // Behind a slash the writer's own line needs none.
        block = written(is) + (remark.empty() ? "" : "  " + std::string(remark)) + "\n" +
                std::string(after_it);
      }
    }
    if (!block.empty() && block.back() != '\n' && block.back() != '\r') block += '\n';
    out += block;
  }
  if (after.user_lines == before.user_lines) {
    const RecordEnd end = find_record_end(scanner, before.records.back());
    out += lines_between(text, scanner, end.line + 1, scanner.lines().size());
  } else {
    for (const std::string& line : after.user_lines) out += line + "\n";
  }
  return out;
}

/// `make(text without marks)` with the byte-order mark and the end-of-file marks of `text` around.
template <class Make>
DeckTextWithComments between_marks(std::string_view text, const Make& make) {
  const std::string_view inside = without_marks(text);
  const auto before = static_cast<std::size_t>(inside.data() - text.data());
  DeckTextWithComments made = make(inside);
  made.text.insert(0, text.substr(0, before));
  made.text += text.substr(before + inside.size());
  return made;
}

/// Remarks behind the values follow a change of kUnit, as far as they are Adore's own.
DeckTextWithComments kept_text(std::string text, UnitSystem before, const Deck& after) {
  if (before == after.units()) return {std::move(text), true, {}};
  UpdatedRemarkUnits units = update_remark_units(text, before);
  return {std::move(units.text), true, std::move(units.doubtful)};
}

DeckTextWithComments deck_in(std::string_view text, const Deck& after) {
  const Deck before = read_deck_text(text, "deck").deck;
  for (const auto& make : {&exchanged, &joined}) {
    if (make == &exchanged && before.user_lines != after.user_lines) continue;
    const std::optional<std::string> kept = make(text, before, after);
    if (!kept) continue;
    const ReadResult again = read_deck_text(*kept, "deck");
    if (again.deck == after) return kept_text(*kept, before.units(), after);
  }
  return {write_deck(after), false, {}};
}

DeckTextWithComments values_in(std::string_view text,
                               std::span<const std::pair<std::string, std::string>> sets) {
  const ReadResult before = read_deck_text(text, "deck");
  Deck after = before.deck;
  after.set_all(sets);
  if (std::optional<std::string> kept = exchanged(text, before.deck, after)) {
    const ReadResult again = read_deck_text(*kept, "deck");
    if (again.ok() && again.deck == after)
      return kept_text(std::move(*kept), before.deck.units(), after);
  }
  return {write_deck(after), false, {}};
}

}  // namespace

DeckTextWithComments with_deck(std::string_view text, const Deck& after) {
  return between_marks(text, [&](std::string_view inside) { return deck_in(inside, after); });
}

DeckTextWithComments with_values(std::string_view text,
                                 std::span<const std::pair<std::string, std::string>> sets) {
  return between_marks(text, [&](std::string_view inside) { return values_in(inside, sets); });
}

}  // namespace adore::deck
