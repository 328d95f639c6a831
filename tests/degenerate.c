/* degenerate.c: the answers that the header gives where the construction has none. */
#include "check.h"
#include "naive.h"
#include "samples.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Sizes from 2^-LARGE to 2^LARGE are all alike, 1e-150 to 1e150, in float 1e-18 to 1e18. */
enum { IS_FLOAT = sizeof(n3_real) == sizeof(float), LARGE = IS_FLOAT ? 59 : 498 };

static const int scales[] = {0, -LARGE, LARGE};

static const n3_options paper = {N3_RULE_PAPER, 0, 0}, arc = {N3_RULE_ARC, 0, 0};
static const n3_options *const rules[] = {&paper, &arc};

static n3_vec vec(const double *p) { return narrow(d_v(p[0], p[1], p[2])); }

static n3_vec unit(const double *p)
{
    dvec a = d_v(p[0], p[1], p[2]);
    return d_len(a) > 0 ? narrow(d_unit(a)) : narrow(a);
}

static n3_vertex vertex_of(const double *x, const double *n)
{
    n3_vertex v;
    v.x = vec(x);
    v.n = unit(n);
    return v;
}

/* ---- Vectors ---- */

/* |(3, 4, 12)| = 13: a division, a square root and a product beside the sum of squares. */
static void lengths_at_every_size(void)
{
    const n3_vec a = n3_v(3, 4, 12), zero = n3_v(0, 0, 0);
    const double tiny = IS_FLOAT ? ldexp(1, -149) : ldexp(1, -1074);
    int k, lowest = IS_FLOAT ? -126 : -1022, highest = IS_FLOAT ? 124 : 1020;
    for (k = lowest; k <= highest; k++) {
        n3_vec b = scale_vec(a, k);
        CHECK_NEAR(n3_len(b), ldexp(13, k), 3 * EPS * ldexp(13, k), k);
        CHECK_SAME(n3_unit(b), n3_unit(a), k);
    }
    CHECK_VEC(n3_unit(a), n3_v(3 / (n3_real)13, 4 / (n3_real)13, 12 / (n3_real)13), 3 * EPS, 0);
    CHECK_SAME(n3_unit(n3_v(0, -(n3_real)tiny, 0)), n3_v(0, -1, 0), 0);
    CHECK(same_real(n3_len(n3_v(0, 0, (n3_real)tiny)), (n3_real)tiny), 0);
    CHECK_SAME(n3_unit(zero), zero, 0);
    CHECK(same_real(n3_len(zero), 0), 0);
}

/* ---- Edges ---- */

/* From the origin to x1, with normals that the test makes unit, and the two inner control points
 * that the rules give by hand with the clamps 1/10 and 10. */
typedef struct edge_row {
    const char *name;
    double x1[3], n0[3], n1[3], paper[2][3], arc[2][3];
} edge_row;

#define THIRDS {{1. / 3, 0, 0}, {2. / 3, 0, 0}}
#define Q      0.13807118745769835 /* (sqrt 2 - 1) / 3 */
#define H      0.32014462336780664 /* (2/3) cos 22.5 / (1 + cos 22.5), degrees */
#define H45    0.2263764341437893 /* H / sqrt 2 */

