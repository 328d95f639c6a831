/* Meshes: topology, normals, fields, the report, and what the calls answer to bad input. */
#include "built.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Topology ---- */

/* The two ends of a side, sorted, as one number; -1 where they are the same point. */
static int ends_of(const n3_mesh *m, int s)
{
    int a = m->triangle[s], b = m->triangle[s % 3 == 2 ? s - 2 : s + 1];
    if (a == b) return -1;
    return a < b ? a * m->points + b : b * m->points + a;
}

/* The first side with the same ends. */
static int first_like(const n3_mesh *m, int s)
{
    int i = 0;
    while (ends_of(m, i) != ends_of(m, s)) i++;
    return i;
}

static void check_topology(const n3_mesh *m, const n3_topology *t, long row)
{
    int s, edges = 0, i = 0;
    for (s = 0; s < 3 * m->triangles; s++) {
        int like = first_like(m, s), end[2];
        CHECK((t->edge[s] < 0) == (ends_of(m, s) < 0), row);
        if (t->edge[s] < 0) continue;
        CHECK(t->edge[s] == (like == s ? edges : t->edge[like]), row);
        edges += like == s;
        n3_mesh_edge_ends(m, t, t->edge[s], end);
        CHECK(end[0] * m->points + end[1] == ends_of(m, s), row);
    }
    CHECK(t->edges == edges && t->first[0] == 0, row);
    for (edges = 0; edges < t->edges; edges++)
        for (; i < t->first[edges + 1]; i++) {
            CHECK(t->edge[t->side[i]] == edges, row);
            CHECK(i == t->first[edges] || t->side[i] > t->side[i - 1], row);
        }
    for (s = 0; s < 3 * m->triangles; s++) i -= t->edge[s] >= 0;
    CHECK(i == 0, row);
}

static void topology_of_soup(void)
{
    rng r = {1};
    long i, count = sample_count(200);
    for (i = 0; i < count; i++) {
        shape s = shape_soup(3 + (int)(rng_next(&r) % 20), 1 + (int)(rng_next(&r) % 40), &r);
        n3_mesh m = shape_mesh(&s);
        size_t size = n3_mesh_workspace(&m);
        void *work = memory(size, 1);
        int used[64] = {0}, f, unused = m.points, collapsed = 0;
        n3_topology t;
        CHECK(n3_mesh_topology(&m, work, size, &t, NULL) == N3_OK, i);
        check_topology(&m, &t, i);
        for (f = 0; f < 3 * m.triangles; f++) unused -= !used[m.triangle[f]]++;
        for (f = 0; f < m.triangles; f++)
            collapsed +=
                ends_of(&m, 3 * f) < 0 || ends_of(&m, 3 * f + 1) < 0 || ends_of(&m, 3 * f + 2) < 0;
        CHECK(t.unused == unused && t.collapsed == collapsed, i);
        CHECK(t.points == m.points && t.triangles == m.triangles, i);
        free(work);
        shape_free(&s);
    }
}

/* ---- Bad input ---- */

enum part { POINT, NORMAL, TRIANGLE, CORNER, POINTS, TRIANGLES, NORMALS, NO_POINTS, NO_TRIANGLES };

/* Faults put into an icosphere of 12 points, 20 triangles and 12 normals. */
static const struct {
    enum part part;
    int at;
    double value;
    n3_status status;
    int item;
} faults[] = {
    {POINT, 7, (double)NAN, N3_BAD_POINT, 7},
    {POINT, 0, (double)INFINITY, N3_BAD_POINT, 0},
    {POINT, 11, -(double)INFINITY, N3_BAD_POINT, 11},
    {NORMAL, 3, (double)NAN, N3_BAD_NORMAL, 3},
    {NORMAL, 0, (double)INFINITY, N3_BAD_NORMAL, 0},
    {TRIANGLE, 0, -1, N3_BAD_TRIANGLE, 0},
    {TRIANGLE, 17, 12, N3_BAD_TRIANGLE, 5},
    {TRIANGLE, 59, 2147483647.0, N3_BAD_TRIANGLE, 19},
    {TRIANGLE, 58, -2147483648.0, N3_BAD_TRIANGLE, 19},
    {CORNER, 4, 12, N3_BAD_CORNER, 1},
    {POINTS, 0, -1, N3_BAD_COUNT, -1},
    {TRIANGLES, 0, -1, N3_BAD_COUNT, -1},
    {TRIANGLES, 0, 715827883.0, N3_BAD_COUNT, -1},
    {NORMALS, 0, -1, N3_BAD_COUNT, -1},
    {NORMALS, 1, 13, N3_BAD_COUNT, -1},
    {NO_POINTS, 0, 0, N3_NULL_POINTER, -1},
    {NO_TRIANGLES, 0, 0, N3_NULL_POINTER, -1},
};

static void put_fault(size_t row, shape *s, n3_mesh *m)
{
    int at = faults[row].at;
    double value = faults[row].value;
    switch (faults[row].part) {
    case POINT: s->point[at].y = (n3_real)value; break;
    case NORMAL: s->normal[at].z = (n3_real)value; break;
    case TRIANGLE: s->triangle[at] = (int)value; break;
    case CORNER: s->corner[at] = (int)value; break;
    case POINTS: m->points = (int)value; break;
    case TRIANGLES: m->triangles = (int)value; break;
    case NORMALS: m->normals = (int)value; break;
    case NO_POINTS: m->point = NULL; break;
    case NO_TRIANGLES: m->triangle = NULL; break;
    }
    if (faults[row].part == NORMALS && at) m->corner = NULL; /* then one for each point */
}

/* Every call names the fault and leaves its outputs as they were. */
static void status_of_faults(void)
{
    size_t i;
    for (i = 0; i < sizeof faults / sizeof *faults; i++) {
        shape s = shape_icosphere(0);
        built b = build(&s, N3_RULE_PAPER, -1);
        n3_mesh m = shape_mesh(&s);
        n3_status want = faults[i].status, got;
        n3_vec *net = b.net, *normal = b.normal, mark = n3_v(1, 2, 3);
        int item[2] = {-7, -7}, normals = 99;
        put_fault(i, &s, &m);
        net[0] = normal[0] = mark;
        b.corner[0] = b.corner[1] = 77;
        got = n3_mesh_net(&m, &b.t, NULL, net, NULL, &item[0]);
        CHECK(got == want && item[0] == faults[i].item, i);
        got = n3_mesh_normals(&m, &b.t, 0, NULL, normal, b.corner, &normals, &item[1]);
        CHECK(got == want && item[1] == faults[i].item, i);
        got = n3_mesh_refine(&m, &b.t, net, 1, normal, b.corner, NULL, NULL, NULL, NULL);
        CHECK(got == want, i);
        CHECK(same_vec(net[0], mark) && same_vec(normal[0], mark), i);
        CHECK(b.corner[0] == 77 && normals == 99, i);
        built_free(&b);
        shape_free(&s);
    }
}

