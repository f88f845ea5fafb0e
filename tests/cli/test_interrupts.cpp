#include "cli/driver.hpp"
#include "results/continuation.hpp"
#include "results/restart.hpp"
#include "results/results_h5.hpp"
#include "results/sol_file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

/// Runs that end from outside: these tests do not wait for a time, only for actions of the program.
using namespace adore;
using namespace adore::test;
using nlohmann::json;

namespace {

/// The next steps of the run in the folder, in any state.
const char* const kMore = " --quiet --set kIcOpt=1 --set fTime=1e12 --set maxStps=5";

results::SolFile stored(const fs::path& path) { return results::read_sol(path, {1, 1000000, 1}); }

void check_increasing(const results::SolFile& file) {
  CHECK(file.note.empty());
  for (std::size_t i = 1; i < file.steps.size(); ++i)
    CHECK(file.steps[i].step > file.steps[i - 1].step);
}

/// MASTER's step, -1 while there is none.
long master_step(const Folder& folder) {
  std::error_code error;
  return fs::exists(folder / "MASTER", error) ? results::read_master(folder / "MASTER").last.step
                                              : -1;
}

/// A message that the terminal's width has broken.
std::string in_one_line(const std::string& text) {
  std::string out;
  std::istringstream words(text);
  for (std::string word; words >> word;) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::vector<std::string> hidden_files(const Folder& folder) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    if (entry.path().filename().string().front() == '.')
      out.push_back(entry.path().filename().string());
  return out;
}

/// PRINT.txt without what each process measures for itself: the evaluations, of which a
/// continuation takes one more, and the computing times at its end.
std::string listed_results(const Folder& folder) {
  const std::string text = read(folder / "PRINT.txt");
  std::istringstream lines(text.substr(0, text.find("  Cost: computing time")));
  std::string out;
  for (std::string line; std::getline(lines, line);)
    if (!contains(line, "  Counter: evaluations")) out += line + "\n";
  CHECK(contains(out, "Conservation of momentum"));
  return out;
}

}  // namespace

TEST_CASE("an interrupted run leaves valid files and exit code 130, and continues from there",
          "[cli][slow]") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Folder folder;
    new_ball_deck(folder);
    EndlessRun run(folder);
    wait_for([&] { return master_step(folder) > 10; });
    run.send(signal);
    CHECK(run.end() == 130);
    const std::string said = run.said();
    INFO(signal << "\n" << said);
    CHECK(contains(said, "--continue"));
    CHECK(contains(said, "--until 1e9rev"));
    check_increasing(stored(folder / "SOL1"));
    const auto state = results::read_final(folder / "FINAL");
    CHECK(state.step == stored(folder / "SOL1").steps.back().step);
    CHECK(json::parse(read(folder / "RUN.json")).at("status") == "interrupted");
    CHECK(hidden_files(folder).empty());

    const long step = master_step(folder);
    const Result more = run_adore("run " + folder.path().string() + kMore);
    INFO(more.out);
    REQUIRE(more.code == 0);
    const auto longer = stored(folder / "SOL1");
    check_increasing(longer);
    CHECK(longer.steps.back().step == step + 5);
  }
}

TEST_CASE("the second interrupt ends the program at once", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  EndlessRun run(folder);
  wait_for([&] { return master_step(folder) >= 0; });
  run.send(SIGSTOP);  // both wait for it
  run.send(SIGINT);
  run.send(SIGTERM);
  run.send(SIGCONT);
  CHECK(run.end() == 130);
  CHECK_FALSE(contains(run.said(), "interrupted"));
}

