#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/session.hpp"
#include "base/write_folder.hpp"
#include "deck/templates.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <memory>

using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

constexpr const char* kChild = "helper process: types into a window and waits to be killed";

NoticeBar& notice(DeckWindow& window, const QString& name) {
  auto* bar = window.findChild<NoticeBar*>(name);
  REQUIRE(bar != nullptr);
  return *bar;
}

bool shown(DeckWindow& window, const QString& name) { return notice(window, name).isVisible(); }

QStringList unsaved(const QTemporaryDir& folder) {
  return QDir(folder.filePath("unsaved")).entryList({"*.unsaved"}, QDir::Files);
}

void type(DeckWindow& window, const std::string& variable, const QString& text) {
  window.showRecord(cell(variable).record);
  auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell(variable).variable));
  REQUIRE(line != nullptr);
  replace_text(line, text);
}

/// A window with its session, as in the program.
struct Started {
  DeckWindow window;
  Session session;
  explicit Started(const QTemporaryDir& folder, const fs::path& deck = {})
      : session(window, folder.filePath("unsaved")) {
    window.show();
    if (!deck.empty()) window.openFile(deck);
    session.begin(!deck.empty());
  }
};

}  // namespace

TEST_CASE("helper process: types into a window and waits to be killed", "[.child]") {
  test::use_qt();
  const QString folder = qEnvironmentVariable("ADORE_TEST_FOLDER");
  if (folder.isEmpty()) return;  // started by nobody
  DeckWindow window;
  Session session(window, folder + "/unsaved");
  window.show();
  window.openFile((folder + "/DATA.txt").toStdString());
  session.begin(true);
  type(window, "cageDia1", "0,0663");
  window.document().edit(cell("nCseg"), "0");  // puts the cage on the shelf
  window.showRecord("12");
  QTest::keyClicks(window.page()->findChild<QPlainTextEdit*>("lines"), "1.0 2.0 line");
  type(window, "bReDia", "twelve");
  type(window, "pitchDia", "0,0611");
  for (;;) {
    QCoreApplication::processEvents();
    QThread::msleep(5);
  }
}

TEST_CASE("session: program killed → typed values are restored", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::ofstream(path) << deck::template_text("ball");
  const std::string original = bytes_of(path);

  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("ADORE_TEST_FOLDER", folder.path());
  environment.insert("QT_QPA_PLATFORM", "offscreen");
  program.setProcessEnvironment(environment);
  program.start(QCoreApplication::applicationFilePath(), {kChild});
  const auto typed_last = [&] {
    for (const QString& name : unsaved(folder)) {
      Document stored;
      stored.restore(bytes_of(folder.filePath("unsaved/" + name).toStdString()));
      if (stored.deck().real("pitchDia") == 0.0611) return true;
    }
    return false;
  };
  REQUIRE(QTest::qWaitFor(typed_last, 30000));
  {
    Started other(folder, path);  // the owner still runs: nothing to ask
    CHECK_FALSE(shown(other.window, "session-notice"));
    type(other.window, "pitchDia", "0,0622");
    other.session.store();
    CHECK(unsaved(folder).size() == 2);
    other.window.hide();  // as after closing
  }
  CHECK(unsaved(folder).size() == 1);
  program.kill();
  REQUIRE(program.waitForFinished());
  CHECK(program.exitStatus() == QProcess::CrashExit);
  CHECK(bytes_of(path) == original);

  {
    Started next(folder, path);
    CHECK(shown(next.window, "session-notice"));
    CHECK(notice(next.window, "session-notice").text().contains("DATA.txt"));
    press(next.window, "later");
    CHECK_FALSE(shown(next.window, "session-notice"));
    CHECK_FALSE(next.window.document().modified());
    emit next.window.recoveryRequested();
    CHECK(shown(next.window, "session-notice"));
    press(next.window, "later");
  }
  CHECK(unsaved(folder).size() == 1);
  {
    Started next(folder);
    REQUIRE(shown(next.window, "session-notice"));
    press(next.window, "restore");
    CHECK_FALSE(shown(next.window, "session-notice"));
    Document& document = next.window.document();
    CHECK(next.window.currentRecord() == "5A");
    CHECK(document.path() == path);
    CHECK(document.modified());
    CHECK(document.deck().real("pitchDia") == 0.0611);
    CHECK(document.text(cell("bReDia")) == "twelve");
    CHECK(document.has_errors());
    CHECK(document.deck().user_lines == std::vector<std::string>{"1.0 2.0 line"});
    document.edit(cell("nCseg"), "1");
    CHECK(document.text(cell("cageDia1")) == "0.0663");
    CHECK(document.original() == original);
    CHECK(unsaved(folder).size() == 1);  // under the name of this program now
    document.edit(cell("bReDia"), "0.0127");
    document.save(path);
    CHECK_FALSE(fs::exists(path.string() + ".bak"));  // its remarks are in the new file
    CHECK(bytes_of(path).find("stpInit stpMin stpMax") != std::string::npos);
    next.session.store();
    CHECK(unsaved(folder).isEmpty());
  }
  CHECK(deck::read_deck(path).deck.real("pitchDia") == 0.0611);
  CHECK(QDir(folder.filePath("unsaved")).isEmpty());  // no lock stays behind either
}

