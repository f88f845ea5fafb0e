#include "adrplot/plot_window.hpp"
#include "adrplot/render.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/errors.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/chart_view.hpp"
#include "support/bytes.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"
#include "support/synthetic_results.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

/// Envelope spectra and order spectra.
using namespace adore;
using namespace adore::adrplot;
using Catch::Contains;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kStep = 5e-5;        // [s]: up to 10 kHz
constexpr std::size_t kCount = 8001;  // 0.4 s

/// A shaft that accelerates; a cage with 0.4 of its speed.
struct RunUp {
  double speed = 20.0, gain = 0.0;  // [rev/s], [rev/s^2]
  [[nodiscard]] double turns(double t) const { return speed * t + 0.5 * gain * t * t; }
};

RunMotion motion_of_run(const RunUp& run, std::size_t count = kCount) {
  RunMotion out;
  for (std::size_t i = 0; i < count; ++i) {
    out.times.push_back(kStep * static_cast<double>(i));
    out.turns.push_back(run.turns(out.times.back()));
  }
  out.source = "bearing rotation in SOL1";
  for (const auto& [label, order] : {std::pair{"shaft", 1.0}, {"FTF", 0.4}, {"BPFO", 3.2}}) {
    MarkEventCounts mark{label, out.times, out.turns};
    for (double& turn : mark.turns) turn *= order;
    out.marks.push_back(mark);
  }
  return out;
}

desktop::ChartPage page_of(const RunMotion& motion, auto&& value) {
  desktop::ChartPage page;
  page.title = "Loads";
  desktop::ChartCurve curve{"outer race", {}, {}};
  for (const double t : motion.times) curve.y.push_back(value(t));
  page.panels = {{"Load", "N", {curve}, false}};
  return page;
}

/// A tone of 4 kHz and 3 N, modulated by 40 % at 64 Hz (BPFO of the run), and a strong slow one.
double modulated(double t) {
  return 500.0 + 30.0 * std::sin(kTurn * 50.0 * t) +
         3.0 * (1.0 + 0.4 * std::cos(kTurn * 64.0 * t)) * std::sin(kTurn * 4000.0 * t);
}

std::pair<double, double> highest(const desktop::ChartPage& page) {
  const std::vector<double>& y = page.panels.at(0).curves.at(0).y;
  const auto at = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
  return {page.x.at(at), y.at(at)};
}

double mark_at(const desktop::ChartPage& page, const std::string& label) {
  for (const desktop::ChartMark& mark : page.marks)
    if (mark.label == label) return mark.x;
  return 0.0;
}

/// Time, vibration of order 3 and speed of a run-up from 600 to 3000 rpm; the modulated tone.
std::string table_of_run_up(bool with_speed) {
  const RunUp run{10.0, 100.0};
  std::string out = "Time [s],Vibration [m/s^2],Load [N]";
  out += with_speed ? ",Speed [rpm]\n" : "\n";
  for (std::size_t i = 0; i < kCount; ++i) {
    const double t = kStep * static_cast<double>(i);
    out += fmt::format("{:.9g},{:.12g},{:.12g}", t, 2.0 * std::sin(kTurn * 3.0 * run.turns(t)),
                       modulated(t));
    out += with_speed ? fmt::format(",{:.9g}\n", 60.0 * (run.speed + run.gain * t)) : "\n";
  }
  return out;
}

void select(PlotWindow& window, const QString& type) {
  auto* domain = window.findChild<QComboBox*>("domain");
  REQUIRE(domain);
  const int index = domain->findText(type);
  REQUIRE(index >= 0);
  domain->setCurrentIndex(index);
}

const desktop::ChartPage& shown(PlotWindow& window) { return window.view().chartScene().page(); }

}  // namespace

