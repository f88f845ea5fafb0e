#include "adrplot/curve_dialog.hpp"
#include "adrplot/spectrogram_page.hpp"
#include "adrplot/spectrum_page.hpp"
#include "desktop/chart_scene.hpp"
#include "support/qt_app.hpp"

#include <QComboBox>
#include <QGraphicsSimpleTextItem>
#include <QTreeWidget>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace adore;
using namespace adore::adrplot;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep = 1e-5;  // [s]

std::vector<double> times(std::size_t n) {
  std::vector<double> t;
  for (std::size_t i = 0; i < n; ++i) t.push_back(kStep * static_cast<double>(i));
  return t;
}

std::vector<double> tone(const std::vector<double>& t, double frequency, double amplitude = 1.0) {
  std::vector<double> out;
  for (const double time : t)
    out.push_back(5.0 + amplitude * std::sin(2.0 * std::numbers::pi * frequency * time));
  return out;
}

desktop::ChartPage page_of(std::vector<std::vector<double>> curves) {
  desktop::ChartPage page;
  page.title = "Loads";
  for (std::size_t i = 0; i < curves.size(); ++i)
    page.panels.push_back(
        {i == 0 ? "Load" : "Angle", "N", {{"outer race", std::move(curves[i]), {}}}, false});
  return page;
}

}  // namespace

TEST_CASE("pages: slow and fast lines side by side are drawn over a logarithmic frequency",
          "[gui][adrplot]") {
  test::use_qt();
  const std::vector<double> t = times(10000);
  const auto spectra = [&](double slow, double fast, SpectrumScale scale) {
    desktop::ChartPage page = page_of({tone(t, slow), tone(t, fast)});
    to_spectra(page, {t, {}}, {Window::Hann, scale});
    set_initial_spectrum_view(page, scale);
    return page;
  };
  for (const SpectrumScale scale :
       {SpectrumScale::Relative, SpectrumScale::Units, SpectrumScale::Decibel}) {
    const desktop::ChartPage page = spectra(40.0, 8000.0, scale);
    INFO(page.note);
    CHECK(page.log_x);
    CHECK(page.note.find("Logarithmic frequency axis: lines above 1 % of the maximum extend to "
                         "50 Hz in one curve and to 8.01 kHz in another.") != std::string::npos);
    // The content of each panel has a tenth of the width at least.
    desktop::ChartScene scene;
    scene.setPageSize({700, 450});
    scene.setPage(page);
    const double width = scene.plotAreas()[0].width();
    CHECK(scene.sceneXAt(50.0) - scene.plotAreas()[0].left() > 0.1 * width);
    CHECK(scene.sceneXAt(8000.0) <= scene.plotAreas()[0].right());
    CHECK(scene.viewLow() == Approx(10.0));
    // And not much beyond the last of them; in dB all of it is seen.
    if (scale == SpectrumScale::Decibel)
      CHECK(scene.viewHigh() == Approx(page.x.back()));
    else
      CHECK((scene.viewHigh() > 8010.0 && scene.viewHigh() < 1.5 * 8010.0));
  }
  CHECK_FALSE(spectra(400.0, 800.0, SpectrumScale::Relative).log_x);
  CHECK(spectra(400.0, 800.0, SpectrumScale::Relative).view_low == 0.0);
}

