/* One patch, an octant of the unit sphere as the arc rule has it, and what can be asked of it. */
#include "nagata3.h"
#include <stdio.h>

int main(void)
{
    n3_vertex a = {{1, 0, 0}, {1, 0, 0}};
    n3_vertex b = {{0, 1, 0}, {0, 1, 0}};
    n3_vertex c = {{0, 0, 1}, {0, 0, 1}};
    n3_options arc = {N3_RULE_ARC, 0, 0};
    n3_patch p = n3_patch_make(a, b, c, &arc);
    n3_foot foot = n3_patch_nearest(&p, n3_v(2, 3, 6));
    n3_curvature bent = n3_patch_curvature(&p, foot.u, foot.v);
    n3_hit hit;
    printf("nearest to (2, 3, 6): %.4f %.4f %.4f\n", foot.x.x, foot.x.y, foot.x.z);
    printf("curvatures there: %.4f and %.4f\n", bent.k[0], bent.k[1]);
    if (n3_patch_hit(&p, n3_v(2, 3, 6), n3_v(-2, -3, -6), 0, 1, &hit))
        printf("hit on the way to the origin: t = %.4f\n", hit.t);
    printf("area %.4f, volume of the cone over it %.4f\n", n3_patch_area(&p, 1e-6, NULL),
           n3_patch_volume(&p, n3_v(0, 0, 0), NULL));
    return 0;
}
