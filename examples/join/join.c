/* join: two triangle meshes with a border loop each into one, over a smooth bridge. */
#include "join.h"
#include "mesh_output.h"
#include "smooth_command.h"

#include <errno.h>
#include <stdlib.h>

const char program[] = "join";

const char usage[] =
    "usage: join A B -o OUT [--loops A,B] [--start A,B] [--direction against|with]\n"
    "            [--rows N | --tol T[%]] [--method nagata|fujita|straight] [--strength A,B]\n"
    "            [--normals] [--weld REL] [--quiet]\n";

static const char help[] =
    "Joins two meshes of triangles, each at a loop of its border, by a bridge that is tangent to\n"
    "both. Their own points and triangles stay as they are.\n"
    "\n"
    "  A, B              OBJ, STL, PLY, VTU, legacy VTK or Gmsh MSH\n"
    "  -o OUT            .obj .stl .ply .vtu .vtk .msh: triangles; .step: a surface over them\n"
    "  --loops A,B       which loops: 1, 2, ... in the order of the files' triangles, or v5: that\n"
    "                    with the point 5. (The two that are nearest to each other.)\n"
    "  --start A,B       points of the loops that are joined first (where the bridge twists "
    "least)\n"
    "  --direction WAY   the loop of B runs against its triangles, as it must where both meshes\n"
    "                    look outwards, or with them: then B is turned inside out. (against,\n"
    "                    unless the bridge would clearly twist)\n"
    "  --rows N          rows of points on the bridge, 0 to 100000; overrules --tol\n"
    "  --tol T           as many rows as keep its curves within T, a length, or a percentage of\n"
    "                    the diagonal of the loops' bounding box (0.1%)\n"
    "  --method METHOD   nagata: cubic edges tangent to the border triangles (the default)\n"
    "                    fujita: the work planes of Fujita's thesis; moves the loop of B\n"
    "                    straight: straight lines\n"
    "  --strength A,B    lengths of the handles at either end, in units of what is usual (1,1);\n"
    "                    fujita: parts of the way to where the tangents meet, below 1\n"
    "  --normals         tangent to the normals in the files, not to the triangles\n"
    "  --weld REL        join points of one mesh closer than this part of the bounding box's\n"
    "                    diagonal. Equal points are always joined. (STL: 1e-6, others: 0)\n"
    "  --quiet           nothing on stderr but errors\n"
    "  -h, --help        this text\n"
    "  --version         the version\n"
    "\n"
    "Points count from 1, as in OBJ. Exit status: 0, 1 for bad input or output, 2 for bad usage.\n";

/* Of one mesh. Numbers are 0 where nothing is asked. */
typedef struct side {
    const char *path;
    int loop, point, start;
    mesh mesh;
    int *number; /* of each point, in the file */
    n3_mesh view;
    n3_topology topology;
    void *work;
    int *sides;
    join_loop *loops;
    join_border border;
    join_vertex *vertex;
    join_rim rim;
} side;

typedef struct options {
    side side[2];
    int sides;
    request out, within; /* the latter for its tolerance alone, of the rows */
    join_options join;
    int rows, along, normals, quiet; /* rows negative: by the tolerance */
    n3_real weld;                    /* negative: by the format */
} options;

/* ---- The command line ---- */

/* Cuts "A,B" in two. */
static void read_two(const char *option, const char *value, char two[2][32])
{
    const char *comma = strchr(value, ',');
    size_t n = comma ? (size_t)(comma - value) : 0;
    if (!comma || n >= 32 || strlen(comma + 1) >= 32)
        misuse("%s takes two, one for each mesh, not '%s'", option, value);
    memcpy(two[0], value, n);
    two[0][n] = 0;
    strcpy(two[1], comma + 1);
}

static void read_pair(options *o, const char *option, const char *value)
{
    const int most = 715827882; /* points in the arrays of a mesh */
    char two[2][32];
    int i;
    read_two(option, value, two);
    for (i = 0; i < 2; i++) {
        side *s = &o->side[i];
        if (!strcmp(option, "--strength"))
            o->join.strength[i] = option_number(option, two[i], 1e-6, 1e6);
        else if (!strcmp(option, "--start"))
            s->start = option_whole(option, two[i], 1, most);
        else if (two[i][0] == 'v')
            s->point = option_whole(option, two[i] + 1, 1, most);
        else
            s->loop = option_whole(option, two[i], 1, most);
    }
}

