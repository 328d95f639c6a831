/* gallery DIR: draws the figures 6 to 13 and 16 to 18 of the paper, and three more surfaces, from
 * computed data into the folder DIR, as SVG and PNG. */
#include "gallery.h"

#include <math.h>
#include <stdlib.h>

const char program[] = "gallery";

void gallery_triangle(n3_vertex v[3])
{
    const double degree = 3.14159265358979323846 / 180, lean = 20 * degree, apart = 5 * degree;
    const double s = sin(lean), c = cos(lean);
    v[0].x = n3_v(0, 0, 0);
    v[1].x = n3_v(1, 0, 0);
    v[2].x = n3_v((n3_real)0.45, (n3_real)-0.85, 0);
    v[0].n = n3_v((n3_real)-s, 0, (n3_real)c);
    v[1].n = n3_v((n3_real)-s, (n3_real)(-c * sin(apart)), (n3_real)(c * cos(apart)));
    v[2].n = n3_v((n3_real)s, 0, (n3_real)c);
}

output *figure_open(const char *folder, const char *name, int order)
{
    char *path = allocate(strlen(folder) + strlen(name) + 2, 1);
    output *o;
    strcat(strcat(strcpy(path, folder), "/"), name);
    o = output_open(path, order);
    free(path);
    return o;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fputs("usage: gallery DIR\n", stderr);
        return 2;
    }
    output_catch_signals();
    draw_plane_figures(argv[1]);
    draw_surface_figures(argv[1]);
    return 0;
}
