#pragma once

#include "adrinput/cell.hpp"
#include "adrinput/typed.hpp"
#include "base/finding.hpp"
#include "runs/option_file.hpp"
#include "runs/run_scales.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The deck being edited: typed values, problems, and undo. No Qt.
namespace adore::adrinput {

/// A problem, and the place to correct it.
struct Problem {
  Issue issue;
  std::string page;          ///< record id; empty when it concerns no record
  std::optional<Cell> cell;  ///< empty when it concerns a whole record
  bool refused = false;      ///< not an error of the deck, but a reason why a run cannot start
};

/// Of the deck as a whole.
enum class DeckState : unsigned char {
  Wrong,      ///< has errors
  Refused,    ///< `adore run` ends before its first step
  Unchecked,  ///< not checked yet
  Ready       ///< a run begins
};

enum class RecordState : unsigned char {
  Complete,
  Untouched,  ///< contains default values that the user has not confirmed
  Doubtful,   ///< has warnings
  Wrong       ///< has errors
};

class Document {
 public:
  /// Starts with the example ball deck.
  Document();

  /// Called after every change of anything below.
  std::function<void()> changed;
  /// Meaning of a typed text if fields show other units than the deck (add_display_unit()). Not
  /// called for edit().
  std::function<std::string(const Cell&, const std::string&)> meaning;

  /// A new data set from an example deck (deck/templates.hpp). @throws InputError
  void start_new(std::string_view template_name);
  /// A new data set from the text of a deck without errors; its comments are kept in the saved
  /// file.
  /// @throws InputError
  void start_from_text(const std::string& text);
  /// Reads as much as possible of a deck with errors: texts that are not values stay in their
  /// fields, and all remarks of the reader are among the problems.
  /// @throws InputError if the file is missing or is not text; the document is then unchanged.
  void open(const std::filesystem::path& name);
  /// Writes the deck if `adore check` accepts it and it reads back equal, based on the text of the
  /// file that it was opened from, with its comments (deck/deck_text_with_comments.hpp). If that
  /// text cannot be kept, the first save keeps the old file as NAME.bak. Run options are written to
  /// ADORE.json in the same folder if they differ from it.
  /// @throws InputError with all errors; then no file is changed.
  void save(const std::filesystem::path& name);
  /// Errors for which save() would reject the deck for any file.
  [[nodiscard]] std::vector<Issue> errors();
  /// Path of the previous file kept by the last save(); empty if none.
  [[nodiscard]] const std::filesystem::path& kept_copy() const { return backup_path_; }
  /// Saves the document, with errors, as a draft that only AdrInput reads: open() restores it. It
  /// counts as saved. @throws InputError
  void save_draft(const std::filesystem::path& path);
  /// The draft file of this document; empty: none.
  [[nodiscard]] const std::filesystem::path& draft() const { return draft_path_; }

  [[nodiscard]] const deck::Deck& deck() const { return state_.deck; }
  /// A whole name, from wherever it was given; empty: not named.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::string& original() const { return original_text_; }  ///< file as opened
  [[nodiscard]] bool modified() const;
  /// Did another program change the file that this deck would replace?
  [[nodiscard]] bool changed_on_disk(const std::filesystem::path& path) const;
  /// Keeps the current deck although another program changed the file: counts as not saved, and
  /// saving keeps the file of the other program as NAME.bak.
  void keep_edited_deck();

  /// State for restore() in a later session, without the undo history.
  [[nodiscard]] std::string snapshot(std::string_view page) const;
  /// Returns the page that was shown. @throws InputError if the bytes are not a snapshot; the
  /// document is then unchanged. Bytes without a complete name give a deck without name.
  std::string restore(std::string_view bytes);

  /// Run options as the page shows them, those that differ from their defaults.
  [[nodiscard]] std::map<std::string, std::string> options() const;
  /// Effects of this deck's motion that the run option effectsOff can disable; empty if unknown,
  /// because the deck cannot be run.
  [[nodiscard]] const std::vector<std::string>& effects() const { return effects_; }

