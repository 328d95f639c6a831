/* gallery.h: the paper's figures, computed. */
#ifndef GALLERY_H
#define GALLERY_H

#include "mesh_output.h"
#include "nagata3.h"

/* A figure: what it is called in the paper or here, and what draws it into a file. */
typedef struct figure {
    const char *name;
    void (*draw)(output *o);
} figure;

/* SVG: what lies in a plane, or is lines. PNG: surfaces, the old patch beside the new one. Each
   ends with a row of NULL. */
extern const figure plane_figures[], surface_figures[];

/* The triangle of figures 7, 17 and 18: the normals at a and b lean by 20 degrees along their edge
   and are 5 degrees apart, which sends the parabola between them far aside. */
void gallery_triangle(n3_vertex v[3]);

#endif
