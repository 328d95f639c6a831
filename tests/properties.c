/* properties.c: what holds for every triangle, on random ones of every awkward kind (samples.h).
 *
 * Tolerances. u = EPS / 2 bounds the relative error of one operation. M is the largest coordinate
 * of the points and control points involved, L the length of a chord. */
#include "check.h"
#include "naive.h"
#include "samples.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const n3_options rules[] = {
    {N3_RULE_PAPER, 0, 0}, {N3_RULE_ARC, 0, 0}, {N3_RULE_PAPER, (n3_real)1 / 64, 64}};

enum { PAPER, ARC, RULES = sizeof rules / sizeof *rules };

/* What a test may skip beyond the share that it states, for short runs. */
enum { FEW = 20 };

/* Through pointers, so that one compiled copy answers: two may round differently where the compiler
 * contracts products and sums. */
static n3_segment (*volatile const segment_make)(n3_vertex, n3_vertex) = n3_segment_make;
static n3_vec (*volatile const segment_curvature)(n3_vertex, n3_vertex) = n3_segment_curvature;
static n3_vec (*volatile const curve_plane)(n3_vertex, n3_vertex) = n3_curve_plane;

static void check_same_net(const n3_vec *got, const n3_vec *want, int count, long row)
{
    int k;
    for (k = 0; k < count; k++)
        if (!CHECK_SAME(got[k], want[k], row)) break;
}

/* A net of small integers, where equal control points are common. */
static void tied_net(rng *r, n3_vec *p, int count)
{
    int k;
    for (k = 0; k < count; k++) {
        int bits = (int)(rng_next(r) >> 61);
        p[k] = n3_v((n3_real)(bits & 1), (n3_real)(bits >> 1 & 1), (n3_real)(bits >> 2));
    }
}

/* Control points in the unit cube, every other time a thousand sizes from the origin. */
static void random_net(rng *r, n3_vec *p, int count)
{
    n3_vec away = n3_mul(rng_next(r) >> 63 ? 1000 : 0, rng_vec(r));
    int k;
    for (k = 0; k < count; k++) p[k] = n3_add(rng_vec(r), away);
}

/* ---- Sharing ---- */

static void segments_are_the_same_from_either_end(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_segment ab = segment_make(s.v[0], s.v[1]), ba = segment_make(s.v[1], s.v[0]);
        n3_vec back[3];
        int k;
        for (k = 0; k < 3; k++) back[k] = ba.p[2 - k];
        CHECK_SAME(segment_curvature(s.v[0], s.v[1]), segment_curvature(s.v[1], s.v[0]), i);
        check_same_net(back, ab.p, 3, i);
    }
}

static void curve_planes_are_the_same_from_either_end(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_vec m = curve_plane(s.v[0], s.v[1]), back = curve_plane(s.v[1], s.v[0]);
        CHECK(same_vec(m, back) || same_vec(m, n3_mul(-1, back)), i);
    }
}

static void edges_are_the_same_from_either_end(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        int k;
        for (k = 0; k < RULES; k++) {
            n3_edge ab = n3_edge_make(s.v[0], s.v[1], &rules[k]);
            n3_edge ba = n3_edge_make(s.v[1], s.v[0], &rules[k]), back = n3_edge_reverse(&ba);
            check_same_net(back.p, ab.p, 4, i);
        }
    }
}

static void check_point_reverses(const n3_edge *e, rng *r, long row)
{
    n3_edge back = n3_edge_reverse(e);
    n3_real t = dyadic(r, -1, 2), s = (n3_real)rng_uniform(r, 0.5, 1); /* 1 - s is exact */
    CHECK_SAME(n3_edge_point(&back, 1 - t), n3_edge_point(e, t), row);
    CHECK_SAME(n3_edge_point(&back, 1 - s), n3_edge_point(e, s), row);
    CHECK_SAME(n3_edge_point(e, 0), e->p[0], row);
    CHECK_SAME(n3_edge_point(e, 1), e->p[3], row);
}

static void edge_points_are_the_same_from_either_end(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_edge e = n3_edge_make(s.v[0], s.v[1], &rules[i / KINDS % RULES]);
        check_point_reverses(&e, &s.r, i);
        tied_net(&s.r, e.p, 4);
        check_point_reverses(&e, &s.r, i);
    }
}

static n3_vec point_at(const n3_patch *p, const n3_real weight[3])
{
    return n3_patch_point(p, weight[1], weight[2]);
}

static void check_sides(const n3_patch *p, rng *r, long row)
{
    n3_edge e[3];
    n3_real t = dyadic(r, 0, 1);
    int k;
    n3_patch_edges(p, e);
    for (k = 0; k < 3; k++) {
        n3_real weight[3] = {0, 0, 0}, corner[3] = {0, 0, 0};
        corner[k] = 1, weight[k] = 1 - t, weight[(k + 1) % 3] = t;
        CHECK_SAME(point_at(p, corner), p->p[k], row);
        CHECK_SAME(point_at(p, weight), n3_edge_point(&e[k], t), row);
    }
}

static void sides_are_edges(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        const n3_options *o = &rules[i / KINDS % RULES];
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], o), q;
        n3_edge e[3];
        int k;
        n3_patch_edges(&p, e);
        for (k = 0; k < 3; k++) {
            n3_edge want = n3_edge_make(s.v[k], s.v[(k + 1) % 3], o);
            check_same_net(e[k].p, want.p, 4, i);
        }
        q = n3_patch_from_edges(&e[0], &e[1], &e[2], p.p[9]);
        check_same_net(q.p, p.p, 10, i);
        check_sides(&p, &s.r, i);
        tied_net(&s.r, p.p, 10);
        check_sides(&p, &s.r, i);
    }
}

