/* ADRX7 for Adore: traction coefficient as a function of slip, kappa = (A + B u) exp(-C u) + D, the
 * built-in curve of record 10.1. Record 12.1 contains the four coefficients A, B, C and D. Build
 * with make. Set kTrac = -1 in the deck and run: adore run DATA.txt --user ./libadrx7.so */
#include "adore_user.h"

#include <math.h>
#include <stdio.h>

static double A, B, C, D;

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "traction 1"; }

int32_t adrx7(adore_adrx7* a) {
  if (a->call.mode == ADORE_READ) {
    double in[4];
    a->call.active = 1;
    if (a->call.services->read_numbers(a->call.host, in, 4) != 4) {
      a->call.services->fail(a->call.host,
                             "record 12 must contain A, B, C and D of the traction curve");
      return 2;
    }
    A = in[0], B = in[1], C = in[2], D = in[3];
  } else if (a->call.mode == ADORE_START) {
    char text[160];
    snprintf(text, sizeof text, "kappa = (%g + %g u) exp(-%g u) + %g", A, B, C, D);
    a->call.services->print(a->call.host, text);
    a->slip_scale = C > 0.0 && A + D == 0.0 ? 1.0 / C : 0.0; /* slip range of the rise from zero */
    a->wants_points = 0;                                     /* the pressure is not used */
  } else if (a->call.mode == ADORE_COMPUTE) {
    const double* restrict u = a->slip;
    double* restrict kappa = a->kappa;
    const int64_t n = a->points * a->stride; /* columns beyond n are not used */
    const double p = A, q = B, c = -C, d = D;
    for (int64_t k = 0; k < n; ++k) kappa[k] = (p + q * u[k]) * exp(c * u[k]) + d;
  }
  return 0;
}
