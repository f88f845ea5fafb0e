#include "adrplot/cursor_time.hpp"
#include "adrplot/formula_document.hpp"
#include "adrplot/own_chart.hpp"
#include "adrplot/plot_window.hpp"
#include "agore/agore_window.hpp"
#include "desktop/chart_view.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Windows of AdrPlot and AGORE that show one run: shared time and element.
using namespace adore;

namespace {

constexpr int kPatience = 10000;  // [ms] of a busy machine
constexpr int kQuiet = 300;       // [ms] in which nothing may move

/// A run with twice as many plotted steps as frames.
struct Run {
  explicit Run(const QString& place) : folder(place) {
    QDir().mkpath(place);
    test::SyntheticRun frames, steps;
    frames.steps = 151, steps.steps = 301;
    write("SOL8", test::sol8_text(test::synthetic_sol8(frames)));
    for (const int element : {1, 3}) {
      results::SolFile file = test::synthetic_sol(results::SolKind::Element, steps);
      file.header.title = "Rolling Element No. " + std::to_string(element) + "$";
      file.header.index = element;
      write(element == 1 ? "SOL1" : "SOL2", test::sol_text(file));
    }
    write("SOL3", test::sol_text(test::synthetic_sol(results::SolKind::Cage, steps)));
    write("SOL7", test::sol_text(test::synthetic_sol(results::SolKind::Power, steps)));
  }
  void write(const char* name, const std::string& text) const {
    test::write_text((folder + "/" + name).toStdString(), text);
  }
  [[nodiscard]] std::filesystem::path file(const char* name) const {
    return (folder + "/" + name).toStdString();
  }
  QString folder;
};

struct Plot {
  explicit Plot(const Run& run, std::initializer_list<const char*> files = {"SOL7"}) {
    window.show();
    for (const char* file : files) REQUIRE(window.openFile(run.file(file)));
    motion = adrplot::open_document(run.file(files.begin()[0])).motion();
  }
  adrplot::PlotWindow window;
  adrplot::RunMotion motion;
  [[nodiscard]] double at() { return window.view().cursorAbscissa(0); }
  [[nodiscard]] std::optional<double> time() {
    return adrplot::time_of_cursor(window.view().chartScene().page(), motion, at());
  }
  /// Ctrl+click at a part of the abscissa, as a person sets cursor A.
  void clickAt(double part) {
    desktop::ChartView& view = window.view();
    const QRectF& area = view.chartScene().plotAreas().front();
    const QPoint at =
        view.mapFromScene(QPointF(area.left() + part * area.width(), area.center().y()));
    QTest::mouseClick(view.viewport(), Qt::LeftButton, Qt::ControlModifier, at);
  }
  /// The same with the button held down.
  void dragTo(double part) {
    desktop::ChartView& view = window.view();
    const QRectF& area = view.chartScene().plotAreas().front();
    const QPoint at =
        view.mapFromScene(QPointF(area.left() + part * area.width(), area.center().y()));
    QMouseEvent move(QEvent::MouseMove, at, view.viewport()->mapToGlobal(at), Qt::NoButton,
                     Qt::LeftButton, Qt::ControlModifier);
    QCoreApplication::sendEvent(view.viewport(), &move);
  }
  void type(const QString& action, bool on) {
    auto* found = window.findChild<QAction*>(action);
    REQUIRE(found != nullptr);
    if (found->isChecked() != on) found->trigger();
  }
};

struct Motion {
  explicit Motion(const Run& run) {
    window.show();
    REQUIRE(window.openFile(run.file("SOL8")));
  }
  agore::AgoreWindow window;
  [[nodiscard]] double time() { return window.picture()->animation().time[window.currentFrame()]; }
  [[nodiscard]] double step() {
    const auto& all = window.picture()->animation().time;
    return all[1] - all[0];
  }
};

bool comes(const std::function<bool()>& what) { return QTest::qWaitFor(what, kPatience); }
bool close(std::optional<double> a, double b, double within) {
  return a && std::abs(*a - b) <= within * (1.0 + 1e-9);
}

}  // namespace

