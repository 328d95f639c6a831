/* join.h: two meshes of triangles made one, by a smooth bridge between a border loop of each.
 *
 * THE BRIDGE
 *
 * Curves run from points of one loop to points of the other; rows of points on them, and the two
 * loops themselves, make the rows of a grid, and its cells, cut in two, are the triangles:
 *
 *     mesh A  ----o----o----o----o----  row 0, the points of A's loop
 *                 | \  | \  | \  |
 *                 o----o----o----o      rows 1 .. m, at t = r / (m + 1) of the curves
 *                  \  / \  / \  /
 *                   o----o----o         a row may have fewer points than the one before
 *                   | \  | \  |
 *     mesh B  ------o----o----o-------  row m + 1, the points of B's loop
 *
 * JOIN_NAGATA, the default: a curve leaves each mesh along a tangent t that lies in the planes of
 * both border triangles at its end, so that the first and the last row of the bridge turn into the
 * planes of the triangles that they meet: the angle at the seams falls like 1 / (m + 1). Where the
 * two planes are one, t is square to the border; between, it fades as the edges of nagata3.h do at
 * their creases, and the lengths of the handles are those of its arc rule for given tangents,
 *
 *     p21 = x0 + h0 t0,  p12 = x1 + h1 t1,  h = (2 L / 3) / (1 + |t0 - t1| / 2) times the strength
 *
 * with both tangents looking away from their mesh. No lines are intersected, so that parallel,
 * diverging and backward tangents are like all others. The loops need not have equally many
 * points, and no point of either mesh moves.
 *
 * JOIN_FUJITA: Fujita's method [1], as printed; its equations are cited as (F2.4.1) and so on, by
 * section. The loops have equally many points and those of B are moved into the work planes.
 * It breaks down where its author says, and a test shows each place: tangents that meet behind a
 * point; equal parallel ones; loops that bend abruptly; parallel ones beside others.
 *
 * JOIN_STRAIGHT: straight lines, for comparison.
 *
 * THE CALLS, in order; all memory is the caller's
 *
 *     join_border_make       the border loops of a mesh; join_border_with, join_border_nearest
 *                            choose among them
 *     join_rim_make          a loop with its tangents
 *     join_rims_match        where the two loops begin, and which way the second runs
 *     join_columns           the curves
 *     join_rows              how many rows a tolerance needs
 *     join_counts            how much there will be
 *     join_mesh              the one mesh; join_seam, how smooth it has become
 *
 * DEGENERATE INPUT
 *
 *     border that is no loop      JOIN_OPEN: it ends at an edge of three triangles, or of two that
 *                                 disagree about which side is outside
 *     loops in the same place     JOIN_COINCIDENT; where only some points coincide the triangles
 *                                 there have no area
 *     loops that cross            a bridge like any other; it may cut through itself
 *     B inside out                its triangles are turned round
 *     triangles without an area   the neighbour's plane; if there is none, a curve without a
 *                                 tangent there leaves along its chord
 *
 * REFERENCES
 *
 *     [1] Fujita N., Natural joining of meshes by approximate G1 continuity with Bezier curves,
 *         graduation thesis, School of Media Science, 2003 (in Japanese).
 *     [2] Wang W., Juettler B., Zheng D., Liu Y., Computation of rotation minimizing frames,
 *         ACM Transactions on Graphics 27, 2008.
 */
#ifndef JOIN_H
#define JOIN_H

#include "nagata3.h"

enum { JOIN_NAGATA, JOIN_FUJITA, JOIN_STRAIGHT };

/* NULL means the defaults, and so does a field that is not > 0. */
typedef struct join_options {
    int method;
    n3_real strength[2]; /* of A's and of B's end: times the handle (1); JOIN_FUJITA: its s, the
                            part of the way to the tangents' intersection, below 1 (2/3) */
} join_options;

typedef enum join_status {
    JOIN_OK,
    JOIN_NO_LOOP,    /* there is no closed border loop, or not this one */
    JOIN_OPEN,       /* item: the loop; the border does not close */
    JOIN_BAD_START,  /* item: 0 or 1; the mesh whose start is not on its loop */
    JOIN_BAD_COUNT,  /* a count is negative or leads beyond int */
    JOIN_COINCIDENT, /* the loops are in the same place */
    JOIN_UNEQUAL,    /* JOIN_FUJITA: the loops have different numbers of points */
    JOIN_NO_PLANE,   /* JOIN_FUJITA, item: a point of A; it lies on the centre line */
    JOIN_NO_LINE     /* JOIN_FUJITA, item: a point of A, or A's points + one of B; its triangles do
                        not meet the work plane in a line */
} join_status;

/* The status in words, never NULL. */
NAGATA3_API const char *join_status_text(join_status status);

/* ---- Borders ---- */

/* Sides first up to but not with first + count, each from its point to that of the next. */
typedef struct join_loop { int first, count, closed; } join_loop;

/* The mesh and its topology must live as long, and the arrays. */
typedef struct join_border {
    const n3_mesh *mesh;
    const n3_topology *topology;
    const int *side;       /* 3 f + i, as in the topology */
    const join_loop *loop;
    int loops;
} join_border;

/* The sides of triangles without a neighbour: the room that join_border_make needs. */
NAGATA3_API int join_border_sides(const n3_mesh *m, const n3_topology *t);

/* The borders, in the order of their lowest side, each run as its triangles do. Where a border
   touches itself in a point, the triangles there say how it goes on. An open one is listed in one
   or more pieces. work: [3 triangles]; side and loop: [join_border_sides]. Linear. */
NAGATA3_API join_border join_border_make(const n3_mesh *m, const n3_topology *t, int *work,
                                         int *side, join_loop *loop);

/* The first loop that has the point, -1: none has. */
NAGATA3_API int join_border_with(const join_border *b, int point);

/* The pair of closed loops that are nearest to each other, by the mean distance to the other from
   16 points of each. Costs 32 distances for each point of one and each loop of the other. */
NAGATA3_API join_status join_border_nearest(const join_border *a, const join_border *b,
                                            int pair[2]);

/* ---- Rims ---- */

