#include "adrplot/curve_dialog.hpp"
#include "adrplot/own_chart.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/render.hpp"
#include "adrplot/run_beside.hpp"
#include "adrplot/spectrogram_page.hpp"
#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/page_export.hpp"
#include "results/results_h5.hpp"
#include "results/sol_writer.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

/// A run whose power loss is `scale` times that of the other one, at other times.
PlotDocument run(double scale, int steps, const char* folder) {
  test::SyntheticRun made;
  made.steps = steps;
  results::SolFile file = test::synthetic_sol(SolKind::Power, made);
  file.path = std::filesystem::path(folder) / "SOL7";
  for (auto& step : file.steps) step.values[0] = scale * (100.0 + step.revolutions);
  return make_document(std::move(file));
}

}  // namespace

TEST_CASE("own charts: curves of two runs over one abscissa, and their difference", "[unit]") {
  const PlotDocument first = run(1.0, 301, "first"), second = run(2.0, 201, "second");
  const std::vector<CurvePick> picks{{&first, 1, 0, 0}, {&second, 1, 0, 0}};
  const auto page = combine_curves(picks, Combine::Overlay, {});
  REQUIRE(page.panels.size() == 1);
  REQUIRE(page.panels[0].curves.size() == 2);
  CHECK(page.panels[0].unit == "W");
  CHECK(page.panels[0].curves[0].name.find("first/SOL7") != std::string::npos);
  CHECK(page.panels[0].curves[1].name.find("second/SOL7") != std::string::npos);
  CHECK(std::is_sorted(page.x.begin(), page.x.end()));
  for (std::size_t i = 0; i < page.x.size(); ++i) {
    CHECK(page.panels[0].curves[0].y[i] == Approx(100.0 + page.x[i]).epsilon(1e-9));
    CHECK(page.panels[0].curves[1].y[i] == Approx(200.0 + 2.0 * page.x[i]).epsilon(1e-9));
  }
  const auto less = combine_curves(picks, Combine::Difference, {});
  REQUIRE(less.panels.size() == 1);
  REQUIRE(less.panels[0].curves.size() == 1);
  for (std::size_t i = 0; i < less.x.size(); ++i)
    CHECK(less.panels[0].curves[0].y[i] == Approx(100.0 + less.x[i]).epsilon(1e-9));
  // Without a legend the page names both curves of the difference.
  CHECK(less.note.find("second/SOL7") < less.note.find(" minus "));
  CHECK(less.note.find("first/SOL7") > less.note.find(" minus "));
  // Different units have separate panels and no difference.
  const std::vector<CurvePick> mixed{{&first, 1, 0, 0}, {&first, 2, 0, 0}};
  CHECK(combine_curves(mixed, Combine::Overlay, {}).panels.size() == 2);
  CHECK_THROWS_WITH(combine_curves(mixed, Combine::Difference, {}),
                    Catch::Contains("select curves with the same unit"));
  CHECK_THROWS_AS(combine_curves({}, Combine::Overlay, {}), InputError);
}

