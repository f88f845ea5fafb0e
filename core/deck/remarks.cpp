#include "deck/remarks.hpp"

#include "deck/schema.hpp"
#include "deck/templates.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <utility>

namespace adore::deck {
namespace {

using Names = std::vector<std::pair<std::string_view, std::string_view>>;  // SI, English

/// Every pair of the deck's units; of stresses first as people write them.
const Names& unit_names() {
  static const Names names = [] {
    Names out{{"Pa", "lbf/in^2"}};
    for (const RecordSpec& record : schema())
      for (const VariableSpec& variable : record.variables) {
        const std::pair<std::string_view, std::string_view> pair{variable.unit.si,
                                                                 variable.unit.en};
        if (variable.type == VarType::Real && std::find(out.begin(), out.end(), pair) == out.end())
          out.push_back(pair);
      }
    return out;
  }();
  return names;
}

std::string_view in_system(const std::pair<std::string_view, std::string_view>& pair,
                           UnitSystem system) {
  return system == UnitSystem::English ? pair.second : pair.first;
}

UnitSystem other(UnitSystem system) {
  return system == UnitSystem::English ? UnitSystem::SI : UnitSystem::English;
}

/// "[N, m]" as "[lbf, in]"; nothing when an entry is not a unit of the system.
std::optional<std::string> followed(std::string_view list, UnitSystem before) {
  std::string out;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t end = std::min(list.find(',', from), list.size());
    const std::string_view name = trimmed(list.substr(from, end - from));
    const auto pair = std::find_if(unit_names().begin(), unit_names().end(),
                                   [&](const auto& one) { return in_system(one, before) == name; });
    if (pair == unit_names().end()) return std::nullopt;
    out += (out.empty() ? "" : ", ") + std::string(in_system(*pair, other(before)));
    from = end + 1;
  }
  return out;
}

const std::set<std::string, std::less<>>& own_words() {
  static const std::set<std::string, std::less<>> words = [] {
    std::set<std::string, std::less<>> out{std::string(kCatalogueOutside)};
    for (const TemplateInfo& info : templates()) {
      const std::string_view text = template_text(info.name);
      const Scanner scanner(text);
      for (const RecordData& record : read_deck_text(text, "example").deck.records) {
        const std::string_view remark = find_record_end(scanner, record).remark;
        out.emplace(trimmed(remark.substr(0, remark.find('['))));
      }
    }
    return out;
  }();
  return words;
}

/// Units that are spoken of in one system only: those of decks, and others that people use.
bool is_unit_of(std::string_view word, UnitSystem system, bool behind_a_number) {
  constexpr std::array<std::string_view, 12> kMetric = {
      "mm", "um", "\u00b5m", "kN", "MPa", "GPa", "\u00b0C", "cSt", "mPa.s", "Pa.s", "Nm", "Nmm"};
  constexpr std::array<std::string_view, 7> kImperial = {"inch", "inches", "lb",     "lbs",
                                                         "psi",  "ksi",    "\u00b0F"};
  const auto among = [&](const auto& list) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  if (system == UnitSystem::SI ? among(kMetric) : among(kImperial)) return true;
  const bool known = std::any_of(unit_names().begin(), unit_names().end(), [&](const auto& pair) {
    return pair.first != pair.second && in_system(pair, system) == word;
  });
  // Letters alone are names of other things, too, and "in" is a word.
  const bool letters = word.size() <= 2 && std::all_of(word.begin(), word.end(), [](char c) {
                         return std::isalpha(static_cast<unsigned char>(c)) != 0;
                       });
  return known && (behind_a_number || !letters);
}

/// "3 kN", "12.7mm", "[N]", "(mm)": does a person's remark speak of units of a system?
bool speaks_of(std::string_view remark, UnitSystem system) {
  constexpr std::string_view kBetween = " \t,;:()[]=\"'";
  bool behind_a_number = false;
  for (std::size_t at = remark.find_first_not_of(kBetween); at < remark.size();) {
    const std::size_t end = std::min(remark.find_first_of(kBetween, at), remark.size());
    std::string_view word = remark.substr(at, end - at);
    const bool listed =
        (at > 0 && std::string_view("[(").find(remark[at - 1]) != std::string::npos) &&
        end < remark.size() && std::string_view(",])").find(remark[end]) != std::string::npos;
    const std::size_t unit = word.find_first_not_of("+-.0123456789");
    const bool digits = unit > 0 && word.find_first_of("0123456789") < unit;
    if (digits) word = unit == std::string_view::npos ? "" : word.substr(unit);
    while (word.ends_with('.')) word.remove_suffix(1);
    if (!word.empty() && is_unit_of(word, system, digits || behind_a_number || listed)) return true;
    behind_a_number = digits && word.empty();
    at = remark.find_first_not_of(kBetween, end);
  }
  return false;
}

}  // namespace

RecordEnd find_record_end(const Scanner& start, const RecordData& record) {
  Scanner scanner = start;
  scanner.go_to_line(static_cast<std::size_t>(record.line) - 1);
  std::size_t values = 0;
  for (const auto& elements : record.values) values += elements.size();
  for (std::size_t taken = 0; taken < values;) {
    const Token token = scanner.next();
    if (token.kind == Token::Kind::Slash || token.kind == Token::Kind::End) break;
    taken += static_cast<std::size_t>(std::max(1LL, token.repeat));
  }
  const std::size_t line = std::min(scanner.position().line, scanner.lines().size() - 1);
  return {line, scanner.position().line < scanner.lines().size() ? scanner.rest_of_line() : ""};
}

bool is_generated_comment(std::string_view words) { return own_words().count(trimmed(words)) > 0; }

UpdatedRemarkUnits update_remark_units(std::string_view text, UnitSystem before) {
  UpdatedRemarkUnits out;
  const Deck deck = read_deck_text(text, "deck").deck;
  const Scanner scanner(text);
  std::vector<std::pair<std::size_t, std::pair<std::size_t, std::string>>> changes;
  for (std::size_t r = 0; r < deck.records.size(); ++r) {
    const RecordData& record = deck.records[r];
    if (record.line == 0) continue;
    const RecordEnd end = find_record_end(scanner, record);
    const std::size_t open = end.remark.find('['), close = end.remark.find(']', open);
    if (close != std::string_view::npos && is_generated_comment(end.remark.substr(0, open)))
      if (auto list = followed(end.remark.substr(open + 1, close - open - 1), before)) {
        const auto at = static_cast<std::size_t>(end.remark.data() - text.data()) + open + 1;
        changes.push_back({at, {close - open - 1, std::move(*list)}});
        continue;
      }
    // Lines below a record belong to it.
    const std::size_t next =
        r + 1 < deck.records.size() ? static_cast<std::size_t>(deck.records[r + 1].line) - 1 : 0;
    bool speaks = speaks_of(end.remark, before);
    for (std::size_t line = end.line + 1; line < next; ++line)
      speaks = speaks || speaks_of(scanner.lines()[line], before);
    if (speaks && (out.doubtful.empty() || out.doubtful.back() != record.id))
      out.doubtful.push_back(record.id);
  }
  out.text = text;
  for (auto change = changes.rbegin(); change != changes.rend(); ++change)
    out.text.replace(change->first, change->second.first, change->second.second);
  return out;
}

}  // namespace adore::deck
