#include "design/find.hpp"

#include "base/errors.hpp"
#include "base/interrupted.hpp"
#include "deck/lookup.hpp"
#include "deck/schema.hpp"
#include "results/h5_reader.hpp"
#include "runs/key_results.hpp"
#include "runs/option_file.hpp"
#include "runs/run_ending.hpp"
#include "runs/static_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace adore::design {
namespace {

bool is_of_equilibrium(std::string_view id) {
  // Behind "Of a motion" in the table, and those that only a run has.
  const auto specs = results::key_result_specs();
  const auto motion = std::find_if(specs.begin(), specs.end(),
                                   [](const auto& spec) { return spec.id == "time_s"; });
  const auto found =
      std::find_if(specs.begin(), specs.end(), [id](const auto& spec) { return spec.id == id; });
  return found < motion && !id.starts_with("run_life_") && id != "life_stored_hours";
}

std::string unit_of(const results::KeyResultSpec& spec) {
  const std::string unit(results::coherent_unit(*spec.unit));
  return unit == "-" ? std::string() : unit;
}

/// The variable among values that the deck's equilibrium does not use: reason; else empty.
std::string idle_reason(const runs::Prepared& prepared, const std::string& name) {
  for (const deck::NoPart& one : prepared.no_part)
    if (one.variable == name || one.variable == name + "[1]") return one.because;
  return {};
}

std::string lacking(const std::string& id, const results::KeyResults& results, bool quasi_static) {
  std::string has;
  for (const results::KeyResult& one : results)
    has += fmt::format("{}{}", has.empty() ? "" : ", ", one.of.id);
  return fmt::format(
      "{}: the equilibrium of this deck does not have this result.{} Available results: {}.", id,
      quasi_static ? ""
                   : " Friction and temperatures need a quasi-static deck: set mode "
                     "to -1.",
      has);
}

struct Variable {
  bool option = false, whole = false;
  std::string unit;
};

Variable variable_of(const FindRequest& request) {
  const std::string bare = request.unknown.name.substr(0, request.unknown.name.find('['));
  const auto found = deck::find_variable(bare);
  if (found.empty()) {
    const auto& options = runs::run_options();
    std::vector<std::string> names;
    for (const runs::RunOptionInfo& one : options) names.push_back(one.name);
    if (std::find(names.begin(), names.end(), request.unknown.name) != names.end())
      return {true, false, ""};
    for (const deck::RecordSpec& record : deck::schema())
      for (const deck::VariableSpec& one : record.variables)
        if (one.name != "recID") names.emplace_back(one.name);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::string text =
        unknown_name_message("deck variable or run option", request.unknown.name, names);
    if (text.size() > 1000)
      text = fmt::format(
          "there is no deck variable or run option \"{}\". `adore schema` lists the variables.",
          request.unknown.name);
    throw InputError(text);
  }
  const deck::VariableSpec& spec = found.front().spec();
  if (spec.type == deck::VarType::String)
    throw InputError(fmt::format(
        "variable {} cannot be the unknown: its value is text. Choose a numeric variable.",
        request.unknown.name));
  return {false, spec.type == deck::VarType::Integer, runs::variable_unit(request, bare)};
}

void set(std::vector<std::pair<std::string, std::string>>& settings, const std::string& name,
         const std::string& value) {
  std::erase_if(settings, [&](const auto& old) { return old.first == name; });
  settings.emplace_back(name, value);
}

}  // namespace

std::vector<FindResultInfo> find_results() {
  std::vector<FindResultInfo> out;
  for (const results::KeyResultSpec& spec : results::key_result_specs()) {
    if (!is_of_equilibrium(spec.id)) continue;
    std::string meaning(spec.label);
    if (!spec.part.empty()) meaning += fmt::format(", {}", spec.part);
    if (!spec.meaning.empty()) meaning += fmt::format(": {}", spec.meaning);
    out.push_back({std::string(spec.id), unit_of(spec), std::move(meaning)});
  }
  return out;
}

FindReport find_in_deck(const FindRequest& request, std::stop_token stop,
                        const std::function<void(int)>& computed) {
  FindReport out;
  out.source = runs::deck_path(request).string();
  out.unknown = request.unknown;
  out.target = request.target;
  const Variable variable = variable_of(request);
  out.unknown.unit = variable.unit;
  const std::string& id = request.target.name;
  std::vector<std::string> ids;
  for (const FindResultInfo& one : find_results()) ids.push_back(one.id);
  if (std::find(ids.begin(), ids.end(), id) == ids.end())
    throw InputError(unknown_name_message("result of the equilibrium", id, ids));
  out.target.unit = unit_of(results::find_key_result(id));

  const runs::LoadedDeck given = runs::load_deck(request);  // its errors are not those of one point
  std::string idle, lack;
  int count = 0;
  const auto value_at = [&](double x) {
    if (stop.stop_requested()) throw Interrupted("interrupted during the search");
    runs::DeckRequest one = request;
    set(variable.option ? one.options : one.changes, request.unknown.name, runs::value_text(x));
    if (given.deck.has("kStif") && given.deck.integer("kStif") != 0) set(one.changes, "kStif", "0");
    const runs::Prepared prepared = runs::prepare(one, stop);
    if (computed) computed(++count);
    if (idle.empty() && !variable.option) idle = idle_reason(prepared, request.unknown.name);
    if (id == "variable_compliance_m") return runs::variable_compliance(prepared).difference;
    if (id == "variable_compliance_span_m") return runs::variable_compliance(prepared).span;
    const results::KeyResults results = runs::equilibrium_results(prepared);
    const auto found = std::find_if(results.begin(), results.end(),
                                    [&](const results::KeyResult& r) { return r.of.id == id; });
    if (found != results.end()) return found->value;
    lack = lacking(id, results, !prepared.control.dynamic);
    throw InputError(lack);
  };
  FindSettings settings;
  settings.first = request.unknown.first;
  settings.last = request.unknown.last;
  settings.relation = request.target.relation;
  settings.target = request.target.value;
  settings.points = request.points;
  settings.whole = variable.whole;
  try {
    out.outcome = find_values(settings, value_at);
  } catch (const InputError&) {
    if (!lack.empty()) throw InputError(lack);
    throw;
  }
  if (!idle.empty())
    throw InputError(
        fmt::format("variable {} cannot be the unknown: the deck does not use it ({}). Choose "
                    "another variable, or change the deck.",
                    request.unknown.name, idle));
  return out;
}

