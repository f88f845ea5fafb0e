/* A plug-in that does what its line of record 12 says: every way to go wrong that tests know. */
#include "adore_user.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double what, seed;
static int calls;

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "behaviours 1"; }

static double random_number(void) { return (double)rand() / RAND_MAX; }

int32_t adrx7(adore_adrx7* a) {
  int64_t k;
  double in[2];
  if (a->call.mode == ADORE_READ) {
    a->call.active = 1;
    if (a->call.services->read_numbers(a->call.host, in, 2) != 2) return 2;
    what = in[0], seed = in[1];
    srand((unsigned)seed);
    return 0;
  }
  if (a->call.mode != ADORE_COMPUTE || ++calls < 3)
    return 0; /* the first question, asked twice, is kappa at rest */
  for (k = 0; k < a->points * a->stride; ++k) a->kappa[k] = 0.05;
  switch ((int)what) {
    case 1:
      a->kappa[0] = NAN;
      break;
    case 2:
      a->kappa[0] = HUGE_VAL;
      break;
    case 3:
      a->kappa[0] = random_number();
      break; /* not the same when asked again */
    case 4:
      memset((void*)a->slip, 0, sizeof(double));
      break; /* not its own */
    case 5:
      return 7;
    case 6:
      *(volatile int*)0 = 1;
      break;
    case 7:
      for (;;) ++*(volatile int*)&calls; /* a loop without end */
    case 8:
      exit(0);
    case 9:
      abort();
    case 10:
      return 1;
    case 11:
      a->call.services->fail(a->call.host, "the oil is out");
      return 3;
    case 12:
      memset(a->call.host, 0x5a, 64);
      return 0; /* of the program */
    case 13:
      for (k = 0; k < a->points * a->stride; ++k)
        a->kappa[k] = (random_number() - 0.5) * pow(10.0, 300.0 * (random_number() - 0.5));
      break;
    default:
      break;
  }
  return 0;
}
