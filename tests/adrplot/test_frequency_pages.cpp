#include "adrplot/curve_dialog.hpp"
#include "adrplot/spectrum_page.hpp"
#include "adrplot/waterfall_page.hpp"
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
    to_spectra(page, t, {Window::Hann, scale});
    first_view_of_spectra(page, scale);
    return page;
  };
  for (const SpectrumScale scale :
       {SpectrumScale::Relative, SpectrumScale::Units, SpectrumScale::Decibel}) {
    const desktop::ChartPage page = spectra(40.0, 8000.0, scale);
    INFO(page.note);
    CHECK(page.log_x);
    CHECK(page.note.find("Logarithmic frequency axis: one curve has lines above 1 % of the maximum "
                         "up to 50 Hz, another up to 8.01 kHz.") != std::string::npos);
    // The content of each panel has a tenth of the width at least.
    desktop::ChartScene scene;
    scene.setPageSize({700, 450});
    scene.setPage(page);
    const double width = scene.plotAreas()[0].width();
    CHECK(scene.positionOf(50.0) - scene.plotAreas()[0].left() > 0.1 * width);
    CHECK(scene.positionOf(8000.0) <= scene.plotAreas()[0].right());
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
    const QPoint at(static_cast<int>(std::lround(scene.positionOf(frequency))),
                    static_cast<int>(std::lround(scene.heightOf(0, value))));
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
    to_spectra(page, t, {Window::Hann, SpectrumScale::Units});
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
            "There are no values at 49 of 5000 steps (gaps up to 500 µs "
            "are too long for lines up to 1.02 kHz), so there is no frequency") == 0);
  // More than one in a hundred, however short each gap is.
  std::vector<double> many = whole;
  for (std::size_t i = 50; i < many.size(); i += 90) many[i] = kNone;
  CHECK(spectrum(many).panels[1].message ==
        "There are no values at 55 of 5000 steps, so there is no frequency spectrum.");

  // The same for a waterfall.
  for (const auto& [y, drawn] : {std::pair(with_gap(1234, 2), true), {with_gap(1234, 49), false}}) {
    desktop::ChartPage fall = page_of({y});
    to_waterfall(fall, {t, {}}, {});
    INFO(fall.note);
    CHECK(fall.panels.empty() != drawn);
    CHECK(fall.note.find(drawn ? "2 of 5000 steps have no value: interpolated linearly"
                               : "There are no values at 49 of 5000 steps") != std::string::npos);
  }
}

