#include "shapes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

static void *memory(size_t count, size_t size)
{
    void *p = calloc(count + 1, size);
    if (!p) abort();
    return p;
}

static n3_vec vec(double x, double y, double z) { return n3_v((n3_real)x, (n3_real)y, (n3_real)z); }

/* Room for so much; the counts start at 0 and grow by the add functions. */
static shape shape_room(int points, int triangles, int normals)
{
    shape s;
    memset(&s, 0, sizeof s);
    s.point = memory((size_t)points, sizeof *s.point);
    s.triangle = memory(3 * (size_t)triangles, sizeof *s.triangle);
    if (!normals) return s;
    s.normal = memory((size_t)normals, sizeof *s.normal);
    s.corner = memory(3 * (size_t)triangles, sizeof *s.corner);
    return s;
}

static int pick(rng *r, int count) { return (int)(rng_next(r) % (uint64_t)count); }

static int add_point(shape *s, n3_vec x)
{
    s->point[s->points] = x;
    return s->points++;
}

static int add_normal(shape *s, n3_vec n)
{
    s->normal[s->normals] = n;
    return s->normals++;
}

static void add_corners(shape *s, int a, int b, int c, int na, int nb, int nc)
{
    int at = 3 * s->triangles++;
    s->triangle[at] = a;
    s->triangle[at + 1] = b;
    s->triangle[at + 2] = c;
    if (!s->corner) return;
    s->corner[at] = na;
    s->corner[at + 1] = nb;
    s->corner[at + 2] = nc;
}

/* Normal i belongs to point i. */
static void add_triangle(shape *s, int a, int b, int c) { add_corners(s, a, b, c, a, b, c); }

/* The point of a sphere in the middle of a and b, made once for the pair: made has, for each
   point, its at most six higher neighbours with the points between, and a 0. */
static int sphere_middle(shape *s, int a, int b, int *made)
{
    int lo = a < b ? a : b, hi = a < b ? b : a, *list = made + 13 * lo, i;
    n3_vec x;
    for (i = 0; list[i]; i += 2)
        if (list[i] == hi) return list[i + 1];
    x = n3_unit(n3_add(s->point[a], s->point[b]));
    list[i] = hi;
    list[i + 1] = add_point(s, x);
    return add_normal(s, x);
}

static void split_sphere(shape *s)
{
    int count = s->triangles, i, k, *made = memory(13 * (size_t)s->points, sizeof *made);
    for (i = 0; i < count; i++) {
        int *t = s->triangle + 3 * i, a[3], m[3];
        for (k = 0; k < 3; k++) a[k] = t[k];
        for (k = 0; k < 3; k++) m[k] = sphere_middle(s, a[k], a[(k + 1) % 3], made);
        for (k = 0; k < 3; k++) add_triangle(s, a[k], m[k], m[(k + 2) % 3]);
        for (k = 0; k < 3; k++) t[k] = s->corner[3 * i + k] = m[k];
    }
    free(made);
}

shape shape_icosphere(int level)
{
    static const int face[20][3] = {{0, 8, 1},  {0, 1, 10}, {0, 5, 4},   {0, 4, 8}, {0, 10, 5},
                                    {1, 6, 7},  {1, 8, 6},  {1, 7, 10},  {2, 3, 9}, {2, 11, 3},
                                    {2, 4, 5},  {2, 9, 4},  {2, 5, 11},  {3, 7, 6}, {3, 6, 9},
                                    {3, 11, 7}, {4, 9, 8},  {5, 10, 11}, {6, 8, 9}, {7, 11, 10}};
    int faces = 20 << (2 * level), i;
    double g = (1 + sqrt(5.0)) / 2;
    shape s = shape_room(faces / 2 + 2, faces, faces / 2 + 2);
    for (i = 0; i < 12; i++) {
        double a = i & 1 ? -1 : 1, b = i & 2 ? -g : g;
        n3_vec x = i < 4 ? vec(a, 0, b) : i < 8 ? vec(b, a, 0) : vec(0, b, a);
        add_normal(&s, n3_unit(x));
        add_point(&s, n3_unit(x));
    }
    for (i = 0; i < 20; i++) add_triangle(&s, face[i][0], face[i][1], face[i][2]);
    for (i = 0; i < level; i++) split_sphere(&s);
    return s;
}

