#include "results/motion.hpp"
#include "results/run_folder.hpp"
#include "results/sol_writer.hpp"
#include "support/paths.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

#include <fstream>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;

TEST_CASE("run_folder: plot files and animation of a run for any file names", "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing(2);
  TemporaryFolder folder;
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  const auto write = [&](const char* name) {
    SolWriter writer = SolWriter::create(folder / name, make_sol_header(bearing, 1, UnitSystem::SI),
                                         UnitSystem::SI);
    writer.write(recorder.record(make_snapshot(bearing, 0)));
  };
  const auto animate = [&](const char* name) {
    Sol8Writer animation = Sol8Writer::create(folder / name, bearing, UnitSystem::SI);
    animation.write(make_snapshot(bearing, 0));
  };
  const auto run_json = [&](const char* text) { std::ofstream(folder / "RUN.json") << text; };

  CHECK(run_folder(folder / "none").plots.empty());
  write("ball.dat");
  animate("moves.dat");
  std::ofstream(folder / "list.txt") << "a listing";
  CHECK(run_folder(folder / "").plots.empty());  // nothing says that they are the run's
  run_json(R"({"files": ["list.txt", "ball.dat", "gone.dat", "moves.dat", 3, "../ball.dat"]})");
  PlottableFiles found = run_folder(folder / "");
  CHECK(found.plots == std::vector{folder / "ball.dat"});
  CHECK(found.animation == folder / "moves.dat");

  write("SOL2");
  write("SOL1");
  animate("SOL8");
  run_json(R"({"files": ["SOL2", "ball.dat"]})");
  found = run_folder(folder / "");
  CHECK(found.plots == std::vector{folder / "SOL1", folder / "SOL2", folder / "ball.dat"});
  CHECK(found.animation == folder / "SOL8");
  for (const char* damaged : {"{", "[]", R"({"files": 3})"}) {
    run_json(damaged);
    CHECK(run_folder(folder / "").plots.size() == 2);
  }
}

TEST_CASE("run_folder: animation of a run is its SOL8, otherwise its RESULTS.h5", "[unit][sol]") {
  const TemporaryFolder folder;
  const auto told = [&] {
    try {
      (void)animation_file(folder / "");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(told().find("no animation") != std::string::npos);
  CHECK(told().find("RESULTS.h5") != std::string::npos);
  std::ofstream(folder / "RESULTS.h5") << "any";
  CHECK(animation_file(folder / "") == folder / "RESULTS.h5");
  std::ofstream(folder / "SOL8") << "any";
  CHECK(animation_file(folder / "") == folder / "SOL8");
  CHECK(animation_file(folder / "RESULTS.h5") == folder / "RESULTS.h5");
  CHECK(animation_file(folder / "nowhere") == folder / "nowhere");  // whoever reads it tells
}
