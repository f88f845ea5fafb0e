#include "adrplot/own_chart.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/range_dialog.hpp"
#include "adrplot/render.hpp"
#include "adrplot/spectrum.hpp"
#include "base/errors.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "results/channels.hpp"
#include "support/drops.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QAction>
#include <QApplication>
#include <QChart>
#include <QComboBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QTreeWidget>
#include <QValueAxis>
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

void press(PlotWindow& window, const QString& button) {
  for (auto* action : window.findChild<QToolBar*>("buttons")->actions())
    if (action->text() == button) return action->trigger();
  FAIL("no button " << button.toStdString());
}

/// Text of the message shown, which is then closed; empty when there is none.
QString take_message(QWidget& window) {
  auto* box = window.findChild<QMessageBox*>("message");
  if (!box) return {};
  const QString text = box->text();
  box->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  return text;
}

int distinct_colours(const QImage& image) {
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); y += 2)
    for (int x = 0; x < image.width(); x += 2) colours.insert(image.pixel(x, y));
  return static_cast<int>(colours.size());
}

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
  CHECK(count(SolKind::Power, as_is) == 5);
  CHECK(count(SolKind::Power, [](auto& h) { h.value_count = 17; }) == 4);
  CHECK(count(SolKind::Element, as_is) == 8);
  CHECK(count(SolKind::Element, [](auto& h) { h.outer_flange = true; }) ==
        8);  // balls have no flanges
  CHECK(count(SolKind::Element,
              [](auto& h) { h.bearing_type = 2, h.value_count = 45, h.outer_flange = true; }) == 9);
  CHECK(count(SolKind::Element, [](auto& h) {
          h.bearing_type = 2, h.value_count = 45, h.outer_flange = h.inner_flange = true;
        }) == 10);
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
      const auto pages = plot_pages(kind, header);
      const std::set<std::string> there = stored(header), shown = drawn(pages);
      for (const std::string& column : shown) {
        INFO(column);
        CHECK(there.count(column) == 1);
      }
      for (const std::string& column : there) {
        INFO(column);
        // phi belongs to spherical pockets; the manual has no page for a race's polar position.
        // Bulk temperatures give way to the page of the thermal model where the file has one.
        const bool left_out =
            (kind == SolKind::Power && column.find("temperature") != column.npos) ||
            (!spherical && column.starts_with("pocket.phi")) ||
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

TEST_CASE("plot_pages: short element files say what is missing instead of showing it", "[unit]") {
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
  Spectrum s = amplitude_spectrum(samples, kStep);
  REQUIRE(s.frequency.size() == kSamples / 2);
  CHECK(s.frequency[16] == Approx(170.0));
  // Whole periods in the record, so only rounding separates the bins from the exact heights.
  CHECK(s.amplitude[16] == Approx(3.0).epsilon(1e-9));
  CHECK(s.amplitude[289] == Approx(0.6).epsilon(1e-9));
  CHECK(s.amplitude[100] < 1e-9);
  for (const Window window : {Window::Hann, Window::FlatTop}) {
    const Spectrum shaped = amplitude_spectrum(samples, kStep, window);
    CHECK(shaped.amplitude[16] == Approx(3.0).epsilon(1e-9));
    CHECK(shaped.amplitude[289] == Approx(0.6).epsilon(1e-9));
  }
  scale_spectrum(s, SpectrumScale::Decibel);
  CHECK(s.amplitude[16] == Approx(0.0).margin(1e-9));
  CHECK(s.amplitude[289] == Approx(20.0 * std::log10(0.2)));
  const Spectrum still = amplitude_spectrum(std::vector<double>(500, 3.3e-5), kStep);
  CHECK(*std::max_element(still.amplitude.begin(), still.amplitude.end()) == 0.0);
}

TEST_CASE("spectrum: a shorter last step is left out, unequal steps are resampled and said so",
          "[unit]") {
  std::vector<double> times, values;
  for (int i = 0; i < 100; ++i) {
    times.push_back(i * 1.25e-5);
    values.push_back(3.0 * times.back());
  }
  CHECK(equal_samples(times, values).step == Approx(1.25e-5));
  CHECK(equal_samples(times, values).note.empty());
  times.back() -= 1e-5;  // the end of the run
  const Samples cut = equal_samples(times, values);
  CHECK(cut.values.size() == 99);
  CHECK(cut.step == Approx(1.25e-5));
  CHECK(cut.note.find("left out") != std::string::npos);
  CHECK_FALSE(cut.resampled);
  for (std::size_t i = 0; i < 100; ++i) {
    times[i] = 1e-5 * static_cast<double>(i) + 3e-6 * static_cast<double>(i % 3);
    values[i] = 7.0 - 2e3 * times[i];  // straight lines read it off exactly
  }
  const Samples uneven = equal_samples(times, values);
  CHECK(uneven.resampled);
  CHECK(uneven.note.find("Resampled") != std::string::npos);
  REQUIRE(uneven.values.size() == 100);
  for (std::size_t i = 0; i < 100; ++i)
    CHECK(uneven.values[i] ==
          Approx(7.0 - 2e3 * (uneven.start + uneven.step * static_cast<double>(i))));
  times.resize(5), values.resize(5);
  CHECK(equal_samples(times, values).note.find("at least 16") != std::string::npos);
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

TEST_CASE("page_builder: an uneven run is resampled for its spectrum page, and it says so",
          "[unit]") {
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

TEST_CASE("page_builder: turns accumulate whatever the direction, and time takes over without them",
          "[unit]") {
  auto race = test::synthetic_sol(SolKind::Race);
  const auto pages = plot_pages(race.kind, race.header);
  const auto forward = build_page(race, pages, 2).x;
  for (auto& step : race.steps) step.revolutions = -step.revolutions;
  CHECK(build_page(race, pages, 2).x == forward);
  // There and back: two turns, drawn side by side.
  for (std::size_t i = 0; i < race.steps.size(); ++i)
    race.steps[i].revolutions =
        1.0 - std::abs(1.0 - 2.0 * static_cast<double>(i) / double(race.steps.size() - 1));
  CHECK(build_page(race, pages, 2).x.back() == Approx(2.0).epsilon(1e-3));
  CHECK(std::is_sorted(forward.begin(), forward.end()));
  for (auto& step : race.steps) step.revolutions = 0.0;  // both races turn alike
  const auto alike = build_page(race, pages, 2);
  CHECK(alike.x_unit == "s");
  CHECK(alike.x.back() == race.steps.back().time);
  CHECK(alike.note.find("drawn over time") != std::string::npos);
  CHECK(build_page(race, pages, 2, {Abscissa::Step, {}}).x[3] == 60.0);
}

TEST_CASE("page_builder: zeros that nobody computed are no values", "[unit]") {
  auto element = test::synthetic_sol(SolKind::Element);
  const auto pages = plot_pages(element.kind, element.header);
  for (auto& step : element.steps) {
    for (const int film : {25, 26, 29, 30}) step.values[static_cast<std::size_t>(film)] = 0.0;
    step.values[15] = 0.0;  // the outer contact is open
  }
  const auto slip = build_page(element, pages, 7);
  CHECK(slip.panels[2].message.find("No film") == 0);
  CHECK(std::isnan(slip.panels[2].curves[0].y[5]));
  CHECK(build_page(element, pages, 8).panels[1].message.find("No temperature rise") == 0);
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

TEST_CASE("page_builder: a flange that is not there has no gap", "[unit]") {
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

TEST_CASE("page_builder: what is stored too seldom for the fastest contact says so", "[unit]") {
  const auto race = test::synthetic_sol(SolKind::Race);  // every 12 us: 83 kHz
  const auto pages = plot_pages(race.kind, race.header);
  CHECK(build_page(race, pages, 2, {}, {{}, 41e3, ""}).note.empty());
  CHECK(build_page(race, pages, 2, {}, {{}, 43e3, ""}).note.find("Aliased") == 0);
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
  REQUIRE(pictures.size() == 8 + 21 + 9 + 5);
  CHECK(pictures.front().filename() == "SOL1-page-01.png");
  CHECK(pictures.back().filename() == "SOL7-page-05.png");
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
  const auto note = [&](long to) { return open_document(files[0], {1, to, 1}).build(1, {}).note; };
  CHECK_THAT(note(299), Catch::Contains("Stored steps 1 to 299; more follow in the file."));
  CHECK_THAT(note(300), !Catch::Contains("more follow"));
  options.page = 9;
  CHECK_THROWS_WITH(render_plots({files[0]}, options), Catch::Contains("pages are 1 to 8"));
  CHECK_THROWS_AS(render_plots({base / "absent"}, options), InputError);
}

TEST_CASE("plot_document: a file too long to be held is read for a few pages at a time", "[gui]") {
  QTemporaryDir folder;
  const std::filesystem::path path = folder.path().toStdString() + "/SOL1";
  test::write_text(path, test::sol_text(test::synthetic_sol(SolKind::Element)));
  const PlotDocument whole = open_document(path), pieces = open_document(path, {}, 1000);
  REQUIRE(pieces.pages.size() == whole.pages.size());
  const auto same = [&](int number) {
    const desktop::ChartPage a = whole.build(number, {}), b = pieces.build(number, {});
    INFO("page " << number);
    CHECK(a.x == b.x);
    CHECK(a.note == b.note);
    REQUIRE(a.panels.size() == b.panels.size());
    for (std::size_t p = 0; p < a.panels.size(); ++p) {
      REQUIRE(a.panels[p].curves.size() == b.panels[p].curves.size());
      CHECK(a.panels[p].unit == b.panels[p].unit);
      for (std::size_t c = 0; c < a.panels[p].curves.size(); ++c)
        CHECK(a.panels[p].curves[c].y == b.panels[p].curves[c].y);
    }
  };
  for (int number = 1; number <= static_cast<int>(whole.pages.size()); ++number) same(number);
  same(1);
}

TEST_CASE("plot_window: pages turn to both ends with a message there", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.show();
  window.addFile(test::synthetic_sol(SolKind::Element));
  CHECK(window.currentPage() == 1);
  press(window, "Prev Plot");
  CHECK(take_message(window) == "This is the first plot.");
  CHECK(window.currentPage() == 1);
  for (int page = 2; page <= 8; ++page) {
    press(window, "Next Plot");
    CHECK(window.currentPage() == page);
    CHECK(take_message(window).isEmpty());
    CHECK_FALSE(window.view().chartScene().charts().empty());
    for (std::size_t i = 0; i < window.view().chartScene().charts().size(); ++i)
      CHECK(window.view().chartScene().linesOf(i) > 0);
  }
  press(window, "Next Plot");
  CHECK(take_message(window) == "This is the last plot.");
  CHECK(window.currentPage() == 8);
  CHECK(window.windowTitle().contains("page 8 of 8"));
}

TEST_CASE("plot_window: Plot Number and the page tree go to a page", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Cage));
  press(window, "Plot Number");
  auto* question = window.findChild<QInputDialog*>("number");
  REQUIRE(question);
  CHECK(question->intMaximum() == 21);
  question->setIntValue(14);
  question->accept();
  CHECK(window.currentPage() == 14);
  auto* tree = window.findChild<QTreeWidget*>("pages");
  tree->setCurrentItem(tree->topLevelItem(0)->child(1));
  CHECK(window.currentPage() == 2);
}

TEST_CASE("plot_window: orbit page offers other pairs, history pages another abscissa", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Race));
  auto& scene = window.view().chartScene();
  auto* orbit = window.findChild<QComboBox*>("orbit");
  auto* abscissa = window.findChild<QComboBox*>("abscissa");
  window.showPage(2);
  CHECK(scene.page().x_unit == "rev");
  abscissa->setCurrentIndex(1);
  CHECK(scene.page().x_unit == "s");
  window.showPage(5);
  REQUIRE(scene.page().equal_axes);
  CHECK_FALSE(abscissa->isEnabled());
  CHECK(scene.page().x_title == "Y position");
  orbit->setCurrentIndex(1);
  CHECK(scene.page().x_title == "X position");
  CHECK(scene.page().panels[0].title == "Z position");
  CHECK(scene.plotAreas()[0].width() == Approx(scene.plotAreas()[0].height()));
  auto* chart = scene.charts()[0];
  auto* x = qobject_cast<QValueAxis*>(chart->axes(Qt::Horizontal).front());
  auto* y = qobject_cast<QValueAxis*>(chart->axes(Qt::Vertical).front());
  CHECK(x->max() - x->min() == Approx(y->max() - y->min()));  // equal axes
}

TEST_CASE("plot_window: files are opened, refused with a reason, and truncated ones explained",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::SyntheticRun run;
  run.steps = 60;
  const std::string text = test::sol_text(test::synthetic_sol(SolKind::Element, run));
  test::write_text(base / "SOL1", text);
  test::write_text(base / "cut", text.substr(0, text.size() - 150));
  test::write_text(base / "letter.txt", "Dear reader,\nthis is no result file.\n");
  PlotWindow window;
  CHECK(window.openFile(base / "SOL1", {1, 40, 2}));
  CHECK(window.view().chartScene().page().x.size() == 20);
  auto* note = window.findChild<QLabel*>("note");
  CHECK(note->text().isEmpty());
  CHECK_FALSE(window.openFile(base / "letter.txt"));
  CHECK(take_message(window).contains("letter.txt"));
  CHECK(window.fileCount() == 1);
  CHECK_FALSE(window.openFile(base / "nowhere"));
  CHECK_FALSE(take_message(window).isEmpty());
  CHECK(window.openFile(base / "cut"));
  CHECK(note->text().contains("incomplete"));
  CHECK(window.view().chartScene().page().x.size() == 59);
  CHECK(window.fileCount() == 2);
  test::write_text(base / "cut", text);
  press(window, "Reload");
  CHECK(window.view().chartScene().page().x.size() == 60);
  CHECK(note->text().isEmpty());
}

TEST_CASE("plot_window: a dropped file asks for its range, several are opened at once", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::SyntheticRun run;
  run.steps = 30;
  const std::string text = test::sol_text(test::synthetic_sol(SolKind::Element, run));
  test::write_text(base / "SOL1", text);
  test::write_text(base / "SOL2", text);
  PlotWindow window;
  window.show();
  const auto drop = [&](const QStringList& names) {
    CHECK(test::drop_on(window, folder.path(), names));
  };
  drop({"SOL1", "SOL2"});
  CHECK(window.fileCount() == 2);
  drop({"SOL2"});
  auto* dialog = window.findChild<RangeDialog*>();
  REQUIRE(dialog != nullptr);
  dialog->reject();
  CHECK(window.fileCount() == 2);
  // Anywhere: on the chart, the tree of files, the menu, the tool bar, and a folder as well.
  QDir(folder.path()).mkdir("run");
  test::write_text(base / "run" / "SOL1", text);
  int more = 2;
  for (const QPoint& place : test::places_of(window)) {
    INFO(place.x() << ", " << place.y());
    CHECK(test::drop_on(window, folder.path(), {"SOL1", "run"}, place));
    CHECK(window.fileCount() > more);
    more = window.fileCount();
  }
  QMimeData words;
  words.setText("SOL1");
  CHECK_FALSE(test::drop_on(window, words, window.view().geometry().center()));
}

TEST_CASE("range_dialog: starts with the whole run and keeps the end behind the start", "[gui]") {
  test::use_qt();
  RangeDialog dialog("SOL1", 9000);
  dialog.setAttribute(Qt::WA_DeleteOnClose, false);
  CHECK(dialog.range().from == 1);
  CHECK(dialog.range().to == results::SolRange{}.to);  // the end, also when the file grows
  CHECK(dialog.findChild<QLabel*>("count")->text() == "9000 of 9000 stored steps");
  CHECK(dialog.range().every == 1);
  dialog.findChild<QSpinBox*>("to")->setValue(100);
  dialog.findChild<QSpinBox*>("from")->setValue(8000);
  CHECK(dialog.range().to == 8000);
  dialog.findChild<QSpinBox*>("every")->setValue(10);
  CHECK(dialog.range().every == 10);
}

TEST_CASE("plot_window: Save JPG writes the page and proposes the next number", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  PlotWindow window;
  window.show();
  window.addFile(test::synthetic_sol(SolKind::Element));
  press(window, "Save JPG");
  auto* dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog);
  const QString name = folder.filePath("wave.jpg");
  emit dialog->fileSelected(name);
  dialog->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  const QImage image(name);
  CHECK(image.width() > 480);
  CHECK(distinct_colours(image) > 20);
  press(window, "Save JPG");
  dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog);
  REQUIRE(dialog->selectedFiles().size() == 1);
  CHECK(dialog->selectedFiles().front().endsWith("wave-2.jpg"));
  emit dialog->fileSelected("/proc/no/such/folder/x.jpg");
  CHECK(take_message(window).contains("cannot write"));
}

