#include "adrplot/distinct_colours.hpp"
#include "adrplot/render.hpp"
#include "adrplot/spectrum.hpp"
#include "base/errors.hpp"
#include "results/channels.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QTemporaryDir>
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

/// Columns that the pages name.
std::set<std::string> drawn(const std::vector<PageSpec>& pages) {
  std::set<std::string> out;
  for (const auto& page : pages)
    for (const auto& panel : page.panels)
      for (const auto& curve : panel.curves) out.insert(curve.column);
  return out;
}

/// Columns that the file has.
std::set<std::string> stored(const results::SolHeader& header) {
  std::set<std::string> out;
  for (const auto& column : results::sol_columns(header)) out.insert(column.id);
  return out;
}

}  // namespace

TEST_CASE("plot_pages: each kind of file has the manual's pages", "[unit]") {
  const auto count = [](SolKind kind, auto change) {
    auto header = test::synthetic_header(kind, {});
    change(header);
    return plot_pages(kind, header).size();
  };
  const auto as_is = [](results::SolHeader&) {};
  CHECK(count(SolKind::Power, as_is) == 5 + 1);  // and bulk temperatures
  CHECK(count(SolKind::Power, [](auto& h) { h.value_count = 17; }) == 4);
  CHECK(count(SolKind::Element, as_is) == 8);
  CHECK(count(SolKind::Element, [](auto& h) { h.outer_flange = true; }) ==
        8);  // balls have no flanges
  CHECK(count(SolKind::Element,
              [](auto& h) { h.bearing_type = 2, h.value_count = 45, h.outer_flange = true; }) == 9);
  CHECK(count(SolKind::Element, [](auto& h) {
          h.bearing_type = 2, h.value_count = 45, h.outer_flange = h.inner_flange = true;
        }) == 10);
  CHECK(count(SolKind::Element, [](auto& h) { h.value_count = 56; }) == 8 + 3 + 1);  // split races
  CHECK(count(SolKind::Race, as_is) == 9);
  CHECK(count(SolKind::Cage, as_is) == 9 + 12);  // N = 9 + n ceil(m/2)
  CHECK(count(SolKind::Cage,
              [](auto& h) { h.pocket_surfaces = 4, h.value_count = 24 + 16 * 12; }) == 9 + 12 * 2);
  CHECK_THROWS_AS(count(SolKind::Animation, as_is), InputError);
}

TEST_CASE("plot_pages: every column of a file is on a page, and no page asks for others",
          "[unit]") {
  for (const auto kind : {SolKind::Power, SolKind::Element, SolKind::Race, SolKind::Cage})
    for (const bool spherical : {false, true}) {
      auto header = test::synthetic_header(kind, {});
      header.pocket_type = spherical ? 1 : 0;
      if (spherical && kind == SolKind::Element) header.value_count = 56;  // and a split race
      const auto pages = plot_pages(kind, header);
      const std::set<std::string> there = stored(header), shown = drawn(pages);
      for (const std::string& column : shown) {
        INFO(column);
        CHECK(there.count(column) == 1);
      }
      for (const std::string& column : there) {
        INFO(column);
        // phi belongs to spherical pockets; the manual has no page for a race's polar position.
        const bool left_out = (!spherical && column.starts_with("pocket.phi")) ||
                              (column.starts_with("race.") && column.ends_with("l_position"));
        CHECK((left_out || shown.count(column) == 1));
      }
      for (const auto& page : pages)
        for (const auto& panel : page.panels) CHECK_FALSE(panel.curves.empty());
    }
}

TEST_CASE("plot_pages: the curves of a panel share one unit", "[unit]") {
  for (const auto kind : {SolKind::Power, SolKind::Element, SolKind::Race, SolKind::Cage}) {
    const auto header = test::synthetic_header(kind, {});
    std::map<std::string, decltype(results::SolColumn::unit)> unit;
    for (const auto& column : results::sol_columns(header)) unit[column.id] = column.unit;
    for (const auto& page : plot_pages(kind, header))
      for (const auto& panel : page.panels)
        for (const auto& curve : panel.curves) {
          INFO(page.title << ", " << panel.title << ", " << curve.column);
          CHECK(unit.at(curve.column) == unit.at(panel.curves.front().column));
        }
  }
}

