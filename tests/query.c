/* Queries of one patch: boxes, parts, curvature, the nearest point, sums. Rays: query_hit.c. */
#include "built.h"
#include "naive.h"
#include "samples.h"

#include <math.h>

/* Through a pointer, so that one compiled copy answers. */
static n3_real (*volatile const edge_nearest)(const n3_edge *, n3_vec) = n3_edge_nearest;

static n3_patch random_net(rng *r)
{
    n3_patch p;
    int i;
    for (i = 0; i < 10; i++) p.p[i] = rng_vec(r);
    return p;
}

/* By turns a sample of each awkward kind, by either rule, and a wild net. */
static n3_patch patch_of(long i, rng *r)
{
    sample s = sample_make(i / 4);
    n3_options o = {N3_RULE_PAPER, 0, 0};
    if (i % 4 == 3) return random_net(r);
    o.rule = i % 2 ? N3_RULE_ARC : N3_RULE_PAPER;
    return n3_patch_make(s.v[0], s.v[1], s.v[2], &o);
}

static void inner_weights(rng *r, n3_real *u, n3_real *v)
{
    double a = rng_uniform(r, 0, 1), b = rng_uniform(r, 0, 1);
    *u = (n3_real)(a + b < 1 ? a : 1 - a);
    *v = (n3_real)(a + b < 1 ? b : 1 - b);
}

/* The largest coordinate of a way from the first control point. */
static double extent(const n3_patch *p)
{
    n3_vec d[10];
    int i;
    for (i = 0; i < 10; i++) d[i] = n3_sub(p->p[i], p->p[0]);
    return reach(d, 10);
}

/* ---- Boxes and flatness ---- */

static void check_in_box(n3_box box, n3_vec x, double tol, long row)
{
    CHECK((double)(box.lo.x - x.x) <= tol && (double)(x.x - box.hi.x) <= tol, row);
    CHECK((double)(box.lo.y - x.y) <= tol && (double)(x.y - box.hi.y) <= tol, row);
    CHECK((double)(box.lo.z - x.z) <= tol && (double)(x.z - box.hi.z) <= tol, row);
}

static n3_vec lower(n3_vec a, n3_vec b)
{
    return n3_v(a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z);
}

/* Over a triangle of the lattice of 1/N a cubic leaves the plane through its corners by at most
   h^2/2 times its second derivative, here below 6 * 4 times the net's extent. */
static void boxes_hold_and_fit(void)
{
    enum { N = 24 };
    rng r = {31};
    long i, count = sample_count(150);
    for (i = 0; i < count; i++) {
        n3_patch p = patch_of(i, &r);
        n3_box net = n3_patch_box(&p), tight = n3_patch_box_tight(&p, (n3_real)0.01), seen;
        double tol = 32 * EPS * reach(p.p, 10), gap = extent(&p) * (0.02 + 12.0 / (N * N));
        int a, b;
        seen.lo = seen.hi = p.p[0];
        for (a = 0; a <= N; a++)
            for (b = 0; a + b <= N; b++) {
                n3_vec x = n3_patch_point(&p, (n3_real)a / N, (n3_real)b / N);
                check_in_box(tight, x, tol, i);
                seen.lo = lower(seen.lo, x);
                seen.hi = n3_mul(-1, lower(n3_mul(-1, seen.hi), n3_mul(-1, x)));
            }
        check_in_box(net, tight.lo, 0, i);
        check_in_box(net, tight.hi, 0, i);
        CHECK_VEC(tight.lo, seen.lo, gap + tol, i);
        CHECK_VEC(tight.hi, seen.hi, gap + tol, i);
    }
}

/* z = 1 - (4 u - 1)^2 - (4 v - 1)^2 and the same on a ridge, z = 1 - (4 u - 1)^2: the top is 1. */
static void tight_boxes_of_hills(void)
{
    static const n3_real square[4] = {1, (n3_real)-5 / 3, 1, 9}; /* polar form of (4 u - 1)^2 */
    static const int at[10][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0},
                                  {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    n3_patch hill, ridge;
    int i;
    for (i = 0; i < 10; i++) {
        ridge.p[i] = n3_v((n3_real)at[i][0], (n3_real)at[i][1], 1 - square[at[i][0]]);
        hill.p[i] = ridge.p[i];
        hill.p[i].z -= square[at[i][1]];
    }
    CHECK_NEAR(n3_patch_box(&hill).hi.z, 13.0 / 3, 8 * EPS, 0);
    CHECK_NEAR(n3_patch_box_tight(&hill, 0).hi.z, 1, 10 * 16 * EPS, 0);
    CHECK_NEAR(n3_patch_box_tight(&hill, (n3_real)1e-3).hi.z, 1, 10 * 1e-3, 0);
    CHECK(n3_patch_box_tight(&hill, (n3_real)1e-3).hi.z >= 1 - 8 * N3_EPS, 0);
    CHECK_NEAR(n3_patch_box_tight(&ridge, (n3_real)1e-3).hi.z, 1, 10 * 1e-3, 1);
    CHECK(n3_patch_box_tight(&ridge, 0).hi.z >= 1 - 8 * N3_EPS, 1);
}

static void flatness_is_a_bound(void)
{
    rng r = {32};
    n3_vec up = {3, -4, 12};
    n3_real third = (n3_real)1 / 3;
    long i, count = sample_count(500);
    for (i = 0; i < count; i++) {
        n3_patch p = patch_of(i, &r), q;
        double bound = (double)n3_patch_flatness(&p), tol = 32 * EPS * reach(p.p, 10);
        n3_vec x[3];
        int k;
        for (k = 0; k < 30; k++) {
            n3_real u, v;
            n3_vec flat;
            inner_weights(&r, &u, &v);
            flat = n3i_mix(1 - u - v, p.p[0], u, p.p[1], v, p.p[2]);
            CHECK((double)n3_len(n3_sub(n3_patch_point(&p, u, v), flat)) <= bound + tol, i);
        }
        for (k = 0; k < 3; k++) x[k] = rng_vec(&r);
        for (k = 0; k < 10; k++) {
            static const int to[10][3] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 1, 0}, {1, 2, 0},
                                          {0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {1, 1, 1}};
            q.p[k] = n3_mul(third, n3i_mix((n3_real)to[k][0], x[0], (n3_real)to[k][1], x[1],
                                           (n3_real)to[k][2], x[2]));
            if (k > 2) q.p[k] = n3_add(q.p[k], up);
        }
        CHECK_NEAR(n3_patch_flatness(&q), 13 * 8.0 / 9, 64 * EPS * 13, i);
        CHECK_VEC(n3_sub(n3_patch_point(&q, third, third),
                         n3i_mix(third, x[0], third, x[1], third, x[2])),
                  n3_mul((n3_real)8 / 9, up), 64 * EPS * 13, i);
    }
}

