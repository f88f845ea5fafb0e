#include "base/errors.hpp"
#include "user/formulas.hpp"
#include "user/host.hpp"
#include "user/session.hpp"
#include "user/table.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>

using namespace adore;

namespace {

/// A bearing whose numbers nobody looks at.
bearing::Bearing some_bearing() {
  bearing::Bearing out;
  bearing::BallGeometry balls;
  balls.count = 12;
  balls.diameter = 0.0127;
  balls.pitch_diameter = 0.07;
  out.elements = balls;
  return out;
}

struct Asked {
  std::vector<double> kappa;
  bool failed = false, refused = false;
  std::string failure;
};

/// Starts a session and asks for κ of three contacts of two points, `times` times.
Asked ask(user::PlugIn plug_in, const std::vector<std::string>& lines, int times = 1) {
  auto session = std::make_shared<user::Session>(std::move(plug_in), lines);
  session->start(some_bearing(), {true, false, false, false, false});
  const auto laws = session->laws(session);
  const tribology::UserTractionRoutine* law =
      laws->traction_of(tribology::TractionKind::ElementRace);
  REQUIRE(law != nullptr);
  Asked out;
  for (int k = 0; k < times; ++k) {
    const std::vector<double> slip{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, contact{1.0, 2.0, 3.0};
    out.kappa.assign(6, 0.0);
    laws->time = 1e-3;
    law->ask(law->routine, {0, 1, 3, 2, 3, slip.data(), slip.data(), contact.data(), contact.data(),
                            contact.data(), contact.data(), contact.data(), contact.data(),
                            contact.data(), out.kappa.data()});
    out.refused = laws->refused() || out.refused;
  }
  out.failed = laws->failed();
  out.failure = session->failure();
  return out;
}

/// ADRX7 by a function of the arguments, active at once.
user::PlugIn traction_of(std::function<std::int32_t(adore_adrx7&)> compute) {
  user::PlugIn out;
  out.source = "the test";
  out.hooks[7] = [compute](adore_call& call) {
    call.active = 1;
    return call.mode == ADORE_COMPUTE ? compute(reinterpret_cast<adore_adrx7&>(call)) : 0;
  };
  return out;
}

std::string library(const char* name) {
  return (std::filesystem::path(USER_PLUG_INS) / ("lib" + std::string(name) + ".so")).string();
}

std::string written(const std::string& name, const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / ("adore-user-" + name);
  std::ofstream(path) << text;
  return path.string();
}

std::string problem_of(const std::string& json) {
  try {
    (void)user::load_plug_in(written("laws.json", json));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("user routines: lines of records 12.x → list-directed read", "[user][unit]") {
  using user::parse_list_directed;
  CHECK(parse_list_directed(" 1, 2.5  3d-2") == std::vector<double>{1.0, 2.5, 0.03});
  CHECK(parse_list_directed("3*0.5 -1") == std::vector<double>{0.5, 0.5, 0.5, -1.0});
  CHECK(parse_list_directed("1 2 / 3") == std::vector<double>{1.0, 2.0});
  CHECK(parse_list_directed("'text' 3").empty());
  CHECK(parse_list_directed("1 seconds") == std::vector<double>{1.0});
}

TEST_CASE("user table: monotone between monotone points, exact there, constant beyond",
          "[user][analytic]") {
  const user::MonotoneTable table({0.0, 0.1, 0.2, 1.0}, {0.0, 0.05, 0.06, 0.06});
  CHECK(table(0.1) == Approx(0.05).epsilon(1e-15));
  CHECK(table(-1.0) == 0.0);
  CHECK(table(5.0) == 0.06);
  double before = 0.0;
  for (int k = 0; k <= 1000; ++k) {
    const double here = table(1e-3 * k);
    CHECK(here >= before - 1e-16);
    CHECK(here <= 0.06 + 1e-15);
    before = here;
  }
  // A straight line is met everywhere.
  const user::MonotoneTable line({0.0, 1.0, 3.0}, {1.0, 3.0, 7.0});
  CHECK(line(2.2) == Approx(5.4).epsilon(1e-14));
}

TEST_CASE("user formula: gives its traction, with numbers of records 12.x", "[user][unit]") {
  const auto file = written("formula.json", R"~({"version": "tanh 1", "adrx7": {
      "read": ["mu", "u1"], "constants": {"double_mu": "2*mu"},
      "element_race": {"formula": "double_mu/2*tanh(u/u1)", "slip_scale": "u1"}}})~");
  const Asked found = ask(user::load_plug_in(file), {"0.06  0.2"});
  CHECK_FALSE(found.failed);
  for (int k = 0; k < 6; ++k)
    CHECK(found.kappa[static_cast<std::size_t>(k)] ==
          Approx(0.06 * std::tanh(0.1 * (k + 1) / 0.2)).epsilon(1e-14));
}

TEST_CASE("user formulas: error → message with its place in the file", "[user][unit]") {
  CHECK_THAT(problem_of(R"~({"adrx7": {"element_race": {"formula": "0.06*tanh(v1)"}}})~"),
             Catch::Contains("adrx7, element_race, formula") && Catch::Contains("known names"));
  CHECK_THAT(problem_of(R"~({"adrx7": {"element_rase": {"formula": "1"}}})~"),
             Catch::Contains("element_rase") && Catch::Contains("element_race"));
  CHECK_THAT(problem_of(R"~({"adrx7": {"read": ["u"], "element_race": {"formula": "u"}}})~"),
             Catch::Contains("choose another name"));
  CHECK_THAT(problem_of(R"~({"adrx7": {"element_race": {"table": "nowhere.csv"}}})~"),
             Catch::Contains("nowhere.csv"));
  CHECK_THAT(problem_of(R"~({"adrx12": {}})~"), Catch::Contains("known names: version, adrx0"));
  CHECK_THAT(problem_of(R"~({"version": "1"})~"), Catch::Contains("no routine"));
  CHECK_THAT(problem_of("[1]"), Catch::Contains("give a JSON object"));
}

TEST_CASE("plug-in: unusable → error with the reason", "[user][unit]") {
  const auto why = [](const std::string& file) {
    try {
      (void)user::load_plug_in(file);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(why("/nowhere/laws.so"), Catch::Contains("there is no plug-in /nowhere/laws.so"));
  CHECK_THAT(why(library("plug_in_no_abi")), Catch::Contains("adore_user_abi()"));
  CHECK_THAT(why(library("plug_in_other_abi")), Catch::Contains("version 99"));
  CHECK_THAT(why(library("plug_in_no_routine")),
             Catch::Contains("none of the routines adrx0 to adrx9"));
  CHECK_THAT(why(written("no-library.so", "text")), Catch::Contains("cannot be loaded"));
}

TEST_CASE("user routines: lines that no routine reads → error", "[user][unit]") {
  CHECK_THROWS_WITH(ask(traction_of([](adore_adrx7&) { return 0; }), {"1 2 3"}),
                    Catch::Contains("\"1 2 3\"") && Catch::Contains("ADRX7"));
}

TEST_CASE("user routines: every wrong answer → reported with routine, source and call",
          "[user][unit]") {
  const auto fill = [](adore_adrx7& a, double value) {
    for (std::int64_t k = 0; k < a.points * a.stride; ++k) a.kappa[k] = value;
  };
  const auto contact = [](const adore_adrx7& a) { return a.n == 3; };  // not the one at rest
  const auto named = Catch::Contains("user routine ADRX7 of the test, call ");
  SECTION("not a number") {
    const Asked found = ask(traction_of([&](adore_adrx7& a) {
                              fill(a, contact(a) ? std::nan("") : 0.0);
                              return 0;
                            }),
                            {});
    CHECK(found.failed);
    CHECK_THAT(found.failure, named && Catch::Contains("nan") && Catch::Contains("t = 0.001 s") &&
                                  Catch::Contains("element to race, inner race"));
    for (const double kappa : found.kappa) CHECK(kappa == 0.0);
  }
  SECTION("infinite") {
    const Asked found = ask(traction_of([&](adore_adrx7& a) {
                              fill(a, 0.0);
                              if (contact(a)) a.kappa[4] = std::numeric_limits<double>::infinity();
                              return 0;
                            }),
                            {});
    CHECK_THAT(found.failure, named && Catch::Contains("inf"));
  }
  SECTION("an exception") {
    const Asked found = ask(traction_of([&](adore_adrx7& a) -> std::int32_t {
                              if (contact(a)) throw std::runtime_error("out of oil");
                              return 0;
                            }),
                            {});
    CHECK_THAT(found.failure, named && Catch::Contains("out of oil"));
  }
  SECTION("another answer to the same question") {
    int calls = 0;
    const Asked found = ask(traction_of([&](adore_adrx7& a) {
                              fill(a, contact(a) ? 0.01 * ++calls : 0.0);
                              return 0;
                            }),
                            {});
    CHECK_THAT(found.failure, named && Catch::Contains("depend on the arguments only"));
  }
  SECTION("what belongs to the solver is changed") {
    const Asked found = ask(traction_of([&](adore_adrx7& a) {
                              if (contact(a)) const_cast<double*>(a.slip)[1] = 9.0;
                              return 0;
                            }),
                            {});
    CHECK_THAT(found.failure, named && Catch::Contains("changed its input arrays"));
  }
  SECTION("a number that is not 0") {
    const Asked found = ask(traction_of([&](adore_adrx7& a) {
                              if (!contact(a)) return 0;
                              a.call.services->fail(a.call.host, "the tank is empty");
                              return 4;
                            }),
                            {});
    CHECK_THAT(found.failure,
               named && Catch::Contains("returned 4") && Catch::Contains("the tank is empty"));
  }
  SECTION("a state that it does not know is no failure") {
    const Asked found = ask(traction_of([&](adore_adrx7& a) { return contact(a) ? 1 : 0; }), {});
    CHECK_FALSE(found.failed);
    CHECK(found.refused);
  }
}

TEST_CASE("plug-in: separate process → same answers as in this process", "[user][unit]") {
  const std::vector<std::string> line{"0 1"};
  const Asked here = ask(user::load_plug_in(library("plug_in_behaviours")), line);
  const Asked there = ask(user::load_in_own_process(library("plug_in_behaviours"), 10.0), line);
  CHECK(here.failure.empty());
  CHECK(there.failure.empty());
  CHECK(here.kappa == there.kappa);
  CHECK(there.kappa == std::vector<double>(6, 0.05));
}

TEST_CASE("plug-in: its process ends → reported, this program continues", "[user][unit]") {
  const auto failure_of = [](const char* line) {
    return ask(user::load_in_own_process(library("plug_in_behaviours"), 0.3), {line}).failure;
  };
  CHECK_THAT(failure_of("6 1"), Catch::Contains("ADRX7") && Catch::Contains("crashed"));
  CHECK_THAT(failure_of("7 1"), Catch::Contains("took more than 0.3 s"));
  CHECK_THAT(failure_of("8 1"), Catch::Contains("ended during the call (exit code 0)"));
  CHECK_THAT(failure_of("9 1"), Catch::Contains("signal 6"));
  CHECK_THAT(failure_of("11 1"), Catch::Contains("the oil is out"));
}

TEST_CASE("plug-in: 1000 of random behavior → run ends properly or continues", "[user][unit]") {
  std::mt19937 random(16);
  int failures = 0;
  for (int k = 0; k < 1000; ++k) {
    int what = static_cast<int>(random() % 14U);
    if (what == 7 && k % 20 != 0) what = 6;  // waiting takes time
    const std::string line = std::to_string(what) + " " + std::to_string(k);
    const Asked found =
        ask(user::load_in_own_process(library("plug_in_behaviours"), 0.25), {line}, 3);
    for (const double kappa : found.kappa) CHECK(std::isfinite(kappa));
    if (what >= 1 && what <= 9 && what != 4) CHECK(found.failed);
    if (found.failed) {
      CHECK_THAT(found.failure, Catch::Contains("user routine ADRX7"));
      ++failures;
    }
  }
  CHECK(failures > 500);
}

TEST_CASE("user routines: random answers → no invalid numbers reach the solver", "[user][unit]") {
  std::mt19937_64 random(16);
  for (int k = 0; k < 1000; ++k) {
    const Asked found = ask(traction_of([&](adore_adrx7& a) -> std::int32_t {
                              if (a.n == 1) return 0;  // at rest, before the run
                              for (std::int64_t i = 0; i < a.points * a.stride; ++i) {
                                const std::uint64_t bits = random();
                                static_assert(sizeof bits == sizeof(double));
                                std::memcpy(a.kappa + i, &bits, sizeof bits);
                              }
                              if (random() % 16U == 0) throw 3;
                              return static_cast<std::int32_t>(random() % 4U);
                            }),
                            {}, 1);
    for (const double kappa : found.kappa) CHECK(kappa == 0.0);
  }
}