typedef struct join_vertex {
    n3_vec x, n, t; /* the point; the mean of its border triangles' normals; the unit tangent along
                       which the surface leaves the mesh */
    n3_real s;      /* the loop's length up to here, of the whole */
    int point, side;
} join_vertex;

/* A loop, run from some vertex in some direction. */
typedef struct join_rim {
    const join_border *border;
    const join_vertex *vertex;
    int count, start, step; /* step: 1 as its triangles run, -1 against */
    int even;               /* the parameter counts vertices, not the length */
} join_rim;

/* From loop's border triangles, or, with from_normals, from the normals that the mesh has at their
   corners instead of the triangles' own. vertex: [count of the loop]. Linear. */
NAGATA3_API join_status join_rim_make(const join_border *b, int loop, int from_normals,
                                      join_vertex *vertex, join_rim *rim);

/* Sets where the rims start and how B's runs, so that the bridge twists least. What is compared is
   the shape of the loops about their centres, and the normals, carried along the curves without
   twisting [2]. start: a point of each mesh, or NULL. along: -1, B runs against its triangles, as
   it must for both meshes to keep their outsides; 1, with them, and B is turned inside out; 0,
   whatever is found, where turning has to be better by a factor of 2.
   Loops in the same places are refused. 64 comparisons for each of up to 256 starts of the larger
   loop, and some beside the best, in both directions. */
NAGATA3_API join_status join_rims_match(join_rim *a, join_rim *b, const int start[2], int along,
                                        int *item);

/* ---- The bridge ---- */

/* A curve of the bridge, from A to B. */
typedef struct join_column { n3_edge curve; n3_real s; } join_column;

typedef struct join_bridge {
    join_rim a, b;
    const join_column *column;
    int columns, rows; /* rows of points between the loops, 0 or more: the caller's */
    int fixed;         /* all cells are cut as Fujita does, not the better way */
} join_bridge;

/* The curves, by the options, at every vertex of both rims. column: [count of A + count of B].
   moved: [points of B], for JOIN_FUJITA alone: the points of B with those of the loop moved.
   The curves do not depend on the number of rows. rows is set to 0. */
NAGATA3_API join_status join_columns(const join_rim *a, const join_rim *b, const join_options *o,
                                     join_column *column, n3_vec *moved, join_bridge *bridge,
                                     int *item);

/* The fewest rows with which no curve is farther than tolerance from its polygon, by the bound
   |x''| / (8 (rows + 1)^2) on the distance; at most 1000000, -1 where that is not enough or the
   tolerance is not > 0. */
NAGATA3_API int join_rows(const join_bridge *bridge, n3_real tolerance);

/* How many points and triangles join_mesh makes: those of A and B, and of the bridge, between rows
   of n and k points n + k. Each pointer may be NULL. */
NAGATA3_API join_status join_counts(const join_bridge *bridge, int *points, int *triangles);

/* The one mesh: A's points, B's, those of the bridge row by row, and the triangles in the same
   order. The points and triangles of both are as they were, bit for bit, but for JOIN_FUJITA, with
   moved in place of B's points, and for B's triangles where they are turned round. point, triangle:
   as many as join_counts says, 1 and 3 elements each. Linear; n log n for unequal loops. */
NAGATA3_API join_status join_mesh(const join_bridge *bridge, const n3_vec *moved, n3_vec *point,
                                  int *triangle);

/* How the joined mesh bends across its seam with A, where 0, or with B, 1, or within the bridge, 2:
   the least and the largest |n - n'|, 2 sin of half the angle, of two triangles' unit normals.
   Beyond sqrt 2 the bridge folds. Returns the number of edges there. */
NAGATA3_API int join_seam(const join_bridge *bridge, const n3_mesh *joined,
                          const n3_topology *topology, int where, n3_real jump[2]);

/* ---- Definitions: status ---- */

NAGATA3_API const char *join_status_text(join_status status)
{
    switch (status) {
    case JOIN_OK: return "all is well";
    case JOIN_NO_LOOP: return "there is no such closed border loop";
    case JOIN_OPEN: return "the border is no loop: it ends where triangles disagree or three meet";
    case JOIN_BAD_START: return "the start is not on the loop";
    case JOIN_BAD_COUNT: return "a count is negative or beyond int";
    case JOIN_COINCIDENT: return "the loops are in the same place";
    case JOIN_UNEQUAL: return "the loops have different numbers of points";
    case JOIN_NO_PLANE: return "a point lies on the centre line and has no work plane";
    case JOIN_NO_LINE: return "the triangles at a point do not meet its work plane in a line";
    }
    return "unknown status";
}

NAGATA3_API join_status joini_blame(join_status status, int index, int *item)
{
    if (item) *item = index;
    return status;
}

/* ---- Definitions: borders ---- */

enum { JOINI_BORDER = -1, JOINI_BROKEN = -2 };

/* The side of the neighbour; JOINI_BORDER: there is none; JOINI_BROKEN: there are several, or one
   that disagrees about which side is outside. */
NAGATA3_API int joini_twin(const n3_mesh *m, const n3_topology *t, int side)
{
    int two[2], edge = t->edge[side];
    if (edge < 0) return JOINI_BROKEN;
    if (n3i_live_sides(m, t, edge, two) == 1) return JOINI_BORDER;
    if (!n3i_is_regular(m, t, edge, two)) return JOINI_BROKEN;
    return two[0] == side ? two[1] : two[0];
}

NAGATA3_API int joini_is_border(const n3_mesh *m, const n3_topology *t, int side)
{
    return !n3i_is_collapsed(m, side / 3) && joini_twin(m, t, side) == JOINI_BORDER;
}

NAGATA3_API int join_border_sides(const n3_mesh *m, const n3_topology *t)
{
    int s, count = 0;
    for (s = 0; s < 3 * m->triangles; s++) count += joini_is_border(m, t, s);
    return count;
}

/* Round the point at the side's end to the next side of the border. */
NAGATA3_API int joini_next(const n3_mesh *m, const n3_topology *t, int side)
{
    int s = n3i_after(side), twin;
    while ((twin = joini_twin(m, t, s)) >= 0) s = n3i_after(twin);
    return twin == JOINI_BORDER ? s : JOINI_BROKEN;
}

