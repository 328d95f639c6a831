/* fujita.c: the method of the thesis, equation by equation, and where it breaks down. */
#include "joined.h"

/* A tube of two rings. */
typedef struct sleeve {
    n3_vec point[2 * MOST_AROUND];
    int triangle[6 * MOST_AROUND];
} sleeve;

enum { N = 12 };

/* One ring, and the ways from it to the other. Where the first, looked at along the way, runs
   clockwise, the triangles look outwards, unless they are turned. */
static n3_mesh sleeve_make(sleeve *s, const n3_vec *x, const n3_vec *way, int n, int turned)
{
    n3_mesh m;
    int i;
    memset(&m, 0, sizeof m);
    for (i = 0; i < n; i++) {
        const int next = (i + 1) % n;
        const int corner[6] = {i, turned ? n + next : n + i, turned ? n + i : n + next,
                               i, turned ? next : n + next,  turned ? n + next : next};
        s->point[i] = x[i];
        s->point[n + i] = n3_add(x[i], way[i]);
        memcpy(s->triangle + 6 * i, corner, sizeof corner);
    }
    m.points = m.triangles = 2 * n;
    m.point = &s->point[0].x;
    m.triangle = s->triangle;
    return m;
}

/* On a ring round the z axis. */
static n3_vec round_z(double radius, double z, int i, int n)
{
    const double a = 2 * 3.14159265358979323846 * i / n;
    return n3_v((n3_real)(radius * cos(a)), (n3_real)(radius * sin(a)), (n3_real)z);
}

typedef struct sleeves {
    sleeve sleeve[2];
    body a, b;
} sleeves;

/* Two of them, A and B, whose points of the same number are joined; B is turned, so that the way
   through both leads in at A and out at B. */
static sleeves *sleeves_open(n3_vec x[2][N], n3_vec way[2][N])
{
    static const int start[2] = {0, 0};
    sleeves *s = memory(1, sizeof *s);
    n3_mesh a = sleeve_make(&s->sleeve[0], x[0], way[0], N, 0);
    n3_mesh b = sleeve_make(&s->sleeve[1], x[1], way[1], N, 1);
    body_open(&a, &s->a);
    body_open(&b, &s->b);
    CHECK(body_take(&s->a, 0) == JOIN_OK, 0);
    CHECK(body_take(&s->b, 0) == JOIN_OK, 0);
    CHECK(join_rims_match(&s->a.rim, &s->b.rim, start, 0, NULL) == JOIN_OK, 0);
    CHECK(s->b.rim.step == -1, 0);
    return s;
}

/* Round the z axis: radii, heights, and the ways into the meshes out from the axis and up. */
static sleeves *sleeves_round(double ra, double rb, double height, const double way[4])
{
    n3_vec x[2][N], w[2][N];
    int i;
    for (i = 0; i < N; i++) {
        x[0][i] = round_z(ra, 0, i, N);
        x[1][i] = round_z(rb, height, i, N);
        w[0][i] = round_z(way[0], way[1], i, N);
        w[1][i] = round_z(way[2], way[3], i, N);
    }
    return sleeves_open(x, w);
}

static void sleeves_free(sleeves *s)
{
    body_free(&s->a);
    body_free(&s->b);
    free(s);
}

static joined sleeves_join(const sleeves *s, int method, double strength, int rows)
{
    join_options o = {0, {0, 0}};
    joined j;
    o.method = method;
    o.strength[0] = o.strength[1] = (n3_real)strength;
    join_rims(&s->a, &s->b, &o, rows, &j);
    return j;
}

/* The point i of B's loop is the one joined to point i of A's. */
static int column_of(const sleeves *s, int i)
{
    int k;
    for (k = 0; joini_at(&s->a.rim, k)->point != i; k++) continue;
    CHECK(joini_at(&s->b.rim, k)->point == i, i);
    return k;
}

/* ---- Its equations ---- */

/* Every curve lies in the plane through the centre line and its first point, with the end of B
   dropped onto it. */
