#pragma once

#include "desktop/dense_way.hpp"
#include "desktop/way_runs.hpp"

#include <QPointF>
#include <QRect>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

class QPainter;
class QPen;

/// An oscillating path of very many points that is moved in its frame.
namespace adore::desktop {

/// Position of a path: inside `area`, with the mapping `scale`. Two pictures of a moved path have
/// `anchor`, a point of the plane, at positions that are whole pixels apart.
struct PathPlacement {
  PlaneScale scale;
  QPointF anchor;
  QRectF area;
};

/// The visible strokes of a path (`visible_path_strokes`) as tiles of pixels that belong to the
/// path and not to its frame. A moved frame shows the existing tiles, and only new ones are drawn
/// from the strokes through them. No stroke appears or disappears during a motion, and a picture
/// does not depend on the previous ones.
class PathTiles {
 public:
  /// Draws the path: on a screen its tiles, for which `anchor` has to be at whole pixels (else it
  /// is drawn up to half a pixel aside); for other painters its strokes.
  void draw(QPainter& painter, const PathIndex& way, const PathPlacement& place, const QPen& pen);
  /// Tiles that are kept now.
  [[nodiscard]] std::size_t kept() const { return tiles_.size(); }

 private:
  using Index = std::pair<int, int>;  ///< row and column, from the anchor on
  struct Look {
    double x_per = 0.0, y_per = 0.0, width = 0.0;
    QPointF anchor;
    [[nodiscard]] bool same_as(const Look& other) const;
  };
  void make(const PathIndex& way, const QRect& seen);

  Look look_;
  std::map<Index, std::vector<std::uint8_t>> tiles_;  ///< covers of their pixels; empty: no ink
};

}  // namespace adore::desktop
