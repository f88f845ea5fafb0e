#include "adrplot/own_chart.hpp"
#include "adrplot/plot_document.hpp"
#include "core/results/synthetic.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/chart_view.hpp"
#include "results/full_precision.hpp"
#include "results/results_h5.hpp"
#include "results/sol_writer.hpp"
#include "support/qt_app.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

/// Extremes between stored steps on the pages of AdrPlot.
using namespace adore;
using namespace adore::adrplot;
using namespace adore::testing;
using Catch::Contains;
using results::UnitSystem;

namespace {

constexpr long kEvery = 10, kLast = 100;

/// A tenth of it is stored: a fast wave about the values of the synthetic run.
double wave(long step) { return 1.0 + 0.5 * std::sin(2.0 * static_cast<double>(step)); }

scene::Snapshot at(const bearing::Bearing& bearing, long step) {
  scene::Snapshot out = make_snapshot(bearing, step);
  for (auto& element : out.elements) {
    for (auto& race : element.race) race.heat *= wave(step);
    for (auto& pocket : element.pocket) pocket.force = 20.0 * wave(step);
  }
  for (auto& cage : out.cages)
    for (auto& land : cage.lands) land.force = 7.0 * wave(step);
  return out;
}

/// SOL1 of element 2 and SOL4 of the cage, and RESULTS.h5 with what the steps in between had.
void write_run(const TemporaryFolder& folder, UnitSystem units) {
  const bearing::Bearing bearing = make_bearing();
  results::ChannelRecorder recorder(bearing, units, channel_table());
  std::vector<results::SolWriter> files;
  for (const auto& [name, index] : {std::pair{"SOL1", 2}, {"SOL4", 4}})
    files.push_back(results::SolWriter::create(
        folder / name, results::make_sol_header(bearing, index, units), units));
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  results::StepBand band;
  for (long step = 0; step <= kLast; ++step) {
    const bool stored = step % kEvery == 0;
    const auto& record = recorder.record(at(bearing, step), &band);
    if (!stored) continue;
    for (auto& file : files) file.write(record);
    h5.write(record);
    band.clear();
  }
  h5.close();
}

int page_named(const PlotDocument& document, const std::string& title) {
  for (std::size_t i = 0; i < document.pages.size(); ++i)
    if (document.pages[i].title.starts_with(title)) return static_cast<int>(i + 1);
  FAIL("no page " << title);
  return 0;
}

}  // namespace

TEST_CASE("pages of pockets, lands and heat: min–max bands between stored steps",
          "[unit][adrplot][step-band]") {
  for (const UnitSystem units : {UnitSystem::SI, UnitSystem::English}) {
    TemporaryFolder folder;
    write_run(folder, units);
    struct Case {
      const char *file, *page, *known, *unknown;
    };
    for (const Case& of :
         {Case{"SOL4", "Pocket 2 interaction", "Normal force", "\"Gap\" and \"Contact angle\""},
          Case{"SOL4", "Cage to race interaction, land 1", "Normal force",
               "\"Gap\" and \"Contact angle\""},
          Case{"SOL1", "Race interactions 3", "Heat generation", "\"Contact temp. rise\""}}) {
      INFO(of.file << ", " << of.page << ", " << (units == UnitSystem::SI ? "SI" : "English"));
      const PlotDocument document = open_document(folder / of.file);
      const desktop::ChartPage page = document.build(page_named(document, of.page), {});
      CHECK_THAT(page.band_note, Contains("Min–max bands: range of the values"));
      CHECK_THAT(page.note, Contains(std::string("peaks of ")));
      CHECK_THAT(page.note, Contains(of.unknown));
      CHECK_THAT(page.note, !Contains(std::string("\"") + of.known));
      const desktop::ChartPanel& panel = page.panels.front();
      CHECK(panel.title == of.known);
      for (const desktop::ChartCurve& curve : panel.curves) {
        REQUIRE(curve.high.size() == static_cast<std::size_t>(kLast / kEvery + 1));
        REQUIRE(curve.low.size() == curve.high.size());
        for (std::size_t i = 1; i < curve.high.size(); ++i) {
          const long step = static_cast<long>(i) * kEvery;
          double low = 1e300, high = 0.0;
          for (long k = step - kEvery + 1; k <= step; ++k) {
            low = std::min(low, wave(k));
            high = std::max(high, wave(k));
          }
          const double mean = curve.y[i] / wave(step);  // of the wave, in the file's unit
          CHECK(curve.low[i] == Approx(low * mean).epsilon(1e-9));
          CHECK(curve.high[i] == Approx(high * mean).epsilon(1e-9));
          CHECK(curve.low[i] <= curve.y[i]);
          CHECK(curve.high[i] >= curve.y[i]);
        }
        CHECK(curve.high[0] == curve.low[0]);
      }
    }
  }
}