TEST_CASE("plot_window: the values of all panels under the mouse are read whole, at any size",
          "[gui]") {
  test::use_qt();
  PlotWindow window;
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power})
    window.addFile(test::synthetic_sol(kind));
  window.show();
  auto* label = window.findChild<QLabel*>("readout");
  REQUIRE(label != nullptr);
  auto* tree = window.findChild<QTreeWidget*>("pages");
  for (const QSize size : {QSize(1264, 770), QSize(700, 450)}) {
    window.resize(size);
    for (int file = 0; file < window.fileCount(); ++file)
      for (int page = 0; page < tree->topLevelItem(file)->childCount(); ++page) {
        tree->setCurrentItem(tree->topLevelItem(file)->child(page));
        QCoreApplication::processEvents();
        auto& scene = window.view().chartScene();
        if (scene.plotAreas().empty() || scene.page().equal_axes) continue;
        const QRectF& area = scene.plotAreas().back();
        for (const double part : {0.1, 0.37, 0.8}) {
          const QPointF place(area.left() + part * area.width(), area.center().y());
          emit window.view().readoutChanged(scene.readoutParts(place));
          INFO(window.windowTitle().toStdString() << ": " << label->text().toStdString());
          CHECK_FALSE(label->text().isEmpty());
          const QRect needed = label->fontMetrics().boundingRect(QRect(0, 0, label->width(), 1000),
                                                                 Qt::TextWordWrap, label->text());
          CHECK(needed.height() <= label->height());
          CHECK(needed.width() <= label->width());
          CHECK(window.rect().contains(QRect(label->mapTo(&window, QPoint()), label->size())));
        }
      }
  }
}

