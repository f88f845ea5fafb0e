#include "studies/chosen_settings.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/interrupted.hpp"
#include "runs/prepare.hpp"
#include "runs/run_span.hpp"
#include "studies/accuracy_judgement.hpp"
#include "studies/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace adore::studies {
namespace {

constexpr double kStepErrorShare = 0.75;  ///< of the target
constexpr double kStudyRevolutions = 5.0, kStudySeconds = 20.0;
constexpr double kMaxRevolutions = 1.0, kMinRevolutions = 0.02,
                 kResolutionSeconds = 10.0;  ///< of all resolutions

/// From the cheapest on; the last one is what the others are compared with. Across the contact two
/// nodes do, four where a film follows the pressure (decisions 390, 414, 328).
using Nodes = std::array<std::pair<int, int>, 8>;
constexpr Nodes kNodes{{{10, 1}, {15, 1}, {10, 2}, {15, 2}, {20, 2}, {30, 2}, {40, 2}, {60, 4}}};
constexpr Nodes kFilmNodes{
    {{10, 2}, {15, 2}, {12, 4}, {15, 4}, {20, 4}, {30, 4}, {40, 4}, {60, 8}}};
constexpr Nodes kStripNodes{
    {{10, 1}, {10, 2}, {15, 2}, {16, 2}, {20, 2}, {30, 2}, {40, 2}, {60, 4}}};
constexpr std::array<int, 8> kSlices{7, 11, 15, 21, 31, 45, 61, 121};

void set_again(runs::RunRequest& run, const std::string& name, const std::string& value) {
  std::erase_if(run.sets, [&](const auto& set) { return set.first == name; });
  run.sets.emplace_back(name, value);
}

ResolutionRow nodes_row(int major, int minor) {
  ResolutionRow row;
  row.options = {{"ellipseMajor", std::to_string(major)}, {"ellipseMinor", std::to_string(minor)}};
  row.name = fmt::format("ellipse nodes {} x {}", major, minor);
  return row;
}

ResolutionRow slices_row(int slices) {
  ResolutionRow row;
  row.options = {{"rollerSlices", std::to_string(slices)}};
  row.name = fmt::format("roller slices {}", slices);
  return row;
}

/// Number of nodes or slices, which is what a resolution costs.
double size_of(const ResolutionRow& row) {
  double out = 1.0;
  for (const auto& [name, value] : row.options) out *= static_cast<double>(std::stoll(value));
  return out;
}

/// Empty where the request has chosen.
std::vector<ResolutionRow> resolutions(const runs::Prepared& prepared) {
  const auto& given = prepared.input.option_values;
  std::vector<ResolutionRow> out;
  if (prepared.rollers) {
    if (given.contains("rollerSlices") || given.contains("rollerContact")) return out;
    for (const int slices : kSlices) out.push_back(slices_row(slices));
    const int default_slices = prepared.options.rollers.slices;
    for (ResolutionRow& row : out) row.is_default = row.name == slices_row(default_slices).name;
    return out;
  }
  if (given.contains("ellipseMajor") || given.contains("ellipseMinor")) return out;
  const auto& system = prepared.options.system;
  const bool strips = system.ellipse_major == tribology::kStripNodes.major;
  for (const auto& [major, minor] : system.ellipse_minor > 2 ? kFilmNodes
                                    : strips                 ? kStripNodes
                                                             : kNodes)
    out.push_back(nodes_row(major, minor));
  for (ResolutionRow& row : out)
    row.is_default = row.name == nodes_row(system.ellipse_major, system.ellipse_minor).name;
  return out;
}

class Choice {
 public:
  Choice(const runs::DeckRequest& request, double target, std::stop_token stop, double most_turns)
      : request_(request), target_(target), stop_(std::move(stop)), most_turns_(most_turns) {}

  ChosenSettings make() {
    choose_steps();
    const runs::Prepared prepared = runs::prepare(request_);
    rows_ = resolutions(prepared);
    if (rows_.empty()) {
      out_.text += ". The numbers of nodes and slices are not chosen, because run options set them";
    } else {
      choose_resolution(prepared);
    }
    out_.text += fmt::format(
        ". The choice depends on measured processor times, so another run may choose other "
        "settings. To "
        "repeat this run: `adore run DECK {}`",
        again());
    return std::move(out_);
  }