/* a, b, c, d round a quadrilateral; equal ones leave one triangle collapsed. */
static void add_quad(shape *s, const int p[4], const int n[4])
{
    add_corners(s, p[0], p[1], p[2], n[0], n[1], n[2]);
    add_corners(s, p[0], p[2], p[3], n[0], n[2], n[3]);
}

shape shape_torus(int nu, int nv)
{
    shape s = shape_room(nu * nv, 2 * nu * nv, nu * nv);
    int i, j;
    for (i = 0; i < nu; i++)
        for (j = 0; j < nv; j++) {
            double u = 2 * PI * i / nu, v = 2 * PI * j / nv, r = 2 + cos(v);
            int p[4];
            p[0] = i * nv + j;
            p[1] = (i + 1) % nu * nv + j;
            p[2] = (i + 1) % nu * nv + (j + 1) % nv;
            p[3] = i * nv + (j + 1) % nv;
            add_point(&s, vec(r * cos(u), r * sin(u), sin(v)));
            add_normal(&s, vec(cos(v) * cos(u), cos(v) * sin(u), sin(v)));
            add_quad(&s, p, p);
        }
    return s;
}

/* Point i on the outline of the bracket, a rectangle of 4 by 3 with fillets of radius 0.6: in each
   quarter the round + 1 points of a fillet and one in the middle of the side that follows. */
static n3_vec outline(int i, int round, n3_vec *normal)
{
    int corner = i / (round + 2), k = i % (round + 2);
    double a = PI / 2 * (corner + (k > round ? 1 : (double)k / round));
    double x = corner == 0 || corner == 3 ? 1.4 : -1.4, y = corner < 2 ? 0.9 : -0.9;
    *normal = vec(cos(a), sin(a), 0);
    if (k > round && corner % 2) y = 0;
    else if (k > round) x = 0;
    return vec(x + 0.6 * cos(a), y + 0.6 * sin(a), 0);
}

/* A wall's or a lid's quadrilateral i: from loop a to loop b of n points each. normals: where those
   of the loops are, or -1 - k for one normal k. */
static void add_strip(shape *s, int a, int b, int na, int nb, int n, int i)
{
    int p[4], q[4], k = (i + 1) % n;
    p[0] = a + i;
    p[1] = a + k;
    p[2] = b + k;
    p[3] = b + i;
    q[0] = na < 0 ? -1 - na : na + i;
    q[1] = na < 0 ? -1 - na : na + k;
    q[2] = nb < 0 ? -1 - nb : nb + k;
    q[3] = nb < 0 ? -1 - nb : nb + i;
    add_quad(s, p, q);
}

shape shape_bracket(int round)
{
    int n = 4 * (round + 2), i, row, up, down;
    shape s = shape_room(6 * n, 12 * n, 2 * n + 2);
    n3_vec normal;
    for (row = 0; row < 3; row++)
        for (i = 0; i < n; i++)
            add_point(&s, n3_add(outline(i, round, &normal), vec(0, 0, row / 2.0)));
    for (row = 0; row < 3; row++)
        for (i = 0; i < n; i++) {
            n3_vec x = n3_mul((n3_real)0.6, n3_unit(outline(i, round, &normal)));
            add_point(&s, n3_add(x, vec(0, 0, row / 2.0)));
        }
    for (i = 0; i < n; i++) {
        outline(i, round, &normal);
        add_normal(&s, normal);
    }
    for (i = 0; i < n; i++) add_normal(&s, n3_unit(n3_mul(-1, outline(i, round, &normal))));
    up = add_normal(&s, vec(0, 0, 1));
    down = add_normal(&s, vec(0, 0, -1));
    for (i = 0; i < n; i++) {
        for (row = 0; row < 2; row++) {
            add_strip(&s, row * n, (row + 1) * n, 0, 0, n, i);
            add_strip(&s, (4 + row) * n, (3 + row) * n, n, n, n, i);
        }
        add_strip(&s, 2 * n, 5 * n, -1 - up, -1 - up, n, i);
        add_strip(&s, 3 * n, 0, -1 - down, -1 - down, n, i);
    }
    return s;
}

