/* awkward.c: borders that are no loops, loops that are hard to join, and numbers at the limits. */
#include "joined.h"

/* ---- Borders ---- */

/* Open shapes of the other tests: how many loops they have, and how many of these are closed. */
static void test_borders(void)
{
    static const int want[][2] = {{1, 0}, {0, 0}, {3, 0}, {0, 0}, {0, 0}};
    shape s[5];
    int i, k;
    s[0] = shape_moebius(8);
    s[1] = shape_cube();
    s[2] = shape_sheets(3);
    s[3] = shape_pillow();
    s[4] = shape_icosphere(1);
    for (i = 0; i < 5; i++) {
        n3_mesh m = shape_mesh(&s[i]);
        body b;
        int closed = 0;
        body_open(&m, &b);
        for (k = 0; k < b.border.loops; k++) closed += b.border.loop[k].closed;
        CHECK(b.border.loops == want[i][0] || (want[i][0] && b.border.loops > 0), i);
        CHECK(closed == want[i][1], i);
        if (b.border.loops) {
            int point = n3i_at(&m, b.side[0]);
            CHECK(body_take(&b, point) == JOIN_OPEN, i);
        }
        CHECK(body_take(&b, -1) == JOIN_NO_LOOP, i);
        CHECK(join_rim_make(&b.border, b.border.loops, 0, b.vertex, &b.rim) == JOIN_NO_LOOP, i);
        body_free(&b);
        shape_free(&s[i]);
    }
}

/* A plate of cells with the corners (i, j) of a grid of side 6, looking up; out[] cells are left
   out. */
enum { SIDE = 6 };
typedef struct plate {
    n3_vec point[(SIDE + 1) * (SIDE + 1)];
    int triangle[6 * SIDE * SIDE];
} plate;

static n3_mesh plate_make(plate *p, const char *const hole[SIDE], n3_real z)
{
    n3_mesh m;
    int i, j, k = 0;
    memset(&m, 0, sizeof m);
    for (j = 0; j <= SIDE; j++)
        for (i = 0; i <= SIDE; i++) p->point[j * (SIDE + 1) + i] = n3_v((n3_real)i, (n3_real)j, z);
    for (j = 0; j < SIDE; j++)
        for (i = 0; i < SIDE; i++) {
            const int a = j * (SIDE + 1) + i;
            const int corner[6] = {a, a + 1, a + SIDE + 2, a, a + SIDE + 2, a + SIDE + 1};
            if (hole[j][i] != '.') continue;
            memcpy(p->triangle + k, corner, sizeof corner);
            k += 6;
        }
    m.points = (SIDE + 1) * (SIDE + 1);
    m.triangles = k / 3;
    m.point = &p->point[0].x;
    m.triangle = p->triangle;
    return m;
}

/* Several loops. Two holes that touch in a point are one, which passes it twice: so the triangles
   between the holes run. */
static void test_several_loops(void)
{
    static const char *const hole[SIDE] = {"......", ".o....", "..o.o.",
                                           "......", ".ooo..", "......"};
    static const int count[4] = {24, 8, 4, 8};
    plate p;
    n3_mesh m = plate_make(&p, hole, 0);
    body b;
    int i, k, sum = 0;
    body_open(&m, &b);
    CHECK(b.border.loops == 4, 0);
    for (i = 0; i < b.border.loops; i++) {
        const join_loop *l = &b.border.loop[i];
        CHECK(l->closed, i);
        for (k = 0; k < l->count; k++) {
            const int next = b.side[l->first + (k + 1) % l->count];
            CHECK(n3i_at(&m, n3i_after(b.side[l->first + k])) == n3i_at(&m, next), i);
        }
        sum += l->count;
        CHECK(l->count == count[i], i);
    }
    CHECK(sum == join_border_sides(&m, &b.topology), 0);
    CHECK(join_border_with(&b.border, 2 * (SIDE + 1) + 2) == 1, 0); /* where the two touch */
    CHECK(join_border_with(&b.border, 2 * (SIDE + 1) + 4) == 2, 0);
    CHECK(join_border_with(&b.border, SIDE + 1 + 3) == -1, 0);
    body_free(&b);
}

