#pragma once

#include "runs/prepare.hpp"

namespace adore::runs {

/// Decides whether films between elements and races are evaluated by floats (laws/film_law_of.hpp):
/// option filmPrecision, a tolerance that does not see their errors (1e-5 of a traction at points
/// of balls, 3e-5 of rollers and visco-elastic films), an explicit method, and no element that is
/// held in balance; Jacobians and balances take differences. Once for a run, after its settings are
/// known.
void choose_film_precision(Prepared& prepared);

}  // namespace adore::runs
