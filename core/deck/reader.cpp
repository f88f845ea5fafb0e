#include "deck/reader.hpp"

#include "base/counted.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"
#include "deck/orbit_records.hpp"
#include "deck/record_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

/// Walks through the schema and the text in parallel: the records already read determine the
/// next record.
namespace adore::deck {
namespace {

class Reader {
 public:
  Reader(const Scanner& scanner, const RecordLabels& labels, bool use_labels, std::string file_name)
      : state_(scanner, labels, use_labels, std::move(file_name)), record_reader_(state_) {}

  ReadResult read();

 private:
  /// Action for the next record.
  enum class Step : unsigned char { Read, Missing, Skip };

  void read_records(std::size_t index);
  bool find_record_at(std::size_t index, bool certain, Step& step);
  [[nodiscard]] Step next_step(std::size_t index, bool certain) const;
  bool pass_over_numbers();
  [[nodiscard]] bool acts_on_shelf(const RecordSpec& extra);
  void skip_record();
  void shelve(const RecordSpec& extra, int instance);
  void note_missing(Step step, bool doubtful);
  void report_missing_at_end();
  void read_extension();
  void keep_user_lines();
  [[nodiscard]] bool is_doubtful(std::string_view condition) const;

  ReadState state_;
  RecordReader record_reader_;
  std::vector<std::string> missing_at_end_;
};

ReadResult Reader::read() {
  if (!state_.scanner.skip_to_record_start()) {
    state_.report(Severity::Error, 0, "", "", "the deck is empty",
                  "write an example deck, for instance with `adore new ball`");
    return std::move(state_.result);
  }
  const std::span<const RecordSpec> records = schema();
  for (std::size_t index = 0; index < records.size(); ++index)
    if (records[index].id != "12" && !is_extension(records[index].id)) read_records(index);
  report_missing_at_end();
  read_extension();
  keep_user_lines();
  for (Issue& issue : check_deck(state_.deck(), state_.reported)) state_.add(std::move(issue));
  std::vector<Issue>& issues = state_.result.issues;
  std::stable_sort(issues.begin(), issues.end(),
                   [](const Issue& a, const Issue& b) { return a.line < b.line; });
  if (state_.issues_dropped > 0) {
    Issue more;
    more.severity = Severity::Note;
    more.file = state_.deck().file;
    more.message =
        counted(state_.issues_dropped, "more problem is", "more problems are") + " not listed";
    more.remedy = "correct the listed problems first";
    issues.push_back(std::move(more));
  }
  return std::move(state_.result);
}

bool Reader::is_doubtful(std::string_view condition) const {
  const std::vector<std::string_view> names = variable_names_in(condition);
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    return state_.reported.doubtful.count(std::string(name)) > 0;
  });
}

/// All instances of one record of the schema, when the deck needs it. Where an earlier mistake
/// makes that uncertain, only a label can tell.
void Reader::read_records(std::size_t index) {
  const RecordSpec& spec = schema()[index];
  const bool required = evaluate(spec.condition, condition_scope(state_.deck()));
  const bool doubtful = is_doubtful(spec.condition) || is_doubtful(spec.repeat);
  const bool by_label = doubtful && state_.use_labels;
  if (!required && !by_label) return;
  state_.spec = &spec;
  for (state_.instance = 1; by_label || state_.instance <= repeat_count(state_.deck(), spec);
       ++state_.instance) {
    Step step = Step::Missing;
    const bool found = find_record_at(index, !by_label, step);
    if (found && step == Step::Read) {
      record_reader_.read(spec, state_.instance);
      if (by_label && spec.repeat.empty()) return;
      continue;
    }
    if (!by_label) {
      note_missing(step, doubtful);
      if (!found && !doubtful) missing_at_end_.emplace_back(spec.id);
    }
    return;  // further instances are missing too
  }
}

/// Goes to the next line that can be a record. False at the end of the deck.
bool Reader::find_record_at(std::size_t index, bool certain, Step& step) {
  while (state_.scanner.skip_to_record_start()) {
    if (pass_over_numbers()) continue;
    step = next_step(index, certain);
    if (step != Step::Skip) return true;
    skip_record();
  }
  step = Step::Skip;
  return false;
}

