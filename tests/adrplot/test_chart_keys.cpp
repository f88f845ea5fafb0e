#include "adrplot/plot_window.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/study_chart.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QAction>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QTreeWidget>
#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

/// AdrPlot without a mouse.
using namespace adore;
using namespace adore::adrplot;
using desktop::ChartAction;
using desktop::ChartPage;
using desktop::ChartView;

namespace {

struct Shown {
  explicit Shown(results::SolKind kind = results::SolKind::Race) {
    window.resize(1100, 760);
    window.addFile(test::synthetic_sol(kind));
    window.show();
    REQUIRE(QTest::qWaitForWindowActive(&window));
    view().setFocus();
    REQUIRE(QApplication::focusWidget() == &view());
  }
  ChartView& view() { return window.view(); }
  desktop::ChartScene& scene() { return view().chartScene(); }
  void press(int key, Qt::KeyboardModifiers held = Qt::NoModifier, int times = 1) {
    for (int i = 0; i < times; ++i) QTest::keyClick(&view(), static_cast<Qt::Key>(key), held);
  }
  QString read() { return window.findChild<QLabel*>("readout")->text(); }
  bool qt = (test::use_qt(), true);  // before any window
  PlotWindow window;
};

/// "12.3 rev:" of a stored step.
QString head_of(const ChartPage& page, std::size_t i) {
  return QString::fromStdString(desktop::pretty_quantity(page.x[i], page.x_unit, 5)) + ":";
}

/// All that somebody sees or reads, as text.
QString state_of(ChartView& view, const QStringList& read) {
  const desktop::ChartZoom zoom = view.chartScene().zoom();
  QString out = QString("%1 %2 ").arg(zoom.low, 0, 'g', 17).arg(zoom.high, 0, 'g', 17);
  for (const auto& range : zoom.panels)
    out += range ? QString("[%1 %2]").arg(range->first, 0, 'g', 17).arg(range->second, 0, 'g', 17)
                 : QString("[]");
  return out + read.join("") + view.cursorReport();
}

}  // namespace

TEST_CASE("plot_window: keys zoom and move a chart up to the end of the run", "[gui]") {
  Shown shown;
  const std::vector<double> x = shown.scene().page().x;
  const double first = x.front(), last = x.back(), all = last - first;
  shown.press(Qt::Key_Plus);
  CHECK(shown.scene().viewLow() == Approx(first + 0.25 * all));
  CHECK(shown.scene().viewHigh() == Approx(last - 0.25 * all));
  shown.press(Qt::Key_Right);
  CHECK(shown.scene().viewLow() == Approx(first + 0.30 * all));
  CHECK(shown.scene().viewHigh() == Approx(first + 0.80 * all));
  shown.press(Qt::Key_Right, Qt::ShiftModifier);
  CHECK(shown.scene().viewLow() == Approx(first + 0.5 * all));
  CHECK(shown.scene().viewHigh() == last);
  shown.press(Qt::Key_Left, Qt::ShiftModifier);
  CHECK(shown.scene().viewLow() == first);
  CHECK(shown.scene().viewHigh() == Approx(first + 0.5 * all));
  // Ways that follow each other are one view to come back to.
  shown.view().zoomBack();
  CHECK(shown.scene().viewLow() == Approx(first + 0.25 * all));
  shown.press(Qt::Key_Minus);
  CHECK(shown.scene().viewLow() == first);
  CHECK(shown.scene().viewHigh() == last);
}

TEST_CASE("plot_window: keys enlarge and move the values of the panel that a bar marks", "[gui]") {
  Shown shown;
  REQUIRE(shown.scene().page().panels.size() > 1);
  const QRectF area = shown.scene().plotAreas()[1];
  const double low = shown.scene().valueAt(1, area.bottom()),
               high = shown.scene().valueAt(1, area.top()), span = high - low;
  const auto bar = [&](std::size_t panel) {
    const QRectF at = shown.scene().plotAreas()[panel];
    const QImage image = shown.view().viewport()->grab().toImage();
    return image.pixelColor(static_cast<int>(at.left()) - 2, static_cast<int>(at.center().y())) ==
           desktop::current_theme().accent;
  };
  CHECK(bar(0));
  shown.press(Qt::Key_Down, Qt::ControlModifier);
  CHECK(bar(1));
  CHECK_FALSE(bar(0));
  shown.press(Qt::Key_Plus, Qt::ControlModifier);
  REQUIRE(shown.scene().zoom().panels[1]);
  CHECK_FALSE(shown.scene().zoom().panels[0]);
  CHECK(shown.scene().zoom().panels[1]->first == Approx(low + 0.25 * span).margin(1e-9 * span));
  CHECK(shown.scene().zoom().panels[1]->second == Approx(low + 0.75 * span).margin(1e-9 * span));
  shown.press(Qt::Key_Up);
  CHECK(shown.scene().zoom().panels[1]->first == Approx(low + 0.30 * span).margin(1e-9 * span));
  shown.press(Qt::Key_Down, Qt::NoModifier, 2);
  CHECK(shown.scene().zoom().panels[1]->first == Approx(low + 0.20 * span).margin(1e-9 * span));
  shown.press(Qt::Key_Home);
  CHECK_FALSE(shown.scene().zoom().panels[1]);
}