TEST_CASE("interrupt: noticed within a counted step and in a table of statics", "[cli][slow]") {
  {
    const Folder folder;
    new_ball_deck(folder);
    EndlessRun run(folder, {"--set", "nStps=1000000000"});
    wait_for([&] {
      return master_step(folder) >= 0 && results::read_master(folder / "MASTER").last.time > 0.0;
    });
    run.send(SIGINT);
    CHECK(run.end() == 130);
    const auto master = results::read_master(folder / "MASTER");
    CHECK(master.last.step == 0);
    CHECK(master.averages.at("substeps of the step under way") > 0.0);
    CHECK(results::read_final(folder / "FINAL").step == 1);
    check_increasing(stored(folder / "SOL1"));
  }
  const Folder folder;
  new_ball_deck(folder);
  EndlessRun run(folder,
                 {"--set", "mode=-1", "--set", "kStif=10000", "--set", "pctDisp=1.0", "--set",
                  "rpmRange12=10.0", "--set", "rpmRange22=12000.0"},
                 "");
  wait_for([&] { return contains(run.said(), " of 10000"); });
  run.send(SIGTERM);
  CHECK(run.end() == 130);
  CHECK(contains(run.said(), "no files were written"));
  CHECK_FALSE(fs::exists(folder / "PRINT.txt"));
}

TEST_CASE("a checkpoint holds the state, not the last stored step", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  EndlessRun run(folder, {"--set", "kPltFreq=100000000", "--set", "kPrtFreq=100000000", "--set",
                          "kAGraf=0", "--set", "kLifeFreq=0"});
  wait_for([&] { return master_step(folder) > 20; });
  run.send(SIGKILL);
  CHECK(run.end() == 128 + SIGKILL);
  const auto master = results::read_master(folder / "MASTER");
  CHECK(master.last.time > 0.0);
  CHECK(stored(folder / "SOL1").steps.size() == 1);
  const Result more = run_adore("run " + folder.path().string() + kMore +
                                " --set kPltFreq=100000000 --set kPrtFreq=100000000 --set kAGraf=0 "
                                "--set kLifeFreq=0");
  INFO(more.out);
  REQUIRE(more.code == 0);
  CHECK(results::read_final(folder / "FINAL").step == master.last.step + 5);
}

TEST_CASE("a killed run leaves readable files and continues from its last checkpoint",
          "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  EndlessRun run(folder);
  wait_for([&] { return master_step(folder) > 80; });
  run.send(SIGKILL);
  CHECK(run.end() == 128 + SIGKILL);
  const auto master = results::read_master(folder / "MASTER");
  const auto file = stored(folder / "SOL7");
  REQUIRE_FALSE(file.steps.empty());
  CHECK(file.steps.back().step >= static_cast<long>(master.averages.at("last step in SOL1-SOL7")));
  CHECK(json::parse(read(folder / "RUN.json")).at("status") == "running");
  CHECK(run_adore("show " + (folder / "RESULTS.h5").string()).code == 0);

  // As far as it has stored already, and five steps more.
  const long steps = file.steps.back().step - master.last.step + 5;
  const Result more =
      run_adore(fmt::format("run {}{} --set maxStps={}", folder.path().string(), kMore, steps));
  INFO(more.out);
  REQUIRE(more.code == 0);
  const auto longer = stored(folder / "SOL7");
  CHECK(longer.steps.back().step == master.last.step + steps);
  check_increasing(longer);
  CHECK(hidden_files(folder).empty());
}

TEST_CASE("killed run: steps after its checkpoint → kept for an earlier end", "[cli]") {
  // Whichever of the files is the denser one.
  for (const auto& [dense, sets] : {std::pair{"SOL7", std::pair{"kPltFreq=1", "kAGraf=100000"}},
                                    std::pair{"SOL8", std::pair{"kPltFreq=100000", "kAGraf=1"}}}) {
    const Folder folder;
    new_ball_deck(folder);
    EndlessRun run(folder, {"--set", sets.first, "--set", sets.second}, "1e9rev", "1000");
    const fs::path file = folder / dense;
    wait_for([&] {
      return master_step(folder) == 0 && fs::exists(file) && fs::file_size(file) > 100000;
    });
    run.send(SIGKILL);
    CHECK(run.end() == 128 + SIGKILL);
    REQUIRE(results::read_master(folder / "MASTER").last.step == 0);
    const std::string before = read(file);
    const auto [step, time] = results::last_stored_step(file);
    REQUIRE(step > 20);
    const std::string command = fmt::format("run {} --quiet --continue --set {} --set {}",
                                            folder.path().string(), sets.first, sets.second);
    for (const std::string& end : {fmt::format(" --until {:.9e}s", 0.9 * time),
                                   fmt::format(" --set fTime=1e12 --set maxStps={}", step - 2)}) {
      const Result refused = run_adore(command + end);
      INFO(refused.out);
      CHECK(refused.code == 2);
      CHECK(contains(in_one_line(refused.out),
                     fmt::format("has stored results up to step {},", step)));
      CHECK(contains(in_one_line(refused.out), "Its last checkpoint is at step 0,"));
      CHECK(read(file) == before);
    }
    const Result more =
        run_adore(command + fmt::format(" --set fTime=1e12 --set maxStps={}", step + 3));
    INFO(more.out);
    REQUIRE(more.code == 0);
    // The same steps computed again, and three more.
    const std::string after = read(file);
    const std::size_t whole = before.rfind('\n', before.size() - 2);
    CHECK(after.substr(0, whole) == before.substr(0, whole));
    CHECK(results::last_stored_step(file).first == step + 3);
  }
}

