#include "base/counted.hpp"
#include "base/duration.hpp"
#include "base/json_text.hpp"
#include "integrators/stepper.hpp"
#include "results/energy_judgement.hpp"
#include "studies/accuracy_judgement.hpp"
#include "studies/verify.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::studies {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double error) {
  return error < 0.0 ? "not computed" : fmt::format("{:.2g} %", 100.0 * error);
}

std::string short_percent(double error) {
  return error < 0.0 ? "-" : fmt::format("{:.2g}", 100.0 * error);
}

std::string table_of(const std::vector<AccuracyRow>& rows) {
  std::size_t width = 24;
  for (const AccuracyRow& row : rows) width = std::max(width, row.setting.name.size() + 2);
  std::string out = fmt::format(
      "  {:<{}}{:>10}{:>9}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>11}{:>7}{:>10}\n", "", width, "s",
      "error %", "speed", "whirl", "load", "peak", "heat", "life", "steps/rev", "order", "energy");
  for (const AccuracyRow& row : rows) {
    const std::string mark = row.front ? "* " : "  ";
    if (!row.failure.empty()) {
      constexpr std::size_t kMaxFailureLength = 90;
      out += fmt::format("{}{:<{}}{}\n", mark, row.setting.name, width,
                         row.failure.size() > kMaxFailureLength
                             ? row.failure.substr(0, kMaxFailureLength) + " ..."
                             : row.failure);
      continue;
    }
    std::string errors;
    for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
      errors += fmt::format("{:>8}", short_percent(row.errors.*q.member));
    out += fmt::format("{}{:<{}}{:>10.3g}{:>9}{}{:>11.0f}{:>7}{:>10.1e}{}{}\n", mark,
                       row.setting.name, width, row.seconds, short_percent(row.errors.largest()),
                       errors, static_cast<double>(row.steps) / row.turns,
                       row.order > 0.0 ? fmt::format("{:.1f}", row.order) : "-", row.energy_share,
                       row.at_longest > kAtLongest ? "  mostly at the longest step" : "",
                       row.setting.own ? "  (settings of the deck)" : "");
  }
  return out;
}

Json json_of(const results::AccuracyErrors& e) {
  Json out = Json::object();
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities) out[q.key] = e.*q.member;
  return out;
}

Json json_of(const AccuracyRow& row) {
  Json out{{"name", row.setting.name},
           {"method", row.setting.method},
           {"curve", row.setting.method + (row.setting.as_long_as_stable ? ", stable" : "")},
           {"tol", row.setting.tolerance},
           {"as_long_as_stable", row.setting.as_long_as_stable},
           {"own", row.setting.own},
           {"turns", row.turns}};
  if (!row.failure.empty()) out["failure"] = row.failure;
  out["seconds"] = row.seconds;
  out["error"] = row.errors.largest();
  out["errors"] = json_of(row.errors);
  out["steps"] = row.steps;
  out["evaluations"] = row.evaluations;
  out["at_longest"] = row.at_longest;
  out["longest"] = row.longest;
  out["energy_share"] = row.energy_share;
  out["order"] = row.order;
  out["growth"] = row.growth;
  out["runs"] = row.runs;
  out["front"] = row.front;
  out["sets"] = row.setting.sets;
  return out;
}

Json json_of(const AccuracyReference& reference) {
  Json out{{"seconds", reference.seconds}, {"noise", json_of(reference.noise)}};
  Json values = Json::object();
  for (const results::KeyResult& result : reference.results)
    if (std::isfinite(result.value)) values[std::string(result.of.id)] = result.value;
  out["results"] = values;
  return out;
}

results::AccuracyErrors errors_of(const Json& json) {
  results::AccuracyErrors out;
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
    out.*q.member = json.value(q.key, -1.0);  // of an earlier release: not computed
  return out;
}

AccuracyRow row_of(const Json& json) {
  AccuracyRow row;
  row.setting.name = json.at("name").get<std::string>();
  row.setting.method = json.at("method").get<std::string>();
  row.setting.tolerance = json.at("tol").get<double>();
  row.setting.as_long_as_stable = json.at("as_long_as_stable").get<bool>();
  row.setting.own = json.at("own").get<bool>();
  row.setting.sets = json.at("sets").get<std::vector<std::pair<std::string, std::string>>>();
  row.turns = json.at("turns").get<double>();
  row.failure = json.value("failure", "");
  row.seconds = json.at("seconds").get<double>();
  row.errors = errors_of(json.at("errors"));
  row.steps = json.at("steps").get<long>();
  row.evaluations = json.at("evaluations").get<long>();
  row.at_longest = json.at("at_longest").get<double>();
  row.longest = json.at("longest").get<double>();
  row.energy_share = json.at("energy_share").get<double>();
  row.order = json.at("order").get<double>();
  row.growth = json.value("growth", 0.0);
  row.runs = json.value("runs", 1);
  row.front = json.at("front").get<bool>();
  return row;
}