/* ---- Parts ---- */

/* A point of a part is the point of the patch at the mixed u and v. Each of the three steps to a
   control point, and the evaluation, keeps within 8 ulp; u and v are off by 2 eps, which the
   derivative, at most 6 times the extent, takes to the point. */
static void parts_are_parts(void)
{
    rng r = {33};
    long i, count = sample_count(3000);
    for (i = 0; i < count; i++) {
        n3_patch p = patch_of(i, &r), part;
        n3_real uv[6], u, v, s, t;
        double tol = 32 * EPS * reach(p.p, 10) + 24 * EPS * extent(&p);
        int k;
        for (k = 0; k < 6; k += 2) inner_weights(&r, &uv[k], &uv[k + 1]);
        part = n3_patch_part(&p, uv);
        inner_weights(&r, &s, &t);
        u = (1 - s - t) * uv[0] + s * uv[2] + t * uv[4];
        v = (1 - s - t) * uv[1] + s * uv[3] + t * uv[5];
        CHECK_VEC(n3_patch_point(&part, s, t), n3_patch_point(&p, u, v), tol, i);
    }
}

static void corners_in_another_order(void)
{
    static const n3_real uv[6][6] = {{0, 0, 1, 0, 0, 1}, {1, 0, 0, 1, 0, 0}, {0, 1, 0, 0, 1, 0},
                                     {1, 0, 0, 0, 0, 1}, {0, 0, 0, 1, 1, 0}, {0, 1, 1, 0, 0, 0}};
    static const int net[6][10] = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 0, 5, 6, 7, 8, 3, 4, 9},
                                   {2, 0, 1, 7, 8, 3, 4, 5, 6, 9}, {1, 0, 2, 4, 3, 8, 7, 6, 5, 9},
                                   {0, 2, 1, 8, 7, 6, 5, 4, 3, 9}, {2, 1, 0, 6, 5, 4, 3, 8, 7, 9}};
    rng r = {34};
    int i, k;
    for (i = 0; i < 6; i++) {
        n3_patch p = random_net(&r), q = n3_patch_part(&p, uv[i]);
        for (k = 0; k < 10; k++) CHECK_SAME(q.p[k], p.p[net[i][k]], 10 * i + k);
    }
}

static n3_edge side_of(const n3_patch *p, int side, int back)
{
    n3_edge e[3];
    n3_patch_edges(p, e);
    return back ? n3_edge_reverse(&e[side]) : e[side];
}

static void check_same_edge(n3_edge a, n3_edge b, long row)
{
    int k;
    for (k = 0; k < 4; k++) CHECK_SAME(a.p[k], b.p[k], row);
}

/* The three parts at a point share sides, keep those of the patch and meet in the point. */
static void splits_share_sides(void)
{
    rng r = {35};
    long i, count = sample_count(500);
    for (i = 0; i < count; i++) {
        n3_patch p = patch_of(i, &r), s[3];
        n3_real u, v;
        inner_weights(&r, &u, &v);
        n3_patch_split(&p, u, v, s);
        check_same_edge(side_of(&s[0], 1, 0), side_of(&p, 1, 0), i);
        check_same_edge(side_of(&s[1], 2, 0), side_of(&p, 2, 0), i);
        check_same_edge(side_of(&s[2], 0, 0), side_of(&p, 0, 0), i);
        check_same_edge(side_of(&s[0], 0, 0), side_of(&s[2], 1, 1), i);
        check_same_edge(side_of(&s[0], 2, 0), side_of(&s[1], 1, 1), i);
        check_same_edge(side_of(&s[1], 0, 0), side_of(&s[2], 2, 1), i);
        CHECK_VEC(s[0].p[0], n3_patch_point(&p, u, v), 32 * EPS * reach(p.p, 10), i);
    }
}

/* The four parts share sides, with each other and with those of a patch across a side; a dyadic
   point is where it was. */