TEST_CASE("envelope spectrum: modulated tone → line A m at the modulation, band from the data",
          "[unit]") {
  const RunMotion motion = motion_of_run({20.0});
  const SpectrumOptions automatic{Window::FlatTop};
  desktop::ChartPage page = page_of(motion, modulated);
  to_spectra(page, motion, automatic, Domain::Envelope);
  CHECK(page.title == "Loads: envelope spectrum");
  CHECK(page.x_unit == "Hz");
  CHECK(page.panels.at(0).unit == "N");
  CHECK(highest(page).first == Approx(64.0).margin(3.0));
  CHECK(highest(page).second == Approx(3.0 * 0.4).epsilon(0.01));
  CHECK(mark_at(page, "BPFO") == Approx(64.0));
  INFO(page.note);
  CHECK_THAT(page.note, Contains("(automatic: strongest modulation)"));
  // Lines above the width of the band do not exist.
  SpectrumOptions band = automatic;
  band.band = {3500.0, 4500.0};
  page = page_of(motion, modulated);
  to_spectra(page, motion, band, Domain::Envelope);
  CHECK(highest(page).second == Approx(3.0 * 0.4).epsilon(0.01));
  CHECK(page.x.back() <= 1000.0 * (1.0 + 1e-9));
  CHECK(page.x.back() > 990.0);
  CHECK_THAT(page.note, Contains("Envelope of the band 3.5 kHz to 4.5 kHz."));
  // In decibels of 1 N.
  band.scale = SpectrumScale::Decibel;
  page = page_of(motion, modulated);
  to_spectra(page, motion, band, Domain::Envelope);
  CHECK(page.panels.at(0).unit == "dB re 1 N");
  CHECK(highest(page).second == Approx(20.0 * std::log10(1.2)).margin(0.1));
}

TEST_CASE("envelope spectrum: orders of shaft and cage → modulation at its order in a run-up",
          "[unit]") {
  // The modulation has 3.2 periods per revolution of the shaft and 8 per revolution of the cage.
  const RunUp run{10.0, 100.0};
  const RunMotion motion = motion_of_run(run);
  const auto value = [&](double t) {
    return 3.0 * (1.0 + 0.4 * std::cos(kTurn * 3.2 * run.turns(t))) * std::sin(kTurn * 4000.0 * t);
  };
  for (const auto& [part, order, unit] : {std::tuple{OrderReference::Shaft, 3.2, "shaft orders"},
                                          {OrderReference::Cage, 8.0, "cage orders"}}) {
    SpectrumOptions options{Window::FlatTop};
    options.orders_of = part;
    options.band = {3000.0, 5000.0};
    desktop::ChartPage page = page_of(motion, value);
    to_spectra(page, motion, options, Domain::Envelope);
    INFO(page.note);
    CHECK(page.x_unit == unit);
    CHECK(highest(page).first == Approx(order).margin(0.5 * order / 3.2));
    CHECK(highest(page).second == Approx(3.0 * 0.4).epsilon(0.02));
    CHECK(mark_at(page, "BPFO") == Approx(order));
  }
  // Over frequency the line is spread.
  desktop::ChartPage page = page_of(motion, value);
  to_spectra(page, motion, {Window::Hann}, Domain::Envelope);
  CHECK(highest(page).second < 0.6);
}

TEST_CASE("order spectrum: run-up with order 3 → one line, speed and its source in the note",
          "[unit]") {
  const RunUp run{10.0, 100.0};
  const RunMotion motion = motion_of_run(run);
  const auto value = [&](double t) { return 2.0 * std::sin(kTurn * 3.0 * run.turns(t)); };
  desktop::ChartPage page = page_of(motion, value);
  to_spectra(page, motion, {Window::FlatTop}, Domain::Orders);
  INFO(page.note);
  CHECK(page.title == "Loads: order spectrum");
  CHECK(page.x_unit == "shaft orders");
  CHECK(highest(page).first == Approx(3.0).margin(0.15));
  CHECK(highest(page).second == Approx(2.0).epsilon(0.01));
  CHECK(mark_at(page, "shaft") == Approx(1.0));
  CHECK(mark_at(page, "FTF") == Approx(0.4));
  CHECK_THAT(page.note, Contains("Speed of the shaft: 660.0 rpm to 2940 rpm (bearing rotation in "
                                 "SOL1)."));
  // Half of the rate of the steps at the highest speed, 50 revolutions per second.
  CHECK(page.x.back() == Approx(0.5 / kStep / 50.0).epsilon(0.03));
  SpectrumOptions cage{Window::FlatTop};
  cage.orders_of = OrderReference::Cage;
  page = page_of(motion, value);
  to_spectra(page, motion, cage, Domain::Orders);
  CHECK(page.x_unit == "cage orders");
  CHECK(highest(page).first == Approx(7.5).margin(0.3));
}

