#include "agore/animation.hpp"
#include "agore/motion_picture.hpp"
#include "agore/short_run.hpp"
#include "agore/sketch.hpp"
#include "agore/view_layout.hpp"
#include "support/qt_app.hpp"

#include <QPainter>
#include <QRegularExpression>
#include <catch2/catch.hpp>

#include <cmath>

/// Paths of bodies through sparse frames: a line means that the path is known.
using namespace adore;
using namespace adore::agore;
using test::pixels_of;

namespace {

constexpr QSize kSize(900, 700);

/// Every `stride`-th frame of a run of three revolutions in 1500 frames.
Animation thinned(std::size_t stride) {
  results::Sol8File all = test::synthetic_sol8(), few = all;
  few.frames.clear();
  for (std::size_t i = 0; i < all.frames.size(); i += stride) few.frames.push_back(all.frames[i]);
  return prepare(few);
}

/// Places of the bodies in a single picture.
struct Seen {
  Seen(const Animation& animation, const ViewOptions& options)
      : area(MotionPicture::pictureAreas(QRectF({0, 0}, kSize), 1).front()),
        foot(legend_height_below(animation, options, area.size())),
        nothing(1, 1, QImage::Format_RGB32),
        painter(&nothing),
        sketch(painter, area,
               picture_radius(animation, options, QSizeF(area.width(), area.height() - foot)),
               theme_of(options), {0.0, 0.0}, foot) {}
  QRectF area;
  double foot;
  QImage nothing;
  QPainter painter;
  Sketch sketch;
};

/// Is a pixel about this place of the color?
bool coloured(const QImage& image, QPointF at, const QColor& colour) {
  return pixels_of(image, QRect(at.toPoint() - QPoint(1, 1), QSize(3, 3)), colour) > 0;
}

}  // namespace

TEST_CASE("paths: frames are marked, lines only where the path between frames is known",
          "[gui][ways]") {
  test::use_qt();
  for (const std::size_t stride : {5U, 20U, 47U, 50U, 60U, 90U, 120U}) {
    const Animation animation = thinned(stride);
    // 0.43 of a shaft that turns once in 500 frames.
    const double turn = 0.43 * static_cast<double>(stride) / 499.7;
    const bool known = turn < kKnownTurn && static_cast<double>(stride) / 499.7 < 0.25;
    MotionPicture picture(animation);
    ViewOptions options;
    options.view = View::Element;
    const std::size_t now = animation.frames() - 1;
    const QImage image = picture.image(kSize, now, options);
    const Seen seen(animation, options);
    const auto place = [&](std::size_t back) {
      const auto& e = animation.frame(now - back).elements.front();
      return seen.sketch.around({0, 0}, e.r, e.theta);
    };
    const QColor colour = theme_of(options).curves[3];
    int marks = 0, chords = 0, looks = 0;
    // Beyond the element itself, within half a turn; short steps are a line of marks.
    for (std::size_t back = 2; static_cast<double>(back) * turn < 0.45; ++back) {
      const QPointF from = place(back), to = place(back + 1);
      if (std::hypot(from.x() - to.x(), from.y() - to.y()) < 13.0) continue;
      ++looks;
      marks += coloured(image, from, colour);
      chords += coloured(image, 0.5 * (from + to), colour);
    }
    const QString key = QString::fromUtf8(picture.svg(kSize, now, options));
    INFO("every " << stride << ": " << turn << " turns; " << marks << " marks and " << chords
                  << " chords of " << looks);
    CHECK(key.contains(">element path<") == known);
    CHECK(key.contains("path unknown") == !known);
    if (stride < 20) continue;
    REQUIRE(looks > 0);
    CHECK(marks == looks);
    CHECK(chords == (known ? looks : 0));
  }
}

TEST_CASE("paths: sparse orbits of centers are drawn as frames, with a key entry", "[gui][ways]") {
  test::use_qt();
  ViewOptions options;
  options.view = View::Cage;
  for (const std::size_t stride : {20U, 60U, 125U}) {
    const Animation animation = thinned(stride);
    const bool known = static_cast<double>(stride) / 499.7 < kKnownTurn;
    MotionPicture picture(animation);
    const std::size_t last = animation.frames() - 1;
    const QImage image = picture.image(kSize, last, options);
    const Seen seen(animation, options);
    // The orbit is drawn so that the clearance, or what is farther, has 0.42 of the cage's bore.
    const auto centre = [&](std::size_t i) {
      const auto& p = animation.frame(i).cage.position;
      return QPointF(p[1], p[2]);
    };
    double largest = animation.guide_clearance;
    for (std::size_t i = 0; i <= last; ++i)
      largest = std::max(largest, std::hypot(centre(i).x(), centre(i).y()));
    const double enlarged = 0.42 * animation.file.geometry.cage_inner_radius / largest;
    const auto place = [&](std::size_t i) {
      return seen.sketch.at(centre(i).x() * enlarged, centre(i).y() * enlarged);
    };
    int marks = 0, chords = 0, looks = 0;
    for (std::size_t i = 1; i + 1 < last; ++i) {
      const QPointF from = place(i), to = place(i + 1);
      if (std::hypot(from.x() - to.x(), from.y() - to.y()) < 6.0) continue;
      ++looks;
      marks += coloured(image, from, theme_of(options).curves[0]);
      chords += coloured(image, 0.5 * (from + to), theme_of(options).curves[0]);
    }
    INFO("every " << stride << ": " << marks << " marks and " << chords << " chords of " << looks);
    REQUIRE(looks > 5);
    CHECK(marks > looks * 3 / 4);  // other pixels are below the axes of the cage
    CHECK((known ? chords > looks * 3 / 4 : chords < looks / 3));
    const QString key = QString::fromUtf8(picture.svg(kSize, last, options));
    CHECK(key.contains("center at each frame, path unknown") == !known);
    options.view = View::InnerRace;
    CHECK(QString::fromUtf8(picture.svg(kSize, last, options)).contains("path unknown") == !known);
    options.view = View::Cage;
  }
}

TEST_CASE("ways: paths beside each other are not told from steps that pass the neighbor's place",
          "[gui][ways]") {
  test::use_qt();
  ViewOptions options;
  options.trails = true;
  for (const std::size_t stride : {4U, 40U, 100U}) {
    const Animation animation = thinned(stride);
    // Twelve elements are 30 degrees apart; half of that is the most.
    const bool known = 0.43 * 360.0 * static_cast<double>(stride) / 499.7 < 15.0;
    MotionPicture picture(animation);
    const QString key = QString::fromUtf8(picture.svg(kSize, animation.frames() - 1, options));
    INFO(stride);
    CHECK(key.contains("element paths") == known);
    CHECK(key.contains(QRegularExpression("path unknown|unknown paths")) == !known);
  }
}

TEST_CASE("ways: values of few frames are marked in the curves", "[gui][ways]") {
  test::use_qt();
  ViewOptions options;
  options.view = View::Pocket;
  const auto marks = [&](std::size_t stride) {
    MotionPicture picture(thinned(stride));
    const QByteArray svg = picture.svg(kSize, 0, options);
    return svg.count(QByteArray("fill=\"") + theme_of(options).curves[0].name().toUtf8());
  };
  CHECK(marks(1) == 0);
  CHECK(marks(60) >= 25);
}
