#include "core/runs/user_runs.hpp"
#include "runs/check.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

/// Whole runs with routines of the user: examples of `adore user new`, formulas, callbacks.
using namespace adore;
using namespace adore::user_runs;

TEST_CASE("user routine equal to the built-in traction → same motion", "[user][physics]") {
  const std::string until = "2e-4s";
  // Elastic: with damped contacts the last bit grows to 1e-15 m and 1.3e-10 m/s of single balls.
  const auto elastic = [&](const char* name, const std::string& deck) {
    auto out = request_of(name, deck, until);
    out.options.emplace_back("contactDamping", "0");
    // One start for both: statics do not call ADRX7.
    out.options.emplace_back("ballFriction", "spin-rule");
    return out;
  };
  const Ran built_in = ran_with(elastic("built-in", deck_with({}, "")));
  auto request = elastic("adrx7-c", deck_with({{"kTrac", "-1"}}, own_curve()));
  request.user = library("adrx7");
  const Ran in_c = ran_with(request);
  REQUIRE(in_c.outcome.status == runs::RunStatus::Done);
  CHECK(in_c.outcome.evaluations == built_in.outcome.evaluations);
  // Two functions exp differ in the last bit, and so do sums that a compiler contracts in one
  // kernel and not in the other.
  check_same_to_rounding(built_in, in_c);

  auto formula = elastic("adrx7-formula", deck_with({{"kTrac", "-1"}}, own_curve()));
  formula.user = json_file("adrx7", R"~({"version": "f1", "adrx7": {"read": ["A", "B", "C", "D"],
      "element_race": {"formula": "(A+B*u)*exp(-C*u)+D", "slip_scale": "1/C"}}})~");
  check_same_to_rounding(built_in, ran_with(formula));

  auto alone = request_of("adrx7-alone", deck_with({{"kTrac", "-1"}}, own_curve()), "2e-5s");
  alone.user = library("adrx7");
  const Ran here = ran_with(alone);
  alone.out = fresh_folder("adrx7-process");
  alone.options.emplace_back("userProcess", "1");
  CHECK(difference(here, ran_with(alone)) == 0.0);
}

TEST_CASE("ADRX1: accelerated inner race → speed and rotation of the closed form",
          "[user][physics]") {
  const std::string lines = "1e-4 4e-4 10000 10300\n0 0\n";
  auto request = request_of("accelerate", deck_with({}, lines), "5e-4s");
  request.user = library("adrx1");
  const Ran ran = ran_with(request);
  REQUIRE(ran.outcome.status == runs::RunStatus::Done);
  const double first = 10000.0 * std::numbers::pi / 30.0, last = 10300.0 * std::numbers::pi / 30.0;
  // The method takes the jumps at t1 and t2 with its tolerance of 1e-6 a step (7e-6 measured).
  CHECK(ran.last.at("inner race.omega[1] [rad/s]") == Approx(last).epsilon(2e-5));
  const double turn = first * 1e-4 + 0.5 * (first + last) * 3e-4 + last * 1e-4;
  CHECK(ran.last.at("inner race.rotation [rad]") == Approx(turn).epsilon(4e-5));
  for (const Issue& remark : ran.outcome.warnings) CHECK(remark.record != "12");
  for (const Issue& remark : runs::check(request).issues) CHECK(remark.record != "12");
  request.user.clear();  // nobody reads the lines
  const auto& unread = runs::prepare(request).input.warnings;
  CHECK(std::any_of(unread.begin(), unread.end(),
                    [](const Issue& remark) { return remark.record == "12"; }));

  // Without jumps to rounding.
  auto even = request_of("even", deck_with({}, "0 1 10000 1010000\n0 0\n"), "2e-4s");
  even.user = library("adrx1");
  const Ran evenly = ran_with(even);
  const double a = 1e6 * std::numbers::pi / 30.0, end = 2e-4;
  CHECK(evenly.last.at("inner race.omega[1] [rad/s]") == Approx(first + a * end).epsilon(1e-11));
  CHECK(evenly.last.at("inner race.rotation [rad]") ==
        Approx(first * end + 0.5 * a * end * end).epsilon(1e-11));
  CHECK_THAT(text_of(ran.folder / "PRINT.txt"), Catch::Contains("ADRX1: inner race from 10000"));
  CHECK_THAT(text_of(ran.folder / "PRINT.txt"), Catch::Contains("Adore 0.9.0+motion"));

  auto formula = request_of("accelerate-formula", deck_with({}, lines), "5e-4s");
  formula.user = json_file("adrx1", R"~({"adrx1": {
      "read": ["t1", "t2", "rpm1", "rpm2", "A", "f"],
      "inner_race": {"angular_acceleration":
                     "t >= t1 && t < t2 ? (rpm2-rpm1)*pi/30/(t2-t1) : 0"},
      "kinks": ["t1", "t2"]}})~");
  const Ran by_formula = ran_with(formula);
  CHECK(difference(ran, by_formula) < 1e-9);
  CHECK_THAT(text_of(by_formula.folder / "RUN.json"),
             Catch::Contains("routine ADRX1 specifies jumps of loads or speeds") &&
                 Catch::Contains("the loads jump at t = 0.0001 s"));
}