AccuracyReference reference_of(const Json& json) {
  AccuracyReference out;
  out.seconds = json.at("seconds").get<double>();
  out.noise = errors_of(json.at("noise"));
  for (const auto& [id, value] : json.at("results").items()) {
    const results::KeyResultSpec spec = results::find_key_result(id);
    if (!spec.id.empty()) out.results.push_back({spec, value.get<double>()});
  }
  return out;
}

const AccuracyRow* own_row(const AccuracyStudy& study) {
  for (const AccuracyRow& row : study.finals)
    if (row.setting.own) return &row;
  return nullptr;
}

/// Growth from the first span to the second, of the recommended or the deck's own settings.
std::string growth_text(const AccuracyStudy& study) {
  const AccuracyRow* row = study.recommended >= 0
                               ? &study.finals[static_cast<std::size_t>(study.recommended)]
                               : own_row(study);
  if (row == nullptr || !row->failure.empty()) return {};
  if (!(study.long_turns > study.short_turns))
    return "Error growth: not measured, because both rounds have the same simulated length.";
  const auto before =
      std::find_if(study.screening.begin(), study.screening.end(), [&](const AccuracyRow& other) {
        return other.setting.name == row->setting.name && other.failure.empty();
      });
  if (before == study.screening.end()) return {};
  return fmt::format(
      "Measured error growth ({}): between {:.4g} and {}, the error changed from {} to {}, and the "
      "energy residual from {:.1e} to {:.1e} of the exchanged energy{}.",
      row->setting.name, before->turns, revolutions_text(row->turns),
      percent(before->errors.largest()), percent(row->errors.largest()), before->energy_share,
      row->energy_share,
      row->growth > 0.0 ? fmt::format(", a factor of {:.4g} per revolution", row->growth)
                        : "; the simulated lengths of the two rounds differ by less than one "
                          "revolution, which is too little to compute a growth rate");
}

/// A row that keeps the target, takes less time than the recommended one and warns of its energy.
const AccuracyRow* cheaper_but_warned(const AccuracyStudy& study, const AccuracyRow& best) {
  const AccuracyRow* out = nullptr;
  for (const AccuracyRow& row : study.finals)
    if (row.failure.empty() && study.keeps(row.errors) && row.seconds < best.seconds &&
        row.energy_share > results::kMovedWarning && (out == nullptr || row.seconds < out->seconds))
      out = &row;
  return out;
}

/// The resolution of the contacts whose effect exceeds the target; no integrator can correct it.
const AccuracyRow* other_model(const AccuracyStudy& study) {
  const AccuracyRow* out = nullptr;
  const auto change = [&](const AccuracyRow& row) {
    return row.failure.empty()
               ? significant_errors(row.errors, study.short_reference.noise).largest()
               : 0.0;
  };
  for (const AccuracyRow& row : study.models)
    if (change(row) > (out == nullptr ? study.target : change(*out))) out = &row;
  return out;
}

}  // namespace

std::string limits_text(const AccuracyStudy& study) {
  const results::AccuracyErrors limits = study.limits();
  std::string wider;
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
    if (limits.*q.member > study.target)
      wider += fmt::format("{}{} within {}", wider.empty() ? "" : ", ", q.name,
                           percent(limits.*q.member));
  return percent(study.target) + (wider.empty() ? "" : " (" + wider + ")");
}

std::string irregular_text(const AccuracyStudy& study) {
  if (study.limits().largest() <= study.target) return {};
  return fmt::format(
      "the motion is irregular, so the mean values over the simulated length scatter by more than "
      "the target error. Two accurate runs differ by {}{}",
      percent(study.long_reference.noise.largest()),
      study.irregular.largest() > 0.0
          ? fmt::format(". A relative load change of 1e-6 changes the means by up to {}",
                        percent(study.irregular.largest()))
          : std::string());
}

