/* golden_gen.c: prints tests/golden.csv, reference values for nagata3.h, computed in __float128
 * (113 bits) from the geometry: planes, their intersections, angles and rotations. It shares no
 * formula and no line with the header; what a number means is in the paper, how it is found here
 * is not. The inputs are seeded, so the file is the same wherever it is made.
 *
 *     gcc -O2 -o build/golden_gen tests/golden_gen.c -lquadmath
 *     build/golden_gen > tests/golden.csv */
#include <math.h>
#include <quadmath.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

__extension__ typedef __float128 quad;

enum { MAX_IN = 64, MAX_OUT = 24, NET = 10 };
enum { BOTH, DOUBLE }; /* the precisions a row is for */
enum { NO_NORMAL = 999 };

typedef struct vec {
    quad x, y, z;
} vec;
typedef struct vertex {
    vec x, n;
} vertex;

static quad power2(int e) { return scalbnq(1, e); }
static quad pi(void) { return acosq(-1); }
static quad degrees(quad angle) { return angle * pi() / 180; }

static vec v(quad x, quad y, quad z)
{
    vec a;
    a.x = x;
    a.y = y;
    a.z = z;
    return a;
}

static vec add(vec a, vec b) { return v(a.x + b.x, a.y + b.y, a.z + b.z); }
static vec sub(vec a, vec b) { return v(a.x - b.x, a.y - b.y, a.z - b.z); }
static vec mul(quad s, vec a) { return v(s * a.x, s * a.y, s * a.z); }
static vec mix(quad t, vec a, vec b) { return add(a, mul(t, sub(b, a))); }
static quad dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static quad largest(vec a) { return fmaxq(fabsq(a.x), fmaxq(fabsq(a.y), fabsq(a.z))); }
static quad length(vec a) { return hypotq(hypotq(a.x, a.y), a.z); }
static int is_zero(vec a) { return !(largest(a) > 0); }