TEST_CASE("plot_window: keys read one stored step after the other, and set both cursors", "[gui]") {
  Shown shown;
  const ChartPage page = shown.scene().page();
  const std::size_t middle = desktop::nearest_index(page.x, 0.5 * (page.x.front() + page.x.back()));
  CHECK(shown.read() == "");
  shown.press(Qt::Key_Right, Qt::ControlModifier);
  CHECK(shown.read().startsWith(head_of(page, middle)));
  const desktop::ChartCurve& curve = page.panels[0].curves[0];
  for (std::size_t i = middle + 1; i < middle + 4; ++i) {
    shown.press(Qt::Key_Right, Qt::ControlModifier);
    CHECK(shown.read().startsWith(head_of(page, i)));
    const int digits = shown.scene().digitsOf(0, 0);
    CHECK(shown.read().contains(
        QString::fromStdString(desktop::pretty_quantity(curve.y[i], page.panels[0].unit, digits))));
    // The complete text for a screen reader.
    CHECK(shown.view().accessibleDescription().startsWith(head_of(page, i)));
  }
  shown.press(Qt::Key_A);
  CHECK(shown.view().cursorAbscissa(0) == page.x[middle + 3]);
  shown.press(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier, 3);
  shown.press(Qt::Key_B);
  const double b = shown.view().cursorAbscissa(1), part = 0.15 * (page.x.back() - page.x.front());
  CHECK(b == Approx(page.x[middle + 3] + part).margin(0.1 * part));
  CHECK(shown.view().cursorReport().contains("B − A"));
  shown.press(Qt::Key_Z);
  CHECK(shown.scene().viewLow() == Approx(page.x[middle + 3]));
  CHECK(shown.scene().viewHigh() == Approx(b));
  // The readout is at B: the next step is outside the view, which follows.
  shown.press(Qt::Key_Right, Qt::ControlModifier);
  CHECK(shown.scene().viewHigh() > b);
  CHECK(shown.read().startsWith(head_of(page, desktop::nearest_index(page.x, b) + 1)));
  shown.press(Qt::Key_Left, Qt::ControlModifier);
  shown.press(Qt::Key_B);
  CHECK(std::isnan(shown.view().cursorAbscissa(1)));  // its earlier place
  CHECK(shown.view().cursorAbscissa(0) == page.x[middle + 3]);
  // Enlarged about the place that is read.
  shown.press(Qt::Key_Home);
  shown.press(Qt::Key_Plus, Qt::NoModifier, 3);
  const double whole = page.x.back() - page.x.front();
  CHECK((b - shown.scene().viewLow()) / (shown.scene().viewHigh() - shown.scene().viewLow()) ==
        Approx((b - page.x.front()) / whole));
  // The same place on the next page of the run, and nothing after Esc.
  shown.press(Qt::Key_PageDown);
  CHECK(shown.read().startsWith(head_of(page, desktop::nearest_index(page.x, b))));
  shown.press(Qt::Key_Escape);
  CHECK(shown.read() == "");
  CHECK(shown.view().cursorReport() == "");
  CHECK(shown.view().accessibleDescription() == QString::fromStdString(shown.scene().page().title));
}

TEST_CASE("plot_window: digit keys → hide curves of the legends, as in their menu", "[gui]") {
  Shown shown(results::SolKind::Element);
  int tried = 0;
  for (int number = 1; number <= shown.window.pageCount(); ++number) {
    shown.window.showPage(number);
    shown.view().setFocus();
    INFO("page " << number);
    const auto names = shown.view().legendCurves();
    auto* menu = shown.window.findChild<QMenu*>("names");
    REQUIRE(menu != nullptr);
    CHECK(menu->menuAction()->isEnabled() == !names.empty());
    QList<QAction*> seen;
    for (QAction* action : menu->actions())
      if (action->isVisible()) seen << action;
    REQUIRE(seen.size() == static_cast<qsizetype>(names.size()));
    for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 9); ++i) {
      const auto hidden = [&] {
        return shown.scene().page().panels[names[i].panel].curves[names[i].curve].hidden;
      };
      CHECK(seen[static_cast<qsizetype>(i)]->text().remove("&").contains(QString::fromStdString(
          shown.scene().page().panels[names[i].panel].curves[names[i].curve].name)));
      shown.press(Qt::Key_1 + static_cast<int>(i));
      CHECK(hidden());
      CHECK_FALSE(seen[static_cast<qsizetype>(i)]->isChecked());
      shown.press(Qt::Key_1 + static_cast<int>(i));
      CHECK_FALSE(hidden());
      CHECK(seen[static_cast<qsizetype>(i)]->isChecked());
      ++tried;
    }
  }
  CHECK(tried > 4);
}

