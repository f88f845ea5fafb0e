#include "runs/run_span.hpp"

#include "base/counted.hpp"
#include "runs/user_session.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::runs {
namespace {

/// Seconds for "5rev", "0.02s" or a dimensionless number. @throws InputError
double parse_until(const std::string& text, double shaft_speed, double time_scale) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (error != std::errc() || !(value > 0.0) || !std::isfinite(value) ||
      (unit != "" && unit != "rev" && unit != "s"))
    throw InputError(
        fmt::format("--until {}: give a value above 0 in shaft revolutions (5rev), in seconds "
                    "(0.02s) or as a dimensionless time (1000)",
                    text));
  if (unit == "s") return value;
  if (unit == "") return value * time_scale;
  if (shaft_speed == 0.0)
    throw InputError(
        fmt::format("--until {}: both races rotate at the same speed, so shaft revolutions cannot "
                    "be counted; give seconds, e.g. 0.01s",
                    text));
  return value * 2.0 * std::numbers::pi / std::abs(shaft_speed);
}

}  // namespace

bool speeds_vary(const Prepared& prepared) {
  const bearing::RaceMotions& motions = prepared.plan.race_motions;
  for (std::size_t j = 0; j < 2; ++j)
    if (motions.ramp[j] || motions.variation[j] || (prepared.user && prepared.user->drives()[j]) ||
        (motions.free[j] && !motions.free[j]->rotation_held[0]))
      return true;
  return false;
}

RunSpan run_span(const RunRequest& request, const Prepared& prepared, double time_scale) {
  const double shaft_speed = prepared.bearing.speed[1] - prepared.bearing.speed[0];
  const bool turns = request.until.ends_with("rev");
  if (turns && speeds_vary(prepared))
    throw InputError(fmt::format(
        "--until {}: the speed of a race varies in time (kVarSpeed, or kMD11 or kMD12 = 0), so "
        "shaft revolutions do not determine an end time; give seconds, e.g. 0.01s",
        request.until));
  if (!request.until.empty())
    return {parse_until(request.until, shaft_speed, time_scale), std::numeric_limits<long>::max()};
  return {prepared.control.end_time * time_scale, prepared.control.max_steps};
}

long last_step(const RunRequest& request, const RunSpan& span, const StartPoint& start) {
  const long from = start.continued && request.go_on ? start.segment : start.step;
  constexpr long kMaxSteps = std::numeric_limits<long>::max();
  return span.max_steps > kMaxSteps - from ? kMaxSteps : from + span.max_steps;
}

double end_time_delay(const RunRequest& request, const StartPoint& start, double turned,
                      double turns_per_second) {
  if (!start.continued || !request.until.ends_with("rev")) return 0.0;
  const double delay = start.time - turned / turns_per_second;
  return std::abs(delay) > 1e-12 * start.time ? delay : 0.0;
}

bool has_reached_end(const RunSpan& span, long last_step, const StartPoint& start, double turned,
                     double turns_per_second) {
  const auto refuse = [&](const std::string& end, const std::string& now) {
    throw InputError(
        fmt::format("the run to be continued is already at {}, later than the specified end, {}. "
                    "Give a later end with --until, fTime or maxStps",
                    now, end));
  };
  if (span.end < start.time * (1.0 - 1e-12)) {
    const auto text = [&](double time) {
      return turns_per_second != 0.0
                 ? fmt::format("{:.6g} s ({})", time,
                               counted(fmt::format("{:.6g}",
                                                   turned + turns_per_second * (time - start.time)),
                                       "revolution"))
                 : fmt::format("{:.6g} s", time);
    };
    refuse(text(span.end), text(start.time));
  }
  if (last_step < start.step)
    refuse(fmt::format("step {}", last_step), fmt::format("step {}", start.step));
  // A run that was killed has stored more than it has checkpointed.
  const bool ends_before = span.end < start.stored_time * (1.0 - 1e-6);
  if (ends_before || last_step < start.stored_step)
    throw InputError(fmt::format(
        "the run to be continued has stored results up to step {}, {:.6g} s. Its last checkpoint "
        "is at step {}, {:.6g} s. The specified end, {}, is earlier than the last stored step, so "
        "later results would be deleted. Give a later end with --until, fTime or maxStps, or start "
        "a new run (kIcOpt = 0) in another folder",
        start.stored_step, start.stored_time, start.step, start.time,
        ends_before ? fmt::format("{:.6g} s", span.end) : fmt::format("step {}", last_step)));
  return start.time >= span.end || last_step == start.step;
}

}  // namespace adore::runs
