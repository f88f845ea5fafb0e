/* ADRXN for Adore: normal force between THE_BODIES as a function of the gap (negative: overlap).
 * One call has all contacts of this kind. This example adds damping during approach to the built-in
 * law. Record 12.1 contains the damping time [s]. */
#include "adore_user.h"

static double damping;

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "force 1"; }

int32_t adrxN(adore_force* a) {
  int64_t i;
  if (a->call.mode == ADORE_READ) {
    a->call.active = 1;
    if (a->call.services->read_numbers(a->call.host, &damping, 1) != 1) {
      a->call.services->fail(a->call.host, "record 12 must contain the damping time");
      return 2;
    }
  }
  if (a->call.mode == ADORE_COMPUTE)
    for (i = 0; i < a->n; ++i) {
      const double rate = a->gap[i] < 0.0 ? a->gap_rate[i] / a->gap[i]
                                          : 0.0; /* relative rate of the overlap [1/s] */
      const double force = a->built_in[i] * (1.0 + damping * rate);
      a->force[i] = force > 0.0 ? force : 0.0;
    }
  return 0;
}
