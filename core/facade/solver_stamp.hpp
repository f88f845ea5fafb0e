#pragma once

#include <string_view>

namespace adore::facade {

/// SHA-256 of what results depend on beside deck and options: the solver's sources and data,
/// compiler and flags of this build; the same in every program of one build. A version number would
/// not do: a program that was built again may compute something else under the same number.
[[nodiscard]] std::string_view solver_stamp();

}  // namespace adore::facade
