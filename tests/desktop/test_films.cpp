#include "desktop/gif_writer.hpp"
#include "desktop/mp4_writer.hpp"
#include "support/qt_app.hpp"

#include <QFile>
#include <QImage>
#include <QImageReader>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;
using namespace adore::desktop;

TEST_CASE("gif_writer: pictures come back with their colors and pauses", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("film.gif").toStdString();
  GifWriter writer(path, {96, 64}, 20);
  const QList<QColor> colours{Qt::red, Qt::green, Qt::blue};
  for (const QColor& colour : colours) {
    QImage image(96, 64, QImage::Format_RGB32);
    image.fill(colour);
    for (int x = 0; x < 96; ++x)  // noise, so that the table of codes fills up
      for (int y = 0; y < 32; ++y)
        image.setPixelColor(x, y, QColor::fromHsv((x * 37 + y * 91) % 360, 200, 200));
    writer.add(image);
  }
  CHECK_FALSE(std::filesystem::exists(path));  // only a whole film
  writer.finish();
  QImageReader reader(folder.filePath("film.gif"));
  REQUIRE(reader.canRead());
  for (const QColor& colour : colours) {
    const QImage image = reader.read();
    INFO(reader.errorString().toStdString());
    REQUIRE(image.size() == QSize(96, 64));
    const QColor got = image.pixelColor(50, 50);
    CHECK(std::abs(got.red() - colour.red()) + std::abs(got.green() - colour.green()) +
              std::abs(got.blue() - colour.blue()) <
          12);
    CHECK(reader.nextImageDelay() == 50);
  }
  CHECK(reader.read().isNull());
}

TEST_CASE("gif_writer: shaded metal stays gray beside the colors of a scale", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  QImage image(256, 200, QImage::Format_RGB32);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 256; ++x)
      image.setPixelColor(x, y,
                          y < 100 ? QColor(x * 9 / 10, x * 9 / 10 + y / 20, x * 9 / 10 + y / 10)
                                  : QColor::fromHsv(x * 300 / 256, 100 + y / 2, 60 + y / 2));
  GifWriter writer(folder.filePath("film.gif").toStdString(), image.size(), 20);
  writer.add(image);
  writer.finish();
  const QImage got = QImageReader(folder.filePath("film.gif")).read();
  REQUIRE(got.size() == image.size());
  int worst = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 256; ++x) {
      const QColor a = image.pixelColor(x, y), b = got.pixelColor(x, y);
      worst = std::max({worst, std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
                        std::abs(a.blue() - b.blue())});
    }
  CHECK(worst < 24);  // a fixed cube of colors, dithered, is up to 51 off
}

TEST_CASE("mp4_writer: without ffmpeg the reason is a sentence", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("film.mp4").toStdString();
  if (!has_ffmpeg()) {
    CHECK_THROWS_WITH(Mp4Writer(path, {64, 64}, 25), Catch::Contains("ffmpeg"));
    return;
  }
  Mp4Writer writer(path, {64, 64}, 25);
  for (int i = 0; i < 10; ++i) writer.add(QImage(64, 64, QImage::Format_RGB32));
  writer.finish();
  CHECK(std::filesystem::file_size(path) > 100);
}
