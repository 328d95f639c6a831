/* closed_forms.c: edges and patches whose exact shape is known: arcs, spheres, cylinders, nearly
 * parallel normals, and the angles at which the paper's rule changes.
 *
 * Curves are evaluated by naive.h; what is tested is where the header puts the control points. The
 * inputs are rounded, which is half an eps per coordinate, and counts as one of the header's. */
#include "check.h"
#include "naive.h"

enum { SAMPLES = 1000 };

static const n3_options paper = {N3_RULE_PAPER, 0, 0}, arc = {N3_RULE_ARC, 0, 0};

static double on_edge(const n3_edge *e, double t, dvec direction)
{
    return d_dot(d_bezier(e, t), direction);
}

/* ---- Arcs ---- */

/* Where a cubic arc with the handle (2L/3)/(1 + cos a) is farthest from its circle, and an S
 * farthest from its chord: r^2 - 1 is proportional to (t (1-t) (1-2t))^2. */
static double extreme(void) { return (3 - sqrt(3)) / 6; }

/* Half a unit of the last of so many printed digits. */
static double half_digit(double value, int digits)
{
    return pow(10, floor(log10(value)) + 1 - digits) / 2;
}

/* The error 1/2 ulp of a coordinate in n0, n1 turns a tangent by one eps, and the header's handles
 * are good to L (40/q + 2/lo) eps (equations.c), q = cos a; the segment's middle to
 * 8 |c| + 4 L/s. */
static double arc_tolerance(double a)
{
    double L = 2 * sin(a), c = 2 / cos(a);
    return EPS * (2 + L * (40 / cos(a) + 20) + 8 * c + 4 * L / sin(2 * a));
}

static void arc_ends(double a, n3_vertex *v0, n3_vertex *v1)
{
    dvec start = in_frame(-sin(a), cos(a), 0), end = in_frame(sin(a), cos(a), 0);
    *v0 = vertex(start, start);
    *v1 = vertex(end, end);
}

typedef struct arc_row {
    double angle, nagata, paper, arc;
    int arc_digits;
} arc_row;

static const arc_row arcs[] = {
    {10, 7.268e-6, 7.268e-6, 5.1e-10, 2}, {30, 6.010e-4, 6.010e-4, 3.7e-7, 2},
    {60, 1.036e-2, 1.036e-2, 2.39e-5, 3}, {90, 6.066e-2, 6.066e-2, 2.725e-4, 4},
    {120, 0.2500, 0.2500, 1.54e-3, 3},    {150, 1.061, 0.1918, 5.97e-3, 3},
};
enum { ARCS = sizeof arcs / sizeof *arcs };

/* Height of the middle over the unit circle: (cos a + 1/cos a)/2 - 1 for the parabola. Past 60
 * degrees the paper's handles are 2L/3 each, and the middle is sin^2 a above the chord. */
static void arc_by_segment(void)
{
    int i;
    for (i = 0; i < ARCS; i++) {
        double a = arcs[i].angle / 2 * DEGREE, height, tolerance = arc_tolerance(a);
        n3_vertex v0, v1;
        n3_segment s;
        n3_edge e;
        arc_ends(a, &v0, &v1);
        s = n3_segment_make(v0, v1);
        e = n3_segment_raise(&s);
        height = on_edge(&e, 0.5, frame_h()) - 1;
        CHECK_NEAR(height, (cos(a) + 1 / cos(a)) / 2 - 1, tolerance, i);
        CHECK_NEAR(height, arcs[i].nagata, half_digit(arcs[i].nagata, 4) + tolerance, i);
    }
}

static void arc_by_paper_rule(void)
{
    int i;
    for (i = 0; i < ARCS; i++) {
        double a = arcs[i].angle / 2 * DEGREE, height, tolerance = arc_tolerance(a);
        double exact = a < 60.5 * DEGREE ? (cos(a) + 1 / cos(a)) / 2 : cos(a) + sin(a) * sin(a);
        n3_vertex v0, v1;
        n3_edge e;
        arc_ends(a, &v0, &v1);
        e = n3_edge_make(v0, v1, NULL);
        height = on_edge(&e, 0.5, frame_h()) - 1;
        CHECK_NEAR(height, exact - 1, tolerance, i);
        CHECK_NEAR(height, arcs[i].paper, half_digit(arcs[i].paper, 4) + tolerance, i);
    }
}

/* r^2 - 1 is 4/27 sin^6(a/2) / cos^2(a/2) at most, and 0 in the middle. The products of the arc
 * rule cost some 16 eps, and m = (n0 + n1)/|n0 + n1| is good to 4 eps / cos a. */
