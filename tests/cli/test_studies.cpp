#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <sstream>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

namespace {

/// A study of `loads` quasi-static runs of the example.
std::string small_study(int loads) {
  return R"({"adore_study": 1, "kind": "sweep", "deck": "DATA.txt", "set": {"mode": -1},
    "variables": [{"name": "appLoadX", "grid": [500, 3000, )" +
         std::to_string(loads) + R"(]}],
    "quantities": ["largest_contact_load_N", "stiffness_x_N_per_m", "life_lp_hours"]})";
}

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::size_t records_in(const fs::path& study) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(study / "runs"))
    if (entry.path().extension() == ".json") ++count;
  return count;
}

}  // namespace

TEST_CASE("a study is planned, run, reported, and nothing is computed twice", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "a.json", small_study(6));
  const std::string file = (folder / "a.json").string();
  const Result before = run_adore("study status " + file);
  CHECK(before.code == 2);
  CHECK(contains(before.out, "never started"));
  const Result plan = run_adore("study plan " + file);
  INFO(plan.out);
  REQUIRE(plan.code == 0);
  CHECK(contains(plan.out, "runs:      6"));
  CHECK(contains(plan.out, "disk:"));
  const Result run = run_adore("study run " + file + " --progress plain");
  INFO(run.out);
  REQUIRE(run.code == 0);
  CHECK(contains(run.out, "6 of 6 runs done, 0 failed"));
  CHECK(contains(run.out, "; 3 computed now in"));  // the pilots were there
  const std::string table = read(folder / "a.study" / "RUNS.csv");
  CHECK(lines_of(table) == 7);
  CHECK(table.rfind("run,exit,appLoadX [N],largest_contact_load_N [N],", 0) == 0);
  CHECK(fs::file_size(folder / "a.study" / "STUDY.h5") > 2000);
  const Result again = run_adore("study resume " + file);
  REQUIRE(again.code == 0);
  CHECK(contains(again.out, "; 0 computed now in"));
  CHECK(read(folder / "a.study" / "RUNS.csv") == table);

  // A finer grid that contains the old points: only the new ones are made.
  write(folder / "a.json", small_study(11));
  const Result finer = run_adore("study run " + file);
  INFO(finer.out);
  REQUIRE(finer.code == 0);
  CHECK(records_in(folder / "a.study") == 11);

  // Another deck: nothing of the old one is taken.
  const std::string deck = read(folder / "DATA.txt");
  const std::size_t at = deck.find("25.0, 0.0, 0.520");
  REQUIRE(at != std::string::npos);
  write(folder / "DATA.txt", std::string(deck).replace(at, 4, "26.0"));
  REQUIRE(run_adore("study run " + file).code == 0);
  CHECK(records_in(folder / "a.study") == 22);
}

TEST_CASE("study: influence with failed runs → note; --quiet → no output", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "a.json", R"({"adore_study": 1, "kind": "tolerance", "deck": "DATA.txt",
    "set": {"mode": -1}, "variables": [{"name": "appLoadX", "uniform": [1400, 1600]},
      {"name": "raceCurFac1", "list": [0.52, 0.4]}],
    "sampling": {"runs": 6}, "quantities": ["load_x_N"]})");
  const Result run = run_adore("study run " + (folder / "a.json").string() + " --quiet");
  CHECK(run.code == 3);
  CHECK(run.out.empty());
  const std::string report = read(folder / "a.study" / "REPORT.txt");
  CHECK(contains(report, "load_x_N:  appLoadX 1.00"));
  CHECK_FALSE(contains(report, "nan"));
}

TEST_CASE("sensitivity study of a motion: available results are differentiated, others are named",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string file = (folder / "a.toml").string();
  const std::string text = R"(adore_study = 1
kind = "sensitivity"
deck = "DATA.txt"
until = "0.1rev"
tolerance = 1e-9
variables = [{name = "appLoadX", step = 15}]
quantities = ["life_lp_hours", {channel = "contact.load", statistic = "rms", at = [1, 1], name = "load"}, )";
  write(file, text + "\"stiffness_x_N_per_m\"]");
  const Result lacks = run_adore("study run " + file + " --quiet");
  CHECK(lacks.code == 2);
  CHECK(contains(lacks.out,
                 "stiffness_x_N_per_m: only a quasi-static run (mode below 0) has this result"));
  CHECK(contains(lacks.out, "mean_largest_load_N"));
  write(file, text + "\"mean_largest_load_N\"]");
  REQUIRE(run_adore("study run " + file + " --quiet").code == 0);
  const auto value_of = [&](const std::string& report, const std::string& quantity) {
    const std::size_t at = report.find("\n" + quantity);
    REQUIRE(at != std::string::npos);
    std::istringstream words(report.substr(report.find("appLoadX", at) + 8));
    double value = 0.0, doubt = 0.0;
    words >> value >> doubt;
    return std::pair(value, doubt);
  };
  const std::string report = read(folder / "a.study" / "REPORT.txt");
  // The life is that of the equilibrium it starts from, which is 8e-5 from the quasi-static one.
  write(folder / "s.json", R"({"adore_study": 1, "kind": "sensitivity", "deck": "DATA.txt",
    "set": {"mode": -1}, "variables": [{"name": "appLoadX", "step": 15}],
    "quantities": ["life_lp_hours"]})");
  REQUIRE(run_adore("study run " + (folder / "s.json").string() + " --quiet").code == 0);
  const auto life = value_of(report, "life_lp_hours");
  CHECK(life.first ==
        Approx(value_of(read(folder / "s.study" / "REPORT.txt"), "life_lp_hours").first)
            .epsilon(5e-4));
  // 14 balls share 1,500 N of thrust at some 25 degrees: each gets about 1/(14 sin 25) = 0.17.
  const auto load = value_of(report, "load [N]");
  CHECK(load.first == Approx(0.17).epsilon(0.3));
  CHECK(load.second < 0.01 * load.first);
}

