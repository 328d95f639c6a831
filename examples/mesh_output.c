#define _POSIX_C_SOURCE 200112L /* isatty, clock_gettime; without POSIX there is no progress */
#include "mesh_output.h"

#include "mesh_number.h"

#include <errno.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>
#if defined __unix__ || defined __APPLE__
#include <unistd.h>
#else
#define isatty(file) 0
#endif

enum { TRIES = 100 }; /* names for a temporary file */
enum { ROOM = 1 << 16, TERMINAL = 2 };

struct output {
    FILE *file;
    char *name, *part;
    int order;
    size_t used;
    char room[ROOM];
};

/* The program writes one file, which a signal or an exit finds here. */
static output current;
static volatile sig_atomic_t unfinished;

static void abandon(void)
{
    if (!unfinished) return;
    unfinished = 0;
    remove(current.part);
}

static void on_signal(int number)
{
    abandon();
    signal(number, SIG_DFL);
    raise(number);
}

/* What was ignored before, as below nohup, stays so. */
static void catch_signal(int number)
{
    if (signal(number, on_signal) == SIG_IGN) signal(number, SIG_IGN);
}

void output_catch_signals(void)
{
    catch_signal(SIGINT);
    catch_signal(SIGTERM);
#ifdef SIGHUP
    catch_signal(SIGHUP);
#endif
#ifdef SIGPIPE
    signal(SIGPIPE, SIG_IGN);
#endif
#ifdef SIGXFSZ
    signal(SIGXFSZ, SIG_IGN);
#endif
    atexit(abandon);
}

output *output_open(const char *path, int order)
{
    output *o = &current;
    size_t size = strlen(path) + 8;
    int i;
    o->name = memcpy(allocate(size, 1), path, strlen(path));
    o->part = allocate(size, 1);
    o->order = order;
    o->used = 0;
    o->file = NULL;
    for (i = 0; i < TRIES && !o->file; i++) {
        snprintf(o->part, size, "%s.part%d", path, i);
        o->file = fopen(o->part, "wbx"); /* x: never a file that is there already */
    }
    if (!o->file) fail(path, 0, "%s", strerror(errno));
    unfinished = 1;
    setvbuf(o->file, NULL, _IONBF, 0);
    return o;
}

const char *output_path(const output *o) { return o->name; }

int output_is_text(const output *o) { return o->order == AS_TEXT; }

static void give_up(const output *o)
{
    fail(o->name, 0, "%s", errno ? strerror(errno) : "cannot be written");
}

static void flush(output *o)
{
    errno = 0;
    if (fwrite(o->room, 1, o->used, o->file) != o->used) give_up(o);
    o->used = 0;
}

void output_close(output *o)
{
    flush(o);
    if (fclose(o->file)) give_up(o);
    if (rename(o->part, o->name)) give_up(o);
    unfinished = 0;
    free(o->name);
    free(o->part);
}

/* Where so many bytes can be put. */
static char *at_least(output *o, size_t bytes)
{
    if (o->used + bytes > ROOM) flush(o);
    return o->room + o->used;
}

void put_bytes(output *o, const void *from, size_t bytes)
{
    const char *at = from;
    while (bytes > 0) {
        size_t n = bytes < ROOM ? bytes : ROOM;
        memcpy(at_least(o, n), at, n);
        o->used += n;
        at += n, bytes -= n;
    }
}

void put_text(output *o, const char *s) { put_bytes(o, s, strlen(s)); }

void put_number(output *o, double x)
{
    o->used += (size_t)number_format(at_least(o, NUMBER_SIZE), x);
}

void put_vec(output *o, n3_vec a)
{
    put_number(o, (double)a.x);
    put_bytes(o, " ", 1);
    put_number(o, (double)a.y);
    put_bytes(o, " ", 1);
    put_number(o, (double)a.z);
}

int type_bytes(int type)
{
    static const int bytes[] = {1, 4, 8, 4, 8};
    return bytes[type];
}

static uint64_t bits_of(int type, double x)
{
    uint64_t bits = 0;
    uint32_t half = 0;
    float narrow = (float)x;
    if (type == FLOAT64) memcpy(&bits, &x, sizeof bits);
    if (type == FLOAT32) memcpy(&half, &narrow, sizeof half);
    if (type == FLOAT32) bits = half;
    if (type < FLOAT32) bits = (uint64_t)(int64_t)x;
    return bits;
}

void put_value(output *o, int type, double x)
{
    int i, n = type_bytes(type);
    uint64_t bits;
    char *to;
    if (o->order == AS_TEXT) {
        put_number(o, x);
        return;
    }
    bits = bits_of(type, x);
    to = at_least(o, (size_t)n);
    for (i = 0; i < n; i++) to[i] = (char)(bits >> 8 * (o->order == BIG ? n - 1 - i : i) & 255);
    o->used += (size_t)n;
}

void put_separator(output *o, char c)
{
    if (o->order == AS_TEXT) put_bytes(o, &c, 1);
}

/* ---- Progress ---- */

enum { STEPS = 16 };

static struct {
    const char *work;
    double seconds;
} steps[STEPS]; /* the last one is under way */
static int count, hidden, width;
static double started, told, step_started;

/* Seconds, from some time on. */
static double now(void)
{
#ifdef CLOCK_MONOTONIC
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
#else
    return (double)time(NULL);
#endif
}

static void begin_step(const char *work, double time)
{
    if (count) steps[count - 1].seconds = time - step_started;
    if (count < STEPS) steps[count++].work = work;
    if (count == 1) started = told = time;
    step_started = time;
}

void progress(const char *work, double done, double all)
{
    const double time = now();
    if (!count || strcmp(steps[count - 1].work, work) != 0) begin_step(work, time);
    if (hidden || time - started < 1 || time - told < 0.5 || !isatty(TERMINAL)) return;
    told = time;
    width = fprintf(stderr, "\r%s: %s", program, work);
    if (done >= 0) width += fprintf(stderr, " %d %%", (int)(100 * done / all));
    fputs("   \r", stderr);
    fflush(stderr);
}

void progress_hide(void)
{
    if (width) fprintf(stderr, "\r%*s\r", width, "");
    hidden = 1;
}

void progress_times(double triangles)
{
    double all = now() - started;
    int i;
    begin_step("all", now());
    steps[count - 1].seconds = all;
    for (i = 0; i < count; i++)
        fprintf(stderr, "%s: %8.2f s %8.3f us per triangle  %s\n", program, steps[i].seconds,
                1e6 * steps[i].seconds / triangles, steps[i].work);
}
