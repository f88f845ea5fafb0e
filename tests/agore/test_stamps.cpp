#include "agore/depth_canvas.hpp"
#include "agore/motion_picture.hpp"
#include "agore/stamps.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QPainter>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using namespace adore::agore;

namespace {

QImage paper() {
  QImage out(300, 300, QImage::Format_RGB32);
  out.fill(Qt::white);
  return out;
}

/// Place and amount of the ink of a picture.
struct Ink {
  QPointF middle{0.0, 0.0};
  double amount = 0.0;
};
Ink ink_of(const QImage& image) {
  Ink out;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const double ink = 255.0 - qGreen(image.pixel(x, y));
      out.amount += ink;
      out.middle += ink * QPointF(x + 0.5, y + 0.5);
    }
  if (out.amount > 0.0) out.middle /= out.amount;
  return out;
}

void disc(QPainter& p, QPointF middle, double radius) {
  p.setPen(Qt::NoPen);
  p.setBrush(QColor(20, 40, 90));
  p.drawEllipse(middle, radius, radius);
}

}  // namespace

TEST_CASE("stamps: what is kept is drawn where it belongs, with all of its ink", "[unit][agore]") {
  for (const double radius : {9.0, 100.0}) {
    SpriteCache stamps;
    const double off = radius < 64.0 ? 0.125 : 0.25;  // each way
    for (int i = 0; i < 60; ++i) {
      const QPointF where(150.0 + 1.37 * std::sin(7.0 * i), 150.0 + 1.71 * std::cos(5.0 * i));
      QImage kept = paper(), drawn = paper();
      QPainter on_kept(&kept), on_drawn(&drawn);
      on_drawn.setRenderHint(QPainter::Antialiasing);
      stamps.draw(on_kept, where, radius, {1, {radius}, {}},
                  [&](QPainter& p, QPointF middle) { disc(p, middle, radius); });
      disc(on_drawn, where, radius);
      on_kept.end(), on_drawn.end();
      const Ink is = ink_of(kept), wanted = ink_of(drawn);
      CAPTURE(radius, where.x(), where.y());
      CHECK(std::abs(is.middle.x() - where.x()) <= off + 0.01);
      CHECK(std::abs(is.middle.y() - where.y()) <= off + 0.01);
      CHECK(is.amount == Approx(wanted.amount).epsilon(2e-3));
    }
    CHECK(stamps.size() <= (radius < 64.0 ? 16U : 4U));
    CHECK(stamps.size() > 2);
  }
}

TEST_CASE("stamps: different looks are distinguished; large ones are drawn, not cached",
          "[unit][agore]") {
  SpriteCache stamps;
  const auto ink = [&](double radius, double reach, SpriteCache::DrawingAppearance look) {
    QImage image = paper();
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    stamps.draw(painter, {150, 150}, reach, look,
                [&](QPainter& p, QPointF middle) { disc(p, middle, radius); });
    painter.end();
    return ink_of(image).amount;
  };
  const double small = ink(10, 12, {1, {10}, {}}), large = ink(20, 22, {1, {20}, {}});
  CHECK(large == Approx(4.0 * small).epsilon(0.01));
  CHECK(ink(20, 22, {2, {10}, {}}) == Approx(large));
  CHECK(ink(20, 22, {1, {10}, {qRgb(1, 2, 3)}}) == Approx(large));
  CHECK(stamps.size() == 4);
  CHECK(ink(20, 5000, {3, {20}, {}}) == Approx(large));
  CHECK(stamps.size() == 4);
}

TEST_CASE("stamps: cache size is limited, last drawn pictures are kept", "[unit][agore]") {
  constexpr double kOne = 4.0 * 27.0 * 27.0;  // bytes of a reach of 12
  SpriteCache stamps(8.5 * kOne);
  QImage image = paper();
  QPainter painter(&image);
  int drawn = 0;
  const auto draw = [&](double size) {
    const int before = drawn;
    stamps.draw(painter, {150, 150}, 12, {1, {size}, {}}, [&](QPainter& p, QPointF middle) {
      ++drawn;
      disc(p, middle, 10);
    });
    return drawn > before;  // it was not there
  };
  for (int i = 0; i < 100; ++i) {
    draw(i);
    CHECK(stamps.bytes() <= 8.5 * kOne);
    CHECK_FALSE(draw(i));
    if (i > 0) CHECK_FALSE(draw(0));  // drawn every time, while all others come and go
  }
  CHECK(stamps.size() >= 5);
  CHECK(draw(50));
}

TEST_CASE("stamps: all views of a window keep theirs in one room", "[gui][agore][slow]") {
  test::use_qt();
  test::SyntheticRun run;
  run.steps = 6;
  MotionPicture picture(prepare(test::synthetic_sol8(run)));
  ViewOptions options;
  options.beside = {{View::Cage}, {View::Element}, {View::InnerRace}};
  QImage screen(1920, 1080, QImage::Format_RGB32);
  screen.setDevicePixelRatio(2.0);
  double most = 0.0;
  for (int i = 0; i < 90; ++i) {  // separate images for every zoom
    options.zoom = 1.0 + 0.02 * i;
    for (AdditionalView& side : options.beside) side.zoom = options.zoom;
    QPainter painter(&screen);
    picture.paint(painter, QRectF(0, 0, 960, 540), static_cast<std::size_t>(i % 6), options);
    most = std::max(most, picture.cachedImageBytes());
    REQUIRE(picture.cachedImageBytes() <= SpriteCache::kRoom);
  }
  CHECK(most > 0.7 * SpriteCache::kRoom);  // it was full
}

TEST_CASE("depth_canvas: restored → everything drawn since is removed", "[unit][agore]") {
  const Shades red = shades_of(QColor(200, 0, 0)), blue = shades_of(QColor(0, 0, 200));
  DepthCanvas still;
  still.reset({80, 60}, qRgb(255, 255, 255));
  still.triangle({10, 10, 0, 190}, {40, 12, 0, 190}, {20, 40, 0, 190}, red);
  DepthCanvas canvas;
  for (int turn = 0; turn < 3; ++turn) {
    canvas.restore(still);
    CHECK(canvas.image(1) == still.image(1));
    CHECK(canvas.drawn() == still.drawn());
    // Behind an object, in front of it, next to it, and beyond the edges.
    canvas.triangle({0, 0, -5, 190}, {90, 0, -5, 190}, {0, 70, -5, 190}, blue);
    canvas.sphere({20.0F + 20.0F * static_cast<float>(turn), 30, 9, 0}, 12.0F, {}, blue, blue);
    canvas.sphere({-3, 58, 9, 0}, 12.0F, {}, red, red);
    CHECK(canvas.image(1) != still.image(1));
    // A part of the picture is that part.
    const QRect box(7, 5, 30, 20);
    CHECK(canvas.image(1, box) == canvas.image(1).copy(box));
    CHECK(canvas.image(2, QRect(3, 2, 10, 9)) == canvas.image(2).copy(3, 2, 10, 9));
    // Nothing is drawn outside of drawn().
    const QImage all = canvas.image(1);
    for (int y = 0; y < all.height(); ++y)
      for (int x = 0; x < all.width(); ++x)
        if (!canvas.drawn().contains(x, y)) CHECK(all.pixel(x, y) == qRgb(255, 255, 255));
  }
}
