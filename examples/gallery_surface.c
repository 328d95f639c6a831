/* Figures of surfaces, as PNG: the same mesh by several rules side by side. */
#include "gallery.h"
#include "smooth_picture.h"

#include <math.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

/* ---- Meshes ---- */

static void add_vertices(mesh *m, n3_vertex a, n3_vertex b, n3_vertex c)
{
    n3_vertex v[3];
    int i;
    v[0] = a;
    v[1] = b;
    v[2] = c;
    mesh_add_triangle(m, m->points, m->points + 1, m->points + 2);
    m->cells++;
    for (i = 0; i < 3; i++) {
        m->point = room(m->point, m->points, sizeof *m->point);
        m->normal = room(m->normal, m->normals, sizeof *m->normal);
        m->point[m->points++] = v[i].x;
        m->corner[3 * m->triangles - 3 + i] = m->normals;
        m->normal[m->normals++] = v[i].n;
    }
}

/* Counterclockwise; the diagonal from a to c. */
static void add_quad(mesh *m, n3_vertex a, n3_vertex b, n3_vertex c, n3_vertex d)
{
    add_vertices(m, a, b, c);
    add_vertices(m, a, c, d);
}

static n3_vertex vertex(double x, double y, double z, double nx, double ny, double nz)
{
    n3_vertex v;
    v.x = n3_v((n3_real)x, (n3_real)y, (n3_real)z);
    v.n = n3_unit(n3_v((n3_real)nx, (n3_real)ny, (n3_real)nz));
    return v;
}

/* z = sin(3 x) cos(2 y) / 4 over a square, with its own normals. */
static n3_vertex wave_vertex(int i, int j, int n)
{
    double x = 2.4 * i / n - 1.2, y = 2.4 * j / n - 1.2;
    return vertex(x, y, sin(3 * x) * cos(2 * y) / 4, -0.75 * cos(3 * x) * cos(2 * y),
                  0.5 * sin(3 * x) * sin(2 * y), 1);
}

static void make_wave(mesh *m)
{
    const int n = 7;
    int i, j;
    for (j = 0; j < n; j++)
        for (i = 0; i < n; i++)
            add_quad(m, wave_vertex(i, j, n), wave_vertex(i + 1, j, n),
                     wave_vertex(i + 1, j + 1, n), wave_vertex(i, j + 1, n));
}

static void make_octant(mesh *m)
{
    add_vertices(m, vertex(1, 0, 0, 1, 0, 0), vertex(0, 1, 0, 0, 1, 0), vertex(0, 0, 1, 0, 0, 1));
}

static void make_triangle(mesh *m)
{
    n3_vertex v[3];
    gallery_triangle(v);
    add_vertices(m, v[0], v[2], v[1]);
}

/* Around the axis at the angle i, around the tube at the angle j; the tube's inner side is the
   saddle ring. */
static n3_vertex torus_vertex(int i, int j, int around, int tube)
{
    double a = 2 * pi * i / around, b = 2 * pi * j / tube, r = 2 + cos(b);
    return vertex(r * cos(a), r * sin(a), sin(b), cos(b) * cos(a), cos(b) * sin(a), sin(b));
}

static void make_torus(mesh *m)
{
    const int around = 16, tube = 10;
    int i, j;
    for (i = 0; i < around; i++)
        for (j = 0; j < tube; j++)
            add_quad(m, torus_vertex(i, j, around, tube), torus_vertex(i + 1, j, around, tube),
                     torus_vertex(i + 1, j + 1, around, tube),
                     torus_vertex(i, j + 1, around, tube));
}

/* ---- A bracket: a strip bent by a quarter turn, of one thickness ---- */

enum { STATIONS = 8 };

/* The station k of the profile in x and z, on the outer or the inner side. */
static n3_vertex profile(int k, int inner, double y)
{
    double radius = inner ? 0.8 : 1.4, side = inner ? -1 : 1, a;
    if (k < 2) return vertex(3 - 0.8 * k, y, 1.4 - radius, 0, 0, -side);
    if (k > 5) return vertex(1.4 - radius, y, 1.4 + 0.8 * (k - 5), -side, 0, 0);
    a = pi / 2 * (k - 2) / 3;
    return vertex(1.4 - radius * sin(a), y, 1.4 - radius * cos(a), -side * sin(a), 0,
                  -side * cos(a));
}

static n3_vertex turned(n3_vertex v, double nx, double ny, double nz)
{
    v.n = n3_v((n3_real)nx, (n3_real)ny, (n3_real)nz);
    return v;
}

