#include "studies/accuracy_statement.hpp"

#include "base/counted.hpp"
#include "base/write_folder.hpp"
#include "results/mean_load.hpp"
#include "results/run_json.hpp"
#include "runs/prepare.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace adore::studies {
namespace {

/// Values of one quantity in the three runs [SI]: a load has three components.
struct StatementValues {
  std::array<double, 3> run{}, tighter{}, twin{};
};

double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class Statement {
 public:
  /// @param twin null: there is no run under changed loads
  Statement(const runs::RunOutcome& run, const Verification& tighter, const runs::RunOutcome* twin)
      : run_(run),
        tighter_(tighter.results),
        twin_(twin),
        means_(twin != nullptr ? twin->means : tighter.means) {}

  std::vector<StatedQuantity> quantities() {
    const double cage = std::abs(of("mean_cage_ratio"));
    const double heat = std::abs(of("mean_power_loss_W"));
    const double contact = std::abs(of("mean_largest_load_N"));
    using Means = results::MeanSeries;
    add("mean_orbital_ratio", "element speed / shaft speed", &Means::orbital_ratio);
    add("mean_cage_ratio", "cage speed / shaft speed", &Means::cage_ratio);
    add("mean_swept_whirl_ratio", "cage whirl speed / shaft speed", &Means::swept_whirl_ratio,
        cage);
    add_load(results::kLoadFloor * contact);
    add("mean_largest_load_N", "mean of the largest contact load", &Means::largest_load);
    if (add("peak_load_N", "peak contact load", nullptr)) out_.back().mean = false;
    add("mean_heat_outer_race_W", "heat, outer race", &Means::heat_outer, heat);
    add("mean_heat_inner_race_W", "heat, inner race", &Means::heat_inner, heat);
    add("mean_heat_elsewhere_W", "heat, cage, lands and fluid", &Means::heat_elsewhere, heat);
    add("mean_power_loss_W", "heat, whole bearing", &Means::power_loss);
    add("run_life_hours", "life", nullptr);
    return std::move(out_);
  }

 private:
  struct Scatter {
    results::PairedScatter paired;
    double own;  ///< half-width from the batches of the run alone [SI], NaN: not computed
  };
  using Scatters = std::vector<Scatter>;

  [[nodiscard]] double of(std::string_view id) const { return results::value_of(run_.summary, id); }

  static Scatter scatter(const results::RatioSeries& run, const results::RatioSeries& twin) {
    return {results::paired_scatter(run, twin), results::ratio_half_width(run.a, run.s)};
  }

  /// @param scatters of the components; empty: the quantity has no batches
  void judge(StatedQuantity& q, const StatementValues& v, const Scatters& scatters) const {
    if (!(q.scale > 0.0)) return;
    const double changed = twin_ != nullptr ? distance(v.run, v.twin) / q.scale : 0.0;
    const double off = distance(v.run, v.tighter) / q.scale;
    q.statistical =
        (scatters.empty() && changed > kRegularChange ? kNoBatchesFactor : kDifferenceFactor) *
        changed;
    double squares = 0.0, own = 0.0, largest = 0.0, late = 1.0;
    for (const auto& [paired, alone] : scatters) {
      if (!std::isfinite(paired.half_width)) continue;
      squares += paired.half_width * paired.half_width;
      if (std::isfinite(alone)) own += 2.0 * alone * alone;
      if (!(paired.half_width > largest)) continue;
      largest = paired.half_width;
      q.fall = paired.fall;
      late = paired.late;
    }
    q.statistical = std::max(q.statistical, std::sqrt(squares) / q.scale);
    q.diverged_statistical = std::sqrt(late) * q.statistical;
    q.parting = late > kDivergingLimit;
    if (q.parting) {
      q.statistical = q.diverged_statistical;
      q.diverged_statistical = std::max(q.diverged_statistical, std::sqrt(own) / q.scale);
    }
    q.irregular = twin_ == nullptr || q.statistical > kDifferenceFactor * kRegularChange;
    const double beyond = q.irregular ? std::max(off - q.statistical, 0.0) : off;
    q.numerical = std::max(kNumericalFactor * beyond, kMinNumericalError);
  }

  /// @param least of the scale [SI] @return whether there is such a result
  bool add(const char* id, const char* label, results::RatioSeries results::MeanSeries::*series,
           double least = 0.0) {
    const double run = of(id), tighter = results::value_of(tighter_, id);
    const double twin = twin_ != nullptr ? results::value_of(twin_->summary, id) : run;
    if (!std::isfinite(run) || !std::isfinite(tighter) || !std::isfinite(twin)) return false;
    StatedQuantity q;
    q.id = id;
    q.label = label;
    q.value = run;
    const results::UnitPair* unit = results::find_key_result(id).unit;
    q.unit = unit == nullptr || std::string_view(unit->si) == "-" ? "" : unit->si;
    q.scale = std::max(std::abs(run), std::isfinite(least) ? least : 0.0);
    Scatters scatters;
    if (series != nullptr) scatters.push_back(scatter(run_.means.*series, means_.*series));
    judge(q, {{run, 0, 0}, {tighter, 0, 0}, {twin, 0, 0}}, scatters);
    out_.push_back(std::move(q));
    return true;
  }

  void add_load(double least) {
    StatementValues v;
    Scatters scatters;
    const std::array<const char*, 3> ids{"mean_load_x_N", "mean_load_y_N", "mean_load_z_N"};
    for (std::size_t k = 0; k < 3; ++k) {
      v.run[k] = of(ids[k]);
      v.tighter[k] = results::value_of(tighter_, ids[k]);
      v.twin[k] = twin_ != nullptr ? results::value_of(twin_->summary, ids[k]) : v.run[k];
      if (!std::isfinite(v.run[k]) || !std::isfinite(v.tighter[k]) || !std::isfinite(v.twin[k]))
        return;
      scatters.push_back(scatter(run_.means.load[k], means_.load[k]));
    }
    StatedQuantity q;
    q.id = "mean_load";
    q.label = "mean load of the races";
    q.value = length(v.run);
    q.unit = "N";
    q.scale = std::max(q.value, least);
    judge(q, v, scatters);
    out_.push_back(std::move(q));
  }

  const runs::RunOutcome& run_;
  const results::KeyResults& tighter_;
  const runs::RunOutcome* twin_;
  const results::MeanSeries& means_;  ///< of the second run
  std::vector<StatedQuantity> out_;
};

std::string share_text(double share) {
  return share >= 0.9995 ? fmt::format("{:.0f} %", 100.0 * share)
                         : fmt::format("{:.2g} %", 100.0 * share);
}

/// Rounded up to two digits.
double rounded_up(double turns) {
  const double unit = std::pow(10.0, std::floor(std::log10(turns)) - 1.0);
  return unit * std::ceil(turns / unit - 1e-9);
}

}  // namespace

