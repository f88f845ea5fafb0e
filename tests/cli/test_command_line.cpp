#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <pty.h>
#include <set>
#include <vector>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

namespace {

json tree() { return json::parse(run_as_given("--completion json").out); }

/// Arguments that a command cannot do without, so that only the one at hand is wrong.
std::string needed(const json& command) {
  std::string out;
  for (const json& option : command.at("options")) {
    if (!option.at("required").get<bool>()) continue;
    const std::string name = option.at("names").back();
    const std::string value =
        option.contains("words") ? option.at("words").at(0).get<std::string>() : "nowhere";
    out += " " + (option.at("positional").get<bool>() ? value : name + " " + value);
  }
  return out;
}

/// Words of the option library, whose errors state the fault without a remedy.
bool speaks_for_itself(const std::string& text) {
  for (const char* phrase : {"Run with --help", "not expected", "Could not convert", "is required",
                             "Expected ", "invalid command line", "allowed value", "this is a bug"})
    if (contains(text, phrase)) return false;
  return true;
}

}  // namespace

TEST_CASE("command line: misspelled word → the nearest word is suggested", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = (folder / "DATA.txt").string();
  struct Case {
    std::string arguments;
    std::string said;
  };
  const std::vector<Case> cases = {
      {"rum", "there is no command \"rum\"; did you mean run?"},
      {"runn " + deck, "did you mean run?"},
      {"plto", "did you mean plot?"},
      {"exampels", "did you mean examples?"},
      {"", "adore new ball --out DATA.txt"},
      {"--verison", "did you mean --version?"},
      {"run --integratr rkf5", "`adore run` has no option --integratr; did you mean --integrator?"},
      {"run " + deck + " extra.txt", "\"extra.txt\" is one argument too many"},
      {"run --out", "--out needs a value"},
      {"run --threads many", "--threads many: invalid value; give a whole number"},
      {"run --tol small", "--tol small: invalid value; give a number"},
      {"run --progress yes", "give auto, plain, json or none"},
      {"run --set rpm2=500 rpm1=3", "write --set (or --opt) before each name=value"},
      {"run --set rpm2=500 rpm1=3 " + deck, "write --set (or --opt) before each name=value"},
      {"run --out a --out b", "--out was given more than once"},
      {"show", "`adore show` needs file: result file"},
      {"convert " + deck, "`adore convert` needs --to"},
      {"convert " + deck + " --to cvs", "did you mean csv? Give csv or json"},
      {"convert " + deck + " --to xml", "give csv or json"},
      {"new",
       "give the name of an example (`adore examples` lists them), a bearing with --catalogue"},
      {"new bal", "bal"},
      {"new --catalogue 9999", "adore: 9999: is not in the catalogue"},
      {"new --catalogue 6205 --oil water", "unknown oil \"water\""},
      {"new --catalogue 6205 --radial 4kPa",
       "--radial \"4kPa\" has a unit of a different quantity"},
      {"new --catalogue 6205 --speed fast", "--speed \"fast\""},
      {"new --from " + deck, "is a deck, not JSON"},
      {"new --list --type plain", "plain"},
  };
  for (const Case& one : cases) {
    const Result result = run_as_given(one.arguments);
    INFO(one.arguments << "\n" << result.out);
    CHECK(result.code == 2);
    CHECK(contains(result.out, one.said));
    CHECK(speaks_for_itself(result.out));
  }
}

TEST_CASE("cli new: load, speed and temperature with units → same deck as plain numbers", "[cli]") {
  const Result plain =
      run_as_given("new --catalogue 6205 --radial 4000 --axial 500 --speed 3000 --temperature 70");
  const Result units = run_as_given(
      "new --catalogue 6205 --radial 4kN --axial 0.5kN --speed 3000rpm "
      "--temperature 343.15K");
  CHECK(plain.code == 0);
  CHECK(units.out == plain.out);
}

