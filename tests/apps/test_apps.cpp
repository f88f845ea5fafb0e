#include "desktop/launch.hpp"
#include "desktop/mp4_writer.hpp"
#include "desktop/one_window.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QDir>
#include <QImage>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTest>
#include <catch2/catch.hpp>

#include <csignal>
#include <cstdlib>
#include <set>
#include <string>
#include <sys/stat.h>
#include <vector>

/// The programs themselves, started headless on the files of one real run.
namespace {

struct Ended {
  int code = -1;
  QString output;
};
Ended start(const char* name, const QStringList& arguments) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("QT_QPA_PLATFORM", "offscreen");
  process.setProcessEnvironment(environment);
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(QString::fromStdString(adore::test::program(name).string()), arguments);
  if (!process.waitForFinished(100000)) return {};
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          QString::fromUtf8(process.readAll())};
}

/// A short run of the example ball bearing, made once.
const QString& run_folder() {
  static QTemporaryDir folder;
  static const bool done = [] {
    REQUIRE(start("adore", {"new", "ball", "--out", folder.filePath("DATA.txt")}).code == 0);
    const Ended run = start("adore", {"run", folder.path(), "--until", "40", "--set", "kPltFreq=1",
                                      "--set", "kAGraf=1", "--quiet"});
    INFO(run.output.toStdString());
    REQUIRE(run.code == 0);
    return true;
  }();
  (void)done;
  static const QString path = folder.path();
  return path;
}

/// A picture shows something when it has the size asked for and more than a few colors, none of
/// which covers nearly everything.
void check_pictures(const QString& folder, int least, QSize size) {
  const QDir directory(folder);
  const auto names = directory.entryList({"*.png"}, QDir::Files, QDir::Name);
  CHECK(names.size() >= least);
  for (const QString& name : names) {
    INFO(name.toStdString());
    const QImage image(directory.filePath(name));
    REQUIRE_FALSE(image.isNull());
    CHECK(image.size() == size);
    std::set<QRgb> colours;
    int background = 0, looked = 0;
    const QRgb corner = image.pixel(0, 0);
    for (int y = 0; y < image.height(); y += 3)
      for (int x = 0; x < image.width(); x += 3, ++looked) {
        colours.insert(image.pixel(x, y));
        background += image.pixel(x, y) == corner;
      }
    CHECK(colours.size() > 10);
    CHECK(background < 0.995 * looked);
  }
}

}  // namespace

TEST_CASE("adrplot --render draws every page of a real run", "[gui][apps]") {
  adore::test::use_qt();
  QTemporaryDir pictures;
  QStringList arguments{"--render", pictures.path(), "--size", "900x700"};
  for (const char* name : {"SOL1", "SOL4", "SOL7"}) arguments << run_folder() + "/" + name;
  const Ended ended = start("adrplot", arguments);
  INFO(ended.output.toStdString());
  REQUIRE(ended.code == 0);
  check_pictures(pictures.path(), 8 + 3, {900, 700});
}

TEST_CASE("agore --render draws every view of a real run", "[gui][apps]") {
  adore::test::use_qt();
  for (const char* view : {"bearing", "cage", "pocket", "element", "race"}) {
    QTemporaryDir pictures;
    const Ended ended = start("agore", {run_folder() + "/SOL8", "--render", pictures.path(),
                                        "--view", view, "--size", "800x640"});
    INFO(view << ": " << ended.output.toStdString());
    REQUIRE(ended.code == 0);
    check_pictures(pictures.path(), 1, {800, 640});
  }
}

