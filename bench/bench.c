/* bench [ROUNDS [FILE]]: what each call costs, as a Markdown table on stdout and as CSV in FILE.
 * bench --list, bench --count NAME: the names; one call alone, for counting its instructions.
 *
 * An item is data: its name, its unit, the call on a range of triangles, and the naive form of the
 * same. Every round times, on memory that was touched before, each item on a mesh whose output fits
 * the second cache and on one of 20,480 triangles, of whose points, 11 to 44 MB, no more than the
 * third could keep a part; its naive form; the writing of as many bytes, by memset of 0x5a (zeros
 * have a short cut in some machines) in the cache and past the caches beyond; and the item on two
 * threads, beside a chain of multiplications and additions that nothing but the cores can hold up.
 * Columns are medians over the rounds, with half the distance between the quartiles; ratios compare
 * times of the same round. */
#define _POSIX_C_SOURCE 200112L
#include "naive.h"
#include "torus.h"

#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

enum { LEVEL = 8, POINTS = 45, SUBS = 64, MAX_ROUNDS = 1000, MAX_ITEMS = 64 };

/* A torus, its patches, and room for what the items write. */
typedef struct job {
    int triangles;
    n3_mesh mesh, creased;
    n3_topology topology;
    n3_vec *x, *n, *net;
    n3_patch *patch;
    int *triangle, *corner, *work, *parent, *index; /* 3 * SUBS for a triangle */
    n3_real *uv;
    char *out; /* 2 * POINTS vectors for a triangle */
} job;

static job cached, beyond, *now_on;

/* ---- The items; each works on the triangles first up to last of now_on ---- */

static n3_vec *out_points(int first) { return (n3_vec *)(void *)now_on->out + POINTS * first; }
static n3_vec *out_normals(int first) { return out_points(now_on->triangles + first); }

static n3_vertex corner(int f, int i)
{
    int k = now_on->triangle[3 * f + i];
    n3_vertex v;
    v.x = now_on->x[k];
    v.n = now_on->n[k];
    return v;
}

static void edge_plain(int first, int last)
{
    n3_edge *out = (n3_edge *)(void *)now_on->out;
    for (; first < last; first++)
        out[first] = n3_edge_make(corner(first, 0), corner(first, 1), NULL);
}

static void patch_plain(int first, int last)
{
    n3_patch *out = (n3_patch *)(void *)now_on->out;
    for (; first < last; first++)
        out[first] = n3_patch_make(corner(first, 0), corner(first, 1), corner(first, 2), NULL);
}

static void naive_patches(int first, int last)
{
    n3_patch *out = (n3_patch *)(void *)now_on->out;
    for (; first < last; first++)
        naive_patch(now_on->x, now_on->n, now_on->triangle + 3 * first, out[first].p);
}

/* The edges in proportion. */
static void net_of(const n3_mesh *m, int rule, int first, int last)
{
    n3_options o = {0, 0, 0};
    const job *j = now_on;
    o.rule = rule;
    n3_mesh_edges(m, &j->topology, &o, first / 2 * 3, last / 2 * 3, j->net, NULL);
    n3_mesh_centres(m, &j->topology, &o, first, last, j->net);
}

static void net_by(int rule, int first, int last) { net_of(&now_on->mesh, rule, first, last); }
static void net_paper(int first, int last) { net_by(N3_RULE_PAPER, first, last); }
static void net_arc(int first, int last) { net_by(N3_RULE_ARC, first, last); }
static void net_fit(int first, int last) { net_by(N3_RULE_FIT, first, last); }

static void net_creased(int first, int last)
{
    net_of(&now_on->creased, N3_RULE_PAPER, first, last);
}

static void patches(int first, int last)
{
    net_by(N3_RULE_PAPER, first, last);
    n3_mesh_patches(&now_on->mesh, &now_on->topology, now_on->net, first, last,
                    (n3_patch *)(void *)now_on->out + first);
}

static void points(int first, int last)
{
    n3_lattice_points(now_on->patch, first, last, LEVEL, out_points(first));
}

static void normals(int first, int last)
{
    n3_lattice_normals(now_on->patch, first, last, LEVEL, out_normals(first));
}

/* In as much room. */
static void point_blocks(int first, int last)
{
    n3_lattice_point_blocks(now_on->patch, first, last, LEVEL, &out_points(first)->x);
}