TEST_CASE("cli: invalid use of every option of every command → rejected with a remedy", "[cli]") {
  std::vector<json> commands = tree().at("commands");
  REQUIRE(commands.size() >= 12);
  int tried = 0;
  for (const json& command : commands) {
    const std::string name = command.at("name");
    if ((name == "plot" || name == "animate") && command.at("options").size() < 3)
      continue;  // a build without Qt
    CHECK_FALSE(command.at("help").get<std::string>().empty());
    for (const json& option : command.at("options")) {
      INFO(name << ' ' << option.dump());
      CHECK_FALSE(option.at("help").get<std::string>().empty());
      if (option.at("positional").get<bool>()) continue;
      const std::string flag = option.at("names").back(), value = option.at("value");
      std::vector<std::string> wrong = {flag + "x"};
      const bool optional_value = name == "calc" && flag == "--json";
      if (value.empty() && flag != "--help")
        wrong.insert(wrong.end(), {flag + "=nonsense", flag + "=3", flag + "=false"});
      else if (!value.empty() && !optional_value)
        wrong.push_back(flag);
      if (value == "N" || value == "NUMBER") wrong.push_back(flag + " nonsense");
      for (const std::string& use : wrong) {
        const Result result = run_as_given(name + needed(command) + " " + use);
        INFO(use << "\n" << result.out);
        CHECK(result.code == 2);
        CHECK(speaks_for_itself(result.out));
        const auto names = option.at("names").get<std::vector<std::string>>();  // flag or an alias
        CHECK(std::any_of(names.begin(), names.end(),
                          [&](const std::string& one) { return contains(result.out, one); }));
        CHECK(contains(result.out, "`adore " + name + " --help`"));
        ++tried;
      }
    }
  }
  CHECK(tried > 60);
}

TEST_CASE("options mean the same in every command", "[cli]") {
  std::map<std::string, std::set<bool>> takes_value;
  const json whole = tree();
  for (const json& command : whole.at("commands"))
    for (const json& option : command.at("options")) {
      if (option.at("positional").get<bool>()) continue;
      // The calculators' --json takes a file too, as it did before there was a place for it.
      if (command.at("name") == "calc" && option.at("names").back() == "--json") continue;
      takes_value[option.at("names").back()].insert(!option.at("value").get<std::string>().empty());
    }
  for (const auto& [name, kinds] : takes_value) {
    INFO(name);
    CHECK(kinds.size() == 1);
  }
  CHECK(takes_value.at("--json") == std::set<bool>{false});
  CHECK(takes_value.at("--out") == std::set<bool>{true});
}

TEST_CASE("an option's value does not swallow the deck", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = (folder / "DATA.txt").string();
  const Result plan = run_as_given("plan --json --set gravityVecZ=0 " + deck);
  INFO(plan.out);
  REQUIRE(plan.code == 0);
  for (const json& effect : json::parse(plan.out).at("effects"))
    if (effect.at("name") == "gravity") CHECK(effect.at("on") == false);
  CHECK(run_as_given("plan --opt resultsH5=0 " + deck).code == 0);
}

TEST_CASE("a dash stands for the standard streams", "[cli]") {
  const Folder folder;
  const std::string out = (folder / "out").string();
  const auto piped = [](const std::string& first, const std::string& second) {
    return run_as_given(first + " | " + command_line(second));
  };
  const Result check = piped("new ball", "check -");
  INFO(check.out);
  CHECK(check.code == 0);
  CHECK(contains(check.out, "standard input: 22 records"));
  const Result plan = piped("new ball --out -", "plan - --json");
  INFO(plan.out);
  CHECK(plan.code == 0);
  CHECK(json::accept(plan.out));
  const Result run = piped("new deep-groove-6205", "run - --out " + out);
  INFO(run.out);
  CHECK(run.code == 0);
  CHECK(fs::exists(folder / "out" / "PRINT.txt"));
  const Result wrong = piped("new ball", "run - --set nRe=-1");
  CHECK(wrong.code == 2);
  CHECK(contains(wrong.out, "standard input"));
  const Result shown = run_as_given("convert " + out + "/RUN.json --to csv --out -");
  CHECK(contains(shown.out, "name,value"));
  CHECK(run_as_given("convert " + out + "/RUN.json --to csv --out " + out).code == 0);
  CHECK(fs::exists(folder / "out" / "RUN.json.csv"));
  const Result calc = run_as_given("--version >/dev/null; echo '{\"code\": 100}' | " +
                                   command_line("calc material -"));
  INFO(calc.out);
  CHECK(calc.code == 0);
  CHECK(json::accept(calc.out));

  const std::string cases =
      (adore::test::source_dir() / "tests/reference/A_hertz_point.json").string();
  const Result validated =
      run_as_given("--version >/dev/null; " + command_line("validate - --quiet < " + cases));
  INFO(validated.out);
  CHECK(validated.code == 0);
  CHECK(contains(validated.out, "standard input: "));
  CHECK(contains(validated.out, "0 failed"));
  const Result none = run_as_given("--version | " + command_line("validate -"));
  CHECK(none.code == 2);
  CHECK(contains(none.out, "standard input"));
  const Result twice = run_as_given("validate - - < " + cases);
  CHECK(twice.code == 2);
  CHECK(contains(twice.out, "once"));
}

