#include "cli/deck_options.hpp"

#include "base/errors.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "deck/schema.hpp"
#include "setup/run_control.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::cli {
namespace {

constexpr std::size_t kLargestDeck = std::size_t{16} << 20;

std::pair<std::string, std::string> split(const std::string& text, const char* option) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0)
    throw InputError(fmt::format("{} {}: write it as {} name=value", option, text, option));
  return {text.substr(0, at), text.substr(at + 1)};
}

std::vector<std::string> option_words() {
  std::vector<std::string> out;
  for (const setup::OptionInfo& info : setup::run_option_list()) out.push_back(info.name + "=");
  return out;
}

}  // namespace

std::vector<std::string> variable_completions() {
  std::vector<std::string> out;
  for (const deck::RecordSpec& record : deck::schema())
    for (const deck::VariableSpec& variable : record.variables)
      if (variable.name != "recID") out.push_back(fmt::format("{}=", variable.name));
  // The same name may occur in several records.
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void add_deck_option(CLI::App& command, std::string& deck) {
  command.add_option("deck", deck, "deck file, folder with DATA.txt, or - for standard input")
      ->type_name("DECK")
      ->default_str("DATA.txt in the current folder");
}

void add_sets(CLI::App& command, std::vector<std::string>& sets) {
  // One value each: the next argument is the deck.
  command_line::suggest_values(
      command
          .add_option("--set", sets,
                      "set a deck variable in the units of the deck; may be repeated")
          ->type_name("NAME=VALUE")
          ->allow_extra_args(false),
      variable_completions());
}

void DeckOptions::add_to(CLI::App& command) {
  add_deck_option(command, deck);
  add_sets(command, sets);
  command_line::suggest_values(
      command
          .add_option("--opt", options,
                      "set a run option (`adore run --list-options` lists them); may be repeated")
          ->type_name("NAME=VALUE")
          ->allow_extra_args(false),
      option_words());
  command
      .add_option("--user", user,
                  "user routines: a shared library (`adore user new` writes an example) or a .json "
                  "file of formulas and tables. The code in the file is executed")
      ->type_name("PLUG-IN")
      ->allow_extra_args(false);
}

runs::DeckRequest deck_request(const std::string& deck) {
  runs::DeckRequest request;
  if (deck == kStream)
    request.text = read_standard_input(kLargestDeck);
  else
    request.deck = deck;
  std::error_code error;
  if (deck.find('=') != std::string::npos && !std::filesystem::exists(deck, error))
    throw InputError(fmt::format(
        "\"{}\" was read as the name of the deck; write --set (or --opt) before each name=value",
        deck));
  return request;
}

std::vector<std::pair<std::string, std::string>> DeckOptions::parse_set_options() const {
  std::vector<std::pair<std::string, std::string>> out;
  for (const std::string& text : sets) out.push_back(split(text, "--set"));
  return out;
}

void DeckOptions::fill(runs::DeckRequest& request) const {
  const runs::DeckRequest source = deck_request(deck);
  request.deck = source.deck;
  request.text = source.text;
  request.user = user;
  for (auto& set : parse_set_options()) request.sets.push_back(std::move(set));
  for (const std::string& text : options) request.options.push_back(split(text, "--opt"));
}

void print_warnings(const std::vector<Finding>& findings) {
  for (const Finding& finding : shown_findings(findings)) tell(finding.text() + "\n");
}

}  // namespace adore::cli
