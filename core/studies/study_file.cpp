#include "base/errors.hpp"
#include "base/input_limits.hpp"
#include "base/json_text.hpp"
#include "base/resources.hpp"
#include "base/spelling.hpp"
#include "deck/schema.hpp"
#include "results/channels.hpp"
#include "results/key_results.hpp"
#include "setup/run_control.hpp"
#include "studies/cage_whirl.hpp"
#include "studies/study.hpp"
#include "studies/study_check.hpp"
#include "studies/study_json.hpp"
#include "studies/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace adore::studies {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, kKinds> kKindNames{"sweep",       "tolerance",  "cage-map",
                                                     "sensitivity", "worst-case", "what-if"};
constexpr std::array<std::pair<const char*, Statistic>, 9> kStatistics{
    {{"mean", Statistic::Mean},
     {"rms", Statistic::Rms},
     {"deviation", Statistic::Deviation},
     {"least", Statistic::Least},
     {"largest", Statistic::Largest},
     {"largest_size", Statistic::LargestSize},
     {"span", Statistic::Span},
     {"last", Statistic::Last},
     {"percentile", Statistic::Percentile}}};

template <class Names>
std::string listed(const Names& names) {
  std::string out;
  for (const auto& name : names) out += fmt::format("{}{}", out.empty() ? "" : ", ", name);
  return out;
}

std::string kinds() { return listed(kKindNames); }

std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  const auto best = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return edit_distance(a, name) < edit_distance(b, name);
  });
  return best == known.end() ? std::string() : *best;
}

std::string value_of(const Json& json, JsonObject& object, std::string_view key) {
  if (json.is_string()) return json.get<std::string>();
  if (json.is_number() || json.is_boolean()) return dump_json(json);
  object.refuse(key,
                "an object of names and values (numbers or strings), e.g. {\"appLoadX\": 500}");
}

Settings read_settings(JsonObject& object, std::string_view key) {
  const Json& json = object.get(key, "an object of names and values");
  if (!json.is_object()) object.refuse(key, "an object of names and values, e.g. {\"mode\": -1}");
  Settings out;
  for (const auto& [name, value] : json.items())
    if (!name.starts_with("//")) out.emplace_back(name, value_of(value, object, key));
  return out;
}

void check_name(JsonObject& object, std::string_view key, std::string name, bool option) {
  std::vector<std::string> known;
  if (option) {
    for (const setup::OptionInfo& info : setup::run_option_list()) known.push_back(info.name);
  } else {
    for (const deck::RecordSpec& record : deck::schema())
      for (const deck::VariableSpec& spec : record.variables) known.emplace_back(spec.name);
  }
  name = name.substr(0, name.find('['));
  if (const auto lot = name.find('#'); lot != std::string::npos) name.replace(lot, 1, "1");
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  object.refuse(key,
                fmt::format("a {}; the most similar name is \"{}\"",
                            option ? "run option (`adore run --list-options` lists the options)"
                                   : "variable of the deck (`adore schema` lists the variables)",
                            nearest(name, known)));
}

void read_law(JsonObject& object, Variable& out) {
  int laws = 0;
  if (object.has("grid")) {
    ++laws;
    const char* valid = "[first, last, count] with a count from 2 to 100000";
    const auto grid = object.numbers("grid", 3, 3, valid);
    if (grid[2] != std::floor(grid[2]) || grid[2] < 2.0 || grid[2] > 100000.0)
      object.refuse("grid", valid);
    const auto count = static_cast<long>(grid[2]);
    for (long k = 0; k < count; ++k)
      out.values.push_back(grid[0] + (grid[1] - grid[0]) * static_cast<double>(k) /
                                         static_cast<double>(count - 1));
  }
  if (object.has("list")) {
    ++laws;
    out.values = object.numbers("list", 1, 100000, "a list of numbers, e.g. [0.5, 1, 2]");
  }
  if (object.has("uniform")) {
    ++laws;
    const auto range = object.numbers("uniform", 2, 2, "[low, high]");
    if (!(range[0] < range[1])) object.refuse("uniform", "[low, high] with low smaller than high");
    out.law = Law::Uniform;
    out.a = range[0];
    out.b = range[1];
  }
  if (object.has("normal")) {
    ++laws;
    const auto normal = object.numbers("normal", 2, 2, "[mean, standard deviation]");
    if (!(normal[1] > 0.0))
      object.refuse("normal", "[mean, standard deviation] with a standard deviation above 0");
    out.law = Law::Normal;
    out.a = normal[0];
    out.b = normal[1];
    if (object.has("within")) {
      const auto cut = object.numbers(
          "within", 2, 2, "[low, high], the limits of the truncated normal distribution");
      // A cut far from the mean leaves no digits of the normal distribution.
      constexpr double kMaxDeviations = 6.0;
      if (!(cut[0] < cut[1]) || cut[0] > out.a + kMaxDeviations * out.b ||
          cut[1] < out.a - kMaxDeviations * out.b)
        object.refuse("within",
                      "[low, high] with low smaller than high; part of the interval must be within "
                      "6 standard deviations of the mean");
      out.low = cut[0];
      out.high = cut[1];
    }
  }
  if (laws != 1)
    throw InputError(fmt::format(
        "{}: give exactly one of \"grid\", \"list\", \"uniform\" and \"normal\" (given: {})",
        object.at(out.option ? "option" : "name"), laws));
}