 private:
  void choose_steps() {
    AccuracyRequest asked;
    static_cast<runs::DeckRequest&>(asked) = request_;
    asked.target = kStepErrorShare * target_;
    asked.methods = {"rk4", "rkf5", "rkf6", "rkf7", "pece2"};
    asked.turns = std::min(kStudyRevolutions, most_turns_);
    asked.budget = kStudySeconds;
    asked.models = false;
    const AccuracyStudy study = study_accuracy(asked, {}, stop_);
    if (!study.complete) throw Interrupted("interrupted");
    const AccuracyRow* chosen = study.recommended >= 0
                                    ? &study.finals[static_cast<std::size_t>(study.recommended)]
                                    : most_accurate(study);
    if (chosen == nullptr)
      throw SolverError(
          fmt::format("{} Use `adore accuracy` to try more settings over more "
                      "revolutions",
                      recommendation(study)));
    const AccuracyRow& best = *chosen;
    out_.integrator = best.setting.method;
    out_.tolerance = best.setting.tolerance;
    out_.steps = best.errors;
    // The longest stable step as a number: it then counts as specified by the deck, without a
    // warning about shortened steps.
    for (auto& [name, value] : recommended_sets(study))
      if (name == "stpMax") out_.sets.emplace_back(std::move(name), std::move(value));
    turn_ = study.turn;
    seconds_per_turn_ = best.seconds / best.turns;
    const std::string longest =
        out_.sets.empty() ? "" : fmt::format(", stpMax {}", out_.sets.front().second);
    out_.text = fmt::format(
        "settings for an error of {:.3g} %: {}, tol {:g}{} (errors over {}: {})", 100.0 * target_,
        out_.integrator, out_.tolerance, longest,
        counted(fmt::format("{:.3g}", best.turns), "revolution"), errors_text(best.errors));
    if (study.recommended < 0)
      out_.text +=
          ", the most accurate settings of the study, because no settings have errors within the "
          "target";
    if (study.limits().largest() > target_) out_.text += "; " + irregular_text(study);
  }

  [[nodiscard]] static const AccuracyRow* most_accurate(const AccuracyStudy& study) {
    const AccuracyRow* out = nullptr;
    const auto over = [&](const AccuracyRow& row) {
      return error_to_limit_ratio(row.errors, study.noise(), study.target);
    };
    for (const AccuracyRow& row : study.finals)
      if (row.failure.empty() && (out == nullptr || over(row) < over(*out))) out = &row;
    return out;
  }

  /// Options that repeat a later run with the same bytes: another study may choose differently.
  [[nodiscard]] std::string again() const {
    std::string out = fmt::format("--integrator {} --tol {:g}", out_.integrator, out_.tolerance);
    for (const auto& [name, value] : out_.sets) out += fmt::format(" --set {}={}", name, value);
    for (const auto& [name, value] : out_.options) out += fmt::format(" --opt {}={}", name, value);
    return out;
  }

  [[nodiscard]] runs::RunRequest run_of(const ResolutionRow& row) const {
    runs::RunRequest run;
    static_cast<runs::DeckRequest&>(run) = request_;
    apply_chosen_settings(run, out_);
    run.until = fmt::format("{:.17g}s", out_.turns * turn_);
    run.options.insert(run.options.end(), row.options.begin(), row.options.end());
    return run;
  }

  /// Key results; none, with the row's failure, where the run gave none.
  std::optional<results::KeyResults> results_of(const runs::RunRequest& run, ResolutionRow& row) {
    try {
      const runs::MeasuredRun one =
          runs::measured_run(run, std::numeric_limits<double>::infinity(), stop_);
      row.seconds = one.seconds;
      if (one.outcome.status == runs::RunStatus::Done) return one.outcome.summary;
      row.failure = one.outcome.message;
    } catch (const InputError& error) {
      row.failure = error.what();
    } catch (const SolverError& error) {
      row.failure = error.what();
    }
    return {};
  }

