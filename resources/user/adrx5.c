/* ADRX5 for Adore: radius of the rolling elements. This example gives rollers a crown. The first
 * number of record 12.1 is the length of the straight land [m], the second the radius of the crown
 * beyond the land [m]. Balls are not changed, because they must be round. */
#include "adore_user.h"

#include <math.h>

static double crown[2];

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "crown 1"; }

int32_t adrx5(adore_surface* a) {
  int64_t k;
  if (a->call.mode == ADORE_READ) {
    a->call.active = 1;
    if (a->call.services->read_numbers(a->call.host, crown, 2) != 2) {
      a->call.services->fail(a->call.host,
                             "record 12 must contain the length of the land and the crown radius");
      return 2;
    }
  }
  if (a->call.mode == ADORE_COMPUTE && a->call.bearing->rollers)
    for (k = 0; k < a->n; ++k) {
      const double e = fabs(a->axial[k]) - 0.5 * crown[0];
      if (e > 0.0) a->radius[k] = -e * e / (crown[1] + sqrt(crown[1] * crown[1] - e * e));
    }
  return 0;
}
