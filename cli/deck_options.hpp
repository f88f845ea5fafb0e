#pragma once

#include "facade/prepare.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace adore::cli {

/// The options that every command over a deck shares: DECK, --set, --opt.
struct DeckOptions {
  std::string deck = ".";
  std::vector<std::string> sets, options;

  void add_to(CLI::App& command);
  /// Fills the request. @throws InputError for a --set or --opt without "=".
  void fill(facade::DeckRequest& request) const;
};

/// Warnings to stderr, one a line.
void print_warnings(const std::vector<Issue>& issues);

}  // namespace adore::cli
