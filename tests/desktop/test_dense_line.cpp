#include "desktop/chart_page.hpp"
#include "desktop/dense_line.hpp"
#include "support/qt_app.hpp"

#include <QImage>
#include <QPainter>
#include <QPen>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace adore::desktop;

namespace {

constexpr int kWidth = 300, kHeight = 200;

/// Ten points for each pixel over half of the height, and one spike to 5 from the top.
QPolygonF zigzag_with_spike(double spike_x) {
  QPolygonF line;
  for (int i = 0; i < 10 * kWidth; ++i) line.append({0.1 * i, 100.0 + (i % 2 == 0 ? 50.0 : -10.0)});
  line[static_cast<qsizetype>(10.0 * spike_x)].setY(5.0);
  return line;
}

QImage drawn(const QPolygonF& line, double ratio = 1.0) {
  QImage image(QSize(kWidth, kHeight) * ratio, QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::white);
  QPainter painter(&image);
  draw_lines(painter, {line}, QRectF(0, 0, kWidth, kHeight), QPen(Qt::black, 1.6));
  return image;
}

}  // namespace

TEST_CASE("dense_line: bars reach every point of the line and no further", "[unit][desktop]") {
  QPolygonF line;
  for (int i = 0; i < 500; ++i)
    line.append({0.37 * i, 50.0 + 40.0 * std::sin(0.9 * i) * std::cos(0.013 * i)});
  const auto bars = column_bars(line, 0.0, 180.0, 1.0);
  REQUIRE(bars.size() == 181);
  for (const QPointF& p : line) {
    if (p.x() > 180.0) continue;
    const ColumnBar& bar = bars.at(static_cast<std::size_t>(p.x()));
    CHECK(bar.top <= p.y());
    CHECK(bar.bottom >= p.y());
  }
  // No further: a bar ends on the line.
  for (const ColumnBar& bar : bars) {
    if (bar.column == 180) continue;  // only its left edge is in the range
    double low = 1e9, high = -1e9;
    for (int part = 0; part <= 2000; ++part) {
      const double x = bar.column + part / 2000.0;
      const auto i = static_cast<qsizetype>(x / 0.37);
      if (i + 1 >= line.size()) continue;
      const double t = (x - line[i].x()) / 0.37;
      const double y = line[i].y() + t * (line[i + 1].y() - line[i].y());
      low = std::min(low, y), high = std::max(high, y);
    }
    CHECK(bar.top == Approx(low).margin(0.3));
    CHECK(bar.bottom == Approx(high).margin(0.3));
  }
}

TEST_CASE("dense_line: the only spike of a thousand points is seen, and stays where it is",
          "[gui]") {
  adore::test::use_qt();
  for (const double ratio : {1.0, 2.0})
    for (const double spike : {0.0, 77.7, 250.2}) {
      INFO("scale " << ratio << ", spike at " << spike);
      const QImage image = drawn(zigzag_with_spike(spike), ratio);
      const int row = static_cast<int>(20.0 * ratio);
      int first = -1, last = -1;
      for (int x = 0; x < image.width(); ++x)
        if (qGray(image.pixel(x, row)) < 200) first = first < 0 ? x : first, last = x;
      REQUIRE(first >= 0);
      CHECK((first + 1) / ratio >= spike - 1.0);  // half of the pen, and a pixel in part
      CHECK(last / ratio <= spike + 1.0);
    }
}

TEST_CASE("dense_line: a wave of ten pixels in a long curve keeps every one of its peaks",
          "[unit][desktop]") {
  // 100,000 values, of which 20,000 are seen on 1,000 columns; 200 values to a wave.
  std::vector<double> x, y;
  for (std::size_t i = 0; i < 100'000; ++i) {
    x.push_back(static_cast<double>(i));
    y.push_back(std::sin(2.0 * 3.14159265358979 * static_cast<double>(i) / 200.0));
  }
  const CurveBlocks blocks = blocks_of(y, false);
  const auto pieces = drawable_polylines(x, y, 30'000.0, 50'000.0, 1000, false, &blocks);
  REQUIRE(pieces.size() == 1);
  int peaks = 0;
  for (std::size_t i = 1; i + 1 < pieces[0].y.size(); ++i)
    peaks += pieces[0].y[i] > 0.99 && pieces[0].y[i] >= pieces[0].y[i - 1] &&
                     pieces[0].y[i] > pieces[0].y[i + 1]
                 ? 1
                 : 0;
  CHECK(peaks == 100);
}

TEST_CASE("dense_line: a stroke of two points is as wide as its pen, upright as well as level",
          "[unit][desktop]") {
  const auto wide = [](const QPolygonF& line, bool upright) {
    QImage image(QSize(kWidth, kHeight), QImage::Format_RGB32);
    image.fill(Qt::white);
    {
      QPainter painter(&image);
      draw_lines(painter, {line}, QRectF(0, 0, kWidth, kHeight), QPen(Qt::black, 6.0));
    }
    int dark = 0;
    for (int i = 0; i < (upright ? kWidth : kHeight); ++i)
      dark += qGray(upright ? image.pixel(i, 100) : image.pixel(150, i)) < 128 ? 1 : 0;
    return dark;
  };
  CHECK(wide(QPolygonF({{150.0, 20.0}, {150.0, 180.0}}), true) == 6);
  CHECK(wide(QPolygonF({{20.0, 100.0}, {280.0, 100.0}}), false) == 6);
}

