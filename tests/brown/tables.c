/* tables.c: the tests of Brown's surfaces. */
#include "check.h"

extern const test_case tests_square[], tests_lattice[], tests_quad[];

const test_case *const test_tables[] = {tests_square, tests_lattice, tests_quad, NULL};
