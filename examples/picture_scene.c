/* From patches to samples, from samples to pixels. */
#include "picture_scene.h"

#include "mesh.h"
#include "picture_look.h"

#include <math.h>
#include <stdlib.h>

enum { SIDE = 4, BAND = 32 }; /* samples along a pixel; rows of pixels that are made at once */
enum { FINEST = 256 };        /* parts of a side */
enum { OUTLINE = 15 };        /* points of a patch by which it is framed */
enum { CURVE = 24 };          /* strokes of an edge */

static const double degree = 3.14159265358979323846 / 180;
static const double field_of_view = 26; /* degrees, over the height */
static const double margin = 0.92;      /* of the panel that the scene fills */
static const double chord_error = 0.08; /* pixels */
static const double lift = 0.004;       /* of strokes towards the eye, in sizes of the scene */

/* ---- Strokes ---- */

void scene_add_stroke(scene *s, n3_vec p, n3_vec q, double width, colour c)
{
    stroke *t;
    s->stroke = room(s->stroke, s->strokes, sizeof *s->stroke);
    t = &s->stroke[s->strokes++];
    t->p[0] = p;
    t->p[1] = q;
    t->width = width;
    t->c = c;
}

void scene_add_edge(scene *s, const n3_edge *e, double width, colour c)
{
    n3_vec from = e->p[0];
    int i;
    for (i = 1; i <= CURVE; i++) {
        n3_vec to = n3_edge_point(e, (n3_real)i / CURVE);
        scene_add_stroke(s, from, to, width, c);
        from = to;
    }
}

void scene_add_net(scene *s)
{
    static const int line[18][2] = {{0, 3}, {3, 4}, {4, 1}, {1, 5}, {5, 6}, {6, 2},
                                    {2, 7}, {7, 8}, {8, 0}, {3, 8}, {4, 9}, {9, 7},
                                    {5, 9}, {9, 8}, {3, 9}, {4, 5}, {9, 6}, {7, 6}};
    const colour curve = colour_oklab(0.3, 0, 0), net = colour_oklab(0.5, 0.15, 0.08);
    int i, k;
    for (i = 0; i < s->patches; i++) {
        const n3_vec *p = s->patch[i].p;
        n3_edge e[3];
        n3_patch_edges(&s->patch[i], e);
        for (k = 0; k < 3; k++) scene_add_edge(s, &e[k], 1.6, curve);
        for (k = 0; k < 18; k++) scene_add_stroke(s, p[line[k][0]], p[line[k][1]], 1, net);
        for (k = 0; k < 10; k++) scene_add_stroke(s, p[k], p[k], 4, net);
    }
}

/* ---- The surface ---- */

spot patch_spot(const n3_patch *p, double u, double v)
{
    spot s;
    s.jet = n3_patch_jet(p, (n3_real)u, (n3_real)v);
    s.jet.x = n3_patch_point(p, (n3_real)u, (n3_real)v);
    s.normal = n3_patch_normal(p, (n3_real)u, (n3_real)v);
    memcpy(s.corner, p->p, sizeof s.corner);
    return s;
}

/* Its places, its derivatives, its normal. */
enum { PLACES = 4, LENGTHS = 9, VECTORS = 10 };

static void spot_vectors(spot *s, n3_vec *v[VECTORS])
{
    v[0] = &s->jet.x;
    v[1] = &s->corner[0];
    v[2] = &s->corner[1];
    v[3] = &s->corner[2];
    v[4] = &s->jet.du;
    v[5] = &s->jet.dv;
    v[6] = &s->jet.duu;
    v[7] = &s->jet.duv;
    v[8] = &s->jet.dvv;
    v[9] = &s->normal;
}

/* The spot with the origin there and in the unit. */
static void shift_spot(spot *s, n3_vec origin, double unit)
{
    n3_vec *v[VECTORS];
    int i;
    spot_vectors(s, v);
    for (i = 0; i < PLACES; i++) *v[i] = n3_sub(*v[i], origin);
    for (i = 0; i < LENGTHS; i++) *v[i] = n3_mul((n3_real)(1 / unit), *v[i]);
}

static int find(const scene *s, int i, double u, double v, spot *out)
{
    return s->find && s->find(s->owner, i, u, v, out);
}