TEST_CASE("plot_window: cursor → values of the visible curves only", "[gui]") {
  Shown shown(results::SolKind::Element);
  int page = 1;
  while (page < shown.window.pageCount() && shown.view().legendCurves().size() < 2)
    shown.window.showPage(++page);
  REQUIRE(shown.view().legendCurves().size() >= 2);
  shown.view().setFocus();
  shown.press(Qt::Key_A);
  auto* told = shown.window.findChild<QLabel*>("cursors");
  REQUIRE(told != nullptr);
  const auto lines = told->text().count('\n');
  shown.press(Qt::Key_1);
  CHECK(told->text().count('\n') == lines - 1);
  shown.press(Qt::Key_1);
  CHECK(told->text().count('\n') == lines);
}

TEST_CASE("plot_window: chart keys act only with the focus, shown by a frame", "[gui]") {
  Shown shown;
  const auto edge = [&] {
    return shown.view().viewport()->grab().toImage().pixelColor(1, shown.view().height() / 2);
  };
  CHECK(edge() == desktop::current_theme().accent);
  auto* tree = shown.window.findChild<QTreeWidget*>("pages");
  tree->setFocus();
  CHECK(edge() == desktop::current_theme().surface);
  const QString before = state_of(shown.view(), {shown.read()});
  for (const int key : {+Qt::Key_Plus, +Qt::Key_A, +Qt::Key_B, +Qt::Key_1, +Qt::Key_Right})
    QTest::keyClick(tree, static_cast<Qt::Key>(key));
  QTest::keyClick(tree, Qt::Key_Right, Qt::ControlModifier);
  CHECK(state_of(shown.view(), {shown.read()}) == before);
  // Tab leads there.
  for (int i = 0; i < 20 && QApplication::focusWidget() != &shown.view(); ++i)
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  CHECK(QApplication::focusWidget() == &shown.view());
}

namespace {

/// Every action has an effect, or is gray with a reason.
void check_actions(ChartView& view, const QList<QAction*>& actions, const QStringList& read,
                   int& done, int& grey) {
  // Performing one changes the state for the next: what they are is tried from many states.
  for (int d = 0; d < desktop::kChartDeeds; ++d) {
    const auto deed = static_cast<ChartAction>(d);
    INFO("deed " << d << " after " << state_of(view, read).toStdString());
    const QString reason = view.disabledReason(deed);
    if (!actions.isEmpty()) {
      CHECK(actions[d]->isEnabled() == reason.isEmpty());
      CHECK(actions[d]->toolTip() == (reason.isEmpty() ? actions[d]->text().remove('&') : reason));
    }
    const QString before = state_of(view, read);
    const QImage image = view.viewport()->grab().toImage();
    view.perform(deed);
    const bool same = state_of(view, read) == before && view.viewport()->grab().toImage() == image;
    CHECK(same == !reason.isEmpty());
    ++(same ? grey : done);
  }
}

}  // namespace

TEST_CASE("plot_window: chart keys act or are disabled with a reason, on every page", "[gui]") {
  int done = 0, grey = 0;
  for (const auto kind : {results::SolKind::Element, results::SolKind::Cage, results::SolKind::Race,
                          results::SolKind::Power}) {
    Shown shown(kind);
    shown.window.resize(900, 620);
    QStringList read;
    QObject::connect(&shown.view(), &ChartView::readoutChanged,
                     [&read](const QStringList& parts) { read = parts; });
    QList<QAction*> actions;
    for (QAction* action : shown.view().actions())
      if (!action->isCheckable()) actions << action;  // the others are names of curves
    REQUIRE(actions.size() == desktop::kChartDeeds);
    std::sort(actions.begin(), actions.end(),
              [](QAction* a, QAction* b) { return a->data().toInt() < b->data().toInt(); });
    for (const Domain domain : {Domain::History, Domain::Spectrum, Domain::Spectrogram}) {
      shown.window.setDomain(domain);
      for (int page = 1; page <= shown.window.pageCount(); page += 2) {
        shown.window.showPage(page);
        INFO("kind " << static_cast<int>(kind) << " domain " << static_cast<int>(domain) << " page "
                     << page);
        read.clear();
        check_actions(shown.view(), actions, read, done, grey);
        for (const ChartAction first :
             {ChartAction::ZoomIn, ChartAction::ReadFarOn, ChartAction::CursorB,
              ChartAction::EnlargeValues, ChartAction::FarLeft})
          shown.view().perform(first);
        check_actions(shown.view(), actions, read, done, grey);
      }
    }
  }
  CHECK(done > 500);
  CHECK(grey > 100);
}

