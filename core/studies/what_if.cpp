#include "studies/what_if.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "runs/prepare.hpp"
#include "setup/scene_plan.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::studies {
namespace {

/// One way to leave something out.
struct LeftOut {
  std::string effects, option, variable;  ///< either the option's name, or "nCseg"
};

/// The deck variable that a reason begins with ("nCseg = 1, ..." -> nCseg), where 0 turns it off.
std::string switch_of(const std::string& because) {
  const std::size_t end = because.find(" = ");
  if (end == std::string::npos) return {};
  const std::string name = because.substr(0, end);
  const bool word =
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
  const bool is_switch = name.size() > 1 && name[0] == 'k' && std::isupper(name[1]) != 0;
  return word && (is_switch || name == "nCseg" || name == "qFac" || name == "mode") ? name : "";
}

/// Records that name bodies of the cage name none of a bearing without it: the first element alone.
void leave_out_the_cage(std::vector<std::pair<std::string, std::string>>& changes) {
  changes.emplace_back("nCseg", "0");
  changes.emplace_back("kNumPltElem", "1");
  changes.emplace_back("kPltElemInd", "1");
}

std::vector<LeftOut> ways_of(const scene::ScenePlan& plan) {
  std::vector<LeftOut> out;
  for (const scene::EffectEntry& entry : plan.effects) {
    if (!entry.on) continue;
    if (setup::can_be_left_out(plan, entry.effect)) {
      out.push_back({entry.name, entry.name, ""});
      continue;
    }
    const std::string variable = switch_of(entry.because);
    const bool at_zero = entry.because.starts_with(variable + " = 0");
    if (variable.empty() || at_zero || variable == "kBrg" || variable == "kReIP") continue;
    const auto same = std::find_if(out.begin(), out.end(),
                                   [&](const LeftOut& way) { return way.variable == variable; });
    if (same == out.end())
      out.push_back({entry.name, "", variable});
    else
      same->effects += ", " + entry.name;
  }
  return out;
}

double relative(const results::KeyResults& run, const results::KeyResults& base,
                std::string_view id) {
  const double a = results::value_of(run, id), b = results::value_of(base, id);
  if (a == b) return 0.0;
  return b != 0.0 ? (a - b) / std::abs(b) : std::numeric_limits<double>::quiet_NaN();
}

WhatIfChange change_of(const results::KeyResults& run, const results::KeyResults& base) {
  const auto turns = [](const results::KeyResults& of) {
    return std::abs(results::value_of(of, "mean_cage_ratio")) >
           0.0;  // none of a bearing without a cage
  };
  const bool cage = turns(base) && turns(run);
  return {relative(run, base, cage ? "mean_cage_ratio" : "mean_orbital_ratio"),
          relative(run, base, "mean_largest_load_N"), relative(run, base, "mean_power_loss_W"),
          relative(run, base, "run_life_hours")};
}

std::string change_percent(double change) {
  if (!std::isfinite(change)) return "-";
  return fmt::format("{:+.2g}", 100.0 * change);
}

nlohmann::ordered_json to_json(const WhatIfChange& change) {
  return {{"speed", change.speed},
          {"largest_load", change.load},
          {"heat", change.heat},
          {"life", change.life}};
}

}  // namespace

