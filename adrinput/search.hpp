#pragma once

#include "adrinput/cell.hpp"

#include <string>
#include <string_view>
#include <vector>

/// "Where is race curvature?": variables by name, help, record title and meaning of codes. No Qt.
namespace adore::adrinput {

struct Found {
  Cell cell;
  int score = 0;
};

/// Best first, at most `most`. Every word of the query that says something must occur; words like
/// "where" and "is" say nothing.
[[nodiscard]] std::vector<Found> search_variables(std::string_view query, std::size_t most = 60);

}  // namespace adore::adrinput
