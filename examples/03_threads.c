/* 03_threads: all cores make the surface. Every call on many patches takes a range of them, so that
 * the loop over the ranges is the caller's: here OpenMP's, cc -fopenmp. */
#include "nagata3.h"

#include <stdio.h>

enum { TRIANGLES = 50000, LEVEL = 4, POINTS = 15, PIECE = 500 };

static n3_patch patch[TRIANGLES];
static n3_vec point[TRIANGLES * POINTS], normal[TRIANGLES * POINTS];

/* A triangle on the unit sphere, one of many along the equator. */
static n3_patch make_patch(int i)
{
    n3_real t = (n3_real)i / TRIANGLES, size = (n3_real)1 / 100;
    n3_vertex v[3];
    int k;
    for (k = 0; k < 3; k++) {
        v[k].x = v[k].n = n3_unit(n3_v(1 - t, t + (k == 1) * size, (k == 2) * size));
    }
    return n3_patch_make(v[0], v[1], v[2], NULL);
}

int main(void)
{
    n3_real largest = 0;
    int first, i;
#ifdef _OPENMP
#pragma omp parallel for
#endif
    for (first = 0; first < TRIANGLES; first += PIECE) {
        int k;
        for (k = first; k < first + PIECE; k++) patch[k] = make_patch(k);
        n3_lattice_points(patch, first, first + PIECE, LEVEL, point + POINTS * first);
        n3_lattice_normals(patch, first, first + PIECE, LEVEL, normal + POINTS * first);
    }
    for (i = 0; i < TRIANGLES * POINTS; i++) {
        n3_real d = n3_len(n3_sub(n3_unit(point[i]), normal[i]));
        largest = d > largest ? d : largest;
    }
    printf("%d points, their normals within %.1g of the sphere's\n", TRIANGLES * POINTS,
           (double)largest);
    return 0;
}