TEST_CASE("own charts: curves of any file have spectra, differences theirs, and spectrograms",
          "[unit]") {
  // 800 Hz of 3 W in one run; in the other one 5 W more of 1200 Hz, and it ends earlier.
  const auto with_tones = [](double second, int steps, const char* folder) {
    test::SyntheticRun made;
    made.steps = steps;
    results::SolFile file = test::synthetic_sol(SolKind::Power, made);
    file.path = std::filesystem::path(folder) / "SOL7";
    const double step = 1.0 / 16000.0;
    for (std::size_t i = 0; i < file.steps.size(); ++i) {
      const double t = step * static_cast<double>(i);
      file.steps[i].time = t;
      file.steps[i].revolutions = 100.0 * t;
      file.steps[i].values[0] = 50.0 + 3.0 * std::sin(2.0 * std::numbers::pi * 800.0 * t) +
                                second * std::sin(2.0 * std::numbers::pi * 1200.0 * t);
    }
    return make_document(std::move(file));
  };
  const PlotDocument first = with_tones(0.0, 801, "first"), second = with_tones(5.0, 641, "second");
  const std::vector<CurvePick> picks{{&first, 1, 0, 0}, {&second, 1, 0, 0}};
  PageOptions options;
  options.domain = Domain::Spectrum;
  options.spectrum.scale = SpectrumScale::Units;
  options.spectrum.window = Window::FlatTop;
  const auto amplitude = [](const desktop::ChartPage& page, std::size_t curve, double frequency) {
    double largest = 0.0;
    for (std::size_t k = 0; k < page.x.size(); ++k)
      if (std::abs(page.x[k] - frequency) < 60.0)
        largest = std::max(largest, page.panels.at(0).curves.at(curve).y[k]);
    return largest;
  };
  const auto spectra = combine_curves(picks, Combine::Overlay, options);
  CHECK(spectra.x_unit == "Hz");
  REQUIRE(spectra.panels.size() == 1);
  CHECK(spectra.panels[0].unit == "W");
  CHECK(amplitude(spectra, 0, 800.0) == Approx(3.0).epsilon(2e-3));
  CHECK(amplitude(spectra, 0, 1200.0) < 0.01);
  CHECK(amplitude(spectra, 1, 800.0) == Approx(3.0).epsilon(2e-3));
  CHECK(amplitude(spectra, 1, 1200.0) == Approx(5.0).epsilon(2e-3));
  const auto less = combine_curves(picks, Combine::Difference, options);
  REQUIRE(less.panels.size() == 1);
  CHECK(amplitude(less, 0, 800.0) < 0.01);
  CHECK(amplitude(less, 0, 1200.0) == Approx(5.0).epsilon(2e-3));
  options.domain = Domain::Spectrogram;
  const PlotDocument whole = with_tones(5.0, 6401, "whole");
  const auto fall = combine_curves({{&whole, 1, 0, 0}, picks[0]}, Combine::Overlay, options);
  REQUIRE(fall.panels.size() == 1);
  CHECK(fall.panels[0].curves.size() > 10);
  CHECK(amplitude(fall, 0, 1200.0) == Approx(5.0).epsilon(5e-3));
  CHECK(fall.note.find("spectra (flat top window) of") != std::string::npos);
}

TEST_CASE(
    "own charts: curves of tables keep their abscissa, have no spectra and mix with no others",
    "[unit]") {
  // A sweep over speed and a run in time.
  QTemporaryDir folder;
  const std::filesystem::path table = folder.filePath("SWEEP.csv").toStdString();
  const auto sweep = [&](double scale) {
    std::string text = "rpm2 [rpm],exit,largest_load_N,life_gz_hours,message\n";
    for (int i = 0; i < 5; ++i)
      text += fmt::format("{},0,{},{},\"\"\n", 1000 * (i + 1), scale * (100.0 + 10.0 * i),
                          500.0 / (i + 1));
    test::write_text(table, text);
    return open_document(table);
  };
  const PlotDocument slow = sweep(1.0), fast = sweep(3.0);
  PageOptions options;
  const auto page_of = [&](const char* panel) {
    for (std::size_t n = 0; n < slow.pages.size(); ++n) {
      const auto page = slow.build(static_cast<int>(n + 1), options);
      for (std::size_t p = 0; p < page.panels.size(); ++p)
        if (page.panels[p].title.find(panel) != std::string::npos)
          return std::pair{static_cast<int>(n + 1), p};
    }
    FAIL("no panel of " << panel);
    return std::pair{0, std::size_t{0}};
  };
  const auto [number, panel] = page_of("load");
  const std::vector<CurvePick> picks{{&slow, number, panel, 0}, {&fast, number, panel, 0}};
  const std::vector<double> speeds{1000, 2000, 3000, 4000, 5000};
  const auto both = combine_curves(picks, Combine::Overlay, options);
  CHECK(both.x == speeds);
  CHECK(both.x_title.find("rpm2") != std::string::npos);
  const auto less = combine_curves(picks, Combine::Difference, options);
  REQUIRE(less.panels.size() == 1);
  for (std::size_t i = 0; i < speeds.size(); ++i)
    CHECK(less.panels[0].curves[0].y.at(i) ==
          Approx(2.0 * (100.0 + 10.0 * static_cast<double>(i))));
  for (const Domain domain : {Domain::Spectrum, Domain::Spectrogram}) {
    options.domain = domain;
    const auto page = combine_curves(picks, Combine::Overlay, options);
    CHECK(page.x == speeds);  // the curves themselves, and why
    CHECK(page.note.find("Spectra need curves over time") != std::string::npos);
  }
  const PlotDocument history = run(1.0, 301, "first");
  options.domain = Domain::History;
  CHECK_THROWS_WITH(combine_curves({picks[0], {&history, 1, 0, 0}}, Combine::Overlay, options),
                    Catch::Contains("select curves with the same horizontal axis"));
}

