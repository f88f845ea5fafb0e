#include "adrinput/document.hpp"
#include "adrinput/file_names.hpp"
#include "adrinput/typed.hpp"
#include "base/input_file.hpp"
#include "base/kept_copy.hpp"
#include "base/write_folder.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/lookup.hpp"
#include "runs/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <system_error>

/// Opening and saving.
namespace adore::adrinput {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  InputFile file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return a == b || (fs::exists(a, error) && fs::exists(b, error) && fs::equivalent(a, b, error));
}

/// Sequences of one to four bytes as RFC 3629 has them, without the overlong ones.
bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t at) {
      return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
    };
    const unsigned first = byte(i);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xc2 && first < 0xe0 ? 2
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xf0 && first < 0xf5 ? 4
                                                               : 0;
    if (length == 0) return false;
    for (std::size_t k = 1; k < length; ++k)
      if ((byte(i + k) & 0xc0U) != 0x80U) return false;
    const unsigned second = byte(i + 1);
    if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
        (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
      return false;
    i += length;
  }
  return true;
}

/// Fields and files contain UTF-8: characters of an old code page would be lost.
std::string utf8_of_latin1(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xc0U | (byte >> 6U));
      text += static_cast<char>(0x80U | (byte & 0x3fU));
    }
  }
  return text;
}