/* Nested loops and several: each hole of a plate finds the one above it. */
static void test_nearest(void)
{
    static const char *const hole[3][SIDE] = {
        {"......", ".o..o.", "......", "......", "......", "......"},
        {"oooooo", "oooo.o", "oooooo", "oooooo", "oooooo", "oooooo"},
        {"oooooo", "o....o", "o.oo.o", "o.oo.o", "o....o", "oooooo"}};
    plate p[4];
    body b[4];
    int i, at[2];
    for (i = 0; i < 3; i++) {
        n3_mesh m = plate_make(&p[i], hole[i], (n3_real)i / 4);
        body_open(&m, &b[i]);
    }
    CHECK(join_border_nearest(&b[0].border, &b[1].border, at) == JOIN_OK, 0);
    CHECK(b[0].border.loop[at[0]].count == 4 && at[1] == 0, 0);
    CHECK(join_border_nearest(&b[0].border, &b[2].border, at) == JOIN_OK, 1);
    CHECK(at[0] == 0 && b[2].border.loop[at[1]].count == 16, 1); /* the outer one of two */
    for (i = 0; i < 3; i++) body_free(&b[i]);
}

/* ---- Loops that are hard to join ---- */

/* Its points are finite, it is closed along both seams, and no edge has three triangles. */
static void check_joined(const joined *j, const body *a, const body *b, long row)
{
    const int before =
        join_border_sides(&a->mesh, &a->topology) + join_border_sides(&b->mesh, &b->topology);
    int i, wrong, two[2], after = open_edges(j, &wrong);
    for (i = 0; i < j->mesh.points; i++) CHECK(is_finite_vec(j->point[i]), row);
    CHECK(after == before - a->rim.count - b->rim.count, row);
    for (i = 0; i < j->topology.edges; i++)
        CHECK(n3i_live_sides(&j->mesh, &j->topology, i, two) <= 2, row);
}

/* Joins with all methods: a mesh, or a clear answer. Returns how many made a mesh. */
static int join_anyhow(body *a, body *b, long row)
{
    int method, made = 0;
    join_status status = join_rims_match(&a->rim, &b->rim, NULL, 0, NULL);
    CHECK(status == JOIN_OK || status == JOIN_COINCIDENT, row);
    for (method = 0; method < 3 && status == JOIN_OK; method++) {
        join_options o = {0, {0, 0}};
        joined j;
        o.method = method;
        join_rims(a, b, &o, 3, &j);
        if (j.status == JOIN_OK) {
            check_joined(&j, a, b, row);
            made++;
        } else {
            CHECK(method == JOIN_FUJITA, row);
            CHECK(strlen(join_status_text(j.status)) > 10, row);
        }
        joined_free(&j);
    }
    return made;
}

/* A fan of n triangles round the last point. */
typedef struct fan {
    n3_vec point[MOST_AROUND + 1];
    int triangle[3 * MOST_AROUND];
} fan;

static n3_mesh fan_mesh(fan *f, int n)
{
    n3_mesh m;
    int i;
    memset(&m, 0, sizeof m);
    for (i = 0; i < n; i++) {
        f->triangle[3 * i] = i;
        f->triangle[3 * i + 1] = (i + 1) % n;
        f->triangle[3 * i + 2] = n;
    }
    m.points = n + 1;
    m.triangles = n;
    m.point = &f->point[0].x;
    m.triangle = f->triangle;
    return m;
}

/* A flat one, of radius 1, its first point in the direction of the angle. */
static n3_mesh fan_make(fan *f, int n, n3_vec centre, double angle)
{
    int i;
    for (i = 0; i < n; i++) {
        const double a = angle + 2 * 3.14159265358979323846 * i / n;
        f->point[i] = n3_add(centre, n3_v((n3_real)cos(a), (n3_real)sin(a), 0));
    }
    f->point[n] = centre;
    return fan_mesh(f, n);
}

typedef struct fans {
    fan fan[2];
    body a, b;
} fans;

static fans *fans_open(int na, int nb, n3_vec centre, double angle)
{
    fans *f = memory(1, sizeof *f);
    n3_mesh a = fan_make(&f->fan[0], na, n3_v(0, 0, 0), 0);
    n3_mesh b = fan_make(&f->fan[1], nb, centre, angle);
    body_open(&a, &f->a);
    body_open(&b, &f->b);
    CHECK(body_take(&f->a, 0) == JOIN_OK, na);
    CHECK(body_take(&f->b, 0) == JOIN_OK, nb);
    return f;
}

static void fans_free(fans *f)
{
    body_free(&f->a);
    body_free(&f->b);
    free(f);
}

/* Discs of three points and of many, one over the other, apart, crossing, one in the other's
   plane. */
