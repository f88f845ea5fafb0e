#pragma once

#include "adrplot/abscissa.hpp"
#include "adrplot/plot_pages.hpp"
#include "adrplot/run_facts.hpp"
#include "adrplot/run_motion.hpp"
#include "adrplot/spectrum.hpp"
#include "desktop/chart_page.hpp"

#include <map>
#include <string>
#include <vector>

namespace adore::adrplot {

/// Which coordinates an orbit page shows: 0, 1, 2 = x, y, z. Z over Y at first.
struct OrbitAxes {
  int across = 1, up = 2;
};

struct PageOptions {
  Abscissa abscissa = Abscissa::Revolutions;
  OrbitAxes orbit;
  SpectrumOptions spectrum = {};
  Domain domain = Domain::History;
  /// Curve of a page for its spectrogram: its name in ChartPage::choices, part of it, or its
  /// number. Empty, or not found: the first one.
  std::string spectrogram_of = {};
};

/// Extremes of a curve between its stored values, as long as it and in its unit.
struct MinMaxBand {
  std::vector<double> low, high;
};

/// Known data of a run that are not in the plotted file.
struct PageContext {
  std::vector<MarkEventCounts> marks = {};       ///< shaft, FTF, BPFO ...
  double fastest_frequency = 0.0;                ///< of a contact of the run [Hz]; 0: not known
  std::string fastest_contact;                   ///< "element 1 / outer race"
  std::map<std::string, MinMaxBand> bands = {};  ///< by column
  RunFacts facts = {};
};

/// @throws InputError unless 1 <= number <= count.
void check_page_number(const std::filesystem::path& file, int number, std::size_t count);

/// Columns that the notes and scales of a page are from, besides its curves.
[[nodiscard]] std::vector<std::string> auxiliary_columns(results::SolKind kind,
                                                         const PageSpec& page);

/// Rotation in the run of a file; without marks in the context only marks of its rotation.
[[nodiscard]] RunMotion motion_of(const results::SolFile& file, const PageContext& context);

/// The chart of one page, with values from the file. @throws InputError for a page number outside 1
/// .. pages.size(). Values that mean "not computed" are dropped (known_values.hpp).
desktop::ChartPage build_page(const results::SolFile& file, const std::vector<PageSpec>& pages,
                              int number, const PageOptions& options = {},
                              const PageContext& context = {});

}  // namespace adore::adrplot
