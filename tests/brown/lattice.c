/* lattice.c: the surface over a lattice, by the equations of its chords and tangents, and the
 * features that its parameters make. */
#include "brown_test.h"

enum { SAMPLES = 400, MOST = 5 };

typedef struct lattice {
    brown_lattice l;
    n3_vec point[MOST * MOST];
    brown_shape u_shape[MOST * MOST], v_shape[MOST * MOST];
} lattice;

/* Parameters from -1/2 to 1/2; a fifth of the curves has none, a fifth the same at all points. */
static void draw_shapes(rng *r, const brown_lattice *l, int along_v, brown_shape *shape)
{
    int curves = along_v ? l->columns : l->rows, points = along_v ? l->rows : l->columns, i, j;
    for (j = 0; j < curves; j++) {
        int kind = (int)(rng_next(r) % 5);
        brown_shape p = {0, 0, 0, 0, 0};
        for (i = 0; i < points; i++) {
            if (kind > 1 || (kind == 1 && i == 0)) {
                p.tension = (n3_real)rng_uniform(r, -0.5, 0.5);
                p.bias = (n3_real)rng_uniform(r, -0.5, 0.5);
                p.continuity = (n3_real)rng_uniform(r, -0.5, 0.5);
                p.t_continuity = (n3_real)rng_uniform(r, -0.5, 0.5);
            }
            shape[along_v ? i * l->columns + j : j * l->columns + i] = p;
        }
    }
}

/* Points near those of a grid. */
static void draw_lattice(rng *r, lattice *a)
{
    int i;
    memset(a, 0, sizeof *a);
    a->l.columns = 2 + (int)(rng_next(r) % 4);
    a->l.rows = 2 + (int)(rng_next(r) % 4);
    a->l.point = a->point;
    a->l.u_shape = a->u_shape;
    a->l.v_shape = a->v_shape;
    for (i = 0; i < a->l.columns * a->l.rows; i++) {
        n3_real x = (n3_real)(i % a->l.columns), y = (n3_real)(i / a->l.columns);
        a->point[i] = n3_add(n3_v(x, y, 0), n3_mul((n3_real)1 / 2, rng_vec(r)));
    }
    draw_shapes(r, &a->l, 0, a->u_shape);
    draw_shapes(r, &a->l, 1, a->v_shape);
}

/* One parameter on all curves. */
static void set_all(lattice *a, brown_shape p)
{
    int i;
    for (i = 0; i < MOST * MOST; i++) a->u_shape[i] = a->v_shape[i] = p;
}

/* ---- The equations as they are printed; U curves run along u, V curves along v ---- */

enum { U, V };

static int curves_of(const lattice *a, int family)
{
    return family == V ? a->l.columns : a->l.rows;
}

static int points_of(const lattice *a, int family)
{
    return family == V ? a->l.rows : a->l.columns;
}

/* CU_j(t) on the part behind its point i; beyond the lattice there is none. */
static dvec curve(const lattice *a, int family, int j, int i, double t)
{
    n3_edge e = brown_lattice_curve(&a->l, family, j, i);
    return d_bezier(&e, t);
}

/* CU_{j+1} - CU_j; at the ends the only chord stands for both. */
static dvec chord(const lattice *a, int family, int j, int i, double t)
{
    int last = curves_of(a, family) - 2;
    j = j < 0 ? 0 : j > last ? last : j;
    return d_sub(curve(a, family, j + 1, i, t), curve(a, family, j, i, t));
}

static brown_shape shape(const lattice *a, int family, int j, int i)
{
    return family == V ? a->v_shape[i * a->l.columns + j] : a->u_shape[j * a->l.columns + i];
}

static double between(n3_real a, n3_real b, double t)
{
    return (1 - t) * (double)a + t * (double)b;
}

