#include "studies/study_table_read.hpp"

#include "base/constants.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "deck/schema.hpp"
#include "results/h5_process.hpp"
#include "setup/run_control.hpp"
#include "studies/charts.hpp"
#include "studies/statistics.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace adore::studies {
namespace fs = std::filesystem;
namespace {

std::string not_a_table_text(const std::string& why) {
  return fmt::format(
      "this is not a table of `adore study`: {}; give the RUNS.csv or STUDY.h5 of a study, or the "
      "folder of the study",
      why);
}

[[noreturn]] void fail_not_a_table(const fs::path& file, const std::string& why) {
  throw InputError(fmt::format("{}: {}", file.string(), not_a_table_text(why)));
}

/// Fields of one line without their quotes, and one more than `most` where it has more.
std::vector<std::string> fields_of(const std::string& line, std::size_t most) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
      out.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted) {
      if (out.size() > most) break;
      out.emplace_back();
    } else if (c != '\r')
      out.back() += c;
  }
  return out;
}

/// A whole number from 0 to kMaxStudyRuns; else -1.
long whole_of(const std::string& text) {
  long value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value <= kMaxStudyRuns ? value
                                                                                            : -1;
}

double number_of(const std::string& text) {
  double value = kNaN;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : kNaN;
}

bool is_varied(const std::string& name) {
  const std::string bare = name.substr(0, name.find('['));
  if (!deck::find_variable(bare).empty()) return true;
  const auto& options = setup::run_option_list();
  return std::any_of(options.begin(), options.end(),
                     [&](const auto& option) { return option.name == bare; });
}

TableColumn column_of(const std::string& heading) {
  const std::size_t bracket = heading.rfind(" [");
  if (bracket == std::string::npos || !heading.ends_with(']')) return {heading, "", {}};
  return {
      heading.substr(0, bracket), heading.substr(bracket + 2, heading.size() - bracket - 3), {}};
}

StudyTable read_csv(const fs::path& file) {
  const std::string text = read_text_file(file, kMaxStudyTableBytes);
  StudyTable out;
  std::vector<std::string> head;
  // Target of a column's values: run, exit, deck, case, message, or a number of a column.
  std::vector<TableColumn*> places;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::vector<std::string> fields =
        fields_of(text.substr(from, end - from), head.empty() ? kMaxTableColumns : head.size());
    from = end + 1;
    if (head.empty()) {
      head = fields;
      if (head.size() < 3 || head[0] != "run" || head[1] != "exit" || head.back() != "message")
        fail_not_a_table(file, "the first line is not the heading \"run,exit,...,message\"");
      if (head.size() > kMaxTableColumns)
        fail_not_a_table(file, fmt::format("it has more than {} columns", kMaxTableColumns));
      out.variables.reserve(head.size());
      out.quantities.reserve(head.size());
      for (const std::string& heading : head) {
        places.push_back(nullptr);
        if (heading == "run" || heading == "exit" || heading == "message" || heading == "deck" ||
            heading == "case") {
          if (std::count(head.begin(), head.end(), heading) > 1)
            fail_not_a_table(file, fmt::format("its first line has {} twice", heading));
          continue;
        }
        TableColumn column = column_of(heading);
        auto& group = is_varied(column.name) ? out.variables : out.quantities;
        group.push_back(std::move(column));
        places.back() = &group.back();
      }
      continue;
    }
    if (fields.size() != head.size())
      fail_not_a_table(file, fmt::format("line {} does not have {}, as the first line does",
                                         out.rows() + 2, counted(head.size(), "field")));
    if (out.rows() >= static_cast<std::size_t>(kMaxStudyRuns))
      fail_not_a_table(file, fmt::format("the study has more than {} runs", kMaxStudyRuns));
    const auto whole = [&](const std::string& name, const std::string& field, long least) {
      const long value = whole_of(field);
      if (value < least)
        fail_not_a_table(
            file, fmt::format("line {}: {} = \"{}\" is not a whole number from {} to {}",
                              out.rows() + 2, name, field.substr(0, 80), least, kMaxStudyRuns));
      return value;
    };
    std::pair<long, long> numbers;
    for (std::size_t k = 0; k < head.size(); ++k) {
      if (places[k] != nullptr)
        places[k]->values.push_back(number_of(fields[k]));
      else if (head[k] == "run")
        numbers.first = whole("run", fields[k], 1);
      else if (head[k] == "exit")
        numbers.second = fields[k].empty() ? -1 : whole("exit", fields[k], 0);
      else if (head[k] == "deck")
        out.deck.push_back(fields[k]);
      else if (head[k] == "case")
        out.label.push_back(fields[k]);
      else
        out.message.push_back(fields[k]);
    }
    out.run.push_back(numbers.first);
    out.exit.push_back(numbers.second);
  }
  if (head.empty()) fail_not_a_table(file, "it is empty");
  return out;
}

