#pragma once

#include "base/errors.hpp"
#include "results/run_json.hpp"
#include "runs/prepare.hpp"

#include <string>
#include <vector>

/// Summary of a deck in RUN.json before the run.
namespace adore::runs {

/// @param plan of the run, with the quadratures that it carries
/// @param request digest of the request
/// @param remarks on the deck, beyond its own warnings
[[nodiscard]] results::RunSummary summary_of_deck(const Prepared& prepared,
                                                  const scene::ScenePlan& plan,
                                                  const std::string& request,
                                                  const std::vector<Finding>& remarks);

}  // namespace adore::runs