static void quarters_share_sides(void)
{
    rng r = {36};
    long i, count = sample_count(500);
    for (i = 0; i < count; i++) {
        n3_patch p = patch_of(i, &r), q = random_net(&r), s[4], t[4];
        static const int across[4] = {1, 6, 5, 2}; /* q's side ab is p's bc, run backwards */
        static const int to[4] = {1, 3, 4, 0};
        int k;
        for (k = 0; k < 4; k++) q.p[to[k]] = p.p[across[k]];
        n3_patch_split4(&p, s);
        n3_patch_split4(&q, t);
        check_same_edge(side_of(&s[0], 1, 0), side_of(&s[3], 1, 1), i);
        check_same_edge(side_of(&s[1], 2, 0), side_of(&s[3], 2, 1), i);
        check_same_edge(side_of(&s[2], 0, 0), side_of(&s[3], 0, 1), i);
        check_same_edge(side_of(&s[1], 1, 0), side_of(&t[1], 0, 1), i);
        check_same_edge(side_of(&s[2], 1, 0), side_of(&t[0], 0, 1), i);
        CHECK_VEC(n3_patch_point(&s[3], (n3_real)1 / 4, (n3_real)1 / 2),
                  n3_patch_point(&p, (n3_real)3 / 8, (n3_real)1 / 4), 40 * EPS * reach(p.p, 10), i);
    }
}

static void raised_is_the_same(void)
{
    static const int power[15][2] = {{0, 0}, {4, 0}, {0, 4}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 2},
                                     {1, 3}, {0, 3}, {0, 2}, {0, 1}, {1, 1}, {2, 1}, {1, 2}};
    static const double factorial[5] = {1, 1, 2, 6, 24};
    rng r = {37};
    long i, count = sample_count(1000);
    for (i = 0; i < count; i++) {
        n3_patch p = patch_of(i, &r);
        n3_vec net[15];
        dvec sum = d_v(0, 0, 0);
        n3_real u, v;
        int k;
        inner_weights(&r, &u, &v);
        n3_patch_raise(&p, net);
        for (k = 0; k < 15; k++) {
            int a = power[k][0], b = power[k][1], c = 4 - a - b;
            double weight = 24 / factorial[a] / factorial[b] / factorial[c];
            weight *= pow((double)u, a) * pow((double)v, b) * pow(1 - (double)u - (double)v, c);
            sum = d_add(sum, d_mul(weight, wide(net[k])));
        }
        CHECK_VEC(n3_patch_point(&p, u, v), narrow(sum), 32 * EPS * reach(p.p, 10), i);
    }
}

/* ---- Curvature ---- */

/* Gauss and mean by the textbook formulas, the principal directions by what they are: at right
   angles in space and conjugate. Where the patch is smooth; K is the largest curvature. */
static void check_curvature(const n3_patch *p, n3_real u, n3_real v, long row)
{
    n3_curvature c = n3_patch_curvature(p, u, v);
    n3_jet j = n3_patch_jet(p, u, v);
    dvec n = d_cross(wide(j.du), wide(j.dv));
    double E = d_dot(wide(j.du), wide(j.du)), F = d_dot(wide(j.du), wide(j.dv));
    double G = d_dot(wide(j.dv), wide(j.dv)), A = sqrt(E * G - F * F), L, M, N, K, tol;
    n = d_mul(1 / d_len(n), n);
    L = d_dot(n, wide(j.duu)), M = d_dot(n, wide(j.duv)), N = d_dot(n, wide(j.dvv));
    K = (fabs(E * N) + fabs(G * L) + 2 * fabs(F * M)) / A / A;
    tol = 256 * EPS * (E + G) / A * (1 + (E + G) / A) * K;
    CHECK_NEAR(c.mean, (E * N - 2 * F * M + G * L) / 2 / A / A, tol, row);
    CHECK_NEAR(c.gauss, (L * N - M * M) / A / A, tol * K, row);
    CHECK_NEAR(c.k[0] + c.k[1], 2 * (double)c.mean, tol, row);
    CHECK_NEAR(c.k[0] * c.k[1], c.gauss, tol * K, row);
    CHECK(c.k[0] >= c.k[1], row);
    CHECK_NEAR(c.E, E, 8 * EPS * E, row);
    CHECK_NEAR(c.G, G, 8 * EPS * G, row);
    CHECK_NEAR(n3_dot(c.t[0], c.t[1]), 0, 8 * EPS, row);
    CHECK_VEC(n3_cross(c.t[0], c.t[1]), c.normal, 16 * EPS, row);
}

static void curvature_by_the_book(void)
{
    rng r = {38};
    long i, count = sample_count(2000), sound = 0;
    for (i = 0; i < count; i++) {
        n3_patch p = random_net(&r);
        n3_real u, v;
        n3_jet j;
        double sine;
        inner_weights(&r, &u, &v);
        j = n3_patch_jet(&p, u, v);
        sine = (double)n3_len(n3_cross(n3_unit(j.du), n3_unit(j.dv)));
        if (sine < 0.1) continue;
        sound++;
        check_curvature(&p, u, v, i);
    }
    CHECK(sound > count / 2, sound);
}

/* x = u + s v, y = v, z = (k x^2 + l y^2) / 2 and turned by a third of a turn: k and l where it is
   flat, to the rounding of the net, and the directions where they differ. */
