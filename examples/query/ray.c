/* ray: a picture of the smooth surface over a mesh, by tracing rays to the patches themselves: with
 * their own normals, the shadows that they cast on each other and on the ground, and smooth
 * outlines. No triangle of it is ever made finer. */
#include "colour.h"
#include "mesh_output.h"
#include "png.h"
#include "smooth.h"
#include "tree.h"

#include <math.h>
#include <stdlib.h>

const char program[] = "ray";

enum { ACROSS = 3 }; /* rays to a pixel, along either of its sides */

typedef struct world {
    tree surface;
    n3_vec eye, right, up, ahead; /* right and up: half of the picture */
    n3_vec sun;                   /* unit, towards it */
    n3_real size, ground;         /* of the box's diagonal; its z */
} world;

/* Three quarters from above the ground, the whole in sight. */
static world world_make(const surface *s)
{
    const n3_real one = 1;
    world w;
    n3_patch *patch = allocate((size_t)s->mesh.triangles, sizeof *patch);
    n3_box box;
    n3_vec middle, back = n3_unit(n3_v(one / 2, -1, 2 * one / 5));
    n3_mesh_patches(&s->mesh, &s->topology, s->net, 0, s->mesh.triangles, patch);
    w.surface = tree_make(patch, s->mesh.triangles);
    free(patch);
    box = w.surface.node[0].box;
    w.size = n3_len(n3_sub(box.hi, box.lo));
    w.ground = box.lo.z;
    middle = n3_mul(one / 2, n3_add(box.lo, box.hi));
    w.eye = n3_add(middle, n3_mul(5 * w.size / 2, back));
    w.ahead = n3_mul(-1, back);
    w.right = n3_mul(one / 4, n3_unit(n3_cross(w.ahead, n3_v(0, 0, 1))));
    w.up = n3_cross(w.right, w.ahead);
    w.sun = n3_unit(n3_v(-1, -one / 2, 3 * one / 2));
    return w;
}

/* How much of the light comes to a point with this normal: that of the sun, unless something is in
   its way, and that of the sky. A shadow's ray starts as far off as the point may be off the
   surface, a millionth of the size. */
static double light(const world *w, n3_vec x, n3_vec n)
{
    double slope = (double)n3_dot(n, w->sun), sky = 0.25 + 0.1 * (double)n.z;
    n3_hit hit;
    x = n3_add(x, n3_mul(w->size / 1000000, n));
    if (slope <= 0 || tree_hit(&w->surface, x, w->sun, 0, 4 * w->size, &hit) >= 0) return sky;
    return sky + 0.65 * slope;
}

/* The colour that a ray from the eye sees. Normals look to the eye. */
static colour trace(const world *w, n3_vec along)
{
    const colour clay = colour_oklab(0.75, 0.06, 0.08), paper = colour_srgb(255, 255, 255);
    const colour none = {0, 0, 0};
    n3_hit hit;
    n3_real t = (w->ground - w->eye.z) / along.z;
    int i = tree_hit(&w->surface, w->eye, along, 0, 100 * w->size, &hit);
    if (i >= 0) {
        n3_vec n = n3_patch_normal(&w->surface.patch[i], hit.u, hit.v);
        if (n3_dot(n, along) > 0) n = n3_mul(-1, n);
        return colour_mix(none, light(w, hit.x, n), clay);
    }
    if (!(along.z < 0) || t > 10 * w->size) return paper;
    return colour_mix(none, 0.5 + 0.5 * light(w, n3_add(w->eye, n3_mul(t, along)), n3_v(0, 0, 1)),
                      paper);
}

static colour pixel(const world *w, int x, int y, int size)
{
    colour sum = {0, 0, 0};
    const double part = 1.0 / (ACROSS * ACROSS);
    int i;
    for (i = 0; i < ACROSS * ACROSS; i++) {
        double a = x + (i % ACROSS + 0.5) / ACROSS, b = y + (i / ACROSS + 0.5) / ACROSS;
        n3_real right = (n3_real)(2 * a / size - 1), up = (n3_real)(1 - 2 * b / size);
        n3_vec across = n3_add(n3_mul(right, w->right), n3_mul(up, w->up));
        colour c = trace(w, n3_add(w->ahead, across));
        sum.r += part * c.r;
        sum.g += part * c.g;
        sum.b += part * c.b;
    }
    return sum;
}

static void draw(const world *w, const char *path, int size)
{
    unsigned char *rgb = allocate(3 * (size_t)size * (size_t)size, 1), *file, *next = rgb;
    size_t bytes;
    int x, y;
    output *o;
    for (y = 0; y < size; y++) {
        progress("tracing", y, size);
        for (x = 0; x < size; x++, next += 3) colour_bytes(pixel(w, x, y, size), next);
    }
    progress_hide();
    file = png_encode(size, size, rgb, &bytes);
    o = output_open(path, LITTLE);
    put_bytes(o, file, bytes);
    output_close(o);
    free(file);
    free(rgb);
}

int main(int argc, char **argv)
{
    const long most = 8192;
    char *end = NULL;
    long size = argc == 4 ? strtol(argv[3], &end, 10) : 600;
    mesh m;
    surface s;
    world w;
    if (argc < 3 || argc > 4 || !has_extension(argv[2], ".png") || (end && *end) || size < 16 ||
        size > most) {
        fprintf(stderr, "usage: ray IN OUT.png [SIZE]\n"
                        "  IN    a mesh in any format that smooth reads\n"
                        "  SIZE  of the picture, 16 to 8192 pixels (600)\n");
        return 2;
    }
    output_catch_signals();
    mesh_read(argv[1], 0, &m);
    if (m.triangles == 0) fail(argv[1], 0, "there are no triangles in it");
    surface_make(argv[1], &m, smooth_rule_find("paper"), (n3_real)0.64, &s); /* 50 degrees */
    w = world_make(&s);
    draw(&w, argv[2], (int)size);
    tree_free(&w.surface);
    surface_free(&s);
    mesh_free(&m);
    return 0;
}
