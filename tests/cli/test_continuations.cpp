#include "cli/driver.hpp"
#include "integrators/stepper.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <vector>

/// Runs that stop anywhere and continue: RESULTS.h5 can be restored from MASTER.
using namespace adore;
using namespace adore::test;

namespace {

constexpr const char* kFiles[] = {"RESULTS.h5", "SOL1", "SOL2", "SOL3",
                                  "SOL4",       "SOL7", "SOL8", "FINAL"};
const char* const kPreload = "LD_PRELOAD=" ADORE_KILL_SHIM " ";

/// Names of checkpoints that a run left: MASTER.0000, MASTER.0001, ...
std::vector<std::string> checkpoints(const fs::path& folder) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string(); name.starts_with("MASTER."))
      out.push_back(name);
  std::sort(out.begin(), out.end());
  return out;
}

/// As if the run had been killed behind that checkpoint, with all that it wrote later in its files.
void go_back(const fs::path& whole, const std::string& checkpoint, const fs::path& to) {
  std::error_code error;
  fs::remove_all(to, error);
  fs::create_directory(to);
  for (const auto& entry : fs::directory_iterator(whole))
    if (const std::string name = entry.path().filename().string(); !name.starts_with("MASTER"))
      fs::copy_file(entry.path(), to / name);
  fs::copy_file(whole / checkpoint, to / "MASTER");
  std::string report = read(to / "RUN.json");
  const std::string done = "\"status\": \"done\"";
  REQUIRE(contains(report, done));
  write(to / "RUN.json", report.replace(report.find(done), done.size(), "\"status\": \"running\""));
}

/// Continues the run `set` of the folder's deck from each of its checkpoints.
void check_every_stop(const Folder& folder, const std::string& set) {
  const std::string run = "run " + (folder / "DATA.txt").string() + " --quiet " + set;
  const fs::path whole = folder / "whole", parts = folder / "parts";
  const Result unbroken =
      run_as_given(run + " --opt checkpointSeconds=1e-9 --overwrite --out " + whole.string(),
                   std::string(kPreload) + "ADORE_KEEP=MASTER");
  INFO(set << "\n" << unbroken.out);
  REQUIRE(unbroken.code == 0);
  const std::vector<std::string> stops = checkpoints(whole);
  REQUIRE(stops.size() >= 8);
  for (const std::string& stop : stops) {
    go_back(whole, stop, parts);
    const Result more = run_as_given(run + " --continue --out " + parts.string());
    INFO(stop << "\n" << more.out);
    REQUIRE(more.code == 0);
    for (const char* name : kFiles) {
      if (!fs::exists(whole / name)) continue;
      INFO(name);
      CHECK(read(parts / name) == read(whole / name));
    }
  }
  fs::remove_all(whole);
}

}  // namespace

TEST_CASE("a run of any method that keeps its past joins to the same bytes from every checkpoint",
          "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  // Two steps a counted step: checkpoints also inside one.
  const std::string often = "--set maxStps=5 --set nStps=2 --set kPltFreq=1 --set kAGraf=1 ";
  int methods = 0;
  for (const std::string_view name : integrators::stepper_names()) {
    if (!integrators::make_stepper(name)->loses().empty()) continue;
    ++methods;
    // Euler's method is rejected at longer steps.
    const std::string short_steps =
        name == "rkf1" ? " --set stpMin=0.001 --set stpMax=0.003 --set stpInit=0.003" : "";
    check_every_stop(folder, often + "--integrator " + std::string(name) + short_steps);
  }
  CHECK(methods >= 15);
}

TEST_CASE("constant steps and balls in balance: continuation from every checkpoint → same bytes",
          "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string often = "--set nStps=3 --set kPltFreq=1 --set kAGraf=2 --set kLifeFreq=2 ";
  check_every_stop(folder, often +
                               "--integrator pece8 --set maxStps=9 --set stpMin=0.05 --set "
                               "stpMax=0.05 --set stpInit=0.05");
  check_every_stop(folder, often +
                               "--integrator rkf4 --set maxStps=12 --set appLoadX=200 --set "
                               "appLoadZ=2000 --set qFac=0.1");
}

TEST_CASE("steps that are judged by their energy join to the same bytes from every checkpoint",
          "[cli][slow]") {
  // Rollers that hammer a free race (tests/core/runs/test_hammering.cpp).
  const Folder folder;
  REQUIRE(run_adore("new cylindrical --out " + (folder / "DATA.txt").string()).code == 0);
  check_every_stop(
      folder,
      "--set maxStps=9 --set nStps=15 --set kPltFreq=1 --set kAGraf=2 --set kLifeFreq=0 --set "
      "kDCR=1 --set kFD11=0 --set kFD21=0 --set kFD31=0 --set kRotFrame=1 --set brgOrbitRad=0.1 "
      "--set brgAngVel=500 --set brgLoadFrac2=1 --set nCseg=0 --set kFS3=1 --set appDispZ=1e-5 "
      "--set kNumPltElem=1 --set kPltElemInd=1");
}