static void curvature_of_a_saddle(void)
{
    static const int at[10][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0},
                                  {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    static const double k[4][2] = {{2, -3}, {5, 1}, {-1, -1}, {4, 0}};
    const double s = 0.7;
    int row, i;
    for (row = 0; row < 4; row++) {
        n3_patch p;
        n3_curvature c;
        for (i = 0; i < 10; i++) {
            int a = at[i][0], b = at[i][1]; /* polar forms of u^2, u v and v^2 at these */
            double uu = a * (a - 1) / 6.0, uv = a * b / 6.0, vv = b * (b - 1) / 6.0;
            double xx = uu + 2 * s * uv + s * s * vv;
            dvec x = d_v((a + s * b) / 3, b / 3.0, (k[row][0] * xx + k[row][1] * vv) / 2);
            p.p[i] = n3_v((n3_real)x.z, (n3_real)x.x, (n3_real)x.y);
        }
        c = n3_patch_curvature(&p, 0, 0);
        CHECK_NEAR(c.k[0], k[row][0], 64 * EPS, row);
        CHECK_NEAR(c.k[1], k[row][1], 64 * EPS, row);
        CHECK_VEC(c.normal, n3_v(1, 0, 0), 8 * EPS, row);
        CHECK_NEAR(fabs((double)c.t[0].y), 1, 64 * EPS, row);
        CHECK_NEAR(fabs((double)c.t[1].z), 1, 64 * EPS, row);
    }
}

/* The largest error of the principal curvatures against the torus of radii 2 and 1, or where the
   ring is 0 the sphere, over patches of size h. */
static double curvature_error(double ring, double h)
{
    const n3_options arc = {N3_RULE_ARC, 0, 0};
    double worst = 0;
    n3_vertex c[3];
    n3_patch p;
    int i, k;
    for (i = 0; i < 3; i++) {
        double a = 0.3 + h * (i == 1), b = 0.5 + h * (i == 2), d = ring + cos(b);
        c[i].n = n3_v((n3_real)(cos(b) * cos(a)), (n3_real)(cos(b) * sin(a)), (n3_real)sin(b));
        c[i].x = n3_v((n3_real)(d * cos(a)), (n3_real)(d * sin(a)), (n3_real)sin(b));
    }
    p = n3_patch_make(c[0], c[1], c[2], &arc);
    for (i = 0; i <= 4; i++)
        for (k = 0; i + k <= 4; k++) {
            n3_curvature got = n3_patch_curvature(&p, (n3_real)i / 4, (n3_real)k / 4);
            double x = hypot((double)got.normal.x, (double)got.normal.y);
            double want = -x / (ring + x);
            worst = fmax(worst, fabs((double)got.k[0] - (ring > 0 ? want : -1)));
            worst = fmax(worst, fabs((double)got.k[1] + 1));
        }
    return worst;
}

/* Arcs of sixth order leave the curvatures of a sphere the fourth order; a torus, whose patch is of
   third order at the least, the first. In float rounding is seen at once. */
static void curvature_orders(void)
{
    const double h = sizeof(n3_real) == 4 ? 0.5 : 0.1;
    double sphere = curvature_error(0, h) / curvature_error(0, h / 2);
    double torus = curvature_error(2, h) / curvature_error(2, h / 2);
    CHECK(sphere > 12, (long)sphere);
    CHECK(torus > 1.6, (long)(10 * torus));
}

/* Collapsed: no direction, no curvature, all finite; scaled by 2^k: curvatures by 2^-k. */
static void curvature_of_the_degenerate(void)
{
    rng r = {39};
    long i, count = sample_count(500);
    const int most = sizeof(n3_real) == 4 ? 50 : 480;
    for (i = 0; i < count; i++) {
        n3_patch p = random_net(&r), q = p;
        n3_curvature c, d;
        int k, e = (int)(i % 2 ? most : -most);
        for (k = 0; k < 10; k++) q.p[k] = scale_vec(p.p[k], e);
        c = n3_patch_curvature(&p, (n3_real)1 / 4, (n3_real)1 / 4);
        d = n3_patch_curvature(&q, (n3_real)1 / 4, (n3_real)1 / 4);
        CHECK_VEC(n3_mul(c.k[0], c.t[0]), scale_vec(n3_mul(d.k[0], d.t[0]), e), 0, i);
        p.p[1] = p.p[3] = p.p[4] = p.p[0]; /* the side ab */
        c = n3_patch_curvature(&p, 0, 0);
        CHECK(same_vec(c.t[0], n3_v(0, 0, 0)) && same_real(c.k[0], 0), i);
        CHECK_NEAR(n3_len(c.normal), 1, 4 * EPS, i);
        for (k = 0; k < 10; k++) p.p[k] = p.p[2];
        c = n3_patch_curvature(&p, (n3_real)1 / 4, (n3_real)1 / 4);
        CHECK(same_vec(c.normal, n3_v(0, 0, 0)) && same_real(c.gauss, 0), i);
    }
}

/* ---- The nearest point ---- */

enum { CLOSE, OFF, FAR_OFF, ON_IT, MEDIAL, WAYS };

/* A place to ask from: off the surface by its size or much more, on it, near it, or in the centre
   of its curvature at a point. */
static n3_vec ask_from(const n3_patch *p, int way, rng *r)
{
    double size = extent(p);
    n3_real u, v, by;
    n3_vec x, n;
    inner_weights(r, &u, &v);
    x = n3_patch_point(p, u, v);
    n = n3_patch_normal(p, u, v);
    by = (n3_real)(rng_uniform(r, -0.2, 0.2) * size);
    if (way == CLOSE) return n3_add(x, n3_mul(by, n));
    if (way == MEDIAL) {
        double k = (double)n3_patch_curvature(p, u, v).k[(int)(rng_next(r) >> 63)];
        if (fabs(k) * size > 0.01) return n3_add(x, n3_mul((n3_real)(1 / k), n));
    }
    if (way == ON_IT) return x;
    return n3_add(x, n3_mul((n3_real)(size * (way == FAR_OFF ? 1e5 : 2)), rng_vec(r)));
}

/* The least squared distance on a lattice, and then around the best place on ever finer ones. */
static double brute_force(const n3_patch *p, n3_vec q)
{
    enum { N = 20 };
    double best = HUGE_VAL, bu = 0, bv = 0, step = 1.0 / N;
    int i, k, round;
    for (round = 0; round < 9; round++, step /= 4) {
        int from = round ? -4 : 0, to = round ? 4 : N;
        double cu = bu, cv = bv;
        for (i = from; i <= to; i++)
            for (k = from; k <= to; k++) {
                double u = cu + i * step, v = cv + k * step;
                n3_vec d;
                if (u < 0 || v < 0 || u + v > 1) continue;
                d = n3_sub(n3_patch_point(p, (n3_real)u, (n3_real)v), q);
                if ((double)n3_dot(d, d) >= best) continue;
                best = (double)n3_dot(d, d), bu = u, bv = v;
            }
    }
    return best;
}

/* Nothing that brute force finds is nearer, but for 32 eps of the square of the largest distance,
   and for the rounding of the points themselves. */
static void nearest_is_nearest(void)
{
    rng r = {40};
    long i, count = sample_count(400);
    for (i = 0; i < count; i++) {
        n3_patch p = patch_of(i, &r);
        int way = (int)(i / 40 % WAYS), k;
        n3_vec q = ask_from(&p, way, &r), d[10];
        n3_foot foot = n3_patch_nearest(&p, q);
        double most, ulp, length = sqrt((double)foot.distance2);
        for (k = 0; k < 10; k++) d[k] = n3_sub(p.p[k], q);
        most = reach(d, 10), ulp = 16 * EPS * (reach(p.p, 10) + reach(&q, 1));
        CHECK((double)foot.distance2 <=
                  brute_force(&p, q) + 32 * EPS * 3 * most * most + ulp * (length + ulp),
              i);
        CHECK_SAME(foot.x, n3_patch_point(&p, foot.u, foot.v), i);
        CHECK(foot.u >= 0 && foot.v >= 0 && foot.u + foot.v <= 1 + 4 * N3_EPS, i);
        CHECK_NEAR(foot.distance2, n3_dot(n3_sub(foot.x, q), n3_sub(foot.x, q)), 0, i);
    }
}

/* A point of a patch that does not come near itself again finds itself: u and v to the error of the
   point over the smallest stretch, and the side is that of a step along the normal. */
static void points_find_themselves(void)
{
    rng r = {41};
    long i, count = sample_count(1000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i * KINDS); /* benign ones */
        n3_patch p = n3_patch_make(s.v[0], s.v[1], s.v[2], NULL);
        n3_real u, v, by;
        n3_vec x, n;
        n3_jet j;
        n3_foot foot;
        double size = extent(&p), stretch, error;
        int up = i % 2 ? 1 : -1;
        inner_weights(&r, &u, &v);
        x = n3_patch_point(&p, u, v);
        j = n3_patch_jet(&p, u, v);
        n = n3_patch_normal(&p, u, v);
        stretch = (double)n3_len(n3_cross(j.du, j.dv)) / (double)(n3_len(j.du) + n3_len(j.dv));
        if (n3_patch_may_fold(&p) || stretch < 0.1 * size) continue;
        error = 64 * EPS * reach(p.p, 10) / stretch;
        foot = n3_patch_nearest(&p, x);
        CHECK_NEAR(foot.u, u, error, i);
        CHECK_NEAR(foot.v, v, error, i);
        by = (n3_real)(size / 1000);
        foot = n3_patch_nearest(&p, n3_add(x, n3_mul((n3_real)up * by, n)));
        if (foot.u > by && foot.v > by && foot.u + foot.v < 1 - by) CHECK(foot.side == up, i);
    }
}

