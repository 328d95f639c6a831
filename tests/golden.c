/* golden.c: the header against tests/golden.csv, which golden_gen.c computed in __float128.
 *
 * The inputs are exact, so all errors are roundings, and a rounding is as good as a change of an
 * input: a difference of points is rounded by eps/2 of itself, a normal (in float only, where the
 * row has it to 17 digits) by eps/2. Between these and a result lie products and sums of unit
 * vectors; the longest chain (chord, its direction, cross product, unit, sum, unit, cross product,
 * unit, dot product) has 9 links of at most 3 roundings: 27 eps/2. The condition of a row adds up
 * the largest effects of a change by eps of every input, hence the bound K eps size condition. */
#include "check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { K = 14, MAX_IN = 64, MAX_OUT = 24 };

/* The rows that must at least be there. */
#define ROWS (sizeof(n3_real) == sizeof(float) ? 590 : 820)

/* These bounds are far above what happens. So that a loss of accuracy shows all the same: in the
 * rows of this table whose condition is at most WELL all errors are below CLAIM eps of the size
 * (most, 6, in second derivatives). Another table has other figures, but the same bounds. */
enum { WELL = 100, CLAIM = 8 };

typedef struct row {
    double size, condition;
    n3_real in[MAX_IN];
    double want[MAX_OUT], got[MAX_OUT];
} row;

static n3_vec vec_at(const n3_real *in) { return n3_v(in[0], in[1], in[2]); }

static n3_vertex vertex_at(const n3_real *in)
{
    n3_vertex a;
    a.x = vec_at(in);
    a.n = vec_at(in + 3);
    return a;
}

static double *put(double *out, n3_vec a)
{
    out[0] = (double)a.x;
    out[1] = (double)a.y;
    out[2] = (double)a.z;
    return out + 3;
}

static n3_options options(int rule, n3_real tan_lo, n3_real tan_hi)
{
    n3_options o;
    o.rule = rule;
    o.tan_lo = tan_lo;
    o.tan_hi = tan_hi;
    return o;
}

static double condition_bound(const row *r) { return K * EPS * r->size * r->condition; }

/* The segment has no cancellation, so nearly parallel normals, X = n0 x n1, cost only 1/|X| where
 * the condition has 1/|X|^2. In units of eps/2: <n0, d> n1 + <n1, d> n0 has 12 L in a coordinate,
 * X has 7.4 |X| in length, |X|^2 thus 18; the cross product of the two has 21 + 15 + 4 L |X|, and
 * the quotient, at most 2 L/|X|, adds 19 of itself: in all 78 L/|X|, 39 in eps. */
static double segment_bound(const row *r)
{
    n3_vertex a = vertex_at(r->in), b = vertex_at(r->in + 6);
    double X = (double)n3_len(n3_cross(a.n, b.n)), L = (double)n3_len(n3_sub(b.x, a.x));
    return X <= (double)N3_PARALLEL ? 0 : 39 * EPS * L / X;
}

static void run_segment(row *r)
{
    put(r->got, n3_segment_curvature(vertex_at(r->in), vertex_at(r->in + 6)));
}

static void run_plane(row *r)
{
    n3_vec m = n3_curve_plane(vertex_at(r->in), vertex_at(r->in + 6));
    double side = (double)m.x * r->want[0] + (double)m.y * r->want[1] + (double)m.z * r->want[2];
    put(r->got, side < 0 ? n3_mul(-1, m) : m);
}

static void edge(row *r, const n3_real *in, n3_options o)
{
    n3_edge e = n3_edge_make(vertex_at(in), vertex_at(in + 6), &o);
    put(put(r->got, e.p[1]), e.p[2]);
}

static void run_edge_paper(row *r)
{
    edge(r, r->in + 2, options(N3_RULE_PAPER, r->in[0], r->in[1]));
}

static void run_edge_arc(row *r) { edge(r, r->in, options(N3_RULE_ARC, 0, 0)); }

