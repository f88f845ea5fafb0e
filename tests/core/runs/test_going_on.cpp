#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/restart.hpp"
#include "results/results_h5.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

/// Races of runs that go on under other loads and speeds: they turn on from where they were, and
/// free ones follow what holds them.
using namespace adore;
namespace fs = std::filesystem;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

deck::Deck ball(Sets sets) {
  deck::Deck deck = deck::new_deck("ball");
  Sets all{{"nStps", "1"},       {"kPltFreq", "1"},    {"kAGraf", "0"},
           {"kLifeFreq", "0"},   {"kPrtFreq", "1000"}, {"kRaceGeoImp2", "2"},
           {"rndVar12", "2e-6"}, {"rndVar22", "3"},    {"rndVar32", "0"}};
  all.insert(all.end(), sets.begin(), sets.end());
  deck.set_all(all);
  return deck;
}

double rad_per_s(double rpm) { return rpm * std::numbers::pi / 30.0; }

double kept(const fs::path& folder, const std::string& name) {
  return results::read_final(folder / "FINAL").extras.at(name);
}

double state_of(const fs::path& folder, std::string_view name) {
  const results::FinalState state = results::read_final(folder / "FINAL");
  for (std::size_t i = 0; i < state.components.size(); ++i)
    if (state.components[i].starts_with(name)) return state.state[i];
  FAIL("no component " << name);
  return 0.0;
}

const Sets kFreeAlongAxis{{"kDCR", "1"}, {"kFD12", "0"}};

Sets with(Sets sets, const Sets& more) {
  sets.insert(sets.end(), more.begin(), more.end());
  return sets;
}

}  // namespace

TEST_CASE("continued run: other speed → race turns on from its angle",
          "[validation][continuation]") {
  const testing::TemporaryFolder folder;
  const fs::path run = folder / "run";
  const double before = testing::run_deck(ball({{"maxStps", "50"}}), run).outcome.time;
  const double turned = kept(run, "inner race turned");
  CHECK(turned == Approx(rad_per_s(10000.0) * before).epsilon(1e-14));
  const auto on = testing::run_deck(ball({{"maxStps", "80"}, {"rpm2", "20000"}}), run, true);
  const double more = rad_per_s(20000.0) * (on.outcome.time - before);
  CHECK(kept(run, "inner race turned") == Approx(turned + more).epsilon(1e-12));
  CHECK(on.outcome.revolutions ==
        Approx((turned + more) / (2.0 * std::numbers::pi)).epsilon(1e-12));
  // Step by step: nowhere does the race jump.
  const results::H5Reader file(run / "RESULTS.h5");
  const auto rotation = file.read("race.rotation"), times = file.read("time");
  for (std::size_t row = 1; row < times.size(); ++row) {
    const double speed = times[row] > before * (1.0 + 1e-12) ? 20000.0 : 10000.0;
    CHECK(rotation[2 * row + 1] - rotation[2 * row - 1] ==
          Approx(rad_per_s(speed) * (times[row] - times[row - 1])).epsilon(1e-9));
  }
  // And at the old speed again, in a run of its own files: from the turn that FINAL has.
  const double phase = std::remainder(kept(run, "inner race turned"), 2.0 * std::numbers::pi);
  const fs::path next = folder / "next";
  fs::create_directories(next);
  fs::copy_file(run / "FINAL", next / "FINAL");
  runs::RunRequest request;
  request.deck = next / "DATA.txt";
  request.overwrite = true;
  deck::write_deck(ball({{"maxStps", "20"}, {"kIcOpt", "-1"}}), request.deck);
  const runs::RunOutcome anew = runs::run(request);
  CHECK(kept(next, "inner race turned") ==
        Approx(phase + rad_per_s(10000.0) * anew.time).epsilon(1e-12));
  CHECK(anew.revolutions == Approx(10000.0 / 60.0 * anew.time).epsilon(1e-9));
}

TEST_CASE("continued run: other speed → revolutions count from its start",
          "[validation][continuation]") {
  const testing::TemporaryFolder folder;
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  const auto until = [&](const char* turns, const char* rpm) {
    deck::write_deck(ball({{"rpm2", rpm}}), request.deck);
    request.until = turns;
    return runs::run(request);
  };
  (void)until("0.02rev", "10000");
  request.go_on = true;
  const auto on = until("0.03rev", "20000");
  CHECK(on.revolutions == Approx(0.03).epsilon(1e-9));
  CHECK(on.time == Approx(0.02 / (10000.0 / 60.0) + 0.01 / (20000.0 / 60.0)).epsilon(1e-9));
  CHECK_THROWS_WITH(until("0.02rev", "20000"),
                    Catch::Contains("(0.03 revolutions)") && Catch::Contains("(0.02 revolutions)"));
}

TEST_CASE("continued run: constraints of a free race follow its deck",
          "[validation][continuation][races]") {
  const testing::TemporaryFolder folder;
  const fs::path run = folder / "run", fresh = folder / "fresh";
  const Sets changed{{"rpm2", "12000"}, {"appLoadZ", "900"}, {"maxStps", "40"}};
  (void)testing::run_deck(ball(with(kFreeAlongAxis, {{"maxStps", "30"}})), run);
  CHECK(state_of(run, "inner race.omega[1]") == Approx(rad_per_s(10000.0)).epsilon(1e-12));
  const double held = state_of(run, "inner race.position[3]");
  const double free = state_of(run, "inner race.position[1]");
  (void)testing::run_deck(ball(with(kFreeAlongAxis, changed)), run, true);
  CHECK(state_of(run, "inner race.omega[1]") == Approx(rad_per_s(12000.0)).epsilon(1e-12));
  // Held along z: where the new load puts it. Free along x: it moves to the new equilibrium.
  (void)testing::run_deck(ball(with(kFreeAlongAxis, changed)), fresh);
  const double place = state_of(fresh, "inner race.position[3]");
  CHECK(state_of(run, "inner race.position[3]") == Approx(place).margin(1e-10));
  CHECK(std::abs(place - held) > 1e-7);
  const double balanced = state_of(fresh, "inner race.position[1]");
  CHECK(std::abs(balanced - free) > 2e-6);
  CHECK(std::abs(state_of(run, "inner race.position[1]") - balanced) < 1e-6);
  CHECK(std::abs(state_of(run, "inner race.velocity[3]")) < 1e-12);
}

