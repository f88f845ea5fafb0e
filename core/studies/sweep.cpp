#include "studies/sweep.hpp"

#include "base/counted.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/write_folder.hpp"
#include "deck/lookup.hpp"
#include "results/run_json.hpp"
#include "runs/output_folder.hpp"
#include "runs/results_folder.hpp"
#include "runs/run_ending.hpp"
#include "studies/sweep_mark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace adore::studies {
namespace {

struct Range {
  double first = 0.0, last = 0.0;
  int count = 0;
};

template <class T>
bool parse(std::string_view text, T& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size();
}

Range parse_range(const std::string& name, const std::string& value) {
  const std::size_t a = value.find(':'), b = value.rfind(':');
  Range out;
  const std::string_view text(value);
  if (a == b || !parse(text.substr(0, a), out.first) ||
      !parse(text.substr(a + 1, b - a - 1), out.last) || !parse(text.substr(b + 1), out.count) ||
      out.count < 2 || out.count > 100000 || !std::isfinite(out.first) || !std::isfinite(out.last))
    throw InputError(fmt::format(
        "--set {}={}: write a sweep as first:last:count with at least two runs, e.g. {}=500:2500:5",
        name, value, name));
  return out;
}

/// One run of the sweep and how it ended.
struct Row : runs::RunEnding {
  std::string value;
  bool known = false;  ///< taken over from an earlier sweep
};

/// The variable with its unit, then key results by id, in SI for any units of the deck.
std::string sweep_csv(const std::string& variable, const std::string& unit,
                      const std::vector<Row>& rows) {
  std::vector<std::string_view> columns;
  for (const Row& row : rows)
    for (const results::KeyResult& item : row.outcome.summary)
      if (std::find(columns.begin(), columns.end(), item.of.id) == columns.end())
        columns.push_back(item.of.id);
  std::string out = variable + (unit.empty() ? "" : " [" + unit + "]") + ",exit";
  for (const std::string_view column : columns) out += fmt::format(",{}", column);
  out += ",message\n";
  for (const Row& row : rows) {
    out += fmt::format("{},{}", row.value, row.exit_code);
    for (const std::string_view column : columns) {
      const auto found = std::find_if(row.outcome.summary.begin(), row.outcome.summary.end(),
                                      [&](const auto& item) { return item.of.id == column; });
      out += found == row.outcome.summary.end() ? "," : fmt::format(",{}", found->value);
    }
    out += fmt::format(",{}\n", runs::quoted_message_field(row.message()));
  }
  return out;
}

Row run_one(const runs::RunRequest& request, std::string value, const std::stop_token& stop) {
  return {runs::run_catching_errors(request, stop), std::move(value), false};
}

/// The row of a run that an earlier, broken-off sweep completed: the same deck, options and end.
std::optional<Row> completed(const runs::RunRequest& request, const std::string& value,
                             const std::string& digest) {
  const std::filesystem::path file = *request.out / request.below / "RUN.json";
  const results::RunRequestStatus mark = results::read_request_status(file);
  if (mark.status != "done" || mark.request != digest) return {};
  Row row;
  row.value = value;
  row.known = true;
  try {
    InputFile stream(file);
    const auto json = parse_json<nlohmann::ordered_json>(
        std::string(std::istreambuf_iterator<char>(stream), {}), file.string());
    for (const auto& [name, item] : json.at("summary").items()) {
      if (results::find_key_result(name).id.empty()) {
        Finding issue =
            make_finding("sweep.unknown_result",
                         fmt::format("the summary contains \"{}\", which this release does not "
                                     "know. The finished run is kept, but the table of the sweep "
                                     "does not include it. To compute it again, remove the folder "
                                     "of the run",
                                     name));
        issue.file = file.string();
        row.outcome.warnings.push_back(std::move(issue));
        continue;
      }
      row.outcome.summary.push_back(results::key_result(
          name, item.is_number() ? item.get<double>() : std::numeric_limits<double>::infinity()));
    }
  } catch (const std::exception&) {
    return {};  // damaged: it runs again
  }
  return row;
}

/// One run of a continued sweep: reused, completed from its last checkpoint, or repeated.
Row run_missing_value(runs::RunRequest request, const std::string& value, std::stop_token stop) {
  std::string digest;
  try {
    digest = runs::request_digest(request, runs::load_deck(request));
  } catch (const InputError&) {
    // The run reports it.
  }
  if (std::optional<Row> row = completed(request, value, digest)) return *row;
  const results::RunRequestStatus mark =
      results::read_request_status(*request.out / request.below / "RUN.json");
  if ((mark.status == "running" || mark.status == "interrupted") && mark.request == digest) {
    request.go_on = true;
    Row row = run_one(request, value, stop);
    if (row.exit_code != 2) return row;  // else its files do not fit together
  }
  request.go_on = false;
  request.overwrite = true;
  return run_one(request, value, stop);
}

/// Remarks that differ only in their numbers come once, from the first run that makes them, which
/// is named where others may not make them.
std::vector<Finding> warnings_once(const std::string& variable, const std::vector<Row>& rows) {
  std::set<std::string> seen;
  std::vector<Finding> out;
  for (const Row& row : rows)
    for (const Finding& issue : row.outcome.warnings) {
      std::string words = issue.record + issue.variable;
      for (const char c : issue.message)
        if ((c < '0' || c > '9') && c != '.') words += c;
      if (!seen.insert(words).second) continue;
      out.push_back(issue);
      if (rows.size() > 1)
        out.back().message =
            fmt::format("first at {} = {}: {}", variable, row.value, issue.message);
    }
  return out;
}

/// A table of motions without steps has loads but no motion: warn.
std::optional<Finding> no_motion_warning(const std::vector<Row>& rows) {
  std::size_t still = 0;
  for (const Row& row : rows)
    still +=
        std::any_of(row.outcome.summary.begin(), row.outcome.summary.end(),
                    [](const auto& item) { return item.of.id == "time_s" && item.value == 0.0; })
            ? 1
            : 0;
  if (still == 0) return std::nullopt;
  Finding out = make_finding(
      "sweep.no_motion",
      fmt::format("{} of the sweep simulated no motion. For these runs, the table contains only "
                  "the loads of the static solution, without mean values, speed ratios and heat",
                  counted(still, "run")));
  out.record = "1";
  out.variable = "maxStps";
  out.remedy =
      "give the number of steps, such as maxStps = 2000, or give the end of the run with --until";
  return out;
}

}  // namespace

