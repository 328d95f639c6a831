/* square.c: Brown's square (1), in the plainest way, against exact values and in its corners. */
#include "brown_test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 2000 };

static n3_vec draw(rng *r)
{
    n3_real c[3];
    int k;
    for (k = 0; k < 3; k++) c[k] = (n3_real)((double)(rng_next(r) % 33) - 16) / 8;
    return n3_v(c[0], c[1], c[2]);
}

brown_square square_make(int seed, int kind)
{
    static const int end[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
    brown_square s;
    n3_vec corner[4];
    rng r = {0};
    int i, k;
    r.state = (uint64_t)seed;
    for (k = 0; k < 4; k++) corner[k] = draw(&r);
    for (k = 0; k < 4; k++) {
        s.side[k].p[0] = corner[end[k][0]];
        for (i = 1; i < 3; i++) s.side[k].p[i] = draw(&r);
        s.side[k].p[3] = corner[end[k][1]];
    }
    for (k = 0; k < 4; k++) {
        n3_vec *h = s.across[k].h.p;
        for (i = 1; i < 3; i++) h[i] = draw(&r);
        for (i = 0; i < 2; i++) {
            const n3_vec *p = &s.side[(k < 2 ? 2 : 0) + i].p[2 * (k % 2)];
            h[3 * i] = kind == INCOMPATIBLE ? draw(&r) : n3_mul(3, n3_sub(p[1], p[0]));
        }
        for (i = 0; i < 4; i++) s.across[k].r.p[i] = kind == REMAINDERS ? draw(&r) : n3_v(0, 0, 0);
    }
    return s;
}

static dvec field_at(const brown_field *f, double t)
{
    double a = t * (1 - t);
    return d_add(d_bezier(&f->h, t), d_mul(a * a, d_bezier(&f->r, t)));
}

/* [h(w)] times the two sides from first on and their cross tangents, at t. */
static dvec loft(const brown_square *s, int first, double t, double w)
{
    double h0 = 2 * w * w * w - 3 * w * w + 1, h1 = -2 * w * w * w + 3 * w * w;
    double h2 = w * w * w - 2 * w * w + w, h3 = w * w * w - w * w;
    dvec sides = d_mix(h0, d_bezier(&s->side[first], t), h1, d_bezier(&s->side[first + 1], t));
    return d_add(sides,
                 d_mix(h2, field_at(&s->across[first], t), h3, field_at(&s->across[first + 1], t)));
}

/* The control points are below 3 in size, cross tangents and remainders below 12, so that a loft is
 * below 3 + 12/4 = 6. The header's own polynomials have 9 roundings of eps/2 in a row, the weights
 * 4 more; the largest terms are of size 6: 13 * 6 / 2 = 39 eps; and as much in DBL_EPSILON for the
 * test's. */
static void eq_1(void)
{
    rng r = {1};
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        brown_square s = square_make((int)(i % 1000), (int)(i % KINDS_OF_SQUARE));
        n3_real u = dyadic(&r, 0, 1), v = dyadic(&r, 0, 1);
        double x = (double)u, y = (double)v, a = x * x * (1 - x) * (1 - x);
        double b = y * y * (1 - y) * (1 - y);
        dvec A = loft(&s, 2, y, x), B = loft(&s, 0, x, y);
        if (!(a + b > 0)) continue;
        CHECK_VEC(brown_point(&s, u, v), narrow(d_mix(b / (a + b), A, a / (a + b), B)),
                  39 * (EPS + DBL_EPSILON), i);
    }
}

/* On a side the surface is the side's curve, bit for bit, and the derivative across it the given
 * one: the lofts' other terms cancel to a rounding of their size. */
static void sides(void)
{
    rng r = {2};
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        brown_square s = square_make((int)(i % 1000), (int)(i % KINDS_OF_SQUARE));
        n3_real t = dyadic(&r, 0, 1), w = (n3_real)(i & 1);
        n3_jet u = brown_jet(&s, t, w), v = brown_jet(&s, w, t);
        CHECK_SAME(u.x, n3_edge_point(&s.side[i & 1], t), i);
        CHECK_SAME(v.x, n3_edge_point(&s.side[2 + (i & 1)], t), i);
        if (!(t > 0 && t < 1)) continue;
        CHECK_VEC(u.dv, narrow(field_at(&s.across[i & 1], (double)t)), 64 * EPS, i);
        CHECK_VEC(v.du, narrow(field_at(&s.across[2 + (i & 1)], (double)t)), 64 * EPS, i);
    }
}