TEST_CASE("JSON output: show, examples, run options, run summary", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run =
      run_as_given("run " + folder.path().string() + " --until 0.02rev --json --progress none");
  INFO(run.out);
  REQUIRE(run.code == 0);
  const json summary = json::parse(run.out);
  CHECK(summary.at("status") == "done");
  CHECK(summary.at("revolutions").get<double>() == Approx(0.02));
  CHECK(summary.at("results").at("power_loss_W").get<double>() > 0.0);
  for (const json& file : summary.at("files")) CHECK(fs::exists(file.get<std::string>()));

  for (const char* file : {"SOL1", "SOL7", "RESULTS.h5"}) {
    const Result shown = run_as_given("show --json " + (folder / file).string());
    INFO(file << '\n' << shown.out);
    REQUIRE(shown.code == 0);
    const json content = json::parse(shown.out);
    CHECK(content.at("complete steps").get<long>() == summary.at("steps").get<long>() + 1);
    CHECK(content.at("channels").size() > 5);
    CHECK(content.at("channels").at(0).contains("unit"));
  }
  for (const char* file : {"FINAL", "MASTER", "RUN.json"})
    CHECK(json::accept(run_as_given("show --json " + (folder / file).string()).out));

  const json examples = json::parse(run_as_given("examples --json").out);
  CHECK(examples.size() == 15);
  for (const json& one : examples) CHECK(one.at("does").size() >= 4);
  CHECK(json::parse(run_as_given("run --list-options --json").out).size() > 8);
}

TEST_CASE("adore examples and new: description of the deck", "[cli]") {
  const Folder folder;
  const Result written = run_as_given("new ball --out " + folder.path().string());
  INFO(written.out);
  CHECK(written.code == 0);
  CHECK(fs::exists(folder / "DATA.txt"));
  for (const char* said : {"12 elements of 0.0127 m", "appLoadX = 1500 N", "inner race 10000 rpm",
                           "motion over time", "the animation SOL8"})
    CHECK(contains(written.out, said));
  const Result still = run_as_given("examples angular-218");
  INFO(still.out);
  CHECK(contains(still.out, "quasi-static solution only"));
  CHECK(contains(still.out, "stiffness at 11 speeds"));
  CHECK(run_as_given("examples no-such").code == 2);
}

TEST_CASE("adore run: options without effect → reported", "[cli]") {
  const Folder folder;
  const std::string deck = (folder / "DATA.txt").string();
  REQUIRE(run_as_given("new deep-groove-6205 --out " + deck).code == 0);
  const Result run = run_as_given("run " + deck +
                                  " --until 5rev --tol 1e-8 --integrator rkf4 --threads 2 --opt "
                                  "ellipseMajor=20 --opt rollerSlices=30");
  INFO(run.out);
  CHECK(run.code == 0);
  CHECK(
      contains(run.out, "--until, --integrator, --tol and option ellipseMajor are without effect"));
  CHECK(contains(run.out, "option rollerSlices is without effect, because the bearing has balls"));
  CHECK(contains(run.out, "--threads has no effect"));
  CHECK_FALSE(contains(run_as_given("run " + deck).out, "--tol"));
}

TEST_CASE("run: last lines list the commands for pictures and continuation", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run = run_as_given("run " + folder.path().string() + " --until 0.02rev");
  INFO(run.out);
  REQUIRE(run.code == 0);
  // A build without Qt draws no pictures.
  CHECK((contains(run.out, "adore plot") || contains(run.out, "adore convert")));
  const std::size_t at = run.out.find("continue:");
  REQUIRE(at != std::string::npos);
  // The line that is printed does what it says.
  const std::string line = run.out.substr(at, run.out.find('\n', at) - at);
  const std::string arguments = line.substr(line.find("adore ") + 6);
  const Result more = run_as_given(arguments);
  INFO(arguments << '\n' << more.out);
  CHECK(more.code == 0);
  CHECK(contains(more.out, "0.04 revolutions"));
}