TEST_CASE("a report of derivatives without runs has no numbers", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "a.json", R"({"adore_study": 1, "kind": "sensitivity", "deck": "DATA.txt",
    "set": {"mode": -1}, "variables": [{"name": "appLoadX", "step": 4e8}],
    "quantities": ["life_lp_hours"]})");
  CHECK(run_adore("study run " + (folder / "a.json").string() + " --quiet").code == 3);
  const Result told = run_adore("study report " + (folder / "a.json").string());
  CHECK(contains(told.out, "appLoadX"));
  CHECK_FALSE(contains(told.out, "nan"));
}

TEST_CASE("the table has the values that single runs have", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "a.json", small_study(3));
  REQUIRE(run_adore("study run " + (folder / "a.json").string()).code == 0);
  REQUIRE(run_adore("run " + (folder / "DATA.txt").string() +
                    " --set mode=-1 --set appLoadX=1750 --quiet --out " + (folder / "one").string())
              .code == 0);
  const json one = json::parse(read(folder / "one" / "RUN.json"));
  std::istringstream table(read(folder / "a.study" / "RUNS.csv"));
  std::string line;
  for (int i = 0; i < 3; ++i) std::getline(table, line);
  CHECK(contains(
      line, fmt::format("1750,{},{},{}", one["summary"]["largest_contact_load_N"].get<double>(),
                        one["summary"]["stiffness_x_N_per_m"].get<double>(),
                        one["summary"]["life_lp_hours"].get<double>())));
}

TEST_CASE("studies of every kind give the same tables from TOML and from JSON", "[cli][slow]") {
  // The examples of `adore study new`, shorter.
  const std::pair<const char*, const char*> shorter[] = {
      {"30rev", "0.2rev"},
      {"5rev", "0.1rev"},
      {"500, 3000, 6", "500, 3000, 2"},
      {"4000, 8000, 12000, 16000, 20000", "4000, 8000"},
      {"0.0002, 0.0003, 0.0004, 0.0005, 0.0006", "0.0003, 0.0005"}};
  for (const char* kind :
       {"sweep", "tolerance", "cage-map", "sensitivity", "worst-case", "what-if"}) {
    INFO(kind);
    const Folder folder;
    new_ball_deck(folder);
    std::map<std::string, std::string> table, numbers, report;
    for (const std::string format : {"json", "toml"}) {
      const fs::path file = folder / (format + "." + format);
      REQUIRE(run_adore(fmt::format("study new {} --out {}", kind, file.string())).code == 0);
      std::string text = read(file);
      for (const auto& [from, to] : shorter)
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from))
          text.replace(at, std::string(from).size(), to);
      for (const std::string runs : {"\"runs\": 100", "\"runs\": 32", "runs = 100", "runs = 32"})
        if (const std::size_t at = text.find(runs); at != std::string::npos)
          text.replace(at, runs.size(), runs.substr(0, runs.find_last_of(' ')) + " 4");
      write(file, text);
      const Result run = run_adore("study run " + file.string() + " --quiet");
      INFO(run.out);
      REQUIRE(run.code == 0);
      const fs::path results = folder / (format + ".study");
      table[format] = read(results / "RUNS.csv");
      numbers[format] = read(results / "STUDY.h5");
      report[format] = read(results / "REPORT.txt");
      report[format].erase(0, report[format].find(','));  // the file's name
    }
    CHECK(lines_of(table["json"]) > 4);
    CHECK(table["toml"] == table["json"]);
    CHECK(numbers["toml"] == numbers["json"]);
    if (std::string(kind) != "what-if")  // with the time of the runs
      CHECK(report["toml"] == report["json"]);
  }
}