TEST_CASE("spectrogram: run-up → rows have speeds, marks move with the speed", "[unit]") {
  test::SyntheticRun made;
  made.steps = 2000;
  for (const bool runs_up : {false, true}) {
    results::SolFile file = test::synthetic_sol(SolKind::Power, made);
    for (std::size_t i = 0; i < file.steps.size(); ++i) {
      const double t = 1e-4 * static_cast<double>(i);
      file.steps[i].time = t;
      // 100 Hz, or 50 Hz that grow by 500 Hz a second.
      // With the seven digits of a file.
      const double turns = runs_up ? 50.0 * t + 250.0 * t * t : 100.0 * t;
      file.steps[i].revolutions = std::stod(fmt::format("{:.6e}", turns));
      file.steps[i].values[0] = std::sin(2.0 * std::numbers::pi * 900.0 * t);
    }
    PageOptions options;
    options.domain = Domain::Spectrum;
    const PlotDocument document = make_document(std::move(file));
    const std::string told = document.build(1, options).note;
    INFO(told);
    CHECK((told.find("speed varies from") != std::string::npos) == runs_up);
    if (runs_up) CHECK(told.find("marks are for the mean") != std::string::npos);
    options.domain = Domain::Spectrogram;
    const auto page = document.build(1, options);
    REQUIRE(page.panels.size() == 1);
    const std::string& name = page.panels[0].curves.front().name;
    INFO(name << " | " << page.note);
    CHECK((name.find("rpm") != std::string::npos) == runs_up);
    REQUIRE(page.marks.size() == 1);
    CHECK(page.marks[0].way.empty() == !runs_up);
    if (!runs_up) continue;
    // Its shaft speed in the middle of the first piece.
    const double rpm = std::stod(name.substr(name.find(',') + 1));
    CHECK(rpm == Approx(60.0 * (50.0 + 500.0 * page.panels[0].rows->at.front())).epsilon(0.01));
    CHECK(page.note.find(" rpm") != std::string::npos);
  }
}

TEST_CASE("own charts: the spectrum of a difference ends at what both runs can show", "[unit]") {
  // 2 kHz in both, stored every 20 us and every 23 us: nothing is drawn above 21.7 kHz.
  const auto run = [](double step, double size) {
    test::SyntheticRun made;
    made.steps = 2000;
    results::SolFile file = test::synthetic_sol(SolKind::Power, made);
    for (std::size_t i = 0; i < file.steps.size(); ++i) {
      const double t = step * static_cast<double>(i);
      file.steps[i].time = t;
      file.steps[i].values[0] = size * std::sin(2.0 * std::numbers::pi * 2000.0 * t);
    }
    return make_document(std::move(file));
  };
  const PlotDocument fine = run(20e-6, 1.0), coarse = run(23e-6, 3.0);
  const std::vector<CurvePick> picks{{&fine, 1, 0, 0}, {&coarse, 1, 0, 0}};
  for (const Domain domain : {Domain::Spectrum, Domain::Spectrogram}) {
    PageOptions options;
    options.domain = domain;
    const auto page = combine_curves(picks, Combine::Difference, options);
    INFO(page.note);
    REQUIRE(page.panels.size() == 1);
    CHECK(page.x.back() <= 0.5 / 23e-6 * (1.0 + 1e-9));
    CHECK(page.x.back() > 0.48 / 23e-6);
    CHECK(page.note.find("interpolated linearly every 23 ") != std::string::npos);
    CHECK(page.note.find("stored steps of") == std::string::npos);
  }
}

TEST_CASE("spectrogram: a speed is written without a power of ten", "[unit]") {
  CHECK(rpm_text(10000.0 / 60.0) == "10000 rpm");
  CHECK(rpm_text(123456.0 / 60.0) == "123456 rpm");
  CHECK(rpm_text(12.34 / 60.0) == "12.34 rpm");
}

