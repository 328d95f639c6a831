/* smooth: a triangle mesh into a smooth surface, or into a finer mesh on it. */
#include "smooth_command.h"
#include "smooth_grid.h"

#include <errno.h>
#include <stdlib.h>

const char program[] = "smooth";

const char usage[] =
    "usage: smooth IN -o OUT [-n LEVEL | --tol T[%] | --order 2|3 | --bezier] [--text | --binary]\n"
    "              [--rule paper|arc|fit|nagata|pn|flat] [--quads brown] [--boundary]\n"
    "              [--crease DEG] [--weld REL] [--view VIEW] [--size WxH] [--turn DEG]\n"
    "              [--rise DEG] [--zoom Z] [--up x|y|z] [--report] [--json]\n"
    "              [--times] [--quiet]\n";

static const char help[] =
    "Lays a smooth surface through the points of a mesh of triangles, tangent to its normals.\n"
    "\n"
    "  IN             OBJ, STL, PLY, VTU, legacy VTK or Gmsh MSH, told by what is in it, not\n"
    "                 by its name. Without normals in it they are estimated.\n"
    "  -o OUT         .obj .stl .ply: flat triangles again, finer; .vtu .vtk .msh: the same, or\n"
    "                 elements with nodes on the surface; .step: the surface itself, solid where\n"
    "                 it closes, in millimetres; .png: a picture; .html: a page that\n"
    "                 turns it. Not needed with --report.\n"
    "  --boundary     of a mesh of volumes: the faces that one volume cell has\n"
    "\n"
    "  -n LEVEL       flat triangles, with so many parts per edge, 1 to 1000 (.obj .stl .ply: 4)\n"
    "  --tol T        flat triangles, as few as keep the surface within this distance of them;\n"
    "                 with a %, of the bounding box's diagonal\n"
    "  --order 2|3    triangles of 6 or of 10 nodes (.vtu .vtk .msh: 3)\n"
    "  --bezier       cubic triangles by their control points (.vtu .vtk; cell type 76, not 69)\n"
    "  --text         numbers that people can read (.ply .vtu .vtk .msh: up to 10000 triangles)\n"
    "  --binary       numbers as bytes (.stl, and the same beyond)\n"
    "\n"
    "  --rule RULE    paper: cubic Nagata patches (this is the default)\n"
    "                 arc: the same with edges that are circular arcs where they can be\n"
    "                 fit: arc, and the bend across edges fitted to the triangles around\n"
    "                 nagata: quadratic Nagata patches; pn: PN triangles; flat: the facets\n"
    "  --quads brown  over each quad one of Brown's squares, not two triangles: where quads meet,\n"
    "                 their tangent planes agree all along\n"
    "  --crease DEG   an edge is sharp where its faces meet at more than this angle (50). Normals\n"
    "                 in the file overrule it, OBJ smoothing groups add to it.\n"
    "  --weld REL     join points closer than this part of the bounding box's diagonal. Equal\n"
    "                 points are always joined. (STL: 1e-6, others: 0)\n"
    "  --view VIEW    of a picture: shaded (this is the default); zebra or isophote, stripes that\n"
    "                 break where normals jump; mean or gauss, curvature; net, control points;\n"
    "                 error, the distance from the triangles. By the patches' own normals.\n"
    "  --size WxH     of a .png, in pixels (800x600)\n"
    "  --turn DEG, --rise DEG\n"
    "                 the camera: round the axis that is up and above the ground (30, 20)\n"
    "  --zoom Z       larger than what fills the picture, or smaller (1)\n"
    "  --up x|y|z     which axis is up (z)\n"
    "\n"
    "  --report       say on stdout what was found and done; with --json, as JSON\n"
    "  --times        say on stderr how long each kind of work took\n"
    "  --quiet        no statistics and no progress on stderr\n"
    "  -h, --help     this text\n"
    "  --version      the version\n"
    "\n"
    "A polygon is split by a fan from its widest corner, the first of equal ones. Fields of\n"
    "points are interpolated; those of cells, groups and numbers go to all parts of a cell.\n"
    "Exit status: 0, 1 for bad input or output, 2 for bad usage.\n";

typedef struct options {
    const char *in;
    request out; /* path NULL: none */
    const smooth_rule *rule;
    int boundary, quads, report, json, quiet, times;
    n3_real crease; /* degrees */
    n3_real weld;   /* negative: by the format */
} options;

/* Options without a value. False if it is none of them. */
static int read_switch(options *o, const char *a)
{
    if (!strcmp(a, "--boundary"))
        o->boundary = 1;
    else if (!strcmp(a, "--report"))
        o->report = 1;
    else if (!strcmp(a, "--json"))
        o->report = o->json = 1;
    else if (!strcmp(a, "--quiet"))
        o->quiet = 1;
    else if (!strcmp(a, "--times"))
        o->times = 1;
    else
        return 0;
    return 1;
}

static int quads_number(const char *option, const char *value)
{
    if (strcmp(value, "brown") && strcmp(value, "split"))
        misuse("%s takes brown or split, not '%s'", option, value);
    return value[0] == 'b';
}

