/* ADRX0 for Adore: materials of your own database, for parts with material code 2. Properties that
 * the routine does not set keep the default of the part (52100 for races and elements, mild steel
 * for other parts). */
#include "adore_user.h"

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "materials 1"; }

int32_t adrx0(adore_adrx0* a) {
  if (a->call.mode == ADORE_READ) a->call.active = 1;
  if (a->call.mode == ADORE_COMPUTE && a->part == ADORE_ELEMENT) { /* silicon nitride */
    a->density = 3200.0;
    a->elastic_modulus = 310e9;
    a->poisson_ratio = 0.27;
    a->thermal_expansion = 2.9e-6;
  }
  return 0;
}
