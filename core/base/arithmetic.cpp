#include "base/arithmetic.hpp"

namespace adore {

bool portable_math_functions() noexcept { return ADORE_PORTABLE_MATH != 0; }

}  // namespace adore
