#include "studies/accuracy.hpp"

#include "base/interrupted.hpp"
#include "integrators/stepper.hpp"
#include "results/energy_judgement.hpp"
#include "studies/accuracy_judgement.hpp"
#include "studies/accuracy_settings.hpp"
#include "studies/accuracy_statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace adore::studies {
namespace {

/// Longest span of the first round.
constexpr double kMaxShortRevolutions = 2.0;
/// Planned and largest part of the budget for the first round.
constexpr double kFirstRoundShare = 0.35, kMaxFirstRoundShare = 0.5;
/// Largest part of the budget that is kept for other models.
constexpr double kModelRoundShare = 0.15;
/// Part of the remaining time for the second round: motions may become slower with time.
constexpr double kSecondRoundShare = 0.85;
/// Largest parts of the remaining time for a reference and for a row of the second round.
constexpr double kReferenceShare = 0.3, kMaxRowShare = 0.5;
/// New span after a run that the time limit ended, over the revolutions of that run.
constexpr double kSpanAfterTimeout = 0.4;
/// Largest cost of a row, in runs with the deck's own settings.
constexpr double kMaxRowCost = 5.0;
/// Largest number of rows of the second round, without the deck's own settings.
constexpr std::size_t kMaxFinalists = 8;
/// Span of models that are much slower, and the largest part of the budget for one of them.
constexpr double kSlowModelRevolutions = 0.05, kSlowModelShare = 0.5;
constexpr double kReferenceTolerance = 1e-9;
constexpr std::size_t kIrregularityMethods = 2, kIrregularityRuns = 3;
/// Remaining time that these runs need, over their estimated time.
constexpr double kIrregularityReserve = 2.0;
/// Version of the rules of comparison: rows of a study with another version are not reused.
constexpr int kRulesVersion = 5;

/// The deck as requested, with the settings that the study varies.
struct Subject {
  runs::RunRequest request;
  double turn = 0.0;        ///< [s]
  double time_scale = 0.0;  ///< unit of the deck's step sizes [s]
};

runs::RunRequest run_of(const Subject& subject, const AccuracySetting& setting, double turns) {
  runs::RunRequest out = subject.request;
  out.integrator = setting.method;
  out.tolerance = setting.tolerance;
  out.until = fmt::format("{:.17g}s", turns * subject.turn);
  out.changes.insert(out.changes.end(), setting.sets.begin(), setting.sets.end());
  out.options.insert(out.options.end(), setting.options.begin(), setting.options.end());
  return out;
}

/// One row and the key results behind it.
struct Trial {
  AccuracyRow row;
  results::KeyResults results;
  bool refused = false;  ///< before anything ran: no tolerance changes that
  double cut_at = 0.0;   ///< time that a run which was cut had come to; 0: it was not [s]
  [[nodiscard]] bool good() const { return row.failure.empty(); }
};

Trial try_setting(const Subject& subject, const AccuracySetting& setting, double turns,
                  double most_seconds, std::stop_token stop) {
  Trial out;
  out.row.setting = setting;
  out.row.turns = turns;
  try {
    const runs::MeasuredRun run =
        runs::measured_run(run_of(subject, setting, turns), most_seconds, stop);
    const runs::RunOutcome& outcome = run.outcome;
    out.row.seconds = run.seconds;
    out.row.steps = outcome.taken;
    out.row.evaluations = outcome.evaluations;
    if (run.cut) {
      out.cut_at = std::max(outcome.time, 1e-12);
      out.row.failure = fmt::format("stopped after {:.3g} s (time limit)", most_seconds);
    } else if (outcome.status != runs::RunStatus::Done) {
      out.row.failure = outcome.message;
    } else {
      out.results = outcome.summary;
      out.row.longest = outcome.longest_step / subject.time_scale;
      if (outcome.taken > 0 && outcome.longest_step > 0.0)
        out.row.at_longest =
            outcome.time / static_cast<double>(outcome.taken) / outcome.longest_step;
      if (outcome.energy_scale > 0.0)
        out.row.energy_share = std::abs(outcome.energy_residual) / outcome.energy_scale;
    }
  } catch (const InputError& error) {
    out.row.failure = error.what();
    out.refused = true;
  } catch (const SolverError& error) {
    out.row.failure = error.what();
  }
  return out;
}

class Trials {
 public:
  Trials(const AccuracyRequest& request, const AccuracySink& sink, std::stop_token stop,
         const AccuracyStudy& earlier)
      : request_(request), sink_(sink), stop_(std::move(stop)), earlier_(earlier) {}

