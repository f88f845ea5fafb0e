#include "adrplot/plot_window.hpp"
#include "desktop/project.hpp"
#include "support/message.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QAction>
#include <QFile>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <catch2/catch.hpp>

/// Projects in AdrPlot: the list of runs above the pages.
using namespace adore;
using desktop::Project;
namespace fs = std::filesystem;

namespace {

/// Two runs, and one that is missing.
struct Folder {
  Folder() {
    Project project = Project::open_or_create(path);
    for (const char* run : {"gone", "first", "second"}) {
      project.add_run(path / run);
      if (std::string(run) == "gone") continue;
      fs::create_directories(path / run);
      for (const auto& [name, kind] :
           {std::pair{"SOL1", results::SolKind::Element}, {"SOL7", results::SolKind::Power}})
        test::write_text(path / run / name, test::sol_text(test::synthetic_sol(kind)));
      test::write_text(path / run / "SOL8", test::sol8_text(test::synthetic_sol8()));
    }
    project.save();
    file = project.file();
  }
  QTemporaryDir temporary;
  fs::path path = fs::path(temporary.path().toStdString()), file;
};

QTreeWidget* runs_of(adrplot::PlotWindow& window) { return window.findChild<QTreeWidget*>("runs"); }
void click(QTreeWidget* list, int line) {
  const QRect at = list->visualItemRect(list->topLevelItem(line));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at.center());
}

}  // namespace

TEST_CASE("plot_window: project → its runs listed, missing ones named, the first one opened",
          "[gui][project]") {
  test::use_qt();
  const Folder folder;
  const bool by_folder = GENERATE(false, true);
  adrplot::PlotWindow window;
  window.show();
  QTreeWidget* runs = runs_of(window);
  CHECK_FALSE(runs->isVisible());
  window.openFiles({QString::fromStdString((by_folder ? folder.path : folder.file).string())});
  CHECK(runs->isVisible());
  REQUIRE(runs->topLevelItemCount() == 3);
  CHECK(runs->topLevelItem(0)->text(0) == "gone (missing)");
  CHECK(runs->topLevelItem(0)->isDisabled());
  CHECK(runs->topLevelItem(1)->text(0) == "first");
  CHECK(runs->currentItem() == runs->topLevelItem(1));
  CHECK(window.fileCount() == 2);
  CHECK(test::take_message(window).isEmpty());  // the list shows it
  CHECK(window.statusBar()->currentMessage().contains("gone"));
}

TEST_CASE("plot_window: run of a project chosen → the page of the same file", "[gui][project]") {
  test::use_qt();
  const Folder folder;
  adrplot::PlotWindow window;
  window.show();
  REQUIRE(window.openFile(folder.file));
  QTreeWidget* runs = runs_of(window);
  auto* tree = window.findChild<QTreeWidget*>("pages");
  tree->setCurrentItem(tree->topLevelItem(0)->child(2));  // SOL1
  CHECK(window.windowTitle().startsWith("first/SOL1 — page 3"));
  click(runs, 2);
  CHECK(window.fileCount() == 4);
  CHECK(window.windowTitle().startsWith("second/SOL1 — page 3"));
  CHECK(runs->currentItem() == runs->topLevelItem(2));
  click(runs, 1);
  CHECK(window.fileCount() == 4);  // it is open
  CHECK(window.windowTitle().startsWith("first/SOL1 — page 3"));
  // The list follows the tree.
  tree->setCurrentItem(tree->topLevelItem(3)->child(0));
  CHECK(runs->currentItem() == runs->topLevelItem(2));
  // Missing runs that exist now, after reloading.
  fs::copy(folder.path / "first", folder.path / "gone");
  window.reload();
  CHECK_FALSE(runs->topLevelItem(0)->isDisabled());
  click(runs, 0);
  CHECK(window.windowTitle().startsWith("gone/"));
}

TEST_CASE("plot_window: damaged or newer project → message, file and window unchanged",
          "[gui][project]") {
  test::use_qt();
  const Folder folder, other;
  adrplot::PlotWindow window;
  window.show();
  REQUIRE(window.openFile(folder.file));
  const int files = window.fileCount();
  for (const char* text :
       {R"({"format": "adore-pro)", R"({"format": "adore-project", "version": 2})"}) {
    test::write_text(other.file, text);
    CHECK_FALSE(window.openFile(other.file));
    CHECK(test::take_message(window).contains("The file is not changed."));
    QFile read(QString::fromStdString(other.file.string()));
    REQUIRE(read.open(QIODevice::ReadOnly));
    CHECK(read.readAll() == text);
    CHECK(window.fileCount() == files);
    CHECK(runs_of(window)->topLevelItemCount() == 3);
  }
}

TEST_CASE("plot_window: folder of a run that is a project, too → the run", "[gui][project]") {
  test::use_qt();
  const Folder folder;
  fs::copy_file(folder.file, folder.path / "first" / desktop::kProjectFile);
  adrplot::PlotWindow window;
  window.show();
  window.openFolder(QString::fromStdString((folder.path / "first").string()));
  CHECK(window.fileCount() == 2);
  CHECK_FALSE(runs_of(window)->isVisible());
}

TEST_CASE("plot_window: project without runs → a message", "[gui][project]") {
  test::use_qt();
  const QTemporaryDir base;
  const Project project = Project::open_or_create(base.path().toStdString());
  project.save();
  adrplot::PlotWindow window;
  window.show();
  CHECK(window.openFile(project.file()));
  CHECK(test::take_message(window).contains("lists no runs"));
  CHECK_FALSE(runs_of(window)->isVisible());
}
