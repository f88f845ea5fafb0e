#pragma once

#include "facade/prepare.hpp"

#include <CLI/CLI.hpp>

#include <string>
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
  void fill(facade::DeckRequest& request) const;
};

/// The positional DECK alone.
void add_deck(CLI::App& command, std::string& deck);
/// What DECK means: a file or folder, or for "-" what stands on standard input.
[[nodiscard]] facade::DeckRequest deck_request(const std::string& deck);

/// Warnings to stderr, one a line.
void print_warnings(const std::vector<Finding>& findings);

}  // namespace adore::cli
