#include "deck/labels.hpp"

#include "deck/number.hpp"
#include "deck/schema.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

namespace adore::deck {
namespace {

constexpr int kMaxValues = 100'000;

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

/// "Rec 5A", "record no. 5A", "#5A" -> "5A ..."
std::string_view strip_prefix(std::string_view text) {
  for (const std::string_view prefix : {"record", "rec", "card", "r"})
    if (text.size() > prefix.size() && equal_ignoring_case(text.substr(0, prefix.size()), prefix)) {
      const std::string_view rest = text.substr(prefix.size());
      if (std::isalpha(static_cast<unsigned char>(rest[0]))) continue;
      text = rest;
      break;
    }
  // Records of the extension file: "X1".
  if (const std::size_t x = text.find_first_of("Xx");
      x <= 2 && x + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[x + 1])) &&
      text.find_first_not_of(" #") == x)
    return text.substr(x);
  const std::size_t digit = text.find_first_of("0123456789");
  if (digit == std::string_view::npos || digit > 4) return {};
  for (const char c : text.substr(0, digit))
    if (std::isalpha(static_cast<unsigned char>(c)) && c != 'n' && c != 'o' && c != 'N' && c != 'O')
      return {};
  return text.substr(digit);
}

/// The id of a record that a label may name: "Rec 7.2.1: land" -> "7.2.1".
std::string_view id_of(std::string_view text) {
  text = strip_prefix(text);
  const auto end = std::find_if(text.begin(), text.end(),
                                [](unsigned char c) { return !std::isalnum(c) && c != '.'; });
  std::string_view id = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  while (id.ends_with('.')) id.remove_suffix(1);
  return id;
}

/// 0 for the id of the record; with `instances` also 7.2 (0) and 7.2.3 (3) for 7.2.i.
std::optional<int> named_instance(std::string_view id, const RecordSpec& spec, bool instances) {
  if (spec.id == "12") return std::nullopt;
  if (!instances) return equal_ignoring_case(id, spec.id) ? std::optional<int>(0) : std::nullopt;
  if (spec.repeat.empty()) return std::nullopt;
  const std::string_view base = spec.id.substr(0, spec.id.rfind('.'));
  if (equal_ignoring_case(id, base)) return 0;
  if (id.size() <= base.size() + 1 || !id.starts_with(base) || id[base.size()] != '.')
    return std::nullopt;
  const std::string_view number = id.substr(base.size() + 1);
  int instance = 0;
  const auto [stop, error] =
      std::from_chars(number.data(), number.data() + number.size(), instance);
  const bool is_number = error == std::errc() && stop == number.data() + number.size();
  return is_number && instance > 0 ? std::optional<int>(instance) : std::nullopt;
}

/// Counts the values after the label that `scanner` has just passed, without running into the next
/// label.
int count_values(Scanner& scanner) {
  int count = 0;
  for (;;) {
    const Token token = scanner.next();
    if (token.kind == Token::Kind::End || token.kind == Token::Kind::Slash) return count;
    if (token.kind == Token::Kind::Quoted && token.first_in_line) return count;
    double number = 0.0;
    if (token.kind == Token::Kind::Word && parse_real(token.text, number)) return count;
    count = static_cast<int>(std::min<long long>(kMaxValues, count + token.repeat));
  }
}

}  // namespace

std::optional<LabelHint> parse_label(std::string_view text) {
  const std::string_view id = id_of(text);
  if (id.empty()) return std::nullopt;
  const std::span<const RecordSpec> records = schema();
  for (const bool instances : {false, true})
    for (std::size_t i = 0; i < records.size(); ++i)
      if (const auto instance = named_instance(id, records[i], instances))
        return LabelHint{i, *instance};
  return std::nullopt;
}

std::string conflicting_record_id(std::string_view text, const RecordSpec& spec, int instance) {
  const std::string_view id = id_of(text);
  if (id.empty() || !parse_label(text)) return {};
  for (const bool instances : {false, true})
    if (const auto named = named_instance(id, spec, instances);
        named && (*named == 0 || *named == instance))
      return {};
  return std::string(id);
}

RecordLabels::RecordLabels(const Scanner& scanner) {
  Scanner reader = scanner;
  for (std::size_t line = 0; line < reader.lines().size(); ++line) {
    const std::string_view text = reader.lines()[line];
    const std::size_t first = text.find_first_not_of(" \t\v\f");
    if (first == std::string_view::npos || (text[first] != '\'' && text[first] != '"')) continue;
    reader.go_to_line(line);
    Label label;
    label.line = line;
    label.text = reader.next().text;
    label.hint = parse_label(label.text);
    label.values = count_values(reader);
    labels_.push_back(std::move(label));
  }
  std::size_t hints = 0;
  std::size_t rising = 0;
  const LabelHint* last = nullptr;
  for (const Label& label : labels_) {
    if (!label.hint) continue;
    ++hints;
    if (last != nullptr &&
        (label.hint->record > last->record ||
         (label.hint->record == last->record && !schema()[last->record].repeat.empty())))
      ++rising;
    last = &*label.hint;
  }
  trusted_ = hints >= 3 && 10 * hints >= 6 * labels_.size() && 10 * rising >= 7 * (hints - 1);
}

const Label* RecordLabels::label_on_line(std::size_t line) const {
  const auto found =
      std::lower_bound(labels_.begin(), labels_.end(), line,
                       [](const Label& label, std::size_t wanted) { return label.line < wanted; });
  return found == labels_.end() || found->line != line ? nullptr : &*found;
}

const Label* RecordLabels::first_label_after(std::size_t line) const {
  const auto found =
      std::upper_bound(labels_.begin(), labels_.end(), line,
                       [](std::size_t wanted, const Label& label) { return wanted < label.line; });
  return found == labels_.end() ? nullptr : &*found;
}

}  // namespace adore::deck
