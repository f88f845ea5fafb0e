#pragma once

#include "support/paths.hpp"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRect>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <memory>
#include <string>

/// The programs in real windows: a separate display (Xvfb) with a window manager (openbox) and
/// simulated keys (xdotool). Without one of them the tests are skipped with a message.
namespace adore::test {

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
    program_.start(QString::fromStdString(program(name).string()), arguments);
    REQUIRE(program_.waitForStarted());
  }

  QString xdotool(const QStringList& arguments) { return said_by("xdotool", arguments); }

  /// The window with a text in its title, as soon as it exists.
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
    source_.start(QString::fromStdString(program("drag_source").string()), files);
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

  /// The window that has the keyboard.
  QString active() { return xdotool({"getactivewindow"}); }

  /// Stored settings of the programs, "Adore/agore.conf: [General] theme=dark" per line.
  QStringList remembered() {
    QStringList out;
    const QDir folder(home_.filePath("Adore"));
    for (const QString& name : folder.entryList({"*.conf"}, QDir::Files, QDir::Name)) {
      QFile file(folder.filePath(name));
      REQUIRE(file.open(QIODevice::ReadOnly));
      for (const QByteArray& line : file.readAll().split('\n'))
        if (!line.isEmpty()) out << name + ": " + QString::fromUtf8(line);
    }
    return out;
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
inline const QString& short_run() {
  static QTemporaryDir folder;
  static const bool done = [] {
    const auto adore = [](const QStringList& arguments) {
      return QProcess::execute(QString::fromStdString(program("adore").string()), arguments) == 0;
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

}  // namespace adore::test
