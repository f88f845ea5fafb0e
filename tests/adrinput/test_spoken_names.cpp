#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/study_panel.hpp"
#include "adrinput/study_window.hpp"
#include "deck/templates.hpp"
#include "studies/study.hpp"
#include "support/qt_app.hpp"
#include "support/qt_warnings.hpp"
#include "support/spoken.hpp"

#include <QDockWidget>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <fstream>

/// Every element with keyboard focus has an accessible name.
using namespace adore;
using namespace adore::adrinput;

namespace {

std::string all(const QStringList& texts) { return texts.join("; ").toStdString(); }

void solve(DeckWindow& window) {
  window.runQuasiStatic();
  REQUIRE(QTest::qWaitFor([&] { return !window.staticsPanel().busy(); }, 60000));
}

}  // namespace

TEST_CASE("adrinput: every focusable widget has an accessible name", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  DeckWindow window;
  window.show();
  for (const deck::TemplateInfo& info : deck::templates()) {
    const std::string name(info.name);
    INFO(name);
    const std::filesystem::path path = folder.filePath("DATA.txt").toStdString();
    std::ofstream(path) << deck::template_text(name);
    REQUIRE(window.openFile(path));
    solve(window);
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) dock->show();
    for (const std::string& record : window.document().pages()) {
      INFO("record " << record);
      window.showRecord(record);
      CHECK(all(test::unspoken(window)) == "");
    }
    CHECK(all(test::unspoken_on_pages(window)) == "");
  }
  int dialogs = 0;
  CHECK(all(test::unspoken_in_dialogs(window, dialogs)) == "");
  CHECK(dialogs >= 3);
}

TEST_CASE("study window: every focusable widget has an accessible name",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const QTemporaryDir folder;
  std::ofstream(folder.filePath("DATA.txt").toStdString()) << deck::template_text("ball");
  StudyWindow window;
  window.show();
  for (int kind = 0; kind < studies::kKinds; ++kind) {
    const std::string name(studies::kind_name(static_cast<studies::Kind>(kind)));
    INFO(name);
    window.newStudy(folder.filePath(QString::fromStdString(name + ".json")).toStdString(),
                    QString::fromStdString(name), folder.filePath("DATA.txt").toStdString());
    for (auto* button : window.panel().findChildren<QPushButton*>()) button->show();
    CHECK(all(test::unspoken_on_pages(window)) == "");
  }
}

TEST_CASE("adrinput: no Qt warnings while docks and switches are toggled at any size",
          "[gui][adrinput]") {
  test::use_qt();
  const test::QtWarnings warnings;
  DeckWindow window;
  window.show();
  solve(window);
  CHECK(test::warned_by_switches(window) == "");
  StudyWindow studies;
  studies.show();
  CHECK(test::warned_by_switches(studies) == "");
}
