#pragma once

#include "adrinput/cell.hpp"
#include "facade/option_file.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The deck being prepared: what the user typed, what is wrong with it, and the way back. No Qt.
namespace adore::adrinput {

/// What is wrong, and where to go to mend it.
struct Problem {
  Issue issue;
  std::string page;          ///< record id; empty when it concerns no record
  std::optional<Cell> cell;  ///< empty when it concerns a whole record
};

enum class RecordState : unsigned char {
  Complete,
  Untouched,  ///< holds values that stand in for what nobody gave
  Doubtful,   ///< has warnings
  Wrong       ///< has errors
};

class Document {
 public:
  /// Starts with the example ball deck.
  Document();

  /// Called after every change of anything below.
  std::function<void()> changed;

  /// A new data set from an example deck (deck/templates.hpp). @throws InputError
  void start_new(std::string_view template_name);
  /// A broken deck is taken as far as it can be understood: texts that are no values stay in their
  /// fields, and everything that the reader remarked is among the problems.
  /// @throws InputError when there is no such file or it is no text; the document stays as it was.
  void open(const std::filesystem::path& path);
  /// Writes the deck when `adore check` accepts it and it reads back equal. The first save over a
  /// file with comments or lines that the deck does not keep leaves the old file beside it as
  /// NAME.bak. Run options go into the ADORE.json beside it when they differ from what it says.
  /// @throws InputError with every reason against it; no file is touched then.
  void save(const std::filesystem::path& path);

  [[nodiscard]] const deck::Deck& deck() const { return state_.deck; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }  ///< empty: not named
  [[nodiscard]] const std::string& original() const { return original_; }    ///< file as opened
  [[nodiscard]] bool modified() const;
  /// Did another program change the file that this deck would replace?
  [[nodiscard]] bool changed_on_disk(const std::filesystem::path& path) const;
  /// Goes on with what is here although another program changed the file: counts as not saved, and
  /// saving leaves what the other program wrote as NAME.bak.
  void keep_mine();

  /// Everything that a later session needs to go on where this one stood, the undo history apart:
  /// bytes for restore().
  [[nodiscard]] std::string snapshot(std::string_view page) const;
  /// Returns the page that was shown. @throws InputError when the bytes are no snapshot; the
  /// document stays as it was.
  std::string restore(std::string_view bytes);

  /// Run options as the page shows them, those that differ from their defaults.
  [[nodiscard]] std::map<std::string, std::string> options() const;

  /// The system of units that the numbers were given in, directly after kUnit was changed.
  [[nodiscard]] std::optional<deck::UnitSystem> numbers_in() const { return numbers_in_; }
  /// After such a change: turns every number into the new units, as part of the same step.
  void convert_values();
  /// After such a change: the numbers stay as they are.
  void keep_numbers();

  /// Records that apply, in deck order, each once; then "12" (lines of user routines) and
  /// kOptionsPage (adrinput/options_page.hpp), which are always there.
  [[nodiscard]] std::vector<std::string> pages() const;
  [[nodiscard]] int instances(std::string_view record) const;
  /// What the field of a cell shows: the value, or the text that is none.
  [[nodiscard]] std::string text(const Cell& cell) const;

  /// Takes what was typed. Options and counts make records and array elements come and go; values
  /// typed before come back with them. Changes of the same cell are one step for undo until
  /// end_step().
  void edit(const Cell& cell, std::string_view typed);
  void set_user_lines(std::vector<std::string> lines);
  void end_step() { step_cell_.reset(); }
  /// The user looked at the record and goes on: its defaults count as given.
  void accept_defaults(std::string_view record);

  [[nodiscard]] bool can_undo() const { return !undo_.empty(); }
  [[nodiscard]] bool can_redo() const { return !redo_.empty(); }
  /// Both return the page on which the change took place.
  std::string undo();
  std::string redo();

  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
  [[nodiscard]] RecordState state_of(std::string_view record) const;
  [[nodiscard]] bool has_errors() const;
  /// Builds the model of a deck without errors and adds what shows only there; some milliseconds.
  void check_model();

 private:
  struct State {
    deck::Deck deck;
    std::map<Cell, std::string> drafts;  ///< typed texts that are no values
    std::map<std::pair<std::string, int>, deck::RecordData> shelf;  ///< every record ever seen
    std::map<std::string, std::string> options;                     ///< run options that are given
  };
  struct Step {
    State state;
    std::string page;
  };
  void start(State state);
  void begin_step(const Cell& cell);
  void edit_option(const Cell& cell, std::string_view typed);
  void find_option_problems();
  void save_options(const std::filesystem::path& deck_file);
  void note_units(deck::UnitSystem before);
  void settle();
  void remember(const deck::RecordData& record);
  void keep_unread_values(const std::vector<Issue>& issues);
  void find_problems();
  void add_problem(Issue issue);
  void notify();
  std::string travel(std::vector<Step>& from, std::vector<Step>& to);

  State state_;
  deck::Deck saved_deck_;
  std::map<Cell, std::string> saved_drafts_;
  std::map<std::string, std::string> saved_options_;
  facade::OptionFile option_file_;  ///< ADORE.json as read
  std::optional<deck::UnitSystem> numbers_in_;
  std::filesystem::path path_;
  std::string original_;
  bool original_kept_ = false;  ///< beside the file, or nothing of it would be lost
  std::vector<Issue> file_issues_, model_issues_;
  std::vector<Problem> problems_;
  std::vector<Step> undo_, redo_;
  std::optional<Cell> step_cell_;
};

}  // namespace adore::adrinput