TEST_CASE("own charts: values between stored ones → linear interpolation, none outside", "[unit]") {
  const std::vector<double> y =
      interpolated_values({1.0, 2.0, 4.0}, {10.0, 20.0, 0.0}, {0.5, 1.0, 1.25, 2.0, 3.0, 4.0, 4.1});
  CHECK(std::isnan(y[0]));
  CHECK(y[1] == 10.0);
  CHECK(y[2] == Approx(12.5));
  CHECK(y[3] == 20.0);
  CHECK(y[4] == Approx(10.0));
  CHECK(y[5] == 0.0);
  CHECK(std::isnan(y[6]));
}

TEST_CASE("own charts: values below the pointer and between cursors say of what they are",
          "[gui][adrplot]") {
  test::use_qt();
  const PlotDocument slow = run(1.0, 50, "bearings/slow"), fast = run(2.0, 50, "bearings/fast"),
                     other = run(3.0, 50, "elsewhere/fast");
  // Names of curves: owner of the values, without the common part.
  const auto told = [](const std::vector<CurvePick>& picks, Combine how, const char* domain) {
    PageOptions options;
    parse_domain_options(options, domain, "");
    desktop::ChartView view;
    view.resize(700, 450);
    view.showPage(combine_curves(picks, how, options));
    const desktop::ChartScene& scene = view.chartScene();
    view.setCursorAbscissa(0, scene.page().x.front());
    return std::pair{scene.readout(scene.plotAreas().at(0).center()).toStdString(),
                     view.cursorReport().toStdString()};
  };
  const auto both_say = [](const std::pair<std::string, std::string>& said,
                           const std::string& text) {
    INFO(said.first << "\n" << said.second);
    CHECK(said.first.find(text + ": ") != std::string::npos);
    CHECK(said.second.find("\n" + text + ":  A ") != std::string::npos);
  };
  const std::vector<CurvePick> runs{{&slow, 1, 0, 0}, {&fast, 1, 0, 0}};
  const std::string title = slow.build(1, {}).panels.at(0).title;
  for (const char* domain : {"history", "spectrum"}) {
    both_say(told(runs, Combine::Difference, domain),
             "Difference: " + title + " · fast/SOL7 minus slow/SOL7");
    both_say(told(runs, Combine::Overlay, domain), title + " · slow/SOL7");
    both_say(told(runs, Combine::Overlay, domain), title + " · fast/SOL7");
  }
  // Two quantities of one run; two runs whose folders have one name.
  const auto& panels = fast.build(1, {}).panels;
  const std::vector<CurvePick> one{{&fast, 1, 0, 0}, {&fast, 1, 1, 0}};
  REQUIRE(panels.size() > 1);
  both_say(told(one, Combine::Overlay, "history"), panels[1].title);
  const std::vector<CurvePick> twins{{&fast, 1, 0, 0}, {&other, 1, 0, 0}};
  both_say(told(twins, Combine::Difference, "history"),
           "Difference: " + title + " · elsewhere/fast/SOL7 minus bearings/fast/SOL7");
  // The spectrogram of a difference is not that of a run.
  PageOptions fall;
  fall.domain = Domain::Spectrogram;
  const desktop::ChartPage page = combine_curves(runs, Combine::Difference, fall);
  CHECK(page.choices ==
        std::vector<std::string>{title + " · " + slow.subject + " · fast/SOL7 minus slow/SOL7"});
}

TEST_CASE("plot_window: chosen curves of two files become a chart that outlives its files",
          "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Power));
  window.addFile(test::synthetic_sol(SolKind::Race));
  window.askForCurves();
  auto* dialog = window.findChild<CurveDialog*>();
  REQUIRE(dialog);
  auto* tree = dialog->findChild<QTreeWidget*>("curves");
  REQUIRE(tree->topLevelItemCount() == 2);
  for (int f = 0; f < 2; ++f) {
    tree->topLevelItem(f)->setExpanded(true);
    REQUIRE(tree->topLevelItem(f)->childCount() > 0);
    tree->topLevelItem(f)->child(1)->child(0)->setCheckState(0, Qt::Checked);
  }
  REQUIRE(dialog->picks().size() == 2);
  dialog->accept();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  REQUIRE(window.fileCount() == 3);
  CHECK(window.view().chartScene().page().title == "Selected curves");
  CHECK(window.view().chartScene().page().panels.size() == 2);
  // Opened again, what was ticked is ticked.
  window.askForCurves();
  dialog = window.findChild<CurveDialog*>();
  REQUIRE(dialog);
  CHECK(dialog->picks().size() == 2);
  dialog->reject();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  auto* pages = window.findChild<QTreeWidget*>("pages");
  pages->setCurrentItem(pages->topLevelItem(0)->child(0));
  window.closeFile();
  CHECK(window.fileCount() == 2);
  pages->setCurrentItem(pages->topLevelItem(1)->child(0));
  CHECK(window.view().chartScene().page().panels.size() == 2);
  while (window.fileCount() > 0) window.closeFile();
  CHECK(window.currentPage() == 0);
  CHECK(window.view().chartScene().page().panels.empty());
}