TEST_CASE("continued run: free race under the same deck → same bytes",
          "[validation][continuation]") {
  const testing::TemporaryFolder folder;
  const Sets sine{{"kVarSpeed", "2"}, {"raceSpeedAmp2", "500"}, {"raceSpeedFreq2", "300"}};
  for (const auto& [name, sets] :
       {std::pair{"free", with(kFreeAlongAxis, sine)}, std::pair{"prescribed", sine}}) {
    INFO(name);
    const fs::path whole = folder / name / "whole", parts = folder / name / "parts";
    (void)testing::run_deck(ball(with(sets, {{"maxStps", "40"}})), whole);
    (void)testing::run_deck(ball(with(sets, {{"maxStps", "25"}})), parts);
    (void)testing::run_deck(ball(with(sets, {{"maxStps", "40"}})), parts, true);
    CHECK(results::read_final(whole / "FINAL").state == results::read_final(parts / "FINAL").state);
  }
}

TEST_CASE("flanges: wear of their race and of the roller ends", "[physics][wear][rollers]") {
  const testing::TemporaryFolder folder;
  deck::Deck deck = deck::new_deck("tapered");
  const Sets every{{"nStps", "1"},     {"kPltFreq", "1"},    {"kAGraf", "0"},
                   {"kLifeFreq", "0"}, {"kPrtFreq", "1000"}, {"maxStps", "120"}};
  deck.set_all(every);
  const auto ran = testing::run_deck(deck, folder / "run");
  const results::H5Reader file(folder / "run" / "RESULTS.h5");
  const auto time = file.read("time"), raceway = file.read("contact.load_slip"),
             flange = file.read("flange.load_slip"), race = file.read("race.wear_rate"),
             rib = file.read("race.flange_wear_rate"),
             element = file.read("power.element1_wear_rate");
  const std::size_t steps = time.size(), n = raceway.size() / steps / 2;
  // Integrals over time: by race of all rollers, and of roller 1 alone [J].
  double ways[2] = {0.0, 0.0}, ribs[2] = {0.0, 0.0}, first[2] = {0.0, 0.0};
  for (std::size_t s = 1; s < steps; ++s)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        double way = 0.0, of_rib = 0.0;
        for (const std::size_t at : {s - 1, s}) {
          const double half = 0.5 * (time[s] - time[s - 1]);
          way += half * raceway[(at * n + i) * 2 + j];
          for (std::size_t side = 0; side < 2; ++side)
            of_rib += half * flange[((at * n + i) * 2 + j) * 2 + side];
        }
        ways[j] += way;
        ribs[j] += of_rib;
        if (i == 0) first[j] += way + of_rib;
      }
  REQUIRE(ribs[1] > 0.05 * ways[1]);  // of a wear that flanges decide
  const std::size_t last = steps - 1;
  for (const std::size_t j : {0U, 1U}) {
    INFO("race " << j << ": raceway " << ways[j] << " J, flanges " << ribs[j] << " J");
    CHECK(rib[last * 2 + j] / race[last * 2 + j] ==
          Approx(ribs[j] / (ways[j] + ribs[j])).epsilon(0.01));
  }
  // One material: element 1 wears by its own integrals as the races by theirs.
  CHECK(element[last] / race[last * 2 + 1] ==
        Approx((first[0] + first[1]) / (ways[1] + ribs[1])).epsilon(0.01));
  CHECK_THAT(ran.print, Catch::Contains("flange part"));
}

TEST_CASE("continued run: other frequency → jump of its race is reported",
          "[validation][continuation]") {
  const testing::TemporaryFolder folder;
  const fs::path run = folder / "run";
  const Sets law{
      {"kVarLoad", "2"}, {"raceVibAmp31", "0"}, {"raceVibAmp32", "2e-6"}, {"raceVibFreq2", "500"}};
  const auto warned = [](const testing::Ran& ran) {
    std::string out;
    for (const Issue& issue : ran.outcome.warnings) out += issue.message + "\n";
    return out;
  };
  testing::run_deck(ball(with(law, {{"maxStps", "50"}})), run);
  const auto same = testing::run_deck(ball(with(law, {{"maxStps", "60"}})), run, true);
  CHECK_THAT(warned(same), !Catch::Contains("race jumps"));
  Sets other = law;
  other.back().second = "700";
  const auto on = testing::run_deck(ball(with(other, {{"maxStps", "70"}})), run, true);
  CHECK_THAT(warned(on), Catch::Contains("the inner race jumps") &&
                             Catch::Contains("from its last position") &&
                             Catch::Contains("a changed frequency also changes the phase"));
}

TEST_CASE("cage start: outside its elements → rejected with the record that puts it there",
          "[unit][cage]") {
  const testing::TemporaryFolder folder;
  for (const char* place : {"cageGcPos[1]", "cageGcPos[2]"}) {
    INFO(place);
    CHECK_THROWS_WITH(testing::run_deck(ball({{place, "1"}}), folder / "run"),
                      Catch::Contains("cageGcPos"));
    CHECK_THROWS_AS(testing::run_deck(ball({{place, "1"}}), folder / "run"), InputError);
  }
}