using results::h5::Handle;

hsize_t rows_of(hid_t set) {
  const Handle space(H5Dget_space(set));
  std::array<hsize_t, H5S_MAX_RANK> size{};
  return H5Sget_simple_extent_ndims(space) == 1 &&
                 H5Sget_simple_extent_dims(space, size.data(), nullptr) == 1
             ? size[0]
             : 0;
}

class H5Table {
 public:
  explicit H5Table(const fs::path& file)
      : file_(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    if (!file_.valid()) fail_not_a_table("it is not an HDF5 file");
  }
  StudyTable read() const {
    StudyTable out;
    out.run = whole("run");
    out.exit = whole("exit");
    if (out.exit.size() != out.run.size())
      fail_not_a_table("the columns \"run\" and \"exit\" have different lengths");
    if (out.rows() > static_cast<std::size_t>(kMaxStudyRuns))
      fail_not_a_table("it has too many runs");
    out.variables = group("variables", out.rows());
    out.quantities = group("quantities", out.rows());
    out.message = texts("message", out.rows());
    out.label = texts("case", out.rows());
    out.deck = texts("deck", out.rows());
    if (out.message.empty()) out.message.resize(out.rows());
    return out;
  }

 private:
  [[nodiscard]] Handle open(const std::string& name) const {
    if (H5Lexists(file_, name.c_str(), H5P_DEFAULT) <= 0) return {};
    return Handle(H5Dopen2(file_, name.c_str(), H5P_DEFAULT));
  }
  [[nodiscard]] std::vector<long> whole(const std::string& name) const {
    const Handle set = open(name);
    if (!set.valid()) fail_not_a_table("it has no " + name);
    const hsize_t rows = rows_of(set);
    if (rows > static_cast<hsize_t>(kMaxStudyRuns)) fail_not_a_table(name + " has too many rows");
    std::vector<long> out(rows);
    if (!out.empty() &&
        H5Dread(set, H5T_NATIVE_LONG, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.data()) < 0)
      fail_not_a_table(name + " cannot be read");
    return out;
  }
  [[nodiscard]] std::vector<std::string> texts(const std::string& name, std::size_t rows) const {
    const Handle set = open(name);
    if (!set.valid() || rows_of(set) != rows || rows == 0) return {};
    const Handle type(H5Dget_type(set));
    const std::size_t width = H5Tget_size(type);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 ||
        width > kMaxStudyTableBytes / rows)
      return {};
    std::string all(width * rows, '\0');
    if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0) return {};
    std::vector<std::string> out;
    for (std::size_t i = 0; i < rows; ++i)
      out.emplace_back(all.substr(i * width, width).c_str());  // up to the padding
    return out;
  }
  [[nodiscard]] std::vector<TableColumn> group(const char* name, std::size_t rows) const {
    std::vector<TableColumn> out;
    if (H5Lexists(file_, name, H5P_DEFAULT) <= 0) return out;
    const Handle in(H5Gopen2(file_, name, H5P_DEFAULT));
    if (!in.valid()) return out;
    std::vector<std::string> names;
    H5Literate(
        in, H5_INDEX_NAME, H5_ITER_INC, nullptr,
        [](hid_t, const char* link, const H5L_info_t*, void* to) -> herr_t {
          static_cast<std::vector<std::string>*>(to)->emplace_back(link);
          return 0;
        },
        &names);
    if (names.size() > kMaxTableColumns) fail_not_a_table("it has too many columns");
    for (const std::string& column : names) {
      const Handle set(H5Dopen2(in, column.c_str(), H5P_DEFAULT));
      if (!set.valid() || rows_of(set) != rows)
        fail_not_a_table(column + " has a different number of rows than the dataset \"run\"");
      TableColumn next{column, unit_of(set), std::vector<double>(rows)};
      if (rows > 0 &&
          H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, next.values.data()) < 0)
        fail_not_a_table(column + " cannot be read");
      out.push_back(std::move(next));
    }
    return out;
  }
  static std::string unit_of(hid_t set) {
    if (H5Aexists(set, "unit") <= 0) return {};
    const Handle attribute(H5Aopen(set, "unit", H5P_DEFAULT));
    const Handle type(H5Aget_type(attribute));
    constexpr std::size_t kMaxUnitLength = 200;
    const std::size_t size = H5Tget_size(type);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || size > kMaxUnitLength)
      return {};
    std::string out(size, '\0');
    if (H5Aread(attribute, type, out.data()) < 0) return {};
    return out.c_str();
  }

  /// The process that asked knows the file's name.
  [[noreturn]] static void fail_not_a_table(const std::string& why) {
    throw InputError(not_a_table_text(why));
  }

  Handle file_;
};

