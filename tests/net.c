/* The net of a mesh and its refinement: shared edges, creases, no cracks. */
#include "built.h"
#include "samples.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double DEGREE = 3.14159265358979323846 / 180;

static shape polar(int n) { return shape_polar(2 * n, n); }
static shape torus(int n) { return shape_torus(2 * n, n); }

/* A bracket whose normals all differ, by as much as the angle in degrees, and half of whose
   triangles are turned over. */
static shape bracket_in_disorder(int angle)
{
    rng r = {9};
    shape s = shape_bracket(2);
    shape_split_normals(&s);
    shape_tilt_normals(&s, angle * DEGREE, &r);
    shape_flip(&s, &r);
    return s;
}

/* Closed ones. given: all normals are; turned: some of the triangles are turned over. */
static const struct {
    shape (*make)(int);
    int n, given, turned;
} closed[] = {{shape_icosphere, 1, 1, 0},     {torus, 5, 1, 0},
              {shape_bracket, 3, 1, 0},       {shape_cone, 7, 0, 0},
              {shape_hourglass, 5, 0, 0},     {polar, 4, 1, 0},
              {bracket_in_disorder, 1, 1, 1}, {bracket_in_disorder, 3, 1, 1},
              {bracket_in_disorder, 60, 1, 1}};
enum { CLOSED = sizeof closed / sizeof *closed };

/* ---- Edges ---- */

static n3_vertex vertex(n3_vec x, n3_vec n)
{
    n3_vertex v;
    v.x = x;
    v.n = n;
    return v;
}

/* The normal that the first triangle of an edge brings to one of its ends. */
static n3_vec normal_at(const built *b, int edge, int point)
{
    int s = b->t.side[b->t.first[edge]], next = s % 3 == 2 ? s - 2 : s + 1;
    return b->normal[b->corner[b->m.triangle[s] == point ? s : next]];
}

/* Where all triangles bring the same normals the edge is n3_edge_make, bit for bit; up to 8 ulp of
   coordinates below 4 where the compiler may contract one otherwise than the other. */
static void smooth_edges_are_edges(void)
{
    int row, rule, i, k, end[2];
    for (row = 0; row < 6; row++)
        for (rule = 0; rule < 3; rule++) {
            shape s = closed[row].make(closed[row].n);
            built b = build(&s, rule, -1);
            n3_options o = {rule, 0, 0};
            for (i = 0; i < b.t.edges; i++) {
                n3_edge e = built_edge(&b, i), want;
                if (b.flags[i] & (N3_EDGE_CREASE | N3_EDGE_HALF_CREASE)) continue;
                n3_mesh_edge_ends(&b.m, &b.t, i, end);
                want = n3_edge_make(vertex(s.point[end[0]], normal_at(&b, i, end[0])),
                                    vertex(s.point[end[1]], normal_at(&b, i, end[1])), &o);
                for (k = 0; k < 4; k++) CHECK_VEC(e.p[k], want.p[k], CONTRACTED * 32 * EPS, row);
            }
            built_free(&b);
            shape_free(&s);
        }
}

/* A patch is its edges, and its centre by the rule, up to 8 ulp of coordinates below 4: the
   compiler may contract sums here otherwise than there. */
static void check_patch(const built *b, int rule, int triangle, long row)
{
    n3_patch p = built_patch(b, triangle);
    n3_vec n[3], centre;
    n3_edge e[3];
    int node[10], k, q;
    n3_mesh_patch_nodes(&b->m, &b->t, triangle, node);
    n3_patch_edges(&p, e);
    for (k = 0; k < 10; k++) CHECK_SAME(p.p[k], b->net[node[k]], row);
    for (k = 0; k < 3; k++) {
        n3_edge want = {{p.p[k], p.p[k], p.p[k], p.p[k]}};
        int edge = b->t.edge[3 * triangle + k], back = node[k] > node[(k + 1) % 3];
        if (edge >= 0) want = built_edge(b, edge);
        if (back) want = n3_edge_reverse(&want);
        for (q = 0; q < 4; q++) CHECK_SAME(e[k].p[q], want.p[q], row);
        n[k] = b->normal[b->corner[3 * triangle + k]];
    }
    centre = rule == N3_RULE_ARC ? n3_patch_centre_arc(&e[0], &e[1], &e[2], n, NULL)
                                 : n3_patch_centre(&e[0], &e[1], &e[2]);
    CHECK_VEC(p.p[9], centre, 8 * 4 * EPS, row);
}

/* So are all of them, and in a range they are the same. */
static void patches_from_edges(void)
{
    int row, rule, i, k;
    for (row = 0; row < CLOSED; row++)
        for (rule = 0; rule < 2; rule++) {
            shape s = closed[row].make(closed[row].n);
            built b = build(&s, rule, -1);
            n3_patch *range = memory((size_t)s.triangles, sizeof *range);
            n3_mesh_patches(&b.m, &b.t, b.net, 3, s.triangles - 2, range);
            for (i = 0; i < s.triangles; i++) check_patch(&b, rule, i, row);
            for (i = 3; i < s.triangles - 2; i++) {
                n3_patch p = built_patch(&b, i);
                for (k = 0; k < 10; k++) CHECK_SAME(range[i - 3].p[k], p.p[k], row);
            }
            free(range);
            built_free(&b);
            shape_free(&s);
        }
}

/* ---- Creases: the ends of one edge under any normals ---- */

/* Triangles on the edge from (0, 0, 0) to (2, 1, 0), each with its normals at both ends. */
enum { SHEETS = 20 };

typedef struct joint {
    int sheets;
    n3_vec normal[SHEETS][2];
} joint;

static const n3_vec ORIGIN = {0, 0, 0}, FAR_END = {2, 1, 0};

/* Every second triangle runs from the other end, and says with a negative index that a normal is
   zero. The points off the edge have no normals. */