TEST_CASE("linked windows: cursor A → nearest frame, and frame → cursor A, for each abscissa",
          "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run"));
  Plot plot(run);
  Motion motion(run);
  QTest::qWait(kQuiet);
  CHECK(motion.window.currentFrame() == 0);  // opening moves nothing
  CHECK(std::isnan(plot.window.view().cursorAbscissa(0)));
  for (const char* abscissa : {"over revolutions", "over time", "over steps"}) {
    INFO(abscissa);
    plot.window.findChild<QComboBox*>("abscissa")->setCurrentText(abscissa);
    plot.clickAt(0.3);
    REQUIRE(plot.time().has_value());
    CHECK(comes([&] { return close(plot.time(), motion.time(), 0.5 * motion.step()); }));
    CHECK(motion.window.currentFrame() > 30);
    plot.clickAt(0.7);
    CHECK(comes([&] { return close(plot.time(), motion.time(), 0.5 * motion.step()); }));
    const std::size_t frame = motion.window.currentFrame();
    CHECK(frame > 90);
    QTest::keyClick(&motion.window, Qt::Key_Right);
    CHECK(motion.window.currentFrame() == frame + 1);
    CHECK(comes([&] { return close(plot.time(), motion.time(), 1e-12); }));
    QTest::keyClick(&motion.window, Qt::Key_Home);
    CHECK(comes([&] { return close(plot.time(), 0.0, 1e-12); }));
  }
}

TEST_CASE("linked windows: cursor A dragged → the animation follows", "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run"));
  Plot plot(run);
  Motion motion(run);
  plot.clickAt(0.2);
  for (const double part : {0.3, 0.4, 0.5, 0.6}) {
    const double before = plot.at();
    plot.dragTo(part);
    CHECK(plot.at() > before);
    CHECK(comes([&] { return close(plot.time(), motion.time(), 0.5 * motion.step()); }));
  }
  const auto zoom = plot.window.view().chartScene().zoomed();
  CHECK_FALSE(zoom);
}

TEST_CASE("linked windows: after a change → no further movement", "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run"));
  Plot plot(run), second(run);
  Motion motion(run), other(run);
  QTest::qWait(kQuiet);
  plot.clickAt(0.337);  // between two frames
  const double at = plot.window.view().cursorAbscissa(0);
  CHECK(comes([&] { return other.time() > 0.0 && motion.time() == other.time(); }));
  CHECK(comes([&] { return second.window.view().cursorAbscissa(0) == at; }));
  const std::size_t frame = motion.window.currentFrame();
  QTest::qWait(kQuiet);
  CHECK(plot.window.view().cursorAbscissa(0) == at);
  CHECK(second.window.view().cursorAbscissa(0) == at);
  CHECK(motion.window.currentFrame() == frame);
  CHECK(other.window.currentFrame() == frame);
  // A repaint or another page is not a change of the user.
  plot.window.nextPage();
  motion.window.setColorQuantity(agore::ColourBy::None);
  QTest::qWait(kQuiet);
  CHECK(plot.window.view().cursorAbscissa(0) == at);
  CHECK(motion.window.currentFrame() == frame);
  // The playing animation moves cursors; a cursor stops the animation.
  motion.window.playForward();
  CHECK(comes([&] { return second.window.view().cursorAbscissa(0) > at; }));
  second.clickAt(0.1);
  CHECK(comes([&] { return !motion.window.playing(); }));
  CHECK(comes([&] { return close(second.time(), motion.time(), 0.5 * motion.step()); }));
}

TEST_CASE("linked windows: window that opens later → begins at the shared time", "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run"));
  Plot plot(run);
  plot.clickAt(0.6);
  Motion motion(run);
  CHECK(comes([&] { return close(plot.time(), motion.time(), 0.5 * motion.step()); }));
  CHECK(motion.time() > 0.0);
  const std::size_t frame = motion.window.currentFrame();
  motion.window.reload();
  CHECK(motion.window.currentFrame() == frame);
  // The same run by another name.
  REQUIRE(QFile::link(run.folder, base.filePath("alias")));
  Plot alias(Run{base.filePath("alias")});
  CHECK(comes([&] { return close(alias.time(), *plot.time(), 1e-12); }));
}

TEST_CASE("linked windows: cursor removed → stays removed; spectra have none", "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run"));
  Plot plot(run);
  Motion motion(run);
  plot.clickAt(0.5);
  CHECK(comes([&] { return motion.time() > 0.0; }));
  const std::size_t frame = motion.window.currentFrame();
  plot.window.setDomain(adrplot::Domain::Spectrum);
  CHECK(std::isnan(plot.window.view().cursorAbscissa(0)));
  plot.clickAt(0.2);  // a frequency
  QTest::qWait(kQuiet);
  CHECK(motion.window.currentFrame() == frame);
  plot.window.setDomain(adrplot::Domain::History);
  CHECK(close(plot.time(), motion.time(), 0.5 * motion.step()));
  plot.window.view().clearCursors();
  plot.window.nextPage();
  QTest::qWait(kQuiet);
  CHECK(std::isnan(plot.window.view().cursorAbscissa(0)));
  CHECK(motion.window.currentFrame() == frame);
}

