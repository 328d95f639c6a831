/* smooth_shells.h: triangles that hang together over edges, and what they enclose. */
#ifndef SMOOTH_SHELLS_H
#define SMOOTH_SHELLS_H

#include "smooth.h"

typedef struct shell {
    int first, count; /* its triangles, in the list of all */
    n3_real volume;   /* within the flat triangles, negative where they look inwards; 0: open */
    n3_vec lo, hi;    /* the box about its corners */
    int around;       /* the shell whose cavity it is; */
    int cavity, next; /* its first cavity, and the next one of the same shell; -1: none */
} shell;

typedef struct shells {
    int count;
    shell *shell;
    int *triangle; /* by shells */
    int *of;       /* of each triangle, its shell */
} shells;

shells shells_find(const surface *s);
void shells_free(shells *all);

#endif