  AccuracyStudy run() {
    set_up();
    if (continues_ && earlier_.complete) return earlier_;
    try {
      first_round();
      second_round();
      measure_irregularity();
      model_round();
      repeat_deciding_rows();
      study_.complete = true;
    } catch (const Interrupted&) {
      study_ = joined(study_, earlier_);
    }
    study_.recommended = choose();
    return std::move(study_);
  }

 private:
  void set_up() {
    const runs::Prepared prepared = runs::prepare(request_);
    if (!prepared.control.dynamic)
      throw InputError(
          "an accuracy study simulates the motion, but this deck is quasi-static (mode < 0); set "
          "mode = 0");
    for (const std::string& method : request_.methods) {
      try {
        (void)integrators::make_stepper(method);
      } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
      }
    }
    static_cast<runs::DeckRequest&>(subject_.request) = request_;
    if (prepared.control.start != setup::StartState::Statics)
      subject_.request.changes.emplace_back("kIcOpt", "0");
    const double scale = runs::make_system(prepared).scales().time;
    const double speed = std::abs(prepared.bearing.speed[1] - prepared.bearing.speed[0]);
    subject_.time_scale = scale;
    // Races without relative rotation: the whole run of the deck counts as one revolution.
    subject_.turn =
        speed > 0.0 ? 2.0 * std::numbers::pi / speed : prepared.control.end_time * scale;
    study_.turn = subject_.turn;
    study_.asked = request_.turns;
    study_.target = request_.target;
    study_.digest = runs::request_digest(subject_.request, prepared.input) +
                    fmt::format("-{:g}-{:g}-{:g}-{}-{}", request_.turns, request_.budget,
                                request_.target, request_.models, kRulesVersion);
    for (const std::string& method : request_.methods) study_.digest += "-" + method;
    for (const double tolerance : request_.tolerances)
      study_.digest += fmt::format("-{:g}", tolerance);
    settings_ = trial_settings(prepared, request_.methods, request_.tolerances);
    models_ = trial_model_settings(prepared);
    continues_ = study_.digest == earlier_.digest;
    if (continues_) study_.twins = earlier_.twins;
    stp_max_ = prepared.control.step_maximum;
    deck_ = prepared.input.deck;
  }

  /// The row of an earlier study of the same deck and span; nullptr: none.
  [[nodiscard]] const AccuracyRow* known(const std::vector<AccuracyRow>& rows,
                                         const AccuracySetting& setting, double turns) const {
    if (!continues_) return nullptr;
    for (const AccuracyRow& row : rows)
      if (row.setting.name == setting.name && row.turns == turns) return &row;
    return nullptr;
  }

  /// A row of an earlier study, or a new one.
  Trial trial(const std::vector<AccuracyRow>& rows, const AccuracySetting& setting, double turns,
              double most_seconds) {
    const AccuracyRow* row = known(rows, setting, turns);
    known_ = row != nullptr;
    if (known_) {
      Trial out;
      out.row = *row;
      study_.seconds += row->runs * row->seconds;
      return out;
    }
    Trial out = try_setting(subject_, setting, turns, most_seconds, stop_);
    study_.seconds += out.row.seconds;
    return out;
  }

  /// Time of runs without a row, which a continued study does not repeat.
  void count_unlisted_time(double seconds) {
    study_.seconds += seconds;
    study_.unlisted_seconds += seconds;
  }

  /// State of a reference that was cut.
  struct ReferenceCut {
    double turns;
  };

  /// @throws SolverError, ReferenceCut when one of both takes more than most_seconds
  AccuracyReference references(double turns, const AccuracyReference& known, double most_seconds) {
    if (continues_ && !known.results.empty()) {
      study_.reference = earlier_.reference;
      study_.seconds += known.seconds;
      return known;
    }
    const auto reference = [&](const char* method, double tolerance) {
      AccuracySetting setting;
      setting.method = method;
      setting.tolerance = tolerance;
      // Its steps may be shorter than the deck allows, not longer.
      setting.sets = {{"stpMin", fmt::format("{:.3g}", 1e-6 * std::min(1.0, stp_max_))}};
      Trial out = try_setting(subject_, setting, turns, most_seconds, stop_);
      count_unlisted_time(out.row.seconds);  // until both have come to their end
      if (out.cut_at > 0.0) throw ReferenceCut{out.cut_at / subject_.turn};
      if (!out.good())
        throw SolverError(fmt::format("no reference solution: {} at tolerance {:.0e}: {}", method,
                                      tolerance, out.row.failure));
      return out;
    };
    const double tight =
        std::min(kReferenceTolerance,
                 1e-2 * *std::min_element(request_.tolerances.begin(), request_.tolerances.end()));
    const Trial best = reference("rkf7", tight);
    const Trial check = reference("rkf5", 10.0 * tight);
    AccuracyReference out{best.results, results::compare_results(check.results, best.results),
                          best.row.seconds + check.row.seconds};
    study_.unlisted_seconds -= out.seconds;
    study_.reference =
        fmt::format("run with rkf7 at tolerance {:.0e}, checked with rkf5 at tolerance {:.0e}",
                    tight, 10.0 * tight);
    return out;
  }