static shape joint_shape(const joint *j)
{
    shape s = shape_sheets(j->sheets);
    int i, k;
    s.normals = 2 * j->sheets;
    s.normal = memory((size_t)s.normals, sizeof *s.normal);
    s.corner = memory(3 * (size_t)s.triangles, sizeof *s.corner);
    s.point[1] = FAR_END;
    for (i = 0; i < j->sheets; i++) {
        for (k = 0; k < 2; k++) {
            int end = i % 2 ? 1 - k : k;
            s.triangle[3 * i + k] = end;
            s.corner[3 * i + k] = 2 * i + end;
            if (i % 2 && same_vec(j->normal[i][end], n3_v(0, 0, 0))) s.corner[3 * i + k] = -1;
            s.normal[2 * i + k] = j->normal[i][k];
        }
        s.corner[3 * i + 2] = -1;
    }
    return s;
}

/* The edge as the net has it; flags may be NULL. */
static n3_edge joint_edge(const joint *j, int rule, unsigned *flags)
{
    shape s = joint_shape(j);
    n3_mesh m = shape_mesh(&s);
    n3_options o = {rule, 0, 0};
    n3_topology t;
    size_t size = n3_mesh_workspace(&m);
    void *work = memory(size, 1);
    n3_vec net[2 + SHEETS + 2 * (2 * SHEETS + 1) + SHEETS];
    unsigned all[2 * SHEETS + 1];
    n3_edge e;
    CHECK(n3_mesh_topology(&m, work, size, &t, NULL) == N3_OK, j->sheets);
    CHECK(n3_mesh_net(&m, &t, &o, net, all, NULL) == N3_OK, j->sheets);
    if (flags) *flags = all[0];
    e.p[0] = net[0];
    e.p[1] = net[m.points];
    e.p[2] = net[m.points + 1];
    e.p[3] = net[1];
    free(work);
    shape_free(&s);
    return e;
}

/* The unit tangents at both ends. */
static void tangents(const n3_edge *e, n3_vec t[2])
{
    t[0] = n3_unit(n3_sub(e->p[1], e->p[0]));
    t[1] = n3_unit(n3_sub(e->p[3], e->p[2]));
}

/* The crease's formulas, plainly: two normals at each end, given by the angle between them about a
   direction c and by the direction of their sum, as far as it can be across c. */
static void crease_normals(n3_vec c, n3_vec sum, double degrees, n3_vec n[2])
{
    n3_vec up = n3_unit(n3_sub(sum, n3_mul(n3_dot(sum, c), c))), side = n3_cross(c, up);
    n3_real x = (n3_real)cos(degrees * DEGREE / 2), y = (n3_real)sin(degrees * DEGREE / 2);
    n[0] = n3_add(n3_mul(x, up), n3_mul(y, side));
    n[1] = n3_sub(n3_mul(x, up), n3_mul(y, side));
}

/* angle: between the normals; off: of the crease off the chord, degrees. share: that of the crease
   in the tangent. */
static const struct {
    double angle, off, share;
} ramp[] = {{0.2, 30, 0},     {1.1, 30, 0},      {2, 30, 0.186}, {3, 30, 0.404}, {5, 30, 0.839},
            {5.7, 30, 0.991}, {5.8, 30, 1},      {45, 30, 1},    {90, 30, 1},    {120, 30, 1},
            {170, 30, 1},     {178.7, 30, 1},    {90, 0, 1},     {90, 60, 1},    {90, 75, 1},
            {90, 80, 0.482},  {90, 89, 0.00487}, {3, 80, 0.195}, {179, 30, 0},   {179.9, 30, 0}};

/* The share, from the angles: sin 1.1 degrees is 0.0192, sin 5.74 is 1/10. */
static double share_of(double angle, double off)
{
    double sine = sin(angle * DEGREE), along = 16 * pow(cos(off * DEGREE), 2);
    if (sine <= 0.02) return 0;
    return fmin(1, angle > 90 ? 1 : (sine - 0.02) / 0.08) * fmin(1, along);
}

/* A cross of normals 1.1 degrees apart is good to 50 eps of its length, the fade multiplies that by
   16 at most. */
static void crease_ramp(void)
{
    size_t i;
    int rule, k;
    n3_vec chord = n3_unit(FAR_END), across = n3_unit(n3_v(-1, 2, 1));
    for (i = 0; i < sizeof ramp / sizeof *ramp; i++)
        for (rule = 0; rule < 2; rule++) {
            double off = ramp[i].off * DEGREE, share = share_of(ramp[i].angle, ramp[i].off);
            n3_vec c = n3_add(n3_mul((n3_real)cos(off), chord), n3_mul((n3_real)sin(off), across));
            n3_vec n[2], flat[2], t[2], want[2], sum, plain[2];
            n3_options o = {rule, 0, 0};
            unsigned flags, crease = N3_EDGE_CREASE | N3_EDGE_HALF_CREASE;
            n3_edge e;
            joint j;
            CHECK_NEAR(share, ramp[i].share, 1e-3, i);
            crease_normals(c, n3_v(0, (n3_real)0.3, 1), ramp[i].angle, n);
            crease_normals(c, n3_v(0, (n3_real)0.3, 1), 0, flat);
            j.sheets = 2;
            for (k = 0; k < 2; k++) j.normal[k][0] = n[k];
            for (k = 0; k < 2; k++) j.normal[k][1] = n3_unit(n3_v(1, 0, 3));
            e = joint_edge(&j, rule, &flags);
            tangents(&e, t);
            sum = flat[0];
            k = n[0].x < n[1].x; /* opposite ones count as the first in order */
            if (ramp[i].angle > 178.9) sum = n3_unit(n3_sub(n[!k], n[k]));
            e = n3_edge_make(vertex(ORIGIN, sum), vertex(FAR_END, j.normal[0][1]), &o);
            tangents(&e, plain);
            want[0] =
                n3_unit(n3_add(n3_mul((n3_real)(1 - share), plain[0]), n3_mul((n3_real)share, c)));
            CHECK_VEC(t[0], want[0], 1e3 * EPS, i);
            CHECK_VEC(t[1], plain[1], 64 * EPS, i);
            CHECK((flags & crease) ==
                      (sin(ramp[i].angle * DEGREE) > 0.02 ? N3_EDGE_HALF_CREASE : 0u),
                  i);
        }
}