/* Two patches of an edge, from points that are nearer to it than to the rest of either, also when
   they are over an end: feet in the same place are the same bits. */
static void feet_on_shared_edges(void)
{
    rng r = {42};
    long i, count = sample_count(2000), shared = 0;
    shape s = shape_icosphere(0);
    built b = build(&s, N3_RULE_PAPER, -1);
    for (i = 0; i < count; i++) {
        int edge = (int)(rng_next(&r) % (uint64_t)b.t.edges), k;
        n3_edge e = built_edge(&b, edge), back = n3_edge_reverse(&e);
        n3_real t = i % 5 ? (n3_real)rng_uniform(&r, 0, 1) : i % 2 ? 0 : 1;
        n3_vec q = n3_mul((n3_real)rng_uniform(&r, 0.5, 3), n3_edge_point(&e, t)), x;
        n3_foot foot[2];
        if (i % 3 && i % 5) q = n3_add(q, n3_mul(N3_EPS * (n3_real)(i % 100), rng_vec(&r)));
        t = edge_nearest(&e, q);
        x = n3_edge_point(&e, t);
        CHECK(same_real(edge_nearest(&back, q), 1 - t), i);
        for (k = 0; k < 2; k++) {
            n3_patch p = built_patch(&b, b.t.side[b.t.first[edge] + k] / 3);
            foot[k] = n3_patch_nearest(&p, q);
            if (!(foot[k].u > 0 && foot[k].v > 0 && 1 - foot[k].u - foot[k].v > 0) &&
                n3_len(n3_sub(foot[k].x, x)) < 100 * N3_EPS) {
                CHECK_SAME(foot[k].x, x, i);
                shared++;
            }
        }
    }
    CHECK(shared > count, shared);
    built_free(&b);
    shape_free(&s);
}

