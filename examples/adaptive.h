/* adaptive.h: Part II of nagata3.h, continued; to be merged into it behind its refinement. */
#ifndef ADAPTIVE_H
#define ADAPTIVE_H

#include "nagata3.h"

#if defined __cplusplus && __cplusplus >= 201103L
inline namespace N3I_PICK(nagata3_double, nagata3_float) {
#elif defined __cplusplus
namespace N3I_PICK(nagata3_double, nagata3_float) {
#endif

/* ---- Refinement to a distance ---- */

/* How an edge or a triangle is cut. parts: of an edge, its parts; of a triangle, how finely it is
   cut inside, a number that n3_mesh_cut alone need understand. first: the first new point. */
typedef struct n3_cut { int parts, first; } n3_cut;

/* Decides how finely n3_mesh_refine_cut cuts each edge and each triangle, so that no part of the
   surface is farther from its facet than distance > 0, and counts what that makes.
   An edge is cut into sqrt(D / distance) parts, rounded up, so that a chord is within 3/4 of the
   distance. D is the longer of the second differences p30 - 2 p21 + p12 and p21 - 2 p12 + p03 of
   its control points, or half the twist of a patch along it, if that is larger: all triangles at an
   edge cut it alike. A triangle takes its sides' points as they are, and inside as few points as
   bring every facet within the distance, by a bound: that on the control vectors of the cubic's
   difference from the facet, which are made of second differences of the net. Where the patch is
   nearly flat, a vector along it counts only by the patch's slope.
   cut: [edges + triangles], the edges first. points, triangles, normals: what will be made; each
   may be NULL. N3_BAD_COUNT where an edge or a row wants more than 4096 parts (item: the edge, -1),
   or where a count leaves int. Linear in what is made, 0.3 us for a facet. */
NAGATA3_API n3_status n3_mesh_cut(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                  n3_real distance, n3_cut *cut, int *points, int *triangles,
                                  int *normals, int *item);

/* The surface as triangles, as n3_mesh_cut has decided. The points are first those of the mesh;
   then those on each edge from its lower to its higher point; then those inside each patch. Each is
   computed once and the triangles that meet there share it: closed meshes stay closed. Where all
   parts are equal it makes the points and triangles of n3_mesh_refine.
   Every output may be NULL. point, triangle, parent and uv as there. normal: the patches' own, for
   each its corners, the points of its sides ab, bc and ca, then those inside; corner: 3 normals for
   each new triangle; origin: for each new triangle, that of the mesh. Linear in the output. */
NAGATA3_API n3_status n3_mesh_refine_cut(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                         const n3_cut *cut, n3_vec *point, int *triangle,
                                         n3_vec *normal, int *corner, int *origin, int *parent,
                                         n3_real *uv);

/* ---- Definitions: how a triangle is cut ---- */

/* The most parts of an edge or a row: the product of two of them is exact in n3_real. */
enum { N3I_PARTS = 4096 };

/* A triangle is cut in one of two ways, between sides of so many parts each.
   Into rows parallel to its base, the side from its corner base to the next, one with the fewest
   parts. Row 0 is the base, row rows the apex; those between have points inside, so that the
   longest has as many parts as parts says. Their ends are points of the two other sides, where
   several rows may end in one. With equal parts everywhere it is the lattice of n3_mesh_refine.
   Or, with inner > 0, round a lattice of inner - 2 parts, which is at the weights

       (i + 2/3) / inner, (j + 2/3) / inner, (k + 2/3) / inner,        i + j + k = inner - 2

   It is one of inner parts, but that its rim lies at 2/3 of a row from the sides, where it fits to
   them wherever their points are: in an equilateral triangle with sides of inner parts, no facet
   between them has a larger circumcircle than those within. */
typedef struct n3i_cut { int side[3], base, parts, inner, strips; } n3i_cut;

/* parts < 0: round an inner lattice of -parts. There are as many strips as rows, or those at the
   sides and those within. */
NAGATA3_API n3i_cut n3i_cut_make(const int side[3], int parts)
{
    n3i_cut c;
    int i;
    c.base = 0;
    c.inner = parts < 0 ? -parts : 0;
    c.strips = c.parts = parts;
    for (i = 0; i < 3; i++) {
        c.side[i] = side[i];
        if (side[i] < side[c.base]) c.base = i;
        if (side[i] > c.strips) c.strips = side[i];
    }
    if (c.inner) c.strips = c.inner + 1;
    return c;
}

NAGATA3_API int n3i_row_parts(const n3i_cut *c, int row)
{
    return ((c->strips - row) * c->parts + c->strips - 1) / c->strips;
}

/* The points inside that are on a row, here one of the inner lattice where there is such. */
NAGATA3_API int n3i_row_inside(const n3i_cut *c, int row)
{
    if (c->inner) return row < c->inner - 1 ? c->inner - 1 - row : 0;
    return row == 0 || row == c->strips ? 0 : n3i_row_parts(c, row) - 1;
}

NAGATA3_API int n3i_cut_inside(const n3i_cut *c)
{
    int row, n = 0;
    for (row = 0; row < c->strips; row++) n += n3i_row_inside(c, row);
    return n;
}

/* A point of the cut triangle. Its index counts the corners, then the points of the sides, then
   those inside, row by row. */
typedef struct n3i_spot { int index; n3_real u, v; } n3i_spot;

/* The index of the first point inside. */
NAGATA3_API int n3i_cut_first(const n3i_cut *c) { return c->side[0] + c->side[1] + c->side[2]; }

NAGATA3_API n3i_spot n3i_spot_at(int index, int corner, n3_real w, n3_real next, n3_real last)
{
    n3_real weight[3];
    n3i_spot s;
    weight[corner] = w;
    weight[(corner + 1) % 3] = next;
    weight[(corner + 2) % 3] = last;
    s.index = index;
    s.u = weight[1];
    s.v = weight[2];
    return s;
}

/* At k parts of a side from its corner; on bc so that 1 - u - v is exactly 0. */
NAGATA3_API n3i_spot n3i_side_spot(const n3i_cut *c, int side, int k)
{
    int i, parts = c->side[side], index = 2 + k;
    n3_real w = (n3_real)(parts - k) / (n3_real)parts;
    n3_real next = side == 1 ? 1 - w : (n3_real)k / (n3_real)parts;
    for (i = 0; i < side; i++) index += c->side[i] - 1;
    if (k == 0) index = side;
    if (k == parts) index = (side + 1) % 3;
    return n3i_spot_at(index, side, w, next, 0);
}

/* The point of a side of so many parts that is next to k / n of the way. Only the end at the base
   takes more than one row that is none of its own: no facet then lies in the side. */
NAGATA3_API int n3i_snap(int k, int n, int parts, int up)
{
    int at = (2 * k * parts + n) / (2 * n);
    if (k == 0 || k == n) return at;
    if (parts == 1) return up ? 0 : 1;
    return at < 1 ? 1 : at > parts - 1 ? parts - 1 : at;
}

/* Point i of a row, of which the first inside has the index first. */
NAGATA3_API n3i_spot n3i_row_spot(const n3i_cut *c, int row, int i, int first)
{
    int rows = c->strips, parts = n3i_row_parts(c, row), all = rows * parts;
    int left = (c->base + 2) % 3, right = (c->base + 1) % 3;
    if (row == 0)
        return n3i_side_spot(c, c->base, n3i_snap(i, parts, c->side[c->base], 1));
    if (i == parts)
        return n3i_side_spot(c, right, n3i_snap(row, rows, c->side[right], 1));
    if (i == 0)
        return n3i_side_spot(c, left, n3i_snap(rows - row, rows, c->side[left], 0));
    return n3i_spot_at(first + i - 1, c->base, (n3_real)((rows - row) * (parts - i)) / (n3_real)all,
                       (n3_real)((rows - row) * i) / (n3_real)all, (n3_real)row / (n3_real)rows);
}

/* Point i of row j of the inner lattice. */
NAGATA3_API n3i_spot n3i_inner_spot(const n3i_cut *c, int i, int j)
{
    int index = n3i_cut_first(c) + j * (c->inner - 1) - j * (j - 1) / 2 + i;
    int k = c->inner - 2 - i - j;
    n3_real all = (n3_real)(3 * c->inner);
    return n3i_spot_at(index, 0, (n3_real)(3 * k + 2) / all, (n3_real)(3 * i + 2) / all,
                       (n3_real)(3 * j + 2) / all);
}

/* ---- Definitions: the facets of a cut triangle ---- */

/* A strip of facets lies between two chains of points, a low one and a high one, of so many parts.
   Rows: strip i is between row i and the next. Else strips 0 to 2 are between the sides and the
   inner lattice, the others between its rows. On the way through the facets: at which points of
   the chains; the index of the low chain's first point inside. */
typedef struct n3i_walk { int strip, parts[2], at[2], first; } n3i_walk;

NAGATA3_API void n3i_walk_strip(const n3i_cut *c, n3i_walk *w, int strip, int first)
{
    w->strip = strip;
    w->first = first;
    w->at[0] = w->at[1] = 0;
    w->parts[0] = c->inner ? c->inner + 1 - strip : n3i_row_parts(c, strip);
    w->parts[1] = c->inner ? w->parts[0] - 1 : n3i_row_parts(c, strip + 1);
    if (!c->inner || strip >= 3) return;
    w->parts[0] = c->side[strip];
    w->parts[1] = c->inner - 2;
}

NAGATA3_API n3i_walk n3i_walk_start(const n3i_cut *c)
{
    n3i_walk w;
    n3i_walk_strip(c, &w, 0, n3i_cut_first(c));
    return w;
}

/* Where the walk is on the low or on the high chain. */
NAGATA3_API n3i_spot n3i_walk_spot(const n3i_cut *c, const n3i_walk *w, int high)
{
    int i = w->at[high], last = c->inner - 2;
    int first = high ? w->first + n3i_row_inside(c, w->strip) : w->first;
    if (!c->inner) return n3i_row_spot(c, w->strip + high, i, first);
    if (w->strip >= 3) return n3i_inner_spot(c, i, w->strip - 3 + high);
    if (!high) return n3i_side_spot(c, w->strip, i);
    if (w->strip == 0) return n3i_inner_spot(c, i, 0);
    return w->strip == 1 ? n3i_inner_spot(c, last - i, i) : n3i_inner_spot(c, 0, last - i);
}

/* Whether the next facet stands on the low chain: on it the middle of the next part comes first.
   Beside a side the inner lattice begins one part from its end. */
NAGATA3_API int n3i_walk_is_low(const n3i_cut *c, const n3i_walk *w)
{
    int low = 2 * w->at[0] + 1, high = 2 * w->at[1] + 1;
    if (w->at[1] == w->parts[1] || w->at[0] == w->parts[0]) return w->at[0] < w->parts[0];
    if (c->inner && w->strip < 3) return low * c->inner < (high + 2) * w->parts[0];
    return low * w->parts[1] < high * w->parts[0];
}

NAGATA3_API void n3i_walk_step(const n3i_cut *c, n3i_walk *w, n3i_spot out[3])
{
    int high = !n3i_walk_is_low(c, w);
    out[high] = n3i_walk_spot(c, w, high);
    out[2] = n3i_walk_spot(c, w, !high);
    w->at[high]++;
    out[!high] = n3i_walk_spot(c, w, high);
    if (w->at[0] == w->parts[0] && w->at[1] == w->parts[1])
        n3i_walk_strip(c, w, w->strip + 1, w->first + n3i_row_inside(c, w->strip));
}

/* The next facet that has three points; false: there is none. */
NAGATA3_API int n3i_walk_next(const n3i_cut *c, n3i_walk *w, n3i_spot out[3])
{
    while (w->strip < c->strips) {
        n3i_walk_step(c, w, out);
        if (out[0].index != out[1].index && out[1].index != out[2].index &&
            out[2].index != out[0].index)
            return 1;
    }
    return 0;
}

/* ---- Definitions: the distance between a facet and its part of the patch ---- */

/* The patch as its second differences at the corners, second derivatives over 6: along u, along
   both, along v. And which share of a vector leads away from the patch: the one along N, and of the
   rest not more than the slope, the largest tangent of an angle between its normals and N. */
typedef struct n3i_bend { n3_vec at[3][3], N; n3_real slope; } n3i_bend;

/* All normals of the patch are sums of products of the net of du and dv. */
NAGATA3_API void n3i_bend_slope(const n3_patch *p, n3i_bend *b)
{
    n3_patch boxed = n3i_patch_boxed(p);
    n3_vec net[5][5], sum = n3_v(0, 0, 0);
    int i, j;
    n3i_normal_net(&boxed, net);
    for (i = 0; i < 5; i++)
        for (j = 0; i + j < 5; j++) sum = n3_add(sum, net[i][j]);
    b->N = n3_unit(sum);
    b->slope = 0;
    for (i = 0; i < 5; i++)
        for (j = 0; i + j < 5; j++) {
            n3_real height = n3_dot(net[i][j], b->N), side = n3_len(n3_cross(net[i][j], b->N));
            if (side >= height) b->slope = side > 0 ? 1 : b->slope;
            else b->slope = n3i_larger(b->slope, side / height);
        }
}

NAGATA3_API n3i_bend n3i_bend_of(const n3_patch *p)
{
    static const int at[4][4] = {{0, 8, 7, 2}, {3, 9, 6, 0}, {4, 5, 0, 0}, {1, 0, 0, 0}};
    n3i_bend b;
    int c;
    for (c = 0; c < 3; c++) {
        int i = c == 1, j = c == 2;
        n3_vec o = p->p[at[i][j]], u = n3_sub(p->p[at[i + 1][j]], o);
        n3_vec v = n3_sub(p->p[at[i][j + 1]], o);
        b.at[c][0] = n3_sub(n3_sub(p->p[at[i + 2][j]], p->p[at[i + 1][j]]), u);
        b.at[c][1] = n3_sub(n3_sub(p->p[at[i + 1][j + 1]], p->p[at[i + 1][j]]), v);
        b.at[c][2] = n3_sub(n3_sub(p->p[at[i][j + 2]], p->p[at[i][j + 1]]), v);
    }
    n3i_bend_slope(p, &b);
    return b;
}

/* The second difference at a spot along the way from x to y. */
NAGATA3_API n3_vec n3i_bend_along(const n3i_bend *b, const n3i_spot *at, const n3i_spot *x,
                                  const n3i_spot *y)
{
    n3_real u = y->u - x->u, v = y->v - x->v, w = 1 - at->u - at->v;
    n3_vec of[3];
    int c;
    for (c = 0; c < 3; c++)
        of[c] = n3i_mix(u * u, b->at[c][0], 2 * u * v, b->at[c][1], v * v, b->at[c][2]);
    return n3i_mix(w, of[0], at->u, of[1], at->v, of[2]);
}

/* The control vectors of the difference between a facet's part of the patch and the facet, with
   the second differences G_i along a side e at its corners:

       side      d_iij = -(2 G_i + G_j) / 3
       centre    d_123 = (G_1(12) + G_1(13) - G_1(23)) / 2 + d_112 + d_113

   out: the sides' two each, then the centre. */
NAGATA3_API void n3i_facet_net(const n3i_bend *b, const n3i_spot s[3], n3_vec out[7])
{
    n3_vec first = n3_v(0, 0, 0);
    int i;
    for (i = 0; i < 3; i++) {
        const n3i_spot *x = &s[i], *y = &s[(i + 1) % 3];
        n3_vec gx = n3i_bend_along(b, x, x, y), gy = n3i_bend_along(b, y, x, y);
        out[2 * i] = n3i_over(n3_add(gx, n3_add(gx, gy)), -3);
        out[2 * i + 1] = n3i_over(n3_add(gy, n3_add(gx, gy)), -3);
        if (i != 1) first = n3_add(first, i == 0 ? gx : gy);
    }
    first = n3_sub(first, n3i_bend_along(b, &s[0], &s[1], &s[2]));
    out[6] = n3_add(n3_mul((n3_real)1 / 2, first), n3_add(out[0], out[5]));
}

/* The largest of xy a + yz b + zx c with x + y + z = 1, none of them negative: the square of the
   circumradius of a triangle with sides of the squares a, b, c, or a quarter of the longest. */
NAGATA3_API n3_real n3i_spread(n3_real a, n3_real b, n3_real c)
{
    n3_real most = n3i_larger(n3i_larger(a, b), c);
    if (2 * most >= a + b + c) return most / 4;
    return a * b * c / (2 * (a * b + b * c + c * a) - (a * a + b * b + c * c));
}

/* How far a difference can lead away from the patch: its length, or the share that counts. */
NAGATA3_API n3_real n3i_bend_size(const n3i_bend *b, n3_vec d)
{
    n3_real all = n3_len(d), share = n3i_abs(n3_dot(d, b->N)) + b->slope * all;
    return share < all ? share : all;
}

/* Whether the difference is nowhere longer than the distance. With D the longer vector of each
   side it is at most

       3 (D_12 xy + D_23 yz + D_31 zx) + 3 xyz (2 |d_123| - D_12 - D_23 - D_31),     xyz <= 1/27 */
NAGATA3_API int n3i_is_within(const n3_vec net[7], n3_vec N, n3_real slope, n3_real distance)
{
    n3_real size[7], D[3], excess, bound;
    int i;
    for (i = 0; i < 7; i++)
        size[i] = (n3i_abs(n3_dot(net[i], N)) + slope * n3_len(net[i])) / distance;
    for (i = 0; i < 3; i++) {
        D[i] = n3i_larger(size[2 * i], size[2 * i + 1]);
        if (!(3 * D[i] <= 4)) return 0;
    }
    excess = 2 * size[6] - D[0] - D[1] - D[2];
    bound = 3 * n3i_spread(D[0], D[1], D[2]);
    return (excess > 0 ? bound + excess / 9 : bound) <= 1;
}

/* The number of facets; 0 if one is not within the distance, or is turned over or without an area,
   which can be only where rows have fewer parts than there are rows. */
NAGATA3_API int n3i_cut_facets(const n3i_cut *c, const n3i_bend *b, n3_real distance)
{
    n3i_walk walk = n3i_walk_start(c);
    n3i_spot s[3];
    n3_vec net[7];
    int n = 0;
    for (; n3i_walk_next(c, &walk, s); n++) {
        n3_real area = (s[1].u - s[0].u) * (s[2].v - s[0].v) -
                       (s[2].u - s[0].u) * (s[1].v - s[0].v);
        if (!c->inner && c->parts < c->strips && area <= 16 * N3_EPS) return 0;
        n3i_facet_net(b, s, net);
        if (n3i_is_within(net, n3_v(0, 0, 0), 1, distance)) continue;
        if (b->slope < 1 && n3i_is_within(net, b->N, b->slope, distance)) continue;
        return 0;
    }
    return n;
}

/* ---- Definitions: refinement to a distance ---- */

/* sqrt(size / distance), rounded up, at least 1; 0: more than N3I_PARTS. */
NAGATA3_API int n3i_parts(n3_real size, n3_real distance)
{
    n3_real parts = n3i_sqrt(size / distance);
    int whole;
    if (!(parts <= (n3_real)N3I_PARTS)) return 0;
    whole = (int)parts;
    return whole + ((n3_real)whole < parts || whole == 0);
}

/* The longest second difference along a side, or half the largest twist there if that is longer:
   the second difference along the side and across, by the way from the third corner to that place
   in the middle half of the side where it is least. */
NAGATA3_API n3_real n3i_side_size(const n3i_bend *b, int side)
{
    static const n3i_spot corner[3] = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}};
    const n3i_spot *x = &corner[side], *y = &corner[(side + 1) % 3], *z = &corner[(side + 2) % 3];
    const n3_real quarter = (n3_real)1 / 4;
    n3_real size = 0, square, s;
    int i;
    for (i = 0; i < 2; i++) {
        const n3i_spot *at = i ? y : x;
        n3_vec along = n3i_bend_along(b, at, x, y), across;
        across = n3_mul(quarter, n3_sub(n3i_bend_along(b, at, z, x), n3i_bend_along(b, at, z, y)));
        square = n3_dot(along, along);
        s = square > 0 ? n3_dot(across, along) / square : 0;
        if (!(n3i_abs(s) <= quarter)) s = s < 0 ? -quarter : quarter;
        size = n3i_larger(size, n3_len(along));
        size = n3i_larger(size, n3i_bend_size(b, n3_sub(across, n3_mul(s, along))));
    }
    return size;
}