  /// Scales of the dimensionless times of the deck, if known for the current deck (step control and
  /// name may differ).
  void set_scales(const deck::Deck& of, const std::optional<runs::RunScales>& scales);
  [[nodiscard]] std::optional<runs::RunScales> scales() const;
  /// A text of a field as a value: also "5 rev" and "0.02 s" for times of a run.
  [[nodiscard]] TypedValue parse(const Cell& cell, std::string_view text) const;

  /// The system of units that the numbers were given in before kUnit was changed, until one of the
  /// two answers below is given.
  [[nodiscard]] std::optional<deck::UnitSystem> previous_units() const {
    return state_.previous_units;
  }
  /// After such a change: converts all values to the new units, except those entered since; part of
  /// the last step.
  void convert_values();
  /// After such a change: the numbers stay as they are.
  void keep_numbers();

  /// Records that apply, in deck order, each once; then "12" (lines of user routines) and
  /// kOptionsPage (adrinput/options_page.hpp), which are always there.
  [[nodiscard]] std::vector<std::string> pages() const;
  [[nodiscard]] int instances(std::string_view record) const;
  /// Content of the field of a cell: the value, or the text that is not a value.
  [[nodiscard]] std::string text(const Cell& cell) const;
  /// Does the field contain a text that is not a value (yet)?
  [[nodiscard]] bool has_unparsed_text(const Cell& cell) const {
    return state_.drafts.count(cell) > 0;
  }
  /// Reason why a run of this deck does not use a value, as a clause; empty if it does, or if the
  /// deck cannot be run.
  [[nodiscard]] std::string unused_reason(const Cell& cell) const;

  /// Applies a typed text. Options and counts add and remove records and array elements; earlier
  /// values return with them. Changes of the same cell are one step for undo until end_undo_step().
  void edit(const Cell& cell, std::string_view typed);
  /// Several values, one step for undo.
  void edit_all(const std::vector<std::pair<Cell, std::string>>& typed);
  /// The same while the user is typing: the text is shown and kept, but the deck keeps its value
  /// until end_undo_step() applies the text, so that the "12.7" of "12.7 mm" is never used as a
  /// value.
  void type(const Cell& cell, std::string_view typed);
  /// Is there a text that is being typed?
  [[nodiscard]] const std::optional<Cell>& cell_being_typed() const { return typed_cell_; }
  /// Sets several variables as one step of undo (deck::Deck::set_all). @throws InputError; the
  /// document stays as it was.
  void change(const std::vector<std::pair<std::string, std::string>>& sets);
  /// Replaces the whole deck as one step of undo; file and run options stay. A save keeps the
  /// comments of `text`, a deck without errors, instead of those of the file.
  void replace(deck::Deck deck, std::string text);
  void set_user_lines(std::vector<std::string> lines);
  void end_undo_step();
  /// The user has seen the record: its defaults count as confirmed.
  void accept_defaults(std::string_view record);

  [[nodiscard]] bool can_undo() const { return !undo_.empty(); }
  [[nodiscard]] bool can_redo() const { return !redo_.empty(); }
  /// Both return the page of the change.
  std::string undo();
  std::string redo();

  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
  [[nodiscard]] RecordState state_of(std::string_view record) const;
  [[nodiscard]] bool has_errors() const;
  [[nodiscard]] int warnings() const;
  [[nodiscard]] DeckState deck_state() const;
  /// Builds the model of a deck without errors and adds the problems found only there; takes some
  /// milliseconds.
  void check_model();
  /// A deck with its options and its path, for the check whether a run can start.
  struct Candidate {
    deck::Deck deck;
    std::map<std::string, std::string> options;
    std::filesystem::path path;
    [[nodiscard]] bool operator==(const Candidate& other) const {
      return deck == other.deck && options == other.options && path == other.path;
    }
  };
  [[nodiscard]] Candidate candidate() const { return {state_.deck, options(), path_}; }
  /// Is it still unknown whether a run of this deck can start (runs/rehearsal.hpp)?
  [[nodiscard]] bool needs_start_check() const;
  /// Result of a check of a deck, which may have changed since.
  /// @param remarks as `adore check` lists them
  void set_start_check_result(const Candidate& of, std::vector<Issue> refusals,
                              std::vector<Finding> remarks = {});
  /// Files of the folder have changed, which affects runs that continue from them.
  void invalidate_start_check();

