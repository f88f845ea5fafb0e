#include "base/errors.hpp"
#include "studies/campaign.hpp"
#include "studies/job.hpp"
#include "studies/points.hpp"
#include "studies/study_check.hpp"
#include "studies/study_table.hpp"
#include "studies/study_table_read.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

using namespace adore;
using namespace adore::studies;
using Catch::Contains;
namespace fs = std::filesystem;

/// Numbers in a study's folder and file that may come from a stranger.
namespace {

const std::string kKey = "7c82932d3c7f73ddc1ba2dfd7129a56e";

const std::string kTask = "{\"run\":2,\"key\":\"" + kKey +
                          "\",\"deck\":0,\"sets\":[[\"appLoadZ\",\"500\"]],\"options\":[],"
                          "\"values\":[500.0],\"label\":\"\"}";
const std::string kFirst = "{\"run\":1,\"key\":\"" + kKey +
                           "\",\"deck\":0,\"sets\":[],\"options\":[],\"values\":[1.0],"
                           "\"label\":\"\"}";

const std::string kJob = R"({"adore_job": 1, "decks": [{"deck": "decks/1/DATA.txt", "options": []}],
  "sets": [], "options": [], "until": "", "integrator": "", "tolerance": null, "keep_files": false,
  "quantities": [{"name": "q", "channel": "contact.load", "statistic": 0, "percent": 50.0,
  "from": 0.0, "to": 1.0, "places": [1, 2], "unit": "N"}]})";

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / fmt::format("adore-study-limits-{}", getpid())) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path write(const char* name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

template <class Read>
std::string refusal(Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// Largest memory of this process so far [MB].
double peak_megabytes() {
  struct rusage used {};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1000.0;
}

}  // namespace

TEST_CASE("tasks.jsonl: index, number or key outside its table → error with file, line and value",
          "[unit][studies]") {
  const Folder folder;
  const auto refused = [&](const std::string& from, const std::string& to) {
    const fs::path file =
        folder.write("tasks.jsonl", kFirst + "\n" + replaced(kTask, from, to) + "\n");
    return refusal([&] { (void)read_tasks(file, 1); });
  };
  REQUIRE(refused("500", "500") == "accepted");
  const std::tuple<const char*, const char*, const char*> cases[] = {
      {"\"deck\":0", "\"deck\":9", "deck = 9"},
      {"\"deck\":0", "\"deck\":1", "deck = 1"},
      {"\"deck\":0", "\"deck\":-1", "deck = -1"},
      {"\"deck\":0", "\"deck\":0.5", "deck = 0.5"},
      {"\"deck\":0", "\"deck\":1e300", "deck = 1e+300"},
      {"\"deck\":0", "\"deck\":\"0\"", "deck = \"0\""},
      {"\"deck\":0", "\"deck\":null", "deck = null"},
      {"\"run\":2", "\"run\":0", "run = 0"},
      {"\"run\":2", "\"run\":1", "run = 1"},
      {"\"run\":2", "\"run\":2.5", "run = 2.5"},
      {"\"run\":2", "\"run\":10000001", "run = 10000001"},
      {"\"run\":2", "\"run\":18446744073709551615", "run = 18446744073709551615"},
      {"7c82932d3c7f73ddc1ba2dfd7129a56e", "../../../../outside", "key = \"../../../../outside\""}};
  for (const auto& [from, to, value] : cases) {
    INFO(to);
    CHECK_THAT(refused(from, to), Contains("tasks.jsonl, line 2: ") && Contains(value));
  }
  CHECK_THAT(refused("[500.0]", "[\"x\"]"), Contains("tasks.jsonl, line 2: "));
  CHECK_THAT(refused("\"label\"", "\"lable\""), Contains("tasks.jsonl, line 2: "));
  CHECK_THAT(refusal([&] {
               (void)parse_task(kTask, {"tasks.jsonl", 1, 0});
             }),
             Contains("line 1: deck = 0: the job has no deck"));
}

TEST_CASE("job.json: number outside its range → error with file, key and value",
          "[unit][studies]") {
  const Folder folder;
  const auto refused = [&](const std::string& from, const std::string& to) {
    folder.write("job.json", replaced(kJob, from, to));
    return refusal([&] { (void)read_job(folder.path()); });
  };
  REQUIRE(refused("50.0", "50.0") == "accepted");
  const std::tuple<const char*, const char*, const char*> cases[] = {
      {"\"statistic\": 0", "\"statistic\": 9", "quantities[1].statistic = 9"},
      {"\"statistic\": 0", "\"statistic\": -1", "quantities[1].statistic = -1"},
      {"\"percent\": 50.0", "\"percent\": 101", "quantities[1].percent = 101"},
      {"\"from\": 0.0", "\"from\": -1", "quantities[1].from = -1"},
      {"\"to\": 1.0", "\"to\": 2", "quantities[1].to = 2"},
      {"[1, 2]", "[1, 0]", "quantities[1].places = 0"},  // an index before the first value
      {"[1, 2]", "[1, 1e18]", "quantities[1].places = 1e+18"},
      {"\"tolerance\": null", "\"tolerance\": \"x\"", "tolerance = \"x\""},
      {"decks/1/DATA.txt", "../../etc/passwd", "decks[1].deck = \"../../etc/passwd\""},
      {"[{\"deck\": \"decks/1/DATA.txt\", \"options\": []}]", "[]", "decks = []"}};
  for (const auto& [from, to, value] : cases) {
    INFO(to);
    CHECK_THAT(refused(from, to), Contains("job.json: ") && Contains(value));
  }
  // The text after the run of a fuzzer: a deck that the job does not have.
  folder.write("job.json", kJob);
  folder.write("tasks.jsonl", replaced(kTask, "\"deck\":0", "\"deck\":9"));
  CHECK_THAT(refusal([&] { (void)run_text(folder.path(), 2); }),
             Contains("tasks.jsonl, line 1: deck = 9"));
}

TEST_CASE("RUNS.csv: run or exit that is not a whole number → error with file, line and value",
          "[unit][studies]") {
  const Folder folder;
  const auto refused = [&](const std::string& head, const std::string& line) {
    const fs::path file = folder.write("RUNS.csv", head + "\n1,0,5,\"\"\n" + line + "\n");
    return refusal([&] { (void)read_study_table(file); });
  };
  const std::string head = "run,exit,rpm2 [rpm],message";
  REQUIRE(refused(head, "2,,5,\"\"") == "accepted");
  for (const char* run : {"2x", "-2", "0", "1e3", "99999999999999999999", "10000001", ""})
    CHECK_THAT(refused(head, fmt::format("{},0,5,\"\"", run)),
               Contains("RUNS.csv: ") && Contains(fmt::format("line 3: run = \"{}\"", run)));
  CHECK_THAT(refused(head, "2,x,5,\"\""), Contains("line 3: exit = \"x\""));
  CHECK_THAT(refused(head, "2,0,5,6,\"\""), Contains("line 3"));
  CHECK_THAT(refused("run,exit,message,message", "2,0,5,\"\""), Contains("message twice"));
}

TEST_CASE("record: exit code outside 0 to 255, or not whole → no record", "[unit][studies]") {
  const Folder folder;
  Record record;
  record.key = kKey;
  record.values = {1.0};
  write_record(folder.path(), record);
  REQUIRE(read_record(folder.path(), kKey));
  const fs::path file = run_record_path(folder.path(), kKey);
  for (const char* code : {"1e300", "-1", "256", "0.5", "\"0\""}) {
    INFO(code);
    std::ofstream(file) << "{\"adore_run\":1,\"key\":\"" + kKey + "\",\"exit\":" + code +
                               ",\"values\":[1.0],\"message\":\"\",\"measured\":{\"processor\":1,"
                               "\"wall\":1,\"memory_megabytes\":1,\"disk_megabytes\":1,"
                               "\"host\":\"\"}}";
    CHECK_FALSE(read_record(folder.path(), kKey));
  }
}

TEST_CASE("report: runs that are not those of the study → error, no access outside the list",
          "[unit][studies]") {
  const std::string text = R"({"adore_study": 1, "kind": "sweep", "deck": "none.txt",
    "variables": [{"name": "appLoadX", "grid": [500, 1500, 3]}],
    "quantities": ["largest_contact_load_N"]})";
  const Study study = parse_study(text, "a.json");
  Results results;
  for (const Point& point : make_points(study))
    results.tasks.push_back({static_cast<long>(results.tasks.size()) + 1, kKey, point});
  results.records.resize(results.tasks.size());
  const auto refused = [&](const Results& changed) {
    return refusal([&] { (void)make_table(study, changed); });
  };
  // Those of the study: the next step looks for the deck.
  CHECK_THAT(refused(results), Contains("none.txt"));
  Results other = results;
  other.tasks[1].point.values[0] = 999.0;
  CHECK_THAT(refused(other), Contains("a.study/tasks.jsonl: line 2, run 2"));
  other.tasks[1].point.values.clear();
  CHECK_THAT(refused(other), Contains("a.study/tasks.jsonl: line 2, run 2"));
  other.tasks.pop_back();
  other.records.pop_back();
  CHECK_THAT(refused(other), Contains("the file lists 2 runs, but the study has 3"));
}