static void test_F241_work_plane(void)
{
    int i, k, row;
    for (row = 0; row < INPUTS; row++) {
        pair *p = pair_open(row, AROUND, AROUND);
        joined j = pair_join(p, JOIN_FUJITA, 3);
        n3_vec o1 = n3_v(0, 0, 0), o2 = o1, axis;
        CHECK(j.status == JOIN_OK, row);
        for (i = 0; i < AROUND; i++) {
            o1 = n3_add(o1, n3i_over(joini_at(&p->a.rim, i)->x, AROUND));
            o2 = n3_add(o2, n3i_over(joini_at(&p->b.rim, i)->x, AROUND));
        }
        axis = n3_sub(o2, o1);
        for (i = 0; i < AROUND; i++) {
            n3_vec x = joini_at(&p->a.rim, i)->x, y = joini_at(&p->b.rim, i)->x;
            n3_vec s = n3_unit(n3_cross(axis, n3_sub(x, o1)));
            const n3_vec *q = j.column[i].curve.p;
            for (k = 0; k < 4; k++) CHECK_NEAR(n3_dot(s, n3_sub(q[k], o1)), 0, 32 * EPS, i);
            CHECK_VEC(n3_cross(s, n3_sub(q[3], y)), n3_v(0, 0, 0), 32 * EPS, i); /* (F2.4.2) */
            CHECK_SAME(q[0], x, i);
        }
        joined_free(&j);
        pair_free(p);
    }
}

/* The tangents of two cones, in the plane y = 0: from (1, 0) along (-1/4, 1), from (1, 2) along
   (-3/8, -1), meet at C = (7/10, 6/5). */
static void test_F243_control_points(void)
{
    static const double way[4] = {0.25, -1, 0.375, 1}, s = 0.4;
    sleeves *t = sleeves_round(1, 1, 2, way);
    joined j = sleeves_join(t, JOIN_FUJITA, s, 3);
    const int column = column_of(t, 0);
    const n3_vec *q = j.column[column].curve.p;
    int k, r;
    CHECK_VEC(q[1], n3_v((n3_real)(0.7 * s + 1 - s), 0, (n3_real)(1.2 * s)), 8 * EPS, 0);
    CHECK_VEC(q[2], n3_v((n3_real)(0.7 * s + 1 - s), 0, (n3_real)(1.2 * s + 2 * (1 - s))), 8 * EPS,
              1);
    for (r = 1; r <= 3; r++) { /* P_ij of section 2.4.4 */
        const double u = r / 4.0;
        const double w[4] = {(1 - u) * (1 - u) * (1 - u), 3 * (1 - u) * (1 - u) * u,
                             3 * (1 - u) * u * u, u * u * u};
        n3_vec want = n3_v(0, 0, 0);
        for (k = 0; k < 4; k++) want = n3_add(want, n3_mul((n3_real)w[k], q[k]));
        CHECK_VEC(j.point[4 * N + (r - 1) * N + column], want, 16 * EPS, r);
    }
    joined_free(&j);
    sleeves_free(t);
}

/* Parallel tangents, not in one line: the middle (5/4, 1) of the ends (1, 0) and (3/2, 2) dropped
   onto both is at height 1. */
static void test_F243_parallel(void)
{
    static const double way[4] = {0, -1, 0, 1}, s = 0.6;
    sleeves *t = sleeves_round(1, 1.5, 2, way);
    joined j = sleeves_join(t, JOIN_FUJITA, s, 3);
    const n3_vec *q = j.column[column_of(t, 0)].curve.p;
    CHECK_VEC(q[1], n3_v(1, 0, (n3_real)s), 8 * EPS, 0);
    CHECK_VEC(q[2], n3_v((n3_real)1.5, 0, (n3_real)(2 - s)), 8 * EPS, 1);
    joined_free(&j);
    sleeves_free(t);
}

/* Every cell is cut from P_ij to P_(i+1)(j+1). */
static void test_F244_cells(void)
{
    pair *p = pair_open(0, AROUND, AROUND);
    joined j = pair_join(p, JOIN_FUJITA, 3);
    const int *t = j.triangle + 3 * (p->a.mesh.triangles + p->b.mesh.triangles);
    const int first = p->a.mesh.points + p->b.mesh.points;
    int r, i;
    for (r = 0; r < 4; r++)
        for (i = 0; i < AROUND; i++, t += 6) {
            const int next = (i + 1) % AROUND;
            if (r == 0 || r == 3) continue;
            CHECK(t[0] == first + (r - 1) * AROUND + i && t[1] == first + r * AROUND + i, i);
            CHECK(t[2] == first + r * AROUND + next && t[3] == t[0] && t[4] == t[2], i);
            CHECK(t[5] == first + (r - 1) * AROUND + next, i);
        }
    joined_free(&j);
    pair_free(p);
}

