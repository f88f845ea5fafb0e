#include "results/mean_load.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace adore;
using namespace adore::results;

namespace {

scene::Snapshot at(double time, double force_x) {
  scene::Snapshot out;
  out.time = time;
  out.races[1].carried_force = {force_x, 0.0, 100.0};
  return out;
}

}  // namespace

TEST_CASE("Mean load: time mean of the reaction on the inner race", "[unit][results]") {
  RunAverages averages;
  averages.add(at(0.0, 100.0));
  CHECK(averages.averages().load[0] == 100.0);
  averages.add(at(1.0, 200.0));
  averages.add(at(4.0, 200.0));
  CHECK(averages.averages().load[0] == Approx((150.0 + 600.0) / 4.0));
  std::map<std::string, double> kept;
  averages.save(kept);
  RunAverages again;
  again.restore(kept);
  again.add(at(5.0, 100.0));
  averages.add(at(5.0, 100.0));
  CHECK(again.averages().load == averages.averages().load);
}

TEST_CASE("Mean of the largest load: over all steps, stored or not", "[unit][results]") {
  const auto largest = [](double t) { return 1000.0 + 500.0 * std::sin(40.0 * t); };
  const auto stored = [&](double t) {
    scene::Snapshot out = at(t, 0.0);
    out.elements.resize(2);
    out.elements[1].race[1].load = largest(t);
    return out;
  };
  const auto run = [&](int every, int steps, RunAverages averages) {
    for (int k = 0; k <= steps; ++k) {
      const double t = k / 1000.0;
      const std::array outer{10.0, 20.0}, inner{30.0, largest(t)};
      averages.add_loads(t, outer, inner);
      if (k % every == 0) averages.add(stored(t));
    }
    return averages;
  };
  const Averages all = run(1, 1000, {}).averages(), few = run(500, 1000, {}).averages();
  CHECK(all.largest_load == Approx(1000.0 + 500.0 * (1.0 - std::cos(40.0)) / 40.0).epsilon(1e-3));
  CHECK(all.peak_load == Approx(1500.0).epsilon(1e-3));
  CHECK(few.largest_load == all.largest_load);
  CHECK(few.peak_load == all.peak_load);

  // A run that goes on from before its last look counts the time between once.
  std::map<std::string, double> kept;
  run(500, 700, {}).save(kept);
  RunAverages again;
  again.restore(kept);
  const Averages twice = run(500, 1000, again).averages();
  CHECK(twice.largest_load == Approx(all.largest_load));

  // What ran before loads were looked at between stored steps went to the stored one.
  kept.erase("average largest time");
  again.restore(kept);
  CHECK(run(500, 1000, again).averages().time == Approx(1.0));
  CHECK(std::isfinite(again.averages().largest_load));
}

TEST_CASE(
    "Mean load: differs from the specified load → warning with remedy, except along given "
    "displacements",
    "[unit][results]") {
  bearing::Bearing bearing;
  bearing.constraints.load = {1000.0, 0.0, 0.0, 0.0, 0.0};
  bearing.constraints.displacement_given[2] = true;
  RunAverages averages;
  averages.add(at(0.0, 960.0));
  averages.add(at(1.0, 960.0));
  CHECK(mean_load(averages.averages(), bearing).departure() == Approx(0.04));
  CHECK(load_warning(mean_load(averages.averages(), bearing), UnitSystem::SI).empty());
  bearing.constraints.load[0] = 1200.0;
  const MeanLoad load = mean_load(averages.averages(), bearing);
  CHECK(load.departure() == Approx(0.2));
  const std::string text = load_warning(load, UnitSystem::SI);
  INFO(text);
  CHECK(text.find("the elements is appLoadX 960 N") != std::string::npos);
  CHECK(text.find("the deck specifies appLoadX 1200 N (20.0 % difference)") != std::string::npos);
  CHECK(text.find("appLoadX 1500 N") != std::string::npos);
  bearing.constraints.displacement_given[0] = true;
  CHECK(mean_load(averages.averages(), bearing).departure() == 0.0);
}

TEST_CASE("Load departure: of a small load on preloaded contacts it is measured by the contacts",
          "[unit][results]") {
  MeanLoad load;
  load.given = {true, true, true};
  load.asked = {1e-9, 0.0, 0.0};
  load.mean = {0.1, 0.0, 0.0};
  load.contact = 1000.0;
  CHECK(load.departure() == Approx(0.01));
  load.asked = {100.0, 0.0, 0.0};
  load.mean = {90.0, 0.0, 0.0};
  CHECK(load.departure() == Approx(0.1));
}