/* The neighbour abd takes its three corners in any of their six orders. */
static void neighbours_share_points(void)
{
    static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                     {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i), other = sample_make(i + 1);
        const int *order = orders[i % 6];
        const n3_options *o = &rules[i / KINDS % RULES];
        n3_vertex d[3] = {s.v[0], s.v[1], other.v[2]};
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], o);
        n3_patch q = n3_patch_make(d[order[0]], d[order[1]], d[order[2]], o);
        n3_real t = dyadic(&s.r, 0, 1), weight[3] = {1 - t, t, 0}, there[3];
        int k;
        for (k = 0; k < 3; k++) there[k] = weight[order[k]];
        CHECK_SAME(point_at(&q, there), point_at(&p, weight), i);
    }
}

static double length(n3_vec a) { return d_len(wide(a)); }

/* The parts of (<n0, d> n1 + <n1, d> n0) x X / |X|^2 have the errors 4 u L, 4 u L, 3 u L and
 * 3 u L |X| in the product and 6 u in X: |dc| <= 26 u L / |X|, and p11 adds its own rounding.
 * Negative where normals count as parallel, or nearly do. */
static double segment_tolerance(n3_vertex a, n3_vertex b, const n3_segment *s)
{
    double X = d_len(d_cross(wide(a.n), d_sub(wide(b.n), wide(a.n))));
    if (X < 2 * (double)N3_PARALLEL) return -1;
    return 13 * EPS * length(n3_sub(b.x, a.x)) / X + 4 * EPS * reach(s->p, 3);
}

/* Their middle control points, to rounding only: a contracting compiler may make two copies. */
static void quadratic_patches_have_the_segments(void)
{
    long i, count = sample_count(20000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_patch2 q = n3_patch2_make(s.v[0], s.v[1], s.v[2]);
        int k;
        for (k = 0; k < 3; k++) {
            n3_vertex a = s.v[k], b = s.v[(k + 1) % 3];
            n3_segment e = n3_segment_make(a, b);
            double tolerance = segment_tolerance(a, b, &e);
            CHECK_SAME(q.p[k], a.x, i);
            if (tolerance >= 0) CHECK_VEC(q.p[3 + k], e.p[1], tolerance, i);
        }
    }
}

/* ---- Order of the corners ---- */

/* How often a, b and c stand in each control point of n3_patch. */
static const int exponents[10][3] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 1, 0}, {1, 2, 0},
                                     {0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {1, 1, 1}};

/* The control point that stands at k when corner order[j] comes j-th. */
static int permuted(const int order[3], int k)
{
    int i, j;
    for (i = 0; i < 10; i++) {
        for (j = 0; j < 3; j++)
            if (exponents[i][order[j]] != exponents[k][j]) break;
        if (j == 3) break;
    }
    return i;
}

/* What the header promises of the centre, 4 ulp and by the arc rule 8. Pairs of control points are
 * the same sums in every order; the sums of these differ, by at most 7 EPS M if every rounding
 * were at its worst. What the arc rule adds is per edge the same bits again, and small where the
 * normals cancel, so that their sum, which is then made of rounding, does no harm. */
static double centre_tolerance(const n3_patch *p, int rule)
{
    return (rule == ARC ? 8 : 4) * EPS * reach(p->p, 10);
}

/* Points: w = 1 - u - v is exact, and a sum of Bernstein terms has the error 5 EPS M whatever its
 * order; the centre enters with the weight 6 u v w <= 2/9. */
static void corners_may_come_in_any_order(void)
{
    static const int orders[5][3] = {{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        const int *order = orders[i / KINDS % 5];
        int rule = (int)(i / KINDS / 5 % RULES), k;
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], &rules[rule]);
        n3_patch q = n3_patch_make(s.v[order[0]], s.v[order[1]], s.v[order[2]], &rules[rule]);
        double tolerance = centre_tolerance(&p, rule);
        n3_real weight[3], there[3];
        dyadic_weights(&s.r, &weight[1], &weight[2]);
        weight[0] = 1 - weight[1] - weight[2];
        for (k = 0; k < 9; k++) CHECK_SAME(q.p[k], p.p[permuted(order, k)], i);
        CHECK_VEC(q.p[9], p.p[9], tolerance, i);
        for (k = 0; k < 3; k++) there[k] = weight[order[k]];
        CHECK_VEC(point_at(&q, there), point_at(&p, weight), tolerance + 10 * EPS * reach(p.p, 10),
                  i);
    }
}

/* ---- Tangency ---- */

/* The sine between the chord and the normal, 0 without a chord. */
static double sine_to_chord(n3_vertex a, n3_vertex b, n3_vec n)
{
    dvec d = d_sub(wide(b.x), wide(a.x));
    double L = d_len(d);
    return L > 0 ? d_len(d_cross(d, wide(n))) / L : 0;
}

/* Both normals along the chord, or next to it. */
static int is_straight(n3_vertex a, n3_vertex b)
{
    return sine_to_chord(a, b, a.n) < 2 * (double)N3_ALONG &&
           sine_to_chord(a, b, b.n) < 2 * (double)N3_ALONG;
}

/* What the header promises: 8 ulp, but for a normal that counts as along the chord, whose tangent
 * is square to the chord and so off by the sine between the two. */
static double tangency_tolerance(n3_vertex a, n3_vertex b, const n3_edge *e)
{
    double sine = fmin(sine_to_chord(a, b, a.n), sine_to_chord(a, b, b.n));
    double tolerance = 8 * EPS * reach(e->p, 4);
    if (sine < 2 * (double)N3_ALONG)
        tolerance += 4. / 3 * length(n3_sub(b.x, a.x)) * (double)N3_ALONG;
    return tolerance;
}