static void add_bracket_slice(mesh *m, int k, double y, double width)
{
    n3_vertex o[4], i[4];
    int c;
    for (c = 0; c < 4; c++) {
        o[c] = profile(k + c % 2, 0, c < 2 ? y : y + width);
        i[c] = profile(k + c % 2, 1, c < 2 ? y : y + width);
    }
    add_quad(m, o[0], o[1], o[3], o[2]);
    add_quad(m, i[2], i[3], i[1], i[0]);
}

static void add_bracket_side(mesh *m, int k, double y, double ny)
{
    n3_vertex v[4];
    int c;
    for (c = 0; c < 4; c++) v[c] = turned(profile(k + (c == 1 || c == 2), c > 1, y), 0, ny, 0);
    if (ny > 0)
        add_quad(m, v[0], v[1], v[2], v[3]);
    else
        add_quad(m, v[3], v[2], v[1], v[0]);
}

static void add_bracket_end(mesh *m, int k, double y, double width, double nx, double nz)
{
    n3_vertex v[4];
    int c;
    for (c = 0; c < 4; c++)
        v[c] = turned(profile(k, c > 1, c == 1 || c == 2 ? y + width : y), nx, 0, nz);
    if (nx > 0)
        add_quad(m, v[0], v[1], v[2], v[3]);
    else
        add_quad(m, v[3], v[2], v[1], v[0]);
}

static void make_bracket(mesh *m)
{
    int k, row;
    for (k = 0; k + 1 < STATIONS; k++) {
        add_bracket_side(m, k, 0, -1);
        add_bracket_side(m, k, 2, 1);
        for (row = 0; row < 2; row++) add_bracket_slice(m, k, row, 1);
    }
    for (row = 0; row < 2; row++) {
        add_bracket_end(m, 0, row, 1, 1, 0);
        add_bracket_end(m, STATIONS - 1, row, 1, 0, 1);
    }
}

/* ---- A cat's head: a sphere of triangles, pulled and pushed ---- */

typedef struct pull {
    double x, y, z;    /* towards this direction, */
    double by, narrow; /* this far, within less the larger narrow is */
} pull;

/* The face looks to -y. */
static double cat_radius(n3_vec d)
{
    static const pull pulls[] = {
        {0.62, 0.1, 0.8, 0.55, 38},    {-0.62, 0.1, 0.8, 0.55, 38},    /* ears */
        {0, -1, -0.35, 0.3, 10},       {0, -1, -0.12, 0.1, 60},        /* muzzle, nose */
        {0.38, -0.85, 0.2, -0.09, 40}, {-0.38, -0.85, 0.2, -0.09, 40}, /* eyes */
        {0.8, -0.5, -0.35, 0.14, 8},   {-0.8, -0.5, -0.35, 0.14, 8},   /* cheeks */
        {0, 0.3, -1, 0.15, 4}};                                        /* neck */
    double r = 1;
    size_t i;
    for (i = 0; i < sizeof pulls / sizeof *pulls; i++) {
        n3_vec to = n3_unit(n3_v((n3_real)pulls[i].x, (n3_real)pulls[i].y, (n3_real)pulls[i].z));
        r += pulls[i].by * exp(pulls[i].narrow * ((double)n3_dot(to, d) - 1));
    }
    return r;
}

static int add_direction(mesh *m, n3_vec d)
{
    d = n3_unit(d);
    m->point = room(m->point, m->points, sizeof *m->point);
    m->point[m->points] = n3_mul((n3_real)cat_radius(d), d);
    return m->points++;
}

/* One side of an octahedron as n^2 triangles. */
static void add_octant(mesh *m, n3_vec a, n3_vec b, n3_vec c, int n)
{
    int i, j, k, up;
    for (j = 0; j < n; j++)
        for (i = 0; i < n - j; i++)
            for (up = 1; up >= (i == 0); up--) {
                static const int corner[2][3][2] = {{{0, 0}, {0, 1}, {-1, 1}},
                                                    {{0, 0}, {1, 0}, {0, 1}}};
                int p[3];
                for (k = 0; k < 3; k++) {
                    int u = i + corner[up][k][0], v = j + corner[up][k][1], w = n - u - v;
                    n3_vec d = n3_add(n3_mul((n3_real)tan(pi / 4 * w / n), a),
                                      n3_add(n3_mul((n3_real)tan(pi / 4 * u / n), b),
                                             n3_mul((n3_real)tan(pi / 4 * v / n), c)));
                    p[k] = add_direction(m, d);
                }
                mesh_add_triangle(m, p[0], p[1], p[2]);
                m->cells++;
            }
}

