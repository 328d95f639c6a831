/* accuracy.h: surfaces that are known exactly, meshes of them, and how far patches over these
 * meshes are from the surface. */
#ifndef ACCURACY_H
#define ACCURACY_H

#include "nagata3.h"

#include <stddef.h>

enum { SURFACES = 9, LEVELS = 4, MOST = 2048 };

/* The surface f = 0; f grows outwards. */
typedef struct surface {
    const char *name;
    /* f, its gradient and its second derivatives, which are symmetric. */
    n3_real (*f)(const struct surface *s, n3_vec x, n3_vec *gradient, n3_vec hessian[3]);
    n3_real size[3]; /* radii, what they are is up to f; 0: infinite */
    n3_real reach;   /* a foot point nearer than this is the nearest */
    /* The point at the parameters u, v; nu: cells round. NULL: a scaled icosphere. */
    n3_vec (*at)(const struct surface *s, n3_real u, n3_real v, int nu);
    int nu, nv;           /* cells of the coarsest mesh over [0, 1]^2 */
    int round_u, round_v; /* closed in that direction */
    int margin;           /* cells beyond an open end, meshed but not measured */
    int alike;            /* a regular mesh consists of equal parts, columns of cells mostly */
} surface;

extern const surface surfaces[SURFACES];

/* malloc for count things, or the end of the program. */
void *take(size_t count, size_t size);

/* A mesh that owns its arrays. */
typedef struct model {
    n3_mesh mesh;
    n3_topology topology;
    n3_vec *point, *normal;
    int *triangle;
    void *work;   /* of the topology */
    int measured; /* the first triangles; others are like these, or in the margin */
} model;

/* The mesh of a level below LEVELS, its normals exact. Irregular: points moved by up to a fifth of
   an edge, diagonals tossed, the same on every machine. */
model model_make(const surface *s, int level, int irregular);
/* Replaces the normals by those that n3_mesh_normals finds. */
void model_estimate_normals(model *m);
void model_free(model *m);

/* The point of the surface nearest to x and the unit normal there; false if there is none. */
int surface_foot(const surface *s, const model *m, n3_vec x, n3_vec *foot, n3_vec *normal);

enum { FLAT, PN, NAGATA, PAPER, PAPER_FREE, ARC, FIT, METHODS };
extern const char *const method_name[METHODS];

/* The patches of the model, to be freed: by a method, or by a rule of the header. */
n3_patch *patches_make(const model *m, int method);
n3_patch *patches_by_rule(const model *m, const n3_options *o);

/* Distances are to the true surface, angles in degrees, between the patch's normal and the true
   one; jump: between the normals of two patches on their edge. */
typedef struct figures {
    double distance, mean_distance, angle, mean_angle, jump;
    long lost; /* points without a foot */
} figures;

/* At the lattice of n parts of each patch. */
figures measure(const surface *s, const model *m, const n3_patch *patch, int n);

/* Degrees between unit vectors. */
double angle_between(n3_vec a, n3_vec b);

/* Of very many triangles only every third, fifth, ... is measured. */
int is_measured(const model *m, int triangle);

/* Adds a point of the patches and its normal. */
void measure_at(const surface *s, const model *m, n3_vec x, n3_vec mine, figures *r);

/* Prints the figures of Brown's squares and of triangles over the finest meshes; returns the number
   of points without a foot. */
long quads(void);

/* Prints the figures of the paper's rule over tan_lo and tan_hi, which the paper leaves open. */
void sweep(void);

#endif