/* Creases at both ends, off the chord by alpha and beta, degrees, in one plane. */
static const struct {
    double alpha, beta;
    unsigned flags;
} creased[] = {{20, 40, 0},
               {40, 20, 0},
               {50, 50, 0},
               {2, 45, N3_EDGE_CLAMPED},
               {45, 3, N3_EDGE_CLAMPED},
               {59, 30, 0},
               {61, 30, N3_EDGE_BRANCH_60},
               {30, 70, N3_EDGE_BRANCH_60},
               {-20, 40, N3_EDGE_S_SHAPED},
               {-0.5, 40, N3_EDGE_CLAMPED},
               {40, -0.5, N3_EDGE_CLAMPED},
               {0, 0, N3_EDGE_STRAIGHT}};

/* Their handles: those of the triangle with these angles, with the clamps and the 60 degree branch,
   or two alike of the arc rule. */
static void crease_lengths(const double angle[2], int rule, double d[2])
{
    double tangent[2], L = sqrt(5.0), half = fabs(angle[0] - angle[1]) / 2;
    int k;
    for (k = 0; k < 2; k++) tangent[k] = fmin(fmax(fabs(tan(angle[k])), 0.1), 10);
    for (k = 0; k < 2; k++) {
        double ratio = tangent[1 - k] / (tangent[0] + tangent[1]);
        double stretch = fabs(angle[k]) <= 60 * DEGREE ? 1 / cos(angle[k]) : 2;
        d[k] = rule == N3_RULE_ARC ? 2 * L / 3 / (1 + cos(half)) : ratio * stretch * 2 * L / 3;
    }
}

static void crease_handles(void)
{
    n3_vec e = n3_unit(FAR_END), b = n3_unit(n3_v(-1, 2, 0));
    const unsigned paper = N3_EDGE_CLAMPED | N3_EDGE_BRANCH_60,
                   aside = N3_EDGE_FLIPPED | N3_EDGE_TURNED;
    size_t i;
    int rule, k;
    for (i = 0; i < sizeof creased / sizeof *creased; i++)
        for (rule = 0; rule < 2; rule++) {
            double angle[2], d[2];
            unsigned flags, want = N3_EDGE_CREASE | creased[i].flags;
            n3_vec t[2], n[2];
            n3_edge got;
            joint j;
            angle[0] = creased[i].alpha * DEGREE;
            angle[1] = -creased[i].beta * DEGREE;
            j.sheets = 2;
            for (k = 0; k < 2; k++) {
                t[k] = n3_add(n3_mul((n3_real)cos(angle[k]), e), n3_mul((n3_real)sin(angle[k]), b));
                crease_normals(t[k], n3_v(0, 0, 1), 80, n);
                j.normal[0][k] = n[0];
                j.normal[1][k] = n[1];
            }
            crease_lengths(angle, rule, d);
            got = joint_edge(&j, rule, &flags);
            CHECK_VEC(got.p[1], n3_mul((n3_real)d[0], t[0]), 64 * EPS, i);
            CHECK_VEC(got.p[2], n3_sub(FAR_END, n3_mul((n3_real)d[1], t[1])), 64 * EPS, i);
            CHECK((flags & ~aside) == (rule == N3_RULE_ARC ? want & ~paper : want), i);
        }
}

/* Three sheets at 120 degrees: their normals cancel, the end takes the direction of all three. */
static void three_sheets(void)
{
    int rule, i;
    n3_vec c = n3_unit(n3_v(2, 2, 1)), up = n3_unit(n3_v(1, -1, 0)), side = n3_cross(c, up);
    for (rule = 0; rule < 2; rule++) {
        n3_options o = {rule, 0, 0};
        n3_vec other = n3_unit(n3_v(1, 2, 5)), t[2], want[2];
        joint j;
        n3_edge e, bare = n3_edge_make(vertex(ORIGIN, n3_v(0, 0, 0)), vertex(FAR_END, other), &o);
        j.sheets = 3;
        for (i = 0; i < 3; i++) {
            n3_vec x = n3_mul((n3_real)cos(120 * i * DEGREE), up);
            j.normal[i][0] = n3_add(x, n3_mul((n3_real)sin(120 * i * DEGREE), side));
            j.normal[i][1] = other;
        }
        e = joint_edge(&j, rule, NULL);
        tangents(&e, t);
        tangents(&bare, want);
        CHECK_VEC(t[0], c, 16 * EPS, rule);
        CHECK_VEC(t[1], want[1], 16 * EPS, rule);
    }
}

/* Any normals, zero, equal and opposite ones among them: the edge is finite, no handle is longer
   than 4/3 of the chord, and neither the order of the triangles nor the end that they begin at
   changes a bit. */
