#include "facade/model_errors.hpp"

#include "base/checksum.hpp"
#include "base/counted.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "facade/chosen_settings.hpp"
#include "facade/measured_run.hpp"
#include "facade/solver_stamp.hpp"
#include "facade/verify.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::facade {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kNearbyLoads = 1e-6;

/// Friction of a curve of record 10 by a factor: its values and slopes, not its slip speeds.
std::vector<std::pair<std::string, std::string>> scaled_curve(const deck::Deck& deck,
                                                              const std::string& type,
                                                              const std::string& stem,
                                                              double factor) {
  std::vector<std::pair<std::string, std::string>> out;
  if (!deck.has(type) || !deck.has(stem + "1")) return out;
  // (A + B u) exp(-C u) + D: A, B and D. The other forms: values and slopes are the first three.
  const bool coefficients = deck.integer(type) == -1;
  for (const char* number : {"1", "2", "3", "4"}) {
    if (*number == (coefficients ? '3' : '4')) continue;
    const std::string name = stem + number;
    const double value = deck.real(name);
    if (value != 0.0) out.emplace_back(name, fmt::format("{:.17g}", factor * value));
  }
  return out;
}

double relative(double a, double b) {
  return std::isfinite(a) && std::isfinite(b) && b != 0.0 ? a / b - 1.0 : kNan;
}

std::string signed_percent(double share) {
  return std::isfinite(share) ? fmt::format("{:+.2g}", 100.0 * share) : std::string("-");
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_of(const Json& json, const char* key) {
  return json.contains(key) && json.at(key).is_number() ? json.at(key).get<double>() : kNan;
}

}  // namespace

std::vector<ModelVariant> model_variants(const Prepared& prepared) {
  std::vector<ModelVariant> out;
  const deck::Deck& deck = prepared.input.deck;
  const auto option = [&](const char* group, const std::string& name, const std::string& value,
                          const char* range) {
    out.push_back({group, fmt::format("{} = {}", name, value), range, {}, {{name, value}}});
  };
  if (prepared.plan.has(scene::Effect::ContactDamping) &&
      prepared.options.system.damping.impact_loss == 0.0) {
    const double factor = prepared.options.system.damping.factor;
    for (const double by : {2.0, 0.5})
      option("damping", "contactDamping", fmt::format("{:g}x", by * factor),
             "factor 2: loss factor of steel contacts 0.005 to 0.02 (from memory)");
  }
  if (prepared.bearing.lubrication && prepared.plan.has(scene::Effect::RaceTraction)) {
    option("traction law", "filmLaw", prepared.options.recommended_law ? "code" : "recommended",
           "the two traction laws of this oil");
  } else {
    for (const double by : {1.3, 1.0 / 1.3})
      if (auto sets = scaled_curve(deck, "kTracType", "reRaceTC", by); !sets.empty())
        out.push_back({"traction law",
                       fmt::format("race friction x {:.2f}", by),
                       "factor 1.3 (estimated)",
                       std::move(sets),
                       {}});
  }
  if (prepared.bearing.cage)
    for (const double by : {1.5, 0.5}) {
      auto sets = scaled_curve(deck, "kCPTracType", "reCageTC", by);
      for (auto& set : scaled_curve(deck, "kCRTracType", "cageRaceTC", by))
        sets.push_back(std::move(set));
      if (!sets.empty())
        out.push_back({"cage friction",
                       fmt::format("pockets and lands x {:g}", by),
                       "50 % (estimated)",
                       std::move(sets),
                       {}});
    }
  if (auto finer = doubled_resolution(prepared); !finer.empty()) {
    std::string name;
    for (const auto& [key, value] : finer)
      name += fmt::format("{}{} = {}", name.empty() ? "" : ", ", key, value);
    out.push_back({prepared.rollers ? "roller slices" : "ellipse nodes",
                   name,
                   "twice as many",
                   {},
                   std::move(finer)});
  }
  for (const int mode : {0, 1, 2})
    if (mode != deck.integer("mode"))
      out.push_back({"mode",
                     fmt::format("mode = {}", mode),
                     "degrees of freedom of elements and races",
                     {{"mode", std::to_string(mode)}},
                     {}});
  if (prepared.bearing.thermal) {
    const bool network = prepared.options.thermal_model == bearing::ThermalModel::Network;
    option("thermal model", "thermalModel", network ? "ladder" : "network",
           "the two thermal models");
  }
  return out;
}