TEST_CASE("plot_pages: short element files → missing quantities are named", "[unit]") {
  auto header = test::synthetic_header(SolKind::Element, {});
  header.value_count = 27;
  const auto pages = plot_pages(SolKind::Element, header);
  REQUIRE(pages.size() == 8);
  for (const std::string& column : drawn(pages)) CHECK(stored(header).count(column) == 1);
  CHECK_FALSE(pages[6].note.empty());
  CHECK_FALSE(pages[7].note.empty());
  CHECK(pages[5].note.empty());
}

TEST_CASE("plot_pages: roller pockets show a contact position, ball pockets an angle", "[unit]") {
  auto header = test::synthetic_header(SolKind::Cage, {});
  CHECK(plot_pages(SolKind::Cage, header)[8].panels[2].title == "Contact angle");
  header.bearing_type = 2;
  header.pocket_surfaces = 2;
  header.value_count = 24 + 8 * 12;
  const auto page = plot_pages(SolKind::Cage, header)[8];
  CHECK(page.panels[2].title == "Contact position");
  CHECK(page.panels[2].curves.size() == 2);
  header.pocket_type = -1;
  CHECK(plot_pages(SolKind::Cage, header)[8].panels[2].title == "Contact angle");
}

TEST_CASE("spectrum: two tones come out at their frequencies and relative heights", "[unit]") {
  constexpr int kSamples = 1000;
  constexpr double kStep = 1e-4;  // bins of 10 Hz
  std::vector<double> samples;
  for (int i = 0; i < kSamples; ++i) {
    const double t = i * kStep;
    samples.push_back(7.0 + 3.0 * std::cos(2 * std::numbers::pi * 170 * t) +
                      0.6 * std::sin(2 * std::numbers::pi * 2900 * t));
  }
  signal::Spectrum s = signal::amplitude_spectrum(samples, kStep);
  REQUIRE(s.frequency.size() == kSamples / 2);
  CHECK(s.frequency[16] == Approx(170.0));
  // Whole periods in the record, so only rounding separates the bins from the exact heights.
  CHECK(s.amplitude[16] == Approx(3.0).epsilon(1e-9));
  CHECK(s.amplitude[289] == Approx(0.6).epsilon(1e-9));
  CHECK(s.amplitude[100] < 1e-9);
  for (const Window window : {Window::Hann, Window::FlatTop}) {
    const signal::Spectrum shaped = signal::amplitude_spectrum(samples, kStep, window);
    CHECK(shaped.amplitude[16] == Approx(3.0).epsilon(1e-9));
    CHECK(shaped.amplitude[289] == Approx(0.6).epsilon(1e-9));
  }
  scale_spectrum(s, SpectrumScale::Decibel);
  CHECK(s.amplitude[16] == Approx(20.0 * std::log10(3.0)));
  CHECK(s.amplitude[289] == Approx(20.0 * std::log10(0.6)));
  const signal::Spectrum still =
      signal::amplitude_spectrum(std::vector<double>(500, 3.3e-5), kStep);
  CHECK(*std::max_element(still.amplitude.begin(), still.amplitude.end()) == 0.0);
}

TEST_CASE("spectrum: nearly equal steps → amplitude of a fast wave is correct", "[unit][adrplot]") {
  // As a run has them: shorter ones at its start, a few on the way, and the last one.
  constexpr double kStep = 1.7e-5, kFrequency = 25e3;
  std::vector<double> times{0.0, 0.36 * kStep, 1.17 * kStep}, values;
  for (int i = 0; i < 1750; ++i)
    times.push_back(times.back() + (i % 400 == 399 ? 0.99 : 1.0) * kStep);
  times.push_back(times.back() + 0.5 * kStep);
  for (const double t : times) values.push_back(std::sin(2.0 * std::numbers::pi * kFrequency * t));
  const signal::Samples samples = signal::equally_spaced_samples(times, values);
  CHECK(samples.resampled);
  CHECK(samples.step == Approx(kStep).epsilon(1e-4));
  const std::size_t third = samples.values.size() / 3;
  for (std::size_t part = 0; part < 3; ++part) {  // in no part of the run it fades
    double square = 0.0;
    for (std::size_t i = part * third; i < (part + 1) * third; ++i)
      square += samples.values[i] * samples.values[i] / static_cast<double>(third);
    CHECK(std::sqrt(2.0 * square) > 0.9);
  }
}

