#include "deck/reader.hpp"

#include "deck/check.hpp"
#include "deck/labels.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

/// Walks the schema and the text side by side: the records already read say which record has to
/// come next.
namespace adore::deck {
namespace {

constexpr std::size_t kMostIssues = 500;

class Reader {
 public:
  Reader(std::string_view text, std::string file_name) : scanner_(text), labels_(scanner_) {
    result_.deck.file = std::move(file_name);
  }

  ReadResult read();

 private:
  /// What to do about the record that has to come next.
  enum class Step : unsigned char { Read, Missing, Skip };

  void read_records(std::size_t index);
  Step next_step(std::size_t index, int instance, bool required);
  void skip_record();
  void read_record(std::size_t index, int instance);
  bool read_label(RecordData& data);
  bool read_value(const VariableSpec& variable, std::size_t position, Value& value);
  bool store(const VariableSpec& variable, const Token& token, Value& value);
  void end_short(const Token& token, const VariableSpec& variable, std::size_t position);
  void warn_about_rest();
  void note_doubtful(const RecordSpec& spec, const RecordData& data);
  void note_missing(const RecordSpec& spec, int instance);
  void report_missing_at_end();
  void keep_user_lines();

  [[nodiscard]] bool is_doubtful(std::string_view condition) const;
  [[nodiscard]] const Label* label_here() const;
  [[nodiscard]] bool is_next_label(const Token& token) const;
  [[nodiscard]] int expected_values(const RecordSpec& spec) const;
  void report(Severity severity, int line, std::string_view variable, std::string value,
              std::string message, std::string remedy);

  ReadResult result_;
  Scanner scanner_;
  Labels labels_;
  Reported reported_;
  std::vector<std::string> missing_at_end_;
  std::size_t issues_dropped_ = 0;

  // The record being read.
  const RecordSpec* spec_ = nullptr;
  int instance_ = 1;
  Token pending_;  // a token whose repeat count is not used up
  long long pending_uses_ = 0;
  bool ended_ = false;   // a slash was read: the rest keeps its defaults
  bool broken_ = false;  // short or unreadable: the rest has no values, and that has been said
  bool last_word_bad_ = false;  // the last word was no number
  int last_line_ = 0;
};

void Reader::report(Severity severity, int line, std::string_view variable, std::string value,
                    std::string message, std::string remedy) {
  if (result_.issues.size() >= kMostIssues) {
    ++issues_dropped_;
    return;
  }
  Issue issue;
  issue.severity = severity;
  issue.file = result_.deck.file;
  issue.line = line;
  if (spec_ != nullptr) {
    issue.record = spec_->id;
    issue.variable = variable;
    if (!spec_->repeat.empty() && !variable.empty())
      issue.variable += fmt::format("[{}]", instance_);
  }
  issue.value = std::move(value);
  issue.message = std::move(message);
  issue.remedy = std::move(remedy);
  result_.issues.push_back(std::move(issue));
}

ReadResult Reader::read() {
  if (!scanner_.start_record()) {
    report(Severity::Error, 0, "", "", "the deck is empty",
           "start from an example, for instance `adore new ball`");
    return std::move(result_);
  }
  const std::span<const RecordSpec> records = schema();
  for (std::size_t index = 0; index < records.size(); ++index)
    if (records[index].id != "12") read_records(index);
  spec_ = nullptr;
  report_missing_at_end();
  keep_user_lines();
  for (Issue& issue : check_deck(result_.deck, reported_)) {
    if (result_.issues.size() >= kMostIssues)
      ++issues_dropped_;
    else
      result_.issues.push_back(std::move(issue));
  }
  std::stable_sort(result_.issues.begin(), result_.issues.end(),
                   [](const Issue& a, const Issue& b) { return a.line < b.line; });
  if (issues_dropped_ > 0) {
    Issue more;
    more.severity = Severity::Note;
    more.file = result_.deck.file;
    more.message = fmt::format("{} more problems are not listed", issues_dropped_);
    more.remedy = "mend the ones above first";
    result_.issues.push_back(std::move(more));
  }
  return std::move(result_);
}

bool Reader::is_doubtful(std::string_view condition) const {
  const std::vector<std::string_view> names = names_in(condition);
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    return reported_.doubtful.count(std::string(name)) > 0;
  });
}