/* In a corner, what the sides say. */
static void corners(void)
{
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        brown_square s = square_make((int)(i % 1000), (int)(i % KINDS_OF_SQUARE));
        int cu = (int)(i / 2 % 2), cv = (int)(i / 4 % 2);
        n3_real u = (n3_real)cu, v = (n3_real)cv;
        n3_jet j = brown_jet(&s, u, v);
        n3_curve_jet along_u = n3_edge_jet(&s.side[cv], u);
        n3_curve_jet along_v = n3_edge_jet(&s.side[2 + cu], v);
        n3_vec tu = n3_edge_jet(&s.across[cv].h, u).dt, tv = n3_edge_jet(&s.across[2 + cu].h, v).dt;
        CHECK_SAME(j.x, s.side[cv].p[3 * cu], i);
        CHECK_SAME(brown_point(&s, u, v), j.x, i);
        CHECK_SAME(j.du, along_u.dt, i);
        CHECK_SAME(j.dv, along_v.dt, i);
        CHECK_SAME(j.duu, along_u.dtt, i);
        CHECK_SAME(j.dvv, along_v.dtt, i);
        CHECK_SAME(j.duv, n3_mul((n3_real)1 / 2, n3_add(tu, tv)), i);
    }
}

/* However near to a corner, where tangents differ too; second derivatives may be beyond n3_real. */
static void next_to_corners(void)
{
    static const double power[] = {-20, -100, -126, -140, -1000, -1022, -1060};
    int i, k;
    for (i = 0; i < 7; i++)
        for (k = 0; k < KINDS_OF_SQUARE; k++) {
            brown_square s = square_make(i, k);
            n3_real u = (n3_real)pow(2, power[i]);
            n3_jet j = brown_jet(&s, u, u), at = brown_jet(&s, 0, 0);
            CHECK_VEC(j.x, at.x, 100 * (double)u + EPS, i);
            CHECK(is_finite_vec(j.du) && is_finite_vec(j.dv), i);
            if (k == INCOMPATIBLE) continue;
            CHECK_VEC(j.du, at.du, 1000 * (double)u + 48 * EPS, i);
            CHECK_VEC(j.dv, at.dv, 1000 * (double)u + 48 * EPS, i);
            CHECK(is_finite_vec(j.duu) && is_finite_vec(j.duv) && is_finite_vec(j.dvv), i);
        }
}

/* The next number of the row. */
static double take_number(char **at)
{
    double x = strtod(*at, at);
    if (**at == ',') ++*at;
    return x;
}

/* Distance to the nearest corner, or what it may count as. */
static double to_corner(double u, double v)
{
    double x = fmax(u * (1 - u), v * (1 - v));
    return x < 1 ? x : 1;
}

/* The exact values of golden.py, 2^-40 and in float 2^-20 from the corners as well, to what brown.h
 * claims: the largest coordinate or cross tangent is below 12. Where the tangents differ, the
 * second derivatives grow as 1/distance to the corner. */
static void golden(void)
{
    const char *path = "tests/brown/golden.csv";
    FILE *f = fopen(path, "r");
    char line[1024], *at;
    long rows = 0;
    if (!CHECK(f != NULL, 0)) return;
    while (fgets(line, sizeof line, f)) {
        int seed, kind, k;
        double u, v, claim[6] = {2, 4, 4, 25, 25, 25};
        brown_square s;
        n3_jet j;
        const n3_vec *got = &j.x;
        at = line;
        seed = (int)take_number(&at);
        kind = (int)take_number(&at);
        u = take_number(&at);
        v = take_number(&at);
        if ((double)(n3_real)u < u || (double)(n3_real)u > u) continue;
        if ((double)(n3_real)v < v || (double)(n3_real)v > v) continue;
        s = square_make(seed, kind);
        j = brown_jet(&s, (n3_real)u, (n3_real)v);
        for (k = 0; k < 6; k++) {
            double x = take_number(&at), y = take_number(&at), z = take_number(&at);
            double near_by = kind == INCOMPATIBLE && k > 2 ? to_corner(u, v) : 1;
            CHECK_VEC(got[k], narrow(d_v(x, y, z)), 12 * claim[k] * EPS / near_by, seed * 1000 + k);
        }
        rows++;
    }
    fclose(f);
    CHECK(rows >= (sizeof(n3_real) == 8 ? 180 : 100), rows);
}

const test_case tests_square[] = {
    {"brown_eq_1", eq_1},       {"brown_sides", sides},
    {"brown_corners", corners}, {"brown_next_to_corners", next_to_corners},
    {"brown_golden", golden},   {NULL, NULL}};
