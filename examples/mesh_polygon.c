/* Polygons into triangles. */
#include "mesh.h"

#include <math.h>

/* How wide the polygon's corner i is, from 0 for a spike over 1 for a right angle and 2 for a
   straight one to 4; N looks to the polygon's front. */
static n3_real width(const mesh *m, int n, const int *point, int i, n3_vec N)
{
    n3_vec x = m->point[point[i]];
    n3_vec to = n3_unit(n3_sub(m->point[point[(i + 1) % n]], x));
    n3_vec from = n3_unit(n3_sub(m->point[point[(i + n - 1) % n]], x));
    n3_real cosine = n3_dot(to, from);
    return n3_dot(n3_cross(to, from), N) >= 0 ? 1 - cosine : 3 + cosine;
}

/* The corner from which a fan splits the polygon: the widest, the first of equal ones. That is
   right for convex polygons and for those with one corner that looks inwards. */
static int fan_corner(const mesh *m, int n, const int *point)
{
    const n3_real noise = (n3_real)1e-6; /* rounded corners of a square are equal to this */
    n3_vec N = n3_v(0, 0, 0), o = m->point[point[0]];
    n3_real size = 0, best, w;
    int i, found = 0;
    for (i = 1; i < n; i++) size += n3_len(n3_sub(m->point[point[i]], o));
    if (n == 3 || !(size > 0)) return 0;
    for (i = 1; i + 1 < n; i++)
        N = n3_add(N, n3_cross(n3_mul(1 / size, n3_sub(m->point[point[i]], o)),
                               n3_mul(1 / size, n3_sub(m->point[point[i + 1]], o))));
    best = width(m, n, point, 0, N);
    for (i = 1; i < n; i++)
        if ((w = width(m, n, point, i, N)) > best + noise) best = w, found = i;
    return found;
}

void mesh_add_polygon(mesh *m, int n, const int *point, const int *normal)
{
    int first = fan_corner(m, n, point), i, j;
    m->polygons += n > 3;
    for (i = 1; i + 1 < n; i++) {
        int c[3];
        c[0] = first, c[1] = (first + i) % n, c[2] = (first + i + 1) % n;
        mesh_add_triangle(m, point[c[0]], point[c[1]], point[c[2]]);
        for (j = 0; normal && j < 3; j++) m->corner[3 * (m->triangles - 1) + j] = normal[c[j]];
    }
}
