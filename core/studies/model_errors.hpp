#pragma once

#include "runs/model_table.hpp"
#include "runs/prepare.hpp"

#include <functional>
#include <stop_token>
#include <vector>

/// Model errors next to numerical errors: what one choice of the model changes within its stated
/// uncertainty. Each row is the deck's run with one change, over the same span and from the same
/// kind of start; differences are those of accuracy.hpp, heat and life also with their sign. A run
/// under loads changed by 1e-6 shows what an irregular motion changes without any reason.
/// Limits: one change at a time (no interaction), the stated ranges only, a short span.
namespace adore::studies {

/// Only what the deck uses: contact damping (factor 2), traction law of the oil (kTrac against
/// filmLaw = recommended) or dry race friction (factor 1.3), friction of the cage (50 %), nodes or
/// slices (twice as many), mode (the others of 0, 1, 2), thermal model (network against ladder).
[[nodiscard]] std::vector<runs::ModelVariant> model_variants(const runs::Prepared& prepared);

/// @param turns of each run at most; the deck's own end ends it earlier
/// @param budget processor time of all runs [s]; fewer revolutions if need be
/// @throws InputError (quasi-static deck), SolverError (the deck's own run fails)
[[nodiscard]] runs::ModelStudy run_model_study(
    const runs::DeckRequest& request, double turns, double budget,
    const std::function<void(const runs::ModelRow&)>& row_done = {}, std::stop_token stop = {});

}  // namespace adore::studies