static const edge_row edge_rows[] = {
    {"parallel normals", {1, 0, 0}, {0, 0, 1}, {0, 0, 1}, THIRDS, THIRDS},
    {"parallel, chord at 45 degrees", {1, 0, 1}, {0, 0, 1}, {0, 0, 1},
     {{2. / 3, 0, 0}, {1. / 3, 0, 1}}, {{1. / 3, 0, 0}, {2. / 3, 0, 1}}},
    {"opposite normals", {1, 0, 1}, {0, 0, 1}, {0, 0, -1},
     {{2. / 3, 0, 0}, {1. / 3, 0, 1}}, {{2. / 3, 0, 0}, {1. / 3, 0, 1}}},
    {"first along, second across", {1, 0, 0}, {1, 0, 0}, {0, 0, 1},
     {{0, 0, 4. / 303}, {103. / 303, 0, 0}}, {{0, 0, -2 * Q}, {1 - 2 * Q, 0, 0}}},
    {"second along, first across", {1, 0, 0}, {0, 0, 1}, {1, 0, 0},
     {{200. / 303, 0, 0}, {1, 0, 4. / 303}}, {{2 * Q, 0, 0}, {1, 0, 2 * Q}}},
    {"both along", {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, THIRDS, THIRDS},
    {"both along, opposite", {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, THIRDS, THIRDS},
    {"both zero", {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, THIRDS, THIRDS},
    {"first zero, second across", {1, 0, 0}, {0, 0, 0}, {0, 0, 1}, THIRDS, THIRDS},
    {"first zero, second at 45 degrees", {1, 0, 0}, {0, 0, 0}, {-1, 0, 1},
     {{20. / 33, 0, 0}, {31. / 33, 0, -2. / 33}}, {{H, 0, 0}, {1 - H45, 0, -H45}}},
    {"second zero, first at 45 degrees", {1, 0, 0}, {1, 0, 1}, {0, 0, 0},
     {{2. / 33, 0, -2. / 33}, {13. / 33, 0, 0}}, {{H45, 0, -H45}, {1 - H, 0, 0}}},
    {"first zero, second along", {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, THIRDS, THIRDS},
    {"first along, second zero", {1, 0, 0}, {-1, 0, 0}, {0, 0, 0}, THIRDS, THIRDS},
    {"coincident points", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {{0}}, {{0}}},
    {"coincident, equal normals", {0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {{0}}, {{0}}},
    {"coincident, no normals", {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {{0}}, {{0}}}};

/* A normal along the chord leaves to the side that makes the edge a C: columns for the paper. */
static const edge_row c_rows[] = {
    {"first along, climbing", {1, 0, 0}, {1, 0, 0}, {-1, 0, 1},
     {{0, 0, -4. / 33}, {13. / 33, 0, -20. / 33}}, {{0}}},
    {"first along, falling", {1, 0, 0}, {-1, 0, 0}, {1, 0, 1},
     {{0, 0, 4. / 33}, {13. / 33, 0, 20. / 33}}, {{0}}},
    {"second along, climbing", {1, 0, 0}, {-1, 0, 1}, {1, 0, 0},
     {{20. / 33, 0, 20. / 33}, {1, 0, 4. / 33}}, {{0}}},
    {"second along, falling", {1, 0, 0}, {1, 0, 1}, {-1, 0, 0},
     {{20. / 33, 0, -20. / 33}, {1, 0, -4. / 33}}, {{0}}}};

/* Handles of length at most 4/3 with ten roundings each; 16 EPS covers the row's numbers too. */
static void check_edge_row(const edge_row *row, const double want[2][3], const n3_options *o,
                           long index)
{
    static const double origin[3] = {0, 0, 0};
    size_t i;
    int k;
    for (i = 0; i < sizeof scales / sizeof *scales; i++) {
        n3_vertex a = vertex_of(origin, row->n0), b = vertex_of(row->x1, row->n1);
        n3_edge e, back;
        a = scale_vertex(a, scales[i]), b = scale_vertex(b, scales[i]);
        e = n3_edge_make(a, b, o), back = n3_edge_make(b, a, o);
        for (k = 0; k < 2; k++) {
            CHECK_VEC(e.p[1 + k], scale_vec(vec(want[k]), scales[i]),
                      16 * EPS * ldexp(1, scales[i]), index);
            CHECK_SAME(back.p[2 - k], e.p[1 + k], index);
        }
        CHECK_SAME(e.p[0], a.x, index);
        CHECK_SAME(e.p[3], b.x, index);
    }
}

static void degenerate_edges(void)
{
    size_t i;
    for (i = 0; i < sizeof edge_rows / sizeof *edge_rows; i++) {
        check_edge_row(&edge_rows[i], edge_rows[i].paper, NULL, (long)i);
        check_edge_row(&edge_rows[i], edge_rows[i].arc, &arc, (long)i);
    }
    for (i = 0; i < sizeof c_rows / sizeof *c_rows; i++)
        check_edge_row(&c_rows[i], c_rows[i].paper, NULL, (long)i);
}

/* Coincident points anywhere: every control point is that point, exactly. */
static void coincident_points_give_that_point(void)
{
    long i, count = sample_count(1000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_vertex a = s.v[0], b = s.v[1];
        size_t r;
        int k;
        b.x = a.x;
        for (r = 0; r < 2; r++) {
            n3_edge e = n3_edge_make(a, b, rules[r]);
            for (k = 0; k < 4; k++) CHECK_SAME(e.p[k], a.x, i);
        }
        CHECK_SAME(n3_segment_make(a, b).p[1], a.x, i);
        CHECK_SAME(n3_curve_plane(a, b), n3_v(0, 0, 0), i);
    }
}

static void degenerate_segments(void)
{
    static const edge_row rows[] = {{"parallel", {1, 2, 3}, {0, 0, 1}, {0, 0, 1}, {{0}}, {{0}}},
                                    {"opposite", {1, 2, 3}, {0, 0, 1}, {0, 0, -1}, {{0}}, {{0}}},
                                    {"one zero", {1, 2, 3}, {0, 0, 0}, {0, 0, 1}, {{0}}, {{0}}},
                                    {"both zero", {1, 2, 3}, {0, 0, 0}, {0, 0, 0}, {{0}}, {{0}}}};
    static const double origin[3] = {0, 0, 0};
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        n3_vertex a = vertex_of(origin, rows[i].n0), b = vertex_of(rows[i].x1, rows[i].n1);
        n3_segment s = n3_segment_make(a, b);
        CHECK_SAME(n3_segment_curvature(a, b), n3_v(0, 0, 0), i);
        CHECK_SAME(s.p[1], n3_mul((n3_real)1 / 2, b.x), i);
    }
}

/* A triangle that is a line or a point has the edges it would have in any other. The centre is
 * (6.1.10), a sum of at most 16 roundings. */
static void collapsed_triangles_are_the_patch_of_their_edges(void)
{
    static const int corners[][3] = {{0, 0, 1}, {0, 1, 1}, {0, 1, 0}, {0, 0, 0}};
    long i, count = sample_count(1000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        const int *c = corners[i % 4];
        n3_patch p = n3_patch_make(s.v[c[0]], s.v[c[1]], s.v[c[2]], NULL);
        n3_edge e[3];
        dvec handles = d_v(0, 0, 0), ends = d_v(0, 0, 0);
        int j, k;
        n3_patch_edges(&p, e);
        for (j = 0; j < 3; j++) {
            n3_edge want = n3_edge_make(s.v[c[j]], s.v[c[(j + 1) % 3]], NULL);
            for (k = 0; k < 4; k++) CHECK_SAME(e[j].p[k], want.p[k], i);
            handles = d_add(handles, d_add(wide(want.p[1]), wide(want.p[2])));
            ends = d_add(ends, wide(want.p[0]));
        }
        CHECK_VEC(p.p[9], narrow(d_mix(1. / 4, handles, -1. / 6, ends)), 16 * EPS * reach(p.p, 10),
                  i);
    }
}

/* ---- Thresholds, from both sides ---- */

static n3_vertex at(n3_vec x, n3_vec n)
{
    n3_vertex v;
    v.x = x;
    v.n = n;
    return v;
}

/* With n0 = z and n1 = (s, 0, 1), X = (0, s, 0) exactly. */
static void threshold_of_parallel_normals(void)
{
    const n3_vec x = n3_v(0, 0, 0), y = n3_v(1, 0, 1);
    n3_real s = (n3_real)ldexp(1, IS_FLOAT ? -22 : -50), more = s * (1 + N3_EPS);
    n3_real side;
    for (side = -1; side <= 1; side += 2) { /* parallel, opposite */
        n3_vertex a = at(x, n3_v(0, 0, 1));
        n3_vec none = n3_segment_curvature(a, at(y, n3_v(s, 0, side)));
        n3_vec most = n3_segment_curvature(a, at(y, n3_v(more, 0, side)));
        CHECK_SAME(none, n3_v(0, 0, 0), (long)side);
        CHECK(n3_len(most) > 1 / s && is_finite_vec(most), (long)side);
    }
}

/* With e = x and n0 = (1, s, 0), e x n0 = (0, 0, s) exactly; the other end's m is -y. */
static void threshold_of_normals_along_the_chord(void)
{
    const n3_vec none = n3_v(0, 0, 0), x = n3_v(1, 0, 0), z = n3_v(0, 0, 1);
    const n3_vec third = n3_v((n3_real)1 / 3, 0, 0), rises = n3_v(0, 0, (n3_real)(4. / 303));
    const n3_real half = (n3_real)sqrt(0.5);
    n3_real s = (n3_real)ldexp(1, IS_FLOAT ? -16 : -40), more = s * (1 + N3_EPS);
    n3_vertex along = at(none, n3_v(1, s, 0)), past = at(none, n3_v(1, more, 0));
    n3_vertex b = at(x, z), zero = at(x, none);
    CHECK_SAME(n3_curve_plane(along, b), n3_v(0, -1, 0), 0);
    CHECK_VEC(n3_curve_plane(past, b), n3_v(0, -half, half), 4 * EPS, 1);
    CHECK_SAME(n3_curve_plane(along, at(x, n3_v(1, -s, 0))), none, 2);
    CHECK_VEC(n3_edge_make(along, at(x, n3_v(-1, s, 0)), NULL).p[1], third, EPS, 3);
    CHECK_VEC(n3_edge_make(along, zero, NULL).p[1], third, EPS, 4);
    CHECK_VEC(n3_edge_make(along, b, NULL).p[1], rises, 4 * EPS, 5);
    CHECK(fabs((double)n3_edge_make(past, b, NULL).p[1].y) > 1e-3, 6);
    CHECK(fabs((double)n3_edge_make(past, zero, NULL).p[1].y) > 1e-3, 7);
}

/* |n0 + n1| = s exactly. */
static void threshold_of_opposite_normals(void)
{
    const n3_vertex a = at(n3_v(0, 0, 0), n3_v(0, 0, 1));
    const n3_vec x = n3_v(1, 0, 0);
    n3_real s = (n3_real)ldexp(1, IS_FLOAT ? -12 : -26), more = s * (1 + N3_EPS);
    n3_edge want = n3_edge_make(a, at(x, n3_v(s, 0, -1)), &paper);
    n3_edge at_it = n3_edge_make(a, at(x, n3_v(s, 0, -1)), &arc);
    n3_edge past = n3_edge_make(a, at(x, n3_v(more, 0, -1)), &arc);
    CHECK_SAME(at_it.p[1], want.p[1], 0);
    CHECK_SAME(at_it.p[2], want.p[2], 0);
    CHECK(fabs((double)past.p[1].x - (double)want.p[1].x) > 0.1, 1);
}

/* ---- Scales ---- */

/* The factor is a power of two, so there is no rounding to allow for. Mixed exponents do underflow
 * here, and they are scaled in the properties. */
static void sizes_are_all_alike(void)
{
    long i, count = sample_count(10000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        const n3_options *o = rules[i / KINDS % 2];
        int k, exponent = scales[1 + i / KINDS % 4 / 2];
        n3_vertex one[3], other[3];
        answers want, got;
        n3_real u, v;
        if (s.kind == MIXED_EXPONENTS) continue;
        dyadic_weights(&s.r, &u, &v);
        for (k = 0; k < 3; k++) {
            one[k] = scale_vertex(s.v[k], -s.exponent);
            other[k] = scale_vertex(one[k], exponent);
        }
        want = ask(one, o, u, v), got = ask(other, o, u, v);
        check_alike(&got, &want, exponent, i);
    }
}

/* ---- NaN and infinity ---- */

/* Component 0..5 of a vertex. */
static n3_real *component(n3_vertex *v, int i)
{
    n3_vec *a = i < 3 ? &v->x : &v->n;
    return i % 3 == 0 ? &a->x : i % 3 == 1 ? &a->y : &a->z;
}

static int is_bad(n3_vec a) { return !is_finite_vec(a); }

/* The edge opposite to the bad corner is what it was; the two others, their segments and the
 * centre are bad, and so is every point inside. */
static void check_spoiled(const n3_vertex v[3], const n3_vertex good[3], int corner,
                          const n3_options *o, long row)
{
    n3_patch p = n3_patch_make(v[0], v[1], v[2], o);
    n3_patch2 q = n3_patch2_make(v[0], v[1], v[2]);
    const n3_real third = (n3_real)1 / 3;
    int next = (corner + 1) % 3, last = (corner + 2) % 3, k;
    n3_edge e[3], want = n3_edge_make(good[next], good[last], o);
    n3_patch_edges(&p, e);
    for (k = 0; k < 4; k++) CHECK_SAME(e[next].p[k], want.p[k], row);
    CHECK(is_bad(e[corner].p[1]) && is_bad(e[corner].p[2]), row);
    CHECK(is_bad(e[last].p[1]) && is_bad(e[last].p[2]), row);
    CHECK(is_bad(p.p[9]) && is_bad(n3_patch_point(&p, third, third)), row);
    CHECK(is_bad(n3_patch_normal(&p, third, third)), row);
    CHECK(is_bad(n3_patch_jet(&p, third, third).du), row);
    CHECK(is_bad(q.p[3 + corner]) && is_bad(q.p[3 + last]), row);
    CHECK(is_bad(n3_patch2_point(&q, third, third)), row);
    CHECK(is_bad(n3_curve_plane(v[corner], v[next])), row);
}

static void one_bad_component_spoils_what_depends_on_it(void)
{
    const n3_real bad[] = {(n3_real)NAN, (n3_real)INFINITY, -(n3_real)INFINITY};
    long i, count = sample_count(100);
    int corner, c;
    size_t b;
    for (i = 0; i < count; i++) {
        sample s = sample_make(i * KINDS + BENIGN);
        for (corner = 0; corner < 3; corner++)
            for (c = 0; c < 6; c++)
                for (b = 0; b < sizeof bad / sizeof *bad; b++) {
                    n3_vertex v[3];
                    memcpy(v, s.v, sizeof v);
                    *component(&v[corner], c) = bad[b];
                    check_spoiled(v, s.v, corner, rules[i % 2], i);
                }
    }
}

/* The same in triangles of every other kind: no answer is asked for, only an end. */
static void bad_components_end(void)
{
    long i, count = sample_count(10000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_real bad = (n3_real)(i % 2 ? NAN : INFINITY);
        *component(&s.v[i / 18 % 3], (int)(i / 3 % 6)) = bad;
        (void)ask(s.v, rules[i % 2], (n3_real)1 / 4, (n3_real)1 / 2);
    }
}

static void check_bad_weights(const n3_patch *p, const n3_patch2 *q, n3_real u, n3_real v, long row)
{
    n3_jet j = n3_patch_jet(p, u, v);
    CHECK(is_bad(n3_patch_point(p, u, v)), row);
    CHECK(is_bad(n3_patch2_point(q, u, v)), row);
    CHECK(is_bad(j.x) && is_bad(j.du) && is_bad(j.dv), row);
    CHECK(is_bad(j.duu) && is_bad(j.duv) && is_bad(j.dvv), row);
    CHECK(is_bad(n3_patch_normal(p, u, v)), row);
}

static void bad_parameters_give_bad_points(void)
{
    const n3_real bad[] = {(n3_real)NAN, (n3_real)INFINITY, -(n3_real)INFINITY};
    sample s = sample_make(BENIGN);
    n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], NULL);
    n3_patch2 q = n3_patch2_make(s.v[0], s.v[1], s.v[2]);
    n3_edge e[3], part[2];
    size_t b;
    n3_patch_edges(&p, e);
    for (b = 0; b < sizeof bad / sizeof *bad; b++) {
        n3_curve_jet j = n3_edge_jet(&e[0], bad[b]);
        check_bad_weights(&p, &q, bad[b], (n3_real)1 / 4, (long)b);
        check_bad_weights(&p, &q, (n3_real)1 / 4, bad[b], (long)b);
        check_bad_weights(&p, &q, bad[b], 0, (long)b);
        check_bad_weights(&p, &q, 0, bad[b], (long)b);
        CHECK(is_bad(j.x) && is_bad(j.dt) && is_bad(j.dtt), b);
        n3_edge_split(&e[0], bad[b], part);
        CHECK(is_bad(part[0].p[3]) && is_bad(part[1].p[0]), b);
    }
}

/* A NaN in any place, beside zeros and beside larger numbers. */
static void lengths_of_nan(void)
{
    int place, beside;
    for (place = 0; place < 3; place++)
        for (beside = 0; beside < 3; beside++) {
            n3_real x[3];
            x[place] = (n3_real)NAN;
            x[(place + 1) % 3] = (n3_real)(beside == 1);
            x[(place + 2) % 3] = (n3_real)(beside == 2);
            CHECK(isnan(n3_len(n3_v(x[0], x[1], x[2]))), place);
            CHECK(is_nan_vec(n3_unit(n3_v(x[0], x[1], x[2]))), place);
        }
}

/* A bad control point spoils the normal everywhere inside. */
static void bad_nets_have_bad_normals(void)
{
    sample s = sample_make(BENIGN);
    const n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], NULL);
    int k, c;
    for (k = 0; k < 10; k++)
        for (c = 0; c < 6; c++) {
            n3_patch q = p;
            n3_real bad = (n3_real)(c < 3 ? NAN : INFINITY);
            if (c % 3 == 0) q.p[k].x = bad;
            if (c % 3 == 1) q.p[k].y = bad;
            if (c % 3 == 2) q.p[k].z = bad;
            CHECK(is_bad(n3_patch_normal(&q, (n3_real)1 / 4, (n3_real)1 / 4)), k);
        }
}

/* ---- Options ---- */

typedef struct option_row { double lo, hi, same_lo, same_hi; } option_row;

#define NO  ((double)NAN)
#define INF ((double)INFINITY)

/* What is not > 0 is the default, 1/10 and 10; hi is at least lo. */
static const option_row option_rows[] = {
    {0, 0, 0.1, 10},     {-1, -2, 0.1, 10},     {NO, NO, 0.1, 10}, {-INF, -INF, 0.1, 10},
    {0.5, NO, 0.5, 10},  {NO, 2, 0.1, 2},       {1, 0.5, 1, 1},    {20, 0, 20, 20},
    {0.25, -1, 0.25, 10}, {0, 0.01, 0.1, 0.1}};

static n3_options options(int rule, double lo, double hi)
{
    n3_options o;
    o.rule = rule;
    o.tan_lo = (n3_real)lo;
    o.tan_hi = (n3_real)hi;
    return o;
}

static n3_options like(const option_row *row)
{
    n3_options o = options(N3_RULE_PAPER, row->same_lo, row->same_hi);
    if (o.tan_lo <= (n3_real)0.1 && o.tan_lo >= (n3_real)0.1) o.tan_lo = (n3_real)1 / 10;
    return o;
}

static void check_same_edges(n3_vertex a, n3_vertex b, const n3_options *o, const n3_options *p,
                             long row)
{
    n3_edge e = n3_edge_make(a, b, o), f = n3_edge_make(a, b, p);
    int k;
    for (k = 0; k < 4; k++) CHECK_SAME(e.p[k], f.p[k], row);
}

static void options_have_defaults(void)
{
    long i, count = sample_count(2000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        size_t row = (size_t)i / KINDS % (sizeof option_rows / sizeof *option_rows);
        const option_row *r = &option_rows[row];
        n3_options o = options(N3_RULE_PAPER, r->lo, r->hi), same = like(r);
        n3_options plain = options(N3_RULE_PAPER, 0.1, 10), unknown = options(99, 0, 0);
        n3_options fit = options(N3_RULE_FIT, 0, 0);
        check_same_edges(s.v[0], s.v[1], &o, &same, (long)row);
        check_same_edges(s.v[0], s.v[1], NULL, &plain, -1);
        check_same_edges(s.v[0], s.v[1], NULL, &unknown, -2);
        check_same_edges(s.v[0], s.v[1], &arc, &fit, -3);
    }
}

/* Clamps as wide or as tight as they go: the handles stay within 4/3 of the chord. From infinite
 * ones no finite answer is asked, but none that is wrong. */
static void extreme_clamps(void)
{
    static const double clamps[][2] = {
        {1e-30, 1e30}, {1e30, 1e30}, {1e-30, 1e-30}, {1, INF}, {INF, 1}};
    long i, count = sample_count(10000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        const double *c = clamps[i / KINDS % 5];
        n3_options o = options(N3_RULE_PAPER, c[0], c[1]);
        n3_edge e = n3_edge_make(s.v[0], s.v[1], &o);
        double L = d_len(wide(n3_sub(s.v[1].x, s.v[0].x)));
        double longest = 4 * L / 3 * (1 + 16 * EPS) + 2 * EPS * reach(e.p, 4);
        CHECK(!(d_len(wide(n3_sub(e.p[1], e.p[0]))) > longest), i);
        CHECK(!(d_len(wide(n3_sub(e.p[3], e.p[2]))) > longest), i);
        CHECK((is_finite_vec(e.p[1]) && is_finite_vec(e.p[2])) || i / KINDS % 5 >= 3, i);
    }
}

/* ---- Normals ---- */

/* A flat net, a = (0,0,0), b = (3,0,0), c = (0,3,0), with up to six control points changed. */
typedef struct change { int index; double x[3]; } change;
typedef struct normal_row {
    const char *name;
    change changes[10];
    double u, v, want[3];
} normal_row;

#define NONE                                                                                       \
    {                                                                                              \
        -1, { 0, 0, 0 }                                                                            \
    }

/* With a at the origin and D the derivative along (1/3, 1/3), towards the centroid, at a
 *     du = 3 p102, dv = 3 p012,
 *     D du = 2 (p201 - 2 p102 + p111 - p102 - p012), D dv = 2 (p111 - p102 - p012 + p021 - 2 p012);
 * where du x dv is zero, the limit is D du x dv + du x D dv, where du and dv are, D du x D dv. */
static const normal_row normal_rows[] = {
    {"flat, corner", {NONE}, 0, 0, {0, 0, 1}},
    {"flat, centre", {NONE}, 1. / 3, 1. / 3, {0, 0, 1}},
    {"flat, outside", {NONE}, 2, 1, {0, 0, 1}},
    /* (2,0,1) + (1,0,1) across (0,1,0) */
    {"one handle", {{3, {0, 0, 0}}, {4, {2, 0, 1}}, {9, {1, 1, 1}}, NONE}, 0, 0, {-2, 0, 3}},
    /* (1,0,0) across (0,1,1) + (0,2,0): p111 - p102 = (0,1,1) */
    {"the other", {{8, {0, 0, 0}}, {9, {1, 1, 1}}, NONE}, 0, 0, {0, -1, 3}},
    /* (2,0,1) + (1,1,0) across (1,1,0) + (0,2,0) */
    {"two handles", {{3, {0, 0, 0}}, {8, {0, 0, 0}}, {4, {2, 0, 1}}, NONE}, 0, 0, {-3, 1, 8}},
    /* (-4,2,2) x (6,0,0) + (3,0,0) x (-12,6,2) */
    {"parallel handles", {{8, {2, 0, 0}}, {9, {1, 1, 1}}, NONE}, 0, 0, {0, 1, 1}},
    /* ab is the point a: on it du = 0, dv = 3 f, D du = f', f = w^2 p012 + 2 u w p111 + u^2 p210 */
    {"collapsed side, at its start",
     {{1, {0}}, {3, {0}}, {4, {0}}, {8, {1, 0, 0}}, {9, {1, 1, 1}}, {5, {0, 1, 0}}, NONE},
     0, 0, {0, 1, -1}},
    {"collapsed side, at its end",
     {{1, {0}}, {3, {0}}, {4, {0}}, {8, {1, 0, 0}}, {9, {1, 1, 1}}, {5, {0, 1, 0}}, NONE},
     1, 0, {1, 0, -1}},
    /* f = (3,3,2)/4, f' = (-1,1,0) */
    {"collapsed side, in its middle",
     {{1, {0}}, {3, {0}}, {4, {0}}, {8, {1, 0, 0}}, {9, {1, 1, 1}}, {5, {0, 1, 0}}, NONE},
     0.5, 0, {1, 1, -3}},
    /* 3 b u^2 + 6 p210 u v + 3 p120 v^2 across 3 p210 u^2 + 6 p120 u v + 3 c v^2 at u = v */
    {"nothing but bc",
     {{3, {0}}, {4, {0}}, {7, {0}}, {8, {0}}, {9, {0}}, {1, {3, 0, 3}}, NONE}, 0, 0, {-2, 1, 4}},
    /* du = 0 at the centroid itself, so no way leads there: b x c, or the outline */
    {"the triangle's", {{5, {-2.5, 1, 1}}, {7, {0, 2, 2}}, NONE}, 1. / 3, 1. / 3, {0, 0, 1}},
    {"the net's",
     {{1, {0}}, {2, {0}}, {5, {0}}, {7, {0}}, {8, {0}}, {9, {0}}, {3, {1, 0, 0}}, {4, {0, 1, 1}},
      {6, {1, -1, -1}}, NONE}, 1. / 3, 1. / 3, {0, -1, 1}},
    {"a line",
     {{2, {6, 0, 0}}, {5, {4, 0, 0}}, {6, {5, 0, 0}}, {7, {4, 0, 0}}, {8, {2, 0, 0}},
      {9, {3, 0, 0}}, NONE}, 0.25, 0.25, {0, 0, 0}},
    {"a point",
     {{1, {0}}, {2, {0}}, {3, {0}}, {4, {0}}, {5, {0}}, {6, {0}}, {7, {0}}, {8, {0}}, {9, {0}},
      NONE}, 0.25, 0.25, {0, 0, 0}}};

static n3_patch net_of(const normal_row *row)
{
    static const double flat[10][3] = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 0, 0}, {2, 0, 0},
                                       {2, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}, {1, 1, 0}};
    n3_patch p;
    const change *c;
    int k;
    for (k = 0; k < 10; k++) p.p[k] = vec(flat[k]);
    for (c = row->changes; c->index >= 0; c++) p.p[c->index] = vec(c->x);
    return p;
}

