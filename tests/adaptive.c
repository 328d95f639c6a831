/* Refinement to a distance: what is made hangs together, stays within the distance, and is not much
 * more than it must be. */
#include "built.h"

#include <math.h>

/* All outputs, with their counts. */
typedef struct fine {
    n3_cut *cut;
    int points, triangles, normals;
    n3_vec *point, *normal;
    int *triangle, *corner, *origin, *parent;
    n3_real *uv;
} fine;

static void fine_make(const built *b, fine *f)
{
    f->point = memory((size_t)f->points, sizeof *f->point);
    f->normal = memory((size_t)f->normals, sizeof *f->normal);
    f->triangle = memory(3 * (size_t)f->triangles, sizeof *f->triangle);
    f->corner = memory(3 * (size_t)f->triangles, sizeof *f->corner);
    f->origin = memory((size_t)f->triangles, sizeof *f->origin);
    f->parent = memory((size_t)f->points, sizeof *f->parent);
    f->uv = memory(2 * (size_t)f->points, sizeof *f->uv);
    n3_mesh_refine_cut(&b->m, &b->t, b->net, f->cut, f->point, f->triangle, f->normal, f->corner,
                       f->origin, f->parent, f->uv);
}

static fine fine_to(const built *b, double distance, long row)
{
    fine f;
    n3_status status;
    f.cut = memory((size_t)(b->t.edges + b->m.triangles), sizeof *f.cut);
    f.points = f.triangles = f.normals = 0;
    status = n3_mesh_cut(&b->m, &b->t, b->net, (n3_real)distance, f.cut, &f.points, &f.triangles,
                         &f.normals, NULL);
    if (!CHECK(status == N3_OK, row)) exit(1);
    fine_make(b, &f);
    return f;
}

static void fine_free(fine *f)
{
    free(f->cut);
    free(f->point);
    free(f->normal);
    free(f->triangle);
    free(f->corner);
    free(f->origin);
    free(f->parent);
    free(f->uv);
}

static n3_mesh fine_mesh(const fine *f)
{
    n3_mesh m;
    memset(&m, 0, sizeof m);
    m.points = f->points;
    m.triangles = f->triangles;
    m.point = &f->point[0].x;
    m.triangle = f->triangle;
    return m;
}

/* ---- Shapes: where curvature is even, and where it is not ---- */

enum { SHAPES = 9 };

static shape shape_number(int i)
{
    rng r = {11};
    shape s;
    switch (i) {
    case 0: return shape_icosphere(1);
    case 1: return shape_torus(12, 6);
    case 2: return shape_polar(8, 5);
    case 3: return shape_bracket(3);
    case 4: return shape_cone(7);
    case 5: return shape_moebius(9);
    case 6: return shape_hourglass(6);
    case 7: return shape_cube();
    }
    s = shape_icosphere(0);
    shape_tilt_normals(&s, 0.4, &r);
    return s;
}

static double size_of(const n3_mesh *m)
{
    double most = 0;
    int i;
    for (i = 1; i < 3 * m->points; i++) {
        double off = fabs((double)m->point[i] - (double)m->point[i % 3]);
        if (off > most) most = off;
    }
    return most;
}

static const double distances[] = {1e-1, 1e-2, 3e-3, 1e-3};
enum { DISTANCES = sizeof distances / sizeof *distances };

/* Calls the check for each shape, by each rule, with a distance relative to its size. */
static void for_each(void (*check)(const built *b, double distance, long row))
{
    int i, k;
    for (i = 0; i < SHAPES; i++) {
        shape s = shape_number(i);
        built b = build(&s, i % 2 ? N3_RULE_PAPER : N3_RULE_FIT, 0.7);
        for (k = 0; k < DISTANCES; k++) check(&b, distances[k] * size_of(&b.m), 10 * i + k);
        built_free(&b);
        shape_free(&s);
    }
}

/* ---- Equal parts everywhere: as n3_mesh_refine ---- */

static int is_collapsed(const n3_mesh *m, int triangle)
{
    const int *x = m->triangle + 3 * triangle;
    return x[0] == x[1] || x[1] == x[2] || x[2] == x[0];
}