static void arc_by_arc_rule(void)
{
    int i;
    for (i = 0; i < ARCS; i++) {
        double a = arcs[i].angle / 2 * DEGREE, handle = 4. / 3 * tan(a / 2), error;
        double tolerance = EPS * (16 + 4 / cos(a)), s = sin(a / 2), c = cos(a / 2);
        n3_vertex v0, v1;
        n3_edge e;
        arc_ends(a, &v0, &v1);
        e = n3_edge_make(v0, v1, &arc);
        CHECK_VEC(e.p[1], narrow(d_add(wide(v0.x), in_frame(handle * cos(a), handle * sin(a), 0))),
                  tolerance, i);
        CHECK_VEC(e.p[2], narrow(d_add(wide(v1.x), in_frame(-handle * cos(a), handle * sin(a), 0))),
                  tolerance, i);
        CHECK_NEAR(on_edge(&e, 0.5, frame_h()), 1, tolerance, i);
        error = d_len(d_bezier(&e, extreme())) - 1;
        CHECK_NEAR(error, sqrt(1 + 4. / 27 * pow(s, 6) / (c * c)) - 1, tolerance, i);
        CHECK_NEAR(error, arcs[i].arc, half_digit(arcs[i].arc, arcs[i].arc_digits) + tolerance, i);
    }
}

/* The known circle handle 4 (sqrt 2 - 1)/3. */
static void arc_of_a_quarter_circle(void)
{
    dvec x = d_v(1, 0, 0), y = d_v(0, 1, 0);
    double k = 4 * (sqrt(2) - 1) / 3;
    n3_edge e = n3_edge_make(vertex(x, x), vertex(y, y), &arc);
    CHECK_VEC(e.p[1], narrow(d_v(1, k, 0)), 20 * EPS, 0);
    CHECK_VEC(e.p[2], narrow(d_v(k, 1, 0)), 20 * EPS, 0);
}

/* ---- Spheres and cylinders ---- */

static void sphere_octant(void)
{
    static const double net[10][3] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {3, 2, 0}, {2, 3, 0},
                                      {0, 3, 2}, {0, 2, 3}, {2, 0, 3}, {3, 0, 2}, {2, 2, 2}};
    dvec x = d_v(1, 0, 0), y = d_v(0, 1, 0), z = d_v(0, 0, 1);
    n3_patch p = n3_patch_make(vertex(x, x), vertex(y, y), vertex(z, z), NULL);
    n3_vec middle = n3_patch_point(&p, (n3_real)1 / 3, (n3_real)1 / 3);
    double tolerance = EPS * (1 + sqrt(2) * (40 / sqrt(0.5) + 20));
    int k;
    for (k = 0; k < 10; k++)
        CHECK_VEC(p.p[k], narrow(d_mul(1. / 3, d_v(net[k][0], net[k][1], net[k][2]))), tolerance,
                  k);
    CHECK_NEAR(d_len(wide(middle)), 5 * sqrt(3) / 9, tolerance, 0);
    CHECK_NEAR(d_len(wide(middle)), 0.9622504486, 5e-11 + tolerance, 0);
}

/* The largest distance from the unit sphere, and angle in degrees between normals, of a patch. */
typedef struct sphere_error {
    double distance, angle;
} sphere_error;

static void sphere_patch_error(const n3_patch *p, sphere_error *worst)
{
    int i, j;
    for (i = 0; i <= 24; i++) {
        for (j = 0; i + j <= 24; j++) {
            n3_real u = (n3_real)i / 24, v = (n3_real)j / 24;
            dvec x = wide(n3_patch_point(p, u, v)), n = wide(n3_patch_normal(p, u, v));
            double angle = atan2(d_len(d_cross(n, x)), d_dot(n, x)) / DEGREE;
            worst->distance = fmax(worst->distance, fabs(d_len(x) - 1));
            worst->angle = fmax(worst->angle, angle);
        }
    }
}

/* The triangle a b c on the unit sphere, split in four so often at the middles of its sides. */
static void sphere_split(dvec a, dvec b, dvec c, int times, const n3_options *o,
                         sphere_error *worst)
{
    if (times) {
        dvec ab = d_unit(d_add(a, b)), bc = d_unit(d_add(b, c)), ca = d_unit(d_add(c, a));
        sphere_split(a, ab, ca, times - 1, o, worst);
        sphere_split(ab, b, bc, times - 1, o, worst);
        sphere_split(ca, bc, c, times - 1, o, worst);
        sphere_split(ab, bc, ca, times - 1, o, worst);
    } else {
        n3_patch p = n3_patch_make(vertex(a, a), vertex(b, b), vertex(c, c), o);
        sphere_patch_error(&p, worst);
    }
}

/* One face of the icosahedron stands for all. At size s = 2^-times points are good to 200 eps s + 2
 * eps and derivatives, of length s, to that as well: the angle to (200 + 3/s) eps. */
