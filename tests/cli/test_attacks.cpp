#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

#include <sys/stat.h>

/// Inputs that broke a build once, one test for each kind:
/// a study folder from a stranger, deep nesting, names that are not UTF-8, devices, state of Slurm,
/// files that lost steps, killed children, tables with thousands of columns, escape sequences.
using namespace adore;
using namespace adore::test;

namespace {

const std::string kSweep =
    R"({"adore_study":1,"kind":"sweep","deck":"DATA.txt","set":{"mode":-1},"variables":[)"
    R"({"name":"appLoadX","list":[500,600]}],"quantities":["largest_contact_load_N"]})";

Result run_in(const fs::path& folder, const std::string& words, const std::string& before = "") {
  return run_shell("cd " + folder.string() + " && " + before + " timeout 120 " +
                   command_line(words) + " 2>&1");
}

}  // namespace

TEST_CASE("study plan of a folder whose deck copy is a link → exit 2, target untouched", "[cli]") {
  const Folder folder;
  const fs::path keys = folder / "home/.ssh/authorized_keys", gift = folder / "gift";
  fs::create_directories(keys.parent_path());
  fs::create_directories(gift / "s.study/decks/1");
  write(keys, "ssh-rsa MYKEY me\n");
  REQUIRE(run_in(folder.path(), "new ball --out gift/DATA.txt").code == 0);
  write(gift / "DATA.txt", read(gift / "DATA.txt") + "\nssh-ed25519 STRANGER\n");
  write(gift / "s.json", kSweep);
  fs::create_symlink("../../../../home/.ssh/authorized_keys", gift / "s.study/decks/1/DATA.txt");
  const Result plan = run_in(gift, "study plan s.json");
  INFO(plan.out);
  CHECK(plan.code == 2);
  CHECK(contains(plan.out, "decks/1/DATA.txt"));
  CHECK(contains(plan.out, "symbolic link"));
  CHECK(read(keys) == "ssh-rsa MYKEY me\n");
}

TEST_CASE("study: keys and decks that lead out of its folder → refused", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "s.json", kSweep);
  REQUIRE(run_in(folder.path(), "study run s.json --workers 1 --quiet").code == 0);
  const std::string tasks = read(folder / "s.study/tasks.jsonl");
  const std::size_t key = tasks.find("\"key\":\"") + 7;
  std::string wrong = tasks;
  wrong.replace(key, 32, "../../../outside");
  write(folder / "s.study/tasks.jsonl", wrong);
  for (const char* words : {"study status s.json", "study report s.json", "verify s.study"}) {
    const Result refused = run_in(folder.path(), words);
    INFO(words << ": " << refused.out);
    CHECK(refused.code == 2);
    CHECK(contains(refused.out, "damaged"));
  }
  write(folder / "s.study/tasks.jsonl", tasks);
  std::string job = read(folder / "s.study/job.json");
  job.replace(job.find("decks/1/DATA.txt"), 16, "../../etc/passwd");
  write(folder / "s.study/job.json", job);
  const Result work = run_in(folder.path(), "study work s.study < /dev/null");
  CHECK(work.code == 2);
  CHECK(contains(work.out, "damaged"));
}

TEST_CASE("run --json into a folder whose name is not UTF-8 → exit 0 and valid JSON", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run = run_shell("cd " + folder.path().string() + " && " +
                               command_line("run DATA.txt --set mode=-1 --json --out ") +
                               "\"$(printf 'n\\377')\" 2>/dev/null");
  CHECK(run.code == 0);
  CHECK(nlohmann::json::parse(run.out).is_object());
}

TEST_CASE("devices and pipes as inputs → rejected at once", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const char* input : {"/dev/zero", "pipe"}) {
    write(folder / "u.json", fmt::format(R"({{"adrx7":{{"element_race":{{"table":"{}"}}}}}})",
                                         input[0] == '/' ? input : (folder / input).string()));
    for (const std::string& words :
         {std::string("run DATA.txt --set kTrac=-1 --user u.json --out r"),
          fmt::format("run DATA.txt --user {} --out r", input), fmt::format("check {}", input),
          fmt::format("show {}", input), fmt::format("convert {} --to csv", input),
          fmt::format("calc hertz {}", input), fmt::format("validate {}", input),
          fmt::format("study plan {}", input)}) {
      const Result refused = run_in(folder.path(), words);
      INFO(words << ": " << refused.out);
      CHECK(refused.code == 2);
    }
  }
  fs::create_symlink("DATA.txt", folder / "linked.txt");
  CHECK(run_in(folder.path(), "check linked.txt").code == 0);
}

