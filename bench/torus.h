/* torus.h: the mesh that bench and scale measure on. */
#ifndef BENCH_TORUS_H
#define BENCH_TORUS_H

#include "nagata3.h"

/* A torus of radii 2 and 1 of nu by nv quadrilaterals split in two, its corners, their normals and
 * its triangles; no normals where n is NULL. */
static inline void torus_make(int nu, int nv, n3_vec *x, n3_vec *n, int *triangle)
{
    const double turn = 2 * 3.14159265358979323846;
    int i, k, *t = triangle;
    for (i = 0; i < nu; i++)
        for (k = 0; k < nv; k++, t += 6) {
            double u = turn * i / nu, v = turn * k / nv, r = 2 + cos(v);
            int right = (i + 1) % nu * nv, up = (k + 1) % nv, p = i * nv + k;
            x[p] = n3_v((n3_real)(r * cos(u)), (n3_real)(r * sin(u)), (n3_real)sin(v));
            if (n)
                n[p] = n3_v((n3_real)(cos(u) * cos(v)), (n3_real)(sin(u) * cos(v)),
                            (n3_real)sin(v));
            t[0] = t[3] = p;
            t[1] = right + k;
            t[2] = t[4] = right + up;
            t[5] = i * nv + up;
        }
}

#endif
