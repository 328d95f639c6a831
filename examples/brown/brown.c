/* brown: a lattice of points into a surface of Brown's squares. */
#include "lattice.h"

#include "../mesh_output.h"
#include "../smooth_command.h"

#include <errno.h>
#include <stdlib.h>

const char program[] = "brown";

const char usage[] = "usage: brown IN -o OUT [-n LEVEL | --tol T[%] | --order 2|3]\n"
                     "             [--text | --binary] [--quiet]\n";

static const char help[] =
    "Lays a surface of Brown's squares through a lattice of points, shaped by parameters.\n"
    "\n"
    "  IN             text, in lines; # begins a comment:\n"
    "                   lattice COLUMNS ROWS     points along u and along v\n"
    "                   point X Y Z              COLUMNS * ROWS of them, u first\n"
    "                   u J PARAMETER VALUE...   of the curve through the row J, from 1 on\n"
    "                   v I PARAMETER VALUE...   of the curve through the column I\n"
    "                   curve u J I X Y Z X Y Z  own control points of a row's part I;\n"
    "                   curve v I J X Y Z X Y Z  of a column's part J\n"
    "                 * for J or I: all; one VALUE, or one for each point of the curve. The\n"
    "                 PARAMETERs: tension, bias, continuity, t-continuity, rise\n"
    "  -o OUT         .obj .stl .ply .vtu .vtk .msh: flat triangles\n"
    "  -n LEVEL       with so many parts for each side of a square, 1 to 1000 (8)\n"
    "  --tol T        with as few as keep the surface within this distance of them, measured\n"
    "                 in the middle of each and of its sides; with a %, of the bounding box's\n"
    "                 diagonal\n"
    "  --order 2|3    triangles of 6 or of 10 nodes on the surface (.vtu .vtk .msh)\n"
    "  --text         numbers that people can read (up to 10000 triangles)\n"
    "  --binary       numbers as bytes (beyond)\n"
    "  --quiet        nothing on stderr but what is wrong\n"
    "  -h, --help     this text\n"
    "  --version      the version\n"
    "\n"
    "Exit status: 0, 1 for bad input or output, 2 for bad usage.\n";

typedef struct options {
    const char *in;
    request out;
    int quiet;
} options;

/* What follows an option; false if the word is none. */
static int read_option(options *o, const char *a, const char *value)
{
    static const char *const known[] = {"-o", "-n", "--tol", "--order"};
    size_t i, n = sizeof known / sizeof *known;
    for (i = 0; i < n && strcmp(a, known[i]); i++) continue;
    if (i == n) return 0;
    if (!value) misuse("%s takes a value", a);
    if (i == 0) o->out.path = value;
    if (i == 1) o->out.level = option_whole(a, value, 1, 1000);
    if (i == 2) option_tolerance(&o->out, a, value);
    if (i == 3) o->out.kind = option_whole(a, value, 2, 3) == 2 ? QUADRATIC : CUBIC;
    return 1;
}

static void read_word(options *o, const char *a)
{
    if (!strcmp(a, "-h") || !strcmp(a, "--help")) {
        fputs(usage, stdout);
        print_and_exit(help);
    } else if (!strcmp(a, "--version")) {
        print_and_exit("brown " NAGATA3_VERSION "\n");
    } else if (!strcmp(a, "--text") || !strcmp(a, "--binary")) {
        o->out.text = a[2] == 't';
    } else if (!strcmp(a, "--quiet")) {
        o->quiet = 1;
    } else if (a[0] == '-') {
        misuse("there is no option '%s'", a);
    } else {
        if (o->in) misuse("one file at a time, not '%s' as well", a);
        o->in = a;
    }
}