/* Points of the surface that tell its extent: the k-th of the triangle i. */
static n3_vec outline_point(const scene *s, int i, int k)
{
    static const int place[OUTLINE][2] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0},
                                          {0, 1}, {1, 1}, {2, 1}, {3, 1}, {0, 2},
                                          {1, 2}, {2, 2}, {0, 3}, {1, 3}, {0, 4}};
    double u = place[k][0] / 4.0, v = place[k][1] / 4.0;
    spot there;
    if (find(s, i, u, v, &there)) return there.jet.x;
    return n3_patch_point(&s->patch[i], (n3_real)u, (n3_real)v);
}

/* Lines without a width take room and are not seen. */
void scene_add_room(scene *s, const scene *other)
{
    const colour none = {0, 0, 0};
    int i, k;
    for (i = 0; i < other->patches; i++)
        for (k = 0; k < OUTLINE; k++) {
            n3_vec x = outline_point(other, i, k);
            scene_add_stroke(s, x, x, 0, none);
        }
}

void scene_free(scene *s)
{
    free(s->patch);
    free(s->stroke);
}

/* ---- Ranges ---- */

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* To a number of one digit. */
static double round_up(double x)
{
    double unit = pow(10, floor(log10(x)));
    return ceil(x / unit) * unit;
}

/* The patch in the size of 1, at the origin; returns its size. */
static double to_unit(n3_patch *p)
{
    const n3_vec origin = p->p[0];
    n3_real size = 0;
    int i;
    for (i = 0; i < 10; i++) {
        n3_real length = n3_len(p->p[i] = n3_sub(p->p[i], origin));
        if (length > size) size = length;
    }
    for (i = 0; i < 10 && size > 0; i++)
        p->p[i] = n3_v(p->p[i].x / size, p->p[i].y / size, p->p[i].z / size);
    return (double)size;
}

double scene_range(const scene *s, view v)
{
    double *value, range = 0;
    int i, k, n = 0;
    if (v != VIEW_MEAN && v != VIEW_GAUSS && v != VIEW_ERROR) return 0;
    value = allocate((size_t)s->patches, 6 * sizeof *value);
    for (i = 0; i < s->patches; i++) {
        n3_patch p = s->patch[i];
        double unit = to_unit(&p);
        for (k = 0; k < 6; k++, n++) { /* inside, on two rings */
            double far_off = k < 3 ? 0.8 : 0.45, rest = (1 - far_off) / 2;
            double u = k % 3 == 1 ? far_off : rest, w = k % 3 == 2 ? far_off : rest;
            spot there = patch_spot(&p, u, w);
            if (find(s, i, u, w, &there)) shift_spot(&there, s->patch[i].p[0], unit);
            value[n] = fabs(look_value(v, &there)) * look_unit(v, unit);
            if (!(value[n] < HUGE_VAL)) value[n] = 0;
        }
    }
    qsort(value, (size_t)n, sizeof *value, compare);
    if (n) range = v == VIEW_ERROR ? value[n - 1] : value[(int)((n - 1) * 0.95)];
    free(value);
    return range > 0 ? round_up(range) : 1;
}

/* ---- Camera ---- */

/* What the camera does to a point: into its axes, around the middle of the scene, in its size. */
typedef struct pose {
    n3_vec right, up, back, middle;
    double unit, eye;     /* z of the eye */
    double focus, cx, cy; /* pixels */
} pose;

static n3_vec turn(const pose *c, n3_vec x)
{
    return n3_v(n3_dot(c->right, x), n3_dot(c->up, x), n3_dot(c->back, x));
}

static n3_vec to_camera(const pose *c, n3_vec x)
{
    return turn(c, n3_mul((n3_real)(1 / c->unit), n3_sub(x, c->middle)));
}

/* A point that is seen somewhere: samples across, samples down, 1 / distance from the eye. */
typedef struct seen {
    double x, y, nearness;
    double u, v; /* of the patch, times nearness */
} seen;

static seen project(const pose *c, n3_vec x)
{
    seen s = {0, 0, 0, 0, 0};
    s.nearness = 1 / fmax(c->eye - (double)x.z, 0.01);
    s.x = (c->cx + c->focus * x.x * s.nearness) * SIDE;
    s.y = (c->cy - c->focus * x.y * s.nearness) * SIDE;
    return s;
}