TEST_CASE("own charts: the dialog opens with the ticks, their order and the reference of before",
          "[gui][adrplot]") {
  test::use_qt();
  const PlotDocument slow = run(1.0, 50, "slow"), fast = run(2.0, 50, "fast");
  const std::vector<const PlotDocument*> files{&slow, &fast};
  CurveChoice before{.how = Combine::Difference};
  before.curves = {{fast.path, 1, 0, 0}, {slow.path, 1, 0, 0, true}, {"elsewhere/SOL7", 1, 0, 0}};
  const CurveDialog dialog(files, {}, before);
  CHECK(dialog.how() == Combine::Difference);
  const std::vector<CurvePick> picks = dialog.picks();
  REQUIRE(picks.size() == 2);
  CHECK(picks.front().file == &slow);
  const CurveChoice again = dialog.choice();
  REQUIRE(again.curves.size() == 2);
  CHECK(again.curves[0].file == fast.path);
  CHECK_FALSE(again.curves[0].reference);
  CHECK(again.curves[1].reference);
}

TEST_CASE("own charts: a table tells stored values from those read off between them",
          "[unit][adrplot]") {
  const PlotDocument coarse = run(1.0, 4, "coarse"), fine = run(2.0, 7, "fine");
  const std::vector<CurvePick> picks{{&coarse, 1, 0, 0}, {&fine, 1, 0, 0}};
  for (const Combine how : {Combine::Overlay, Combine::Difference}) {
    const desktop::ChartPage page = combine_curves(picks, how, {});
    const std::string csv = desktop::page_csv(page);
    INFO(csv);
    CHECK(csv.substr(0, csv.find('\n')).find("stored (1) or interpolated (0)") !=
          std::string::npos);
    // Each curve's column says 1 as often as that has a stored value.
    const auto coarse_x = coarse.build(1, {}).x, fine_x = fine.build(1, {}).x;
    for (std::size_t c = 0; c < page.panels.at(0).curves.size(); ++c) {
      const desktop::ChartCurve& curve = page.panels[0].curves[c];
      REQUIRE((curve.stored.empty() || curve.stored.size() == page.x.size()));
      for (std::size_t i = 0; i < page.x.size(); ++i) {
        const auto in = [&](const std::vector<double>& x) {
          return std::find(x.begin(), x.end(), page.x[i]) != x.end();
        };
        CHECK((curve.stored.empty() || curve.stored[i]) == (how == Combine::Difference
                                                                ? in(coarse_x) && in(fine_x)
                                                            : c == 0 ? in(coarse_x)
                                                                     : in(fine_x)));
      }
    }
  }
  // Curves over the same steps have nothing to tell apart.
  const PlotDocument same = run(3.0, 4, "same");
  CHECK(desktop::page_csv(
            combine_curves({{&coarse, 1, 0, 0}, {&same, 1, 0, 0}}, Combine::Overlay, {}))
            .find("stored (1)") == std::string::npos);
}

TEST_CASE("the folder of a run is the same for every way of writing it", "[unit]") {
  const auto here = std::filesystem::current_path();
  for (const auto& file : {std::filesystem::path("SOL1"), std::filesystem::path("./SOL1"),
                           std::filesystem::path("x/../SOL1"), here / "." / "SOL1"})
    CHECK(run_folder(file) == here);
  CHECK(run_folder("./run-001/SOL1") == here / "run-001");
}