NAGATA3_API n3_edge n3i_mesh_edge(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                  int edge)
{
    const n3_vec *handle = net + m->points + 2 * edge;
    int end[2];
    n3_mesh_edge_ends(m, t, edge, end);
    return n3i_edge_of(net[end[0]], handle[0], handle[1], net[end[1]]);
}

NAGATA3_API n3i_cut n3i_mesh_cut_of(const n3_topology *t, const n3_cut *cut, int triangle)
{
    int i, side[3];
    for (i = 0; i < 3; i++) {
        int edge = t->edge[3 * triangle + i];
        side[i] = edge < 0 ? 1 : cut[edge].parts;
    }
    return n3i_cut_make(side, cut[t->edges + triangle].parts);
}

/* The first way that does: in rows, with more and more parts, or else round an inner lattice; and
   its facets, 0 if there is none. */
NAGATA3_API n3i_cut n3i_cut_find(const int side[3], const n3_patch *p, n3_real distance,
                                 int *facets)
{
    n3i_bend bend = n3i_bend_of(p);
    n3i_cut c = n3i_cut_make(side, 1);
    int most = c.strips, least = c.side[c.base], parts = least;
    do {
        c = n3i_cut_make(side, parts);
        *facets = n3i_cut_facets(&c, &bend, distance);
        parts += 1 + parts / 8;
    } while (parts < most && !*facets);
    for (parts = least > 2 ? least : 2; parts <= N3I_PARTS && !*facets; parts += 1 + parts / 16) {
        c = n3i_cut_make(side, -parts);
        *facets = n3i_cut_facets(&c, &bend, distance);
    }
    return c;
}