NAGATA3_API join_border join_border_make(const n3_mesh *m, const n3_topology *t, int *work,
                                         int *side, join_loop *loop)
{
    join_border b;
    int s, k, made = 0;
    b.mesh = m;
    b.topology = t;
    b.side = side;
    b.loop = loop;
    b.loops = 0;
    for (s = 0; s < 3 * m->triangles; s++) work[s] = joini_is_border(m, t, s);
    for (s = 0; s < 3 * m->triangles; s++) {
        if (!work[s]) continue;
        loop[b.loops].first = made;
        for (k = s; k >= 0 && work[k]; k = joini_next(m, t, k)) {
            work[k] = 0;
            side[made++] = k;
        }
        loop[b.loops].count = made - loop[b.loops].first;
        loop[b.loops++].closed = k == s;
    }
    return b;
}

NAGATA3_API int join_border_with(const join_border *b, int point)
{
    int i, k;
    for (i = 0; i < b->loops; i++)
        for (k = b->loop[i].first; k < b->loop[i].first + b->loop[i].count; k++)
            if (n3i_at(b->mesh, b->side[k]) == point) return i;
    return -1;
}

/* The point k of a loop, counted round and round. */
NAGATA3_API n3_vec joini_loop_point(const join_border *b, int loop, int k)
{
    return n3i_point(b->mesh, n3i_at(b->mesh, b->side[b->loop[loop].first + k]));
}

/* The mean distance from 16 points of a loop to the nearest points of another. */
NAGATA3_API n3_real joini_loop_distance(const join_border *a, int i, const join_border *b, int k)
{
    int n = a->loop[i].count, samples = n < 16 ? n : 16, p, q;
    n3_real sum = 0;
    for (p = 0; p < samples; p++) {
        n3_vec x = joini_loop_point(a, i, (int)((double)p * n / samples));
        n3_real least = n3_len(n3_sub(x, joini_loop_point(b, k, 0)));
        for (q = 1; q < b->loop[k].count; q++) {
            n3_real d = n3_len(n3_sub(x, joini_loop_point(b, k, q)));
            if (d < least) least = d;
        }
        sum += least / (n3_real)samples;
    }
    return sum;
}

NAGATA3_API join_status join_border_nearest(const join_border *a, const join_border *b, int pair[2])
{
    n3_real best = 0;
    int i, k;
    pair[0] = pair[1] = -1;
    for (i = 0; i < a->loops; i++)
        for (k = 0; k < b->loops; k++) {
            n3_real d;
            if (!a->loop[i].closed || !b->loop[k].closed) continue;
            d = joini_loop_distance(a, i, b, k) + joini_loop_distance(b, k, a, i);
            if (pair[0] >= 0 && !(d < best)) continue;
            best = d;
            pair[0] = i;
            pair[1] = k;
        }
    return pair[0] < 0 ? JOIN_NO_LOOP : JOIN_OK;
}

/* ---- Definitions: rims ---- */

/* The way out of the triangle across its side, unit, in its plane. */
NAGATA3_API n3_vec joini_way_out(const join_border *b, int side)
{
    n3_vec x0 = n3i_point(b->mesh, n3i_at(b->mesh, side));
    n3_vec x1 = n3i_point(b->mesh, n3i_at(b->mesh, n3i_after(side)));
    n3_vec n = n3i_fan_normal(b->mesh, b->topology, side / 3);
    return n3_unit(n3_cross(n3_unit(n3_sub(x1, x0)), n));
}

/* The part of the way from one direction to another up to where it comes within 30 degrees of
   the border: a and b are the cosines of both with the way out across it. */
NAGATA3_API n3_real joini_reach(n3_real a, n3_real b)
{
    const n3_real low = (n3_real)1 / 2;
    if (b >= low) return 1;
    return a > low ? (a - low) / (a - b) : 0;
}

/* The unit tangent between the planes of two border triangles, from the ways out across them.
   The mean of these, laid into the mean plane, turns into the planes' intersection by the share
   that a crease has in the edges of nagata3.h, all of it from 5.7 degrees between the planes on,
   none below 1.1 or where it runs along the border; and no farther than it still leaves both
   triangles. What a seam's triangle on this curve keeps of the angle between the planes, however
   many rows there are, is at most 0.9 degrees, but half of it where the planes meet along the
   border; there it takes the diagonal to the next curve. */
NAGATA3_API n3_vec joini_tangent(const n3_vec plane[2], const n3_vec out[2])
{
    n3_vec mean = n3_unit(n3_add(out[0], out[1]));
    n3i_joint joint = n3i_joint_of_pairs(plane, 2, mean);
    n3_real w = joint.share;
    int i;
    mean = n3_unit(n3i_off(mean, n3_unit(n3_add(plane[0], plane[1]))));
    for (i = 0; i < 2; i++) {
        n3_real most = joini_reach(n3_dot(mean, out[i]), n3_dot(joint.crease, out[i]));
        if (most < w) w = most;
    }
    return n3_unit(n3_add(n3_mul(1 - w, mean), n3_mul(w, joint.crease)));
}

/* At the point between the border sides before and after it. */
NAGATA3_API join_vertex joini_vertex(const join_border *b, int before, int after, int from_normals)
{
    const n3_mesh *m = b->mesh;
    n3_vec plane[2], given[2], out[2];
    join_vertex v;
    int i;
    v.side = after;
    v.point = n3i_at(m, after);
    v.x = n3i_point(m, v.point);
    v.s = 0;
    plane[0] = n3i_fan_normal(m, b->topology, before / 3);
    plane[1] = n3i_fan_normal(m, b->topology, after / 3);
    given[0] = n3i_corner_normal(m, n3i_after(before));
    given[1] = n3i_corner_normal(m, after);
    for (i = 0; i < 2; i++)
        if (from_normals && !n3i_is_zero(given[i])) plane[i] = given[i];
    v.n = n3_unit(n3_add(plane[0], plane[1]));
    out[0] = joini_way_out(b, before);
    out[1] = joini_way_out(b, after);
    v.t = joini_tangent(plane, out);
    return v;
}

