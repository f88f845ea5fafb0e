#pragma once

#include "deck/deck.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The ADORE.json in the folder of a deck: one object of named values, which are run options and
/// variables of the records X (deck/schema_extension.cpp), for example
///   {"version": 1, "ellipseMajor": 20, "ratingC": "55.3 kN"}
/// A number is in the unit of the deck, a text may have its own unit. A file with variables needs
/// "version": 1; a file with run options only needs none.
namespace adore::runs {

struct RunOptionInfo {
  std::string name, default_value, meaning;  ///< the meaning lists the valid values
  std::vector<std::string> choices;  ///< words that it takes; empty when it takes numbers only
};

/// Every run option, in a fixed order; the list of `--opt`.
[[nodiscard]] const std::vector<RunOptionInfo>& run_options();

/// Why a run option does not take a value: "is not valid: ..."; empty when it does.
[[nodiscard]] std::string option_problem(std::string_view name, std::string_view value);

/// Do two texts mean the same value of an option? "16" and "16.0" do.
[[nodiscard]] bool same_option(std::string_view a, std::string_view b);

inline constexpr int kExtensionVersion = 1;

/// The file as it was read. Names that are neither run options nor variables stay in it.
class OptionFile {
 public:
  OptionFile() = default;  ///< no file
  [[nodiscard]] static std::filesystem::path path_for_deck(const std::filesystem::path& deck_file);
  /// Never throws: what is wrong with the file is problem().
  [[nodiscard]] static OptionFile of_deck(const std::filesystem::path& deck_file);
  [[nodiscard]] static OptionFile from_text(std::string text);

  [[nodiscard]] bool exists() const { return exists_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  /// A clause that continues "ADORE.json ..."; empty when the file can be understood.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// Run options that the file gives, as text.
  [[nodiscard]] const std::map<std::string, std::string>& values() const { return values_; }
  /// Variables of the records X with the texts that Deck::set() takes, in the order of the file.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& variables() const {
    return variables_;
  }
  /// Names in it that are neither run options nor variables, or whose value is not a number,
  /// string or true/false (or, for a variable, a list of them).
  [[nodiscard]] const std::vector<std::string>& unknown_names() const { return unknown_names_; }

  /// The file's text with these run options instead of its options. Values equal to the default are
  /// left out, unknown names stay, an unchanged option keeps its spelling. Equal
  /// to text() when nothing changed.
  [[nodiscard]] std::string with(const std::map<std::string, std::string>& values) const;
  /// The file's text with the values of the deck's records X instead of its variables. An unchanged
  /// value keeps its spelling.
  [[nodiscard]] std::string with_variables(const deck::Deck& deck) const;

 private:
  bool exists_ = false;
  std::string text_, problem_;
  std::map<std::string, std::string> values_;
  std::vector<std::pair<std::string, std::string>> variables_;
  std::vector<std::string> unknown_names_;
};

/// "there is no run option or variable of records X named ...; did you mean ...?"
[[nodiscard]] std::string unknown_name_text(std::string_view name);

/// The file next to a deck; without it an empty one. @throws InputError for a file that a run
/// cannot use: not an object, unknown names, another version.
[[nodiscard]] OptionFile usable_options_of_deck(const std::filesystem::path& deck_file);

/// Gives the deck the variables of the file. The issues name the file.
[[nodiscard]] std::vector<Issue> set_extension(deck::Deck& deck, const OptionFile& file,
                                               const std::filesystem::path& deck_file);

/// The deck without its records X: the text of DATA.txt.
[[nodiscard]] deck::Deck without_extension(deck::Deck deck);

}  // namespace adore::runs
