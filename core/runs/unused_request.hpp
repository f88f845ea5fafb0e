#pragma once

#include "runs/prepare.hpp"
#include "runs/run.hpp"

#include <vector>

namespace adore::runs {

/// Requests without effect on this run: steps and tolerances of a quasi-static deck, roller slices
/// of a ball bearing, a motion without steps.
[[nodiscard]] std::vector<Issue> unused_request(const RunRequest& request,
                                                const Prepared& prepared);

/// Why a deck that asks for a motion makes no step of it: "maxStps is 0" or "fTime is 0"; empty
/// when it does, or when it asks for none.
[[nodiscard]] std::string why_no_step(const deck::Deck& deck);
/// The note about that: every chart would show one point.
[[nodiscard]] std::optional<Issue> no_step_note(const deck::Deck& deck);

}  // namespace adore::runs