static void joints_in_any_order(void)
{
    rng r = {7};
    long i, count = sample_count(3000);
    int k, rule, end;
    for (i = 0; i < count; i++) {
        joint a, b;
        n3_edge e, f;
        a.sheets = b.sheets = 1 + (int)(rng_next(&r) % SHEETS);
        for (k = 0; k < a.sheets; k++)
            for (end = 0; end < 2; end++) {
                int from = (int)(rng_next(&r) % 8);
                n3_vec n = rng_unit(&r);
                if (k > 0 && from < 4) n = a.normal[k - 1][end];
                if (from == 1) n = n3_mul(-1, n);
                if (from == 2) n = n3_unit(n3_add(n, n3_mul((n3_real)1 / 64, rng_vec(&r))));
                if (from == 7) n = n3_v(0, 0, 0);
                a.normal[k][end] = n;
            }
        for (k = 0; k < a.sheets; k++)
            for (end = 0; end < 2; end++) b.normal[k][end] = a.normal[(k * 7 + 3) % a.sheets][end];
        if (a.sheets % 7 == 0) b = a; /* 7 is no step through all of them */
        rule = (int)(i % 2);
        e = joint_edge(&a, rule, NULL);
        f = joint_edge(&b, rule, NULL);
        for (k = 0; k < 4; k++) CHECK_SAME(e.p[k], f.p[k], i);
        CHECK(n3_len(n3_sub(e.p[1], e.p[0])) <= (n3_real)1.34 * n3_len(FAR_END), i);
        CHECK(n3_len(n3_sub(e.p[3], e.p[2])) <= (n3_real)1.34 * n3_len(FAR_END), i);
    }
}

/* Of more than 16 triangles with normals of their own the first 16 count, in the order of x at the
   end that comes first. */
static void joints_of_many(void)
{
    rng r = {16};
    long i, count = sample_count(200);
    int k, rule;
    for (i = 0; i < count; i++) {
        joint all, some;
        n3_edge e, f;
        all.sheets = SHEETS;
        some.sheets = 16;
        for (k = 0; k < SHEETS; k++) {
            int place = (k * 7 + (int)(i % SHEETS)) % SHEETS;
            n3_real x = (n3_real)(place - 10) / 16;
            all.normal[k][0] = n3_unit(n3_v(x, 1, (n3_real)rng_uniform(&r, 0, 0.1)));
            all.normal[k][1] = rng_unit(&r);
            if (place >= 16) continue;
            some.normal[place][0] = all.normal[k][0];
            some.normal[place][1] = all.normal[k][1];
        }
        rule = (int)(i % 2);
        e = joint_edge(&all, rule, NULL);
        f = joint_edge(&some, rule, NULL);
        for (k = 0; k < 4; k++) CHECK_SAME(e.p[k], f.p[k], i);
    }
}

/* On a rim of the bracket the edge is the same as on the circle, in the plane of the lid. The error
   of an arc of angle 2 a is (cos a + 1/cos a)/2 - 1 of the radius by the paper, at its middle, and
   3.7e-7 for 30 degrees by the arc rule, at its worst (0 at the middle). */
static void bracket_rims(void)
{
    int rule, i, k, rims;
    double a = 15 * DEGREE, bulge = 0.6 * ((cos(a) + 1 / cos(a)) / 2 - 1);
    for (rule = 0; rule < 2; rule++) {
        shape s = shape_bracket(3);
        built b = build(&s, rule, -1);
        for (i = rims = 0; i < b.t.edges; i++) {
            n3_edge e = built_edge(&b, i);
            n3_vec x = n3_edge_point(&e, (n3_real)1 / 2);
            double dx = fabs((double)x.x) - 1.4, dy = fabs((double)x.y) - 0.9;
            if (!(b.flags[i] & N3_EDGE_CREASE)) continue;
            for (k = 1; k < 3; k++) CHECK_NEAR(e.p[k].z, e.p[0].z, 4 * EPS, i);
            if (dx < 0.1 || dy < 0.1 || b.flags[i] & N3_EDGE_STRAIGHT) continue;
            rims++;
            CHECK_NEAR(sqrt(dx * dx + dy * dy), 0.6 + (rule == N3_RULE_PAPER ? bulge : 0), 16 * EPS,
                       i);
        }
        CHECK(rims == 2 * 4 * 3, rule);
        built_free(&b);
        shape_free(&s);
    }
}

/* Corner normals of a smooth torus off by 0.17 degrees each: no crease, no turned tangent; the
   handles move by the noise, at the worst tilted by the steepest tangent here, below 45 degrees,
   and in the paper's plane by twice that. */
static void noise_on_seams(void)
{
    int rule, i, k;
    for (rule = 0; rule < 3; rule++) {
        rng r = {8};
        shape s = shape_torus(12, 8);
        built exact = build(&s, rule, -1), b;
        shape_split_normals(&s);
        shape_tilt_normals(&s, 0.17 * DEGREE, &r);
        b = build(&s, rule, -1);
        for (i = 0; i < b.t.edges; i++) {
            n3_edge e = built_edge(&b, i), f = built_edge(&exact, i);
            n3_vec t[2], want[2];
            tangents(&e, t);
            tangents(&f, want);
            CHECK(!(b.flags[i] & (N3_EDGE_CREASE | N3_EDGE_HALF_CREASE)), i);
            for (k = 0; k < 2; k++) CHECK_VEC(t[k], want[k], 2 * sqrt(2.0) * 0.17 * DEGREE, i);
        }
        built_free(&b);
        built_free(&exact);
        shape_free(&s);
    }
}

/* ---- The fit ---- */

/* Six chords know the third derivative of a sphere and of a cylinder to vanish: the wanted normal
   is the mean, whatever the four points. */
static void fit_on_sphere_and_cylinder(void)
{
    rng r = {10};
    long i, count = sample_count(2000);
    int k;
    for (i = 0; i < count; i++) {
        n3_vertex v[4];
        n3_vec mean, mid;
        for (k = 0; k < 4; k++) {
            n3_vec n = rng_unit(&r), x = n;
            if (i % 2) n = n3_unit(n3_v(x.x, x.y, 0));
            if (i % 2) x = n3_v(n.x, n.y, x.z);
            v[k] = vertex(x, n);
        }
        mean = n3_unit(n3_add(v[0].n, v[1].n));
        mid = n3_edge_mid_normal(v[0], v[1], v[2], v[3]);
        /* Right sides of 100 eps over a sum of two normals of 1/50; the ridge, 1/10000 of the
           mean diagonal, lets the solution be no more than 50 times that. */
        if (n3_len(n3_add(v[0].n, v[1].n)) < (n3_real)1 / 50) continue;
        CHECK_VEC(mid, mean, 1e5 * EPS, i);
    }
}