static void edges_are_tangent_to_the_end_planes(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_vertex a = s.v[0], b = s.v[1];
        int k;
        if (is_straight(a, b)) continue;
        for (k = 0; k < RULES; k++) {
            n3_edge e = n3_edge_make(a, b, &rules[k]);
            double tolerance = tangency_tolerance(a, b, &e);
            CHECK_NEAR(d_dot(wide(n3_sub(e.p[1], e.p[0])), wide(a.n)), 0, tolerance, i);
            CHECK_NEAR(d_dot(wide(n3_sub(e.p[3], e.p[2])), wide(b.n)), 0, tolerance, i);
        }
    }
}

static void segments_are_tangent_to_the_end_planes(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_segment e = n3_segment_make(s.v[0], s.v[1]);
        double tolerance = segment_tolerance(s.v[0], s.v[1], &e);
        if (tolerance < 0) continue; /* parallel: the chord */
        CHECK_NEAR(d_dot(wide(n3_sub(e.p[1], e.p[0])), wide(s.v[0].n)), 0, tolerance, i);
        CHECK_NEAR(d_dot(wide(n3_sub(e.p[2], e.p[1])), wide(s.v[1].n)), 0, tolerance, i);
    }
}

/* A corner's normal is made of two handles h with the error dh, the tolerance of the tangency and
 * 10 EPS of the size of the net from the derivatives; it leans by sum dh / |h| over the sine
 * between them at most. Tolerances above 1/8 say nothing and are skipped. */
static double corner_tolerance(const sample *s, const n3_patch *p, int k)
{
    n3_edge e[3];
    const n3_vertex *v = s->v;
    int next = (k + 1) % 3, last = (k + 2) % 3;
    dvec out, in;
    double h, g, sine, sum;
    n3_patch_edges(p, e);
    out = wide(n3_sub(e[k].p[1], e[k].p[0])), in = wide(n3_sub(e[last].p[2], e[last].p[3]));
    h = d_len(out), g = d_len(in);
    if (!(h > 0 && g > 0)) return 1;
    sine = d_len(d_cross(out, in)) / h / g;
    sum = tangency_tolerance(v[k], v[next], &e[k]) / h +
          tangency_tolerance(v[last], v[k], &e[last]) / g +
          10 * EPS * 4 * reach(p->p, 10) * (1 / h + 1 / g);
    return sum < sine / 8 ? sum / sine : 1;
}

/* Skipped are the kinds with normals along chords and coincident points; no others but a few. */
static void corners_have_the_vertex_normals(void)
{
    long i, count = sample_count(100000), skipped = 0;
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        int rule = (int)(i / KINDS % RULES), k;
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], &rules[rule]);
        for (k = 0; k < 3; k++) {
            double tolerance = corner_tolerance(&s, &p, k);
            n3_vec n = n3_patch_normal(&p, k == 1, k == 2);
            if (n3_dot(n, s.v[k].n) < 0) n = n3_mul(-1, n);
            if (tolerance > 0.125 || is_straight(s.v[k], s.v[(k + 1) % 3]) ||
                is_straight(s.v[k], s.v[(k + 2) % 3]))
                skipped++;
            else
                CHECK_VEC(n, s.v[k].n, tolerance, i);
        }
    }
    CHECK(skipped <= 3 * count / 5 + FEW, skipped);
}

/* ---- Finite and bounded ---- */

static void check_finite(const n3_vec *p, int count, long row)
{
    int k;
    for (k = 0; k < count; k++)
        if (!CHECK(is_finite_vec(p[k]), row)) break;
}

static void answers_are_finite(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_patch2 q = n3_patch2_make(s.v[0], s.v[1], s.v[2]);
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], &rules[i / KINDS % RULES]);
        n3_real u, v;
        n3_jet j;
        n3_vec n;
        dyadic_weights(&s.r, &u, &v);
        j = n3_patch_jet(&p, u, v);
        n = n3_patch_normal(&p, u, v);
        check_finite(q.p, 6, i);
        check_finite(p.p, 10, i);
        check_finite(&j.x, 1, i), check_finite(&j.du, 1, i), check_finite(&j.dv, 1, i);
        check_finite(&j.duu, 1, i), check_finite(&j.duv, 1, i), check_finite(&j.dvv, 1, i);
        CHECK(same_vec(n, n3_v(0, 0, 0)) || fabs(length(n) - 1) <= 3 * EPS, i);
    }
}

/* (5.1.13): ratio 2 L / (3 cos) with cos >= 1/2, or ratio 4 L / 3, and ratio is at most
 * tan_hi / (tan_lo + tan_hi). The arc rule: of d the part along m goes, the part across both
 * normals stays, and the bending one is turned and lengthened by 2 / (1 + cos). To this come the
 * roundings of the handle, and M's of the control point; of m, EPS / cos. */
static double longest_handle(n3_vertex a, n3_vertex b, int rule, double L)
{
    double sum = length(n3_add(a.n, b.n));
    if (rule == ARC && sum > (double)N3_OPPOSITE)
        return 2 * L / 3 / (1 + sum / 2) * (1 + 16 * EPS + 8 * EPS / sum);
    return 4 * L / 3 * (rule == RULES - 1 ? 4096. / 4097 : 100. / 101) * (1 + 16 * EPS);
}

static void handles_are_bounded(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_vertex a = s.v[0], b = s.v[1];
        double L = length(n3_sub(b.x, a.x));
        int k;
        for (k = 0; k < RULES; k++) {
            n3_edge e = n3_edge_make(a, b, &rules[k]);
            double limit = longest_handle(a, b, k, L) + 2 * EPS * reach(e.p, 4);
            CHECK(length(n3_sub(e.p[1], e.p[0])) <= limit, i);
            CHECK(length(n3_sub(e.p[3], e.p[2])) <= limit, i);
        }
    }
}