// A run is "done" when the last byte of its results is written: it cannot be continued.
TEST_CASE("a run killed at any of its last calls that change a file is completed to the same bytes",
          "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string run = "run " + (folder / "DATA.txt").string() +
                          " --quiet --set maxStps=4 --set nStps=2 --set kPltFreq=1 --set kAGraf=1 "
                          "--out ";
  const fs::path whole = folder / "whole", parts = folder / "parts";
  const Result counted = run_as_given(
      run + whole.string(), kPreload + ("ADORE_COUNT_CALLS=" + (folder / "calls").string()));
  INFO(counted.out);
  REQUIRE(counted.code == 0);
  const long calls = std::stol(read(folder / "calls"));
  REQUIRE(calls > 100);
  int nothing_left = 0;
  for (long at = calls - 19; at <= calls; ++at) {
    std::error_code error;
    fs::remove_all(parts, error);
    const Result killed =
        run_as_given(run + parts.string(), kPreload + fmt::format("ADORE_KILL_AT={}", at));
    INFO("killed before call " << at << " of " << calls << "\n" << killed.out);
    REQUIRE(killed.code == 128 + SIGKILL);
    const Result more = run_as_given(run + parts.string() + " --continue");
    INFO(more.out);
    REQUIRE(more.code == 0);
    if (contains(more.out, "the run is complete")) ++nothing_left;
    for (const char* name : kFiles) {
      INFO(name);
      CHECK(read(parts / name) == read(whole / name));
    }
  }
  CHECK(nothing_left > 0);   // the window behind "done" is among them,
  CHECK(nothing_left < 10);  // and calls before it
}

TEST_CASE("damaged number in MASTER → run continues, is rejected, or fails with a message",
          "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string run = "run " + (folder / "DATA.txt").string() +
                          " --quiet --integrator pece4 --set nStps=2 --set kPltFreq=1 --out ";
  const fs::path whole = folder / "whole", parts = folder / "parts";
  REQUIRE(run_as_given(run + whole.string() + " --set maxStps=4").code == 0);
  // One line of each kind: names that differ by their digits only are of a kind.
  std::istringstream lines(read(whole / "MASTER"));
  std::vector<std::string> master;
  std::set<std::string> known;
  std::vector<std::size_t> chosen;
  // As of a release before checksums, which would refuse all.
  for (std::string line; std::getline(lines, line);)
    master.push_back(line == "format 4" ? "format 2" : line.starts_with("end ") ? "end" : line);
  CHECK(master[2] == "format 2");
  for (std::size_t i = 4; i < master.size(); ++i) {
    const std::string& line = master[i];
    const std::size_t blank = line.find(' ');
    if (line.starts_with("deck ")) i += std::stoul(line.substr(blank));
    if (blank == std::string::npos || line.starts_with("deck ")) continue;
    const bool first = line[0] == '-' || std::isdigit(static_cast<unsigned char>(line[0])) != 0;
    std::string kind = first ? line.substr(blank) : line.substr(0, blank);
    std::erase_if(kind, [](unsigned char c) { return std::isdigit(c) != 0; });
    if (known.insert(kind).second) chosen.push_back(i);
  }
  CHECK(chosen.size() > 100);
  int refused = 0, runs = 0;
  for (const std::size_t i : chosen) {
    for (const std::string value : {"nan", "-1", "1e300"}) {
      const std::size_t blank = master[i].find(' ');
      const bool first =
          master[i][0] == '-' || std::isdigit(static_cast<unsigned char>(master[i][0])) != 0;
      std::string text;
      for (std::size_t k = 0; k < master.size(); ++k)
        text += (k != i  ? master[k]
                 : first ? value + master[k].substr(blank)
                         : master[k].substr(0, blank) + " " + value) +
                "\n";
      std::error_code error;
      fs::remove_all(parts, error);
      fs::copy(whole, parts);
      write(parts / "MASTER", text);
      const Result more = run_shell("timeout 60 ADORE " + run + parts.string() +
                                    " --set maxStps=6 --continue 2>&1");
      INFO(master[i] << " became " << value << "\n" << more.out);
      // 0 it counts for nothing, or is a state; 2 refused; 3 a state in which the bearing cannot be
      CHECK((more.code == 0 || more.code == 2 || more.code == 3));
      if (value == "nan" && !master[i].starts_with("version ")) CHECK(more.code == 2);
      ++runs;
      refused += more.code == 2;
    }
  }
  CHECK(refused > runs / 4);
}
