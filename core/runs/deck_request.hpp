#pragma once

#include "base/finding.hpp"
#include "deck/deck.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// Request to run a deck, and its reading.
namespace adore::user {
struct PlugIn;
}

namespace adore::runs {

/// Requests of the user in addition to the deck.
struct DeckRequest {
  std::filesystem::path deck = ".";  ///< the deck, or a folder that holds DATA.txt
  std::optional<std::string> text;   ///< the deck itself, in place of the file; its outputs go to
                                     ///< the current folder
  /// With `text`: a program provides the deck. `deck` is its name in messages, whether there is
  /// such a file or not, and run options are only those of the request: no ADORE.json is read.
  bool in_memory = false;
  std::vector<std::pair<std::string, std::string>>
      sets;  ///< --set variable=value, in the deck's units
  /// Variables that the program sets for additional runs (studies,
  /// verification), after `sets` and overriding them.
  std::vector<std::pair<std::string, std::string>> changes;
  std::vector<std::pair<std::string, std::string>>
      options;  ///< --opt name=value, over those of ADORE.json
  /// --user: routines of the user, a shared object or a file of formulas (user/plug_in.hpp). The
  /// one way to load code: neither deck nor ADORE.json can.
  std::filesystem::path user;
  std::shared_ptr<const user::PlugIn> routines;  ///< functions of the calling program, instead
};

struct LoadedDeck {
  std::filesystem::path path;     ///< the deck file
  deck::Deck deck;                ///< with the sets applied
  std::vector<Finding> warnings;  ///< of the reader, and what the model, statics and run add
  std::map<std::string, std::string> option_values;  ///< ADORE.json and --opt, as given
  std::filesystem::path user;                        ///< as in the request
  std::shared_ptr<const user::PlugIn> routines;
  std::stop_token stop;  ///< ends a long preparation (Interrupted)
  /// Called after each speed of the stiffness table; may be empty.
  std::function<void(long done, long total)> table_progress;
};

/// The deck file that a path means: itself, or DATA.txt in it. @throws InputError when there is
/// none.
[[nodiscard]] std::filesystem::path deck_path(const std::filesystem::path& path);

/// Name in messages of a deck that was given as text.
inline constexpr const char* kStandardInput = "standard input";
/// The deck file of the request, or kStandardInput. @throws InputError when there is none.
[[nodiscard]] std::filesystem::path deck_path(const DeckRequest& request);
/// The request's deck before any of its sets. @throws InputError when it cannot be read.
[[nodiscard]] deck::ReadResult read_deck(const DeckRequest& request);

/// Reads, applies the sets, checks again. @throws InputError with every error of the deck.
[[nodiscard]] LoadedDeck load_deck(const DeckRequest& request);

/// The run options of the ADORE.json in the folder of a deck, as given; empty without this file.
/// @throws InputError when the file is not an object of named values.
[[nodiscard]] std::map<std::string, std::string> options_of_deck(
    const std::filesystem::path& deck_file);

}  // namespace adore::runs