std::string recommendation(const AccuracyStudy& study) {
  if (study.finals.empty()) return "The study was interrupted before it could recommend settings.";
  const AccuracyRow* own = own_row(study);
  std::string out;
  if (study.recommended < 0) {
    out = fmt::format("No settings keep all errors within {} over {}", limits_text(study),
                      revolutions_text(study.long_turns));
  } else {
    const AccuracyRow& best = study.finals[static_cast<std::size_t>(study.recommended)];
    out = fmt::format(
        "{}: the fastest settings that keep all errors within {} over {}, {:.3g} s (errors: {})",
        best.setting.name, limits_text(study), revolutions_text(study.long_turns), best.seconds,
        errors_text(best.errors));
    if (best.energy_share > results::kMovedWarning)
      out += fmt::format(
          "; the energy residual is {:.1e} of the exchanged energy, which causes a warning",
          best.energy_share);
    else if (const AccuracyRow* cheaper = cheaper_but_warned(study, best))
      out += fmt::format(
          "; {} needs only {:.3g} s, but its energy residual is {:.1e} of the "
          "exchanged energy",
          cheaper->setting.name, cheaper->seconds, cheaper->energy_share);
    if (best.setting.own) return out + "; these are the deck's own settings.";
  }
  if (own != nullptr)
    out += own->failure.empty()
               ? fmt::format("; the deck's own settings need {:.3g} s (errors: {})", own->seconds,
                             errors_text(own->errors))
               : fmt::format("; with the deck's own settings: {}", own->failure);
  if (const std::string irregular = irregular_text(study); !irregular.empty())
    out += "; " + irregular;
  if (const AccuracyRow* model = other_model(study))
    out += fmt::format(
        "; this study covers only the integrator and the step sizes: {} changes the results by "
        "more than the target error ({}). `adore run --accuracy {:g}%` also chooses the numbers of "
        "nodes and "
        "slices",
        model->setting.name, errors_text(model->errors), 100.0 * study.target);
  return out + ".";
}

std::vector<std::pair<std::string, std::string>> recommended_sets(const AccuracyStudy& study) {
  if (study.recommended < 0) return {};
  const AccuracySetting& best = study.finals[static_cast<std::size_t>(study.recommended)].setting;
  int code = 0;
  while (code < 100 && integrators::name_of_int_met(code) != best.method) ++code;
  std::vector<std::pair<std::string, std::string>> out{
      {"intMet", std::to_string(code)}, {"tol", fmt::format("{:g}", best.tolerance)}};
  const double longest = study.finals[static_cast<std::size_t>(study.recommended)].longest;
  if (best.as_long_as_stable && longest > 0.0) {
    // As stability allows it, rounded down: the deck then asks for it itself.
    const double unit = std::pow(10.0, std::floor(std::log10(longest)) - 1.0);
    out.emplace_back("stpMax", fmt::format("{:g}", unit * std::floor(longest / unit)));
  }
  return out;
}

std::string round_text(const AccuracyRow& row, const AccuracyStudy& study) {
  const char* round = !study.models.empty()   ? "models"
                      : !study.finals.empty() ? "second round"
                                              : "first round";
  return fmt::format("{}, {}", round, revolutions_text(row.turns));
}

std::string accuracy_table(const AccuracyStudy& study) {
  std::string out = fmt::format(
      "Errors are differences of mean values from a reference ({}).\nColumn \"s\": processor time "
      "of the whole run. In the second round, three runs are measured if the budget allows:\nwith "
      "the recommended settings, with the deck's own settings and in the rows with *. The column "
      "then shows the median.\nRows with *: no other row is both faster and as accurate.\nAn error "
      "counts only if it is larger than the difference of two accurate runs.\nThe whirl speed is "
      "computed from the area that the cage center sweeps, not from the number of whirl "
      "revolutions in PRINT.\n",
      study.reference);
  const auto round = [&](const char* what, double turns, const AccuracyReference& reference,
                         const std::vector<AccuracyRow>& rows) {
    if (rows.empty()) return;
    out += fmt::format("\n{}: {}. The two references differ by {} ({}).\n{}", what,
                       revolutions_text(turns), percent(reference.noise.largest()),
                       errors_text(reference.noise), table_of(rows));
  };
  round("First round", study.short_turns, study.short_reference, study.screening);
  round("Second round", study.long_turns, study.long_reference, study.finals);
  if (study.long_turns > 0.0 && study.long_turns < study.asked)
    out += fmt::format("Specified length: {}; the time budget allows only {:.4g}. {}\n",
                       revolutions_text(study.asked), study.long_turns, growth_text(study));
  if (study.irregular.largest() > 0.0)
    out += fmt::format("A relative load change of 1e-6 changes the means by up to {} ({}; {}).\n",
                       percent(study.irregular.largest()), errors_text(study.irregular),
                       study.irregular_by);
  else if (!study.finals.empty() && study.irregular.load < 0.0)
    out +=
        "The effect of a relative load change of 1e-6 was not measured (no load, no time left, or "
        "a "
        "failed run). Only the difference between the two reference runs shows whether the motion "
        "is irregular.\n";
  if (study.untried > 0)
    out += fmt::format(
        "{} not run: the time budget was used up.\n",
        counted(study.untried, "more setting or model was", "more settings or models were"));
  if (!study.models.empty())
    out += fmt::format(
        "\nOther models with the deck's own settings over {}. The errors are changes relative to "
        "the model of the deck.\n{}",
        revolutions_text(study.short_turns), table_of(study.models));
  return out + "\n" + recommendation(study) + "\n";
}

