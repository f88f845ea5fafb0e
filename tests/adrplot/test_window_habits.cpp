#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMouseEvent>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

QList<QByteArray> lines_of(const QString& path) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  return file.readAll().trimmed().split('\n');
}

}  // namespace

TEST_CASE("plot_window: export of all pages → pages of all SOL files of the run, open or not",
          "[gui][adrplot]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path run = folder.path().toStdString() + "/run";
  std::filesystem::create_directory(run);
  test::SyntheticRun made;
  made.steps = 20;
  test::write_text(run / "SOL2", test::sol_text(test::synthetic_sol(SolKind::Element, made)));
  test::write_text(run / "SOL4", test::sol_text(test::synthetic_sol(SolKind::Cage, made)));
  PlotWindow window;
  REQUIRE(window.openFile(run / "SOL4"));
  REQUIRE(window.exportTo(folder.filePath("all.csv"), true));
  CHECK(window.statusBar()->currentMessage().contains("of 2 files"));
  QStringList expected;
  for (const char* file : {"SOL2", "SOL4"})
    for (std::size_t page = 1; page <= open_document(run / file).pages.size(); ++page)
      expected += QString("all-%1-%2.csv").arg(file).arg(page, 2, 10, QChar('0'));
  CHECK(expected.size() > 10);
  CHECK(QDir(folder.path()).entryList(QDir::Files, QDir::Name) == expected);
  CHECK(window.fileCount() == 1);
}

TEST_CASE("plot_window: export of all or visible values → reported in the status bar",
          "[gui][adrplot]") {
  test::use_qt();
  QTemporaryDir folder;
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Element));
  window.showPage(6);
  auto& scene = window.view().chartScene();
  const std::size_t all = scene.page().x.size(), curves = scene.page().panels[0].curves.size();
  REQUIRE(curves == 2);
  scene.setView(1.0, 2.0);
  scene.showCurve(0, 1, false);
  const QString whole = folder.filePath("whole.csv"), part = folder.filePath("part.csv");
  REQUIRE(window.exportTo(whole, false));
  CHECK(window.statusBar()->currentMessage().contains(
      QString("(%1 values each), including values outside the visible range").arg(all)));
  REQUIRE(window.exportTo(part, false, true));
  const auto rows = lines_of(whole), seen = lines_of(part);
  CHECK(rows.size() == static_cast<qsizetype>(all) + 1);
  CHECK(seen.size() < rows.size());
  // A column less: its separator, and the comma of its name.
  CHECK(rows.front().count(',') == seen.front().count(',') + 2);
  qsizetype inside = 0;
  for (const double x : scene.page().x) inside += x >= 1.0 && x <= 2.0 ? 1 : 0;
  CHECK(seen.size() == inside + 1);
  for (qsizetype i = 1; i < seen.size(); ++i) {
    const double x = seen[i].split(',').front().toDouble();
    CHECK((x >= 1.0 && x <= 2.0));
  }
  CHECK(window.statusBar()->currentMessage().contains(QString("%1 values each").arg(inside)));
}

