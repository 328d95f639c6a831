/* facts.c: the figures of the README, recomputed: `make facts`. */
#include "nagata3.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double degree = 3.14159265358979323846 / 180;

/* The largest distance of a curve from the x axis, which is its chord. */
static double bulge(const n3_edge *e)
{
    double worst = 0;
    int i;
    for (i = 0; i <= 1000; i++) {
        n3_vec x = n3_edge_point(e, i / 1000.0);
        worst = fmax(worst, hypot(x.y, x.z));
    }
    return worst;
}

/* A unit chord tilted by 5 degrees, its normals turned by 0.01 degrees about it. */
static void print_bulge(void)
{
    double tilt = 5 * degree, turn = 0.01 * degree;
    n3_vertex a = {{0, 0, 0}, {-sin(tilt), 0, cos(tilt)}};
    n3_vertex b = {{1, 0, 0}, {-sin(tilt), -cos(tilt) * sin(turn), cos(tilt) * cos(turn)}};
    n3_segment s = n3_segment_make(a, b);
    n3_edge nagata = n3_segment_raise(&s), cubic = n3_edge_make(a, b, NULL);
    printf("bulge over a unit chord    Nagata %.0f, cubic %.3f\n", bulge(&nagata), bulge(&cubic));
}

static n3_vertex on_sphere(double x, double y, double z)
{
    n3_vertex v;
    v.x = v.n = n3_unit(n3_v(x, y, z));
    return v;
}

/* The largest distance of a patch from the unit sphere. */
static double sphere_error(const n3_patch *p)
{
    double worst = 0;
    int i, j;
    for (i = 0; i <= 24; i++)
        for (j = 0; i + j <= 24; j++) {
            n3_vec x = n3_patch_point(p, i / 24.0, j / 24.0);
            worst = fmax(worst, fabs(n3_len(x) - 1));
        }
    return worst;
}

/* The faces of the icosahedron are all alike; this is one. */
static void print_sphere(void)
{
    double g = (1 + sqrt(5)) / 2;
    n3_vertex a = on_sphere(0, 1, g), b = on_sphere(0, -1, g), c = on_sphere(g, 0, 1);
    n3_options arc = {N3_RULE_ARC, 0, 0};
    n3_patch2 q = n3_patch2_make(a, b, c);
    n3_patch nagata = n3_patch2_raise(&q), paper = n3_patch_make(a, b, c, NULL),
             ours = n3_patch_make(a, b, c, &arc);
    printf("sphere from 20 triangles   flat %.1e, Nagata %.1e, paper %.1e, arc rule %.1e\n",
           1 - n3_len(n3_mul(1.0 / 3, n3_add(a.x, n3_add(b.x, c.x)))), sphere_error(&nagata),
           sphere_error(&paper), sphere_error(&ours));
}

/* A drum: a cylinder of radius and height 1 with flat lids, whose faces bring their own normals to
   its rims. Points: the rims, bottom and top in turn, then the middles of the lids. */
enum { AROUND = 16, RIM = 2 * AROUND, PARTS = 4 };
enum { TRIANGLES = 4 * AROUND, EDGES = 3 * TRIANGLES / 2 };

typedef struct drum {
    n3_vec point[RIM + 2], normal[AROUND + 2];
    int triangle[TRIANGLES][3], corner[TRIANGLES][3];
} drum;