TEST_CASE("ADRX1: shaken housing → moves as A sin wt", "[user][physics]") {
  const double A = 2e-6, f = 2000.0, end = 6e-4;
  auto request = request_of("shake", deck_with({}, fmt::format("0 0 0 0\n{} {}\n", A, f)),
                            fmt::format("{}s", end));
  request.user = library("adrx1");
  const Ran ran = ran_with(request);
  REQUIRE(ran.outcome.status == runs::RunStatus::Done);
  const double w = 2.0 * std::numbers::pi * f;
  CHECK(ran.last.at("outer race.position[3] [m]") ==
        Approx(A * std::sin(w * end)).margin(1e-6 * A));
  CHECK(ran.last.at("outer race.velocity[3] [m/s]") ==
        Approx(A * w * std::cos(w * end)).epsilon(1e-6));
  CHECK(std::abs(ran.outcome.energy_residual) < 1e-3 * ran.outcome.energy_scale);
}

TEST_CASE("ADRX1: accelerated base frame → opposite gravity field", "[user][physics]") {
  const std::string until = "2e-4s";
  for (const char* type : {"ball", "cylindrical"}) {
    CAPTURE(type);
    const Ran weights = ran_with(request_of(
        "gravity",
        deck_of(type, {{"gravityVecX", "0"}, {"gravityVecY", "300"}, {"gravityVecZ", "-1000"}}, ""),
        until));
    const Sets none{{"gravityVecX", "0"}, {"gravityVecY", "0"}, {"gravityVecZ", "0"}};
    auto request = request_of("frame", deck_of(type, none, ""), until);
    request.user =
        json_file("frame", R"~({"adrx1": {"frame_acceleration": ["0", "-300", "1000"]}})~");
    const Ran moved = ran_with(request);
    REQUIRE(moved.outcome.status == runs::RunStatus::Done);
    const Ran still = ran_with(request_of("still", deck_of(type, none, ""), until));
    // Accumulated in other components of the state, the same motion to rounding.
    double worst = 0.0, acts = 0.0;
    for (const auto& [name, value] : weights.last) {
      if (name.find("position") == std::string::npos) continue;
      worst = std::max(worst, std::abs(value - moved.last.at(name)));
      acts = std::max(acts, std::abs(value - still.last.at(name)));
    }
    CHECK(acts > 1e-8);
    CHECK(worst < 1e-6 * acts);
    CHECK(
        std::abs(moved.outcome.energy_residual) <
        std::max(1e-6 * moved.outcome.energy_scale, 3.0 * std::abs(still.outcome.energy_residual)));
  }
}

TEST_CASE("ADRX1: accelerated base frame → record 9.5 on an infinite orbit", "[user][physics]") {
  // a = R w^2 towards the axis of the orbit. What is left of the turning is Coriolis: 2 w v on a
  // body whose v = a t makes it a w t^2, which is w t of a t.
  const double a = 1000.0, angle = 0.5;
  const std::string until = "2e-4s";
  const Sets still{{"gravityVecX", "0"}, {"gravityVecY", "0"}, {"gravityVecZ", "0"}};
  auto request = request_of("uniform", deck_of("ball", still, ""), until);
  request.user = json_file(
      "uniform",
      fmt::format(R"~({{"adrx1": {{"frame_acceleration": ["0", "{:.17g}", "{:.17g}"]}}}})~",
                  a * std::sin(angle), -a * std::cos(angle)));
  const Ran uniform = ran_with(request);
  const Ran at_rest = ran_with(request_of("at-rest", deck_of("ball", still, ""), until));
  const auto between = [](const Ran& one, const Ran& other) {
    double out = 0.0;
    for (const auto& [name, value] : one.last)
      if (name.find("velocity") != std::string::npos && name.find("angular") == std::string::npos)
        out = std::max(out, std::abs(value - other.last.at(name)));
    return out;
  };
  const double acts = between(uniform, at_rest);
  CHECK(acts == Approx(a * 2e-4).epsilon(0.5));
  for (const double R : {1e4, 1e8, 1e12}) {
    const double w = std::sqrt(a / R);
    Sets sets = still;
    sets.insert(sets.end(),
                {{"kRotFrame", "1"},
                 {"brgOrbitRad", fmt::format("{:.17g}", R)},
                 {"brgAngPos", fmt::format("{:.17g}", angle * 180.0 / std::numbers::pi)},
                 {"brgAngVel", fmt::format("{:.17g}", w * 30.0 / std::numbers::pi)},
                 {"brgLoadFrac1", "0"},
                 {"brgLoadFrac2", "0"}});
    const Ran turning = ran_with(request_of("orbit", deck_of("ball", sets, ""), until));
    REQUIRE(turning.outcome.status == runs::RunStatus::Done);
    CAPTURE(R);
    CHECK(between(uniform, turning) / acts == Approx(w * 2e-4).epsilon(0.01).margin(1e-9));
  }
}

