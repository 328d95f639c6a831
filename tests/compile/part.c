/* Compiled in each precision, as C and as C++, into one program with main.c. */
#include "nagata3.h"

#ifdef NAGATA3_FLOAT
#define RADIUS radius_float
#else
#define RADIUS radius_double
#endif

double RADIUS(void);

double RADIUS(void)
{
    n3_vertex a = {{1, 0, 0}, {1, 0, 0}}, b = {{0, 1, 0}, {0, 1, 0}}, c = {{0, 0, 1}, {0, 0, 1}};
    n3_patch p = n3_patch_make(a, b, c, NULL);
    n3_real third = (n3_real)1 / 3;
    return (double)n3_len(n3_patch_point(&p, third, third));
}
