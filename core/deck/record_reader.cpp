#include "deck/record_reader.hpp"

#include "base/counted.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace adore::deck {
namespace {

constexpr std::size_t kMaxIssues = 500;

std::string quote_problem(const Token& token) {
  return token.unterminated ? "the closing quote is missing on this line"
                            : "text follows directly after the closing quote";
}

bool is_bad_quote(const Token& token) {
  return token.kind == Token::Kind::Quoted && (token.unterminated || token.joined);
}

}  // namespace

ReadState::ReadState(const Scanner& text, const RecordLabels& all_labels, bool follow_labels,
                     std::string file_name)
    : scanner(text), labels(all_labels), use_labels(follow_labels) {
  result.deck.file = std::move(file_name);
}

int ReadState::expected_value_count(const RecordSpec& of) const {
  int count = 0;
  for (std::size_t i = 1; i < of.variables.size(); ++i)
    count += array_length(result.deck, of.variables[i]);
  return count;
}

void ReadState::add(Issue issue) {
  if (result.issues.size() < kMaxIssues)
    result.issues.push_back(std::move(issue));
  else
    ++issues_dropped;
}

void ReadState::report(Severity severity, int line, std::string_view variable, std::string value,
                       std::string message, std::string remedy) {
  Issue issue;
  issue.severity = severity;
  issue.file = result.deck.file;
  issue.line = line;
  if (spec != nullptr) {
    issue.record = spec->id;
    issue.variable = variable;
    if (!spec->repeat.empty() && !variable.empty()) issue.variable += fmt::format("[{}]", instance);
  }
  issue.value = std::move(value);
  issue.message = std::move(message);
  issue.remedy = std::move(remedy);
  add(std::move(issue));
}

void RecordReader::read(const RecordSpec& spec, int instance) {
  pending_repeats_ = 0;
  slash_reached_ = broken_ = last_word_was_prose_ = has_blank_separators_ = false;
  comma_count_ = 0;
  detached_token_ = {};
  last_bad_word_line_ = 0;
  RecordData empty;
  empty.id = spec.id;
  empty.instance = instance;
  empty.line = static_cast<int>(state_.scanner.position().line) + 1;
  empty.values.resize(spec.variables.size());
  empty.values[0].resize(1);
  state_.deck().records.push_back(
      std::move(empty));  // already part of the deck: counts are looked up there
  RecordData& data = state_.deck().records.back();

  read_label(data);
  for (std::size_t i = 1; i < spec.variables.size(); ++i) {
    const VariableSpec& variable = spec.variables[i];
    data.values[i].resize(static_cast<std::size_t>(array_length(state_.deck(), variable)));
    for (std::size_t k = 0; k < data.values[i].size(); ++k) {
      bool given = false;
      if (!read_value(variable, i, data.values[i][k], given))
        state_.reported.values.insert({data.id, instance, std::string(variable.name)});
      else if (!given && !variable.default_value.empty())
        data.defaulted.push_back({i, k});
    }
  }
  if (!slash_reached_ && !broken_) warn_about_detached_value();
  if (!slash_reached_ && !broken_) warn_about_surplus_values();
  if (!slash_reached_ && !broken_) note_missing_final_newline();
  mark_doubtful_integers(data);
}

/// The label, or a complaint.
void RecordReader::read_label(RecordData& data) {
  const auto complain = [&](Severity severity, const Token& token, std::string message,
                            std::string remedy) {
    state_.report(severity, token.line, "recID", token.text, std::move(message), std::move(remedy));
    state_.reported.values.insert({data.id, data.instance, "recID"});
  };
  const Scanner::Position start = state_.scanner.position();
  const Token token = state_.scanner.next();
  if (token.kind == Token::Kind::Slash) slash_reached_ = true;
  if (token.kind == Token::Kind::Slash || token.kind == Token::Kind::Null)
    return;  // the checks notice
  double number = 0.0;
  if (token.kind == Token::Kind::Word &&
      !parse_real(token.text, number)) {  // the line holds just the values
    complain(Severity::Error, token, "the record has no label",
             fmt::format("start the record with a label in single quotes, such as 'Rec {}'",
                         state_.spec->id));
    state_.scanner.set_position(start);
    return;
  }
  data.values[0][0] = token.text;
  if (token.kind == Token::Kind::Word)
    complain(Severity::Warning, token, "the label should be in single quotes",
             fmt::format("write '{}'", token.text));
  else if (const std::string other = conflicting_record_id(token.text, *state_.spec, data.instance);
           !other.empty())
    complain(Severity::Warning, token,
             fmt::format("the label names record {}, but the values are read as record {}", other,
                         default_label(*state_.spec, data.instance).substr(4)),
             fmt::format("write '{}', or check the order of the records",
                         default_label(*state_.spec, data.instance)));
  if (is_bad_quote(token)) {
    complain(Severity::Error, token, quote_problem(token),
             "put single quotes around the label and a comma after it");
    broken_ = true;
  } else if (token.repeat != 1) {
    complain(Severity::Error, token, "a label cannot be repeated",
             "write the label without the repeat count (r*)");
  }
}