  /// Of the budget [s].
  [[nodiscard]] double left() const { return request_.budget - study_.seconds; }

  void add(std::vector<AccuracyRow>& rows, Trial& trial, const results::KeyResults& reference) {
    if (trial.good() && !known_)
      trial.row.errors = results::compare_results(trial.results, reference);
    rows.push_back(trial.row);
    if (sink_) sink_(trial.row, study_);
  }

  void first_round() {
    const auto same = continues_ && earlier_.short_turns > 0.0;
    // Two short runs with the deck's own settings measure the time of the start and of one
    // revolution; a run before them loads programs and files into the cache.
    const double few = 0.02, more = 0.2;
    (void)try_seconds(few);
    const double start = try_seconds(few), both = try_seconds(more);
    turn_cost_ = std::max((both - start) / (more - few), 1e-6);
    start_cost_ = std::max(0.0, start - few * turn_cost_);
    const double references_cost = 12.0;  // in turns of the deck's own run; measured below
    const double rows = static_cast<double>(settings_.size());
    study_.short_turns =
        std::clamp((kFirstRoundShare * request_.budget - (rows + 2.0) * start_cost_) /
                       (turn_cost_ * (1.2 * rows + references_cost)),
                   0.02, std::min(kMaxShortRevolutions, request_.turns));
    if (same) study_.short_turns = earlier_.short_turns;
    study_.short_reference = references(study_.short_turns, earlier_.short_reference, kInfinity);
    reference_cost_ = (study_.short_reference.seconds - 2.0 * start_cost_) / study_.short_turns;
    const double most = start_cost_ + 0.05 + kMaxRowCost * turn_cost_ * study_.short_turns;
    // From the tightest tolerance up: once the longest step decides, looser ones change nothing.
    std::string settled;
    for (const AccuracySetting& setting : settings_) {
      const std::string group = setting.method + (setting.as_long_as_stable ? "+" : "-");
      if (group == settled && !setting.own) continue;
      if (std::find(study_.twins.begin(), study_.twins.end(), setting.name) != study_.twins.end()) {
        settled = group;
        continue;
      }
      const double room = left() - (1.0 - kMaxFirstRoundShare) * request_.budget;
      if (room < start_cost_ && !setting.own &&
          known(earlier_.screening, setting, study_.short_turns) == nullptr) {
        ++study_.untried;
        continue;
      }
      Trial row = trial(earlier_.screening, setting, study_.short_turns,
                        setting.own ? most : std::min(most, room));
      // So does a rejected method, and one whose steps its stability limits in any case.
      const bool twin = has_twin(row.row);
      if (row.refused || twin || (row.good() && row.row.at_longest > kAtLongest)) settled = group;
      if (twin) {
        study_.twins.push_back(setting.name);
        study_.unlisted_seconds += row.row.seconds;
      } else {
        add(study_.screening, row, study_.short_reference.results);
      }
    }
    judge_rows(study_.screening, study_.short_reference.noise, study_.target);
  }

  /// Is there a row with the deck's own longest step that was allowed the very same steps?
  [[nodiscard]] bool has_twin(const AccuracyRow& row) const {
    return row.setting.as_long_as_stable &&
           std::any_of(study_.screening.begin(), study_.screening.end(),
                       [&](const AccuracyRow& other) {
                         return other.setting.method == row.setting.method &&
                                !other.setting.as_long_as_stable &&
                                other.setting.tolerance == row.setting.tolerance &&
                                other.longest > 0.0 && other.longest == row.longest;
                       });
  }

  double try_seconds(double turns) {
    const Trial own = try_setting(subject_, deck_setting(settings_), turns, kInfinity, stop_);
    count_unlisted_time(own.row.seconds);
    if (!own.good() && own.row.seconds == 0.0)
      throw InputError(own.row.failure);  // refused before it began
    return own.row.seconds;
  }