/* The box of the outline and the strokes, in the axes of the pose as it stands. */
static void find_box(const scene *s, const pose *c, n3_vec *lo, n3_vec *hi)
{
    int i, k;
    for (i = 0; i < s->patches; i++)
        for (k = 0; k < OUTLINE; k++) {
            n3_vec x = to_camera(c, outline_point(s, i, k));
            if (i + k == 0) *lo = *hi = x;
            box_add(lo, hi, x);
        }
    for (i = 0; i < 2 * s->strokes; i++) box_add(lo, hi, to_camera(c, s->stroke[i / 2].p[i % 2]));
}

static double distance_for(const pose *c, n3_vec x, panel f)
{
    double across = fabs(x.x) * c->focus / (margin * f.width / 2);
    double up = fabs(x.y) * c->focus / (margin * f.height / 2);
    return x.z + fmax(across, up);
}

/* As near as lets every point be in the panel, and outside of the scene, which is of radius 1. */
static void step_back(const scene *s, pose *c, panel f)
{
    int i, k;
    c->eye = 2;
    for (i = 0; i < s->patches; i++)
        for (k = 0; k < OUTLINE; k++)
            c->eye = fmax(c->eye, distance_for(c, to_camera(c, outline_point(s, i, k)), f));
    for (i = 0; i < 2 * s->strokes; i++)
        c->eye = fmax(c->eye, distance_for(c, to_camera(c, s->stroke[i / 2].p[i % 2]), f));
}

/* x y z, with the axis that is up in the last place. */
static n3_vec turn_axes(double x, double y, double z, int up)
{
    if (up == 'x') return n3_v((n3_real)z, (n3_real)x, (n3_real)y);
    if (up == 'y') return n3_v((n3_real)y, (n3_real)z, (n3_real)x);
    return n3_v((n3_real)x, (n3_real)y, (n3_real)z);
}

static pose pose_make(const scene *s, camera c, panel f)
{
    double ct = cos(c.turn * degree), st = sin(c.turn * degree);
    double cr = cos(c.rise * degree), sr = sin(c.rise * degree);
    n3_vec lo = {0, 0, 0}, hi = {0, 0, 0}, m;
    pose p = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1, 0, 0, 0, 0};
    p.right = turn_axes(ct, st, 0, c.up);
    p.back = turn_axes(st * cr, -ct * cr, sr, c.up);
    p.up = n3_cross(p.back, p.right);
    if (s->patches) p.middle = s->patch[0].p[0];
    find_box(s, &p, &lo, &hi);
    m = n3_mul((n3_real)1 / 2, n3_add(lo, hi));
    p.middle = n3_add(p.middle,
                      n3_add(n3_add(n3_mul(m.x, p.right), n3_mul(m.y, p.up)), n3_mul(m.z, p.back)));
    p.unit = (double)n3_len(n3_sub(hi, lo)) / 2;
    if (!(p.unit > 0)) p.unit = 1;
    p.focus = f.height / 2.0 / tan(field_of_view / 2 * degree);
    p.cx = f.width / 2.0;
    p.cy = f.height / 2.0;
    step_back(s, &p, f);
    p.focus *= c.zoom;
    return p;
}

/* ---- Samples ---- */

/* What a sample sees: a patch, or behind these a stroke; -1 for nothing. */
typedef struct sample {
    float nearness, u, v;
    int item;
} sample;

/* Rows of samples from top to end. */
typedef struct band {
    int width, top, end;
    sample *row;
} band;

static void see(const band *b, int x, int y, double nearness, int item, double u, double v)
{
    sample *s = &b->row[(size_t)(y - b->top) * (size_t)b->width + (size_t)x];
    if (!(nearness > (double)s->nearness)) return;
    s->nearness = (float)nearness;
    s->item = item;
    s->u = (float)u;
    s->v = (float)v;
}

static int clamp(double x, int lo, int hi) { return x > lo ? x < hi ? (int)x : hi : lo; }

/* Twice the area of a, b and (x, y), positive where they run counterclockwise, y upwards. */
static double area(const seen *a, const seen *b, double x, double y)
{
    return (b->y - a->y) * (x - a->x) - (b->x - a->x) * (y - a->y);
}

