/* Writes the demonstration's mesh, a bottle of 224 triangles with exact normals, as OBJ on stdout.
 *
 *     base and lid    flat, each with a crease round it
 *     wall            four flat sides, joined by quarter cylinders
 *     shoulder        shaped like an S, upright at both ends, while the rounded square becomes a
 *                     circle; the inflection lies inside the middle one of its three rows
 *     neck            a cylinder
 */
#include <math.h>
#include <stdio.h>

enum { AROUND = 16, ROWS = 7 }; /* rows of points */

static const double pi = 3.14159265358979323846;
static const double flat = 0.5; /* half a side's flat part; half of the whole side is 1 */
static const double neck = 0.4; /* radius */
static const double height[ROWS] = {0, 0.75, 1.5, 1.8, 2.1, 2.4, 3};
static const double foot = 1.5, top = 2.4; /* of the shoulder */

/* To nine decimals, without a negative zero. */
static void print_vec(const char *word, double x, double y, double z)
{
    const double unit = 1e9;
    printf("%s %.9g %.9g %.9g\n", word, floor(x * unit + 0.5) / unit, floor(y * unit + 0.5) / unit,
           floor(z * unit + 0.5) / unit);
}

/* The columns stand in the middle of each side, where it ends, and in the middle of the corner. */
static double direction(int j)
{
    const double within[4] = {0, atan(flat), pi / 4, pi / 2 - atan(flat)};
    return pi / 2 * (j / 4) + within[j % 4];
}

/* Distance of the wall from the axis in direction a, and its derivative. */
static double wall(double a, double *slope)
{
    const double turned = fmod(a + pi / 4, pi / 2) - pi / 4; /* from the middle of the side */
    const double from_corner = pi / 4 - fabs(turned), radius = 1 - flat, centre = flat * sqrt(2.0);
    const double across = centre * sin(from_corner), along = centre * cos(from_corner);
    const double rest = sqrt(radius * radius - across * across);
    if (fabs(tan(turned)) <= flat) {
        *slope = tan(turned) / cos(turned);
        return 1 / cos(turned);
    }
    *slope = (turned < 0 ? -across : across) * (1 + along / rest);
    return along + rest;
}

/* How much of the section at height z is the neck's circle, the rest being the wall's; slope: its
   derivative, 0 at both ends of the shoulder. */
static double roundness(double z, double *slope)
{
    double t = z < foot ? 0 : z > top ? 1 : (z - foot) / (top - foot);
    *slope = 6 * t * (1 - t) / (top - foot);
    return t * t * (3 - 2 * t);
}

/* The point at radius r(a, z) and the normal there, the cross product of the derivatives. */
static void print_vertex(int i, int j)
{
    double a = direction(j), z = height[i], ra, rz, x, y, length, size = wall(a, &ra);
    double part = roundness(z, &rz), r = (1 - part) * size + part * neck;
    ra *= 1 - part;
    rz *= neck - size;
    x = r * cos(a) + ra * sin(a);
    y = r * sin(a) - ra * cos(a);
    length = sqrt(x * x + y * y + r * r * rz * rz);
    print_vec("v", r * cos(a), r * sin(a), z);
    print_vec("vn", x / length, y / length, -r * rz / length);
}

static void print_triangle(int a, int b, int c)
{
    printf("f %d//%d %d//%d %d//%d\n", a, a, b, b, c, c);
}

/* The ring's vertices and a new one in its middle, in the plane of the row i. */
static void print_cap(int i, int middle, int up)
{
    int j;
    print_vec("v", 0, 0, height[i]);
    print_vec("vn", 0, 0, up ? 1 : -1);
    for (j = 0; j < AROUND; j++) {
        int a = AROUND * i + j + 1, b = AROUND * i + (j + 1) % AROUND + 1;
        printf("f %d//%d %d//%d %d//%d\n", middle, middle, up ? a : b, middle, up ? b : a, middle);
    }
}

int main(void)
{
    int i, j;
    puts("# a bottle, to be smoothed");
    for (i = 0; i < ROWS; i++)
        for (j = 0; j < AROUND; j++) print_vertex(i, j);
    for (i = 0; i + 1 < ROWS; i++) {
        for (j = 0; j < AROUND; j++) {
            int a = AROUND * i + j + 1, b = AROUND * i + (j + 1) % AROUND + 1;
            print_triangle(a, b, b + AROUND);
            print_triangle(a, b + AROUND, a + AROUND);
        }
    }
    print_cap(0, AROUND * ROWS + 1, 0);
    print_cap(ROWS - 1, AROUND * ROWS + 2, 1);
    return fflush(stdout) || ferror(stdout);
}
