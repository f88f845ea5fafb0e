#pragma once

#include "base/errors.hpp"
#include "facade/prepare.hpp"
#include "results/run_json.hpp"

#include <string>
#include <vector>

/// What RUN.json says of a deck before anything has run.
namespace adore::facade {

/// @param plan of the run, with the quadratures that it carries
/// @param request digest of what was asked for
/// @param remarks on the deck, beyond its own warnings
[[nodiscard]] results::RunSummary summary_of_deck(const Prepared& prepared,
                                                  const scene::ScenePlan& plan,
                                                  const std::string& request,
                                                  const std::vector<Finding>& remarks);

}  // namespace adore::facade