TEST_CASE("plot_document: page without extremes → note on missing peaks",
          "[unit][adrplot][step-band]") {
  TemporaryFolder folder;
  write_run(folder, UnitSystem::SI);
  const PlotDocument document = open_document(folder / "SOL1");
  const desktop::ChartPage page = document.build(page_named(document, "Position of the mass"), {});
  CHECK(page.band_note.empty());
  for (const auto& panel : page.panels)
    for (const auto& curve : panel.curves) CHECK(curve.high.empty());
  CHECK_THAT(page.note, Contains("is stored: peaks between stored steps are missing."));
}

TEST_CASE("bands: range over several stored steps → includes their extremes",
          "[unit][adrplot][step-band]") {
  TemporaryFolder folder;
  write_run(folder, UnitSystem::SI);
  results::SolRange range;
  range.every = 5;
  const PlotDocument document = open_document(folder / "SOL4", range);
  const desktop::ChartPage page = document.build(page_named(document, "Pocket 1"), {});
  const desktop::ChartCurve& force = page.panels.front().curves.front();
  REQUIRE(force.high.size() == 3);  // steps 0, 50, 100
  double high = 0.0, low = 1e300;
  for (long k = 51; k <= 100; ++k) {
    high = std::max(high, 20.0 * wave(k));
    low = std::min(low, 20.0 * wave(k));
  }
  CHECK(force.high[2] == Approx(high).epsilon(1e-9));
  CHECK(force.low[2] == Approx(low).epsilon(1e-9));
  CHECK_THAT(page.note,
             Contains("peaks of \"Gap\" and \"Contact angle\" between them are missing"));
}

TEST_CASE("spectra are of stored values and a file of another run gives no bands",
          "[unit][adrplot][step-band]") {
  TemporaryFolder folder;
  write_run(folder, UnitSystem::SI);
  const PlotDocument document = open_document(folder / "SOL4");
  PageOptions options;
  options.domain = Domain::Spectrum;
  const desktop::ChartPage spectrum = document.build(page_named(document, "Pocket 1"), options);
  for (const auto& panel : spectrum.panels)
    for (const auto& curve : panel.curves) CHECK(curve.high.empty());

  results::SolFile other = results::read_sol(folder / "SOL4");
  other.header.run_id = "another run";
  CHECK(results::bands_of(other, {0, 1, 2, 3, 4, 5}).empty());
}

