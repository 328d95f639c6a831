/* Quads as Brown's squares: which pairs of triangles they were, and the surface over them. */
#include "smooth_grid.h"

#include <math.h>
#include <stdlib.h>

/* ---- The surface over a triangle, be it a patch or half a square ---- */

static const brown_square *square_of(const surface *s, int triangle)
{
    return s->half && s->half[triangle] >= 0 ? &s->square[s->half[triangle] / 2] : NULL;
}

/* From a triangle's parameters to its square's, whose corners are 0 1 2 or 0 2 3 of it. */
static void to_square(const surface *s, int triangle, n3_real *u, n3_real *v)
{
    n3_real sum = *u + *v;
    if (fabs(1 - sum) <= 2 * N3_EPS) sum = 1;
    *(s->half[triangle] % 2 ? v : u) = sum;
}

n3_vec surface_point(const surface *s, int triangle, n3_real u, n3_real v)
{
    n3_patch p;
    if (square_of(s, triangle)) {
        to_square(s, triangle, &u, &v);
        return brown_point(square_of(s, triangle), u, v);
    }
    n3_mesh_patches(&s->mesh, &s->topology, s->net, triangle, triangle + 1, &p);
    return n3_patch_point(&p, u, v);
}

int surface_on_square(const surface *s, int triangle, n3_real u, n3_real v, n3_jet *jet,
                      n3_vec *normal)
{
    const brown_square *q = square_of(s, triangle);
    if (!q) return 0;
    to_square(s, triangle, &u, &v);
    *jet = brown_jet(q, u, v);
    *normal = brown_normal(q, u, v);
    return 1;
}

n3_vec surface_normal(const surface *s, int triangle, n3_real u, n3_real v)
{
    n3_patch p;
    if (square_of(s, triangle)) {
        to_square(s, triangle, &u, &v);
        return brown_normal(square_of(s, triangle), u, v);
    }
    n3_mesh_patches(&s->mesh, &s->topology, s->net, triangle, triangle + 1, &p);
    return n3_patch_normal(&p, u, v);
}

n3_vec surface_side_normal(const surface *s, int side, n3_real t)
{
    n3_real w[3] = {0, 0, 0};
    w[side % 3] = 1 - t;
    w[(side + 1) % 3] = t;
    return surface_normal(s, side / 3, w[1], w[2]);
}

/* Inside a square, between its two triangles. */
static int is_diagonal(const surface *s, int edge)
{
    const int *first = s->topology.first + edge, *side = s->topology.side + first[0];
    if (first[1] - first[0] != 2) return 0;
    return square_of(s, side[0] / 3) && square_of(s, side[0] / 3) == square_of(s, side[1] / 3);
}

void surface_take_squares(surface *s)
{
    int e;
    s->square = allocate((size_t)s->squares, sizeof *s->square);
    for (e = 0; e < s->topology.edges; e++)
        if (is_diagonal(s, e)) s->flags[e] = 0;
}

/* ---- Quads of a mesh ---- */

/* Triangles of one cell that a quad has been split into; a bend along the diagonal parts it. */
static int is_quad(const mesh *m, const surface *s, int t)
{
    const int *a = m->triangle + 3 * t, *b = a + 3, *n = s->corner + 3 * t;
    int alone = t + 2 >= m->triangles || m->cell[t + 2] != m->cell[t];
    if (t + 1 >= m->triangles || m->cell[t] != m->cell[t + 1]) return 0;
    if (!m->boundary && (!alone || (t > 0 && m->cell[t - 1] == m->cell[t]))) return 0;
    return a[0] == b[0] && a[2] == b[1] && a[1] != b[2] && n[0] == n[3] && n[2] == n[4];
}

void surface_find_quads(const mesh *m, surface *s)
{
    n3_options o = {0, 0, 0};
    int t;
    o.rule = s->rule->rule;
    s->half = allocate((size_t)m->triangles, sizeof *s->half);
    for (t = 0; t < m->triangles; t++) s->half[t] = -1;
    for (t = 0; t < m->triangles; t++) {
        if (!is_quad(m, s, t)) continue;
        s->half[t] = 2 * s->squares;
        s->half[++t] = 2 * s->squares++ + 1;
    }
    surface_take_squares(s);
    for (t = 0; t < m->triangles; t++)
        if (s->half[t] >= 0 && s->half[t] % 2 == 0)
            s->square[s->half[t] / 2] =
                brown_mesh_square(&s->mesh, &s->topology, s->net, s->half, t, &o);
}

/* ---- Facets ---- */

void facet_places(int i, int j, int at[3][2])
{
    int down = i % 2, u = (i + 1) / 2, v = j + down, side = down ? -1 : 1;
    at[0][0] = at[2][0] = u;
    at[0][1] = at[1][1] = v;
    at[1][0] = u + side;
    at[2][1] = v + side;
}

/* The largest distance from a facet's middle and its sides' to where the surface has them; a facet
   is the n-th part of a triangle along its sides, up or down. */