  /// The deck's own settings, and those that may be the cheapest of their accuracy.
  [[nodiscard]] std::vector<AccuracySetting> finalists() const {
    std::vector<AccuracySetting> out{deck_setting(settings_)};
    for (const std::size_t k :
         candidates(study_.screening, study_.short_reference.noise, study_.target, kMaxFinalists))
      out.push_back(study_.screening[k].setting);
    return out;
  }

  /// Cost of a row of the second round relative to the first [s/turn].
  [[nodiscard]] double cost_of(const AccuracySetting& setting) const {
    for (const AccuracyRow& row : study_.screening)
      if (row.setting.name == setting.name && row.failure.empty())
        return std::max(row.seconds - start_cost_, 0.0) / row.turns;
    return turn_cost_;
  }

  /// Possible cost of the other models, by the deck's own run, at most a fraction of the budget
  /// [s].
  [[nodiscard]] double time_for_models() const {
    if (!request_.models) return 0.0;
    const double one = start_cost_ + 2.0 * turn_cost_ * study_.short_turns;
    return std::min(one * static_cast<double>(models_.size()), kModelRoundShare * request_.budget);
  }

  /// References of the second span, which becomes shorter if they are slower than measured in the
  /// first round (skew of rollers and impacts in pockets begin after some time).
  void long_references() {
    while (true) {
      if (study_.long_turns <= study_.short_turns) {  // the very runs of the first round
        study_.long_reference = study_.short_reference;
        return;
      }
      try {
        study_.long_reference =
            references(study_.long_turns, earlier_.long_reference, kReferenceShare * left());
        return;
      } catch (const ReferenceCut& cut) {
        const double turns = std::min(kSpanAfterTimeout * cut.turns, 0.5 * study_.long_turns);
        study_.long_turns = std::max(turns >= 1.0 ? std::floor(turns) : turns, study_.short_turns);
      }
    }
  }

  void second_round() {
    // Time spent earlier without a row was spent in this round, except for a few short runs.
    if (continues_) count_unlisted_time(earlier_.unlisted_seconds);
    const std::vector<AccuracySetting> chosen = finalists();
    std::vector<double> costs;
    for (const AccuracySetting& setting : chosen) costs.push_back(cost_of(setting));
    double turn_of_all = std::accumulate(costs.begin(), costs.end(), reference_cost_);
    // Minimum time for runs with loads changed by 1e-6; the most accurate that it allows are run.
    std::sort(costs.begin(), costs.end());
    costs.resize(std::min(costs.size(), kIrregularityMethods));
    for (const double cost : costs) turn_of_all += kIrregularityRuns * cost;
    const double runs = static_cast<double>(chosen.size() + 2 + kIrregularityRuns * costs.size());
    const double affordable =
        (kSecondRoundShare * (left() - time_for_models()) - runs * start_cost_) / turn_of_all;
    double turns = std::min(request_.turns, affordable);
    // Means over whole revolutions; if less than one is possible, over the available span.
    turns = turns >= 1.0 ? std::floor(turns) : turns;
    study_.long_turns = std::max(turns, study_.short_turns);
    if (continues_ && earlier_.long_turns > 0.0) study_.long_turns = earlier_.long_turns;
    long_references();
    for (const AccuracySetting& setting : chosen) {
      if (left() < start_cost_ && !study_.finals.empty() &&
          known(earlier_.finals, setting, study_.long_turns) == nullptr) {
        ++study_.untried;
        continue;
      }
      // Motions may become slower than in the first round: no row may use the time of the others.
      Trial row = trial(earlier_.finals, setting, study_.long_turns,
                        std::max(kMaxRowShare * left(), start_cost_));
      add(study_.finals, row, study_.long_reference.results);
    }
    judge_rows(study_.finals, study_.noise(), study_.target);
    for (AccuracyRow& row : study_.finals) measure_growth(row);
  }

  /// Growth factor per revolution of the energy residual, from the first span to the second.
  /// It stays near 1 if errors only add up; it grows without limit if the method feeds energy into
  /// contact vibrations.
  void measure_growth(AccuracyRow& row) const {
    constexpr double kRounding = 1e-13;  // shares below are last digits
    for (const AccuracyRow& before : study_.screening) {
      if (before.setting.name != row.setting.name || !before.failure.empty() ||
          !row.failure.empty() || row.turns - before.turns < 1.0)
        continue;  // over a fraction of a revolution there is only the start transient
      row.growth =
          std::pow(std::max(row.energy_share, kRounding) / std::max(before.energy_share, kRounding),
                   1.0 / (row.turns - before.turns));
    }
  }

