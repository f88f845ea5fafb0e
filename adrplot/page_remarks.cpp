#include "adrplot/page_remarks.hpp"

#include "adrplot/abscissa.hpp"
#include "adrplot/known_values.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/stored_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace adore::adrplot {
namespace {

using desktop::ChartCurve;
using desktop::ChartPage;
using desktop::ChartPanel;
using results::SolFile;

std::vector<double> times_of(const SolFile& file) {
  std::vector<double> out;
  for (const auto& step : file.steps) out.push_back(step.time);
  return out;
}

/// The usual stored interval if it is too long for a vibration of that frequency (less than two
/// samples per period), else 0.
double alias_interval(const SolFile& file, double frequency) {
  const std::vector<double> times = times_of(file);
  const double values = desktop::values_per_period(times, frequency);
  return values > 0.0 && values < desktop::kAliased ? desktop::median_interval(times) : 0.0;
}

/// Does it follow each vibration of a contact? Temperatures, lives and averages do not.
bool vibrates(const std::string& column) {
  const auto has = [&column](const char* part) { return column.find(part) != std::string::npos; };
  if (has("temperature") || has("life") || has("wear_rate")) return false;
  if (has("rotation")) return false;  // a ramp of revolutions hides vibrations
  return column == "power.loss" ||
         (!column.starts_with("power.") && !column.starts_with("thermal."));
}

/// Is it 0 but for rounding (a thousandth of the least range of its axis)?
bool is_nothing(double value, const std::string& unit) {
  return std::abs(value) <= 1e-3 * desktop::min_axis_span(unit);
}

/// Flat lines at 0 get a note that the values are correct.
void tell_zeros(ChartPage& chart) {
  bool any = false;
  for (const ChartPanel& panel : chart.panels)
    for (const ChartCurve& curve : panel.curves)
      for (const double v : curve.y) {
        if (!std::isfinite(v)) continue;
        if (!is_nothing(v, panel.unit)) return;
        any = true;
      }
  if (!any) return;
  const bool motion = chart.title.starts_with("Mass center ");
  add_note(chart, motion ? "The mass center does not move: all values of this page are 0."
                         : "All values of this page are 0.");
}

/// Is there a value between two missing ones, in addition to values that form lines?
bool has_dots(const ChartPage& chart) {
  for (const ChartPanel& panel : chart.panels)
    for (const ChartCurve& curve : panel.curves) {
      const auto known = [&curve](std::size_t i) {
        return i < curve.y.size() && std::isfinite(curve.y[i]);
      };
      bool dot = false, more = false;
      for (std::size_t i = 0; i < curve.y.size(); ++i) {
        const bool alone = known(i) && !known(i + 1) && (i == 0 || !known(i - 1));
        more = more || (known(i) && (dot || !alone));
        dot = dot || alone;
      }
      if (dot && more) return true;
    }
  return false;
}

/// With kLifeFreq = 0 life is predicted only at the first and last step and constant in between:
/// only the predicted values are drawn, one at each end of a continued run.
void tell_life(ChartPage& chart, const SolFile& file, const PageSpec& page, const RunFacts& facts) {
  constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t p = 0; p < page.panels.size(); ++p) {
    if (page.panels[p].curves.front().column != "power.life") continue;
    std::vector<double>& y = chart.panels[p].curves.front().y;
    const auto first = std::find_if(y.begin(), y.end(), [](double v) { return std::isfinite(v); });
    if (first == y.end() || facts.life_every.value_or(0) != 0) continue;
    const bool once = is_constant(y, 2e-7 * std::abs(*first));
    if (!once && !facts.life_every) continue;
    const bool start = file.steps[static_cast<std::size_t>(first - y.begin())].step == 0;
    double held = *first;
    for (auto value = first + 1; value < y.end(); ++value)
      if (once || *value == held)
        *value = kNoValue;
      else
        held = *value;
    if (!once) {
      add_note(chart, "Fatigue life is computed only at the first and last step (kLifeFreq = 0).");
      continue;
    }
    const std::string life = desktop::pretty_quantity(*first, chart.panels[p].unit, 5);
    add_note(chart,
             facts.life_every
                 ? fmt::format("Fatigue life {} was computed only {} (kLifeFreq = 0). Loads after "
                               "that step are not included.",
                               life, start ? "at step 0" : "at a step before the first step shown")
                 : fmt::format("Fatigue life {} is constant in {}: it was computed once, and later "
                               "loads are not included.",
                               life, file.part ? "these steps" : "this file"));
  }
}