Reader::Step Reader::next_step(std::size_t index, bool certain) const {
  const Label* label = state_.label_on_current_line();
  const bool hinted = state_.use_labels && label != nullptr && label->hint.has_value();
  if (!certain) {  // only the label identifies this record
    const bool this_one = hinted && label->hint->record == index &&
                          (label->hint->instance == 0 || label->hint->instance == state_.instance);
    return this_one ? Step::Read : Step::Missing;
  }
  if (!hinted || label->hint->record == index) return Step::Read;
  const std::span<const RecordSpec> records = schema();
  const std::size_t hint = label->hint->record;
  const bool fits = label->values == state_.expected_value_count(records[index]);
  const bool fits_hint = label->values == state_.expected_value_count(records[hint]);
  if (fits && !fits_hint) return Step::Read;  // a wrong label on the right record
  const Label* next = state_.labels.first_label_after(label->line);
  if (hint > index) {
    const bool out_of_order =
        next != nullptr && next->hint && next->hint->record <= hint && records[hint].repeat.empty();
    return fits && out_of_order ? Step::Read : Step::Missing;
  }
  const bool back_in_step = next != nullptr && next->hint && next->hint->record == index;
  return back_in_step || fits_hint ? Step::Skip : Step::Read;
}

/// Lines that start with a number where a label is due belong to nothing, unless they hold just
/// what the record needs. True when some were passed over.
bool Reader::pass_over_numbers() {
  constexpr long long kMaxCountedValues = 20000;
  Scanner ahead = state_.scanner;
  const Token first = ahead.next();
  double number = 0.0;
  if (first.kind != Token::Kind::Word || parse_real(first.text, number)) return false;
  long long count = 0;
  for (Token next = first; next.kind == Token::Kind::Word && !parse_real(next.text, number) &&
                           count < kMaxCountedValues;
       next = ahead.next())
    count += std::min(next.repeat, kMaxCountedValues);
  if (count == state_.expected_value_count(*state_.spec)) return false;
  state_.report(Severity::Error, first.line, "recID", first.text,
                "a record label in quotes is expected here, not a number; either the record above "
                "has too many values or the label is missing",
                "remove the extra values or start the record with its label");
  do {
    state_.scanner.go_to_line(state_.scanner.position().line + 1);
  } while (state_.scanner.skip_to_record_start() && state_.label_on_current_line() == nullptr);
  return true;
}

/// Record 3.4 or 9.5 of an orbit in mode -1.
bool Reader::acts_on_shelf(const RecordSpec& extra) {
  return (extra.id == "3.4" && has_enabled_orbit(state_.deck())) ||
         (extra.id == "9.5" && !orbit_records(state_.deck()).empty());
}

/// An extra record: one that the options do not ask for, or one that was there before.
void Reader::skip_record() {
  const Label& label = *state_.label_on_current_line();
  const RecordSpec& extra = schema()[label.hint->record];
  const RecordSpec* const expected = std::exchange(state_.spec, &extra);
  const int line = static_cast<int>(label.line) + 1;
  bool needless = false;
  if (state_.deck().has_record(extra.id) && extra.repeat.empty())
    state_.report(Severity::Error, line, "", "", "the deck already has this record",
                  "remove one of the two records");
  else if (is_doubtful(extra.condition))
    state_.report(Severity::Warning, line, "", "",
                  "this record is ignored: the errors above make it unclear whether it is needed",
                  "correct the errors above first");
  else if (evaluate(extra.condition, condition_scope(state_.deck())))
    state_.report(
        Severity::Warning, line, "", "",
        extra.repeat.empty()
            ? "this record is out of order and is ignored"
            : fmt::format(
                  "the deck has more of these records than `{}` specifies; this record is ignored",
                  extra.repeat),
        extra.repeat.empty() ? "put the records in the order that `adore schema` lists"
                             : "remove the record, or change the options that it depends on");
  else
    needless = true;
  const bool known_before = state_.deck().has_record(extra.id) && extra.repeat.empty();
  if (!known_before && !is_doubtful(extra.condition)) shelve(extra, label.hint->instance);
  if (needless && !acts_on_shelf(extra))
    state_.report(
        Severity::Warning, line, "", "",
        fmt::format(
            "this record is not needed and is ignored, because the condition `{}` is not met",
            extra.condition),
        "remove the record, or change the options that it depends on");
  state_.spec = expected;
  const Label* next = state_.labels.first_label_after(label.line);
  state_.scanner.go_to_line(next == nullptr ? state_.scanner.lines().size() : next->line);
}

/// Keeps a record that the options do not require, without a message: when they change, the checks
/// report its errors.
void Reader::shelve(const RecordSpec& extra, int instance) {
  if (instance == 0 && !extra.repeat.empty()) return;  // its label does not identify it
  const ReportedErrors reported = state_.reported;
  const std::vector<Issue> issues = state_.result.issues;
  const std::size_t dropped = state_.issues_dropped;
  const std::size_t records = state_.deck().records.size();
  record_reader_.read(extra, std::max(1, instance));
  std::vector<RecordData>& all = state_.deck().records;
  if (all.size() > records) {
    state_.deck().shelf.push_back(std::move(all.back()));
    all.pop_back();
  }
  state_.reported = reported;
  state_.result.issues = issues;
  state_.issues_dropped = dropped;
}