TEST_CASE("adore run: continuation command is unique for all speed laws", "[cli]") {
  const std::pair<const char*, const char*> cases[] = {
      {"", "rev --continue"},
      {"--set kVarSpeed=1 --set raceAngAcc2=1e6 --set endTime2=1", "s --continue"},
      {"--set kVarSpeed=2 --set raceSpeedAmp2=100 --set raceSpeedFreq2=50", "s --continue"},
      {"--set kDCR=1 --set kMD11=1 --set kMD12=0", "s --continue"}};
  for (const auto& [sets, end] : cases) {
    const Folder folder;
    new_ball_deck(folder);
    const std::string deck = folder.path().string();
    const Result run = run_as_given("run " + deck + " --until 1e-5s " + sets);
    INFO(sets << '\n' << run.out);
    REQUIRE(run.code == 0);
    const std::size_t at = run.out.find("continue:");
    REQUIRE(at != std::string::npos);
    const std::string line = run.out.substr(at, run.out.find('\n', at) - at);
    CHECK(contains(line, end));
    const Result more = run_as_given(line.substr(line.find("adore ") + 6));
    INFO(more.out);
    CHECK(more.code == 0);
  }
}

TEST_CASE("plan: disk space of a run is listed", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string();
  const std::string sets = " --set maxStps=300 --set kPltFreq=2 --set kAGraf=3 --set kPrtFreq=50";
  const json disk = json::parse(run_as_given("plan " + deck + sets + " --json").out).at("disk");
  REQUIRE(run_as_given("run " + deck + sets + " --quiet").code == 0);
  double planned = 0.0, found = 0.0;
  for (const auto& [name, bytes] : disk.at("files").items()) {
    const double size = static_cast<double>(fs::file_size(folder / name));
    INFO(name << ": planned " << bytes << ", found " << size);
    CHECK(bytes.get<double>() == Approx(size).epsilon(name == "PRINT.txt" ? 0.5 : 0.15));
    planned += bytes.get<double>();
    found += size;
  }
  CHECK(planned == Approx(found).epsilon(0.15));
  CHECK(disk.at("bytes").get<double>() == Approx(planned).epsilon(1e-6));
  CHECK(contains(run_as_given("plan " + deck).out, "disk\n  about "));
}

TEST_CASE("the progress line is never wider than the terminal", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string(), adore = program("adore").string();
  for (const int width : {20, 40, 80, 200}) {
    winsize size{};
    size.ws_row = 24;
    size.ws_col = static_cast<unsigned short>(width);
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
    REQUIRE(child >= 0);
    if (child == 0) {
      execl(adore.c_str(), "adore", "run", deck.c_str(), "--until", "0.3rev", "--json",
            "--overwrite", nullptr);
      _exit(99);
    }
    std::string seen;
    std::array<char, 4096> block{};
    for (ssize_t n = 0; (n = ::read(terminal, block.data(), block.size())) > 0;)
      seen.append(block.data(), static_cast<std::size_t>(n));
    int status = 0;
    waitpid(child, &status, 0);
    close(terminal);
    INFO(width << '\n' << seen);
    REQUIRE((WIFEXITED(status) && WEXITSTATUS(status) == 0));
    // Overwritten text is between "\r\033[K" and the next return or line end.
    std::size_t lines = 0, longest = 0;
    const std::string start = "\r\033[K";
    for (std::size_t at = seen.find(start); at != std::string::npos;
         at = seen.find(start, at + 1)) {
      const std::size_t begin = at + start.size();
      longest = std::max(longest, seen.find_first_of("\r\n", begin) - begin);
      ++lines;
    }
    CHECK(lines >= 1);
    CHECK(longest < static_cast<std::size_t>(width));
    if (width == 200) CHECK(contains(seen, "real time"));
  }
}

