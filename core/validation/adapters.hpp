#pragma once

#include "validation/adapter.hpp"

#include <string_view>
#include <vector>

namespace adore::validation {

/// The adapters of every family that the program understands.
[[nodiscard]] std::vector<Adapter> all_adapters();

/// The function, or the functions, of the library that cases of a family without motion evaluate;
/// empty: unknown family.
[[nodiscard]] std::string_view evaluated_library_functions(std::string_view family);

}  // namespace adore::validation
