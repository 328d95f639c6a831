/* mutate.h: files with faults in them. */
#ifndef MUTATE_H
#define MUTATE_H

#include "seeds.h"

enum { MUTANT_MOST = 1 << 16 }; /* bytes */

/* The mutant with this number, always the same: of the seed it begins with the size of *data is
   returned. */
size_t mutate(unsigned long number, const seed *list, int seeds, char *data);

#endif
