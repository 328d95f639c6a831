/* quad.c: quads with normals. */
#include "brown_test.h"

enum { SAMPLES = 500 };

/* A vertex of the surface z = x^2/4 - x y/3 + x^3/6 - y^2/5 + 2, its normal upwards. */
static n3_vertex on_surface(n3_real x, n3_real y)
{
    double a = (double)x, b = (double)y, z = a * a / 4 - a * b / 3 + a * a * a / 6 - b * b / 5 + 2;
    dvec n = d_unit(d_v(-(a / 2 - b / 3 + a * a / 2), a / 3 + 2 * b / 5, 1));
    n3_vertex v;
    v.x = narrow(d_v(a, b, z));
    v.n = narrow(n);
    return v;
}

/* Two rows of three of them: the quads 0 1 4 3 and 1 2 5 4 share the edge 1 4. */
static void draw_two(rng *r, n3_vertex v[6])
{
    int i;
    for (i = 0; i < 6; i++) {
        n3_vec toss = n3_mul((n3_real)1 / 4, rng_vec(r));
        v[i] = on_surface((n3_real)(i % 3) - 1 + toss.x, (n3_real)(i / 3) + toss.y);
    }
}

static void quad_of(const n3_vertex v[6], int at, n3_vertex corner[4])
{
    corner[0] = v[at];
    corner[1] = v[at + 1];
    corner[2] = v[at + 4];
    corner[3] = v[at + 3];
}

/* The first of them. */
static brown_square draw_one(rng *r, n3_vertex corner[4])
{
    n3_vertex v[6];
    draw_two(r, v);
    quad_of(v, 0, corner);
    return brown_quad_make(corner, NULL);
}

static brown_square fitted(const n3_vertex v[6], int at, const n3_options *o)
{
    n3_vertex corner[4], c[2], d[2];
    n3_edge edge[4];
    n3_vec mid[4];
    int i;
    quad_of(v, at, corner);
    memset(mid, 0, sizeof mid);
    c[0] = v[3], c[1] = v[0], d[0] = v[2], d[1] = v[5];
    mid[at ? 3 : 1] = brown_mid_normal(v[1], v[4], c, d);
    for (i = 0; i < 4; i++) edge[i] = n3_edge_make(corner[i], corner[(i + 1) % 4], o);
    return brown_quad_from_edges(corner, edge, mid, o);
}

/* The goal is 1e-9; what is left is rounding: a cross tangent has some 30 eps of the size, 3, over
 * its length, which is at least 1/4, the normals' product twice that. */
static void normals_do_not_jump(void)
{
    rng r = {21};
    long n, count = sample_count(SAMPLES);
    n3_options o = {0, 0, 0};
    for (n = 0; n < count; n++) {
        n3_vertex v[6], corner[4];
        brown_square s[2];
        int i;
        o.rule = (int)(n / 2 % 2);
        draw_two(&r, v);
        for (i = 0; i < 2; i++) {
            quad_of(v, i, corner);
            s[i] = n % 2 ? fitted(v, i, &o) : brown_quad_make(corner, &o);
        }
        for (i = 0; i <= 16; i++) {
            n3_real t = (n3_real)i / 16;
            CHECK_SAME(brown_point(&s[0], 1, t), brown_point(&s[1], 0, t), n);
            CHECK_VEC(brown_normal(&s[0], 1, t), brown_normal(&s[1], 0, t), 720 * EPS, n);
        }
    }
}

/* Sides are the library's edges, bit for bit, and corners have the vertices' normals. */
static void sides_are_edges(void)
{
    rng r = {22};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        n3_vertex corner[4];
        brown_square s;
        n3_edge e[4];
        int i;
        n3_real t = dyadic(&r, 0, 1);
        s = draw_one(&r, corner);
        for (i = 0; i < 4; i++) e[i] = n3_edge_make(corner[i], corner[(i + 1) % 4], NULL);
        CHECK_SAME(brown_point(&s, t, 0), n3_edge_point(&e[0], t), n);
        CHECK_SAME(brown_point(&s, 1, t), n3_edge_point(&e[1], t), n);
        CHECK_SAME(brown_point(&s, t, 1), n3_edge_point(&e[2], 1 - t), n);
        CHECK_SAME(brown_point(&s, 0, t), n3_edge_point(&e[3], 1 - t), n);
        for (i = 0; i < 4; i++)
            CHECK_VEC(brown_normal(&s, (n3_real)(i == 1 || i == 2), (n3_real)(i > 1)), corner[i].n,
                      720 * EPS, n);
    }
}