/* The topology looks at points and triangles alone. */
static void status_of_topology(void)
{
    size_t i;
    for (i = 0; i < sizeof faults / sizeof *faults; i++) {
        shape s = shape_icosphere(0);
        n3_mesh m = shape_mesh(&s);
        size_t size = n3_mesh_workspace(&m), k;
        unsigned char *work = memory(size, 1);
        enum part part = faults[i].part;
        int item = -7, sound = part == NORMAL || part == CORNER || part == NORMALS;
        n3_topology t;
        t.edges = 77;
        put_fault(i, &s, &m);
        CHECK(n3_mesh_topology(&m, work, size, &t, &item) == (sound ? 0 : faults[i].status), i);
        CHECK(item == (sound ? -7 : faults[i].item), i);
        for (k = 0; k < size && !sound; k++) CHECK(work[k] == 0, i);
        CHECK(t.edges == (sound ? 30 : 0), i);
        free(work);
        shape_free(&s);
    }
}

/* A status without an item says -1. */
static void check_status(n3_status got, n3_status want, int *item, long row)
{
    CHECK(got == want && *item == -1, row);
    *item = 5;
}

static void status_of_pointers(void)
{
    shape s = shape_icosphere(0);
    built b = build(&s, N3_RULE_PAPER, -1);
    const n3_mesh *m = &b.m;
    const n3_status null = N3_NULL_POINTER;
    size_t size = n3_mesh_workspace(m);
    n3_vec *normal = b.normal;
    n3_topology t = b.t;
    int k = 5, normals, *corner = b.corner;
    CHECK(n3_mesh_workspace(NULL) == 0, 0);
    check_status(n3_mesh_topology(m, b.work, size - 1, &t, &k), N3_BAD_WORKSPACE, &k, 1);
    CHECK(!t.edge && t.edges == 0, 1);
    check_status(n3_mesh_topology(m, NULL, size, &t, &k), null, &k, 2);
    check_status(n3_mesh_topology(m, b.work, size, NULL, &k), null, &k, 3);
    check_status(n3_mesh_topology(NULL, b.work, size, &t, &k), null, &k, 4);
    t = b.t;
    check_status(n3_mesh_normals(m, &t, 0, NULL, NULL, corner, &normals, &k), null, &k, 5);
    check_status(n3_mesh_normals(m, &t, 0, NULL, normal, NULL, &normals, &k), null, &k, 6);
    check_status(n3_mesh_normals(m, &t, 0, NULL, normal, corner, NULL, &k), null, &k, 7);
    check_status(n3_mesh_net(m, NULL, NULL, b.net, NULL, &k), null, &k, 8);
    check_status(n3_mesh_net(m, &t, NULL, NULL, b.flags, &k), null, &k, 9);
    CHECK(n3_mesh_refine(m, &t, NULL, 2, b.net, NULL, NULL, NULL, NULL, NULL) == null, 10);
    CHECK(n3_mesh_refine(m, &t, NULL, 2, NULL, NULL, b.net, NULL, NULL, NULL) == null, 11);
    CHECK(n3_mesh_refine_counts(NULL, &t, 2, NULL, NULL, NULL) == null, 12);
    CHECK(n3_mesh_refine_counts(m, NULL, 2, NULL, NULL, NULL) == null, 13);
    t.triangles--;
    check_status(n3_mesh_net(m, &t, NULL, b.net, NULL, &k), N3_BAD_COUNT, &k, 14);
    t = b.t;
    t.points--;
    check_status(n3_mesh_net(m, &t, NULL, b.net, NULL, &k), N3_BAD_COUNT, &k, 15);
    t = b.t;
    t.edges = 1073741824;
    check_status(n3_mesh_net(m, &t, NULL, b.net, NULL, &k), N3_BAD_COUNT, &k, 16);
    built_free(&b);
    shape_free(&s);
}

static void status_texts(void)
{
    int i, k;
    for (i = N3_OK; i <= N3_BAD_WORKSPACE + 1; i++) /* and one that is none */
        for (k = N3_OK; k < i; k++)
            CHECK(strcmp(n3_status_text((n3_status)i), n3_status_text((n3_status)k)) != 0, i);
}

/* Sizes beyond int are refused before anything is computed from them. */
static void counts_overflow(void)
{
    static const struct {
        int points, triangles, edges, level;
        n3_status status;
    } rows[] = {
        {8, 12, 18, 1, N3_OK},
        {8, 12, 18, 0, N3_BAD_COUNT},
        {8, 12, 18, -3, N3_BAD_COUNT},
        {8, 12, 18, 7723, N3_OK},        /* 3 * 12 * 7723^2 = 2147202444 */
        {8, 12, 18, 7724, N3_BAD_COUNT}, /* 2147758536 */
        {8, 12, 18, 46341, N3_BAD_COUNT},
        {8, 12, 18, 2147483647, N3_BAD_COUNT},
        {2147483647, 12, 18, 2, N3_BAD_COUNT},
        {2147483629, 12, 18, 2, N3_OK},
        {0, 0, 0, 46341, N3_BAD_COUNT},
        {0, 0, 0, 40000, N3_OK},
    };
    n3_mesh m;
    n3_topology t;
    size_t i;
    memset(&m, 0, sizeof m);
    memset(&t, 0, sizeof t);
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        int points = -1, triangles = -1, normals = -1, level = rows[i].level, ok;
        t.points = rows[i].points;
        t.triangles = rows[i].triangles;
        t.edges = rows[i].edges;
        ok = n3_mesh_refine_counts(&m, &t, level, &points, &triangles, &normals) == N3_OK;
        CHECK(ok == (rows[i].status == N3_OK), i);
        CHECK((triangles < 0) == !ok && (points < 0) == !ok && (normals < 0) == !ok, i);
    }
    m.points = 2147483646;
    CHECK(n3_mesh_workspace(&m) > 2147483646u || n3_mesh_workspace(&m) == 0, 0);
    m.points = 2147483647;
    CHECK(n3_mesh_workspace(&m) == 0, 0);
    m.points = t.points = 10;
    m.triangles = t.triangles = 715827883;
    CHECK(n3_mesh_workspace(&m) == 0, 0);
    t.edges = 1073741824;
    CHECK(n3_mesh_nodes(&m, &t) == 0, 0);
}

/* Normals that no corner names, and no normals at all, behind a pointer. */
static void unnamed_normals(void)
{
    shape s = shape_icosphere(0);
    int i, count;
    for (i = 0; i < 3 * s.triangles; i++) s.corner[i] = -1 - i;
    for (count = 12; count >= 0; count -= 12) {
        built b;
        s.normals = count;
        b = build(&s, N3_RULE_PAPER, -1);
        CHECK(b.m.normals == count + 12, count);
        for (i = 0; i < 60; i++) CHECK(b.corner[i] >= count, count);
        built_free(&b);
    }
    shape_free(&s);
}

