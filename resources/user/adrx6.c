/* ADRX6 for Adore: surfaces of races (kRaceGeoImp1, kRaceGeoImp2 = 3). In this example,
 * the radius of the inner race has waves. Record 12.1 contains amplitude [m], number per revolution
 * and phase [rad]. */
#include "adore_user.h"

#include <math.h>

static double wave[3];

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "waves 1"; }

int32_t adrx6(adore_surface* a) {
  int64_t k;
  if (a->call.mode == ADORE_READ) {
    a->call.active = 1;
    if (a->call.services->read_numbers(a->call.host, wave, 3) != 3) {
      a->call.services->fail(a->call.host,
                             "record 12 must contain amplitude, number and phase of the waves");
      return 2;
    }
  }
  if (a->call.mode == ADORE_COMPUTE && a->race == 1)
    for (k = 0; k < a->n; ++k) a->radius[k] = wave[0] * sin(wave[1] * a->azimuth[k] + wave[2]);
  return 0;
}
