/* PNG: a picture of the surface. */
#include "smooth_picture.h"

#include <stdlib.h>

/* Halves of squares are no patches. */
static int find_on_square(const void *owner, int triangle, double u, double v, spot *out)
{
    const surface *s = owner;
    int i;
    if (!surface_on_square(s, triangle, (n3_real)u, (n3_real)v, &out->jet, &out->normal)) return 0;
    for (i = 0; i < 3; i++) out->corner[i] = s->net[s->mesh.triangle[3 * triangle + i]];
    return 1;
}

void surface_scene(const surface *s, scene *out)
{
    const int n = s->mesh.triangles;
    memset(out, 0, sizeof *out);
    out->patches = n;
    out->find = s->squares ? find_on_square : NULL;
    out->owner = s;
    out->patch = allocate((size_t)n, sizeof *out->patch);
    n3_mesh_patches(&s->mesh, &s->topology, s->net, 0, n, out->patch);
}

unsigned char *surface_png(const scene *s, const request *r, int width, int height, size_t *size)
{
    panel all = {0, 0, 0, 0};
    picture p = picture_make(width, height, colour_srgb(255, 255, 255));
    unsigned char *file;
    all.width = width;
    all.height = height;
    scene_draw(&p, all, s, r->camera, r->view, scene_range(s, r->view));
    file = picture_png(&p, size);
    picture_free(&p);
    return file;
}

product write_picture(const request *r, const mesh *m, const surface *s)
{
    product out = {NULL, "cubic", 0, 0, 0, 0};
    scene drawn;
    size_t size;
    unsigned char *file;
    output *o;
    (void)m;
    surface_scene(s, &drawn);
    if (r->view == VIEW_NET) scene_add_net(&drawn);
    progress("drawing", -1, 1);
    file = surface_png(&drawn, r, r->width, r->height, &size);
    o = output_open(r->path, LITTLE);
    put_bytes(o, file, size);
    output_close(o);
    free(file);
    scene_free(&drawn);
    out.triangles = s->mesh.triangles;
    out.points = s->mesh.points;
    return out;
}
