/* sandbox.h: reads a mesh from memory, and comes back whatever is in it. */
#ifndef SANDBOX_H
#define SANDBOX_H

#include "mesh.h"

/* The promise: memory at most so many times the file's size, and so much besides. */
enum { MEMORY_TIMES = 96, MEMORY_MORE = 1 << 17 };

typedef struct outcome {
    int accepted;
    size_t peak;       /* bytes, while reading */
    char message[400]; /* of who refused */
    const char *fault; /* what must not be; NULL: nothing */
} outcome;

/* read NULL: mesh_read(), which finds the format. The mesh is checked, joined and freed. */
outcome sandbox_read(void (*read)(const char *path, const char *data, size_t size, mesh *m),
                     const char *data, size_t size, int boundary);

#endif
