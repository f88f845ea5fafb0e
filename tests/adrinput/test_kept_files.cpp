#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/record_page.hpp"
#include "deck/templates.hpp"
#include "support/elsewhere.hpp"
#include "support/qt_app.hpp"

#include <QFileDialog>
#include <QLineEdit>
#include <QStatusBar>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <fstream>

/// Data that saving keeps: drafts, remarks, copies.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

TEST_CASE("drafts: deck with an error saved and reopened → unchanged", "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  const QString draft = folder.filePath("half.draft");
  {
    DeckWindow window;
    window.show();
    replace_text(line_of(window, "bReDia"), "unknown");
    replace_text(line_of(window, "pitchDia"), "61 mm");
    window.document().save_draft(draft.toStdString());
    CHECK_FALSE(window.document().modified());
    CHECK(window.windowTitle().contains("half.draft"));
    CHECK_THROWS_AS(window.document().save(folder.filePath("DATA.txt").toStdString()), InputError);
  }
  CHECK_THROWS_AS(deck::read_deck(draft.toStdString()), InputError);  // no run takes it
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(draft.toStdString()));
  CHECK(window.document().deck().real("pitchDia") == 0.061);
  CHECK(line_of(window, "bReDia")->text() == "unknown");
  CHECK_FALSE(window.document().modified());
  replace_text(line_of(window, "bReDia"), "12.7 mm");
  window.document().save(folder.filePath("DATA.txt").toStdString());
  CHECK_FALSE(fs::exists(draft.toStdString()));  // it became the deck
  CHECK(deck::read_deck(folder.filePath("DATA.txt").toStdString()).deck.real("pitchDia") == 0.061);
  // The refused save offers to park it.
  replace_text(line_of(window, "bReDia"), "unknown");
  window.save();
  auto* box = window.findChild<QMessageBox*>("message");
  REQUIRE(box != nullptr);
  REQUIRE(box->findChild<QPushButton*>("park-draft") != nullptr);
  box->close();
  // A deleted file is reported.
  window.document().save_draft(draft.toStdString());
  REQUIRE(fs::exists(draft.toStdString()));
  replace_text(line_of(window, "bReDia"), "12.8 mm");
  window.save();
  CHECK_FALSE(fs::exists(draft.toStdString()));
  CHECK(window.statusBar()->currentMessage().contains("; the draft half.draft was deleted"));
  replace_text(line_of(window, "bReDia"), "12.7 mm");
  window.save();
  CHECK_FALSE(window.statusBar()->currentMessage().contains("draft"));
}

TEST_CASE("comments: kept when a save changes options", "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::ofstream(path) << deck::template_text("ball");
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(path));
  window.document().edit(cell("kReGeoImp"), "2");  // four records come
  window.document().edit(cell("reDiaVar7"), "1e-6");
  window.document().save(path);
  const std::string text = bytes_of(path);
  CHECK(text.find("stpInit stpMin stpMax fTime tol qFac") != std::string::npos);
  CHECK(text.find("D, dm, contact angle") != std::string::npos);
  CHECK_FALSE(fs::exists(path.string() + ".bak"));
  CHECK(deck::read_deck(path).deck == window.document().deck());
}

TEST_CASE("comments: unit change → comments name the new units, or a note lists those that do not",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::string text(deck::template_text("ball"));
  const std::string own = "bore, OD, shaft bore, housing OD, race widths [m]";
  REQUIRE(text.find(own) != std::string::npos);
  text.replace(text.find(own), own.size(), "bore 40 mm, from our drawing");
  std::ofstream(path) << text;
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(path));
  const auto notes = [&] {
    std::vector<std::string> records;
    for (const Problem& problem : window.document().problems())
      if (problem.issue.message.find("comment after the values") != std::string::npos)
        records.push_back(problem.page);
    return records;
  };
  window.document().edit(cell("kUnit"), "2");
  window.document().convert_values();
  window.save();
  CHECK(bytes_of(path).find("displacements [lbf, in]") != std::string::npos);
  CHECK(bytes_of(path).find("bore 40 mm, from our drawing") != std::string::npos);
  CHECK(notes() == std::vector<std::string>{"4"});
  window.document().edit(cell("kUnit"), "1");
  window.document().convert_values();
  window.save();
  CHECK(bytes_of(path).find("displacements [N, m]") != std::string::npos);
  CHECK(notes().empty());
}

TEST_CASE("adrinput: deck with an error → rejected before the file dialog; kept copy is reported",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  {
    DeckWindow window;
    window.show();
    replace_text(line_of(window, "bReDia"), "unknown");
    for (const bool as : {false, true}) {
      if (as)
        window.saveAs();
      else
        window.save();
      CHECK(window.findChild<QFileDialog*>("save") == nullptr);
      CHECK(take_message(window).contains("bReDia"));
    }
  }
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::string text(deck::template_text("ball"));
  text.replace(text.find("0.0127"), 6, "x.0127");
  std::ofstream(path) << text;
  DeckWindow window;
  window.show();
  REQUIRE(window.openFile(path));
  replace_text(line_of(window, "bReDia"), "12.7 mm");
  window.save();
  CHECK(take_message(window).isEmpty());
  CHECK(window.statusBar()->currentMessage().contains("DATA.txt.bak"));
  CHECK(bytes_of(path.string() + ".bak") == text);
  replace_text(line_of(window, "bReDia"), "12.8 mm");
  window.save();
  CHECK_FALSE(window.statusBar()->currentMessage().contains(".bak"));
}

TEST_CASE("a deck that was opened by a relative name is proposed where it is, also as a draft",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  const test::Elsewhere elsewhere(folder.path().toStdString());
  fs::create_directory("deck");
  std::ofstream("deck/DATA.txt") << deck::template_text("ball");
  for (const char* name : {"deck/DATA.txt", "deck"}) {
    DeckWindow window;
    window.show();
    REQUIRE(window.openFile(name));
    window.saveAs();
    auto* save = window.findChild<QFileDialog*>("save");
    REQUIRE(save != nullptr);
    CHECK(save->selectedFiles() == QStringList{folder.filePath("deck/DATA.txt")});
    save->close();
    window.saveDraft();
    auto* park = window.findChild<QFileDialog*>("save-draft");
    REQUIRE(park != nullptr);
    CHECK(park->selectedFiles() == QStringList{folder.filePath("deck/DATA.draft")});
    park->close();
  }
}
