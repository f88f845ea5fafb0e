#include "studies/job.hpp"

#include "base/checksum.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/version.hpp"
#include "base/write_error.hpp"
#include "base/write_folder.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/monitored_bodies.hpp"
#include "results/reader_killed.hpp"
#include "runs/option_file.hpp"
#include "runs/run_ending.hpp"
#include "runs/solver_stamp.hpp"
#include "runs/temporary_folder.hpp"
#include "scene/cost_ledger.hpp"
#include "studies/quantities.hpp"
#include "studies/quantity_check.hpp"
#include "studies/study_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <sys/resource.h>
#include <unistd.h>

namespace adore::studies {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// Content hash of 128 bits: Fowler, Noll and Vo's FNV-1a twice, from different offsets, the second
/// over mixed bytes. No defence against malice: a key that collides gives a wrong row, so that 1e5
/// runs meet with probability 1e-29.
class Hash {
 public:
  void add(std::string_view text) {
    for (const char c : text) byte(static_cast<unsigned char>(c));
    byte(0);  // "ab", "c" is not "a", "bc"
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}{:016x}", a_, b_); }

 private:
  void byte(unsigned char c) {
    a_ = (a_ ^ c) * 0x100000001b3U;
    b_ = (b_ ^ (c * 0x9E3779B97F4A7C15ULL >> 56)) * 0x100000001b3U;
    b_ ^= b_ >> 29;
  }
  std::uint64_t a_ = 0xcbf29ce484222325U, b_ = 0x84222325cbf29ce4U;
};

Json to_json(const Settings& settings) {
  Json out = Json::array();
  for (const auto& [name, value] : settings) out.push_back({name, value});
  return out;
}

Settings settings_of(const Json& json) {
  Settings out;
  for (const Json& row : json)
    out.emplace_back(row.at(0).get<std::string>(), row.at(1).get<std::string>());
  return out;
}

/// Infinite lives and missing values have no number in JSON.
Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? Json() : Json(value > 0.0 ? "inf" : "-inf");
}

double number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json.is_null()) return std::numeric_limits<double>::quiet_NaN();
  return (json == "inf" ? 1.0 : -1.0) * std::numeric_limits<double>::infinity();
}

Json to_json(const Quantity& q) {
  return {
      {"name", q.name},       {"channel", q.channel}, {"statistic", static_cast<int>(q.statistic)},
      {"percent", q.percent}, {"from", q.from},       {"to", q.to},
      {"places", q.places},   {"unit", q.unit}};
}

/// Values of a JSON text in the study's folder, which may come from a stranger. Numbers are checked
/// before they become indices; a mistake names file, line, key and value.
class FolderFile {
 public:
  explicit FolderFile(std::string file, long line = 0) : file_(std::move(file)), line_(line) {}

  [[noreturn]] void refuse(const std::string& problem) const {
    throw InputError(fmt::format(
        "{}{}: {}. The file is damaged: remove it and start the study again with `adore study "
        "run`; finished runs are kept.",
        file_, line_ > 0 ? fmt::format(", line {}", line_) : "", problem));
  }
  [[noreturn]] void refuse(const std::string& key, const Json& value,
                           const std::string& valid) const {
    constexpr std::size_t kMaxValueLength = 80;
    refuse(fmt::format("{} = {}: {}", key, dump_json(value).substr(0, kMaxValueLength), valid));
  }
  [[nodiscard]] long whole(const std::string& key, const Json& value, long low, long high) const {
    const double number = real(key, value, static_cast<double>(low), static_cast<double>(high));
    if (number != std::floor(number)) refuse(key, value, "not a whole number");
    return static_cast<long>(number);
  }
  [[nodiscard]] double real(const std::string& key, const Json& value, double low,
                            double high) const {
    if (!value.is_number()) refuse(key, value, "not a number");
    const auto number = value.get<double>();
    if (!(number >= low && number <= high))
      refuse(key, value, fmt::format("outside its range, {:.15g} to {:.15g}", low, high));
    return number;
  }