TEST_CASE(
    "plot_window: Home in the tree shows all of its page, and the pointer's line goes with its "
    "page",
    "[gui][adrplot]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Element));
  window.show();
  auto* tree = window.findChild<QTreeWidget*>("pages");
  REQUIRE(QTest::qWaitForWindowActive(&window));
  window.showPage(2);
  tree->setFocus();
  desktop::ChartScene& scene = window.view().chartScene();
  scene.setView(scene.viewLow(), 0.5 * (scene.viewLow() + scene.viewHigh()));
  REQUIRE(scene.zoomed());
  QTest::keyClick(tree, Qt::Key_Home);
  CHECK_FALSE(scene.zoomed());
  CHECK(window.windowTitle().contains("/SOL1 — page 2 of"));
  window.showPage(1);
  CHECK(window.windowTitle().contains("/SOL1 — page 1 of"));  // of the run's folder
  const auto picture = [&] { return window.view().grab().toImage(); };
  auto& view = window.view();
  window.showPage(2);
  const QImage before = picture();
  window.showPage(1);
  const QPoint at = view.mapFromScene(view.chartScene().plotAreas()[0].center());
  QMouseEvent move(QEvent::MouseMove, at, view.viewport()->mapToGlobal(at), Qt::NoButton,
                   Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(view.viewport(), &move);
  const QImage with_line = picture();
  window.showPage(2);
  CHECK(picture() == before);
  window.showPage(1);
  CHECK(picture() != with_line);
}

TEST_CASE("plot_window: run without rotation → drawn over time, with a note", "[gui][adrplot]") {
  test::use_qt();
  PlotWindow window;
  auto file = test::synthetic_sol(SolKind::Element);
  window.addFile(file);
  auto* abscissa = window.findChild<QComboBox*>("abscissa");
  CHECK(abscissa->currentText() == "over revolutions");
  for (auto& step : file.steps) step.revolutions = 0.0;
  window.addFile(file);
  CHECK(window.view().chartScene().page().x_title == "Time");
  CHECK(abscissa->currentText() == "over time (no rotation)");
}

TEST_CASE("plot_window: unavailable actions are disabled with a reason", "[gui][adrplot]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Race));
  const auto action = [&](const QString& text) -> QAction* {
    for (QAction* one : window.findChildren<QAction*>())
      if (QString(one->text()).remove('&') == text) return one;
    return nullptr;
  };
  auto* values = action("Logarithmic Values");
  auto* amplitude = action("Spectrum: Amplitude");
  REQUIRE(values);
  REQUIRE(amplitude);
  window.showPage(2);
  CHECK(values->isEnabled());
  CHECK_FALSE(amplitude->isEnabled());
  CHECK(amplitude->toolTip().contains("no spectra"));
  window.showPage(5);  // an orbit
  REQUIRE(window.view().chartScene().page().equal_axes);
  CHECK_FALSE(values->isEnabled());
  CHECK(values->toolTip().contains("equal"));
  values->trigger();  // as its key does
  window.showPage(2);
  for (const auto& panel : window.view().chartScene().page().panels) CHECK_FALSE(panel.log);
  window.setDomain(Domain::Spectrum);
  CHECK(amplitude->isEnabled());
  CHECK(values->isEnabled());
  window.setLogAxes(std::nullopt, true);
  for (const bool decibel : {true, false}) {  // dB are logarithms already
    for (QAction* one : window.findChildren<QAction*>())
      if (one->text() == (decibel ? "in dB" : "in units")) one->trigger();
    INFO("in dB " << decibel);
    CHECK(values->isEnabled() == !decibel);
    CHECK(values->toolTip().contains("already") == decibel);
    for (const auto& panel : window.view().chartScene().page().panels) {
      CHECK(panel.unit.starts_with("dB") == decibel);
      CHECK(panel.log == !decibel);
    }
  }
  window.setLogAxes(std::nullopt, std::nullopt);
  auto* abscissa = window.findChild<QComboBox*>("abscissa");
  CHECK_FALSE(abscissa->isEnabled());
  CHECK(abscissa->toolTip().contains("frequency"));
}

TEST_CASE("plot_window: the name proposed for a picture has the picture's suffix",
          "[gui][adrplot]") {
  test::use_qt();
  QTemporaryDir folder;
  const QString sweep = folder.filePath("SWEEP.csv");
  QFile file(sweep);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write("fxInner [N],exit,largest_contact_load_N,message\n1,0,2,\"\"\n2,0,3,\"\"\n");
  file.close();
  PlotWindow window;
  REQUIRE(window.openFile(sweep.toStdString()));
  for (const bool all : {false, true}) {
    if (all)
      window.exportAll();
    else
      window.exportPage();
    auto* dialog = window.findChild<QFileDialog*>("export");
    REQUIRE(dialog);
    REQUIRE(dialog->selectedFiles().size() == 1);
    const QFileInfo proposed(dialog->selectedFiles().front());
    CHECK(proposed.suffix() == "pdf");
    CHECK(proposed.baseName().startsWith("SWEEP-page"));
    delete dialog;
  }
}

TEST_CASE("plot_window: long messages → small window does not grow", "[gui][adrplot]") {
  test::use_qt();
  PlotWindow window;
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Power})
    window.addFile(test::synthetic_sol(kind));
  window.show();
  const QSize small(684, 402);  // the room of a screen of 700x450
  window.resize(small);
  auto* tree = window.findChild<QTreeWidget*>("pages");
  auto& view = window.view();
  int told = 0;
  for (int file = 0; file < window.fileCount(); ++file)
    for (int page = 0; page < tree->topLevelItem(file)->childCount(); ++page) {
      tree->setCurrentItem(tree->topLevelItem(file)->child(page));
      const auto& areas = view.chartScene().plotAreas();
      if (!areas.empty() && !view.chartScene().isPlane()) {
        const QPoint middle = view.mapFromScene(areas[0].center());
        QTest::mouseClick(view.viewport(), Qt::LeftButton, Qt::ControlModifier, middle);
        QTest::mouseClick(view.viewport(), Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier,
                          middle + QPoint(40, 0));
        told += view.cursorReport().isEmpty() ? 0 : 1;
      }
      for (int round = 0; round < 3; ++round) QCoreApplication::processEvents();
      INFO(window.windowTitle().toStdString());
      CHECK(window.width() == small.width());
      CHECK(window.height() == small.height());
      CHECK(view.height() >= view.minimumHeight());
    }
  CHECK(told > 3);
}

TEST_CASE("plot_window: Write Report → report.html and report.pdf of the runs of all open files",
          "[gui][adrplot]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path run = folder.path().toStdString();
  REQUIRE(std::system((test::program("adore").string() + " new ball --out " +
                       folder.filePath("DATA.txt").toStdString() + " >/dev/null && " +
                       test::program("adore").string() + " run " + folder.path().toStdString() +
                       " --quiet --set maxStps=40 >/dev/null")
                          .c_str()) == 0);
  PlotWindow window;
  REQUIRE(window.openFile(run / "SOL1"));
  REQUIRE(window.openFile(run / "SOL7"));
  REQUIRE(window.reportTo(folder.filePath("report")));
  CHECK(window.statusBar()->currentMessage().contains("report.pdf"));
  CHECK(QFileInfo(folder.filePath("report/report.html")).size() > 100'000);
  CHECK(QFileInfo(folder.filePath("report/report.pdf")).size() > 50'000);
}