static vec cross(vec a, vec b)
{
    return v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static vec unit(vec a) { return is_zero(a) ? a : mul(1 / length(a), a); }

/* The angle between two vectors, 0 to pi, accurate at both ends. */
static quad angle(vec a, vec b) { return atan2q(length(cross(a, b)), dot(a, b)); }

/* The acute angle between a vector and a line; a zero vector lies along every line. */
static quad angle_to_line(vec a, vec along)
{
    quad t = angle(a, along);
    return fminq(t, pi() - t);
}

/* a turned about a unit axis, right-handed. */
static vec rotate(vec a, vec axis, quad t)
{
    vec fixed = mul(dot(a, axis), axis), across = sub(a, fixed);
    return add(fixed, add(mul(cosq(t), across), mul(sinq(t), cross(axis, across))));
}

/* ---- The segment: two tangent planes and the foot of a perpendicular (condition C). ---- */

/* Drops x on the tangent plane at a, then slides it inside that plane, across the intersection,
 * to the tangent plane at b. Both moves are orthogonal to the intersection of the planes. */
static vec foot_on_intersection(vec x, vertex a, vertex b)
{
    quad dihedral = angle(a.n, b.n);
    vec down = sub(x, mul(dot(sub(x, a.x), a.n), a.n));
    vec slope = cross(unit(cross(a.n, b.n)), a.n);
    return sub(down, mul(dot(sub(down, b.x), b.n) / sinq(dihedral), slope));
}

/* The middle control point; with parallel planes, the middle of the chord. */
static vec segment_middle(vertex a, vertex b)
{
    vec middle = mix((quad)1 / 2, a.x, b.x);
    if (is_zero(a.n) || is_zero(b.n) || angle_to_line(a.n, b.n) <= power2(-50)) return middle;
    return foot_on_intersection(middle, a, b);
}

/* c from (2.1.9). */
static vec curvature(vertex a, vertex b)
{
    return mul(2, sub(mix((quad)1 / 2, a.x, b.x), segment_middle(a, b)));
}

/* ---- The curve plane: half planes about the chord and their azimuths. ---- */

/* A right-handed frame with the chord's direction last. */
typedef struct frame {
    vec f, g, e;
} frame;

static vec least_axis(vec a)
{
    if (fabsq(a.x) <= fabsq(a.y) && fabsq(a.x) <= fabsq(a.z)) return v(1, 0, 0);
    return fabsq(a.y) <= fabsq(a.z) ? v(0, 1, 0) : v(0, 0, 1);
}

static frame frame_about(vec e)
{
    frame r;
    r.e = unit(e);
    r.f = unit(cross(r.e, least_axis(e)));
    r.g = cross(r.e, r.f);
    return r;
}

static quad azimuth(const frame *r, vec n) { return atan2q(dot(n, r->g), dot(n, r->f)); }

static int is_along(vec n, vec e) { return is_zero(n) || angle_to_line(n, e) <= power2(-40); }

/* The azimuth of Pi's half plane nearest to a normal of a: the plane Pi_0 of the chord and a's
 * normal, turned about the chord by half of the dihedral angle that it makes with Pi_1. */
static quad plane_azimuth(const frame *r, vec n0, vec n1)
{
    quad dihedral;
    if (is_along(n0, r->e)) return azimuth(r, n1);
    if (is_along(n1, r->e)) return azimuth(r, n0);
    dihedral = azimuth(r, n1) - azimuth(r, n0);
    return azimuth(r, n0) + (dihedral - pi() * roundq(dihedral / pi())) / 2;
}

static vec plane_normal(const frame *r, vec n0, vec n1)
{
    return rotate(r->f, r->e, plane_azimuth(r, n0, n1) + pi() / 2);
}

/* ---- The cubic edge, the paper's rule. ---- */

/* A normal of zero length gives way to the other end's, made orthogonal to the chord. */
static void replace_missing(vertex *a, vertex *b)
{
    frame r = frame_about(sub(b->x, a->x));
    if (is_zero(a->n) && !is_along(b->n, r.e)) a->n = rotate(r.f, r.e, azimuth(&r, b->n));
    if (is_zero(b->n) && !is_along(a->n, r.e)) b->n = rotate(r.f, r.e, azimuth(&r, a->n));
}

/* The direction in which Pi meets a tangent plane, turned along the chord. */
static vec tangent(vec m, vec n, vec e)
{
    vec t = unit(cross(m, n));
    return dot(t, e) < 0 ? mul(-1, t) : t;
}

/* The way to the handle of an end whose tangent is upright: to the side of the chord on which the
 * other handle lies, else to the side of the other end's normal. */
static vec upright(const frame *r, vec n, vec other_handle)
{
    vec side = sub(other_handle, mul(dot(other_handle, r->e), r->e));
    if (length(side) <= power2(-100)) side = sub(n, mul(dot(n, r->e), r->e));
    return unit(side);
}

static quad clamp(quad theta, quad lo, quad hi)
{
    return fmaxq(atanq(lo), fminq(atanq(hi), theta));
}

/* (5.1.13): the apex of the triangle with the clamped base angles divides the chord; the handle
 * is two thirds of the way, along the tangent, to the point above it. Beyond 60 degrees no such
 * division: twice the share of the chord itself. */
static quad handle(quad here, quad other, quad lo, quad hi, quad chord)
{
    quad base = clamp(here, lo, hi), top = clamp(other, lo, hi);
    quad share = chord * sinq(top) * cosq(base) / sinq(base + top);
    return here <= pi() / 3 ? 2 * share / (3 * cosq(here)) : 4 * share / 3;
}

static void edge_straight(vertex a, vertex b, vec p[2])
{
    p[0] = mix((quad)1 / 3, a.x, b.x);
    p[1] = mix((quad)2 / 3, a.x, b.x);
}

static void edge_paper(vertex a, vertex b, quad lo, quad hi, vec p[2])
{
    frame r = frame_about(sub(b.x, a.x));
    quad chord = length(sub(b.x, a.x)), s = pi() / 2, e = pi() / 2;
    vec m, t0, t1;
    replace_missing(&a, &b);
    edge_straight(a, b, p);
    if (is_along(a.n, r.e) && is_along(b.n, r.e)) return;
    m = plane_normal(&r, a.n, b.n);
    t0 = tangent(m, a.n, r.e);
    t1 = mul(-1, tangent(m, b.n, r.e)); /* both from the end inwards */
    if (is_along(a.n, r.e))
        t0 = upright(&r, b.n, t1);
    else
        s = angle(t0, r.e);
    if (is_along(b.n, r.e))
        t1 = upright(&r, a.n, t0);
    else
        e = pi() - angle(t1, r.e);
    p[0] = add(a.x, mul(handle(s, e, lo, hi, chord), t0));
    p[1] = add(b.x, mul(handle(e, s, lo, hi, chord), t1));
}

/* ---- The arc rule: half angles and rotations about the axis of the two normals. ---- */

/* The chord's part orthogonal to the bisector of the normals, what runs across the axis lengthened
 * by 1 / cos^2 of a quarter of the angle between them, is turned about the axis by half of that
 * angle into each tangent plane; a third of it is the handle. */
static void edge_arc(vertex a, vertex b, vec p[2])
{
    vec d = sub(b.x, a.x), axis, bisector, flat, bent;
    quad turn, quarter;
    replace_missing(&a, &b);
    edge_straight(a, b, p);
    if (is_along(a.n, d) && is_along(b.n, d)) return;
    turn = angle(a.n, b.n);
    if (pi() - turn <= power2(-26)) {
        edge_paper(a, b, (quad)1 / 10, 10, p);
        return;
    }
    axis = unit(cross(a.n, b.n));
    bisector = rotate(a.n, axis, turn / 2);
    flat = sub(d, mul(dot(d, bisector), bisector));
    quarter = cosq(turn / 4);
    bent = mul(1 / (quarter * quarter), sub(flat, mul(dot(flat, axis), axis)));
    flat = add(mul(dot(flat, axis), axis), bent);
    p[0] = add(a.x, mul((quad)1 / 3, rotate(flat, axis, -turn / 2)));
    p[1] = sub(b.x, mul((quad)1 / 3, rotate(flat, axis, turn / 2)));
}

/* ---- Bezier curves and triangles by blossoms. ---- */

/* The weights of a, b and c: of a point they sum to 1, of a direction to 0. */
typedef struct weights {
    quad a, b, c;
} weights;

static const weights corners[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* Half of r s + q t. */
static weights weights_mix(weights s, weights t, quad r, quad q)
{
    s.a = (r * s.a + q * t.a) / 2;
    s.b = (r * s.b + q * t.b) / 2;
    s.c = (r * s.c + q * t.c) / 2;
    return s;
}

static weights at(quad u, quad v)
{
    weights s;
    s.a = 1 - u - v;
    s.b = u;
    s.c = v;
    return s;
}

/* Where b^i c^j a^k stands in the order of the control points. */
static int slot(int degree, int i, int j)
{
    static const int cubic[4][4] = {{0, 8, 7, 2}, {3, 9, 6, 0}, {4, 5, 0, 0}, {1, 0, 0, 0}};
    static const int quadratic[3][3] = {{0, 5, 2}, {3, 4, 0}, {1, 0, 0}};
    return degree == 3 ? cubic[i][j] : quadratic[i][j];
}

/* De Casteljau's algorithm, with other weights in each step. */
static vec blossom(const vec *net, int degree, const weights *s)
{
    vec q[4][4];
    int step, i, j;
    for (i = 0; i <= degree; i++)
        for (j = 0; i + j <= degree; j++) q[i][j] = net[slot(degree, i, j)];
    for (step = 0; step < degree; step++)
        for (i = 0; i < degree - step; i++)
            for (j = 0; i + j < degree - step; j++)
                q[i][j] = add(mul(s[step].a, q[i][j]),
                              add(mul(s[step].b, q[i + 1][j]), mul(s[step].c, q[i][j + 1])));
    return q[0][0];
}

/* The blossom of a cubic at the point p, its last `order` arguments replaced by d and e. */
static vec derivative(const vec *net, weights p, int order, weights d, weights e)
{
    weights s[3];
    s[0] = p;
    s[1] = order > 1 ? e : p;
    s[2] = order > 0 ? d : p;
    return mul(order == 2 ? 6 : order == 1 ? 3 : 1, blossom(net, 3, s));
}

static vec curve_blossom(const vec p[4], quad r, quad s, quad t)
{
    vec ab = mix(r, p[0], p[1]), bc = mix(r, p[1], p[2]), cd = mix(r, p[2], p[3]);
    return mix(t, mix(s, ab, bc), mix(s, bc, cd));
}

static vec curve_point(const vec p[4], quad t) { return curve_blossom(p, t, t, t); }

/* ---- Patches. ---- */

/* The side of a patch that leaves corner i, to the next corner or back to the one before. */
static void side(const vec *net, int i, int back, vec p[4])
{
    int j, k = (i + 2) % 3, first = back ? 3 + 2 * k : 3 + 2 * i;
    for (j = 0; j < 2; j++) p[1 + j] = net[back ? first + 1 - j : first + j];
    p[0] = net[i];
    p[3] = net[back ? k : (i + 1) % 3];
}

/* S_1, S_2 and S_3 rule between the two sides at a corner, equally far from it; in the middle of
 * the triangle that is two thirds of the way. S = (S_1 + S_2 + S_3 - S_4) / 2, and p111 is what
 * the cubic net lacks to reach it. */
static vec centre_coons(const vec *net)
{
    vec s = v(0, 0, 0), rest = s, p[4];
    int i;
    for (i = 0; i < 6; i++) {
        side(net, i / 2, i % 2, p);
        s = add(s, mul((quad)1 / 2, curve_point(p, (quad)2 / 3)));
        rest = add(rest, mul((quad)3, net[3 + i]));
    }
    for (i = 0; i < 3; i++) {
        s = sub(s, mul((quad)1 / 3, net[i]));
        rest = add(rest, net[i]);
    }
    return mul((quad)1 / 6, sub(mul((quad)27 / 2, s), rest));
}

/* The cubic form <x, n> n, x and n linear in the weights of the three corners. */
static vec cubic_form(const vec x[3], const vec n[3], int a, int b, int c)
{
    vec p = add(mul(a, x[0]), add(mul(b, x[1]), mul(c, x[2])));
    vec q = add(mul(a, n[0]), add(mul(b, n[1]), mul(c, n[2])));
    return mul(dot(p, q), q);
}

/* Its value at three different corners, by polarization: inclusion and exclusion over sums. */
static vec polar_form(const vec x[3], const vec n[3])
{
    vec sum = v(0, 0, 0);
    int set;
    for (set = 1; set < 8; set++) {
        int a = set & 1, b = set >> 1 & 1, c = set >> 2;
        sum = add(sum, mul((a + b + c) % 2 ? 1 : -1, cubic_form(x, n, a, b, c)));
    }
    return mul((quad)1 / 6, sum);
}

static vec centre_tangential(const vec *net, const vec n[3], vec coons)
{
    vec x[3], w[3], x_mean = v(0, 0, 0), n_mean = x_mean;
    quad stretch = 0;
    int i;
    for (i = 0; i < 3; i++) {
        quad handle = 1 / (1 + length(add(n[i], n[(i + 1) % 3])) / 2);
        stretch += handle * handle;
        x_mean = add(x_mean, mul((quad)1 / 3, net[i]));
        n_mean = add(n_mean, mul((quad)1 / 3, n[i]));
    }
    for (i = 0; i < 3; i++) {
        x[i] = sub(net[i], x_mean);
        w[i] = sub(n[i], n_mean);
    }
    return sub(coons, mul((stretch - (quad)1 / 4) * 9 / 16, polar_form(x, w)));
}

/* The part, along the wanted normal of side i, of the derivative across its middle. */
static quad miss(const vec *net, vec wanted, int i)
{
    weights from = corners[i], to = corners[(i + 1) % 3], middle = weights_mix(from, to, 1, 1);
    weights along = weights_mix(to, from, 2, -2);
    weights across = weights_mix(corners[(i + 2) % 3], middle, 2, -2);
    vec t = unit(derivative(net, middle, 1, along, along));
    vec n = unit(sub(wanted, mul(dot(wanted, t), t)));
    return 2 * dot(n, derivative(net, middle, 1, across, across)) / 3;
}

/* How far the patch with this centre misses the wanted normals: squares, added. */
static quad misfit(const vec *net, vec centre, const vec mid[3])
{
    vec q[NET];
    quad sum = 0;
    int i;
    memcpy(q, net, sizeof q);
    q[9] = centre;
    for (i = 0; i < 3; i++) {
        quad m = miss(q, mid[i], i);
        sum += m * m;
    }
    return sum;
}

/* The centre on a line along the mean normal where the misfit, a parabola, is least; its
 * curvature held from below, the more the nearer the normals come to cancelling. */
static vec centre_arc(const vec *net, const vec n[3], const vec mid[3])
{
    vec c = centre_tangential(net, n, centre_coons(net));
    vec sum = add(n[0], add(n[1], n[2])), up = unit(sum);
    quad low = fmaxq(1, 1 / (16 * dot(sum, sum))) * 3 / 4;
    quad step = largest(sub(net[1], net[0])) + largest(sub(net[2], net[0]));
    quad here, above, below, bend;
    if (!(step > 0)) return c;
    here = misfit(net, c, mid);
    above = misfit(net, add(c, mul(step, up)), mid);
    below = misfit(net, sub(c, mul(step, up)), mid);
    bend = fmaxq((above - 2 * here + below) / (2 * step * step), low);
    return add(c, mul((below - above) / (4 * step * bend), up));
}

/* Opposite normals have no mean. */
static void sums_of_normals(const vec n[3], vec mid[3])
{
    int i;
    for (i = 0; i < 3; i++) {
        mid[i] = add(n[i], n[(i + 1) % 3]);
        if (length(mid[i]) <= power2(-26)) mid[i] = v(0, 0, 0);
    }
}

/* ---- What a row of the table computes. ---- */

static vec vec_at(const quad *q) { return v(q[0], q[1], q[2]); }

static vertex vertex_at(const quad *q)
{
    vertex a;
    a.x = vec_at(q);
    a.n = unit(vec_at(q + 3));
    return a;
}

static quad *put(quad *out, vec a)
{
    out[0] = a.x;
    out[1] = a.y;
    out[2] = a.z;
    return out + 3;
}

static void read_options(const quad *q, quad *lo, quad *hi)
{
    *lo = q[0] > 0 ? q[0] : (quad)1 / 10;
    *hi = fmaxq(q[1] > 0 ? q[1] : 10, *lo);
}

static void row_segment(const quad *in, quad *out)
{
    put(out, curvature(vertex_at(in), vertex_at(in + 6)));
}

static void row_plane(const quad *in, quad *out)
{
    vertex a = vertex_at(in), b = vertex_at(in + 6);
    frame r = frame_about(sub(b.x, a.x));
    int none = is_along(a.n, r.e) && is_along(b.n, r.e);
    put(out, none ? v(0, 0, 0) : plane_normal(&r, a.n, b.n));
}

static void row_edge_paper(const quad *in, quad *out)
{
    vec p[2];
    quad lo, hi;
    read_options(in, &lo, &hi);
    edge_paper(vertex_at(in + 2), vertex_at(in + 8), lo, hi, p);
    put(put(out, p[0]), p[1]);
}

static void row_edge_arc(const quad *in, quad *out)
{
    vec p[2];
    edge_arc(vertex_at(in), vertex_at(in + 6), p);
    put(put(out, p[0]), p[1]);
}

static void row_patch_nagata(const quad *in, quad *out)
{
    int i;
    for (i = 0; i < 3; i++)
        out = put(out, segment_middle(vertex_at(in + 6 * i), vertex_at(in + 6 * ((i + 1) % 3))));
}

static void row_patch_paper(const quad *in, quad *out)
{
    vec net[NET];
    quad lo, hi;
    int i;
    read_options(in, &lo, &hi);
    for (i = 0; i < 3; i++) {
        vertex a = vertex_at(in + 2 + 6 * i), b = vertex_at(in + 2 + 6 * ((i + 1) % 3));
        net[i] = a.x;
        edge_paper(a, b, lo, hi, net + 3 + 2 * i);
    }
    net[9] = centre_coons(net);
    for (i = 3; i < NET; i++) out = put(out, net[i]);
}

static void arc_net(const quad *in, vec *net, vec n[3])
{
    int i;
    for (i = 0; i < 3; i++) {
        vertex a = vertex_at(in + 6 * i), b = vertex_at(in + 6 * ((i + 1) % 3));
        net[i] = a.x;
        n[i] = a.n;
        edge_arc(a, b, net + 3 + 2 * i);
    }
    net[9] = v(0, 0, 0);
}

static void row_patch_arc(const quad *in, quad *out)
{
    vec net[NET], n[3], mid[3];
    int i;
    arc_net(in, net, n);
    sums_of_normals(n, mid);
    net[9] = centre_arc(net, n, mid);
    for (i = 3; i < NET; i++) out = put(out, net[i]);
}

static void row_centre_arc(const quad *in, quad *out)
{
    vec net[NET], n[3], mid[3];
    int i;
    arc_net(in, net, n);
    for (i = 0; i < 3; i++) mid[i] = vec_at(in + 18 + 3 * i);
    put(out, centre_arc(net, n, mid));
}

static void read_net(const quad *in, vec *net, int count)
{
    int i;
    for (i = 0; i < count; i++) net[i] = vec_at(in + 3 * i);
}

static void row_edge_point(const quad *in, quad *out)
{
    vec p[4];
    read_net(in + 1, p, 4);
    put(out, curve_point(p, in[0]));
}

static void row_edge_jet(const quad *in, quad *out)
{
    vec p[4], end[2][2];
    quad t = in[0];
    int i, j;
    read_net(in + 1, p, 4);
    for (i = 0; i < 2; i++)
        for (j = 0; j < 2; j++) end[i][j] = curve_blossom(p, t, i, j);
    out = put(out, mul(3, sub(curve_blossom(p, t, t, 1), curve_blossom(p, t, t, 0))));
    put(out, mul(6, sub(sub(end[1][1], end[0][1]), sub(end[1][0], end[0][0]))));
}

static void row_point2(const quad *in, quad *out)
{
    vec net[6];
    weights s[2];
    s[0] = s[1] = at(in[0], in[1]);
    read_net(in + 2, net, 6);
    put(out, blossom(net, 2, s));
}

static void row_point(const quad *in, quad *out)
{
    weights s = at(in[0], in[1]);
    vec net[NET];
    read_net(in + 2, net, NET);
    put(out, derivative(net, s, 0, s, s));
}

static void row_jet(const quad *in, quad *out)
{
    static const weights du = {-1, 1, 0}, dv = {-1, 0, 1};
    weights s = at(in[0], in[1]);
    vec net[NET];
    read_net(in + 2, net, NET);
    out = put(out, derivative(net, s, 1, du, du));
    out = put(out, derivative(net, s, 1, dv, dv));
    out = put(out, derivative(net, s, 2, du, du));
    out = put(out, derivative(net, s, 2, du, dv));
    put(out, derivative(net, s, 2, dv, dv));
}

static void row_normal(const quad *in, quad *out)
{
    quad jet[15];
    row_jet(in, jet);
    put(out, unit(cross(unit(vec_at(jet)), unit(vec_at(jet + 3)))));
}

/* ---- The table. ---- */

static const char *const header[] = {
    "Reference values for nagata3.h, computed in 113 bits by tests/golden_gen.c.",
    "",
    "Columns: kind, case, precision, size, condition, inputs, outputs.",
    "",
    "  kind         inputs                        outputs",
    "  segment      x0 n0 x1 n1                   c of (2.1.7)",
    "  plane        x0 n0 x1 n1                   unit normal of Pi, up to its sign",
    "  edge_paper   tan_lo tan_hi x0 n0 x1 n1     p21 p12; a limit not above 0 is the default",
    "  edge_arc     x0 n0 x1 n1                   p21 p12",
    "  patch_nagata xa na xb nb xc nc             p101 p110 p011",
    "  patch_paper  tan_lo tan_hi xa na ... nc    p102 p201 p210 p120 p021 p012 p111",
    "  patch_arc    xa na xb nb xc nc             the same",
    "  centre_arc   xa na xb nb xc nc mab mbc mca p111, with wanted normals in the sides' middles",
    "  edge_point   t p30 p21 p12 p03             x(t)",
    "  edge_jet     t p30 p21 p12 p03             x' x''",
    "  point2       u v p002 p200 p020 p101 p110 p011",
    "                                             x(u, v); w = 1 - u - v belongs to p002",
    "  point        u v p003 p300 p030 p102 p201 p210 p120 p021 p012 p111",
    "                                             x(u, v)",
    "  jet          as point                      x_u x_v x_uu x_uv x_vv",
    "  normal       as point                      x_u cross x_v, unit",
    "",
    "x, n, m, p and c are three numbers each. Every input is exact as a double; where the",
    "precision is 'both' it is exact as a float too, but for the normals in rows of the arc",
    "rule, which a program in floats has to round. Normals are unit to the rounding of float or",
    "double; the reference makes them unit before it uses them. Only their directions matter but",
    "to the arc rule, whose normals are therefore unit to the rounding of double. A zero normal",
    "stays zero; a zero wanted normal asks for nothing.",
    "",
    "size is the largest coordinate of the inputs and outputs; for segment and the jets the",
    "largest difference of two points, or output; for unit vectors 1. condition is 1 plus the",
    "sum, over the coordinates of all inputs, of the largest change of an output per change of",
    "that coordinate; outputs count in units of size, points in units of the largest difference",
    "of two points, normals in units of 1.",
};

/* What the inputs are, one letter each: s a number; x a vertex or a control point; n a normal of
 * which only the direction counts; u a unit normal. */
typedef struct kind {
    const char *name, *layout;
    int outputs;
    enum { COORDINATES, DIFFERENCES, DIRECTIONS } unit_of;
    void (*run)(const quad *in, quad *out);
} kind;

static const kind kinds[] = {
    {"segment", "xnxn", 3, DIFFERENCES, row_segment},
    {"plane", "xnxn", 3, DIRECTIONS, row_plane},
    {"edge_paper", "ssxnxn", 6, COORDINATES, row_edge_paper},
    {"edge_arc", "xuxu", 6, COORDINATES, row_edge_arc},
    {"patch_nagata", "xnxnxn", 9, COORDINATES, row_patch_nagata},
    {"patch_paper", "ssxnxnxn", 21, COORDINATES, row_patch_paper},
    {"patch_arc", "xuxuxu", 21, COORDINATES, row_patch_arc},
    {"centre_arc", "xuxuxunnn", 3, COORDINATES, row_centre_arc},
    {"edge_point", "sxxxx", 3, COORDINATES, row_edge_point},
    {"edge_jet", "sxxxx", 6, DIFFERENCES, row_edge_jet},
    {"point2", "ssxxxxxx", 3, COORDINATES, row_point2},
    {"point", "ssxxxxxxxxxx", 3, COORDINATES, row_point},
    {"jet", "ssxxxxxxxxxx", 15, DIFFERENCES, row_jet},
    {"normal", "ssxxxxxxxxxx", 3, DIRECTIONS, row_normal},
};

static const kind *kind_named(const char *name)
{
    const kind *k = kinds;
    while (strcmp(k->name, name) != 0) k++;
    return k;
}

static int width(char letter) { return letter == 's' ? 1 : 3; }

static int inputs(const kind *k)
{
    const char *c;
    int n = 0;
    for (c = k->layout; *c; c++) n += width(*c);
    return n;
}

/* To the nearest float or double, so that a reader of that precision has the very same number;
 * what rounding left beside a zero of a normal becomes zero. */
static void round_inputs(const kind *k, int precision, quad *in)
{
    const char *c;
    int n;
    for (c = k->layout; *c; c++)
        for (n = width(*c); n--; in++) {
            int normal = *c == 'n' || *c == 'u';
            if (normal && fabsq(*in) < power2(-60)) *in = 0;
            if (precision == BOTH && *c != 'u')
                *in = (quad)(float)*in;
            else
                *in = (quad)(double)*in;
        }
}

/* The largest coordinate of the points, or of their differences. */
static quad extent(const kind *k, const quad *in, int differences)
{
    const char *c;
    vec lo = v(0, 0, 0), hi = lo;
    int first = differences;
    for (c = k->layout; *c; in += width(*c++)) {
        vec a;
        if (*c != 'x') continue;
        a = vec_at(in);
        if (first) lo = hi = a;
        lo = v(fminq(lo.x, a.x), fminq(lo.y, a.y), fminq(lo.z, a.z));
        hi = v(fmaxq(hi.x, a.x), fmaxq(hi.y, a.y), fmaxq(hi.z, a.z));
        first = 0;
    }
    return differences ? largest(sub(hi, lo)) : fmaxq(largest(lo), largest(hi));
}

static quad row_size(const kind *k, const quad *in, const quad *out)
{
    quad size = k->unit_of == DIRECTIONS ? 1 : extent(k, in, k->unit_of == DIFFERENCES);
    int i;
    for (i = 0; i < k->outputs; i++) size = fmaxq(size, fabsq(out[i]));
    return size;
}

/* The largest change of an output per change of input i. */
static quad sensitivity(const kind *k, const quad *in, int i, quad unit_in)
{
    quad moved[MAX_IN], up[MAX_OUT], down[MAX_OUT], worst = 0, h = unit_in * power2(-70);
    int j;
    memcpy(moved, in, sizeof moved);
    moved[i] = in[i] + h;
    k->run(moved, up);
    moved[i] = in[i] - h;
    k->run(moved, down);
    for (j = 0; j < k->outputs; j++) worst = fmaxq(worst, fabsq(up[j] - down[j]));
    return worst * power2(69);
}

static quad condition(const kind *k, const quad *in, quad size)
{
    const char *c;
    quad sum = size;
    int i = 0, n;
    for (c = k->layout; *c; i += width(*c++)) {
        quad by = *c == 'x' ? extent(k, in, 1) : 1;
        if (*c == 's' || (*c != 'x' && is_zero(vec_at(in + i)))) continue;
        for (n = 0; n < 3; n++) sum += sensitivity(k, in, i + n, by);
    }
    return size > 0 ? sum / size : 1;
}

static void print_number(quad x, quad size)
{
    char text[64];
    if (fabsq(x) <= size * power2(-90)) x = 0;
    quadmath_snprintf(text, sizeof text, "%.21Qg", x);
    printf(",%s", text);
}

static void emit(const char *kind_name, const char *name, int precision, const quad *given)
{
    const kind *k = kind_named(kind_name);
    quad in[MAX_IN] = {0}, out[MAX_OUT], size;
    int i, n = inputs(k);
    memcpy(in, given, (size_t)n * sizeof *in);
    round_inputs(k, precision, in);
    k->run(in, out);
    size = row_size(k, in, out);
    printf("%s,%s,%s,%.17g,%.4g", k->name, name, precision == BOTH ? "both" : "double",
           (double)size, (double)condition(k, in, size));
    for (i = 0; i < n; i++) printf(",%.17g", (double)in[i]);
    for (i = 0; i < k->outputs; i++) print_number(out[i], size);
    printf("\n");
}

/* ---- The inputs: seeded, on coarse grids, so that they print short. ---- */

static uint64_t state = 20120131;

/* splitmix64 */
static uint64_t next(void)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* -1 to 1, in steps of 2^-10. */
static quad draw(void) { return ((quad)(int)(next() % 2049) - 1024) / 1024; }

static vec draw_vec(void)
{
    quad x = draw(), y = draw(), z = draw();
    return v(x, y, z);
}

static vec draw_unit(void)
{
    vec a = draw_vec();
    while (length(a) > 1 || length(a) < (quad)1 / 4) a = draw_vec();
    return unit(a);
}

/* Where the points of a row lie: offset + scale * (stretch * draw), each a power of two. */
typedef struct setting {
    const char *name;
    int precision, scale, stretch_y, stretch_z;
    double offset;
} setting;

static const setting plain = {"", BOTH, 0, 0, 0, 0};
static const setting settings[] = {
    {" far from the origin", BOTH, 0, 0, 0, 4096},
    {" very far from the origin", DOUBLE, 0, 0, 0, 1073741824},
    {" scaled by 2^-40", BOTH, -40, 0, 0, 0},
    {" scaled by 2^40", BOTH, 40, 0, 0, 0},
    {" scaled by 2^-400", DOUBLE, -400, 0, 0, 0},
    {" scaled by 2^400", DOUBLE, 400, 0, 0, 0},
    {" with mixed exponents", BOTH, 0, -12, 9, 0},
    {" with very mixed exponents", DOUBLE, 0, -30, 25, 0},
};
enum { SETTINGS = sizeof settings / sizeof *settings };

static vec placed(const setting *where, vec a)
{
    a = v(a.x, scalbnq(a.y, where->stretch_y), scalbnq(a.z, where->stretch_z));
    return add(v(where->offset, -where->offset, where->offset / 2), mul(power2(where->scale), a));
}

static vec draw_point(const setting *where) { return placed(where, draw_vec()); }

static vec as_read(vec a, int precision)
{
    if (precision == BOTH) return v((float)a.x, (float)a.y, (float)a.z);
    return v((double)a.x, (double)a.y, (double)a.z);
}

/* A normal by its azimuth about the chord and its lean towards it, degrees. */
static vec leaning(const frame *r, double turn, double lean)
{
    vec radial = rotate(r->f, r->e, degrees(turn));
    if (!(lean < NO_NORMAL)) return v(0, 0, 0);
    return rotate(r->e, cross(radial, r->e), degrees(lean - 90));
}

static void emit_pair(const char *name, const setting *where, int precision, vertex a, vertex b)
{
    quad in[2 + 12] = {0};
    char text[128];
    snprintf(text, sizeof text, "%s%s", name, where->name);
    put(put(put(put(in + 2, a.x), a.n), b.x), b.n);
    emit("segment", text, precision, in + 2);
    emit("plane", text, precision, in + 2);
    emit("edge_paper", text, precision, in);
    emit("edge_arc", text, precision, in + 2);
}

typedef struct pair_case {
    const char *name;
    int precision;
    double turn0, lean0, turn1, lean1; /* of the normals, as leaning() */
} pair_case;

/* A lean of -l at the start and l at the end bends the curve to one side. */
static const pair_case easy[] = {
    {"arc of 10 degrees", BOTH, 0, -5, 0, 5}, {"arc of 90 degrees", BOTH, 0, -45, 0, 45},
    {"uneven arc", BOTH, 0, -20, 0, 35},      {"twisted by 40 degrees", BOTH, 0, -20, 40, 25},
    {"S-shaped", BOTH, 0, 10, 0, 25},         {"one normal reversed", BOTH, 0, -20, 205, 30},
};

static const pair_case hard[] = {
    {"arc of 170 degrees", BOTH, 0, -85, 0, 85},
    {"uneven arc", BOTH, 0, -8, 0, 55},
    {"twisted by 80 degrees", BOTH, 0, -20, 80, 30},
    {"twisted by 100 degrees", BOTH, 0, -20, 100, 30},
    {"twisted by 89.9 degrees", BOTH, 0, -20, 89.9, 30},
    {"S-shaped and twisted", BOTH, 0, 30, 20, 25},
    {"S-shaped and steep", BOTH, 0, 50, 5, 65},
    {"just below 60 degrees", BOTH, 0, -59.999, 0, 30},
    {"just above 60 degrees", BOTH, 0, -60.001, 0, 30},
    {"around 60 degrees", BOTH, 0, -59.9, 10, 60.1},
    {"above 60 degrees", BOTH, 0, 40, 10, 70},
    {"below tan_lo", BOTH, 0, -3, 0, 40},
    {"both below tan_lo", BOTH, 0, -3, 15, 4},
    {"flat", BOTH, 0, 0, 20, 0},
    {"just below tan_lo", BOTH, 0, -5.71, 0, 30},
    {"just above tan_lo", BOTH, 0, -5.712, 0, 30},
    {"just below tan_hi", BOTH, 0, -84.2, 0, 30},
    {"above tan_hi", BOTH, 0, -86, 0, 30},
    {"both above tan_hi", BOTH, 0, -86, 20, 87},
    {"below tan_lo and above tan_hi", BOTH, 0, 3, 20, 87},
    {"near 90 degrees", BOTH, 0, -89.9, 0, 20},
    {"both near 90 degrees", BOTH, 0, -89.9, 30, 89.8},
    {"near-parallel and steep", BOTH, 0, -20, 0.6, -20},
    {"near-parallel by 0.6 degrees", BOTH, 0, -5, 0.6, -5},
    {"near-parallel by 0.01 degrees", BOTH, 0, -5, 0.01, -5},
    {"near-parallel by 5e-5 degrees", BOTH, 0, -20, 5e-5, -20},
    {"near-parallel by 1e-6 degrees", DOUBLE, 0, -20, 1e-6, -20},
    {"near-parallel by 1e-8 degrees", DOUBLE, 0, -40, 1e-8, -40},
    {"near-parallel by 1e-11 degrees", DOUBLE, 0, -40, 1e-11, -40},
    {"near-parallel in lean", BOTH, 0, -5, 0, -5.01},
    {"near-parallel in lean by 1e-8 degrees", DOUBLE, 0, 20, 0, 20.00000001},
    {"near-parallel and flat", BOTH, 0, -0.005, 0, 0.005},
    {"parallel", BOTH, 0, -20, 0, -20},
    {"parallel and flat", BOTH, 30, 0, 30, 0},
    {"near-opposite by 1 degree", BOTH, 0, -20, 181, 20},
    {"near-opposite by 0.03 degrees", BOTH, 0, -20, 180.03, 20},
    {"near-opposite by 1e-3 degrees", DOUBLE, 0, 30, 180.001, -30},
    {"near-opposite by 2e-6 degrees", DOUBLE, 0, 30, 180.000002, -30},
    {"opposite but for 5e-7 degrees", DOUBLE, 0, 30, 180.0000005, -30},
    {"near-opposite in lean", BOTH, 0, 30, 180, -30.2},
    {"opposite", BOTH, 0, 30, 180, -30},
    {"near the chord by 1 degree", BOTH, 0, 89, 10, 20},
    {"near the chord by 0.1 degrees", BOTH, 0, 20, 10, -89.9},
    {"near the chord by 0.002 degrees", BOTH, 0, 89.998, 10, -20},
    {"near the chord by 1e-5 degrees", DOUBLE, 0, 89.99999, 10, 20},
    {"near the chord by 1e-8 degrees", DOUBLE, 0, 30, 10, 89.99999999},
    {"near the chord by 1e-10 degrees", DOUBLE, 0, 90 - 1e-10, 10, 30},
    {"along the chord but for 2e-11 degrees", DOUBLE, 0, 30, 10, 90 - 2e-11},
    {"no first normal", BOTH, 0, NO_NORMAL, 0, 20},
    {"no second normal", BOTH, 0, -35, 0, NO_NORMAL},
    {"no normals", BOTH, 0, NO_NORMAL, 0, NO_NORMAL},
};

/* These need a chord along an axis, where a normal can be exactly parallel to it. */
static const pair_case on_axis[] = {
    {"first normal along the chord", BOTH, 0, 90, 0, 20},
    {"first normal against the chord", BOTH, 0, -90, 30, -20},
    {"second normal along the chord", BOTH, 10, 35, 0, 90},
    {"second normal along and the first flat", BOTH, 10, -2, 0, 90},
    {"first normal along and the second steep", BOTH, 0, 90, 40, 87},
    {"both normals along the chord", BOTH, 0, 90, 0, 90},
    {"normals along the chord and opposite", BOTH, 0, 90, 0, -90},
    {"one normal along and one missing", BOTH, 0, 90, 0, NO_NORMAL},
    {"arc of 60 degrees", BOTH, 0, -30, 0, 30},
};
enum {
    EASY = sizeof easy / sizeof *easy,
    HARD = sizeof hard / sizeof *hard,
    ON_AXIS = sizeof on_axis / sizeof *on_axis
};

static void pair_of_case(const pair_case *c, const setting *where, vec x0, vec x1)
{
    int precision = c->precision == BOTH ? where->precision : DOUBLE;
    vec d = sub(x1, x0);
    frame r = frame_about(is_zero(d) ? v(2, 3, 6) : d);
    vertex a, b;
    a.x = x0;
    b.x = x1;
    a.n = leaning(&r, c->turn0, c->lean0);
    b.n = leaning(&r, c->turn1, c->lean1);
    emit_pair(c->name, where, precision, a, b);
}

static void pair_anywhere(const pair_case *c, const setting *where)
{
    int precision = c->precision == BOTH ? where->precision : DOUBLE;
    vec x0 = as_read(draw_point(where), precision), x1 = as_read(draw_point(where), precision);
    pair_of_case(c, where, x0, x1);
}

static void pairs(void)
{
    static const setting same = {" at coincident points", BOTH, 0, 0, 0, 0};
    static const setting close = {" at close points far from the origin", BOTH, 0, 0, 0, 64};
    int i, j;
    for (i = 0; i < EASY; i++) {
        vec x = draw_point(&plain), y = placed(&close, x);
        pair_anywhere(easy + i, &plain);
        for (j = 0; j < SETTINGS; j++) pair_anywhere(easy + i, settings + j);
        pair_of_case(easy + i, &same, x, x);
        pair_of_case(easy + i, &close, y, add(y, mul(power2(-10), draw_unit())));
    }
    for (i = 0; i < HARD; i++) pair_anywhere(hard + i, &plain);
    for (i = 0; i < ON_AXIS; i++) {
        vec x = draw_point(&plain), d = v(0, 0, 0);
        *(i % 3 == 0 ? &d.x : i % 3 == 1 ? &d.y : &d.z) = i % 2 ? 2 : -(quad)3 / 4;
        pair_of_case(on_axis + i, &plain, x, add(x, d));
    }
    for (i = 0; i < 12; i++) {
        vertex a, b;
        a.x = draw_vec();
        a.n = draw_unit();
        b.x = draw_vec();
        b.n = draw_unit();
        emit_pair("any normals", &plain, BOTH, a, b);
    }
}

/* tan_lo and tan_hi, 0 and below for the defaults, with those of hard[] that they bear on. */
static void options(void)
{
    static const double limits[][2] = {
        {0.25, 2}, {1, 1}, {4, 0.5}, {0, 1.5}, {0.5, 0}, {1.0 / 65536, 65536}, {-1, -1}, {3, 3}};
    static const int chosen[] = {1, 11, 16, 17, 20};
    size_t i, j;
    for (i = 0; i < sizeof limits / sizeof *limits; i++)
        for (j = 0; j < sizeof chosen / sizeof *chosen; j++) {
            const pair_case *c = hard + chosen[j];
            quad in[14] = {limits[i][0], limits[i][1]};
            vec x0 = draw_vec(), x1 = draw_vec();
            frame r = frame_about(sub(x1, x0));
            vec n0 = leaning(&r, c->turn0, c->lean0), n1 = leaning(&r, c->turn1, c->lean1);
            put(put(put(put(in + 2, x0), n0), x1), n1);
            emit("edge_paper", c->name, BOTH, in);
        }
}

/* ---- Triangles. ---- */

typedef enum bend { BULGE, SADDLE, ANY, PARALLEL, OPPOSITE, MISSING } bend;

typedef struct triangle_case {
    const char *name;
    bend how;
    int precision;
    double amount; /* degrees off the triangle's normal, or off each other */
} triangle_case;

static const triangle_case triangle_cases[] = {
    {"bulge of 10 degrees", BULGE, BOTH, 10},
    {"bulge of 40 degrees", BULGE, BOTH, 40},
    {"saddle of 15 degrees", SADDLE, BOTH, 15},
    {"saddle of 35 degrees", SADDLE, BOTH, 35},
    {"any normals", ANY, BOTH, 0},
    {"any normals again", ANY, BOTH, 0},
    {"near-parallel by 0.5 degrees", PARALLEL, BOTH, 0.5},
    {"near-parallel by 1e-3 degrees", PARALLEL, BOTH, 1e-3},
    {"near-parallel by 1e-7 degrees", PARALLEL, DOUBLE, 1e-7},
    {"parallel", PARALLEL, BOTH, 0},
    {"two normals near-opposite by 1 degree", OPPOSITE, BOTH, 1},
    {"two normals opposite", OPPOSITE, BOTH, 0},
    {"no first normal", MISSING, BOTH, 25},
};
enum { TRIANGLES = sizeof triangle_cases / sizeof *triangle_cases };

/* The normal at a corner: the triangle's, leaning away from the middle or about a side. */
static vec corner_normal(const triangle_case *c, const vec x[3], int i)
{
    vec ab = unit(sub(x[1], x[0])), ac = sub(x[2], x[0]), up = unit(cross(ab, ac));
    vec middle = mul((quad)1 / 3, add(x[0], add(x[1], x[2])));
    quad t = degrees(c->amount);
    vec away = unit(cross(up, sub(x[i], middle)));
    vec tilted = rotate(up, ab, degrees(20));
    if (c->how == BULGE) return rotate(up, away, t);
    if (c->how == SADDLE) return rotate(up, away, i == 1 ? -t : t);
    if (c->how == PARALLEL) return rotate(tilted, up, t * i * i);
    if (c->how == OPPOSITE) return i == 1 ? rotate(mul(-1, tilted), up, t) : tilted;
    if (c->how == MISSING) return i == 0 ? v(0, 0, 0) : rotate(up, away, t);
    return draw_unit();
}

/* A collapsed side has no tangent to make its wanted normal orthogonal to; no rows of that. */
static void emit_triangle(const char *name, const setting *where, int precision, const quad *tri)
{
    quad in[2 + 18 + 9] = {0};
    char text[128];
    int i;
    snprintf(text, sizeof text, "%s%s", name, where->name);
    memcpy(in + 2, tri, 18 * sizeof *tri);
    emit("patch_nagata", text, precision, in + 2);
    emit("patch_paper", text, precision, in);
    if (is_zero(sub(vec_at(tri), vec_at(tri + 6)))) return;
    emit("patch_arc", text, precision, in + 2);
    for (i = 0; i < 9; i++) in[20 + i] = tri[6 * (i / 3) + 3 + i % 3] + draw() / 2;
    emit("centre_arc", text, precision, in + 2);
    if (where != &plain) return;
    for (i = 0; i < 9; i++) in[20 + i] = i < 3 && is_zero(vec_at(tri + 3)) ? 0 : draw();
    emit("centre_arc", text, precision, in + 2);
}

static void triangle(const triangle_case *c, const setting *where, const vec local[3])
{
    int i, precision = c->precision == BOTH ? where->precision : DOUBLE;
    quad in[18];
    vec x[3];
    for (i = 0; i < 3; i++) x[i] = as_read(placed(where, local[i]), precision);
    for (i = 0; i < 3; i++) put(put(in + 6 * i, x[i]), corner_normal(c, x, i));
    emit_triangle(c->name, where, precision, in);
}

static void draw_triangle(vec x[3])
{
    int i;
    for (i = 0; i < 3; i++) x[i] = draw_vec();
    if (length(cross(sub(x[1], x[0]), sub(x[2], x[0]))) < (quad)1 / 2) draw_triangle(x);
}

static void triangles(void)
{
    static const setting needle = {" of aspect 1e6", BOTH, 0, 0, 0, 0};
    static const setting collapsed = {" with a collapsed side", BOTH, 0, 0, 0, 0};
    static const setting double_needle = {" of aspect 1e6 unrounded", DOUBLE, 0, 0, 0, 0};
    int i;
    vec x[3];
    for (i = 0; i < TRIANGLES; i++) {
        draw_triangle(x);
        triangle(triangle_cases + i, &plain, x);
    }
    for (i = 0; i < SETTINGS; i++) {
        draw_triangle(x);
        triangle(triangle_cases + i % 4, settings + i, x);
    }
    for (i = 0; i < 4; i++) {
        draw_triangle(x);
        x[0] = v(0, 0, 0);
        x[1] = mul(power2(-20), x[1]);
        triangle(triangle_cases + i, i % 2 ? &needle : &double_needle, x);
    }
    draw_triangle(x);
    x[1] = x[0];
    triangle(triangle_cases + 4, &collapsed, x);
}

/* ---- Control nets: a triangle's lattice, every point shaken. ---- */

static void draw_net(const setting *where, int degree, quad *in)
{
    vec x[3];
    int i, j;
    draw_triangle(x);
    for (i = 0; i <= degree; i++)
        for (j = 0; i + j <= degree; j++) {
            vec p = add(mul(i, x[1]), add(mul(j, x[2]), mul(degree - i - j, x[0])));
            p = add(mul((quad)1 / degree, p), mul((quad)1 / 7, draw_vec()));
            put(in + 3 * slot(degree, i, j), placed(where, p));
        }
}

static void emit_nets(const setting *where, int precision, quad u, quad v)
{
    quad in[2 + 3 * NET];
    char text[64];
    in[0] = u;
    in[1] = v;
    snprintf(text, sizeof text, "net%s", where->name);
    draw_net(where, 3, in + 2);
    emit("point", text, precision, in);
    emit("jet", text, precision, in);
    emit("normal", text, precision, in);
    emit("edge_point", text, precision, in + 1);
    emit("edge_jet", text, precision, in + 1);
    draw_net(where, 2, in + 2);
    emit("point2", text, precision, in);
}

/* u and v in units of 2^-20: corners, sides, the interior, outside. 1 - u - v is exact. */
static void nets(void)
{
    static const int uv[][2] = {
        {0, 0},          {1048576, 0},     {0, 1048576},     {314159, 0},
        {0, 271828},     {365432, 683144}, {349525, 349526}, {123456, 654321},
        {987654, 12345}, {1, 2},           {654321, 234567}, {-262143, 1572865},
    };
    enum { UV = sizeof uv / sizeof *uv };
    int i;
    for (i = 0; i < UV; i++)
        emit_nets(&plain, i % 2 ? DOUBLE : BOTH, (quad)uv[i][0] / 1048576,
                  (quad)uv[i][1] / 1048576);
    for (i = 0; i < SETTINGS; i++)
        emit_nets(settings + i, settings[i].precision, (quad)uv[i + 3][0] / 1048576,
                  (quad)uv[i + 3][1] / 1048576);
}

int main(void)
{
    size_t i;
    for (i = 0; i < sizeof header / sizeof *header; i++)
        printf("#%s%s\n", *header[i] ? " " : "", header[i]);
    pairs();
    options();
    triangles();
    nets();
    return 0;
}