TEST_CASE("chart_scene: logarithmic abscissa → enough values in its low decades", "[gui]") {
  test::use_qt();
  desktop::ChartPage page;
  page.x_title = "Frequency", page.x_unit = "Hz";
  page.log_x = true;
  page.panels = {{"Amplitude", "N", {{"", {}, {}}}, false}};
  for (int k = 1; k <= 50000; ++k) {  // every other line is high
    page.x.push_back(k);
    page.panels[0].curves[0].y.push_back(k % 2 == 0 ? 1.0 : 0.0);
  }
  desktop::ChartScene scene;
  scene.setPageSize({1280, 800});
  scene.setPage(page);
  const QImage picture = scene.image({1280, 800});
  // Between two high lines the curve comes down: at 20, 40 and 60 Hz.
  const QRectF area = scene.plotAreas()[0];
  const auto is_line = [&](double frequency, double value, int beside = 1) {
    const QPoint at(static_cast<int>(std::lround(scene.sceneXAt(frequency))),
                    static_cast<int>(std::lround(scene.sceneYAt(0, value))));
    for (int dx = -beside; dx <= beside; ++dx)
      for (int dy = -2; dy <= 2; ++dy)
        if (picture.pixelColor(at + QPoint(dx, dy)).saturation() > 128) return true;
    return false;
  };
  for (const int k : {4, 10, 20, 40}) {
    INFO(k);
    CHECK(is_line(k, 1.0));
    CHECK_FALSE(is_line(k, 0.0, 0));  // the next ones are three pixels away
    CHECK(is_line(k + 1, 0.0));
    CHECK_FALSE(is_line(k + 1, 1.0, 0));
  }
  CHECK(area.width() > 1000.0);
}

TEST_CASE("pages: short gaps of a curve are bridged for its spectrum, and said",
          "[unit][adrplot]") {
  const std::vector<double> t = times(5000);
  const std::vector<double> whole = tone(t, 1000.0);
  const auto with_gap = [&](std::size_t first, std::size_t length) {
    std::vector<double> y = whole;
    for (std::size_t i = first; i < first + length; ++i) y[i] = kNone;
    return y;
  };
  const auto spectrum = [&](const std::vector<double>& y) {
    desktop::ChartPage page = page_of({whole, y});
    to_spectra(page, {t, {}}, {Window::Hann, SpectrumScale::Units});
    return page;
  };
  // Two steps: as much as half a period of what vibrates is no more than 50 steps.
  const desktop::ChartPage page = spectrum(with_gap(1234, 2));
  INFO(page.note);
  REQUIRE_FALSE(page.panels[1].curves[0].y.empty());
  CHECK(page.panels[1].curves[0].y.size() == page.panels[0].curves[0].y.size());
  CHECK(page.note.find("Angle, outer race: 2 of 5000 steps have no value: interpolated linearly "
                       "(longest gap 30 µs).") != std::string::npos);
  for (std::size_t k = 0; k < page.x.size(); ++k)
    CHECK(page.panels[1].curves[0].y[k] == Approx(page.panels[0].curves[0].y[k]).margin(2e-3));
  // At the ends of the run there is nothing to bridge to.
  CHECK(spectrum(with_gap(0, 3)).panels[1].message.find("There are no values before 30 µs") == 0);
  CHECK(spectrum(with_gap(4996, 4)).panels[1].message.find("There are no values after ") == 0);
  // As long as half a period: nothing would be known of it. The tone's lines reach 1020 Hz.
  CHECK_FALSE(spectrum(with_gap(1234, 47)).panels[1].curves[0].y.empty());
  const desktop::ChartPage longer = spectrum(with_gap(1234, 49));
  INFO(longer.panels[1].message);
  CHECK(longer.panels[1].curves[0].y.empty());
  CHECK(longer.panels[1].message.find(
            "There are no values at 49 of 5000 steps (a gap of 500 µs "
            "is too long for vibrations up to 1.02 kHz), so there is no frequency") == 0);
  // More than one in a hundred, however short each gap is.
  std::vector<double> many = whole;
  for (std::size_t i = 50; i < many.size(); i += 90) many[i] = kNone;
  CHECK(spectrum(many).panels[1].message ==
        "There are no values at 55 of 5000 steps, so there is no frequency spectrum.");

  // The same for a spectrogram.
  for (const auto& [y, drawn] : {std::pair(with_gap(1234, 2), true), {with_gap(1234, 49), false}}) {
    desktop::ChartPage fall = page_of({y});
    to_spectrogram(fall, {t, {}}, {});
    INFO(fall.note);
    CHECK(fall.panels.empty() != drawn);
    CHECK(fall.note.find(drawn ? "2 of 5000 steps have no value: interpolated linearly"
                               : "There are no values at 49 of 5000 steps") != std::string::npos);
  }
}

