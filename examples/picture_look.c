#include "picture_look.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ZEBRA = 14, ISOPHOTES = 20 }; /* pairs of stripes in half a turn */

static const double half_turn = 3.14159265358979323846;

static const struct {
    const char *name, *legend;
} views[] = {{"shaded", NULL},
             {"zebra", NULL},
             {"isophote", NULL},
             {"mean", "mean curvature, 1 / length"},
             {"gauss", "Gaussian curvature, 1 / length squared"},
             {"net", NULL},
             {"error", "distance from the flat triangles"}};

int view_find(const char *name)
{
    size_t i;
    for (i = 0; i < sizeof views / sizeof *views; i++)
        if (strcmp(views[i].name, name) == 0) return (int)i;
    return -1;
}

const char *view_name(view v) { return views[v].name; }

/* First fundamental form, E F G, and second, L M N, of the normal n. */
static double curvature(const n3_jet *j, n3_vec n, int mean)
{
    double E = n3_dot(j->du, j->du), F = n3_dot(j->du, j->dv), G = n3_dot(j->dv, j->dv);
    double L = n3_dot(j->duu, n), M = n3_dot(j->duv, n), N = n3_dot(j->dvv, n);
    double area = E * G - F * F, k = mean ? 2 * F * M - E * N - G * L : L * N - M * M;
    if (mean) area *= 2;
    return area > 0 ? k / area : 0;
}

double look_value(view v, const spot *s)
{
    const n3_vec *c = s->corner;
    n3_vec face;
    if (v != VIEW_ERROR) return curvature(&s->jet, s->normal, v == VIEW_MEAN);
    face = n3_unit(n3_cross(n3_sub(c[1], c[0]), n3_sub(c[2], c[0])));
    return fabs(n3_dot(face, n3_sub(s->jet.x, c[0])));
}

double look_unit(view v, double length)
{
    return v == VIEW_MEAN ? 1 / length : v == VIEW_GAUSS ? 1 / length / length : length;
}

/* Whether a value lies in a light stripe. */
static int in_stripe(double cosine, int stripes)
{
    double t = acos(fmin(1, fmax(-1, cosine))) / half_turn * stripes;
    return t - floor(t) < 0.5;
}

/* Lights stay with the camera: a key from the upper left, a weak one from the right. */
static const n3_vec key = {(n3_real)-0.48, (n3_real)0.6, (n3_real)0.64};

static double brightness(n3_vec n, n3_vec eye, double *shine)
{
    const n3_vec fill = {(n3_real)0.8, 0, (n3_real)0.6};
    double d = fmax(0, n3_dot(n, key)), f = fmax(0, n3_dot(n, fill));
    *shine = pow(fmax(0, n3_dot(n, n3_unit(n3_add(key, eye)))), 60);
    return 0.16 + 0.78 * d + 0.12 * f;
}

static colour lit(colour c, double light, double shine)
{
    c.r = fmin(1, c.r * light + shine);
    c.g = fmin(1, c.g * light + shine);
    c.b = fmin(1, c.b * light + shine);
    return c;
}

static colour map_colour(const look *l, const spot *s)
{
    double t = look_value(l->v, s) * look_unit(l->v, l->unit) / l->range;
    return l->v == VIEW_ERROR ? colour_sequential(t) : colour_diverging(t);
}

/* A stripe in the mirror that the surface is; yellowish on its inner side. */
static colour zebra(n3_vec n, n3_vec eye, int inner)
{
    const n3_vec axis = {(n3_real)0.6, (n3_real)0.8, 0};
    n3_vec mirrored = n3_sub(n3_mul(2 * n3_dot(n, eye), n), eye);
    colour c = colour_srgb(255, inner ? 244 : 255, inner ? 214 : 255);
    return lit(c, in_stripe(n3_dot(mirrored, axis), ZEBRA) ? 0.9 : 0.012, 0);
}

colour look_colour(const look *l, const spot *s)
{
    n3_vec eye = n3_unit(n3_sub(n3_v(0, 0, (n3_real)l->eye), s->jet.x)), n = s->normal;
    int inner = n3_dot(n, eye) < 0;
    double shine, light;
    if (inner) n = n3_mul(-1, n);
    light = brightness(n, eye, &shine);
    if (l->v == VIEW_ZEBRA) return lit(zebra(n, eye, inner), 0.75 + 0.25 * light, 0);
    if (l->v == VIEW_ISOPHOTE) {
        int on = in_stripe(n3_dot(n, key), ISOPHOTES);
        return lit(on ? colour_oklab(0.95, 0, 0) : colour_oklab(0.5, 0, inner ? 0.08 : -0.12),
                   0.7 + 0.3 * light, 0);
    }
    if (l->v == VIEW_SHADED || l->v == VIEW_NET)
        return lit(inner ? colour_oklab(0.7, 0.09, 0.05) : colour_oklab(0.8, -0.015, -0.035), light,
                   0.25 * shine);
    return lit(map_colour(l, s), 0.8 + 0.2 * light, 0);
}

/* ---- Legend ---- */

static double text_size(panel f) { return fmax(7, fmin(f.height, f.width) / 42.0); }

int look_legend_height(panel f, view v) { return views[v].legend ? (int)(6.5 * text_size(f)) : 0; }

/* A bar of the map's colours with numbers below and its name on top. */
void look_legend(picture *p, panel f, view v, double range)
{
    const colour ink = colour_oklab(0.3, 0, 0);
    const int width = f.width * 6 / 10, left = f.x + (f.width - width) / 2, ticks = 4;
    const double size = text_size(f), from = v == VIEW_ERROR ? 0 : -range;
    panel bar = {0, 0, 1, 0};
    int i;
    if (!views[v].legend) return;
    bar.height = (int)(1.2 * size);
    bar.y = f.y + f.height - (int)(4.2 * size);
    for (i = 0; i < width; i++) {
        double t = (i + 0.5) / width;
        bar.x = left + i;
        picture_fill(p, bar, v == VIEW_ERROR ? colour_sequential(t) : colour_diverging(2 * t - 1));
    }
    picture_text(p, left + width / 2.0, bar.y - 0.6 * size, size, 0, ink, views[v].legend);
    for (i = 0; i <= ticks; i++) {
        char number[32];
        double x = left + (double)width * i / ticks;
        snprintf(number, sizeof number, "%.3g", from + (range - from) * i / ticks);
        picture_line(p, x, bar.y + bar.height, x, bar.y + bar.height + 0.4 * size, 1, ink);
        picture_text(p, x, bar.y + bar.height + 1.8 * size, size, 0, ink, number);
    }
}