/* ---- Conditioning ----
 *
 * How far the inner control points can move, in units of L, when the unit chord and the normals
 * move by delta; -1 within twice that of a discontinuity, or where this first-order analysis ends.
 *
 * Paper: m_i = unit(e x n_i) by 2 delta / |e x n_i|; m by spread, half their sum and more, as
 * |m0 + s m1| >= sqrt 2; b by spread + delta. The tangent is (<n,b> e - <n,e> b) / h, and Pi being
 * a bisector, h >= 1/sqrt 2: it turns by turn = 3/2 (spread + 4 delta). The logarithm of a tangent
 * clamped to [0.1, 10] moves by 10.1 turn, ratio by 2 (10.1 / 4) turn, 1/cos <= 2 by 2 sqrt 3 turn:
 * the handle's length by L (6.8 + 2.4) turn, its direction by 4/3 L (turn + spread + 2 delta). */
static double paper_slack(n3_vertex a, n3_vertex b, double delta)
{
    dvec d = d_sub(wide(b.x), wide(a.x)), e, m0, m1, m, across;
    double L = d_len(d), s0 = sine_to_chord(a, b, a.n), s1 = sine_to_chord(a, b, b.n);
    double spread, turn, side;
    if (!(L > 0) || fmin(s0, s1) < 4 * (double)N3_ALONG) return -1;
    e = d_mul(1 / L, d);
    m0 = d_mul(1 / s0, d_cross(e, wide(a.n))), m1 = d_mul(1 / s1, d_cross(e, wide(b.n)));
    spread = 2 * delta * (1 / s0 + 1 / s1), turn = 1.5 * (spread + 4 * delta);
    side = d_dot(m0, m1);
    m = d_unit(side < 0 ? d_sub(m0, m1) : d_add(m0, m1));
    across = d_cross(m, e);
    if (turn > 1. / 16 || fabs(side) < 2 * spread || fabs(d_dot(wide(a.n), across)) < 2 * turn ||
        fabs(d_dot(wide(b.n), across)) < 2 * turn)
        return -1;
    return 12 * turn + 2 * spread + 5 * delta;
}

/* Arc: m = unit(n0 + n1) by 2 delta / |n0 + n1|, <d, m> m by twice that, g by 4 delta, k by delta,
 * so the handle (q + g k m) / 3 by (4 |dm| + 13 delta) / 3. */
static double arc_slack(n3_vertex a, n3_vertex b, double delta)
{
    double sum = length(n3_add(a.n, b.n));
    if (sum < 4 * (double)N3_OPPOSITE || is_straight(a, b)) return -1;
    return 3 * delta / sum + 5 * delta;
}

static double slack(n3_vertex a, n3_vertex b, double delta, int rule)
{
    return rule == ARC ? arc_slack(a, b, delta) : paper_slack(a, b, delta);
}

typedef struct motion { dvec x, y, z, origin; } motion;

static motion random_motion(rng *r, double size)
{
    motion f;
    f.x = d_unit(wide(rng_unit(r)));
    f.y = d_unit(d_cross(f.x, wide(rng_unit(r))));
    f.z = d_cross(f.x, f.y);
    f.origin = d_mul(size, wide(rng_vec(r)));
    return f;
}

static n3_vec turned(const motion *f, n3_vec a)
{
    dvec v = wide(a);
    return narrow(d_add(d_mix(v.x, f->x, v.y, f->y), d_mul(v.z, f->z)));
}

static n3_vec moved(const motion *f, n3_vec a)
{
    dvec v = wide(a);
    return narrow(d_add(d_add(d_mix(v.x, f->x, v.y, f->y), d_mul(v.z, f->z)), f->origin));
}

static n3_vertex moved_vertex(const motion *f, n3_vertex v)
{
    v.x = moved(f, v.x);
    v.n = turned(f, v.n);
    return v;
}

/* Moving a point costs 4 u M for rotating and adding and u M for narrowing, 5 EPS M as a vector;
 * so the chord of two is off by 10 EPS M / L. Normals and the two computations: 16 EPS. Skipped
 * are normals along chords, coincident points, the ties of ON_AXES; in float also what is far. */
static void check_moved_edge(const motion *f, const n3_vertex v[2], int rule, long row,
                             long *skipped)
{
    n3_edge e = n3_edge_make(v[0], v[1], &rules[rule]);
    n3_edge g = n3_edge_make(moved_vertex(f, v[0]), moved_vertex(f, v[1]), &rules[rule]);
    double M, L = length(n3_sub(v[1].x, v[0].x)), share;
    int k;
    M = fmax(reach(e.p, 4), reach(g.p, 4));
    share = L > 0 ? slack(v[0], v[1], 10 * EPS * M / L + 16 * EPS, rule) : -1;
    if (share < 0) {
        (*skipped)++;
        return;
    }
    for (k = 0; k < 4; k++) CHECK_VEC(g.p[k], moved(f, e.p[k]), share * L + 12 * EPS * M, row);
}

static void edges_move_with_rigid_motions(void)
{
    long i, count = sample_count(100000), skipped = 0;
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        motion f = random_motion(&s.r, length(n3_sub(s.v[1].x, s.v[0].x)));
        check_moved_edge(&f, s.v, PAPER, i, &skipped);
        check_moved_edge(&f, s.v, ARC, i, &skipped);
    }
    CHECK(skipped <= count / 2 + FEW, skipped); /* a quarter of two rules */
}

/* The arc rule's centre C + h N when the handles move by H, and the normals and chords, of L <= D,
 * by delta: in (6.1.10) six quarters of H; in the cubic part three terms of D / 2 by 3 delta each:
 * dC = 3/2 H + 5 D delta; N by dN = 3 delta / |sum n|; n_e by turn = (2 delta / |mid| + 8 H / |T|)
 * over the sine between mid and the middle tangent T; r_e = <n_e, q_e - C> by D turn + 3 H + dC and
 * c_e by turn + dN; with |h| <= 4 D and sum c_e^2 >= 3/4, h by 4 (D (2 turn + dN) + 3 H + dC) +
 * 32 D (turn + dN). Skipped are normals along chords, coincident points and some of the nearly
 * opposite normals and slivers, in float also what is far: less than half. */
