/* smooth_picture.h: the surface to look at. */
#ifndef SMOOTH_PICTURE_H
#define SMOOTH_PICTURE_H

#include "mesh_output.h"
#include "smooth.h"

/* The patches, to be freed with scene_free() before the surface. */
void surface_scene(const surface *s, scene *out);

/* A PNG file in memory, as asked for. */
unsigned char *surface_png(const scene *s, const request *r, int width, int height, size_t *size);

/* Into a file of its own. */
product write_page(const request *r, const mesh *m, const surface *s);
product write_picture(const request *r, const mesh *m, const surface *s);

#endif
