#include "adrinput/document.hpp"
#include "adrinput/typed.hpp"
#include "base/atomic_file.hpp"
#include "deck/lookup.hpp"
#include "facade/check.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <system_error>

/// Opening and saving.
namespace adore::adrinput {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return a == b || (fs::exists(a, error) && fs::exists(b, error) && fs::equivalent(a, b, error));
}

void take_errors(std::vector<Issue>& reasons, const std::vector<Issue>& issues) {
  for (const Issue& issue : issues)
    if (issue.severity == Severity::Error) reasons.push_back(issue);
}

}  // namespace

void Document::open(const fs::path& path) {
  deck::ReadResult read = deck::read_deck(path);
  State state;
  state.deck = std::move(read.deck);
  path_ = path;
  original_ = bytes_of(path);
  original_kept_ = deck::write_deck(state.deck) == original_;
  file_issues_ = read.issues;
  std::swap(state_, state);
  state_.shelf.clear();
  keep_unread_values(read.issues);
  state = std::move(state_);
  start(std::move(state));
  notify();
}

/// Texts in the file that are no values stay in their fields; so do integers that do not exist,
/// because a count of a million must not make a million records.
void Document::keep_unread_values(const std::vector<Issue>& issues) {
  for (const Issue& issue : issues) {
    const std::optional<Cell> cell = cell_of(issue);
    if (issue.severity != Severity::Error || !cell || issue.value.empty()) continue;
    const deck::Value* value = value_at(state_.deck, *cell);
    if (value != nullptr && std::holds_alternative<std::monostate>(*value) &&
        parse_typed(*variable_of(*cell), issue.value).problem)
      state_.drafts[*cell] = issue.value;
  }
  for (deck::RecordData& record : state_.deck.records) {
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 0; v < std::min(record.values.size(), spec.variables.size()); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        deck::Value& value = record.values[v][k];
        if (!std::holds_alternative<long long>(value) ||
            deck::is_reliable_integer(spec.variables[v], value))
          continue;
        state_.drafts[{record.id, record.instance, v, k}] = shown_text(value);
        value = std::monostate();
      }
  }
}

bool Document::changed_on_disk(const fs::path& path) const {
  std::error_code error;
  return !path_.empty() && same_file(path, path_) && fs::exists(path, error) &&
         bytes_of(path) != original_;
}

void Document::save(const fs::path& path) {
  end_step();
  check_model();
  std::vector<Issue> reasons;
  for (const Problem& problem : problems_)
    if (problem.issue.severity == Severity::Error) reasons.push_back(problem.issue);
  const std::string text = deck::write_deck(state_.deck);
  if (reasons.empty()) {
    const deck::ReadResult back = deck::read_deck_text(text, path.string());
    take_errors(reasons, back.issues);
    if (reasons.empty() && !(back.deck == state_.deck)) {
      Issue issue;
      issue.record = back.deck.records == state_.deck.records ? "12" : "";
      issue.message = issue.record.empty()
                          ? "a text in the deck would not read back as it stands here"
                          : "lines of user routines would not read back as they stand here; the "
                            "first of them looks like a record, or one is blank";
      issue.remedy = "change that text";
      reasons.push_back(std::move(issue));
    }
  }
  if (!reasons.empty()) throw InputError(std::move(reasons));
  if (!original_kept_ && same_file(path, path_)) {
    fs::path backup = path;
    backup += ".bak";
    write_file_atomically(backup, original_);
    original_kept_ = true;
  }
  write_file_atomically(path, text);
  path_ = path;
  original_ = text;
  original_kept_ = true;
  file_issues_.clear();
  saved_deck_ = state_.deck;
  saved_drafts_ = state_.drafts;
  find_problems();
  notify();
}

}  // namespace adore::adrinput