static double centre_slack(const sample *s, const n3_patch *p, double H, double delta)
{
    const n3_vertex *v = s->v;
    double D = 0, turn = 0, dN, sum = length(n3_add(n3_add(v[0].n, v[1].n), v[2].n));
    n3_edge e[3];
    int k;
    n3_patch_edges(p, e);
    for (k = 0; k < 3; k++) {
        dvec T = d_add(wide(n3_sub(e[k].p[3], e[k].p[0])), wide(n3_sub(e[k].p[2], e[k].p[1])));
        dvec mid = d_add(wide(v[k].n), wide(v[(k + 1) % 3].n));
        double across = d_len(d_cross(mid, T));
        if (!(across > 0) || is_straight(v[k], v[(k + 1) % 3])) return -1;
        D = fmax(D, 2 * d_len(d_sub(wide(e[k].p[3]), wide(e[k].p[0]))));
        turn = fmax(turn, (2 * delta * d_len(T) + 8 * H * d_len(mid)) / across);
    }
    dN = 3 * delta / fmax(sum, delta);
    if (turn > 1. / 16 || dN > 1. / 16) return -1;
    return 16 * H + 5 * (1.5 * H + 5 * D * delta) + D * (40 * turn + 40 * dN);
}

static void arc_centres_move_with_rigid_motions(void)
{
    long i, count = sample_count(100000), skipped = 0;
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        motion f = random_motion(&s.r, length(n3_sub(s.v[1].x, s.v[0].x)));
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], &rules[ARC]), q;
        n3_vertex w[3];
        double M, H = 0, worst = 0, tolerance;
        int k, sound = 1;
        for (k = 0; k < 3; k++) w[k] = moved_vertex(&f, s.v[k]);
        q = n3_patch_make(w[0], w[1], w[2], &rules[ARC]);
        M = fmax(reach(p.p, 10), reach(q.p, 10));
        for (k = 0; k < 3; k++) {
            n3_vertex a = s.v[k], b = s.v[(k + 1) % 3];
            double L = length(n3_sub(b.x, a.x));
            double delta = (L > 0 ? 10 * EPS * M / L : 1) + 16 * EPS;
            double share = slack(a, b, delta, ARC);
            sound = sound && share >= 0;
            H = fmax(H, share * L + 12 * EPS * M);
            worst = fmax(worst, delta);
        }
        tolerance = sound ? centre_slack(&s, &p, H, worst) : -1;
        if (tolerance < 0)
            skipped++;
        else
            CHECK_VEC(q.p[9], moved(&f, p.p[9]), tolerance + 16 * EPS * M, i);
    }
    CHECK(skipped <= count / 2 + FEW, skipped);
}

/* The wanted normals of the arc's centre are the sums of the end normals where none are given. */
static void wanted_normals_may_have_any_length(void)
{
    static n3_vec (*volatile const centre)(const n3_edge *, const n3_edge *, const n3_edge *,
                                           const n3_vec *, const n3_vec *) = n3_patch_centre_arc;
    long i, count = sample_count(20000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], &rules[ARC]);
        n3_edge e[3];
        n3_vec n[3], mid[3], want;
        int k;
        n3_patch_edges(&p, e);
        for (k = 0; k < 3; k++) {
            n[k] = s.v[k].n;
            mid[k] = scale_vec(n3_add(s.v[k].n, s.v[(k + 1) % 3].n), 3 * k - 4);
        }
        want = centre(&e[0], &e[1], &e[2], n, NULL);
        CHECK_SAME(centre(&e[0], &e[1], &e[2], n, mid), want, i);
    }
}

/* Through parallel normals the edge is continuous: turned by delta it moves by its slack. */
static void edges_are_bounded_next_to_parallel_normals(void)
{
    long i, count = sample_count(100000), skipped = 0;
    for (i = 0; i < count; i++) {
        sample s = sample_make(i * KINDS + NEARLY_PARALLEL);
        n3_vertex a = s.v[0], b = s.v[1], parallel = b;
        double L = length(n3_sub(b.x, a.x)), delta = length(n3_sub(b.n, a.n));
        int rule = (int)(i % 2), k;
        n3_edge e = n3_edge_make(a, b, &rules[rule]), f;
        double share = slack(a, b, delta + 16 * EPS, rule);
        parallel.n = a.n;
        f = n3_edge_make(a, parallel, &rules[rule]);
        if (share < 0) skipped++;
        for (k = 0; k < 4 && share >= 0; k++)
            CHECK_VEC(e.p[k], f.p[k], share * L + 2 * EPS * reach(e.p, 4), i);
    }
    CHECK(skipped <= count / 4 + FEW, skipped);
}

/* The paper's rule does not ask to which side a normal looks. */
static void paper_edges_do_not_need_oriented_normals(void)
{
    long i, count = sample_count(100000), skipped = 0;
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_vertex a = s.v[0], b = s.v[1], flipped = b;
        n3_edge e = n3_edge_make(a, b, NULL), f;
        flipped.n = n3_mul(-1, b.n);
        f = n3_edge_make(a, flipped, NULL);
        if (paper_slack(a, b, 16 * EPS) < 0)
            skipped++;
        else
            check_same_net(f.p, e.p, 4, i);
    }
    CHECK(skipped <= count / 4 + FEW, skipped);
}

/* ---- Scale ---- */

static void powers_of_two_change_no_bit(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        const n3_options *o = &rules[i / KINDS % RULES];
        int exponent = (int)(rng_next(&s.r) % 41) - 20, k;
        n3_vertex scaled[3];
        answers want, got;
        n3_real u, v;
        dyadic_weights(&s.r, &u, &v);
        for (k = 0; k < 3; k++) scaled[k] = scale_vertex(s.v[k], exponent);
        want = ask(s.v, o, u, v);
        got = ask(scaled, o, u, v);
        check_alike(&got, &want, exponent, i);
    }
}

