/* samples.h: random triangles with normals, a tenth of them of each awkward kind. */
#ifndef SAMPLES_H
#define SAMPLES_H

#include "check.h"

enum {
    BENIGN,          /* the normals within 30 degrees of the triangle's */
    NEARLY_PARALLEL, /* turned from each other by 1e-1 to 1e-16 */
    NEARLY_OPPOSITE, /* the same of opposite normals, or of three that cancel */
    ALONG_CHORD,     /* normals along chords, exactly or nearly */
    COINCIDENT,      /* two or three points, exactly or nearly */
    SLIVER,          /* aspect 1e6 */
    MIXED_EXPONENTS, /* coordinates from 1e-30 to 1e30, in float from 1e-6 to 1e6 */
    ORTHOGONAL,      /* normals at right angles to chords */
    ON_AXES,         /* integer points and normals along axes */
    EQUAL_NORMALS,
    KINDS
};

/* Where a kind says nothing, points lie in the unit cube and normals point anywhere. A quarter of
 * the triangles lies a thousand sizes from the origin, a quarter is scaled by 2^exponent, from
 * 2^-100 to 2^100, in float from 2^-20 to 2^20. */
typedef struct sample {
    n3_vertex v[3];
    int kind, exponent;
    rng r; /* for what the test wants to choose itself */
} sample;

/* Sample i, the same whatever was drawn before; its kind is i % KINDS. */
sample sample_make(long i);

n3_vertex scale_vertex(n3_vertex v, int exponent);
n3_vec scale_vec(n3_vec a, int exponent);

/* A multiple of 2^-10 in [lo, hi], so that 1 - t and t h are exact. */
n3_real dyadic(rng *r, int lo, int hi);

/* Dyadic u and v in the triangle; a third of them on its sides. */
void dyadic_weights(rng *r, n3_real *u, n3_real *v);

/* The largest coordinate. */
double reach(const n3_vec *p, int count);

/* What every function says to the same triangle: vectors that grow with it, and unit ones. Asked
 * here and not where it is compared, so that one compiled copy of the header answers: two may
 * round differently where the compiler contracts products and sums. */
enum { LINEAR = 64, UNIT = 3 };
typedef struct answers { n3_vec linear[LINEAR], unit[UNIT]; } answers;
answers ask(const n3_vertex x[3], const n3_options *o, n3_real u, n3_real v);

/* Equal bit by bit, want having been scaled by 2^exponent. */
void check_alike(const answers *got, const answers *want, int exponent, long row);

#endif
