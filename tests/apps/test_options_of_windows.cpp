#include "apps/desk.hpp"
#include "support/qt_app.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>
#include <QRegularExpression>
#include <QSet>

/// Options of the command line are not stored for the next window.
using adore::test::Desk;

namespace {

struct Program {
  const char *name, *title, *file;
};
constexpr Program kPrograms[]{{"adrinput", "AdrInput", "DATA.txt"},
                              {"adrplot", "AdrPlot", "SOL1"},
                              {"agore", "AGORE", "SOL8"}};

/// Names of all options of the program, and whether they have a value.
QMap<QString, bool> options_of(const char* program) {
  QProcess process;
  process.start(QString::fromStdString(adore::test::program(program).string()),
                {"--completion", "json"});
  REQUIRE(process.waitForFinished(20000));
  QMap<QString, bool> out;
  const QJsonObject tree = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
  for (const QJsonValue& option : tree["options"].toArray()) {
    if (option["positional"].toBool()) continue;
    out[option["names"].toArray().last().toString()] = !option["value"].toString().isEmpty();
  }
  REQUIRE(out.size() > 4);
  return out;
}

/// A value that differs from the default of the window.
const QMap<QString, QString> kValues{{"--size", "900x700"},    {"--page", "2"},
                                     {"--from", "2"},          {"--to", "5"},
                                     {"--every", "2"},         {"--abscissa", "time"},
                                     {"--view", "cage"},       {"--beside", "element"},
                                     {"--race", "outer"},      {"--element", "2"},
                                     {"--exaggerate", "7"},    {"--frame", "2"},
                                     {"--html", "scene.html"}, {"--movie", "film.gif"},
                                     {"--fps", "5"},           {"--slow", "1e-4"},
                                     {"--colour", "load"},     {"--scale", "run"},
                                     {"--domain", "spectrum"}, {"--curve", "2"},
                                     {"--rows", "speed"},      {"--band", "2000:8000"},
                                     {"--orders-of", "cage"}};
/// Of pictures alone: no window comes.
const QSet<QString> kOfPictures{"--size", "--frame", "--movie", "--html", "--fps", "--slow"};

}  // namespace

TEST_CASE("no option of a window's command line is remembered for the next window",
          "[gui][apps][window][slow]") {
  adore::test::use_qt();
  for (const Program& program : kPrograms) {
    const auto desk = Desk::make("1280x800x24");
    if (!desk) return;
    const QString file = adore::test::short_run() + "/" + program.file;
    const auto open_and_close = [&](const QStringList& options) {
      desk->start(program.name, QStringList{file} + options);
      desk->xdotool({"windowactivate", "--sync", desk->window(program.title)});
      QTest::qWait(500);
      desk->keys({"ctrl+q"});
      CHECK(desk->ends());
    };
    open_and_close({});
    const QStringList before = desk->remembered();
    REQUIRE(before.size() > 2);
    const auto changed = [&] {
      const QStringList now = desk->remembered();
      QStringList out;
      for (const QString& line : now)
        if (!before.contains(line)) out << line;
      for (const QString& line : before)
        if (!now.contains(line)) out << "gone: " + line;
      return out.join("\n").toStdString();
    };
    open_and_close({});
    REQUIRE(changed() == "");  // otherwise options could not be tested
    int tried = 0;
    const QMap<QString, bool> options = options_of(program.name);
    for (auto option = options.begin(); option != options.end(); ++option) {
      if (QSet<QString>{"--help", "--version", "--man", "--completion", "--render"}.contains(
              option.key()))
        continue;
      INFO(program.name << " " << option.key().toStdString());
      ++tried;
      QStringList words{option.key()};
      if (option.key() == "--project")
        words << adore::test::short_run();
      else if (program.name == std::string("adrplot") && option.key() == "--scale")
        words << "db"
              << "--domain"
              << "spectrum";
      else if (option.value()) {
        REQUIRE(kValues.contains(option.key()));  // a new option: give it a value above
        words << kValues[option.key()];
      }
      if (option.key() == "--curve" || option.key() == "--rows")
        words << "--domain"
              << "spectrogram";
      if (option.key() == "--band" || option.key() == "--orders-of")
        words << "--domain"
              << "envelope";
      const bool picture = kOfPictures.contains(option.key()) ||
                           (program.name == std::string("adrinput") && option.key() == "--dark") ||
                           (program.name == std::string("agore") &&
                            QSet<QString>{"--from", "--to", "--every"}.contains(option.key()));
      if (!picture) {
        open_and_close(words);
      } else {
        const QTemporaryDir pictures;
        words << "--render" << pictures.path();
        if (QSet<QString>{"--fps", "--slow"}.contains(option.key()))
          words << "--movie"
                << "f.gif";
        if (QSet<QString>{"--from", "--to"}.contains(option.key()))
          words << "--every"
                << "3";
        desk->start(program.name, QStringList{file} + words);
        CHECK(desk->ends());
      }
      CHECK(changed() == "");
    }
    CHECK(tried >= 2);
  }
}

TEST_CASE("a real run's end opens its plots and leaves the keyboard to who types",
          "[gui][apps][window][slow]") {
  adore::test::use_qt();
  const auto desk = Desk::make("1280x800x24");
  if (!desk) return;
  const QTemporaryDir folder;
  REQUIRE(QFile::copy(adore::test::short_run() + "/DATA.txt", folder.filePath("DATA.txt")));
  desk->start("adrinput", {folder.filePath("DATA.txt")});
  const QString window = desk->window("AdrInput");
  desk->xdotool({"windowactivate", "--sync", window});
  desk->keys({"ctrl+f"});
  desk->type("maxStps");
  desk->keys({"Return", "ctrl+a"});
  desk->type("200");
  desk->keys({"Tab", "F7"});
  const QStringList viewers{desk->window("AdrPlot"), desk->window("AGORE")};
  QTest::qWait(2000);
  CHECK(desk->active() == window);
  desk->keys({"alt+l"});  // the button Plots: asked for
  CHECK(Desk::comes([&] { return desk->active() == viewers[0]; }));
  desk->keys({"ctrl+q"});
  desk->xdotool({"windowactivate", "--sync", viewers[1]});
  desk->keys({"ctrl+q"});
  desk->xdotool({"windowactivate", "--sync", window});
  desk->keys({"ctrl+q"});
  CHECK(desk->ends());
}