  /// Effect of a relative load change of 1e-6, in both directions: small for a regular motion.
  /// Measured with the most accurate setting of the second round and with a second method whose
  /// errors are within the target: coarse steps scatter anyway and would hide the
  /// irregularity.
  void measure_irregularity() {
    if (continues_ && earlier_.irregular.load >= 0.0) {
      study_.irregular = earlier_.irregular;
      study_.irregular_by = earlier_.irregular_by;
      return;
    }
    if (runs::nearby_loads(deck_, 1.0).empty()) return;
    std::vector<NearbyRuns> methods;
    std::vector<std::string> used;
    std::string by;
    while (methods.size() < kIrregularityMethods) {
      const AccuracyRow* row = best_for_nearby_runs(used);
      if (row == nullptr) break;
      used.push_back(row->setting.method);
      NearbyRuns runs = nearby_runs(*row);
      if (runs.size() < kIrregularityRuns) continue;
      methods.push_back(std::move(runs));
      by += (by.empty() ? "" : "; ") + row->setting.name;
    }
    study_.irregular = estimate_noise(methods);
    study_.irregular_by = by;
  }

  /// Of another method than those used; nullptr: none has time left.
  [[nodiscard]] const AccuracyRow* best_for_nearby_runs(
      const std::vector<std::string>& used) const {
    const AccuracyRow* out = nullptr;
    const results::AccuracyErrors noise = study_.noise();
    std::pair<double, double> least(used.empty() ? std::numeric_limits<double>::infinity() : 1.0,
                                    0.0);
    for (const AccuracyRow& row : study_.finals) {
      const bool tried = std::find(used.begin(), used.end(), row.setting.method) != used.end();
      if (tried || !row.failure.empty() || row.energy_share > results::kMovedWarning ||
          left() < kIrregularityReserve * kIrregularityRuns * row.seconds)
        continue;
      const std::pair rank(error_to_limit_ratio(row.errors, noise, study_.target),
                           row.errors.largest());
      if (!(rank < least)) continue;
      least = rank;
      out = &row;
    }
    return out;
  }

  /// Under the loads as they are, a millionth more and less; fewer where one fails.
  NearbyRuns nearby_runs(const AccuracyRow& row) {
    NearbyRuns out;
    for (const double change : {0.0, kLoadChange, -kLoadChange}) {
      Subject subject = subject_;
      for (auto& load : runs::nearby_loads(deck_, change)) subject.request.changes.push_back(load);
      Trial one = try_setting(subject, row.setting, row.turns, kInfinity, stop_);
      count_unlisted_time(one.row.seconds);
      if (!one.good()) break;
      out.push_back(std::move(one.results));
    }
    return out;
  }

  /// Effect of other resolutions of the model, compared with the deck's own run.
  void model_round() {
    if (models_.empty() || !request_.models) return;
    if (left() < start_cost_) {
      study_.untried += static_cast<int>(models_.size());
      return;
    }
    const AccuracySetting own = deck_setting(settings_);
    const Trial base = try_setting(subject_, own, study_.short_turns, kInfinity, stop_);
    count_unlisted_time(base.row.seconds);
    if (!base.good()) return;
    for (AccuracySetting setting : models_) {
      setting.method = own.method;
      setting.tolerance = own.tolerance;
      if (left() < start_cost_) {
        ++study_.untried;
        continue;
      }
      if (setting.dear) {
        const double turns = std::min(study_.short_turns, kSlowModelRevolutions);
        const Trial own_run = try_setting(subject_, own, turns, kInfinity, stop_);
        count_unlisted_time(own_run.row.seconds);
        if (!own_run.good()) continue;
        Trial row = trial(earlier_.models, setting, turns,
                          std::min(kSlowModelShare * request_.budget, left()));
        add(study_.models, row, own_run.results);
        continue;
      }
      Trial row =
          trial(earlier_.models, setting, study_.short_turns,
                std::min(start_cost_ + 0.5 + 30.0 * turn_cost_ * study_.short_turns, left()));
      add(study_.models, row, base.results);
    }
  }