/* Normals all across a plane: the plane. */
static void flat(void)
{
    rng r = {23};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        n3_vertex v[4];
        brown_square s;
        int i;
        n3_real u = (n3_real)rng_uniform(&r, 0, 1), w = (n3_real)rng_uniform(&r, 0, 1);
        for (i = 0; i < 4; i++) {
            n3_vec toss = n3_mul((n3_real)1 / 4, rng_vec(&r));
            v[i].x = n3_v((n3_real)(i == 1 || i == 2) + toss.x, (n3_real)(i / 2) + toss.y, 3);
            v[i].n = n3_v(0, 0, 1);
        }
        s = brown_quad_make(v, NULL);
        CHECK_NEAR(brown_point(&s, u, w).z, 3, 16 * EPS, n);
        CHECK_VEC(brown_normal(&s, u, w), v[0].n, 32 * EPS, n);
    }
}

/* A scale of a power of two changes no bit but the exponent's, a turn by right angles none. */
static void scaled(void)
{
    rng r = {24};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        n3_vertex v[6], corner[4], big[4];
        brown_square (*volatile make)(const n3_vertex *, const n3_options *) = brown_quad_make;
        n3_jet (*volatile jet)(const brown_square *, n3_real, n3_real) = brown_jet;
        brown_square s, t;
        n3_real u = dyadic(&r, 0, 1), w = dyadic(&r, 0, 1);
        n3_jet a, b;
        int i, exponent = (int)(rng_next(&r) % 41) - 20;
        draw_two(&r, v);
        quad_of(v, 0, corner);
        for (i = 0; i < 4; i++) big[i] = scale_vertex(corner[i], exponent);
        s = make(corner, NULL);
        t = make(big, NULL);
        a = jet(&s, u, w);
        b = jet(&t, u, w);
        CHECK_SAME(b.x, scale_vec(a.x, exponent), n);
        CHECK_SAME(b.du, scale_vec(a.du, exponent), n);
        CHECK_SAME(b.dvv, scale_vec(a.dvv, exponent), n);
        CHECK_SAME(brown_normal(&t, u, w), brown_normal(&s, u, w), n);
    }
}

/* The paper's rule takes normals that look to either side: the same edges, and tangents that differ
 * by roundings, of which the longest chain has 30. */
static void either_side(void)
{
    rng r = {26};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        n3_vertex corner[4];
        brown_square s, t;
        n3_real u = dyadic(&r, 0, 1), w = dyadic(&r, 0, 1);
        int flipped = (int)(n % 4);
        s = draw_one(&r, corner);
        corner[flipped].n = n3_mul(-1, corner[flipped].n);
        t = brown_quad_make(corner, NULL);
        CHECK_VEC(brown_point(&t, u, w), brown_point(&s, u, w), 3 * 30 * EPS, n);
        CHECK_SAME(brown_point(&t, u, 0), brown_point(&s, u, 0), n);
    }
}

/* Whatever comes in, finite answers come out, and normals are unit or zero. */
static void degenerate(void)
{
    long n, count = sample_count(SAMPLES * KINDS / 2);
    for (n = 0; n < count; n++) {
        sample a = sample_make(n);
        n3_vertex v[4];
        n3_options o = {0, 0, 0};
        brown_square s;
        int i, j, fourth = (int)(rng_next(&a.r) % 3);
        for (i = 0; i < 3; i++) v[i] = a.v[i];
        v[3] = a.v[fourth];
        if (n % 4) v[3].x = n3_add(a.v[0].x, n3_sub(a.v[2].x, a.v[1].x));
        if (n % 5 == 0) v[n % 4].n = n3_v(0, 0, 0);
        o.rule = (int)(n % 2);
        s = brown_quad_make(v, &o);
        for (j = 0; j <= 4; j++)
            for (i = 0; i <= 4; i++) {
                n3_jet p = brown_jet(&s, (n3_real)i / 4, (n3_real)j / 4);
                n3_real length = n3_len(brown_normal(&s, (n3_real)i / 4, (n3_real)j / 4));
                CHECK(is_finite_vec(p.x) && is_finite_vec(p.du) && is_finite_vec(p.dv), n);
                CHECK(is_finite_vec(p.duu) && is_finite_vec(p.duv) && is_finite_vec(p.dvv), n);
                CHECK(length <= 0 || fabs((double)length - 1) <= 8 * EPS, n);
            }
    }
}

