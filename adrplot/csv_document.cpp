#include "adrplot/csv_document.hpp"

#include "adrplot/domain_page.hpp"
#include "adrplot/known_values.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>

namespace adore::adrplot {
namespace {

constexpr std::size_t kMaxColumns = 4096;

std::vector<std::string> fields(const std::string& line, char separator) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      out.back() += line[i++];
    else if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      out.emplace_back();
    else if (c != '\r')
      out.back() += c;
  }
  return out;
}

char separator_of(const std::string& line) {
  for (const char c : {'\t', ';', ','})
    if (fields(line, c).size() > 1) return c;
  return ',';
}

double number(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  if (text.starts_with('+')) text.erase(0, 1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size() && !text.empty();
  return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

struct CsvColumn {
  std::string title, unit;
  std::vector<double> values;
};

struct Table {
  std::vector<CsvColumn> columns;
  std::size_t rejected = 0;  ///< rows of another length
};

CsvColumn heading(const std::string& text) {
  const std::size_t bracket = text.rfind(" [");
  if (bracket == std::string::npos || text.back() != ']') return {text, "", {}};
  return {text.substr(0, bracket), text.substr(bracket + 2, text.size() - bracket - 3), {}};
}

Table read_table(const std::filesystem::path& path) {
  std::istringstream file(read_text_file(path));
  std::string line;
  std::getline(file, line);
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // byte order mark
  const char separator = separator_of(line);
  const std::vector<std::string> first = fields(line, separator);
  const auto refuse = [&](const std::string& why) {
    return InputError(fmt::format(
        "{}: {}. Give a table of numbers with at least two columns and two rows, separated by "
        "commas, semicolons or tabs",
        path.string(), why));
  };
  if (first.size() < 2) throw refuse("the file has only one column");
  if (first.size() > kMaxColumns)
    throw refuse(fmt::format("the file has {} columns, but at most {} are possible", first.size(),
                             kMaxColumns));
  Table out;
  const bool numbers = std::all_of(first.begin(), first.end(), [](const std::string& text) {
    return std::isfinite(number(text));
  });
  for (std::size_t i = 0; i < first.size(); ++i) {
    out.columns.push_back(numbers ? CsvColumn{fmt::format("Column {}", i + 1), "", {}}
                                  : heading(first[i]));
    if (numbers) out.columns.back().values.push_back(number(first[i]));
  }
  while (std::getline(file, line)) {
    if (line.empty() || line == "\r") continue;
    const std::vector<std::string> row = fields(line, separator);
    if (row.size() != first.size()) {
      ++out.rejected;
      continue;
    }
    for (std::size_t i = 0; i < row.size(); ++i) out.columns[i].values.push_back(number(row[i]));
  }
  const auto many = std::count_if(out.columns.begin(), out.columns.end(), [](const CsvColumn& c) {
    return std::count_if(c.values.begin(), c.values.end(),
                         [](double v) { return std::isfinite(v); }) > 1;
  });
  if (many < 2) throw refuse("fewer than two columns contain numbers");
  return out;
}

/// The column with the abscissa.
std::size_t abscissa_of(const Table& table) {
  const auto named = [&](std::string_view word) {
    return std::find_if(table.columns.begin(), table.columns.end(),
                        [&](const CsvColumn& column) {
                          std::string text = column.title;
                          for (char& c : text)
                            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
                          return text.starts_with(word) && has_number(column.values);
                        }) -
           table.columns.begin();
  };
  for (const std::string_view word : {"time", "revolutions", "bearing rotation"})
    if (const auto at = named(word); at < std::ssize(table.columns))
      return static_cast<std::size_t>(at);
  return 0;
}

/// Speeds of a shaft [rev/s] per unit of a column; 0: the unit is no speed of rotation.
double turns_per_second(std::string unit) {
  for (char& c : unit) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return unit == "rpm" || unit == "1/min" || unit == "r/min" || unit == "rev/min" ? 1.0 / 60.0
         : unit == "rad/s" ? 0.5 / std::numbers::pi
                           : 0.0;
}

/// Revolutions of the shaft: the integral of the first column with a speed (trapezoidal rule).
RunMotion motion_of_table(const Table& table, std::size_t abscissa) {
  RunMotion out{table.columns[abscissa].values, {}};
  for (const CsvColumn& column : table.columns) {
    const double factor = turns_per_second(column.unit);
    if (factor == 0.0 || out.times.empty()) continue;
    out.turns = {0.0};
    for (std::size_t i = 1; i < out.times.size(); ++i)
      out.turns.push_back(out.turns.back() + 0.5 * factor * (out.times[i] - out.times[i - 1]) *
                                                 (column.values[i - 1] + column.values[i]));
    if (!std::isfinite(out.turns.back())) {  // the speed has gaps
      out.turns.clear();
      continue;
    }
    if (out.turns.back() < 0.0)
      for (double& turn : out.turns) turn = -turn;
    out.source = "column \"" + column.title + "\"";
    const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
    out.oscillates = *low < 0.0 && *high > 0.0;
    if (!out.oscillates) out.marks.push_back({"shaft", out.times, out.turns});
    break;
  }
  return out;
}

}  // namespace

PlotDocument open_csv(const std::filesystem::path& path) {
  const auto table = std::make_shared<const Table>(read_table(path));
  const std::size_t abscissa = abscissa_of(*table);
  const CsvColumn& x = table->columns[abscissa];
  const bool over_time = x.unit == "s";
  PlotDocument out;
  out.path = path;
  out.subject = "table";
  if (table->rejected > 0)
    out.note = counted(table->rejected, "row") + " left out (wrong number of fields)";
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table->columns.size(); ++i) {
    if (i == abscissa) continue;
    columns.push_back(i);
    out.pages.push_back({table->columns[i].title,
                         over_time ? PageKind::History : PageKind::Chart,
                         {table->columns[i].title},
                         {{""}}});
  }
  out.build = [path, table, columns, abscissa, over_time](int number, const PageOptions& options) {
    check_page_number(path, number, columns.size());
    const CsvColumn& across = table->columns[abscissa];
    const CsvColumn& column = table->columns[columns[static_cast<std::size_t>(number - 1)]];
    desktop::ChartPage chart;
    chart.title = column.title;
    chart.subtitle =
        fmt::format("{}   ·   page {} of {}", path.filename().string(), number, columns.size());
    chart.x = across.values;
    chart.x_title = over_time ? "Time" : across.title;
    chart.x_unit = across.unit;
    chart.panels.push_back({column.title, column.unit, {{"", column.values, {}}}, false});
    if (!has_number(column.values)) chart.panels.back().message = "This column has no numbers.";
    if (over_time) {
      show_domain(chart, motion_of_table(*table, abscissa), options);
      if (options.domain == Domain::History && options.abscissa != Abscissa::Time)
        add_note(chart, "A table has no revolutions, so the abscissa is time.");
    }
    return chart;
  };
  if (over_time) out.motion = [table, abscissa] { return motion_of_table(*table, abscissa); };
  return out;
}

}  // namespace adore::adrplot
