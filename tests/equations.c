/* equations.c: one test per numbered equation that nagata3.h cites, named after it.
 *
 * A test calls the one function that realises the equation, and evaluates what the paper prints in
 * the plainest way: Cramer's rule for (2.1.7), angles and rotations for the cubic edge, whole
 * control nets for (6.1.10). Tolerances are in units of EPS, the header's precision; DBL_EPSILON
 * enters only where the plain way itself cancels. `make ledger` compares the numbers. */
#include "check.h"
#include "naive.h"

#include <float.h>

enum { SAMPLES = 2000 };

/* ---- The segment ---- */

/* Points in the cube [-1, 1]^3, normals that make a sine from 1/1024 to 1 with each other. */
static void segment_ends(rng *r, n3_vertex *a, n3_vertex *b)
{
    double sine = pow(2, rng_uniform(r, -10, 0)), cosine;
    dvec n = wide(rng_unit(r)), across = d_unit(d_cross(n, wide(rng_unit(r))));
    cosine = rng_next(r) & 1 ? sqrt(1 - sine * sine) : -sqrt(1 - sine * sine);
    *a = vertex(wide(rng_vec(r)), n);
    *b = vertex(wide(rng_vec(r)), d_mix(cosine, n, sine, across));
}

static dvec chord(n3_vertex a, n3_vertex b) { return d_sub(wide(b.x), wide(a.x)); }

/* c = l0 n0 + l1 n1 (2.1.7), where <n0, c> = <n0, d> (2.1.5) and <n1, c> = -<n1, d> (2.1.6). */
static dvec curvature(n3_vertex a, n3_vertex b)
{
    dvec n0 = wide(a.n), n1 = wide(b.n), d = chord(a, b);
    double g00 = d_dot(n0, n0), g01 = d_dot(n0, n1), g11 = d_dot(n1, n1);
    double r0 = d_dot(n0, d), r1 = -d_dot(n1, d), determinant = g00 * g11 - g01 * g01;
    return d_mix((r0 * g11 - r1 * g01) / determinant, n0, (r1 * g00 - r0 * g01) / determinant, n1);
}

/* The header's c = w x X / |X|^2, s = |X| the normals' sine, |w| = s |c|. X is good to 4 eps |X|,
 * as its factors make a right angle nearly; a product <n, d> to 2 eps |d|, so w to 6 eps |d|; with
 * the last product and quotient c to 16 eps |c| + 6 eps |d| / s. Cramer's determinant is s^2, good
 * to 4 DBL_EPSILON, and its numerators are to 4 DBL_EPSILON |d|: 4 DBL_EPSILON (|c| + |d|)/s^2. */
static double curvature_tolerance(n3_vertex a, n3_vertex b)
{
    double s = d_len(d_cross(wide(a.n), wide(b.n))), d = d_len(chord(a, b));
    double c = d_len(curvature(a, b));
    return EPS * (16 * c + 6 * d / s) + 4 * DBL_EPSILON * (c + d) / (s * s);
}

/* The end points may lie anywhere: c depends on d = x1 - x0 only. Sixteenths add exactly. One
 * compiled copy serves both, as two may be contracted differently. */
static void eq_2_1_2(void)
{
    n3_vec (*volatile c)(n3_vertex, n3_vertex) = n3_segment_curvature;
    rng r = {212};
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        n3_vertex a, b, origin, end;
        n3_real k = (n3_real)(rng_next(&r) % 64) / 16;
        segment_ends(&r, &a, &b);
        origin = vertex(d_v(0, 0, 0), wide(a.n));
        end = vertex(d_v(1, (double)k, -2), wide(b.n));
        a.x = n3_v(k, 3, k / 2);
        b.x = n3_v(k + 1, k + 3, k / 2 - 2);
        CHECK_SAME(c(a, b), c(origin, end), i);
    }
}

/* Of the error of w in curvature_tolerance the part along the other normal drops out here, and what
 * it has from <n, d> enters at full size but without 1/s. Its rounding, eps (|<n0,d>| + |<n1,d>|),
 * is divided by s: at most 2 eps (|c| + |d|), as <n0,d> and <n1,d> differ by 2 s |d| at most when
 * the normals' angle is acute and, if not, their opposites do. In all 18 eps (|c| + |d|). */
