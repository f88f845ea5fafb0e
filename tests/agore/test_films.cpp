#include "agore/render.hpp"
#include "agore/short_run.hpp"
#include "agore/view_options.hpp"
#include "agore/view_scene.hpp"
#include "base/errors.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QFile>
#include <QPainter>
#include <QPrinter>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace adore;
using namespace adore::agore;
using test::short_run;

TEST_CASE("render: pictures, numbered pictures and a film", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::write_text(base / "SOL8", test::sol8_text(test::synthetic_sol8(short_run(30))));
  MotionPicture picture = open_animation(base / "SOL8");
  RenderOptions options;
  options.width = 640, options.height = 400;
  const auto written = render_frames(picture, 10, base / "frames", options);
  REQUIRE(written.size() == 3);
  CHECK(written[1].filename() == "SOL8-frame-00011.png");
  CHECK(QImage(QString::fromStdString(written[2].string())).size() == QSize(640, 400));
  CHECK_THROWS_WITH(render_frame(picture, 31, base / "x.png", options), Catch::Contains("1 to 30"));
  render_movie(picture, 3, 25, base / "films" / "run.avi", options);
  CHECK(std::filesystem::file_size(base / "films" / "run.avi") > 10 * 5000);
  CHECK_THROWS_AS(render_movie(picture, 1, 25, base / "run.mkv", options), InputError);
  render_movie(picture, 15, 25, base / "run.gif", options);
  CHECK(QImage(QString::fromStdString((base / "run.gif").string())).size() == QSize(640, 400));
  render_movie(picture, 15, 25, base / "stills", options);
  CHECK(std::filesystem::exists(base / "stills" / "SOL8-frame-00016.png"));
}

TEST_CASE("render: a film in slow motion shows the frames at their own times", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  auto file = test::synthetic_sol8(short_run(8));
  for (std::size_t i = 0; i < file.frames.size(); ++i)  // 0, 1, 4, 9, ... 49 us
    file.frames[i].time = 1e-6 * static_cast<double>(i * i);
  MotionPicture picture(prepare(file));
  RenderOptions options;
  options.width = 320, options.height = 240;
  options.slow = 7e-6 * 25.0;  // 7 us a picture: 0, 7, 14, 21, 28, 35, 42 us and the end
  render_movie(picture, 1, 25, base / "stills", options);
  const std::size_t shown[] = {0, 2, 3, 4, 5, 5, 6, 7};
  const std::string stem = picture.animation().file.path.filename().string();
  int number = 0;
  for (const std::size_t frame : shown) {
    const auto path = base / "stills" / fmt::format("{}-picture-{:05}.png", stem, ++number);
    INFO(path.string() << " is frame " << frame);
    const QImage image(QString::fromStdString(path.string()));
    REQUIRE_FALSE(image.isNull());
    CHECK(image.convertToFormat(QImage::Format_RGB32) ==
          picture.image({320, 240}, frame, options.view).convertToFormat(QImage::Format_RGB32));
  }
  CHECK_FALSE(std::filesystem::exists(base / "stills" /
                                      fmt::format("{}-picture-{:05}.png", stem, number + 1)));
  options.slow = 1e-30;
  CHECK_THROWS_WITH(render_movie(picture, 1, 25, base / "film.gif", options),
                    Catch::Contains("larger slow-motion value (--slow)"));
}