TEST_CASE("plot_window: folder → all its plot files opened, two folders distinguished", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  test::SyntheticRun made;
  made.steps = 30;
  const QDir base(folder.path());
  for (const char* run : {"slow", "fast"}) {
    base.mkdir(run);
    for (const auto& [name, kind] : {std::pair{"SOL1", SolKind::Element}, {"SOL7", SolKind::Power}})
      test::write_text(base.filePath(QString("%1/%2").arg(run, name)).toStdString(),
                       test::sol_text(test::synthetic_sol(kind, made)));
  }
  PlotWindow window;
  window.openFolder(base.filePath("slow"));
  window.openFolder(base.filePath("fast"));
  CHECK(window.fileCount() == 4);
  auto* tree = window.findChild<QTreeWidget*>("pages");
  CHECK(tree->topLevelItem(0)->text(0).startsWith("slow/SOL1"));
  CHECK(tree->topLevelItem(3)->text(0).startsWith("fast/SOL7"));
  window.openFolder(base.filePath("fast"), {.from = 2, .to = 11});
  CHECK(window.findChild<desktop::ChartView*>()->chartScene().page().x.size() == 10);
  // Record 2.3 of the deck had named its files.
  base.mkdir("named");
  QFile::copy(base.filePath("slow/SOL1"), base.filePath("named/ball.dat"));
  test::write_text(base.filePath("named/RUN.json").toStdString(), R"({"files": ["ball.dat"]})");
  window.openFolder(base.filePath("named"));
  CHECK(window.findChild<QMessageBox*>("message") == nullptr);
  CHECK(tree->topLevelItem(tree->topLevelItemCount() - 1)->text(0).startsWith("named/ball.dat"));
  base.mkdir("empty");
  window.openFolder(base.filePath("empty"));
  auto* box = window.findChild<QMessageBox*>("message");
  REQUIRE(box);
  CHECK(box->text().contains("no plot file"));
}

TEST_CASE("plot_window: any history has a spectrum and a spectrogram", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Element));
  window.showPage(6);
  auto& scene = window.view().chartScene();
  window.setDomain(Domain::Spectrum);
  CHECK(scene.page().x_unit == "Hz");
  REQUIRE(scene.page().panels.size() == 3);
  // The outer load swings 160 N with the cage and 6 N at 17.3 times the shaft's frequency.
  const auto& load = scene.page().panels[0].curves[0].y;
  CHECK(scene.page().panels[0].unit == "N");
  CHECK(*std::max_element(load.begin(), load.end()) == Approx(160.0).epsilon(0.2));
  window.setSpectrum({Window::Hann, SpectrumScale::Units});
  window.setDomain(Domain::Spectrogram);
  REQUIRE(scene.page().panels.size() == 1);
  CHECK(scene.page().panels[0].curves.size() > 10);
  CHECK(scene.page().panels[0].title == "Contact load, outer race");
  CHECK(scene.page().title.find(": spectrogram") != std::string::npos);
  const desktop::ChartPanel& lines = scene.page().panels[0];
  const desktop::ChartCurve& last = lines.curves.back();
  REQUIRE(lines.rows);
  CHECK(lines.unit == "N");
  const std::string table = desktop::page_csv(scene.page());
  const std::string row = table.substr(table.rfind('\n', table.size() - 2) + 1);
  CHECK(std::stod(row.substr(row.rfind(',') + 1)) == Approx(last.y.back()).margin(1e-9));
  const QRectF& area = scene.plotAreas().front();
  const QString told = scene.readout({area.left() + 0.5 * area.width(), area.center().y()});
  INFO(told.toStdString());
  const std::size_t at =
      desktop::nearest_index(scene.page().x, scene.abscissaAt(area.left() + 0.5 * area.width()));
  const std::size_t middle = scene.mapRowAt({area.center().x(), area.center().y()}).value();
  CHECK(told.endsWith(QString::fromStdString(
      desktop::pretty_quantity(lines.curves.at(middle).y.at(at), lines.unit, 5))));
  // The cursor readout has the largest value of the map; the window stays on the screen.
  window.resize(1264, 770);
  window.show();
  window.view().setCursorAbscissa(0, 100.0);
  window.view().setCursorAbscissa(1, 500.0);
  QCoreApplication::processEvents();
  auto* cursors = window.findChild<QLabel*>("cursors");
  CHECK(cursors->text().contains("A maximum"));
  CHECK(window.height() <= 770);
  CHECK(window.minimumSizeHint().height() <= 770);
  window.view().clearCursors();
  // The first view ends where nothing can be seen any more, and hides nothing that can.
  const double end = scene.page().view_high;
  CHECK(end < 0.8 * scene.page().x.back());
  const auto& first = scene.page().panels[0].curves[0].y;
  const double largest = *std::max_element(first.begin(), first.end());
  for (std::size_t k = 0; k < first.size(); ++k)
    if (scene.page().x[k] > end) CHECK(first[k] < 0.02 * largest);
  window.setDomain(Domain::History);
  CHECK(scene.page().x_unit == "rev");
}

