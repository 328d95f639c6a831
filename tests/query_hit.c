/* Rays: which patch owns a hit, all hits of a patch, grazing and degenerate rays. */
#include "built.h"
#include "naive.h"
#include "samples.h"

#include <math.h>

/* ---- Closed surfaces ---- */

static shape torus(int n) { return shape_torus(2 * n, n); }

static shape tilted_bracket(int angle)
{
    rng r = {9};
    shape s = shape_bracket(1);
    shape_split_normals(&s);
    shape_tilt_normals(&s, angle * DEGREE, &r);
    return s;
}

static shape turned_bracket(int angle)
{
    rng r = {10};
    shape s = tilted_bracket(angle);
    shape_flip(&s, &r);
    return s;
}

static const struct {
    shape (*make)(int);
    int n, given, agree; /* all normals are given; the triangles agree about outside */
} closed[] = {{shape_icosphere, 0, 1, 1}, {shape_icosphere, 1, 1, 1}, {torus, 4, 1, 1},
              {tilted_bracket, 3, 1, 1},  {tilted_bracket, 60, 1, 1}, {turned_bracket, 20, 1, 0},
              {shape_cone, 5, 0, 1},      {shape_hourglass, 4, 0, 1}};
enum { CLOSED = sizeof closed / sizeof *closed };

/* A place on a triangle's patch: a corner, a side, its middle or the inside. */
static n3_vec target_on(const built *b, rng *r)
{
    n3_patch p = built_patch(b, (int)(rng_next(r) % (uint64_t)b->m.triangles));
    n3_edge e[3];
    int way = (int)(rng_next(r) >> 62), i = (int)(rng_next(r) % 3);
    n3_patch_edges(&p, e);
    if (way == 0) return p.p[i];
    if (way == 1) return n3_edge_point(&e[i], (n3_real)1 / 2);
    if (way == 2) return n3_edge_point(&e[i], (n3_real)rng_uniform(r, 0, 1));
    return n3_patch_point(&p, (n3_real)rng_uniform(r, 0, 0.5), (n3_real)rng_uniform(r, 0, 0.5));
}

/* Along an axis, to another such place, along the chord to it, or anywhere; from before or behind.
 */
static void aim(const built *b, rng *r, n3_vec *from, n3_vec *along)
{
    n3_vec x = target_on(b, r);
    int way = (int)(rng_next(r) >> 62);
    n3_real back = (n3_real)rng_uniform(r, -2, 2);
    *along = rng_unit(r);
    if (way == 0) *along = n3_v(way == (int)(rng_next(r) >> 62), 0, 1);
    if (way == 1) *along = n3_sub(target_on(b, r), x);
    *from = n3_sub(x, n3_mul(rng_next(r) >> 63 ? 2 : back, *along));
}

/* The sum of the sides over all hits of a line is zero, and their number even. */
static void check_line(const built *b, n3_vec from, n3_vec along, int agree, long row)
{
    n3_hit hit[N3_HITS];
    int f, i, sum = 0, hits = 0;
    for (f = 0; f < b->m.triangles; f++) {
        n3_patch p = built_patch(b, f);
        int n = n3_patch_hits(&p, from, along, -(n3_real)HUGE_VAL, (n3_real)HUGE_VAL, hit);
        for (i = 0; i < n; i++) sum += hit[i].side;
        hits += n;
    }
    CHECK(hits % 2 == 0, row);
    if (agree) CHECK(sum == 0, row);
}

static void lines_leave_what_they_enter(void)
{
    rng r = {21};
    long i, count = sample_count(4000);
    int row, rule;
    for (row = 0; row < CLOSED; row++)
        for (rule = 0; rule < 3; rule += 2) {
            shape s = closed[row].make(closed[row].n);
            built b;
            if (!closed[row].given) shape_drop_normals(&s);
            b = build(&s, rule, -1);
            for (i = 0; i < count / 2 / CLOSED; i++) {
                n3_vec from, along;
                aim(&b, &r, &from, &along);
                check_line(&b, from, along, closed[row].agree, i);
            }
            built_free(&b);
            shape_free(&s);
        }
}

/* A ray from the middle of a sphere leaves it once, also through a vertex: one hit, and on the side
   where the normal looks away. */
static void rays_leave_a_sphere_once(void)
{
    rng r = {22};
    long i, count = sample_count(2000);
    shape s = shape_icosphere(1);
    built b = build(&s, N3_RULE_ARC, -1);
    for (i = 0; i < count; i++) {
        n3_vec from = n3_mul((n3_real)1 / 4, rng_vec(&r)), along = n3_sub(target_on(&b, &r), from);
        int f, hits = 0;
        for (f = 0; f < b.m.triangles; f++) {
            n3_patch p = built_patch(&b, f);
            n3_hit hit;
            if (!n3_patch_hit(&p, from, along, 0, (n3_real)HUGE_VAL, &hit)) continue;
            hits++;
            CHECK(hit.side == -1, i);
            CHECK_NEAR(hit.t, 1, 64 * EPS, i); /* the sine is above 1/2 */
        }
        CHECK(hits == 1, i);
    }
    built_free(&b);
    shape_free(&s);
}

