/* inflate.h: zlib streams and PNG files read back, by the specifications alone. */
#ifndef INFLATE_H
#define INFLATE_H

#include <stddef.h>

/* The data of a zlib stream; NULL if anything in it is not as it should be, its checksum included.
   The caller frees it. */
unsigned char *zlib_expand(const unsigned char *from, size_t size, size_t *out);

/* A picture as rows of RGB; NULL if the file is not a PNG as png.h writes it. */
unsigned char *png_decode(const unsigned char *file, size_t size, int *width, int *height);

#endif
