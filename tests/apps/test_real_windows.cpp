#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <memory>
#include <string>

/// The programs in real windows: a display of their own (Xvfb) with a window manager (openbox), and
/// a hand that types (xdotool). Where one of them is missing the tests say so and end.
namespace {

class Desk {
 public:
  /// nullptr, after a sentence, where the machine cannot do it.
  static std::unique_ptr<Desk> make(const QString& screen) {
    for (const char* tool : {"Xvfb", "openbox", "xdotool", "xwininfo", "xprop"})
      if (QStandardPaths::findExecutable(tool).isEmpty()) {
        WARN("skipped: " << tool << " is not installed (setup.sh installs it)");
        return nullptr;
      }
    auto desk = std::unique_ptr<Desk>(new Desk);
    desk->server_.start("Xvfb", {"-displayfd", "1", "-screen", "0", screen, "-nolisten", "tcp"});
    REQUIRE(desk->server_.waitForStarted());
    QByteArray number;
    while (!number.contains('\n') && desk->server_.waitForReadyRead(20000))
      number += desk->server_.readAllStandardOutput();
    REQUIRE(!number.trimmed().isEmpty());
    desk->environment_ = QProcessEnvironment::systemEnvironment();
    desk->environment_.remove("QT_QPA_PLATFORM");
    desk->environment_.remove("WAYLAND_DISPLAY");
    desk->environment_.insert("DISPLAY", ":" + QString::fromUtf8(number.trimmed()));
    desk->environment_.insert("HOME", desk->home_.path());
    desk->environment_.insert("XDG_CONFIG_HOME", desk->home_.path());
    desk->environment_.insert("XDG_DATA_HOME", desk->home_.path());
    desk->environment_.insert("XDG_RUNTIME_DIR", desk->home_.path());
    QDir(desk->home_.path()).mkpath("Adore");
    QFile accepted(desk->home_.filePath("Adore/Adore.conf"));
    REQUIRE(accepted.open(QIODevice::WriteOnly));
    accepted.write("[disclaimer]\naccepted=1\n");
    accepted.close();
    desk->manager_.setProcessEnvironment(desk->environment_);
    desk->manager_.start("openbox", {});
    REQUIRE(desk->manager_.waitForStarted());
    REQUIRE(desk->comes([&] {
      return desk->said_by("xprop", {"-root", "_NET_SUPPORTING_WM_CHECK"}).contains("window id");
    }));
    return desk;
  }
  ~Desk() {
    for (QProcess* process : {&source_, &program_, &manager_, &server_}) {
      process->terminate();
      if (!process->waitForFinished(5000)) process->kill();
      process->waitForFinished(5000);
    }
  }

  void scaleBy(int factor) { environment_.insert("QT_SCALE_FACTOR", QString::number(factor)); }

  void start(const char* name, const QStringList& arguments) {
    program_.setProcessEnvironment(environment_);
    program_.setProcessChannelMode(QProcess::MergedChannels);
    program_.start(QString::fromStdString(adore::test::program(name).string()), arguments);
    REQUIRE(program_.waitForStarted());
  }

  QString xdotool(const QStringList& arguments) { return said_by("xdotool", arguments); }

  /// The window whose title holds a text, once it is there.
  QString window(const QString& title) {
    for (int wait = 0; wait < 150; ++wait) {
      const QString id = xdotool({"search", "--onlyvisible", "--name", title}).section('\n', -1);
      if (!id.isEmpty()) return id;
      QTest::qWait(200);
    }
    FAIL("no window named " << title.toStdString() << ": " << program_.readAll().toStdString());
    return {};
  }

  void keys(const QStringList& names) {
    for (const QString& name : names) {
      xdotool({"key", "--clearmodifiers", name});
      QTest::qWait(200);
    }
  }
  void type(const QString& text) {
    xdotool({"type", "--delay", "30", text});
    QTest::qWait(300);
  }

  /// Left, top, width and height of a window with its frame on its screen.
  QRect place(const QString& id) {
    const QString text = said_by("xwininfo", {"-id", id, "-frame"});
    const auto value = [&](const QString& name) {
      return QRegularExpression(name + ":\\s*(-?\\d+)").match(text).captured(1).toInt();
    };
    return {value("Absolute upper-left X"), value("Absolute upper-left Y"), value("Width"),
            value("Height")};
  }