TEST_CASE("spectrum: shorter last step omitted, unequal steps resampled with a note", "[unit]") {
  std::vector<double> times, values;
  for (int i = 0; i < 100; ++i) {
    times.push_back(i * 1.25e-5);
    values.push_back(3.0 * times.back());
  }
  CHECK(signal::equally_spaced_samples(times, values).step == Approx(1.25e-5));
  CHECK(sampling_note(signal::equally_spaced_samples(times, values), times.size()).empty());
  times.back() -= 1e-5;  // the end of the run
  const signal::Samples cut = signal::equally_spaced_samples(times, values);
  CHECK(cut.values.size() == 99);
  CHECK(cut.step == Approx(1.25e-5));
  CHECK(sampling_note(cut, times.size()).find("not included") != std::string::npos);
  CHECK_FALSE(cut.resampled);
  for (std::size_t i = 0; i < 100; ++i) {
    times[i] = 1e-5 * static_cast<double>(i) + 3e-6 * static_cast<double>(i % 3);
    values[i] = 7.0 - 2e3 * times[i];  // straight lines read it off exactly
  }
  const signal::Samples uneven = signal::equally_spaced_samples(times, values);
  CHECK(uneven.resampled);
  CHECK(sampling_note(uneven, times.size()).find("Resampled") != std::string::npos);
  REQUIRE(uneven.values.size() == 100);
  for (std::size_t i = 0; i < 100; ++i)
    CHECK(uneven.values[i] ==
          Approx(7.0 - 2e3 * (uneven.start + uneven.step * static_cast<double>(i))));
  times.resize(5), values.resize(5);
  CHECK(sampling_note(signal::equally_spaced_samples(times, values), times.size())
            .find("at least 16") != std::string::npos);
}

TEST_CASE("page_builder: abscissa, units and orbit pair follow the options", "[unit]") {
  const auto race = test::synthetic_sol(SolKind::Race);
  const auto pages = plot_pages(race.kind, race.header);
  CHECK(build_page(race, pages, 3).panels[1].unit == "N.m");
  CHECK(build_page(race, pages, 2).x_unit == "rev");
  CHECK(build_page(race, pages, 2, {Abscissa::Time, {}}).x.back() ==
        Approx(race.steps.back().time));
  const auto orbit = build_page(race, pages, 5);
  CHECK(orbit.equal_axes);
  CHECK(orbit.panels[0].title == "Z position");
  CHECK(orbit.panels[0].curves[0].y[10] == race.steps[10].values[14]);
  CHECK(orbit.panels[0].curves[0].x[10] == race.steps[10].values[13]);
  CHECK(build_page(race, pages, 5, {Abscissa::Time, {0, 1}}).x_title == "X position");
  CHECK_THROWS_AS(build_page(race, pages, 10), InputError);
  CHECK_THROWS_AS(build_page(race, pages, 0), InputError);
}

TEST_CASE("page_builder: uneven steps → resampled for the spectrum page, with a note", "[unit]") {
  auto cage = test::synthetic_sol(SolKind::Cage);
  const auto pages = plot_pages(cage.kind, cage.header);
  const auto full = build_page(cage, pages, 21);
  REQUIRE(full.panels.size() == 3);
  CHECK(full.marks.at(0).x == Approx(10000.0 / 60.0).epsilon(1e-6));
  cage.steps.erase(cage.steps.begin() + 700, cage.steps.begin() + 720);
  const auto uneven = build_page(cage, pages, 21);
  CHECK(uneven.panels.size() == 3);
  CHECK(uneven.note.find("Resampled") != std::string::npos);
}

TEST_CASE("page_builder: revolutions accumulate in both directions; without rotation → time",
          "[unit]") {
  auto race = test::synthetic_sol(SolKind::Race);
  const auto pages = plot_pages(race.kind, race.header);
  const auto forward = build_page(race, pages, 2).x;
  for (auto& step : race.steps) step.revolutions = -step.revolutions;
  CHECK(build_page(race, pages, 2).x == forward);
  // Back and forth: two turning points, drawn side by side.
  for (std::size_t i = 0; i < race.steps.size(); ++i)
    race.steps[i].revolutions =
        1.0 - std::abs(1.0 - 2.0 * static_cast<double>(i) / double(race.steps.size() - 1));
  CHECK(build_page(race, pages, 2).x.back() == Approx(2.0).epsilon(1e-3));
  CHECK(std::is_sorted(forward.begin(), forward.end()));
  for (auto& step : race.steps) step.revolutions = 0.0;  // equal race speeds
  const auto alike = build_page(race, pages, 2);
  CHECK(alike.x_unit == "s");
  CHECK(alike.x.back() == race.steps.back().time);
  CHECK(alike.note.find("the abscissa is time") != std::string::npos);
  CHECK(build_page(race, pages, 2, {Abscissa::Step, {}}).x[3] == 60.0);
}

