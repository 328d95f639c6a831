/* figure7 > figure7.svg: why the patch is cubic, after figure 7 of the paper.
 *
 * The normals at a and b lean by 20 degrees along their edge and are 5 degrees apart, so that the
 * two tangent planes meet far beside the chord. Nagata's parabola has its middle control point
 * there; the cubic edge stays in a plane that stands across both tangent planes. */
#include "nagata3.h"

#include <stdio.h>

enum { LINES = 10, STEPS = 24, SAMPLES = 1000 };

static const double degree = 3.14159265358979323846 / 180, lean = 20, apart = 5;

/* Where the origin of space lies in the picture, and the pixels per unit. */
typedef struct view { double x, y, scale; n3_vec right, up; } view;

static const char *const style =
    "<style>\n"
    "  rect { fill: #ffffff }\n"
    "  text { font: 17px sans-serif; fill: #1f2328; text-anchor: middle }\n"
    "  .note { font-size: 15px; fill: #59636e }\n"
    "  path { fill: none; stroke-linejoin: round; stroke-linecap: round }\n"
    "  .chord { stroke: #59636e; stroke-width: 1.5; stroke-dasharray: 4 5 }\n"
    "  .normal { stroke: #1a7f37; stroke-width: 2.5 }\n"
    "  .nagata { stroke: #cf222e }\n"
    "  .cubic { stroke: #0969da }\n"
    "  .line { stroke-width: 0.7 }\n"
    "  .side { stroke-width: 3 }\n"
    "  @media (prefers-color-scheme: dark) {\n"
    "    rect { fill: #0d1117 }\n"
    "    text { fill: #f0f6fc }\n"
    "    .note { fill: #9198a1 }\n"
    "    .chord { stroke: #9198a1 }\n"
    "    .normal { stroke: #3fb950 }\n"
    "    .nagata { stroke: #ff7b72 }\n"
    "    .cubic { stroke: #58a6ff }\n"
    "  }\n"
    "</style>\n";

static view view_make(double x, double y, double scale)
{
    double turn = 14 * degree, rise = 34 * degree;
    view s;
    s.x = x;
    s.y = y;
    s.scale = scale;
    s.right = n3_v(cos(turn), sin(turn), 0);
    s.up = n3_v(-sin(turn) * sin(rise), cos(turn) * sin(rise), cos(rise));
    return s;
}

static double view_x(const view *s, n3_vec p) { return s->x + s->scale * n3_dot(s->right, p); }
static double view_y(const view *s, n3_vec p) { return s->y - s->scale * n3_dot(s->up, p); }

static void path_to(const view *s, const char *command, n3_vec p)
{
    printf("%s%.1f %.1f", command, view_x(s, p), view_y(s, p));
}

static void draw_straight(const view *s, const char *kind, n3_vec p, n3_vec q)
{
    printf("<path class=\"%s\" d=\"", kind);
    path_to(s, "M", p);
    path_to(s, "L", q);
    printf("\"/>\n");
}

static void draw_edge(const view *s, const char *kind, const n3_edge *e)
{
    printf("<path class=\"%s side\" d=\"", kind);
    path_to(s, "M", e->p[0]);
    path_to(s, "C", e->p[1]);
    path_to(s, " ", e->p[2]);
    path_to(s, " ", e->p[3]);
    printf("\"/>\n");
}

/* The line on the patch along which the weight of one corner is constant. */
static void draw_line(const view *s, const char *kind, const n3_patch *p, int corner, double weight)
{
    int i;
    printf("<path class=\"%s line\" d=\"", kind);
    for (i = 0; i <= STEPS; i++) {
        double w[3];
        w[corner] = weight;
        w[(corner + 1) % 3] = (1 - weight) * i / STEPS;
        w[(corner + 2) % 3] = (1 - weight) * (STEPS - i) / STEPS;
        path_to(s, i ? "L" : "M", n3_patch_point(p, w[1], w[2]));
    }
    printf("\"/>\n");
}

static void draw_patch(const view *s, const char *kind, const n3_patch *p)
{
    n3_edge edge[3];
    int k, i;
    n3_patch_edges(p, edge);
    for (k = 0; k < 3; k++) {
        for (i = 1; i < LINES; i++) draw_line(s, kind, p, k, (double)i / LINES);
        draw_edge(s, kind, &edge[k]);
    }
}

/* The corners and normals, which are all that a patch is made from. */
static void draw_corners(const view *s, const n3_vertex v[3])
{
    static const double dx[3] = {-14, 16, 0}, dy[3] = {6, 6, 20};
    int i;
    for (i = 0; i < 3; i++) {
        n3_vec x = v[i].x;
        draw_straight(s, "chord", x, v[(i + 1) % 3].x);
        draw_straight(s, "normal", x, n3_add(x, n3_mul(0.35, v[i].n)));
        printf("<text x=\"%.1f\" y=\"%.1f\">%c</text>\n", view_x(s, x) + dx[i],
               view_y(s, x) + dy[i], 'a' + i);
    }
}

/* The largest distance of the side ab from its chord, which is the x axis from 0 to 1. */
static double bulge(const n3_patch *p)
{
    double largest = 0;
    int i;
    for (i = 0; i <= SAMPLES; i++) {
        n3_vec x = n3_patch_point(p, (double)i / SAMPLES, 0);
        largest = fmax(largest, n3_len(n3_v(0, x.y, x.z)));
    }
    return largest;
}

static void draw_panel(double x, const char *kind, const char *name, const n3_patch *p,
                       const n3_vertex v[3])
{
    view s = view_make(x - 87, 282, 175);
    draw_patch(&s, kind, p);
    draw_corners(&s, v);
    printf("<text x=\"%.1f\" y=\"30\">%s</text>\n", x, name);
    printf("<text class=\"note\" x=\"%.1f\" y=\"53\">ab bulges by %.3f of its length</text>\n", x,
           bulge(p));
}

int main(void)
{
    double A = lean * degree, delta = apart * degree;
    n3_vertex v[3];
    n3_patch2 q;
    n3_patch nagata, cubic;
    v[0].x = n3_v(0, 0, 0);
    v[1].x = n3_v(1, 0, 0);
    v[2].x = n3_v(0.45, -0.85, 0);
    v[0].n = n3_v(-sin(A), 0, cos(A));
    v[1].n = n3_v(-sin(A), -cos(A) * sin(delta), cos(A) * cos(delta));
    v[2].n = n3_v(sin(A), 0, cos(A));
    q = n3_patch2_make(v[0], v[1], v[2]);
    nagata = n3_patch2_raise(&q);
    cubic = n3_patch_make(v[0], v[1], v[2], NULL);
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 440\">\n%s", style);
    printf("<rect width=\"700\" height=\"440\" rx=\"8\"/>\n");
    draw_panel(175, "nagata", "Nagata's patch, quadratic", &nagata, v);
    draw_panel(525, "cubic", "the cubic patch", &cubic, v);
    printf("<text class=\"note\" x=\"350\" y=\"424\">the same corners and normals: those at "
           "a and b lean %.0f&#176; along ab, %.0f&#176; apart</text>\n", lean, apart);
    printf("</svg>\n");
    return 0;
}