  /// Processor times of what is recommended, of the deck's own settings and of the front become the
  /// median of three runs, as far as the budget goes: caches and neighbors make a tenth of one
  /// run.
  void repeat_deciding_rows() {
    const auto repeat = [&](AccuracyRow& row) {
      if (row.runs >= 3 || !row.failure.empty() || left() < 2.0 * row.seconds) return;
      std::array<double, 3> seconds{row.seconds, 0.0, 0.0};
      for (std::size_t k = 1; k < 3; ++k) {
        const Trial again = try_setting(subject_, row.setting, row.turns, kInfinity, stop_);
        study_.seconds += again.row.seconds;
        if (!again.good()) return;
        seconds[k] = again.row.seconds;
      }
      std::sort(seconds.begin(), seconds.end());
      row.seconds = seconds[1];
      row.runs = 3;
    };
    // A median may make another row the cheapest.
    for (int best = choose(), before = -1; best >= 0 && best != before; best = choose()) {
      repeat(study_.finals[static_cast<std::size_t>(best)]);
      before = best;
    }
    for (AccuracyRow& row : study_.finals)
      if (row.setting.own) repeat(row);
    for (AccuracyRow& row : study_.finals)
      if (row.front) repeat(row);
    judge_rows(study_.finals, study_.noise(), study_.target);
  }

  [[nodiscard]] int choose() const {
    int best = -1;
    // Runs that warn of their energy come last, however well their means agree over this span.
    const auto rank = [](const AccuracyRow& row) {
      return std::pair(row.energy_share > results::kMovedWarning, row.seconds);
    };
    for (std::size_t k = 0; k < study_.finals.size(); ++k) {
      const AccuracyRow& row = study_.finals[k];
      if (!row.failure.empty() || !study_.keeps(row.errors)) continue;
      if (best < 0 || rank(row) < rank(study_.finals[static_cast<std::size_t>(best)]))
        best = static_cast<int>(k);
    }
    return best;
  }

  const AccuracyRequest& request_;
  const AccuracySink& sink_;
  std::stop_token stop_;
  const AccuracyStudy& earlier_;
  Subject subject_;
  std::vector<AccuracySetting> settings_, models_;
  double stp_max_ = 0.0;
  deck::Deck deck_;
  double turn_cost_ = 0.0, start_cost_ = 0.0, reference_cost_ = 0.0;  ///< [s/turn, s, s/turn]
  bool continues_ = false;  ///< the earlier study is of the same request
  bool known_ = false;      ///< the last trial was taken from the earlier study
  AccuracyStudy study_;
};

}  // namespace

results::AccuracyErrors AccuracyStudy::limits() const {
  const results::AccuracyErrors n = noise();
  results::AccuracyErrors out;
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
    out.*q.member = std::max(target, kBeyondNoise * n.*q.member);
  return out;
}

bool AccuracyStudy::keeps(const results::AccuracyErrors& errors) const {
  return error_to_limit_ratio(errors, noise(), target) <= 1.0;
}

AccuracyStudy joined(AccuracyStudy study, const AccuracyStudy& earlier) {
  if (study.complete || study.digest != earlier.digest) return study;
  const auto add = [](std::vector<AccuracyRow>& rows, const std::vector<AccuracyRow>& more) {
    for (const AccuracyRow& row : more)
      if (std::none_of(rows.begin(), rows.end(), [&](const AccuracyRow& other) {
            return other.setting.name == row.setting.name && other.turns == row.turns;
          }))
        rows.push_back(row);
  };
  add(study.screening, earlier.screening);
  add(study.finals, earlier.finals);
  add(study.models, earlier.models);
  if (study.reference.empty()) study.reference = earlier.reference;
  if (study.short_reference.results.empty() && earlier.short_turns > 0.0) {
    study.short_turns = earlier.short_turns;
    study.short_reference = earlier.short_reference;
  }
  if (study.long_reference.results.empty() && earlier.long_turns > 0.0) {
    study.long_turns = earlier.long_turns;
    study.long_reference = earlier.long_reference;
  }
  if (study.irregular.load < 0.0) {
    study.irregular = earlier.irregular;
    study.irregular_by = earlier.irregular_by;
  }
  study.unlisted_seconds = std::max(study.unlisted_seconds, earlier.unlisted_seconds);
  study.seconds = std::max(study.seconds, earlier.seconds);
  return study;
}

AccuracyStudy study_accuracy(const AccuracyRequest& request, const AccuracySink& row_done,
                             std::stop_token stop, const AccuracyStudy& earlier) {
  return Trials(request, row_done, std::move(stop), earlier).run();
}

}  // namespace adore::studies