TEST_CASE("page_builder: zeros of quantities that were not computed → no values", "[unit]") {
  auto element = test::synthetic_sol(SolKind::Element);
  const auto pages = plot_pages(element.kind, element.header);
  for (auto& step : element.steps) {
    for (const int film : {25, 26, 29, 30}) step.values[static_cast<std::size_t>(film)] = 0.0;
    step.values[15] = 0.0;  // the outer contact is open
  }
  const auto slip = build_page(element, pages, 7);
  CHECK(slip.panels[2].message.find("No film") == 0);
  CHECK(std::isnan(slip.panels[2].curves[0].y[5]));
  CHECK(build_page(element, pages, 8)
            .panels[1]
            .message.find("Contact temperature rise was not computed") == 0);
  const auto load = build_page(element, pages, 6);
  CHECK(load.panels[0].curves[0].y[5] == 0.0);
  CHECK(std::isnan(load.panels[1].curves[0].y[5]));  // an open contact has no angle
  CHECK(std::isfinite(load.panels[1].curves[1].y[5]));

  auto cage = test::synthetic_sol(SolKind::Cage);
  for (auto& step : cage.steps)
    for (const std::size_t land2 : {6, 7, 8}) step.values[land2] = 0.0;
  const auto cage_pages = plot_pages(cage.kind, cage.header);
  CHECK(build_page(cage, cage_pages, 3).panels[0].message.find("no guide land 2") !=
        std::string::npos);
  CHECK(build_page(cage, cage_pages, 2).panels[0].message.empty());

  auto power = test::synthetic_sol(SolKind::Power);
  for (const std::size_t wear : {9, 10, 11, 12}) power.steps.front().values[wear] = 0.0;
  const auto wear = build_page(power, plot_pages(power.kind, power.header), 3);
  for (const auto& panel : wear.panels)
    for (const auto& curve : panel.curves) {
      INFO(panel.title << " " << curve.name);
      CHECK(std::isnan(curve.y[0]));
      CHECK(std::isfinite(curve.y[1]));
    }
}

TEST_CASE("page_builder: missing flange → no gap", "[unit]") {
  test::SyntheticRun run;
  run.steps = 20;
  auto roller = test::synthetic_sol(SolKind::Element, run);
  roller.header.bearing_type = 2;
  roller.header.value_count = 45;
  roller.header.outer_flange = true;
  for (auto& step : roller.steps) {
    step.values.resize(45, 0.0);
    for (std::size_t i = 27; i < 45; ++i) step.values[i] = 0.0;
    step.values[27] = 12.0;   // load at -x
    step.values[29] = -2e-7;  // gap at -x
  }
  const auto page = build_page(roller, plot_pages(roller.kind, roller.header), 9);
  CHECK(page.panels[0].curves[0].y[3] == 12.0);
  CHECK(std::isnan(page.panels[0].curves[1].y[3]));
  CHECK(page.panels[1].curves[0].y[3] == -2e-7);
  CHECK(std::isnan(page.panels[1].curves[1].y[3]));
  CHECK(page.note.find("no flange") != std::string::npos);
}

TEST_CASE("page_builder: storing interval too long for the fastest contact → note", "[unit]") {
  const auto race = test::synthetic_sol(SolKind::Race);  // every 12 us: 83 kHz
  const auto pages = plot_pages(race.kind, race.header);
  constexpr int kAcceleration = 4;  // a page without a note
  CHECK(build_page(race, pages, kAcceleration, {}, {{}, 41e3, ""}).note.find("Aliased") ==
        std::string::npos);
  CHECK(build_page(race, pages, kAcceleration, {}, {{}, 43e3, ""}).note.find("Aliased") == 0);
  // Also spectra and spectrograms, which are folded into the drawing.
  for (const Domain domain : {Domain::Spectrum, Domain::Spectrogram}) {
    PageOptions options;
    options.domain = domain;
    const std::string note = build_page(race, pages, kAcceleration, options, {{}, 43e3, ""}).note;
    INFO(note);
    CHECK(note.find("Aliased: the fastest contact vibration is 43 kHz") == 0);
    CHECK(note.find("higher frequencies") != std::string::npos);
    CHECK(build_page(race, pages, kAcceleration, options, {{}, 41e3, ""}).note.find("Aliased") ==
          std::string::npos);
  }
}