/* DSU_j (out = 0) or DDU_j (out = 1) at t on the part behind the point i. */
static dvec tangent(const lattice *a, int family, int j, int i, int out, double t)
{
    brown_shape p = shape(a, family, j, i), q = shape(a, family, j, i + 1);
    double ten = between(p.tension, q.tension, t), b = between(p.bias, q.bias, t);
    double c = between(p.continuity, q.continuity, t);
    double tc = between(p.t_continuity, q.t_continuity, t);
    double alpha = (1 - ten) * (1 + b) * (1 - c) * (1 - tc) / 2;
    double beta = (1 - ten) * (1 - b) * (1 + c) * (1 - tc) / 2;
    double gamma = (1 - ten) * (1 + b) * (1 + c) * (1 + tc) / 2;
    double delta = (1 - ten) * (1 - b) * (1 - c) * (1 + tc) / 2;
    return d_mix(out ? gamma : alpha, chord(a, family, j - 1, i, t), out ? delta : beta,
                 chord(a, family, j, i, t));
}

/* What the square beside the curve j of the family has for its cross tangent. */
static dvec made(const lattice *a, int family, int j, int i, int out, double t)
{
    int before = out ? j : j - 1;
    brown_square s = family == V ? brown_lattice_square(&a->l, before, i)
                                 : brown_lattice_square(&a->l, i, before);
    const brown_field *f = &s.across[2 * family + !out];
    double w = t * (1 - t);
    return d_add(d_bezier(&f->h, t), d_mul(w * w, d_bezier(&f->r, t)));
}

/* Letters are below 1.5^4 / 2 = 2.6, point differences below 2, tangents below 11, so curves are
 * within 4 of their chord, their differences below 10 and fields below 52. Bernstein coefficients
 * are products of 5 factors, sums of 2, differences of curves; four raisings add 3 roundings each:
 * 25 eps/2 of 52. Those of a remainder carry 21 times as much twice over, and count 1/16. */
static const double field_error = 52 * 25 / 2.0 * (1 + 2 * 21 / 16.0);

/* The tangents out of or into the curves of a family, for every curve and part that has them. */
static void check_tangents(const lattice *a, int family, int out, double t, double tolerance,
                           long row)
{
    int i, j;
    for (j = !out; j < curves_of(a, family) - out; j++)
        for (i = 0; i + 1 < points_of(a, family); i++)
            CHECK_VEC(narrow(made(a, family, j, i, out, t)),
                      narrow(tangent(a, family, j, i, out, t)), tolerance, row);
}

static void tangents(uint64_t seed, int family, int out)
{
    rng r = {0};
    long i, count = sample_count(SAMPLES);
    r.state = seed;
    for (i = 0; i < count; i++) {
        lattice a;
        draw_lattice(&r, &a);
        check_tangents(&a, family, out, rng_uniform(&r, 0, 1), field_error * EPS, i);
    }
}

static void eq_6(void) { tangents(6, U, 0); }
static void eq_7(void) { tangents(7, U, 1); }
static void eq_8(void) { tangents(8, V, 0); }
static void eq_9(void) { tangents(9, V, 1); }

/* A bias of 1 leaves alpha = gamma = 1 alone, so the chord before the curve, -1 the one behind. */
static void chords(uint64_t seed, int family, int before)
{
    rng r = {0};
    long n, count = sample_count(SAMPLES);
    r.state = seed;
    for (n = 0; n < count; n++) {
        brown_shape p = {0, 0, 0, 0, 0};
        double t = rng_uniform(&r, 0, 1);
        lattice a;
        int i, j;
        draw_lattice(&r, &a);
        p.bias = before ? 1 : -1;
        set_all(&a, p);
        for (j = before; j < curves_of(&a, family) - !before; j++)
            for (i = 0; i + 1 < points_of(&a, family); i++)
                CHECK_VEC(narrow(made(&a, family, j, i, !before, t)),
                          narrow(d_sub(curve(&a, family, before ? j : j + 1, i, t),
                                       curve(&a, family, before ? j - 1 : j, i, t))),
                          32 * EPS, n);
    }
}

