/* ADRX9 for Adore: the third example of the manual. It writes all local heat sources with position
 * and size to SOL9, for a finite element model of races and cage. Each source has one line per
 * step. The sum of the sources of a step is the total dissipation. */
#include "adore_user.h"

#include <stdio.h>

int32_t adore_user_abi(void) { return ADORE_USER_ABI; }
const char* adore_user_version(void) { return "heat map 1"; }

int32_t adrx9(adore_adrx9* a) {
  const adore_services* s = a->call.services;
  char line[200];
  int64_t i;
  if (a->call.mode == ADORE_READ) a->call.active = 1;
  if (a->call.mode == ADORE_START)
    s->write(a->call.host,
             "#       time kind element race          x          y          z          a          "
             "b         heat\n");
  if (a->call.mode == ADORE_STEP)
    for (i = 0; i < a->sources; ++i) {
      snprintf(line, sizeof line, "%12.6e %4d %7d %4d %10.3e %10.3e %10.3e %10.3e %10.3e %12.5e\n",
               a->call.time, (int)a->source_kind[i], (int)a->source_element[i] + 1,
               (int)a->source_race[i] + 1, a->source_place[3 * i], a->source_place[3 * i + 1],
               a->source_place[3 * i + 2], a->source_size[2 * i], a->source_size[2 * i + 1],
               a->source_heat[i]);
      s->write(a->call.host, line);
    }
  return 0;
}
