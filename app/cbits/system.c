/* What the program must be able to do at any moment, in the middle of a collection of memory too, and what the runtime
 * system of GHC lets nobody do from within Haskell: keep to a limit of memory, end by a signal, and leave no half of a
 * file behind. Output.hs is the other side.
 */
#define _GNU_SOURCE
#include <Rts.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/* Exit codes of docs/commands.md. */
enum { MORE_MEMORY_NEEDED = 6, LAW_BROKEN = 70 };

/* Files ----------------------------------------------------------------------------------------------------------- */

/* The file under work, the one whose place it will take, and whether there is such a file: until it is renamed, it is
 * removed however the program ends. */
static char unfinished[PATH_MAX], target[PATH_MAX];
static volatile sig_atomic_t is_unfinished = 0;

static void clean_up(void) {
  if (is_unfinished) {
    is_unfinished = 0;
    unlink(unfinished);
  }
}

static int failed_with(int fault) {
  clean_up();
  errno = fault;
  return -1;
}

/* Which file a path means in the end: symbolic links in its last place are followed, to a file that is not there too. */
static int follow(const char *path) {
  char link[PATH_MAX];
  if (strlen(path) >= PATH_MAX) return failed_with(ENAMETOOLONG);
  strcpy(target, path);
  for (int links = 0; links < 40; links++) {
    ssize_t length = readlink(target, link, PATH_MAX - 1);
    if (length < 0) return errno == EINVAL || errno == ENOENT ? 0 : -1;
    link[length] = 0;
    char *last = strrchr(target, '/');
    char *from = link[0] == '/' || !last ? target : last + 1;
    if (from - target + length >= PATH_MAX) return failed_with(ENAMETOOLONG);
    strcpy(from, link);
  }
  return failed_with(ELOOP);
}

static bool is_same(const struct stat *file, int fd) {
  struct stat other;
  return fstat(fd, &other) == 0 && other.st_dev == file->st_dev && other.st_ino == file->st_ino;
}

/* Begins to write what a path names; returns where to write it, or -1. A file is written beside its place, with its
 * owner and permissions. What is none (a pipe, a device), or is open already as an output of this process, is written
 * as it is. */
int viscomplex_begin(const char *path) {
  struct stat old;
  bool is_there = stat(path, &old) == 0;
  if (!is_there && errno != ENOENT) return -1;
  if (is_there && S_ISREG(old.st_mode))
    for (int fd = 1; fd <= 2; fd++)
      if (is_same(&old, fd)) return dup(fd);
  if (is_there && (!S_ISREG(old.st_mode) || !strncmp(path, "/dev/fd/", 8) || !strncmp(path, "/proc/", 6)))
    return open(path, O_WRONLY | O_TRUNC | O_NOCTTY | O_CLOEXEC);
  if (follow(path) < 0 || (is_there && faccessat(AT_FDCWD, target, W_OK, AT_EACCESS) < 0)) return -1;

  char *last = strrchr(target, '/');
  int folder = last ? last + 1 - target : 0;
  sigset_t all, before;
  sigfillset(&all);
  for (int k = 0;; k++) {
    int length = snprintf(unfinished, PATH_MAX, "%.*s.viscomplex-%d-%d", folder, target, (int)getpid(), k);
    if (length >= PATH_MAX) return failed_with(ENAMETOOLONG);
    sigprocmask(SIG_BLOCK, &all, &before);
    int fd = open(unfinished, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    int fault = errno;
    is_unfinished = fd >= 0;
    sigprocmask(SIG_SETMASK, &before, NULL);
    errno = fault;
    if (fd < 0 && fault == EEXIST && k < 1000) continue;
    if (fd < 0 || !is_there) return fd;
    /* Where the owner cannot be kept, a program that ran as that owner would run as another one. */
    mode_t kept = fchown(fd, old.st_uid, old.st_gid) == 0 ? 07777 : 01777;
    if (fchmod(fd, old.st_mode & kept) == 0) return fd;
    fault = errno;
    close(fd);
    return failed_with(fault);
  }
}

void viscomplex_end_line(void);

/* Writes all of some bytes. A line of progress ends where they go to the terminal too. */
int viscomplex_write(int fd, const char *bytes, size_t count) {
  if (fd == STDERR_FILENO || (fd == STDOUT_FILENO && isatty(fd))) viscomplex_end_line();
  while (count > 0) {
    ssize_t done = write(fd, bytes, count);
    if (done > 0) {
      bytes += done;
      count -= done;
    } else if (done < 0 && errno == EAGAIN) {
      struct pollfd ready = {.fd = fd, .events = POLLOUT};
      poll(&ready, 1, -1);
    } else if (done == 0 || errno != EINTR) {
      return failed_with(done == 0 ? EIO : errno);
    }
  }
  return 0;
}

/* Ends what was begun: from here on, the path names what was written. */
int viscomplex_end(int fd) {
  bool is_file = is_unfinished;
  if (is_file && fsync(fd) < 0 && errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP) {
    int fault = errno;
    close(fd);
    return failed_with(fault);
  }
  if (close(fd) < 0) return failed_with(errno);
  if (!is_file) return 0;
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &before);
  int outcome = rename(unfinished, target) < 0 ? failed_with(errno) : 0;
  int fault = errno;
  is_unfinished = 0;
  sigprocmask(SIG_SETMASK, &before, NULL);
  errno = fault;
  return outcome;
}

