#pragma once

#include "base/errors.hpp"
#include "deck/schema.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

/// A deck as data: the user's own numbers in the user's own units. Plain value: copy, compare, undo
/// and diff it.
namespace adore::deck {

/// Empty (std::monostate) = left out with `,,` or `/` and without default.
using Value = std::variant<std::monostate, long long, double, std::string>;

struct RecordData {
  std::string id;    ///< schema record id, "7.2.i" for every instance
  int instance = 1;  ///< 1.. for repeated records
  int line = 0;  ///< 1-based line it started on; 0 when not read from a file. Not part of equality.
  std::vector<std::vector<Value>> values;  ///< [variable in schema order, recID first][element]
  /// An element of `values`.
  struct Element {
    std::size_t variable = 0, element = 0;
    bool operator==(const Element&) const = default;
  };
  /// Values that nobody gave and a default stands in for; see defaults_used(). Not part of
  /// equality.
  std::vector<Element> defaulted;
  bool operator==(const RecordData& other) const {
    return id == other.id && instance == other.instance && values == other.values;
  }
};

/// Values of a deck that were read: a value that is never read has no effect.
class ReadLog {
 public:
  void add(const RecordData& record, std::size_t variable, std::size_t element) {
    if (paused_ == 0) read_.insert({record.id, record.instance, variable, element});
  }
  [[nodiscard]] bool has(const RecordData& record, std::size_t variable,
                         std::size_t element) const {
    return read_.count({record.id, record.instance, variable, element}) > 0;
  }
  void pause() { ++paused_; }
  void resume() { --paused_; }

 private:
  int paused_ = 0;
  std::set<std::tuple<std::string, int, std::size_t, std::size_t>> read_;
};

class Deck {
 public:
  std::string file;                     ///< file that it was read from; for messages only
  std::vector<RecordData> records;      ///< in deck order
  std::vector<std::string> user_lines;  ///< raw lines after the last required record (12.x)
  /// Records that were given but that the options do not ask for: set() and complete() take them
  /// back when the options change. Neither written nor part of equality.
  std::vector<RecordData> shelf;
  /// If set, integer(), real(), si() and text() record the variables that they read. Copies
  /// share it. Not part of equality.
  std::shared_ptr<ReadLog> reads;

  bool operator==(const Deck& other) const {
    return records == other.records && user_lines == other.user_lines;
  }

  [[nodiscard]] bool has_record(std::string_view id, int instance = 1) const;
  /// Is there a value of that name in a record that is present?
  [[nodiscard]] bool has(std::string_view name) const;
  /// Integer variable; 0 when its record is absent (the rule of the conditions).
  [[nodiscard]] long long integer(std::string_view name, int index = 1) const;
  /// Real variable in the deck's units. `instance` picks a repeated record, `index` an array
  /// element (both from 1).
  /// @throws InternalError when no present record has the name: ask has() first.
  [[nodiscard]] double real(std::string_view name, int instance = 1, int index = 1) const;
  /// The same in coherent SI with radians (UnitPair factors of the deck's kUnit).
  [[nodiscard]] double si(std::string_view name, int instance = 1, int index = 1) const;
  [[nodiscard]] std::string text(std::string_view name) const;
  [[nodiscard]] UnitSystem units() const;

  /// Sets one variable from text as `--set` does: "pitchDia", "cageGsCls[2]" (instance of a
  /// repeated record, else array element), "cageGcPos[2][3]" (both), "iCageGuide" with "1,2" (a
  /// whole array). A missing record that the options ask for is added, from the shelf if it is
  /// there, when one of its variables is set; one that they do not ask for takes no value. Others
  /// that a changed option makes necessary are NOT invented: call complete() or check() after. When
  /// it throws, the deck is unchanged.
  /// @throws InputError naming close matches for an unknown variable, or the type that is expected.
  void set(std::string_view name, std::string_view value);
  /// Sets several variables as one change, name and value as in set(): the options among them act
  /// before the records that they control, in any order, and the deck is then
  /// complete(). When it throws, the deck is unchanged.
  /// @throws InputError with every error: also for a variable of a record that the changed deck
  /// does not have, and for one that is given two values.
  void set_all(std::span<const std::pair<std::string, std::string>> sets);
  /// Adds required records that are missing (from the shelf, else default values; 0 / "" where
  /// there is none) and shelves those that no longer apply, in schema order.
  void complete();
  /// An Issue that points at a variable of this deck (file, line, record, value filled in).
  [[nodiscard]] Issue issue(Severity severity, std::string_view name, std::string message,
                            std::string remedy = {}, int instance = 1) const;
};

/// While it lives, values are read for reports only: they are not entered in the deck's log.
class ReportOnly {
 public:
  explicit ReportOnly(const Deck& deck, bool when = true) : log_(when ? deck.reads : nullptr) {
    if (log_) log_->pause();
  }
  ~ReportOnly() {
    if (log_) log_->resume();
  }
  ReportOnly(const ReportOnly&) = delete;
  ReportOnly& operator=(const ReportOnly&) = delete;

 private:
  std::shared_ptr<ReadLog> log_;
};

struct ReadResult {
  Deck deck;                      ///< everything that could be understood
  std::vector<Issue> issues;      ///< syntax, types, counts, options, ranges: all of them at once
  [[nodiscard]] bool ok() const;  ///< no issue of severity Error
};

/// The text of a file less its byte-order mark and the end-of-file marks of old systems, which the
/// reader leaves out.
[[nodiscard]] std::string_view without_marks(std::string_view text);

/// Reads a deck from text; never throws for bad text.
ReadResult read_deck_text(std::string_view text, std::string file_name);
/// @throws InputError when the file cannot be read (missing, a folder, larger than 16 MiB, binary).
ReadResult read_deck(const std::filesystem::path& path);

/// One line per record, comma delimited, decimal point in every locale; reads back to an equal
/// deck.
std::string write_deck(const Deck& deck);
/// Replaces the file atomically. @throws InputError when it cannot be written.
void write_deck(const Deck& deck, const std::filesystem::path& path);

/// Checks values against the schema and against each other (geometry that cannot close,
/// contradictory flags ...), as far as it needs no physics. Called by read_deck; call again after
/// set().
std::vector<Issue> check_deck(const Deck& deck);

}  // namespace adore::deck
