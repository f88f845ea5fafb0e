#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <set>
#include <sstream>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

TEST_CASE("a sweep runs one folder per value and a table", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result sweep = run_adore("run " + folder.path().string() +
                                 " --set mode=-1 --set appLoadX=500.0:2500.0:3 --quiet --out " +
                                 (folder / "sweep").string());
  INFO(sweep.out);
  REQUIRE(sweep.code == 0);
  std::istringstream table(read(folder / "sweep" / "SWEEP.csv"));
  std::string line;
  int lines = 0;
  while (std::getline(table, line)) ++lines;
  CHECK(lines == 4);
  CHECK(read(folder / "sweep" / "SWEEP.csv").rfind("appLoadX [N],exit,", 0) == 0);
  CHECK(fs::exists(folder / "sweep" / "appLoadX-3" / "PRINT.txt"));
}

namespace {

/// Names of the columns that hold a value in the first row of a table.
std::set<std::string> with_values(const fs::path& table) {
  std::istringstream file(read(table));
  std::string names, row;
  std::getline(file, names);
  std::getline(file, row);
  std::istringstream heads(names), values(row);
  std::set<std::string> out;
  for (std::string head, value; std::getline(heads, head, ',') && std::getline(values, value, ',');)
    if (!value.empty()) out.insert(head);
  return out;
}

}  // namespace

TEST_CASE("a sweep has no value for what a scene does not have and what nothing was averaged over",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::set<std::string> cage{"mean_cage_ratio", "mean_whirl_ratio", "mean_swept_whirl_ratio"},
      heat{"power_loss_W", "mean_power_loss_W", "mean_heat_outer_race_W", "mean_heat_inner_race_W",
           "mean_heat_elsewhere_W"},
      means{"mean_power_loss_W",     "mean_heat_outer_race_W", "mean_heat_inner_race_W",
            "mean_heat_elsewhere_W", "mean_orbital_ratio",     "mean_cage_ratio",
            "mean_whirl_ratio",      "mean_swept_whirl_ratio", "mean_load_x_N",
            "mean_load_y_N",         "mean_load_z_N",          "mean_largest_load_N",
            "load_departure",        "energy_residual_J"};
  const std::string no_cage = " --set nCseg=0 --set kNumPltElem=1 --set kPltElemInd=1",
                    alike = " --set rpm1=3000 --set rpm2=3000";
  struct Scene {
    std::string name, options;
    std::set<std::string> has, has_not;
  };
  std::set<std::string> ratios = cage, all = heat;
  ratios.insert("mean_orbital_ratio");
  all.insert(means.begin(), means.end());
  const std::vector<Scene> scenes{
      {"whole", " --until 0.01rev", all, {}},
      {"no cage", no_cage + " --until 0.01rev", heat, cage},
      {"no friction",
       no_cage + " --opt 'effectsOff=ball / race traction' --opt contactDamping=0 --until 0.01rev",
       {"mean_orbital_ratio"},
       heat},
      {"no step", " --set maxStps=0", {"largest_contact_load_N", "power_loss_W"}, means},
      {"races that turn alike", alike + " --until 1e-5s", {"mean_power_loss_W"}, ratios}};
  for (const Scene& scene : scenes) {
    const fs::path out = folder / scene.name;
    const Result sweep =
        run_adore("run " + folder.path().string() + scene.options +
                  " --set appLoadX=1000.0:2000.0:2 --quiet --out '" + out.string() + "'");
    INFO(scene.name << '\n' << sweep.out << read(out / "SWEEP.csv"));
    CHECK(sweep.code == 0);
    const std::set<std::string> found = with_values(out / "SWEEP.csv");
    for (const std::string& name : scene.has) {
      INFO(name);
      CHECK(found.count(name) == 1);
    }
    for (const std::string& name : scene.has_not) {
      INFO(name);
      CHECK(found.count(name) == 0);
    }
    // What did not move says so.
    CHECK(contains(sweep.out, "2 runs of the sweep simulated no motion") ==
          (scene.name == "no step"));
  }
}

