/* smooth: a triangle mesh into a smooth surface, or into a finer mesh on it. */
#include "smooth.h"

#include <errno.h>
#include <float.h>
#include <stdarg.h>
#include <stdlib.h>

const char program[] = "smooth";

static const char usage[] =
    "usage: smooth IN -o OUT [-n LEVEL] [--rule paper|arc|fit|nagata|pn|flat]\n"
    "              [--boundary] [--bezier] [--crease DEG] [--weld REL] [--report] [--json]\n"
    "              [--quiet]\n";

static const char help[] =
    "Lays a smooth surface through the points of a mesh of triangles, tangent to its normals.\n"
    "\n"
    "  IN             OBJ, STL, PLY, VTU, legacy VTK or Gmsh MSH, told by what is in it, not\n"
    "                 by its name. Without normals in it they are estimated.\n"
    "  -o OUT         .obj or .stl: flat triangles again, finer; .vtu: the surface itself, in\n"
    "                 cubic triangles. Not needed with --report.\n"
    "  --boundary     of a mesh of volumes: the faces that one volume cell has\n"
    "  -n LEVEL       parts per edge in .obj and .stl, 1 to 1000 (4)\n"
    "  --rule RULE    paper: cubic Nagata patches (this is the default)\n"
    "                 arc: the same with edges that are circular arcs where they can be\n"
    "                 fit: arc, and the bend across edges fitted to the triangles around\n"
    "                 nagata: quadratic Nagata patches; pn: PN triangles; flat: the facets\n"
    "  --bezier       .vtu with control points (cell type 76), not nodes on the surface (69)\n"
    "  --crease DEG   an edge is sharp where its faces meet at more than this angle (50). Normals\n"
    "                 in the file overrule it, OBJ smoothing groups add to it.\n"
    "  --weld REL     join points closer than this part of the bounding box's diagonal. Equal\n"
    "                 points are always joined. (STL: 1e-6, others: 0)\n"
    "  --report       say on stdout what was found and done; with --json, as JSON\n"
    "  --quiet        no statistics on stderr\n"
    "  -h, --help     this text\n"
    "  --version      the version\n"
    "\n"
    "A polygon is split by a fan from its widest corner, the first of equal ones.\n"
    "Exit status: 0, 1 for bad input or output, 2 for bad usage.\n";

typedef struct options {
    const char *in, *out;
    const smooth_rule *rule;
    int level, boundary, bezier, report, json, quiet;
    n3_real crease; /* degrees */
    n3_real weld;   /* negative: by the format */
} options;

static void misuse(const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "%s: ", program);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fprintf(stderr, "\n%s", usage);
    exit(2);
}

/* The argument of an option as a number from lo to hi. */
static n3_real number(const char *option, const char *value, double lo, double hi)
{
    char *end;
    double x = strtod(value, &end);
    if (end == value || *end || !(x >= lo && x <= hi))
        misuse("%s takes a number from %g to %g, not '%s'", option, lo, hi, value);
    return (n3_real)x;
}

static int whole_number(const char *option, const char *value, int lo, int hi)
{
    n3_real x = number(option, value, lo, hi);
    if (x > floor(x)) misuse("%s takes a whole number, not '%s'", option, value);
    return (int)x;
}

static void print_and_exit(const char *text)
{
    fputs(text, stdout);
    exit(fflush(stdout) || ferror(stdout) ? EXIT_FAILURE : EXIT_SUCCESS);
}

/* Options without a value. False if it is none of them. */
static int read_switch(options *o, const char *a)
{
    if (!strcmp(a, "--boundary"))
        o->boundary = 1;
    else if (!strcmp(a, "--bezier"))
        o->bezier = 1;
    else if (!strcmp(a, "--report"))
        o->report = 1;
    else if (!strcmp(a, "--json"))
        o->report = o->json = 1;
    else if (!strcmp(a, "--quiet"))
        o->quiet = 1;
    else
        return 0;
    return 1;
}

static int read_value(options *o, const char *a, const char *value)
{
    static const char *const known[] = {"-o", "-n", "--rule", "--crease", "--weld"};
    size_t i, n = sizeof known / sizeof *known;
    for (i = 0; i < n && strcmp(a, known[i]); i++) continue;
    if (i == n) return 0;
    if (!value) misuse("%s takes a value", a);
    if (i == 0) o->out = value;
    if (i == 1) o->level = whole_number(a, value, 1, 1000);
    if (i == 2 && !(o->rule = smooth_rule_find(value))) misuse("there is no rule '%s'", value);
    if (i == 3) o->crease = number(a, value, 0, 180);
    if (i == 4) o->weld = number(a, value, 0, 1);
    return 1;
}

