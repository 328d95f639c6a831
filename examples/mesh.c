#include "mesh.h"

#include <limits.h>
#include <stdlib.h>

void mesh_read(const char *path, mesh *m)
{
    const int is_obj = has_extension(path, ".obj");
    char *data;
    size_t size;
    memset(m, 0, sizeof *m);
    if (!is_obj && !has_extension(path, ".stl")) fail(path, 0, "only .obj and .stl can be read");
    data = file_read(path, &size);
    if (!size) fail(path, 0, "the file is empty");
    if (is_obj)
        mesh_read_obj(path, data, size, m);
    else
        mesh_read_stl(path, data, size, m);
    free(data);
    if (!m->triangles) fail(path, 0, "there are no triangles in it");
}

void mesh_free(mesh *m)
{
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
    corner = m->corner + 3 * n;
    corner[0] = corner[1] = corner[2] = -1;
    m->triangle[3 * n] = a;
    m->triangle[3 * n + 1] = b;
    m->triangle[3 * n + 2] = c;
    m->group[n] = 0;
    m->triangles++;
}