double AccuracyStatement::numerical() const {
  double out = 0.0;
  for (const StatedQuantity& q : quantities) out = std::max(out, q.numerical);
  return out;
}

double AccuracyStatement::required_revolutions(const StatedQuantity& q, double asked) const {
  if (!q.mean || !(q.statistical > asked) || !(turns > 0.0)) return 0.0;
  return rounded_up(kLengthMargin * turns * std::pow(q.diverged_statistical / asked, 1.0 / q.fall));
}

double AccuracyStatement::required_revolutions(double asked) const {
  double longest = 0.0;
  for (const StatedQuantity& q : quantities)
    longest = std::max(longest, required_revolutions(q, asked));
  return longest;
}

bool AccuracyStatement::has_diverging_quantity(double asked) const {
  return std::any_of(quantities.begin(), quantities.end(), [&](const StatedQuantity& q) {
    return q.mean && q.parting && q.statistical > asked;
  });
}

bool AccuracyStatement::keeps() const {
  return !quantities.empty() &&
         std::all_of(quantities.begin(), quantities.end(),
                     [&](const StatedQuantity& q) { return q.half_width() <= target; });
}

AccuracyStatement make_accuracy_statement(const runs::RunRequest& request,
                                          const runs::RunOutcome& outcome, double target,
                                          std::stop_token stop) {
  AccuracyStatement out;
  out.target = target;
  out.time = outcome.time;
  out.turns = std::abs(outcome.revolutions);
  out.run_seconds = outcome.processor_seconds;
  out.tighter = verify(request, outcome, stop);
  if (!out.tighter.failure.empty()) return out;
  const runs::Prepared prepared = runs::prepare(request);
  runs::RunRequest beside = repeated(request, prepared, outcome);
  beside.options.emplace_back("resultsH5", "0");
  std::optional<runs::RunOutcome> twin;
  if (const auto loads = runs::nearby_loads(prepared.input.deck, kLoadChange); loads.empty()) {
    out.twin_failure = "the deck has no external load";
  } else {
    for (const auto& load : loads) beside.changes.push_back(load);
    runs::MeasuredRun run =
        runs::measured_run(beside, std::numeric_limits<double>::infinity(), std::move(stop));
    out.twin_seconds = run.seconds;
    if (run.outcome.status == runs::RunStatus::Done ||
        run.outcome.status == runs::RunStatus::Untrusted)
      twin = std::move(run.outcome);
    else
      out.twin_failure = run.outcome.message;
  }
  out.quantities = Statement(outcome, out.tighter, twin ? &*twin : nullptr).quantities();
  return out;
}

