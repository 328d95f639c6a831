/* bridge.c: the bridges over the five inputs. */
#include "joined.h"

/* ---- Seams ---- */

/* With three rows: below 15 degrees where Fujita's are, below 31 in the abrupt case, and far below
   straight bridges. */
static void test_seams(void)
{
    const double half_degree = 3.14159265358979323846 / 360;
    n3_real jump[2];
    int i, k;
    for (i = 0; i < INPUTS; i++) {
        pair *p = pair_open(i, AROUND, AROUND);
        joined nagata = pair_join(p, JOIN_NAGATA, 3), straight = pair_join(p, JOIN_STRAIGHT, 3);
        for (k = 0; k < 2; k++) {
            double range[2], plain[2], most = inputs[i].outlier > 0 ? 31 : 15;
            CHECK(seam(&nagata, k, range) == AROUND, i);
            CHECK(seam(&straight, k, plain) == AROUND, i);
            CHECK(join_seam(&nagata.bridge, &nagata.mesh, &nagata.topology, k, jump) == AROUND, i);
            CHECK_NEAR(jump[0], 2 * sin(range[0] * half_degree), 64 * EPS, i);
            CHECK_NEAR(jump[1], 2 * sin(range[1] * half_degree), 64 * EPS, i);
            CHECK_NEAR(range[1], 0, most, 2 * i + k);
            CHECK(range[1] < plain[1] / 2, 2 * i + k);
        }
        joined_free(&nagata);
        joined_free(&straight);
        pair_free(p);
    }
}

/* The first chord of a curve with the handle h leaves its tangent by |x''| / (6 h (m + 1)), to
   first order, so that m + 1 times the angle tends to a constant; on the way there the diagonals
   may change, and with them which of two neighbouring curves a seam's triangle ends on. */
static void test_seams_fall_like_one_over_rows(void)
{
    static const int around[3][2] = {{24, 24}, {24, 17}, {20, 32}};
    int row, rows, k;
    for (row = 0; row < 3 * INPUTS; row++) {
        const int *n = around[row / INPUTS];
        pair *p = pair_open(row % INPUTS, n[0], n[1]);
        double first[2] = {0, 0};
        for (rows = 7; rows < 256; rows = 2 * rows + 1) {
            joined j = pair_join(p, JOIN_NAGATA, rows);
            for (k = 0; k < 2; k++) {
                double range[2];
                CHECK(seam(&j, k, range) == n[k], row);
                if (rows == 7) first[k] = range[1] * 8;
                CHECK_NEAR(range[1] * (rows + 1) / first[k], 1, 0.35, row);
            }
            joined_free(&j);
        }
        pair_free(p);
    }
}

/* ---- The mesh ---- */

static void test_kept_bit_for_bit(void)
{
    pair *p = pair_open(2, 24, 17);
    joined j = pair_join(p, JOIN_NAGATA, 5);
    const n3_mesh *a = &p->a.mesh, *b = &p->b.mesh;
    int i;
    CHECK(memcmp(j.point, a->point, (size_t)a->points * sizeof *j.point) == 0, 0);
    CHECK(memcmp(j.point + a->points, b->point, (size_t)b->points * sizeof *j.point) == 0, 1);
    CHECK(memcmp(j.triangle, a->triangle, 3 * (size_t)a->triangles * sizeof *j.triangle) == 0, 2);
    for (i = 0; i < 3 * b->triangles; i++)
        CHECK(j.triangle[3 * a->triangles + i] == a->points + b->triangle[i], i);
    joined_free(&j);
    pair_free(p);
}

/* Every edge has two triangles that agree, but for those of the two loops that are left; the tube
   without holes of its own has no handle. */
static void test_closed_along_both_seams(void)
{
    static const int count[] = {3, 4, 5, 7, 24, 64};
    int row;
    for (row = 0; row < 6 * 6 * 5; row++) {
        const int lower = count[row % 6], upper = count[row / 6 % 6], rows = row / 36;
        pair *p = pair_open(row % INPUTS, lower, upper);
        joined j = pair_join(p, row % 2 ? JOIN_NAGATA : JOIN_STRAIGHT, rows == 4 ? 9 : rows);
        int wrong, open = open_edges(&j, &wrong);
        CHECK(j.status == JOIN_OK, row);
        CHECK(open == lower + upper, row);
        CHECK(wrong == 0, row);
        CHECK(j.topology.unused == 0 && j.topology.collapsed == 0, row);
        CHECK(j.mesh.points - j.topology.edges + j.mesh.triangles == 0, row);
        joined_free(&j);
        pair_free(p);
    }
}

