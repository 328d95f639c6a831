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
 * Any C99, C++98 or CUDA compiler takes it: cc examples/01_point.c -I. -lm
 *
 * CONTENTS
 *
 *     Part I, the paper     vectors, segment, curve plane, edge, patch, evaluator
 *     Part II, the mesh     what a mesh of triangles needs on top of single patches; and what is
 *                           asked of one: box, parts, curvature, nearest point, rays, sums
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
 *        and (5.1.14), so that Nagata's curve is kept where it lies in Pi, bends one way and makes
 *        angles between atan tan_lo and 60 degrees with its chord.
 *     5  p21 = x0 + d_s t_s and p12 = x1 - d_e t_e.
 *
 * The three edges leave p111, the centre: half the sum of the three ruled surfaces between pairs
 * of edges less the flat triangle, (6.1.10). It is the centre of a PN triangle [3] as well.
 *
 * Nagata's own patch, a quadratic one, is here too: its net is p002 p200 p020 | p101 p110 p011.
 *
 * THE MESH
 *
 * A mesh is a view of the caller's arrays, and so is all memory. The calls, in order:
 *
 *     n3_mesh_topology    which triangles share an edge
 *     n3_mesh_normals     normals where there are none, parted at creases
 *     n3_mesh_net         the control points of all patches, each edge built once
 *     n3_mesh_patches     the patches; n3_mesh_refine: a finer mesh on them
 *     n3_lattice_points   points on each patch; n3_patch_points: where they are wanted
 *     n3_mesh_cut         how fine it must be, edge by edge, to be within a distance
 *     n3_mesh_field       nodal values, carried to the finer mesh
 *     n3_mesh_report      what was found and what was done
 *
 * Where the triangles at an edge bring different normals n_i to one of its ends, the surface has
 * several tangent planes there and the edge has to lie in all of them. With s the largest sine
 * between two of the normals and c the direction of the sum of their n_i x n_j, turned along the
 * chord, the edge leaves that end
 *
 *     s <= 1/50           as with one normal, their unit sum, all turned to one side of the plane
 *     s >= 1/10           along c, the crease
 *     between             in between, and so where c is more than 75 degrees off the chord
 *
 * CONVENTIONS
 *
 * Normals are unit to rounding, points are in any unit. Angles appear as their tangents. Nothing
 * is allocated, nothing is kept, and nothing depends on anything but the arguments. Structures up
 * to a vertex go by value, larger ones by pointer; results are returned. Edges run round the
 * triangle, ab, bc, ca, so that ca is the paper's third edge (5.2.7) reversed. In bounds, eps is
 * N3_EPS, the spacing of n3_real at 1, and an ulp is one of the largest coordinate involved.
 *
 * An edge's curve is the same, bit for bit, from either end: neighbours share it exactly. That
 * wants IEEE arithmetic, so neither -ffast-math nor x87; and as C promises nothing about
 * contraction, -ffp-contract=off makes sure.
 *
 * DEGENERATE INPUT
 *
 *     parallel normals            segment: the chord; edges: as always, no case of their own
 *     opposite normals            segment: the chord; the arc rule uses the paper's
 *     one normal along the chord  paper: the plane comes from the other end; this end counts as
 *                                 90 degrees and the edge becomes a C; arc: its formula
 *     both along the chord        straight, control points at thirds
 *     chord along n0 + n1         arc: both handles vanish; straight
 *     one normal zero             the other end's, made orthogonal to the chord; if that
 *                                 vanishes, straight; segment: the chord
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
 *     n0 = +-e        <t, e> = 0, a tangent at 90 degrees to the chord: along it, or against it
 *     n1 = -n0        arc rule: every direction bisects
 *     n1 = +-n0       segment: c has a pole, and is zero in it
 *     mid along t     arc rule, centre: a wanted normal along the tangent in the edge's middle
 *
 * and where a row of the table above begins to apply.
 *
 * CONFIGURATION, before the header is included
 *
 *     NAGATA3_FLOAT    n3_real is float. Both precisions can live in one program, in different
 *                      translation units.
 *     NAGATA3_SIMD     0 keeps the calls on many patches to plain C. Else they use the vectors of
 *                      GCC and Clang, 16 bytes or with AVX 32, where the machine has any; the
 *                      results have the same bits.
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
#if !defined NAGATA3_SIMD && defined __has_builtin && !defined __CUDACC__
#if __has_builtin(__builtin_shufflevector) && (defined __SSE2__ || defined __aarch64__)
#define NAGATA3_SIMD 1
#endif
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
    N3_RULE_PAPER, /* the paper's cubic edge and centre; normals may look to either side */
    N3_RULE_ARC,   /* ours: circles to sixth order; wants normals that all look outwards */
    N3_RULE_FIT    /* ours: arc, and normals across edges fitted over the neighbours of a mesh */
};

/* Where a function takes options, NULL means the defaults, and so does a field that is not > 0. */
typedef struct n3_options {
    int rule;      /* N3_RULE_PAPER; an unknown value means the same */
    n3_real tan_lo; /* 1/10: smallest tangent of the angle at an end, epsilon of (5.1.11) */
    n3_real tan_hi; /* 10: largest, Omega of (5.1.12); one below tan_lo counts as tan_lo */
} n3_options;

typedef char n3i_assert_packed[sizeof(n3_vec) == 3 * sizeof(n3_real) ? 1 : -1];

/* ---- Tolerances: all of them, none is a length ---- */

/* The spacing of n3_real at 1. */
#define N3_EPS (N3I_PICK((n3_real)1 / 67108864 / 67108864, (n3_real)1 / 8388608))

/* Normals whose sine is at most this count as parallel in the segment: they differ in their last
   two bits, and the direction and the length of c would be made of these. */
#define N3_PARALLEL (N3I_PICK((n3_real)1 / 33554432 / 33554432, (n3_real)1 / 4194304))

/* A normal whose sine with the chord is at most this lies along it: the direction of e x n then
   has a quarter (float: a third) of its digits left. */
#define N3_ALONG (N3I_PICK((n3_real)1 / 1048576 / 1048576, (n3_real)1 / 65536))

/* Normals whose sum is at most this long are opposite: the bisector has lost half its digits. */
#define N3_OPPOSITE (N3I_PICK((n3_real)1 / 67108864, (n3_real)1 / 4096))

/* A normal du x dv shorter than this times |du| + |dv| is rounding, the patch being of size 1: the
   error of du and dv is below 28 eps in the triangle. */
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
   nearby: with a chord tilted by A and the normals delta apart, |c| is 2 L sin(A) / delta, and
   tan(A) when delta is a turn about the chord. The same from either end, bit for bit.
   54 flops, 3 divisions. */
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
   4 square roots, 12 divisions. */
NAGATA3_API n3_vec n3_curve_plane(n3_vertex a, n3_vertex b);

/* The cubic edge from a to b: (5.1.13) (5.1.14), or the arc rule.
   Exactly n3_edge_reverse of the edge from b to a. Tangent to both tangent planes to 8 ulp, but at
   an end that counts as along the chord, whose tangent is square to the chord. No handle is longer
   than 4/3 of the chord (arc: 2/3, to rounding), whatever the normals.
   220 flops, 15 divisions, 5 square roots; arc: 130, 10, 2. */
NAGATA3_API n3_edge n3_edge_make(n3_vertex a, n3_vertex b, const n3_options *o);

/* Point of the curve at t, any real; in [0, 1] it runs from p[0] to p[3]: (5.1.1).
   n3_edge_point(e, t) and n3_edge_point(reverse of e, 1 - t) are the same bits where
   1 - (1 - t) == t, and t = 0 and t = 1 give the ends exactly. 32 flops. */
NAGATA3_API n3_vec n3_edge_point(const n3_edge *e, n3_real t);

/* Point, first and second derivative at t. The derivatives are made from differences of control
   points, so that their error is relative to the size of the edge, not to where it lies; they are
   not bit for bit the same from the other end. 82 flops. */
NAGATA3_API n3_curve_jet n3_edge_jet(const n3_edge *e, n3_real t);

/* The same curve run the other way. */
NAGATA3_API n3_edge n3_edge_reverse(const n3_edge *e);

/* The parts of the curve before and after t (de Casteljau); out[0].p[3] is out[1].p[0]. Not bit for
   bit the same from the other end. */
NAGATA3_API void n3_edge_split(const n3_edge *e, n3_real t, n3_edge out[2]);

/* ---- The patch ---- */

/* Centre p111 from the edges, which run round the triangle: (6.1.10). */
NAGATA3_API n3_vec n3_patch_centre(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca);

/* Ours, for edges of the arc rule: the centre with cubic precision along the surface, and with
   neighbours that nearly agree on the normal in the middle of the edge that they share. n: unit
   normals at a, b, c. mid: a wanted normal at the middle of ab, bc, ca, of any length; NULL means
   the sum of the edge's end normals; one that vanishes, as does that of an edge without a length,
   contributes nothing. A zero corner normal is taken as it is. 540 flops. */
NAGATA3_API n3_vec n3_patch_centre_arc(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca,
                                       const n3_vec n[3], const n3_vec mid[3]);

/* The patch that has these edges, round the triangle, and this centre: (5.2.2)-(5.2.7). */
NAGATA3_API n3_patch n3_patch_from_edges(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca,
                                         n3_vec centre);

/* The patch over the triangle a, b, c: three edges and a centre by the rule. A patch alone has no
   neighbours to fit to: N3_RULE_FIT is the arc rule here. Corners given in another order give the
   same edges, bit for bit, and the same centre to 4 ulp (arc: 8). 700 flops, 48 divisions, 15
   square roots. */
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
   Outside the triangle the polynomial goes on. 88 flops. */
NAGATA3_API n3_vec n3_patch_point(const n3_patch *p, n3_real u, n3_real v);

/* Point, first and second derivatives; errors as for n3_edge_jet. 300 flops. */
NAGATA3_API n3_jet n3_patch_jet(const n3_patch *p, n3_real u, n3_real v);

/* Unit normal of the surface, along du x dv: it looks to the side from which a, b, c run
   counterclockwise. Where du x dv vanishes, as at a collapsed side, the limit on the way from the
   centroid; failing that the triangle's normal, then the normal of the net, then zero. Outside the
   triangle rounding may pass for a normal. 380 flops, 33 divisions, 4 square roots. */
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

/* Correctly rounded in both precisions: 53 digits are more than 2 * 24 + 2, so that rounding the
   root of a float twice changes nothing. */
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

/* Of such squares of a length none overflowed, and what underflowed in them, or does when they are
   multiplied by N3_ALONG^2, is rounding. The power, of two, makes any other square such a one. */
#define N3I_LEAST_SQUARE (N3I_PICK((n3_real)1e-260, (n3_real)1e-24))
#define N3I_MOST_SQUARE  (N3I_PICK((n3_real)1e+300, (n3_real)1e+37))
#define N3I_POWER        (N3I_PICK((n3_real)4.562440617622195e192, (n3_real)1.2676506002282294e30))

/* a / *scale, *scale a power of two, 1 unless the square of a is too small or too large. */
NAGATA3_API n3_vec n3i_fair(n3_vec a, n3_real *scale)
{
    n3_real aa = n3_dot(a, a);
    int is_small = n3i_largest(a) < 1;
    *scale = 1;
    if (aa > N3I_LEAST_SQUARE && aa < N3I_MOST_SQUARE) return a;
    *scale = is_small ? 1 / N3I_POWER : N3I_POWER;
    return n3_mul(is_small ? N3I_POWER : 1 / N3I_POWER, a);
}

/* n3_unit and n3_len of one vector. */
NAGATA3_API n3_vec n3i_direction(n3_vec a, n3_real *length)
{
    n3_real scale, r;
    a = n3i_fair(a, &scale);
    r = n3i_sqrt(n3_dot(a, a));
    *length = scale * r;
    return r > 0 ? n3i_over(a, r) : n3_mul(r, a); /* 0, or NaN */
}

NAGATA3_API n3_real n3_len(n3_vec a)
{
    n3_real length;
    n3i_direction(a, &length);
    return length;
}

NAGATA3_API n3_vec n3_unit(n3_vec a)
{
    n3_real length;
    return n3i_direction(a, &length);
}

/* True if n is zero or lies along d. */
NAGATA3_API int n3i_is_along(n3_vec d, n3_vec n)
{
    n3_vec m = n3_cross(d, n);
    return n3_dot(m, m) <= N3_ALONG * N3_ALONG * n3_dot(d, d);
}

/* d x n, unit: the normal of the plane through the chord d perpendicular to the tangent plane of n.
   Zero when n is zero or lies along d. */
NAGATA3_API n3_vec n3i_upright(n3_vec d, n3_vec n)
{
    return n3i_is_along(d, n) ? n3_v(0, 0, 0) : n3_unit(n3_cross(d, n));
}

/* The part of n across the unit vector e, unit; zero when n is zero or lies along e. */
NAGATA3_API n3_vec n3i_across(n3_vec n, n3_vec e) { return n3_cross(n3i_upright(e, n), e); }

/* -1, 0 or 1 as a comes before, equals or comes after b, by x, then y, then z. */
NAGATA3_API int n3i_order(n3_vec a, n3_vec b)
{
    if (a.x < b.x || a.x > b.x) return a.x < b.x ? -1 : 1;
    if (a.y < b.y || a.y > b.y) return a.y < b.y ? -1 : 1;
    return a.z < b.z ? -1 : a.z > b.z;
}

/* Puts the ends of an edge in an order that does not depend on how they were given: what is then
   computed is the same from either end. True if they were swapped. Ends in one place may stand
   either way: all control points are there. */
NAGATA3_API int n3i_sort_ends(n3_vertex *a, n3_vertex *b)
{
    n3_vertex t = *a;
    if (n3i_order(a->x, b->x) <= 0) return 0;
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

/* Pi for the chord d and the normals at its ends. The bisector of the smaller angle of two planes is
   the one whose normal is the sum of theirs when these make an acute angle. */
NAGATA3_API n3_vec n3i_plane(n3_vec d, n3_vec n0, n3_vec n1)
{
    n3_vec m0 = n3i_upright(d, n0), m1 = n3i_upright(d, n1);
    return n3_unit(n3_dot(m0, m1) >= 0 ? n3_add(m0, m1) : n3_sub(m0, m1));
}

NAGATA3_API n3_vec n3_curve_plane(n3_vertex a, n3_vertex b)
{
    return n3i_plane(n3_unit(n3_sub(b.x, a.x)), a.n, b.n);
}

/* An end of an edge: the tangent of its angle to the chord, clamped, and its handle but for the
   ratio of the tangents of both. */
typedef struct n3i_end { n3_vec reach; n3_real tan; } n3i_end;

/* Where Pi, spanned by the chord d and by b, across it and as long, meets the tangent plane of the
   normal n: <n, d - s b> = 0, turned along the chord, as the paper does it by (4.2.1) and the
   corrected points of (5.1.4a) and (5.1.5a), here without a point of intersection. s is the tangent
   of the angle to the chord, d - s b is L / cos long, and so a third of it twice is what (5.1.13)
   says up to 60 degrees; beyond it is no longer stretched by 1/cos. A normal along the chord gives
   tan_hi, and no direction of its own. */
NAGATA3_API n3i_end n3i_end_make(n3_vec n, n3_vec d, n3_vec b, const n3_options *o)
{
    n3i_end t;
    n3_real s, third = (n3_real)1 / 3, stretch;
    t.reach = n3_v(0, 0, 0);
    t.tan = o->tan_hi;
    if (n3i_is_along(d, n)) return t;
    s = n3_dot(n, d) / n3_dot(n, b);
    if (n3i_abs(s) < t.tan) t.tan = n3i_abs(s);                                    /* (5.1.12) */
    t.tan = n3i_larger(t.tan, o->tan_lo);                                          /* (5.1.11) */
    stretch = s * s > 3 ? 4 * third / n3i_sqrt(1 + s * s) : 2 * third;
    t.reach = n3_mul(stretch, n3_sub(d, n3_mul(s, b)));
    return t;
}

/* The handle, by (5.1.13) at the start and (5.1.14) at the end, in the direction of its tangent: from
   the clamped angles here and at the other end. */
NAGATA3_API n3_vec n3i_handle(n3i_end here, n3i_end other)
{
    return n3_mul(other.tan / (here.tan + other.tan), here.reach);
}

NAGATA3_API n3_edge n3i_edge_straight(n3_vec x0, n3_vec x1)
{
    n3_vec third = n3i_over(n3_sub(x1, x0), 3);
    return n3i_edge_of(x0, n3_add(x0, third), n3_sub(x1, third), x1);
}

/* An end whose normal lies along the chord starts at 90 degrees on the side from which the other end
   comes down. */
NAGATA3_API n3_edge n3i_edge_paper(n3_vertex v0, n3_vertex v1, const n3_options *o)
{
    n3_real scale;
    n3_vec d = n3i_fair(n3_sub(v1.x, v0.x), &scale), b = n3_cross(n3i_plane(d, v0.n, v1.n), d);
    n3i_end s = n3i_end_make(v0.n, d, b, o), t = n3i_end_make(v1.n, d, b, o);
    n3_vec ds, de, up = n3_mul((n3_real)4 / 3, b);
    if (n3i_is_zero(s.reach)) s.reach = n3_dot(t.reach, b) > 0 ? n3i_neg(up) : up;
    if (n3i_is_zero(t.reach)) t.reach = n3_dot(s.reach, b) < 0 ? up : n3i_neg(up);
    ds = n3_mul(scale, n3i_handle(s, t));                                          /* (5.1.13) */
    de = n3_mul(scale, n3i_handle(t, s));                                          /* (5.1.14) */
    return n3i_edge_of(v0.x, n3_add(v0.x, ds), n3_sub(v1.x, de), v1.x);
}

/* Ours. m = unit(n0 + n1) bisects the normals, which make the angle 2 a; cos = cos a. Of the chord
   d the part along m is dropped; the rest, split into what bends, g, and what does not, is turned
   into each tangent plane, and the bending part is lengthened by 1/cos^2(a/2): with k = 1/(1 + cos)

       q   = d - <d, m> m - (g k^2 / 4) (n1 - n0),      g = <d, n1 - n0>
       p21 = x0 + (q + g k m) / 3,      p12 = x1 - (q - g k m) / 3

   On a circle both handles are (2 L / 3) / (1 + cos a), its approximation of sixth order. Normals
   are unit to rounding only, and what that leaves of the handles along them is taken off. */
NAGATA3_API n3_vec n3i_off(n3_vec a, n3_vec n) { return n3_sub(a, n3_mul(n3_dot(a, n), n)); }

NAGATA3_API n3_edge n3i_edge_arc(n3_vertex v0, n3_vertex v1)
{
    n3_vec d = n3_sub(v1.x, v0.x), turn = n3_sub(v1.n, v0.n), sum = n3_add(v0.n, v1.n);
    n3_real length, g = n3_dot(d, turn), k;
    n3_vec m = n3i_direction(sum, &length), q, hs, he;
    k = 1 / (1 + length / 2);
    q = n3_sub(n3_sub(d, n3_mul(n3_dot(d, m), m)), n3_mul(g * k * k / 4, turn));
    m = n3_mul(g * k, m);
    hs = n3i_off(n3i_over(n3_add(q, m), 3), v0.n);
    he = n3i_off(n3i_over(n3_sub(q, m), 3), v1.n);
    return n3i_edge_of(v0.x, n3_add(v0.x, hs), n3_sub(v1.x, he), v1.x);
}

/* The paper leaves its two constants open. Over nine surfaces and four meshes of each, `make sweep`
   finds the largest error with tan_lo = 1e-6 to be 1.1 to 1.9 times that with 1/10 and that of the
   normals 1.4 to 2.5 times: a handle collapses where one end is flat and the other is not. The best
   value falls with the mesh from 1/3 to 1/30; 1/10 is within 30 percent of it on each. tan_hi
   matters below 3 only. The price: on fine meshes of a cylinder over an ellipse, where parabolas
   are right, the clamp costs a factor of 17. */
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
    n3_real scale;
    n3_vec d = n3i_fair(n3_sub(b.x, a.x), &scale);
    if (n3i_is_zero(a.n)) a.n = n3i_across(b.n, n3_unit(d));
    else if (n3i_is_zero(b.n)) b.n = n3i_across(a.n, n3_unit(d));
    if (n3i_is_along(d, a.n) && n3i_is_along(d, b.n)) return n3i_edge_straight(a.x, b.x);
    if (n3i_is_arc(&o) && !(n3_len(n3_add(a.n, b.n)) <= N3_OPPOSITE)) return n3i_edge_arc(a, b);
    return n3i_edge_paper(a, b, &o);
}

NAGATA3_API n3_edge n3_edge_make(n3_vertex a, n3_vertex b, const n3_options *o)
{
    int swapped = n3i_sort_ends(&a, &b);
    n3_edge e = n3i_edge_sorted(a, b, o);
    return swapped ? n3_edge_reverse(&e) : e;
}

/* -1, 0 or 1 as the curve runs from its canonical end, is the same from both, or runs back. */
NAGATA3_API int n3i_edge_order(const n3_edge *e)
{
    int order = n3i_order(e->p[0], e->p[3]);
    return order ? order : n3i_order(e->p[1], e->p[2]);
}

/* Evaluated from the canonical end, or, where there is none, from the nearer one: k ^ i counts the
   control points from there. */