static void empty_mesh(void)
{
    n3_mesh m;
    n3_topology t;
    n3_report r;
    int work[8], points = -1, triangles = -1, normals = -1;
    memset(&m, 0, sizeof m);
    CHECK(n3_mesh_workspace(&m) > 0 && n3_mesh_workspace(&m) <= sizeof work, 0);
    CHECK(n3_mesh_topology(&m, work, sizeof work, &t, NULL) == N3_OK && t.edges == 0, 0);
    CHECK(n3_mesh_normals(&m, &t, 0, NULL, NULL, NULL, &normals, NULL) == N3_OK, 0);
    CHECK(normals == 0 && n3_mesh_nodes(&m, &t) == 0, 0);
    CHECK(n3_mesh_net(&m, &t, NULL, NULL, NULL, NULL) == N3_OK, 0);
    CHECK(n3_mesh_refine_counts(&m, &t, 3, &points, &triangles, &normals) == N3_OK, 0);
    CHECK(points == 0 && triangles == 0 && normals == 0, 0);
    CHECK(n3_mesh_refine(&m, &t, NULL, 3, NULL, NULL, NULL, NULL, NULL, NULL) == N3_OK, 0);
    r = n3_mesh_report(&m, &t, NULL, NULL);
    CHECK(r.points == 0 && r.edges == 0 && r.border_edges == 0 && r.crease_edges == -1, 0);
    r = n3_mesh_report(NULL, NULL, NULL, NULL);
    CHECK(r.points == 0 && r.triangles == 0 && r.edges == -1, 0);
}

/* count elements of a size, spread out so that none but the first is aligned. */
enum { STEP = 29 };

static void *spread(const void *from, int count, size_t size)
{
    char *to = memory((size_t)count, STEP);
    int i;
    for (i = 0; i < count; i++)
        memcpy(to + (size_t)i * STEP, (const char *)from + (size_t)i * size, size);
    return to;
}

static void strides(void)
{
    shape s = shape_bracket(3);
    n3_mesh m = shape_mesh(&s);
    void *point = spread(s.point, s.points, sizeof *s.point);
    void *normal = spread(s.normal, s.normals, sizeof *s.normal);
    void *triangle = spread(s.triangle, s.triangles, 3 * sizeof(int));
    void *corner = spread(s.corner, s.triangles, 3 * sizeof(int));
    built a = build(&s, N3_RULE_FIT, -1), b;
    int k;
    m.point = point;
    m.normal = normal;
    m.triangle = triangle;
    m.corner = corner;
    m.point_stride = m.normal_stride = m.triangle_stride = m.corner_stride = STEP;
    b = build_mesh(&m, N3_RULE_FIT, -1);
    for (k = 0; k < b.nodes; k++) CHECK_SAME(a.net[k], b.net[k], k);
    free(point);
    free(normal);
    free(triangle);
    free(corner);
    built_free(&a);
    built_free(&b);
    shape_free(&s);
}

/* ---- Normals ---- */

/* Max's sum is the exact normal of a sphere through the points. Each unit edge carries an error of
   a point's ulp, eps/2 in each of 3 coordinates of 2 points, over its length l, and each of the
   2 edges of a term 6 eps of its own arithmetic; the terms' sum cancels by less than 4 on these
   fans, whose triangles all face outwards. So the error is below 4 (2 sqrt 3 / l + 12) eps. */
static void normals_on_sphere(void)
{
    rng r = {2};
    int level, i;
    for (level = 0; level < 4; level++) {
        shape s = shape_icosphere(level);
        n3_real shake = (n3_real)0.2 / (n3_real)(1 << level);
        double shortest = 0.4 / (1 << level);
        built b;
        for (i = 0; i < s.points; i++)
            s.point[i] = n3_unit(n3_add(s.point[i], n3_mul(shake, rng_vec(&r))));
        shape_drop_normals(&s);
        b = build(&s, N3_RULE_PAPER, -1);
        CHECK(b.m.normals == s.points, level);
        for (i = 0; i < b.t.edges; i++) {
            n3_edge e = built_edge(&b, i);
            shortest = fmin(shortest, (double)n3_len(n3_sub(e.p[3], e.p[0])));
        }
        for (i = 0; i < 3 * s.triangles; i++)
            CHECK_VEC(b.normal[b.corner[i]], s.point[s.triangle[i]],
                      4 * (2 * sqrt(3.0) / shortest + 12) * EPS, level);
        built_free(&b);
        shape_free(&s);
    }
}

/* A cube is inscribed too. Cutting it by angle gives each face its normal; one marked edge ends in
   two fans that stay whole; marks round a face cut it off. */
static void normals_of_cube(void)
{
    static const struct {
        double cosine;
        int marked, normals;
    } rows[] = {{-1, 0, 8}, {0.5, 0, 24}, {-1, 1, 8}, {-1, 4, 12}, {-0.1, 0, 8}, {0.1, 0, 24}};
    size_t i;
    int c;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        shape s = shape_cube();
        built b = build(&s, N3_RULE_PAPER, -1);
        unsigned char mark[36] = {0};
        int normals = 0;
        n3_mesh m = shape_mesh(&s);
        /* Triangles 2 and 3 are the lid z = 1: its outer sides are 6, 7, 10 and 11. */
        if (rows[i].marked > 0) mark[6] = 1;
        if (rows[i].marked > 1) mark[7] = mark[10] = mark[11] = 1;
        CHECK(n3_mesh_normals(&m, &b.t, (n3_real)rows[i].cosine, mark, b.normal, b.corner, &normals,
                              NULL) == N3_OK,
              i);
        CHECK(normals == rows[i].normals, i);
        for (c = 0; c < 36; c++) {
            n3_vec n = b.normal[b.corner[c]], x = s.point[s.triangle[c]];
            n3_vec out = n3_unit(n3_sub(x, n3_v((n3_real)0.5, (n3_real)0.5, (n3_real)0.5)));
            if (normals == 8) CHECK_VEC(n, out, 4 * EPS, c);
            if (normals == 24) CHECK_NEAR(n3_dot(n, out), 1 / sqrt(3.0), 4 * EPS, c);
            if (normals == 24) CHECK_NEAR(fabs((double)(n.x + n.y + n.z)), 1, 0, c);
        }
        built_free(&b);
        shape_free(&s);
    }
}

/* How many fans a shape has: two at the apex of the hourglass, two where the strip's end meets its
   beginning upside down, one for each corner of sheets that share an edge. */
static void normals_counted(void)
{
    static const struct {
        shape (*make)(int);
        int n, normals;
    } rows[] = {{shape_hourglass, 7, 2 * 7 + 4},
                {shape_moebius, 9, 3 * 9 + 3},
                {shape_sheets, 4, 12},
                {shape_sheets, 2, 6},
                {shape_sheets, 1, 3}};
    size_t i;
    int c;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        shape s = rows[i].make(rows[i].n);
        built b = build(&s, N3_RULE_PAPER, -1);
        CHECK(b.m.normals == rows[i].normals, i);
        for (c = 0; c < 3 * s.triangles; c++)
            CHECK_NEAR(n3_len(b.normal[b.corner[c]]), 1, 4 * EPS, i);
        built_free(&b);
        shape_free(&s);
    }
}

/* Max's term as it is printed. */
static n3_vec naive_term(const shape *s, int c)
{
    int f = c - c % 3;
    n3_vec x = s->point[s->triangle[c]];
    n3_vec e0 = n3_sub(s->point[s->triangle[f + (c + 1) % 3]], x);
    n3_vec e1 = n3_sub(s->point[s->triangle[f + (c + 2) % 3]], x);
    return n3_mul(1 / (n3_dot(e0, e0) * n3_dot(e1, e1)), n3_cross(e0, e1));
}