NAGATA3_API join_status join_rim_make(const join_border *b, int loop, int from_normals,
                                      join_vertex *vertex, join_rim *rim)
{
    const int *side;
    n3_real length = 0;
    int i, n;
    if (loop < 0 || loop >= b->loops) return JOIN_NO_LOOP;
    if (!b->loop[loop].closed) return JOIN_OPEN;
    side = b->side + b->loop[loop].first;
    n = b->loop[loop].count;
    for (i = 0; i < n; i++)
        vertex[i] = joini_vertex(b, side[i ? i - 1 : n - 1], side[i], from_normals);
    for (i = 0; i < n; i++) {
        vertex[i].s = length;
        length += n3_len(n3_sub(vertex[(i + 1) % n].x, vertex[i].x));
    }
    for (i = 0; i < n; i++) vertex[i].s = length > 0 ? vertex[i].s / length : 0;
    rim->border = b;
    rim->vertex = vertex;
    rim->count = n;
    rim->start = 0;
    rim->step = 1;
    rim->even = 0;
    return JOIN_OK;
}

/* Vertex k, 0 <= k <= count, counted from the start. */
NAGATA3_API int joini_index(const join_rim *r, int k)
{
    int i = r->step > 0 ? r->start - (r->count - k) : r->start - k;
    return i < 0 ? i + r->count : i;
}

NAGATA3_API const join_vertex *joini_at(const join_rim *r, int k)
{
    return &r->vertex[joini_index(r, k)];
}

/* The parameter of vertex k: 0 at the start, 1 behind the last. */
NAGATA3_API n3_real joini_s(const join_rim *r, int k)
{
    n3_real s;
    if (k == r->count) return 1;
    if (r->even) return (n3_real)k / (n3_real)r->count;
    s = joini_at(r, k)->s - r->vertex[r->start].s;
    if (r->step < 0) s = -s;
    return s < 0 ? s + 1 : s;
}

/* The vertex at s or the last one before it. */
NAGATA3_API int joini_find(const join_rim *r, n3_real s)
{
    int lo = 0, hi = r->count;
    while (hi - lo > 1) {
        int mid = lo + (hi - lo) / 2;
        if (joini_s(r, mid) <= s) lo = mid;
        else hi = mid;
    }
    return lo;
}

/* Between the vertices k and k + 1, at s. */
NAGATA3_API join_vertex joini_between(const join_rim *r, int k, n3_real s)
{
    join_vertex v = *joini_at(r, k), w = *joini_at(r, k + 1);
    n3_real s0 = joini_s(r, k), width = joini_s(r, k + 1) - s0;
    n3_real f = width > 0 ? (s - s0) / width : 0;
    if (!(f > 0)) return v;
    v.x = n3_add(v.x, n3_mul(f, n3_sub(w.x, v.x)));
    v.n = n3_unit(n3_add(n3_mul(1 - f, v.n), n3_mul(f, w.n)));
    v.t = n3_unit(n3_add(n3_mul(1 - f, v.t), n3_mul(f, w.t)));
    return v;
}

/* a mirrored across the plane with the normal v. */
NAGATA3_API n3_vec joini_mirror(n3_vec a, n3_vec v)
{
    v = n3_unit(v);
    return n3_sub(a, n3_mul(2 * n3_dot(a, v), v));
}

/* How far A's normal, carried along the curve to B by two mirrors, is off B's, squared, 0 to 4. The
   first mirror maps the ends onto each other, the second the tangent that then is there onto that
   of B's end, reversed; where these are one already, its normal is what of the chord is across. */
NAGATA3_API n3_real joini_twist(const join_vertex *a, const join_vertex *b, n3_real side)
{
    n3_vec d = n3_unit(n3_sub(b->x, a->x)), n = joini_mirror(a->n, d), t = joini_mirror(a->t, d);
    n3_vec v = n3_add(b->t, t);
    if (n3_len(v) <= N3_OPPOSITE) v = n3i_off(d, t);
    n = n3_sub(joini_mirror(n, v), n3_mul(side, b->n));
    return n3_dot(n, n);
}

/* The middle of a rim's points, and the largest component of a way from there to one. */
NAGATA3_API n3_vec joini_centre(const join_rim *r, n3_real *size)
{
    n3_vec c = n3_v(0, 0, 0), first = r->vertex[0].x;
    int i;
    for (i = 0; i < r->count; i++)
        c = n3_add(c, n3i_over(n3_sub(r->vertex[i].x, first), (n3_real)r->count));
    c = n3_add(c, first);
    for (i = 0; i < r->count; i++)
        *size = n3i_larger(*size, n3i_largest(n3_sub(r->vertex[i].x, c)));
    return c;
}

/* The mean over 64 points of the twist and a quarter of the squared difference of places, from
   their centres, in units of size. */
NAGATA3_API n3_real joini_cost(const join_rim *a, const join_rim *b, n3_vec way, n3_real size)
{
    int samples = a->count < 64 ? a->count : 64, i;
    n3_real side = b->step < 0 ? (n3_real)1 : (n3_real)-1, sum = 0;
    for (i = 0; i < samples; i++) {
        int k = (int)((double)i * a->count / samples);
        n3_real s = joini_s(a, k);
        join_vertex p = *joini_at(a, k), q = joini_between(b, a->even ? k : joini_find(b, s), s);
        n3_vec d = n3i_over(n3_sub(n3_sub(q.x, p.x), way), size);
        sum += joini_twist(&p, &q, side) + n3_dot(d, d) / 4;
    }
    return sum / (n3_real)samples;
}

/* Tries starts of a rim from one up to another, and keeps the best. */
NAGATA3_API void joini_try_starts(join_rim *a, join_rim *b, join_rim *free_one, const int range[3],
                                  n3_vec way, n3_real size, n3_real *least)
{
    int i, best = free_one->start, n = free_one->count;
    for (i = range[0]; i <= range[1]; i += range[2]) {
        n3_real cost;
        free_one->start = i < 0 ? i + n : i % n;
        cost = joini_cost(a, b, way, size);
        if (!(cost < *least)) continue;
        *least = cost;
        best = free_one->start;
    }
    free_one->start = best;
}