/// Is a text at the start of a line the label of a later record, although a text is due?
bool RecordReader::is_next_label(const Token& token) const {
  const Label* label = state_.labels.label_on_line(static_cast<std::size_t>(token.line) - 1);
  return state_.use_labels && label != nullptr && label->values > 0 && label->hint &&
         &schema()[label->hint->record] > state_.spec;
}

/// Makes pending_ a token with uses left. False when there is none and that has been reported.
bool RecordReader::fetch_token(const VariableSpec& variable, std::size_t position) {
  if (pending_repeats_ > 0) return true;
  const Scanner::Position before = state_.scanner.position();
  note_separator(position);
  pending_ = state_.scanner.next();
  if (detached_variable_index_ == position && detached_token_.line < 0) detached_token_ = pending_;
  const bool next_record = pending_.kind == Token::Kind::Quoted && pending_.first_in_line &&
                           (variable.type != VarType::String || is_next_label(pending_));
  if (pending_.kind == Token::Kind::End || next_record) {
    if (next_record) state_.scanner.set_position(before);
    report_missing_values(pending_, position);
    return false;
  }
  if (pending_.repeat == 0) {
    state_.report(Severity::Error, pending_.line, variable.name, "0*" + pending_.text,
                  "a repeat count of 0 is not valid", "write r*value with r of at least 1");
    return false;
  }
  pending_repeats_ = pending_.repeat;
  return true;
}

/// False if there is no value, which has been reported. `given`: the deck gives the value.
bool RecordReader::read_value(const VariableSpec& variable, std::size_t position, Value& value,
                              bool& given) {
  if (!variable.default_value.empty()) value = default_value(variable);
  if (slash_reached_) return true;  // without a default the checks complain
  if (broken_ || !fetch_token(variable, position)) return false;
  --pending_repeats_;
  if (pending_.kind == Token::Kind::Slash) {
    slash_reached_ = true;
    return true;
  }
  given = pending_.kind != Token::Kind::Null;
  return !given || store(variable, pending_, value);
}

bool RecordReader::store(const VariableSpec& variable, const Token& token, Value& value) {
  if (is_bad_quote(token)) {
    state_.report(Severity::Error, token.line, variable.name, token.text, quote_problem(token),
                  "put the text in single quotes; write a quote inside the text twice");
    broken_ = true;
    return false;
  }
  if (variable.type != VarType::String) return store_number(variable, token, value);
  if (token.kind == Token::Kind::Word)
    state_.report(Severity::Warning, token.line, variable.name, token.text,
                  "text should be in single quotes", fmt::format("write '{}'", token.text));
  value = token.text;
  return true;
}

bool RecordReader::store_number(const VariableSpec& variable, const Token& token, Value& value) {
  const bool whole = variable.type == VarType::Integer;
  if (token.kind == Token::Kind::Quoted) {
    const std::string_view kind = whole ? "an integer" : "a number";
    state_.report(Severity::Error, token.line, variable.name, "'" + token.text + "'",
                  fmt::format("is text, but {} is required", kind),
                  fmt::format("give {} without quotes", kind));
    return false;
  }
  long long integer = 0;
  double real = 0.0;
  const NumberProblem problem =
      whole ? parse_integer(token.text, integer) : parse_real(token.text, real);
  if (!problem) {
    last_word_was_prose_ = false;
    if (whole)
      value = integer;
    else
      value = real;
    return true;
  }
  const bool prose = std::isalpha(static_cast<unsigned char>(token.text[0])) != 0;
  if (prose && last_word_was_prose_ &&
      token.line == last_bad_word_line_) {  // two words in a row: the values are over
    broken_ = true;
    return false;
  }
  last_word_was_prose_ = prose;
  last_bad_word_line_ = token.line;
  state_.report(Severity::Error, token.line, variable.name, token.text, problem.message,
                problem.remedy);
  return false;
}