TEST_CASE("ADRX9: heat map adds up to the heat of the ledger", "[user][physics]") {
  auto request = request_of("heat", deck_with({}, ""), "2e-4s");
  double worst = 0.0, before = 0.0, at = 0.0, sum = 0.0;
  int steps = 0;
  auto watch = std::make_shared<user::PlugIn>();
  watch->source = "the test";
  watch->hooks[9] = [&](adore_call& call) {
    call.active = 1;
    if (call.mode != ADORE_STEP) return 0;
    const auto& a = reinterpret_cast<adore_adrx9&>(call);
    double heat = 0.0;
    for (std::int64_t k = 0; k < a.sources; ++k) heat += a.source_heat[k];
    worst = std::max(worst, std::abs(heat / a.total_heat - 1.0));
    if (steps++ > 0) sum += 0.5 * (heat + before) * (call.time - at);
    before = heat;
    at = call.time;
    return 0;
  };
  request.routines = watch;
  const Ran ran = ran_with(request);
  REQUIRE(ran.outcome.status == runs::RunStatus::Done);
  CHECK(steps > 20);
  CHECK(worst < 1e-12);
  // Over time as the ledger has it; the trapezoidal rule leaves 2e-3 of it.
  double heat = 0.0;
  const auto report = nlohmann::json::parse(text_of(ran.folder / "RUN.json"));
  for (const auto& [name, value] : report.at("conservation").at("energy").items())
    if (name.starts_with("heat, ")) heat += value.get<double>();
  CHECK(sum == Approx(heat).epsilon(0.01));

  auto in_c = request_of("heat-c", deck_with({}, ""), "2e-5s");
  in_c.user = library("adrx9");
  const std::string first = text_of(ran_with(in_c).folder / "SOL9");
  CHECK_THAT(first, Catch::StartsWith("  Adore0.9.0+heat map 1  SOL9"));
  auto formula = request_of("heat-json", deck_with({}, ""), "2e-5s");
  formula.user = json_file("adrx9", R"~({"version": "heat map 1", "adrx9": {"heat_map": true}})~");
  const std::string second = text_of(ran_with(formula).folder / "SOL9");
  CHECK(first.substr(first.find('\n')) == second.substr(second.find('\n')));
}

TEST_CASE("ADRX9: both contacts of a ball on a split race are at their places and add up",
          "[user][physics]") {
  auto request = request_of(
      "split-heat",
      deck_of("four-point-qj208", {{"rpm2", "3000"}, {"appLoadX", "0"}, {"appLoadZ", "2000"}}, ""),
      "");
  request.until = "0.02rev";
  auto watch = std::make_shared<user::PlugIn>();
  watch->source = "the test";
  double total = 0.0, heat = 0.0, at_races = 0.0, elsewhere = 0.0;
  std::array<int, 2> of_ball{};
  watch->hooks[9] = [&](adore_call& call) {
    call.active = 1;
    if (call.mode != ADORE_STEP) return 0;
    const auto& a = reinterpret_cast<adore_adrx9&>(call);
    total = a.total_heat;
    heat = at_races = elsewhere = 0.0;
    of_ball = {};
    for (std::int64_t k = 0; k < a.sources; ++k) {
      heat += a.source_heat[k];
      const bool race = a.source_kind[k] == ADORE_ELEMENT_RACE;
      if (race) at_races += a.source_heat[k];
      if (!race && a.source_race[k] >= 0 && a.source_element[k] < 0) elsewhere += a.source_heat[k];
      if (!race || a.source_element[k] != 0) continue;
      const double side = a.source_place[3 * k] - a.x[0];
      ++of_ball[side > 0.0 ? 1 : 0];
      const double radius = std::hypot(a.source_place[3 * k + 1], a.source_place[3 * k + 2]);
      CHECK(std::hypot(side, radius - a.r[0]) == Approx(0.5 * 0.0127).epsilon(1e-3));
    }
    return 0;
  };
  request.routines = watch;
  REQUIRE(ran_with(request).outcome.status == runs::RunStatus::Done);
  CHECK(heat == Approx(total).epsilon(1e-12));
  CHECK(std::abs(elsewhere) < 1e-9 * total);  // nothing of a race is left without a place
  CHECK(at_races > 0.5 * total);
  CHECK(of_ball[0] >= 1);
  CHECK(of_ball[1] >= 1);
  CHECK(of_ball[0] + of_ball[1] >= 3);
}