static void eq_2(void) { chords(2, U, 1); }
static void eq_3(void) { chords(3, U, 0); }
static void eq_4(void) { chords(4, V, 1); }
static void eq_5(void) { chords(5, V, 0); }

/* Section 3, the fifth parameter, read as DSU_j = alpha (CSU_j - CSU_{j-1}) and
 * DDU_j = alpha (CDU_j - CDU_{j+1}); next to an end the last difference serves. */
static void section_3(void)
{
    rng r = {33};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        brown_shape p = {0, 0, 0, 0, 0};
        double t = rng_uniform(&r, 0, 1);
        int family = (int)(n & 1), out = (int)(n >> 1 & 1), i, j, k, last;
        lattice a;
        draw_lattice(&r, &a);
        a.l.columns = a.l.rows = 4;
        p.rise = (n3_real)rng_uniform(&r, 0.1, 1);
        set_all(&a, p);
        last = curves_of(&a, family) - 2;
        CHECK(brown_lattice_check(&a.l, NULL) == BROWN_OK, n);
        for (j = !out; j < curves_of(&a, family) - out; j++)
            for (i = 0; i + 1 < points_of(&a, family); i++) {
                k = out ? j : j - 2; /* the lower of the two chords */
                k = k < 0 ? 0 : k >= last ? last - 1 : k;
                CHECK_VEC(narrow(made(&a, family, j, i, out, t)),
                          narrow(d_mul(
                              (out ? -1 : 1) * (double)p.rise,
                              d_sub(chord(&a, family, k + 1, i, t), chord(&a, family, k, i, t)))),
                          64 * EPS, n);
            }
    }
}

/* ---- What the surface is ---- */

static void points_are_kept(void)
{
    rng r = {11};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        lattice a;
        int i, j, k;
        draw_lattice(&r, &a);
        for (j = 0; j + 1 < a.l.rows; j++)
            for (i = 0; i + 1 < a.l.columns; i++) {
                brown_square s = brown_lattice_square(&a.l, i, j);
                for (k = 0; k < 4; k++)
                    CHECK_SAME(brown_point(&s, (n3_real)(k & 1), (n3_real)(k >> 1)),
                               a.point[(j + (k >> 1)) * a.l.columns + i + (k & 1)], n);
            }
    }
}

/* With tension and bias alone the derivative across a curve is the same from both sides, and so is
 * the normal; with the others it jumps by (gamma - alpha) CS + (delta - beta) CD. */
static void jumps(void)
{
    rng r = {12};
    long n, count = sample_count(SAMPLES);
    for (n = 0; n < count; n++) {
        lattice a;
        int i, smooth = (int)(n % 2);
        n3_real t = dyadic(&r, 0, 1);
        draw_lattice(&r, &a);
        a.l.columns = a.l.rows = 3;
        for (i = 0; i < MOST * MOST && smooth; i++) {
            a.u_shape[i].continuity = a.u_shape[i].t_continuity = 0;
            a.v_shape[i].continuity = a.v_shape[i].t_continuity = 0;
        }
        if (!(t > 0 && t < 1)) continue;
        for (i = 0; i < 2; i++) {
            brown_square below = brown_lattice_square(&a.l, i, 0);
            brown_square above = brown_lattice_square(&a.l, i, 1);
            n3_jet in = brown_jet(&below, t, 1), out = brown_jet(&above, t, 0);
            dvec want =
                d_sub(tangent(&a, U, 1, i, 1, (double)t), tangent(&a, U, 1, i, 0, (double)t));
            CHECK_SAME(in.x, out.x, n);
            CHECK_VEC(n3_sub(out.dv, in.dv), narrow(smooth ? d_v(0, 0, 0) : want),
                      2 * field_error * EPS, n);
            CHECK_VEC(n3_sub(out.du, in.du), n3_v(0, 0, 0), field_error * EPS, n);
        }
    }
}

/* Rounding in the tangents of sides and squares is no difference between them: second derivatives
 * next to a corner would hold it divided by the distance. Third derivatives are below 2000. */
