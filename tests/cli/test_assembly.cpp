#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

using namespace adore::test;

namespace {

std::string new_pair(const Folder& folder) {
  const std::string set = (folder / "set").string();
  const Result made = run_adore(
      "new --assembly DB --catalogue '7012 C' --preload 211 --speed 1000 --radial 500 --out " +
      set);
  INFO(made.out);
  REQUIRE(made.code == 0);
  REQUIRE(fs::exists(folder.path() / "set" / "ASSEMBLY.json"));
  REQUIRE(fs::exists(folder.path() / "set" / "row-2" / "DATA.txt"));
  return set;
}

bool has(const Result& result, const std::string& text) {
  return result.out.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("adore run: folder with ASSEMBLY.json → files of set and rows", "[cli][assembly]") {
  const Folder folder;
  const std::string set = new_pair(folder), out = (folder / "results").string();
  const Result run = run_adore("run " + set + " --out " + out);
  INFO(run.out);
  CHECK(run.code == 0);
  CHECK(has(run, "arrangement DB, 2 rows"));
  CHECK(has(run, "preload: 211 N unmounted"));
  CHECK(has(run, "unloads row 2"));
  for (const char* name : {"PRINT.txt", "RUN.json", "row-1/PRINT.txt", "row-2/RUN.json"})
    CHECK(fs::exists(fs::path(out) / name));
  // Results are kept unless --overwrite is given.
  CHECK(run_as_given("run " + set + " --out " + out + " < /dev/null").code == 2);
  const Result json = run_adore("run " + set + " --out " + out + " --overwrite --json");
  CHECK(json.code == 0);
  const auto data = nlohmann::json::parse(json.out.substr(json.out.find('{')));
  CHECK(data.at("results").at("preload_unmounted_N").get<double>() == Approx(211.0));
  CHECK(data.at("assembly").at("rows").size() == 2);
}

TEST_CASE("adore run: motions and sweeps of an assembly → exit code 2 with the reason",
          "[cli][assembly]") {
  const Folder folder;
  const std::string set = new_pair(folder);
  const Result moving = run_adore("run " + set + " --set mode=0");
  CHECK(moving.code == 2);
  CHECK(has(moving, "motions of several rows on one shaft are not available"));
  for (const char* option : {"--until 1rev", "--integrator rkf4", "--tol 1e-6", "--accuracy 1%",
                             "--continue", "--set rpm2=1:10:3"}) {
    CAPTURE(option);
    CHECK(run_adore("run " + set + " " + option).code == 2);
  }
  CHECK_FALSE(fs::exists(fs::path(set) / "RUN.json"));
}

TEST_CASE("adore check: assembly with and without errors", "[cli][assembly]") {
  const Folder folder;
  const std::string set = new_pair(folder);
  const Result good = run_adore("check " + set);
  INFO(good.out);
  CHECK(good.code == 0);
  CHECK(has(good, "2 rows, 0 errors, 0 warnings or notes"));
  std::ofstream(fs::path(set) / "ASSEMBLY.json")
      << R"({"version": 1, "arrangement": "DB", "rows": [{"deck": "row-1"}, {"deck": "row-3"}]})";
  const Result missing = run_adore("check " + set);
  CHECK(missing.code == 2);
  CHECK(has(missing, "row-3"));
}

TEST_CASE("adore new --assembly: wrong requests → exit code 2", "[cli][assembly]") {
  const Folder folder;
  const std::string out = " --out " + (folder / "set").string();
  CHECK(run_adore("new ball --assembly XX" + out).code == 2);
  CHECK(run_adore("new ball --assembly DB").code == 2);
  CHECK(run_adore("new --assembly DB" + out).code == 2);
  CHECK(run_adore("new ball --assembly DT --preload 100" + out).code == 2);
  CHECK(run_adore("new ball --assembly DB --preload 100 --offset 5" + out).code == 2);
  CHECK_FALSE(fs::exists(folder / "set"));
  CHECK(run_adore("new ball --assembly DB --offset 5" + out).code == 0);
  CHECK(run_adore("new ball --assembly DB --offset 5" + out).code == 2);  // exists
}