using PlainJson = nlohmann::json;

PlainJson columns_json(const std::vector<TableColumn>& columns) {
  PlainJson out = PlainJson::array();
  for (const TableColumn& column : columns)
    out.push_back({column.name, column.unit, column.values});
  return out;
}

std::vector<TableColumn> columns_of(const PlainJson& json) {
  std::vector<TableColumn> out;
  for (const PlainJson& column : json)
    out.push_back({column.at(0).get<std::string>(), column.at(1).get<std::string>(),
                   column.at(2).get<std::vector<double>>()});
  return out;
}

/// In a separate process: effects of a damaged file on the HDF5 library stay there.
StudyTable read_h5(const fs::path& file) {
  results::h5::ReaderLimits limits;
  limits.memory = std::size_t{2} << 30;
  constexpr std::size_t kMaxTableBytes = std::size_t{1} << 30;
  const std::string bytes = results::h5::read_in_child_process(
      file,
      [&file] {
        const StudyTable table = H5Table(file).read();
        const std::vector<std::uint8_t> cbor =
            PlainJson::to_cbor({table.run, table.exit, table.deck, table.label, table.message,
                                columns_json(table.variables), columns_json(table.quantities)});
        return std::string(cbor.begin(), cbor.end());
      },
      kMaxTableBytes, limits);
  StudyTable out;
  try {
    const PlainJson json = PlainJson::from_cbor(bytes);
    json.at(0).get_to(out.run);
    json.at(1).get_to(out.exit);
    json.at(2).get_to(out.deck);
    json.at(3).get_to(out.label);
    json.at(4).get_to(out.message);
    out.variables = columns_of(json.at(5));
    out.quantities = columns_of(json.at(6));
  } catch (const PlainJson::exception&) {
    fail_not_a_table(file, "it is damaged");
  }
  const auto fits = [&](std::size_t length) { return length == out.rows() || length == 0; };
  bool whole = out.exit.size() == out.rows() && out.message.size() == out.rows() &&
               fits(out.deck.size()) && fits(out.label.size());
  for (const auto* group : {&out.variables, &out.quantities})
    for (const TableColumn& column : *group) whole = whole && column.values.size() == out.rows();
  if (!whole) fail_not_a_table(file, "it is damaged");
  return out;
}

std::string file_name(std::string text) {
  for (char& c : text)
    if (c == '/' || c == ' ' || c == '[' || c == ']') c = '_';
  return text;
}

std::string shown(const TableColumn& column, std::size_t row) {
  const std::string unit = column.unit.empty() || column.unit == "-" ? "" : " " + column.unit;
  const double value = column.values.at(row);
  return fmt::format("  {:<34} {}\n", column.name,
                     std::isnan(value) ? "none" : fmt::format("{:.10g}{}", value, unit));
}

Task task_of(const fs::path& folder, long run) {
  for (Task& task : read_tasks(folder / "tasks.jsonl", read_job(folder).decks.size()))
    if (task.number == run) return std::move(task);
  throw InputError(fmt::format("{}: the study has no run {}", folder.string(), run));
}

}  // namespace