TEST_CASE("session: typed values → stored automatically, deleted after an orderly end",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  fs::create_directories(folder.filePath("unsaved").toStdString());
  const fs::path old_lock = folder.filePath("unsaved/7-1.unsaved.lock").toStdString();
  std::ofstream(old_lock) << "";
  {
    Started one(folder);
    CHECK(unsaved(folder).isEmpty());
    CHECK_FALSE(fs::exists(old_lock));
    type(one.window, "pitchDia", "0.0612");
    CHECK(QTest::qWaitFor([&] { return !unsaved(folder).isEmpty(); }, 5000));
    one.window.undo();
    CHECK(QTest::qWaitFor([&] { return unsaved(folder).isEmpty(); }, 5000));
    type(one.window, "pitchDia", "0.0613");
    CHECK(QTest::qWaitFor([&] { return !unsaved(folder).isEmpty(); }, 5000));
    one.window.hide();
  }
  CHECK(unsaved(folder).isEmpty());
  {
    // A window that goes without the question, as when the desktop takes the program down.
    Started one(folder);
    type(one.window, "pitchDia", "0.0614");
  }
  REQUIRE(unsaved(folder).size() == 1);
  const fs::path file = folder.filePath("unsaved/" + unsaved(folder).front()).toStdString();
  const std::string whole = bytes_of(file);
  // A file that cannot be understood is kept until somebody says otherwise.
  write_file_atomically(file, whole.substr(0, whole.size() / 2));
  {
    Started one(folder);
    REQUIRE(shown(one.window, "session-notice"));
    CHECK(notice(one.window, "session-notice").text().contains("cannot be restored"));
    press(one.window, "later");
    CHECK(fs::exists(file));
  }
  write_file_atomically(file, whole);
  {
    Started one(folder);
    REQUIRE(shown(one.window, "session-notice"));
    press(one.window, "discard");
    CHECK_FALSE(fs::exists(file));
    CHECK_FALSE(one.window.document().modified());
    emit one.window.recoveryRequested();
    CHECK(take_message(one.window).contains("There are no unsaved decks"));
  }
}

TEST_CASE("session: read-only folder → reported once, editing continues", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  std::ofstream(folder.filePath("unsaved").toStdString()) << "a file where the folder should be";
  Started one(folder);
  type(one.window, "pitchDia", "0.0612");
  one.session.store();
  CHECK(one.window.document().deck().real("pitchDia") == 0.0612);
  CHECK(one.window.document().modified());
}

