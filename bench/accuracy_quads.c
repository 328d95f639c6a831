/* accuracy_quads.c: Brown's squares over the quads of the meshes, against two triangles for each.
 */
#include "accuracy.h"
#include "examples/brown/brown.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Every cell of a grid is two triangles that follow one another. */
static brown_square *squares_make(const model *m, int rule)
{
    n3_options o = {0, 0, 0};
    int f, triangles = m->mesh.triangles, *half = take((size_t)triangles, sizeof *half);
    brown_square *square = take((size_t)triangles / 2, sizeof *square);
    n3_vec *net = take((size_t)n3_mesh_nodes(&m->mesh, &m->topology), sizeof *net);
    o.rule = rule;
    n3_mesh_net(&m->mesh, &m->topology, &o, net, NULL, NULL);
    for (f = 0; f < triangles; f++) half[f] = f;
    for (f = 0; f < triangles; f += 2)
        square[f / 2] = brown_mesh_square(&m->mesh, &m->topology, net, half, f, &o);
    free(net);
    free(half);
    return square;
}

/* The normal at t along a side of a triangle that is no diagonal: 0 and 1 of the first of a square,
   1 and 2 of the second. */
static n3_vec normal_on_side(const brown_square *square, int side, n3_real t)
{
    const brown_square *s = &square[side / 6];
    int k = side % 6;
    if (k == 0) return brown_normal(s, t, 0);
    if (k == 1) return brown_normal(s, 1, t);
    return k == 4 ? brown_normal(s, 1 - t, 1) : brown_normal(s, 0, 1 - t);
}

static double jump_across(const model *m, const brown_square *square, int side, int n)
{
    const int *first = &m->topology.first[m->topology.edge[side]];
    double jump = 0;
    int i, other;
    if (first[1] - first[0] != 2 || side % 6 == 2 || side % 6 == 3) return 0;
    other = m->topology.side[first[0]] + m->topology.side[first[0] + 1] - side;
    for (i = 0; i <= n; i++) {
        n3_real t = (n3_real)i / (n3_real)n;
        n3_vec a = normal_on_side(square, side, t), b = normal_on_side(square, other, 1 - t);
        jump = fmax(jump, angle_between(a, b));
    }
    return jump;
}

/* Squares are measured at as many points as their two triangles would be. */
static figures measure_squares(const surface *s, const model *m, const brown_square *square, int n)
{
    figures r = {0, 0, 0, 0, 0, 0};
    int f, i, j;
    for (f = 0; f < m->measured; f++) {
        if (!is_measured(m, f)) continue;
        for (i = 0; i < 3; i++) r.jump = fmax(r.jump, jump_across(m, square, 3 * f + i, n));
        for (i = 0; i <= n; i++)
            for (j = 0; j <= n; j++) {
                n3_real u = (n3_real)i / (n3_real)n, v = (n3_real)j / (n3_real)n;
                n3_vec x = brown_point(&square[f / 2], u, v);
                measure_at(s, m, x, brown_normal(&square[f / 2], u, v), &r);
            }
    }
    return r;
}

static void print_figures(const figures *r)
{
    printf(" %.1e / %.2g / ", r->distance, r->angle);
    if (r->jump < 1e-9)
        printf("below 1e-9 |");
    else
        printf("%.1g |", r->jump);
}

static long print_row(const surface *s, int irregular)
{
    static const int methods[] = {ARC, FIT}, rules[] = {N3_RULE_ARC, N3_RULE_FIT};
    int i, n = s->alike && !irregular ? 24 : 12;
    long lost = 0;
    model m = model_make(s, LEVELS - 1, irregular);
    printf("| %s |", s->name);
    for (i = 0; i < 4; i++) {
        n3_patch *patch = i < 2 ? patches_make(&m, methods[i]) : NULL;
        brown_square *square = i < 2 ? NULL : squares_make(&m, rules[i - 2]);
        figures r = i < 2 ? measure(s, &m, patch, n) : measure_squares(s, &m, square, n);
        print_figures(&r);
        lost += r.lost;
        free(patch);
        free(square);
    }
    printf("\n");
    model_free(&m);
    return lost;
}

long quads(void)
{
    int irregular, i;
    long lost = 0;
    for (irregular = 0; irregular < 2; irregular++) {
        printf("\n### quads, %s mesh, exact normals\n\n", irregular ? "irregular" : "regular");
        printf("| | triangles, arc | triangles, fit | squares, arc | squares, fit |\n");
        printf("| --- | --- | --- | --- | --- |\n");
        for (i = 0; i < SURFACES; i++)
            if (surfaces[i].at) lost += print_row(&surfaces[i], irregular);
    }
    return lost;
}
