/* seeds.h: small files of every format that the readers know, in every variant of it. The same two
 * meshes stand in them: a few faces with fields, and a few volumes. */
#ifndef SEEDS_H
#define SEEDS_H

#include <stddef.h>

typedef struct seed {
    char name[60]; /* of a file */
    char *data;
    size_t size;
} seed;

/* The number of seeds; they are made once and never freed. */
int seeds_make(const seed **list);

/* Larger ones, of which readers need the most memory for a byte of the file. */
int seeds_make_worst(const seed **list);

#endif