/* The place of the value in a list that ends with NULL. */
static int read_word(const char *option, const char *value, const char *const *list)
{
    int i;
    for (i = 0; list[i] && strcmp(list[i], value); i++) continue;
    if (!list[i]) misuse("%s has no '%s'", option, value);
    return i;
}

static int read_value(options *o, const char *a, const char *value)
{
    static const char *const known[] = {"-o",     "--loops",  "--start", "--direction",
                                        "--rows", "--method", "--weld",  "--strength",
                                        "--tol",  NULL};
    static const char *const ways[] = {"against", "with", NULL};
    static const char *const methods[] = {"nagata", "fujita", "straight", NULL};
    int i;
    for (i = 0; known[i] && strcmp(a, known[i]); i++) continue;
    if (!known[i]) return 0;
    if (!value) misuse("%s takes a value", a);
    if (i == 0) o->out.path = value;
    if (i == 1 || i == 2 || i == 7) read_pair(o, a, value);
    if (i == 3) o->along = read_word(a, value, ways) ? 1 : -1;
    if (i == 4) o->rows = option_whole(a, value, 0, 100000);
    if (i == 5) o->join.method = read_word(a, value, methods);
    if (i == 6) o->weld = option_number(a, value, 0, 1);
    if (i == 8) option_tolerance(&o->within, a, value);
    return 1;
}

static void check_options(options *o)
{
    int i;
    if (o->sides < 2) misuse("two files to read are needed");
    if (!o->out.path) misuse("no file to write; -o OUT names it");
    for (i = 0; i < 2 && o->join.method == JOIN_FUJITA; i++)
        if (o->join.strength[i] >= 1) misuse("--method fujita takes a --strength below 1");
}

/* An option without a value, or a file. */
static void read_word_alone(options *o, const char *a)
{
    if (!strcmp(a, "--normals"))
        o->normals = 1;
    else if (!strcmp(a, "--quiet"))
        o->quiet = 1;
    else if (a[0] == '-')
        misuse("there is no option '%s'", a);
    else if (o->sides == 2)
        misuse("two files at a time, not '%s' as well", a);
    else
        o->side[o->sides++].path = a;
}

static void read_options(int argc, char **argv, options *o)
{
    int i;
    memset(o, 0, sizeof *o);
    o->out = o->within = request_plain();
    o->rows = -1;
    o->weld = -1;
    o->within.tolerance = (n3_real)0.001;
    o->within.relative = 1;
    for (i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "-h") || !strcmp(argv[i], "--help")) {
            fputs(usage, stdout);
            print_and_exit(help);
        }
        if (!strcmp(argv[i], "--version")) print_and_exit("join " NAGATA3_VERSION "\n");
        if (read_value(o, argv[i], argv[i + 1]))
            i++;
        else
            read_word_alone(o, argv[i]);
    }
    check_options(o);
}

/* ---- The two meshes ---- */

/* Points keep the numbers that they have in the file, where others are joined or left out. */
static void read_mesh(const options *o, side *s)
{
    mesh *m = &s->mesh;
    double *value;
    int i;
    n3_real weld;
    mesh_read(s->path, 0, m);
    value = allocate((size_t)m->points, sizeof *value);
    for (i = 0; i < m->points; i++) value[i] = i + 1;
    field_add(&m->point_field, &m->point_fields, "number", 6, 1, value);
    weld = strcmp(m->format, "STL") ? 0 : (n3_real)1e-6;
    mesh_join(m, o->weld >= 0 ? o->weld : weld);
    s->number = allocate((size_t)m->points, sizeof *s->number);
    for (i = 0; i < m->points; i++)
        s->number[i] = (int)m->point_field[m->point_fields - 1].value[i];
    if (!m->triangles) fail(s->path, 0, "all its triangles have collapsed");
    if (!o->quiet && (m->joined || m->welded || m->unused))
        fprintf(stderr, "%s: %s: joined %d points, left out %d in no triangle\n", program, s->path,
                m->joined + m->welded, m->unused);
}

static void find_topology(side *s)
{
    const mesh *m = &s->mesh;
    n3_mesh *v = &s->view;
    n3_status status;
    size_t size;
    int item = -1;
    v->points = m->points;
    v->triangles = m->triangles;
    v->point = &m->point->x;
    v->triangle = m->triangle;
    if (m->normals) {
        v->normals = m->normals;
        v->normal = &m->normal->x;
        v->corner = m->corner;
    }
    size = n3_mesh_workspace(v);
    s->work = allocate(size, 1);
    status = n3_mesh_topology(v, s->work, size, &s->topology, &item);
    if (status == N3_BAD_POINT) fail(s->path, 0, "the point %d is not finite", s->number[item]);
    if (status != N3_OK) fail(s->path, 0, "%s", n3_status_text(status));
}