static void orthogonal(uint64_t seed, int at_end)
{
    rng r = {0};
    long i, count = sample_count(SAMPLES);
    r.state = seed;
    for (i = 0; i < count; i++) {
        n3_vertex a, b;
        dvec d, c;
        segment_ends(&r, &a, &b);
        d = chord(a, b);
        c = wide(n3_segment_curvature(a, b));
        CHECK_NEAR(at_end ? d_dot(wide(b.n), d_add(d, c)) : d_dot(wide(a.n), d_sub(d, c)), 0,
                   18 * EPS * (d_len(c) + d_len(d)), i);
    }
}

static void eq_2_1_5(void) { orthogonal(215, 0); }
static void eq_2_1_6(void) { orthogonal(216, 1); }

/* Also Nagata's own rule: for parallel normals, which leave c open, c = 0. */
static void eq_2_1_7(void)
{
    rng r = {217};
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        n3_vertex a, b;
        segment_ends(&r, &a, &b);
        CHECK_VEC(n3_segment_curvature(a, b), narrow(curvature(a, b)), curvature_tolerance(a, b),
                  i);
        b.n = a.n;
        CHECK_SAME(n3_segment_curvature(a, b), n3_v(0, 0, 0), i);
    }
}

/* (x0 + x1)/2 - c/2; the sum and the difference of coordinates up to 1 cost 2 eps. */
static dvec middle(n3_vertex a, n3_vertex b)
{
    return d_sub(d_mix(0.5, wide(a.x), 0.5, wide(b.x)), d_mul(0.5, curvature(a, b)));
}

static double middle_tolerance(n3_vertex a, n3_vertex b)
{
    return 2 * EPS + EPS * d_len(curvature(a, b)) + curvature_tolerance(a, b) / 2;
}

static void segment_point(uint64_t seed, int point)
{
    rng r = {0};
    long i, count = sample_count(SAMPLES);
    r.state = seed;
    for (i = 0; i < count; i++) {
        n3_vertex a, b;
        n3_segment s;
        segment_ends(&r, &a, &b);
        s = n3_segment_make(a, b);
        if (point == 0) CHECK_SAME(s.p[0], a.x, i);
        if (point == 1) CHECK_VEC(s.p[1], narrow(middle(a, b)), middle_tolerance(a, b), i);
        if (point == 2) CHECK_SAME(s.p[2], b.x, i);
    }
}

static void eq_3_1_5(void) { segment_point(315, 0); }
static void eq_3_1_6(void) { segment_point(316, 1); }
static void eq_3_1_7(void) { segment_point(317, 2); }

/* ---- The quadratic patch ---- */

/* Weights (u, v): corners, middles of sides, sides, inside, outside; then random ones inside. */
static void weights(rng *r, long i, n3_real *u, n3_real *v)
{
    static const double row[][2] = {{0, 0},      {1, 0},      {0, 1},      {0.5, 0},  {0.5, 0.5},
                                    {0, 0.5},    {0.25, 0},   {0.25, .75}, {0, 0.75}, {0.25, 0.25},
                                    {0.5, 0.25}, {0.25, 0.5}, {1.25, -.5}, {-.25, 0}};
    double x = rng_uniform(r, 0, 1), y = rng_uniform(r, 0, 1);
    int fold = x + y > 1, given = i < (long)(sizeof row / sizeof *row);
    *u = (n3_real)(given ? row[i][0] : fold ? 1 - x : x);
    *v = (n3_real)(given ? row[i][1] : fold ? 1 - y : y);
}

/* sum of weight[k] p[k] */
static dvec combine(const n3_vec *p, const double *weight, int count)
{
    dvec sum = d_v(0, 0, 0);
    int k;
    for (k = 0; k < count; k++) sum = d_add(sum, d_mul(weight[k], wide(p[k])));
    return sum;
}

/* Coordinates up to 1: w = 1 - u - v is off by eps and moves the point by twice that, six weights
 * of three products that sum to 1 (5 outside) by 2 eps, the sum of six by 3 eps: 7, outside 29. */
