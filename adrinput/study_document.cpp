#include "adrinput/study_document.hpp"

#include "adrinput/file_names.hpp"
#include "adrinput/study_example.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/write_folder.hpp"
#include "studies/campaign.hpp"
#include "studies/study_check.hpp"
#include "studies/study_splice.hpp"
#include "studies/study_text.hpp"

#include <algorithm>
#include <utility>

namespace adore::adrinput {

namespace fs = std::filesystem;

namespace {

constexpr long kSampledAtOnce = 20'000;

StudyJson& object_at(StudyJson& values, const std::string& key) {
  StudyJson& inner = values[key];
  if (!inner.is_object()) inner = StudyJson::object();
  return inner;
}

}  // namespace

void StudyDocument::open(const fs::path& file) {
  std::string text = read_text_file(file);
  path_ = normalized_path(file);
  stored_ = text;
  state_ = std::move(text);
  undo_.clear();
  redo_.clear();
  last_edit_target_.clear();
  read_values();
  if (changed) changed();
}

void StudyDocument::start_new(const fs::path& file, const std::string& kind, const fs::path& deck) {
  StudyJson values = studies::read_study_text(studies::example_study(kind), "example.json").json;
  if (!deck.empty()) {
    std::error_code error;
    const fs::path beside = fs::proximate(deck, fs::absolute(file).parent_path(), error);
    values["deck"] = (error || beside.empty() ? deck : beside).string();
    // Files that cannot be read are reported by the check.
    if (const fs::path whole = fs::absolute(deck, error); fs::is_regular_file(whole, error))
      values = adapt_example_to_deck(std::move(values), deck::read_deck(whole).deck);
  }
  path_ = normalized_path(file);
  stored_.reset();
  state_ = studies::write_study_text(values, studies::is_toml(file));
  undo_.clear();
  redo_.clear();
  last_edit_target_.clear();
  read_values();
  if (changed) changed();
}

void StudyDocument::read_values() {
  values_.reset();
  loose_comments_ = false;
  try {
    studies::StudyText read = studies::read_study_text(state_, path_);
    if (read.json.is_object()) values_ = std::move(read.json);
    loose_comments_ = read.loose_comments;
  } catch (const InputError&) {
    // check() gives the reason.
  }
}

std::optional<studies::Kind> StudyDocument::kind() const {
  if (!values_ || !values_->contains("kind")) return {};
  const std::string name = shown_value(values_->at("kind"));
  for (int k = 0; k < studies::kKinds; ++k)
    if (studies::kind_name(static_cast<studies::Kind>(k)) == name)
      return static_cast<studies::Kind>(k);
  return {};
}

void StudyDocument::change(std::string text, const std::string& place, bool comments_lost) {
  if (text == state_) return;
  comments_lost_ = comments_lost;
  if (place.empty() || place != last_edit_target_) undo_.push_back(state_);
  last_edit_target_ = place;
  redo_.clear();
  state_ = std::move(text);
  read_values();
  if (changed) changed();
}

void StudyDocument::set_text(const std::string& text) { change(text, "text"); }

void StudyDocument::write_values(StudyJson values, const std::string& place) {
  studies::EditedText edited = studies::edited_study_text(state_, values, path_);
  const bool lost = edited.rewritten && loose_comments_;
  change(std::move(edited.text), place, lost);
}

std::string StudyDocument::field(const StudyField& field) const {
  if (!values_) return {};
  if (field.key == "deck" && values_->contains("decks")) return shown_value(values_->at("decks"));
  const std::string key(field.key);
  const StudyJson* at = &*values_;
  if (const auto dot = key.find('.'); dot != std::string::npos) {
    const auto outer = at->find(key.substr(0, dot));
    if (outer == at->end() || !outer->is_object()) return {};
    at = &*outer;
  }
  const auto found = at->find(key.substr(key.find('.') + 1));
  return found == at->end() ? std::string() : shown_value(*found);
}

void StudyDocument::set_field(const StudyField& field, const std::string& typed) {
  if (!values_ || typed == this->field(field)) return;
  StudyJson values = *values_;
  StudyJson value = typed_value(field.cell, typed);
  std::string key(field.key);
  if (key == "deck") {  // one deck, or several
    const bool several = value.is_array() && value.size() > 1;
    if (value.is_array() && !several) value = value.empty() ? StudyJson() : value.front();
    values.erase(several ? "deck" : "decks");
    if (several) key = "decks";
  }
  const auto dot = key.find('.');
  const std::string outer = key.substr(0, dot), inner = key.substr(dot + 1);
  if (dot == std::string::npos) {
    if (value.is_null() || value == false)
      values.erase(key);
    else
      values[key] = value;
  } else if (!value.is_null()) {
    object_at(values, outer)[inner] = value;
  } else if (values.contains(outer) && values[outer].is_object()) {
    values[outer].erase(inner);
    if (values[outer].empty()) values.erase(outer);
  }
  write_values(std::move(values), "field " + std::string(field.key));
}

std::size_t StudyDocument::rows(std::string_view table) const {
  if (!values_) return 0;
  const auto found = values_->find(std::string(table));
  return found == values_->end() || !found->is_array() ? 0 : found->size();
}

std::vector<std::string> StudyDocument::cells(std::string_view table, std::size_t row) const {
  return row_cells(table, values_->at(std::string(table)).at(row));
}

void StudyDocument::set_cell(std::string_view table, std::size_t row, std::size_t column,
                             const std::string& typed) {
  if (!values_) return;
  const std::string key(table);
  const bool fresh = row >= rows(table);
  if (fresh && typed.empty()) return;
  std::vector<std::string> cells = row_cells(table, fresh ? StudyJson() : values_->at(key)[row]);
  if (cells.at(column) == typed) return;
  cells[column] = typed;
  StudyJson values = *values_;
  if (!values.contains(key) || !values[key].is_array()) values[key] = StudyJson::array();
  StudyJson& list = values[key];
  if (fresh)
    list.push_back(row_from_cells(table, cells, StudyJson()));
  else
    list[row] = row_from_cells(table, cells, list[row]);
  write_values(std::move(values), key + " " + std::to_string(std::min(row, list.size())) + " " +
                                      std::to_string(column));
}

void StudyDocument::remove_row(std::string_view table, std::size_t row) {
  if (row >= rows(table)) return;
  StudyJson values = *values_;
  StudyJson& list = values[std::string(table)];
  list.erase(list.begin() + static_cast<long>(row));
  // An empty list of these is equivalent to none.
  if (list.empty() && (table == "correlation" || table == "variables"))
    values.erase(std::string(table));
  write_values(std::move(values), "");
}

void StudyDocument::undo() {
  comments_lost_ = false;
  if (undo_.empty()) return;
  redo_.push_back(std::exchange(state_, undo_.back()));
  undo_.pop_back();
  last_edit_target_.clear();
  read_values();
  if (changed) changed();
}

void StudyDocument::redo() {
  comments_lost_ = false;
  if (redo_.empty()) return;
  undo_.push_back(std::exchange(state_, redo_.back()));
  redo_.pop_back();
  last_edit_target_.clear();
  read_values();
  if (changed) changed();
}

bool StudyDocument::changed_on_disk() const {
  std::error_code error;
  if (!fs::exists(path_, error)) return false;
  try {
    return !stored_ || read_text_file(path_) != *stored_;
  } catch (const InputError&) {
    return true;
  }
}

void StudyDocument::save(const fs::path& file) {
  std::string text = state_;
  if (values_ && studies::is_toml(file) != studies::is_toml(path_))
    text = studies::write_study_text(*values_, studies::is_toml(file));
  write_file_atomically(file, text);
  delete_unsaved_copy();
  path_ = normalized_path(file);
  stored_ = text;
  state_ = std::move(text);
  last_edit_target_.clear();
  read_values();
  if (changed) changed();
}

StudyDocument::Finding StudyDocument::check() const {
  Finding out;
  try {
    const studies::Study study = studies::open_study_text(state_, path_);
    out.runs = studies::count_points(study);
    // Samples of a large study are drawn when it starts, not at each key.
    const bool small = out.runs <= kSampledAtOnce;
    studies::check_decks(study,
                         small ? studies::initial_points(study) : std::vector<studies::Point>());
  } catch (const std::exception& error) {
    out.runs = 0;
    out.problem = error.what();
    out.key = studies::key_in_message(out.problem, path_.string());
    // The title of the window names the file.
    const std::string folder = path_.has_parent_path() ? path_.parent_path().string() + "/" : "";
    if (!folder.empty() && out.problem.starts_with(folder)) out.problem.erase(0, folder.size());
  }
  return out;
}

fs::path StudyDocument::unsaved_path() const {
  return path_.parent_path() / ("." + path_.filename().string() + ".unsaved");
}

void StudyDocument::store_unsaved() const {
  if (modified())
    write_file_atomically(unsaved_path(), state_);
  else
    delete_unsaved_copy();
}

void StudyDocument::delete_unsaved_copy() const { remove_file(unsaved_path()); }

std::optional<std::string> StudyDocument::unsaved_text() const {
  std::error_code error;
  if (!fs::exists(unsaved_path(), error)) return {};
  try {
    std::string text = read_text_file(unsaved_path());
    if (text == state_) return {};
    return text;
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace adore::adrinput
