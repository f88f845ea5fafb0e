#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/file_names.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/session.hpp"
#include "adrinput/study_document.hpp"
#include "deck/templates.hpp"
#include "desktop/chrome.hpp"
#include "support/qt_app.hpp"

#include <QCheckBox>
#include <QDir>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

/// A name that is kept means the same file when the working folder is another one.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

/// Folders ra with a ball bearing and rb with another deck of the same name; current folder: ra.
struct TwoProjects {
  QTemporaryDir folder;
  fs::path before = fs::current_path();
  fs::path root = fs::canonical(folder.path().toStdString());
  TwoProjects() {
    for (const auto& [name, type] : {std::pair{"ra", "ball"}, {"rb", "cylindrical"}}) {
      fs::create_directory(root / name);
      std::ofstream(root / name / "DATA.txt") << deck::template_text(type);
    }
    fs::current_path(root / "ra");
  }
  ~TwoProjects() { fs::current_path(before); }
  TwoProjects(const TwoProjects&) = delete;
  TwoProjects& operator=(const TwoProjects&) = delete;
  [[nodiscard]] QString unsaved() const { return folder.filePath("unsaved"); }
  [[nodiscard]] fs::path kept() const {
    const QStringList names = QDir(unsaved()).entryList({"*.unsaved"}, QDir::Files);
    REQUIRE(names.size() == 1);
    return (unsaved() + "/" + names.front()).toStdString();
  }
};

struct Started {
  DeckWindow window;
  Session session;
  Started(const TwoProjects& projects, const fs::path& deck) : session(window, projects.unsaved()) {
    window.show();
    window.openFile(deck);
    session.begin(true);
  }
  NoticeBar& notice(const char* name) {
    auto* bar = window.findChild<NoticeBar*>(name);
    REQUIRE(bar != nullptr);
    return *bar;
  }
};

/// As when the program is cut off after a change.
void cut_off(const TwoProjects& projects, const fs::path& deck) {
  Started one(projects, deck);
  one.window.document().edit(cell("rpm2"), "7777");
}

}  // namespace

TEST_CASE("session: deck restored after a crash → same file in any working folder",
          "[gui][adrinput][recovery]") {
  test::use_qt();
  const TwoProjects projects;
  const fs::path a = projects.root / "ra/DATA.txt", b = projects.root / "rb/DATA.txt";
  const std::string other = bytes_of(b);
  cut_off(projects, "DATA.txt");
  fs::current_path(projects.root / "rb");
  Started next(projects, "DATA.txt");
  Document& document = next.window.document();
  REQUIRE(next.notice("session-notice").isVisible());
  CHECK(next.notice("session-notice").text().contains("ra/DATA.txt"));
  CHECK(document.path() == b);

  SECTION("in place of a deck without changes") {
    press(next.window, "restore");
    CHECK(next.window.windowTitle().startsWith("ra/DATA.txt"));
  }
  SECTION("in place of a deck with changes, which is asked about by its name") {
    document.edit(cell("rpm2"), "5555");
    press(next.window, "restore");
    auto* box = next.window.findChild<QMessageBox*>("unsaved");
    REQUIRE(box != nullptr);
    CHECK(box->text().contains("rb/DATA.txt"));
    QTest::mouseClick(box->button(QMessageBox::Discard), Qt::LeftButton);
  }
  CHECK(document.path() == a);
  CHECK(document.modified());
  CHECK_FALSE(next.notice("file-notice").isVisible());  // nobody changed either
  next.window.save();
  CHECK(next.window.findChild<QMessageBox*>("changed") == nullptr);
  CHECK(deck::read_deck(a).deck.real("rpm2") == 7777);
  CHECK(bytes_of(b) == other);
}

