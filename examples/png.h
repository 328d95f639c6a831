/* png.h: pictures as PNG files, as small as zlib makes them at its best or nearly so. */
#ifndef PNG_H
#define PNG_H

#include <stddef.h>
#include <stdio.h>

/* The bytes of a PNG file of the picture, in memory that the caller frees. rgb: rows from the top,
   three bytes of sRGB each pixel. Grey pictures become grey files, those of at most 256 colours get
   a palette. Sizes from 1 x 1 on, up to 2^28 pixels. */
unsigned char *png_encode(int width, int height, const unsigned char *rgb, size_t *size);

/* The same into a file. */
void png_write(FILE *f, int width, int height, const unsigned char *rgb);

#endif