static void find_borders(side *s)
{
    const n3_mesh *v = &s->view;
    size_t count;
    find_topology(s);
    count = (size_t)join_border_sides(v, &s->topology);
    if (!count) fail(s->path, 0, "it is closed: there is no border to join at");
    s->sides = allocate(count + 3 * (size_t)v->triangles, sizeof *s->sides);
    s->loops = allocate(count, sizeof *s->loops);
    s->vertex = allocate(count, sizeof *s->vertex);
    s->border = join_border_make(v, &s->topology, s->sides + count, s->sides, s->loops);
}

/* The point with a number in the file. */
static int find_point(const side *s, int number)
{
    int i;
    for (i = 0; i < s->mesh.points && s->number[i] != number; i++) continue;
    if (i == s->mesh.points)
        fail(s->path, 0, "there is no point %d; or it was joined to another, or left out", number);
    return i;
}

/* The loop that is asked for, -1 for none. */
static int find_loop(const side *s)
{
    int loop = s->loop - 1;
    if (s->point) loop = join_border_with(&s->border, find_point(s, s->point));
    if (s->point && loop < 0) fail(s->path, 0, "the point %d is not on the border", s->point);
    if (loop >= s->border.loops)
        fail(s->path, 0, "there is no loop %d, only %d", s->loop, s->border.loops);
    if (loop >= 0 && !s->border.loop[loop].closed)
        fail(s->path, 0, "loop %d: %s", loop + 1, join_status_text(JOIN_OPEN));
    return loop;
}

static void check_loops(const side *s)
{
    int i;
    for (i = 0; i < s->border.loops && !s->border.loop[i].closed; i++) continue;
    if (i == s->border.loops) fail(s->path, 0, "%s", join_status_text(JOIN_OPEN));
}

/* Where one loop is given the other is the nearest to it. */
static void choose_loops(side two[2], int loop[2])
{
    join_border border[2];
    int i, nearest[2];
    for (i = 0; i < 2; i++) {
        check_loops(&two[i]);
        loop[i] = find_loop(&two[i]);
        border[i] = two[i].border;
        if (loop[i] < 0) continue;
        border[i].loop += loop[i];
        border[i].loops = 1;
    }
    join_border_nearest(&border[0], &border[1], nearest);
    for (i = 0; i < 2; i++)
        if (loop[i] < 0) loop[i] = nearest[i];
}

static void make_rims(options *o)
{
    int i, loop[2], start[2], item = -1, given = o->side[0].start > 0;
    join_status status;
    choose_loops(o->side, loop);
    for (i = 0; i < 2; i++) {
        side *s = &o->side[i];
        status = join_rim_make(&s->border, loop[i], o->normals, s->vertex, &s->rim);
        if (status != JOIN_OK) fail(s->path, 0, "%s", join_status_text(status));
        if (given) start[i] = find_point(s, s->start);
    }
    status =
        join_rims_match(&o->side[0].rim, &o->side[1].rim, given ? start : NULL, o->along, &item);
    if (status == JOIN_BAD_START)
        fail(o->side[item].path, 0, "the point %d is not on loop %d", o->side[item].start,
             loop[item] + 1);
    if (status != JOIN_OK) fail(o->side[1].path, 0, "%s", join_status_text(status));
}

/* ---- The bridge ---- */

/* The diagonal of the box of both loops. */
static n3_real loops_size(const side two[2])
{
    n3_vec lo = two[0].vertex[0].x, hi = lo;
    int i, k;
    for (i = 0; i < 2; i++)
        for (k = 0; k < two[i].rim.count; k++) {
            n3_vec x = two[i].vertex[k].x;
            lo = n3_v(fmin(lo.x, x.x), fmin(lo.y, x.y), fmin(lo.z, x.z));
            hi = n3_v(fmax(hi.x, x.x), fmax(hi.y, x.y), fmax(hi.z, x.z));
        }
    return n3_len(n3_sub(hi, lo));
}

static void fail_at(const options *o, join_status status, int item)
{
    const side *s = &o->side[item >= o->side[0].mesh.points];
    if (item < 0) fail(o->side[1].path, 0, "%s", join_status_text(status));
    if (s != o->side) item -= o->side[0].mesh.points;
    fail(s->path, 0, "%s (point %d)", join_status_text(status), s->number[item]);
}

