/* OBJ and binary STL. */
#include "mesh.h"

#include <stdint.h>
#include <stdlib.h>

void write_number(FILE *f, n3_real x)
{
    char s[40];
    int digits;
    for (digits = 15; digits <= 17; digits++) {
        double back;
        snprintf(s, sizeof s, "%.*g", digits, (double)x);
        back = strtod(s, NULL);
        if (back <= (double)x && back >= (double)x) break;
    }
    fputs(s, f);
}

void write_vec(FILE *f, n3_vec a)
{
    write_number(f, a.x);
    fputc(' ', f);
    write_number(f, a.y);
    fputc(' ', f);
    write_number(f, a.z);
    fputc('\n', f);
}

void mesh_write_obj(FILE *f, const mesh *m)
{
    int i;
    for (i = 0; i < m->points; i++) {
        fputs("v ", f);
        write_vec(f, m->point[i]);
    }
    for (i = 0; i < m->normals; i++) {
        fputs("vn ", f);
        write_vec(f, m->normal[i]);
    }
    for (i = 0; i < 3 * m->triangles; i++)
        fprintf(f, "%s%d//%d%s", i % 3 ? " " : "f ", m->triangle[i] + 1, m->corner[i] + 1,
                i % 3 == 2 ? "\n" : "");
}

static char *put_count(char *to, uint32_t bits)
{
    int i;
    for (i = 0; i < 4; i++) *to++ = (char)(bits >> 8 * i & 255);
    return to;
}

static char *put_vec(char *to, n3_vec a)
{
    float x[3];
    int i;
    x[0] = (float)a.x, x[1] = (float)a.y, x[2] = (float)a.z;
    for (i = 0; i < 3; i++) {
        uint32_t bits;
        memcpy(&bits, &x[i], sizeof bits);
        to = put_count(to, bits);
    }
    return to;
}

/* The header must not begin with "solid", by which many readers tell an ASCII file. */
void mesh_write_stl(FILE *f, const mesh *m)
{
    char header[84] = "binary STL", facet[50];
    int t, i;
    put_count(header + 80, (uint32_t)m->triangles);
    fwrite(header, 1, sizeof header, f);
    for (t = 0; t < m->triangles; t++) {
        char *to = facet;
        n3_vec x[3];
        for (i = 0; i < 3; i++) x[i] = m->point[m->triangle[3 * t + i]];
        to = put_vec(to, n3_unit(n3_cross(n3_sub(x[1], x[0]), n3_sub(x[2], x[0]))));
        for (i = 0; i < 3; i++) to = put_vec(to, x[i]);
        to[0] = to[1] = 0;
        fwrite(facet, 1, sizeof facet, f);
    }
}
