#include "mesh_binary.h"

#include <ctype.h>
#include <limits.h>
#include <stdlib.h>

/* Behind blanks and empty lines. */
static int begins(const char *data, size_t size, const char *word)
{
    size_t n = strlen(word);
    text t = text_open("", data, size);
    while (t.at < t.end && isspace((unsigned char)*t.at)) t.at++;
    return text_left(&t) >= n && memcmp(t.at, word, n) == 0;
}

static int is_ply(const char *data, size_t size)
{
    text t = text_open("", data, size);
    return token_is(text_word(&t), "ply");
}

static int is_vtu(const char *data, size_t size) { return begins(data, size, "<"); }

static int is_vtk(const char *data, size_t size) { return begins(data, size, "# vtk DataFile"); }

static int is_msh(const char *data, size_t size) { return begins(data, size, "$"); }

typedef struct format {
    const char *name;
    int (*is)(const char *data, size_t size);
    void (*read)(const char *path, const char *data, size_t size, mesh *m);
    int volumes; /* there may be some */
} format;

/* Binary STL by its size, whatever it begins with; others by their first words; what is left is
   OBJ. */
static const format *find_format(const char *data, size_t size)
{
    static const format formats[] = {{"STL", mesh_is_binary_stl, mesh_read_stl, 0},
                                     {"PLY", is_ply, mesh_read_ply, 0},
                                     {"VTU", is_vtu, mesh_read_vtu, 1},
                                     {"VTK", is_vtk, mesh_read_vtk, 1},
                                     {"MSH", is_msh, mesh_read_msh, 1},
                                     {"STL", mesh_is_stl, mesh_read_stl, 0},
                                     {"OBJ", NULL, mesh_read_obj, 0}};
    const format *f = formats;
    while (f->is && !f->is(data, size)) f++;
    return f;
}

static void check_result(const char *path, const format *f, const mesh *m)
{
    if (m->triangles) return;
    if (m->skipped)
        fail(path, 0, "there are no faces in it, %d other cells; --boundary takes that of volumes",
             m->skipped);
    if (!m->points && !f->is) fail(path, 0, "it is none of OBJ, STL, PLY, VTU, VTK and MSH");
    fail(path, 0, "there are no triangles in it");
}

void mesh_read(const char *path, int boundary, mesh *m)
{
    const format *f;
    char *data;
    size_t size;
    memset(m, 0, sizeof *m);
    data = file_read(path, &size);
    if (!size) fail(path, 0, "the file is empty");
    f = find_format(data, size);
    if (boundary && !f->volumes) fail(path, 0, "%s has no volume cells", f->name);
    m->format = f->name;
    m->boundary = boundary;
    f->read(path, data, size, m);
    free(data);
    check_result(path, f, m);
}

void box_add(n3_vec *lo, n3_vec *hi, n3_vec x)
{
    *lo = n3_v(x.x < lo->x ? x.x : lo->x, x.y < lo->y ? x.y : lo->y, x.z < lo->z ? x.z : lo->z);
    *hi = n3_v(x.x > hi->x ? x.x : hi->x, x.y > hi->y ? x.y : hi->y, x.z > hi->z ? x.z : hi->z);
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
    f->kind = VALUES;
    f->value = value;
    return f;
}

void field_drop(field *list, int *fields, int i)
{
    free(list[i].name);
    free(list[i].value);
    memmove(list + i, list + i + 1, (size_t)(--*fields - i) * sizeof *list);
}

void field_move_row(const field *f, int from, int to)
{
    size_t k = (size_t)f->components;
    memmove(f->value + k * (size_t)to, f->value + k * (size_t)from, k * sizeof *f->value);
}