const std::vector<FindQuestion>& find_questions() {
  static const std::vector<FindQuestion> list{
      {"all-loaded", "smallest thrust that keeps all elements loaded", "", "appLoadX",
       "least_element_load_N", "0", "",
       "adore find DATA.txt --question all-loaded --between 1:5000 --set appLoadZ=2000"},
      {"preload-for-stiffness", "thrust that gives a specified radial stiffness [N/m]", "",
       "appLoadX", "stiffness_z_N_per_m", "", "",
       "adore find DATA.txt --question preload-for-stiffness=1e8 --between 10:5000"},
      {"clearance-for-life",
       "diametral clearance that gives a specified life [hr] (up to two solutions)", "",
       "freeIntCls", "life_lp_hours", "", "freeConAng=0",
       "adore find DATA.txt --question clearance-for-life=20000 --between -2e-5:1e-4"},
      {"pivot-speed", "inner race speed at which a ball starts to pivot gyroscopically [rpm]", "",
       "rpm2", "gyroscopic_ratio", "1", "",
       "adore find DATA.txt --question pivot-speed --between 1000:60000"},
      {"load-for-pressure", "radial load that gives a specified maximum contact pressure [Pa]", "",
       "appLoadZ", "largest_pressure_Pa", "", "",
       "adore find DATA.txt --question load-for-pressure=2e9 --between 10:50000"},
      {"load-for-approach", "radial load that gives a specified maximum elastic approach [m]", "",
       "appLoadZ", "largest_approach_m", "", "",
       "adore find DATA.txt --question load-for-approach=1e-5 --between 10:50000"},
      {"fit-for-clearance", "fit of the inner race that gives a specified operating clearance [m]",
       "", "raceFit2", "operating_clearance_m", "", "",
       "adore find DATA.txt --question fit-for-clearance=5e-6 --between 0:4e-5"},
      {"viscosity-for-kappa",
       "viscosity of the user lubricant (kTrac = 9) that gives a specified viscosity ratio kappa",
       "", "refVis", "viscosity_ratio", "", "",
       "adore find DATA.txt --question viscosity-for-kappa=2 --between 1e-3:1"},
      {"quiet-load",
       "radial load at which the displacement variation from variable compliance changes its sign",
       "", "appLoadZ", "variable_compliance_m", "0", "",
       "adore find DATA.txt --question quiet-load --between 20:2000"},
      {"contact-load-for-approach",
       "load of one contact that gives a specified elastic approach [m]", "hertz", "load", "delta",
       "", "", "adore find --question contact-load-for-approach=1e-5 contact.json --between 1:1e5"},
      {"contact-load-for-pressure",
       "load of one contact that gives a specified maximum pressure [Pa]", "hertz", "load", "p_max",
       "", "", "adore find --question contact-load-for-pressure=2e9 contact.json --between 1:1e5"},
      {"contact-load-for-half-width",
       "load of one contact that gives a specified minor half axis [m]", "hertz", "load", "b", "",
       "", "adore find --question contact-load-for-half-width=1e-4 contact.json --between 1:1e5"},
  };
  return list;
}

ParsedFindQuestion parse_question(std::string_view text) {
  const std::size_t equal = text.find('=');
  const std::string_view name = text.substr(0, std::min(equal, text.size()));
  ParsedFindQuestion out;
  std::vector<std::string> names;
  for (const FindQuestion& one : find_questions()) {
    names.emplace_back(one.name);
    if (one.name == name) out.question = &one;
  }
  if (out.question == nullptr) throw InputError(unknown_name_message("question", name, names));
  const std::string value(equal == std::string_view::npos ? out.question->value
                                                          : text.substr(equal + 1));
  if (value.empty())
    throw InputError(fmt::format("question {} needs a value. Write {}=value, for example {}.", name,
                                 name, out.question->example));
  out.unknown.name = out.question->unknown;
  out.target = parse_target(fmt::format("{}={}", out.question->target, value));
  return out;
}

void add_sets(const FindQuestion& question, runs::DeckRequest& request) {
  if (question.sets.empty()) return;
  const std::size_t equal = question.sets.find('=');
  const std::string name(question.sets.substr(0, equal));
  const bool given = std::any_of(request.sets.begin(), request.sets.end(),
                                 [&](const auto& one) { return one.first == name; });
  const runs::LoadedDeck loaded = runs::load_deck(request);
  // Only balls derive the clearance from the angle.
  if (!given && loaded.deck.integer("kBrg") == 1 && loaded.deck.has(name))
    request.sets.emplace_back(name, question.sets.substr(equal + 1));
}

}  // namespace adore::design
