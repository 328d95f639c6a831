/* accuracy_mesh.c: regular and irregular meshes of the surfaces. */
#include "accuracy.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

void *take(size_t count, size_t size)
{
    void *p = malloc(count * size + 1);
    if (p) return p;
    fprintf(stderr, "accuracy: out of memory\n");
    exit(1);
}

/* splitmix64, from -1 to 1 */
static n3_real toss(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (n3_real)((double)((z ^ (z >> 31)) >> 11) / 4503599627370496.0 - 1);
}

/* The view of the arrays, and the topology. */
static void model_join(model *m, int points, int triangles)
{
    n3_mesh view = {0, 0, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0};
    view.points = view.normals = points;
    view.triangles = triangles;
    view.point = &m->point[0].x;
    view.normal = &m->normal[0].x;
    view.triangle = m->triangle;
    m->mesh = view;
    m->measured = triangles;
    m->work = take(n3_mesh_workspace(&view), 1);
    n3_mesh_topology(&view, m->work, n3_mesh_workspace(&view), &m->topology, NULL);
}

static model model_take(int points, int triangles)
{
    model m;
    m.point = take((size_t)points, sizeof *m.point);
    m.normal = take((size_t)points, sizeof *m.normal);
    m.triangle = take((size_t)triangles, 3 * sizeof *m.triangle);
    return m;
}

void model_free(model *m)
{
    free(m->point);
    free(m->normal);
    free(m->triangle);
    free(m->work);
}

