#include "agore/cage_outlines.hpp"
#include "agore/depth_canvas.hpp"
#include "support/synthetic_results.hpp"

#include <QImage>
#include <QPainter>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace adore;
using namespace adore::agore;

namespace {

double area_of(const QPolygonF& line) {
  double twice = 0.0;
  for (qsizetype i = 0; i < line.size(); ++i) {
    const QPointF p = line[i], q = line[(i + 1) % line.size()];
    twice += p.x() * q.y() - q.x() * p.y();
  }
  return 0.5 * std::abs(twice);
}

double length_of(const QPolygonF& line) {
  double out = 0.0;
  for (qsizetype i = 1; i < line.size(); ++i)
    out += std::hypot(line[i].x() - line[i - 1].x(), line[i].y() - line[i - 1].y());
  return out;
}

qsizetype points_of(const CageOutlines::Outline& outline) {
  qsizetype out = 0;
  for (const QPolygonF& piece : outline.pieces) out += piece.size();
  return out;
}

Animation forty() {
  test::SyntheticRun run;
  run.steps = 5, run.balls = 40, run.ball_radius = 0.0022;
  return prepare(test::synthetic_sol8(run));
}

}  // namespace

TEST_CASE("cage outlines: a thinned line stays within its tolerance, corners stay where they are",
          "[unit][agore]") {
  QPolygonF line;
  constexpr int kPoints = 4000;
  constexpr double kRadius = 40.0;
  for (int i = 0; i <= kPoints; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kPoints;
    line.append(kRadius * QPointF(std::cos(a), std::sin(a)));
  }
  for (const double tolerance : {0.01, 0.1, 1.0}) {
    const QPolygonF few = thinned(line, tolerance);
    // A chord of the circle that leaves it by the tolerance spans 2 acos(1 - t / r).
    const double least = std::numbers::pi / std::acos(1.0 - tolerance / kRadius);
    CAPTURE(tolerance, few.size(), least);
    CHECK(few.size() >= least);
    CHECK(few.size() <= 3.0 * least + 4.0);
    for (qsizetype i = 1; i < few.size(); ++i) {
      const QPointF middle = 0.5 * (few[i - 1] + few[i]);
      CHECK(kRadius - std::hypot(middle.x(), middle.y()) <= tolerance * 1.001);
    }
  }
  const QPolygonF square{{0, 0}, {3, 0}, {10, 0}, {10, 4}, {10, 10}, {0, 10}, {0, 5}, {0, 0}};
  CHECK(thinned(square, 0.01) == QPolygonF({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}));
  CHECK(thinned({{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}}, 0.1).size() <= 5);
}

TEST_CASE("cage outlines: forty bars have as many points as their size in the picture asks for",
          "[unit][agore]") {
  const Animation animation = forty();
  const double pocket = 0.0022 + 0.5 * 300e-6;
  CageOutlines cages;
  const CageOutlines::Outline large = cages.of(animation, pocket, 0, 1e5);
  const CageOutlines::Outline shown = cages.of(animation, pocket, 0, 430.0);
  const CageOutlines::Outline tile = cages.of(animation, pocket, 0, 80.0);
  REQUIRE(large.pieces.size() == 40);  // the pockets part the cage into bars
  CHECK_FALSE(large.nested);
  CHECK(points_of(shown) < points_of(large) / 3);
  CHECK(points_of(tile) < points_of(shown));
  CHECK(points_of(shown) < 40 * 60);
  for (std::size_t i = 0; i < large.pieces.size(); ++i) {
    // Omitted points are within the tolerance of the line.
    const double most = CageOutlines::kTolerance * CageOutlines::kRadius / 430.0;
    CHECK(std::abs(area_of(shown.pieces[i]) - area_of(large.pieces[i])) <
          most * length_of(large.pieces[i]));
  }
  // Larger again: no point is lost for good.
  CHECK(points_of(cages.of(animation, pocket, 0, 1e5)) == points_of(large));
  // Pockets within the rims of the cage: holes of one body.
  CHECK(cages.of(animation, 0.0005, 0, 430.0).nested);
}

TEST_CASE("depth_canvas: a closed body looks the same without what is turned away",
          "[unit][agore]") {
  const Shades shades = shades_of(QColor(120, 140, 90));
  // A cube, turned.
  const auto corner = [](int i, float light) {
    const double x = (i & 1) != 0 ? 15 : -15, y = (i & 2) != 0 ? 15 : -15,
                 z = (i & 4) != 0 ? 15 : -15;
    const double a = 0.6, b = 0.4;
    const double u = x * std::cos(a) + z * std::sin(a), w = z * std::cos(a) - x * std::sin(a);
    return DepthCanvas::Point{static_cast<float>(30 + u),
                              static_cast<float>(30 - y * std::cos(b) - w * std::sin(b)),
                              static_cast<float>(w * std::cos(b) - y * std::sin(b)), light};
  };
  // Seen from outside each has its corners clockwise.
  constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  DepthCanvas all, front, back;
  for (DepthCanvas* canvas : {&all, &front, &back}) canvas->reset({60, 60}, qRgb(255, 255, 255));
  float light = 40.0F;  // of each face its own
  for (const auto& f : kFaces) {
    light += 30.0F;
    const auto p = [&](int i) { return corner(f[i], light); };
    all.quad(p(0), p(1), p(2), p(3), shades);
    front.front_quad(p(3), p(2), p(1), p(0), shades);
    back.front_quad(p(0), p(1), p(2), p(3), shades);
  }
  CHECK(all.image(1) == front.image(1));
  CHECK(all.image(1) != back.image(1));
}

TEST_CASE("cage outlines: segments leave no part of the ring but their gaps", "[unit][agore]") {
  for (const int count : {2, 3, 4, 6}) {
    Animation animation = prepare(test::synthetic_sol8());
    const auto n = animation.pocket_angle.size();
    animation.segments = count;
    for (std::size_t k = 0; k < n; ++k)
      animation.pocket_part[k] = static_cast<int>(k) * count / static_cast<int>(n);
    double all = 0.0;
    for (int part = 0; part < count; ++part) {
      const auto [begin, end] = segment_sector(animation, part);
      const auto next = segment_sector(animation, (part + 1) % count);
      all += end - begin;
      const double gap = std::remainder(next.begin - end, 2.0 * std::numbers::pi);
      CAPTURE(count, part);
      CHECK(gap > 0.0);
      CHECK(gap < 0.03);
      for (std::size_t k = 0; k < n; ++k) {
        const double from =
            std::remainder(animation.pocket_angle[k] - 0.5 * (begin + end), 2.0 * std::numbers::pi);
        CHECK((std::abs(from) < 0.5 * (end - begin)) == (animation.pocket_part[k] == part));
      }
    }
    CHECK(all == Approx(2.0 * std::numbers::pi).epsilon(0.03));
  }
}