Variable read_variable(const Json& json, const std::string& where, Kind kind) {
  JsonObject object(json, where);
  Variable out;
  out.option = object.has("option");
  if (out.option && object.has("name"))
    object.refuse("option",
                  "either \"name\" (a deck variable) or \"option\" (a run option), not both");
  out.name = out.option ? object.text("option", "the name of a run option")
                        : object.text("name", "the name of a deck variable, e.g. \"appLoadX\"");
  check_name(object, out.option ? "option" : "name", out.name, out.option);
  if (object.has("also")) {
    if (out.option || out.is_group())
      object.refuse("also",
                    "a single deck variable in \"name\"; \"also\" is not possible for a run option "
                    "or a name with #");
    out.also = object.texts("also", "a list of deck variables that take the same value");
    for (const std::string& name : out.also) check_name(object, "also", name, false);
  }
  if (kind == Kind::Sensitivity) {
    if (object.has("step")) {
      out.step = object.number("step", "a step above 0, in the units of the deck");
      if (!(out.step > 0.0)) object.refuse("step", "a step above 0, in the units of the deck");
    }
    out.targets = {out.name};
    object.reject_unknown_keys();
    return out;
  }
  read_law(object, out);
  if (object.has("common")) {
    if (!out.is_group())
      object.refuse("common",
                    "a \"name\" with # in place of the element number; \"common\" is possible only "
                    "for such a group of elements");
    out.common = object.number("common", "a correlation from 0 to 1");
    if (out.common < 0.0 || out.common > 1.0)
      object.refuse("common", "a correlation from 0 to 1 between the elements of the group");
  }
  if (out.is_group() && out.law == Law::Values)
    object.refuse("name",
                  "a name without #, or replace \"grid\" or \"list\" by \"uniform\" or \"normal\" "
                  "(a name with # needs a random value for each element)");
  out.targets = {out.name};
  object.reject_unknown_keys();
  return out;
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> out;
  for (const results::KeyResultSpec& spec : results::key_result_specs()) out.emplace_back(spec.id);
  for (const std::string_view figure : kWhirlFigures) out.emplace_back(figure);
  return out;
}

Quantity named_quantity(const std::string& name, const std::string& where) {
  Quantity out;
  out.name = name;
  const auto names = quantity_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InputError(fmt::format(
        "{} = \"{}\": this key result is unknown; the most similar name is \"{}\" (\"summary\" "
        "in RUN.json lists the key results of a run). For a statistic of a channel, "
        "give an object with \"channel\" and \"statistic\"",
        where, name, nearest(name, names)));
  if (const auto spec = results::find_key_result(name); !spec.id.empty()) out.unit = spec.unit->si;
  return out;
}

Statistic read_statistic(JsonObject& object) {
  std::string names;
  for (const auto& [name, statistic] : kStatistics)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  const std::string text = object.text("statistic", "one of " + names);
  for (const auto& [name, statistic] : kStatistics)
    if (text == name) return statistic;
  object.refuse("statistic", "one of " + names);
}