/* ---- The parabola, promise 5 ---- */

/* Ends whose tangents in Pi climb from the chord by the angles at 0 and fall by the one at 1. */
static void parabola_ends(rng *r, n3_vertex v[2])
{
    dvec e = d_unit(wide(rng_unit(r))), b = d_unit(d_cross(e, wide(rng_unit(r))));
    dvec m = d_cross(e, b), x = wide(rng_vec(r));
    double lo = atan(0.1) + 1e-6, hi = PI / 3 - 1e-6, lean = 0;
    double start = rng_uniform(r, lo, hi), end = rng_uniform(r, lo, hi);
    if (rng_next(r) >> 63) end = start, lean = rng_uniform(r, -PI / 5, PI / 5);
    v[0] = vertex(
        x, d_unit(d_add(d_mix(-sin(start), e, cos(start), b), d_mul(cos(start) * tan(lean), m))));
    v[1] = vertex(d_add(x, e),
                  d_unit(d_add(d_mix(sin(end), e, cos(end), b), d_mul(-cos(end) * tan(lean), m))));
}

/* The plane of the segment is Pi to the rounding of the normals, 4 EPS, over the sine X of the
 * angle between them; c has the error 26 u L / X + (4 EPS) 2 L / X, and (5.1.4) takes a third.
 * X >= sin(2 atan 0.1) > 0.19. The paper's edge: slack, with 6 EPS for e and narrowed normals. */
static void sound_parabolas_are_kept(void)
{
    long i, count = sample_count(100000);
    rng r = {1};
    for (i = 0; i < count; i++) {
        n3_vertex v[2];
        n3_segment s;
        n3_edge e, want;
        double L, M, tolerance;
        int k;
        parabola_ends(&r, v);
        s = n3_segment_make(v[0], v[1]), want = n3_segment_raise(&s);
        e = n3_edge_make(v[0], v[1], NULL);
        L = length(n3_sub(v[1].x, v[0].x)), M = reach(e.p, 4);
        tolerance = L * (paper_slack(v[0], v[1], 6 * EPS) + 21 * EPS / 3 / 0.19) + 4 * EPS * M;
        for (k = 0; k < 4; k++) CHECK_VEC(e.p[k], want.p[k], tolerance, i);
    }
}

/* ---- The evaluator ----
 *
 * A sum of the ten Bernstein terms (four, for an edge): 4 roundings in a weight and the product, 4
 * additions, so 9 u S^3 M < 5 EPS S^3 M, where S = |u| + |v| + |w| is 1 in the triangle. */

static n3_patch random_patch(rng *r)
{
    n3_patch p;
    random_net(r, p.p, 10);
    return p;
}

static double support(const n3_vec *p, int count, dvec side)
{
    double largest = d_dot(side, wide(p[0]));
    int k;
    for (k = 1; k < count; k++) largest = fmax(largest, d_dot(side, wide(p[k])));
    return largest;
}

/* Seen from any side no point lies beyond the control points; 5 EPS M a component, 5 sqrt 3 EPS M
 * in all, and as much again for the two products here. */
static void points_lie_in_the_convex_hull(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], &rules[i / KINDS % RULES]);
        dvec side = wide(rng_unit(&s.r));
        double tolerance = 18 * EPS * reach(p.p, 10);
        n3_edge e[3];
        n3_real u, v;
        dyadic_weights(&s.r, &u, &v);
        n3_patch_edges(&p, e);
        CHECK(d_dot(side, wide(n3_patch_point(&p, u, v))) <= support(p.p, 10, side) + tolerance, i);
        CHECK(d_dot(side, wide(n3_edge_point(&e[0], u))) <= support(e[0].p, 4, side) + tolerance,
              i);
    }
}

/* The net of a plane, p_ijk = (k a + i b + j c) / 3, gives w a + u b + v c back; the net is off by
 * 3 u M, S < 5 for u and v in [-1, 2]. */
static void planes_are_reproduced(void)
{
    long i, count = sample_count(20000);
    rng r = {2};
    for (i = 0; i < count; i++) {
        n3_vec corner[3], got;
        n3_patch p;
        n3_real u = dyadic(&r, -1, 2), v = dyadic(&r, -1, 2);
        double ud = (double)u, vd = (double)v, wd = 1 - ud - vd;
        double S = fabs(ud) + fabs(vd) + fabs(wd), M;
        dvec want;
        int k;
        random_net(&r, corner, 3);
        for (k = 0; k < 10; k++) {
            const int *n = exponents[k];
            dvec ab = d_mix(n[0] / 3., wide(corner[0]), n[1] / 3., wide(corner[1]));
            p.p[k] = narrow(d_add(ab, d_mul(n[2] / 3., wide(corner[2]))));
        }
        M = reach(p.p, 10);
        got = n3_patch_point(&p, u, v);
        want = d_add(d_mix(wd, wide(corner[0]), ud, wide(corner[1])), d_mul(vd, wide(corner[2])));
        CHECK_VEC(got, narrow(want), (5 + 2) * EPS * S * S * S * M, i);
    }
}

/* x -> A x + b of the net and of the point; rounding the new net costs u M', and M covers both. */
static void affine_maps_commute_with_the_evaluator(void)
{
    long i, count = sample_count(20000);
    rng r = {3};
    for (i = 0; i < count; i++) {
        n3_patch p = random_patch(&r), q;
        motion f;
        n3_real u, v;
        int k;
        f.x = wide(rng_vec(&r)), f.y = wide(rng_vec(&r)), f.z = wide(rng_vec(&r));
        f.origin = wide(rng_vec(&r));
        dyadic_weights(&r, &u, &v);
        for (k = 0; k < 10; k++) q.p[k] = moved(&f, p.p[k]);
        CHECK_VEC(n3_patch_point(&q, u, v), moved(&f, n3_patch_point(&p, u, v)),
                  (5 + 1) * EPS * reach(q.p, 10) + 3 * 5 * EPS * reach(p.p, 10) +
                      8 * DBL_EPSILON * reach(p.p, 10),
                  i);
    }
}

