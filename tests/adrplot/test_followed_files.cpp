#include "adrplot/plot_document.hpp"
#include "adrplot/plot_pages.hpp"
#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/page_export.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"
#include "support/synthetic_results.hpp"

#include <QMessageBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <catch2/catch.hpp>

/// Files that change while AdrPlot shows them, and what a table says of whom it is.
using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

TEST_CASE("plot_window: followed file temporarily invalid → message in the status bar", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  test::SyntheticRun made;
  made.steps = 60;
  const auto sol = test::sol_text(test::synthetic_sol(SolKind::Power, made));
  const std::filesystem::path path = folder.filePath("SOL7").toStdString();
  test::write_text(path, sol);
  PlotWindow window;
  REQUIRE(window.openFile(path));
  window.follow(true);
  const auto foot = [&] { return window.statusBar()->currentMessage(); };
  test::write_text(path, "noise, for a moment");
  CHECK(QTest::qWaitFor([&] { return foot().contains("cannot be read at the moment"); }, 10'000));
  CHECK(window.findChild<QMessageBox*>("message") == nullptr);
  CHECK(window.pageCount() > 0);  // the earlier picture is still shown
  test::write_text(path, sol);
  CHECK(QTest::qWaitFor([&] { return foot().isEmpty(); }, 10'000));
  window.follow(false);
}

TEST_CASE("plot_window: names of files are those of the run that has replaced them", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const auto text = [](int body) {
    test::SyntheticRun made;
    made.steps = 60;
    auto file = test::synthetic_sol(SolKind::Element, made);
    file.header.index = body;  // one figure for another: a file of the same size
    return test::sol_text(file);
  };
  const std::filesystem::path first = folder.filePath("SOL1").toStdString(),
                              second = folder.filePath("SOL2").toStdString();
  const auto write = [&](int one, int two) {
    test::write_text(first, text(one));
    test::write_text(second, text(two));
  };
  write(1, 5);
  PlotWindow window;
  REQUIRE(window.openFile(first));
  REQUIRE(window.openFile(second));
  const auto named = [&](int one, int two) {
    const auto* tree = window.findChild<QTreeWidget*>("pages");
    return tree->topLevelItem(0)->text(0).endsWith(QString("rolling element %1").arg(one)) &&
           tree->topLevelItem(1)->text(0).endsWith(QString("rolling element %1").arg(two));
  };
  REQUIRE(named(1, 5));
  QTest::qWait(20);  // a separate time stamp
  write(2, 8);
  window.reload();
  CHECK(named(2, 8));
  window.follow(true);
  QTest::qWait(20);
  write(3, 6);
  CHECK(QTest::qWaitFor([&] { return named(3, 6); }, 10'000));
  window.follow(false);
}

TEST_CASE("adrplot: every column of a table says of what body and page it is", "[unit][adrplot]") {
  test::SyntheticRun made;
  made.steps = 5;
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power}) {
    const results::SolFile file = test::synthetic_sol(kind, made);
    const std::string body = subject(kind, file.header);
    const PlotDocument document = make_document(file);
    for (int number = 1; number <= static_cast<int>(document.pages.size()); ++number) {
      const desktop::ChartPage page = document.build(number, {});
      if (page.panels.empty()) continue;
      const std::string csv = desktop::page_csv(page), heads = csv.substr(0, csv.find('\n'));
      INFO(heads);
      std::size_t columns = page.equal_axes ? 0 : 1, named = 0;  // the abscissa is of no body
      for (const auto& panel : page.panels) columns += panel.curves.size();
      for (std::size_t at = 0; (at = heads.find(body + ": ", at)) != std::string::npos; ++at)
        ++named;
      CHECK(named + (page.equal_axes ? 0 : 1) >= columns);
      CHECK(heads.find(page.title) != std::string::npos);
    }
  }
}