static void choose_rows(const options *o, join_bridge *bridge)
{
    n3_real tolerance = o->within.tolerance;
    if (o->within.relative) tolerance *= loops_size(o->side);
    bridge->rows = o->rows >= 0 ? o->rows : join_rows(bridge, tolerance);
    if (bridge->rows < 0) fail(o->out.path, 0, "the tolerance wants too many rows");
}

static void make_bridge(const options *o, join_bridge *bridge, mesh *m)
{
    const side *a = &o->side[0], *b = &o->side[1];
    const size_t columns = (size_t)a->rim.count + (size_t)b->rim.count;
    join_column *column = allocate(columns, sizeof *column);
    n3_vec *moved = allocate((size_t)b->mesh.points, sizeof *moved);
    int i, item = -1;
    join_status status = join_columns(&a->rim, &b->rim, &o->join, column, moved, bridge, &item);
    if (status != JOIN_OK) fail_at(o, status, item);
    choose_rows(o, bridge);
    memset(m, 0, sizeof *m);
    status = join_counts(bridge, &m->points, &m->triangles);
    if (status != JOIN_OK) fail_at(o, status, -1);
    m->format = "OBJ";
    m->point = allocate((size_t)m->points, sizeof *m->point);
    m->triangle = allocate((size_t)m->triangles, 3 * sizeof *m->triangle);
    m->corner = allocate((size_t)m->triangles, 3 * sizeof *m->corner);
    m->group = allocate((size_t)m->triangles, sizeof *m->group);
    m->cell = allocate((size_t)m->triangles, sizeof *m->cell);
    for (i = 0; i < 3 * m->triangles; i++) m->corner[i] = -1;
    join_mesh(bridge, moved, m->point, m->triangle);
    free(column);
    free(moved);
}

static void report(const options *o, const join_bridge *bridge, const surface *s)
{
    double degrees[3];
    int i;
    for (i = 0; i < 3; i++) {
        n3_real jump[2];
        join_seam(bridge, &s->mesh, &s->topology, i, jump);
        degrees[i] = 2 * asin(fmin((double)jump[1] / 2, 1)) * 180 / 3.14159265358979323846;
    }
    fprintf(stderr, "%s: loops of %d and %d points, %d rows between them\n", program,
            bridge->a.count, bridge->b.count, bridge->rows);
    if (degrees[2] > 90)
        fprintf(stderr, "%s: the bridge folds: it may cut through itself; try another --strength\n",
                program);
    fprintf(stderr, "%s: the seams bend by at most %.3g degrees at %s, %.3g at %s\n", program,
            degrees[0], o->side[0].path, degrees[1], o->side[1].path);
    if (bridge->b.step > 0)
        fprintf(stderr, "%s: %s is turned inside out\n", program, o->side[1].path);
    fprintf(stderr, "%s: wrote %s, %d triangles on %d points\n", program, o->out.path,
            s->mesh.triangles, s->mesh.points);
}

/* Normals are those of smooth, with creases from 50 degrees on. */
static void write_mesh(options *o, const join_bridge *bridge, const mesh *m)
{
    const n3_real cos_crease = (n3_real)cos(50 * 3.14159265358979323846 / 180);
    surface s;
    surface_make(o->out.path, m, smooth_rule_find("paper"), cos_crease, &s);
    product_write(&o->out, m, &s);
    progress_hide();
    if (!o->quiet) report(o, bridge, &s);
    surface_free(&s);
}

static void side_free(side *s)
{
    mesh_free(&s->mesh);
    free(s->number);
    free(s->work);
    free(s->sides);
    free(s->loops);
    free(s->vertex);
}

/* One part for each edge leaves the triangles as they are; STEP has no triangles. */
static void check_output(options *o)
{
    o->out.level = 1;
    if (product_refuse(&o->out)) o->out.level = 0;
    if (product_refuse(&o->out)) misuse("'%s' %s", o->out.path, product_refuse(&o->out));
}

int main(int argc, char **argv)
{
    static options o;
    join_bridge bridge;
    mesh m;
    int i;
    read_options(argc, argv, &o);
    check_output(&o);
    output_catch_signals();
    if (o.quiet) progress_hide();
    for (i = 0; i < 2; i++) {
        read_mesh(&o, &o.side[i]);
        find_borders(&o.side[i]);
    }
    make_rims(&o);
    make_bridge(&o, &bridge, &m);
    write_mesh(&o, &bridge, &m);
    mesh_free(&m);
    for (i = 0; i < 2; i++) side_free(&o.side[i]);
    return 0;
}