TEST_CASE("pages: a waterfall is in units, over its largest or in dB, as the spectrum is",
          "[gui][adrplot]") {
  test::use_qt();
  const std::vector<double> t = times(20000);
  std::vector<double> y = tone(t, 3000.0, 20.0);
  for (std::size_t i = y.size() / 2; i < y.size(); ++i)
    y[i] = 5.0 + 0.1 * (y[i] - 5.0);  // 20 dB lower in the second half
  const auto fall = [&](SpectrumScale scale) {
    desktop::ChartPage page = page_of({y});
    to_waterfall(page, {t, {}}, {Window::FlatTop, scale});
    return page;
  };
  const auto highest = [](const desktop::ChartCurve& curve) {
    double out = -1e9;
    for (std::size_t k = 0; k < curve.y.size(); ++k) out = std::max(out, curve.value(k));
    return out;
  };
  const auto lowest = [](const desktop::ChartCurve& curve) {
    double out = 1e9;
    for (std::size_t k = 0; k < curve.y.size(); ++k) out = std::min(out, curve.value(k));
    return out;
  };
  const desktop::ChartPage units = fall(SpectrumScale::Units),
                           relative = fall(SpectrumScale::Relative),
                           decibel = fall(SpectrumScale::Decibel);
  const auto curves = [](const desktop::ChartPage& page) -> const auto& {
    return page.panels.at(0).curves;
  };
  REQUIRE(curves(units).size() > 20);
  CHECK(highest(curves(units).front()) == Approx(20.0).epsilon(2e-3));
  CHECK(highest(curves(units).back()) == Approx(2.0).epsilon(2e-3));
  CHECK(relative.panels[0].unit == "of largest");
  // Over the largest of all pieces: that in which the tone drops has more.
  double largest = 0.0;
  for (const auto& curve : curves(relative)) largest = std::max(largest, highest(curve));
  CHECK(largest == Approx(1.0).epsilon(1e-12));
  const double first = highest(curves(relative).front());
  CHECK(first > 0.95);
  CHECK(highest(curves(relative).back()) == Approx(0.1 * first).epsilon(2e-3));
  CHECK(decibel.panels[0].unit == "dB");
  CHECK(highest(curves(decibel).front()) == Approx(20.0 * std::log10(first)).margin(1e-9));
  CHECK(highest(curves(decibel).back()) - highest(curves(decibel).front()) ==
        Approx(-20.0).margin(0.02));
  CHECK(lowest(curves(decibel).back()) == -60.0);
  INFO(decibel.note);
  CHECK(decibel.note.find("Values below −60 dB are not drawn") != std::string::npos);

  // Each name is next to the panel, where its line begins, and covers nothing.
  for (const auto& page : {units, relative, decibel}) {
    desktop::ChartScene scene;
    scene.setPageSize({700, 450});
    scene.setPage(page);
    const QRectF area = scene.plotAreas()[0];
    int names = 0;
    for (const QGraphicsItem* item : scene.items())
      if (const auto* text = dynamic_cast<const QGraphicsSimpleTextItem*>(item))
        for (const desktop::ChartCurve& curve : page.panels[0].curves)
          if (text->text().toStdString() == curve.name) {
            ++names;
            const QRectF box = text->sceneBoundingRect();
            CHECK(box.left() > area.right());
            CHECK(box.right() <= 700.0);
            CHECK(box.center().y() ==
                  Approx(scene.heightOf(0, curve.lift + curve.foot)).margin(2.0));
          }
    CHECK(names > 5);
  }
}