TEST_CASE("envelope and order spectra: impossible → the reason instead of an empty page",
          "[unit]") {
  const auto reason = [](const RunMotion& motion, const SpectrumOptions& options, Domain domain,
                         auto&& value) {
    desktop::ChartPage page = page_of(motion, value);
    to_spectra(page, motion, options, domain);
    CHECK(page.panels.empty());
    return page.note;
  };
  const RunMotion motion = motion_of_run({20.0});
  SpectrumOptions options;
  options.band = {3000.0, 12000.0};
  CHECK_THAT(reason(motion, options, Domain::Envelope, modulated),
             Contains("exceeds 10 kHz") && Contains("Enter a band below this frequency."));
  options.band = {4000.0, 4004.0};
  CHECK_THAT(reason(motion, options, Domain::Envelope, modulated),
             Contains("narrower than 4 lines"));
  CHECK_THAT(reason(motion_of_run({20.0}, 40), {}, Domain::Envelope, modulated),
             Contains("at least 64 stored steps. This curve has 40."));
  CHECK_THAT(reason(motion_of_run({20.0}, 10), {}, Domain::Envelope, modulated),
             Contains("at least 16 stored steps"));
  CHECK_THAT(reason(motion, {}, Domain::Envelope, [](double t) { return 3.0 * t; }),
             Contains("no vibration from 625 Hz to 10 kHz"));
  CHECK_THAT(reason(motion, {}, Domain::Envelope, [](double) { return 3.0; }),
             Contains("the value is constant"));
  RunMotion unknown = motion;
  unknown.turns.clear();
  unknown.marks.clear();
  CHECK_THAT(reason(unknown, {}, Domain::Orders, modulated),
             Contains("The speed of the shaft is not known"));
  options = {};
  options.orders_of = OrderReference::Element;
  CHECK_THAT(reason(motion, options, Domain::Orders, modulated),
             Contains("The speed of the element is not known") && Contains("RESULTS.h5"));
  RunMotion still = motion;
  for (std::size_t i = 4000; i < still.turns.size(); ++i) still.turns[i] = still.turns[4000];
  CHECK_THAT(reason(still, {}, Domain::Orders, modulated),
             Contains("The shaft stops or reverses at 200 ms"));
  RunMotion oscillating = motion;
  oscillating.oscillates = true;
  CHECK_THAT(reason(oscillating, {}, Domain::Orders, modulated), Contains("The shaft oscillates"));
}

TEST_CASE("plot_window: table with speed → order and envelope spectra, band dialog, session",
          "[gui]") {
  test::use_qt();
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath("run.csv").toStdString();
  test::write_text(file, table_of_run_up(true));
  const QString session = folder.filePath("saved.adrplot");
  {
    PlotWindow window;
    window.resize(1280, 800);
    REQUIRE(window.openFile(file));
    window.show();
    select(window, "order spectrum");
    CHECK(shown(window).x_unit == "shaft orders");
    CHECK(highest(shown(window)).first == Approx(3.0).margin(0.15));
    CHECK(highest(shown(window)).second == Approx(2.0).epsilon(0.16));  // Hann, between lines
    CHECK_THAT(shown(window).note, Contains("column \"Speed\""));
    CHECK(window.view().chartScene().viewHigh() < 100.0);
    select(window, "envelope spectrum");
    window.showPage(2);
    CHECK(highest(shown(window)).first == Approx(64.0).margin(3.0));
    CHECK_THAT(shown(window).note, Contains("automatic"));
    auto* action = window.findChild<QAction*>("band");
    REQUIRE(action);
    CHECK(action->isEnabled());
    action->trigger();
    auto* dialog = window.findChild<QDialog*>("bandDialog");
    REQUIRE(dialog);
    auto* automatic = dialog->findChild<QCheckBox*>("automatic");
    auto* low = dialog->findChild<QDoubleSpinBox*>("low");
    auto* high = dialog->findChild<QDoubleSpinBox*>("high");
    auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    REQUIRE((automatic && low && high && ok));
    CHECK(automatic->isChecked());
    CHECK_FALSE(low->isEnabled());
    automatic->click();
    CHECK_FALSE(ok->isEnabled());  // 0 to 0 Hz
    low->setValue(3600.0);
    high->setValue(4400.0);
    CHECK(ok->isEnabled());
    ok->click();
    CHECK_THAT(shown(window).note, Contains("Envelope of the band 3.6 kHz to 4.4 kHz."));
    CHECK(shown(window).x.back() == Approx(800.0).margin(3.0));
    for (QAction* one : window.findChildren<QAction*>())
      if (one->text() == "shaft") one->trigger();
    CHECK(shown(window).x_unit == "shaft orders");
    REQUIRE(window.saveSession(session));
  }
  PlotWindow again;
  REQUIRE(again.openSession(session));
  CHECK(again.findChild<QComboBox*>("domain")->currentText() == "envelope spectrum");
  CHECK(shown(again).x_unit == "shaft orders");
  CHECK_THAT(shown(again).note, Contains("Envelope of the band 3.6 kHz to 4.4 kHz."));
  // Histories have no band.
  select(again, "history");
  CHECK_FALSE(again.findChild<QAction*>("band")->isEnabled());
  CHECK_THAT(again.findChild<QAction*>("band")->toolTip().toStdString(),
             Contains("\"envelope spectrum\""));
}