deck::ReadResult read_as_latin1(std::string_view bytes, const fs::path& path) {
  const std::string text = utf8_of_latin1(bytes);
  const auto foreign = std::find_if(bytes.begin(), bytes.end(),
                                    [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  const int first_line = 1 + static_cast<int>(std::count(bytes.begin(), foreign, '\n'));
  deck::ReadResult read = deck::read_deck_text(text, path.string());
  Issue issue;
  issue.severity = Severity::Note;
  issue.file = path.string();
  issue.line = first_line;
  issue.message = "contains characters that are not UTF-8; they were read as Latin-1 (ISO 8859-1)";
  issue.remedy = "saving converts them to UTF-8";
  read.issues.push_back(std::move(issue));
  return read;
}

/// Drafts begin with this line, followed by the bytes of Document::snapshot().
constexpr std::string_view kDraftHead =
    "AdrInput draft: a deck that is not ready to be run. Open it with AdrInput.\n";

bool holds_draft(const fs::path& path) {
  InputFile file(path);
  std::string head(kDraftHead.size(), '\0');
  return file.read(head.data(), static_cast<std::streamsize>(head.size())) && head == kDraftHead;
}

/// Of a remark that was written when the deck was in other units.
Issue doubtful_units(const std::string& record, deck::UnitSystem now) {
  const bool si = now == deck::UnitSystem::SI;
  Issue issue;
  issue.severity = Severity::Note;
  issue.record = record;
  issue.message =
      fmt::format("the comment after the values mentions {} units, but the deck is now in {} units",
                  si ? "English" : "SI", si ? "SI" : "English");
  issue.remedy = "correct the comment in a text editor";
  return issue;
}

void take_errors(std::vector<Issue>& reasons, const std::vector<Issue>& issues) {
  for (const Issue& issue : issues)
    if (issue.severity == Severity::Error) reasons.push_back(issue);
}

}  // namespace

void Document::open(const fs::path& name) {
  const fs::path path = normalized_path(name);
  reject_special_file(path);
  if (holds_draft(path)) {
    const std::string bytes = bytes_of(path);
    (void)restore(std::string_view(bytes).substr(kDraftHead.size()));
    draft_path_ = path;
    saved_deck_ = state_.deck;
    saved_unparsed_texts_ = state_.drafts;
    saved_options_ = state_.options;
    return notify();
  }
  deck::ReadResult read = deck::read_deck(path);
  std::string bytes = bytes_of(path);
  if (!is_utf8(bytes)) read = read_as_latin1(bytes, path);
  State state;
  option_file_ = runs::OptionFile::of_deck(path);
  for (Issue& issue : runs::set_extension(read.deck, option_file_, path))
    read.issues.push_back(std::move(issue));
  state.deck = std::move(read.deck);
  state.options = option_file_.values();
  path_ = path;
  original_text_ = std::move(bytes);
  original_matches_deck_ = deck::write_deck(runs::without_extension(state.deck)) == original_text_;
  file_issues_ = read.issues;
  file_has_errors_ = !read.ok();
  std::swap(state_, state);
  state_.shelf.clear();
  keep_unread_values(read.issues);
  state = std::move(state_);
  start(std::move(state));
  remove_duplicate_file_issues();
  find_problems();
  notify();
}

/// A remark of the deck replaces the same remark of its file.
void Document::remove_duplicate_file_issues() {
  const std::vector<Issue> live = deck::check_deck(state_.deck);
  std::erase_if(file_issues_, [&](const Issue& issue) {
    return std::any_of(live.begin(), live.end(), [&](const Issue& other) {
      return other.record == issue.record && other.variable == issue.variable &&
             other.message == issue.message;
    });
  });
}

/// Texts of the file that are not values stay in their fields; so do invalid integers, because a
/// count of a million must not create a million records.
void Document::keep_unread_values(const std::vector<Issue>& issues) {
  for (const Issue& issue : issues) {
    const std::optional<Cell> cell = cell_of(issue);
    if (issue.severity != Severity::Error || !cell || issue.value.empty()) continue;
    const deck::Value* value = value_at(state_.deck, *cell);
    if (value != nullptr && std::holds_alternative<std::monostate>(*value) &&
        parse_typed_text(*variable_of(*cell), issue.value).problem)
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
         bytes_of(path) != original_text_;
}

std::vector<Issue> Document::errors() {
  end_undo_step();
  check_model();
  std::vector<Issue> reasons;
  for (const Problem& problem : problems_)
    if (problem.issue.severity == Severity::Error) reasons.push_back(problem.issue);
  return reasons;
}

void Document::save(const fs::path& name) {
  const fs::path path = normalized_path(name);
  std::vector<Issue> reasons = errors();
  // The text of the file is kept as far as possible; foreign characters as UTF-8.
  const std::string& base = state_.comments.empty() ? original_text_ : state_.comments;
  // Records X go to ADORE.json.
  const deck::Deck plain = runs::without_extension(state_.deck);
  deck::DeckTextWithComments kept{deck::write_deck(plain), original_text_.empty(), {}};
  if (!base.empty()) kept = deck::with_deck(is_utf8(base) ? base : utf8_of_latin1(base), plain);
  const bool replaced = state_.comments != saved_comments_;  // the file has another bearing
  const std::string& text = kept.text;
  deck::ReadResult back;
  if (reasons.empty()) {
    back = deck::read_deck_text(text, path.string());
    take_errors(reasons, back.issues);
    if (reasons.empty() && !(back.deck == plain)) {
      Issue issue;
      issue.record = back.deck.records == plain.records ? "12" : "";
      issue.message = issue.record.empty()
                          ? "a title or label would change when the saved deck is read again"
                          : "the lines of user routines would change when the saved deck is read "
                            "again: the first line looks like a record, or a line is blank";
      issue.remedy = "change that text";
      reasons.push_back(std::move(issue));
    }
  }
  if (!reasons.empty()) throw InputError(std::move(reasons));
  const bool lost = file_changed_externally_ ||
                    (!original_matches_deck_ && (file_has_errors_ || !kept.kept || replaced));
  backup_path_.clear();
  if (lost && same_file(path, path_)) backup_path_ = write_backup_copy(path, original_text_);
  save_options(path);
  write_file_atomically(path, text);
  path_ = path;
  original_text_ = text;
  original_matches_deck_ = text == deck::write_deck(plain);
  file_changed_externally_ = file_has_errors_ = false;
  file_issues_ = std::move(back.issues);  // also needed by readers of the new file
  remove_duplicate_file_issues();
  for (const std::string& record : kept.doubtful_units)
    file_issues_.push_back(doubtful_units(record, state_.deck.units()));
  if (!draft_path_.empty()) {  // it became this deck
    remove_file(draft_path_);
    draft_path_.clear();
  }
  saved_deck_ = state_.deck;
  saved_unparsed_texts_ = state_.drafts;
  saved_options_ = state_.options;
  saved_comments_ = state_.comments;
  find_problems();
  notify();
}

void Document::save_draft(const fs::path& path) {
  end_undo_step();
  write_file_atomically(path, std::string(kDraftHead) + snapshot(""));
  draft_path_ = normalized_path(path);
  saved_deck_ = state_.deck;
  saved_unparsed_texts_ = state_.drafts;
  saved_options_ = state_.options;
  notify();
}

void Document::keep_edited_deck() {
  if (path_.empty()) return;
  original_text_ = bytes_of(path_);
  original_matches_deck_ = original_text_.empty();
  file_changed_externally_ = !original_matches_deck_;
  saved_deck_ = deck::read_deck_text(original_text_, path_.string()).deck;
  saved_unparsed_texts_.clear();
  notify();
}

}  // namespace adore::adrinput