TEST_CASE("dense_line: a line of any slope and density looks as a painter strokes it",
          "[gui][desktop]") {
  adore::test::use_qt();
  // A sine of growing slope; as many points as pixels, fewer, more. Compared is the ink of each
  // pixel with what Qt's own stroke leaves there.
  for (const double ratio : {1.0, 2.0})
    for (const double points : {0.2, 1.0, 3.0})
      for (const double slope : {0.02, 0.4, 1.0, 4.0}) {
        INFO("scale " << ratio << ", " << points << " points a pixel, slope " << slope);
        QPolygonF line;
        for (int i = 0; i < static_cast<int>(points * kWidth); ++i) {
          const double x = i / points, length = 80.0;
          line.append({x, 100.0 + slope * length / 6.2832 * std::sin(6.2832 * x / length)});
        }
        QImage stroked(QSize(kWidth, kHeight) * ratio, QImage::Format_RGB32);
        stroked.setDevicePixelRatio(ratio);
        stroked.fill(Qt::white);
        {
          QPainter painter(&stroked);
          painter.setRenderHint(QPainter::Antialiasing);
          painter.setPen(QPen(Qt::black, 1.6));
          painter.drawPolyline(line);
        }
        const QImage masked = drawn(line, ratio);
        double ink = 0.0, other = 0.0;
        int worst = 0;
        for (int y = 0; y < stroked.height(); ++y)
          for (int x = 4; x < stroked.width() - 20 * ratio; ++x) {
            const int a = 255 - qGray(stroked.pixel(x, y)), b = 255 - qGray(masked.pixel(x, y));
            ink += a;
            other += b;
            worst = std::max(worst, std::abs(a - b));
          }
        CHECK(other == Approx(ink).epsilon(0.1));
        CHECK(worst < 70);
      }
}

TEST_CASE("dense_line: width of a spike does not depend on the number of points",
          "[gui][desktop]") {
  adore::test::use_qt();
  const auto ink_of_spike = [](double points) {
    QPolygonF line;
    const int count = static_cast<int>(points * kWidth);
    for (int i = 0; i < count; ++i) line.append({i / points, 150.0});
    const double x = line[count / 2].x();
    line.insert(count / 2, QPointF(x, 20.0));
    line.insert(count / 2, QPointF(x, 150.0));
    const QImage image = drawn(line);
    double ink = 0.0;
    for (int k = 0; k < kWidth; ++k) ink += 255 - qGray(image.pixel(k, 80));
    return ink / 255.0;
  };
  CHECK(ink_of_spike(0.1) == Approx(1.6).margin(0.1));
  CHECK(ink_of_spike(8.0) == Approx(ink_of_spike(0.1)).margin(0.15));
}

TEST_CASE("dense_line: an area covers each pixel as much as a painter's does", "[gui][desktop]") {
  adore::test::use_qt();
  // Rectangles narrower and wider than a pixel, at places between pixels, with a high one and one
  // of no height.
  for (const double ratio : {1.0, 1.5, 2.0})
    for (const double width : {0.3, 1.0, 1.7, 9.4}) {
      QPolygonF outline;
      std::vector<QRectF> pieces;
      double x = 10.35;
      for (int k = 0; x + width < kWidth - 10.0; ++k, x += width) {
        const double top = k == 7 ? 20.3 : 100.0 + 30.0 * std::sin(0.3 * k), height = k == 9 ? 0.0
                                                                                      : k % 3 == 0
                                                                                          ? 0.4
                                                                                          : 12.6;
        pieces.emplace_back(x, top, width, height);
      }
      for (const QRectF& p : pieces) outline << p.topLeft() << p.topRight();
      for (auto p = pieces.rbegin(); p != pieces.rend(); ++p)
        outline << p->bottomRight() << p->bottomLeft();
      const QColor colour(20, 90, 200, 95);
      const auto painted = [&](bool ours) {
        QImage image(QSize(kWidth, kHeight) * ratio, QImage::Format_RGB32);
        image.fill(Qt::white);
        image.setDevicePixelRatio(ratio);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        if (ours) {
          REQUIRE(draw_band(painter, outline, colour));
        } else {
          painter.setPen(Qt::NoPen);
          painter.setBrush(colour);
          painter.drawPolygon(outline);
        }
        painter.end();
        return image;
      };
      const QImage one = painted(true), other = painted(false);
      int most = 0, inked = 0;
      for (int row = 0; row < one.height(); ++row)
        for (int column = 0; column < one.width(); ++column) {
          const int a = qRed(one.pixel(column, row)), b = qRed(other.pixel(column, row));
          most = std::max(most, std::abs(a - b));
          inked += a < 250 ? 1 : 0;
        }
      INFO("scale " << ratio << ", pieces of " << width);
      CHECK(inked > 1000);
      CHECK(most <= 3);  // of 87 between paper and area
    }
}