static fine fine_evenly(const built *b, int level)
{
    int e, f, live = 0, inside = (level - 1) * (level - 2) / 2;
    fine g;
    g.cut = memory((size_t)(b->t.edges + b->m.triangles), sizeof *g.cut);
    for (e = 0; e < b->t.edges; e++) {
        g.cut[e].parts = level;
        g.cut[e].first = b->m.points + (level - 1) * e;
    }
    for (f = 0; f < b->m.triangles; f++) {
        g.cut[e + f].parts = level;
        g.cut[e + f].first = b->m.points + (level - 1) * e + inside * live;
        live += !is_collapsed(&b->m, f);
    }
    n3_mesh_refine_counts(&b->m, &b->t, level, &g.points, &g.triangles, &g.normals);
    fine_make(b, &g);
    return g;
}

/* The outputs of n3_mesh_refine put in place of those of f. */
static void refine_into(const built *b, int level, fine *f)
{
    n3_mesh_refine(&b->m, &b->t, b->net, level, f->point, f->triangle, f->normal, f->corner,
                   f->parent, f->uv);
}

/* Where the uv of the point are those of the normal's triangle. */
static void check_normal(const built *b, const fine *f, const fine *g, int side, long row)
{
    int point = f->triangle[side], triangle = f->origin[side / 3];
    n3_patch p = built_patch(b, triangle);
    const n3_real *uv = f->uv + 2 * (size_t)point;
    double bound = f->parent[point] == triangle ? normal_bound(&p, uv[0], uv[1]) : 2;
    CHECK_VEC(f->normal[f->corner[side]], g->normal[g->corner[side]], bound, row);
}

/* A collapsed triangle has a point at two corners, and either will do. Points inside a patch agree
   within 64 eps and normals within normal_bound. */
static void equal_parts(void)
{
    static const int levels[] = {1, 2, 3, 4, 7};
    int i, k, j;
    for (i = 0; i < 5 * SHAPES; i++) {
        shape s = shape_number(i / 5);
        built b = build(&s, N3_RULE_PAPER, 0.7);
        fine f = fine_evenly(&b, levels[i % 5]), g = fine_evenly(&b, levels[i % 5]);
        refine_into(&b, levels[i % 5], &g);
        for (j = 0; j < f.points; j++) {
            CHECK_VEC(f.point[j], g.point[j], 64 * EPS * size_of(&b.m), i);
            CHECK(f.parent[j] == g.parent[j], i);
            if (f.parent[j] < 0 || is_collapsed(&b.m, f.parent[j])) continue;
            for (k = 0; k < 2; k++) CHECK(same_real(f.uv[2 * j + k], g.uv[2 * j + k]), i);
        }
        for (j = 0; j < 3 * f.triangles; j++) {
            CHECK(f.triangle[j] == g.triangle[j], i);
            check_normal(&b, &f, &g, j, i);
        }
        fine_free(&f);
        fine_free(&g);
        built_free(&b);
        shape_free(&s);
    }
}

/* ---- One triangle, between sides of all kinds ---- */

/* The inner lattice is in the middle. */
static void check_inner(const n3i_cut *c, long row)
{
    double u = 0, v = 0;
    int i, j, n = n3i_cut_inside(c);
    for (j = 0; j <= c->inner - 2; j++)
        for (i = 0; i <= c->inner - 2 - j; i++) {
            n3i_spot s = n3i_inner_spot(c, i, j);
            u += (double)s.u / n, v += (double)s.v / n;
        }
    CHECK_NEAR(u, 1.0 / 3, n * EPS, row);
    CHECK_NEAR(v, 1.0 / 3, n * EPS, row);
}

/* Its facets fill it, and use every part of a side once. */
static void check_filled(const n3i_cut *c, long row)
{
    int used[3] = {0}, i, on = n3i_cut_first(c), facets = 0;
    char *seen = memory((size_t)(on + n3i_cut_inside(c)), 1);
    n3i_walk walk = n3i_walk_start(c);
    n3i_spot s[3];
    double all = 0;
    for (; n3i_walk_next(c, &walk, s); facets++) {
        double area = (double)((s[1].u - s[0].u) * (s[2].v - s[0].v) -
                               (s[2].u - s[0].u) * (s[1].v - s[0].v));
        CHECK(area > 0, row);
        all += area;
        for (i = 0; i < 3; i++) {
            const n3i_spot *x = &s[i], *y = &s[(i + 1) % 3];
            seen[x->index] = 1;
            used[0] += x->v <= 0 && y->v <= 0;
            used[1] += 1 - x->u - x->v <= 0 && 1 - y->u - y->v <= 0 && x->index < on;
            used[2] += x->u <= 0 && y->u <= 0;
        }
    }
    CHECK_NEAR(all, 1, 4 * EPS * facets, row); /* each corner is off by EPS at most */
    for (i = 0; i < 3; i++) CHECK(used[i] == c->side[i], row);
    for (i = 0; i < on + n3i_cut_inside(c); i++) CHECK(seen[i], row);
    free(seen);
}