TEST_CASE("plot_window: user-defined chart → orders of each curve; table without speed → reason",
          "[gui]") {
  test::use_qt();
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath("run.csv").toStdString(),
                              plain = folder.filePath("plain.csv").toStdString();
  test::write_text(file, table_of_run_up(true));
  test::write_text(plain, table_of_run_up(false));
  const PlotDocument with = open_document(file), without = open_document(plain);
  PageOptions options;
  options.domain = Domain::Orders;
  const desktop::ChartPage page = combine_curves({{&with, 1, 0, 0}}, Combine::Overlay, options);
  CHECK(page.title == "Selected curves: order spectrum");
  CHECK(page.x_unit == "shaft orders");
  CHECK(highest(page).first == Approx(3.0).margin(0.15));
  const desktop::ChartPage none = without.build(1, options);
  CHECK(none.panels.empty());
  CHECK_THAT(none.note, Contains("a table column with the unit rpm"));
  CHECK_THAT(combine_curves({{&without, 1, 0, 0}}, Combine::Overlay, options).note,
             Contains("The speed of the shaft is not known"));
}

TEST_CASE("render: envelope and orders of a result file as pictures; options of other types",
          "[gui]") {
  test::use_qt();
  const QTemporaryDir folder;
  const PlotDocument document = make_document(test::synthetic_sol(results::SolKind::Element));
  RenderOptions options;
  options.folder = folder.path().toStdString();
  options.page = 6;
  parse_domain_options(options.view, "orders", "", "db", "", "", "shaft");
  CHECK(options.view.domain == Domain::Orders);
  CHECK(options.view.spectrum.orders_of == OrderReference::Shaft);
  const auto orders = render_document(document, "orders", options);
  REQUIRE(orders.size() == 1);
  parse_domain_options(options.view, "envelope", "", "", "", "10:400.5");
  CHECK(options.view.spectrum.band.low == 10.0);
  CHECK(options.view.spectrum.band.high == 400.5);
  CHECK(options.view.spectrum.orders_of == OrderReference::Automatic);
  const auto envelope = render_document(document, "envelope", options);
  REQUIRE(envelope.size() == 1);
  CHECK(test::bytes_of(orders.front()) != test::bytes_of(envelope.front()));
  for (const char* band : {"10", "10:", ":10", "20:10", "a:b", "10:20:30", "-5:10", "0:inf"})
    CHECK_THROWS_WITH(parse_domain_options(options.view, "envelope", "", "", "", band),
                      Contains("--band = ") && Contains("such as 2000:8000"));
  CHECK_THROWS_WITH(parse_domain_options(options.view, "spectrum", "", "", "", "10:20"),
                    Contains("--domain envelope"));
  CHECK_THROWS_WITH(parse_domain_options(options.view, "spectrum", "", "", "", "", "cage"),
                    Contains("--domain orders or envelope"));
}