TEST_CASE("user routines: deck without plug-in → rejected, with instructions", "[user][unit]") {
  for (const auto& [variable, code, routine] : {std::tuple{"kTrac", "-1", "ADRX7"},
                                                {"kCPTrac", "-1", "ADRX7"},
                                                {"kCRTrac", "-1", "ADRX7"},
                                                {"kDOF", "6", "ADRX1"},
                                                {"kReMat", "2", "ADRX0"},
                                                {"kRaceGeoImp1", "3", "ADRX6"},
                                                {"kReGeoImp", "3", "ADRX8"}}) {
    runs::DeckRequest request;
    request.text = deck_with({{variable, code}}, "");
    CHECK_THROWS_WITH(runs::prepare(request),
                      Catch::Contains(routine) && Catch::Contains("--user PLUG-IN"));
  }
}

TEST_CASE("user routines: NaN → run ends with its name, files stay valid", "[user][unit]") {
  auto bad = std::make_shared<user::PlugIn>();
  bad->source = "the test";
  bad->hooks[7] = [](adore_call& call) {
    call.active = 1;
    if (call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_adrx7&>(call);
    for (std::int64_t k = 0; k < a.points * a.stride; ++k)
      a.kappa[k] = call.time > 5e-5 ? std::nan("") : 0.05;
    return 0;
  };
  auto request = request_of("nan", deck_with({{"kTrac", "-1"}}, ""), "2e-4s");
  request.routines = bad;
  const Ran ran = ran_with(request);
  CHECK(ran.outcome.status == runs::RunStatus::Failed);
  CHECK_THAT(ran.outcome.message, Catch::Contains("user routine ADRX7 of the test, call") &&
                                      Catch::Contains("nan") && Catch::Contains("files are valid"));
  CHECK_THAT(text_of(ran.folder / "RUN.json"), Catch::Contains("\"failed\""));
}

TEST_CASE("user routines: failure before the first step → named", "[user][unit]") {
  for (long after : {3L, 5L, 9L}) {
    auto bad = std::make_shared<user::PlugIn>();
    bad->source = "the test";
    long calls = 0;
    bad->hooks[7] = [&calls, after](adore_call& call) {
      call.active = 1;
      if (call.mode != ADORE_COMPUTE) return 0;
      auto& a = reinterpret_cast<adore_adrx7&>(call);
      const double kappa = ++calls < after ? 0.05 : std::nan("");
      for (std::int64_t k = 0; k < a.points * a.stride; ++k) a.kappa[k] = kappa;
      return 0;
    };
    auto request = request_of("early", deck_with({{"kTrac", "-1"}}, ""), "2e-6s");
    request.routines = bad;
    std::string message;
    try {
      message = ran_with(request).outcome.message;
    } catch (const SolverError& error) {
      message = error.what();
    }
    CHECK_THAT(message,
               Catch::Contains("user routine ADRX7 of the test") && Catch::Contains("nan"));
  }
}

TEST_CASE("user routines: every state rejected from some call on → run ends with its name",
          "[user][unit]") {
  auto bad = std::make_shared<user::PlugIn>();
  bad->source = "the test";
  long calls = 0;
  bad->hooks[7] = [&calls](adore_call& call) {
    call.active = 1;
    if (call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_adrx7&>(call);
    for (std::int64_t k = 0; k < a.points * a.stride; ++k) a.kappa[k] = 0.05;
    return ++calls < 455 ? 0 : 1;
  };
  auto request = request_of("refuses", deck_with({{"kTrac", "-1"}}, ""), "2e-4s");
  request.routines = bad;
  const Ran ran = ran_with(request);
  CHECK(ran.outcome.status == runs::RunStatus::Failed);
  CHECK_THAT(ran.outcome.message, Catch::Contains("user routine ADRX7 of the test"));
  CHECK_FALSE(ran.last.empty());  // FINAL
  CHECK_THAT(text_of(ran.folder / "RUN.json"), Catch::Contains("\"failed\""));
}

TEST_CASE("user routines: materials, imperfections and pockets are used", "[user][physics]") {
  runs::DeckRequest request;
  request.text = deck_with({{"kReMat", "2"}, {"kReGeoImp", "3"}}, "");
  request.user = json_file("adrx08", R"~({"adrx0": {"element": {"density": 3200,
      "elastic_modulus": 310e9, "poisson_ratio": 0.27}},
      "adrx8": {"diameter": "1e-7*i"}})~");
  const runs::Prepared prepared = runs::prepare(request);
  CHECK(prepared.as_built.element_material.density == 3200.0);
  CHECK(prepared.as_built.element_inertia.mass ==
        Approx(3200.0 * std::numbers::pi / 6.0 * std::pow(0.0127, 3)));
  CHECK(prepared.as_built.imperfections.ball_diameter.at(3) == Approx(3e-7));

  // A fast cage meets its balls soon.
  const Sets kFastCage{{"avRatio", "1.2"}};
  // The built-in force of a pocket, restated, changes nothing; a stiffer one does.
  const std::string until = "2e-4s";
  const Ran built_in = ran_with(request_of("pocket", deck_with(kFastCage, ""), until));
  auto same = request_of("pocket-same", deck_with(kFastCage, ""), until);
  same.user = json_file("adrx3", R"~({"adrx3": {"force": "built_in"}})~");
  CHECK(difference(built_in, ran_with(same)) == 0.0);
  auto stiff = request_of("pocket-stiff", deck_with(kFastCage, ""), until);
  stiff.user = json_file("adrx3b", R"~({"adrx3": {"force": "1.5*built_in"}})~");
  const Ran other = ran_with(stiff);
  CHECK(difference(built_in, other) > 1e-9);
  CHECK(std::abs(other.outcome.energy_residual) < 1e-3 * other.outcome.energy_scale);
}

