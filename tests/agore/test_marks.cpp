#include "agore/example_run.hpp"
#include "agore/made_run.hpp"
#include "agore/motion_picture.hpp"
#include "agore/picture_words.hpp"
#include "agore/solid_view.hpp"
#include "agore/view_scene.hpp"
#include "agore/ways.hpp"
#include "support/qt_app.hpp"

#include <QImage>
#include <QPainter>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

/// Marks over bodies: contrast with the background, and order of drawing.
using namespace adore;
using namespace adore::agore;

namespace {

/// Contrast of two colors after WCAG 2.
double contrast(QRgb a, QRgb b) {
  const auto light = [](QRgb c) {
    const auto one = [](int v) {
      const double s = v / 255.0;
      return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * one(qRed(c)) + 0.7152 * one(qGreen(c)) + 0.0722 * one(qBlue(c)) + 0.05;
  };
  return std::max(light(a), light(b)) / std::min(light(a), light(b));
}

/// Pixels with the color of a mark, and those of them without three times or a third of their
/// luminance within a few pixels: the inside of an area, far from all other colors, remains
/// visible.
struct Seen {
  int all = 0, lost = 0;
};
Seen seen_of(const QImage& image, const QColor& colour) {
  constexpr int kNear = 6, kInside = 3;
  Seen out;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixel(x, y) != colour.rgb()) continue;
      ++out.all;
      bool apart = false, inside = true;
      for (int j = std::max(0, y - kNear); j <= std::min(image.height() - 1, y + kNear); ++j)
        for (int i = std::max(0, x - kNear); i <= std::min(image.width() - 1, x + kNear); ++i) {
          apart = apart || contrast(image.pixel(i, j), colour.rgb()) >= 3.0;
          const bool next = std::max(std::abs(i - x), std::abs(j - y)) <= kInside;
          inside = inside && (!next || image.pixel(i, j) == colour.rgb());
        }
      out.lost += !apart && !inside;
    }
  return out;
}

/// Without the key.
QImage picture_of(const Animation& animation, std::size_t frame, const ViewOptions& options) {
  QImage image(700, 900, QImage::Format_RGB32);
  image.fill(theme_of(options).surface);
  QPainter painter(&image);
  paint_picture(painter, QRectF(0, 0, 700, 900), animation, frame, options);
  painter.end();
  return image.copy(0, 0, 700, 740);
}

}  // namespace

TEST_CASE("marks: contrast of every color to its background is at least 3:1, light and dark",
          "[gui][agore][slow]") {
  test::use_qt();
  for (const std::string& type : test::kTypes) {
    const Animation animation = open_motion(test::example_run(type) / "RESULTS.h5");
    const std::size_t frame = animation.frames() - 1;
    for (const bool dark : {false, true})
      for (const ColourBy colour : {ColourBy::None, ColourBy::Slip})
        for (const View view :
             {View::Bearing, View::Cage, View::Pocket, View::Element, View::OuterRace,
              View::InnerRace, View::Section, View::Flange, View::Solid}) {
          ViewOptions options;
          options.view = view;
          options.dark = dark;
          options.colour = colour;
          options.contacts = options.trails = true;
          choose_flange_race(animation, options);
          if (!why_not(view, animation).empty()) continue;
          const desktop::Theme& t = theme_of(options);
          const QImage image = picture_of(animation, frame, options);
          for (const QColor& mark : {t.red, t.green, t.blue, t.light_blue, t.curves[0], t.curves[1],
                                     t.curves[2], t.curves[3], rotation_mark_color(t)}) {
            const Seen seen = seen_of(image, mark);
            INFO(type << ", " << view_title(view) << (dark ? ", dark, " : ", light, ")
                      << mark.name().toStdString() << ": " << seen.lost << " of " << seen.all);
            CHECK(seen.lost <= seen.all / 50);
          }
        }
  }
}

TEST_CASE("marks: rotation marks have one color, apart from every color of the scale",
          "[unit][agore]") {
  for (const auto kind : {desktop::ThemeKind::Light, desktop::ThemeKind::Dark}) {
    const desktop::Theme& t = desktop::theme(kind);
    for (int i = 0; i <= 100; ++i) {
      const QColor tint = i == 100 ? no_contact_colour() : scale_colour(i / 99.0);
      INFO(tint.name().toStdString());
      CHECK(contrast(rotation_mark_color(t).rgb(), tint.rgb()) >= 3.0);
      CHECK(contrast(solid_rotation_mark_color(t, true).rgb(), tint.rgb()) >= 3.0);
    }
    CHECK(contrast(rotation_mark_color(t).rgb(), t.steel_light.rgb()) >= 3.0);
    CHECK(contrast(solid_rotation_mark_color(t).rgb(), t.steel_light.rgb()) >= 3.0);
  }
}

