#pragma once

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QRect>

#include <array>
#include <vector>

/// A picture with depth: of triangles and spheres the nearest surface wins at every pixel. Plain
/// arithmetic on arrays, without a graphics driver: the same picture with and without a screen.
namespace adore::agore {

/// A color from shadow (0) over itself (about 190) to its highlight (255).
using Shades = std::array<QRgb, 256>;
[[nodiscard]] Shades shades_of(const QColor& colour);

/// Light of a surface with this unit normal toward the viewer (x right, y up, z to the viewer), 0
/// to 255: a lamp over the viewer's left shoulder.
[[nodiscard]] float light_of(float x, float y, float z);

class DepthCanvas {
 public:
  /// In pixels, y downward; nearer is larger in depth.
  struct Point {
    float x = 0, y = 0, depth = 0, light = 0;
  };
  /// Marks on a sphere that show its rotation: a spot at the pole and a line around the equator. In
  /// the axes of the viewer; 0: none.
  struct Pole {
    float x = 0, y = 0, z = 0;
  };

  void reset(QSize size, QRgb paper);
  /// Restores the state of `other`: copies only parts drawn since.
  void restore(const DepthCanvas& other);
  [[nodiscard]] QSize size() const { return {width_, height_}; }
  void triangle(const Point& a, const Point& b, const Point& c, const Shades& shades);
  void quad(const Point& a, const Point& b, const Point& c, const Point& d, const Shades& shades) {
    triangle(a, b, c, shades);
    triangle(a, c, d, shades);
  }
  /// A closed body, without surfaces turned away from the viewer. Visible surfaces have clockwise
  /// corners in the picture.
  void front_triangle(const Point& a, const Point& b, const Point& c, const Shades& shades) {
    if (clockwise(a, b, c)) triangle(a, b, c, shades);
  }
  void front_quad(const Point& a, const Point& b, const Point& c, const Point& d,
                  const Shades& shades) {
    front_triangle(a, b, c, shades);
    front_triangle(a, c, d, shades);
  }
  void sphere(const Point& centre, float radius, const Pole& pole, const Shades& shades,
              const Shades& mark);
  /// Image with the mean of `shrink` by `shrink` pixels, in `box`. For shrink 1 it is not a copy:
  /// it is valid as long as the canvas exists and nothing more is drawn.
  [[nodiscard]] QImage image(int shrink, const QRect& box) const;
  [[nodiscard]] QImage image(int shrink) const {
    return image(shrink, QRect(0, 0, width_ / shrink, height_ / shrink));
  }
  /// Depth of the nearest surface; minus infinity if nothing is drawn.
  [[nodiscard]] float depth_at(QPointF pixel) const;
  /// Bounds of everything drawn since reset().
  [[nodiscard]] QRect drawn() const { return drawn_; }

 private:
  [[nodiscard]] static bool clockwise(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
  }
  /// Records that the pixels from `left` to `right` of these rows are drawn.
  void touch(int left, int top, int right, int bottom);
  int width_ = 0, height_ = 0;
  QRect drawn_, drawn_since_restore_;
  std::vector<QRgb> colour_;
  std::vector<float> depth_;
};

}  // namespace adore::agore