const Label* Reader::label_here() const { return labels_.on_line(scanner_.position().line); }

/// Is a text at the start of a line the label of a later record, although a text is due?
bool Reader::is_next_label(const Token& token) const {
  const Label* label = labels_.on_line(static_cast<std::size_t>(token.line) - 1);
  return labels_.trusted() && label != nullptr && label->values > 0 && label->hint &&
         &schema()[label->hint->record] > spec_;
}

/// Values after the label; an array whose length is in the same record counts with what is known so
/// far.
int Reader::expected_values(const RecordSpec& spec) const {
  int count = 0;
  for (std::size_t i = 1; i < spec.variables.size(); ++i)
    count += array_length(result_.deck, spec.variables[i]);
  return count;
}

void Reader::read_records(std::size_t index) {
  const RecordSpec& spec = schema()[index];
  const bool required = evaluate(spec.condition, scope_of(result_.deck));
  const bool doubtful = is_doubtful(spec.condition) || is_doubtful(spec.repeat);
  const bool by_label = doubtful && labels_.trusted();
  if (!required && !by_label) return;
  for (int instance = 1; by_label || instance <= repeat_count(result_.deck, spec); ++instance) {
    spec_ = &spec;
    instance_ = instance;
    Step step = Step::Skip;
    while (scanner_.start_record()) {
      step = next_step(index, instance, !by_label);
      if (step != Step::Skip) break;
      skip_record();
    }
    if (step == Step::Read) {
      read_record(index, instance);
      if (by_label && spec.repeat.empty()) return;
      continue;
    }
    if (by_label) return;
    note_missing(spec, instance);
    if (step == Step::Missing) {
      const Label* label = label_here();
      report(Severity::Error, static_cast<int>(scanner_.position().line) + 1, "", "",
             fmt::format("the record ({}) is missing; the deck goes on with '{}'", spec.title,
                         label->text),
             fmt::format("insert record {} before this line", spec.id));
    } else if (!doubtful) {
      missing_at_end_.push_back(std::string(spec.id));
    }
    return;  // further instances are missing too
  }
}

Reader::Step Reader::next_step(std::size_t index, int instance, bool required) {
  const Label* label = label_here();
  const bool hinted = labels_.trusted() && label != nullptr && label->hint.has_value();
  if (!required) {  // only the label can say that this record is here
    const bool this_one = hinted && label->hint->record == index &&
                          (label->hint->instance == 0 || label->hint->instance == instance);
    return this_one ? Step::Read : Step::Missing;
  }
  if (!hinted || label->hint->record == index) return Step::Read;
  const std::span<const RecordSpec> records = schema();
  const std::size_t hint = label->hint->record;
  const bool fits = label->values == expected_values(records[index]);
  const bool fits_hint = label->values == expected_values(records[hint]);
  if (fits && !fits_hint) return Step::Read;  // a wrong label on the right record
  const Label* next = labels_.after_line(label->line);
  if (hint > index) {
    const bool out_of_order =
        next != nullptr && next->hint && next->hint->record <= hint && records[hint].repeat.empty();
    return fits && out_of_order ? Step::Read : Step::Missing;
  }
  const bool back_in_step = next != nullptr && next->hint && next->hint->record == index;
  return back_in_step || fits_hint ? Step::Skip : Step::Read;
}

