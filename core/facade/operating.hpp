#pragma once

#include "bearing/bearing.hpp"

namespace adore::facade {

/// The bearing in operation, whatever rolls in it: fits, temperatures and growth at its speeds
/// (thermal/operating.hpp). @throws InputError
[[nodiscard]] bearing::Bearing at_work(const bearing::Bearing& as_built);

}  // namespace adore::facade
