#include "adrinput/document.hpp"

#include "adrinput/options_page.hpp"
#include "adrinput/typed.hpp"
#include "adrinput/window_words.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "runs/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace adore::adrinput {
namespace {

constexpr std::size_t kMostSteps = 200;
constexpr std::string_view kUserLines = "12";

bool has_error(const std::vector<Problem>& problems) {
  return std::any_of(problems.begin(), problems.end(), [](const Problem& problem) {
    return problem.issue.severity == Severity::Error;
  });
}

bool same_variable(const Cell& a, const Cell& b) {
  return a.record == b.record && a.instance == b.instance && a.variable == b.variable;
}

}  // namespace

Document::Document() { start_new("ball"); }

void Document::start(State state) {
  state_ = std::move(state);
  undo_.clear();
  redo_.clear();
  undo_step_cell_.reset();
  typed_cell_.reset();
  draft_path_.clear();
  file_changed_externally_ = false;
  refusals_.clear();
  start_refusals_.clear();
  checked_candidate_.reset();
  unused_reasons_.clear();
  effects_.clear();
  backup_path_.clear();
  model_issues_.clear();
  change_issues_.clear();
  // Values of the file that its options do not need are kept with the hidden ones.
  for (const deck::RecordData& record : std::exchange(state_.deck.shelf, {}))
    state_.shelf.try_emplace({record.id, record.instance}, record);
  complete_records();
  saved_deck_ = state_.deck;
  saved_unparsed_texts_ = state_.drafts;
  saved_options_ = state_.options;
  saved_comments_ = state_.comments;
  find_problems();
}

void Document::start_new(std::string_view template_name) {
  State state;
  state.deck = deck::new_deck(template_name);
  path_.clear();
  original_text_.clear();
  original_matches_deck_ = true;
  file_has_errors_ = false;
  option_file_ = {};
  file_issues_.clear();
  start(std::move(state));
  notify();
}

void Document::start_from_text(const std::string& text) {
  deck::ReadResult read = deck::read_deck_text(text, "new deck");
  if (!read.ok()) throw InputError(std::move(read.issues));
  start_new("ball");  // otherwise like a new deck
  State state;
  state.deck = std::move(read.deck);
  state.deck.file.clear();
  original_text_ = text;
  original_matches_deck_ = true;  // nobody's file
  start(std::move(state));
  notify();
}

void Document::change(const std::vector<std::pair<std::string, std::string>>& sets) {
  end_undo_step();
  deck::Deck changed_deck = state_.deck;
  changed_deck.set_all(sets);
  if (changed_deck == state_.deck) return;
  Cell cell;
  for (const deck::RecordData& record : changed_deck.records)
    if (const deck::RecordData* old =
            deck::find_record_data(state_.deck, record.id, record.instance);
        cell.record.empty() && (old == nullptr || !(*old == record)))
      cell.record = record.id;
  begin_undo_step(cell);
  state_.drafts.clear();
  const deck::Deck before = std::exchange(state_.deck, std::move(changed_deck));
  mark_changed_as_typed(before);
  complete_records();
  if (std::none_of(sets.begin(), sets.end(), [](const auto& set) {
        return std::string_view(set.first).starts_with("kPltElemInd");
      }))
    renumber_monitored_bodies(before);
  undo_step_cell_.reset();
  find_problems();
  notify();
}

void Document::replace(deck::Deck deck, std::string text) {
  end_undo_step();
  if (deck == state_.deck) return;
  Cell cell;
  cell.record = "4";
  begin_undo_step(cell);
  state_.drafts.clear();
  state_.shelf.clear();  // values of another bearing
  state_.previous_units.reset();
  state_.typed_since.clear();
  state_.comments = std::move(text);
  state_.deck = std::move(deck);
  complete_records();
  undo_step_cell_.reset();
  file_issues_.clear();
  find_problems();
  notify();
}

bool Document::modified() const {
  return !(state_.deck == saved_deck_) || state_.drafts != saved_unparsed_texts_ ||
         state_.options != saved_options_;
}

std::vector<std::string> Document::pages() const {
  std::vector<std::string> out;
  for (const deck::RecordData& record : state_.deck.records)
    if (out.empty() || out.back() != record.id) out.push_back(record.id);
  out.emplace_back(kUserLines);
  out.emplace_back(kOptionsPage);
  return out;
}

int Document::instances(std::string_view record) const {
  if (record == kOptionsPage) return 1;
  return static_cast<int>(
      std::count_if(state_.deck.records.begin(), state_.deck.records.end(),
                    [&](const deck::RecordData& data) { return data.id == record; }));
}

