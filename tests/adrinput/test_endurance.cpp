#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "base/errors.hpp"
#include "deck/templates.hpp"
#include "support/full_disk.hpp"
#include "support/qt_app.hpp"

#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

TEST_CASE("adrinput: unit system switched a hundred times → values unchanged",
          "[unit][adrinput][daily]") {
  for (const char* type : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    INFO(type);
    Document document;
    document.start_new(type);
    const deck::Deck before = document.deck();
    for (int round = 0; round < 100; ++round)
      for (const char* unit : {"2", "1"}) {
        document.edit(cell("kUnit"), unit);
        document.end_undo_step();
        document.convert_values();
      }
    CHECK(document.deck() == before);
  }
}

TEST_CASE("adrinput: full disk → error message, old deck and typed values kept",
          "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  DeckWindow window;
  window.show();
  window.newDeck("ball");
  window.document().save(path);
  const std::string old = bytes_of(path);
  REQUIRE(window.openFile(path));
  window.document().edit(cell("brgBore"), "0.041");
  window.document().end_undo_step();
  {
    const test::FullDisk full(200);
    window.save();
  }
  CHECK(take_message(window).contains("not saved"));
  CHECK(bytes_of(path) == old);
  CHECK(window.document().modified());
  CHECK(window.document().deck().real("brgBore") == 0.041);
  window.save();
  CHECK(take_message(window).toStdString() == "");
  CHECK(bytes_of(path) != old);
  // Undo continues across the save.
  window.undo();
  CHECK(window.document().deck().real("brgBore") != 0.041);
  CHECK(window.document().modified());
  int left = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder.path().toStdString()))
    ++left;
  CHECK(left <= 2);  // the deck, and what is kept for the case of a crash
}

TEST_CASE("file names: longest possible names are saved and opened", "[gui][adrinput][daily]") {
  test::use_qt();
  const QTemporaryDir folder;
  fs::path path = folder.path().toStdString();
  while (path.string().size() < 3000) path /= std::string(200, 'x');
  fs::create_directories(path);
  path /= std::string(180, 'd') + ".txt";
  DeckWindow window;
  window.show();
  window.newDeck("tapered");
  window.document().save(path);
  CHECK(window.openFile(path));
  CHECK(window.width() <= 1400);  // the name does not widen it
  CHECK(window.minimumSizeHint().width() <= 700);
}