TEST_CASE("adore animate --slow draws the film of agore --render --slow", "[gui][apps]") {
  adore::test::use_qt();
  QTemporaryDir folder;
  const QString file = run_folder() + "/SOL8";
  const auto pictures = [&](const QString& name) {
    return QDir(folder.filePath(name)).entryList({"*.png"}, QDir::Files, QDir::Name);
  };
  const Ended slow = start("adore", {"animate", file, "--out", folder.path(), "--movie", "slow",
                                     "--slow", "1e-4", "--fps", "2"});
  INFO(slow.output.toStdString());
  REQUIRE(slow.code == 0);
  REQUIRE(start("agore", {file, "--render", folder.path(), "--movie", "window", "--slow", "1e-4",
                          "--fps", "2"})
              .code == 0);
  REQUIRE(pictures("slow").size() > 3);
  CHECK(pictures("slow") == pictures("window"));
  for (const QString& name : pictures("slow")) {
    CHECK(name.contains("picture"));  // of the film, not of the file
    CHECK(QImage(folder.filePath("slow/" + name)) == QImage(folder.filePath("window/" + name)));
  }
  const Ended alone = start("adore", {"animate", file, "--out", folder.path(), "--slow", "1e-4"});
  CHECK(alone.code == 2);
  CHECK(alone.output.contains("--movie"));
}