static n3_real facet_distance(const surface *s, int triangle, const int at[3][2], int n)
{
    static const int weight[4][3] = {{2, 2, 2}, {0, 3, 3}, {3, 0, 3}, {3, 3, 0}};
    n3_vec x[3];
    n3_real most = 0;
    int i, k;
    for (i = 0; i < 3; i++)
        x[i] = surface_point(s, triangle, (n3_real)at[i][0] / n, (n3_real)at[i][1] / n);
    for (k = 0; k < 4; k++) {
        n3_vec flat = n3_v(0, 0, 0);
        n3_real u = 0, v = 0, d;
        for (i = 0; i < 3; i++) {
            flat = n3_add(flat, n3_mul((n3_real)weight[k][i] / 6, x[i]));
            u += (n3_real)(weight[k][i] * at[i][0]) / (6 * n);
            v += (n3_real)(weight[k][i] * at[i][1]) / (6 * n);
        }
        d = n3_len(n3_sub(surface_point(s, triangle, u, v), flat));
        most = d > most ? d : most;
    }
    return most;
}

static n3_real level_distance(const surface *s, int n)
{
    n3_real most = 0;
    int t, i, j;
    for (t = 0; t < s->mesh.triangles; t++)
        for (j = 0; j < n; j++)
            for (i = 0; i < 2 * (n - j) - 1; i++) {
                int at[3][2];
                n3_real d;
                facet_places(i, j, at);
                d = facet_distance(s, t, (const int(*)[2])at, n);
                most = d > most ? d : most;
            }
    return most;
}

/* The distance falls with the square of the level. */
int surface_level(const surface *s, n3_real distance)
{
    enum { MOST = 1000 };
    int n = 1;
    for (;;) {
        n3_real d = level_distance(s, n), more = n * sqrt(d / distance);
        if (d <= distance) return n;
        if (!(more <= MOST) || n >= MOST)
            fail(s->path, 0, "more than %d parts per edge were needed", MOST);
        n = more > n + 1 ? (int)ceil(more) : n + 1;
    }
}

static void lay_node(grid *g, int node)
{
    const surface *s = g->surface;
    int t = g->parent[node];
    if (square_of(s, t)) g->node[node] = surface_point(s, t, g->uv[2 * node], g->uv[2 * node + 1]);
}

void surface_square_normals(const surface *s, int triangle, int level, n3_vec *normal)
{
    int i, j;
    if (!square_of(s, triangle)) return;
    for (j = 0; j <= level; j++)
        for (i = 0; i <= level - j; i++)
            *normal++ = surface_normal(s, triangle, (n3_real)i / level, (n3_real)j / level);
}

/* Those on the sides of squares are where they should be, on the edges of the net. */
void grid_lay_squares(grid *g, int level)
{
    const surface *s = g->surface;
    const int edges = s->topology.edges, size = (level + 1) * (level + 2) / 2;
    int e, t, i;
    for (e = 0; e < edges; e++)
        for (i = g->first[e]; i < g->first[e + 1] && is_diagonal(s, e); i++) lay_node(g, i);
    for (i = g->first[edges]; i < g->nodes; i++) lay_node(g, i);
    for (t = 0; t < s->mesh.triangles && g->normal; t++)
        surface_square_normals(s, t, level, g->normal + (size_t)t * (size_t)size);
}

/* ---- Report ---- */

static void report_jumps(const surface *s, n3_report *r)
{
    const unsigned rough = N3_EDGE_CREASE | N3_EDGE_HALF_CREASE | N3_EDGE_DEGENERATE;
    int e, i, side[2];
    r->jump = 0;
    r->jump_edge = -1;
    for (e = 0; e < s->topology.edges; e++) {
        int regular = n3i_is_regular(&s->mesh, &s->topology, e, side);
        for (i = 1; i < 4 && regular && !(s->flags[e] & rough) && !is_diagonal(s, e); i++) {
            n3_vec a = surface_side_normal(s, side[0], (n3_real)i / 4);
            n3_vec b = surface_side_normal(s, side[1], 1 - (n3_real)i / 4);
            n3_real jump = n3_len(n3_sub(a, b));
            if (r->jump_edge >= 0 && !(jump > r->jump)) continue;
            r->jump = jump;
            r->jump_edge = e;
        }
    }
}

static void report_distances(const surface *s, n3_report *r)
{
    int t, i, j;
    for (t = 0; t < s->mesh.triangles; t++) {
        const int *point = s->mesh.triangle + 3 * t;
        n3_vec a = s->net[point[0]], b = n3_sub(s->net[point[1]], a),
               c = n3_sub(s->net[point[2]], a);
        n3_vec face = n3_unit(n3_cross(b, c));
        for (j = 0; j <= 6; j++)
            for (i = 0; i <= 6 - j; i++) {
                n3_vec x = surface_point(s, t, (n3_real)i / 6, (n3_real)j / 6);
                n3_real d = (n3_real)fabs(n3_dot(n3_sub(x, a), face));
                if (r->distance_triangle >= 0 && !(d > r->distance)) continue;
                r->distance = d;
                r->distance_triangle = t;
            }
    }
}

n3_report surface_report(const surface *s)
{
    n3_report r = n3_mesh_report(&s->mesh, &s->topology, s->net, s->flags);
    int t;
    if (!s->squares) return r;
    r.folding_patches = 0;
    for (t = 0; t < s->mesh.triangles; t++) {
        n3_patch p;
        n3_mesh_patches(&s->mesh, &s->topology, s->net, t, t + 1, &p);
        r.folding_patches += !square_of(s, t) && n3_patch_may_fold(&p);
    }
    r.distance = 0;
    r.distance_triangle = -1;
    report_jumps(s, &r);
    report_distances(s, &r);
    return r;
}
