/* Figures of lines, as SVG in light and dark colours. */
#include "gallery.h"

#include <math.h>
#include <stdarg.h>

enum { WIDTH = 640, HEIGHT = 360, STEPS = 24, LINES = 10 };

static const double degree = 3.14159265358979323846 / 180;

static const char *const style =
    "<style>\n"
    "  rect { fill: #ffffff }\n"
    "  text { font: 16px sans-serif; fill: #1f2328; text-anchor: middle }\n"
    "  .small { font-size: 11px }\n"
    "  path { fill: none; stroke: #59636e; stroke-width: 1.5; stroke-linejoin: round }\n"
    "  circle { fill: #1f2328 }\n"
    "  .chord { stroke: #1f2328; stroke-width: 2 }\n"
    "  .help { stroke-dasharray: 4 5 }\n"
    "  .normal { stroke: #1a7f37; stroke-width: 2.5 }\n"
    "  .nagata { stroke: #cf222e; stroke-width: 3 }\n"
    "  .cubic { stroke: #0969da; stroke-width: 3 }\n"
    "  .thin { stroke-width: 0.7 }\n"
    "  .sheet { fill: #9a670033; stroke-width: 1 }\n"
    "  @media (prefers-color-scheme: dark) {\n"
    "    rect { fill: #0d1117 }\n"
    "    text, circle { fill: #f0f6fc }\n"
    "    path { stroke: #9198a1 }\n"
    "    .chord { stroke: #f0f6fc }\n"
    "    .normal { stroke: #3fb950 }\n"
    "    .nagata { stroke: #ff7b72 }\n"
    "    .cubic { stroke: #58a6ff }\n"
    "  }\n"
    "</style>\n";

/* Where the origin of space lies in the picture, the pixels per unit, the axes. */
typedef struct sheet {
    output *o;
    double x, y, scale;
    n3_vec right, up;
} sheet;

