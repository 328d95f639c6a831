/* nagata3.h 0.1.0: cubic Nagata patches, a smooth surface over triangles with vertex normals.
 *
 * SYNOPSIS
 *
 *     #include "nagata3.h"
 *     #include <stdio.h>
 *
 *     int main(void)
 *     {
 *         n3_vertex a = {{1, 0, 0}, {1, 0, 0}};
 *         n3_vertex b = {{0, 1, 0}, {0, 1, 0}};
 *         n3_vertex c = {{0, 0, 1}, {0, 0, 1}};
 *         n3_patch p = n3_patch_make(a, b, c, NULL);
 *         n3_vec x = n3_patch_point(&p, 1.0 / 3, 1.0 / 3);
 *         printf("middle %.6f %.6f %.6f, radius %.10f\n", x.x, x.y, x.z, n3_len(x));
 *         return 0;
 *     }
 *
 * An octant of the unit sphere, from its three corners; the program is examples/01_point.c.
 *
 * CONTENTS
 *
 *     Part I, the paper     vectors, segment, curve plane, edge, patch, evaluator
 *     Part II, the mesh     what a mesh of triangles needs on top of single patches
 *
 * THE SURFACE
 *
 * A number in parentheses is an equation of Shimizu's paper [1]; each has a test of its name.
 * The patch is a cubic Bezier triangle. Its net, as p_ijk and as the index in n3_patch.p:
 *
 *                      c = p030                                 2
 *                       /    \                                 / \
 *                   p021      p120                            7   6
 *                   /            \                           /     \
 *               p012     p111     p210                      8   9   5
 *               /                    \                     /         \
 *       a = p003 --- p102 --- p201 --- p300 = b           0 - 3 --- 4 - 1
 *
 * Its domain is the triangle u >= 0, v >= 0, w = 1 - u - v >= 0, with the weight w on a, u on b
 * and v on c: the (u, v) of ray tracers and finite elements, and the paper's u = eta - zeta,
 * v = zeta, w = 1 - eta. In p_ijk, i counts u, j counts v, k counts w. The order of the indices
 * is the node order of VTK_BEZIER_TRIANGLE, VTK_LAGRANGE_TRIANGLE and Gmsh's 10-node triangle.
 *
 * How it comes about, for each edge from x0 to x1 with the unit normals n0 and n1 at its ends:
 *
 *     1  d = x1 - x0, L = |d|, e = d / L.
 *     2  The curve lies in a plane Pi through the chord. The planes through the chord that are
 *        perpendicular to the two tangent planes have the normals m0 = e x n0 and m1 = e x n1;
 *        Pi bisects the smaller angle between them, so that no nearly parallel pair of tangent
 *        planes can lay it flat, which is how Nagata's parabola comes to bulge.
 *     3  Pi meets the tangent planes in the tangents t_s and t_e, at the angles theta_s and
 *        theta_e to the chord, both turned to run along it.
 *     4  The handles d_s and d_e are those of the raised parabola that has these angles, (5.1.13)
 *        and (5.1.14), so where Nagata's curve is sound it is kept.
 *     5  p21 = x0 + d_s t_s and p12 = x1 - d_e t_e.
 *
 * The three edges leave p111, the centre: half the sum of the three ruled surfaces between pairs
 * of edges less the flat triangle, (6.1.10). It is the centre of a PN triangle [3] as well.
 *
 * Nagata's own patch, a quadratic one, is here too: its net is p002 p200 p020 | p101 p110 p011.
 *
 * CONVENTIONS
 *
 * Normals are unit to rounding, points are in any unit. Angles appear as their tangents. Nothing
 * is allocated, nothing is kept, and nothing depends on anything but the arguments. Structures up
 * to a vertex go by value, larger ones by pointer; results are returned. An edge's curve is
 * the same, bit for bit, from either end: neighbours share it exactly. Edges run round the
 * triangle, ab, bc, ca, so that ca is the paper's third edge (5.2.7) reversed. In bounds,
 * eps is N3_EPS, the spacing of n3_real at 1, and an ulp is one of the largest coordinate involved.
 *
 * DEGENERATE INPUT
 *
 *     parallel normals            segment: the chord; edges: as always, no case of their own
 *     opposite normals            segment: the chord; the arc rule uses the paper's
 *     one normal along the chord  the plane comes from the other end; this end counts as 90
 *                                 degrees and the edge becomes a C
 *     both along the chord        straight, control points at thirds
 *     one normal zero             the other end's, made orthogonal to the chord; if that
 *                                 vanishes, straight
 *     both zero                   straight
 *     coincident points           all control points between them
 *     collapsed, folded triangle  the patch of its edges
 *     no normal at a point        the limit along the way to the centroid, else the triangle's
 *                                 normal, else the net's, else zero
 *     NaN                         NaN, in what depends on it
 *
 * A zero normal is how CAD kernels say that there is none, at the apex of a cone for example.
 * Sizes from 1e-150 to 1e150 (float: 1e-18 to 1e18) are all alike: there is no length tolerance.
 *
 * DISCONTINUITIES
 *
 * The result jumps, as any construction of this kind must, where
 *
 *     <m0, m1> = 0    the two perpendicular planes cross at 90 degrees: two bisectors
 *     <t, e> = 0      a tangent at 90 degrees to the chord: along it, or against it
 *     n1 = -n0        arc rule: every direction bisects; segment: so does n1 = n0, by a pole
 *
 * and where a row of the table above begins to apply.
 *
 * CONFIGURATION, before the header is included
 *
 *     NAGATA3_FLOAT    n3_real is float. Both precisions can live in one program, in different
 *                      translation units.
 *     NAGATA3_API      what stands before every function, static inline by default; for CUDA
 *                      static inline __host__ __device__.
 *
 * REFERENCES
 *
 *     [1] Shimizu Y., Extension of Nagata Patch to Cubic Degree, Nihon Unisys (in Japanese).
 *     [2] Nagata T., Simple local interpolation of surfaces using normal vectors, Computer Aided
 *         Geometric Design 22, 2005, 327-347.
 *     [3] Vlachos A., Peters J., Boyd C., Mitchell J., Curved PN triangles, Symposium on
 *         Interactive 3D Graphics, 2001, 159-166.
 *     [4] Farin G., Curves and Surfaces for CAGD, 4th edition, Academic Press, 1997.
 */