TEST_CASE("marks: an element without contact has a color of its own, which the key names",
          "[gui][agore][h5]") {
  test::use_qt();
  const testing::TemporaryFolder folder;
  test::write_run(folder);
  Animation animation = open_motion(folder / "RESULTS.h5");
  constexpr std::size_t kFree = 2;
  const std::size_t frame = 12;
  // Nobody else has these values: they are read once, and kept.
  auto& load = const_cast<results::MotionChannel&>(*animation.motion->channel("contact.load"));
  for (const std::size_t at : {2 * kFree, 2 * kFree + 1})
    load.values.at(frame * load.width + at) = 0.0;
  CHECK_FALSE(animation.some_free);
  animation.some_free = loses_contact(load);
  int coloured = 0;
  for (const ColourBy by : {ColourBy::Load, ColourBy::Slip, ColourBy::Heat}) {
    const ElementColors colours = element_colors(animation, frame, by);
    if (!colours.any()) continue;
    ++coloured;
    for (std::size_t k = 0; k < 8; ++k) {
      INFO("ball " << k + 1 << ", by " << static_cast<int>(by));
      CHECK((colours.of(k) == no_contact_colour()) == (k == kFree));
    }
  }
  REQUIRE(coloured >= 2);
  for (int i = 0; i <= 255; ++i) {
    const QColor used = scale_colour(i / 255.0), none = no_contact_colour();
    CHECK(std::abs(used.red() - none.red()) + std::abs(used.green() - none.green()) +
              std::abs(used.blue() - none.blue()) >
          100);
  }
  MotionPicture picture(std::move(animation));
  ViewOptions options;
  options.colour = ColourBy::Slip;
  for (const View view : {View::Bearing, View::Solid}) {
    options.view = view;
    CHECK(picture.svg({1280, 800}, frame, options).contains("no contact<"));
    options.beside = {{View::Section}, {View::Pocket}, {View::Cage}};
    CHECK(picture.svg({700, 450}, frame, options).contains("no contact<"));
    options.beside.clear();
    // If all elements are in contact there is no other entry; a run that never loses a contact has
    // none.
    const QByteArray before = picture.svg({1280, 800}, frame - 1, options);
    CHECK_FALSE(before.contains("no contact<"));
    CHECK(before.contains("all in contact"));
  }
}

TEST_CASE("marks: a path behind bodies is dashed in 3D, and no load hides a race's spot",
          "[gui][agore]") {
  test::use_qt();
  const Animation animation = open_motion(test::example_run("ball") / "RESULTS.h5");
  MotionPicture picture(animation);
  const std::size_t frame = animation.frames() - 1;
  ViewOptions options;
  options.view = View::Solid;
  options.trails = true;
  CHECK(picture.svg({1280, 800}, frame, options).contains("behind a body"));
  // A bearing without the covering bodies: in front view cage and balls cover half of the drawing,
  // which is complete where nothing covers it.
  const QColor way = theme_of(options).curves[3];
  const auto inked = [&] { return seen_of(picture_of(animation, frame, options), way).all; };
  const int dashed = inked();
  options.view = View::Bearing;
  const int whole = inked();
  CHECK(dashed > 20);
  CHECK(dashed < whole);
  // The spot of the inner race, where it is seen, with all loads around it.
  options.view = View::Solid;
  options.trails = false;
  const QColor spot = theme_of(options).blue;
  for (std::size_t i = 0; i < animation.frames(); i += animation.frames() / 8 + 1) {
    options.contacts = false;
    const int alone = seen_of(picture_of(animation, i, options), spot).all;
    options.contacts = true;
    CHECK(seen_of(picture_of(animation, i, options), spot).all == alone);
  }
}

TEST_CASE("marks: flange penetration → note that it is not drawn", "[gui][agore]") {
  test::use_qt();
  const Animation animation = open_motion(test::example_run("tapered") / "RESULTS.h5");
  MotionPicture picture(animation);
  ViewOptions options;
  options.view = View::Flange;
  choose_flange_race(animation, options);
  int pressed = 0, open = 0;
  for (std::size_t i = 0; i < animation.frames(); i += animation.frames() / 40 + 1)
    for (options.element = 1; options.element <= animation.file.elements; options.element += 4) {
      const QString words = test::all_words(picture.svg({700, 450}, i, options));
      const bool gap = words.contains(", gap ");
      if (words.contains("penetration (not drawn)")) ++pressed;
      open += gap;
      INFO(words.toStdString());
      CHECK(words.contains("gap × ") == gap);
    }
  CHECK(pressed > 0);
}