/// Temperatures that are not computed are input values of the deck.
void tell_temperatures(ChartPage& chart, const SolFile& file, const PageSpec& page,
                       const RunFacts& facts) {
  if (facts.temperatures_computed.value_or(false)) return;
  std::string names;
  for (std::size_t p = 0; p < page.panels.size(); ++p) {
    const std::string& column = page.panels[p].curves.front().column;
    const bool bulk = column.ends_with("_temperature") || column.starts_with("race.temperature");
    if (!bulk && !column.starts_with("contact.temperature.")) continue;
    for (const ChartCurve& curve : chart.panels[p].curves)
      if (has_number(curve.y) && !is_constant(curve.y, desktop::min_axis_span("K"))) return;
    if (std::none_of(chart.panels[p].curves.begin(), chart.panels[p].curves.end(),
                     [](const ChartCurve& curve) { return has_number(curve.y); }))
      continue;
    names = bulk ? "These temperatures" : "Race temperatures (without contact temperature rise)";
  }
  if (names.empty()) return;
  add_note(chart,
           names + (facts.temperatures_computed ? " are input values of the deck (kTherm = 0)."
                    : file.part                 ? " are constant at these steps."
                                : " are constant input values, not computed in this run."));
}

/// There is no average at time 0 (known_values.hpp): a note explains the missing value.
void tell_averages(ChartPage& chart, const SolFile& file, const PageSpec& page) {
  const bool averages =
      std::any_of(page.panels.begin(), page.panels.end(), [](const PanelSpec& panel) {
        return panel.curves.front().column.find("wear_rate") != std::string::npos;
      });
  if (averages && !(file.steps.front().time > 0.0))
    add_note(chart, fmt::format("Step {} has no average values because its time is 0.",
                                file.steps.front().step));
}

/// Angles of lands and round pockets have values without contact, too.
void tell_nearest(ChartPage& chart, const PageSpec& page) {
  for (std::size_t p = 1; p < page.panels.size(); ++p) {
    const std::string& column = page.panels[p].curves.front().column;
    if (!column.starts_with("pocket.theta.") &&
        !(column.starts_with("cage.land") && column.ends_with("_angle")))
      continue;
    for (const ChartCurve& angle : chart.panels[p].curves)
      for (const ChartCurve& force : chart.panels.front().curves)
        for (std::size_t i = 0; i < std::min(angle.y.size(), force.y.size()); ++i)
          if (std::isfinite(angle.y[i]) && force.y[i] == 0.0)
            return add_note(chart,
                            "Without contact, the contact angle is the angle of the smallest gap.");
  }
}

/// Explains the forces and moments of a race.
void tell_holding(ChartPage& chart, const SolFile& file, const PageSpec& page,
                  const RunFacts& facts) {
  const std::string& column = page.panels.front().curves.front().column;
  const bool moments = column.starts_with("race.applied_moment");
  if (!moments && !column.starts_with("race.applied_force")) return;
  if (file.kind == results::SolKind::Race)
    add_note(chart, prescribed_motion_note(ValidColumns(file), moments));
  else if (facts.races_held.value_or(false))
    add_note(chart,
             "Position and speed of the races are prescribed: the values are reactions, not loads "
             "of the deck.");
}

