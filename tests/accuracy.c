/* The figures that `make accuracy` prints, pinned to 2 percent, and the observed orders to 0.3.
 *
 * Distances are known to 16 eps, the error of the foot point, beside the rounding of the patch;
 * normals to some eps over the length of an edge, 1/100 at least. Smaller ones are not compared. */
#include "check.h"

#include "../bench/accuracy.h"

#include <math.h>
#include <stdlib.h>

enum { SPHERE, TORUS_2_1, TORUS_1_04, ELLIPSOID, CYLINDER, ELLIPTIC, SADDLE, WAVE, BORDER };

/* Surface, irregular, method, level; largest distance, largest angle in degrees, their orders from
   the level below; 0: not pinned, because irregular meshes of two levels are not alike. */
static const struct figure_row {
    int surface, irregular, method, level;
    double distance, angle, distance_order, angle_order;
} rows[] = {
    {SPHERE, 0, FLAT, 3, 4.528e-03, 5.45, 2.0, 1.0},
    {SPHERE, 0, PN, 3, 3.071e-05, 0.0285, 3.9, 2.9},
    {SPHERE, 0, NAGATA, 3, 5.780e-06, 0.0185, 4.0, 3.0},
    {SPHERE, 0, PAPER, 3, 5.780e-06, 0.0185, 4.0, 3.0},
    {SPHERE, 0, ARC, 3, 5.857e-09, 1.17e-05, 6.0, 4.9},
    {SPHERE, 0, FIT, 3, 5.857e-09, 1.17e-05, 6.0, 4.9},
    {CYLINDER, 0, FLAT, 3, 4.815e-03, 5.63, 2.0, 1.0},
    {CYLINDER, 0, PN, 3, 3.527e-05, 0.033, 4.0, 3.0},
    {CYLINDER, 0, NAGATA, 3, 1.165e-05, 0.0105, 4.0, 3.0},
    {CYLINDER, 0, PAPER, 3, 1.165e-05, 0.0105, 4.0, 3.0},
    {CYLINDER, 0, ARC, 3, 1.036e-09, 2.25e-06, 6.0, 5.0},
    {CYLINDER, 0, FIT, 3, 1.036e-09, 2.25e-06, 6.0, 5.0},
    {TORUS_2_1, 0, FLAT, 3, 2.808e-03, 3.38, 2.0, 1.0},
    {TORUS_2_1, 0, PN, 3, 1.002e-05, 0.0425, 3.7, 2.1},
    {TORUS_2_1, 0, NAGATA, 3, 1.601e-05, 0.0814, 3.0, 2.1},
    {TORUS_2_1, 0, PAPER, 3, 8.560e-06, 0.043, 3.1, 2.1},
    {TORUS_2_1, 0, PAPER_FREE, 3, 2.082e-05, 0.122, 3.1, 2.1},
    {TORUS_2_1, 0, ARC, 3, 6.820e-06, 0.0405, 3.0, 2.1},
    {TORUS_2_1, 0, FIT, 3, 7.532e-07, 0.00422, 4.0, 3.2},
    {TORUS_1_04, 0, FLAT, 3, 1.603e-03, 4.19, 2.0, 1.0},
    {TORUS_1_04, 0, PN, 3, 8.216e-06, 0.0546, 3.8, 2.1},
    {TORUS_1_04, 0, NAGATA, 3, 1.100e-05, 0.104, 3.1, 2.1},
    {TORUS_1_04, 0, PAPER, 3, 6.022e-06, 0.0549, 3.2, 2.1},
    {TORUS_1_04, 0, PAPER_FREE, 3, 1.217e-05, 0.134, 3.0, 2.1},
    {TORUS_1_04, 0, ARC, 3, 4.604e-06, 0.0496, 3.0, 2.1},
    {TORUS_1_04, 0, FIT, 3, 5.734e-07, 0.00559, 4.0, 3.2},
    {ELLIPSOID, 0, PN, 2, 1.941e-03, 2.5, 3.1, 2.0},
    {ELLIPSOID, 0, NAGATA, 2, 4.501e-04, 1.57, 2.7, 2.0},
    {ELLIPSOID, 0, PAPER, 2, 4.269e-04, 1.55, 3.4, 2.4},
    {ELLIPSOID, 0, ARC, 2, 4.861e-04, 0.853, 2.9, 2.3},
    {ELLIPSOID, 0, FIT, 2, 3.851e-04, 0.529, 2.7, 2.2},
    {ELLIPTIC, 0, PN, 2, 3.718e-04, 0.388, 3.5, 2.4},
    {ELLIPTIC, 0, NAGATA, 2, 2.297e-05, 0.0201, 4.0, 3.0},
    {ELLIPTIC, 0, PAPER, 2, 1.656e-04, 0.238, 1.3, -0.3},
    {ELLIPTIC, 0, ARC, 2, 1.253e-04, 0.231, 3.2, 1.8},
    {ELLIPTIC, 0, FIT, 2, 5.429e-05, 0.049, 3.7, 2.4},
    {SADDLE, 0, PN, 2, 2.909e-05, 0.108, 2.9, 2.0},
    {SADDLE, 0, NAGATA, 2, 2.434e-05, 0.0844, 3.0, 2.0},
    {SADDLE, 0, PAPER, 2, 2.934e-05, 0.108, 3.0, 1.9},
    {SADDLE, 0, ARC, 2, 2.418e-05, 0.0837, 3.0, 1.9},
    {SADDLE, 0, FIT, 2, 1.849e-06, 0.00485, 3.9, 3.0},
    {WAVE, 0, PN, 2, 3.831e-05, 0.109, 3.8, 2.4},
    {WAVE, 0, PAPER, 2, 1.795e-05, 0.106, 3.9, 2.3},
    {WAVE, 0, ARC, 2, 2.298e-05, 0.131, 3.4, 2.0},
    {WAVE, 0, FIT, 2, 1.693e-05, 0.0357, 3.9, 2.9},
    {BORDER, 0, PN, 2, 3.831e-05, 0.109, 3.8, 2.4},
    {BORDER, 0, PAPER, 2, 1.795e-05, 0.106, 3.9, 2.3},
    {BORDER, 0, ARC, 2, 2.298e-05, 0.131, 3.4, 2.0},
    {BORDER, 0, FIT, 2, 1.693e-05, 0.0887, 3.9, 2.2},
    {SPHERE, 1, PAPER, 1, 3.698e-03, 2.21, 0, 0},
    {SPHERE, 1, ARC, 1, 8.043e-05, 0.0358, 0, 0},
    {SPHERE, 1, FIT, 1, 8.043e-05, 0.0358, 0, 0},
    {TORUS_2_1, 1, PAPER, 1, 2.561e-03, 3.34, 0, 0},
    {TORUS_2_1, 1, ARC, 1, 1.119e-03, 1.55, 0, 0},
    {TORUS_2_1, 1, FIT, 1, 5.678e-04, 0.487, 0, 0},
    {TORUS_1_04, 1, PAPER, 1, 1.930e-03, 4.64, 0, 0},
    {TORUS_1_04, 1, ARC, 1, 8.056e-04, 1.76, 0, 0},
    {TORUS_1_04, 1, FIT, 1, 4.350e-04, 0.685, 0, 0},
    {ELLIPSOID, 1, PAPER, 1, 7.467e-03, 11.4, 0, 0},
    {ELLIPSOID, 1, ARC, 1, 7.384e-03, 6.41, 0, 0},
    {ELLIPSOID, 1, FIT, 1, 6.249e-03, 5.22, 0, 0},
    {CYLINDER, 1, PAPER, 1, 8.072e-03, 1.87, 0, 0},
    {CYLINDER, 1, ARC, 1, 1.585e-05, 0.0075, 0, 0},
    {CYLINDER, 1, FIT, 1, 1.585e-05, 0.0075, 0, 0},
    {ELLIPTIC, 1, PAPER, 1, 1.091e-03, 0.446, 0, 0},
    {ELLIPTIC, 1, ARC, 1, 2.032e-03, 1.3, 0, 0},
    {ELLIPTIC, 1, FIT, 1, 1.865e-03, 0.751, 0, 0},
    {SADDLE, 1, PAPER, 1, 3.010e-04, 0.593, 0, 0},
    {SADDLE, 1, ARC, 1, 2.838e-04, 0.402, 0, 0},
    {SADDLE, 1, FIT, 1, 5.775e-05, 0.0892, 0, 0},
    {WAVE, 1, PAPER, 1, 4.908e-04, 1.11, 0, 0},
    {WAVE, 1, ARC, 1, 4.827e-04, 0.785, 0, 0},
    {WAVE, 1, FIT, 1, 5.151e-04, 0.436, 0, 0},
};