/* From (1, 0) along (0, 1) and from (2, 1) along (-1, -1/10) the tangents meet at C = (1, 9/10),
   9/10 and sqrt(101)/10 away: not yet twice as far. With the ends at (3, 1) along (-1, -1/4) they
   meet at (1, 1/2), 1/2 and sqrt(17)/2 away: the nearer control point goes to sqrt(17)/4. */
static void test_F25_sharp_bend(void)
{
    static const double way[2][4] = {{0, -1, 1, 0.1}, {0, -1, 1, 0.25}}, s = 0.5;
    int row;
    for (row = 0; row < 2; row++) {
        sleeves *t = sleeves_round(1, row ? 3 : 2, 1, way[row]);
        joined j = sleeves_join(t, JOIN_FUJITA, s, 3);
        const n3_vec *q = j.column[column_of(t, 0)].curve.p;
        n3_real z = (n3_real)(row ? sqrt(17.0) / 4 : 0.45);
        CHECK_VEC(q[1], n3_v(1, 0, z), 16 * EPS, row);
        CHECK_VEC(q[2], n3_v(row ? 2 : (n3_real)1.5, 0, (n3_real)(row ? 0.75 : 0.95)), 16 * EPS,
                  row);
        joined_free(&j);
        sleeves_free(t);
    }
}

/* ---- Where its author says that it fails ---- */

/* The largest angle at the seams by both methods, with 15 rows. */
static void both(const sleeves *s, double fujita[2], double nagata[2])
{
    int method, k;
    for (method = 0; method < 2; method++) {
        joined j = sleeves_join(s, method ? JOIN_FUJITA : JOIN_NAGATA, 0, 15);
        CHECK(j.status == JOIN_OK, method);
        for (k = 0; k < 2; k++) {
            double range[2];
            seam(&j, k, range);
            (method ? fujita : nagata)[k] = range[1];
        }
        joined_free(&j);
    }
}

/* First: the tangents meet behind a point. From (1, 0) along (0, 1), from (2, 1) along (-1, -2) is
   C = (1, -1), below A: its curve leaves into the mesh. */
static void test_failure_1_behind(void)
{
    static const double way[4] = {0, -1, 1, 2};
    sleeves *s = sleeves_round(1, 2, 1, way);
    double fujita[2], nagata[2];
    both(s, fujita, nagata);
    CHECK(fujita[0] > 170, 0);
    CHECK(nagata[0] < 6 && nagata[1] < 6, 0);
    sleeves_free(s);
}

/* Second: parallel and of the same direction. A tube in a wider one, both open at the top, at the
   heights 0 and 1/2: their middle is below the outer end, whose curve leaves into its mesh. */
static void test_failure_2_same_direction(void)
{
    static const double way[4] = {0, -1, 0, -1};
    sleeves *s = sleeves_round(1, 2, 0.5, way);
    double fujita[2], nagata[2];
    both(s, fujita, nagata);
    CHECK(fujita[1] > 120, 0);
    CHECK(nagata[0] < 12 && nagata[1] < 12, 0);
    sleeves_free(s);
}

/* Third: neighbouring parts of the loop turn abruptly. The plane crosses one triangle at a point,
   and the seam keeps the angle between that and those beside it, however many rows there are. */
static void test_failure_3_abrupt(void)
{
    pair *p = pair_open(4, AROUND, AROUND);
    int rows;
    for (rows = 3; rows < 64; rows = 2 * rows + 1) {
        joined fujita = pair_join(p, JOIN_FUJITA, rows), nagata = pair_join(p, JOIN_NAGATA, rows);
        double range[2][2];
        seam(&fujita, 0, range[0]);
        seam(&nagata, 0, range[1]);
        CHECK_NEAR(range[0][1], 14.5, 2, rows);
        CHECK_NEAR(range[1][1], 0, 32.0 / (rows + 1), rows);
        joined_free(&fujita);
        joined_free(&nagata);
    }
    pair_free(p);
}