/* On a curve: no nearer point among many. */
static void nearest_on_an_edge(void)
{
    rng r = {43};
    long i, count = sample_count(2000);
    for (i = 0; i < count; i++) {
        n3_edge e;
        n3_vec q = rng_vec(&r), d;
        double best;
        int k;
        for (k = 0; k < 4; k++) e.p[k] = rng_vec(&r);
        if (i % 5 == 0) e.p[3] = e.p[0];
        if (i % 7 == 0) e.p[1] = e.p[2] = e.p[0];
        d = n3_sub(n3_edge_point(&e, n3_edge_nearest(&e, q)), q);
        best = (double)n3_dot(d, d);
        for (k = 0; k <= 64; k++) {
            d = n3_sub(n3_edge_point(&e, (n3_real)k / 64), q);
            CHECK(best <= (double)n3_dot(d, d) + 32 * EPS * 12, i);
        }
    }
}

/* Powers of two change nothing, at either end of the range; NaN and infinity give NaN. */
static void nearest_scaled_or_broken(void)
{
    const int most = sizeof(n3_real) == 4 ? 55 : 490;
    rng r = {44};
    long i, count = sample_count(200);
    for (i = 0; i < count; i++) {
        n3_patch p = patch_of(4 * i + 3, &r), q = p;
        n3_vec x = rng_vec(&r), bad = n3_v(0, i % 2 ? (n3_real)NAN : (n3_real)HUGE_VAL, 0);
        n3_foot a = n3_patch_nearest(&p, x), b;
        int k, e = (int)(i % 2 ? most : -most);
        for (k = 0; k < 10; k++) q.p[k] = scale_vec(p.p[k], e);
        b = n3_patch_nearest(&q, scale_vec(x, e));
        CHECK(same_real(a.u, b.u) && same_real(a.v, b.v) && a.side == b.side, i);
        CHECK_SAME(b.x, scale_vec(a.x, e), i);
        b = n3_patch_nearest(&p, bad);
        CHECK(isnan(b.u) && isnan(b.v) && isnan(b.distance2) && is_nan_vec(b.x) && !b.side, i);
        p.p[i % 10] = bad;
        b = n3_patch_nearest(&p, x);
        CHECK(isnan(b.u) && isnan(b.distance2) && !b.side, i);
        for (k = 0; k < 10; k++) q.p[k] = x;
        b = n3_patch_nearest(&q, x);
        CHECK_VEC(b.x, x, 4 * EPS, i);
        CHECK(b.side == 0, i);
    }
}

/* ---- Folds ---- */

/* Seen along z, z < 0 too, the determinant of the Jacobian is 9 sum det[5 i + j] u^i v^j w^k over
   i + j + k = 4, in units of the largest coordinate; its terms are below 16, and there are 36. */
static void net_of_the_determinant(void)
{
    rng r = {49};
    long q, count = sample_count(1000);
    for (q = 0; q < count; q++) {
        n3_patch p = random_net(&r);
        n3i_cell c;
        n3_real det[25], u, v, z = q % 2 ? 1 : -3, sum = 0, size, largest;
        n3_jet jet;
        int i, j, k;
        size = n3i_look_along(&p, p.p[9], n3_v(0, 0, z), 2, &c);
        largest = n3i_jacobian(&c, 1 / size, det);
        inner_weights(&r, &u, &v);
        jet = n3_patch_jet(&p, u, v);
        for (i = 0; i < 5; i++)
            for (j = 0; i + j < 5; j++) {
                n3_real weight = 9 * size * size;
                for (k = 0; k < 4; k++) weight *= k < i ? u : k < i + j ? v : 1 - u - v;
                sum += weight * det[5 * i + j];
                CHECK(fabs((double)det[5 * i + j]) <= 16 * (double)largest, q);
            }
        CHECK_NEAR(sum, n3_cross(jet.du, jet.dv).z, 9 * 36 * 16 * EPS, q);
    }
}

/* A definite answer agrees with a lattice of normals; more parts decide what fewer do not. */
static void folds_along_directions(void)
{
    rng r = {45};
    long i, count = sample_count(1000), said[3] = {0, 0, 0};
    for (i = 0; i < count; i++) {
        n3_patch p = i % 3 ? random_net(&r) : patch_of(i / 3 * KINDS * 4, &r);
        n3_vec d = i % 2 ? rng_unit(&r) : n3_patch_normal(&p, (n3_real)1 / 3, (n3_real)1 / 3);
        int a, b, few = n3_patch_folds(&p, d, 4), many = n3_patch_folds(&p, d, 400);
        said[many]++;
        CHECK(few == N3_UNDECIDED || few == many, i);
        if (many != N3_NO) continue;
        for (a = 0; a <= 8; a++)
            for (b = 0; a + b <= 8; b++) {
                n3_jet j = n3_patch_jet(&p, (n3_real)a / 8, (n3_real)b / 8);
                CHECK(n3_dot(n3_cross(j.du, j.dv), d) > 0, i);
            }
    }
    CHECK(said[N3_NO] > count / 10 && said[N3_YES] > count / 10, said[N3_NO]);
    CHECK(said[N3_UNDECIDED] < 1 + count / 100, said[N3_UNDECIDED]);
}

/* ---- Sums ---- */

/* The volume of the cone and its moment do not change when the patch is cut, to rounding: 36 terms
   and four parts of them. From one end of a closed mesh as from another: the same volume and the
   same place of the centroid. */
