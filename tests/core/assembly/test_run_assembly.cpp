#include "assembly/run_assembly.hpp"
#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "pair_folder.hpp"
#include "results/run_json.hpp"
#include "results/static_tables.hpp"
#include "runs/output_folder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace adore;
using namespace adore::assembly;
using namespace adore::test;

namespace {

Assembly pair() {
  Assembly set = spaced("DB");
  set.preload.kind = PreloadKind::Force;
  set.preload.force = 300.0;
  set.load = {100.0, 0.0, 600.0, 0.0, 0.0};
  return set;
}

nlohmann::json json_of(const std::filesystem::path& file) {
  return parse_json(read_text_file(file), file.string());
}

}  // namespace

TEST_CASE("run_assembly(): PRINT.txt and RUN.json of the set, row-N/ of each row",
          "[unit][assembly]") {
  const AssemblyFolder folder(pair(), {{timken_deck(), ""}});
  AssemblyRunRequest request;
  request.folder = folder.path();
  request.out = folder.path() / "results";
  const AssemblyOutcome done = run_assembly(request);
  for (const char* name : {"PRINT.txt", "RUN.json", "row-1/PRINT.txt", "row-1/RUN.json",
                           "row-2/PRINT.txt", "row-2/RUN.json"}) {
    CAPTURE(name);
    CHECK(std::filesystem::exists(*request.out / name));
  }
  const nlohmann::json run = json_of(*request.out / "RUN.json");
  CHECK(run.at("status") == "done");
  CHECK(run.at("deck") == "ASSEMBLY.json");
  CHECK(run.at("summary").at("preload_unmounted_N").get<double>() == Approx(300.0));
  CHECK(run.at("assembly").at("rows").size() == 2);
  CHECK(run.at("assembly").at("unloading").size() == 2);
  // A row's files are those of its deck at its part of the load.
  double x = 0.0, z = 0.0;
  for (const char* row : {"row-1", "row-2"}) {
    const nlohmann::json own = json_of(*request.out / row / "RUN.json");
    const double sign = std::string(row) == "row-1" ? 1.0 : -1.0;
    x += sign * own.at("summary").at("load_x_N").get<double>();
    z += own.at("summary").at("load_z_N").get<double>();
  }
  CHECK(x == Approx(100.0).epsilon(1e-6));
  CHECK(z == Approx(600.0).epsilon(1e-6));
  const results::StaticTables tables = results::read_static_tables(*request.out / "RUN.json");
  REQUIRE(tables.find("rows") != nullptr);
  REQUIRE(tables.find("axial force") != nullptr);
  REQUIRE(tables.find("preload") != nullptr);
  CHECK(tables.find("axial force")->find("axial load of row 2") != nullptr);
}

TEST_CASE("run_assembly(): existing results are kept unless overwriting is allowed",
          "[unit][assembly]") {
  const AssemblyFolder folder(pair(), {{timken_deck(), ""}});
  AssemblyRunRequest request;
  request.folder = folder.path();
  (void)run_assembly(request);
  const std::string before = read_text_file(folder.path() / "row-1" / "PRINT.txt");
  CHECK_THROWS_AS(run_assembly(request), runs::ResultsExist);
  request.overwrite = true;
  (void)run_assembly(request);
  CHECK(read_text_file(folder.path() / "row-1" / "PRINT.txt") == before);
}

TEST_CASE("check_assembly(): errors name file, row and cause; nothing is written",
          "[unit][assembly]") {
  const AssemblyFolder folder(pair(), {{timken_deck(), ""}});
  AssemblyRequest request;
  request.folder = folder.path();
  const AssemblyCheck good = check_assembly(request);
  CHECK(good.ok());
  CHECK(good.rows == 2);
  for (const Finding& one : good.issues) CHECK(one.text().find("has no load") == std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "RUN.json"));
  request.sets = {{"mode", "0"}};
  const AssemblyCheck moving = check_assembly(request);
  CHECK_FALSE(moving.ok());
  REQUIRE_FALSE(moving.issues.empty());
  CHECK(moving.issues.front().text().find("several rows on one shaft") != std::string::npos);
  request.sets = {{"pitchDia", "0.01"}};
  CHECK_FALSE(check_assembly(request).ok());
}

TEST_CASE("run_assembly(): findings of rows have the row in front, those of the set the file",
          "[unit][assembly]") {
  Assembly set = pair();
  set.load = {5000.0, 0.0, 0.0, 0.0, 0.0};  // far beyond the unloading force
  const AssemblyFolder folder(set, {{timken_deck(), ""}});
  const AssemblyResult result = folder.solve();
  const auto has = [&](const std::string& code, const std::string& text) {
    return std::any_of(result.findings.begin(), result.findings.end(), [&](const Finding& one) {
      return one.code == code && one.text().find(text) != std::string::npos;
    });
  };
  CHECK(has("assembly.unloaded_row", "row 2 carries no load"));
  CHECK(result.rows[1].state.loaded == 0);
  CHECK(std::any_of(result.findings.begin(), result.findings.end(),
                    [](const Finding& one) { return one.message.rfind("row 1: ", 0) == 0; }));
}