static options read_options(int argc, char **argv)
{
    options o = {NULL, request_plain(), 0};
    request *r = &o.out;
    int i;
    for (i = 1; i < argc; i++) {
        if (read_option(&o, argv[i], argv[i + 1]))
            i++;
        else
            read_word(&o, argv[i]);
    }
    if (!o.in) misuse("no file to read");
    if (!r->path) misuse("no file to write; -o OUT names it");
    if ((r->level > 0) + (r->tolerance > 0) + (r->kind != FACETS) > 1)
        misuse("-n, --tol and --order exclude each other");
    if (!r->level && !(r->tolerance > 0) && r->kind == FACETS) r->level = 8;
    if (product_refuse(r)) misuse("'%s' %s", r->path, product_refuse(r));
    return o;
}

/* Two triangles for each square, 0 1 2 and 0 2 3 of its corners. */
static void make_mesh(const brown_lattice *l, mesh *m)
{
    int i, j, n = l->columns;
    memset(m, 0, sizeof *m);
    m->points = n * l->rows;
    m->point = allocate((size_t)m->points, sizeof *m->point);
    memcpy(m->point, l->point, (size_t)m->points * sizeof *m->point);
    for (j = 0; j + 1 < l->rows; j++)
        for (i = 0; i + 1 < n; i++, m->cells++) {
            int a = n * j + i;
            mesh_add_triangle(m, a, a + 1, a + n + 1);
            mesh_add_triangle(m, a, a + n + 1, a + n);
        }
}

/* A side of a triangle gets the curve that runs along it. */
static void put_curve(surface *s, int side, n3_edge e)
{
    n3_vec *net = s->net + s->mesh.points + 2 * s->topology.edge[side];
    if (s->mesh.triangle[side] > s->mesh.triangle[n3i_after(side)]) e = n3_edge_reverse(&e);
    net[0] = e.p[1];
    net[1] = e.p[2];
}

/* An edge is sharp where the normals in its middle differ. */
static void mark_creases(surface *s)
{
    const n3_real half = (n3_real)1 / 2;
    int e, i, two[2];
    for (e = 0; e < s->topology.edges; e++) {
        n3_vec n[2];
        if (!n3i_is_regular(&s->mesh, &s->topology, e, two)) continue;
        for (i = 0; i < 2; i++)
            n[i] = surface_normal(s, two[i] / 3, two[i] % 3 == 2 ? 0 : half,
                                  two[i] % 3 == 0 ? 0 : half);
        if (n3_len(n3_cross(n[0], n[1])) > N3_CREASE_LO) s->flags[e] |= N3_EDGE_CREASE;
    }
}

static void make_surface(const char *path, const brown_lattice *l, const mesh *m, surface *s)
{
    int t;
    surface_make(path, m, smooth_rule_find("flat"), -1, s);
    s->squares = m->triangles / 2;
    s->half = allocate((size_t)m->triangles, sizeof *s->half);
    for (t = 0; t < m->triangles; t++) s->half[t] = t;
    surface_take_squares(s);
    memset(s->flags, 0, (size_t)s->topology.edges * sizeof *s->flags);
    for (t = 0; t < m->triangles; t += 2) {
        brown_square *q = &s->square[t / 2];
        *q = brown_lattice_square(l, t / 2 % (l->columns - 1), t / 2 / (l->columns - 1));
        put_curve(s, 3 * t, q->side[0]);
        put_curve(s, 3 * t + 1, q->side[3]);
        put_curve(s, 3 * t + 4, n3_edge_reverse(&q->side[1]));
        put_curve(s, 3 * t + 5, n3_edge_reverse(&q->side[2]));
    }
    mark_creases(s);
}

int main(int argc, char **argv)
{
    options o = read_options(argc, argv);
    lattice l;
    mesh m;
    surface s;
    product out;
    output_catch_signals();
    if (o.quiet) progress_hide();
    lattice_read(o.in, &l);
    make_mesh(&l.view, &m);
    make_surface(o.in, &l.view, &m, &s);
    out = product_write(&o.out, &m, &s);
    progress_hide();
    if (!o.quiet)
        fprintf(stderr, "%s: %s: %d by %d points; %s: %d %s triangles, %d points\n", program, o.in,
                l.view.columns, l.view.rows, out.path, out.triangles, out.kind, out.points);
    surface_free(&s);
    mesh_free(&m);
    lattice_free(&l);
    return 0;
}
