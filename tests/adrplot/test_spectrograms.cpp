#include "adrplot/plot_window.hpp"
#include "adrplot/render.hpp"
#include "adrplot/run_beside.hpp"
#include "adrplot/spectrogram_page.hpp"
#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/heat_color.hpp"
#include "results/results_h5.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QComboBox>
#include <QImage>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QWidgetAction>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

/// Spectrograms and the marks of a run with variable speed.
using namespace adore;
using namespace adore::adrplot;
using Catch::Contains;

namespace {

constexpr double kStep = 1e-5, kTurn = 2.0 * std::numbers::pi;  // [s], [rad]

/// A shaft that begins with `speed` turns a second and gains `gain` of them in a second; the turns
/// of what has `order` times its frequency.
struct RunUp {
  double speed = 60.0, gain = 400.0;
  [[nodiscard]] double turns(double t, double order = 1.0) const {
    return order * (speed * t + 0.5 * gain * t * t);
  }
  [[nodiscard]] double frequency(double t, double order = 1.0) const {
    return order * (speed + gain * t);
  }
};

RunMotion motion_of_run(const RunUp& run, std::size_t steps, const std::vector<double>& orders) {
  RunMotion out;
  for (std::size_t i = 0; i < steps; ++i) {
    out.times.push_back(kStep * static_cast<double>(i));
    out.turns.push_back(run.turns(out.times.back()));
  }
  for (const double order : orders) {
    MarkEventCounts mark{std::to_string(order), {}, {}};
    for (std::size_t i = 0; i < steps; i += 40) {
      mark.time.push_back(out.times[i]);
      mark.turns.push_back(run.turns(out.times[i], order));
    }
    out.marks.push_back(mark);
  }
  return out;
}

desktop::ChartPage page_over(const RunMotion& motion, const RunUp& run, double order) {
  desktop::ChartPage page;
  page.title = "Loads";
  desktop::ChartCurve chirp{"outer race", {}, {}}, tone{"inner race", {}, {}};
  for (const double t : motion.times) {
    chirp.y.push_back(std::sin(kTurn * run.turns(t, order)));
    tone.y.push_back(4.0 * std::sin(kTurn * 2000.0 * t));
  }
  desktop::ChartCurve none{"outer race", std::vector<double>(chirp.y.size(), std::nan("")), {}};
  page.panels = {{"Load", "N", {chirp, tone}, false}, {"Angle", "deg", {none, chirp}, false}};
  page.panels[1].curves[1].name = "inner race";
  return page;
}

}  // namespace

TEST_CASE("spectrogram: selected curve → drawn and named", "[unit]") {
  const RunUp run{80.0, 0.0};
  const RunMotion motion = motion_of_run(run, 8000, {});
  const auto fall = [&](const std::string& of) {
    desktop::ChartPage page = page_over(motion, run, 5.0);
    to_spectrogram(page, motion, {Window::FlatTop, SpectrumScale::Units}, of);
    return page;
  };
  const auto largest = [](const desktop::ChartPage& page) {
    const desktop::ChartCurve& row = page.panels.at(0).curves.front();
    const auto most = std::max_element(row.y.begin(), row.y.end()) - row.y.begin();
    return std::pair(page.x[static_cast<std::size_t>(most)], row.y[static_cast<std::size_t>(most)]);
  };
  // Curves without values are not offered.
  const std::vector<std::string> names{"Load, outer race", "Load, inner race", "Angle, inner race"};
  struct Case {
    const char* asked;
    std::size_t chosen;
  };
  for (const Case& one : {Case{"", 0},
                          {"Load, inner race", 1},
                          {"load, INNER race", 1},
                          {"2", 1},
                          {"angle", 2},
                          {"3", 2},
                          {"4", 0},
                          {"0", 0},
                          {"film", 0}}) {
    const desktop::ChartPage page = fall(one.asked);
    INFO(one.asked);
    CHECK(page.choices == names);
    CHECK(page.chosen == one.chosen);
    CHECK(page.panels.at(0).title == names[one.chosen]);
    CHECK(page.panels[0].unit == (one.chosen == 2 ? "deg" : "N"));
    const auto [frequency, height] = largest(page);
    CHECK(frequency == Approx(one.chosen == 1 ? 2000.0 : 400.0).margin(160.0));
    CHECK(height == Approx(one.chosen == 1 ? 4.0 : 1.0).epsilon(0.05));
  }
  CHECK_FALSE(choice_of(names, "4"));
  CHECK_FALSE(choice_of(names, "film"));
}

