/* tables.c: the tests of the header. */
#include "check.h"

extern const test_case tests_equations[], tests_closed_forms[], tests_golden[], tests_degenerate[],
    tests_properties[], tests_mesh[], tests_net[], tests_adaptive[], tests_accuracy[],
    tests_batch[], tests_query[], tests_query_hit[];

const test_case *const test_tables[] = {
    tests_equations, tests_closed_forms, tests_golden,   tests_degenerate, tests_properties,
    tests_mesh,      tests_net,          tests_adaptive, tests_accuracy,   tests_query,
    tests_batch,     tests_query_hit,    NULL};
