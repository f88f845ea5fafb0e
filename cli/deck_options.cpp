#include "cli/deck_options.hpp"

#include "base/errors.hpp"
#include "cli/streams.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace adore::cli {
namespace {

std::pair<std::string, std::string> split(const std::string& text, const char* option) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0)
    throw InputError(fmt::format("{} {}: write it as {} name=value", option, text, option));
  return {text.substr(0, at), text.substr(at + 1)};
}

}  // namespace

void DeckOptions::add_to(CLI::App& command) {
  command.add_option("deck", deck, "deck file, or a folder that holds DATA.txt")
      ->capture_default_str();
  command
      .add_option("--set", sets, "change a deck variable: name=value, name[i]=value (deck units)")
      ->take_all();
  command
      .add_option("--opt", options, "set a run option: name=value (see `adore run --list-options`)")
      ->take_all();
}

void DeckOptions::fill(facade::DeckRequest& request) const {
  request.deck = deck;
  for (const std::string& text : sets) request.sets.push_back(split(text, "--set"));
  for (const std::string& text : options) request.options.push_back(split(text, "--opt"));
}

void print_warnings(const std::vector<Issue>& issues) {
  for (const Issue& issue : issues)
    if (issue.severity != Severity::Error) tell(issue.text() + "\n");
}

}  // namespace adore::cli