std::string model_stamp(const LoadedDeck& deck) {
  deck::Deck model = deck.deck;
  for (const char* name : {"stpInit", "stpMin", "stpMax", "tol", "fTime"})
    if (model.has(name)) model.set(name, "1");
  for (const char* name :
       {"kPrtFreq", "kPltFreq", "kAGraf", "kLifeFreq", "maxStps", "intMet", "nStps", "kIcOpt"})
    if (model.has(name)) model.set(name, "1");
  std::string text = fmt::format("{}\n{}\n", solver_stamp(), deck::write_deck(model));
  for (const auto& [name, value] : deck.option_values)
    if (name != "ellipseMajor" && name != "ellipseMinor" && name != "rollerSlices" &&
        name != "resultsH5" && name != "checkpointSeconds" && name != "filmPrecision")
      text += fmt::format("{}={}\n", name, value);
  return fmt::format("{:016x}", checksum(text));
}

ModelStudy study_models(const DeckRequest& request, double turns, double budget,
                        const std::function<void(const ModelRow&)>& row_done,
                        std::stop_token stop) {
  RunRequest own;
  static_cast<DeckRequest&>(own) = request;
  const Prepared prepared = prepare(request);
  if (!prepared.control.dynamic)
    throw InputError(
        "model errors need a motion, but this deck is quasi-static (mode < 0); set mode = 0");
  std::vector<ModelVariant> variants = model_variants(prepared);
  if (const auto loads = nearby_loads(prepared.input.deck, kNearbyLoads); !loads.empty())
    variants.insert(variants.begin(), {"scatter",
                                       "loads x 1.000001",
                                       "not an uncertainty: scatter of an irregular motion",
                                       loads,
                                       {}});
  if (prepared.control.start != setup::StartState::Statics) own.changes.emplace_back("kIcOpt", "0");
  own.options.emplace_back("resultsH5", "0");
  ModelStudy study;
  study.stamp = model_stamp(prepared.input);
  study.deck = prepared.input.path.filename().string();
  const double speed = std::abs(prepared.bearing.speed[1] - prepared.bearing.speed[0]);
  const double turn = speed > 0.0 ? 2.0 * std::numbers::pi / speed
                                  : prepared.control.end_time * make_system(prepared).scales().time;
  study.turns = speed > 0.0 ? std::min(turns, asked_turns(own)) : 1.0;
  // Finer and smoother models take two to four times the time of the deck's own run.
  const double each = budget / (2.0 * static_cast<double>(variants.size() + 1));
  MeasuredRun base;
  while (true) {
    own.until = fmt::format("{:.17g}s", study.turns * turn);
    base = measured_run(own, each, stop);
    study.seconds += base.seconds;
    if (!base.cut) break;
    study.turns *= std::clamp(0.8 * base.outcome.time / (study.turns * turn), 0.02, 0.8);
  }
  if (base.outcome.status != RunStatus::Done && base.outcome.status != RunStatus::Untrusted)
    throw SolverError("the run with the deck's own settings ends with: " + base.outcome.message);
  const results::KeyResults& is = base.outcome.summary;
  study.heat = value_of(is, "mean_power_loss_W");
  study.life = value_of(is, "run_life_hours");
  for (ModelVariant& variant : variants) {
    ModelRow row;
    RunRequest run = own;
    for (const auto& set : variant.sets) run.changes.push_back(set);
    for (const auto& one : variant.options) run.options.push_back(one);
    row.variant = std::move(variant);
    try {
      const MeasuredRun one = measured_run(run, std::max(each, budget - study.seconds), stop);
      row.seconds = one.seconds;
      study.seconds += one.seconds;
      if (one.cut)
        row.failure = fmt::format("stopped after {:.3g} s (time limit)", one.seconds);
      else if (one.outcome.status == RunStatus::Failed)
        row.failure = one.outcome.message;
      else {
        row.change = compare_results(one.outcome.summary, is);
        row.heat = relative(value_of(one.outcome.summary, "mean_power_loss_W"), study.heat);
        row.life = relative(value_of(one.outcome.summary, "run_life_hours"), study.life);
      }
    } catch (const InputError& error) {
      row.failure = error.what();
    } catch (const SolverError& error) {
      row.failure = error.what();
    }
    study.rows.push_back(std::move(row));
    if (row_done) row_done(study.rows.back());
  }
  study.complete = true;
  return study;
}