/* ---- One patch ---- */

static n3_patch random_net(rng *r)
{
    n3_patch p;
    int i;
    for (i = 0; i < 10; i++) p.p[i] = rng_vec(r);
    return p;
}

/* How often the boundary, seen along z, runs round the origin: the sum of its turns over short
   steps. The distance to it that makes this certain, or 0. */
static int turns(const n3_patch *p, n3_vec from, double *distance)
{
    enum { STEPS = 300 };
    double angle = 0;
    n3_edge e[3];
    int i, k;
    *distance = 9;
    n3_patch_edges(p, e);
    for (i = 0; i < 3; i++)
        for (k = 0; k < STEPS; k++) {
            n3_vec a = n3_sub(n3_edge_point(&e[i], (n3_real)k / STEPS), from);
            n3_vec b = n3_sub(n3_edge_point(&e[i], (n3_real)(k + 1) / STEPS), from);
            double ax = (double)a.x, ay = (double)a.y, bx = (double)b.x, by = (double)b.y;
            angle += atan2(ax * by - ay * bx, ax * bx + ay * by);
            if (hypot(ax, ay) < *distance) *distance = hypot(ax, ay);
        }
    return (int)floor(angle / (2 * PI) + 0.5);
}

/* A step of the boundary is at most 3 * 2 sqrt(3) / 300 long. */
static void sides_add_up_to_the_turns(void)
{
    rng r = {23};
    long i, count = sample_count(2000), sound = 0;
    for (i = 0; i < count; i++) {
        n3_patch p = random_net(&r);
        n3_vec from = n3_mul((n3_real)1 / 2, rng_vec(&r));
        n3_hit hit[N3_HITS];
        double distance;
        int k, sum = 0, want = turns(&p, from, &distance);
        int n = n3_patch_hits(&p, from, n3_v(0, 0, 1), -9, 9, hit);
        for (k = 0; k < n; k++) sum -= hit[k].side;
        if (distance < 0.04) continue;
        sound++;
        CHECK(sum == want, i);
    }
    CHECK(sound > count / 2, sound);
}

/* Hits lie on the patch and on the ray, to the rounding of f, ON_SIDE and the shear, and ascend.
   Where the ray touches the patch a zero is as good as the root of that. */
static void check_hits(const n3_patch *p, n3_vec from, n3_vec along, const n3_hit *hit, int n,
                       long row)
{
    double size = reach(p->p, 10) + reach(&from, 1);
    int i;
    for (i = 0; i < n; i++) {
        n3_hit h = hit[i];
        n3_jet j = n3_patch_jet(p, h.u, h.v);
        double turn = fabs((double)n3_dot(n3_cross(j.du, j.dv), n3_unit(along)));
        int touches = turn <= 64 * sqrt(EPS) * size * size;
        CHECK_SAME(h.x, n3_patch_point(p, h.u, h.v), row);
        CHECK_VEC(n3_add(from, n3_mul(h.t, along)), h.x, (touches ? sqrt(EPS) : 128 * EPS) * size,
                  row);
        CHECK(h.u >= 0 && h.v >= 0 && h.u + h.v <= 1 + 2 * N3_EPS, row);
        CHECK(h.side == 1 || h.side == -1, row);
        CHECK(i == 0 || hit[i - 1].t <= h.t, row);
    }
}

/* A ray through a point of the patch hits it there: at an angle to the surface whose sine is s,
   within the error of f, over s and the smaller singular value of the derivatives. Half of the
   patches are wild nets. */