/* The upper part of a sphere: at its border the sum is over the triangles that there are. Both
   sides round each of 6 terms of like length by 12 eps at most, in sums that cancel less than
   twice. */
static void normals_at_border(void)
{
    shape s = shape_icosphere(2);
    n3_vec *sum = memory((size_t)s.points, sizeof *sum);
    int kept = 0, f, k, c;
    built b;
    shape_drop_normals(&s);
    for (f = 0; f < s.triangles; f++) {
        n3_real z = 1;
        for (k = 0; k < 3; k++) {
            n3_vec x = s.point[s.triangle[3 * f + k]];
            if (x.z < z) z = x.z;
        }
        for (k = 0; k < 3 && z > 0; k++) s.triangle[3 * kept + k] = s.triangle[3 * f + k];
        kept += z > 0;
    }
    s.triangles = kept;
    for (c = 0; c < 3 * kept; c++)
        sum[s.triangle[c]] = n3_add(sum[s.triangle[c]], naive_term(&s, c));
    b = build(&s, N3_RULE_PAPER, -1);
    CHECK(b.m.normals == s.points - b.t.unused, 0);
    for (c = 0; c < 3 * kept; c++)
        CHECK_VEC(b.normal[b.corner[c]], n3_unit(sum[s.triangle[c]]), 48 * EPS, c);
    free(sum);
    built_free(&b);
    shape_free(&s);
}

/* Given normals keep their index and are made unit; unit ones keep their bits. The cone's apex has
   none: its triangles share it, because at their other ends they agree, sharp as its edges are. */
static void normals_given(void)
{
    shape s = shape_cone(12);
    built b = build(&s, N3_RULE_PAPER, 0.99), c;
    int i;
    CHECK(b.m.normals == s.normals + 1, 0);
    for (i = 0; i < 3 * s.triangles; i++) {
        int apex = s.triangle[i] == 12, given = s.corner[i];
        CHECK(b.corner[i] == (apex ? s.normals : given), i);
        if (!apex) CHECK_SAME(b.normal[b.corner[i]], s.normal[given], i);
        if (apex) CHECK_VEC(b.normal[b.corner[i]], n3_v(0, 0, 1), 16 * EPS, i);
    }
    for (i = 0; i < s.normals; i++)
        s.normal[i] = n3_mul((n3_real)(i % 2 ? 1e-9 : 7e8) * (n3_real)(i + 1), s.normal[i]);
    c = build(&s, N3_RULE_PAPER, 0.99);
    for (i = 0; i < s.normals; i++) CHECK_VEC(c.normal[i], b.normal[i], 4 * EPS, i);
    built_free(&c);
    built_free(&b);
    shape_free(&s);
}

/* At the cone's base each triangle has its own normals, that of its plane or, turned, the
   neighbours' turned round: then at the apex it has its own as well. */
static void normals_given_apart(void)
{
    int turned, i, c;
    for (turned = 0; turned < 2; turned++) {
        shape s = shape_cone(6);
        built b;
        shape_split_normals(&s);
        for (i = 0; i < s.triangles; i += 2) {
            const int *t = s.triangle + 3 * i;
            n3_vec x = s.point[t[0]], d = n3_sub(s.point[t[1]], x);
            n3_vec face = n3_unit(n3_cross(d, n3_sub(s.point[t[2]], x)));
            if (turned) face = n3_v(0, 0, i % 4 ? 1 : -1);
            for (c = 3 * i; c < 3 * i + 2; c++) s.normal[c] = face;
        }
        b = build(&s, N3_RULE_PAPER, -1);
        CHECK(b.m.normals == s.normals + 6, turned);
        built_free(&b);
        shape_free(&s);
    }
}

/* Two triangles back to back cancel: the one that comes first in order decides, not the first in
   the mesh. */
static void normals_that_cancel(void)
{
    int turn, c;
    for (turn = 0; turn < 2; turn++) {
        shape s = shape_pillow();
        built b;
        if (turn) memcpy(s.triangle, s.triangle + 3, 3 * sizeof(int));
        if (turn) s.triangle[4] = 1;
        if (turn) s.triangle[5] = 2;
        b = build(&s, N3_RULE_PAPER, -1);
        CHECK(b.m.normals == 3, turn);
        for (c = 0; c < 6; c++) CHECK_SAME(b.normal[b.corner[c]], n3_v(0, 0, -1), turn);
        built_free(&b);
        shape_free(&s);
    }
}

/* A flat tetrahedron with its corners in order on a circle, where Max's sums cancel: at each corner
   the largest of its triangles decides which way the normal looks, unless another one that looks
   the other way is as large. */
static void check_flat_tetrahedron(const n3_vec x[4], long row)
{
    static const int triangle[12] = {0, 1, 3, 1, 2, 3, 0, 2, 1, 0, 3, 2};
    shape s = shape_sheets(4);
    n3_real up[4] = {0, 0, 0, 0}, down[4] = {0, 0, 0, 0};
    built b;
    int c, f;
    memcpy(s.triangle, triangle, sizeof triangle);
    memcpy(s.point, x, 4 * sizeof *x);
    s.point[4] = n3_v(9999, 0, 0);
    s.points = 5;
    b = build(&s, N3_RULE_PAPER, -1);
    for (c = 0; c < 12; c++) {
        const int *t = triangle + c - c % 3;
        n3_vec n = n3_cross(n3_sub(x[t[1]], x[t[0]]), n3_sub(x[t[2]], x[t[0]]));
        f = triangle[c];
        if (n.z > up[f]) up[f] = n.z;
        if (-n.z > down[f]) down[f] = -n.z;
    }
    CHECK(b.m.normals == 4, row);
    for (c = 0; c < 12; c++) {
        n3_vec n = b.normal[b.corner[c]];
        f = triangle[c];
        if (up[f] > down[f]) CHECK_SAME(n, n3_v(0, 0, 1), row);
        if (up[f] < down[f]) CHECK_SAME(n, n3_v(0, 0, -1), row);
    }
    built_free(&b);
    shape_free(&s);
}

static void normals_of_flat_tetrahedra(void)
{
    static const n3_vec circle[12] = {{5, 0, 0},   {4, 3, 0},   {3, 4, 0},   {0, 5, 0},
                                      {-3, 4, 0},  {-4, 3, 0},  {-5, 0, 0},  {-4, -3, 0},
                                      {-3, -4, 0}, {0, -5, 0},  {3, -4, 0},  {4, -3, 0}};
    int set, k;
    for (set = 0; set < 1 << 12; set++) {
        n3_vec x[4];
        int count = 0;
        for (k = 0; k < 12; k++)
            if (set >> k & 1 && count++ < 4) x[count - 1] = circle[k];
        if (count == 4) check_flat_tetrahedron(x, set);
    }
}

