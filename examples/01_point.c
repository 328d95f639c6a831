#include "nagata3.h"
#include <stdio.h>

int main(void)
{
    n3_vertex a = {{1, 0, 0}, {1, 0, 0}};
    n3_vertex b = {{0, 1, 0}, {0, 1, 0}};
    n3_vertex c = {{0, 0, 1}, {0, 0, 1}};
    n3_patch p = n3_patch_make(a, b, c, NULL);
    n3_vec x = n3_patch_point(&p, 1.0 / 3, 1.0 / 3);
    printf("middle %.6f %.6f %.6f, radius %.10f\n", x.x, x.y, x.z, n3_len(x));
    return 0;
}