 private:
  std::string file_;
  long line_;
};

Quantity quantity_of(const Json& json, const FolderFile& file, const std::string& at) {
  constexpr long kMaxIndex = 1'000'000;  // as in the study file
  Quantity q;
  q.name = json.at("name").get<std::string>();
  q.channel = json.at("channel").get<std::string>();
  q.statistic = static_cast<Statistic>(file.whole(at + ".statistic", json.at("statistic"), 0,
                                                  static_cast<long>(Statistic::Percentile)));
  q.percent = file.real(at + ".percent", json.at("percent"), 0.0, 100.0);
  q.from = file.real(at + ".from", json.at("from"), 0.0, 1.0);
  q.to = file.real(at + ".to", json.at("to"), 0.0, 1.0);
  for (const Json& place : json.at("places"))
    q.places.push_back(static_cast<std::size_t>(file.whole(at + ".places", place, 1, kMaxIndex)));
  q.unit = json.at("unit").get<std::string>();
  return q;
}

Json to_json(const Job& job, const fs::path& folder) {
  Json out;
  out["adore_job"] = 1;
  out["program"] = kProgramVersion;
  out["decks"] = Json::array();
  for (const Job::BaseDeck& base : job.decks)
    out["decks"].push_back({{"deck", base.deck.lexically_relative(folder).string()},
                            {"options", to_json(base.options)}});
  out["sets"] = to_json(job.sets);
  out["options"] = to_json(job.options);
  out["until"] = job.until;
  out["integrator"] = job.integrator;
  out["tolerance"] = job.tolerance ? Json(*job.tolerance) : Json();
  out["keep_files"] = job.keep_files;
  out["quantities"] = Json::array();
  for (const Quantity& q : job.quantities) out["quantities"].push_back(to_json(q));
  return out;
}

void leave_out(std::string& text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.erase(at, part.size());
}

double megabytes_in(const fs::path& folder) {
  double bytes = 0.0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error)) bytes += static_cast<double>(entry.file_size(error));
  return bytes / 1e6;
}

double peak_megabytes() {
  struct rusage self {
  }, children{};
  getrusage(RUSAGE_SELF, &self);
  getrusage(RUSAGE_CHILDREN, &children);
  return static_cast<double>(self.ru_maxrss + children.ru_maxrss) * 1024.0 / 1e6;
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// Settings of a task for run_task() and the key, in one order: base, study, point.
Settings options_of(const Job& job, const Task& task) {
  Settings out = job.decks.at(task.point.deck).options;
  const auto over = [&](const Settings& more) {
    for (const auto& [name, value] : more) {
      std::erase_if(out, [&](const auto& old) { return old.first == name; });
      out.emplace_back(name, value);
    }
  };
  over(job.options);
  over(task.point.options);
  return out;
}

/// A case replaces what the study sets for all runs.
Settings sets_of(const Job& job, const Task& task) {
  Settings out = job.sets;
  for (const auto& [name, value] : task.point.sets) {
    std::erase_if(out, [&](const auto& old) { return old.first == name; });
    out.emplace_back(name, value);
  }
  return out;
}

/// As Hash writes it: a key is the name of a file and a folder.
bool is_key(const std::string& text) {
  return text.size() == 32 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Of a record without its checksum.
std::string record_sum(const Json& json) {
  return fmt::format("{:016x}", checksum(dump_json(json)));
}

/// "decks/1/DATA.txt": a path that stays in the study's folder.
fs::path path_inside(const Json& text, const FolderFile& file, const std::string& at) {
  const fs::path relative = text.get<std::string>();
  const bool leaves = relative.empty() || relative.is_absolute() ||
                      std::any_of(relative.begin(), relative.end(),
                                  [](const fs::path& part) { return part == ".."; });
  if (leaves) file.refuse(at, text, "the path must be inside the folder of the study");
  return relative;
}

}  // namespace

Job prepare_job(const Study& study, const WriteFolder& folder) {
  Job job;
  (void)folder.folder("runs");
  for (std::size_t k = 0; k < study.decks.size(); ++k) {
    const fs::path original = runs::deck_path(study.decks[k]);
    const WriteFolder place = folder.folder(fs::path("decks") / std::to_string(k + 1));
    const std::string name = original.filename().string();
    Job::BaseDeck base;
    base.deck = place.path() / name;
    const runs::OptionFile options = runs::usable_options_of_deck(original);
    std::string text = read_text_file(original, kMaxHandwrittenBytes);
    if (!options.variables().empty()) {  // the copy of the deck has its records X itself
      deck::Deck deck = deck::read_deck(original).deck;
      if (std::vector<Issue> issues = runs::set_extension(deck, options, original); !issues.empty())
        throw InputError(std::move(issues));
      text = deck::with_deck(text, deck).text;
    }
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(base.deck, error)) ||
        read_text_file(base.deck) != text)
      write_into_study(place, name, text);
    for (const auto& [option, value] : options.values()) base.options.emplace_back(option, value);
    job.decks.push_back(std::move(base));
  }
  job.sets = study.sets;
  job.options = study.options;
  job.until = study.until;
  job.integrator = study.integrator;
  job.tolerance = study.tolerance;
  job.quantities = study.quantities;
  job.keep_files = study.keep_files;
  write_into_study(folder, "job.json", dump_json(to_json(job, folder.path()), 1) + "\n");
  return job;
}