void Reader::note_missing(Step step, bool doubtful) {
  const RecordSpec& spec = *state_.spec;
  const int last = std::max(state_.instance, repeat_count(state_.deck(), spec));
  for (int i = state_.instance; i <= last; ++i)
    state_.reported.missing_records.insert({std::string(spec.id), i});
  for (const VariableSpec& variable : spec.variables)
    if (variable.type == VarType::Integer)
      state_.reported.doubtful.insert(std::string(variable.name));
  if (step != Step::Missing || doubtful) return;
  const Label* label = state_.label_on_current_line();
  state_.report(
      Severity::Error, static_cast<int>(state_.scanner.position().line) + 1, "", "",
      fmt::format("the record ({}) is missing; the next record is '{}'", spec.title, label->text),
      fmt::format("insert record {} before this line", spec.id));
}

void Reader::report_missing_at_end() {
  state_.spec = nullptr;
  if (missing_at_end_.empty()) return;
  std::string list;
  for (const std::string& id : missing_at_end_) list += (list.empty() ? "" : ", ") + id;
  state_.spec = find_record(missing_at_end_.front());
  const bool one = missing_at_end_.size() == 1;
  state_.report(
      Severity::Error, static_cast<int>(state_.scanner.lines().size()), "", "",
      one ? fmt::format("the deck ends, but record {} ({}) is required", list, state_.spec->title)
          : fmt::format("the deck ends, but records {} are required", list),
      one ? "add this record" : "add these records");
  state_.spec = nullptr;
}

/// Records X after the last required record. Their labels identify them.
void Reader::read_extension() {
  while (state_.scanner.skip_to_record_start()) {
    const std::size_t line = state_.scanner.position().line;
    const Label* label = state_.labels.label_on_line(line);
    if (label == nullptr || !label->hint || !is_extension(schema()[label->hint->record].id)) break;
    const RecordSpec& spec = schema()[label->hint->record];
    state_.spec = &spec;
    state_.instance = 1;
    const bool again = state_.deck().has_record(spec.id);
    if (again)
      state_.report(Severity::Error, static_cast<int>(line) + 1, "", "",
                    "the deck already has this record", "remove one of the two records");
    record_reader_.read(spec, 1);
    if (again) state_.deck().records.pop_back();
  }
  // Sorted as in the schema.
  std::vector<RecordData>& all = state_.deck().records;
  const auto first = std::find_if(all.begin(), all.end(),
                                  [](const RecordData& data) { return is_extension(data.id); });
  std::sort(first, all.end(), [](const RecordData& a, const RecordData& b) { return a.id < b.id; });
  state_.spec = nullptr;
}

void Reader::keep_user_lines() {
  Scanner& scanner = state_.scanner;
  while (scanner.skip_to_record_start() && state_.use_labels &&
         state_.label_on_current_line() != nullptr && state_.label_on_current_line()->hint)
    skip_record();
  if (!scanner.skip_to_record_start()) return;
  const std::size_t first = scanner.position().line;
  std::vector<std::string>& kept = state_.deck().user_lines;
  for (std::size_t line = first; line < scanner.lines().size(); ++line)
    if (!is_blank_line(scanner.lines()[line])) kept.emplace_back(scanner.lines()[line]);
  const std::string_view last =
      state_.deck().records.empty() ? "" : std::string_view(state_.deck().records.back().id);
  state_.spec = find_record("12");
  state_.report(
      Severity::Warning, static_cast<int>(first) + 1, "", "",
      fmt::format("{} after the last required record{} {} kept as input of user routines",
                  counted(kept.size(), "line"), last.empty() ? "" : fmt::format(" ({})", last),
                  kept.size() == 1 ? "is" : "are"),
      "remove these lines if no user routine reads them");
  state_.spec = nullptr;
}

/// A line such as "'Rec 5A', 0.0127, ..."
bool is_labelled_record(const std::string& line) {
  const Token token = Scanner(line).next();
  return token.kind == Token::Kind::Quoted && parse_label(token.text).has_value();
}

}  // namespace

ReadResult read_deck_records(std::string_view text, std::string file_name) {
  const Scanner scanner(text);
  const RecordLabels labels(scanner);
  ReadResult plain = Reader(scanner, labels, false, file_name).read();
  // A deck that follows the rules is right, independent of its labels. Otherwise they may show
  // the error.
  const bool labelled_rest =
      std::any_of(plain.deck.user_lines.begin(), plain.deck.user_lines.end(), is_labelled_record);
  if (!labels.trusted() || (plain.ok() && !labelled_rest)) return plain;
  return Reader(scanner, labels, true, std::move(file_name)).read();
}

}  // namespace adore::deck
