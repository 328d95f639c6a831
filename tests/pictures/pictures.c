/* pictures.c: tests of PNG files, colours and what is drawn. */
#include "colour.h"
#include "deflate.h"
#include "inflate.h"
#include "mesh.h"
#include "picture_look.h"
#include "picture_scene.h"
#include "png.h"

#include <math.h>
#include <stdlib.h>

const char program[] = "pictures";

static int passed, failed;

#define CHECK(ok, row) check((ok) ? 1 : 0, #ok, __LINE__, (long)(row))
#define CHECK_NEAR(got, want, tol, row)                                                            \
    check_near((double)(got), (double)(want), (double)(tol), #got, __LINE__, (long)(row))

static void check(int ok, const char *what, int line, long row)
{
    ok ? passed++ : failed++;
    if (!ok) printf("pictures.c:%d: row %ld: %s is false\n", line, row, what);
}

static void check_near(double got, double want, double tol, const char *what, int line, long row)
{
    int ok = fabs(got - want) <= tol;
    ok ? passed++ : failed++;
    if (!ok)
        printf("pictures.c:%d: row %ld: %s = %.17g, want %.17g, tolerance %.3g\n", line, row, what,
               got, want, tol);
}

static unsigned random_byte(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 24;
}

/* ---- Files ---- */

/* Data of kinds that use every part of the format: the same byte, few bytes in long runs, all bytes
   at random, text that comes back at almost the whole window's distance and just beyond it, weights
   that would make codes longer than 15 bits. */
static unsigned char sample_byte(int kind, size_t i, uint32_t *state)
{
    static const unsigned char words[] = "the surface of the patch of the mesh ";
    unsigned r = random_byte(state), k = 0;
    if (kind == 0) return 7;
    if (kind == 1) return (unsigned char)(i / 700 % 3);
    if (kind == 2) return (unsigned char)r;
    if (kind == 3) return i % 32700 < 300 ? words[i % 37] : (unsigned char)(r | 128);
    if (kind == 4) return i % 32769 < 37 ? words[i % 32769] : (unsigned char)(r | 128);
    while (k < 40 && random_byte(state) < 158) k++; /* as frequent as the two after it together */
    return (unsigned char)k;
}

static void test_deflate(void)
{
    static const size_t sizes[] = {1, 2, 3, 4, 257, 258, 259, 32768, 32769, 200000};
    int kind;
    size_t n, i;
    for (kind = 0; kind < 6; kind++)
        for (n = 0; n < sizeof sizes / sizeof *sizes; n++) {
            bytes out = {NULL, 0, 0};
            unsigned char *data = allocate(sizes[n], 1), *back;
            uint32_t state = 1;
            size_t made = 0;
            for (i = 0; i < sizes[n]; i++) data[i] = sample_byte(kind, i, &state);
            zlib_compress(&out, data, sizes[n]);
            back = zlib_expand(out.data, out.size, &made);
            CHECK(back && made == sizes[n] && memcmp(back, data, made) == 0, kind * 100 + (long)n);
            /* A block of random bytes costs at most its codes, some 300 bytes. */
            CHECK(out.size <= sizes[n] + 310 * (1 + sizes[n] / 32768), kind * 100 + (long)n);
            if (kind == 0 && n == 9) CHECK(out.size < sizes[n] / 500, n);
            free(back);
            free(data);
            free(out.data);
        }
}

/* Grey ones, ones of few colours and of many. */
static void test_png(void)
{
    static const int sizes[][2] = {{1, 1}, {2, 1}, {1, 9}, {33, 17}, {256, 100}, {300, 301}};
    static const int type[] = {0, 3, 2, 2, 0};
    int kind, n, x, y, k, width, height;
    for (kind = 0; kind < 5; kind++)
        for (n = 0; n < 6; n++) {
            int w = sizes[n][0], h = sizes[n][1], pixels = w * h;
            unsigned char *rgb = allocate((size_t)pixels, 3), *file, *back;
            uint32_t state = 5;
            size_t size;
            for (y = 0; y < h; y++)
                for (x = 0; x < w; x++)
                    for (k = 0; k < 3; k++) {
                        int v = kind == 0   ? x * y / 8
                                : kind == 1 ? (x / 4 + y / 4) % 5 * 50 * k
                                : kind == 2 ? x * (k + 1) + y * 2
                                            : (int)random_byte(&state);
                        if (kind == 4) v = x * x / 32 + y * y / 16 + (x + 3 * y) % 3;
                        rgb[3 * (y * w + x) + k] = (unsigned char)(v & 255);
                    }
            file = png_encode(w, h, rgb, &size);
            back = png_decode(file, size, &width, &height);
            CHECK(back && width == w && height == h, kind * 10 + n);
            CHECK(back && memcmp(back, rgb, 3 * (size_t)pixels) == 0, kind * 10 + n);
            CHECK(pixels < 800 || file[25] == type[kind], kind * 10 + n);
            free(back);
            free(file);
            free(rgb);
        }
}

/* ---- Colours ---- */

static void test_oklab(void)
{
    /* White, and the primaries as Ottosson gives them. */
    static const double rows[][6] = {{1, 1, 1, 1, 0, 0},
                                     {1, 0, 0, 0.62796, 0.22486, 0.12585},
                                     {0, 1, 0, 0.86644, -0.23389, 0.17950},
                                     {0, 0, 1, 0.45201, -0.03246, -0.31153}};
    int i, k;
    for (i = 0; i < 4; i++) {
        colour c, back;
        double lab[3];
        c.r = rows[i][0];
        c.g = rows[i][1];
        c.b = rows[i][2];
        colour_to_oklab(c, lab);
        for (k = 0; k < 3; k++) CHECK_NEAR(lab[k], rows[i][3 + k], 1e-5, i);
        back = colour_oklab(lab[0], lab[1], lab[2]);
        CHECK_NEAR(back.r, c.r, 1e-6, i); /* the matrices have ten digits */
        CHECK_NEAR(back.g, c.g, 1e-6, i);
        CHECK_NEAR(back.b, c.b, 1e-6, i);
    }
    for (i = 0; i < 256; i++) {
        unsigned char rgb[3];
        colour_bytes(colour_srgb(i, 255 - i, 128), rgb);
        CHECK(rgb[0] == i && rgb[1] == 255 - i && rgb[2] == 128, i);
    }
}

/* Equal steps, and colours that a screen can show: half a level of 255 outside at most. */
static void check_map(colour (*map)(double), double lo, double hi, int steps)
{
    double before[3] = {0, 0, 0}, lab[3], first = 0;
    int i;
    for (i = 0; i <= steps; i++) {
        colour c = map(lo + (hi - lo) * i / steps);
        double step, worst = fmin(fmin(c.r, c.g), fmin(c.b, 1 - fmax(c.r, fmax(c.g, c.b))));
        colour_to_oklab(c, lab);
        CHECK(worst > -0.5 / 255 / 12.92, i);
        step = sqrt(pow(lab[0] - before[0], 2) + pow(lab[1] - before[1], 2) +
                    pow(lab[2] - before[2], 2));
        if (i == 1) first = step;
        if (i > 1) CHECK_NEAR(step, first, 1e-5 * first + 1e-7, i);
        memcpy(before, lab, sizeof lab);
    }
}

static void test_maps(void)
{
    unsigned char a[3], b[3];
    double left[3], right[3];
    check_map(colour_sequential, 0, 1, 64);
    check_map(colour_diverging, -1, 0, 32);
    check_map(colour_diverging, 0, 1, 32);
    colour_to_oklab(colour_diverging(-0.7), left);
    colour_to_oklab(colour_diverging(0.7), right);
    CHECK_NEAR(left[0], right[0], 1e-6, 0);
    colour_bytes(colour_sequential(3), a);
    colour_bytes(colour_sequential(1), b);
    CHECK(memcmp(a, b, 3) == 0, 0);
}

/* ---- Surfaces ---- */

/* z = (x^2 + s y^2) / 2 over the triangle (0, 0), (1, 0), (0, 1): exactly a quadratic patch, by its
   blossom, raised. */
static n3_patch paraboloid(double s)
{
    static const double at[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    static const int side[3][2] = {{0, 1}, {1, 2}, {0, 2}};
    n3_patch2 q;
    int i;
    for (i = 0; i < 6; i++) {
        const double *a = at[i < 3 ? i : side[i - 3][0]], *b = at[i < 3 ? i : side[i - 3][1]];
        q.p[i] = n3_v((n3_real)((a[0] + b[0]) / 2), (n3_real)((a[1] + b[1]) / 2),
                      (n3_real)((a[0] * b[0] + s * a[1] * b[1]) / 2));
    }
    return n3_patch2_raise(&q);
}

/* H = -(s (1 + x^2) + 1 + s^2 y^2) / (2 W^3), K = s / W^4, W^2 = 1 + x^2 + s^2 y^2; seen from above
   it is hollow for s > 0. */
static void test_values(void)
{
    static const double bend[] = {0, 1, -1, 0.25};
    const double eps = (double)N3_EPS;
    int i, k;
    for (i = 0; i < 4; i++)
        for (k = 0; k < 20; k++) {
            double s = bend[i], x = k % 5 / 5.0, y = k / 5 / 5.0, W = 1 + x * x + s * s * y * y;
            n3_patch p = paraboloid(s);
            spot there;
            double H = -(s * (1 + x * x) + 1 + s * s * y * y) / (2 * W * sqrt(W));
            if (x + y > 1) continue;
            /* Derivatives of size 1 from differences of points of size 1, six of them to the
               product: some ten roundings each. */
            there = patch_spot(&p, x, y);
            CHECK_NEAR(look_value(VIEW_MEAN, &there), H, 60 * eps, i * 100 + k);
            CHECK_NEAR(look_value(VIEW_GAUSS, &there), s / (W * W), 60 * eps, i * 100 + k);
        }
    { /* The triangle of the corners with s = 1 is the plane z = (x + y) / 2. */
        n3_patch p = paraboloid(1);
        spot there = patch_spot(&p, 1.0 / 3, 1.0 / 3);
        double want = (1.0 / 3 - 1.0 / 9) / sqrt(1.5);
        CHECK_NEAR(look_value(VIEW_ERROR, &there), want, 8 * eps, 0);
    }
}

static void test_names(void)
{
    static const char *const names[] = {"shaded", "zebra", "isophote", "mean",
                                        "gauss",  "net",   "error"};
    int i;
    for (i = 0; i < 7; i++) CHECK(view_find(names[i]) == i, i);
    CHECK(view_find("zebras") < 0, 0);
}

/* A square of two triangles from above, on blue: at the distance at which it fills 92 % of the
   height it covers the pixels from 4 to 95, and no others. */
static void test_square(void)
{
    static const n3_vec x[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const n3_vec up = {0, 0, 1};
    const colour blue = {0, 0, 1};
    const camera above = {0, 90, 1, 'z'};
    const panel all = {0, 0, 100, 100};
    n3_patch patch[2];
    scene s = {0, 0, NULL, NULL, NULL, NULL};
    picture p = picture_make(100, 100, blue);
    int i, k, wrong = 0;
    for (i = 0; i < 2; i++) {
        n3_vertex v[3];
        for (k = 0; k < 3; k++) {
            v[k].x = x[k ? i + k : 0];
            v[k].n = up;
        }
        patch[i] = n3_patch_make(v[0], v[1], v[2], NULL);
    }
    s.patches = 2;
    s.patch = patch;
    scene_draw(&p, all, &s, above, VIEW_ZEBRA, 0);
    for (i = 0; i < 100; i++)
        for (k = 0; k < 100; k++) {
            int inside = i >= 4 && i < 96 && k >= 4 && k < 96;
            const colour *c = &p.pixel[100 * i + k]; /* stripes are grey */
            wrong += inside ? fabs(c->r - c->b) > 1e-9 : c->r > 0;
        }
    CHECK(wrong == 0, wrong);
    picture_free(&p);
}

/* An octant of a pebble, looking outwards: its corners are the ends of the half axes. */
static n3_patch octant(int i)
{
    static const double half_axis[2][3] = {{1, 0.35, 0.7}, {0.6, 0.5, 0.9}};
    const n3_options arc = {N3_RULE_ARC, 0, 0};
    int odd = (i & 1) ^ (i >> 1 & 1) ^ (i >> 2 & 1), k;
    n3_vertex v[3];
    for (k = 0; k < 3; k++) {
        int axis = odd && k ? 3 - k : k;
        n3_real part[3] = {0, 0, 0};
        part[axis] = i >> axis & 1 ? -1 : 1;
        v[k].n = n3_v(part[0], part[1], part[2]);
        v[k].x = n3_mul((n3_real)half_axis[i >> axis & 1][axis], v[k].n);
    }
    return n3_patch_make(v[0], v[1], v[2], &arc);
}

/* The surface between two parts of the background in each row, or none of it. The background is so
   bright that one sample of it can be told: rows that see it between are not counted right. */
static int is_whole(const picture *p, int *first, int *last)
{
    int x, y, wrong = 0;
    for (y = 0; y < p->height; y++) {
        int changes = 0, inside = 0;
        for (x = 0; x < p->width; x++) {
            int on = p->pixel[p->width * y + x].r <= 2;
            changes += on != inside;
            inside = on;
            if (on && x < *first) *first = x;
            if (on && x > *last) *last = x;
        }
        wrong += changes != 0 && changes != 2;
    }
    return !wrong;
}

/* Four patches with sides of different curvature, which are cut into different numbers of parts,
   and nothing behind them, in every view: a disc without a gap, and all of it. */
static void test_whole(void)
{
    const colour bright = {1000, 0, 1000};
    const panel all = {0, 0, 200, 150};
    n3_patch patch[4];
    scene s = {0, 0, NULL, NULL, NULL, NULL};
    int i, v, turn;
    for (i = 0; i < 4; i++) patch[i] = octant((i & 1) | 2 | (i & 2) << 1); /* towards -y */
    s.patches = 4;
    s.patch = patch;
    for (v = VIEW_SHADED; v <= VIEW_ERROR; v++)
        for (turn = -10; turn <= 10; turn += 10) {
            camera c = {0, 5, 1, 'z'};
            picture p = picture_make(200, 150, bright);
            int first = 200, last = -1;
            c.turn = turn;
            scene_draw(&p, all, &s, c, (view)v, scene_range(&s, (view)v));
            CHECK(is_whole(&p, &first, &last), 100 * v + turn);
            CHECK(first > 0 && first < last && last < 199, 100 * v + turn);
            picture_free(&p);
        }
}

static int find_octant(const void *owner, int i, double u, double v, spot *out)
{
    *out = patch_spot((const n3_patch *)owner + i, u, v);
    return 1;
}

/* A surface that is told point by point looks like its patches, though the scene's own ones are
   flat: all but one in a hundred of the pixels, where stripes have their sides. */
static void test_found(void)
{
    const colour ground = {1, 0, 1};
    const camera c = {30, 20, 1, 'z'};
    const panel all = {0, 0, 200, 150};
    n3_patch patch[8], flat[8];
    scene s = {8, 0, NULL, NULL, NULL, NULL}, told = {8, 0, NULL, NULL, find_octant, NULL};
    picture p = picture_make(200, 150, ground), q = picture_make(200, 150, ground);
    int i, k, different = 0;
    for (i = 0; i < 8; i++) {
        n3_vertex v[3];
        patch[i] = octant(i);
        for (k = 0; k < 3; k++) {
            v[k].x = patch[i].p[k];
            v[k].n = n3_v(0, 0, 0);
        }
        flat[i] = n3_patch_make(v[0], v[1], v[2], NULL);
    }
    s.patch = patch;
    told.patch = flat;
    told.owner = patch;
    scene_draw(&p, all, &s, c, VIEW_ZEBRA, 0);
    scene_draw(&q, all, &told, c, VIEW_ZEBRA, 0);
    for (i = 0; i < 200 * 150; i++) different += fabs(p.pixel[i].r - q.pixel[i].r) > 0.1;
    CHECK(different <= 200 * 150 / 100, different);
    picture_free(&p);
    picture_free(&q);
}

int main(void)
{
    test_deflate();
    test_png();
    test_oklab();
    test_maps();
    test_values();
    test_names();
    test_square();
    test_whole();
    test_found();
    printf("pictures: %d passed, %d failed\n", passed, failed);
    return failed != 0;
}
