#pragma once

#include "adrplot/page_builder.hpp"

/// Notes on the values of a page.
namespace adore::adrplot {

/// "Aliased: ..." of a run that is stored too seldom for its fastest contact, else empty.
[[nodiscard]] std::string aliasing(const results::SolFile& file, const PageContext& context);

/// A cage's speeds are ratios, and not over what other pages of a run divide by (N54).
void tell_of_ratios(desktop::ChartPage& chart, const results::SolFile& file, const PageSpec& page,
                    const PageContext& context);

/// Lines through few stored values of a period have beats and uneven peaks that do not exist: said
/// of a page with such a line. Where extremes between steps are drawn, these show the peaks.
void tell_of_peaks(desktop::ChartPage& chart, const results::SolFile& file, const PageSpec& page,
                   const PageContext& context);

/// This note comes first: frequencies above the limit appear as lines below it.
void lead_with_aliasing(desktop::ChartPage& chart, const results::SolFile& file,
                        const PageContext& context);

/// Sentences on the values of a page over the steps of a run: zeros, values that are held, given or
/// averaged, and what loads or holds the races.
void tell_of_values(desktop::ChartPage& chart, const results::SolFile& file, const PageSpec& page,
                    const RunFacts& facts);

}  // namespace adore::adrplot