TEST_CASE("linked windows: other run, or switched off → not moved; the choice is remembered",
          "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run")), other(base.filePath("other"));
  Plot plot(run);
  Motion motion(run), elsewhere(other);
  plot.clickAt(0.5);
  CHECK(comes([&] { return motion.time() > 0.0; }));
  CHECK(elsewhere.window.currentFrame() == 0);
  CHECK(QSettings("Adore", "adrplot").value("linkTime", true).toBool());
  plot.type("linkAction", false);
  const std::size_t frame = motion.window.currentFrame();
  const double at = plot.window.view().cursorAbscissa(0);
  plot.clickAt(0.9);
  motion.window.frameForward();
  QTest::qWait(kQuiet);
  CHECK(motion.window.currentFrame() == frame + 1);
  CHECK(plot.window.view().cursorAbscissa(0) > at);
  {
    Plot next(run);
    CHECK_FALSE(next.window.findChild<QAction*>("linkAction")->isChecked());
  }
  plot.type("linkAction", true);  // it receives the time of the others
  CHECK(comes([&] { return close(plot.time(), motion.time(), 1e-12); }));
  Plot next(run);
  CHECK(next.window.findChild<QAction*>("linkAction")->isChecked());
}

TEST_CASE("linked windows: element selected in one → selected in the other", "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run"));
  Plot plot(run, {"SOL1", "SOL2"});
  Motion motion(run);
  QTest::qWait(kQuiet);
  CHECK(motion.window.options().element == 1);  // opening selects nothing
  auto* tree = plot.window.findChild<QTreeWidget*>("pages");
  tree->setCurrentItem(tree->topLevelItem(0)->child(1));
  QTest::qWait(kQuiet);
  tree->setCurrentItem(tree->topLevelItem(1)->child(1));
  CHECK(comes([&] { return motion.window.options().element == 3; }));
  QTest::keyClick(&motion.window, Qt::Key_Down);  // element 2 has no file
  QTest::qWait(kQuiet);
  CHECK(motion.window.options().element == 2);
  CHECK(tree->currentItem() == tree->topLevelItem(1)->child(1));
  QTest::keyClick(&motion.window, Qt::Key_Down);
  CHECK(comes([&] { return tree->currentItem() == tree->topLevelItem(0)->child(1); }));
  QTest::qWait(kQuiet);
  CHECK(motion.window.options().element == 1);
  CHECK(plot.window.currentPage() == 2);
}

TEST_CASE("linked windows: cursor on a trajectory ↔ frame, in each plane and over each abscissa",
          "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run"));
  Plot plot(run, {"SOL3"});
  Motion motion(run);
  const adrplot::PlotDocument cage = adrplot::open_document(run.file("SOL3"));
  const auto orbit = std::find_if(cage.pages.begin(), cage.pages.end(), [](const auto& page) {
    return page.kind == adrplot::PageKind::Orbit;
  });
  REQUIRE(orbit != cage.pages.end());
  plot.window.showPage(static_cast<int>(orbit - cage.pages.begin()) + 1);
  desktop::ChartView& view = plot.window.view();
  auto* axes = plot.window.findChild<QComboBox*>("orbit");
  REQUIRE(axes != nullptr);
  for (const char* abscissa : {"over revolutions", "over time", "over steps"})
    for (int pair = 0; pair < axes->count(); ++pair) {
      INFO(abscissa << ", " << axes->itemText(pair).toStdString());
      plot.window.findChild<QComboBox*>("abscissa")->setCurrentText(abscissa);
      axes->setCurrentIndex(pair);
      const desktop::ChartPage& page = view.chartScene().page();
      REQUIRE(page.equal_axes);
      const desktop::ChartCurve& path = page.panels.front().curves.front();
      for (const std::size_t i : {std::size_t{40}, std::size_t{200}}) {
        const QPointF at = view.chartScene().planePosition(path.x[i], path.y[i]).value();
        QTest::mouseClick(view.viewport(), Qt::LeftButton, Qt::ControlModifier,
                          view.mapFromScene(at));
        REQUIRE(plot.time().has_value());
        // The trajectory crosses itself: another step may be there.
        const std::size_t chosen = desktop::nearest_index(page.along, plot.at());
        const QPointF marked =
            view.chartScene().planePosition(path.x[chosen], path.y[chosen]).value();
        // The line with the cursor values has made the chart lower.
        const QPointF wanted = view.chartScene().planePosition(path.x[i], path.y[i]).value();
        CHECK((marked - wanted).manhattanLength() < 12.0);
        CHECK(comes([&] { return close(plot.time(), motion.time(), 0.5 * motion.step()); }));
      }
      const std::size_t frame = motion.window.currentFrame();
      QTest::keyClick(&motion.window, frame > 0 ? Qt::Key_Left : Qt::Key_Right);
      CHECK(motion.window.currentFrame() != frame);
      CHECK(comes([&] { return close(plot.time(), motion.time(), 1e-12); }));
    }
}

