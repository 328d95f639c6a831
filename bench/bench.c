/* bench [ROUNDS]: what each call costs, as a Markdown table on stdout.
 *
 * Every round times every call once, on memory that was touched before, and beside each call the
 * writing of as many bytes (memset of 0x5a: zeros have a short cut in some machines) and the plain
 * way to a point, the sum of the ten control points times their Bernstein polynomials. The columns
 * are the medians over the rounds; the ratios compare times of the same round, and the spread is
 * half the distance between the quartiles. */
#define _POSIX_C_SOURCE 199309L
#include "nagata3.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { ITEMS = 512, LATTICE = 8, POINTS = 45, PATCHES = 64, MAX_ROUNDS = 1000 };

static n3_vertex corners[ITEMS][3];
static n3_patch patches[PATCHES];
static n3_real lattice[POINTS][2];
static union output {
    n3_segment segment[ITEMS];
    n3_edge edge[ITEMS];
    n3_patch patch[ITEMS];
    n3_vec point[PATCHES * POINTS];
    n3_jet jet[PATCHES * POINTS];
    unsigned char byte[sizeof(n3_jet) * PATCHES * POINTS];
} out;

static const n3_options arc_rule = {N3_RULE_ARC, 0, 0};

static void run_segment(void)
{
    int i;
    for (i = 0; i < ITEMS; i++) out.segment[i] = n3_segment_make(corners[i][0], corners[i][1]);
}

static void run_edge(void)
{
    int i;
    for (i = 0; i < ITEMS; i++) out.edge[i] = n3_edge_make(corners[i][0], corners[i][1], NULL);
}

static void run_edge_arc(void)
{
    int i;
    for (i = 0; i < ITEMS; i++) out.edge[i] = n3_edge_make(corners[i][0], corners[i][1], &arc_rule);
}

static void run_patch(void)
{
    int i;
    for (i = 0; i < ITEMS; i++)
        out.patch[i] = n3_patch_make(corners[i][0], corners[i][1], corners[i][2], NULL);
}

static void run_patch_arc(void)
{
    int i;
    for (i = 0; i < ITEMS; i++)
        out.patch[i] = n3_patch_make(corners[i][0], corners[i][1], corners[i][2], &arc_rule);
}

static n3_vec bernstein_point(const n3_patch *p, n3_real u, n3_real v)
{
    n3_real w = 1 - u - v, b[10];
    n3_vec x = {0, 0, 0};
    int k;
    b[0] = w * w * w, b[1] = u * u * u, b[2] = v * v * v;
    b[3] = 3 * u * w * w, b[4] = 3 * u * u * w, b[5] = 3 * u * u * v;
    b[6] = 3 * u * v * v, b[7] = 3 * v * v * w, b[8] = 3 * v * w * w;
    b[9] = 6 * u * v * w;
    for (k = 0; k < 10; k++) x = n3_add(x, n3_mul(b[k], p->p[k]));
    return x;
}

#define AT_EVERY_POINT(array, function)                                                            \
    int i, k;                                                                                      \
    for (i = 0; i < PATCHES; i++)                                                                  \
        for (k = 0; k < POINTS; k++)                                                               \
            out.array[POINTS * i + k] = function(&patches[i], lattice[k][0], lattice[k][1])

static void run_bernstein(void) { AT_EVERY_POINT(point, bernstein_point); }
static void run_point(void) { AT_EVERY_POINT(point, n3_patch_point); }
static void run_normal(void) { AT_EVERY_POINT(point, n3_patch_normal); }
static void run_jet(void) { AT_EVERY_POINT(jet, n3_patch_jet); }

typedef struct call { const char *name; void (*run)(void); int items; size_t bytes; } call;

static const call calls[] = {
    {"n3_segment_make", run_segment, ITEMS, sizeof(n3_segment)},
    {"n3_edge_make, paper", run_edge, ITEMS, sizeof(n3_edge)},
    {"n3_edge_make, arc", run_edge_arc, ITEMS, sizeof(n3_edge)},
    {"n3_patch_make, paper", run_patch, ITEMS, sizeof(n3_patch)},
    {"n3_patch_make, arc", run_patch_arc, ITEMS, sizeof(n3_patch)},
    {"n3_patch_point", run_point, PATCHES * POINTS, sizeof(n3_vec)},
    {"n3_patch_normal", run_normal, PATCHES * POINTS, sizeof(n3_vec)},
    {"n3_patch_jet", run_jet, PATCHES * POINTS, sizeof(n3_jet)},
    {"plain Bernstein sum", run_bernstein, PATCHES * POINTS, sizeof(n3_vec)},
};
enum { CALLS = sizeof calls / sizeof *calls, REPEATS = 8 };