static void volumes_add_up(void)
{
    rng r = {46};
    long i, count = sample_count(200);
    for (i = 0; i < count; i++) {
        n3_patch p = random_net(&r), part[4];
        n3_vec from = rng_vec(&r), moment, sum = n3_v(0, 0, 0), m;
        double volume = (double)n3_patch_volume(&p, from, &moment), parts = 0;
        int k;
        n3_patch_split4(&p, part);
        for (k = 0; k < 4; k++) {
            parts += (double)n3_patch_volume(&part[k], from, &m);
            sum = n3_add(sum, m);
        }
        CHECK_NEAR(parts, volume, 1000 * EPS, i);
        CHECK_VEC(sum, moment, 1000 * EPS, i);
        CHECK_NEAR(n3_patch_volume(&p, from, NULL), volume, 0, i);
    }
}

/* The sphere: 20 patches of the arc rule lie within 1e-3 of it. The cube's are flat, and exact.
   Both have their centroid where the mean of their points is. */
static void volumes_of_bodies(void)
{
    static const double want[2] = {4 * PI / 3, 1}, area[2] = {4 * PI, 6}, tol[2] = {0.013, 0};
    int row, f;
    for (row = 0; row < 2; row++) {
        shape s = row ? shape_cube() : shape_icosphere(0);
        built b = build(&s, N3_RULE_ARC, 0.5);
        n3_vec from = n3_v(2, -3, 1), moment = n3_v(0, 0, 0), mean = moment, m;
        double volume = 0, surface = 0;
        for (f = 0; f < s.points; f++)
            mean = n3_add(mean, n3_mul((n3_real)1 / (n3_real)s.points, s.point[f]));
        for (f = 0; f < b.m.triangles; f++) {
            n3_patch p = built_patch(&b, f);
            volume += (double)n3_patch_volume(&p, from, &m);
            surface += (double)n3_patch_area(&p, (n3_real)1e-5, NULL);
            moment = n3_add(moment, m);
        }
        CHECK_NEAR(volume, want[row], tol[row] + 4000 * EPS, row);
        CHECK_NEAR(surface, area[row], tol[row] + 1e-5 * area[row], row);
        CHECK_VEC(n3_add(from, n3_mul((n3_real)(1 / volume), moment)), mean, 4000 * EPS, row);
        built_free(&b);
        shape_free(&s);
    }
}

/* In its plane a patch that does not fold has the area inside its sides, which is that of the cone
   over it from one unit below, times three; and the centroid is that of this volume. */