static void points_normals_blocks(int first, int last)
{
    point_blocks(first, last);
    n3_lattice_normal_blocks(now_on->patch, first, last, LEVEL, &out_normals(first)->x);
}

static void points_normals(int first, int last)
{
    points(first, last);
    normals(first, last);
}

static void indices(int first, int last)
{
    n3_lattice_triangles(first, last, LEVEL, now_on->index + 3 * SUBS * first);
}

static void whole_mesh(int first, int last)
{
    points_normals(first, last);
    indices(first, last);
}

#define AT_LATTICE(out, function)                                                                  \
    n3_vec *to = out(first);                                                                       \
    int i, j;                                                                                      \
    for (; first < last; first++) {                                                                \
        n3_patch p = now_on->patch[first];                                                         \
        for (j = 0; j <= LEVEL; j++)                                                               \
            for (i = 0; i <= LEVEL - j; i++)                                                       \
                *to++ = function(&p, (n3_real)i / LEVEL, (n3_real)j / LEVEL);                      \
    }

static void naive_points(int first, int last) { AT_LATTICE(out_points, naive_point) }
static void naive_normals(int first, int last) { AT_LATTICE(out_normals, naive_normal) }

static void naive_points_normals(int first, int last)
{
    naive_points(first, last);
    naive_normals(first, last);
}

static void point_plain(int first, int last) { AT_LATTICE(out_points, n3_patch_point) }
static void normal_plain(int first, int last) { AT_LATTICE(out_points, n3_patch_normal) }

static void scattered_points(int first, int last)
{
    n3_patch_points(now_on->patch, now_on->parent, now_on->uv, first, last, out_points(0) + first);
}

static void scattered_normals(int first, int last)
{
    n3_patch_normals(now_on->patch, now_on->parent, now_on->uv, first, last, out_points(0) + first);
}

static void scattered_jets(int first, int last)
{
    n3_patch_jets(now_on->patch, now_on->parent, now_on->uv, first, last,
                  (n3_jet *)(void *)now_on->out + first);
}

#define AT_SCATTERED(type, function)                                                               \
    type *to = (type *)(void *)now_on->out;                                                        \
    for (; first < last; first++)                                                                  \
        to[first] = function(now_on->patch + now_on->parent[first], now_on->uv[2 * first],         \
                             now_on->uv[2 * first + 1])

static void naive_scattered_points(int first, int last) { AT_SCATTERED(n3_vec, naive_point); }
static void naive_scattered_normals(int first, int last) { AT_SCATTERED(n3_vec, naive_normal); }
static void jet_plain(int first, int last) { AT_SCATTERED(n3_jet, n3_patch_jet); }

typedef void range(int first, int last);

/* units for a triangle; bytes written for a unit; large: measured beyond the caches too. reference:
   ns of the naive form on a Zen 4 core of 3.6 GHz, gcc 12 -O3, double and float; 0: none. */
typedef struct item {
    const char *name, *unit;
    range *run, *naive;
    int units, bytes, large;
    double reference[2];
} item;

enum { VEC = sizeof(n3_vec) };

static const item items[] = {
    {"n3_edge_make", "edge", edge_plain, NULL, 1, 4 * VEC, 0, {0, 0}},
    {"n3_patch_make", "patch", patch_plain, naive_patches, 1, 10 * VEC, 0, {152, 115}},
    {"net", "triangle", net_paper, naive_patches, 1, 4 * VEC, 1, {152, 115}},
    {"net and patches", "triangle", patches, naive_patches, 1, 14 * VEC, 0, {152, 115}},
    {"net by arc", "triangle", net_arc, NULL, 1, 4 * VEC, 0, {0, 0}},
    {"net by fit", "triangle", net_fit, NULL, 1, 4 * VEC, 0, {0, 0}},
    {"net with creases", "triangle", net_creased, NULL, 1, 4 * VEC, 1, {0, 0}},
    {"n3_patch_point", "point", point_plain, naive_points, POINTS, VEC, 0, {5.3, 4.0}},
    {"n3_patch_normal", "normal", normal_plain, naive_normals, POINTS, VEC, 0, {0, 0}},
    {"lattice points", "point", points, naive_points, POINTS, VEC, 1, {5.3, 4.0}},
    {"lattice points and normals", "point", points_normals, naive_points_normals, POINTS, 2 * VEC,
     1, {15.7, 13.4}},
    {"point blocks", "point", point_blocks, naive_points, POINTS, VEC, 1, {5.3, 4.0}},
    {"point and normal blocks", "point", points_normals_blocks, naive_points_normals, POINTS,
     2 * VEC, 1, {15.7, 13.4}},
    {"lattice triangles", "triangle", indices, NULL, SUBS, 3 * sizeof(int), 0, {0, 0}},
    {"points normals triangles", "triangle", whole_mesh, naive_points_normals, SUBS,
     (2 * VEC * POINTS + 3 * SUBS * (int)sizeof(int)) / SUBS, 1, {0, 0}},
    {"scattered points", "point", scattered_points, naive_scattered_points, 1, VEC, 0, {0, 0}},
    {"scattered normals", "normal", scattered_normals, naive_scattered_normals, 1, VEC, 0, {0, 0}},
    {"scattered jets", "jet", scattered_jets, jet_plain, 1, 6 * VEC, 0, {0, 0}},
};
enum { ITEMS = sizeof items / sizeof *items };

