#include "facade/accuracy_statement.hpp"

#include "base/counted.hpp"
#include "base/write_folder.hpp"
#include "facade/prepare.hpp"
#include "results/mean_load.hpp"
#include "results/run_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace adore::facade {
namespace {

/// Values of one quantity in the three runs [SI]: a load has three components.
struct Values {
  std::array<double, 3> run{}, tighter{}, twin{};
};

double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class Statement {
 public:
  Statement(const RunOutcome& run, const results::KeyResults& tighter,
            const std::optional<results::KeyResults>& twin)
      : run_(run), tighter_(tighter), twin_(twin) {}

  std::vector<StatedQuantity> quantities() {
    const results::MeanErrors& means = run_.mean_errors;
    const double cage = std::abs(of("mean_cage_ratio"));
    const double heat = std::abs(of("mean_power_loss_W"));
    const double contact = std::abs(of("mean_largest_load_N"));
    add("mean_orbital_ratio", "element speed over shaft speed", means.orbital_ratio);
    add("mean_cage_ratio", "cage speed over shaft speed", means.cage_ratio);
    add("mean_swept_whirl_ratio", "whirl of the cage over shaft speed", means.swept_whirl_ratio,
        cage);
    add_load(means.load, results::kLoadFloor * contact);
    add("mean_largest_load_N", "largest contact load, mean", means.largest_load);
    if (add("peak_load_N", "largest contact load of the span", results::MeanErrors::kNone))
      out_.back().mean = false;
    add("mean_heat_outer_race_W", "heat, outer race", means.heat_outer, heat);
    add("mean_heat_inner_race_W", "heat, inner race", means.heat_inner, heat);
    add("mean_heat_elsewhere_W", "heat, cage, lands and fluid", means.heat_elsewhere, heat);
    add("mean_power_loss_W", "heat, whole bearing", means.power_loss);
    const double life = of("run_life_hours");
    // Two standard errors: the interval of the others.
    add("run_life_hours", "life", 2.0 * life * of("run_life_spread"));
    return std::move(out_);
  }

 private:
  [[nodiscard]] double of(std::string_view id) const { return value_of(run_.summary, id); }

  /// @param half half-width of the mean's interval [SI], NaN: not computed
  void judge(StatedQuantity& q, const Values& v, double half) const {
    if (!(q.scale > 0.0)) return;
    const double changed = twin_ ? distance(v.run, v.twin) / q.scale : 0.0;
    const double off = distance(v.run, v.tighter) / q.scale;
    q.irregular = !twin_ || changed > kRegular;
    q.statistical = kTwin * changed;
    if (q.irregular && std::isfinite(half)) {
      const double scatter = std::sqrt(2.0) * half / q.scale;
      const double seen = twin_ ? kSeen * std::max(changed, off) : scatter;
      q.statistical = std::max(q.statistical, std::min(scatter, seen));
    }
    const double beyond = q.irregular ? std::max(off - q.statistical, 0.0) : off;
    q.numerical = std::max(kNumerical * beyond, kFloor);
  }

  /// @param least of the scale [SI] @return whether there is such a result
  bool add(const char* id, const char* label, double half, double least = 0.0) {
    const double here = of(id), there = value_of(tighter_, id);
    const double beside = twin_ ? value_of(*twin_, id) : here;
    if (!std::isfinite(here) || !std::isfinite(there) || !std::isfinite(beside)) return false;
    StatedQuantity q;
    q.id = id;
    q.label = label;
    q.value = here;
    const results::UnitPair* unit = results::find_key_result(id).unit;
    q.unit = unit == nullptr || std::string_view(unit->si) == "-" ? "" : unit->si;
    q.scale = std::max(std::abs(here), std::isfinite(least) ? least : 0.0);
    judge(q, {{here, 0, 0}, {there, 0, 0}, {beside, 0, 0}}, half);
    out_.push_back(std::move(q));
    return true;
  }

  void add_load(const std::array<double, 3>& half, double least) {
    Values v;
    const std::array<const char*, 3> ids{"mean_load_x_N", "mean_load_y_N", "mean_load_z_N"};
    for (std::size_t k = 0; k < 3; ++k) {
      v.run[k] = of(ids[k]);
      v.tighter[k] = value_of(tighter_, ids[k]);
      v.twin[k] = twin_ ? value_of(*twin_, ids[k]) : v.run[k];
      if (!std::isfinite(v.run[k]) || !std::isfinite(v.tighter[k]) || !std::isfinite(v.twin[k]))
        return;
    }
    StatedQuantity q;
    q.id = "mean_load";
    q.label = "load of the races, mean";
    q.value = length(v.run);
    q.unit = "N";
    q.scale = std::max(q.value, least);
    judge(q, v, length(half));
    out_.push_back(std::move(q));
  }

  const RunOutcome& run_;
  const results::KeyResults& tighter_;
  const std::optional<results::KeyResults>& twin_;
  std::vector<StatedQuantity> out_;
};

std::string percent(double share) {
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

double AccuracyStatement::needed_turns(double asked) const {
  double share = 0.0;
  for (const StatedQuantity& q : quantities)
    if (q.mean && q.statistical > asked) share = std::max(share, q.statistical / asked);
  return share > 0.0 && turns > 0.0 ? rounded_up(turns * share * share) : 0.0;
}

bool AccuracyStatement::keeps() const {
  return !quantities.empty() &&
         std::all_of(quantities.begin(), quantities.end(),
                     [&](const StatedQuantity& q) { return q.half_width() <= target; });
}

AccuracyStatement state_accuracy(const RunRequest& request, const RunOutcome& outcome,
                                 double target, std::stop_token stop) {
  AccuracyStatement out;
  out.target = target;
  out.time = outcome.time;
  out.turns = std::abs(outcome.revolutions);
  out.run_seconds = outcome.processor_seconds;
  out.tighter = verify(request, outcome, stop);
  if (!out.tighter.failure.empty()) return out;
  const Prepared prepared = prepare(request);
  RunRequest beside = repeated(request, prepared, outcome);
  beside.options.emplace_back("resultsH5", "0");
  std::optional<results::KeyResults> twin;
  if (const auto loads = nearby_loads(prepared.input.deck, kNearby); loads.empty()) {
    out.twin_failure = "the deck has no external load";
  } else {
    for (const auto& load : loads) beside.changes.push_back(load);
    const MeasuredRun run =
        measured_run(beside, std::numeric_limits<double>::infinity(), std::move(stop));
    out.twin_seconds = run.seconds;
    if (run.outcome.status == RunStatus::Done || run.outcome.status == RunStatus::Untrusted)
      twin = run.outcome.summary;
    else
      out.twin_failure = run.outcome.message;
  }
  out.quantities = Statement(outcome, out.tighter.results, twin).quantities();
  return out;
}

std::string statement_text(const AccuracyStatement& statement) {
  const Verification& tighter = statement.tighter;
  if (!tighter.failure.empty())
    return fmt::format("accuracy:  not stated; the run with {} failed: {}\n", tighter.tighter,
                       tighter.failure);
  const std::string second =
      statement.twin_failure.empty()
          ? fmt::format("loads changed by 1e-6 ({:.3g} s, {:.2g} times this run)",
                        statement.twin_seconds,
                        statement.twin_seconds / std::max(statement.run_seconds, 1e-9))
          : fmt::format("no second run under changed loads: {}", statement.twin_failure);
  std::string out = fmt::format(
      "accuracy:  over the {} of this run, 95 % intervals\n"
      "  numerical part: against {} ({:.3g} s of processor time)\n"
      "  statistical part: batch means, {}\n"
      "  {:<36} {:>14} {:<5} {:>11} {:>12} {:>10}\n",
      counted(fmt::format("{:.4g}", statement.turns), "revolution"), tighter.tighter,
      tighter.seconds, second, "", "value", "", "numerical", "statistical", "interval");
  for (const StatedQuantity& q : statement.quantities)
    out += fmt::format("  {:<36} {:>14.6g} {:<5} {:>11} {:>12} {:>10}{}\n", q.label, q.value,
                       q.unit, percent(q.numerical), percent(q.statistical),
                       "±" + percent(q.half_width()), q.irregular ? "  irregular" : "");
  if (!(statement.target > 0.0)) return out;
  std::string worst;
  for (const StatedQuantity& q : statement.quantities)
    if (q.half_width() > statement.target)
      worst += fmt::format("{}{} ±{}", worst.empty() ? "" : ", ", q.label, percent(q.half_width()));
  if (worst.empty())
    return out + fmt::format("  All intervals are within {}.\n", percent(statement.target));
  out += fmt::format("  Wider than {}: {}.\n", percent(statement.target), worst);
  if (const double turns = statement.needed_turns(statement.target); turns > 0.0)
    out += fmt::format(
        "  The means need about {} for {} (this run: {:.4g}). Run that "
        "long, or let `adore run --accuracy ... --extend` do it.\n",
        counted(fmt::format("{:.3g}", turns), "revolution"), percent(statement.target),
        statement.turns);
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
  for (const StatedQuantity& q : statement.quantities)
    out["quantities"].push_back({{"id", q.id},
                                 {"label", q.label},
                                 {"value", q.value},
                                 {"unit", q.unit},
                                 {"scale", q.scale},
                                 {"numerical", q.numerical},
                                 {"statistical", q.statistical},
                                 {"half_width", q.half_width()},
                                 {"irregular", q.irregular}});
  if (statement.target > 0.0) {
    out["keeps_target"] = statement.keeps();
    if (const double turns = statement.needed_turns(statement.target); turns > 0.0)
      out["needs_revolutions"] = turns;
  }
  return out;
}

void store_statement(const AccuracyStatement& statement, const RunOutcome& outcome) {
  results::amend_run(WriteFolder(outcome.folder),
                     {{"accuracy", statement_json(statement, outcome.mean_errors)},
                      {"verify", verification_json(statement.tighter, outcome)}},
                     "\f\n  ACCURACY OF THE RESULTS\n\n" + statement_text(statement));
}

}  // namespace adore::facade
