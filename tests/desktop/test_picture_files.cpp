#include "base/errors.hpp"
#include "desktop/avi_writer.hpp"
#include "desktop/command_line.hpp"
#include "desktop/disclaimer.hpp"
#include "desktop/image_export.hpp"
#include "desktop/theme.hpp"
#include "desktop/window_place.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QFile>
#include <QFontInfo>
#include <QImage>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QWidget>
#include <QtEndian>
#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

using namespace adore;
using namespace adore::desktop;
namespace fs = std::filesystem;

namespace {

quint32 number_at(const QByteArray& bytes, qsizetype at) {
  return qFromLittleEndian<quint32>(bytes.constData() + at);
}

}  // namespace

TEST_CASE("theme: the shipped font is the one in use", "[gui]") {
  test::use_qt();
  CHECK(QFontInfo(ui_font(13)).family() == "DejaVu Sans");
  CHECK(QFile::exists(":/adore/fonts/LICENSE-DejaVu.txt"));
}

TEST_CASE("every app has an icon and an entry in the desktop's menu", "[gui]") {
  test::use_qt();
  const fs::path resources = adore::test::source_dir() / "resources";
  for (const std::string app : {"adrinput", "adrplot", "agore"}) {
    INFO(app);
    const QImage icon(QString::fromStdString(":/adore/icons/" + app + ".png"));
    CHECK(icon.size() == QSize(128, 128));
    CHECK(fs::exists(resources / "icons" / (app + ".svg")));
    const std::string entry = test::bytes_of(resources / "applications" / (app + ".desktop"));
    CHECK(entry.find("\nExec=" + app + " %") != std::string::npos);
    CHECK(entry.find("\nIcon=" + app + "\n") != std::string::npos);
  }
}

TEST_CASE("image_export: names count on, and skip files that exist", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const QString first = folder.filePath("plot.jpg");
  CHECK(next_image_name(first) == folder.filePath("plot-2.jpg"));
  CHECK(next_image_name(folder.filePath("plot-9.png")) == folder.filePath("plot-10.png"));
  QImage image(20, 10, QImage::Format_RGB32);
  image.fill(Qt::red);
  save_image(image, folder.filePath("plot-2.jpg").toStdString());
  CHECK(next_image_name(first) == folder.filePath("plot-3.jpg"));
}

TEST_CASE("image_export: file name from the content, with a number", "[gui]") {
  test::use_qt();
  QTemporaryDir data, pictures;
  const auto of = [&](const char* name) { return data.filePath(name); };
  const auto proposed = [](const QString& shown) { return proposed_image_name("of-what", shown); };
  const auto save = [](const QString& shown, const QString& name) {
    QImage image(20, 10, QImage::Format_RGB32);
    image.fill(Qt::red);
    save_image(image, name.toStdString());
    remember_image_name("of-what", shown, name);
  };
  // In any order of display: its name, the first free number.
  std::map<QString, int> saved;
  for (const char* name : {"SOL1-page-6.jpg", "SOL1-page-6.jpg", "SOL3-page-1.jpg",
                           "SOL1-page-7.jpg", "SOL1-page-6.jpg", "SOL3-page-1.jpg"}) {
    const QString shown = of(name);
    const int number = ++saved[shown];
    const QString expected =
        number == 1 ? shown : QString(shown).replace(".jpg", QString("-%1.jpg").arg(number));
    CHECK(proposed(shown).toStdString() == expected.toStdString());
    save(shown, proposed(shown));
  }
  // A selected folder stays selected for files of the same folder.
  save(of("SOL1-page-6.jpg"), pictures.filePath("SOL1-page-6.jpg"));
  CHECK(proposed(of("SOL3-page-1.jpg")) == pictures.filePath("SOL3-page-1.jpg"));
  CHECK(proposed(of("SOL1-page-6.jpg")) == pictures.filePath("SOL1-page-6-2.jpg"));
  const QString elsewhere = pictures.filePath("run/SOL1-page-6.jpg");
  CHECK(proposed(elsewhere) == elsewhere);
  // A name of one's own counts on for what it was given to, and for nothing else.
  save(of("SOL1-page-6.jpg"), pictures.filePath("start.jpg"));
  CHECK(proposed(of("SOL1-page-6.jpg")) == pictures.filePath("start-2.jpg"));
  CHECK(proposed(of("SOL3-page-1.jpg")) == pictures.filePath("SOL3-page-1.jpg"));
}

TEST_CASE("image_export: PNG and JPEG written, other suffixes → rejected with a message", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  QImage image(64, 48, QImage::Format_RGB32);
  image.fill(QColor(10, 120, 200));
  for (const char* name : {"a.png", "b.jpg", "c.JPEG"}) {
    save_image(image, folder.filePath(name).toStdString());
    const QImage back(folder.filePath(name));
    REQUIRE(back.size() == image.size());
    CHECK(std::abs(back.pixelColor(30, 20).green() - 120) <= 3);  // JPEG is lossy by a few levels
  }
  CHECK_THROWS_WITH(save_image(image, folder.filePath("d.bmp").toStdString()),
                    Catch::Contains(".png, .jpg or .jpeg"));
  CHECK_THROWS_AS(save_image(image, folder.filePath("missing/e.png").toStdString()), InputError);
}

