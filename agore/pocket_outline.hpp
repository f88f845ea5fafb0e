#pragma once

#include <QPainterPath>
#include <QPolygonF>

#include <array>
#include <optional>

namespace adore::agore {

/// A pocket seen from outside, about its center: right is the way round, up the bearing axis.
struct PocketOutline {
  int code = 0;                                 ///< kPocType
  double radius = 0.0;                          ///< of the element
  double roller_length = 0.0;                   ///< 0: balls
  double taper = 0.0;                           ///< of a roller and its window, along the axis
  double clearance_1 = 0.0, clearance_2 = 0.0;  ///< diametral, as drawn
  /// How much farther than half a roller its end walls at -x and +x stand, of one that leans.
  std::array<double, 2> leaning{};
};

/// A roller seen from outside, about its middle: its silhouette with its axis to the right turned
/// upright, and then by its skew toward the way round.
[[nodiscard]] QPolygonF upright(const QPainterPath& silhouette, double skew);

/// What such a roller in the middle of its pocket has left to the walls at its sides, left and
/// right, and to those at its ends, below and above; negative: it overlaps.
struct PocketPlay {
  std::array<double, 2> sides{}, ends{};
};
[[nodiscard]] PocketPlay play_in(const PocketOutline& pocket, const QPolygonF& roller);

/// The skew that is drawn where clearances are `factor` times as large: the one that takes `factor`
/// times as much of the play at the sides. Of a straight roller about `factor` times the skew, of a
/// barrel, whose arc goes aside with the square of it, about the root of that; so both touch where
/// they touch, and are jammed where they are. At most a right angle's two thirds.
[[nodiscard]] double drawn_skew(const QPainterPath& silhouette, double taper, double skew,
                                double factor);

/// How far a body is moved from the middle, toward the second wall, so that what it has left to
/// two walls is as the gaps to them are; in the middle where it has nothing left.
[[nodiscard]] double moved(const std::array<double, 2>& play, std::array<double, 2> gaps);

/// The hole. Lengths in one unit of the caller's. A roller has half of clearance I at its sides and
/// at its ends, however it leans toward the viewer (decision 213), and its window its taper.
[[nodiscard]] QPainterPath pocket_hole(const PocketOutline& pocket);

/// The other, hidden edge of a conical pocket's hole, whose two ends differ; empty for others.
[[nodiscard]] QPainterPath pocket_far_edge(const PocketOutline& pocket);

/// Which way from an element's center the wall lies that carries it, at most 1 long: of a ball
/// where it has gone, or by the stored angle where it has not (0: the cage drives). A roller's
/// angle is that of a guide surface beside it, while it may have gone to the pocket's end as well.
/// `direction`: 1 where the cage turns to the right, else -1.
[[nodiscard]] QPointF touched_wall(bool roller, QPointF centre, double angle, double direction);
/// Where a roller, as upright() has it, meets a wall on its left (0) or right (1): at the height
/// `along` where that is known and it reaches there, else where it comes next to the wall.
[[nodiscard]] QPointF touching_place(const QPolygonF& roller, double taper, std::size_t side,
                                     std::optional<double> along);

/// Half sizes of it, the way round and along the axis, the larger one.
[[nodiscard]] QSizeF pocket_half(const PocketOutline& pocket);

}  // namespace adore::agore
