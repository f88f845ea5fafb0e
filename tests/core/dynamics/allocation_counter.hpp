#pragma once

namespace adore::test {

/// Calls of operator new so far, in the whole test program.
long allocation_count();

}  // namespace adore::test