TEST_CASE("spectrum pages: notes on the removed mean and on drift in the first line",
          "[unit][adrplot]") {
  const std::vector<double> t = times(600);
  const auto curve = [&](double drift, double periods) {
    std::vector<double> out = tone(t, periods / (kStep * static_cast<double>(t.size())), 5.0);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] += drift * static_cast<double>(i) / static_cast<double>(out.size());
    return out;
  };
  const auto note = [&](std::vector<std::vector<double>> curves) {
    desktop::ChartPage page = page_of(std::move(curves));
    to_spectra(page, {t, {}}, {});
    note_spectrum_lines(page, {page.x.front()}, {});
    return page.note;
  };
  const std::string told = "irst line is drift";
  for (const double periods : {1.0, 2.0, 2.5, 30.0, 60.5})
    for (const double drift : {0.0, 40.0}) {
      const std::string all = note({curve(drift, periods)});
      INFO(drift << " and " << periods << " periods: " << all);
      CHECK(all.find("Hann window, mean removed, line spacing") != std::string::npos);
      // A wave of one period keeps more than half of the line that both share.
      if (periods > 1.0 || drift == 0.0)
        CHECK((all.find("The f" + told) != std::string::npos) == (drift > 0.0));
    }
  // With one curve that has lines and one without, the page names the curve.
  CHECK(note({curve(0.0, 30.0), curve(40.0, 30.0)}).find("Angle, outer race: the f" + told) !=
        std::string::npos);
}

TEST_CASE("own charts: differences are from the curve that was ticked first, or from a chosen one",
          "[gui][adrplot]") {
  test::use_qt();
  std::vector<PlotDocument> files(3);
  std::vector<const PlotDocument*> all;
  for (std::size_t f = 0; f < files.size(); ++f) {
    files[f].path = "run" + std::to_string(f) + "/SOL1";
    files[f].subject = "element";
    files[f].pages = {{"Loads", PageKind::History}};
    files[f].build = [f](int, const PageOptions&) {
      desktop::ChartPage page;
      page.x_title = "Time", page.x_unit = "s", page.x = {0.0, 1.0, 2.0};
      page.panels = {
          {"Load", "N", {{"", std::vector<double>(3, 10.0 * static_cast<double>(f)), {}}}, false}};
      return page;
    };
    all.push_back(&files[f]);
  }
  CurveDialog dialog(all, {});
  auto* tree = dialog.findChild<QTreeWidget*>("curves");
  auto* how = dialog.findChild<QComboBox*>("how");
  auto* reference = dialog.findChild<QComboBox*>("reference");
  REQUIRE(reference != nullptr);
  const auto checkCurves = [&](int f, bool on) {
    tree->topLevelItem(f)->setExpanded(true);
    tree->topLevelItem(f)->child(0)->child(0)->setCheckState(0, on ? Qt::Checked : Qt::Unchecked);
  };
  for (const int f : {1, 0, 2}) checkCurves(f, true);
  CHECK_FALSE(reference->isEnabled());
  CHECK(dialog.picks().front().file == &files[0]);  // drawn together: as in the tree
  how->setCurrentIndex(1);
  CHECK(reference->isEnabled());
  REQUIRE(reference->count() == 3);
  CHECK(reference->currentText().contains("run1"));
  REQUIRE(dialog.picks().size() == 3);
  CHECK(dialog.picks().front().file == &files[1]);
  const auto drawn = combine_curves(dialog.picks(), dialog.how(), {});
  CHECK(drawn.note.find("run1/SOL1") != std::string::npos);
  CHECK(drawn.panels.at(0).curves.at(0).y.front() == -10.0);
  CHECK(drawn.panels[0].curves.at(1).y.front() == 10.0);
  // By hand, kept while another curve goes.
  reference->setCurrentIndex(2);
  emit reference->activated(2);
  CHECK(dialog.picks().front().file == &files[2]);
  checkCurves(1, false);
  CHECK(dialog.picks().front().file == &files[2]);
  CHECK(dialog.picks().size() == 2);
  checkCurves(2, false);
  CHECK(dialog.picks().front().file == &files[0]);
}