/* The same surface with b first, and (u, v) of the same point. */
static void turn_corners(n3_patch *p, double *u, double *v)
{
    static const int from[10] = {1, 2, 0, 5, 6, 7, 8, 3, 4, 9};
    n3_patch q = *p;
    double w = 1 - *u - *v;
    int k;
    for (k = 0; k < 10; k++) p->p[k] = q.p[from[k]];
    *u = *v;
    *v = w;
}

static n3_vec framed(n3_vec a) { return narrow(in_frame((double)a.x, (double)a.y, (double)a.z)); }

/* du and dv have the error 28 EPS of a net whose size is 1, and so does D du; no row's cross
 * product is shorter than 1/16 of the squared size. In a frame along no axis, what vanishes does so
 * to rounding only. */
static void check_normal_row(const normal_row *row, int tilted, int exponent, long index)
{
    n3_patch p = net_of(row);
    n3_vec want = unit(row->want);
    double u = row->u, v = row->v;
    int turn, k;
    for (k = 0; k < 10; k++) p.p[k] = tilted ? framed(p.p[k]) : p.p[k];
    want = tilted ? framed(want) : want;
    for (turn = 0; turn < 3; turn++) {
        n3_patch q = p;
        for (k = 0; k < 10; k++) q.p[k] = scale_vec(p.p[k], exponent);
        CHECK_VEC(n3_patch_normal(&q, (n3_real)u, (n3_real)v), want, 16 * 28 * EPS, index);
        turn_corners(&p, &u, &v);
    }
}