TEST_CASE("study: failed runs → diagnosis in the table, the others continue", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "a.json", R"({"adore_study": 1, "kind": "sweep", "deck": "DATA.txt",
    "set": {"mode": -1}, "variables": [{"name": "raceCurFac1", "list": [0.52, 0.515, 0.4, 0.53]}],
    "quantities": ["largest_contact_load_N"]})");
  const Result run = run_adore("study run " + (folder / "a.json").string());
  INFO(run.out);
  CHECK(run.code == 3);
  CHECK(contains(run.out, "raceCurFac1 = 0.4"));
  const std::string table = read(folder / "a.study" / "RUNS.csv");
  // The sentence does not name folders, which differ from machine to machine.
  CHECK(contains(table, "3,2,0.4,,\"decks/1/DATA.txt:"));
  const Result status = run_adore("study status " + (folder / "a.json").string());
  CHECK(contains(status.out, "4 of 4 runs done, 1 of them failed"));
  CHECK(contains(status.out, "run 3:"));
}

TEST_CASE("a study that asks for what runs do not have, or for too much, does not start", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string file = (folder / "a.json").string();
  std::string text = small_study(500);
  write(file, std::string(text).replace(text.find("life_lp_hours"), 13, "power_loss_W"));
  const Result missing = run_adore("study run " + file);
  CHECK(missing.code == 2);
  CHECK(contains(
      missing.out,
      "power_loss_W: a quasi-static run (mode = -1) has no motion; possible key results are"));
  write(file, std::string(text).insert(text.find("\"deck\""), "\"budget\": {\"runs\": 100}, "));
  const Result large = run_adore("study run " + file);
  CHECK(large.code == 2);
  CHECK(contains(large.out, "500 runs, but the budget is 100"));
  CHECK(records_in(folder / "a.study") <= 6);
}

TEST_CASE("drivers and workers are killed at random, and the table is the same", "[cli][slow]") {
  const Folder folder, whole;
  new_ball_deck(folder);
  new_ball_deck(whole);
  const std::string study = R"({"adore_study": 1, "kind": "tolerance", "deck": "DATA.txt",
    "until": "0.5rev", "variables": [{"name": "freeConAng", "normal": [25, 0.5]},
      {"name": "mode", "list": [-1, 0]}],
    "sampling": {"runs": 12}, "quantities": ["largest_contact_load_N"]})";
  write(folder / "a.json", study);
  write(whole / "a.json", study);
  REQUIRE(run_adore("study run " + (whole / "a.json").string() + " --workers 1").code == 0);
  // `timeout -s KILL` ends the driver; its workers end with it.
  Result last{};
  for (int i = 1; i <= 40; ++i) {
    last = run_as_given("study run " + (folder / "a.json").string() + " --workers 2 --quiet",
                        fmt::format("timeout -s KILL {}", 0.2 + 0.1 * i));
    if (last.code == 0) break;
  }
  INFO(last.out);
  REQUIRE(last.code == 0);
  CHECK(read(folder / "a.study" / "RUNS.csv") == read(whole / "a.study" / "RUNS.csv"));
  CHECK(read(folder / "a.study" / "STUDY.h5") == read(whole / "a.study" / "STUDY.h5"));
}

TEST_CASE("percentiles of a tolerance of the applied load are those of the load", "[cli]") {
  // The load on the race is what is applied: a linear quantity with a known law.
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "a.json", R"({"adore_study": 1, "kind": "tolerance", "deck": "DATA.txt",
    "set": {"mode": -1}, "variables": [{"name": "appLoadX", "normal": [1500, 50]}],
    "sampling": {"method": "random", "runs": 60, "seed": 3}, "quantities": ["load_x_N"]})");
  REQUIRE(run_adore("study run " + (folder / "a.json").string()).code == 0);
  std::istringstream table(read(folder / "a.study" / "RUNS.csv"));
  std::string line;
  std::getline(table, line);
  std::vector<double> scores;
  while (std::getline(table, line)) {
    std::istringstream fields(line);
    std::string field;
    for (int k = 0; k < 4; ++k) std::getline(fields, field, ',');
    scores.push_back((std::stod(field) - 1500.0) / 50.0);
  }
  REQUIRE(scores.size() == 60);
  std::sort(scores.begin(), scores.end());
  // Standard error of a percentile: √(p (1 - p) / n) / φ(z); three of them.
  const auto percentile = [&](double p) { return scores[static_cast<std::size_t>(p * 60.0)]; };
  CHECK(percentile(0.5) == Approx(0.0).margin(3 * 0.162));
  CHECK(percentile(0.1) == Approx(-1.2816).margin(3 * 0.221));
  CHECK(percentile(0.9) == Approx(1.2816).margin(3 * 0.221));
}