/// Speeds of outer and inner race [rpm], from the counted marks; no value for a varying speed.
std::optional<std::array<double, 2>> race_speeds(const SolFile& file, const PageContext& context) {
  constexpr double kSteady = 1e-3;
  const auto mark = [&context](std::string_view label) {
    const auto found = std::find_if(context.marks.begin(), context.marks.end(),
                                    [&](const MarkEventCounts& one) { return one.label == label; });
    return found == context.marks.end() ? nullptr : &*found;
  };
  const std::array<const MarkEventCounts*, 2> past{mark("BPFO"), mark("BPFI")};
  const MarkEventCounts* const orbit = mark("FTF");
  if (orbit == nullptr || past[0] == nullptr || past[1] == nullptr || orbit->time.size() < 2)
    return std::nullopt;
  const std::vector<double>& times = orbit->time;
  const double span = times.back() - times.front();
  if (!(span > 0.0) || file.header.elements < 1) return std::nullopt;
  // Elements pass a race as often as they orbit against it.
  const auto turned = [&](std::size_t race, std::size_t i) {
    return orbit->turns[i] - orbit->turns[0] -
           (past[race]->turns[i] - past[race]->turns[0]) / file.header.elements;
  };
  const std::size_t last = times.size() - 1;
  const std::array<double, 2> all{turned(0, last), turned(1, last)};
  const double least = kSteady * std::max(std::abs(all[0]), std::abs(all[1]));
  for (std::size_t race = 0; race < 2; ++race)
    for (std::size_t i = 0; i <= last; ++i)
      if (std::abs(turned(race, i) - all[race] * (times[i] - times.front()) / span) > least)
        return std::nullopt;
  return std::array{60.0 * all[0] / span, 60.0 * all[1] / span};
}

}  // namespace

std::string aliasing_note(const SolFile& file, const PageContext& context) {
  const double interval = alias_interval(file, context.fastest_frequency);
  if (!(interval > 0.0)) return {};
  const auto every = static_cast<double>(file.every);
  const std::string fastest = desktop::pretty_quantity(context.fastest_frequency, "Hz", 3),
                    rate = desktop::pretty_quantity(every / interval, "Hz", 3);
  if (file.every == 1)
    return fmt::format("Aliased: the fastest contact vibration is {}, but steps are stored at {}",
                       fastest, rate);
  return fmt::format(
      "Aliased: the fastest contact vibration is {}, but only one of every {} is drawn (rate {})",
      fastest, counted(file.every, "step"), rate);
}

void note_speed_ratios(ChartPage& chart, const SolFile& file, const PageSpec& page,
                       const PageContext& context) {
  for (const PanelSpec& panel : page.panels) {
    const std::string& column = panel.curves.front().column;
    if (column != "cage.whirl_ratio" && column != "cage.speed_ratio") continue;
    if (has_reversals(file)) {
      add_note(chart, panel.title + ": divided by a race speed that passes through 0.");
      continue;
    }
    const auto speeds = race_speeds(file, context);
    if (!speeds) {
      add_note(chart, panel.title + ": ratio to the speed of the faster race.");
      continue;
    }
    const bool outer = std::abs((*speeds)[0]) > std::abs((*speeds)[1]);
    add_note(chart, fmt::format("{}: ratio to the speed of the {} race, {} rpm.", panel.title,
                                outer ? "outer" : "inner",
                                desktop::pretty_number((*speeds)[outer ? 0 : 1], 4)));
  }
}

void note_missed_peaks(ChartPage& chart, const SolFile& file, const PageSpec& page,
                       const PageContext& context) {
  for (std::size_t p = 0; p < page.panels.size(); ++p) {
    if (!vibrates(page.panels[p].curves.front().column)) continue;
    const double least = 1e-3 * desktop::min_axis_span(chart.panels[p].unit);
    for (const ChartCurve& curve : chart.panels[p].curves)
      if (curve.low.empty() && has_number(curve.y) && !is_constant(curve.y, least))
        return add_note(chart,
                        desktop::coarse_storage_note(times_of(file), context.fastest_frequency,
                                                     file.every, !chart.band_note.empty()));
  }
}

void put_aliasing_note_first(ChartPage& chart, const SolFile& file, const PageContext& context) {
  const std::string aliased = aliasing_note(file, context);
  if (aliased.empty() || chart.panels.empty()) return;
  chart.note =
      aliased + "; higher frequencies appear as false lines below " +
      desktop::pretty_quantity(0.5 / alias_interval(file, context.fastest_frequency), "Hz", 3) +
      "." + (chart.note.empty() ? "" : " ") + chart.note;
}

void note_special_values(ChartPage& chart, const SolFile& file, const PageSpec& page,
                         const RunFacts& facts) {
  tell_zeros(chart);
  tell_life(chart, file, page, facts);
  tell_temperatures(chart, file, page, facts);
  tell_holding(chart, file, page, facts);
  tell_averages(chart, file, page);
  tell_nearest(chart, page);
  if (has_dots(chart)) add_note(chart, "Dots are single values between missing values.");
}

}  // namespace adore::adrplot