/* A nearly flat surface z = h (p x^3 + q x^2 y + r x y^2 + s y^3) / 6: the normal at the middle of
   the edge, at the origin, is (0, 0, 1), and the mean of the ends' misses it by the edge's share of
   q. The ridge costs 0.28 % of the largest coefficient at most: the sum of its row of
   (A + ridge)^-1 ridge over these places. */
static void fit_on_cubics(void)
{
    rng r = {11};
    long i, count = sample_count(2000);
    int k, swap;
    for (i = 0; i < count; i++) {
        double p[4], h = EPS < 1e-10 ? 1e-6 : 1e-3, slope;
        static const double place[4][2] = {{-1, 0}, {1, 0}, {0.2, 1.8}, {-0.3, -1.6}};
        n3_vertex v[4];
        n3_vec mid, back;
        for (k = 0; k < 4; k++) p[k] = rng_uniform(&r, -1, 1);
        for (k = 0; k < 4; k++) {
            double x = place[k][0] + rng_uniform(&r, -0.1, 0.1) * (k > 1), y = place[k][1];
            double zx = h * (3 * p[0] * x * x + 2 * p[1] * x * y + p[2] * y * y) / 6;
            double zy = h * (p[1] * x * x + 2 * p[2] * x * y + 3 * p[3] * y * y) / 6;
            double z =
                h * (p[0] * x * x * x + p[1] * x * x * y + p[2] * x * y * y + p[3] * y * y * y) / 6;
            v[k] = vertex(n3_v((n3_real)x, (n3_real)y, (n3_real)z),
                          n3_unit(n3_v((n3_real)-zx, (n3_real)-zy, 1)));
        }
        slope = h / 6;
        mid = n3_edge_mid_normal(v[0], v[1], v[2], v[3]);
        CHECK_NEAR(mid.y / mid.z, 0, 0.0028 * slope + 100 * EPS, i);
        swap = (int)(i % 2);
        back = n3_edge_mid_normal(v[1], v[0], v[3], v[2]);
        CHECK_SAME(back, mid, swap);
    }
}

/* Normals that no surface has: the wanted normal is off the mean by 1/4 at most, to both sides. */
static void fit_is_held(void)
{
    rng r = {15};
    long i, count = sample_count(500);
    int k, most[2] = {0, 0};
    for (i = 0; i < count; i++) {
        n3_vertex v[4];
        n3_vec mean, off, side;
        for (k = 0; k < 4; k++) v[k] = vertex(rng_vec(&r), n3_unit(n3_add(rng_vec(&r), FAR_END)));
        mean = n3_unit(n3_add(v[0].n, v[1].n));
        off = n3_sub(n3_edge_mid_normal(v[0], v[1], v[2], v[3]), mean);
        k = v[0].x.x < v[1].x.x; /* sides as seen from the end that comes first */
        side = n3_cross(mean, n3_sub(v[k].x, v[!k].x));
        CHECK(n3_len(off) <= (n3_real)1 / 4 + 4 * N3_EPS, i);
        if (n3_len(off) >= (n3_real)1 / 4 - 4 * N3_EPS) most[n3_dot(off, side) > 0]++;
    }
    CHECK(most[0] > 0 && most[1] > 0, most[0]);
}

/* Largest distance of a torus's patches to it, and largest angle of their normals, degrees. */
static void torus_errors(const built *b, double *distance, double *angle)
{
    int f, i, j;
    *distance = *angle = 0;
    for (f = 0; f < b->m.triangles; f++) {
        n3_patch p = built_patch(b, f);
        for (i = 0; i <= 24; i++)
            for (j = 0; i + j <= 24; j++) {
                n3_real u = (n3_real)i / 24, v = (n3_real)j / 24;
                n3_vec x = n3_patch_point(&p, u, v), n = n3_patch_normal(&p, u, v), out;
                double ring = hypot((double)x.x, (double)x.y), c = 1 - 2 / ring;
                out = n3_v((n3_real)((double)x.x * c), (n3_real)((double)x.y * c), x.z);
                *distance = fmax(*distance, fabs((double)n3_len(out) - 1));
                *angle =
                    fmax(*angle, 2 * asin((double)n3_len(n3_sub(n3_unit(out), n)) / 2) / DEGREE);
            }
    }
}

/* The figures of the rules on a torus, radii 2 and 1, to the digits that they were found with by an
   implementation of its own. */
static void torus_accuracy(void)
{
    static const struct {
        int rule, n;
        double distance, angle;
    } rows[] = {{N3_RULE_PAPER, 4, 1.66e-2, 10.5}, {N3_RULE_PAPER, 8, 9.9e-4, 1.48},
                {N3_RULE_ARC, 4, 4.07e-3, 3.54},   {N3_RULE_ARC, 8, 4.64e-4, 0.746},
                {N3_RULE_FIT, 4, 3.39e-3, 2.62},   {N3_RULE_FIT, 8, 2.01e-4, 0.340}};
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        shape s = shape_torus(3 * rows[i].n, 2 * rows[i].n);
        built b = build(&s, rows[i].rule, -1);
        double distance, angle;
        torus_errors(&b, &distance, &angle);
        CHECK_NEAR(distance, rows[i].distance, 0.005 * rows[i].distance, i);
        CHECK_NEAR(angle, rows[i].angle, 0.005 * rows[i].angle, i);
        built_free(&b);
        shape_free(&s);
    }
}

/* ---- Refinement ---- */

typedef struct refined {
    int points, triangles, normals, *triangle, *corner, *parent;
    n3_vec *point, *normal;
    n3_real *uv;
} refined;

