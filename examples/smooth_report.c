/* What was found in the mesh and what was done with it, for people and for programs. */
#include "smooth.h"

#include "mesh_number.h"

#include <math.h>
#include <string.h>

/* A row of the report: a name for programs, words for people, where a 0 is not worth a line. */
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

static int found(const mesh *m, const surface *s, const n3_report *r, row *rows)
{
    const row all[] = {
        {"skipped_cells", m->skipped, "cells of other kinds were left out"},
        {"curved_cells", m->curved, "cells have nodes besides their corners, which alone count"},
        {"lost_fields", m->lost_fields,
         "fields of no numbers, few or too large ones were left out"},
        {"polygons", m->polygons, "polygons were split into triangles"},
        {"joined_points", m->joined, "points equal another one and were joined to it"},
        {"welded_points", m->welded, "points lie within the tolerance of another and were joined"},
        {"collapsed_triangles", m->collapsed, "triangles collapsed and were left out"},
        {"unused_points", m->unused, "points are in no triangle and were left out"},
        {"flat_triangles", r->flat_triangles, "triangles have no area"},
        {"duplicate_triangles", r->duplicate_triangles, "triangles are there already"},
        {"border_edges", r->border_edges, "edges have one triangle: the surface ends there"},
        {"non_manifold_edges", r->non_manifold_edges, "edges have three triangles or more"},
        {"flipped_edges", r->flipped_edges, "edges have triangles that disagree about the outside"},
        {"degenerate_edges", r->degenerate_edges, "edges have no length"},
        {"inferred_normals", s->inferred, "corners had no normal; it was inferred"},
        {"zero_normals", r->zero_normals, "corners have no normal for all that"},
        {"flipped_normals", r->flipped_normals, "corners' normals look to the inside"}};
    memcpy(rows, all, sizeof all);
    return (int)(sizeof all / sizeof *all);
}

/* The flags tell the header's own curves: not those of the rules for comparison. */
static int done(const surface *s, const n3_report *r, row *rows)
{
    const row all[] = {
        {"crease_edges", r->crease_edges, "edges are sharp"},
        {"half_crease_edges", r->half_crease_edges, "edges are sharp at one end"},
        {"folding_patches", r->folding_patches, "patches may fold"},
        {"straight_edges", r->straight_edges, "edges stayed straight"},
        {"s_shaped_edges", r->s_shaped_edges, "edges became S-shaped"},
        {"clamped_edges", r->clamped_edges,
         "edges have an end nearer than 5.7 degrees to flat or upright"},
        {"branch_60_edges", r->branch_60_edges, "edges have an end steeper than 60 degrees"},
        {"turned_edges", r->turned_edges, "edges had a tangent turned round, to run forwards"}};
    memcpy(rows, all, sizeof all);
    return s->rule->edge ? 3 : (int)(sizeof all / sizeof *all);
}

static void print_rows(FILE *f, const row *rows, int n)
{
    int i;
    for (i = 0; i < n; i++)
        if (rows[i].value) fprintf(f, "%10d  %s\n", rows[i].value, rows[i].words);
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
    fprintf(stderr, "%s: %s: %d triangles, %d edges (%d border, %d sharp)", program, in,
            s->mesh.triangles, r->edges, r->border_edges, sharp_edges(r));
    if (out->path)
        fprintf(stderr, "; %s: %d %s triangles, %d points", out->path, out->triangles, out->kind,
                out->points);
    if (out->solids || out->sheets)
        fprintf(stderr, ", %d solids, %d sheets", out->solids, out->sheets);
    fprintf(stderr, "; at most %.4g off the facets\n", (double)r->distance);
}

void report_text(FILE *f, const char *in, const mesh *m, const surface *s, const n3_report *r,
                 const product *out)
{
    row rows[ROWS];
    fprintf(f, "%s: %d triangles, %d points, %d edges\n", in, r->triangles, r->points, r->edges);
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
    if (out->path)
        fprintf(f, "\nWritten: %s, %d %s triangles on %d points\n", out->path, out->triangles,
                out->kind, out->points);
    if (out->solids || out->sheets)
        fprintf(f, "They are %d solids and %d sheets.\n", out->solids, out->sheets);
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
            fputc(*s, f);
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
