/* inputs.h: the five pairs of meshes that Fujita's thesis tries, generated: its pictures show them,
 * its text has no coordinates. Tubes of rings of points, open at both ends; the loops to be joined
 * are the last ring of the lower and the first of the upper one. */
#ifndef INPUTS_H
#define INPUTS_H

#include "nagata3.h"

enum { INPUTS = 5, RINGS = 4, AROUND = 24, MOST_AROUND = 64 };

typedef struct tube {
    n3_mesh mesh; /* of the arrays below */
    n3_vec point[RINGS * MOST_AROUND];
    int triangle[6 * (RINGS - 1) * MOST_AROUND];
} tube;

/* What the thesis says of one: degrees between the triangles across the upper and the lower seam,
   from least to most; in the fifth, where two are apart from the others, the most of these. */
typedef struct input {
    const char *name, *title;
    double upper[2], lower[2], outlier;
} input;

extern const input inputs[INPUTS];

/* Into *t, which must not move, as its mesh points into it; around: points of a ring, 3 to
   MOST_AROUND. */
void input_make(int number, int upper, int around, tube *t);

/* The first point of the loop that is to be joined. */
int input_start(const tube *t, int upper);

#endif