/// An extra record: one that the options do not ask for, or one that was there before.
void Reader::skip_record() {
  const Label* label = label_here();
  const RecordSpec& extra = schema()[label->hint->record];
  const bool repeated = result_.deck.has_record(extra.id) && extra.repeat.empty();
  const RecordSpec* expected = spec_;
  spec_ = &extra;
  instance_ = std::max(label->hint->instance, 1);
  const int line = static_cast<int>(label->line) + 1;
  if (repeated)
    report(Severity::Error, line, "", "", "this record was there before", "remove one of them");
  else if (is_doubtful(extra.condition))
    report(Severity::Warning, line, "", "", "this record cannot be placed and is ignored",
           "mend the errors above first");
  else if (evaluate(extra.condition, scope_of(result_.deck)))
    report(Severity::Warning, line, "", "",
           fmt::format("there are more of these records than `{}` asks for; this one is ignored",
                       extra.repeat),
           "remove it, or change the count");
  else
    report(Severity::Warning, line, "", "",
           fmt::format("this record is not needed and is ignored, because `{}` does not hold",
                       extra.condition),
           "remove it, or change the option");
  spec_ = expected;
  const Label* next = labels_.after_line(label->line);
  scanner_.go_to_line(next == nullptr ? scanner_.lines().size() : next->line);
}

void Reader::read_record(std::size_t index, int instance) {
  const RecordSpec& spec = schema()[index];
  pending_uses_ = 0;
  ended_ = broken_ = last_word_bad_ = false;
  last_line_ = 0;
  {
    RecordData data;
    data.id = spec.id;
    data.instance = instance;
    data.line = static_cast<int>(scanner_.position().line) + 1;
    data.values.resize(spec.variables.size());
    data.values[0].resize(1);
    result_.deck.records.push_back(std::move(data));
  }
  if (!read_label(result_.deck.records.back())) {
    result_.deck.records.pop_back();
    note_missing(spec, instance);
    return;
  }
  for (std::size_t i = 1; i < spec.variables.size(); ++i) {
    const int length = array_length(result_.deck, spec.variables[i]);
    result_.deck.records.back().values[i].resize(static_cast<std::size_t>(length));
    for (int element = 0; element < length; ++element) {
      Value value;
      if (!read_value(spec.variables[i], i, value))
        reported_.values.insert(
            {std::string(spec.id), instance, std::string(spec.variables[i].name)});
      result_.deck.records.back().values[i][static_cast<std::size_t>(element)] = std::move(value);
    }
  }
  if (!ended_ && !broken_) warn_about_rest();
  note_doubtful(spec, result_.deck.records.back());
}

/// The label, or a complaint. False: the line is no record at all and was passed over with those
/// after it.
bool Reader::read_label(RecordData& data) {
  Value& value = data.values[0][0];
  const auto done = [&] { reported_.values.insert({data.id, data.instance, "recID"}); };
  const Scanner::Position start = scanner_.position();
  const Token token = scanner_.next();
  if (token.kind == Token::Kind::Quoted) {
    value = token.text;
    if (token.unterminated || token.joined) {
      report(Severity::Error, token.line, "recID", token.text,
             token.unterminated ? "the quote is not closed on its line"
                                : "text follows the closing quote directly",
             "put the label between two single quotes, then a comma");
      broken_ = true;
    }
    if (token.repeat != 1)
      report(Severity::Error, token.line, "recID", token.text, "a label cannot be repeated",
             "write it without r*");
    return true;
  }
  if (token.kind == Token::Kind::Slash) {
    ended_ = true;
    return true;  // no value: the checks say so
  }
  if (token.kind == Token::Kind::Null) return true;
  double number = 0.0;
  const bool is_number = !parse_real(token.text, number);
  if (!is_number) {
    report(Severity::Warning, token.line, "recID", token.text,
           "the label should be in single quotes", fmt::format("write '{}'", token.text));
    value = token.text;
    return true;
  }
  // A number where a label is due. When the line has as many values as the record needs, only the
  // label is missing.
  Scanner ahead = scanner_;
  ahead.set_position(start);
  int count = 0;
  for (Token next = ahead.next();
       next.kind == Token::Kind::Word && !parse_real(next.text, number) && count < 20000;
       next = ahead.next())
    count += static_cast<int>(std::min<long long>(next.repeat, 20000));
  if (count == expected_values(*spec_)) {
    report(Severity::Error, token.line, "recID", "", "the record has no label",
           fmt::format("start it with a text in single quotes, such as 'Rec {}'", spec_->id));
    done();
    scanner_.set_position(start);
    return true;
  }
  report(Severity::Error, token.line, "recID", token.text,
         "a record label in quotes is due here, not a number; either the record above has too many "
         "values or the label is "
         "missing",
         "remove the surplus values or start the record with its label");
  // Look for this record further down.
  while (scanner_.start_record()) {
    if (label_here() != nullptr) {
      data.line = static_cast<int>(scanner_.position().line) + 1;
      return read_label(data);
    }
    scanner_.go_to_line(scanner_.position().line + 1);
  }
  return false;
}

