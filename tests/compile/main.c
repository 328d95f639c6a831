/* The middle of a sphere's octant, from both precisions in one program: 5 sqrt(3) / 9 from the
 * origin. The header is included here too, for a second file in the same precision. The octant's
 * control points come by some thirty operations, each with an error of half an eps of 1. */
#include "nagata3.h"

#include <stdio.h>

double radius_double(void), radius_float(void);

int main(void)
{
    double want = 5 * sqrt(3.0) / 9, eps_float = 1 / 8388608.0;
    double got[2], tolerance[2];
    int i, failed = 0;
    got[0] = radius_double(), tolerance[0] = 16 * (double)N3_EPS;
    got[1] = radius_float(), tolerance[1] = 16 * eps_float;
    for (i = 0; i < 2; i++) {
        if (fabs(got[i] - want) <= tolerance[i]) continue;
        printf("%d: got %.17g, want %.17g, tolerance %.3g\n", i, got[i], want, tolerance[i]);
        failed = 1;
    }
    return failed;
}
