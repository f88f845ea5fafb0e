#include "studies/reporter.hpp"
#include "studies/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

/// Sweeps and tolerances: statistics, curves over what is varied, and what scatters.
namespace adore::studies {

void Reporter::statistics() {
  text_ += fmt::format("{:<34} {:>6} {:>12} {:>12} {:>12} {:>12}", "quantity", "runs", "mean",
                       "std. dev.", "least", "largest");
  for (const double percent : study_.percentiles) text_ += fmt::format(" {:>11}%", percent);
  text_ += "\n";
  for (const TableColumn& column : table_.quantities) {
    const Summary summary = summarize(column.values, study_.percentiles);
    text_ += fmt::format("{:<34} {:>6}", label(column), summary.count);
    if (summary.count == 0) {
      text_ += "  no run has a value\n";
      continue;
    }
    text_ += fmt::format(" {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g}", summary.mean,
                         summary.deviation, summary.least, summary.largest);
    for (const Percentile& p : summary.percentiles) text_ += fmt::format(" {:>12.5g}", p.value);
    if (summary.infinite > 0) text_ += fmt::format("  ({} infinite)", summary.infinite);
    text_ += "\n";
    if (study_.kind != Kind::Tolerance || !grids_.empty()) continue;
    text_ += fmt::format("{:<34} {:>58}", "", "95 % confidence limits");
    for (const Percentile& p : summary.percentiles)
      text_ += fmt::format(" {:.5g}..{:.5g}", p.low, p.high);
    text_ += "\n";
    distribution(column);
  }
  text_ += "\n";
}

void Reporter::distribution(const TableColumn& column) {
  std::vector<std::pair<double, long>> values;
  for (std::size_t i = 0; i < table_.rows(); ++i)
    if (std::isfinite(column.values[i])) values.emplace_back(column.values[i], table_.run[i]);
  std::sort(values.begin(), values.end());
  ChartLine line;
  for (std::size_t i = 0; i < values.size(); ++i) {
    line.x.push_back(values[i].first);
    line.runs.push_back({values[i].second});
    line.y.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(values.size()));
  }
  charts_.push_back(curves_chart("distribution-" + file_name(column.name), column,
                                 {"fraction of the runs with a smaller value", "", {}}, {line}));
}

void Reporter::add_grid_curves() {
  const TableColumn& x = column_of(*grids_[0]);
  const TableColumn* second = grids_.size() > 1 ? &column_of(*grids_[1]) : nullptr;
  const std::vector<double> xs = sorted_unique_values(x.values);
  const std::vector<double> others =
      second != nullptr ? sorted_unique_values(second->values) : std::vector<double>{0.0};
  const bool band =
      !random_variables_.empty() || grids_.size() > 2 || !study_.bearing_seeds.empty();
  for (const TableColumn& quantity : table_.quantities) {
    std::vector<ChartLine> lines;
    std::vector<std::vector<double>> map;
    std::vector<std::vector<std::vector<long>>> runs;
    if (band)
      text_ += fmt::format("{} versus {}: percentiles {:g}, 50 and {:g} %\n", label(quantity),
                           label(x), study_.percentiles.front(), study_.percentiles.back());
    for (const double other : others) {
      ChartLine line;
      if (second != nullptr)
        line.name =
            fmt::format("{} = {:g}{}", second->name, other,
                        second->unit.empty() || second->unit == "-" ? "" : " " + second->unit);
      for (const double at : xs) {
        std::vector<std::pair<const TableColumn*, double>> where{{&x, at}};
        if (second != nullptr) where.emplace_back(second, other);
        const std::vector<std::size_t> rows = rows_with_values(where);
        line.runs.push_back(run_numbers(rows));
        const Summary summary =
            summarize(values_at_rows(quantity, rows),
                      {study_.percentiles.front(), 50.0, study_.percentiles.back()});
        const auto value = [&](std::size_t k) {
          return summary.count > 0 ? summary.percentiles[k].value : kNaN;
        };
        line.x.push_back(at);
        line.y.push_back(value(1));
        if (!band) continue;
        line.low.push_back(value(0));
        line.high.push_back(value(2));
        text_ += fmt::format("  {:>12g}{} {:>12} {:>12} {:>12}\n", at,
                             second != nullptr ? fmt::format(" {:>12g}", other) : "",
                             number(value(0)), number(value(1)), number(value(2)));
      }
      map.push_back(line.y);
      runs.push_back(line.runs);
      lines.push_back(std::move(line));
    }
    charts_.push_back(curves_chart("curves-" + file_name(quantity.name), x, quantity, lines));
    if (band)
      charts_.back()["title"] = fmt::format("{}: median, {:g} to {:g} % of the runs",
                                            charts_.back()["title"].get<std::string>(),
                                            study_.percentiles.front(), study_.percentiles.back());
    if (second != nullptr && xs.size() > 1 && others.size() > 1)
      charts_.push_back(heat_map("map-" + file_name(quantity.name), x, *second, quantity, xs,
                                 others, map, {}, runs));
  }
  if (band) text_ += "\n";
}

std::vector<std::vector<std::size_t>> Reporter::rows_by_grid_point() const {
  std::map<std::vector<double>, std::vector<std::size_t>> out;
  for (std::size_t i = 0; i < table_.rows(); ++i) {
    std::vector<double> at;
    for (const Variable* variable : grids_) at.push_back(column_of(*variable).values[i]);
    if (!table_.deck.empty()) at.push_back(static_cast<double>(results_.tasks[i].point.deck));
    out[at].push_back(i);
  }
  std::vector<std::vector<std::size_t>> rows;
  for (auto& [at, of] : out) rows.push_back(std::move(of));
  return rows;
}

void Reporter::influence() {
  const auto groups = rows_by_grid_point();
  text_ += "rank correlation (Spearman) of each quantity with the random variables:\n";
  for (const TableColumn& quantity : table_.quantities) {
    std::vector<Bar> bars;
    for (const Variable* variable : random_variables_) {
      const TableColumn shown = display_column(*variable);
      const std::vector<double>& values = shown.values;
      const std::string& name = shown.name;
      double sum = 0.0;
      int known = 0;  // a point whose runs all failed gives no information
      for (const auto& rows : groups) {
        const double one = rank_correlation(values_at_rows({{}, {}, values}, rows),
                                            values_at_rows(quantity, rows));
        if (std::isnan(one)) continue;
        sum += one;
        ++known;
      }
      if (known > 0) bars.push_back({name, sum / known, 0.0});
    }
    std::stable_sort(bars.begin(), bars.end(), [](const Bar& a, const Bar& b) {
      return std::abs(a.value) > std::abs(b.value);
    });
    text_ += fmt::format("  {}:", quantity.name);
    for (const Bar& bar : bars) text_ += fmt::format("  {} {:.2f}", bar.name, bar.value);
    text_ += bars.empty() ? "  too few results\n" : "\n";
    if (bars.empty()) continue;
    charts_.push_back(tornado("influence-" + file_name(quantity.name),
                              "Sources of scatter: " + words_of(quantity.name), "rank correlation",
                              bars));
  }
  text_ += "\n";
}

}  // namespace adore::studies
