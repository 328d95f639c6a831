/* What was found in the mesh and what was done with it, for people and for programs. */
#include "smooth.h"

#include "mesh_number.h"

#include <math.h>
#include <string.h>

/* A row of the report: a name for programs, words for people, where a 0 is not worth a line; a * is
   the plural's s. */
typedef struct row {
    const char *name;
    int value;
    const char *words;
} row;

enum { ROWS = 24 };

static int sharp_edges(const n3_report *r) { return r->crease_edges + r->half_crease_edges; }

static int is_closed(const n3_report *r)
{
    return !r->border_edges && !r->non_manifold_edges && !r->flipped_edges;
}

/* What reading has made of the file. */
static int changed(const mesh *m, row *rows)
{
    const row all[] = {
        {"skipped_cells", m->skipped,
         m->boundary ? "cell* other than volumes left out" : "cell* other than faces left out"},
        {"curved_cells", m->curved, "curved cell*, of which the corners alone count"},
        {"lost_fields", m->lost_fields, "field* left out, of no numbers, few or too large ones"},
        {"joined_points", m->joined, "point* equal to another one, and joined to it"},
        {"welded_points", m->welded, "point* within the tolerance of another, and joined to it"},
        {"collapsed_triangles", m->collapsed, "collapsed triangle* left out"}};
    memcpy(rows, all, sizeof all);
    return (int)(sizeof all / sizeof *all);
}

static int found(const mesh *m, const surface *s, const n3_report *r, row *rows)
{
    const row all[] = {
        {"polygons", m->polygons, "polygon* split into triangles"},
        {"unused_points", m->unused, "point* in no triangle left out"},
        {"flat_triangles", r->flat_triangles, "triangle* without area"},
        {"duplicate_triangles", r->duplicate_triangles, "triangle* that another one is, too"},
        {"border_edges", r->border_edges, "edge* with one triangle: the surface ends there"},
        {"non_manifold_edges", r->non_manifold_edges, "edge* with three triangles or more"},
        {"flipped_edges", r->flipped_edges, "edge* with triangles that disagree about the outside"},
        {"degenerate_edges", r->degenerate_edges, "edge* without length"},
        {"inferred_normals", s->inferred, "corner* without normal: it was inferred"},
        {"zero_normals", r->zero_normals, "corner* without normal for all that"},
        {"flipped_normals", r->flipped_normals, "corner* whose normal looks to the inside"}};
    const int n = changed(m, rows);
    memcpy(rows + n, all, sizeof all);
    return n + (int)(sizeof all / sizeof *all);
}

/* The flags tell the header's own curves: not those of the rules for comparison. */
static int done(const surface *s, const n3_report *r, row *rows)
{
    const row all[] = {
        {"crease_edges", r->crease_edges, "sharp edge*"},
        {"half_crease_edges", r->half_crease_edges, "edge* sharp at one end"},
        {"folding_patches", r->folding_patches, "triangle* whose patch may fold"},
        {"straight_edges", r->straight_edges, "straight edge*"},
        {"s_shaped_edges", r->s_shaped_edges, "S-shaped edge*"},
        {"clamped_edges", r->clamped_edges,
         "edge* with an end nearer than 5.7 degrees to flat or upright"},
        {"branch_60_edges", r->branch_60_edges, "edge* with an end steeper than 60 degrees"},
        {"turned_edges", r->turned_edges, "edge* with a tangent turned round, to run forwards"}};
    memcpy(rows, all, sizeof all);
    return s->rule->edge ? 3 : (int)(sizeof all / sizeof *all);
}

static void put_words(FILE *f, int n, const char *words)
{
    for (; *words; words++)
        if (*words != '*' || n != 1) putc(*words == '*' ? 's' : *words, f);
}

static void put_count(FILE *f, const char *before, int n, const char *words)
{
    fprintf(f, "%s%d ", before, n);
    put_words(f, n, words);
}

static void put_product(FILE *f, const product *out)
{
    fprintf(f, "%s: %d %s ", out->path, out->triangles, out->kind);
    put_words(f, out->triangles, "triangle*");
    put_count(f, ", ", out->points, "point*");
    if (out->solids) put_count(f, ", ", out->solids, "solid*");
    if (out->sheets) put_count(f, ", ", out->sheets, "sheet*");
}

void report_reading(const char *in, const mesh *m)
{
    row rows[ROWS];
    int i, n = changed(m, rows);
    for (i = 0; i < n; i++) {
        if (!rows[i].value) continue;
        fprintf(stderr, "%s: %s: ", program, in);
        put_count(stderr, "", rows[i].value, rows[i].words);
        putc('\n', stderr);
    }
}

static void print_rows(FILE *f, const row *rows, int n)
{
    int i;
    for (i = 0; i < n; i++) {
        if (!rows[i].value) continue;
        fprintf(f, "%10d  ", rows[i].value);
        put_words(f, rows[i].value, rows[i].words);
        putc('\n', f);
    }
}