TEST_CASE("a sweep of an English deck names its unit, and progress counts runs", "[cli]") {
  const Folder folder;
  const std::string deck = (folder / "E.txt").string();
  REQUIRE(run_adore("new ball-english --out " + deck).code == 0);
  const Result sweep = run_adore(
      "run " + deck + " --set mode=-1 --set appLoadX=100.0:300.0:2 --progress plain --out " +
      folder.path().string());
  INFO(sweep.out);
  REQUIRE(sweep.code == 0);
  CHECK(read(folder / "SWEEP.csv").rfind("appLoadX [lbf],exit,", 0) == 0);
  CHECK(contains(sweep.out, "run 2 of 2"));
  CHECK_FALSE(contains(sweep.out, "real time"));
}

TEST_CASE("a sweep whose runs all fail still leaves its table with the reasons", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result sweep =
      run_adore("run " + folder.path().string() + " --set brgOD=0.001:0.002:2 --quiet --out " +
                (folder / "sweep").string());
  INFO(sweep.out);
  CHECK(sweep.code == 2);
  CHECK(read(folder / "sweep" / "SWEEP.csv").find("brgOD") != std::string::npos);
}

TEST_CASE("sweep: failed runs → command that repeats only them", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string line = "run " + folder.path().string() +
                           " --set mode=-1 --set raceCurFac1=0.4:0.52:3 --out " +
                           (folder / "sweep").string();
  const Result sweep = run_adore(line);
  INFO(sweep.out);
  CHECK(sweep.code == 2);
  CHECK(contains(sweep.out, "2 runs have no result; run them again with"));
  CHECK(contains(sweep.out, "--set raceCurFac1=0.4:0.52:3"));
  CHECK(contains(sweep.out, "--continue"));
  const auto failed = [&] { return json::parse(read(folder / "sweep/SWEEP.json"))["failed"]; };
  CHECK(failed() == 2);
  // One that gave up on its way, of which there is a report.
  const fs::path good = folder / "sweep/raceCurFac1-3/RUN.json";
  std::string text = read(good);
  REQUIRE(contains(text, "\"status\": \"done\""));
  const auto time = fs::last_write_time(good);
  CHECK(run_adore(line + " --continue").code == 2);
  CHECK(fs::last_write_time(good) == time);
  text.replace(text.find("\"status\": \"done\""), 16, "\"status\": \"failed\"");
  std::ofstream(good) << text;
  CHECK(run_adore(line + " --continue").code == 2);
  CHECK(contains(read(good), "\"status\": \"done\""));
  CHECK(failed() == 2);
}

TEST_CASE("run without steps → no continuation command", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  for (const char* still : {"maxStps=0", "fTime=0.0"}) {
    const Result run = run_adore("run " + folder.path().string() + " --overwrite --set " + still);
    INFO(run.out);
    CHECK(run.code == 0);
    CHECK_FALSE(contains(run.out, "continue:"));
  }
}

TEST_CASE("sweep: unknown variable → ends before a file is written", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result sweep =
      run_adore("run " + folder.path().string() + " --set appLodX=1:2:2 --quiet --out " +
                (folder / "sweep").string());
  INFO(sweep.out);
  CHECK(sweep.code == 2);
  CHECK(contains(sweep.out, "did you mean appLoadX"));
  CHECK_FALSE(fs::exists(folder / "sweep"));
}