/* ---- The meshes ---- */

/* From a line of the caches on. */
static void *room(size_t size)
{
    void *p;
    if (posix_memalign(&p, 64, size)) {
        fprintf(stderr, "bench: out of memory\n");
        exit(1);
    }
    return memset(p, 0x5a, size);
}

/* splitmix64, into [0, 1). */
static n3_real random_real(void)
{
    static uint64_t state = 1;
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (n3_real)((z ^ (z >> 31)) >> 40) / 16777216;
}

/* The same mesh with a band in eight leaning out, which makes one edge in twelve a crease, and a
   name for each corner's normal. */
static void make_creases(job *j, int nv)
{
    const int points = j->mesh.points, sides = 3 * j->triangles;
    int i;
    j->corner = (int *)room((size_t)sides * sizeof(int));
    for (i = 0; i < points; i++) j->n[points + i] = n3_unit(n3_add(j->n[i], n3_v(0, 0, 1)));
    for (i = 0; i < sides; i++)
        j->corner[i] = j->triangle[i] + (i / (6 * nv) % 8 == 0 ? points : 0);
    j->creased = j->mesh;
    j->creased.normals = 2 * points;
    j->creased.corner = j->corner;
}

static void make_job(job *j, int nu, int nv)
{
    n3_mesh *m = &j->mesh;
    size_t points = (size_t)nu * (size_t)nv, triangles = 2 * points;
    int i;
    memset(j, 0, sizeof *j);
    j->x = (n3_vec *)room(points * VEC);
    j->n = (n3_vec *)room(2 * points * VEC);
    j->triangle = (int *)room(triangles * 3 * sizeof(int));
    torus_make(nu, nv, j->x, j->n, j->triangle);
    j->triangles = m->triangles = (int)triangles;
    m->points = m->normals = (int)points;
    m->point = &j->x->x;
    m->normal = &j->n->x;
    m->triangle = j->triangle;
    j->work = (int *)room(n3_mesh_workspace(m));
    j->net = (n3_vec *)room((points + 6 * points + triangles) * VEC);
    j->patch = (n3_patch *)room(triangles * sizeof(n3_patch));
    j->index = (int *)room(triangles * 3 * SUBS * sizeof(int));
    j->out = (char *)room(triangles * 2 * POINTS * VEC);
    j->parent = (int *)room(triangles * sizeof(int));
    j->uv = (n3_real *)room(triangles * 2 * sizeof(n3_real));
    make_creases(j, nv);
    n3_mesh_topology(m, j->work, n3_mesh_workspace(m), &j->topology, NULL);
    n3_mesh_net(m, &j->topology, NULL, j->net, NULL, NULL);
    n3_mesh_patches(m, &j->topology, j->net, 0, m->triangles, j->patch);
    for (i = 0; i < m->triangles; i++) {
        j->parent[i] = (int)((n3_real)m->triangles * random_real());
        j->uv[2 * i] = random_real();
        j->uv[2 * i + 1] = (1 - j->uv[2 * i]) * random_real();
    }
}

/* ---- Timing ---- */

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* A part of a range, over and over. run NULL: the chain of multiplications and additions. */
typedef struct task { range *run; int first, last, repeats; } task;