static void eq_3_2_5(void)
{
    rng r = {325};
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        n3_patch2 q;
        n3_real u, v;
        double x, y, w, weight[6];
        int k;
        weights(&r, i, &u, &v);
        for (k = 0; k < 6; k++) q.p[k] = rng_vec(&r);
        x = (double)u, y = (double)v, w = 1 - x - y;
        weight[0] = w * w, weight[1] = x * x, weight[2] = y * y;
        weight[3] = 2 * x * w, weight[4] = 2 * x * y, weight[5] = 2 * y * w;
        CHECK_VEC(n3_patch2_point(&q, u, v), narrow(combine(q.p, weight, 6)),
                  (w < 0 || u < 0 || v < 0 ? 29 : 7) * EPS, i);
    }
}

/* Point k of the patch over the triangle is corner i if i == j, else the middle point between the
 * corners i and j, from V1, V2, V3 of the paper. */
static void quadratic_point(uint64_t seed, int k, int i, int j)
{
    rng r = {0};
    long n, count = sample_count(SAMPLES / 4);
    r.state = seed;
    for (n = 0; n < count; n++) {
        n3_vertex v[3];
        n3_patch2 q;
        segment_ends(&r, &v[i], &v[i == j ? (i + 1) % 3 : j]);
        v[i == j ? (i + 2) % 3 : 3 - i - j] = vertex(wide(rng_vec(&r)), wide(rng_unit(&r)));
        q = n3_patch2_make(v[0], v[1], v[2]);
        if (i == j)
            CHECK_SAME(q.p[k], v[i].x, n);
        else
            CHECK_VEC(q.p[k], narrow(middle(v[i], v[j])), middle_tolerance(v[i], v[j]), n);
    }
}

static void eq_3_2_6(void) { quadratic_point(326, 0, 0, 0); }
static void eq_3_2_7(void) { quadratic_point(327, 3, 0, 1); }
static void eq_3_2_8(void) { quadratic_point(328, 1, 1, 1); }
static void eq_3_2_9(void) { quadratic_point(329, 5, 0, 2); }
static void eq_3_2_10(void) { quadratic_point(3210, 4, 1, 2); }
static void eq_3_2_11(void) { quadratic_point(3211, 2, 2, 2); }

/* ---- The cubic curve ---- */

static n3_edge random_edge(rng *r)
{
    n3_edge e;
    int k;
    for (k = 0; k < 4; k++) e.p[k] = rng_vec(r);
    return e;
}

/* Coordinates up to 1: 1 - t is off by eps/2 and moves the point by 3 times that, weights of four
 * products by 2 eps, the sum of four by 2 eps: 6. */
static void eq_5_1_1(void)
{
    rng r = {511};
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        n3_edge e = random_edge(&r);
        n3_real t = (n3_real)(i <= 8 ? (double)i / 8 : rng_uniform(&r, 0, 1));
        CHECK_VEC(n3_edge_point(&e, t), narrow(d_bezier(&e, (double)t)), 6 * EPS, i);
    }
}

/* Two roundings of a sum up to 3, divided by 3, and one more: 2 eps. */
static void raised_point(uint64_t seed, int k)
{
    static const double third[4][3] = {{3, 0, 0}, {1, 2, 0}, {0, 2, 1}, {0, 0, 3}};
    rng r = {0};
    long i, count = sample_count(SAMPLES);
    r.state = seed;
    for (i = 0; i < count; i++) {
        n3_segment s;
        n3_edge e;
        s.p[0] = rng_vec(&r), s.p[1] = rng_vec(&r), s.p[2] = rng_vec(&r);
        e = n3_segment_raise(&s);
        CHECK_VEC(e.p[k], narrow(d_mul(1. / 3, combine(s.p, third[k], 3))), 2 * EPS, i);
    }
}

static void eq_5_1_3(void) { raised_point(513, 0); }
static void eq_5_1_4(void) { raised_point(514, 1); }
static void eq_5_1_5(void) { raised_point(515, 2); }
static void eq_5_1_6(void) { raised_point(516, 3); }

/* ---- The cubic edge ---- */

/* Across the chord e, in the plane Pi: halfway between the normals' directions around the chord,
 * one of them turned about if they are more than a right angle apart. */
