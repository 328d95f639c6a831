/* smooth_grid.h: what goes into a file: elements on shared nodes, and what is known of them. */
#ifndef SMOOTH_GRID_H
#define SMOOTH_GRID_H

#include "mesh_output.h"
#include "smooth.h"

/* What a file can take of a grid, and what otherwise need not be made. */
enum { WITH_CORNER_NORMALS = 1, WITH_NODE_NORMALS = 2, WITH_FIELDS = 4 };

/* The nodes are first the points of the mesh, under their numbers, then those on the edges, then
   those inside the triangles. */
typedef struct grid {
    const mesh *mesh;
    const surface *surface;
    int kind, corners; /* of an element: 3, 6 or 10 */
    int nodes, elements, normals;
    n3_vec *node;
    int *element;        /* corners of each */
    int *origin;         /* of each, the triangle that it comes from */
    int *first;          /* [edges + 1] of each edge, the first node; then the first one inside */
    n3_vec *normal;      /* of facets: at points of the mesh its own, else those of the patches */
    int *corner;         /* three of each */
    n3_vec *node_normal; /* their mean at a node */
    int *parent;         /* of each node, a triangle that has it, and its place there */
    n3_real *uv;
    field *point_field; /* those of the mesh, a row for each node */
    int *cell;          /* of each element, the row in the fields of cells */
} grid;

/* Facets with so many parts for each edge, or within a distance; elements of the other kinds. */
void grid_refine(const mesh *m, const surface *s, int level, unsigned with, grid *g);
void grid_adapt(const mesh *m, const surface *s, n3_real distance, unsigned with, grid *g);
void grid_curve(const mesh *m, const surface *s, int kind, unsigned with, grid *g);
void grid_free(grid *g);

/* Nodes and normals of facets onto Brown's squares, where the surface has some; so many parts for
   each edge. */
void grid_lay_squares(grid *g, int level);

/* The mean of the normals at the corners of the facets, for each of count things that they are of;
   where these are one, to the bit. From allocate(). */
n3_vec *grid_mean_normals(const grid *g, const int *of, int count);

/* Numbers in rows: real, whole, or first, first + step, ...; with a map, the row of that number. */
typedef struct array {
    const char *name;
    int components, type, rows;
    const double *real;
    const int *whole, *map;
    double first, step;
} array;

double array_value(const array *a, int row, int component);

/* The rows one after the other; in text a line for each. */
void put_array(output *o, const array *a);

/* What the grid has in a row for each node, without its place but with its normal, or for each
   element, without its nodes; an array that ends with a name of NULL. */
array *grid_node_arrays(const grid *g);
array *grid_element_arrays(const grid *g);
array grid_places(const grid *g);

/* The field of cells or of points of that name, NULL if there is none. */
const field *mesh_field_find(const field *list, int fields, const char *name);

/* The whole grid, in the format of the name. */
void grid_write_obj(output *o, const grid *g);
void grid_write_stl(output *o, const grid *g);
void grid_write_ply(output *o, const grid *g);
void grid_write_vtu(output *o, const grid *g);
void grid_write_vtk(output *o, const grid *g);
void grid_write_msh(output *o, const grid *g);

/* STEP: the surface itself, as so many solids and sheets. */
typedef struct bodies {
    int solids, sheets;
} bodies;
bodies surface_write_step(output *o, const char *path, const surface *s);

#endif
