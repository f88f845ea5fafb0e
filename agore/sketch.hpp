#pragma once

#include "agore/cage_outlines.hpp"
#include "agore/stamps.hpp"
#include "agore/view_options.hpp"
#include "desktop/theme.hpp"

#include <QPainter>

/// Drawing in the plane of the bearing, seen from +X: y to the right, z up, lengths in the file's
/// unit.
namespace adore::agore {

/// Is the target made of pixels, so that cached images can be used? Else vector graphics.
bool is_raster_target(const QPainter& painter);

/// Adds a point to a line in the picture unless it is within half a pixel of the last one.
void append_visible_point(QPolygonF& line, QPointF next);

/// Length of y of a frame without names, in that of z.
inline constexpr double kShorterArm = 0.6;

/// Width of the edge in the background color for marks over bodies [pixels on each side].
inline constexpr double kCasing = 1.2;

/// The mark of a contact, centered at a point of the picture, with an edge that keeps it readable
/// on steel.
void draw_asterisk(QPainter& painter, QPointF where, double size, const QColor& colour,
                   const QColor& rim);

/// The mark that turns with a body of radius `r` [pixels]: right, up, toward the viewer, in its
/// radii; its end is hollow on the far side.
void draw_rotation_mark(QPainter& painter, QPointF middle, double r,
                        const std::array<double, 3>& mark, const QColor& colour);
/// That of a roller, seen on its end: a sector, which no line of a path looks like.
void draw_rotation_sector(QPainter& painter, QPointF middle, double r,
                          const std::array<double, 3>& mark, const QColor& colour);
/// Their color on steel and on the colors of a scale: darker than all of them.
[[nodiscard]] QColor rotation_mark_color(const desktop::Theme& theme);

class Sketch {
 public:
  /// Fits a circle of `radius` around the origin into `area`.
  /// `pan`: how far its middle is moved, in parts of the area. `foot`: height at the bottom that
  /// the circle leaves free [pixels], `head`: at the top. `stamps`: keeps drawings that only move;
  /// may be null.
  Sketch(QPainter& painter, const QRectF& area, double radius, const desktop::Theme& theme,
         QPointF pan = {0.0, 0.0}, double foot = 0.0, SpriteCache* stamps = nullptr,
         double head = 0.0);

  [[nodiscard]] QPainter& painter() const { return painter_; }
  [[nodiscard]] const desktop::Theme& theme() const { return theme_; }
  [[nodiscard]] const QRectF& area() const { return area_; }
  [[nodiscard]] double scale() const { return scale_; }
  /// Half size of the picture in each direction [pixels].
  [[nodiscard]] double half() const { return half_; }
  /// Picture position of a point (y, z), and of a point at azimuth `angle` and `radius` about (y,
  /// z).
  [[nodiscard]] QPointF at(double y, double z) const { return centre_ + QPointF(y, -z) * scale_; }
  [[nodiscard]] QPointF around(QPointF centre_yz, double radius, double angle) const;

  void ring(QPointF centre_yz, double inner, double outer, const QColor& light,
            const QColor& dark) const;
  void circle(QPointF centre_yz, double radius, const QPen& pen) const;
  /// As straight dashes, and only those in the area: quick at any size.
  void dashed_circle(QPointF centre_yz, double radius, const QColor& colour, double width) const;
  /// `mark` is the direction of the orientation mark: right, up, toward the viewer; zero: none.
  /// An invalid `tint` is steel.
  void ball(QPointF centre_yz, double radius, const std::array<double, 3>& mark,
            const QColor& tint = {}) const;
  /// The flat end of a roller, seen along the bearing axis.
  void roller_end(QPointF centre_yz, double radius, const std::array<double, 3>& mark,
                  const QColor& tint = {}) const;
  /// The side ring of the cage, pale, drawn behind the elements; and the ring between the pockets,
  /// drawn in front of them.
  void cage_rail(QPointF centre_yz, const Animation& animation) const;
  /// The same of a segment: from `begin` to `end` [rad], as azimuths.
  void cage_rail(QPointF centre_yz, const Animation& animation, double begin, double end) const;
  /// An outline of CageOutlines, rotated by `angle`, scaled to `outer_radius`.
  void cage(QPointF centre_yz, double angle, double outer_radius,
            const CageOutlines::Outline& outline) const;
  /// Two arms along the y and z axes of the body. Without names, z is the longer one.
  void frame(QPointF centre_yz, double angle, double length, const QColor& colour,
             bool named) const;
  /// Are the arms long enough for their names?
  [[nodiscard]] bool can_label_frame(double length) const;
  /// Positions of those names in the picture, z first: outside of the arms (`side` 1) or between
  /// them (-1).
  [[nodiscard]] std::array<QPointF, 2> frame_label_positions(QPointF centre_yz, double angle,
                                                             double length, double side) const;
  /// Draws the names over existing parts.
  void draw_frame_labels(QPointF centre_yz, double angle, double length, const QColor& colour,
                         double side = 1.0) const;
  /// Arrow between two points of the picture; its edge separates it from the background.
  void arrow(QPointF from, QPointF to, const QColor& colour, double width) const;
  void asterisk(QPointF where, double size, const QColor& colour) const;  ///< picture position
  void label(QPointF where, const QString& text, const QColor& colour, int pixel_size,
             bool bold = false) const;  ///< centered
  /// The same in bold letters with an edge of the paper's color, for places over marks.
  void draw_outlined_label(QPointF where, const QString& text, const QColor& colour,
                           int pixel_size) const;

  /// The mark of a ball or a roller alone.
  void draw_element_rotation_mark(QPointF centre_yz, double radius,
                                  const std::array<double, 3>& mark, bool roller) const;

 private:
  /// A drawing about `middle` that is the same wherever that is, kept on a screen.
  void stamp(QPointF middle, double reach, const SpriteCache::DrawingAppearance& look,
             const std::function<void(QPainter&, QPointF)>& paint) const;
  void draw_pale_cage(QPainter& painter, const QPainterPath& path) const;
  QPainter& painter_;
  QRectF area_;
  const desktop::Theme& theme_;
  QPointF centre_;
  double half_;
  double scale_;
  SpriteCache* sprite_cache_;
};

}  // namespace adore::agore