/* How far neighbouring curves of a bridge with a round section are from each other in radius, at
   the most, half way. */
static double ripple(const joined *j)
{
    double most = 0;
    int i;
    for (i = 0; i < N; i++) {
        n3_vec x = n3_edge_point(&j->column[i].curve, (n3_real)1 / 2);
        n3_vec y = n3_edge_point(&j->column[(i + 1) % N].curve, (n3_real)1 / 2);
        x.z = y.z = 0;
        most = fmax(most, fabs((double)n3_len(x) - (double)n3_len(y)));
    }
    return most;
}

/* Fourth: parallel tangents beside others. The tube above has points that go straight up and,
   between them, points that lean by a hundredth: these meet a hundred radii away. */
static void test_failure_4_ripples(void)
{
    n3_vec x[2][N], w[2][N];
    joined fujita, nagata;
    sleeves *s;
    int i;
    for (i = 0; i < N; i++) {
        x[0][i] = round_z(1, 0, i, N);
        x[1][i] = round_z(1.5, 2, i, N);
        w[0][i] = n3_v(0, 0, -1);
        w[1][i] = round_z(i % 2 ? 0.01 : 0, 1, i, N);
    }
    s = sleeves_open(x, w);
    fujita = sleeves_join(s, JOIN_FUJITA, 0, 7);
    nagata = sleeves_join(s, JOIN_NAGATA, 0, 7);
    CHECK(ripple(&fujita) > 0.1, 0);
    CHECK(ripple(&nagata) < 0.01, 0);
    joined_free(&fujita);
    joined_free(&nagata);
    sleeves_free(s);
}

/* ---- What it cannot do at all ---- */

static void test_errors(void)
{
    static const double up[4] = {0, -1, 0, 1};
    pair *p = pair_open(0, AROUND, 17);
    joined j = pair_join(p, JOIN_FUJITA, 3);
    sleeves *s;
    CHECK(j.status == JOIN_UNEQUAL, 0);
    joined_free(&j);
    pair_free(p);

    s = sleeves_round(1, 2, 0, up); /* no centre line */
    j = sleeves_join(s, JOIN_FUJITA, 0, 3);
    CHECK(j.status == JOIN_NO_PLANE, 1);
    CHECK(j.item == joini_at(&s->a.rim, 0)->point, 1);
    joined_free(&j);
    sleeves_free(s);
}

/* A point of the loop that has stepped back beside the one before it: all its triangles lie to one
   side of the plane through it and the centre line. */
static void test_no_line(void)
{
    n3_vec x[2][N], w[2][N];
    sleeves *s;
    joined j;
    int i;
    for (i = 0; i < N; i++) {
        x[0][i] = round_z(1, 0, i, N);
        x[1][i] = round_z(1, 2, i, N);
        w[0][i] = n3_v(0, 0, -1);
        w[1][i] = n3_v(0, 0, 1);
    }
    x[0][5] = n3_sub(n3_mul(2, round_z(1, 0, 3, N)), n3_v((n3_real)0.3, 0, 0));
    w[0][5] = n3_sub(round_z(1, -1, 5, N), x[0][5]);
    s = sleeves_open(x, w);
    j = sleeves_join(s, JOIN_FUJITA, 0, 3);
    CHECK(j.status == JOIN_NO_LINE, 0);
    CHECK(j.item == 5, 0);
    joined_free(&j);
    j = sleeves_join(s, JOIN_NAGATA, 0, 3);
    CHECK(j.status == JOIN_OK, 1);
    joined_free(&j);
    sleeves_free(s);
}

const test_case tests_fujita[] = {
    {"F2.4.1 the work plane", test_F241_work_plane},
    {"F2.4.3 control points", test_F243_control_points},
    {"F2.4.3 parallel tangents", test_F243_parallel},
    {"F2.4.4 cells", test_F244_cells},
    {"F2.5 a sharp bend", test_F25_sharp_bend},
    {"fujita: tangents meet behind a point", test_failure_1_behind},
    {"fujita: parallel, the same direction", test_failure_2_same_direction},
    {"fujita: an abrupt change", test_failure_3_abrupt},
    {"fujita: ripples", test_failure_4_ripples},
    {"fujita: errors", test_errors},
    {"fujita: no line in the plane", test_no_line},
    {NULL, NULL}};
