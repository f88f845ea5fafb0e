#pragma once

#include "facade/reference/adapter.hpp"

#include <vector>

namespace adore::facade::reference {

/// Families tribology_hypotheticalTraction, tribology_hertzTraction, dynamics_contact_traction.
std::vector<Adapter> traction_adapters();

}  // namespace adore::facade::reference
