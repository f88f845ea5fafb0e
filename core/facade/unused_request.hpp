#pragma once

#include "facade/prepare.hpp"
#include "facade/run.hpp"

#include <vector>

namespace adore::facade {

/// Requests beyond the deck without effect on this run: steps and tolerances of a
/// quasi-static deck, roller slices of a ball bearing. One note; none when all have an effect.
[[nodiscard]] std::vector<Issue> unused_request(const RunRequest& request,
                                                const Prepared& prepared);

}  // namespace adore::facade