TEST_CASE("sweep: killed → table kept, only missing runs computed", "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string sweep = " --set mode=-1 --set appLoadX=500.0:900.0:5 --threads 1 --quiet";
  const std::string run = "run " + folder.path().string() + sweep + " --out ";
  REQUIRE(run_as_given(run + (folder / "whole").string()).code == 0);
  const std::string whole = read(folder / "whole" / "SWEEP.csv"),
                    broken = (folder / "broken").string();

  // Killed at a call of its own choice, not after a time.
  const Result counted = run_as_given(
      run + (folder / "counted").string(),
      "LD_PRELOAD=" ADORE_KILL_SHIM " ADORE_COUNT_CALLS=" + (folder / "calls").string());
  REQUIRE(counted.code == 0);
  const long calls = std::stol(read(folder / "calls"));
  const Result killed = run_as_given(run + broken, "LD_PRELOAD=" ADORE_KILL_SHIM " ADORE_KILL_AT=" +
                                                       std::to_string(calls * 7 / 10));
  CHECK(killed.code == 128 + SIGKILL);
  REQUIRE(fs::exists(folder / "broken" / "SWEEP.csv"));
  const auto mark = [&] { return json::parse(read(folder / "broken" / "SWEEP.json")); };
  CHECK(mark()["sweep"] == "appLoadX=500.0:900.0:5");
  CHECK(mark()["status"] == "running");
  const auto first = fs::last_write_time(folder / "broken" / "appLoadX-1" / "RUN.json");

  const Result refused = run_as_given(run + broken + " < /dev/null");
  CHECK(refused.code == 2);
  CHECK(contains(refused.out, "--continue"));
  const Result more = run_as_given(run + broken + " --continue");
  INFO(more.out);
  REQUIRE(more.code == 0);
  CHECK(mark()["status"] == "done");
  CHECK(read(folder / "broken" / "SWEEP.csv") == whole);
  CHECK(fs::last_write_time(folder / "broken" / "appLoadX-1" / "RUN.json") == first);

  // A result of another release is no reason to compute a finished run again.
  const fs::path one = folder / "broken" / "appLoadX-2" / "RUN.json";
  std::string text = read(one);
  const std::string summary = "\"summary\": {";
  REQUIRE(contains(text, summary));
  text.insert(text.find(summary) + summary.size(), "\n    \"of_another_release\": 1.0,");
  std::ofstream(one) << text;
  const Result kept = run_as_given(run + broken + " --continue");
  INFO(kept.out);
  REQUIRE(kept.code == 0);
  CHECK(contains(kept.out, "of_another_release"));
  CHECK(read(one) == text);
  CHECK(read(folder / "broken" / "SWEEP.csv") == whole);

  // Another deck: nothing of the old runs is taken over.
  const Result other = run_as_given(run + broken + " --continue --set appLoadZ=100.0");
  INFO(other.out);
  REQUIRE(other.code == 0);
  CHECK(read(folder / "broken" / "SWEEP.csv") != whole);
}

TEST_CASE("adore accuracy studies a deck's own run and puts what it finds into the deck", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string line = "accuracy " + folder.path().string() +
                           " --methods rkf5,rkf7 --tols 1e-5,1e-6 --turns 0.05 --budget 10 "
                           "--accuracy 50% --out " +
                           (folder / "study").string();
  const std::string before = read(folder / "DATA.txt");
  const Result study = run_adore(line);
  INFO(study.out);
  REQUIRE(study.code == 0);
  CHECK(contains(study.out, "the fastest settings that keep all errors within 50 %"));
  const json found = json::parse(read(folder / "study" / "ACCURACY.json"));
  CHECK(found["complete"] == true);
  CHECK(found["finals"].size() >= 2);
  std::istringstream csv(read(folder / "study" / "ACCURACY.csv"));
  std::size_t lines = 0;
  for (std::string text; std::getline(csv, text);) ++lines;
  CHECK(lines == 1 + found["screening"].size() + found["finals"].size() + found["models"].size());
  CHECK(read(folder / "DATA.txt") == before);

  // From the rows that are there: nothing runs, and the deck gets what they recommend.
  const Result applied = run_adore(line + " --continue --apply");
  INFO(applied.out);
  REQUIRE(applied.code == 0);
  const std::string after = read(folder / "DATA.txt");
  CHECK(contains(after, "stpInit stpMin stpMax fTime tol qFac"));  // remarks stay
  const auto& best = found["finals"][found["recommended"].get<std::size_t>()];
  const Result checked = run_adore("check " + folder.path().string());
  CHECK(checked.code == 0);
  if (!best["own"].get<bool>()) CHECK(after != before);
}

