#include "apps/desk.hpp"
#include "support/qt_app.hpp"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <string>

/// The programs in real windows, as somebody uses them.
using adore::test::Desk;

namespace {

std::string text_of(const QString& path) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  return file.readAll().toStdString();
}

}  // namespace

TEST_CASE("a real window of AdrInput: a size in millimeters is typed, Ctrl+U empties nothing",
          "[gui][apps][window][slow]") {
  adore::test::use_qt();
  const auto desk = Desk::make("1280x800x24");
  if (!desk) return;
  const QTemporaryDir folder;
  const QString deck = folder.filePath("DATA.txt");
  REQUIRE(QFile::copy(adore::test::short_run() + "/DATA.txt", deck));
  desk->start("adrinput", {deck});
  const QString window = desk->window("AdrInput");
  desk->xdotool({"windowactivate", "--sync", window});
  const QRect place = desk->place(window);
  CHECK(QRect(0, 0, 1280, 800).contains(place));
  desk->keys({"ctrl+f"});
  desk->type("bReDia");
  desk->keys({"Return"});
  desk->type("12.8 mm");
  desk->keys({"Tab", "shift+Tab", "ctrl+u", "ctrl+k"});
  // An Escape before the dialog is there would leave it open, and it would take the keys after it.
  const QString dialog = "Compare";
  REQUIRE(desk->shows(dialog));
  desk->keys({"Escape"});
  REQUIRE(desk->shows(dialog, false));
  desk->keys({"ctrl+s"});
  CHECK(Desk::comes([&] { return text_of(deck).find("0.0128") != std::string::npos; }));
  const std::string saved = text_of(deck);
  CHECK(saved.find("stpInit stpMin stpMax") != std::string::npos);  // its remarks
  desk->keys({"ctrl+q"});
  CHECK(desk->ends());
}

TEST_CASE("real windows of all three programs open within a small screen and end on Ctrl+Q",
          "[gui][apps][window][slow]") {
  adore::test::use_qt();
  struct Program {
    const char *name, *title, *file;
  };
  for (const auto& [screen, factor] :
       {std::pair{QSize(1280, 800), 1}, {QSize(1920, 1080), 2}, {QSize(640, 480), 1}}) {
    const auto desk = Desk::make(QString("%1x%2x24").arg(screen.width()).arg(screen.height()));
    if (!desk) return;
    desk->scaleBy(factor);
    for (const Program& program : {Program{"adrinput", "AdrInput", "DATA.txt"},
                                   {"adrplot", "AdrPlot", "SOL1"},
                                   {"agore", "AGORE", "SOL8"}}) {
      INFO(program.name << " at scale " << factor);
      desk->start(program.name, {adore::test::short_run() + "/" + program.file});
      const QString window = desk->window(program.title);
      desk->xdotool({"windowactivate", "--sync", window});
      QRect place;  // the manager gives it a frame in its own time
      const bool fits = Desk::comes([&] {
        place = desk->place(window);
        return QRect(QPoint(0, 0), screen).contains(place) && place.width() > screen.width() / 3;
      });
      INFO(place.x() << " " << place.y() << " " << place.width() << " " << place.height());
      CHECK(fits);
      desk->keys({"ctrl+q"});
      CHECK(desk->ends());
    }
  }
}

TEST_CASE("real windows start dark and at the page that a command asks for",
          "[gui][apps][window][slow]") {
  adore::test::use_qt();
  const auto desk = Desk::make("1280x800x24");
  if (!desk) return;
  const auto ends = [&desk](const QString& title) {
    desk->xdotool({"windowactivate", "--sync", desk->window(title)});
    desk->keys({"ctrl+q"});
    return desk->ends();
  };
  desk->start("adrplot", {adore::test::short_run() + "/SOL1", "--dark", "--page", "6"});
  CHECK(desk->shows("page 6 of"));
  CHECK(ends("page 6 of"));
  desk->start("adrplot", {adore::test::short_run() + "/SOL1", "--page", "600"});
  CHECK(desk->shows("page 1 of"));
  desk->keys({"Return"});  // the message that there is none
  CHECK(ends("page 1 of"));
  desk->start("agore", {adore::test::short_run() + "/SOL8", "--dark"});
  CHECK(desk->shows("Bearing motion"));
  CHECK(ends("Bearing motion"));
}

TEST_CASE("real windows: project on the command line → its first run that exists",
          "[gui][apps][window][slow]") {
  adore::test::use_qt();
  const auto desk = Desk::make("1280x800x24");
  if (!desk) return;
  const QTemporaryDir folder;
  REQUIRE(QFile::link(adore::test::short_run(), folder.filePath("first")));
  QFile project(folder.filePath("PROJECT.json"));
  REQUIRE(project.open(QIODevice::WriteOnly));
  project.write(
      R"({"format": "adore-project", "version": 1, "decks": [], "runs": ["gone", "first"]})");
  project.close();
  for (const auto& [program, title] : {std::pair{"adrplot", "first/SOL1"}, {"agore", "first/SOL8"}})
    for (const QString& named : {folder.path(), project.fileName()}) {
      INFO(program << " " << named.toStdString());
      desk->start(program, {named});
      CHECK(desk->shows(title));
      if (std::string(program) == "agore") desk->keys({"Return"});  // the missing run
      desk->xdotool({"windowactivate", "--sync", desk->window(title)});
      desk->keys({"ctrl+q"});
      CHECK(desk->ends());
    }
}

TEST_CASE("real windows: files that are dragged from another program open where they are dropped",
          "[gui][apps][window][slow]") {
  adore::test::use_qt();
  struct Try {
    const char *program, *file, *title;
  };
  for (const auto& [program, file, title] : {Try{"adrplot", "SOL3", "SOL3"},
                                             {"agore", "SOL8", "SOL8"},
                                             {"adrinput", "DATA.txt", "DATA.txt"}}) {
    INFO(program);
    const auto desk = Desk::make("1280x800x24");
    if (!desk) return;
    desk->start(program, {});
    const QRect place = desk->place(desk->window("A(drPlot|drInput|GORE)"));
    if (program != std::string("adrinput")) {  // it opens a file dialog automatically
      QTest::qWait(1000);
      desk->keys({"Escape"});
    }
    desk->offer({adore::test::short_run() + "/" + file});
    const QRect icon = desk->place(desk->window("drag-source"));
    desk->drag(icon.center(), {place.left() + 2 * place.width() / 5, place.center().y()});
    if (program == std::string("adrplot")) {  // the range of its steps
      QTest::qWait(1000);
      desk->keys({"Return"});
    }
    CHECK(desk->shows(title));
  }
}