/* The best start of the larger rim for one direction of B, of about 256 and then of those beside
   the best of them; returns its cost. */
NAGATA3_API n3_real joini_best_start(join_rim *a, join_rim *b, n3_vec way, n3_real size)
{
    join_rim *free_one = a->count > b->count ? a : b;
    n3_real least = joini_cost(a, b, way, size);
    int range[3], step = 1 + free_one->count / 256;
    range[0] = 0;
    range[1] = free_one->count - 1;
    range[2] = step;
    joini_try_starts(a, b, free_one, range, way, size, &least);
    range[0] = free_one->start - step + 1;
    range[1] = free_one->start + step - 1;
    range[2] = 1;
    joini_try_starts(a, b, free_one, range, way, size, &least);
    return least;
}

NAGATA3_API int joini_vertex_of(const join_rim *r, int point)
{
    int i;
    for (i = 0; i < r->count; i++)
        if (r->vertex[i].point == point) return i;
    return -1;
}

/* Sets the start of both rims, given or found, for the direction that B has; returns the cost. */
NAGATA3_API n3_real joini_match(join_rim *a, join_rim *b, const int start[2])
{
    n3_real size = 0;
    n3_vec way = joini_centre(a, &size);
    way = n3_sub(joini_centre(b, &size), way);
    if (!(size > 0)) size = 1;
    a->start = start ? joini_vertex_of(a, start[0]) : 0;
    b->start = start ? joini_vertex_of(b, start[1]) : 0;
    return start ? joini_cost(a, b, way, size) : joini_best_start(a, b, way, size);
}

/* True if the rims run through the same places from their starts on. */
NAGATA3_API int joini_same_places(const join_rim *a, const join_rim *b)
{
    int i = 0;
    while (i < a->count && n3i_order(joini_at(a, i)->x, joini_at(b, i)->x) == 0) i++;
    return i == a->count;
}

NAGATA3_API int joini_are_coincident(const join_rim *a, const join_rim *b)
{
    join_rim r = *b;
    int i;
    if (a->count != b->count) return 0;
    for (i = 0; i < 2 * b->count; i++) {
        r.start = i / 2;
        r.step = i % 2 ? 1 : -1;
        if (joini_same_places(a, &r)) return 1;
    }
    return 0;
}

NAGATA3_API join_status join_rims_match(join_rim *a, join_rim *b, const int start[2], int along,
                                        int *item)
{
    join_rim turned_a, turned_b;
    if (joini_are_coincident(a, b)) return joini_blame(JOIN_COINCIDENT, -1, item);
    if (start && joini_vertex_of(a, start[0]) < 0) return joini_blame(JOIN_BAD_START, 0, item);
    if (start && joini_vertex_of(b, start[1]) < 0) return joini_blame(JOIN_BAD_START, 1, item);
    a->even = b->even = a->count == b->count;
    a->step = 1;
    b->step = along > 0 ? 1 : -1;
    turned_a = *a;
    turned_b = *b;
    turned_b.step = 1;
    if (2 * joini_match(&turned_a, &turned_b, start) < joini_match(a, b, start) && along == 0) {
        *a = turned_a;
        *b = turned_b;
    }
    return JOIN_OK;
}

/* ---- Definitions: the curves ---- */

/* The curve that is tangent to both. With tangents of opposite directions it is nearly a half
   circle, with two along the chord the chord itself. */
NAGATA3_API n3_edge joini_curve(join_vertex a, join_vertex b, const join_options *o)
{
    n3_vec d = n3_sub(b.x, a.x), e = n3_unit(d);
    n3_real h;
    if (n3i_is_zero(a.t)) a.t = e;
    if (n3i_is_zero(b.t)) b.t = n3i_neg(e);
    h = 2 * n3_len(d) / 3 / (1 + n3_len(n3_sub(a.t, b.t)) / 2);
    return n3i_edge_of(a.x, n3_add(a.x, n3_mul(o->strength[0] * h, a.t)),
                       n3_add(b.x, n3_mul(o->strength[1] * h, b.t)), b.x);
}

/* Columns at the vertices of both rims, in order; at those of A where the parameters are one.
   Returns how many. */
NAGATA3_API int joini_make_columns(const join_rim *a, const join_rim *b, const join_options *o,
                                   join_column *column)
{
    int i = 0, k = 0, made = 0;
    while (i < a->count || k < b->count) {
        n3_real sa = joini_s(a, i), sb = joini_s(b, k), s = sb < sa ? sb : sa;
        int at_a = k == b->count || (i < a->count && sa <= sb);
        int at_b = i == a->count || (k < b->count && sb <= sa);
        join_vertex v = joini_between(a, at_a ? i : i - 1, s);
        join_vertex w = joini_between(b, at_b ? k : k - 1, s);
        column[made].s = s;
        column[made++].curve =
            o->method == JOIN_STRAIGHT ? n3i_edge_straight(v.x, w.x) : joini_curve(v, w, o);
        i += at_a;
        k += at_b;
    }
    return made;
}

/* ---- Definitions: Fujita's curves ---- */

/* Lines in the plane whose sine is at most this count as parallel: their intersection has lost half
   of its digits. */
#define JOIN_PARALLEL N3_OPPOSITE

/* Keeps of two ways along the plane the one that leads deeper into the mesh. */
NAGATA3_API void joini_deeper(n3_vec way, n3_vec out, n3_vec *best)
{
    way = n3_unit(way);
    if (n3i_is_zero(*best) || n3_dot(way, out) < n3_dot(*best, out)) *best = way;
}

/* The unit tangent away from the mesh along the line in which the triangles at a border point meet
   the plane through it with the unit normal s: across a triangle, or along a side of one. Zero
   where they do not, or lie in it. (F2.4.3) */