TEST_CASE(
    "user routines: force laws of flanges, pockets and lands; equal laws change nothing, others "
    "act",
    "[user][physics]") {
  struct Case {
    const char* name;
    int hook;
    const char* type;
    Sets sets;
    double power;  ///< n of N = K overlap^n; 0: not a power
    const char* until;
  };
  const Sets fast_cage{{"avRatio", "1.2"}}, none;
  for (const Case& c :
       {Case{"flange", 2, "tapered", none, 1.5, "1e-4s"},
        Case{"roller pocket", 3, "cylindrical", fast_cage, 0.0, "2e-4s"},
        Case{"tapered pocket", 3, "tapered", fast_cage, 0.0, "2e-4s"},
        Case{"land", 4, "cylindrical", {{"cageGsCls[1]", "1.0e-08"}}, 0.0, "2e-4s"}}) {
    CAPTURE(c.name);
    const auto with = [&](const Force& law) {
      auto request = request_of("force", deck_of(c.type, c.sets, ""), c.until);
      if (law) request.routines = force_law(c.hook, law);
      return ran_with(request);
    };
    const Ran built_in = with(nullptr);
    REQUIRE(built_in.outcome.status == runs::RunStatus::Done);
    CHECK(difference(built_in, with([](const adore_force& a, std::int64_t k) {
                       return a.built_in[k];
                     })) == 0.0);
    std::int64_t asked = 0;
    double least = 1e300, most = 0.0;
    const Ran counted = with([&](const adore_force& a, std::int64_t k) {
      ++asked;
      const double K = a.built_in[k] / std::pow(-a.gap[k], c.power);
      least = std::min(least, K);
      most = std::max(most, K);
      return a.built_in[k];
    });
    CHECK(asked > 100);
    if (c.power > 0.0) {
      // The same law in other words: one constant, and the same motion to rounding.
      CHECK(most / least - 1.0 < 1e-12);
      const Ran restated = with([&](const adore_force& a, std::int64_t k) {
        return most * std::pow(-a.gap[k], c.power);
      });
      // pow and d sqrt(d) differ in the last bit.
      check_same_to_rounding(built_in, restated);
    }
    // Stiffer, and damped by the rate: both move otherwise, and the ledger closes.
    const Ran stiff =
        with([](const adore_force& a, std::int64_t k) { return 1.5 * a.built_in[k]; });
    const Ran damped = with([](const adore_force& a, std::int64_t k) {
      return std::max(0.0, a.built_in[k] * (1.0 - 5.0 * a.gap_rate[k]));
    });
    for (const Ran* ran : {&stiff, &damped}) {
      REQUIRE(ran->outcome.status == runs::RunStatus::Done);
      CHECK(difference(built_in, *ran) > 1e-9);
      CHECK(std::abs(ran->outcome.energy_residual) <
            std::max(1e-5 * ran->outcome.energy_scale,
                     3.0 * std::abs(built_in.outcome.energy_residual)));
    }
  }
}