static void sphere_order(void)
{
    static const struct {
        const n3_options *o;
        int times;
        double distance;
        int distance_digits;
        double angle;
        int angle_digits;
    } row[] = {{&paper, 0, 1.311e-2, 4, 6.03, 3}, {&paper, 1, 1.259e-3, 4, 1.04, 3},
               {&paper, 2, 8.94e-5, 3, 0.144, 3}, {&paper, 3, 5.78e-6, 3, 0.0185, 3},
               {&arc, 0, 8.51e-4, 3, 0.207, 3},   {&arc, 1, 2.04e-5, 3, 9.64e-3, 3},
               {&arc, 2, 3.62e-7, 3, 3.55e-4, 3}, {&arc, 3, 5.86e-9, 3, 1.17e-5, 3}};
    double g = (1 + sqrt(5)) / 2;
    dvec a = d_unit(d_v(0, 1, g)), b = d_unit(d_v(g, 0, 1)), c = d_unit(d_v(1, g, 0));
    int i;
    for (i = 0; i < (int)(sizeof row / sizeof *row); i++) {
        sphere_error got = {0, 0};
        double size = pow(2, -row[i].times);
        sphere_split(a, b, c, row[i].times, row[i].o, &got);
        CHECK_NEAR(got.distance, row[i].distance,
                   half_digit(row[i].distance, row[i].distance_digits) + (200 * size + 2) * EPS, i);
        CHECK_NEAR(got.angle, row[i].angle,
                   half_digit(row[i].angle, row[i].angle_digits) + (200 + 3 / size) * EPS / DEGREE,
                   i);
    }
}

/* Edges between points of the unit cylinder, alpha apart around it and slope alpha along it: under
 * the arc rule the distance from it is of sixth order, 64 for each halving. In float the second
 * halving is below the rounding of 16 eps. */
static void cylinder_order(void)
{
    static const double slope[] = {0, 0.25, 0.5, 1, 2};
    int halvings = EPS < 1e-10 ? 3 : 1, i, k, t;
    for (i = 0; i < (int)(sizeof slope / sizeof *slope); i++) {
        double before = 0;
        for (k = 0; k <= halvings; k++) {
            double alpha = 2 * pow(2, -k), error = 0;
            dvec n = in_frame(cos(alpha), sin(alpha), 0);
            n3_vertex a = vertex(frame_e(), frame_e());
            n3_vertex b = vertex(d_mix(1, n, slope[i] * alpha, frame_m()), n);
            n3_edge e = n3_edge_make(a, b, &arc);
            for (t = 0; t <= 64; t++) {
                dvec x = d_bezier(&e, t / 64.);
                double height = d_dot(x, frame_m());
                error = fmax(error, fabs(d_len(d_mix(1, x, -height, frame_m())) - 1));
            }
            if (k) CHECK(before > 50 * (error - 16 * EPS), 10 * i + k);
            if (k) CHECK(before < 80 * (error + 16 * EPS), 10 * i + k);
            before = error;
        }
    }
}

/* ---- Nearly parallel normals ---- */

/* The largest distance of the curve from the first axis, on which its chord lies: a C has it in the
 * middle, an S at the extreme; other places are looked at all the same. */
static double largest_height(const n3_edge *e)
{
    double height = 0;
    int i;
    for (i = 0; i <= 33; i++) {
        double t = i < 33 ? i / 32. : extreme();
        dvec x = d_bezier(e, t);
        height = fmax(height, hypot(x.y, x.z));
    }
    return height;
}

/* A unit chord tilted by A against both tangent planes, the normals turned by delta around it. */
static void tilted_ends(double A, double delta, n3_vertex *a, n3_vertex *b)
{
    double s = sin(A * DEGREE), c = cos(A * DEGREE), turn = delta * DEGREE;
    *a = vertex(d_v(0, 0, 0), d_v(-s, 0, c));
    *b = vertex(d_v(1, 0, 0), d_v(-s, -c * sin(turn), c * cos(turn)));
}

/* Nagata's |c| is tan A / sin(delta/2) exactly, the height a quarter of it: tan A / (2 delta). With
 * s the normals' sine the header is good to 16 |c| + 6/s eps, |c| <= 2/s; rounding the normals by
 * half an eps turns them towards each other by as much, a relative error of 2/s. */
