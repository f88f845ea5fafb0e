#pragma once

#include "desktop/dense_way.hpp"

#include <QPolygonF>
#include <QRectF>

#include <vector>

/// A way to and fro of very many points that is moved about in its frame.
namespace adore::desktop {

/// What is seen of a way at one scale, with as much around it as half the frame: while the frame
/// moves inside that, the million points behind it are not gone through again. Its places hang on
/// the way itself and not on the frame, so that no stroke comes or goes as the frame moves.
class KeptWay {
 public:
  /// Strokes of the way that reach into `area`, all of them seen ones (`seen_way`).
  [[nodiscard]] std::vector<QPolygonF> inside(const std::vector<double>& x,
                                              const std::vector<double>& y, const PlaneScale& scale,
                                              const QRectF& area);

 private:
  [[nodiscard]] bool holds(const PlaneScale& scale, const QRectF& seen) const;

  double x_per_ = 0.0, y_per_ = 0.0;  ///< of the scale that it was found at
  QRectF around_;                     ///< in pixels from the place of the values 0
  std::vector<QPolygonF> way_;
};

}  // namespace adore::desktop