/* A triangle b, a, m without area in the seam a, b of a flat quadrilateral, and of a folded one,
   begun at each of its corners, first or last of four: it goes with the triangle a, b, c beyond its
   longest side. Fans on a: one, or two; on m: one, or that of the two below and, without a normal,
   that of the flat triangle. */
static void normals_beside_flat_triangle(void)
{
    static const int flat[5] = {1, 0, 3, 1, 0};
    int row, i;
    for (row = 0; row < 12; row++) {
        int triangle[15] = {0, 0, 0, 0, 1, 2, 3, 0, 4, 1, 3, 4}, *first = triangle + row / 6 * 3;
        int fold = row / 3 % 2, zero = 0;
        shape s = shape_sheets(4);
        n3_vec below = fold ? n3_v(0, -1, 0) : n3_v(0, 0, 1);
        built b;
        s.points = 5;
        s.point[0] = n3_v(0, 0, 0);
        s.point[1] = n3_v(2, 0, 0);
        s.point[2] = n3_v(1, 1, 0);
        s.point[3] = n3_v(1, 0, 0);
        s.point[4] = fold ? n3_v(1, 0, -1) : n3_v(1, -1, 0);
        memcpy(triangle, flat + row % 3, 3 * sizeof(int));
        memcpy(triangle + 12, flat + row % 3, 3 * sizeof(int));
        memcpy(s.triangle, first, 12 * sizeof(int));
        b = build(&s, N3_RULE_PAPER, 0.5);
        CHECK(b.m.normals == (fold ? 8 : 5), row);
        for (i = 0; i < b.m.normals; i++) zero += same_vec(b.normal[i], n3_v(0, 0, 0));
        CHECK(zero == fold, row);
        for (i = 0; i < 12; i++) {
            int under = first + i >= triangle + 6 && first + i < triangle + 12;
            if (first[i] == 3 && !under) continue; /* the flat one at m */
            CHECK_VEC(b.normal[b.corner[i]], under ? below : n3_v(0, 0, 1), 2 * EPS, row);
        }
        built_free(&b);
        shape_free(&s);
    }
}

/* Triangles on a line have no normal to tell a crease by: it is one between any two of them, unless
   marks alone are asked for. All normals are zero. */
static void normals_on_line(void)
{
    shape s = shape_icosphere(0);
    int i, k;
    shape_drop_normals(&s);
    for (i = 0; i < s.points; i++) s.point[i] = n3_mul((n3_real)i, n3_v(1, 2, 3));
    for (k = 0; k < 2; k++) {
        built b = build(&s, N3_RULE_PAPER, k ? -1 : -0.99);
        CHECK(b.m.normals == (k ? 12 : 60), k);
        for (i = 0; i < b.m.normals; i++) CHECK_SAME(b.normal[i], n3_v(0, 0, 0), k);
        built_free(&b);
    }
    shape_free(&s);
}

/* Scaling by a power of two changes no bit, up to the largest and down to the smallest sizes. */
static void normals_scaled(void)
{
    int i, k;
    for (k = -1; k <= 1; k++) {
        shape s = shape_icosphere(1), big;
        built a, b;
        shape_drop_normals(&s);
        s.point[3] = n3_mul((n3_real)5 / 4, s.point[3]);
        big = shape_copy(&s);
        for (i = 0; i < s.points; i++)
            big.point[i] = n3_mul((n3_real)ldexp(1, k * (EPS < 1e-10 ? 498 : 59)), s.point[i]);
        a = build(&s, N3_RULE_PAPER, 0.7);
        b = build(&big, N3_RULE_PAPER, 0.7);
        CHECK(a.m.normals == b.m.normals, k);
        for (i = 0; i < a.m.normals; i++) CHECK_SAME(a.normal[i], b.normal[i], k);
        built_free(&a);
        built_free(&b);
        shape_free(&s);
        shape_free(&big);
    }
}

/* ---- Fields ---- */

/* A polynomial of a degree with other coefficients for each component. */
static double polynomial(int degree, int component, double x, double y)
{
    double p = 1 + component + 2 * x - 3 * y;
    if (degree > 1) p += x * x - (2 + component) * x * y + 3 * y * y;
    if (degree > 2) p += x * x * x - 4 * x * x * y + (1 - component) * x * y * y + 5 * y * y * y;
    return p;
}

/* The places of the nodes of a flat mesh. */
static int field_places(const built *b, int degree, n3_vec *place)
{
    int i, k, count = b->m.points;
    for (i = 0; i < b->m.points; i++) place[i] = b->net[i];
    for (i = 0; i < b->t.edges && degree > 1; i++) {
        n3_edge e = built_edge(b, i);
        for (k = 1; k < degree; k++)
            place[count++] =
                n3_add(e.p[0], n3_mul((n3_real)k / (n3_real)degree, n3_sub(e.p[3], e.p[0])));
    }
    for (i = 0; i < b->m.triangles && degree > 2; i++) {
        n3_patch p = built_patch(b, i);
        place[count++] = n3_mul((n3_real)1 / 3, n3_add(n3_add(p.p[0], p.p[1]), p.p[2]));
    }
    return count;
}

/* A soup in the plane, with unused points, in three parts for each edge. */
static void check_field(int degree, rng *r)
{
    enum { LEVEL = 4 };
    shape s = shape_soup(9, 8, r);
    built b;
    int i, k, nodes, points = 0, *parent, used[400] = {0};
    n3_vec place[200];
    n3_real nodal[400], *uv, *out;
    for (i = 0; i < s.points; i++) s.point[i].z = 0;
    b = build(&s, N3_RULE_PAPER, -1);
    nodes = field_places(&b, degree, place);
    for (i = 0; i < nodes; i++)
        for (k = 0; k < 2; k++)
            nodal[2 * i + k] =
                (n3_real)polynomial(degree, k, (double)place[i].x, (double)place[i].y);
    CHECK(n3_mesh_refine_counts(&b.m, &b.t, LEVEL, &points, NULL, NULL) == N3_OK, degree);
    parent = memory((size_t)points, sizeof *parent);
    uv = memory(2 * (size_t)points, sizeof *uv);
    out = memory(2 * (size_t)points, sizeof *out);
    for (i = 0; i < points; i++) parent[i] = -5;
    CHECK(n3_mesh_refine(&b.m, &b.t, b.net, LEVEL, NULL, NULL, NULL, NULL, parent, uv) == N3_OK,
          degree);
    CHECK(n3_mesh_field(&b.m, &b.t, degree, 2, nodal, parent, uv, points, out) == N3_OK, degree);
    for (i = 0; i < 3 * s.triangles; i++) used[s.triangle[i]] = 1;
    for (i = 0; i < points; i++) {
        n3_vec x = b.net[i < s.points ? i : 0];
        CHECK(parent[i] >= 0 ? i >= s.points || used[i] : parent[i] == -1 && !used[i], degree);
        if (parent[i] >= 0) {
            n3_patch p = built_patch(&b, parent[i]);
            n3_real u = uv[2 * i], v = uv[2 * i + 1];
            x = n3_add(n3_add(n3_mul(1 - u - v, p.p[0]), n3_mul(u, p.p[1])), n3_mul(v, p.p[2]));
        }
        /* Values are below 25; the weights' magnitudes add up to less than 2.3, and values and
           weights are good to 16 eps. */
        for (k = 0; k < 2; k++)
            CHECK_NEAR(out[2 * i + k], polynomial(degree, k, (double)x.x, (double)x.y),
                       25 * 2.3 * 16 * EPS, degree);
    }
    free(parent);
    free(uv);
    free(out);
    built_free(&b);
    shape_free(&s);
}

