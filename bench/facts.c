/* facts.c: the figures of the README, recomputed: `make facts`. */
#include "nagata3.h"

#include <math.h>
#include <stdio.h>

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

int main(void)
{
    print_bulge();
    print_sphere();
    return 0;
}