TEST_CASE("render: movies and numbered pictures → first and last frame as specified", "[gui]") {
  test::use_qt();
  auto file = test::synthetic_sol8(short_run(8));
  for (std::size_t i = 0; i < file.frames.size(); ++i)  // 0, 1, 4, 9, ... 49 us
    file.frames[i].time = 1e-6 * static_cast<double>(i * i);
  const MotionPicture picture(prepare(file));
  const auto frames = [&](int first, int last, int every, double slow) {
    RenderOptions options;
    options.first = first, options.last = last, options.slow = slow;
    return movie_frames(picture, every, 25, options);
  };
  using Frames = std::vector<std::size_t>;
  CHECK(frames(1, 0, 3, 0.0) == Frames{0, 3, 6});
  CHECK(frames(3, 7, 2, 0.0) == Frames{2, 4, 6});
  CHECK(frames(3, 3, 1, 0.0) == Frames{2});
  // 7 us a picture from 4 us on: 4, 11, 18 and the end at 25 us.
  CHECK(frames(3, 6, 1, 7e-6 * 25.0) == Frames{2, 3, 4, 5});
  CHECK_THROWS_WITH(frames(3, 9, 1, 0.0),
                    Catch::Contains("no frame 9") && Catch::Contains("1 to 8"));
  CHECK_THROWS_WITH(frames(-1, 4, 1, 0.0), Catch::Contains("no frame -1"));
  CHECK_THROWS_WITH(frames(5, 4, 1, 0.0), Catch::Contains("frame (5) is after the last frame (4)"));
}

TEST_CASE("render: numbered pictures stop on request", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  MotionPicture picture(prepare(test::synthetic_sol8(short_run(30))));
  RenderOptions options;
  options.width = 320, options.height = 240;
  long drawn = 0;
  options.progress = [&](long done, long total) {
    drawn = done;
    CHECK(total == 30);
  };
  options.stop = [&] { return drawn == 3; };
  CHECK(render_frames(picture, 1, base / "stills", options).size() == 3);
  render_movie(picture, 1, 25, base / "film.gif", options);
  CHECK_FALSE(std::filesystem::exists(base / "film.gif"));
}

TEST_CASE("motion_picture: SVG and paper hold lines and text, inside the zoomed picture's frame",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  MotionPicture picture(prepare(test::synthetic_sol8(short_run(30))));
  for (const View view : {View::Bearing, View::Cage, View::Pocket, View::Element, View::InnerRace})
    for (const double zoom : {1.0, 4.0}) {
      ViewOptions options;
      options.view = view;
      options.zoom = zoom;
      INFO(view_title(view) << ", zoom " << zoom);
      const QByteArray svg = picture.svg({900, 600}, 2, options);
      QXmlStreamReader xml(svg);
      int paths = 0, images = 0;
      QString words;
      QStringList clips, clipped;
      while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        paths += xml.name() == QLatin1String("path");
        images += xml.name() == QLatin1String("image");
        if (xml.name() == QLatin1String("clipPath"))
          clips << xml.attributes().value("id").toString();
        if (xml.attributes().hasAttribute("clip-path"))
          clipped << xml.attributes().value("clip-path").toString();
        if (xml.name() == QLatin1String("text")) words += xml.readElementText() + "|";
      }
      CHECK_FALSE(xml.hasError());
      CHECK(paths > 30);
      CHECK(images == 0);
      CHECK(words.contains("frame 3 of 30|"));
      CHECK(words.contains(QString::fromStdString(view_title(view)) + "|"));
      for (const QString& use : clipped) CHECK(clips.contains(use.mid(5).chopped(1)));
      if (zoom > 1.0) CHECK(clipped.size() > 5);  // the picture's bodies stay in its frame
    }
  QPrinter printer;
  printer.setOutputFormat(QPrinter::PdfFormat);
  printer.setOutputFileName(folder.filePath("page.pdf"));
  {
    QPainter painter(&printer);
    picture.paintOnPaper(painter, painter.viewport(), {900, 600}, 2, {});
  }
  QFile file(folder.filePath("page.pdf"));
  REQUIRE(file.open(QIODevice::ReadOnly));
  const QByteArray bytes = file.readAll();
  CHECK(bytes.startsWith("%PDF"));
  CHECK(bytes.count("/Type /Page\n") == 1);
  CHECK(bytes.contains("/Type /Font"));
  CHECK_FALSE(bytes.contains("/Subtype /Image"));
}