TEST_CASE("spectrogram: run-up → ridge and marks at the frequency of each row", "[gui]") {
  test::use_qt();
  // Something at 7.3 times the frequency of the shaft, and a mark that counts just that.
  constexpr double kOrder = 7.3;
  const RunUp run;
  const RunMotion motion = motion_of_run(run, 40000, {1.0, kOrder, 0.05});
  desktop::ChartPage page = page_over(motion, run, kOrder);
  to_spectrogram(page, motion, {Window::Hann, SpectrumScale::Units}, "load, outer");
  const desktop::ChartPanel& panel = page.panels.at(0);
  REQUIRE(panel.rows);
  REQUIRE(panel.rows->at.size() == panel.curves.size());
  REQUIRE(panel.curves.size() > 50);
  REQUIRE(page.marks.size() == 3);
  CHECK(panel.rows->title == "Time");
  CHECK(panel.rows->unit == "s");
  CHECK(panel.unit == "N");
  const double spacing = page.x.front();  // of two lines [Hz]
  for (std::size_t i = 0; i < panel.curves.size(); i += 7) {
    const double t = panel.rows->at[i];
    for (const auto& [mark, order] : {std::pair{0, 1.0}, {1, kOrder}}) {
      const auto& [x, height] = page.marks[static_cast<std::size_t>(mark)].way.at(i);
      CHECK(x == Approx(run.frequency(t, order)).epsilon(2e-3));
      CHECK(height == t);
    }
    const std::vector<double>& y = panel.curves[i].y;
    const auto ridge = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
    CHECK(page.x[ridge] == Approx(run.frequency(t, kOrder)).margin(3.0 * spacing));
  }
  CHECK_THAT(page.note, Contains("The marks follow the shaft"));

  // Over speed: the ridge is a straight line through 0.
  desktop::ChartPage over_speed = page_over(motion, run, kOrder);
  SpectrumOptions options{Window::Hann, SpectrumScale::Decibel, true};
  to_spectrogram(over_speed, motion, options, "load, outer");
  const desktop::ChartPanel& speeds = over_speed.panels.at(0);
  CHECK(speeds.rows->title == "Shaft speed");
  CHECK(speeds.rows->unit == "rpm");
  CHECK(speeds.unit == "dB re 1 N");
  for (std::size_t i = 0; i < speeds.curves.size(); i += 7) {
    const std::vector<double>& y = speeds.curves[i].y;
    const auto ridge = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
    CHECK(over_speed.x[ridge] == Approx(speeds.rows->at[i] / 60.0 * kOrder).margin(3.0 * spacing));
  }

  // A shaft with constant speed has vertical marks, and no speed axis.
  const RunUp steady{60.0, 0.0};
  const RunMotion still = motion_of_run(steady, 40000, {1.0, kOrder, 0.05});
  page = page_over(still, steady, kOrder);
  to_spectrogram(page, still, options, "");
  CHECK(page.panels.at(0).rows->title == "Time");
  CHECK_THAT(page.note, Contains("The shaft speed is constant"));
  REQUIRE(page.marks.size() == 3);
  for (const desktop::ChartMark& mark : page.marks) CHECK(mark.way.empty());
  CHECK(page.marks[1].x == Approx(60.0 * kOrder));
}

TEST_CASE("spectrogram: pixels → color of the value that the readout gives", "[gui]") {
  test::use_qt();
  const RunUp run{80.0, 0.0};
  RunMotion motion = motion_of_run(run, 20000, {});
  desktop::ChartPage page = page_over(motion, run, 5.0);
  // 20 dB lower in the second half.
  auto& y = page.panels[0].curves[0].y;
  for (std::size_t i = y.size() / 2; i < y.size(); ++i) y[i] *= 0.1;
  to_spectrogram(page, motion, {Window::Hann, SpectrumScale::Decibel}, "1");
  page.subtitle = "a run";
  desktop::ChartScene scene;
  const QSize size(1280, 800);
  scene.setPageSize(size);
  scene.setPage(page);
  const QImage picture = scene.image(size);
  const desktop::ChartPanel& panel = scene.page().panels[0];
  const desktop::ChartMapRows& rows = *panel.rows;
  const QRectF area = scene.plotAreas()[0];
  CHECK(area.height() > 500.0);
  int compared = 0;
  // In the middle of wide cells: zoomed to some lines.
  scene.setView(200.0, 700.0);
  const QImage zoomed = scene.image(size);
  for (const std::size_t row : {std::size_t{3}, rows.at.size() / 2, rows.at.size() - 4})
    for (std::size_t k = 0; k < page.x.size(); ++k) {
      if (page.x[k] < 220.0 || page.x[k] > 680.0) continue;
      const QPoint at(static_cast<int>(std::lround(scene.sceneXAt(page.x[k]))),
                      static_cast<int>(std::lround(scene.sceneYAt(0, rows.at[row]))));
      const double share = (panel.curves[row].y[k] - rows.low) / (rows.high - rows.low);
      const QColor wanted = desktop::heat_color(share), drawn = zoomed.pixelColor(at);
      CHECK(std::abs(wanted.red() - drawn.red()) + std::abs(wanted.green() - drawn.green()) +
                std::abs(wanted.blue() - drawn.blue()) <
            24);
      ++compared;
      const QString told = scene.readout(QPointF(at));
      CHECK(told.contains(QString::fromStdString(
          desktop::pretty_quantity(panel.curves[row].y[k], panel.unit, scene.digitsOf(0, row)))));
    }
  CHECK(compared > 20);
  // The whole range of colors is used.
  CHECK(rows.high == Approx(0.0).margin(0.5));
  CHECK(rows.high - rows.low > 20.0);
}

