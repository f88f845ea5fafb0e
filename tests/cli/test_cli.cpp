#include "deck/deck.hpp"
#include "deck/reader.hpp"
#include "deck/schema.hpp"
#include "results/restart.hpp"
#include "results/sol_file.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// A folder of its own for one test, removed at the end.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "adore-cli-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct Result {
  int code = -1;
  std::string out;  ///< stdout and stderr together
};

std::string command_line(const std::string& arguments) {
  return std::string(ADORE_EXECUTABLE) + " " + arguments;
}

Result run_adore(const std::string& arguments, const std::string& environment = "") {
  Result result;
  FILE* pipe = popen((environment + " " + command_line(arguments) + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer{};
  std::size_t count = 0;
  while ((count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0)
    result.out.append(buffer.data(), count);
  const int status = pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream out;
  out << file.rdbuf();
  return out.str();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A new ball deck in the folder, stored often enough for short runs.
void new_ball_deck(const Folder& folder) {
  REQUIRE(run_adore("new ball --out " + (folder / "DATA.txt").string()).code == 0);
}

/// Starts a long run in the background and returns its process.
pid_t start_long_run(const Folder& folder, const std::string& set = "") {
  const pid_t child = fork();
  if (child == 0) {
    std::freopen("/dev/null", "w", stderr);
    std::freopen("/dev/null", "w", stdout);
    const std::string deck = folder.path().string();
    if (set.empty())
      execl(ADORE_EXECUTABLE, "adore", "run", deck.c_str(), "--until", "500rev", "--opt",
            "checkpointSeconds=0.2", nullptr);
    else
      execl(ADORE_EXECUTABLE, "adore", "run", deck.c_str(), "--until", "500rev", "--opt",
            "checkpointSeconds=0.2", "--set", set.c_str(), nullptr);
    _exit(99);
  }
  return child;
}

/// Waits until the run has stored some steps.
void wait_for_steps(const Folder& folder, std::uintmax_t bytes) {
  std::error_code error;
  for (int i = 0; i < 600 && (!fs::exists(folder / "SOL7", error) ||
                              fs::file_size(folder / "SOL7", error) < bytes);
       ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  REQUIRE(fs::file_size(folder / "SOL7") >= bytes);
}

}  // namespace

TEST_CASE("adore refuses what it cannot read with a sentence and exit code 2", "[cli]") {
  const Folder folder;
  write(folder / "empty.txt", "");
  write(folder / "binary.txt", std::string("\x7f"
                                           "ELF\0\1\2\3\0\0\0",
                                           11));
  new_ball_deck(folder);
  const std::string deck = (folder / "DATA.txt").string();

  const auto refused = [](const Result& result, const std::string& part) {
    INFO(result.out);
    CHECK(result.code == 2);
    CHECK(contains(result.out, part));
  };
  refused(run_adore("run " + (folder / "missing.txt").string()), "missing.txt");
  refused(run_adore("run " + (folder / "empty.txt").string()), "empty");
  refused(run_adore("run " + (folder / "binary.txt").string()), "binary");
  refused(run_adore("run " + deck + " --set pitchDai=0.06"), "pitchDia");
  refused(run_adore("run " + deck + " --set pitchDia=nan"), "pitchDia");
  refused(run_adore("run " + deck + " --set pitchDia=1e999"), "pitchDia");
  refused(run_adore("run " + deck + " --set nRe=2.5"), "nRe");
  refused(run_adore("run " + deck + " --opt ellipse=3"), "ellipseMajor");
  refused(run_adore("run " + deck + " --integrator euler"), "rkf1");
  refused(run_adore("run " + deck + " --until 5turns"), "5rev");
  refused(run_adore("run " + deck + " --tol -1"), "--tol");
  refused(run_adore("run " + deck + " --out /proc/adore"), "/proc/adore");
  refused(run_adore("check " + (folder / "nowhere").string()), "nowhere");
  refused(run_adore("calc no-such --json " + deck), "JSON");
  refused(run_adore("show " + deck), "DATA.txt");
  refused(run_adore("nonsense"), "subcommand");
}

TEST_CASE(
    "a deck that asks for what is not built checks clean and is refused by record and variable",
    "[cli]") {
  const Folder folder;
  for (const std::string type : {"cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const std::string deck = (folder / (type + ".txt")).string();
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    CHECK(run_adore("check " + deck).code == 0);
    const Result run = run_adore("run " + deck);
    INFO(run.out);
    CHECK(run.code == 2);
    CHECK(contains(run.out, "record 3.2, kBrg"));
    CHECK(contains(run.out, "set mode to -1"));
    CHECK_FALSE(fs::exists(folder / "PRINT.txt"));
  }
  new_ball_deck(folder);
  for (const std::string set : {"kTrac=3", "kVarLoad=1", "mode=1", "kDOF=2", "kPocType=1"}) {
    const Result run = run_adore("run " + folder.path().string() + " --set " + set);
    INFO(set << "\n" << run.out);
    CHECK(run.code == 2);
    CHECK(contains(run.out, set.substr(0, set.find('='))));
  }
}

TEST_CASE("every ball example checks clean and runs", "[cli]") {
  const Folder folder;
  for (const std::string type : {"ball", "ball-english", "ball-thrust", "ball-18"}) {
    const std::string deck = (folder / (type + ".txt")).string();
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    CHECK(run_adore("check " + deck).code == 0);
    const Result run =
        run_adore("run " + deck + " --until 0.02rev --quiet --out " + (folder / type).string());
    INFO(type << "\n" << run.out);
    CHECK(run.code == 0);
  }
  // The same bearing in two unit systems. The decks' own numbers are rounded to 1e-7 or better.
  const auto result = [&](const std::string& type, const char* name) {
    return json::parse(read(folder / type / "RUN.json")).at("summary").at(name).get<double>();
  };
  for (const char* name : {"largest_contact_load_N", "power_loss_W", "mean_orbital_ratio"})
    CHECK(result("ball-english", name) == Approx(result("ball", name)).epsilon(1e-6));
}

TEST_CASE("what an integrator cannot do is refused before a file is touched", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  for (const std::string set :
       {" --set intMet=33", " --set intMet=21 --set stpMin=0.3 --set stpMax=0.3"}) {
    const Result run = run_adore("run " + folder.path().string() + set);
    INFO(run.out);
    CHECK(run.code == 2);
    CHECK_FALSE(fs::exists(folder / "PRINT.txt"));
  }
}

TEST_CASE("a short run writes every file, and each can be shown and exported", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run =
      run_adore("run " + folder.path().string() + " --until 0.1rev --progress plain");
  INFO(run.out);
  REQUIRE(run.code == 0);
  for (const char* name : {"PRINT.txt", "FINAL", "MASTER", "SOL1", "SOL2", "SOL3", "SOL4", "SOL7",
                           "SOL8", "RUN.json", "RESULTS.h5"}) {
    INFO(name);
    REQUIRE(fs::exists(folder / name));
    CHECK(fs::file_size(folder / name) > 0);
    if (std::string(name) == "PRINT.txt") continue;
    CHECK(run_adore("show " + (folder / name).string()).code == 0);
    const Result csv = run_adore("convert " + (folder / name).string() + " --to csv");
    CHECK(csv.code == 0);
    const Result exported = run_adore("convert " + (folder / name).string() + " --to json");
    CHECK(json::accept(exported.out));
  }
  const json summary = json::parse(read(folder / "RUN.json"));
  CHECK(summary.at("status") == "done");
  CHECK(summary.at("revolutions").get<double>() == Approx(0.1).epsilon(1e-9));
  const std::string listing = read(folder / "PRINT.txt");
  for (const char* part : {"kBrg", "residual", "stepper", "7208"}) CHECK(contains(listing, part));
  std::size_t longest = 0;
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    std::size_t columns = 0;
    for (const char c : line) columns += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    longest = std::max(longest, columns);
  }
  CHECK(longest <= 132);
}

TEST_CASE("the same deck writes the same bytes, measured times apart", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const auto run_into = [&](const std::string& name, const std::string& environment = "") {
    const Result run = run_adore("run " + folder.path().string() +
                                     " --quiet --until 0.05rev --out " + (folder / name).string(),
                                 environment);
    INFO(run.out);
    REQUIRE(run.code == 0);
  };
  run_into("a");
  run_into("b", "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8");
  for (const char* name : {"SOL1", "SOL2", "SOL3", "SOL4", "SOL7", "SOL8", "FINAL", "RESULTS.h5"}) {
    INFO(name);
    CHECK(read(folder / "a" / name) == read(folder / "b" / name));
  }
  json a = json::parse(read(folder / "a" / "RUN.json")),
       b = json::parse(read(folder / "b" / "RUN.json"));
  a.erase("measured");
  b.erase("measured");
  CHECK(a == b);
}

TEST_CASE("a quasi-static deck writes one page and the equilibrium carries the load", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run = run_adore("run " + folder.path().string() + " --set mode=-1");
  INFO(run.out);
  REQUIRE(run.code == 0);
  const json summary = json::parse(read(folder / "RUN.json"));
  CHECK(summary.at("summary").at("load_x_N").get<double>() == Approx(1500.0).epsilon(1e-9));
  CHECK(summary.at("summary").at("load_z_N").get<double>() == Approx(500.0).epsilon(1e-9));
  CHECK_FALSE(fs::exists(folder / "SOL1"));
}

TEST_CASE("a quasi-static deck of each roller type writes one page and carries its load", "[cli]") {
  for (const std::string type : {"cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const Folder folder;
    const std::string deck = (folder / "DATA.txt").string();
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    const Result run = run_adore("run " + folder.path().string() + " --quiet --set mode=-1");
    INFO(type << "\n" << run.out);
    REQUIRE(run.code == 0);
    const std::string print = read(folder / "PRINT.txt");
    for (const char* part : {"QUASI-STATIC EQUILIBRIUM", "Contacts with the outer race",
                             "Along the heaviest rollers", "Roller length"})
      CHECK(contains(print, part));
    CHECK_FALSE(contains(print, "nan"));
    const json summary = json::parse(read(folder / "RUN.json")).at("summary");
    CHECK(summary.at("load_z_N").get<double>() == Approx(5000.0).epsilon(1e-9));
    CHECK(summary.at("largest_pressure_Pa").get<double>() > 5e8);
  }
}

TEST_CASE("roller decks in SI and in English units give the same results", "[cli]") {
  using namespace adore::deck;
  for (const std::string type : {"cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const Folder folder;
    const fs::path path = folder / "SI.txt";
    REQUIRE(run_adore("new " + type + " --out " + path.string()).code == 0);
    Deck si = read_deck(path).deck;
    si.set("mode", "-1");
    si.complete();
    Deck english = si;
    english.set("kUnit", "2");
    for (const RecordSpec& record : schema())
      for (const VariableSpec& variable : record.variables) {
        if (variable.type != VarType::Real) continue;
        for (int i = 1; si.has_record(record.id, i); ++i) {
          const std::string name = record.repeat.empty() ? std::string(variable.name)
                                                         : fmt::format("{}[{}]", variable.name, i);
          const double value = si.si(variable.name, i) / variable.unit.en_factor;
          if (variable.length == "1") english.set(name, fmt::format("{}", value));
        }
      }
    write_deck(si, folder / "SI.txt");
    write_deck(english, folder / "EN.txt");
    std::array<json, 2> result;
    for (const std::size_t k : {0U, 1U}) {
      const fs::path out = folder / (k == 0 ? "si" : "en");
      const Result run = run_adore("run " + (folder / (k == 0 ? "SI.txt" : "EN.txt")).string() +
                                   " --quiet --out " + out.string());
      INFO(type << "\n" << run.out);
      REQUIRE(run.code == 0);
      result[k] = json::parse(read(out / "RUN.json")).at("summary");
    }
    for (const char* key : {"largest_contact_load_N", "largest_pressure_Pa", "displacement_z_m",
                            "stiffness_z_N_per_m"}) {
      CAPTURE(type, key);
      CHECK(result[1].at(key).get<double>() ==
            Approx(result[0].at(key).get<double>()).epsilon(1e-10));
    }
  }
}

TEST_CASE("an interrupted run leaves valid files and exit code 130, and continues from there",
          "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  const pid_t child = start_long_run(folder);
  wait_for_steps(folder, 30000);
  kill(child, SIGINT);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 130);
  const auto stored = adore::results::read_sol(folder / "SOL1", {1, 1000000, 1});
  CHECK(stored.note.empty());
  const auto state = adore::results::read_final(folder / "FINAL");
  CHECK(state.step == stored.steps.back().step);
  CHECK(json::parse(read(folder / "RUN.json")).at("status") == "interrupted");

  const Result more =
      run_adore("run " + folder.path().string() + " --set kIcOpt=1 --set maxStps=10");
  INFO(more.out);
  REQUIRE(more.code == 0);
  const auto longer = adore::results::read_sol(folder / "SOL1", {1, 1000000, 1});
  CHECK(longer.steps.size() > stored.steps.size());
  CHECK(longer.steps.back().step == state.step + 10);
  for (std::size_t i = 1; i < longer.steps.size(); ++i)
    CHECK(longer.steps[i].step > longer.steps[i - 1].step);
}

TEST_CASE("a killed run leaves readable files and continues from its last checkpoint",
          "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  const pid_t child = start_long_run(folder);
  wait_for_steps(folder, 60000);
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  kill(child, SIGKILL);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  const auto master = adore::results::read_master(folder / "MASTER");
  const auto stored = adore::results::read_sol(folder / "SOL7", {1, 1000000, 1});
  REQUIRE_FALSE(stored.steps.empty());
  CHECK(stored.steps.back().step >= master.last.step);
  CHECK(run_adore("show " + (folder / "RESULTS.h5").string()).code == 0);

  const Result more =
      run_adore("run " + folder.path().string() + " --set kIcOpt=1 --set maxStps=5");
  INFO(more.out);
  REQUIRE(more.code == 0);
  const auto longer = adore::results::read_sol(folder / "SOL7", {1, 1000000, 1});
  CHECK(longer.steps.back().step == master.last.step + 5);
  for (std::size_t i = 1; i < longer.steps.size(); ++i)
    CHECK(longer.steps[i].step > longer.steps[i - 1].step);
}

TEST_CASE("a continued run reaches the state of an unbroken one", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string
      deck = folder.path().string(),
      fixed = " --set stpMin=0.2 --set stpMax=0.2 --set stpInit=0.2 --set intMet=4 --quiet";
  REQUIRE(
      run_adore("run " + deck + fixed + " --set maxStps=20 --out " + (folder / "whole").string())
          .code == 0);
  const std::string parts = (folder / "parts").string();
  REQUIRE(run_adore("run " + deck + fixed + " --set maxStps=10 --out " + parts).code == 0);
  REQUIRE(
      run_adore("run " + deck + fixed + " --set maxStps=10 --set kIcOpt=1 --out " + parts).code ==
      0);
  const auto whole = adore::results::read_final(folder / "whole" / "FINAL");
  const auto joined = adore::results::read_final(folder / "parts" / "FINAL");
  CHECK(joined.step == whole.step);
  REQUIRE(joined.state.size() == whole.state.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < whole.state.size(); ++i)
    worst = std::max(worst, std::abs(joined.state[i] - whole.state[i]) /
                                std::max(1.0, std::abs(whole.state[i])));
  CHECK(worst < 1e-11);  // the same steps; only t = k h is summed in two parts
  CHECK(read(folder / "whole" / "SOL1").size() == read(folder / "parts" / "SOL1").size());

  const Result other =
      run_adore("run " + deck + fixed +
                " --set maxStps=10 --set kIcOpt=1 --set runID=another --out " + parts);
  INFO(other.out);
  CHECK(other.code == 2);
  CHECK(contains(other.out, "another"));
  CHECK(contains(other.out, "7208"));
}

TEST_CASE("a run prints fatigue lives, and SOL7 stores the one that was asked for", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string();
  const auto sol7_lives = [&](const std::string& name, const std::string& options) {
    const Result run = run_adore("run " + deck + " --quiet --until 0.1rev " + options + " --out " +
                                 (folder / name).string());
    INFO(run.out);
    REQUIRE(run.code == 0);
    std::istringstream csv(
        run_adore("convert " + (folder / name / "SOL7").string() + " --to csv").out);
    std::string line;
    std::getline(csv, line);
    std::size_t column = 0;
    std::istringstream titles(line);
    std::string title;
    while (std::getline(titles, title, ',') && !contains(title, "life")) ++column;
    std::vector<double> out;
    while (std::getline(csv, line)) {
      std::istringstream cells(line);
      std::string cell;
      for (std::size_t k = 0; k <= column; ++k) std::getline(cells, cell, ',');
      out.push_back(std::stod(cell));
    }
    REQUIRE(out.size() > 3);
    return out;
  };
  const std::vector<double> stored = sol7_lives("default", "");
  for (const double life : stored) {
    CHECK(life > 1.0);
    CHECK(life < 1e9);
  }
  const json run = json::parse(read(folder / "default" / "RUN.json"));
  const json& models = run.at("life").at("quasi-static").at("lives");
  // The run starts from the statics that the page shows: the first instant has its life, elements
  // at their actual spin instead of the formula's.
  const double page = models.at("Gupta-Zaretsky type").at("STLE").at("L10 [hr]").get<double>();
  CHECK(stored.front() == Approx(page).epsilon(0.02));
  CHECK(run.at("life").at("run").at("life [hr]").get<double>() == Approx(page).epsilon(0.2));
  CHECK(run.at("life").at("run").at("window [rev]").get<double>() == Approx(0.1).epsilon(1e-6));
  const std::string listing = read(folder / "default" / "PRINT.txt");
  for (const char* part : {"FATIGUE LIFE", "CALIBRATED", "Fatigue life of the run",
                           "no lubricant film is computed", "Fatigue life at the present loads"})
    CHECK(contains(listing, part));
  CHECK_FALSE(contains(listing, "no life model is active"));

  // Races only, of the original theory: no formula of spin in between.
  const double original =
      models.at("Original Lundberg-Palmgren").at("basic").at("L10 [hr]").get<double>();
  CHECK(sol7_lives("lp", "--opt sol7Life=lp").front() == Approx(original).epsilon(1e-5));
  // Every contact under the limit.
  for (const double life : sol7_lives(
           "light", "--opt sol7Life=ih --set appLoadX=60.0 --set appLoadZ=0.0 --set rpm2=500.0"))
    CHECK(life == Approx(9.9999999e30).epsilon(1e-6));
  CHECK(contains(read(folder / "light" / "PRINT.txt"), "INFINITE"));
  CHECK(contains(run_adore("run " + deck + " --opt sol7Life=no").out, "gz"));
}

TEST_CASE("adore plan, schema, examples and calc speak JSON and tables", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result plan = run_adore("plan --json " + folder.path().string());
  INFO(plan.out);
  REQUIRE(plan.code == 0);
  const json scene = json::parse(plan.out);
  CHECK(scene.at("estimates").at("fastest_frequency_Hz").get<double>() > 1000.0);
  for (const json& effect : scene.at("effects"))
    CHECK_FALSE(effect.at("because").get<std::string>().empty());
  const Result off = run_adore("plan --json " + folder.path().string() + " --set gravityVecZ=0.0");
  for (const json& effect : json::parse(off.out).at("effects"))
    if (effect.at("name") == "gravity") CHECK(effect.at("on") == false);

  CHECK(run_adore("schema").out.substr(0, 6) == "record");
  CHECK(json::accept(run_adore("schema --format json").out));
  CHECK(contains(run_adore("examples").out, "tapered"));
  write(
      folder / "hertz.json",
      R"({"body1": {"Rx": 0.01, "Ry": 0.01, "E": 2e11, "nu": 0.3}, "body2": {"Rx": "inf", "Ry": "inf", "E": 2e11, "nu": 0.3}, "load": 100, "stress_poisson": 0.3})");
  const Result hertz = run_adore("calc hertz --json " + (folder / "hertz.json").string());
  INFO(hertz.out);
  REQUIRE(hertz.code == 0);
  // Sphere on flat: K = 4/3 E* sqrt(R) with E* = 1e11/0.91.
  CHECK(json::parse(hertz.out).at("load_deflection_constant").get<double>() ==
        Approx(4.0 / 3.0 * 1e11 / 0.91 * 0.1).epsilon(1e-9));
}

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
  CHECK(fs::exists(folder / "sweep" / "appLoadX-3" / "PRINT.txt"));
}

TEST_CASE("the quasi-static example decks run, with tables for plots, lives and stiffness",
          "[cli]") {
  const Folder folder;
  for (const std::string name : {"angular-218", "deep-groove-6205", "cylindrical-nu209",
                                 "tapered-30208", "spherical-22210"}) {
    INFO(name);
    const std::string deck = (folder / (name + ".txt")).string(), out = (folder / name).string();
    REQUIRE(run_adore("new " + name + " --out " + deck).code == 0);
    const Result run = run_adore("run " + deck + " --quiet --out " + out);
    INFO(run.out);
    REQUIRE(run.code == 0);
    const json report = json::parse(read(fs::path(out) / "RUN.json"));
    const json& tables = report.at("quasi_static").at("tables");
    const auto count = tables.at("elements").at("azimuth [deg]").size();
    CHECK(count >= 9);
    CHECK(tables.at("elements").at("inner load [N]").size() == count);
    const bool rollers = name != "angular-218" && name != "deep-groove-6205";
    CHECK(tables.contains("slices") == rollers);
    CHECK(tables.contains("stiffness over speed") == (name == "angular-218"));
    CHECK(report.at("summary").at("life_lp_hours").get<double>() > 0.0);
    const std::string listing = read(fs::path(out) / "PRINT.txt");
    for (const char* page : {"QUASI-STATIC EQUILIBRIUM", "OPERATING FITS AND CLEARANCES"})
      CHECK(contains(listing, page));
  }
}

TEST_CASE("a sweep whose runs all fail still leaves its table with the reasons", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result sweep =
      run_adore("run " + folder.path().string() + " --set noSuchVariable=1:2:2 --quiet --out " +
                (folder / "sweep").string());
  INFO(sweep.out);
  CHECK(sweep.code == 2);
  CHECK(read(folder / "sweep" / "SWEEP.csv").find("noSuchVariable") != std::string::npos);
}

TEST_CASE("adore accuracy tabulates error against cost", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result study =
      run_adore("accuracy " + folder.path().string() +
                " --methods rkf5,pece4 --tols 1e-5,1e-7 --span 5 --out " + folder.path().string());
  INFO(study.out);
  REQUIRE(study.code == 0);
  CHECK(fs::exists(folder / "ACCURACY.csv"));
  std::istringstream csv(read(folder / "ACCURACY.csv"));
  std::string line;
  int lines = 0;
  while (std::getline(csv, line)) ++lines;
  CHECK(lines == 5);
}

namespace {

/// --set of fits and temperatures in the units of a deck: metres and kelvin, or inches and rankine.
std::string fits_and_temperatures(bool english) {
  const double length = english ? 1.0 / 0.0254 : 1.0, temperature = english ? 1.8 : 1.0;
  const auto set = [](const char* name, double value) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << " --set " << name << "=" << std::scientific << value;
    return out.str();
  };
  return set("raceFit1", 4e-6 * length) + set("raceFit2", 16e-6 * length) +
         set("hsngTemp", 318.0 * temperature) + set("shftTemp", 336.0 * temperature) +
         set("raceTemp1", 330.0 * temperature) + set("raceTemp2", 345.0 * temperature) +
         set("reTemp", 350.0 * temperature) + set("cageTemp", 335.0 * temperature);
}

}  // namespace

TEST_CASE("fits and temperatures change statics and dynamics alike, in either unit system",
          "[cli]") {
  const Folder folder;
  std::map<std::string, json> runs;
  for (const std::string type : {"ball", "ball-english"}) {
    const std::string deck = (folder / (type + ".txt")).string();
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    const std::string sets = fits_and_temperatures(type == "ball-english");
    const std::string out = (folder / type).string();
    for (const auto& [name, arguments] :
         {std::pair<std::string, std::string>{"-static", " --set mode=-1"},
          std::pair<std::string, std::string>{"-dynamic", " --until 0.01rev"}}) {
      const Result run =
          run_adore("run " + deck + sets + arguments + " --quiet --out " + out + name);
      INFO(run.out);
      REQUIRE(run.code == 0);
      runs[type + name] = json::parse(read(fs::path(out + name) / "RUN.json"));
      CHECK(contains(read(fs::path(out + name) / "PRINT.txt"), "OPERATING FITS AND CLEARANCES"));
    }
  }
  const json& si = runs["ball-static"];
  const json& fits = si.at("operating fits");
  CHECK(fits.at("geometry changed").get<bool>());
  const double free = fits.at("unmounted").at("diametral clearance [m]").get<double>();
  const double warm = fits.at("operating").at("diametral clearance [m]").get<double>();
  CHECK(warm < free);
  // The dynamic run has the same bearing, and its cage too.
  CHECK(runs["ball-dynamic"].at("operating fits").at("operating") == fits.at("operating"));
  CHECK(runs["ball-dynamic"].at("operating fits").contains("cage play, diametral"));
  // Statics in two unit systems: only the conversion of the deck's 16 digits differs.
  for (const auto& [name, value] : si.at("summary").items()) {
    INFO(name);
    const double other = runs["ball-english-static"].at("summary").at(name).get<double>();
    // Zero by symmetry, up to 1e-10 of the largest load [N, N m] or displacement [m].
    const bool load = name.find("load_") == 0, displacement = name.find("displacement_") == 0;
    const double scale = load ? 1e-10 * 1500.0 : displacement ? 1e-10 * 2e-5 : 0.0;
    CHECK(other == Approx(value.get<double>()).epsilon(1e-10).margin(scale));
  }
}

TEST_CASE("lost clearance and loose fits are said on the terminal, in PRINT and in RUN.json",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run = run_adore("run " + folder.path().string() +
                               " --set mode=-1 --set raceFit2=2e-6 --set rpm2=30000.0 --set "
                               "reTemp=420.0 --set raceTemp2=400.0");
  INFO(run.out);
  REQUIRE(run.code == 0);
  for (const char* text : {"clearance turns negative", "inner race comes loose from the shaft"}) {
    CHECK(contains(run.out, text));
    CHECK(contains(read(folder / "PRINT.txt"), text));
    CHECK(contains(read(folder / "RUN.json"), text));
  }
  const Result check = run_adore("check " + folder.path().string());
  CHECK(check.code == 0);
}

TEST_CASE("adore calc knows fits, growth, clearance, materials and units", "[cli]") {
  const Folder folder;
  const auto calc = [&](const std::string& name, const std::string& input) {
    write(folder / "in.json", input);
    const Result result = run_adore("calc " + name + " --json " + (folder / "in.json").string());
    INFO(result.out);
    REQUIRE(result.code == 0);
    return json::parse(result.out);
  };
  const json steel = calc("material", R"({"code": 100})");
  CHECK(steel.at("properties").at("density").at("value") == 7810.0);
  CHECK(steel.at("properties").at("density").at("provenance") == "seen");
  CHECK(steel.at("properties").at("elastic_modulus").at("unit") == "Pa");
  CHECK(steel.at("properties").size() == 11);
  CHECK_FALSE(steel.contains("T"));
  CHECK(calc("material", R"({"code": 0, "part": "shaft", "T": 400})").at("key") == "mild_steel");
  CHECK(calc("units", R"({"quantity": "force", "values": [1]})").at("values")[0] ==
        Approx(4.4482216152605));
  CHECK(calc("fits", R"({"inner_id": 0, "interface_dia": 0.04, "outer_od": 0.05,
      "diametral_interference": -1e-6, "inner_part": {"E": 2e11, "nu": 0.3},
      "outer_part": {"E": 2e11, "nu": 0.3}})")
            .at("pressure") == 0.0);
  CHECK(calc("growth", R"({"inner_dia": 0.05, "outer_dia": 0.06, "cte": 1e-5, "temp_inner": 300,
      "temp_outer": 300, "room_temp": 290})")
            .at("bore_growth") == Approx(0.05 * 1e-4));
  CHECK(calc("clearance", R"({"curvature_radius": 0.0065405, "ball_dia": 0.0127, "shim": 0.0001,
      "measured_clearance": 3e-5, "center_distance_A": 0.0004445})")
            .at("contact_angle_deg") == Approx(17.968010894907867));
  write(folder / "bad.json", R"({"code": 999})");
  const Result bad = run_adore("calc material --json " + (folder / "bad.json").string());
  CHECK(bad.code == 2);
  CHECK(contains(bad.out, "valid codes"));
}

