/* PNG: a picture of the surface. */
#include "smooth_picture.h"

#include <math.h>
#include <stdlib.h>

/* The parts for each side into which a square is cut: few where there are many squares. */
static int square_parts(const surface *s)
{
    int n = s->squares ? (int)sqrt(50000.0 / s->squares) : 1;
    return n < 1 ? 1 : n > 8 ? 8 : n;
}

/* The control point next to x0 of the cubic curve through points at thirds: 6 p1 = -5 x0 + 18 x1 -
   9 x2 + 2 x3. */
static n3_vec control(n3_vec x0, n3_vec x1, n3_vec x2, n3_vec x3)
{
    n3_vec minus = n3_add(n3_mul(5, x0), n3_mul(9, x2));
    return n3_mul((n3_real)1 / 6, n3_sub(n3_add(n3_mul(18, x1), n3_mul(2, x3)), minus));
}

static n3_edge edge_through(n3_vec x0, n3_vec x1, n3_vec x2, n3_vec x3)
{
    n3_edge e;
    e.p[0] = x0;
    e.p[1] = control(x0, x1, x2, x3);
    e.p[2] = control(x3, x2, x1, x0);
    e.p[3] = x3;
    return e;
}

/* The cubic patch through ten points: corners, sides, the middle. */
static n3_patch patch_through(const n3_vec x[10])
{
    n3_edge ab = edge_through(x[0], x[3], x[4], x[1]), bc = edge_through(x[1], x[5], x[6], x[2]);
    n3_edge ca = edge_through(x[2], x[7], x[8], x[0]);
    n3_vec centre = n3_mul(27, x[9]);
    n3_patch p = n3_patch_from_edges(&ab, &bc, &ca, x[9]);
    int i;
    for (i = 0; i < 9; i++) centre = n3_sub(centre, n3_mul(i < 3 ? 1 : 3, p.p[i]));
    p.p[9] = n3_mul((n3_real)1 / 6, centre);
    return p;
}

/* Half a square as patches through its points. */
static int cut_half(const surface *s, int triangle, int n, n3_patch *to)
{
    static const int weight[10][3] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 1, 0}, {1, 2, 0},
                                      {0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {1, 1, 1}};
    int i, j, k, made = 0;
    for (j = 0; j < n; j++)
        for (i = 0; i < 2 * (n - j) - 1; i++) {
            int at[3][2];
            n3_vec x[10];
            facet_places(i, j, at);
            for (k = 0; k < 10; k++) {
                const int *w = weight[k];
                int u = w[0] * at[0][0] + w[1] * at[1][0] + w[2] * at[2][0];
                int v = w[0] * at[0][1] + w[1] * at[1][1] + w[2] * at[2][1];
                x[k] = surface_point(s, triangle, (n3_real)u / (3 * n), (n3_real)v / (3 * n));
            }
            to[made++] = patch_through(x);
        }
    return made;
}

void surface_scene(const surface *s, scene *out)
{
    const int triangles = s->mesh.triangles, n = square_parts(s);
    int t, patches = triangles + 2 * s->squares * (n * n - 1);
    memset(out, 0, sizeof *out);
    out->patch = allocate((size_t)patches, sizeof *out->patch);
    for (t = 0; t < triangles; t++) {
        n3_patch *to = out->patch + out->patches;
        if (s->half && s->half[t] >= 0) {
            out->patches += cut_half(s, t, n, to);
        } else {
            n3_mesh_patches(&s->mesh, &s->topology, s->net, t, t + 1, to);
            out->patches++;
        }
    }
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