  /// Waits for something, however busy the machine is.
  template <class Condition>
  static bool comes(Condition condition) {
    for (int wait = 0; wait < 300; ++wait) {
      if (condition()) return true;
      QTest::qWait(200);
    }
    return false;
  }

  /// Waits until a window of that title has come or gone.
  bool shows(const QString& title, bool there = true) {
    return comes([&] {
      return xdotool({"search", "--onlyvisible", "--name", title}).isEmpty() != there;
    });
  }

  /// A window from which these files can be dragged, above all others.
  void offer(const QStringList& files) {
    source_.setProcessEnvironment(environment_);
    source_.start(QString::fromStdString(adore::test::program("drag_source").string()), files);
    REQUIRE(source_.waitForStarted());
    window("drag-source");
    QTest::qWait(500);
  }
  void drag(QPoint from, QPoint to) {
    const auto go = [&](const QPoint& to_place) {
      xdotool({"mousemove", QString::number(to_place.x()), QString::number(to_place.y())});
      QTest::qWait(150);
    };
    go(from);
    xdotool({"mousedown", "1"});
    constexpr int kSteps = 8;
    for (int i = 1; i <= kSteps; ++i) go(from + (to - from) * i / kSteps);
    QTest::qWait(500);
    xdotool({"mouseup", "1"});
    QTest::qWait(300);
  }

  bool ends() {
    return (program_.state() == QProcess::NotRunning || program_.waitForFinished(20000)) &&
           program_.exitStatus() == QProcess::NormalExit && program_.exitCode() == 0;
  }

 private:
  Desk() = default;
  QString said_by(const char* tool, const QStringList& arguments) {
    QProcess hand;
    hand.setProcessEnvironment(environment_);
    hand.start(tool, arguments);
    hand.waitForFinished(30000);
    return QString::fromUtf8(hand.readAllStandardOutput()).trimmed();
  }
  QTemporaryDir home_;
  QProcessEnvironment environment_;
  QProcess server_, manager_, program_, source_;
};

/// Deck and results of a short run, made once.
const QString& results() {
  static QTemporaryDir folder;
  static const bool done = [] {
    const auto adore = [](const QStringList& arguments) {
      return QProcess::execute(QString::fromStdString(adore::test::program("adore").string()),
                               arguments) == 0;
    };
    REQUIRE(adore({"new", "ball", "--out", folder.filePath("DATA.txt")}));
    REQUIRE(adore({"run", folder.path(), "--until", "40", "--set", "kPltFreq=1", "--set",
                   "kAGraf=1", "--quiet"}));
    return true;
  }();
  (void)done;
  static const QString path = folder.path();
  return path;
}

std::string text_of(const QString& path) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::ReadOnly));
  return file.readAll().toStdString();
}

}  // namespace

TEST_CASE("a real window of AdrInput: a size in millimetres is typed, Ctrl+U empties nothing",
          "[gui][apps][window][slow]") {
  adore::test::use_qt();
  const auto desk = Desk::make("1280x800x24");
  if (!desk) return;
  const QTemporaryDir folder;
  const QString deck = folder.filePath("DATA.txt");
  REQUIRE(QFile::copy(results() + "/DATA.txt", deck));
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
      desk->start(program.name, {results() + "/" + program.file});
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
  desk->start("adrplot", {results() + "/SOL1", "--dark", "--page", "6"});
  CHECK(desk->shows("page 6 of"));
  CHECK(ends("page 6 of"));
  desk->start("adrplot", {results() + "/SOL1", "--page", "600"});
  CHECK(desk->shows("page 1 of"));
  desk->keys({"Return"});  // the message that there is none
  CHECK(ends("page 1 of"));
  desk->start("agore", {results() + "/SOL8", "--dark"});
  CHECK(desk->shows("Bearing motion"));
  CHECK(ends("Bearing motion"));
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
    if (program != std::string("adrinput")) {  // it asks for a file by itself
      QTest::qWait(1000);
      desk->keys({"Escape"});
    }
    desk->offer({results() + "/" + file});
    const QRect icon = desk->place(desk->window("drag-source"));
    desk->drag(icon.center(), {place.left() + 2 * place.width() / 5, place.center().y()});
    if (program == std::string("adrplot")) {  // the range of its steps
      QTest::qWait(1000);
      desk->keys({"Return"});
    }
    CHECK(desk->shows(title));
  }
}
