#pragma once

#include "scene/cost_ledger.hpp"
#include "scene/ledger.hpp"
#include "scene/look.hpp"
#include "scene/plan.hpp"
#include "scene/scales.hpp"
#include "scene/snapshot.hpp"
#include "scene/system_options.hpp"

/// Plans, snapshots, ledgers and scales are what the equations of motion talk in.
namespace adore::dynamics {

using namespace scene;  // NOLINT(google-build-using-namespace)

}  // namespace adore::dynamics