TEST_CASE("own charts keep the extremes and the remarks of the pages that they are from",
          "[unit][adrplot][step-band]") {
  TemporaryFolder folder;
  write_run(folder, UnitSystem::SI);
  results::SolRange range;
  range.every = 5;
  const PlotDocument all = open_document(folder / "SOL4"),
                     few = open_document(folder / "SOL4", range),
                     element = open_document(folder / "SOL1");
  const int pocket = page_named(all, "Pocket 1"),
            moves = page_named(element, "Position of the mass");
  const CurvePick force{&all, pocket, 0, 0}, force_of_few{&few, pocket, 0, 0},
      gap{&all, pocket, 1, 0}, moving{&element, moves, 0, 0};
  const auto said = [](const desktop::ChartPage& page, const std::string& what) {
    return page.note.find(what) != std::string::npos;
  };
  const auto source = all.build(pocket, {});
  // Two abscissae: each place has the extremes of the stored step that it lies in.
  const auto page = combine_curves({force, force_of_few}, Combine::Overlay, {});
  REQUIRE(page.panels.size() == 1);
  const auto& curves = page.panels[0].curves;
  CHECK(curves.at(0).low == source.panels[0].curves[0].low);
  CHECK(curves[0].high == source.panels[0].curves[0].high);
  REQUIRE(curves.at(1).high.size() == page.x.size());
  for (std::size_t i = 0; i < page.x.size(); ++i) {
    double high = 20.0 * wave(0), low = high;
    const long end = i == 0 ? 0 : i <= 5 ? 50 : 100;
    for (long k = end - 49; k <= end && end > 0; ++k) {
      high = k == end - 49 ? 20.0 * wave(k) : std::max(high, 20.0 * wave(k));
      low = k == end - 49 ? 20.0 * wave(k) : std::min(low, 20.0 * wave(k));
    }
    CHECK(curves[1].high[i] == Approx(high).epsilon(1e-9));
    CHECK(curves[1].low[i] == Approx(low).epsilon(1e-9));
  }
  CHECK_THAT(page.band_note, Contains("Min–max bands:"));
  // What one of them says is said of that one; what a curve does not have is not spoken of.
  CHECK(said(page, "of the steps in the file (one of every 5)"));
  CHECK(combine_curves({gap}, Combine::Overlay, {}).band_note.empty());
  const auto two = combine_curves({gap, moving}, Combine::Overlay, {});
  REQUIRE(two.panels.size() == 2);
  CHECK(said(two, two.panels[1].curves[0].name + ": One of every 10 steps is stored: peaks between "
                                                 "stored steps are missing"));
  const auto less = combine_curves({force, force_of_few}, Combine::Difference, {});
  for (const auto& curve : less.panels.at(0).curves) CHECK(curve.high.empty());
  CHECK(said(less, "Differences have no min–max bands."));
  PageOptions spectra;
  spectra.domain = Domain::Spectrum;
  const auto lines = combine_curves({force, force_of_few}, Combine::Overlay, spectra);
  CHECK_FALSE(said(lines, "Min–max"));
  CHECK(said(lines, "of the steps in the file (one of every 5)"));
}

TEST_CASE("readout and cursors tell the extremes between the values", "[gui][step-band]") {
  test::use_qt();
  desktop::ChartPage page;
  page.title = "Pocket";
  page.x_title = "Time";
  page.x_unit = "s";
  page.x = {0.0, 1.0, 2.0, 3.0};
  desktop::ChartPanel panel{"Normal force", "N", {}};
  desktop::ChartCurve with{"", {1.0, 2.0, 1.0, 3.0}, {}};
  with.low = {1.0, 0.5, 0.25, 2.0};
  with.high = {1.0, 17.6, 4.0, 9.0};
  panel.curves = {with};
  page.panels = {panel};
  desktop::ChartView view;
  view.resize(900, 500);
  view.show();
  view.showPage(page);
  const desktop::ChartScene& scene = view.chartScene();
  const auto told = [&](double x) {
    return scene.readout({scene.sceneXAt(x), scene.plotAreas().front().center().y()});
  };
  CHECK_THAT(told(1.0).toStdString(), Contains("2 N (500 mN to 17.6 N)"));
  CHECK_THAT(told(0.0).toStdString(), !Contains(" to "));
  view.setCursorAbscissa(0, 1.0);
  view.setCursorAbscissa(1, 3.0);
  // What was before A counts no more.
  CHECK_THAT(view.cursorReport().toStdString(), Contains("band 250 mN to 9 N"));
  view.setCursorAbscissa(0, 0.0);
  CHECK_THAT(view.cursorReport().toStdString(), Contains("band 250 mN to 17.6 N"));
}