std::string accuracy_csv(const AccuracyStudy& study) {
  std::string out =
      "round,name,method,tol,turns,seconds,error,speed,whirl,load,peak,heat,life,steps,"
      "evaluations,"
      "longest_step,mean_step_over_longest,energy_share,order,front,growth_per_turn,runs,failure\n";
  const auto quoted = [](std::string text) {
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
      text.insert(at, 1, '"');
    return "\"" + text + "\"";
  };
  const auto add = [&](const char* round, const std::vector<AccuracyRow>& rows) {
    for (const AccuracyRow& row : rows) {
      const auto number = [&](double error) {
        return !row.failure.empty() || error < 0.0 ? std::string() : fmt::format("{:.6g}", error);
      };
      std::string errors;
      for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
        errors += "," + number(row.errors.*q.member);
      out += fmt::format(
          "{},{},{},{:g},{:g},{:.6g},{}{},{},{},{:.4g},{:.4g},{:.4g},{:.3g},{},{},{},{}\n", round,
          quoted(row.setting.name), row.setting.method, row.setting.tolerance, row.turns,
          row.seconds, number(row.errors.largest()), errors, row.steps, row.evaluations,
          row.longest, row.at_longest, row.energy_share, row.order, row.front ? 1 : 0,
          row.growth > 0.0 ? fmt::format("{:.4g}", row.growth) : std::string(), row.runs,
          row.failure.empty() ? "" : quoted(row.failure));
    }
  };
  add("first", study.screening);
  add("second", study.finals);
  add("model", study.models);
  return out;
}

std::string accuracy_json(const AccuracyStudy& study) {
  Json out{{"program", "adore"},
           {"study", "accuracy"},
           {"digest", study.digest},
           {"complete", study.complete},
           {"title", fmt::format("Cost of accuracy: {}, reference {}",
                                 revolutions_text(study.finals.empty() ? study.short_turns
                                                                       : study.long_turns),
                                 study.reference)},
           {"error_title", "largest error of speeds, whirl, loads, heat and life"},
           {"turn_s", study.turn},
           {"asked_turns", study.asked},
           {"short_turns", study.short_turns},
           {"long_turns", study.long_turns},
           {"target", study.target},
           {"beyond_noise", kBeyondNoise},
           {"reference", study.reference},
           {"short_reference", json_of(study.short_reference)},
           {"long_reference", json_of(study.long_reference)},
           {"irregular", json_of(study.irregular)},
           {"irregular_by", study.irregular_by},
           {"twins", study.twins},
           {"seconds", study.seconds},
           {"unlisted_seconds", study.unlisted_seconds},
           {"untried", study.untried},
           {"recommended", study.recommended},
           {"recommendation", recommendation(study)}};
  const auto list = [](const std::vector<AccuracyRow>& rows) {
    Json all = Json::array();
    for (const AccuracyRow& row : rows) all.push_back(json_of(row));
    return all;
  };
  out["screening"] = list(study.screening);
  out["finals"] = list(study.finals);
  out["models"] = list(study.models);
  return dump_json(out, 2) + "\n";
}

AccuracyStudy read_accuracy(const std::string& text, const std::string& name) {
  const Json json = parse_json<Json>(text, name);
  try {
    AccuracyStudy out;
    out.digest = json.at("digest").get<std::string>();
    out.complete = json.at("complete").get<bool>();
    out.turn = json.at("turn_s").get<double>();
    out.asked = json.at("asked_turns").get<double>();
    out.short_turns = json.at("short_turns").get<double>();
    out.long_turns = json.at("long_turns").get<double>();
    out.target = json.at("target").get<double>();
    out.reference = json.at("reference").get<std::string>();
    out.short_reference = reference_of(json.at("short_reference"));
    out.long_reference = reference_of(json.at("long_reference"));
    if (json.contains("irregular")) out.irregular = errors_of(json.at("irregular"));
    out.irregular_by = json.value("irregular_by", "");
    out.twins = json.value("twins", std::vector<std::string>());
    out.seconds = json.at("seconds").get<double>();
    out.unlisted_seconds = json.value("unlisted_seconds", 0.0);
    out.untried = json.value("untried", 0);
    for (const Json& row : json.at("screening")) out.screening.push_back(row_of(row));
    for (const Json& row : json.at("finals")) out.finals.push_back(row_of(row));
    for (const Json& row : json.at("models")) out.models.push_back(row_of(row));
    const auto recommended = json.at("recommended").get<long long>();
    if (recommended >= static_cast<long long>(out.finals.size()))
      throw InputError(
          name +
          " is not a study of `adore accuracy`: it recommends a row that it does not contain");
    out.recommended = static_cast<int>(std::max(recommended, -1LL));
    return out;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(name + " is not a study of `adore accuracy`: " + error.what());
  }
}

}  // namespace adore::studies