static void make_cat(mesh *m)
{
    int i;
    for (i = 0; i < 8; i++) {
        n3_vec x = n3_v(i & 1 ? -1 : 1, 0, 0), y = n3_v(0, i & 2 ? -1 : 1, 0);
        n3_vec z = n3_v(0, 0, i & 4 ? -1 : 1);
        int odd = (i & 1) ^ (i >> 1 & 1) ^ (i >> 2 & 1);
        add_octant(m, z, odd ? y : x, odd ? x : y, 7);
    }
}

/* ---- Panels ---- */

typedef struct column {
    const char *rule, *title;
} column;

enum { COLUMNS = 3, WIDTH = 330, HEIGHT = 280, TITLE = 28, GAP = 12 }; /* pixels */

/* A row for each view, a column for each rule; all from the same place, with the same ranges. */
typedef struct plate {
    const char *name;
    void (*make)(mesh *m);
    column column[COLUMNS]; /* the last one may be absent */
    int rows;
    view view[2];
    camera camera;
} plate;

/* The range of maps is that of the last column. */
static void draw_column(picture *p, const plate *d, int k, const scene *s, const scene *last)
{
    const colour ink = colour_oklab(0.3, 0, 0);
    panel f = {0, 0, WIDTH, HEIGHT};
    int row;
    f.x = k * (WIDTH + GAP);
    for (row = 0; row < d->rows; row++) {
        f.y = TITLE + row * HEIGHT;
        scene_draw(p, f, s, d->camera, d->view[row], scene_range(last, d->view[row]));
    }
    picture_text(p, f.x + WIDTH / 2.0, TITLE - 6, 11, 0, ink, d->column[k].title);
}

/* The mesh by each rule, all framed alike. Returns how many. */
static int make_scenes(const plate *d, scene *all)
{
    mesh m;
    int columns, k, i;
    memset(&m, 0, sizeof m);
    d->make(&m);
    mesh_join(&m, 0);
    for (columns = 0; columns < COLUMNS && d->column[columns].rule; columns++) {
        const smooth_rule *rule = smooth_rule_find(d->column[columns].rule);
        surface s;
        surface_make(d->name, &m, rule, cos(50 * pi / 180), &s);
        surface_scene(&s, &all[columns]);
        surface_free(&s);
    }
    mesh_free(&m);
    for (k = 0; k < columns; k++) {
        if (d->view[0] == VIEW_NET) scene_add_net(&all[k]);
        for (i = 0; i < columns; i++) scene_add_room(&all[k], &all[i]);
    }
    return columns;
}

static void draw_plate(output *o, const plate *d)
{
    scene all[COLUMNS];
    int columns = make_scenes(d, all), k;
    picture p = picture_make(columns * (WIDTH + GAP) - GAP, TITLE + d->rows * HEIGHT,
                             colour_srgb(255, 255, 255));
    unsigned char *file;
    size_t size;
    for (k = 0; k < columns; k++) draw_column(&p, d, k, &all[k], &all[columns - 1]);
    for (k = 0; k < columns; k++) scene_free(&all[k]);
    file = picture_png(&p, &size);
    put_bytes(o, file, size);
    free(file);
    picture_free(&p);
}

#define OLD  "nagata", "Nagata's patch"
#define NEW  "paper", "the cubic patch"
#define ARC  "arc", "the arc rule"
#define FIT  "fit", "the fit rule"
#define FLAT "flat", "the triangles"

static const plate plates[] = {
    {"figure06.png", make_wave, {{OLD}, {NEW}}, 1, {VIEW_SHADED}, {20, 40, 1, 'z'}},
    {"figure16.png", make_octant, {{OLD}, {NEW}}, 1, {VIEW_ZEBRA}, {135, 35, 1, 'z'}},
    {"figure17.png", make_triangle, {{OLD}, {NEW}}, 1, {VIEW_NET}, {14, 34, 1, 'z'}},
    {"torus.png", make_torus, {{OLD}, {NEW}, {FIT}}, 1, {VIEW_ZEBRA}, {15, 50, 1.35, 'z'}},
    {"bracket.png",
     make_bracket,
     {{OLD}, {NEW}, {ARC}},
     2,
     {VIEW_ZEBRA, VIEW_MEAN},
     {60, 28, 1, 'z'}},
    {"cat.png", make_cat, {{FLAT}, {OLD}, {NEW}}, 2, {VIEW_SHADED, VIEW_ZEBRA}, {25, 12, 1, 'z'}}};

void draw_surface_figures(const char *folder)
{
    size_t i;
    for (i = 0; i < sizeof plates / sizeof *plates; i++) {
        output *o = figure_open(folder, plates[i].name, LITTLE);
        draw_plate(o, &plates[i]);
        output_close(o);
    }
}