TEST_CASE("Slurm state with an option in place of the job → no such word reaches Slurm", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "s.json", kSweep);
  fs::create_directories(folder / "bin");
  for (const char* name : {"sinfo", "sbatch", "squeue", "sacct", "scontrol", "scancel"}) {
    write(
        folder / "bin" / name,
        fmt::format("#!/bin/sh\necho \"{0} $*\" >> {1}\ncase {0} in sinfo) echo 0/2/0/2;; squeue) "
                    "echo RUNNING;; esac\n",
                    name, (folder / "log").string()));
    fs::permissions(folder / "bin" / name, fs::perms::owner_all);
  }
  REQUIRE(run_in(folder.path(), "study run s.json --workers 1 --quiet").code == 0);
  fs::remove_all(folder / "s.study/runs");
  for (const char* job : {"--user=root", "12 --user=root", "", "1_2", "x"}) {
    fs::create_directories(folder / "s.study/slurm/submission-1");
    fs::copy_file(folder / "s.study/tasks.jsonl", folder / "s.study/slurm/submission-1/tasks.jsonl",
                  fs::copy_options::overwrite_existing);
    write(folder / "s.study/slurm/current.json",
          nlohmann::json{{"job", job}, {"piece", 1}, {"folder", "submission-1"}}.dump() + "\n");
    (void)run_shell("cd " + folder.path().string() + " && PATH=" + (folder / "bin").string() +
                    ":$PATH timeout -s INT 6 " +
                    command_line("study resume s.json --engine slurm --quiet") + " 2>&1");
    const std::string log = read(folder / "log");
    INFO(job << "\n" << log);
    CHECK_FALSE(contains(log, "scancel"));
    CHECK_FALSE(contains(log, "--user=root"));
    CHECK_FALSE(contains(log, "--jobs=x"));
  }
}

TEST_CASE("continue: over a plot file that lost steps, or was changed → exit 2, file named",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string run = "run DATA.txt --quiet --progress none --out r --until ";
  REQUIRE(run_in(folder.path(), run + "0.02rev").code == 0);
  CHECK(run_in(folder.path(), "verify r").code == 0);
  const auto damaged = [&](const std::string& name, const std::string& text) {
    const std::string whole = read(folder / "r" / name);
    REQUIRE(text != whole);
    write(folder / "r" / name, text);
    const Result verified = run_in(folder.path(), "verify r");
    INFO(name << ": " << verified.out);
    CHECK(verified.code == 1);
    CHECK(contains(verified.out, name));
    const Result on = run_in(folder.path(), run + "0.03rev --continue");
    INFO(on.out);
    CHECK(on.code == 2);
    CHECK(contains(on.out, name));
    CHECK(read(folder / "r" / name) == text);
    write(folder / "r" / name, whole);
  };
  const std::string sol1 = read(folder / "r/SOL1"), sol7 = read(folder / "r/SOL7");
  damaged("SOL1", sol1.substr(0, sol1.size() - 3000));
  std::string changed = sol7;
  const std::size_t digit = changed.rfind("1.");
  REQUIRE(digit != std::string::npos);
  changed[digit] = '2';
  damaged("SOL7", changed);
  std::string print = read(folder / "r/PRINT.txt");
  print[print.find("STEP")] = 'X';
  damaged("PRINT.txt", print);
  std::string h5 = read(folder / "r/RESULTS.h5");
  // A stored value: the time of the first stored step behind 0, found by its bytes.
  const std::string json = run_in(folder.path(), "convert r/RESULTS.h5 --to csv").out;
  std::istringstream lines(json);
  std::string line;
  for (int i = 0; i < 3; ++i) std::getline(lines, line);
  const double time = std::stod(line.substr(line.find(',') + 1));
  const std::string bytes(reinterpret_cast<const char*>(&time), sizeof time);
  const std::size_t at = h5.find(bytes);
  REQUIRE(at != std::string::npos);
  h5[at] = static_cast<char>(h5[at] ^ 1);
  damaged("RESULTS.h5", h5);
  CHECK(run_in(folder.path(), run + "0.03rev --continue").code == 0);
  const Result after = run_in(folder.path(), "verify r");
  INFO(after.out);
  CHECK(after.code == 0);
  fs::remove(folder / "r/SOL2");
  CHECK(contains(run_in(folder.path(), "verify r --json").out, "MISSING"));
  std::string summary = read(folder / "r/RUN.json");
  summary.replace(summary.find("\"steps\""), 7, "\"stepz\"");
  write(folder / "r/RUN.json", summary);
  CHECK(contains(run_in(folder.path(), "verify r").out, "DAMAGED    r/RUN.json"));
  CHECK(run_in(folder.path(), "verify bin").code == 2);
}

