/* scale [TRIANGLES]: what a mesh costs, from 10 thousand triangles up to TRIANGLES, 4 million at
 * first, as a Markdown table on stdout.
 *
 * A torus of quadrilaterals split in two goes through topology, normals, net and refinement by two,
 * and instead to a distance that makes five facets of each, without normals and with them. A stage's
 * time stands as nanoseconds per triangle, after the net per facet made, and as a multiple of a
 * memset of 0x5a of the bytes that it writes, on memory that was touched before; the best of the
 * rounds counts. The bytes are all that the caller holds at once: mesh, workspace and results. */
#define _POSIX_C_SOURCE 199309L
#include "torus.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { TOPOLOGY, NORMALS, NET, REFINE, CUT, CUT_NORMALS, STAGES };
enum { ROUNDS = 3, LEVEL = 2, MOST = 8, SMALLEST = 10000, LARGEST = 4000000 };

static const char *const stage_name[STAGES] = {"topology", "normals", "net",
                                               "refine",   "cut",     "cut with normals"};

/* Everything that the caller holds. */
typedef struct job {
    n3_mesh mesh, smooth; /* smooth has the normals too */
    n3_topology topology;
    n3_vec *point, *normal, *net, *fine, *fine_normal;
    int *triangle, *corner, *work, *fine_triangle, *fine_corner;
    int fine_points, fine_triangles, fine_normals;
    n3_cut *cut;
    size_t work_size, bytes;
} job;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Touched memory, counted. */
static void *room(job *j, size_t count, size_t size)
{
    void *p = malloc(count * size);
    if (!p) {
        fprintf(stderr, "scale: out of memory\n");
        exit(1);
    }
    j->bytes += count * size;
    return memset(p, 0, count * size);
}

/* Room for a torus of n * n points; its edges are three times as many. */
static void job_make(job *j, int n)
{
    size_t points = (size_t)n * (size_t)n, triangles = 2 * points, edges = 3 * points;
    memset(j, 0, sizeof *j);
    j->mesh.points = n * n;
    j->mesh.triangles = 2 * n * n;
    j->work_size = n3_mesh_workspace(&j->mesh);
    j->point = (n3_vec *)room(j, points, sizeof(n3_vec));
    j->triangle = (int *)room(j, triangles, 3 * sizeof(int));
    j->work = (int *)room(j, j->work_size, 1);
    j->normal = (n3_vec *)room(j, 3 * triangles, sizeof(n3_vec));
    j->corner = (int *)room(j, triangles, 3 * sizeof(int));
    j->net = (n3_vec *)room(j, points + 2 * edges + triangles, sizeof(n3_vec));
    j->fine = (n3_vec *)room(j, MOST / 2 * triangles, sizeof(n3_vec));
    j->fine_triangle = (int *)room(j, MOST * triangles, 3 * sizeof(int));
    j->fine_normal = (n3_vec *)room(j, MOST * triangles, sizeof(n3_vec));
    j->fine_corner = (int *)room(j, MOST * triangles, 3 * sizeof(int));
    j->cut = (n3_cut *)room(j, edges + triangles, sizeof(n3_cut));
    torus_make(n, n, j->point, NULL, j->triangle);
    j->mesh.point = &j->point->x;
    j->mesh.triangle = j->triangle;
    j->smooth = j->mesh;
    j->smooth.normal = &j->normal->x;
    j->smooth.corner = j->corner;
}

static void job_free(job *j)
{
    free(j->point);
    free(j->triangle);
    free(j->work);
    free(j->normal);
    free(j->corner);
    free(j->net);
    free(j->fine);
    free(j->fine_triangle);
    free(j->fine_normal);
    free(j->fine_corner);
    free(j->cut);
}

/* The distance falls as the squares of the edges, so that every mesh is cut alike. */
static n3_status cut(job *j, n3_vec *normal, int *corner)
{
    const int most = MOST * j->mesh.triangles;
    const n3_real distance = 8 / (n3_real)j->mesh.triangles;
    n3_status status = n3_mesh_cut(&j->smooth, &j->topology, j->net, distance, j->cut,
                                   &j->fine_points, &j->fine_triangles, &j->fine_normals, NULL);
    if (status != N3_OK) return status;
    if (j->fine_points > most / 2 || j->fine_triangles > most || j->fine_normals > most)
        return N3_BAD_COUNT;
    return n3_mesh_refine_cut(&j->smooth, &j->topology, j->net, j->cut, j->fine, j->fine_triangle,
                              normal, corner, NULL, NULL, NULL);
}