static dvec across(dvec e, dvec n0, dvec n1)
{
    dvec f = d_unit(d_cross(e, fabs(e.x) < 0.5 ? d_v(1, 0, 0) : d_v(0, 1, 0))), g = d_cross(e, f);
    double start = atan2(d_dot(n0, g), d_dot(n0, f)), end = atan2(d_dot(n1, g), d_dot(n1, f));
    double angle = start + remainder(end - start, PI) / 2;
    return d_mix(cos(angle), f, sin(angle), g);
}

/* An end of an edge: the unit tangent in Pi, along the chord; theta; tan theta cut off. */
typedef struct end {
    dvec t;
    double theta, tangent;
} end;

static end end_make(dvec n, dvec e, dvec h, double lo, double hi)
{
    end r;
    r.t = d_unit(d_mix(d_dot(n, h), e, -d_dot(n, e), h));
    if (d_dot(r.t, e) < 0) r.t = d_mul(-1, r.t);
    r.theta = atan2(fabs(d_dot(r.t, h)), d_dot(r.t, e));
    r.tangent = tan(r.theta);
    if (r.tangent <= lo) r.tangent = lo; /* (5.1.11) */
    if (r.tangent >= hi) r.tangent = hi; /* (5.1.12) */
    return r;
}

/* (5.1.13), and with the ends exchanged (5.1.14) */
static double handle(end here, end other, double L)
{
    double share = other.tangent / (here.tangent + other.tangent);
    return here.theta <= 60 * DEGREE ? share / cos(here.theta) * (2 * L / 3) : share * (4 * L / 3);
}

/* The header's error, in eps, q = min |e x n|: e 2; unit(e x n) 4/q, so Pi and b are turned around
 * the chord by 6/q; the normal's direction around the chord is within 45 degrees of b, so <n,b> is
 * good to (6 + 2)/q of itself; <n,e> to 2. Within the cut-offs tan theta is then good to
 * 8/q + 3/lo of itself, the share of the handle to a quarter of two of those, cos theta up to 60
 * degrees to 3/4 of 8/q + 3, the tangent's direction to 9/q + 4. Handles are at most 4L/3 long:
 * 4L/3 ((4 + 6 + 9)/q + 1.5/lo + 10) in all, below L (40/q + 2/lo), and 1 for the sum. */
static double edge_tolerance(double L, double q, double lo)
{
    return EPS * (1 + L * (40 / q + 2 / lo));
}

static void check_edge(n3_vertex a, n3_vertex b, const n3_options *o, int k, long row)
{
    double lo = o ? (double)o->tan_lo : 0.1, hi = o ? (double)o->tan_hi : 10, q;
    dvec d = chord(a, b), e = d_unit(d), h = across(e, wide(a.n), wide(b.n));
    end start = end_make(wide(a.n), e, h, lo, hi), stop = end_make(wide(b.n), e, h, lo, hi);
    n3_edge got = n3_edge_make(a, b, o);
    dvec p21 = d_mix(1, wide(a.x), handle(start, stop, d_len(d)), start.t);
    dvec p12 = d_mix(1, wide(b.x), -handle(stop, start, d_len(d)), stop.t);
    q = fmin(d_len(d_cross(e, wide(a.n))), d_len(d_cross(e, wide(b.n))));
    CHECK_VEC(got.p[k], narrow(k == 1 ? p21 : p12), edge_tolerance(d_len(d), q, lo), row);
}

/* Random ends, no normal within 7 degrees of the chord and the normals' directions around the chord
 * not within 1 degree of perpendicular: that is where the edge jumps. */
static void edge_ends(rng *r, n3_vertex *a, n3_vertex *b)
{
    for (;;) {
        dvec e, m0, m1;
        *a = vertex(wide(rng_vec(r)), wide(rng_unit(r)));
        *b = vertex(wide(rng_vec(r)), wide(rng_unit(r)));
        if (d_len(chord(*a, *b)) < 0.25) continue;
        e = d_unit(chord(*a, *b));
        m0 = d_cross(e, wide(a->n)), m1 = d_cross(e, wide(b->n));
        if (d_len(m0) < 0.125 || d_len(m1) < 0.125) continue;
        if (fabs(d_dot(d_unit(m0), d_unit(m1))) > 0.02) return;
    }
}

/* Planar ends with angles in degrees against (5.1.13) and (5.1.14), whose cut-offs matter there:
 * below and above lo, and hi; each at the start, at the end, at both; C and S. */
