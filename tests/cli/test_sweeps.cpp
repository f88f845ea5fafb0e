#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

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
  CHECK(fs::exists(folder / "sweep" / "appLoadX-3" / "PRINT.txt"));
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
