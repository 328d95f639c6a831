/* Many patches at once: as one at a time, wherever the range is cut. */
#include "built.h"
#include "samples.h"

#include <math.h>

enum { PATCHES = 11, LEVELS = 5, LARGEST = 9, POINTS = (LARGEST + 1) * (LARGEST + 2) / 2 };
static const int levels[LEVELS] = {1, 2, 3, 8, LARGEST};

/* Patches of all kinds; an edge in three is a loop, so that it has no canonical end. */
static void make_patches(long row, n3_patch *p)
{
    static const n3_options rules[2] = {{N3_RULE_PAPER, 0, 0}, {N3_RULE_ARC, 0, 0}};
    int i;
    for (i = 0; i < PATCHES; i++) {
        sample s = sample_make(PATCHES * row + i);
        p[i] = n3_patch_make(s.v[0], s.v[1], s.v[2], &rules[i % 2]);
        if (i == 5 && row % 3 == 0) p[i].p[1] = p[i].p[0];
        if (i == 5 && row % 6 == 0) p[i].p[4] = p[i].p[3];
    }
}

/* The point at i / level, from the end that comes first in x, y and z; between equal ends from the
   inner control points' first, and if these are equal, from the nearer. */
static n3_vec side_point(n3_edge e, int i, int level)
{
    const n3_real *p[4];
    int k, order = 0;
    for (k = 0; k < 4; k++) p[k] = &e.p[k].x;
    for (k = 0; k < 3 && !order; k++) order = (p[0][k] > p[3][k]) - (p[0][k] < p[3][k]);
    for (k = 0; k < 3 && !order; k++) order = (p[1][k] > p[2][k]) - (p[1][k] < p[2][k]);
    if (order > 0 || (order == 0 && 2 * i > level)) {
        e = n3_edge_reverse(&e);
        i = level - i;
    }
    return n3_edge_point(&e, (n3_real)i / (n3_real)level);
}

/* Inside, with M the largest coordinate, the roundings of all steps add up to 50 eps M at level 3,
   193 at 8, 340 at 64, if every one is as large as it can be and of the worst sign; their root mean
   square, over 10^8 numbers, is 1.6 eps M at most, the largest 27. A side has the bits of the plain
   form. */
static void check_point(const n3_patch *p, int level, int i, int j, n3_vec got, long row)
{
    n3_edge side[3];
    n3_vec want = n3_patch_point(p, (n3_real)i / (n3_real)level, (n3_real)j / (n3_real)level);
    double bound = 64;
    n3_patch_edges(p, side);
    if (i + j == level) want = side_point(side[1], j, level);
    if (i == 0) want = side_point(side[2], level - j, level);
    if (j == 0) want = side_point(side[0], i, level);
    if (i == 0 || j == 0 || i + j == level) bound = CONTRACTED * 4;
    CHECK_VEC(got, want, bound * EPS * reach(p->p, 10), row);
}

static void check_normal(const n3_patch *p, int level, int i, int j, n3_vec got, long row)
{
    n3_real u = (n3_real)i / (n3_real)level, v = (n3_real)j / (n3_real)level;
    if (i + j == level) v = 1 - u;
    CHECK_VEC(got, n3_patch_normal(p, u, v), normal_bound(p, u, v), row);
    CHECK(fabs((double)n3_len(got) - 1) <= 4 * EPS || n3_len(got) <= 0, row);
}

typedef void lattices(const n3_patch *patch, int first, int last, int level, n3_vec *out);
typedef void blocks(const n3_patch *patch, int first, int last, int level, n3_real *out);
typedef void check_one(const n3_patch *p, int level, int i, int j, n3_vec got, long row);

static const struct { lattices *in_rows; blocks *in_blocks; check_one *check; } calls[2] = {
    {n3_lattice_points, n3_lattice_point_blocks, check_point},
    {n3_lattice_normals, n3_lattice_normal_blocks, check_normal}};

/* Every number of lattices against the plain form. */
static void check_lattices(int call, const n3_patch *p, int count, int level, const n3_vec *x,
                           long row)
{
    int f, i, j;
    for (f = 0; f < count; f++)
        for (j = 0; j <= level; j++)
            for (i = 0; i <= level - j; i++) calls[call].check(&p[f], level, i, j, *x++, row);
}

static void against_plain(int call)
{
    static n3_vec x[PATCHES * POINTS];
    long row, rows = sample_count(100);
    for (row = 0; row < rows; row++) {
        n3_patch p[PATCHES];
        int level = levels[row % LEVELS];
        make_patches(row, p);
        calls[call].in_rows(p, 0, PATCHES, level, x);
        check_lattices(call, p, PATCHES, level, x, row);
    }
}