typedef struct cut {
    double start, end, lo, hi;
} cut;

static void cut_off(const cut *row, int rows)
{
    int i;
    for (i = 0; i < rows; i++) {
        n3_options o = {N3_RULE_PAPER, 0, 0};
        n3_vertex a, b;
        o.tan_lo = (n3_real)row[i].lo;
        o.tan_hi = (n3_real)row[i].hi;
        planar_ends(row[i].start, row[i].end, &a, &b);
        check_edge(a, b, &o, 1, i);
        check_edge(a, b, &o, 2, i);
    }
}

static void eq_5_1_11(void)
{
    static const cut row[] = {{3, -30, .1, 10},  {-30, 3, .1, 10}, {5.6, 20, .1, 10},
                              {5.8, 20, .1, 10}, {3, -1, .1, 10},  {0, 40, .1, 10},
                              {20, -50, .5, 4},  {-50, 20, .5, 4}, {1e-3, 5, 1e-3, 10}};
    cut_off(row, (int)(sizeof row / sizeof *row));
}

static void eq_5_1_12(void)
{
    static const cut row[] = {{82, -30, .1, 5}, {-30, 82, .1, 5}, {82, -80, .1, 5},
                              {78, -30, .1, 5}, {79, 30, .1, 5},  {50, -20, .1, 1},
                              {44, -20, .1, 1}, {-20, 50, .1, 1}, {70, 20, 2, 2}};
    cut_off(row, (int)(sizeof row / sizeof *row));
}

static void random_edges(uint64_t seed, int k)
{
    rng r = {0};
    long i, count = sample_count(SAMPLES);
    r.state = seed;
    for (i = 0; i < count; i++) {
        n3_vertex a, b;
        edge_ends(&r, &a, &b);
        check_edge(a, b, NULL, k, i);
    }
}

static void eq_5_1_13(void) { random_edges(5113, 1); }
static void eq_5_1_14(void) { random_edges(5114, 2); }

/* The tangents never run against the chord, also where their intersection p11 in Pi makes the
 * parabola do so, which is (4.2.1). A tangent of cosine 0 may round to -eps. */
static void eq_4_2_1(void)
{
    rng r = {421};
    long i, against = 0, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        n3_vertex a, b;
        n3_edge got;
        dvec d, e, h, start, stop, p11;
        edge_ends(&r, &a, &b);
        d = chord(a, b), e = d_unit(d), h = across(e, wide(a.n), wide(b.n));
        start = end_make(wide(a.n), e, h, 0.1, 10).t;
        stop = end_make(wide(b.n), e, h, 0.1, 10).t;
        p11 = d_mul(d_len(d) * d_dot(stop, h) /
                        (d_dot(stop, h) * d_dot(start, e) - d_dot(start, h) * d_dot(stop, e)),
                    start);
        against += d_dot(p11, d) < 0 || d_dot(d_sub(d, p11), d) < 0;
        got = n3_edge_make(a, b, NULL);
        CHECK(d_dot(d_sub(wide(got.p[1]), wide(a.x)), d) > -4 * EPS, i);
        CHECK(d_dot(d_sub(wide(b.x), wide(got.p[2])), d) > -4 * EPS, i);
    }
    CHECK(8 * against > count || count < 100, against);
}

/* The corrected control point: where the start tangent meets the end tangent, mirrored in the chord
 * if the two do not meet above the chord. Coordinates along the chord of planar_ends and across.
 * Angles from 6 to 59 degrees, so neither cut off nor past the branch. */
static void corrected_point(uint64_t seed, int k)
{
    rng r = {0};
    long i, count = sample_count(SAMPLES);
    r.state = seed;
    for (i = 0; i < count; i++) {
        double s = rng_uniform(&r, 6, 59), e = rng_uniform(&r, 6, 59), x, y;
        double up = i & 1 ? 1 : -1, ts = up * tan(s * DEGREE), te = tan(e * DEGREE);
        dvec p11, p;
        n3_vertex a, b;
        planar_ends(up * s, e, &a, &b);
        if (k == 1 && ts * te > 0) te = -te; /* p11^(0): the end tangent is mirrored */
        if (k == 2 && ts * te > 0) ts = -ts; /* p11^(1): the start tangent */
        x = 2 * te / (te - ts), y = ts * x;  /* y = ts x and y = te (x - 2) */
        p11 = in_frame(x - 1, y, 0);
        p = d_mul(1. / 3, d_add(d_mul(2, p11), wide(k == 1 ? a.x : b.x)));
        CHECK_VEC(n3_edge_make(a, b, NULL).p[k], narrow(p), edge_tolerance(2, 0.5, 0.1), i);
    }
}

