#include "inputs.h"

static const double pi = 3.14159265358979323846;

const input inputs[INPUTS] = {{"circles", "equal circles", {7.61, 9.9}, {2.78, 3.61}, 0},
                              {"square", "circle to square", {7.67, 14.97}, {1.92, 3.66}, 0},
                              {"bent", "loops that are not plane", {0.65, 6.59}, {5.67, 8.96}, 0},
                              {"waves", "opposed waves", {4.45, 14.00}, {0.04, 6.82}, 0},
                              {"abrupt", "abrupt change", {3.15, 9.96}, {2.99, 3.69}, 30.4}};

enum { CIRCLES, SQUARE, BENT, WAVES, ABRUPT };

/* How many times wider a tube is per unit of depth. */
static double slope(int number, int upper)
{
    if (number == BENT) return upper ? 0.25 : 0.35;
    return upper ? 0.45 : 0.3;
}

/* The height of a ring's point over the ring's middle: both loops alike, or opposed. */
static double height(int number, int upper, double a)
{
    if (number == BENT) return 0.3 * cos(2 * a);
    if (number == WAVES) return (upper ? -0.25 : 0.25) * cos(2 * a);
    return 0;
}

/* The distance of a loop's point i from the axis, in the direction a. The upper waves go in where
   the lower ones go out. What is abrupt is a dent, one point wide, in the loop alone. */
static double radius(int number, int upper, int i, int around, double a)
{
    if (number == SQUARE && upper) return 1 / fmax(fabs(cos(a)), fabs(sin(a)));
    if (number == WAVES) return 1 + (upper ? -0.05 : 0.05) * cos(2 * a);
    return number == ABRUPT && !upper && i == around / 3 ? 0.8 : 1;
}

/* Every second ring is turned by half a point, but those of a square keep to its corners. */
static int is_turned(int number, int depth) { return number != SQUARE && depth % 2; }

static n3_vec place(int number, int upper, int depth, int i, int around)
{
    const double a = 2 * pi * (i + (is_turned(number, depth) ? 0.5 : 0)) / around, u = 0.4 * depth;
    const double r =
        radius(number, upper, depth ? -1 : i, around, a) * (1 + slope(number, upper) * u);
    const double z = height(number, upper, a) + (upper ? 2 + u : -u);
    return n3_v((n3_real)(r * cos(a)), (n3_real)(r * sin(a)), (n3_real)z);
}

/* The triangles between two rings whose first points are a and b. */
static int *cover(int a, int b, int turned, int around, int *triangle)
{
    int i;
    for (i = 0; i < around; i++) {
        const int next = (i + 1) % around;
        const int corner[6] = {
            a + i, a + next, turned ? b + next : b + i, turned ? a + i : a + next, b + next, b + i};
        memcpy(triangle, corner, sizeof corner);
        triangle += 6;
    }
    return triangle;
}

void input_make(int number, int upper, int around, tube *t)
{
    int ring, i, *triangle = t->triangle;
    memset(t, 0, sizeof *t);
    for (ring = 0; ring < RINGS; ring++) {
        const int depth = upper ? ring : RINGS - 1 - ring, first = ring * around;
        for (i = 0; i < around; i++) t->point[first + i] = place(number, upper, depth, i, around);
        if (ring + 1 < RINGS) triangle = cover(first, first + around, depth % 2, around, triangle);
    }
    t->mesh.points = RINGS * around;
    t->mesh.triangles = (int)(triangle - t->triangle) / 3;
    t->mesh.point = &t->point[0].x;
    t->mesh.triangle = t->triangle;
}

int input_start(const tube *t, int upper)
{
    return upper ? 0 : t->mesh.points / RINGS * (RINGS - 1);
}