TEST_CASE("Mean load: load across the specified one → warning without proposed load",
          "[unit][results]") {
  MeanLoad load;
  load.time = 1.0;
  load.given = {true, true, true};
  load.asked = {1000.0, 0.0, 0.0};
  load.mean = {980.0, 0.001, 300.0};
  const std::string text = load_warning(load, UnitSystem::SI);
  INFO(text);
  CHECK(text.find("the elements is appLoadX 980, appLoadZ 300 N") != std::string::npos);
  CHECK(text.find("the deck specifies appLoadX 1000, appLoadZ 0 N (30.1 % difference)") !=
        std::string::npos);
  CHECK(text.find("enter about") == std::string::npos);
  CHECK(text.find("perpendicular to the specified load") != std::string::npos);
  // Of one that is mostly along it the other is told, too, where it is seen.
  load.mean = {800.0, 20.0, 60.0};
  const std::string along = load_warning(load, UnitSystem::SI);
  INFO(along);
  CHECK(along.find("the elements is appLoadX 800, appLoadZ 60 N") != std::string::npos);
  CHECK(along.find("appLoadX 1250") != std::string::npos);
}

TEST_CASE("Mean load: rotating load → not compared; free race → not described as held",
          "[unit][results]") {
  bearing::Bearing bearing;
  bearing.constraints.load = {1200.0, 0.0, 100.0, 0.0, 0.0};
  RunAverages averages;
  averages.add(at(0.0, 960.0));
  averages.add(at(1.0, 960.0));
  scene::ScenePlan plan;
  plan.race_motions.free[1].emplace();
  const std::string text =
      load_warning(mean_load(averages.averages(), bearing, plan), UnitSystem::SI);
  INFO(text);
  CHECK(text.find("a race is free to move along x") != std::string::npos);
  CHECK(text.find("inner race is fixed") == std::string::npos);
  scene::ScenePlan tilting;
  tilting.race_motions.free[0].emplace();
  tilting.race_motions.free[0]->translation_held = {true, true, true};
  const std::string tilt =
      load_warning(mean_load(averages.averages(), bearing, tilting), UnitSystem::SI);
  CHECK(tilt.find("a race without prescribed tilt") != std::string::npos);
  CHECK(tilt.find("inner race is fixed") == std::string::npos);
  scene::ScenePlan shaken;
  shaken.race_motions.vibration[1].emplace();
  const std::string cause =
      load_warning(mean_load(averages.averages(), bearing, shaken), UnitSystem::SI);
  CHECK(cause.find("record 9.3B makes a race vibrate") != std::string::npos);
  CHECK(cause.find("inner race is fixed") == std::string::npos);
  CHECK(cause.find("enter about") == std::string::npos);
  plan.race_motions.rotating_load_parameters =
      bearing::RotatingLoadParameters{{0.0, 1.0}, {0.0, 100.0}};
  const MeanLoad turning = mean_load(averages.averages(), bearing, plan);
  CHECK(turning.given[0]);
  CHECK_FALSE(turning.given[1]);
  CHECK_FALSE(turning.given[2]);
  plan.race_motions.rotating_load_parameters->fraction[1] = 0.0;
  CHECK(mean_load(averages.averages(), bearing, plan).given[2]);
}

TEST_CASE("Mean load: race in balance more than 1 % off → warning with cause", "[unit][results]") {
  bearing::Bearing bearing;
  bearing.constraints.load = {1000.0, 0.0, 100.0, 0.0, 0.0};
  scene::ScenePlan plan;
  plan.effects.push_back({scene::Effect::RaceBalance, "race balance", true, "mode = 2"});
  const auto told = [&](double carried) {
    RunAverages averages;
    averages.add(at(0.0, carried));
    averages.add(at(1.0, carried));
    return load_warning(mean_load(averages.averages(), bearing, plan), UnitSystem::SI);
  };
  CHECK(told(1009.0).empty());
  CHECK(told(975.0).find("(2.5 % difference). Cause: in mode 2") != std::string::npos);
  plan.effects.clear();
  CHECK(told(975.0).empty());
}