static void areas_in_a_plane(void)
{
    rng r = {47};
    long i, count = 1 + sample_count(6000) / 100, sound = 0;
    for (i = 0; i < count; i++) {
        n3_patch p;
        n3_vec below = n3_v(0, 0, -1), centroid, moment;
        double area, volume;
        int k;
        for (k = 0; k < 10; k++) {
            static const int at[10][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0},
                                          {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
            n3_vec shake = n3_mul((n3_real)0.4, rng_vec(&r));
            p.p[k] = n3_v((n3_real)at[k][0] + shake.x, (n3_real)at[k][1] + shake.y, 0);
        }
        if (n3_patch_folds(&p, n3_v(0, 0, 1), 50) != N3_NO) continue;
        sound++;
        volume = (double)n3_patch_volume(&p, below, &moment);
        area = (double)n3_patch_area(&p, 0, &centroid);
        CHECK_NEAR(area, 3 * volume, 500 * EPS, i);
        moment = n3_mul((n3_real)(4 / (3 * volume)), moment);
        CHECK_VEC(centroid, n3_add(below, moment), 500 * EPS, i);
    }
    CHECK(sound > count / 3, sound);
}

/* To the tolerance that is asked for, also where a side is collapsed; parts add up. A point has no
   area and is its own centroid. */
static void areas_to_a_tolerance(void)
{
    rng r = {48};
    long i, count = 1 + sample_count(1500) / 100;
    for (i = 0; i < count; i++) {
        n3_patch p = random_net(&r), part[3];
        double exact, parts = 0, tol = sizeof(n3_real) == 4 ? 1e-4 : 1e-6;
        n3_vec centroid, x = p.p[2];
        int k;
        if (i % 2) p.p[1] = p.p[3] = p.p[4] = p.p[0];
        exact = (double)n3_patch_area(&p, (n3_real)(tol / 10), NULL);
        CHECK_NEAR(n3_patch_area(&p, (n3_real)tol, NULL), exact, 1.1 * tol * exact, i);
        CHECK_NEAR(n3_patch_area(&p, (n3_real)0.01, &centroid), exact, 0.0102 * exact, i);
        CHECK(is_finite_vec(centroid), i);
        n3_patch_split(&p, (n3_real)0.2, (n3_real)0.5, part);
        for (k = 0; k < 3; k++) parts += (double)n3_patch_area(&part[k], (n3_real)tol, NULL);
        CHECK_NEAR(parts, exact, 1.1 * tol * exact, i);
        for (k = 0; k < 10; k++) p.p[k] = x;
        CHECK_NEAR(n3_patch_area(&p, 0, &centroid), 0, 0, i);
        CHECK_VEC(centroid, x, 0, i);
    }
}

/* The parabola (t, t^2), t from 0 to 2: sqrt(17) + asinh(4) / 4; a cusp, (3 t - t^3, 2 t^2...) in
   closed form: (t^2, t^3) from 0 to 1 is (13 sqrt(13) - 8) / 27 long. */
static void lengths_in_closed_form(void)
{
    static const struct {
        double p[4][2], want;
    } curve[] = {{{{0, 0}, {2.0 / 3, 0}, {4.0 / 3, 4.0 / 3}, {2, 4}}, 4.646783762432936},
                 {{{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}}, 1.43970987337155},
                 {{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 3},
                 {{{0, 0}, {0, 0}, {0, 0}, {0, 0}}, 0}};
    size_t i;
    for (i = 0; i < sizeof curve / sizeof *curve; i++) {
        n3_edge e;
        int k;
        for (k = 0; k < 4; k++)
            e.p[k] = n3_v((n3_real)curve[i].p[k][0], 0, (n3_real)curve[i].p[k][1]);
        CHECK_NEAR(n3_edge_length(&e, 0), curve[i].want, 64 * EPS * 4, (long)i);
        CHECK_NEAR(n3_edge_length(&e, (n3_real)1e-3), curve[i].want, 1e-3 * curve[i].want, (long)i);
    }
}

/* From the middle of a sphere, to which a patch is as near everywhere as it can be: all of it is
   nearest, but for the error of the arc rule, which falls with the sixth power of the size. */
static void nearest_of_equals(void)
{
    static const double size[] = {1, 0.5, 0.2, 0.1, 0.05};
    const n3_options arc = {N3_RULE_ARC, 0, 0};
    int i, k, j;
    for (i = 0; i < 5; i++) {
        n3_vertex v[3];
        n3_patch p;
        n3_foot foot;
        double least = 4;
        for (k = 0; k < 3; k++) {
            n3_real s = (n3_real)size[i], one = 1;
            v[k].x = n3_unit(n3_v(k == 0 ? one : one - s, k == 1 ? one : one - s,
                                  k == 2 ? one : one - s));
            v[k].n = v[k].x;
        }
        p = n3_patch_make(v[0], v[1], v[2], &arc);
        foot = n3_patch_nearest(&p, n3_v(0, 0, 0));
        for (j = 0; j <= 60; j++)
            for (k = 0; k <= 60 - j; k++) {
                n3_vec x = n3_patch_point(&p, (n3_real)k / 60, (n3_real)j / 60);
                double d = (double)n3_dot(x, x);
                least = d < least ? d : least;
            }
        CHECK((double)foot.distance2 <= least + 64 * EPS, i);
        CHECK_NEAR(foot.distance2, n3_dot(foot.x, foot.x), 8 * EPS, i);
    }
}

/* Nets on a line, which the patch leaves and comes back to: all points of a curve in the domain are
   nearest, too long a curve to be settled part by part. The first in double, the second in float;
   in the third the curve rises and falls by 1e-9, so that in double it matters which of the parts
   that are left holds the nearest: the maximum of y along x = q.x, at u = 0.9111437878369577 on ab,
   found by bisection. */
static void nearest_on_a_line(void)
{
    static const struct {
        double x[10], y[10], q[3], distance2;
    } rows[] = {{{1, 2, -1.5, 1.5, -.5, -2, -1, 2, .5, 1}, {0}, {.75, 1, .5}, 1.25},
                {{0, .5, -1, 2, 2, 0, 2, 0, .5, 1}, {0}, {.5, .5, .5}, .5},
                {{1.288, -.934, -.348, -.352, 1.788, 1.738, -.962, 1.532, 1.792, -.544},
                 {1e-9, 1e-9, -1e-9, -1e-9, 1e-9, -1e-9, -1e-9, 0, -1e-9, 0},
                 {-.3175, .957, 0},
                 0.9158489981686142}};
    int i, k;
    for (i = 0; i < 3; i++) {
        const double *q = rows[i].q;
        n3_patch p;
        n3_foot foot;
        for (k = 0; k < 10; k++) p.p[k] = n3_v((n3_real)rows[i].x[k], (n3_real)rows[i].y[k], 0);
        foot = n3_patch_nearest(&p, n3_v((n3_real)q[0], (n3_real)q[1], (n3_real)q[2]));
        CHECK_NEAR(foot.distance2, rows[i].distance2, 32 * EPS * 10, i);
    }
}

const test_case tests_query[] = {{"boxes_hold_and_fit", boxes_hold_and_fit},
                                 {"tight_boxes_of_hills", tight_boxes_of_hills},
                                 {"flatness_is_a_bound", flatness_is_a_bound},
                                 {"parts_are_parts", parts_are_parts},
                                 {"corners_in_another_order", corners_in_another_order},
                                 {"splits_share_sides", splits_share_sides},
                                 {"quarters_share_sides", quarters_share_sides},
                                 {"raised_is_the_same", raised_is_the_same},
                                 {"curvature_by_the_book", curvature_by_the_book},
                                 {"curvature_of_a_saddle", curvature_of_a_saddle},
                                 {"curvature_orders", curvature_orders},
                                 {"curvature_of_the_degenerate", curvature_of_the_degenerate},
                                 {"nearest_is_nearest", nearest_is_nearest},
                                 {"points_find_themselves", points_find_themselves},
                                 {"nearest_of_equals", nearest_of_equals},
                                 {"nearest_on_a_line", nearest_on_a_line},
                                 {"feet_on_shared_edges", feet_on_shared_edges},
                                 {"nearest_on_an_edge", nearest_on_an_edge},
                                 {"nearest_scaled_or_broken", nearest_scaled_or_broken},
                                 {"net_of_the_determinant", net_of_the_determinant},
                                 {"folds_along_directions", folds_along_directions},
                                 {"volumes_add_up", volumes_add_up},
                                 {"volumes_of_bodies", volumes_of_bodies},
                                 {"areas_in_a_plane", areas_in_a_plane},
                                 {"areas_to_a_tolerance", areas_to_a_tolerance},
                                 {"lengths_in_closed_form", lengths_in_closed_form},
                                 {NULL, NULL}};