static void near_parallel_segment(void)
{
    static const double tilt[] = {5, 20, 40}, delta[] = {10, 1, 0.1, 0.01};
    int i, k;
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 4; k++) {
            double A = tan(tilt[i] * DEGREE), turn = delta[k] * DEGREE, height, s;
            n3_vertex a, b;
            n3_segment curve;
            n3_edge e;
            tilted_ends(tilt[i], delta[k], &a, &b);
            s = d_len(d_cross(wide(a.n), wide(b.n)));
            curve = n3_segment_make(a, b);
            e = n3_segment_raise(&curve);
            height = largest_height(&e);
            CHECK_NEAR(height / (A / (4 * sin(turn / 2))), 1, EPS * (16 + 8 / s), 10 * i + k);
            CHECK_NEAR(height / (A / (2 * turn)), 1, turn * turn / 20 + EPS * (16 + 8 / s),
                       10 * i + k);
            if (i == 0 && k == 3) CHECK_NEAR(height, 251, 0.5 + 251 * EPS * (16 + 8 / s), 0);
        }
    }
}

/* The cubics are S curves in the plane halfway between the normals, of height sqrt(3)/18 times
 * tan A / cos(delta/2) by the paper's rule and, with M the length of (n0 + n1)/2,
 * sin A cos A cos(delta/2) / M^2 by the arc rule; so also at delta = 0, and within 0.6 % of that up
 * to 10 degrees. Tolerance: a unit chord, q = cos A, by arc_tolerance's first part. */
static void near_parallel_cubic(void)
{
    static const double delta[] = {0, 1e-9, 1e-6, 1e-4, 0.01, 0.1, 1, 10};
    static const struct {
        double tilt, printed, digit;
    } row[] = {{5, 0.00842, 5e-6}, {20, 0.0350, 5e-5}, {40, 0.0807, 5e-5}, {0.1, 0, 1}, {59, 0, 1}};
    int i, k;
    for (i = 0; i < (int)(sizeof row / sizeof *row); i++) {
        double S = sin(row[i].tilt * DEGREE), C = cos(row[i].tilt * DEGREE);
        double parallel = sqrt(3) / 18 * S / C, tolerance = EPS * (22 + 40 / C);
        for (k = 0; k < (int)(sizeof delta / sizeof *delta); k++) {
            double turn = cos(delta[k] / 2 * DEGREE), M = hypot(S, C * turn), height;
            n3_vertex a, b;
            n3_edge by_paper, by_arc;
            tilted_ends(row[i].tilt, delta[k], &a, &b);
            by_paper = n3_edge_make(a, b, NULL);
            by_arc = n3_edge_make(a, b, &arc);
            height = largest_height(&by_paper);
            CHECK_NEAR(height, parallel / turn, tolerance, 10 * i + k);
            CHECK_NEAR(height, parallel, 0.006 * parallel + tolerance, 10 * i + k);
            CHECK_NEAR(largest_height(&by_arc), sqrt(3) / 18 * S * C * turn / (M * M), tolerance,
                       10 * i + k);
            if (k == 0 && row[i].printed > 0)
                CHECK_NEAR(height, row[i].printed, row[i].digit + tolerance, i);
        }
    }
}

/* ---- The paper's edge: its plane, where it is the parabola, where it changes ---- */

/* As planar_ends, and then each normal turned by twist around the chord, the two away from each
 * other. */
static void twisted_ends(double start, double end, double twist, n3_vertex *a, n3_vertex *b)
{
    double s = start * DEGREE, e = end * DEGREE, w = twist * DEGREE;
    *a = vertex(in_frame(-1, 0, 0), in_frame(-sin(s), cos(s) * cos(w), cos(s) * sin(w)));
    *b = vertex(in_frame(1, 0, 0), in_frame(-sin(e), cos(e) * cos(w), -cos(e) * sin(w)));
}

/* Pi halves the smaller angle between the normals' directions around the chord, taken as lines. */
static void plane_bisects(void)
{
    static const struct {
        double start, end, start_tilt, end_tilt, plane;
    } row[] = {{0, 60, 0, 0, 30},     {0, 120, 0, 0, 150}, {10, -10, 30, -50, 0},
               {20, 200, 40, 40, 20}, {0, 89, 0, 0, 44.5}, {0, 91, 0, 0, 135.5},
               {33, 0, 0, 90, 33},    {0, 33, -90, 0, 33}, {5, 185, 10, 10, 5},
               {300, 20, 0, 0, 340},  {7, 7, 80, -80, 7},  {0, 271, 60, 0, 315.5}};
    int i;
    for (i = 0; i < (int)(sizeof row / sizeof *row); i++) {
        double s = row[i].start * DEGREE, e = row[i].end * DEGREE, p = row[i].plane * DEGREE, q;
        double S = row[i].start_tilt * DEGREE, E = row[i].end_tilt * DEGREE;
        n3_vertex a =
            vertex(in_frame(-1, 0, 0), in_frame(sin(S), cos(s) * cos(S), sin(s) * cos(S)));
        n3_vertex b = vertex(in_frame(1, 0, 0), in_frame(sin(E), cos(e) * cos(E), sin(e) * cos(E)));
        dvec m = wide(n3_curve_plane(a, b)), want = in_frame(0, -sin(p), cos(p));
        if (d_dot(m, want) < 0) want = d_mul(-1, want);
        q = fmin(fabs(cos(S)) > 0.01 ? fabs(cos(S)) : 1, fabs(cos(E)) > 0.01 ? fabs(cos(E)) : 1);
        CHECK_VEC(narrow(m), narrow(want), EPS * (2 + 8 / q), i);
    }
}

