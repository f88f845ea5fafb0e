#include "cli/driver.hpp"
#include "results/restart.hpp"

#include <map>

/// Files that a run may replace, and locks of a folder.
using namespace adore;
using namespace adore::test;

namespace {

const std::string kShort = " --quiet --until 0.005rev";

std::map<std::string, std::string> content(const fs::path& folder) {
  std::map<std::string, std::string> out;
  for (const auto& entry : fs::directory_iterator(folder))
    out[entry.path().filename().string()] =
        entry.is_regular_file() ? read(entry.path()) : std::string("no file");
  return out;
}

/// The example deck with names on record 2.3, as "deck" in the folder.
fs::path deck_with_names(const Folder& folder, const std::string& names,
                         const std::string& file = "DATA.txt") {
  std::string text = run_adore("new ball").out;
  const std::size_t option = text.find("'Rec 1', 0, 0, 0, 0, 0,");
  REQUIRE(option != std::string::npos);
  text.replace(option, 23, "'Rec 1', 0, 0, 0, 0, 1,");
  const std::size_t third = text.find("'Rec 3.1'");
  REQUIRE(third != std::string::npos);
  text.insert(third, "'Rec 2.3', " + names + "\n");
  write(folder / file, text);
  return folder / file;
}

std::string names_with(const std::string& final_file, const std::string& first_plot) {
  return "'MASTER', '" + final_file + "', '" + first_plot +
         "', 'SOL2', 'SOL3', 'SOL4', 'SOL5', 'SOL6', 'SOL7', 'SOL8'";
}

}  // namespace

TEST_CASE("outputs: inputs and files of other programs are not replaced", "[cli]") {
  const auto refused = [](const fs::path& deck, const Folder& folder, const std::string& said) {
    const auto before = content(folder.path());
    for (const char* how : {"", " --overwrite"}) {
      const Result run = run_as_given("run " + deck.string() + kShort + how);
      INFO(run.out);
      CHECK(run.code == 2);
      CHECK(contains(run.out, said));
      CHECK(content(folder.path()) == before);
    }
  };
  {  // the deck has the name of an output
    const Folder folder;
    REQUIRE(run_adore("new ball --out " + (folder / "SOL1").string()).code == 0);
    refused(folder / "SOL1", folder, "an input");
  }
  {
    const Folder folder;
    REQUIRE(run_adore("new ball --out " + (folder / "PRINT.txt").string()).code == 0);
    refused(folder / "PRINT.txt", folder, "an input");
  }
  {
    const Folder folder;
    refused(deck_with_names(folder, names_with("FINAL", "D.txt"), "D.txt"), folder,
            "the deck itself");
  }
  for (const std::string name : {"run.sh", ".bashrc", "a b", "-rf", "x.py", "a;b", "../x"}) {
    const Folder folder;
    refused(deck_with_names(folder, names_with(name, "SOL1")), folder, "finName");
  }
  {  // of the lock
    const Folder folder;
    REQUIRE(run_adore("new ball --out " + (folder / ".adore.lock").string()).code == 0);
    refused(folder / ".adore.lock", folder, "this name is reserved for the lock file");
  }
  {  // somebody's own file
    const Folder folder;
    const fs::path deck = deck_with_names(folder, names_with("notes", "SOL1"));
    write(folder / "notes", "what I must not forget\n");
    refused(deck, folder, "was not written by this program");
  }
  {
    const Folder folder;
    new_ball_deck(folder);
    write(folder / "SOL2", "");
    fs::permissions(folder / "SOL2", fs::perms::owner_all);
    refused(folder / "DATA.txt", folder, "was not written by this program");
  }
  {
    const Folder folder, outside;
    new_ball_deck(folder);
    write(outside / "far", "");
    fs::create_symlink(outside / "far", folder / "SOL3");
    refused(folder / "DATA.txt", folder, "symbolic link");
    CHECK(read(outside / "far").empty());
  }
  {
    const Folder folder;
    new_ball_deck(folder);
    fs::create_directory(folder / "MASTER");
    refused(folder / "DATA.txt", folder, "not a regular file");
  }
}

TEST_CASE("results of an earlier run → replaced only on request", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string run = "run " + folder.path().string() + kShort;
  REQUIRE(run_as_given(run).code == 0);
  const auto before = content(folder.path());
  CHECK(before.count("SOL8") == 1);
  for (const std::string& again : {run, run + " --set mode=-1", run + " --set kIcOpt=-1"}) {
    const Result refused = run_as_given(again + " < /dev/null");
    INFO(again << "\n" << refused.out);
    CHECK(refused.code == 2);
    for (const char* way : {"--continue", "--overwrite", "--out"})
      CHECK(contains(refused.out, way));
    CHECK(content(folder.path()) == before);
  }

  // A link to an old file from elsewhere keeps what it had; nothing stays a program.
  fs::create_hard_link(folder / "SOL1", folder / "kept");
  fs::permissions(folder / "SOL7", fs::perms::owner_all);
  fs::permissions(folder / "FINAL", fs::perms::owner_all);
  fs::permissions(folder / "RUN.json", fs::perms::owner_all);
  const Result replaced = run_as_given(run + " --overwrite --set kAGraf=0 --set appLoadX=1600.0");
  INFO(replaced.out);
  REQUIRE(replaced.code == 0);
  CHECK(read(folder / "kept") == before.at("SOL1"));
  CHECK(read(folder / "SOL1") != before.at("SOL1"));
  for (const char* name : {"SOL7", "FINAL", "RUN.json"})
    CHECK((fs::status(folder / name).permissions() & fs::perms::owner_exec) == fs::perms::none);
  // Files that the new run does not write are removed from its files.
  CHECK_FALSE(fs::exists(folder / "SOL8"));
  CHECK(read(folder / "earlier-1" / "SOL8") == before.at("SOL8"));
  CHECK(contains(replaced.out, "earlier-1"));

  REQUIRE(run_as_given(run + " --overwrite --set mode=-1").code == 0);
  for (const char* name : {"SOL1", "SOL7", "FINAL", "MASTER", "RESULTS.h5"}) {
    INFO(name);
    CHECK_FALSE(fs::exists(folder / name));
    CHECK(fs::exists(folder / "earlier-2" / name));
  }
}