TEST_CASE("adore without a command in a deck's folder: names it, runs after a yes at the terminal",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  {  // a few steps
    std::string text = read(folder / "DATA.txt");
    const std::string steps = " 5000, 4, 5";
    const std::size_t at = text.find(steps);
    REQUIRE(at != std::string::npos);
    std::ofstream(folder / "DATA.txt") << text.replace(at, steps.size(), " 5, 4, 5");
  }
  const std::string there = "cd " + folder.path().string() + " &&";
  const Result piped = run_as_given("< /dev/null", there);
  INFO(piped.out);
  CHECK(piped.code == 2);
  CHECK(contains(piped.out, "\n  adore run\n"));
  CHECK_FALSE(fs::exists(folder / "RUN.json"));

  const std::string adore = program("adore").string(), here = folder.path().string();
  const auto at_terminal = [&](const char* typed) {
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    REQUIRE(child >= 0);
    if (child == 0) {
      if (chdir(here.c_str()) == 0) execl(adore.c_str(), "adore", nullptr);
      _exit(99);
    }
    REQUIRE(::write(terminal, typed, std::strlen(typed)) > 0);
    Result out;
    std::array<char, 4096> block{};
    for (ssize_t n = 0; (n = ::read(terminal, block.data(), block.size())) > 0;)
      out.out.append(block.data(), static_cast<std::size_t>(n));
    int status = 0;
    waitpid(child, &status, 0);
    close(terminal);
    out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return out;
  };
  const Result no = at_terminal("\n");
  CHECK(no.code == 0);
  CHECK(contains(no.out, "[y/N]"));
  CHECK_FALSE(fs::exists(folder / "RUN.json"));
  const Result yes = at_terminal("y\n");
  INFO(yes.out);
  CHECK(yes.code == 0);
  CHECK(fs::exists(folder / "RUN.json"));
  const Result again = at_terminal("y\nn\n");  // runs, but replaces nothing
  INFO(again.out);
  CHECK(again.code == 2);
  CHECK(contains(again.out, "--overwrite"));
}

TEST_CASE("wrong file for a command → message names the file type", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string out = folder.path().string();
  REQUIRE(run_as_given("run " + out + " --until 0.01rev --quiet").code == 0);
  struct Case {
    const char* arguments;
    const char* said;
  };
  for (const Case& one :
       {Case{"check PRINT.txt", "this is a listing (PRINT.txt of a run), not a deck"},
        Case{"run SOL1", "this is a file of plotted channels"},
        Case{"plan SOL8", "this is an animation file"},
        Case{"run FINAL", "this is the final state of a run"},
        Case{"run MASTER", "this is the bookkeeping of a run"},
        Case{"check RUN.json", "this is the summary of a run"}, Case{"check RESULTS.h5", "HDF5"},
        Case{"show DATA.txt", "this is a deck"},
        Case{"show PRINT.txt", "read this file with a text viewer"},
        Case{"calc hertz DATA.txt", "is a deck, not JSON"},
        Case{"validate PRINT.txt", "is a listing (PRINT.txt of a run), not JSON"},
        Case{"convert DATA.txt --to csv", "`adore check` and `adore run` read this file"}}) {
    const Result result = run_as_given(one.arguments, "cd " + out + " &&");
    INFO(one.arguments << '\n' << result.out);
    CHECK(result.code == 2);
    CHECK(contains(result.out, one.said));
  }
}

TEST_CASE("the manual page holds every command and option", "[cli]") {
  const std::string page = run_as_given("--man").out;
  CHECK(contains(page, ".TH ADORE 1"));
  const auto holds = [&page](const json& command) {
    for (const json& option : command.at("options")) {
      std::string name = option.at("names").back();
      std::string typed;
      for (const char c : name) typed += c == '-' ? std::string("\\-") : std::string(1, c);
      INFO(command.at("name") << ' ' << name);
      CHECK(contains(page, "\\fB" + typed + "\\fR"));
    }
  };
  const json all = tree();
  holds(all);
  for (const json& command : all.at("commands")) {
    const std::string name = command.at("name");
    CHECK(contains(page, ".SS adore " + name + "\n"));
    holds(command);
  }
}