  void choose_resolution(const runs::Prepared& prepared) {
    const auto default_row = std::find_if(rows_.begin(), rows_.end(),
                                          [](const ResolutionRow& row) { return row.is_default; });
    // A quarter of a run's cost is not that of its contacts.
    double sizes = 0.0;
    const double one =
        default_row != rows_.end() ? size_of(*default_row) : size_of(rows_[rows_.size() / 2]);
    for (const ResolutionRow& row : rows_) sizes += 0.25 + 0.75 * size_of(row) / one;
    sizes += 0.25 + 0.75 * size_of(rows_.back()) / one;
    out_.turns = std::min(std::clamp(kResolutionSeconds / (seconds_per_turn_ * sizes),
                                     kMinRevolutions, kMaxRevolutions),
                          most_turns_);
    ResolutionRow finest = rows_.back();
    rows_.pop_back();
    out_.finest = finest.name;
    const runs::RunRequest reference = run_of(finest);
    const auto is = results_of(reference, finest);
    runs::RunRequest beside = reference;
    for (const char* load : {"appLoadX", "appLoadY", "appLoadZ"})
      if (const double value = prepared.input.deck.real(load); value != 0.0)
        beside.changes.emplace_back(load, fmt::format("{:.17g}", 1.000001 * value));
    const auto other = is ? results_of(beside, finest) : std::nullopt;
    if (!is || !other) {
      out_.text += fmt::format(
          ". The numbers of nodes and slices are unchanged, because the run with {} failed: {}",
          finest.name, finest.failure);
      return;
    }
    out_.noise = results::compare_results(*other, *is);
    const double limit = target_ - std::min(out_.steps.largest(), kStepErrorShare * target_);
    int before = -1;  // the row before this one keeps to the limit
    for (ResolutionRow& row : rows_) {
      const auto results = results_of(run_of(row), row);
      if (results) {
        const results::AccuracyErrors errors = results::compare_results(*results, *is);
        row.significant = significant_errors(errors, out_.noise);
        for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
          row.below_noise = row.below_noise || errors.*q.member > row.significant.*q.member;
      }
      out_.rows.push_back(row);
      const int here = static_cast<int>(out_.rows.size()) - 1;
      const bool keeps = results && row.significant.largest() <= limit;
      if (keeps && before >= 0) {
        out_.resolution = before;
        break;
      }
      before = keeps ? here : -1;
    }
    if (out_.resolution < 0) out_.resolution = before;
    const std::string against =
        fmt::format("compared with {} over {}", out_.finest,
                    counted(fmt::format("{:.3g}", out_.turns), "revolution"));
    if (out_.resolution < 0) {
      out_.options = finest.options;
      out_.text += fmt::format(
          ". Resolution: {}, because every coarser resolution fails or changes the results by more "
          "than {:.2g} %",
          out_.finest, 100.0 * limit);
      return;
    }
    const ResolutionRow& chosen = out_.rows[static_cast<std::size_t>(out_.resolution)];
    out_.options = chosen.options;
    out_.text +=
        fmt::format("; {} ({}: {}{}{})", chosen.name, against, errors_text(chosen.significant),
                    chosen.is_default ? ", the default" : "", noise_text(chosen));
  }

  /// Noise below which an error counts as 0.
  [[nodiscard]] static std::string noise_text(const ResolutionRow& row) {
    return row.below_noise
               ? "; an error of 0 % is not larger than the effect of a relative load change of 1e-6"
               : "";
  }

  const runs::DeckRequest& request_;
  double target_;
  std::stop_token stop_;
  double most_turns_;
  double turn_ = 0.0, seconds_per_turn_ = 0.0;
  std::vector<ResolutionRow> rows_;
  ChosenSettings out_;
};

}  // namespace

void apply_chosen_settings(runs::RunRequest& request, const ChosenSettings& chosen) {
  request.integrator = chosen.integrator;
  request.tolerance = chosen.tolerance;
  for (const auto& [name, value] : chosen.sets) set_again(request, name, value);
  request.options.insert(request.options.end(), chosen.options.begin(), chosen.options.end());
}

ChosenSettings choose_settings(const runs::DeckRequest& request, double target,
                               std::stop_token stop, double most_turns) {
  return Choice(request, target, std::move(stop), most_turns).make();
}

double requested_revolutions(const runs::RunRequest& request) {
  const runs::Prepared prepared = runs::prepare(request);
  const double speed = std::abs(prepared.bearing.speed[1] - prepared.bearing.speed[0]);
  if (!prepared.control.dynamic || !(speed > 0.0)) return std::numeric_limits<double>::infinity();
  const runs::RunSpan span =
      runs::run_span(request, prepared, runs::make_system(prepared).scales().time);
  return span.end * speed / (2.0 * std::numbers::pi);
}

void tighten_settings(ChosenSettings& chosen, const runs::RunRequest& request,
                      const runs::RunOutcome& outcome) {
  runs::RunRequest run = request;
  apply_chosen_settings(run, chosen);
  const runs::Prepared prepared = runs::prepare(run);
  const double longest = 0.5 * outcome.longest_step / runs::make_system(prepared).scales().time;
  chosen.tolerance *= 0.1;
  std::erase_if(chosen.sets, [](const auto& set) { return set.first.starts_with("stpM"); });
  chosen.sets.emplace_back("stpMax", fmt::format("{:.3g}", longest));
  if (prepared.control.step_minimum > longest ||
      prepared.control.step_minimum == prepared.control.step_maximum)
    chosen.sets.emplace_back("stpMin", fmt::format("{:.3g}", longest));
  if (auto finer = doubled_resolution(prepared); !finer.empty()) chosen.options = std::move(finer);
  chosen.text += fmt::format(
      ". The 95 % interval of the whole run was wider than the target. New settings: tol {:g}, "
      "stpMax {:.3g}",
      chosen.tolerance, longest);
  for (const auto& [name, value] : chosen.options)
    chosen.text += fmt::format(", {} {}", name, value);
}

runs::RunOutcome run_with_chosen_settings(runs::RunRequest request, const ChosenSettings& chosen,
                                          const runs::ProgressSink& progress,
                                          std::stop_token stop) {
  apply_chosen_settings(request, chosen);
  request.settings_note = chosen.text;
  return runs::run(request, progress, std::move(stop));
}

}  // namespace adore::studies
