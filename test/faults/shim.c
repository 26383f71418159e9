/* Loaded before the C library, it makes one call of a kind that writes fail, or sends a signal at it: the FAULT_AT-th
 * gets the error FAULT_ERROR, or the signal FAULT_SIGNAL just before it. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static int number(const char *name) {
  const char *text = getenv(name);
  return text ? atoi(text) : 0;
}

static int fails(void) {
  static int calls = 0;
  if (++calls != number("FAULT_AT")) return 0;
  if (number("FAULT_SIGNAL")) raise(number("FAULT_SIGNAL"));
  errno = number("FAULT_ERROR");
  return errno != 0;
}

/* Who started the tests may ignore the signal, as a shell does in the background. */
__attribute__((constructor)) static void heed(void) {
  if (number("FAULT_SIGNAL")) signal(number("FAULT_SIGNAL"), SIG_DFL);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

int open(const char *path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  mode_t mode = va_arg(rest, mode_t);
  va_end(rest);
  return (flags & O_CREAT) && fails() ? -1 : REAL(open)(path, flags, mode);
}

ssize_t write(int fd, const void *bytes, size_t count) {
  return fd != 2 && fails() ? -1 : REAL(write)(fd, bytes, count);
}

int fchmod(int fd, mode_t mode) { return fails() ? -1 : REAL(fchmod)(fd, mode); }
int fsync(int fd) { return fails() ? -1 : REAL(fsync)(fd); }
int rename(const char *from, const char *to) { return fails() ? -1 : REAL(rename)(from, to); }