NAGATA3_API n3_vec joini_fan_line(const n3_mesh *m, const n3_topology *t, const join_vertex *v,
                                  n3_vec s)
{
    n3_vec x = n3i_point(m, v->point), best = n3_v(0, 0, 0);
    int c = v->side;
    while (c >= 0) {
        n3_vec p = n3_sub(n3i_point(m, n3i_at(m, n3i_after(c))), x);
        n3_vec q = n3_sub(n3i_point(m, n3i_at(m, n3i_after(n3i_after(c)))), x);
        n3_real hp = n3_dot(n3_unit(p), s), hq = n3_dot(n3_unit(q), s);
        int in_p = n3i_abs(hp) <= N3_ALONG, in_q = n3i_abs(hq) <= N3_ALONG;
        if (in_p && !in_q) joini_deeper(p, v->t, &best);
        if (in_q && !in_p) joini_deeper(q, v->t, &best);
        if (!in_p && !in_q && (hp < 0) != (hq < 0))
            joini_deeper(n3_add(n3_mul(n3i_abs(hp), n3_unit(q)), n3_mul(n3i_abs(hq), n3_unit(p))),
                         v->t, &best);
        c = joini_twin(m, t, n3i_after(n3i_after(c)));
    }
    return n3i_neg(best);
}

/* The middle control points in the work plane of the normal s, from the points and the tangents at
   both ends. C is where the lines along the tangents meet, at C = x0 + f0 t0 = x1 + f1 t1. */
NAGATA3_API n3_edge joini_fujita_curve(join_vertex a, join_vertex b, n3_vec s,
                                       const n3_real part[2])
{
    n3_vec d = n3_sub(b.x, a.x), q, r;
    n3_real sine = n3_dot(n3_cross(a.t, b.t), s), f0, f1;
    int short_a, short_b; /* C is at most half as far from one end as from the other */
    if (n3i_abs(sine) <= JOIN_PARALLEL) { /* the middle of the ends, dropped onto both lines */
        f0 = n3_dot(d, a.t) / 2;
        f1 = -n3_dot(d, b.t) / 2;
        return n3i_edge_of(a.x, n3_add(a.x, n3_mul(part[0] * f0, a.t)),
                           n3_add(b.x, n3_mul(part[1] * f1, b.t)), b.x);
    }
    f0 = n3_dot(n3_cross(d, b.t), s) / sine;
    f1 = n3_dot(n3_cross(d, a.t), s) / sine;
    q = n3_mul(part[0] * f0, a.t);                                                  /* (F2.4.3) */
    r = n3_mul(part[1] * f1, b.t);
    short_a = n3i_abs(f0) <= n3i_abs(f1) / 2;
    short_b = n3i_abs(f1) <= n3i_abs(f0) / 2;
    if (short_a) q = n3_mul((f0 < 0 ? -1 : 1) * n3i_abs(f1) / 2, a.t);                /* (F2.5) */
    else if (short_b) r = n3_mul((f1 < 0 ? -1 : 1) * n3i_abs(f0) / 2, b.t);
    return n3i_edge_of(a.x, n3_add(a.x, q), n3_add(b.x, r), b.x);
}

/* The unit normal of the work plane of vertex k, through the line from o1 along axis. (F2.4.1) */
NAGATA3_API n3_vec joini_work_plane(const join_rim *a, int k, n3_vec o1, n3_vec axis)
{
    return n3i_upright(axis, n3_unit(n3_sub(joini_at(a, k)->x, o1)));
}

/* Puts the points of B's loop into the work planes. (F2.4.2) */
NAGATA3_API join_status joini_move(const join_rim *a, const join_rim *b, n3_vec o1, n3_vec axis,
                                   n3_vec *moved, int *item)
{
    const n3_mesh *m = b->border->mesh;
    int k;
    for (k = 0; k < m->points; k++) moved[k] = n3i_point(m, k);
    for (k = 0; k < a->count; k++) {
        n3_vec s = joini_work_plane(a, k, o1, axis), *x = &moved[joini_at(b, k)->point];
        if (n3i_is_zero(s)) return joini_blame(JOIN_NO_PLANE, joini_at(a, k)->point, item);
        *x = n3_sub(*x, n3_mul(n3_dot(n3_sub(*x, o1), s), s));
    }
    return JOIN_OK;
}

/* All points of B's loop move before any line is sought, as its triangles change with them. Centres
   nearer to each other than half the digits of the loops' size are one. */
NAGATA3_API join_status joini_fujita_columns(const join_rim *a, const join_rim *b,
                                             const n3_real part[2], join_column *column,
                                             n3_vec *moved, int *item)
{
    const n3_mesh *mesh_a = a->border->mesh;
    n3_mesh mesh_b = *b->border->mesh;
    n3_real size = 0;
    n3_vec o1 = joini_centre(a, &size), axis = n3_sub(joini_centre(b, &size), o1);
    join_status status;
    int k;
    axis = n3_len(axis) <= N3_OPPOSITE * size ? n3_v(0, 0, 0) : n3_unit(axis);
    status = joini_move(a, b, o1, axis, moved, item);
    mesh_b.point = &moved->x;
    mesh_b.point_stride = 0;
    for (k = 0; k < a->count && status == JOIN_OK; k++) {
        join_vertex v = *joini_at(a, k), w = *joini_at(b, k);
        n3_vec s = joini_work_plane(a, k, o1, axis);
        v.t = joini_fan_line(mesh_a, a->border->topology, &v, s);
        w.t = joini_fan_line(&mesh_b, b->border->topology, &w, s);
        w.x = moved[w.point];
        if (n3i_is_zero(v.t)) return joini_blame(JOIN_NO_LINE, v.point, item);
        if (n3i_is_zero(w.t)) return joini_blame(JOIN_NO_LINE, mesh_a->points + w.point, item);
        column[k].s = joini_s(a, k);
        column[k].curve = joini_fujita_curve(v, w, s, part);
    }
    return status;
}

/* ---- Definitions: the bridge ---- */

NAGATA3_API join_options joini_defaults(const join_options *given)
{
    join_options o = {JOIN_NAGATA, {0, 0}};
    int i;
    if (given) o = *given;
    for (i = 0; i < 2; i++)
        if (!(o.strength[i] > 0)) o.strength[i] = o.method == JOIN_FUJITA ? (n3_real)2 / 3 : 1;
    return o;
}

