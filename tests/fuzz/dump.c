/* dump [--boundary] FILE: what the readers make of a file, as text. */
#include "mesh.h"

#include <math.h>
#include <string.h>

const char program[] = "dump";

static void print_number(double x) { printf(isnan(x) ? " nan" : " %.17g", x); }

static void print_fields(const char *what, const field *list, int fields, int rows)
{
    static const char *const kinds[] = {"real", "whole", "colours"};
    int i, j;
    for (i = 0; i < fields; i++) {
        printf("%s field '%s' %d %s:", what, list[i].name, list[i].components,
               kinds[list[i].kind]);
        for (j = 0; j < rows * list[i].components; j++) print_number(list[i].value[j]);
        printf("\n");
    }
}

static void print_vec(n3_vec a)
{
    printf(" (%.17g %.17g %.17g)", (double)a.x, (double)a.y, (double)a.z);
}

static void print_mesh(const mesh *m)
{
    int i, j;
    printf("%d cells, %d polygons, %d skipped, %d curved, %d lost\npoints", m->cells, m->polygons,
           m->skipped, m->curved, m->lost_fields);
    for (i = 0; i < m->points; i++) print_vec(m->point[i]);
    for (i = 0; i < m->triangles; i++) {
        const int *p = m->triangle + 3 * i;
        printf("\n%d %d %d of %d", p[0], p[1], p[2], m->cell[i]);
        for (j = 0; j < 3; j++)
            if (m->corner[3 * i + j] >= 0) print_vec(m->normal[m->corner[3 * i + j]]);
    }
    printf("\n");
    for (i = 0; i < m->names; i++)
        printf("name '%s' of %d, dimension %d\n", m->name[i].name, m->name[i].number,
               m->name[i].dimension);
    print_fields("point", m->point_field, m->point_fields, m->points);
    print_fields("cell", m->cell_field, m->cell_fields, m->cells);
}

int main(int argc, char **argv)
{
    const int boundary = argc > 2 && !strcmp(argv[1], "--boundary");
    mesh m;
    if (argc != 2 + boundary) return 2;
    mesh_read(argv[1 + boundary], boundary, &m);
    print_mesh(&m);
    mesh_free(&m);
    return fflush(stdout) || ferror(stdout);
}