TEST_CASE("adore run --accuracy: settings reported and used for the continuation", "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run =
      run_adore("run " + folder.path().string() + " --until 0.02rev --accuracy 30% --out " +
                (folder / "out").string());
  INFO(run.out);
  REQUIRE(run.code == 0);
  CHECK(contains(run.out, "settings for an error of 30 %"));
  CHECK(contains(run.out, "ellipse nodes"));
  const std::size_t at = run.out.find("continue:");
  REQUIRE(at != std::string::npos);
  const std::string way_on = run.out.substr(at, run.out.find('\n', at) - at);
  CHECK(contains(way_on, "--integrator "));
  CHECK(contains(way_on, "--opt ellipseMajor="));
  const json report = json::parse(read(folder / "out" / "RUN.json"));
  CHECK(contains(report["notes"].dump(), "settings for an error of 30 %"));
}

TEST_CASE("adore plan, check and new: --until and --set act", "[cli]") {
  const Folder folder;
  const std::string deck = (folder / "DATA.txt").string();
  const Result made = run_adore("new ball --set rpm2=4321 --out " + deck);
  REQUIRE(made.code == 0);
  CHECK(contains(read(folder / "DATA.txt"), "4321"));
  CHECK(contains(made.out, "4321 rpm"));
  CHECK(run_adore("new ball --set rpm3=1 --out " + (folder / "no.txt").string()).code == 2);
  CHECK(run_adore("check " + deck + " --set pitchDia=0.001").code == 2);
  CHECK(run_adore("check " + deck + " --set rpm2=5000").code == 0);
  const Result plan = run_adore("plan " + deck + " --until 0.02rev");
  CHECK(plan.code == 0);
  CHECK(contains(plan.out, "processor time of the whole run"));
  CHECK(contains(plan.out, "the pilot run simulated the whole run"));
  CHECK(contains(plan.out, "0.02 revolutions"));
  const json none = json::parse(run_adore("plan " + deck + " --pilot 0 --json").out);
  CHECK_FALSE(none.contains("run_cost"));
  CHECK(run_adore("run " + deck + " --extend").code == 2);
}

TEST_CASE("adore run --verify: sensitivity of the results to the tolerance reported", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run = run_adore("run " + folder.path().string() +
                               " --until 0.02rev --verify --out " + (folder / "out").string());
  INFO(run.out);
  REQUIRE(run.code == 0);
  CHECK(contains(run.out, "verified:  compared with tol 1e-07"));
  CHECK(contains(run.out, "accuracy:  over the 0.02 revolutions of this run, 95 % intervals"));
  const json report = json::parse(read(folder / "out" / "RUN.json"));
  CHECK(report["accuracy"]["quantities"].size() >= 10);
  CHECK(report["verify"]["results"].contains("mean_cage_ratio"));
  // Whatever was set by hand.
  for (const char* sets : {"stpMax=0.8", "nStps=2", "stpMin=1e-4", "kIcOpt=0", "tol=1e-5"}) {
    const Result again =
        run_adore("run " + folder.path().string() + " --until 0.01rev --verify --set " + sets +
                  " --overwrite --out " + (folder / "again").string());
    INFO(sets << '\n' << again.out);
    CHECK(again.code == 0);
    CHECK(contains(again.out, "verified:  compared with tol"));
  }
  CHECK(contains(run.out, "loads"));
  const Result both =
      run_adore("run " + folder.path().string() + " --set rpm2=1000:2000:2 --verify --out " +
                (folder / "sweep").string());
  CHECK(both.code == 2);
  CHECK(contains(both.out, "this is a sweep"));
}
