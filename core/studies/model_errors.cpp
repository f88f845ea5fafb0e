#include "studies/model_errors.hpp"

#include "base/constants.hpp"
#include "runs/measured_run.hpp"
#include "studies/accuracy_statement.hpp"
#include "studies/chosen_settings.hpp"
#include "studies/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::studies {
namespace {

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
  return std::isfinite(a) && std::isfinite(b) && b != 0.0 ? a / b - 1.0 : kNaN;
}

}  // namespace

std::vector<runs::ModelVariant> model_variants(const runs::Prepared& prepared) {
  std::vector<runs::ModelVariant> out;
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
             "damping times or divided by 2: loss factors of steel contacts are from 0.005 to 0.02 "
             "(values not checked against a publication)");
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

runs::ModelStudy run_model_study(const runs::DeckRequest& request, double turns, double budget,
                                 const std::function<void(const runs::ModelRow&)>& row_done,
                                 std::stop_token stop) {
  runs::RunRequest own;
  static_cast<runs::DeckRequest&>(own) = request;
  const runs::Prepared prepared = runs::prepare(request);
  if (!prepared.control.dynamic)
    throw InputError(
        "the study of model errors simulates the motion, but this deck is quasi-static (mode < 0); "
        "set mode = 0");
  std::vector<runs::ModelVariant> variants = model_variants(prepared);
  if (const auto loads = runs::nearby_loads(prepared.input.deck, kLoadChange); !loads.empty())
    variants.insert(variants.begin(),
                    {"scatter",
                     "loads x 1.000001",
                     "statistical scatter of an irregular motion, not a model uncertainty",
                     loads,
                     {}});
  if (prepared.control.start != setup::StartState::Statics) own.changes.emplace_back("kIcOpt", "0");
  own.options.emplace_back("resultsH5", "0");
  runs::ModelStudy study;
  study.stamp = runs::model_stamp(prepared.input);
  study.deck = prepared.input.path.filename().string();
  const double speed = std::abs(prepared.bearing.speed[1] - prepared.bearing.speed[0]);
  const double turn = speed > 0.0 ? 2.0 * std::numbers::pi / speed
                                  : prepared.control.end_time * make_system(prepared).scales().time;
  study.turns = speed > 0.0 ? std::min(turns, requested_revolutions(own)) : 1.0;
  // Finer and smoother models take two to four times the time of the deck's own run.
  const double each = budget / (2.0 * static_cast<double>(variants.size() + 1));
  runs::MeasuredRun base;
  while (true) {
    own.until = fmt::format("{:.17g}s", study.turns * turn);
    base = runs::measured_run(own, each, stop);
    study.seconds += base.seconds;
    if (!base.cut) break;
    study.turns *= std::clamp(0.8 * base.outcome.time / (study.turns * turn), 0.02, 0.8);
  }
  if (base.outcome.status != runs::RunStatus::Done &&
      base.outcome.status != runs::RunStatus::Untrusted)
    throw SolverError("the run with the deck's own settings ended with the message: " +
                      base.outcome.message);
  const results::KeyResults& is = base.outcome.summary;
  study.heat = results::value_of(is, "mean_power_loss_W");
  study.life = results::value_of(is, "run_life_hours");
  for (runs::ModelVariant& variant : variants) {
    runs::ModelRow row;
    runs::RunRequest run = own;
    for (const auto& set : variant.sets) run.changes.push_back(set);
    for (const auto& one : variant.options) run.options.push_back(one);
    row.variant = std::move(variant);
    try {
      const runs::MeasuredRun one =
          runs::measured_run(run, std::max(each, budget - study.seconds), stop);
      row.seconds = one.seconds;
      study.seconds += one.seconds;
      if (one.cut)
        row.failure = fmt::format("stopped after {:.3g} s (time limit)", one.seconds);
      else if (one.outcome.status == runs::RunStatus::Failed)
        row.failure = one.outcome.message;
      else {
        row.change = results::compare_results(one.outcome.summary, is);
        row.heat =
            relative(results::value_of(one.outcome.summary, "mean_power_loss_W"), study.heat);
        row.life = relative(results::value_of(one.outcome.summary, "run_life_hours"), study.life);
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

}  // namespace adore::studies