TEST_CASE(
    "plot_window: a chart of sixty curves keeps most of the window, and says what it leaves out",
    "[gui]") {
  test::use_qt();
  PlotWindow window;
  PlotDocument document;
  document.path = "many";
  document.pages = {{"Many", PageKind::History}};
  document.build = [](int, const PageOptions&) {
    desktop::ChartPage page;
    page.x_title = "Time", page.x_unit = "s";
    page.x = {0.0, 1.0, 2.0};
    page.panels = {{"Load", "N", {}}};
    for (int c = 0; c < 60; ++c)
      page.panels[0].curves.push_back(
          {"rolling element " + std::to_string(c + 1), {1.0 + c, 2.0 + c, 3.0 + c}, {}});
    return page;
  };
  std::vector<CurvePick> picks;
  for (std::size_t c = 0; c < 60; ++c) picks.push_back({&document, 1, 0, c});
  window.addChart(picks, Combine::Overlay);
  window.show();
  auto* label = window.findChild<QLabel*>("readout");
  auto& scene = window.view().chartScene();
  const auto read = [&](QSize size) {
    window.resize(size);
    QCoreApplication::processEvents();
    const QRectF area = scene.plotAreas().front();
    emit window.view().readoutChanged(scene.readoutParts(area.center()));
    CHECK(label->height() <= window.height() / 5 + 2);
    const QRect needed = label->fontMetrics().boundingRect(QRect(0, 0, label->width(), 5000),
                                                           Qt::TextWordWrap, label->text());
    CHECK(needed.height() <= label->height());
    return label->text();
  };
  const QString small = read({700, 450}), large = read({1264, 770});
  CHECK(QRegularExpression(" … [0-9]+ more$").match(small).hasMatch());
  CHECK(large.size() > small.size());
  // Without most of them the line is as low as what is left.
  const int high = label->height();
  for (int c = 1; c < 60; ++c) scene.showCurve(0, static_cast<std::size_t>(c), false);
  emit window.view().curvesChanged();
  CHECK(label->height() < high / 2);
  CHECK(read({1264, 770}).contains("rolling element 1"));
  CHECK(label->text().endsWith(" 2 N"));
}

