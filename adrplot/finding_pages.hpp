#pragma once

#include "base/finding.hpp"
#include "desktop/chart_page.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Pages that show the subject of a finding.
namespace adore::adrplot {

/// "cage", "film", "life", "heat", "contact" by the words of a page's title; empty: none.
/// @param subject of its file: "cage"
[[nodiscard]] std::string topic_of_page(std::string_view title, std::string_view subject = {});
/// By its kind; empty: none.
[[nodiscard]] std::string topic_of(const Finding& finding);
/// Does a panel of that title show the quantity of a finding?
[[nodiscard]] bool panel_concerns(std::string_view title, const Finding& finding);
/// Panel and curve of each curve that a finding concerns: panels of its quantity, of these the
/// curves of its race if they have one. Empty: none.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> concerned_curves(
    const desktop::ChartPage& page, const Finding& finding);
/// Does a finding concern the page of that title?
[[nodiscard]] std::function<bool(const Finding&)> page_concerns(std::string_view title,
                                                                std::string_view subject = {});

}  // namespace adore::adrplot
