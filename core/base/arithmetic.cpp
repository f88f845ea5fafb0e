#include "base/arithmetic.hpp"

namespace adore {

bool has_portable_math() noexcept { return ADORE_PORTABLE_MATH != 0; }

}  // namespace adore
