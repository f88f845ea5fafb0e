#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/output_folder.hpp"
#include "runs/results_folder.hpp"
#include "runs/run.hpp"
#include "runs/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

using namespace adore;
using namespace adore::runs;
namespace fs = std::filesystem;

TEST_CASE("results folder: created here and empty → removed, others kept", "[unit][folders]") {
  const testing::TemporaryFolder place;
  const fs::path there = place / "there";
  fs::create_directory(there);
  for (const char* name : {"new", "new/below", "there/new/below", "new/"}) {
    CAPTURE(name);
    {
      const ResultsFolder folder(place / name);
      CHECK(fs::is_directory(folder.path()));
    }
    CHECK_FALSE(fs::exists(place / "new"));
    CHECK(fs::exists(there));
    CHECK(fs::is_empty(there));
  }
  { const ResultsFolder folder(there); }
  CHECK(fs::exists(there));
  {
    const ResultsFolder folder(place / "kept/below");
    std::ofstream(folder.path() / "PRINT.txt") << "text";
  }
  CHECK(fs::exists(place / "kept/below/PRINT.txt"));
  std::ofstream(place / "file") << "text";
  CHECK_THROWS_AS(ResultsFolder(place / "file"), InputError);
}

TEST_CASE("run: rejected → leaves no folder", "[unit][folders]") {
  const testing::TemporaryFolder place;
  RunRequest request;
  request.text = std::string(deck::template_text("ball"));
  request.out = place / "a/b";
  SECTION("an integrator that is not stable") { request.integrator = "rkf1"; }
  SECTION("an end that is none") { request.until = "3parsec"; }
  SECTION("nothing to go on with") { request.go_on = true; }
  SECTION("invalid range of a sweep") { request.sets = {{"nonsense", "3"}}; }
  CHECK_THROWS_AS(run(request), InputError);
  CHECK_FALSE(fs::exists(place / "a"));
}

TEST_CASE("temporary folders: of killed processes → removed, of running ones and others → kept",
          "[unit][folders]") {
  const testing::TemporaryFolder place;
  // In a process of its own: the first folder of a process looks for those that were left.
  const auto in_a_child = [&](auto&& act) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::setenv("TMPDIR", fs::path(place / "").c_str(), 1);
      act();
      ::_exit(0);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(status == 0);
  };
  in_a_child([] { new TemporaryFolder; });  // ends without its destructor, as if it were killed
  REQUIRE(std::distance(fs::directory_iterator(place / ""), {}) == 1);
  const fs::path left = *fs::directory_iterator(place / "");
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  const auto make = [&](const char* name, const char* text) {
    fs::create_directory(place / name);
    std::ofstream(place / name / FolderLock::kName) << text;
    fs::last_write_time(place / name / FolderLock::kName, old);
  };
  make("adore-temporary-ABCDEF", "my own notes");     // no lock
  make("adore-temporary-ABCDEFG", "process 1 on x");  // not our name
  make("data-ABCDEF", "process 1 on x");
  fs::create_directory(place / "adore-temporary-GHIJKL");  // without a lock
  // Results of a run that was killed, whatever somebody called their folder.
  for (const char* name : {"adore-ABCDEF", "adore-temporary-MNOPQR"}) {
    make(name, "process 1 on x");
    std::ofstream(place / name / "MASTER") << "to be continued";
  }
  const auto count = [&] { return std::distance(fs::directory_iterator(place / ""), {}); };
  in_a_child([] { const TemporaryFolder folder; });
  CHECK(fs::exists(left));  // its lock is too young to tell
  fs::last_write_time(left / FolderLock::kName, old);
  {
    fs::create_directory(place / "adore-temporary-living");
    const FolderLock held{WriteFolder(place / "adore-temporary-living")};
    fs::last_write_time(place / "adore-temporary-living" / FolderLock::kName, old);
    in_a_child([] { const TemporaryFolder folder; });
    CHECK(fs::exists(place / "adore-temporary-living"));
    CHECK_FALSE(fs::exists(left));
  }
  CHECK(count() == 7);
  std::ofstream(place / "adore-temporary-living" / FolderLock::kName) << "process 1 on x";
  fs::last_write_time(place / "adore-temporary-living" / FolderLock::kName, old);
  in_a_child([] { const TemporaryFolder folder; });
  CHECK(count() == 6);
  for (const char* name : {"adore-ABCDEF", "adore-temporary-MNOPQR"})
    CHECK(fs::exists(place / name / "MASTER"));
  CHECK_FALSE(fs::exists(place / "adore-temporary-living"));
}