/// The values end before variable `position` has its own.
void RecordReader::report_missing_values(const Token& token, std::size_t position) {
  broken_ = true;
  constexpr std::size_t kMaxNames = 6;
  const RecordSpec& spec = *state_.spec;
  std::string names;
  const std::size_t listed = std::min(spec.variables.size(), position + kMaxNames);
  for (std::size_t i = position; i < listed; ++i)
    names += (names.empty() ? "" : ", ") + std::string(spec.variables[i].name);
  if (listed < spec.variables.size())
    names += fmt::format(" and {} more", spec.variables.size() - listed);
  const bool end = token.kind == Token::Kind::End;
  state_.report(
      Severity::Error, state_.deck().records.back().line, spec.variables[position].name, "",
      end ? fmt::format("the deck ends in this record, without values for {}", names)
          : fmt::format(
                "the record has too few values: no value for {} before the next record '{}'", names,
                token.text),
      fmt::format("give {} for record {}", counted(state_.expected_value_count(spec) + 1, "value"),
                  spec.id));
}

/// A deck that was cut in its last number reads like a whole one; a missing line end gives it away.
void RecordReader::note_missing_final_newline() {
  if (!state_.scanner.is_at_unterminated_end()) return;
  state_.report(
      Severity::Note, state_.deck().records.back().line, "", "",
      "the file ends right after this value, without an end of line, and may be truncated",
      "check the last value and add an end of line");
}

/// Text between the last value and the next one, on the same line.
void RecordReader::note_separator(std::size_t position) {
  const std::string_view rest = state_.scanner.rest_of_line();
  const std::size_t next = rest.find_first_not_of(" \t");
  if (next == std::string_view::npos) return;
  if (rest[next] == ',') {
    ++comma_count_;
    detached_token_ = {};
  } else if (next < 2) {
    has_blank_separators_ = true;
  } else if (detached_token_.text.empty()) {
    detached_variable_index_ = position;
    detached_token_.line = -1;  // the token that comes now
  }
}

/// Commas between all values, then a gap, a number and prose: "0.018   2 races". The number may
/// have been meant as part of the comment, and a value be missing.
void RecordReader::warn_about_detached_value() {
  if (detached_token_.text.empty() || comma_count_ < 2 || has_blank_separators_) return;
  const std::string_view rest = state_.scanner.rest_of_line();
  const std::size_t word = rest.find_first_not_of(" \t");
  if (word == std::string_view::npos || std::isalpha(static_cast<unsigned char>(rest[word])) == 0)
    return;
  state_.report(
      Severity::Warning, detached_token_.line,
      state_.spec->variables[detached_variable_index_].name, detached_token_.text,
      "was read as a value, but it is separated from the other values and followed by text, "
      "like the start of a comment",
      "if the number is a value of the record, put a comma before it; otherwise add the missing "
      "value");
}

/// Text after the last value is ignored by the rules, but a number after a comma is likely a
/// mistake.
void RecordReader::warn_about_surplus_values() {
  if (pending_repeats_ > 0) {
    state_.report(
        Severity::Warning, pending_.line, "", "",
        fmt::format("a repeat count gives more values than the record has variables; {} ignored",
                    pending_repeats_ == 1 ? "1 is" : fmt::format("{} are", pending_repeats_)),
        "lower the repeat count");
    return;
  }
  const std::string_view rest = state_.scanner.rest_of_line();
  const std::size_t comma = rest.find_first_not_of(" \t");
  if (comma == std::string_view::npos || rest[comma] != ',') return;
  std::string_view word = rest.substr(comma + 1);
  word.remove_prefix(std::min(word.find_first_not_of(" \t"), word.size()));
  word = word.substr(0, word.find_first_of(" \t,/"));
  double number = 0.0;
  if (word.empty() || parse_real(word, number)) return;
  state_.report(Severity::Warning, static_cast<int>(state_.scanner.position().line) + 1, "",
                std::string(word),
                fmt::format("the record has {}; further values on the line are ignored",
                            counted(state_.expected_value_count(*state_.spec) + 1, "value")),
                "remove the extra values, or use a decimal point instead of a decimal comma");
}

/// Conditions must not be trusted where they ask for a value that is missing or wrong.
void RecordReader::mark_doubtful_integers(const RecordData& data) {
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    const VariableSpec& variable = state_.spec->variables[i];
    for (const Value& value : data.values[i])
      if (variable.type == VarType::Integer && !is_reliable_integer(variable, value))
        state_.reported.doubtful.insert(std::string(variable.name));
  }
}

}  // namespace adore::deck