static double nanoseconds[CALLS][MAX_ROUNDS], to_memset[CALLS][MAX_ROUNDS],
    to_bernstein[CALLS][MAX_ROUNDS];

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* Folded over all that the calls wrote, so that no compiler can leave them out. */
static uint32_t checksum = 2166136261u;

static void add_to_checksum(size_t bytes)
{
    size_t i;
    for (i = 0; i < bytes; i++) checksum = (checksum ^ out.byte[i]) * 16777619u;
}

/* Nanoseconds per item; the first pass brings code and data into the caches. */
static double time_call(const call *c)
{
    double start;
    int i;
    c->run();
    start = now();
    for (i = 0; i < REPEATS; i++) c->run();
    start = now() - start;
    add_to_checksum(c->bytes * (size_t)c->items);
    return start / REPEATS / c->items;
}

/* As many bytes, in nanoseconds per item. */
static double time_memset(const call *c)
{
    size_t bytes = c->bytes * (size_t)c->items;
    void *(*volatile set)(void *, int, size_t) = memset;
    double start;
    int i;
    set(out.byte, 0x5a, bytes);
    start = now();
    for (i = 0; i < REPEATS; i++) set(out.byte, 0x5a, bytes);
    start = now() - start;
    return start / REPEATS / c->items;
}

/* splitmix64, into [-1, 1]. */
static n3_real random_real(void)
{
    static uint64_t state = 1;
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (n3_real)((double)((z ^ (z >> 31)) >> 11) / 4503599627370496.0 - 1);
}

static n3_vec random_vec(void)
{
    n3_real x = random_real(), y = random_real(), z = random_real();
    return n3_v(x, y, z);
}

/* Corners in the unit cube whose normals lean up to 45 degrees off the triangle's. */
static void make_input(void)
{
    int i, j, k = 0;
    for (i = 0; i < ITEMS; i++) {
        n3_vertex *v = corners[i];
        n3_vec n;
        for (j = 0; j < 3; j++) v[j].x = random_vec();
        n = n3_unit(n3_cross(n3_sub(v[1].x, v[0].x), n3_sub(v[2].x, v[0].x)));
        for (j = 0; j < 3; j++)
            v[j].n = n3_unit(n3_add(n, n3_mul((n3_real)1 / 2, random_vec())));
    }
    for (i = 0; i < PATCHES; i++)
        patches[i] = n3_patch_make(corners[i][0], corners[i][1], corners[i][2], NULL);
    for (i = 0; i <= LATTICE; i++)
        for (j = 0; i + j <= LATTICE; j++, k++) {
            lattice[k][0] = (n3_real)i / LATTICE;
            lattice[k][1] = (n3_real)j / LATTICE;
        }
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Prints the median; the spread is in per cent of it. */
static void print_median(double *x, int rounds, int digits)
{
    double median, spread;
    qsort(x, (size_t)rounds, sizeof *x, compare);
    median = x[rounds / 2];
    spread = (x[3 * rounds / 4] - x[rounds / 4]) / 2;
    printf(" %.*f +- %.0f %% |", digits, median, 100 * spread / median);
}

int main(int argc, char **argv)
{
    int rounds = argc > 1 ? atoi(argv[1]) : 101, round, i;
    if (argc > 2 || rounds < 1 || rounds > MAX_ROUNDS) {
        fprintf(stderr, "usage: bench [ROUNDS], 1 to %d\n", MAX_ROUNDS);
        return 2;
    }
    make_input();
    for (round = 0; round < rounds; round++) {
        double bernstein = time_call(&calls[CALLS - 1]);
        for (i = 0; i < CALLS; i++) {
            double t = time_call(&calls[i]);
            nanoseconds[i][round] = t;
            to_memset[i][round] = t / time_memset(&calls[i]);
            to_bernstein[i][round] = t / bernstein;
        }
    }
    printf("| %s | ns | in memsets of its output | in plain Bernstein sums |\n",
           sizeof(n3_real) == 4 ? "float" : "double");
    printf("| --- | --: | --: | --: |\n");
    for (i = 0; i < CALLS; i++) {
        printf("| %s |", calls[i].name);
        print_median(nanoseconds[i], rounds, 1);
        print_median(to_memset[i], rounds, 1);
        print_median(to_bernstein[i], rounds, 2);
        printf("\n");
    }
    printf("\nmedians of %d rounds, checksum %08lx\n\n", rounds, (unsigned long)checksum);
    return 0;
}