Job read_job(const fs::path& folder) {
  const fs::path path = folder / "job.json";
  const Json json = parse_json<Json>(read_text_file(path), path.string());
  const FolderFile file(path.string());
  try {
    Job job;
    for (const Json& deck : json.at("decks")) {
      const std::string at = fmt::format("decks[{}].deck", job.decks.size() + 1);
      job.decks.push_back(
          {folder / path_inside(deck.at("deck"), file, at), settings_of(deck.at("options"))});
    }
    if (job.decks.empty()) file.refuse("decks", json.at("decks"), "the list of decks is empty");
    job.sets = settings_of(json.at("sets"));
    job.options = settings_of(json.at("options"));
    job.until = json.at("until").get<std::string>();
    job.integrator = json.at("integrator").get<std::string>();
    if (const Json& tolerance = json.at("tolerance"); !tolerance.is_null())
      job.tolerance = file.real("tolerance", tolerance, 0.0, 1.0);
    job.keep_files = json.at("keep_files").get<bool>();
    for (const Json& q : json.at("quantities"))
      job.quantities.push_back(
          quantity_of(q, file, fmt::format("quantities[{}]", job.quantities.size() + 1)));
    return job;
  } catch (const nlohmann::json::exception& error) {
    file.refuse(error.what());
  }
}

std::vector<Task> make_tasks(const Job& job, const std::vector<Point>& points, long first_number) {
  Hash common;
  common.add(runs::solver_stamp());
  common.add(job.until);
  common.add(job.integrator);
  common.add(job.tolerance ? fmt::format("{}", *job.tolerance) : "");
  for (const Quantity& q : job.quantities) common.add(dump_json(to_json(q)));
  std::vector<std::optional<deck::ReadResult>> bases(job.decks.size());
  std::vector<Task> out;
  out.reserve(points.size());
  for (const Point& point : points) {
    Task task{first_number + static_cast<long>(out.size()), {}, point};
    std::optional<deck::ReadResult>& base = bases.at(point.deck);
    if (!base) base = deck::read_deck(job.decks[point.deck].deck);
    Hash hash = common;
    deck::Deck deck = base->deck;
    try {
      (void)deck::set_all_and_renumber(deck, sets_of(job, task));
      hash.add(deck::write_deck(deck));
    } catch (const InputError& error) {
      hash.add(error.what());  // the run will be rejected with the same sentence
    }
    for (const auto& [name, value] : [&] {
           const Settings options = options_of(job, task);
           return std::map<std::string, std::string>(options.begin(), options.end());
         }()) {
      hash.add(name);
      hash.add(value);
    }
    task.key = hash.text();
    out.push_back(std::move(task));
  }
  return out;
}

