#include "cli/driver.hpp"
#include "results/sol_file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

TEST_CASE("adore: unreadable input → rejected with a message, exit code 2", "[cli]") {
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
  refused(run_adore("calc hertz --json " + deck), "JSON");
  refused(run_adore("calc no-such --json " + deck), "no calculator named \"no-such\"");
  refused(run_adore("show " + deck), "DATA.txt");
  refused(run_adore("nonsense"), "there is no command \"nonsense\"");
}

TEST_CASE("adore new gives a deck of every type that runs in time", "[cli]") {
  const Folder folder;
  for (const std::string type : {"cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const std::string deck = (folder / (type + ".txt")).string();
    const fs::path out = folder / type;
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    const Result check = run_adore("check " + deck);
    INFO(check.out);
    CHECK(check.code == 0);
    CHECK_FALSE(contains(check.out, "will refuse"));
    const Result run = run_adore("run " + deck + " --until 0.05rev --out " + out.string());
    INFO(run.out);
    REQUIRE(run.code == 0);
    const results::SolFile roller = results::read_sol((out / "SOL1").string());
    CHECK(roller.header.bearing_type > 1);
    CHECK(roller.header.value_count == 54);
    REQUIRE_FALSE(roller.steps.empty());
    for (const double value : roller.steps.back().values) CHECK(std::isfinite(value));
  }
}

TEST_CASE(
    "adore check: deck that needs a missing feature → no errors in the check, rejected by record "
    "and variable",
    "[cli]") {
  const Folder folder;
  for (const std::string type : {"cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const std::string deck = (folder / (type + ".txt")).string();
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    const Result run = run_adore("run " + deck + " --set kDOF=6");
    INFO(run.out);
    CHECK(run.code == 2);
    CHECK(contains(run.out, "kDOF"));
    CHECK(contains(run.out, "user routine ADRX1"));
    CHECK_FALSE(fs::exists(folder / "PRINT.txt"));
  }
  new_ball_deck(folder);
  for (const std::string set : {"kReIP=3", "kDOF=6", "kRaceGeoImp1=3", "kReGeoImp=3"}) {
    const Result run = run_adore("run " + folder.path().string() + " --set " + set);
    INFO(set << "\n" << run.out);
    CHECK(run.code == 2);
    CHECK(contains(run.out, set.substr(0, set.find('='))));
  }
}

TEST_CASE("adore user new writes an example of every routine in every language", "[cli]") {
  const Folder folder;
  for (const std::string lang : {"c", "cpp", "fortran", "python"})
    for (int hook = 0; hook < 10; ++hook) {
      const std::string name = "adrx" + std::to_string(hook);
      const fs::path out = folder / (name + "-" + lang);
      const Result made =
          run_adore("user new " + name + " --lang " + lang + " --out " + out.string());
      INFO(made.out);
      CHECK(made.code == 0);
      const std::string ending = lang == "fortran" ? "f90" : lang == "python" ? "py" : lang;
      const std::string text = read(out / (name + "." + ending));
      CHECK(contains(text, "ADRX" + std::to_string(hook)));
      if (lang != "python") CHECK(contains(text, name + "("));
      CHECK_FALSE(contains(text, "THE_BODIES"));
      CHECK(fs::exists(out / "Makefile") == (lang != "python"));
      CHECK(run_adore("user new " + name + " --lang " + lang + " --out " + out.string()).code == 2);
    }
  CHECK(run_adore("user new adrx7 --lang pascal --out " + (folder / "p").string()).code == 2);
}

TEST_CASE("examples of user routines run as their last lines say", "[cli]") {
  for (int hook = 0; hook < 10; ++hook) {
    const Folder folder;
    new_ball_deck(folder);
    const fs::path out = folder / "mine";
    const std::string name = "adrx" + std::to_string(hook);
    const std::string told = run_adore("user new " + name + " --out " + out.string()).out;
    INFO(told);
    REQUIRE(std::system(("make -s -C " + out.string() + " >/dev/null").c_str()) == 0);
    const std::size_t set = told.find("--set "), lines = told.find("explain them. Example:\n");
    const std::string options =
        set == std::string::npos ? "" : told.substr(set, told.find_first_of(",\n", set) - set);
    const std::string run = "run " + folder.path().string() + " --set maxStps=3 " + options +
                            " --user " + (out / ("lib" + name + ".so")).string();
    if (lines != std::string::npos) {
      const Result without = run_adore(run);  // reports the missing part
      CHECK(without.code == 2);
      CHECK(contains(without.out, "must contain"));
      std::ofstream(folder / "DATA.txt", std::ios::app) << told.substr(told.find('\n', lines) + 1);
    }
    const Result ran = run_adore(run);
    INFO(ran.out);
    CHECK(ran.code == 0);
  }
}

TEST_CASE("integrator: impossible request → rejected before any file is changed", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  for (const std::string set :
       {" --set intMet=33 --set qFac=0.1", " --set intMet=21 --set stpMin=0.3 --set stpMax=0.3"}) {
    const Result run = run_adore("run " + folder.path().string() + set);
    INFO(run.out);
    CHECK(run.code == 2);
    CHECK_FALSE(fs::exists(folder / "PRINT.txt"));
  }
}

TEST_CASE("JSON and table output: plan, schema, examples, calc", "[cli]") {
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

TEST_CASE("adore calc: inputs described with units, others rejected", "[cli]") {
  const Folder folder;
  const auto calc = [&](const std::string& name, const std::string& input) {
    write(folder / "in.json", input);
    return run_adore("calc " + name + " --json " + (folder / "in.json").string());
  };
  const json list = json::parse(run_adore("calc --list --as-json").out);
  REQUIRE(list.size() > 30);
  for (const json& one : list) {
    INFO(one.at("name"));
    REQUIRE_FALSE(one.at("calculations").empty());
    for (const json& calculation : one.at("calculations")) {
      CHECK_FALSE(calculation.at("inputs").empty());
      const json& row = calculation.at("inputs").at(0);
      CHECK(row.contains("unit"));
    }
  }
  const std::string text = run_adore("calc hertz --describe").out;
  CHECK(contains(text, "body1.E"));
  CHECK(contains(text, "Pa"));
  const std::string example = text.substr(text.find("example") + 8);
  const Result good = calc("hertz", example);
  INFO(good.out);
  REQUIRE(good.code == 0);
  CHECK(json::parse(good.out).at("units").at("p_max") == "Pa");

  struct Refusal {
    const char* name;
    const char* input;
    const char* said;
  };
  const Refusal refusals[] = {
      {"hertz", "{}", "body1.E: missing; give a number above 0, up to 2e12 [Pa]"},
      {"hertz", R"({"bodyy1": {}})", "bodyy1: there is no such input; did you mean body1"},
      {"hertz", R"({"body1": {"Rx": 0.01, "Ry": 0.01, "E": -1, "nu": 0.3}})",
       "body1.E = -1: out of range; give a number above 0, up to 2e12 [Pa]"},
      {"hertz", R"({"load": -10})",
       "load = -10: out of range; give a number above 0, up to 1e10 [N]"},
      {"hertz", R"({"load": "much"})",
       "load = \"much\": not a number; give a number above 0, up to 1e10 [N]"},
      {"hertz", R"({"body1": 3})", "give an object with E, Rx, Ry, nu"},
      {"material", R"({"code": 101.5})", "code = 101.5: not a whole number"},
      {"material", R"({"code": 100, "temperature": 300})", "there is no such input"},
      {"fits", R"({"inputs": 3})", "must be one JSON object"},
  };
  for (const Refusal& r : refusals) {
    const Result result = calc(r.name, r.input);
    INFO(result.out);
    CHECK(result.code == 2);
    CHECK(contains(result.out, r.said));
    CHECK_FALSE(contains(result.out, "json.exception"));
  }
  const json hot = json::parse(calc("material", R"({"code": 100, "T": 2500})").out);
  CHECK(contains(hot.at("clamped").at("elastic_modulus").get<std::string>(), "T is outside"));
  CHECK(json::parse(calc("material", R"({"code": 100, "T": 300})").out).at("clamped").empty());
}

TEST_CASE("the deck reference of the docs is what the schema says now", "[cli]") {
  const std::string written = read(source_dir() / "resources/docs/deck-reference.md");
  INFO("make it anew: adore schema --format md > resources/docs/deck-reference.md");
  CHECK((run_as_given("schema --format md").out == written));
}

TEST_CASE("findings page: equals the output of its command", "[cli]") {
  INFO("make it anew: adore check --codes > resources/docs/findings.md");
  CHECK((run_as_given("check --codes").out == read(source_dir() / "resources/docs/findings.md")));
}
