/* brown: a lattice of points into a surface of Brown's squares. */
#include "lattice.h"

#include "../mesh_output.h"
#include "../smooth_command.h"

#include <errno.h>
#include <stdlib.h>

const char program[] = "brown";

const char usage[] =
    "usage: brown IN -o OUT [-n LEVEL | --tol T[%] | --order 2|3] [--text | --binary] [--quiet]\n"
    "             [--view VIEW] [--size WxH] [--turn DEG] [--rise DEG] [--zoom Z] [--up x|y|z]\n";

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
    "  -o OUT         .obj .stl .ply .vtu .vtk .msh: flat triangles; .png: a picture\n"
    "  -n LEVEL       with so many parts for each side of a square, 1 to 1000 (8)\n"
    "  --tol T        with as few as keep the surface within this distance of them, measured\n"
    "                 in the middle of each and of its sides; with a %, of the bounding box's\n"
    "                 diagonal\n"
    "  --order 2|3    triangles of 6 or of 10 nodes on the surface (.vtu .vtk .msh)\n"
    "  --text         numbers that people can read (up to 10000 triangles)\n"
    "  --binary       numbers as bytes (beyond)\n"
    "  --view VIEW    of a picture: shaded, zebra, isophote, mean or gauss\n"
    "  --size, --turn, --rise, --zoom, --up\n"
    "                 its size and the camera, as those of smooth\n"
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

static void read_word(options *o, const char *a)
{
    if (!strcmp(a, "-h") || !strcmp(a, "--help")) {
        fputs(usage, stdout);
        print_and_exit(help);
    } else if (!strcmp(a, "--version")) {
        print_and_exit("brown " NAGATA3_VERSION "\n");
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
        if (request_value(r, argv[i], argv[i + 1]))
            i++;
        else if (!request_switch(r, argv[i]))
            read_word(&o, argv[i]);
    }
    if (!o.in) misuse("no file to read");
    if (!r->path) misuse("no file to write; -o OUT names it");
    request_check(r, 1);
    if (!(r->tolerance > 0) && r->kind == FACETS && !r->level && !has_extension(r->path, ".png"))
        r->level = 8;
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

/* An edge is sharp if the normals of its two squares differ at one of its quarters. */
static void mark_creases(surface *s)
{
    int e, i, k, two[2];
    for (e = 0; e < s->topology.edges; e++) {
        s->flags[e] &= N3_EDGE_BORDER;
        if (!n3i_is_regular(&s->mesh, &s->topology, e, two)) continue;
        for (k = 1; k < 4; k++) {
            n3_vec n[2];
            for (i = 0; i < 2; i++)
                n[i] = surface_side_normal(s, two[i], (n3_real)(i ? 4 - k : k) / 4);
            if (n3_len(n3_cross(n[0], n[1])) > N3_CREASE_LO) s->flags[e] |= N3_EDGE_CREASE;
        }
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