static void fields_of_polynomials(void)
{
    rng r = {3};
    long i, count = sample_count(60);
    for (i = 0; i < count; i++) check_field(1 + (int)(i % 3), &r);
}

/* All of count parents the same: a triangle of the cube, which has 8 points and 12 triangles, or -1
   for points in none. given: the values are. */
static void fields_refused(void)
{
    static const struct {
        int degree, components, parent, count, given;
        n3_status status;
    } rows[] = {{1, 1, 11, 9, 1, N3_OK},          {1, 1, -1, 8, 1, N3_OK},
                {1, 0, 11, 9, 1, N3_OK},          {3, 1, 11, 0, 0, N3_OK},
                {0, 1, 11, 9, 1, N3_BAD_COUNT},   {4, 1, 11, 9, 1, N3_BAD_COUNT},
                {1, -1, 11, 9, 1, N3_BAD_COUNT},  {1, 1, 11, -1, 1, N3_BAD_COUNT},
                {1, 1, 12, 9, 1, N3_BAD_COUNT},   {1, 1, -1, 9, 1, N3_BAD_COUNT},
                {1, 1, 11, 9, 0, N3_NULL_POINTER}};
    shape s = shape_cube();
    built b = build(&s, N3_RULE_PAPER, -1);
    size_t i;
    int k;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        n3_real nodal[8], uv[18] = {0}, out[10];
        int parent[9], count = rows[i].count;
        n3_status got;
        for (k = 0; k < 9; k++) parent[k] = rows[i].parent;
        for (k = 0; k < 10; k++) out[k] = 77;
        for (k = 0; k < 8; k++) nodal[k] = (n3_real)k;
        got = n3_mesh_field(&b.m, &b.t, rows[i].degree, rows[i].components,
                            rows[i].given ? nodal : NULL, parent, uv, count, out);
        CHECK(got == rows[i].status, i);
        for (k = 0; k < 10; k++) {
            int same = got != N3_OK || k >= count || rows[i].components == 0;
            int want = same ? 77 : rows[i].parent < 0 ? k : b.m.triangle[3 * 11];
            CHECK_NEAR(out[k], want, 0, i);
        }
    }
    built_free(&b);
    shape_free(&s);
}

/* ---- The report ---- */

static shape polar(int n) { return shape_polar(2 * n, n); }

/* A triangle turned over, its corners keeping their normals. */
static shape flipped_sphere(int n)
{
    shape s = shape_icosphere(n);
    int k = s.triangle[1];
    s.triangle[1] = s.corner[1] = s.triangle[2];
    s.triangle[2] = s.corner[2] = k;
    return s;
}

/* The second triangle, which shares a side with the first, gives way to a copy of it. */
static shape doubled_sphere(int n)
{
    shape s = shape_icosphere(n);
    memcpy(s.triangle + 3, s.triangle, 3 * sizeof(int));
    memcpy(s.corner + 3, s.corner, 3 * sizeof(int));
    return s;
}

/* back: -1 where inferred normals may well look back, at rims. */
static void report_counts(void)
{
    static const struct {
        shape (*make)(int);
        int n, edges, border, non_manifold, flipped, crease, half, collapsed, duplicate, back;
    } rows[] = {{shape_bracket, 3, 360, 0, 0, 0, 80, 0, 0, 0, 0},
                {shape_icosphere, 1, 120, 0, 0, 0, 0, 0, 0, 0, 0},
                {shape_cone, 8, 24, 0, 0, 0, 8, 0, 0, 0, 0},
                {shape_moebius, 9, 63, 18, 0, 2, 1, 1, 0, 0, 0},
                {shape_hourglass, 6, 36, 0, 0, 0, 0, 0, 0, 0, -1},
                {shape_sheets, 3, 7, 6, 1, 0, 1, 0, 0, 0, 0},
                {polar, 4, 72, 0, 0, 0, 0, 0, 16, 0, 0},
                {flipped_sphere, 0, 30, 0, 0, 3, 0, 0, 0, 0, 3},
                {doubled_sphere, 0, 30, 2, 2, 1, 0, 0, 0, 1, 0}};
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        shape s = rows[i].make(rows[i].n);
        built b = build(&s, N3_RULE_PAPER, -1);
        n3_report r = n3_mesh_report(&b.m, &b.t, b.net, b.flags);
        CHECK_NEAR(r.edges, rows[i].edges, 0, i);
        CHECK_NEAR(r.border_edges, rows[i].border, 0, i);
        CHECK_NEAR(r.non_manifold_edges, rows[i].non_manifold, 0, i);
        CHECK_NEAR(r.flipped_edges, rows[i].flipped, 0, i);
        CHECK_NEAR(r.crease_edges, rows[i].crease, 0, i);
        CHECK_NEAR(r.half_crease_edges, rows[i].half, 0, i);
        CHECK_NEAR(r.collapsed_triangles, rows[i].collapsed, 0, i);
        CHECK_NEAR(r.duplicate_triangles, rows[i].duplicate, 0, i);
        if (rows[i].back >= 0) CHECK_NEAR(r.flipped_normals, rows[i].back, 0, i);
        CHECK(r.points == s.points && r.triangles == s.triangles && r.normals == b.m.normals, i);
        CHECK(r.bad_points + r.bad_normals + r.bad_triangles + r.bad_corners == 0, i);
        CHECK(r.degenerate_edges + r.flat_triangles + r.zero_normals == 0, i);
        CHECK(r.unused_points == b.t.unused, i);
        built_free(&b);
        shape_free(&s);
    }
}

/* The smallest numbers that are not none. */
static void report_of_one(void)
{
    n3_vec x = {1, 2, 3};
    int triangle[3] = {0, 0, 0};
    n3_mesh m;
    n3_report r;
    memset(&m, 0, sizeof m);
    m.points = m.triangles = m.normals = 1;
    m.point = m.normal = &x.x;
    m.triangle = triangle;
    r = n3_mesh_report(&m, NULL, NULL, NULL);
    CHECK(r.points == 1 && r.triangles == 1 && r.normals == 1 && r.collapsed_triangles == 1, 0);
    m.points = m.triangles = m.normals = -1;
    r = n3_mesh_report(&m, NULL, NULL, NULL);
    CHECK(r.points == 0 && r.triangles == 0 && r.normals == 0 && r.collapsed_triangles == 0, 1);
}