static void test_discs(void)
{
    static const double centre[][3] = {{0, 0, 1},   {0.3, 0, 0.01}, {5, 0, 0},  {0.5, 0.25, 0},
                                       {1, 0, 0.5}, {0, 0, 1e-9},   {0, 0, 1e9}};
    static const int count[][2] = {{3, 3}, {3, 4}, {4, 3}, {3, 64}, {12, 12}, {12, 5}};
    int row;
    for (row = 0; row < 7 * 6; row++) {
        const double *c = centre[row % 7];
        fans *f = fans_open(count[row / 7][0], count[row / 7][1],
                            n3_v((n3_real)c[0], (n3_real)c[1], (n3_real)c[2]), 0.1);
        CHECK(join_anyhow(&f->a, &f->b, row) >= 2, row);
        fans_free(f);
    }
}

/* The same loop twice is refused, whatever its start; one that shares a point only is not, and the
   point stays two. */
static void test_coincident(void)
{
    const double half_turn = 3.14159265358979323846;
    fans *f = fans_open(7, 7, n3_v(0, 0, 0), 0);
    CHECK(join_anyhow(&f->a, &f->b, 0) == 0, 0);
    f->b.rim.start = 3;
    CHECK(join_rims_match(&f->a.rim, &f->b.rim, NULL, -1, NULL) == JOIN_COINCIDENT, 1);
    fans_free(f);
    f = fans_open(7, 7, n3_v(2, 0, 0), half_turn);
    CHECK(join_anyhow(&f->a, &f->b, 2) >= 2, 2);
    fans_free(f);
}

/* Loops of any points, some of them in one place or in a line, some beyond all sizes. */
static void test_any_loops(void)
{
    rng r = {8};
    long i, k, count = sample_count(2000);
    for (i = 0; i < count; i++) {
        const int na = 3 + (int)(rng_next(&r) % 6), nb = 3 + (int)(rng_next(&r) % 6);
        const int kind = (int)(i % 10), most = sizeof(n3_real) == 4 ? 15 : 140;
        fans *f = fans_open(na, nb, n3_v(0, 0, 2), 0);
        n3_vec *x[2];
        x[0] = f->fan[0].point, x[1] = f->fan[1].point;
        for (k = 0; k <= na + nb; k++) {
            n3_vec *p = k <= na ? &x[0][k] : &x[1][k - na - 1], y = rng_vec(&r);
            if (kind < 2) *p = y;
            if (kind == 2) p->z = 0;
            if (kind == 3) p->y = p->z = 0;
            if (kind == 4 && rng_next(&r) % 2) *p = x[k > na][0];
            if (kind == 5) *p = x[0][0];
            if (kind == 6) *p = n3_mul((n3_real)pow(10, rng_uniform(&r, -most, most)), y);
            if (kind == 7) *p = n3_mul((n3_real)pow(10, most), *p);
            if (kind == 8) *p = n3_mul((n3_real)pow(10, -most), *p);
            if (kind == 9) *p = n3_add(*p, n3_mul((n3_real)1e-6, y));
        }
        CHECK(body_take(&f->a, 0) == JOIN_OK && body_take(&f->b, 0) == JOIN_OK, i);
        CHECK(join_anyhow(&f->a, &f->b, i) >= (kind == 2 || kind == 3 || kind == 5 ? 0 : 2), i);
        fans_free(f);
    }
}

/* The tangent of the border triangles' normals, or of those that the mesh has: of a flat disc, into
   its plane, or wherever its normals say. */
static void test_normals(void)
{
    static const n3_real up[3] = {0, 0, 1}, lean[3] = {1, 0, 1};
    const n3_real root = (n3_real)sqrt(0.5);
    fans *f = fans_open(4, 4, n3_v(0, 0, 1), 0);
    n3_real normal[5][3];
    int row, i;
    for (row = 0; row < 3; row++) {
        for (i = 0; i < 5; i++) memcpy(normal[i], row ? lean : up, sizeof up);
        f->a.mesh.normals = 5;
        f->a.mesh.normal = normal[0];
        CHECK(join_rim_make(&f->a.border, 0, row < 2, f->a.vertex, &f->a.rim) == JOIN_OK, row);
        CHECK_VEC(f->a.vertex[0].t, row == 1 ? n3_v(root, 0, -root) : n3_v(1, 0, 0), 8 * EPS, row);
        CHECK_VEC(f->a.vertex[0].n, row == 1 ? n3_v(root, 0, root) : n3_v(0, 0, 1), 8 * EPS, row);
    }
    fans_free(f);
}

const test_case tests_awkward[] = {{"awkward: borders", test_borders},
                                   {"awkward: several loops", test_several_loops},
                                   {"awkward: the nearest loops", test_nearest},
                                   {"awkward: discs", test_discs},
                                   {"awkward: coincident loops", test_coincident},
                                   {"awkward: any loops", test_any_loops},
                                   {"awkward: normals of the mesh", test_normals},
                                   {NULL, NULL}};