static options read_options(int argc, char **argv)
{
    options o = {NULL, NULL, NULL, 4, 0, 0, 0, 0, 0, 50, -1};
    int i;
    o.rule = smooth_rule_find("paper");
    for (i = 1; i < argc; i++) {
        const char *a = argv[i];
        if (!strcmp(a, "-h") || !strcmp(a, "--help")) {
            fputs(usage, stdout);
            print_and_exit(help);
        }
        if (!strcmp(a, "--version")) print_and_exit("smooth " NAGATA3_VERSION "\n");
        if (read_switch(&o, a)) continue;
        if (read_value(&o, a, argv[i + 1]))
            i++;
        else if (a[0] == '-')
            misuse("there is no option '%s'", a);
        else if (o.in)
            misuse("one file at a time, not '%s' as well", a);
        else
            o.in = a;
    }
    if (!o.in) misuse("no file to read");
    if (!o.out && !o.report) misuse("no file to write; -o OUT names it");
    if (o.out && !has_extension(o.out, ".obj") && !has_extension(o.out, ".stl") &&
        !has_extension(o.out, ".vtu"))
        misuse("'%s' is neither .obj nor .stl nor .vtu", o.out);
    if (o.bezier && !(o.out && has_extension(o.out, ".vtu"))) misuse("--bezier needs a .vtu");
    return o;
}

/* STL holds single precision. */
static void check_range(const char *path, const mesh *m)
{
    const n3_real most = (n3_real)FLT_MAX;
    int i;
    for (i = 0; i < m->points; i++) {
        n3_vec x = m->point[i];
        if (fabs(x.x) > most || fabs(x.y) > most || fabs(x.z) > most)
            fail(path, 0, "a coordinate is too large for STL, beyond %g", (double)most);
    }
}

static product write_flat(const options *o, const surface *s)
{
    product out = {NULL, "flat", 0, 0};
    mesh m;
    surface_refine(o->in, s, o->level, &m);
    out.triangles = m.triangles;
    out.points = m.points;
    if (has_extension(o->out, ".obj")) {
        mesh_write_obj(output_open(o->out), &m);
    } else {
        check_range(o->out, &m);
        mesh_write_stl(output_open(o->out), &m);
    }
    output_close();
    mesh_free(&m);
    return out;
}

static product write_output(const options *o, const surface *s)
{
    product out = {NULL, "cubic", 0, 0};
    if (!o->out) return out;
    if (has_extension(o->out, ".vtu")) {
        surface_write_vtu(output_open(o->out), s, o->bezier);
        output_close();
        out.triangles = s->mesh.triangles;
        out.points = s->nodes;
    } else {
        out = write_flat(o, s);
    }
    out.path = o->out;
    return out;
}

/* What was done to the mesh before anything else; never in silence, unless asked. */
static void report_reading(const char *path, const mesh *m)
{
    if (m->skipped)
        fprintf(stderr, "%s: %s: left out %d cells that are no %s\n", program, path, m->skipped,
                m->boundary ? "volumes" : "faces");
    if (m->curved)
        fprintf(stderr, "%s: %s: took the corners alone of %d curved cells\n", program, path,
                m->curved);
    if (m->lost_fields)
        fprintf(stderr, "%s: %s: left out %d fields of no numbers, few or too large ones\n",
                program, path, m->lost_fields);
    if (!m->joined && !m->welded && !m->collapsed) return;
    fprintf(stderr, "%s: %s: joined %d equal points", program, path, m->joined);
    if (m->reach > 0) fprintf(stderr, " and %d within %.3g", m->welded, (double)m->reach);
    fprintf(stderr, "; left out %d collapsed triangles\n", m->collapsed);
}

static void read_mesh(const options *o, mesh *m)
{
    n3_real weld;
    mesh_read(o->in, o->boundary, m);
    weld = strcmp(m->format, "STL") ? 0 : (n3_real)1e-6;
    mesh_join(m, o->weld >= 0 ? o->weld : weld);
    if (!o->quiet) report_reading(o->in, m);
    if (!m->triangles) fail(o->in, 0, "all its triangles have collapsed");
}

int main(int argc, char **argv)
{
    const n3_real degree = (n3_real)(3.14159265358979323846 / 180);
    options o = read_options(argc, argv);
    mesh m;
    surface s;
    n3_report r;
    product out;
    read_mesh(&o, &m);
    surface_make(o.in, &m, o.rule, cos(o.crease * degree), &s);
    out = write_output(&o, &s);
    r = n3_mesh_report(&s.mesh, &s.topology, s.net, s.flags);
    if (!o.quiet) report_line(o.in, &s, &r, &out);
    if (o.report) (o.json ? report_json : report_text)(o.in, &m, &s, &r, &out);
    surface_free(&s);
    mesh_free(&m);
    if (fflush(stdout) || ferror(stdout)) fail("standard output", 0, "%s", strerror(errno));
    return 0;
}