/* The raised parabola is the edge where both tangents' angles lie between the cut-off and 60
 * degrees, they make a C, and its plane is Pi: with no twist, or equal angles. Elsewhere it is not,
 * by a visible amount. Tolerance: arc_tolerance's, at 60 degrees, and as the segment's c depends on
 * two normals 11 degrees apart. */
static void parabola_kept(void)
{
    static const struct {
        double start, end, twist;
        int kept;
    } row[] = {{20, -20, 0, 1},   {6, -6, 0, 1},    {59.9, -59.9, 0, 1}, {10, -50, 0, 1},
               {6, -59, 0, 1},    {-30, 45, 0, 1},  {20, -20, 30, 1},    {-30, 30, 44, 1},
               {10, -10, -40, 1}, {50, -50, 15, 1}, {5, -20, 0, 0},      {50, -3, 0, 0},
               {66, -20, 0, 0},   {-20, 66, 0, 0},  {70, -70, 0, 0},     {20, 20.5, 0, 0},
               {10, 50, 0, 0},    {20, -20, 50, 0}, {20, -40, 20, 0},    {-30, 25, -10, 0}};
    double tolerance = arc_tolerance(60 * DEGREE) + EPS * (40 / sin(11 * DEGREE)) * 2;
    int i;
    for (i = 0; i < (int)(sizeof row / sizeof *row); i++) {
        n3_vertex a, b;
        n3_segment s;
        n3_edge e, raised;
        double off;
        twisted_ends(row[i].start, row[i].end, row[i].twist, &a, &b);
        s = n3_segment_make(a, b);
        raised = n3_segment_raise(&s);
        e = n3_edge_make(a, b, NULL);
        off = fmax(d_len(d_sub(wide(e.p[1]), wide(raised.p[1]))),
                   d_len(d_sub(wide(e.p[2]), wide(raised.p[2]))));
        if (row[i].kept)
            CHECK_NEAR(off, 0, tolerance, i);
        else
            CHECK(off > 0.01, i);
    }
}

/* Equal tilts make an S, symmetric about the middle of the chord; under the paper's rule also when
 * the normals are twisted apart. */
static void s_shaped(void)
{
    static const struct {
        double tilt, twist;
        const n3_options *o;
    } row[] = {{0, 0, &paper},  {3, 0, &paper},    {-20, 0, &paper}, {40, 20, &paper},
               {70, 0, &paper}, {-80, 40, &paper}, {0, 0, &arc},     {3, 0, &arc},
               {-20, 0, &arc},  {80, 0, &arc}};
    int i;
    for (i = 0; i < (int)(sizeof row / sizeof *row); i++) {
        double tilt = row[i].tilt * DEGREE, tolerance = EPS * (22 + 80 / cos(tilt)), climb;
        n3_vertex a, b;
        n3_edge e;
        twisted_ends(row[i].tilt, row[i].tilt, row[i].twist, &a, &b);
        e = n3_edge_make(a, b, row[i].o);
        CHECK_VEC(narrow(d_add(wide(e.p[1]), wide(e.p[2]))), n3_v(0, 0, 0), tolerance, i);
        climb = on_edge(&e, 0.25, frame_h());
        CHECK(row[i].tilt > 0 || row[i].tilt < 0 ? climb * tilt > 0 : fabs(climb) <= tolerance, i);
        CHECK_NEAR(on_edge(&e, 0.25, frame_m()), 0, tolerance, i);
    }
}

/* Planar ends whose tangents leave the chord, of length 2, at the angles start and end, in degrees,
 * after they were turned to at most 90; the handles by (5.1.13) and (5.1.14) for them. */
typedef struct turn {
    double start, end, lo, hi, turned_start, turned_end;
} turn;

static double handle(double here, double other, const turn *row)
{
    double own = fmin(fmax(tan(fabs(here) * DEGREE), row->lo), row->hi);
    double facing = fmin(fmax(tan(fabs(other) * DEGREE), row->lo), row->hi);
    return facing / (own + facing) * 4 / 3 * fmin(1 / cos(here * DEGREE), 2);
}

