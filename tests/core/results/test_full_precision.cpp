#include "results/full_precision.hpp"
#include "results/motion_file.hpp"
#include "results/results_h5.hpp"
#include "results/sol_writer.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;
using Catch::Matchers::Contains;

namespace {

/// Steps 0 to 40 in SOL files of element 2, cage and power and in SOL8; RESULTS.h5 of `h5_run`
/// holds all of them, whose time is shifted by `delay` steps.
void write_run(const TemporaryFolder& folder, UnitSystem units, const std::string& h5_run,
               long delay = 0, long h5_steps = 40) {
  bearing::Bearing bearing = make_bearing();
  ChannelRecorder recorder(bearing, units, channel_table());
  std::vector<std::pair<SolHeader, SolWriter>> files;
  for (const auto& [name, index] : {std::pair{"SOL1", 2}, {"SOL4", 4}, {"SOL7", 0}}) {
    const SolHeader header = make_sol_header(bearing, index, units);
    files.emplace_back(header, SolWriter::create(folder / name, header, units));
  }
  Sol8Writer animation = Sol8Writer::create(folder / "SOL8", bearing, units);
  for (long step = 0; step <= 40; ++step) {
    const StepRecord& record = recorder.record(make_snapshot(bearing, step));
    for (auto& [header, file] : files) file.write(record);
    animation.write(make_snapshot(bearing, step));
  }
  bearing.run_id = h5_run;
  H5Writer h5 = H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  ChannelRecorder second(bearing, units, channel_table());
  for (long step = 0; step <= h5_steps; ++step) {
    scene::Snapshot snapshot = make_snapshot(bearing, step + delay);
    snapshot.step = step;
    h5.write(second.record(snapshot));
  }
  h5.flush();
}

/// Largest relative distance between the values of a file and those that the writers were given.
double worst(const SolFile& file, UnitSystem units) {
  const bearing::Bearing bearing = make_bearing();
  ChannelRecorder recorder(bearing, units, channel_table());
  const auto columns = sol_columns(file.header);
  double largest = 0.0;
  for (long step = 0; step <= 40; ++step) {
    const SolStep exact =
        make_sol_step(file.header, columns, recorder.record(make_snapshot(bearing, step)), units);
    const SolStep& read = file.steps.at(static_cast<std::size_t>(step));
    REQUIRE(read.values.size() == exact.values.size());
    for (const auto& [had, given] :
         {std::pair{read.time, exact.time}, {read.revolutions, exact.revolutions}})
      if (given != 0.0) largest = std::max(largest, std::abs(had / given - 1.0));
    for (std::size_t i = 0; i < exact.values.size(); ++i)
      if (exact.values[i] != 0.0)
        largest = std::max(largest, std::abs(read.values[i] / exact.values[i] - 1.0));
  }
  return largest;
}

}  // namespace

TEST_CASE("full_precision: RESULTS.h5 in the folder of SOL1-SOL7 → all digits", "[unit][h5][sol]") {
  for (const UnitSystem units : {UnitSystem::SI, UnitSystem::English}) {
    TemporaryFolder folder;
    write_run(folder, units, "synthetic run 7");
    for (const char* name : {"SOL1", "SOL4", "SOL7"}) {
      INFO(name);
      SolFile file = read_sol(folder / name);
      CHECK(worst(file, units) > 1e-10);  // the file's own digits
      CHECK(worst(file, units) < 1e-6);
      CHECK(use_full_precision(file).why_not.empty());
      CHECK(worst(file, units) < 1e-15);  // the same numbers through the same conversion
    }
  }
}

