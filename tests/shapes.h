/* shapes.h: the awkward meshes of the tests, generated. */
#ifndef SHAPES_H
#define SHAPES_H

#include "check.h"

/* Arrays of its own; those of normals are NULL where the shape has none. */
typedef struct shape {
    int points, triangles, normals;
    n3_vec *point, *normal;
    int *triangle, *corner;
} shape;

/* With exact normals. */
shape shape_icosphere(int level);        /* radius 1 */
shape shape_torus(int nu, int nv);       /* radii 2 and 1 */
shape shape_polar(int nu, int nv);       /* sphere; triangles at the poles collapse */
shape shape_bracket(int round);          /* plate with fillets of round segments, and a hole; at its
                                            rims each face has its own normals */
shape shape_cone(int n);                 /* and its base; the normal of the apex is zero */

/* Without normals. */
shape shape_cube(void);                  /* edge 1 */
shape shape_moebius(int n);
shape shape_hourglass(int n);            /* two cones with one apex */
shape shape_sheets(int n);               /* n triangles on one edge */
shape shape_pillow(void);                /* two triangles back to back */
shape shape_soup(int points, int triangles, rng *r); /* any three points, also the same */

/* In place. */
void shape_drop_normals(shape *s);
void shape_split_normals(shape *s);                  /* a normal of its own for each corner */
void shape_tilt_normals(shape *s, double angle, rng *r); /* each by angle, in a random direction */
void shape_flip(shape *s, rng *r);                   /* every second triangle, more or less */
void shape_shuffle(shape *s, rng *r);                /* the triangles' order and first corners */
void shape_renumber(shape *s, rng *r);               /* the points */
void shape_free(shape *s);

shape shape_copy(const shape *s);
n3_mesh shape_mesh(const shape *s);

/* An OBJ file: v, vn, f. False if it cannot be read. */
int shape_read(const char *path, shape *s);

#endif