NAGATA3_API join_status join_columns(const join_rim *a, const join_rim *b, const join_options *o,
                                     join_column *column, n3_vec *moved, join_bridge *bridge,
                                     int *item)
{
    join_options used = joini_defaults(o);
    bridge->a = *a;
    bridge->b = *b;
    bridge->column = column;
    bridge->columns = a->count;
    bridge->rows = 0;
    bridge->fixed = used.method == JOIN_FUJITA;
    if (bridge->fixed && a->count != b->count) return JOIN_UNEQUAL;
    if (n3i_count_add(a->count, b->count) < 0) return JOIN_BAD_COUNT;
    if (bridge->fixed) return joini_fujita_columns(a, b, used.strength, column, moved, item);
    bridge->columns = joini_make_columns(a, b, &used, column);
    return JOIN_OK;
}

NAGATA3_API int join_rows(const join_bridge *bridge, n3_real tolerance)
{
    const n3_real most = 1000000;
    n3_real bend = 0, pieces;
    int i, k;
    for (i = 0; i < bridge->columns; i++)
        for (k = 1; k < 3; k++) {
            const n3_vec *p = bridge->column[i].curve.p + k;
            n3_vec second = n3_sub(n3_sub(p[1], p[0]), n3_sub(p[0], p[-1]));
            bend = n3i_larger(bend, n3_len(second));
        }
    if (!(tolerance > 0)) return -1;
    pieces = n3i_sqrt(bend / tolerance * 3 / 4); /* |x''| <= 6 bend */
    if (!(pieces < most)) return -1;
    i = (int)pieces;
    return (n3_real)i < pieces ? i : i > 0 ? i - 1 : 0;
}

/* The points of row r: from one rim's number to the other's, with each rim's own beside it. */
NAGATA3_API int joini_row_count(const join_bridge *b, int r)
{
    int n = b->a.count, k = b->b.count;
    if (r == 0 || n == k) return n;
    if (r > b->rows) return k;
    if (b->rows == 1) return n > k ? n : k;
    return (int)(n + ((double)k - n) * (r - 1) / (b->rows - 1) + 1.0 / 2);
}

/* The parameter of a rim x vertices along it, 0 <= x <= count. */
NAGATA3_API n3_real joini_s_along(const join_rim *r, double x)
{
    int k = (int)x;
    n3_real f = (n3_real)(x - k), s = joini_s(r, k);
    return f > 0 ? s + f * (joini_s(r, k + 1) - s) : s;
}

/* The parameter of the point k of row r, 0 <= k <= its count: spaced as on the rim that is
   nearer, in proportion. */
NAGATA3_API n3_real joini_row_s(const join_bridge *b, int r, int k)
{
    int n = joini_row_count(b, r);
    n3_real w = b->rows > 1 ? (n3_real)(r - 1) / (n3_real)(b->rows - 1) : n == b->b.count;
    if (r == 0 || b->a.even) return joini_s(&b->a, k);
    if (r > b->rows) return joini_s(&b->b, k);
    return (1 - w) * joini_s_along(&b->a, (double)k * b->a.count / n) +
           w * joini_s_along(&b->b, (double)k * b->b.count / n);
}

/* The point at s between the loops' points, t of the way: on a column, or between two on the line
   that joins them. */
NAGATA3_API n3_vec joini_surface(const join_bridge *b, n3_real s, n3_real t)
{
    int lo = 0, hi = b->columns;
    n3_real width;
    n3_vec x, y;
    while (hi - lo > 1) {
        int mid = lo + (hi - lo) / 2;
        if (b->column[mid].s <= s) lo = mid;
        else hi = mid;
    }
    x = n3_edge_point(&b->column[lo].curve, t);
    if (b->column[lo].s >= s) return x;
    width = (hi < b->columns ? b->column[hi].s : 1) - b->column[lo].s;
    y = n3_edge_point(&b->column[hi < b->columns ? hi : 0].curve, t);
    return n3_add(x, n3_mul((s - b->column[lo].s) / width, n3_sub(y, x)));
}

NAGATA3_API join_status join_counts(const join_bridge *b, int *points, int *triangles)
{
    const n3_mesh *ma = b->a.border->mesh, *mb = b->b.border->mesh;
    int r, n = n3i_count_add(ma->points, mb->points);
    int k = n3i_count_add(ma->triangles, mb->triangles);
    if (b->rows < 0) return JOIN_BAD_COUNT;
    for (r = 0; r <= b->rows && n >= 0 && k >= 0; r++) {
        if (r > 0) n = n3i_count_add(n, joini_row_count(b, r));
        k = n3i_count_add(k, joini_row_count(b, r));
        k = n3i_count_add(k, joini_row_count(b, r + 1));
    }
    if (n < 0 || n3i_count_mul(k, 3) < 0) return JOIN_BAD_COUNT;
    if (points) *points = n;
    if (triangles) *triangles = k;
    return JOIN_OK;
}

/* The number of the point k of row r, whose own points begin with first. */
NAGATA3_API int joini_number(const join_bridge *b, int r, int first, int k)
{
    if (k == joini_row_count(b, r)) k = 0;
    if (r == 0) return joini_at(&b->a, k)->point;
    if (r > b->rows) return b->a.border->mesh->points + joini_at(&b->b, k)->point;
    return first + k;
}

/* How much a triangle bends, |n - n'|, from one with the unit normal face. */
NAGATA3_API n3_real joini_bend(n3_vec a, n3_vec b, n3_vec c, n3_vec face)
{
    n3_vec n = n3_cross(n3_unit(n3_sub(b, a)), n3_unit(n3_sub(c, a)));
    return n3_len(n3_sub(n3_unit(n), face));
}

/* The normal of the border triangle at the side from vertex k to the next, as it looks in the
   joined mesh. */
NAGATA3_API n3_vec joini_border_normal(const join_rim *r, int k, int turned)
{
    int side = joini_at(r, r->step > 0 ? k : k + 1)->side;
    n3_vec n = n3i_fan_normal(r->border->mesh, r->border->topology, side / 3);
    return turned ? n3i_neg(n) : n;
}

