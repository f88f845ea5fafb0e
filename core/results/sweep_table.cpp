#include "results/sweep_table.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "results/key_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string_view>

namespace adore::results {
namespace {

std::vector<std::string_view> fields(std::string_view line) {
  std::vector<std::string_view> out;
  while (true) {
    const std::size_t comma = line.find(',');
    out.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return out;
    line.remove_prefix(comma + 1);
  }
}

double number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value)
             ? value
             : std::numeric_limits<double>::quiet_NaN();
}

bool is_heading(const std::vector<std::string_view>& names) {
  return names.size() >= 3 && names[1] == "exit" && names.back() == "message";
}

}  // namespace

bool is_sweep(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return is_heading(fields(line));
}

SweepTable read_sweep(const std::filesystem::path& path) {
  std::istringstream file(read_text_file(path));
  std::string line;
  std::getline(file, line);
  const std::vector<std::string_view> names = fields(line);
  if (!is_heading(names))
    throw InputError(fmt::format("{} is not a table of `adore run --set variable=first:last:count`",
                                 path.string()));
  if (names.size() > kMaxTableColumns)
    throw InputError(
        fmt::format("{}: {} columns are too many for a table of runs (at most {}); "
                    "give a table of `adore run --set variable=first:last:count`",
                    path.string(), names.size(), kMaxTableColumns));
  SweepTable out;
  out.variable = names.front();
  if (const std::size_t bracket = out.variable.find(" [");
      bracket != std::string::npos && out.variable.back() == ']') {
    out.unit = out.variable.substr(bracket + 2, out.variable.size() - bracket - 3);
    out.variable.resize(bracket);
  }
  const bool motion = std::find(names.begin(), names.end(), "peak_load_N") != names.end();
  for (std::size_t i = 2; i + 1 < names.size(); ++i) {
    const KeyResultSpec spec = find_key_result(names[i]);
    if (spec.id.empty())
      out.columns.push_back({std::string(names[i]), {}, {}, {}});
    else
      out.columns.push_back({std::string(label_of(spec, motion)),
                             std::string(spec.part),
                             std::string(spec.unit->si),
                             {}});
  }
  std::string row;
  while (std::getline(file, row)) {
    // The message comes last and may hold commas, so it is cut off first.
    const std::vector<std::string_view> values =
        fields(std::string_view(row).substr(0, row.find(",\"")));
    if (values.size() != names.size() - 1) continue;  // a line cut short
    out.values.push_back(number(values[0]));
    if (values[1] != "0") ++out.failed;
    for (std::size_t i = 0; i < out.columns.size(); ++i)
      out.columns[i].values.push_back(number(values[i + 2]));
  }
  if (out.values.empty())
    throw InputError(fmt::format(
        "{}: this table of runs has no complete row, so nothing can be drawn", path.string()));
  return out;
}

}  // namespace adore::results
