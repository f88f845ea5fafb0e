#include "adrinput/deck_window.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/run_time_bar.hpp"
#include "adrplot/cursor_time.hpp"
#include "adrplot/plot_window.hpp"
#include "agore/agore_window.hpp"
#include "desktop/chart_view.hpp"
#include "results/h5_reader.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProcess>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

/// AdrInput shows the values of a run at the time and for the element that all windows share.
using namespace adore;

namespace {

constexpr int kPatience = 10000;  // [ms] of a busy machine
constexpr int kQuiet = 300;       // [ms] in which nothing may move

bool comes(const std::function<bool()>& what) { return QTest::qWaitFor(what, kPatience); }

/// A deck and its run.
struct Run {
  Run() {
    const auto adore = [](const QStringList& arguments) {
      return QProcess::execute(QString::fromStdString(test::program("adore").string()),
                               arguments) == 0;
    };
    REQUIRE(adore({"new", "ball", "--out", folder.filePath("DATA.txt")}));
    REQUIRE(adore({"run", folder.path(), "--until", "40", "--set", "kPltFreq=1", "--set",
                   "kAGraf=2", "--quiet"}));
  }
  [[nodiscard]] std::filesystem::path file(const char* name) const {
    return folder.filePath(name).toStdString();
  }
  QTemporaryDir folder;
};

struct Input {
  explicit Input(const Run& run) {
    window.show();
    REQUIRE(window.openFile(run.file("DATA.txt")));
    showRunTab();
  }
  void showRunTab() {
    for (auto* tabs : window.findChildren<QTabWidget*>())
      for (int i = 0; i < tabs->count(); ++i)
        if (tabs->widget(i)->isAncestorOf(&window.runPanel())) tabs->setCurrentIndex(i);
    window.showRecord("1");
  }
  adrinput::DeckWindow window;
  adrinput::RunTimeBar& bar = window.runPanel().timeBar();
};

}  // namespace

TEST_CASE("run times: values in AdrInput at a step → those of RESULTS.h5", "[gui][links]") {
  test::use_qt();
  const Run run;
  Input input(run);
  REQUIRE(comes([&] { return input.bar.isVisible() && input.bar.hasValues(); }));
  const results::H5Reader reader(run.file("RESULTS.h5"));
  const std::vector<double> times = reader.read("time");
  CHECK(input.bar.time() == times.back());  // the end of the run
  const adrinput::RunMotionValues values(run.file("RESULTS.h5"));
  const std::size_t step = times.size() / 2;
  CHECK(values.step_at(times[step]) == step);
  CHECK(values.step_at(-1.0) == 0);
  CHECK(values.step_at(1e9) == times.size() - 1);
  const double load = reader.read("contact.load", step, 1).at(2 * 2 + 1);  // element 3, inner race
  REQUIRE(load > 0.0);
  const std::string text = values.describe(step, 3).front();
  INFO(text);
  CHECK(text.starts_with("Element 3: outer race "));
  const std::size_t inner = text.find("inner race ");
  REQUIRE(inner != std::string::npos);
  CHECK(std::stod(text.substr(inner + 11)) *
            (text.find("kN", inner) < text.find(',', inner) ? 1000.0 : 1.0) ==
        Approx(load).epsilon(1e-3));
  for (const auto& line : values.describe(step, 3)) {
    INFO(line);
    CHECK(line.back() == '.');
    CHECK(line.find("nan") == std::string::npos);
  }
  // The slider and the field select stored steps.
  input.window.findChild<QSlider*>("run-time-slider")->setValue(static_cast<int>(step));
  CHECK(input.bar.time() == times[step]);
  auto* field = input.window.findChild<QDoubleSpinBox*>("run-time");
  field->setValue(1e9);
  CHECK(input.bar.time() == times.back());
  const std::string last = "Step " + std::to_string(reader.step_numbers().back()) + " (";
  CHECK(comes([&] { return input.bar.text().toStdString().starts_with(last); }));
}

