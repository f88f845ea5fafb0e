#include "studies/report.hpp"

#include "base/atomic_file.hpp"
#include "base/counted.hpp"
#include "facade/prepare.hpp"
#include "studies/cage_whirl.hpp"
#include "studies/charts.hpp"
#include "studies/sensitivity.hpp"
#include "studies/static_sensitivity.hpp"
#include "studies/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace adore::studies {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kShownFailures = 5;

std::string file_name(std::string text) {
  for (char& c : text)
    if (c == '/' || c == ' ' || c == '[' || c == ']') c = '_';
  return text;
}

std::vector<double> sorted_values(const std::vector<double>& values) {
  const std::set<double> once(values.begin(), values.end());
  return {once.begin(), once.end()};
}

/// "-" of what there is none.
std::string number(double value, int digits = 5) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}g}", value, digits);
}

class Reporter {
 public:
  Reporter(const Study& study, const Results& results, const StudyTable& table)
      : study_(study), results_(results), table_(table) {
    for (const Variable& variable : study.variables)
      (variable.law == Law::Values ? grids_ : randoms_).push_back(&variable);
  }

  Report make() {
    head();
    switch (study_.kind) {
      case Kind::Sweep:
      case Kind::Tolerance:
        statistics();
        if (!grids_.empty()) over_grids();
        if (!randoms_.empty()) influence();
        parallel(-1);
        break;
      case Kind::CageMap:
        cage_map();
        break;
      case Kind::Sensitivity:
        for (std::size_t deck = 0; deck < study_.decks.size(); ++deck) sensitivity(deck);
        break;
      case Kind::WorstCase:
        worst_case();
        break;
      case Kind::WhatIf:
        what_if();
        break;
    }
    no_part();
    failures();
    return {text_, charts_.dump(1) + "\n"};
  }

 private:
  void head() {
    const auto count = [&](auto&& test) {
      return std::count_if(table_.exit.begin(), table_.exit.end(), test);
    };
    text_ += fmt::format("{}: {}, {}, {} done, {} failed, {} open\n\n",
                         study_.file.filename().string(), kind_name(study_.kind),
                         counted(table_.rows(), "run"), count([](long e) { return e == 0; }),
                         count([](long e) { return e > 0; }), count([](long e) { return e < 0; }));
  }

  /// What varies and acts on nothing.
  void no_part() {
    if (study_.kind == Kind::WhatIf) return;
    try {
      facade::DeckRequest request;
      request.deck = study_.decks.front();
      const Task& task = results_.tasks.at(results_.tasks.size() / 2);
      request.sets = study_.sets;
      request.sets.insert(request.sets.end(), task.point.sets.begin(), task.point.sets.end());
      for (const auto& none : facade::prepare(request).no_part)
        for (const TableColumn& column : table_.variables)
          if (none.variable == column.name)
            text_ +=
                fmt::format("note: {} varies and plays no part: {}\n", none.variable, none.because);
    } catch (const std::exception&) {
      // The runs say what is wrong.
    }
  }

  void failures() {
    std::size_t shown = 0;
    for (std::size_t i = 0; i < table_.rows(); ++i) {
      if (table_.exit[i] <= 0 || ++shown > kShownFailures) continue;
      text_ += fmt::format("run {} failed (exit {}): {}\n", table_.run[i], table_.exit[i],
                           table_.message[i]);
    }
    if (shown > kShownFailures)
      text_ += fmt::format("and {} more failed; RUNS.csv says why\n", shown - kShownFailures);
  }

