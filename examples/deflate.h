/* deflate.h: zlib streams (RFC 1950, 1951), and bytes that grow. */
#ifndef DEFLATE_H
#define DEFLATE_H

#include <stddef.h>
#include <stdint.h>

typedef struct bytes {
    unsigned char *data;
    size_t size, room;
} bytes;

void bytes_add(bytes *b, const void *data, size_t size);
void bytes_add_byte(bytes *b, unsigned value);

/* Appends a zlib stream of the data: LZ77 with hash chains and lazy matches, in blocks with
   Huffman codes of their own. */
void zlib_compress(bytes *out, const unsigned char *data, size_t size);

#endif
