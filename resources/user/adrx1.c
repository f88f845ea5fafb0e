/* ADRX1 for Adore: the two examples of the manual. The speed of the inner race increases linearly
 * from rpm1 at t1 to rpm2 at t2, and the housing vibrates along z, z = A sin(2 pi f t). Record 12.1
 * contains t1, t2 [s], rpm1 and rpm2 [rpm] (equal speeds: no ramp). Record 12.2 contains A [m] and
 * f [Hz] (A = 0: no vibration). rpm1 must be equal to the inner race speed of record 9.1.2. */
#include "adore_user.h"

#include <math.h>
#include <stdio.h>

static double t1, t2, rpm1, rpm2, A, f, w, spin_up;
static const double pi = 3.14159265358979323846;

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "motion 1"; }

int32_t adrx1(adore_adrx1* a) {
  const adore_services* s = a->call.services;
  char text[200];
  double in[4];
  switch (a->call.mode) {
    case ADORE_READ:
      a->call.active = 1;
      if (s->read_numbers(a->call.host, in, 4) != 4) {
        s->fail(a->call.host, "record 12.1 must contain t1, t2, rpm1 and rpm2");
        return 2;
      }
      t1 = in[0], t2 = in[1], rpm1 = in[2], rpm2 = in[3];
      if (s->read_numbers(a->call.host, in, 2) != 2) {
        s->fail(a->call.host, "record 12.2 must contain amplitude and frequency of the housing");
        return 2;
      }
      A = in[0], f = in[1];
      break;
    case ADORE_START:
      w = 2.0 * pi * f;
      spin_up = t2 > t1 ? (rpm2 - rpm1) * pi / 30.0 / (t2 - t1) : 0.0;
      if (spin_up != 0.0) {
        a->drives[1] = 1;
        a->kinks[0] = t1, a->kinks[1] = t2, a->kink_count = 2; /* the acceleration jumps there */
        snprintf(text, sizeof text, "inner race from %g to %g rpm between %g and %g s", rpm1, rpm2,
                 t1, t2);
        s->print(a->call.host, text);
      }
      if (A != 0.0) {
        a->drives[0] = 1;
        a->start_velocity[2] = A * w; /* of the outer race, along z */
        a->longest_step = 0.05 / f;
        snprintf(text, sizeof text, "housing along z: %g m at %g Hz", A, f);
        s->print(a->call.host, text);
      }
      break;
    case ADORE_COMPUTE:
      if (a->call.time >= t1 && a->call.time < t2)
        a->angular_acceleration[3] = spin_up;                  /* inner race, x */
      a->acceleration[2] = -A * w * w * sin(w * a->call.time); /* outer race, z */
      break;
    case ADORE_PRINT:
      if (A != 0.0) {
        snprintf(text, sizeof text, "housing at z = %.6e m", A * sin(w * a->call.time));
        s->print(a->call.host, text);
      }
      break;
    default:
      break;
  }
  return 0;
}