std::string statement_text(const AccuracyStatement& statement) {
  const Verification& tighter = statement.tighter;
  if (!tighter.failure.empty())
    return fmt::format("accuracy:  not computed, because the run with {} failed: {}\n",
                       tighter.tighter, tighter.failure);
  const std::string second =
      statement.twin_failure.empty()
          ? fmt::format(
                "a run with a relative load change of 1e-6 ({:.3g} s of processor time, {:.2g} "
                "times this run)",
                statement.twin_seconds,
                statement.twin_seconds / std::max(statement.run_seconds, 1e-9))
          : fmt::format(
                "the run with tighter settings, because there is no run with changed loads: {}",
                statement.twin_failure);
  std::string out = fmt::format(
      "accuracy:  over the {} of this run, 95 % intervals\n  numerical part: difference from a run "
      "with {} ({:.3g} s of processor time)\n  statistical part: batch means of the difference "
      "from {}\n  "
      "{:<36} {:>14} {:<5} {:>11} {:>12} {:>10}\n",
      counted(fmt::format("{:.4g}", statement.turns), "revolution"), tighter.tighter,
      tighter.seconds, second, "", "value", "", "numerical", "statistical", "interval");
  for (const StatedQuantity& q : statement.quantities)
    out += fmt::format("  {:<36} {:>14.6g} {:<5} {:>11} {:>12} {:>10}{}\n", q.label, q.value,
                       q.unit, share_text(q.numerical), share_text(q.statistical),
                       "±" + share_text(q.half_width()), q.irregular ? "  irregular" : "");
  if (!(statement.target > 0.0)) return out;
  std::string worst;
  for (const StatedQuantity& q : statement.quantities)
    if (q.half_width() > statement.target)
      worst +=
          fmt::format("{}{} ±{}", worst.empty() ? "" : ", ", q.label, share_text(q.half_width()));
  if (worst.empty())
    return out + fmt::format("  All intervals are within {}.\n", share_text(statement.target));
  out += fmt::format("  Intervals wider than {}: {}.\n", share_text(statement.target), worst);
  const double turns = statement.required_revolutions(statement.target);
  if (!(turns > 0.0)) return out;
  const std::string needed = counted(fmt::format("{:.3g}", turns), "revolution");
  std::string each;
  for (const StatedQuantity& q : statement.quantities)
    if (const double own = statement.required_revolutions(q, statement.target); own > 0.0)
      each += fmt::format("{}{} {:.3g}", each.empty() ? "" : ", ", q.label, own);
  out += fmt::format(
      "  The mean values need {} for an accuracy of {} ({}; this run: {:.4g}). The estimate is {}. "
      "Simulate this length, or use `adore run --accuracy ... --extend`.\n",
      (statement.has_diverging_quantity(statement.target) ? "on the order of " : "about ") + needed,
      share_text(statement.target), each, statement.turns,
      statement.has_diverging_quantity(statement.target)
          ? "an order of magnitude only, because the two runs still diverge"
          : fmt::format("correct within a factor of {:g}", kNeededFactor));
  return out;
}

nlohmann::ordered_json statement_json(const AccuracyStatement& statement,
                                      const results::MeanErrors& means) {
  nlohmann::ordered_json out;
  out["means"] = results::mean_errors_json(means);
  if (statement.target > 0.0) out["target"] = statement.target;
  out["span_s"] = statement.time;
  out["revolutions"] = statement.turns;
  out["run_processor_s"] = statement.run_seconds;
  if (statement.twin_failure.empty())
    out["changed_loads_processor_s"] = statement.twin_seconds;
  else
    out["changed_loads"] = statement.twin_failure;
  out["quantities"] = nlohmann::ordered_json::array();
  for (const StatedQuantity& q : statement.quantities) {
    out["quantities"].push_back({{"id", q.id},
                                 {"label", q.label},
                                 {"value", q.value},
                                 {"unit", q.unit},
                                 {"scale", q.scale},
                                 {"numerical", q.numerical},
                                 {"statistical", q.statistical},
                                 {"half_width", q.half_width()},
                                 {"fall_exponent", q.fall},
                                 {"irregular", q.irregular}});
    const double turns = statement.required_revolutions(q, statement.target);
    if (statement.target > 0.0 && turns > 0.0)
      out["quantities"].back()["needs_revolutions"] = turns;
  }
  if (statement.target > 0.0) {
    out["keeps_target"] = statement.keeps();
    if (const double turns = statement.required_revolutions(statement.target); turns > 0.0) {
      out["needs_revolutions"] = turns;
      if (statement.has_diverging_quantity(statement.target))
        out["needs_revolutions_rough"] = true;
      else
        out["needs_revolutions_factor"] = kNeededFactor;
    }
  }
  return out;
}

void store_statement(const AccuracyStatement& statement, const runs::RunOutcome& outcome) {
  results::amend_run(WriteFolder(outcome.folder),
                     {{"accuracy", statement_json(statement, results::errors_of(outcome.means))},
                      {"verify", verification_json(statement.tighter, outcome)}},
                     "\f\n  ACCURACY OF THE RESULTS\n\n" + statement_text(statement));
}

}  // namespace adore::studies
