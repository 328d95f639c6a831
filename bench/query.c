/* query [ROUNDS]: what it costs to ask one patch, as a Markdown table on stdout.
 *
 * The patches lie on a torus of radii 2 and 1 and are a quarter wide; points lie off them by up to
 * a tenth, or ten; rays come from two away, to a point of the patch or of another one. Beside each
 * call, in the same round: n3_patch_jet, the price of one look at the surface; and the writing of
 * as many bytes as it returns. The plain way to the nearest point is the nearest of the 2145 points
 * of a lattice of 64, good for two digits. All are the medians over the rounds. */
#define _POSIX_C_SOURCE 199309L
#include "nagata3.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { ITEMS = 256, MAX_ROUNDS = 1000, LATTICE = 64 };

static n3_patch patch[ITEMS];
static n3_vec close_by[ITEMS], far_off[ITEMS], eye[ITEMS], target[ITEMS];
static union answer {
    n3_jet jet;
    n3_box box;
    n3_patch parts[4];
    n3_curvature curvature;
    n3_foot foot;
    n3_hit hit[N3_HITS];
    n3_real number;
    unsigned char byte[sizeof(n3_patch[4])];
} answer[ITEMS];

static const n3_real third = (n3_real)1 / 3;

static void ask_jet(int i) { answer[i].jet = n3_patch_jet(&patch[i], third, third); }
static void ask_box(int i) { answer[i].box = n3_patch_box(&patch[i]); }
static void ask_tight(int i) { answer[i].box = n3_patch_box_tight(&patch[i], third / 300); }
static void ask_flatness(int i) { answer[i].number = n3_patch_flatness(&patch[i]); }
static void ask_split(int i) { n3_patch_split4(&patch[i], answer[i].parts); }
static void ask_curvature(int i)
{
    answer[i].curvature = n3_patch_curvature(&patch[i], third, third);
}
static void ask_near(int i) { answer[i].foot = n3_patch_nearest(&patch[i], close_by[i]); }
static void ask_far(int i) { answer[i].foot = n3_patch_nearest(&patch[i], far_off[i]); }

static void ask_hit(int i)
{
    n3_patch_hits(&patch[i], eye[i], n3_sub(target[i], eye[i]), 0, 9, answer[i].hit);
}

static void ask_miss(int i)
{
    n3_vec along = n3_sub(target[(i + 1) % ITEMS], eye[i]);
    n3_patch_hits(&patch[i], eye[i], along, 0, 9, answer[i].hit);
}

static void ask_folds(int i)
{
    n3_vec normal = n3_sub(eye[i], target[i]);
    answer[i].number = (n3_real)n3_patch_folds(&patch[i], normal, 9);
}

static void ask_volume(int i) { answer[i].number = n3_patch_volume(&patch[i], eye[i], NULL); }
static void ask_area(int i) { answer[i].number = n3_patch_area(&patch[i], third / 300, NULL); }

static void ask_plainly(int i)
{
    n3_foot best = {{0, 0, 0}, 0, 0, 0, 0};
    int a, b;
    for (a = 0; a <= LATTICE; a++)
        for (b = 0; a + b <= LATTICE; b++) {
            n3_foot f = {{0, 0, 0}, (n3_real)a / LATTICE, (n3_real)b / LATTICE, 0, 0};
            n3_vec d;
            f.x = n3_patch_point(&patch[i], f.u, f.v);
            d = n3_sub(f.x, close_by[i]);
            f.distance2 = n3_dot(d, d);
            if (a + b == 0 || f.distance2 < best.distance2) best = f;
        }
    answer[i].foot = best;
}

static const struct {
    const char *name;
    void (*ask)(int);
    size_t bytes;
} calls[] = {{"n3_patch_jet", ask_jet, sizeof(n3_jet)},
             {"n3_patch_box", ask_box, sizeof(n3_box)},
             {"n3_patch_box_tight, 1/900", ask_tight, sizeof(n3_box)},
             {"n3_patch_flatness", ask_flatness, sizeof(n3_real)},
             {"n3_patch_split4", ask_split, sizeof(n3_patch[4])},
             {"n3_patch_curvature", ask_curvature, sizeof(n3_curvature)},
             {"n3_patch_nearest, 0.1 off", ask_near, sizeof(n3_foot)},
             {"n3_patch_nearest, 10 off", ask_far, sizeof(n3_foot)},
             {"nearest of 2145 points", ask_plainly, sizeof(n3_foot)},
             {"n3_patch_hits, one", ask_hit, sizeof(n3_hit)},
             {"n3_patch_hits, none", ask_miss, sizeof(n3_hit)},
             {"n3_patch_folds", ask_folds, sizeof(n3_real)},
             {"n3_patch_volume", ask_volume, sizeof(n3_real)},
             {"n3_patch_area, 1/900", ask_area, sizeof(n3_real)}};