static void points_are_hit(void)
{
    rng r = {24};
    long i, count = sample_count(4000);
    for (i = 0; i < count; i++) {
        sample s = sample_make(i * KINDS);
        n3_patch p = i % 2 ? random_net(&r) : n3_patch_make(s.v[0], s.v[1], s.v[2], NULL);
        n3_real u = (n3_real)rng_uniform(&r, 0.01, 0.5), v = (n3_real)rng_uniform(&r, 0.01, 0.49);
        n3_vec along = rng_unit(&r), x = n3_patch_point(&p, u, v), from, n;
        n3_jet j = n3_patch_jet(&p, u, v);
        n3_hit hit[N3_HITS];
        double size = reach(p.p, 10), det, away = 2;
        int k, hits, side = 0;
        from = n3_sub(x, n3_mul((n3_real)size, along));
        n = n3_cross(j.du, j.dv);
        det = fabs((double)n3_dot(n, along)) / (double)(n3_len(j.du) + n3_len(j.dv));
        hits = n3_patch_hits(&p, from, along, 0, (n3_real)(2 * size), hit);
        check_hits(&p, from, along, hit, hits, i);
        if (!(det > 0.01 * size)) continue;
        for (k = 0; k < hits; k++) {
            double off = fabs((double)(hit[k].u - u)) + fabs((double)(hit[k].v - v));
            if (off < away) side = hit[k].side;
            if (off < away) away = off;
        }
        CHECK_NEAR(away, 0, 256 * EPS * size / det, i);
        CHECK(side == (n3_dot(n, along) < 0 ? 1 : -1), i);
    }
}

/* The mean over the orders of the arguments makes the polar form of a product. */
static n3_real polar(const double root[3], int ones)
{
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    double sum = 0;
    int i, k;
    for (i = 0; i < 6; i++) {
        double product = 1;
        for (k = 0; k < 3; k++) product *= (k < ones) - root[order[i][k]];
        sum += product / 6;
    }
    return (n3_real)sum;
}

/* x = (u - .05)(u - .15)(u - .35), y the same in v: nine zeros, all in the triangle. */
static void nine_hits(void)
{
    static const double root[3] = {0.05, 0.15, 0.35};
    static const int count_u[10] = {0, 3, 0, 1, 2, 2, 1, 0, 0, 1};
    static const int count_v[10] = {0, 0, 3, 0, 0, 1, 2, 2, 1, 1};
    n3_patch p;
    n3_hit hit[N3_HITS];
    int i, k, n, sum = 0, seen = 0;
    for (i = 0; i < 10; i++)
        p.p[i] = n3_v(polar(root, count_u[i]), polar(root, count_v[i]),
                      (n3_real)(count_u[i] + 2 * count_v[i]) / 3);
    n = n3_patch_hits(&p, n3_v(0, 0, -1), n3_v(0, 0, 1), 0, 9, hit);
    CHECK(n == 9, n);
    for (i = 0; i < n; i++) {
        for (k = 0; k < 9; k++)
            if (fabs((double)hit[i].u - root[k / 3]) + fabs((double)hit[i].v - root[k % 3]) <
                1e4 * EPS)
                seen |= 1 << k;
        CHECK_NEAR(hit[i].t, 1 + (double)hit[i].u + 2 * (double)hit[i].v, 1e4 * EPS, i);
        sum += hit[i].side;
    }
    CHECK(seen == 511, seen);
    CHECK(sum == -1, sum); /* five of the nine have a positive determinant */
    CHECK(n3_patch_hits(&p, n3_v(0, 0, -1), n3_v(0, 0, 1), (n3_real)1.2, (n3_real)1.4, hit) == 2,
          0);
    CHECK(n3_patch_hit(&p, n3_v(0, 0, -1), n3_v(0, 0, 1), 0, 9, hit), 0);
    CHECK_NEAR(hit[0].t, 1.15, 1e4 * EPS, 0);
}

