/* mesh.h: a mesh of triangles in memory, and the files that it comes from.
 *
 * What goes wrong ends the program: fail() prints "program: file:line: reason" and exits with 1. */
#ifndef MESH_H
#define MESH_H

#include "nagata3.h"

#include <stdio.h>

/* Values that can be anything between two of them; numbers of things, whole ones that have no mean;
   bytes of colours, whose mean is rounded. */
enum { VALUES, NUMBERS, COLOUR_BYTES };

/* Values of each point or of each cell, row by row. NaN: the file has none there. */
typedef struct field {
    char *name;
    int components;
    int kind;
    double *value;
} field;

/* What the file calls the group with a number, of cells of a dimension from 0 to 3. */
typedef struct group_name {
    int dimension, number;
    char *name;
} group_name;

typedef struct mesh {
    int points, triangles, normals;
    n3_vec *point;
    int *triangle;  /* three points each */
    n3_vec *normal; /* as in the file, of any length */
    int *corner;    /* three normals each, negative where there is none */
    int *group;     /* of each triangle, the smoothing group; 0: none */
    int grouped;    /* some group is not 0 */
    int cells;      /* of the file, that triangles come from */
    int *cell;      /* of each triangle */
    int point_fields, cell_fields, names;
    field *point_field, *cell_field;
    group_name *name;
    const char *format; /* what the file is */
    int boundary;       /* the triangles are the boundary of volume cells */
    int polygons;       /* with more than three corners, split */
    int skipped;        /* cells left out: they are no faces */
    int curved;      /* cells with nodes between their corners, of which the corners were taken */
    int lost_fields; /* left out */
    int joined;      /* points that equal another one */
    int welded;      /* points that lie within the tolerance of another one */
    int collapsed;   /* triangles left out: two of their corners are one point */
    int unused;      /* points left out: in no triangle */
    double highest;  /* number, in the field "id", of a point of the file */
    n3_real reach;   /* the tolerance, a length */
} mesh;

/* How numbers stand in a file: as text, or as bytes, the least or the greatest one first. */
enum { AS_TEXT, LITTLE, BIG };

/* Defined by each program: its name, which begins its messages. */
extern const char program[];

/* line 0: the reason stands for the whole file. Does not return. */
void fail(const char *file, long line, const char *format, ...);

/* Memory, or the end of the program. room() returns the array with place for one more element; it
   moves when count is a power of two. No array has more than INT_MAX / 3 elements. */
void *allocate(size_t count, size_t size);
void *room(void *array, int count, size_t size);

/* A whole file with a zero byte behind it. */
char *file_read(const char *path, size_t *size);

/* True if the name ends in the extension, such as ".obj", in any case. */
int has_extension(const char *path, const char *extension);

/* OBJ: points, normals, faces of any number of corners, smoothing groups.
   STL: ASCII or binary; three points of its own for each triangle.
   PLY: ASCII or binary; vertices with what they have, faces with their polygons.
   VTU, VTK (legacy: POLYDATA, UNSTRUCTURED_GRID), MSH (Gmsh 2 and 4.1): cells of all kinds.
   What the file is is told by what is in it. With boundary the triangles are the faces that one
   volume cell has, looking outwards, and no others.
   The readers check every count against what is left of the file before they take memory. */
void mesh_read(const char *path, int boundary, mesh *m);
void mesh_read_obj(const char *path, const char *data, size_t size, mesh *m);
void mesh_read_stl(const char *path, const char *data, size_t size, mesh *m);
void mesh_read_ply(const char *path, const char *data, size_t size, mesh *m);
void mesh_read_vtu(const char *path, const char *data, size_t size, mesh *m);
void mesh_read_vtk(const char *path, const char *data, size_t size, mesh *m);
void mesh_read_msh(const char *path, const char *data, size_t size, mesh *m);
int mesh_is_stl(const char *data, size_t size);
int mesh_is_binary_stl(const char *data, size_t size);
void mesh_free(mesh *m);

/* Adds a triangle, its corners without normals, in group 0, of the cell with the number m->cells:
   who has added all of a cell's triangles counts it. */
void mesh_add_triangle(mesh *m, int a, int b, int c);

/* Adds a polygon of three corners or more as triangles, in the same way; with the normals of its
   corners, or NULL. A fan from the widest corner, the first of equal ones, splits it. */
void mesh_add_polygon(mesh *m, int n, const int *point, const int *normal);

/* Adds a field of VALUES to the list. The name is copied up to length characters; the values, from
   allocate(), become the field's. */
field *field_add(field **list, int *fields, const char *name, size_t length, int components,
                 double *value);

/* Takes the field i out of the list. */
void field_drop(field *list, int *fields, int i);

/* The row from becomes the row to. */
void field_move_row(const field *f, int from, int to);

/* The box from lo to hi grows until x is in it. */
void box_add(n3_vec *lo, n3_vec *hi, n3_vec x);

/* kept[i] becomes the first point that equals the point i. Returns how many are not their own. */
int mesh_find_equal(const mesh *m, int *kept);

/* Joins points: equal ones, then those within relative times the diagonal of the bounding box to
   the nearest point that is kept, in the order of the file. Then leaves out the triangles that
   have collapsed and the points in no triangle. */
void mesh_join(mesh *m, n3_real relative);

#endif
