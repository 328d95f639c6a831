/* lattice.h: lattices of points with their parameters of shape, from files. */
#ifndef LATTICE_H
#define LATTICE_H

#include "../smooth.h"
#include "brown.h"

typedef struct lattice {
    brown_lattice view; /* of the arrays below */
    n3_vec *point;
    brown_shape *shape[2]; /* of the curves CU and CV */
    n3_edge *curve[2];     /* NULL, or own curves for all parts */
} lattice;

/* A file is text; # begins a comment, a backslash at its end continues a line. Its lines:

       lattice COLUMNS ROWS              first; points along u, points along v
       point X Y Z                       COLUMNS * ROWS of them, u first
       u J PARAMETER VALUE...            of the curve CU_J through the row J, from 1 on; * for all:
       v I PARAMETER VALUE...            of the curve CV_I through the column I; one value, or one
                                         for each point of the curve
       curve u J I X Y Z X Y Z           own inner control points of the part I of CU_J
       curve v I J X Y Z X Y Z

   PARAMETER is tension, bias, continuity, t-continuity or rise. Where a parameter of a curve is set
   twice the last one counts. What is wrong ends the program: file, line and reason. */
void lattice_read(const char *path, lattice *l);
void lattice_free(lattice *l);

#endif