shape shape_cone(int n)
{
    shape s = shape_room(n + 2, 2 * n, n + 2);
    int i;
    for (i = 0; i < n; i++) {
        double a = 2 * PI * i / n;
        add_point(&s, vec(cos(a), sin(a), 0));
        add_normal(&s, n3_unit(vec(2 * cos(a), 2 * sin(a), 1)));
        add_corners(&s, i, (i + 1) % n, n, i, (i + 1) % n, n);
        add_corners(&s, (i + 1) % n, i, n + 1, n + 1, n + 1, n + 1);
    }
    add_point(&s, vec(0, 0, 2));
    add_point(&s, vec(0, 0, 0));
    add_normal(&s, vec(0, 0, 0));
    add_normal(&s, vec(0, 0, -1));
    return s;
}

shape shape_moebius(int n)
{
    shape s = shape_room(3 * n, 4 * n, 0);
    int i, j;
    for (i = 0; i < n; i++)
        for (j = 0; j < 3; j++) {
            double a = 2 * PI * i / n, r = 2 + (j - 1) * cos(a / 2) / 2;
            add_point(&s, vec(r * cos(a), r * sin(a), (j - 1) * sin(a / 2) / 2));
        }
    for (i = 0; i < n; i++)
        for (j = 0; j < 2; j++) {
            int p[4];
            p[0] = 3 * i + j;
            p[1] = i < n - 1 ? p[0] + 3 : 2 - j;
            p[2] = i < n - 1 ? p[0] + 4 : 1 - j;
            p[3] = p[0] + 1;
            add_quad(&s, p, p);
        }
    return s;
}

shape shape_hourglass(int n)
{
    shape s = shape_room(2 * n + 3, 4 * n, 0);
    int i;
    add_point(&s, vec(0, 0, 0));
    add_point(&s, vec(0, 0, 1));
    add_point(&s, vec(0, 0, -1));
    for (i = 0; i < n; i++) {
        double a = 2 * PI * i / n;
        int p = 3 + 2 * i, q = 3 + 2 * ((i + 1) % n);
        add_point(&s, vec(cos(a), sin(a), 1));
        add_point(&s, vec(cos(a), sin(a), -1));
        add_triangle(&s, 0, q, p);
        add_triangle(&s, 1, p, q);
        add_triangle(&s, 0, p + 1, q + 1);
        add_triangle(&s, 2, q + 1, p + 1);
    }
    return s;
}

shape shape_sheets(int n)
{
    shape s = shape_room(n + 2, n, 0);
    int i;
    add_point(&s, vec(0, 0, 0));
    add_point(&s, vec(1, 0, 0));
    for (i = 0; i < n; i++) {
        double a = 2 * PI * i / n;
        add_triangle(&s, 0, 1, add_point(&s, vec(0.5, cos(a), sin(a))));
    }
    return s;
}

/* Point i of nu on ring j of nv: the poles are 0 and 1. */
static int polar_point(int i, int j, int nu, int nv)
{
    if (j == 0 || j == nv) return j == 0 ? 0 : 1;
    return 2 + (j - 1) * nu + i % nu;
}