/* Signals --------------------------------------------------------------------------------------------------------- */

/* The handler has been taken away before it runs, so that the signal does what it does to any program. */
static void end_by(int signal) {
  clean_up();
  raise(signal);
}

static struct sigaction interrupt;

static void catch_signals(void) {
  static const int deadly[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU};
  struct sigaction ours, before;
  memset(&ours, 0, sizeof ours);
  ours.sa_handler = end_by;
  ours.sa_flags = SA_RESETHAND | SA_NODEFER;
  for (size_t k = 0; k < sizeof deadly / sizeof *deadly; k++)
    /* Who started the program may want a signal to be ignored, as nohup does. */
    if (sigaction(deadly[k], NULL, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(deadly[k], &ours, NULL);
  sigaction(SIGINT, NULL, &interrupt);
  /* A file that may not become so large is told as any other fault of writing. */
  signal(SIGXFSZ, SIG_IGN);
}

/* The base library of GHC puts a handler of its own for interrupts before the program's main; this takes it away. */
void viscomplex_heed_interrupts(void) { sigaction(SIGINT, &interrupt, NULL); }

/* Memory ---------------------------------------------------------------------------------------------------------- */

/* What a command may take, and what of it is for all but the heap: the program itself and its tables. */
static uint64_t allowed = UINT64_MAX;
static const uint64_t besides = 12 << 20;

/* Says that there is not enough memory, and ends the program. No Haskell runs any more. */
void viscomplex_exhausted(bool refused) {
  char text[256];
  int length = snprintf(text, sizeof text,
    refused ? "%sviscomplex: the system gives no more memory, by a limit such as ulimit -v or because others have it; "
              "give a smaller scene\n"
            : "%sviscomplex: more memory is needed than the %lluM allowed; allow more by --memory SIZE, or give a "
              "smaller scene\n",
    /* There may be a line of progress. */
    isatty(STDERR_FILENO) ? "\r\033[K" : "", (unsigned long long)(allowed >> 20));
  clean_up();
  if (write(STDERR_FILENO, text, length) < 0) { /* Nobody is there to be told. */ }
  _exit(MORE_MEMORY_NEEDED);
}

/* The heap's part of what is allowed. */
static uint64_t heap_allowed = UINT64_MAX;

/* The configuration of the runtime system, which no header shows. */
extern RtsConfig rtsConfig;

/* Memory is collected by copying, which needs twice what is live: the more of a heap is live, the more often. Near a half
 * nothing else is done any more, so that a command takes many minutes before it fails; at this part it does so in time. */
static void collected(const struct GCDetails_ *details) {
  if (details->gen > 0 && details->live_bytes > heap_allowed / 20 * 9) viscomplex_exhausted(false);
}

/* Allows so many bytes. */
void viscomplex_allow(uint64_t bytes) {
  allowed = bytes;
  heap_allowed = bytes > 2 * besides ? bytes - besides : bytes / 2;
  RtsFlags.GcFlags.maxHeapSize = heap_allowed / BLOCK_SIZE > UINT32_MAX ? UINT32_MAX : heap_allowed / BLOCK_SIZE;
  /* Collecting in place instead would be slower, and no more than twice as much could be live. */
  RtsFlags.GcFlags.compactThreshold = 1000;
  rtsConfig.gcDoneHook = collected;
}

static void at_most(uint64_t bytes, uint64_t *least) {
  if (bytes > 0 && bytes < *least) *least = bytes;
}

/* The first number in a file; 0 for none, as "max" is. */
static uint64_t number_in(const char *path) {
  unsigned long long number = 0;
  FILE *file = fopen(path, "re");
  if (!file) return 0;
  if (fscanf(file, "%*[^0-9\n]%llu", &number) != 1) {
    rewind(file);
    if (fscanf(file, "%llu", &number) != 1) number = 0;
  }
  fclose(file);
  return number;
}

/* What a control group allows, and each of those around it. */
static void group_allows(const char *root, char *group, const char *name, uint64_t *least) {
  char path[PATH_MAX];
  for (;;) {
    if (snprintf(path, sizeof path, "%s%s/%s", root, group, name) < PATH_MAX) at_most(number_in(path), least);
    char *last = strrchr(group, '/');
    if (!last) return;
    *last = 0;
  }
}

/* Half of the machine's memory, or what a container or the limit of a shell allows, where that is less. */
static uint64_t usually_allowed(void) {
  uint64_t least = UINT64_MAX;
  char line[PATH_MAX];
  struct rlimit space;
  at_most(number_in("/proc/meminfo") * 1024 / 2, &least);
  if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) at_most(space.rlim_cur, &least);
  FILE *groups = fopen("/proc/self/cgroup", "re");
  while (groups && fgets(line, sizeof line, groups)) {
    line[strcspn(line, "\n")] = 0;
    char *controllers = strchr(line, ':');
    char *group = controllers ? strchr(controllers + 1, ':') : NULL;
    if (!group) continue;
    *group++ = 0;
    if (!strcmp(controllers, ":")) group_allows("/sys/fs/cgroup", group, "memory.max", &least);
    else if (strstr(controllers, "memory")) group_allows("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes", &least);
  }
  if (groups) fclose(groups);
  return least;
}

/* Hooks of the runtime system, which calls those with a capital by name. */

void FlagDefaultsHook(void) {
  RtsFlags.MiscFlags.install_signal_handlers = false;
  viscomplex_allow(usually_allowed());
}

void OutOfHeapHook(W_ request STG_UNUSED, W_ heap STG_UNUSED) { viscomplex_exhausted(false); }

void StackOverflowHook(W_ size STG_UNUSED) { viscomplex_exhausted(false); }

void MallocFailHook(W_ request STG_UNUSED, const char *why STG_UNUSED) { viscomplex_exhausted(true); }

/* The errors that the runtime system tells are of memory, since it is given no options. */
static bool told = false;

static void tell(const char *format STG_UNUSED, va_list arguments STG_UNUSED) { told = true; }

static void leave(int code) {
  if (told || code == EXIT_HEAPOVERFLOW) viscomplex_exhausted(true);
}

static void internal_error(const char *format, va_list arguments) {
  clean_up();
  if (strstr(format, "emory") || strstr(format, "mmap")) viscomplex_exhausted(true);
  fputs("viscomplex: the runtime system of GHC has an internal error: ", stderr);
  vfprintf(stderr, format, arguments);
  fputs("\n", stderr);
  _exit(LAW_BROKEN);
}

/* Before the runtime system starts. */
__attribute__((constructor)) static void set_up(void) {
  /* Where a standard file is closed, a file opened later must not take its place: it is open the wrong way round, so
   * that using it is an error. */
  for (int fd = 0; fd <= 2; fd++)
    if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", fd == 0 ? O_WRONLY : O_RDONLY) != fd) _exit(LAW_BROKEN);
  catch_signals();
  atexit(clean_up);
  errorMsgFn = tell;
  fatalInternalErrorFn = internal_error;
  exitFn = leave;
}
