/* brown_test.h: what the tests of Brown's surfaces share. */
#ifndef BROWN_TEST_H
#define BROWN_TEST_H

#include "brown.h"
#include "check.h"
#include "naive.h"
#include "samples.h"

#include <float.h>

/* A square with control points in eighths, the same as in golden.py: tangents that agree in the
 * corners; the same with remainders in the fields; tangents that differ. */
enum { COMPATIBLE, REMAINDERS, INCOMPATIBLE, KINDS_OF_SQUARE };
brown_square square_make(int seed, int kind);

#endif