Quantity read_quantity(const Json& json, const std::string& where) {
  if (json.is_string()) return named_quantity(json.get<std::string>(), where);
  JsonObject object(json, where);
  if (object.has("result")) {
    Quantity out =
        named_quantity(object.text("result", "the name of a key result"), object.at("result"));
    object.reject_unknown_keys();
    return out;
  }
  Quantity out;
  out.channel = object.text("channel", "a channel of RESULTS.h5, e.g. \"contact.load\"");
  std::vector<std::string> known;
  for (const results::Channel& channel : results::channels()) {
    known.emplace_back(channel.id);
    if (channel.id == out.channel) out.unit = channel.unit->si;
  }
  // Items of the energy ledger are channels too, and differ from deck to deck.
  if (std::find(known.begin(), known.end(), out.channel) == known.end() &&
      !out.channel.starts_with("energy."))
    object.refuse("channel", fmt::format("a channel of RESULTS.h5 (`adore show RESULTS.h5` lists "
                                         "the channels); the most similar name is \"{}\"",
                                         nearest(out.channel, known)));
  out.statistic = read_statistic(object);
  if (out.statistic == Statistic::Percentile) {
    out.percent = object.number("percent", "a number from 0 to 100");
    if (out.percent < 0.0 || out.percent > 100.0)
      object.refuse("percent", "a number from 0 to 100");
  }
  if (object.has("window")) {
    const char* valid = "[from, to], fractions of the run time from 0 to 1";
    const auto window = object.numbers("window", 2, 2, valid);
    if (window[0] < 0.0 || window[1] > 1.0 || !(window[0] < window[1]))
      object.refuse("window", valid);
    out.from = window[0];
    out.to = window[1];
  }
  if (object.has("at"))
    for (const double place : object.numbers("at", 1, 4, "[element, race ...], counted from 1")) {
      if (place < 1.0 || place != std::floor(place) || place > 1e6)
        object.refuse("at", "[element, race ...], counted from 1");
      out.places.push_back(static_cast<std::size_t>(place));
    }
  out.name = object.has("name") ? object.text("name", "a heading for the column")
                                : out.channel + "." + object.text("statistic", "");
  if (out.name.find_first_of(",\"\n/") != std::string::npos || out.name.empty())
    object.refuse("name", "a column heading without commas, quotes and slashes");
  object.reject_unknown_keys();
  return out;
}

void read_sampling(const Json& json, const std::string& where, Study& out) {
  JsonObject object(json, where);
  if (object.has("method")) {
    const std::string method = object.text("method", "latin, sobol or random");
    if (method == "latin")
      out.sampling = Sampling::Latin;
    else if (method == "sobol")
      out.sampling = Sampling::Sobol;
    else if (method == "random")
      out.sampling = Sampling::Random;
    else
      object.refuse("method", "latin, sobol or random");
  }
  if (object.has("runs"))
    out.samples = object.whole("runs", 1, kMaxStudyRuns, "a whole number from 1 to 10000000");
  if (object.has("seed"))
    out.seed = static_cast<std::uint64_t>(
        object.whole("seed", 0, 1L << 53, "a whole number from 0 to 2^53"));
  object.reject_unknown_keys();
}

void read_correlations(const Json& json, const std::string& where, Study& out) {
  if (!json.is_array())
    throw InputError(where +
                     ": give a list of entries [\"variable 1\", \"variable 2\", correlation]");
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Json& row = json[i];
    const std::string at = fmt::format("{}[{}]", where, i + 1);
    if (!row.is_array() || row.size() != 3 || !row[0].is_string() || !row[1].is_string() ||
        !row[2].is_number())
      throw InputError(at + " = " + dump_json(row) + ": give [\"first\", \"second\", correlation]");
    Correlation next{row[0].get<std::string>(), row[1].get<std::string>(), row[2].get<double>()};
    for (const std::string& name : {next.first, next.second}) {
      const auto found =
          std::find_if(out.variables.begin(), out.variables.end(),
                       [&](const Variable& variable) { return variable.name == name; });
      if (found == out.variables.end() || found->law == Law::Values || found->is_group())
        throw InputError(
            fmt::format("{}: \"{}\" is not a variable with a uniform or normal distribution (for a "
                        "name with #, use \"common\" to correlate the elements)",
                        at, name));
    }
    if (!(std::abs(next.value) <= 1.0) || next.first == next.second)
      throw InputError(at + " = " + dump_json(row) +
                       ": give two different variables and a number from -1 to 1");
    out.correlations.push_back(std::move(next));
  }
}