static void filled_triangles(void)
{
    n3i_bend flat;
    int side[3], parts, k;
    memset(&flat, 0, sizeof flat);
    for (k = 0; k < 7 * 7 * 7; k++) {
        side[0] = 1 + k % 7, side[1] = 1 + k / 7 % 7, side[2] = 1 + k / 49;
        for (parts = 2; parts < 9; parts++) {
            n3i_cut c = n3i_cut_make(side, -parts);
            check_filled(&c, 10 * k + parts);
            check_inner(&c, 10 * k + parts);
        }
        for (parts = 1; parts < 8; parts++) {
            n3i_cut c = n3i_cut_make(side, parts);
            if (parts < c.side[c.base]) continue;
            if (parts > 1 && parts >= c.strips) continue;
            if (n3i_cut_facets(&c, &flat, 1)) check_filled(&c, -10 * k - parts);
            else CHECK(parts > 1, -10 * k - parts);
        }
    }
}

/* ---- One facet: the bound on its distance ---- */

static n3i_spot random_spot(int index, rng *r)
{
    n3i_spot s;
    double u = rng_uniform(r, 0, 1), v = rng_uniform(r, 0, 1);
    s.index = index;
    s.u = (n3_real)(u + v > 1 ? 1 - u : u);
    s.v = (n3_real)(u + v > 1 ? 1 - v : v);
    return s;
}

/* The patch less the facet at the weights, directly, and from the control vectors. */
static n3_vec off_facet(const n3_patch *p, const n3i_spot s[3], const n3_real w[3])
{
    n3_vec off = n3_patch_point(p, w[0] * s[0].u + w[1] * s[1].u + w[2] * s[2].u,
                                w[0] * s[0].v + w[1] * s[1].v + w[2] * s[2].v);
    int i;
    for (i = 0; i < 3; i++)
        off = n3_sub(off, n3_mul(w[i], n3_patch_point(p, s[i].u, s[i].v)));
    return off;
}

static n3_vec from_net(const n3_vec net[7], const n3_real w[3])
{
    n3_vec sum = n3_mul(6 * w[0] * w[1] * w[2], net[6]);
    int i;
    for (i = 0; i < 3; i++) {
        n3_real a = w[i], b = w[(i + 1) % 3];
        sum = n3_add(sum, n3_mul(3 * a * a * b, net[2 * i]));
        sum = n3_add(sum, n3_mul(3 * a * b * b, net[2 * i + 1]));
    }
    return sum;
}

/* A patch of points in the unit cube. Sums of ten products each, of second differences up to 8,
   with weights up to 6: 64 EPS for each is ample. */
static void bound_of_a_facet(void)
{
    rng r = {5};
    long i, count = sample_count(300), loose = 0;
    for (i = 0; i < count; i++) {
        n3_patch p;
        n3i_spot s[3];
        n3i_bend b;
        n3_vec net[7];
        double most = 0;
        int k;
        for (k = 0; k < 10; k++) p.p[k] = rng_vec(&r);
        for (k = 0; k < 3; k++) s[k] = random_spot(k, &r);
        b = n3i_bend_of(&p);
        n3i_facet_net(&b, s, net);
        for (k = 0; k < 200; k++) {
            n3i_spot at = random_spot(0, &r);
            n3_real w[3];
            n3_vec off;
            w[0] = at.u, w[1] = k < 20 ? 0 : at.v, w[2] = 1 - w[0] - w[1];
            off = off_facet(&p, s, w);
            CHECK_VEC(from_net(net, w), off, 64 * 10 * EPS, i);
            if ((double)n3_len(off) > most) most = (double)n3_len(off);
        }
        CHECK(!n3i_is_within(net, n3_v(0, 0, 0), 1, (n3_real)(0.99 * most)), i);
        loose += !n3i_is_within(net, n3_v(0, 0, 0), 1, (n3_real)(2 * most));
    }
    CHECK(loose * 4 < count, loose);
}

