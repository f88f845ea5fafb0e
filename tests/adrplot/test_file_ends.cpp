#include "adrplot/plot_document.hpp"
#include "core/results/synthetic.hpp"
#include "results/results_h5.hpp"
#include "results/sol_writer.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

/// A run that was killed: its plot files and RESULTS.h5 end at different steps.
using namespace adore;
using namespace adore::adrplot;
using namespace adore::testing;
using Catch::Matchers::Contains;

namespace {

/// SOL7 with the steps 0 to `sol`, RESULTS.h5 with those to `h5`; a file of fewer bytes, where
/// asked.
std::filesystem::path run_of(const TemporaryFolder& folder, long sol, long h5,
                             std::uintmax_t cut = 0) {
  const bearing::Bearing bearing = make_bearing();
  const auto units = deck::UnitSystem::SI;
  results::ChannelRecorder recorder(bearing, units, channel_table());
  const results::SolHeader header = results::make_sol_header(bearing, 0, units);
  const std::filesystem::path path = folder / "SOL7";
  {
    results::SolWriter file = results::SolWriter::create(path, header, units);
    results::H5Writer rows =
        results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
    for (long step = 0; step <= std::max(sol, h5); ++step) {
      const results::StepRecord& record = recorder.record(make_snapshot(bearing, step));
      if (step <= sol) file.write(record);
      if (step <= h5) rows.write(record);
    }
    rows.close();
  }
  if (cut > 0) std::filesystem::resize_file(path, std::filesystem::file_size(path) - cut);
  return path;
}

desktop::ChartPage first_page(const std::filesystem::path& path,
                              const results::SolRange& range = {}, std::size_t room = kMostValues) {
  PageOptions over_steps;
  over_steps.abscissa = Abscissa::Step;
  return open_document(path, range, room).build(1, over_steps);
}

}  // namespace

TEST_CASE("plot_document: steps only in RESULTS.h5 are drawn with a note", "[unit][adrplot][h5]") {
  TemporaryFolder folder;
  const auto path = run_of(folder, 30, 50, 7);  // the last step of SOL7 is cut
  const desktop::ChartPage page = first_page(path);
  REQUIRE(page.x.size() == 51);
  CHECK(page.x.back() == 50.0);
  CHECK(std::isfinite(page.panels.at(0).curves.at(0).y.back()));
  CHECK_THAT(page.note,
             Contains("The last 21 steps, 30 to 50, are only in RESULTS.h5: SOL7 ends at step "
                      "29."));
  CHECK_THAT(page.subtitle, Contains("full precision (RESULTS.h5)"));
  // The steps that are asked for are those of the file.
  const desktop::ChartPage part = first_page(path, {1, 10, 1});
  CHECK(part.x.size() == 10);
  CHECK_THAT(part.note, !Contains("only in RESULTS.h5"));
}

TEST_CASE("plot_document: full precision is reported only for steps that have it",
          "[unit][adrplot][h5]") {
  TemporaryFolder folder;
  const desktop::ChartPage page = first_page(run_of(folder, 50, 30));
  CHECK(page.x.size() == 51);
  CHECK_THAT(page.subtitle, Contains("full precision (RESULTS.h5) to step 30"));
  CHECK_THAT(page.note, Contains("RESULTS.h5 ends at step 30: later values have eight digits "
                                 "(SOL7)."));
  const desktop::ChartPage whole = first_page(run_of(folder, 50, 50));
  CHECK(whole.subtitle.ends_with("full precision (RESULTS.h5)"));
  CHECK_THAT(whole.note, !Contains("RESULTS.h5"));
}

TEST_CASE("plot_document: a longer RESULTS.h5 takes no more room than files may",
          "[unit][adrplot][h5]") {
  TemporaryFolder folder;
  const auto path = run_of(folder, 30, 400);
  const desktop::ChartPage page = first_page(path, {}, 31 * 17 + 17 * 20);
  CHECK(page.x.size() <= 60);
  CHECK(page.x.size() >= 31);
  CHECK_THAT(page.note, Contains("that do not fit in memory"));
}

TEST_CASE("plot_document: interval or part of a file → not treated as its end",
          "[unit][adrplot][h5]") {
  TemporaryFolder folder;
  // Both files end with step 41: with every interval that leaves it out nothing is added, and
  // nothing said of an end. The same where RESULTS.h5 ends first, or is longer.
  for (const long h5 : {41L, 33L, 60L}) {
    const auto path = run_of(folder, 41, h5);
    for (const long from : {1L, 5L, 38L})
      for (const long every : {1L, 2L, 3L, 7L, 20L}) {
        const desktop::ChartPage page = first_page(path, {from, results::SolRange{}.to, every});
        INFO("RESULTS.h5 to " << h5 << ", from " << from << ", every " << every << ": " << page.note
                              << " | " << page.subtitle);
        std::vector<double> expected;
        for (long step = from - 1; step <= 41; step += every)
          expected.push_back(static_cast<double>(step));
        const std::size_t own = expected.size();
        // Behind the file's end as far apart; the run's end whatever its distance.
        for (long step = static_cast<long>(expected.back()) + every; step <= h5; step += every)
          expected.push_back(static_cast<double>(step));
        // Of one step no distance is known.
        if (h5 > 41 && own > 1 && expected.back() < static_cast<double>(h5))
          expected.push_back(static_cast<double>(h5));
        if (own > 1 || h5 <= 41) CHECK(page.x == expected);
        const std::string& note = page.note;
        if (h5 > 41)
          CHECK_THAT(note, Contains("only in RESULTS.h5: SOL7 ends at step 41."));
        else
          CHECK_THAT(note, !Contains("only in RESULTS.h5"));
        CHECK(note.find("RESULTS.h5 ends at step") ==
              (note.find("RESULTS.h5 ends at step 33:") == std::string::npos
                   ? std::string::npos
                   : note.find("RESULTS.h5 ends at step 33:")));
        if (h5 == 41) CHECK_THAT(page.subtitle, Contains("full precision (RESULTS.h5)"));
        if (every > 1) CHECK_THAT(note, Contains(fmt::format("one of every {}", every)));
        if (from > 1) CHECK_THAT(note, Contains(fmt::format("from number {} to the end", from)));
      }
  }
}