static void eq_5_1_4a(void) { corrected_point(514, 1); }
static void eq_5_1_5a(void) { corrected_point(515, 2); }

/* ---- The cubic patch ---- */

/* Coordinates up to 1: w = 1 - u - v is off by eps and moves the point by 3 times that, weights of
 * five products that sum to 1 (23 outside) by 3 eps, the sum of ten by 5 eps: 11, outside 180. */
static void eq_5_2_1(void)
{
    rng r = {521};
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        n3_patch p;
        n3_real u, v;
        double x, y, w, weight[10];
        int k;
        weights(&r, i, &u, &v);
        for (k = 0; k < 10; k++) p.p[k] = rng_vec(&r);
        x = (double)u, y = (double)v, w = 1 - x - y;
        weight[0] = w * w * w, weight[1] = x * x * x, weight[2] = y * y * y;
        weight[3] = 3 * x * w * w, weight[4] = 3 * x * x * w;
        weight[5] = 3 * x * x * y, weight[6] = 3 * x * y * y;
        weight[7] = 3 * y * y * w, weight[8] = 3 * y * w * w, weight[9] = 6 * x * y * w;
        CHECK_VEC(n3_patch_point(&p, u, v), narrow(combine(p.p, weight, 10)),
                  (w < 0 || u < 0 || v < 0 ? 180 : 11) * EPS, i);
    }
}

/* Three curves that meet at the corners: the paper's first and second edge, and its third, which
 * runs from x00 to x11 like the first two together. */
static void three_edges(rng *r, n3_edge e[3])
{
    int i;
    for (i = 0; i < 3; i++) e[i] = random_edge(r);
    e[1].p[0] = e[0].p[3];
    e[2].p[0] = e[0].p[0];
    e[2].p[3] = e[1].p[3];
}

/* The header's third edge runs from c to a. */
static n3_edge turned(const n3_edge *e)
{
    n3_edge r;
    int k;
    for (k = 0; k < 4; k++) r.p[k] = e->p[3 - k];
    return r;
}

static n3_patch patch_of(const n3_edge e[3])
{
    n3_edge ca = turned(&e[2]);
    return n3_patch_from_edges(&e[0], &e[1], &ca, n3_v(0, 0, 0));
}

/* Corner k of the net is an end of two edges. */
static void patch_corner(uint64_t seed, int k)
{
    static const int meets[3][4] = {{0, 0, 2, 0}, {0, 3, 1, 0}, {1, 3, 2, 3}};
    rng r = {0};
    long i;
    r.state = seed;
    for (i = 0; i < 100; i++) {
        n3_edge e[3];
        n3_patch p;
        three_edges(&r, e);
        p = patch_of(e);
        CHECK_SAME(p.p[k], e[meets[k][0]].p[meets[k][1]], i);
        CHECK_SAME(p.p[k], e[meets[k][2]].p[meets[k][3]], i);
    }
}

static void eq_5_2_2(void) { patch_corner(522, 0); }
static void eq_5_2_3(void) { patch_corner(523, 1); }
static void eq_5_2_4(void) { patch_corner(524, 2); }

/* The printed curve of edge k is made of these four points of the net: the edge itself. */
static void patch_edge(uint64_t seed, int k)
{
    static const int net[3][4] = {{0, 3, 4, 1}, {1, 5, 6, 2}, {0, 8, 7, 2}};
    rng r = {0};
    long i;
    int j;
    r.state = seed;
    for (i = 0; i < 100; i++) {
        n3_edge e[3];
        n3_patch p;
        three_edges(&r, e);
        p = patch_of(e);
        for (j = 0; j < 4; j++) CHECK_SAME(p.p[net[k][j]], e[k].p[j], i);
    }
}

