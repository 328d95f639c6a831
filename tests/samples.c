#include "samples.h"

#include <math.h>

enum {
    DIGITS = sizeof(n3_real) == sizeof(float) ? 24 : 53,
    POWERS = sizeof(n3_real) == sizeof(float) ? 20 : 100
};

static int chance(rng *r, int of) { return rng_next(r) % (uint64_t)of == 0; }

static int below(rng *r, int count) { return (int)(rng_next(r) % (uint64_t)count); }

/* From 1/4 down to a quarter of N3_EPS, all exponents alike. */
static double slight(rng *r) { return ldexp(rng_uniform(r, 0.5, 1), -2 - below(r, DIGITS)); }

static n3_vec beside(rng *r, n3_vec a, double distance)
{
    return n3_add(a, n3_mul((n3_real)distance, rng_unit(r)));
}

static n3_vec chord(const sample *s, int i, int j) { return n3_sub(s->v[j].x, s->v[i].x); }

static n3_vec turned(rng *r, n3_vec n) { return n3_unit(beside(r, n, slight(r))); }

static void make_benign(sample *s, rng *r)
{
    n3_vec n = n3_unit(n3_cross(chord(s, 0, 1), chord(s, 0, 2)));
    int i;
    for (i = 0; i < 3; i++) s->v[i].n = n3_unit(beside(r, n, 0.5));
}

static void make_nearly_parallel(sample *s, rng *r)
{
    s->v[1].n = turned(r, s->v[0].n);
    s->v[2].n = turned(r, s->v[0].n);
}

/* Three normals whose sum vanishes, or nearly. */
static void make_cancelling(sample *s, rng *r)
{
    n3_vec n = s->v[0].n, across = n3_unit(n3_cross(n, rng_unit(r)));
    n3_vec back = n3_mul((n3_real)-0.5, n);
    s->v[1].n = n3_unit(n3_add(back, n3_mul((n3_real)sqrt(0.75), across)));
    s->v[2].n = turned(r, n3_unit(n3_sub(back, n3_mul((n3_real)sqrt(0.75), across))));
}

static void make_nearly_opposite(sample *s, rng *r)
{
    n3_vec back = n3_mul(-1, s->v[0].n);
    s->v[1].n = chance(r, 8) ? back : turned(r, back);
    s->v[2].n = turned(r, chance(r, 2) ? back : s->v[0].n);
    if (chance(r, 4)) make_cancelling(s, r);
}

static n3_vec along(rng *r, n3_vec d)
{
    n3_vec n = n3_unit(n3_mul(chance(r, 2) ? 1 : -1, d));
    return chance(r, 2) ? n : turned(r, n);
}

static void make_along_chord(sample *s, rng *r)
{
    int end = below(r, 2);
    s->v[end].n = along(r, chord(s, 0, 1));
    if (chance(r, 4)) s->v[1 - end].n = along(r, chord(s, 0, 1));
    if (chance(r, 4)) s->v[2].n = along(r, chord(s, 0, 2));
}

static void make_coincident(sample *s, rng *r)
{
    s->v[1].x = chance(r, 2) ? s->v[0].x : beside(r, s->v[0].x, slight(r));
    if (chance(r, 2)) s->v[2].x = s->v[1].x;
    if (chance(r, 4)) s->v[1].n = s->v[0].n;
}

static void make_sliver(sample *s, rng *r)
{
    n3_vec foot = n3_mul((n3_real)rng_uniform(r, 0, 1), chord(s, 0, 1));
    s->v[2].x = beside(r, n3_add(s->v[0].x, foot), 1e-6);
}

static n3_real mixed(rng *r)
{
    return (n3_real)ldexp(rng_uniform(r, -1, 1), below(r, 2 * POWERS + 1) - POWERS);
}

static void make_mixed_exponents(sample *s, rng *r)
{
    int i;
    for (i = 0; i < 3; i++) {
        n3_real x = mixed(r), y = mixed(r), z = mixed(r);
        s->v[i].x = n3_v(x, y, z);
    }
}

static void make_orthogonal(sample *s, rng *r)
{
    int i;
    for (i = 0; i < 3; i++)
        s->v[i].n =
            n3_unit(n3_cross(chord(s, i, chance(r, 2) ? (i + 1) % 3 : (i + 2) % 3), s->v[i].n));
}