/* From 12 points to 5 in four rows: a row at each loop's own number, then in proportion. With one
   row it is the larger loop's. */
static void test_rows_of_unequal_loops(void)
{
    static const int want[] = {12, 12, 10, 7, 5, 5};
    pair *p = pair_open(1, 12, 5);
    joined j = pair_join(p, JOIN_NAGATA, 4);
    int r, points = 12 * RINGS + 5 * RINGS, triangles = j.mesh.triangles;
    for (r = 0; r < 6; r++) CHECK(joini_row_count(&j.bridge, r) == want[r], r);
    CHECK(j.mesh.points == points + 12 + 10 + 7 + 5, 0);
    CHECK(triangles == 6 * 17 + 12 + 2 * (12 + 10 + 7 + 5) + 5, 1);
    for (r = 0; r < 12; r++) CHECK_NEAR(joini_row_s(&j.bridge, 1, r), joini_s(&p->a.rim, r), 0, r);
    for (r = 0; r < 5; r++) CHECK_NEAR(joini_row_s(&j.bridge, 4, r), joini_s(&p->b.rim, r), 0, r);
    j.bridge.rows = 1;
    CHECK(joini_row_count(&j.bridge, 1) == 12, 2);
    joined_free(&j);
    pair_free(p);
}

/* ---- Self-intersection ---- */

/* Six times the volume of a tetrahedron; what is within the rounding counts as 0. */
static double volume(const n3_vec x[4])
{
    double e[3][3], a, b, c, size = 0;
    int i;
    for (i = 0; i < 3; i++) {
        e[i][0] = (double)x[i + 1].x - (double)x[0].x;
        e[i][1] = (double)x[i + 1].y - (double)x[0].y;
        e[i][2] = (double)x[i + 1].z - (double)x[0].z;
    }
    a = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]);
    b = e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]);
    c = e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    for (i = 0; i < 9; i++) size = fmax(size, fabs(e[i / 3][i % 3]));
    return fabs(a + b + c) <= 64 * 2.3e-16 * size * size * size ? 0 : a + b + c;
}

/* True if the segment from p to q pierces the inside of the triangle. */
static int pierces(n3_vec p, n3_vec q, const n3_vec x[3])
{
    n3_vec end[2][4], side[3][4];
    double v[2], w[3];
    int i, k;
    for (i = 0; i < 2; i++) {
        for (k = 0; k < 3; k++) end[i][k] = x[k];
        end[i][3] = i ? q : p;
        v[i] = volume(end[i]);
    }
    if (!(v[0] * v[1] < 0)) return 0;
    for (i = 0; i < 3; i++) {
        side[i][0] = p, side[i][1] = q, side[i][2] = x[i], side[i][3] = x[(i + 1) % 3];
        w[i] = volume(side[i]);
    }
    return (w[0] > 0 && w[1] > 0 && w[2] > 0) || (w[0] < 0 && w[1] < 0 && w[2] < 0);
}

static int shares(const int *f, int point)
{
    return f[0] == point || f[1] == point || f[2] == point;
}

/* A side of one triangle pierces the other; sides that share a corner with it only touch it. */
static int cut_through(const joined *j, int f, int g)
{
    int turn, i, k;
    for (turn = 0; turn < 2; turn++) {
        const int *s = j->triangle + 3 * (turn ? g : f), *t = j->triangle + 3 * (turn ? f : g);
        n3_vec x[3];
        for (k = 0; k < 3; k++) x[k] = j->point[t[k]];
        for (i = 0; i < 3; i++) {
            const int a = s[i], b = s[(i + 1) % 3];
            if (!shares(t, a) && !shares(t, b) && pierces(j->point[a], j->point[b], x)) return 1;
        }
    }
    return 0;
}