TEST_CASE("image_export: only own pictures and films are replaced without a question", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  QImage image(64, 48, QImage::Format_RGB32);
  image.fill(Qt::green);
  const auto path = [&](const char* name) {
    return std::filesystem::path(folder.filePath(name).toStdString());
  };
  for (const char* name : {"own.png", "own.jpg"}) {
    save_image(image, path(name));
    CHECK_NOTHROW(save_image(image, path(name)));
    REQUIRE(image.save(folder.filePath(name)));  // as another program would
    CHECK_THROWS_WITH(save_image(image, path(name)),
                      Catch::Contains("not written by this program"));
    CHECK_NOTHROW(save_image(image, path(name), Replace::Anything));  // somebody was asked
    CHECK_NOTHROW(save_image(image, path(name)));
  }
  std::filesystem::create_symlink(path("own.png"), path("link.png"));
  CHECK_THROWS_AS(save_image(image, path("link.png")), InputError);
  CHECK_THROWS_AS(AviWriter(path("link.png"), {64, 48}, 25), InputError);
  for (int time = 0; time < 2; ++time) {
    AviWriter film(path("film.avi"), {64, 48}, 25);
    film.add(image);
    film.finish();
  }
  QFile file(folder.filePath("film.avi"));
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write("RIFF\1\2\3\4AVI of somebody else");
  file.close();
  CHECK_THROWS_WITH(AviWriter(path("film.avi"), {64, 48}, 25),
                    Catch::Contains("not written by this program"));
}

TEST_CASE("avi_writer: the film is a valid RIFF file whose index finds every picture", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const QString name = folder.filePath("film.avi");
  constexpr int kFrames = 7;
  {
    AviWriter film(name.toStdString(), {320, 200}, 25);
    for (int i = 0; i < kFrames; ++i) {
      QImage image(320, 200, QImage::Format_RGB32);
      image.fill(QColor(30 * i, 90, 200 - 20 * i));
      film.add(image);
    }
    CHECK_FALSE(QFile::exists(name));  // appears when complete
    film.finish();
  }
  QFile file(name);
  REQUIRE(file.open(QIODevice::ReadOnly));
  const QByteArray bytes = file.readAll();
  CHECK(bytes.left(4) == "RIFF");
  CHECK(number_at(bytes, 4) == bytes.size() - 8);
  const auto movi = bytes.indexOf("movi"), index = bytes.indexOf("idx1");
  REQUIRE(movi > 0);
  REQUIRE(index > movi);
  CHECK(number_at(bytes, movi - 4) == index - movi);
  REQUIRE(number_at(bytes, index + 4) == 16 * kFrames);
  CHECK(number_at(bytes, bytes.indexOf("avih") + 8 + 16) == kFrames);
  for (int i = 0; i < kFrames; ++i) {
    const auto entry = index + 8 + 16 * i;
    const auto chunk = movi + number_at(bytes, entry + 8);
    CHECK(bytes.mid(chunk, 4) == "00dc");
    CHECK(number_at(bytes, chunk + 4) == number_at(bytes, entry + 12));
    const QImage picture =
        QImage::fromData(bytes.mid(chunk + 8, number_at(bytes, chunk + 4)), "JPEG");
    REQUIRE(picture.size() == QSize(320, 200));
    CHECK(std::abs(picture.pixelColor(100, 100).red() - 30 * i) <= 4);
  }
}

TEST_CASE("avi_writer: an unfinished or empty film leaves no file", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const QString name = folder.filePath("film.avi");
  AviWriter film(name.toStdString(), {320, 200}, 25);
  CHECK_THROWS_AS(film.finish(), InputError);
  CHECK_FALSE(QFile::exists(name));
  CHECK_THROWS_AS(AviWriter(folder.filePath("no/film.avi").toStdString(), {320, 200}, 25),
                  InputError);
}

TEST_CASE("disclaimer: names warranty and independence, and is remembered", "[gui]") {
  test::use_qt();
  DisclaimerDialog dialog("AdrPlot");
  QString text;
  for (auto* label : dialog.findChildren<QLabel*>()) text += label->text();
  CHECK(text.contains("without any warranty"));
  CHECK(text.contains("independent implementation"));
  CHECK_FALSE(disclaimer_accepted());
  remember_disclaimer();
  CHECK(disclaimer_accepted());
  CHECK(ask_for_disclaimer("AdrPlot"));  // returns at once
}

TEST_CASE("command_line: picture sizes are checked", "[unit]") {
  CHECK(parse_size("800x600").width == 800);
  CHECK(parse_size("800x600").height == 600);
  for (const char* wrong :
       {"", "800", "800x", "x600", "800x600x3", "10x600", "99999x600", "8e2x600"})
    CHECK_THROWS_AS(parse_size(wrong), InputError);
}

TEST_CASE("a window opens within its screen, frame and title bar included", "[unit][gui][window]") {
  CHECK(desktop::size_within({1320, 820}, {2560, 1440}) == QSize(1320, 820));
  CHECK(desktop::size_within({1320, 820}, {1280, 800}) == QSize(1264, 752));
  CHECK(desktop::size_within({1280, 860}, {1920, 800}) == QSize(1280, 752));
}

TEST_CASE("a window comes back where it was closed", "[unit][gui][window]") {
  test::use_qt();
  const QString app = "adore-test-window-place";
  QSettings("Adore", app).clear();
  {
    QWidget window;
    desktop::resize_to_fit_screen(window, {700, 500});
    const desktop::WindowGeometryStore memory(window, app);
    CHECK(window.size() == QSize(700, 500));
    window.show();
    window.resize(640, 410);
    window.close();
  }
  QWidget window;
  desktop::resize_to_fit_screen(window, {700, 500});
  const desktop::WindowGeometryStore memory(window, app);
  CHECK(window.size() == QSize(640, 410));
  QSettings("Adore", app).clear();
}