bool is_sweep(const runs::RunRequest& request) {
  return std::any_of(request.sets.begin(), request.sets.end(),
                     [](const auto& set) { return is_sweep_range(set.second); });
}

SweepOutcome run_sweep(const runs::RunRequest& request, int threads,
                       const runs::ProgressSink& progress, std::stop_token stop) {
  std::size_t swept = request.sets.size();
  for (std::size_t i = 0; i < request.sets.size(); ++i) {
    if (!is_sweep_range(request.sets[i].second)) continue;
    if (swept != request.sets.size())
      throw InputError("a sweep varies one variable; give only one --set with a range");
    swept = i;
  }
  const std::string variable = request.sets[swept].first;
  const Range range = parse_range(variable, request.sets[swept].second);
  if (deck::find_variable(variable.substr(0, variable.find('['))).empty()) {
    runs::RunRequest first = request;
    first.sets[swept].second = runs::value_text(range.first);
    (void)runs::load_deck(first);  // throws with names that are like it, before any file
  }
  const runs::ResultsFolder made(runs::output_folder(request, runs::deck_path(request)));
  const std::filesystem::path& folder = made.path();
  const runs::FolderLock lock(made.folder());
  const auto count = static_cast<std::size_t>(range.count);
  SweepOutcome out;
  out.table = folder / "SWEEP.csv";
  const auto one_request = [&](std::size_t k) {
    runs::RunRequest one = request;
    const double value =
        range.first + (range.last - range.first) * static_cast<double>(k) / (range.count - 1);
    one.sets[swept].second = runs::value_text(value);
    one.out = folder;
    one.below = fmt::format("{}-{}", variable, k + 1);
    return one;
  };
  const bool keep = !request.overwrite && !request.go_on;
  runs::check_room({folder, {"SWEEP.csv", SweepManifest::kName}, {runs::deck_path(request)}}, true);
  if (keep && std::filesystem::exists(out.table)) throw runs::ResultsExist(folder, {"SWEEP.csv"});
  for (std::size_t k = 0; keep && k < count; ++k)
    if (const auto place = folder / one_request(k).below; std::filesystem::exists(place))
      runs::check_room({place, {"PRINT.txt", "RUN.json"}, {}}, false);

  SweepManifest mark{runs::deck_path(request).filename().string(),
                     variable + "=" + request.sets[swept].second, sweep_digest(request), "running"};
  write_sweep_manifest(mark, made.folder());

  std::vector<Row> rows(count);
  std::atomic<std::size_t> next{0};
  std::size_t done = 0, computed = 0;
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  };
  const auto begin = Clock::now();
  std::mutex mutex;
  std::exception_ptr bug;
  const std::string unit = runs::variable_unit(request, variable);
  const auto write_table = [&] {
    std::vector<Row> finished = rows;
    std::erase_if(finished, [](const Row& row) { return row.value.empty(); });
    write_file_atomically({made.folder(), out.table.filename().string()},
                          sweep_csv(variable, unit, finished));
  };
  // The table grows with the runs, so that a sweep that is killed leaves one. A tenth of the time
  // at most goes into that.
  const auto report_progress = [&] {
    if (!progress) return;
    runs::Progress p;
    p.fraction = static_cast<double>(done) / static_cast<double>(count);
    p.step = static_cast<long>(done);
    p.runs = static_cast<long>(count);
    p.elapsed = seconds(begin);
    // Known runs took no time, so they do not count in the estimate.
    if (computed > 0)
      p.remaining = p.elapsed * static_cast<double>(count - done) / static_cast<double>(computed);
    progress(p);
  };
  double rest = 0.0;
  auto written = begin;
  auto work = [&] {
    for (std::size_t k = next++; k < count && !stop.stop_requested(); k = next++) {
      runs::RunRequest one = one_request(k);
      one.go_on = false;
      try {
        const std::string value = one.sets[swept].second;
        Row row = request.go_on ? run_missing_value(one, value, stop) : run_one(one, value, stop);
        const std::scoped_lock guard(mutex);
        rows[k] = std::move(row);
        ++done;
        computed += rows[k].known ? 0 : 1;
        if (const auto at = Clock::now(); seconds(written) >= rest) {
          write_table();
          written = Clock::now();
          rest = 10.0 * seconds(at);
        }
      } catch (...) {
        const std::scoped_lock guard(mutex);
        bug = std::current_exception();
        next = count;
        return;
      }
      const std::scoped_lock guard(mutex);
      report_progress();
    }
  };
  report_progress();
  // Static variables of a plug-in would serve several runs at once.
  if (!request.user.empty()) threads = 1;
  const unsigned cores = threads > 0 ? static_cast<unsigned>(threads)
                                     : std::max(1U, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> pool;
    for (unsigned i = 1; i < std::min<std::size_t>(cores, count); ++i) pool.emplace_back(work);
    work();
  }
  if (bug) std::rethrow_exception(bug);

  write_table();
  std::erase_if(rows,
                [](const Row& row) { return row.value.empty(); });  // not started: interrupted
  out.warnings = warnings_once(variable, rows);
  if (auto still = no_motion_warning(rows)) out.warnings.push_back(std::move(*still));
  constexpr int kInterrupted = 130;
  for (const Row& row : rows) {
    out.exit_code = std::max(out.exit_code, row.exit_code);
    out.failed += row.exit_code != 0 && row.exit_code != kInterrupted ? 1 : 0;
  }
  mark.failed = out.failed;
  if (stop.stop_requested()) out.exit_code = kInterrupted;
  // Runs whose files did not fit on the disk have no result yet.
  const bool unwritten =
      std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.not_written; });
  mark.status = out.exit_code == kInterrupted || unwritten ? "interrupted" : "done";
  write_sweep_manifest(mark, made.folder());
  return out;
}

}  // namespace adore::studies
