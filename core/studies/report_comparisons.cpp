#include "studies/reporter.hpp"
#include "studies/sensitivity.hpp"
#include "studies/static_sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// Sensitivities, worst cases and what-if: runs that are compared with one of them.
namespace adore::studies {

void Reporter::sensitivity(std::size_t deck) {
  const std::size_t each = 1 + 4 * study_.variables.size(), from = deck * each;
  if (study_.decks.size() > 1) text_ += study_.decks[deck].filename().string() + "\n";
  StaticDerivatives exact;
  try {
    exact = static_derivatives(study_, deck);
  } catch (const std::exception& error) {
    text_ += fmt::format("exact derivatives are not available: {}\n", error.what());
  }
  const std::vector<BaseValue> bases = base_values(study_, deck);
  text_ += fmt::format("{:<34} {:<14} {:>13} {:>11} {:>13} {:>10} {:>11}\n", "quantity", "variable",
                       "finite diff.", "uncertainty", "exact", "rel. diff.", "% per %");
  for (const TableColumn& quantity : table_.quantities) {
    const double base = quantity.values[from];
    std::vector<Bar> bars;
    for (std::size_t v = 0; v < study_.variables.size(); ++v) {
      std::vector<double> f;
      for (std::size_t k = 0; k < 4; ++k) f.push_back(quantity.values[from + 1 + 4 * v + k]);
      const Derivative by = difference(f, bases[v].step);
      double known = kNaN;
      if (v < exact.size())
        if (const auto found = exact[v].find(quantity.name); found != exact[v].end())
          known = found->second;
      const double value = std::isnan(known) ? by.value : known;
      const double relative = value * bases[v].value / base;
      text_ += fmt::format("{:<34} {:<14} {:>13} {:>11} {:>13} {:>10} {:>11}\n", label(quantity),
                           study_.variables[v].name, number(by.value, 6), number(by.doubt, 2),
                           number(known, 6),
                           number(std::abs(known - by.value) /
                                      std::max({std::abs(known), std::abs(by.value), 1e-300}),
                                  2),
                           number(std::isfinite(relative) ? relative : kNaN, 4));
      // A variable whose value is 0 has no percent: per step instead.
      const double scale =
          bases[v].value != 0.0 ? bases[v].value / base : 100.0 * bases[v].step / base;
      bars.push_back({study_.variables[v].name + (bases[v].value != 0.0 ? "" : " (per step)"),
                      value * scale, std::isnan(known) ? std::abs(by.doubt * scale) : 0.0});
    }
    charts_.push_back(
        tornado(fmt::format("tornado-{}{}", file_name(quantity.name),
                            study_.decks.size() > 1 ? fmt::format("-{}", deck + 1) : ""),
                "Sensitivity: " + words_of(quantity.name),
                "change in percent for a change of the variable by 1 %", bars));
  }
  text_ += "\n";
}

void Reporter::add_worst_case() {
  const TableColumn& objective = *table_.find(study_.objective);
  long best = -1;
  for (std::size_t i = 0; i < table_.rows(); ++i) {
    if (std::isnan(objective.values[i])) continue;
    if (best < 0 || (study_.seek_largest
                         ? objective.values[i] > objective.values[static_cast<std::size_t>(best)]
                         : objective.values[i] < objective.values[static_cast<std::size_t>(best)]))
      best = static_cast<long>(i);
  }
  statistics();
  if (best < 0) {
    text_ += "no run has a value for the objective of the study\n";
    return;
  }
  const auto row = static_cast<std::size_t>(best);
  text_ +=
      fmt::format("{} {} = {:.6g} in run {} with\n", study_.seek_largest ? "largest" : "smallest",
                  label(objective), objective.values[row], table_.run[row]);
  std::size_t at = 0;
  for (const Variable& variable : study_.variables)
    for (const std::string& target : variable.targets) {
      const double value = table_.variables[at++].values[row];
      text_ += fmt::format("  {:<24} {:>14.8g}{}\n", target, value,
                           value == variable.a   ? "  (lower end of its range)"
                           : value == variable.b ? "  (upper end of its range)"
                                                 : "");
    }
  text_ += "\n";
  // The objective last: lines are coloured by it.
  const std::vector<TableColumn> variables = display_columns();
  std::vector<TableColumn> others;
  for (const TableColumn& column : table_.quantities)
    if (&column != &objective) others.push_back(column);
  std::vector<const TableColumn*> columns = parallel_chart_axes(variables, others);
  columns.push_back(&objective);
  charts_.push_back(parallel_chart("parallel", columns, best, table_.run));
}

void Reporter::add_what_if() {
  const std::size_t each = 1 + study_.cases.size();
  for (std::size_t deck = 0; deck < study_.decks.size(); ++deck) {
    const std::size_t base = deck * each;
    text_ += study_.decks[deck].filename().string() + "\n";
    const auto& own = results_.records[base];
    for (std::size_t k = 0; k < each; ++k) {
      const auto& record = results_.records[base + k];
      text_ += fmt::format(
          "  {:<28} {}\n", table_.label[base + k],
          !record                  ? "not finished"
          : record->exit_code != 0 ? "failed: " + record->message
          : own && own->processor > 0.0
              ? fmt::format("{:.3g} s processor time, {:.2f} times that of the original deck",
                            record->processor, record->processor / own->processor)
              : "");
      if (!record || record->exit_code != 0) continue;
      for (const TableColumn& quantity : table_.quantities) {
        const double value = quantity.values[base + k], was = quantity.values[base];
        text_ += fmt::format("    {:<34} {:>13.6g}{}\n", label(quantity), value,
                             k == 0 || was == 0.0 || !std::isfinite(value / was)
                                 ? ""
                                 : fmt::format("  {:+.3g} %", 100.0 * (value / was - 1.0)));
      }
    }
    for (const TableColumn& quantity : table_.quantities) {
      std::vector<Bar> bars;
      for (std::size_t k = 1; k < each; ++k)
        bars.push_back({table_.label[base + k],
                        100.0 * (quantity.values[base + k] / quantity.values[base] - 1.0), 0.0});
      charts_.push_back(tornado(fmt::format("what-if-{}-{}", deck + 1, file_name(quantity.name)),
                                "change of " + quantity.name, "change in percent", bars));
    }
    text_ += "\n";
  }
}

}  // namespace adore::studies