bool is_study_table(const fs::path& file) {
  if (file.extension() == ".h5") return file.filename() != "RESULTS.h5";
  if (file.extension() != ".csv" || !is_plain_file(file)) return false;
  InputFile in(file);
  std::string start(9, '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == "run,exit,";
}

StudyTable read_study_table(const fs::path& file) {
  if (file.extension() != ".h5") return read_csv(file);
  return read_h5(file);
}

std::string charts_of_table(const StudyTable& table) {
  Chart charts = Chart::array();
  constexpr std::size_t kMaxGridValues = 200;
  const std::vector<const TableColumn*> columns =
      parallel_chart_axes(table.variables, table.quantities);
  if (columns.size() > 1 && table.rows() > 1)
    charts.push_back(parallel_chart("parallel", columns, -1, table.run));
  for (const TableColumn& x : table.variables) {
    const std::set<double> values(x.values.begin(), x.values.end());
    if (values.size() < 2 || values.size() > kMaxGridValues) continue;
    for (const TableColumn& y : table.quantities) {
      ChartLine line;
      bool band = false;
      for (const double at : values) {
        std::vector<double> here;
        line.runs.emplace_back();
        for (std::size_t i = 0; i < table.rows(); ++i) {
          if (x.values[i] != at) continue;
          here.push_back(y.values[i]);
          line.runs.back().push_back(table.run[i]);
        }
        const Summary summary = summarize(here, {5.0, 50.0, 95.0});
        const auto value = [&](std::size_t k) {
          return summary.count > 0 ? summary.percentiles[k].value : kNaN;
        };
        line.x.push_back(at);
        line.low.push_back(value(0));
        line.y.push_back(value(1));
        line.high.push_back(value(2));
        band = band || summary.count > 1;
      }
      if (!band) {
        line.low.clear();
        line.high.clear();
      }
      charts.push_back(curves_chart(
          fmt::format("curves-{}-over-{}", file_name(y.name), file_name(x.name)), x, y, {line}));
    }
  }
  return dump_json(charts, 1) + "\n";
}

std::string run_text(const StudyTable& table, long run) {
  const auto found = std::find(table.run.begin(), table.run.end(), run);
  if (found == table.run.end()) return fmt::format("The table has no run {}.\n", run);
  const auto row = static_cast<std::size_t>(found - table.run.begin());
  const long exit = table.exit[row];
  std::string out = fmt::format("Run {}: {}\n", run,
                                exit < 0    ? "not finished"
                                : exit == 0 ? "done"
                                            : fmt::format("failed (exit {})", exit));
  if (!table.message[row].empty()) out += table.message[row] + "\n";
  if (!table.deck.empty()) out += fmt::format("  {:<34} {}\n", "deck", table.deck[row]);
  if (!table.label.empty()) out += fmt::format("  {:<34} {}\n", "case", table.label[row]);
  out += "\n";
  for (const TableColumn& column : table.variables) out += shown(column, row);
  out += "\n";
  for (const TableColumn& column : table.quantities) out += shown(column, row);
  return out;
}

std::string run_text(const fs::path& folder, long run) {
  const Job job = read_job(folder);
  const Task task = task_of(folder, run);
  const std::optional<Record> record = read_record(folder, task.key);
  std::string out;
  if (std::error_code error; fs::exists(folder / "RUNS.csv", error))
    out = run_text(read_study_table(folder / "RUNS.csv"), run);
  if (record)
    out += fmt::format("\ncost: {:.3g} s processor time, {:.3g} MB of memory, on {}\n",
                       record->processor, record->memory_megabytes, record->host);
  // As run_task() makes it.
  std::string command = fmt::format("adore run {}", job.decks.at(task.point.deck).deck.string());
  const auto add = [&](const char* option, const Settings& base, const Settings& over) {
    Settings all = base;
    for (const auto& [name, value] : over) {
      std::erase_if(all, [&](const auto& old) { return old.first == name; });
      all.emplace_back(name, value);
    }
    for (const auto& [name, value] : all)
      command += fmt::format(" {} '{}={}'", option, name, value);
  };
  add("--set", job.sets, task.point.sets);
  Settings options = job.decks.at(task.point.deck).options;
  options.insert(options.end(), job.options.begin(), job.options.end());
  add("--opt", options, task.point.options);
  if (!job.until.empty()) command += " --until " + job.until;
  if (!job.integrator.empty()) command += " --integrator " + job.integrator;
  if (job.tolerance) command += fmt::format(" --tol {}", *job.tolerance);
  out += fmt::format("\ncommand that repeats this run and keeps all files:\n{} --out RUN-{}\n",
                     command, run);
  return out;
}

fs::path run_files_folder(const fs::path& folder, long run) {
  const fs::path files = folder / "files" / task_of(folder, run).key;
  std::error_code error;
  return fs::is_directory(files, error) ? files : fs::path();
}

}  // namespace adore::studies