TEST_CASE("lightly loaded elements are held, booked and continued as in an unbroken run", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string(),
                    light = " --set appLoadX=200 --set appLoadZ=2000 --set qFac=0.1",
                    fixed = light +
                            " --set stpMin=0.2 --set stpMax=0.2 --set stpInit=0.2 --set intMet=4 "
                            "--set nStps=5 --quiet";
  const Result plan = run_adore("plan " + deck + light + " --json");
  REQUIRE(plan.code == 0);
  CHECK(contains(plan.out, "light-load balance"));
  CHECK(contains(plan.out, "qFac = 0.1"));

  const std::string whole = (folder / "whole").string(), parts = (folder / "parts").string();
  REQUIRE(run_adore("run " + deck + fixed + " --set maxStps=400 --out " + whole).code == 0);
  const json run = json::parse(read(folder / "whole" / "RUN.json"));
  CHECK(run.at("counters").at("changes of held elements").get<int>() >= 3);
  const json& energy = run.at("conservation").at("energy");
  CHECK(energy.contains("switches of held elements [J]"));
  CHECK(std::abs(energy.at("residual over energy moved").get<double>()) < 1e-5);
  const json& momentum = run.at("conservation").at("momentum");
  CHECK(std::abs(momentum.at("linear residual over momentum carried").get<double>()) < 1e-9);
  CHECK(std::abs(momentum.at("angular residual over momentum carried").get<double>()) < 1e-9);
  const std::string print = read(folder / "whole" / "PRINT.txt");
  CHECK(contains(print, "Elements held in force balance"));
  CHECK(contains(print, "residual of angular momentum, z"));

  // Broken in the middle, while balls are held and between two changes.
  REQUIRE(run_adore("run " + deck + fixed + " --set maxStps=230 --out " + parts).code == 0);
  REQUIRE(
      run_adore("run " + deck + fixed + " --set maxStps=170 --set kIcOpt=1 --out " + parts).code ==
      0);
  const auto one = adore::results::read_final(folder / "whole" / "FINAL");
  const auto two = adore::results::read_final(folder / "parts" / "FINAL");
  REQUIRE(one.components == two.components);
  CHECK(one.step == two.step);
  double held = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < one.state.size(); ++i) {
    worst = std::max(worst,
                     std::abs(one.state[i] - two.state[i]) / std::max(1.0, std::abs(one.state[i])));
    if (one.components[i].rfind("held.element", 0) == 0) held += one.state[i];
  }
  CHECK(held >= 3.0);
  CHECK(worst < 1e-9);  // the same steps; only t = k h is summed in two parts

  // qFac = 0 is another state: refused by name when a run is continued.
  const Result other = run_adore("run " + deck + fixed +
                                 " --set qFac=0 --set maxStps=5 --set kIcOpt=1 --out " + parts);
  CHECK(other.code == 2);
  CHECK(contains(other.out, "qFac"));
}
