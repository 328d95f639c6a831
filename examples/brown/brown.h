/* brown.h: Brown's surfaces on top of nagata3.h: squares from their four sides, lattices of them
 * with parameters of shape, and quads with normals.
 *
 * SYNOPSIS
 *
 *     n3_vertex corner[4] = ...;                        points and unit normals, round the quad
 *     brown_square s = brown_quad_make(corner, NULL);
 *     n3_vec x = brown_point(&s, u, v), n = brown_normal(&s, u, v);
 *
 *     brown_lattice l = {columns, rows, point, NULL, NULL, NULL, NULL};
 *     if (brown_lattice_check(&l, &item) == BROWN_OK) s = brown_lattice_square(&l, i, j);
 *
 * THE SURFACE
 *
 * A number in parentheses is an equation of [1]; each has a test of its name. A square is given by
 * its four sides and, along each, the derivative of the surface across it:
 *
 *           v = 1   P(u, 1), P^v(u, 1)
 *              x01 ------------ x11
 *               |                |            side[0]  P(u, 0)    across[0]  P^v(u, 0)
 *     P(0, v)   |                |  P(1, v)   side[1]  P(u, 1)    across[1]  P^v(u, 1)
 *     P^u(0, v) |                |  P^u(1, v) side[2]  P(0, v)    across[2]  P^u(0, v)
 *               |                |            side[3]  P(1, v)    across[3]  P^u(1, v)
 *              x00 ------------ x10
 *           v = 0   P(u, 0), P^v(u, 0)
 *
 * Two lofts, each of Hermite's cubics h over one pair of sides, are blended (1):
 *
 *     Brown(u, v) = g1 A + g2 B,       A = [h(u)] [P(v)]^T,   B = [P(u)] [h(v)]^T
 *     g1 = b^2 / (a^2 + b^2),   g2 = a^2 / (a^2 + b^2),   a = u (1 - u),   b = v (1 - v)
 *
 * so that the surface takes on each side the point and the derivative of the loft that has them.
 * At a corner the weights are 0/0. What they weigh is not: h(t) divides by t (1 - t) but for the
 * corners' values, which are the same in both lofts, so that
 *
 *     B - A = a U + b V + a b E
 *     Brown = (A + B) / 2 + (a^2 - b^2) / (a^2 + b^2) / 2 (a U + b V + a b E)
 *
 * with U and V from what the sides' and the cross tangents differ by in the corners, zero where
 * the one side's tangent is the other's cross tangent, and E from the differences of the twists.
 * That leaves a b (a^2 - b^2) / (a^2 + b^2), the textbook's function whose mixed derivatives in the
 * origin depend on the order; no digit is lost next to a corner.
 *
 * In a corner the first derivatives are those of the sides; they are the limit from everywhere
 * where U = V = 0. The second derivatives' limit depends on the direction: duu and dvv are those
 * of the sides, which is the limit along them, and duv is the mean of the two sides' limits.
 *
 * REFERENCES
 *
 *     [1] Watanabe M., Furukawa M., Kakazu Y., on shape parameters of Brown surfaces, Japan Society
 *         for Precision Engineering (in Japanese), about 1990.
 *     [2] Kochanek D., Bartels R., Interpolating splines with local tension, continuity, and bias
 *         control, SIGGRAPH 1984, 33-41.
 *     [3] Chiyokura H., Kimura F., Design of solids with free-form surfaces, SIGGRAPH 1983,
 *         289-298.
 */
#ifndef BROWN_H
#define BROWN_H

#include "nagata3.h"