TEST_CASE("page_builder: few values per vibration period → note on missing peaks", "[unit]") {
  const std::string said = "steps per period. Shape and peaks are not reliable";
  const auto noted = [&](SolKind kind, int page, double frequency, bool banded = false) {
    const auto file = test::synthetic_sol(kind);  // every 12 us: 83 kHz
    const auto pages = plot_pages(file.kind, file.header);
    PageContext context{{}, frequency, ""};
    const std::vector<double> none(file.steps.size(), 0.0);
    if (banded)
      for (const auto& panel : pages.at(static_cast<std::size_t>(page - 1)).panels)
        for (const auto& curve : panel.curves) context.bands[curve.column] = {none, none};
    const std::string note = build_page(file, pages, page, {}, context).note;
    INFO(note);
    const bool out = note.find(said) != std::string::npos;
    CHECK((note.find("Aliased") == std::string::npos || !out));
    return out;
  };
  constexpr int kVelocities = 1;
  CHECK(noted(SolKind::Element, kVelocities, 41e3));  // 2.03 values a period
  CHECK(noted(SolKind::Element, kVelocities, 14.5e3));
  CHECK_FALSE(noted(SolKind::Element, kVelocities, 13.5e3));  // 6.2
  CHECK_FALSE(noted(SolKind::Element, kVelocities, 43e3));    // that is "Aliased"
  CHECK_FALSE(noted(SolKind::Element, kVelocities, 0.0));     // nobody knows
  CHECK_FALSE(noted(SolKind::Element, kVelocities, 41e3, true));
  // Quantities without vibration: wear and temperatures.
  const auto power = test::synthetic_sol(SolKind::Power);
  const auto pages = plot_pages(power.kind, power.header);
  for (std::size_t p = 1; p < pages.size(); ++p) {
    const std::string& column = pages[p].panels.front().curves.front().column;
    INFO(column);
    const bool of_contacts = column == "power.loss" || column.starts_with("race.applied_");
    CHECK(noted(SolKind::Power, static_cast<int>(p + 1), 41e3) == of_contacts);
  }
}

TEST_CASE("render_plots: every page of files on disk becomes a picture with curves in it",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  std::vector<std::filesystem::path> files;
  test::SyntheticRun run;
  run.steps = 300;
  for (const auto kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
    const auto file = test::synthetic_sol(kind, run);
    files.push_back(base / file.path);
    test::write_text(files.back(), test::sol_text(file));
  }
  RenderOptions options;
  options.folder = base / "pictures" / "deep";
  const auto pictures = render_plots(files, options);
  REQUIRE(pictures.size() == 8 + 21 + 9 + 6);
  CHECK(pictures.front().filename() == "SOL1-page-01.png");
  CHECK(pictures.back().filename() == "SOL7-page-06.png");
  for (const auto& path : pictures) {
    const QImage image(QString::fromStdString(path.string()));
    INFO(path);
    REQUIRE(image.size() == QSize(1280, 800));
    CHECK(distinct_colours(image) > 20);
  }
  options.page = 2;
  options.width = 640, options.height = 480;
  options.range = {1, 50, 5};
  CHECK(render_plots({files[0]}, options).size() == 1);
  // The folder of a run stands for its files; a folder without files is reported and nothing is
  // written.
  CHECK(render_plots({base}, options) == render_plots(files, options));
  options.folder = base / "none";
  CHECK_THROWS_WITH(render_plots({base / "pictures"}, options), Catch::Contains("no plot file"));
  CHECK_FALSE(std::filesystem::exists(options.folder));
  options.folder = base / "pictures";
  const auto note = [&](long to) { return open_document(files[0], {1, to, 1}).build(1, {}).note; };
  CHECK_THAT(note(299),
             Catch::Contains("Shown: stored steps 1 to 299 (the file contains more steps)."));
  CHECK_THAT(note(300), !Catch::Contains("the file contains more steps"));
  options.page = 9;
  CHECK_THROWS_WITH(render_plots({files[0]}, options), Catch::Contains("pages are 1 to 8"));
  CHECK_THROWS_AS(render_plots({base / "absent"}, options), InputError);
}