/// False when there is no value and that has been reported.
bool Reader::read_value(const VariableSpec& variable, std::size_t position, Value& value) {
  if (broken_) return false;
  const auto use_default = [&] {
    if (!variable.default_value.empty()) value = default_value(variable);
    return true;  // without a default the checks complain
  };
  if (ended_) return use_default();
  if (pending_uses_ == 0) {
    const Scanner::Position before = scanner_.position();
    pending_ = scanner_.next();
    pending_uses_ = std::max(pending_.repeat, 1LL);
    const bool quoted = pending_.kind == Token::Kind::Quoted;
    const bool next_record = quoted && pending_.first_in_line &&
                             (variable.type != VarType::String || is_next_label(pending_));
    if (pending_.kind == Token::Kind::End || next_record) {
      if (next_record) scanner_.set_position(before);
      end_short(pending_, variable, position);
      return false;
    }
    if (pending_.repeat == 0) {
      pending_uses_ = 0;
      report(Severity::Error, pending_.line, variable.name, "0*" + pending_.text,
             "a repeat count of 0 has no meaning", "write r*value with r of 1 or more");
      return false;
    }
  }
  --pending_uses_;
  if (pending_.kind == Token::Kind::Slash) {
    ended_ = true;
    pending_uses_ = 0;
    return use_default();
  }
  if (pending_.kind == Token::Kind::Null) return use_default();
  return store(variable, pending_, value);
}

bool Reader::store(const VariableSpec& variable, const Token& token, Value& value) {
  if (token.kind == Token::Kind::Quoted && (token.unterminated || token.joined)) {
    report(Severity::Error, token.line, variable.name, token.text,
           token.unterminated ? "the quote is not closed on its line"
                              : "text follows the closing quote directly",
           "put the text between two single quotes; a quote inside is written twice");
    broken_ = true;
    return false;
  }
  if (variable.type == VarType::String) {
    if (token.kind == Token::Kind::Word)
      report(Severity::Warning, token.line, variable.name, token.text,
             "text should be in single quotes", fmt::format("write '{}'", token.text));
    value = token.text;
    return true;
  }
  const std::string_view kind = variable.type == VarType::Integer ? "an integer" : "a number";
  if (token.kind == Token::Kind::Quoted) {
    report(Severity::Error, token.line, variable.name, "'" + token.text + "'",
           fmt::format("is text where {} is due", kind),
           fmt::format("give {} without quotes", kind));
    return false;
  }
  long long integer = 0;
  double real = 0.0;
  const NumberProblem problem = variable.type == VarType::Integer
                                    ? parse_integer(token.text, integer)
                                    : parse_real(token.text, real);
  if (problem) {
    const bool words = parse_real(token.text, real) && !token.text.empty() &&
                       std::isalpha(static_cast<unsigned char>(token.text[0])) != 0;
    if (words && last_word_bad_ &&
        token.line == last_line_) {  // prose: the values of this record are over
      broken_ = true;
      return false;
    }
    last_word_bad_ = words;
    last_line_ = token.line;
    report(Severity::Error, token.line, variable.name, token.text, problem.message, problem.remedy);
    return false;
  }
  last_word_bad_ = false;
  if (variable.type == VarType::Integer)
    value = integer;
  else
    value = real;
  return true;
}