static void run_patch_nagata(row *r)
{
    const n3_real *in = r->in;
    n3_patch2 q = n3_patch2_make(vertex_at(in), vertex_at(in + 6), vertex_at(in + 12));
    put(put(put(r->got, q.p[3]), q.p[4]), q.p[5]);
}

static void patch(row *r, const n3_real *in, n3_options o)
{
    n3_patch p = n3_patch_make(vertex_at(in), vertex_at(in + 6), vertex_at(in + 12), &o);
    double *out = r->got;
    int i;
    for (i = 3; i < 10; i++) out = put(out, p.p[i]);
}

static void run_patch_paper(row *r)
{
    patch(r, r->in + 2, options(N3_RULE_PAPER, r->in[0], r->in[1]));
}

static void run_patch_arc(row *r) { patch(r, r->in, options(N3_RULE_ARC, 0, 0)); }

static void run_centre_arc(row *r)
{
    n3_options o = options(N3_RULE_ARC, 0, 0);
    n3_edge e[3];
    n3_vec n[3], mid[3];
    int i;
    for (i = 0; i < 3; i++) {
        n3_vertex a = vertex_at(r->in + 6 * i), b = vertex_at(r->in + 6 * ((i + 1) % 3));
        e[i] = n3_edge_make(a, b, &o);
        n[i] = a.n;
        mid[i] = vec_at(r->in + 18 + 3 * i);
    }
    put(r->got, n3_patch_centre_arc(&e[0], &e[1], &e[2], n, mid));
}

static n3_edge edge_at(const n3_real *in)
{
    n3_edge e;
    int i;
    for (i = 0; i < 4; i++) e.p[i] = vec_at(in + 3 * i);
    return e;
}

static void run_edge_point(row *r)
{
    n3_edge e = edge_at(r->in + 1);
    put(r->got, n3_edge_point(&e, r->in[0]));
}

static void run_edge_jet(row *r)
{
    n3_edge e = edge_at(r->in + 1);
    n3_curve_jet j = n3_edge_jet(&e, r->in[0]);
    put(put(r->got, j.dt), j.dtt);
}

static void run_point2(row *r)
{
    n3_patch2 q;
    int i;
    for (i = 0; i < 6; i++) q.p[i] = vec_at(r->in + 2 + 3 * i);
    put(r->got, n3_patch2_point(&q, r->in[0], r->in[1]));
}

static n3_patch patch_at(const n3_real *in)
{
    n3_patch p;
    int i;
    for (i = 0; i < 10; i++) p.p[i] = vec_at(in + 3 * i);
    return p;
}

static void run_point(row *r)
{
    n3_patch p = patch_at(r->in + 2);
    put(r->got, n3_patch_point(&p, r->in[0], r->in[1]));
}

static void run_jet_point(row *r)
{
    n3_patch p = patch_at(r->in + 2);
    put(r->got, n3_patch_jet(&p, r->in[0], r->in[1]).x);
}

static void run_jet(row *r)
{
    n3_patch p = patch_at(r->in + 2);
    n3_jet j = n3_patch_jet(&p, r->in[0], r->in[1]);
    put(put(put(put(put(r->got, j.du), j.dv), j.duu), j.duv), j.dvv);
}

static void run_normal(row *r)
{
    n3_patch p = patch_at(r->in + 2);
    put(r->got, n3_patch_normal(&p, r->in[0], r->in[1]));
}