/* A side without length, as of a cone's apex: the normal is the limit. */
static void collapsed_side(void)
{
    n3_vertex v[4];
    brown_square s;
    int i;
    for (i = 0; i < 4; i++) {
        static const double at[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}};
        v[i].x = n3_v((n3_real)at[i][0], (n3_real)at[i][1], 0);
        v[i].n = n3_v(0, 0, 1);
    }
    s = brown_quad_make(v, NULL);
    for (i = 0; i <= 8; i++) {
        CHECK_SAME(brown_point(&s, 0, (n3_real)i / 8), v[0].x, i);
        CHECK_VEC(brown_normal(&s, 0, (n3_real)i / 8), v[0].n, 32 * EPS, i);
    }
}

/* Tangents that vanish all along a side, as tension 1 makes them: the normal is the limit on the
 * way to the middle. In the corners, where both tangents may be short, it turns the fastest. */
static void tense_side(void)
{
    rng r = {25};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        n3_vertex corner[4];
        brown_square s;
        n3_real t = (n3_real)(n % 9) / 8, way = (n3_real)(sizeof(n3_real) == 8 ? 1e-7 : 1e-3);
        s = draw_one(&r, corner);
        memset(&s.across[0], 0, sizeof s.across[0]);
        s.side[2].p[1] = s.side[2].p[0];
        s.side[3].p[1] = s.side[3].p[0];
        CHECK_VEC(brown_normal(&s, t, 0), brown_normal(&s, t + way * ((n3_real)1 / 2 - t), way / 2),
                  20 * way, n);
    }
}

/* Both tangents vanish in a corner, as with tension 1 on both curves there: the normal is the
 * limit. Flatter still, second derivatives too: it is the normal a 1024th of the way on. */
static void tense_corner(void)
{
    rng r = {27};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        n3_vertex corner[4];
        brown_square s;
        int flatter = (int)(n % 2), i;
        n3_real way = (n3_real)(sizeof(n3_real) == 8 ? 1e-7 : 1e-3);
        s = draw_one(&r, corner);
        for (i = 0; i < 4; i += 2) {
            int k;
            for (k = 1; k < 2 + flatter; k++) s.side[i].p[k] = s.side[i].p[0];
            for (k = 0; k < 1 + flatter; k++) s.across[i].h.p[k] = n3_v(0, 0, 0);
            memset(&s.across[i].r, 0, sizeof s.across[i].r);
        }
        CHECK_VEC(brown_normal(&s, 0, 0), brown_normal(&s, way, way),
                  50 * (double)way + (flatter ? 200 * (double)BROWNI_WAY : 0), n);
    }
}

/* Where one vertex has no normal, two quads nearly agree along their edge towards its other end:
 * their tangents there differ, and count with the fourth power of the distance. Where none has, a
 * quad is bilinear. */
static void without_normals(void)
{
    rng r = {28};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        n3_vertex v[6], corner[4];
        brown_square s[2];
        int i;
        n3_real u = dyadic(&r, 0, 1), w = dyadic(&r, 0, 1), t;
        draw_two(&r, v);
        v[n % 2 ? 1 : 4].n = n3_v(0, 0, 0);
        for (i = 0; i < 2; i++) {
            quad_of(v, i, corner);
            s[i] = brown_quad_make(corner, NULL);
        }
        t = (n3_real)(n % 2 ? 7 : 1) / 8;
        CHECK_VEC(brown_normal(&s[0], 1, t), brown_normal(&s[1], 0, t), 1e-3, n);
        for (i = 0; i < 4; i++) corner[i].n = n3_v(0, 0, 0);
        s[0] = brown_quad_make(corner, NULL);
        CHECK_VEC(
            brown_point(&s[0], u, w),
            n3_add(n3_add(n3_mul((1 - u) * (1 - w), corner[0].x), n3_mul(u * (1 - w), corner[1].x)),
                   n3_add(n3_mul(u * w, corner[2].x), n3_mul((1 - u) * w, corner[3].x))),
            64 * EPS, n);
    }
}