TEST_CASE("bash completes commands, options, values and deck variables", "[cli]") {
  if (std::system("bash -c true") != 0) return;
  const Folder folder;
  write(folder / "adore.bash", run_as_given("--completion bash").out);
  const auto completed = [&](const std::string& words) {
    const std::string script =
        "source " + (folder / "adore.bash").string() + "; COMP_WORDS=(" + words +
        "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); compopt() { :; }; _adore; "
        "printf \"%s\\n\" \"${COMPREPLY[@]}\"";
    write(folder / "ask.sh", script);
    const Result result =
        run_as_given("--version >/dev/null; bash " + (folder / "ask.sh").string());
    return "\n" + result.out;
  };
  CHECK(completed("adore exa") == "\nexamples\n");
  CHECK(contains(completed("adore run --int"), "\n--integrator\n"));
  CHECK(contains(completed("adore run --integrator rkf"), "\nrkf5\n"));
  CHECK(contains(completed("adore run DATA.txt --set pitch"), "\npitchDia=\n"));
  CHECK(contains(completed("adore run --opt ellipse"), "\nellipseMajor=\n"));
  CHECK(contains(completed("adore new bal"), "\nball-thrust\n"));
  CHECK(contains(completed("adore calc her"), "\nhertz\n"));
  CHECK(completed("adore convert SOL1 --to c") == "\ncsv\n");
  CHECK(contains(completed("adore --comp"), "\n--completion\n"));
}

TEST_CASE("fish completes commands, options, values and deck variables", "[cli]") {
  const std::string script = run_as_given("--completion fish").out;
  const json whole = tree();
  for (const json& command : whole.at("commands"))
    CHECK(contains(script, command.at("name").get<std::string>()));
  if (run_shell("fish --version >/dev/null 2>&1").code != 0) {
    WARN("fish is not installed: its completion was not tried");
    return;
  }
  const Folder folder;
  write(folder / "adore.fish", script);
  const auto completed = [&](const std::string& words) {
    return run_shell("HOME=" + folder.path().string() + " fish --no-config -c \"source " +
                     (folder / "adore.fish").string() + "; complete -C '" + words +
                     "'\" | cut -f 1")
        .out;
  };
  CHECK(completed("adore exa") == "examples\n");
  CHECK(completed("adore run --int") == "--integrator\n");
  CHECK(contains(completed("adore run --integrator rkf"), "rkf5\n"));
  CHECK(completed("adore run DATA.txt --set pitch") == "pitchDia=\n");
  CHECK(contains(completed("adore run --opt ellipse"), "ellipseMajor=\n"));
  CHECK(contains(completed("adore new bal"), "ball-thrust\n"));
  CHECK(contains(completed("adore calc her"), "hertz\n"));
  CHECK(completed("adore convert SOL1 --to c") == "csv\n");
}

TEST_CASE("zsh completes commands, options, values and deck variables", "[cli]") {
  const std::string function = run_as_given("--completion zsh").out;
  const json whole = tree();
  for (const json& command : whole.at("commands"))
    CHECK(contains(function, command.at("name").get<std::string>()));
  if (run_shell("zsh -f -c 'zmodload zsh/zpty' >/dev/null 2>&1").code != 0) {
    WARN("zsh is not installed: its completion was not tried");
    return;
  }
  const Folder folder;
  write(folder / "_adore", function);
  // A separate terminal, in which a key shows the line after the tabulator.
  write(folder / "ask.zsh",
        R"(zmodload zsh/zpty
zpty z zsh -f -i
zpty -w z "PS1=; fpath=($1 \$fpath); autoload -Uz compinit; compinit -u -D; setopt no_beep"
zpty -w z 'told() { print -r -- "<<$BUFFER>>" }; zle -N told; bindkey "^X" told'
zpty -w z 'zle-line-init() { print -r -- "RE""ADY" }; zle -N zle-line-init'
zpty -r z out '*READY*'
zpty -w -n z "$2"$'\t\x18'
zpty -r z out '*<<*>>*'
print -rn -- "${${out##*<<}%%>>*}")");
  const auto completed = [&](const std::string& words) {
    return run_shell("cd " + folder.path().string() + " && ZDOTDIR=" + folder.path().string() +
                     " timeout 120 zsh -f ask.zsh " + folder.path().string() + " '" + words + "'")
        .out;
  };
  CHECK(completed("adore exa") == "adore examples ");
  CHECK(completed("adore run --int") == "adore run --integrator ");
  CHECK(completed("adore run --integrator arkode-i") == "adore run --integrator arkode-imex ");
  CHECK(completed("adore run DATA.txt --set pitch") == "adore run DATA.txt --set pitchDia=");
  CHECK(completed("adore run --opt ellipseMa") == "adore run --opt ellipseMajor=");
  CHECK(completed("adore new ball-t") == "adore new ball-thrust ");
  CHECK(completed("adore convert SOL1 --to c") == "adore convert SOL1 --to csv ");
}
