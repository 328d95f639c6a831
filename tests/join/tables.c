/* tables.c: the tests of join.h. */
#include "joined.h"

const test_case *const test_tables[] = {tests_bridge, tests_fujita, tests_awkward, NULL};
