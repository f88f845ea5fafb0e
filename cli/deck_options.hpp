#pragma once

#include "runs/prepare.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

namespace adore::cli {

/// The options that every command over a deck shares: DECK, --set, --opt.
struct DeckOptions {
  std::string deck = ".";
  std::string user;  ///< --user
  std::vector<std::string> sets, options;

  void add_to(CLI::App& command);
  /// Fills the request; "-" reads the deck from standard input.
  /// @throws InputError for a --set or --opt without "=".
  void fill(runs::DeckRequest& request) const;
  /// @throws InputError for a --set without "=".
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> parse_set_options() const;
};

/// Names of the deck variables with "=", for completion.
[[nodiscard]] std::vector<std::string> variable_completions();
/// --set alone.
void add_sets(CLI::App& command, std::vector<std::string>& sets);
/// The positional DECK alone.
void add_deck_option(CLI::App& command, std::string& deck);
/// Meaning of DECK: a file, a folder, or "-" for standard input.
[[nodiscard]] runs::DeckRequest deck_request(const std::string& deck);

/// Warnings to stderr, one a line.
void print_warnings(const std::vector<Finding>& findings);

}  // namespace adore::cli