shape shape_polar(int nu, int nv)
{
    int i, j, points = 2 + (nv - 1) * nu;
    shape s = shape_room(points, 2 * nu * nv, points);
    add_point(&s, vec(0, 0, 1));
    add_point(&s, vec(0, 0, -1));
    for (j = 1; j < nv; j++)
        for (i = 0; i < nu; i++) {
            double a = 2 * PI * i / nu, b = PI * j / nv;
            add_point(&s, vec(sin(b) * cos(a), sin(b) * sin(a), cos(b)));
        }
    for (i = 0; i < points; i++) add_normal(&s, n3_unit(s.point[i]));
    for (j = 0; j < nv; j++)
        for (i = 0; i < nu; i++) {
            int p[4];
            p[0] = polar_point(i, j, nu, nv);
            p[1] = polar_point(i, j + 1, nu, nv);
            p[2] = polar_point(i + 1, j + 1, nu, nv);
            p[3] = polar_point(i + 1, j, nu, nv);
            add_quad(&s, p, p);
        }
    return s;
}

shape shape_cube(void)
{
    static const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    shape s = shape_room(8, 12, 0);
    int i;
    for (i = 0; i < 8; i++) add_point(&s, vec(i & 1, i >> 1 & 1, i >> 2));
    for (i = 0; i < 6; i++) add_quad(&s, face[i], face[i]);
    return s;
}

shape shape_pillow(void)
{
    shape s = shape_room(3, 2, 0);
    add_point(&s, vec(0, 0, 0));
    add_point(&s, vec(1, 0, 0));
    add_point(&s, vec(0, 1, 0));
    add_triangle(&s, 0, 1, 2);
    add_triangle(&s, 0, 2, 1);
    return s;
}

shape shape_soup(int points, int triangles, rng *r)
{
    shape s = shape_room(points, triangles, 0);
    int i;
    for (i = 0; i < points; i++) add_point(&s, rng_vec(r));
    for (i = 0; i < triangles; i++) {
        int a = pick(r, points), b = pick(r, points);
        add_triangle(&s, a, b, pick(r, points));
    }
    return s;
}

void shape_drop_normals(shape *s)
{
    free(s->normal);
    free(s->corner);
    s->normal = NULL;
    s->corner = NULL;
    s->normals = 0;
}

void shape_split_normals(shape *s)
{
    int i, corners = 3 * s->triangles;
    n3_vec *normal = memory((size_t)corners, sizeof *normal);
    for (i = 0; i < corners; i++) {
        normal[i] = s->normal[s->corner[i]];
        s->corner[i] = i;
    }
    free(s->normal);
    s->normal = normal;
    s->normals = corners;
}

void shape_tilt_normals(shape *s, double angle, rng *r)
{
    int i;
    for (i = 0; i < s->normals; i++) {
        n3_vec n = s->normal[i], across = n3_unit(n3_cross(n, rng_unit(r)));
        s->normal[i] = n3_add(n3_mul((n3_real)cos(angle), n), n3_mul((n3_real)sin(angle), across));
    }
}

static void swap(int *a, int *b)
{
    int c = *a;
    *a = *b;
    *b = c;
}

void shape_flip(shape *s, rng *r)
{
    int i;
    for (i = 0; i < s->triangles; i++) {
        if (pick(r, 2)) continue;
        swap(&s->triangle[3 * i + 1], &s->triangle[3 * i + 2]);
        if (s->corner) swap(&s->corner[3 * i + 1], &s->corner[3 * i + 2]);
    }
}

/* Triangle i takes the place of k, and begins with another corner. */
static void rotate_and_swap(int *t, int i, int k, int turn)
{
    int j, old[3];
    for (j = 0; j < 3; j++) old[j] = t[3 * i + j];
    for (j = 0; j < 3; j++) t[3 * i + j] = t[3 * k + j];
    for (j = 0; j < 3; j++) t[3 * k + j] = old[(j + turn) % 3];
}