NAGATA3_API n3_status n3i_cut_edges(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                    n3_real distance, n3_cut *cut, int *points, int *item)
{
    int f, i;
    for (i = 0; i < t->edges; i++) cut[i].parts = 1;
    for (f = 0; f < m->triangles; f++) {
        n3_patch p = n3i_mesh_patch(m, t, net, f);
        n3i_bend b = n3i_bend_of(&p);
        for (i = 0; i < 3 && !n3i_is_collapsed(m, f); i++) {
            int edge = t->edge[3 * f + i], parts = n3i_parts(n3i_side_size(&b, i), distance);
            if (parts == 0) return n3i_blame(N3_BAD_COUNT, edge, item);
            if (parts > cut[edge].parts) cut[edge].parts = parts;
        }
    }
    for (i = 0; i < t->edges; i++) {
        cut[i].first = *points;
        *points = n3i_count_add(*points, cut[i].parts - 1);
    }
    return *points < 0 ? n3i_blame(N3_BAD_COUNT, -1, item) : N3_OK;
}

NAGATA3_API n3_status n3_mesh_cut(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                  n3_real distance, n3_cut *cut, int *points, int *triangles,
                                  int *normals, int *item)
{
    n3_status status = n3i_check(m, t, item);
    int f, p, facets, made = 0, n = 0;
    if (status != N3_OK) return status;
    if (!net || !cut) return n3i_blame(N3_NULL_POINTER, -1, item);
    if (!(distance > 0)) return n3i_blame(N3_BAD_COUNT, -1, item);
    p = m->points;
    status = n3i_cut_edges(m, t, net, distance, cut, &p, item);
    for (f = 0; f < m->triangles && status == N3_OK; f++) {
        n3_patch patch = n3i_mesh_patch(m, t, net, f);
        n3_cut *own = &cut[t->edges + f];
        n3i_cut c;
        own->first = p;
        own->parts = 1;
        if (n3i_is_collapsed(m, f)) continue;
        c = n3i_mesh_cut_of(t, cut, f);
        c = n3i_cut_find(c.side, &patch, distance, &facets);
        own->parts = c.parts;
        p = n3i_count_add(p, n3i_cut_inside(&c));
        made = n3i_count_add(made, facets);
        n = n3i_count_add(n, n3i_cut_first(&c) + n3i_cut_inside(&c));
        if (!facets || p < 0 || n < 0 || n3i_count_mul(3, made) < 0)
            status = n3i_blame(N3_BAD_COUNT, -1, item);
    }
    if (points) *points = p;
    if (triangles) *triangles = made;
    if (normals) *normals = n;
    return status;
}