/* Pairs of triangles, one at least of the bridge, that cut through each other. */
static int cuts(const joined *j)
{
    int f, g, count = 0;
    for (f = 0; f < j->mesh.triangles; f++)
        for (g = f + 1; g < j->mesh.triangles; g++)
            if (joini_origin(&j->bridge, g) == 2) count += cut_through(j, f, g);
    return count;
}

/* Neighbours, one at least of the bridge, that are folded onto each other, by more than 90 degrees.
 */
static int folds(const joined *j)
{
    int e, two[2], count = 0;
    for (e = 0; e < j->topology.edges; e++) {
        if (!n3i_is_regular(&j->mesh, &j->topology, e, two)) continue;
        if (joini_origin(&j->bridge, two[0] / 3) < 2 && joini_origin(&j->bridge, two[1] / 3) < 2)
            continue;
        count += n3_dot(facet_normal(j, two[0] / 3), facet_normal(j, two[1] / 3)) < 0;
    }
    return count;
}

static void test_no_self_intersection(void)
{
    n3_real jump[2];
    int row;
    for (row = 0; row < 2 * INPUTS; row++) {
        pair *p = pair_open(row % INPUTS, AROUND, row < INPUTS ? AROUND : 17);
        joined j = pair_join(p, JOIN_NAGATA, 5);
        CHECK(cuts(&j) == 0, row);
        CHECK(folds(&j) == 0, row);
        CHECK(join_seam(&j.bridge, &j.mesh, &j.topology, 2, jump) > 5 * AROUND, row);
        CHECK(jump[1] < (n3_real)1.4, row); /* 89 degrees */
        joined_free(&j);
        pair_free(p);
    }
}

/* The test sees them: where one loop runs the wrong way the curves pass through each other; away
   from the symmetric place, where they would do so in single points. */
static void test_self_intersection_is_seen(void)
{
    pair *p = pair_open(3, AROUND, 17);
    joined j;
    p->b.rim.step = 1;
    p->b.rim.start = (p->b.rim.start + 2) % 17;
    j = pair_join(p, JOIN_STRAIGHT, 4);
    CHECK(cuts(&j) > 10, 0);
    joined_free(&j);
    pair_free(p);
}

/* ---- Start and direction ---- */

static double angle_of(n3_vec x) { return atan2((double)x.y, (double)x.x); }

/* The loops of an input begin at the same angle, and keep their outsides; the larger one does so to
   half a step. */
static void test_start_is_found(void)
{
    static const int around[4][2] = {{24, 24}, {24, 17}, {12, 64}, {64, 3}};
    int row;
    for (row = 0; row < 4 * INPUTS; row++) {
        const int *n = around[row / INPUTS];
        pair *p = pair_open(row % INPUTS, n[0], n[1]);
        const join_vertex *a = &p->a.rim.vertex[p->a.rim.start];
        const join_vertex *b = &p->b.rim.vertex[p->b.rim.start];
        double off = angle_of(a->x) - angle_of(b->x),
               step = 6.2831853 / (n[0] > n[1] ? n[0] : n[1]);
        CHECK(p->a.rim.step == 1 && p->b.rim.step == -1, row);
        CHECK_NEAR(sin(off / 2), 0, n[0] == n[1] ? 4 * EPS : step, row);
        pair_free(p);
    }
}

/* Given points begin, in whatever direction is better; or none, where one is not on its loop. */
static void test_start_is_given(void)
{
    pair *p = pair_open(0, 24, 17);
    int start[2], item = -1;
    start[0] = input_start(&p->tube[0], 0) + 5, start[1] = 9;
    CHECK(join_rims_match(&p->a.rim, &p->b.rim, start, 0, &item) == JOIN_OK, 0);
    CHECK(p->a.rim.vertex[p->a.rim.start].point == start[0], 0);
    CHECK(p->b.rim.vertex[p->b.rim.start].point == start[1], 0);
    CHECK(p->b.rim.step == -1, 0);
    CHECK(join_rims_match(&p->a.rim, &p->b.rim, start, 1, NULL) == JOIN_OK, 1);
    CHECK(p->b.rim.step == 1 && p->b.rim.vertex[p->b.rim.start].point == start[1], 1);
    start[1] = 17;
    CHECK(join_rims_match(&p->a.rim, &p->b.rim, start, 0, &item) == JOIN_BAD_START, 2);
    CHECK(item == 1, 2);
    start[0] = 0;
    CHECK(join_rims_match(&p->a.rim, &p->b.rim, start, 0, &item) == JOIN_BAD_START, 3);
    CHECK(item == 0, 3);
    pair_free(p);
}