/* Differences that are exact for cubics, in one direction (a, b) of the domain. */
static dvec first_difference(const n3_patch *p, n3_real u, n3_real v, n3_real a, n3_real b)
{
    dvec here = d_sub(wide(n3_patch_point(p, u + a, v + b)), wide(n3_patch_point(p, u - a, v - b)));
    dvec twice = d_sub(wide(n3_patch_point(p, u + 2 * a, v + 2 * b)),
                       wide(n3_patch_point(p, u - 2 * a, v - 2 * b)));
    return d_mix(8. / 12, here, -1. / 12, twice);
}

static dvec second_difference(const n3_patch *p, n3_real u, n3_real v, n3_real a, n3_real b)
{
    dvec ends = d_add(wide(n3_patch_point(p, u + a, v + b)), wide(n3_patch_point(p, u - a, v - b)));
    return d_sub(ends, d_mul(2, wide(n3_patch_point(p, u, v))));
}

/* Steps of 1/4 for the first, 1/2 for the second derivatives; all weights are exact.
 * Points: S <= 2, 8 * 5 EPS M each, 18/12 of them over 1/4: 240 EPS M. Seconds: S <= 2, 4 of them
 * over 1/4: 640 EPS M; mixed: the two diagonals, S <= 3 and S <= 2, 135 EPS M and 40 EPS M, twice
 * each and four points between, over 4 * 1/4: below 640 as well.
 * The jet: 5 u 2 M in r_ijk, 10 u 2 M in the three points, so 3 * 2 * 10 EPS M = 60 EPS M in the
 * first and 6 * 4 * 5 EPS M = 120 EPS M in the second derivatives. */
static void patch_jets_are_differences(void)
{
    const n3_real h = (n3_real)1 / 4, g = (n3_real)1 / 2;
    long i, count = sample_count(20000);
    rng r = {4};
    for (i = 0; i < count; i++) {
        n3_patch p = random_patch(&r);
        double first = 300 * EPS * reach(p.p, 10), second = 760 * EPS * reach(p.p, 10);
        n3_real u, v;
        n3_jet j;
        dvec mixed;
        dyadic_weights(&r, &u, &v);
        j = n3_patch_jet(&p, u, v);
        mixed = d_sub(second_difference(&p, u, v, g, g), second_difference(&p, u, v, g, -g));
        CHECK_SAME(j.x, n3_patch_point(&p, u, v), i);
        CHECK_VEC(j.du, narrow(d_mul(4, first_difference(&p, u, v, h, 0))), first, i);
        CHECK_VEC(j.dv, narrow(d_mul(4, first_difference(&p, u, v, 0, h))), first, i);
        CHECK_VEC(j.duu, narrow(d_mul(4, second_difference(&p, u, v, g, 0))), second, i);
        CHECK_VEC(j.dvv, narrow(d_mul(4, second_difference(&p, u, v, 0, g))), second, i);
        CHECK_VEC(j.duv, narrow(d_mul(1, mixed)), second, i);
    }
}

/* The same in one parameter; t in [0, 1] with steps of 1/4 and 1/2 has S <= 2. */
static void edge_jets_are_differences(void)
{
    const n3_real h = (n3_real)1 / 4;
    long i, count = sample_count(20000);
    rng r = {5};
    for (i = 0; i < count; i++) {
        n3_edge e;
        n3_real t = dyadic(&r, 0, 1);
        n3_curve_jet j;
        dvec x[5], slope, bend;
        double M;
        int k;
        random_net(&r, e.p, 4);
        M = reach(e.p, 4);
        for (k = 0; k < 5; k++) x[k] = wide(n3_edge_point(&e, t + h * (n3_real)(k - 2)));
        slope = d_mix(8. / 3, d_sub(x[3], x[1]), -1. / 3, d_sub(x[4], x[0]));
        bend = d_mul(4, d_sub(d_add(x[0], x[4]), d_mul(2, x[2])));
        j = n3_edge_jet(&e, t);
        CHECK_SAME(j.x, n3_edge_point(&e, t), i);
        CHECK_VEC(j.dt, narrow(slope), 300 * EPS * M, i);
        CHECK_VEC(j.dtt, narrow(bend), 760 * EPS * M, i);
    }
}

/* x = sum q_ijk 2!/(i! j! k!) u^i v^j w^k has constant second derivatives, and raising it changes
 * nothing: 3 u M in the cubic's net, 5 EPS M for a point of it and 4 EPS M for one of the
 * quadratic; 120 EPS M for second derivatives, and their 6 * 4 terms carry the net's 3 u M. */
static void raised_quadratics_keep_their_jets(void)
{
    long i, count = sample_count(100000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_patch2 q = n3_patch2_make(s.v[0], s.v[1], s.v[2]);
        n3_patch p = n3_patch2_raise(&q);
        double M = reach(q.p, 6);
        dvec a = wide(q.p[0]), b = wide(q.p[1]), c = wide(q.p[2]);
        dvec ab = wide(q.p[3]), bc = wide(q.p[4]), ca = wide(q.p[5]);
        n3_real u, v;
        n3_jet j;
        dyadic_weights(&s.r, &u, &v);
        j = n3_patch_jet(&p, u, v);
        CHECK_VEC(j.x, n3_patch2_point(&q, u, v), 11 * EPS * M, i);
        CHECK_VEC(j.duu, narrow(d_mix(2, d_add(a, b), -4, ab)), 156 * EPS * M, i);
        CHECK_VEC(j.dvv, narrow(d_mix(2, d_add(a, c), -4, ca)), 156 * EPS * M, i);
        CHECK_VEC(j.duv, narrow(d_mul(2, d_sub(d_add(a, bc), d_add(ab, ca)))), 156 * EPS * M, i);
    }
}

