#include "runs/check.hpp"

#include "deck/unit_text.hpp"
#include "life/parameters.hpp"
#include "runs/prepare.hpp"
#include "runs/rehearsal.hpp"
#include "runs/unused_request.hpp"
#include "setup/build_bearing.hpp"
#include "setup/build_life.hpp"
#include "setup/run_control.hpp"
#include "setup/scene_plan.hpp"
#include "setup/unused_values.hpp"
#include "statics/ball_model.hpp"
#include "statics/roller_model.hpp"
#include "thermal/operating.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace adore::runs {

namespace {

template <class Remarks>
bool has_error(const Remarks& issues) {
  return std::any_of(issues.begin(), issues.end(),
                     [](const Issue& issue) { return issue.severity == Severity::Error; });
}

/// Builds the model of a deck without solving it. @throws InputError
void check_rest(const deck::Deck& deck, const bearing::Bearing& operating) {
  (void)setup::build_run_control(deck);
  const bearing::LifeInputs life_inputs = setup::build_life_inputs(deck);
  const bool line = operating.rollers() != nullptr;
  (void)life::life_parameters(life_inputs, line, operating.element_material,
                              operating.race_material);
  if (line)
    (void)statics::make_roller_model(operating, {});
  else
    (void)statics::make_ball_model(operating, {});
}

}  // namespace

namespace {

/// Names of the plan's effects that are on and that run option effectsOff can leave out.
std::vector<std::string> effects_to_leave_out(const deck::Deck& deck,
                                              const bearing::Bearing& bearing) {
  std::vector<std::string> out;
  const setup::RunControl control = setup::build_run_control(deck);
  if (!control.dynamic) return out;
  const scene::ScenePlan plan = setup::make_scene_plan(deck, bearing, control, {});
  for (const scene::EffectEntry& entry : plan.effects)
    if (entry.on && setup::can_be_left_out(plan, entry.effect)) out.push_back(entry.name);
  return out;
}

}  // namespace

std::vector<Issue> check_model(const deck::Deck& deck) {
  const std::vector<Finding> found = examine_model(deck).issues;
  return {found.begin(), found.end()};
}

ModelCheck examine_model(const deck::Deck& deck) {
  ModelCheck out;
  std::vector<Finding>& issues = out.issues = findings_of(setup::check_buildable(deck));
  const bool runs = !has_error(issues);
  for (Finding& issue : issues)
    if (issue.severity == Severity::Error) {
      issue.severity = Severity::Note;
      issue.code = "deck.refused";
      issue.message = "`adore run` will refuse this deck: " + issue.message;
      out.refusals.push_back(issue);
    }
  deck::Deck model = deck;
  if (!runs) {
    // A motion that cannot be run still has a geometry.
    model.set("mode", "-1");
    model.complete();
    if (has_error(setup::check_buildable(model))) return out;
  }
  model.reads = std::make_shared<deck::ReadLog>();
  try {
    const bearing::Bearing operating = thermal::operating_bearing(setup::build_bearing(model));
    for (Finding& one : operating_warnings(operating, deck.file)) issues.push_back(std::move(one));
    check_rest(model, operating);
    if (runs) {
      if (std::optional<Issue> note = no_step_note(model)) issues.push_back(std::move(*note));
      out.unused = setup::find_unused_values(model);
      if (std::optional<Issue> note =
              setup::note_unused_values(out.unused, model, {issues.begin(), issues.end()}))
        issues.push_back(std::move(*note));
      out.effects = effects_to_leave_out(model, operating);
    }
  } catch (const InputError& error) {
    for (Issue issue : error.issues()) {
      if (issue.file.empty()) issue.file = deck.file;
      issues.push_back(std::move(issue));
    }
  }
  const auto in_units = [&](Issue& issue) {
    issue.message = deck::message_in_units(issue.message, deck.units());
    issue.remedy = deck::message_in_units(issue.remedy, deck.units());
  };
  for (Finding& issue : issues) in_units(issue);
  for (Issue& issue : out.refusals) in_units(issue);
  return out;
}

bool CheckReport::ok() const { return !has_error(issues); }

namespace {

/// The run options of the request. @throws InputError
void check_options(const DeckRequest& request) {
  std::map<std::string, std::string> options;
  if (!request.in_memory) options = options_of_deck(deck_path(request));
  for (const auto& [name, value] : request.options) options[name] = value;
  (void)setup::build_run_options(options);
}

/// Adds what is not said yet; of two equal texts, the one with a value is kept.
void add_new(std::vector<Finding>& said, std::vector<Finding> more) {
  std::map<std::string, std::size_t> places;
  for (std::size_t k = 0; k < said.size(); ++k) places.emplace(said[k].text(), k);
  for (Finding& one : more) {
    const auto [place, is_new] = places.emplace(one.text(), said.size());
    if (is_new)
      said.push_back(std::move(one));
    else if (one.measured && !said[place->second].measured)
      said[place->second] = std::move(one);
  }
}

}  // namespace

CheckReport check(const DeckRequest& request, std::stop_token stop) {
  deck::ReadResult read = read_deck(request);
  CheckReport out{read.deck.file, read.deck.records.size(), findings_of(read.issues)};
  if (read.ok() && !request.sets.empty()) try {
      LoadedDeck loaded = load_deck(request);
      read.deck = std::move(loaded.deck);
      out.issues = std::move(loaded.warnings);
    } catch (const InputError& error) {
      out.issues = findings_of(error.issues());
      return out;
    }
  bool begins = read.ok();
  // Only a run knows what routines of the user make of the model.
  if (begins && !request.routines && request.user.empty()) {
    ModelCheck model = examine_model(read.deck);
    begins = model.refusals.empty();
    // A deck that `adore run` rejects is an error of `adore check`, too.
    for (Finding& issue : model.issues)
      for (const Issue& refusal : model.refusals)
        if (issue.text() == refusal.text()) issue.severity = Severity::Error;
    add_new(out.issues, std::move(model.issues));
  }
  try {
    check_options(request);
  } catch (const InputError& error) {  // the run would end with it
    add_new(out.issues, findings_of(error.issues()));
  }
  if (!begins || !out.ok()) return out;
  LoadedDeck input = load_deck(request);
  input.stop = std::move(stop);
  DryRunResult rehearsal = dry_run_without_files(std::move(input));
  add_new(out.issues, std::move(rehearsal.remarks));
  add_new(out.issues, findings_of(std::move(rehearsal.refusals)));
  return out;
}

}  // namespace adore::runs
