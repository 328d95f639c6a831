/* picture.h: pictures to draw on. */
#ifndef PICTURE_H
#define PICTURE_H

#include "colour.h"

#include <stddef.h>

/* Pixels in rows from the top. Places are in pixels from the upper left corner of the picture. */
typedef struct picture {
    int width, height;
    colour *pixel;
} picture;

/* A part of a picture. */
typedef struct panel { int x, y, width, height; } panel;

picture picture_make(int width, int height, colour background);
void picture_free(picture *p);

/* Colours are laid over what is there; what lies outside is cut off. Lines have round ends. */
void picture_fill(picture *p, panel f, colour c);
void picture_line(picture *p, double x0, double y0, double x1, double y1, double width, colour c);

/* Text of letters, digits and . , : ' - + / = ( ), its baseline at y; size: the height of a
   capital. align -1, 0, 1: x is its left end, its middle, its right end. Returns its width. */
double picture_text(picture *p, double x, double y, double size, int align, colour c,
                    const char *text);

/* As a PNG file, in memory that the caller frees. */
unsigned char *picture_png(const picture *p, size_t *size);

#endif