TEST_CASE("linked windows: element selected in AGORE → user-defined charts and formulas follow",
          "[gui][links]") {
  test::use_qt();
  const QTemporaryDir base;
  const Run run(base.filePath("run"));
  Plot plot(run, {"SOL1", "SOL2"});
  Motion motion(run);
  QTest::qWait(kQuiet);
  const auto first =
      std::make_shared<adrplot::PlotDocument>(adrplot::open_document(run.file("SOL1")));
  const adrplot::PlotDocument third = adrplot::open_document(run.file("SOL2"));
  const auto shown = [&] { return plot.window.view().chartScene().page(); };
  const auto elements = [&] {
    std::vector<int> out;
    for (const auto& panel : shown().panels)
      for (const auto& curve : panel.curves) out.push_back(curve.element);
    return out;
  };
  plot.window.addChart({{first.get(), 1, 0, 0}}, adrplot::Combine::Overlay);
  CHECK(elements() == std::vector{1});
  QTest::keyClick(&motion.window, Qt::Key_Up);  // element 2 has no file
  REQUIRE(motion.window.options().element == 2);
  QTest::qWait(kQuiet);
  CHECK(elements() == std::vector{1});
  QTest::keyClick(&motion.window, Qt::Key_Up);
  CHECK(comes([&] { return elements() == std::vector{3}; }));
  CHECK(shown().note.find("element 3") != std::string::npos);
  // The chart itself keeps its curves.
  QTest::keyClick(&motion.window, Qt::Key_Down);
  QTest::keyClick(&motion.window, Qt::Key_Down);
  CHECK(comes([&] { return elements() == std::vector{1}; }));
  CHECK(shown().note.find("element 1") == std::string::npos);
  // A new chart is shown as it was made, then it follows.
  plot.window.addChart({{first.get(), 1, 0, 0}, {&third, 1, 0, 0}}, adrplot::Combine::Overlay);
  CHECK(elements() == std::vector{1, 3});
  const auto heavy = [&](std::size_t curve) { return shown().panels[0].curves[curve].heavy; };
  QTest::keyClick(&motion.window, Qt::Key_Up);
  QTest::keyClick(&motion.window, Qt::Key_Up);
  CHECK(comes([&] { return heavy(1); }));
  CHECK_FALSE(heavy(0));
  // A formula has the values of the element.
  adrplot::FormulaChannel channel{"Twice", "2*a", "", {}};
  channel.inputs.push_back({"a", first, 1, 0, first->build(1, {}).panels[0].curves[0].name});
  plot.window.addFormula(channel);
  CHECK(shown().note.find("selected in another window") == std::string::npos);
  QTest::keyClick(&motion.window, Qt::Key_Down);
  QTest::keyClick(&motion.window, Qt::Key_Up);
  CHECK(comes([&] { return shown().note.find("element 3") != std::string::npos; }));
  plot.type("linkAction", false);
  plot.window.showPage(plot.window.currentPage());
  CHECK(shown().note.find("selected in another window") == std::string::npos);
  plot.type("linkAction", true);  // the setting is stored
}

TEST_CASE("linked windows: results in memory → not linked", "[gui][links]") {
  test::use_qt();
  adrplot::PlotWindow plot;
  plot.show();
  plot.addFile(test::synthetic_sol(results::SolKind::Power));
  agore::AgoreWindow motion;
  motion.show();
  motion.setAnimation(agore::prepare(test::synthetic_sol8()));
  plot.view().setCursorAbscissa(0, 1.0);
  QTest::qWait(kQuiet);
  CHECK(motion.currentFrame() == 0);
}
