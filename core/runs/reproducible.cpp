#include "runs/reproducible.hpp"

#include "base/arithmetic.hpp"
#include "base/errors.hpp"
#include "dynamics/race_contacts.hpp"

#include <cstdlib>
#include <string_view>

namespace adore::runs {

void require_reproducible() {
  if (!has_portable_math())
    throw InputError(
        "--reproducible: this program was built with the math functions of the C library, which "
        "differ between processors; build the program on a system with musl (Debian: musl-dev)");
  ::setenv("ADORE_ISA", "baseline", 1);
  // The kernel is chosen once, at its first use.
  if (std::string_view(dynamics::race_contact_instruction_set()) != "baseline")
    throw InputError(
        "--reproducible must be set before the first run of a process; start a new process");
}

}  // namespace adore::runs
