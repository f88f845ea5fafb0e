/* Preloaded into a program, ends it (SIGKILL) at its n-th call that changes a file: a kill at a
 * moment that does not depend on the machine's speed.
 *
 *   ADORE_KILL_AT=n      before the call is made, n = 1, 2, ...; with ADORE_KILL_AFTER=1 when it
 * has been made
 *   ADORE_COUNT_CALLS=f  writes the number of calls into file f when the program ends by itself
 *   ADORE_KEEP=name      kills nothing: each file that is given this name keeps another one,
 * name.0000, name.0001, ..., when the next one takes its place
 *
 * Counted: write beyond the standard streams, pwrite, ftruncate, fsync, rename, link, unlink, and
 * open that creates; those in an open folder (renameat, openat ...), too. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static long calls, kill_at = -1;
static int after;
static const char* keep;
static int kept;

__attribute__((constructor)) static void start(void) {
  const char* at = getenv("ADORE_KILL_AT");
  kill_at = at != NULL ? atol(at) : -1;
  after = getenv("ADORE_KILL_AFTER") != NULL;
  keep = getenv("ADORE_KEEP");
}

__attribute__((destructor)) static void end(void) {
  const char* name = getenv("ADORE_COUNT_CALLS");
  FILE* file = name != NULL ? fopen(name, "w") : NULL;
  if (file == NULL) return;
  fprintf(file, "%ld\n", calls);
  fclose(file);
}

static void die(void) {
  kill(getpid(), SIGKILL);
  for (;;) pause();
}

static int comes(void) {
  const int now = __atomic_add_fetch(&calls, 1, __ATOMIC_SEQ_CST) == kill_at;
  if (now && !after) die();
  return now;
}

#define AROUND(type, call)    \
  do {                        \
    const int last = comes(); \
    type result = (call);     \
    if (last) die();          \
    return result;            \
  } while (0)
#define REAL(name, ...)    \
  static type_##name real; \
  if (real == NULL) real = (type_##name)dlsym(RTLD_NEXT, #name)

typedef ssize_t (*type_write)(int, const void*, size_t);
ssize_t write(int fd, const void* data, size_t size) {
  REAL(write);
  if (fd <= 2) return real(fd, data, size);
  AROUND(ssize_t, real(fd, data, size));
}
typedef ssize_t (*type_pwrite)(int, const void*, size_t, off_t);
ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
  REAL(pwrite);
  AROUND(ssize_t, real(fd, data, size, at));
}
typedef ssize_t (*type_pwrite64)(int, const void*, size_t, off64_t);
ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
  REAL(pwrite64);
  AROUND(ssize_t, real(fd, data, size, at));
}
typedef int (*type_ftruncate)(int, off_t);
int ftruncate(int fd, off_t size) {
  REAL(ftruncate);
  AROUND(int, real(fd, size));
}
typedef int (*type_ftruncate64)(int, off64_t);
int ftruncate64(int fd, off64_t size) {
  REAL(ftruncate64);
  AROUND(int, real(fd, size));
}
typedef int (*type_fsync)(int);
int fsync(int fd) {
  REAL(fsync);
  AROUND(int, real(fd));
}
static void keep_copy(int folder, const char* path) {
  char name[4096];
  const size_t length = strlen(path), tail = strlen(keep);
  if (length < tail || strcmp(path + length - tail, keep) != 0) return;
  snprintf(name, sizeof name, "%s.%04d", path, kept++);
  if (linkat(folder, path, folder, name, 0) != 0) abort();
}
typedef int (*type_rename)(const char*, const char*);
int rename(const char* from, const char* to) {
  REAL(rename);
  if (keep != NULL) {
    const int result = real(from, to);
    if (result == 0) keep_copy(AT_FDCWD, to);
    return result;
  }
  AROUND(int, real(from, to));
}
typedef int (*type_renameat)(int, const char*, int, const char*);
int renameat(int a, const char* from, int b, const char* to) {
  REAL(renameat);
  if (keep != NULL) {
    const int result = real(a, from, b, to);
    if (result == 0) keep_copy(b, to);
    return result;
  }
  AROUND(int, real(a, from, b, to));
}
typedef int (*type_unlinkat)(int, const char*, int);
int unlinkat(int folder, const char* name, int flags) {
  REAL(unlinkat);
  AROUND(int, real(folder, name, flags));
}
typedef int (*type_unlink)(const char*);
int unlink(const char* name) {
  REAL(unlink);
  AROUND(int, real(name));
}
typedef int (*type_linkat)(int, const char*, int, const char*, int);
int linkat(int a, const char* from, int b, const char* to, int flags) {
  REAL(linkat);
  AROUND(int, real(a, from, b, to, flags));
}
typedef int (*type_open)(const char*, int, ...);
int open(const char* name, int flags, ...) {
  REAL(open);
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
  va_end(list);
  if ((flags & O_CREAT) == 0) return real(name, flags, mode);
  AROUND(int, real(name, flags, mode));
}
typedef int (*type_open64)(const char*, int, ...);
int open64(const char* name, int flags, ...) {
  REAL(open64);
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
  va_end(list);
  if ((flags & O_CREAT) == 0) return real(name, flags, mode);
  AROUND(int, real(name, flags, mode));
}
typedef int (*type_openat)(int, const char*, int, ...);
int openat(int folder, const char* name, int flags, ...) {
  REAL(openat);
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
  va_end(list);
  if ((flags & O_CREAT) == 0) return real(folder, name, flags, mode);
  AROUND(int, real(folder, name, flags, mode));
}
typedef int (*type_openat64)(int, const char*, int, ...);
int openat64(int folder, const char* name, int flags, ...) {
  REAL(openat64);
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
  va_end(list);
  if ((flags & O_CREAT) == 0) return real(folder, name, flags, mode);
  AROUND(int, real(folder, name, flags, mode));
}