TEST_CASE("pages of a listing that is denser than the plots are not dropped by an earlier end",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::vector<std::string> dense{"--set", "kPrtFreq=1", "--set", "kPltFreq=1000000",
                                       "--set", "kAGraf=0",   "--set", "kPrtOpt=-2"};
  EndlessRun run(folder, dense, "1e9rev", "1000");
  const fs::path print = folder / "PRINT.txt";
  wait_for([&] { return master_step(folder) == 0 && contains(read(print), "STEP 40\n"); });
  run.send(SIGKILL);
  CHECK(run.end() == 128 + SIGKILL);
  REQUIRE(stored(folder / "SOL7").steps.back().step == 0);
  const std::string before = read(print);
  long last = 40;
  while (contains(before, fmt::format("STEP {}\n", last + 1))) ++last;
  std::string command = "run " + folder.path().string() + " --quiet --continue";
  for (const std::string& word : dense) command += " " + word;
  const Result refused =
      run_adore(command + fmt::format(" --set fTime=1e12 --set maxStps={}", last - 5));
  INFO(refused.out);
  CHECK(refused.code == 2);
  CHECK(contains(refused.out, "has stored results up to step"));
  CHECK((read(print) == before));
  const Result more =
      run_adore(command + fmt::format(" --set fTime=1e12 --set maxStps={}", last + 3));
  INFO(more.out);
  REQUIRE(more.code == 0);
  CHECK(contains(read(print), fmt::format("STEP {}\n", last + 3)));
}

TEST_CASE("a run killed at any call that changes a file joins to the bytes of an unbroken one",
          "[cli][slow]") {
  // Three steps a counted step, a checkpoint after each: the same calls on every machine.
  const std::string how =
      " --quiet --opt checkpointSeconds=1e-9 --set maxStps=9 --set nStps=3 --set kPltFreq=2 --set "
      "kPrtFreq=4 --set kAGraf=3 --set kLifeFreq=2";
  for (const std::string method : {"rkf5", "pece4"}) {
    const std::string set = how + " --integrator " + method;
    const Folder whole;
    new_ball_deck(whole);
    const std::string preload = "LD_PRELOAD=" ADORE_KILL_SHIM " ";
    const Result counted = run_adore("run " + whole.path().string() + set,
                                     preload + "ADORE_COUNT_CALLS=" + (whole / "calls").string());
    INFO(counted.out);
    REQUIRE(counted.code == 0);
    const long calls = std::stol(read(whole / "calls"));
    REQUIRE(calls > 200);
    constexpr long kKills = 14;
    for (long k = 0; k < kKills; ++k) {
      const long at = 1 + k * (calls - 2) / (kKills - 1);
      const Folder folder;
      new_ball_deck(folder);
      const std::string run = "run " + folder.path().string() + set;
      const Result killed = run_as_given(
          run,
          preload + fmt::format("ADORE_KILL_AT={} {}", at, k % 2 == 0 ? "" : "ADORE_KILL_AFTER=1"));
      INFO(method << " killed at call " << at << " of " << calls << "\n" << killed.out);
      REQUIRE(killed.code == 128 + SIGKILL);
      Result more = run_as_given(run + " --continue");
      if (more.code == 2) {  // before the first checkpoint: the message explains a new start
        CHECK(contains(more.out, "--overwrite"));
        more = run_as_given(run + " --overwrite");
      }
      INFO(more.out);
      REQUIRE(more.code == 0);
      for (const char* name :
           {"SOL1", "SOL2", "SOL3", "SOL4", "SOL7", "SOL8", "FINAL", "RESULTS.h5"}) {
        INFO(name);
        CHECK(read(folder / name) == read(whole / name));
      }
      CHECK(listed_results(folder) == listed_results(whole));
      const auto evaluations = [](const Folder& of) {
        return nlohmann::json::parse(read(of / "RUN.json")).at("counters").at("evaluations");
      };
      const long spent = evaluations(folder), unbroken = evaluations(whole);
      CHECK((spent == unbroken || spent == unbroken + 1));
      CHECK(hidden_files(folder).empty());
    }
  }
}