static int read_value(options *o, const char *a, const char *value)
{
    static const char *const known[] = {"--rule", "--crease", "--weld", "--quads"};
    size_t i, n = sizeof known / sizeof *known;
    for (i = 0; i < n && strcmp(a, known[i]); i++) continue;
    if (i == n) return 0;
    if (!value) misuse("%s takes a value", a);
    if (i == 0 && !(o->rule = smooth_rule_find(value))) misuse("there is no rule '%s'", value);
    if (i == 1) o->crease = option_number(a, value, 0, 180);
    if (i == 2) o->weld = option_number(a, value, 0, 1);
    if (i == 3) o->quads = quads_number(a, value);
    return 1;
}

static options read_options(int argc, char **argv)
{
    options o = {NULL, request_plain(), NULL, 0, 0, 0, 0, 0, 0, 50, -1};
    int i;
    o.rule = smooth_rule_find("paper");
    for (i = 1; i < argc; i++) {
        const char *a = argv[i];
        if (!strcmp(a, "-h") || !strcmp(a, "--help")) {
            fputs(usage, stdout);
            print_and_exit(help);
        }
        if (!strcmp(a, "--version")) print_and_exit("smooth " NAGATA3_VERSION "\n");
        if (read_switch(&o, a) || request_switch(&o.out, a)) continue;
        if (read_value(&o, a, argv[i + 1]) || request_value(&o.out, a, argv[i + 1]))
            i++;
        else if (a[0] == '-')
            misuse("there is no option '%s'", a);
        else if (o.in)
            misuse("one file at a time, not '%s' as well", a);
        else
            o.in = a;
    }
    if (!o.in) misuse("no file to read");
    if (!o.out.path && !o.report) misuse("no file to write; -o OUT names it");
    request_check(&o.out, o.quads);
    return o;
}

/* Formats that number their points, from 0 or from 1. */
static int numbers_points(const mesh *m)
{
    return strcmp(m->format, "OBJ") && strcmp(m->format, "STL") && strcmp(m->format, "PLY");
}

/* Numbers the points by a field "id", unless they have one. False if they have. */
static int number_points(mesh *m, int first)
{
    double *value;
    int i;
    if (mesh_field_find(m->point_field, m->point_fields, "id")) return 0;
    value = allocate((size_t)m->points, sizeof *value);
    for (i = 0; i < m->points; i++) value[i] = i + first;
    field_add(&m->point_field, &m->point_fields, "id", 2, 1, value)->kind = NUMBERS;
    return 1;
}

/* The points keep their numbers, if others of the file's cells have been left out or move up. */
static void join_points(mesh *m, n3_real weld)
{
    const int first = strcmp(m->format, "MSH") == 0, id = m->point_fields;
    int i, added = numbers_points(m) && number_points(m, first);
    const field *f = mesh_field_find(m->point_field, m->point_fields, "id");
    for (i = 0; f && i < m->points; i++)
        if (f->value[i] > m->highest) m->highest = f->value[i];
    mesh_join(m, weld);
    if (!added || m->skipped) return;
    for (i = 0; i < m->points && f->value[i] <= i + first; i++) continue;
    if (i == m->points) field_drop(m->point_field, &m->point_fields, id);
}

static void read_mesh(const options *o, mesh *m)
{
    n3_real weld;
    progress("reading", -1, 1);
    mesh_read(o->in, o->boundary, m);
    weld = strcmp(m->format, "STL") ? 0 : (n3_real)1e-6;
    progress("joining points", -1, 1);
    join_points(m, o->weld >= 0 ? o->weld : weld);
    if (!o->quiet) report_reading(o->in, m);
    if (!m->triangles) fail(o->in, 0, "all its triangles have collapsed");
}

/* What was found and done, where anybody wants to know. */
static void tell(const options *o, const mesh *m, const surface *s, const product *out)
{
    n3_report r;
    memset(&r, 0, sizeof r);
    if (!o->quiet || o->report) {
        progress("measuring", -1, 1);
        r = surface_report(s);
    }
    progress_hide();
    if (o->times) progress_times(m->triangles);
    if (!o->quiet) report_line(o->in, s, &r, out);
    if (o->report) (o->json ? report_json : report_text)(stdout, o->in, m, s, &r, out);
}

int main(int argc, char **argv)
{
    const n3_real degree = (n3_real)(3.14159265358979323846 / 180);
    options o = read_options(argc, argv);
    mesh m;
    surface s;
    product out = {NULL, NULL, 0, 0, 0, 0};
    output_catch_signals();
    if (o.quiet) progress_hide();
    read_mesh(&o, &m);
    surface_make(o.in, &m, o.rule, cos(o.crease * degree), &s);
    if (o.quads) surface_find_quads(&m, &s);
    if (o.out.path) out = product_write(&o.out, &m, &s);
    tell(&o, &m, &s, &out);
    surface_free(&s);
    mesh_free(&m);
    if (fflush(stdout) || ferror(stdout)) fail("standard output", 0, "%s", strerror(errno));
    return 0;
}
