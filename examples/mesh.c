#include "mesh.h"

#include <limits.h>
#include <stdlib.h>

void mesh_read(const char *path, int boundary, mesh *m)
{
    const int is_obj = has_extension(path, ".obj");
    char *data;
    size_t size;
    memset(m, 0, sizeof *m);
    if (!is_obj && !has_extension(path, ".stl")) fail(path, 0, "only .obj and .stl can be read");
    data = file_read(path, &size);
    if (!size) fail(path, 0, "the file is empty");
    m->format = is_obj ? "OBJ" : "STL";
    if (is_obj)
        mesh_read_obj(path, data, size, m);
    else
        mesh_read_stl(path, data, size, m);
    free(data);
    if (boundary) fail(path, 0, "there are no volume cells in it, whose boundary to take");
    if (!m->triangles) fail(path, 0, "there are no triangles in it");
}

static void free_fields(field *list, int fields)
{
    int i;
    for (i = 0; i < fields; i++) {
        free(list[i].name);
        free(list[i].value);
    }
    free(list);
}

void mesh_free(mesh *m)
{
    int i;
    free_fields(m->point_field, m->point_fields);
    free_fields(m->cell_field, m->cell_fields);
    for (i = 0; i < m->names; i++) free(m->name[i].name);
    free(m->name);
    free(m->cell);
    free(m->point);
    free(m->triangle);
    free(m->normal);
    free(m->corner);
    free(m->group);
    memset(m, 0, sizeof *m);
}

void mesh_add_triangle(mesh *m, int a, int b, int c)
{
    int n = m->triangles, *corner;
    m->triangle = room(m->triangle, n, 3 * sizeof *m->triangle);
    m->corner = room(m->corner, n, 3 * sizeof *m->corner);
    m->group = room(m->group, n, sizeof *m->group);
    m->cell = room(m->cell, n, sizeof *m->cell);
    corner = m->corner + 3 * n;
    corner[0] = corner[1] = corner[2] = -1;
    m->triangle[3 * n] = a;
    m->triangle[3 * n + 1] = b;
    m->triangle[3 * n + 2] = c;
    m->group[n] = 0;
    m->cell[n] = m->cells;
    m->triangles++;
}

field *field_add(field **list, int *fields, const char *name, size_t length, int components,
                 double *value)
{
    field *f;
    *list = room(*list, *fields, sizeof **list);
    f = &(*list)[(*fields)++];
    f->name = memcpy(allocate(length + 1, 1), name, length);
    f->components = components;
    f->whole = 0;
    f->value = value;
    return f;
}