/* The same second difference everywhere: the bound is the distance, a sixth of the difference. */
static void bound_is_sharp(void)
{
    static const double h[10] = {0, 0, 0, -1, -1, -1, -1, -1, -1, -1.5};
    static const double x[10] = {0, 3, 0, 1, 2, 2, 1, 0, 0, 1};
    static const double y[10] = {0, 0, 3, 0, 0, 1, 2, 2, 1, 1};
    n3i_spot s[3] = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}};
    n3_patch p;
    n3i_bend b;
    n3_vec net[7];
    int k;
    for (k = 0; k < 10; k++) p.p[k] = n3_v((n3_real)x[k], (n3_real)y[k], (n3_real)h[k]);
    b = n3i_bend_of(&p);
    n3i_facet_net(&b, s, net);
    CHECK(n3i_is_within(net, n3_v(0, 0, 0), 1, (n3_real)1.0001), 0);
    CHECK(!n3i_is_within(net, n3_v(0, 0, 0), 1, (n3_real)0.9999), 0);
}

/* ---- Edges: every one has as many triangles as before ---- */

static int live_sides(const built *b, int edge)
{
    int i, n = 0;
    for (i = b->t.first[edge]; i < b->t.first[edge + 1]; i++)
        n += !is_collapsed(&b->m, b->t.side[i] / 3);
    return n;
}

static void check_joined(const built *b, double distance, long row)
{
    fine f = fine_to(b, distance, row);
    n3_mesh m = fine_mesh(&f);
    size_t size = n3_mesh_workspace(&m);
    void *work = memory(size, 1);
    int count[16] = {0}, e, q;
    n3_topology t;
    memset(&t, 0, sizeof t);
    CHECK(n3_mesh_topology(&m, work, size, &t, NULL) == N3_OK, row);
    for (e = 0; e < b->t.edges; e++)
        if ((q = live_sides(b, e)) < 16) count[q] += f.cut[e].parts;
    for (e = 0; e < t.edges; e++)
        if ((q = t.first[e + 1] - t.first[e]) < 16 && q != 2) count[q]--;
    for (q = 1; q < 16; q++) CHECK(q == 2 || count[q] == 0, row);
    CHECK(t.collapsed == 0 && t.unused == b->t.unused + count[0], row);
    free(work);
    fine_free(&f);
}

static void edges_stay_joined(void) { for_each(check_joined); }

/* ---- The distance ---- */

static double to_segment(n3_vec p, n3_vec a, n3_vec b)
{
    n3_vec d = n3_sub(b, a), x = n3_sub(p, a);
    double l = (double)n3_dot(d, d), s = l > 0 ? (double)n3_dot(x, d) / l : 0;
    s = s < 0 ? 0 : s > 1 ? 1 : s;
    return (double)n3_len(n3_sub(x, n3_mul((n3_real)s, d)));
}

static double to_triangle(n3_vec p, const n3_vec x[3])
{
    n3_vec n = n3_unit(n3_cross(n3_sub(x[1], x[0]), n3_sub(x[2], x[0])));
    double best = to_segment(p, x[0], x[1]), d;
    int i, within = n3_len(n) > 0;
    for (i = 0; i < 3; i++) {
        n3_vec side = n3_sub(x[(i + 1) % 3], x[i]), way = n3_sub(p, x[i]);
        within = within && n3_dot(n3_cross(side, way), n) >= 0;
        if ((d = to_segment(p, x[i], x[(i + 1) % 3])) < best) best = d;
    }
    return within ? fabs((double)n3_dot(n3_sub(p, x[0]), n)) : best;
}

enum { LATTICE = 12, SPOTS = LATTICE * (LATTICE + 1) / 2 + LATTICE };

/* Points of the patch: in the middle of the triangles of a lattice, or on ab, where no point of a
   level below 36 is. */
static void spots_of(const n3_patch *p, n3_vec y[SPOTS])
{
    int i, j, n = 0;
    for (j = -1; j < LATTICE; j++)
        for (i = 0; i < LATTICE - (j > 0 ? j : 0); i++)
            y[n++] = n3_patch_point(p, (n3_real)(3 * i + 1) / (3 * LATTICE),
                                    (n3_real)(j < 0 ? 0 : 3 * j + 1) / (3 * LATTICE));
}

/* Lowers the distances to the triangle's, which lies within a sphere about its middle. */
static void approach(const n3_vec x[3], const n3_vec y[SPOTS], double best[SPOTS])
{
    n3_vec middle = n3_mul((n3_real)1 / 3, n3_add(n3_add(x[0], x[1]), x[2]));
    double radius = 0;
    int i;
    for (i = 0; i < 3; i++) radius = fmax(radius, 1.001 * (double)n3_len(n3_sub(x[i], middle)));
    for (i = 0; i < SPOTS; i++) {
        n3_vec way = n3_sub(y[i], middle);
        double reach = best[i] + radius;
        if ((double)n3_dot(way, way) < reach * reach) best[i] = fmin(best[i], to_triangle(y[i], x));
    }
}