static void degenerate_normals(void)
{
    size_t i, k;
    for (i = 0; i < sizeof normal_rows / sizeof *normal_rows; i++)
        for (k = 0; k < sizeof scales / sizeof *scales; k++) {
            check_normal_row(&normal_rows[i], 0, scales[k], (long)i);
            check_normal_row(&normal_rows[i], 1, scales[k], (long)i);
        }
}

/* The rows are limits: next to the point, on the way to the centroid, the normal is theirs up to
 * the step times the net's second over its first derivatives, below 16. */
static void degenerate_normals_are_limits(void)
{
    const double step = ldexp(1, IS_FLOAT ? -8 : -16);
    size_t i;
    for (i = 0; i < sizeof normal_rows / sizeof *normal_rows; i++) {
        const normal_row *row = &normal_rows[i];
        n3_patch p = net_of(row);
        double u = row->u + step * (1. / 3 - row->u), v = row->v + step * (1. / 3 - row->v);
        if (row->u > 0.3 && row->v > 0.3) continue;
        CHECK_VEC(n3_patch_normal(&p, (n3_real)u, (n3_real)v), unit(row->want), 16 * step, i);
    }
}

/* Flat, with exact coordinates: the triangle's normal holds out to a width of 8 EPS, in float an
 * aspect of 1e6. */