/* A mesh with one of each fault, and what is left unknown without its topology. */
static void report_of_faults(void)
{
    shape s = shape_icosphere(1);
    n3_mesh m;
    n3_report r;
    s.point[0].x = (n3_real)NAN;
    s.point[5].z = (n3_real)INFINITY;
    s.normal[7] = n3_v(0, 0, 0);
    s.normal[9].x = (n3_real)NAN;
    s.triangle[0] = -1;
    s.triangle[4] = 42;
    s.triangle[5] = 2147483647;
    s.triangle[9] = 99;
    s.corner[6] = 42;
    s.corner[9] = -5;
    s.triangle[12] = s.triangle[13];
    m = shape_mesh(&s);
    r = n3_mesh_report(&m, NULL, NULL, NULL);
    CHECK(r.bad_points == 2 && r.bad_normals == 1 && r.bad_triangles == 3 && r.bad_corners == 1, 0);
    CHECK(r.collapsed_triangles == 1 && r.zero_normals >= 3, 0);
    CHECK(r.edges == -1 && r.border_edges == -1 && r.unused_points == -1, 0);
    CHECK(r.crease_edges == -1 && r.folding_patches == -1 && r.jump_edge == -1, 0);
    shape_free(&s);
}

/* Counts and indices of any value: it returns. */
static void report_of_garbage(void)
{
    rng r = {4};
    long i, count = sample_count(300);
    int k;
    for (i = 0; i < count; i++) {
        n3_vec point[6], normal[6];
        int triangle[24], corner[24];
        n3_mesh m;
        n3_report report;
        memset(&m, 0, sizeof m);
        for (k = 0; k < 6; k++)
            point[k] = n3_mul((n3_real)pow(10, rng_uniform(&r, -40, 40)), rng_vec(&r));
        for (k = 0; k < 6; k++) normal[k] = k % 3 ? rng_vec(&r) : n3_v(0, (n3_real)NAN, 0);
        for (k = 0; k < 24; k++) triangle[k] = (int)(rng_next(&r) % 9) - 1;
        for (k = 0; k < 24; k++) corner[k] = (int)(rng_next(&r) % 9) - 1;
        m.points = (int)(rng_next(&r) % 9) - 2;
        m.triangles = (int)(rng_next(&r) % 11) - 2;
        m.normals = (int)(rng_next(&r) % 9) - 2;
        if (m.points > 6) m.points = 6;
        if (m.normals > 6) m.normals = 6;
        m.point = rng_next(&r) % 8 ? &point[0].x : NULL;
        m.normal = rng_next(&r) % 8 ? &normal[0].x : NULL;
        m.triangle = rng_next(&r) % 8 ? triangle : NULL;
        m.corner = rng_next(&r) % 8 ? corner : NULL;
        report = n3_mesh_report(&m, NULL, NULL, NULL);
        CHECK(report.triangles <= 8 && report.triangles >= 0, i);
    }
}

/* On the sphere by the arc rule, which follows it to 1e-3 (accuracy: 8.5e-4 for 20 triangles), the
   distance to the farthest facet is 1 less that of its plane to the middle. */
static void report_measures(void)
{
    shape s = shape_icosphere(0), flat = shape_cube();
    built b = build(&s, N3_RULE_ARC, -1), c = build(&flat, N3_RULE_ARC, 0.5);
    n3_report r = n3_mesh_report(&b.m, &b.t, b.net, b.flags);
    n3_patch p = built_patch(&b, 0);
    n3_vec plane = n3_unit(n3_cross(n3_sub(p.p[1], p.p[0]), n3_sub(p.p[2], p.p[0])));
    double jump = 0;
    int i;
    CHECK_NEAR(r.distance, 1 - (double)n3_dot(plane, p.p[0]), 1e-3, 0);
    CHECK(r.distance_triangle >= 0 && r.distance_triangle < 20, 0);
    for (i = 0; i < b.t.edges; i++) {
        int two[2], k, q;
        for (k = 0; k < 2; k++) two[k] = b.t.side[b.t.first[i] + k];
        for (q = 1; q < 4; q++) {
            n3_vec n[2];
            for (k = 0; k < 2; k++) {
                n3_real L[3] = {0, 0, 0}, t = (n3_real)(k ? 4 - q : q) / 4;
                L[two[k] % 3] = 1 - t;
                L[(two[k] + 1) % 3] = t;
                p = built_patch(&b, two[k] / 3);
                n[k] = n3_patch_normal(&p, L[1], L[2]);
            }
            jump = fmax(jump, (double)n3_len(n3_sub(n[0], n[1])));
        }
    }
    CHECK_NEAR(r.jump, jump, 16 * EPS, 0);
    CHECK(jump > 1e-4 && r.jump_edge >= 0 && r.folding_patches == 0, 0);
    r = n3_mesh_report(&c.m, &c.t, c.net, c.flags);
    CHECK(r.distance <= 4 * (n3_real)EPS && r.jump <= 16 * (n3_real)EPS, 1);
    CHECK(r.straight_edges == 18 && r.crease_edges == 12 && r.folding_patches == 0, 1);
    built_free(&b);
    built_free(&c);
    shape_free(&s);
    shape_free(&flat);
}

/* A patch near the flat one over (0, 0), (1, 0), (0, 1), its points moved by up to reach. */
static n3_patch shaken_patch(rng *r, n3_real reach)
{
    n3_vec z = n3_v(0, 0, 1);
    n3_vertex a = {{0, 0, 0}, {0, 0, 0}}, b = {{1, 0, 0}, {0, 0, 0}}, c = {{0, 1, 0}, {0, 0, 0}};
    n3_patch p;
    int k;
    a.n = b.n = c.n = z;
    p = n3_patch_make(a, b, c, NULL);
    for (k = 0; k < 10; k++) p.p[k] = n3_add(p.p[k], n3_mul(reach, rng_vec(r)));
    return p;
}

/* The net of the normal is the polynomial 9 sum net[i][j] u^i v^j w^k, i + j + k = 4. Its terms
   are below 4, there are 36 of them. */
static void net_of_normal(void)
{
    rng r = {14};
    long q, count = sample_count(500);
    for (q = 0; q < count; q++) {
        n3_patch p = shaken_patch(&r, (n3_real)1 / 2);
        n3_vec net[5][5], sum = n3_v(0, 0, 0);
        n3_real u = (n3_real)rng_uniform(&r, 0, 1), v = (1 - u) * (n3_real)rng_uniform(&r, 0, 1);
        n3_jet jet = n3_patch_jet(&p, u, v);
        int i, j, k;
        n3i_normal_net(&p, net);
        for (i = 0; i < 5; i++)
            for (j = 0; i + j < 5; j++) {
                n3_real weight = 9;
                for (k = 0; k < 4; k++) weight *= k < i ? u : k < i + j ? v : 1 - u - v;
                sum = n3_add(sum, n3_mul(weight, net[i][j]));
            }
        CHECK_VEC(sum, n3_cross(jet.du, jet.dv), 9 * 36 * 4 * EPS, q);
    }
}

/* The middle pulled out of the triangle folds the patch; and no patch that is said not to fold has,
   on a lattice, a normal that turns away from that of its outline. */