TEST_CASE("spectrum: a sine on an offset has its amplitude at its line, and none near 0 Hz",
          "[unit][adrplot]") {
  constexpr std::size_t kSamples = 1000;
  constexpr double kStep = 1e-4, kSize = 0.3, kOffset = 5e3;
  const auto sine = [](double periods, double phase, double offset) {
    std::vector<double> out;
    for (std::size_t i = 0; i < kSamples; ++i)
      out.push_back(offset + kSize * std::cos(2.0 * std::numbers::pi * periods *
                                                  static_cast<double>(i) / kSamples +
                                              phase));
    return out;
  };
  // Lines next to that of a windowed sine; loss between two lines; a remaining constant in the
  // first line.
  struct Case {
    Window window;
    std::size_t wide;
    double loss, first;
  };
  for (const auto& [window, wide, loss, first] :
       {Case{Window::None, 0, 0.364, 0.0}, Case{Window::Hann, 1, 0.152, 1.0},
        Case{Window::FlatTop, 4, 1.1e-3, 1.93}})
    for (const double phase : {0.0, 0.7, 1.9}) {
      for (const std::size_t line : {1UL, 2UL, 5UL, 23UL, 260UL, 499UL}) {
        const Spectrum s =
            amplitude_spectrum(sine(static_cast<double>(line), phase, kOffset), kStep, window);
        INFO(window_name(window) << ", line " << line << ", phase " << phase);
        REQUIRE(s.amplitude.size() == kSamples / 2);
        CHECK(s.frequency[line - 1] == Approx(static_cast<double>(line) / (kSamples * kStep)));
        // Leakage of a low line also affects its mirror line.
        if (line > 2 * wide && line < kSamples / 2 - wide)
          CHECK(s.amplitude[line - 1] == Approx(kSize).epsilon(1e-8));
        for (std::size_t k = 1; k <= kSamples / 2; ++k)
          if (k > line + wide || k + wide < line) CHECK(s.amplitude[k - 1] < 1e-8 * kSize);
      }
      for (const double periods : {5.5, 40.5, 300.3}) {
        const Spectrum s = amplitude_spectrum(sine(periods, phase, kOffset), kStep, window);
        const Spectrum same = amplitude_spectrum(sine(periods, phase, 0.0), kStep, window);
        INFO(window_name(window) << ", " << periods << " periods");
        for (std::size_t k = 0; k < s.amplitude.size(); ++k)
          CHECK(s.amplitude[k] == Approx(same.amplitude[k]).margin(1e-8 * kSize));
        const double highest = *std::max_element(s.amplitude.begin(), s.amplitude.end());
        CHECK(highest > (1.0 - loss) * 0.98 * kSize);
        CHECK(highest < 1.05 * kSize);
        // The mean of a partial period is not an offset: it leaves at most size / (pi periods).
        if (window != Window::None)
          CHECK(s.amplitude[0] < 1.2 * first * kSize / (std::numbers::pi * periods));
      }
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
    to_spectra(page, t, {});
    tell_lines(page, {page.x.front()}, {});
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

TEST_CASE("waterfall: motion slower than a piece does not fill its first lines",
          "[unit][adrplot]") {
  // Pieces of 10 ms: a line every 100 Hz. A tone of 1 N on the twentieth, a load that grows by 100
  // N and swings by 5 N in 60 ms.
  constexpr double kPi = std::numbers::pi;
  const std::vector<double> t = times(12500);
  const auto fall = [&](auto&& value) {
    Samples samples;
    samples.step = kStep;
    for (const double time : t) samples.values.push_back(value(time));
    return waterfall(samples, Window::Hann);
  };
  const Waterfall slow = fall([&](double time) {
    return std::sin(2.0 * kPi * 2000.0 * time) + 100.0 * time / t.back() +
           5.0 * std::sin(2.0 * kPi * time / 0.06);
  });
  REQUIRE(slow.time.size() == 24);
  REQUIRE(slow.frequency.front() == Approx(100.0));
  for (const auto& piece : slow.amplitude) {
    for (const std::size_t k : {0U, 1U, 2U}) CHECK(piece.at(k) < 0.35);  // 2 N with the trend
    CHECK(piece.at(19) == Approx(1.0).epsilon(1e-3));
  }
  // The remark of the page on its first line only.
  double least[2] = {1.0, 1.0}, most[2] = {0.0, 0.0};
  for (int phase = 0; phase < 16; ++phase)
    for (const std::size_t k : {0U, 1U}) {
      const Waterfall one = fall([&](double time) {
        return 7.0 +
               std::sin(2.0 * kPi * (100.0 * static_cast<double>(k + 1) * time + phase / 16.0));
      });
      for (const auto& piece : one.amplitude) {
        least[k] = std::min(least[k], piece.at(k));
        most[k] = std::max(most[k], piece.at(k));
      }
    }
  CHECK(least[0] == Approx(0.54).margin(0.01));
  CHECK(most[0] == Approx(1.0).margin(0.01));
  CHECK(least[1] == Approx(1.0).margin(0.01));
  CHECK(most[1] == Approx(1.05).margin(0.01));
  for (const auto& piece : fall([](double time) { return 3.0 + 200.0 * time; }).amplitude)
    CHECK(*std::max_element(piece.begin(), piece.end()) == 0.0);
  desktop::ChartPage page = page_of({tone(t, 2000.0)});
  to_waterfall(page, {t, {}}, {Window::Hann, SpectrumScale::Units});
  CHECK(page.note.find("Mean and trend are removed") != std::string::npos);
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
  const auto tick = [&](int f, bool on) {
    tree->topLevelItem(f)->setExpanded(true);
    tree->topLevelItem(f)->child(0)->child(0)->setCheckState(0, on ? Qt::Checked : Qt::Unchecked);
  };
  for (const int f : {1, 0, 2}) tick(f, true);
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
  tick(1, false);
  CHECK(dialog.picks().front().file == &files[2]);
  CHECK(dialog.picks().size() == 2);
  tick(2, false);
  CHECK(dialog.picks().front().file == &files[0]);
}