TEST_CASE("suggested commands → valid for any folder name", "[cli]") {
  Folder folder;
  REQUIRE(run_adore("new ball --out " + (folder / "DATA.txt").string()).code == 0);
  const std::string here = "cd " + folder.path().string() + " && ";
  for (const char* out : {"-out", "two words", "it's"}) {
    std::string argument = out;
    if (argument == "it's") argument = "it'\\''s";
    const Result made = run_shell(
        here + "ADORE run DATA.txt --until 0.01rev --progress none --out='" + argument + "'");
    INFO(made.out);
    REQUIRE(made.code == 0);
    int tried = 0;
    std::istringstream lines(made.out);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t at = line.find("adore plot");
      if (at == std::string::npos) continue;
      ++tried;
      // Without drawing: no file has such a page.
      const Result read = run_shell(here + "ADORE " + line.substr(at + 6) + " --page 9999 2>&1");
      INFO(line << '\n' << read.out);
      CHECK(read.out.find("9999") != std::string::npos);
      CHECK(read.out.find("has no option") == std::string::npos);
      CHECK(read.out.find("one argument too many") == std::string::npos);
    }
    CHECK(tried > 0);
  }
}

TEST_CASE("one process at a time writes into a folder", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  EndlessRun run(folder);
  wait_for([&] { return fs::exists(folder / "MASTER"); });
  const Result second = run_as_given("run " + folder.path().string() + kShort + " --overwrite");
  INFO(second.out);
  CHECK(second.code == 2);
  CHECK(contains(second.out, "another run is writing into this folder (process "));
  CHECK(run.alive());
  // Its lock dies with it, also when it is killed.
  run.send(SIGKILL);
  run.end();
  CHECK(fs::exists(folder / ".adore.lock"));
  CHECK(run_as_given("run " + folder.path().string() + kShort + " --overwrite").code == 0);
  CHECK_FALSE(fs::exists(folder / ".adore.lock"));
}

TEST_CASE("exports replace neither what they read nor anything but an earlier export", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  REQUIRE(run_adore("run " + folder.path().string() + kShort).code == 0);
  const std::string sol = (folder / "SOL1").string(), before = read(sol);
  const auto convert = [&](const std::string& out) {
    return run_adore("convert " + sol + " --to csv --out " + (folder / out).string());
  };
  CHECK(convert("SOL1").code == 2);
  CHECK(convert("DATA.txt").code == 2);
  CHECK(convert("MASTER").code == 2);
  CHECK(read(sol) == before);
  CHECK(convert("SOL1.csv").code == 0);
  CHECK(convert("SOL1.csv").code == 0);
  CHECK(read(folder / "SOL1.csv") == run_adore("convert " + sol + " --to csv").out);
  CHECK(convert("SOL1.csv").out.empty());
}

TEST_CASE("standard streams: write error → reported, results complete", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string(), out = " --out " + (folder / "out").string(),
                    run = "ADORE run " + deck + " --overwrite --until 0.005rev" + out;
  const auto complete = [&] {
    CHECK(contains(read(folder / "out" / "RUN.json"), "\"status\": \"done\""));
    CHECK(read(folder / "out" / "SOL1").rfind("  Adore", 0) == 0);
    CHECK(read(folder / "out" / "PRINT.txt").rfind("\fAdore", 0) == 0);
    fs::remove_all(folder / "out");
  };
  CHECK(run_shell(run + " --progress plain 2>/dev/full").code == 0);
  complete();
  CHECK(run_shell(run + " --progress json 2>/dev/full").code == 0);
  complete();
  const Result full = run_shell("{ " + run + " --progress none >/dev/full; } 2>&1");
  CHECK(full.code == 2);
  CHECK(contains(full.out, "standard output cannot be written"));
  complete();
  run_shell(run + " >&- 2>&- <&-");
  complete();
  CHECK(run_shell("{ " + run + " --progress plain; echo code $? >&3; } 2>&1 3>" +
                  (folder / "code").string() + " | true")
            .code == 0);
  CHECK(contains(read(folder / "code"), "code "));
  complete();

  REQUIRE(run_adore("run " + deck + " --until 0.005rev --quiet" + out).code == 0);
  const std::string sol = (folder / "out" / "SOL1").string();
  const std::vector<std::string> commands{"convert " + sol + " --to csv",
                                          "convert " + sol + " --to json",
                                          "show " + sol,
                                          "plan " + deck,
                                          "schema",
                                          "new ball",
                                          "examples",
                                          "check " + deck};
  for (const std::string& command : commands) {
    const Result lost = run_shell("{ ADORE " + command + " >/dev/full; } 2>&1");
    INFO(command << "\n" << lost.out);
    CHECK(lost.code == 2);
    CHECK(contains(lost.out, "standard output cannot be written"));
  }
}