static void folds(void)
{
    rng r = {5};
    long i, count = sample_count(2000);
    int u, v, sound = 0;
    n3_patch p = shaken_patch(&r, 0);
    CHECK(!n3_patch_may_fold(&p), 0);
    p.p[9] = n3_v(2, 2, 0);
    CHECK(n3_patch_may_fold(&p), 1);
    for (i = 0; i < count; i++) {
        n3_patch q = shaken_patch(&r, (n3_real)(i % 5 + 1) / 25);
        n3_vec sum = n3i_net_area(q.p);
        if (n3_patch_may_fold(&q)) continue;
        sound++;
        for (u = 0; u <= 8; u++)
            for (v = 0; u + v <= 8; v++) {
                n3_vec n = n3_patch_normal(&q, (n3_real)u / 8, (n3_real)v / 8);
                CHECK(n3_dot(n, sum) > 0, i);
            }
    }
    CHECK(sound > count / 5, sound);
}

/* A point in no triangle keeps its place and has no parent and no parameters. */
static void unused_points_refined(void)
{
    static const n3_real point[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 6, 7}};
    static const int triangle[3] = {0, 1, 2};
    n3_mesh m = {4, 1, 0, &point[0][0], 0, triangle, 0, NULL, 0, NULL, 0};
    n3_topology t;
    n3_vec net[4 + 6 + 1], fine[7];
    int work[32], parent[7];
    n3_real uv[14];
    CHECK(n3_mesh_topology(&m, work, sizeof work, &t, NULL) == N3_OK, 0);
    CHECK(n3_mesh_net(&m, &t, NULL, net, NULL, NULL) == N3_OK, 0);
    CHECK(n3_mesh_refine(&m, &t, net, 2, fine, NULL, NULL, NULL, parent, uv) == N3_OK, 0);
    CHECK_SAME(fine[3], n3_v(5, 6, 7), 0);
    CHECK(parent[3] == -1 && parent[4] == 0, 0);
    CHECK(same_real(uv[6], 0) && same_real(uv[7], 0), 0);
}

/* The largest jump at a smooth edge is looked for along all of it: it is the same when the two
 * triangles change places, so that its quarters are met in reverse. */
static void jump_from_both_ends(void)
{
    static const int triangles[2][6] = {{0, 1, 2, 1, 0, 3}, {1, 0, 3, 0, 1, 2}};
    static const double place[4][2] = {{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}};
    rng r = {77};
    long i, count = sample_count(500);
    for (i = 0; i < count; i++) {
        n3_vec point[4], normal[4];
        n3_real jump[2];
        int k, way;
        for (k = 0; k < 4; k++) {
            n3_vec lean = n3_mul((n3_real)1 / 4, rng_vec(&r));
            point[k] = n3_v((n3_real)place[k][0], (n3_real)place[k][1], lean.z);
            normal[k] = n3_unit(n3_v(lean.x, lean.y, 1));
        }
        for (way = 0; way < 2; way++) {
            n3_mesh m = {4, 2, 4, NULL, 0, NULL, 0, NULL, 0, NULL, 0};
            n3_topology t;
            n3_vec net[4 + 10 + 2];
            unsigned flags[5];
            int work[64];
            m.point = &point[0].x;
            m.triangle = triangles[way];
            m.normal = &normal[0].x;
            CHECK(n3_mesh_topology(&m, work, sizeof work, &t, NULL) == N3_OK, i);
            CHECK(n3_mesh_net(&m, &t, NULL, net, flags, NULL) == N3_OK, i);
            jump[way] = n3_mesh_report(&m, &t, net, flags).jump;
        }
        /* The normals' error, 28 eps over the sine of du and dv, which is above 1/8 here. */
        CHECK_NEAR(jump[0], jump[1], 2 * 8 * 28 * EPS, i);
    }
}

/* What stands in the arrays before does not matter: three fans of one corner, three normals. */
static void normals_into_used_room(void)
{
    static const n3_real point[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const int triangle[3] = {0, 1, 2};
    n3_mesh m = {3, 1, 0, &point[0][0], 0, triangle, 0, NULL, 0, NULL, 0};
    n3_topology t;
    n3_vec normal[3];
    int work[32], corner[3] = {2147483647, 2147483647, 2147483647}, normals = 0;
    CHECK(n3_mesh_topology(&m, work, sizeof work, &t, NULL) == N3_OK, 0);
    CHECK(n3_mesh_normals(&m, &t, -1, NULL, normal, corner, &normals, NULL) == N3_OK, 0);
    CHECK(normals == 3 && corner[0] == 0 && corner[1] == 1 && corner[2] == 2, normals);
}

/* A thin triangle that looks down does not fold: nothing but the patch decides. */
static void thin_patch_does_not_fold(void)
{
    n3_vertex a = {{0, 0, 0}, {0, 0, -1}}, b = {{0, (n3_real)0.001, 0}, {0, 0, -1}};
    n3_vertex c = {{1, 0, 0}, {0, 0, -1}};
    n3_patch p = n3_patch_make(a, b, c, NULL);
    CHECK(!n3_patch_may_fold(&p), 0);
}

/* Triangles without an area: their points are linear in u and v, and so are those of the patch. */
static void distance_from_a_line(void)
{
    shape s = shape_pillow();
    built b;
    n3_report r;
    s.point[2] = n3_v((n3_real)0.4, 0, 0);
    b = build(&s, N3_RULE_PAPER, -1);
    r = n3_mesh_report(&b.m, &b.t, b.net, b.flags);
    CHECK(r.flat_triangles == 2 && r.distance <= 8 * (n3_real)EPS, 0);
    built_free(&b);
    shape_free(&s);
}

const test_case tests_mesh[] = {{"unused_points_refined", unused_points_refined},
                                {"distance_from_a_line", distance_from_a_line},
                                {"jump_from_both_ends", jump_from_both_ends},
                                {"thin_patch_does_not_fold", thin_patch_does_not_fold},
                                {"normals_into_used_room", normals_into_used_room},
                                {"topology_of_soup", topology_of_soup},
                                {"status_of_faults", status_of_faults},
                                {"status_of_topology", status_of_topology},
                                {"status_of_pointers", status_of_pointers},
                                {"status_texts", status_texts},
                                {"counts_overflow", counts_overflow},
                                {"unnamed_normals", unnamed_normals},
                                {"empty_mesh", empty_mesh},
                                {"strides", strides},
                                {"normals_on_sphere", normals_on_sphere},
                                {"normals_of_cube", normals_of_cube},
                                {"normals_counted", normals_counted},
                                {"normals_at_border", normals_at_border},
                                {"normals_given", normals_given},
                                {"normals_given_apart", normals_given_apart},
                                {"normals_that_cancel", normals_that_cancel},
                                {"normals_of_flat_tetrahedra", normals_of_flat_tetrahedra},
                                {"normals_beside_flat_triangle", normals_beside_flat_triangle},
                                {"normals_on_line", normals_on_line},
                                {"normals_scaled", normals_scaled},
                                {"fields_of_polynomials", fields_of_polynomials},
                                {"fields_refused", fields_refused},
                                {"report_counts", report_counts},
                                {"report_of_one", report_of_one},
                                {"report_of_faults", report_of_faults},
                                {"report_of_garbage", report_of_garbage},
                                {"report_measures", report_measures},
                                {"net_of_normal", net_of_normal},
                                {"folds", folds},
                                {NULL, NULL}};
