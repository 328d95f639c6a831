/* accuracy_surface.c: the surfaces and their foot points. */
#include "accuracy.h"

#include <math.h>

static const n3_real two_pi = (n3_real)6.283185307179586477;

static n3_real sine(n3_real x) { return (n3_real)sin((double)x); }
static n3_real cosine(n3_real x) { return (n3_real)cos((double)x); }

/* ---- f = 0 ---- */

/* x^2/a^2 + y^2/b^2 + z^2/c^2 = 1, halved; c = 0 is an infinite c, a cylinder. */
static n3_real f_ellipsoid(const surface *s, n3_vec x, n3_vec *gradient, n3_vec hessian[3])
{
    n3_vec k = n3_v(1 / (s->size[0] * s->size[0]), 1 / (s->size[1] * s->size[1]),
                    s->size[2] > 0 ? 1 / (s->size[2] * s->size[2]) : 0);
    *gradient = n3_v(k.x * x.x, k.y * x.y, k.z * x.z);
    hessian[0] = n3_v(k.x, 0, 0);
    hessian[1] = n3_v(0, k.y, 0);
    hessian[2] = n3_v(0, 0, k.z);
    return (n3_dot(*gradient, x) - 1) / 2;
}

/* (|x|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2), divided by 8 R^2 r */
static n3_real f_torus(const surface *s, n3_vec x, n3_vec *gradient, n3_vec hessian[3])
{
    n3_real R = s->size[0], r = s->size[1], scale = 8 * R * R * r;
    n3_real S = n3_dot(x, x) + R * R - r * r, RR = 8 * R * R;
    n3_vec h = n3_mul(8 / scale, x);
    *gradient = n3_mul(1 / scale, n3_sub(n3_mul(4 * S, x), n3_v(RR * x.x, RR * x.y, 0)));
    hessian[0] = n3_add(n3_mul(x.x, h), n3_v((4 * S - RR) / scale, 0, 0));
    hessian[1] = n3_add(n3_mul(x.y, h), n3_v(0, (4 * S - RR) / scale, 0));
    hessian[2] = n3_add(n3_mul(x.z, h), n3_v(0, 0, 4 * S / scale));
    return (S * S - RR / 2 * (x.x * x.x + x.y * x.y)) / scale;
}

/* z = (x^2 - y^2)/2 */
static n3_real f_saddle(const surface *s, n3_vec x, n3_vec *gradient, n3_vec hessian[3])
{
    (void)s;
    *gradient = n3_v(-x.x, x.y, 1);
    hessian[0] = n3_v(-1, 0, 0);
    hessian[1] = n3_v(0, 1, 0);
    hessian[2] = n3_v(0, 0, 0);
    return x.z - (x.x * x.x - x.y * x.y) / 2;
}

/* z = sin(3 x) cos(2 y)/4 */
static n3_real f_wave(const surface *s, n3_vec x, n3_vec *gradient, n3_vec hessian[3])
{
    n3_real sx = sine(3 * x.x), cx = cosine(3 * x.x), sy = sine(2 * x.y), cy = cosine(2 * x.y);
    (void)s;
    *gradient = n3_v(-3 * cx * cy / 4, sx * sy / 2, 1);
    hessian[0] = n3_v(9 * sx * cy / 4, 3 * cx * sy / 2, 0);
    hessian[1] = n3_v(3 * cx * sy / 2, sx * cy, 0);
    hessian[2] = n3_v(0, 0, 0);
    return x.z - sx * cy / 4;
}

/* ---- Parameters ---- */

/* Round the ellipse with u; v rises by as much as there are cells from 0 to nu/4, each as high as
   one of the circle of mean radius is wide. */
static n3_vec at_cylinder(const surface *s, n3_real u, n3_real v, int nu)
{
    n3_real angle = two_pi * u, mean = (s->size[0] + s->size[1]) / 2;
    n3_real row = 2 * mean * sine(two_pi / (n3_real)(2 * nu));
    return n3_v(s->size[0] * cosine(angle), s->size[1] * sine(angle), row * v * (n3_real)nu / 4);
}

static n3_vec at_torus(const surface *s, n3_real u, n3_real v, int nu)
{
    n3_real a = two_pi * u, b = two_pi * v;
    n3_real rho = s->size[0] + s->size[1] * cosine(b);
    (void)nu;
    return n3_v(rho * cosine(a), rho * sine(a), s->size[1] * sine(b));
}