static void make_on_axes(sample *s, rng *r)
{
    int i;
    for (i = 0; i < 3; i++) {
        int x = below(r, 5) - 2, y = below(r, 5) - 2, z = below(r, 5) - 2, axis = below(r, 3);
        n3_real sign = chance(r, 2) ? 1 : -1;
        s->v[i].x = n3_v((n3_real)x, (n3_real)y, (n3_real)z);
        s->v[i].n = n3_v(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
    }
}

static void make_equal_normals(sample *s, rng *r)
{
    (void)r;
    s->v[1].n = s->v[2].n = s->v[0].n;
}

sample sample_make(long i)
{
    static void (*const make[KINDS])(sample *, rng *) = {
        make_benign, make_nearly_parallel, make_nearly_opposite, make_along_chord,
        make_coincident, make_sliver, make_mixed_exponents, make_orthogonal, make_on_axes,
        make_equal_normals};
    sample s;
    int k;
    s.r.state = (uint64_t)i * 0xd1342543de82ef95u + 1;
    s.kind = (int)(i % KINDS);
    s.exponent = 0;
    for (k = 0; k < 3; k++) {
        s.v[k].x = rng_vec(&s.r);
        s.v[k].n = rng_unit(&s.r);
    }
    if (i / KINDS % 4 == 1) {
        n3_vec away = n3_mul(1000, rng_vec(&s.r));
        for (k = 0; k < 3; k++) s.v[k].x = n3_add(s.v[k].x, away);
    }
    make[s.kind](&s, &s.r);
    if (i / KINDS % 4 == 2) s.exponent = below(&s.r, 2 * POWERS + 1) - POWERS;
    for (k = 0; k < 3; k++) s.v[k] = scale_vertex(s.v[k], s.exponent);
    return s;
}

n3_vec scale_vec(n3_vec a, int exponent)
{
    n3_real s = (n3_real)ldexp(1, exponent);
    return n3_mul(s, a);
}

n3_vertex scale_vertex(n3_vertex v, int exponent)
{
    v.x = scale_vec(v.x, exponent);
    return v;
}

n3_real dyadic(rng *r, int lo, int hi)
{
    return (n3_real)(lo * 1024 + below(r, (hi - lo) * 1024 + 1)) / 1024;
}

void dyadic_weights(rng *r, n3_real *u, n3_real *v)
{
    *u = dyadic(r, 0, 1);
    *v = dyadic(r, 0, 1);
    if (*u + *v > 1) *u = 1 - *u, *v = 1 - *v;
    switch (below(r, 9)) {
    case 0: *u = 0; break;
    case 1: *v = 0; break;
    case 2: *v = 1 - *u; break;
    default: break;
    }
}

double reach(const n3_vec *p, int count)
{
    double largest = 0;
    int i;
    for (i = 0; i < count; i++) {
        largest = fmax(largest, fabs((double)p[i].x));
        largest = fmax(largest, fmax(fabs((double)p[i].y), fabs((double)p[i].z)));
    }
    return largest;
}

static n3_vec *put(n3_vec *to, const n3_vec *from, int count)
{
    int k;
    for (k = 0; k < count; k++) *to++ = from[k];
    return to;
}

static n3_vec *put_patch(n3_vec *to, const n3_patch *p, n3_real u, n3_real v)
{
    n3_jet j = n3_patch_jet(p, u, v);
    n3_vec net[16], jet[6];
    jet[0] = j.x, jet[1] = j.du, jet[2] = j.dv, jet[3] = j.duu, jet[4] = j.duv, jet[5] = j.dvv;
    n3_patch_bicubic(p, net);
    to = put(to, p->p, 10);
    to = put(to, jet, 6);
    return put(to, net, 16);
}

static n3_vec *put_edge(n3_vec *to, const n3_edge *e, n3_real t)
{
    n3_edge part[2];
    n3_curve_jet j = n3_edge_jet(e, t);
    n3_edge_split(e, t, part);
    to = put(to, part[0].p, 4);
    *to++ = j.x, *to++ = j.dt, *to++ = j.dtt;
    return to;
}

answers ask(const n3_vertex x[3], const n3_options *o, n3_real u, n3_real v)
{
    answers r;
    n3_patch p = n3_patch_make(x[0], x[1], x[2], o), raised;
    n3_patch2 q = n3_patch2_make(x[0], x[1], x[2]);
    n3_edge e[3];
    n3_vec *to = put_patch(r.linear, &p, u, v);
    raised = n3_patch2_raise(&q);
    n3_patch_edges(&p, e);
    to = put(to, q.p, 6);
    to = put(to, raised.p, 10);
    to = put_edge(to, &e[0], u);
    to = put_edge(to, &e[1], v);
    *to++ = n3_patch2_point(&q, u, v);
    *to++ = n3_segment_curvature(x[1], x[2]);
    r.unit[0] = n3_patch_normal(&p, u, v);
    r.unit[1] = n3_patch_normal(&raised, u, v);
    r.unit[2] = n3_curve_plane(x[0], x[1]);
    return r;
}

void check_alike(const answers *got, const answers *want, int exponent, long row)
{
    int k;
    for (k = 0; k < LINEAR; k++)
        if (!CHECK_SAME(got->linear[k], scale_vec(want->linear[k], exponent), row)) break;
    for (k = 0; k < UNIT; k++) CHECK_SAME(got->unit[k], want->unit[k], row);
}