void read_cases(const Json& json, const std::string& where, Study& out) {
  if (!json.is_array() || json.empty())
    throw InputError(where + ": give a list of {\"name\": ..., \"set\": {...}}");
  std::set<std::string> names{"as it is"};
  for (std::size_t i = 0; i < json.size(); ++i) {
    JsonObject object(json[i], fmt::format("{}[{}]", where, i + 1));
    WhatIfCase next;
    next.name = object.text("name", "the name of the case in the report");
    if (!names.insert(next.name).second) object.refuse("name", "a name that no other case has");
    if (object.has("set")) next.sets = read_settings(object, "set");
    if (object.has("options")) next.options = read_settings(object, "options");
    if (next.sets.empty() && next.options.empty())
      object.refuse("set", "the variables that the case changes, e.g. {\"kGsHydro\": 0}");
    object.reject_unknown_keys();
    out.cases.push_back(std::move(next));
  }
}

void read_budget(const Json& json, const std::string& where, Study& out) {
  JsonObject object(json, where);
  const auto positive = [&](const char* key, std::optional<double>& value) {
    if (!object.has(key)) return;
    value = object.number(key, "a number above 0");
    if (!(*value > 0.0)) object.refuse(key, "a number above 0");
  };
  positive("runs", out.budget.runs);
  positive("hours", out.budget.hours);
  positive("disk_megabytes", out.budget.disk_megabytes);
  object.reject_unknown_keys();
}

/// Keys that fit no kind, or not this one.
void check_kind(const Study& study, const std::string& name) {
  const auto refuse = [&](const std::string& text) { throw InputError(name + ": " + text); };
  const auto random = [](const Variable& v) { return v.law != Law::Values; };
  const auto count = std::count_if(study.variables.begin(), study.variables.end(), random);
  const auto values = static_cast<long>(study.variables.size()) - count;
  if (!study.bearing_seeds.empty() &&
      (study.kind == Kind::WhatIf || study.kind == Kind::Sensitivity ||
       study.kind == Kind::WorstCase))
    refuse(fmt::format(
        "bearing_seeds has no effect in a study of kind \"{}\"; remove it, or use kind \"sweep\"",
        kind_name(study.kind)));
  if (study.kind == Kind::WorstCase && study.decks.size() > 1)
    refuse(
        "a worst-case search uses one deck; replace \"decks\" by \"deck\", and write a separate "
        "study for each deck");
  std::set<std::string> names;
  for (const Variable& variable : study.variables)
    if (!names.insert(variable.name).second)
      refuse(
          fmt::format("variables: {} occurs twice; remove one of the two entries", variable.name));
  for (const Variable& variable : study.variables)
    for (const auto& [set, value] : variable.option ? study.options : study.sets)
      if (set == variable.name)
        refuse(fmt::format(
            "{} is set to {} and is also in \"variables\"; remove one of the two entries", set,
            value));
  if (study.kind == Kind::WhatIf) {
    if (!study.variables.empty())
      refuse(
          "a what-if study compares \"cases\"; remove \"variables\", or use a study of kind "
          "\"sweep\"");
    return;
  }
  if (study.variables.empty() && study.bearing_seeds.size() < 2)
    refuse("variables = []: give at least one {\"name\": ..., \"grid\": [first, last, count]}");
  if (study.kind == Kind::CageMap && (values != 2 || count != 0))
    refuse(
        fmt::format("a cage-map needs two variables with \"grid\" or \"list\" (speed and "
                    "clearance), but this study has {} such variables and {} random variables",
                    values, count));
  if (study.kind == Kind::Tolerance && count == 0)
    refuse(
        "a tolerance study needs at least one variable with a \"uniform\" or \"normal\" "
        "distribution");
  if (study.kind == Kind::WorstCase) {
    if (values != 0)
      refuse("a worst-case search needs a range for each variable: give \"uniform\": [low, high]");
    for (const Variable& variable : study.variables)
      if (variable.law != Law::Uniform)
        refuse(fmt::format(
            "variable {}: a worst-case search needs limits; give \"uniform\": [low, high]",
            variable.name));
    if (!study.correlations.empty())
      refuse("correlation: this key has no effect in a worst-case search; remove it");
  }
  if (study.has_random_variables() && study.samples == 0)
    refuse(
        "sampling.runs is missing: give the number of samples of the variables with a \"uniform\" "
        "or \"normal\" distribution");
  if (!study.has_random_variables() && study.samples > 0 && study.kind != Kind::Sensitivity)
    refuse(
        "sampling.runs has no effect, because no variable has a \"uniform\" or \"normal\" "
        "distribution");
}

}  // namespace

std::string kind_name(Kind kind) { return kKindNames.at(static_cast<std::size_t>(kind)); }

