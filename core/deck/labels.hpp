#pragma once

#include "deck/scanner.hpp"
#include "deck/schema.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The record labels of a deck as signposts. A label is free text, so it is only a hint; but when
/// most labels of a deck name their records in order ('Rec 5A', '5a geometry', 'Record 7.2.1'), a
/// reader that lost its way can trust them.
namespace adore::deck {

/// Content of one label.
struct LabelHint {
  std::size_t record = 0;  ///< index in schema()
  int instance = 0;        ///< of a repeated record, 0 when the label does not say
};

std::optional<LabelHint> parse_label(std::string_view text);

/// The id in a label that names another record, or another instance, than this one; else empty.
[[nodiscard]] std::string conflicting_record_id(std::string_view text, const RecordSpec& spec,
                                                int instance);

/// A line that starts with quoted text.
struct Label {
  std::size_t line = 0;  ///< 0-based
  std::string text;
  std::optional<LabelHint> hint;
  int values =
      0;  ///< numbers and texts that follow, up to the first word that is neither or the next label
};

class RecordLabels {
 public:
  explicit RecordLabels(const Scanner& scanner);

  /// Do enough labels name records, in the order of the deck?
  [[nodiscard]] bool trusted() const { return trusted_; }
  /// The label on that line, or nullptr.
  [[nodiscard]] const Label* label_on_line(std::size_t line) const;
  /// The first label below that line, or nullptr.
  [[nodiscard]] const Label* first_label_after(std::size_t line) const;

 private:
  std::vector<Label> labels_;  // in order of lines
  bool trusted_ = false;
};

}  // namespace adore::deck