TEST_CASE("plot_window: the curve of a spectrogram is chosen, or its panel clicked", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.resize(1400, 700);
  window.addFile(test::synthetic_sol(results::SolKind::Element));
  window.showPage(6);
  window.show();
  auto* choice = window.findChild<QComboBox*>("curve");
  REQUIRE(choice);
  const auto offered = [&] {  // next to the other choices, or below them in narrow windows
    for (const QAction* action : window.findChild<QToolBar*>("buttons")->actions())
      if (const auto* of = qobject_cast<const QWidgetAction*>(action);
          of != nullptr && of->defaultWidget() == choice)
        return action->isVisible();
    return false;
  };
  CHECK_FALSE(offered());  // of histories all curves are there
  desktop::ChartScene& scene = window.view().chartScene();
  const auto titled = [&] { return QString::fromStdString(scene.page().panels.at(0).title); };
  window.setDomain(Domain::Spectrogram);
  CHECK(offered());
  REQUIRE(choice->count() > 3);
  CHECK(choice->currentText() == titled());
  for (const int index : {choice->count() - 1, 1}) {
    const QString name = choice->itemText(index);
    choice->setCurrentIndex(index);
    emit choice->activated(index);
    CHECK(titled() == name);
    CHECK(choice->currentText() == name);
  }
  auto* menu = window.findChild<QMenu*>("curves");
  REQUIRE(menu);
  REQUIRE(menu->actions().size() == choice->count());
  menu->actions().at(2)->trigger();
  CHECK(titled() == choice->itemText(2));
  CHECK(menu->actions().at(2)->isChecked());
  // A panel that is clicked; one that is dragged is not.
  window.setDomain(Domain::Spectrum);
  CHECK_FALSE(offered());
  const auto place = [&](std::size_t panel) {
    return window.view().mapFromScene(scene.plotAreas().at(panel).center());
  };
  QTest::mouseClick(window.view().viewport(), Qt::LeftButton, {}, place(2));
  const std::string clicked = scene.page().panels[2].title;
  QTest::mousePress(window.view().viewport(), Qt::LeftButton, {}, place(1));
  QTest::mouseMove(window.view().viewport(), place(1) + QPoint(40, 0));
  QTest::mouseRelease(window.view().viewport(), Qt::LeftButton, {}, place(1) + QPoint(40, 0));
  window.setDomain(Domain::Spectrogram);
  CHECK(titled().startsWith(QString::fromStdString(clicked)));
}

TEST_CASE("render: a spectrogram of a named curve is drawn where there is one", "[gui]") {
  test::use_qt();
  const QTemporaryDir folder;
  const PlotDocument document = make_document(test::synthetic_sol(results::SolKind::Element));
  RenderOptions options;
  options.folder = folder.path().toStdString();
  parse_domain_options(options.view, "spectrogram", "Contact load");
  const auto written = render_document(document, "SOL1", options);
  CHECK(!written.empty());
  CHECK(written.size() < document.pages.size());
  parse_domain_options(options.view, "spectrogram", "no such curve");
  CHECK_THROWS_WITH(render_document(document, "SOL1", options),
                    Contains("no curve \"no such curve\"") && Contains("Contact load, outer race"));
  CHECK_THROWS_WITH(parse_domain_options(options.view, "spectrum", "load"),
                    Contains("--domain spectrogram"));
  CHECK_THROWS_WITH(parse_domain_options(options.view, "spectrum", "", "", "speed"),
                    Contains("--rows") && Contains("--domain spectrogram"));
  CHECK_THROWS_WITH(parse_domain_options(options.view, "history", "", "db"), Contains("--scale"));
  parse_domain_options(options.view, "spectrogram", "", "units");
  CHECK(options.view.spectrum.scale == SpectrumScale::Units);
  parse_domain_options(options.view, "spectrogram", "");
  CHECK(options.view.spectrum.scale == SpectrumScale::Automatic);
  parse_domain_options(options.view, "spectrogram", "", "db", "speed");
  CHECK(options.view.spectrum.scale == SpectrumScale::Decibel);
  CHECK(options.view.spectrum.over_speed);
}

