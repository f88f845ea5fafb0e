#include "desktop/theme.hpp"
#include "support/qt_app.hpp"

#include <QCheckBox>
#include <QImage>
#include <QRadioButton>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

/// Colors as people with a color-vision deficiency see them: Machado, Oliveira and Fernandes
/// (2009), severity 1, on linear RGB. Distances in CIELAB: 2 is just seen side by side, 10 at a
/// glance.
using namespace adore;

namespace {

using Rgb = std::array<double, 3>;
using Matrix = std::array<Rgb, 3>;

constexpr Matrix kEverybody{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kProtanope{{{0.152286, 1.052583, -0.204868},
                             {0.114503, 0.786281, 0.099216},
                             {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeuteranope{{{0.367322, 0.860646, -0.227968},
                               {0.280085, 0.672501, 0.047413},
                               {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritanope{{{1.255528, -0.076749, -0.178779},
                             {-0.078411, 0.930809, 0.147602},
                             {0.004733, 0.691367, 0.303900}}};

Rgb linear(const QColor& colour) {
  const auto one = [](double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return {one(colour.redF()), one(colour.greenF()), one(colour.blueF())};
}

Rgb lab(const QColor& colour, const Matrix& eye) {
  const Rgb in = linear(colour);
  Rgb c{};
  for (std::size_t i = 0; i < 3; ++i)
    c[i] = std::clamp(eye[i][0] * in[0] + eye[i][1] * in[1] + eye[i][2] * in[2], 0.0, 1.0);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.95047),
               y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]),
               z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.08883);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double distance(const QColor& a, const QColor& b, const Matrix& eye) {
  const Rgb p = lab(a, eye), q = lab(b, eye);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double contrast(const QColor& a, const QColor& b) {
  const auto y = [](const QColor& colour) {
    const Rgb c = linear(colour);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2] + 0.05;
  };
  return std::max(y(a), y(b)) / std::min(y(a), y(b));
}

}  // namespace

TEST_CASE("theme: curves and marks are told apart with every color vision, in both themes",
          "[unit][desktop]") {
  for (const auto kind : {desktop::ThemeKind::Light, desktop::ThemeKind::Dark}) {
    const desktop::Theme& theme = desktop::theme(kind);
    for (const Matrix& eye : {kEverybody, kProtanope, kDeuteranope, kTritanope}) {
      for (std::size_t i = 0; i < theme.curves.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          INFO("curves " << j << " and " << i << ", dark " << (kind == desktop::ThemeKind::Dark));
          CHECK(distance(theme.curves[i], theme.curves[j], eye) > 10.0);
        }
      CHECK(distance(theme.red, theme.green, eye) > 15.0);        // start and end of an orbit
      CHECK(distance(theme.blue, theme.light_blue, eye) > 10.0);  // frames of the races
      for (const QColor& mark : {theme.red, theme.green, theme.blue, theme.light_blue, theme.cage,
                                 theme.steel_light, theme.steel_dark}) {
        INFO("ways of elements and " << mark.name().toStdString());
        CHECK(distance(theme.curves[3], mark, eye) > 10.0);
      }
    }
    // Thin lines on their ground, text-like marks better than that.
    for (const QColor& curve : theme.curves) CHECK(contrast(curve, theme.surface) > 2.5);
    for (const QColor& mark : {theme.red, theme.green, theme.blue, theme.text, theme.accent})
      CHECK(contrast(mark, theme.surface) > 3.0);
  }
}

TEST_CASE("theme: what can be ticked has an edge that is seen, ticked or not, in both themes",
          "[gui][desktop]") {
  test::use_qt();
  const auto before = desktop::current_theme().kind;
  for (const auto kind : {desktop::ThemeKind::Light, desktop::ThemeKind::Dark}) {
    desktop::apply_theme(kind);
    QCheckBox box;
    QRadioButton ring;
    for (QAbstractButton* button :
         {static_cast<QAbstractButton*>(&box), static_cast<QAbstractButton*>(&ring)}) {
      button->resize(button->sizeHint());
      const QImage image = button->grab().toImage();
      // Across the middle: the first change from the ground is the edge.
      const int y = image.height() / 2;
      const QColor ground = image.pixelColor(image.width() - 1, 0);
      double most = 0.0;
      for (int x = 0; x < image.width() / 3; ++x)
        most = std::max(most, contrast(image.pixelColor(x, y), ground));
      INFO(button->metaObject()->className() << ", dark " << (kind == desktop::ThemeKind::Dark));
      CHECK(most > 3.0);
    }
  }
  desktop::apply_theme(before);
}