#if defined __cplusplus && __cplusplus >= 201103L /* as nagata3.h does */
inline namespace N3I_PICK(brown_double, brown_float) {
#elif defined __cplusplus
namespace N3I_PICK(brown_double, brown_float) {}
using namespace N3I_PICK(brown_double, brown_float);
namespace N3I_PICK(brown_double, brown_float) {
#endif

/* ---- The square ---- */

/* A vector that varies along a side: h(t) + (t (1 - t))^2 r(t), h and r cubic Bezier curves. Every
   polynomial of degree 7 is of this form; a cubic has r = 0. */
typedef struct brown_field { n3_edge h, r; } brown_field;

/* Sides and cross tangents in the order of the drawing. Sides that meet must share the corner. */
typedef struct brown_square { n3_edge side[4]; brown_field across[4]; } brown_square;

/* Point at u, v in [0, 1]: (1). On a side it is n3_edge_point of that side, bit for bit. Within
   2 eps of the largest coordinate and cross tangent, also 1e-12 from a corner. Costs as much as
   seven n3_patch_point. */
NAGATA3_API n3_vec brown_point(const brown_square *s, n3_real u, n3_real v);

/* Point, first and second derivatives; what they are in a corner stands above. Within 4 and 25 eps
   of the largest coordinate and cross tangent, also 1e-12 from a corner, where U = V = 0: tangents
   that differ by their rounding count as equal. Where they differ by more, second derivatives grow
   as 1/distance to the corner, and their error with them. Costs as much as a n3_patch_make. */
NAGATA3_API n3_jet brown_jet(const brown_square *s, n3_real u, n3_real v);

/* Unit normal, along du x dv. Where that vanishes, the limit on the way to the middle, as far as
   second derivatives tell it; failing that the normal 2^-17 (float: 2^-8) of the way on; then zero.
   Costs as much as the jet. */
NAGATA3_API n3_vec brown_normal(const brown_square *s, n3_real u, n3_real v);

/* ---- The lattice ---- */

/* The parameters of shape of a lattice curve at one of its points; all zero: Catmull and Rom's
   tangents. The first four are those of Kochanek and Bartels [2], and what [1] adds to them:

       tension        1: no tangents; 0; below: longer ones
       bias           towards the chord before (1) or after (-1)
       continuity     -1: each side goes by its own chord; 1: by the other's
       t_continuity   -1: long before and none after the curve; 1: the reverse

   The first two keep the surface smooth across the curve. rise is [1]'s fifth: the tangents come
   from the difference of the two chords beyond, each side's own. It is used where it is not zero,
   and wants to be so on the whole curve, the other four being zero there. */
typedef struct brown_shape { n3_real tension, bias, continuity, t_continuity, rise; } brown_shape;

/* Curves CU_j run along u, CV_i along v, through the points of a lattice, borrowed: nothing is
   copied. Between two points of a curve its parameters vary linearly. A curve's own tangents are
   made by the parameters of the curves that it crosses, in the same way as the cross tangents; so
   the square's tangents agree in the corners. */
typedef struct brown_lattice {
    int columns, rows;          /* points along u and along v, 2 or more of each */
    const n3_vec *point;        /* [rows][columns] */
    const brown_shape *u_shape; /* [rows][columns] of the curves CU_j in each point; NULL: zero */
    const brown_shape *v_shape; /* [rows][columns] of the curves CV_i in each point; NULL: zero */
    const n3_edge *u_curve;     /* [rows][columns - 1] the parts of CU_j; NULL: made here */
    const n3_edge *v_curve;     /* [columns][rows - 1] the parts of CV_i; NULL: made here */
} brown_lattice;

typedef enum brown_status {
    BROWN_OK,
    BROWN_NULL_POINTER, /* there are no points */
    BROWN_BAD_COUNT,    /* fewer than two points in a direction, or more than int can count */
    BROWN_BAD_POINT,    /* item: a point that is not finite */
    BROWN_BAD_SHAPE,    /* item: a point with a parameter that is not finite */
    BROWN_BAD_RISE      /* item: a point whose curve has rise, but not everywhere, or with other
                           parameters, or with fewer than two curves beside it */
} brown_status;

/* In words, never NULL. */
NAGATA3_API const char *brown_status_text(brown_status status);

/* BROWN_OK, or what is wrong; item, which may be NULL, is left alone or says where. */
NAGATA3_API brown_status brown_lattice_check(const brown_lattice *l, int *item);

/* The part of the curve CU_j between its points i and i + 1 (along_v: of CV_j), by (6)-(9). */
NAGATA3_API n3_edge brown_lattice_curve(const brown_lattice *l, int along_v, int j, int i);

/* The square between the columns i and i + 1 and the rows j and j + 1 of a lattice that has been
   checked: (2)-(9). At the lattice's ends, which have one chord only, it stands for both. Costs as
   much as three n3_patch_make. */
NAGATA3_API brown_square brown_lattice_square(const brown_lattice *l, int i, int j);

/* ---- The quad ---- */

/* Ours, after [3]: the square over the quad of four vertices, x00, x10, x11, x01, its sides edges
   of nagata3.h. Along each side the tangent planes follow from this side and the normals at its
   ends alone: two quads that share them have the same planes all along, and no normal jumps.
   The planes are spanned by the side's derivative D(t) and by S(t), a quadratic from n0 x t0 to
   n1 x t1, the normals times the side's unit tangents; in the middle it has their mean length and
   is square to the side and to n0 + n1. The cross tangents are
   l(t) D(t) + m(t) S(t) with quadratics l and m, such that at the ends they are the tangents of the
   sides that meet there, and in the middle that of the edge, by the same rule, which joins the
   middles of opposite sides.
   The rule is one of nagata3.h. N3_RULE_ARC wants normals that look outwards; N3_RULE_FIT is the
   same here. Costs as much as five n3_patch_make. */
NAGATA3_API brown_square brown_quad_make(const n3_vertex corner[4], const n3_options *o);

/* The same from edges that are there already, which run round the quad: from 0 to 1 and so on.
   mid: a normal to want in the middle of each in place of n0 + n1, of any length; zero, or mid
   NULL: none. A zero normal at a corner is replaced by that at the other end of each edge; where
   both are, the cross tangents are linear. */
NAGATA3_API brown_square brown_quad_from_edges(const n3_vertex corner[4], const n3_edge edge[4],
                                               const n3_vec mid[4], const n3_options *o);

/* A normal to want in the middle of the edge a, b of the quads a b c[0] c[1] and b a d[0] d[1], not
   of unit length: n3_edge_mid_normal of both pairs of opposite points. With it the surface is of
   fourth order in position, and third in normals, on smooth surfaces. */
NAGATA3_API n3_vec brown_mid_normal(n3_vertex a, n3_vertex b, const n3_vertex c[2],
                                    const n3_vertex d[2]);

/* The square over a quad of a mesh: over its triangles f and f + 1, which have the corners 0 1 2
   and 0 2 3 of it, between the edges of its net. half: of each triangle 2 q or 2 q + 1, as it is
   the first or the second of the quad q; negative: it is a triangle. By N3_RULE_FIT the normals in the
   middle of the sides are fitted over what meets there, brown_mid_normal, where two faces do that
   agree on the normals at the ends; a triangle counts as a quad with its third corner twice.
   The topology and the net are the mesh's; the triangles have an edge on every side. */
NAGATA3_API brown_square brown_mesh_square(const n3_mesh *m, const n3_topology *t,
                                           const n3_vec *net, const int *half, int f,
                                           const n3_options *o);

/* ---- Definitions: the square ---- */

/* Hermite's cubics [h(t)], for the value at 0 and at 1 and the derivative at 0 and at 1, and their
   first and second derivatives. */
NAGATA3_API void browni_hermite(n3_real t, n3_real h[3][4])
{
    n3_real s = 1 - t;
    h[0][0] = s * s * (1 + 2 * t);
    h[0][1] = t * t * (1 + 2 * s);
    h[0][2] = s * s * t;
    h[0][3] = -t * t * s;
    h[1][1] = 6 * t * s;
    h[1][0] = -h[1][1];
    h[1][2] = s * (s - 2 * t);
    h[1][3] = t * (t - 2 * s);
    h[2][1] = 6 * (s - t);
    h[2][0] = -h[2][1];
    h[2][2] = 2 * t - 4 * s;
    h[2][3] = 4 * t - 2 * s;
}

NAGATA3_API n3_vec browni_sum(const n3_real w[4], n3_vec a, n3_vec b, n3_vec c, n3_vec d)
{
    return n3_add(n3_add(n3_mul(w[0], a), n3_mul(w[1], b)),
                  n3_add(n3_mul(w[2], c), n3_mul(w[3], d)));
}

/* f x with the derivatives f, f1, f2 of f and those of x. */
NAGATA3_API n3_curve_jet browni_product(n3_real f, n3_real f1, n3_real f2, n3_curve_jet x)
{
    n3_curve_jet r;
    r.x = n3_mul(f, x.x);
    r.dt = n3_add(n3_mul(f1, x.x), n3_mul(f, x.dt));
    r.dtt = n3i_mix(f2, x.x, 2 * f1, x.dt, f, x.dtt);
    return r;
}

NAGATA3_API n3_curve_jet browni_field_jet(const brown_field *f, n3_real t)
{
    n3_curve_jet h = n3_edge_jet(&f->h, t), r = n3_edge_jet(&f->r, t);
    n3_real a = t * (1 - t), a1 = 1 - 2 * t;
    r = browni_product(a * a, 2 * a * a1, 2 * a1 * a1 - 4 * a, r);
    h.x = n3_add(h.x, r.x);
    h.dt = n3_add(h.dt, r.dt);
    h.dtt = n3_add(h.dtt, r.dtt);
    return h;
}

/* The square's two families of curves: 0 runs along u, its loft is B; 1 runs along v, A. In what
   follows a family is seen from itself, u along its curves and v across them; for family 1 the
   result is turned round. */
NAGATA3_API n3_jet browni_turned(n3_jet j, int family)
{
    n3_jet r = j;
    if (!family) return j;
    r.du = j.dv;
    r.dv = j.du;
    r.duu = j.dvv;
    r.dvv = j.duu;
    return r;
}

/* The loft B of family 0, A of family 1. */
NAGATA3_API n3_jet browni_loft(const brown_square *s, int family, n3_real u, n3_real v)
{
    n3_curve_jet c[4];
    n3_real h[3][4];
    n3_vec d;
    n3_jet r;
    int k;
    for (k = 0; k < 2; k++) {
        c[k] = n3_edge_jet(&s->side[2 * family + k], u);
        c[2 + k] = browni_field_jet(&s->across[2 * family + k], u);
    }
    browni_hermite(v, h);
    d = n3_sub(c[1].x, c[0].x);
    r.x = browni_sum(h[0], c[0].x, c[1].x, c[2].x, c[3].x);
    r.du = browni_sum(h[0], c[0].dt, c[1].dt, c[2].dt, c[3].dt);
    r.duu = browni_sum(h[0], c[0].dtt, c[1].dtt, c[2].dtt, c[3].dtt);
    r.duv = browni_sum(h[1], c[0].dt, c[1].dt, c[2].dt, c[3].dt);
    r.dv = n3i_mix(h[1][1], d, h[1][2], c[2].x, h[1][3], c[3].x);
    r.dvv = n3i_mix(h[2][1], d, h[2][2], c[2].x, h[2][3], c[3].x);
    return browni_turned(r, family);
}

/* Its point alone. */
NAGATA3_API n3_vec browni_loft_point(const brown_square *s, int family, n3_real u, n3_real v)
{
    n3_real h[3][4], aa = u * (1 - u) * (u * (1 - u));
    n3_vec x[4];
    int k;
    for (k = 0; k < 2; k++) {
        const brown_field *f = &s->across[2 * family + k];
        x[k] = n3_edge_point(&s->side[2 * family + k], u);
        x[2 + k] = n3_add(n3_edge_point(&f->h, u), n3_mul(aa, n3_edge_point(&f->r, u)));
    }
    browni_hermite(v, h);
    return browni_sum(h[0], x[0], x[1], x[2], x[3]);
}

/* Where a place lies: a and b over s, the larger of them, and their derivatives. */
typedef struct browni_place { n3_real u, v, s, a, b, a1, b1; } browni_place;

NAGATA3_API browni_place browni_place_of(n3_real u, n3_real v)
{
    browni_place p;
    n3_real a = u * (1 - u), b = v * (1 - v);
    p.u = u;
    p.v = v;
    p.s = n3i_larger(n3i_abs(a), n3i_abs(b));
    p.a = p.s > 0 ? a / p.s : 1; /* in a corner both lofts are the corner */
    p.b = p.s > 0 ? b / p.s : 1;
    p.a1 = 1 - 2 * u;
    p.b1 = 1 - 2 * v;
    return p;
}

NAGATA3_API n3_vec brown_point(const brown_square *s, n3_real u, n3_real v)
{
    browni_place p = browni_place_of(u, v);
    n3_real q = p.a * p.a + p.b * p.b;
    n3_vec A = browni_loft_point(s, 1, v, u), B = browni_loft_point(s, 0, u, v);
    return n3_add(n3_mul(p.b * p.b / q, A), n3_mul(p.a * p.a / q, B));                  /* (1) */
}

/* Below, a jet with the scale s holds x / s^2, du / s, dv / s, and the second derivatives as they
   are: what is of second order next to a corner then has no powers of s in it. */
typedef struct browni_jet { n3_real x, du, dv, duu, duv, dvv; } browni_jet;

/* r += f g: f has the scale s, g has none, and the result has that of f. */
NAGATA3_API void browni_add_product(n3_jet *r, browni_jet f, n3_jet g, n3_real s)
{
    n3_real x = s * f.x, du = s * f.du, dv = s * f.dv;
    r->x = n3_add(r->x, n3_mul(f.x, g.x));
    r->du = n3_add(r->du, n3_add(n3_mul(f.du, g.x), n3_mul(x, g.du)));
    r->dv = n3_add(r->dv, n3_add(n3_mul(f.dv, g.x), n3_mul(x, g.dv)));
    r->duu = n3_add(r->duu, n3i_mix(f.duu, g.x, 2 * du, g.du, s * x, g.duu));
    r->dvv = n3_add(r->dvv, n3i_mix(f.dvv, g.x, 2 * dv, g.dv, s * x, g.dvv));
    r->duv = n3_add(r->duv, n3i_mix(f.duv, g.x, du, g.dv, dv, g.du));
    r->duv = n3_add(r->duv, n3_mul(s * x, g.duv));
}

/* A family's part of E: along either curve the field's values at its ends are taken off and a is
   divided out,

       f(u) = h0(u) f(0) + h1(u) f(1) + a q(u),   q = (1 - u) f'(0) - u f'(1) + a r(u)

   and the loft of a q over the two curves is a b ((1 - v) q_0 - v q_1). */
NAGATA3_API n3_jet browni_twist(const brown_square *s, int family, n3_real u, n3_real v)
{
    n3_curve_jet q[2];
    n3_jet e;
    int k;
    for (k = 0; k < 2; k++) {
        const brown_field *f = &s->across[2 * family + k];
        n3_vec f0 = n3_mul(3, n3_sub(f->h.p[1], f->h.p[0]));
        n3_vec f1 = n3_mul(3, n3_sub(f->h.p[3], f->h.p[2]));
        q[k] = browni_product(u * (1 - u), 1 - 2 * u, -2, n3_edge_jet(&f->r, u));
        q[k].x = n3_add(q[k].x, n3_sub(n3_mul(1 - u, f0), n3_mul(u, f1)));
        q[k].dt = n3_sub(q[k].dt, n3_add(f0, f1));
    }
    e.x = n3_sub(n3_mul(1 - v, q[0].x), n3_mul(v, q[1].x));
    e.du = n3_sub(n3_mul(1 - v, q[0].dt), n3_mul(v, q[1].dt));
    e.duu = n3_sub(n3_mul(1 - v, q[0].dtt), n3_mul(v, q[1].dtt));
    e.dv = n3i_neg(n3_add(q[0].x, q[1].x));
    e.duv = n3i_neg(n3_add(q[0].dt, q[1].dt));
    e.dvv = n3_v(0, 0, 0);
    return e;
}

/* By how much the derivative of the family's side k at its end differs from the cross tangent that
   the other family has in this corner; zero if by rounding: a side's control point has that of the
   coordinates, and the derivative is 3 times its distance from the corner. */
NAGATA3_API n3_vec browni_mismatch(const brown_square *s, int family, int k, int end)
{
    const n3_vec *p = s->side[2 * family + k].p;
    n3_vec T = s->across[2 * (1 - family) + end].h.p[3 * k];
    n3_vec d = n3_sub(n3_mul(3, n3_sub(p[2 * end + 1], p[2 * end])), T);
    n3_real size = n3i_larger(n3i_largest(p[2 * end]), n3i_largest(p[2 * end + 1]));
    size = n3i_larger(size, n3i_largest(T));
    return n3i_largest(d) <= 8 * N3_EPS * size ? n3_v(0, 0, 0) : d;
}

/* A family's part of U and V: the loft of a ((1 - u) d_0 - u d_1), d the mismatch at the ends, over
   the two curves, without a. False if it vanishes. */
NAGATA3_API int browni_tangents_differ(const brown_square *s, int family, n3_real u, n3_real v,
                                       n3_jet *j)
{
    n3_vec x[2], d[2];
    n3_real h[3][4], size = 0;
    int k;
    browni_hermite(v, h);
    for (k = 0; k < 2; k++) {
        n3_vec d0 = browni_mismatch(s, family, k, 0), d1 = browni_mismatch(s, family, k, 1);
        x[k] = n3_sub(n3_mul(1 - u, d0), n3_mul(u, d1));
        d[k] = n3i_neg(n3_add(d0, d1));
        size = n3i_larger(size, n3i_larger(n3i_largest(d0), n3i_largest(d1)));
    }
    j->x = n3_add(n3_mul(h[0][0], x[0]), n3_mul(h[0][1], x[1]));
    j->du = n3_add(n3_mul(h[0][0], d[0]), n3_mul(h[0][1], d[1]));
    j->dv = n3_mul(h[1][1], n3_sub(x[1], x[0]));
    j->duv = n3_mul(h[1][1], n3_sub(d[1], d[0]));
    j->dvv = n3_mul(h[2][1], n3_sub(x[1], x[0]));
    j->duu = n3_v(0, 0, 0);
    return size > 0;
}

/* The scale up to which a place counts as the corner. */
#define BROWNI_CORNER (N3_EPS * N3_EPS * N3_EPS * N3_EPS)

/* a U + a b E of family 0, or the same of family 1, with its scale; E and U here are the family's
   parts. */
NAGATA3_API n3_jet browni_part(const brown_square *s, int family, browni_place p)
{
    browni_jet f = {0, 0, 0, 0, 0, 0};
    n3_real u = family ? p.v : p.u, v = family ? p.u : p.v, a1 = 1 - 2 * u, b1 = 1 - 2 * v;
    n3_real a = family ? p.b : p.a, b = family ? p.a : p.b;
    n3_jet D, g;
    memset(&D, 0, sizeof D);
    if (browni_tangents_differ(s, family, u, v, &g)) {
        f.x = a / p.s;
        f.du = a1 / p.s;
        f.duu = -2;
        browni_add_product(&D, f, g, p.s);
    }
    f.x = a * b;
    f.du = a1 * b;
    f.dv = a * b1;
    f.duu = -2 * p.s * b;
    f.duv = a1 * b1;
    f.dvv = -2 * p.s * a;
    browni_add_product(&D, f, browni_twist(s, family, u, v), p.s);
    return browni_turned(D, family);
}

/* (a^2 - b^2) / (a^2 + b^2) / 2 and its derivatives, each as often multiplied by s. */
NAGATA3_API browni_jet browni_weight(browni_place p)
{
    n3_real a = p.a, b = p.b, aa = a * a, bb = b * b, q = aa + bb, ab = a * b / (q * q);
    n3_real ka = 2 * ab * b, kb = -2 * ab * a;
    n3_real kaa = 2 * bb * (bb - 3 * aa) / (q * q * q), kbb = 2 * aa * (3 * bb - aa) / (q * q * q);
    browni_jet k;
    k.x = (aa - bb) / (2 * q);
    k.du = p.a1 * ka;
    k.dv = p.b1 * kb;
    k.duu = p.a1 * p.a1 * kaa - 2 * p.s * ka;
    k.duv = p.a1 * p.b1 * (4 * ab * (aa - bb) / q);
    k.dvv = p.b1 * p.b1 * kbb - 2 * p.s * kb;
    return k;
}

NAGATA3_API n3_jet browni_jet_mix(n3_real r, n3_jet a, n3_real s, n3_jet b)
{
    a.x = n3_add(n3_mul(r, a.x), n3_mul(s, b.x));
    a.du = n3_add(n3_mul(r, a.du), n3_mul(s, b.du));
    a.dv = n3_add(n3_mul(r, a.dv), n3_mul(s, b.dv));
    a.duu = n3_add(n3_mul(r, a.duu), n3_mul(s, b.duu));
    a.duv = n3_add(n3_mul(r, a.duv), n3_mul(s, b.duv));
    a.dvv = n3_add(n3_mul(r, a.dvv), n3_mul(s, b.dvv));
    return a;
}

NAGATA3_API n3_jet browni_jet_at(const brown_square *s, browni_place p)
{
    n3_jet A = browni_loft(s, 1, p.v, p.u), B = browni_loft(s, 0, p.u, p.v), D, K, j;
    n3_real half = (n3_real)1 / 2;
    memset(&K, 0, sizeof K);
    D = browni_jet_mix(1, browni_part(s, 0, p), -1, browni_part(s, 1, p));
    browni_add_product(&K, browni_weight(p), D, 1);
    K.du = n3_mul(p.s, K.du);
    K.dv = n3_mul(p.s, K.dv);
    j = browni_jet_mix(1, browni_jet_mix(half, A, half, B), 1, K);
    j.x = brown_point(s, p.u, p.v);
    return j;
}

/* What the two sides say that meet in the corner. */
NAGATA3_API n3_jet browni_corner_jet(const brown_square *s, n3_real u, n3_real v)
{
    int at_u = u > (n3_real)1 / 2, at_v = v > (n3_real)1 / 2;
    n3_curve_jet along_u = n3_edge_jet(&s->side[at_v], u);
    n3_curve_jet along_v = n3_edge_jet(&s->side[2 + at_u], v);
    n3_vec twist_u = browni_field_jet(&s->across[at_v], u).dt;
    n3_vec twist_v = browni_field_jet(&s->across[2 + at_u], v).dt;
    n3_jet j;
    j.x = brown_point(s, u, v);
    j.du = along_u.dt;
    j.dv = along_v.dt;
    j.duu = along_u.dtt;
    j.dvv = along_v.dtt;
    j.duv = n3_mul((n3_real)1 / 2, n3_add(twist_u, twist_v));
    return j;
}

NAGATA3_API n3_jet brown_jet(const brown_square *s, n3_real u, n3_real v)
{
    browni_place p = browni_place_of(u, v);
    return p.s <= BROWNI_CORNER ? browni_corner_jet(s, u, v) : browni_jet_at(s, p);
}

/* The largest of what the square is made of, seen from x00. */
NAGATA3_API n3_real browni_size(const brown_square *s)
{
    n3_real size = 0;
    int i, k;
    for (i = 0; i < 4; i++)
        for (k = 0; k < 4; k++) {
            n3_vec x = n3_sub(s->side[i].p[k], s->side[0].p[0]);
            size = n3i_larger(size, n3i_largest(x));
            size = n3i_larger(size, n3i_largest(s->across[i].h.p[k]));
            size = n3i_larger(size, n3i_largest(s->across[i].r.p[k]));
        }
    return size;
}

/* du x dv of the square made of size 1, so that products neither overflow nor underflow. Where it
   vanishes, the coefficients of the powers of the way to the middle, as far as second derivatives
   have them. */
NAGATA3_API n3_vec browni_normal_at(n3_jet j, n3_real unit, n3_real to_u, n3_real to_v)
{
    n3_vec u = n3i_over(j.du, unit), v = n3i_over(j.dv, unit), uv = n3i_over(j.duv, unit);
    n3_vec du = n3_add(n3_mul(to_u, n3i_over(j.duu, unit)), n3_mul(to_v, uv));
    n3_vec dv = n3_add(n3_mul(to_u, uv), n3_mul(to_v, n3i_over(j.dvv, unit)));
    n3_real size = n3_len(u) + n3_len(v);
    n3_vec n = n3i_clear(n3_cross(u, v), size);
    if (!n3i_is_zero(n)) return n;
    size += n3_len(du) + n3_len(dv);
    n = n3i_clear(n3_add(n3_cross(du, v), n3_cross(u, dv)), size);
    return n3i_is_zero(n) ? n3i_clear(n3_cross(du, dv), size) : n;
}

/* A little way to the middle: what is third order there has lost a third of its digits to rounding,
   and is off by as much. */
#define BROWNI_WAY N3I_PICK((n3_real)1 / 131072, (n3_real)1 / 256)

/* Here; then beside here, where also in a corner second derivatives are those on the way to the
   middle; then farther on. */
NAGATA3_API n3_vec brown_normal(const brown_square *s, n3_real u, n3_real v)
{
    n3_real to_u = (n3_real)1 / 2 - u, to_v = (n3_real)1 / 2 - v;
    n3_real size = browni_size(s), step[2];
    int k;
    n3_vec n = n3_sub(s->side[1].p[3], s->side[0].p[0]);
    if (!(size > 0)) return n; /* zero, or NaN */
    n = browni_normal_at(brown_jet(s, u, v), size, 0, 0);
    step[0] = N3_EPS;
    step[1] = BROWNI_WAY;
    for (k = 0; k < 2 && n3i_is_zero(n); k++) {
        n3_jet moved = brown_jet(s, u + step[k] * to_u, v + step[k] * to_v);
        n = browni_normal_at(moved, size, to_u, to_v);
    }
    return n;
}

/* ---- Definitions: the lattice ---- */

NAGATA3_API const char *brown_status_text(brown_status status)
{
    switch (status) {
    case BROWN_OK: return "all is well";
    case BROWN_NULL_POINTER: return "there are no points";
    case BROWN_BAD_COUNT: return "a lattice has from 2 by 2 points to what int can count";
    case BROWN_BAD_POINT: return "a point is not finite";
    case BROWN_BAD_SHAPE: return "a parameter is not finite";
    case BROWN_BAD_RISE:
        return "rise wants to be on the whole curve, without other parameters and with two curves "
               "beside it";
    }
    return "unknown status";
}

/* A family of lattice curves is seen along its curves: CU_j for family 0, CV_j for family 1. */
NAGATA3_API int browni_length(const brown_lattice *l, int family)
{
    return family ? l->rows : l->columns;
}

/* Where the i-th point of the family's j-th curve lies in the arrays. */
NAGATA3_API size_t browni_index(const brown_lattice *l, int family, int j, int i)
{
    return (size_t)(family ? i : j) * (size_t)l->columns + (size_t)(family ? j : i);
}

NAGATA3_API brown_shape browni_shape(const brown_lattice *l, int family, int j, int i)
{
    const brown_shape *given = family ? l->v_shape : l->u_shape;
    brown_shape none = {0, 0, 0, 0, 0};
    return given ? given[browni_index(l, family, j, i)] : none;
}

NAGATA3_API int browni_is_plain(brown_shape p)
{
    return n3i_abs(p.tension) + n3i_abs(p.bias) + n3i_abs(p.continuity) + n3i_abs(p.t_continuity) <=
           0;
}

NAGATA3_API int browni_rises(brown_shape p) { return p.rise < 0 || p.rise > 0; }

NAGATA3_API brown_status browni_check_shapes(const brown_lattice *l, int family, int *item)
{
    int i, j, curves = browni_length(l, !family);
    for (j = 0; j < curves; j++)
        for (i = 0; i < browni_length(l, family); i++) {
            brown_shape p = browni_shape(l, family, j, i), first = browni_shape(l, family, j, 0);
            n3_real sum = p.tension + p.bias + p.continuity + p.t_continuity + p.rise;
            int bad = !n3i_is_finite(n3_v(sum, 0, 0));
            int rises = browni_rises(p) || browni_rises(first);
            int misused = rises && (!browni_rises(p) || !browni_rises(first) ||
                                    !browni_is_plain(p) || curves < 3);
            if (item && (bad || misused)) *item = (int)browni_index(l, family, j, i);
            if (bad) return BROWN_BAD_SHAPE;
            if (misused) return BROWN_BAD_RISE;
        }
    return BROWN_OK;
}

NAGATA3_API brown_status brown_lattice_check(const brown_lattice *l, int *item)
{
    brown_status status;
    int i;
    if (!l || !l->point) return BROWN_NULL_POINTER;
    if (l->columns < 2 || l->rows < 2 || n3i_count_mul(l->columns, l->rows) < 0)
        return BROWN_BAD_COUNT;
    i = n3i_not_finite(&l->point[0].x, 0, l->columns * l->rows);
    if (item && i >= 0) *item = i;
    if (i >= 0) return BROWN_BAD_POINT;
    status = browni_check_shapes(l, 0, item);
    return status == BROWN_OK ? browni_check_shapes(l, 1, item) : status;
}

/* The Bezier curve c of the degree n times the linear function that is a at 0 and b at 1. */
NAGATA3_API void browni_raise(n3_vec *c, int n, n3_real a, n3_real b)
{
    int k;
    c[n + 1] = n3_mul(b, c[n]);
    for (k = n; k > 0; k--) {
        n3_real part = (n3_real)k / (n3_real)(n + 1);
        c[k] = n3_add(n3_mul((1 - part) * a, c[k]), n3_mul(part * b, c[k - 1]));
    }
    c[0] = n3_mul(a, c[0]);
}

/* The same; the degree stays where the function is constant. Returns the degree. */
NAGATA3_API int browni_times(n3_vec *c, int n, n3_real a, n3_real b)
{
    int k, constant = a >= b && a <= b;
    if (!constant) browni_raise(c, n, a, b);
    for (k = 0; k <= n && constant; k++) c[k] = n3_mul(a, c[k]);
    return constant ? n : n + 1;
}

/* A Bezier curve of the degree 3 to 7 as a field. Less the cubic h of the same values and
   derivatives at the ends it is (t (1 - t))^2 r. */
NAGATA3_API brown_field browni_field_of(n3_vec *c, int degree)
{
    static const n3_real times[4] = {21, (n3_real)35 / 3, (n3_real)35 / 3, 21};
    n3_real third = (n3_real)degree / 3;
    n3_vec e[8];
    brown_field f;
    int k, n;
    memset(&f, 0, sizeof f);
    for (k = 0; k < 4; k++) f.h.p[k] = c[k];
    if (degree == 3) return f;
    f.h.p[1] = n3_add(c[0], n3_mul(third, n3_sub(c[1], c[0])));
    f.h.p[2] = n3_sub(c[degree], n3_mul(third, n3_sub(c[degree], c[degree - 1])));
    f.h.p[3] = c[degree];
    for (k = 0; k < 4; k++) e[k] = f.h.p[k];
    for (n = degree; n < 7; n++) browni_raise(c, n, 1, 1);
    for (n = 3; n < 7; n++) browni_raise(e, n, 1, 1);
    for (k = 0; k < 4; k++) f.r.p[k] = n3_mul(times[k], n3_sub(c[k + 2], e[k + 2]));
    return f;
}

/* The chord vector from the family's curve j to the next, of the degree 0 at the curve's point i,
   of the degree 3 over its part from there on: (2)-(5). The first and the last serve beyond. */
NAGATA3_API void browni_chord(const brown_lattice *l, int family, int j, int i, int degree,
                              n3_vec *c)
{
    int k, last = browni_length(l, !family) - 2;
    j = j < 0 ? 0 : j > last ? last : j;
    if (degree == 0) {
        c[0] = n3_sub(l->point[browni_index(l, family, j + 1, i)],
                      l->point[browni_index(l, family, j, i)]);
    } else {
        n3_edge from = brown_lattice_curve(l, family, j, i);
        n3_edge to = brown_lattice_curve(l, family, j + 1, i);
        for (k = 0; k < 4; k++) c[k] = n3_sub(to.p[k], from.p[k]);                /* (2)-(5) */
    }
}

/* The Greek letters of (6)-(9), alpha to delta, are products of 1 + sign * parameter and 1/2. */
NAGATA3_API int browni_times_letter(brown_shape from, brown_shape to, int letter, n3_vec *c, int n)
{
    static const n3_real sign[4][4] = {
        {-1, 1, -1, -1}, {-1, -1, 1, -1}, {-1, 1, 1, 1}, {-1, -1, -1, 1}};
    const n3_real *s = sign[letter], half = (n3_real)1 / 2;
    n = browni_times(c, n, 1 + s[0] * from.tension, 1 + s[0] * to.tension);
    n = browni_times(c, n, 1 + s[1] * from.bias, 1 + s[1] * to.bias);
    n = browni_times(c, n, 1 + s[2] * from.continuity, 1 + s[2] * to.continuity);
    n = browni_times(c, n, 1 + s[3] * from.t_continuity, 1 + s[3] * to.t_continuity);
    return browni_times(c, n, half, half);
}

/* The tangent across the family's curve j, at its point i (degree 0) or over its part from there on
   (degree 3), as it comes in, DS, or goes out, DD. Returns the degree of c. */
NAGATA3_API int browni_across(const brown_lattice *l, int family, int j, int i, int out, int degree,
                              n3_vec *c)
{
    brown_shape from = browni_shape(l, family, j, i), to = from;
    n3_vec b[8];
    int k, n, last = browni_length(l, !family) - 2, second = out ? j + 1 : j - 1;
    if (degree) to = browni_shape(l, family, j, i + 1);
    if (browni_rises(from)) {
        n3_real sign = out ? -1 : 1;
        second = second < 1 ? 1 : second > last ? last : second;
        browni_chord(l, family, second, i, degree, c);
        browni_chord(l, family, second - 1, i, degree, b);
        for (k = 0; k <= degree; k++) c[k] = n3_sub(c[k], b[k]);
        return browni_times(c, degree, sign * from.rise, sign * to.rise);
    }
    browni_chord(l, family, j - 1, i, degree, c);
    browni_chord(l, family, j, i, degree, b);
    n = browni_times_letter(from, to, out ? 2 : 0, c, degree);
    browni_times_letter(from, to, out ? 3 : 1, b, degree);
    for (k = 0; k <= n; k++) c[k] = n3_add(c[k], b[k]);                           /* (6)-(9) */
    return n;
}

NAGATA3_API n3_edge brown_lattice_curve(const brown_lattice *l, int along_v, int j, int i)
{
    const n3_edge *given = along_v ? l->v_curve : l->u_curve;
    size_t part = (size_t)j * (size_t)(browni_length(l, along_v) - 1) + (size_t)i;
    n3_vec x0 = l->point[browni_index(l, along_v, j, i)];
    n3_vec x1 = l->point[browni_index(l, along_v, j, i + 1)], out[8], in[8];
    if (given) return given[part];
    browni_across(l, !along_v, i, j, 1, 0, out);
    browni_across(l, !along_v, i + 1, j, 0, 0, in);
    return n3i_edge_of(x0, n3_add(x0, n3i_over(out[0], 3)), n3_sub(x1, n3i_over(in[0], 3)), x1);
}

NAGATA3_API brown_square brown_lattice_square(const brown_lattice *l, int i, int j)
{
    brown_square s;
    n3_vec c[8];
    int k, degree;
    memset(&s, 0, sizeof s);
    for (k = 0; k < 4; k++) {
        int family = k > 1, out = k % 2 == 0;
        int curve = (family ? i : j) + !out, part = family ? j : i;
        s.side[k] = brown_lattice_curve(l, family, curve, part);
        degree = browni_across(l, family, curve, part, out, 3, c);
        s.across[k] = browni_field_of(c, degree);
    }
    return s;
}

/* ---- Definitions: the quad ---- */

/* A side of a quad: its derivative D(t) and what else spans its tangent planes, S(t), as quadratic
   Bezier curves, and the normal in its middle. */
typedef struct browni_frame { n3_vec D[3], S[3], n; } browni_frame;

NAGATA3_API n3_vec browni_middle(const n3_vec q[3])
{
    return n3i_mix((n3_real)1 / 4, q[0], (n3_real)1 / 2, q[1], (n3_real)1 / 4, q[2]);
}

/* S(t) runs from n0 x t0 to n1 x t1; in the middle it has the mean length and stands across the
   side and the normal that is wanted there. S is zero where there is none at an end. The paper's
   rule takes normals that look to either side: n1 is turned as its plane Pi turns it. */
NAGATA3_API browni_frame browni_frame_of(const n3_edge *e, n3_vec n0, n3_vec n1, n3_vec mid,
                                         const n3_options *o)
{
    browni_frame f;
    n3_vec t0, t1, t, chord = n3_unit(n3_sub(e->p[3], e->p[0]));
    int k, turned = n3_dot(n3_cross(chord, n0), n3_cross(chord, n1)) < 0 && !n3i_is_arc(o);
    for (k = 0; k < 3; k++) f.D[k] = n3_mul(3, n3_sub(e->p[k + 1], e->p[k]));
    t0 = n3_unit(f.D[0]);
    t1 = n3_unit(f.D[2]);
    if (n3i_is_zero(n0)) n0 = n3i_across(n1, t0);
    if (n3i_is_zero(n1)) n1 = n3i_across(n0, t1);
    if (turned) n1 = n3i_neg(n1);
    if (n3i_is_zero(mid)) mid = n3_add(n0, n1);
    f.S[0] = n3_cross(n0, t0);
    f.S[2] = n3_cross(n1, t1);
    f.S[1] = n3_mul((n3_real)1 / 2, n3_add(f.S[0], f.S[2]));
    t = n3_unit(browni_middle(f.D));
    mid = n3i_across(n3_unit(mid), t);
    if (!n3i_is_zero(mid))
        f.S[1] = n3_sub(n3_mul(2 * n3_len(f.S[1]), n3_cross(mid, t)), f.S[1]);
    f.n = n3_unit(n3_cross(t, browni_middle(f.S)));
    return f;
}

/* W, which lies in the plane of D and S, as l D + m S; false where they hardly span one. */
NAGATA3_API int browni_solve(n3_vec D, n3_vec S, n3_vec W, n3_real *l, n3_real *m)
{
    n3_vec d = n3_unit(D), s = n3_unit(S), N = n3_cross(d, s);
    n3_real NN = n3_dot(N, N);
    if (!(NN > (n3_real)1 / 256)) return 0;
    *l = n3_dot(n3_cross(W, s), N) / (NN * n3_len(D));
    *m = n3_dot(n3_cross(d, W), N) / (NN * n3_len(S));
    return 1;
}

/* c += l(t) q(t), l and q quadratic, l given at 0, 1/2 and 1, as a curve of degree 4. */
NAGATA3_API void browni_add_times(n3_vec *c, const n3_vec q[3], const n3_real l[3])
{
    n3_real bump = 4 * l[1] - 2 * (l[0] + l[2]); /* l = linear + bump t (1 - t) */
    n3_vec a[5], b[5];
    int k;
    for (k = 0; k < 3; k++) a[k] = b[k] = q[k];
    browni_raise(a, 2, l[0], l[2]);
    browni_raise(a, 3, 1, 1);
    browni_raise(b, 2, 0, bump);
    browni_raise(b, 3, 1, 0);
    for (k = 0; k < 5; k++) c[k] = n3_add(c[k], n3_add(a[k], b[k]));
}

/* Cross tangents along a side, l(t) D(t) + m(t) S(t), that are T[0], T[1] and T[2] at its
   beginning, middle and end. Linear where there is no S at an end. */
NAGATA3_API brown_field browni_cross_tangents(const browni_frame *f, const n3_vec T[3])
{
    n3_real l[3], m[3];
    n3_vec c[8];
    n3_edge linear = n3i_edge_straight(T[0], T[2]);
    int k;
    memset(c, 0, sizeof c);
    if (!browni_solve(f->D[0], f->S[0], T[0], &l[0], &m[0]) ||
        !browni_solve(f->D[2], f->S[2], T[2], &l[2], &m[2]))
        return browni_field_of(linear.p, 3);
    l[1] = (l[0] + l[2]) / 2;
    m[1] = (m[0] + m[2]) / 2;
    browni_solve(browni_middle(f->D), browni_middle(f->S), T[1], &l[1], &m[1]);
    browni_add_times(c, f->D, l);
    browni_add_times(c, f->S, m);
    for (k = 0; k < 2; k++) c[4 * k] = T[2 * k];
    return browni_field_of(c, 4);
}

NAGATA3_API n3_vertex browni_middle_vertex(const n3_edge *side, const browni_frame *f)
{
    n3_vertex v;
    v.x = n3_edge_point(side, (n3_real)1 / 2);
    v.n = f->n;
    return v;
}

NAGATA3_API brown_square brown_quad_from_edges(const n3_vertex corner[4], const n3_edge edge[4],
                                               const n3_vec mid[4], const n3_options *o)
{
    static const int end[4][2] = {{0, 1}, {3, 2}, {0, 3}, {1, 2}}, round[4] = {0, 2, 3, 1};
    brown_square s;
    browni_frame f[4];
    int i, k;
    memset(&s, 0, sizeof s);
    s.side[0] = edge[0];
    s.side[1] = n3_edge_reverse(&edge[2]);
    s.side[2] = n3_edge_reverse(&edge[3]);
    s.side[3] = edge[1];
    for (k = 0; k < 4; k++)
        f[k] = browni_frame_of(&s.side[k], corner[end[k][0]].n, corner[end[k][1]].n,
                               mid ? mid[round[k]] : n3_v(0, 0, 0), o);
    for (k = 0; k < 4; k++) {
        const n3_edge *cross = &s.side[k < 2 ? 2 : 0];
        int first = k / 2 * 2, at = 2 * (k % 2);
        n3_edge middle = n3_edge_make(browni_middle_vertex(&s.side[first], &f[first]),
                                      browni_middle_vertex(&s.side[first + 1], &f[first + 1]), o);
        n3_vec T[3];
        for (i = 0; i < 2; i++) T[2 * i] = n3_mul(3, n3_sub(cross[i].p[at + 1], cross[i].p[at]));
        T[1] = n3_mul(3, n3_sub(middle.p[at + 1], middle.p[at]));
        s.across[k] = browni_cross_tangents(&f[k], T);
    }
    return s;
}

NAGATA3_API brown_square brown_quad_make(const n3_vertex corner[4], const n3_options *o)
{
    n3_edge edge[4];
    int i;
    for (i = 0; i < 4; i++) edge[i] = n3_edge_make(corner[i], corner[(i + 1) % 4], o);
    return brown_quad_from_edges(corner, edge, NULL, o);
}

NAGATA3_API n3_vec brown_mid_normal(n3_vertex a, n3_vertex b, const n3_vertex c[2],
                                    const n3_vertex d[2])
{
    return n3_add(n3_edge_mid_normal(a, b, c[0], d[0]), n3_edge_mid_normal(a, b, c[1], d[1]));
}

/* Corner k of the quad of the triangles f and f + 1, as one of theirs. */
NAGATA3_API int browni_corner(int f, int k) { return 3 * f + (k < 3 ? k : 5); }

NAGATA3_API n3_vertex browni_vertex(const n3_mesh *m, int corner)
{
    n3_vertex v;
    v.x = n3i_point(m, n3i_at(m, corner));
    v.n = n3i_corner_normal(m, corner);
    return v;
}

/* The two points behind a side of a triangle, the one next to its end first: those of its quad, or
   twice the triangle's. */
NAGATA3_API void browni_behind(const n3_mesh *m, const int *half, int side, n3_vertex out[2])
{
    int f = side / 3, k = side % 3;
    if (half[f] < 0) {
        out[0] = out[1] = browni_vertex(m, 3 * f + (k + 2) % 3);
        return;
    }
    k += half[f] % 2; /* the sides of 0 2 3 are the quad's second diagonal, third and fourth */
    f -= half[f] % 2;
    out[0] = browni_vertex(m, browni_corner(f, (k + 2) % 4));
    out[1] = browni_vertex(m, browni_corner(f, (k + 3) % 4));
}

/* Zero where the faces at the side do not agree. */
NAGATA3_API n3_vec browni_wanted(const n3_mesh *m, const n3_topology *t, const int *half, int side)
{
    int two[2], back;
    n3_vertex a = browni_vertex(m, side), b = browni_vertex(m, n3i_after(side)), c[2], d[2];
    n3_vec turn_a, turn_b;
    if (!n3i_is_regular(m, t, t->edge[side], two)) return n3_v(0, 0, 0);
    back = two[0] + two[1] - side;
    turn_a = n3_sub(n3i_corner_normal(m, n3i_after(back)), a.n);
    turn_b = n3_sub(n3i_corner_normal(m, back), b.n);
    if (!n3i_is_zero(turn_a) || !n3i_is_zero(turn_b)) return n3_v(0, 0, 0);
    browni_behind(m, half, side, c);
    browni_behind(m, half, back, d);
    return brown_mid_normal(a, b, c, d);
}

NAGATA3_API brown_square brown_mesh_square(const n3_mesh *m, const n3_topology *t,
                                           const n3_vec *net, const int *half, int f,
                                           const n3_options *o)
{
    static const int triangle_side[4] = {0, 1, 4, 5};
    n3_vertex corner[4];
    n3_vec mid[4];
    n3_edge e[6], edge[4];
    int i;
    for (i = 0; i < 2; i++) {
        n3_patch p = n3i_mesh_patch(m, t, net, f + i);
        n3_patch_edges(&p, e + 3 * i);
    }
    for (i = 0; i < 4; i++) {
        int side = triangle_side[i];
        corner[i] = browni_vertex(m, browni_corner(f, i));
        edge[i] = e[side];
        mid[i] = n3_v(0, 0, 0);
        if (o && o->rule == N3_RULE_FIT) mid[i] = browni_wanted(m, t, half, 3 * f + side);
    }
    return brown_quad_from_edges(corner, edge, mid, o);
}

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT. Copyright 2026 the nagata3 authors; the text is in LICENSE. */