/* The largest distance of a patch's points to the nearest of the triangles. */
static double off_patch(const n3_patch *p, const fine *f, int first, int last)
{
    n3_vec y[SPOTS], x[3];
    double best[SPOTS], most = 0;
    int i, k;
    spots_of(p, y);
    for (i = 0; i < SPOTS; i++) best[i] = 1e100;
    for (k = first; k < last; k++) {
        for (i = 0; i < 3; i++) x[i] = f->point[f->triangle[3 * k + i]];
        approach(x, y, best);
    }
    for (i = 0; i < SPOTS; i++) most = fmax(most, best[i]);
    return most;
}

/* The size of rounding in the points and in their distance. */
static void check_distance(const built *b, double distance, long row)
{
    fine f = fine_to(b, distance, row);
    double rounding = 16 * EPS * size_of(&b->m);
    int i, first = 0, last = 0;
    for (i = 0; i < b->m.triangles; i++, first = last) {
        n3_patch p = built_patch(b, i);
        while (last < f.triangles && f.origin[last] == i) last++;
        if (last > first) CHECK(off_patch(&p, &f, first, last) <= distance + rounding, row);
    }
    CHECK(last == f.triangles, row);
    fine_free(&f);
}

static void within_the_distance(void) { for_each(check_distance); }

/* ---- How many triangles ---- */

/* The smallest level whose triangles are within the distance of the first patches. */
static int level_for(const built *b, double distance, int patches)
{
    int level, i, good = 0;
    for (level = 1; !good; level++) {
        fine f = fine_evenly(b, level);
        for (good = 1, i = 0; i < patches; i++) {
            n3_patch p = built_patch(b, i);
            int from = i * level * level;
            good = good && off_patch(&p, &f, from, from + level * level) <= distance;
        }
        fine_free(&f);
    }
    return level - 1;
}

/* One and a half times what equal parts take, or one part more than they. The triangles of one face
   of the icosahedron are all that there are on an icosphere. */
static void few_on_a_sphere(void)
{
    static const double tolerance[] = {2e-2, 1e-2, 5e-3, 3e-3, 2e-3, 1e-3, 7e-4, 5e-4};
    int i, k;
    for (i = 0; i < 2; i++) {
        shape s = shape_icosphere(1 + i);
        built b = build(&s, N3_RULE_PAPER, 0.7);
        for (k = 0; k < 8; k++) {
            int level = level_for(&b, tolerance[k], 4 + 12 * i);
            double most = fmax(1.5 * level * level, (level + 1) * (level + 1));
            fine f = fine_to(&b, tolerance[k], k);
            CHECK_NEAR(f.triangles, 0, most * b.m.triangles, 10 * i + k);
            fine_free(&f);
        }
        built_free(&b);
        shape_free(&s);
    }
}

/* Two triangles on z = x y, whose sides are straight but for one: a twist and no more. */
static shape shape_twist(void)
{
    static const int corners[6] = {0, 1, 2, 0, 2, 3};
    shape s = shape_pillow();
    int i;
    CHECK(s.points <= 4 && s.triangles == 2, 0);
    s.point = realloc(s.point, 4 * sizeof *s.point);
    s.normal = memory(4, sizeof *s.normal);
    s.corner = memory(6, sizeof *s.corner);
    if (!s.point) abort();
    s.points = s.normals = 4;
    for (i = 0; i < 4; i++) {
        n3_real x = i == 1 || i == 2 ? 1 : -1, y = i >= 2 ? 1 : -1;
        s.point[i] = n3_v(x, y, x * y);
        s.normal[i] = n3_unit(n3_v(-y, -x, 1));
    }
    for (i = 0; i < 6; i++) s.triangle[i] = s.corner[i] = corners[i];
    return s;
}