 private:
  struct State {
    deck::Deck deck;
    std::map<Cell, std::string> drafts;  ///< typed texts that are not values
    std::map<std::pair<std::string, int>, deck::RecordData> shelf;  ///< every record ever seen
    std::map<std::string, std::string> options;                     ///< run options that are given
    std::optional<deck::UnitSystem> previous_units;  ///< before kUnit was changed; unanswered
    /// Bodies monitored with other counts of elements and segments, for the time when these counts
    /// return; and those before the last change of a count.
    std::map<std::pair<long long, long long>, std::vector<long long>> monitored_with;
    std::vector<long long> followed;
    std::set<Cell> typed_since;  ///< values in the new units already
    std::string comments;        ///< text of replace(); empty: those of the file
  };
  struct UndoStep {
    State state;
    std::string page;
  };
  void start(State state);
  void begin_undo_step(const Cell& cell);
  void edit_option(const Cell& cell, std::string_view typed);
  void find_option_problems();
  void save_options(const std::filesystem::path& deck_file);
  void track_unit_change(deck::UnitSystem before);
  void mark_changed_as_typed(const deck::Deck& before);
  void mark_inherited_as_typed();
  void clear_unit_change();
  enum class TypedValues { Left, Alone };  ///< values typed since kUnit changed
  void convert_all(deck::UnitSystem from, deck::UnitSystem to, TypedValues given);
  void convert(deck::RecordData& record, const deck::Deck& deck, deck::UnitSystem from,
               deck::UnitSystem to, TypedValues given) const;
  void complete_records();
  void restore_from_shelf();
  void renumber_monitored_bodies(const deck::Deck& before);
  void remember(const deck::RecordData& record);
  void remove_duplicate_file_issues();
  void keep_unread_values(const std::vector<Issue>& issues);
  void find_problems();
  void add_problem(Issue issue, bool refused = false);
  void add_refusals();
  void add_remarks();
  void notify();
  std::string move_in_history(std::vector<UndoStep>& from, std::vector<UndoStep>& to);

  State state_;
  deck::Deck saved_deck_;
  std::map<Cell, std::string> saved_unparsed_texts_;
  std::map<std::string, std::string> saved_options_;
  runs::OptionFile option_file_;  ///< ADORE.json as read
  std::filesystem::path path_;
  std::string original_text_;
  std::string saved_comments_;            ///< State::comments of the file
  bool original_matches_deck_ = false;    ///< the deck alone makes the same text
  bool file_changed_externally_ = false;  ///< the file was written by another program
  bool file_has_errors_ = false;          ///< the file has errors: reading it was a guess
  std::vector<Issue> file_issues_, model_issues_;
  std::vector<Issue> change_issues_;    ///< records removed by the last change
  std::vector<Issue> refusals_;         ///< of the model issues those that no run accepts
  std::vector<Issue> start_refusals_;   ///< error at the end of a run of `checked_candidate_`
  std::vector<Finding> start_remarks_;  ///< findings of statics and plan
  std::optional<Candidate> checked_candidate_;
  std::map<Cell, std::string> unused_reasons_;  ///< values without a part, and why
  std::vector<std::string> effects_;
  std::vector<Problem> problems_;
  std::vector<UndoStep> undo_, redo_;
  std::optional<Cell> undo_step_cell_, typed_cell_;
  bool step_spans_cells_ = false;  ///< changes of other cells belong to the step that is open
  std::filesystem::path draft_path_, backup_path_;
  std::optional<runs::RunScales> scales_;
  std::vector<deck::RecordData> scale_records_;  ///< records that the scales are of
};

}  // namespace adore::adrinput