NAGATA3_API n3_vec n3_edge_point(const n3_edge *e, n3_real t)
{
    const n3_vec *p = e->p;
    int order = n3i_edge_order(e), k = (order ? order > 0 : t > 1 - t) ? 3 : 0;
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

/* Of the patch whose points are p[k[0]], p[k[1]] and so on. */
NAGATA3_API n3_vec n3i_centre(const n3_vec *p, const int k[9])
{
    n3_vec p201_p021 = n3_add(p[k[4]], p[k[7]]), p012_p210 = n3_add(p[k[8]], p[k[5]]);
    n3_vec p102_p120 = n3_add(p[k[3]], p[k[6]]);
    n3_vec corners = n3_add(n3_add(p[k[0]], p[k[1]]), p[k[2]]);
    return n3_sub(n3i_over(n3_add(n3_add(p201_p021, p012_p210), p102_p120), 4),
                  n3i_over(corners, 6));                                           /* (6.1.10) */
}

NAGATA3_API n3_vec n3_patch_centre(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca)
{
    static const int order[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    n3_patch p = n3_patch_from_edges(ab, bc, ca, ab->p[0]);
    return n3i_centre(p.p, order);
}

/* (6.1.10) has quadratic precision only. In centred coordinates s an arc's own cubic is
   -A(s, s) V(s) / 8, A the second fundamental form and V what turns a vector into the change of the
   normal: the third difference of its control points is g k^2 / 2 (n1 - n0), g = <d, n1 - n0>. Of a
   cubic form with the polar form B (6.1.10) finds -5/4 B(a, b, c) in place of B(a, b, c); with
   x_i, v_i the corners and normals less their means, A_ij = (<x_i, v_j> + <x_j, v_i>) / 2 and
   B(a, b, c) = -(A_ab v_c + A_bc v_a + A_ca v_b) / 24

       C = (6.1.10) - K (A_ab v_c + A_bc v_a + A_ca v_b),   K = (12 sum k^2 - 3) / 64

   K is 9/4 / 24 = 3/32 where the normals hardly turn, k = 1/2 on every edge, and 4 k^2 times as
   much over an edge and a generator of a cylinder, where the patch then is as exact as its edges.
   On spheres and cylinders this makes the patch of sixth order, like its edges. */
NAGATA3_API n3_vec n3i_centre_cubic(const n3_vec x[3], const n3_vec n[3], n3_vec centre)
{
    n3_vec xm = n3i_over(n3_add(n3_add(x[0], x[1]), x[2]), 3);
    n3_vec nm = n3i_over(n3_add(n3_add(n[0], n[1]), n[2]), 3);
    n3_real K = -(n3_real)3 / 64;
    int i;
    for (i = 0; i < 3; i++) {
        n3_real k = 1 / (1 + n3_len(n3_add(n[i], n[(i + 1) % 3])) / 2);
        K += 3 * k * k / 16;
    }
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n3_real A = n3_dot(n3_sub(x[i], xm), n3_sub(n[j], nm)) +
                    n3_dot(n3_sub(x[j], xm), n3_sub(n[i], nm));
        centre = n3_sub(centre, n3_mul(K * A / 2, n3_sub(n[k], nm)));
    }
    return centre;
}

/* Then C moves along N, the direction of n_a + n_b + n_c, by least squares over the edges, to where
   the surface has the wanted normals in their middles. At the middle of an edge with the point x
   and the tangent t it is perpendicular to n_e when C + h N lies in the plane through q_e,

       n_e = unit(mid - <mid, t> t),   q_e = 2 x - (the two control points facing the edge) / 2
       h = sum r_e c_e / max(sum c_e^2, 3/4),   r_e = <n_e, q_e - C>,   c_e = <n_e, N>

   and 3/4, a third of the sum with 30 degrees between n_e and N on all edges, keeps h bounded.
   Where the corner normals cancel N is made of rounding: so below a length of 1/4 of their sum the
   move fades out. */
NAGATA3_API n3_vec n3_patch_centre_arc(const n3_edge *ab, const n3_edge *bc, const n3_edge *ca,
                                       const n3_vec n[3], const n3_vec mid[3])
{
    const n3_edge *e[3];
    n3_vec x[3], C, ne, qe, N = n3_add(n3_add(n[0], n[1]), n[2]);
    n3_real rc = 0, cc = 0, low = (n3_real)3 / 4 * n3i_larger(n3_dot(N, N), (n3_real)1 / 16);
    int i;
    e[0] = ab;
    e[1] = bc;
    e[2] = ca;
    for (i = 0; i < 3; i++) x[i] = e[i]->p[0];
    C = n3i_centre_cubic(x, n, n3_patch_centre(ab, bc, ca));
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        const n3_vec *p = e[i]->p;
        n3_vec t = n3_unit(n3_add(n3_sub(p[3], p[0]), n3_sub(p[2], p[1])));
        n3_vec facing = n3_mul((n3_real)1 / 2, n3_add(e[j]->p[1], e[k]->p[2]));
        qe = n3_sub(n3_mul(2, n3_edge_point(e[i], (n3_real)1 / 2)), facing);
        ne = n3i_across(n3_unit(mid ? mid[i] : n3_add(n[i], n[j])), t);
        rc += n3_dot(ne, n3_sub(qe, C)) * n3_dot(ne, N);
        cc += n3_dot(ne, N) * n3_dot(ne, N);
    }
    return n3_add(C, n3_mul(rc / n3i_larger(cc, low), N));
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
    int ab = v >= 0 && v <= 0, bc = w >= 0 && w <= 0, ca = u >= 0 && u <= 0; /* == 0 */
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

/* Along the way to the centroid, s = 0 to 1, du and dv are quadratics in s and du x dv is a
   quartic; its first coefficient that is not rounding has the direction of the limit. */
NAGATA3_API n3_vec n3i_normal_limit(const n3_patch *q, n3_real u, n3_real v)
{
    n3_real third = (n3_real)1 / 3, a = third - u, b = third - v, size = 0;
    n3_jet j = n3_patch_jet(q, u, v), c = n3_patch_jet(q, third, third);
    n3_vec du[3], dv[3], n = n3_v(0, 0, 0);
    int i, k;
    du[0] = j.du;
    dv[0] = j.dv;
    du[1] = n3_add(n3_mul(a, j.duu), n3_mul(b, j.duv));
    dv[1] = n3_add(n3_mul(a, j.duv), n3_mul(b, j.dvv));
    du[2] = n3_sub(n3_sub(c.du, du[0]), du[1]);
    dv[2] = n3_sub(n3_sub(c.dv, dv[0]), dv[1]);
    for (i = 0; i < 3; i++) size += n3_len(du[i]) + n3_len(dv[i]);
    for (k = 1; k < 5 && n3i_is_zero(n); k++) {
        for (i = k < 2 ? 0 : k - 2; i <= k && i < 3; i++)
            n = n3_add(n, n3_cross(du[i], dv[k - i]));
        n = n3i_clear(n, size);
    }
    return n;
}

/* The triangle's normal has the rounding of q alone, below 8 eps. */
NAGATA3_API n3_vec n3_patch_normal(const n3_patch *p, n3_real u, n3_real v)
{
    n3_patch q = n3i_patch_boxed(p);
    n3_jet j = n3_patch_jet(&q, u, v);
    n3_vec n = n3i_clear(n3_cross(j.du, j.dv), n3_len(j.du) + n3_len(j.dv));
    if (n3i_is_zero(n)) n = n3i_normal_limit(&q, u, v);
    if (n3i_is_zero(n)) n = n3i_clear(n3_cross(q.p[1], q.p[2]), (n3_real)1 / 4);
    if (n3i_is_zero(n)) n = n3i_clear(n3i_net_area(q.p), 1);
    return n;
}

/* ==== Part II: what a mesh needs ===============================================================

   ---- The mesh ---- */

/* A mesh of triangles: a flat, borrowed view; nothing is copied or owned. A stride is the distance
   in bytes from one element to the next, any number; 0 means packed. */
typedef struct n3_mesh {
    int points, triangles, normals;                  /* counts */
    const n3_real *point;    size_t point_stride;    /* xyz each */
    const int     *triangle; size_t triangle_stride; /* three points each */
    const n3_real *normal;   size_t normal_stride;   /* xyz each, of any length; NULL: no normals */
    const int     *corner;   size_t corner_stride;   /* three normals for each triangle, negative:
                                                        none; NULL: normal i belongs to point i */
} n3_mesh;

/* What a call answers that can fail. Nothing is written before the input is known to be sound.
   Such a call takes a pointer item, which may be NULL, to where the index of what is to blame
   goes; -1 where no single thing is. It is left alone when all is well. */
typedef enum n3_status {
    N3_OK,
    N3_NULL_POINTER, /* a pointer that must not be NULL is */
    N3_BAD_COUNT,    /* a count is negative, does not fit its partner, or leads beyond int */
    N3_BAD_TRIANGLE, /* item: a triangle that names a point out of range */
    N3_BAD_CORNER,   /* item: a triangle that names a normal out of range */
    N3_BAD_POINT,    /* item: a point that is not finite */
    N3_BAD_NORMAL,   /* item: a normal that is not finite */
    N3_BAD_WORKSPACE /* less workspace than the query said */
} n3_status;

/* The status in words, never NULL. */
NAGATA3_API const char *n3_status_text(n3_status status);

/* ---- Topology: which triangles share an edge ---- */

/* Side 3 f + i of triangle f runs from its corner i to the next. Sides between the same two points
   make an edge. A triangle that names a point twice is collapsed; its side from the point to
   itself has no edge. Edges are numbered in the order of their first side, and run from the lower
   to the higher point. The arrays lie in the workspace. */
typedef struct n3_topology {
    int points, triangles; /* those of the mesh */
    int edges;
    int collapsed;         /* triangles */
    int unused;            /* points in no triangle */
    const int *edge;       /* [3 triangles] the edge of a side, -1: none */
    const int *first;      /* [edges + 1] the sides of edge e, ascending, are */
    const int *side;       /* side[first[e]] up to but not with side[first[e + 1]] */
} n3_topology;

/* The bytes of workspace that n3_mesh_topology needs, about 36 for each triangle; 0 when the
   counts are out of range. */
NAGATA3_API size_t n3_mesh_workspace(const n3_mesh *m);

/* Fills the topology, which is empty after an error. work is aligned for int; it must live as long
   as the topology is used, which goes for every mesh with the same triangles, wherever its points
   are. Normals are not looked at. Linear: three counting passes. */
NAGATA3_API n3_status n3_mesh_topology(const n3_mesh *m, void *work, size_t size,
                                       n3_topology *topology, int *item);

/* The points of an edge, the lower one first. */
NAGATA3_API void n3_mesh_edge_ends(const n3_mesh *m, const n3_topology *t, int edge, int end[2]);

/* ---- Normals ---- */

/* A unit normal for every corner. Given ones are made unit and keep their index. Where a corner
   has none, or zero, the normal is inferred, one for each fan: the triangles round a point that
   hang together over edges that are no creases. A crease is an edge with a marked side, with other
   than two triangles, or with two that disagree about which side is outside; or where normals
   given to both of them at an end differ; or, if none are, with a cosine of the angle between the
   triangles below cos_crease (-1: none of these).
   The inferred normal is Max's sum over the fan, e0 and e1 the sides that meet in the corner,

       n = sum (e0 x e1) / (|e0|^2 |e1|^2)

   exact on a closed fan inscribed in a sphere; failing that, where the sum cancels, the normal of
   the largest triangle; zero where none has an area.
   mark: [3 triangles] by side, not 0: a crease; may be NULL. normal: room for m->normals +
   3 triangles; the given come first. corner: [3 triangles], indices into normal. normals: their
   number. None of them may be an array of m. n log n at worst in the triangles round one point. */
NAGATA3_API n3_status n3_mesh_normals(const n3_mesh *m, const n3_topology *t, n3_real cos_crease,
                                      const unsigned char *mark, n3_vec *normal, int *corner,
                                      int *normals, int *item);

/* ---- The net: all patches, their edges shared ---- */

/* What the construction met with and did at an edge. */
enum {
    N3_EDGE_STRAIGHT = 1,        /* all control points are on the chord */
    N3_EDGE_S_SHAPED = 2,        /* leaves the chord on one side and comes back from the other, by
                                    more than 1.1 degrees */
    N3_EDGE_CLAMPED = 4,         /* paper: an angle was clamped, (5.1.11) (5.1.12) */
    N3_EDGE_BRANCH_60 = 8,       /* paper: an angle was above 60 degrees, (5.1.13) (5.1.14) */
    N3_EDGE_TURNED = 16,         /* paper: seen along the chord, the ends' normals are more than 90
                                    degrees apart; a tangent was turned round to run along it */
    N3_EDGE_CREASE = 32,         /* the faces bring different normals to both ends */
    N3_EDGE_HALF_CREASE = 64,    /* to one end */
    N3_EDGE_BORDER = 128,        /* one triangle, not counting collapsed ones here and below */
    N3_EDGE_NON_MANIFOLD = 256,  /* three or more */
    N3_EDGE_FLIPPED = 512,       /* two, that disagree about which side is outside */
    N3_EDGE_DEGENERATE = 1024    /* its ends are at the same place */
};

/* Ours, for N3_RULE_FIT: a normal to want at the middle of the edge a, b of the triangles abc and
   bad, not of unit length. The sum of the ends' normals misses the term T(ab, ab, y) / 8 of the
   slope across, T the third derivative of the surface. Each of the six chords d between the points
   tells one value of it, T(d, d, d) = -6 <d, n_i + n_j>; T is fitted to them.
   For surfaces whose curvature does not jump: at the edge of a plane and a fillet the six chords
   contradict each other, and the sum of the ends' normals is better.
   The same, bit for bit, as for (b, a, d, c). 500 flops. */
NAGATA3_API n3_vec n3_edge_mid_normal(n3_vertex a, n3_vertex b, n3_vertex c, n3_vertex d);

/* The number of control points of the net: points + 2 edges + triangles; 0 beyond int. */
NAGATA3_API int n3_mesh_nodes(const n3_mesh *m, const n3_topology *t);

/* The control points of all patches, by the rule of the options. First the points; then two for
   each edge, the one next to its lower point first; then the centre of each triangle.
   An edge is built once, from the normals of all its triangles, so that these cannot part: where
   they agree it is n3_edge_make, bit for bit; where they differ by more than 1.1 degrees the edge
   turns into both tangent planes, and above 5.7 degrees it lies in both. It does not depend on the
   order of the triangles or of their corners. The centre by N3_RULE_FIT takes n3_edge_mid_normal
   at edges with two triangles that agree. Corners without a normal leave the edge to the others;
   in a mesh without normals every edge is straight.
   net: [n3_mesh_nodes]. flags: [edges] of N3_EDGE_ bits, may be NULL. Linear. */
NAGATA3_API n3_status n3_mesh_net(const n3_mesh *m, const n3_topology *t, const n3_options *o,
                                  n3_vec *net, unsigned *flags, int *item);

/* Its parts, for callers that share the work out: the control points of the edges and the centres
   of the triangles first up to but not with last, into their places in net, of which a centre
   reads the edges and corners. Nothing is checked; n3_mesh_net says what is. */
NAGATA3_API void n3_mesh_edges(const n3_mesh *m, const n3_topology *t, const n3_options *o,
                               int first, int last, n3_vec *net, unsigned *flags);
NAGATA3_API void n3_mesh_centres(const n3_mesh *m, const n3_topology *t, const n3_options *o,
                                 int first, int last, n3_vec *net);

/* The nodes of a triangle's patch, in the order of n3_patch.p. A side without an edge repeats its
   point. */
NAGATA3_API void n3_mesh_patch_nodes(const n3_mesh *m, const n3_topology *t, int triangle,
                                     int node[10]);

/* The patches of the triangles first up to but not with last, 0 <= first <= last <= triangles, into
   out[0] and on. */
NAGATA3_API void n3_mesh_patches(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                 int first, int last, n3_patch *out);

/* ---- Refinement ---- */

/* How many points, triangles and normals n3_mesh_refine makes, with level parts for each edge:
   points + (level - 1) edges + (level - 1)(level - 2)/2 T, level^2 T and (level + 1)(level + 2)/2 T
   where T counts the triangles that are not collapsed. Each pointer may be NULL. */
NAGATA3_API n3_status n3_mesh_refine_counts(const n3_mesh *m, const n3_topology *t, int level,
                                            int *points, int *triangles, int *normals);

/* The surface as triangles, level >= 1 parts for each edge. The points are first those of the
   mesh; then level - 1 on each edge from its lower to its higher point; then those inside each
   patch, in rows of constant v, u ascending. Each is computed once and the triangles that meet
   there share it: closed meshes stay closed. Collapsed triangles, and they alone, vanish.
   Every output may be NULL; sizes as n3_mesh_refine_counts says, in elements:
   point; triangle: 3 points each, a patch's together, turning as it does;
   normal: the patches' own, unit, a lattice of (level + 1)(level + 2)/2 for each patch in rows of
   constant v, so that two patches can differ at a crease; corner: 3 normals for each new triangle;
   parent and uv: for each new point the lowest triangle that has it, and its u and v there,
   2 numbers; -1 and 0, 0 for a point in no triangle. Linear in the output. */
NAGATA3_API n3_status n3_mesh_refine(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                     int level, n3_vec *point, int *triangle, n3_vec *normal,
                                     int *corner, int *parent, n3_real *uv);

/* Its parts, for callers that share the work out: the points on the edges first up to but not with
   last; and, of the triangles first up to but not with last, the points inside, the triangles, the
   normals and their corners, all into their places. The first points are the net's. Nothing is
   checked; n3_mesh_refine says what is. */
NAGATA3_API void n3_mesh_refine_edges(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                      int level, int first, int last, n3_vec *point);
NAGATA3_API void n3_mesh_refine_triangles(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                          int level, int first, int last, n3_vec *point,
                                          int *triangle, n3_vec *normal, int *corner);

/* Nodal values carried to new points with the parameters that n3_mesh_refine gave them.
   degree 1: nodal has a row of components numbers for each point. 2: then one for the middle of
   each edge. 3: then instead two for the thirds of each edge, the one next to the lower point
   first, and one for each triangle's centroid: the nodes of the net, with values in place of
   control points. Continuous across edges in every degree. out: [count][components]. */
NAGATA3_API n3_status n3_mesh_field(const n3_mesh *m, const n3_topology *t, int degree,
                                    int components, const n3_real *nodal, const int *parent,
                                    const n3_real *uv, int count, n3_real *out);

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
   parts are equal it makes the triangles of n3_mesh_refine, and its points to rounding.
   Every output may be NULL. point, triangle, parent and uv as there. normal: the patches' own, for
   each its corners, the points of its sides ab, bc and ca, then those inside; corner: 3 normals for
   each new triangle; origin: for each new triangle, that of the mesh. Linear in the output. */
NAGATA3_API n3_status n3_mesh_refine_cut(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                         const n3_cut *cut, n3_vec *point, int *triangle,
                                         n3_vec *normal, int *corner, int *origin, int *parent,
                                         n3_real *uv);

/* ---- Many patches at once ----

   These calls work on the items first up to but not with last, so that threads and processes can
   share them out as they like; the results do not depend on how. Out[0] belongs to the item first.
   Nothing is checked. */

/* The points of each patch at u = i / level, v = j / level, level >= 1, in rows of constant v, u
   ascending: (level + 1)(level + 2)/2 for each patch. On a side it is n3_edge_point from the
   canonical end, so that neighbours agree bit for bit, and with n3_mesh_refine; inside it is
   within 64 eps of the largest coordinate in the net of n3_patch_point (all roundings at their
   worst: 350; the most met: 28). 11 flops inside, 21 on a side; what is larger than a cache goes
   past it. */
NAGATA3_API void n3_lattice_points(const n3_patch *patch, int first, int last, int level,
                                   n3_vec *point);

/* The unit normals there: n3_patch_normal within 6 N3_NOISE (|du| + |dv|) / |du x dv| in a patch of
   size 1, and where a patch has a point at which |du x dv| is small, the same. 33 flops, a square
   root and a division. */
NAGATA3_API void n3_lattice_normals(const n3_patch *patch, int first, int last, int level,
                                    n3_vec *normal);

/* The same bits in blocks of N3_BLOCK patches, 32 bytes of each number: the x of the first point of
   all of them, their y, their z, the x of the next point. That takes less time than rows, and suits
   who goes on with vectors. first is a multiple of N3_BLOCK. What the last block has no patches for
   repeats the last patch: 3 N3_BLOCK (level + 1)(level + 2)/2 numbers are written for every block.
   More than a cache holds is written much faster to a multiple of 32 bytes. */
enum { N3_BLOCK = 32 / sizeof(n3_real) };
NAGATA3_API void n3_lattice_point_blocks(const n3_patch *patch, int first, int last, int level,
                                         n3_real *point);
NAGATA3_API void n3_lattice_normal_blocks(const n3_patch *patch, int first, int last, int level,
                                          n3_real *normal);

/* The triangles between these points, level^2 for each patch, 3 indices each, which count from the
   first point of patch 0. */
NAGATA3_API void n3_lattice_triangles(int first, int last, int level, int *triangle);

/* At the parameters uv[2 i] and uv[2 i + 1] of the patch parent[i], as n3_mesh_refine gives them:
   n3_patch_point and n3_patch_jet, bit for bit, and the normal as n3_lattice_normals has it.
   parent and uv are the whole arrays; every parent must be a patch. */
NAGATA3_API void n3_patch_points(const n3_patch *patch, const int *parent, const n3_real *uv,
                                 int first, int last, n3_vec *point);
NAGATA3_API void n3_patch_jets(const n3_patch *patch, const int *parent, const n3_real *uv,
                               int first, int last, n3_jet *jet);
NAGATA3_API void n3_patch_normals(const n3_patch *patch, const int *parent, const n3_real *uv,
                                  int first, int last, n3_vec *normal);

/* ---- Report ---- */

/* False if the patch certainly has no fold: all control vectors of its normal, du x dv, a quartic,
   make an acute angle with the normal of its outline. True says that it may have one;
   n3_patch_folds looks closer. */
NAGATA3_API int n3_patch_may_fold(const n3_patch *p);

/* What is in a mesh and what became of it. A count that could not be taken, for want of the
   topology or of the net and its flags, is -1. */
typedef struct n3_report {
    int points, triangles, normals, edges;
    int bad_points, bad_normals;       /* not finite */
    int bad_triangles, bad_corners;    /* triangles that name a point, a normal out of range */
    int collapsed_triangles;           /* name a point twice */
    int flat_triangles;                /* others without an area: their points are in a line */
    int duplicate_triangles;           /* have the three points of one before them */
    int unused_points;                 /* in no triangle */
    int zero_normals;                  /* corners without a normal, not of collapsed triangles */
    int flipped_normals;               /* corners whose normal looks to the back of the triangle */
    int border_edges, non_manifold_edges, flipped_edges;           /* by the topology */
    int straight_edges, s_shaped_edges, clamped_edges, branch_60_edges, turned_edges;
    int crease_edges, half_crease_edges, degenerate_edges;         /* by the flags */
    int folding_patches;               /* that may fold */
    n3_real jump;                      /* largest |n - n'|, 2 sin of half the angle, of the unit
                                          normals of two patches at the quarters of a smooth edge;
                                          flat and collapsed triangles are left out */
    int jump_edge;                     /* where; -1: there is no such edge */
    n3_real distance;                  /* largest distance of a patch to its triangle's plane, at
                                          the lattice of sixths */
    int distance_triangle;             /* where; -1: there is no triangle */
} n3_report;

/* Never fails, whatever the mesh holds: indices out of range, NaN, counts below 0 (they read as
   0). t may be NULL, as it must be when n3_mesh_topology has failed; net and flags, those of
   n3_mesh_net, may be NULL, and count only together and with t. Linear, but for duplicates, which
   cost the number of triangles at an edge each time. */
NAGATA3_API n3_report n3_mesh_report(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                     const unsigned *flags);

/* ---- Queries of one patch ---- */

/* Corners of a box along the axes. */
typedef struct n3_box { n3_vec lo, hi; } n3_box;

/* Holds the patch: the box of its control points. 54 comparisons. */
NAGATA3_API n3_box n3_patch_box(const n3_patch *p);

/* Holds the patch, and no side of it is farther from the patch than tolerance times the largest
   extent of n3_patch_box, unless a coordinate has so long a ridge that 500 parts of the patch do
   not settle it; 0 stands for N3_EPS. A tolerance of 1/1000 costs some 50 parts. */
NAGATA3_API n3_box n3_patch_box_tight(const n3_patch *p, n3_real tolerance);

/* No point of the patch is farther than this from the point of the triangle with the same u and
   v: 8/9 of the largest such distance of a control point. */
NAGATA3_API n3_real n3_patch_flatness(const n3_patch *p);

/* The part of the patch over a triangle in its domain, or outside, as a patch: uv holds the u and
   v of its corners. The corners of the domain in another order give the same patch with its
   corners in that order, exactly. 690 flops. */
NAGATA3_API n3_patch n3_patch_part(const n3_patch *p, const n3_real uv[6]);

/* The parts that have the point at u, v in place of the corner a, of b, of c. Parts share the
   control points of the side between them, bit for bit. */
NAGATA3_API void n3_patch_split(const n3_patch *p, n3_real u, n3_real v, n3_patch out[3]);

/* The parts between the middles of the sides: at a, at b, at c, and the one in the middle, turned
   against the others: its corners are the middles of bc, ca, ab. Parts share their sides bit for
   bit, with each other and across the sides of the patch. */
NAGATA3_API void n3_patch_split4(const n3_patch *p, n3_patch out[4]);

/* The same surface as a patch of degree 4, in the order of VTK_BEZIER_TRIANGLE: the corners, three
   points each of ab, bc, ca, and the three inside that are next to a, b, c. */
NAGATA3_API void n3_patch_raise(const n3_patch *p, n3_vec out[15]);

/* What bends at a point: the coefficients of du^2, du dv and dv^2 in the first fundamental form
   (E, 2 F, G) and in the second (L, 2 M, N) along the normal of n3_patch_normal; the principal
   curvatures, k[0] >= k[1], with their unit directions t[0], t[1] = normal x t[0]; their mean and
   their product. A curvature is positive where the surface bends towards its normal: a sphere seen
   from outside has -1 / radius. At an umbilic every direction is principal, and t[0] is along du.
   Where du x dv vanishes there are no curvatures: they and the directions are zero. */
typedef struct n3_curvature {
    n3_vec normal, t[2];
    n3_real E, F, G, L, M, N, k[2], mean, gauss;
} n3_curvature;

NAGATA3_API n3_curvature n3_patch_curvature(const n3_patch *p, n3_real u, n3_real v);

/* A point of the patch nearest to another point. */
typedef struct n3_foot {
    n3_vec x;             /* n3_patch_point at u, v */
    n3_real u, v;
    n3_real distance2;    /* the square of the distance */
    int side;             /* 1: the point is where the normal at x looks to, -1: behind it */
} n3_foot;

/* The nearest point of the whole patch, however it is folded: its squared distance is the least one
   but for 32 eps of the square of the largest distance to a control point, and but for degenerate
   patches that 2000 parts do not settle. Where several are nearest, one of them. It inverts
   n3_patch_point: a point of the patch finds its u and v.
   A foot on a side, u, v or w exactly 0, is the one that n3_edge_nearest finds, so that both
   patches of an edge return the same bits. NaN or infinite input: all NaN, side 0. About as long as
   ten of n3_patch_jet for a point near the patch. */
NAGATA3_API n3_foot n3_patch_nearest(const n3_patch *p, n3_vec q);

/* The t in [0, 1] of the point of the curve nearest to q, over the whole curve; 1 - t, exactly,
   from the other end. NaN or infinite input: 0. */
NAGATA3_API n3_real n3_edge_nearest(const n3_edge *e, n3_vec q);

/* Where the ray from + t along meets the patch. */
typedef struct n3_hit {
    n3_real t;
    n3_vec x;     /* n3_patch_point at u, v */
    n3_real u, v;
    int side;     /* 1: the ray comes from where the normal looks to, and enters; -1: it leaves */
} n3_hit;

/* A straight line meets a cubic patch in at most nine points, unless it lies in it. */
enum { N3_HITS = 9 };

/* All hits with t0 <= t <= t1, ascending; returns their number. along is not zero, of any length.
   Over the patches of a closed mesh that share their sides bit for bit, and whose triangles agree
   about which side is outside, the sides of all hits of a whole line add up to zero, exactly,
   through whatever edges and vertices the line goes: their number is even. A line that touches the
   patch has two hits there or none; the hits in one that lies in it are those of rounding.
   As long as ten of n3_patch_jet for a ray that hits once and does not graze. */
NAGATA3_API int n3_patch_hits(const n3_patch *p, n3_vec from, n3_vec along, n3_real t0, n3_real t1,
                              n3_hit hit[N3_HITS]);

/* The first of them; returns whether there is one. */
NAGATA3_API int n3_patch_hit(const n3_patch *p, n3_vec from, n3_vec along, n3_real t0, n3_real t1,
                             n3_hit *hit);

enum { N3_NO, N3_YES, N3_UNDECIDED };

/* Whether the patch folds as seen along a direction, that is whether <direction, du x dv> is
   anywhere 0 or below. Looks at as many parts of the patch as budget says, 1 at least, each about
   300 flops, and leaves it undecided when they do not tell. */
NAGATA3_API int n3_patch_folds(const n3_patch *p, n3_vec direction, int budget);

/* The signed volume between the patch and the point from, the cone over it, positive where the
   normal looks away from the point. moment, which may be NULL: the integral of x - from over it.
   Summed over a closed surface they give its volume, wherever from is, and volume times (centroid -
   from). Exact but for rounding, as long as the results are representable: 36 evaluations. */
NAGATA3_API n3_real n3_patch_volume(const n3_patch *p, n3_vec from, n3_vec *moment);

/* The area, to tolerance (relative; 0 stands for 16 N3_EPS) unless 2000 parts of the patch do not
   settle it. centroid, which may be NULL: of the area. */
NAGATA3_API n3_real n3_patch_area(const n3_patch *p, n3_real tolerance, n3_vec *centroid);

/* The length of the curve, to tolerance in the same manner. */
NAGATA3_API n3_real n3_edge_length(const n3_edge *e, n3_real tolerance);

/* ---- Definitions: the mesh ---- */

/* Counts are int; a negative one is the mark of an overflow, and passes through. */
enum { N3I_COUNT_LIMIT = 2147483647 };

typedef char n3i_assert_int[sizeof(int) == 4 ? 1 : -1];

NAGATA3_API int n3i_count_add(int a, int b)
{
    return a < 0 || b < 0 || a > N3I_COUNT_LIMIT - b ? -1 : a + b;
}

NAGATA3_API int n3i_count_mul(int a, int b)
{
    return a < 0 || b < 0 || (b > 0 && a > N3I_COUNT_LIMIT / b) ? -1 : a * b;
}

NAGATA3_API const char *n3_status_text(n3_status status)
{
    switch (status) {
    case N3_OK: return "all is well";
    case N3_NULL_POINTER: return "a pointer is NULL";
    case N3_BAD_COUNT: return "a count is negative, unfit or beyond int";
    case N3_BAD_TRIANGLE: return "a triangle names a point out of range";
    case N3_BAD_CORNER: return "a triangle names a normal out of range";
    case N3_BAD_POINT: return "a point is not finite";
    case N3_BAD_NORMAL: return "a normal is not finite";
    case N3_BAD_WORKSPACE: return "the workspace is too small";
    }
    return "unknown status";
}

NAGATA3_API n3_status n3i_blame(n3_status status, int index, int *item)
{
    if (item) *item = index;
    return status;
}

/* Copied byte by byte: a stride need not keep the alignment. */
NAGATA3_API n3_real n3i_real_at(const char *from, int k)
{
    n3_real a;
    memcpy(&a, from + (size_t)k * sizeof a, sizeof a);
    return a;
}

NAGATA3_API n3_vec n3i_vec_from(const char *from)
{
    return n3_v(n3i_real_at(from, 0), n3i_real_at(from, 1), n3i_real_at(from, 2));
}

NAGATA3_API const char *n3i_vec_place(const n3_real *base, size_t stride, int i)
{
    return (const char *)base + (size_t)i * (stride ? stride : 3 * sizeof *base);
}

NAGATA3_API n3_vec n3i_vec_at(const n3_real *base, size_t stride, int i)
{
    return n3i_vec_from(n3i_vec_place(base, stride, i));
}

NAGATA3_API int n3i_index_at(const int *base, size_t stride, int triangle, int corner)
{
    int index;
    const char *from = (const char *)base + (size_t)triangle * (stride ? stride : 3 * sizeof index);
    memcpy(&index, from + (size_t)corner * sizeof index, sizeof index);
    return index;
}

/* The same for c = 3 triangle + corner, without a division where the array is packed. */
NAGATA3_API int n3i_index_of(const int *base, size_t stride, int c)
{
    int index;
    if (stride) return n3i_index_at(base, stride, c / 3, c % 3);
    memcpy(&index, (const char *)base + (size_t)c * sizeof index, sizeof index);
    return index;
}

NAGATA3_API n3_vec n3i_point(const n3_mesh *m, int i)
{
    return n3i_vec_at(m->point, m->point_stride, i);
}

/* The point at corner c = 3 f + i of triangle f, and at the corner after it. */
NAGATA3_API int n3i_at(const n3_mesh *m, int c)
{
    return n3i_index_of(m->triangle, m->triangle_stride, c);
}

NAGATA3_API int n3i_after(int c) { return (unsigned)c % 3 == 2 ? c - 2 : c + 1; }

/* All three. */
NAGATA3_API void n3i_corners(const n3_mesh *m, int triangle, int c[3])
{
    size_t size = 3 * sizeof *c, stride = m->triangle_stride ? m->triangle_stride : size;
    memcpy(c, (const char *)m->triangle + (size_t)triangle * stride, size);
}

NAGATA3_API int n3i_is_collapsed(const n3_mesh *m, int triangle)
{
    int c[3];
    n3i_corners(m, triangle, c);
    return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

/* The normal that the mesh names for a corner, -1: none. */
NAGATA3_API int n3i_normal_at(const n3_mesh *m, int c)
{
    if (!m->normal) return -1;
    if (!m->corner) return n3i_at(m, c);
    return n3i_index_of(m->corner, m->corner_stride, c);
}

/* Made unit, unless it is so to rounding: then it keeps its bits. */
NAGATA3_API n3_vec n3i_made_unit(n3_vec n)
{
    return n3i_abs(n3_dot(n, n) - 1) <= 8 * N3_EPS ? n : n3_unit(n);
}

/* The unit normal of that name, zero where there is none. */
NAGATA3_API n3_vec n3i_normal_named(const n3_mesh *m, int i)
{
    if (i < 0) return n3_v(0, 0, 0);
    return n3i_made_unit(n3i_vec_at(m->normal, m->normal_stride, i));
}

NAGATA3_API n3_vec n3i_corner_normal(const n3_mesh *m, int c)
{
    return n3i_normal_named(m, n3i_normal_at(m, c));
}

NAGATA3_API int n3i_is_finite(n3_vec a)
{
    n3_vec zero = n3_sub(a, a);
    return zero.x <= 0 && zero.y <= 0 && zero.z <= 0;
}

/* The first corner whose name is not in [0, count), nor negative where that means none; -1: there
   is no such. */
NAGATA3_API int n3i_outside(const int *base, size_t stride, int triangles, int none, int count)
{
    int f, i;
    for (f = 0; f < triangles; f++)
        for (i = 0; i < 3; i++) {
            int k = n3i_index_at(base, stride, f, i);
            if (k >= count || (k < 0 && !none)) return 3 * f + i;
        }
    return -1;
}

NAGATA3_API int n3i_not_finite(const n3_real *base, size_t stride, int count)
{
    int i;
    for (i = 0; i < count; i++)
        if (!n3i_is_finite(n3i_vec_at(base, stride, i))) return i;
    return -1;
}

/* Points and triangles are sound. */
NAGATA3_API n3_status n3i_check_shape(const n3_mesh *m, int *item)
{
    int i;
    if (!m) return n3i_blame(N3_NULL_POINTER, -1, item);
    if (m->points < 0 || n3i_count_add(n3i_count_mul(m->triangles, 3), 1) < 0)
        return n3i_blame(N3_BAD_COUNT, -1, item);
    if ((m->points > 0 && !m->point) || (m->triangles > 0 && !m->triangle))
        return n3i_blame(N3_NULL_POINTER, -1, item);
    i = n3i_outside(m->triangle, m->triangle_stride, m->triangles, 0, m->points);
    if (i >= 0) return n3i_blame(N3_BAD_TRIANGLE, i / 3, item);
    i = n3i_not_finite(m->point, m->point_stride, m->points);
    return i >= 0 ? n3i_blame(N3_BAD_POINT, i, item) : N3_OK;
}

/* So are the normals, if there are any. */
NAGATA3_API n3_status n3i_check_normals(const n3_mesh *m, int *item)
{
    int i;
    if (!m->normal) return N3_OK;
    if (m->normals < 0 || (!m->corner && m->normals != m->points))
        return n3i_blame(N3_BAD_COUNT, -1, item);
    if (m->corner) {
        i = n3i_outside(m->corner, m->corner_stride, m->triangles, 1, m->normals);
        if (i >= 0) return n3i_blame(N3_BAD_CORNER, i / 3, item);
    }
    i = n3i_not_finite(m->normal, m->normal_stride, m->normals);
    return i >= 0 ? n3i_blame(N3_BAD_NORMAL, i, item) : N3_OK;
}

/* So is everything, and the topology is of this mesh. */
NAGATA3_API n3_status n3i_check(const n3_mesh *m, const n3_topology *t, int *item)
{
    n3_status status = n3i_check_shape(m, item);
    if (status == N3_OK) status = n3i_check_normals(m, item);
    if (status != N3_OK) return status;
    if (!t) return n3i_blame(N3_NULL_POINTER, -1, item);
    if (t->points != m->points || t->triangles != m->triangles)
        return n3i_blame(N3_BAD_COUNT, -1, item);
    return N3_OK;
}

/* ---- Definitions: topology ---- */

/* The workspace is three arrays of int: edge, which before it is filled serves as the counters of
   the points; first, which serves for the sorted sides; side. */
NAGATA3_API int n3i_edge_room(const n3_mesh *m)
{
    int sides = n3i_count_mul(m->triangles, 3), counters = n3i_count_add(m->points, 1);
    if (sides < 0 || counters < 0 || n3i_count_add(sides, 1) < 0) return -1;
    return sides > counters ? sides : counters;
}

NAGATA3_API size_t n3_mesh_workspace(const n3_mesh *m)
{
    int room = m ? n3i_edge_room(m) : -1;
    size_t sides, limit = (size_t)-1 / sizeof(int);
    if (room < 0) return 0;
    sides = 3 * (size_t)m->triangles;
    if ((size_t)room > limit - 1 || sides > (limit - 1 - (size_t)room) / 2) return 0;
    return ((size_t)room + sides + 1 + sides) * sizeof(int);
}

/* The higher (high 1) or lower point of a side. */
NAGATA3_API int n3i_end_of_side(const n3_mesh *m, int s, int high)
{
    int a = n3i_at(m, s), b = n3i_at(m, n3i_after(s));
    return (a > b) == (high != 0) ? a : b;
}

NAGATA3_API int n3i_has_length(const n3_mesh *m, int s)
{
    return n3i_at(m, s) != n3i_at(m, n3i_after(s));
}

/* Sorts sides by an end, keeping the order of equals. from NULL: all sides that have two ends.
   Returns how many there are. */
NAGATA3_API int n3i_sort_sides(const n3_mesh *m, int high, const int *from, int sides, int *count,
                               int *to)
{
    int i, kept = 0;
    for (i = 0; i <= m->points; i++) count[i] = 0;
    for (i = 0; i < sides; i++) {
        int s = from ? from[i] : i;
        if (!n3i_has_length(m, s)) continue;
        count[n3i_end_of_side(m, s, high) + 1]++;
        kept++;
    }
    for (i = 0; i < m->points; i++) count[i + 1] += count[i];
    for (i = 0; i < sides; i++) {
        int s = from ? from[i] : i;
        if (n3i_has_length(m, s)) to[count[n3i_end_of_side(m, s, high)]++] = s;
    }
    return kept;
}

/* Sides of one edge lie together in sorted; each takes the first of them for its leader, and then
   the leaders are numbered. Returns the number of edges. */
NAGATA3_API int n3i_number_edges(const n3_mesh *m, const int *sorted, int count, int *edge)
{
    int sides = 3 * m->triangles, edges = 0, i, leader = -1;
    for (i = 0; i < sides; i++) edge[i] = -1;
    for (i = 0; i < count; i++) {
        int s = sorted[i];
        if (leader < 0 || n3i_end_of_side(m, s, 0) != n3i_end_of_side(m, leader, 0) ||
            n3i_end_of_side(m, s, 1) != n3i_end_of_side(m, leader, 1))
            leader = s;
        edge[s] = leader;
    }
    for (i = 0; i < sides; i++)
        if (edge[i] >= 0) edge[i] = edge[i] == i ? edges++ : edge[edge[i]];
    return edges;
}

/* first counts to the end of each edge's sides and comes down to their beginning. */
NAGATA3_API void n3i_list_sides(int sides, int edges, const int *edge, int *first, int *side)
{
    int i;
    for (i = 0; i <= edges; i++) first[i] = 0;
    for (i = 0; i < sides; i++)
        if (edge[i] >= 0) first[edge[i]]++;
    for (i = 0; i < edges; i++) first[i + 1] += first[i];
    for (i = sides - 1; i >= 0; i--)
        if (edge[i] >= 0) side[--first[edge[i]]] = i;
}

NAGATA3_API int n3i_count_unused(const n3_mesh *m, int *used)
{
    int i, unused = m->points;
    for (i = 0; i < m->points; i++) used[i] = 0;
    for (i = 0; i < 3 * m->triangles; i++) {
        int p = n3i_at(m, i);
        unused -= !used[p];
        used[p] = 1;
    }
    return unused;
}

NAGATA3_API n3_status n3_mesh_topology(const n3_mesh *m, void *work, size_t size,
                                       n3_topology *topology, int *item)
{
    n3_status status = n3i_check_shape(m, item);
    size_t needed = n3_mesh_workspace(m);
    int *edge = (int *)work, *first, *side, sides, i;
    if (topology) memset(topology, 0, sizeof *topology);
    if (status != N3_OK) return status;
    if (!work || !topology) return n3i_blame(N3_NULL_POINTER, -1, item);
    if (needed == 0) return n3i_blame(N3_BAD_COUNT, -1, item);
    if (size < needed) return n3i_blame(N3_BAD_WORKSPACE, -1, item);
    sides = 3 * m->triangles;
    first = edge + n3i_edge_room(m);
    side = first + sides + 1;
    topology->points = m->points;
    topology->triangles = m->triangles;
    topology->unused = n3i_count_unused(m, edge);
    topology->collapsed = 0;
    for (i = 0; i < m->triangles; i++) topology->collapsed += n3i_is_collapsed(m, i);
    i = n3i_sort_sides(m, 1, NULL, sides, edge, side);
    i = n3i_sort_sides(m, 0, side, i, edge, first);
    topology->edges = n3i_number_edges(m, first, i, edge);
    n3i_list_sides(sides, topology->edges, edge, first, side);
    topology->edge = edge;
    topology->first = first;
    topology->side = side;
    return N3_OK;
}

NAGATA3_API void n3_mesh_edge_ends(const n3_mesh *m, const n3_topology *t, int edge, int end[2])
{
    int s = t->side[t->first[edge]];
    end[0] = n3i_end_of_side(m, s, 0);
    end[1] = n3i_end_of_side(m, s, 1);
}

/* The sides of an edge in triangles that are not collapsed: their number, and the first two. */
NAGATA3_API int n3i_live_sides(const n3_mesh *m, const n3_topology *t, int edge, int two[2])
{
    int i, live = 0;
    two[0] = two[1] = -1;
    for (i = t->first[edge]; i < t->first[edge + 1]; i++) {
        int s = t->side[i];
        if (n3i_is_collapsed(m, s / 3)) continue;
        if (live < 2) two[live] = s;
        live++;
    }
    return live;
}

/* Two triangles that agree about which side is outside, by running opposite ways. */
NAGATA3_API int n3i_is_regular(const n3_mesh *m, const n3_topology *t, int edge, int two[2])
{
    return n3i_live_sides(m, t, edge, two) == 2 && n3i_at(m, two[0]) != n3i_at(m, two[1]);
}

/* ---- Definitions: normals ---- */

/* Tolerances of the crease: sines of the angle between normals. Up to the first, 1.1 degrees,
   their difference is noise and its direction means nothing; from the second, 5.7, it is meant. */
#define N3_CREASE_LO ((n3_real)1 / 50)
#define N3_CREASE_HI ((n3_real)1 / 10)

/* A triangle's unit normal, zero when it has none; its longest side; the root of twice its area. */
typedef struct n3i_face { n3_vec normal; int longest; n3_real root; } n3i_face;

/* Seen from the corner that faces the longest side, where the sine is largest. */
NAGATA3_API n3i_face n3i_face_of(const n3_mesh *m, int triangle)
{
    n3i_face face;
    n3_vec e[3], n;
    n3_real l[3];
    int i;
    for (i = 0; i < 3; i++) {
        int c = 3 * triangle + i;
        e[i] = n3_sub(n3i_point(m, n3i_at(m, n3i_after(c))), n3i_point(m, n3i_at(m, c)));
        l[i] = n3_len(e[i]);
    }
    i = l[1] > l[0] ? 1 : 0;
    if (l[2] > l[i]) i = 2;
    n = n3_cross(n3_unit(e[(i + 1) % 3]), n3_unit(e[(i + 2) % 3]));
    face.normal = n3i_clear(n, 1);
    face.longest = 3 * triangle + i;
    face.root = n3i_sqrt(l[(i + 1) % 3]) * n3i_sqrt(l[(i + 2) % 3]) * n3i_sqrt(n3_len(n));
    return face;
}

/* A triangle without an area counts as part of the one beyond its longest side: so a needle neither
   cuts a smooth fan nor bridges a crease. */
NAGATA3_API n3_vec n3i_fan_normal(const n3_mesh *m, const n3_topology *t, int triangle)
{
    n3i_face face = n3i_face_of(m, triangle);
    int two[2], edge = t->edge[face.longest];
    if (!n3i_is_zero(face.normal) || edge < 0 || !n3i_is_regular(m, t, edge, two))
        return face.normal;
    return n3i_face_of(m, (two[0] == face.longest ? two[1] : two[0]) / 3).normal;
}

/* The normal given for a corner, -1: none, or zero. */
NAGATA3_API int n3i_given(const n3_mesh *m, int c)
{
    int i = n3i_normal_at(m, c);
    return i >= 0 && n3i_is_zero(n3i_vec_at(m->normal, m->normal_stride, i)) ? -1 : i;
}

/* Whether the normals given to the two triangles of an edge differ at an end: 0 or 1, or -1 where
   both have one at neither. */
NAGATA3_API int n3i_given_crease(const n3_mesh *m, const int two[2])
{
    int i, answer = -1;
    for (i = 0; i < 2; i++) {
        int c = i ? n3i_after(two[0]) : two[0], d = i ? two[1] : n3i_after(two[1]);
        n3_vec n0 = n3i_corner_normal(m, c), n1 = n3i_corner_normal(m, d);
        if (n3i_given(m, c) < 0 || n3i_given(m, d) < 0) continue;
        if (n3_dot(n0, n1) < 0 || n3_len(n3_cross(n0, n1)) > N3_CREASE_LO) return 1;
        answer = 0;
    }
    return answer;
}

NAGATA3_API int n3i_is_crease(const n3_mesh *m, const n3_topology *t, int edge, n3_real cos_crease,
                              const unsigned char *mark)
{
    int i, two[2];
    n3_vec n0, n1;
    if (!n3i_is_regular(m, t, edge, two)) return 1;
    for (i = t->first[edge]; mark && i < t->first[edge + 1]; i++)
        if (mark[t->side[i]]) return 1;
    i = n3i_given_crease(m, two);
    if (i >= 0 || cos_crease <= -1) return i > 0;
    n0 = n3i_fan_normal(m, t, two[0] / 3);
    n1 = n3i_fan_normal(m, t, two[1] / 3);
    return n3i_is_zero(n0) || n3i_is_zero(n1) || !(n3_dot(n0, n1) >= cos_crease);
}

/* Fans are a forest of corners that link to lower ones. */
NAGATA3_API int n3i_root(int *link, int c)
{
    while (link[c] != c) {
        link[c] = link[link[c]];
        c = link[c];
    }
    return c;
}

NAGATA3_API void n3i_join(int *link, int a, int b)
{
    a = n3i_root(link, a);
    b = n3i_root(link, b);
    if (a < b) link[b] = a;
    else link[a] = b;
}

NAGATA3_API void n3i_make_fans(const n3_mesh *m, const n3_topology *t, n3_real cos_crease,
                               const unsigned char *mark, int *link)
{
    int i, edge, two[2];
    for (i = 0; i < 3 * m->triangles; i++) link[i] = i;
    for (edge = 0; edge < t->edges; edge++) {
        if (n3i_is_crease(m, t, edge, cos_crease, mark)) continue;
        n3i_live_sides(m, t, edge, two);
        n3i_join(link, two[0], n3i_after(two[1]));
        n3i_join(link, two[1], n3i_after(two[0]));
    }
}

/* From links to indices of normals: given ones, and from first on one for each fan that has a
   corner without, negative while it stands beside links. Returns the number of normals. */
NAGATA3_API int n3i_number_fans(const n3_mesh *m, int first, int *corner)
{
    int c, next = first, corners = 3 * m->triangles;
    for (c = 0; c < corners; c++) corner[c] = corner[corner[c]];
    for (c = 0; c < corners; c++) {
        int root = corner[c], given = n3i_given(m, c);
        if (given < 0 && corner[root] >= 0) corner[root] = -1 - next++;
        if (c != root) corner[c] = given < 0 ? corner[root] : given;
    }
    for (c = 0; c < corners; c++) {
        int given = n3i_given(m, c);
        if (given >= 0) corner[c] = given;
        else if (corner[c] < 0) corner[c] = -1 - corner[c];
    }
    return next;
}

/* The largest component of a way from the first point, what lengths are measured by; 1 where all
   points are in one place. */
NAGATA3_API n3_real n3i_mesh_size(const n3_mesh *m)
{
    n3_real size = 0;
    int i;
    for (i = 1; i < m->points; i++)
        size = n3i_larger(size, n3i_largest(n3_sub(n3i_point(m, i), n3i_point(m, 0))));
    return size > 0 ? size : 1;
}

/* Max's terms (e0 x e1) / (|e0|^2 |e1|^2) at the corners of a triangle, in units of 1/size^2. Sides
   below eps^2 of the size count as that long, so that the square of a term is in range; an angle
   that is rounding gives zero. */
NAGATA3_API void n3i_corner_terms(const n3_mesh *m, int triangle, n3_real size, n3_vec term[3])
{
    n3_vec x[3], e[3];
    n3_real l[3];
    int i, c[3];
    n3i_corners(m, triangle, c);
    for (i = 0; i < 3; i++) x[i] = n3i_point(m, c[i]);
    for (i = 0; i < 3; i++) {
        n3_vec d = n3_sub(x[n3i_after(i)], x[i]);
        l[i] = n3i_larger(n3_len(d) / size, N3_EPS * N3_EPS);
        e[i] = n3_unit(d);
    }
    for (i = 0; i < 3; i++) {
        int before = n3i_after(n3i_after(i));
        n3_vec n = n3_cross(e[before], e[i]); /* e1 is -e[before] */
        int clear = n3_dot(n, n) > 4 * N3_NOISE * N3_NOISE || n3_len(n) > N3_NOISE;
        term[i] = clear ? n3i_over(n3i_over(n, l[i]), l[before]) : n3_v(0, 0, 0);
    }
}

/* Max's sums, unit, where they keep half their digits; zero where they cancel, which is looked for
   where some sum is short against the longest of all terms. */
NAGATA3_API void n3i_sum_fans(const n3_mesh *m, const int *corner, int first, int last,
                              n3_real size, n3_vec *normal)
{
    n3_vec term[3];
    n3_real longest = 0;
    int c, i, suspect = 0, corners = 3 * m->triangles;
    for (c = first; c < last; c++) normal[c] = n3_v(0, 0, 0);
    for (c = 0; c < corners; c += 3) {
        n3i_corner_terms(m, c / 3, size, term);
        for (i = 0; i < 3; i++) {
            if (corner[c + i] < first) continue;
            normal[corner[c + i]] = n3_add(normal[corner[c + i]], term[i]);
            longest = n3i_larger(longest, n3i_largest(term[i]));
        }
    }
    for (c = first; c < last; c++) suspect |= n3i_largest(normal[c]) <= 2 * N3_OPPOSITE * longest;
    for (c = 0; suspect && c < corners; c += 3) {
        n3i_corner_terms(m, c / 3, size, term);
        for (i = 0; i < 3; i++) {
            n3_vec *sum = normal + corner[c + i];
            if (corner[c + i] < first) continue;
            if (n3_len(*sum) <= N3_OPPOSITE * n3_len(term[i])) *sum = n3_v(0, 0, 0);
        }
    }
    for (c = first; c < last; c++) normal[c] = n3_unit(normal[c]);
}

/* Fans that are zero take the normal of their largest triangle, of two alike the one that comes
   first in n3i_order. While they wait it is shorter than 1/2, as no side is longer than 4 size. */
NAGATA3_API void n3i_mend_fans(const n3_mesh *m, const int *corner, int first, int last,
                               n3_real size, n3_vec *normal)
{
    int c;
    for (c = 0; c < 3 * m->triangles; c++) {
        n3_vec *best = normal + corner[c], n;
        n3_real longer;
        n3i_face face;
        if (corner[c] < first || n3_dot(*best, *best) > (n3_real)1 / 2) continue;
        face = n3i_face_of(m, c / 3);
        n = n3_mul(face.root / size / 8, face.normal);
        longer = n3_len(n) - n3_len(*best);
        if (longer > 0 || (longer >= 0 && n3i_order(n, *best) < 0)) *best = n;
    }
    for (c = first; c < last; c++) normal[c] = n3_unit(normal[c]);
}

NAGATA3_API n3_status n3_mesh_normals(const n3_mesh *m, const n3_topology *t, n3_real cos_crease,
                                      const unsigned char *mark, n3_vec *normal, int *corner,
                                      int *normals, int *item)
{
    n3_status status = n3i_check(m, t, item);
    int i, first, last;
    n3_real size;
    if (status != N3_OK) return status;
    first = m->normal ? m->normals : 0;
    if (n3i_count_add(first, 3 * m->triangles) < 0) return n3i_blame(N3_BAD_COUNT, -1, item);
    if (!normals || (m->triangles > 0 && (!normal || !corner)))
        return n3i_blame(N3_NULL_POINTER, -1, item);
    size = n3i_mesh_size(m);
    for (i = 0; i < first; i++)
        normal[i] = n3i_made_unit(n3i_vec_at(m->normal, m->normal_stride, i));
    n3i_make_fans(m, t, cos_crease, mark, corner);
    last = n3i_number_fans(m, first, corner);
    n3i_sum_fans(m, corner, first, last, size, normal);
    n3i_mend_fans(m, corner, first, last, size, normal);
    *normals = last;
    return N3_OK;
}

/* ---- Definitions: several at once ----

   A wide number holds one number from each of N3I_WIDTH patches or edges, its lanes: in a vector of
   GCC and Clang, or in n3_real where there is none. Wide forms do the operations of the plain ones
   in the same order and round alike. A lane that the plain form would treat as a case of its own is
   not ok, and the plain form does it again. */

#if NAGATA3_SIMD
#ifdef __AVX__
#define N3I_BYTES 32
#else
#define N3I_BYTES 16
#endif
#define N3I_WIDE_API NAGATA3_API __attribute__((always_inline))
#define N3I_UNROLL   _Pragma("GCC unroll 16")
typedef n3_real n3i_wide __attribute__((vector_size(N3I_BYTES)));
typedef __typeof__(*(n3i_wide *)0 > *(n3i_wide *)0) n3i_mask; /* integers of the same size */
typedef n3_real n3i_xyz __attribute__((vector_size(N3I_PICK(N3I_BYTES, 16))));
#else
#define N3I_WIDE_API NAGATA3_API
#define N3I_UNROLL
typedef n3_real n3i_wide;
typedef int n3i_mask;
typedef n3_real n3i_xyz;
#endif

enum { N3I_WIDTH = sizeof(n3i_wide) / sizeof(n3_real) };
enum { N3I_XYZ = sizeof(n3i_xyz) / sizeof(n3_real) };

typedef struct n3i_wide_vec { n3i_wide x, y, z; } n3i_wide_vec;

#if NAGATA3_SIMD
N3I_WIDE_API n3i_wide n3i_wide_of(n3_real a)
{
    n3i_wide zero = {0};
    return a - zero;
}

N3I_WIDE_API n3i_wide n3i_pick(n3i_mask mask, n3i_wide a, n3i_wide b)
{
#ifdef __AVX__
    return N3I_PICK(__builtin_ia32_blendvpd256, __builtin_ia32_blendvps256)(b, a, (n3i_wide)mask);
#else
    return (n3i_wide)((mask & (n3i_mask)a) | (~mask & (n3i_mask)b));
#endif
}

N3I_WIDE_API n3i_wide n3i_wide_abs(n3i_wide a)
{
    return (n3i_wide)((n3i_mask)a & ~(n3i_mask)n3i_wide_of(-(n3_real)0));
}

N3I_WIDE_API int n3i_lane(n3i_mask mask, int lane) { return mask[lane] != 0; }

#if __has_builtin(__builtin_elementwise_sqrt)
#define N3I_SQRT __builtin_elementwise_sqrt
#elif defined __AVX__
#define N3I_SQRT N3I_PICK(__builtin_ia32_sqrtpd256, __builtin_ia32_sqrtps256)
#elif defined __SSE2__
#define N3I_SQRT N3I_PICK(__builtin_ia32_sqrtpd, __builtin_ia32_sqrtps)
#endif

N3I_WIDE_API n3i_wide n3i_wide_sqrt(n3i_wide a)
{
#ifdef N3I_SQRT
    return N3I_SQRT(a);
#else
    int i;
    for (i = 0; i < N3I_WIDTH; i++) a[i] = n3i_sqrt(a[i]);
    return a;
#endif
}

/* One step of turning rows into columns: blocks of step numbers off the diagonal change places. */
N3I_WIDE_API void n3i_exchange(n3i_wide *a, n3i_wide *b, int step)
{
    n3i_wide p = *a, q = *b;
#if N3I_BYTES == N3I_PICK(16, 8)
    if (step == 1) *a = __builtin_shufflevector(p, q, 0, 2);
    if (step == 1) *b = __builtin_shufflevector(p, q, 1, 3);
#elif N3I_BYTES == N3I_PICK(32, 16)
    if (step == 1) *a = __builtin_shufflevector(p, q, 0, 4, 2, 6);
    if (step == 1) *b = __builtin_shufflevector(p, q, 1, 5, 3, 7);
    if (step == 2) *a = __builtin_shufflevector(p, q, 0, 1, 4, 5);
    if (step == 2) *b = __builtin_shufflevector(p, q, 2, 3, 6, 7);
#else
    if (step == 1) *a = __builtin_shufflevector(p, q, 0, 8, 2, 10, 4, 12, 6, 14);
    if (step == 1) *b = __builtin_shufflevector(p, q, 1, 9, 3, 11, 5, 13, 7, 15);
    if (step == 2) *a = __builtin_shufflevector(p, q, 0, 1, 8, 9, 4, 5, 12, 13);
    if (step == 2) *b = __builtin_shufflevector(p, q, 2, 3, 10, 11, 6, 7, 14, 15);
    if (step == 4) *a = __builtin_shufflevector(p, q, 0, 1, 2, 3, 8, 9, 10, 11);
    if (step == 4) *b = __builtin_shufflevector(p, q, 4, 5, 6, 7, 12, 13, 14, 15);
#endif
}

/* The first and the second of N3I_WIDTH pairs. */
N3I_WIDE_API void n3i_pairs(const n3_real *from, n3i_wide *first, n3i_wide *second)
{
    n3i_wide p, q;
    memcpy(&p, from, sizeof p);
    memcpy(&q, from + N3I_WIDTH, sizeof q);
#if N3I_BYTES == N3I_PICK(16, 8)
    *first = __builtin_shufflevector(p, q, 0, 2);
    *second = __builtin_shufflevector(p, q, 1, 3);
#elif N3I_BYTES == N3I_PICK(32, 16)
    *first = __builtin_shufflevector(p, q, 0, 2, 4, 6);
    *second = __builtin_shufflevector(p, q, 1, 3, 5, 7);
#else
    *first = __builtin_shufflevector(p, q, 0, 2, 4, 6, 8, 10, 12, 14);
    *second = __builtin_shufflevector(p, q, 1, 3, 5, 7, 9, 11, 13, 15);
#endif
}

/* A row of a point that nothing follows: four numbers begin before it. */
N3I_WIDE_API n3i_xyz n3i_xyz_last(const n3_real *from)
{
    n3i_xyz x;
#if N3I_BYTES == N3I_PICK(16, 0)
    memcpy(&x, from, sizeof x);
#else
    memcpy(&x, from - 1, sizeof x);
    x = __builtin_shufflevector(x, x, 1, 2, 3, 3);
#endif
    return x;
}

/* Of four numbers, three. */
N3I_WIDE_API void n3i_xyz_store(n3i_xyz x, n3_real *to)
{
    int i;
    N3I_UNROLL
    for (i = 0; i < (N3I_XYZ < 3 ? N3I_XYZ : 3); i++) to[i] = x[i];
}

/* Rows into columns, by halving. */
N3I_WIDE_API void n3i_turn(n3i_wide row[N3I_WIDTH])
{
    int i, step;
    N3I_UNROLL
    for (step = 1; step < N3I_WIDTH; step *= 2)
        N3I_UNROLL
        for (i = 0; i < N3I_WIDTH; i++)
            if (!(i & step)) n3i_exchange(&row[i], &row[i + step], step);
}
#else
N3I_WIDE_API n3i_wide n3i_wide_of(n3_real a) { return a; }
N3I_WIDE_API n3i_wide n3i_pick(n3i_mask mask, n3i_wide a, n3i_wide b) { return mask ? a : b; }
N3I_WIDE_API n3i_wide n3i_wide_abs(n3i_wide a) { return n3i_abs(a); }
N3I_WIDE_API int n3i_lane(n3i_mask mask, int lane) { return lane == 0 && mask; }
N3I_WIDE_API n3i_wide n3i_wide_sqrt(n3i_wide a) { return n3i_sqrt(a); }
N3I_WIDE_API void n3i_turn(n3i_wide row[N3I_WIDTH]) { (void)row; }
N3I_WIDE_API void n3i_pairs(const n3_real *from, n3i_wide *first, n3i_wide *second)
{
    *first = from[0];
    *second = from[1];
}
N3I_WIDE_API n3i_xyz n3i_xyz_last(const n3_real *from) { return *from; }
N3I_WIDE_API void n3i_xyz_store(n3i_xyz x, n3_real *to) { *to = x; }
#endif

/* The first count numbers of every lane; count is at least N3I_WIDTH. */
N3I_WIDE_API void n3i_load(const n3_real *const from[N3I_WIDTH], int count, n3i_wide *to)
{
    n3i_wide row[N3I_WIDTH];
    int i, k, at;
    for (k = 0; k < count; k += N3I_WIDTH) {
        at = k + N3I_WIDTH > count ? count - N3I_WIDTH : k;
        N3I_UNROLL
        for (i = 0; i < N3I_WIDTH; i++) memcpy(&row[i], from[i] + at, sizeof row[i]);
        n3i_turn(row);
        N3I_UNROLL
        for (i = 0; i < N3I_WIDTH; i++) to[at + i] = row[i];
    }
}

/* A store past the caches, to where a vector may begin; the fence after the last of them. */
#if !NAGATA3_SIMD || !defined __SSE2__
#define N3I_PAST(to, x) memcpy(to, &(x), sizeof(x))
#elif __has_builtin(__builtin_nontemporal_store)
#define N3I_PAST(to, x) __builtin_nontemporal_store(x, (n3i_wide *)(void *)(to))
#elif defined __AVX__
#define N3I_PAST N3I_PICK(__builtin_ia32_movntpd256, __builtin_ia32_movntps256)
#else
#define N3I_PAST N3I_PICK(__builtin_ia32_movntpd, __builtin_ia32_movntps)
#endif

NAGATA3_API void n3i_fence(void)
{
#if NAGATA3_SIMD && defined __SSE2__
    __builtin_ia32_sfence();
#endif
}

/* The reverse, of N3I_WIDTH numbers from at on. */
N3I_WIDE_API void n3i_turned(const n3i_wide *from, int at, n3_real *const to[N3I_WIDTH], int past)
{
    n3i_wide row[N3I_WIDTH];
    int i;
    N3I_UNROLL
    for (i = 0; i < N3I_WIDTH; i++) row[i] = from[at + i];
    n3i_turn(row);
    N3I_UNROLL
    for (i = 0; i < N3I_WIDTH; i++)
        if (past) N3I_PAST(to[i] + at, row[i]);
        else memcpy(to[i] + at, &row[i], sizeof row[i]);
}

/* Of any count. */
N3I_WIDE_API void n3i_store(const n3i_wide *from, int count, n3_real *const to[N3I_WIDTH],
                            int past)
{
    n3_real *out[N3I_WIDTH];
    int i, k;
    for (i = 0; i < N3I_WIDTH; i++) out[i] = to[i]; /* that no store could change */
    for (k = 0; k + N3I_WIDTH <= count; k += N3I_WIDTH) n3i_turned(from, k, out, past);
    if (k < count && count > N3I_WIDTH) n3i_turned(from, count - N3I_WIDTH, out, 0);
    for (; k < count && count < N3I_WIDTH; k++)
        for (i = 0; i < N3I_WIDTH; i++)
            memcpy(out[i] + k, (const char *)&from[k] + (size_t)i * sizeof **to, sizeof **to);
}

N3I_WIDE_API int n3i_all(n3i_mask mask)
{
    int i, all = 1;
    N3I_UNROLL
    for (i = 0; i < N3I_WIDTH; i++) all &= n3i_lane(mask, i);
    return all;
}

N3I_WIDE_API n3i_wide_vec n3i_wide_v(n3i_wide x, n3i_wide y, n3i_wide z)
{
    n3i_wide_vec a;
    a.x = x;
    a.y = y;
    a.z = z;
    return a;
}

N3I_WIDE_API n3i_wide_vec n3i_wide_add(n3i_wide_vec a, n3i_wide_vec b)
{
    return n3i_wide_v(a.x + b.x, a.y + b.y, a.z + b.z);
}

N3I_WIDE_API n3i_wide_vec n3i_wide_sub(n3i_wide_vec a, n3i_wide_vec b)
{
    return n3i_wide_v(a.x - b.x, a.y - b.y, a.z - b.z);
}

N3I_WIDE_API n3i_wide_vec n3i_wide_mul(n3i_wide s, n3i_wide_vec a)
{
    return n3i_wide_v(s * a.x, s * a.y, s * a.z);
}

N3I_WIDE_API n3i_wide_vec n3i_wide_over(n3i_wide_vec a, n3i_wide s)
{
    return n3i_wide_v(a.x / s, a.y / s, a.z / s);
}

N3I_WIDE_API n3i_wide n3i_wide_dot(n3i_wide_vec a, n3i_wide_vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

N3I_WIDE_API n3i_wide_vec n3i_wide_cross(n3i_wide_vec a, n3i_wide_vec b)
{
    return n3i_wide_v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

N3I_WIDE_API n3i_wide_vec n3i_wide_pick(n3i_mask mask, n3i_wide_vec a, n3i_wide_vec b)
{
    return n3i_wide_v(n3i_pick(mask, a.x, b.x), n3i_pick(mask, a.y, b.y),
                      n3i_pick(mask, a.z, b.z));
}

N3I_WIDE_API n3i_wide n3i_wide_larger(n3i_wide a, n3i_wide b)
{
    return n3i_pick((n3i_mask)(b > a), b, a);
}

/* n3_unit and n3_len of a lane whose square neither overflows nor underflows; the others are not
   ok. */
N3I_WIDE_API n3i_wide_vec n3i_wide_unit(n3i_wide_vec a, n3i_wide *length, n3i_mask *ok)
{
    n3i_wide aa = n3i_wide_dot(a, a);
    *ok &= (n3i_mask)(aa > N3I_LEAST_SQUARE) & (n3i_mask)(aa < N3I_MOST_SQUARE);
    *length = n3i_wide_sqrt(n3i_wide_larger(n3i_wide_of(N3I_LEAST_SQUARE), aa));
    return n3i_wide_over(a, *length);
}

/* The square of d x n at which n counts as along d; a d whose own square is too small or too large
   is not ok. */
N3I_WIDE_API n3i_wide n3i_wide_along(n3i_wide_vec d, n3i_mask *ok)
{
    n3i_wide dd = n3i_wide_dot(d, d);
    *ok &= (n3i_mask)(dd > N3I_LEAST_SQUARE) & (n3i_mask)(dd < N3I_MOST_SQUARE);
    return N3_ALONG * N3_ALONG * dd;
}

/* n3i_upright of a lane whose n is neither zero nor along d; along: n3i_wide_along of d. */
N3I_WIDE_API n3i_wide_vec n3i_wide_upright(n3i_wide_vec d, n3i_wide_vec n, n3i_wide along,
                                           n3i_mask *ok)
{
    n3i_wide_vec m = n3i_wide_cross(d, n);
    n3i_wide length;
    *ok &= (n3i_mask)(n3i_wide_dot(m, m) > along);
    return n3i_wide_unit(m, &length, ok);
}

/* ---- Definitions: edges at once ---- */

typedef struct n3i_wide_vertex { n3i_wide_vec x, n; } n3i_wide_vertex;
typedef struct n3i_wide_end { n3i_wide_vec reach; n3i_wide tan; } n3i_wide_end;

/* n3i_end_make. */
N3I_WIDE_API n3i_wide_end n3i_wide_end_make(n3i_wide_vec n, n3i_wide_vec d, n3i_wide_vec b,
                                            const n3_options *o)
{
    n3i_wide third = n3i_wide_of((n3_real)1 / 3), high = n3i_wide_of(o->tan_hi), stretch;
    n3i_wide nd = n3i_wide_dot(n, d), nb = n3i_wide_dot(n, b), s, size;
    n3i_wide_end t;
    s = nd / n3i_pick((n3i_mask)(nb * nb > 0), nb, n3i_wide_of(1));
    size = n3i_wide_abs(s);
    t.tan = n3i_pick((n3i_mask)(size < high), size, high);                         /* (5.1.12) */
    t.tan = n3i_wide_larger(t.tan, n3i_wide_of(o->tan_lo));                        /* (5.1.11) */
    stretch = 4 * third / n3i_wide_sqrt(1 + s * s);
    stretch = n3i_pick((n3i_mask)(s * s > 3), stretch, 2 * third);
    t.reach = n3i_wide_mul(stretch, n3i_wide_sub(d, n3i_wide_mul(s, b)));
    return t;
}

/* n3i_handle. */
N3I_WIDE_API n3i_wide_vec n3i_wide_handle(n3i_wide_end here, n3i_wide_end other)
{
    return n3i_wide_mul(other.tan / (here.tan + other.tan), here.reach);
}

/* n3i_plane, and from it b as long as the chord and across it. */
N3I_WIDE_API n3i_wide_vec n3i_wide_across(n3i_wide_vec d, n3i_wide_vec n0, n3i_wide_vec n1,
                                          n3i_mask *ok)
{
    n3i_wide along = n3i_wide_along(d, ok), length;
    n3i_wide_vec m0 = n3i_wide_upright(d, n0, along, ok), m1 = n3i_wide_upright(d, n1, along, ok);
    n3i_mask acute = (n3i_mask)(n3i_wide_dot(m0, m1) >= 0);
    n3i_wide_vec m = n3i_wide_pick(acute, n3i_wide_add(m0, m1), n3i_wide_sub(m0, m1));
    return n3i_wide_cross(n3i_wide_unit(m, &length, ok), d);
}

/* n3i_edge_paper, b across the chord given. */
N3I_WIDE_API void n3i_wide_edge_paper(n3i_wide_vertex v0, n3i_wide_vertex v1, n3i_wide_vec b,
                                      const n3_options *o, n3i_wide_vec p[2])
{
    n3i_wide_vec d = n3i_wide_sub(v1.x, v0.x);
    n3i_wide_end s = n3i_wide_end_make(v0.n, d, b, o), t = n3i_wide_end_make(v1.n, d, b, o);
    p[0] = n3i_wide_add(v0.x, n3i_wide_handle(s, t));                              /* (5.1.13) */
    p[1] = n3i_wide_sub(v1.x, n3i_wide_handle(t, s));                              /* (5.1.14) */
}

N3I_WIDE_API n3i_wide_vec n3i_wide_off(n3i_wide_vec a, n3i_wide_vec n)
{
    return n3i_wide_sub(a, n3i_wide_mul(n3i_wide_dot(a, n), n));
}

/* n3i_edge_arc. */
N3I_WIDE_API void n3i_wide_edge_arc(n3i_wide_vertex v0, n3i_wide_vertex v1, n3i_wide_vec p[2],
                                    n3i_mask *ok)
{
    n3i_wide_vec d = n3i_wide_sub(v1.x, v0.x), e, m, q, turn = n3i_wide_sub(v1.n, v0.n);
    n3i_wide g = n3i_wide_dot(d, turn), k, length, along;
    along = n3i_wide_along(d, ok);
    n3i_wide_upright(d, v0.n, along, ok);
    n3i_wide_upright(d, v1.n, along, ok);
    m = n3i_wide_unit(n3i_wide_add(v0.n, v1.n), &length, ok);
    *ok &= (n3i_mask)(length > N3_OPPOSITE);
    k = 1 / (1 + length / 2);
    q = n3i_wide_sub(n3i_wide_off(d, m), n3i_wide_mul(g * k * k / 4, turn));
    m = n3i_wide_mul(g * k, m);
    d = n3i_wide_over(n3i_wide_add(q, m), n3i_wide_of(3));
    e = n3i_wide_over(n3i_wide_sub(q, m), n3i_wide_of(3));
    p[0] = n3i_wide_add(v0.x, n3i_wide_off(d, v0.n));
    p[1] = n3i_wide_sub(v1.x, n3i_wide_off(e, v1.n));
}

/* n3i_centre_cubic, from (6.1.10). */
N3I_WIDE_API n3i_wide_vec n3i_wide_centre_cubic(const n3i_wide_vec p[9], const n3i_wide_vec n[3],
                                                n3i_mask *ok)
{
    n3i_wide_vec corners = n3i_wide_add(n3i_wide_add(p[0], p[1]), p[2]), centre, x[3], v[3], mean;
    n3i_wide K = n3i_wide_of(-(n3_real)3 / 64), three = n3i_wide_of(3), k, length;
    int i;
    centre = n3i_wide_add(n3i_wide_add(n3i_wide_add(p[4], p[7]), n3i_wide_add(p[8], p[5])),
                          n3i_wide_add(p[3], p[6]));
    centre = n3i_wide_sub(n3i_wide_over(centre, n3i_wide_of(4)),
                          n3i_wide_over(corners, n3i_wide_of(6)));                 /* (6.1.10) */
    mean = n3i_wide_over(corners, three);
    for (i = 0; i < 3; i++) x[i] = n3i_wide_sub(p[i], mean);
    mean = n3i_wide_over(n3i_wide_add(n3i_wide_add(n[0], n[1]), n[2]), three);
    for (i = 0; i < 3; i++) v[i] = n3i_wide_sub(n[i], mean);
    for (i = 0; i < 3; i++) {
        n3i_wide_unit(n3i_wide_add(n[i], n[(i + 1) % 3]), &length, ok);
        k = 1 / (1 + length / 2);
        K += 3 * k * k / 16;
    }
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        n3i_wide A = n3i_wide_dot(x[i], v[j]) + n3i_wide_dot(x[j], v[i]);
        centre = n3i_wide_sub(centre, n3i_wide_mul(K * A / 2, v[(i + 2) % 3]));
    }
    return centre;
}

/* n3_patch_centre_arc. */
N3I_WIDE_API n3i_wide_vec n3i_wide_centre_arc(const n3i_wide_vec p[9], const n3i_wide_vec n[3],
                                              const n3i_wide_vec mid[3], n3i_mask *ok)
{
    n3i_wide_vec N = n3i_wide_add(n3i_wide_add(n[0], n[1]), n[2]);
    n3i_wide_vec C = n3i_wide_centre_cubic(p, n, ok);
    n3i_wide eighth = n3i_wide_of((n3_real)1 / 8), low, rc = 0 * eighth, cc = rc, length;
    int i;
    low = (n3_real)3 / 4 * n3i_wide_larger(n3i_wide_dot(N, N), eighth / 2);
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n3i_wide_vec p1 = p[3 + 2 * i], p2 = p[4 + 2 * i], x, facing, t, ne;
        x = n3i_wide_add(
            n3i_wide_add(n3i_wide_mul(eighth, p[i]), n3i_wide_mul(3 * eighth, p1)),
            n3i_wide_add(n3i_wide_mul(3 * eighth, p2), n3i_wide_mul(eighth, p[j])));
        facing = n3i_wide_add(p[3 + 2 * j], p[4 + 2 * k]);
        facing = n3i_wide_mul(4 * eighth, facing);
        x = n3i_wide_sub(n3i_wide_sub(n3i_wide_add(x, x), facing), C);
        t = n3i_wide_add(n3i_wide_sub(p[j], p[i]), n3i_wide_sub(p2, p1));
        t = n3i_wide_unit(t, &length, ok);
        ne = n3i_wide_unit(mid[i], &length, ok);
        ne = n3i_wide_upright(t, ne, n3i_wide_along(t, ok), ok);
        ne = n3i_wide_cross(ne, t);
        rc += n3i_wide_dot(ne, x) * n3i_wide_dot(ne, N);
        cc += n3i_wide_dot(ne, N) * n3i_wide_dot(ne, N);
    }
    return n3i_wide_add(C, n3i_wide_mul(rc / n3i_wide_larger(cc, low), N));
}

/* ---- Definitions: the net ---- */

/* What the triangles bring to one end of an edge. n: the one normal, or the unit sum of all;
   crease: the direction along all tangent planes, zero when there is none, and its share in the
   tangent; split: there is more than one tangent plane. */
typedef struct n3i_joint { n3_vec n, crease; n3_real share; int split; } n3i_joint;

/* The normals that a triangle brings to the ends of an edge. */
typedef struct n3i_pair { n3_vec n[2]; } n3i_pair;

/* As many different pairs are looked at, the first in order. */
enum { N3I_PAIRS = 16 };

NAGATA3_API int n3i_pair_order(n3i_pair a, n3i_pair b)
{
    int order = n3i_order(a.n[0], b.n[0]);
    return order ? order : n3i_order(a.n[1], b.n[1]);
}

/* Into a list in order without repetition; returns its length. */
NAGATA3_API int n3i_insert(n3i_pair *list, int count, n3i_pair p)
{
    int i, place = count;
    while (place > 0 && n3i_pair_order(p, list[place - 1]) < 0) place--;
    if (place > 0 && n3i_pair_order(p, list[place - 1]) == 0) return count;
    if (place == N3I_PAIRS) return count;
    if (count < N3I_PAIRS) count++;
    for (i = count - 1; i > place; i--) list[i] = list[i - 1];
    list[place] = p;
    return count;
}

/* From the triangles that are not collapsed, if there are any; the end that is the point from
   first. */
NAGATA3_API int n3i_collect(const n3_mesh *m, const n3_topology *t, int edge, int from,
                            n3i_pair *list)
{
    int i, two[2], count = 0, live = n3i_live_sides(m, t, edge, two);
    for (i = t->first[edge]; i < t->first[edge + 1]; i++) {
        int s = t->side[i], back = n3i_at(m, s) != from;
        n3i_pair p;
        if (live && n3i_is_collapsed(m, s / 3)) continue;
        p.n[back] = n3i_corner_normal(m, s);
        p.n[!back] = n3i_corner_normal(m, n3i_after(s));
        count = n3i_insert(list, count, p);
    }
    return count;
}

/* The crosses of the pairs, turned along the chord e: their sum, as the crease, and the share that
   it has in the tangent. A crease more than 75 degrees off the chord fades out: its curve could
   only spike. */
NAGATA3_API n3i_joint n3i_joint_of_pairs(const n3_vec *n, int count, n3_vec e)
{
    n3i_joint joint;
    n3_real sine = 0, along;
    int i, k, opposed = 0;
    joint.n = joint.crease = n3_v(0, 0, 0);
    for (i = 0; i < count; i++)
        for (k = i + 1; k < count; k++) {
            n3_vec c = n3_cross(n[i], n[k]);
            sine = n3i_larger(sine, n3_len(c));
            if (n3_dot(n[i], n[k]) < 0) opposed = 1;
            joint.crease = n3_add(joint.crease, n3_dot(c, e) < 0 ? n3i_neg(c) : c);
        }
    joint.crease = n3_unit(joint.crease);
    joint.split = sine > N3_CREASE_LO;
    along = 16 * n3_dot(joint.crease, e) * n3_dot(joint.crease, e);
    joint.share = opposed ? 1 : (sine - N3_CREASE_LO) / (N3_CREASE_HI - N3_CREASE_LO);
    joint.share = n3i_larger(joint.share, 0);
    if (joint.share > 1) joint.share = 1;
    joint.share *= along < 1 ? along : 1;
    if (!joint.split) joint.share = 0;
    return joint;
}

/* From the normals of an end, in order: zero ones left out, equal ones taken once. On one tangent
   plane normals that look to its other side are turned; on several the sum may vanish, which
   leaves this end without a normal. */
NAGATA3_API n3i_joint n3i_joint_make(const n3i_pair *list, int count, int end, n3_vec e)
{
    n3_vec n[N3I_PAIRS], sum = n3_v(0, 0, 0);
    n3i_joint joint;
    int i, k, kept = 0;
    n[0] = sum;
    for (i = 0; i < count; i++) {
        n3_vec a = list[i].n[end];
        for (k = 0; k < kept && n3i_order(n[k], a) != 0; k++) continue;
        if (k == kept && !n3i_is_zero(a)) n[kept++] = a;
    }
    joint = n3i_joint_of_pairs(n, kept, e);
    for (i = 0; i < kept; i++)
        sum = n3_add(sum, !joint.split && n3_dot(n[i], n[0]) < 0 ? n3i_neg(n[i]) : n[i]);
    if (n3_len(sum) > N3_OPPOSITE) joint.n = kept == 1 ? n[0] : n3_unit(sum);
    return joint;
}

/* True if all triangles of an edge name these normals at these points. */
NAGATA3_API int n3i_same_names(const n3_mesh *m, const n3_topology *t, int edge, const int point[2],
                               const int normal[2])
{
    int i;
    for (i = t->first[edge]; i < t->first[edge + 1]; i++) {
        int s = t->side[i], down = n3i_at(m, s) != point[0];
        if (n3i_normal_at(m, s) != normal[down]) return 0;
        if (n3i_normal_at(m, n3i_after(s)) != normal[!down]) return 0;
    }
    return 1;
}

/* The points of an edge, the lower first, and the normals that all of its triangles name there, in
   the same order; false if they do not name the same. */
NAGATA3_API int n3i_common_ends(const n3_mesh *m, const n3_topology *t, int edge, int point[2],
                                int normal[2])
{
    int s = t->side[t->first[edge]], next = n3i_after(s);
    int a = n3i_at(m, s), b = n3i_at(m, next), down = a > b;
    point[0] = down ? b : a;
    point[1] = down ? a : b;
    normal[0] = n3i_normal_at(m, down ? next : s);
    normal[1] = n3i_normal_at(m, down ? s : next);
    return !m->corner || n3i_same_names(m, t, edge, point, normal);
}

/* An edge of the mesh with its ends in canonical order. */
typedef struct n3i_seam { int point[2]; n3_vertex end[2]; n3i_joint joint[2]; } n3i_seam;

NAGATA3_API void n3i_seam_of(const n3_mesh *m, const n3_topology *t, int edge, n3i_seam *seam)
{
    n3i_pair list[N3I_PAIRS];
    n3_vec e;
    int i, count, point[2], normal[2], common = n3i_common_ends(m, t, edge, point, normal);
    int back = n3i_order(n3i_point(m, point[0]), n3i_point(m, point[1])) > 0;
    memset(seam->joint, 0, sizeof seam->joint);
    for (i = 0; i < 2; i++) {
        seam->point[i] = point[i ^ back];
        seam->end[i].x = n3i_point(m, seam->point[i]);
        if (common) seam->end[i].n = seam->joint[i].n = n3i_normal_named(m, normal[i ^ back]);
    }
    if (common) return;
    e = n3_unit(n3_sub(seam->end[1].x, seam->end[0].x));
    count = n3i_collect(m, t, edge, seam->point[0], list);
    for (i = 0; i < 2; i++) {
        seam->joint[i] = n3i_joint_make(list, count, i, e);
        seam->end[i].n = seam->joint[i].n;
    }
}

/* The end of a curve over the chord L e that leaves it with the unit tangent t, clamped as the paper
   does. */
NAGATA3_API n3i_end n3i_end_of_tangent(n3_vec t, n3_vec e, n3_real L, const n3_options *o)
{
    n3_real cosine = n3_dot(t, e), sine = n3_len(n3_cross(t, e));
    n3i_end end;
    end.tan = sine < o->tan_hi * cosine ? sine / cosine : o->tan_hi;               /* (5.1.12) */
    end.tan = n3i_larger(end.tan, o->tan_lo);                                      /* (5.1.11) */
    end.reach = n3_mul(cosine >= (n3_real)1 / 2 ? 2 * L / 3 / cosine : 4 * L / 3, t);
    return end;
}

/* The unit tangents at the ends of the seam: those of the rule, from an edge that begins in the
   origin so that no digits are lost to where it lies, each turned into its crease by its share. */
NAGATA3_API void n3i_seam_tangents(const n3i_seam *seam, const n3_options *o, n3_vec tangent[2])
{
    n3_vertex a = seam->end[0], b = seam->end[1];
    n3_edge c;
    int i;
    b.x = n3_sub(b.x, a.x);
    a.x = n3_v(0, 0, 0);
    c = n3_edge_make(a, b, o);
    tangent[0] = n3_unit(c.p[1]);
    tangent[1] = n3_unit(n3_sub(c.p[3], c.p[2]));
    for (i = 0; i < 2; i++) {
        n3_real w = seam->joint[i].share;
        n3_vec turn = n3_mul(w, seam->joint[i].crease);
        if (w > 0) tangent[i] = n3_unit(n3_add(n3_mul(1 - w, tangent[i]), turn));
    }
}

/* Where an end is a crease both handles are computed anew for the tangents: by the paper as ever,
   by the arc rule (2 L / 3) / (1 + cos a) with |t0 + t1| = 2 cos a. */
NAGATA3_API n3_edge n3i_seam_edge(const n3i_seam *seam, const n3_options *given)
{
    n3_options o = n3i_defaults(given);
    n3_vec x0 = seam->end[0].x, x1 = seam->end[1].x, t[2], ds, de, e;
    n3_real L, arc;
    if (!(seam->joint[0].share > 0) && !(seam->joint[1].share > 0))
        return n3_edge_make(seam->end[0], seam->end[1], given);
    n3i_seam_tangents(seam, given, t);
    e = n3i_direction(n3_sub(x1, x0), &L);
    if (n3i_is_arc(&o)) {
        arc = 2 * L / 3 / (1 + n3_len(n3_add(t[0], t[1])) / 2);
        ds = n3_mul(arc, t[0]);
        de = n3_mul(arc, t[1]);
    } else {
        n3i_end start = n3i_end_of_tangent(t[0], e, L, &o);
        n3i_end stop = n3i_end_of_tangent(t[1], e, L, &o);
        ds = n3i_handle(start, stop);                                              /* (5.1.13) */
        de = n3i_handle(stop, start);                                              /* (5.1.14) */
    }
    return n3i_edge_of(x0, n3_add(x0, ds), n3_sub(x1, de), x1);
}

/* The bits that the shape of an edge gives. */
NAGATA3_API unsigned n3i_shape_flags(const n3i_seam *seam, const n3_options *given)
{
    n3_options o = n3i_defaults(given);
    n3_vec e = n3_unit(n3_sub(seam->end[1].x, seam->end[0].x)), t[2], bend[2];
    unsigned flags = 0;
    int i;
    if (n3i_is_zero(e)) return N3_EDGE_DEGENERATE;
    n3i_seam_tangents(seam, given, t);
    for (i = 0; i < 2; i++) bend[i] = n3_cross(e, t[i]);
    if (n3_len(bend[0]) <= N3_NOISE && n3_len(bend[1]) <= N3_NOISE) return N3_EDGE_STRAIGHT;
    if (n3_dot(bend[0], bend[1]) > 0 && n3_len(bend[0]) > N3_CREASE_LO &&
        n3_len(bend[1]) > N3_CREASE_LO)
        flags |= N3_EDGE_S_SHAPED;
    if (n3i_is_arc(&o)) return flags;
    if (n3_dot(n3_cross(e, seam->end[0].n), n3_cross(e, seam->end[1].n)) < 0)
        flags |= N3_EDGE_TURNED;
    for (i = 0; i < 2; i++) {
        n3_real cosine = n3_dot(t[i], e), sine = n3_len(bend[i]);
        if (sine > o.tan_hi * cosine || sine < o.tan_lo * cosine) flags |= N3_EDGE_CLAMPED;
        if (cosine < (n3_real)1 / 2) flags |= N3_EDGE_BRANCH_60;
    }
    return flags;
}

/* The bits that its triangles give. */
NAGATA3_API unsigned n3i_face_flags(const n3_mesh *m, const n3_topology *t, int edge)
{
    int two[2], live = n3i_live_sides(m, t, edge, two);
    if (live == 1) return N3_EDGE_BORDER;
    if (live > 2) return N3_EDGE_NON_MANIFOLD;
    return live == 2 && n3i_at(m, two[0]) == n3i_at(m, two[1]) ? N3_EDGE_FLIPPED : 0;
}

NAGATA3_API unsigned n3i_seam_flags(const n3i_seam *seam, const n3_options *o)
{
    int split = seam->joint[0].split + seam->joint[1].split;
    unsigned crease = split == 2 ? N3_EDGE_CREASE : split == 1 ? N3_EDGE_HALF_CREASE : 0;
    return crease | n3i_shape_flags(seam, o);
}

/* A chord's row of the fit, [x^3, s x^2 y, s x y^2, y^3 | -6 <d, n0 + n1>], s = sqrt 3, enters the
   normal equations. Lengths are in units of size. */
NAGATA3_API void n3i_fit_chord(n3_vertex p, n3_vertex q, const n3_vec frame[2], n3_real size,
                               n3_real A[4][5])
{
    n3_vec d = n3i_over(n3_sub(q.x, p.x), size), sum = n3_add(p.n, q.n);
    n3_real x = n3_dot(d, frame[0]), y = n3_dot(d, frame[1]), s = n3i_sqrt(3), row[5];
    int i, k;
    if (n3_dot(sum, sum) <= N3_OPPOSITE * N3_OPPOSITE) return;
    row[0] = x * x * x;
    row[1] = s * x * x * y;
    row[2] = s * x * y * y;
    row[3] = y * y * y;
    row[4] = -6 * n3_dot(d, sum);
    for (i = 0; i < 4; i++)
        for (k = 0; k < 5; k++) A[i][k] += row[i] * row[k];
}

/* The second unknown of four; the ridge keeps the pivots above zero, but where all underflows. With
   1e-3 it would hold the normals on a saddle to second order; with 1e-5 it fails on stretched
   meshes. The right sides take n0 + n1 as it stands, not made unit, so that a chord over which the
   normals turn far counts less. */
NAGATA3_API n3_real n3i_fit_solve(n3_real A[4][5])
{
    static const int order[4] = {0, 2, 3, 1};
    n3_real trace = A[0][0] + A[1][1] + A[2][2] + A[3][3];
    int i, j, k;
    if (!(trace > N3I_LEAST_SQUARE)) return 0;
    for (i = 0; i < 4; i++) A[i][i] += trace / 4 / 10000;
    for (i = 0; i < 3; i++)
        for (j = i + 1; j < 4; j++) {
            int p = order[i], r = order[j];
            n3_real factor = A[r][p] / A[p][p];
            for (k = 0; k < 5; k++) A[r][k] -= factor * A[p][k];
        }
    return A[1][4] / A[1][1];
}

NAGATA3_API n3_vec n3_edge_mid_normal(n3_vertex a, n3_vertex b, n3_vertex c, n3_vertex d)
{
    n3_vertex v[4];
    n3_vec m, ab, frame[2];
    n3_real size = 0, slope, part, A[4][5] = {{0}};
    int i, k, swapped = n3i_sort_ends(&a, &b);
    v[0] = a;
    v[1] = b;
    v[2] = swapped ? d : c;
    v[3] = swapped ? c : d;
    m = n3_unit(n3_add(a.n, b.n));
    ab = n3_sub(b.x, a.x);
    frame[1] = n3_unit(n3_cross(m, n3_unit(ab)));
    frame[0] = n3_cross(frame[1], m);
    for (i = 1; i < 4; i++) size = n3i_larger(size, n3i_largest(n3_sub(v[i].x, a.x)));
    if (!(size > 0)) return m;
    for (i = 0; i < 4; i++)
        for (k = i + 1; k < 4; k++) n3i_fit_chord(v[i], v[k], frame, size, A);
    part = n3_len(ab) / size;
    slope = n3i_fit_solve(A) / n3i_sqrt(3) * part * part / 8;
    if (slope > (n3_real)1 / 4) slope = (n3_real)1 / 4;
    if (slope < -(n3_real)1 / 4) slope = -(n3_real)1 / 4;
    return n3_add(m, n3_mul(slope, frame[1]));
}

NAGATA3_API n3_vertex n3i_corner(const n3_mesh *m, int c)
{
    n3_vertex v;
    v.x = n3i_point(m, n3i_at(m, c));
    v.n = n3i_corner_normal(m, c);
    return v;
}

/* The wanted normal at the middle of a side: fitted at an edge of two triangles on one tangent
   plane, and then the same from both; else the sum of the ends'. */
NAGATA3_API n3_vec n3i_side_mid(const n3_mesh *m, const n3_topology *t, int s)
{
    int edge = t->edge[s], two[2], back;
    n3_vec sum = n3_add(n3i_corner_normal(m, s), n3i_corner_normal(m, n3i_after(s)));
    n3i_seam seam;
    if (edge < 0 || !n3i_is_regular(m, t, edge, two)) return sum;
    n3i_seam_of(m, t, edge, &seam);
    if (seam.joint[0].split || seam.joint[1].split) return sum;
    back = n3i_at(m, two[0]) != seam.point[0];
    return n3_edge_mid_normal(seam.end[0], seam.end[1],
                              n3i_corner(m, n3i_after(n3i_after(two[back]))),
                              n3i_corner(m, n3i_after(n3i_after(two[!back]))));
}

/* The centre by the arc rules. */
NAGATA3_API n3_vec n3i_mesh_centre(const n3_mesh *m, const n3_topology *t, const n3_options *o,
                                   const n3_vec *net, int triangle)
{
    n3_edge e[3];
    n3_patch p;
    n3_vec n[3], mid[3];
    int i, node[10];
    n3_mesh_patch_nodes(m, t, triangle, node);
    for (i = 0; i < 9; i++) p.p[i] = net[node[i]];
    n3_patch_edges(&p, e);
    for (i = 0; i < 3; i++) n[i] = n3i_corner_normal(m, 3 * triangle + i);
    if (o->rule != N3_RULE_FIT) return n3_patch_centre_arc(&e[0], &e[1], &e[2], n, NULL);
    for (i = 0; i < 3; i++) mid[i] = n3i_side_mid(m, t, 3 * triangle + i);
    return n3_patch_centre_arc(&e[0], &e[1], &e[2], n, mid);
}

/* Edges on their way through wide numbers, a row for each number: x and n of the lower point, then of
   the higher, from either of which the rules give the same bits; b, across the chord and as long; p,
   the control point next to the one, then to the other. same: the triangles name the same normals.
   ok: the lanes that need no plain form. */
enum { N3I_GROUP = 32 };
typedef n3_real n3i_rows[3][N3I_GROUP];
typedef struct n3i_group {
    n3i_rows x[2], n[2], b, p[2];
    int point[2][N3I_GROUP], normal[2][N3I_GROUP], same[N3I_GROUP];
    n3i_mask ok[(int)N3I_GROUP / (int)N3I_WIDTH];
} n3i_group;

N3I_WIDE_API n3i_wide_vec n3i_from_rows(n3i_rows row, int first)
{
    n3i_wide_vec a;
    memcpy(&a.x, row[0] + first, sizeof a.x);
    memcpy(&a.y, row[1] + first, sizeof a.y);
    memcpy(&a.z, row[2] + first, sizeof a.z);
    return a;
}

N3I_WIDE_API void n3i_to_rows(n3i_wide_vec a, n3i_rows row, int first)
{
    memcpy(row[0] + first, &a.x, sizeof a.x);
    memcpy(row[1] + first, &a.y, sizeof a.y);
    memcpy(row[2] + first, &a.z, sizeof a.z);
}

/* Vectors into three rows; index -1: zero. */
NAGATA3_API void n3i_group_vectors(const n3_real *base, size_t stride, const int *index, int count,
                                   n3i_rows row)
{
    static const n3_real zero[3] = {0, 0, 0};
    int i, c;
    for (i = 0; i < count; i++) {
        const char *from = (const char *)zero;
        if (index[i] >= 0) from = n3i_vec_place(base, stride, index[i]);
        for (c = 0; c < 3; c++) row[c][i] = n3i_real_at(from, c);
    }
}

/* count edges from first on, the last one again to fill N3I_WIDTH. */
NAGATA3_API void n3i_group_ends(const n3_mesh *m, const n3_topology *t, int first, int count,
                                n3i_group *group)
{
    int i, k, point[2], normal[2], filled = (count + N3I_WIDTH - 1) / N3I_WIDTH * N3I_WIDTH;
    for (i = 0; i < filled; i++) {
        int edge = first + (i < count ? i : count - 1);
        group->same[i] = n3i_common_ends(m, t, edge, point, normal);
        for (k = 0; k < 2; k++) {
            group->point[k][i] = point[k];
            group->normal[k][i] = normal[k];
        }
    }
    for (k = 0; k < 2; k++) {
        n3i_group_vectors(m->point, m->point_stride, group->point[k], filled, group->x[k]);
        n3i_group_vectors(m->normal, m->normal_stride, group->normal[k], filled, group->n[k]);
    }
}

/* n3i_made_unit. */
NAGATA3_API void n3i_group_normals(n3i_group *group, int count)
{
    int i, k;
    for (i = 0; i < count; i += N3I_WIDTH) {
        n3i_mask *ok = &group->ok[i / N3I_WIDTH];
        n3i_wide one = n3i_wide_of(1), length;
        *ok = (n3i_mask)(one <= one);
        for (k = 0; k < 2; k++) {
            n3i_wide_vec n = n3i_from_rows(group->n[k], i);
            n3i_mask is_unit = (n3i_mask)(n3i_wide_abs(n3i_wide_dot(n, n) - one) <= 8 * N3_EPS);
            if (n3i_all(is_unit)) continue;
            n = n3i_wide_pick(is_unit, n, n3i_wide_unit(n, &length, ok));
            n3i_to_rows(n, group->n[k], i);
        }
    }
}

/* What the paper's rule needs first: two short loops, of which the processor does several rounds at
   once, and not one long one. */
NAGATA3_API void n3i_group_across(n3i_group *group, int count)
{
    int i;
    for (i = 0; i < count; i += N3I_WIDTH) {
        n3i_wide_vec x0 = n3i_from_rows(group->x[0], i), x1 = n3i_from_rows(group->x[1], i);
        n3i_wide_vec n0 = n3i_from_rows(group->n[0], i), n1 = n3i_from_rows(group->n[1], i);
        n3i_wide_vec d = n3i_wide_sub(x1, x0);
        n3i_to_rows(n3i_wide_across(d, n0, n1, &group->ok[i / N3I_WIDTH]), group->b, i);
    }
}

NAGATA3_API void n3i_group_edges(n3i_group *group, int count, const n3_options *o)
{
    int i, k;
    for (i = 0; i < count; i += N3I_WIDTH) {
        n3i_wide_vertex v[2];
        n3i_wide_vec p[2];
        for (k = 0; k < 2; k++) {
            v[k].x = n3i_from_rows(group->x[k], i);
            v[k].n = n3i_from_rows(group->n[k], i);
        }
        if (n3i_is_arc(o)) n3i_wide_edge_arc(v[0], v[1], p, &group->ok[i / N3I_WIDTH]);
        else n3i_wide_edge_paper(v[0], v[1], n3i_from_rows(group->b, i), o, p);
        for (k = 0; k < 2; k++) n3i_to_rows(p[k], group->p[k], i);
    }
}

/* An edge whose triangles do not agree, or that is a case of its own. */
NAGATA3_API void n3i_edge_apart(const n3i_seam *seam, const n3_options *o, n3_vec handle[2])
{
    n3_edge e = n3i_seam_edge(seam, o);
    int back = seam->point[0] > seam->point[1];
    handle[back] = e.p[1];
    handle[!back] = e.p[2];
}

NAGATA3_API void n3_mesh_edges(const n3_mesh *m, const n3_topology *t, const n3_options *given,
                               int first, int last, n3_vec *net, unsigned *flags)
{
    n3_options o = n3i_defaults(given);
    n3i_group group;
    int i, k;
    for (; first < last; first += N3I_GROUP) {
        int count = last - first < N3I_GROUP ? last - first : N3I_GROUP;
        n3i_group_ends(m, t, first, count, &group);
        n3i_group_normals(&group, count);
        if (!n3i_is_arc(&o)) n3i_group_across(&group, count);
        n3i_group_edges(&group, count, &o);
        for (i = 0; i < count; i++) {
            n3_vec *handle = net + m->points + 2 * (first + i);
            int exact = group.same[i] && n3i_lane(group.ok[i / N3I_WIDTH], i % N3I_WIDTH);
            n3i_seam seam;
            for (k = 0; k < 2; k++)
                handle[k] = n3_v(group.p[k][0][i], group.p[k][1][i], group.p[k][2][i]);
            if (exact && !flags) continue;
            n3i_seam_of(m, t, first + i, &seam);
            if (!exact) n3i_edge_apart(&seam, given, handle);
            if (flags)
                flags[first + i] = n3i_seam_flags(&seam, given) | n3i_face_flags(m, t, first + i);
        }
    }
}

/* Centres of the arc rule, of triangles first up to last, at most N3I_WIDTH. The rows are those of
   n3i_wide_centre_arc: the sides' control points, the normals of the corners, and of the sides. */
NAGATA3_API void n3i_arc_centres(const n3_mesh *m, const n3_topology *t, const n3_options *o,
                                 int first, int last, n3_vec *net)
{
    n3_vec row[N3I_WIDTH][15], *centre = net + m->points + 2 * t->edges;
    const n3_real *from[N3I_WIDTH];
    n3_real *to[N3I_WIDTH];
    n3i_wide_vec v[15];
    n3i_mask ok;
    int i, k, node[10];
    for (i = 0; i < N3I_WIDTH; i++) {
        int f = first + i < last ? first + i : first;
        n3_mesh_patch_nodes(m, t, f, node);
        for (k = 0; k < 9; k++) row[i][k] = net[node[k]];
        for (k = 0; k < 3; k++) row[i][9 + k] = n3i_corner_normal(m, 3 * f + k);
        for (k = 0; k < 3; k++)
            row[i][12 + k] = o->rule == N3_RULE_FIT
                                 ? n3i_side_mid(m, t, 3 * f + k)
                                 : n3_add(row[i][9 + k], row[i][9 + (k + 1) % 3]);
        from[i] = &row[i][0].x;
        to[i] = &centre[f].x;
    }
    n3i_load(from, 45, &v[0].x);
    ok = (n3i_mask)(v[0].x <= v[0].x);
    v[0] = n3i_wide_centre_arc(v, v + 9, v + 12, &ok);
    n3i_store(&v[0].x, 3, to, 0);
    for (i = 0; i < N3I_WIDTH && first + i < last; i++)
        if (!n3i_lane(ok, i)) centre[first + i] = n3i_mesh_centre(m, t, o, net, first + i);
}

NAGATA3_API void n3_mesh_centres(const n3_mesh *m, const n3_topology *t, const n3_options *o,
                                 int first, int last, n3_vec *net)
{
    int node[10];
    for (; n3i_is_arc(o) && first < last; first += N3I_WIDTH)
        n3i_arc_centres(m, t, o, first, last - first < N3I_WIDTH ? last : first + N3I_WIDTH, net);
    for (; first < last; first++) {
        n3_mesh_patch_nodes(m, t, first, node);
        net[node[9]] = n3i_centre(net, node);
    }
}

NAGATA3_API int n3_mesh_nodes(const n3_mesh *m, const n3_topology *t)
{
    int inner = n3i_count_add(n3i_count_mul(2, t->edges), m->triangles);
    int nodes = n3i_count_add(m->points, inner);
    return nodes < 0 ? 0 : nodes;
}

NAGATA3_API n3_status n3_mesh_net(const n3_mesh *m, const n3_topology *t, const n3_options *o,
                                  n3_vec *net, unsigned *flags, int *item)
{
    n3_status status = n3i_check(m, t, item);
    int i, nodes;
    if (status != N3_OK) return status;
    nodes = n3_mesh_nodes(m, t);
    if (nodes < m->points) return n3i_blame(N3_BAD_COUNT, -1, item);
    if (nodes > 0 && !net) return n3i_blame(N3_NULL_POINTER, -1, item);
    for (i = 0; i < m->points; i++) net[i] = n3i_point(m, i);
    n3_mesh_edges(m, t, o, 0, t->edges, net, flags);
    n3_mesh_centres(m, t, o, 0, m->triangles, net);
    return N3_OK;
}

NAGATA3_API void n3_mesh_patch_nodes(const n3_mesh *m, const n3_topology *t, int triangle,
                                     int node[10])
{
    int i;
    n3i_corners(m, triangle, node);
    for (i = 0; i < 3; i++) {
        int a = node[i], edge = t->edge[3 * triangle + i], back = a > node[(i + 1) % 3];
        node[3 + 2 * i] = edge < 0 ? a : m->points + 2 * edge + back;
        node[4 + 2 * i] = edge < 0 ? a : m->points + 2 * edge + !back;
    }
    node[9] = m->points + 2 * t->edges + triangle;
}

NAGATA3_API void n3_mesh_patches(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                 int first, int last, n3_patch *out)
{
    int f, i, node[10];
    for (f = first; f < last; f++, out++) {
        n3_mesh_patch_nodes(m, t, f, node);
        for (i = 0; i < 10; i++) out->p[i] = net[node[i]];
    }
}

NAGATA3_API n3_patch n3i_mesh_patch(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                    int triangle)
{
    n3_patch p;
    n3_mesh_patches(m, t, net, triangle, triangle + 1, &p);
    return p;
}

/* ---- Definitions: patches at once ---- */

/* Points inside a patch; with level + 3, all. */
NAGATA3_API int n3i_inside(int level)
{
    int square = level < 3 ? 0 : n3i_count_mul(level - 1, level - 2);
    return square < 0 ? -1 : square / 2;
}

/* The numbers u and v of the point at i, j; on bc so that 1 - u - v is exactly 0. */
NAGATA3_API void n3i_lattice_uv(int level, int i, int j, n3_real *u, n3_real *v)
{
    *u = (n3_real)i / (n3_real)level;
    *v = i + j == level ? 1 - *u : (n3_real)j / (n3_real)level;
}

/* Where the points of N3I_WIDTH lattices go, from at on. Blocks are written in place. Rows, one
   for each lane, are held until there are enough to be turned: held[begin] and on belong to
   to[lane] and on. They leave in whole units, of a vector or of a line of the caches, which all
   lanes begin at the same number. past: past the caches. */
enum { N3I_ROW = 62, N3I_HELD = 384, N3I_FULL = N3I_HELD - 3 * (N3I_ROW + 2) };
typedef struct n3i_sink {
    n3_real *at, *to[N3I_WIDTH];
    n3i_wide held[N3I_HELD];
    int begin, unit, past;
} n3i_sink;

/* Writes what is held up to end. */
N3I_WIDE_API void n3i_write(n3i_sink *s, int end, int past)
{
    int i;
    n3i_store(s->held + s->begin, end - s->begin, s->to, past);
    for (i = 0; i < N3I_WIDTH; i++) s->to[i] += end - s->begin;
    s->begin = end;
}

/* Writes whole units, or all; returns where to go on. */
NAGATA3_API n3_real *n3i_flush(n3i_sink *s, const n3_real *at, int all)
{
    n3_real *start = (n3_real *)(void *)s->held;
    int i, last = (int)(at - start) / N3I_WIDTH, end = last / s->unit * s->unit;
    if (s->begin % s->unit != 0 && end > 0) n3i_write(s, s->unit, 0);
    if (s->begin < end && s->past) n3i_write(s, end, 1);
    if (s->begin < end) n3i_write(s, end, 0);
    if (s->begin < last && all) n3i_write(s, last, 0);
    for (i = 0; i < last - end; i++) s->held[i] = s->held[end + i];
    s->begin = 0;
    return start + (last - end) * N3I_WIDTH;
}

/* Makes room for N3I_ROW points and two more. */
N3I_WIDE_API n3_real *n3i_room(n3i_sink *s, n3_real *at, int blocks)
{
    if (blocks || at <= (n3_real *)(void *)(s->held + N3I_FULL)) return at;
    return n3i_flush(s, at, 0);
}

/* Numbers from a point's x to its y, to its z, and to the next point's x. */
#define N3I_STEP(blocks) ((blocks) ? N3_BLOCK : (int)N3I_WIDTH)

N3I_WIDE_API n3_real *n3i_put(const n3i_sink *s, n3_real *at, n3i_wide_vec x, int blocks)
{
    const int step = N3I_STEP(blocks);
    if (blocks && s->past) {
        N3I_PAST(at, x.x);
        N3I_PAST(at + step, x.y);
        N3I_PAST(at + 2 * step, x.z);
    } else {
        memcpy(at, &x.x, sizeof x.x);
        memcpy(at + step, &x.y, sizeof x.y);
        memcpy(at + 2 * step, &x.z, sizeof x.z);
    }
    return at + 3 * step;
}

/* s a + b, a step of Horner's. */
N3I_WIDE_API n3i_wide_vec n3i_wide_step(n3i_wide_vec a, n3i_wide s, n3i_wide_vec b)
{
    return n3i_wide_v(s * a.x + b.x, s * a.y + b.y, s * a.z + b.z);
}

/* The point at i / level of an edge, from its canonical end or, where there is none, the nearer. */
NAGATA3_API n3_vec n3i_side_point(n3_edge e, int i, int level)
{
    int order = n3i_edge_order(&e);
    if (order ? order > 0 : 2 * i > level) {
        e = n3_edge_reverse(&e);
        i = level - i;
    }
    return n3_edge_point(&e, (n3_real)i / (n3_real)level);
}

/* A side with its control points from the canonical end, and whether that is not its first. */
typedef struct n3i_wide_side { n3i_wide_vec p[4]; n3i_mask back; } n3i_wide_side;

/* A side whose ends are in two places; others are not ok. */
N3I_WIDE_API n3i_wide_side n3i_wide_side_of(n3i_wide_vec p0, n3i_wide_vec p1, n3i_wide_vec p2,
                                            n3i_wide_vec p3, n3i_mask *ok)
{
    n3i_wide_vec d = n3i_wide_sub(p3, p0);
    n3i_wide way = n3i_pick((n3i_mask)(d.y < 0) | (n3i_mask)(d.y > 0), d.y, d.z);
    n3i_wide_side s;
    n3i_mask back;
    way = n3i_pick((n3i_mask)(d.x < 0) | (n3i_mask)(d.x > 0), d.x, way);
    back = (n3i_mask)(way < 0); /* n3i_order(p0, p3) > 0 */
    *ok &= back | (n3i_mask)(way > 0);
    s.p[0] = n3i_wide_pick(back, p3, p0);
    s.p[1] = n3i_wide_pick(back, p2, p1);
    s.p[2] = n3i_wide_pick(back, p1, p2);
    s.p[3] = n3i_wide_pick(back, p0, p3);
    s.back = back;
    return s;
}

/* The weights of n3_edge_point, (5.1.1). */
typedef struct n3i_wide_weights { n3i_wide b[4]; } n3i_wide_weights;

N3I_WIDE_API n3i_wide_weights n3i_wide_weights_at(n3i_wide r)
{
    n3i_wide s = 1 - r;
    n3i_wide_weights w;
    w.b[0] = s * s * s;
    w.b[1] = 3 * s * s * r;
    w.b[2] = 3 * s * r * r;
    w.b[3] = r * r * r;
    return w;
}

/* All of them at i / level, of a level below N3I_WEIGHTS: what the points of all sides share. */
enum { N3I_WEIGHTS = 33 };

NAGATA3_API void n3i_all_weights(int level, n3i_wide_weights w[N3I_WEIGHTS])
{
    int i;
    for (i = 0; i <= level && i < N3I_WEIGHTS; i++)
        w[i] = n3i_wide_weights_at(n3i_wide_of((n3_real)i / (n3_real)level));
}

/* n3i_side_point */
N3I_WIDE_API n3i_wide_vec n3i_wide_side_point(const n3i_wide_side *side, int i, int level,
                                              const n3i_wide_weights *w)
{
    n3i_wide_weights at;
    int k;
    if (level < N3I_WEIGHTS)
        N3I_UNROLL
        for (k = 0; k < 4; k++) at.b[k] = n3i_pick(side->back, w[level - i].b[k], w[i].b[k]);
    else
        at = n3i_wide_weights_at(n3i_pick(side->back,
                                          n3i_wide_of((n3_real)(level - i) / (n3_real)level),
                                          n3i_wide_of((n3_real)i / (n3_real)level)));
    return n3i_wide_add(
        n3i_wide_add(n3i_wide_mul(at.b[0], side->p[0]), n3i_wide_mul(at.b[1], side->p[1])),
        n3i_wide_add(n3i_wide_mul(at.b[2], side->p[2]), n3i_wide_mul(at.b[3], side->p[3])));
}

/* The coefficients of w^i u^k in steps of h, i + 4 k - k (k - 1)/2 counting rows of constant k:
   3!/(i! k! (3 - i - k)!) h^(i+k) times differences of the net at p030. */
N3I_WIDE_API void n3i_wide_powers(const n3i_wide_vec q[10], n3_real h, n3i_wide_vec c[10])
{
    n3i_wide h1 = n3i_wide_of(3 * h), h2 = n3i_wide_of(3 * h * h), h3 = n3i_wide_of(h * h * h);
    n3i_wide_vec w0 = n3i_wide_sub(q[7], q[2]), u0 = n3i_wide_sub(q[6], q[2]);
    n3i_wide_vec w1 = n3i_wide_sub(q[8], q[7]), u1 = n3i_wide_sub(q[5], q[6]);
    n3i_wide_vec w2 = n3i_wide_sub(q[0], q[8]), u2 = n3i_wide_sub(q[1], q[5]);
    n3i_wide_vec a = n3i_wide_sub(q[9], q[6]), b = n3i_wide_sub(q[9], q[7]);
    n3i_wide_vec ww = n3i_wide_sub(w1, w0), uu = n3i_wide_sub(u1, u0);
    n3i_wide_vec wwu = n3i_wide_sub(n3i_wide_sub(n3i_wide_sub(q[3], q[9]), a), ww);
    n3i_wide_vec wuu = n3i_wide_sub(n3i_wide_sub(n3i_wide_sub(q[4], q[9]), b), uu);
    c[0] = q[2];
    c[1] = n3i_wide_mul(h1, w0);
    c[2] = n3i_wide_mul(h2, ww);
    c[3] = n3i_wide_mul(h3, n3i_wide_sub(n3i_wide_sub(w2, w1), ww));
    c[4] = n3i_wide_mul(h1, u0);
    c[5] = n3i_wide_mul(2 * h2, n3i_wide_sub(a, w0));
    c[6] = n3i_wide_mul(3 * h3, wwu);
    c[7] = n3i_wide_mul(h2, uu);
    c[8] = n3i_wide_mul(3 * h3, wuu);
    c[9] = n3i_wide_mul(h3, n3i_wide_sub(n3i_wide_sub(u2, u1), uu));
}

/* Those of e^i s^k, e = u - w and s = u + w: rows of constant v go to both sides of e = 0. */
N3I_WIDE_API void n3i_wide_centred(const n3i_wide_vec q[10], int level, n3i_wide_vec c[10])
{
    n3i_wide three = n3i_wide_of(3);
    n3i_wide_vec a[2], b[2], d[2], w;
    n3i_wide_powers(q, 1 / (2 * (n3_real)level), c);
    w = c[1];
    a[0] = n3i_wide_add(c[7], c[2]);
    a[1] = n3i_wide_sub(c[7], c[2]);
    b[0] = n3i_wide_add(c[9], c[3]);
    b[1] = n3i_wide_sub(c[9], c[3]);
    d[0] = n3i_wide_add(c[8], c[6]);
    d[1] = n3i_wide_sub(c[8], c[6]);
    c[1] = n3i_wide_sub(c[4], w);
    c[2] = n3i_wide_sub(a[0], c[5]);
    c[3] = n3i_wide_sub(b[1], d[1]);
    c[4] = n3i_wide_add(c[4], w);
    c[7] = n3i_wide_add(a[0], c[5]);
    c[5] = n3i_wide_add(a[1], a[1]);
    c[6] = n3i_wide_sub(n3i_wide_mul(three, b[0]), d[0]);
    c[8] = n3i_wide_add(n3i_wide_mul(three, b[1]), d[1]);
    c[9] = n3i_wide_add(b[0], d[0]);
}

/* One over the size of the patch, the root of the sum of squares of the ways from p003. */
N3I_WIDE_API n3i_wide n3i_wide_inverse_size(const n3i_wide_vec q[10], n3i_mask *ok)
{
    n3i_wide size = n3i_wide_of(0);
    n3i_mask some;
    int i;
    for (i = 1; i < 10; i++) {
        n3i_wide_vec d = n3i_wide_sub(q[i], q[0]);
        size += n3i_wide_dot(d, d);
    }
    some = (n3i_mask)(size > 0);
    *ok &= some;
    return 1 / n3i_wide_sqrt(n3i_pick(some, size, n3i_wide_of(1)));
}

/* In a patch of this size 1 a product du x dv that is longer makes the normal: its direction has
   half its digits (float: two thirds) at least. */
#define N3I_CLEAR (N3I_PICK((n3_real)1 / 1048576, (n3_real)1 / 512))

/* The unit normal along du x dv, if the square of that is above least; the lowest square. */
N3I_WIDE_API n3i_wide_vec n3i_wide_facing(n3i_wide_vec du, n3i_wide_vec dv, n3i_wide least,
                                          n3i_wide *lowest)
{
    n3i_wide_vec n = n3i_wide_cross(du, dv);
    n3i_wide nn = n3i_wide_dot(n, n);
    *lowest = n3i_pick((n3i_mask)(*lowest < nn), *lowest, nn);
    return n3i_wide_mul(1 / n3i_wide_sqrt(n3i_wide_larger(least, nn)), n);
}

/* The unit normal where du x dv is longer than clear; others are not ok. */
N3I_WIDE_API n3i_wide_vec n3i_wide_normal(n3i_wide_vec du, n3i_wide_vec dv, n3_real clear,
                                          n3i_mask *ok)
{
    n3i_wide least = n3i_wide_of(clear * clear), lowest = n3i_wide_of(1);
    n3i_wide_vec n = n3i_wide_facing(du, dv, least, &lowest);
    *ok &= (n3i_mask)(lowest > least);
    return n;
}

/* What a row shares: its points are f0 + e f1 + e^2 f2 + e^3 f3. Or its normals are the products of
   f0 + e f1 + e^2 f2 and the same of g; the least square of one that is clear, the lowest found. */
typedef struct n3i_wide_row { n3i_wide_vec f[4], g[3]; n3i_wide least, lowest; } n3i_wide_row;

/* even - e odd on the one side of a row's middle, even + e odd on the other */
N3I_WIDE_API n3i_wide_vec n3i_wide_aside(n3i_wide_vec even, n3i_wide e, n3i_wide_vec odd, int side)
{
    odd = n3i_wide_mul(e, odd);
    return side < 0 ? n3i_wide_sub(even, odd) : n3i_wide_add(even, odd);
}

N3I_WIDE_API n3i_wide_vec n3i_wide_row_point(const n3i_wide_row *r, n3i_wide e, int side)
{
    n3i_wide ee = e * e;
    if (side == 0) return r->f[0];
    return n3i_wide_aside(n3i_wide_step(r->f[2], ee, r->f[0]), e,
                          n3i_wide_step(r->f[3], ee, r->f[1]), side);
}

N3I_WIDE_API n3i_wide_vec n3i_wide_row_normal(n3i_wide_row *r, n3i_wide e, int side)
{
    n3i_wide ee = e * e;
    n3i_wide_vec a = r->f[0], b = r->g[0];
    if (side) a = n3i_wide_aside(n3i_wide_step(r->f[2], ee, a), e, r->f[1], side);
    if (side) b = n3i_wide_aside(n3i_wide_step(r->g[2], ee, b), e, r->g[1], side);
    return n3i_wide_facing(a, b, r->least, &r->lowest);
}

N3I_WIDE_API n3i_wide_vec n3i_wide_row_at(n3i_wide_row *r, n3i_wide e, int side, int normals)
{
    return normals ? n3i_wide_row_normal(r, e, side) : n3i_wide_row_point(r, e, side);
}

/* Puts it at e = 1 - count, 3 - count, ... count - 1: from both ends, so that e and -e share the
   parts, where the row can be held. */
N3I_WIDE_API n3_real *n3i_wide_row_all(n3i_wide_row *r, int count, int normals, n3i_sink *s,
                                       n3_real *at, int blocks)
{
    const int step = 3 * N3I_STEP(blocks);
    n3_real *end = at + step * count;
    n3i_wide e = n3i_wide_of((n3_real)(count - 1));
    if (count > N3I_ROW && !blocks) {
        for (; count > 0; count--, e -= 2) {
            if (count % N3I_ROW == 0) at = n3i_room(s, at, blocks);
            at = n3i_put(s, at, n3i_wide_row_at(r, e, -1, normals), blocks);
        }
        return at;
    }
    for (; count > 1; count -= 2, e -= 2) {
        at = n3i_put(s, at, n3i_wide_row_at(r, e, -1, normals), blocks);
        n3i_put(s, at + step * (count - 2), n3i_wide_row_at(r, e, 1, normals), blocks);
    }
    if (count == 1) n3i_put(s, at, n3i_wide_row_at(r, e, 0, normals), blocks);
    return end;
}

/* The points of a lattice, or those inside it alone, in rows of constant v = j / level. */
N3I_WIDE_API n3i_mask n3i_wide_lattice(const n3i_wide_vec q[10], int level, int inside,
                                       const n3i_wide_weights *w, n3i_sink *sink, int blocks)
{
    n3i_wide s = n3i_wide_of((n3_real)level);
    n3i_wide_vec c[10];
    n3i_wide_row row;
    n3i_mask ok = (n3i_mask)(s > 0);
    n3i_wide_side ab = n3i_wide_side_of(q[0], q[3], q[4], q[1], &ok);
    n3i_wide_side bc = n3i_wide_side_of(q[1], q[5], q[6], q[2], &ok);
    n3i_wide_side ac = n3i_wide_side_of(q[0], q[8], q[7], q[2], &ok);
    n3_real *at = sink->at;
    int i, j;
    n3i_wide_centred(q, level, c);
    row.f[3] = c[3];
    for (i = 0; !inside && i <= level; i++) {
        if (i % N3I_ROW == 0) at = n3i_room(sink, at, blocks);
        at = n3i_put(sink, at, n3i_wide_side_point(&ab, i, level, w), blocks);
    }
    for (j = 1; j < level; j++) {
        s -= 1;
        row.f[0] = n3i_wide_step(n3i_wide_step(n3i_wide_step(c[9], s, c[7]), s, c[4]), s, c[0]);
        row.f[1] = n3i_wide_step(n3i_wide_step(c[8], s, c[5]), s, c[1]);
        row.f[2] = n3i_wide_step(c[6], s, c[2]);
        at = n3i_room(sink, at, blocks);
        if (!inside) at = n3i_put(sink, at, n3i_wide_side_point(&ac, j, level, w), blocks);
        at = n3i_wide_row_all(&row, level - j - 1, 0, sink, at, blocks);
        if (!inside) at = n3i_put(sink, at, n3i_wide_side_point(&bc, j, level, w), blocks);
    }
    if (!inside) at = n3i_put(sink, at, n3i_wide_side_point(&ac, level, level, w), blocks);
    sink->at = at;
    return ok;
}

/* The normals of a lattice, in the same rows: the derivatives by s and by e, whose product is half
   of that by u and by v. */
N3I_WIDE_API n3i_mask n3i_wide_normals(const n3i_wide_vec q[10], int level, n3i_sink *sink,
                                       int blocks)
{
    n3i_wide s = n3i_wide_of((n3_real)level), two = n3i_wide_of(2), three = n3i_wide_of(3), size;
    n3_real h = 1 / (n3_real)level, clear = N3I_CLEAR * h * h / 2, *at = sink->at;
    n3i_wide_vec c[10];
    n3i_wide_row row;
    n3i_mask ok = (n3i_mask)(s > 0);
    int i;
    n3i_wide_centred(q, level, c);
    size = n3i_wide_inverse_size(q, &ok);
    for (i = 1; i < 10; i++) c[i] = n3i_wide_mul(size, c[i]);
    row.f[2] = c[6];
    row.g[2] = n3i_wide_mul(three, c[3]);
    c[9] = n3i_wide_mul(three, c[9]);
    c[7] = n3i_wide_mul(two, c[7]);
    row.least = n3i_wide_of(clear * clear);
    row.lowest = n3i_wide_of(1);
    for (i = level; i >= 0; i--, s -= 1) {
        row.f[0] = n3i_wide_step(n3i_wide_step(c[9], s, c[7]), s, c[4]);
        row.f[1] = n3i_wide_step(c[8], 2 * s, c[5]);
        row.g[0] = n3i_wide_step(n3i_wide_step(c[8], s, c[5]), s, c[1]);
        row.g[1] = n3i_wide_mul(two, n3i_wide_step(c[6], s, c[2]));
        at = n3i_room(sink, at, blocks);
        at = n3i_wide_row_all(&row, i + 1, 1, sink, at, blocks);
    }
    sink->at = at;
    return ok & (n3i_mask)(row.lowest > row.least);
}

/* What is wanted: points, of a lattice those inside it, normals, jets. */
enum { N3I_POINTS, N3I_INSIDE, N3I_NORMALS, N3I_JETS };

/* What the wide form left out; step: from a point's x to its y. */
NAGATA3_API void n3i_plain_lattice(const n3_patch *p, int level, int what, int step, n3_real *out)
{
    n3_edge side[3];
    n3_vec x;
    n3_real u, v;
    int i, j, inside = what == N3I_INSIDE;
    n3_patch_edges(p, side);
    side[2] = n3_edge_reverse(&side[2]);
    for (j = inside; j <= level - inside; j++)
        for (i = inside; i <= level - j - inside; i++, out += 3 * step) {
            n3i_lattice_uv(level, i, j, &u, &v);
            if (what == N3I_NORMALS) x = n3_patch_normal(p, u, v);
            else if (j == 0) x = n3i_side_point(side[0], i, level);
            else if (i == 0) x = n3i_side_point(side[2], j, level);
            else if (i + j == level) x = n3i_side_point(side[1], j, level);
            else x = n3_patch_point(p, u, v);
            out[0] = x.x;
            out[step] = x.y;
            out[2 * step] = x.z;
        }
}

/* Patches next to each other that are left to one lane, where many are. */
enum { N3I_PART = 64, N3I_LINE = 64 / sizeof(n3_real) };

/* The lattices of count patches for each of so many lanes, part after part; of fewer lanes the last
   is done more than once. */
NAGATA3_API void n3i_lattices(const n3_patch *patch, int lanes, int part, int level, int what,
                              const n3i_wide_weights *w, int blocks, int past, n3_real *out)
{
    const size_t each = blocks ? 1 : 3 * (size_t)n3i_inside(what == N3I_INSIDE ? level : level + 3);
    const n3_real *from[N3I_WIDTH];
    n3i_wide_vec q[10];
    n3i_sink sink;
    n3i_mask ok[N3I_PART];
    int i, k;
    sink.past = past;
    sink.unit = past ? (int)N3I_LINE : (int)N3I_WIDTH;
    sink.begin = part > 1 ? (int)((size_t)out / sizeof *out % (size_t)sink.unit) : 0;
    sink.at = blocks ? out : (n3_real *)(void *)(sink.held + sink.begin);
    for (i = 0; i < N3I_WIDTH; i++) {
        int lane = (i < lanes ? i : lanes - 1) * part;
        from[i] = &patch[lane].p[0].x;
        sink.to[i] = out + each * (size_t)lane;
    }
    for (k = 0; k < part; k++) {
        n3i_load(from, 30, &q[0].x);
        if (what == N3I_NORMALS) ok[k] = n3i_wide_normals(q, level, &sink, blocks);
        else if (what == N3I_POINTS) ok[k] = n3i_wide_lattice(q, level, 0, w, &sink, blocks);
        else ok[k] = n3i_wide_lattice(q, level, 1, w, &sink, blocks);
        for (i = 0; i < N3I_WIDTH; i++) from[i] += 30;
    }
    if (!blocks) n3i_flush(&sink, sink.at, 1);
    for (k = 0; k < part; k++)
        for (i = 0; i < (blocks ? (int)N3I_WIDTH : lanes); i++) {
            int lane = (i < lanes ? i : lanes - 1) * part + k;
            if (n3i_lane(ok[k], i)) continue;
            n3i_plain_lattice(&patch[lane], level, what, blocks ? N3_BLOCK : 1,
                              out + each * (size_t)(blocks ? i : lane));
        }
}

/* An output this large, in bytes, does not stay in a cache: what goes past it need not be read
   before, which is faster from 8 to 16 MB on. */
enum { N3I_FAR = 1 << 23 };

NAGATA3_API void n3i_lattice_range(const n3_patch *patch, int first, int last, int level, int what,
                                   n3_vec *out)
{
    size_t size = (size_t)n3i_inside(level + 3);
    int past = (size_t)(last - first) > N3I_FAR / sizeof *out / size;
    int part = past ? (int)N3I_PART : (int)N3I_WIDTH, lanes = N3I_WIDTH;
    n3i_wide_weights w[N3I_WEIGHTS];
    n3i_all_weights(level, w);
    while (first < last) {
        while (part > 1 && last - first < part * lanes) part = part > N3I_LINE ? (int)N3I_LINE : 1;
        if (last - first < lanes) lanes = last - first;
        n3i_lattices(patch + first, lanes, part, level, what, w, 0, past && part > 1, &out->x);
        first += part * lanes;
        out += (size_t)(part * lanes) * size;
    }
    n3i_fence();
}

/* Vectors of half a block would leave half of the lines open. */
NAGATA3_API void n3i_block_range(const n3_patch *patch, int first, int last, int level, int what,
                                 n3_real *out)
{
    size_t size = 3 * (size_t)n3i_inside(level + 3);
    int past = (size_t)(last - first) > N3I_FAR / sizeof *out / size, i;
    n3i_wide_weights w[N3I_WEIGHTS];
    n3i_all_weights(level, w);
    past = past && (int)N3I_WIDTH == N3_BLOCK && (size_t)out % sizeof(n3i_wide) == 0;
    for (; first < last; first += N3_BLOCK, out += N3_BLOCK * size)
        for (i = 0; i < N3_BLOCK; i += N3I_WIDTH) {
            int at = first + i < last ? first + i : last - 1;
            int lanes = last - at < (int)N3I_WIDTH ? last - at : (int)N3I_WIDTH;
            n3i_lattices(patch + at, lanes, 1, level, what, w, 1, past, out + i);
        }
    n3i_fence();
}

NAGATA3_API void n3_lattice_points(const n3_patch *patch, int first, int last, int level,
                                   n3_vec *point)
{
    n3i_lattice_range(patch, first, last, level, N3I_POINTS, point);
}

NAGATA3_API void n3_lattice_normals(const n3_patch *patch, int first, int last, int level,
                                    n3_vec *normal)
{
    n3i_lattice_range(patch, first, last, level, N3I_NORMALS, normal);
}

NAGATA3_API void n3_lattice_point_blocks(const n3_patch *patch, int first, int last, int level,
                                         n3_real *point)
{
    n3i_block_range(patch, first, last, level, N3I_POINTS, point);
}

NAGATA3_API void n3_lattice_normal_blocks(const n3_patch *patch, int first, int last, int level,
                                          n3_real *normal)
{
    n3i_block_range(patch, first, last, level, N3I_NORMALS, normal);
}

NAGATA3_API void n3_lattice_triangles(int first, int last, int level, int *triangle)
{
    int i, j, at = first * n3i_inside(level + 3);
    for (; first < last; first++, at++)
        for (j = level; j > 0; j--, at++) /* rows of j + 1 points */
            for (i = 0; i < j; i++, at++) {
                triangle[0] = at;
                triangle[1] = at + 1;
                triangle[2] = at + j + 1;
                triangle += 3;
                if (i + 1 == j) continue;
                triangle[0] = at + j + 2;
                triangle[1] = at + j + 1;
                triangle[2] = at + 1;
                triangle += 3;
            }
}

/* Scattered points have patches of their own, and to turn these into lanes would take longer than
   the sums: their lanes are x, y and z of a point, in N3I_ROWS rows. Only the weights are made with
   the points of a batch for lanes. */
enum { N3I_ROWS = N3I_XYZ > 3 ? 1 : 4 - N3I_XYZ, N3I_BATCH = 16 };
typedef struct n3i_weights { n3_real c[13][N3I_BATCH]; } n3i_weights;

/* Of p[0] to p[9]; then u, v and w. */
N3I_WIDE_API void n3i_wide_cubic(n3i_wide u, n3i_wide v, n3i_wide w, n3i_wide c[13])
{
    c[0] = w * w * w;
    c[1] = u * u * u;
    c[2] = v * v * v;
    c[3] = 3 * u * w * w;
    c[4] = 3 * u * u * w;
    c[5] = 3 * u * u * v;
    c[6] = 3 * u * v * v;
    c[7] = 3 * v * v * w;
    c[8] = 3 * v * w * w;
    c[9] = 6 * u * v * w;
    c[10] = u;
    c[11] = v;
    c[12] = w;
}

/* Of the ways in u or v, row by row. */
N3I_WIDE_API void n3i_wide_quadratic(n3i_wide u, n3i_wide v, n3i_wide w, n3i_wide c[13])
{
    c[0] = w * w;
    c[1] = 2 * u * w;
    c[2] = u * u;
    c[3] = 2 * v * w;
    c[4] = 2 * u * v;
    c[5] = v * v;
}

N3I_WIDE_API void n3i_weights_of(const n3_real *uv, int count, int what, n3i_weights *weights)
{
    const int rows = what == N3I_NORMALS ? 6 : what == N3I_JETS ? 13 : 10;
    n3_real rest[2 * N3I_WIDTH] = {0};
    n3i_wide u, v, c[13];
    int i, k;
    for (i = 0; i < count; i += N3I_WIDTH, uv += 2 * N3I_WIDTH) {
        if (count - i < N3I_WIDTH) {
            memcpy(rest, uv, 2 * (size_t)(count - i) * sizeof *uv);
            uv = rest;
        }
        n3i_pairs(uv, &u, &v);
        if (what == N3I_NORMALS) n3i_wide_quadratic(u, v, 1 - u - v, c);
        else n3i_wide_cubic(u, v, 1 - u - v, c);
        N3I_UNROLL
        for (k = 0; k < rows; k++) memcpy(&weights->c[k][i], &c[k], sizeof c[k]);
    }
}

/* The control points from their coordinate row on. */
N3I_WIDE_API void n3i_xyz_load(const n3_patch *p, int row, n3i_xyz q[10])
{
    int i;
    N3I_UNROLL
    for (i = 0; i < 9; i++) memcpy(&q[i], &p->p[i].x + row, sizeof *q);
    q[9] = n3i_xyz_last(&p->p[9].x + row);
}

/* By itself, as in n3_mul: clang contracts what stands in one expression. */
N3I_WIDE_API n3i_xyz n3i_xyz_mul(n3_real s, n3i_xyz a) { return s * a; }

/* w a + u b + v c */
N3I_WIDE_API n3i_xyz n3i_xyz_mix(n3_real w, n3i_xyz a, n3_real u, n3i_xyz b, n3_real v, n3i_xyz c)
{
    return n3i_xyz_mul(w, a) + n3i_xyz_mul(u, b) + n3i_xyz_mul(v, c);
}

/* n3_patch_point. */
N3I_WIDE_API n3i_xyz n3i_xyz_point(const n3i_xyz q[10], const n3i_weights *t, int i)
{
    n3i_xyz x[10];
    int k;
    N3I_UNROLL
    for (k = 0; k < 10; k++) x[k] = n3i_xyz_mul(t->c[k][i], q[k]);
    return (((x[0] + x[1]) + x[2]) + x[9]) +
           (((x[3] + x[4]) + (x[5] + x[6])) + (x[7] + x[8]));                       /* (5.2.1) */
}

/* n3_patch_jet, but for the point. */
N3I_WIDE_API void n3i_xyz_jet(const n3i_xyz p[10], n3_real u, n3_real v, n3_real w, n3i_xyz jet[6])
{
    n3i_xyz q[10], r002, r200, r020, r101, r110, r011, pw;
    int i;
    N3I_UNROLL
    for (i = 0; i < 10; i++) q[i] = p[i] - p[0];
    r002 = n3i_xyz_mix(w, q[0], u, q[3], v, q[8]);
    r200 = n3i_xyz_mix(w, q[4], u, q[1], v, q[5]);
    r020 = n3i_xyz_mix(w, q[7], u, q[6], v, q[2]);
    r101 = n3i_xyz_mix(w, q[3], u, q[4], v, q[9]);
    r110 = n3i_xyz_mix(w, q[9], u, q[5], v, q[6]);
    r011 = n3i_xyz_mix(w, q[8], u, q[9], v, q[7]);
    pw = n3i_xyz_mix(w, r002, u, r101, v, r011);
    jet[1] = 3 * (n3i_xyz_mix(w, r101, u, r200, v, r110) - pw);
    jet[2] = 3 * (n3i_xyz_mix(w, r011, u, r110, v, r020) - pw);
    jet[3] = 6 * ((r200 - r101) + (r002 - r101));
    jet[4] = 6 * ((r110 - r101) + (r002 - r011));
    jet[5] = 6 * ((r020 - r011) + (r002 - r011));
}

/* A third of du and dv, and the squares of the ways along a tree through the control points, whose
   sum is the square of the patch's size. */
N3I_WIDE_API void n3i_xyz_ways(const n3i_xyz q[10], const n3i_weights *t, int i, n3i_xyz way[3])
{
    n3i_xyz u0 = q[3] - q[0], u1 = q[4] - q[3], u2 = q[1] - q[4];
    n3i_xyz u3 = q[9] - q[8], u4 = q[5] - q[9], u5 = q[6] - q[7];
    n3i_xyz v0 = q[8] - q[0], v1 = q[9] - q[3], v2 = q[5] - q[4];
    n3i_xyz v3 = q[7] - q[8], v4 = q[6] - q[9], v5 = q[2] - q[7];
    way[0] = (t->c[0][i] * u0 + t->c[1][i] * u1 + t->c[2][i] * u2) +
             (t->c[3][i] * u3 + t->c[4][i] * u4 + t->c[5][i] * u5);
    way[1] = (t->c[0][i] * v0 + t->c[1][i] * v1 + t->c[2][i] * v2) +
             (t->c[3][i] * v3 + t->c[4][i] * v4 + t->c[5][i] * v5);
    way[2] = (u0 * u0 + u1 * u1 + u2 * u2) + (u3 * u3 + u4 * u4 + u5 * u5) +
             (v0 * v0 + v3 * v3 + v5 * v5);
}

/* The normals of a batch from what n3i_xyz_ways gave, with points for lanes again; ok is 0 where
   one is not. */
NAGATA3_API void n3i_batch_normals(n3_vec way[N3I_BATCH][3], int count, n3_vec *out, int *ok)
{
    int i, k;
    for (k = 0; k < count; k += N3I_WIDTH) {
        const n3_real *from[N3I_WIDTH];
        n3_real *to[N3I_WIDTH];
        n3i_wide_vec lane[3];
        n3i_wide size, inverse;
        n3i_mask clear;
        N3I_UNROLL
        for (i = 0; i < N3I_WIDTH; i++) {
            int point = k + i < count ? k + i : k;
            from[i] = &way[point][0].x;
            to[i] = &out[point].x;
        }
        n3i_load(from, 9, &lane[0].x);
        size = lane[2].x + lane[2].y + lane[2].z;
        clear = (n3i_mask)(size > 0);
        inverse = 1 / n3i_pick(clear, size, n3i_wide_of(1));
        clear &= (n3i_mask)(inverse - inverse <= 0); /* not infinite */
        lane[0] = n3i_wide_normal(n3i_wide_mul(inverse, lane[0]), lane[1], N3I_CLEAR, &clear);
        n3i_store(&lane[0].x, 3, to, 0);
        N3I_UNROLL
        for (i = 0; i < N3I_WIDTH; i++) ok[k + i] = n3i_lane(clear, i);
    }
}

/* What the wide form left out. */
NAGATA3_API void n3i_plain_at(const n3_patch *p, const n3_real *uv, int what, n3_vec *out)
{
    n3_jet j;
    if (what == N3I_JETS) j = n3_patch_jet(p, uv[0], uv[1]);
    else if (what == N3I_NORMALS) j.x = n3_patch_normal(p, uv[0], uv[1]);
    else j.x = n3_patch_point(p, uv[0], uv[1]);
    memcpy(out, &j, what == N3I_JETS ? sizeof j : sizeof j.x);
}

N3I_WIDE_API void n3i_batch(const n3_patch *patch, const int *parent, const n3_real *uv, int count,
                            int what, n3_vec *out)
{
    const int size = what == N3I_JETS ? 6 : what == N3I_NORMALS ? 3 : 1;
    int i, k, row, ok[N3I_BATCH];
    n3_vec way[N3I_BATCH][3];
    n3i_weights t;
    if (N3I_WIDTH > 1 || what == N3I_NORMALS) n3i_weights_of(uv, count, what, &t);
    for (i = 0; i < count; i++) {
        n3_vec *to = what == N3I_NORMALS ? way[i] : out + size * i;
        n3i_xyz q[10], x[6];
        int inside = N3I_WIDTH > 1 && (t.c[9][i] < 0 || t.c[9][i] > 0);
        if (what != N3I_NORMALS && !inside) {
            n3i_plain_at(&patch[parent[i]], uv + 2 * i, what, to);
            continue;
        }
        N3I_UNROLL
        for (row = 0; row < N3I_ROWS; row++) {
            n3i_xyz_load(&patch[parent[i]], row, q);
            if (what == N3I_NORMALS) n3i_xyz_ways(q, &t, i, x);
            else x[0] = n3i_xyz_point(q, &t, i);
            if (what == N3I_JETS) n3i_xyz_jet(q, t.c[10][i], t.c[11][i], t.c[12][i], x);
            N3I_UNROLL /* a fourth number gives way to the next */
            for (k = 0; k + 1 < size; k++) memcpy(&to[k].x + row, &x[k], sizeof x[k]);
            n3i_xyz_store(x[k], &to[k].x + row);
        }
    }
    if (what != N3I_NORMALS) return;
    n3i_batch_normals(way, count, out, ok);
    for (i = 0; i < count; i++)
        if (!ok[i]) n3i_plain_at(&patch[parent[i]], uv + 2 * i, what, out + i);
}

NAGATA3_API void n3i_evaluate(const n3_patch *patch, const int *parent, const n3_real *uv,
                              int first, int last, int what, n3_vec *out)
{
    const int size = what == N3I_JETS ? 6 : 1;
    for (; first < last; first += N3I_BATCH, out += N3I_BATCH * size) {
        int count = last - first < N3I_BATCH ? last - first : N3I_BATCH;
        const int *p = parent + first;
        const n3_real *at = uv + 2 * (size_t)first;
        if (what == N3I_POINTS) n3i_batch(patch, p, at, count, N3I_POINTS, out);
        else if (what == N3I_JETS) n3i_batch(patch, p, at, count, N3I_JETS, out);
        else n3i_batch(patch, p, at, count, N3I_NORMALS, out);
    }
}

NAGATA3_API void n3_patch_points(const n3_patch *patch, const int *parent, const n3_real *uv,
                                 int first, int last, n3_vec *point)
{
    n3i_evaluate(patch, parent, uv, first, last, N3I_POINTS, point);
}

NAGATA3_API void n3_patch_jets(const n3_patch *patch, const int *parent, const n3_real *uv,
                               int first, int last, n3_jet *jet)
{
    n3i_evaluate(patch, parent, uv, first, last, N3I_JETS, &jet->x);
}

NAGATA3_API void n3_patch_normals(const n3_patch *patch, const int *parent, const n3_real *uv,
                                  int first, int last, n3_vec *normal)
{
    n3i_evaluate(patch, parent, uv, first, last, N3I_NORMALS, normal);
}

/* ---- Definitions: refinement ---- */

/* From its lower to its higher point. */
NAGATA3_API n3_edge n3i_mesh_edge(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                  int edge)
{
    const n3_vec *handle = net + m->points + 2 * edge;
    int end[2];
    n3_mesh_edge_ends(m, t, edge, end);
    return n3i_edge_of(net[end[0]], handle[0], handle[1], net[end[1]]);
}

NAGATA3_API n3_status n3_mesh_refine_counts(const n3_mesh *m, const n3_topology *t, int level,
                                            int *points, int *triangles, int *normals)
{
    int live, p, f, n;
    if (!m || !t) return N3_NULL_POINTER;
    if (level < 1 || level > N3I_COUNT_LIMIT - 3) return N3_BAD_COUNT;
    live = t->triangles - t->collapsed;
    p = n3i_count_add(t->points, n3i_count_mul(level - 1, t->edges));
    p = n3i_count_add(p, n3i_count_mul(n3i_inside(level), live));
    f = n3i_count_mul(n3i_count_mul(level, level), live);
    n = n3i_count_mul(n3i_inside(level + 3), live);
    if (p < 0 || n < 0 || n3i_count_mul(3, f) < 0) return N3_BAD_COUNT;
    if (points) *points = p;
    if (triangles) *triangles = f;
    if (normals) *normals = n;
    return N3_OK;
}

/* Where the points of a refined patch are: k steps along side i from its corner, start + k step;
   those inside from there on. */
typedef struct n3i_lattice { int level, corner[3], start[3], step[3], inside; } n3i_lattice;

/* live counts the triangles before this one that are not collapsed. */
NAGATA3_API n3i_lattice n3i_lattice_of(const n3_mesh *m, const n3_topology *t, int level,
                                       int triangle, int live)
{
    n3i_lattice g;
    int i;
    g.level = level;
    g.inside = m->points + (level - 1) * t->edges + n3i_inside(level) * live;
    for (i = 0; i < 3; i++) {
        int s = 3 * triangle + i, edge = t->edge[s], base = m->points + (level - 1) * edge;
        int up = n3i_at(m, s) < n3i_at(m, n3i_after(s));
        g.corner[i] = n3i_at(m, s);
        g.start[i] = edge < 0 ? g.corner[i] : up ? base - 1 : base + level - 1;
        g.step[i] = edge < 0 ? 0 : up ? 1 : -1;
    }
    return g;
}

/* The point at u = i / level, v = j / level. */
NAGATA3_API int n3i_lattice_point(const n3i_lattice *g, int i, int j)
{
    int k = g->level - i - j, n = g->level;
    if (i == n || j == n || k == n) return g->corner[i == n ? 1 : j == n ? 2 : 0];
    if (j == 0) return g->start[0] + g->step[0] * i;
    if (k == 0) return g->start[1] + g->step[1] * j;
    if (i == 0) return g->start[2] + g->step[2] * k;
    return g->inside + (j - 1) * (n - 1) - (j - 1) * j / 2 + i - 1;
}

/* From the canonical end, so that numbering the points anew changes none. */
NAGATA3_API void n3_mesh_refine_edges(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                      int level, int first, int last, n3_vec *point)
{
    const n3_real *from[N3I_WIDTH];
    n3_edge e[N3I_WIDTH];
    n3i_wide_vec p[4];
    n3i_sink sink;
    n3i_wide_weights w[N3I_WEIGHTS];
    n3_real *at;
    n3i_wide_side side;
    n3i_mask ok;
    int i, k;
    n3i_all_weights(level, w);
    for (point += m->points; level > 1 && first < last; first += N3I_WIDTH) {
        for (i = 0; i < N3I_WIDTH; i++) {
            int edge = first + i < last ? first + i : last - 1;
            e[i] = n3i_mesh_edge(m, t, net, edge);
            from[i] = &e[i].p[0].x;
            sink.to[i] = &point[(level - 1) * edge].x;
        }
        n3i_load(from, 12, &p[0].x);
        ok = (n3i_mask)(p[0].x <= p[0].x);
        side = n3i_wide_side_of(p[0], p[1], p[2], p[3], &ok);
        sink.begin = sink.past = 0;
        sink.unit = N3I_WIDTH;
        for (i = 1, at = (n3_real *)(void *)sink.held; i < level; i++)
            at = n3i_put(&sink, n3i_room(&sink, at, 0), n3i_wide_side_point(&side, i, level, w), 0);
        n3i_flush(&sink, at, 1);
        for (i = 0; i < N3I_WIDTH && first + i < last; i++)
            for (k = 1; !n3i_lane(ok, i) && k < level; k++)
                point[(level - 1) * (first + i) + k - 1] = n3i_side_point(e[i], k, level);
    }
}

/* The lattices of the triangles, those of collapsed ones left out. */
NAGATA3_API void n3i_refine_patches(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                    int level, int first, int last, int what, n3_vec *out)
{
    n3_patch p[N3I_WIDTH];
    int count = 0, size = n3i_inside(what == N3I_INSIDE ? level : level + 3);
    for (; first < last; first++) {
        if (!n3i_is_collapsed(m, first)) p[count++] = n3i_mesh_patch(m, t, net, first);
        if (count == 0 || (count < N3I_WIDTH && first + 1 < last)) continue;
        n3i_lattices(p, count, 1, level, what, NULL, 0, 0, &out->x);
        out += (size_t)count * (size_t)size;
        count = 0;
    }
}

/* The triangles of a lattice between the rows j and j + 1: along both, one up, one down. */
NAGATA3_API int *n3i_refine_row(const n3i_lattice *g, int j, int *triangle)
{
    int i, low = n3i_lattice_point(g, 0, j), high = n3i_lattice_point(g, 0, j + 1);
    for (i = 1; i <= g->level - j; i++) {
        int next = n3i_lattice_point(g, i, j);
        *triangle++ = low;
        *triangle++ = next;
        *triangle++ = high;
        low = next;
        if (i == g->level - j) break;
        next = n3i_lattice_point(g, i, j + 1);
        *triangle++ = next;
        *triangle++ = high;
        *triangle++ = low;
        high = next;
    }
    return triangle;
}

/* How many of the first triangles are not collapsed. */
NAGATA3_API int n3i_live_before(const n3_mesh *m, const n3_topology *t, int triangle)
{
    int f, live = triangle;
    for (f = 0; t->collapsed && f < triangle; f++) live -= n3i_is_collapsed(m, f);
    return live;
}

NAGATA3_API void n3_mesh_refine_triangles(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                          int level, int first, int last, n3_vec *point,
                                          int *triangle, n3_vec *normal, int *corner)
{
    int f, j, live = n3i_live_before(m, t, first), end = n3i_live_before(m, t, last);
    size_t before = (size_t)live, each = 3 * (size_t)level * (size_t)level;
    if (point && level > 2)
        n3i_refine_patches(m, t, net, level, first, last, N3I_INSIDE,
                           point + m->points + (level - 1) * t->edges + n3i_inside(level) * live);
    if (normal)
        n3i_refine_patches(m, t, net, level, first, last, N3I_NORMALS,
                           normal + before * (size_t)n3i_inside(level + 3));
    if (corner) n3_lattice_triangles(live, end, level, corner + before * each);
    if (!triangle) return;
    for (f = first, triangle += before * each; f < last; f++) {
        n3i_lattice g;
        if (n3i_is_collapsed(m, f)) continue;
        g = n3i_lattice_of(m, t, level, f, live++);
        for (j = 0; j < level; j++) triangle = n3i_refine_row(&g, j, triangle);
    }
}

/* From the last triangle to the first, so that the lowest stays. A collapsed one has no points
   inside. */
NAGATA3_API void n3i_refine_parents(const n3_mesh *m, const n3_topology *t, int level, int *parent,
                                    n3_real *uv)
{
    int f, i, j, live = m->triangles - t->collapsed;
    for (i = 0; i < m->points; i++) {
        if (parent) parent[i] = -1;
        if (uv) uv[2 * i] = uv[2 * i + 1] = 0;
    }
    for (f = m->triangles - 1; f >= 0; f--) {
        int collapsed = n3i_is_collapsed(m, f);
        n3i_lattice g = n3i_lattice_of(m, t, level, f, live -= !collapsed);
        for (j = level; j >= 0; j--)
            for (i = level - j; i >= 0; i--) {
                int k = n3i_lattice_point(&g, i, j);
                if (collapsed && i > 0 && j > 0 && i + j < level) continue;
                if (parent) parent[k] = f;
                if (uv) n3i_lattice_uv(level, i, j, &uv[2 * (size_t)k], &uv[2 * (size_t)k + 1]);
            }
    }
}

NAGATA3_API n3_status n3_mesh_refine(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                     int level, n3_vec *point, int *triangle, n3_vec *normal,
                                     int *corner, int *parent, n3_real *uv)
{
    n3_status status = n3i_check(m, t, NULL);
    int i;
    if (status == N3_OK) status = n3_mesh_refine_counts(m, t, level, NULL, NULL, NULL);
    if (status != N3_OK) return status;
    if ((point || normal) && !net) return N3_NULL_POINTER;
    for (i = 0; point && i < m->points; i++) point[i] = net[i];
    if (point) n3_mesh_refine_edges(m, t, net, level, 0, t->edges, point);
    n3_mesh_refine_triangles(m, t, net, level, 0, m->triangles, point, triangle, normal, corner);
    if (parent || uv) n3i_refine_parents(m, t, level, parent, uv);
    return N3_OK;
}

/* Values of the Lagrange polynomials: corners, then nodes of the sides, then the middle. */
NAGATA3_API void n3i_lagrange(int degree, n3_real u, n3_real v, n3_real weight[10])
{
    n3_real L[3], nine_halves = (n3_real)9 / 2;
    int i;
    L[0] = 1 - u - v;
    L[1] = u;
    L[2] = v;
    for (i = 0; i < 3; i++) {
        n3_real a = L[i], b = L[(i + 1) % 3];
        if (degree == 1) weight[i] = a;
        if (degree == 2) weight[i] = a * (2 * a - 1);
        if (degree == 2) weight[3 + i] = 4 * a * b;
        if (degree == 3) weight[i] = a * (3 * a - 1) * (3 * a - 2) / 2;
        if (degree == 3) weight[3 + 2 * i] = nine_halves * a * b * (3 * a - 1);
        if (degree == 3) weight[4 + 2 * i] = nine_halves * a * b * (3 * b - 1);
    }
    if (degree == 3) weight[9] = 27 * u * v * L[0];
}

/* The nodes of a triangle in the field, in the order of the weights; returns their number. */
NAGATA3_API int n3i_field_nodes(const n3_mesh *m, const n3_topology *t, int degree, int triangle,
                                int node[10])
{
    int i;
    n3_mesh_patch_nodes(m, t, triangle, node);
    for (i = 0; i < 3 && degree == 2; i++) {
        int edge = t->edge[3 * triangle + i];
        node[3 + i] = edge < 0 ? node[i] : m->points + edge;
    }
    return degree == 3 ? 10 : 3 * degree;
}

NAGATA3_API n3_status n3_mesh_field(const n3_mesh *m, const n3_topology *t, int degree,
                                    int components, const n3_real *nodal, const int *parent,
                                    const n3_real *uv, int count, n3_real *out)
{
    n3_status status = n3i_check(m, t, NULL);
    int i, k, q, nodes, node[10];
    n3_real weight[10];
    if (status != N3_OK) return status;
    if (degree < 1 || degree > 3 || components < 0 || count < 0) return N3_BAD_COUNT;
    if (count > 0 && (!nodal || !parent || !uv || !out)) return N3_NULL_POINTER;
    for (i = 0; i < count; i++)
        if (parent[i] >= m->triangles || (parent[i] < 0 && i >= m->points)) return N3_BAD_COUNT;
    for (i = 0; i < count; i++) {
        n3_real *row = out + (size_t)i * (size_t)components;
        node[0] = i;
        weight[0] = 1;
        nodes = parent[i] < 0 ? 1 : n3i_field_nodes(m, t, degree, parent[i], node);
        if (nodes > 1) n3i_lagrange(degree, uv[2 * (size_t)i], uv[2 * (size_t)i + 1], weight);
        for (k = 0; k < components; k++) row[k] = 0;
        for (q = 0; q < nodes; q++) {
            const n3_real *value = nodal + (size_t)node[q] * (size_t)components;
            for (k = 0; k < components; k++) row[k] += weight[q] * value[k];
        }
    }
    return N3_OK;
}

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
typedef struct n3i_walk { int strip, parts[2], at[2], first; n3i_spot spot[2]; } n3i_walk;

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

NAGATA3_API void n3i_walk_strip(const n3i_cut *c, n3i_walk *w, int strip, int first)
{
    int beside = c->inner && strip < 3;
    w->strip = strip;
    w->first = first;
    w->at[0] = w->at[1] = 0;
    if (strip >= c->strips) return;
    w->parts[0] = beside ? c->side[strip] : c->inner ? c->inner + 1 - strip : n3i_row_parts(c, strip);
    w->parts[1] = beside ? c->inner - 2 : c->inner ? c->inner - strip : n3i_row_parts(c, strip + 1);
    w->spot[0] = n3i_walk_spot(c, w, 0);
    w->spot[1] = n3i_walk_spot(c, w, 1);
}

NAGATA3_API n3i_walk n3i_walk_start(const n3i_cut *c)
{
    n3i_walk w;
    memset(&w, 0, sizeof w);
    n3i_walk_strip(c, &w, 0, n3i_cut_first(c));
    return w;
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
    out[high] = w->spot[high];
    out[2] = w->spot[!high];
    w->at[high]++;
    out[!high] = w->spot[high] = n3i_walk_spot(c, w, high);
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

/* The control vectors of du x dv at [i][j], the exponents of u and v, each but for a factor above
   0: sums of the crosses of the quadratic nets of du and dv, in the order of n3_patch2.p, in which
   the Bernstein polynomials of the last three carry a 2. */
NAGATA3_API void n3i_normal_net(const n3_patch *p, n3_vec out[5][5])
{
    static const int from[6] = {0, 4, 7, 3, 9, 8}, to_u[6] = {3, 1, 6, 4, 5, 9};
    static const int to_v[6] = {8, 5, 2, 9, 6, 7};
    static const int power[6][2] = {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}};
    int a, b, i, j;
    for (i = 0; i < 5; i++)
        for (j = 0; j < 5; j++) out[i][j] = n3_v(0, 0, 0);
    for (a = 0; a < 6; a++)
        for (b = 0; b < 6; b++) {
            n3_vec du = n3_sub(p->p[to_u[a]], p->p[from[a]]);
            n3_vec dv = n3_sub(p->p[to_v[b]], p->p[from[b]]);
            int times = (a > 2 ? 2 : 1) * (b > 2 ? 2 : 1);
            i = power[a][0] + power[b][0];
            j = power[a][1] + power[b][1];
            out[i][j] = n3_add(out[i][j], n3_mul((n3_real)times, n3_cross(du, dv)));
        }
}

/* The patch as its second differences at the corners, second derivatives over 6: along u, along
   both, along v. And which share of a vector leads away from the patch: the one along N, and of the
   rest not more than the slope, the largest tangent of an angle between its normals and N; below 0
   while nobody has asked. */
typedef struct n3i_bend { const n3_patch *patch; n3_vec at[3][3], N; n3_real slope; } n3i_bend;

/* No normal of the patch is beyond those of its net. */
NAGATA3_API void n3i_bend_slope(n3i_bend *b)
{
    n3_patch boxed;
    n3_vec net[5][5], sum = n3_v(0, 0, 0);
    int i, j;
    if (b->slope >= 0) return;
    boxed = n3i_patch_boxed(b->patch);
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
    b.patch = p;
    b.N = n3_v(0, 0, 0);
    b.slope = -1;
    return b;
}

/* The second differences along the way from x to y, at the corners. */
NAGATA3_API void n3i_bend_along(const n3i_bend *b, const n3i_spot *x, const n3i_spot *y,
                                n3_vec along[3])
{
    n3_real u = y->u - x->u, v = y->v - x->v;
    int c;
    for (c = 0; c < 3; c++)
        along[c] = n3i_mix(u * u, b->at[c][0], 2 * u * v, b->at[c][1], v * v, b->at[c][2]);
}

NAGATA3_API n3_vec n3i_bend_at(const n3_vec along[3], const n3i_spot *at)
{
    return n3i_mix(1 - at->u - at->v, along[0], at->u, along[1], at->v, along[2]);
}

/* The control vectors of the difference between a facet's part of the patch and the facet, with
   the second differences G_i along a side e at its corners:

       side      d_iij = -(2 G_i + G_j) / 3
       centre    d_123 = (G_1(12) + G_1(13) - G_1(23)) / 2 + d_112 + d_113

   out: the sides' two each, then the centre. */
NAGATA3_API void n3i_facet_net(const n3i_bend *b, const n3i_spot s[3], n3_vec out[7])
{
    n3_vec first = n3_v(0, 0, 0), along[3], gx, gy;
    int i;
    for (i = 0; i < 3; i++) {
        const n3i_spot *x = &s[i], *y = &s[(i + 1) % 3];
        n3i_bend_along(b, x, y, along);
        gx = n3i_bend_at(along, x);
        gy = n3i_bend_at(along, y);
        out[2 * i] = n3_mul(-(n3_real)1 / 3, n3_add(gx, n3_add(gx, gy)));
        out[2 * i + 1] = n3_mul(-(n3_real)1 / 3, n3_add(gy, n3_add(gx, gy)));
        if (i != 1) first = n3_add(first, i == 0 ? gx : gy);
    }
    n3i_bend_along(b, &s[1], &s[2], along);
    first = n3_sub(first, n3i_bend_at(along, &s[0]));
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

/* How far a difference can lead away from the patch: its length, or the share that counts; size, if
   that is larger. */
NAGATA3_API n3_real n3i_bend_size(n3i_bend *b, n3_vec d, n3_real size)
{
    n3_real all = n3_len(d), share;
    if (all <= size) return size;
    n3i_bend_slope(b);
    share = n3i_abs(n3_dot(d, b->N)) + b->slope * all;
    return n3i_larger(size, share < all ? share : all);
}

/* Whether the difference is nowhere longer than the distance. With D the longer vector of each
   side it is at most

       3 (D_12 xy + D_23 yz + D_31 zx) + 3 xyz (2 |d_123| - D_12 - D_23 - D_31),     xyz <= 1/27 */
NAGATA3_API int n3i_is_within(const n3_vec net[7], n3_vec N, n3_real slope, n3_real distance)
{
    n3_real size[7], D[3], excess, bound, inverse = 1 / distance;
    int i;
    for (i = 0; i < 7; i++) {
        n3_vec d = n3_mul(inverse, net[i]);
        size[i] = n3i_abs(n3_dot(d, N)) + slope * n3i_sqrt(n3_dot(d, d));
    }
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
NAGATA3_API int n3i_cut_facets(const n3i_cut *c, n3i_bend *b, n3_real distance)
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
        n3i_bend_slope(b);
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
NAGATA3_API n3_real n3i_side_size(n3i_bend *b, int side)
{
    static const n3i_spot corner[3] = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}};
    const n3i_spot *x = &corner[side], *y = &corner[(side + 1) % 3], *z = &corner[(side + 2) % 3];
    const n3_real quarter = (n3_real)1 / 4;
    n3_vec way[3][3];
    n3_real size = 0, square, s;
    int i;
    n3i_bend_along(b, x, y, way[0]);
    n3i_bend_along(b, z, x, way[1]);
    n3i_bend_along(b, z, y, way[2]);
    for (i = 0; i < 2; i++) {
        const n3i_spot *at = i ? y : x;
        n3_vec along = n3i_bend_at(way[0], at), across;
        across = n3_mul(quarter, n3_sub(n3i_bend_at(way[1], at), n3i_bend_at(way[2], at)));
        square = n3_dot(along, along);
        s = square > 0 ? n3_dot(across, along) / square : 0;
        if (!(n3i_abs(s) <= quarter)) s = s < 0 ? -quarter : quarter;
        size = n3i_larger(size, n3_len(along));
        size = n3i_bend_size(b, n3_sub(across, n3_mul(s, along)), size);
    }
    return size;
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

/* What n3_mesh_refine_cut makes, and how far it has come; spots of a triangle on their way to its
   points and normals. */
typedef struct n3i_made {
    n3_vec *point, *normal;
    int *triangle, *corner, *origin, *parent;
    n3_real *uv;
    int triangles, normals, count, to_point[N3I_BATCH], to_normal[N3I_BATCH];
    n3_real at[2 * N3I_BATCH];
} n3i_made;

/* Those on sides have their points from the edges. */
NAGATA3_API void n3i_make_batch(const n3_patch *p, int inside, n3i_made *out)
{
    static const int parent[N3I_BATCH] = {0};
    n3_vec x[N3I_BATCH];
    int i;
    if (out->normal) n3_patch_normals(p, parent, out->at, 0, out->count, x);
    for (i = 0; i < out->count && out->normal; i++) out->normal[out->to_normal[i]] = x[i];
    inside = inside && out->point;
    if (inside) n3_patch_points(p, parent, out->at, 0, out->count, x);
    for (i = 0; i < out->count && inside; i++) out->point[out->to_point[i]] = x[i];
    out->count = 0;
}

NAGATA3_API void n3i_make_spot(const n3_patch *p, const n3i_spot *s, int point, int inside,
                               int triangle, n3i_made *out)
{
    if (out->parent) out->parent[point] = triangle;
    if (out->uv) {
        out->uv[2 * (size_t)point] = s->u;
        out->uv[2 * (size_t)point + 1] = s->v;
    }
    out->to_point[out->count] = point;
    out->to_normal[out->count] = out->normals + s->index;
    out->at[2 * out->count] = s->u;
    out->at[2 * out->count + 1] = s->v;
    if (++out->count == N3I_BATCH) n3i_make_batch(p, inside, out);
}

/* The points of a triangle: its sides', each without its end, then those inside, which a collapsed
   one has not. */
NAGATA3_API void n3i_make_spots(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                const n3_cut *cut, int triangle, n3i_made *out)
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
    n3i_make_batch(&p, 0, out);
    for (row = 0; row < rows; row++) {
        for (i = 0; i < n3i_row_inside(&c, row); i++) {
            n3i_spot s = c.inner ? n3i_inner_spot(&c, i, row) : n3i_row_spot(&c, row, i + 1, first);
            int point = n3i_cut_point(m, t, cut, triangle, &c, s.index);
            n3i_make_spot(&p, &s, point, 1, triangle, out);
        }
        first += n3i_row_inside(&c, row);
    }
    n3i_make_batch(&p, 1, out);
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
    n3i_made out;
    int i;
    memset(&out, 0, sizeof out);
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
    n3_status status = n3i_check(m, t, NULL);
    n3i_made out;
    int f, i;
    memset(&out, 0, sizeof out);
    out.point = point;
    out.normal = normal;
    out.triangle = triangle;
    out.corner = corner;
    out.origin = origin;
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

/* ---- Definitions: report ---- */

NAGATA3_API int n3_patch_may_fold(const n3_patch *p)
{
    n3_patch q = n3i_patch_boxed(p);
    return n3_patch_folds(&q, n3i_net_area(q.p), 1) != N3_NO;
}

/* A report on nothing: what takes the topology or the net is not known. */
NAGATA3_API n3_report n3i_report_empty(const n3_mesh *m)
{
    n3_report r;
    memset(&r, 0, sizeof r);
    if (m && m->point && m->points > 0) r.points = m->points;
    if (m && m->triangle && m->triangles > 0) r.triangles = m->triangles;
    if (r.triangles > N3I_COUNT_LIMIT / 3) r.triangles = N3I_COUNT_LIMIT / 3;
    if (m && m->normal && m->normals > 0) r.normals = m->normals;
    r.edges = r.duplicate_triangles = r.unused_points = -1;
    r.border_edges = r.non_manifold_edges = r.flipped_edges = -1;
    r.straight_edges = r.s_shaped_edges = r.clamped_edges = r.branch_60_edges = -1;
    r.turned_edges = r.crease_edges = r.half_crease_edges = r.degenerate_edges = -1;
    r.folding_patches = r.jump_edge = r.distance_triangle = -1;
    return r;
}

NAGATA3_API int n3i_names_points(const n3_mesh *m, const n3_report *r, int triangle)
{
    int i;
    for (i = 0; i < 3; i++) {
        int p = n3i_at(m, 3 * triangle + i);
        if (p < 0 || p >= r->points) return 0;
    }
    return 1;
}

/* Which corner normals a triangle names, and which of them are none or look back. */
NAGATA3_API void n3i_report_corners(const n3_mesh *m, int triangle, n3_vec face, n3_report *r)
{
    int i, out_of_range = 0;
    for (i = 0; i < 3; i++) {
        int c = 3 * triangle + i, k = n3i_normal_at(m, c);
        n3_vec n = n3_v(0, 0, 0);
        if (k >= r->normals) out_of_range = 1;
        else if (k >= 0) n = n3i_vec_at(m->normal, m->normal_stride, k);
        if (n3i_is_zero(n)) r->zero_normals++;
        if (n3_dot(n3_unit(n), face) < 0) r->flipped_normals++;
    }
    r->bad_corners += out_of_range;
}

NAGATA3_API void n3i_report_triangles(const n3_mesh *m, n3_report *r)
{
    int f;
    for (f = 0; f < r->triangles; f++) {
        n3_vec face = n3_v(0, 0, 0);
        if (!n3i_names_points(m, r, f)) {
            r->bad_triangles++;
            n3i_report_corners(m, f, face, r);
        } else if (n3i_is_collapsed(m, f)) {
            r->collapsed_triangles++;
        } else {
            face = n3i_face_of(m, f).normal;
            r->flat_triangles += n3i_is_zero(face);
            n3i_report_corners(m, f, face, r);
        }
    }
}

/* True if a triangle before this one has its points: it shares the side with the fewest others. */
NAGATA3_API int n3i_is_duplicate(const n3_mesh *m, const n3_topology *t, int triangle)
{
    int i, s = 3 * triangle, fewest = N3I_COUNT_LIMIT;
    for (i = 3 * triangle; i < 3 * triangle + 3; i++) {
        int edge = t->edge[i], count = t->first[edge + 1] - t->first[edge];
        if (count < fewest) s = i;
        if (count < fewest) fewest = count;
    }
    for (i = t->first[t->edge[s]]; t->side[i] < 3 * triangle; i++) {
        int apex = n3i_at(m, n3i_after(n3i_after(t->side[i])));
        if (apex == n3i_at(m, n3i_after(n3i_after(s)))) return 1;
    }
    return 0;
}

NAGATA3_API void n3i_report_topology(const n3_mesh *m, const n3_topology *t, n3_report *r)
{
    int i;
    r->edges = t->edges;
    r->unused_points = t->unused;
    r->border_edges = r->non_manifold_edges = r->flipped_edges = r->duplicate_triangles = 0;
    for (i = 0; i < t->edges; i++) {
        unsigned flags = n3i_face_flags(m, t, i);
        r->border_edges += (flags & N3_EDGE_BORDER) != 0;
        r->non_manifold_edges += (flags & N3_EDGE_NON_MANIFOLD) != 0;
        r->flipped_edges += (flags & N3_EDGE_FLIPPED) != 0;
    }
    for (i = 0; i < t->triangles; i++)
        if (!n3i_is_collapsed(m, i)) r->duplicate_triangles += n3i_is_duplicate(m, t, i);
}

NAGATA3_API int n3i_count_flags(const unsigned *flags, int count, unsigned bit)
{
    int i, n = 0;
    for (i = 0; i < count; i++) n += (flags[i] & bit) != 0;
    return n;
}

NAGATA3_API void n3i_report_flags(const unsigned *flags, n3_report *r)
{
    r->straight_edges = n3i_count_flags(flags, r->edges, N3_EDGE_STRAIGHT);
    r->s_shaped_edges = n3i_count_flags(flags, r->edges, N3_EDGE_S_SHAPED);
    r->clamped_edges = n3i_count_flags(flags, r->edges, N3_EDGE_CLAMPED);
    r->branch_60_edges = n3i_count_flags(flags, r->edges, N3_EDGE_BRANCH_60);
    r->turned_edges = n3i_count_flags(flags, r->edges, N3_EDGE_TURNED);
    r->crease_edges = n3i_count_flags(flags, r->edges, N3_EDGE_CREASE);
    r->half_crease_edges = n3i_count_flags(flags, r->edges, N3_EDGE_HALF_CREASE);
    r->degenerate_edges = n3i_count_flags(flags, r->edges, N3_EDGE_DEGENERATE);
}

/* The parameters of a patch at quarters of one of its sides, from its end if turned. */
NAGATA3_API void n3i_side_quarters(int side, int turned, n3_real uv[6])
{
    int i;
    for (i = 0; i < 3; i++) {
        n3_real t = (n3_real)(turned ? 3 - i : i + 1) / 4;
        uv[2 * i] = side == 0 ? t : side == 1 ? 1 - t : 0;
        uv[2 * i + 1] = side == 0 ? 0 : side == 1 ? t : 1 - t;
    }
}

NAGATA3_API void n3i_report_jump(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                 int edge, n3_report *r)
{
    static const int parent[6] = {0, 0, 0, 1, 1, 1};
    n3_patch p[2];
    n3_real uv[12];
    n3_vec n[6];
    int i, two[2];
    if (!n3i_is_regular(m, t, edge, two)) return;
    for (i = 0; i < 2; i++) {
        if (n3i_is_zero(n3i_face_of(m, two[i] / 3).normal)) return;
        p[i] = n3i_mesh_patch(m, t, net, two[i] / 3);
        n3i_side_quarters(two[i] % 3, i, uv + 6 * i);
    }
    n3_patch_normals(p, parent, uv, 0, 6, n);
    for (i = 0; i < 3; i++) {
        n3_real jump = n3_len(n3_sub(n[i], n[3 + i]));
        if (n3i_is_zero(n[i]) || n3i_is_zero(n[3 + i])) jump = 0;
        if (r->jump_edge >= 0 && !(jump > r->jump)) continue;
        r->jump = jump;
        r->jump_edge = edge;
    }
}

/* Across the plane of the triangle; where it has none, from the triangle's point of the same u
   and v. */
NAGATA3_API n3_real n3i_off_triangle(n3_vec x, const n3_patch *p, n3_vec face, int i, int j, int n)
{
    n3_real u = (n3_real)i / (n3_real)n, v = (n3_real)j / (n3_real)n;
    n3_vec way = n3_sub(x, n3i_mix(1 - u - v, p->p[0], u, p->p[1], v, p->p[2]));
    return n3i_is_zero(face) ? n3_len(way) : n3i_abs(n3_dot(way, face));
}

/* No point is farther than the control point that is farthest, taken at its own u and v. */
NAGATA3_API int n3i_may_be_beyond(const n3_patch *p, n3_vec face, n3_real distance)
{
    static const int place[7][2] = {{1, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    int i;
    for (i = 0; i < 7; i++)
        if (!(n3i_off_triangle(p->p[3 + i], p, face, place[i][0], place[i][1], 3) <= distance))
            return 1;
    return 0;
}

NAGATA3_API void n3i_report_distance(const n3_mesh *m, const n3_patch *p, int triangle,
                                     n3_report *r)
{
    n3_vec face = n3i_face_of(m, triangle).normal;
    int i, j;
    if (r->distance_triangle >= 0 && !n3i_may_be_beyond(p, face, r->distance)) return;
    for (j = 0; j <= 6; j++)
        for (i = 0; i <= 6 - j; i++) {
            n3_vec x = n3_patch_point(p, (n3_real)i / 6, (n3_real)j / 6);
            n3_real distance = n3i_off_triangle(x, p, face, i, j, 6);
            if (r->distance_triangle >= 0 && !(distance > r->distance)) continue;
            r->distance = distance;
            r->distance_triangle = triangle;
        }
}

NAGATA3_API n3_report n3_mesh_report(const n3_mesh *m, const n3_topology *t, const n3_vec *net,
                                     const unsigned *flags)
{
    const unsigned rough = N3_EDGE_CREASE | N3_EDGE_HALF_CREASE | N3_EDGE_DEGENERATE;
    n3_report r = n3i_report_empty(m);
    int i;
    for (i = 0; i < r.points; i++) r.bad_points += !n3i_is_finite(n3i_point(m, i));
    for (i = 0; i < r.normals; i++)
        r.bad_normals += !n3i_is_finite(n3i_vec_at(m->normal, m->normal_stride, i));
    n3i_report_triangles(m, &r);
    if (!t || t->points != r.points || t->triangles != r.triangles || r.bad_triangles) return r;
    n3i_report_topology(m, t, &r);
    if (!net || !flags) return r;
    n3i_report_flags(flags, &r);
    r.folding_patches = 0;
    for (i = 0; i < r.edges; i++)
        if (!(flags[i] & rough)) n3i_report_jump(m, t, net, i, &r);
    for (i = 0; i < r.triangles; i++) {
        n3_patch p = n3i_mesh_patch(m, t, net, i);
        if (n3i_is_collapsed(m, i)) continue;
        r.folding_patches += n3_patch_may_fold(&p);
        n3i_report_distance(m, &p, i, &r);
    }
    return r;
}

/* ---- Definitions: queries, boxes and parts ---- */

NAGATA3_API n3_box n3_patch_box(const n3_patch *p)
{
    n3_box box;
    int i;
    box.lo = box.hi = p->p[0];
    for (i = 1; i < 10; i++) {
        n3_vec a = p->p[i];
        box.lo = n3_v(a.x < box.lo.x ? a.x : box.lo.x, a.y < box.lo.y ? a.y : box.lo.y,
                      a.z < box.lo.z ? a.z : box.lo.z);
        box.hi = n3_v(n3i_larger(box.hi.x, a.x), n3i_larger(box.hi.y, a.y),
                      n3i_larger(box.hi.z, a.z));
    }
    return box;
}

/* The searches below cut the domain in halves. A cell is a part of the patch: its net, a row of ten
   for each coordinate, and the weights w, u, v of the patch at its three corners, all of them exact
   multiples of powers of 1/2. A cell is cut from its corner 2 to the middle m of the side between
   its corners 0 and 1, and m becomes the corner 2 of the halves, c a m and b c m:

             c                     Every second cut halves all sides. De Casteljau at 1/2 along
            /|\                    the rows that are parallel to ab makes both nets, from averages
           / | \                   (p + q) / 2 alone. These are the same in either order, so that a
          /  |  \                  side is cut into the same bits by the cells on both sides of it,
         a - m - b                 also where these belong to different patches.

   Nets shrink to their surface with the square of the cells' size: with d cuts, 2^-d times. After
   N3I_CUTS of them that is rounding, and no search cuts further. Each puts off one half while it
   looks at the other, so that there are never more than N3I_CUTS + 1 cells. */
enum { N3I_CUTS = N3I_PICK(54, 26) };

/* As many cells are looked at, or a few times as many. Degenerate patches can ask for more without
   end; of random nets less than one in ten thousand does. */
enum { N3I_CELLS = 500 };

typedef struct n3i_cell { n3_real x[3][10], weight[3][3]; int cuts; } n3i_cell;

typedef struct n3i_stack { n3i_cell cell[N3I_CUTS + 1]; int count; } n3i_stack;

NAGATA3_API void n3i_cell_set(n3i_cell *c, int i, n3_vec a)
{
    c->x[0][i] = a.x;
    c->x[1][i] = a.y;
    c->x[2][i] = a.z;
}

NAGATA3_API n3_vec n3i_cell_at(const n3i_cell *c, int i)
{
    return n3_v(c->x[0][i], c->x[1][i], c->x[2][i]);
}

/* All of the patch, and nothing in its net yet. */
NAGATA3_API void n3i_cell_start(n3i_cell *c)
{
    int i, k;
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) c->weight[i][k] = i == k;
    c->cuts = 0;
}

NAGATA3_API n3_real n3i_middle(n3_real a, n3_real b) { return (a + b) / 2; }

NAGATA3_API void n3i_cut_row(const n3_real x[10], n3_real a[10], n3_real b[10])
{
    n3_real l = n3i_middle(x[0], x[3]), h = n3i_middle(x[3], x[4]), r = n3i_middle(x[4], x[1]);
    n3_real lh = n3i_middle(l, h), hr = n3i_middle(h, r), m = n3i_middle(lh, hr);
    n3_real s = n3i_middle(x[8], x[9]), t = n3i_middle(x[9], x[5]);
    n3_real st = n3i_middle(s, t), top = n3i_middle(x[7], x[6]);
    a[0] = b[1] = x[2];
    a[1] = x[0];
    b[0] = x[1];
    a[2] = b[2] = m;
    a[3] = x[7];
    a[4] = x[8];
    b[3] = x[5];
    b[4] = x[6];
    a[5] = l;
    a[6] = lh;
    b[7] = hr;
    b[8] = r;
    a[7] = b[6] = st;
    a[8] = b[5] = top;
    a[9] = s;
    b[9] = t;
}

/* Replaces the top of the stack, of which c is a copy, by the halves of c; rows of the net. */
NAGATA3_API void n3i_cell_cut(n3i_stack *stack, const n3i_cell *c, int rows)
{
    n3i_cell *a = &stack->cell[stack->count], *b = a + 1;
    int k;
    for (k = 0; k < rows; k++) n3i_cut_row(c->x[k], a->x[k], b->x[k]);
    for (k = 0; k < 3; k++) {
        a->weight[0][k] = b->weight[1][k] = c->weight[2][k];
        a->weight[1][k] = c->weight[0][k];
        b->weight[0][k] = c->weight[1][k];
        a->weight[2][k] = b->weight[2][k] = n3i_middle(c->weight[0][k], c->weight[1][k]);
    }
    a->cuts = b->cuts = c->cuts + 1;
    stack->count += 2;
}

/* The largest of a row's numbers from the first up to but not with the last. */
NAGATA3_API n3_real n3i_highest(const n3_real *x, int first, int last)
{
    n3_real high = x[first];
    int i;
    for (i = first + 1; i < last; i++) high = n3i_larger(high, x[i]);
    return high;
}

/* A number not below the coordinate's maximum over the patch, and not more than gap above: the
   numbers at the corners are values, and no value is above all of the net's. */
NAGATA3_API n3_real n3i_ridge(const n3_real x[10], n3_real gap)
{
    n3i_stack stack;
    n3_real found = n3i_highest(x, 0, 3), bound = found;
    int looked = 0;
    n3i_cell_start(&stack.cell[0]);
    memcpy(stack.cell[0].x[0], x, sizeof stack.cell[0].x[0]);
    stack.count = 1;
    while (stack.count > 0) {
        n3i_cell c = stack.cell[--stack.count];
        n3_real high = n3i_highest(c.x[0], 0, 10);
        found = n3i_larger(found, n3i_highest(c.x[0], 0, 3));
        if (high > found + gap && c.cuts < N3I_CUTS && ++looked < N3I_CELLS) {
            n3i_cell_cut(&stack, &c, 1);
            continue;
        }
        bound = n3i_larger(bound, high);
    }
    return bound;
}

NAGATA3_API n3_box n3_patch_box_tight(const n3_patch *p, n3_real tolerance)
{
    n3_box net = n3_patch_box(p);
    n3_real side[6], x[10], gap;
    int i, k;
    gap = n3i_larger(tolerance, N3_EPS) * n3i_largest(n3_sub(net.hi, net.lo));
    for (k = 0; k < 6; k++) {
        for (i = 0; i < 10; i++) {
            n3_vec a = p->p[i];
            x[i] = k % 3 == 0 ? a.x : k % 3 == 1 ? a.y : a.z;
            if (k < 3) x[i] = -x[i];
        }
        side[k] = n3i_ridge(x, gap);
    }
    net.lo = n3_v(-side[0], -side[1], -side[2]);
    net.hi = n3_v(side[3], side[4], side[5]);
    return net;
}

/* With l_ijk = (k a + i b + j c) / 3 in place of p_ijk the patch is its triangle. So the difference
   is sum (p_ijk - l_ijk) B_ijk, which has no term at the corners, and the B of the others sum to
   1 - u^3 - v^3 - w^3 <= 8/9, with equality in the middle. */
NAGATA3_API n3_real n3_patch_flatness(const n3_patch *p)
{
    static const int part[7][3] = {{2, 1, 0}, {1, 2, 0}, {0, 2, 1}, {0, 1, 2},
                                   {1, 0, 2}, {2, 0, 1}, {1, 1, 1}};
    n3_real farthest = 0;
    int i;
    for (i = 0; i < 7; i++) {
        n3_vec sum = n3_v(0, 0, 0);
        int k;
        for (k = 0; k < 3; k++)
            sum = n3_add(sum, n3_mul((n3_real)part[i][k], n3_sub(p->p[3 + i], p->p[k])));
        farthest = n3i_larger(farthest, n3_len(sum));
    }
    return farthest / 3 * 8 / 9;
}

/* The polar form b(x, y, z) of the patch is linear in each of three points of the domain, does not
   depend on their order, and b(x, x, x) is the patch. The part with the corners A, B, C has the
   control points b(A^k, B^i, C^j). An argument takes a net of degree n to one of degree n - 1:
   q_ijk = w p_ij(k+1) + u p_(i+1)jk + v p_i(j+1)k. Nets lie in rows of constant j here. */
NAGATA3_API void n3i_polar(const n3_vec *from, int n, n3_real u, n3_real v, n3_vec *to)
{
    n3_real w = 1 - u - v;
    int i, j;
    for (j = 0; j < n; j++, from++)
        for (i = 0; i < n - j; i++, from++)
            *to++ = n3i_mix(w, from[0], u, from[1], v, from[n + 1 - j]);
}

/* Arguments are taken in the order of their u, then v, so that parts agree on what they share. */
NAGATA3_API n3_patch n3_patch_part(const n3_patch *p, const n3_real uv[6])
{
    static const int row[10] = {0, 3, 4, 1, 8, 9, 5, 7, 6, 2};
    static const int point[3][3][3] = {{{0, 3, 8}, {3, 4, 9}, {8, 9, 7}},
                                       {{3, 4, 9}, {4, 1, 5}, {9, 5, 6}},
                                       {{8, 9, 7}, {9, 5, 6}, {7, 6, 2}}};
    n3_vec cubic[10], quadratic[6], linear[3], corner[3];
    n3_patch r = *p;
    int i, k, l, a[3];
    for (i = 0; i < 10; i++) cubic[i] = p->p[row[i]];
    for (i = 0; i < 3; i++) {
        corner[i] = n3_v(uv[2 * i], uv[2 * i + 1], 0);
        for (k = i; k > 0 && n3i_order(corner[a[k - 1]], corner[i]) > 0; k--) a[k] = a[k - 1];
        a[k] = i;
    }
    for (i = 0; i < 3; i++) {
        n3i_polar(cubic, 3, corner[a[i]].x, corner[a[i]].y, quadratic);
        for (k = i; k < 3; k++) {
            n3i_polar(quadratic, 2, corner[a[k]].x, corner[a[k]].y, linear);
            for (l = k; l < 3; l++)
                n3i_polar(linear, 1, corner[a[l]].x, corner[a[l]].y, &r.p[point[a[i]][a[k]][a[l]]]);
        }
    }
    return r;
}

NAGATA3_API void n3_patch_split(const n3_patch *p, n3_real u, n3_real v, n3_patch out[3])
{
    int i, k;
    for (i = 0; i < 3; i++) {
        n3_real uv[6];
        for (k = 0; k < 6; k++) uv[k] = k == 2 || k == 5;
        uv[2 * i] = u;
        uv[2 * i + 1] = v;
        out[i] = n3_patch_part(p, uv);
    }
}

NAGATA3_API void n3_patch_split4(const n3_patch *p, n3_patch out[4])
{
    static const int twice[4][6] = {
        {0, 0, 1, 0, 0, 1}, {1, 0, 2, 0, 1, 1}, {0, 1, 1, 1, 0, 2}, {1, 1, 0, 1, 1, 0}};
    int i, k;
    for (i = 0; i < 4; i++) {
        n3_real uv[6];
        for (k = 0; k < 6; k++) uv[k] = (n3_real)twice[i][k] / 2;
        out[i] = n3_patch_part(p, uv);
    }
}

/* p times u + v + w: 4 q_ijk = i p_(i-1)jk + j p_i(j-1)k + k p_ij(k-1). */
NAGATA3_API void n3_patch_raise(const n3_patch *p, n3_vec out[15])
{
    static const int side[3][4] = {{0, 3, 4, 1}, {1, 5, 6, 2}, {2, 7, 8, 0}};
    static const int inner[3][3] = {{9, 3, 8}, {9, 5, 4}, {9, 7, 6}};
    const n3_vec *q = p->p;
    int i, k;
    for (i = 0; i < 3; i++) {
        out[i] = q[i];
        for (k = 1; k < 4; k++) {
            n3_vec a = q[side[i][k - 1]], b = q[side[i][k]];
            n3_vec sum = n3_add(n3_mul((n3_real)k, a), n3_mul((n3_real)(4 - k), b));
            out[2 + 3 * i + k] = n3i_over(sum, 4);
        }
        out[12 + i] = n3i_over(n3_add(n3_mul(2, q[inner[i][0]]),
                                      n3_add(q[inner[i][1]], q[inner[i][2]])), 4);
    }
}

/* ---- Definitions: queries, curvature ---- */

/* With the orthonormal t1 = du / |du|, t2 = n x t1: du = a t1, dv = b t1 + c t2. The shape operator
   S, symmetric, makes L = S11 a^2, M = a (S11 b + S12 c), N = S11 b^2 + 2 S12 b c + S22 c^2. Its
   eigenvalues are mean +- root; the eigenvector is taken from the row that does not cancel. */
NAGATA3_API void n3i_principal(n3_real s11, n3_real s12, n3_real s22, n3_vec t1, n3_curvature *r)
{
    n3_vec t2 = n3_cross(r->normal, t1);
    n3_real half = n3i_middle(s11, -s22), root = n3_len(n3_v(half, s12, 0)), x, y;
    r->mean = n3i_middle(s11, s22);
    r->gauss = s11 * s22 - s12 * s12;
    r->k[0] = r->mean + root;
    r->k[1] = r->mean - root;
    x = half >= 0 ? root + half : n3i_abs(s12);
    y = half >= 0 ? s12 : s12 < 0 ? half - root : root - half;
    r->t[0] = n3_unit(n3_add(n3_mul(x, t1), n3_mul(y, t2)));
    if (!(root > N3_NOISE * n3i_larger(r->k[0], -r->k[1]))) r->t[0] = t1;
    r->t[1] = n3_cross(r->normal, r->t[0]);
}

NAGATA3_API n3_curvature n3_patch_curvature(const n3_patch *p, n3_real u, n3_real v)
{
    n3_jet j = n3_patch_jet(p, u, v);
    n3_curvature r;
    n3_real size = n3i_larger(n3_len(j.du), n3_len(j.dv)), a, b, c, s11, s12;
    n3_vec t1 = n3_unit(j.du), du, dv;
    memset(&r, 0, sizeof r);
    r.normal = n3_patch_normal(p, u, v);
    r.E = n3_dot(j.du, j.du);
    r.F = n3_dot(j.du, j.dv);
    r.G = n3_dot(j.dv, j.dv);
    r.L = n3_dot(r.normal, j.duu);
    r.M = n3_dot(r.normal, j.duv);
    r.N = n3_dot(r.normal, j.dvv);
    if (!(size > 0)) return r;
    du = n3i_over(j.du, size);
    dv = n3i_over(j.dv, size);
    if (!(n3_len(n3_cross(du, dv)) > N3_NOISE)) return r;
    a = n3_len(du);
    b = n3_dot(dv, t1);
    c = n3_dot(dv, n3_cross(r.normal, t1));
    s11 = r.L / size / a / a;
    s12 = (r.M / size / a - b * s11) / c;
    n3i_principal(s11 / size, s12 / size, (r.N / size - b * (b * s11 + 2 * c * s12)) / c / c / size,
                  t1, &r);
    return r;
}

/* ---- Definitions: queries, the nearest point ---- */

/* Of a squared distance what its bounds cannot tell: they are sums of products of control points,
   in units of the square of the largest distance to one. */
#define N3_BOUND (16 * N3_EPS)

/* A foot whose weight at a corner is at most this is on the side across. */
#define N3_ON_SIDE (64 * N3_EPS)

/* A step of Newton's this long is the last: the next would be as long as its square. */
#define N3_LAST_STEP (N3I_PICK((n3_real)1 / 67108864, (n3_real)1 / 4096))

/* The squared distance along a curve, seen from the point, and its least value so far. */
typedef struct n3i_near1 { n3_real t, d; } n3i_near1;

/* The Bernstein coefficients of |x|^2, of degree 6, from the products of the control points. */
NAGATA3_API void n3i_square1(const n3_vec p[4], n3_real c[7])
{
    c[0] = n3_dot(p[0], p[0]);
    c[1] = n3_dot(p[0], p[1]);
    c[2] = (2 * n3_dot(p[0], p[2]) + 3 * n3_dot(p[1], p[1])) / 5;
    c[3] = (n3_dot(p[0], p[3]) + 9 * n3_dot(p[1], p[2])) / 10;
    c[4] = (2 * n3_dot(p[1], p[3]) + 3 * n3_dot(p[2], p[2])) / 5;
    c[5] = n3_dot(p[2], p[3]);
    c[6] = n3_dot(p[3], p[3]);
}

/* Value at t of the polynomial of degree n with the Bernstein coefficients c, and n times less than
   its derivative. */
NAGATA3_API n3_real n3i_bernstein(const n3_real *c, int n, n3_real t, n3_real *slope)
{
    n3_real b[7];
    int i, k;
    for (i = 0; i <= n; i++) b[i] = c[i];
    for (k = n; k > 1; k--)
        for (i = 0; i < k; i++) b[i] = (1 - t) * b[i] + t * b[i + 1];
    *slope = b[1] - b[0];
    return (1 - t) * b[0] + t * b[1];
}

/* The minimum of a convex polynomial of degree 6 on [0, 1]: Newton on its derivative, held between
   arguments where this is below and above zero. */
NAGATA3_API n3_real n3i_minimum1(const n3_real c[7])
{
    n3_real g[6], lo = 0, hi = 1, t, value, slope;
    int i;
    for (i = 0; i < 6; i++) g[i] = c[i + 1] - c[i];
    if (g[0] >= 0) return 0;
    if (g[5] <= 0) return 1;
    t = g[0] / (g[0] - g[5]);
    for (i = 0; i < 2 * N3I_CUTS; i++) {
        n3_real last = t;
        value = n3i_bernstein(g, 5, t, &slope);
        if (value > 0) hi = t;
        else lo = t;
        t -= slope > 0 ? value / (5 * slope) : 1;
        if (!(t > lo && t < hi)) t = n3i_middle(lo, hi);
        if (!(n3i_abs(t - last) > N3_EPS)) break;
    }
    return t;
}

/* Looks at the part of the curve from t on that is h long in t, in the curve's own units; returns
   whether it has to be halved. */
NAGATA3_API int n3i_look1(const n3_edge *e, n3_real t, n3_real h, n3i_near1 *best)
{
    n3_real c[7], low, high, s, slope, d;
    int i, convex = 1;
    n3i_square1(e->p, c);
    low = high = c[0];
    for (i = 0; i < 7; i++) {
        low = c[i] < low ? c[i] : low;
        high = n3i_larger(high, c[i]);
        if (i < 5 && c[i] - c[i + 1] + (c[i + 2] - c[i + 1]) < 0) convex = 0;
    }
    if (!(low < best->d - N3_BOUND * high)) return 0;
    s = convex ? n3i_minimum1(c) : c[0] <= c[6] ? 0 : 1;
    d = n3i_bernstein(c, 6, s, &slope);
    if (d < best->d) {
        best->d = d;
        best->t = t + h * s;
    }
    return !convex;
}

/* Over the whole curve, in canonical direction and relative to the point, size 1. */
NAGATA3_API n3i_near1 n3i_search1(const n3_edge *whole)
{
    n3_edge stack[N3I_CUTS + 1];
    n3_real start[N3I_CUTS + 1], length[N3I_CUTS + 1];
    n3i_near1 best;
    int count = 1, looked = 0;
    best.t = start[0] = 0;
    best.d = 4;
    length[0] = 1;
    stack[0] = *whole;
    while (count > 0 && looked++ < N3I_CELLS) {
        n3_edge e = stack[--count];
        n3_real t = start[count], h = length[count] / 2;
        if (!n3i_look1(&e, t, 2 * h, &best) || count + 2 > N3I_CUTS) continue;
        n3_edge_split(&e, (n3_real)1 / 2, &stack[count]);
        start[count] = t;
        start[count + 1] = t + h;
        length[count] = length[count + 1] = h;
        count += 2;
    }
    return best;
}

/* The differences to a point, divided by the largest of their components; returns this. */
NAGATA3_API n3_real n3i_relative(const n3_vec *p, int count, n3_vec q, n3_vec *out)
{
    n3_real size = 0;
    int i;
    for (i = 0; i < count; i++) {
        out[i] = n3_sub(p[i], q);
        size = n3i_larger(size, n3i_largest(out[i]));
    }
    for (i = 0; i < count && size > 0; i++) out[i] = n3_mul(1 / size, out[i]);
    return size;
}

/* 1 - t is exact in the end, and 1 - (1 - t) is t. */
NAGATA3_API n3_real n3_edge_nearest(const n3_edge *e, n3_vec q)
{
    int back = n3i_edge_order(e) > 0;
    n3_edge c = back ? n3_edge_reverse(e) : *e;
    n3_real t;
    n3i_relative(c.p, 4, q, c.p);
    t = n3i_search1(&c).t;
    t = t <= N3_ON_SIDE ? 1 : 1 - t <= N3_ON_SIDE ? 0 : 1 - t;
    return back ? t : 1 - t;
}

/* The patch seen from the point, x and its derivatives at the weights w; the squared distance
   d = <x, x>, and half of its first and second derivatives in u and v: g, h as uu, uv, vv. */
typedef struct n3i_form { n3_vec x, du, dv; n3_real d, g[2], h[3]; } n3i_form;

/* Value, du, dv, duu, duv, dvv of a row, as in n3_patch_jet. */
NAGATA3_API void n3i_row_jet(const n3_real x[10], const n3_real w[3], n3_real j[6])
{
    n3_real r002 = w[0] * x[0] + w[1] * x[3] + w[2] * x[8];
    n3_real r200 = w[0] * x[4] + w[1] * x[1] + w[2] * x[5];
    n3_real r020 = w[0] * x[7] + w[1] * x[6] + w[2] * x[2];
    n3_real r101 = w[0] * x[3] + w[1] * x[4] + w[2] * x[9];
    n3_real r110 = w[0] * x[9] + w[1] * x[5] + w[2] * x[6];
    n3_real r011 = w[0] * x[8] + w[1] * x[9] + w[2] * x[7];
    n3_real pw = w[0] * r002 + w[1] * r101 + w[2] * r011;
    n3_real pu = w[0] * r101 + w[1] * r200 + w[2] * r110;
    n3_real pv = w[0] * r011 + w[1] * r110 + w[2] * r020;
    j[0] = w[0] * pw + w[1] * pu + w[2] * pv;
    j[1] = 3 * (pu - pw);
    j[2] = 3 * (pv - pw);
    j[3] = 6 * (r200 - r101 + (r002 - r101));
    j[4] = 6 * (r110 - r101 + (r002 - r011));
    j[5] = 6 * (r020 - r011 + (r002 - r011));
}

NAGATA3_API n3i_form n3i_form_at(const n3i_cell *c, const n3_real w[3])
{
    n3_real x[6], y[6], z[6];
    n3i_form f;
    int i;
    n3i_row_jet(c->x[0], w, x);
    n3i_row_jet(c->x[1], w, y);
    n3i_row_jet(c->x[2], w, z);
    f.x = n3_v(x[0], y[0], z[0]);
    f.du = n3_v(x[1], y[1], z[1]);
    f.dv = n3_v(x[2], y[2], z[2]);
    f.d = n3_dot(f.x, f.x);
    f.g[0] = n3_dot(f.x, f.du);
    f.g[1] = n3_dot(f.x, f.dv);
    f.h[0] = n3_dot(f.du, f.du);
    f.h[1] = n3_dot(f.du, f.dv);
    f.h[2] = n3_dot(f.dv, f.dv);
    for (i = 0; i < 3; i++) f.h[i] += n3_dot(f.x, n3_v(x[3 + i], y[3 + i], z[3 + i]));
    return f;
}

/* Whether a step leads out of the triangle at once. */
NAGATA3_API int n3i_is_blocked(const n3_real w[3], const n3_real step[3])
{
    int i;
    for (i = 0; i < 3; i++)
        if (w[i] <= 0 && step[i] < 0) return 1;
    return 0;
}

/* Newton's step h step = -g. Where h is not positive definite both of its eigenvalues are raised so
   far that the smaller one is a 64th of what they were. */
NAGATA3_API void n3i_free_step(const n3i_form *f, n3_real step[3])
{
    n3_real uu = f->h[0], uv = f->h[1], vv = f->h[2], det = uu * vv - uv * uv;
    step[1] = step[2] = step[0] = 0;
    if (!(uu > 0 && det > N3_NOISE * uu * vv)) {
        n3_real half = n3i_middle(uu, -vv), root = n3i_sqrt(half * half + uv * uv);
        n3_real mean = n3i_middle(uu, vv), raised = root - mean + (n3i_abs(mean) + root) / 64;
        uu += raised;
        vv += raised;
        det = uu * vv - uv * uv;
    }
    if (!(det > 0)) return;
    step[1] = (uv * f->g[1] - vv * f->g[0]) / det;
    step[2] = (uv * f->g[0] - uu * f->g[1]) / det;
    step[0] = -step[1] - step[2];
}

/* The same along the side across corner i; where it bends down, to the end. */
NAGATA3_API void n3i_side_step(const n3i_form *f, int i, n3_real step[3])
{
    n3_real e[3], h, g;
    e[i] = 0;
    e[(i + 1) % 3] = 1;
    e[(i + 2) % 3] = -1;
    g = f->g[0] * e[1] + f->g[1] * e[2];
    h = f->h[0] * e[1] * e[1] + 2 * f->h[1] * e[1] * e[2] + f->h[2] * e[2] * e[2];
    g = h > 0 ? -g / h : g > 0 ? -1 : g < 0 ? 1 : 0;
    for (i = 0; i < 3; i++) step[i] = g * e[i];
}

/* A step that stays in the triangle, along a side if need be; the zero step where d has a minimum
   on the triangle. next: where it leads, no farther than to the next side. Returns its size. */
NAGATA3_API n3_real n3i_step(const n3i_form *f, const n3_real w[3], n3_real next[3])
{
    n3_real step[3], part = 1;
    int i, across = -1;
    n3i_free_step(f, step);
    for (i = 0; i < 3 && n3i_is_blocked(w, step); i++)
        if (w[i] <= 0) n3i_side_step(f, i, step);
    if (n3i_is_blocked(w, step)) return 0;
    for (i = 0; i < 3; i++)
        if (w[i] + part * step[i] < 0) {
            part = w[i] / -step[i];
            across = i;
        }
    for (i = 0; i < 3; i++) next[i] = i == across ? 0 : w[i] + part * step[i];
    return part * n3i_larger(n3i_larger(n3i_abs(step[0]), n3i_abs(step[1])), n3i_abs(step[2]));
}

/* From w to a minimum of d on the triangle. A step that does not go down is halved; one shorter
   than the root of eps is the last, as it changes d by rounding. Returns the form before it. */
NAGATA3_API n3i_form n3i_descend(const n3i_cell *c, n3_real w[3])
{
    n3i_form f = n3i_form_at(c, w);
    n3_real next[3], size = n3i_step(&f, w, next);
    int i, k;
    for (i = 0; i < N3I_CUTS && size > N3_LAST_STEP; i++) {
        n3i_form g = n3i_form_at(c, next);
        if (g.d > f.d) {
            for (k = 0; k < 3; k++) next[k] = n3i_middle(w[k], next[k]);
            size /= 2;
            continue;
        }
        for (k = 0; k < 3; k++) w[k] = next[k];
        f = g;
        size = n3i_step(&f, w, next);
    }
    for (k = 0; k < 3 && size > 0; k++) w[k] = next[k];
    return f;
}

/* The least squared distance so far: the weights on the patch, the point, and <x, du x dv>. */
typedef struct n3i_near2 { n3_real w[3], d, turn; n3_vec x; } n3i_near2;

/* The Bernstein coefficients of |x|^2, of degree 6, at [7 i + j], i and j the exponents of u and v:
   the products of the control points, in rows of constant j, times the ratio of the trinomials,
   twice for each pair. Their least and largest, too. */
NAGATA3_API void n3i_square2(const n3i_cell *c, n3_real out[49], n3_real range[2])
{
    static const int row[10] = {0, 3, 4, 1, 8, 9, 5, 7, 6, 2};
    static const int times[10] = {1, 3, 3, 1, 3, 6, 3, 3, 3, 1};
    static const int at[10] = {0, 7, 14, 21, 1, 8, 15, 2, 9, 3};
    const n3_real r6 = (n3_real)1 / 6, r15 = (n3_real)1 / 15, r20 = (n3_real)1 / 20;
    const n3_real r30 = r15 / 2, r60 = r30 / 2, r90 = r30 / 3;
    const n3_real share[28] = {1,   r6,  r15, r20, r15, r6,  1,   r6,  r30, r60, r60, r30, r6, r15,
                               r60, r90, r60, r15, r20, r60, r60, r20, r15, r30, r15, r6,  r6, 1};
    n3_vec p[10];
    int a, b, k = 0;
    memset(out, 0, 49 * sizeof(n3_real));
    for (a = 0; a < 10; a++) {
        n3_vec x = n3i_cell_at(c, row[a]);
        p[a] = n3_mul((n3_real)times[a], x);
        x = n3_add(p[a], p[a]);
        out[2 * at[a]] += n3_dot(p[a], p[a]);
        for (b = 0; b < a; b++) out[at[a] + at[b]] += n3_dot(x, p[b]);
    }
    range[0] = range[1] = out[0];
    for (a = 0; a < 7; a++)
        for (b = 0; a + b < 7; b++) {
            n3_real q = out[7 * a + b] * share[k++];
            out[7 * a + b] = q;
            range[0] = q < range[0] ? q : range[0];
            range[1] = n3i_larger(range[1], q);
        }
}

/* Second differences are a thirtieth of the Bernstein coefficients of the second derivatives, and a
   matrix with those of the same exponents is one coefficient of the Hessian. Returns m >= 0 such
   that no eigenvalue of any of them is below -m; so -30 m is a bound for the Hessian's, and 0 says
   that the polynomial is convex. */
NAGATA3_API n3_real n3i_concavity(const n3_real coefficient[49])
{
    n3_real most = 0;
    int i, j;
    for (i = 0; i < 5; i++)
        for (j = 0; i + j < 5; j++) {
            const n3_real *q = coefficient + 7 * i + j;
            n3_real uu = q[14] - q[7] - (q[7] - q[0]), vv = q[2] - q[1] - (q[1] - q[0]);
            n3_real uv = q[8] - q[7] - (q[1] - q[0]);
            n3_real half = n3i_middle(uu, -vv);
            if (uu > 0 && uu * vv > uv * uv) continue;
            most = n3i_larger(most, n3i_sqrt(half * half + uv * uv) - n3i_middle(uu, vv));
        }
    return most;
}

/* Descends in a cell, from weights on it; returns the d of the minimum. */
NAGATA3_API n3_real n3i_improve(const n3i_cell *c, n3_real w[3], n3i_near2 *best)
{
    n3i_form f = n3i_descend(c, w);
    int k;
    if (!(f.d < best->d)) return f.d;
    for (k = 0; k < 3; k++)
        best->w[k] = w[0] * c->weight[0][k] + w[1] * c->weight[1][k] + w[2] * c->weight[2][k];
    best->d = f.d;
    best->x = f.x;
    best->turn = n3_dot(f.x, n3_cross(f.du, f.dv));
    return f.d;
}

/* No point of the cell is nearer than the best when all its control points lie beyond the plane
   through that, across the way to it. */
NAGATA3_API int n3i_is_beyond(const n3i_cell *c, const n3i_near2 *best)
{
    n3_real level = best->d - N3_BOUND * n3i_largest(best->x);
    int i;
    for (i = 0; i < 10; i++)
        if (!(n3_dot(n3i_cell_at(c, i), best->x) >= level)) return 0;
    return 1;
}

/* The weights of the point of the triangle of the corners that is nearest, or of one on its sides
   that is not far from that. */
NAGATA3_API void n3i_project(const n3i_cell *c, n3_real w[3])
{
    n3_vec x = n3i_cell_at(c, 0);
    n3_vec b = n3_sub(n3i_cell_at(c, 1), x), e = n3_sub(n3i_cell_at(c, 2), x);
    n3_real bb = n3_dot(b, b), be = n3_dot(b, e), ee = n3_dot(e, e), det = bb * ee - be * be, sum;
    n3_real xb = n3_dot(x, b), xe = n3_dot(x, e);
    w[0] = w[1] = w[2] = (n3_real)1 / 3;
    if (!(det > N3_NOISE * bb * ee)) return;
    w[1] = n3i_larger((be * xe - ee * xb) / det, 0);
    w[2] = n3i_larger((be * xb - bb * xe) / det, 0);
    w[0] = n3i_larger(1 - w[1] - w[2], 0);
    sum = w[0] + w[1] + w[2];
    w[1] /= sum;
    w[2] /= sum;
    w[0] /= sum;
}

/* First differences are, but for a factor, the Bernstein coefficients of the derivatives along the
   sides. Where one has one sign, d falls all the way along parallels to that side, to another side.
   Returns the corner across that, or -1. */
NAGATA3_API int n3i_downhill(const n3_real coefficient[49])
{
    int up[3] = {1, 1, 1}, down[3] = {1, 1, 1}, i, j;
    for (i = 0; i < 6; i++)
        for (j = 0; i + j < 6; j++) {
            const n3_real *q = coefficient + 7 * i + j;
            up[0] &= q[7] >= q[0];
            down[0] &= q[7] <= q[0];
            up[1] &= q[1] >= q[0];
            down[1] &= q[1] <= q[0];
            up[2] &= q[7] >= q[1];
            down[2] &= q[7] <= q[1];
        }
    if (up[0] || up[2]) return 1;
    if (down[0] || down[1]) return 0;
    return up[1] || down[2] ? 2 : -1;
}

/* The minimum of a cell that lies on the side across a corner. */
NAGATA3_API void n3i_settle_side(const n3i_cell *c, int corner, n3i_near2 *best)
{
    static const int side[3][4] = {{1, 5, 6, 2}, {2, 7, 8, 0}, {0, 3, 4, 1}};
    n3i_near1 found;
    n3_real w[3];
    n3_edge e;
    int i;
    for (i = 0; i < 4; i++) e.p[i] = n3i_cell_at(c, side[corner][i]);
    found = n3i_search1(&e);
    w[corner] = 0;
    w[(corner + 1) % 3] = 1 - found.t;
    w[(corner + 2) % 3] = found.t;
    if (found.d < best->d) n3i_improve(c, w, best);
}

/* Looks at a cell; returns whether it has to be cut. No value of d is below the least coefficient.
   Nor, with the Hessian's eigenvalues above -30 m and a minimum on the cell at y, below
   d(y) - 30 m: at z on the cell it is at least d(y) + <gradient, z - y> - 15 m |z - y|^2, where the
   product is not negative and |z - y|^2 <= 2. That bound only costs what is not convex: it settles
   the cells round the foot, which the first could not but by cutting them down to rounding. Cells
   that go downhill to a side are settled there, also where d is convex along it and concave
   across. */
NAGATA3_API int n3i_look2(const n3i_cell *c, n3i_near2 *best)
{
    n3_real q[49], w[3], range[2], corner, concave, bound, d = best->d;
    int side;
    if (n3i_is_beyond(c, best)) return 0;
    n3i_square2(c, q, range);
    bound = N3_BOUND * range[1];
    if (!(range[0] < best->d - bound)) return 0;
    corner = -n3i_larger(-q[0], n3i_larger(-q[42], -q[6]));
    concave = 30 * n3i_concavity(q);
    if (concave <= n3i_larger(corner - best->d, 0) + bound || corner < best->d) {
        if (c->cuts > 0) {
            n3i_project(c, w);
            d = n3i_improve(c, w, best);
        }
        if (!(d - concave < best->d - bound)) return 0;
    }
    side = n3i_downhill(q);
    if (side >= 0) n3i_settle_side(c, side, best);
    return side < 0 && c->cuts < N3I_CUTS;
}

/* A best foot on sides of the patch becomes the curve's own foot there. */
NAGATA3_API void n3i_settle(const n3_patch *p, n3_vec q, const n3i_cell *root, n3i_near2 *best)
{
    n3_edge e[3];
    n3_real was[3], shortest = 0;
    n3i_form f;
    int i, k, found = 0;
    for (i = 0; i < 3; i++) was[i] = best->w[i];
    for (i = 0; i < 3; i++) {
        n3_real t, length;
        k = (i + 1) % 3;
        if (!(was[i] <= N3_ON_SIDE)) continue;
        n3_patch_edges(p, e);
        t = n3_edge_nearest(&e[k], q);
        length = n3_len(n3_sub(n3_edge_point(&e[k], t), q));
        if (found && !(length < shortest)) continue;
        found = 1;
        shortest = length;
        best->w[i] = 0;
        best->w[k] = 1 - t;
        best->w[(i + 2) % 3] = t;
    }
    if (!found) return;
    f = n3i_form_at(root, best->w);
    best->turn = n3_dot(f.x, n3_cross(f.du, f.dv));
}

NAGATA3_API n3_foot n3_patch_nearest(const n3_patch *p, n3_vec q)
{
    n3i_stack stack;
    n3i_near2 best;
    n3_vec net[10];
    n3i_cell root;
    n3_real w[3], sum = 0;
    n3_foot foot;
    int i, looked = 0;
    n3i_relative(p->p, 10, q, net);
    n3i_cell_start(&root);
    for (i = 0; i < 10; i++) {
        n3i_cell_set(&root, i, net[i]);
        sum += net[i].x + net[i].y + net[i].z;
    }
    n3i_project(&root, w);
    memset(&best, 0, sizeof best);
    best.d = 4;
    n3i_improve(&root, w, &best);
    stack.count = 0;
    if (n3i_look2(&root, &best)) n3i_cell_cut(&stack, &root, 3);
    while (stack.count > 0 && looked++ < 4 * N3I_CELLS) {
        n3i_cell c = stack.cell[--stack.count];
        if (n3i_look2(&c, &best)) n3i_cell_cut(&stack, &c, 3);
    }
    while (stack.count > 0) {
        const n3i_cell *c = &stack.cell[--stack.count];
        n3i_project(c, w);
        n3i_improve(c, w, &best);
    }
    if (!(sum - sum <= 0)) best.w[0] = best.w[1] = best.w[2] = best.turn = sum - sum;
    n3i_settle(p, q, &root, &best);
    foot.u = best.w[1];
    foot.v = best.w[2];
    foot.x = n3_patch_point(p, foot.u, foot.v);
    net[0] = n3_sub(q, foot.x);
    foot.distance2 = n3_dot(net[0], net[0]);
    foot.side = best.turn < 0 ? 1 : best.turn > 0 ? -1 : 0;
    return foot;
}

/* ---- Definitions: queries, rays ---- */

/* Seen along the ray the patch is a map f of its triangle into a plane, and it is met where f = 0.
   Let k be the largest component of the direction d; the two others of

       f = x - from - (x - from)_k d / d_k

   are f, without a root and without a division by what may vanish, and as affine a map of x as any:
   <d, du x dv> / d_k is the determinant of its Jacobian.

   Which patch owns a hit is decided by signs of numbers that neighbours share, and by nothing else.
   The curve f of the boundary winds around 0 as many times as the patch is met from behind less the
   times it is met from the front, and the winding number is the sum over the sides of how many
   times they cross the half axis f2 = 0, f1 >= 0 upwards less downwards:

       f2 >= 0 at all four control points, or < 0 at all of them, or f1 < 0 at all of them: 0
       f1 >= 0 at all of them: [f2 >= 0 at the end] - [f2 >= 0 at the beginning]
       else: the sum of the halves, from averages (p + q) / 2

   with f1 >= 0 at all of them taken for f1 >= 0 on the whole after N3I_CUTS halvings. So defined,
   the count C of a side is, in floating-point arithmetic and not only in theory,

       odd: the side run backwards has -C, because averages and tests are the same from both ends;
       additive: C is the sum of the C of its halves, because an average of numbers >= 0 is >= 0 and
       of numbers < 0 is < 0 (underflow aside), so that a rule that holds for a side holds for its
       halves, and the differences in the second telescope.

   Hence the winding numbers of the cells of a patch add up to its own, whichever are cut; those of
   the patches of a closed mesh add up to zero; and a cell whose control points have all f1 >= 0, or
   < 0, or so f2, has the number zero and can be dropped. Where the Jacobian has one sign on a cell
   as its Bernstein coefficients show, its winding number says how many hits there are: none, or one
   that Newton finds. Other cells are cut. When one is as small as rounding its winding number still
   says how many hits it has to answer for. */
NAGATA3_API int n3i_crossings(const n3_real x[10], const n3_real y[10], const int at[4],
                              int halvings)
{
    n3_real stack[N3I_CUTS + 2][8];
    int left[N3I_CUTS + 2], count = 1, crossings = 0, i;
    for (i = 0; i < 4; i++) {
        stack[0][i] = x[at[i]];
        stack[0][4 + i] = y[at[i]];
    }
    left[0] = halvings;
    while (count > 0) {
        n3_real *p = stack[--count], *q = stack[count + 1];
        int up = (p[4] >= 0) + (p[5] >= 0) + (p[6] >= 0) + (p[7] >= 0);
        int right = (p[0] >= 0) + (p[1] >= 0) + (p[2] >= 0) + (p[3] >= 0);
        if (right == 0 || up == 0 || up == 4) continue;
        if (right == 4 || left[count] == 0) {
            if (right == 4 || p[0] + p[3] >= 0) crossings += (p[7] >= 0) - (p[4] >= 0);
            continue;
        }
        left[count + 1] = --left[count];
        for (i = 0; i < 2; i++, p += 4, q += 4) {
            n3_real middle = n3i_middle(p[1], p[2]);
            q[3] = p[3];
            q[2] = n3i_middle(p[2], p[3]);
            p[1] = n3i_middle(p[0], p[1]);
            p[2] = n3i_middle(p[1], middle);
            q[1] = n3i_middle(middle, q[2]);
            q[0] = p[3] = n3i_middle(p[2], q[1]);
        }
        count += 2;
    }
    return crossings;
}

/* The winding number of a cell's boundary. A cut halves the side from corner 0 to 1; the two others
   are the next to be halved. */
NAGATA3_API int n3i_winding(const n3i_cell *c)
{
    static const int side[3][4] = {{0, 3, 4, 1}, {1, 5, 6, 2}, {2, 7, 8, 0}};
    int i, sum = 0;
    for (i = 0; i < 3; i++)
        sum += n3i_crossings(c->x[0], c->x[1], side[i], (2 * N3I_CUTS + (i == 0) - c->cuts) / 2);
    return sum;
}

/* f of the patch along a direction whose component k is its largest; returns the largest number
   in it. */
NAGATA3_API n3_real n3i_look_along(const n3_patch *p, n3_vec from, n3_vec d, int k, n3i_cell *c)
{
    n3_real size = 0, dx, dy, dk = k == 0 ? d.x : k == 1 ? d.y : d.z;
    int i;
    n3i_cell_start(c);
    dx = (k == 0 ? d.y : k == 1 ? d.z : d.x) / dk;
    dy = (k == 0 ? d.z : k == 1 ? d.x : d.y) / dk;
    for (i = 0; i < 10; i++) {
        n3_vec a = n3_sub(p->p[i], from);
        if (k == 0) a = n3_v(a.y, a.z, a.x);
        if (k == 1) a = n3_v(a.z, a.x, a.y);
        c->x[0][i] = a.x - dx * a.z;
        c->x[1][i] = a.y - dy * a.z;
        size = n3i_larger(size, n3i_larger(n3i_abs(c->x[0][i]), n3i_abs(c->x[1][i])));
    }
    return size;
}

/* The largest component, -1 if none is above zero. */
NAGATA3_API int n3i_main_axis(n3_vec d)
{
    n3_real x = n3i_abs(d.x), y = n3i_abs(d.y), z = n3i_abs(d.z);
    if (!(x + y + z > 0)) return -1;
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/* The Bernstein coefficients of the determinant of the Jacobian of scale f at [5 i + j], the
   exponents of u and v, but for a factor above 0 each: as n3i_normal_net, in a plane. Returns the
   largest product in them. */
NAGATA3_API n3_real n3i_jacobian(const n3i_cell *c, n3_real scale, n3_real out[25])
{
    static const int from[6] = {0, 4, 7, 3, 9, 8}, to_u[6] = {3, 1, 6, 4, 5, 9};
    static const int to_v[6] = {8, 5, 2, 9, 6, 7}, at[6] = {0, 10, 2, 5, 6, 1};
    n3_real u[2][6], v[2][6], largest_u = 0, largest_v = 0;
    int a, b;
    memset(out, 0, 25 * sizeof(n3_real));
    for (a = 0; a < 6; a++) {
        n3_real twice = a > 2 ? 2 * scale : scale;
        for (b = 0; b < 2; b++) {
            u[b][a] = twice * (c->x[b][to_u[a]] - c->x[b][from[a]]);
            v[b][a] = twice * (c->x[b][to_v[a]] - c->x[b][from[a]]);
            largest_u = n3i_larger(largest_u, n3i_abs(u[b][a]));
            largest_v = n3i_larger(largest_v, n3i_abs(v[b][a]));
        }
    }
    for (a = 0; a < 6; a++)
        for (b = 0; b < 6; b++) out[at[a] + at[b]] += u[0][a] * v[1][b] - u[1][a] * v[0][b];
    return largest_u * largest_v;
}

/* Whether the determinant has one sign on the cell, or is rounding: no two hits on it cancel. */
NAGATA3_API int n3i_is_simple(const n3i_cell *c, n3_real scale)
{
    n3_real det[25], high = 0, low = 0, noise = N3_NOISE * n3i_jacobian(c, scale, det);
    int i, j, zero = 0;
    for (i = 0; i < 5; i++)
        for (j = 0; i + j < 5; j++) {
            n3_real d = det[5 * i + j];
            high = n3i_larger(high, d);
            low = n3i_larger(low, -d);
            zero += !(n3i_abs(d) > 0);
        }
    return (zero == 0 && !(high > 0 && low > 0)) || (high <= noise && low <= noise);
}

/* One step of Newton's towards f = 0 from the weights w, held on the cell: a weight that it makes
   negative is zero. Returns its size, -1 where it fails; held: whether it was. */
NAGATA3_API n3_real n3i_zero_step(const n3_real f[6], const n3_real g[6], n3_real w[3], int *held)
{
    n3_real det = f[1] * g[2] - f[2] * g[1], next[3], sum = 0, size = 0;
    int k;
    if (!(n3i_abs(det) > 0)) return -1;
    next[1] = (f[2] * g[0] - f[0] * g[2]) / det;
    next[2] = (f[0] * g[1] - f[1] * g[0]) / det;
    next[0] = -next[1] - next[2];
    *held = 0;
    for (k = 0; k < 3; k++) {
        next[k] += w[k];
        if (!(next[k] >= 0)) *held = 1;
        next[k] = n3i_larger(next[k], 0);
        sum += next[k];
    }
    if (!(sum > 0)) return -1;
    for (k = 0; k < 3; k++) {
        size = n3i_larger(size, n3i_abs(next[k] / sum - w[k]));
        w[k] = next[k] / sum;
    }
    return size;
}

/* The zero of f on a cell; whether it was found. Steps of Newton's follow each other as b = C a^2;
   when the next would be below eps, b^3 <= eps a^2, they end. Held on a side they do not: there the
   zero may be just outside, and f tells. */
NAGATA3_API int n3i_zero(const n3i_cell *c, n3_real scale, n3_real w[3])
{
    n3_real f[6], g[6], last = 1;
    int i, k, held = 0;
    w[0] = w[1] = w[2] = (n3_real)1 / 3;
    for (i = 0; i < 16; i++) {
        n3_real size;
        n3i_row_jet(c->x[0], w, f);
        n3i_row_jet(c->x[1], w, g);
        for (k = 0; k < 3; k++) {
            f[k] *= scale;
            g[k] *= scale;
        }
        if (held && n3i_abs(f[0]) + n3i_abs(g[0]) <= N3_ON_SIDE) return 1;
        size = n3i_zero_step(f, g, w, &held);
        if (size < 0) return 0;
        if (!held && size <= N3_LAST_STEP && size * size * size <= N3_EPS * last * last) return 1;
        last = size;
    }
    return 0;
}

/* The hit at the weights w of a cell. On the side bc, w = 0, v is made 1 - u. */
NAGATA3_API n3_hit n3i_hit_at(const n3_patch *p, n3_vec from, n3_vec d, int k, const n3i_cell *c,
                              const n3_real w[3])
{
    n3_hit hit;
    n3_real on[3];
    n3_vec way;
    int i, sound = w[0] >= 0 && w[1] >= 0 && w[2] >= 0;
    for (i = 0; i < 3; i++)
        on[i] = sound ? w[0] * c->weight[0][i] + w[1] * c->weight[1][i] + w[2] * c->weight[2][i]
                      : c->weight[0][i];
    hit.u = on[1];
    hit.v = on[0] > 0 ? on[2] : 1 - on[1];
    hit.x = n3_patch_point(p, hit.u, hit.v);
    way = n3_sub(hit.x, from);
    hit.t = k == 0 ? way.x / d.x : k == 1 ? way.y / d.y : way.z / d.z;
    hit.side = 0;
    return hit;
}

/* Into a list ascending in t. A full list cancels a hit against one from the other side; over sums
   the sides of those that wait for such a one. */
NAGATA3_API int n3i_insert_hit(n3_hit *list, int count, n3_hit hit, int *over)
{
    int i = 0;
    if (count == N3_HITS || *over * hit.side < 0) {
        while (i < count && list[i].side == hit.side) i++;
        if (i == count || *over * hit.side < 0) {
            *over += hit.side;
            return count;
        }
        for (; i + 1 < count; i++) list[i] = list[i + 1];
        return count - 1;
    }
    for (i = count; i > 0 && list[i - 1].t > hit.t; i--) list[i] = list[i - 1];
    list[i] = hit;
    return count + 1;
}

/* All control points on one side of an axis, as n3i_crossings tells sides. */
NAGATA3_API int n3i_is_missed(const n3i_cell *c)
{
    int i, right = 0, up = 0;
    for (i = 0; i < 10; i++) {
        right += c->x[0][i] >= 0;
        up += c->x[1][i] >= 0;
    }
    return right == 0 || right == 10 || up == 0 || up == 10;
}

/* All control points strictly on one side of a line through the origin, across the way to the sum
   of the corners, or along the longer of two sides: then there is no hit. */
NAGATA3_API int n3i_is_beside(const n3i_cell *c)
{
    const n3_real *x = c->x[0], *y = c->x[1];
    n3_real bx = x[1] - x[0], by = y[1] - y[0], cx = x[2] - x[0], cy = y[2] - y[0];
    n3_real gx = x[0] + x[1] + x[2], gy = y[0] + y[1] + y[2];
    int i, turn;
    for (turn = 0; turn < 2; turn++) {
        int above = 0, below = 0;
        for (i = 0; i < 10; i++) {
            n3_real level = gx * x[i] + gy * y[i];
            above += level > 0;
            below += level < 0;
        }
        if (above == 10 || below == 10) return 1;
        gx = bx * bx + by * by > cx * cx + cy * cy ? -by : -cy;
        gy = bx * bx + by * by > cx * cx + cy * cy ? bx : cx;
    }
    return 0;
}

NAGATA3_API int n3_patch_hits(const n3_patch *p, n3_vec from, n3_vec along, n3_real t0, n3_real t1,
                              n3_hit hit[N3_HITS])
{
    n3i_stack stack;
    int k = n3i_main_axis(along), found = 0, over = 0, looked = 0, back;
    n3_real size;
    if (k < 0) return 0;
    size = n3i_look_along(p, from, along, k, &stack.cell[0]);
    if (!(size > 0) || n3i_is_missed(&stack.cell[0])) return 0;
    back = (k == 0 ? along.x : k == 1 ? along.y : along.z) < 0;
    stack.count = 1;
    while (stack.count > 0) {
        n3i_cell c = stack.cell[--stack.count];
        n3_real w[3];
        n3_hit h;
        int winding, simple, may_cut = c.cuts < N3I_CUTS;
        if (n3i_is_missed(&c)) continue;
        winding = n3i_winding(&c);
        if (winding == 0 && (n3i_is_beside(&c) || !may_cut || looked++ > N3I_CELLS)) continue;
        simple = n3i_is_simple(&c, 1 / size);
        if (winding == 0 && simple) continue;
        if (may_cut && !(simple && winding * winding == 1 && n3i_zero(&c, 1 / size, w))) {
            n3i_cell_cut(&stack, &c, 2);
            continue;
        }
        if (!may_cut) n3i_zero(&c, 1 / size, w);
        h = n3i_hit_at(p, from, along, k, &c, w);
        h.side = (winding > 0) == back ? 1 : -1;
        if (!(h.t >= t0 && h.t <= t1)) continue;
        for (; winding != 0; winding += winding > 0 ? -1 : 1)
            found = n3i_insert_hit(hit, found, h, &over);
    }
    return found;
}

NAGATA3_API int n3_patch_hit(const n3_patch *p, n3_vec from, n3_vec along, n3_real t0, n3_real t1,
                             n3_hit *hit)
{
    n3_hit all[N3_HITS];
    int found = n3_patch_hits(p, from, along, t0, t1, all);
    if (found > 0) *hit = all[0];
    return found > 0;
}

/* The coefficients at the corners of a cell are values. */
NAGATA3_API int n3_patch_folds(const n3_patch *p, n3_vec direction, int budget)
{
    n3i_stack stack;
    int i, j, k = n3i_main_axis(direction), back;
    n3_real size, det[25];
    if (k < 0) return N3_YES;
    size = n3i_look_along(p, p->p[0], direction, k, &stack.cell[0]);
    if (!(size > 0)) return N3_YES;
    back = (k == 0 ? direction.x : k == 1 ? direction.y : direction.z) < 0;
    stack.count = 1;
    while (stack.count > 0) {
        n3i_cell c = stack.cell[--stack.count];
        int above = 0;
        n3i_jacobian(&c, 1 / size, det);
        for (i = 0; i < 5; i++)
            for (j = 0; i + j < 5; j++)
                above += back ? det[5 * i + j] < 0 : det[5 * i + j] > 0;
        if (above == 15) continue;
        for (i = 0; i < 5; i += 4)
            for (j = 0; i + j < 5; j += 4)
                if (back ? !(det[5 * i + j] < 0) : !(det[5 * i + j] > 0)) return N3_YES;
        if (c.cuts == N3I_CUTS || --budget <= 0) return N3_UNDECIDED;
        n3i_cell_cut(&stack, &c, 2);
    }
    return N3_NO;
}

/* ---- Definitions: queries, sums over a patch ---- */

/* Gauss's six nodes and weights on [0, 1]: exact for polynomials of degree 11. With u = s and
   v = (1 - s) t the triangle is a square, and du dv is (1 - s) ds dt: a polynomial of degree n in
   u and v is one of degree n + 1 in s and n in t. So 6 x 6 nodes are exact up to n = 10. */
NAGATA3_API n3_real n3i_node(int i)
{
    static const n3_real node[3] = {(n3_real)0.23861918608319690863,
                                    (n3_real)0.66120938646626451366,
                                    (n3_real)0.93246951420315202781};
    return (1 + (i < 3 ? -node[2 - i] : node[i - 3])) / 2;
}

NAGATA3_API n3_real n3i_node_weight(int i)
{
    static const n3_real weight[3] = {(n3_real)0.46791393457269104739,
                                      (n3_real)0.36076157304813860757,
                                      (n3_real)0.17132449237917034504};
    return weight[i < 3 ? 2 - i : i - 3] / 2;
}

/* The point, and du x dv times the weight of the node i of the 36. */
NAGATA3_API n3_vec n3i_area_at(const n3i_cell *c, int i, n3_vec *x)
{
    n3_real w[3], s = n3i_node(i / 6), t = n3i_node(i % 6), j[3][6];
    n3_real weight = n3i_node_weight(i / 6) * n3i_node_weight(i % 6) * (1 - s);
    int k;
    w[0] = (1 - s) * (1 - t);
    w[1] = s;
    w[2] = (1 - s) * t;
    for (k = 0; k < 3; k++) n3i_row_jet(c->x[k], w, j[k]);
    *x = n3_v(j[0][0], j[1][0], j[2][0]);
    return n3_mul(weight, n3_cross(n3_v(j[0][1], j[1][1], j[2][1]),
                                   n3_v(j[0][2], j[1][2], j[2][2])));
}

/* With y = x - from the cone's points are r y, 0 <= r <= 1, and its element of volume is
   r^2 <y, du x dv> dr du dv: the volume is the integral of <y, du x dv> / 3, of degree 3 + 4, and
   the moment that of y <y, du x dv> / 4, of degree 3 + 7. */
NAGATA3_API n3_real n3_patch_volume(const n3_patch *p, n3_vec from, n3_vec *moment)
{
    n3i_cell c;
    n3_vec sum = n3_v(0, 0, 0);
    n3_real volume = 0;
    int i;
    for (i = 0; i < 10; i++) n3i_cell_set(&c, i, n3_sub(p->p[i], from));
    for (i = 0; i < 36; i++) {
        n3_vec x, n = n3i_area_at(&c, i, &x);
        volume += n3_dot(x, n) / 3;
        sum = n3_add(sum, n3_mul(n3_dot(x, n) / 4, x));
    }
    if (moment) *moment = sum;
    return volume;
}

/* The area of a cell, and its moment, by the 36 nodes. */
typedef struct n3i_sum { n3_real area; n3_vec moment; } n3i_sum;

NAGATA3_API n3i_sum n3i_area_of(const n3i_cell *c)
{
    n3i_sum sum;
    int i;
    sum.area = 0;
    sum.moment = n3_v(0, 0, 0);
    for (i = 0; i < 36; i++) {
        n3_vec x, n = n3i_area_at(c, i, &x);
        n3_real part = n3_len(n);
        sum.area += part;
        sum.moment = n3_add(sum.moment, n3_mul(part, x));
    }
    return sum;
}

/* Whether what a sum over a whole is off that over its halves is settled, as a part of all: 64
   times as well as is asked for. */
NAGATA3_API int n3i_is_settled(n3_real off, n3_real halves, n3_real all, n3_real tolerance)
{
    tolerance = n3i_larger(tolerance, 16 * N3_EPS);
    return !(64 * off > tolerance * halves && 512 * off > tolerance * all);
}

NAGATA3_API n3i_sum n3i_sum_add(n3i_sum a, n3i_sum b)
{
    a.area += b.area;
    a.moment = n3_add(a.moment, b.moment);
    return a;
}

/* Areas can agree by chance; hardly with their moments, whose arms are 1 at most. */
NAGATA3_API n3i_sum n3i_area_to(n3i_stack *stack, n3_real tolerance)
{
    n3i_sum sum[N3I_CUTS + 2], total, all = n3i_area_of(&stack->cell[0]);
    int looked = 0;
    sum[0] = all;
    memset(&total, 0, sizeof total);
    while (stack->count > 0) {
        n3i_cell c = stack->cell[--stack->count];
        int k = stack->count;
        n3i_sum whole = sum[k], halves;
        n3_real off;
        n3i_cell_cut(stack, &c, 3);
        sum[k] = n3i_area_of(&stack->cell[k]);
        sum[k + 1] = n3i_area_of(&stack->cell[k + 1]);
        halves = n3i_sum_add(sum[k], sum[k + 1]);
        off = n3i_larger(n3i_abs(halves.area - whole.area),
                         n3i_largest(n3_sub(halves.moment, whole.moment)));
        if (looked++ < 4 * N3I_CELLS && c.cuts + 1 < N3I_CUTS &&
            !n3i_is_settled(off, halves.area, all.area, tolerance))
            continue;
        total = n3i_sum_add(total, halves);
        stack->count = k;
    }
    return total;
}

NAGATA3_API n3_real n3_patch_area(const n3_patch *p, n3_real tolerance, n3_vec *centroid)
{
    n3i_stack stack;
    n3i_sum total;
    n3_vec net[10];
    n3_real size = n3i_relative(p->p, 10, p->p[0], net);
    int i;
    n3i_cell_start(&stack.cell[0]);
    for (i = 0; i < 10; i++) n3i_cell_set(&stack.cell[0], i, net[i]);
    stack.count = 1;
    total = n3i_area_to(&stack, tolerance);
    if (centroid) {
        n3_vec mean = n3i_over(n3_add(net[1], net[2]), 3);
        if (total.area > 0) mean = n3i_over(total.moment, total.area);
        *centroid = n3_add(p->p[0], n3_mul(size, mean));
    }
    return size * total.area * size;
}

NAGATA3_API n3_real n3i_length_of(const n3_edge *e)
{
    n3_real sum = 0;
    int i;
    for (i = 0; i < 6; i++) sum += n3i_node_weight(i) * n3_len(n3_edge_jet(e, n3i_node(i)).dt);
    return sum;
}

NAGATA3_API n3_real n3_edge_length(const n3_edge *e, n3_real tolerance)
{
    n3_edge stack[N3I_CUTS + 1];
    n3_real length[N3I_CUTS + 1], all = n3i_length_of(e), sum = 0;
    int count = 1, looked = 0;
    stack[0] = *e;
    length[0] = all;
    while (count > 0) {
        n3_edge c = stack[--count];
        n3_real whole = length[count], halves;
        n3_edge_split(&c, (n3_real)1 / 2, &stack[count]);
        length[count] = n3i_length_of(&stack[count]);
        length[count + 1] = n3i_length_of(&stack[count + 1]);
        halves = length[count] + length[count + 1];
        if (looked++ < N3I_CELLS && count + 2 < N3I_CUTS &&
            !n3i_is_settled(n3i_abs(whole - halves), halves, all, tolerance))
            count += 2;
        else
            sum += halves;
    }
    return sum;
}

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT. Copyright 2026 the nagata3 authors; the text is in LICENSE. */