static refined refine(const built *b, int level)
{
    refined r;
    CHECK(n3_mesh_refine_counts(&b->m, &b->t, level, &r.points, &r.triangles, &r.normals) == N3_OK,
          level);
    r.point = memory((size_t)r.points, sizeof *r.point);
    r.triangle = memory(3 * (size_t)r.triangles, sizeof *r.triangle);
    r.normal = memory((size_t)r.normals, sizeof *r.normal);
    r.corner = memory(3 * (size_t)r.triangles, sizeof *r.corner);
    r.parent = memory((size_t)r.points, sizeof *r.parent);
    r.uv = memory(2 * (size_t)r.points, sizeof *r.uv);
    CHECK(n3_mesh_refine(&b->m, &b->t, b->net, level, r.point, r.triangle, r.normal, r.corner,
                         r.parent, r.uv) == N3_OK,
          level);
    return r;
}

static void refined_free(refined *r)
{
    free(r->point);
    free(r->triangle);
    free(r->normal);
    free(r->corner);
    free(r->parent);
    free(r->uv);
}

/* One triangle in two parts, written out. */
static void refined_triangle(void)
{
    static const int triangle[12] = {0, 3, 5, 4, 5, 3, 3, 1, 4, 5, 4, 2};
    static const int corner[12] = {0, 1, 3, 4, 3, 1, 1, 2, 4, 3, 4, 5};
    static const double uv[12] = {0, 0, 1, 0, 0, 1, 0.5, 0, 0.5, 0.5, 0, 0.5};
    shape s = shape_sheets(1);
    built b;
    refined r;
    n3_patch p;
    int i, j, k = 0;
    b = build(&s, N3_RULE_PAPER, -1);
    r = refine(&b, 2);
    p = built_patch(&b, 0);
    CHECK(r.points == 6 && r.triangles == 4 && r.normals == 6, 0);
    for (i = 0; i < 12; i++) {
        CHECK(r.triangle[i] == triangle[i] && r.corner[i] == corner[i], i);
        CHECK(r.parent[i / 2] == 0, i);
        CHECK_NEAR(r.uv[i], uv[i], 0, i);
    }
    for (i = 0; i < 6; i++)
        CHECK_SAME(r.point[i], n3_patch_point(&p, r.uv[2 * i], r.uv[2 * i + 1]), i);
    for (j = 0; j <= 2; k += 3 - j++)
        for (i = 0; i <= 2 - j; i++)
            CHECK_VEC(r.normal[k + i], n3_patch_normal(&p, (n3_real)i / 2, (n3_real)j / 2), 2 * EPS,
                      j);
    refined_free(&r);
    built_free(&b);
    shape_free(&s);
}

/* The surface at a parent's parameters is the point: but for the weights' rounding, which moves it
   by 16 ulp of its coordinates, below 4. The parent is the first triangle whose part has the point,
   and a part's normals are the surface's there, within normal_bound. */
static void check_parents(const built *b, const refined *r, int level, long row)
{
    int i, k, f = -1, live = 0, *first = memory((size_t)r->points, sizeof *first);
    for (i = 0; i < r->points; i++) first[i] = -1;
    for (i = 0; i < r->triangles; i++) {
        n3_patch p;
        if (i == live * level * level) {
            for (f++; b->t.edge[3 * f] < 0 || b->t.edge[3 * f + 1] < 0 || b->t.edge[3 * f + 2] < 0;)
                f++;
            live++;
        }
        p = built_patch(b, f);
        for (k = 3 * i; k < 3 * i + 3; k++) {
            int v = r->triangle[k];
            n3_real *uv = r->uv + 2 * (size_t)v;
            if (first[v] < 0) first[v] = f;
            if (r->parent[v] != f) continue;
            CHECK_VEC(r->point[v], n3_patch_point(&p, uv[0], uv[1]), 64 * EPS, row);
            CHECK_VEC(r->normal[r->corner[k]], n3_patch_normal(&p, uv[0], uv[1]),
                      normal_bound(&p, uv[0], uv[1]), row);
        }
    }
    for (i = 0; i < r->points; i++) CHECK(first[i] < 0 || r->parent[i] <= first[i], row);
    for (i = 0; i < r->points && !b->t.collapsed; i++) CHECK(r->parent[i] == first[i], row);
    free(first);
}

/* A side of a triangle, its points in order, and whether it runs from the lower one. */
typedef struct side {
    int lo, hi, up;
} side;

static int compare_sides(const void *a, const void *b)
{
    const side *p = a, *q = b;
    if (p->lo != q->lo) return p->lo < q->lo ? -1 : 1;
    return p->hi < q->hi ? -1 : p->hi > q->hi;
}

static int compare_points(const void *a, const void *b)
{
    const n3_vec *p = a, *q = b;
    if (p->x < q->x || p->x > q->x) return p->x < q->x ? -1 : 1;
    if (p->y < q->y || p->y > q->y) return p->y < q->y ? -1 : 1;
    return p->z < q->z ? -1 : p->z > q->z;
}

static int compare_to_next(const n3_vec *point) { return compare_points(point, point + 1); }

/* Each side of the refined triangles has one partner, which runs the other way unless triangles are
   turned over; no two points are the same. */
static void check_watertight(const refined *r, int turned, long row)
{
    int sides = 3 * r->triangles, i;
    side *list = memory((size_t)sides, sizeof *list);
    n3_vec *point = memory((size_t)r->points, sizeof *point);
    for (i = 0; i < sides; i++) {
        int a = r->triangle[i], b = r->triangle[i % 3 == 2 ? i - 2 : i + 1];
        list[i].up = a < b;
        list[i].lo = a < b ? a : b;
        list[i].hi = a < b ? b : a;
    }
    qsort(list, (size_t)sides, sizeof *list, compare_sides);
    for (i = 0; i + 1 < sides; i += 2) {
        CHECK(list[i].lo != list[i].hi && compare_sides(&list[i], &list[i + 1]) == 0, row);
        CHECK(turned || list[i].up != list[i + 1].up, row);
        CHECK(i + 2 >= sides || compare_sides(&list[i + 1], &list[i + 2]) != 0, row);
    }
    memcpy(point, r->point, (size_t)r->points * sizeof *point);
    qsort(point, (size_t)r->points, sizeof *point, compare_points);
    for (i = 0; i + 1 < r->points; i++) CHECK(compare_to_next(point + i) < 0, row);
    free(list);
    free(point);
}

