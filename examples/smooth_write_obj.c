/* OBJ, which has the patches' own normals at their corners, and binary STL. */
#include "smooth_grid.h"

#include <float.h>

void grid_write_obj(output *o, const grid *g)
{
    int i;
    for (i = 0; i < g->nodes; i++) {
        if (i % 4096 == 0) progress("writing", i, g->nodes);
        put_text(o, "v ");
        put_vec(o, g->node[i]);
        put_text(o, "\n");
    }
    for (i = 0; i < g->normals; i++) {
        if (i % 4096 == 0) progress("writing", i, g->normals);
        put_text(o, "vn ");
        put_vec(o, g->normal[i]);
        put_text(o, "\n");
    }
    for (i = 0; i < 3 * g->elements; i++) {
        if (i % 4096 == 0) progress("writing", i, 3.0 * g->elements);
        put_text(o, i % 3 ? " " : "f ");
        put_number(o, g->element[i] + 1.0);
        put_text(o, "//");
        put_number(o, g->corner[i] + 1.0);
        if (i % 3 == 2) put_text(o, "\n");
    }
}

static void put_float(output *o, n3_vec a)
{
    put_value(o, FLOAT32, (double)a.x);
    put_value(o, FLOAT32, (double)a.y);
    put_value(o, FLOAT32, (double)a.z);
}

static void put_facet_point(output *o, n3_vec x)
{
    if (!(n3_len(x) <= (n3_real)FLT_MAX))
        fail(output_path(o), 0, "a coordinate is too large for STL, beyond %g", (double)FLT_MAX);
    put_float(o, x);
}

/* The header must not begin with "solid", by which many readers tell an ASCII file. */
void grid_write_stl(output *o, const grid *g)
{
    const char header[80] = "binary STL";
    int t, i;
    put_bytes(o, header, sizeof header);
    put_value(o, INT32, g->elements);
    for (t = 0; t < g->elements; t++) {
        n3_vec x[3];
        if (t % 4096 == 0) progress("writing", t, g->elements);
        for (i = 0; i < 3; i++) x[i] = g->node[g->element[3 * t + i]];
        put_float(o, n3_unit(n3_cross(n3_sub(x[1], x[0]), n3_sub(x[2], x[0]))));
        for (i = 0; i < 3; i++) put_facet_point(o, x[i]);
        put_value(o, UINT8, 0);
        put_value(o, UINT8, 0);
    }
}
