#pragma once

#include <string_view>

namespace adore::runs {

/// SHA-256 of everything that results depend on except deck and options: the solver's sources and
/// data, compiler and flags of this build; the same in every program of one build. A version number
/// is not sufficient: another build may compute different results under the same number.
[[nodiscard]] std::string_view solver_stamp();

}  // namespace adore::runs