static void check_turns(const turn *row, int rows)
{
    int i;
    for (i = 0; i < rows; i++) {
        double start = row[i].turned_start, end = row[i].turned_end, q = 1;
        double ds = handle(start, end, &row[i]), de = handle(end, start, &row[i]);
        n3_options o = {N3_RULE_PAPER, 0, 0};
        n3_vertex a, b;
        n3_edge e;
        o.tan_lo = (n3_real)row[i].lo;
        o.tan_hi = (n3_real)row[i].hi;
        if (fabs(cos(row[i].start * DEGREE)) > 1e-3) q = fmin(q, fabs(cos(row[i].start * DEGREE)));
        if (fabs(cos(row[i].end * DEGREE)) > 1e-3) q = fmin(q, fabs(cos(row[i].end * DEGREE)));
        planar_ends(row[i].start, row[i].end, &a, &b);
        e = n3_edge_make(a, b, &o);
        start *= DEGREE, end *= DEGREE;
        CHECK_VEC(e.p[1], narrow(in_frame(ds * cos(start) - 1, ds * sin(start), 0)),
                  EPS * (1 + 80 / q + 4 / row[i].lo), i);
        CHECK_VEC(e.p[2], narrow(in_frame(1 - de * cos(end), -de * sin(end), 0)),
                  EPS * (1 + 80 / q + 4 / row[i].lo), i);
    }
}

/* At 60 degrees the handle is 2L/3 times its share, and stays so beyond: no jump. */
static void branch_at_60_degrees(void)
{
    static const turn row[] = {
        {50, -50, .1, 10, 50, -50},         {59.999, -59.999, .1, 10, 59.999, -59.999},
        {60, -60, .1, 10, 60, -60},         {60.001, -60.001, .1, 10, 60.001, -60.001},
        {75, -75, .1, 10, 75, -75},         {59.999, 30, .1, 10, 59.999, 30},
        {60, 30, .1, 10, 60, 30},           {60.001, 30, .1, 10, 60.001, 30},
        {-20, 59.999, .1, 10, -20, 59.999}, {-20, 60.001, .1, 10, -20, 60.001},
        {-20, 80, .1, 10, -20, 80},         {70, 65, .1, 10, 70, 65}};
    check_turns(row, (int)(sizeof row / sizeof *row));
}

/* Beyond 90 degrees a tangent would run against the chord and is turned about; at 90 exactly, the
 * normal along the chord, it goes to the side that makes a C. */
static void branch_at_90_degrees(void)
{
    static const turn row[] = {{89.9, -30, .1, 10, 89.9, -30},  {90, -30, .1, 10, 90, -30},
                               {90.1, -30, .1, 10, -89.9, -30}, {100, -30, .1, 10, -80, -30},
                               {90, 30, .1, 10, -90, 30},       {-90, 30, .1, 10, -90, 30},
                               {-90.1, 30, .1, 10, 89.9, 30},   {-30, 89.9, .1, 10, -30, 89.9},
                               {-30, 90, .1, 10, -30, 90},      {-30, 90.1, .1, 10, -30, -89.9},
                               {30, 90, .1, 10, 30, -90},       {30, -90, .1, 10, 30, -90},
                               {150, 20, .1, 10, -30, 20},      {180, 45, .1, 10, 0, 45},
                               {130, -130, .1, 10, -50, 50}};
    check_turns(row, (int)(sizeof row / sizeof *row));
}

/* Tangents on both sides of the cut-offs; 5.7106 and 84.2894 degrees are 0.1 and 10. */
static void angles_at_the_clamps(void)
{
    static const turn row[] = {{0, -45, .1, 10, 0, -45},       {5.7, -45, .1, 10, 5.7, -45},
                               {5.71, 20, .1, 10, 5.71, 20},   {5.72, 20, .1, 10, 5.72, 20},
                               {-8, 3, .1, 10, -8, 3},         {2, -1, .1, 10, 2, -1},
                               {84, -20, .1, 10, 84, -20},     {84.3, -20, .1, 10, 84.3, -20},
                               {-20, 84.2, .1, 10, -20, 84.2}, {-20, 89, .1, 10, -20, 89},
                               {89, 88, .1, 10, 89, 88},       {2, 88, .1, 10, 2, 88},
                               {30, -50, .5, 1, 30, -50},      {20, -50, .5, 1, 20, -50},
                               {20, 50, 1, 1, 20, 50},         {0.1, -5, 1e-3, 10, 0.1, -5},
                               {89, -89.5, .1, 50, 89, -89.5}, {90, 20, .1, 50, -90, 20}};
    check_turns(row, (int)(sizeof row / sizeof *row));
}

/* Where two answers are as good as each other, on the unit chord along x, which is in canonical
 * order: normals perpendicular around the chord have the plane of the sum of e x n0 and e x n1; an
 * end at 90 degrees facing one at 0 starts towards the other's normal, or comes down from it. */
