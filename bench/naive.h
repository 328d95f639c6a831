/* naive.h: what the header does fast, written down as it comes, for the bench to compare with: one
 * item after the other, no care for what is degenerate, nothing shared. */
#ifndef BENCH_NAIVE_H
#define BENCH_NAIVE_H

#include "nagata3.h"

static inline n3_real naive_len(n3_vec a) { return n3i_sqrt(n3_dot(a, a)); }
static inline n3_vec naive_unit(n3_vec a) { return n3i_over(a, naive_len(a)); }

typedef struct naive_end { n3_real cos, sin, tan; } naive_end;

static inline naive_end naive_end_of(n3_vec n, n3_vec e, n3_vec b)
{
    n3_real ne = n3_dot(n, e), nb = n3_dot(n, b), r = 1 / n3i_sqrt(ne * ne + nb * nb);
    naive_end t;
    t.cos = n3i_abs(nb) * r;
    t.sin = (nb < 0 ? ne : -ne) * r;
    t.tan = n3i_larger(n3i_abs(ne / nb), (n3_real)1 / 10);
    t.tan = t.tan > 10 ? 10 : t.tan;
    return t;
}

static inline n3_real naive_handle(naive_end here, naive_end other, n3_real L)
{
    n3_real ratio = other.tan / (here.tan + other.tan);
    return here.cos >= (n3_real)1 / 2 ? ratio / here.cos * (2 * L / 3) : ratio * (4 * L / 3);
}

/* The paper's edge between two points with normals: p[0] and p[1] are its inner control points. */
static inline void naive_edge(const n3_vec *x0, const n3_vec *n0, const n3_vec *x1,
                              const n3_vec *n1, n3_vec p[2])
{
    n3_vec d = n3_sub(*x1, *x0), e, m0, m1, b;
    n3_real L = naive_len(d);
    naive_end s, t;
    e = n3i_over(d, L);
    m0 = naive_unit(n3_cross(e, *n0));
    m1 = naive_unit(n3_cross(e, *n1));
    if (n3_dot(m0, m1) < 0) m1 = n3i_neg(m1);
    b = n3_cross(naive_unit(n3_add(m0, m1)), e);
    s = naive_end_of(*n0, e, b);
    t = naive_end_of(*n1, e, b);
    d = n3_add(n3_mul(s.cos, e), n3_mul(s.sin, b));
    p[0] = n3_add(*x0, n3_mul(naive_handle(s, t, L), d));
    d = n3_add(n3_mul(t.cos, e), n3_mul(t.sin, b));
    p[1] = n3_sub(*x1, n3_mul(naive_handle(t, s, L), d));
}

/* Read and written where it lies, and in a loop: a compiler builds naive_edge in at one place, not
   at three, and handing structures over takes a fifth longer. */
static inline void naive_patch(const n3_vec *x, const n3_vec *n, const int *t, n3_vec p[10])
{
    n3_vec sides, corners;
    int i;
    for (i = 0; i < 3; i++) {
        int a = t[i], b = t[(i + 1) % 3];
        p[i] = x[a];
        naive_edge(&x[a], &n[a], &x[b], &n[b], &p[3 + 2 * i]);
    }
    corners = n3_add(n3_add(p[0], p[1]), p[2]);
    sides = n3_add(n3_add(n3_add(p[3], p[4]), n3_add(p[5], p[6])), n3_add(p[7], p[8]));
    p[9] = n3_sub(n3_mul((n3_real)1 / 4, sides), n3_mul((n3_real)1 / 6, corners));
}

/* The sum of the control points times their Bernstein polynomials. */
static inline n3_vec naive_point(const n3_patch *p, n3_real u, n3_real v)
{
    const n3_vec *q = p->p;
    n3_real w = 1 - u - v, b[10];
    b[0] = w * w * w, b[1] = u * u * u, b[2] = v * v * v;
    b[3] = 3 * u * w * w, b[4] = 3 * u * u * w, b[5] = 3 * u * u * v;
    b[6] = 3 * u * v * v, b[7] = 3 * v * v * w, b[8] = 3 * v * w * w;
    b[9] = 6 * u * v * w;
#define NAIVE_SUM(x)                                                                               \
    (b[0] * q[0].x + b[1] * q[1].x + b[2] * q[2].x + b[3] * q[3].x + b[4] * q[4].x +               \
     b[5] * q[5].x + b[6] * q[6].x + b[7] * q[7].x + b[8] * q[8].x + b[9] * q[9].x)
    return n3_v(NAIVE_SUM(x), NAIVE_SUM(y), NAIVE_SUM(z));
#undef NAIVE_SUM
}

/* The unit cross product of the derivatives. */
static inline n3_vec naive_normal(const n3_patch *p, n3_real u, n3_real v)
{
    const n3_vec *q = p->p;
    n3_real w = 1 - u - v, ww = w * w, uu = u * u, vv = v * v;
    n3_real uw = 2 * u * w, uv = 2 * u * v, vw = 2 * v * w;
    n3_vec du, dv;
#define NAIVE_DU(x)                                                                                \
    (ww * (q[3].x - q[0].x) + uu * (q[1].x - q[4].x) + vv * (q[6].x - q[7].x) +                    \
     uw * (q[4].x - q[3].x) + uv * (q[5].x - q[9].x) + vw * (q[9].x - q[8].x))
#define NAIVE_DV(x)                                                                                \
    (ww * (q[8].x - q[0].x) + uu * (q[5].x - q[4].x) + vv * (q[2].x - q[7].x) +                    \
     uw * (q[9].x - q[3].x) + uv * (q[6].x - q[9].x) + vw * (q[7].x - q[8].x))
    du = n3_v(NAIVE_DU(x), NAIVE_DU(y), NAIVE_DU(z));
    dv = n3_v(NAIVE_DV(x), NAIVE_DV(y), NAIVE_DV(z));
#undef NAIVE_DU
#undef NAIVE_DV
    return naive_unit(n3_cross(du, dv));
}

#endif