std::string Document::text(const Cell& cell) const {
  const auto draft = state_.drafts.find(cell);
  if (draft != state_.drafts.end()) return draft->second;
  if (cell.record == kOptionsPage) return option_text(state_.options, cell);
  const deck::Value* value = value_at(state_.deck, cell);
  return value == nullptr ? std::string() : shown_text(*value);
}

std::string Document::unused_reason(const Cell& cell) const {
  const auto found = unused_reasons_.find(cell);
  return found == unused_reasons_.end() ? std::string() : found->second;
}

void Document::begin_undo_step(const Cell& cell) {
  redo_.clear();
  if (undo_step_cell_ == cell || (step_spans_cells_ && undo_step_cell_)) return;
  undo_step_cell_ = cell;
  change_issues_.clear();
  undo_.push_back({state_, cell.record});
  if (undo_.size() > kMostSteps) undo_.erase(undo_.begin());
}

void Document::type(const Cell& cell, std::string_view typed) {
  if (typed_cell_ && *typed_cell_ != cell) end_undo_step();
  if (cell.record == kOptionsPage) return edit(cell, typed);
  if (value_at(state_.deck, cell) == nullptr) return;
  if (text(cell) == typed &&
      (has_unparsed_text(cell) || !meaning || meaning(cell, std::string(typed)) == typed))
    return;
  begin_undo_step(cell);
  state_.drafts[cell] = typed;
  typed_cell_ = cell;
  find_problems();
  notify();
}

/// The text being typed becomes the value; one step for undo, and none if nothing changed.
void Document::end_undo_step() {
  if (typed_cell_) {
    const Cell cell = *std::exchange(typed_cell_, std::nullopt);
    const auto draft = state_.drafts.find(cell);
    if (draft != state_.drafts.end()) {
      const std::string typed = draft->second;
      const State& before = undo_.back().state;
      const auto held = before.drafts.find(cell);  // content of the field before typing
      state_.drafts.erase(draft);
      if (held != before.drafts.end()) state_.drafts[cell] = held->second;
      edit(cell, meaning ? meaning(cell, typed) : typed);
      if (state_.deck == before.deck && state_.drafts == before.drafts &&
          state_.options == before.options) {
        undo_.pop_back();
        find_problems();
        notify();
      }
    }
  }
  undo_step_cell_.reset();
}

void Document::edit(const Cell& cell, std::string_view typed) {
  if (typed_cell_ && *typed_cell_ != cell) end_undo_step();
  if (typed_cell_) {
    typed_cell_.reset();
    state_.drafts.erase(cell);
  }
  if (cell.record == kOptionsPage) return edit_option(cell, typed);
  const deck::Value* old = value_at(state_.deck, cell);
  if (old == nullptr) return;
  const deck::VariableSpec& variable = *variable_of(cell);
  TypedValue value = parse(cell, typed);
  if (text(cell) == typed && (value.problem || state_.drafts.count(cell) == 0)) return;
  if (!value.problem && value.value == *old && state_.drafts.count(cell) == 0) return;
  begin_undo_step(cell);
  const deck::UnitSystem units = state_.deck.units();
  const deck::Deck before = state_.deck;
  if (value.problem) {
    state_.drafts[cell] = typed;
  } else {
    state_.drafts.erase(cell);
    deck::RecordData& record = *record_at(state_.deck, cell.record, cell.instance);
    record.values[cell.variable][cell.element] = std::move(value.value);
    std::erase(record.defaulted, deck::RecordData::Element{cell.variable, cell.element});
    if (variable.type == deck::VarType::Integer) {
      complete_records();
      if (variable.name == "nRe" || variable.name == "nCseg") renumber_monitored_bodies(before);
    }
  }
  if (state_.previous_units && !value.problem) state_.typed_since.insert(cell);
  track_unit_change(units);
  std::erase_if(file_issues_, [&](const Issue& issue) {
    const std::optional<Cell> at = cell_of(issue);
    return at && same_variable(*at, cell);
  });
  find_problems();
  notify();
}

void Document::edit_all(const std::vector<std::pair<Cell, std::string>>& typed) {
  end_undo_step();
  {
    struct Apart {  // edit() may throw
      bool& together;
      ~Apart() { together = false; }
    } const apart{step_spans_cells_};
    step_spans_cells_ = true;
    for (const auto& [cell, text] : typed) edit(cell, text);
  }
  end_undo_step();
}

void Document::set_user_lines(std::vector<std::string> lines) {
  if (typed_cell_) end_undo_step();
  if (lines == state_.deck.user_lines) return;
  Cell cell;
  cell.record = kUserLines;
  begin_undo_step(cell);
  state_.deck.user_lines = std::move(lines);
  find_problems();
  notify();
}

void Document::accept_defaults(std::string_view record) {
  bool any = false;
  for (deck::RecordData& data : state_.deck.records)
    if (data.id == record && !data.defaulted.empty()) {
      data.defaulted.clear();
      any = true;
    }
  if (any) notify();
}

