/* ADRX8 for Adore: imperfections of elements (kReGeoImp = 3) and pockets (kCagePocImp = 4), inertia
 * (kReIP = 3). In this example, record 12.1 contains the increase in diameter of every second
 * element [m]. */
#include "adore_user.h"

static double larger;

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "imperfections 1"; }

int32_t adrx8(adore_adrx8* a) {
  int64_t i;
  if (a->call.mode == ADORE_READ) {
    a->call.active = 1;
    if (a->call.services->read_numbers(a->call.host, &larger, 1) != 1) {
      a->call.services->fail(a->call.host, "record 12 must contain the increase in diameter [m]");
      return 2;
    }
  }
  if (a->call.mode == ADORE_COMPUTE)
    for (i = 1; i < a->n; i += 2) a->diameter[i] = larger;
  return 0;
}