/* The point of the mesh for a point of the cut triangle. */
NAGATA3_API int n3i_cut_point(const n3_mesh *m, const n3_topology *t, const n3_cut *cut,
                              int triangle, const n3i_cut *c, int index)
{
    int i, at = index - 3;
    if (index < 3) return n3i_at(m, 3 * triangle + index);
    for (i = 0; i < 3; i++) {
        int s = 3 * triangle + i, inner = c->side[i] - 1;
        int back = n3i_at(m, s) > n3i_at(m, n3i_after(s));
        if (at < inner) return cut[t->edge[s]].first + (back ? inner - 1 - at : at);
        at -= inner;
    }
    return cut[t->edges + triangle].first + at;
}

/* From the canonical end, so that numbering the points anew changes none. */
NAGATA3_API void n3i_cut_edge_points(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                     const n3_cut *cut, n3_vec *point)
{
    int i, k;
    for (i = 0; i < t->edges; i++) {
        n3_edge e = n3i_mesh_edge(m, t, net, i);
        int parts = cut[i].parts, back = n3i_edge_order(&e) > 0;
        if (back) e = n3_edge_reverse(&e);
        for (k = 1; k < parts; k++)
            point[cut[i].first + (back ? parts - k : k) - 1] =
                n3_edge_point(&e, (n3_real)k / (n3_real)parts);
    }
}