/// Keeps a record for later use; for shortened arrays also the removed elements.
void Document::remember(const deck::RecordData& record) {
  deck::RecordData kept = record;
  deck::RecordData& slot = state_.shelf[{record.id, record.instance}];
  for (std::size_t v = 0; v < std::min(kept.values.size(), slot.values.size()); ++v)
    for (std::size_t k = kept.values[v].size(); k < slot.values[v].size(); ++k) {
      kept.values[v].push_back(slot.values[v][k]);
      const deck::RecordData::Element at{v, k};
      if (std::find(slot.defaulted.begin(), slot.defaulted.end(), at) != slot.defaulted.end())
        kept.defaulted.push_back(at);
    }
  slot = std::move(kept);
}

/// Adds records and array elements needed by the options, with the values that they had before.
void Document::complete_records() {
  for (const deck::RecordData& record : state_.deck.records) remember(record);
  restore_from_shelf();
}

void Document::restore_from_shelf() {
  state_.deck.records.clear();
  for (const auto& [place, record] : state_.shelf) state_.deck.records.push_back(record);
  state_.deck.complete();
  if (state_.previous_units) mark_inherited_as_typed();
}

std::string Document::move_in_history(std::vector<UndoStep>& from, std::vector<UndoStep>& to) {
  if (from.empty()) return {};
  UndoStep step = std::move(from.back());
  from.pop_back();
  change_issues_.clear();
  to.push_back({std::move(state_), step.page});
  state_ = std::move(step.state);
  undo_step_cell_.reset();
  find_problems();
  notify();
  return step.page;
}

std::string Document::undo() {
  end_undo_step();
  return move_in_history(undo_, redo_);
}

std::string Document::redo() {
  end_undo_step();
  return move_in_history(redo_, undo_);
}

void Document::add_problem(Issue issue, bool refused) {
  Problem problem;
  problem.refused = refused;
  problem.cell = cell_of(issue);
  const bool option = issue.record == kOptionsPage;
  if (problem.cell && !option && value_at(state_.deck, *problem.cell) == nullptr)
    problem.cell.reset();
  problem.page = issue.record;
  if (!issue.record.empty() && issue.record != kUserLines && !option &&
      deck::find_record_data(state_.deck, issue.record) == nullptr)
    problem.page.clear();
  problem.issue = std::move(issue);
  problems_.push_back(std::move(problem));
}

void Document::find_problems() {
  problems_.clear();
  for (const auto& [cell, typed] : state_.drafts) {
    if (value_at(state_.deck, cell) == nullptr || typed_cell_ == cell) continue;
    const deck::VariableSpec& variable = *variable_of(cell);
    deck::NumberProblem problem = parse(cell, typed).problem;
    if (!problem)  // of a session that was cut off
      problem = {"the typed value is not accepted yet", "press Enter in its field"};
    Issue issue;
    issue.record = cell.record;
    issue.variable = variable.name;
    if (!deck::find_record(cell.record)->repeat.empty())
      issue.variable += fmt::format("[{}]", cell.instance);
    if (variable.length != "1") issue.variable += fmt::format("[{}]", cell.element + 1);
    issue.value = typed;
    issue.message = problem.message;
    issue.remedy = problem.remedy;
    add_problem(std::move(issue));
  }
  for (Issue& issue : deck::check_deck(state_.deck)) {
    const std::optional<Cell> cell = cell_of(issue);
    const bool said =
        cell && std::any_of(state_.drafts.begin(), state_.drafts.end(),
                            [&](const auto& draft) { return same_variable(draft.first, *cell); });
    if (!said) add_problem(std::move(issue));
  }
  find_option_problems();
  // Rejections are kept: an error elsewhere does not remove the rejection of a record.
  if (has_error(problems_)) model_issues_.clear();
  for (const Issue& issue : model_issues_) {
    const std::string text = issue.text();
    add_problem(issue, std::any_of(refusals_.begin(), refusals_.end(),
                                   [&](const Issue& refusal) { return refusal.text() == text; }));
  }
  if (!has_error(problems_)) add_refusals();
  if (!has_error(problems_)) add_remarks();
  for (const Issue& issue : change_issues_) add_problem(issue);
  const std::vector<Problem> live = problems_;
  for (const Issue& from_file : file_issues_) {
    const std::optional<Cell> cell = cell_of(from_file);
    const bool said = cell && std::any_of(live.begin(), live.end(), [&](const Problem& problem) {
                        return problem.cell && same_variable(*problem.cell, *cell);
                      });
    if (said) continue;
    Issue issue = from_file;
    if (issue.severity == Severity::Error) issue.severity = Severity::Warning;
    issue.message = issue.line > 0
                        ? fmt::format("in the file, line {}: {}", issue.line, issue.message)
                        : "in the file: " + issue.message;
    add_problem(std::move(issue));
  }
  const auto weight = [](const Problem& problem) {
    if (problem.issue.severity == Severity::Error) return 3;
    if (problem.refused) return 2;
    return problem.issue.severity == Severity::Warning ? 1 : 0;
  };
  std::stable_sort(problems_.begin(), problems_.end(),
                   [&](const Problem& a, const Problem& b) { return weight(a) > weight(b); });
}