void shape_shuffle(shape *s, rng *r)
{
    int i;
    for (i = s->triangles - 1; i > 0; i--) {
        int k = pick(r, i), turn = pick(r, 3);
        rotate_and_swap(s->triangle, i, k, turn);
        if (s->corner) rotate_and_swap(s->corner, i, k, turn);
    }
}

void shape_renumber(shape *s, rng *r)
{
    int *to = memory((size_t)s->points, sizeof *to), i;
    n3_vec *point = memory((size_t)s->points, sizeof *point);
    for (i = 0; i < s->points; i++) to[i] = i;
    for (i = s->points - 1; i > 0; i--) swap(&to[i], &to[pick(r, i + 1)]);
    for (i = 0; i < s->points; i++) point[to[i]] = s->point[i];
    for (i = 0; i < 3 * s->triangles; i++) s->triangle[i] = to[s->triangle[i]];
    free(s->point);
    free(to);
    s->point = point;
}

void shape_free(shape *s)
{
    free(s->point);
    free(s->normal);
    free(s->triangle);
    free(s->corner);
    memset(s, 0, sizeof *s);
}

static void *copy(const void *from, int count, size_t size)
{
    return from ? memcpy(memory((size_t)count, size), from, (size_t)count * size) : NULL;
}

shape shape_copy(const shape *s)
{
    shape c = *s;
    c.point = copy(s->point, s->points, sizeof *s->point);
    c.normal = copy(s->normal, s->normals, sizeof *s->normal);
    c.triangle = copy(s->triangle, 3 * s->triangles, sizeof *s->triangle);
    c.corner = copy(s->corner, 3 * s->triangles, sizeof *s->corner);
    return c;
}

n3_mesh shape_mesh(const shape *s)
{
    n3_mesh m;
    memset(&m, 0, sizeof m);
    m.points = s->points;
    m.triangles = s->triangles;
    m.normals = s->normals;
    m.point = &s->point[0].x;
    m.triangle = s->triangle;
    m.normal = s->normal ? &s->normal[0].x : NULL;
    m.corner = s->corner;
    return m;
}

/* Faces as a fan of triangles; "a", "a/t", "a//n", "a/t/n". */
static void read_face(char *line, shape *s)
{
    int p[3] = {0, 0, 0}, n[3] = {0, 0, 0}, count = 0;
    char *word, *end;
    for (word = strtok(line, " \t\r\n"); word; word = strtok(NULL, " \t\r\n")) {
        char *slash = strrchr(word, '/');
        int k = count < 3 ? count : 2;
        if (count >= 3) p[1] = p[2];
        if (count >= 3) n[1] = n[2];
        p[k] = (int)strtol(word, &end, 10) - 1;
        n[k] = slash && strchr(word, '/') < slash ? (int)strtol(slash + 1, NULL, 10) - 1 : -1;
        if (++count >= 3) add_corners(s, p[0], p[1], p[2], n[0], n[1], n[2]);
    }
}

/* Counts first, then fills. */
int shape_read(const char *path, shape *s)
{
    static char line[1000];
    FILE *f = fopen(path, "r");
    int points = 0, triangles = 0, normals = 0;
    double x, y, z;
    if (!f) return 0;
    while (fgets(line, sizeof line, f)) {
        points += !strncmp(line, "v ", 2);
        normals += !strncmp(line, "vn ", 3);
        triangles += !strncmp(line, "f ", 2) ? (int)strlen(line) / 2 : 0;
    }
    rewind(f);
    *s = shape_room(points, triangles, normals);
    while (fgets(line, sizeof line, f)) {
        if (sscanf(line, "v %lf %lf %lf", &x, &y, &z) == 3) add_point(s, vec(x, y, z));
        if (sscanf(line, "vn %lf %lf %lf", &x, &y, &z) == 3) add_normal(s, vec(x, y, z));
        if (!strncmp(line, "f ", 2)) read_face(line + 2, s);
    }
    fclose(f);
    return 1;
}