TEST_CASE("user routines: normal force → damping acts in addition, and the energy closes",
          "[user][physics][damping]") {
  struct Case {
    const char* name;
    int hook;
    const char* type;
    Sets sets;
    const char* until;
  };
  // Steps are judged by an energy whose items differ; blows want the same steps.
  const Sets fast_cage{
      {"avRatio", "1.2"}, {"stpInit", "0.05"}, {"stpMin", "0.05"}, {"stpMax", "0.05"}},
      none;
  const double alpha = 0.3;
  for (const Case& c : {Case{"flange", 2, "tapered", none, "1e-4s"},
                        Case{"roller pocket", 3, "cylindrical", fast_cage, "2e-4s"},
                        Case{"land", 4, "cylindrical", {{"cageGsCls[1]", "1.0e-08"}}, "2e-4s"}}) {
    CAPTURE(c.name);
    const auto with = [&](const Force& law) {
      auto request = request_of("damped-force", deck_of(c.type, c.sets, ""), c.until);
      request.options.emplace_back("contactDamping", fmt::format("{}", alpha));
      if (law) request.routines = force_law(c.hook, law);
      const Ran ran = ran_with(request);
      REQUIRE(ran.outcome.status == runs::RunStatus::Done);
      return ran;
    };
    const Ran damped = with(nullptr);
    std::int64_t asked = 0;
    // The routine is handed the elastic force; one that gives it back changes nothing.
    const Ran restated = with([&](const adore_force& a, std::int64_t k) {
      ++asked;
      return a.built_in[k];
    });
    CHECK(asked > 100);
    check_same_to_rounding(damped, restated);
    const Ran stiffer =
        with([](const adore_force& a, std::int64_t k) { return 1.5 * a.built_in[k]; });
    CHECK(difference(damped, stiffer) > 1e-12);
    for (const Ran* ran : {&damped, &restated, &stiffer})
      CHECK(std::abs(ran->outcome.energy_residual) < 1e-5 * ran->outcome.energy_scale);
  }
}

TEST_CASE("user routines: force laws without a contact → reported", "[user][unit]") {
  const auto says = [](int hook, const std::string& type, const Sets& sets) {
    runs::DeckRequest request;
    request.text = deck_of(type, sets, "");
    request.routines =
        force_law(hook, [](const adore_force& a, std::int64_t k) { return a.built_in[k]; });
    std::string out;
    for (const Issue& issue : runs::prepare(request).input.warnings) out += issue.text() + "\n";
    return out;
  };
  CHECK_THAT(says(2, "ball", {}), Catch::Contains("ADRX2") && Catch::Contains("no flanges"));
  CHECK_THAT(says(3, "ball", {{"mode", "-1"}}),
             Catch::Contains("ADRX3 of the test is active but has no effect here"));
  CHECK_THROWS_WITH(
      says(4, "ball", {{"kCageGsImp", "2"}, {"nGL", "1"}, {"cageGsRadVar1[1]", "1e-6"}}),
      Catch::Contains("ADRX4") && Catch::Contains("needs a single gap") &&
          Catch::Contains("kCageGsImp = 2"));
  CHECK_THROWS_WITH(says(4, "ball", {{"kRaceGsImp", "1"}, {"raceGsRadVar1[1]", "1e-6"}}),
                    Catch::Contains("kRaceGsImp = 1") && Catch::Contains("needs a single gap"));
  const std::pair<const char*, const char*> holds[] = {{"kVarLoad", "1"}, {"kVarSpeed", "1"}};
  for (const auto& [variable, code] : holds) {
    runs::DeckRequest request;
    request.text = deck_of("ball", {{variable, code}}, "");
    request.user = json_file("drives", R"~({"adrx1": {"inner_race": {
        "angular_acceleration": "1"}}})~");
    CHECK_THROWS_WITH(runs::prepare(request),
                      Catch::Contains(fmt::format("{} = {}", variable, code)) &&
                          Catch::Contains("ADRX1") && Catch::Contains("drives"));
  }
}