/* Samples on a side shared by two triangles belong to both: no gap, and which is in front does not
   matter. What is linear on the screen is nearness, u and v times nearness. */
static void fill_triangle(const band *b, int item, const seen *p, const seen *q, const seen *r)
{
    const double slack = 1e-9;
    double whole = area(p, q, r->x, r->y);
    int x, y, left = clamp(fmin(p->x, fmin(q->x, r->x)) - 0.5, 0, b->width);
    int right = clamp(fmax(p->x, fmax(q->x, r->x)) + 0.5, 0, b->width);
    int end = clamp(fmax(p->y, fmax(q->y, r->y)) + 0.5, b->top, b->end);
    if (!(fabs(whole) > 0)) return;
    for (y = clamp(fmin(p->y, fmin(q->y, r->y)) - 0.5, b->top, b->end); y < end; y++)
        for (x = left; x < right; x++) {
            double i = area(q, r, x + 0.5, y + 0.5) / whole;
            double j = area(r, p, x + 0.5, y + 0.5) / whole, k = 1 - i - j, nearness;
            if (i < -slack || j < -slack || k < -slack) continue;
            nearness = i * p->nearness + j * q->nearness + k * r->nearness;
            see(b, x, y, nearness, item, (i * p->u + j * q->u + k * r->u) / nearness,
                (i * p->v + j * q->v + k * r->v) / nearness);
        }
}

static void fill_stroke(const band *b, int item, const seen *p, const seen *q, double width)
{
    double dx = q->x - p->x, dy = q->y - p->y, square = dx * dx + dy * dy, reach = width / 2;
    int x, y, left = clamp(fmin(p->x, q->x) - reach, 0, b->width);
    int right = clamp(fmax(p->x, q->x) + reach + 1, 0, b->width);
    int end = clamp(fmax(p->y, q->y) + reach + 1, b->top, b->end);
    for (y = clamp(fmin(p->y, q->y) - reach, b->top, b->end); y < end; y++)
        for (x = left; x < right; x++) {
            double px = x + 0.5 - p->x, py = y + 0.5 - p->y, t = px * dx + py * dy;
            t = square > 0 ? fmin(1, fmax(0, t / square)) : 0;
            if (hypot(px - t * dx, py - t * dy) <= reach)
                see(b, x, y, p->nearness + t * (q->nearness - p->nearness), item, 0, 0);
        }
}

/* ---- Patches into triangles ---- */

/* In the camera's axes, with the parts of its sides and of the whole, and the rows that it and its
   net are seen in. */
typedef struct shape {
    n3_patch p;
    int level, side[3];
    double top, end;
} shape;

/* All that a picture is made from. */
typedef struct shot {
    const scene *scene;
    pose pose;
    shape *shape;
    look look;
} shot;

static spot shot_spot(const shot *t, int i, double u, double v)
{
    n3_vec *part[VECTORS];
    spot s;
    int k;
    if (!find(t->scene, i, u, v, &s)) return patch_spot(&t->shape[i].p, u, v);
    shift_spot(&s, t->pose.middle, t->pose.unit);
    spot_vectors(&s, part);
    for (k = 0; k < VECTORS; k++) *part[k] = turn(&t->pose, *part[k]);
    return s;
}

static n3_vec shot_point(const shot *t, int i, double u, double v)
{
    if (t->scene->find) return shot_spot(t, i, u, v).jet.x;
    return n3_patch_point(&t->shape[i].p, (n3_real)u, (n3_real)v);
}

static double second_difference(n3_vec a, n3_vec b, n3_vec c)
{
    return (double)n3_len(n3_add(n3_sub(a, b), n3_sub(c, b)));
}

/* A curve's chord over the n-th part of it is off by at most 6 |second difference| / (8 n^2). */
static int parts(const pose *c, double difference)
{
    double pixels = difference * c->focus / (c->eye - 1);
    return clamp(ceil(sqrt(0.75 * pixels / chord_error)), 1, FINEST);
}

