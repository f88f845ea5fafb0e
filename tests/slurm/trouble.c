/* Preloaded into the workers of a study (LD_PRELOAD): the first one that finds the file named by
   ADORE_TROUBLE takes it away and does what it says before it computes: "hang" waits for ever,
   "memory N" takes N megabytes and waits. All other processes do nothing. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int is_worker(void) {
  char words[256] = {0};
  FILE* file = fopen("/proc/self/cmdline", "rb");
  if (file == NULL) return 0;
  size_t size = fread(words, 1, sizeof words - 1, file);
  fclose(file);
  const char* second = memchr(words, 0, size);
  return second != NULL && strcmp(second + 1, "study") == 0 && strcmp(second + 7, "work") == 0;
}

__attribute__((constructor)) static void trouble(void) {
  const char* name = getenv("ADORE_TROUBLE");
  if (name == NULL || !is_worker()) return;
  char taken[4096], what[64] = {0};
  snprintf(taken, sizeof taken, "%s.%d", name, (int)getpid());
  if (rename(name, taken) != 0) return;
  FILE* file = fopen(taken, "r");
  if (file == NULL || fgets(what, sizeof what, file) == NULL) return;
  fclose(file);
  if (strncmp(what, "memory ", 7) == 0) {
    size_t bytes = (size_t)atol(what + 7) << 20;
    volatile char* all = malloc(bytes); /* else the compiler leaves it out */
    for (size_t at = 0; all != NULL && at < bytes; at += 1024) all[at] = 1;
  }
  for (;;) pause();
}