TEST_CASE("integrators without stored history → reported, continue within their tolerance",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = "run " + folder.path().string() + " --integrator cvode-bdf --quiet ";
  REQUIRE(run_adore(deck + "--set maxStps=40 --out " + (folder / "whole").string()).code == 0);
  const std::string parts = " --out " + (folder / "parts").string();
  REQUIRE(run_adore(deck + "--set maxStps=20" + parts).code == 0);
  const Result more = run_adore(deck + "--set maxStps=20 --set kIcOpt=1" + parts);
  INFO(more.out);
  REQUIRE(more.code == 0);
  CHECK(contains(more.out, "its order and its past steps"));
  CHECK(contains(read(folder / "parts" / "RUN.json"), "its order and its past steps"));
}

TEST_CASE("a complete run is continued to a later end only, and stores no step twice", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = "run " + folder.path().string() + " --quiet ";
  REQUIRE(run_as_given(deck + "--until 0.02rev").code == 0);
  const auto before = stored(folder / "SOL1");
  const std::string report = read(folder / "RUN.json");
  const Result again = run_as_given(deck + "--until 0.02rev --continue");
  INFO(again.out);
  CHECK(again.code == 0);
  CHECK(contains(again.out, "the run is complete"));
  CHECK(read(folder / "RUN.json") == report);

  const Result sooner = run_as_given(deck + "--until 0.01rev --continue");
  INFO(sooner.out);
  CHECK(sooner.code == 2);
  CHECK(contains(sooner.out, "later end"));
  CHECK(read(folder / "RUN.json") == report);

  // The step that the end shortened is not used for the continuation.
  const double cut = results::read_master(folder / "MASTER").last.step_size;
  CHECK(results::read_master(folder / "MASTER").averages.at("stepper memory next step") > cut);
  REQUIRE(run_as_given(deck + "--until 0.04rev --continue").code == 0);
  const auto after = stored(folder / "SOL1");
  check_increasing(after);
  REQUIRE(after.steps.size() > before.steps.size());
  CHECK(after.steps[before.steps.size() - 1].step == before.steps.back().step);
  CHECK(after.steps.back().revolutions == Approx(0.04).epsilon(1e-6));
}

TEST_CASE("option --continue without a run → rejected", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result none = run_as_given("run " + folder.path().string() + " --continue");
  CHECK(none.code == 2);
  CHECK(contains(none.out, "no run to continue"));
  CHECK(contains(none.out, "--overwrite"));
  const Result still = run_as_given("run " + folder.path().string() + " --set mode=-1 --continue");
  CHECK(still.code == 2);
  CHECK(contains(still.out, "quasi-static"));
}

TEST_CASE("file size limit → run stops with a message, valid files, and a continuation command",
          "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = "run " + folder.path().string() + " --quiet --set kPltFreq=1";
  // RESULTS.h5 begins with 5 MB, its first block of 256 steps among them; not many more have room.
  const Result stopped = run_shell("ulimit -f 5900; ADORE " + deck + " --until 1e9rev 2>&1");
  INFO(stopped.out);
  CHECK(stopped.code == 2);
  CHECK(contains(stopped.out, "File too large"));
  CHECK(contains(stopped.out, "continue the run with --continue"));
  check_increasing(stored(folder / "SOL1"));
  const results::H5Reader before(folder / "RESULTS.h5");
  CHECK(before.steps() > 10);
  const Result more = run_adore(deck + " --continue --until 2rev");
  INFO(more.out);
  CHECK(more.code == 0);
  check_increasing(stored(folder / "SOL1"));
}