static void put(output *o, const char *format, ...)
{
    char text[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    put_text(o, text);
}

/* The plane of x and y. */
static sheet plane(output *o, double x, double y, double scale)
{
    sheet s;
    s.o = o;
    s.x = x;
    s.y = y;
    s.scale = scale;
    s.right = n3_v(1, 0, 0);
    s.up = n3_v(0, 1, 0);
    return s;
}

static void begin(output *o, int height)
{
    put(o, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\">\n", WIDTH, height);
    put_text(o, style);
    put(o, "<rect width=\"%d\" height=\"%d\" rx=\"8\"/>\n", WIDTH, height);
}

static void finish(output *o) { put(o, "</svg>\n"); }

static double across(const sheet *s, n3_vec p)
{
    return s->x + s->scale * (double)n3_dot(s->right, p);
}

static double down(const sheet *s, n3_vec p) { return s->y - s->scale * (double)n3_dot(s->up, p); }

static n3_vec at(double x, double y) { return n3_v((n3_real)x, (n3_real)y, 0); }

/* p + t (q - p) */
static n3_vec between(n3_vec p, double t, n3_vec q)
{
    return n3_add(p, n3_mul((n3_real)t, n3_sub(q, p)));
}

static void line(const sheet *s, const char *kind, n3_vec p, n3_vec q)
{
    put(s->o, "<path class=\"%s\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", kind, across(s, p), down(s, p),
        across(s, q), down(s, q));
}

/* With a head of two strokes. */
static void arrow(const sheet *s, const char *kind, n3_vec p, n3_vec q)
{
    double dx = across(s, q) - across(s, p), dy = down(s, q) - down(s, p), n = hypot(dx, dy);
    double x = across(s, q), y = down(s, q);
    if (n <= 0) return;
    dx *= 9 / n;
    dy *= 9 / n;
    line(s, kind, p, q);
    put(s->o, "<path class=\"%s\" d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1f\"/>\n", kind, x - dx - dy / 2,
        y - dy + dx / 2, x, y, x - dx + dy / 2, y - dy - dx / 2);
}

static void curve(const sheet *s, const char *kind, const n3_edge *e)
{
    put(s->o, "<path class=\"%s\" d=\"M%.1f %.1fC%.1f %.1f %.1f %.1f %.1f %.1f\"/>\n", kind,
        across(s, e->p[0]), down(s, e->p[0]), across(s, e->p[1]), down(s, e->p[1]),
        across(s, e->p[2]), down(s, e->p[2]), across(s, e->p[3]), down(s, e->p[3]));
}

static void polygon(const sheet *s, const char *kind, const n3_vec p[4])
{
    int i;
    put(s->o, "<path class=\"%s\" d=\"", kind);
    for (i = 0; i < 4; i++) put(s->o, "%s%.1f %.1f", i ? "L" : "M", across(s, p[i]), down(s, p[i]));
    put(s->o, "Z\"/>\n");
}

/* A letter, an index below and one above it, beside a point. */
static void name(const sheet *s, n3_vec p, double dx, double dy, const char *letter,
                 const char *below, const char *above)
{
    put(s->o, "<text x=\"%.1f\" y=\"%.1f\">%s", across(s, p) + dx, down(s, p) + dy, letter);
    put(s->o, "<tspan class=\"small\" dy=\"5\">%s</tspan>", below);
    if (*above) put(s->o, "<tspan class=\"small\" dy=\"-12\">%s</tspan>", above);
    put(s->o, "</text>\n");
}

static void dot(const sheet *s, n3_vec p, double dx, double dy, const char *letter,
                const char *below, const char *above)
{
    put(s->o, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\"/>\n", across(s, p), down(s, p));
    name(s, p, dx, dy, letter, below, above);
}

static void caption(output *o, double x, double y, const char *text)
{
    put(o, "<text x=\"%.1f\" y=\"%.1f\">%s</text>\n", x, y, text);
}

/* An arc from the direction of the angle from to that of to, in degrees. */
static void angle(const sheet *s, n3_vec p, double radius, double from, double to)
{
    n3_vec q = n3_add(p, at(radius * cos(from * degree), radius * sin(from * degree)));
    n3_vec r = n3_add(p, at(radius * cos(to * degree), radius * sin(to * degree)));
    put(s->o, "<path d=\"M%.1f %.1fA%.1f %.1f 0 0 %d %.1f %.1f\"/>\n", across(s, q), down(s, q),
        radius * s->scale, radius * s->scale, to < from, across(s, r), down(s, r));
}

/* The ends of the chord from 0 to 1 on the x axis, in the plane of the curve; the tangents there
   have these angles to it, in degrees. */
static void ends(double at_start, double at_end, n3_vertex v[2])
{
    v[0].x = at(0, 0);
    v[1].x = at(1, 0);
    v[0].n = at(-sin(at_start * degree), cos(at_start * degree));
    v[1].n = at(-sin(at_end * degree), cos(at_end * degree));
}

static void draw_ends(const sheet *s, const n3_vertex v[2], const char *start, const char *end)
{
    int i;
    line(s, "chord", v[0].x, v[1].x);
    for (i = 0; i < 2; i++)
        arrow(s, "normal", v[i].x, n3_add(v[i].x, n3_mul((n3_real)(55 / s->scale), v[i].n)));
    dot(s, v[0].x, -20, 4, "p", start, "");
    dot(s, v[1].x, 20, 4, "p", end, "");
}

/* ---- Figure 7: the parabola's middle point lies where the tangent planes meet. ---- */

static sheet space(output *o, double x, double y, double scale, double turn, double rise)
{
    sheet s = plane(o, x, y, scale);
    double ct = cos(turn * degree), st = sin(turn * degree);
    double cr = cos(rise * degree), sr = sin(rise * degree);
    s.right = n3_v((n3_real)ct, (n3_real)st, 0);
    s.up = n3_v((n3_real)(-st * sr), (n3_real)(ct * sr), (n3_real)cr);
    return s;
}

/* A part of the tangent plane of v, as far as the line where it meets the other one. */
static void draw_tangent_plane(const sheet *s, n3_vertex v, n3_vec meet, n3_vec along)
{
    n3_vec p[4], to = n3_sub(meet, v.x);
    n3_vec foot = n3_sub(meet, n3_mul(n3_dot(to, along), along));
    p[0] = n3_add(v.x, n3_mul((n3_real)0.25, along));
    p[1] = n3_sub(v.x, n3_mul((n3_real)0.25, along));
    p[2] = n3_sub(foot, n3_mul((n3_real)0.25, along));
    p[3] = n3_add(foot, n3_mul((n3_real)0.25, along));
    polygon(s, "sheet", p);
}

static void figure07(output *o)
{
    n3_vertex v[3];
    n3_segment g;
    n3_edge old, new;
    n3_vec along;
    sheet s = space(o, 140, 290, 105, 14, 34);
    int i;
    gallery_triangle(v);
    g = n3_segment_make(v[0], v[1]);
    old = n3_segment_raise(&g);
    new = n3_edge_make(v[0], v[1], NULL);
    along = n3_unit(n3_cross(v[0].n, v[1].n));
    begin(o, HEIGHT);
    for (i = 0; i < 2; i++) draw_tangent_plane(&s, v[i], g.p[1], along);
    line(&s, "help", n3_sub(g.p[1], n3_mul((n3_real)0.6, along)),
         n3_add(g.p[1], n3_mul((n3_real)1.2, along)));
    line(&s, "help", between(g.p[0], 0.5, g.p[2]), g.p[1]);
    line(&s, "chord", v[0].x, v[1].x);
    curve(&s, "nagata", &old);
    curve(&s, "cubic", &new);
    for (i = 0; i < 2; i++)
        arrow(&s, "normal", v[i].x, n3_add(v[i].x, n3_mul((n3_real)0.4, v[i].n)));
    dot(&s, g.p[0], -14, 16, "p", "20", "");
    dot(&s, g.p[2], 18, 14, "p", "02", "");
    dot(&s, g.p[1], -20, 0, "p", "11", "");
    caption(o, 500, 60, "where the tangent planes meet");
    caption(o, 420, 190, "the parabola");
    caption(o, 420, 300, "the cubic edge");
    finish(o);
}

/* ---- Figure 8: seen along the chord, planes through it are lines. ---- */

static void plane_line(const sheet *s, const char *kind, n3_vec across_chord)
{
    n3_vec p = n3_mul((n3_real)1.3, across_chord);
    line(s, kind, n3_mul(-1, p), p);
}

static void figure08(output *o)
{
    n3_vertex v[2];
    n3_vec m, e = {1, 0, 0}, p0, p1, pi;
    sheet s = plane(o, 320, 200, 125);
    s.right = n3_v(0, 1, 0);
    s.up = n3_v(0, 0, 1);
    v[0].x = n3_v(0, 0, 0);
    v[1].x = n3_v(1, 0, 0);
    v[0].n = n3_v(0, (n3_real)-sin(35 * degree), (n3_real)cos(35 * degree));
    v[1].n = n3_v(0, (n3_real)sin(25 * degree), (n3_real)cos(25 * degree));
    m = n3_curve_plane(v[0], v[1]);
    p0 = v[0].n;
    p1 = v[1].n;
    pi = n3_cross(m, e);
    if (pi.z < 0) pi = n3_mul(-1, pi);
    begin(o, 400);
    plane_line(&s, "help", n3_cross(e, p0));
    plane_line(&s, "help", n3_cross(e, p1));
    plane_line(&s, "", p0);
    plane_line(&s, "", p1);
    plane_line(&s, "cubic", pi);
    arrow(&s, "normal", n3_v(0, 0, 0), n3_mul((n3_real)0.8, p0));
    arrow(&s, "normal", n3_v(0, 0, 0), n3_mul((n3_real)0.8, p1));
    name(&s, n3_mul((n3_real)1.3, p0), -18, 6, "&#928;", "0", "");
    name(&s, n3_mul((n3_real)1.3, p1), 20, 6, "&#928;", "1", "");
    name(&s, n3_mul((n3_real)1.3, pi), 0, -10, "&#928;", "", "");
    name(&s, n3_mul((n3_real)0.8, p0), 22, 4, "n", "0", "");
    name(&s, n3_mul((n3_real)0.8, p1), -20, 4, "n", "1", "");
    name(&s, n3_mul((n3_real)1.3, n3_cross(e, p0)), -60, 22, "tangent plane at 0", "", "");
    name(&s, n3_mul((n3_real)-1.3, n3_cross(e, p1)), 60, 22, "tangent plane at 1", "", "");
    dot(&s, n3_v(0, 0, 0), 52, 6, "chord", "", "");
    finish(o);
}

/* ---- Figures 9 and 10: the tangents meet beyond an end. ---- */

static void draw_parabola(const sheet *s, double at_start, double at_end)
{
    n3_vertex v[2];
    n3_segment g;
    n3_edge e;
    ends(at_start, at_end, v);
    g = n3_segment_make(v[0], v[1]);
    e = n3_segment_raise(&g);
    line(s, "", g.p[0], g.p[1]);
    line(s, "", g.p[2], g.p[1]);
    curve(s, "nagata", &e);
    draw_ends(s, v, "20", "02");
    dot(s, g.p[1], 18, 4, "p", "11", "");
}

static void figure09(output *o)
{
    sheet s = plane(o, 150, 290, 190);
    int i;
    begin(o, HEIGHT);
    for (i = 0; i < 2; i++) line(&s, "help", at(i, -0.25), at(i, 1.4));
    draw_parabola(&s, 30, 50);
    caption(o, 245, 40, "where p11 should be");
    finish(o);
}

static void figure10(output *o)
{
    sheet s = plane(o, 175, 130, 120);
    begin(o, HEIGHT);
    draw_parabola(&s, 50, 30);
    s = plane(o, 370, 250, 120);
    draw_parabola(&s, 30, 50);
    caption(o, 160, 335, "(a) it starts backwards");
    caption(o, 480, 335, "(b) it ends backwards");
    finish(o);
}

/* ---- Figures 11 to 13: the cubic. ---- */

static void draw_cubic(const sheet *s, const n3_vertex v[2], const n3_edge *e)
{
    double side = e->p[2].y < 0 ? 20 : -10;
    line(s, "", e->p[0], e->p[1]);
    line(s, "", e->p[1], e->p[2]);
    line(s, "", e->p[2], e->p[3]);
    curve(s, "cubic", e);
    draw_ends(s, v, "30", "03");
    dot(s, e->p[1], 0, -10, "p", "21", "");
    dot(s, e->p[2], 0, side, "p", "12", "");
}

static void figure11(output *o)
{
    n3_vertex v[2];
    n3_edge e;
    sheet s = plane(o, 90, 170, 460);
    ends(50, 30, v);
    e = n3_edge_make(v[0], v[1], NULL);
    begin(o, HEIGHT);
    draw_cubic(&s, v, &e);
    finish(o);
}

/* The corrected points are 3/2 of a handle away, by (5.1.4a) and (5.1.5a). */
static void figure12(output *o)
{
    n3_vertex v[2];
    n3_edge e;
    n3_segment g;
    n3_vec c0, c1;
    sheet s = plane(o, 260, 180, 250);
    ends(50, 30, v);
    e = n3_edge_make(v[0], v[1], NULL);
    g = n3_segment_make(v[0], v[1]);
    c0 = between(e.p[0], 1.5, e.p[1]);
    c1 = between(e.p[3], 1.5, e.p[2]);
    begin(o, HEIGHT);
    line(&s, "help", between(g.p[0], 0.45, g.p[1]), g.p[0]);
    line(&s, "help", between(g.p[2], 0.62, g.p[1]), c1);
    line(&s, "", v[0].x, c0);
    line(&s, "", v[1].x, c1);
    line(&s, "help", v[1].x, c0);
    line(&s, "help", v[0].x, c1);
    curve(&s, "cubic", &e);
    draw_ends(&s, v, "20", "02");
    dot(&s, c0, 0, -14, "p", "11", "(0)");
    dot(&s, c1, 0, 24, "p", "11", "(1)");
    caption(o, 110, 280, "on to p11, backwards");
    caption(o, 490, 60, "mirrored in the chord");
    finish(o);
}

static void figure13(output *o)
{
    n3_vertex v[2];
    n3_edge e;
    n3_vec c;
    sheet s = plane(o, 110, 290, 420);
    ends(35, -52, v);
    e = n3_edge_make(v[0], v[1], NULL);
    c = between(e.p[0], 1.5, e.p[1]);
    begin(o, HEIGHT);
    line(&s, "help", v[0].x, c);
    line(&s, "help", v[1].x, c);
    draw_cubic(&s, v, &e);
    angle(&s, v[0].x, 0.16, 0, 35);
    angle(&s, v[1].x, 0.13, 180, 128);
    name(&s, at(0.2, 0.06), 0, 5, "&#952;", "s", "");
    name(&s, at(0.84, 0.07), 0, 5, "&#952;", "e", "");
    name(&s, between(v[0].x, 0.5, e.p[1]), -18, -4, "d", "s", "");
    name(&s, between(v[1].x, 0.5, e.p[2]), 20, -4, "d", "e", "");
    name(&s, c, 40, 0, "3/2 d", "s", "");
    name(&s, at(0.5, 0), 0, 24, "L", "", "");
    finish(o);
}

/* ---- Figure 18: both patches, from a towards b. ---- */

static void draw_patch(const sheet *s, const char *kind, const n3_patch *p)
{
    n3_edge edge[3];
    char thin[32];
    int k, i, j;
    snprintf(thin, sizeof thin, "%s thin", kind);
    n3_patch_edges(p, edge);
    for (k = 0; k < 3; k++) curve(s, kind, &edge[k]);
    for (k = 0; k < 3; k++)
        for (i = 1; i < LINES; i++) {
            double w[3];
            put(s->o, "<path class=\"%s\" d=\"", thin);
            for (j = 0; j <= STEPS; j++) {
                n3_vec x;
                w[k] = (double)i / LINES;
                w[(k + 1) % 3] = (1 - w[k]) * j / STEPS;
                w[(k + 2) % 3] = (1 - w[k]) * (STEPS - j) / STEPS;
                x = n3_patch_point(p, (n3_real)w[1], (n3_real)w[2]);
                put(s->o, "%s%.1f %.1f", j ? "L" : "M", across(s, x), down(s, x));
            }
            put(s->o, "\"/>\n");
        }
}

static void figure18(output *o)
{
    n3_vertex v[3];
    n3_patch2 q;
    n3_patch old, new;
    sheet s = space(o, 200, 220, 185, 80, 24);
    gallery_triangle(v);
    q = n3_patch2_make(v[0], v[1], v[2]);
    old = n3_patch2_raise(&q);
    new = n3_patch_make(v[0], v[1], v[2], NULL);
    begin(o, HEIGHT);
    draw_patch(&s, "nagata", &old);
    draw_patch(&s, "cubic", &new);
    dot(&s, v[0].x, -2, -10, "a", "", "");
    dot(&s, v[1].x, 12, 16, "b", "", "");
    dot(&s, v[2].x, -14, 12, "c", "", "");
    finish(o);
}

void draw_plane_figures(const char *folder)
{
    static const struct {
        const char *name;
        void (*draw)(output *o);
    } figures[] = {{"figure07.svg", figure07}, {"figure08.svg", figure08},
                   {"figure09.svg", figure09}, {"figure10.svg", figure10},
                   {"figure11.svg", figure11}, {"figure12.svg", figure12},
                   {"figure13.svg", figure13}, {"figure18.svg", figure18}};
    size_t i;
    for (i = 0; i < sizeof figures / sizeof *figures; i++) {
        output *o = figure_open(folder, figures[i].name, AS_TEXT);
        figures[i].draw(o);
        output_close(o);
    }
}
