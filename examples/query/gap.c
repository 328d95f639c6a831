/* gap: how well a contact search between two smooth bodies knows the gap between them, where both
 * are given as coarse meshes.
 *
 * From every place of one body, its vertices and points between them, the nearest point of the
 * other is looked for, among flat triangles and among patches with the same corners. The table has
 * the largest error of the gap against that between the bodies themselves, at the places of the
 * first body where the gap is below twice the least one. */
#include "mesh.h"
#include "tree.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const char program[] = "gap";

enum { FLAT, PAPER, ARC, WAYS, SAMPLES = 6 };

/* A sphere of radius 1 round a centre on the x axis, or a pipe of radius 1 + 1/10 round it, seen
   from inside. */
typedef struct body {
    const char *name;
    int pipe;
    double centre, radius;
} body;

static n3_vec vec(double x, double y, double z) { return n3_v((n3_real)x, (n3_real)y, (n3_real)z); }

/* The body's point and normal that belong to a place p of its parametrisation: on a sphere the
   direction of p; on a pipe the angle p.y and the place p.z along it. */
static n3_vertex on_body(const body *b, n3_vec p)
{
    n3_vertex v;
    n3_vec n = b->pipe ? vec(cos((double)p.y), sin((double)p.y), 0) : n3_unit(p);
    v.x = n3_add(vec(b->centre, 0, b->pipe ? (double)p.z : 0), n3_mul((n3_real)b->radius, n));
    v.n = b->pipe ? n3_mul(-1, n) : n;
    return v;
}

/* Distance of a point to the body, positive on the side of the normals. */
static double distance_to(const body *b, n3_vec x)
{
    n3_vec d = n3_sub(x, vec(b->centre, 0, 0));
    double from_axis = b->pipe ? hypot((double)d.x, (double)d.y) : (double)n3_len(d);
    return b->pipe ? b->radius - from_axis : from_axis - b->radius;
}

/* Places of the corners of a triangle of the body's mesh. */
typedef struct triangle {
    n3_vec p[3];
} triangle;

/* n x n triangles over each face of an octahedron. */
static int octahedron(int n, triangle *out)
{
    int face, i, k, side, count = 0;
    for (face = 0; face < 8; face++)
        for (i = 0; i < n; i++)
            for (k = 0; i + k < n; k++)
                for (side = 0; side < (i + k + 1 < n ? 2 : 1); side++) {
                    static const int at[2][3][2] = {{{0, 0}, {1, 0}, {0, 1}},
                                                    {{1, 1}, {0, 1}, {1, 0}}};
                    int c;
                    for (c = 0; c < 3; c++) {
                        int a = i + at[side][c][0], b = k + at[side][c][1], d = n - a - b;
                        out[count].p[c] =
                            vec(face & 1 ? -a : a, face & 2 ? -b : b, face & 4 ? -d : d);
                    }
                    count++;
                }
    return count;
}

/* 4 n parts round the pipe, and n along. */
static int grid(int n, triangle *out)
{
    static const int at[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
    const double turn = 2 * acos(-1.0) / (4 * n), step = 3.0 / n;
    int i, k, side, c, count = 0;
    for (i = 0; i < 4 * n; i++)
        for (k = 0; k < n; k++)
            for (side = 0; side < 2; side++, count++)
                for (c = 0; c < 3; c++)
                    out[count].p[c] = vec(0, turn * (i + at[side][c][0] + 0.5),
                                          step * (k + at[side][c][1]) - 1.5);
    return count;
}

/* The corners run round the body's normal. */
static void turn_outwards(const body *b, triangle *t, int count)
{
    int i, k;
    for (i = 0; i < count; i++) {
        n3_vertex v[3];
        n3_vec swapped = t[i].p[1];
        for (k = 0; k < 3; k++) v[k] = on_body(b, t[i].p[k]);
        if (n3_dot(n3_cross(n3_sub(v[1].x, v[0].x), n3_sub(v[2].x, v[0].x)), v[0].n) > 0) continue;
        t[i].p[1] = t[i].p[2];
        t[i].p[2] = swapped;
    }
}

static n3_patch patch_of(const body *b, const triangle *t, int way)
{
    const n3_options arc = {N3_RULE_ARC, 0, 0};
    n3_vertex v[3];
    int i;
    for (i = 0; i < 3; i++) {
        v[i] = on_body(b, t->p[i]);
        if (way == FLAT) v[i].n = n3_v(0, 0, 0);
    }
    return n3_patch_make(v[0], v[1], v[2], way == ARC ? &arc : NULL);
}

/* The largest error of the gap over the places of a triangle of the first body, a sphere round the
   origin: against that from the point of the sphere in the same direction. */
static double worst_gap(const body *a, const body *b, const triangle *t, const tree *other, int way)
{
    n3_patch p = patch_of(a, t, way);
    const double least = 0.1;
    double worst = 0;
    int i, k;
    for (i = 0; i <= SAMPLES; i++)
        for (k = 0; i + k <= SAMPLES; k++) {
            n3_real u = (n3_real)i / SAMPLES, v = (n3_real)k / SAMPLES;
            n3_vec x = n3_patch_point(&p, u, v);
            double want = distance_to(b, on_body(a, x).x), gap;
            n3_foot foot;
            if (want > 2 * least) continue;
            tree_nearest(other, x, &foot);
            gap = sqrt((double)foot.distance2) * (foot.side < 0 ? -1 : 1);
            if (fabs(gap - want) > worst) worst = fabs(gap - want);
        }
    return worst;
}

static void print_row(const body *a, const body *b, int n)
{
    int room = 8 * n * n, i, k, way, count, others;
    triangle *first = allocate((size_t)room, sizeof *first);
    triangle *second = allocate((size_t)room, sizeof *second);
    n3_patch *patch = allocate((size_t)room, sizeof *patch);
    count = octahedron(n, first);
    others = b->pipe ? grid(n, second) : octahedron(n, second);
    turn_outwards(a, first, count);
    turn_outwards(b, second, others);
    printf("| %s | %d, %d |", b->name, count, others);
    for (way = 0; way < WAYS; way++) {
        double worst = 0;
        tree t;
        for (i = 0; i < others; i++) patch[i] = patch_of(b, &second[i], way);
        t = tree_make(patch, others);
        for (k = 0; k < count; k++) worst = fmax(worst, worst_gap(a, b, &first[k], &t, way));
        printf(" %.1e |", worst);
        tree_free(&t);
    }
    printf("\n");
    free(first);
    free(second);
    free(patch);
}

/* All gaps are 1/10 where they are least. */
int main(void)
{
    static const body ball = {"", 0, 0, 1},
                      other[2] = {{"two spheres", 0, 2.1, 1}, {"sphere in a pipe", 1, 0, 1.1}};
    int i, n;
    printf("| bodies, 0.1 apart | triangles | flat | paper | arc rule |\n");
    printf("| --- | --- | --- | --- | --- |\n");
    for (i = 0; i < 2; i++)
        for (n = 2; n <= 8; n *= 2) print_row(&ball, &other[i], n);
    return fflush(stdout) || ferror(stdout);
}