TEST_CASE("study: more runs or memory than the limits → error before memory is taken",
          "[unit][studies]") {
  const auto study = [](const std::string& kind, const std::string& variables,
                        const std::string& more) {
    return parse_study(
        fmt::format(R"({{"adore_study": 1, "kind": "{}", "deck": "DATA.txt", "set": {{"mode": -1}},
          "quantities": ["largest_pressure_Pa"], "variables": [{}]{}}})",
                    kind, variables, more),
        "a.json");
  };
  const std::string four =
      R"({"name": "freeConAng", "uniform": [23, 27]}, {"name": "raceCurFac1", "uniform": [0.515, 0.525]},
         {"name": "raceCurFac2", "uniform": [0.51, 0.52]}, {"name": "appLoadZ", "uniform": [300, 700]})";
  const auto worst = [&](long runs) {
    return study("worst-case", four,
                 fmt::format(R"(, "objective": {{"quantity": "largest_pressure_Pa", "rounds": 12,
                   "seek": "largest"}}, "sampling": {{"method": "sobol", "runs": {}}})",
                             runs));
  };
  const auto samples = [](long runs) {
    return fmt::format(R"(, "sampling": {{"runs": {}}})", runs);
  };
  const double before = peak_megabytes();
  // Samples, the middle, 16 corners, two sides of four variables in each round.
  CHECK(count_points(worst(1'000'000)) == 1'000'000 + 1 + 16 + 2 * 4 * 12);
  const std::string grid = R"({"name": "appLoadX", "grid": [1, 2, 100000]})";
  CHECK_THAT(refusal([&] { (void)initial_points(worst(10'000'000)); }), Contains("more than"));
  CHECK_THAT(refusal([&] { (void)initial_points(worst(9'000'000)); }), Contains("GB of memory"));
  CHECK_THAT(refusal([&] { (void)initial_points(study("tolerance", four, samples(9'000'000))); }),
             Contains("GB of memory"));
  CHECK_THAT(refusal([&] {
               (void)initial_points(study(
                   "sweep", grid + R"(, {"name": "appLoadZ", "uniform": [1, 2]})", samples(101)));
             }),
             Contains("more than"));
  for (const char* kind : {"sweep", "cage-map"})
    CHECK_THAT(refusal([&] {
                 (void)study(kind, grid + R"(, {"name": "appLoadZ", "grid": [1, 2, 101]})", "");
               }),
               Contains("variables: the values of the variables have 1.01e+07 combinations"));
  std::string many, decks, cases;
  for (int k = 0; k < 2001; ++k)
    many += fmt::format(R"({}{{"name": "reDiaVar[{}]", "step": 1}})", k > 0 ? ", " : "", k + 1);
  CHECK_THAT(refusal([&] { (void)study("sensitivity", many, ""); }),
             Contains("variables: 2001 entries"));
  for (int k = 0; k < 4000; ++k) {
    decks += k > 0 ? ", \"a\"" : "\"a\"";
    cases += fmt::format(R"({}{{"name": "{}", "set": {{"mode": -1}}}})", k > 0 ? ", " : "", k);
  }
  const Study what_if = parse_study(
      fmt::format(R"({{"adore_study": 1, "kind": "what-if", "decks": [{}], "cases": [{}],
        "quantities": ["largest_pressure_Pa"]}})",
                  decks, cases),
      "a.json");
  CHECK_THAT(refusal([&] { (void)initial_points(what_if); }), Contains("more than"));
  CHECK(peak_megabytes() - before < 100.0);
}

