/* A line on the terminal that says each second what is being done, and how much of it has been. An alarm shows it, so
 * that it comes also in the middle of work that counts nothing; the runtime system's own timer is off. Progress.hs is
 * the other side.
 */
#include <errno.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

/* What is being done, and how much of it has been. */
const char *volatile viscomplex_work = "working";
volatile uint64_t viscomplex_done = 0;

static volatile sig_atomic_t is_watched = 0, is_shown = 0;

static const char clear[] = "\r\033[K";

static void put(const char *bytes, size_t count) {
  if (write(STDERR_FILENO, bytes, count) < 0) { /* Nobody is there to be told. */ }
}

static void show(int signal) {
  int fault = errno;
  char digits[24], *first = digits + sizeof digits;
  const char *work = viscomplex_work;
  uint64_t done = viscomplex_done;
  (void)signal;
  if (done > 0) *--first = ' ';
  for (; done > 0; done /= 10) *--first = (char)('0' + done % 10);
  is_shown = 1;
  put(clear, sizeof clear - 1);
  put(first, digits + sizeof digits - first);
  put(work, strlen(work));
  errno = fault;
}

static void set_alarm(int seconds) {
  struct itimerval every = {.it_interval = {.tv_sec = seconds}, .it_value = {.tv_sec = seconds}};
  setitimer(ITIMER_REAL, &every, NULL);
}

int viscomplex_is_watched(void) { return is_watched; }

/* Ends the line: something else is going to be written to the terminal. */
void viscomplex_end_line(void) {
  if (!is_watched) return;
  set_alarm(0);
  is_watched = 0;
  if (is_shown) put(clear, sizeof clear - 1);
}

/* From here on the line is shown, if there is a terminal. */
void viscomplex_watch(void) {
  struct sigaction action;
  if (is_watched || !isatty(STDERR_FILENO)) return;
  memset(&action, 0, sizeof action);
  action.sa_handler = show;
  action.sa_flags = SA_RESTART;
  is_watched = sigaction(SIGALRM, &action, NULL) == 0;
  atexit(viscomplex_end_line);
  set_alarm(1);
}
