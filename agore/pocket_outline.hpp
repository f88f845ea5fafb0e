#pragma once

#include <QPainterPath>

#include <array>

namespace adore::agore {

/// A pocket seen from outside, about its centre: right is the way round, up the bearing axis.
struct PocketOutline {
  int code = 0;                                 ///< kPocType
  double radius = 0.0;                          ///< of the element
  double roller_length = 0.0;                   ///< 0: balls
  double taper = 0.0;                           ///< of a roller and its window, along the axis
  double clearance_1 = 0.0, clearance_2 = 0.0;  ///< diametral, as drawn
  /// How much farther than half a roller its end walls at -x and +x stand, of one that leans.
  std::array<double, 2> leaning{};
};

/// The hole. Lengths in one unit of the caller's. A roller has half of clearance I at its sides and
/// at its ends, however it leans towards the viewer (decision 213), and its window its taper.
[[nodiscard]] QPainterPath pocket_hole(const PocketOutline& pocket);

/// The other, hidden edge of a conical pocket's hole, whose two ends differ; empty for others.
[[nodiscard]] QPainterPath pocket_far_edge(const PocketOutline& pocket);

/// Which way from an element's centre the wall lies that carries it, at most 1 long: of a ball
/// where it has gone, or by the stored angle where it has not (0: the cage drives). A roller's
/// angle is that of a guide surface beside it, while it may have gone to the pocket's end as well.
/// `direction`: 1 where the cage turns to the right, else -1.
[[nodiscard]] QPointF touched_wall(bool roller, QPointF centre, double angle, double direction);

/// Half sizes of it, the way round and along the axis, the larger one.
[[nodiscard]] QSizeF pocket_half(const PocketOutline& pocket);

}  // namespace adore::agore
