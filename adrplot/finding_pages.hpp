#pragma once

#include "base/finding.hpp"

#include <functional>
#include <string>
#include <string_view>

/// Pages that show the subject of a finding.
namespace adore::adrplot {

/// "cage", "film", "life", "heat", "contact" by the words of a page's title; empty: none.
/// @param subject of its file: "cage"
[[nodiscard]] std::string topic_of_page(std::string_view title, std::string_view subject = {});
/// By its kind; empty: none.
[[nodiscard]] std::string topic_of(const Finding& finding);
/// Does a finding concern the page of that title?
[[nodiscard]] std::function<bool(const Finding&)> page_concerns(std::string_view title,
                                                                std::string_view subject = {});

}  // namespace adore::adrplot