/* A vertex of the torus R = 2, r = 1 in a grid of 24 by 16 whose columns are sheared. */
static n3_vertex on_torus(int i, int j, double shear)
{
    double a = PI * i / 12, b = PI * (j + shear * i) / 8, rho = 2 + cos(b);
    n3_vertex v;
    v.x = narrow(d_v(rho * cos(a), rho * sin(a), sin(b)));
    v.n = narrow(d_v(cos(b) * cos(a), cos(b) * sin(a), sin(b)));
    return v;
}

/* The quad between columns 0 and 1, rows j and j + 1. */
static brown_square torus_quad(int j, double shear, int fit)
{
    static const int at[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static const int over[4][2][2] = {
        {{0, -1}, {1, -1}}, {{2, 0}, {2, 1}}, {{1, 2}, {0, 2}}, {{-1, 1}, {-1, 0}}};
    n3_options o = {N3_RULE_ARC, 0, 0};
    n3_vertex v[4], c[2], d[2];
    n3_edge edge[4];
    n3_vec mid[4];
    int i, k;
    for (i = 0; i < 4; i++) v[i] = on_torus(at[i][0], j + at[i][1], shear);
    for (i = 0; i < 4; i++) {
        edge[i] = n3_edge_make(v[i], v[(i + 1) % 4], &o);
        for (k = 0; k < 2; k++) {
            c[k] = v[(i + 2 + k) % 4];
            d[k] = on_torus(over[i][k][0], j + over[i][k][1], shear);
        }
        mid[i] = fit ? brown_mid_normal(v[i], v[(i + 1) % 4], c, d) : n3_v(0, 0, 0);
    }
    return brown_quad_from_edges(v, edge, mid, &o);
}

/* The largest distance from the torus and the largest sine between the normals, found and held. */
static void torus(void)
{
    static const struct {
        double shear;
        int fit;
        double distance, sine;
    } row[] = {{0, 0, 6.3e-4, 1.72e-2},
               {0, 1, 2.1e-4, 2.3e-3},
               {0.25, 0, 5.66e-4, 1.57e-2},
               {0.25, 1, 1.88e-4, 2.36e-3}};
    int k, i, j, q;
    for (k = 0; k < 4; k++) {
        double distance = 0, sine = 0;
        for (q = 0; q < 16; q++) {
            brown_square s = torus_quad(q, row[k].shear, row[k].fit);
            for (j = 0; j <= 12; j++)
                for (i = 0; i <= 12; i++) {
                    n3_real u = (n3_real)i / 12, v = (n3_real)j / 12;
                    dvec x = wide(brown_point(&s, u, v)), n = wide(brown_normal(&s, u, v));
                    double rho = hypot(x.x, x.y), c = rho - 2;
                    dvec want = d_unit(d_v(x.x / rho * c, x.y / rho * c, x.z));
                    distance = fmax(distance, fabs(hypot(c, x.z) - 1));
                    sine = fmax(sine, d_len(d_cross(n, want)));
                }
        }
        CHECK_NEAR(distance, row[k].distance, 0.05 * row[k].distance, k);
        CHECK_NEAR(sine, row[k].sine, 0.05 * row[k].sine, k);
    }
}

const test_case tests_quad[] = {{"brown_normals_do_not_jump", normals_do_not_jump},
                                {"brown_sides_are_edges", sides_are_edges},
                                {"brown_flat", flat},
                                {"brown_scaled", scaled},
                                {"brown_either_side", either_side},
                                {"brown_degenerate", degenerate},
                                {"brown_collapsed_side", collapsed_side},
                                {"brown_tense_side", tense_side},
                                {"brown_tense_corner", tense_corner},
                                {"brown_without_normals", without_normals},
                                {"brown_torus", torus},
                                {NULL, NULL}};