/* What n3_mesh_refine_cut makes, and how far it has come. */
typedef struct n3i_made {
    n3_vec *point, *normal;
    int *triangle, *corner, *origin, *parent;
    n3_real *uv;
    int triangles, normals;
} n3i_made;

NAGATA3_API void n3i_make_spot(const n3_patch *p, const n3i_spot *s, int point, int inside,
                               int triangle, const n3i_made *out)
{
    if (out->point && inside) out->point[point] = n3_patch_point(p, s->u, s->v);
    if (out->normal) out->normal[out->normals + s->index] = n3_patch_normal(p, s->u, s->v);
    if (out->parent) out->parent[point] = triangle;
    if (!out->uv) return;
    out->uv[2 * (size_t)point] = s->u;
    out->uv[2 * (size_t)point + 1] = s->v;
}

/* The points of a triangle: its sides', each without its end, then those inside, which a collapsed
   one has not. */
NAGATA3_API void n3i_make_spots(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                const n3_cut *cut, int triangle, const n3i_made *out)
{
    n3i_cut c = n3i_mesh_cut_of(t, cut, triangle);
    n3_patch p = n3i_mesh_patch(m, t, net, triangle);
    int i, k, row, first = n3i_cut_first(&c), rows = n3i_is_collapsed(m, triangle) ? 0 : c.strips;
    for (i = 0; i < 3; i++)
        for (k = 0; k < c.side[i]; k++) {
            n3i_spot s = n3i_side_spot(&c, i, k);
            int point = n3i_cut_point(m, t, cut, triangle, &c, s.index);
            n3i_make_spot(&p, &s, point, 0, triangle, out);
        }
    for (row = 0; row < rows; row++) {
        for (i = 0; i < n3i_row_inside(&c, row); i++) {
            n3i_spot s = c.inner ? n3i_inner_spot(&c, i, row) : n3i_row_spot(&c, row, i + 1, first);
            int point = n3i_cut_point(m, t, cut, triangle, &c, s.index);
            n3i_make_spot(&p, &s, point, 1, triangle, out);
        }
        first += n3i_row_inside(&c, row);
    }
}

