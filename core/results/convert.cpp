#include "results/convert.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/own_files.hpp"
#include "base/terminal_text.hpp"
#include "results/restart.hpp"
#include "results/sol_file.hpp"
#include "results/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <ostream>

namespace adore::results {
namespace {

using Json = nlohmann::ordered_json;

std::string first_bytes(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw InputError(fmt::format("{}: this is a folder; give a result file in it", path.string()));
  InputFile stream(path);
  if (!stream)
    throw InputError(fmt::format("{}: the file cannot be opened; check its name and permissions",
                                 path.string()));
  std::string bytes(256, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

ResultTable table_of(const std::filesystem::path& path, FileKind kind) {
  return kind == FileKind::ResultsH5 ? results_h5_table(path) : sol_table(path);
}

Json read_run_json(const std::filesystem::path& path) {
  return parse_json<Json>(read_text_file(path), path.string());
}

Json to_json(const FinalState& state) {
  Json components = Json::object();
  for (std::size_t i = 0; i < state.state.size(); ++i)
    components[state.components[i]] = state.state[i];
  return {{"version", state.version},
          {"run", state.run_id},
          {"step", state.step},
          {"time", state.time},
          {"step_size", state.step_size},
          {"shaft_rotation", state.shaft_rotation},
          {"scales",
           {{"length", state.scales.length},
            {"force", state.scales.force},
            {"time", state.scales.time}}},
          {"extras", state.extras},
          {"state", components},
          {"deck", state.deck}};
}

Json to_json(const MasterState& state) {
  Json out = to_json(state.last);
  out["averages"] = state.averages;
  out["files"] = Json::array();
  for (const MasterFileEntry& file : state.files)
    out["files"].push_back({{"role", file.role}, {"name", file.name}, {"bytes", file.bytes}});
  return out;
}

/// A number in JSON and CSV: shortest text that reads back to the same value; `missing` where there
/// is none.
std::string number(double value, std::string_view missing) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string(missing);
}

/// RFC 4180, with control characters made visible.
std::string csv_text(const std::string& raw) {
  const std::string text = escape_for_terminal(raw);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

/// @returns the note of the table
std::string write_csv(const ResultTable& table, std::ostream& out) {
  std::string line;
  for (const TableColumn& column : table.columns) {
    if (!line.empty()) line += ',';
    line +=
        csv_text(column.unit.empty() ? column.id : fmt::format("{} [{}]", column.id, column.unit));
  }
  out << line << '\n';
  std::vector<double> row;
  while (table.next(row)) {
    line.clear();
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) line += ',';
      line += number(row[k], "");
    }
    out << line << '\n';
  }
  return table.note();
}

/// Likewise.
std::string write_json(const ResultTable& table, std::ostream& out) {
  Json header = Json::object(), columns = Json::array();
  for (const auto& [name, value] : table.header) header[name] = value;
  for (const TableColumn& column : table.columns)
    columns.push_back({{"id", column.id}, {"label", column.label}, {"unit", column.unit}});
  const auto text = [](const Json& json) { return dump_json(json); };
  out << "{\"header\":" << text(header) << ",\n\"columns\":" << text(columns) << ",\n\"steps\":[";
  std::vector<double> row;
  std::string line;
  for (bool first = true; table.next(row); first = false) {
    line = first ? "\n[" : ",\n[";
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) line += ',';
      line += number(row[k], "null");
    }
    out << line << ']';
  }
  std::string note = table.note();
  out << "],\n\"note\":" << text(Json(note)) << "}\n";
  return note;
}

void write_leaves(const Json& json, const std::string& path, std::ostream& out) {
  if (json.is_structured() && !json.empty()) {
    std::size_t index = 0;
    for (const auto& [key, value] : json.items()) {
      const std::string name = json.is_array() ? std::to_string(++index) : key;
      write_leaves(value, path.empty() ? name : path + "." + name, out);
    }
    return;
  }
  out << csv_text(path) << ','
      << csv_text(json.is_string() ? json.get<std::string>() : dump_json(json)) << '\n';
}

void add_line(std::string& out, std::string_view name, std::string_view value) {
  out += fmt::format("{:<26} {}\n", name, value);
}

/// Number of complete steps, and the range of each column; not-a-numbers are passed over.
struct TableRanges {
  explicit TableRanges(ResultTable& table) : ranges(table.columns.size(), {kInfinity, -kInfinity}) {
    std::vector<double> row;
    for (; table.next(row); ++steps)
      for (std::size_t k = 0; k < row.size(); ++k) {
        if (row[k] < ranges[k][0]) ranges[k][0] = row[k];
        if (row[k] > ranges[k][1]) ranges[k][1] = row[k];
      }
  }
  [[nodiscard]] bool any(std::size_t column) const {
    return ranges[column][0] <= ranges[column][1];
  }
  std::vector<std::array<double, 2>> ranges;
  long steps = 0;
};

std::string describe(ResultTable table, const std::filesystem::path& path) {
  std::string out;
  add_line(out, "file", path.string());
  for (const auto& [name, value] : table.header) add_line(out, name, value);
  const TableRanges found(table);
  add_line(out, "complete steps", std::to_string(found.steps));
  if (const std::string note = table.note(); !note.empty()) add_line(out, "note", note);
  if (found.steps == 0) return out;
  out += fmt::format("\n{:>5} {:<48} {:<10} {:>15} {:>15}  {}\n", "No", "channel", "unit", "least",
                     "largest", "id");
  int number_in_file = 0;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const TableColumn& column = table.columns[k];
    const auto shown = [&](double value) {
      return found.any(k) ? fmt::format("{:.7g}", value) : std::string("-");
    };
    // The columns of the step line have no separate number.
    const bool step_line = column.id == "step" || column.id == "revolutions" ||
                           column.id == "element_revolutions" || column.id == "step_size" ||
                           column.id == "time" || column.id == "shaft_rotation";
    out +=
        fmt::format("{:>5} {:<48} {:<10} {:>15} {:>15}  {}\n",
                    step_line ? std::string() : std::to_string(++number_in_file), column.label,
                    column.unit, shown(found.ranges[k][0]), shown(found.ranges[k][1]), column.id);
  }
  return out;
}