std::string task_line(const Task& task) {
  Json out;
  out["run"] = task.number;
  out["key"] = task.key;
  out["deck"] = task.point.deck;
  out["sets"] = to_json(task.point.sets);
  out["options"] = to_json(task.point.options);
  out["values"] = task.point.values;
  out["label"] = task.point.label;
  return dump_json(out) + "\n";
}

Task parse_task(const std::string& line, const TaskSource& source) {
  const Json json = parse_json<Json>(line, fmt::format("{}, line {}", source.file, source.line));
  const FolderFile file(source.file, source.line);
  try {
    Task task;
    task.number = file.whole("run", json.at("run"), 1, kMaxStudyRuns);
    task.key = json.at("key").get<std::string>();
    if (!is_key(task.key)) file.refuse("key", json.at("key"), "not 32 hexadecimal digits");
    if (source.decks == 0) file.refuse("deck", json.at("deck"), "the job has no deck");
    task.point.deck = static_cast<std::size_t>(
        file.whole("deck", json.at("deck"), 0, static_cast<long>(source.decks) - 1));
    task.point.sets = settings_of(json.at("sets"));
    task.point.options = settings_of(json.at("options"));
    task.point.values = json.at("values").get<std::vector<double>>();
    task.point.label = json.at("label").get<std::string>();
    return task;
  } catch (const nlohmann::json::exception& error) {
    file.refuse(error.what());
  }
}

void write_tasks(const WriteFolder& folder, const std::string& name,
                 const std::vector<Task>& tasks) {
  write_into_study(folder, name, [&](const TextSink& sink) {
    for (const Task& task : tasks) sink(task_line(task));
  });
}

std::vector<Task> read_tasks(const fs::path& file, std::size_t decks) {
  std::istringstream lines(read_text_file(file, kMaxStudyTableBytes));
  std::vector<Task> out;
  TaskSource source{file.string(), 0, decks};
  double bytes = 0.0;
  for (std::string line; std::getline(lines, line);) {
    ++source.line;
    if (line.empty()) continue;
    if (line.size() > kMaxHandwrittenBytes)
      throw InputError(fmt::format("{}, line {}: the line is longer than {} MB", source.file,
                                   source.line, kMaxHandwrittenBytes >> 20));
    out.push_back(parse_task(line, source));
    if (out.size() > 1 && out.back().number <= out[out.size() - 2].number)
      FolderFile(source.file, source.line)
          .refuse("run", out.back().number,
                  fmt::format("the run number must be larger than that of the previous line, {}",
                              out[out.size() - 2].number));
    bytes += point_memory_bytes(out.back().point);
    if (bytes > kMaxStudyBytes)
      throw InputError(fmt::format(
          "{}, line {}: the list of runs needs more than {:.3g} GB of memory. Split the study.",
          source.file, source.line, kMaxStudyBytes / 1e9));
  }
  return out;
}

fs::path run_record_path(const fs::path& folder, const std::string& key) {
  return folder / "runs" / key.substr(0, 2) / (key + ".json");
}