TEST_CASE("session: deck stored with an incomplete name → restored without a name",
          "[gui][adrinput][recovery]") {
  test::use_qt();
  const TwoProjects projects;
  cut_off(projects, "DATA.txt");
  // As it was stored: the name as it had been typed.
  const fs::path file = projects.kept();
  std::string bytes = bytes_of(file);
  const std::string whole = (projects.root / "ra/DATA.txt").string();
  const std::size_t at = bytes.find(whole, bytes.find("dpath"));
  REQUIRE(at != std::string::npos);
  const std::size_t head = bytes.find("dpath") + 5;
  bytes.replace(head, at - head + whole.size(), "hDATA.txt");
  std::ofstream(file, std::ios::binary) << bytes;
  fs::current_path(projects.root / "rb");
  const std::string other = bytes_of("DATA.txt");
  Started next(projects, "DATA.txt");
  CHECK(next.notice("session-notice").text().contains("unnamed deck"));
  press(next.window, "restore");
  CHECK(next.window.document().deck().real("rpm2") == 7777);
  CHECK(next.window.document().path().empty());
  CHECK(next.window.windowTitle().startsWith("new deck"));
  next.window.save();  // asks for a name
  CHECK(next.window.findChild<QWidget*>("save") != nullptr);
  CHECK(bytes_of("DATA.txt") == other);
}

TEST_CASE("session: working folder changed → stored names refer to the same files",
          "[gui][adrinput][recovery]") {
  test::use_qt();
  const TwoProjects projects;
  const fs::path ra = projects.root / "ra";
  const std::string other = bytes_of(projects.root / "rb/DATA.txt");
  const auto elsewhere = [&] { fs::current_path(projects.root / "rb"); };
  const auto back = [&] { fs::current_path(ra); };
  const auto setting = [](const char* name) {
    return QSettings("Adore", "adrinput").value(name).toString().toStdString();
  };
  QStringList given;
  {
    Started one(projects, "../ra/DATA.txt");
    elsewhere();
    one.window.runPanel().launch = [&](const QString&, const QStringList& list) { given += list; };
    for (const char* box : {"plots-at-end", "animation-at-end"})
      one.window.findChild<QCheckBox*>(box)->setChecked(true);
    one.window.document().change({{"rpm2", "7000"}, {"maxStps", "3"}, {"kAGraf", "1"}});
    QSignalSpy spy(&one.window.runPanel(), &RunPanel::finished);
    const auto wait = [&] {
      REQUIRE(QTest::qWaitFor([&] { return !one.window.runPanel().busy(); }, 120000));
    };
    one.window.runDeck();
    wait();
    one.window.runInNewFolder();
    wait();
    Document& document = one.window.document();
    one.window.runPanel().sweep(document.path(), document.deck(), {}, "rpm2=7000:7100:2");
    wait();
    CHECK(spy.count() == 3);
  }
  CHECK(deck::read_deck(ra / "DATA.txt").deck.real("rpm2") == 7000);
  for (const char* name : {"SOL1", "run-001/SOL1", "sweep-001/SWEEP.csv"}) {
    INFO(name);
    CHECK(fs::exists(ra / name));
  }
  CHECK(given.size() > 6);
  for (const QString& name : given) {
    INFO(name.toStdString());
    CHECK((name.startsWith("--") || name.startsWith(QString::fromStdString(ra.string()))));
  }
  CHECK(setting("session/deck") == (ra / "DATA.txt").string());
  CHECK(setting("folder") == ra.string());
  CHECK(desktop::recent_files("adrinput").front().toStdString() == (ra / "DATA.txt").string());

  back();
  Document document;
  document.save("NEW.txt");
  document.save_draft("HALF.draft");
  StudyDocument study;
  study.start_new("sweep.json", "sweep", "DATA.txt");
  StudyDocument saved;
  saved.open([&] {
    study.save("saved.json");
    return fs::path("saved.json");
  }());
  elsewhere();
  CHECK(document.path() == ra / "NEW.txt");
  CHECK(document.draft() == ra / "HALF.draft");
  CHECK(study.path() == ra / "saved.json");
  CHECK(saved.path() == ra / "saved.json");
  document.save(document.path());
  CHECK_FALSE(fs::exists("NEW.txt"));
  CHECK(bytes_of("DATA.txt") == other);
  CHECK(fs::directory_iterator(".") != fs::directory_iterator());
  for (const auto& entry : fs::directory_iterator("."))
    CHECK(entry.path().filename() == "DATA.txt");
}

TEST_CASE("short names: shortened in the middle, distinguishing folders kept",
          "[adrinput][recovery]") {
  CHECK(shortened_path("/home/me/DATA.txt") == "/home/me/DATA.txt");
  const std::string said = shortened_path(
      "/home/someone/projects/of this year/gearbox of the third stage/bearings/left/DATA.txt");
  CHECK(said.size() < 75);
  CHECK(said.find("/home/…/") == 0);
  CHECK(said.find("/bearings/left/DATA.txt") != std::string::npos);
}