/* Each function of the header with the kind of rows that it is compared with. */
static const struct kind {
    const char *name, *function;
    int inputs, outputs;
    double (*bound)(const row *r);
    void (*run)(row *r);
} kinds[] = {
    {"segment", "segment", 12, 3, segment_bound, run_segment},
    {"plane", "plane", 12, 3, condition_bound, run_plane},
    {"edge_paper", "edge_paper", 14, 6, condition_bound, run_edge_paper},
    {"edge_arc", "edge_arc", 12, 6, condition_bound, run_edge_arc},
    {"patch_nagata", "patch_nagata", 18, 9, condition_bound, run_patch_nagata},
    {"patch_paper", "patch_paper", 20, 21, condition_bound, run_patch_paper},
    {"patch_arc", "patch_arc", 18, 21, condition_bound, run_patch_arc},
    {"centre_arc", "centre_arc", 27, 3, condition_bound, run_centre_arc},
    {"edge_point", "edge_point", 13, 3, condition_bound, run_edge_point},
    {"edge_jet", "edge_jet", 13, 6, condition_bound, run_edge_jet},
    {"point2", "patch2_point", 20, 3, condition_bound, run_point2},
    {"point", "patch_point", 32, 3, condition_bound, run_point},
    {"point", "patch_jet.x", 32, 3, condition_bound, run_jet_point},
    {"jet", "patch_jet", 32, 15, condition_bound, run_jet},
    {"normal", "patch_normal", 32, 3, condition_bound, run_normal},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* The worst errors of a kind: in eps of the size where well conditioned, and in eps of the size
 * times the condition everywhere. */
typedef struct worst {
    double plain, scaled;
} worst;

static FILE *open_table(void)
{
    FILE *f = fopen("tests/golden.csv", "r");
    const char *path = getenv("N3_GOLDEN");
    return !f && path ? fopen(path, "r") : f;
}

/* The next field of a line, cut off at its comma. */
static char *field(char **line)
{
    char *start = *line, *end = start + strcspn(start, ",\r\n");
    *line = *end == ',' ? end + 1 : end;
    *end = 0;
    return start;
}

static int read_numbers(row *r, const struct kind *k, char *line)
{
    int i;
    for (i = 0; i < k->inputs; i++) r->in[i] = (n3_real)strtod(field(&line), NULL);
    for (i = 0; i < k->outputs; i++) {
        char *s = field(&line);
        if (!*s) return 0;
        r->want[i] = strtod(s, NULL);
    }
    return !*line;
}

static void compare(row *r, const struct kind *k, long line, worst *w)
{
    double error = 0, bound = k->bound(r);
    int i;
    k->run(r);
    for (i = 0; i < k->outputs; i++) {
        CHECK_NEAR(r->got[i], r->want[i], bound, line);
        error = fmax(error, fabs(r->got[i] - r->want[i]));
    }
    if (error > 0) error /= EPS * r->size;
    if (r->condition <= WELL) w->plain = fmax(w->plain, error);
    w->scaled = fmax(w->scaled, error / r->condition);
}

/* Returns true when the line is a row for this precision. */
static int run_line(char *line, long number, worst w[KINDS])
{
    row r;
    const char *name = field(&line), *precision;
    int i, known = 0;
    (void)field(&line); /* what the case is called */
    precision = field(&line);
    r.size = strtod(field(&line), NULL);
    r.condition = strtod(field(&line), NULL);
    if (sizeof(n3_real) == sizeof(float) && strcmp(precision, "both") != 0) return 0;
    for (i = 0; i < KINDS; i++) {
        char copy[4096];
        if (strcmp(kinds[i].name, name) != 0) continue;
        strcpy(copy, line);
        known = CHECK(read_numbers(&r, &kinds[i], copy), number);
        if (known) compare(&r, &kinds[i], number, &w[i]);
    }
    return CHECK(known, number);
}

static void report(const worst w[KINDS])
{
    int i;
    printf("golden, %s, errors in eps of the size where well conditioned / times condition:",
           sizeof(n3_real) == sizeof(float) ? "float" : "double");
    for (i = 0; i < KINDS; i++) {
        CHECK_NEAR(w[i].plain, 0, CLAIM, i);
        printf(" %s %.2g/%.2g", kinds[i].function, w[i].plain, w[i].scaled);
    }
    printf("\n");
}

static void golden_rows(void)
{
    char line[4096];
    worst w[KINDS] = {{0, 0}};
    long number = 0, rows = 0;
    FILE *f = open_table();
    if (!CHECK(f != NULL, 0)) return;
    while (fgets(line, sizeof line, f)) {
        number++;
        if (*line != '#') rows += run_line(line, number, w);
    }
    fclose(f);
    CHECK(rows >= ROWS, rows);
    report(w);
}

const test_case tests_golden[] = {{"golden_rows", golden_rows}, {NULL, NULL}};