TEST_CASE("run times: time and element of AdrInput, AdrPlot and AGORE → one for all",
          "[gui][links]") {
  test::use_qt();
  const Run run;
  Input input(run);
  adrplot::PlotWindow plot;
  plot.show();
  REQUIRE(plot.openFile(run.file("SOL1")));
  plot.setAbscissa(adrplot::Abscissa::Time);
  agore::AgoreWindow motion;
  motion.show();
  REQUIRE(motion.openFile(run.file("SOL8")));
  REQUIRE(comes([&] { return input.bar.hasValues(); }));
  QTest::qWait(kQuiet);
  CHECK(motion.currentFrame() == 0);  // opening moves nothing
  CHECK(std::isnan(plot.view().cursorAbscissa(0)));
  const auto& frames = motion.picture()->animation().time;
  // From AdrInput to the others.
  auto* slider = input.window.findChild<QSlider*>("run-time-slider");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_PageDown);
  const double time = input.bar.time();
  CHECK(time < frames.back());
  CHECK(comes([&] { return std::abs(plot.view().cursorAbscissa(0) - time) < 1e-12; }));
  CHECK(comes([&] { return motion.currentFrame() == motion.picture()->frameAt(time); }));
  // From AGORE.
  QTest::keyClick(&motion, Qt::Key_Home);
  CHECK(comes([&] { return input.bar.time() == frames.front(); }));
  // From AdrPlot.
  plot.view().setCursorAbscissa(0, frames[5]);
  CHECK(comes([&] { return std::abs(input.bar.time() - frames[5]) < 1e-12; }));
  CHECK(comes([&] { return motion.currentFrame() == 5; }));
  // The element, both ways.
  input.window.findChild<QSpinBox*>("run-element")->setValue(4);
  CHECK(comes([&] { return motion.options().element == 4; }));
  QTest::keyClick(&motion, Qt::Key_Up);
  CHECK(comes([&] { return input.bar.element() == 5; }));
  CHECK(comes([&] { return input.bar.text().contains("Element 5: "); }));
  CHECK(input.window.findChild<QSpinBox*>("run-element")->value() == 5);
  // Switched off in the menu.
  auto* action = input.window.findChild<QAction*>("linkAction");
  REQUIRE(action != nullptr);
  action->trigger();
  QTest::keyClick(&motion, Qt::Key_End);
  QTest::qWait(kQuiet);
  CHECK(std::abs(input.bar.time() - frames[5]) < 1e-12);
  action->trigger();
  CHECK(comes([&] { return input.bar.time() == frames.back(); }));
}

TEST_CASE("run times: no, damaged or replaced RESULTS.h5 → hidden, or a message", "[gui][links]") {
  test::use_qt();
  const Run run;
  const std::string bytes = test::bytes_of(run.file("RESULTS.h5"));
  const auto write = [&](const std::string& text) {
    std::ofstream(run.file("RESULTS.h5"), std::ios::binary) << text;
  };
  for (const std::string& damaged :
       {std::string(), std::string("garbage"), bytes.substr(0, 100), bytes.substr(0, 3000)}) {
    INFO(damaged.size() << " bytes");
    write(damaged);
    Input input(run);
    CHECK(comes([&] { return input.bar.isVisible(); }));
    CHECK_FALSE(input.bar.hasValues());
    CHECK(input.bar.text().contains("RESULTS.h5"));
    CHECK_FALSE(input.window.findChild<QSlider*>("run-time-slider")->isVisible());
    CHECK(test::bytes_of(run.file("RESULTS.h5")) == damaged);
  }
  std::filesystem::remove(run.file("RESULTS.h5"));
  Input input(run);
  QTest::qWait(kQuiet);
  CHECK_FALSE(input.bar.isVisible());
  write(bytes);  // a run of another program has ended
  CHECK(comes([&] { return input.bar.hasValues(); }));
}