/* A side has the same parts from both its patches, as they come from its own points alone. */
static void set_levels(const pose *c, shape *s)
{
    static const int inner[3][3] = {{8, 9, 5}, {3, 9, 6}, {4, 9, 7}};
    n3_edge e[3];
    int i;
    n3_patch_edges(&s->p, e);
    s->level = 1;
    for (i = 0; i < 3; i++) {
        double d0 = second_difference(e[i].p[0], e[i].p[1], e[i].p[2]);
        double d1 = second_difference(e[i].p[1], e[i].p[2], e[i].p[3]);
        const int *k = inner[i];
        s->side[i] = parts(c, fmax(d0, d1));
        d0 = 1.34 * second_difference(s->p.p[k[0]], s->p.p[k[1]], s->p.p[k[2]]);
        if (s->side[i] > s->level) s->level = s->side[i];
        if (parts(c, d0) > s->level) s->level = parts(c, d0);
    }
}

/* The place of the lattice point (i, j) among those of the outline. */
static int outline_place(int i, int j) { return j * 5 - j * (j - 1) / 2 + i; }

/* The same where the surface is no patch, from the second differences of its points a quarter of a
   side apart, in each direction. A chord is off by 2 of these over n^2; they are taken twice, as
   they do not reach the ends. Sides that are shared have the same points, and so the same parts. */
static void sample_levels(const shot *t, int item, shape *s)
{
    static const int way[3][2] = {{1, 0}, {-1, 1}, {0, 1}};
    n3_vec x[OUTLINE];
    int i, j, k;
    for (k = 0; k < OUTLINE; k++) x[k] = to_camera(&t->pose, outline_point(t->scene, item, k));
    s->level = s->side[0] = s->side[1] = s->side[2] = 1;
    for (k = 0; k < 3; k++)
        for (j = 0; j <= 4; j++)
            for (i = 0; i + j <= 4; i++) {
                int p = i + 2 * way[k][0], q = j + 2 * way[k][1], n;
                int on_side = k == 0 ? j == 0 : k == 1 ? i + j == 4 : i == 0;
                if (p < 0 || p + q > 4) continue;
                n = parts(&t->pose,
                          16 / 3.0 *
                              second_difference(x[outline_place(i, j)],
                                                x[outline_place((i + p) / 2, (j + q) / 2)],
                                                x[outline_place(p, q)]));
                if (on_side && n > s->side[k]) s->side[k] = n;
                if (n > s->level) s->level = n;
            }
}

static void widen(shape *s, double y)
{
    s->top = fmin(s->top, y);
    s->end = fmax(s->end, y);
}

/* A curve that is no patch's may leave the net; its points tell how far. */
static shape shape_make(const shot *t, int i)
{
    const pose *c = &t->pose;
    shape s;
    int k;
    s.top = HUGE_VAL;
    s.end = -HUGE_VAL;
    for (k = 0; k < 10; k++) {
        s.p.p[k] = to_camera(c, t->scene->patch[i].p[k]);
        widen(&s, project(c, s.p.p[k]).y);
    }
    for (k = 0; k < OUTLINE && t->scene->find; k++)
        widen(&s, project(c, to_camera(c, outline_point(t->scene, i, k))).y);
    if (t->scene->find) {
        double more = (s.end - s.top) / 4;
        s.top -= more;
        s.end += more;
    }
    set_levels(c, &s);
    if (t->scene->find) sample_levels(t, i, &s);
    return s;
}

/* The i-th of n + 1 places on a side, moved to the nearest of those that its curve has. */
static double snapped(int i, int n, int curve)
{
    return floor((double)i * curve / n + 0.5) / curve;
}

/* The lattice point (i, j): u = i / n, v = j / n, on a side where the side has one. */
static seen shape_point(const shot *t, int item, int i, int j)
{
    const shape *s = &t->shape[item];
    int n = s->level;
    double u = (double)i / n, v = (double)j / n;
    seen at;
    if (j == 0)
        u = snapped(i, n, s->side[0]);
    else if (i == 0)
        v = snapped(j, n, s->side[2]);
    else if (i + j == n)
        u = 1 - (v = snapped(j, n, s->side[1]));
    at = project(&t->pose, shot_point(t, item, u, v));
    at.u = u * at.nearness;
    at.v = v * at.nearness;
    return at;
}