bool Study::has_random_variables() const {
  if (kind == Kind::Sensitivity) return false;
  return std::any_of(variables.begin(), variables.end(),
                     [](const Variable& v) { return v.law != Law::Values; });
}

std::filesystem::path Study::folder() const {
  std::filesystem::path out = file;
  return out.replace_extension(".study");
}

namespace {

/// Each variable and quantity is a column of the table.
void require_columns(std::size_t count, const JsonObject& object, std::string_view key) {
  if (count > kMaxTableColumns)
    throw InputError(fmt::format("{}: {} entries, but at most {} are allowed; use fewer entries",
                                 object.at(key), count, kMaxTableColumns));
}

Study checked_study(const Json& json, const std::filesystem::path& file) {
  const std::string name = file.string();
  Study out;
  out.file = file;
  JsonObject object(json, name + ":");
  (void)object.whole("adore_study", 1, 1, "1, the version of the study format");
  const std::string kind = object.text("kind", "one of " + kinds());
  const auto* const found = std::find(kKindNames.begin(), kKindNames.end(), kind);
  if (found == kKindNames.end())
    object.refuse("kind", fmt::format("one of {}; the most similar name is \"{}\"", kinds(),
                                      nearest(kind, {kKindNames.begin(), kKindNames.end()})));
  out.kind = static_cast<Kind>(found - kKindNames.begin());
  const auto path_of = [&](const std::string& deck) {
    const std::filesystem::path path(deck);
    return path.is_absolute() ? path : file.parent_path() / path;
  };
  if (object.has("decks")) {
    for (const std::string& deck : object.texts("decks", "a list of deck files"))
      out.decks.push_back(path_of(deck));
    if (out.decks.empty() || object.has("deck"))
      object.refuse("decks", "one or more deck files in \"decks\", without the key \"deck\"");
  } else {
    out.decks = {path_of(
        object.text("deck", "the base deck, a path relative to the folder of the study file"))};
  }
  if (object.has("set")) out.sets = read_settings(object, "set");
  if (object.has("options")) out.options = read_settings(object, "options");
  if (object.has("until"))
    out.until = object.text(
        "until", "the length of each run: \"5rev\", \"0.02s\" or \"1000\" (dimensionless time)");
  if (object.has("integrator"))
    out.integrator = object.text("integrator", "a name that `adore run --integrator` accepts");
  if (object.has("tolerance")) {
    out.tolerance = object.number("tolerance", "a local error limit between 0 and 1");
    if (!(*out.tolerance > 0.0 && *out.tolerance < 1.0))
      object.refuse("tolerance", "a local error limit between 0 and 1");
  }
  if (object.has("variables") || out.kind != Kind::WhatIf) {
    const Json& list = object.get("variables", "a list of variables");
    if (!list.is_array()) object.refuse("variables", "a list of {\"name\": ..., \"grid\": ...}");
    require_columns(list.size(), object, "variables");
    double combinations = 1.0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      out.variables.push_back(
          read_variable(list[i], fmt::format("{}[{}]", object.at("variables"), i + 1), out.kind));
      // Checked here: the values of the next variable may not fit in the memory.
      combinations *=
          static_cast<double>(std::max<std::size_t>(1, out.variables.back().values.size()));
      if (combinations > static_cast<double>(kMaxStudyRuns))
        throw InputError(
            fmt::format("{}: the values of the variables have {:.3g} combinations, more than the "
                        "limit of {}; use fewer values",
                        object.at("variables"), combinations, kMaxStudyRuns));
    }
  }
  if (object.has("correlation"))
    read_correlations(object.get("correlation", ""), object.at("correlation"), out);
  if (object.has("sampling")) read_sampling(object.get("sampling", ""), object.at("sampling"), out);
  if (object.has("bearing_seeds"))
    for (const double seed :
         object.numbers("bearing_seeds", 1, 100000, "a list of whole numbers from 0")) {
      if (seed < 0.0 || seed != std::floor(seed) || seed > 9e15)
        object.refuse("bearing_seeds", "a list of whole numbers from 0 to 9e15");
      out.bearing_seeds.push_back(static_cast<std::uint64_t>(seed));
    }
  const Json& quantities = object.has("quantities") || out.kind != Kind::CageMap
                               ? object.get("quantities", "a list of key results and statistics")
                               : Json::array();
  if (!quantities.is_array())
    object.refuse("quantities",
                  "a list with entries such as \"largest_contact_load_N\" or {\"channel\": ...}");
  require_columns(quantities.size(), object, "quantities");
  for (std::size_t i = 0; i < quantities.size(); ++i)
    out.quantities.push_back(
        read_quantity(quantities[i], fmt::format("{}[{}]", object.at("quantities"), i + 1)));
  if (out.kind == Kind::CageMap)
    for (const std::string_view figure : kWhirlFigures)
      if (std::none_of(out.quantities.begin(), out.quantities.end(),
                       [&](const Quantity& q) { return q.name == figure; }))
        out.quantities.push_back(named_quantity(std::string(figure), name));
  if (out.quantities.empty())
    object.refuse("quantities", "at least one key result or statistic of a channel");
  std::set<std::string> columns;
  for (const Quantity& quantity : out.quantities)
    if (!columns.insert(quantity.name).second)
      throw InputError(fmt::format(
          "{}: two columns have the name \"{}\"; set a different \"name\" for one of them",
          object.at("quantities"), quantity.name));
  if (object.has("percentiles")) {
    out.percentiles =
        object.numbers("percentiles", 1, 99, "numbers between 0 and 100 in ascending order");
    for (std::size_t i = 0; i < out.percentiles.size(); ++i)
      if (out.percentiles[i] <= 0.0 || out.percentiles[i] >= 100.0 ||
          (i > 0 && out.percentiles[i] <= out.percentiles[i - 1]))
        object.refuse("percentiles",
                      "numbers between 0 and 100 in ascending order, e.g. [5, 50, 95]");
  }
  if (out.kind == Kind::WhatIf)
    read_cases(object.get("cases", "a list of {\"name\": ..., \"set\": {...}}"), object.at("cases"),
               out);
  if (out.kind == Kind::WorstCase) {
    JsonObject objective(object.get("objective", "{\"quantity\": ..., \"seek\": \"largest\"}"),
                         object.at("objective"));
    out.objective = objective.text("quantity", "the name of one of the quantities");
    if (!columns.contains(out.objective))
      objective.refuse("quantity",
                       "the name of one of the quantities of this study: " + listed(columns));
    const std::string seek = objective.text("seek", "largest or smallest");
    if (seek != "largest" && seek != "smallest") objective.refuse("seek", "largest or smallest");
    out.seek_largest = seek == "largest";
    if (objective.has("rounds"))
      out.rounds =
          static_cast<int>(objective.whole("rounds", 1, 100, "a whole number from 1 to 100"));
    objective.reject_unknown_keys();
  }
  if (object.has("keep_files")) out.keep_files = object.boolean("keep_files");
  if (object.has("budget")) read_budget(object.get("budget", ""), object.at("budget"), out);
  object.reject_unknown_keys();
  check_kind(out, name);
  return out;
}