enum { CALLS = sizeof calls / sizeof *calls };

static double times[CALLS][MAX_ROUNDS], in_jets[CALLS][MAX_ROUNDS], in_memsets[CALLS][MAX_ROUNDS];

/* [0, 1), by a linear congruence. */
static double chance(void)
{
    static unsigned long state = 1;
    state = (state * 69069 + 12345) & 0xffffffff;
    return (double)(state >> 8) / 16777216;
}

static n3_vertex on_torus(double a, double b)
{
    n3_vertex v;
    v.n = n3_v((n3_real)(cos(b) * cos(a)), (n3_real)(cos(b) * sin(a)), (n3_real)sin(b));
    v.x = n3_add(v.n, n3_v((n3_real)(2 * cos(a)), (n3_real)(2 * sin(a)), 0));
    return v;
}

static void make_input(void)
{
    int i;
    for (i = 0; i < ITEMS; i++) {
        double a = 6 * chance(), b = 6 * chance(), u = chance(), v = chance() * (1 - u);
        n3_vec n;
        patch[i] = n3_patch_make(on_torus(a, b), on_torus(a + 0.1, b), on_torus(a, b + 0.25), NULL);
        n = n3_patch_normal(&patch[i], (n3_real)u, (n3_real)v);
        target[i] = n3_patch_point(&patch[i], (n3_real)u, (n3_real)v);
        close_by[i] = n3_add(target[i], n3_mul((n3_real)(0.2 * chance() - 0.1), n));
        far_off[i] = n3_add(target[i], n3_mul((n3_real)(20 * chance() - 10), n));
        n = n3_add(n, n3_v((n3_real)(chance() / 2), (n3_real)(chance() / 2), 0));
        eye[i] = n3_add(target[i], n3_mul(2, n));
    }
}

/* Nanoseconds for each answer; a first pass brings code and data into the caches. */
static double time_call(int c)
{
    struct timespec start, stop;
    int i;
    for (i = 0; i < ITEMS; i++) calls[c].ask(i);
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (i = 0; i < ITEMS; i++) calls[c].ask(i);
    clock_gettime(CLOCK_MONOTONIC, &stop);
    return (1e9 * (double)(stop.tv_sec - start.tv_sec) + (double)(stop.tv_nsec - start.tv_nsec)) /
           ITEMS;
}

static double time_memset(size_t bytes)
{
    void *(*volatile set)(void *, int, size_t) = memset;
    struct timespec start, stop;
    int i;
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (i = 0; i < ITEMS; i++) set(answer[i].byte, 0x5a, bytes);
    clock_gettime(CLOCK_MONOTONIC, &stop);
    return (1e9 * (double)(stop.tv_sec - start.tv_sec) + (double)(stop.tv_nsec - start.tv_nsec)) /
           ITEMS;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x, int rounds)
{
    qsort(x, (size_t)rounds, sizeof *x, compare);
    return x[rounds / 2];
}

int main(int argc, char **argv)
{
    int rounds = argc > 1 ? atoi(argv[1]) : 101, round, i;
    if (argc > 2 || rounds < 1 || rounds > MAX_ROUNDS) {
        fprintf(stderr, "usage: query [ROUNDS], 1 to %d\n", MAX_ROUNDS);
        return 2;
    }
    make_input();
    for (round = 0; round < rounds; round++)
        for (i = 0; i < CALLS; i++) {
            times[i][round] = time_call(i);
            in_jets[i][round] = times[i][round] / times[0][round];
            in_memsets[i][round] = times[i][round] / time_memset(calls[i].bytes);
        }
    printf("| asked of one patch, %s | ns | in n3_patch_jet | in memsets of its output |\n",
           sizeof(n3_real) == 4 ? "float" : "double");
    printf("| --- | --: | --: | --: |\n");
    for (i = 0; i < CALLS; i++)
        printf("| %s | %.0f | %.2f | %.0f |\n", calls[i].name, median(times[i], rounds),
               median(in_jets[i], rounds), median(in_memsets[i], rounds));
    printf("\n");
    return 0;
}
