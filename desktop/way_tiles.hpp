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

/// A way to and fro of very many points that is moved about in its frame.
namespace adore::desktop {

/// Where a way is drawn: inside `area`, at the places that `scale` gives. Two pictures of a way
/// that is moved have `anchor`, a point of the plane, at places that are whole pixels apart.
struct WayPlace {
  PlaneScale scale;
  QPointF anchor;
  QRectF area;
};

/// The seen strokes of a way (`seen_way`) as tiles of pixels that hang on the way and not on its
/// frame. A frame that moves shows the tiles that it showed before, and only new ones are drawn
/// from the strokes that pass them. No stroke comes or goes as it moves, and a picture does not
/// tell by which moves it was reached.
class WayTiles {
 public:
  /// Draws the way: its tiles on a screen, on which `anchor` has to be at whole pixels (else it is
  /// drawn up to half a pixel aside); its strokes by another painter.
  void draw(QPainter& painter, const WayRuns& way, const WayPlace& place, const QPen& pen);
  /// Tiles that are kept now.
  [[nodiscard]] std::size_t kept() const { return tiles_.size(); }

 private:
  using Index = std::pair<int, int>;  ///< row and column, from the anchor on
  struct Look {
    double x_per = 0.0, y_per = 0.0, width = 0.0;
    QPointF anchor;
    [[nodiscard]] bool same_as(const Look& other) const;
  };
  void make(const WayRuns& way, const QRect& seen);

  Look look_;
  std::map<Index, std::vector<std::uint8_t>> tiles_;  ///< covers of their pixels; empty: no ink
};

}  // namespace adore::desktop