static model icosahedron(void)
{
    static const int face[20][3] = {
        {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
        {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};
    static const signed char corner[12][3] = {
        {-1, 2, 0}, {1, 2, 0}, {-1, -2, 0}, {1, -2, 0}, {0, -1, 2}, {0, 1, 2},
        {0, -1, -2}, {0, 1, -2}, {2, 0, -1}, {2, 0, 1}, {-2, 0, -1}, {-2, 0, 1}};
    n3_real golden = (1 + (n3_real)sqrt(5)) / 4;
    model m = model_take(12, 20);
    int i, k;
    for (i = 0; i < 12; i++) {
        n3_real c[3];
        for (k = 0; k < 3; k++)
            c[k] = (n3_real)corner[i][k] * (abs(corner[i][k]) == 2 ? golden : 1);
        m.point[i] = n3_unit(n3_v(c[0], c[1], c[2]));
    }
    for (i = 0; i < 60; i++) m.triangle[i] = face[i / 3][i % 3];
    model_join(&m, 12, 20);
    return m;
}

/* Each triangle in four at its edges' middles, on the sphere; the four follow one another. */
static model quarter(model *old)
{
    static const int part[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    int points = old->mesh.points, triangles = old->mesh.triangles, i, k;
    model m = model_take(points + old->topology.edges, 4 * triangles);
    for (i = 0; i < points; i++) m.point[i] = old->point[i];
    for (i = 0; i < triangles; i++) {
        int node[6];
        for (k = 0; k < 3; k++) {
            int a = old->triangle[3 * i + k], b = old->triangle[3 * i + (k + 1) % 3];
            node[k] = a;
            node[3 + k] = points + old->topology.edge[3 * i + k];
            m.point[node[3 + k]] = n3_unit(n3_add(old->point[a], old->point[b]));
        }
        for (k = 0; k < 12; k++) m.triangle[12 * i + k] = node[part[k / 3][k % 3]];
    }
    model_join(&m, points + old->topology.edges, 4 * triangles);
    model_free(old);
    return m;
}

/* The edges of an icosahedron are 1.05 long; a move stays within a fifth of an edge or so. */
static model icosphere(const surface *s, int level, int irregular)
{
    model m = icosahedron();
    uint64_t state = (uint64_t)level;
    n3_real move = (n3_real)1 / 5;
    int i;
    for (i = 0; i < level; i++) {
        m = quarter(&m);
        move /= 2;
    }
    for (i = 0; i < m.mesh.points; i++) {
        n3_vec x = m.point[i];
        if (irregular) {
            n3_real dx = toss(&state), dy = toss(&state), dz = toss(&state);
            x = n3_unit(n3_add(x, n3_mul(move, n3_v(dx, dy, dz))));
        }
        m.point[i] = n3_v(s->size[0] * x.x, s->size[1] * x.y, s->size[2] * x.z);
    }
    if (s->alike && !irregular) m.measured /= 20;
    return m;
}

/* The grid's size: cells and points in u and v, cells of the margin at either end. */
typedef struct extent { int nu, nv, columns, rows, margin_u, margin_v; } extent;

static extent extent_make(const surface *s, int level)
{
    extent e;
    e.margin_u = s->round_u ? 0 : s->margin;
    e.margin_v = s->round_v ? 0 : s->margin;
    e.nu = (s->nu << level) + 2 * e.margin_u;
    e.nv = (s->nv << level) + 2 * e.margin_v;
    e.columns = e.nu + !s->round_u;
    e.rows = e.nv + !s->round_v;
    return e;
}

/* The cell i, j as two triangles along the diagonal from its corner (0, 0), or the other. */
static void split_cell(const extent *e, int i, int j, int other, int triangle[6])
{
    static const int part[2][6] = {{0, 1, 2, 0, 2, 3}, {1, 2, 3, 1, 3, 0}};
    int i1 = (i + 1) % e->columns, j1 = (j + 1) % e->rows, node[4], k;
    node[0] = i * e->rows + j;
    node[1] = i1 * e->rows + j;
    node[2] = i1 * e->rows + j1;
    node[3] = i * e->rows + j1;
    for (k = 0; k < 6; k++) triangle[k] = node[part[other][k]];
}

/* The cells that are measured come first. */
static void split_cells(model *m, const extent *e, int irregular, uint64_t *state)
{
    int pass, i, j, n = 0;
    for (pass = 0; pass < 2; pass++)
        for (i = 0; i < e->nu; i++)
            for (j = 0; j < e->nv; j++) {
                int inside = i >= e->margin_u && i < e->nu - e->margin_u && j >= e->margin_v &&
                             j < e->nv - e->margin_v;
                if (inside == pass) continue;
                split_cell(e, i, j, irregular && toss(state) < 0, &m->triangle[6 * n++]);
            }
}

static model grid(const surface *s, int level, int irregular)
{
    extent e = extent_make(s, level);
    uint64_t state = (uint64_t)level;
    model m = model_take(e.columns * e.rows, 2 * e.nu * e.nv);
    int i, j;
    for (i = 0; i < e.columns; i++)
        for (j = 0; j < e.rows; j++) {
            n3_real u = (n3_real)(i - e.margin_u), v = (n3_real)(j - e.margin_v);
            n3_real du = toss(&state) / 5, dv = toss(&state) / 5;
            if (irregular && (s->round_u || (i > 0 && i < e.nu))) u += du;
            if (irregular && (s->round_v || (j > 0 && j < e.nv))) v += dv;
            u /= (n3_real)(s->nu << level);
            v /= (n3_real)(s->nv << level);
            m.point[i * e.rows + j] = s->at(s, u, v, s->nu << level);
        }
    split_cells(&m, &e, irregular, &state);
    model_join(&m, e.columns * e.rows, 2 * e.nu * e.nv);
    m.measured = 2 * (e.nu - 2 * e.margin_u) * (e.nv - 2 * e.margin_v);
    if (s->alike && !irregular) m.measured /= e.nu;
    return m;
}

model model_make(const surface *s, int level, int irregular)
{
    model m = s->at ? grid(s, level, irregular) : icosphere(s, level, irregular);
    n3_vec hessian[3];
    int i;
    for (i = 0; i < m.mesh.points; i++) {
        s->f(s, m.point[i], &m.normal[i], hessian);
        m.normal[i] = n3_unit(m.normal[i]);
    }
    return m;
}

void model_estimate_normals(model *m)
{
    size_t triangles = (size_t)m->mesh.triangles, points = (size_t)m->mesh.points, i;
    n3_vec *normal = take(points + 3 * triangles, sizeof *normal);
    int *corner = take(3 * triangles, sizeof *corner), normals;
    m->mesh.normals = 0;
    m->mesh.normal = NULL;
    n3_mesh_normals(&m->mesh, &m->topology, -1, NULL, normal, corner, &normals, NULL);
    for (i = 0; i < 3 * triangles; i++) m->normal[m->triangle[i]] = normal[corner[i]];
    m->mesh.normals = m->mesh.points;
    m->mesh.normal = &m->normal[0].x;
    free(corner);
    free(normal);
}
