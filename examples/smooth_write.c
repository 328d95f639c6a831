/* What kind of file, and what goes into it. */
#include "smooth_grid.h"
#include "smooth_picture.h"

#include <float.h>
#include <stdlib.h>

/* Up to so many elements a file is text that people can read, unless they want it otherwise or it
   has numbers that programs cannot read. */
enum { READABLE = 10000 };

enum { TEXT = 1, BYTES = 2 }; /* what a format knows */

typedef struct format {
    const char *extension;
    int kinds; /* the highest that it can hold */
    int coding, order;
    unsigned with;
    void (*write)(output *o, const grid *g);
    product (*whole)(const request *r, const mesh *m, const surface *s); /* else this */
} format;

static product write_step(const request *r, const mesh *m, const surface *s)
{
    product out = {NULL, "cubic", 0, 0, 0, 0};
    output *o = output_open(r->path, AS_TEXT);
    bodies made = surface_write_step(o, r->path, s);
    output_close(o);
    (void)m;
    out.triangles = s->mesh.triangles;
    out.points = s->mesh.points;
    out.solids = made.solids;
    out.sheets = made.sheets;
    return out;
}

static const format formats[] = {
    {".obj", FACETS, TEXT, LITTLE, WITH_CORNER_NORMALS, grid_write_obj, NULL},
    {".stl", FACETS, BYTES, LITTLE, 0, grid_write_stl, NULL},
    {".ply", FACETS, TEXT | BYTES, LITTLE, WITH_CORNER_NORMALS | WITH_FIELDS, grid_write_ply, NULL},
    {".vtu", BEZIER, TEXT | BYTES, LITTLE, WITH_NODE_NORMALS | WITH_FIELDS, grid_write_vtu, NULL},
    {".vtk", BEZIER, TEXT | BYTES, BIG, WITH_NODE_NORMALS | WITH_FIELDS, grid_write_vtk, NULL},
    {".msh", CUBIC, TEXT | BYTES, LITTLE, WITH_FIELDS, grid_write_msh, NULL},
    {".step", BEZIER, TEXT, LITTLE, 0, NULL, write_step},
    {".stp", BEZIER, TEXT, LITTLE, 0, NULL, write_step},
    {".png", BEZIER, BYTES, LITTLE, 0, NULL, write_picture},
    {".html", BEZIER, TEXT, LITTLE, 0, NULL, write_page}};

/* NULL for none. */
static const format *find_format(const char *path)
{
    size_t i;
    for (i = 0; i < sizeof formats / sizeof *formats; i++)
        if (has_extension(path, formats[i].extension)) return &formats[i];
    return NULL;
}

static int is_picture(const format *f) { return f->whole && f->whole != write_step; }

const char *product_refuse(const request *r)
{
    const format *f = find_format(r->path);
    if (!f) return "is none of .obj .stl .ply .vtu .vtk .msh .step .png .html";
    if (r->drawn && !is_picture(f)) return "is no picture";
    if (!f->write && (r->level || r->kind || r->tolerance > 0))
        return "holds the surface itself, not facets or elements";
    if (r->kind > f->kinds)
        return f->kinds == FACETS ? "holds facets only" : "has no such elements";
    if (r->text >= 0 && !(f->coding & (r->text ? TEXT : BYTES)))
        return r->text ? "is always binary" : "is always text";
    return NULL;
}

int product_is_exact(const request *r)
{
    const format *f = find_format(r->path);
    return f && f->whole && f->whole != write_picture;
}

/* A node on a sharp edge has no one normal; and a field may have the name. */
static unsigned wanted(const format *f, const mesh *m, const surface *s)
{
    if (surface_edges_with(s, N3_EDGE_CREASE | N3_EDGE_HALF_CREASE) ||
        mesh_field_find(m->point_field, m->point_fields, "Normals"))
        return f->with & ~(unsigned)WITH_NODE_NORMALS;
    return f->with;
}

static void make_grid(const request *r, const format *f, const mesh *m, const surface *s, grid *g)
{
    const unsigned with = wanted(f, m, s);
    n3_real unit = r->relative ? surface_size(s) : 1;
    int kind = r->kind ? r->kind : f->kinds > FACETS ? CUBIC : FACETS;
    progress("refining", -1, 1);
    if (r->tolerance > 0 && s->squares)
        grid_refine(m, s, surface_level(s, r->tolerance * unit), with, g);
    else if (r->tolerance > 0)
        grid_adapt(m, s, r->tolerance * unit, with, g);
    else if (r->level || kind == FACETS)
        grid_refine(m, s, r->level ? r->level : 4, with, g);
    else
        grid_curve(m, s, kind, with, g);
}

/* VTK for one stops at a NaN in a text. */
static int are_finite(const field *list, int fields, int rows)
{
    int i, k;
    for (i = 0; i < fields; i++)
        for (k = 0; k < rows * list[i].components; k++)
            if (!(fabs(list[i].value[k]) <= DBL_MAX)) return 0;
    return 1;
}

static int is_readable(const request *r, const format *f, const mesh *m, const grid *g)
{
    if (f->coding != (TEXT | BYTES)) return f->coding == TEXT;
    if (r->text >= 0) return r->text;
    return g->elements <= READABLE && are_finite(m->point_field, m->point_fields, m->points) &&
           are_finite(m->cell_field, m->cell_fields, m->cells);
}

static product write_grid(const request *r, const format *f, const mesh *m, const surface *s)
{
    static const char *const kinds[] = {"flat", "quadratic", "cubic", "cubic"};
    product out = {NULL, NULL, 0, 0, 0, 0};
    grid g;
    output *o;
    make_grid(r, f, m, s, &g);
    o = output_open(r->path, is_readable(r, f, m, &g) ? AS_TEXT : f->order);
    f->write(o, &g);
    output_close(o);
    out.kind = kinds[g.kind];
    out.triangles = g.elements;
    out.points = g.nodes;
    grid_free(&g);
    return out;
}

product product_write(const request *r, const mesh *m, const surface *s)
{
    const format *f = find_format(r->path);
    product out = f->write ? write_grid(r, f, m, s) : f->whole(r, m, s);
    out.path = r->path;
    return out;
}