void Reader::end_short(const Token& token, const VariableSpec& variable, std::size_t position) {
  broken_ = true;
  std::string names;
  std::size_t count = 0;
  for (std::size_t i = position; i < spec_->variables.size(); ++i) {
    if (++count > 6) continue;
    names += (names.empty() ? "" : ", ") + std::string(spec_->variables[i].name);
  }
  if (count > 6) names += fmt::format(" and {} more", count - 6);
  const int start = result_.deck.records.back().line;
  const bool end = token.kind == Token::Kind::End;
  report(Severity::Error, end ? start : token.line - 1, variable.name, "",
         end ? fmt::format("the deck ends inside this record; no value for {}", names)
             : fmt::format("the record is short: no value for {} before the next record '{}'",
                           names, token.text),
         fmt::format("give all {} values of record {}", spec_->variables.size(), spec_->id));
}

/// Text after the last value is ignored by the rules, but a number after a comma is likely a
/// mistake.
void Reader::warn_about_rest() {
  if (pending_uses_ > 0) {
    report(
        Severity::Warning, pending_.line, "", "",
        fmt::format("a repeat count gives {} values more than the record takes; they are ignored",
                    pending_uses_),
        "");
    return;
  }
  const std::string_view rest = scanner_.rest_of_line();
  const std::size_t comma = rest.find_first_not_of(" \t");
  if (comma == std::string_view::npos || rest[comma] != ',') return;
  std::string_view word = rest.substr(comma + 1);
  word.remove_prefix(std::min(word.find_first_not_of(" \t"), word.size()));
  word = word.substr(0, word.find_first_of(" \t,/"));
  double number = 0.0;
  if (word.empty() || parse_real(word, number)) return;
  report(Severity::Warning, static_cast<int>(scanner_.position().line) + 1, "", std::string(word),
         fmt::format("the record takes {} values; what follows is ignored",
                     expected_values(*spec_) + 1),
         "remove the surplus values, or write a decimal comma as a point");
}

void Reader::note_doubtful(const RecordSpec& spec, const RecordData& data) {
  for (std::size_t i = 0; i < spec.variables.size(); ++i) {
    if (spec.variables[i].type != VarType::Integer) continue;
    for (const Value& value : data.values[i])
      if (!is_reliable_integer(spec.variables[i], value))
        reported_.doubtful.insert(std::string(spec.variables[i].name));
  }
}

void Reader::note_missing(const RecordSpec& spec, int instance) {
  for (int i = instance; i <= std::max(instance, repeat_count(result_.deck, spec)); ++i)
    reported_.missing_records.insert({std::string(spec.id), i});
  for (const VariableSpec& variable : spec.variables)
    if (variable.type == VarType::Integer) reported_.doubtful.insert(std::string(variable.name));
}

void Reader::report_missing_at_end() {
  if (missing_at_end_.empty()) return;
  std::string list;
  for (const std::string& id : missing_at_end_) list += (list.empty() ? "" : ", ") + id;
  const RecordSpec* first = find_record(missing_at_end_.front());
  spec_ = first;
  const bool one = missing_at_end_.size() == 1;
  report(Severity::Error, static_cast<int>(scanner_.lines().size()), "", "",
         one ? fmt::format("the deck ends, but record {} ({}) is required", list, first->title)
             : fmt::format("the deck ends, but records {} are required", list),
         one ? "add it" : "add them");
  spec_ = nullptr;
}

void Reader::keep_user_lines() {
  if (!scanner_.start_record()) return;
  const std::size_t first = scanner_.position().line;
  for (std::size_t line = first; line < scanner_.lines().size(); ++line)
    if (!is_blank_line(scanner_.lines()[line]))
      result_.deck.user_lines.emplace_back(scanner_.lines()[line]);
  const std::string_view last =
      result_.deck.records.empty() ? "" : std::string_view(result_.deck.records.back().id);
  report(
      Severity::Warning, static_cast<int>(first) + 1, "", "",
      fmt::format("{} line(s) after the last required record{} are kept as input of user routines",
                  result_.deck.user_lines.size(), last.empty() ? "" : fmt::format(" ({})", last)),
      "remove them when no user routine reads them");
}

}  // namespace

ReadResult read_records_of(std::string_view text, std::string file_name) {
  return Reader(text, std::move(file_name)).read();
}

}  // namespace adore::deck
