#include "adrinput/options_page.hpp"

#include "adrinput/document.hpp"
#include "adrinput/typed.hpp"
#include "adrinput/window_words.hpp"
#include "base/kept_copy.hpp"
#include "base/write_folder.hpp"
#include "deck/quantity.hpp"
#include "deck/units.hpp"
#include "runs/option_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::adrinput {
namespace {

namespace fs = std::filesystem;

/// "[s]" in the meaning of an option is the unit of its number.
bool is_time(std::string_view meaning) { return meaning.find("[s]") != std::string_view::npos; }

/// "500 ms" as seconds, the unit of the file; other texts unchanged.
std::string in_seconds(const deck::VariableSpec& option, const std::string& text) {
  double value = 0.0, seconds = 0.0;
  if (!is_time(option.help) || !deck::parse_real(text, value)) return text;
  if (deck::parse_quantity(text, deck::unit::kTime, deck::UnitSystem::SI, seconds)) return text;
  return fmt::format("{}", seconds);
}

using Options = std::map<std::string, std::string>;

/// Without values equal to the default.
Options that_differ(const Options& given) {
  Options out;
  for (const runs::RunOptionInfo& option : runs::run_options()) {
    const auto found = given.find(option.name);
    if (found != given.end() && !runs::same_option(found->second, option.default_value))
      out.insert(*found);
  }
  return out;
}

std::string capital_sentence(std::string clause) {
  clause = replace_cli_terms(std::move(clause));
  if (!clause.empty() && clause[0] >= 'a' && clause[0] <= 'z')
    clause[0] = static_cast<char>(clause[0] - 'a' + 'A');
  return clause + ".";
}

bool same(const Options& a, const Options& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && runs::same_option(x.second, y.second);
  });
}

}  // namespace

const deck::RecordSpec& options_record() {
  static const deck::RecordSpec record = [] {
    deck::RecordSpec out;
    out.id = kOptionsPage;
    out.title = "Run options (ADORE.json)";
    out.condition = "true";
    static std::vector<std::string> sentences;  // the specs refer to them
    std::size_t texts = 0;
    for (const runs::RunOptionInfo& option : runs::run_options())
      texts += 1 + option.choices.size();
    sentences.reserve(texts);
    for (const runs::RunOptionInfo& option : runs::run_options()) {
      sentences.push_back(capital_sentence(option.meaning));
      deck::VariableSpec variable;
      variable.name = option.name;
      variable.type = deck::VarType::String;
      variable.default_value = option.default_value;
      variable.help = sentences.back();
      for (const std::string& choice : option.choices) {
        std::string meaning = choice == option.default_value ? "the default" : "";
        if (option.choices.size() == 2 && choice.size() == 1)
          meaning =
              std::string(choice == "1" ? "yes" : "no") + (meaning.empty() ? "" : ", " + meaning);
        sentences.push_back(std::move(meaning));
        variable.options.push_back({choice, sentences.back()});
      }
      if (option.choices.size() == 1) variable.options.push_back({"n", "a number"});
      out.variables.push_back(variable);
    }
    return out;
  }();
  return record;
}

const deck::RecordSpec* page_record(std::string_view id) {
  return id == kOptionsPage ? &options_record() : deck::find_record(id);
}

std::string option_text(const Options& given, const Cell& cell) {
  const deck::VariableSpec& option = options_record().variables.at(cell.variable);
  const auto found = given.find(std::string(option.name));
  return found == given.end() ? std::string(option.default_value) : found->second;
}

Options Document::options() const { return that_differ(state_.options); }

/// An empty field means the default.
void Document::edit_option(const Cell& cell, std::string_view typed) {
  const std::string name(options_record().variables.at(cell.variable).name);
  const std::string value =
      in_seconds(options_record().variables.at(cell.variable), normalized_text(typed));
  const auto given = state_.options.find(name);
  if (given == state_.options.end() ? value.empty() || value == text(cell) : value == given->second)
    return;
  begin_undo_step(cell);
  if (value.empty() || (saved_options_.count(name) == 0 &&
                        value == options_record().variables[cell.variable].default_value))
    state_.options.erase(name);
  else
    state_.options[name] = value;
  find_problems();
  notify();
}

void Document::find_option_problems() {
  for (const auto& [name, value] : state_.options) {
    const std::string problem = runs::option_problem(name, value);
    if (problem.empty()) continue;
    Issue issue;
    issue.record = kOptionsPage;
    issue.variable = name;
    issue.value = value;
    issue.message = problem;
    add_problem(std::move(issue));
  }
  Issue issue;
  issue.severity = Severity::Warning;
  issue.record = kOptionsPage;
  if (!option_file_.problem().empty()) {
    issue.message = "the option file in the folder of the deck " + option_file_.problem();
    issue.remedy =
        "correct the file in an editor, or change an option here and save the deck (the old file "
        "is kept as ADORE.json.bak)";
    add_problem(issue);
  }
  for (const std::string& name : option_file_.unknown_names()) {
    issue.message = "the option file in the folder of the deck: " + runs::unknown_name_text(name);
    issue.remedy = "correct the file in an editor; until then, runs of this deck are rejected";
    add_problem(issue);
  }
}

/// Writes the file only if its content changes. Changes of another program since reading, and
/// unknown content, are kept in ADORE.json.bak.
void Document::save_options(const fs::path& deck_file) {
  const runs::OptionFile there = runs::OptionFile::of_deck(deck_file);
  const Options wanted = options();
  std::string text = there.text();
  if (!same(wanted, that_differ(there.values())))
    text = (there.exists() ? there : option_file_).with(wanted);
  if (there.problem().empty() || text != there.text())
    text = (text.empty() ? runs::OptionFile() : runs::OptionFile::from_text(text))
               .with_variables(state_.deck);
  if (text != there.text()) {
    const fs::path path = runs::OptionFile::path_for_deck(deck_file);
    const bool known = there.text() == option_file_.text();
    if (there.exists() && (!known || !there.problem().empty()))
      write_backup_copy(path, there.text());
    write_file_atomically(path, text);
  }
  option_file_ = runs::OptionFile::of_deck(deck_file);
}

}  // namespace adore::adrinput