/* Closed meshes stay closed, by every rule. */
static void refined_is_watertight(void)
{
    static const int levels[] = {1, 2, 3, 6};
    int row, rule, i;
    for (row = 0; row < CLOSED; row++)
        for (rule = 0; rule < 3; rule++) {
            shape s = closed[row].make(closed[row].n);
            built b = build(&s, rule, -1);
            for (i = 0; i < 4; i++) {
                refined r = refine(&b, levels[i]);
                check_watertight(&r, closed[row].turned, row);
                check_parents(&b, &r, levels[i], row);
                refined_free(&r);
            }
            built_free(&b);
            shape_free(&s);
        }
}

/* The other form of the same: two patches on one edge have the same points along it, bit for bit,
   at parameters that are exact from both ends. */
static void patches_share_points(void)
{
    int row, i, k, q, c;
    for (row = 0; row < CLOSED; row++) {
        shape s = closed[row].make(closed[row].n);
        built b = build(&s, row % 3, -1);
        for (i = 0; i < b.t.edges; i++)
            for (k = b.t.first[i]; k < b.t.first[i + 1]; k++) {
                int at = b.t.side[k], next = at % 3 == 2 ? at - 2 : at + 1;
                n3_edge e = built_edge(&b, i);
                n3_patch p = built_patch(&b, at / 3);
                for (q = 0; q <= 8; q++) {
                    n3_real t = (n3_real)q / 8, L[3] = {0, 0, 0};
                    c = s.triangle[at] < s.triangle[next];
                    L[at % 3] = c ? 1 - t : t;
                    L[next % 3] = c ? t : 1 - t;
                    CHECK_SAME(n3_patch_point(&p, L[1], L[2]), n3_edge_point(&e, t), row);
                }
            }
        built_free(&b);
        shape_free(&s);
    }
}

/* The points on the edges of a refined shape, sorted. */
static n3_vec *edge_points(const shape *s, int rule, int level, int *count)
{
    built b = build(s, rule, -1);
    refined r = refine(&b, level);
    n3_vec *list;
    *count = (level - 1) * b.t.edges;
    list = memory((size_t)*count, sizeof *list);
    memcpy(list, r.point + s->points, (size_t)*count * sizeof *list);
    qsort(list, (size_t)*count, sizeof *list, compare_points);
    refined_free(&r);
    built_free(&b);
    return list;
}

/* Triangles in another order, begun at other corners, points numbered anew: from given normals the
   same points on the edges, bit for bit. */
static void refined_in_any_order(void)
{
    rng r = {12};
    int row, rule, i, turn, count, again;
    for (row = 0; row < CLOSED; row++)
        for (rule = 0; rule < 3; rule++) {
            shape s = closed[row].make(closed[row].n);
            n3_vec *want, *got;
            want = edge_points(&s, rule, 5, &count);
            for (turn = 0; turn < 2 && closed[row].given; turn++) {
                if (turn) shape_renumber(&s, &r);
                shape_shuffle(&s, &r);
                got = edge_points(&s, rule, 5, &again);
                CHECK(again == count, row);
                for (i = 0; i < count && i < again; i++) CHECK_SAME(got[i], want[i], row);
                free(got);
            }
            free(want);
            shape_free(&s);
        }
}

/* Each output alone is what it is with the others. */
static void refined_outputs_alone(void)
{
    shape s = shape_bracket(1);
    built b = build(&s, N3_RULE_FIT, -1);
    refined all = refine(&b, 3), r = refine(&b, 3);
    size_t points = (size_t)all.points, sides = 3 * (size_t)all.triangles;
    memset(r.point, 1, points * sizeof *r.point);
    memset(r.triangle, 1, sides * sizeof *r.triangle);
    memset(r.normal, 1, (size_t)r.normals * sizeof *r.normal);
    memset(r.corner, 1, sides * sizeof *r.corner);
    memset(r.parent, 1, points * sizeof *r.parent);
    memset(r.uv, 1, 2 * points * sizeof *r.uv);
    n3_mesh_refine(&b.m, &b.t, b.net, 3, r.point, NULL, NULL, NULL, NULL, NULL);
    n3_mesh_refine(&b.m, &b.t, NULL, 3, NULL, r.triangle, NULL, NULL, NULL, NULL);
    n3_mesh_refine(&b.m, &b.t, b.net, 3, NULL, NULL, r.normal, NULL, NULL, NULL);
    n3_mesh_refine(&b.m, &b.t, NULL, 3, NULL, NULL, NULL, r.corner, NULL, NULL);
    n3_mesh_refine(&b.m, &b.t, NULL, 3, NULL, NULL, NULL, NULL, r.parent, NULL);
    n3_mesh_refine(&b.m, &b.t, NULL, 3, NULL, NULL, NULL, NULL, NULL, r.uv);
    CHECK(!memcmp(r.point, all.point, points * sizeof *r.point), 0);
    CHECK(!memcmp(r.triangle, all.triangle, sides * sizeof *r.triangle), 0);
    CHECK(!memcmp(r.normal, all.normal, (size_t)r.normals * sizeof *r.normal), 0);
    CHECK(!memcmp(r.corner, all.corner, sides * sizeof *r.corner), 0);
    CHECK(!memcmp(r.parent, all.parent, points * sizeof *r.parent), 0);
    CHECK(!memcmp(r.uv, all.uv, 2 * points * sizeof *r.uv), 0);
    refined_free(&all);
    refined_free(&r);
    built_free(&b);
    shape_free(&s);
}