static volatile double chain_end;

static void run_chain(int steps)
{
    double x[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    int i, k;
    for (i = 0; i < steps; i++)
        for (k = 0; k < 8; k++) x[k] = x[k] * 0.999 + 0.5;
    for (k = 0; k < 8; k++) chain_end = x[k];
}

static void *run_task(void *data)
{
    const task *t = (const task *)data;
    int i;
    for (i = 0; i < t->repeats; i++)
        if (t->run) t->run(t->first, t->last);
        else run_chain(10000);
    return NULL;
}

/* Nanoseconds for all repeats of the range, or of chains, shared out among the threads. */
static double time_range(range *run, int threads, int repeats)
{
    pthread_t thread;
    task t[2];
    double start;
    int i, half = now_on->triangles / 2;
    for (i = 0; i < 2; i++) {
        t[i].run = run;
        t[i].first = i * half;
        t[i].last = i || threads == 1 ? now_on->triangles : half;
        t[i].repeats = run ? repeats : repeats / threads;
    }
    t[1].first = threads == 1 ? 0 : half;
    start = now();
    if (threads == 2 && pthread_create(&thread, NULL, run_task, &t[0])) exit(1);
    run_task(&t[1]);
    if (threads == 2) pthread_join(thread, NULL);
    return now() - start;
}

/* As many bytes as a range writes: in the caches, or past them. */
static void fill(char *out, size_t bytes, int past)
{
    void *(*volatile set)(void *, int, size_t) = memset;
#ifdef __SSE2__
    __m128i x = _mm_set1_epi8(0x5a);
    size_t i;
    for (i = 0; past && i + 16 <= bytes; i += 16) _mm_stream_si128((__m128i *)(void *)(out + i), x);
    if (past) return;
#endif
    (void)past;
    set(out, 0x5a, bytes);
}

static double time_fill(size_t bytes, int past, int repeats)
{
    double start = now();
    int i;
    for (i = 0; i < repeats; i++) fill(now_on->out, bytes, past);
    return now() - start;
}

/* ---- Results ---- */

enum { TIME, NAIVE, FILL, TO_NAIVE, TO_FILL, THREADS, COLUMNS };
static double result[2][ITEMS][COLUMNS][MAX_ROUNDS], chain[MAX_ROUNDS];

/* Repeats that take six milliseconds. */
static int repeats_of(range *run)
{
    double t = time_range(run, 1, 1);
    return 1 + (int)(6e6 / t);
}

static void measure(int which, int round)
{
    int i;
    now_on = which ? &beyond : &cached;
    for (i = 0; i < ITEMS; i++) {
        const item *c = &items[i];
        double units = (double)now_on->triangles * c->units, t, filled, naive = 0;
        size_t bytes = (size_t)units * (size_t)c->bytes;
        int repeats;
        if (which && !c->large) continue;
        if (bytes > (size_t)now_on->triangles * 2 * POINTS * VEC)
            bytes = (size_t)now_on->triangles * 2 * POINTS * VEC;
        repeats = repeats_of(c->run);
        t = time_range(c->run, 1, repeats) / repeats;
        filled = time_fill(bytes, which, repeats) / repeats * units * c->bytes / (double)bytes;
        if (c->naive && !which)
            naive = time_range(c->naive, 1, 1 + repeats / 4) / (1 + repeats / 4);
        result[which][i][TIME][round] = t / units;
        result[which][i][NAIVE][round] = naive / units;
        result[which][i][FILL][round] = filled / units;
        result[which][i][TO_NAIVE][round] = naive / t;
        result[which][i][TO_FILL][round] = filled / t;
        result[which][i][THREADS][round] = t * repeats / time_range(c->run, 2, repeats);
    }
    chain[round] = time_range(NULL, 1, 100) / time_range(NULL, 2, 100);
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The median; the spread in per cent of it. */
static double median(double *x, int rounds, double *spread)
{
    qsort(x, (size_t)rounds, sizeof *x, compare);
    *spread = 50 * (x[3 * rounds / 4] - x[rounds / 4]) / x[rounds / 2];
    return x[rounds / 2];
}

/* Over all that the items wrote, so that no compiler can leave it out. */
static unsigned long checksum(const job *j)
{
    size_t i, bytes = (size_t)j->triangles * 2 * POINTS * VEC;
    uint32_t sum = 2166136261u;
    for (i = 0; i < bytes; i += 8) sum = (sum ^ (unsigned char)j->out[i]) * 16777619u;
    return sum;
}

static void print_row(int which, int i, int rounds, FILE *csv)
{
    const item *c = &items[i];
    double x[COLUMNS], spread[COLUMNS], reference = c->reference[sizeof(n3_real) == 4];
    const char *where = which ? "memory" : "cache";
    const char *type = sizeof(n3_real) == 4 ? "float" : "double";
    int k;
    for (k = 0; k < COLUMNS; k++) x[k] = median(result[which][i][k], rounds, &spread[k]);
    if (csv)
        fprintf(csv, "%s,%s,%s,%s,%.4g,%.1f,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g\n", c->name, c->unit,
                type, where, x[TIME], spread[TIME], c->bytes / x[TIME], x[TO_FILL], x[NAIVE],
                reference, x[TO_NAIVE], x[THREADS]);
    printf("| %s | %s | %.2f +- %.0f %% | %.2f | %.0f %% |", c->name, where, x[TIME], spread[TIME],
           c->bytes / x[TIME], 100 * x[TO_FILL]);
    if (x[NAIVE] > 0 && reference > 0)
        printf(" %.1f (%.1f) | %.1f +- %.0f %% |", x[NAIVE], reference, x[TO_NAIVE],
               spread[TO_NAIVE]);
    else if (x[NAIVE] > 0)
        printf(" %.1f | %.1f +- %.0f %% |", x[NAIVE], x[TO_NAIVE], spread[TO_NAIVE]);
    else printf(" | |");
    printf(" %.2f |\n", x[THREADS]);
}

static void print_table(int rounds, FILE *csv)
{
    double spread, two = median(chain, rounds, &spread);
    int which, i;
    if (csv)
        fprintf(csv, "item,unit,type,where,ns,spread %%,GB/s,share of fill,naive ns,reference ns,"
                     "times naive,two threads\n");
    printf("| %s | | ns | GB/s | of a fill | naive (reference) | times naive | 2 threads |\n"
           "| --- | --- | --: | --: | --: | --: | --: | --: |\n",
           sizeof(n3_real) == 4 ? "float" : "double");
    for (which = 0; which < 2; which++)
        for (i = 0; i < ITEMS; i++)
            if (!which || items[i].large) print_row(which, i, rounds, csv);
    if (csv) fprintf(csv, "multiply and add,step,double,cache,,,,,,,,%.4g\n", two);
    printf("\nmedians of %d rounds; two threads of multiplications and additions: %.2f; "
           "checksum %08lx\n\n",
           rounds, two, checksum(&cached));
}

/* Where a profiler begins and stops to count. */
static void counted(range *run) { run(0, now_on->triangles); }

/* One call on the small mesh, and its units. */
static int count(const char *name)
{
    void (*volatile call)(range *run) = counted; /* not inlined */
    int i;
    make_job(&cached, 8, 8);
    now_on = &cached;
    for (i = 0; i < ITEMS; i++) {
        if (strcmp(items[i].name, name) != 0) continue;
        call(items[i].run);
        printf("%d\n", cached.triangles * items[i].units);
        return 0;
    }
    return 2;
}

int main(int argc, char **argv)
{
    int rounds = 21, round, i;
    FILE *csv = NULL;
    if (argc == 2 && strcmp(argv[1], "--list") == 0) {
        for (i = 0; i < ITEMS; i++) printf("%s\n", items[i].name);
        return 0;
    }
    if (argc == 3 && strcmp(argv[1], "--count") == 0) return count(argv[2]);
    if (argc > 1) rounds = atoi(argv[1]);
    if (argc > 3 || rounds < 1 || rounds > MAX_ROUNDS) {
        fprintf(stderr, "usage: bench [ROUNDS [FILE]], 1 to %d\n", MAX_ROUNDS);
        return 2;
    }
    if (argc == 3 && (csv = fopen(argv[2], "w")) == NULL) {
        perror(argv[2]);
        return 1;
    }
    make_job(&cached, 8, 8);
    make_job(&beyond, 128, 80);
    for (round = 0; round < rounds; round++) {
        measure(0, round);
        measure(1, round);
    }
    print_table(rounds, csv);
    return csv && fclose(csv) ? 1 : 0;
}
