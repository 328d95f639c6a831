#include "picture.h"

#include "mesh.h"
#include "png.h"

#include <math.h>
#include <stdlib.h>

picture picture_make(int width, int height, colour background)
{
    picture p;
    panel all = {0, 0, 0, 0};
    all.width = p.width = width;
    all.height = p.height = height;
    p.pixel = allocate((size_t)width * (size_t)height, sizeof *p.pixel);
    picture_fill(&p, all, background);
    return p;
}

void picture_free(picture *p) { free(p->pixel); }

static int clamp(double x, int lo, int hi) { return x > lo ? x < hi ? (int)x : hi : lo; }

void picture_fill(picture *p, panel f, colour c)
{
    int x, y, right = clamp(f.x + f.width, 0, p->width), end = clamp(f.y + f.height, 0, p->height);
    for (y = clamp(f.y, 0, p->height); y < end; y++)
        for (x = clamp(f.x, 0, p->width); x < right; x++) p->pixel[y * p->width + x] = c;
}

/* How far a point is from a line between two points. */
static double distance_from(double x, double y, double x0, double y0, double dx, double dy)
{
    double length = dx * dx + dy * dy, t = 0;
    if (length > 0) t = fmin(1, fmax(0, ((x - x0) * dx + (y - y0) * dy) / length));
    return hypot(x - x0 - t * dx, y - y0 - t * dy);
}

/* A pixel is covered by what of it lies within half the width, taken along the distance. */
void picture_line(picture *p, double x0, double y0, double x1, double y1, double width, colour c)
{
    double reach = width / 2 + 1;
    int x, y, left = clamp(fmin(x0, x1) - reach, 0, p->width);
    int right = clamp(fmax(x0, x1) + reach + 1, 0, p->width);
    int end = clamp(fmax(y0, y1) + reach + 1, 0, p->height);
    for (y = clamp(fmin(y0, y1) - reach, 0, p->height); y < end; y++) {
        for (x = left; x < right; x++) {
            double d = distance_from(x + 0.5, y + 0.5, x0, y0, x1 - x0, y1 - y0);
            double part = fmin(1, fmax(0, width / 2 - d + 0.5));
            colour *pixel = &p->pixel[y * p->width + x];
            *pixel = colour_mix(*pixel, part, c);
        }
    }
}

unsigned char *picture_png(const picture *p, size_t *size)
{
    size_t i, pixels = (size_t)p->width * (size_t)p->height;
    unsigned char *rgb = allocate(pixels, 3), *file;
    for (i = 0; i < pixels; i++) colour_bytes(p->pixel[i], rgb + 3 * i);
    file = png_encode(p->width, p->height, rgb, size);
    free(rgb);
    return file;
}
