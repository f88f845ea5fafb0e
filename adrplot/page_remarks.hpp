#pragma once

#include "adrplot/page_builder.hpp"

/// Notes on the values of a page.
namespace adore::adrplot {

/// "Aliased: ..." for a run stored too coarsely for its fastest contact, else empty.
[[nodiscard]] std::string aliasing_note(const results::SolFile& file, const PageContext& context);

/// Cage speeds are ratios with a divisor that differs from other pages (N54).
void note_speed_ratios(desktop::ChartPage& chart, const results::SolFile& file,
                       const PageSpec& page, const PageContext& context);

/// Lines with few stored values per period show artificial beats and uneven peaks: note for a page
/// with such a line. Extremes between steps show the real peaks.
void note_missed_peaks(desktop::ChartPage& chart, const results::SolFile& file,
                       const PageSpec& page, const PageContext& context);

/// This note comes first: frequencies above the limit appear as lines below it.
void put_aliasing_note_first(desktop::ChartPage& chart, const results::SolFile& file,
                             const PageContext& context);

/// Notes on the values of a page over the steps of a run: zeros, constant, given or averaged
/// values, and loads or reactions of the races.
void note_special_values(desktop::ChartPage& chart, const results::SolFile& file,
                         const PageSpec& page, const RunFacts& facts);

}  // namespace adore::adrplot