TEST_CASE("plot_window: pages are exported in every format, one or all", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  test::SyntheticRun made;
  made.steps = 40;
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Power, made));
  for (const char* suffix : {"png", "svg", "pdf", "csv"}) {
    const QString path = folder.filePath(QString("one.%1").arg(suffix));
    CHECK(window.exportTo(path, false));
    CHECK(window.statusBar()->currentMessage().contains(path));
    CHECK(QFile(path).size() > 1000);
  }
  CHECK(window.exportTo(folder.filePath("all.pdf"), true));
  CHECK(QFile(folder.filePath("all.pdf")).size() > QFile(folder.filePath("one.pdf")).size());
  CHECK(window.exportTo(folder.filePath("all.csv"), true));
  for (int page = 1; page <= window.pageCount(); ++page)
    CHECK(QFile::exists(folder.filePath(QString("all-%1.csv").arg(page, 2, 10, QChar('0')))));
  CHECK(window.currentPage() == 1);
  CHECK_FALSE(window.exportTo(folder.filePath("one.doc"), false));
}

TEST_CASE("plot_window: a growing file is read again while it is followed", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  test::SyntheticRun made;
  made.steps = 60;
  const auto whole = test::synthetic_sol(SolKind::Power, made);
  auto part = whole;
  part.steps.resize(20);
  const std::filesystem::path path = folder.filePath("SOL7").toStdString();
  test::write_text(path, test::sol_text(part));
  PlotWindow window;
  REQUIRE(window.openFile(path));
  CHECK(window.view().chartScene().page().x.size() == 20);
  window.follow(true);
  test::write_text(path, test::sol_text(whole));
  for (int i = 0; i < 60 && window.view().chartScene().page().x.size() < 60; ++i) QTest::qWait(100);
  CHECK(window.view().chartScene().page().x.size() == 60);
  window.follow(false);
}

TEST_CASE("run_beside: frequencies of a run are those of its mean speeds", "[unit][h5]") {
  using namespace adore::testing;
  TemporaryFolder folder;
  const bearing::Bearing bearing = make_bearing();
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (long step = 0; step <= 50; ++step) {
    scene::Snapshot snapshot = make_snapshot(bearing, step);
    snapshot.races[0].total_rotation = -100.0 * snapshot.time;  // [rad/s] x time
    snapshot.races[1].total_rotation = 900.0 * snapshot.time;
    for (auto& element : snapshot.elements)
      element.omega = {400.0 + 3.0 * 500.0, 4.0 * 500.0, 0.0};  // spins at 2500 rad/s
    h5.write(recorder.record(snapshot));
  }
  h5.close();
  std::map<std::string, double> found;
  for (const auto& mark : bearing_frequencies(folder / "RESULTS.h5")) found[mark.label] = mark.x;
  // Both turn: neither at the 1000 rad/s of one against the other.
  CHECK(found["inner race"] == Approx(900.0 / kTurn));
  CHECK(found["outer race"] == Approx(100.0 / kTurn));
  CHECK(found.count("shaft") == 0);
  CHECK(found["FTF"] == Approx(400.0 / kTurn));
  CHECK(found["BSF"] == Approx(2500.0 / kTurn));
  CHECK(found["BPFO"] == Approx(3 * 500.0 / kTurn));
  CHECK(found["BPFI"] == Approx(3 * 500.0 / kTurn));
  for (const char* name : {"FTF", "BSF", "BPFO", "BPFI"})
    for (const int harmonic : {2, 3}) {
      INFO(harmonic << " " << name);
      CHECK(found[std::to_string(harmonic) + " " + name] == Approx(harmonic * found[name]));
    }
}