static figures figures_of(const struct figure_row *r, int level)
{
    const surface *s = &surfaces[r->surface];
    model m = model_make(s, level, r->irregular);
    n3_patch *p = patches_make(&m, r->method);
    figures f = measure(s, &m, p, s->alike && !r->irregular ? 24 : 12);
    free(p);
    model_free(&m);
    return f;
}

/* A value below the floor is rounding, and so is the order of one below 100 of them. */
static void check_figure(double got, double want, double floor, double coarse, double order,
                         long row)
{
    CHECK_NEAR(got, want, 0.02 * want + floor, row);
    if (order > 0 && want > 100 * floor) CHECK_NEAR(log2(coarse / got), order, 0.3, row);
}

static void accuracy_figures(void)
{
    long count = sample_count((long)(sizeof rows / sizeof *rows)), i;
    for (i = 0; i < count && i < (long)(sizeof rows / sizeof *rows); i++) {
        const struct figure_row *r = &rows[i];
        figures fine = figures_of(r, r->level), coarse = fine;
        if (r->distance_order > 0) coarse = figures_of(r, r->level - 1);
        CHECK(fine.lost + coarse.lost == 0, i);
        check_figure(fine.distance, r->distance, 32 * EPS, coarse.distance, r->distance_order, i);
        check_figure(fine.angle, r->angle, 2e4 * EPS, coarse.angle, r->angle_order, i);
    }
}

