#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/session.hpp"
#include "adrinput/study_panel.hpp"
#include "adrinput/study_window.hpp"
#include "deck/templates.hpp"
#include "studies/study.hpp"
#include "support/qt_app.hpp"
#include "support/reachable.hpp"

#include <QDockWidget>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <fstream>

/// Each Alt letter selects one element, in every state of a window.
using namespace adore;
using namespace adore::adrinput;

namespace {

std::string one(const QStringList& texts) { return texts.join("; ").toStdString(); }

}  // namespace

TEST_CASE("adrinput: a letter with Alt chooses one menu, button or field on every page",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("DATA.txt").toStdString();
  std::ofstream(path) << deck::template_text("ball");
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(path));
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) dock->show();
  for (const std::string& record : window.document().pages()) {
    INFO("record " << record);
    window.showRecord(record);
    CHECK(one(test::contested_letters_of_pages(window)) == "");
  }
  window.showRecord("1");
  int dialogs = 0;
  CHECK(one(test::contested_letters_of_dialogs(window, dialogs)) == "");
  CHECK(dialogs >= 3);
}

TEST_CASE("adrinput: notices above the form use free access keys only", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("DATA.txt").toStdString();
  std::ofstream(path) << deck::template_text("ball");
  {
    DeckWindow cut_off;
    REQUIRE(cut_off.openFile(path));
    cut_off.document().edit(cell("appLoadZ"), "777");
    const QDir unsaved(folder.filePath("unsaved"));
    unsaved.mkpath(".");
    std::ofstream(unsaved.filePath("1-1.unsaved").toStdString(), std::ios::binary)
        << cut_off.document().snapshot("1");
  }
  DeckWindow window;
  Session session(window, folder.filePath("unsaved"));
  window.show();
  session.begin(true);
  REQUIRE(window.openFile(path));
  window.document().edit(cell("kUnit"), "2");                // converts?
  window.goTo({"5G.1D.1", 1, 3, 0});                         // is not there: set an option?
  std::ofstream(path, std::ios::app) << "of another one\n";  // reload?
  const auto shown = [&] {
    int count = 0;
    for (const NoticeBar* bar : window.findChildren<NoticeBar*>())
      count += bar->isVisible() ? 1 : 0;
    return count;
  };
  CHECK(QTest::qWaitFor([&] { return shown() >= 4; }, 10000));
  CHECK(one(test::contested_letters_of_pages(window)) == "");
  window.document().keep_numbers();
}

TEST_CASE("study window: access keys are unique", "[gui][adrinput][studies]") {
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
    // Also with the button that only some plans show.
    for (auto* button : window.panel().findChildren<QPushButton*>()) button->show();
    window.notice().ask("?", {{"restore", QObject::tr("Res&tore"), nullptr},
                              {"discard", QObject::tr("&Discard"), nullptr}});
    CHECK(one(test::contested_letters_of_pages(window)) == "");
  }
  CHECK(one(test::clashing_letters(window)) == "");
}

TEST_CASE("adrinput: Alt+letter without an action is not typed into a field", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  std::ofstream(folder.filePath("DATA.txt").toStdString()) << deck::template_text("ball");
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(folder.filePath("DATA.txt").toStdString()));
  window.showRecord("3.1");
  CHECK(one(test::letters_typed_by_alt(window)) == "");
  StudyWindow studies;
  studies.show();
  studies.newStudy(folder.filePath("sweep.json").toStdString(), "sweep",
                   folder.filePath("DATA.txt").toStdString());
  CHECK(one(test::letters_typed_by_alt(studies)) == "");
}