TEST_CASE("spectrum scale: automatic → units for spectra, dB for spectrograms", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(results::SolKind::Power));
  const auto unit = [&] { return window.view().chartScene().page().panels.front().unit; };
  const auto choose = [&](const QString& text) {
    for (QAction* one : window.findChildren<QAction*>())
      if (one->text() == text) return one->trigger();
  };
  window.setDomain(Domain::Spectrum);
  CHECK(unit() == "W");
  window.setDomain(Domain::Spectrogram);
  CHECK(unit() == "dB re 1 W");
  choose("in units");
  CHECK(unit() == "W");
  window.setDomain(Domain::Spectrum);
  choose("automatic (spectrogram: in dB)");
  CHECK(unit() == "W");
  // As a session and a command set it.
  for (const auto& [scale, of_spectrogram] : {std::pair{SpectrumScale::Relative, "of largest"},
                                              {SpectrumScale::Automatic, "dB re 1 W"}}) {
    window.setSpectrum({signal::Window::Hann, scale});
    window.setDomain(Domain::Spectrogram);
    CHECK(unit() == of_spectrogram);
  }
}

TEST_CASE("spectrogram: low picture → about half of it is the map", "[gui]") {
  test::use_qt();
  // With the longest notes of a steady run: unequal steps, marks below the first line.
  RunUp run{300.0, 0.0};
  RunMotion motion = motion_of_run(run, 20000, {1.0, 0.4, 0.07, 0.05, 5.0, 7.1});
  for (std::size_t i = 1; i < motion.times.size(); i += 2) motion.times[i] += 0.3 * kStep;
  desktop::ChartPage page = page_over(motion, run, 5.0);
  to_spectrogram(page, motion, {}, "");
  REQUIRE(page.note.find("Resampled") != std::string::npos);
  page.subtitle = "a run";
  desktop::ChartScene scene;
  scene.setPageSize({700, 450});
  scene.setPage(page);
  INFO(page.note);
  CHECK(scene.plotAreas()[0].height() >= 0.45 * 450.0);
}

TEST_CASE("run_beside: what a mark counts goes with the speeds of a run that accelerates",
          "[unit][h5]") {
  // The inner race begins at 900 rad/s and gains 40,000 rad/s in a second; elements orbit at 0.4 of
  // that, and spin at 5/4 of it.
  using namespace adore::testing;
  TemporaryFolder folder;
  const bearing::Bearing bearing = make_bearing();
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  constexpr double kTurn = 2.0 * std::numbers::pi, kGain = 40e3;
  const auto n = static_cast<double>(bearing.balls().count);
  double last = 0.0;
  for (long step = 0; step <= 1203; ++step) {
    scene::Snapshot snapshot = make_snapshot(bearing, step);
    const double t = snapshot.time = last = 1e-5 * static_cast<double>(step);
    const double angle = 900.0 * t + 0.5 * kGain * t * t, speed = 900.0 + kGain * t;
    snapshot.races[0].total_rotation = 0.0;
    snapshot.races[1].total_rotation = angle;
    for (auto& element : snapshot.elements) {
      element.theta = 0.4 * angle;
      element.omega = {0.4 * speed + 0.75 * speed, speed, 0.0};
    }
    h5.write(recorder.record(snapshot));
  }
  h5.close();
  results::SolFile file = test::synthetic_sol(results::SolKind::Power);
  file.path = folder / "SOL7";
  file.header.run_id = results::H5Reader(folder / "RESULTS.h5").run_id();
  const PageContext context = page_context_of(file);
  const auto found = [&](const std::string& label, double from, double to) {
    for (const MarkEventCounts& mark : context.marks)
      if (mark.label == label) return frequency_between(mark, from, to);
    return 0.0;
  };
  for (const double part : {0.0, 0.3, 0.9}) {
    const double from = part * last, to = from + 0.1 * last;
    const double speed = (900.0 + kGain * 0.5 * (from + to)) / kTurn;
    INFO(part);
    CHECK(found("shaft", from, to) == Approx(speed).epsilon(1e-4));
    CHECK(found("FTF", from, to) == Approx(0.4 * speed).epsilon(1e-4));
    CHECK(found("BSF", from, to) == Approx(1.25 * speed).epsilon(2e-3));
    CHECK(found("BPFO", from, to) == Approx(n * 0.4 * speed).epsilon(1e-4));
    CHECK(found("2 BPFI", from, to) == Approx(2.0 * n * 0.6 * speed).epsilon(1e-4));
  }
}