std::optional<Record> read_record(const fs::path& folder, const std::string& key) {
  const fs::path file = run_record_path(folder, key);
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  try {
    Json json = parse_json<Json>(read_text_file(file), file.string());
    if (const auto sum = json.find("checksum"); sum != json.end()) {
      const std::string stored = sum->get<std::string>();
      json.erase("checksum");
      if (stored != record_sum(json)) return {};
    }
    Record out;
    out.key = json.at("key").get<std::string>();
    if (out.key != key) return {};
    constexpr long kMaxExit = 255;
    out.exit_code =
        static_cast<int>(FolderFile(file.string()).whole("exit", json.at("exit"), 0, kMaxExit));
    for (const Json& value : json.at("values")) out.values.push_back(number_of(value));
    out.message = json.at("message").get<std::string>();
    out.codes = json.value("findings", std::vector<std::string>());  // earlier releases: none
    const Json& measured = json.at("measured");
    out.processor = measured.at("processor").get<double>();
    out.wall = measured.at("wall").get<double>();
    out.memory_megabytes = measured.at("memory_megabytes").get<double>();
    out.disk_megabytes = measured.at("disk_megabytes").get<double>();
    out.host = measured.at("host").get<std::string>();
    return out;
  } catch (const InputError&) {
    return {};
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

void write_record(const fs::path& folder, const Record& record) {
  const fs::path file = run_record_path(folder, record.key).lexically_relative(folder);
  Json json;
  json["adore_run"] = 1;
  json["key"] = record.key;
  json["exit"] = record.exit_code;
  json["values"] = Json::array();
  for (const double value : record.values) json["values"].push_back(number(value));
  json["message"] = record.message;
  json["findings"] = record.codes;
  json["measured"] = {{"processor", record.processor},
                      {"wall", record.wall},
                      {"memory_megabytes", record.memory_megabytes},
                      {"disk_megabytes", record.disk_megabytes},
                      {"host", record.host}};
  json["checksum"] = record_sum(json);
  write_into_study(open_study_folder(folder).folder(file.parent_path()), file.filename().string(),
                   dump_json(json) + "\n");
}

std::optional<Record> run_task(const Job& job, const Task& task, const fs::path& folder,
                               const std::stop_token& stop) {
  const auto begin = std::chrono::steady_clock::now();
  const double processor = scene::processor_seconds();
  std::optional<runs::TemporaryFolder> temporary;
  runs::RunRequest request;
  request.deck = job.decks.at(task.point.deck).deck;
  request.sets = sets_of(job, task);
  request.options = options_of(job, task);
  request.until = job.until;
  request.integrator = job.integrator;
  request.tolerance = job.tolerance;
  request.overwrite = true;
  if (job.keep_files) {
    // NAME.study is looked up in the folder of the study file: it must not be a link, either.
    request.out = folder.parent_path();
    request.below = folder.filename() / "files" / task.key;
  } else {
    temporary.emplace();
    request.out = temporary->path();
    if (!needs_channels(job.quantities)) {
      std::erase_if(request.options, [](const auto& set) { return set.first == "resultsH5"; });
      request.options.emplace_back("resultsH5", "0");
    }
  }
  const fs::path files = *request.out / request.below;
  runs::RunEnding ending;
  try {
    ending = runs::run_catching_errors(request, stop);
  } catch (const std::logic_error& bug) {
    ending.failure = bug.what();
    ending.exit_code = 1;
  }
  if (ending.not_written) throw WriteError(ending.failure);
  if (ending.exit_code == 130) return {};
  Record out;
  out.key = task.key;
  out.exit_code = ending.exit_code;
  out.message = ending.message();
  // A run that failed half-way has no results: means over what it reached are not comparable.
  out.values.assign(job.quantities.size(), std::numeric_limits<double>::quiet_NaN());
  if (ending.exit_code == 0) {
    try {
      QuantityValues answers =
          answer(job.quantities, ending.outcome.summary, files, [&](const Quantity& quantity) {
            const runs::LoadedDeck read = runs::load_deck(request);
            return missing_quantity_reason(quantity, read.deck, job.until);
          });
      out.values = std::move(answers.values);
      out.message = std::move(answers.missing);
    } catch (const results::ReaderKilled&) {
      return {};
    }
  }
  std::set<std::string> codes;
  for (const Finding& one : ending.outcome.warnings) codes.insert(one.code);
  out.codes.assign(codes.begin(), codes.end());
  // The same sentence wherever the study's folder is: tables are compared.
  leave_out(out.message, files.string() + "/");
  leave_out(out.message, folder.string() + "/");
  out.disk_megabytes = megabytes_in(files);
  out.processor = scene::processor_seconds() - processor;
  out.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  out.memory_megabytes = peak_megabytes();
  out.host = host_name();
  return out;
}

}  // namespace adore::studies