/* Patches of the arc rule nearly agree on the normal along the edge that they share: the largest
 * jump, in degrees, on two meshes, and its order. */
static void jumps_across_edges(void)
{
    static const struct {
        int surface, method;
        double coarse, fine, order;
    } jumps[] = {{SPHERE, PN, 15.84, 2.559, 2.6},      {SPHERE, ARC, 0.3285, 0.01728, 4.2},
                 {TORUS_2_1, PN, 8.636, 1.236, 2.8},   {TORUS_2_1, ARC, 2.463, 0.2740, 3.2},
                 {TORUS_2_1, FIT, 2.980, 0.3302, 3.2}, {ELLIPSOID, ARC, 14.18, 4.549, 1.6}};
    long count = sample_count((long)(sizeof jumps / sizeof *jumps)), i;
    for (i = 0; i < count && i < (long)(sizeof jumps / sizeof *jumps); i++) {
        struct figure_row r = {0, 0, 0, 0, 0, 0, 0, 0};
        double coarse, fine;
        r.surface = jumps[i].surface;
        r.method = jumps[i].method;
        coarse = figures_of(&r, 0).jump;
        fine = figures_of(&r, 1).jump;
        CHECK_NEAR(coarse, jumps[i].coarse, 0.02 * jumps[i].coarse + 2e4 * EPS, i);
        CHECK_NEAR(fine, jumps[i].fine, 0.02 * jumps[i].fine + 2e4 * EPS, i);
        if (EPS < 1e-10) CHECK_NEAR(log2(coarse / fine), jumps[i].order, 0.3, i);
    }
}

const test_case tests_accuracy[] = {{"accuracy_figures", accuracy_figures},
                                    {"jumps_across_edges", jumps_across_edges},
                                    {NULL, NULL}};
