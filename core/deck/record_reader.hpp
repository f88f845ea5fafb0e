#pragma once

#include "deck/check.hpp"
#include "deck/labels.hpp"
#include "deck/scanner.hpp"

#include <string>
#include <string_view>

namespace adore::deck {

/// Current record and errors so far; shared by the two halves of the reader.
struct ReadState {
  ReadState(const Scanner& text, const RecordLabels& all_labels, bool follow_labels,
            std::string file_name);

  ReadResult result;
  Scanner scanner;
  const RecordLabels& labels;
  bool use_labels;  ///< the record labels help to find missing and surplus records
  ReportedErrors reported;
  std::size_t issues_dropped = 0;

  // The record at hand, for messages.
  const RecordSpec* spec = nullptr;
  int instance = 1;

  [[nodiscard]] Deck& deck() { return result.deck; }
  [[nodiscard]] const Label* label_on_current_line() const {
    return labels.label_on_line(scanner.position().line);
  }
  /// Values after the label; an array whose length is in the same record counts with the values
  /// known so far.
  [[nodiscard]] int expected_value_count(const RecordSpec& of) const;

  void add(Issue issue);
  void report(Severity severity, int line, std::string_view variable, std::string value,
              std::string message, std::string remedy);
};

/// Reads one record, which the scanner stands at, and appends it to the deck.
class RecordReader {
 public:
  explicit RecordReader(ReadState& state) : state_(state) {}
  void read(const RecordSpec& spec, int instance);

 private:
  void read_label(RecordData& data);
  bool read_value(const VariableSpec& variable, std::size_t position, Value& value, bool& given);
  bool fetch_token(const VariableSpec& variable, std::size_t position);
  bool store(const VariableSpec& variable, const Token& token, Value& value);
  bool store_number(const VariableSpec& variable, const Token& token, Value& value);
  void report_missing_values(const Token& token, std::size_t position);
  void note_separator(std::size_t position);
  void warn_about_detached_value();
  void warn_about_surplus_values();
  void note_missing_final_newline();
  void mark_doubtful_integers(const RecordData& data);
  [[nodiscard]] bool is_next_label(const Token& token) const;

  ReadState& state_;
  Token pending_;  // a token whose repeat count is not used up
  long long pending_repeats_ = 0;
  bool slash_reached_ = false;  // a slash was read: the rest keeps its defaults
  bool broken_ = false;  // short or unreadable: the rest has no values, and that has been said
  int comma_count_ = 0;  ///< values after a comma
  bool has_blank_separators_ =
      false;  ///< some values follow single blanks: this is the deck's style
  std::size_t detached_variable_index_ =
      0;                  ///< variable of the first value after the last comma that is set apart
  Token detached_token_;  ///< and that value; text empty: there is none
  bool last_word_was_prose_ = false;  // the last word was prose, not a number
  int last_bad_word_line_ = 0;
};

}  // namespace adore::deck