#ifndef NAGATA3_H
#define NAGATA3_H

#include <math.h>
#include <string.h>

#define NAGATA3_VERSION "0.1.0"

/* ---- Portability ---- */

#ifdef NAGATA3_FLOAT
#define N3I_PICK(in_double, in_float) in_float
#else
#define N3I_PICK(in_double, in_float) in_double
#endif
#ifndef NAGATA3_API
#define NAGATA3_API static inline
#endif
#if defined __cplusplus && __cplusplus >= 201103L /* a name of its own per precision, for linkers */
inline namespace N3I_PICK(nagata3_double, nagata3_float) {
#elif defined __cplusplus
namespace N3I_PICK(nagata3_double, nagata3_float) {}
using namespace N3I_PICK(nagata3_double, nagata3_float);
namespace N3I_PICK(nagata3_double, nagata3_float) {
#endif

typedef N3I_PICK(double, float) n3_real;

/* ==== Part I: the paper ========================================================================

   ---- Types ---- */

/* A point or a vector; an array of xyz triples may be read as an array of these. */
typedef struct n3_vec { n3_real x, y, z; } n3_vec;

/* An end of an edge, a corner of a triangle: a point and its unit normal. */
typedef struct n3_vertex { n3_vec x, n; } n3_vertex;

/* Quadratic Bezier curve: p20 p11 p02. */
typedef struct n3_segment { n3_vec p[3]; } n3_segment;

/* Cubic Bezier curve: p30 p21 p12 p03. */
typedef struct n3_edge { n3_vec p[4]; } n3_edge;

/* Quadratic Bezier triangle: p002 p200 p020 | p101 p110 p011. */
typedef struct n3_patch2 { n3_vec p[6]; } n3_patch2;

/* Cubic Bezier triangle: p003 p300 p030 | p102 p201 | p210 p120 | p021 p012 | p111. */
typedef struct n3_patch { n3_vec p[10]; } n3_patch;

/* A point of a curve with its first and second derivative. */
typedef struct n3_curve_jet { n3_vec x, dt, dtt; } n3_curve_jet;

/* A point of a patch with its first and second derivatives in u and v (w = 1 - u - v). */
typedef struct n3_jet { n3_vec x, du, dv, duu, duv, dvv; } n3_jet;

enum {
    N3_RULE_PAPER, /* the paper's cubic edge and centre */
    N3_RULE_ARC,   /* ours: circles to sixth order; wants normals that all look outwards */
    N3_RULE_FIT    /* ours: arc, and normals across edges fitted over the neighbours of a mesh */
};

/* Where a function takes options, NULL means the defaults, and so does a field that is not > 0. */
typedef struct n3_options {
    int rule;      /* N3_RULE_PAPER; an unknown value means the same */
    n3_real tan_lo; /* 1/10: smallest tangent of the angle at an end, epsilon of (5.1.11) */
    n3_real tan_hi; /* 10: largest, Omega of (5.1.12); at least tan_lo */
} n3_options;

typedef char n3i_assert_packed[sizeof(n3_vec) == 3 * sizeof(n3_real) ? 1 : -1];

/* ---- Tolerances: all of them, none is a length ---- */

/* The spacing of n3_real at 1. */
#define N3_EPS N3I_PICK((n3_real)1 / 67108864 / 67108864, (n3_real)1 / 8388608)

/* Normals whose sine is at most this count as parallel in the segment: beyond it, c of (2.1.7) is
   four times the chord at least and made of the normals' last two bits. */
#define N3_PARALLEL N3I_PICK((n3_real)1 / 33554432 / 33554432, (n3_real)1 / 4194304)

/* A normal whose sine with the chord is at most this lies along it: the direction of e x n then
   has less than a quarter (float: a half) of its digits left. */
#define N3_ALONG N3I_PICK((n3_real)1 / 1048576 / 1048576, (n3_real)1 / 65536)

/* Normals whose sum is at most this long are opposite: the bisector has lost half its digits. */
#define N3_OPPOSITE N3I_PICK((n3_real)1 / 67108864, (n3_real)1 / 4096)

/* A normal du x dv shorter than this times |du| + |dv|, the patch being of size 1, is rounding:
   the error of du and dv is below 28 eps. */
#define N3_NOISE (32 * N3_EPS)

/* ---- Vectors ---- */

NAGATA3_API n3_vec n3_v(n3_real x, n3_real y, n3_real z);
NAGATA3_API n3_vec n3_add(n3_vec a, n3_vec b);
NAGATA3_API n3_vec n3_sub(n3_vec a, n3_vec b);
NAGATA3_API n3_vec n3_mul(n3_real s, n3_vec a);
NAGATA3_API n3_real n3_dot(n3_vec a, n3_vec b);
NAGATA3_API n3_vec n3_cross(n3_vec a, n3_vec b);

/* Length, at every size: nothing overflows or underflows before the result does. */
NAGATA3_API n3_real n3_len(n3_vec a);

/* a / |a|, at every size; the zero vector stays zero. */
NAGATA3_API n3_vec n3_unit(n3_vec a);

/* ---- Nagata's segment and patch, quadratic ---- */

/* Nagata's c of x(t) = x0 + (d - c) t + c t^2, twice the way from the curve's middle control point
   to the middle of the chord: the one vector in the span of n0 and n1 with <n0, d - c> = 0 (2.1.5)
   and <n1, d + c> = 0 (2.1.6). Zero when the normals are parallel, opposite or zero; unbounded
   nearby: with a chord tilted by A and normals turned by delta, |c| is 2 L tan(A) / delta.
   The same from either end, bit for bit. 40 flops, 3 divisions. */
NAGATA3_API n3_vec n3_segment_curvature(n3_vertex a, n3_vertex b);

/* The segment from a to b: (3.1.5)-(3.1.7). */
NAGATA3_API n3_segment n3_segment_make(n3_vertex a, n3_vertex b);

/* The same curve as a cubic: (5.1.3)-(5.1.6). */
NAGATA3_API n3_edge n3_segment_raise(const n3_segment *s);

/* Nagata's patch over the triangle a, b, c: (3.2.6)-(3.2.11). */
NAGATA3_API n3_patch2 n3_patch2_make(n3_vertex a, n3_vertex b, n3_vertex c);

/* Its point at u on b, v on c: (3.2.5). */
NAGATA3_API n3_vec n3_patch2_point(const n3_patch2 *q, n3_real u, n3_real v);

/* The same surface as a cubic patch. */
NAGATA3_API n3_patch n3_patch2_raise(const n3_patch2 *q);

/* ---- The edge ---- */

/* Unit normal of the plane Pi that holds the edge between a and b: the bisector, nearer to both,
   of the planes through the chord perpendicular to the tangent planes (countermeasure 1, section
   4.2). From the other end it is the same up to sign. An end whose normal is zero or lies along
   the chord leaves the plane to the other; both: no plane, the zero vector.
   5 square roots, 15 divisions. */
NAGATA3_API n3_vec n3_curve_plane(n3_vertex a, n3_vertex b);

/* The cubic edge from a to b: (5.1.13) (5.1.14), or the arc rule.
   Exactly n3_edge_reverse of the edge from b to a. Tangent to both tangent planes to 8 ulp. No
   handle is longer than 4/3 of the chord (arc: 2/3), whatever the normals. */
NAGATA3_API n3_edge n3_edge_make(n3_vertex a, n3_vertex b, const n3_options *o);

/* Point of the curve at t, any real; in [0, 1] it runs from p[0] to p[3]: (5.1.1).
   n3_edge_point(e, t) and n3_edge_point(reverse of e, 1 - t) are the same bits where
   1 - (1 - t) == t, and t = 0 and t = 1 give the ends exactly. 30 flops. */
NAGATA3_API n3_vec n3_edge_point(const n3_edge *e, n3_real t);

/* Point, first and second derivative at t. The derivatives are made from differences of control
   points, so that their error is relative to the size of the edge, not to where it lies. */
NAGATA3_API n3_curve_jet n3_edge_jet(const n3_edge *e, n3_real t);

/* The same curve run the other way. */
NAGATA3_API n3_edge n3_edge_reverse(const n3_edge *e);

/* The parts of the curve before and after t (de Casteljau); out[0].p[3] is out[1].p[0]. */
NAGATA3_API void n3_edge_split(const n3_edge *e, n3_real t, n3_edge out[2]);

/* ---- The patch ---- */

/* Centre p111 from the edges, which run round the triangle: (6.1.10). */
NAGATA3_API n3_vec n3_patch_centre(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca);

/* Ours, for edges of the arc rule: the centre with cubic precision along the surface, and with
   neighbours that nearly agree on the normal in the middle of the edge that they share. n: unit
   normals at a, b, c. mid: a wanted normal at the middle of ab, bc, ca, of any length; NULL means
   the sum of the edge's end normals. A normal that vanishes contributes nothing. */
NAGATA3_API n3_vec n3_patch_centre_arc(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca,
                                       const n3_vec n[3], const n3_vec mid[3]);

/* The patch that has these edges, round the triangle, and this centre: (5.2.2)-(5.2.7). */
NAGATA3_API n3_patch n3_patch_from_edges(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca,
                                         n3_vec centre);

/* The patch over the triangle a, b, c: three edges and a centre by the rule. A patch alone has no
   neighbours to fit to: N3_RULE_FIT is the arc rule here. Corners given in another order give the
   same edges, bit for bit, and the same centre to 4 ulp. */
NAGATA3_API n3_patch n3_patch_make(n3_vertex a, n3_vertex b, n3_vertex c, const n3_options *o);

/* The edges ab, bc, ca of a patch. */
NAGATA3_API void n3_patch_edges(const n3_patch *p, n3_edge out[3]);

/* The same surface as a bicubic tensor product with a collapsed side, for kernels without Bezier
   triangles: out[4 i + j] is the control point of weight B3_i(s) B3_j(t), where w = 1 - s,
   u = s (1 - t), v = s t. The row i = 0 is the corner a, four times. */
NAGATA3_API void n3_patch_bicubic(const n3_patch *p, n3_vec out[16]);

/* ---- The evaluator ---- */

/* Point at the weights w = 1 - u - v on a, u on b, v on c: (5.2.1). On a side, where u, v or w is
   exactly 0, it is n3_edge_point of that side: of ab at u, of bc at v, of ca reversed at v.
   Outside the triangle the polynomial goes on. 70 flops. */
NAGATA3_API n3_vec n3_patch_point(const n3_patch *p, n3_real u, n3_real v);

/* Point, first and second derivatives; errors as for n3_edge_jet. */
NAGATA3_API n3_jet n3_patch_jet(const n3_patch *p, n3_real u, n3_real v);

/* Unit normal of the surface, along du x dv: it looks to the side from which a, b, c run
   counterclockwise. Where du x dv vanishes, as at a collapsed side, the limit on the way from the
   centroid; failing that the triangle's normal, then the normal of the net, then zero. */
NAGATA3_API n3_vec n3_patch_normal(const n3_patch *p, n3_real u, n3_real v);

/* ---- Definitions: vectors ---- */

NAGATA3_API n3_vec n3_v(n3_real x, n3_real y, n3_real z)
{
    n3_vec a;
    a.x = x;
    a.y = y;
    a.z = z;
    return a;
}

NAGATA3_API n3_vec n3_add(n3_vec a, n3_vec b) { return n3_v(a.x + b.x, a.y + b.y, a.z + b.z); }
NAGATA3_API n3_vec n3_sub(n3_vec a, n3_vec b) { return n3_v(a.x - b.x, a.y - b.y, a.z - b.z); }
NAGATA3_API n3_vec n3_mul(n3_real s, n3_vec a) { return n3_v(s * a.x, s * a.y, s * a.z); }
NAGATA3_API n3_real n3_dot(n3_vec a, n3_vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

NAGATA3_API n3_vec n3_cross(n3_vec a, n3_vec b)
{
    return n3_v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* Rounded correctly in both precisions: a float's root has too few digits to be rounded twice. */
NAGATA3_API n3_real n3i_sqrt(n3_real x) { return (n3_real)sqrt((double)x); }
NAGATA3_API n3_real n3i_abs(n3_real x) { return (n3_real)fabs((double)x); }
NAGATA3_API n3_real n3i_larger(n3_real a, n3_real b) { return b > a ? b : a; }

NAGATA3_API n3_vec n3i_over(n3_vec a, n3_real s) { return n3_v(a.x / s, a.y / s, a.z / s); }
NAGATA3_API n3_vec n3i_neg(n3_vec a) { return n3_v(-a.x, -a.y, -a.z); }

/* The largest component: what every norm divides by first. */
NAGATA3_API n3_real n3i_largest(n3_vec a)
{
    return n3i_larger(n3i_larger(n3i_abs(a.x), n3i_abs(a.y)), n3i_abs(a.z));
}

NAGATA3_API int n3i_is_zero(n3_vec a) { return n3i_abs(a.x) + n3i_abs(a.y) + n3i_abs(a.z) <= 0; }

NAGATA3_API n3_real n3_len(n3_vec a)
{
    n3_real s = n3i_largest(a);
    if (n3i_is_zero(a)) return 0;
    a = n3i_over(a, s);
    return s * n3i_sqrt(n3_dot(a, a));
}

NAGATA3_API n3_vec n3_unit(n3_vec a)
{
    if (n3i_is_zero(a)) return a;
    a = n3i_over(a, n3i_largest(a));
    return n3i_over(a, n3i_sqrt(n3_dot(a, a)));
}

/* The part of n across the unit vector e, unit; zero when n is zero or along e. */
NAGATA3_API n3_vec n3i_across(n3_vec n, n3_vec e)
{
    n3_vec r = n3_cross(e, n);
    if (n3_len(r) <= N3_ALONG) return n3_v(0, 0, 0);
    return n3_unit(n3_cross(r, e));
}

/* -1, 0 or 1 as a stands before, with or behind b, by x, then y, then z. */
NAGATA3_API int n3i_order(n3_vec a, n3_vec b)
{
    if (a.x < b.x || a.x > b.x) return a.x < b.x ? -1 : 1;
    if (a.y < b.y || a.y > b.y) return a.y < b.y ? -1 : 1;
    return a.z < b.z ? -1 : a.z > b.z;
}

/* Puts the ends of an edge in an order that does not depend on how they were given: what is then
   computed is the same from either end. True if they were swapped. */
NAGATA3_API int n3i_sort_ends(n3_vertex *a, n3_vertex *b)
{
    int order = n3i_order(a->x, b->x);
    n3_vertex t = *a;
    if (order == 0) order = n3i_order(a->n, b->n);
    if (order <= 0) return 0;
    *a = *b;
    *b = t;
    return 1;
}

/* ---- Definitions: Nagata's segment and patch ---- */

/* c = l0 n0 + l1 n1 (2.1.7) solved for l0 and l1 cancels where the segment is interesting, near
   parallel normals. With X = n0 x n1 the same vector is

       c = (<n0, d> n1 + <n1, d> n0) x X / |X|^2                                            (2.1.7)

   and X is free of cancellation when n0 x (n1 - n0) or n0 x (n1 + n0) is taken for it. */
NAGATA3_API n3_vec n3_segment_curvature(n3_vertex a, n3_vertex b)
{
    n3_vec d, X, c;
    n3_real XX;
    n3i_sort_ends(&a, &b);
    d = n3_sub(b.x, a.x);                                                           /* (2.1.2) */
    X = n3_cross(a.n, n3_dot(a.n, b.n) >= 0 ? n3_sub(b.n, a.n) : n3_add(b.n, a.n));
    XX = n3_dot(X, X);
    if (XX <= N3_PARALLEL * N3_PARALLEL) return n3_v(0, 0, 0);
    c = n3_add(n3_mul(n3_dot(a.n, d), b.n), n3_mul(n3_dot(b.n, d), a.n));
    return n3i_over(n3_cross(c, X), XX);                                            /* (2.1.7) */
}

NAGATA3_API n3_segment n3_segment_make(n3_vertex a, n3_vertex b)
{
    n3_segment s;
    n3_vec c = n3_segment_curvature(a, b);
    s.p[0] = a.x;                                                                   /* (3.1.5) */
    s.p[1] = n3_mul((n3_real)1 / 2, n3_sub(n3_add(a.x, b.x), c));                   /* (3.1.6) */
    s.p[2] = b.x;                                                                   /* (3.1.7) */
    return s;
}

NAGATA3_API n3_edge n3i_edge_of(n3_vec p30, n3_vec p21, n3_vec p12, n3_vec p03)
{
    n3_edge e;
    e.p[0] = p30;
    e.p[1] = p21;
    e.p[2] = p12;
    e.p[3] = p03;
    return e;
}

NAGATA3_API n3_edge n3_segment_raise(const n3_segment *s)
{
    n3_edge e;
    e.p[0] = s->p[0];                                                               /* (5.1.3) */
    e.p[1] = n3i_over(n3_add(s->p[0], n3_mul(2, s->p[1])), 3);                      /* (5.1.4) */
    e.p[2] = n3i_over(n3_add(n3_mul(2, s->p[1]), s->p[2]), 3);                      /* (5.1.5) */
    e.p[3] = s->p[2];                                                               /* (5.1.6) */
    return e;
}

NAGATA3_API n3_patch2 n3_patch2_make(n3_vertex a, n3_vertex b, n3_vertex c)
{
    n3_patch2 q;
    q.p[0] = a.x;                                                                   /* (3.2.6) */
    q.p[3] = n3_segment_make(a, b).p[1];                                            /* (3.2.7) */
    q.p[1] = b.x;                                                                   /* (3.2.8) */
    q.p[5] = n3_segment_make(a, c).p[1];                                            /* (3.2.9) */
    q.p[4] = n3_segment_make(b, c).p[1];                                           /* (3.2.10) */
    q.p[2] = c.x;                                                                  /* (3.2.11) */
    return q;
}

/* w a + u b + v c */
NAGATA3_API n3_vec n3i_mix(n3_real w, n3_vec a, n3_real u, n3_vec b, n3_real v, n3_vec c)
{
    return n3_add(n3_add(n3_mul(w, a), n3_mul(u, b)), n3_mul(v, c));
}

NAGATA3_API n3_vec n3_patch2_point(const n3_patch2 *q, n3_real u, n3_real v)
{
    const n3_vec *p = q->p;
    n3_real w = 1 - u - v;
    return n3_add(n3i_mix(w * w, p[0], u * u, p[1], v * v, p[2]),
                  n3i_mix(2 * u * w, p[3], 2 * u * v, p[4], 2 * v * w, p[5]));      /* (3.2.5) */
}

NAGATA3_API n3_patch n3_patch2_raise(const n3_patch2 *q)
{
    static const int side[3][3] = {{0, 3, 1}, {1, 4, 2}, {2, 5, 0}};
    n3_edge e[3];
    n3_vec centre = n3i_over(n3_add(n3_add(q->p[3], q->p[4]), q->p[5]), 3);
    int i, k;
    for (i = 0; i < 3; i++) {
        n3_segment s;
        for (k = 0; k < 3; k++) s.p[k] = q->p[side[i][k]];
        e[i] = n3_segment_raise(&s);
    }
    return n3_patch_from_edges(&e[0], &e[1], &e[2], centre);
}

/* ---- Definitions: the edge ---- */

/* Pi for the unit chord e and the normals at its ends. The bisector of the smaller angle of two
   planes is the one whose normal is the sum of theirs when these make an acute angle. */
NAGATA3_API n3_vec n3i_plane(n3_vec e, n3_vec n0, n3_vec n1)
{
    n3_vec m0 = n3_cross(e, n0), m1 = n3_cross(e, n1);
    m0 = n3_len(m0) <= N3_ALONG ? n3_v(0, 0, 0) : n3_unit(m0);
    m1 = n3_len(m1) <= N3_ALONG ? n3_v(0, 0, 0) : n3_unit(m1);
    return n3_unit(n3_dot(m0, m1) >= 0 ? n3_add(m0, m1) : n3_sub(m0, m1));
}

NAGATA3_API n3_vec n3_curve_plane(n3_vertex a, n3_vertex b)
{
    return n3i_plane(n3_unit(n3_sub(b.x, a.x)), a.n, b.n);
}

/* The tangent cos e + sin b at an end, and the tangent of its angle to the chord after clamping. */
typedef struct n3i_end { n3_real cos, sin, tan; int along; } n3i_end;

/* Where Pi, spanned by the chord e and b across it, meets the tangent plane of the normal n:
   <n, cos e + sin b> = 0, turned along the chord, cos >= 0, as the paper does it by (4.2.1) and
   the corrected points of (5.1.4a) and (5.1.5a), here without a point of intersection. A normal
   along the chord gives tan_hi, and no direction of its own. */
NAGATA3_API n3i_end n3i_end_make(n3_vec n, n3_vec e, n3_vec b, const n3_options *o)
{
    n3_real ne = n3_dot(n, e), nb = n3_dot(n, b), h = n3i_sqrt(ne * ne + nb * nb);
    n3i_end t;
    t.cos = t.sin = 0;
    t.tan = o->tan_hi;
    t.along = n3_len(n3_cross(e, n)) <= N3_ALONG;
    if (t.along) return t;
    if (n3i_abs(ne) < o->tan_hi * n3i_abs(nb)) t.tan = n3i_abs(ne / nb);           /* (5.1.12) */
    t.tan = n3i_larger(t.tan, o->tan_lo);                                          /* (5.1.11) */
    t.cos = n3i_abs(nb) / h;
    t.sin = (nb < 0 ? ne : -ne) / h;
    return t;
}

/* The handle at an end of a chord of length L, from the clamped angles here and at the other end;
   beyond 60 degrees it is no longer stretched by 1/cos. */
NAGATA3_API n3_real n3i_handle(n3i_end here, n3i_end other, n3_real L)
{
    n3_real ratio = other.tan / (here.tan + other.tan);
    if (here.cos >= (n3_real)1 / 2) return ratio / here.cos * (2 * L / 3);
    return ratio * (4 * L / 3);
}

NAGATA3_API n3_edge n3i_edge_straight(n3_vec x0, n3_vec x1)
{
    n3_vec third = n3i_over(n3_sub(x1, x0), 3);
    return n3i_edge_of(x0, n3_add(x0, third), n3_sub(x1, third), x1);
}

/* m: unit normal of Pi. An end whose normal lies along the chord starts at 90 degrees on the side
   from which the other end comes down. */
NAGATA3_API n3_edge n3i_edge_paper(n3_vertex v0, n3_vertex v1, n3_vec m, const n3_options *o)
{
    n3_vec d = n3_sub(v1.x, v0.x), e = n3_unit(d), b = n3_cross(m, e), ts, te;
    n3_real L = n3_len(d);
    n3i_end s = n3i_end_make(v0.n, e, b, o), t = n3i_end_make(v1.n, e, b, o);
    n3_real ds = n3i_handle(s, t, L);                                              /* (5.1.13) */
    n3_real de = n3i_handle(t, s, L);                                              /* (5.1.14) */
    if (s.along) s.sin = t.sin > 0 ? -1 : 1;
    if (t.along) t.sin = s.sin < 0 ? 1 : -1;
    ts = n3_add(n3_mul(s.cos, e), n3_mul(s.sin, b));
    te = n3_add(n3_mul(t.cos, e), n3_mul(t.sin, b));
    return n3i_edge_of(v0.x, n3_add(v0.x, n3_mul(ds, ts)), n3_sub(v1.x, n3_mul(de, te)), v1.x);
}

/* Ours. m = unit(n0 + n1) bisects the normals, which make the angle 2 a; cos = cos a. Of the chord
   d the part along m is dropped; the rest, split into what bends, g, and what does not, is turned
   into each tangent plane, and the bending part is lengthened by 1/cos^2(a/2): with k = 1/(1 + cos)

       q   = d - <d, m> m - (g k^2 / 4) (n1 - n0),      g = <d, n1 - n0>
       p21 = x0 + (q + g k m) / 3,      p12 = x1 - (q - g k m) / 3

   On a circle both handles are (2 L / 3) / (1 + cos a), its approximation of sixth order. */
NAGATA3_API n3_edge n3i_edge_arc(n3_vertex v0, n3_vertex v1)
{
    n3_vec d = n3_sub(v1.x, v0.x), turn = n3_sub(v1.n, v0.n), sum = n3_add(v0.n, v1.n);
    n3_vec m = n3_unit(sum), q, p21, p12;
    n3_real g = n3_dot(d, turn), k = 1 / (1 + n3_len(sum) / 2);
    q = n3_sub(n3_sub(d, n3_mul(n3_dot(d, m), m)), n3_mul(g * k * k / 4, turn));
    m = n3_mul(g * k, m);
    p21 = n3_add(v0.x, n3i_over(n3_add(q, m), 3));
    p12 = n3_sub(v1.x, n3i_over(n3_sub(q, m), 3));
    return n3i_edge_of(v0.x, p21, p12, v1.x);
}

NAGATA3_API n3_options n3i_defaults(const n3_options *given)
{
    n3_options o = {N3_RULE_PAPER, 0, 0};
    if (given) o = *given;
    if (!(o.tan_lo > 0)) o.tan_lo = (n3_real)1 / 10;
    if (!(o.tan_hi > 0)) o.tan_hi = 10;
    o.tan_hi = n3i_larger(o.tan_hi, o.tan_lo);
    return o;
}

NAGATA3_API int n3i_is_arc(const n3_options *o)
{
    return o && (o->rule == N3_RULE_ARC || o->rule == N3_RULE_FIT);
}

/* The edge between ends in canonical order. */
NAGATA3_API n3_edge n3i_edge_sorted(n3_vertex a, n3_vertex b, const n3_options *given)
{
    n3_options o = n3i_defaults(given);
    n3_vec e = n3_unit(n3_sub(b.x, a.x)), m;
    if (n3i_is_zero(a.n)) a.n = n3i_across(b.n, e);
    else if (n3i_is_zero(b.n)) b.n = n3i_across(a.n, e);
    m = n3i_plane(e, a.n, b.n);
    if (n3i_is_zero(m)) return n3i_edge_straight(a.x, b.x);
    if (n3i_is_arc(&o) && !(n3_len(n3_add(a.n, b.n)) <= N3_OPPOSITE)) return n3i_edge_arc(a, b);
    return n3i_edge_paper(a, b, m, &o);
}

NAGATA3_API n3_edge n3_edge_make(n3_vertex a, n3_vertex b, const n3_options *o)
{
    int swapped = n3i_sort_ends(&a, &b);
    n3_edge e = n3i_edge_sorted(a, b, o);
    return swapped ? n3_edge_reverse(&e) : e;
}

/* True if the canonical direction of the curve is the reverse. */
NAGATA3_API int n3i_runs_back(const n3_edge *e)
{
    int order = n3i_order(e->p[0], e->p[3]);
    return (order ? order : n3i_order(e->p[1], e->p[2])) > 0;
}

/* Evaluated from the canonical end: k ^ i counts the control points from there. */
NAGATA3_API n3_vec n3_edge_point(const n3_edge *e, n3_real t)
{
    const n3_vec *p = e->p;
    int k = n3i_runs_back(e) ? 3 : 0;
    n3_real s = k ? t : 1 - t, r = k ? 1 - t : t;
    return n3_add(n3_add(n3_mul(s * s * s, p[k]), n3_mul(3 * s * s * r, p[k ^ 1])),
                  n3_add(n3_mul(3 * s * r * r, p[k ^ 2]), n3_mul(r * r * r, p[k ^ 3])));
}                                                                                   /* (5.1.1) */

NAGATA3_API n3_curve_jet n3_edge_jet(const n3_edge *e, n3_real t)
{
    n3_curve_jet j;
    n3_real s = 1 - t;
    n3_vec d0 = n3_sub(e->p[1], e->p[0]);
    n3_vec d1 = n3_sub(e->p[2], e->p[1]);
    n3_vec d2 = n3_sub(e->p[3], e->p[2]);
    j.x = n3_edge_point(e, t);
    j.dt = n3_mul(3, n3i_mix(s * s, d0, 2 * s * t, d1, t * t, d2));
    j.dtt = n3_mul(6, n3_add(n3_mul(s, n3_sub(d1, d0)), n3_mul(t, n3_sub(d2, d1))));
    return j;
}

NAGATA3_API n3_edge n3_edge_reverse(const n3_edge *e)
{
    return n3i_edge_of(e->p[3], e->p[2], e->p[1], e->p[0]);
}

NAGATA3_API void n3_edge_split(const n3_edge *e, n3_real t, n3_edge out[2])
{
    n3_vec p[4];
    int i, k;
    for (i = 0; i < 4; i++) p[i] = e->p[i];
    for (k = 3; k >= 0; k--) {
        out[0].p[3 - k] = p[0];
        out[1].p[k] = p[k];
        for (i = 0; i < k; i++) p[i] = n3_add(n3_mul(1 - t, p[i]), n3_mul(t, p[i + 1]));
    }
}

/* ---- Definitions: the patch ---- */

NAGATA3_API n3_vec n3_patch_centre(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca)
{
    n3_vec p201_p021 = n3_add(ab->p[2], ca->p[1]);
    n3_vec p012_p210 = n3_add(ca->p[2], bc->p[1]);
    n3_vec p102_p120 = n3_add(ab->p[1], bc->p[2]);
    n3_vec corners = n3_add(n3_add(ab->p[0], bc->p[0]), ca->p[0]);
    return n3_sub(n3i_over(n3_add(n3_add(p201_p021, p012_p210), p102_p120), 4),
                  n3i_over(corners, 6));                                           /* (6.1.10) */
}

/* (6.1.10) has quadratic precision only, and the coordinates of an arc along its chord are cubics.
   The missing cubic is the one of the second fundamental form A and the normals: with x_i, v_i the
   corners and normals less their means and A_ij = (<x_i, v_j> + <x_j, v_i>) / 2

       C = (6.1.10) - (A_ab v_c + A_bc v_a + A_ca v_b) / 8 */
NAGATA3_API n3_vec n3i_centre_cubic(const n3_vec x[3], const n3_vec n[3], n3_vec centre)
{
    n3_vec xm = n3i_over(n3_add(n3_add(x[0], x[1]), x[2]), 3);
    n3_vec nm = n3i_over(n3_add(n3_add(n[0], n[1]), n[2]), 3);
    int i;
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n3_real A = n3_dot(n3_sub(x[i], xm), n3_sub(n[j], nm)) +
                    n3_dot(n3_sub(x[j], xm), n3_sub(n[i], nm));
        centre = n3_sub(centre, n3_mul(A / 16, n3_sub(n[k], nm)));
    }
    return centre;
}

/* Then C moves along N = unit(n_a + n_b + n_c), by least squares over the edges, to where the
   surface has the wanted normals in their middles. At the middle of an edge with the point x and
   the tangent t the surface is perpendicular to n_e when C + h N lies in the plane through q_e,

       n_e = unit(mid - <mid, t> t),   q_e = 2 x - (the two control points facing the edge) / 2
       h = sum r_e c_e / max(sum c_e^2, 3/4),   r_e = <n_e, q_e - C>,   c_e = <n_e, N>

   and 3/4, a third of the sum over three edges at 30 degrees, keeps h bounded. */
NAGATA3_API n3_vec n3_patch_centre_arc(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca,
                                       const n3_vec n[3], const n3_vec mid[3])
{
    const n3_edge *e[3];
    n3_vec x[3], C, ne, qe, N = n3_unit(n3_add(n3_add(n[0], n[1]), n[2]));
    n3_real rc = 0, cc = 0;
    int i;
    e[0] = ab;
    e[1] = bc;
    e[2] = ca;
    for (i = 0; i < 3; i++) x[i] = e[i]->p[0];
    C = n3i_centre_cubic(x, n, n3_patch_centre(ab, bc, ca));
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n3_curve_jet middle = n3_edge_jet(e[i], (n3_real)1 / 2);
        n3_vec facing = n3_mul((n3_real)1 / 2, n3_add(e[j]->p[1], e[k]->p[2]));
        qe = n3_sub(n3_mul(2, middle.x), facing);
        ne = n3i_across(n3_unit(mid ? mid[i] : n3_add(n[i], n[j])), n3_unit(middle.dt));
        rc += n3_dot(ne, n3_sub(qe, C)) * n3_dot(ne, N);
        cc += n3_dot(ne, N) * n3_dot(ne, N);
    }
    return n3_add(C, n3_mul(rc / n3i_larger(cc, (n3_real)3 / 4), N));
}

NAGATA3_API n3_patch n3_patch_from_edges(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca,
                                         n3_vec centre)
{
    n3_patch r;
    r.p[0] = ab->p[0];                                                             /* (5.2.2) */
    r.p[1] = bc->p[0];                                                             /* (5.2.3) */
    r.p[2] = ca->p[0];                                                             /* (5.2.4) */
    r.p[3] = ab->p[1];                                                             /* (5.2.5) */
    r.p[4] = ab->p[2];
    r.p[5] = bc->p[1];                                                             /* (5.2.6) */
    r.p[6] = bc->p[2];
    r.p[7] = ca->p[1];                                                             /* (5.2.7) */
    r.p[8] = ca->p[2];
    r.p[9] = centre;
    return r;
}

NAGATA3_API n3_patch n3_patch_make(n3_vertex a, n3_vertex b, n3_vertex c, const n3_options *o)
{
    n3_edge ab = n3_edge_make(a, b, o), bc = n3_edge_make(b, c, o), ca = n3_edge_make(c, a, o);
    n3_vec n[3], centre;
    n[0] = a.n;
    n[1] = b.n;
    n[2] = c.n;
    centre = n3i_is_arc(o) ? n3_patch_centre_arc(&ab, &bc, &ca, n, NULL)
                           : n3_patch_centre(&ab, &bc, &ca);
    return n3_patch_from_edges(&ab, &bc, &ca, centre);
}

NAGATA3_API void n3_patch_edges(const n3_patch *p, n3_edge out[3])
{
    static const int side[3][4] = {{0, 3, 4, 1}, {1, 5, 6, 2}, {2, 7, 8, 0}};
    int i, k;
    for (i = 0; i < 3; i++)
        for (k = 0; k < 4; k++) out[i].p[k] = p->p[side[i][k]];
}

/* The rows of constant k = 3, 2, 1, 0, each a curve of degree 3 - k between the sides ab and ca,
   raised to a cubic. */
NAGATA3_API void n3_patch_bicubic(const n3_patch *p, n3_vec out[16])
{
    const n3_vec *q = p->p;
    n3_edge row[4];
    n3_segment s;
    int i, j;
    s.p[0] = q[4];
    s.p[1] = q[9];
    s.p[2] = q[7];
    row[0] = n3i_edge_straight(q[0], q[0]);
    row[1] = n3i_edge_straight(q[3], q[8]);
    row[2] = n3_segment_raise(&s);
    row[3] = n3i_edge_of(q[1], q[5], q[6], q[2]);
    for (i = 0; i < 4; i++)
        for (j = 0; j < 4; j++) out[4 * i + j] = row[i].p[j];
}

/* ---- Definitions: the evaluator ---- */

/* The side on which (u, v) lies exactly, as the edge that runs with t; false inside and outside. */
NAGATA3_API int n3i_on_side(const n3_patch *p, n3_real u, n3_real v, n3_edge *e, n3_real *t)
{
    n3_edge side[3];
    n3_real w = 1 - u - v;
    int ab = v >= 0 && v <= 0, bc = w >= 0 && w <= 0, ca = u >= 0 && u <= 0;
    if (!ab && !bc && !ca) return 0;
    n3_patch_edges(p, side);
    *e = ab ? side[0] : bc ? side[1] : n3_edge_reverse(&side[2]);
    *t = ab ? u : v;
    return 1;
}

NAGATA3_API n3_vec n3_patch_point(const n3_patch *p, n3_real u, n3_real v)
{
    const n3_vec *q = p->p;
    n3_real w = 1 - u - v, t;
    n3_vec corners, ab, bc, ca;
    n3_edge e;
    if (n3i_on_side(p, u, v, &e, &t)) return n3_edge_point(&e, t);
    corners = n3i_mix(w * w * w, q[0], u * u * u, q[1], v * v * v, q[2]);
    ab = n3_add(n3_mul(3 * u * w * w, q[3]), n3_mul(3 * u * u * w, q[4]));
    bc = n3_add(n3_mul(3 * u * u * v, q[5]), n3_mul(3 * u * v * v, q[6]));
    ca = n3_add(n3_mul(3 * v * v * w, q[7]), n3_mul(3 * v * w * w, q[8]));
    return n3_add(n3_add(corners, n3_mul(6 * u * v * w, q[9])),
                  n3_add(n3_add(ab, bc), ca));                                      /* (5.2.1) */
}

/* The derivatives, by two steps of de Casteljau on the net seen from p003, so that no digits are
   lost to where the patch lies: from ten points to the six r_ijk, and from these to three. */
NAGATA3_API n3_jet n3_patch_jet(const n3_patch *p, n3_real u, n3_real v)
{
    n3_real w = 1 - u - v;
    n3_vec q[10], r002, r200, r020, r101, r110, r011, pw, pu, pv;
    n3_jet j;
    int i;
    for (i = 0; i < 10; i++) q[i] = n3_sub(p->p[i], p->p[0]);
    r002 = n3i_mix(w, q[0], u, q[3], v, q[8]);
    r200 = n3i_mix(w, q[4], u, q[1], v, q[5]);
    r020 = n3i_mix(w, q[7], u, q[6], v, q[2]);
    r101 = n3i_mix(w, q[3], u, q[4], v, q[9]);
    r110 = n3i_mix(w, q[9], u, q[5], v, q[6]);
    r011 = n3i_mix(w, q[8], u, q[9], v, q[7]);
    pw = n3i_mix(w, r002, u, r101, v, r011);
    pu = n3i_mix(w, r101, u, r200, v, r110);
    pv = n3i_mix(w, r011, u, r110, v, r020);
    j.x = n3_patch_point(p, u, v);
    j.du = n3_mul(3, n3_sub(pu, pw));
    j.dv = n3_mul(3, n3_sub(pv, pw));
    j.duu = n3_mul(6, n3_add(n3_sub(r200, r101), n3_sub(r002, r101)));
    j.duv = n3_mul(6, n3_add(n3_sub(r110, r101), n3_sub(r002, r011)));
    j.dvv = n3_mul(6, n3_add(n3_sub(r020, r011), n3_sub(r002, r011)));
    return j;
}

/* unit(n), or zero when n is not clear of the rounding of vectors of this size. */
NAGATA3_API n3_vec n3i_clear(n3_vec n, n3_real size)
{
    return n3_len(n) <= N3_NOISE * size ? n3_v(0, 0, 0) : n3_unit(n);
}

/* The sum of the areas of the net's nine small triangles, which is that of its outline. */
NAGATA3_API n3_vec n3i_net_area(const n3_vec q[10])
{
    static const int loop[10] = {0, 3, 4, 1, 5, 6, 2, 7, 8, 0};
    n3_vec area = n3_v(0, 0, 0);
    int i;
    for (i = 0; i < 9; i++) area = n3_add(area, n3_cross(q[loop[i]], q[loop[i + 1]]));
    return area;
}

/* The patch with p003 in the origin and size 1, so that products neither overflow nor underflow. */
NAGATA3_API n3_patch n3i_patch_boxed(const n3_patch *p)
{
    n3_patch q = *p;
    n3_real size = 0;
    int i;
    for (i = 0; i < 10; i++) q.p[i] = n3_sub(p->p[i], p->p[0]);
    for (i = 0; i < 10; i++) size = n3i_larger(size, n3i_largest(q.p[i]));
    for (i = 0; i < 10; i++) q.p[i] = size > 0 ? n3i_over(q.p[i], size) : q.p[i];
    return q;
}

/* With D the derivative towards the centroid, du x dv becomes D du x dv + du x D dv where it
   vanishes itself, and D du x D dv where du and dv do. */
NAGATA3_API n3_vec n3_patch_normal(const n3_patch *p, n3_real u, n3_real v)
{
    n3_patch q = n3i_patch_boxed(p);
    n3_jet j = n3_patch_jet(&q, u, v);
    n3_real a = (n3_real)1 / 3 - u, b = (n3_real)1 / 3 - v, size = n3_len(j.du) + n3_len(j.dv);
    n3_vec Ddu, Ddv, n = n3i_clear(n3_cross(j.du, j.dv), size);
    if (!n3i_is_zero(n)) return n;
    Ddu = n3_add(n3_mul(a, j.duu), n3_mul(b, j.duv));
    Ddv = n3_add(n3_mul(a, j.duv), n3_mul(b, j.dvv));
    size += n3_len(Ddu) + n3_len(Ddv);
    n = n3i_clear(n3_add(n3_cross(Ddu, j.dv), n3_cross(j.du, Ddv)), size);
    if (n3i_is_zero(n)) n = n3i_clear(n3_cross(Ddu, Ddv), size);
    if (n3i_is_zero(n)) n = n3i_clear(n3_cross(q.p[1], q.p[2]), 1);
    if (n3i_is_zero(n)) n = n3i_clear(n3i_net_area(q.p), 1);
    return n;
}

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT. Copyright 2026 the nagata3 authors; the text is in LICENSE. */
