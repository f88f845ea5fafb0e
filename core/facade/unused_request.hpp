#pragma once

#include "facade/prepare.hpp"
#include "facade/run.hpp"

#include <vector>

namespace adore::facade {

/// What was asked for beyond the deck and plays no part in this run: steps and tolerances of a
/// quasi-static deck, roller slices of a ball bearing. One note; none when all of it acts.
[[nodiscard]] std::vector<Issue> unused_request(const RunRequest& request,
                                                const Prepared& prepared);

}  // namespace adore::facade