TEST_CASE("an interrupt ends every command alike: a word, exit code 130, no unfinished film",
          "[gui][apps]") {
  adore::test::use_qt();
  QTemporaryDir folder;
  const QString run = run_folder(), out = folder.path();
  struct Command {
    const char* program;
    QStringList words;
  };
  std::vector<Command> commands{
      {"adore", {"check", "-"}},  // waits for a deck
      {"adore", {"plan", run, "--what-if", "--turns", "50"}},
      {"adore", {"plot", run + "/SOL1", run + "/SOL4", run + "/SOL7", "--out", out}},
      {"adore", {"gallery", run, "--out", out}},
      {"adore", {"animate", run + "/SOL8", "--view", "3d", "--out", out}},
      {"adrplot", {run + "/SOL1", run + "/SOL4", run + "/SOL7", "--render", out}},
      {"agore", {run + "/SOL8", "--render", out, "--every", "1", "--view", "3d"}},
      {"agore", {run + "/SOL8", "--render", out, "--movie", "a.gif", "--view", "3d"}},
      {"adore", {"animate", run + "/SOL8", "--out", out, "--movie", "b.avi", "--view", "3d"}}};
  if (adore::desktop::has_ffmpeg())
    for (const char* program : {"agore", "adore"})
      commands.push_back(
          {program, program == std::string("agore")
                        ? QStringList{run + "/SOL8", "--render", out, "--movie", "c.mp4"}
                        : QStringList{"animate", run + "/SOL8", "--out", out, "--movie", "c.mp4"}});
  const auto is_listening = [](qint64 process) {
    QFile status(QString("/proc/%1/status").arg(process));
    if (!status.open(QIODevice::ReadOnly)) return false;
    for (const QByteArray& line : status.readAll().split('\n'))
      if (line.startsWith("SigCgt:"))
        return (line.mid(7).trimmed().toULongLong(nullptr, 16) & 1ULL << (SIGINT - 1)) != 0;
    return false;
  };
  const auto parts = [&] { return QDir(out).entryList({".c.mp4.*"}, QDir::Files | QDir::Hidden); };
  for (const Command& command : commands) {
    INFO(command.program << " " << command.words.join(' ').toStdString());
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QString::fromStdString(adore::test::program(command.program).string()),
                  command.words);
    REQUIRE(process.waitForStarted());
    REQUIRE(QTest::qWaitFor([&] { return is_listening(process.processId()); }, 60'000));
    REQUIRE(::kill(static_cast<pid_t>(process.processId()), SIGINT) == 0);
    REQUIRE(process.waitForFinished(60'000));
    const QString said = QString::fromUtf8(process.readAll());
    INFO(said.toStdString());
    CHECK(process.exitStatus() == QProcess::NormalExit);
    CHECK(process.exitCode() == 130);
    CHECK(said.contains("interrupted"));
    CHECK(parts().isEmpty());
  }
}

TEST_CASE("a second viewer of a project hands its files over and ends", "[gui][apps]") {
  adore::test::use_qt();
  QTemporaryDir project;
  REQUIRE(QDir(project.path()).mkpath("run-001"));
  for (const auto& [program, name] : {std::pair{"adrplot", "SOL1"}, {"agore", "SOL8"}}) {
    const QString file = project.filePath(QString("run-001/") + name);
    REQUIRE(QFile::copy(run_folder() + "/" + name, file));
    QStringList shown;
    const adore::desktop::SingleWindowServer first(
        program, project.path(), nullptr, [&](const QStringList& names) { shown = names; });
    REQUIRE(first.is_listening());
    QProcess second;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    second.setProcessEnvironment(environment);
    second.start(QString::fromStdString(adore::test::program(program).string()),
                 {"--project", project.path(), file});
    REQUIRE(second.waitForStarted());
    CHECK(QTest::qWaitFor([&] { return second.state() == QProcess::NotRunning; }, 60000));
    CHECK(second.exitCode() == 0);
    CHECK(QTest::qWaitFor([&] { return shown == QStringList{file}; }, 5000));
    second.kill();
    second.waitForFinished(5000);
  }
}

TEST_CASE("programs: files of other types → rejected with exit code 2", "[gui][apps]") {
  adore::test::use_qt();
  QTemporaryDir pictures;
  for (const char* program : {"adrplot", "agore"}) {
    const Ended ended = start(program, {"--render", pictures.path(), run_folder() + "/DATA.txt"});
    CHECK(ended.code == 2);
    CHECK(ended.output.contains("DATA.txt"));
  }
}

TEST_CASE("programs: pictures of a project → rejected with exit code 2", "[gui][apps]") {
  adore::test::use_qt();
  const QTemporaryDir folder, pictures;
  QFile project(folder.filePath("PROJECT.json"));
  REQUIRE(project.open(QIODevice::WriteOnly));
  project.write(R"({"format": "adore-project", "version": 1, "decks": [], "runs": []})");
  project.close();
  for (const char* program : {"adrplot", "agore"})
    for (const QString& named : {folder.path(), project.fileName()}) {
      const Ended ended = start(program, {"--render", pictures.path(), named});
      INFO(ended.output.toStdString());
      CHECK(ended.code == 2);
      CHECK(ended.output.contains("project"));
    }
}

TEST_CASE("programs: pipe instead of a file → rejected at once; next to a file → skipped",
          "[gui][apps]") {
  adore::test::use_qt();
  QTemporaryDir folder;
  const auto pipe = [&](const char* name) {
    REQUIRE(::mkfifo(folder.filePath(name).toLocal8Bit().constData(), 0600) == 0);
  };
  for (const char* name : {"SOL1", "SOL8", "RUN.json", "SWEEP.csv", "RUNS.csv", "ACCURACY.json",
                           "STUDY.h5", "DATA.txt", "ADORE.json"})
    pipe(name);
  for (const auto& [program, name] : {std::pair{"adrplot", "SOL1"},
                                      {"adrplot", "RUN.json"},
                                      {"adrplot", "SWEEP.csv"},
                                      {"adrplot", "RUNS.csv"},
                                      {"adrplot", "ACCURACY.json"},
                                      {"adrplot", "STUDY.h5"},
                                      {"agore", "SOL8"},
                                      {"adrinput", "DATA.txt"}}) {
    const Ended ended =
        start(program, {"--render", folder.filePath("pictures"), folder.filePath(name)});
    INFO(program << " " << name << ": " << ended.output.toStdString());
    CHECK(ended.code == 2);
    CHECK(ended.output.contains("pipe"));
  }
  // In the folder of the requested file: SOL1 and RUN.json belong to another run.
  for (const char* name : {"SOL2", "SOL8"}) {
    QFile::remove(folder.filePath(name));
    REQUIRE(QFile::copy(run_folder() + "/" + name, folder.filePath(name)));
  }
  CHECK(start("adrplot", {"--render", folder.filePath("pictures"), folder.filePath("SOL2")}).code ==
        0);
  CHECK(start("agore", {"--render", folder.filePath("pictures"), "--view", "element",
                        folder.filePath("SOL8")})
            .code == 0);
  REQUIRE(QFile::remove(folder.filePath("DATA.txt")));
  REQUIRE(QFile::copy(run_folder() + "/DATA.txt", folder.filePath("DATA.txt")));
  const Ended beside =
      start("adrinput", {"--render", folder.filePath("forms"), folder.filePath("DATA.txt")});
  INFO(beside.output.toStdString());
  CHECK(beside.code == 0);  // its page of options reports the fault of ADORE.json
}

TEST_CASE("adrinput --render draws its pages for a real deck", "[gui][apps]") {
  adore::test::use_qt();
  QTemporaryDir pictures;
  const Ended ended = start("adrinput", {"--render", pictures.path(), run_folder() + "/DATA.txt"});
  INFO(ended.output.toStdString());
  REQUIRE(ended.code == 0);
  const auto names = QDir(pictures.path()).entryList({"*.png"}, QDir::Files);
  REQUIRE(names.size() > 3);
  check_pictures(pictures.path(), 4, QImage(pictures.filePath(names.front())).size());
}

TEST_CASE("programs: start another program of the same folder; missing → message", "[gui][apps]") {
  adore::test::use_qt();
  adore::desktop::set_program_starter({});
  QTemporaryDir pictures;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  adore::desktop::start_program(
      "adrplot", {"--render", pictures.path(), "--page", "1", run_folder() + "/SOL1"});
  CHECK(QTest::qWaitFor(
      [&] { return !QDir(pictures.path()).entryList({"*.png"}, QDir::Files).isEmpty(); }, 60000));
  CHECK_THROWS_WITH(adore::desktop::start_program("no-such-viewer", {}),
                    Catch::Contains("no-such-viewer") && Catch::Contains("PATH"));
}

TEST_CASE("option --project: accepts files only; options of a first window → rejected by name",
          "[gui][apps]") {
  adore::test::use_qt();
  const QString folder = run_folder();
  struct Try {
    const char* program;
    QString file;
    QStringList options;
  };
  std::vector<Try> tries;
  const QString sol1 = folder + "/SOL1", sol8 = folder + "/SOL8";
  const QList<QStringList> of_plots{{"--render", folder + "/pictures"},
                                    {"--page", "2"},
                                    {"--dark"},
                                    {"--from", "2"},
                                    {"--to", "9"},
                                    {"--every", "2"},
                                    {"--abscissa", "time"}};
  const QList<QStringList> of_motion{{"--render", folder + "/pictures"},
                                     {"--view", "cage"},
                                     {"--beside", "section"},
                                     {"--element", "2"},
                                     {"--race", "outer"},
                                     {"--color", "load"},
                                     {"--contacts"},
                                     {"--trails"},
                                     {"--dark"}};
  for (const QStringList& options : of_plots) tries.push_back({"adrplot", sol1, options});
  for (const QStringList& options : of_motion) tries.push_back({"agore", sol8, options});
  for (const Try& one : tries) {
    const Ended ended =
        start(one.program, QStringList{"--project", folder, one.file} + one.options);
    INFO(one.program << ' ' << one.options.join(' ').toStdString() << ": "
                     << ended.output.toStdString());
    CHECK(ended.code == 2);
    CHECK(ended.output.contains("--project"));
    CHECK(ended.output.contains(one.options.front()));
    CHECK_FALSE(QDir(folder).exists("pictures"));
  }
  for (const char* program : {"adrplot", "agore"}) {
    INFO(program);
    const Ended alone = start(program, {"--project", folder});
    CHECK(alone.code == 2);
    CHECK(alone.output.contains(program == std::string("agore") ? "SOL8" : "FILE"));
    const Ended nowhere = start(program, {"--project", folder + "/nowhere", sol1});
    CHECK(nowhere.code == 2);
    CHECK(nowhere.output.contains("nowhere"));
  }
}
