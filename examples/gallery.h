/* gallery.h: the paper's figures, computed. */
#ifndef GALLERY_H
#define GALLERY_H

#include "mesh_output.h"
#include "nagata3.h"

/* What lies in a plane, or is lines, as SVG; surfaces, the old patch beside the new one, as PNG. */
void draw_plane_figures(const char *folder);
void draw_surface_figures(const char *folder);

/* A file in the folder. */
output *figure_open(const char *folder, const char *name, int order);

/* The triangle of figures 7, 17 and 18: the normals at a and b lean by 20 degrees along their edge
   and are 5 degrees apart, which sends the parabola between them far aside. */
void gallery_triangle(n3_vertex v[3]);

#endif