/* Over the square [-1, 1]^2: f is z less the height. */
static n3_vec at_height(const surface *s, n3_real u, n3_real v, int nu)
{
    n3_vec x = n3_v(2 * u - 1, 2 * v - 1, 0), gradient, hessian[3];
    (void)nu;
    x.z = -s->f(s, x, &gradient, hessian);
    return x;
}

#define PART(a, b) ((n3_real)(a) / (b))
/* The reach is the smallest radius of curvature; the tori's middles are no nearer. */
const surface surfaces[SURFACES] = {
    {"sphere", f_ellipsoid, {1, 1, 1}, 1, NULL, 0, 0, 1, 1, 0, 1},
    {"torus 2, 1", f_torus, {2, 1, 0}, 1, at_torus, 12, 8, 1, 1, 0, 1},
    {"torus 1, .4", f_torus, {1, PART(2, 5), 0}, PART(2, 5), at_torus, 12, 6, 1, 1, 0, 1},
    {"ellipsoid 1, .6, .4", f_ellipsoid, {1, PART(3, 5), PART(2, 5)}, PART(4, 25), NULL,
     0, 0, 1, 1, 0, 0},
    {"cylinder", f_ellipsoid, {1, 1, 0}, 1, at_cylinder, 4, 1, 1, 0, 2, 1},
    {"elliptic cylinder 2:1", f_ellipsoid, {2, 1, 0}, PART(1, 2), at_cylinder, 8, 2, 1, 0, 2, 0},
    {"saddle", f_saddle, {0, 0, 0}, 1, at_height, 4, 4, 0, 0, 2, 0},
    {"wave", f_wave, {0, 0, 0}, PART(4, 9), at_height, 6, 6, 0, 0, 2, 0},
    {"wave and its border", f_wave, {0, 0, 0}, PART(4, 9), at_height, 6, 6, 0, 0, 0, 0},
};

/* ---- Foot points ---- */

/* Newton's method for p - x + l g(p) = 0, f(p) = 0 in p and l, from p and l = 0. With
   A = I + l H a step is dp = -A^-1 (r + g dl), <g, dp> = -f. The rows of A^-1 are c / det A, c the
   cross products of the rows of A, which is symmetric. Converged when the last step, and the error
   of p with it, is below 16 eps. */
static int newton(const surface *s, n3_vec x, n3_vec *p, n3_vec *g)
{
    n3_vec A[3], c[3], r, y, z;
    n3_real l = 0, f, dl, det;
    int i, k;
    for (i = 0; i < 40; i++) {
        f = s->f(s, *p, g, A);
        for (k = 0; k < 3; k++) A[k] = n3_mul(l, A[k]);
        A[0].x += 1;
        A[1].y += 1;
        A[2].z += 1;
        for (k = 0; k < 3; k++) c[k] = n3_cross(A[(k + 1) % 3], A[(k + 2) % 3]);
        det = n3_dot(A[0], c[0]);
        r = n3_add(n3_sub(*p, x), n3_mul(l, *g));
        y = n3_v(n3_dot(c[0], r), n3_dot(c[1], r), n3_dot(c[2], r));
        z = n3_v(n3_dot(c[0], *g), n3_dot(c[1], *g), n3_dot(c[2], *g));
        dl = (f * det - n3_dot(*g, y)) / n3_dot(*g, z);
        y = n3_mul(1 / det, n3_add(y, n3_mul(dl, z)));
        *p = n3_sub(*p, y);
        l += dl;
        if (n3_dot(y, y) <= 256 * N3_EPS * N3_EPS) return 1;
    }
    return 0;
}

/* A foot point nearer than the reach is the nearest one; otherwise the nearest of those found from
   all points of the mesh is taken. */
int surface_foot(const surface *s, const model *m, n3_vec x, n3_vec *foot, n3_vec *normal)
{
    n3_real best = -1;
    int i = -1;
    for (; i < m->mesh.points; i++) {
        n3_vec p = i < 0 ? x : m->point[i], g;
        n3_real distance;
        if (!newton(s, x, &p, &g)) continue;
        distance = n3_len(n3_sub(x, p));
        if (best >= 0 && !(distance < best)) continue;
        best = distance;
        *foot = p;
        *normal = n3_unit(g);
        if (i < 0 && distance < s->reach) break;
    }
    return best >= 0;
}
