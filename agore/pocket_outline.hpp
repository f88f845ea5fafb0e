#pragma once

#include <QPainterPath>
#include <QPolygonF>

#include <array>
#include <optional>
#include <vector>

namespace adore::agore {

/// A guide face beside a roller as seen from outside: from the height `low` to `high` along the
/// bearing axis, at these distances to the right of the pocket's middle. A mirror image stands on
/// the left.
struct GuideFace {
  double low = 0.0, high = 0.0, at_low = 0.0, at_high = 0.0;
};

/// A pocket seen from outside, about its center: right is the way round, up the bearing axis.
struct PocketOutline {
  int code = 0;                                 ///< kPocType
  double radius = 0.0;                          ///< of the element
  double roller_length = 0.0;                   ///< 0: balls
  double taper = 0.0;                           ///< of a roller and its window, along the axis
  double clearance_1 = 0.0, clearance_2 = 0.0;  ///< diametral, as drawn
  /// Additional distance of the end walls at -x and +x from the middle of the pocket, for a tilted
  /// roller.
  std::array<double, 2> leaning{};
  std::vector<GuideFace> faces{};  ///< of record 7.3, in place of the window's sides
};

/// A roller seen from outside, about its middle: its silhouette with its axis to the right turned
/// upright, and then by its skew toward the way round.
[[nodiscard]] QPolygonF upright(const QPainterPath& silhouette, double skew);

/// Gaps of such a roller in the middle of its pocket to the side walls, left and right, and to the
/// end walls, below and above; negative: overlap.
struct PocketGaps {
  std::array<double, 2> sides{}, ends{};
};
[[nodiscard]] PocketGaps pocket_gaps(const PocketOutline& pocket, const QPolygonF& roller);

/// Skew drawn for clearances multiplied by `factor`: it uses the same fraction of the side
/// clearance. For a straight roller about `factor` times the skew; for a barrel, whose arc moves
/// aside with the square of the skew, about the square root of that. So drawn contacts agree with
/// real ones. At most 60 degrees.
[[nodiscard]] double drawn_skew(const QPainterPath& silhouette, double taper, double skew,
                                double factor);

/// Displacement from the middle toward the second wall that keeps the ratio of the two gaps; 0
/// without clearance.
[[nodiscard]] double moved(const std::array<double, 2>& play, std::array<double, 2> gaps);

/// The hole. Lengths in one unit of the caller's. A roller has half of clearance I at its sides and
/// at its ends, however it leans toward the viewer (decision 213), and its window its taper.
[[nodiscard]] QPainterPath pocket_hole(const PocketOutline& pocket);

/// The other, hidden edge of a conical pocket; empty for other shapes.
[[nodiscard]] QPainterPath pocket_far_edge(const PocketOutline& pocket);

/// Direction from the center of an element to the wall that carries it, at most 1 long: for a ball
/// its displacement, or the stored angle without displacement (0: the cage drives). For a roller
/// the angle is that of a guide surface, although it may also be at the end of the pocket.
/// `direction`: 1 if the cage turns to the right, else -1.
[[nodiscard]] QPointF wall_contact_direction(bool roller, QPointF centre, double angle,
                                             double direction);
/// Point where a roller, as upright() gives it, meets a wall on its left (0) or right (1): at the
/// height `along` if known and reachable, else at the smallest gap.
[[nodiscard]] QPointF wall_contact_point(const QPolygonF& roller, double taper, std::size_t side,
                                         std::optional<double> along);

/// Half sizes of the larger opening, around the cage and along the axis.
[[nodiscard]] QSizeF pocket_half_size(const PocketOutline& pocket);

}  // namespace adore::agore