  /// Rows where `variable` has that value, for every given pair.
  [[nodiscard]] std::vector<std::size_t> rows_at(
      const std::vector<std::pair<const TableColumn*, double>>& where) const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < table_.rows(); ++i)
      if (std::all_of(where.begin(), where.end(),
                      [&](const auto& pair) { return pair.first->values[i] == pair.second; }))
        out.push_back(i);
    return out;
  }
  [[nodiscard]] std::vector<long> numbers_of(const std::vector<std::size_t>& rows) const {
    std::vector<long> out;
    for (const std::size_t i : rows) out.push_back(table_.run[i]);
    return out;
  }
  static std::vector<double> picked(const TableColumn& column,
                                    const std::vector<std::size_t>& rows) {
    std::vector<double> out;
    for (const std::size_t i : rows) out.push_back(column.values[i]);
    return out;
  }

  void statistics() {
    text_ += fmt::format("{:<34} {:>6} {:>12} {:>12} {:>12} {:>12}", "quantity", "runs", "mean",
                         "deviation", "least", "largest");
    for (const double percent : study_.percentiles) text_ += fmt::format(" {:>11}%", percent);
    text_ += "\n";
    for (const TableColumn& column : table_.quantities) {
      const Summary summary = summarise(column.values, study_.percentiles);
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
      text_ += fmt::format("{:<34} {:>58}", "", "95 % certain between");
      for (const Percentile& p : summary.percentiles)
        text_ += fmt::format(" {:.5g}..{:.5g}", p.low, p.high);
      text_ += "\n";
      distribution(column);
    }
    text_ += "\n";
  }

  /// Share of the runs below each value.
  void distribution(const TableColumn& column) {
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
                                   {"share of the runs below", "", {}}, {line}));
  }

  static std::string label(const TableColumn& column) {
    return column.unit.empty() || column.unit == "-"
               ? column.name
               : fmt::format("{} [{}]", column.name, column.unit);
  }

  [[nodiscard]] const TableColumn& column_of(const Variable& variable) const {
    return *table_.find(variable.targets.front());
  }

  /// Curves over the first grid, one for each value of the second, bands where samples scatter.
  void over_grids() {
    const TableColumn& x = column_of(*grids_[0]);
    const TableColumn* second = grids_.size() > 1 ? &column_of(*grids_[1]) : nullptr;
    const std::vector<double> xs = sorted_values(x.values);
    const std::vector<double> others =
        second != nullptr ? sorted_values(second->values) : std::vector<double>{0.0};
    const bool band = !randoms_.empty() || grids_.size() > 2 || !study_.bearing_seeds.empty();
    for (const TableColumn& quantity : table_.quantities) {
      std::vector<ChartLine> lines;
      std::vector<std::vector<double>> map;
      std::vector<std::vector<std::vector<long>>> runs;
      if (band)
        text_ += fmt::format("{} over {}: {:g}, 50 and {:g} %\n", label(quantity), label(x),
                             study_.percentiles.front(), study_.percentiles.back());
      for (const double other : others) {
        ChartLine line;
        if (second != nullptr) line.name = fmt::format("{} = {:g}", second->name, other);
        for (const double at : xs) {
          std::vector<std::pair<const TableColumn*, double>> where{{&x, at}};
          if (second != nullptr) where.emplace_back(second, other);
          const std::vector<std::size_t> rows = rows_at(where);
          line.runs.push_back(numbers_of(rows));
          const Summary summary =
              summarise(picked(quantity, rows),
                        {study_.percentiles.front(), 50.0, study_.percentiles.back()});
          const auto value = [&](std::size_t k) {
            return summary.count > 0 ? summary.percentiles[k].value : kNone;
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
      if (second != nullptr && xs.size() > 1 && others.size() > 1)
        charts_.push_back(heat_map("map-" + file_name(quantity.name), x, *second, quantity, xs,
                                   others, map, {}, runs));
    }
    if (band) text_ += "\n";
  }

  /// Rows of each point of the grids: what scatters there, scatters there alone.
  [[nodiscard]] std::vector<std::vector<std::size_t>> grid_points() const {
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

  /// Rank correlation of what scatters with what comes of it, the mean over the points of the
  /// grids.
  void influence() {
    const auto groups = grid_points();
    text_ += "rank correlation (Spearman) of scatter and result:\n";
    for (const TableColumn& quantity : table_.quantities) {
      std::vector<Bar> bars;
      for (const Variable* variable : randoms_) {
        const TableColumn shown = shown_of(*variable);
        const std::vector<double>& values = shown.values;
        const std::string& name = shown.name;
        double sum = 0.0;
        int known = 0;  // a point whose runs all failed says nothing
        for (const auto& rows : groups) {
          const double one =
              rank_correlation(picked({{}, {}, values}, rows), picked(quantity, rows));
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
                                "what scatters: " + words_of(quantity.name), "rank correlation",
                                bars));
    }
    text_ += "\n";
  }

  /// Its column; of a lot the mean of its elements.
  [[nodiscard]] TableColumn shown_of(const Variable& variable) const {
    TableColumn out = column_of(variable);
    if (!variable.lot()) return out;
    const auto n = static_cast<double>(variable.targets.size());
    for (std::size_t k = 1; k < variable.targets.size(); ++k) {
      const std::vector<double>& more = table_.find(variable.targets[k])->values;
      for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] += more[i];
    }
    for (double& value : out.values) value /= n;
    out.name = variable.name + " (mean of the lot)";
    return out;
  }
  /// A lot has one axis.
  [[nodiscard]] std::vector<TableColumn> shown_variables() const {
    std::vector<TableColumn> out;
    for (const Variable& variable : study_.variables) out.push_back(shown_of(variable));
    if (const TableColumn* seeds = table_.find("seed")) out.push_back(*seeds);
    return out;
  }

  void parallel(long heavy) {
    const std::vector<TableColumn> variables = shown_variables();
    const std::vector<const TableColumn*> columns = axes_of(variables, table_.quantities);
    if (columns.size() > 2 && table_.rows() > 2)
      charts_.push_back(parallel_chart("parallel", columns, heavy, table_.run));
  }

  void cage_map() {
    const TableColumn &x = column_of(*grids_[0]), &y = column_of(*grids_[1]);
    const std::vector<double> xs = sorted_values(x.values), ys = sorted_values(y.values);
    const TableColumn& kind = *table_.find(std::string(kWhirlFigures[3]));
    std::vector<std::vector<std::string>> marks;
    for (const double b : ys) {
      marks.emplace_back();
      for (const double a : xs) {
        const auto rows = rows_at({{&x, a}, {&y, b}});
        const double of = rows.empty() ? kNone : kind.values[rows.front()];
        marks.back().emplace_back(std::isnan(of)
                                      ? "failed"
                                      : std::string(whirl_class_name(static_cast<WhirlClass>(
                                            static_cast<unsigned char>(std::lround(of))))));
      }
    }
    for (const TableColumn& quantity : table_.quantities) {
      if (&quantity == &kind) continue;
      std::vector<std::vector<double>> values;
      std::vector<std::vector<std::vector<long>>> runs;
      for (const double b : ys) {
        values.emplace_back();
        runs.emplace_back();
        for (const double a : xs) {
          const auto rows = rows_at({{&x, a}, {&y, b}});
          runs.back().push_back(numbers_of(rows));
          values.back().push_back(rows.empty() ? kNone : quantity.values[rows.front()]);
        }
      }
      charts_.push_back(
          heat_map("map-" + file_name(quantity.name), x, y, quantity, xs, ys, values, marks, runs));
      text_ +=
          fmt::format("{}, {} across, {} down\n{:>14}", label(quantity), label(x), label(y), "");
      for (const double a : xs) text_ += fmt::format(" {:>12g}", a);
      text_ += "\n";
      for (std::size_t j = ys.size(); j-- > 0;) {
        text_ += fmt::format("{:>14g}", ys[j]);
        for (const double value : values[j]) text_ += fmt::format(" {:>12}", number(value));
        text_ += "\n";
      }
    }
    text_ += fmt::format("class, {} across, {} down\n{:>14}", label(x), label(y), "");
    for (const double a : xs) text_ += fmt::format(" {:>12g}", a);
    text_ += "\n";
    for (std::size_t j = ys.size(); j-- > 0;) {
      text_ += fmt::format("{:>14g}", ys[j]);
      for (const std::string& mark : marks[j]) text_ += fmt::format(" {:>12}", mark);
      text_ += "\n";
    }
    text_ += fmt::format(
        "\nresting: the centre moves less than {:g} of the clearance about its mean place; "
        "whirling: more, with a deviation below {:g} of the whirl ratio; irregular: else. Judged "
        "over the second half of each run.\n\n",
        kRestingOrbit, kSteadyDeviation);
  }

  void sensitivity(std::size_t deck) {
    const std::size_t each = 1 + 4 * study_.variables.size(), from = deck * each;
    if (study_.decks.size() > 1) text_ += study_.decks[deck].filename().string() + "\n";
    StaticDerivatives exact;
    try {
      exact = static_derivatives(study_, deck);
    } catch (const std::exception& error) {
      text_ += fmt::format("no exact derivatives: {}\n", error.what());
    }
    const std::vector<BaseValue> bases = base_values(study_, deck);
    text_ += fmt::format("{:<34} {:<14} {:>13} {:>11} {:>13} {:>10} {:>11}\n", "quantity",
                         "variable", "by difference", "doubt", "exact", "differ", "% per %");
    for (const TableColumn& quantity : table_.quantities) {
      const double base = quantity.values[from];
      std::vector<Bar> bars;
      for (std::size_t v = 0; v < study_.variables.size(); ++v) {
        std::vector<double> f;
        for (std::size_t k = 0; k < 4; ++k) f.push_back(quantity.values[from + 1 + 4 * v + k]);
        const Derivative by = difference(f, bases[v].step);
        double known = kNone;
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
                             number(std::isfinite(relative) ? relative : kNone, 4));
        // A variable whose value is 0 has no percent: per step instead.
        const double scale =
            bases[v].value != 0.0 ? bases[v].value / base : 100.0 * bases[v].step / base;
        bars.push_back({study_.variables[v].name + (bases[v].value != 0.0 ? "" : " (per step)"),
                        value * scale, std::isnan(known) ? std::abs(by.doubt * scale) : 0.0});
      }
      charts_.push_back(tornado(
          fmt::format("tornado-{}{}", file_name(quantity.name),
                      study_.decks.size() > 1 ? fmt::format("-{}", deck + 1) : ""),
          "sensitivity: " + words_of(quantity.name), "percent of change for one percent", bars));
    }
    text_ += "\n";
  }

  void worst_case() {
    const TableColumn& objective = *table_.find(study_.objective);
    long best = -1;
    for (std::size_t i = 0; i < table_.rows(); ++i) {
      if (std::isnan(objective.values[i])) continue;
      if (best < 0 ||
          (study_.seek_largest
               ? objective.values[i] > objective.values[static_cast<std::size_t>(best)]
               : objective.values[i] < objective.values[static_cast<std::size_t>(best)]))
        best = static_cast<long>(i);
    }
    statistics();
    if (best < 0) {
      text_ += "no run has a value of the objective\n";
      return;
    }
    const auto row = static_cast<std::size_t>(best);
    text_ +=
        fmt::format("{} {} = {:.6g}, run {}, at\n", study_.seek_largest ? "largest" : "smallest",
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
    const std::vector<TableColumn> variables = shown_variables();
    std::vector<TableColumn> others;
    for (const TableColumn& column : table_.quantities)
      if (&column != &objective) others.push_back(column);
    std::vector<const TableColumn*> columns = axes_of(variables, others);
    columns.push_back(&objective);
    charts_.push_back(parallel_chart("parallel", columns, best, table_.run));
  }

  void what_if() {
    const std::size_t each = 1 + study_.cases.size();
    for (std::size_t deck = 0; deck < study_.decks.size(); ++deck) {
      const std::size_t base = deck * each;
      text_ += study_.decks[deck].filename().string() + "\n";
      const auto& own = results_.records[base];
      for (std::size_t k = 0; k < each; ++k) {
        const auto& record = results_.records[base + k];
        text_ +=
            fmt::format("  {:<28} {}\n", table_.label[base + k],
                        !record                  ? "not finished"
                        : record->exit_code != 0 ? "failed: " + record->message
                        : own && own->processor > 0.0
                            ? fmt::format("{:.3g} s of the processor, {:.2f} of the deck as it is",
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
                                  "what changes " + quantity.name, "change in percent", bars));
      }
      text_ += "\n";
    }
  }

  const Study& study_;
  const Results& results_;
  const StudyTable& table_;
  std::vector<const Variable*> grids_, randoms_;
  std::string text_;
  Chart charts_ = Chart::array();
};

}  // namespace

Report make_report(const Study& study, const Results& results, const StudyTable& table) {
  return Reporter(study, results, table).make();
}

Report write_report(const Study& study) {
  const Results results = read_results(study);
  const StudyTable table = write_tables(study, results);
  Report report = make_report(study, results, table);
  write_file_atomically(study.folder() / "REPORT.txt", report.text);
  write_file_atomically(study.folder() / "CHARTS.json", report.charts);
  return report;
}

}  // namespace adore::studies
