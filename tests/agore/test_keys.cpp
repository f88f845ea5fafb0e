#include "agore/example_run.hpp"
#include "agore/kept.hpp"
#include "agore/motion_picture.hpp"
#include "agore/picture_words.hpp"
#include "support/qt_app.hpp"

#include <QImage>
#include <QPainter>
#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

/// Keys of the pictures of every type of bearing, in small windows and large ones.
using namespace adore;
using namespace adore::agore;

namespace {

constexpr std::array<View, 9> kViews{View::Bearing, View::Cage,      View::Pocket,
                                     View::Element, View::OuterRace, View::InnerRace,
                                     View::Flange,  View::Section,   View::Solid};

/// Those that a run has, the flange view at a race that has one.
std::vector<View> views_of(const Animation& animation, ViewOptions& options) {
  std::vector<View> out;
  for (const View view : kViews)
    if (why_not(view, animation).empty()) out.push_back(view);
  if (!has_flange(animation, options.flange_race, 0) &&
      !has_flange(animation, options.flange_race, 1))
    options.flange_race = 1 - options.flange_race;
  return out;
}

/// Entries that the key of one picture needs at its size.
std::vector<PictureLegendEntry> entries_of(const Animation& animation, std::size_t frame,
                                           const ViewOptions& options, std::size_t tile,
                                           QSizeF size) {
  const std::size_t count = 1 + options.beside.size();
  QSizeF own = MotionPicture::pictureAreas(QRectF({0, 0}, size), count).at(tile).size();
  if (count > 1) own -= QSizeF(8.0, own.height() < 200.0 ? 22.0 : 30.0);
  QImage image(own.toSize(), QImage::Format_RGB32);
  QPainter painter(&image);
  ViewCache kept;
  paint_picture(painter, QRectF({0, 0}, own), animation, frame, options.tile(tile), &kept);
  std::vector<PictureLegendEntry> out = kept.key.entries();
  // Of several small pictures: objects without space for their name.
  for (const PictureLegendEntry& entry : kept.key.omittedEntries())
    if (entry.colour.isValid()) out.push_back(entry);
  return out;
}

}  // namespace

TEST_CASE("warned bodies: warnings name elements, cage and races, notes do not", "[unit][agore]") {
  const auto of = [](Severity severity, const char* body) {
    Finding out;
    out.severity = severity;
    out.body = body;
    return out;
  };
  const WarnedBodies warned = warned_bodies(
      std::vector{of(Severity::Warning, "ball 3, inner race"), of(Severity::Note, "ball 4"),
                  of(Severity::Warning, "cage, in the pocket of element 5"),
                  of(Severity::Error, "outer race")});
  CHECK(warned == WarnedBodies{{3}, true, {true, false}});
  CHECK(warned.names(true) == "ball 3, cage, outer race");
  CHECK(warned_bodies({}).empty());
}

TEST_CASE("bearing view: a body with a warning gets a red ring and a line of the key",
          "[gui][keys]") {
  test::use_qt();
  MotionPicture picture(open_motion(test::example_run("ball") / "RESULTS.h5"));
  const Animation& animation = picture.animation();
  ViewOptions options;
  const auto red = [&](const WarnedBodies& warned) {
    options.warned = warned;
    const QImage image = picture.image({900, 700}, 0, options);
    int count = 0;
    const QRgb colour = desktop::theme(desktop::ThemeKind::Light).red.rgb();
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == colour;
    return count;
  };
  const int none = red({});
  for (const WarnedBodies& warned :
       {WarnedBodies{{2}, false, {}}, WarnedBodies{{}, true, {}},
        WarnedBodies{{}, false, {true, false}}, WarnedBodies{{}, false, {false, true}}}) {
    CAPTURE(warned.names(true));
    CHECK(red(warned) > none + 200);
    const std::vector<PictureLegendEntry> key = entries_of(animation, 0, options, 0, {900, 700});
    CHECK(std::any_of(key.begin(), key.end(), [&](const PictureLegendEntry& entry) {
      return entry.text == QString::fromStdString("warning: " + warned.names(true));
    }));
  }
}

TEST_CASE("keys: every entry stands whole in the picture, however small, beside however many",
          "[gui][keys][slow]") {
  test::use_qt();
  int seen = 0, elsewhere = 0;
  for (const std::string& type : test::kTypes) {
    MotionPicture picture(open_motion(test::example_run(type) / "RESULTS.h5"));
    const Animation& animation = picture.animation();
    const std::size_t frame = animation.frames() - 1;
    ViewOptions options;
    const std::vector<View> views = views_of(animation, options);
    for (const bool marks : {false, true})
      for (const std::size_t tiles : {1U, 2U, 4U})
        for (std::size_t first = 0; first < views.size(); ++first) {
          options.contacts = options.trails = marks;
          options.colour = marks ? ColourBy::Slip : ColourBy::None;
          options.view = views[first];
          options.beside.clear();
          for (std::size_t i = 1; i < tiles; ++i)
            options.beside.push_back({views[(first + i) % views.size()]});
          for (const QSize size : {QSize(700, 450), QSize(1280, 800)}) {
            if (size.width() > 1000 && !marks) continue;  // fewer entries, more room
            const QByteArray svg = picture.svg(size, frame, options);
            const QString words = test::all_words(svg);
            INFO(type << ", " << view_title(options.view) << ", one of " << tiles
                      << (marks ? ", all marks, " : ", ") << size.width());
            for (std::size_t i = 0; i < tiles; ++i)
              for (const PictureLegendEntry& entry :
                   entries_of(animation, frame, options, i, size)) {
                INFO(entry.text.toStdString());
                ++seen;
                if (words.contains(entry.text.simplified())) continue;
                // Four pictures with all marks need more lines than there are.
                CHECK((marks && tiles == 4 && size.width() < 1000));
                CHECK(words.contains("more (see the single view, V)"));
                ++elsewhere;
              }
            for (const QString& fault : test::faults_of(svg, size))
              if (!fault.contains(" lies over ")) FAIL_CHECK(fault.toStdString());
          }
        }
  }
  CHECK(seen > 1000);
  CHECK(elsewhere < seen / 50);
}

TEST_CASE("keys: no words of a picture lie over each other", "[gui][keys][slow]") {
  test::use_qt();
  for (const std::string& type : test::kTypes) {
    MotionPicture picture(open_motion(test::example_run(type) / "RESULTS.h5"));
    ViewOptions options;
    const std::vector<View> views = views_of(picture.animation(), options);
    for (const ColourBy colour : {ColourBy::None, ColourBy::Slip, ColourBy::Temperature})
      for (const View view : views)
        for (const QSize size : {QSize(700, 450), QSize(1280, 800)})
          for (const double part : {0.0, 0.2, 0.45, 0.8, 1.0}) {
            if (size.width() > 1000 && part > 0.0 && part < 0.5) continue;
            options.view = view;
            options.colour = colour;
            options.contacts = options.trails = colour == ColourBy::Slip;
            const auto frame =
                static_cast<std::size_t>(part * static_cast<double>(picture.frames() - 1));
            INFO(type << ", " << view_title(view) << ", colour " << static_cast<int>(colour) << ", "
                      << size.width() << ", frame " << frame + 1);
            const QStringList faults = test::faults_of(picture.svg(size, frame, options), size);
            CHECK(faults.join("; ").toStdString() == "");
          }
  }
}