/* B inside out is turned round, and nothing else changes. */
static void test_opposite_orientation(void)
{
    int row, i, k;
    for (row = 0; row < INPUTS; row++) {
        pair *p = pair_open(row, AROUND, AROUND);
        joined j = pair_join(p, JOIN_NAGATA, 1), turned;
        tube *upper = &p->tube[1];
        double range[2], other[2];
        int wrong;
        for (i = 0; i < upper->mesh.triangles; i++) {
            int *c = upper->triangle + 3 * i, swap = c[1];
            c[1] = c[2];
            c[2] = swap;
        }
        body_free(&p->b);
        body_open(&upper->mesh, &p->b);
        CHECK(body_take(&p->b, 0) == JOIN_OK, row);
        CHECK(join_rims_match(&p->a.rim, &p->b.rim, NULL, 0, NULL) == JOIN_OK, row);
        CHECK(p->b.rim.step == 1, row);
        turned = pair_join(p, JOIN_NAGATA, 1);
        for (k = 0; k < 2; k++) {
            seam(&j, k, range);
            seam(&turned, k, other);
            CHECK_NEAR(other[1], range[1], 0.01, row);
        }
        CHECK(open_edges(&turned, &wrong) == 2 * AROUND && wrong == 0, row);
        CHECK(turned.mesh.triangles == j.mesh.triangles, row);
        for (i = 0; i < turned.mesh.points; i++) {
            double least = 1;
            for (k = 0; k < j.mesh.points; k++)
                least = fmin(least, (double)n3_len(n3_sub(turned.point[i], j.point[k])));
            CHECK_NEAR(least, 0, 32 * EPS, row);
        }
        joined_free(&j);
        joined_free(&turned);
        pair_free(p);
    }
}

/* A tube that opens at the origin, turned from the z axis by an angle about the y axis, and moved.
 */
static void lay_tube(body *b, tube *t, double angle, double x, double z)
{
    const double c = cos(angle), s = sin(angle);
    int i;
    input_make(0, 0, AROUND, t);
    for (i = 0; i < t->mesh.points; i++) {
        n3_vec *p = &t->point[i], y = *p;
        p->x = (n3_real)(c * (double)y.x + s * (double)y.z + x);
        p->z = (n3_real)(c * (double)y.z - s * (double)y.x + z);
    }
    body_free(b);
    body_open(&t->mesh, b);
    CHECK(body_take(b, input_start(t, 0)) == JOIN_OK, 0);
}

/* Tubes side by side, leaning together, at right angles, and one over the other but beside it: the
   bridge is a handle, an elbow, an S. What is inside of the bend is joined to what is inside. */
static void test_handles_and_elbows(void)
{
    static const double turn[4][2] = {
        {0, 0}, {0.8, 0}, {1.5707963267948966, 0}, {3.14159265358979323846, 5}};
    int row, k;
    for (row = 0; row < 4; row++) {
        pair *p = pair_open(0, AROUND, AROUND);
        const int start = input_start(&p->tube[0], 0);
        joined j;
        lay_tube(&p->a, &p->tube[0], 0, 0, 0);
        lay_tube(&p->b, &p->tube[1], -turn[row][0], 5, turn[row][1]);
        CHECK(join_rims_match(&p->a.rim, &p->b.rim, NULL, 0, NULL) == JOIN_OK, row);
        CHECK(p->b.rim.step == -1, row);
        for (k = 0; joini_at(&p->a.rim, k)->point != start; k++) continue;
        CHECK(joini_at(&p->b.rim, k)->point == start + AROUND / 2, row);
        j = pair_join(p, JOIN_NAGATA, 15);
        CHECK(cuts(&j) == 0 && folds(&j) == 0, row);
        for (k = 0; k < 2; k++) {
            double range[2];
            CHECK(seam(&j, k, range) == AROUND, row);
            CHECK_NEAR(range[1], 0, 10, row);
        }
        joined_free(&j);
        pair_free(p);
    }
}