TEST_CASE("marks: frames too short for letters have a long arm for z, and the key says so",
          "[gui][agore]") {
  test::use_qt();
  MotionPicture picture(open_motion(test::example_run("ball") / "RESULTS.h5"));
  ViewOptions options;
  options.beside = {{View::Solid}, {View::Section}, {View::Pocket}};
  const QByteArray small = picture.svg({700, 450}, 5, options);
  CHECK(small.contains("long arm: z"));
  CHECK(small.contains("cage rotation"));
  CHECK(small.count("guide lands") == 1);
  CHECK_FALSE(small.contains("guide land<"));
  options.beside.clear();
  const QByteArray large = picture.svg({1280, 800}, 5, options);
  CHECK_FALSE(large.contains("long arm"));
  options.view = View::Pocket;
  CHECK(picture.svg({1280, 800}, 5, options).contains("cage rotation"));
}

TEST_CASE("marks: no path hides the mark that turns with an element", "[gui][agore]") {
  test::use_qt();
  for (const char* const type : {"ball", "cylindrical"}) {
    const Animation animation = open_motion(test::example_run(type) / "RESULTS.h5");
    const std::size_t frame = animation.frames() - 1;
    ViewOptions options;
    const QColor mark = rotation_mark_color(theme_of(options));
    const auto inked = [&](bool trails) {
      options.trails = trails;
      QImage image(394, 348, QImage::Format_RGB32);
      image.fill(theme_of(options).surface);
      QPainter painter(&image);
      // Equal size with any key.
      const Sketch sketch(painter, QRectF(0, 0, 394, 348),
                          1.1 * animation.file.geometry.outer_race_inner_radius, theme_of(options));
      ViewCache kept;
      draw_bearing_view(Scene{sketch, animation, frame, animation.frame(frame), 1.0, options,
                              kept.cages, kept.key});
      painter.end();
      return seen_of(image.copy(0, 0, 394, 240), mark).all;
    };
    const int whole = inked(false);
    INFO(type);
    CHECK(whole > 20);
    // Edges of a path that blend with the mark may add some pixels of its color, never take any.
    CHECK(inked(true) >= whole);
    CHECK(inked(true) <= whole + whole / 30);
  }
}

TEST_CASE("marks: rotation mark of a roller is an area, distinct from path edges", "[gui][agore]") {
  test::use_qt();
  Animation animation = open_motion(test::example_run("cylindrical") / "RESULTS.h5");
  const std::size_t frame = animation.frames() - 1;
  const double radius = 1.1 * animation.file.geometry.outer_race_inner_radius;
  constexpr int kSize = 180;  // a bearing with all of its marks and its key at 700x450
  for (const bool dark : {false, true}) {
    ViewOptions options;
    options.dark = dark;
    options.trails = true;
    const desktop::Theme& t = theme_of(options);
    // Of rollers as dark as the scale has them, and of steel, at the size that 700x450 leaves.
    for (const ColourBy colour : {ColourBy::None, ColourBy::Load}) {
      options.colour = colour;
      options.scale = {ColorScaleKind::Typed, 0.0, 1e9};
      const QColor mark = rotation_mark_color(t);
      double pixels = 0.0;  // of a roller's radius
      const auto inked = [&](const Animation& of) {
        QImage image(kSize, kSize, QImage::Format_RGB32);
        image.fill(t.surface);
        QPainter painter(&image);
        const Sketch sketch(painter, QRectF(0, 0, kSize, kSize), radius, t);
        pixels = of.file.geometry.element_radius * sketch.scale();
        ViewCache kept;
        const ViewOptions asked = options;
        const Scene scene{sketch, of, frame, of.frame(frame), 1.0, asked, kept.cages, kept.key};
        draw_elements(scene);
        for (std::size_t k = 0; k < scene.frame.elements.size(); ++k) {
          const QPointF at = element_centre(scene, k), across(-at.y(), at.x());
          const QPointF way =
              0.8 * of.file.geometry.element_radius / std::hypot(at.x(), at.y()) * across;
          const QPointF from = at - way, to = at + way;
          draw_trajectory(painter, sketch.area(),
                          {{sketch.at(from.x(), from.y()), false, false},
                           {sketch.at(to.x(), to.y()), true, false}},
                          {trail_colour(scene), 2.0, t.surface});
        }
        draw_rotation_marks(scene);
        painter.end();
        // Of 3x3 pixels in the mark's color: lines and edges of lines have none.
        int out = 0;
        const auto is = [&](int x, int y) {
          const QColor c = image.pixelColor(x, y);
          return std::abs(c.red() - mark.red()) + std::abs(c.green() - mark.green()) +
                     std::abs(c.blue() - mark.blue()) <
                 30;
        };
        for (int y = 1; y < kSize - 1; ++y)
          for (int x = 1; x < kSize - 1; ++x) {
            bool solid = true;
            for (int dy = -1; dy <= 1; ++dy)
              for (int dx = -1; dx <= 1; ++dx) solid = solid && is(x + dx, y + dy);
            out += solid;
          }
        return out;
      };
      Animation unmarked = animation;
      for (auto& element : unmarked.file.frames[frame].elements) element.angles = {};
      const int with = inked(animation), without = inked(unmarked);
      const auto rollers = static_cast<double>(animation.file.elements);
      INFO((dark ? "dark" : "light")
           << ", radius " << pixels << ": " << with << " and " << without);
      CHECK(pixels < 14.0);
      CHECK(without == 0);
      CHECK(with > 0.02 * rollers * kPi * pixels * pixels);
    }
  }
}