TEST_CASE("run ended before its first checkpoint → command for a new start", "[cli]") {
  // Room for no RESULTS.h5 at all, for an empty one, and for the listing's first pages alone.
  for (const int limit : {60, 300, 700}) {
    const Folder folder;
    new_ball_deck(folder);
    const std::string deck = "run " + folder.path().string() + " --quiet --set maxStps=2";
    const Result stopped = run_shell(fmt::format("ulimit -f {}; ADORE {} 2>&1", limit, deck));
    INFO(limit << "\n" << stopped.out);
    CHECK(stopped.code == 2);
    CHECK(contains(stopped.out, "File too large"));
    CHECK(contains(stopped.out, "did not reach its first checkpoint"));
    CHECK(contains(stopped.out, "--overwrite"));
    CHECK_FALSE(fs::exists(folder / "MASTER"));
    const Result more = run_as_given(deck + " --continue");
    INFO(more.out);
    CHECK(more.code == 2);
    CHECK(contains(more.out, "--overwrite"));
    const Result classic = run_as_given(deck + " --set kIcOpt=1");
    INFO(classic.out);
    CHECK(classic.code == 2);
    CHECK(contains(classic.out, "kIcOpt = 0"));
    CHECK(run_as_given(deck + " --overwrite").code == 0);
    CHECK(hidden_files(folder).empty());
  }
}

TEST_CASE("full disk of any small size → run ends with a message, no crash", "[cli][slow]") {
  const Folder place;
  if (run_shell("mount -t tmpfs -o size=64k none " + place.path().string() + " 2>&1").code != 0) {
    WARN("not done: mounting a small disk needs rights that this user does not have");
    return;
  }
  run_shell("umount " + place.path().string());
  const Folder decks;
  new_ball_deck(decks);
  for (const int size : {64, 176, 272, 368, 500, 620}) {
    REQUIRE(
        run_shell(fmt::format("mount -t tmpfs -o size={}k none {}", size, place.path().string()))
            .code == 0);
    const Result run = run_as_given("run " + decks.path().string() +
                                    " --quiet --opt checkpointSeconds=0.2 --set kPltFreq=1 --until "
                                    "1e9rev --out " +
                                    place.path().string());
    INFO(size << " kB\n" << run.out);
    CHECK(run.code == 2);
    CHECK(contains(run.out, "No space left"));
    if (fs::exists(place / "SOL1") && fs::file_size(place / "SOL1") > 0)
      check_increasing(stored(place / "SOL1"));
    if (fs::exists(place / "RESULTS.h5")) {
      const results::H5Reader file(place / "RESULTS.h5");
      CHECK(file.read("time").size() == file.steps());
    }
    CHECK(run_shell("umount " + place.path().string()).code == 0);
  }
}

TEST_CASE("other programs open the RESULTS.h5 of a killed run", "[cli][slow]") {
  if (run_shell("/usr/bin/python3 -c 'import h5py' 2>/dev/null").code != 0) {
    WARN("not done: python3 has no h5py");
    return;
  }
  const Folder folder;
  new_ball_deck(folder);
  EndlessRun run(folder, {"--set", "kPltFreq=1"});
  wait_for([&] { return master_step(folder) > 100; });
  run.send(SIGKILL);
  run.end();
  const Result opened = run_shell(
      "/usr/bin/python3 -c \"import h5py,sys; f=h5py.File(sys.argv[1],'r'); n=f['step'].shape[0]; "
      "f.visititems(lambda k,o: o[...] if isinstance(o,h5py.Dataset) else None); "
      "assert n > 50 and f['time'][n-1] > 0; print('steps', n)\" " +
      (folder / "RESULTS.h5").string() + " 2>&1");
  INFO(opened.out);
  CHECK(opened.code == 0);
}