static void drum_make(drum *d)
{
    int i, k;
    for (i = 0; i < AROUND; i++) {
        double x = cos(i * 360 / AROUND * degree), y = sin(i * 360 / AROUND * degree);
        d->normal[i] = d->point[2 * i] = n3_v(x, y, 0);
        d->point[2 * i + 1] = n3_v(x, y, 1);
    }
    d->point[RIM] = n3_v(0, 0, 0);
    d->point[RIM + 1] = n3_v(0, 0, 1);
    d->normal[AROUND] = n3_v(0, 0, -1);
    d->normal[AROUND + 1] = n3_v(0, 0, 1);
    for (i = 0; i < AROUND; i++) {
        int a = 2 * i, b = 2 * ((i + 1) % AROUND);
        int faces[4][3] = {{0, 0, 0}, {0, 0, 0}, {RIM, 0, 0}, {RIM + 1, 0, 0}};
        faces[0][0] = faces[1][0] = faces[2][2] = a;
        faces[0][1] = faces[2][1] = b;
        faces[0][2] = faces[1][1] = faces[3][2] = b + 1;
        faces[1][2] = faces[3][1] = a + 1;
        for (k = 0; k < 12; k++) {
            int point = faces[k / 3][k % 3];
            d->triangle[4 * i + k / 3][k % 3] = point;
            d->corner[4 * i + k / 3][k % 3] = k / 3 < 2 ? point / 2 : AROUND + k / 3 - 2;
        }
    }
}

/* The edge of a side, as its face alone would build it. */
static n3_edge own_edge(const drum *d, int side)
{
    int next = side % 3 == 2 ? side - 2 : side + 1;
    const int *triangle = &d->triangle[0][0], *corner = &d->corner[0][0];
    n3_vertex a, b;
    a.x = d->point[triangle[side]];
    a.n = d->normal[corner[side]];
    b.x = d->point[triangle[next]];
    b.n = d->normal[corner[next]];
    return n3_edge_make(a, b, NULL);
}

static void fail_if(int failed)
{
    if (failed) fprintf(stderr, "the drum cannot be built\n");
    if (failed) exit(1);
}

/* The sides of the refined surface that no other side meets. */
static int open_sides(const n3_mesh *m, const n3_topology *t)
{
    static n3_vec net[RIM + 2 + 2 * EDGES + TRIANGLES], point[PARTS * PARTS * TRIANGLES];
    static int triangle[PARTS * PARTS * TRIANGLES][3], work[PARTS * PARTS * TRIANGLES * 12];
    n3_mesh fine = {0, 0, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0};
    n3_topology seams;
    n3_report report;
    n3_mesh_refine_counts(m, t, PARTS, &fine.points, &fine.triangles, NULL);
    fine.point = &point[0].x;
    fine.triangle = &triangle[0][0];
    fail_if(n3_mesh_net(m, t, NULL, net, NULL, NULL) != N3_OK);
    fail_if(n3_mesh_refine(m, t, net, PARTS, point, &triangle[0][0], NULL, NULL, NULL, NULL) !=
            N3_OK);
    fail_if(n3_mesh_topology(&fine, work, sizeof work, &seams, NULL) != N3_OK);
    report = n3_mesh_report(&fine, &seams, NULL, NULL);
    return report.border_edges + report.non_manifold_edges;
}

static void print_cracks(void)
{
    static drum d;
    static int work[12 * TRIANGLES];
    n3_mesh m = {RIM + 2, TRIANGLES, AROUND + 2, NULL, 0, NULL, 0, NULL, 0, NULL, 0};
    n3_topology t;
    double widest = 0;
    int i, cracks = 0;
    drum_make(&d);
    m.point = &d.point[0].x;
    m.triangle = &d.triangle[0][0];
    m.normal = &d.normal[0].x;
    m.corner = &d.corner[0][0];
    fail_if(n3_mesh_topology(&m, work, sizeof work, &t, NULL) != N3_OK);
    for (i = 0; i < t.edges; i++) {
        n3_edge e = own_edge(&d, t.side[t.first[i]]), f = own_edge(&d, t.side[t.first[i] + 1]);
        n3_vec gap = n3_sub(n3_edge_point(&e, 0.5), n3_edge_point(&f, 0.5));
        cracks += n3_len(gap) > 0;
        widest = fmax(widest, n3_len(gap));
    }
    printf("cracks in a drum           faces alone %d of %d edges, up to %.3f; as a mesh %d\n", cracks,
           t.edges, widest, open_sides(&m, &t));
}

int main(void)
{
    print_bulge();
    print_cracks();
    print_sphere();
    return 0;
}
