#include "check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN = 8 }; /* failures printed per test */

static const char *test_name;
static long failures;

static int fail(const char *what, const char *file, int line, long row)
{
    if (failures++ < SHOWN)
        printf("%s:%d: %s: row %ld: %s", file, line, test_name, row, what);
    return failures <= SHOWN;
}

int check_true(int ok, const char *what, const char *file, int line, long row)
{
    if (!ok && fail(what, file, line, row)) printf(" is false\n");
    return ok;
}

int check_near(double got, double want, double tol, const char *what, const char *file, int line,
               long row)
{
    int ok = fabs(got - want) <= tol;
    if (!ok && fail(what, file, line, row))
        printf(" = %.17g, want %.17g, off by %.3g, tolerance %.3g\n", got, want, got - want, tol);
    return ok;
}

int check_vec(n3_vec got, n3_vec want, double tol, const char *what, const char *file, int line,
              long row)
{
    int ok = fabs((double)got.x - (double)want.x) <= tol &&
             fabs((double)got.y - (double)want.y) <= tol &&
             fabs((double)got.z - (double)want.z) <= tol;
    if (!ok && fail(what, file, line, row))
        printf("\n    got  %.17g %.17g %.17g\n    want %.17g %.17g %.17g\n    tolerance %.3g\n",
               (double)got.x, (double)got.y, (double)got.z, (double)want.x, (double)want.y,
               (double)want.z, tol);
    return ok;
}

int check_same(n3_vec got, n3_vec want, const char *what, const char *file, int line, long row)
{
    int ok = same_vec(got, want);
    if (!ok && fail(what, file, line, row))
        printf("\n    got  %.17g %.17g %.17g\n    want %.17g %.17g %.17g, the same bits\n",
               (double)got.x, (double)got.y, (double)got.z, (double)want.x, (double)want.y,
               (double)want.z);
    return ok;
}

int same_real(n3_real a, n3_real b) { return a <= b && a >= b; }

int same_vec(n3_vec a, n3_vec b)
{
    return same_real(a.x, b.x) && same_real(a.y, b.y) && same_real(a.z, b.z);
}

int is_finite_vec(n3_vec a)
{
    return isfinite(a.x) && isfinite(a.y) && isfinite(a.z);
}

int is_nan_vec(n3_vec a) { return isnan(a.x) || isnan(a.y) || isnan(a.z); }

long sample_count(long count)
{
    const char *s = getenv("N3_SAMPLES");
    return s && atol(s) > 0 ? atol(s) : count;
}

uint64_t rng_next(rng *r)
{
    uint64_t z = (r->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double rng_uniform(rng *r, double lo, double hi)
{
    return lo + (hi - lo) * ((double)(rng_next(r) >> 11) / 9007199254740992.0);
}

n3_vec rng_vec(rng *r)
{
    n3_real x = (n3_real)rng_uniform(r, -1, 1);
    n3_real y = (n3_real)rng_uniform(r, -1, 1);
    n3_real z = (n3_real)rng_uniform(r, -1, 1);
    return n3_v(x, y, z);
}

n3_vec rng_unit(rng *r)
{
    for (;;) {
        n3_vec a = rng_vec(r);
        n3_real s = n3_dot(a, a);
        if (s <= 1 && s > (n3_real)1 / 16) return n3_unit(a);
    }
}

/* Runs every table, or only the tests whose name contains the first argument. */
int main(int argc, char **argv)
{
    const test_case *const *table, *t;
    long passed = 0, failed = 0;
    for (table = test_tables; *table; table++) {
        for (t = *table; t->name; t++) {
            if (argc > 1 && !strstr(t->name, argv[1])) continue;
            test_name = t->name;
            failures = 0;
            t->run();
            if (failures) printf("FAIL %s: %ld failures\n", t->name, failures);
            failures ? failed++ : passed++;
        }
    }
    printf("%s precision: %ld passed, %ld failed\n", sizeof(n3_real) == 4 ? "single" : "double",
           passed, failed);
    return failed != 0;
}