TEST_CASE("study: bearing seeds or several decks in a kind that ignores them → error",
          "[unit][studies]") {
  const auto refused = [](const std::string& text) {
    return refusal([&] { (void)parse_study(text, "a.json"); });
  };
  const std::string worst = R"({"adore_study": 1, "kind": "worst-case", "deck": "DATA.txt",
    "variables": [{"name": "appLoadZ", "uniform": [300, 700]}], "sampling": {"runs": 8},
    "quantities": ["largest_pressure_Pa"],
    "objective": {"quantity": "largest_pressure_Pa", "seek": "largest"}})";
  REQUIRE(refused(worst) == "accepted");
  CHECK_THAT(refused(replaced(worst, "\"sampling\"", "\"bearing_seeds\": [1, 2], \"sampling\"")),
             Contains("bearing_seeds has no effect in a study of kind \"worst-case\""));
  CHECK_THAT(refused(replaced(worst, "\"deck\": \"DATA.txt\"", "\"decks\": [\"a\", \"b\"]")),
             Contains("one deck"));
  CHECK_THAT(refused(R"({"adore_study": 1, "kind": "sensitivity", "deck": "DATA.txt",
    "variables": [{"name": "appLoadZ"}], "quantities": ["largest_pressure_Pa"],
    "bearing_seeds": [1, 2]})"),
             Contains("bearing_seeds has no effect in a study of kind \"sensitivity\""));
}