TEST_CASE("session: last deck, page and window size are restored unless switched off",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("ROLLER.txt").toStdString();
  std::ofstream(path) << deck::template_text("cylindrical");
  QSize size;
  {
    Started one(folder, path);
    one.window.resize(1111, 777);
    one.window.showRecord("9.1.1");
    size = one.window.size();
    one.window.close();
  }
  {
    Started one(folder);
    CHECK(one.window.document().path() == path);
    CHECK(one.window.currentRecord() == "9.1.1");
    CHECK(one.window.size() == size);
    auto* reopenLastDeck = one.window.findChild<QAction*>("reopen");
    REQUIRE(reopenLastDeck != nullptr);
    CHECK(reopenLastDeck->isChecked());
    reopenLastDeck->setChecked(false);
    one.window.close();
  }
  {
    Started one(folder);
    CHECK(one.window.document().path().empty());
    one.window.findChild<QAction*>("reopen")->setChecked(true);
    one.window.openFile(path);
    one.window.close();
  }
  fs::remove(path);
  Started one(folder);
  CHECK(one.window.document().path().empty());
  CHECK(take_message(one.window).isEmpty());
}

TEST_CASE("file watch: deck changed by another program → reload, keep or compare",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  DeckWindow window;
  window.show();
  window.document().save(path);
  QTest::qWait(300);
  CHECK_FALSE(shown(window, "file-notice"));  // a save by this program is not reported as a change
  deck::Deck foreign = window.document().deck();
  const auto replace = [&](const char* pitch, bool atomically) {
    foreign.set("pitchDia", pitch);
    if (atomically)
      deck::write_deck(foreign, path);
    else
      std::ofstream(path) << deck::write_deck(foreign);
    REQUIRE(QTest::qWaitFor([&] { return shown(window, "file-notice"); }, 5000));
  };
  window.showRecord("7.1");
  replace("0.0601", true);
  press(window, "reload");
  CHECK_FALSE(shown(window, "file-notice"));
  CHECK(window.document().deck().real("pitchDia") == 0.0601);
  CHECK(window.currentRecord() == "7.1");

  window.document().edit(cell("bReDia"), "0.0126");
  replace("0.0602", false);
  CHECK(window.findChild<QPushButton*>("reload")->text().contains("discard"));
  press(window, "compare-file");
  auto* dialog = window.findChild<QDialog*>("compare");
  REQUIRE(dialog != nullptr);
  dialog->close();
  REQUIRE(shown(window, "file-notice"));
  press(window, "keep-mine");
  CHECK(window.document().deck().real("pitchDia") == 0.0601);
  CHECK(window.document().modified());
  const std::string theirs = bytes_of(path);
  window.save();  // answered already: no second question
  CHECK(window.findChild<QMessageBox*>("changed") == nullptr);
  CHECK(deck::read_deck(path).deck.real("bReDia") == 0.0126);
  CHECK(bytes_of(path.string() + ".bak") == theirs);

  fs::remove(path);
  REQUIRE(QTest::qWaitFor([&] { return shown(window, "file-notice"); }, 5000));
  CHECK(notice(window, "file-notice").text().contains("removed"));
  press(window, "file-ok");
  window.save();
  CHECK(fs::exists(path));
}

TEST_CASE("charts of a solution do not come back empty in the next session", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::ofstream(path) << deck::template_text("ball");
  const auto dock = [](DeckWindow& window, const char* name) {
    return window.findChild<QDockWidget*>(name);
  };
  {
    Started first(folder, path);
    first.window.runQuasiStatic();
    REQUIRE(QTest::qWaitFor([&] { return !first.window.staticsPanel().busy(); }, 60000));
    CHECK(dock(first.window, "solution-dock")->isHidden());
    first.window.showRecord("3.2");  // leaves the design page
    CHECK_FALSE(dock(first.window, "solution-dock")->isHidden());
  }
  Started next(folder, path);
  next.window.showRecord("3.2");
  CHECK(dock(next.window, "solution-dock")->isHidden());
  CHECK_FALSE(dock(next.window, "drawing-dock")->isHidden());
}
