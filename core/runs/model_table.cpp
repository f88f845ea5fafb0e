#include "runs/model_table.hpp"

#include "base/checksum.hpp"
#include "base/constants.hpp"
#include "base/counted.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "runs/solver_stamp.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace adore::runs {
namespace {

using Json = nlohmann::ordered_json;

std::string signed_percent(double share) {
  return std::isfinite(share) ? fmt::format("{:+.2g}", 100.0 * share) : std::string("-");
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_of(const Json& json, const char* key) {
  return json.contains(key) && json.at(key).is_number() ? json.at(key).get<double>() : kNaN;
}

}  // namespace

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

std::string model_table(const ModelStudy& study) {
  std::string out = fmt::format(
      "Model errors of {}: change of each result in percent after one model choice is changed, "
      "computed over {}.\n{:<15}{:<42}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n",
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
      constexpr std::size_t kMaxFailureLength = 60;
      out += head + " no result: " + row.failure.substr(0, kMaxFailureLength) + "\n";
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
      for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
        one["change"][q.key] = row.change.*q.member;
      one["heat"] = number(row.heat);
      one["life"] = number(row.life);
    }
    out["rows"].push_back(std::move(one));
  }
  return dump_json(out, 2) + "\n";
}

ModelStudy read_model_study(const std::string& text, const std::string& name) {
  const Json json = parse_json<Json>(text, name);
  try {
    if (json.at("study") != "models")
      throw InputError(name + " does not contain a study of model errors");
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
        for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
          row.change.*q.member = one.at("change").value(q.key, -1.0);
      row.heat = number_of(one, "heat");
      row.life = number_of(one, "life");
      out.rows.push_back(std::move(row));
    }
    return out;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(name + " does not contain a study of model errors: " + error.what());
  }
}

std::optional<ModelStudy> find_model_study(const LoadedDeck& deck) {
  const std::filesystem::path file = deck.path.parent_path() / kModelFile;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  try {
    ModelStudy study = read_model_study(read_text_file(file), file.string());
    if (study.complete && study.stamp == model_stamp(deck)) return study;
  } catch (const InputError&) {  // of somebody else
  }
  return {};
}

}  // namespace adore::runs