static void quiet_corners(void)
{
    rng r = {15};
    long n, count = sample_count(SAMPLES);
    n3_real e = sizeof(n3_real) == 8 ? N3_EPS * 4096 : N3_EPS * 8; /* 2^-40, 2^-20 */
    for (n = 0; n < count; n++) {
        lattice a;
        brown_square s;
        n3_jet j, k;
        draw_lattice(&r, &a);
        s = brown_lattice_square(&a.l, 0, 0);
        j = brown_jet(&s, e, e);
        k = brown_jet(&s, 2 * e, 2 * e);
        CHECK_VEC(k.duu, j.duu, 2000 * (double)e + 2000 * EPS, n);
        CHECK_VEC(k.duv, j.duv, 2000 * (double)e + 2000 * EPS, n);
        CHECK_VEC(k.dvv, j.dvv, 2000 * (double)e + 2000 * EPS, n);
    }
}

/* Own curves, with tangents of their own: points and cross tangents stay. */
static void own_curves(void)
{
    rng r = {13};
    n3_edge own[12];
    lattice a;
    brown_square s;
    int i;
    draw_lattice(&r, &a);
    a.l.columns = a.l.rows = 3;
    for (i = 0; i < 6; i++) {
        own[i] = brown_lattice_curve(&a.l, 0, i / 2, i % 2);
        own[i].p[1] = n3_add(own[i].p[1], n3_v(0, 0, 1));
    }
    a.l.u_curve = own;
    s = brown_lattice_square(&a.l, 1, 1);
    for (i = 0; i <= 8; i++) {
        n3_real t = (n3_real)i / 8;
        n3_vec want = n3_edge_point(&own[3], t);
        CHECK_SAME(brown_point(&s, t, 0), want, i);
        if (i % 8)
            CHECK_VEC(brown_jet(&s, t, 0).dv, narrow(tangent(&a, U, 1, 1, 1, (double)t)),
                      field_error * EPS, i);
    }
}

/* ---- Features of section 4 ---- */

/* A lattice of which only the middle square lies on the plane z = x / 4 + 5: continuity -1 on the
 * four curves round it, and the square is flat. */
static void plane(void)
{
    lattice a;
    brown_square s;
    int i, j;
    memset(&a, 0, sizeof a);
    a.l.columns = a.l.rows = 4;
    a.l.point = a.point;
    a.l.u_shape = a.u_shape;
    a.l.v_shape = a.v_shape;
    for (i = 0; i < 16; i++) {
        int column = i % 4, row = i / 4, out_u = column % 3 == 0, out_v = row % 3 == 0;
        n3_real x = (n3_real)column, y = (n3_real)row, bump = out_u || out_v ? 1 : 0;
        a.point[i] = n3_v(x, y, x / 4 + 5 + bump * y);
        a.u_shape[i].continuity = out_v ? 0 : -1;
        a.v_shape[i].continuity = out_u ? 0 : -1;
    }
    s = brown_lattice_square(&a.l, 1, 1);
    for (j = 0; j <= 16; j++)
        for (i = 0; i <= 16; i++) {
            n3_real u = (n3_real)i / 16, v = (n3_real)j / 16;
            n3_vec x = brown_point(&s, u, v), n = brown_normal(&s, u, v);
            CHECK_NEAR(x.z, x.x / 4 + 5, 16 * EPS, 17 * j + i);
            CHECK_VEC(n, n3_unit(n3_v((n3_real)-1 / 4, 0, 1)), 64 * EPS, 17 * j + i);
        }
}