static void fill_shape(const band *b, const shot *t, int item)
{
    seen row[2][FINEST + 1];
    int i, j, n = t->shape[item].level;
    for (i = 0; i <= n; i++) row[0][i] = shape_point(t, item, i, 0);
    for (j = 0; j < n; j++) {
        const seen *low = row[j % 2];
        seen *high = row[(j + 1) % 2];
        for (i = 0; i < n - j; i++) {
            high[i] = shape_point(t, item, i, j + 1);
            fill_triangle(b, item, &low[i], &low[i + 1], &high[i]);
            if (i > 0) fill_triangle(b, item, &low[i], &high[i], &high[i - 1]);
        }
    }
}

/* ---- The whole ---- */

static void fill_strokes(const band *b, const shot *t)
{
    const scene *s = t->scene;
    int i, k;
    for (i = 0; i < s->strokes; i++) {
        seen p[2];
        for (k = 0; k < 2; k++) {
            n3_vec x = to_camera(&t->pose, s->stroke[i].p[k]);
            x.z += (n3_real)lift;
            p[k] = project(&t->pose, x);
        }
        if (s->stroke[i].width > 0)
            fill_stroke(b, s->patches + i, &p[0], &p[1], s->stroke[i].width * SIDE);
    }
}

static void fill_band(const band *b, const shot *t)
{
    int i;
    for (i = 0; i < b->width * (b->end - b->top); i++) {
        b->row[i].nearness = 0;
        b->row[i].item = -1;
    }
    for (i = 0; i < t->scene->patches; i++)
        if (t->shape[i].top < b->end + 1 && t->shape[i].end > b->top - 1) fill_shape(b, t, i);
    fill_strokes(b, t);
}

static colour sample_colour(const sample *at, const shot *t)
{
    spot there;
    if (at->item >= t->scene->patches) return t->scene->stroke[at->item - t->scene->patches].c;
    there = shot_spot(t, at->item, (double)at->u, (double)at->v);
    return look_colour(&t->look, &there);
}

/* A pixel is the mean of its samples, in light; those that see nothing leave what is there. */
static colour pixel_colour(const band *b, int x, int y, colour before, const shot *t)
{
    colour sum = {0, 0, 0};
    int k;
    for (k = 0; k < SIDE * SIDE; k++) {
        size_t row = (size_t)(y * SIDE + k / SIDE - b->top);
        const sample *at = &b->row[row * (size_t)b->width + (size_t)(x * SIDE + k % SIDE)];
        colour c = at->item < 0 ? before : sample_colour(at, t);
        sum.r += c.r / (SIDE * SIDE);
        sum.g += c.g / (SIDE * SIDE);
        sum.b += c.b / (SIDE * SIDE);
    }
    return sum;
}

static void resolve(const band *b, picture *out, panel f, const shot *t)
{
    int x, y;
    for (y = b->top / SIDE; y < b->end / SIDE; y++)
        for (x = 0; x < f.width; x++) {
            int px = f.x + x, py = f.y + y;
            colour *pixel;
            if (px < 0 || py < 0 || px >= out->width || py >= out->height) continue;
            pixel = &out->pixel[(size_t)py * (size_t)out->width + (size_t)px];
            *pixel = pixel_colour(b, x, y, *pixel, t);
        }
}

static shot shot_make(const scene *s, camera c, panel f, view v, double range)
{
    shot t;
    int i;
    t.scene = s;
    t.pose = pose_make(s, c, f);
    t.look.v = v;
    t.look.range = range;
    t.look.unit = t.pose.unit;
    t.look.eye = t.pose.eye;
    t.shape = allocate((size_t)s->patches, sizeof *t.shape);
    for (i = 0; i < s->patches; i++) t.shape[i] = shape_make(&t, i);
    return t;
}

void scene_draw(picture *out, panel f, const scene *s, camera c, view v, double range)
{
    panel inner = f;
    shot t;
    band b;
    inner.height -= look_legend_height(f, v);
    t = shot_make(s, c, inner, v, range);
    b.width = inner.width * SIDE;
    b.row = allocate((size_t)b.width, BAND * SIDE * sizeof *b.row);
    for (b.top = 0; b.top < inner.height * SIDE; b.top = b.end) {
        b.end = b.top + BAND * SIDE;
        if (b.end > inner.height * SIDE) b.end = inner.height * SIDE;
        fill_band(&b, &t);
        resolve(&b, out, inner, &t);
    }
    look_legend(out, f, v, range);
    free(b.row);
    free(t.shape);
}