static n3_status run_stage(job *j, int stage)
{
    if (stage == TOPOLOGY)
        return n3_mesh_topology(&j->mesh, j->work, j->work_size, &j->topology, NULL);
    if (stage == NORMALS)
        return n3_mesh_normals(&j->mesh, &j->topology, -1, NULL, j->normal, j->corner,
                               &j->smooth.normals, NULL);
    if (stage == NET) return n3_mesh_net(&j->smooth, &j->topology, NULL, j->net, NULL, NULL);
    if (stage == CUT) return cut(j, NULL, NULL);
    if (stage == CUT_NORMALS) return cut(j, j->fine_normal, j->fine_corner);
    n3_mesh_refine_counts(&j->smooth, &j->topology, LEVEL, &j->fine_points, &j->fine_triangles,
                          NULL);
    return n3_mesh_refine(&j->smooth, &j->topology, j->net, LEVEL, j->fine, j->fine_triangle, NULL,
                          NULL, NULL, NULL);
}

/* Seconds for a byte, over the room of the net. */
static double time_memset(job *j)
{
    void *(*volatile set)(void *, int, size_t) = memset;
    size_t bytes = (size_t)n3_mesh_nodes(&j->mesh, &j->topology) * sizeof(n3_vec);
    double start = now();
    set(j->net, 0x5a, bytes);
    return (now() - start) / (double)bytes;
}

/* By the last run of the stage. */
static double bytes_written(const job *j, int stage)
{
    double triangles = j->mesh.triangles, vec = sizeof(n3_vec), indices = 3 * sizeof(int), bytes;
    if (stage == TOPOLOGY) return (double)j->work_size;
    if (stage == NORMALS) return j->smooth.normals * vec + triangles * indices;
    if (stage == NET) return n3_mesh_nodes(&j->mesh, &j->topology) * vec;
    bytes = j->fine_points * vec + j->fine_triangles * indices;
    if (stage == REFINE) return bytes;
    bytes += (double)(j->topology.edges + j->mesh.triangles) * sizeof(n3_cut);
    if (stage == CUT) return bytes;
    return bytes + j->fine_normals * vec + j->fine_triangles * indices;
}

static double time_stage(job *j, int stage)
{
    double start = now();
    if (run_stage(j, stage) != N3_OK) {
        fprintf(stderr, "scale: %s failed\n", stage_name[stage]);
        exit(1);
    }
    return now() - start;
}

/* Seconds, triangles taken or facets made, and bytes written; for a byte, the memset's come last. */
typedef struct result { double seconds, units, bytes; } result;

/* The best of the rounds. */
static void run_job(job *j, result best[STAGES + 1])
{
    int round, s;
    for (round = 0; round < ROUNDS; round++)
        for (s = 0; s <= STAGES; s++) {
            double seconds = s < STAGES ? time_stage(j, s) : time_memset(j);
            if (round && seconds >= best[s].seconds) continue;
            best[s].seconds = seconds;
            best[s].units = s < REFINE ? j->mesh.triangles : j->fine_triangles;
            best[s].bytes = s < STAGES ? bytes_written(j, s) : 1;
        }
}

static void print_row(const job *j, const result best[STAGES + 1])
{
    double triangles = j->mesh.triangles, seconds = 0;
    int s;
    printf("| %d |", j->mesh.triangles);
    for (s = 0; s < STAGES; s++)
        printf(" %.0f (%.0f) |", 1e9 * best[s].seconds / best[s].units,
               best[s].seconds / (best[STAGES].seconds * best[s].bytes));
    for (s = 0; s <= REFINE; s++) seconds += best[s].seconds;
    printf(" %.2f | %.0f |\n", triangles / seconds / 1e6, (double)j->bytes / triangles);
}

int main(int argc, char **argv)
{
    int largest = argc > 1 ? atoi(argv[1]) : LARGEST, triangles, s;
    if (argc > 2 || largest < SMALLEST || largest > LARGEST) {
        fprintf(stderr, "usage: scale [TRIANGLES], %d to %d\n", SMALLEST, LARGEST);
        return 2;
    }
    printf("| triangles |");
    for (s = 0; s < STAGES; s++) printf(" %s, ns (memsets) |", stage_name[s]);
    printf(" million triangles/s, refined | bytes/triangle |\n| --: |");
    for (s = 0; s < STAGES; s++) printf(" --: |");
    printf(" --: | --: |\n");
    for (triangles = SMALLEST; triangles <= largest; triangles *= triangles < 1000000 ? 10 : 4) {
        result best[STAGES + 1];
        job j;
        job_make(&j, (int)sqrt(triangles / 2.0));
        run_job(&j, best);
        print_row(&j, best);
        job_free(&j);
    }
    return 0;
}
