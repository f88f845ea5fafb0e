#include "studies/charts.hpp"

#include "results/key_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::studies {
namespace {

Chart numbers(const std::vector<double>& values) {
  Chart out = Chart::array();
  for (const double value : values) out.push_back(std::isfinite(value) ? Chart(value) : Chart());
  return out;
}

Chart grid(const std::vector<std::vector<double>>& values) {
  Chart out = Chart::array();
  for (const auto& row : values) out.push_back(numbers(row));
  return out;
}

std::string words_of(const TableColumn& column) { return studies::words_of(column.name); }

std::string axis_heading(const TableColumn& column) {
  return column.unit.empty() || column.unit == "-"
             ? words_of(column)
             : fmt::format("{} [{}]", words_of(column), column.unit);
}

std::string unit(const TableColumn& column) { return column.unit == "-" ? "" : column.unit; }

}  // namespace

std::string words_of(const std::string& column) {
  const results::KeyResultSpec spec = results::find_key_result(column);
  if (spec.id.empty()) return column;
  return spec.part.empty() ? std::string(spec.label) : fmt::format("{}, {}", spec.label, spec.part);
}

Chart curves_chart(const std::string& name, const TableColumn& x, const TableColumn& y,
                   const std::vector<ChartLine>& lines) {
  Chart out{{"kind", "curves"},
            {"name", name},
            {"title", words_of(y) + " versus " + words_of(x)},
            {"x_title", words_of(x)},
            {"y_title", words_of(y)},
            {"x_unit", unit(x)},
            {"y_unit", unit(y)},
            {"curves", Chart::array()}};
  for (const ChartLine& line : lines)
    out["curves"].push_back({{"name", line.name},
                             {"x", numbers(line.x)},
                             {"y", numbers(line.y)},
                             {"low", numbers(line.low)},
                             {"high", numbers(line.high)},
                             {"runs", line.runs}});
  return out;
}

Chart heat_map(const std::string& name, const TableColumn& x, const TableColumn& y,
               const TableColumn& of, const std::vector<double>& xs, const std::vector<double>& ys,
               const std::vector<std::vector<double>>& values,
               const std::vector<std::vector<std::string>>& marks,
               const std::vector<std::vector<std::vector<long>>>& runs) {
  return {{"kind", "heat-map"},
          {"name", name},
          {"title", fmt::format("{} versus {} and {}", words_of(of), words_of(x), words_of(y))},
          {"x_title", axis_heading(x)},
          {"y_title", axis_heading(y)},
          {"legend", words_of(of)},
          {"unit", unit(of)},
          {"x", numbers(xs)},
          {"y", numbers(ys)},
          {"values", grid(values)},
          {"marks", marks},
          {"runs", runs}};
}

Chart parallel_chart(const std::string& name, const std::vector<const TableColumn*>& columns,
                     long heavy, const std::vector<long>& runs) {
  Chart out{{"kind", "parallel"}, {"name", name},           {"title", "All runs"},
            {"heavy", heavy},     {"axes", Chart::array()}, {"columns", Chart::array()}};
  out["runs"] = runs;
  for (const TableColumn* column : columns) {
    out["axes"].push_back(axis_heading(*column));
    out["columns"].push_back(numbers(column->values));
  }
  return out;
}

std::vector<const TableColumn*> parallel_chart_axes(const std::vector<TableColumn>& variables,
                                                    const std::vector<TableColumn>& quantities) {
  constexpr std::size_t kMaxAxes = 12;
  const auto varying = [](const std::vector<TableColumn>& of) {
    std::vector<const TableColumn*> out;
    for (const TableColumn& column : of) {
      double least = std::numeric_limits<double>::infinity(), most = -least;
      for (const double value : column.values) {  // comparisons leave NaN out
        if (value < least) least = value;
        if (value > most) most = value;
      }
      if (least < most) out.push_back(&column);
    }
    return out;
  };
  std::vector<const TableColumn*> out = varying(variables), last = varying(quantities);
  last.resize(
      std::min(last.size(), std::max(kMaxAxes / 2, kMaxAxes - std::min(kMaxAxes, out.size()))));
  out.resize(std::min(out.size(), kMaxAxes - last.size()));
  out.insert(out.end(), last.begin(), last.end());
  return out;
}

Chart tornado(const std::string& name, const std::string& title, const std::string& x_title,
              const std::vector<Bar>& bars) {
  Chart out{{"kind", "tornado"},
            {"name", name},
            {"title", title},
            {"x_title", x_title},
            {"bars", Chart::array()}};
  for (const Bar& bar : bars)
    if (std::isfinite(bar.value))
      out["bars"].push_back({{"name", bar.name},
                             {"value", bar.value},
                             {"doubt", std::isfinite(bar.doubt) ? bar.doubt : 0.0}});
  return out;
}

}  // namespace adore::studies