std::string model_table(const ModelStudy& study) {
  std::string out = fmt::format(
      "Model errors of {}: change of the results in percent for one changed model choice at a "
      "time, over {}.\n{:<15}{:<42}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n",
      study.deck, counted(fmt::format("{:.3g}", study.turns), "revolution"), "choice", "", "speeds",
      "whirl", "loads", "peak", "heat", "life");
  const auto size = [](double share) {
    return share < 0.0 ? std::string("-") : fmt::format("{:.2g}", 100.0 * share);
  };
  std::vector<std::pair<std::string, std::string>> ranges;
  for (const ModelRow& row : study.rows) {
    const std::pair range(row.variant.group, row.variant.range);
    if (std::find(ranges.begin(), ranges.end(), range) == ranges.end()) ranges.push_back(range);
    const std::string head = fmt::format("{:<15}{:<42}", row.variant.group, row.variant.name);
    if (!row.failure.empty()) {
      constexpr std::size_t kRoom = 60;
      out += head + " no result: " + row.failure.substr(0, kRoom) + "\n";
      continue;
    }
    out += fmt::format("{}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", head, size(row.change.speed),
                       size(row.change.whirl), size(row.change.load), size(row.change.peak),
                       signed_percent(row.heat), signed_percent(row.life));
  }
  out += "Assumed ranges\n";
  for (const auto& [group, range] : ranges) out += fmt::format("{:<15}{}\n", group, range);
  return out;
}

std::string model_json(const ModelStudy& study) {
  Json out{{"program", "adore"},           {"study", "models"},
           {"stamp", study.stamp},         {"deck", study.deck},
           {"turns", study.turns},         {"processor_s", study.seconds},
           {"heat_W", number(study.heat)}, {"life_h", number(study.life)},
           {"complete", study.complete}};
  out["rows"] = Json::array();
  for (const ModelRow& row : study.rows) {
    Json one{{"group", row.variant.group},     {"name", row.variant.name},
             {"range", row.variant.range},     {"sets", row.variant.sets},
             {"options", row.variant.options}, {"processor_s", row.seconds}};
    if (!row.failure.empty()) {
      one["failure"] = row.failure;
    } else {
      one["change"] = Json::object();
      for (const AccuracyQuantity& q : kAccuracyQuantities)
        one["change"][q.key] = row.change.*q.member;
      one["heat"] = number(row.heat);
      one["life"] = number(row.life);
    }
    out["rows"].push_back(std::move(one));
  }
  return dump_json(out, 2) + "\n";
}

ModelStudy read_models(const std::string& text, const std::string& name) {
  const Json json = parse_json<Json>(text, name);
  try {
    if (json.at("study") != "models") throw InputError(name + " is not a study of model errors");
    ModelStudy out;
    out.stamp = json.at("stamp").get<std::string>();
    out.deck = json.at("deck").get<std::string>();
    out.turns = json.at("turns").get<double>();
    out.seconds = json.at("processor_s").get<double>();
    out.heat = number_of(json, "heat_W");
    out.life = number_of(json, "life_h");
    out.complete = json.at("complete").get<bool>();
    for (const Json& one : json.at("rows")) {
      ModelRow row;
      row.variant.group = one.at("group").get<std::string>();
      row.variant.name = one.at("name").get<std::string>();
      row.variant.range = one.at("range").get<std::string>();
      row.variant.sets = one.at("sets").get<decltype(row.variant.sets)>();
      row.variant.options = one.at("options").get<decltype(row.variant.options)>();
      row.seconds = one.at("processor_s").get<double>();
      row.failure = one.value("failure", "");
      if (row.failure.empty())
        for (const AccuracyQuantity& q : kAccuracyQuantities)
          row.change.*q.member = one.at("change").value(q.key, -1.0);
      row.heat = number_of(one, "heat");
      row.life = number_of(one, "life");
      out.rows.push_back(std::move(row));
    }
    return out;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(name + " is not a study of model errors: " + error.what());
  }
}

std::optional<ModelStudy> models_beside(const LoadedDeck& deck) {
  const std::filesystem::path file = deck.path.parent_path() / kModelFile;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  try {
    ModelStudy study = read_models(read_text_file(file), file.string());
    if (study.complete && study.stamp == model_stamp(deck)) return study;
  } catch (const InputError&) {  // of somebody else
  }
  return {};
}

}  // namespace adore::facade