static void ties(void)
{
    static const struct {
        double n0[3], n1[3], p21[3], p12[3];
    } row[] = {{{0, 1, 0}, {0, 0, 1}, {1. / 3, 0, 0}, {2. / 3, 0, 0}},
               {{1, 0, 0}, {0, 0, 1}, {0, 0, 4. / 303}, {103. / 303, 0, 0}},
               {{0, 0, 1}, {-1, 0, 0}, {200. / 303, 0, 0}, {1, 0, 4. / 303}}};
    n3_vec diagonal = narrow(d_unit(d_v(0, -1, 1)));
    int i;
    for (i = 0; i < 3; i++) {
        const double *n0 = row[i].n0, *n1 = row[i].n1, *p = row[i].p21, *q = row[i].p12;
        n3_vertex a = vertex(d_v(0, 0, 0), d_v(n0[0], n0[1], n0[2]));
        n3_vertex b = vertex(d_v(1, 0, 0), d_v(n1[0], n1[1], n1[2]));
        n3_edge e = n3_edge_make(a, b, NULL);
        CHECK_VEC(e.p[1], narrow(d_v(p[0], p[1], p[2])), 8 * EPS, i);
        CHECK_VEC(e.p[2], narrow(d_v(q[0], q[1], q[2])), 8 * EPS, i);
        if (i == 0) CHECK_VEC(n3_curve_plane(a, b), diagonal, EPS, i);
    }
}

/* ---- Options ---- */

/* Each row is the same as the next one, bit for bit; the last as none at all. */
static void option_fields(void)
{
    static const struct {
        n3_options o, same;
    } row[] = {{{N3_RULE_PAPER, 0, 0}, {N3_RULE_PAPER, (n3_real)1 / 10, 10}},
               {{N3_RULE_PAPER, -1, 0}, {N3_RULE_PAPER, 0, -2}},
               {{N3_RULE_PAPER, 0, 2}, {N3_RULE_PAPER, (n3_real)1 / 10, 2}},
               {{N3_RULE_PAPER, (n3_real)1 / 2, 0}, {N3_RULE_PAPER, (n3_real)1 / 2, 10}},
               {{N3_RULE_PAPER, 1, (n3_real)1 / 2}, {N3_RULE_PAPER, 1, 1}},
               {{N3_RULE_PAPER, 20, 0}, {N3_RULE_PAPER, 20, 20}},
               {{N3_RULE_ARC, 3, 4}, {N3_RULE_ARC, 0, 0}},
               {{N3_RULE_FIT, 0, 0}, {N3_RULE_ARC, 0, 0}}};
    rng r = {5};
    int i, j, k;
    for (i = 0; i < (int)(sizeof row / sizeof *row); i++) {
        for (j = 0; j < 50; j++) {
            n3_vertex v[3];
            n3_patch p, q;
            for (k = 0; k < 3; k++) v[k] = vertex(wide(rng_vec(&r)), wide(rng_unit(&r)));
            p = n3_patch_make(v[0], v[1], v[2], &row[i].o);
            q = n3_patch_make(v[0], v[1], v[2], &row[i].same);
            for (k = 0; k < 10; k++) CHECK_SAME(p.p[k], q.p[k], i);
            if (i) continue;
            q = n3_patch_make(v[0], v[1], v[2], NULL);
            for (k = 0; k < 10; k++) CHECK_SAME(p.p[k], q.p[k], i);
        }
    }
}

/* ---- The centre ---- */

/* Three random edges that meet at the corners. */
static void random_edges(rng *r, n3_edge e[3])
{
    int i, k;
    for (i = 0; i < 3; i++)
        for (k = 0; k < 4; k++) e[i].p[k] = rng_vec(r);
    for (i = 0; i < 3; i++) e[i].p[3] = e[(i + 1) % 3].p[0];
}

/* PN triangles put the centre at E + (E - V)/2, E the mean of the six points between the corners, V
 * that of the corners. Coordinates up to 1, as eq_6_1_10. */
static void centre_is_pn(void)
{
    rng r = {111};
    long i, count = sample_count(SAMPLES);
    int j;
    for (i = 0; i < count; i++) {
        n3_edge e[3];
        dvec E = d_v(0, 0, 0), V = d_v(0, 0, 0);
        random_edges(&r, e);
        for (j = 0; j < 3; j++) {
            V = d_mix(1, V, 1. / 3, wide(e[j].p[0]));
            E = d_mix(1, E, 1. / 6, d_add(wide(e[j].p[1]), wide(e[j].p[2])));
        }
        CHECK_VEC(n3_patch_centre(&e[0], &e[1], &e[2]), narrow(d_mix(1.5, E, -0.5, V)), 6 * EPS, i);
    }
}

/* (6.1.10) - K (A_ab v_c + A_bc v_a + A_ca v_b), with x_i, v_i the corners and normals less their
 * means, A_ij = (<x_i, v_j> + <x_j, v_i>)/2, K = (12 sum k^2 - 3)/64, k = 1/(1 + |n_i + n_j|/2) */
