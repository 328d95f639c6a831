/* seams: the angles at the seams of the five inputs, by all methods, beside those of the thesis; as
 * a table for the README. With a folder: the inputs themselves, as OBJ files into it. */
#include "inputs.h"
#include "join.h"

#include <stdio.h>
#include <stdlib.h>

enum { ROWS = 3, SIDES = 3 * 2 * (RINGS - 1) * AROUND, LOOP = 2 * AROUND };
enum { POINTS = (2 * RINGS + 31) * AROUND, TRIANGLES = (4 * (RINGS - 1) + 2 * 32) * AROUND };

/* A tube with its loop; the topology's workspace is of the size that a mesh of this kind needs. */
typedef struct side {
    tube tube;
    n3_topology topology;
    int work[3 * SIDES + 1], scratch[SIDES], sides[LOOP];
    join_loop loop[LOOP];
    join_border border;
    join_vertex vertex[LOOP];
    join_rim rim;
} side;

static void give_up(const char *reason)
{
    fprintf(stderr, "seams: %s\n", reason);
    exit(EXIT_FAILURE);
}

static void check(join_status status)
{
    if (status != JOIN_OK) give_up(join_status_text(status));
}

static void side_make(int number, int upper, side *s)
{
    const n3_mesh *m = &s->tube.mesh;
    input_make(number, upper, AROUND, &s->tube);
    if (n3_mesh_topology(m, s->work, sizeof s->work, &s->topology, NULL) != N3_OK)
        give_up("a tube is no mesh");
    s->border = join_border_make(m, &s->topology, s->scratch, s->sides, s->loop);
    check(join_rim_make(&s->border, join_border_with(&s->border, input_start(&s->tube, upper)), 0,
                        s->vertex, &s->rim));
}

/* From a jump to degrees. */
static double degrees(n3_real jump) { return 2 * asin((double)jump / 2) * 180 / 3.14159265358979; }

static void print_range(const n3_real jump[2], const char *end)
{
    printf("%.1f-%.1f%s", degrees(jump[0]), degrees(jump[1]), end);
}

/* The upper seam, then the lower one. */
static void print_seams(const join_bridge *bridge, const n3_vec *moved, const char *end)
{
    static n3_vec point[POINTS];
    static int triangle[3 * TRIANGLES], work[9 * TRIANGLES + 1];
    n3_topology topology;
    n3_real jump[2];
    n3_mesh m;
    memset(&m, 0, sizeof m);
    m.point = &point[0].x;
    m.triangle = triangle;
    check(join_counts(bridge, &m.points, &m.triangles));
    check(join_mesh(bridge, moved, point, triangle));
    if (n3_mesh_topology(&m, work, sizeof work, &topology, NULL) != N3_OK)
        give_up("a bridge is no mesh");
    join_seam(bridge, &m, &topology, 1, jump);
    print_range(jump, "; ");
    join_seam(bridge, &m, &topology, 0, jump);
    print_range(jump, end);
}

static void print_row(int number)
{
    static const struct {
        int method, rows;
        const char *end;
    } columns[] = {{JOIN_FUJITA, ROWS, " | "},
                   {JOIN_NAGATA, ROWS, " | "},
                   {JOIN_STRAIGHT, ROWS, " | "},
                   {JOIN_FUJITA, 31, " | "},
                   {JOIN_NAGATA, 31, " |\n"}};
    static side lower, upper;
    const input *in = &inputs[number];
    size_t i;
    side_make(number, 0, &lower);
    side_make(number, 1, &upper);
    check(join_rims_match(&lower.rim, &upper.rim, NULL, 0, NULL));
    printf("| %s | %.1f-%.1f; %.1f-%.1f", in->title, in->upper[0], in->upper[1], in->lower[0],
           in->lower[1]);
    if (in->outlier > 0) printf(", two up to %.1f", in->outlier);
    printf(" | ");
    for (i = 0; i < sizeof columns / sizeof *columns; i++) {
        static join_column column[2 * AROUND];
        static n3_vec moved[RINGS * AROUND];
        join_options o = {0, {0, 0}};
        join_bridge bridge;
        o.method = columns[i].method;
        check(join_columns(&lower.rim, &upper.rim, &o, column, moved, &bridge, NULL));
        bridge.rows = columns[i].rows;
        print_seams(&bridge, moved, columns[i].end);
    }
}

static void write_obj(const char *folder, int number, int upper)
{
    static tube t;
    char path[1024];
    FILE *f;
    int i;
    input_make(number, upper, AROUND, &t);
    snprintf(path, sizeof path, "%s/%s_%s.obj", folder, inputs[number].name,
             upper ? "upper" : "lower");
    f = fopen(path, "w");
    if (!f) give_up("a file cannot be written");
    for (i = 0; i < t.mesh.points; i++)
        fprintf(f, "v %.17g %.17g %.17g\n", (double)t.point[i].x, (double)t.point[i].y,
                (double)t.point[i].z);
    for (i = 0; i < t.mesh.triangles; i++)
        fprintf(f, "f %d %d %d\n", t.triangle[3 * i] + 1, t.triangle[3 * i + 1] + 1,
                t.triangle[3 * i + 2] + 1);
    if (fclose(f)) give_up("a file cannot be written");
}

int main(int argc, char **argv)
{
    int i;
    for (i = 0; i < 2 * INPUTS && argc > 1; i++) write_obj(argv[1], i / 2, i % 2);
    if (argc > 1) return 0;
    printf("| upper; lower seam | thesis | Fujita, %d rows | default, %d rows | straight | "
           "Fujita, 31 rows | default, 31 rows |\n| --- | --- | --- | --- | --- | --- | --- |\n",
           ROWS, ROWS);
    for (i = 0; i < INPUTS; i++) print_row(i);
    return fflush(stdout) || ferror(stdout);
}