TEST_CASE("a record of a study whose value was changed → verify names it, resume computes it again",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "s.json", kSweep);
  REQUIRE(run_in(folder.path(), "study run s.json --workers 1 --quiet").code == 0);
  CHECK(run_in(folder.path(), "verify s.study").code == 0);
  const std::string table = read(folder / "s.study/RUNS.csv");
  fs::path record;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "s.study/runs"))
    if (entry.is_regular_file()) record = entry.path();
  std::string text = read(record);
  const std::size_t digit = text.find_first_of("123456789", text.find("\"values\":["));
  text[digit] = text[digit] == '9' ? '8' : static_cast<char>(text[digit] + 1);
  write(record, text);
  const Result verified = run_in(folder.path(), "verify s.study");
  CHECK(verified.code == 1);
  CHECK(contains(verified.out, record.filename().string()));
  REQUIRE(run_in(folder.path(), "study resume s.json --workers 1 --quiet").code == 0);
  CHECK(run_in(folder.path(), "verify s.study").code == 0);
  CHECK(read(folder / "s.study/RUNS.csv") == table);
}

TEST_CASE("drawing process killed → message with its name, exit code 2", "[cli]") {
  if (contains(run_adore("plot none --out none").out, "ADORE_WITH_QT")) return;  // no pictures
  const Folder folder;
  new_ball_deck(folder);
  write(folder / "s.json", kSweep);
  // A program in the place of adore-pictures that kills itself.
  fs::create_directories(folder / "bin");
  fs::copy_file(program("adore"), folder / "bin/adore");
  write(folder / "bin/adore-pictures", "#!/bin/sh\nkill -9 $$\n");
  fs::permissions(folder / "bin/adore-pictures", fs::perms::owner_all);
  const Result run = run_shell("cd " + folder.path().string() +
                               " && bin/adore study run s.json --workers 1 --quiet 2>&1");
  INFO(run.out);
  CHECK(run.code == 2);
  CHECK(contains(run.out, "signal 9"));
  CHECK(contains(run.out, "adore study report"));
  CHECK(fs::exists(folder / "s.study/RUNS.csv"));
}

TEST_CASE("a table of runs with 10,027 columns or without a row → refused, nothing drawn",
          "[cli]") {
  if (contains(run_adore("plot none --out none").out, "ADORE_WITH_QT")) return;  // no pictures
  const Folder folder;
  for (const int columns : {10027, 3}) {
    write(folder / "SWEEP.csv",
          "appLoadX [N],exit,displacement_x_m" + std::string(columns, ',') + "message\n");
    const Result refused = run_in(folder.path(), "plot SWEEP.csv --out p");
    INFO(refused.out);
    CHECK(refused.code == 2);
    CHECK_FALSE(fs::exists(folder / "p/SWEEP.csv-page-01.png"));
  }
}

TEST_CASE("escape sequences in names and in result files → visible text", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  REQUIRE(run_in(folder.path(), "run DATA.txt --set mode=-1 --out r --quiet").code == 0);
  std::string run = read(folder / "r/RUN.json");
  const std::size_t at = run.find("\"run\": \"") + 8;
  run.insert(at, "\\u001b]0;title\\u0007\\u009b31m");
  write(folder / "r/RUN.json", run);
  write(folder / "ADORE.json", "{\"\\u001b[31m\":1}");
  const std::string name = "e\x1b[31m\xc2\x9b";
  fs::copy_file(folder / "DATA.txt", folder / name);
  for (const std::string& words :
       {std::string("convert r/RUN.json --to csv"), std::string("convert r/RUN.json --to json"),
        std::string("show r/RUN.json"), std::string("check ."), "check '" + name + "'",
        "check 'no " + name + "'", "run '" + name + "' --set mode=-1 --out q", "new '" + name + "'",
        "'" + name + "'"}) {
    const Result said = run_in(folder.path(), words);
    INFO(words << ": " << said.out);
    CHECK_FALSE(contains(said.out, "\x1b"));
    CHECK_FALSE(contains(said.out, "\xc2\x9b"));
    CHECK_FALSE(contains(said.out, "\x07"));
  }
}