static void lattice_points(void) { against_plain(0); }
static void lattice_normals(void) { against_plain(1); }

/* Where handles of a corner are nearly parallel, du x dv there has no more than a fiftieth of the
   digits that the wide form asks for: the plain form makes all normals. */
static void normals_at_a_sharp_corner(void)
{
    const n3_real angle = (n3_real)(EPS < 1e-10 ? 1e-8 : 2e-5);
    static const n3_real uv[10][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0},
                                      {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    n3_patch p;
    n3_vec n[POINTS];
    n3_real u, v;
    int i, j, at = 0;
    for (i = 0; i < 10; i++) p.p[i] = n3_v(uv[i][0], uv[i][1], uv[i][0] * uv[i][1] / 8);
    p.p[8] = n3_v(1, angle, 0);
    n3_lattice_normals(&p, 0, 1, LARGEST, n);
    for (j = 0; j <= LARGEST; j++)
        for (i = 0; i <= LARGEST - j; i++, at++) {
            u = (n3_real)i / LARGEST;
            v = i + j == LARGEST ? 1 - u : (n3_real)j / LARGEST;
            CHECK_VEC(n[at], n3_patch_normal(&p, u, v), CONTRACTED * 64 * EPS, at);
        }
}

/* The patch seen from its corner b, and turned over: the same points on its sides. */
static void lattice_sides_agree(void)
{
    static const int turned[10] = {1, 2, 0, 5, 6, 7, 8, 3, 4, 9};
    static const int over[10] = {1, 0, 2, 4, 3, 8, 7, 6, 5, 9};
    long row, rows = sample_count(300);
    for (row = 0; row < rows; row++) {
        n3_patch p[PATCHES], q[3];
        n3_vec x[3 * POINTS];
        int i, k, level = levels[row % LEVELS], count = (level + 1) * (level + 2) / 2;
        make_patches(row, p);
        q[0] = p[row % PATCHES];
        for (i = 0; i < 10; i++) q[1].p[i] = q[0].p[turned[i]];
        for (i = 0; i < 10; i++) q[2].p[i] = q[0].p[over[i]];
        n3_lattice_points(q, 0, 3, level, x);
        for (i = 0, k = 0; i <= level; k += level + 1 - i, i++) { /* k: the first of row i */
            CHECK_SAME(x[count + i], x[k + level - i], row);      /* bc */
            CHECK_SAME(x[2 * count + level - i], x[i], row);      /* ba */
            CHECK_SAME(x[2 * count + k + level - i], x[k], row);  /* ac */
        }
    }
}

/* Any part of the range gives the same bits; one item alone too. But a compiler that contracts may
   do so otherwise where it knows the range, which normals have shown. */
static void ranges(void)
{
    static n3_vec all[2][PATCHES * POINTS], part[2][PATCHES * POINTS];
    static int t[PATCHES * LARGEST * LARGEST * 3], s[PATCHES * LARGEST * LARGEST * 3];
    long row, rows = sample_count(60);
    for (row = 0; row < rows; row++) {
        n3_patch p[PATCHES];
        int i, level = levels[row % LEVELS], size = (level + 1) * (level + 2) / 2;
        int first = (int)(row % PATCHES), last = first + (int)(row / PATCHES % (PATCHES - first));
        int triangles = 3 * level * level;
        make_patches(row, p);
        n3_lattice_points(p, 0, PATCHES, level, all[0]);
        n3_lattice_normals(p, 0, PATCHES, level, all[1]);
        n3_lattice_triangles(0, PATCHES, level, t);
        n3_lattice_points(p, first, last, level, part[0]);
        n3_lattice_normals(p, first, last, level, part[1]);
        n3_lattice_triangles(first, last, level, s);
        for (i = 0; i < size * (last - first); i++) {
            CHECK_SAME(part[0][i], all[0][size * first + i], row);
            if (!CONTRACTED) CHECK_SAME(part[1][i], all[1][size * first + i], row);
        }
        for (i = 0; i < triangles * (last - first); i++)
            CHECK(s[i] == t[triangles * first + i], row);
    }
}

/* As n3_mesh_refine numbers its normals. */
static void lattice_triangles(void)
{
    shape s = shape_icosphere(0);
    built b = build(&s, N3_RULE_PAPER, -1);
    int i, k, count;
    for (k = 0; k < LEVELS; k++) {
        int *corner, *triangle;
        n3_mesh_refine_counts(&b.m, &b.t, levels[k], NULL, &count, NULL);
        corner = memory(3 * (size_t)count, sizeof *corner);
        triangle = memory(3 * (size_t)count, sizeof *triangle);
        n3_mesh_refine(&b.m, &b.t, b.net, levels[k], NULL, NULL, NULL, corner, NULL, NULL);
        n3_lattice_triangles(0, b.m.triangles, levels[k], triangle);
        for (i = 0; i < 3 * count; i++) CHECK(corner[i] == triangle[i], k);
        free(corner);
        free(triangle);
    }
    built_free(&b);
    shape_free(&s);
}

/* Scattered parameters, a third of them on sides, in ranges of every length. */
static void scattered(void)
{
    enum { ITEMS = 30 };
    long row, rows = sample_count(200);
    for (row = 0; row < rows; row++) {
        n3_patch p[PATCHES];
        n3_real uv[2 * ITEMS];
        int parent[ITEMS], i, k, first = (int)(row % 7), last = ITEMS - (int)(row % 5);
        n3_vec x[ITEMS + 1], n[ITEMS + 1];
        n3_jet j[ITEMS + 1];
        rng r = {(uint64_t)row};
        make_patches(row, p);
        for (i = 0; i < ITEMS; i++) {
            parent[i] = (int)(rng_next(&r) % PATCHES);
            dyadic_weights(&r, &uv[2 * i], &uv[2 * i + 1]);
        }
        x[last - first] = n[last - first] = j[last - first].x = n3_v(1, 2, 3);
        n3_patch_points(p, parent, uv, first, last, x);
        n3_patch_jets(p, parent, uv, first, last, j);
        n3_patch_normals(p, parent, uv, first, last, n);
        CHECK_SAME(x[last - first], n3_v(1, 2, 3), row); /* nothing behind the last */
        CHECK_SAME(n[last - first], n3_v(1, 2, 3), row);
        CHECK_SAME(j[last - first].x, n3_v(1, 2, 3), row);
        for (i = first; i < last; i++) {
            const n3_patch *q = &p[parent[i]];
            const n3_jet want = n3_patch_jet(q, uv[2 * i], uv[2 * i + 1]);
            const n3_vec *a = &want.x, *b = &j[i - first].x;
            double bound = 64 * CONTRACTED * EPS * reach(q->p, 10);
            CHECK_VEC(x[i - first], want.x, bound, row);
            for (k = 0; k < 6; k++) CHECK_VEC(b[k], a[k], 4 * bound, row);
            CHECK_VEC(n[i - first], n3_patch_normal(q, uv[2 * i], uv[2 * i + 1]),
                      normal_bound(q, uv[2 * i], uv[2 * i + 1]), row);
        }
    }
}

static void check_centre(const built *b, int triangle, int rule, long row)
{
    n3_patch p = built_patch(b, triangle);
    n3_edge e[3];
    n3_vec n[3], want;
    int i;
    n3_patch_edges(&p, e);
    for (i = 0; i < 3; i++) n[i] = b->normal[b->m.triangle[3 * triangle + i]];
    want = rule == N3_RULE_ARC ? n3_patch_centre_arc(&e[0], &e[1], &e[2], n, NULL)
                               : n3_patch_centre(&e[0], &e[1], &e[2]);
    CHECK_SAME(p.p[9], want, row);
}

/* The net in parts is the net; edges of triangles in a soup, with normals of all kinds, are those
   of n3_edge_make where all triangles name the same, and centres those of the plain form. */
static void net_in_parts(void)
{
    static const int triangle[9] = {0, 1, 2, 1, 0, 3, 2, 1, 4};
    long row, rows = sample_count(300);
    for (row = 0; row < rows; row++) {
        n3_vec point[5], normal[5], net[5 + 2 * 7 + 3];
        n3_options o = {(int)(row % 3), 0, 0};
        n3_mesh m = {5, 3, 5, NULL, 0, NULL, 0, NULL, 0, NULL, 0};
        sample s = sample_make(row), q = sample_make(row + 1);
        built b;
        int i, cut, end[2];
        for (i = 0; i < 5; i++) point[i] = i < 3 ? s.v[i].x : q.v[i - 3].x;
        for (i = 0; i < 5; i++) normal[i] = i < 3 ? s.v[i].n : q.v[i - 3].n;
        m.point = &point[0].x;
        m.triangle = triangle;
        m.normal = &normal[0].x;
        b = build_mesh(&m, o.rule, -1);
        cut = (int)(row % (b.t.edges + 1));
        for (i = 0; i < 5; i++) net[i] = point[i];
        n3_mesh_edges(&b.m, &b.t, &o, cut, b.t.edges, net, NULL);
        n3_mesh_edges(&b.m, &b.t, &o, 0, cut, net, NULL);
        n3_mesh_centres(&b.m, &b.t, &o, 0, 1, net);
        n3_mesh_centres(&b.m, &b.t, &o, 1, 3, net);
        for (i = 0; i < b.nodes; i++) CHECK_SAME(net[i], b.net[i], row);
        for (i = 0; i < b.t.edges && !CONTRACTED; i++) {
            n3_vertex v[2];
            n3_edge e = built_edge(&b, i), want;
            n3_mesh_edge_ends(&b.m, &b.t, i, end);
            for (cut = 0; cut < 2; cut++) {
                v[cut].x = point[end[cut]];
                v[cut].n = b.normal[end[cut]];
            }
            want = n3_edge_make(v[0], v[1], &o);
            for (cut = 0; cut < 4; cut++) CHECK_SAME(e.p[cut], want.p[cut], row);
        }
        for (i = 0; i < 3 && !CONTRACTED && o.rule != N3_RULE_FIT; i++)
            check_centre(&b, i, o.rule, row);
        built_free(&b);
    }
}

/* Two triangles at an edge name one normal at its first end, and one or two at its second; the same
   normals under other names give the same net. */
static void names_of_normals(void)
{
    static const int triangle[6] = {0, 1, 2, 1, 0, 3}, apart[6] = {0, 1, 2, 4, 5, 3};
    long row, rows = sample_count(300);
    for (row = 0; row < rows; row++) {
        n3_vec point[4], normal[6];
        int shared[6] = {0, 1, 2, 1, 0, 3}, i;
        n3_mesh m = {4, 2, 6, NULL, 0, NULL, 0, NULL, 0, NULL, 0};
        sample s = sample_make(row), q = sample_make(row + 1);
        built a, b;
        for (i = 0; i < 4; i++) point[i] = i < 3 ? s.v[i].x : q.v[0].x;
        for (i = 0; i < 4; i++) normal[i] = i < 3 ? s.v[i].n : q.v[0].n;
        if (row % 2) shared[3] = 4;
        normal[4] = row % 2 ? q.v[1].n : normal[1];
        normal[5] = normal[0];
        m.point = &point[0].x;
        m.triangle = triangle;
        m.normal = &normal[0].x;
        m.corner = shared;
        a = build_mesh(&m, (int)(row % 3), -1);
        m.corner = apart;
        b = build_mesh(&m, (int)(row % 3), -1);
        for (i = 0; i < a.nodes; i++)
            CHECK_VEC(a.net[i], b.net[i], CONTRACTED * 64 * EPS * reach(a.net, a.nodes), row);
        for (i = 0; i < a.t.edges; i++) CHECK(a.flags[i] == b.flags[i], row);
        built_free(&a);
        built_free(&b);
    }
}

/* Levels whose rows are longer than can be held, and than the table of weights. */
static void long_rows(void)
{
    static const int level[] = {N3I_WEIGHTS - 1, N3I_WEIGHTS, N3I_ROW, N3I_ROW + 2, 131};
    int i, call;
    for (i = 0; i < 5; i++) {
        size_t size = (size_t)(level[i] + 1) * (size_t)(level[i] + 2) / 2;
        n3_vec *x = memory(PATCHES * size, sizeof *x);
        n3_patch p[PATCHES];
        make_patches(i + 1, p);
        for (call = 0; call < 2; call++) {
            calls[call].in_rows(p, 0, PATCHES, level[i], x);
            check_lattices(call, p, PATCHES, level[i], x, i);
        }
        free(x);
    }
}

static const n3_real guard = 12345;

static n3_real *guarded(size_t count)
{
    n3_real *x = memory(count, sizeof *x);
    while (count-- > 0) x[count] = guard;
    return x;
}

/* The numbers that are not to be written, before and behind the others. */
static void check_guards(const n3_real *x, size_t first, size_t last, size_t count, long row)
{
    size_t i;
    for (i = 0; i < count; i++)
        if (i < first || i >= last) CHECK(memcmp(&x[i], &guard, sizeof guard) == 0, row);
}

/* Rows from blocks, the last block with all its patches. */
static n3_vec *unblocked(const n3_real *from, int patches, size_t size)
{
    n3_vec *x = memory((size_t)patches * size, sizeof *x);
    size_t f, i;
    for (f = 0; f < (size_t)patches; f++)
        for (i = 0; i < size; i++) {
            const n3_real *at = from + (f / N3_BLOCK * size + i) * 3 * N3_BLOCK + f % N3_BLOCK;
            x[f * size + i] = n3_v(at[0], at[N3_BLOCK], at[2 * N3_BLOCK]);
        }
    return x;
}

/* Blocks have the same bits, of some patches and of so many that they are written past the caches,
   from any address; the last patch fills the last block. */
static void check_blocks(const n3_patch *p, int first, int last, int level, size_t skip, long row)
{
    size_t size = (size_t)(level + 1) * (size_t)(level + 2) / 2, each = size * sizeof(n3_vec);
    int call, f, count = last - first, whole = (count + N3_BLOCK - 1) / N3_BLOCK * N3_BLOCK;
    size_t end = skip + 3 * size * (size_t)whole, room = end + 2 * N3I_LINE;
    n3_vec *x = memory((size_t)count, each);
    for (call = 0; call < 2; call++) {
        n3_real *out = guarded(room);
        n3_vec *got;
        calls[call].in_rows(p, first, last, level, x);
        calls[call].in_blocks(p, first, last, level, out + skip);
        check_guards(out, skip, end, room, row);
        got = unblocked(out + skip, whole, size);
        if (CONTRACTED) check_lattices(call, p + first, count, level, got, row);
        for (f = CONTRACTED ? count : 0; f < whole; f++) {
            const n3_vec *want = CONTRACTED ? got : x;
            want += (size_t)(f < count ? f : count - 1) * size;
            CHECK(memcmp(got + (size_t)f * size, want, each) == 0, row);
        }
        free(out);
        free(got);
    }
    free(x);
}

static void lattice_blocks(void)
{
    long row, rows = sample_count(60);
    n3_patch p[2 * PATCHES];
    for (row = 0; row < rows; row++) {
        int first = (int)(row % 2) * N3_BLOCK, last = first + 1 + (int)(row % PATCHES);
        make_patches(row, p);
        make_patches(row + 1, p + PATCHES);
        check_blocks(p, first, last, levels[row % LEVELS], (size_t)row % N3I_LINE, row);
    }
    check_blocks(p, 0, PATCHES, N3I_ROW + 9, 0, rows);
}

/* Patches of SEVERAL kinds, so many that their lattices are written past the caches: as one at a
   time, from any address, whatever is left over, and nothing but them. */
enum { SEVERAL = 10 * PATCHES };

static void check_past(int call, const n3_patch *some, int level, long row)
{
    size_t each = 3 * (size_t)(level + 1) * (size_t)(level + 2) / 2, skip = (size_t)row;
    int i, count = (int)(N3I_FAR / sizeof(n3_real) / each) + 1 + 37 * (int)row;
    size_t last = skip + each * (size_t)count, room = last + 2 * N3I_LINE;
    n3_patch *p = memory((size_t)count, sizeof *p);
    n3_real *one = memory(SEVERAL * each, sizeof *one), *out = guarded(room);
    for (i = 0; i < count; i++) p[i] = some[i % SEVERAL];
    for (i = 0; i < SEVERAL; i++)
        calls[call].in_rows(some, i, i + 1, level, (n3_vec *)(void *)(one + each * (size_t)i));
    calls[call].in_rows(p, 0, count, level, (n3_vec *)(void *)(out + skip));
    check_guards(out, skip, last, room, row);
    for (i = 0; i < count; i++)
        CHECK(memcmp(out + skip + each * (size_t)i, one + each * (size_t)(i % SEVERAL),
                     each * sizeof *one) == 0, i);
    if (level == 8) check_blocks(p, 0, count, level, row == 3 ? 0 : N3I_LINE / 4, row);
    free(out);
    free(one);
    free(p);
}

static void lattices_past_the_caches(void)
{
    static const int level[] = {1, 2, 5, 8, 8, N3I_ROW + 9};
    static n3_patch some[SEVERAL];
    int i;
    for (i = 0; i < SEVERAL; i += PATCHES) make_patches(i / PATCHES, some + i);
    for (i = 0; i < 6; i++) check_past(i % 2, some, level[i], i);
}

const test_case tests_batch[] = {{"lattice_points", lattice_points},
                                 {"lattices_past_the_caches", lattices_past_the_caches},
                                 {"long_rows", long_rows},
                                 {"lattice_blocks", lattice_blocks},
                                 {"lattice_normals", lattice_normals},
                                 {"normals_at_a_sharp_corner", normals_at_a_sharp_corner},
                                 {"lattice_sides_agree", lattice_sides_agree},
                                 {"ranges", ranges},
                                 {"lattice_triangles", lattice_triangles},
                                 {"scattered", scattered},
                                 {"net_in_parts", net_in_parts},
                                 {"names_of_normals", names_of_normals},
                                 {NULL, NULL}};