/* The share of what equal parts take, from measurement; a fifth more is allowed. */
static void few_elsewhere(void)
{
    static const struct {
        int shape;
        double distance, share;
    } rows[] = {{1, 1e-3, 1.352}, {3, 1e-3, 0.177}, {4, 1e-3, 0.707}, {5, 1e-3, 0.753},
                {-1, 1e-3, 1.244}};
    int i;
    for (i = 0; i < 5; i++) {
        shape s = rows[i].shape < 0 ? shape_twist() : shape_number(rows[i].shape);
        built b = build(&s, N3_RULE_PAPER, 0.7);
        double distance = rows[i].distance * size_of(&b.m);
        int level = level_for(&b, distance, b.m.triangles);
        fine f = fine_to(&b, distance, i);
        CHECK_NEAR((double)f.triangles / level / level / b.m.triangles, 0, 1.2 * rows[i].share, i);
        fine_free(&f);
        built_free(&b);
        shape_free(&s);
    }
}

/* ---- Sizes and faults ---- */

static void any_size(void)
{
    const int exponents[] = {sizeof(n3_real) == 4 ? -20 : -200, sizeof(n3_real) == 4 ? 20 : 200};
    int i, k;
    for (i = 0; i < 2; i++) {
        shape s = shape_bracket(2), t = shape_bracket(2);
        built b = build(&s, N3_RULE_PAPER, 0.7), c;
        double distance = 1e-3 * size_of(&b.m);
        fine f = fine_to(&b, distance, i), g;
        for (k = 0; k < t.points; k++)
            t.point[k] = n3_mul((n3_real)ldexp(1, exponents[i]), t.point[k]);
        c = build(&t, N3_RULE_PAPER, 0.7);
        g = fine_to(&c, ldexp(distance, exponents[i]), i);
        CHECK(f.triangles == g.triangles && f.points == g.points, i);
        fine_free(&f);
        fine_free(&g);
        built_free(&b);
        built_free(&c);
        shape_free(&s);
        shape_free(&t);
    }
}

static void faults_of_distance(void)
{
    shape s = shape_icosphere(0);
    built b = build(&s, N3_RULE_PAPER, 0.7);
    n3_cut *cut = memory((size_t)(b.t.edges + b.m.triangles), sizeof *cut);
    static const double wrong[] = {0, -1, (double)NAN, 1e-12};
    int i, item;
    for (i = 0; i < 4; i++) {
        item = -2;
        CHECK(n3_mesh_cut(&b.m, &b.t, b.net, (n3_real)wrong[i], cut, NULL, NULL, NULL, &item) ==
                  N3_BAD_COUNT, i);
        CHECK(item == (i == 3 ? 0 : -1), i);
    }
    CHECK(n3_mesh_cut(&b.m, &b.t, NULL, 1, cut, NULL, NULL, NULL, NULL) == N3_NULL_POINTER, 0);
    CHECK(n3_mesh_cut(&b.m, &b.t, b.net, 1, NULL, NULL, NULL, NULL, NULL) == N3_NULL_POINTER, 1);
    CHECK(n3_mesh_cut(&b.m, NULL, b.net, 1, cut, NULL, NULL, NULL, NULL) == N3_NULL_POINTER, 2);
    CHECK(n3_mesh_refine_cut(&b.m, &b.t, b.net, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL) ==
              N3_NULL_POINTER, 3);
    CHECK(n3_mesh_cut(&b.m, &b.t, b.net, 1, cut, NULL, NULL, NULL, NULL) == N3_OK, 4);
    b.net[b.nodes - 1].x = (n3_real)NAN; /* a centre: no cut will do */
    item = -2;
    CHECK(n3_mesh_cut(&b.m, &b.t, b.net, 1, cut, NULL, NULL, NULL, &item) == N3_BAD_COUNT, 6);
    CHECK(item == -1, item);
    CHECK(n3_mesh_refine_cut(&b.m, &b.t, b.net, cut, NULL, NULL, NULL, NULL, NULL, NULL, NULL) ==
              N3_OK, 5);
    free(cut);
    built_free(&b);
    shape_free(&s);
}

const test_case tests_adaptive[] = {{"adaptive: equal parts", equal_parts},
                                    {"adaptive: filled triangles", filled_triangles},
                                    {"adaptive: bound of a facet", bound_of_a_facet},
                                    {"adaptive: bound is sharp", bound_is_sharp},
                                    {"adaptive: edges stay joined", edges_stay_joined},
                                    {"adaptive: within the distance", within_the_distance},
                                    {"adaptive: few on a sphere", few_on_a_sphere},
                                    {"adaptive: few elsewhere", few_elsewhere},
                                    {"adaptive: any size", any_size},
                                    {"adaptive: faults", faults_of_distance},
                                    {NULL, NULL}};