TEST_CASE("ADRX6: races of the routine equal those of decks", "[user][physics]") {
  struct Case {
    const char *name, *type, *until;
    Sets deck;
    const char* routine;
  };
  const Case kCases[] = {
      {"waves of the inner race of balls",
       "ball",
       "2e-4s",
       {{"kRaceGeoImp2", "2"},
        {"rndVar12", "1e-6"},
        {"rndVar22", "9"},
        {"rndVar32", "0.3"},
        {"cFacVar12", "0.002"},
        {"cFacVar22", "2"},
        {"cFacVar32", "0.1"}},
       R"~("inner_race": {"radius": "1e-6*sin(9*psi+0.3*pi/180)",
                          "curvature_factor": "0.002*sin(2*psi+0.1*pi/180)"})~"},
      {"taper of the outer race of rollers",
       "cylindrical",
       "1e-4s",
       {{"kRaceGeoImp1", "2"},
        {"rndVar11", "1e-6"},
        {"rndVar21", "3"},
        {"rndVar31", "0"},
        {"rlTaper11", "1e-5"},
        {"rlTaper21", "2"},
        {"rlTaper31", "0"}},
       R"~("outer_race": {"radius": "1e-6*sin(3*psi)+x*tan(1e-5*sin(2*psi))"})~"},
  };
  for (const Case& c : kCases) {
    CAPTURE(c.name);
    const auto folder = [&](const char* which) { return std::string("adrx6-") + which; };
    const Ran of_deck = ran_with(request_of(folder("deck"), deck_of(c.type, c.deck, ""), c.until));
    REQUIRE(of_deck.outcome.status == runs::RunStatus::Done);
    const Sets ask{{c.deck.front().first, "3"}};
    auto request = request_of(folder("user"), deck_of(c.type, ask, ""), c.until);
    request.user = json_file("adrx6", std::string(R"~({"adrx6": {)~") + c.routine + "}}");
    const Ran of_user = ran_with(request);
    REQUIRE(of_user.outcome.status == runs::RunStatus::Done);
    // Balls: constants of the groove are polynomials over the range of its factor, which the
    // routine tells at 1024 places (6.5e-7 measured). Rollers: the taper comes from differences
    // (1.3e-9).
    CHECK(difference(of_deck, of_user) < (std::string(c.type) == "ball" ? 2e-6 : 1e-8));
    const Ran round = ran_with(request_of(folder("round"), deck_of(c.type, {}, ""), c.until));
    CHECK(difference(of_deck, round) > 1e-6);
    CHECK(std::abs(of_user.outcome.energy_residual) < 1e-3 * of_user.outcome.energy_scale);
    CHECK_THAT(text_of(of_user.folder / "PRINT.txt"),
               Catch::Contains("ADRX6: ") && Catch::Contains("waves per revolution"));

    // The equilibrium has them, too.
    const auto forces = [&](Sets sets, bool user) {
      sets.emplace_back("mode", "-1");
      runs::DeckRequest still;
      still.text = deck_of(c.type, sets, "");
      if (user) still.user = request.user;
      const runs::Prepared prepared = runs::prepare(still);
      std::vector<double> out;
      if (prepared.rollers)
        for (const auto& roller : prepared.rollers->rollers) out.push_back(roller.race[0].load);
      else
        for (const auto& ball : prepared.statics.balls) out.push_back(ball.Q[0]);
      return out;
    };
    const std::vector<double> a = forces(c.deck, false), b = forces(ask, true),
                              ideal = forces({}, false);
    REQUIRE(a.size() == b.size());
    double worst = 0.0, size = 0.0, acts = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      worst = std::max(worst, std::abs(a[k] - b[k]));
      acts = std::max(acts, std::abs(a[k] - ideal[k]));
      size = std::max(size, std::abs(a[k]));
    }
    CHECK(worst < 1e-9 * size);
    CHECK(acts > 1e-3 * size);
  }
}