/// Errors that end a run before its first step; some of them are already errors of the model.
void Document::add_refusals() {
  if (!refusals_.empty()) return;
  for (Issue issue : start_refusals_) {
    issue.severity = Severity::Note;
    issue.code = "deck.refused";
    issue.message = "`adore run` will refuse this deck: " + issue.message;
    add_problem(std::move(issue), true);
  }
}

bool Document::needs_start_check() const {
  return !typed_cell_ && !has_error(problems_) &&
         !(checked_candidate_ && *checked_candidate_ == candidate());
}

void Document::invalidate_start_check() {
  checked_candidate_.reset();
  notify();
}

void Document::set_start_check_result(const Candidate& of, std::vector<Issue> refusals,
                                      std::vector<Finding> remarks) {
  if (!(of == candidate())) return;  // of a deck that is no longer here
  checked_candidate_ = of;
  start_refusals_ = std::move(refusals);
  start_remarks_ = shown_findings(remarks);
  find_problems();
  notify();
}

DeckState Document::deck_state() const {
  if (has_error(problems_)) return DeckState::Wrong;
  if (!refusals_.empty()) return DeckState::Refused;
  if (!checked_candidate_ || !(*checked_candidate_ == candidate())) return DeckState::Unchecked;
  return start_refusals_.empty() ? DeckState::Ready : DeckState::Refused;
}

void Document::check_model() {
  runs::ModelCheck found;
  model_issues_.clear();
  find_problems();
  const bool examined = !has_error(problems_);
  if (examined) try {
      found = runs::examine_model(state_.deck);
    } catch (const std::exception& error) {
      Issue issue;
      issue.message = error.what();
      found.issues.push_back(std::move(issue));
    }
  for (Issue& issue : found.issues) {
    issue.message = replace_cli_terms(std::move(issue.message));
    issue.remedy = replace_cli_terms(std::move(issue.remedy));
  }
  model_issues_.assign(found.issues.begin(), found.issues.end());
  if (examined) refusals_ = std::move(found.refusals);
  if (examined) effects_ = std::move(found.effects);
  if (examined) unused_reasons_.clear();  // else it is unchanged since the last valid deck
  for (const deck::NoPart& value : found.unused) {
    Issue named;
    named.record = value.record;
    named.variable = value.variable;
    if (const std::optional<Cell> cell = cell_of(named)) unused_reasons_[*cell] = value.because;
  }
  find_problems();
  notify();
}

/// Findings of statics and plan that the checks of the deck do not contain. A finding without
/// variable leads to the field of its kind.
void Document::add_remarks() {
  if (!checked_candidate_ || !(*checked_candidate_ == candidate())) return;
  for (const Finding& one : start_remarks_) {
    const bool said = std::any_of(problems_.begin(), problems_.end(), [&](const Problem& problem) {
      return problem.issue.message == one.message && problem.issue.variable == one.variable;
    });
    if (said) continue;
    add_problem(one);
    if (!one.variable.empty()) continue;
    if (const std::optional<Issue> place = issue_of_finding(state_.deck, one)) {
      problems_.back().page = place->record;
      problems_.back().cell = cell_of(*place);
    }
  }
}

bool Document::has_errors() const { return has_error(problems_); }

int Document::warnings() const {
  return static_cast<int>(std::count_if(
      problems_.begin(), problems_.end(),
      [](const Problem& problem) { return problem.issue.severity == Severity::Warning; }));
}

RecordState Document::state_of(std::string_view record) const {
  RecordState state = RecordState::Complete;
  for (const deck::RecordData& data : state_.deck.records)
    if (data.id == record && !data.defaulted.empty()) state = RecordState::Untouched;
  for (const std::vector<Issue>* refusals : {&refusals_, &start_refusals_})
    for (const Issue& refusal : *refusals)
      if (refusal.record == record) state = RecordState::Doubtful;
  for (const Problem& problem : problems_) {
    if (problem.page != record) continue;
    if (problem.issue.severity == Severity::Error) return RecordState::Wrong;
    if (problem.issue.severity == Severity::Warning) state = RecordState::Doubtful;
  }
  return state;
}

void Document::notify() {
  if (changed) changed();
}

}  // namespace adore::adrinput
