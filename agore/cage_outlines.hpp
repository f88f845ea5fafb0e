#pragma once

#include "agore/animation.hpp"

#include <QPainterPath>

#include <map>
#include <utility>
#include <vector>

namespace adore::agore {

/// Outlines of the cage between its pockets, or of a segment, at angle 0: y to the right, z up,
/// scaled to an outside of kRadius. The outlines are pieces that do not overlap (bars between
/// pockets), because a path is searched completely for each strip of a picture. They are cut once,
/// simplified once for each size, and rotated for drawing: cutting forty pockets takes longer than
/// the rest of a picture.
class CageOutlines {
 public:
  static constexpr double kRadius = 1000.0;
  /// Largest distance of an omitted point from the drawn outline [pixels].
  static constexpr double kTolerance = 0.1;
  using Pieces = std::vector<QPolygonF>;
  struct Outline {
    Pieces pieces;        ///< closed
    bool nested = false;  ///< pieces are holes of others: one path
  };

  /// `outside`: radius of the cage in the picture [pixels].
  const Outline& of(const Animation& animation, double pocket_radius, int segment, double outside);

 private:
  const Animation* animation_ = nullptr;
  double pocket_radius_ = -1.0;
  std::map<int, Outline> full_outlines_;
  std::map<int, std::pair<double, Outline>> simplified_outlines_;  ///< and for which size
};

/// Outline of a segment of the cage at angle 0 [rad]: from the middle between two pockets to the
/// next such middle, with a visible gap.
struct Sector {
  double begin = 0.0, end = 0.0;
};
[[nodiscard]] Sector segment_sector(const Animation& animation, int segment);

/// A closed line without points that are within `tolerance` of the rest (Ramer, Douglas and
/// Peucker's algorithm).
[[nodiscard]] QPolygonF thinned(const QPolygonF& closed, double tolerance);

}  // namespace adore::agore