TEST_CASE("ADRX5: crown of the routine equals the crown of the deck", "[user][physics]") {
  // Record 5B.1: a straight land of 8 mm, then circles of 2 m. The crown that the routine gives
  // takes nothing off the mass, so both have that of record 6.1.
  const std::string until = "1e-4s";
  const Sets mass{{"kReIP", "2"},
                  {"bReMass", "9e-3"},
                  {"bReMIx", "1.4e-7"},
                  {"bReMIy", "1.8e-7"},
                  {"bReMIz", "1.8e-7"}};
  const Ran crowned = ran_with(request_of("adrx5-deck", deck_of("cylindrical", mass, ""), until));
  Sets straight = mass;
  straight.emplace_back("bReCrn", "1e10");
  auto request = request_of("adrx5-user", deck_of("cylindrical", straight, ""), until);
  request.user = json_file("adrx5", R"~({"adrx5": {"constants": {"R": "2"},
      "radius": "abs(x) > 0.004 ? -((abs(x)-0.004)^2/(R+sqrt(R^2-(abs(x)-0.004)^2))) : 0"}})~");
  const Ran of_user = ran_with(request);
  REQUIRE(of_user.outcome.status == runs::RunStatus::Done);
  CHECK(difference(crowned, of_user) < 1e-8);  // 1.3e-9 measured
  const Ran plain =
      ran_with(request_of("adrx5-plain", deck_of("cylindrical", straight, ""), until));
  CHECK(difference(crowned, plain) > 1e-6);

  // Nothing more changes not a byte; larger balls are those of the deck's list.
  auto nothing = request_of("adrx5-zero", deck_of("cylindrical", mass, ""), until);
  nothing.user = json_file("adrx5-zero", R"~({"adrx5": {"radius": "0*x"}})~");
  CHECK(difference(crowned, ran_with(nothing)) == 0.0);
  Sets listed{{"kReGeoImp", "2"}};
  for (int k = 0; k < 16; ++k)
    listed.emplace_back(fmt::format("reDiaVar{}", k + 1), fmt::format("{}", k == 0 ? 1e-6 : 0.0));
  const Ran in_deck = ran_with(request_of("adrx5-listed", deck_with(listed, ""), until));
  auto balls = request_of("adrx5-balls", deck_with({}, ""), until);
  balls.user = json_file("adrx5-balls", R"~({"adrx5": {"radius": "i == 0 ? 5e-7 : 0"}})~");
  CHECK(difference(in_deck, ran_with(balls)) == 0.0);
}

TEST_CASE("user surfaces: not supported → rejected with the reason", "[user][unit]") {
  const auto says = [](const std::string& type, const Sets& sets, const std::string& json) {
    runs::DeckRequest request;
    request.text = deck_of(type, sets, "");
    request.user = json_file("surface", json);
    std::string out;
    for (const Issue& issue : runs::prepare(request).input.warnings) out += issue.text() + "\n";
    return out;
  };
  CHECK_THROWS_WITH(says("cylindrical", {}, R"~({"adrx5": {"radius": "1e-2*x^2*sin(psi)"}})~"),
                    Catch::Contains("ADRX5") && Catch::Contains("f(x) + c(psi) + x t(psi)"));
  CHECK_THROWS_WITH(says("spherical", {}, R"~({"adrx5": {"radius": "1e-3*x*sin(psi)"}})~"),
                    Catch::Contains("ADRX5") && Catch::Contains("azimuth only"));
  CHECK_THAT(says("cylindrical", {{"mode", "-1"}}, R"~({"adrx5": {"radius": "1e-6*sin(psi)"}})~"),
             Catch::Contains("the equilibrium uses the mean radius"));
  CHECK_THAT(says("ball", {{"mode", "-1"}}, R"~({"adrx5": {"radius": "1e-6*cos(2*psi)"}})~"),
             Catch::Contains("gives out-of-round balls"));
  CHECK_THROWS_WITH(says("ball", {}, R"~({"adrx5": {"radius": "psi > 1 ? 1e-6 : 0"}})~"),
                    Catch::Contains("ADRX5") && Catch::Contains("has steps"));
  CHECK_THROWS_WITH(says("ball", {}, R"~({"adrx5": {"radius": "0.05*x"}})~"),
                    Catch::Contains("ADRX5") && Catch::Contains("at most 1 %"));
  CHECK_THROWS_WITH(says("ball", {{"kRaceGeoImp1", "3"}},
                         R"~({"adrx6": {"outer_race": {"curvature_factor": "-0.1*sin(psi)^2"}}})~"),
                    Catch::Contains("kRaceGeoImp1") && Catch::Contains("do not fit"));
  CHECK_THROWS_WITH(says("cylindrical", {{"kRaceGeoImp2", "3"}},
                         R"~({"adrx6": {"inner_race": {"curvature_factor": "0.01"}}})~"),
                    Catch::Contains("ADRX6") && Catch::Contains("no groove factor"));
  {
    runs::DeckRequest request;
    request.text = deck_of("spherical", {{"mode", "-1"}}, "");
    request.options = {{"rollerContact", "point"}};
    request.user = json_file("barrel", R"~({"adrx5": {"radius": "1e-4*x"}})~");
    CHECK_THROWS_WITH(runs::prepare(request),
                      Catch::Contains("ADRX5") && Catch::Contains("rollerContact=point"));
  }
  CHECK_THAT(says("ball", {}, R"~({"adrx6": {"inner_race": {"radius": "0"}}})~"),
             Catch::Contains("ADRX6") && Catch::Contains("kRaceGeoImp1"));
}