WhatIf what_if(const WhatIfRequest& request, const std::function<void(const WhatIfRow&)>& row_done,
               std::stop_token stop) {
  const runs::Prepared prepared = runs::prepare(request);
  if (!prepared.control.dynamic)
    throw InputError(
        "effects of a quasi-static deck (mode < 0) cannot be switched off one by one; set mode = "
        "0");
  runs::RunRequest run;
  static_cast<runs::DeckRequest&>(run) = request;
  if (prepared.control.start != setup::StartState::Statics) run.changes.emplace_back("kIcOpt", "0");
  const double speed = std::abs(prepared.bearing.speed[1] - prepared.bearing.speed[0]);
  const double whole = prepared.control.end_time * make_system(prepared).scales().time;
  const double turn = speed > 0.0 ? 2.0 * std::numbers::pi / speed : whole;
  const double span = std::min(request.turns * turn, whole);
  run.until = fmt::format("{:.17g}s", span);

  WhatIf out;
  out.turns = span / turn;
  const auto measured = [&](const runs::RunRequest& one) {
    return runs::measured_run(one, kInfinity, stop);
  };
  (void)measured(run);  // finds programs and files in no cache
  const runs::MeasuredRun base = measured(run);
  if (base.outcome.status == runs::RunStatus::Failed) throw SolverError(base.outcome.message);
  out.seconds = base.seconds;
  out.base = base.outcome.summary;
  runs::RunRequest beside = run;
  for (auto& load : runs::nearby_loads(prepared.input.deck, 1e-6)) beside.changes.push_back(load);
  const runs::MeasuredRun other = measured(beside);
  // Processor times depend on other programs on the machine: each effect is measured between two
  // runs of the complete deck, and their difference is reported.
  double before = other.seconds;
  const auto beside_each = [&] {
    const double after = measured(run).seconds, mean = 0.5 * (before + after);
    out.time_spread = std::max(out.time_spread, std::abs(after - before) / mean);
    before = after;
    return mean;
  };
  (void)beside_each();
  out.noise = change_of(other.outcome.summary, out.base);

  for (const LeftOut& way : ways_of(prepared.plan)) {
    WhatIfRow row;
    row.effect = way.effects;
    runs::RunRequest without = run;
    if (!way.option.empty()) {
      std::string& names = [&]() -> std::string& {
        for (auto& [name, value] : without.options)
          if (name == "effectsOff") return value;
        without.options.emplace_back("effectsOff", "");
        return without.options.back().second;
      }();
      names += (names.empty() ? "" : ",") + way.option;
      row.without = "effectsOff=" + way.option;
    } else {
      if (way.variable == "nCseg")
        leave_out_the_cage(without.changes);
      else
        without.changes.emplace_back(way.variable, "0");
      row.without = way.variable + "=0";
    }
    try {
      const runs::MeasuredRun one = measured(without);
      row.seconds = one.seconds;
      row.share = 1.0 - one.seconds / beside_each();
      if (one.outcome.status == runs::RunStatus::Failed)
        row.failure = one.outcome.message;
      else
        row.change = change_of(one.outcome.summary, out.base);
    } catch (const InputError& error) {
      row.failure = error.what();
      for (const Issue& issue : error.issues())
        if (issue.severity == Severity::Error) row.failure = issue.message;
    } catch (const SolverError& error) {
      row.failure = error.what();
    }
    if (row_done) row_done(row);
    out.rows.push_back(std::move(row));
  }
  return out;
}

std::string what_if_text(const WhatIf& result) {
  const auto of = [&](std::string_view id, int digits, std::string_view unit) {
    const double value = results::value_of(result.base, id);
    return std::isnan(value) ? std::string("none") : fmt::format("{:.{}g}{}", value, digits, unit);
  };
  std::string out = fmt::format(
      "\nwhat if: runs over {} with one effect switched off at a time; {:.3g} s of processor time "
      "with all effects\nall effects: cage speed {}, largest load {}, heat {}, life {}\nChanges "
      "are in percent of these values. Changes smaller than those caused by a relative load change "
      "of 1e-6 are not significant.\nCost is the share of the effect in the processor time, with "
      "an uncertainty of {:.2g} %.\n\n  {:<32} {:>8} {:>9} {:>9} {:>9} {:>9}  without\n",
      counted(fmt::format("{:.4g}", result.turns), "revolution"), result.seconds,
      of("mean_cage_ratio", 5, " times the shaft speed"), of("mean_largest_load_N", 4, " N"),
      of("mean_power_loss_W", 4, " W"), of("run_life_hours", 4, " h"), 100.0 * result.time_spread,
      "effect", "cost %", "speed %", "load %", "heat %", "life %");
  const auto line = [&](const std::string& name, const std::string& cost,
                        const WhatIfChange& change, const std::string& without) {
    out += fmt::format("  {:<32} {:>8} {:>9} {:>9} {:>9} {:>9}  {}\n", name, cost,
                       change_percent(change.speed), change_percent(change.load),
                       change_percent(change.heat), change_percent(change.life), without);
  };
  line("relative load change 1e-6", "", result.noise, "");
  for (const WhatIfRow& row : result.rows) {
    if (row.failure.empty())
      line(row.effect, fmt::format("{:.1f}", 100.0 * row.share), row.change, row.without);
    else
      out += fmt::format("  {:<32} the run without it ({}) failed: {}\n", row.effect, row.without,
                         row.failure.substr(0, row.failure.find('\n')));
  }
  return out;
}

nlohmann::ordered_json what_if_json(const WhatIf& result) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const WhatIfRow& row : result.rows) {
    nlohmann::ordered_json one{{"effect", row.effect}, {"without", row.without}};
    if (row.failure.empty()) {
      one["seconds"] = row.seconds;
      one["cost_share"] = row.share;
      one["change"] = to_json(row.change);
    } else {
      one["failure"] = row.failure;
    }
    rows.push_back(std::move(one));
  }
  return {{"turns", result.turns},
          {"seconds", result.seconds},
          {"time_spread", result.time_spread},
          {"noise", to_json(result.noise)},
          {"rows", std::move(rows)}};
}

}  // namespace adore::studies