/* ---- Options ---- */

/* The handles are (2 L / 3) / (1 + |t0 - t1| / 2) long times the strengths, along the tangents. */
static void test_strength(void)
{
    pair *p = pair_open(3, AROUND, AROUND);
    join_options o = {JOIN_NAGATA, {(n3_real)3 / 2, (n3_real)1 / 4}};
    joined j;
    int i;
    join_rims(&p->a, &p->b, &o, 1, &j);
    for (i = 0; i < AROUND; i++) {
        const n3_vec *x = j.column[i].curve.p;
        const join_vertex *a = joini_at(&p->a.rim, i), *b = joini_at(&p->b.rim, i);
        double h = 2 * (double)n3_len(n3_sub(b->x, a->x)) / 3 /
                   (1 + (double)n3_len(n3_sub(a->t, b->t)) / 2);
        CHECK_SAME(x[0], a->x, i);
        CHECK_SAME(x[3], b->x, i);
        CHECK_VEC(n3_sub(x[1], x[0]), n3_mul((n3_real)(h * 3 / 2), a->t), 16 * EPS, i);
        CHECK_VEC(n3_sub(x[2], x[3]), n3_mul((n3_real)(h / 4), b->t), 16 * EPS, i);
    }
    joined_free(&j);
    pair_free(p);
}

/* The distance from a point to a segment. */
static double distance(n3_vec x, n3_vec a, n3_vec b)
{
    n3_vec d = n3_sub(b, a);
    n3_real f = n3_dot(n3_sub(x, a), d) / n3_dot(d, d);
    f = f < 0 ? 0 : f > 1 ? 1 : f;
    return (double)n3_len(n3_sub(x, n3_add(a, n3_mul(f, d))));
}

/* No curve is farther from its polygon than asked, and the bound is not idle: with a third of the
   rows one is. */
static void test_rows_of_tolerance(void)
{
    static const double tolerance[] = {1e-1, 1e-2, 1e-3, 1e-4};
    int row, thin, i, k;
    for (row = 0; row < 4 * INPUTS; row++) {
        pair *p = pair_open(row % INPUTS, AROUND, AROUND);
        joined j = pair_join(p, JOIN_NAGATA, 0);
        const double asked = tolerance[row / INPUTS];
        const int rows = join_rows(&j.bridge, (n3_real)asked);
        for (thin = 0; thin < 2; thin++) {
            const int pieces = thin ? rows / 3 + 1 : rows + 1;
            double most = 0;
            for (i = 0; i < 16 * pieces * j.bridge.columns; i++) {
                const n3_edge *curve = &j.column[i / 16 / pieces].curve;
                const n3_real m = (n3_real)pieces;
                k = i % (16 * pieces);
                most = fmax(most, distance(n3_edge_point(curve, (n3_real)k / 16 / m),
                                           n3_edge_point(curve, (n3_real)(k / 16) / m),
                                           n3_edge_point(curve, (n3_real)(k / 16 + 1) / m)));
            }
            CHECK(thin ? rows < 2 || most > asked : most <= asked + 16 * EPS, row);
        }
        joined_free(&j);
        pair_free(p);
    }
}

static void test_rows_out_of_range(void)
{
    pair *p = pair_open(0, AROUND, AROUND);
    joined j = pair_join(p, JOIN_NAGATA, 0), straight = pair_join(p, JOIN_STRAIGHT, 0);
    CHECK(join_rows(&j.bridge, 0) == -1, 0);
    CHECK(join_rows(&j.bridge, -1) == -1, 1);
    CHECK(join_rows(&j.bridge, (n3_real)nan("")) == -1, 2);
    CHECK(join_rows(&j.bridge, (n3_real)1e-30) == -1, 3);
    CHECK(join_rows(&j.bridge, (n3_real)1e30) == 0, 4);
    CHECK(join_rows(&straight.bridge, (n3_real)1e-3) == 0, 5);
    j.bridge.rows = -1;
    CHECK(join_counts(&j.bridge, NULL, NULL) == JOIN_BAD_COUNT, 6);
    j.bridge.rows = 2000000000;
    CHECK(join_counts(&j.bridge, NULL, NULL) == JOIN_BAD_COUNT, 7);
    joined_free(&j);
    joined_free(&straight);
    pair_free(p);
}

