/* mesh_cells.h: the cells of a file, of any kind, before they become triangles. */
#ifndef MESH_CELLS_H
#define MESH_CELLS_H

#include "mesh_text.h"

/* Kinds of cells by VTK's numbers; most have further ones for cells with nodes between corners. */
enum { VERTEX = 1, LINES = 4, TRIANGLE = 5, STRIP = 6, POLYGON = 7, QUAD = 9, TETRA = 10 };

typedef struct cells {
    int count, corners;
    unsigned char *kind;
    int *end;   /* where the points of each cell end and those of the next begin */
    int *point; /* corners first */
} cells;

void cells_add_point(cells *c, int point);

/* The points that were added since the last cell are one of this kind; or the end of the program,
   if they are too few or too many for it. */
void cells_add(cells *c, const text *t, int kind);

/* Adds the second ones behind the first, and frees them. */
void cells_append(cells *c, cells *more);

/* The mesh's triangles: the faces among the cells or, with m->boundary, those that one volume
   has, looking outwards. The mesh's points are there, its cell fields have a row for each cell;
   those of cells without triangles are left out. Normals are those of the points. The cells are
   freed. */
void cells_take(const char *path, cells *c, mesh *m);

/* For cells_take(). The kind of the cell of corners alone, 0 for an unknown one; true if there are
   other points than corners; the points of the cell i, of which there are *n. */
int cells_base(int kind);
int cells_curved(int kind, int n);
const int *cells_points(const cells *c, int i, int *n);
void cells_take_boundary(const char *path, const cells *c, mesh *m);

#endif
