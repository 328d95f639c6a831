/* check.h: a small test harness. A test is a function; it passes when none of its checks failed.
 *
 * Each file of tests exports one table, closed by a NULL name; each program of tests has one file
 * that lists its tables, and check.c runs them. Every check takes the row of the table or the
 * number of the sample that it belongs to, and prints both numbers, the tolerance and the row when
 * it fails. */
#ifndef CHECK_H
#define CHECK_H

#include "nagata3.h"

#include <stdint.h>

typedef struct test_case { const char *name; void (*run)(void); } test_case;

/* What check.c runs, closed by NULL. */
extern const test_case *const test_tables[];

/* 1 where the compiler may contract products and sums, and one call round unlike another. */
#ifdef FP_FAST_FMA
enum { CONTRACTED = 1 };
#else
enum { CONTRACTED = 0 };
#endif

/* The relative spacing of n3_real at 1: 2^-52 or 2^-23. */
#define EPS ((double)N3_EPS)

#define CHECK(ok, row) check_true((ok) ? 1 : 0, #ok, __FILE__, __LINE__, (long)(row))
#define CHECK_NEAR(got, want, tol, row) \
    check_near((double)(got), (double)(want), (double)(tol), #got, __FILE__, __LINE__, (long)(row))
#define CHECK_VEC(got, want, tol, row) \
    check_vec((got), (want), (double)(tol), #got, __FILE__, __LINE__, (long)(row))
#define CHECK_SAME(got, want, row) check_same((got), (want), #got, __FILE__, __LINE__, (long)(row))

int check_true(int ok, const char *what, const char *file, int line, long row);
/* |got - want| <= tol; a NaN fails. */
int check_near(double got, double want, double tol, const char *what, const char *file, int line,
               long row);
/* The largest component of got - want is at most tol; a NaN fails. */
int check_vec(n3_vec got, n3_vec want, double tol, const char *what, const char *file, int line,
              long row);
/* Equal with ==, component by component; -0 equals 0, a NaN fails. */
int check_same(n3_vec got, n3_vec want, const char *what, const char *file, int line, long row);

int same_real(n3_real a, n3_real b);
int same_vec(n3_vec a, n3_vec b);
int is_finite_vec(n3_vec a);
int is_nan_vec(n3_vec a);

/* The number of random samples: the environment's N3_SAMPLES, else count. */
long sample_count(long count);

/* A seeded generator (splitmix64); the same numbers on every machine. */
typedef struct rng { uint64_t state; } rng;
uint64_t rng_next(rng *r);
double rng_uniform(rng *r, double lo, double hi);
n3_vec rng_vec(rng *r);  /* in the cube [-1, 1]^3 */
n3_vec rng_unit(rng *r); /* uniform on the unit sphere */

#endif
