#pragma once

#include "agore/depth_canvas.hpp"
#include "agore/ring_profile.hpp"
#include "agore/solid_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

/// Parts of a bearing as triangles on a canvas, seen by an eye.
namespace adore::agore {

/// Directions at an azimuth: outward and of increasing azimuth.
inline Vec3 outward_direction(double azimuth) {
  return {0.0, -std::sin(azimuth), std::cos(azimuth)};
}
inline Vec3 azimuthal_direction(double azimuth) {
  return {0.0, -std::cos(azimuth), -std::sin(azimuth)};
}

/// Bodies as triangles on a canvas.
class SolidPainter {
 public:
  SolidPainter(DepthCanvas& canvas, const Eye& eye, double scale, QPointF middle)
      : canvas_(canvas), eye_(eye), scale_(scale), middle_(middle) {}

  [[nodiscard]] DepthCanvas::Point at(const Vec3& p) const {
    return {static_cast<float>(middle_.x() + scale_ * p.dot(eye_.right)),
            static_cast<float>(middle_.y() - scale_ * p.dot(eye_.up)),
            static_cast<float>(scale_ * p.dot(eye_.toward)), 0.0F};
  }
  /// Of a surface seen from either side.
  [[nodiscard]] float light(const Vec3& normal) const {
    const double z = normal.dot(eye_.toward), side = z < 0.0 ? -1.0 : 1.0;
    return light_of(static_cast<float>(side * normal.dot(eye_.right)),
                    static_cast<float>(side * normal.dot(eye_.up)), static_cast<float>(side * z));
  }
  [[nodiscard]] DepthCanvas::Point at(const Vec3& p, const Vec3& normal) const {
    DepthCanvas::Point out = at(p);
    out.light = light(normal);
    return out;
  }
  void flat(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Shades& shades) {
    const auto lit = lit_corners(a, b, c, d);
    if (lit) canvas_.quad((*lit)[0], (*lit)[1], (*lit)[2], (*lit)[3], shades);
  }
  /// A closed body with corners that are clockwise if visible.
  void front_flat(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                  const Shades& shades) {
    if (!((c - a).cross(d - b).dot(eye_.toward) < 0.0)) return;
    const auto lit = lit_corners(a, b, c, d);
    if (lit) canvas_.quad((*lit)[0], (*lit)[1], (*lit)[2], (*lit)[3], shades);
  }
  void sphere(const Vec3& centre, double radius, const Vec3& pole, const Shades& shades,
              const Shades& mark) {
    canvas_.sphere(at(centre), static_cast<float>(scale_ * radius),
                   {static_cast<float>(pole.dot(eye_.right)), static_cast<float>(pole.dot(eye_.up)),
                    static_cast<float>(pole.dot(eye_.toward))},
                   shades, mark);
  }
  [[nodiscard]] DepthCanvas& canvas() { return canvas_; }
  /// Number of parts of an arc [rad] of a radius for which its chords deviate by at most a quarter
  /// of a pixel.
  [[nodiscard]] int parts(double radius, double arc) const {
    constexpr double kSeen = 0.25, kMost = 1000.0;
    return static_cast<int>(
        std::clamp(std::ceil(arc / std::sqrt(8.0 * kSeen / (scale_ * radius))), 1.0, kMost));
  }

 private:
  [[nodiscard]] std::optional<std::array<DepthCanvas::Point, 4>> lit_corners(const Vec3& a,
                                                                             const Vec3& b,
                                                                             const Vec3& c,
                                                                             const Vec3& d) const {
    Vec3 normal = (c - a).cross(d - b);
    const double size = normal.norm();
    if (!(size > 0.0)) return std::nullopt;
    normal /= size;
    const float lit = light(normal);
    std::array<DepthCanvas::Point, 4> out{at(a), at(b), at(c), at(d)};
    for (DepthCanvas::Point& p : out) p.light = lit;
    return out;
  }
  DepthCanvas& canvas_;
  const Eye& eye_;
  double scale_;
  QPointF middle_;
};

/// A ring over the azimuths from `begin` to `end`.
void add_ring(SolidPainter& m, const std::vector<RingRadii>& profile, const Vec3& shift,
              double begin, double end, const Shades& shades);

/// Contact surface of a guide land on its race, above the ring surface by `proud`.
void add_land_surface(SolidPainter& m, const LandSection& land, const Vec3& shift,
                      std::pair<double, double> arc, const Shades& shades, double proud);

/// Position of the sector of one pocket of the cage, and its hole, as drawn.
struct PocketMesh {
  double half_angle, half_round;  ///< of the sector [rad]; of the hole, length around the cage
  bool round;                     ///< hole: an ellipse, or a window
  double taper = 0.0;             ///< of a window, as its roller
};

/// Point around a pocket: at its hole, and at the edge of its sector; angles about the bearing
/// axis, u along the cage.
struct RimPoint {
  double hole_angle, hole_u, edge_angle, edge_u;
};
/// Closed: the last point is the first. @param arc, straight numbers of points on the sides around
/// the bearing and along it
[[nodiscard]] std::vector<RimPoint> pocket_rim(const CageProfile& cage, double pitch_radius,
                                               const PocketMesh& pocket, int arc, int straight);

/// The sector of each pocket in the cage or its segment. `open_end`: does the cage end there,
/// before and after it?
struct CagePocket {
  int part = 0;
  double azimuth = 0.0;  ///< in the cage [rad]
  PocketMesh mesh;
  std::array<bool, 2> open_end{};
};
/// @param pocket_radius with the clearance as drawn; `profile` gets the hole that belongs to it
[[nodiscard]] std::vector<CagePocket> cage_pockets(const Animation& animation, double pocket_radius,
                                                   CageProfile& profile);
/// Attitude of the cage or a segment as drawn: tilts magnified by `factor`.
[[nodiscard]] Mat3 cage_attitude(const Animation& animation, std::size_t frame, int part,
                                 double factor);

/// The sector of one pocket. `open_end`: does the cage end there, before and after it?
void add_pocket_sector(SolidPainter& m, const CageProfile& cage, double pitch_radius,
                       double azimuth, const PocketMesh& pocket, const Mat3& turn,
                       const Vec3& shift, const std::array<bool, 2>& open_end,
                       const Shades& shades);

/// `first`: position of its mark, across the axis; none: no mark.
void add_roller(SolidPainter& m, const RollerProfile& shape, const Vec3& middle, const Vec3& axis,
                const Vec3& first, const Shades& shades, const Shades& mark);

}  // namespace adore::agore