Json describe_json(ResultTable table, const std::filesystem::path& path) {
  Json out{{"file", path.string()}};
  for (const auto& [name, value] : table.header) out[name] = value;
  const TableRanges found(table);
  out["complete steps"] = found.steps;
  if (const std::string note = table.note(); !note.empty()) out["note"] = note;
  out["channels"] = Json::array();
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const TableColumn& column = table.columns[k];
    const auto shown = [&](double value) { return found.any(k) ? Json(value) : Json(); };
    out["channels"].push_back({{"id", column.id},
                               {"label", column.label},
                               {"unit", column.unit},
                               {"least", shown(found.ranges[k][0])},
                               {"largest", shown(found.ranges[k][1])}});
  }
  return out;
}

std::string describe(const FinalState& state, std::string_view kind,
                     const std::filesystem::path& path) {
  std::string out;
  add_line(out, "file", path.string());
  add_line(out, "kind", kind);
  add_line(out, "program", state.version);
  add_line(out, "run", state.run_id);
  add_line(out, "step", std::to_string(state.step));
  add_line(out, "time", fmt::format("{} s", state.time));
  add_line(out, "last step size", fmt::format("{} s", state.step_size));
  add_line(out, "shaft rotation", fmt::format("{} rad", state.shaft_rotation));
  add_line(out, "scale of length", fmt::format("{} m", state.scales.length));
  add_line(out, "scale of force", fmt::format("{} N", state.scales.force));
  add_line(out, "scale of time", fmt::format("{} s", state.scales.time));
  for (const auto& [name, value] : state.extras) add_line(out, name, fmt::format("{}", value));
  add_line(out, "state components", std::to_string(state.state.size()));
  for (std::size_t i = 0; i < state.state.size(); ++i)
    out += fmt::format("{:>5} {:<48} {}\n", i + 1, state.components[i], state.state[i]);
  return out;
}

}  // namespace

FileKind file_kind(const std::filesystem::path& path) {
  const std::string bytes = first_bytes(path);
  const AdoreFileType sort = detect_file_type(bytes);
  if (sort == AdoreFileType::Deck || sort == AdoreFileType::Listing ||
      sort == AdoreFileType::SweepTable)
    throw InputError(fmt::format("{}: this is {}, not a result file that can be displayed; {}",
                                 path.string(), describe_file_type(sort),
                                 file_type_usage_hint(sort)));
  if (bytes.substr(0, 4) == "\x89HDF") return FileKind::ResultsH5;
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start != std::string::npos && bytes[start] == '{') return FileKind::RunJson;
  const std::string line = bytes.substr(0, bytes.find('\n'));
  if (line.find("FINAL: ") != std::string::npos) return FileKind::Final;
  if (line.find("MASTER: ") != std::string::npos) return FileKind::Master;
  return sol_kind(path) == SolKind::Animation ? FileKind::Animation : FileKind::Sol;
}

std::string describe_file(const std::filesystem::path& path) {
  switch (const FileKind kind = file_kind(path)) {
    case FileKind::Final:
      return describe(read_final(path), "last solution vector (FINAL)", path);
    case FileKind::Master: {
      const MasterState state = read_master(path);
      std::string out = describe(state.last, "bookkeeping of a run (MASTER)", path);
      for (const auto& [name, value] : state.averages)
        add_line(out, name, fmt::format("{}", value));
      for (const MasterFileEntry& file : state.files)
        add_line(out, "file " + file.role, fmt::format("{} ({} bytes)", file.name, file.bytes));
      return out;
    }
    case FileKind::RunJson:
      return dump_json(read_run_json(path), 2) + "\n";
    default:
      return describe(table_of(path, kind), path);
  }
}

std::string describe_file_json(const std::filesystem::path& path) {
  const FileKind kind = file_kind(path);
  Json out;
  if (kind == FileKind::Final)
    out = to_json(read_final(path));
  else if (kind == FileKind::Master)
    out = to_json(read_master(path));
  else if (kind == FileKind::RunJson)
    out = read_run_json(path);
  else
    out = describe_json(table_of(path, kind), path);
  return dump_json(out, 2) + "\n";
}

std::string convert_file(const std::filesystem::path& path, std::string_view format,
                         std::ostream& out) {
  const bool csv = format == "csv";
  if (!csv && format != "json")
    throw InputError(fmt::format(
        "a result file cannot be converted to '{}'; the possible formats are csv and json",
        format));
  const FileKind kind = file_kind(path);
  std::string note;
  if (kind == FileKind::Final || kind == FileKind::Master || kind == FileKind::RunJson) {
    const Json json = kind == FileKind::Final    ? to_json(read_final(path))
                      : kind == FileKind::Master ? to_json(read_master(path))
                                                 : read_run_json(path);
    if (csv) {
      out << "name,value\n";
      write_leaves(json, {}, out);
    } else {
      out << dump_json(json, 2) << '\n';
    }
  } else if (csv) {
    note = write_csv(table_of(path, kind), out);
  } else {
    note = write_json(table_of(path, kind), out);
  }
  if (!out)
    throw InputError(
        fmt::format("{}: the output of the conversion cannot be written; free some disk space or "
                    "choose another file",
                    path.string()));
  return note;
}

}  // namespace adore::results