static n3_real jump_degrees(const n3_report *r)
{
    return 2 * asin(r->jump < 2 ? r->jump / 2 : 1) * (n3_real)(180 / 3.14159265358979323846);
}

static n3_vec edge_middle(const surface *s, int edge)
{
    n3_edge e = surface_edge(s, edge);
    return n3_edge_point(&e, (n3_real)1 / 2);
}

static n3_vec patch_middle(const surface *s, int triangle)
{
    n3_patch p;
    n3_mesh_patches(&s->mesh, &s->topology, s->net, triangle, triangle + 1, &p);
    return n3_patch_point(&p, (n3_real)1 / 3, (n3_real)1 / 3);
}

static void print_place(FILE *f, n3_vec x)
{
    fprintf(f, ", near (%.4g, %.4g, %.4g).\n", (double)x.x, (double)x.y, (double)x.z);
}

void report_line(const char *in, const surface *s, const n3_report *r, const product *out)
{
    fprintf(stderr, "%s: %s: ", program, in);
    put_count(stderr, "", s->mesh.triangles, "triangle*");
    put_count(stderr, ", ", r->edges, "edge*");
    fprintf(stderr, " (%d border, %d sharp); ", r->border_edges, sharp_edges(r));
    if (out->path) put_product(stderr, out);
    if (out->path) fputs("; ", stderr);
    fprintf(stderr, "at most %.4g off the facets\n", (double)r->distance);
}

void report_text(FILE *f, const char *in, const mesh *m, const surface *s, const n3_report *r,
                 const product *out)
{
    row rows[ROWS];
    fprintf(f, "%s: ", in);
    put_count(f, "", r->triangles, "triangle*");
    put_count(f, ", ", r->points, "point*");
    put_count(f, ", ", r->edges, "edge*\n");
    fprintf(f, "\nFound:\n");
    if (is_closed(r)) fprintf(f, "  The mesh is closed: every edge joins two triangles.\n");
    print_rows(f, rows, found(m, s, r, rows));
    fprintf(f, "\nMade, by the rule '%s':\n", s->rule->name);
    print_rows(f, rows, done(s, r, rows));
    if (r->distance_triangle >= 0) {
        fprintf(f, "  The surface leaves its triangles by at most %.4g", (double)r->distance);
        print_place(f, patch_middle(s, r->distance_triangle));
    }
    if (r->jump_edge >= 0) {
        fprintf(f, "  Between smooth patches it bends by at most %.4g degrees",
                (double)jump_degrees(r));
        print_place(f, edge_middle(s, r->jump_edge));
    }
    if (!out->path) return;
    fprintf(f, "\nWritten: ");
    put_product(f, out);
    fprintf(f, "\n");
}

static void json_string(FILE *f, const char *name, const char *s)
{
    fprintf(f, "  \"%s\": \"", name);
    for (; *s; s++) {
        if (*s == '"' || *s == '\\')
            fprintf(f, "\\%c", *s);
        else if ((unsigned char)*s < 32)
            fprintf(f, "\\u%04x", (unsigned)*s);
        else
            putc(*s, f);
    }
    fprintf(f, "\",\n");
}

static void json_number(FILE *f, n3_real x)
{
    char s[NUMBER_SIZE];
    number_format(s, (double)x);
    fputs(s, f);
}

static void json_rows(FILE *f, const row *rows, int n)
{
    int i;
    for (i = 0; i < n; i++) fprintf(f, "  \"%s\": %d,\n", rows[i].name, rows[i].value);
}

void report_json(FILE *f, const char *in, const mesh *m, const surface *s, const n3_report *r,
                 const product *out)
{
    const row counts[] = {
        {"triangles", r->triangles, ""}, {"points", r->points, ""}, {"edges", r->edges, ""}};
    const row written[] = {{"output_triangles", out->triangles, ""},
                           {"output_points", out->points, ""},
                           {"output_solids", out->solids, ""},
                           {"output_sheets", out->sheets, ""}};
    row rows[ROWS];
    fprintf(f, "{\n");
    json_string(f, "input", in);
    json_rows(f, counts, 3);
    json_rows(f, rows, found(m, s, r, rows));
    json_string(f, "rule", s->rule->name);
    json_rows(f, rows, done(s, r, rows));
    if (out->path) {
        json_string(f, "output", out->path);
        json_rows(f, written, 4);
    }
    fprintf(f, "  \"closed\": %s,\n", is_closed(r) ? "true" : "false");
    fprintf(f, "  \"distance\": ");
    json_number(f, r->distance);
    fprintf(f, ",\n  \"jump_degrees\": ");
    json_number(f, jump_degrees(r));
    fprintf(f, "\n}\n");
}