/* Three rows over half a circle: rise 3 k / 2 at both ends, tension 1 - 3 k on the middle one. */
static void half_cylinder(void)
{
    const double k = 4 * (sqrt(2) - 1) / 3;
    double mean = 0, most = 0;
    brown_shape rise = {0, 0, 0, 0, 0}, tense = {0, 0, 0, 0, 0};
    lattice a;
    int i, j, n = 2000;
    memset(&a, 0, sizeof a);
    rise.rise = (n3_real)(3 * k / 2);
    tense.tension = (n3_real)(1 - 3 * k);
    a.l.columns = 2;
    a.l.rows = 3;
    a.l.point = a.point;
    a.l.u_shape = a.u_shape;
    for (i = 0; i < 6; i++) {
        static const double at[3][2] = {{-1, 0}, {0, 1}, {1, 0}};
        a.point[i] = n3_v((n3_real)(i % 2), (n3_real)at[i / 2][0], (n3_real)at[i / 2][1]);
        a.u_shape[i] = i / 2 == 1 ? tense : rise;
    }
    CHECK(brown_lattice_check(&a.l, NULL) == BROWN_OK, 0);
    for (j = 0; j < 2; j++) {
        brown_square s = brown_lattice_square(&a.l, 0, j);
        for (i = 0; i < n; i++) {
            n3_real u = (n3_real)(i % 7) / 7, v = (n3_real)(2 * i + 1) / (n3_real)(2 * n);
            n3_vec x = brown_point(&s, u, v);
            double error = fabs(hypot((double)x.y, (double)x.z) - 1);
            mean += error / (2 * n);
            most = fmax(most, error);
            CHECK_NEAR(x.x, u, 16 * EPS, i);
        }
    }
    CHECK_NEAR(mean, 1.40e-4, 0.005e-4, 0);
    CHECK_NEAR(most, 2.73e-4, 0.005e-4, 0);
}

/* ---- What is refused ---- */

static void check(void)
{
    rng r = {14};
    lattice a;
    int item = -7, i;
    draw_lattice(&r, &a);
    a.l.columns = a.l.rows = 3;
    set_all(&a, a.u_shape[0]);
    CHECK(brown_lattice_check(&a.l, &item) == BROWN_OK && item == -7, 0);
    CHECK(brown_lattice_check(NULL, &item) == BROWN_NULL_POINTER, 1);
    a.l.rows = 1;
    CHECK(brown_lattice_check(&a.l, &item) == BROWN_BAD_COUNT && item == -7, 2);
    a.l.rows = 3;
    a.point[4].y = (n3_real)NAN;
    CHECK(brown_lattice_check(&a.l, &item) == BROWN_BAD_POINT && item == 4, 3);
    a.point[4].y = 0;
    a.v_shape[5].bias = (n3_real)INFINITY;
    CHECK(brown_lattice_check(&a.l, &item) == BROWN_BAD_SHAPE && item == 5, 4);
    a.v_shape[5].bias = 0;
    a.v_shape[7].rise = 1;
    CHECK(brown_lattice_check(&a.l, &item) == BROWN_BAD_RISE && item == 7, 5);
    memset(a.u_shape, 0, sizeof a.u_shape);
    memset(a.v_shape, 0, sizeof a.v_shape);
    for (i = 0; i < 9; i++) a.u_shape[i].rise = 1;
    CHECK(brown_lattice_check(&a.l, &item) == BROWN_OK, 6);
    a.l.rows = 2;
    CHECK(brown_lattice_check(&a.l, &item) == BROWN_BAD_RISE && item == 0, 7);
}

const test_case tests_lattice[] = {{"brown_eq_2", eq_2},
                                   {"brown_eq_3", eq_3},
                                   {"brown_eq_4", eq_4},
                                   {"brown_eq_5", eq_5},
                                   {"brown_eq_6", eq_6},
                                   {"brown_eq_7", eq_7},
                                   {"brown_eq_8", eq_8},
                                   {"brown_eq_9", eq_9},
                                   {"brown_section_3", section_3},
                                   {"brown_points_are_kept", points_are_kept},
                                   {"brown_jumps", jumps},
                                   {"brown_quiet_corners", quiet_corners},
                                   {"brown_own_curves", own_curves},
                                   {"brown_plane", plane},
                                   {"brown_half_cylinder", half_cylinder},
                                   {"brown_lattice_check", check},
                                   {NULL, NULL}};