TEST_CASE("full_precision: range of steps → found in RESULTS.h5, and stars become numbers",
          "[unit][h5][sol]") {
  TemporaryFolder folder;
  write_run(folder, UnitSystem::SI, "synthetic run 7");
  SolFile all = read_sol(folder / "SOL1"), some = read_sol(folder / "SOL1", {4, 31, 9});
  some.steps[1].values[0] = std::nan("");
  REQUIRE(use_full_precision(all).why_not.empty());
  REQUIRE(use_full_precision(some).why_not.empty());
  REQUIRE(some.steps.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(some.steps[i].values == all.steps[3 + 9 * i].values);
}

TEST_CASE("full_precision: RESULTS.h5 missing, of another run or unreadable → file unchanged",
          "[unit][h5][sol]") {
  const auto refused = [](const TemporaryFolder& folder) {
    SolFile file = read_sol(folder / "SOL1");
    const SolFile before = file;
    const std::string why = use_full_precision(file).why_not;
    for (std::size_t i = 0; i < file.steps.size(); ++i)
      CHECK(file.steps[i].values == before.steps[i].values);
    std::string why_not;
    CHECK_FALSE(MotionFile::of_sol8(read_sol8(folder / "SOL8"), why_not).has_value());
    CHECK_FALSE(why_not.empty());
    return why;
  };
  TemporaryFolder other, older, bare, broken;
  write_run(other, UnitSystem::SI, "another run");
  CHECK_THAT(refused(other), Contains("another run"));
  write_run(older, UnitSystem::SI, "synthetic run 7", 3);
  CHECK_THAT(refused(older), Contains("different numbers"));
  write_run(bare, UnitSystem::SI, "synthetic run 7");
  std::filesystem::remove(bare / "RESULTS.h5");
  CHECK_THAT(refused(bare), Contains("no RESULTS.h5"));
  write_run(broken, UnitSystem::SI, "synthetic run 7");
  write_bytes(broken / "RESULTS.h5", "not an HDF5 file");
  CHECK_THAT(refused(broken), Contains("RESULTS.h5"));
}

TEST_CASE("full_precision: steps missing in RESULTS.h5 → values of the classic file",
          "[unit][h5][sol]") {
  TemporaryFolder folder;
  write_run(folder, UnitSystem::SI, "synthetic run 7", 0, 20);
  SolFile file = read_sol(folder / "SOL1");
  const SolFile before = file;
  CHECK(use_full_precision(file).why_not.empty());
  CHECK(file.steps[20].values != before.steps[20].values);
  CHECK(file.steps[21].values == before.steps[21].values);
  std::string why_not;
  // A run that was killed: RESULTS.h5 is used as far as it goes.
  const Sol8File longer = read_sol8(folder / "SOL8");
  const auto motion = MotionFile::of_sol8(longer, why_not);
  INFO(why_not);
  REQUIRE(motion);
  CHECK(motion->frames().frames.back().step < longer.frames.back().step);
  // A gap within it is no such end.
  Sol8File gap = longer;
  gap.frames.front().step = motion->frames().frames.front().step - 1;
  CHECK_FALSE(MotionFile::of_sol8(gap, why_not).has_value());
  CHECK_THAT(why_not, Contains("does not contain step"));
}

TEST_CASE("full_precision: steps after the end of a classic file → from RESULTS.h5",
          "[unit][h5][sol]") {
  const bearing::Bearing bearing = make_bearing();
  for (const UnitSystem units : {UnitSystem::SI, UnitSystem::English}) {
    TemporaryFolder folder;
    write_run(folder, units, "synthetic run 7", 0, 60);
    for (const char* name : {"SOL1", "SOL4", "SOL7"}) {
      INFO(name);
      SolFile file = read_sol(folder / name);
      const FullPrecisionStatus told = use_full_precision(file, 1000);
      CHECK(told.why_not.empty());
      CHECK(told.exact == 41);
      CHECK(told.from_start);
      CHECK_FALSE(told.more);
      REQUIRE(told.added == 20);
      REQUIRE(file.steps.size() == 61);
      ChannelRecorder recorder(bearing, units, channel_table());
      for (long step = 0; step <= 60; ++step) {
        const SolStep exact = make_sol_step(file.header, sol_columns(file.header),
                                            recorder.record(make_snapshot(bearing, step)), units);
        const SolStep& read = file.steps[static_cast<std::size_t>(step)];
        CHECK(read.step == step);
        CHECK(read.time == Approx(exact.time).epsilon(1e-14));
        CHECK(read.revolutions == Approx(exact.revolutions).epsilon(1e-6));
        CHECK(read.element_revolutions == Approx(exact.element_revolutions).epsilon(1e-6));
        CHECK(read.step_size == Approx(exact.step_size).epsilon(1e-6));
        if (step <= 40) continue;
        REQUIRE(read.values.size() == exact.values.size());
        for (std::size_t i = 0; i < exact.values.size(); ++i)
          CHECK(read.values[i] == Approx(exact.values[i]).epsilon(1e-14));
      }
    }
  }
  // As far apart as the file's own steps, with the run's end; no more than there is room for.
  TemporaryFolder folder;
  write_run(folder, UnitSystem::SI, "synthetic run 7", 0, 60);
  SolFile apart = read_sol(folder / "SOL1", {1, 1000, 9});
  CHECK(use_full_precision(apart, 1000).added == 3);
  std::vector<long> steps;
  for (const SolStep& step : apart.steps) steps.push_back(step.step);
  CHECK(steps == std::vector<long>{0, 9, 18, 27, 36, 45, 54, 60});
  SolFile few = read_sol(folder / "SOL1");
  const FullPrecisionStatus told = use_full_precision(few, 5);
  CHECK(told.added == 5);
  CHECK(told.more);
  CHECK(few.steps.back().step == 45);
  // The file's end is the later one: nothing is added, and where all digits end is told.
  write_run(folder, UnitSystem::SI, "synthetic run 7", 0, 20);
  SolFile longer = read_sol(folder / "SOL1");
  const FullPrecisionStatus part = use_full_precision(longer, 1000);
  CHECK(part.added == 0);
  CHECK(part.exact == 21);
  CHECK(part.from_start);
  CHECK(longer.steps.size() == 41);
}

TEST_CASE("motion file: SOL8 with RESULTS.h5 → all digits and every channel", "[unit][h5][sol8]") {
  for (const UnitSystem units : {UnitSystem::SI, UnitSystem::English}) {
    TemporaryFolder folder;
    write_run(folder, units, "synthetic run 7");
    const Sol8File coarse = read_sol8(folder / "SOL8");
    std::string why_not;
    const auto motion = MotionFile::of_sol8(coarse, why_not);
    INFO(why_not);
    REQUIRE(motion);
    const Sol8File& fine = motion->frames();
    REQUIRE(fine.frames.size() == 41);
    CHECK(fine.units == coarse.units);
    CHECK(fine.elements == coarse.elements);
    CHECK(motion->every() == 1);
    const bearing::Bearing bearing = make_bearing();
    const double metre = units == UnitSystem::SI ? 1.0 : 0.0254,
                 newton = units == UnitSystem::SI ? 1.0 : 4.4482216152605;
    const Sol8Geometry sizes = make_sol8_geometry(bearing);
    for (const Sol8GeometryField& field : kSol8Geometry)
      CHECK(fine.geometry.*field.value == Approx(sizes.*field.value / metre));
    for (const long step : {0L, 17L, 40L}) {
      INFO(step);
      const Sol8Frame exact = make_sol8_frame(make_snapshot(bearing, step));
      const Sol8Frame& read = fine.frames[static_cast<std::size_t>(step)];
      CHECK(read.step == exact.step);
      CHECK(read.revolutions == Approx(exact.revolutions));
      for (std::size_t k = 0; k < exact.elements.size(); ++k) {
        const Sol8Element &a = read.elements[k], &b = exact.elements[k];
        CHECK(a.x == Approx(b.x / metre).epsilon(1e-12));
        CHECK(a.r == Approx(b.r / metre).epsilon(1e-12));
        CHECK(a.theta == Approx(b.theta).epsilon(1e-12));
        CHECK(a.pocket_force == Approx(b.pocket_force / newton).epsilon(1e-12));
        for (std::size_t c = 0; c < 3; ++c) {
          CHECK(a.angles[c] == Approx(b.angles[c]).margin(1e-12));
          CHECK(a.pocket_vector[c] == Approx(b.pocket_vector[c] / metre).margin(1e-15));
        }
      }
      for (std::size_t land = 0; land < 2; ++land)
        CHECK(read.land_force[land] == Approx(exact.land_force[land] / newton).margin(1e-12));
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(read.cage.position[c] == Approx(exact.cage.position[c] / metre).margin(1e-15));
        CHECK(read.races[1].angles[c] == Approx(exact.races[1].angles[c]).margin(1e-12));
      }
    }
    const MotionChannel* load = motion->channel("contact.load");
    REQUIRE(load != nullptr);
    CHECK(load->unit == (units == UnitSystem::SI ? "N" : "lbf"));
    const auto made = make_snapshot(bearing, 17).elements[2].race[1];
    CHECK(load->at(17, 2 * 2 + 1) == Approx(made.load / newton).epsilon(1e-12));
    CHECK(motion->series("contact.load", 5)[17] == load->at(17, 5));
    CHECK(motion->channel("nothing.here") == nullptr);
    // Of long runs every second, third ... step is a frame; curves keep every step.
    const MotionFile few = MotionFile::open(folder / "RESULTS.h5", units, 11);
    CHECK(few.every() == 4);
    CHECK(few.frames().frames.size() == 11);
    CHECK(few.frames().frames[3].step == 12);
    CHECK(few.channel("contact.load")->at(3, 5) == load->at(12, 5));
    CHECK(few.series("contact.load", 5).size() == 41);
  }
}

TEST_CASE("motion file: SOL8 finds its RESULTS.h5 for any orbit radius", "[unit][h5][sol8]") {
  // Three digits behind 0. leave up to half a percent of a radius such as 0.0100499.
  for (const double radius : {0.0100499, 0.0102499, 0.01925, 0.0192499, 0.0249501, 0.0999501}) {
    INFO(radius);
    TemporaryFolder folder;
    const bearing::Bearing bearing = make_bearing();
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    Sol8Writer animation = Sol8Writer::create(folder / "SOL8", bearing, UnitSystem::SI);
    H5Writer h5 = H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
    scene::Snapshot snapshot = make_snapshot(bearing, 0);
    for (auto& ball : snapshot.elements) ball.r = radius;
    h5.write(recorder.record(snapshot));
    h5.close();
    animation.write(snapshot);
    std::string why_not;
    const Sol8File file = read_sol8(folder / "SOL8");
    CHECK(MotionFile::of_sol8(file, why_not).has_value());
    CHECK(why_not.empty());
    Sol8File other = file;
    other.frames[0].elements[0].r *= 1.012;
    CHECK_FALSE(MotionFile::of_sol8(other, why_not).has_value());
  }
}