/* The graph z = x^2 + y^2 over the triangle (-1, -1), (3, -1), (-1, 3), an exact patch. */
static n3_patch bowl(void)
{
    static const int count[10][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0},
                                     {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    n3_patch p;
    int i;
    for (i = 0; i < 10; i++) { /* the polar form of 16 u^2 - 8 u + 1 at k ones of three */
        static const n3_real square[4] = {1, (n3_real)-5 / 3, 1, 9};
        p.p[i] = n3_v((n3_real)(4 * count[i][0] - 3) / 3, (n3_real)(4 * count[i][1] - 3) / 3,
                      square[count[i][0]] + square[count[i][1]]);
    }
    return p;
}

/* Along x at the height h: two hits at x = +-sqrt(h) above zero and none below, down to the error
   of a height, 64 eps of 9. At zero two or none. */
static void grazing_rays(void)
{
    n3_patch p = bowl();
    n3_hit hit[N3_HITS];
    double h;
    long row = 0;
    for (h = 0.5; h > 64 * 9 * EPS; h /= 4, row++) {
        int n = n3_patch_hits(&p, n3_v(-5, 0, (n3_real)h), n3_v(1, 0, 0), 0, 10, hit);
        CHECK(n == 2 && hit[0].side == -1 && hit[1].side == 1, row);
        CHECK_NEAR(hit[0].x.x, -sqrt(h), 64 * 9 * EPS / sqrt(h), row);
        CHECK_NEAR(hit[1].x.x, sqrt(h), 64 * 9 * EPS / sqrt(h), row);
        CHECK(n3_patch_hits(&p, n3_v(-5, 0, (n3_real)-h), n3_v(1, 0, 0), 0, 10, hit) == 0, row);
    }
    CHECK(n3_patch_hits(&p, n3_v(-5, 0, 0), n3_v(1, 0, 0), 0, 10, hit) % 2 == 0, row);
    CHECK(n3_patch_hits(&p, n3_v(-5, 0, 0), n3_v(1, 1, 0), 0, 10, hit) % 2 == 0, row);
}

/* Patches without an area, rays in their plane or along them, directions and places that are none:
   hits are hits, and nothing hangs. */
static void degenerate_rays(void)
{
    rng r = {25};
    long i, count = sample_count(2000);
    n3_hit hit[N3_HITS];
    for (i = 0; i < count; i++) {
        n3_patch p = random_net(&r);
        n3_vec from = rng_vec(&r), along = rng_unit(&r), nan = n3_mul((n3_real)NAN, from);
        int k, kind = (int)(i % 4);
        for (k = 0; k < 10; k++) {
            if (kind == 0) p.p[k].z = from.z;
            if (kind == 1) p.p[k] = n3_add(from, n3_mul(p.p[k].x, along));
            if (kind == 2) p.p[k] = n3_mul(p.p[k].x, n3_sub(rng_vec(&r), p.p[k]));
            if (kind == 3) p.p[k] = p.p[0];
        }
        if (kind == 0) along.z = 0;
        k = n3_patch_hits(&p, from, along, -9, 9, hit);
        check_hits(&p, from, along, hit, k, i);
        CHECK(kind == 1 || kind == 2 || k % 2 == 0, i); /* in the plane, or away from a point */
        CHECK(n3_patch_hits(&p, from, n3_v(0, 0, 0), -9, 9, hit) == 0, i);
        CHECK(n3_patch_hits(&p, from, nan, -9, 9, hit) == 0, i);
        CHECK(n3_patch_hits(&p, nan, along, -9, 9, hit) == 0, i);
        p.p[i % 10] = nan;
        CHECK(n3_patch_hits(&p, from, along, -9, 9, hit) <= N3_HITS, i);
    }
}

/* Scaled by a power of two: the same u and v, bit for bit. */
static void scaled_rays(void)
{
    const int most = sizeof(n3_real) == 4 ? 50 : 480;
    rng r = {26};
    long i, count = sample_count(500);
    for (i = 0; i < count; i++) {
        n3_patch p = random_net(&r), q = p;
        n3_vec from = rng_vec(&r), along = rng_unit(&r);
        n3_hit a[N3_HITS], b[N3_HITS];
        int k, n, e = (int)(i % 2 ? most : -most);
        for (k = 0; k < 10; k++) q.p[k] = scale_vec(p.p[k], e);
        n = n3_patch_hits(&p, from, along, -9, 9, a);
        CHECK(n3_patch_hits(&q, scale_vec(from, e), scale_vec(along, e), -9, 9, b) == n, i);
        for (k = 0; k < n; k++) CHECK(same_real(a[k].u, b[k].u) && same_real(a[k].v, b[k].v), i);
    }
}

/* Whatever comes, the sides in the list and of those that wait add up to those that came. */
static void full_lists_lose_no_side(void)
{
    rng r = {27};
    long i, k, count = sample_count(200);
    for (i = 0; i < count; i++) {
        n3_hit list[N3_HITS], hit;
        int n = 0, over = 0, sum = 0, j, left;
        memset(&hit, 0, sizeof hit);
        for (k = 0; k < 40; k++) {
            hit.t = (n3_real)rng_uniform(&r, 0, 1);
            hit.side = rng_uniform(&r, 0, 1) < (k < 20 ? 0.8 : 0.2) ? 1 : -1;
            sum += hit.side;
            n = n3i_insert_hit(list, n, hit, &over);
            for (left = over, j = 0; j < n; j++) left += list[j].side;
            CHECK(left == sum && n <= N3_HITS, i);
            for (j = 1; j < n; j++) CHECK(list[j - 1].t <= list[j].t, i);
        }
    }
}

const test_case tests_query_hit[] = {{"lines_leave_what_they_enter", lines_leave_what_they_enter},
                                     {"rays_leave_a_sphere_once", rays_leave_a_sphere_once},
                                     {"sides_add_up_to_the_turns", sides_add_up_to_the_turns},
                                     {"points_are_hit", points_are_hit},
                                     {"nine_hits", nine_hits},
                                     {"full_lists_lose_no_side", full_lists_lose_no_side},
                                     {"grazing_rays", grazing_rays},
                                     {"degenerate_rays", degenerate_rays},
                                     {"scaled_rays", scaled_rays},
                                     {NULL, NULL}};
