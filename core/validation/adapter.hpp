#pragma once

#include "calculators/json_access.hpp"

/// Adapters of reference cases are written in the words of the calculators, whose cases they
/// include.
namespace adore::validation {

using namespace calculators;  // NOLINT(google-build-using-namespace)

}  // namespace adore::validation