/* ---- Properties ---- */

static void move_tubes(pair *p, n3_real scale, n3_vec by)
{
    int k, i, start[2];
    for (k = 0; k < 2; k++) {
        body *q = k ? &p->b : &p->a;
        start[k] = q->rim.vertex[q->rim.start].point;
        for (i = 0; i < p->tube[k].mesh.points; i++)
            p->tube[k].point[i] = n3_add(n3_mul(scale, p->tube[k].point[i]), by);
        CHECK(body_take(q, start[k]) == JOIN_OK, k);
    }
    CHECK(join_rims_match(&p->a.rim, &p->b.rim, NULL, 0, NULL) == JOIN_OK, 0);
}

/* Scaling by a power of two changes no bit. Both are asked for in one place, as two copies of the
   header's code may round differently where the compiler contracts products and sums. */
static void test_scaling(void)
{
    static const int exponent[] = {-30, -1, 30, 60};
    int row, i;
    for (row = 0; row < 4 * INPUTS; row++) {
        const n3_real scale = (n3_real)ldexp(1, exponent[row / INPUTS]);
        pair *p = pair_open(row % INPUTS, AROUND, row % 2 ? AROUND : 17);
        joined j[2];
        for (i = 0; i < 2; i++) {
            move_tubes(p, i ? scale : 1, n3_v(0, 0, 0));
            j[i] = pair_join(p, JOIN_NAGATA, 4);
        }
        for (i = 0; i < j[0].mesh.points; i++)
            CHECK_SAME(j[1].point[i], n3_mul(scale, j[0].point[i]), row);
        i = memcmp(j[0].triangle, j[1].triangle, 3 * (size_t)j[0].mesh.triangles * sizeof i);
        CHECK(i == 0, row);
        for (i = 0; i < 2; i++) joined_free(&j[i]);
        pair_free(p);
    }
}

/* The bridge from B to A has the same points as that from A to B. */
static void test_from_either_side(void)
{
    int row, i, k;
    for (row = 0; row < INPUTS; row++) {
        pair *p = pair_open(row, AROUND, AROUND);
        joined j = pair_join(p, JOIN_NAGATA, 4), back;
        CHECK(join_rims_match(&p->b.rim, &p->a.rim, NULL, 0, NULL) == JOIN_OK, row);
        join_rims(&p->b, &p->a, NULL, 4, &back);
        for (i = 0; i < 4 * AROUND; i++) {
            const int first = j.mesh.points - 4 * AROUND;
            double least = 1;
            for (k = 0; k < 4 * AROUND; k++)
                least =
                    fmin(least, (double)n3_len(n3_sub(j.point[first + i], back.point[first + k])));
            CHECK_NEAR(least, 0, 32 * EPS, row);
        }
        joined_free(&j);
        joined_free(&back);
        pair_free(p);
    }
}

const test_case tests_bridge[] = {
    {"join: seams", test_seams},
    {"join: seams fall like 1 / rows", test_seams_fall_like_one_over_rows},
    {"join: kept bit for bit", test_kept_bit_for_bit},
    {"join: closed along both seams", test_closed_along_both_seams},
    {"join: rows of unequal loops", test_rows_of_unequal_loops},
    {"join: no self-intersection", test_no_self_intersection},
    {"join: self-intersection is seen", test_self_intersection_is_seen},
    {"join: the start is found", test_start_is_found},
    {"join: the start is given", test_start_is_given},
    {"join: opposite orientation", test_opposite_orientation},
    {"join: handles and elbows", test_handles_and_elbows},
    {"join: strength", test_strength},
    {"join: rows of a tolerance", test_rows_of_tolerance},
    {"join: rows out of range", test_rows_out_of_range},
    {"join: scaling", test_scaling},
    {"join: from either side", test_from_either_side},
    {NULL, NULL}};