TEST_CASE("chart_view: nothing to zoom → keys are disabled", "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(700, 500);
  view.show();
  ChartPage study;
  study.study = std::make_shared<const desktop::StudyChart>();
  ChartPage empty;
  empty.x_unit = "s";
  ChartPage no_values = empty;
  no_values.x = {0.0, 1.0, 2.0};
  no_values.panels = {{"Force", "N", {{"", {NAN, NAN, NAN}, {}}}}};
  for (const ChartPage& page : {study, empty, no_values}) {
    view.showPage(page);
    for (int d = 0; d < desktop::kChartDeeds; ++d) {
      CHECK(view.disabledReason(static_cast<ChartAction>(d)) != "");
      view.perform(static_cast<ChartAction>(d));
    }
    CHECK_FALSE(view.chartScene().zoomed());
  }
}

TEST_CASE("chart_view: an orbit is enlarged, moved and read by keys, its axes stay equal",
          "[gui]") {
  test::use_qt();
  ChartView view;
  view.resize(700, 700);
  view.show();
  ChartPage orbit;
  orbit.equal_axes = true;
  orbit.x_title = "Y";
  orbit.along_title = "Time";
  orbit.along_unit = "s";
  desktop::ChartPanel panel{"Z", "m", {{"path", {}, {}}}};
  for (int i = 0; i < 200; ++i) {
    orbit.along.push_back(0.01 * i);
    panel.curves[0].x.push_back(1e-4 * std::cos(0.1 * i));
    panel.curves[0].y.push_back(1e-4 * std::sin(0.1 * i));
  }
  orbit.panels = {panel};
  view.showPage(orbit);
  QStringList read;
  QObject::connect(&view, &ChartView::readoutChanged,
                   [&](const QStringList& parts) { read = parts; });
  const auto per_pixel = [&] {
    const auto& scene = view.chartScene();
    return std::pair(scene.abscissaAt(101.0) - scene.abscissaAt(100.0),
                     scene.valueAt(0, 100.0) - scene.valueAt(0, 101.0));
  };
  const auto [wide, high] = per_pixel();
  view.perform(ChartAction::ZoomIn);
  CHECK(per_pixel().first == Approx(0.5 * wide));
  CHECK(per_pixel().second == Approx(0.5 * high));
  const QRectF area = view.chartScene().plotAreas().front();
  const double bottom = view.chartScene().valueAt(0, area.bottom());
  view.perform(ChartAction::MoveUp);
  CHECK(view.chartScene().valueAt(0, area.bottom()) ==
        Approx(bottom + 0.1 * 0.5 * high * area.height()));
  view.zoomAll();
  // One stored place after the other, in the order of time, also where paths cross.
  view.perform(ChartAction::ReadOn);
  REQUIRE(read.size() == 1);
  view.perform(ChartAction::CursorA);
  const std::size_t at = desktop::nearest_index(orbit.along, view.cursorAbscissa(0));
  for (std::size_t i = at + 1; i < std::min<std::size_t>(at + 80, 200); ++i) {
    view.perform(ChartAction::ReadOn);
    CHECK(read.join("").startsWith(
        QString::fromStdString(desktop::pretty_quantity(orbit.along[i], "s", 5))));
  }
  // Enlarged, the picture follows what is read.
  for (int i = 0; i < 4; ++i) view.perform(ChartAction::ZoomIn);
  for (int i = 0; i < 30; ++i) {
    view.perform(ChartAction::ReadBack);
    REQUIRE(read.size() == 1);
    view.perform(ChartAction::CursorB);
    const std::size_t now = desktop::nearest_index(orbit.along, view.cursorAbscissa(1));
    CHECK(view.chartScene().planePosition(panel.curves[0].x[now], panel.curves[0].y[now]));
  }
  CHECK(view.disabledReason(ChartAction::ZoomToCursors) != "");
  // To the closest look and no further.
  for (int i = 0; i < 40 && view.disabledReason(ChartAction::ZoomIn).isEmpty(); ++i)
    view.perform(ChartAction::ZoomIn);
  CHECK(per_pixel().first == Approx(1e-4 * wide).epsilon(0.01));
  CHECK(view.disabledReason(ChartAction::ZoomIn) != "");
}