TEST_CASE("plot_window: what is left out is counted by value, and what stays is whole", "[gui]") {
  test::use_qt();
  PlotWindow window;
  PlotDocument document;
  document.path = "many";
  document.pages = {{"Many", PageKind::History}};
  document.build = [](int, const PageOptions&) {
    desktop::ChartPage page;
    page.x_title = "Time", page.x_unit = "s";
    page.x = {0.0, 1.0, 2.0};
    for (const char* title : {"Load", "Speed, of the race", "Force"}) {
      page.panels.push_back({title, "N", {}});
      for (int c = 0; c < 40; ++c)
        page.panels.back().curves.push_back(
            {fmt::format("element {}, case a, outer", c + 1), {1.0, 2.0, 3.0}, {}});
    }
    return page;
  };
  std::vector<CurvePick> picks;
  for (std::size_t c = 0; c < 3; ++c) picks.push_back({&document, 1, c, 0});
  window.addChart(picks, Combine::Overlay);
  window.show();
  window.resize({700, 450});
  QCoreApplication::processEvents();
  window.view().showPage(document.build(1, {}));
  auto* label = window.findChild<QLabel*>("readout");
  auto& scene = window.view().chartScene();
  const auto whole = [&] {
    const QRect needed = label->fontMetrics().boundingRect(QRect(0, 0, label->width(), 5000),
                                                           Qt::TextWordWrap, label->text());
    return needed.height() <= label->height();
  };
  const QStringList all = scene.readoutParts(scene.plotAreas().back().center());
  REQUIRE(all.size() == 120);
  CHECK(all.join("") == scene.readout(scene.plotAreas().back().center()));
  emit window.view().readoutChanged(all);
  const auto told = label->text().count(" N");
  CHECK(told > 0);
  CHECK(label->text().endsWith(QString(" … %1 more").arg(120 - told)));
  CHECK(whole());
  // A smaller window has room for less of the same; other curves have other values.
  window.resize({500, 420});
  QCoreApplication::processEvents();
  CHECK(whole());
  CHECK(label->text().endsWith(QString(" … %1 more").arg(120 - label->text().count(" N"))));
  emit window.view().curvesChanged();
  CHECK(label->text().isEmpty());
  // One value without room is shortened, and nothing more is promised.
  emit window.view().readoutChanged({QString("a name of the run's own ").repeated(200) + "2 N"});
  CHECK(label->text().contains("…"));
  CHECK_FALSE(label->text().contains("more"));
  CHECK(whole());
}

TEST_CASE("plot_window: the wheel zooms and the pointer reads values", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.show();
  window.addFile(test::synthetic_sol(SolKind::Element));
  auto& view = window.view();
  auto& scene = view.chartScene();
  const QPoint middle = view.mapFromScene(scene.plotAreas()[1].center());
  QWheelEvent wheel(middle, view.viewport()->mapToGlobal(middle), {}, {0, 240}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(view.viewport(), &wheel);
  CHECK(scene.viewHigh() - scene.viewLow() ==
        Approx(3.0 * 0.64).epsilon(1e-3));  // two notches of 0.8
  QSignalSpy readout(&view, &desktop::ChartView::readoutChanged);
  // Sent directly: a headless platform has no pointer that QTest could move.
  const QPointF there = middle + QPoint(3, 3);
  QMouseEvent move(QEvent::MouseMove, there, view.viewport()->mapToGlobal(there), Qt::NoButton,
                   Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(view.viewport(), &move);
  REQUIRE(readout.count() > 0);
  CHECK(readout.back().front().toStringList().join("").contains("Radial"));
  QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, middle);
  CHECK(scene.viewHigh() == Approx(3.0).epsilon(1e-6));
}