TEST_CASE("marks: in space a roller's mark is a field, not a sliver", "[gui][agore]") {
  test::use_qt();
  for (const char* const type : {"tapered", "cylindrical"}) {
    const Animation animation = open_motion(test::example_run(type) / "RESULTS.h5");
    const std::size_t frame = animation.frames() - 1;
    ViewOptions options;
    options.view = View::Solid;
    options.yaw = 0.0, options.elevation = 0.0;  // on their ends
    const QImage image = picture_of(animation, frame, options);
    const QColor ink = solid_rotation_mark_color(theme_of(options));
    int painted = 0;  // with light and shade
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        painted +=
            c.hsvSaturationF() > 0.5 * ink.hsvSaturationF() && std::abs(c.hue() - ink.hue()) < 30;
      }
    INFO(type << ": " << painted << " pixels for " << animation.file.elements << " rollers");
    CHECK(painted > 100 * animation.file.elements);
  }
}

TEST_CASE("marks: loads behind bodies → dashed in 3D, explained in the key", "[gui][agore]") {
  test::use_qt();
  const Animation animation = open_motion(test::example_run("cylindrical") / "RESULTS.h5");
  MotionPicture picture(animation);
  const std::size_t frame = animation.frames() - 1;
  ViewOptions options;
  options.view = View::Solid;
  options.contacts = true;
  const QColor outer = theme_of(options).curves[0];
  const auto look = [&](double yaw) {
    options.yaw = yaw;
    return std::pair{seen_of(picture_of(animation, frame, options), outer).all,
                     picture.svg({1280, 800}, frame, options).contains("dashed: behind a body")};
  };
  // From the side of the loaded rollers, where the outer race is cut open, and from behind them.
  options.elevation = 70.0;
  const int before = look(20.0).first;
  options.elevation = -70.0;
  const auto [behind, behind_said] = look(20.0);
  CHECK(before > 2 * behind);
  CHECK(behind_said);
  CHECK(before > 100);
}

TEST_CASE("marks: every loaded element has an arrow, or a stub of an arrow in small pictures",
          "[gui][agore]") {
  test::use_qt();
  for (const char* type : {"ball", "spherical"}) {
    const Animation animation = open_motion(test::example_run(type) / "RESULTS.h5");
    const std::size_t frame = animation.frames() - 1;
    const auto& contacts = *animation.contacts_at(frame);
    MotionPicture picture(animation);
    ViewOptions options;
    options.contacts = true;
    for (const QSize size : {QSize(700, 450), QSize(1280, 800)})
      for (const std::size_t race : {0U, 1U}) {
        int carry = 0;
        for (const auto& contact : contacts)
          carry += contact.load[race] >= 0.011 * animation.contacts->largest_load ? 1 : 0;
        REQUIRE(carry > 2);
        const QImage image = picture.image(size, frame, options);
        const QColor ink = desktop::theme(desktop::ThemeKind::Light).curves[race];
        const QRect area =
            MotionPicture::pictureAreas(QRectF(QPointF(0, 0), QSizeF(size)), 1).front().toRect();
        // Pieces of the color that hang together: the arrows, and one in the key.
        std::set<std::pair<int, int>> left;
        for (int y = area.top(); y < area.bottom(); ++y)
          for (int x = area.left(); x < area.right(); ++x) {
            const QColor c = image.pixelColor(x, y);
            if (std::abs(c.red() - ink.red()) + std::abs(c.green() - ink.green()) +
                    std::abs(c.blue() - ink.blue()) <
                40)
              left.emplace(x, y);
          }
        int pieces = 0;
        while (!left.empty()) {
          ++pieces;
          std::vector<std::pair<int, int>> next{*left.begin()};
          left.erase(left.begin());
          while (!next.empty()) {
            const auto [x, y] = next.back();
            next.pop_back();
            for (int dx = -2; dx <= 2; ++dx)
              for (int dy = -2; dy <= 2; ++dy)
                if (const auto found = left.find({x + dx, y + dy}); found != left.end()) {
                  next.push_back(*found);
                  left.erase(found);
                }
          }
        }
        INFO(type << ", " << size.width() << " pixels, race " << race << ": " << carry << " carry");
        CHECK(pieces >= carry + 1);
      }
  }
}