/* Scaling by a power of two changes no bit of the net and no flag; but where the compiler contracts
   the plain form, which does what is very small, in another way than the wide one. */
static void net_scaled(void)
{
    int row, k, i;
    for (row = 0; row < CLOSED; row++)
        for (k = -1; k <= 1; k += 2) {
            shape s = closed[row].make(closed[row].n), big = shape_copy(&s);
            n3_real scale = (n3_real)ldexp(1, k * (EPS < 1e-10 ? 490 : 55));
            built a, b;
            for (i = 0; i < s.points; i++) big.point[i] = n3_mul(scale, s.point[i]);
            a = build(&s, row % 3, -1);
            b = build(&big, row % 3, -1);
            for (i = 0; i < a.nodes; i++)
                CHECK_VEC(b.net[i], n3_mul(scale, a.net[i]),
                          CONTRACTED * 32 * EPS * (double)scale * reach(a.net, a.nodes), row);
            for (i = 0; i < a.t.edges; i++) CHECK(a.flags[i] == b.flags[i], row);
            built_free(&a);
            built_free(&b);
            shape_free(&s);
            shape_free(&big);
        }
}

/* All points in one place, or on one line, and normals of any kind: finite, by every rule. */
static void net_of_nothing(void)
{
    rng r = {13};
    int i, rule, line, given;
    for (rule = 0; rule < 3; rule++)
        for (line = 0; line < 2; line++)
            for (given = 0; given < 2; given++) {
                shape s = shape_icosphere(0);
                built b;
                n3_report report;
                for (i = 0; i < s.points; i++)
                    s.point[i] = n3_mul((n3_real)(line * i), n3_v(1, 2, 3));
                for (i = 0; i < s.normals; i++) s.normal[i] = i % 3 ? rng_unit(&r) : n3_v(1, 2, 3);
                if (!given) shape_drop_normals(&s);
                b = build(&s, rule, 0.5);
                for (i = 0; i < b.nodes; i++) CHECK(is_finite_vec(b.net[i]), rule);
                report = n3_mesh_report(&b.m, &b.t, b.net, b.flags);
                CHECK(report.flat_triangles == 20, rule);
                CHECK(report.degenerate_edges == (line ? 0 : 30), rule);
                CHECK(given || report.straight_edges == (line ? 30 : 0), rule);
                built_free(&b);
                shape_free(&s);
            }
}

/* ---- Real meshes, where they are at hand ---- */

static void check_real(const shape *s, int is_closed, long row)
{
    int rule, i;
    for (rule = 0; rule < 3; rule++) {
        built b = build(s, rule, 0.64);
        refined r = refine(&b, 3);
        for (i = 0; i < b.t.edges; i++) {
            n3_edge e = built_edge(&b, i);
            n3_real most = (n3_real)1.34 * n3_len(n3_sub(e.p[3], e.p[0])); /* 4/3 */
            CHECK(n3_len(n3_sub(e.p[1], e.p[0])) <= most, row);
            CHECK(n3_len(n3_sub(e.p[3], e.p[2])) <= most, row);
        }
        for (i = 0; i < r.points; i++) CHECK(is_finite_vec(r.point[i]), row);
        if (is_closed) check_watertight(&r, 0, row);
        refined_free(&r);
        built_free(&b);
    }
}

static void real_meshes(void)
{
    static const struct {
        const char *path;
        int closed;
    } files[] = {{"../shared/meshes/cad_bracket.obj", 1},
                 {"../shared/meshes/cad_cone_apex.obj", 1},
                 {"../shared/meshes/cad_torus.obj", 1},
                 {"../shared/meshes/gc_cat_head.obj", 0},
                 {"../shared/meshes/gc_fan3.obj", 0},
                 {"../shared/meshes/gc_hourglass_ico.obj", 1},
                 {"../shared/meshes/gc_moebius.obj", 0},
                 {"../shared/meshes/osd_loop_cube_creases1.obj", 1},
                 {"../shared/meshes/osd_loop_nonman_edges.obj", 0},
                 {"../shared/meshes/osd_loop_saddle_edgecorner.obj", 0},
                 {"../shared/meshes/spot_control_mesh.obj", 1},
                 {"../shared/meshes/tm_capsule.obj", 0}};
    size_t i;
    for (i = 0; i < sizeof files / sizeof *files; i++) {
        shape s;
        if (!shape_read(files[i].path, &s)) {
            printf("real_meshes: skipped, there is no %s\n", files[i].path);
            return;
        }
        if (!s.normals) shape_drop_normals(&s);
        check_real(&s, files[i].closed, (long)i);
        shape_free(&s);
    }
}

const test_case tests_net[] = {{"smooth_edges_are_edges", smooth_edges_are_edges},
                               {"patches_from_edges", patches_from_edges},
                               {"crease_ramp", crease_ramp},
                               {"crease_handles", crease_handles},
                               {"three_sheets", three_sheets},
                               {"joints_in_any_order", joints_in_any_order},
                               {"joints_of_many", joints_of_many},
                               {"bracket_rims", bracket_rims},
                               {"noise_on_seams", noise_on_seams},
                               {"fit_on_sphere_and_cylinder", fit_on_sphere_and_cylinder},
                               {"fit_on_cubics", fit_on_cubics},
                               {"fit_is_held", fit_is_held},
                               {"torus_accuracy", torus_accuracy},
                               {"refined_triangle", refined_triangle},
                               {"refined_is_watertight", refined_is_watertight},
                               {"patches_share_points", patches_share_points},
                               {"refined_in_any_order", refined_in_any_order},
                               {"refined_outputs_alone", refined_outputs_alone},
                               {"net_scaled", net_scaled},
                               {"net_of_nothing", net_of_nothing},
                               {"real_meshes", real_meshes},
                               {NULL, NULL}};
