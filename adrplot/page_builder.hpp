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

/// @throws InputError unless 1 <= number <= count.
void check_page_number(const std::filesystem::path& file, int number, std::size_t count);

/// The chart of one page, its numbers taken from the file. @throws InputError for a page number
/// outside 1 .. pages.size().
desktop::ChartPage build_page(const results::SolFile& file, const std::vector<PageSpec>& pages,
                              int number, const PageOptions& options = {});

}  // namespace adore::adrplot
