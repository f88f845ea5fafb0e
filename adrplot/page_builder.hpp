#pragma once

#include "adrplot/plot_pages.hpp"
#include "desktop/chart_page.hpp"

namespace adore::adrplot {

enum class Abscissa : unsigned char { Revolutions, Time };

/// Which coordinates an orbit page shows: 0, 1, 2 = x, y, z. Z over Y at first.
struct OrbitPair {
  int across = 1, up = 2;
};

struct PageOptions {
  Abscissa abscissa = Abscissa::Revolutions;
  OrbitPair orbit;
};

/// The chart of one page, its numbers taken from the file. @throws InputError for a page number
/// outside 1 .. pages.size().
desktop::ChartPage build_page(const results::SolFile& file, const std::vector<PageSpec>& pages,
                              int number, const PageOptions& options = {});

}  // namespace adore::adrplot