static void slivers_have_normals(void)
{
    double width;
    for (width = 1; width > 8 * EPS; width *= 0.75) {
        n3_vertex a = at(n3_v(0, 0, 0), n3_v(0, 0, 1)), b = a, c = a;
        n3_patch p;
        b.x.x = 1;
        c.x = n3_v((n3_real)0.5, (n3_real)width, 0);
        p = n3_patch_make(a, b, c, NULL);
        CHECK_VEC(n3_patch_normal(&p, 0, 0), a.n, 2 * EPS, 0);
        CHECK_VEC(n3_patch_normal(&p, (n3_real)0.25, (n3_real)0.5), a.n, 2 * EPS, 1);
    }
}

/* All control points equal, anywhere: no normal, whatever the parameters. */
static void points_have_no_normal(void)
{
    long i, count = sample_count(1000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i);
        n3_patch p;
        n3_real u, v;
        int k;
        dyadic_weights(&s.r, &u, &v);
        for (k = 0; k < 10; k++) p.p[k] = s.v[0].x;
        CHECK_SAME(n3_patch_normal(&p, u, v), n3_v(0, 0, 0), i);
    }
}

const test_case tests_degenerate[] = {
    {"lengths_at_every_size", lengths_at_every_size},
    {"degenerate_edges", degenerate_edges},
    {"coincident_points_give_that_point", coincident_points_give_that_point},
    {"degenerate_segments", degenerate_segments},
    {"collapsed_triangles_are_the_patch_of_their_edges",
     collapsed_triangles_are_the_patch_of_their_edges},
    {"threshold_of_parallel_normals", threshold_of_parallel_normals},
    {"threshold_of_normals_along_the_chord", threshold_of_normals_along_the_chord},
    {"threshold_of_opposite_normals", threshold_of_opposite_normals},
    {"sizes_are_all_alike", sizes_are_all_alike},
    {"one_bad_component_spoils_what_depends_on_it", one_bad_component_spoils_what_depends_on_it},
    {"bad_components_end", bad_components_end},
    {"bad_parameters_give_bad_points", bad_parameters_give_bad_points},
    {"lengths_of_nan", lengths_of_nan},
    {"bad_nets_have_bad_normals", bad_nets_have_bad_normals},
    {"options_have_defaults", options_have_defaults},
    {"extreme_clamps", extreme_clamps},
    {"degenerate_normals", degenerate_normals},
    {"degenerate_normals_are_limits", degenerate_normals_are_limits},
    {"slivers_have_normals", slivers_have_normals},
    {"points_have_no_normal", points_have_no_normal},
    {NULL, NULL}};
