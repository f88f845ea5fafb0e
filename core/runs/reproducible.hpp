#pragma once

namespace adore::runs {

/// Makes every later run of this process give the same bytes on any x86-64 processor: the contact
/// kernel of the baseline instruction set, independent of ADORE_ISA. Call it before the first run
/// and before other threads start.
/// @throws InputError when the program was built without portable math functions.
void require_reproducible();

}  // namespace adore::runs