static dvec arc_centre_along(const n3_edge e[3], const n3_vec n[3])
{
    dvec x[3], v[3], xm = d_v(0, 0, 0), vm = d_v(0, 0, 0), C = d_v(0, 0, 0);
    double K = -3. / 64;
    int i;
    for (i = 0; i < 3; i++) {
        xm = d_mix(1, xm, 1. / 3, wide(e[i].p[0]));
        vm = d_mix(1, vm, 1. / 3, wide(n[i]));
        C = d_mix(1, C, 1. / 4, d_add(wide(e[i].p[1]), wide(e[i].p[2])));
        K += 12. / 64 / pow(1 + d_len(d_add(wide(n[i]), wide(n[(i + 1) % 3]))) / 2, 2);
    }
    for (i = 0; i < 3; i++) x[i] = d_sub(wide(e[i].p[0]), xm), v[i] = d_sub(wide(n[i]), vm);
    C = d_mix(1, C, -0.5, xm);
    for (i = 0; i < 3; i++) {
        double A = (d_dot(x[i], v[(i + 1) % 3]) + d_dot(x[(i + 1) % 3], v[i])) / 2;
        C = d_mix(1, C, -A * K, v[(i + 2) % 3]);
    }
    return C;
}

/* C + h N by the normals in the middles of the edges; *q is the smallest length that is divided by
 * on the way. */
static dvec arc_centre(const n3_edge e[3], const n3_vec n[3], const n3_vec mid[3], double *q)
{
    dvec C = arc_centre_along(e, n), N = d_add(wide(n[0]), d_add(wide(n[1]), wide(n[2])));
    double rc = 0, cc = 0, low;
    int i;
    *q = d_len(N);
    low = 0.75 * fmax(1, 1 / (16 * *q * *q)); /* the move fades below |N| = 1/4 */
    N = d_unit(N);
    for (i = 0; i < 3; i++) {
        const n3_vec *p = e[i].p;
        dvec m = d_unit(wide(mid[i])), t, qe;
        double r, c;
        t = d_sub(d_add(wide(p[2]), wide(p[3])), d_add(wide(p[0]), wide(p[1])));
        m = d_mix(1, m, -d_dot(m, d_unit(t)), d_unit(t));
        *q = fmin(*q, fmin(d_len(t), d_len(m)));
        m = d_unit(m);
        qe = d_mix(0.5, wide(e[(i + 1) % 3].p[1]), 0.5, wide(e[(i + 2) % 3].p[2]));
        r = d_dot(m, d_sub(d_sub(d_mul(2, d_bezier(&e[i], 0.5)), qe), C));
        c = d_dot(m, N);
        rc += r * c, cc += c * c;
    }
    return d_mix(1, C, rc / fmax(cc, low), N);
}

/* The centre of the arc rule as it is defined, for random curves and normals. Coordinates are up to
 * 1: C is good to 12 eps, N and the n_e to 8/q each, |q_e - C| <= 8, so each r c to 12 + 8 * 16/q
 * and h to three of these over 3/4, and twice as much by cc: 8 (12 + 128/q). */
static void centre_by_arc_rule(void)
{
    rng r = {112};
    long i, count = sample_count(SAMPLES);
    for (i = 0; i < count; i++) {
        n3_vec n[3], mid[3];
        n3_edge e[3];
        double q;
        dvec want;
        int k, given = (int)(i % 2);
        random_edges(&r, e);
        for (k = 0; k < 3; k++) n[k] = rng_unit(&r);
        for (k = 0; k < 3; k++)
            mid[k] = given ? rng_vec(&r) : narrow(d_add(wide(n[k]), wide(n[(k + 1) % 3])));
        want = arc_centre(e, n, mid, &q);
        if (q < 0.125) continue;
        CHECK_VEC(n3_patch_centre_arc(&e[0], &e[1], &e[2], n, given ? mid : NULL), narrow(want),
                  8 * (12 + 128 / q) * EPS, i);
    }
}

#define TEST(name) {#name, name}

const test_case tests_closed_forms[] = {
    TEST(arc_by_segment),       TEST(arc_by_paper_rule),
    TEST(arc_by_arc_rule),      TEST(arc_of_a_quarter_circle),
    TEST(sphere_octant),        TEST(sphere_order),
    TEST(cylinder_order),       TEST(near_parallel_segment),
    TEST(near_parallel_cubic),  TEST(plane_bisects),
    TEST(parabola_kept),        TEST(s_shaped),
    TEST(branch_at_60_degrees), TEST(branch_at_90_degrees),
    TEST(angles_at_the_clamps), TEST(ties),
    TEST(option_fields),        TEST(centre_is_pn),
    TEST(centre_by_arc_rule),   {NULL, NULL},
};