TEST_CASE("render_plots: page that some files lack → drawn for the others, missing ones named",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::SyntheticRun run;
  run.steps = 30;
  std::map<std::string, int> pages;  // of each file
  for (const auto kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
    const auto file = test::synthetic_sol(kind, run);
    test::write_text(base / file.path, test::sol_text(file));
    pages[file.path.string()] = static_cast<int>(open_document(base / file.path).pages.size());
  }
  const auto [least, most] = std::minmax_element(
      pages.begin(), pages.end(), [](auto& a, auto& b) { return a.second < b.second; });
  RenderOptions options;
  options.width = 200, options.height = 150;
  options.folder = base / "pictures";
  long counted = 0;
  options.progress = [&](long done, long) { counted = done; };
  for (int page = least->second; page <= most->second; ++page) {
    std::string told;
    options.tell = [&](const std::string& sentence) { told += sentence + "\n"; };
    options.page = page;
    std::string drawn;
    for (const auto& picture : render_plots({base}, options)) drawn += picture.string() + "\n";
    CHECK(counted == 4);
    for (const auto& [name, count] : pages) {
      INFO(page << " of " << name << ": " << drawn << told);
      CHECK((drawn.find(name + "-page") != std::string::npos) == (count >= page));
      const std::string sentence = fmt::format("{} has {} pages: page {} was not drawn",
                                               (base / name).string(), count, page);
      CHECK((told.find(sentence) != std::string::npos) == (count < page));
    }
  }
  options.page = most->second + 1;
  CHECK_THROWS_WITH(
      render_plots({base}, options),
      Catch::Contains(fmt::format("none of the files has a page {}: ", options.page)) &&
          Catch::Contains(fmt::format("{} has {} pages", least->first, least->second)));
}

TEST_CASE("plot_document: file larger than memory → read for a few pages at a time", "[gui]") {
  // As it is; without any contact, land or motion; and open at every third step.
  const auto nothing = [](std::size_t) { return true; };
  const auto third = [](std::size_t step) { return step % 3 == 0; };
  const auto never = [](std::size_t) { return false; };
  const auto check = [](SolKind kind, auto zero) {
    QTemporaryDir folder;
    results::SolFile file = test::synthetic_sol(kind);
    const std::filesystem::path path = folder.path().toStdString() + "/" + file.path.string();
    for (std::size_t i = 0; i < file.steps.size(); ++i)
      if (zero(i)) std::fill(file.steps[i].values.begin(), file.steps[i].values.end(), 0.0);
    test::write_text(path, test::sol_text(file));
    const PlotDocument whole = open_document(path);
    const auto same = [&](int number, PageOptions options) {
      // Each page separately, without the columns of other pages.
      const PlotDocument pieces = open_document(path, {}, 1000);
      REQUIRE(pieces.pages.size() == whole.pages.size());
      const desktop::ChartPage a = whole.build(number, options), b = pieces.build(number, options);
      CAPTURE(file.path, number);
      CHECK(a.x == b.x);
      CHECK(a.note == b.note);
      CHECK(a.x_title == b.x_title);
      CHECK(a.guide_radius == b.guide_radius);
      REQUIRE(a.panels.size() == b.panels.size());
      const auto equal = [](const std::vector<double>& p, const std::vector<double>& q) {
        return std::equal(p.begin(), p.end(), q.begin(), q.end(), [](double v, double w) {
          return v == w || (std::isnan(v) && std::isnan(w));
        });
      };
      for (std::size_t p = 0; p < a.panels.size(); ++p) {
        REQUIRE(a.panels[p].curves.size() == b.panels[p].curves.size());
        CHECK(a.panels[p].title == b.panels[p].title);
        CHECK(a.panels[p].unit == b.panels[p].unit);
        CHECK(a.panels[p].message == b.panels[p].message);
        for (std::size_t c = 0; c < a.panels[p].curves.size(); ++c)
          CHECK(equal(a.panels[p].curves[c].y, b.panels[p].curves[c].y));
      }
    };
    for (int number = 1; number <= static_cast<int>(whole.pages.size()); ++number) {
      same(number, {});
      if (whole.pages[static_cast<std::size_t>(number - 1)].kind == PageKind::Orbit)
        same(number, {.orbit = {0, 1}});
    }
    // From one page to another and back.
    const PlotDocument pieces = open_document(path, {}, 1000);
    const int last = static_cast<int>(whole.pages.size());
    for (const int number : {1, last, 1})
      CHECK(pieces.build(number, {}).note == whole.build(number, {}).note);
  };
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
    check(kind, never);
    check(kind, nothing);
    check(kind, third);
  }
}