/// "a.toml: variables[2].normal = ..." gets the line of its key, or of what holds it.
std::string with_line(const std::string& sentence, const std::string& file,
                      const std::map<std::string, int>& lines) {
  for (std::string key = key_in_message(sentence, file); !key.empty();) {
    if (const auto found = lines.find(key); found != lines.end())
      return fmt::format("{}, line {}{}", file, found->second, sentence.substr(file.size()));
    const std::size_t end = key.find_last_of(".[");
    key = end == std::string::npos ? std::string() : key.substr(0, end);
  }
  return sentence;
}

}  // namespace

Study parse_study(const std::string& text, const std::filesystem::path& file) {
  const StudyText read = read_study_text(text, file);
  try {
    return checked_study(read.json, file);
  } catch (const InputError& error) {
    if (read.lines.empty()) throw;
    throw InputError(with_line(error.what(), file.string(), read.lines));
  }
}

std::string example_study(const std::string& kind) {
  const auto* const found = std::find(kKindNames.begin(), kKindNames.end(), kind);
  if (found == kKindNames.end())
    throw InputError(fmt::format("there is no study kind \"{}\"; give one of {}", kind, kinds()));
  return std::string(resources::get("studies/" + kind + ".json"));
}

void expand_lots(Study& study, int elements) {
  for (Variable& variable : study.variables) {
    if (!variable.is_group()) continue;
    variable.targets.clear();
    for (int k = 1; k <= elements; ++k) {
      std::string name = variable.name;
      name.replace(name.find('#'), 1, std::to_string(k));
      variable.targets.push_back(std::move(name));
    }
  }
}

}  // namespace adore::studies