static void eq_5_2_5(void) { patch_edge(525, 0); }
static void eq_5_2_6(void) { patch_edge(526, 1); }
static void eq_5_2_7(void) { patch_edge(527, 2); }

/* ---- The triangular Coons surface ---- */

/* The sides of the net, end, two points, end, and for each the mean of which points is the centre
 * of the ruled surface that has it straight: S2 (6.1.5), S1 (6.1.4), S3 (6.1.6). */
static const int side[3][4] = {{0, 3, 4, 1}, {1, 5, 6, 2}, {2, 7, 8, 0}};
static const int ruled[3][2] = {{8, 5}, {4, 7}, {3, 6}};

static void straighten(dvec net[10], const int s[4])
{
    net[s[1]] = d_mix(2. / 3, net[s[0]], 1. / 3, net[s[3]]);
    net[s[2]] = d_mix(1. / 3, net[s[0]], 2. / 3, net[s[3]]);
}

/* (S1 + S2 + S3 - S4)/2 (6.1.9), S4 the flat triangle raised to degree three (6.1.8). */
static void coons(const n3_patch *p, dvec net[10])
{
    dvec s[4][10];
    int i, k;
    for (i = 0; i < 4; i++)
        for (k = 0; k < 10; k++) s[i][k] = wide(p->p[k]);
    for (i = 0; i < 3; i++) {
        straighten(s[i], side[i]);
        straighten(s[3], side[i]);
        s[i][9] = d_mix(0.5, s[i][ruled[i][0]], 0.5, s[i][ruled[i][1]]);
    }
    s[3][9] = d_mul(1. / 3, d_add(s[3][0], d_add(s[3][1], s[3][2])));
    for (k = 0; k < 10; k++)
        net[k] = d_mul(0.5, d_sub(d_add(s[0][k], d_add(s[1][k], s[2][k])), s[3][k]));
}

/* The printed formula on its own, then all ten control points of a patch the long way. Coordinates
 * up to 1 (the patch's up to 5 by its handles): sums of six and of three points over 4 and 6, the
 * largest 6/4 and 3/6, and their difference cost 6 eps of these. The boundary of coons is that of
 * the patch up to 8 DBL_EPSILON. */
static void eq_6_1_10(void)
{
    static const double weight[10] = {-1. / 6, -1. / 6, -1. / 6, .25, .25, .25, .25, .25, .25, 0};
    rng r = {6110};
    long i, count = sample_count(SAMPLES);
    int k;
    for (i = 0; i < count; i++) {
        n3_edge e[3], ca;
        n3_patch p;
        dvec net[10];
        three_edges(&r, e);
        p = patch_of(e);
        ca = turned(&e[2]);
        p.p[9] = n3_patch_centre(&e[0], &e[1], &ca);
        CHECK_VEC(p.p[9], narrow(combine(p.p, weight, 10)), 6 * EPS, i);
        coons(&p, net);
        for (k = 0; k < 10; k++) CHECK_VEC(p.p[k], narrow(net[k]), 8 * EPS, i);
    }
}

#define TEST(name) {#name, name}

const test_case tests_equations[] = {
    TEST(eq_2_1_2),  TEST(eq_2_1_5), TEST(eq_2_1_6),  TEST(eq_2_1_7),  TEST(eq_3_1_5),
    TEST(eq_3_1_6),  TEST(eq_3_1_7), TEST(eq_3_2_5),  TEST(eq_3_2_6),  TEST(eq_3_2_7),
    TEST(eq_3_2_8),  TEST(eq_3_2_9), TEST(eq_3_2_10), TEST(eq_3_2_11), TEST(eq_4_2_1),
    TEST(eq_5_1_1),  TEST(eq_5_1_3), TEST(eq_5_1_4),  TEST(eq_5_1_4a), TEST(eq_5_1_5),
    TEST(eq_5_1_5a), TEST(eq_5_1_6), TEST(eq_5_1_11), TEST(eq_5_1_12), TEST(eq_5_1_13),
    TEST(eq_5_1_14), TEST(eq_5_2_1), TEST(eq_5_2_2),  TEST(eq_5_2_3),  TEST(eq_5_2_4),
    TEST(eq_5_2_5),  TEST(eq_5_2_6), TEST(eq_5_2_7),  TEST(eq_6_1_10), {NULL, NULL},
};