/* How much better the seam becomes by the diagonal from vertex k + 1 of the next row than by the
   other one, in the cell of the vertices i and k; 0 where there is no seam. */
NAGATA3_API n3_real joini_gain(const join_bridge *b, int r, int i, int k, const n3_vec x[4])
{
    n3_vec face;
    if (r == 0) {
        face = joini_border_normal(&b->a, i, 0);
        return joini_bend(x[0], x[2], x[1], face) - joini_bend(x[0], x[3], x[1], face);
    }
    if (r < b->rows) return 0;
    face = joini_border_normal(&b->b, k, b->b.step > 0);
    return joini_bend(x[1], x[2], x[3], face) - joini_bend(x[0], x[2], x[3], face);
}

/* Of the cell with two new corners, i + 1 on row r and k + 1 on the next: true if the diagonal
   from k + 1 is the better one: at a seam by 0.9 degrees there, else by being longer than the other
   by no more than one part in 1024. */
NAGATA3_API int joini_cut(const join_bridge *b, int r, int i, int k, const n3_vec *point,
                          const int cell[4])
{
    n3_vec x[4];
    n3_real gain, one, other;
    int c;
    if (b->fixed) return 1;                                                         /* (F2.4.4) */
    for (c = 0; c < 4; c++) x[c] = point[cell[c]];
    gain = joini_gain(b, r, i, k, x);
    if (n3i_abs(gain) > (n3_real)1 / 64) return gain > 0;
    one = n3_len(n3_sub(x[0], x[3]));
    other = n3_len(n3_sub(x[1], x[2]));
    return !(other < one - one / 1024);
}

/* The triangles between row r and the next, whose own points begin with first and next. No point
   has all of the other row, or the edge where that begins and ends would have four triangles. */
NAGATA3_API int *joini_strip(const join_bridge *b, int r, int first, int next, const n3_vec *point,
                             int *triangle)
{
    int n = joini_row_count(b, r), m = joini_row_count(b, r + 1), cell[4], forward;
    int i = 0, k = 0, i_at_k = 0, k_at_i = 0; /* where the other one was at the last step */
    while (i < n || k < m) {
        n3_real s = i < n ? joini_row_s(b, r, i + 1) : 2;
        n3_real q = k < m ? joini_row_s(b, r + 1, k + 1) : 2;
        cell[0] = joini_number(b, r, first, i);
        cell[1] = joini_number(b, r, first, i < n ? i + 1 : i);
        cell[2] = joini_number(b, r + 1, next, k);
        cell[3] = joini_number(b, r + 1, next, k < m ? k + 1 : k);
        forward = q < s || (!(s < q) && joini_cut(b, r, i, k, point, cell));
        if (k == m - 1 && i < n && k_at_i == 0) forward = 0;
        if (i == n - 1 && k < m && i_at_k == 0) forward = 1;
        triangle[0] = cell[0];
        triangle[1] = cell[2];
        triangle[2] = forward ? cell[3] : cell[1];
        triangle += 3;
        if (forward) {
            k++;
            i_at_k = i;
        } else {
            i++;
            k_at_i = k;
        }
    }
    return triangle;
}

NAGATA3_API void joini_copy(const n3_mesh *m, int shift, int turned, const n3_vec *moved,
                            n3_vec *point, int *triangle)
{
    int i;
    for (i = 0; i < m->points; i++) point[i] = moved ? moved[i] : n3i_point(m, i);
    for (i = 0; i < 3 * m->triangles; i++) {
        int c = turned && i % 3 ? i / 3 * 3 + 3 - i % 3 : i;
        triangle[i] = n3i_at(m, c) + shift;
    }
}

NAGATA3_API join_status join_mesh(const join_bridge *b, const n3_vec *moved, n3_vec *point,
                                  int *triangle)
{
    const n3_mesh *ma = b->a.border->mesh, *mb = b->b.border->mesh;
    join_status status = join_counts(b, NULL, NULL);
    int r, k, first, next = ma->points + mb->points;
    if (status != JOIN_OK) return status;
    joini_copy(ma, 0, 0, NULL, point, triangle);
    joini_copy(mb, ma->points, b->b.step > 0, b->fixed ? moved : NULL, point + ma->points,
               triangle + 3 * ma->triangles);
    triangle += 3 * ((size_t)ma->triangles + (size_t)mb->triangles);
    for (r = 0; r <= b->rows; r++) {
        first = next;
        next = r ? first + joini_row_count(b, r) : first;
        for (k = 0; r < b->rows && k < joini_row_count(b, r + 1); k++)
            point[next + k] = joini_surface(b, joini_row_s(b, r + 1, k),
                                            (n3_real)(r + 1) / (n3_real)(b->rows + 1));
        triangle = joini_strip(b, r, first, next, point, triangle);
    }
    return JOIN_OK;
}

/* 0, 1: a triangle of A, of B; 2: of the bridge. */
NAGATA3_API int joini_origin(const join_bridge *b, int triangle)
{
    int a = b->a.border->mesh->triangles;
    return triangle < a ? 0 : triangle < a + b->b.border->mesh->triangles ? 1 : 2;
}

NAGATA3_API int join_seam(const join_bridge *b, const n3_mesh *joined, const n3_topology *t,
                          int where, n3_real jump[2])
{
    int e, k, two[2], count = 0;
    jump[0] = jump[1] = 0;
    for (e = 0; e < t->edges; e++) {
        n3_real d;
        if (!n3i_is_regular(joined, t, e, two)) continue;
        k = joini_origin(b, two[0] / 3) == 2;
        if (joini_origin(b, two[k] / 3) != where || joini_origin(b, two[!k] / 3) != 2) continue;
        d = n3_len(n3_sub(n3i_face_of(joined, two[0] / 3).normal,
                          n3i_face_of(joined, two[1] / 3).normal));
        if (count == 0 || d < jump[0]) jump[0] = d;
        jump[1] = n3i_larger(jump[1], d);
        count++;
    }
    return count;
}

#endif

/* SPDX-License-Identifier: MIT. Copyright 2026 the nagata3 authors; the text is in LICENSE. */
