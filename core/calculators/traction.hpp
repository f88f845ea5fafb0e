#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Families tribology_hypotheticalTraction, tribology_hertzTraction, dynamics_contact_traction.
std::vector<Adapter> traction_adapters();

}  // namespace adore::calculators
