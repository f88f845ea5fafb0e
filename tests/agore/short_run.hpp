#pragma once

#include "support/synthetic_results.hpp"

#include <QColor>
#include <QImage>

#include <cmath>

/// Common parts of AGORE tests: a short run and access to pictures.
namespace adore::test {

inline SyntheticRun short_run(int steps = 120) {
  SyntheticRun run;
  run.steps = steps;
  return run;
}

/// Pixels of about a color inside a rectangle.
inline int pixels_of(const QImage& image, const QRect& area, const QColor& colour) {
  int count = 0;
  for (int y = area.top(); y <= area.bottom(); ++y)
    for (int x = area.left(); x <= area.right(); ++x) {
      const QColor c = image.pixelColor(x, y);
      count += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                   std::abs(c.blue() - colour.blue()) <
               30;
    }
  return count;
}

}  // namespace adore::test
