#pragma once

#include "desktop/chart_page.hpp"

#include <cmath>

namespace adore::testing {

/// y = 2x and y = 100 - x over 0 .. 10 in one panel, 3 in another.
inline desktop::ChartPage lines_page() {
  desktop::ChartPage page;
  page.title = "Lines";
  page.x_title = "Time";
  page.x_unit = "s";
  desktop::ChartPanel force{"Force", "N", {{"rising", {}, {}}, {"falling", {}, {}}}, false};
  desktop::ChartPanel still{"Length", "m", {{"", {}, {}}}, false};
  for (int i = 0; i <= 100; ++i) {
    const double x = 0.1 * i;
    page.x.push_back(x);
    force.curves[0].y.push_back(2.0 * x);
    force.curves[1].y.push_back(100.0 - x);
    still.curves[0].y.push_back(3e-18 * std::sin(x));
  }
  page.panels = {force, still};
  return page;
}

}  // namespace adore::testing