/* Three rounds of two products and a sum in the split, 9 u M = 5 EPS M, and 5 EPS M for each
 * point; t and s t are exact. */
static void split_edges_are_the_edge(void)
{
    long i, count = sample_count(20000);
    rng r = {6};
    for (i = 0; i < count; i++) {
        n3_edge e, part[2];
        n3_real t = dyadic(&r, 0, 1), s = dyadic(&r, 0, 1);
        double tolerance;
        random_net(&r, e.p, 4);
        tolerance = 15 * EPS * reach(e.p, 4);
        n3_edge_split(&e, t, part);
        CHECK_SAME(part[0].p[0], e.p[0], i);
        CHECK_SAME(part[0].p[3], part[1].p[0], i);
        CHECK_SAME(part[1].p[3], e.p[3], i);
        CHECK_VEC(n3_edge_point(&part[0], s), n3_edge_point(&e, s * t), tolerance, i);
        CHECK_VEC(n3_edge_point(&part[1], s), n3_edge_point(&e, t + s * (1 - t)), tolerance, i);
    }
}

/* Rows as they are meant: n3_edge_point along j, then along i. Raising costs 3 u M, a row and the
 * column 5 EPS M each, the point 5 EPS M. */
static void bicubic_nets_are_the_patch(void)
{
    long i, count = sample_count(20000);
    rng r = {7};
    for (i = 0; i < count; i++) {
        n3_patch p = random_patch(&r);
        n3_vec net[16];
        n3_edge column;
        n3_real s = dyadic(&r, 0, 1), t = dyadic(&r, 0, 1);
        int k;
        n3_patch_bicubic(&p, net);
        for (k = 0; k < 4; k++) {
            n3_edge row;
            memcpy(row.p, net + 4 * k, sizeof row.p);
            column.p[k] = narrow(d_bezier(&row, (double)t));
        }
        CHECK_VEC(narrow(d_bezier(&column, (double)s)), n3_patch_point(&p, s * (1 - t), s * t),
                  17 * EPS * reach(p.p, 10), i);
    }
}

/* |n| = 1 to 2 EPS; n is perpendicular to du and dv, each off by 28 EPS of the patch's size in the
 * normal as the header says and by 60 EPS M in the jet, to the sum of these over their sine. */
static void normals_are_those_of_the_jet(void)
{
    long i, count = sample_count(20000);
    rng r = {8};
    for (i = 0; i < count; i++) {
        n3_patch p = random_patch(&r);
        n3_real u, v;
        n3_jet j;
        n3_vec n;
        dvec du, dv, across;
        double error = 100 * EPS * reach(p.p, 10);
        dyadic_weights(&r, &u, &v);
        j = n3_patch_jet(&p, u, v), n = n3_patch_normal(&p, u, v);
        du = wide(j.du), dv = wide(j.dv), across = d_cross(du, dv);
        CHECK_NEAR(length(n), 1, 3 * EPS, i);
        if (d_len(across) <= 8 * error * (d_len(du) + d_len(dv))) continue;
        CHECK_VEC(n, narrow(d_unit(across)),
                  error * (d_len(du) + d_len(dv)) / d_len(across) * 1.5 + 4 * EPS, i);
    }
}

const test_case tests_properties[] = {
    {"segments_are_the_same_from_either_end", segments_are_the_same_from_either_end},
    {"curve_planes_are_the_same_from_either_end", curve_planes_are_the_same_from_either_end},
    {"edges_are_the_same_from_either_end", edges_are_the_same_from_either_end},
    {"edge_points_are_the_same_from_either_end", edge_points_are_the_same_from_either_end},
    {"sides_are_edges", sides_are_edges},
    {"neighbours_share_points", neighbours_share_points},
    {"quadratic_patches_have_the_segments", quadratic_patches_have_the_segments},
    {"corners_may_come_in_any_order", corners_may_come_in_any_order},
    {"edges_are_tangent_to_the_end_planes", edges_are_tangent_to_the_end_planes},
    {"segments_are_tangent_to_the_end_planes", segments_are_tangent_to_the_end_planes},
    {"corners_have_the_vertex_normals", corners_have_the_vertex_normals},
    {"answers_are_finite", answers_are_finite},
    {"handles_are_bounded", handles_are_bounded},
    {"edges_move_with_rigid_motions", edges_move_with_rigid_motions},
    {"arc_centres_move_with_rigid_motions", arc_centres_move_with_rigid_motions},
    {"wanted_normals_may_have_any_length", wanted_normals_may_have_any_length},
    {"edges_are_bounded_next_to_parallel_normals", edges_are_bounded_next_to_parallel_normals},
    {"paper_edges_do_not_need_oriented_normals", paper_edges_do_not_need_oriented_normals},
    {"powers_of_two_change_no_bit", powers_of_two_change_no_bit},
    {"sound_parabolas_are_kept", sound_parabolas_are_kept},
    {"points_lie_in_the_convex_hull", points_lie_in_the_convex_hull},
    {"planes_are_reproduced", planes_are_reproduced},
    {"affine_maps_commute_with_the_evaluator", affine_maps_commute_with_the_evaluator},
    {"patch_jets_are_differences", patch_jets_are_differences},
    {"edge_jets_are_differences", edge_jets_are_differences},
    {"raised_quadratics_keep_their_jets", raised_quadratics_keep_their_jets},
    {"split_edges_are_the_edge", split_edges_are_the_edge},
    {"bicubic_nets_are_the_patch", bicubic_nets_are_the_patch},
    {"normals_are_those_of_the_jet", normals_are_those_of_the_jet},
    {NULL, NULL}};