NAGATA3_API void n3i_make_facets(const n3_mesh *m, const n3_topology *t, const n3_cut *cut,
                                 int triangle, const n3i_cut *c, n3i_made *out)
{
    n3i_walk walk = n3i_walk_start(c);
    n3i_spot s[3];
    int i;
    while (n3i_walk_next(c, &walk, s)) {
        for (i = 0; i < 3; i++) {
            size_t k = 3 * (size_t)out->triangles + (size_t)i;
            if (out->triangle)
                out->triangle[k] = n3i_cut_point(m, t, cut, triangle, c, s[i].index);
            if (out->corner) out->corner[k] = out->normals + s[i].index;
        }
        if (out->origin) out->origin[out->triangles] = triangle;
        out->triangles++;
    }
}

/* From the last triangle to the first, so that the lowest stays. */
NAGATA3_API void n3i_make_parents(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                  const n3_cut *cut, int *parent, n3_real *uv)
{
    n3i_made out = {NULL, NULL, NULL, NULL, NULL, NULL, NULL, 0, 0};
    int i;
    out.parent = parent;
    out.uv = uv;
    for (i = 0; i < m->points; i++) {
        if (parent) parent[i] = -1;
        if (uv) uv[2 * (size_t)i] = uv[2 * (size_t)i + 1] = 0;
    }
    for (i = m->triangles - 1; i >= 0; i--) n3i_make_spots(m, t, net, cut, i, &out);
}

NAGATA3_API n3_status n3_mesh_refine_cut(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                         const n3_cut *cut, n3_vec *point, int *triangle,
                                         n3_vec *normal, int *corner, int *origin, int *parent,
                                         n3_real *uv)
{
    n3i_made out = {point, normal, triangle, corner, origin, NULL, NULL, 0, 0};
    n3_status status = n3i_check(m, t, NULL);
    int f, i;
    if (status != N3_OK) return status;
    if (!net || !cut) return N3_NULL_POINTER;
    for (i = 0; i < m->points && point; i++) point[i] = net[i];
    if (point) n3i_cut_edge_points(m, t, net, cut, point);
    for (f = 0; f < m->triangles; f++) {
        n3i_cut c;
        if (n3i_is_collapsed(m, f)) continue;
        c = n3i_mesh_cut_of(t, cut, f);
        if (point || normal) n3i_make_spots(m, t, net, cut, f, &out);
        if (triangle || corner || origin) n3i_make_facets(m, t, cut, f, &c, &out);
        out.normals += n3i_cut_first(&c) + n3i_cut_inside(&c);
    }
    if (parent || uv) n3i_make_parents(m, t, net, cut, parent, uv);
    return N3_OK;
}

#ifdef __cplusplus
}
#endif

#endif
