/* naive.h: vectors and curves in double, for tests that evaluate a formula as it is printed.
 *
 * Nothing here is fast or careful; the inputs are the very numbers that the header gets (wide), so
 * that the only errors to allow for are the header's own and a few DBL_EPSILON. */
#ifndef NAIVE_H
#define NAIVE_H

#include "nagata3.h"

#include <math.h>

#define PI     3.14159265358979323846
#define DEGREE (PI / 180)

typedef struct dvec {
    double x, y, z;
} dvec;

static inline dvec d_v(double x, double y, double z)
{
    dvec a;
    a.x = x;
    a.y = y;
    a.z = z;
    return a;
}

static inline dvec wide(n3_vec a) { return d_v((double)a.x, (double)a.y, (double)a.z); }

static inline n3_vec narrow(dvec a)
{
    n3_vec b;
    b.x = (n3_real)a.x;
    b.y = (n3_real)a.y;
    b.z = (n3_real)a.z;
    return b;
}

static inline dvec d_add(dvec a, dvec b) { return d_v(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline dvec d_sub(dvec a, dvec b) { return d_v(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline dvec d_mul(double s, dvec a) { return d_v(s * a.x, s * a.y, s * a.z); }
static inline double d_dot(dvec a, dvec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline double d_len(dvec a) { return sqrt(d_dot(a, a)); }
static inline dvec d_unit(dvec a) { return d_mul(1 / d_len(a), a); }

/* s a + r b */
static inline dvec d_mix(double s, dvec a, double r, dvec b)
{
    return d_add(d_mul(s, a), d_mul(r, b));
}

static inline dvec d_cross(dvec a, dvec b)
{
    return d_v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* sum p_ij 3!/(i! j!) (1-t)^i t^j */
static inline dvec d_bezier(const n3_edge *e, double t)
{
    double s = 1 - t;
    dvec start = d_mix(s * s * s, wide(e->p[0]), 3 * s * s * t, wide(e->p[1]));
    dvec end = d_mix(3 * s * t * t, wide(e->p[2]), t * t * t, wide(e->p[3]));
    return d_add(start, end);
}

/* A frame that no axis favours, with exact sevenths. */
static inline dvec frame_e(void) { return d_v(2. / 7, 3. / 7, 6. / 7); }
static inline dvec frame_h(void) { return d_v(3. / 7, -6. / 7, 2. / 7); }
static inline dvec frame_m(void) { return d_v(6. / 7, 2. / 7, -3. / 7); }

static inline dvec in_frame(double e, double h, double m)
{
    return d_add(d_mix(e, frame_e(), h, frame_h()), d_mul(m, frame_m()));
}

static inline n3_vertex vertex(dvec x, dvec n)
{
    n3_vertex v;
    v.x = narrow(x);
    v.n = narrow(n);
    return v;
}

/* A chord of length 2 along frame_e, its middle at the origin, and end normals turned by the
 * angles (degrees) from frame_h, so that the end tangents climb by them towards frame_h. */
static inline void planar_ends(double start, double end, n3_vertex *a, n3_vertex *b)
{
    double s = start * DEGREE, t = end * DEGREE;
    *a = vertex(in_frame(-1, 0, 0), in_frame(-sin(s), cos(s), 0));
    *b = vertex(in_frame(1, 0, 0), in_frame(-sin(t), cos(t), 0));
}

#endif
